//! The tangent-space set-up against the meaning of the patent's text, computed here in integers.

use crate::common::{Vector, cross, dot};
use fixpath::measure::{Basis, BoundCheck, Inputs, hard_verdicts, measure, sample_words};
use fixpath::specialise::{Known, Rate, specialise};
use fixpath::units::{Design, Sampler, Unit};

fn design(assignments: &[&str]) -> Design {
    let values = Unit::find("tangent").unwrap().values(assignments).unwrap();
    values.build().unwrap_or_else(|why| panic!("{assignments:?}: {why}"))
}

/// A vector of integers divided by its length.
fn unit(v: [i128; 3]) -> Vector {
    let v = v.map(|x| x as f64);
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}

/// Input words by the names of ports.
struct Ports<'a> {
    design: &'a Design,
    words: &'a [i64],
}

impl Ports<'_> {
    fn word(&self, name: &str) -> i128 {
        let netlist = &self.design.netlist;
        let port = (0..self.words.len()).find(|port| netlist.input_name(*port) == name);
        self.words[port.unwrap_or_else(|| panic!("no port {name}"))].into()
    }

    fn vector(&self, name: &str) -> [i128; 3] {
        ["x", "y", "z"].map(|axis| self.word(&format!("{name}_{axis}")))
    }

    fn value(&self, name: &str) -> Vector {
        let netlist = &self.design.netlist;
        let first = format!("{name}_x");
        let port = (0..self.words.len()).find(|port| netlist.input_name(*port) == first);
        let ulp = netlist.node(netlist.inputs()[port.unwrap()]).format.ulp();
        self.vector(name).map(|word| word as f64 * ulp)
    }
}

/// A triangle in integers: dP/du and dP/dv times det, det, the area, and the edges from its first
/// corner.
struct Exact {
    by_u: [i128; 3],
    by_v: [i128; 3],
    det: i128,
    area: [i128; 3],
    edges: [[i128; 3]; 2],
}

fn cross_exact(u: [i128; 3], v: [i128; 3]) -> [i128; 3] {
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

impl Exact {
    fn new(ports: &Ports<'_>) -> Self {
        let p = ["p0", "p1", "p2"].map(|name| ports.vector(name));
        let uv = [0, 1, 2].map(|k| ["u", "v"].map(|axis| ports.word(&format!("uv{k}_{axis}"))));
        let [e1, e2] = [1, 2].map(|k| [0, 1, 2].map(|i| p[k][i] - p[0][i]));
        let [d1, d2] = [1, 2].map(|k| [0, 1].map(|i| uv[k][i] - uv[0][i]));
        let by_u = [0, 1, 2].map(|i| d2[1] * e1[i] - d1[1] * e2[i]);
        let by_v = [0, 1, 2].map(|i| d1[0] * e2[i] - d2[0] * e1[i]);
        let det = d1[0] * d2[1] - d2[0] * d1[1];
        // The definition of dP/du and dP/dv: the edges are their linear combinations.
        for i in 0..3 {
            assert_eq!(d1[0] * by_u[i] + d1[1] * by_v[i], det * e1[i]);
            assert_eq!(d2[0] * by_u[i] + d2[1] * by_v[i], det * e2[i]);
        }
        let area = cross_exact(e1, e2);
        // Therefore the hardware may use the area as their cross product.
        assert_eq!(cross_exact(by_u, by_v), area.map(|x| det * x));
        Self { by_u, by_v, det, area, edges: [e1, e2] }
    }

    /// The documented frame for degenerate cases: not mirrored, whatever the rule.
    fn fallback(&self, ports: &Ports<'_>, faceted: bool, printed_basis: bool) -> [Vector; 3] {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        if faceted {
            if self.area == [0; 3] {
                return axes;
            }
            let (t, n) = (unit(self.edges[0]), unit(self.area));
            return [t, if printed_basis { unit(self.edges[1]) } else { cross(n, t) }, n];
        }
        let n = ports.value("normal");
        let axis = axes[usize::from(n[0].abs() > n[1].abs())];
        let b = cross(n, axis);
        let length = dot(b, b).sqrt();
        if printed_basis || length == 0.0 {
            // With N = 0, B is 0, and so is a T at right angles to both.
            return [if printed_basis { axis } else { [0.0; 3] }, b, n];
        }
        let b = b.map(|x| x / length);
        [cross(b, n), b, n]
    }

    fn flags(&self) -> [bool; 3] {
        [self.det < 0, self.det == 0, self.area == [0; 3]]
    }
}

