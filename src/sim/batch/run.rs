//! Runs programs over callers' columns, block by block.

use super::program::{BLOCK, Column, Port, Program};
use super::step::run_block;
use super::store::{Lanes, Store, columns, fill};
use super::word::{Inside, Word};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::simd::{Body, Features, prefetch, vectorised_for};
use crate::netlist::{Netlist, NodeId};
use crate::number::format::Overflow;
use crate::sim::kernels::Lane;
use crate::sim::lanes::Width;
use std::collections::VecDeque;

impl Program {
    /// Creates a runner with its own columns.
    #[must_use]
    pub fn runner(&self) -> Runner {
        self.runner_for(Features::best())
    }

    /// As [`Program::runner`], for a set of processor features. If this processor lacks them, the
    /// baseline is used.
    #[must_use]
    pub fn runner_for(&self, features: Features) -> Runner {
        let mut store = Store {
            features,
            lanes16: columns(self.slots[0]),
            lanes32: columns(self.slots[1]),
            lanes64: columns(self.slots[2]),
            delays: self.delays.iter().map(|samples| line(*samples)).collect(),
        };
        for (column, raw) in &self.constants {
            match column.width {
                Width::W16 => fill(&mut store.lanes16[column.slot], *raw),
                Width::W32 => fill(&mut store.lanes32[column.slot], *raw),
                Width::W64 => fill(&mut store.lanes64[column.slot], *raw),
            }
        }
        let counters = self.narrows.len().max(1);
        Runner {
            store,
            overflows: vec![0; counters],
            repeated: vec![0; counters],
            narrows: self.narrows.len(),
        }
    }
}

/// The contents of a delay after a reset.
fn line(samples: u32) -> VecDeque<i64> {
    vec![0; cast::index_of_u32(samples)].into()
}

/// Columns for one thread. Each run resumes with the samples after those of the previous run.
#[derive(Debug)]
pub struct Runner {
    store: Store,
    /// Overflows of each `narrow`; at least one counter.
    overflows: Vec<u64>,
    /// Overflows per block of the instructions that run once for all blocks.
    repeated: Vec<u64>,
    narrows: usize,
}

impl Runner {
    /// Simulates as many samples as the input columns hold; `outputs` are overwritten.
    ///
    /// # Errors
    /// As [`Runner::run_words`].
    pub fn run(
        &mut self,
        program: &Program,
        inputs: &[&[i64]],
        outputs: &mut [Vec<i64>],
    ) -> Result<()> {
        self.run_words(program, inputs, outputs)
    }

    /// As [`Runner::run`], for words that were quantised to the ports' formats and need no check.
    pub(crate) fn run_quantised(
        &mut self,
        program: &Program,
        inputs: &[&[i64]],
        outputs: &mut [Vec<i64>],
    ) -> Result<()> {
        self.run_columns(program, inputs, outputs, false)
    }

    /// As [`Runner::run`], on columns of any [`Word`] type: narrow ones save time.
    ///
    /// # Errors
    /// If there isn't a column for each port and each output of the program, columns differ in
    /// length, a port that is read has a word outside its format, or an output has words that its
    /// column can't hold. Results computed until then are invalid.
    pub fn run_words<I: Word, O: Word>(
        &mut self,
        program: &Program,
        inputs: &[&[I]],
        outputs: &mut [Vec<O>],
    ) -> Result<()> {
        self.run_columns(program, inputs, outputs, true)
    }

