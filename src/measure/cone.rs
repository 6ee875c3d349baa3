//! Measures one node over every combination of the words that it depends on.
//!
//! Samples count through the words, with the first port fastest; the ports on which most nodes of
//! the cone depend are the slowest. Within a run of samples the slow ports are constant and the
//! fastest repeat from block to block. The engine and the evaluation on reals compute nodes that
//! depend only on those once per run.

use super::inputs::{EXHAUSTIVE_BITS, Scale};
use super::report::{Basis, Figures, Lap, Profile, Report, Speed, Witness, overflow_counts};
use super::stream::{Counts, Differences, Histograms, Merged, Stream};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::simd::{Body, vectorised};
use crate::design::Design;
use crate::netlist::op::Op;
use crate::netlist::{Netlist, Node, NodeId, Quantity};
use crate::sim::batch::{self, BLOCK, check_overflows};
use crate::sim::real;
use rayon::prelude::*;
use std::f64::consts::TAU;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// Samples in a run: enough blocks to make the shared work cheap.
const RUN_BITS: u32 = 14;

/// A node, and the input ports that its words and its value on reals depend on.
#[derive(Clone, Debug)]
pub struct Cone {
    /// The node.
    pub node: NodeId,
    /// Indices of the ports, fastest-counting first.
    pub ports: Vec<usize>,
    /// Total bits of the ports.
    pub bits: u32,
}

impl Cone {
    /// The cone of a node, given by its label, the name of an output port, or its number, as in
    /// `%3`.
    ///
    /// # Errors
    /// If there is no such node, it has no value on reals, or there are too many combinations.
    pub fn new(netlist: &Netlist, label: &str) -> Result<Self> {
        let Some(node) = named(netlist, label) else {
            let nodes = netlist.ids().filter(|id| netlist.node(*id).name.is_some());
            let mut names: Vec<String> = nodes.map(|id| netlist.label(id)).collect();
            names.extend(netlist.outputs().iter().map(|output| output.name.clone()));
            names.sort_unstable();
            names.dedup();
            return Err(Error::usage(format!(
                "there is no node `{label}`: the named ones are {}; use a number for others, such as %3",
                names.join(", ")
            )));
        };
        if netlist.node(node).real.is_none() {
            return Err(Error::usage(format!(
                "node `{label}` is bits without a value on reals, so it has no error: choose a node for which `fixpath wave` shows a value"
            )));
        }
        let nodes = netlist.nodes();
        let mut users: Vec<Vec<usize>> = vec![Vec::new(); nodes.len()];
        let mut inside = vec![false; nodes.len()];
        inside[node.index()] = true;
        for index in (0..=node.index()).rev().filter(|i| nodes[*i].op != Op::Input) {
            if inside[index] {
                let meaning = nodes[index].meaning.iter().flat_map(|meaning| &meaning.of);
                for operand in nodes[index].operands.iter().chain(meaning) {
                    inside[operand.index()] = true;
                    users[operand.index()].push(index);
                }
            }
        }
        for id in netlist.ids().filter(|id| inside[id.index()]) {
            if let Op::Delay { .. } = nodes[id.index()].op {
                return Err(Error::earlier_samples(netlist.label(id)));
            }
            if let Some(memory) = netlist.read_of(id).filter(|table| table.is_unbound()) {
                return Err(Error::unbound_memory(&memory.name));
            }
        }
        let dependents = |port: usize| {
            let mut reached = vec![false; nodes.len()];
            reached[netlist.inputs()[port].index()] = true;
            for index in 0..nodes.len() {
                if reached[index] {
                    users[index].iter().for_each(|user| reached[*user] = true);
                }
            }
            reached.into_iter().filter(|reached| *reached).count()
        };
        let mut ports: Vec<usize> = (0..netlist.inputs().len())
            .filter(|port| inside[netlist.inputs()[*port].index()])
            .collect();
        ports.sort_by_key(|port| dependents(*port));
        let bits = |port: &usize| netlist.node(netlist.inputs()[*port]).format.bits();
        let total: u32 = ports.iter().map(bits).sum();
        if total > EXHAUSTIVE_BITS {
            let each: Vec<String> = ports
                .iter()
                .map(|port| format!("{} of {} bits", netlist.input_name(*port), bits(port)))
                .collect();
            return Err(Error::usage(format!(
                "node `{label}` depends on {}: 2^{total} combinations, but an exhaustive run is limited to 2^{EXHAUSTIVE_BITS}: use narrower inputs or a node further up",
                each.join(", ")
            )));
        }
        Ok(Self { node, ports, bits: total })
    }

