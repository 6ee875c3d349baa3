//! `fixpath show`: a design's ports, tables, operators and netlist.

use super::text::{number, parameter_line, parameters, table};
use crate::base::error::Result;
use crate::base::json;
use crate::design::Design;
use crate::measure;
use crate::netlist::{Netlist, Node, Operators, Rate, SchemeChoice, Table};
use crate::schedule::stage_sizes;
use crate::table::figures::TableFigures;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::sync::Arc;

/// Ports as a table and as JSON; the table has rates if there are any but the default.
fn ports(netlist: &Netlist) -> (String, Value) {
    let inputs = netlist.inputs().iter().enumerate();
    let inputs = inputs.map(|(port, id)| ("in", netlist.input_name(port), netlist.node(*id)));
    let outputs = netlist.outputs().iter();
    let outputs = outputs.map(|output| ("out", &output.name[..], netlist.node(output.node)));
    let rates = netlist.rates();
    let fastest = rates[rates.len() - 1];
    // An output has a word for each sample.
    let rate = |way: &str, node: &Node| if way == "in" { node.rate } else { fastest };
    let (mut rows, mut json) = (Vec::new(), Vec::new());
    for (way, name, node) in inputs.chain(outputs) {
        let (format, quantity) = (node.format.to_string(), node.quantity.name());
        let rate = rate(way, node).name();
        rows.push(vec![way.to_owned(), name.to_owned(), format.clone(), quantity.to_owned()]);
        if rates != [Rate::default()] {
            rows.last_mut().expect("bug: pushed above").push(rate.to_owned());
        }
        json.push(json!({
            "direction": way, "name": name, "format": format, "quantity": quantity, "rate": rate,
        }));
    }
    let headings = ["", "name", "format", "quantity", "rate"];
    let columns = rows.first().map_or(0, Vec::len);
    (table(&headings[..columns], &rows), Value::Array(json))
}

/// Exact statistics of every table scheme that is small enough to enumerate.
fn tables(design: &Design) -> Result<Vec<TableFigures>> {
    let mut all = Vec::new();
    for tabulated in &design.tabulated {
        all.extend(measure::table_figures(tabulated)?.unwrap_or_default());
    }
    Ok(all)
}

fn columns_of(table: &Table) -> String {
    let columns = table.columns.iter().map(|column| format!("{} {}", column.name, column.format));
    columns.collect::<Vec<_>>().join(", ")
}

fn memory_row(memory: &Table) -> Vec<String> {
    vec![
        memory.name.clone(),
        (1u64 << memory.addr_bits).to_string(),
        memory.rom_bits().to_string(),
        columns_of(memory),
        memory.memory.map_or(0, |memory| memory.latency).to_string(),
        if memory.is_unbound() { "none" } else { "bound" }.to_owned(),
    ]
}

