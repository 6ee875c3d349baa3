//! What the commands print, as text and as JSON.

use super::sim::Sim;
use crate::base::{cast, json};
use crate::design::{Design, Kind, PIPELINE, Param, Unit, Values};
use crate::measure;
use crate::measure::{Basis, Cone, ConeReport, Figures, Profile, Report, Witness};
use crate::netlist::Netlist;
use crate::report::record::{Measured, Point, Record, json_of, parameters_of};
use crate::report::{Table, pareto};
use serde_json::{Map, Value, json};
use std::fmt::Write as _;
use std::path::Path;

pub(super) const BROKEN: &str = "a stated bound is BROKEN\n";

/// A table as text, for the terminal.
pub(super) fn table(headings: &[&str], rows: &[Vec<String>]) -> String {
    Table::new(headings, rows.to_vec()).text()
}

/// A number to three or four digits, in the form that is easiest to read.
pub(super) fn number(x: f64) -> String {
    if x == 0.0 {
        "0".to_owned()
    } else if (1e-2..1e5).contains(&x.abs()) {
        let digits = if x.abs() >= 100.0 {
            1
        } else if x.abs() >= 1.0 {
            3
        } else {
            4
        };
        format!("{x:.digits$}")
    } else {
        format!("{x:.2e}")
    }
}

/// A rate in millions per second.
fn rate(per_second: f64) -> String {
    format!("{:.1} M/s", per_second / 1e6)
}

/// A unit's own description of its ports, or the port names of its default design.
fn ports_of(unit: &Unit) -> (String, String) {
    if !unit.inputs.is_empty() || !unit.outputs.is_empty() {
        return (unit.inputs.clone(), unit.outputs.clone());
    }
    let Ok(design) = unit.defaults().build() else { return Default::default() };
    let netlist = &design.netlist;
    let inputs: Vec<&str> = (0..netlist.inputs().len()).map(|at| netlist.input_name(at)).collect();
    let outputs: Vec<&str> = netlist.outputs().iter().map(|port| port.name.as_str()).collect();
    (inputs.join(", "), outputs.join(", "))
}

/// A table of parameters.
fn parameter_table<'a>(params: impl IntoIterator<Item = &'a Param>) -> String {
    let row = |param: &Param| {
        let Param { name, default, help, .. } = param;
        vec![name.clone(), default.to_string(), param.kind.legal(), help.clone()]
    };
    let rows: Vec<Vec<String>> = params.into_iter().map(row).collect();
    if rows.is_empty() {
        return String::new();
    }
    table(&["parameter", "default", "legal", "meaning"], &rows)
}

/// Every unit in a line, and what all of them share.
pub(super) fn list(units: &[&Unit]) -> String {
    let row = |unit: &&Unit| vec![unit.name.clone(), unit.summary.clone()];
    let rows: Vec<Vec<String>> = units.iter().map(row).collect();
    format!(
        "{}\n`fixpath list UNIT` prints a unit's formula, ports and parameters. Every unit also has these parameters:\n\n{}",
        table(&["unit", "what it computes"], &rows),
        parameter_table(PIPELINE.iter())
    )
}

/// A unit's summary, source, ports, formula and parameters.
pub(super) fn list_unit(unit: &Unit) -> String {
    let mut text = format!("{}: {}\n", unit.name, unit.summary);
    if !unit.source.is_empty() {
        let _ = writeln!(text, "  source: {}", unit.source);
    }
    let (inputs, outputs) = ports_of(unit);
    let _ = writeln!(text, "  inputs: {inputs}\n  outputs: {outputs}");
    for (number, line) in unit.formula.lines().enumerate() {
        let _ = writeln!(text, "{}{line}", if number == 0 { "  formula: " } else { "           " });
    }
    text.push('\n');
    let own = parameter_table(&unit.params);
    if !own.is_empty() {
        text.push_str(&own);
        text.push_str("  a word has at most 63 bits: a setting that needs more is refused\n");
    }
    text.push_str("  plus the pipeline parameters, which `fixpath list` prints\n");
    text
}

pub(super) fn list_json(units: &[&Unit]) -> Value {
    let param = |param: &Param| {
        let default = json_of(&param.default);
        let mut entry = json!({
            "name": param.name, "role": param.role.name(), "default": default,
            "legal": param.kind.legal(), "help": param.help,
        });
        let extra = match &param.kind {
            Kind::Int { min, max, auto } => json!({"min": min, "max": max, "auto": auto.is_some()}),
            Kind::Real { min, max } => json!({"min": min, "max": max}),
            Kind::Choice(names) => {
                json!({ "choices": names.iter().map(|name| &**name).collect::<Vec<&str>>() })
            }
        };
        let fields = entry.as_object_mut().expect("bug: an object");
        fields.extend(extra.as_object().expect("bug: an object").clone());
        entry
    };
    let unit = |unit: &&Unit| {
        let (inputs, outputs) = ports_of(unit);
        json::document(
            "unit",
            json!({
                "name": unit.name,
                "summary": unit.summary,
                "source": unit.source,
                "formula": unit.formula,
                "inputs": inputs,
                "outputs": outputs,
                "parameters": unit.all_params().map(param).collect::<Vec<_>>(),
            }),
        )
    };
    Value::Array(units.iter().map(unit).collect())
}