    /// Number of combinations of words.
    #[must_use]
    pub fn samples(&self) -> u64 {
        1 << self.bits
    }

    /// Measures the node's words against its value on reals; `progress` receives the number of
    /// samples done.
    ///
    /// # Errors
    /// If a `narrow` under overflow mode `error` overflowed.
    pub fn measure(&self, design: &Design, progress: &(dyn Fn(u64) + Sync)) -> Result<ConeReport> {
        let netlist = &*design.netlist;
        let node = netlist.node(self.node);
        let pass = Pass::new(self, netlist)?;
        let narrows = pass.program.narrows();
        let start = Instant::now();
        let runs = self.samples() >> pass.run_bits;
        let threads = rayon::current_num_threads();
        let round = cast::count_of(threads) * 64;
        let mut merged = Merged::EMPTY;
        let mut overflows = vec![0; narrows.len()];
        let mut profile = Profile::default();
        let mut past_format = 0;
        let lanes = Mutex::new(Vec::new());
        let mut next = 0;
        while next < runs {
            let these: Vec<u64> = (next..(next + round).min(runs)).collect();
            let partials: Vec<_> = these
                .par_iter()
                .map(|run| {
                    // Columns are created once per thread.
                    let free = || lanes.lock().unwrap_or_else(PoisonError::into_inner);
                    let known = free().pop();
                    let mut lane = known.unwrap_or_else(|| pass.lane());
                    let partial = pass.run(&mut lane, *run);
                    free().push(lane);
                    partial
                })
                .collect();
            for Partial { stream, past, overflows: counts, profile: times } in partials {
                past_format += past;
                check_overflows(netlist, narrows, &counts)?;
                let words = pass.words(stream.at);
                let ports = words.iter().zip(netlist.inputs());
                let values = ports.map(|(word, id)| netlist.node(*id).format.value(*word));
                let values = values.collect();
                // The node's own word stands in for the outputs.
                let ran = netlist.eval(&words)?;
                let outputs = vec![ran.0[self.node.index()]];
                merged.merge(&stream, Witness { sample: stream.at, words, values, outputs });
                overflows.iter_mut().zip(counts).for_each(|(total, count)| *total += count);
                profile.add(&times);
            }
            next += round;
            progress((next << pass.run_bits).min(self.samples()));
        }
        // Dropping a lane adds its counts to the histogram.
        drop(lanes);
        let elapsed = start.elapsed().as_secs_f64();
        let rate = |seconds: f64| {
            if seconds > 0.0 { cast::f64_of_count(self.samples()) / seconds } else { 0.0 }
        };
        let ulp = node.format.ulp() * if pass.is_angle { TAU } else { 1.0 };
        let unit = if pass.is_angle { "rad" } else { "1" };
        let stream = merged.stream;
        let figures = Figures {
            max_ulp: Some(stream.max / ulp),
            witness: merged.witness,
            ..stream.figures(
                &netlist.label(self.node),
                unit,
                Basis::Arithmetic,
                &pass.histograms.of(0),
            )
        };
        let report = Report {
            samples: self.samples(),
            figures: vec![figures],
            overflows: overflow_counts(netlist, narrows, &overflows),
            speed: Speed {
                engine_samples_per_second_per_thread: rate(profile.engine),
                samples_per_second: rate(elapsed),
                threads,
                profile,
            },
        };
        Ok(ConeReport { report, past_format })
    }
}

/// The measurement of a cone.
#[derive(Clone, Debug)]
pub struct ConeReport {
    /// The figures, on the arithmetic basis.
    pub report: Report,
    /// Samples left out of the figures: their value on reals is outside the node's format by more
    /// than an ulp, or infinite, such as at poles, so that words saturate.
    pub past_format: u64,
}

