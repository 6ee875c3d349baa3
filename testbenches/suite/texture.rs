//! The sampler and the combiner: every word at small widths, against integer arithmetic.

use fixpath::measure::{BoundCheck, Inputs, hard_verdicts, measure};
use fixpath::sim::batch::Program;
use fixpath::units::{Design, Sampler, Unit};
use std::collections::BTreeMap;

fn design(unit: &str, set: &[String]) -> Design {
    Unit::find(unit).unwrap().values(set).unwrap().build().unwrap()
}

fn set(pairs: &[(&str, &dyn std::fmt::Display)]) -> Vec<String> {
    pairs.iter().map(|(key, value)| format!("{key}={value}")).collect()
}

/// Output words of each port for some input words.
fn run(design: &Design, inputs: &[Vec<i64>]) -> BTreeMap<String, Vec<i64>> {
    let outputs = design.netlist.outputs();
    let nodes: Vec<_> = outputs.iter().map(|output| output.node).collect();
    let program = Program::compile(&design.netlist, &nodes);
    let mut words = vec![Vec::new(); nodes.len()];
    let inputs: Vec<&[i64]> = inputs.iter().map(Vec::as_slice).collect();
    program.runner().run(&program, &inputs, &mut words).unwrap();
    outputs.iter().map(|output| output.name.clone()).zip(words).collect()
}

/// Every word of both coordinates, including negative ones and the last.
#[test]
fn the_sampler_is_right_for_every_word() {
    for (int_bits, frac_bits, log2, fraction_bits) in
        [(1, 5, 2, 2), (2, 3, 1, 4), (0, 6, 3, 2), (2, 2, 4, 1), (1, 1, 5, 3)]
    {
        for (filter, address) in
            [("nearest", "wrap"), ("nearest", "clamp"), ("bilinear", "wrap"), ("bilinear", "clamp")]
        {
            // The other axis in reverse order, with a larger map.
            let other = if address == "wrap" { "clamp" } else { "wrap" };
            let design = design(
                "sampler",
                &set(&[
                    ("filter", &filter),
                    ("address_s", &address),
                    ("address_t", &other),
                    ("int_bits", &int_bits),
                    ("frac_bits", &frac_bits),
                    ("log2_width", &log2),
                    ("log2_height", &(log2 + 1)),
                    ("fraction_bits", &fraction_bits),
                ]),
            );
            let reach = 1i64 << (int_bits + frac_bits);
            let words: Vec<i64> = (-reach..reach).collect();
            let reversed: Vec<i64> = words.iter().rev().copied().collect();
            let out = run(&design, &[words.clone(), reversed.clone()]);
            for (words, address, log2, [near, first, second, part]) in [
                (&words, address, log2, ["i", "i0", "i1", "a"]),
                (&reversed, other, log2 + 1, ["j", "j0", "j1", "b"]),
            ] {
                let side = 1i64 << log2;
                let texel = |index: i64| match address {
                    "wrap" => index.rem_euclid(side),
                    _ => index.clamp(0, side - 1),
                };
                for (at, word) in words.iter().enumerate() {
                    // s · side = word · 2^(log2 - frac_bits), in half texels times 2^frac_bits.
                    let halves = 2 * word * side;
                    let half_texels = 1i64 << (frac_bits + 1);
                    let context = format!("{filter} {address} {word} of {frac_bits} bits");
                    if filter == "nearest" {
                        let should = texel(halves.div_euclid(half_texels));
                        assert_eq!(out[near][at], should, "{context}");
                        continue;
                    }
                    let position = halves - half_texels / 2;
                    let whole = position.div_euclid(half_texels);
                    let cut = (position.rem_euclid(half_texels) << fraction_bits) / half_texels;
                    let is = [out[first][at], out[second][at], out[part][at]];
                    assert_eq!(is, [texel(whole), texel(whole + 1), cut], "{context}");
                }
            }
        }
    }
}

/// On a centre a sample is its texel; halfway between two, half of each; at the map's end, as the
/// address mode says.
#[test]
fn texel_centres_are_at_halves() {
    for (address, outside) in [("wrap", 7), ("clamp", 0)] {
        let design = design(
            "sampler",
            &set(&[("log2_width", &3), ("address_s", &address), ("frac_bits", &6)]),
        );
        // Words of 1/64: a texel is 8 of them.
        let out = run(&design, &[vec![4, 8, 0, 60, 63], vec![0; 5]]);
        let end = if address == "wrap" { 0 } else { 7 };
        assert_eq!(out["i0"], [0, 0, outside, 7, 7]);
        assert_eq!(out["i1"], [1, 1, 0, end, end]);
        assert_eq!(out["a"], [0, 128, 128, 0, 96]);
    }
}