pub(super) fn parameters(values: &Values) -> Value {
    Value::Object(parameters_of(values))
}

pub(super) fn parameter_line(values: &Values) -> String {
    let pairs: Vec<String> = values.told().map(|(name, value)| format!("{name}={value}")).collect();
    pairs.join(" ")
}

/// The input words of a witness, such as `phi_a=12 theta_a=7`.
fn witness(netlist: &Netlist, witness: &Witness) -> String {
    let port = |i: usize| format!("{}={}", netlist.input_name(i), witness.words[i]);
    let words: Vec<String> = (0..witness.words.len()).map(port).collect();
    words.join(" ")
}

pub(super) fn sim(sim: &Sim) -> String {
    let (design, report) = (&sim.design, &sim.report);
    let netlist = &design.netlist;
    let mut text = format!("{} {}\n", design.values.unit().name, parameter_line(&design.values));
    let _ = writeln!(
        text,
        "{} samples, sampler {}{}; errors are absolute unless stated otherwise, with the input words of the worst\n",
        report.samples,
        sim.inputs.sampler.name(),
        if sim.inputs.sampler.is_random() {
            format!(", seed {}", sim.inputs.seed)
        } else {
            String::new()
        }
    );
    text.push_str(&figures(netlist, &report.figures));
    let told = |basis| report.figures.iter().any(|figures| figures.basis == basis);
    for basis in Basis::ALL.into_iter().filter(|basis| told(*basis)) {
        let _ = writeln!(text, "  {}: {}", basis.name(), basis.meaning());
    }
    if sim.design.groups.iter().any(|group| group.shape.is_direction()) {
        text.push_str("  dot: dot product of the result with any unit vector\n");
    }
    for (quantity, what) in sim.design.scales() {
        let _ = writeln!(text, "  {quantity}: relative to {what}");
    }
    text.push_str("  percentiles are accurate to 1.6 %; 0 means below 2^-44\n");
    for figures in sim.without_value() {
        let (basis, quantity) = (figures.basis.name(), &figures.quantity);
        let _ = writeln!(
            text,
            "{basis} {quantity}: NO VALUE at some input: a pole, or a root or logarithm of a negative number"
        );
    }
    text.push_str(&overflows(report));
    if !sim.hard.is_empty() {
        text.push('\n');
        text.push_str(&hard_cases(sim));
    }
    text.push('\n');
    for bound in &sim.bounds.stated {
        let verdict = if bound.holds(report) { "holds" } else { "IS BROKEN" };
        let _ = writeln!(
            text,
            "stated bound on {}: {}; seen {}: {verdict}",
            bound.subject(),
            number(bound.bound),
            number(bound.seen(report))
        );
    }
    if let Some(inputs) = &sim.bounds.inputs {
        let _ = writeln!(text, "bounds hold for {inputs}");
    }
    if let Some(why) = &sim.bounds.why_none {
        let _ = writeln!(text, "no bound is stated: {why}");
    }
    let _ = writeln!(text, "{}", speed(report));
    text
}

/// Figures in a table, with the input words of the worst.
fn figures(netlist: &Netlist, all: &[Figures]) -> String {
    let row = |f: &Figures| {
        let (scale, unit) = if f.unit == "rad" { (1f64.to_degrees(), "°") } else { (1.0, "") };
        let show = |x: f64| format!("{}{unit}", number(x * scale));
        vec![
            f.basis.name().to_owned(),
            f.quantity.clone(),
            show(f.max),
            f.max_ulp.map(number).unwrap_or_default(),
            show(f.mean),
            show(f.bias),
            show(f.rms),
            show(f.p50),
            show(f.p99),
            show(f.p999),
            f.witness.as_ref().map(|w| witness(netlist, w)).unwrap_or_default(),
        ]
    };
    let rows: Vec<Vec<String>> = all.iter().map(row).collect();
    table(
        &[
            "basis",
            "error of",
            ">max",
            ">max ulp",
            ">mean",
            ">bias",
            ">rms",
            ">p50",
            ">p99",
            ">p99.9",
            "worst input",
        ],
        &rows,
    )
}

