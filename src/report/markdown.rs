//! A sweep as Markdown.

use super::plot::Plot;
use super::record::{Figures, Measured, PictureFigures, Record, plain};
use super::rows::{Row, against, axis_names, axis_values, best, inputs, rows};
use super::table::Table;
use crate::base::escape::markdown;
use crate::measure::Basis;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Largest number of rows in the table of points; `sweep.csv` has all.
const MAX_ROWS: usize = 1000;

/// The report.
pub(super) fn sweep(record: &Record, plots: &[Plot]) -> String {
    let rows = rows(record);
    let mut text = String::new();
    // Writing to a string can't fail.
    let _ = head(&mut text, record, rows.len());
    let _ = front(&mut text, record, &rows);
    for plot in plots {
        let _ = write!(text, "![{}]({})\n\n", markdown(&plot.title), plot.file);
    }
    let _ = match record.header.scene {
        Some(_) => pictures(&mut text, record, &rows),
        None => points(&mut text, record, &rows),
    };
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
    writeln!(text, "- Inputs: {}.", markdown(&inputs(record)))?;
    if let Some(coverage) = record.coverage() {
        writeln!(text, "- Pictures: {coverage}.")?;
    }
    if let Some(scene) = &header.scene {
        for note in &scene.notes {
            writeln!(text, "- Note: {}.", markdown(note))?;
        }
        writeln!(
            text,
            "- The golden picture is tangent-space bump mapping in `f64`, with the same material. Differences are in linear light, over every channel of the covered pixels, here in 1/255 (`sweep.csv` and `sweep.json` have 0 to 1); SSIM, FLIP and codes compare the 8-bit sRGB pictures. L' angle is the angle between the rotated light vector and that of the inputs before quantisation."
        )?;
        writeln!(
            text,
            "- `scene`: this material parameter comes from the scene. One that is set explicitly replaces the scene's, in the pipeline and the golden alike."
        )?;
    } else {
        measures(text, record)?;
    }
    writeln!(
        text,
        "- ROM bits include one copy of each table per two read ports. Multipliers are those of the datapath + those inside table schemes. Engine speed is that of the bit-true simulation alone, per thread.\n"
    )
}

/// What the figures over samples mean.
fn measures(text: &mut String, record: &Record) -> std::fmt::Result {
    let figures = record.points.iter().filter_map(|point| point.measured.as_ref());
    let scales: BTreeSet<String> = figures
        .flat_map(|measured| &measured.figures)
        .filter_map(|f| Some(format!("`{}` over {}", f.quantity, markdown(f.over.as_ref()?))))
        .collect();
    let scaled = match scales.is_empty() {
        true => String::new(),
        false => format!(", except {}", scales.into_iter().collect::<Vec<_>>().join("; ")),
    };
    writeln!(
        text,
        "- Errors are absolute{scaled}: the angle between vectors, here in degrees (`sweep.csv` and `sweep.json` have rad), and the difference of a number or a component, also in ulp of its port."
    )?;
    writeln!(
        text,
        "- *Total* is bit-true against the golden model (the same function in double precision) of the quantised inputs. It has two parts: *algorithm* is the netlist on reals against that golden, the error of the method; *arithmetic* is bit-true against the netlist on reals, the error of words and tables. *End-to-end* is bit-true against the golden model of the inputs before quantisation."
    )?;
    writeln!(
        text,
        "- *Max* is the largest seen over these inputs; `sweep.json` names the input that gave it. Quantiles are accurate to 1.6 %."
    )
}

