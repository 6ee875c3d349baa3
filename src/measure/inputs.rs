//! Input samples, and their words.

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::simd::{Body, vectorised};
use crate::design::{Design, Sampler, Uniform};
use crate::netlist::{Netlist, Node, NodeId, Quantity};
use crate::number::format::{Format, Overflow, Round, float20, quantize};
use crate::number::trig::ROUNDER;
use crate::sim::batch::BLOCK;

/// Samples per chunk.
pub(super) const CHUNK: u64 = 1 << 12;
/// Largest number of input bits that `exhaustive` enumerates.
pub(super) const EXHAUSTIVE_BITS: u32 = 32;

/// The inputs to measure over.
#[derive(Clone, Copy, Debug)]
pub struct Inputs {
    /// Their source.
    pub sampler: Sampler,
    /// Number of samples, for the random samplers.
    pub samples: u64,
    /// Seed, for the random samplers.
    pub seed: u64,
}

impl Inputs {
    /// Number of samples for a design.
    ///
    /// # Errors
    /// If an exhaustive run has more than 2^32 combinations.
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
                        "the inputs have 2^{bits} combinations but an exhaustive run is limited to 2^{EXHAUSTIVE_BITS}: use narrower inputs or another sampler"
                    )));
                }
                Ok(1 << bits)
            }
        }
    }

    /// True if the sampler gives each design's words directly, not numbers to be quantised.
    pub(crate) fn are_words(&self) -> bool {
        !self.sampler.is_random()
    }

    /// True if two designs get the same values before quantisation, and the same golden for them.
    pub(crate) fn same_values(&self, a: &Design, b: &Design) -> bool {
        // A sampler may or may not depend on the formats.
        let drawn = !a.is_drawn_by_format() || ports(a) == ports(b);
        !self.are_words() && a.golden_key() == b.golden_key() && drawn
    }

    /// True if two designs get the same input words, and the same golden for them.
    pub(crate) fn same(&self, a: &Design, b: &Design) -> bool {
        if a.golden_key() != b.golden_key() {
            return false;
        }
        let hard = |design: &Design| -> Vec<Vec<i64>> {
            design.hard.iter().flat_map(|case| case.words.clone()).collect()
        };
        ports(a) == ports(b) && (self.sampler != Sampler::Hard || hard(a) == hard(b))
    }

    /// Ports whose words are the same in each block of a chunk: in an exhaustive run, those that
    /// count within a block or from chunk to chunk.
    pub(super) fn repeats(&self, design: &Design) -> Vec<bool> {
        let mut at = 0;
        let repeats = |id: &NodeId| {
            let first = at;
            at += design.netlist.node(*id).format.bits();
            self.sampler == Sampler::Exhaustive && (at <= BLOCK.ilog2() || first >= CHUNK.ilog2())
        };
        design.netlist.inputs().iter().map(repeats).collect()
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
                // One random stream per chunk, so that any chunk can be drawn on its own.
                let chunk = (start / CHUNK).wrapping_mul(0x9e37_79b9_7f4a_7c15);
                let mut uniform = Uniform::new(self.seed ^ chunk);
                design.draw.run(self.sampler, &mut uniform, columns, count);
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

/// Formats and quantities of a design's input ports.
fn ports(design: &Design) -> Vec<(Format, Quantity)> {
    let netlist = &design.netlist;
    let of = |id: &NodeId| (netlist.node(*id).format, netlist.node(*id).quantity);
    netlist.inputs().iter().map(of).collect()
}

/// Quantises input columns to words of the ports: rounds to nearest, wraps angles modulo a turn,
/// and saturates numbers. A [`Quantity::Float20`] is first truncated to a float of 20 bits.
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
        let short = node.quantity == Quantity::Float20;
        to.resize(column.len(), 0);
        let mut far = false;
        let wraps = node.quantity == Quantity::Turns;
        vectorised(Quantise { column, to, format: node.format, wraps, short, far: &mut far });
        if far {
            for (to, value) in to.iter_mut().zip(column) {
                *to = quantize_input(node, *value)?.0;
            }
        }
    }
    Ok(())
}

/// The word of one value of an input port, by the rules of [`quantize_inputs`], and whether the
/// value is outside the port's range.
///
/// # Errors
/// If it is not finite.
pub(crate) fn quantize_input(node: &Node, value: f64) -> Result<(i64, bool)> {
    let (value, overflow) = match node.quantity {
        Quantity::Turns => (value % 1.0, Overflow::Wrap),
        Quantity::Number => (value, Overflow::Saturate),
        // Values outside the range of `f32` are outside that of any port.
        Quantity::Float20 if value.is_finite() => {
            (float20(value.clamp(f32::MIN.into(), f32::MAX.into())), Overflow::Saturate)
        }
        Quantity::Float20 => (value, Overflow::Saturate),
    };
    let (word, overflowed) = quantize(value, node.format, Round::HalfEven, overflow)?;
    Ok((word, overflowed && overflow == Overflow::Saturate))
}

/// Quantises a column. Words of numbers that are far out of range or not finite are wrong, and
/// `far` is set.
struct Quantise<'a> {
    column: &'a [f64],
    to: &'a mut [i64],
    format: Format,
    wraps: bool,
    short: bool,
    far: &'a mut bool,
}

impl Body for Quantise<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { column, to, format, wraps, short, far } = self;
        let scale = 2f64.powi(format.frac_bits());
        let (min, max) = (format.min_raw(), format.max_raw());
        let mut any_far = false;
        // Adding 1.5 * 2^52 rounds to a whole number, ties to even, in the low bits.
        let mut whole = |value: f64| {
            let scaled = value * scale;
            any_far |= scaled.is_nan() || scaled.abs() >= 2f64.powi(51);
            // Far values are redone by the caller.
            let bits = cast::word_of_bits((scaled + ROUNDER).to_bits());
            bits.wrapping_sub(cast::word_of_bits(ROUNDER.to_bits()))
        };
        let pairs = to.iter_mut().zip(column);
        if wraps {
            for (to, value) in pairs {
                *to = format.wrap(whole(*value));
            }
        } else if short {
            for (to, value) in pairs {
                *to = whole(float20(*value)).clamp(min, max);
            }
        } else {
            for (to, value) in pairs {
                *to = whole(*value).clamp(min, max);
            }
        }
        *far = any_far;
    }
}

/// Values of columns of words.
pub(crate) fn values_of(
    netlist: &Netlist,
    nodes: &[NodeId],
    words: &[Vec<i64>],
    to: &mut Vec<Vec<f64>>,
) {
    to.resize(nodes.len(), Vec::new());
    for ((id, words), to) in nodes.iter().zip(words).zip(to) {
        to.resize(words.len(), 0.0);
        vectorised(Scale { words, ulp: netlist.node(*id).format.ulp(), to });
    }
}

/// Values of a column of words.
pub(super) struct Scale<'a> {
    pub(super) words: &'a [i64],
    pub(super) ulp: f64,
    pub(super) to: &'a mut [f64],
}

impl Body for Scale<'_> {
    #[inline(always)]
    fn run(self) {
        for (to, word) in self.to.iter_mut().zip(self.words) {
            *to = cast::f64_of(*word) * self.ulp;
        }
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
