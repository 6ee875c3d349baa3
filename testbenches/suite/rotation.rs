//! The rotation unit against rotation matrices, and its variants against the paper's equations.
//!
//! Everything here is written from the mathematics: only the unit's ports are used.

use fixpath::measure::{Basis, BoundCheck, Inputs, Report, measure};
use fixpath::netlist::{Netlist, Quantity};
use fixpath::sim::batch::Program;
use fixpath::units::{Bounds, Design, Golden, Sampler, Shape, Unit};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::engines::Random;

type Vector = [f64; 3];
type Matrix = [Vector; 3];

fn design(assignments: &[&str]) -> Design {
    crate::common::design("rotation", assignments)
}

fn times(m: Matrix, v: Vector) -> Vector {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

/// Right-handed rotation about z.
fn about_z(turns: f64) -> Matrix {
    let (s, c) = (turns * TAU).sin_cos();
    [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]
}

/// Right-handed rotation about y.
fn about_y(turns: f64) -> Matrix {
    let (s, c) = (turns * TAU).sin_cos();
    [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]]
}

fn vector(phi: f64, theta: f64) -> Vector {
    // From +z: tilted about y, then turned about z.
    times(about_z(phi), times(about_y(theta), [0.0, 0.0, 1.0]))
}

/// A turned by -phi_n about z, then by -theta_n about y.
fn matrix_golden([phi_a, theta_a, phi_n, theta_n]: [f64; 4]) -> Vector {
    times(about_y(-theta_n), times(about_z(-phi_n), vector(phi_a, theta_a)))
}

/// Port values of input words.
fn turns_of(netlist: &Netlist, words: &[i64]) -> [f64; 4] {
    let mut turns = [0.0; 4];
    for ((turns, id), word) in turns.iter_mut().zip(netlist.inputs()).zip(words) {
        assert_eq!(netlist.node(*id).quantity, Quantity::Turns);
        *turns = *word as f64 / 2f64.powi(netlist.node(*id).format.frac_bits());
    }
    turns
}

/// The unit's golden on one input.
fn unit_golden(design: &Design, turns: [f64; 4]) -> Vector {
    let columns: Vec<[f64; 1]> = turns.iter().map(|turns| [*turns]).collect();
    let inputs: Vec<&[f64]> = columns.iter().map(|column| &column[..]).collect();
    let mut outputs = vec![vec![0.0]; 3];
    design.golden.run(&inputs, &mut outputs);
    [outputs[0][0], outputs[1][0], outputs[2][0]]
}

/// Random input words for a design, followed by every hard case.
fn words(design: &Design, seed: u64, count: usize) -> Vec<Vec<i64>> {
    let mut random = Random::new(seed);
    let netlist = &design.netlist;
    let formats: Vec<_> = netlist.inputs().iter().map(|id| netlist.node(*id).format).collect();
    let mut words: Vec<Vec<i64>> = (0..count)
        .map(|_| formats.iter().map(|f| f.wrap(random.bits() as i64)).collect())
        .collect();
    assert!(design.hard.len() >= 10);
    for case in &design.hard {
        assert!(!case.words.is_empty(), "{}", case.name);
        words.extend(case.words.iter().cloned());
    }
    words
}

/// Output words of samples, by the batch engine.
fn run(netlist: &Netlist, samples: &[Vec<i64>]) -> Vec<Vec<i64>> {
    let ports: Vec<_> = netlist.outputs().iter().map(|output| output.node).collect();
    let program = Program::compile(netlist, &ports);
    let columns: Vec<Vec<i64>> =
        (0..netlist.inputs().len()).map(|i| samples.iter().map(|s| s[i]).collect()).collect();
    let views: Vec<&[i64]> = columns.iter().map(Vec::as_slice).collect();
    let mut outputs = vec![Vec::new(); ports.len()];
    program.runner().run(&program, &views, &mut outputs).unwrap();
    outputs
}

