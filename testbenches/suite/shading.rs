//! The illumination and bump units against matrices and the reflection formula.
//!
//! Everything here is written from the mathematics, with glam's matrices: only the units' ports are
//! used.

use crate::common::design;
use fixpath::measure::{Basis, BoundCheck, Inputs, Report, hard_verdicts, measure};
use fixpath::netlist::Netlist;
use fixpath::units::{Design, Golden, Sampler, Values};
use glam::{DMat3, DVec3};
use std::f64::consts::TAU;

use crate::engines::Random;

fn report(design: &Design, sampler: Sampler, samples: u64) -> Report {
    let inputs = Inputs { sampler, samples, seed: 5 };
    measure(&[design], &inputs, &|_| ()).unwrap().remove(0)
}

/// Value of a port from input words.
fn port(netlist: &Netlist, words: &[i64], name: &str) -> f64 {
    let at = (0..words.len()).find(|at| netlist.input_name(*at) == name);
    let at = at.unwrap_or_else(|| panic!("no port {name}"));
    netlist.node(netlist.inputs()[at]).format.value(words[at])
}

/// From +z: tilted about y, then turned about z.
fn direction(phi: f64, theta: f64) -> DVec3 {
    DMat3::from_rotation_z(phi * TAU) * DMat3::from_rotation_y(theta * TAU) * DVec3::Z
}

/// A vector of an input, in either form.
fn vector(netlist: &Netlist, words: &[i64], name: &str) -> DVec3 {
    let of = |part: String| port(netlist, words, &part);
    let has = |name: &str| (0..words.len()).any(|at| netlist.input_name(at) == name);
    if has(&format!("phi_{name}")) {
        direction(of(format!("phi_{name}")), of(format!("theta_{name}")))
    } else {
        DVec3::from(["x", "y", "z"].map(|axis| of(format!("{name}_{axis}"))))
    }
}

/// Intensity, diffuse and specular light for two dot products.
fn light(values: &Values, dot_l: f64, dot_h: f64) -> [f64; 3] {
    let diffuse = values.real("ambient") + values.real("diffuse") * dot_l.clamp(0.0, 1.0);
    let mut power = 1.0;
    for _ in 0..values.int("exponent").unwrap() {
        power *= dot_h.clamp(0.0, 1.0);
    }
    let specular = if dot_h > 0.0 { values.real("specular") * power } else { 0.0 };
    let diffuse = diffuse.min(1.0);
    [(diffuse + specular).min(1.0), diffuse, specular]
}

/// The dot products N'·L, N'·H of a bump unit's input, all in the world.
fn bump_dots(netlist: &Netlist, words: &[i64]) -> [f64; 2] {
    let turn = |name: &str| port(netlist, words, name) * TAU;
    let to_world = DMat3::from_rotation_z(turn("phi_n"))
        * DMat3::from_rotation_y(turn("theta_n"))
        * DMat3::from_rotation_z(turn("psi"));
    let perturbed = to_world * vector(netlist, words, "p");
    [vector(netlist, words, "l").dot(perturbed), vector(netlist, words, "h").dot(perturbed)]
}

fn illumination_dots(netlist: &Netlist, words: &[i64]) -> [f64; 2] {
    let p = vector(netlist, words, "p");
    [vector(netlist, words, "lt").dot(p), vector(netlist, words, "ht").dot(p)]
}

/// Random words; components have about unit length.
fn random_words(netlist: &Netlist, random: &mut Random) -> Vec<i64> {
    netlist
        .inputs()
        .iter()
        .map(|id| {
            let format = netlist.node(*id).format;
            let words = if format.is_signed() { format.words() / 3 } else { format.words() };
            let word = random.below(words as usize) as i64;
            if format.is_signed() { word - words as i64 / 2 } else { word }
        })
        .collect()
}

