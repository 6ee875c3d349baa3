//! `fixpath schedule`: a time-shared schedule in the layout of the table in US 6,980,218.

use super::options::UnitArgs;
use super::text;
use crate::base::error::Result;
use crate::base::json;
use crate::design::Design;
use crate::hardware::rtl::{HardwareCounts, Rtl};
use crate::hardware::timetable::Timetable;
use crate::netlist::{Counts, Rate};
use clap::Args;
use serde_json::{Value, json};
use std::fmt::Write as _;

#[derive(Args)]
pub(super) struct ScheduleArgs {
    #[command(flatten)]
    unit: UnitArgs,
    /// As JSON.
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: &ScheduleArgs) -> Result<String> {
    let design = args.unit.design()?;
    let rtl = design.rtl()?;
    let table = Timetable::new(&rtl, design.printed());
    Ok(if args.json {
        json::text(&as_json(&design, &rtl, &table))
    } else {
        as_text(&design, &rtl, &table)
    })
}

/// Operators of a unit or of the whole design, summed over datapath, table schemes and parts.
fn operators(counts: &Counts) -> Vec<(&'static str, u64)> {
    let sum = |of: fn(&crate::netlist::Operators) -> u64| {
        of(&counts.datapath) + of(&counts.schemes) + of(&counts.parts)
    };
    vec![
        ("multipliers", sum(|o| o.multipliers)),
        ("adders", sum(|o| o.adders)),
        ("negations", sum(|o| o.negations)),
        ("comparators", sum(|o| o.comparators)),
        ("multiplexers", sum(|o| o.multiplexers)),
        ("shifters", sum(|o| o.shifters)),
        ("rounders", sum(|o| o.rounders)),
        ("table ports", counts.ports),
    ]
}

/// The operators that occur, in words.
pub(super) fn told(counts: &Counts) -> String {
    let some = operators(counts).into_iter().filter(|(_, count)| *count > 0);
    let text: Vec<String> = some.map(|(name, count)| format!("{count} {name}")).collect();
    if text.is_empty() { "wires".to_owned() } else { text.join(", ") }
}

/// When words of each rate enter, if ports have several rates.
pub(super) fn rates(rtl: &Rtl) -> String {
    let timings = rtl.schedule().timings();
    if timings.len() < 2 {
        return String::new();
    }
    let ports = |rate: Rate| {
        let netlist = rtl.netlist();
        let ports = netlist.inputs().iter().enumerate();
        let ports = ports.filter(|(_, id)| netlist.node(**id).rate == rate);
        ports.map(|(port, _)| netlist.input_name(port)).collect::<Vec<_>>().join(", ")
    };
    let rows: Vec<Vec<String>> = timings
        .iter()
        .map(|timing| {
            vec![
                timing.rate.to_string(),
                ports(timing.rate),
                timing.entry.to_string(),
                timing.latency.to_string(),
                timing.interval.to_string(),
            ]
        })
        .collect();
    let mut text = String::from(
        "\nrates, in cycles: a slow word applies to every faster word that enters a latency later or after, until the next slow word is held\n",
    );
    text.push_str(&text::table(&["rate", "ports", ">entry", ">latency", ">interval"], &rows));
    text
}

pub(super) fn rates_json(rtl: &Rtl) -> Value {
    let timings = rtl.schedule().timings().into_iter();
    let json = timings.map(|timing| {
        json!({
            "rate": timing.rate.name(), "entry_cycle": timing.entry,
            "latency_cycles": timing.latency, "interval_cycles": timing.interval,
        })
    });
    Value::Array(json.collect())
}

/// Chains of hold registers, the longest first: name, registers, bits of each.
fn fifos(rtl: &Rtl) -> Vec<(String, usize, u32)> {
    let netlist = rtl.netlist();
    let chains = netlist.ids().map(|id| (id, rtl.registers(id).count()));
    let mut fifos: Vec<(String, usize, u32)> = chains
        .filter(|(_, registers)| *registers > 1)
        .map(|(id, registers)| (netlist.label(id), registers, netlist.node(id).format.bits()))
        .collect();
    fifos.sort_by(|a, b| b.1.cmp(&a.1).then_with(|| a.0.cmp(&b.0)));
    fifos
}

