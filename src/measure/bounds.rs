//! Verdicts on stated bounds and on the hard-case list.

use super::golden::{as_golden, run_golden};
use super::inputs::values_of;
use super::measurand::Measurand;
use super::report::{Basis, Report};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::json;
use crate::design::{Bound, Bounds, Design, HardCase};
use crate::sim::batch::Program;
use crate::table::figures::table_figures;
use serde::Serialize;
use std::cell::RefCell;

/// A stated bound, evaluated.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StatedBound {
    /// What is bounded, in a few words.
    pub quantity: String,
    /// The quantities that it bounds, by their names in reports.
    pub of: Vec<String>,
    /// The bound, in the unit of those quantities.
    pub bound: f64,
    /// What the error is relative to, if it isn't absolute.
    pub over: Option<String>,
}

impl StatedBound {
    /// The subject of the bound: "each" and its quantity (with "each" only once), and what the
    /// error is relative to.
    #[must_use]
    pub fn subject(&self) -> String {
        let each = if self.quantity.starts_with("each ") { "" } else { "each " };
        let over =
            self.over.as_ref().map_or_else(String::new, |what| format!(" (relative to {what})"));
        format!("{each}{}{over}", self.quantity)
    }

    /// The largest total error of the bounded quantities in a report.
    #[must_use]
    pub fn seen(&self, report: &Report) -> f64 {
        let all = self.of.iter().map(|quantity| report.figures(quantity, Basis::Total).max);
        // f64::max would drop a NaN.
        all.fold(0.0, |a, b| if a >= b || a.is_nan() { a } else { b })
    }

    /// True unless the bound is broken.
    #[must_use]
    pub fn holds(&self, report: &Report) -> bool {
        self.seen(report) <= self.bound // false for NaN
    }
}

/// The stated bounds of a design.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BoundCheck {
    /// The stated bounds.
    pub stated: Vec<StatedBound>,
    /// The inputs that they hold for, if not for all.
    pub inputs: Option<String>,
    /// Why no bound is stated.
    pub why_none: Option<String>,
}

impl BoundCheck {
    /// Evaluates the bounds of a design, which needs the exact worst error of each table scheme.
    ///
    /// # Errors
    /// As [`table_figures`], or if a bound refers to an unknown table or parameter.
    pub fn new(design: &Design) -> Result<Self> {
        design.check_samples()?;
        let (bounds, inputs) = match &design.bounds {
            Bounds::Stated(bounds) => (bounds, None),
            Bounds::Within(inputs, bounds) => (bounds, Some(inputs.clone())),
            Bounds::Unstated(why) => return Ok(Self::unstated(why)),
        };
        let mut worst: Vec<(String, f64)> = Vec::new();
        for tabulated in &design.tabulated {
            let Some(figures) = table_figures(tabulated)? else {
                return Ok(Self::unstated(
                    "a bound needs the exact worst error of each table, and one table has too many words to enumerate",
                ));
            };
            worst.extend(figures.into_iter().map(|figures| (figures.table, figures.worst)));
        }
        let missing = RefCell::new(None);
        let worst_of = |name: &str| {
            let of = worst.iter().filter(|(table, _)| *table == name).map(|(_, worst)| *worst);
            of.reduce(f64::max).unwrap_or_else(|| {
                missing.borrow_mut().get_or_insert_with(|| name.to_owned());
                0.0
            })
        };
        let scales = design.scales();
        let noting = design.values.noting();
        let evaluated = |bound: &Bound| -> Result<StatedBound> {
            let (quantity, of) = (bound.what.clone(), bound.quantities.clone());
            let over = scales.iter().find(|(name, _)| of.contains(name));
            let over = over.map(|(_, what)| what.clone());
            let bound = (bound.bound)(&noting, &worst_of);
            if let Some(wrong) = noting.wrong() {
                return Err(wrong);
            }
            if let Some(table) = missing.take() {
                let unit = &design.values.unit().name;
                return Err(Error::usage(format!(
                    "unit `{unit}`: its bound on `{quantity}` refers to the table `{table}`, which isn't among its `tabulated`"
                )));
            }
            Ok(StatedBound { quantity, of, bound, over })
        };
        let stated = bounds.iter().map(evaluated).collect::<Result<_>>()?;
        Ok(Self { stated, inputs, why_none: None })
    }

