//! Netlists specialised for the values that occur at their inputs, against the general ones.

use super::engines::{self, Random, random_netlist_of, random_netlist_within};
use crate::common::design;
use fixpath::format::{Format, Overflow, Round};
use fixpath::netlist::{Builder, Column, Counts, Netlist, NodeId, Operators, Quantity, Table};
use fixpath::op::Op;
use fixpath::specialise::{Known, Rate, Source, Specialised, Words, ranges, specialise};
use std::collections::BTreeMap;
use std::sync::Arc;

fn rotation(assignments: &[&str]) -> Netlist {
    Netlist::clone(&design("rotation", assignments).netlist)
}

fn all_outputs(netlist: &Netlist) -> Vec<&str> {
    netlist.outputs().iter().map(|output| output.name.as_str()).collect()
}

/// Nothing, one word, an interval or a few intervals.
fn random_words(random: &mut Random, format: Format) -> Words {
    let interval = |random: &mut Random| {
        let (a, b) = (random.word(format), random.word(format));
        (a.min(b), a.max(b))
    };
    match random.below(6) {
        0 => Words::all(format),
        1 => Words::only(random.word(format)),
        2 | 3 => Words::of([interval(random)]),
        4 => {
            let near = random.word(format);
            Words::between(near, near.saturating_add(3).min(format.max_raw()))
        }
        _ => {
            let parts: Vec<_> = (0..2 + random.below(3)).map(|_| interval(random)).collect();
            Words::of(parts)
        }
    }
}

/// Every word of a small set; for a large one the ends and some in between.
fn members(words: &Words, random: &mut Random, limit: i64) -> Vec<i64> {
    let mut members = Vec::new();
    for (lo, hi) in words.intervals() {
        if hi - lo < limit {
            members.extend(*lo..=*hi);
        } else {
            members.extend([*lo, *lo + 1, *hi - 1, *hi]);
            // A span of 63 bits plus one exceeds i64.
            members.extend(
                (0..limit).map(|_| random.within(*lo, (*hi).min(lo.saturating_add(i64::MAX - 1)))),
            );
        }
    }
    members
}

/// The inputs to try: all of them if they are few.
fn inputs_of(words: &[Words], random: &mut Random, most: usize) -> Vec<Vec<i64>> {
    let members: Vec<Vec<i64>> = words.iter().map(|words| members(words, random, 40)).collect();
    let count = members.iter().map(Vec::len).fold(1usize, usize::saturating_mul);
    if count > most {
        let any = |random: &mut Random| members.iter().map(|of| random.pick(of)).collect();
        return (0..most).map(|_| any(random)).collect();
    }
    let mut inputs = vec![Vec::new()];
    for of in &members {
        let with = |input: &Vec<i64>| -> Vec<Vec<i64>> {
            of.iter().map(|word| input.iter().copied().chain([*word]).collect()).collect()
        };
        inputs = inputs.iter().flat_map(with).collect();
    }
    inputs
}

fn outputs(netlist: &Netlist, inputs: &[i64]) -> BTreeMap<String, i64> {
    let words = netlist.eval(inputs).unwrap().0;
    netlist.outputs().iter().map(|o| (o.name.clone(), words[o.node.index()])).collect()
}

/// Output words of the whole datapath, and of its face part followed by the rest.
fn both_ways(of: &Specialised, inputs: &[i64]) -> [BTreeMap<String, i64>; 2] {
    let whole = outputs(&of.whole.netlist, &of.whole.select(inputs, &[]));
    let face: Vec<i64> = of.face.as_ref().map_or_else(Vec::new, |face| {
        let words = face.netlist.eval(&face.select(inputs, &[])).unwrap().0;
        face.netlist.outputs().iter().map(|output| words[output.node.index()]).collect()
    });
    [whole, outputs(&of.pixel.netlist, &of.pixel.select(inputs, &face))]
}