/// The node with a label, of an output port, or with a number such as `%3`.
fn named(netlist: &Netlist, label: &str) -> Option<NodeId> {
    let by_label = netlist.ids().find(|id| netlist.label(*id) == label);
    let port = || netlist.outputs().iter().find(|output| output.name == label);
    // `%12`, or `n12` with the scopes that waves put before it.
    let last = label.rsplit('.').next().unwrap_or_default();
    let number = || label.strip_prefix('%').or(last.strip_prefix('n'))?.parse::<usize>().ok();
    by_label.or_else(|| port().map(|output| output.node)).or_else(|| {
        number()
            .filter(|number| *number < netlist.nodes().len())
            .map(|number| netlist.id_at(number))
    })
}

/// True if a node is an angle in turns, or computed from angles so that whole turns don't matter.
fn is_angle(netlist: &Netlist, node: NodeId) -> bool {
    let Node { op, operands, quantity, meaning, .. } = netlist.node(node);
    let angle = |id: &NodeId| is_angle(netlist, *id);
    if *quantity == Quantity::Turns {
        return true;
    }
    let sum = matches!(op, Op::Add | Op::Sub | Op::Neg | Op::Modulo | Op::Narrow { .. });
    let choice = matches!(op, Op::AddSub | Op::Mux);
    // The first operand of a choice only selects.
    meaning.is_none()
        && (sum && operands.iter().any(angle) || choice && operands[1..].iter().any(angle))
}

/// Data shared by all threads.
struct Pass<'a> {
    cone: &'a Cone,
    /// Whether errors are modulo a turn.
    is_angle: bool,
    netlist: &'a Netlist,
    /// Port indices, each with the position of its first bit in a sample's number.
    offsets: Vec<(usize, u32)>,
    /// Ports whose words are the same in each block of a run.
    repeats: Vec<bool>,
    run_bits: u32,
    program: batch::Program,
    reals: real::Program,
    histograms: Histograms,
}

/// The results of a run.
struct Partial {
    stream: Stream,
    past: u64,
    overflows: Vec<u64>,
    profile: Profile,
}

impl<'a> Pass<'a> {
    fn new(cone: &'a Cone, netlist: &'a Netlist) -> Result<Self> {
        let (mut offsets, mut at) = (Vec::new(), 0);
        let mut repeats = vec![true; netlist.inputs().len()];
        for port in &cone.ports {
            let end = at + netlist.node(netlist.inputs()[*port]).format.bits();
            repeats[*port] = end <= BLOCK.ilog2() || at >= RUN_BITS;
            offsets.push((*port, at));
            at = end;
        }
        Ok(Self {
            cone,
            is_angle: is_angle(netlist, cone.node),
            netlist,
            program: batch::Program::compile_cone(netlist, &[cone.node], &repeats),
            reals: real::Program::compile_repeated(netlist, &[cone.node], &repeats)?,
            offsets,
            repeats,
            run_bits: RUN_BITS.min(cone.bits),
            histograms: Histograms::new(1),
        })
    }