/// Values of the output words in order.
fn run(design: &Design, words: &[i64]) -> Vec<f64> {
    let netlist = &design.netlist;
    let all = netlist.eval(words).unwrap().0;
    let value = |id: fixpath::netlist::NodeId| netlist.node(id).format.value(all[id.index()]);
    netlist.outputs().iter().map(|output| value(output.node)).collect()
}

fn rows(outputs: &[f64]) -> [Vector; 3] {
    [0, 3, 6].map(|at| [outputs[at], outputs[at + 1], outputs[at + 2]])
}

fn golden(design: &Design, words: &[i64]) -> Vec<f64> {
    let netlist = &design.netlist;
    let column =
        |(id, word): (&fixpath::netlist::NodeId, &i64)| [netlist.node(*id).format.value(*word)];
    let columns: Vec<[f64; 1]> = netlist.inputs().iter().zip(words).map(column).collect();
    let slices: Vec<&[f64]> = columns.iter().map(|column| &column[..]).collect();
    let mut golden = vec![vec![0.0]; design.golden_columns()];
    design.golden.run(&slices, &mut golden);
    golden.iter().map(|column| column[0]).collect()
}

fn samples(design: &Design, sampler: Sampler, random: u64) -> Vec<Vec<i64>> {
    let mut words = sample_words(design, &Inputs { sampler, samples: random, seed: 3 }).unwrap();
    words.extend(design.hard.iter().flat_map(|case| case.words.clone()));
    words
}

const VARIANTS: &[&[&str]] = &[
    &[],
    &["basis=printed"],
    &["mirror=printed"],
    &["mirror=printed", "basis=printed"],
    &["mirror=off"],
    &["mirror=off", "basis=printed"],
    &["frame=faceted"],
    &["frame=faceted", "basis=printed"],
    &["frame=faceted", "mirror=printed"],
    &["frame=faceted", "mirror=printed", "basis=printed"],
    &["frame=faceted", "mirror=off"],
    &["frame=faceted", "mirror=off", "basis=printed"],
];