/// Compares the general netlist, its ranges and its specialised forms on the same inputs.
fn check(
    netlist: &Netlist,
    known: &[Known],
    wanted: &[&str],
    random: &mut Random,
    most: usize,
) -> Result<Specialised, String> {
    let words: Vec<Words> = known.iter().map(|known| known.words.clone()).collect();
    let found = ranges(netlist, &words);
    let special = specialise(netlist, known, wanted);
    for input in inputs_of(&words, random, most) {
        let general = netlist.eval(&input).unwrap().0;
        for (id, raw) in netlist.ids().zip(&general) {
            if !found[id.index()].contains(*raw) {
                return Err(format!(
                    "{} is {raw}, outside {}, for {input:?} of {words:?}\n{}",
                    netlist.label(id),
                    found[id.index()],
                    netlist.to_text()
                ));
            }
        }
        let mut expected = outputs(netlist, &input);
        expected.retain(|name, _| wanted.contains(&name.as_str()));
        for (is, part) in both_ways(&special, &input).iter().zip(["whole", "face and pixel"]) {
            if *is != expected {
                return Err(format!(
                    "{part}: {is:?} and not {expected:?} for {input:?} of {words:?}\n{}\n{}\n{}",
                    netlist.to_text(),
                    special.whole.netlist.to_text(),
                    special.pixel.netlist.to_text()
                ));
            }
        }
    }
    Ok(special)
}

fn random_known(netlist: &Netlist, random: &mut Random) -> Vec<Known> {
    let known = |id: &NodeId| Known {
        words: random_words(random, netlist.node(*id).format),
        rate: random.pick(&[Rate::Scene, Rate::Face, Rate::Pixel]),
    };
    netlist.inputs().iter().map(known).collect()
}

#[test]
fn random_netlists_keep_their_outputs() {
    let (mut split, mut cut, mut folded) = (0, 0, 0);
    for seed in 0..1500 {
        let mut random = Random::new(seed ^ 0x5bec);
        let operations = 3 + random.below(40);
        let netlist = match seed % 3 {
            0 => random_netlist_of(seed, operations),
            _ => random_netlist_within(seed, operations, 3 + (seed % 4) as u32),
        };
        let known = random_known(&netlist, &mut random);
        let mut wanted = all_outputs(&netlist);
        while wanted.len() > 1 && random.chance(30) {
            wanted.remove(random.below(wanted.len()));
        }
        let special = check(&netlist, &known, &wanted, &mut random, 600)
            .unwrap_or_else(|why| panic!("seed {seed}: {why}"));
        let names: Vec<&str> =
            special.pixel.netlist.outputs().iter().map(|o| o.name.as_str()).collect();
        assert_eq!(names, wanted);
        split += u32::from(special.face.is_some());
        cut += u32::from(special.report.whole.counts.rom_bits < special.report.before.rom_bits);
        folded += u32::from(special.report.folded_nodes > 0);
        serde_json::to_string(&special.report).unwrap();
        // The fast engines run the remaining netlist, also on words that the scene doesn't have.
        for part in [Some(&special.pixel), special.face.as_ref()].into_iter().flatten() {
            if seed % 10 == 0 && !part.inputs.is_empty() {
                engines::check(&part.netlist, seed, 300).unwrap();
            }
        }
    }
    // If the generator stopped producing these, the test would check less than it claims.
    assert!(split > 300 && cut > 200 && folded > 300, "{split} {cut} {folded}");
}

/// Operators that have a cost.
fn sizes(counts: &Counts) -> Vec<u64> {
    let of = |o: &Operators| {
        [o.multipliers, o.adders, o.negations, o.comparators, o.multiplexers, o.shifters]
    };
    let operators = [counts.datapath, counts.schemes, counts.parts].into_iter().map(|o| of(&o));
    let sums = operators.fold([0; 6], |sum, of| std::array::from_fn(|i| sum[i] + of[i]));
    let tables = [counts.reads, counts.ports, counts.rom_bits_dual_port];
    // A negation may replace a subtraction or a magnitude.
    [sums[0], sums[1] + sums[2], sums[3], sums[4], sums[5]].into_iter().chain(tables).collect()
}