    fn lane(&self) -> Lane<'_> {
        let run = 1 << self.run_bits;
        let ports = self.cone.ports.len();
        Lane {
            runner: self.program.runner(),
            real_runner: self.reals.runner(),
            words: vec![vec![0; run]; ports],
            values: vec![vec![0.0; run]; ports],
            zero_words: vec![0; run],
            zero_values: vec![0.0; run],
            given: vec![Vec::new()],
            ideal: vec![Vec::new()],
            value: vec![0.0; run],
            errors: vec![0.0; run],
            counts: Counts::new(&self.histograms, 1),
        }
    }

    /// The word of each port for a sample's number; 0 for ports outside the cone.
    fn words(&self, sample: u64) -> Vec<i64> {
        let mut words = vec![0; self.netlist.inputs().len()];
        for (port, at) in &self.offsets {
            let format = self.netlist.node(self.netlist.inputs()[*port]).format;
            words[*port] = format.wrap(cast::word_of_bits(sample >> at));
        }
        words
    }

    fn run(&self, lane: &mut Lane<'_>, run: u64) -> Partial {
        let from = run << self.run_bits;
        let node = self.netlist.node(self.cone.node);
        let mut profile = Profile::default();
        let mut lap = Lap(Instant::now());
        lane.counts.make_room(lane.errors.len());
        for (i, (port, at)) in self.offsets.iter().enumerate() {
            let format = self.netlist.node(self.netlist.inputs()[*port]).format;
            let words = &mut lane.words[i];
            // Only the first block of repeating ports is read.
            let len = if self.repeats[*port] { words.len().min(BLOCK) } else { words.len() };
            let words = &mut words[..len];
            for (word, sample) in words.iter_mut().zip(from..) {
                *word = format.wrap(cast::word_of_bits(sample >> at));
            }
            let to = &mut lane.values[i][..len];
            vectorised(Scale { words, ulp: format.ulp(), to });
        }
        profile.quantise = lap.seconds();
        let before = lane.runner.overflows().to_vec();
        let mut columns: Vec<&[i64]> = vec![&lane.zero_words; self.netlist.inputs().len()];
        for ((port, _), words) in self.offsets.iter().zip(&lane.words) {
            columns[*port] = words;
        }
        let ran = lane.runner.run(&self.program, &columns, &mut lane.given);
        ran.expect("bug: words are of their ports' formats");
        profile.engine = lap.seconds();
        let mut columns: Vec<&[f64]> = vec![&lane.zero_values; self.netlist.inputs().len()];
        for ((port, _), values) in self.offsets.iter().zip(&lane.values) {
            columns[*port] = values;
        }
        lane.real_runner.run(&self.reals, &columns, &mut lane.ideal);
        profile.reals = lap.seconds();
        let (words, to) = (&lane.given[0], &mut lane.value);
        vectorised(Scale { words, ulp: node.format.ulp(), to });
        let (is, should, errors) = (&lane.value, &lane.ideal[0], &mut lane.errors);
        vectorised(Differences { is, should, factor: 1.0, errors });
        if self.is_angle {
            vectorised(Arcs { errors: &mut lane.errors });
        }
        let past = self.leave_out(&lane.ideal[0], &mut lane.errors);
        let mut stream = Stream::of(&lane.errors, from, lane.counts.of(0));
        // The samples left out were counted as errors of 0.
        stream.count -= u64::from(past);
        lane.counts.of(0)[0] -= past;
        let overflows = lane.runner.overflows().iter().zip(before);
        let overflows = overflows.map(|(after, before)| after - before).collect();
        profile.statistics = lap.seconds();
        Partial { stream, past: past.into(), overflows, profile }
    }
}

impl Pass<'_> {
    /// Clears and counts the errors of samples whose value on reals is outside the format.
    fn leave_out(&self, ideal: &[f64], errors: &mut [f64]) -> u32 {
        let format = self.netlist.node(self.cone.node).format;
        let (low, high) = if self.is_angle {
            (f64::MIN, f64::MAX)
        } else {
            (
                format.value(format.min_raw()) - format.ulp(),
                format.value(format.max_raw()) + format.ulp(),
            )
        };
        let mut past = 0;
        for (error, ideal) in errors.iter_mut().zip(ideal) {
            let inside = *ideal >= low && *ideal <= high;
            past += u32::from(!inside);
            *error = if inside { *error } else { 0.0 };
        }
        past
    }
}

/// Columns of a thread.
struct Lane<'a> {
    runner: batch::Runner,
    real_runner: real::Runner,
    /// For the cone's ports.
    words: Vec<Vec<i64>>,
    values: Vec<Vec<f64>>,
    /// For all other ports.
    zero_words: Vec<i64>,
    zero_values: Vec<f64>,
    given: Vec<Vec<i64>>,
    ideal: Vec<Vec<f64>>,
    value: Vec<f64>,
    errors: Vec<f64>,
    counts: Counts<'a>,
}

/// Converts differences of angles in turns to arcs in rad, at most half a turn.
struct Arcs<'a> {
    errors: &'a mut [f64],
}

impl Body for Arcs<'_> {
    #[inline(always)]
    fn run(self) {
        for error in self.errors {
            *error = (*error - error.round_ties_even()) * TAU;
        }
    }
}
