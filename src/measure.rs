//! Error measurement: bit-true words and real evaluations against the golden.
//!
//! An error is always told with its *basis*:
//!
//! - `total`: bit-true against the golden of the same quantised inputs;
//! - `arithmetic`: bit-true against the netlist on reals: what words and tables do;
//! - `algorithm`: the netlist on reals against the golden: what the method itself does;
//! - `end-to-end`: bit-true against the golden of the inputs before quantisation.
//!
//! Samples come in chunks, each with a random stream of its own; partial results are merged in
//! chunk order, so the figures don't depend on the number of threads. Designs measured together
//! share inputs and golden values.

use crate::cast;
use crate::error::{Error, Result};
use crate::format::{Overflow, Round, quantize};
use crate::lut;
use crate::netlist::{Builder, Netlist, NodeId, Quantity};
use crate::sim::batch::{Program, Runner, check_overflows};
use crate::sim::real;
use crate::trig::sin_cos_turns;
use crate::units::{Bound, Design, Sampler, Shape, Tabulated};
use rand_core::{RngCore, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};
use std::time::{Duration, Instant};

/// Samples per chunk.
const CHUNK: u64 = 1 << 14;
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
    fn are_words(&self) -> bool {
        matches!(self.sampler, Sampler::Hard | Sampler::Exhaustive)
    }

    /// True if two designs get the same input words.
    fn same(&self, a: &Design, b: &Design) -> bool {
        let formats = |design: &Design| -> Vec<_> {
            let netlist = &design.netlist;
            netlist.inputs().iter().map(|id| netlist.node(*id).format).collect()
        };
        let hard = |design: &Design| -> Vec<Vec<i64>> {
            design.hard.iter().flat_map(|case| case.words.clone()).collect()
        };
        formats(a) == formats(b) && (self.sampler != Sampler::Hard || hard(a) == hard(b))
    }

    /// Input values of samples `start..start + count`, one column per port, before quantisation.
    fn values(&self, design: &Design, start: u64, count: usize, columns: &mut Vec<Vec<f64>>) {
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
                (design.draw)(self.sampler, &mut next, columns, count);
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

/// 1.5 * 2^52: the sum with a smaller number is a whole number.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// Writes input columns as words of the ports: to nearest, angles modulo a turn, numbers saturated.
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
            Quantity::Number => Overflow::Saturate,
        };
        to.clear();
        let scale = 2f64.powi(node.format.frac_bits());
        let (min, max) = (node.format.min_raw(), node.format.max_raw());
        for value in column {
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
                let value = if turns { value % 1.0 } else { *value };
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

/// Turns columns of output values into x, y, z columns.
fn directions(shape: Shape, outputs: &[Vec<f64>], to: &mut [Vec<f64>; 3]) {
    match shape {
        Shape::Cartesian => {
            for (to, column) in to.iter_mut().zip(outputs) {
                to.clone_from(column);
            }
        }
        Shape::Polar => {
            let [xs, ys, zs] = to;
            xs.clear();
            ys.clear();
            zs.clear();
            for (phi, theta) in outputs[0].iter().zip(&outputs[1]) {
                let ((sin_phi, cos_phi), (sin_theta, cos_theta)) =
                    (sin_cos_turns(*phi), sin_cos_turns(*theta));
                xs.push(sin_theta * cos_phi);
                ys.push(sin_theta * sin_phi);
                zs.push(cos_theta);
            }
        }
    }
}

/// Output values that a golden direction means for the ports of a shape; angles in turns, 0 to 1.
#[must_use]
pub fn ports_of_direction(shape: Shape, [x, y, z]: [f64; 3]) -> Vec<f64> {
    match shape {
        Shape::Cartesian => vec![x, y, z],
        Shape::Polar => {
            let phi = (y.atan2(x) / TAU).rem_euclid(1.0);
            vec![phi, x.hypot(y).atan2(z) / TAU]
        }
    }
}

/// Angle between two vectors in rad, good for small angles too. A null vector has no
/// direction and counts as opposite.
#[must_use]
pub fn angle_between(u: [f64; 3], v: [f64; 3]) -> f64 {
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let dot = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    let sine = (cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]).sqrt();
    if sine < 0.02 * dot {
        // atan's series; the next term is below 1e-18 of the sum.
        let t = sine / dot;
        let t2 = t * t;
        t * (1.0 - t2 * (1.0 / 3.0 - t2 * (0.2 - t2 * (1.0 / 7.0 - t2 / 9.0))))
    } else if sine == 0.0 && dot == 0.0 {
        PI
    } else {
        sine.atan2(dot)
    }
}