#[test]
fn nothing_grows_and_nothing_is_cut_where_nothing_is_known() {
    for seed in 0..400 {
        let netlist = random_netlist_of(seed, 40);
        let known: Vec<Known> =
            netlist.inputs().iter().map(|id| Known::nothing(netlist.node(*id).format)).collect();
        let special = specialise(&netlist, &known, &all_outputs(&netlist));
        let (before, after) = (sizes(&special.report.before), sizes(&special.report.whole.counts));
        assert!(
            before.iter().zip(&after).all(|(before, after)| after <= before),
            "seed {seed}: {before:?} {after:?}"
        );
        assert!(special.face.is_none() && special.report.removed_outputs.is_empty());
    }
    for form in ["output=cartesian", "output=polar-table", "output=polar-cordic"] {
        for scheme in ["scheme=direct", "scheme=linear", "scheme=bipartite"] {
            let netlist = rotation(&[form, scheme]);
            let known = turns(&netlist, &[None, None, None, None]);
            let special = specialise(&netlist, &known, &all_outputs(&netlist));
            let (before, after) = (special.report.before, special.report.whole.counts);
            assert_eq!(
                (after.reads, after.ports, after.datapath.multipliers),
                (before.reads, before.ports, before.datapath.multipliers),
                "{form} {scheme}"
            );
            // Ports that read one of two columns need no copy of the other.
            let (before, after) = (before.rom_bits_dual_port, after.rom_bits_dual_port);
            let cosines_alone = form == "output=cartesian";
            assert!(
                if cosines_alone { after < before } else { after <= before },
                "{form} {scheme}"
            );
        }
    }
}

#[test]
#[should_panic(expected = "bug: no output of `rotation` is wanted")]
fn at_least_one_output_must_be_wanted() {
    let netlist = rotation(&[]);
    let known = turns(&netlist, &[None, None, None, None]);
    drop(specialise(&netlist, &known, &[]));
}

#[test]
fn constant_inputs_give_a_constant_netlist() {
    for seed in 0..200 {
        let netlist = random_netlist_of(seed, 30);
        let mut random = Random::new(seed);
        let known: Vec<Known> = netlist
            .inputs()
            .iter()
            .map(|id| Known {
                words: Words::only(random.word(netlist.node(*id).format)),
                rate: Rate::Pixel,
            })
            .collect();
        let special = check(&netlist, &known, &all_outputs(&netlist), &mut random, 1).unwrap();
        assert!(special.whole.inputs.is_empty() && special.whole.netlist.tables().is_empty());
        let ops = special.whole.netlist.nodes().iter().map(|node| node.op);
        assert!(ops.into_iter().all(|op| matches!(op, Op::Const { .. })), "seed {seed}");
    }
}

type Build = fn(&mut Builder, &[NodeId]) -> Option<NodeId>;

/// Every operation on operands of two formats, where it accepts them.
fn operations() -> Vec<(&'static str, Build)> {
    fn integer(format: Format) -> bool {
        !format.is_signed() && format.frac_bits() == 0
    }
    vec![
        ("add", |b, of| Some(b.add(of[0], of[1]))),
        ("sub", |b, of| Some(b.sub(of[0], of[1]))),
        ("mul", |b, of| Some(b.mul(of[0], of[1]))),
        ("square", |b, of| Some(b.mul(of[0], of[0]))),
        ("neg", |b, of| Some(b.neg(of[0]))),
        ("abs", |b, of| Some(b.abs(of[0]))),
        ("equal", |b, of| Some(b.equal(of[0], of[1]))),
        ("less", |b, of| Some(b.less(of[0], of[1]))),
        ("addsub", |b, of| Some(b.addsub(of[2], of[0], of[1]))),
        ("mux", |b, of| Some(b.mux(of[2], of[0], of[1]))),
        ("shift", |b, of| Some(b.shift(of[0], 1))),
        ("and", |b, of| (b.format(of[0]) == b.format(of[1])).then(|| b.and(of[0], of[1]))),
        ("or", |b, of| (b.format(of[0]) == b.format(of[1])).then(|| b.or(of[0], of[1]))),
        ("xor", |b, of| (b.format(of[0]) == b.format(of[1])).then(|| b.xor(of[0], of[1]))),
        ("slice low", |b, of| Some(b.slice(of[0], 0, 2))),
        ("slice high", |b, of| Some(b.slice(of[0], 1, 2))),
        ("concat", |b, of| {
            let formats = [b.format(of[0]), b.format(of[1])];
            formats.into_iter().all(integer).then(|| b.concat(of[0], of[1]))
        }),
        ("leading zeros", |b, of| (!b.format(of[0]).is_signed()).then(|| b.leading_zeros(of[0]))),
        ("shift left", |b, of| integer(b.format(of[1])).then(|| b.shift_left(of[0], of[1], 3))),
        ("modulo", |b, of| {
            let format = Format::new(true, 2, b.format(of[0]).frac_bits()).unwrap();
            Some(b.modulo(of[0], format))
        }),
        ("read", |b, of| {
            if !integer(b.format(of[0])) {
                return None;
            }
            let bits = b.format(of[0]).bits();
            let words: Vec<i64> = (0..1i64 << bits).map(|i| (i * 5) % 7 - 3).collect();
            let format = Format::signed(4, 1).unwrap();
            let column = Column { name: "c".to_owned(), format, words: Arc::from(words) };
            let table = b.table(Table {
                name: "t".to_owned(),
                addr_bits: bits,
                columns: vec![column],
                memory: None,
            });
            Some(b.read(table, 0, of[0]))
        }),
    ]
}

