//! Waves are read back by independent readers and compared with the reference.

use crate::common;
use fixpath::measure::{Basis, Inputs, measure, sample_words};
use fixpath::units::rotation;
use fixpath::units::{Design, Sampler, Shape, UNITS, Unit};
use fixpath::wave::{Options, Wave};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;
use std::path::Path;
use std::process::Command;

fn design(assignments: &[&str]) -> Design {
    rotation::unit().values(assignments).unwrap().build().unwrap()
}

fn samples(design: &Design) -> Vec<Vec<i64>> {
    let mut rows: Vec<Vec<i64>> =
        design.hard.iter().flat_map(|case| case.words.iter().take(3).cloned()).collect();
    let words = design.netlist.node(design.netlist.inputs()[0]).format.words();
    rows.extend((1..40u64).map(|i| {
        (1..5u64).map(|port| ((i * i * 7919 * port + i * 104_729) % words) as i64).collect()
    }));
    rows
}

fn write(
    design: &Design,
    options: Options,
    rows: &[Vec<i64>],
    folder: &Path,
) -> std::path::PathBuf {
    let path = folder.join("unit.vcd");
    let wave = Wave::new(design, options).unwrap();
    wave.write(rows, &mut std::fs::File::create(&path).unwrap(), &path).unwrap();
    wave.write_gtkw(&path, &mut std::fs::File::create(path.with_extension("gtkw")).unwrap())
        .unwrap();
    path
}

/// Values by full name and time, as wellen reads them.
pub(crate) struct ReadBack {
    pub(crate) times: Vec<u64>,
    pub(crate) signals: BTreeMap<String, BTreeMap<u64, String>>,
}

impl ReadBack {
    pub(crate) fn open(path: &Path) -> Self {
        let mut waves = wellen::simple::read(path).expect("a legal VCD");
        let times = waves.time_table().to_vec();
        let vars: Vec<(String, wellen::SignalRef)> = waves
            .hierarchy()
            .all_vars()
            .map(|var| {
                let var = &waves.hierarchy()[var];
                (var.full_name(waves.hierarchy()), var.signal_ref())
            })
            .collect();
        let refs: Vec<wellen::SignalRef> = vars.iter().map(|(_, signal)| *signal).collect();
        waves.load_signals(&refs);
        let mut signals = BTreeMap::new();
        for (name, signal) in vars {
            let signal = waves.get_signal(signal).unwrap();
            let changes = signal
                .iter_changes()
                .map(|(time, value)| (times[time as usize], value.to_string()))
                .collect();
            assert!(signals.insert(name.clone(), changes).is_none(), "{name} is there twice");
        }
        Self { times, signals }
    }

    /// The last change at or before a time.
    pub(crate) fn at(&self, name: &str, time: u64) -> &str {
        let changes = self.signals.get(name).unwrap_or_else(|| panic!("no signal {name}"));
        changes.range(..=time).next_back().map_or("none", |(_, value)| value)
    }
}

fn bits(pattern: u64, width: u32) -> String {
    format!("{pattern:0width$b}", width = width as usize)
}