/// What an error is measured against.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize, PartialOrd, Ord)]
#[serde(rename_all = "kebab-case")]
pub enum Basis {
    /// Bit-true against the golden of the quantised inputs.
    Total,
    /// Bit-true against the netlist on reals.
    Arithmetic,
    /// The netlist on reals against the golden of the quantised inputs.
    Algorithm,
    /// Bit-true against the golden of the real inputs.
    EndToEnd,
}

impl Basis {
    const ALL: [Self; 4] = [Self::Total, Self::Arithmetic, Self::Algorithm, Self::EndToEnd];

    /// Name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Total => "total",
            Self::Arithmetic => "arithmetic",
            Self::Algorithm => "algorithm",
            Self::EndToEnd => "end-to-end",
        }
    }
}

/// Quantities measured for a direction, with their units.
const QUANTITIES: [(&str, &str); 5] =
    [("angle", "rad"), ("dot", "1"), ("x", "1"), ("y", "1"), ("z", "1")];

/// Octaves of the histogram: from 2^-44 to 2^4.
const OCTAVES: usize = 48;
const LEAST_EXPONENT: u64 = 1023 - 44;
/// Bins per octave: a quantile is known to 1.6 %.
const BINS_PER_OCTAVE_BITS: u32 = 5;
const BINS: usize = OCTAVES << BINS_PER_OCTAVE_BITS;

/// Accumulated errors of one quantity on one basis.
#[derive(Clone, Debug)]
struct Stream {
    count: u64,
    max: f64,
    /// Sample that gave the maximum.
    at: u64,
    sum_abs: f64,
    sum: f64,
    sum_squares: f64,
    histogram: Vec<u32>,
}

impl Stream {
    fn new() -> Self {
        Self {
            count: 0,
            max: -1.0,
            at: 0,
            sum_abs: 0.0,
            sum: 0.0,
            sum_squares: 0.0,
            histogram: vec![0; BINS],
        }
    }

    fn clear(&mut self) {
        let histogram = std::mem::take(&mut self.histogram);
        *self = Self { histogram, ..Self { histogram: Vec::new(), ..EMPTY } };
        self.histogram.fill(0);
    }

    /// Adds errors of consecutive samples from `start`.
    fn add(&mut self, errors: &[f64], start: u64) {
        let (mut sum_abs, mut sum, mut sum_squares) = (0.0, 0.0, 0.0);
        for (error, index) in errors.iter().zip(start..) {
            let size = error.abs();
            // A NaN is larger than everything.
            if size > self.max || size.is_nan() && !self.max.is_nan() {
                self.max = size;
                self.at = index;
            }
            sum_abs += size;
            sum += error;
            sum_squares += error * error;
            self.histogram[bin(size)] += 1;
        }
        self.count += cast::count_of(errors.len());
        self.sum_abs += sum_abs;
        self.sum += sum;
        self.sum_squares += sum_squares;
    }
}

const EMPTY: Stream = Stream {
    count: 0,
    max: -1.0,
    at: 0,
    sum_abs: 0.0,
    sum: 0.0,
    sum_squares: 0.0,
    histogram: Vec::new(),
};

/// Bin of the histogram: the exponent and the first bits of the mantissa.
#[inline(always)]
fn bin(size: f64) -> usize {
    let key = size.to_bits() >> (f64::MANTISSA_DIGITS - 1 - BINS_PER_OCTAVE_BITS);
    let bin = key.saturating_sub(LEAST_EXPONENT << BINS_PER_OCTAVE_BITS);
    cast::index_of(cast::word_of_bits(bin.min(cast::count_of(BINS - 1))))
}

/// Middle of a bin; 0 for the lowest, which holds everything below 2^-44.
fn bin_middle(index: usize) -> f64 {
    if index == 0 {
        return 0.0;
    }
    let bits = (cast::count_of(index) + (LEAST_EXPONENT << BINS_PER_OCTAVE_BITS))
        << (f64::MANTISSA_DIGITS - 1 - BINS_PER_OCTAVE_BITS);
    f64::from_bits(bits) * (1.0 + 0.5 * 2f64.powi(-cast::signed_count(BINS_PER_OCTAVE_BITS)))
}

/// The input that gave a maximum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Witness {
    /// Number of the sample.
    pub sample: u64,
    /// Input words, by port.
    pub words: Vec<i64>,
    /// Their values.
    pub values: Vec<f64>,
    /// Output words, by port.
    pub outputs: Vec<i64>,
}

