use super::*;
use crate::design::{Draw, Golden, Group, Shape};
use crate::measure::Basis;
use crate::netlist::{Builder, Quantity};
use crate::number::format::{Format, Overflow, Round};
use crate::units::built_in;
use serde_json::json;
use std::path::PathBuf;

const FEW: Inputs = Inputs { sampler: Sampler::Lit, samples: 500, seed: 1 };

fn axis(text: &str) -> Axis {
    Axis::parse(text, built_in("rotation")).unwrap()
}

fn values(text: &str) -> Vec<String> {
    axis(text).values().iter().map(Value::to_string).collect()
}

fn refused(text: &str) -> String {
    Axis::parse(text, built_in("rotation")).unwrap_err().to_string()
}

fn sweep(assignments: &[&str], axes: &[&str], inputs: Inputs) -> Sweep {
    let axes = axes.iter().map(|text| axis(text)).collect();
    Sweep::new(built_in("rotation").values(assignments).unwrap(), axes, inputs).unwrap()
}

fn run(sweep: &Sweep, folder: &Path) -> Result<Record> {
    sweep.run(folder, false, &|_| ())
}

/// Points without their times, which differ in every run.
fn timeless(record: &Record) -> Vec<serde_json::Value> {
    let strip = |point: &Point| {
        let mut point = serde_json::to_value(point).unwrap();
        if let Some(measured) = point["measured"].as_object_mut() {
            measured.remove("speed");
        }
        point
    };
    record.points.iter().map(strip).collect()
}

/// A small sweep that was run into a folder, and its `sweep.json`.
fn small() -> (tempfile::TempDir, Sweep, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let sweep = sweep(&[], &["table_addr_bits=6,8", "frac_bits=8..10"], FEW);
    run(&sweep, folder.path()).unwrap();
    let json = folder.path().join("sweep.json");
    (folder, sweep, json)
}

#[test]
fn axis_values() {
    assert_eq!(axis("frac_bits=8").key(), "frac_bits");
    assert_eq!(values("frac_bits=8"), ["8"]);
    assert_eq!(values("table_addr_bits=6..14:2"), ["6", "8", "10", "12", "14"]);
    assert_eq!(values("table_addr_bits=6..9:2"), ["6", "8"]);
    assert_eq!(values("table_addr_bits=6..8,10"), ["6", "7", "8", "10"]);
    assert_eq!(values("frac_bits=12, 9 .. 9 ,4"), ["12", "9", "4"]);
    assert_eq!(values("sincos_addr_bits=auto,6"), ["auto", "6"]);
    assert_eq!(values("variant=exact,printed"), ["exact", "printed"]);
    assert_eq!(values("frac_bits=2..32:18446744073709551615"), ["2"]);
    assert_eq!(values("period_ps=100..100099").len(), MAX_POINTS);
}

