//! A sweep as Markdown.

use super::plot::Plot;
use super::record::{Record, plain};
use super::{Row, against, axis_names, axis_values, best, inputs, rows};
use crate::measure::Basis;
use std::fmt::Write;

/// The most rows of the table of points: `sweep.csv` has all.
const MAX_ROWS: usize = 1000;

/// The report.
pub(super) fn sweep(record: &Record, plots: &[Plot]) -> String {
    let rows = rows(record);
    let mut text = String::new();
    // Writing to a string can't fail.
    let _ = head(&mut text, record, rows.len());
    let _ = front(&mut text, record, &rows);
    for plot in plots {
        let _ = write!(text, "![{}]({})\n\n", plot.title, plot.file);
    }
    let _ = points(&mut text, record, &rows);
    let _ = failures(&mut text, record);
    text
}

fn head(text: &mut String, record: &Record, measured: usize) -> std::fmt::Result {
    let header = &record.header;
    writeln!(text, "# Sweep of `{}`\n", header.unit)?;
    writeln!(text, "fixpath {}.\n", header.crate_version)?;
    writeln!(text, "| swept | values |\n|---|---|")?;
    for axis in &header.axes {
        let values: Vec<String> = axis.values.iter().map(plain).collect();
        writeln!(text, "| `{}` | {} |", axis.key, values.join(", "))?;
    }
    let base: Vec<String> =
        header.base.iter().map(|(name, value)| format!("`{name}={}`", plain(value))).collect();
    writeln!(text, "\nFixed: {}.\n", base.join(", "))?;
    writeln!(text, "- Points: {} measured, {} failed.", measured, record.points.len() - measured)?;
    writeln!(text, "- Inputs: {}.", inputs(record))?;
    writeln!(
        text,
        "- Errors are absolute: the angle between vectors, here in degrees (`sweep.csv` and `sweep.json` have rad), and the difference of a number or a component, also in ulp of its port."
    )?;
    writeln!(
        text,
        "- *Total* is bit-true against the golden of the quantised inputs. It has two parts: *algorithm* is the netlist on reals against that golden, what the method does; *arithmetic* is bit-true against the netlist on reals, what words and tables do. *End-to-end* is bit-true against the golden of the inputs before quantisation."
    )?;
    writeln!(
        text,
        "- *Max* is the largest seen over these inputs; `sweep.json` names the input that gave it. Quantiles are known to 1.6 %."
    )?;
    writeln!(
        text,
        "- ROM bits count a table as often as it is copied for two ports per copy. Multipliers are those of the datapath + those inside table schemes. Engine speed is that of the bit-true simulation alone, per thread.\n"
    )
}

fn front(text: &mut String, record: &Record, rows: &[Row<'_>]) -> std::fmt::Result {
    writeln!(text, "## Pareto-optimal points\n")?;
    let lead = record.lead();
    writeln!(
        text,
        "By the largest {} error against {}: no other point is as good in both numbers and better in one.\n",
        lead.quantity,
        against(record)
    )?;
    let names = axis_names(record);
    writeln!(
        text,
        "| {} | max {} error ({}) | ROM bits |",
        if names.is_empty() { "unit" } else { &names },
        lead.quantity,
        lead.unit
    )?;
    writeln!(text, "|---|---:|---:|")?;
    for index in best(rows) {
        let row = &rows[index];
        let values = axis_values(record, row.point);
        writeln!(text, "| {values} | {} | {} |", short(row.error), row.rom_bits)?;
    }
    writeln!(text)
}

fn points(text: &mut String, record: &Record, rows: &[Row<'_>]) -> std::fmt::Result {
    writeln!(text, "## Points\n")?;
    let axes = &record.header.axes;
    for axis in axes {
        write!(text, "| {} ", axis.key)?;
    }
    let lead = record.lead();
    let unit = lead.unit;
    writeln!(
        text,
        "| end-to-end max ({unit}) | total max ({unit}) | total mean ({unit}) | total p99 ({unit}) | arithmetic max ({unit}) | algorithm mean ({unit}) | component max (ulp) | ROM bits | multipliers | latency (cycles) | engine (Msamples/s) |"
    )?;
    writeln!(
        text,
        "{}|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|",
        "|---".repeat(axes.len())
    )?;
    for row in rows.iter().take(MAX_ROWS) {
        for axis in axes {
            write!(text, "| {} ", row.point.text(&axis.key))?;
        }
        let error = |basis, get: fn(&super::record::Figures) -> f64| {
            let figures = row.measured.lead(basis);
            figures.map_or("-".to_owned(), |figures| short(get(figures) * lead.scale))
        };
        let count = |name| row.measured.count(name).unwrap_or(0);
        writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} + {} | {} | {} |",
            error(Basis::EndToEnd, |f| f.max.0),
            error(Basis::Total, |f| f.max.0),
            error(Basis::Total, |f| f.mean.0),
            error(Basis::Total, |f| f.p99.0),
            error(Basis::Arithmetic, |f| f.max.0),
            error(Basis::Algorithm, |f| f.mean.0),
            row.measured.max_ulp().map_or("-".to_owned(), short),
            row.rom_bits,
            count("datapath_multipliers"),
            count("scheme_multipliers"),
            count("latency_cycles"),
            short(row.speed / 1e6),
        )?;
    }
    if rows.len() > MAX_ROWS {
        writeln!(text, "\n{} more points are in `sweep.csv`.", rows.len() - MAX_ROWS)?;
    }
    writeln!(text)
}

fn failures(text: &mut String, record: &Record) -> std::fmt::Result {
    let mut failed = record.points.iter().filter_map(|p| Some((p, p.error.as_ref()?))).peekable();
    if failed.peek().is_none() {
        return Ok(());
    }
    writeln!(text, "## Failed points\n\n| {} | reason |\n|---|---|", axis_names(record))?;
    for (point, error) in failed.by_ref().take(MAX_ROWS) {
        let error = error.replace('|', "\\|").replace('\n', " ");
        writeln!(text, "| {} | {error} |", axis_values(record, point))?;
    }
    match failed.count() {
        0 => Ok(()),
        rest => writeln!(text, "\n{rest} more failed points are in `sweep.csv`."),
    }
}

/// A number in four digits.
fn short(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return x.to_string();
    }
    let exponent = x.abs().log10().floor();
    if (-4.0..6.0).contains(&exponent) {
        let digits = crate::cast::usize_of(3.0 - exponent);
        format!("{x:.digits$}")
    } else {
        format!("{x:.3e}")
    }
}