/// Merged errors of one quantity.
#[derive(Clone, Debug)]
struct Merged {
    stream: Stream,
    histogram: Vec<u64>,
    witness: Option<Witness>,
}

/// Statistics of one quantity on one basis.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Figures {
    /// What is measured: angle (between vectors), dot (largest error of a dot product with any
    /// unit vector: the length of the difference), or a component.
    pub quantity: &'static str,
    /// `rad`, or `1` for absolute errors.
    pub unit: &'static str,
    /// Against what.
    pub basis: Basis,
    /// Largest absolute value.
    pub max: f64,
    /// The same in ulp of the output port, for components.
    pub max_ulp: Option<f64>,
    /// Input that gave it.
    pub witness: Option<Witness>,
    /// Mean of the absolute value.
    pub mean: f64,
    /// Mean with sign.
    pub bias: f64,
    /// Root of the mean square.
    pub rms: f64,
    /// Median of the absolute value, to 1.6 %; 0 means below 2^-44.
    pub p50: f64,
    /// 99th percentile, likewise.
    pub p99: f64,
    /// 99.9th percentile, likewise.
    pub p999: f64,
}

/// How often a `narrow` overflowed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct OverflowCount {
    /// The node.
    pub node: String,
    /// Its overflow mode.
    pub mode: &'static str,
    /// How often.
    pub count: u64,
}

/// Time spent.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct Speed {
    /// Bit-true samples per second and thread: the engine alone.
    pub engine_samples_per_second_per_thread: f64,
    /// Samples per second of the whole run on all threads: inputs, golden, both evaluations, statistics.
    pub samples_per_second: f64,
    /// Threads.
    pub threads: usize,
}

/// What was measured of a design.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Samples measured.
    pub samples: u64,
    /// One entry per quantity and basis.
    pub figures: Vec<Figures>,
    /// Every `narrow` that overflowed at least once, then those that could have are not listed.
    pub overflows: Vec<OverflowCount>,
    /// Time spent; the only part that differs from run to run.
    pub speed: Speed,
}

impl Report {
    /// Figures of a quantity on a basis.
    ///
    /// # Panics
    /// If there is no such quantity.
    #[must_use]
    pub fn figures(&self, quantity: &str, basis: Basis) -> &Figures {
        self.figures
            .iter()
            .find(|figures| figures.quantity == quantity && figures.basis == basis)
            .expect("bug: no such quantity")
    }
}

/// Compiled design.
struct Compiled<'a> {
    design: &'a Design,
    program: Program,
    reals: real::Program,
    outputs: Vec<NodeId>,
    /// Which set of quantised inputs it shares.
    inputs: usize,
}

/// Columns of one thread for one design.
struct Lanes {
    runner: Runner,
    real_runner: real::Runner,
    words: Vec<Vec<i64>>,
    values: Vec<Vec<f64>>,
    reals: Vec<Vec<f64>>,
    streams: Vec<Stream>,
}

/// Columns of one thread that designs share.
#[derive(Default)]
struct Shared {
    values: Vec<Vec<f64>>,
    golden: [Vec<f64>; 3],
    words: Vec<Vec<Vec<i64>>>,
    quantised: Vec<Vec<Vec<f64>>>,
    goldens: Vec<[Vec<f64>; 3]>,
    bit_true: [Vec<f64>; 3],
    real: [Vec<f64>; 3],
    errors: Vec<f64>,
}

/// What a chunk gave for one design.
struct Partial {
    streams: Vec<(Stream, Option<Witness>)>,
    overflows: Vec<u64>,
    engine: Duration,
}

