//! `fixpath sim`: the measurement, and the CSV of hard cases.

use super::progress::progress_bar;
use crate::base::columns::{self, Field};
use crate::base::error::Result;
use crate::design::{Design, Sampler};
use crate::measure::{self, Basis, BoundCheck, Figures, Inputs, Profile, Report};
use std::io::Write;
use std::path::Path;

/// A measured design with everything that `sim` prints.
pub(super) struct Sim {
    pub(super) design: Design,
    pub(super) inputs: Inputs,
    pub(super) report: Report,
    pub(super) bounds: BoundCheck,
    pub(super) hard: Vec<measure::HardVerdict>,
}

impl Sim {
    pub(super) fn run(design: Design, inputs: &Inputs, bases: &[Basis]) -> Result<Self> {
        let bar = progress_bar(inputs.count(&design)?, &design.values.unit().name);
        let done = |done| bar.set_position(done);
        let mut reports = measure::measure_on(bases, &[&design], inputs, &done)?;
        bar.finish_and_clear();
        let bounds = BoundCheck::new(&design)?;
        let hard = if inputs.sampler == Sampler::Hard {
            measure::hard_verdicts(&design, &bounds)
        } else {
            Vec::new()
        };
        let report = reports.pop().expect("bug: one report per design");
        Ok(Self { design, inputs: *inputs, report, bounds, hard })
    }

    pub(super) fn passed(&self) -> bool {
        self.bounds.hold(&self.report)
            && self.hard.iter().all(|case| case.holds != Some(false))
            && self.without_value().next().is_none()
    }

    /// Quantities whose golden, or value on reals, is NaN at some input.
    pub(super) fn without_value(&self) -> impl Iterator<Item = &Figures> {
        self.report.figures.iter().filter(|figures| figures.max.is_nan())
    }
}

/// Every hard case, one row each.
pub(super) fn write_cases(sim: &Sim, to: &mut dyn Write, path: &Path) -> Result<()> {
    let netlist = &sim.design.netlist;
    let (group, results) = measure::case_columns(&sim.design);
    let mut heading = vec![group.to_owned()];
    heading.extend((0..netlist.inputs().len()).map(|i| format!("{}_raw", netlist.input_name(i))));
    heading.extend(results);
    let results = |group| measure::hard_results(&sim.design, group, &sim.bounds);
    let row = |case: measure::HardResult, group: &str| {
        let mut row = vec![Field::from(group)];
        row.extend(case.words.iter().map(|word| Field::Word(*word)));
        for numbers in [Some(&case.fixed), case.float32.as_ref(), Some(&case.float64)] {
            let number = |at: usize| numbers.map(|numbers| numbers[at]).into();
            row.extend((0..case.fixed.len()).map(number));
        }
        row.extend([case.error.into(), case.float32_error.into(), case.bound.into()]);
        row.push(case.holds().map(|holds| holds.to_string()).into());
        row.push(case.quantity.into());
        row
    };
    let rows = sim
        .design
        .hard
        .iter()
        .flat_map(|group| results(group).into_iter().map(move |case| row(case, &group.name)));
    columns::write(to, path, &heading, rows)
}

/// Adds the seconds of each part to a report.
pub(super) fn with_profile(
    mut json: serde_json::Value,
    times: Option<&Profile>,
) -> serde_json::Value {
    if let Some(times) = times {
        json["profile_seconds"] = serde_json::json!(times);
    }
    json
}