fn angle_between(u: Vector, v: Vector) -> f64 {
    // Kahan's formula: accurate for small and for large angles.
    let length = |v: Vector| (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    let (lu, lv) = (length(u), length(v));
    let difference: Vec<f64> = (0..3).map(|i| u[i] * lv - v[i] * lu).collect();
    let sum: Vec<f64> = (0..3).map(|i| u[i] * lv + v[i] * lu).collect();
    2.0 * length([difference[0], difference[1], difference[2]])
        .atan2(length([sum[0], sum[1], sum[2]]))
}

#[test]
fn conventions_of_the_matrices() {
    let close = |a: Vector, b: Vector| (0..3).all(|i| (a[i] - b[i]).abs() < 1e-15);
    assert!(close(vector(0.0, 0.25), [1.0, 0.0, 0.0]), "theta is from +z");
    assert!(close(vector(0.25, 0.25), [0.0, 1.0, 0.0]), "phi is from +x to +y");
    // In the frame of its own normal, every direction is +z.
    for (phi, theta) in [(0.1, 0.2), (0.9, 0.45), (0.5, 0.0)] {
        assert!(close(matrix_golden([phi, theta, phi, theta]), [0.0, 0.0, 1.0]));
    }
    assert!((angle_between([1.0, 0.0, 0.0], [0.0, 3.0, 0.0]) - FRAC_PI_2).abs() < 1e-15);
}

#[test]
fn the_golden_is_the_product_of_the_matrices() {
    let design = design(&[]);
    for words in words(&design, 1, 100_000) {
        let turns = turns_of(&design.netlist, &words);
        let (is, should) = (unit_golden(&design, turns), matrix_golden(turns));
        for (is, should) in is.iter().zip(should) {
            assert!((is - should).abs() <= 1e-14, "{words:?}: {is} and not {should}");
        }
    }
}

#[test]
fn exact_linear_is_within_two_ulp_of_the_matrices() {
    let design = design(&["scheme=linear"]);
    let samples = words(&design, 2, 100_000);
    let outputs = run(&design.netlist, &samples);
    let mut worst = 0f64;
    for (i, words) in samples.iter().enumerate() {
        let golden = matrix_golden(turns_of(&design.netlist, words));
        for (column, golden) in outputs.iter().zip(golden) {
            let ulps = column[i] as f64 - golden * 65536.0;
            worst = worst.max(ulps.abs());
            assert!(ulps.abs() <= 2.0, "{words:?}: {} ulp", ulps);
        }
    }
    assert!(worst > 0.5, "words can't be better than rounding: {worst}");
    assert_eq!(design.groups[0].shape, Shape::Cartesian);
    let names: Vec<&str> = design.netlist.outputs().iter().map(|o| o.name.as_str()).collect();
    assert_eq!(names, ["x", "y", "z"]);
}

/// Eqs (5)-(9), (16)-(21), (26), (27) as printed, with a full-circle arctangent. Angles are in rad;
/// the halved angles of eq (6) don't reduce the difference of the azimuths.
fn printed_model(turns: [f64; 4]) -> Option<Vector> {
    let [phi_a, theta_a, phi_n, theta_n] = turns.map(|turns| turns * TAU);
    let delta = phi_a - phi_n;
    let (x, y) = ((theta_a + delta) / 2.0, (theta_a - delta) / 2.0);
    let sine = (x.sin() + y.sin()) / 2.0;
    let z = sine.asin() - theta_n;
    let rise = y.cos() - x.cos();
    let phi = rise.atan2(2.0 * z.sin());
    let y_k = rise / (2.0 * z.cos());
    let prop = 1.0 - y_k.clamp(-1.0, 1.0).acos() / FRAC_PI_2;
    let theta = z + (FRAC_PI_2 - z) * prop;
    let singular = rise.abs() < 1e-6
        || z.sin().abs() < 1e-6
        || z.cos().abs() < 1e-3
        || sine.abs() > 1.0 - 1e-6
        || (y_k.abs() - 1.0).abs() < 1e-6;
    (!singular).then(|| vector(phi / TAU, theta / TAU))
}

/// The same with corrected identities: full angles, the arcsine's other branch where cos theta_a <
/// 0, and magnitudes in the last line.
fn corrected_model(turns: [f64; 4]) -> Option<Vector> {
    let [phi_a, theta_a, phi_n, theta_n] = turns.map(|turns| turns * TAU);
    let delta = phi_a - phi_n;
    let (x, y) = (theta_a + delta, theta_a - delta);
    let sine = ((x.sin() + y.sin()) / 2.0).clamp(-1.0, 1.0);
    let theta_x = if theta_a.cos() < 0.0 { PI - sine.asin() } else { sine.asin() };
    let z = (theta_x - theta_n + PI).rem_euclid(TAU) - PI;
    let rise = y.cos() - x.cos();
    let phi = rise.atan2(2.0 * z.sin());
    let y_k = (rise / (2.0 * z.cos())).abs();
    let prop = 1.0 - y_k.min(1.0).acos() / FRAC_PI_2;
    let theta = z.abs() + (FRAC_PI_2 - z.abs()) * prop;
    let singular = rise.abs() < 1e-6
        || z.sin().abs() < 1e-6
        || z.cos().abs() < 1e-3
        || theta_a.cos().abs() < 1e-9
        || sine.abs() > 1.0 - 1e-6
        || (y_k - 1.0).abs() < 1e-6;
    (!singular).then(|| vector(phi / TAU, theta / TAU))
}

#[test]
fn the_seeds_variants_on_reals_are_the_seeds_equations() {
    for (variant, model) in [
        ("printed", printed_model as fn([f64; 4]) -> Option<Vector>),
        ("corrected", corrected_model),
    ] {
        let design = design(&[&format!("variant={variant}")]);
        let netlist = &design.netlist;
        let mut compared = 0;
        let samples = words(&design, 3, 30_000);
        for words in &samples {
            let turns = turns_of(netlist, words);
            // The printed equations reduce no angles. Input words are modulo a turn, so only polar
            // angles up to half a turn are compared.
            if turns[1] > 0.5 || turns[3] > 0.5 {
                continue;
            }
            let Some(should) = model(turns) else { continue };
            let values = netlist.eval_reals(&turns);
            let [phi, theta] = [0, 1].map(|i| values[netlist.outputs()[i].node.index()]);
            let is = vector(phi, theta);
            for (is, should) in is.iter().zip(should) {
                assert!((is - should).abs() < 1e-9, "{variant} {words:?}: {is} and not {should}");
            }
            compared += 1;
        }
        assert!(compared > 5_000, "{compared} of {}", samples.len());
    }
}

#[test]
fn the_exact_variant_on_reals_is_the_rotation() {
    for output in ["cartesian", "polar-cordic", "polar-table"] {
        let design = design(&[&format!("output={output}"), "scheme=linear"]);
        let netlist = &design.netlist;
        for words in words(&design, 4, 20_000) {
            let turns = turns_of(netlist, &words);
            let values = netlist.eval_reals(&turns);
            let ports: Vec<f64> =
                netlist.outputs().iter().map(|output| values[output.node.index()]).collect();
            let is = match ports[..] {
                [x, y, z] => [x, y, z],
                [phi, theta] => vector(phi, theta),
                _ => panic!("two or three ports"),
            };

            for (is, should) in is.iter().zip(matrix_golden(turns)) {
                assert!((is - should).abs() < 1e-12, "{output} {words:?}: {is} and not {should}");
            }
        }
    }
}

fn lit(design: &Design, samples: u64) -> Report {
    let inputs = Inputs { sampler: Sampler::Lit, samples, seed: 1 };
    measure(&[design], &inputs, &|_| ()).unwrap().remove(0)
}

/// The stated errors of the methods themselves, in degrees over lit vectors.
#[test]
fn algorithm_errors_are_as_stated() {
    let figures = |assignments: &[&str]| {
        let report = lit(&design(assignments), 200_000);
        let figures = report.figures("angle", Basis::Algorithm).clone();
        (figures.mean.to_degrees(), figures.p99.to_degrees(), figures.max.to_degrees())
    };
    let (mean, p99, max) = figures(&["variant=corrected"]);
    assert!((mean - 17.0).abs() <= 0.3, "mean {mean}");
    assert!((p99 - 49.0).abs() <= 1.0, "p99 {p99}");
    assert!(max <= 60.5, "max {max}");
    let (mean, _, _) = figures(&["variant=printed"]);
    assert!((mean - 78.4).abs() <= 0.5, "mean {mean}");
    let (_, _, max) = figures(&[]);
    assert!(max.to_radians() < 1e-12, "max {max}");
}

/// Measures over a sampler and holds the result to the stated bound.
fn assert_bound(assignments: &[&str], design: &Design, check: &BoundCheck, sampler: Sampler) {
    let inputs = Inputs { sampler, samples: 20_000, seed: 7 };
    let report = measure(&[design], &inputs, &|_| ()).unwrap().remove(0);
    let (bound, seen) = (check.stated[0].bound, check.stated[0].seen(&report));
    assert!(
        seen <= bound && check.hold(&report),
        "{assignments:?} {sampler:?}: {seen:e} is above {bound:e}, {:?}",
        report.figures("angle", Basis::Total).witness
    );
}

#[test]
fn stated_bounds_hold() {
    let widths: [&[&str]; 8] = [
        &[],
        &["angle_bits=2", "frac_bits=2", "guard_bits=0", "table_addr_bits=2"],
        &["angle_bits=5", "frac_bits=6", "guard_bits=0", "table_addr_bits=4"],
        &["angle_bits=8", "frac_bits=8", "guard_bits=1", "table_addr_bits=6", "rounding=floor"],
        &["angle_bits=12", "frac_bits=12", "guard_bits=0", "rounding=toward-zero"],
        &["angle_bits=16", "frac_bits=20", "guard_bits=4", "quarter_wave=on"],
        &["angle_bits=24", "frac_bits=16", "table_addr_bits=12", "rounding=half-even"],
        &["angle_bits=10", "frac_bits=2", "guard_bits=0", "rounding=half-away", "quarter_wave=on"],
    ];
    for output in ["cartesian", "polar-cordic", "polar-table"] {
        for scheme in ["direct", "linear", "bipartite"] {
            for widths in widths {
                // A table with a 24-bit argument takes seconds to evaluate, so it is tested once.
                if widths.contains(&"angle_bits=24") && scheme != "linear" {
                    continue;
                }
                let named = [format!("output={output}"), format!("scheme={scheme}")];
                let mut assignments: Vec<&str> = named.iter().map(String::as_str).collect();
                assignments.extend(widths);
                let design = design(&assignments);
                let check = BoundCheck::new(&design).unwrap();
                assert_bound(&assignments, &design, &check, Sampler::Hard);
                assert_bound(&assignments, &design, &check, Sampler::Sphere);
                if widths.contains(&"angle_bits=5") || widths.contains(&"angle_bits=2") {
                    assert_bound(&assignments, &design, &check, Sampler::Exhaustive);
                }
            }
        }
    }
}

/// A bound that nothing can exceed is useless: it must be near the errors seen.
#[test]
fn stated_bounds_are_not_idle() {
    for (assignments, factor) in [
        (&["scheme=linear"][..], 3.0),
        (&["scheme=direct"], 3.0),
        (&["scheme=linear", "output=polar-cordic"], 20.0),
        (&["scheme=linear", "output=polar-table"], 20.0),
    ] {
        let design = design(assignments);
        let check = BoundCheck::new(&design).unwrap();
        let report = lit(&design, 50_000);
        let (bound, seen) = (check.stated[0].bound, check.stated[0].seen(&report));
        assert!(bound <= factor * seen, "{assignments:?}: {bound:e} for {seen:e}");
    }
}

#[test]
fn the_seeds_variants_state_no_bound() {
    for variant in ["printed", "corrected"] {
        let design = design(&[&format!("variant={variant}")]);
        assert!(matches!(design.bounds, Bounds::Unstated(_)));
        let check = BoundCheck::new(&design).unwrap();
        assert!(check.stated.is_empty());
        assert!(check.why_none.as_deref().is_some_and(|why| why.contains("infinite slopes")));
        assert!(check.hold(&lit(&design, 1000)));
    }
}

/// A design with another design's golden must break its bound: the check can fail.
#[test]
fn a_wrong_golden_breaks_the_bound() {
    let mirrored = |turns: [f64; 4]| {
        let v = matrix_golden(turns);
        [v[0], -v[1], v[2]]
    };
    for output in ["cartesian", "polar-cordic", "polar-table"] {
        let mut design = design(&[&format!("output={output}")]);
        let check = BoundCheck::new(&design).unwrap();
        assert!(check.hold(&lit(&design, 2000)));
        design.golden = Golden::each(mirrored);
        assert!(!check.hold(&lit(&design, 2000)), "{output}");
    }
}

/// Witnesses are real: their words give the claimed error.
#[test]
fn witnesses_give_their_errors() {
    let design = design(&["angle_bits=10", "table_addr_bits=8", "frac_bits=10"]);
    let report = lit(&design, 40_000);
    for (i, quantity) in ["x", "y", "z"].into_iter().enumerate() {
        let figures = report.figures(quantity, Basis::Total);
        let witness = figures.witness.as_ref().unwrap();
        let (nodes, _) = design.netlist.eval(&witness.words).unwrap();
        let outputs: Vec<i64> =
            design.netlist.outputs().iter().map(|output| nodes[output.node.index()]).collect();
        assert_eq!(outputs, witness.outputs);
        let golden = matrix_golden(turns_of(&design.netlist, &witness.words));
        let error = (outputs[i] as f64 / 1024.0 - golden[i]).abs();
        assert!((error - figures.max).abs() < 1e-14, "{error} and not {}", figures.max);
        assert!((figures.max_ulp.unwrap() - error * 1024.0).abs() < 1e-9);
        assert!(figures.mean <= figures.rms && figures.rms <= figures.max);
        assert!(figures.p50 <= figures.p99 && figures.p99 <= figures.max);
        assert!(figures.bias.abs() <= figures.mean);
    }
}

/// The figures are the same, to the last bit, on any number of threads.
#[test]
fn figures_do_not_depend_on_threads() {
    let designs = [design(&[]), design(&["variant=corrected"]), design(&["angle_bits=12"])];
    let designs: Vec<&Design> = designs.iter().collect();
    for (sampler, samples) in [(Sampler::Lit, 150_001), (Sampler::Hard, 0)] {
        let figures = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let inputs = Inputs { sampler, samples, seed: 5 };
            let reports = pool.install(|| measure(&designs, &inputs, &|_| ()).unwrap());
            let tables =
                pool.install(|| fixpath::measure::table_figures(&designs[0].tabulated[0]).unwrap());
            assert_eq!(reports[0].speed.threads, threads);
            let mut texts = vec![serde_json::to_string(&tables).unwrap()];
            for report in &reports {
                let same = (&report.figures, &report.overflows, report.samples);
                texts.push(serde_json::to_string(&same).unwrap());
            }
            texts
        };
        let one = figures(1);
        assert_eq!(one, figures(2));
        assert_eq!(one, figures(3));
    }
}