/// Measures designs of one unit over the same inputs; `progress` gets the samples done.
///
/// # Errors
/// If the inputs are too many to go through, or a `narrow` under overflow mode `error` overflowed.
///
/// # Panics
/// If the designs belong to different units.
pub fn measure(
    designs: &[&Design],
    inputs: &Inputs,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Report>> {
    let Some(first) = designs.first() else { return Ok(Vec::new()) };
    assert!(
        designs.iter().all(|design| std::ptr::eq(design.values.unit(), first.values.unit())),
        "bug: designs of different units have no common golden"
    );
    let mut sets: Vec<&Design> = Vec::new();
    let mut compiled = Vec::new();
    let mut count = None;
    for design in designs {
        let netlist = &design.netlist;
        let known = sets.iter().position(|known| inputs.same(known, design));
        let index = known.unwrap_or_else(|| {
            sets.push(design);
            sets.len() - 1
        });
        let samples = inputs.count(design)?;
        if *count.get_or_insert(samples) != samples {
            return Err(Error::usage(
                "designs with different numbers of inputs can't be measured together".to_owned(),
            ));
        }
        let outputs: Vec<NodeId> = netlist.outputs().iter().map(|output| output.node).collect();
        compiled.push(Compiled {
            design,
            program: Program::compile(netlist, &outputs),
            reals: real::Program::compile(netlist, &outputs),
            outputs,
            inputs: index,
        });
    }
    let same_words = |design: &&Design| {
        design.hard.len() == first.hard.len()
            && design.hard.iter().zip(&first.hard).all(|(a, b)| a.words == b.words)
    };
    if formats.len() > 1 && !matches!(inputs.sampler, Sampler::Lit | Sampler::Sphere)
        || inputs.sampler == Sampler::Hard && !designs.iter().all(same_words)
    {
        return Err(Error::usage(
            "designs with different input words can't be measured together".to_owned(),
        ));
    }
    let count = count.unwrap_or_default();

    let start = Instant::now();
    let chunks = count.div_ceil(CHUNK);
    let threads = rayon::current_num_threads();
    // A few chunks per thread at a time: memory doesn't grow with samples.
    let round = cast::count_of(threads) * 4;
    let mut merged: Vec<Vec<Merged>> = compiled.iter().map(|_| new_merged()).collect();
    let mut overflows: Vec<Vec<u64>> =
        compiled.iter().map(|c| vec![0; c.program.narrows().len()]).collect();
    let mut engine = vec![Duration::ZERO; compiled.len()];
    let mut next = 0;
    while next < chunks {
        let these: Vec<u64> = (next..(next + round).min(chunks)).collect();
        let partials: Vec<Result<Vec<Partial>>> = these
            .par_iter()
            .map_init(
                || (Shared::default(), compiled.iter().map(new_lanes).collect::<Vec<_>>()),
                |(shared, lanes), chunk| {
                    let from = chunk * CHUNK;
                    let len = usize::try_from(CHUNK.min(count - from)).expect("bug: a chunk");
                    measure_chunk(&compiled, &sets, inputs, (from, len), shared, lanes)
                },
            )
            .collect();
        for partial in partials {
            for (i, partial) in partial?.into_iter().enumerate() {
                for (merged, (stream, witness)) in merged[i].iter_mut().zip(partial.streams) {
                    merged.merge(&stream, witness);
                }
                for (total, count) in overflows[i].iter_mut().zip(partial.overflows) {
                    *total += count;
                }
                engine[i] += partial.engine;
            }
        }
        for (c, counts) in compiled.iter().zip(&overflows) {
            check_overflows(&c.design.netlist, c.program.narrows(), counts)?;
        }
        next += round;
        progress((next * CHUNK).min(count));
    }
    let elapsed = start.elapsed().as_secs_f64();
    let rate = |seconds: f64| {
        if seconds > 0.0 { cast::f64_of_count(count) / seconds } else { 0.0 }
    };
    Ok(compiled
        .iter()
        .zip(merged)
        .zip(overflows.iter().zip(engine))
        .map(|((c, merged), (overflows, engine))| Report {
            samples: count,
            figures: figures(c.design, &merged),
            overflows: overflow_counts(c, overflows),
            speed: Speed {
                engine_samples_per_second_per_thread: rate(engine.as_secs_f64()),
                samples_per_second: rate(elapsed) * cast::f64_of_len(designs.len()),
                threads,
            },
        })
        .collect())
}

fn new_merged() -> Vec<Merged> {
    let empty = Merged { stream: EMPTY, histogram: vec![0; BINS], witness: None };
    vec![empty; QUANTITIES.len() * Basis::ALL.len()]
}

fn new_lanes(c: &Compiled<'_>) -> Lanes {
    let outputs = c.outputs.len();
    Lanes {
        runner: c.program.runner(),
        real_runner: c.reals.runner(),
        words: vec![Vec::new(); outputs],
        values: vec![Vec::new(); outputs],
        reals: vec![Vec::new(); outputs],
        streams: (0..QUANTITIES.len() * Basis::ALL.len()).map(|_| Stream::new()).collect(),
    }
}

impl Merged {
    /// Adds the next chunk's stream; the first of equal maxima stays the witness.
    fn merge(&mut self, other: &Stream, witness: Option<Witness>) {
        let mine = &mut self.stream;
        if other.max > mine.max || other.max.is_nan() && !mine.max.is_nan() {
            mine.max = other.max;
            self.witness = witness;
        }
        mine.count += other.count;
        mine.sum_abs += other.sum_abs;
        mine.sum += other.sum;
        mine.sum_squares += other.sum_squares;
        for (total, count) in self.histogram.iter_mut().zip(&other.histogram) {
            *total += u64::from(*count);
        }
    }

    fn quantile(&self, share: f64) -> f64 {
        let wanted = (share * cast::f64_of_count(self.stream.count)).ceil();
        let mut seen = 0;
        for (index, count) in self.histogram.iter().enumerate() {
            seen += count;
            if cast::f64_of_count(seen) >= wanted && seen > 0 {
                return bin_middle(index).min(self.stream.max);
            }
        }
        0.0
    }
}

fn measure_chunk(
    compiled: &[Compiled<'_>],
    representatives: &[&Design],
    inputs: &Inputs,
    (from, len): (u64, usize),
    shared: &mut Shared,
    lanes: &mut [Lanes],
) -> Result<Vec<Partial>> {
    let first = representatives[0];
    inputs.values(first, from, len, &mut shared.values);
    run_golden(first, &shared.values, &mut shared.golden);
    let sets = representatives.len();
    shared.words.resize(sets, Vec::new());
    shared.quantised.resize(sets, Vec::new());
    shared.goldens.resize(sets, Default::default());
    for (i, design) in representatives.iter().enumerate() {
        let netlist = &design.netlist;
        if inputs.are_words() && i > 0 {
            inputs.values(design, from, len, &mut shared.values);
        }
        quantize_inputs(netlist, &shared.values, &mut shared.words[i])?;
        values_of(netlist, netlist.inputs(), &shared.words[i], &mut shared.quantised[i]);
        run_golden(design, &shared.quantised[i], &mut shared.goldens[i]);
    }
    let mut partials = Vec::with_capacity(compiled.len());
    for (c, lanes) in compiled.iter().zip(lanes) {
        let words: Vec<&[i64]> = shared.words[c.inputs].iter().map(Vec::as_slice).collect();
        let before = lanes.runner.overflows().to_vec();
        let start = Instant::now();
        lanes.runner.run(&c.program, &words, &mut lanes.words);
        let engine = start.elapsed();
        values_of(&c.design.netlist, &c.outputs, &lanes.words, &mut lanes.values);
        let values: Vec<&[f64]> = shared.quantised[c.inputs].iter().map(Vec::as_slice).collect();
        lanes.real_runner.run(&c.reals, &values, &mut lanes.reals);
        directions(c.design.shape, &lanes.values, &mut shared.bit_true);
        directions(c.design.shape, &lanes.reals, &mut shared.real);
        let golden = &shared.goldens[c.inputs];
        lanes.streams.iter_mut().for_each(Stream::clear);
        for (b, basis) in Basis::ALL.into_iter().enumerate() {
            let (is, should) = match basis {
                Basis::Total => (&shared.bit_true, golden),
                Basis::Arithmetic => (&shared.bit_true, &shared.real),
                Basis::Algorithm => (&shared.real, golden),
                // Words are their own real inputs.
                Basis::EndToEnd if inputs.are_words() => (&shared.bit_true, golden),
                Basis::EndToEnd => (&shared.bit_true, &shared.golden),
            };
            let at = |v: &[Vec<f64>; 3], i: usize| [v[0][i], v[1][i], v[2][i]];
            let errors = &mut shared.errors;
            for (q, stream) in lanes.streams[b * QUANTITIES.len()..].iter_mut().enumerate().take(5)
            {
                errors.clear();
                match q {
                    0 => errors.extend((0..len).map(|i| angle_between(at(is, i), at(should, i)))),
                    1 => errors.extend((0..len).map(|i| {
                        let (u, v) = (at(is, i), at(should, i));
                        let d = [u[0] - v[0], u[1] - v[1], u[2] - v[2]];
                        (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt()
                    })),
                    _ => errors.extend(
                        is[q - 2].iter().zip(&should[q - 2]).map(|(is, should)| is - should),
                    ),
                }
                stream.add(errors, from);
            }
        }
        let witness = |stream: &Stream| {
            let i = usize::try_from(stream.at - from).expect("bug: inside the chunk");
            Witness {
                sample: stream.at,
                words: shared.words[c.inputs].iter().map(|column| column[i]).collect(),
                values: shared.quantised[c.inputs].iter().map(|column| column[i]).collect(),
                outputs: lanes.words.iter().map(|column| column[i]).collect(),
            }
        };
        let after = lanes.runner.overflows();
        partials.push(Partial {
            streams: lanes.streams.iter().map(|s| (s.clone(), Some(witness(s)))).collect(),
            overflows: after.iter().zip(before).map(|(after, before)| after - before).collect(),
            engine,
        });
    }
    Ok(partials)
}

/// Golden direction of columns of inputs.
fn run_golden(design: &Design, inputs: &[Vec<f64>], to: &mut [Vec<f64>; 3]) {
    let len = inputs.first().map_or(0, Vec::len);
    for column in to.iter_mut() {
        column.resize(len, 0.0);
    }
    let columns: Vec<&[f64]> = inputs.iter().map(Vec::as_slice).collect();
    (design.golden)(&columns, to);
}

fn figures(design: &Design, merged: &[Merged]) -> Vec<Figures> {
    let netlist = &design.netlist;
    let ulp = netlist.node(netlist.outputs()[0].node).format.ulp();
    let mut figures = Vec::new();
    for (basis, merged) in Basis::ALL.into_iter().zip(merged.chunks(QUANTITIES.len())) {
        for ((quantity, unit), merged) in QUANTITIES.into_iter().zip(merged) {
            let stream = &merged.stream;
            let count = cast::f64_of_count(stream.count.max(1));
            let component =
                design.shape == Shape::Cartesian && !matches!(quantity, "angle" | "dot");
            figures.push(Figures {
                quantity,
                unit,
                basis,
                // -1 means that there was no sample; a NaN stays one.
                max: if stream.count == 0 { 0.0 } else { stream.max },
                max_ulp: component.then(|| stream.max / ulp),
                witness: merged.witness.clone(),
                mean: stream.sum_abs / count,
                bias: stream.sum / count,
                rms: (stream.sum_squares / count).sqrt(),
                p50: merged.quantile(0.5),
                p99: merged.quantile(0.99),
                p999: merged.quantile(0.999),
            });
        }
    }
    figures
}

fn overflow_counts(c: &Compiled<'_>, counts: &[u64]) -> Vec<OverflowCount> {
    let netlist = &c.design.netlist;
    c.program
        .narrows()
        .iter()
        .zip(counts)
        .filter(|(_, count)| **count > 0)
        .map(|(id, count)| OverflowCount {
            node: netlist.label(*id),
            mode: netlist.node(*id).op.overflow().expect("bug: only narrows are counted").name(),
            count: *count,
        })
        .collect()
}

/// Exact statistics of one function of a table scheme, over every word of its argument.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TableFigures {
    /// Table and function.
    pub table: &'static str,
    /// Function.
    pub function: &'static str,
    /// Largest absolute error against the function saturated to the output format.
    pub worst: f64,
    /// The same in ulp of the output.
    pub worst_ulp: f64,
    /// Argument word that gives it.
    pub witness_raw: i64,
    /// Its value.
    pub witness: f64,
    /// Neighbouring words between which the table goes against the function.
    pub not_monotone: u64,
    /// Largest jump between neighbouring words beyond the function's own step.
    pub jump: f64,
    /// Upper word of that jump.
    pub jump_raw: i64,
}

/// The widest argument whose words are gone through.
pub const TABLE_ARGUMENT_BITS: u32 = 26;

/// Goes through every word of a table scheme's argument; `None` if it has more than
/// [`TABLE_ARGUMENT_BITS`].
///
/// # Errors
/// If the scheme has a word past 63 bits.
///
/// # Panics
/// If a thread panicked.
pub fn table_figures(tabulated: &Tabulated) -> Result<Option<Vec<TableFigures>>> {
    if tabulated.argument.bits() > TABLE_ARGUMENT_BITS {
        return Ok(None);
    }
    let mut b = Builder::new("table");
    let argument = b.input("argument", tabulated.argument, Quantity::Number);
    let nodes = lut::emit(&mut b, &tabulated.spec(), argument);
    for (i, node) in nodes.iter().enumerate() {
        b.output(&format!("f{i}"), *node);
    }
    let netlist = b.build()?;
    let outputs: Vec<NodeId> = netlist.outputs().iter().map(|output| output.node).collect();
    let program = Program::compile(&netlist, &outputs);
    let (lo, hi) = (tabulated.argument.min_raw(), tabulated.argument.max_raw());
    let starts: Vec<i64> = (lo..=hi).step_by(cast::index_of(CHUNK_WORDS)).collect();
    let parts: Vec<Vec<TableFigures>> = starts
        .par_iter()
        .map_init(
            || program.runner(),
            |runner, start| {
                // One word before the chunk, so that every joint is seen.
                let first = (start - 1).max(lo);
                let last = (start + CHUNK_WORDS - 1).min(hi);
                let words: Vec<i64> = (first..=last).collect();
                let mut columns = vec![Vec::new(); nodes.len()];
                runner.run(&program, &[&words], &mut columns);
                tabulated
                    .functions
                    .iter()
                    .zip(&columns)
                    .map(|(function, column)| part_figures(tabulated, *function, &words, column))
                    .collect()
            },
        )
        .collect();
    let mut parts = parts.into_iter();
    let mut total = parts.next().expect("bug: arguments have words");
    for part in parts {
        for (total, part) in total.iter_mut().zip(part) {
            if part.worst > total.worst {
                total.worst = part.worst;
                total.worst_ulp = part.worst_ulp;
                total.witness_raw = part.witness_raw;
                total.witness = part.witness;
            }
            if part.jump > total.jump {
                total.jump = part.jump;
                total.jump_raw = part.jump_raw;
            }
            total.not_monotone += part.not_monotone;
        }
    }
    Ok(Some(total))
}

/// Words that a thread takes at a time in [`table_figures`].
const CHUNK_WORDS: i64 = 1 << 14;

fn part_figures(
    tabulated: &Tabulated,
    function: crate::function::Function,
    words: &[i64],
    column: &[i64],
) -> TableFigures {
    let (output, argument) = (tabulated.output, tabulated.argument);
    let (lo, hi) = (output.value(output.min_raw()), output.value(output.max_raw()));
    let mut figures = TableFigures {
        table: tabulated.name,
        function: function.name(),
        worst: -1.0,
        worst_ulp: 0.0,
        witness_raw: 0,
        witness: 0.0,
        not_monotone: 0,
        jump: 0.0,
        jump_raw: 0,
    };
    let mut before: Option<(f64, f64)> = None;
    for (word, raw) in words.iter().zip(column) {
        let x = tabulated.origin + argument.value(*word);
        let (is, should) = (output.value(*raw), function.eval(x).clamp(lo, hi));
        let error = (is - should).abs();
        if error > figures.worst {
            figures.worst = error;
            figures.worst_ulp = error / output.ulp();
            figures.witness_raw = *word;
            figures.witness = x;
        }
        if let Some((is_before, should_before)) = before {
            let (step, own) = (is - is_before, should - should_before);
            // A pole between the words is the function's own jump.
            if (step - own).abs() > figures.jump {
                figures.jump = (step - own).abs();
                figures.jump_raw = *word;
            }
            figures.not_monotone += u64::from(step * own < 0.0);
        }
        before = Some((is, should));
    }
    figures
}

/// A stated bound beside what was seen.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BoundCheck {
    /// Quantity that is bounded; `None` if no bound is stated.
    pub quantity: Option<&'static str>,
    /// The bound; `None` if none is stated.
    pub bound: Option<f64>,
    /// Why none is stated.
    pub why: Option<&'static str>,
}

impl BoundCheck {
    /// Evaluates the bound of a design: needs the exact worst error of each table scheme.
    ///
    /// # Errors
    /// As [`table_figures`].
    ///
    /// # Panics
    /// If the bound asks for a table that the design doesn't have: that is wrong code.
    pub fn new(design: &Design) -> Result<Self> {
        let (quantity, bound) = match design.bound {
            Bound::Component(bound) => ("component", bound),
            Bound::Angle(bound) => ("angle", bound),
            Bound::Unstated(why) => return Ok(Self::unstated(why)),
        };
        let mut worst: Vec<(&str, f64)> = Vec::new();
        for tabulated in &design.tabulated {
            let Some(figures) = table_figures(tabulated)? else {
                return Ok(Self::unstated(
                    "it rests on the exact worst error of each table, and one has too many words to go through",
                ));
            };
            worst.extend(figures.iter().map(|figures| (figures.table, figures.worst)));
        }
        let worst_of = |name: &str| {
            let of = worst.iter().filter(|(table, _)| *table == name).map(|(_, worst)| *worst);
            let most = of.fold(f64::NEG_INFINITY, f64::max);
            assert!(most >= 0.0, "bug: no table `{name}`");
            most
        };
        Ok(Self {
            quantity: Some(quantity),
            bound: Some(bound(&design.values, &worst_of)),
            why: None,
        })
    }

    fn unstated(why: &'static str) -> Self {
        Self { quantity: None, bound: None, why: Some(why) }
    }

    /// The largest total error of the bounded quantity in a report.
    #[must_use]
    pub fn seen(&self, report: &Report) -> Option<f64> {
        match self.quantity? {
            "component" => ["x", "y", "z"]
                .into_iter()
                .map(|component| report.figures(component, Basis::Total).max)
                .reduce(f64::max),
            quantity => Some(report.figures(quantity, Basis::Total).max),
        }
    }

    /// True unless the bound is broken.
    #[must_use]
    pub fn holds(&self, report: &Report) -> bool {
        match (self.bound, self.seen(report)) {
            (Some(bound), Some(seen)) => seen <= bound, // false for NaN
            _ => true,
        }
    }
}

/// The worst of a group of hard cases, beside plain floating point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HardVerdict {
    /// What is hard about them.
    pub name: &'static str,
    /// Number of cases.
    pub cases: usize,
    /// Input words of the worst case.
    pub words: Vec<i64>,
    /// Bit-true direction.
    pub fixed: [f64; 3],
    /// Direction by the golden in `f32`.
    pub float32: [f64; 3],
    /// Direction by the golden in `f64`.
    pub float64: [f64; 3],
    /// Error of the bounded quantity, bit-true against `f64`; the angle in rad where none is bounded.
    pub error: f64,
    /// Largest angle between `f32` and `f64` over the group, in rad.
    pub float32_error: f64,
    /// The stated bound.
    pub bound: Option<f64>,
    /// Whether it holds for every case of the group; `None` without a bound.
    pub holds: Option<bool>,
}

