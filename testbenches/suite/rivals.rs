//! The rivals of Table 1 against vectors and matrices, and Table 1 rebuilt.
//!
//! Golden values are derived here from fragments: only the units' ports are used.

use crate::common::{Vector, design, dot};
use fixpath::compare::{ARCHITECTURES, BY_PARAMETERS, COUNTS, compare, saved_percent};
use fixpath::measure::{Basis, BoundCheck, Inputs, hard_verdicts, measure, sample_words};
use fixpath::netlist::{Netlist, Part, ScopeId};
use fixpath::op::Op;
use fixpath::units::{Bounds, Design, Sampler};
use std::collections::BTreeSet;
use std::f64::consts::TAU;

const RIVALS: [&str; 4] = ["peercy", "ernst", "kim", "kugler"];

fn unit(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    if length == 0.0 { v } else { v.map(|x| x / length) }
}

fn combined(p: Vector, [x, y, z]: [Vector; 3]) -> Vector {
    [0, 1, 2].map(|i| p[0] * x[i] + p[1] * y[i] + p[2] * z[i])
}

fn direction(phi: f64, theta: f64) -> Vector {
    let ((sp, cp), (st, ct)) = ((phi * TAU).sin_cos(), (theta * TAU).sin_cos());
    [st * cp, st * sp, ct]
}

/// Values of named input ports.
struct Ports<'a> {
    design: &'a Design,
    values: Vec<f64>,
}

impl Ports<'_> {
    fn get(&self, name: &str) -> f64 {
        let netlist = &self.design.netlist;
        let port = (0..self.values.len()).find(|port| netlist.input_name(*port) == name);
        self.values[port.unwrap_or_else(|| panic!("no port {name}"))]
    }

    fn cartesian(&self, v: &str) -> Vector {
        ["x", "y", "z"].map(|axis| self.get(&format!("{v}_{axis}")))
    }

    fn polar(&self, v: &str) -> Vector {
        direction(self.get(&format!("phi_{v}")), self.get(&format!("theta_{v}")))
    }

    /// T, B, N of the texture: those of N's polar form, turned by psi about N.
    fn frame(&self, phi: f64, theta: f64) -> [Vector; 3] {
        let ((sp, cp), (st, ct)) = ((phi * TAU).sin_cos(), (theta * TAU).sin_cos());
        let (along_theta, along_phi) = ([ct * cp, ct * sp, -st], [-sp, cp, 0.0]);
        let (sin, cos) = (self.get("psi") * TAU).sin_cos();
        let mix = |a: f64, b: f64| [0, 1, 2].map(|i| a * along_theta[i] + b * along_phi[i]);
        [mix(cos, sin), mix(-sin, cos), direction(phi, theta)]
    }
}

fn light(dot_l: f64, dot_h: f64) -> [f64; 3] {
    let diffuse = 0.1 + 0.6 * dot_l.clamp(0.0, 1.0);
    let specular = 0.3 * dot_h.clamp(0.0, 1.0).powi(32);
    [(diffuse + specular).min(1.0), diffuse, specular]
}