/// The patent's rules in integers, the documented frames where they give none, and the flags.
#[test]
fn goldens_are_those_of_the_seed() {
    for set in VARIANTS {
        let design = design(set);
        let has = |text: &str| set.contains(&text);
        let (faceted, printed_basis) = (has("frame=faceted"), has("basis=printed"));
        let (mut frames, mut fallbacks) = ([0; 2], 0);
        for words in samples(&design, Sampler::Sphere, 5000) {
            let ports = Ports { design: &design, words: &words };
            let exact = Exact::new(&ports);
            let golden = golden(&design, &words);
            let [mirrored, zero_uv, zero_area] = exact.flags();
            let mut flags = vec![mirrored, zero_uv || zero_area, zero_uv, zero_area];
            if !faceted {
                let parallel = cross_exact(ports.vector("normal"), exact.by_u) == [0; 3];
                flags.push(parallel);
                flags[1] |= parallel;
            }
            let flags_at = golden.len() - flags.len();
            let should: Vec<f64> = flags.iter().map(|flag| f64::from(u8::from(*flag))).collect();
            assert_eq!(golden[flags_at..], should, "{set:?} {words:?}");
            frames[usize::from(mirrored && !flags[1])] += 1;
            fallbacks += usize::from(flags[1]);
            // dP/du, dP/dv: exact, divided by the sign of det.
            let sign = if mirrored { -1 } else { 1 };
            let (du, dv) = (exact.by_u.map(|x| sign * x), exact.by_v.map(|x| sign * x));
            let t = if mirrored && has("mirror=printed") { du.map(|x| -x) } else { du };
            let turn =
                if mirrored && !has("mirror=printed") && !has("mirror=off") { -1 } else { 1 };
            let [t, b, n] = if flags[1] {
                exact.fallback(&ports, faceted, printed_basis)
            } else if faceted {
                // T x dP/dv has the signs of T and of det; (e1 x e2)/det is the product of dP/du
                // and dP/dv.
                let product = if t == du { sign } else { -sign };
                let n = unit(exact.area.map(|x| turn * product * x));
                let b = if printed_basis {
                    unit(dv)
                } else {
                    // At right angles to T, on the side of dP/dv.
                    let b = cross(n, unit(t));
                    if dot(b, unit(dv)) < 0.0 { b.map(|x| -x) } else { b }
                };
                [unit(t), b, n]
            } else {
                let n = ports.value("normal");
                let turn = turn as f64;
                let n_cross_t = unit(cross_exact(ports.vector("normal"), t));
                if printed_basis {
                    [unit(t), cross(n, unit(t)).map(|x| turn * x), n]
                } else {
                    [cross(n_cross_t, n), n_cross_t.map(|x| turn * x), n]
                }
            };
            // For a sliver, B of a facet may be on the side of dP/dv by less than an f64 resolves.
            for (row, (is, should)) in rows(&golden).into_iter().zip([t, b, n]).enumerate() {
                for (is, should) in is.into_iter().zip(should) {
                    assert!(
                        (is - should).abs() < 1e-9,
                        "{set:?} {words:?} row {row}: {is} for {should}"
                    );
                }
            }
            for (k, vector) in ["view", "light0"].into_iter().enumerate() {
                for (i, row) in [t, b, n].into_iter().enumerate() {
                    let is = golden[9 + 3 * k + i];
                    assert!((is - dot(row, ports.value(vector))).abs() < 1e-8, "{set:?} {words:?}");
                }
            }
        }
        assert!(frames.iter().all(|count| *count > 1000), "{set:?}: {frames:?}");
        assert!(fallbacks > 20, "{set:?}: {fallbacks}");
    }
}

/// Which of T, B, N are on the side of dP/du, dP/dv, and e1 x e2, without and with a mirrored
/// texture.
#[test]
fn what_each_rule_of_mirroring_gets_wrong() {
    for (set, right) in VARIANTS.iter().zip([
        [true; 3],
        [true; 3],
        [false, true, true],
        [false, true, true],
        [true, false, true],
        [true, false, true],
        [true; 3],
        [true; 3],
        [false, true, true],
        [false, true, true],
        [true, true, false],
        [true, true, false],
    ]) {
        let design = design(set);
        let mut counts = [[[0; 2]; 3]; 2];
        for words in samples(&design, Sampler::Lit, 4000) {
            let outputs = run(&design, &words);
            let ports = Ports { design: &design, words: &words };
            let exact = Exact::new(&ports);
            let flags = &outputs[15..];
            let sign = if exact.det < 0 { -1 } else { 1 };
            let axes = [exact.by_u.map(|x| sign * x), exact.by_v.map(|x| sign * x), exact.area];
            let front =
                |n: [i128; 3]| n.iter().zip(exact.area).map(|(n, a)| n * a).sum::<i128>() > 0;
            let faceted = set.contains(&"frame=faceted");
            if flags[1] != 0.0 || (!faceted && !front(ports.vector("normal"))) {
                continue;
            }
            assert_eq!(flags[0] == 1.0, exact.det < 0);
            for (row, axis) in axes.into_iter().enumerate() {
                let cosine = dot(rows(&outputs)[row], unit(axis));
                if cosine.abs() > 0.01 {
                    counts[usize::from(exact.det < 0)][row][usize::from(cosine > 0.0)] += 1;
                }
            }
        }
        for row in 0..3 {
            let [plain, mirrored] = [counts[0][row], counts[1][row]];
            assert!(plain[0] == 0 && plain[1] > 1000, "{set:?} row {row}: {counts:?}");
            let (wrong, is) = if right[row] { (0, 1) } else { (1, 0) };
            assert!(mirrored[wrong] == 0 && mirrored[is] > 1000, "{set:?} row {row}: {counts:?}");
        }
    }
}

