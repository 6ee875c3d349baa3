//! One node over all combinations of the words it depends on.

use crate::common::{design, fixpath};
use fixpath::measure::{Basis, Cone, ConeReport, Inputs, measure};
use fixpath::op::Op;
use fixpath::units::{Design, Sampler};

fn cone(design: &Design, node: &str) -> ConeReport {
    Cone::new(&design.netlist, node).unwrap().measure(design, &|_| ()).unwrap()
}

/// The cone of an output and the exhaustive run of the whole unit find the same errors. The
/// exhaustive run finds each once per combination of the ports outside the cone.
#[test]
fn outputs_are_as_in_an_exhaustive_run() {
    let rotation = |variant| vec!["angle_bits=4", "table_addr_bits=4", "int_bits=0", variant];
    let combine = vec!["channel_bits=1", "fraction_bits=1", "guard_bits=0"];
    let dot = vec!["v_bits=3", "v_frac_bits=1", "w_bits=4", "w_frac_bits=2", "out_frac_bits=2"];
    let cases: [(&str, Vec<&str>, &[&str]); 5] = [
        ("rotation", rotation("variant=exact"), &["x", "y", "z"]),
        ("combine", combine, &["out_r", "out_g"]),
        // Many runs, with ports of unequal widths.
        ("dot", dot, &["dot_product"]),
        // Fewer samples than a block; many runs of one port.
        ("rsqrt", vec!["input_bits=9"], &["r"]),
        ("rsqrt", vec!["input_bits=17"], &["r"]),
    ];
    for (unit, params, outputs) in cases {
        let design = design(unit, &params);
        let netlist = &design.netlist;
        let bits: u32 = netlist.inputs().iter().map(|id| netlist.node(*id).format.bits()).sum();
        let inputs = Inputs { sampler: Sampler::Exhaustive, samples: 1, seed: 1 };
        let whole = measure(&[&design], &inputs, &|_| ()).unwrap().remove(0);
        for output in outputs {
            let cone = Cone::new(netlist, output).unwrap();
            assert!(!cone.ports.is_empty() && cone.bits <= bits, "{unit} {output}");
            let one = cone.measure(&design, &|_| ()).unwrap();
            let again = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
            let again = again.install(|| cone.measure(&design, &|_| ()).unwrap());
            let should = whole.figures(output, Basis::Arithmetic);
            let is = &one.report.figures[0];
            assert_eq!(one.past_format, 0, "{unit} {output}");
            assert_eq!(is, &again.report.figures[0], "{unit} {output}: threads count");
            assert_eq!(is.max, should.max, "{unit} {output}");
            assert_eq!((is.p50, is.p99, is.p999), (should.p50, should.p99, should.p999));
            for (is, should) in
                [(is.mean, should.mean), (is.bias, should.bias), (is.rms, should.rms)]
            {
                assert!((is - should).abs() <= 1e-12 * should.abs().max(1e-6), "{unit} {output}");
            }
            let times = 1 << (bits - cone.bits);
            for overflow in &one.report.overflows {
                let all = whole.overflows.iter().find(|o| o.node == overflow.node).unwrap();
                assert_eq!(overflow.count * times, all.count, "{unit} {}", overflow.node);
            }
            // The witness gives the largest error.
            let witness = is.witness.as_ref().unwrap();
            let node = netlist.node(cone.node);
            let ideal = netlist.eval_reals(&witness.values)[cone.node.index()];
            assert_eq!((node.format.value(witness.outputs[0]) - ideal).abs(), is.max);
            assert_eq!(
                netlist.eval(&witness.words).unwrap().0[cone.node.index()],
                witness.outputs[0]
            );
        }
    }
}

/// Differences of angles as words and as reals may be whole turns apart, which is no error.
#[test]
fn angles_are_modulo_a_turn() {
    let design = design("rotation", &["variant=corrected", "angle_bits=4"]);
    for node in ["z_exact", "theta_x"] {
        let report = cone(&design, node);
        let figures = &report.report.figures[0];
        assert_eq!(figures.unit, "rad");
        assert!(figures.max < 0.2, "{node}: {}", figures.max);
    }
}

