//! Accumulated errors: sums, the largest with its sample, a histogram for quantiles.

use crate::cast;
use crate::measure::{Basis, Figures, Witness};
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

/// Octaves of the histogram: from 2^-44 to 2^24, for texels and reciprocals too.
const OCTAVES: usize = 68;
const LEAST_EXPONENT: u64 = 1023 - 44;
/// Bins per octave: a quantile is known to 1.6 %.
const BINS_PER_OCTAVE_BITS: u32 = 5;
pub(crate) const BINS: usize = OCTAVES << BINS_PER_OCTAVE_BITS;

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
    pub(crate) fn of(errors: &[f64], start: u64, histogram: &mut [u32]) -> Self {
        let mut stream = Self { count: cast::count_of(errors.len()), ..Self::EMPTY };
        for (error, index) in errors.iter().zip(start..) {
            let size = error.abs();
            // A NaN is larger than everything.
            if size > stream.max || size.is_nan() && !stream.max.is_nan() {
                stream.max = size;
                stream.at = index;
            }
            stream.sum_abs += size;
            stream.sum += error;
            stream.sum_squares += error * error;
            histogram[bin(size)] += 1;
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
