//! Accumulated errors: sums, the largest error with its sample, and a histogram for quantiles.

use super::report::{Basis, Figures, Witness};
use crate::base::cast;
use crate::base::simd::{Body, vectorised};
use crate::number::trig::atan2;
use std::f64::consts::PI;
use std::sync::{Mutex, PoisonError};

/// Angle between two vectors in rad, accurate for small angles too. A null vector has no direction:
/// its angle to any other vector is π, and to another null vector 0.
#[inline(always)]
#[must_use]
pub fn angle_between(u: [f64; 3], v: [f64; 3]) -> f64 {
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let dot = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    let sine = (cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]).sqrt();
    let angle = atan2(sine, dot);
    let same = u[0] == v[0] && u[1] == v[1] && u[2] == v[2];
    let opposite = sine == 0.0 && dot == 0.0 && !same;
    if opposite { PI } else { angle }
}

/// [`angle_between`] of columns of vectors.
pub(super) struct Angles<'a> {
    pub(super) u: [&'a [f64]; 3],
    pub(super) v: [&'a [f64]; 3],
    pub(super) angles: &'a mut [f64],
}

impl Body for Angles<'_> {
    #[inline(always)]
    fn run(self) {
        let len = self.angles.len();
        let ([ux, uy, uz], [vx, vy, vz]) = (self.u.map(|u| &u[..len]), self.v.map(|v| &v[..len]));
        for i in 0..len {
            self.angles[i] = angle_between([ux[i], uy[i], uz[i]], [vx[i], vy[i], vz[i]]);
        }
    }
}

/// Differences of two columns, times a factor.
pub(super) struct Differences<'a> {
    pub(super) is: &'a [f64],
    pub(super) should: &'a [f64],
    pub(super) factor: f64,
    pub(super) errors: &'a mut [f64],
}

impl Body for Differences<'_> {
    #[inline(always)]
    fn run(self) {
        for ((error, is), should) in self.errors.iter_mut().zip(self.is).zip(self.should) {
            *error = (is - should) * self.factor;
        }
    }
}

/// Lengths of differences of columns of vectors.
pub(super) struct Lengths<'a> {
    pub(super) u: [&'a [f64]; 3],
    pub(super) v: [&'a [f64]; 3],
    pub(super) lengths: &'a mut [f64],
}

impl Body for Lengths<'_> {
    #[inline(always)]
    fn run(self) {
        let len = self.lengths.len();
        let ([ux, uy, uz], [vx, vy, vz]) = (self.u.map(|u| &u[..len]), self.v.map(|v| &v[..len]));
        for i in 0..len {
            let d = [ux[i] - vx[i], uy[i] - vy[i], uz[i] - vz[i]];
            self.lengths[i] = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
        }
    }
}

/// Octaves of the histogram: from 2^-44 to 2^24, which covers texels and reciprocals too.
const OCTAVES: usize = 68;
const LEAST_EXPONENT: u64 = 1023 - 44;
/// Errors below it go to the first bin.
const LEAST: f64 = 5.684_341_886_080_802e-14; // 2^-44
/// The exponent of [`LEAST`], shifted left by the mantissa bits of a bin.
const LEAST_KEY: i32 = (1023 - 44) << BINS_PER_OCTAVE_BITS;
const LAST_BIN: i32 = 68 * (1 << BINS_PER_OCTAVE_BITS) - 1;
/// log2 of the bins per octave: a quantile is accurate to 1.6 %.
const BINS_PER_OCTAVE_BITS: u32 = 5;
pub(crate) const BINS: usize = OCTAVES << BINS_PER_OCTAVE_BITS;
// Constants written twice, since casts aren't available, must agree.
const _: () = assert!(LEAST_EXPONENT << BINS_PER_OCTAVE_BITS == LEAST_KEY.unsigned_abs() as u64);
const _: () = assert!(BINS == LAST_BIN.unsigned_abs() as usize + 1);

/// Sums of the errors of one quantity on one basis, and the largest error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stream {
    pub(super) count: u64,
    pub(super) max: f64,
    /// Sample that gave the maximum.
    pub(super) at: u64,
    pub(super) sum_abs: f64,
    pub(super) sum: f64,
    pub(super) sum_squares: f64,
}

impl Stream {
    pub(crate) const EMPTY: Self =
        Self { count: 0, max: -1.0, at: 0, sum_abs: 0.0, sum: 0.0, sum_squares: 0.0 };