    fn unstated(why: &str) -> Self {
        Self { stated: Vec::new(), inputs: None, why_none: Some(why.to_owned()) }
    }

    /// True unless a bound is broken.
    #[must_use]
    pub fn hold(&self, report: &Report) -> bool {
        self.stated.iter().all(|bound| bound.holds(report))
    }
}

/// The result of a hard case, compared with plain floating point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HardResult {
    /// Input words.
    pub words: Vec<i64>,
    /// Bit-true results in the golden's columns: directions as x, y, z.
    #[serde(serialize_with = "json::reals")]
    pub fixed: Vec<f64>,
    /// Results of the golden in `f32`, if the unit has one.
    #[serde(serialize_with = "json::known_reals")]
    pub float32: Option<Vec<f64>>,
    /// Results of the golden in `f64`.
    #[serde(serialize_with = "json::reals")]
    pub float64: Vec<f64>,
    /// The quantity nearest to its bound or furthest past it. Without a bound: the angle of a
    /// direction, otherwise the quantity with the largest error.
    pub quantity: String,
    /// Its error: bit-true against `f64`.
    #[serde(serialize_with = "json::real")]
    pub error: f64,
    /// The largest error of `f32` in the judged quantities.
    #[serde(serialize_with = "json::known_real")]
    pub float32_error: Option<f64>,
    /// Its bound.
    #[serde(serialize_with = "json::known_real")]
    pub bound: Option<f64>,
}

impl HardResult {
    /// Whether the bound holds; `None` without one.
    #[must_use]
    pub fn holds(&self) -> Option<bool> {
        self.bound.map(|bound| self.error <= bound) // false for NaN
    }

    /// The rank of a case: the error in units of its bound. A NaN is worst.
    fn rank(&self) -> f64 {
        if self.error == 0.0 {
            return 0.0; // also beside a bound of 0
        }
        let rank = self.error / self.bound.unwrap_or(1.0);
        if rank.is_nan() { f64::INFINITY } else { rank }
    }
}

/// The worst case of a group of hard cases.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HardVerdict {
    /// What makes these cases hard.
    pub name: String,
    /// Number of cases.
    pub cases: usize,
    /// The case with the largest error relative to its bound.
    #[serde(flatten)]
    pub worst: HardResult,
    /// The largest error of `f32` over the group.
    #[serde(serialize_with = "json::known_real")]
    pub float32_worst: Option<f64>,
    /// Whether the bounds hold for every case of the group; `None` without a bound.
    pub holds: Option<bool>,
}

/// Names of the numbers in a [`HardResult`], in order.
#[must_use]
pub fn hard_columns(design: &Design) -> Vec<String> {
    design.groups.iter().flat_map(crate::design::Group::columns).collect()
}

/// Names of the columns of a table of hard cases, except the inputs: the group's, which precedes
/// the inputs, and those of the results, which follow them.
#[must_use]
pub fn case_columns(design: &Design) -> (&'static str, Vec<String>) {
    let names = hard_columns(design);
    let numbers = ["fixed", "f32", "f64"]
        .into_iter()
        .flat_map(|result| names.iter().map(move |name| format!("{name}_{result}")));
    let verdict = ["error", "f32_error", "bound", "holds", "quantity"].map(str::to_owned);
    ("case", numbers.chain(verdict).collect())
}

