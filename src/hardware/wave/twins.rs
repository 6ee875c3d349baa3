//! The reals next to words (value, ideal, arithmetic error, golden model, total error), and the
//! angle of each direction.
//!
//! Ideal, golden model and angle belong to a sample, not to a cycle. They are evaluated for a block
//! of samples at once, by the engines and by the golden model. Columns hold them from the oldest
//! sample in the pipeline on, so memory doesn't grow with the wave.

use super::text::{Code, Lines};
use super::trace::{AngleTrace, Trace, Twin};
use crate::base::cast;
use crate::design::Design;
use crate::hardware::cycle::Cycle;
use crate::hardware::rtl::Rtl;
use crate::measure::{angle_errors, as_golden, values_of};
use crate::netlist::{NodeId, Quantity};
use crate::sim::batch;
use crate::sim::real::{Program, Runner};
use std::io;
use vcd::IdCode;

/// Number of samples evaluated at once.
const BLOCK: usize = 1024;

/// All twins of a wave.
pub(super) struct Twins<'a> {
    design: &'a Design,
    program: Program,
    runner: Runner,
    shown: Vec<Shown>,
    interval: u64,
    /// Columns hold samples `first..end`.
    first: usize,
    end: usize,
    /// Largest number of samples in the pipeline.
    kept: usize,
    /// Ideals, by node that has one.
    ideals: Vec<Vec<f64>>,
    /// Golden values by output port (output ports come first among the judged nodes); empty if none
    /// is shown.
    judged: Vec<Vec<f64>>,
    angles: Option<Angles>,
    /// Inputs, and ideals, of a block.
    inputs: Vec<Vec<f64>>,
    block: Vec<Vec<f64>>,
}

/// The twins of a signal.
struct Shown {
    slot: usize,
    stage: u32,
    /// True if the word is present only in its phase.
    own: bool,
    ulp: f64,
    scale: f64,
    quantity: Quantity,
    /// Column of the ideal.
    ideal: Option<usize>,
    /// Its output port, if it is one.
    port: Option<usize>,
    /// Identifiers and latest values.
    codes: Vec<(Twin, Real)>,
}

/// A real variable, and the bits of its latest value.
struct Real {
    code: Code,
    last: Option<u64>,
}

impl Real {
    fn new(code: IdCode) -> Self {
        Self { code: code.into(), last: None }
    }

    /// Writes a value if it has changed.
    fn change(&mut self, lines: &mut Lines<'_>, now: f64) -> io::Result<()> {
        if self.last == Some(now.to_bits()) {
            return Ok(());
        }
        self.last = Some(now.to_bits());
        lines.real(now, &self.code)
    }
}

/// The angles between directions and their golden model.
struct Angles {
    /// The bit-true values that are judged.
    program: batch::Program,
    runner: batch::Runner,
    /// Number of the direction, the stage in which it is complete, and the variable.
    shown: Vec<(usize, u64, Real)>,
    /// By direction, in degrees; as many samples as in the other columns.
    columns: Vec<Vec<f64>>,
}

impl Angles {
    /// Appends a block of samples with the given golden values.
    fn append(&mut self, design: &Design, block: &[Vec<i64>], golden: &[Vec<f64>]) {
        let ports = 0..design.netlist.inputs().len();
        let words: Vec<Vec<i64>> =
            ports.map(|port| block.iter().map(|words| words[port]).collect()).collect();
        let words: Vec<&[i64]> = words.iter().map(Vec::as_slice).collect();
        let judged = design.judged();
        let mut results = vec![Vec::new(); judged.len()];
        let ran = self.runner.run(&self.program, &words, &mut results);
        ran.expect("bug: words are of their ports' formats");
        let (mut values, mut is) = (Vec::new(), Vec::new());
        values_of(&design.netlist, &judged, &results, &mut values);
        as_golden(&design.groups, &mut values, &mut is);
        for (column, errors) in self.columns.iter_mut().zip(angle_errors(design, &is, golden)) {
            column.extend(errors.into_iter().map(f64::to_degrees));
        }
    }
}

