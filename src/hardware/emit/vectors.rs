//! Test vectors for hardware: input words and the expected output words.

use crate::base::cast;
use crate::design::Design;
use crate::hardware::hdl::testbench::push_vector;
use crate::netlist::{Netlist, NodeId};
use crate::sim::batch::{Program, Runner};
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::io::{self, Write};
use std::sync::Arc;

/// Vectors per block.
const BLOCK: usize = 1 << 12;
/// A word of a slow rate stays for this many samples of the next faster rate.
const HELD: u64 = 5;
/// One in this many random words is at or next to an end of its format, or at or next to 0.
const EXTREME_SHARE: u64 = 16;

/// A stream of vectors: the whole hard-case list, then words drawn uniformly from the ports'
/// formats, some of them extreme. The batch engine computes the expected words.
#[derive(Debug)]
pub struct Vectors {
    netlist: Arc<Netlist>,
    program: Program,
    runner: Runner,
    hard: Vec<Vec<i64>>,
    random: u64,
    rng: Pcg64Mcg,
    /// Number of vectors generated so far.
    given: u64,
    inputs: Vec<Vec<i64>>,
    outputs: Vec<Vec<i64>>,
    /// By port: for how many vectors a random word stays.
    stays: Vec<u64>,
    /// The latest words.
    words: Vec<i64>,
}

impl Vectors {
    /// The hard cases of a design, at most `hard_per_group` of each group, and `random` random
    /// vectors.
    #[must_use]
    pub fn new(design: &Design, hard_per_group: usize, random: u64, seed: u64) -> Self {
        let groups = design.hard.iter();
        // A subset is spread over the whole group.
        let hard = groups
            .flat_map(|case| {
                let step = case.words.len().div_ceil(hard_per_group.max(1)).max(1);
                case.words.iter().step_by(step).cloned()
            })
            .collect();
        Self::of_netlist(&design.netlist, hard, random, seed)
    }

    /// The same for a netlist, starting with the vectors `hard`.
    #[must_use]
    pub fn of_netlist(netlist: &Arc<Netlist>, hard: Vec<Vec<i64>>, random: u64, seed: u64) -> Self {
        let ports: Vec<NodeId> = netlist.outputs().iter().map(|output| output.node).collect();
        let program = Program::compile(netlist, &ports);
        let rates = netlist.rates();
        let stays = |id: &NodeId| {
            let rate = netlist.node(*id).rate;
            rates.iter().filter(|known| **known > rate).fold(1, |stays, _| stays * HELD)
        };
        Self {
            stays: netlist.inputs().iter().map(stays).collect(),
            words: vec![0; netlist.inputs().len()],
            runner: program.runner(),
            program,
            hard,
            random,
            rng: Pcg64Mcg::seed_from_u64(seed),
            given: 0,
            inputs: vec![Vec::new(); netlist.inputs().len()],
            outputs: vec![Vec::new(); ports.len()],
            netlist: Arc::clone(netlist),
        }
    }

    /// Total number of vectors.
    #[must_use]
    pub fn count(&self) -> u64 {
        cast::count_of(self.hard.len()) + self.random
    }

    /// Computes the next block into `inputs` and `outputs`; false at the end.
    fn advance(&mut self) -> bool {
        let left = self.count() - self.given;
        let count = usize::try_from(left).unwrap_or(usize::MAX).min(BLOCK);
        if count == 0 {
            return false;
        }
        self.inputs.iter_mut().for_each(Vec::clear);
        for _ in 0..count {
            let hard = usize::try_from(self.given).ok().and_then(|at| self.hard.get(at));
            for (port, id) in self.netlist.inputs().iter().enumerate() {
                let drawn = self.given.saturating_sub(cast::count_of(self.hard.len()));
                let word = match hard {
                    Some(words) => words[port],
                    None if !drawn.is_multiple_of(self.stays[port]) => self.words[port],
                    None => {
                        let format = self.netlist.node(*id).format;
                        let bits = self.rng.next_u64();
                        // The low bits choose between an extreme and a uniform word; the high bits
                        // choose the extreme.
                        match bits % EXTREME_SHARE {
                            0 => {
                                let (lo, hi) = (format.min_raw(), format.max_raw());
                                let all = [lo, hi, 0, lo.saturating_add(1), hi - 1, 1];
                                let pick = usize::try_from(bits >> 32).expect("bug: 32 bits fit");
                                all[pick % all.len()].clamp(lo, hi)
                            }
                            _ => format.wrap(cast::word_of_bits(self.rng.next_u64() >> 1)),
                        }
                    }
                };
                self.words[port] = word;
                self.inputs[port].push(word);
            }
            self.given += 1;
        }
        let columns: Vec<&[i64]> = self.inputs.iter().map(Vec::as_slice).collect();
        let ran = self.runner.run(&self.program, &columns, &mut self.outputs);
        ran.expect("bug: words are of their ports' formats, and memories were asked for");
        true
    }

    /// Writes the remaining vectors, one per line.
    ///
    /// # Errors
    /// If `to` can't be written.
    ///
    /// # Panics
    /// If no words are bound to a memory of the netlist.
    pub fn write(&mut self, to: &mut dyn Write) -> io::Result<()> {
        let netlist = Arc::clone(&self.netlist);
        let formats: Vec<_> = netlist
            .inputs()
            .iter()
            .copied()
            .chain(netlist.outputs().iter().map(|output| output.node))
            .map(|id| netlist.node(id).format)
            .collect();
        let mut text = String::new();
        while self.advance() {
            text.clear();
            for row in 0..self.inputs[0].len() {
                let words = self.inputs.iter().chain(&self.outputs).map(|column| column[row]);
                push_vector(&mut text, words.zip(formats.iter().copied()));
            }
            to.write_all(text.as_bytes())?;
        }
        Ok(())
    }

    /// Input and output words of one vector, counted from 0.
    ///
    /// # Panics
    /// As [`Vectors::write`].
    #[must_use]
    pub fn vector(mut self, number: u64) -> Option<(Vec<i64>, Vec<i64>)> {
        loop {
            let start = self.given;
            if !self.advance() {
                return None;
            }
            if number < self.given {
                let row = usize::try_from(number - start).expect("bug: a row of a block");
                let of = |columns: &[Vec<i64>]| columns.iter().map(|column| column[row]).collect();
                return Some((of(&self.inputs), of(&self.outputs)));
            }
        }
    }
}
