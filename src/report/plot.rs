//! The plots of a sweep.

use super::chart::{Along, Chart, Front, Series, Style};
use super::record::{Axis, Record, plain};
use super::rows::{Row, against, axis_names, axis_values, best, inputs, rows};
use crate::design::{Role, Unit};
use crate::measure::Basis;

/// With more series than this, a plot groups points by colour and mark only.
const MAX_SERIES: usize = 8;
/// Algorithm errors up to this are rounding of the golden itself; in rad, or absolute.
const LEAST_ALGORITHM: f64 = 1e-9;

/// A plot and its file.
pub(super) struct Plot {
    pub(super) file: &'static str,
    pub(super) title: String,
    pub(super) svg: String,
}

/// All plots for which the sweep has numbers.
pub(super) fn plots(record: &Record) -> Vec<Plot> {
    let rows = rows(record);
    let charts = [
        error_vs_axis(record, &rows),
        Some(("error_vs_rom.svg", error_vs_rom(record, &rows))),
        Some(("error_vs_speed.svg", error_vs_speed(record, &rows))),
    ];
    charts
        .into_iter()
        .flatten()
        .map(|(file, chart)| Plot { file, svg: chart.svg(), title: chart.title })
        .collect()
}

/// Title of the error axis.
fn error_axis(record: &Record) -> (String, Along) {
    let lead = record.lead();
    let unit = match lead.unit {
        "deg" => "degrees",
        "abs" => "absolute",
        "texel" => "texels",
        "rel" => "relative to its scale",
        unit => unit,
    };
    (format!("{} ({unit})", lead.what), Along::Log10)
}

/// Caption on what the errors are relative to.
fn caption(record: &Record) -> Vec<String> {
    vec![format!("Against {}; {}.", against(record), inputs(record))]
}

/// Axes with more than one value.
fn varied(record: &Record) -> impl Iterator<Item = &Axis> + Clone {
    record.header.axes.iter().filter(|axis| axis.values.len() > 1)
}

/// Role of the parameter of an axis.
fn role(record: &Record, axis: &Axis) -> Option<Role> {
    Some(Unit::find(&record.header.unit).ok()?.find_param(&axis.key)?.role)
}

/// The axis whose values have different colours: a unit has at most one such parameter.
fn coloured(record: &Record) -> Option<&Axis> {
    let is_variant = |role| matches!(role, Some(Role::Variant | Role::Pipeline));
    varied(record).find(|axis| is_variant(role(record, axis)))
}

/// The axis whose values have different marks, in preference to others.
fn marked(record: &Record) -> Option<&Axis> {
    varied(record).find(|axis| role(record, axis) == Some(Role::Scheme))
}

/// A grouping of points into series, by the values of some axes.
struct Groups<'a> {
    axes: Vec<&'a Axis>,
    coloured: Option<&'a Axis>,
    marked: Option<&'a Axis>,
}

impl<'a> Groups<'a> {
    fn new(record: &'a Record, axes: Vec<&'a Axis>) -> Self {
        Self { axes, coloured: coloured(record), marked: marked(record) }
    }

    /// Groups by colour and mark alone.
    fn few(record: &'a Record) -> Self {
        let [coloured, marked] = [coloured(record), marked(record)];
        let axes = varied(record).filter(|axis| [coloured, marked].contains(&Some(axis)));
        Self { axes: axes.collect(), coloured, marked }
    }

    fn len(&self) -> usize {
        self.axes.iter().map(|axis| axis.values.len()).product()
    }

    /// Index of a point's group among all combinations.
    fn of(&self, row: &Row<'_>) -> usize {
        self.axes.iter().fold(0, |group, axis| {
            let text = row.point.text(&axis.key);
            let position = axis.values.iter().position(|value| plain(value) == text);
            group * axis.values.len() + position.unwrap_or(0)
        })
    }

    /// A name, a colour and a mark for each group.
    fn looks(&self) -> Vec<(String, usize, usize)> {
        let coloured = self.axes.iter().any(|axis| Some(*axis) == self.coloured);
        (0..self.len())
            .map(|group| {
                let (mut rest, mut colour, mut mark, mut scale) = (group, 0, 0, 1);
                let mut names = Vec::new();
                for axis in self.axes.iter().rev() {
                    let index = rest % axis.values.len();
                    rest /= axis.values.len();
                    let value = plain(&axis.values[index]);
                    if Some(*axis) == self.coloured {
                        colour = index;
                    } else {
                        mark += index * scale;
                        scale *= axis.values.len();
                    }
                    let told_by_value = [self.coloured, self.marked].contains(&Some(*axis));
                    names.push(if told_by_value { value } else { format!("{}={value}", axis.key) });
                }
                names.reverse();
                let name =
                    if names.is_empty() { "all points".to_owned() } else { names.join(", ") };
                (name, if coloured { colour } else { group }, mark)
            })
            .collect()
    }