/// Operations whose result ranges are exact, where single intervals make that cheap.
const EXACT_ENDS: &[&str] = &[
    "add",
    "sub",
    "mul",
    "square",
    "neg",
    "abs",
    "less",
    "addsub",
    "mux",
    "shift",
    "slice low",
    "slice high",
    "leading zeros",
    "shift left",
    "modulo",
    "read",
];

#[test]
fn ranges_hold_every_word_of_every_operation() {
    let mut formats = Vec::new();
    for signed in [false, true] {
        for (bits, frac) in [(3, 0), (3, 1), (4, 0), (2, -1)] {
            formats.push(Format::new(signed, bits, frac).unwrap());
        }
    }
    let mut cases = 0;
    for (name, build) in operations() {
        for first in &formats {
            for second in &formats {
                let mut b = Builder::new("one");
                let operands = [("a", *first), ("b", *second), ("flag", Format::FLAG)];
                let of = operands.map(|(name, format)| b.input(name, format, Quantity::Number));
                if name.starts_with("slice") && first.bits() < 3 {
                    continue;
                }
                let Some(node) = build(&mut b, &of) else { continue };
                b.output("out", node);
                cases += check_operation(&b.build().unwrap(), name);
            }
        }
    }
    for to in ["u3f1", "s2f0", "s4f2", "s3f-1"] {
        let to: Format = to.replace("f-", "e").parse().unwrap();
        for from in [&formats[..], &[Format::signed(5, 3).unwrap()]].concat() {
            for round in Round::ALL {
                for overflow in Overflow::ALL {
                    let mut b = Builder::new("one");
                    let a = b.input("a", from, Quantity::Number);
                    let node = b.narrow(a, to, *round, *overflow);
                    b.output("out", node);
                    cases += check_operation(&b.build().unwrap(), "narrow");
                }
            }
        }
    }
    assert!(cases > 300_000, "{cases}");
}

/// All intervals of up to two operands; a flag is 0, 1 or either.
fn check_operation(netlist: &Netlist, name: &str) -> u64 {
    let node = netlist.outputs()[0].node;
    let used: Vec<bool> = netlist
        .inputs()
        .iter()
        .map(|id| netlist.node(node).operands.contains(id) || *id == node)
        .collect();
    let intervals: Vec<Vec<(i64, i64)>> = netlist
        .inputs()
        .iter()
        .zip(&used)
        .map(|(id, used)| {
            let format = netlist.node(*id).format;
            let (min, max) = (format.min_raw(), format.max_raw());
            if !used {
                return vec![(min, min)];
            }
            (min..=max).flat_map(|lo| (lo..=max).map(move |hi| (lo, hi))).collect()
        })
        .collect();
    // The result of each choice of words is computed once.
    let mut results: BTreeMap<Vec<i64>, i64> = BTreeMap::new();
    let wholes: Vec<Words> = intervals.iter().map(|of| Words::of(of.iter().copied())).collect();
    let mut random = Random::new(0);
    for input in inputs_of(&wholes, &mut random, usize::MAX) {
        let word = netlist.eval(&input).unwrap().0[node.index()];
        results.insert(input, word);
    }
    let mut cases = 0;
    let pick = |at: usize, port: usize| intervals.get(port).map(|of| of[at]);
    let lens: Vec<usize> = (0..3).map(|port| intervals.get(port).map_or(1, Vec::len)).collect();
    for i in 0..lens[0] {
        // Large operands: not all pairs.
        let step = 1 + lens[0] * lens[1] / 3000;
        for j in (i % step..lens[1]).step_by(step) {
            for k in 0..lens[2] {
                let words: Vec<Words> = [pick(i, 0), pick(j, 1), pick(k, 2)]
                    .into_iter()
                    .flatten()
                    .map(|(lo, hi)| Words::between(lo, hi))
                    .collect();
                let found = &ranges(netlist, &words)[node.index()];
                let reached: Vec<i64> = inputs_of(&words, &mut random, usize::MAX)
                    .iter()
                    .map(|input| results[input])
                    .collect();
                for raw in &reached {
                    assert!(
                        found.contains(*raw),
                        "{name}: {raw} is outside {found} for {words:?}\n{}",
                        netlist.to_text()
                    );
                }
                let ends = (*reached.iter().min().unwrap(), *reached.iter().max().unwrap());
                if EXACT_ENDS.contains(&name) {
                    assert_eq!(
                        (found.lo(), found.hi()),
                        ends,
                        "{name} for {words:?}\n{}",
                        netlist.to_text()
                    );
                }
                cases += 1;
            }
        }
    }
    cases
}