#[test]
fn axis_errors() {
    let cases = [
        ("frac_bits", "`frac_bits` is not of the form key=v,v,… or key=a..b or key=a..b:step"),
        (
            "frac_bit=8",
            "unit `rotation` has no parameter `frac_bit`, did you mean `frac_bits`: `fixpath list rotation` names them all",
        ),
        ("frac_bits=1", "parameter `frac_bits` = `1`: legal is 2 to 32"),
        ("frac_bits=8,x", "parameter `frac_bits` = `x`: legal is 2 to 32"),
        ("frac_bits=8..33", "parameter `frac_bits` = `33`: legal is 2 to 32"),
        ("frac_bits=..8", "parameter `frac_bits` = ``: legal is 2 to 32"),
        ("variant=exact,fast", "parameter `variant` = `fast`: legal is printed, corrected, exact"),
        (
            "variant=printed..exact",
            "`printed..exact`: `variant` is a name and has no ranges: write variant=v,v,…",
        ),
        ("sincos_addr_bits=auto..6", "`auto..6`: a range of `sincos_addr_bits` needs numbers"),
        (
            "frac_bits=",
            "axis `frac_bits=` has an empty value: write frac_bits=v,v,… or frac_bits=a..b",
        ),
        (
            "frac_bits=8,,9",
            "axis `frac_bits=8,,9` has an empty value: write frac_bits=v,v,… or frac_bits=a..b",
        ),
        ("frac_bits=8,6..9", "axis `frac_bits=8,6..9` has the value 8 twice"),
        ("frac_bits=08,8", "axis `frac_bits=08,8` has the value 8 twice"),
        ("frac_bits=9..8", "range `9..8` runs backwards: write 8..9"),
        ("frac_bits=8..9:0", "range `8..9:0` has the step `0`: a step is a whole number from 1"),
        ("frac_bits=8..9:-1", "range `8..9:-1` has the step `-1`: a step is a whole number from 1"),
        ("frac_bits=8..9:", "range `8..9:` has the step ``: a step is a whole number from 1"),
        ("format.x=16", "parameter `format.x` = `16`: legal is a format, such as s20f18 or u12f12"),
        ("format.x=s8f6..s9f6", "`s8f6..s9f6`: `format.x` has no ranges: write format.x=v,v,…"),
        (
            "scheme.sincos=lin",
            "parameter `scheme.sincos` = `lin`: legal is direct, linear, bipartite",
        ),
        ("memory.map=a.csv", "`memory.map` can't be swept: set it with -p memory.map=FILE"),
        (
            "period_ps=100..100100",
            "axis `period_ps=100..100100` has more than 100000 values: a sweep has at most 100000 points; use fewer values or a larger step",
        ),
    ];
    for (text, message) in cases {
        assert_eq!(refused(text), message);
    }
}

#[test]
fn grid_errors() {
    let new = |axes: &[&str], inputs| {
        let axes = axes.iter().map(|text| axis(text)).collect();
        Sweep::new(built_in("rotation").defaults(), axes, inputs).unwrap_err().to_string()
    };
    assert_eq!(
        new(&["frac_bits=8", "frac_bits=9"], FEW),
        "parameter `frac_bits` has two axes: put all its values in one, such as frac_bits=v,v,…"
    );
    assert_eq!(
        new(&["period_ps=100..50100", "variant=exact,printed"], FEW),
        "the grid has 50001 × 2 points: a sweep has at most 100000 points; use fewer values or a larger step"
    );
    assert_eq!(new(&[], Inputs { samples: 0, ..FEW }), "a sweep needs at least 1 sample");
}

#[test]
fn points_in_grid_order_and_on_disk() {
    let (folder, sweep, json) = small();
    let record = Record::load(&json).unwrap().unwrap();
    assert_eq!(record.header, sweep.header());
    let pairs: Vec<_> = record
        .points
        .iter()
        .map(|point| (point.text("table_addr_bits"), point.text("frac_bits")))
        .collect();
    let wanted = ["6 8", "6 9", "6 10", "8 8", "8 9", "8 10"].map(|pair| {
        let (a, b) = pair.split_once(' ').unwrap();
        (a.to_owned(), b.to_owned())
    });
    assert_eq!(pairs, wanted);
    let mut csv = csv::Reader::from_path(folder.path().join("sweep.csv")).unwrap();
    let names = csv.headers().unwrap().clone();
    let column = |name: &str| names.iter().position(|known| known == name).unwrap();
    assert_eq!((&names[0], &names[1]), ("table_addr_bits", "frac_bits"));
    assert_eq!(&names[names.len() - 1], "error");
    let (max, witness, ulp) =
        (column("angle_total_max_rad"), column("angle_total_witness"), column("x_total_max_ulp"));
    column("datapath_adders");
    column("scheme_multipliers");
    column("rom_bits_dual_port");
    column("dot_end_to_end_p999_abs");
    let rows: Vec<_> = csv.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), record.points.len());
    for (row, point) in rows.iter().zip(&record.points) {
        let measured = point.measured.as_ref().unwrap();
        assert_eq!(row[max].parse::<f64>().unwrap(), measured.lead_max(Basis::Total));
        assert!(row[witness].starts_with("phi_a=") && row[witness].contains(";theta_n="));
        assert!(row[ulp].parse::<f64>().unwrap() > 0.0);
    }
    let report = fs::read_to_string(folder.path().join("report.md")).unwrap();
    assert!(report.contains("6 measured, 0 failed"), "{report}");
    assert!(folder.path().join("error_vs_table.svg").exists());
}

