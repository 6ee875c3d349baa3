//! A named node over every combination of the words that it depends on.
//!
//! Words are counted up, the first of the ports fastest; the ports that most nodes of the cone depend
//! on are the slowest. In a run of samples the slow ports stay and the fastest repeat from block to block,
//! so what depends on those only is computed once a run, by the engine and on reals.

use super::{
    Basis, Counts, Differences, Figures, Histograms, Lap, Merged, Profile, Report, Speed, Stream,
    Witness, overflow_counts,
};
use crate::cast;
use crate::error::{Error, Result};
use crate::netlist::{Netlist, NodeId, Quantity};
use crate::sim::batch::{self, BLOCK, check_overflows};
use crate::sim::real;
use crate::simd::{Body, vectorised};
use crate::units::Design;
use rayon::prelude::*;
use std::f64::consts::TAU;
use std::time::Instant;

use super::inputs::{EXHAUSTIVE_BITS, Scale};

/// Samples in a run: blocks enough that what they share costs little.
const RUN_BITS: u32 = 14;

/// A node and the input ports that its words and its value on reals depend on.
#[derive(Clone, Debug)]
pub struct Cone {
    /// The node.
    pub node: NodeId,
    /// Numbers of the ports, the one that is counted fastest first.
    pub ports: Vec<usize>,
    /// Bits of all of them.
    pub bits: u32,
}

impl Cone {
    /// The cone of a node by its label, as `show` lists it.
    ///
    /// # Errors
    /// If there is no such node, it has no value on reals, or there are too many combinations.
    pub fn new(netlist: &Netlist, label: &str) -> Result<Self> {
        let Some(node) = netlist.ids().find(|id| netlist.label(*id) == label) else {
            let named = netlist.ids().filter(|id| netlist.node(*id).name.is_some());
            let names: Vec<String> = named.map(|id| netlist.label(id)).collect();
            return Err(Error::usage(format!(
                "there is no node `{label}`: the named ones are {}",
                names.join(", ")
            )));
        };
        if !netlist.node(node).has_real {
            return Err(Error::usage(format!(
                "node `{label}` is bits without a value on reals, so it has no error: take a node that `fixpath wave` gives a value"
            )));
        }
        let nodes = netlist.nodes();
        let mut users: Vec<Vec<usize>> = vec![Vec::new(); nodes.len()];
        let mut inside = vec![false; nodes.len()];
        inside[node.index()] = true;
        for index in (0..=node.index()).rev().filter(|i| nodes[*i].op != crate::op::Op::Input) {
            if inside[index] {
                let meaning = nodes[index].meaning.into_iter().flat_map(|m| m.arguments());
                for operand in nodes[index].operands.iter().copied().chain(meaning.flatten()) {
                    inside[operand.index()] = true;
                    users[operand.index()].push(index);
                }
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
                "node `{label}` depends on {}: 2^{total} combinations, and an exhaustive run goes up to 2^{EXHAUSTIVE_BITS}: take narrower inputs or a node further up",
                each.join(", ")
            )));
        }
        Ok(Self { node, ports, bits: total })
    }

    /// Combinations of words.
    #[must_use]
    pub fn samples(&self) -> u64 {
        1 << self.bits
    }

    /// Measures the node's words against its value on reals; `progress` gets the samples done.
    ///
    /// # Errors
    /// If a `narrow` under overflow mode `error` overflowed.
    pub fn measure(&self, design: &Design, progress: &(dyn Fn(u64) + Sync)) -> Result<Report> {
        let netlist = &*design.netlist;
        let node = netlist.node(self.node);
        let pass = Pass::new(self, netlist);
        let narrows = pass.program.narrows();
        let start = Instant::now();
        let runs = self.samples() >> pass.run_bits;
        let threads = rayon::current_num_threads();
        let round = cast::count_of(threads) * 64;
        let mut merged = Merged::EMPTY;
        let mut overflows = vec![0; narrows.len()];
        let mut profile = Profile::default();
        let mut next = 0;
        while next < runs {
            let these: Vec<u64> = (next..(next + round).min(runs)).collect();
            let partials: Vec<_> = these
                .par_iter()
                .map_init(|| pass.lane(), |lane, run| pass.run(lane, *run))
                .collect();
            for Partial { stream, overflows: counts, profile: times } in partials {
                check_overflows(netlist, narrows, &counts)?;
                let words = pass.words(stream.at);
                let ports = words.iter().zip(netlist.inputs());
                let values = ports.map(|(word, id)| netlist.node(*id).format.value(*word));
                let values = values.collect();
                // The node's own word stands for the outputs.
                let outputs = vec![netlist.eval(&words).0[self.node.index()]];
                merged.merge(&stream, Witness { sample: stream.at, words, values, outputs });
                overflows.iter_mut().zip(counts).for_each(|(total, count)| *total += count);
                profile.add(&times);
            }
            next += round;
            progress((next << pass.run_bits).min(self.samples()));
        }
        let elapsed = start.elapsed().as_secs_f64();
        let rate = |seconds: f64| {
            if seconds > 0.0 { cast::f64_of_count(self.samples()) / seconds } else { 0.0 }
        };
        let turns = node.quantity == Quantity::Turns;
        let ulp = node.format.ulp() * if turns { TAU } else { 1.0 };
        let unit = if turns { "rad" } else { "1" };
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
        Ok(Report {
            samples: self.samples(),
            figures: vec![figures],
            overflows: overflow_counts(netlist, narrows, &overflows),
            speed: Speed {
                engine_samples_per_second_per_thread: rate(profile.engine),
                samples_per_second: rate(elapsed),
                threads,
                profile,
            },
        })
    }
}