#[test]
fn every_word_and_twin_is_the_reference_of_its_sample() {
    let settings: [&[&str]; 5] = [
        &[],
        &["variant=corrected", "rom=distributed"],
        &["variant=printed", "angle_bits=9", "frac_bits=7"],
        &["output=polar-table", "scheme=linear", "period_ps=2500"],
        &["scheme=bipartite", "stages=0", "rom=distributed"],
    ];
    for assignments in settings {
        let design = design(assignments);
        let folder = tempfile::tempdir().unwrap();
        let rows = samples(&design);
        let path =
            write(&design, Options { all: true, ..Options::default() }, &rows, folder.path());
        let read = ReadBack::open(&path);
        let wave = Wave::new(&design, Options { all: true, ..Options::default() }).unwrap();
        let netlist = &design.netlist;
        let latency = wave.rtl().schedule().latency() as usize;
        let period = read.times[2] - read.times[0];
        let mut compared = 0;
        for at in 0..rows.len() + latency {
            let time = at as u64 * period;
            assert_eq!(read.at("rotation.valid_in", time), if at < rows.len() { "1" } else { "0" });
            assert_eq!(read.at("rotation.valid_out", time), if at >= latency { "1" } else { "0" });
            assert_eq!(read.at("rotation.clk", time), "1");
            assert_eq!(read.at("rotation.clk", time + period / 2), "0");
            for (name, node, stage) in wave.signals() {
                let full = format!("rotation.{name}");
                let Some(sample) = at.checked_sub(stage as usize) else {
                    assert!(read.at(&full, time).chars().all(|c| c == 'x'), "{full} at {at}");
                    continue;
                };
                let Some(words) = rows.get(sample) else { continue };
                let (reference, _) = netlist.eval(words).unwrap();
                let format = netlist.node(node).format;
                let word = reference[node.index()];
                let should = bits(format.pattern(word), format.bits());
                assert_eq!(read.at(&full, time), should, "{assignments:?}: {full} at cycle {at}");
                compared += 1;
                for (twin, scale) in [("_value", 1.0), ("_value_deg", 360.0)] {
                    if let Some(changes) = read.signals.get(&format!("{full}{twin}")) {
                        let (_, text) = changes.range(..=time).next_back().unwrap();
                        assert_eq!(
                            text.parse::<f64>().unwrap(),
                            format.value(word) * scale,
                            "{full}"
                        );
                    }
                }
                if let Some(changes) = read.signals.get(&format!("{full}_arith_error")) {
                    let inputs: Vec<f64> = words
                        .iter()
                        .zip(netlist.inputs())
                        .map(|(word, id)| netlist.node(*id).format.value(*word))
                        .collect();
                    let error = format.value(word) - netlist.eval_reals(&inputs)[node.index()];
                    let (_, text) = changes.range(..=time).next_back().unwrap();
                    let shown: f64 = text.parse().unwrap();
                    assert!(shown == error || shown.is_nan() && error.is_nan(), "{full}: {shown}");
                    // In ulp, to 1/256 of an ulp.
                    let ulp = read.at(&format!("{full}_arith_error_ulp"), time);
                    let ulp: f64 = ulp.parse().unwrap();
                    let should = error / format.ulp();
                    if should.is_finite() {
                        assert_eq!((ulp * 256.0).fract(), 0.0, "{full}: {ulp}");
                        let off = (ulp - should).abs();
                        assert!(off <= 1.0 / 512.0, "{full}: {ulp} for {should}");
                    } else {
                        assert_eq!(ulp.to_string(), should.to_string(), "{full}");
                    }
                }
            }
        }
        assert!(compared > 1000, "{assignments:?}: {compared} words were compared");
    }
}

#[test]
fn the_golden_stands_beside_output_ports() {
    let design = design(&["variant=exact", "scheme=linear"]);
    assert_eq!(design.groups[0].shape, Shape::Cartesian);
    let folder = tempfile::tempdir().unwrap();
    let rows = vec![vec![0, 8192, 0, 0]]; // 45° from the pole, N at the pole
    let read = ReadBack::open(&write(&design, Options::default(), &rows, folder.path()));
    let end = *read.times.last().unwrap();
    let z: f64 = read.at("rotation.z_golden", end).parse().unwrap();
    assert!((z - 0.5f64.sqrt()).abs() < 1e-15);
}

/// The angle of every direction of every unit is the one by which `sim` ranks.
#[test]
fn angle_errors_are_those_that_sim_measures() {
    let shared = ["schedule=shared", "share_mul=2", "share_add=3"];
    let more = [("rotation", &["output=polar-table"][..]), ("illumination", &shared)];
    let all = UNITS.iter().map(|unit| (unit.name.as_str(), &[][..]));
    let mut directions = 0;
    for (unit, assignments) in all.chain(more) {
        let design = common::design(unit, assignments);
        if !design.groups.iter().any(|group| group.shape.is_direction()) {
            continue;
        }
        let inputs = Inputs { sampler: Sampler::Hard, samples: 1, seed: 1 };
        let report = measure(&[&design], &inputs, &|_| ()).unwrap().pop().unwrap();
        let rows = sample_words(&design, &inputs).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let options = Options { signals: vec!["*angle_error".to_owned()], ..Options::default() };
        let read = ReadBack::open(&write(&design, options, &rows, folder.path()));
        for figures in report.figures.iter().filter(|figures| figures.basis == Basis::Total) {
            if figures.unit != "rad" || !figures.quantity.ends_with("angle") {
                continue;
            }
            directions += 1;
            let name = format!("{}.{}_error_deg", design.netlist.name(), figures.quantity);
            let shown = read.signals.get(&name).unwrap_or_else(|| panic!("no {name}"));
            let shown = shown.values().map(|text| text.parse::<f64>().unwrap());
            assert_eq!(shown.fold(0.0, f64::max), figures.max.to_degrees(), "{name}");
        }
    }
    assert!(directions >= 8, "{directions}");
}