#[test]
fn goes_on_where_it_was() {
    let (folder, sweep, json) = small();
    let whole = fs::read_to_string(&json).unwrap();
    let report = fs::read(folder.path().join("report.md")).unwrap();
    let mut record = Record::load(&json).unwrap().unwrap();
    let before = timeless(&record);
    // All points are there: nothing is measured again.
    run(&sweep, folder.path()).unwrap();
    assert_eq!(fs::read_to_string(&json).unwrap(), whole);
    assert_eq!(fs::read(folder.path().join("report.md")).unwrap(), report);
    // The second half is missing, and the rest is not in grid order.
    record.points.truncate(3);
    record.points.reverse();
    Record::write_json(&json, &record.header, record.points.iter()).unwrap();
    let first = std::sync::Mutex::new(None);
    let again = sweep
        .run(folder.path(), false, &|progress| {
            first.lock().unwrap().get_or_insert(progress);
        })
        .unwrap();
    let started = first.lock().unwrap().unwrap();
    assert_eq!((started.points_done, started.running, started.points), (3, 3, 6));
    assert_eq!(timeless(&again), before);
}

#[test]
fn another_sweep_is_refused() {
    let (folder, _, json) = small();
    let before = fs::read(&json).unwrap();
    let refused = |sweep: &Sweep| run(sweep, folder.path()).unwrap_err().to_string();
    let path = json.display();
    assert_eq!(
        refused(&sweep(
            &[],
            &["table_addr_bits=6,8", "frac_bits=8..10"],
            Inputs { seed: 2, ..FEW }
        )),
        format!(
            "{path}: holds another sweep: seed is 1 there and 2 here; choose another folder or pass --fresh"
        )
    );
    assert_eq!(
        refused(&sweep(&["scheme=linear"], &["frac_bits=8,9"], FEW)),
        format!(
            "{path}: holds another sweep: the grid is table_addr_bits=6,8 frac_bits=8,9,10 there and frac_bits=8,9 here, scheme is direct there and linear here; choose another folder or pass --fresh"
        )
    );
    assert_eq!(fs::read(&json).unwrap(), before);
    let other = sweep(&[], &["frac_bits=8,9"], FEW);
    let record = other.run(folder.path(), true, &|_| ()).unwrap();
    assert_eq!(record.points.len(), 2);
    assert!(!folder.path().join("error_vs_table.svg").exists());
}

#[test]
fn malformed_json_is_refused() {
    let (folder, sweep, json) = small();
    let whole = fs::read_to_string(&json).unwrap();
    let remedy = "choose another folder or pass --fresh";
    let refused = |text: &str| {
        fs::write(&json, text).unwrap();
        let message = run(&sweep, folder.path()).unwrap_err().to_string();
        assert!(message.starts_with(&json.display().to_string()), "{message}");
        assert!(message.ends_with(remedy), "{message}");
        message
    };
    assert!(refused("").contains("is not a sweep result that this version reads"));
    assert!(refused(&whole[..whole.len() / 2]).contains("EOF while parsing"));
    let mut value: serde_json::Value = serde_json::from_str(&whole).unwrap();
    value["points"][1]["measured"] = json!(null);
    assert!(refused(&value.to_string()).contains("point 2 is incomplete"));
    let mut value: serde_json::Value = serde_json::from_str(&whole).unwrap();
    value["points"][1] = value["points"][0].clone();
    assert!(refused(&value.to_string()).contains("has a point twice or outside its grid"));
    fs::remove_file(&json).unwrap();
    fs::create_dir(&json).unwrap();
    let message = run(&sweep, folder.path()).unwrap_err().to_string();
    assert!(message.contains("can't read") && message.ends_with(remedy), "{message}");
}

#[test]
fn a_group_gives_what_a_point_gives_alone() {
    for sampler in [Sampler::Lit, Sampler::Hard, Sampler::Exhaustive] {
        let axes = ["angle_bits=3,4", "variant=exact,corrected", "table_addr_bits=3,4"];
        check_alone(&sweep(&[], &axes, Inputs { sampler, ..FEW }), Inputs { sampler, ..FEW });
    }
}