/// Values of ports by name; ports not listed are 0.
fn words_of(design: &Design, values: &[(&str, f64)]) -> Vec<i64> {
    let netlist = &design.netlist;
    let word = |(port, id): (usize, &fixpath::netlist::NodeId)| {
        let known = values.iter().find(|(name, _)| *name == netlist.input_name(port));
        (known.map_or(0.0, |(_, value)| *value) / netlist.node(*id).format.ulp()).round() as i64
    };
    netlist.inputs().iter().enumerate().map(word).collect()
}

/// A bumpy floor, lit in texture space like modelled bumps, with and without a mirrored texture.
#[test]
fn bumps_are_the_right_way_out_on_mirrored_textures() {
    let (a, b) = (0.3, -0.2); // height a u + b v
    let light: Vector = [0.48, 0.36, 0.8];
    for frame in ["frame=smooth", "frame=faceted"] {
        for (mirror, rights) in [
            ("mirror=handed", [true; 4]),
            ("mirror=printed", [true, false, false, true]),
            ("mirror=off", [true, false, false, true]),
        ] {
            let design = design(&[frame, mirror]);
            for ((su, sv), right) in
                [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)].into_iter().zip(rights)
            {
                let words = words_of(
                    &design,
                    &[
                        ("p1_x", 4.0),
                        ("p2_y", 4.0),
                        ("uv1_u", su),
                        ("uv2_v", sv),
                        ("normal_z", 1.0),
                        ("light0_x", light[0]),
                        ("light0_y", light[1]),
                        ("light0_z", light[2]),
                    ],
                );
                let outputs = run(&design, &words);
                let ts_light = [outputs[12], outputs[13], outputs[14]];
                let lit = dot(ts_light, [-a, -b, 1.0]);
                // z = h(u, v) with u = su x, v = sv y, up to the scale of both.
                let should = dot(light, [-a * su, -b * sv, 1.0]);
                let off = (lit - should).abs();
                assert!(
                    (off < 1e-3) == right && (right || off > 0.1),
                    "{frame} {mirror} {su} {sv}: {lit} for {should}"
                );
            }
        }
    }
}

/// With u negated, T is negated and nothing else, to the last bit.
#[test]
fn mirrored_pairs_are_mirrored_bit_for_bit() {
    for (set, turned) in [
        (&[][..], [true, false, false]),
        (&["basis=printed"], [true, false, false]),
        (&["mirror=printed"], [false; 3]),
        (&["mirror=off"], [true, true, false]),
        (&["frame=faceted"], [true, false, false]),
        (&["frame=faceted", "basis=printed"], [true, false, false]),
        (&["frame=faceted", "mirror=off"], [true, false, true]),
    ] {
        let design = design(set);
        let netlist = &design.netlist;
        let is_u = |port: usize| netlist.input_name(port).ends_with("_u");
        let mut pairs = 0;
        for words in samples(&design, Sampler::Lit, 2000) {
            let mut pair = words.clone();
            for port in (0..words.len()).filter(|port| is_u(*port)) {
                pair[port] = -words[port];
            }
            if pair.contains(&(1 << 15)) {
                continue; // no such word
            }
            let (one, other) = (run(&design, &words), run(&design, &pair));
            let degenerate = one[16] == 1.0;
            assert_eq!(one[16..], other[16..], "{set:?} {words:?}");
            assert!(one[17] == 1.0 || one[15] != other[15], "{set:?} {words:?}");
            for (row, turned) in turned.into_iter().enumerate() {
                let sign = if turned && !degenerate { -1.0 } else { 1.0 };
                // dP/dv of a facet is rounded from the negated words, and ties round up.
                let rounds = row == 1 && set == ["frame=faceted", "basis=printed"];
                let off = if rounds { 2f64.powi(-15) } else { 0.0 };
                for i in 3 * row..3 * row + 3 {
                    let difference = (one[i] - sign * other[i]).abs();
                    assert!(difference <= off, "{set:?} {words:?} row {row}: {difference}");
                }
            }
            pairs += usize::from(!degenerate);
        }
        assert!(pairs > 1500, "{set:?}: {pairs}");
    }
}