/// The expected golden columns at the defaults.
fn should(ports: &Ports<'_>, name: &str) -> Vec<f64> {
    match name {
        "peercy" | "ernst" => {
            let [l, h, n, t, b, p] = ["l", "h", "n", "t", "b", "p"].map(|v| ports.cartesian(v));
            let [lt, ht] = [l, h].map(|v| unit([dot(t, v), dot(b, v), dot(n, v)]));
            let np = unit(p);
            if name == "peercy" {
                return [lt, ht, np].concat();
            }
            let (dot_l, dot_h) = (dot(np, lt), dot(np, ht));
            [&light(dot_l, dot_h)[..], &[dot_l, dot_h], &lt, &ht].concat()
        }
        "kim" => {
            let [t, b, n] = ports.frame(ports.get("phi_n"), ports.get("theta_n"));
            let world = combined(ports.polar("p"), [t, b, n]);
            let [l, h] = ["l", "h"].map(|v| ports.polar(v));
            let (dot_l, dot_h) = (dot(world, l), dot(world, h));
            // In the frame of N's polar form: the texture frame, turned back.
            let (sin, cos) = (ports.get("psi") * TAU).sin_cos();
            let own = |v: Vector| {
                let (x, y, z) = (dot(t, v), dot(b, v), dot(n, v));
                [x * cos - y * sin, x * sin + y * cos, z]
            };
            [&light(dot_l, dot_h)[..], &[dot_l, dot_h], &own(l), &own(h)].concat()
        }
        "kugler" => {
            let n = ports.cartesian("n");
            let (phi, theta) = (n[1].atan2(n[0]) / TAU, n[0].hypot(n[1]).atan2(n[2]) / TAU);
            let world = combined(ports.polar("p"), ports.frame(phi, theta));
            let seen = ["l", "h"].map(|v| {
                let (phi, theta) =
                    (ports.get(&format!("phi_{v}")), ports.get(&format!("theta_{v}")));
                let ((sp, cp), (st, ct)) = ((phi * TAU).sin_cos(), (theta * TAU).sin_cos());
                [[ct * cp, ct * sp, -st], [-sp, cp, 0.0], direction(phi, theta)]
                    .map(|axis| dot(axis, world))
            });
            [&light(seen[0][2], seen[1][2])[..], &world, &seen[0], &seen[1]].concat()
        }
        _ => panic!("{name}"),
    }
}

#[test]
fn goldens_are_those_of_vectors_and_matrices() {
    for name in RIVALS {
        let design = design(name, &[]);
        let netlist = &design.netlist;
        let inputs = Inputs { sampler: Sampler::Sphere, samples: 20_000, seed: 3 };
        let mut samples = sample_words(&design, &inputs).unwrap();
        samples.extend(design.hard.iter().flat_map(|case| case.words.clone()));
        for words in samples {
            let values: Vec<f64> = netlist
                .inputs()
                .iter()
                .zip(&words)
                .map(|(id, word)| netlist.node(*id).format.value(*word))
                .collect();
            let columns: Vec<[f64; 1]> = values.iter().map(|value| [*value]).collect();
            let slices: Vec<&[f64]> = columns.iter().map(|column| &column[..]).collect();
            let mut golden = vec![vec![0.0]; design.golden_columns()];
            design.golden.run(&slices, &mut golden);
            let should = should(&Ports { design: &design, values }, name);
            assert_eq!(golden.len(), should.len());
            for (is, should) in golden.iter().zip(should) {
                assert!((is[0] - should).abs() < 1e-12, "{name} {words:?}: {} for {should}", is[0]);
            }
        }
    }
}

/// The netlists on reals equal their goldens: no rival has an algorithm error here.
#[test]
fn reconstructions_are_exact_on_reals_and_bounds_hold() {
    let sets: &[(&str, &[&str])] = &[
        ("peercy", &[]),
        ("peercy", &["divider=restoring", "frac_bits=8"]),
        ("peercy", &["divider=table", "root=table", "scheme=linear"]),
        ("peercy", &["normalise=reciprocal-root", "scheme=bipartite", "rounding=floor"]),
        ("peercy", &["frac_bits=2", "guard_bits=0"]),
        ("ernst", &[]),
        ("ernst", &["divider=table", "frac_bits=10", "exponent=1", "highlight=off"]),
        ("ernst", &["frac_bits=3", "guard_bits=0", "rounding=toward-zero", "exponent=255"]),
        ("kim", &[]),
        ("kim", &["conversion=cordic", "scheme=linear", "quarter_wave=on"]),
        ("kim", &["angle_bits=2", "frac_bits=2", "guard_bits=0", "highlight=off"]),
        ("kugler", &[]),
        ("kugler", &["map_addr_bits=16", "tilt_addr_bits=18", "map_angle_bits=12"]),
        ("kugler", &["tilt_addr_bits=6", "map_addr_bits=4", "map_angle_bits=2", "angle_bits=2"]),
    ];
    for (name, set) in sets {
        let design = design(name, set);
        let bounds = BoundCheck::new(&design).unwrap();
        for sampler in [Sampler::Lit, Sampler::Hard] {
            let inputs = Inputs { sampler, samples: 20_000, seed: 5 };
            let report = &measure(&[&design], &inputs, &|_| ()).unwrap()[0];
            for figures in report.figures.iter().filter(|f| f.basis == Basis::Algorithm) {
                let is_light = ["intensity", "specular"].contains(&figures.quantity.as_str());
                let allowed = if is_light { 1e-11 } else { 1e-12 };
                assert!(
                    figures.max < allowed,
                    "{name} {set:?}: {} {}",
                    figures.quantity,
                    figures.max
                );
            }
            assert!(bounds.hold(report), "{name} {set:?}: {:?}", bounds.stated);
        }
        assert!(!hard_verdicts(&design, &bounds).is_empty());
        assert_eq!(matches!(design.bounds, Bounds::Unstated(_)), *name == "kugler");
    }
}

