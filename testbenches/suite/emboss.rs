//! The emboss family against a plain model of both published schemes, written here from the
//! publications.

use crate::common::{Vector, cross, design, dot};
use fixpath::format::float20;
use fixpath::measure::{Basis, BoundCheck, Inputs, hard_verdicts, measure, sample_words};
use fixpath::netlist::{Netlist, Part, Quantity};
use fixpath::op::Op;
use fixpath::units::{Design, Sampler};

fn unit(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    if length == 0.0 { [0.0; 3] } else { v.map(|x| x / length) }
}

/// Values of named input ports.
struct Ports<'a> {
    netlist: &'a Netlist,
    values: Vec<f64>,
}

impl<'a> Ports<'a> {
    fn new(netlist: &'a Netlist, words: &[i64]) -> Self {
        let ids = netlist.inputs().iter().zip(words);
        Self { netlist, values: ids.map(|(id, w)| netlist.node(*id).format.value(*w)).collect() }
    }

    fn get(&self, name: &str) -> f64 {
        let port = (0..self.values.len()).find(|port| self.netlist.input_name(*port) == name);
        self.values[port.unwrap_or_else(|| panic!("no port {name}"))]
    }

    fn vector(&self, name: &str) -> Vector {
        ["x", "y", "z"].map(|axis| self.get(&format!("{name}_{axis}")))
    }
}

/// ds, dt, s1, t1, degenerate of US 6,980,218 and 7,307,640, at coordinates that don't saturate.
fn gx(ports: &Ports<'_>) -> Vec<f64> {
    let rows = ["m0", "m1", "m2"].map(|row| ports.vector(row));
    let [t, b] = ["tangent", "binormal"].map(|v| rows.map(|row| dot(row, ports.vector(v))));
    let (light, vertex) = (ports.vector("light"), ports.vector("vertex"));
    let l = [0, 1, 2].map(|i| light[i] - vertex[i]);
    let degenerate = f64::from(u8::from(l == [0.0; 3]));
    let (ds, dt) = (dot(t, unit(l)), dot(b, unit(l)));
    vec![ds, dt, ports.get("s0") + ds, ports.get("t0") + dt, degenerate]
}

/// Es - PCTs, Et - PCTt, Es, Et, degenerate, Eq, Er of GL_NV_texgen_emboss.
fn nv(ports: &Ports<'_>, ks: f64, kt: f64) -> Vec<f64> {
    let (n, ct) = (ports.vector("normal"), unit(ports.vector("ct")));
    // Exact, so that parallel vectors are detected.
    let parallel = cross(n, ports.vector("ct")) == [0.0; 3];
    let bn = if parallel { [0.0; 3] } else { unit(cross(n, ct)) };
    let t = cross(bn, n);
    let (light, vertex) = (ports.vector("light"), ports.vector("vertex"));
    let l = [0, 1, 2].map(|i| light[i] - vertex[i]);
    let degenerate = f64::from(u8::from(l == [0.0; 3] || parallel));
    let (q, l) = (ports.get("q0"), unit(l));
    let (ds, dt) = (ks * dot(l, bn) * q, -kt * dot(l, t) * q);
    let (s, t) = (ports.get("s0") + ds, ports.get("t0") + dt);
    vec![ds, dt, s, t, degenerate, q, ports.get("r0")]
}

/// Words of every port: hard cases and random ones.
fn samples(design: &Design, random: u64) -> Vec<Vec<i64>> {
    let inputs = Inputs { sampler: Sampler::Lit, samples: random, seed: 11 };
    let mut words = sample_words(design, &inputs).unwrap();
    words.extend(design.hard.iter().flat_map(|case| case.words.clone()));
    words
}

fn golden(design: &Design, ports: &Ports<'_>) -> Vec<f64> {
    let columns: Vec<[f64; 1]> = ports.values.iter().map(|value| [*value]).collect();
    let slices: Vec<&[f64]> = columns.iter().map(|column| &column[..]).collect();
    let mut golden = vec![vec![0.0]; design.golden_columns()];
    design.golden.run(&slices, &mut golden);
    golden.iter().map(|column| column[0]).collect()
}

