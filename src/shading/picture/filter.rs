//! Separable filters over bands of rows.

use crate::base::cast;
use crate::base::simd::{Body, vectorised};
use rayon::prelude::*;
use std::ops::Range;

/// Rows per band: enough that few rows are filtered twice, few enough to fit caches and to bound
/// memory.
const BAND: usize = 64;

/// Adds up the results of `body` for each band of `rows`, in order from the top, whatever thread
/// computed them.
pub(super) fn sum_over_bands(rows: usize, body: impl Fn(Range<usize>) -> f64 + Sync) -> f64 {
    let band = |i: usize| body(i * BAND..((i + 1) * BAND).min(rows));
    let sums: Vec<f64> = (0..rows.div_ceil(BAND)).into_par_iter().map(band).collect();
    sums.iter().sum()
}

/// One quantity of some rows of a picture, row after row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Plane {
    pub(super) width: usize,
    pub(super) values: Vec<f64>,
}

impl Plane {
    /// Filters each row; the result is narrower by the kernel's length minus 1.
    pub(super) fn along_x(&self, kernel: &[f64]) -> Self {
        let width = self.width + 1 - kernel.len();
        let mut values = vec![0.0; self.values.len() / self.width * width];
        for (to, from) in values.chunks_exact_mut(width).zip(self.values.chunks_exact(self.width)) {
            vectorised(Weighted { to, from, step: 1, kernel });
        }
        Self { width, values }
    }

    /// Filters each column; the result is lower by the kernel's length minus 1.
    pub(super) fn along_y(&self, kernel: &[f64]) -> Self {
        let lost = (kernel.len() - 1) * self.width;
        let mut values = vec![0.0; self.values.len() - lost];
        for (row, to) in values.chunks_exact_mut(self.width).enumerate() {
            let from = &self.values[row * self.width..];
            vectorised(Weighted { to, from, step: self.width, kernel });
        }
        Self { width: self.width, values }
    }
}

/// Computes `to[i]` as the sum over `k` of `kernel[k] * from[i + k * step]`.
struct Weighted<'a> {
    to: &'a mut [f64],
    from: &'a [f64],
    step: usize,
    kernel: &'a [f64],
}

impl Body for Weighted<'_> {
    #[inline(always)]
    fn run(self) {
        /// Sums that stay in registers.
        const LANES: usize = 16;
        let (blocks, rest) = self.to.as_chunks_mut::<LANES>();
        let done = blocks.len() * LANES;
        for (block, to) in blocks.iter_mut().enumerate() {
            let mut sums = [0.0; LANES];
            for (k, weight) in self.kernel.iter().enumerate() {
                let from = &self.from[block * LANES + k * self.step..][..LANES];
                for (sum, value) in sums.iter_mut().zip(from) {
                    *sum += weight * value;
                }
            }
            *to = sums;
        }
        for (i, to) in rest.iter_mut().enumerate() {
            let terms = self.kernel.iter().enumerate();
            *to = terms.map(|(k, weight)| weight * self.from[done + i + k * self.step]).sum();
        }
    }
}

/// The function's value at each integer from `-radius` to `radius`.
pub(super) fn taps(radius: usize, value: impl Fn(f64) -> f64) -> Vec<f64> {
    let at = |i: usize| cast::f64_of_len(i) - cast::f64_of_len(radius);
    (0..=2 * radius).map(|i| value(at(i))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn filters_are_their_definition_on_every_width() {
        let kernel = [0.5, -1.0, 2.0];
        for width in [3, 4, 18, 19, 35, 70] {
            let values: Vec<f64> =
                (0..5 * width).map(|i| cast::f64_of_len(i * i * 7 % 101)).collect();
            let plane = Plane { width, values };
            let at = |x: usize, y: usize| plane.values[y * width + x];
            let by = |value: [f64; 3]| 0.5 * value[0] - value[1] + 2.0 * value[2];
            let x = plane.along_x(&kernel);
            assert_eq!(x.width, width - 2);
            for y in 0..5 {
                for i in 0..width - 2 {
                    let expected = by([at(i, y), at(i + 1, y), at(i + 2, y)]);
                    assert_eq!(x.values[y * (width - 2) + i], expected, "{width} {i} {y}");
                }
            }
            let y = plane.along_y(&kernel);
            assert_eq!((y.width, y.values.len()), (width, 3 * width));
            for row in 0..3 {
                for i in 0..width {
                    let expected = by([at(i, row), at(i, row + 1), at(i, row + 2)]);
                    assert_eq!(y.values[row * width + i], expected, "{width} {i} {row}");
                }
            }
        }
    }

    #[test]
    fn bands_cover_each_row_once() {
        for rows in [1, 63, 64, 65, 200] {
            let rows_seen = |range: Range<usize>| cast::f64_of_len(range.sum());
            assert_eq!(sum_over_bands(rows, rows_seen), cast::f64_of_len(rows * (rows - 1) / 2));
        }
    }
}