/// A finer map is more exact, in proportion to its cells.
#[test]
fn larger_maps_of_kugler_err_less() {
    let error = |set: &[&str]| {
        let design = design("kugler", set);
        let inputs = Inputs { sampler: Sampler::Lit, samples: 20_000, seed: 1 };
        measure(&[&design], &inputs, &|_| ()).unwrap()[0].figures("intensity", Basis::Total).mean
    };
    let coarse = error(&["tilt_addr_bits=11", "map_addr_bits=12"]);
    let fine = error(&["tilt_addr_bits=20", "map_addr_bits=20", "map_angle_bits=12"]);
    assert!(fine < 0.25 * coarse, "{fine} and {coarse}");
}

#[test]
fn every_difference_from_the_paper_has_its_reason() {
    let inputs = Inputs { sampler: Sampler::Lit, samples: 1000, seed: 1 };
    let comparison = compare(&[], &inputs, &|_, _| ()).unwrap();
    for (row, architecture) in comparison.rows.iter().zip(ARCHITECTURES) {
        for difference in &row.differences {
            assert!(difference.why != BY_PARAMETERS, "{}: {difference:?}", row.name);
        }
        assert_eq!(row.differences.len(), architecture.differences.len(), "{}", row.name);
        assert!(architecture.differences.iter().all(|note| COUNTS.contains(&note.count)));
    }
    // The figures that the paper's text states.
    let row = |name: &str| comparison.rows.iter().find(|row| row.name == name).unwrap();
    assert_eq!(row("peercy").set_up.counts(), [27, 18, 0, 0, 9, 3]);
    assert_eq!(row("ernst").set_up.counts(), [27, 18, 0, 0, 9, 3]);
    let ernst = row("ernst").illumination.unwrap();
    assert_eq!((ernst.multipliers, ernst.lookups), (7, 1));
    assert_eq!(row("kim").illumination.unwrap().multipliers, 6);
    let lee = row("lee corrected");
    assert_eq!((lee.set_up.multipliers, lee.illumination.unwrap().multipliers), (6, 2));
    let shares: Vec<f64> =
        comparison.claims.iter().map(|claim| saved_percent(claim.paper).round()).collect();
    assert!(shares.iter().all(|share| *share == 78.0), "{shares:?}");
}

/// The counts, recounted from the netlist's text form.
#[test]
fn counts_are_those_of_the_text_form() {
    let inputs = Inputs { sampler: Sampler::Lit, samples: 100, seed: 1 };
    let comparison = compare(&[], &inputs, &|_, _| ()).unwrap();
    for row in &comparison.rows {
        let set: Vec<&str> = row.parameters.iter().map(String::as_str).collect();
        let text = design(row.unit, &set).netlist.to_text();
        let count = |op: &str| {
            text.lines().filter(|line| line.contains(&format!("= {op} %"))).count() as u64
        };
        // No table scheme uses multipliers at the defaults; digit recurrences use adders.
        assert_eq!(count("mul"), row.whole.multipliers, "{}", row.name);
        if row.whole.dividers == 0 {
            assert_eq!(
                count("add") + count("sub") + count("addsub"),
                row.whole.adders,
                "{}",
                row.name
            );
        }
        let tables = text.lines().filter(|line| line.starts_with("  table ")).count() as u64;
        assert_eq!(tables, row.tables, "{}", row.name);
    }
}