/// Angles of the rotation unit from `lo` to `hi` turns, per pixel; the words wrap.
fn turns(netlist: &Netlist, ranges: &[Option<(f64, f64)>]) -> Vec<Known> {
    let known = |(id, range): (&NodeId, &Option<(f64, f64)>)| {
        let format = netlist.node(*id).format;
        let Some((lo, hi)) = range else { return Known::nothing(format) };
        let word =
            |turns: f64| format.wrap((turns * 2f64.powi(format.bits() as i32)).round() as i64);
        let (lo, hi) = (word(*lo), word(*hi));
        let words = if lo <= hi {
            Words::between(lo, hi)
        } else {
            Words::of([(lo, format.max_raw()), (0, hi)])
        };
        Known { words, rate: Rate::Pixel }
    };
    netlist.inputs().iter().zip(ranges).map(known).collect()
}

fn special_rotation(
    assignments: &[&str],
    given: &[Option<(f64, f64)>],
    rates: [Rate; 4],
) -> Specialised {
    let netlist = rotation(assignments);
    let mut known = turns(&netlist, given);
    known.iter_mut().zip(rates).for_each(|(known, rate)| known.rate = rate);
    let special = check(&netlist, &known, &all_outputs(&netlist), &mut Random::new(7), 3000);
    special.unwrap()
}

const FORMS: &[&[&str]] = &[
    &["output=cartesian"],
    &["output=cartesian", "quarter_wave=on"],
    &["output=cartesian", "scheme=bipartite"],
    &["output=cartesian", "scheme=linear"],
    &["output=polar-table", "scheme=linear"],
    &["output=polar-cordic"],
    &["variant=corrected"],
    &["variant=printed", "quarter_wave=on"],
];

#[test]
fn a_constant_normal_and_light_fold_the_rotation() {
    let at = |turns: f64| Some((turns, turns));
    for form in FORMS {
        let given = [at(0.1), at(0.2), at(0.3), at(0.05)];
        let special = special_rotation(form, &given, [Rate::Pixel; 4]);
        assert!(special.whole.netlist.inputs().is_empty(), "{form:?}");
        assert_eq!(special.report.whole.counts.rom_bits, 0);
        assert_eq!(special.report.removed_inputs, ["phi_a", "theta_a", "phi_n", "theta_n"]);
        assert!(special.report.folded.iter().any(|node| node.node == "angles.ang_x"));
    }
}

#[test]
fn a_face_has_its_light_turned_once() {
    for form in FORMS {
        let special =
            special_rotation(form, &[None; 4], [Rate::Scene, Rate::Scene, Rate::Face, Rate::Face]);
        let face = special.face.unwrap();
        assert_eq!(face.netlist.inputs().len(), 4);
        assert!(special.pixel.inputs.iter().all(|source| matches!(source, Source::Face(_))));
        assert_eq!(special.report.pixel.counts.rom_bits, 0, "{form:?}");
        // Only the result crosses to the pixel part, under a name that no output has.
        let outputs = special.pixel.netlist.outputs().len();
        assert_eq!(special.pixel.netlist.inputs().len(), outputs);
        assert_eq!(special.report.hoisted.len(), outputs);
    }
    // One direction per pixel: sums of the face's angles are computed once.
    let special = special_rotation(
        &["variant=corrected"],
        &[None; 4],
        [Rate::Pixel, Rate::Face, Rate::Face, Rate::Face],
    );
    let hoisted: Vec<&str> = special.report.hoisted.iter().map(|word| word.port.as_str()).collect();
    assert_eq!(hoisted, ["behind"]);
}