/// An error in ulp for display: to 1/256, so that a few digits are exact.
fn in_ulp(error: f64, ulp: f64) -> f64 {
    (error / ulp * 256.0).round() / 256.0 + 0.0 // -0 becomes 0
}

impl<'a> Twins<'a> {
    /// Twins of signals with these identifiers; `first` is the earliest sample that is shown.
    pub(super) fn new(
        design: &'a Design,
        rtl: &Rtl,
        cycle: &Cycle,
        signals: Vec<(&Trace, Vec<IdCode>)>,
        angles: Vec<(&AngleTrace, IdCode)>,
        first: usize,
    ) -> Self {
        let netlist = rtl.netlist();
        let mut nodes: Vec<NodeId> = Vec::new();
        let mut columns: Vec<Option<usize>> = vec![None; netlist.nodes().len()];
        let shown: Vec<Shown> = signals
            .into_iter()
            .filter(|(_, codes)| !codes.is_empty())
            .map(|(trace, codes)| {
                let id = trace.signal.node;
                let has = |twin| trace.twins.contains(&twin);
                let ideals = [Twin::Ideal, Twin::ArithError, Twin::ArithErrorUlp];
                let goldens = [Twin::Golden, Twin::TotalError, Twin::TotalErrorUlp];
                let ideal = ideals.into_iter().any(has).then(|| {
                    *columns[id.index()].get_or_insert_with(|| {
                        nodes.push(id);
                        nodes.len() - 1
                    })
                });
                Shown {
                    slot: cycle.slot(trace.signal),
                    stage: trace.signal.stage,
                    own: trace.signal.stage == rtl.schedule().stage(id),
                    ulp: netlist.node(id).format.ulp(),
                    scale: trace.scale(),
                    quantity: trace.quantity,
                    ideal,
                    port: trace.port.filter(|_| goldens.into_iter().any(has)),
                    codes: trace
                        .twins
                        .iter()
                        .copied()
                        .zip(codes.into_iter().map(Real::new))
                        .collect(),
                }
            })
            .collect();
        let judged = shown.iter().any(|shown| shown.port.is_some());
        let program =
            Program::compile(netlist, &nodes).expect("bug: only nodes with a value have twins");
        let schedule = rtl.schedule();
        let angles = (!angles.is_empty()).then(|| {
            let program = batch::Program::compile(&design.netlist, &design.judged());
            let shown = angles
                .into_iter()
                .map(|(angle, code)| (angle.direction, u64::from(angle.stage), Real::new(code)));
            let directions = design.groups.iter().filter(|group| group.shape.is_direction());
            Angles {
                runner: program.runner(),
                program,
                shown: shown.collect(),
                columns: vec![Vec::new(); directions.count()],
            }
        });
        Self {
            design,
            runner: program.runner(),
            program,
            shown,
            interval: schedule.phases().into(),
            first,
            end: first,
            kept: cast::index_of_u32(schedule.latency() / schedule.phases()) + 2,
            ideals: vec![Vec::new(); nodes.len()],
            judged: vec![Vec::new(); if judged { netlist.outputs().len() } else { 0 }],
            angles,
            inputs: vec![Vec::new(); netlist.inputs().len()],
            block: vec![Vec::new(); nodes.len()],
        }
    }