    fn run_columns<I: Word, O: Word>(
        &mut self,
        program: &Program,
        inputs: &[&[I]],
        outputs: &mut [Vec<O>],
        checked: bool,
    ) -> Result<()> {
        if let Some(memory) = &program.unbound {
            return Err(Error::unbound_memory(memory));
        }
        let count = check_columns(program, inputs, outputs)?;
        for column in outputs.iter_mut() {
            column.resize(count, O::default());
        }
        let Self { store, overflows, repeated, .. } = self;
        let features = store.features;
        let mut start = 0;
        while start < count {
            let len = BLOCK.min(count - start);
            let again = start > 0;
            let mut outside = None;
            let seen = checked.then_some(&mut outside);
            let load = Load { program, store, inputs, again, start, len, outside: seen };
            vectorised_for(features, load);
            if let Some(port) = outside {
                return Err(outside_of(&program.ports[port], &inputs[port][start..], start));
            }
            if again {
                // Instructions that are skipped would overflow again.
                overflows.iter_mut().zip(&*repeated).for_each(|(count, more)| *count += more);
            } else if program.repeated > 0 {
                repeated.copy_from_slice(overflows);
                run_block(program, store, 0..program.repeated, len, overflows);
                repeated.iter_mut().zip(&*overflows).for_each(|(more, now)| *more = now - *more);
            }
            let next = start + len..count.min(start + len + BLOCK);
            for ((input, port), repeats) in inputs.iter().zip(&program.inputs).zip(&program.repeats)
            {
                if port.is_some() && !repeats {
                    prefetch(&input[next.clone()]);
                }
            }
            let rest = program.repeated..program.instructions.len();
            run_block(program, store, rest, len, overflows);
            vectorised_for(features, Unload { program, store, outputs, start, len });
            start += len;
        }
        Ok(())
    }

    /// Clears earlier samples, as a reset does.
    pub fn reset(&mut self, program: &Program) {
        for (under_way, samples) in self.store.delays.iter_mut().zip(&program.delays) {
            *under_way = line(*samples);
        }
    }

    /// Overflows of each `narrow` so far, in the order of [`Program::narrows`].
    #[must_use]
    pub fn overflows(&self) -> &[u64] {
        &self.overflows[..self.narrows]
    }

    /// An error if a `narrow` under [`Overflow::Error`] overflowed.
    ///
    /// # Errors
    /// If one overflowed; the error names the node.
    pub fn check(&self, program: &Program, netlist: &Netlist) -> Result<()> {
        check_overflows(netlist, program.narrows(), self.overflows())
    }
}

/// An error if a `narrow` under [`Overflow::Error`] has a count above 0.
///
/// # Errors
/// If one has; the error names the node.
pub fn check_overflows(netlist: &Netlist, narrows: &[NodeId], counts: &[u64]) -> Result<()> {
    for (id, count) in narrows.iter().zip(counts) {
        let forbidden = netlist.node(*id).op.overflow() == Some(Overflow::Error);
        if forbidden && *count > 0 {
            return Err(Error::node_overflow(netlist.label(*id), *count));
        }
    }
    Ok(())
}

/// Copies a block of the callers' columns into those of the ports.
struct Load<'a, 'b, I> {
    program: &'a Program,
    store: &'a mut Store,
    inputs: &'a [&'b [I]],
    /// Skips repeating ports, which are already loaded.
    again: bool,
    start: usize,
    len: usize,
    /// If words are checked, receives a port with words outside its format.
    outside: Option<&'a mut Option<usize>>,
}

impl<I: Word> Body for Load<'_, '_, I> {
    #[inline(always)]
    fn run(self) {
        let Self { program, store, inputs, again, start, len, mut outside } = self;
        for (port, (column, input)) in program.inputs.iter().zip(inputs).enumerate() {
            let Some(Column { width, slot }) = *column else { continue };
            if again && program.repeats[port] {
                continue;
            }
            let input = &input[start..start + len];
            let Some(outside) = &mut outside else {
                match width {
                    Width::W16 => load(input, &mut store.lanes16[slot]),
                    Width::W32 => load(input, &mut store.lanes32[slot]),
                    Width::W64 => load(input, &mut store.lanes64[slot]),
                }
                continue;
            };
            let inside = Inside::new(program.ports[port].format);
            let holds = match width {
                Width::W16 => load_checked(input, inside, &mut store.lanes16[slot]),
                Width::W32 => load_checked(input, inside, &mut store.lanes32[slot]),
                Width::W64 => load_checked(input, inside, &mut store.lanes64[slot]),
            };
            if !holds {
                outside.get_or_insert(port);
            }
        }
    }
}

/// Fills a column.
#[inline(always)]
fn load<I: Word, L: Lane>(from: &[I], to: &mut Option<Box<Lanes<L>>>) {
    let to = to.as_mut().expect("bug: no column is taken out");
    for (to, word) in to.0.iter_mut().zip(from) {
        *to = L::of(word.word());
    }
}