pub(super) fn show(design: &Design) -> Result<String> {
    let netlist = &design.netlist;
    let rtl = Arc::new(design.rtl()?);
    let counts = netlist.counts();
    let unit = design.values.unit();
    let mut text = format!("{}: {}\n", unit.name, unit.summary);
    let _ = writeln!(text, "  {}\n\nports", parameter_line(&design.values));
    text.push_str(&ports(netlist).0);

    let operators = |name: &str, o: Operators| {
        let counts = [
            o.multipliers,
            o.adders,
            o.negations,
            o.comparators,
            o.multiplexers,
            o.shifters,
            o.narrows,
            o.rounders,
        ];
        let mut row = vec![name.to_owned()];
        row.extend(counts.map(|count| count.to_string()));
        row
    };
    let parts = [
        (counts.dividers, "dividers"),
        (counts.square_roots, "square roots"),
        (counts.reciprocal_roots, "reciprocal square roots"),
    ];
    let mut rows =
        vec![operators("datapath", counts.datapath), operators("table schemes", counts.schemes)];
    if counts.parts != Operators::default() {
        rows.push(operators("dividers, roots", counts.parts));
    }
    text.push_str("\noperators\n");
    text.push_str(&table(
        &[
            "",
            ">mul",
            ">add/sub",
            ">neg/abs",
            ">compare",
            ">mux",
            ">shift",
            ">narrow",
            ">of which round",
        ],
        &rows,
    ));
    if parts.iter().any(|(count, _)| *count > 0) {
        let parts = parts.iter().filter(|(count, _)| *count > 0);
        let parts: Vec<String> = parts.map(|(count, name)| format!("{count} {name}")).collect();
        let _ = writeln!(text, "  each counted as one: {}", parts.join(", "));
    }

    let _ = writeln!(
        text,
        "\ntables: {}; words read {}, ports {}; ROM {} bits, {} with one copy per two read ports",
        counts.tables, counts.reads, counts.ports, counts.rom_bits, counts.rom_bits_dual_port
    );
    let mut rows = Vec::new();
    for t in netlist.roms() {
        rows.push(vec![
            t.name.clone(),
            (1u64 << t.addr_bits).to_string(),
            t.rom_bits().to_string(),
            columns_of(t),
        ]);
    }
    text.push_str(&table(&["name", ">entries", ">bits", "columns"], &rows));
    if counts.memories > 0 {
        let _ = writeln!(
            text,
            "\nmemories (-p memory.NAME=FILE.csv binds their words): {}; ports {}; {} bits",
            counts.memories, counts.memory_ports, counts.memory_bits
        );
        let rows: Vec<Vec<String>> = netlist.memories().map(memory_row).collect();
        text.push_str(&table(
            &["name", ">entries", ">bits", "columns", ">latency in cycles", "words"],
            &rows,
        ));
    }

    let figures = tables(design)?;
    if !figures.is_empty() {
        text.push_str(
            "\ntable schemes over every argument word, against the function saturated to the output format\n",
        );
        let rows: Vec<Vec<String>> = figures
            .iter()
            .map(|f| {
                vec![
                    format!("{}.{}", f.table, f.function),
                    number(f.worst),
                    number(f.worst_ulp),
                    format!("{} (word {})", number(f.witness), f.witness_raw),
                    number(f.jump),
                    f.not_monotone.to_string(),
                ]
            })
            .collect();
        text.push_str(&table(
            &["function", ">worst", ">ulp", "at", ">largest jump", ">not monotone"],
            &rows,
        ));
    }
    let unjudged = design.tabulated.len()
        - design.tabulated.iter().filter(|t| figures.iter().any(|f| f.table == t.name)).count();
    if unjudged > 0 {
        let _ = writeln!(
            text,
            "  {unjudged} more have arguments of more than {} bits: too many words to enumerate",
            measure::TABLE_ARGUMENT_BITS
        );
    }

    if !netlist.choices().is_empty() {
        text.push_str("\nformats, set with -p format.NODE=…\n");
        let rows: Vec<Vec<String>> = netlist
            .choices()
            .iter()
            .map(|choice| {
                let set = if choice.overridden { "set" } else { "" };
                vec![choice.name.clone(), choice.format.to_string(), set.to_owned()]
            })
            .collect();
        text.push_str(&table(&["node", "format", ""], &rows));
    }

    if !netlist.schemes().is_empty() {
        text.push_str("\nschemes, set with -p scheme.TABLE=…\n");
        let row = |choice: &SchemeChoice| {
            let set = if choice.overridden { "set" } else { "" };
            vec![choice.table.clone(), choice.scheme.clone(), set.to_owned()]
        };
        let rows: Vec<Vec<String>> = netlist.schemes().iter().map(row).collect();
        text.push_str(&table(&["table", "scheme", ""], &rows));
    }

    let schedule = rtl.schedule();
    let _ = writeln!(
        text,
        "\npipeline: latency {} cycles, {} register bits, tables read {}, {} ps by the delay model (target {} ps)",
        schedule.latency(),
        rtl.register_bits(),
        if schedule.rom() == crate::schedule::Rom::Block {
            "on a clock"
        } else {
            "without a clock"
        },
        schedule.period_ps(),
        design.values.get("period_ps"),
    );
    text.push_str(&super::schedule::rates(&rtl));
    let sizes: Vec<String> =
        stage_sizes(netlist, schedule).iter().map(ToString::to_string).collect();
    let _ = writeln!(text, "  nodes per stage: {}", sizes.join(" "));
    if schedule.interval() > 1 || !rtl.units().is_empty() {
        let _ = writeln!(
            text,
            "  time-shared: a sample every {} cycles, {} units for {} operations; the operators above are the \
             netlist's, the hardware has {}; `fixpath schedule` prints the schedule",
            schedule.interval(),
            rtl.units().len(),
            schedule.units().iter().map(|unit| unit.operations.len()).sum::<usize>(),
            super::schedule::told(&rtl.counts().operators),
        );
    }
    text.push_str(&super::cost::estimates(&rtl));
    text.push('\n');
    text.push_str(&netlist.to_text());
    Ok(text)
}

pub(super) fn show_json(design: &Design) -> Result<Value> {
    let netlist = &design.netlist;
    let rtl = Arc::new(design.rtl()?);
    let schedule = rtl.schedule();
    let table = |t: &Table| {
        let columns: Vec<Value> = t
            .columns
            .iter()
            .map(|column| json!({"name": column.name, "format": column.format.to_string()}))
            .collect();
        json!({"name": t.name, "entries": 1u64 << t.addr_bits, "rom_bits": t.rom_bits(), "columns": columns})
    };
    let memory = |t: &Table| {
        let mut json = table(t);
        json["latency_cycles"] = t.memory.map_or(0, |memory| memory.latency).into();
        json["bound"] = (!t.is_unbound()).into();
        json
    };
    let format = |choice: &crate::netlist::Choice| json!({"node": choice.name, "format": choice.format.to_string(), "set": choice.overridden});
    let scheme = |choice: &SchemeChoice| json!({"table": choice.table, "scheme": choice.scheme, "set": choice.overridden});
    let node = |id| {
        let node = netlist.node(id);
        json!({
            "label": netlist.label(id),
            "op": node.op.name(),
            "operands": node.operands.iter().map(|id| id.index()).collect::<Vec<_>>(),
            "format": node.format.to_string(),
            "stage": schedule.stage(id),
        })
    };
    Ok(json::document(
        "show",
        json!({
            "unit": design.values.unit().name,
            "parameters": parameters(&design.values),
            "ports": ports(netlist).1,
            "counts": netlist.counts(),
            "tables": netlist.roms().map(table).collect::<Vec<_>>(),
            "memories": netlist.memories().map(memory).collect::<Vec<_>>(),
            "table_schemes": tables(design)?,
            "formats": netlist.choices().iter().map(format).collect::<Vec<_>>(),
            "schemes": netlist.schemes().iter().map(scheme).collect::<Vec<_>>(),
            "pipeline": {
                "latency_cycles": schedule.latency(),
                "interval_cycles": schedule.interval(),
                "rates": super::schedule::rates_json(&rtl),
                "flip_flops": rtl.register_bits(),
                "model_period_ps": schedule.period_ps(),
                "rom": schedule.rom().to_string(),
                "nodes_per_stage": stage_sizes(netlist, schedule),
            },
            "hardware": rtl.counts(),
            "cost_estimate": super::cost::estimates_json(&rtl),
            "nodes": netlist.ids().map(node).collect::<Vec<_>>(),
            "outputs": netlist.outputs().iter().map(|o| json!({"name": o.name, "node": o.node.index()})).collect::<Vec<_>>(),
        }),
    ))
}