/// In its own cycle: only a direction at the pole that should be at the equator is 90° off.
#[test]
fn an_angle_error_is_in_the_cycle_of_its_result() {
    let design = design(&["variant=printed"]);
    let folder = tempfile::tempdir().unwrap();
    let rows = samples(&design);
    let read = ReadBack::open(&write(&design, Options::default(), &rows, folder.path()));
    let latency = design.rtl().unwrap().schedule().latency() as usize;
    let period = read.times[2] - read.times[0];
    let netlist = &design.netlist;
    for (sample, words) in rows.iter().enumerate() {
        let values: Vec<f64> = words
            .iter()
            .zip(netlist.inputs())
            .map(|(w, id)| netlist.node(*id).format.value(*w))
            .collect();
        let columns: Vec<&[f64]> = values.iter().map(std::slice::from_ref).collect();
        let mut golden = vec![vec![0.0]; design.golden_columns()];
        design.golden.run(&columns, &mut golden);
        let (reference, _) = netlist.eval(words).unwrap();
        let outputs = netlist.outputs().iter();
        let is: Vec<f64> =
            outputs.map(|o| netlist.node(o.node).format.value(reference[o.node.index()])).collect();
        assert_eq!(design.groups[0].shape, Shape::Polar);
        let (phi, theta) = (is[0] * TAU, is[1] * TAU);
        let is = [phi.cos() * theta.sin(), phi.sin() * theta.sin(), theta.cos()];
        // Kahan's formula: accurate for small and for large angles.
        let (mut less, mut more) = (0.0f64, 0.0f64);
        for (is, golden) in is.iter().zip(&golden) {
            less += (is - golden[0]).powi(2);
            more += (is + golden[0]).powi(2);
        }
        let should = 2.0 * less.sqrt().atan2(more.sqrt()).to_degrees();
        let shown = read.at("rotation.angle_error_deg", (sample + latency) as u64 * period);
        let shown: f64 = shown.parse().unwrap();
        // Rounding of the sines and of the golden, 2^-52 each, in degrees.
        assert!((shown - should).abs() < 1e-12, "sample {sample}: {shown} for {should}");
    }
}

#[test]
fn errors_are_found_by_their_name() {
    for (assignments, some) in [
        (&["scheme=linear"][..], ["x_total_error", "y_arith_error_ulp", "angle_error_deg"]),
        (
            &["output=polar-table"],
            ["phi_total_error_deg", "phi_total_error_ulp", "angle_error_deg"],
        ),
    ] {
        let design = design(assignments);
        let folder = tempfile::tempdir().unwrap();
        let rows = samples(&design);
        let names = |pattern: &str| -> BTreeSet<String> {
            let options = Options { signals: vec![pattern.to_owned()], ..Options::default() };
            let read = ReadBack::open(&write(&design, options, &rows, folder.path()));
            let always = ["clk", "rst", "valid_in", "valid_out"];
            let names = read.signals.keys().map(|name| name["rotation.".len()..].to_owned());
            names.filter(|name| !always.contains(&name.as_str())).collect()
        };
        let found = names("*error");
        let is_error = |name: &str| {
            ["_error", "_error_deg", "_error_ulp"].iter().any(|end| name.ends_with(end))
        };
        assert!(found.iter().all(|name| is_error(name)), "{found:?}");
        assert!(some.iter().all(|name| found.contains(*name)), "{found:?}");
        let all = names("*");
        assert_eq!(found, all.iter().filter(|name| is_error(name)).cloned().collect());
        // The save file shows them, each in its own line.
        let save = std::fs::read_to_string(folder.path().join("unit.gtkw")).unwrap();
        assert!(some.iter().all(|name| save.contains(&format!("\nrotation.{name}\n"))), "{save}");
    }
}

/// GTKWave takes the name of the waves from between the first and the last quote of their line. A
/// name that doesn't fit into a line is left out, and the rest stays.
#[test]
fn save_files_name_the_waves_in_one_line() {
    let design = Unit::find("rotation").unwrap().defaults().build().unwrap();
    let wave = Wave::new(&design, Options::default()).unwrap();
    let save = |name: &str| {
        let mut save = Vec::new();
        wave.write_gtkw(&Path::new("a folder").join(name), &mut save).unwrap();
        String::from_utf8(save).unwrap()
    };
    let plain = save("u.vcd");
    let line = "[dumpfile] \"u.vcd\"\n";
    assert_eq!(plain.matches(line).count(), 1, "{plain}");
    let quoted = "[dumpfile] \"it's \"u\".vcd\"\n";
    assert_eq!(save("it's \"u\".vcd"), plain.replace(line, quoted));
    for name in ["u\n[timestart] 9.vcd", "u\r.vcd"] {
        assert_eq!(save(name), plain.replace(line, ""), "{name:?}");
    }
}