/// The least widths.
const SMALL: [&str; 12] = [
    "position_int_bits=1",
    "position_frac_bits=0",
    "uv_int_bits=0",
    "uv_frac_bits=1",
    "component_bits=2",
    "guard_bits=0",
    "vector_bits=2",
    "vector_int_bits=0",
    "norm_bits=2",
    "dot_frac_bits=2",
    "root_addr_bits=2",
    "root_frac_bits=2",
];

/// The largest.
const LARGE: [&str; 11] = [
    "position_int_bits=8",
    "position_frac_bits=9",
    "uv_int_bits=3",
    "uv_frac_bits=12",
    "component_bits=24",
    "vector_bits=24",
    "norm_bits=24",
    "dot_frac_bits=24",
    "root_addr_bits=12",
    "root_frac_bits=22",
    "out_frac_bits=24",
];

/// Every stated bound holds over the hard list and random inputs.
#[test]
fn bounds_hold_at_every_width_and_switch() {
    let mut coarse = Vec::new();
    let mut sets: Vec<Vec<&str>> = VARIANTS.iter().map(|set| set.to_vec()).collect();
    for of in [&SMALL[..], &LARGE] {
        for frame in ["frame=smooth", "frame=faceted"] {
            for basis in ["basis=orthonormal", "basis=printed"] {
                sets.push([of, &[frame, basis]].concat());
            }
        }
    }
    sets.push(vec!["lights=8", "rounding=floor"]);
    sets.push(vec!["rounding=toward-zero", "basis=printed", "root_scheme=direct"]);
    sets.push(vec![
        "rounding=half-even",
        "frame=faceted",
        "root_scheme=newton",
        "root_addr_bits=7",
    ]);
    sets.push(vec![
        "component_bits=10",
        "guard_bits=0",
        "norm_bits=12",
        "out_frac_bits=8",
        "lights=3",
    ]);
    sets.push(vec![
        "position_int_bits=0",
        "position_frac_bits=23",
        "uv_int_bits=0",
        "uv_frac_bits=15",
        "component_bits=18",
    ]);
    sets.push(vec![
        "frame=faceted",
        "position_int_bits=22",
        "position_frac_bits=1",
        "uv_int_bits=22",
        "uv_frac_bits=1",
    ]);
    // Vectors in texture space with few fraction bits: the longest are still representable.
    for widths in [["0", "0"], ["0", "1"], ["1", "0"], ["1", "1"]] {
        let [whole, fraction] = widths;
        let widths = [format!("vector_int_bits={whole}"), format!("out_frac_bits={fraction}")];
        for frame in ["frame=smooth", "frame=faceted"] {
            for basis in ["basis=orthonormal", "basis=printed"] {
                coarse.push(
                    [frame.to_owned(), basis.to_owned()]
                        .into_iter()
                        .chain(widths.clone())
                        .collect(),
                );
            }
        }
    }
    sets.extend(coarse.iter().map(|set: &Vec<String>| set.iter().map(String::as_str).collect()));
    for set in &sets {
        let design = design(set);
        let bounds = BoundCheck::new(&design).unwrap();
        assert!(!bounds.stated.is_empty(), "{set:?}: {:?}", bounds.why_none);
        for sampler in [Sampler::Lit, Sampler::Sphere, Sampler::Hard] {
            let inputs = Inputs { sampler, samples: 10_000, seed: 5 };
            let report = &measure(&[&design], &inputs, &|_| ()).unwrap()[0];
            let seen: Vec<f64> = bounds.stated.iter().map(|bound| bound.seen(report)).collect();
            assert!(bounds.hold(report), "{set:?} {sampler:?}: {seen:?} {:#?}", bounds.stated);
        }
        for verdict in hard_verdicts(&design, &bounds) {
            assert_eq!(verdict.holds, Some(true), "{set:?}: {verdict:?}");
        }
    }
}