#[test]
fn formats_and_schemes_are_axes() {
    let axes = ["format.x=s18f16,s8f6", "scheme.sincos=direct,linear"];
    let record = check_alone(&sweep(&["table_addr_bits=6"], &axes, FEW), FEW);
    let max = |index: usize| {
        let figures = &record.points[index].measured.as_ref().unwrap().figures;
        let is_x = |of: &&record::Figures| of.quantity == "x" && of.basis == Basis::Arithmetic;
        figures.iter().find(is_x).unwrap().max.0
    };
    // Six fraction bits lose up to 2^-7, more than tables of slopes do and less than tables of 64
    // words.
    let [direct, fine, _, coarse] = [0, 1, 2, 3].map(max);
    assert!(fine < 2f64.powi(-8) && coarse > 2f64.powi(-8), "{fine} {coarse}");
    assert!(direct > 2f64.powi(-6), "{direct}");
    let keys: Vec<&str> = record.header.axes.iter().map(|axis| &axis.key[..]).collect();
    assert_eq!(keys, ["format.x", "scheme.sincos"]);
    assert_eq!(record.points[2].text("format.x"), "s8f6");

    let folder = tempfile::tempdir().unwrap();
    let unknown = run(&sweep(&[], &["format.xx=s8f6"], FEW), folder.path()).unwrap_err();
    let why =
        "netlist `rotation` has no node `xx` whose format can be set: there are sincos, x, y, z";
    assert!(unknown.to_string().contains(why), "{unknown}");
}

/// A golden model that reads formats by name isn't shared by points that differ in them.
#[test]
fn goldens_of_formats_are_not_shared() {
    let unit = Unit::new("named", "").design(|values| {
        let mut b = values.builder("named");
        let input = b.input("a", Format::unsigned(8, 8)?, Quantity::Number);
        let word = b.narrow(input, Format::unsigned(6, 6)?, Round::Floor, Overflow::Saturate);
        b.name(word, "x");
        b.output("x", word);
        Ok(Design::new(values, b.build()?).golden(|values| {
            let is_coarse =
                values.iter().any(|(key, value)| key == "format.x" && value.to_string() == "u4f4");
            let offset = if is_coarse { 0.5 } else { 0.0 };
            Golden::each(move |[a]: [f64; 1]| [a + offset])
        }))
    });
    let axis = Axis::parse("format.x=u5f5,u4f4", &unit).unwrap();
    let record = check_alone(&Sweep::new(unit.defaults(), vec![axis], FEW).unwrap(), FEW);
    let max = |index: usize| record.points[index].measured.as_ref().unwrap().figures[0].max.0;
    assert!(max(0) < 0.1 && max(1) > 0.4, "{} {}", max(0), max(1));
}

/// Runs a sweep, and checks that each point has the same figures as on its own.
fn check_alone(sweep: &Sweep, inputs: Inputs) -> Record {
    let folder = tempfile::tempdir().unwrap();
    let record = run(sweep, folder.path()).unwrap();
    assert_eq!(record.points.len(), sweep.points());
    for (index, point) in record.points.iter().enumerate() {
        let design = sweep.point(index).build().unwrap();
        let alone = measure::measure(&[&design], &inputs, &|_| ()).unwrap().remove(0);
        let alone = Measured::new(&design, alone);
        let shared = point.measured.as_ref().unwrap();
        assert_eq!(shared.samples, alone.samples);
        assert_eq!(shared.figures, alone.figures, "{:?}", point.parameters);
        assert_eq!(shared.overflows, alone.overflows);
    }
    record
}

#[test]
fn points_that_cannot_be_built_are_recorded() {
    let folder = tempfile::tempdir().unwrap();
    let sweep = sweep(&[], &["output=polar-table,cartesian", "variant=printed,exact"], FEW);
    let record = run(&sweep, folder.path()).unwrap();
    let why = "parameter `output` = `cartesian`: legal is auto or polar-table when variant=printed";
    let errors: Vec<_> = record.points.iter().map(|point| point.error.as_deref()).collect();
    assert_eq!(errors, [None, None, Some(why), None]);
    assert!(record.points.iter().all(|p| p.error.is_some() != p.measured.is_some()));
    let report = fs::read_to_string(folder.path().join("report.md")).unwrap();
    let shown = why.replace('`', "\\`");
    assert!(report.contains(&format!("| cartesian, printed | {shown} |")), "{report}");
    let csv = fs::read_to_string(folder.path().join("sweep.csv")).unwrap();
    assert!(csv.contains(why), "{csv}");
}