/// At poles, values on reals are out of every format's range: such samples are counted and left
/// out.
#[test]
fn poles_are_left_out_and_counted() {
    let design = design("rotation", &["variant=corrected", "angle_bits=3"]);
    let netlist = &design.netlist;
    let report = cone(&design, "y_k");
    let figures = &report.report.figures[0];
    assert!(report.past_format > 0);
    for number in [figures.max, figures.mean, figures.bias, figures.rms, figures.p999] {
        assert!(number.is_finite(), "{figures:?}");
    }
    // Counted by the reference, sample by sample.
    let cone = Cone::new(netlist, "y_k").unwrap();
    let format = netlist.node(cone.node).format;
    let (mut past, mut sum, mut largest) = (0, 0.0, 0.0f64);
    for sample in 0..cone.samples() {
        let mut words = vec![0; netlist.inputs().len()];
        for (i, port) in cone.ports.iter().enumerate() {
            words[*port] = (sample >> (3 * i) & 7) as i64;
        }
        let values: Vec<f64> = words.iter().map(|word| *word as f64 / 8.0).collect();
        let ideal = netlist.eval_reals(&values)[cone.node.index()];
        let (low, high) = (format.value(format.min_raw()), format.value(format.max_raw()));
        if ideal >= low - format.ulp() && ideal <= high + format.ulp() {
            let error = format.value(netlist.eval(&words).unwrap().0[cone.node.index()]) - ideal;
            sum += error.abs();
            largest = largest.max(error.abs());
        } else {
            past += 1;
        }
    }
    assert_eq!((report.past_format, figures.max), (past, largest));
    let mean = sum / (cone.samples() - past) as f64;
    assert!((figures.mean - mean).abs() < 1e-12);
}

#[test]
fn nodes_go_by_label_port_and_number() {
    let design = design("rotation", &["variant=exact", "angle_bits=4"]);
    let netlist = &design.netlist;
    let of = |name: &str| Cone::new(netlist, name).map(|cone| cone.node);
    let delta = of("angles.delta").unwrap();
    assert_eq!(of(&format!("%{}", delta.index())).unwrap(), delta);
    assert_eq!(of("x").unwrap(), netlist.outputs()[0].node);
    let constant = netlist.ids().find(|id| matches!(netlist.node(*id).op, Op::Const { .. }));
    if let Some(id) = constant {
        let cone = Cone::new(netlist, &format!("%{}", id.index())).unwrap();
        assert_eq!((cone.samples(), cone.ports.len()), (1, 0));
    }
    let unknown = of("nothing").unwrap_err().to_string();
    assert!(unknown.starts_with("there is no node `nothing`") && unknown.contains("angles.delta"));
    let wide = crate::common::design("rotation", &["variant=exact"]);
    let refused = Cone::new(&wide.netlist, "x").unwrap_err().to_string();
    assert!(refused.contains("phi_a of 16 bits") && refused.contains("2^64"), "{refused}");
}

#[test]
fn the_command_line_tells_cones() {
    let run = |args: &[&str]| fixpath().arg("sim").arg("rotation").args(args).output().unwrap();
    let small = ["-p", "variant=exact", "-p", "angle_bits=3", "--cone", "x"];
    let text = run(&[&small[..], &["--profile"]].concat());
    let text = String::from_utf8(text.stdout).unwrap();
    assert!(text.contains("4096 samples: every combination of the words of"), "{text}");
    assert!(text.contains("arithmetic x") && text.contains("time of all threads"), "{text}");
    let json = run(&[&small[..], &["--json"]].concat());
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json["inputs"]["samples"], 4096);
    assert_eq!(json["inputs"]["left_out_past_format"], 0);
    for other in
        [&["--hard"][..], &["--samples", "5"], &["--cases", "c.csv"], &["--sampler", "lit"]]
    {
        let refused = run(&[&small[..], other].concat());
        assert_eq!(refused.status.code(), Some(2), "{other:?}");
    }
}