/// The save file opens on the first samples, zoomed so that the results of the first are visible.
#[test]
fn gtkwave_opens_on_inputs_and_outputs_of_the_first_samples() {
    let shared = ["schedule=shared", "share_mul=1", "share_add=2"];
    for (unit, assignments, first) in [
        ("rotation", &[][..], 0),
        ("rotation", &["scheme=linear", "period_ps=2500"], 7),
        ("emboss", &[], 0),
        ("illumination", &shared, 0),
    ] {
        let design = common::design(unit, assignments);
        let options = Options { cycles: (first > 0).then_some(first..1000), ..Options::default() };
        let wave = Wave::new(&design, options).unwrap();
        let mut save = Vec::new();
        wave.write_gtkw(Path::new("u.vcd"), &mut save).unwrap();
        let save = String::from_utf8(save).unwrap();
        let line = |start: &str| -> &str {
            save.lines().find_map(|line| line.strip_prefix(start)).unwrap()
        };
        let rows = sample_words(&design, &Inputs { sampler: Sampler::Lit, samples: 3, seed: 1 });
        let mut vcd = Vec::new();
        wave.write(&rows.unwrap(), &mut vcd, Path::new("u.vcd")).unwrap();
        let times: Vec<u64> = String::from_utf8(vcd)
            .unwrap()
            .lines()
            .filter_map(|line| line.strip_prefix('#')?.parse().ok())
            .collect();
        let period = times[2] - times[0];
        assert_eq!(line("[timestart] ").parse::<u64>().unwrap(), first * period);
        // GTKWave: this many time units in 200 pixels.
        let zoom: f64 = line("*").split(' ').next().unwrap().parse().unwrap();
        let pixels_per_cycle = 200.0 * period as f64 / 2f64.powf(-zoom);
        let schedule = wave.rtl().schedule();
        let cycles = schedule.latency() + 2 * schedule.interval();
        let width: f64 = line("[size] ").split(' ').next().unwrap().parse().unwrap();
        let names: f64 = line("[signals_width] ").parse().unwrap();
        let tree: f64 = line("[sst_width] ").parse().unwrap();
        assert!(pixels_per_cycle * f64::from(cycles) <= width - names - tree, "{unit}");
        assert!(pixels_per_cycle <= 100.001);
    }
}

/// Twins are evaluated in blocks of samples: long waves have several blocks, and windows start
/// inside one.
#[test]
fn twins_are_those_of_their_sample_in_long_waves() {
    let shared = ["schedule=shared", "share_mul=2", "share_add=3"];
    let cases = [
        ("rotation", &[][..], 3000, None),
        ("rotation", &["output=polar-table"], 3000, Some(2040..2120)),
        ("emboss", &shared, 1200, None),
        ("emboss", &shared, 2300, Some(16_101..16_400)),
    ];
    for (unit, assignments, count, cycles) in cases {
        let design = common::design(unit, assignments);
        let inputs = Inputs { sampler: Sampler::Lit, samples: count, seed: 5 };
        let rows = sample_words(&design, &inputs).unwrap();
        let netlist = &design.netlist;
        let folder = tempfile::tempdir().unwrap();
        let options = Options { cycles: cycles.clone(), ..Options::default() };
        let wave = Wave::new(&design, options.clone()).unwrap();
        let read = ReadBack::open(&write(&design, options, &rows, folder.path()));
        let period = read.times[2] - read.times[0];
        let interval = u64::from(wave.rtl().schedule().interval());
        assert_eq!(interval > 1, unit == "emboss");
        let window = cycles.unwrap_or(0..wave.cycles(rows.len()));
        let (mut ideals, mut goldens) = (0, 0);
        for (sample, words) in rows.iter().enumerate() {
            let first = sample as u64 * interval;
            let latency = u64::from(wave.rtl().schedule().latency());
            if first + latency < window.start || first >= window.end {
                continue;
            }
            let values: Vec<f64> = words
                .iter()
                .zip(netlist.inputs())
                .map(|(word, id)| netlist.node(*id).format.value(*word))
                .collect();
            let reals = netlist.eval_reals(&values);
            let columns: Vec<&[f64]> = values.iter().map(std::slice::from_ref).collect();
            let mut golden = vec![vec![0.0]; design.golden_columns()];
            design.golden.run(&columns, &mut golden);
            let golden: Vec<f64> = golden.iter().map(|column| column[0]).collect();
            let golden = design.of_golden(&golden);
            for (name, node, stage) in wave.signals() {
                let now = first + u64::from(stage);
                if !window.contains(&now) {
                    continue;
                }
                let port = netlist.outputs().iter().position(|output| output.name == name);
                for (unit_of, scale) in [("", 1.0), ("_deg", 360.0)] {
                    let shown = |twin: &str| -> Option<f64> {
                        let full = format!("{unit}.{name}_{twin}{unit_of}");
                        let (_, text) =
                            read.signals.get(&full)?.range(..=now * period).next_back()?;
                        Some(text.parse().unwrap())
                    };
                    if let Some(ideal) = shown("ideal") {
                        let should = reals[node.index()] * scale;
                        assert_eq!(ideal.to_bits(), should.to_bits(), "{name} of {sample}");
                        ideals += 1;
                    }
                    if let Some(shown) = shown("golden") {
                        let should = golden[port.unwrap()] * scale;
                        assert_eq!(shown.to_bits(), should.to_bits(), "{name} of {sample}");
                        goldens += 1;
                    }
                }
            }
        }
        assert!(ideals > 200 && goldens > 50, "{unit} {assignments:?}: {ideals}, {goldens}");
    }
}