/// Designs measured together have the figures that each has alone.
#[test]
fn company_changes_nothing() {
    let designs =
        [design(&["scheme=linear"]), design(&["angle_bits=12"]), design(&["frac_bits=8"])];
    // The hard lists of these widths have the same length and different words.
    for sampler in [Sampler::Sphere, Sampler::Hard] {
        let inputs = Inputs { sampler, samples: 20_000, seed: 3 };
        let together = measure(&designs.iter().collect::<Vec<_>>(), &inputs, &|_| ()).unwrap();
        for (design, report) in designs.iter().zip(together) {
            let alone = measure(&[design], &inputs, &|_| ()).unwrap().remove(0);
            assert_eq!(alone.samples, report.samples);
            assert_eq!(alone.figures, report.figures, "{sampler:?}");
            assert_eq!(alone.overflows, report.overflows);
        }
    }
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    let unit = Unit::find("rotation").unwrap();
    let refusal = |assignment: &str| unit.values(&[assignment]).unwrap_err().to_string();
    assert_eq!(refusal("angle_bits=25"), "parameter `angle_bits` = `25`: legal is 2 to 24");
    assert_eq!(
        refusal("scheme=cubic"),
        "parameter `scheme` = `cubic`: legal is direct, linear, bipartite"
    );
    assert_eq!(
        refusal("angle_bit=8"),
        "unit `rotation` has no parameter `angle_bit`, did you mean `angle_bits`: `fixpath list rotation` names them all"
    );
    assert_eq!(refusal("angle_bits"), "`angle_bits` is not of the form key=value");
    let values = unit.values(&["variant=corrected", "output=polar-cordic"]).unwrap();
    assert_eq!(
        values.build().unwrap_err().to_string(),
        "parameter `output` = `polar-cordic`: legal is auto or polar-table when variant=corrected"
    );
    let message = Unit::find("rotatoin").unwrap_err().to_string();
    assert_eq!(
        message,
        "no unit `rotatoin`, did you mean `rotation`: `fixpath list` names them all"
    );
    let wide = design(&["angle_bits=24"]);
    let inputs = Inputs { sampler: Sampler::Exhaustive, samples: 0, seed: 0 };
    let message = measure(&[&wide], &inputs, &|_| ()).unwrap_err().to_string();
    assert!(message.contains("2^96 combinations"), "{message}");
}

