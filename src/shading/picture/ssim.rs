//! Structural similarity: Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment: from error
//! visibility to structural similarity", 2004.

use super::filter::{Plane, sum_over_bands};
use super::pixels::{LUMINANCE, Srgb8};
use crate::base::cast;

/// Side of the window, in px.
const WINDOW_PX: usize = 11;
const SIGMA_PX: f64 = 1.5;
/// `(K1 L)²` and `(K2 L)²` with K1 = 0.01, K2 = 0.03, L = 255.
const C1: f64 = 6.5025;
const C2: f64 = 58.5225;

/// Mean SSIM, -1..=1, of the luma (BT.709, 0..=255, not rounded) of two pictures of equal size,
/// over all windows that lie inside them. 1 if they are equal.
///
/// The window is 11 px wide and high, Gaussian with a standard deviation of 1.5 px. Along a shorter
/// side of the picture it is as long as that side, still centred: a picture of one pixel is one
/// window without variance.
pub(super) fn ssim(a: &Srgb8, b: &Srgb8) -> f64 {
    let (width, height) = (a.width_px(), a.height_px());
    let (across, down) = (window(width), window(height));
    let rows = height + 1 - down.len();
    let sum = sum_over_bands(rows, |band| {
        let inside = band.start * width..(band.end + down.len() - 1) * width;
        let luma = |picture: &Srgb8| picture.codes[inside.clone()].iter().map(luma).collect();
        let (a, b): (Vec<f64>, Vec<f64>) = (luma(a), luma(b));
        let mean_of_product = |a: &[f64], b: &[f64]| {
            mean(a.iter().zip(b).map(|(a, b)| a * b).collect(), width, &across, &down)
        };
        let (aa, bb) = (mean_of_product(&a, &a), mean_of_product(&b, &b));
        let ab = mean_of_product(&a, &b);
        let (a, b) = (mean(a, width, &across, &down), mean(b, width, &across, &down));
        (0..a.len())
            .map(|i| {
                let (aa, bb, ab) = (aa[i] - a[i] * a[i], bb[i] - b[i] * b[i], ab[i] - a[i] * b[i]);
                (2.0 * a[i] * b[i] + C1) * (2.0 * ab + C2)
                    / ((a[i] * a[i] + b[i] * b[i] + C1) * (aa + bb + C2))
            })
            .sum()
    });
    sum / cast::f64_of_len(rows * (width + 1 - across.len()))
}

fn luma(codes: &[u8; 3]) -> f64 {
    codes.iter().zip(LUMINANCE).map(|(code, weight)| f64::from(*code) * weight).sum()
}

/// Weights along a side; they sum to 1.
fn window(side_px: usize) -> Vec<f64> {
    let len = side_px.min(WINDOW_PX);
    let centre = 0.5 * cast::f64_of_len(len - 1);
    let weight = |i| libm::exp(-0.5 * ((cast::f64_of_len(i) - centre) / SIGMA_PX).powi(2));
    let weights: Vec<f64> = (0..len).map(weight).collect();
    let sum: f64 = weights.iter().sum();
    weights.iter().map(|weight| weight / sum).collect()
}

/// Means of a quantity over each window.
fn mean(values: Vec<f64>, width: usize, across: &[f64], down: &[f64]) -> Vec<f64> {
    Plane { width, values }.along_x(across).along_y(down).values
}
