//! Pictures of differences, with their scales.

use super::compare::check_equal_sizes;
use super::draw::{Canvas, GAP_PX, LINE_PX, code, text_width};
use super::pixels::{LUMINANCE, NAN_COLOUR, Picture, Srgb8, encode};
use crate::base::cast;
use crate::base::error::{Error, Result};
use rayon::prelude::*;

/// How much a difference is amplified before it is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amplify {
    /// By the largest power of two that keeps the largest difference at 1 or below; by 1 if there
    /// is no difference.
    Fit,
    /// By a factor above 0; results above 1 are drawn as 1.
    By(f64),
}

impl Amplify {
    /// The factor for the largest of some differences; infinite ones and NaN are ignored.
    fn factor(self, differences: impl Iterator<Item = f64>) -> Result<f64> {
        match self {
            Self::By(factor) if factor.is_finite() && factor > 0.0 => Ok(factor),
            Self::By(factor) => {
                let legal = "a number above 0".to_owned();
                Err(Error::parameter_value("amplify", &factor.to_string(), legal))
            }
            Self::Fit => {
                let finite = differences.filter(|difference| difference.is_finite());
                let max = finite.fold(0.0, f64::max);
                Ok(if max > 0.0 { libm::exp2(-libm::log2(max).ceil()) } else { 1.0 })
            }
        }
    }
}

/// Draws the absolute difference of each channel in linear light, amplified, black where there is
/// none. Beside it is a scale with the difference at its top, 0 at its bottom, and the factor.
///
/// NaN differences are drawn in [`NAN_COLOUR`], and the scale labels that colour.
///
/// # Errors
/// If the pictures differ in size, the factor isn't a number above 0, or the result would be larger
/// than a picture may be.
pub fn absolute_map(picture: &Picture, golden: &Picture, amplify: Amplify) -> Result<Srgb8> {
    check_equal_sizes(picture, golden)?;
    let pairs = picture.pixels().par_iter().zip(golden.pixels());
    let differences: Vec<[f32; 3]> =
        pairs.map(|(a, b)| std::array::from_fn(|i| (a[i] - b[i]).abs())).collect();
    let factor = amplify.factor(differences.as_flattened().iter().map(|d| f64::from(*d)))?;
    let draw = |pixel: &[f32; 3]| encode(pixel.map(|d| cast::f32_of(f64::from(d) * factor)));
    let map = Map {
        width_px: picture.width_px(),
        codes: differences.par_iter().map(draw).collect(),
        has_nan: differences.as_flattened().iter().any(|d| d.is_nan()),
        labels: vec![(0.0, "0".to_owned()), (1.0, short(1.0 / factor))],
        below: format!("×{}", short(factor)),
    };
    map.with_scale(|height| encode([cast::f32_of(height); 3]))
}

/// Draws the signed difference of luminance (BT.709 weights of linear light, 0..=1 within 0..=1):
/// blue where the picture is darker than the golden one, white where equal, red where it is
/// brighter. Beside it is a scale with the difference at its top, its negative at its bottom, and
/// the factor.
///
/// NaN differences are drawn in [`NAN_COLOUR`], and the scale labels that colour.
///
/// # Errors
/// As [`absolute_map`].
pub fn signed_map(picture: &Picture, golden: &Picture, amplify: Amplify) -> Result<Srgb8> {
    check_equal_sizes(picture, golden)?;
    let error = |(a, b): (&[f32; 3], &[f32; 3])| -> f64 {
        (0..3).map(|i| LUMINANCE[i] * (f64::from(a[i]) - f64::from(b[i]))).sum()
    };
    let errors: Vec<f64> = picture.pixels().par_iter().zip(golden.pixels()).map(error).collect();
    let factor = amplify.factor(errors.iter().map(|error| error.abs()))?;
    let map = Map {
        width_px: picture.width_px(),
        codes: errors.par_iter().map(|error| diverging(error * factor)).collect(),
        has_nan: errors.iter().any(|error| error.is_nan()),
        labels: vec![
            (0.0, format!("-{}", short(1.0 / factor))),
            (0.5, "0".to_owned()),
            (1.0, format!("+{}", short(1.0 / factor))),
        ],
        below: format!("×{}", short(factor)),
    };
    map.with_scale(|height| diverging(2.0 * height - 1.0))
}