#[test]
fn goldens_are_those_of_the_seeds() {
    for (set, model) in [
        (&[][..], gx as fn(&Ports<'_>) -> Vec<f64>),
        (&["setting=nv"][..], |ports| nv(ports, 1.0, 1.0)),
        (&["setting=nv", "ks=0.5", "kt=-0.25"], |ports| nv(ports, 0.5, -0.25)),
        (&["setting=nv", "ks=4", "kt=-300.5"], |ports| nv(ports, 4.0, -300.5)),
        (&["setting=nv", "constants=ports"], |ports| nv(ports, ports.get("ks"), ports.get("kt"))),
    ] {
        let design = design("emboss", set);
        for words in samples(&design, 20_000) {
            let ports = Ports::new(&design.netlist, &words);
            let mut should = model(&ports);
            // Coordinates are clamped to the range of their words.
            let (low, high) = (-64.0, 64.0 - 2f64.powi(-18));
            should[2..4].iter_mut().for_each(|x| *x = x.clamp(low, high));
            for (is, should) in golden(&design, &ports).iter().zip(should) {
                assert!((is - should).abs() < 1e-9, "{set:?} {words:?}: {is} for {should}");
            }
        }
    }
}

/// Fixed words against the model of this file, with T different from B: s and t aren't exchanged.
#[test]
fn s_goes_with_the_tangent_and_t_with_the_binormal() {
    let one = |set: &[&str], l: Vector| {
        let design = design("emboss", set);
        let netlist = &design.netlist;
        let frame = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let value = |name: &str| -> f64 {
            let axis = ["x", "y", "z"].iter().position(|axis| name.ends_with(&format!("_{axis}")));
            match (name.split('_').next().unwrap(), axis) {
                ("m0" | "tangent" | "normal", Some(axis)) => frame[0][axis],
                ("m1" | "binormal" | "ct", Some(axis)) => frame[1][axis],
                ("m2", Some(axis)) => frame[2][axis],
                ("light", Some(axis)) => l[axis],
                ("q0", None) => 1.0,
                _ => 0.0,
            }
        };
        let ports = (0..netlist.inputs().len()).map(|port| value(netlist.input_name(port)));
        let words: Vec<i64> = netlist
            .inputs()
            .iter()
            .zip(ports)
            .map(|(id, x)| (x / netlist.node(*id).format.ulp()) as i64)
            .collect();
        let all = netlist.eval(&words).unwrap().0;
        [0, 1].map(|port| {
            let id = netlist.outputs()[port].node;
            (netlist.node(id).format.value(all[id.index()]) * 1000.0).round() / 1000.0
        })
    };
    let (l, given) = ([3.0, 4.0, 0.0], "frame=given");
    assert_eq!(one(&[], l), [0.6, 0.8]);
    assert_eq!(one(&["s_vector=binormal"], l), [0.8, 0.6]);
    assert_eq!(one(&["l_sign=vertex-light"], l), [-0.6, -0.8]);
    assert_eq!(one(&["t_sign=minus"], l), [0.6, -0.8]);
    assert_eq!(one(&[given, "constants=parameters", "ks=0.5", "kt=-0.25"], l), [0.3, -0.2]);
    // A small constant keeps its fraction bits next to a large one.
    let far_apart = ["ks=30000", "kt=0.005"];
    assert_eq!(one(&[given, "constants=parameters", far_apart[0], far_apart[1]], l)[1], 0.004);
    // N = x, CT = y: BN = z, T = BN x N = y.
    assert_eq!(one(&["setting=nv"], [0.0, 3.0, 4.0]), [0.8, -0.6]);
    assert_eq!(
        one(&["setting=nv", "t_sign=plus", "s_vector=tangent"], [0.0, 3.0, 4.0]),
        [0.6, 0.8]
    );
    assert_eq!(one(&["setting=nv", given], l), [0.8, -0.6]);
}

const SETS: &[(&str, &[&str])] = &[
    ("dot", &[]),
    (
        "dot",
        &["v_bits=2", "v_frac_bits=0", "w_bits=2", "w_frac_bits=2", "out_bits=2", "rounding=floor"],
    ),
    ("dot", &["v_bits=26", "w_bits=26", "out_bits=63", "out_frac_bits=20", "overflow=symmetric"]),
    ("normalise", &[]),
    ("normalise", &["v_bits=2", "norm_bits=2", "v_frac_bits=0"]),
    ("normalise", &["v_bits=32", "norm_bits=7", "rounding=floor"]),
    ("normalise", &["v_bits=20", "norm_bits=24", "rounding=half-even"]),
    ("rsqrt", &[]),
    ("rsqrt", &["root_scheme=direct", "root_frac_bits=10", "rounding=floor"]),
    ("rsqrt", &["input_frac_bits=8", "input_bits=21", "root_int_bits=5"]),
    ("rsqrt", &["root_scheme=newton", "root_addr_bits=6"]),
    ("rsqrt", &["root_scheme=newton", "root_addr_bits=2", "root_frac_bits=2", "input_bits=2"]),
    ("rsqrt", &["root_scheme=newton", "root_addr_bits=11", "root_frac_bits=22", "input_bits=32"]),
    ("rsqrt", &["root_int_bits=1", "rounding=toward-zero", "input_bits=9", "input_frac_bits=9"]),
    ("cross_product", &[]),
    (
        "cross_product",
        &[
            "v_bits=3",
            "w_bits=2",
            "v_frac_bits=1",
            "w_frac_bits=0",
            "out_bits=4",
            "out_frac_bits=0",
        ],
    ),
    ("cross_product", &["v_bits=26", "w_bits=26", "out_bits=40", "out_frac_bits=26"]),
    ("basis", &[]),
    (
        "basis",
        &[
            "component_bits=2",
            "norm_bits=2",
            "dot_frac_bits=2",
            "root_frac_bits=2",
            "root_addr_bits=2",
        ],
    ),
    (
        "basis",
        &[
            "component_bits=24",
            "guard_bits=0",
            "norm_bits=24",
            "dot_frac_bits=24",
            "root_frac_bits=22",
            "root_addr_bits=12",
        ],
    ),
    ("basis", &["root_scheme=newton", "guard_bits=3", "rounding=floor"]),
    ("emboss", &[]),
    ("emboss", &["root_scheme=newton", "root_addr_bits=7", "rounding=half-even"]),
    ("emboss", &["root_scheme=direct", "rounding=floor", "s_vector=binormal", "t_sign=minus"]),
    ("emboss", &["normalise_basis=on", "l_sign=vertex-light"]),
    ("emboss", &["frame=given", "scale_q=on"]),
    ("emboss", &["frame=given", "constants=ports", "normalise_basis=on", "overflow=symmetric"]),
    ("emboss", &["frame=normal", "rounding=toward-zero"]),
    ("emboss", &["setting=nv"]),
    ("emboss", &["setting=nv", "root_scheme=newton", "constants=ports"]),
    ("emboss", &["setting=nv", "normalise_basis=off", "texture_int_bits=1"]),
    ("emboss", &["setting=nv", "constants=off", "rounding=floor", "overflow=wrap", "ks=0.3"]),
    ("emboss", &["setting=nv", "ks=0.00390625", "kt=0.0078125", "input20=on"]),
    ("emboss", &["setting=nv", "ks=4", "kt=-3.3"]),
    ("emboss", &["setting=nv", "ks=1234.567", "kt=-65536"]),
    ("emboss", &["setting=nv", "constants=ports", "constant_int_bits=4", "constant_frac_bits=16"]),
    // The least and the greatest widths.
    (
        "emboss",
        &[
            "component_bits=2",
            "matrix_bits=2",
            "matrix_int_bits=0",
            "position_bits=2",
            "position_frac_bits=0",
            "guard_bits=0",
            "norm_bits=2",
            "dot_frac_bits=2",
            "root_addr_bits=2",
            "root_frac_bits=2",
            "texture_int_bits=0",
            "texture_frac_bits=2",
            "constant_frac_bits=2",
        ],
    ),
    (
        "emboss",
        &[
            "setting=nv",
            "component_bits=2",
            "position_bits=2",
            "position_frac_bits=0",
            "guard_bits=0",
            "norm_bits=2",
            "dot_frac_bits=2",
            "root_addr_bits=2",
            "root_frac_bits=2",
            "texture_int_bits=0",
            "texture_frac_bits=2",
            "constant_frac_bits=2",
        ],
    ),
    (
        "emboss",
        &[
            "component_bits=24",
            "matrix_bits=24",
            "matrix_int_bits=2",
            "position_bits=30",
            "position_frac_bits=17",
            "guard_bits=2",
            "norm_bits=24",
            "dot_frac_bits=24",
            "root_addr_bits=12",
            "root_frac_bits=22",
            "texture_int_bits=8",
            "texture_frac_bits=24",
        ],
    ),
];

/// Every stated bound holds over the hard list and random inputs, and no method has an error of its
/// own.
#[test]
fn bounds_hold_at_every_width_and_switch() {
    for (name, set) in SETS {
        let design = design(name, set);
        let bounds = BoundCheck::new(&design).unwrap();
        assert!(!bounds.stated.is_empty(), "{name} {set:?}: {:?}", bounds.why_none);
        for sampler in [Sampler::Lit, Sampler::Hard] {
            let inputs = Inputs { sampler, samples: 40_000, seed: 5 };
            let report = &measure(&[&design], &inputs, &|_| ()).unwrap()[0];
            assert!(bounds.hold(report), "{name} {set:?} {sampler:?}: {:#?}", {
                let seen: Vec<f64> = bounds.stated.iter().map(|bound| bound.seen(report)).collect();
                (seen, &bounds.stated)
            });
        }
        for verdict in hard_verdicts(&design, &bounds) {
            assert_eq!(verdict.holds, Some(true), "{name} {set:?}: {verdict:?}");
        }
    }
}

/// On reals the netlists equal the goldens: there is no algorithm error. Words are clamped to their
/// range, reals aren't.
#[test]
fn netlists_on_reals_are_the_goldens() {
    for (name, set) in [
        ("dot", &[][..]),
        ("normalise", &[]),
        ("rsqrt", &["root_int_bits=17"]),
        ("rsqrt", &["root_scheme=newton", "root_int_bits=17"]),
        ("cross_product", &[]),
        ("basis", &[]),
        ("emboss", &[]),
        ("emboss", &["normalise_basis=on"]),
        ("emboss", &["setting=nv"]),
        ("emboss", &["setting=nv", "normalise_basis=off", "constants=ports"]),
    ] {
        let design = design(name, set);
        for sampler in [Sampler::Lit, Sampler::Hard] {
            let inputs = Inputs { sampler, samples: 20_000, seed: 3 };
            let report = &measure(&[&design], &inputs, &|_| ()).unwrap()[0];
            for figures in report.figures.iter().filter(|f| f.basis == Basis::Algorithm) {
                let quantity = figures.quantity.as_str();
                // Words that saturate differ from reals. dot and cross never saturate here,
                // coordinates only in the hard list.
                if sampler == Sampler::Hard && ["s1", "t1"].contains(&quantity) {
                    continue;
                }
                assert!(figures.max < 1e-10, "{name} {set:?}: {quantity} {}", figures.max);
            }
        }
    }
}

/// The target is 2^-13 of the displacement's scale, |T_e| or |B_e|. It applies at the defaults,
/// with 16-bit components, over a million vertices with lights 2^-6 to 2^10 away, and over the hard
/// list.
#[test]
fn displacements_are_within_the_target_at_the_defaults() {
    for setting in ["setting=gx", "setting=nv"] {
        let design = design("emboss", &[setting]);
        let bounds = BoundCheck::new(&design).unwrap();
        for sampler in [Sampler::Lit, Sampler::Hard] {
            let inputs = Inputs { sampler, samples: 1_000_000, seed: 1 };
            let report = &measure(&[&design], &inputs, &|_| ()).unwrap()[0];
            assert!(bounds.hold(report), "{setting} {sampler:?}");
            for quantity in ["ds_relative", "dt_relative"] {
                let seen = report.figures(quantity, Basis::Total).max;
                assert!(seen <= 2f64.powi(-13), "{setting} {sampler:?} {quantity}: {seen}");
            }
        }
        // The bound promises it too.
        let relative =
            bounds.stated.iter().find(|bound| bound.of.iter().any(|of| of == "ds_relative"));
        assert!(relative.unwrap().bound <= 2f64.powi(-13), "{setting}");
    }
}

/// The same at each distance separately, so that no distance hides behind the others.
#[test]
fn near_lights_are_no_worse_than_far_ones() {
    let design = design("emboss", &[]);
    let netlist = &design.netlist;
    let lsb = 2f64.powi(-15);
    let mut worst = vec![0.0f64; 17];
    for (row, words) in samples(&design, 60_000).iter().take(60_000).enumerate() {
        // The light is moved to a chosen distance.
        let octave = row % 17;
        let distance = 2f64.powi(octave as i32 - 6);
        let ports = Ports::new(netlist, words);
        let (light, vertex) = (ports.vector("light"), ports.vector("vertex"));
        let direction = unit([0, 1, 2].map(|i| light[i] - vertex[i]));
        let mut words = words.clone();
        let first = (0..words.len()).find(|port| netlist.input_name(*port) == "light_x").unwrap();
        for axis in 0..3 {
            let value = vertex[axis] + direction[axis] * distance;
            words[first + axis] = (value / lsb).round() as i64;
        }
        let ports = Ports::new(netlist, &words);
        let should = gx(&ports);
        let all = netlist.eval(&words).unwrap().0;
        let rows = ["m0", "m1", "m2"].map(|row| ports.vector(row));
        for (port, v) in ["tangent", "binormal"].iter().enumerate() {
            let eye = rows.map(|row| dot(row, ports.vector(v)));
            let id = netlist.outputs()[port].node;
            let is = netlist.node(id).format.value(all[id.index()]);
            let error = (is - should[port]).abs() / dot(eye, eye).sqrt();
            worst[octave] = worst[octave].max(error);
        }
    }
    assert!(worst.iter().all(|error| *error < 2f64.powi(-13)), "{worst:?}");
}

/// Floats of 20 bits: computed arithmetically from the value here, from the bits of an `f32` there.
#[test]
fn inputs_of_20_bits_keep_12_significant_bits() {
    let cut = |x: f64| {
        if x == 0.0 {
            return 0.0;
        }
        let ulp = 2f64.powi(x.abs().log2().floor() as i32 - 11);
        (x / ulp).trunc() * ulp
    };
    let mut state = 1u64;
    for _ in 0..100_000 {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let x = f64::from((state >> 32) as u32 as i32) * 2f64.powi(-((state >> 8) as i32 & 31));
        let x = f64::from(x as f32);
        assert_eq!(float20(x), cut(x), "{x}");
    }
    assert_eq!((float20(1.0), float20(-4095.9), float20(0.0)), (1.0, -4095.0, 0.0));

    // Only words of light and matrix are limited to 12 significant bits.
    let design = design("emboss", &["input20=on"]);
    let netlist = &design.netlist;
    let inputs = Inputs { sampler: Sampler::Lit, samples: 2000, seed: 2 };
    let mut others = false;
    for words in sample_words(&design, &inputs).unwrap() {
        for (port, (id, word)) in netlist.inputs().iter().zip(&words).enumerate() {
            let name = netlist.input_name(port);
            let short = name.starts_with("light") || name.starts_with('m');
            let quantity = netlist.node(*id).quantity;
            assert_eq!(quantity == Quantity::Float20, short, "{name}");
            let significant = 64
                - word.unsigned_abs().leading_zeros() as i64
                - i64::from(word.trailing_zeros().min(63));
            // Rounding the word itself may carry into a thirteenth bit.
            assert!(!short || significant <= 12, "{name} {word}");
            others |= !short && significant > 12;
        }
    }
    assert!(others);
    // The cost of the short floats shows only in the end-to-end error.
    let plain = self::design("emboss", &[]);
    let inputs = Inputs { sampler: Sampler::Lit, samples: 40_000, seed: 2 };
    let reports = measure(&[&plain, &design], &inputs, &|_| ()).unwrap();
    let mean = |report: usize, basis| reports[report].figures("ds_relative", basis).mean;
    assert!(mean(1, Basis::EndToEnd) > 4.0 * mean(0, Basis::EndToEnd));
    assert!(mean(1, Basis::Total) < 1.5 * mean(0, Basis::Total));
    // Lights next to far vertices are lost. Quantiles of errors of hundreds of texels are reported,
    // too.
    let texels = reports[1].figures("ds_texels", Basis::EndToEnd);
    assert!(texels.p999 > 100.0 && texels.p999 <= texels.max, "{texels:?}");
}

/// The structure that schedules share: nine dot products, three differences, one reciprocal root,
/// one product and one sum for each of s and t.
#[test]
fn gx_is_made_of_the_parts_that_the_patent_draws() {
    let design = design("emboss", &[]);
    let netlist = &design.netlist;
    let parts = |part| -> Vec<String> {
        let of = netlist.scopes().iter().filter(|scope| scope.part == Some(part));
        of.map(|scope| scope.name.clone()).collect()
    };
    let dots = ["t_x", "t_y", "t_z", "b_x", "b_y", "b_z", "t_dot_l", "l_dot_l", "b_dot_l"];
    assert_eq!(parts(Part::Dot), dots);
    assert_eq!(parts(Part::ReciprocalRoot).len(), 1);
    for (at, scope) in netlist.scopes().iter().enumerate() {
        let ops: Vec<Op> = netlist
            .nodes()
            .iter()
            .filter(|node| node.scope.index() == at)
            .map(|node| node.op)
            .collect();
        if scope.part == Some(Part::Dot) {
            assert_eq!(ops, [Op::Mul, Op::Mul, Op::Mul, Op::Add, Op::Add], "{}", scope.name);
        } else if at == 0 {
            let count = |op: Op| ops.iter().filter(|known| **known == op).count();
            assert_eq!([Op::Sub, Op::Mul, Op::Add].map(count), [3, 2, 2]);
        }
    }
    let named = |name: &str| netlist.ids().find(|id| netlist.label(*id) == name).unwrap();
    for name in ["l_x", "l_y", "l_z"] {
        assert_eq!(netlist.node(named(name)).op, Op::Sub);
    }
    let counts = netlist.counts();
    assert_eq!((counts.datapath.multipliers, counts.reciprocal_roots), (29, 1));
}

/// Out-of-range coordinates are counted, and wrap or saturate.
#[test]
fn coordinates_saturate_or_wrap() {
    for (overflow, should) in [("saturate", 64.0 - 2f64.powi(-18)), ("wrap", -63.5)] {
        let design = design("emboss", &[&format!("overflow={overflow}")]);
        let netlist = &design.netlist;
        let words: Vec<i64> = (0..netlist.inputs().len())
            .map(|port| match netlist.input_name(port) {
                "m0_x" => 1 << 13,
                "tangent_x" => 1 << 14,
                "light_x" => 1 << 20,
                "s0" => (64 << 18) - (1 << 17),
                _ => 0,
            })
            .collect();
        let (all, overflowed) = netlist.eval(&words).unwrap();
        let s1 = netlist.outputs().iter().find(|output| output.name == "s1").unwrap().node;
        let is = netlist.node(s1).format.value(all[s1.index()]);
        assert!((is - should).abs() < 1e-4, "{overflow}: {is}");
        assert!(overflowed[s1.index()]);
    }
}

/// A sweep is ranked by the error in texels; if points differ in their input words, it is ranked
/// end to end.
#[test]
fn sweeps_are_in_texels_and_see_what_inputs_are() {
    let folder = tempfile::tempdir().unwrap();
    let sweep = |name: &str, axes: &[&str]| {
        let out = folder.path().join(name);
        let mut command = crate::common::fixpath();
        command.args(["sweep", "emboss", "--samples", "3000", "--out"]).arg(&out);
        for axis in axes {
            command.args(["--axis", axis]);
        }
        let output = command.output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let csv = std::fs::read_to_string(out.join("sweep.csv")).unwrap();
        assert!(
            csv.contains("ds_texels_total_max_texel") && csv.contains("ds_relative_total_max_rel")
        );
        assert!(csv.contains("ds_texels_total_witness"));
        String::from_utf8(output.stdout).unwrap()
    };
    let told = sweep("roots", &["root_scheme=direct,newton", "root_addr_bits=4,8"]);
    assert!(told.contains("ds_texels (total error)"), "{told}");
    for axis in ["input20=off,on", "position_frac_bits=10,15", "component_bits=12,16"] {
        let told = sweep(axis, &[axis]);
        assert!(told.contains("ds_texels (end-to-end error)"), "{told}");
    }
}

/// For results below 1 the last rounding is a larger part of the result, and the relative bound
/// accounts for it.
#[test]
fn relative_errors_of_small_results_are_relative() {
    let design = design("rsqrt", &["input_frac_bits=8", "input_bits=21", "root_int_bits=5"]);
    let bounds = BoundCheck::new(&design).unwrap();
    let bound = |of: &str| {
        let on = |bound: &&fixpath::measure::StatedBound| bound.of.iter().any(|name| name == of);
        bounds.stated.iter().find(on).unwrap()
    };
    let r = design.netlist.outputs()[0].node.index();
    let off = |word: i64| {
        let (is, should) =
            (design.netlist.eval(&[word]).unwrap().0[r], (256.0 / word as f64).sqrt());
        (is as f64 / f64::from(1 << 18) - should).abs() / should
    };
    // a = 7668.8125
    let word = 7668 * 256 + 208;
    assert!(off(word) > 1e-4 && bound("r_scaled").bound < 2e-5);
    // Large input words give small results.
    let worst = ((1i64 << 21) - 60_000..1 << 21).map(off).fold(0.0, f64::max);
    let stated = bound("r_relative").bound;
    assert!(worst <= stated && stated <= 2.0 * worst, "{worst:e} {stated:e}");
    assert_eq!(bound("r_relative").over.as_deref(), Some("the result"));
    assert_eq!(bound("r_scaled").over.as_deref(), Some("the result, at least 1"));
    assert_eq!(bound("r").over, None);
}