/// The `narrow`s that overflowed, if any did.
fn overflows(report: &Report) -> String {
    if report.overflows.is_empty() {
        return String::new();
    }
    let rows: Vec<Vec<String>> = report
        .overflows
        .iter()
        .map(|o| vec![o.node.clone(), o.mode.to_owned(), o.count.to_string()])
        .collect();
    format!("\nnarrows that overflowed\n{}", table(&["node", "mode", ">count"], &rows))
}

/// A node over every combination of the words that it depends on.
pub(super) fn cone(design: &Design, cone: &Cone, measured: &ConeReport) -> String {
    let (netlist, report) = (&design.netlist, &measured.report);
    let ports: Vec<&str> = cone.ports.iter().map(|port| netlist.input_name(*port)).collect();
    let over = if ports.is_empty() {
        "it depends on no port".to_owned()
    } else {
        format!("every combination of the words of {}", ports.join(", "))
    };
    let mut text = format!(
        "{} {}\n{} samples: {over}; errors of {} are absolute, with the input words of the worst (ports that it doesn't depend on are 0)\n\n{}",
        design.values.unit().name,
        parameter_line(&design.values),
        report.samples,
        netlist.label(cone.node),
        figures(netlist, &report.figures),
    );
    text.push_str(
        "  arithmetic: bit-true against the netlist on reals, for the same words; the golden model has no inner nodes\n  \
           percentiles are accurate to 1.6 %; 0 means below 2^-44\n",
    );
    if measured.past_format > 0 {
        let _ = writeln!(
            text,
            "  left out: {} samples whose value on reals is outside the node's format, such as at poles; words saturate there",
            measured.past_format
        );
    }
    text + &overflows(report) + "\n" + &speed(report) + "\n"
}

/// The same as JSON.
pub(super) fn cone_json(design: &Design, cone: &Cone, measured: &ConeReport) -> Value {
    let (netlist, report) = (&design.netlist, &measured.report);
    json::document(
        "cone",
        json!({
            "unit": design.values.unit().name,
            "parameters": parameters(&design.values),
            "cone": netlist.label(cone.node),
            "inputs": {
                "sampler": "exhaustive",
                "samples": report.samples,
                "left_out_past_format": measured.past_format,
                // The fastest-changing port first; a witness has words of all ports of the unit.
                "counted": cone.ports.iter().map(|port| netlist.input_name(*port)).collect::<Vec<_>>(),
                "ports": (0..netlist.inputs().len()).map(|i| netlist.input_name(i)).collect::<Vec<_>>(),
            },
            "figures": report.figures,
            "overflows": report.overflows,
            "speed": report.speed,
        }),
    )
}

/// Share of time of each part of a measurement.
pub(super) fn profile(profile: &Profile) -> String {
    let parts = profile.parts();
    let total: f64 = parts.iter().map(|(_, seconds)| seconds).sum();
    if total == 0.0 {
        return "nothing was measured, so there are no times\n".to_owned();
    }
    let share = |(name, seconds): &(&str, f64)| format!("{name} {:.1} %", 100.0 * seconds / total);
    let shares: Vec<String> = parts.iter().map(share).collect();
    format!("time of all threads, {total:.2} s: {}\n", shares.join(", "))
}

/// The hard-case table with its verdicts.
pub(super) fn hard_cases(sim: &Sim) -> String {
    let mut text =
        format!("hard cases of {}, the worst of each group\n", parameter_line(&sim.design.values));
    let vector = |v: &[f64]| {
        let numbers: Vec<String> = v.iter().map(|x| format!("{x:.5}")).collect();
        format!("({})", numbers.join(", "))
    };
    let rows: Vec<Vec<String>> = sim
        .hard
        .iter()
        .map(|case| {
            vec![
                case.name.clone(),
                case.cases.to_string(),
                case.worst.words.iter().map(ToString::to_string).collect::<Vec<_>>().join(","),
                vector(&case.worst.fixed),
                case.worst.float32.as_deref().map(vector).unwrap_or_default(),
                vector(&case.worst.float64),
                case.worst.quantity.clone(),
                number(case.worst.error),
                case.float32_worst.map(number).unwrap_or_default(),
                match case.holds {
                    None => "no bound",
                    Some(true) => "ok",
                    Some(false) => "BROKEN",
                }
                .to_owned(),
            ]
        })
        .collect();
    text.push_str(&table(
        &[
            "case",
            ">cases",
            "words",
            "fixed",
            "f32",
            "f64",
            "error of",
            ">error",
            ">worst f32 error",
            "verdict",
        ],
        &rows,
    ));
    let columns = measure::hard_columns(&sim.design).join(", ");
    let _ = writeln!(
        text,
        "  fixed, f32, f64: ({columns}); errors are absolute, against f64, for angles in rad; of several quantities, the one nearest to its bound is shown"
    );
    if sim.design.golden_f32.is_none() {
        text.push_str("  f32 is not judged: the unit has no golden model in f32\n");
    }
    text
}