/// Every triangle of two-bit words and every texture of two-bit words, each with some of the other.
#[test]
fn every_small_triangle_has_its_flags_and_a_frame() {
    for frame in ["frame=smooth", "frame=faceted"] {
        let mut set = SMALL[..4].to_vec();
        set.push(frame);
        let design = design(&set);
        let bounds = BoundCheck::new(&design).unwrap();
        let ports = design.netlist.inputs().len();
        let names: Vec<&str> = (0..ports).map(|port| design.netlist.input_name(port)).collect();
        let usual = words_of(
            &design,
            &[("normal_y", 0.6), ("normal_z", 0.8), ("view_x", 1.0), ("light0_z", 1.0)],
        );
        let of = |prefix: fn(&str) -> bool| -> Vec<usize> {
            (0..ports).filter(|port| prefix(names[*port])).collect()
        };
        let positions = of(|name| name.starts_with('p'));
        let textures = of(|name| name.starts_with("uv"));
        let mut rows = Vec::new();
        let fill = |row: &mut Vec<i64>, ports: &[usize], mut bits: u64| {
            for port in ports {
                row[*port] = i64::try_from(bits & 3).unwrap() - 2;
                bits >>= 2;
            }
        };
        for bits in 0..1u64 << 18 {
            // Not all combinations: each position gets one of 4096 textures, and vice versa.
            let mut row = usual.clone();
            fill(&mut row, &positions, bits);
            fill(&mut row, &textures, bits.wrapping_mul(0x9e37_79b9) >> 7 & 0xfff);
            rows.push(row);
        }
        let mut counts = [0; 4];
        for row in &rows {
            let exact = Exact::new(&Ports { design: &design, words: row });
            let outputs = run(&design, row);
            let [mirrored, zero_uv, zero_area] = exact.flags();
            let flags = &outputs[15..];
            assert_eq!(
                [flags[0], flags[2], flags[3]],
                [mirrored, zero_uv, zero_area].map(|x| f64::from(u8::from(x)))
            );
            for (count, flag) in counts.iter_mut().zip(flags) {
                *count += usize::from(*flag == 1.0);
            }
            let golden = golden(&design, row);
            assert_eq!(flags, &golden[15..], "{frame} {row:?}");
            for (at, bound) in bounds.stated[..3].iter().enumerate() {
                for i in 3 * at..3 * at + 3 {
                    assert!((outputs[i] - golden[i]).abs() <= bound.bound, "{frame} {row:?}: {i}");
                }
            }
        }
        assert!(counts.iter().all(|count| *count > 1000 && *count < 200_000), "{counts:?}");
    }
}