/// The colour of a number, -1..=1: ColorBrewer's RdBu (C. Brewer) in seven steps, red for positive
/// numbers, with a white middle.
fn diverging(x: f64) -> [u8; 3] {
    const STEPS: [[u8; 3]; 7] = [
        [33, 102, 172],
        [103, 169, 207],
        [209, 229, 240],
        [255, 255, 255],
        [253, 219, 199],
        [239, 138, 98],
        [178, 24, 43],
    ];
    if x.is_nan() {
        return NAN_COLOUR;
    }
    let place = 3.0 * x.clamp(-1.0, 1.0) + 3.0;
    let step = cast::usize_of(place).min(STEPS.len() - 2);
    let part = place - cast::f64_of_len(step);
    std::array::from_fn(|i| {
        let (from, to) = (f64::from(STEPS[step][i]), f64::from(STEPS[step + 1][i]));
        code(from + part * (to - from))
    })
}

/// Formats a number with at most four digits, exact for powers of two that fit.
fn short(x: f64) -> String {
    if (1.0..1e6).contains(&x) {
        return format!("{}", (x * 1e3).round() / 1e3);
    }
    let digits = format!("{x:.3e}");
    // `{:e}` of the rounded number has no trailing zeros.
    let rounded: f64 = digits.parse().unwrap_or(x);
    if (1e-3..1.0).contains(&rounded) { format!("{rounded}") } else { format!("{rounded:e}") }
}

/// A drawn difference, before its scale.
struct Map {
    width_px: usize,
    codes: Vec<[u8; 3]>,
    has_nan: bool,
    /// Heights along the scale, 0 (bottom) to 1 (top), and their labels.
    labels: Vec<(f64, String)>,
    /// Text below the scale.
    below: String,
}

/// Width of a scale's bar, its minimum height, and the gap between bar and labels.
const BAR_PX: usize = 16;
const MIN_BAR_PX: usize = 4 * LINE_PX;
const LABEL_GAP_PX: usize = 4;

impl Map {
    /// The map with a colour bar to its right, from 0 (bottom) to 1 (top).
    fn with_scale(self, colour: impl Fn(f64) -> [u8; 3]) -> Result<Srgb8> {
        let nan = if self.has_nan { "NaN" } else { "" };
        let words = self.labels.iter().map(|(_, label)| label.as_str()).chain([nan]);
        let beside = BAR_PX + LABEL_GAP_PX + words.map(text_width).max().unwrap_or(0);
        let right = beside.max(text_width(&self.below));
        let picture = Srgb8 { width_px: self.width_px, codes: self.codes };
        let size = (picture.width_px(), picture.height_px());

        // Only the frame surrounds the picture, so that it lines up with others.
        let corner = (1, 1);
        let below = 2 * (LINE_PX + GAP_PX);
        let bar_height = size.1.saturating_sub(below).max(MIN_BAR_PX);
        let bar_left = 1 + size.0 + 2 * GAP_PX;
        let label_left = bar_left + BAR_PX + LABEL_GAP_PX;
        let height = size.1.max(bar_height + below) + 2;
        let mut canvas = Canvas::new(bar_left + right + GAP_PX, height)?;
        canvas.framed(corner, size, |x, y| picture.codes[y * size.0 + x]);
        canvas.framed((bar_left, 1), (BAR_PX, bar_height), |_, y| {
            colour(1.0 - cast::f64_of_len(y) / cast::f64_of_len(bar_height - 1))
        });
        for (place, label) in &self.labels {
            let down = (1.0 - place) * cast::f64_of_len(bar_height - LINE_PX);
            canvas.text((label_left, 1 + cast::usize_of(down)), label);
        }
        let mut top = 1 + bar_height + GAP_PX;
        canvas.text((bar_left, top), &self.below);
        if self.has_nan {
            top += LINE_PX + GAP_PX / 2;
            canvas.framed((bar_left, top + 2), (BAR_PX, LINE_PX - 4), |_, _| NAN_COLOUR);
            canvas.text((label_left, top), nan);
        }
        Ok(canvas.done())
    }
}
