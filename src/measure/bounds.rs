//! Stated bounds and the hard-case list, judged.

use crate::cast;
use crate::error::Result;
use crate::measure::inputs::values_of;
use crate::measure::{Basis, Report, angle_between, directions, run_golden, table_figures};
use crate::netlist::NodeId;
use crate::sim::batch::Program;
use crate::units::{Bound, Design, HardCase};
use serde::Serialize;

/// A stated bound beside what was seen.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BoundCheck {
    /// Quantity that is bounded; `None` if no bound is stated.
    pub quantity: Option<&'static str>,
    /// The bound; `None` if none is stated.
    pub bound: Option<f64>,
    /// Why none is stated.
    pub why: Option<&'static str>,
}

impl BoundCheck {
    /// Evaluates the bound of a design: needs the exact worst error of each table scheme.
    ///
    /// # Errors
    /// As [`table_figures`].
    ///
    /// # Panics
    /// If the bound asks for a table that the design doesn't have: that is wrong code.
    pub fn new(design: &Design) -> Result<Self> {
        let (quantity, bound) = match design.bound {
            Bound::Component(bound) => ("component", bound),
            Bound::Angle(bound) => ("angle", bound),
            Bound::Unstated(why) => return Ok(Self::unstated(why)),
        };
        let mut worst: Vec<(&str, f64)> = Vec::new();
        for tabulated in &design.tabulated {
            let Some(figures) = table_figures(tabulated)? else {
                return Ok(Self::unstated(
                    "it rests on the exact worst error of each table, and one has too many words to go through",
                ));
            };
            worst.extend(figures.iter().map(|figures| (figures.table, figures.worst)));
        }
        let worst_of = |name: &str| {
            let of = worst.iter().filter(|(table, _)| *table == name).map(|(_, worst)| *worst);
            let most = of.fold(f64::NEG_INFINITY, f64::max);
            assert!(most >= 0.0, "bug: no table `{name}`");
            most
        };
        Ok(Self {
            quantity: Some(quantity),
            bound: Some(bound(&design.values, &worst_of)),
            why: None,
        })
    }

    fn unstated(why: &'static str) -> Self {
        Self { quantity: None, bound: None, why: Some(why) }
    }

    /// The largest total error of the bounded quantity in a report.
    #[must_use]
    pub fn seen(&self, report: &Report) -> Option<f64> {
        match self.quantity? {
            "component" => ["x", "y", "z"]
                .into_iter()
                .map(|component| report.figures(component, Basis::Total).max)
                // f64::max would drop a NaN.
                .reduce(|a, b| if a >= b || a.is_nan() { a } else { b }),
            quantity => Some(report.figures(quantity, Basis::Total).max),
        }
    }

    /// True unless the bound is broken.
    #[must_use]
    pub fn holds(&self, report: &Report) -> bool {
        match (self.bound, self.seen(report)) {
            (Some(bound), Some(seen)) => seen <= bound, // false for NaN
            _ => true,
        }
    }
}

/// A hard case beside plain floating point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HardResult {
    /// Input words.
    pub words: Vec<i64>,
    /// Bit-true direction.
    pub fixed: [f64; 3],
    /// Direction by the golden in `f32`.
    pub float32: [f64; 3],
    /// Direction by the golden in `f64`.
    pub float64: [f64; 3],
    /// Error of the bounded quantity, bit-true against `f64`: of the worst component, or the angle
    /// in rad, also where none is bounded.
    pub error: f64,
    /// The same of `f32`.
    pub float32_error: f64,
}

/// The worst of a group of hard cases.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HardVerdict {
    /// What is hard about them.
    pub name: &'static str,
    /// Number of cases.
    pub cases: usize,
    /// The case with the largest error.
    #[serde(flatten)]
    pub worst: HardResult,
    /// The largest error of `f32` over the group.
    pub float32_worst: f64,
    /// The stated bound.
    pub bound: Option<f64>,
    /// Whether it holds for every case of the group; `None` without a bound.
    pub holds: Option<bool>,
}

/// Runs a group of hard cases, in its order.
///
/// # Panics
/// If a case doesn't have one word per input port: that is wrong code.
#[must_use]
pub fn hard_results(design: &Design, group: &HardCase, bound: &BoundCheck) -> Vec<HardResult> {
    let netlist = &design.netlist;
    let outputs: Vec<NodeId> = netlist.outputs().iter().map(|output| output.node).collect();
    let program = Program::compile(netlist, &outputs);
    let columns: Vec<Vec<i64>> = (0..netlist.inputs().len())
        .map(|port| group.words.iter().map(|case| case[port]).collect())
        .collect();
    let slices: Vec<&[i64]> = columns.iter().map(Vec::as_slice).collect();
    let mut words = vec![Vec::new(); outputs.len()];
    program.runner().run(&program, &slices, &mut words);
    let (mut values, mut inputs) = (Vec::new(), Vec::new());
    values_of(netlist, &outputs, &words, &mut values);
    values_of(netlist, netlist.inputs(), &columns, &mut inputs);
    let (mut fixed, mut float64) = <([Vec<f64>; 3], [Vec<f64>; 3])>::default();
    directions(design.shape, &values, &mut fixed);
    run_golden(design, &inputs, &mut float64);
    let inputs32: Vec<Vec<f32>> =
        inputs.iter().map(|column| column.iter().map(|x| cast::f32_of(*x)).collect()).collect();
    let slices: Vec<&[f32]> = inputs32.iter().map(Vec::as_slice).collect();
    let mut float32 = [(); 3].map(|()| vec![0.0f32; group.words.len()]);
    (design.golden_f32)(&slices, &mut float32);
    let error = |is: [f64; 3], should: [f64; 3]| match bound.quantity {
        Some("component") => (0..3).map(|i| (is[i] - should[i]).abs()).fold(0.0, f64::max),
        Some(_) | None => angle_between(is, should),
    };
    (0..group.words.len())
        .map(|i| {
            let at = |columns: &[Vec<f64>; 3]| [columns[0][i], columns[1][i], columns[2][i]];
            let (fixed, float64) = (at(&fixed), at(&float64));
            let float32 = [0, 1, 2].map(|axis| f64::from(float32[axis][i]));
            HardResult {
                words: group.words[i].clone(),
                fixed,
                float32,
                float64,
                error: error(fixed, float64),
                float32_error: error(float32, float64),
            }
        })
        .collect()
}

/// Judges each group of the hard-case list.
#[must_use]
pub fn hard_verdicts(design: &Design, bound: &BoundCheck) -> Vec<HardVerdict> {
    let verdict = |group: &HardCase| {
        let results = hard_results(design, group, bound);
        let float32_worst = results.iter().map(|case| case.float32_error).fold(0.0, f64::max);
        let cases = results.len();
        let worst = results.into_iter().max_by(|a, b| a.error.total_cmp(&b.error))?;
        let holds = bound.bound.map(|bound| worst.error <= bound);
        Some(HardVerdict {
            name: group.name,
            cases,
            worst,
            float32_worst,
            bound: bound.bound,
            holds,
        })
    };
    design.hard.iter().filter_map(verdict).collect()
}