#[test]
fn angle_ranges_cut_the_table() {
    // Sums of four such angles stay within an eighth of a turn around the seam, where words wrap.
    let seam = Some((-1.0 / 66.0, 1.0 / 66.0));
    let special = special_rotation(&["output=cartesian"], &[seam; 4], [Rate::Pixel; 4]);
    let cut = &special.report.whole.tables[0];
    assert_eq!((cut.table.as_str(), cut.rows), ("sincos", 1024));
    assert!(cut.into.iter().all(|table| table.rows <= 128), "{cut:?}");
    let bits = |counts: &Counts| counts.rom_bits_dual_port;
    assert!(bits(&special.report.whole.counts) <= bits(&special.report.before) / 8, "{cut:?}");
    assert_eq!(special.report.whole.counts.datapath.adders, special.report.before.datapath.adders);
    // Words of the general unit keep their names.
    let names = |netlist: &Netlist| -> Vec<String> {
        netlist
            .ids()
            .filter(|id| netlist.node(*id).name.is_some())
            .map(|id| netlist.label(id))
            .collect()
    };
    assert_eq!(names(&special.whole.netlist), names(&rotation(&["output=cartesian"])));
}

/// The real values of a specialised unit are those of the general one, where nothing is folded.
#[test]
fn meanings_are_kept() {
    for form in FORMS {
        let netlist = rotation(form);
        let some = Some((0.01, 0.12));
        let special = special_rotation(
            form,
            &[some, some, Some((0.0, 0.06)), Some((0.3, 0.4))],
            [Rate::Pixel; 4],
        );
        let inputs = [0.03, 0.1, 0.05, 0.33];
        let values = |netlist: &Netlist| -> Vec<f64> {
            let values = netlist.eval_reals(&inputs);
            netlist.outputs().iter().map(|output| values[output.node.index()]).collect()
        };
        assert_eq!(values(&special.whole.netlist), values(&netlist), "{form:?}");
    }
}

#[test]
fn the_largest_unit_has_a_face_part() {
    let netlist = rotation(&["output=polar-cordic", "table_addr_bits=12"]);
    let given = [Some((0.9, 0.1)), Some((0.0, 0.25)), Some((0.1, 0.2)), Some((0.0, 0.1))];
    let mut known = turns(&netlist, &given);
    known[1..].iter_mut().for_each(|known| known.rate = Rate::Face);
    let special = specialise(&netlist, &known, &all_outputs(&netlist));
    assert!(special.face.is_some());
}

#[test]
fn the_parts_of_an_exact_unit_meet_at_named_ports() {
    let mut b = Builder::new("lit");
    let format = Format::signed(6, 3).unwrap();
    let light = b.input("light", format, Quantity::Number);
    let bump = b.input("bump", format, Quantity::Number);
    let scale = b.input("scale", format, Quantity::Number);
    let strength = b.scope("light", |b| {
        let strength = b.mul(light, scale);
        b.name(strength, "strength")
    });
    let sum = b.add(strength, bump);
    b.output("sum", sum);
    b.output("strength", strength);
    b.output("unused", light);
    let netlist = b.build().unwrap();
    let of = |words: Words, rate: Rate| Known { words, rate };
    let known = [
        of(Words::between(-5, 9), Rate::Face),
        of(Words::between(0, 3), Rate::Pixel),
        of(Words::only(-4), Rate::Scene),
    ];
    let special = check(&netlist, &known, &["sum", "strength"], &mut Random::new(1), 1000).unwrap();
    assert_eq!(special.report.removed_outputs, ["unused"]);
    assert_eq!(special.report.removed_inputs, ["scale"]);
    expect_test::expect![[r#"
        netlist lit_face
          %0 = input : s6f3  # light
          %1 = const -4 : s6f3  # scale
          %2 = mul %0 %1 : s12f6  # light.strength
          output light_strength = %2
        netlist lit_pixel
          %0 = input : s6f3  # bump
          %1 = input : s12f6  # light_strength
          %2 = add %1 %0 : s13f6
          output sum = %2
          output strength = %1
    "#]]
    .assert_eq(&(special.face.unwrap().netlist.to_text() + &special.pixel.netlist.to_text()));
}
