//! Where inputs come from, and their words.

use crate::cast;
use crate::error::{Error, Result};
use crate::format::{Overflow, Round, float20, quantize};
use crate::netlist::{Netlist, NodeId, Quantity};
use crate::trig::ROUNDER;
use crate::units::{Design, Sampler};
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Samples per chunk.
pub(super) const CHUNK: u64 = 1 << 12;
/// The most input words that `exhaustive` goes through.
const EXHAUSTIVE_BITS: u32 = 32;

/// Which inputs to measure over.
#[derive(Clone, Copy, Debug)]
pub struct Inputs {
    /// Where they come from.
    pub sampler: Sampler,
    /// How many, for the random samplers.
    pub samples: u64,
    /// Seed of the random samplers.
    pub seed: u64,
}

impl Inputs {
    /// How many samples a design gets.
    ///
    /// # Errors
    /// If an exhaustive run would be too long.
    pub fn count(&self, design: &Design) -> Result<u64> {
        match self.sampler {
            Sampler::Lit | Sampler::Sphere => Ok(self.samples),
            Sampler::Hard => {
                Ok(design.hard.iter().map(|case| cast::count_of(case.words.len())).sum())
            }
            Sampler::Exhaustive => {
                let netlist = &design.netlist;
                let bits: u32 =
                    netlist.inputs().iter().map(|id| netlist.node(*id).format.bits()).sum();
                if bits > EXHAUSTIVE_BITS {
                    return Err(Error::usage(format!(
                        "the inputs have 2^{bits} combinations and an exhaustive run goes up to 2^{EXHAUSTIVE_BITS}: take narrower inputs or another sampler"
                    )));
                }
                Ok(1 << bits)
            }
        }
    }

    /// True if each design has inputs of its own: words, and not numbers to be quantised.
    pub(crate) fn are_words(&self) -> bool {
        matches!(self.sampler, Sampler::Hard | Sampler::Exhaustive)
    }

    /// True if two designs get the same values before quantisation, and the same golden of them.
    pub(crate) fn same_values(&self, a: &Design, b: &Design) -> bool {
        let names = |design: &Design| -> Vec<String> {
            let netlist = &design.netlist;
            (0..netlist.inputs().len()).map(|port| netlist.input_name(port).to_owned()).collect()
        };
        !self.are_words() && names(a) == names(b) && a.golden_key() == b.golden_key()
    }

    /// True if two designs get the same input words, and the same golden of them.
    pub(crate) fn same(&self, a: &Design, b: &Design) -> bool {
        let formats = |design: &Design| -> Vec<_> {
            let netlist = &design.netlist;
            let of = |id: &NodeId| (netlist.node(*id).format, netlist.node(*id).quantity);
            netlist.inputs().iter().map(of).collect()
        };
        if a.golden_key() != b.golden_key() {
            return false;
        }
        let hard = |design: &Design| -> Vec<Vec<i64>> {
            design.hard.iter().flat_map(|case| case.words.clone()).collect()
        };
        formats(a) == formats(b) && (self.sampler != Sampler::Hard || hard(a) == hard(b))
    }

    /// Input values of samples `start..start + count`, one column per port, before quantisation.
    pub(super) fn values(
        &self,
        design: &Design,
        start: u64,
        count: usize,
        columns: &mut Vec<Vec<f64>>,
    ) {
        let netlist = &design.netlist;
        columns.resize(netlist.inputs().len(), Vec::new());
        match self.sampler {
            Sampler::Lit | Sampler::Sphere => {
                // One stream per chunk: any chunk can be drawn on its own.
                let mut rng = Pcg64Mcg::seed_from_u64(
                    self.seed ^ (start / CHUNK).wrapping_mul(0x9e37_79b9_7f4a_7c15),
                );
                let mut next =
                    || cast::f64_of(cast::word_of_bits(rng.next_u64() >> 11)) * 2f64.powi(-53);
                (design.draw)(design, self.sampler, &mut next, columns, count);
            }
            Sampler::Hard => {
                let skip = usize::try_from(start).expect("bug: the list is short");
                let words = design.hard.iter().flat_map(|case| &case.words).skip(skip).take(count);
                columns.iter_mut().for_each(Vec::clear);
                for case in words {
                    for ((column, id), word) in columns.iter_mut().zip(netlist.inputs()).zip(case) {
                        column.push(netlist.node(*id).format.value(*word));
                    }
                }
            }
            Sampler::Exhaustive => {
                columns.iter_mut().for_each(Vec::clear);
                for index in start..start + cast::count_of(count) {
                    let mut rest = index;
                    for (column, id) in columns.iter_mut().zip(netlist.inputs()) {
                        let format = netlist.node(*id).format;
                        let word = format.wrap(cast::word_of_bits(rest & (format.words() - 1)));
                        column.push(format.value(word));
                        rest >>= format.bits();
                    }
                }
            }
        }
    }
}