#[test]
fn goldens_are_the_matrices() {
    for (unit, key, variants, dots) in [
        (
            "illumination",
            "variant",
            &["corrected", "kim", "cartesian", "printed"][..],
            illumination_dots as fn(&Netlist, &[i64]) -> [f64; 2],
        ),
        ("bump", "pipeline", &["exact-polar", "exact-cartesian", "corrected"], bump_dots),
    ] {
        for variant in variants {
            for exponent in ["exponent=1", "exponent=50"] {
                let design = design(unit, &[&format!("{key}={variant}"), exponent]);
                let netlist = &design.netlist;
                let mut random = Random::new(3);
                let hard = design.hard.iter().flat_map(|case| case.words.clone()).step_by(7);
                let all: Vec<Vec<i64>> =
                    (0..300).map(|_| random_words(netlist, &mut random)).chain(hard).collect();
                for words in all {
                    let inputs: Vec<[f64; 1]> = netlist
                        .inputs()
                        .iter()
                        .zip(&words)
                        .map(|(id, word)| [netlist.node(*id).format.value(*word)])
                        .collect();
                    let inputs: Vec<&[f64]> = inputs.iter().map(|column| &column[..]).collect();
                    let mut golden = vec![vec![0.0]; design.golden_columns()];
                    design.golden.run(&inputs, &mut golden);
                    let [dot_l, dot_h] = dots(netlist, &words);
                    let [intensity, diffuse, specular] = light(&design.values, dot_l, dot_h);
                    let should = [intensity, diffuse, specular, dot_l, dot_h];
                    for (is, should) in golden.iter().zip(should) {
                        assert!((is[0] - should).abs() < 1e-12, "{variant} {words:?}: {golden:?}");
                    }
                }
            }
        }
    }
}

/// Errors of the methods themselves: only the equations as printed are wrong.
#[test]
fn only_the_printed_equations_are_wrong() {
    for variant in ["corrected", "kim", "cartesian"] {
        let design = design("illumination", &[&format!("variant={variant}")]);
        let report = report(&design, Sampler::Lit, 20_000);
        for quantity in ["dot_l", "dot_h", "diffuse", "specular"] {
            let max = report.figures(quantity, Basis::Algorithm).max;
            assert!(max < 1e-13, "{variant} {quantity}: {max:e}");
        }
    }
    // The printed form is cos cos - sin sin cos: off by twice the last term, up to 2.
    let printed = report(&design("illumination", &["variant=printed"]), Sampler::Sphere, 50_000);
    let dot = printed.figures("dot_l", Basis::Algorithm);
    assert!(dot.max > 1.5 && dot.mean > 0.3, "{dot:?}");
    let exact = design("bump", &["pipeline=exact-cartesian"]);
    let report = report(&exact, Sampler::Lit, 20_000);
    assert!(report.figures("dot_l", Basis::Algorithm).max < 1e-13);
}

#[test]
fn counts_are_those_of_the_seed() {
    let counts = |unit: &str, set: &[&str]| {
        let counts = design(unit, set).netlist.counts();
        (counts.datapath.multipliers, counts.datapath.adders, counts.reads)
    };
    // Section 4.2: 2 multipliers, 13 adders, 6 cosine tables and 2 light tables.
    assert_eq!(counts("illumination", &["variant=corrected"]), (2, 13, 8));
    assert_eq!(counts("illumination", &["variant=printed"]), (2, 13, 8));
    // Table 1 has 12 LUTs and 5 adders for Kim. Here sin and cos of theta' serve both products, and
    // the differences of azimuths take two adders.
    assert_eq!(counts("illumination", &["variant=kim"]), (6, 5, 10));
    assert_eq!(counts("illumination", &["variant=cartesian"]), (6, 5, 2));
    assert_eq!(counts("illumination", &["highlight=off"]), (1, 6, 4));
    // Two rotations of 3 multipliers and 8 adders, the rotation by psi, and the illumination.
    assert_eq!(counts("bump", &["pipeline=corrected"]).0, 8);
    assert_eq!(counts("bump", &["pipeline=corrected"]).1, 2 * 8 + 1 + 13);
    // Six for the dot products, four for the rotation by psi.
    assert_eq!(counts("bump", &["pipeline=exact-cartesian"]).0, 10);
}