/// A unit whose outputs are its input, in exactly the requested number of bits.
fn tight() -> Unit {
    Unit::new("tight", "").param(Param::bits("bits", 1..=8).default(8)).design(|values| {
        let mut b = Builder::new("tight");
        let input = b.input("a", Format::unsigned(8, 8)?, Quantity::Turns);
        let format = Format::unsigned(values.bits("bits"), 8)?;
        for name in ["x", "y", "z"] {
            let word = b.narrow(input, format, Round::Floor, Overflow::Error);
            b.output(name, word);
        }
        let netlist = b.build()?;
        let words = netlist.outputs().iter().map(|output| output.node).collect();
        Ok(Design::new(values, netlist)
            .groups(vec![Group::new("", Shape::Cartesian, words)])
            .golden(|_| Golden::each(|[a]: [f64; 1]| [a; 3]))
            // Not near 0, where a vector has no direction.
            .draw(|_, _| {
                Draw::new(|_, next, columns, count| {
                    columns[0] = (0..count).map(|_| 0.1 + 0.8 * next.draw()).collect()
                })
            }))
    })
}

#[test]
fn points_that_fail_a_check_are_recorded() {
    let folder = tempfile::tempdir().unwrap();
    let unit = tight();
    let axis = Axis::parse("bits=7,8,6", &unit).unwrap();
    let sweep = Sweep::new(unit.defaults(), vec![axis], FEW).unwrap();
    let record = run(&sweep, folder.path()).unwrap();
    for (point, bits) in record.points.iter().zip([7, 8, 6]) {
        assert_eq!(point.text("bits"), bits.to_string());
        match &point.error {
            Some(why) => {
                assert_ne!(bits, 8);
                assert!(why.contains("under overflow mode `error`"), "{why}");
            }
            // All words fit, so every error is 0, which has no logarithm.
            None => assert_eq!(
                (bits, point.measured.as_ref().unwrap().lead_max(Basis::Total)),
                (8, 0.0)
            ),
        }
    }
    let again = run(&sweep, folder.path()).unwrap();
    assert_eq!(timeless(&again), timeless(&record));
    let svg = fs::read_to_string(folder.path().join("error_vs_rom.svg")).unwrap();
    assert!(svg.contains("lower edge have zero error"));
}

#[test]
fn all_points_failing_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let sweep = sweep(&["variant=printed"], &["output=cartesian,polar-cordic"], FEW);
    assert_eq!(
        run(&sweep, folder.path()).unwrap_err().to_string(),
        "all 2 points failed, the first because parameter `output` = `cartesian`: legal is auto or polar-table when variant=printed"
    );
    assert!(folder.path().join("sweep.json").exists());
}

#[test]
fn numbers_that_json_cannot_write() {
    let (_folder, _, json) = small();
    let mut record = Record::load(&json).unwrap().unwrap();
    let figures = &mut record.points[0].measured.as_mut().unwrap().figures[0];
    assert_eq!((figures.quantity.as_str(), figures.basis), ("angle", Basis::Total));
    figures.max.0 = f64::NAN;
    figures.mean.0 = f64::INFINITY;
    figures.bias.0 = f64::NEG_INFINITY;
    figures.rms.0 = 0.1 + 0.2;
    Record::write_json(&json, &record.header, record.points.iter()).unwrap();
    let back = Record::load(&json).unwrap().unwrap();
    let figures = &back.points[0].measured.as_ref().unwrap().figures[0];
    assert!(figures.max.0.is_nan());
    assert_eq!((figures.mean.0, figures.bias.0), (f64::INFINITY, f64::NEG_INFINITY));
    assert_eq!(figures.rms.0.to_bits(), (0.1f64 + 0.2).to_bits());
    assert!(serde_json::from_str::<record::Real>("\"many\"").is_err());
}