/// Runs a group of hard cases, in order.
///
/// # Panics
/// If a case doesn't have one word of its format per input port, which is a bug.
#[must_use]
pub fn hard_results(design: &Design, group: &HardCase, bounds: &BoundCheck) -> Vec<HardResult> {
    let netlist = &design.netlist;
    let judged = design.judged();
    let program = Program::compile(netlist, &judged);
    let columns: Vec<Vec<i64>> = (0..netlist.inputs().len())
        .map(|port| group.words.iter().map(|case| case[port]).collect())
        .collect();
    let slices: Vec<&[i64]> = columns.iter().map(Vec::as_slice).collect();
    let mut words = vec![Vec::new(); judged.len()];
    let ran = program.runner().run(&program, &slices, &mut words);
    ran.expect("bug: cases are words of their ports");
    let (mut values, mut inputs) = (Vec::new(), Vec::new());
    values_of(netlist, &judged, &words, &mut values);
    values_of(netlist, netlist.inputs(), &columns, &mut inputs);
    let (mut fixed, mut float64) = (Vec::new(), Vec::new());
    as_golden(&design.groups, &mut values, &mut fixed);
    run_golden(design, &inputs, &mut float64);
    let float32 = design.golden_f32.as_ref().map(|golden| -> Vec<Vec<f64>> {
        let inputs: Vec<Vec<f32>> =
            inputs.iter().map(|column| column.iter().map(|x| cast::f32_of(*x)).collect()).collect();
        let slices: Vec<&[f32]> = inputs.iter().map(Vec::as_slice).collect();
        let mut columns = vec![vec![0.0f32; group.words.len()]; design.golden_columns()];
        golden.run(&slices, &mut columns);
        let wide = |column: &Vec<f32>| column.iter().map(|value| f64::from(*value)).collect();
        columns.iter().map(wide).collect()
    });

    // The quantities that count, and their bounds.
    let mut judged: Vec<(Measurand, Option<f64>)> = Vec::new();
    for measurand in Measurand::all(design) {
        let bound = bounds.stated.iter().find(|bound| bound.of.contains(&measurand.name));
        match bound {
            Some(bound) => judged.push((measurand, Some(bound.bound))),
            None if bounds.stated.is_empty() && measurand.counts_unbounded(design) => {
                judged.push((measurand, None));
            }
            None => {}
        }
    }
    let errors = |is: &[Vec<f64>]| -> Vec<Vec<f64>> {
        let of = |(measurand, _): &(Measurand, Option<f64>)| {
            let mut errors = Vec::new();
            measurand.errors(is, &float64, &float64, &mut errors);
            errors
        };
        judged.iter().map(of).collect()
    };
    let (fixed_errors, float32_errors) = (errors(&fixed), float32.as_deref().map(errors));
    let result = |i: usize| {
        // Excluding the golden's scales.
        let at = |columns: &[Vec<f64>]| {
            columns.iter().take(fixed.len()).map(|column| column[i]).collect()
        };
        let case = |q: usize| HardResult {
            words: group.words[i].clone(),
            fixed: at(&fixed),
            float32: float32.as_deref().map(at),
            float64: at(&float64),
            quantity: judged[q].0.name.clone(),
            error: fixed_errors[q][i].abs(),
            float32_error: float32_errors
                .as_ref()
                .map(|errors| errors.iter().map(|e| e[i].abs()).fold(0.0, f64::max)),
            bound: judged[q].1,
        };
        let worst = (0..judged.len()).map(case).max_by(|a, b| a.rank().total_cmp(&b.rank()));
        worst.expect("bug: something is judged")
    };
    (0..group.words.len()).map(result).collect()
}

/// Judges each group of the hard-case list.
#[must_use]
pub fn hard_verdicts(design: &Design, bounds: &BoundCheck) -> Vec<HardVerdict> {
    let verdict = |group: &HardCase| {
        let results = hard_results(design, group, bounds);
        let float32_worst = results.iter().filter_map(|case| case.float32_error).reduce(f64::max);
        let cases = results.len();
        let worst = results.into_iter().max_by(|a, b| a.rank().total_cmp(&b.rank()))?;
        let holds = worst.holds();
        Some(HardVerdict { name: group.name.clone(), cases, worst, float32_worst, holds })
    };
    design.hard.iter().filter_map(verdict).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_is_said_once() {
        let of = |quantity| {
            StatedBound { quantity: str::to_owned(quantity), of: vec![], over: None, bound: 0.0 }
                .subject()
        };
        assert_eq!(of("part"), "each part");
        assert_eq!(of("each part"), "each part");
        assert_eq!(of("eachother"), "each eachother");
    }
}