/// Every corner of the legal ranges gives a datapath that runs, or an error that names a node.
#[test]
fn corners_of_the_legal_ranges_build_or_say_why_not() {
    let (mut built, mut refused) = (0, 0);
    let forms = [
        "exact,cartesian",
        "exact,polar-cordic",
        "exact,polar-table",
        "printed,auto",
        "corrected,auto",
    ];
    for form in forms {
        let (variant, output) = form.split_once(',').unwrap();
        for (angle, frac, guard) in
            [(2, 2, 0), (2, 32, 8), (3, 2, 8), (24, 2, 0), (24, 32, 8), (5, 9, 1)]
        {
            for (scheme, wave) in [
                ("direct", "off"),
                ("direct", "on"),
                ("linear", "off"),
                ("linear", "on"),
                ("bipartite", "off"),
                ("bipartite", "on"),
            ] {
                for size in [2, 3, 6] {
                    let named = [
                        format!("variant={variant}"),
                        format!("output={output}"),
                        format!("angle_bits={angle}"),
                        format!("frac_bits={frac}"),
                        format!("guard_bits={guard}"),
                        format!("scheme={scheme}"),
                        format!("quarter_wave={wave}"),
                        format!("table_addr_bits={size}"),
                    ];
                    let values = Unit::find("rotation").unwrap().values(&named).unwrap();
                    let design = match values.build() {
                        Ok(design) => design,
                        Err(error) => {
                            let text = error.to_string();
                            assert!(text.contains("words have at most 63"), "{named:?}: {text}");
                            refused += 1;
                            continue;
                        }
                    };
                    built += 1;
                    let top = (1i64 << angle) - 1;
                    for words in
                        [[0; 4], [top; 4], [1, top / 2, top, top / 2 + 1], [top, 0, 0, top]]
                    {
                        let (nodes, _) = design.netlist.eval(&words).unwrap();
                        let outputs = run(&design.netlist, &[words.to_vec()]);
                        for (port, output) in design.netlist.outputs().iter().zip(outputs) {
                            assert_eq!(output[0], nodes[port.node.index()], "{named:?} {words:?}");
                        }
                    }
                }
            }
        }
    }
    assert!(built > 350 && refused > 0, "{built} built, {refused} refused");
}