/// Judges each group of the hard-case list.
///
/// # Panics
/// If a case doesn't have one word per input port: that is wrong code.
#[must_use]
pub fn hard_verdicts(design: &Design, bound: &BoundCheck) -> Vec<HardVerdict> {
    let netlist = &design.netlist;
    let outputs: Vec<NodeId> = netlist.outputs().iter().map(|output| output.node).collect();
    let program = Program::compile(netlist, &outputs);
    let mut runner = program.runner();
    let mut verdicts = Vec::new();
    for group in &design.hard {
        let columns: Vec<Vec<i64>> = (0..netlist.inputs().len())
            .map(|port| group.words.iter().map(|case| case[port]).collect())
            .collect();
        let slices: Vec<&[i64]> = columns.iter().map(Vec::as_slice).collect();
        let mut words = vec![Vec::new(); outputs.len()];
        runner.run(&program, &slices, &mut words);
        let (mut values, mut inputs) = (Vec::new(), Vec::new());
        values_of(netlist, &outputs, &words, &mut values);
        values_of(netlist, netlist.inputs(), &columns, &mut inputs);
        let (mut fixed, mut float64) = <([Vec<f64>; 3], [Vec<f64>; 3])>::default();
        directions(design.shape, &values, &mut fixed);
        run_golden(design, &inputs, &mut float64);
        let inputs32: Vec<Vec<f32>> =
            inputs.iter().map(|column| column.iter().map(|x| cast::f32_of(*x)).collect()).collect();
        let slices: Vec<&[f32]> = inputs32.iter().map(Vec::as_slice).collect();
        let mut float32 = [(); 3].map(|()| vec![0.0f32; group.words.len()]);
        (design.golden_f32)(&slices, &mut float32);
        let at = |columns: &[Vec<f64>; 3], i: usize| [columns[0][i], columns[1][i], columns[2][i]];
        let at32 = |i: usize| [0, 1, 2].map(|axis| f64::from(float32[axis][i]));
        let error = |i: usize| {
            let (is, should) = (at(&fixed, i), at(&float64, i));
            match bound.quantity {
                Some("component") => {
                    (0..3).map(|axis| (is[axis] - should[axis]).abs()).fold(0.0, f64::max)
                }
                _ => angle_between(is, should),
            }
        };
        let cases = group.words.len();
        let worst = (0..cases).max_by(|a, b| error(*a).total_cmp(&error(*b)));
        let Some(worst) = worst else { continue };
        let float32_errors = (0..cases).map(|i| angle_between(at32(i), at(&float64, i)));
        verdicts.push(HardVerdict {
            name: group.name,
            cases,
            words: group.words[worst].clone(),
            fixed: at(&fixed, worst),
            float32: at32(worst),
            float64: at(&float64, worst),
            error: error(worst),
            float32_error: float32_errors.fold(0.0, f64::max),
            bound: bound.bound,
            holds: bound.bound.map(|bound| error(worst) <= bound),
        });
    }
    verdicts
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