/// Writes input columns as words of the ports: to nearest, angles modulo a turn, numbers saturated;
/// what comes as a float of 20 bits is cut down to it before.
///
/// # Errors
/// If a value is not finite.
pub fn quantize_inputs(
    netlist: &Netlist,
    values: &[Vec<f64>],
    words: &mut Vec<Vec<i64>>,
) -> Result<()> {
    words.resize(values.len(), Vec::new());
    for ((id, column), to) in netlist.inputs().iter().zip(values).zip(words) {
        let node = netlist.node(*id);
        let overflow = match node.quantity {
            Quantity::Turns => Overflow::Wrap,
            Quantity::Number | Quantity::Float20 => Overflow::Saturate,
        };
        to.clear();
        let scale = 2f64.powi(node.format.frac_bits());
        let (min, max) = (node.format.min_raw(), node.format.max_raw());
        let short = node.quantity == Quantity::Float20;
        for value in column {
            let value = if short { float20(*value) } else { *value };
            let scaled = value * scale;
            to.push(if scaled.abs() < 2f64.powi(51) {
                // Adding 1.5 * 2^52 rounds to a whole number, ties to even, in the low bits.
                let whole = cast::word_of_bits((scaled + ROUNDER).to_bits())
                    - cast::word_of_bits(ROUNDER.to_bits());
                match overflow {
                    Overflow::Wrap => node.format.wrap(whole),
                    Overflow::Saturate | Overflow::Symmetric | Overflow::Error => {
                        whole.clamp(min, max)
                    }
                }
            } else {
                // Far out, or not finite.
                let turns = node.quantity == Quantity::Turns;
                let value = if turns { value % 1.0 } else { value };
                quantize(value, node.format, Round::HalfEven, overflow)?.0
            });
        }
    }
    Ok(())
}

/// Real values of columns of words.
pub(crate) fn values_of(
    netlist: &Netlist,
    nodes: &[NodeId],
    words: &[Vec<i64>],
    to: &mut Vec<Vec<f64>>,
) {
    to.resize(nodes.len(), Vec::new());
    for ((id, column), to) in nodes.iter().zip(words).zip(to) {
        let format = netlist.node(*id).format;
        let ulp = format.ulp();
        to.clear();
        to.extend(column.iter().map(|word| cast::f64_of(*word) * ulp));
    }
}

/// Input words of samples, one row each.
///
/// # Errors
/// As [`Inputs::count`].
///
/// # Panics
/// If a sampler gave fewer samples than it was asked for.
pub fn sample_words(design: &Design, inputs: &Inputs) -> Result<Vec<Vec<i64>>> {
    let count = inputs.count(design)?;
    let (mut values, mut words) = (Vec::new(), Vec::new());
    let mut rows = Vec::new();
    let mut from = 0;
    while from < count {
        let len = usize::try_from(CHUNK.min(count - from)).expect("bug: a chunk");
        inputs.values(design, from, len, &mut values);
        quantize_inputs(&design.netlist, &values, &mut words)?;
        rows.extend((0..len).map(|row| words.iter().map(|column| column[row]).collect()));
        from += CHUNK;
    }
    Ok(rows)
}