/// Frames are orthonormal with unit normals, even in degenerate cases.
#[test]
fn orthonormal_maps_are_orthonormal() {
    for frame in ["frame=smooth", "frame=faceted"] {
        for mirror in ["mirror=handed", "mirror=printed", "mirror=off"] {
            let design = design(&[frame, mirror]);
            let bounds = BoundCheck::new(&design).unwrap();
            let off = bounds.stated[..3].iter().map(|bound| bound.bound).sum::<f64>() + 1e-4;
            for words in samples(&design, Sampler::Sphere, 3000) {
                let outputs = run(&design, &words);
                let rows = rows(&outputs);
                let length = dot(rows[2], rows[2]).sqrt();
                if (length - 1.0).abs() > 1e-4 {
                    continue; // of the hard list
                }
                for (i, u) in rows.iter().enumerate() {
                    for (j, v) in rows.iter().enumerate() {
                        let should = f64::from(u8::from(i == j));
                        assert!((dot(*u, *v) - should).abs() < 3.0 * off, "{words:?}: {rows:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn widths_that_do_not_go_together_are_refused() {
    let refused = |set: &[&str]| {
        let values = Unit::find("tangent").unwrap().values(set).unwrap();
        values.build().unwrap_err().to_string()
    };
    for name in ["position", "uv"] {
        for (whole, fraction, legal) in
            [(20, 4, (0, 19)), (0, 0, (1, 22)), (22, 2, (0, 21)), (22, 23, (0, 0))]
        {
            let set = |whole: i32| {
                let (frame, narrow) = ("frame=faceted".to_owned(), "vector_bits=2".to_owned());
                let whole = format!("{name}_int_bits={whole}");
                [whole, format!("{name}_frac_bits={fraction}"), frame, narrow]
            };
            let build = |whole| Unit::find("tangent").unwrap().values(&set(whole))?.build();
            let text = build(whole).unwrap_err().to_string();
            let range = format!("legal is {} to {} with", legal.0, legal.1);
            assert!(text.contains(&format!("{name}_int_bits")) && text.contains(&range), "{text}");
            // The ends are legal, and the values next to them aren't.
            assert!(build(legal.0).is_ok() && build(legal.1).is_ok(), "{text}");
            assert!(build(legal.0 - 1).is_err() && build(legal.1 + 1).is_err(), "{text}");
        }
    }
    let widest = ["frame=faceted", "component_bits=24", "root_frac_bits=22"];
    let text = refused(&[&widest[..], &["guard_bits=8"]].concat());
    assert!(
        text.contains("guard_bits") && text.contains("0 to 7 with component_bits=24"),
        "{text}"
    );
    design(&[&widest[..], &["guard_bits=7"]].concat());
    let text = refused(&["position_frac_bits=19", "uv_frac_bits=20", "component_bits=12"]);
    assert!(text.contains("component_bits") && text.contains("2 to 11"), "{text}");
    // The widest legal combination is built.
    for set in [
        &["position_frac_bits=19", "uv_frac_bits=20", "component_bits=11"][..],
        &["position_frac_bits=19", "uv_frac_bits=20", "component_bits=11", "basis=printed"],
        &["position_frac_bits=19", "uv_frac_bits=21", "component_bits=24", "frame=faceted"],
        &[
            "position_frac_bits=19",
            "uv_frac_bits=21",
            "component_bits=24",
            "frame=faceted",
            "basis=printed",
            "guard_bits=8",
            "vector_bits=24",
        ],
    ] {
        design(set);
    }
}

/// At the ends of all widths: combinations that don't go together are refused by a parameter, not
/// by a node.
#[test]
fn no_width_is_refused_by_a_node() {
    const ENDS: [(&str, [&str; 2]); 10] = [
        ("position_frac_bits", ["0", "19"]),
        ("uv_frac_bits", ["0", "21"]),
        ("component_bits", ["2", "24"]),
        ("guard_bits", ["0", "8"]),
        ("vector_bits", ["2", "24"]),
        ("out_frac_bits", ["0", "30"]),
        ("norm_bits", ["2", "24"]),
        ("dot_frac_bits", ["2", "24"]),
        ("root_frac_bits", ["2", "22"]),
        ("vector_int_bits", ["0", "20"]),
    ];
    let mut counts = [0; 2];
    for bits in 0..1 << ENDS.len() {
        for frame in ["frame=smooth", "frame=faceted"] {
            for basis in ["basis=orthonormal", "basis=printed"] {
                let mut set =
                    vec![frame.to_owned(), basis.to_owned(), "root_addr_bits=2".to_owned()];
                set.extend(
                    ENDS.iter()
                        .enumerate()
                        .map(|(at, (name, ends))| format!("{name}={}", ends[bits >> at & 1])),
                );
                let built = Unit::find("tangent").unwrap().values(&set).unwrap().build();
                counts[usize::from(built.is_ok())] += 1;
                if let Err(why) = built {
                    let text = why.to_string();
                    assert!(
                        text.starts_with("parameter") && text.contains(" to "),
                        "{set:?}: {text}"
                    );
                }
            }
        }
    }
    assert!(counts.iter().all(|count| *count > 100), "{counts:?}");
}

/// Multipliers are shared at the defaults, for all switches.
#[test]
fn every_variant_shares_its_multipliers() {
    for frame in ["frame=smooth", "frame=faceted"] {
        for basis in ["basis=orthonormal", "basis=printed"] {
            let design = design(&[frame, basis, "schedule=shared", "share_mul=2"]);
            let rtl = design.rtl().unwrap_or_else(|why| panic!("{frame} {basis}: {why}"));
            assert!(rtl.schedule().interval() > 1);
        }
    }
}

/// On reals the netlists equal the goldens, where exact products fit an `f64`: there is no
/// algorithm error.
#[test]
fn netlists_on_reals_are_the_goldens() {
    for set in VARIANTS {
        let design = design(set);
        for sampler in [Sampler::Lit, Sampler::Sphere, Sampler::Hard] {
            let inputs = Inputs { sampler, samples: 5000, seed: 9 };
            let report = &measure(&[&design], &inputs, &|_| ()).unwrap()[0];
            for figures in report.figures.iter().filter(|f| f.basis == Basis::Algorithm) {
                assert!(figures.max < 1e-12, "{set:?} {sampler:?}: {figures:?}");
            }
        }
    }
}

/// A triangle's values are computed once for its vertices: the exact edges with smooth normals, the
/// map of a facet.
#[test]
fn triangles_share_what_does_not_depend_on_the_vertex() {
    for (set, primitive, vertex) in
        [(&[][..], 14, 36), (&["frame=faceted"], 32, 18), (&["basis=printed"], 20, 27)]
    {
        let design = design(set);
        let netlist = &design.netlist;
        let known = |(port, id): (usize, &fixpath::netlist::NodeId)| {
            let name = netlist.input_name(port);
            let rate = if name.starts_with('p') || name.starts_with("uv") {
                Rate::Face
            } else {
                Rate::Pixel
            };
            Known { rate, ..Known::nothing(netlist.node(*id).format) }
        };
        let known: Vec<Known> = netlist.inputs().iter().enumerate().map(known).collect();
        let outputs: Vec<&str> =
            netlist.outputs().iter().map(|output| output.name.as_str()).collect();
        let special = specialise(netlist, &known, &outputs);
        let face = special.face.as_ref().unwrap();
        let multipliers = [&face.netlist, &special.pixel.netlist]
            .map(|netlist| netlist.counts().datapath.multipliers);
        assert_eq!(multipliers, [primitive, vertex], "{set:?}");
        for words in samples(&design, Sampler::Lit, 200) {
            let values = |netlist: &fixpath::netlist::Netlist, words: &[i64]| -> Vec<i64> {
                let all = netlist.eval(words).unwrap().0;
                netlist.outputs().iter().map(|output| all[output.node.index()]).collect()
            };
            let of_face = values(&face.netlist, &face.select(&words, &[]));
            let of_vertex = values(&special.pixel.netlist, &special.pixel.select(&words, &of_face));
            assert_eq!(of_vertex, values(netlist, &words), "{set:?} {words:?}");
        }
    }
}