    /// Sums errors of consecutive samples from `start`, and counts them in a histogram.
    ///
    /// Sums use [`LANES`] lanes on every processor, so roundings are the same everywhere.
    pub(crate) fn of(errors: &[f64], start: u64, histogram: &mut [u32]) -> Self {
        let mut sums = Sums::default();
        // The run of errors that contains the largest; it is searched at the end.
        let mut largest = 0..0;
        for run in (0..errors.len()).step_by(RUN) {
            let run = run..errors.len().min(run + RUN);
            let before = sums.largest();
            vectorised(Accumulate { errors: &errors[run.clone()], sums: &mut sums });
            if sums.largest() > before {
                largest = run.clone();
            }
            if sums.largest() < LEAST && !sums.abs.iter().any(|sum| sum.is_nan()) {
                histogram[0] += cast::id_of(run.len());
            } else {
                vectorised(Count { errors: &errors[run], histogram });
            }
        }
        let total = |lanes: [f64; LANES]| lanes.into_iter().fold(0.0, |sum, lane| sum + lane);
        let mut stream = Self {
            count: cast::count_of(errors.len()),
            sum_abs: total(sums.abs),
            sum: total(sums.plain),
            sum_squares: total(sums.squares),
            ..Self::EMPTY
        };
        // A NaN is larger than everything. Only a NaN makes a sum of absolute values NaN.
        let at = if stream.sum_abs.is_nan() {
            errors.iter().position(|error| error.is_nan())
        } else {
            let max = sums.largest();
            let found = errors[largest.clone()].iter().position(|error| error.abs() == max);
            found.map(|at| largest.start + at)
        };
        if let Some(at) = at {
            stream.max = errors[at].abs();
            stream.at = start + cast::count_of(at);
        }
        stream
    }

    /// Adds the sums of later samples; true if the overall largest error is one of theirs.
    pub(crate) fn merge(&mut self, later: &Self) -> bool {
        let larger = later.max > self.max || later.max.is_nan() && !self.max.is_nan();
        if larger {
            (self.max, self.at) = (later.max, later.at);
        }
        self.count += later.count;
        self.sum_abs += later.sum_abs;
        self.sum += later.sum;
        self.sum_squares += later.sum_squares;
        larger
    }

    /// Figures without scale, ulp and witness; the quantiles come from a histogram.
    pub(crate) fn figures(
        &self,
        quantity: &str,
        unit: &'static str,
        basis: Basis,
        histogram: &[u64],
    ) -> Figures {
        let count = cast::f64_of_count(self.count.max(1));
        Figures {
            quantity: quantity.to_owned(),
            unit,
            over: None,
            basis,
            // -1 means that there was no sample; a NaN stays one.
            max: if self.count == 0 { 0.0 } else { self.max },
            max_ulp: None,
            witness: None,
            mean: self.sum_abs / count,
            bias: self.sum / count,
            rms: (self.sum_squares / count).sqrt(),
            p50: self.quantile(histogram, 0.5),
            p99: self.quantile(histogram, 0.99),
            p999: self.quantile(histogram, 0.999),
        }
    }

    /// The error that `share` of all errors don't exceed, to the width of a bin.
    fn quantile(&self, histogram: &[u64], share: f64) -> f64 {
        let wanted = (share * cast::f64_of_count(self.count)).ceil();
        let mut seen = 0;
        for (index, count) in histogram.iter().enumerate() {
            seen += count;
            if cast::f64_of_count(seen) >= wanted && seen > 0 {
                // The last bin also holds all larger errors.
                let middle = if index + 1 == BINS { self.max } else { bin_middle(index) };
                return middle.min(self.max);
            }
        }
        0.0
    }
}

/// Lanes of the sums.
const LANES: usize = 8;

/// Sums over a block, lane by lane.
struct Sums {
    abs: [f64; LANES],
    plain: [f64; LANES],
    squares: [f64; LANES],
    max: [f64; LANES],
}

impl Default for Sums {
    fn default() -> Self {
        let zero = [0.0; LANES];
        Self { abs: zero, plain: zero, squares: zero, max: [-1.0; LANES] }
    }
}

impl Sums {
    /// The largest absolute value; NaNs are ignored.
    fn largest(&self) -> f64 {
        self.max.into_iter().fold(-1.0, f64::max)
    }
}

/// Errors per pass over the sums and then the histogram: they stay in the first-level cache.
const RUN: usize = 512;

struct Accumulate<'a> {
    errors: &'a [f64],
    sums: &'a mut Sums,
}

impl Body for Accumulate<'_> {
    #[inline(always)]
    fn run(self) {
        let Sums { mut abs, mut plain, mut squares, mut max } = *self.sums;
        let mut add = |lane: usize, error: f64| {
            let size = error.abs();
            abs[lane] += size;
            plain[lane] += error;
            squares[lane] += error * error;
            max[lane] = if size > max[lane] { size } else { max[lane] };
        };
        let blocks = self.errors.chunks_exact(LANES);
        let rest = blocks.remainder();
        for block in blocks {
            for (lane, error) in block.iter().enumerate() {
                add(lane, *error);
            }
        }
        for (lane, error) in rest.iter().enumerate() {
            add(lane, *error);
        }
        *self.sums = Sums { abs, plain, squares, max };
    }
}