    /// Series of the points that have a place, in the order of the rows. Groups without points are
    /// left out.
    fn series(
        &self,
        rows: &[Row<'_>],
        style: Style,
        place: impl Fn(&Row<'_>) -> Option<(f64, f64)>,
    ) -> Vec<Series> {
        let mut all: Vec<Series> = self
            .looks()
            .into_iter()
            .map(|(label, colour, mark)| Series { label, colour, mark, style, points: Vec::new() })
            .collect();
        for row in rows {
            all[self.of(row)].points.extend(place(row));
        }
        all.retain(|series| !series.points.is_empty());
        all
    }
}

/// Sorts points along x and keeps one for each x, as picked by `keep`.
fn one_per_x(points: &mut Vec<(f64, f64)>, keep: fn(f64, f64) -> f64) {
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points.dedup_by(|later, kept| {
        let same = later.0 == kept.0;
        if same {
            kept.1 = keep(kept.1, later.1);
        }
        same
    });
}

/// Error against table size, or against the first numeric axis.
fn error_vs_axis(record: &Record, rows: &[Row<'_>]) -> Option<(&'static str, Chart)> {
    let numeric =
        || varied(record).filter(|axis| axis.values.iter().any(|value| value.is_number()));
    let table = numeric().find(|axis| role(record, axis) == Some(Role::TableSize));
    let axis = table.or_else(|| numeric().next())?;
    let is_table = table.is_some();
    let x_of = |row: &Row<'_>| {
        let number = row.point.number(&axis.key)?;
        Some(if is_table { libm::exp2(number) } else { number })
    };
    let (file, title, x) = if is_table {
        let what = format!("table size before folding (2^{} entries)", axis.key);
        ("error_vs_table.svg", "table size".to_owned(), (what, Along::Log2))
    } else {
        ("error_vs_axis.svg", axis.key.clone(), (axis.key.clone(), Along::Linear))
    };
    let mut caption = caption(record);
    let others =
        Groups::new(record, varied(record).filter(|other| other.key != axis.key).collect());
    let groups = if others.len() <= MAX_SERIES {
        others
    } else {
        let few = Groups::few(record);
        let over: Vec<&str> = others
            .axes
            .iter()
            .filter(|axis| !few.axes.contains(axis))
            .map(|axis| axis.key.as_str())
            .collect();
        if !over.is_empty() {
            caption.push(format!("Each point is the best over {}.", over.join(", ")));
        }
        few
    };
    let mut series = groups.series(rows, Style::Joined, |row| Some((x_of(row)?, row.error)));
    for series in &mut series {
        one_per_x(&mut series.points, f64::min);
    }
    let algorithm = algorithm_errors(record, rows, x_of);
    if !algorithm.is_empty() {
        caption.push("Dashed: error of the algorithm alone, on real numbers.".to_owned());
    }
    series.extend(algorithm);
    let title = format!("{}: error against {title}", record.header.unit);
    Some((file, Chart { title, caption, x, y: error_axis(record), series, front: None }))
}

/// The largest algorithm error of each variant that has one.
fn algorithm_errors(
    record: &Record,
    rows: &[Row<'_>],
    x_of: impl Fn(&Row<'_>) -> Option<f64>,
) -> Vec<Series> {
    let scale = record.lead().scale;
    let variants = Groups::new(record, coloured(record).into_iter().collect());
    let mut series = variants.series(rows, Style::Dashed, |row| {
        let error = row.measured.lead_max(Basis::Algorithm);
        (!error.is_nan()).then_some((x_of(row)?, error * scale))
    });
    series.retain(|s| s.points.iter().any(|(_, y)| y / scale > LEAST_ALGORITHM));
    for series in &mut series {
        one_per_x(&mut series.points, f64::max);
        series.label = if variants.axes.is_empty() {
            "algorithm alone".to_owned()
        } else {
            format!("{}, algorithm alone", series.label)
        };
    }
    series
}

/// Error against ROM bits, with the Pareto-optimal points.
fn error_vs_rom(record: &Record, rows: &[Row<'_>]) -> Chart {
    let series =
        Groups::few(record).series(rows, Style::Marks, |row| Some((row.rom_bits, row.error)));
    let front = best(rows).into_iter().map(|index| &rows[index]);
    let points: Vec<_> =
        front.map(|row| (row.rom_bits, row.error, axis_values(record, row.point))).collect();
    let mut caption = caption(record);
    let names = axis_names(record);
    if !names.is_empty() {
        caption.push(format!("Labels: {names}."));
    }
    Chart {
        title: format!("{}: error against ROM bits", record.header.unit),
        caption,
        x: ("ROM bits, one copy per two read ports".to_owned(), Along::Log10),
        y: error_axis(record),
        series,
        front: Some(Front { label: "Pareto-optimal".to_owned(), points }),
    }
}

/// Error against the speed of the simulation.
fn error_vs_speed(record: &Record, rows: &[Row<'_>]) -> Chart {
    let series = Groups::few(record).series(rows, Style::Marks, |row| Some((row.speed, row.error)));
    Chart {
        title: format!("{}: error against simulation speed", record.header.unit),
        caption: {
            let mut caption = caption(record);
            caption.push("Wall-clock time: affected by other load on the machine.".to_owned());
            caption
        },
        x: ("bit-true engine alone (samples per second and thread)".to_owned(), Along::Log10),
        y: error_axis(record),
        series,
        front: None,
    }
}
