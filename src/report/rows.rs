//! A record's measured points, inputs and reference, for reports.

use super::pareto::pareto;
use super::record::{Measured, Point, Record};
use crate::base::cast;
use crate::measure::Basis;

/// A measured point with the figures that rank it.
pub(super) struct Row<'a> {
    pub(super) point: &'a Point,
    pub(super) measured: &'a Measured,
    /// Largest error of the leading quantity on the basis that ranks the record, as shown; NaN if
    /// there is none.
    pub(super) error: f64,
    pub(super) rom_bits: f64,
    /// Engine samples per second and thread.
    pub(super) speed: f64,
}

/// The measured points in grid order.
pub(super) fn rows(record: &Record) -> Vec<Row<'_>> {
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

/// Positions of the Pareto-optimal rows: error against ROM bits, cheapest first.
pub(super) fn best(rows: &[Row<'_>]) -> Vec<usize> {
    let costs: Vec<_> = rows.iter().map(|row| (row.rom_bits, row.error)).collect();
    pareto(&costs)
}

/// Values of the axes at a point, such as `exact, 10, 16`.
pub(super) fn axis_values(record: &Record, point: &Point) -> String {
    let values: Vec<String> = record.header.axes.iter().map(|axis| point.text(&axis.key)).collect();
    if values.is_empty() { record.header.unit.clone() } else { values.join(", ") }
}

/// Names of the axes, in the order of [`axis_values`].
pub(super) fn axis_names(record: &Record) -> String {
    let names: Vec<&str> = record.header.axes.iter().map(|axis| axis.key.as_str()).collect();
    names.join(", ")
}

/// What points are ranked against, in words.
pub(super) fn against(record: &Record) -> &'static str {
    if record.header.scene.is_some() {
        "the golden picture"
    } else if record.ranking() == Basis::EndToEnd {
        "the golden model of the real inputs (end-to-end)"
    } else if record.inputs_differ() {
        // Such samplers give words, so there are no inputs before quantisation.
        "the golden model of each point's own input words (total): not comparable if those differ"
    } else {
        "the golden model of the quantised inputs (total)"
    }
}

/// The inputs, in words.
pub(super) fn inputs(record: &Record) -> String {
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