fn front(text: &mut String, record: &Record, rows: &[Row<'_>]) -> std::fmt::Result {
    writeln!(text, "## Pareto-optimal points\n")?;
    let lead = record.lead();
    writeln!(
        text,
        "By the {} against {}: no other point is as good in both and better in one.\n",
        lead.what,
        against(record)
    )?;
    let names = axis_names(record);
    writeln!(
        text,
        "| {} | {} ({}) | ROM bits |",
        if names.is_empty() { "unit" } else { &names },
        lead.what,
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
        let error = |basis, get: fn(&Figures) -> f64| {
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

/// The points over a scene.
fn pictures(text: &mut String, record: &Record, rows: &[Row<'_>]) -> std::fmt::Result {
    writeln!(text, "## Points\n")?;
    let axes: Vec<&str> = record.header.axes.iter().map(|axis| axis.key.as_str()).collect();
    let mut headings = axes.clone();
    headings.extend(PICTURE_HEADINGS);
    headings.extend([
        ">ROM bits",
        ">multipliers",
        ">adders",
        ">latency (cycles)",
        ">engine (Msamples/s)",
    ]);
    let cells = rows.iter().take(MAX_ROWS).map(|row| {
        let mut cells: Vec<String> = axes.iter().map(|key| row.point.text(key)).collect();
        cells.extend(picture_cells(row.measured));
        let [multipliers, adders] = row.measured.operators();
        cells.extend([
            row.rom_bits.to_string(),
            multipliers.to_string(),
            adders.to_string(),
            row.measured.count("latency_cycles").unwrap_or(0).to_string(),
            short(row.speed / 1e6),
        ]);
        cells
    });
    text.push_str(&Table::new(&headings, cells.collect()).markdown());
    if rows.len() > MAX_ROWS {
        writeln!(text, "\n{} more points are in `sweep.csv`.", rows.len() - MAX_ROWS)?;
    }
    writeln!(text)
}

/// Headings of [`picture_cells`].
pub(super) const PICTURE_HEADINGS: [&str; 9] = [
    ">max (1/255)",
    ">mean (1/255)",
    ">rms (1/255)",
    ">PSNR (dB)",
    ">SSIM",
    ">FLIP",
    ">8-bit differing (%)",
    ">L' angle max (deg)",
    ">L' angle mean (deg)",
];

/// Figures of a picture as they are shown.
pub(super) fn picture_cells(measured: &Measured) -> Vec<String> {
    let none = || "-".to_owned();
    let figure = |quantity, get: fn(&Figures) -> f64, scale: f64| {
        let figures = measured.figures(quantity, Basis::EndToEnd);
        figures.map_or_else(none, |figures| short(get(figures) * scale))
    };
    let picture =
        |show: fn(&PictureFigures) -> String| measured.picture.as_ref().map_or_else(none, show);
    vec![
        figure("picture", |f| f.max.0, 255.0),
        figure("picture", |f| f.mean.0, 255.0),
        figure("picture", |f| f.rms.0, 255.0),
        picture(|p| format!("{:.1}", p.psnr_db.0)),
        picture(|p| format!("{:.4}", p.ssim.0)),
        picture(|p| format!("{:.4}", p.flip.0)),
        picture(|p| format!("{:.2}", p.srgb8_differing * 100.0)),
        figure("lt_angle", |f| f.max.0, 1f64.to_degrees()),
        figure("lt_angle", |f| f.mean.0, 1f64.to_degrees()),
    ]
}

fn failures(text: &mut String, record: &Record) -> std::fmt::Result {
    let mut failed = record.points.iter().filter_map(|p| Some((p, p.error.as_ref()?))).peekable();
    if failed.peek().is_none() {
        return Ok(());
    }
    writeln!(text, "## Failed points\n\n| {} | reason |\n|---|---|", axis_names(record))?;
    for (point, error) in failed.by_ref().take(MAX_ROWS) {
        writeln!(text, "| {} | {} |", axis_values(record, point), markdown(error))?;
    }
    match failed.count() {
        0 => Ok(()),
        rest => writeln!(text, "\n{rest} more failed points are in `sweep.csv`."),
    }
}

/// A number in four digits.
pub(super) fn short(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return x.to_string();
    }
    let exponent = libm::log10(x.abs()).floor();
    if (-4.0..6.0).contains(&exponent) {
        let digits = crate::base::cast::usize_of(3.0 - exponent);
        format!("{x:.digits$}")
    } else {
        format!("{x:.3e}")
    }
}