/// Every word of texels, fractions and channels, against integer arithmetic.
#[test]
fn the_combiner_is_right_for_every_word() {
    let (toward, away) = ("undisplaced-displaced", "displaced-undisplaced");
    for (filter, channel_bits, fraction_bits, lights, gain_log2, difference) in [
        ("nearest", 3, 1, 1, 0, toward),
        ("nearest", 2, 1, 3, -1, toward),
        ("nearest", 2, 1, 2, 1, toward),
        ("nearest", 2, 1, 2, 0, away),
        ("bilinear", 1, 1, 1, 0, toward),
        ("bilinear", 1, 1, 1, 2, toward),
        ("bilinear", 1, 1, 1, -2, toward),
        ("bilinear", 1, 2, 1, 0, away),
    ] {
        let design = design(
            "combine",
            &set(&[
                ("filter", &filter),
                ("channel_bits", &channel_bits),
                ("fraction_bits", &fraction_bits),
                ("lights", &lights),
                ("gain_log2", &gain_log2),
                ("difference", &difference),
                ("guard_bits", &8), // exact here: 2 · fraction_bits are enough
                ("rounding", &"half-up"),
            ]),
        );
        let netlist = &design.netlist;
        let formats: Vec<_> = netlist.inputs().iter().map(|id| netlist.node(*id).format).collect();
        let bits: u32 = formats.iter().map(|format| format.bits()).sum();
        let mut columns = vec![Vec::new(); formats.len()];
        for index in 0..1u64 << bits {
            let mut rest = index;
            for (column, format) in columns.iter_mut().zip(&formats) {
                column.push((rest & (format.words() - 1)) as i64);
                rest >>= format.bits();
            }
        }
        let out = run(&design, &columns);
        let at = |name: &str, row: usize| {
            let port = (0..formats.len()).find(|at| netlist.input_name(*at) == name);
            columns[port.unwrap_or_else(|| panic!("no port {name}"))][row]
        };
        // Heights in units of 2^-2f codes: weights are products of integers.
        let one = 1i64 << fraction_bits;
        let height = |name: &str, row: usize| {
            if filter == "nearest" {
                return at(name, row) * one * one;
            }
            let of = |part: &str| at(&format!("{name}_{part}"), row);
            let (a, b) = (of("a"), of("b"));
            of("00") * (one - a) * (one - b)
                + of("10") * a * (one - b)
                + of("01") * (one - a) * b
                + of("11") * a * b
        };
        let most = (1i64 << channel_bits) - 1;
        let (mut low, mut high) = (0, 0);
        let rows = 0..1usize << bits;
        for row in rows.clone() {
            let relief: i64 =
                (0..lights).map(|n| height("h", row) - height(&format!("d{n}"), row)).sum();
            let relief = if difference == away { -relief } else { relief };
            for channel in ["r", "g", "b"] {
                // In units of codes / (4 · 2^2f), so that a gain of a quarter is an integer.
                let unit = 4 * one * one;
                let sum = at(channel, row) * unit
                    + if gain_log2 < 0 {
                        (4 * relief) >> -gain_log2
                    } else {
                        (4 * relief) << gain_log2
                    };
                let rounded = (sum + unit / 2).div_euclid(unit);
                low += u32::from(rounded < 0);
                high += u32::from(rounded > most);
                let is = &out[&format!("out_{channel}")];
                assert_eq!(is[row], rounded.clamp(0, most), "{filter} {gain_log2} row {row}");
            }
        }
        // Both sides of the clamp, unless the gain makes differences too small.
        assert!(gain_log2 < 0 || low > 0 && high > 0, "{filter} {gain_log2}: {low} {high}");
    }
}