#[test]
fn stated_bounds_hold() {
    let widths: [&[&str]; 6] = [
        &[],
        &["angle_bits=2", "frac_bits=2", "guard_bits=0", "table_addr_bits=2", "light_bits=2"],
        &["angle_bits=6", "frac_bits=6", "guard_bits=0", "table_addr_bits=4", "exponent=1"],
        &["angle_bits=12", "frac_bits=10", "rounding=floor", "exponent=255", "ambient=0"],
        &["scheme=linear", "light_scheme=linear", "frac_bits=18", "exponent=0"],
        &["scheme=bipartite", "light_scheme=bipartite", "diffuse=1", "ambient=1", "specular=1"],
    ];
    for (unit, variants) in [
        ("illumination", &["variant=corrected", "variant=kim", "variant=cartesian"][..]),
        (
            "bump",
            &[
                "pipeline=exact-polar",
                "pipeline=exact-cartesian",
                "conversion=cordic",
                "highlight=off",
            ],
        ),
    ] {
        for variant in variants {
            for widths in widths {
                let design = design(unit, &[&[*variant], widths].concat());
                let check = BoundCheck::new(&design).unwrap();
                assert!(check.stated.len() >= 3, "{variant}");
                for sampler in [Sampler::Sphere, Sampler::Hard] {
                    let report = report(&design, sampler, 4_000);
                    for bound in &check.stated {
                        let (seen, most) = (bound.seen(&report), bound.bound);
                        let what = &bound.quantity;
                        assert!(seen <= most, "{variant} {widths:?} {what}: {seen:e} > {most:e}");
                    }
                }
                for verdict in hard_verdicts(&design, &check) {
                    assert_eq!(verdict.holds, Some(true), "{variant} {widths:?}: {verdict:?}");
                }
            }
        }
    }
}

/// A bound that nothing can break would be useless.
#[test]
fn bounds_are_near_what_is_seen_and_break_for_a_wrong_golden() {
    for (unit, set, quantity, factor) in [
        ("illumination", &["variant=cartesian"][..], "dot", 1.01),
        ("illumination", &["scheme=linear"], "dot", 3.0),
        ("illumination", &["scheme=linear", "light_scheme=linear"], "diffuse", 4.0),
        ("illumination", &["scheme=linear", "light_scheme=linear"], "specular", 8.0),
        ("illumination", &["variant=cartesian"], "intensity", 1.2),
        ("bump", &["scheme=linear", "light_scheme=linear"], "specular", 16.0),
        ("bump", &["pipeline=exact-cartesian", "scheme=linear"], "dot", 8.0),
        ("bump", &["scheme=linear"], "dot", 4.0),
    ] {
        let mut design = design(unit, set);
        let check = BoundCheck::new(&design).unwrap();
        let bound = check.stated.iter().find(|bound| bound.quantity == quantity).unwrap();
        let seen = bound.seen(&report(&design, Sampler::Lit, 50_000));
        assert!(bound.bound <= factor * seen, "{unit} {set:?}: {:e} for {seen:e}", bound.bound);
        assert!(check.hold(&report(&design, Sampler::Lit, 2_000)));
        design.golden = Golden::new(|inputs, outputs| {
            for column in outputs {
                column.copy_from_slice(inputs[0]);
            }
        });
        assert!(!check.hold(&report(&design, Sampler::Lit, 2_000)), "{unit}");
    }
}