/// Fills a column; returns whether all words are inside.
#[inline(always)]
fn load_checked<I: Word, L: Lane>(
    from: &[I],
    inside: Inside<I>,
    to: &mut Option<Box<Lanes<L>>>,
) -> bool {
    let to = to.as_mut().expect("bug: no column is taken out");
    let mut seen = I::default();
    for (to, word) in to.0.iter_mut().zip(from) {
        *to = L::of(word.word());
        seen = inside.see(*word, seen);
    }
    inside.holds(seen)
}

/// The number of samples in the columns, or why the columns don't fit the program.
fn check_columns<I: Word, O: Word>(
    program: &Program,
    inputs: &[&[I]],
    outputs: &[Vec<O>],
) -> Result<usize> {
    let columns = |what: &str, given: usize, ports: &[Port]| {
        let right = given == ports.len();
        let problem = || {
            let names: Vec<&str> = ports.iter().map(|port| &port.name[..]).collect();
            format!("{given} columns of {what}: one is needed for each of {}", names.join(", "))
        };
        if right { Ok(()) } else { Err(Error::usage(problem())) }
    };
    columns("input words", inputs.len(), &program.ports)?;
    columns("output words", outputs.len(), &program.results)?;
    let count = inputs.first().map_or(0, |column| column.len());
    if let Some(at) = inputs.iter().position(|column| column.len() != count) {
        return Err(Error::usage(format!(
            "the column of port `{}` has {} words and that of `{}` has {count}: give each the same number",
            program.ports[at].name,
            inputs[at].len(),
            program.ports[0].name
        )));
    }
    if program.repeats.contains(&true) && count > BLOCK && !count.is_multiple_of(BLOCK) {
        return Err(Error::usage(format!(
            "{count} samples where blocks of {BLOCK} repeat words: give at most one block, or whole blocks"
        )));
    }
    let held = |port: &&Port| {
        (O::RANGE.0..=O::RANGE.1).contains(&port.format.min_raw())
            && (O::RANGE.0..=O::RANGE.1).contains(&port.format.max_raw())
    };
    match program.results.iter().find(|port| !held(port)) {
        None => Ok(count),
        Some(Port { name, format }) => Err(Error::usage(format!(
            "words of `{name}` are {format} and its column holds {} to {}: use a wider number type",
            O::RANGE.0,
            O::RANGE.1
        ))),
    }
}

/// The error for the first word of a block that is outside a port's format.
#[cold]
fn outside_of<I: Word>(port: &Port, block: &[I], start: usize) -> Error {
    let Port { name, format } = port;
    let at = block.iter().position(|word| !format.contains(word.word()));
    let at = at.expect("bug: there is one in the block");
    let word = block[at].word();
    Error::outside_port(name.clone(), word, Some(start + at), format.spelled())
}

/// Copies the columns of the outputs into the callers'.
struct Unload<'a, O> {
    program: &'a Program,
    store: &'a Store,
    outputs: &'a mut [Vec<O>],
    start: usize,
    len: usize,
}

impl<O: Word> Body for Unload<'_, O> {
    #[inline(always)]
    fn run(self) {
        let Self { program, store, outputs, start, len } = self;
        for ((Column { width, slot }, zero), output) in program.outputs.iter().zip(outputs) {
            let (output, slot) = (&mut output[start..start + len], *slot);
            match width {
                Width::W16 => unload(*zero, &store.lanes16[slot], output),
                Width::W32 => unload(*zero, &store.lanes32[slot], output),
                Width::W64 => unload(*zero, &store.lanes64[slot], output),
            }
        }
    }
}

#[inline(always)]
fn unload<O: Word, L: Lane>(zero: bool, from: &Option<Box<Lanes<L>>>, to: &mut [O]) {
    let from = from.as_ref().expect("bug: no column is taken out");
    let pairs = to.iter_mut().zip(&from.0);
    if zero {
        pairs.for_each(|(to, lane)| *to = O::of_word(lane.raw_of_pattern()));
    } else {
        pairs.for_each(|(to, lane)| *to = O::of_word(lane.raw()));
    }
}
