//! Reports: the result of a sweep or a ladder as Markdown and plots.
//!
//! A sweep's is made from a [`record::Record`] alone, so a sweep that was stopped and went
//! on gives the same report as one that ran through.

mod chart;
pub mod ladder;
mod markdown;
mod plot;
pub mod record;

use crate::base::cast;
use crate::base::error::Result;
use crate::base::output;
use crate::measure::Basis;
use crate::shading::render::{Shader, shoot};
use crate::shading::scene::Scene;
use rayon::prelude::*;
use record::{Measured, Point, Record};
use std::path::Path;

/// Every file that [`write()`] may write.
pub const FILES: [&str; 5] = [
    "report.md",
    "error_vs_table.svg",
    "error_vs_axis.svg",
    "error_vs_rom.svg",
    "error_vs_speed.svg",
];

/// Writes `report.md` and the plots that it links to into a folder.
///
/// # Errors
/// If a file can't be written.
pub fn write(folder: &Path, record: &Record) -> Result<()> {
    let plots = plot::plots(record);
    let text = |name: &str, text: &str| {
        let path = folder.join(name);
        output::write_file(&path, |to| to.write_all(text.as_bytes()).map_err(output::at(&path)))
    };
    for plot in &plots {
        text(plot.file, &plot.svg)?;
    }
    text("report.md", &markdown::sweep(record, &plots))
}

/// Renders a scene by shaders made for it and measures every shot; `pixels_per_degree` is FLIP's.
/// `progress` gets the rows done.
///
/// # Errors
/// If a `narrow` under overflow mode `error` overflowed, no pixel sees an object, or FLIP can't look that finely.
pub fn shots(
    scene: &Scene,
    shaders: &[&Shader],
    pixels_per_degree: f64,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Measured>> {
    let rendered = shoot(scene, shaders, progress)?;
    let measured = rendered.shots.par_iter().map(|shot| {
        let difference = rendered.difference(&shot.picture, &rendered.golden, pixels_per_degree)?;
        Ok(Measured::of_shot(&rendered, shot, &difference))
    });
    measured.collect()
}

/// A measured point with what it is judged by.
struct Row<'a> {
    point: &'a Point,
    measured: &'a Measured,
    /// Largest error of the leading quantity on the basis that the record is ranked by, as it is
    /// shown; NaN if it is none.
    error: f64,
    rom_bits: f64,
    /// Engine samples per second and thread.
    speed: f64,
}

/// The measured points in grid order.
fn rows(record: &Record) -> Vec<Row<'_>> {
    let basis = record.ranking();
    let row = |point| {
        let point: &Point = point;
        let measured = point.measured.as_ref()?;
        let rom_bits = measured.count("rom_bits_dual_port").unwrap_or(0);
        Some(Row {
            point,
            measured,
            error: record.error(measured, basis),
            rom_bits: cast::f64_of_count(rom_bits),
            speed: measured.speed.engine_samples_per_second_per_thread,
        })
    };
    record.points.iter().filter_map(row).collect()
}

/// Positions of the rows that are best: error against ROM bits, cheapest first.
fn best(rows: &[Row<'_>]) -> Vec<usize> {
    let costs: Vec<_> = rows.iter().map(|row| (row.rom_bits, row.error)).collect();
    pareto(&costs)
}

/// Positions of the pairs that no other pair beats: one that is as small in both numbers and
/// smaller in one. Equal pairs stay together; pairs with a NaN are left out. The result goes up
/// in the first number, and equal pairs keep their order.
#[must_use]
pub fn pareto(costs: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> =
        (0..costs.len()).filter(|i| !costs[*i].0.is_nan() && !costs[*i].1.is_nan()).collect();
    order.sort_by(|a, b| {
        let ((a0, a1), (b0, b1)) = (costs[*a], costs[*b]);
        a0.total_cmp(&b0).then(a1.total_cmp(&b1))
    });
    let mut front: Vec<usize> = Vec::new();
    for index in order {
        // The last of the front has the smallest second number so far.
        let beaten = front
            .last()
            .is_some_and(|last| costs[index].1 >= costs[*last].1 && costs[index] != costs[*last]);
        if !beaten {
            front.push(index);
        }
    }
    front
}

/// Values of the axes at a point, as `exact, 10, 16`.
fn axis_values(record: &Record, point: &Point) -> String {
    let values: Vec<String> = record.header.axes.iter().map(|axis| point.text(&axis.key)).collect();
    if values.is_empty() { record.header.unit.clone() } else { values.join(", ") }
}

/// Names of the axes, in the order of [`axis_values`].
fn axis_names(record: &Record) -> String {
    let names: Vec<&str> = record.header.axes.iter().map(|axis| axis.key.as_str()).collect();
    names.join(", ")
}

/// Against what points are ranked, in words.
fn against(record: &Record) -> &'static str {
    if record.header.scene.is_some() {
        "the golden picture"
    } else if record.ranking() == Basis::EndToEnd {
        "the golden of the real inputs (end-to-end)"
    } else if record.inputs_differ() {
        // Such samplers give words: nothing is known of inputs before quantisation.
        "the golden of each point's own input words (total): not comparable where those differ"
    } else {
        "the golden of the quantised inputs (total)"
    }
}

/// Over which inputs, in words.
fn inputs(record: &Record) -> String {
    let header = &record.header;
    if let Some(scene) = &header.scene {
        return format!("scene {scene}");
    }
    match header.sampler.as_str() {
        sampler @ ("lit" | "sphere") => {
            format!("sampler {sampler}, {} samples, seed {}", header.samples, header.seed)
        }
        "exhaustive" => "sampler exhaustive: every combination of input words".to_owned(),
        sampler => format!("sampler {sampler}"),
    }
}

#[cfg(test)]
mod tests;
