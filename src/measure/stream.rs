//! Accumulated errors: sums, the largest with its sample, a histogram for quantiles.

use crate::cast;
use crate::measure::{Basis, Figures, Witness};
use crate::simd::{Body, vectorised};
use std::f64::consts::PI;
use std::sync::{Mutex, PoisonError};

/// Angle between two vectors in rad, good for small angles too. A null vector has no
/// direction and counts as opposite to all but another.
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
        if u == v { 0.0 } else { PI }
    } else {
        sine.atan2(dot)
    }
}

/// [`angle_between`] of columns of vectors, bit for bit.
pub(super) fn angles_between(u: [&[f64]; 3], v: [&[f64]; 3], angles: &mut [f64]) {
    let mut large = false;
    vectorised(Angles { u, v, angles, large: &mut large });
    if large {
        for (i, angle) in angles.iter_mut().enumerate().filter(|(_, angle)| angle.is_nan()) {
            *angle = angle_between(u.map(|u| u[i]), v.map(|v| v[i]));
        }
    }
}

/// The series of [`angle_between`]; where it doesn't hold, a NaN.
struct Angles<'a> {
    u: [&'a [f64]; 3],
    v: [&'a [f64]; 3],
    angles: &'a mut [f64],
    large: &'a mut bool,
}

impl Body for Angles<'_> {
    #[inline(always)]
    fn run(self) {
        let len = self.angles.len();
        let ([ux, uy, uz], [vx, vy, vz]) = (self.u.map(|u| &u[..len]), self.v.map(|v| &v[..len]));
        let mut large = false;
        for i in 0..len {
            let cross = [
                uy[i] * vz[i] - uz[i] * vy[i],
                uz[i] * vx[i] - ux[i] * vz[i],
                ux[i] * vy[i] - uy[i] * vx[i],
            ];
            let dot = ux[i] * vx[i] + uy[i] * vy[i] + uz[i] * vz[i];
            let sine = (cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]).sqrt();
            let t = sine / dot;
            let t2 = t * t;
            let angle = t * (1.0 - t2 * (1.0 / 3.0 - t2 * (0.2 - t2 * (1.0 / 7.0 - t2 / 9.0))));
            let small = sine < 0.02 * dot;
            large |= !small;
            self.angles[i] = if small { angle } else { f64::NAN };
        }
        *self.large = large;
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

/// Octaves of the histogram: from 2^-44 to 2^24, for texels and reciprocals too.
const OCTAVES: usize = 68;
const LEAST_EXPONENT: u64 = 1023 - 44;
/// The same with the first bits of the mantissa below it.
const LEAST_KEY: i32 = (1023 - 44) << BINS_PER_OCTAVE_BITS;
const LAST_BIN: i32 = 68 * (1 << BINS_PER_OCTAVE_BITS) - 1;
/// Bins per octave: a quantile is known to 1.6 %.
const BINS_PER_OCTAVE_BITS: u32 = 5;
pub(crate) const BINS: usize = OCTAVES << BINS_PER_OCTAVE_BITS;
// The numbers written twice, for want of casts, are the same.
const _: () = assert!(LEAST_EXPONENT << BINS_PER_OCTAVE_BITS == LEAST_KEY.unsigned_abs() as u64);
const _: () = assert!(BINS == LAST_BIN.unsigned_abs() as usize + 1);

/// Sums over errors of one quantity on one basis, and the largest.
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
    /// Sums run in [`LANES`] lanes whatever the processor, so their roundings are the same on all.
    pub(crate) fn of(errors: &[f64], start: u64, histogram: &mut [u32]) -> Self {
        let mut sums = Sums::default();
        vectorised(Accumulate { errors, sums: &mut sums, histogram });
        let total = |lanes: [f64; LANES]| lanes.into_iter().fold(0.0, |sum, lane| sum + lane);
        let mut stream = Self {
            count: cast::count_of(errors.len()),
            sum_abs: total(sums.abs),
            sum: total(sums.plain),
            sum_squares: total(sums.squares),
            ..Self::EMPTY
        };
        // A NaN is larger than everything. Only a NaN makes a sum of absolute values one.
        let largest = if stream.sum_abs.is_nan() {
            errors.iter().position(|error| error.is_nan())
        } else {
            let max = sums.max.into_iter().fold(-1.0, f64::max);
            errors.iter().position(|error| error.abs() == max)
        };
        if let Some(largest) = largest {
            stream.max = errors[largest].abs();
            stream.at = start + cast::count_of(largest);
        }
        stream
    }

    /// Adds the sums of later samples; true if the largest of all is one of theirs.
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

    /// Figures without ulp and witness, with the quantiles of a histogram.
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

    /// The error that `share` of all are not above, to the width of a bin.
    fn quantile(&self, histogram: &[u64], share: f64) -> f64 {
        let wanted = (share * cast::f64_of_count(self.count)).ceil();
        let mut seen = 0;
        for (index, count) in histogram.iter().enumerate() {
            seen += count;
            if cast::f64_of_count(seen) >= wanted && seen > 0 {
                // The last bin holds all above, too.
                let middle = if index + 1 == BINS { self.max } else { bin_middle(index) };
                return middle.min(self.max);
            }
        }
        0.0
    }
}

/// Lanes of the sums over a block.
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

struct Accumulate<'a> {
    errors: &'a [f64],
    sums: &'a mut Sums,
    histogram: &'a mut [u32],
}

impl Body for Accumulate<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { errors, sums, histogram } = self;
        let Sums { mut abs, mut plain, mut squares, mut max } = *sums;
        let blocks = errors.chunks_exact(LANES);
        let rest = blocks.remainder();
        let mut bins = [0; LANES];
        for block in blocks {
            for lane in 0..LANES {
                let error = block[lane];
                let size = error.abs();
                abs[lane] += size;
                plain[lane] += error;
                squares[lane] += error * error;
                max[lane] = if size > max[lane] { size } else { max[lane] };
                bins[lane] = bin(size);
            }
            for bin in bins {
                histogram[cast::index_of(i64::from(bin))] += 1;
            }
        }
        for (lane, error) in rest.iter().enumerate() {
            let size = error.abs();
            abs[lane] += size;
            plain[lane] += error;
            squares[lane] += error * error;
            max[lane] = if size > max[lane] { size } else { max[lane] };
            histogram[cast::index_of(i64::from(bin(size)))] += 1;
        }
        *sums = Sums { abs, plain, squares, max };
    }
}

/// Histograms of all quantities of a design: whole numbers, so threads may add in any order.
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

/// Bin of the histogram: the exponent and the first bits of the mantissa.
#[inline(always)]
fn bin(size: f64) -> i32 {
    // The sign is clear, so 17 bits are left.
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