/// Multipliers, adders, look-ups, maps, dividers and square roots of a stage, node by node; without
/// a stage, of both stages. At the defaults each read of a table scheme is a look-up.
fn recounted(netlist: &Netlist, stage: Option<bool>) -> [u64; 6] {
    // From the outermost scope inwards.
    let chain = |scope: ScopeId| {
        let mut chain = vec![&netlist.scopes()[scope.index()]];
        while let Some(parent) = chain[0].parent {
            chain.insert(0, &netlist.scopes()[parent.index()]);
        }
        chain
    };
    let set_up: &[&str] = if netlist.name() == "bump" {
        &["light", "half", "bump"]
    } else {
        &["setup"] // of all rivals
    };
    let (mut multipliers, mut adders, mut lookups) = (0, 0, 0);
    let (mut maps, mut dividers, mut roots) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
    for node in netlist.nodes() {
        let path = netlist.scope_path(node.scope);
        let is_set_up = path.first().is_some_and(|name| set_up.contains(name));
        if stage.is_some_and(|stage| stage != is_set_up) {
            continue;
        }
        let chain = chain(node.scope);
        // A dot product's operators belong to the datapath.
        let apart = |part: Option<Part>| part.is_some_and(|part| part != Part::Dot);
        let Some(depth) = chain.iter().position(|scope| apart(scope.part)) else {
            multipliers += u64::from(node.op == Op::Mul);
            adders += u64::from([Op::Add, Op::Sub, Op::AddSub].contains(&node.op));
            if let Op::Read { table, .. } = node.op {
                maps.insert(table);
            }
            continue;
        };
        // The unit itself is the first of the chain, but not part of the path.
        let name = path[..depth].join(".");
        match chain[depth].part.unwrap() {
            Part::Scheme => lookups += u64::from(matches!(node.op, Op::Read { .. })),
            Part::Divider => _ = dividers.insert(name),
            Part::SquareRoot => _ = roots.insert(name),
            Part::ReciprocalRoot | Part::Dot => {}
        }
    }
    let len = |set: &BTreeSet<String>| set.len() as u64;
    [multipliers, adders, lookups, maps.len() as u64, len(&dividers), len(&roots)]
}

/// The split into stages, with dividers and roots as one operator each.
#[test]
fn stages_recounted_node_by_node() {
    let inputs = Inputs { sampler: Sampler::Lit, samples: 100, seed: 1 };
    let comparison = compare(&[], &inputs, &|_, _| ()).unwrap();
    for row in &comparison.rows {
        let set: Vec<&str> = row.parameters.iter().map(String::as_str).collect();
        let design = design(row.unit, &set);
        let of = |stage| recounted(&design.netlist, stage);
        assert_eq!(row.set_up.counts(), of(Some(true)), "{}", row.name);
        let lit = (row.name != "peercy").then(|| of(Some(false)));
        assert_eq!(row.illumination.map(|counts| counts.counts()), lit, "{}", row.name);
        assert_eq!(row.whole.counts(), of(None), "{}", row.name);
    }
    let counts = |name: &str, stage| recounted(&design(name, &[]).netlist, Some(stage));
    assert_eq!(counts("peercy", true), [27, 18, 0, 0, 9, 3]);
    assert_eq!(counts("ernst", true), [27, 18, 0, 0, 9, 3]);
    assert_eq!(counts("ernst", false), [7, 6, 1, 0, 0, 0]);
}