/// Counts the errors of a run in a histogram.
struct Count<'a> {
    errors: &'a [f64],
    histogram: &'a mut [u32],
}

impl Body for Count<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { errors, histogram } = self;
        // Compute all bins first, vectorised. A count then waits only for the previous one in its
        // bin.
        let mut bins = [0; RUN];
        let bins = &mut bins[..errors.len()];
        for (bin_of, error) in bins.iter_mut().zip(errors) {
            *bin_of = cast::low_u16(i64::from(bin(error.abs())));
        }
        for bin in bins {
            histogram[usize::from(*bin)] += 1;
        }
    }
}

/// Histograms of all quantities of a design. Counts are whole numbers, so threads may add them in
/// any order.
#[derive(Debug)]
pub(crate) struct Histograms(Mutex<Vec<u64>>);

impl Histograms {
    pub(crate) fn new(streams: usize) -> Self {
        Self(Mutex::new(vec![0; streams * BINS]))
    }

    /// Adds a thread's counts and clears them.
    pub(crate) fn take(&self, counts: &mut [u32]) {
        // A panic elsewhere leaves whole numbers; the run is lost anyway.
        let mut totals = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        for (total, count) in totals.iter_mut().zip(counts) {
            *total += u64::from(std::mem::take(count));
        }
    }

    /// Counts of one quantity.
    pub(crate) fn of(&self, stream: usize) -> Vec<u64> {
        let totals = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        totals[stream * BINS..(stream + 1) * BINS].to_vec()
    }
}

/// A thread's counts, which are added to the totals when it is done.
#[derive(Debug)]
pub(super) struct Counts<'a> {
    all: &'a Histograms,
    own: Vec<u32>,
    /// Upper bound on the samples counted since the last addition to the totals.
    samples: u32,
}

impl<'a> Counts<'a> {
    pub(super) fn new(all: &'a Histograms, streams: usize) -> Self {
        Self { all, own: vec![0; streams * BINS], samples: 0 }
    }

    /// Adds the counts to the totals if this many more samples could overflow a count.
    pub(super) fn make_room(&mut self, samples: usize) {
        let samples = cast::id_of(samples);
        self.samples = self.samples.checked_add(samples).unwrap_or_else(|| {
            self.all.take(&mut self.own);
            samples
        });
    }

    /// Counts of one quantity.
    pub(super) fn of(&mut self, stream: usize) -> &mut [u32] {
        &mut self.own[stream * BINS..(stream + 1) * BINS]
    }
}

impl Drop for Counts<'_> {
    fn drop(&mut self) {
        self.all.take(&mut self.own);
    }
}

/// Bin of the histogram: the exponent and the first bits of the mantissa.
#[inline(always)]
fn bin(size: f64) -> i32 {
    // The sign bit is clear, so 17 bits are left.
    let key = size.to_bits() >> (f64::MANTISSA_DIGITS - 1 - BINS_PER_OCTAVE_BITS);
    let bin = cast::low_i32(cast::word_of_bits(key)) - LEAST_KEY;
    let bin = if bin < 0 { 0 } else { bin };
    if bin > LAST_BIN { LAST_BIN } else { bin }
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

/// Sums of all chunks so far, and the input of the largest error.
#[derive(Clone, Debug)]
pub(super) struct Merged {
    pub(super) stream: Stream,
    pub(super) witness: Option<Witness>,
}

impl Merged {
    pub(super) const EMPTY: Self = Self { stream: Stream::EMPTY, witness: None };

    /// Adds the next chunk's stream; the first of equal maxima stays the witness.
    pub(super) fn merge(&mut self, other: &Stream, witness: Witness) {
        if self.stream.merge(other) {
            self.witness = Some(witness);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// More samples in one bin than a thread's own count holds.
    #[test]
    fn counts_have_room_for_any_number_of_samples() {
        let all = Histograms::new(1);
        let mut counts = Counts::new(&all, 1);
        counts.make_room(3);
        counts.of(0)[0] = 3;
        // As if so many had been counted.
        let many = u32::MAX - 5;
        counts.samples += many;
        counts.of(0)[0] += many;
        for _ in 0..3 {
            counts.make_room(512);
            let stream = Stream::of(&[0.0; 512], 0, counts.of(0));
            assert_eq!(stream.count, 512);
        }
        drop(counts);
        assert_eq!(all.of(0)[0], u64::from(many) + 3 + 3 * 512);
    }
}
