//! The reals beside words: value, ideal, arithmetic error, golden, total error.
//!
//! Ideal and golden belong to a sample, not to a cycle: they are evaluated for a block of samples at
//! once, by the engine on reals and by the golden model. Columns hold them from the oldest
//! sample in the pipeline on, so memory doesn't grow with the wave.

use super::Trace;
use super::text::{Code, Lines};
use crate::cast;
use crate::netlist::{NodeId, Quantity};
use crate::rtl::Rtl;
use crate::sim::cycle::Cycle;
use crate::sim::real::{Program, Runner};
use crate::units::Design;
use std::io;
use vcd::IdCode;

/// Samples that are evaluated at once.
const BLOCK: usize = 1024;

/// All twins of a wave.
pub(super) struct Twins<'a> {
    design: &'a Design,
    program: Program,
    runner: Runner,
    shown: Vec<Shown>,
    interval: u64,
    /// Columns hold the samples from `first` to before `end`.
    first: usize,
    end: usize,
    /// Samples that can be in the pipeline.
    kept: usize,
    /// By node that has an ideal.
    ideals: Vec<Vec<f64>>,
    /// By output port, which are the first of what is judged; none if no golden is shown.
    judged: Vec<Vec<f64>>,
    /// Inputs and ideals of a block.
    inputs: Vec<Vec<f64>>,
    block: Vec<Vec<f64>>,
}

/// The twins of a signal.
struct Shown {
    slot: usize,
    stage: u32,
    /// True if the word is there in its phase only.
    own: bool,
    ulp: f64,
    scale: f64,
    quantity: Quantity,
    /// Column of the ideal.
    ideal: Option<usize>,
    /// The output port that it is.
    port: Option<usize>,
    /// Identifiers, and what they show.
    codes: Vec<(Code, Option<u64>)>,
}

impl<'a> Twins<'a> {
    /// Twins of signals with these identifiers; the earliest sample that is seen is `first`.
    pub(super) fn new(
        design: &'a Design,
        rtl: &Rtl,
        cycle: &Cycle,
        signals: Vec<(&Trace, Vec<IdCode>)>,
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
                let ideal = (codes.len() > 1).then(|| {
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
                    port: trace.port,
                    codes: codes.into_iter().map(|code| (Code::from(code), None)).collect(),
                }
            })
            .collect();
        let judged = shown.iter().any(|shown| shown.port.is_some());
        let program = Program::compile(netlist, &nodes);
        let schedule = rtl.schedule();
        Self {
            design,
            runner: program.runner(),
            program,
            shown,
            interval: schedule.interval().into(),
            first,
            end: first,
            kept: cast::index_of_u32(schedule.latency() / schedule.interval()) + 2,
            ideals: vec![Vec::new(); nodes.len()],
            judged: vec![Vec::new(); if judged { netlist.outputs().len() } else { 0 }],
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
        if self.shown.is_empty() {
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
            // As `Format::value`.
            let value = cast::f64_of(cycle.words()[shown.slot]) * shown.ulp * shown.scale;
            let quantity = shown.quantity;
            // Angles differ by half a turn at most.
            let difference = |other: f64| {
                let difference = value - other;
                match quantity {
                    Quantity::Turns => difference - 360.0 * (difference / 360.0).round(),
                    Quantity::Number | Quantity::Float20 => difference,
                }
            };
            let ideal = shown.ideal.map_or(0.0, |column| self.ideals[column][at] * shown.scale);
            let golden = shown.port.map_or(0.0, |port| self.judged[port][at] * shown.scale);
            let values = [value, ideal, difference(ideal), golden, difference(golden)];
            for ((code, last), value) in shown.codes.iter_mut().zip(values) {
                if *last != Some(value.to_bits()) {
                    *last = Some(value.to_bits());
                    lines.real(value, code)?;
                }
            }
        }
        Ok(())
    }

    /// Evaluates blocks of samples until one is in the columns; those that have left go.
    fn reach(&mut self, samples: &[Vec<i64>], sample: usize) {
        while self.end <= sample {
            let block = &samples[self.end..samples.len().min(self.end + BLOCK)];
            let first = self.first.max(self.end.saturating_sub(self.kept));
            let columns = self.ideals.iter_mut().chain(&mut self.judged);
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
            if self.judged.is_empty() {
                continue;
            }
            let mut golden = vec![vec![0.0; block.len()]; self.design.golden_columns()];
            (self.design.golden)(&self.design.values, &inputs, &mut golden);
            let mut row = vec![0.0; golden.len()];
            for at in 0..block.len() {
                row.iter_mut().zip(&golden).for_each(|(value, column)| *value = column[at]);
                let judged = self.design.of_golden(&row);
                self.judged.iter_mut().zip(judged).for_each(|(column, value)| column.push(value));
            }
        }
    }
}