fn speed(report: &Report) -> String {
    let speed = &report.speed;
    format!(
        "engine {} a thread; whole measurement {} on {} threads",
        rate(speed.engine_samples_per_second_per_thread),
        rate(speed.samples_per_second),
        speed.threads
    )
}

pub(super) fn sim_json(sim: &Sim) -> Value {
    let (design, report) = (&sim.design, &sim.report);
    let stated = sim.bounds.stated.iter().map(|bound| {
        json!({
            "quantity": bound.quantity,
            "of": bound.of,
            "over": bound.over,
            "bound": json::number(bound.bound),
            "seen": json::number(bound.seen(report)),
            "holds": bound.holds(report),
        })
    });
    let stated: Vec<Value> = stated.collect();
    let mut value = json::document(
        "sim",
        json!({
            "unit": design.values.unit().name,
            "parameters": parameters(&design.values),
            "inputs": {
                "sampler": sim.inputs.sampler.name(),
                "samples": report.samples,
                "seed": sim.inputs.sampler.is_random().then_some(sim.inputs.seed),
                "ports": (0..design.netlist.inputs().len()).map(|i| design.netlist.input_name(i)).collect::<Vec<_>>(),
            },
            "counts": design.netlist.counts(),
            "figures": report.figures,
            "overflows": report.overflows,
            // The first bound also on its own: a field from when units had one bound.
            "bound": stated.first().map_or_else(|| json!({
                "quantity": null, "of": [], "over": null, "bound": null, "seen": null, "holds": null,
            }), Clone::clone),
            "bounds": stated,
            "bounds_hold_for": sim.bounds.inputs,
            "why_no_bound": sim.bounds.why_none,
        }),
    );
    let fields: &mut Map<String, Value> = value.as_object_mut().expect("bug: an object");
    if !sim.hard.is_empty() {
        fields.insert("hard_cases".to_owned(), json!(sim.hard));
    }
    // Last and separate: the only figures that differ from run to run.
    fields.insert("speed".to_owned(), json!(report.speed));
    value
}

/// Angle figures of one basis on one line, for the demo.
pub(super) fn angle_line(report: &Report, basis: Basis) -> String {
    let f = report.figures("angle", basis);
    format!("mean {}°, max {}°", number(f.mean.to_degrees()), number(f.max.to_degrees()))
}

/// Summary of a sweep, and its best points.
pub(super) fn sweep(record: &Record, out: &Path) -> String {
    let measured: Vec<(&Point, &Measured)> =
        record.points.iter().filter_map(|p| Some((p, p.measured.as_ref()?))).collect();
    let failed = record.points.len() - measured.len();
    let mut text = format!("{} points, {failed} failed\n", record.points.len());
    if let Some(error) = record.points.iter().find_map(|point| point.error.as_ref()) {
        let _ = writeln!(text, "the first failure: {error}");
    }
    if let Some(coverage) = record.coverage() {
        let _ = writeln!(text, "{coverage}");
    }
    let rom = |m: &Measured| cast::f64_of_count(m.count("rom_bits_dual_port").unwrap_or_default());
    let (basis, lead) = (record.ranking(), record.lead());
    let image = record.header.scene.is_some();
    let symbol = if lead.unit == "deg" { "°" } else { "" };
    let costs: Vec<(f64, f64)> =
        measured.iter().map(|(_, m)| (rom(m), record.error(m, basis))).collect();
    let axes: Vec<&str> = record.header.axes.iter().map(|axis| axis.key.as_str()).collect();
    let rows: Vec<Vec<String>> = pareto(&costs)
        .into_iter()
        .map(|i| {
            let (point, m) = measured[i];
            let mut row: Vec<String> = axes.iter().map(|key| point.text(key)).collect();
            row.extend([format!("{}{symbol}", number(record.error(m, basis))), rom(m).to_string()]);
            row
        })
        .collect();
    let ranked = if image {
        format!("{} ({}) against the golden picture", lead.what, lead.unit)
    } else {
        format!("worst {} ({} error)", lead.quantity, basis.name())
    };
    let _ = writeln!(
        text,
        "Pareto-optimal points by {ranked} and ROM bits (one copy per two read ports)"
    );
    let mut headings = axes;
    let worst = if image { format!(">{}", lead.what) } else { format!(">worst {}", lead.quantity) };
    headings.extend([worst.as_str(), ">ROM bits"]);
    text.push_str(&table(&headings, &rows));
    let _ = writeln!(text, "see {}", out.join("report.md").display());
    text
}