#[test]
fn a_window_and_a_choice_of_signals_cut_the_file() {
    let design = design(&[]);
    let folder = tempfile::tempdir().unwrap();
    let rows = samples(&design);
    let whole = ReadBack::open(&write(&design, Options::default(), &rows, folder.path()));
    let options = Options {
        cycles: Some(10..20),
        signals: vec!["x".to_owned(), "angles.*".to_owned()],
        ..Options::default()
    };
    let cut = ReadBack::open(&write(&design, options, &rows, folder.path()));
    let period = whole.times[2];
    assert_eq!((cut.times[0], *cut.times.last().unwrap()), (10 * period, 20 * period));
    assert!(
        cut.signals.contains_key("rotation.x") && cut.signals.contains_key("rotation.angles.delta")
    );
    assert!(!cut.signals.contains_key("rotation.y"));
    for at in 10..20 {
        for name in ["rotation.x", "rotation.x_value", "rotation.x_golden", "rotation.angles.ang_x"]
        {
            assert_eq!(cut.at(name, at * period), whole.at(name, at * period), "{name} at {at}");
        }
    }
    let error =
        Wave::new(&design, Options { signals: vec!["nothing".into()], ..Options::default() });
    assert!(error.unwrap_err().to_string().starts_with("no signal matches `nothing`"));
}

/// GTKWave itself decodes the words.
#[test]
#[ignore = "needs gtkwave and xvfb: testbenches/run installs them"]
fn gtkwave_decodes_words_as_the_save_file_tells_it() {
    let design = design(&["scheme=linear"]);
    let folder = tempfile::tempdir().unwrap();
    let rows = vec![vec![65_000, 8192, 1234, 7000]; 10];
    let path = write(&design, Options::default(), &rows, folder.path());
    let script = folder.path().join("script.tcl");
    let body = "gtkwave::setMarker 27000\n\
        for {set i 0} {$i < [gtkwave::getTotalNumTraces]} {incr i} {\n\
        puts \"TRACE [gtkwave::getTraceNameFromIndex $i] [gtkwave::getTraceValueAtMarkerFromIndex $i]\"\n}\n\
        gtkwave::/File/Quit\n";
    std::fs::write(&script, body).unwrap();
    let output = Command::new("timeout")
        .args(["120", "xvfb-run", "-a", "gtkwave", "-S"])
        .args([&script, &path, &path.with_extension("gtkw")])
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&output.stdout);
    let shown: BTreeMap<&str, &str> =
        text.lines().filter_map(|line| line.strip_prefix("TRACE ")?.rsplit_once(' ')).collect();
    let number = |name: &str| -> f64 {
        let value = shown.get(name).unwrap_or_else(|| panic!("GTKWave shows no {name}: {text}"));
        value.parse().unwrap_or_else(|_| panic!("{name} = {value}"))
    };
    let netlist = &design.netlist;
    let (reference, _) = netlist.eval(&rows[0]).unwrap();
    let x = netlist.outputs()[0].node;
    let value = netlist.node(x).format.value(reference[x.index()]);
    // A signed word by its fixed-point shift, a real twin, and an unsigned angle in turns and
    // degrees.
    assert_eq!(number("x[1:-16]"), value);
    assert_eq!(number("x_value"), value);
    assert_eq!(number("phi_a[15:0]"), 65_000.0 / 65_536.0);
    assert_eq!(number("phi_a_value_deg"), 360.0 * 65_000.0 / 65_536.0);
    assert_eq!(number("clk"), 1.0);
}
