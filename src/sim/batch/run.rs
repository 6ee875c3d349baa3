//! Programs run over callers' columns, block by block.

use super::program::{BLOCK, Column, Program};
use super::step::run_block;
use super::store::{Lanes, Store, columns, fill};
use super::word::Word;
use crate::base::error::{Error, Result};
use crate::base::simd::{Body, Features, prefetch, vectorised_for};
use crate::netlist::{Netlist, NodeId};
use crate::number::format::Overflow;
use crate::sim::kernels::Lane;
use crate::sim::lanes::Width;

impl Program {
    /// Makes a runner with columns of its own.
    #[must_use]
    pub fn runner(&self) -> Runner {
        self.runner_for(Features::best())
    }

    /// As [`Program::runner`], for a set of processor features; the baseline if this processor
    /// lacks them.
    #[must_use]
    pub fn runner_for(&self, features: Features) -> Runner {
        let mut store = Store {
            features,
            lanes16: columns(self.slots[0]),
            lanes32: columns(self.slots[1]),
            lanes64: columns(self.slots[2]),
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

/// Columns for one thread.
#[derive(Debug)]
pub struct Runner {
    store: Store,
    /// Of each `narrow`, and at least one.
    overflows: Vec<u64>,
    /// Those of one block, of instructions that are run once for all blocks.
    repeated: Vec<u64>,
    narrows: usize,
}

impl Runner {
    /// Simulates as many samples as the input columns hold; `outputs` are overwritten.
    ///
    /// # Panics
    /// If the columns don't match the program's ports or differ in length.
    pub fn run(&mut self, program: &Program, inputs: &[&[i64]], outputs: &mut [Vec<i64>]) {
        self.run_words(program, inputs, outputs);
    }

    /// As [`Runner::run`] on columns of any [`Word`]s that hold those of all ports: narrow ones
    /// save time.
    ///
    /// # Panics
    /// If the columns don't match the program's ports or differ in length.
    pub fn run_words<I: Word, O: Word>(
        &mut self,
        program: &Program,
        inputs: &[&[I]],
        outputs: &mut [Vec<O>],
    ) {
        assert_eq!(inputs.len(), program.inputs.len(), "bug: one column per input");
        assert_eq!(outputs.len(), program.outputs.len(), "bug: one column per output");
        let count = inputs.first().map_or(0, |column| column.len());
        assert!(inputs.iter().all(|column| column.len() == count), "bug: columns differ in length");
        for column in outputs.iter_mut() {
            column.resize(count, O::default());
        }
        let some_repeats = program.repeats.contains(&true);
        assert!(
            !some_repeats || count <= BLOCK || count.is_multiple_of(BLOCK),
            "bug: blocks repeat words, and the last is short"
        );
        let Self { store, overflows, repeated, .. } = self;
        let features = store.features;
        let mut start = 0;
        while start < count {
            let len = BLOCK.min(count - start);
            let again = start > 0;
            vectorised_for(features, Load { program, store, inputs, again, start, len });
            if again {
                // What isn't computed again would overflow again.
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
    }

    /// How often each `narrow` overflowed so far, in the order of [`Program::narrows`].
    #[must_use]
    pub fn overflows(&self) -> &[u64] {
        &self.overflows[..self.narrows]
    }

    /// An error if a `narrow` under [`Overflow::Error`] overflowed.
    ///
    /// # Errors
    /// Names the node.
    pub fn check(&self, program: &Program, netlist: &Netlist) -> Result<()> {
        check_overflows(netlist, program.narrows(), self.overflows())
    }
}

/// An error if a `narrow` under [`Overflow::Error`] has a count above 0.
///
/// # Errors
/// Names the node.
pub fn check_overflows(netlist: &Netlist, narrows: &[NodeId], counts: &[u64]) -> Result<()> {
    for (id, count) in narrows.iter().zip(counts) {
        let forbidden = netlist.node(*id).op.overflow() == Some(Overflow::Error);
        if forbidden && *count > 0 {
            return Err(Error::node_overflow(netlist.label(*id), *count));
        }
    }
    Ok(())
}

/// A block of the callers' columns into those of the ports.
struct Load<'a, 'b, I> {
    program: &'a Program,
    store: &'a mut Store,
    inputs: &'a [&'b [I]],
    /// Not what repeats: it is there.
    again: bool,
    start: usize,
    len: usize,
}

impl<I: Word> Body for Load<'_, '_, I> {
    #[inline(always)]
    fn run(self) {
        let Self { program, store, inputs, again, start, len } = self;
        for ((column, input), repeats) in program.inputs.iter().zip(inputs).zip(&program.repeats) {
            let Some(Column { width, slot }) = *column else { continue };
            if again && *repeats {
                continue;
            }
            let input = &input[start..start + len];
            match width {
                Width::W16 => load(input, &mut store.lanes16[slot]),
                Width::W32 => load(input, &mut store.lanes32[slot]),
                Width::W64 => load(input, &mut store.lanes64[slot]),
            }
        }
    }
}

#[inline(always)]
fn load<I: Word, L: Lane>(from: &[I], to: &mut Option<Box<Lanes<L>>>) {
    let to = to.as_mut().expect("bug: no column is taken out");
    for (to, word) in to.0.iter_mut().zip(from) {
        *to = L::of(word.word());
    }
}

/// Columns of the outputs into the callers'.
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