/// For each set of units: kind, units, operations and interval; then, with one more unit, the
/// shortest interval of the set and of the whole design.
fn one_more(rtl: &Rtl) -> Vec<(&'static str, usize, usize, u32, u32, u32)> {
    let loads = &rtl.schedule().loads();
    let others = |at: usize| {
        let same = move |(other, load): &(usize, &crate::schedule::Load)| {
            *other != at && load.rate == loads[at].rate
        };
        let others = loads.iter().enumerate().filter(same);
        others.map(|(_, load)| load.interval()).max().unwrap_or(1)
    };
    let row = |(at, load): (usize, &crate::schedule::Load)| {
        let more = load.interval_with(1);
        (
            load.kind.name(),
            load.units.len(),
            load.operations.len(),
            load.interval(),
            more,
            more.max(others(at)),
        )
    };
    loads.iter().enumerate().map(row).collect()
}

fn as_text(design: &Design, rtl: &Rtl, table: &Timetable) -> String {
    let (schedule, counts) = (rtl.schedule(), rtl.counts());
    let unit = design.values.unit();
    let mut text = format!("{}: {}\n", unit.name, unit.summary);
    let _ = writeln!(text, "  {}\n", text::parameter_line(&design.values));
    if rtl.units().is_empty() {
        let remedy = match design.values.choice("schedule") {
            "shared" => "the netlist has no two operations of a kind that share_…=N names",
            _ => "use schedule=shared and share_…=N",
        };
        let _ = writeln!(
            text,
            "nothing is shared: a sample every {} cycles, {} cycles of latency; {remedy}",
            schedule.interval(),
            schedule.latency()
        );
        text.push_str(&rates(rtl));
        return text;
    }
    let rows = table.rows.iter().enumerate().map(|(cycle, cells)| {
        let mut row = vec![(cycle + 1).to_string()];
        row.extend(cells.iter().cloned());
        row
    });
    let mut headings = vec![">Cycle #"];
    headings.extend(table.titles.iter().map(String::as_str));
    text.push_str(&text::table(&headings, &rows.collect::<Vec<_>>()));

    let _ = writeln!(
        text,
        "\ninterval {} cycles (shortest for these units: {}), latency {} cycles: {} samples in flight; {} ps by the delay model",
        schedule.interval(),
        schedule.shortest_interval(),
        schedule.latency(),
        rtl.valid_bits_of(&schedule.fastest()),
        schedule.period_ps()
    );
    text.push_str(&rates(rtl));
    text.push_str("\nunits\n");
    let rows: Vec<Vec<String>> = units(rtl, table, &counts)
        .into_iter()
        .map(|u| {
            vec![
                u.name.clone(),
                if u.title == u.name { String::new() } else { u.title },
                u.latency.to_string(),
                format!("{} of {}", u.operations, u.interval),
                format!("{:.0} %", 100.0 * u.used),
                u.operand_bits.to_string(),
                u.unit_bits.to_string(),
                u.operators,
            ]
        })
        .collect();
    text.push_str(&text::table(
        &["unit", "", ">latency", ">phases", ">used", ">operand bits", ">bits inside", "operators"],
        &rows,
    ));
    text.push_str("\neffect of one more unit\n");
    let rows: Vec<Vec<String>> = one_more(rtl)
        .into_iter()
        .map(|(kind, units, operations, now, more, all)| {
            vec![
                kind.to_owned(),
                units.to_string(),
                operations.to_string(),
                now.to_string(),
                more.to_string(),
                all.to_string(),
            ]
        })
        .collect();
    text.push_str(&text::table(
        &[
            "kind",
            ">units",
            ">operations",
            ">shortest interval",
            ">with one more",
            ">of all units then",
        ],
        &rows,
    ));
    let _ = writeln!(text, "\nhardware: {}", told(&counts.operators));
    let _ = writeln!(
        text,
        "  {} flip-flops: {} in hold registers ({} of them in delay FIFOs), {}{} in operand registers, {} inside units, {} for the phase, the rest for valid bits and synchronous reads; {} multiplexer bits before units",
        counts.register_bits,
        counts.hold_bits,
        counts.fifo_bits,
        if counts.state_bits > 0 {
            format!("{} in delays, ", counts.state_bits)
        } else {
            String::new()
        },
        counts.operand_bits,
        counts.unit_bits,
        counts.phase_bits,
        counts.multiplexer_bits
    );
    let fifos = fifos(rtl);
    if !fifos.is_empty() {
        text.push_str("\ndelay FIFOs\n");
        let rows: Vec<Vec<String>> = fifos
            .into_iter()
            .map(|(name, depth, bits)| vec![name, depth.to_string(), bits.to_string()])
            .collect();
        text.push_str(&text::table(&["word", ">depth", ">bits"], &rows));
    }
    text
}