    /// Writes what changed in a cycle.
    pub(super) fn change(
        &mut self,
        lines: &mut Lines<'_>,
        samples: &[Vec<i64>],
        cycle: &Cycle,
    ) -> io::Result<()> {
        if self.shown.is_empty() && self.angles.is_none() {
            return Ok(());
        }
        let (now, interval) = (cycle.edges(), self.interval);
        let latest = usize::try_from(now / interval).unwrap_or(usize::MAX);
        self.reach(samples, latest.min(samples.len().saturating_sub(1)));
        for shown in &mut self.shown {
            let Some(since) = now.checked_sub(u64::from(shown.stage)) else { continue };
            let sample = usize::try_from(since / interval).unwrap_or(usize::MAX);
            if sample >= samples.len() || (shown.own && since % interval > 0) {
                continue;
            }
            let at = sample - self.first;
            // As in `Format::value`.
            let value = cast::f64_of(cycle.words()[shown.slot]) * shown.ulp * shown.scale;
            let quantity = shown.quantity;
            // Angles differ by at most half a turn.
            let difference = |other: f64| {
                let difference = value - other;
                match quantity {
                    Quantity::Turns => difference - 360.0 * (difference / 360.0).round(),
                    Quantity::Number | Quantity::Float20 => difference,
                }
            };
            let ideal = shown.ideal.map_or(0.0, |column| self.ideals[column][at] * shown.scale);
            let golden = shown.port.map_or(0.0, |port| self.judged[port][at] * shown.scale);
            let ulp = shown.ulp * shown.scale;
            for (twin, real) in &mut shown.codes {
                let now = match twin {
                    Twin::Value => value,
                    Twin::Ideal => ideal,
                    Twin::ArithError => difference(ideal),
                    Twin::ArithErrorUlp => in_ulp(difference(ideal), ulp),
                    Twin::Golden => golden,
                    Twin::TotalError => difference(golden),
                    Twin::TotalErrorUlp => in_ulp(difference(golden), ulp),
                };
                real.change(lines, now)?;
            }
        }
        let Some(Angles { shown, columns, .. }) = &mut self.angles else { return Ok(()) };
        for (direction, stage, real) in shown {
            let Some(since) = now.checked_sub(*stage) else { continue };
            let sample = usize::try_from(since / interval).unwrap_or(usize::MAX);
            if sample < samples.len() {
                real.change(lines, columns[*direction][sample - self.first])?;
            }
        }
        Ok(())
    }

    /// Evaluates blocks of samples until `sample` is in the columns; drops those that have left the
    /// pipeline.
    fn reach(&mut self, samples: &[Vec<i64>], sample: usize) {
        while self.end <= sample {
            let block = &samples[self.end..samples.len().min(self.end + BLOCK)];
            let first = self.first.max(self.end.saturating_sub(self.kept));
            let angles = self.angles.iter_mut().flat_map(|angles| &mut angles.columns);
            let columns = self.ideals.iter_mut().chain(&mut self.judged).chain(angles);
            columns.for_each(|column| drop(column.drain(..first - self.first)));
            (self.first, self.end) = (first, self.end + block.len());
            let netlist = &self.design.netlist;
            for (port, (column, id)) in self.inputs.iter_mut().zip(netlist.inputs()).enumerate() {
                let format = netlist.node(*id).format;
                column.clear();
                column.extend(block.iter().map(|words| format.value(words[port])));
            }
            let inputs: Vec<&[f64]> = self.inputs.iter().map(Vec::as_slice).collect();
            self.runner.run(&self.program, &inputs, &mut self.block);
            for (column, block) in self.ideals.iter_mut().zip(&self.block) {
                column.extend(block);
            }
            if self.judged.is_empty() && self.angles.is_none() {
                continue;
            }
            let mut golden = vec![vec![0.0; block.len()]; self.design.golden_columns()];
            self.design.golden.run(&inputs, &mut golden);
            if let Some(angles) = &mut self.angles {
                angles.append(self.design, block, &golden);
            }
            if self.judged.is_empty() {
                continue;
            }
            let mut row = vec![0.0; golden.len()];
            for at in 0..block.len() {
                row.iter_mut().zip(&golden).for_each(|(value, column)| *value = column[at]);
                let judged = self.design.of_golden(&row);
                self.judged.iter_mut().zip(judged).for_each(|(column, value)| column.push(value));
            }
        }
    }
}