/// A vector with x = y = 0 has no azimuth: every conversion gives 0, as the golden does.
#[test]
fn on_a_pole_the_azimuth_is_0() {
    for output in ["output=polar-cordic", "output=polar-table"] {
        for more in ["quarter_wave=off", "quarter_wave=on", "cordic_iterations=3"] {
            let design = design(&[output, "scheme=linear", more]);
            let half = 1i64 << 15;
            // A and N on poles, and A parallel to N.
            for [phi_a, theta_a, phi_n, theta_n] in [
                [0, 0, 0, 0],
                [0, half, 0, 0],
                [22391, 0, 14017, 0],
                [0, half / 2, 0, half / 2],
                [0, 0, 0, half],
                [5, half, 9, half],
            ] {
                let (words, _) = design.netlist.eval(&[phi_a, theta_a, phi_n, theta_n]).unwrap();
                let [phi, theta] = [0, 1].map(|i| words[design.netlist.outputs()[i].node.index()]);
                let is_up = (theta_a == half) == (theta_n == half);
                assert_eq!(phi, 0, "{output} {more}: {phi_a} {theta_a} {phi_n} {theta_n}");
                assert!((theta - if is_up { 0 } else { half }).abs() <= 1 || more.contains("=3"));
            }
        }
    }
}