/// What all threads share.
struct Pass<'a> {
    cone: &'a Cone,
    netlist: &'a Netlist,
    /// Numbers of ports, and the first of their bits in a sample's number.
    offsets: Vec<(usize, u32)>,
    /// Ports whose words are the same in each block of a run.
    repeats: Vec<bool>,
    run_bits: u32,
    program: batch::Program,
    reals: real::Program,
    histograms: Histograms,
}

/// What a run gave.
struct Partial {
    stream: Stream,
    overflows: Vec<u64>,
    profile: Profile,
}

impl<'a> Pass<'a> {
    fn new(cone: &'a Cone, netlist: &'a Netlist) -> Self {
        let (mut offsets, mut at) = (Vec::new(), 0);
        let mut repeats = vec![true; netlist.inputs().len()];
        for port in &cone.ports {
            let end = at + netlist.node(netlist.inputs()[*port]).format.bits();
            repeats[*port] = end <= BLOCK.ilog2() || at >= RUN_BITS;
            offsets.push((*port, at));
            at = end;
        }
        Self {
            cone,
            netlist,
            program: batch::Program::compile_cone(netlist, &[cone.node], &repeats),
            reals: real::Program::compile_cone(netlist, &[cone.node], &repeats),
            offsets,
            repeats,
            run_bits: RUN_BITS.min(cone.bits),
            histograms: Histograms::new(1),
        }
    }

    fn lane(&self) -> Lane<'_> {
        let (ports, run) = (self.netlist.inputs().len(), 1 << self.run_bits);
        Lane {
            runner: self.program.runner(),
            real_runner: self.reals.runner(),
            words: vec![vec![0; run]; ports],
            values: vec![vec![0.0; run]; ports],
            given: vec![Vec::new()],
            ideal: vec![Vec::new()],
            value: vec![0.0; run],
            errors: vec![0.0; run],
            counts: Counts::new(&self.histograms, 1),
        }
    }

    /// The word at each port for a sample's number; 0 at ports outside the cone.
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
        for (port, at) in &self.offsets {
            let format = self.netlist.node(self.netlist.inputs()[*port]).format;
            let words = &mut lane.words[*port];
            // Of what repeats, only the first block is read.
            let len = if self.repeats[*port] { words.len().min(BLOCK) } else { words.len() };
            let words = &mut words[..len];
            for (word, sample) in words.iter_mut().zip(from..) {
                *word = format.wrap(cast::word_of_bits(sample >> at));
            }
            let to = &mut lane.values[*port][..len];
            vectorised(Scale { words, ulp: format.ulp(), to });
        }
        profile.quantise = lap.seconds();
        let before = lane.runner.overflows().to_vec();
        let columns: Vec<&[i64]> = lane.words.iter().map(Vec::as_slice).collect();
        lane.runner.run(&self.program, &columns, &mut lane.given);
        profile.engine = lap.seconds();
        let columns: Vec<&[f64]> = lane.values.iter().map(Vec::as_slice).collect();
        lane.real_runner.run(&self.reals, &columns, &mut lane.ideal);
        profile.reals = lap.seconds();
        let (words, to) = (&lane.given[0], &mut lane.value);
        vectorised(Scale { words, ulp: node.format.ulp(), to });
        let (is, should, errors) = (&lane.value, &lane.ideal[0], &mut lane.errors);
        vectorised(Differences { is, should, factor: 1.0, errors });
        if node.quantity == Quantity::Turns {
            vectorised(Arcs { errors: &mut lane.errors });
        }
        let stream = Stream::of(&lane.errors, from, lane.counts.of(0));
        let overflows = lane.runner.overflows().iter().zip(before);
        let overflows = overflows.map(|(after, before)| after - before).collect();
        profile.statistics = lap.seconds();
        Partial { stream, overflows, profile }
    }
}

/// Columns of a thread.
struct Lane<'a> {
    runner: batch::Runner,
    real_runner: real::Runner,
    words: Vec<Vec<i64>>,
    values: Vec<Vec<f64>>,
    given: Vec<Vec<i64>>,
    ideal: Vec<Vec<f64>>,
    value: Vec<f64>,
    errors: Vec<f64>,
    counts: Counts<'a>,
}

/// Differences of angles in turns become arcs in rad, of half a turn at most.
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