struct UnitLine {
    name: String,
    title: String,
    kind: &'static str,
    latency: u32,
    operations: usize,
    interval: u32,
    /// Share of the phases in which an operation is issued.
    used: f64,
    operand_bits: u64,
    unit_bits: u64,
    operators: String,
}

fn units(rtl: &Rtl, table: &Timetable, counts: &HardwareCounts) -> Vec<UnitLine> {
    let line = |(number, unit): (usize, &crate::hardware::rtl::Instance)| {
        let operations = rtl.operations(number).len();
        UnitLine {
            name: unit.name.clone(),
            title: table.titles[number].clone(),
            kind: unit.kind.name(),
            latency: unit.rtl.schedule().latency(),
            operations,
            interval: unit.interval,
            used: crate::base::cast::f64_of_len(operations) / f64::from(unit.interval),
            operand_bits: unit.operand_bits(),
            unit_bits: unit.rtl.data_bits(),
            operators: told(&counts.units[&unit.name]),
        }
    };
    rtl.units().iter().enumerate().map(line).collect()
}

fn as_json(design: &Design, rtl: &Rtl, table: &Timetable) -> Value {
    let (schedule, counts) = (rtl.schedule(), rtl.counts());
    let operators = |counts: &Counts| {
        let pairs = operators(counts).into_iter();
        Value::Object(pairs.map(|(name, count)| (name.replace(' ', "_"), count.into())).collect())
    };
    let units: Vec<Value> = units(rtl, table, &counts)
        .into_iter()
        .enumerate()
        .map(|(number, u)| {
            let operations = rtl.operations(number).iter().zip(&table.names[number]);
            let operations = operations.map(|(operation, name)| {
                json!({
                    "label": operation.name, "result": name.result, "formula": name.formula,
                    "operands": name.operands, "issue_cycle": operation.issue + 1,
                    "out_cycle": operation.issue + u.latency + 1,
                })
            });
            json!({
                "name": u.name, "title": u.title, "kind": u.kind, "latency_cycles": u.latency,
                "operations": operations.collect::<Vec<_>>(), "utilisation": u.used,
                "operand_bits": u.operand_bits, "register_bits": u.unit_bits,
                "operators": operators(&counts.units[&u.name]),
            })
        })
        .collect();
    let more = one_more(rtl).into_iter().map(|(kind, units, operations, now, more, all)| {
        json!({
            "kind": kind, "units": units, "operations": operations, "shortest_interval": now,
            "with_one_more": more, "of_all_with_one_more": all,
        })
    });
    let fifos = fifos(rtl)
        .into_iter()
        .map(|(word, depth, bits)| json!({"word": word, "depth": depth, "bits": bits}));
    json::document(
        "schedule",
        json!({
            "unit": design.values.unit().name,
            "parameters": text::parameters(&design.values),
            "interval_cycles": schedule.interval(),
            "shortest_interval_cycles": schedule.shortest_interval(),
            "latency_cycles": schedule.latency(),
            "rates": rates_json(rtl),
            "model_period_ps": schedule.period_ps(),
            "table": {"units": table.titles, "rows": table.rows},
            "units": units,
            "one_more_unit": more.collect::<Vec<_>>(),
            "hardware": counts,
            "operators": operators(&counts.operators),
            "fifos": fifos.collect::<Vec<_>>(),
        }),
    )
}