/// The light saturates: a dot product above 1 or a sum above 1 doesn't wrap to darkness.
#[test]
fn light_saturates() {
    let design = design(
        "illumination",
        &[
            "variant=cartesian",
            "ambient=1",
            "diffuse=1",
            "specular=1",
            "exponent=2",
            "light_scheme=linear",
        ],
    );
    let netlist = &design.netlist;
    let format = netlist.node(netlist.inputs()[0]).format;
    for word in [1 << 16, format.max_raw()] {
        // L = H = N' = (0, 0, word): dot products of 1 and of nearly 4.
        let (words, _) = netlist.eval(&[0, 0, word, 0, 0, word, 0, 0, word]).unwrap();
        for output in netlist.outputs() {
            let light = words[output.node.index()];
            assert!((65534..=65535).contains(&light), "{} {word}: {light}", output.name);
        }
    }
    // From behind there is only ambient light, which is 1 here.
    let (words, _) = netlist.eval(&[0, 0, -(1 << 16), 0, 0, -(1 << 16), 0, 0, 1 << 16]).unwrap();
    let ports: Vec<i64> = netlist.outputs().iter().map(|o| words[o.node.index()]).collect();
    assert_eq!(ports, [(1 << 16) - 1, (1 << 16) - 1, 0]);
}

/// A rounded dot product exceeds 1, so the guard bit is needed (8-bit angles, 10 fraction bits).
#[test]
fn dot_products_pass_one() {
    let set = ["angle_bits=8", "table_addr_bits=8", "frac_bits=10", "guard_bits=0"];
    let design = design("illumination", &set);
    let netlist = &design.netlist;
    let dot = netlist.ids().find(|id| netlist.label(*id) == "dot_l").unwrap();
    let mut most = 0;
    for theta in 0..256 {
        for tilt in 0..256 {
            let (words, _) = netlist.eval(&[0, theta, 0, 0, 0, tilt]).unwrap();
            most = most.max(words[dot.index()]);
        }
    }
    assert!((1024..1030).contains(&most), "{most}");
}

/// Designs with other exponents share no golden.
#[test]
fn designs_with_other_light_have_their_own_golden() {
    let designs = [design("bump", &["exponent=1"]), design("bump", &["exponent=200"])];
    let inputs = Inputs { sampler: Sampler::Lit, samples: 5_000, seed: 1 };
    let together = measure(&[&designs[0], &designs[1]], &inputs, &|_| ()).unwrap();
    for (design, together) in designs.iter().zip(together) {
        let alone = measure(&[design], &inputs, &|_| ()).unwrap().remove(0);
        assert_eq!(alone.figures, together.figures);
    }
}

/// In the middle of a highlight the dot product is 1. There the light must follow the formula, for
/// tables of any size and scheme.
#[test]
fn light_in_the_middle_of_a_highlight_is_the_formula_s() {
    let one = 1i64 << 16;
    let [x, y, z] = [[one, 0, 0], [0, one, 0], [0, 0, one]];
    let units: [(&str, &[&str], Vec<i64>); 5] = [
        ("illumination", &["variant=cartesian"], [x, x, x].concat()),
        ("illumination", &["scheme=linear"], vec![7, 9, 7, 9, 7, 9]),
        // Angles of 0: all vectors along z.
        ("bump", &["scheme=linear"], vec![0; 9]),
        ("kim", &["scheme=linear"], vec![0; 9]),
        // L = H = N = x, T = y, B = z: L' is along z, as is N'.
        ("ernst", &[], [x, x, x, y, z, z].concat()),
    ];
    for (unit, set, words) in units {
        for light in ["light_scheme=direct", "light_scheme=linear", "light_scheme=bipartite"] {
            for size in ["specular_addr_bits=4", "specular_addr_bits=12"] {
                let more = [light, size, "exponent=255", "specular=0.9"];
                let design = design(unit, &[set, &more].concat());
                let (values, _) = design.netlist.eval(&words).unwrap();
                let outputs = design.netlist.outputs();
                let port = |name: &str| outputs.iter().find(|output| output.name == name).unwrap();
                let light = |name: &str| values[port(name).node.index()];
                // 0.9 and 0.1 + 0.6 times 2^16.
                assert_eq!(light("specular"), 58982, "{unit} {more:?}");
                if unit != "ernst" {
                    // `ernst` computes a product of rounded factors.
                    assert_eq!(light("diffuse"), 45875, "{unit} {more:?}");
                }
            }
        }
    }
}