/// The samples of the lights are distinguished, and so are column and row.
#[test]
fn ports_mean_what_they_say() {
    let design = design("combine", &set(&[("lights", &8)]));
    let netlist = &design.netlist;
    let names: Vec<&str> = (0..netlist.inputs().len()).map(|at| netlist.input_name(at)).collect();
    assert_eq!(names.len(), 6 * 9 + 3);
    let word = |set: &[(&str, i64)]| -> Vec<Vec<i64>> {
        let of = |name: &&str| set.iter().find(|(known, _)| known == name).map_or(0, |(_, w)| *w);
        names.iter().map(|name| vec![of(name)]).collect()
    };
    for light in 0..8 {
        let texel = format!("d{light}_10");
        let fraction = format!("d{light}_a");
        let out = run(&design, &word(&[(&texel, 100), (&fraction, 64), ("r", 200), ("g", 20)]));
        assert_eq!([out["out_r"][0], out["out_g"][0], out["out_b"][0]], [175, 0, 0]);
        let other = format!("d{light}_b");
        let out = run(&design, &word(&[(&texel, 100), (&other, 64), ("r", 200)]));
        assert_eq!(out["out_r"][0], 200, "10 is the next column of the first row");
    }
    // Each light's sample is subtracted from the one undisplaced sample.
    let out = run(&design, &word(&[("h_01", 12), ("h_b", 128), ("b", 20)]));
    assert_eq!(out["out_b"][0], 20 + 8 * 6);
}

/// Stated bounds hold over random words and the whole hard-case list, at the ends of every
/// parameter.
#[test]
fn bounds_hold() {
    let mut settings: Vec<(&str, Vec<String>)> = Vec::new();
    for filter in ["nearest", "bilinear"] {
        for (int_bits, frac_bits, log2, fraction_bits) in
            [(4, 20, 9, 8), (0, 1, 1, 1), (16, 30, 13, 16), (1, 12, 3, 2), (2, 8, 13, 4)]
        {
            for address in ["wrap", "clamp"] {
                settings.push((
                    "sampler",
                    set(&[
                        ("filter", &filter),
                        ("address_s", &address),
                        ("int_bits", &int_bits),
                        ("frac_bits", &frac_bits),
                        ("log2_width", &log2),
                        ("fraction_bits", &fraction_bits),
                    ]),
                ));
            }
        }
        for rounding in ["floor", "toward-zero", "half-up", "half-away", "half-even"] {
            for (channel_bits, fraction_bits, guard_bits, lights, gain_log2) in [
                (8, 8, 4, 1, 0),
                (1, 1, 0, 1, 0),
                (8, 8, 0, 8, 0),
                (16, 16, 16, 8, 8),
                (8, 3, 5, 2, -8),
                (8, 2, 4, 4, 4),
            ] {
                settings.push((
                    "combine",
                    set(&[
                        ("filter", &filter),
                        ("rounding", &rounding),
                        ("channel_bits", &channel_bits),
                        ("fraction_bits", &fraction_bits),
                        ("guard_bits", &guard_bits),
                        ("lights", &lights),
                        ("gain_log2", &gain_log2),
                    ]),
                ));
            }
        }
    }
    for (unit, set) in settings {
        let design = design(unit, &set);
        let bounds = BoundCheck::new(&design).unwrap();
        assert!(!bounds.stated.is_empty());
        let inputs = Inputs { sampler: Sampler::Lit, samples: 20_000, seed: 3 };
        let report = measure(&[&design], &inputs, &|_| ()).unwrap().remove(0);
        for bound in &bounds.stated {
            assert!(bound.holds(&report), "{unit} {set:?}: {bound:?} {:e}", bound.seen(&report));
        }
        for verdict in hard_verdicts(&design, &bounds) {
            assert_eq!(verdict.holds, Some(true), "{unit} {set:?}: {verdict:#?}");
        }
        assert!(report.overflows.is_empty(), "{set:?}: {:?}", report.overflows);
    }
}

/// The bound at the defaults is tight: the worst inputs come near it.
#[test]
fn the_combiner_comes_near_its_bound() {
    let design = design("combine", &[]);
    let bound = BoundCheck::new(&design).unwrap().stated[0].bound;
    assert_eq!(bound, 0.5 + 2.0 / 16.0);
    let inputs = Inputs { sampler: Sampler::Lit, samples: 200_000, seed: 3 };
    let report = measure(&[&design], &inputs, &|_| ()).unwrap().remove(0);
    let seen = report.figures("out_r", fixpath::measure::Basis::Total).max;
    assert!(seen > 0.8 * bound && seen <= bound, "{seen} of {bound}");
}