#[test]
fn look_ups_are_the_same_in_every_scheme() {
    let inputs = Inputs { sampler: Sampler::Lit, samples: 100, seed: 1 };
    let of = |set: &[&str]| {
        let set: Vec<String> = set.iter().map(|&set| set.to_owned()).collect();
        let comparison = compare(&set, &inputs, &|_, _| ()).unwrap();
        let counts = comparison.rows.iter().map(|row| (row.set_up, row.illumination, row.whole));
        counts.collect::<Vec<_>>()
    };
    let direct = of(&[]);
    for set in
        [&["scheme=linear", "light_scheme=linear"][..], &["scheme=bipartite"], &["quarter_wave=on"]]
    {
        assert_eq!(of(set), direct, "{set:?}");
    }
}

mod commands {
    use crate::common::run;
    use std::fs;

    #[test]
    fn compare_tells_writes_and_refuses() {
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
        let (code, told, _) = run(&["compare", "--samples", "500", "--out", &file("t.md")]);
        assert_eq!(code, 0);
        for text in ["27 / 27", "1 - 6/27 = 77.8 %", "1 - 8/37 = 78.4 %", "exact-cartesian"] {
            assert!(told.contains(text), "{text}: {told}");
            assert!(fs::read_to_string(file("t.md")).unwrap().contains(text), "{text}");
        }
        let args = ["compare", "--samples", "500", "--json", "--out", &file("t.csv")];
        let (code, json, _) = run(&args);
        assert_eq!(code, 0);
        let json: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert_eq!(json["rows"][0]["set_up"]["dividers"], 9);
        assert_eq!(json["rows"][0]["illumination"], serde_json::Value::Null);
        let csv = fs::read_to_string(file("t.csv")).unwrap();
        let columns: Vec<usize> = csv.lines().map(|line| line.split(',').count()).collect();
        assert_eq!(columns.len(), 1 + 3 * 8);
        assert!(columns.iter().all(|count| *count == columns[0]), "{csv}");

        for (args, says) in [
            (&["compare", "-p", "nothing=1"][..], "no architecture has a parameter `nothing`"),
            (&["compare", "-p", "scheme=cubic"], "parameter `scheme` = `cubic`"),
            (&["compare", "-p", "scheme"], "is not of the form key=value"),
            (&["compare", "-p", "pipeline=printed"], "given twice"),
            (&["compare", "--out", "table.txt"], "ends in .md or .csv"),
            (&["compare", "--samples", "0"], "--samples"),
        ] {
            let (code, told, error) = run(args);
            assert_eq!((code, told.as_str()), (2, ""), "{args:?}: {error}");
            assert!(error.contains(says), "{args:?}: {error}");
        }
    }
}

/// The bounds of the Cartesian set-up hold for vectors of about unit length, and say so.
#[test]
fn bounds_of_the_set_up_name_the_vectors_that_they_hold_for() {
    let design = design("peercy", &[]);
    let check = BoundCheck::new(&design).unwrap();
    assert_eq!(
        check.inputs.as_deref(),
        Some("L and H in the texture frame, and N', from 1/2 to 2 long")
    );
    // L' along x from the frame's own axes, by its length in units of 2^-16.
    let one = 1i64 << 16;
    let off = |length: i64| {
        let l = [length, length / 3, 0];
        let frame = [[0, 0, one], [one, 0, 0], [0, one, 0], [0, 0, one]];
        let words: Vec<i64> = [l, l].into_iter().chain(frame).flatten().collect();
        let is = design.netlist.eval(&words).unwrap().0[design.netlist.outputs()[0].node.index()];
        let should = l[0] as f64 / (l[0] as f64).hypot(l[1] as f64);
        (is as f64 / one as f64 - should).abs()
    };
    let worst = |lengths: std::ops::Range<i64>| lengths.map(off).fold(0.0, f64::max);
    assert!(worst(one / 2..one / 2 + 300) <= check.stated[0].bound);
    assert!(worst(3..300) > check.stated[0].bound, "otherwise the bound would hold for all");
}
