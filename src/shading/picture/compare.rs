//! Figures for the difference of a picture to its golden picture.

use super::flip::flip;
use super::pixels::{Picture, Srgb8};
use super::ssim::ssim;
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::json;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Pixels per degree of the visual field as FLIP's authors suggest: a 4K display 0.7 m wide, seen
/// from 0.7 m.
pub const PIXELS_PER_DEGREE: f64 = 67.0;

/// The resolutions that FLIP accepts. The filters grow with them.
const LEGAL_PIXELS_PER_DEGREE: std::ops::RangeInclusive<f64> = 1.0..=1000.0;

/// A channel of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Channel {
    /// Red.
    Red,
    /// Green.
    Green,
    /// Blue.
    Blue,
}

impl Channel {
    /// Its name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Red => "red",
            Self::Green => "green",
            Self::Blue => "blue",
        }
    }
}

const CHANNELS: [Channel; 3] = [Channel::Red, Channel::Green, Channel::Blue];

/// A largest difference and its position: the first from the upper left, if there are several. A
/// NaN is larger than any number.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Extreme {
    /// Absolute difference in linear light.
    #[serde(serialize_with = "json::real")]
    pub difference: f64,
    /// The channel.
    pub channel: Channel,
    /// Column, from the left.
    pub x_px: usize,
    /// Row, from the top.
    pub y_px: usize,
    /// Linear light in the picture.
    #[serde(serialize_with = "json::real")]
    pub value: f64,
    /// Linear light in the golden picture.
    #[serde(serialize_with = "json::real")]
    pub golden: f64,
}

impl Extreme {
    /// The larger of two, where NaN is largest; the first if neither is larger (equal, or both
    /// NaN).
    fn or_later(self, later: Self) -> Self {
        let larger = later.difference > self.difference
            || later.difference.is_nan() && !self.difference.is_nan();
        if larger { later } else { self }
    }
}

/// Differences of one channel, in linear light.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ChannelDifference {
    /// The largest absolute difference.
    pub max: Extreme,
    /// The mean absolute difference.
    #[serde(serialize_with = "json::real")]
    pub mean: f64,
}

/// The difference of a picture to a golden one.
///
/// For a rendered scene, per-pixel figures count only pixels that see an object: an empty
/// background, which is the same in both pictures, would make every mean arbitrarily small. SSIM
/// and FLIP look at neighbourhoods and count the whole picture, as other tools do.
///
/// In JSON, numbers that it can't represent are the strings `NaN`, `inf` and `-inf`.
///
/// ```
/// use fixpath::picture::{Difference, PIXELS_PER_DEGREE, Picture};
///
/// let golden = Picture::from_fn(64, 64, |x, _| [x as f32 / 64.0; 3])?;
/// let picture = Picture::from_fn(64, 64, |x, _| [(x / 4 * 4) as f32 / 64.0; 3])?;
/// let difference = Difference::between(&picture, &golden, PIXELS_PER_DEGREE)?;
/// assert_eq!(difference.max.difference, 3.0 / 64.0);
/// assert_eq!(difference.mean, 1.5 / 64.0);
/// # Ok::<(), fixpath::error::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// Number of pixels that the per-pixel figures count: those that see an object.
    pub covered_px: u64,
    /// Number of other pixels.
    pub background_px: u64,
    /// The largest absolute difference of any channel, in linear light.
    pub max: Extreme,
    /// The mean absolute difference of all channels of covered pixels, in linear light.
    #[serde(serialize_with = "json::real")]
    pub mean: f64,
    /// The differences of red, green and blue.
    pub channels: [ChannelDifference; 3],
    /// Peak signal-to-noise ratio in dB: a peak of 1 in linear light over the mean squared
    /// difference of all channels of covered pixels. Infinite if the pictures are equal.
    #[serde(serialize_with = "json::real")]
    pub psnr_db: f64,
    /// Fraction of the covered pixels that differ in any of their 8-bit sRGB codes, 0..=1.
    pub srgb8_differing: f64,
    /// The largest difference between 8-bit sRGB codes.
    pub srgb8_max_codes: u8,
    /// Mean structural similarity of the luma (BT.709) of the 8-bit pictures, -1..=1, 1 if they are
    /// equal: Wang et al. 2004, over 11 x 11 px windows inside the picture. A window is at most as
    /// long as the picture's side.
    #[serde(serialize_with = "json::real")]
    pub ssim: f64,
    /// Mean LDR-FLIP of the 8-bit pictures, 0..=1, 0 if they are equal: Andersson et al. 2020. A
    /// picture is extended beyond its borders with its border pixels.
    #[serde(serialize_with = "json::real")]
    pub flip: f64,
    /// Pixels per degree of the visual field given to FLIP.
    pub pixels_per_degree: f64,
}

impl Difference {
    /// Compares a whole picture with a golden one. `pixels_per_degree` is FLIP's, 1..=1000; see
    /// [`PIXELS_PER_DEGREE`].
    ///
    /// # Errors
    /// If the pictures differ in size, or `pixels_per_degree` is outside its range.
    pub fn between(picture: &Picture, golden: &Picture, pixels_per_degree: f64) -> Result<Self> {
        Self::over(&vec![true; picture.pixels().len()], picture, golden, pixels_per_degree)
    }

    /// Compares a picture of a scene with a golden one: `covered` says which pixels see an object.
    ///
    /// # Errors
    /// As [`between`](Self::between), or if no pixel is covered: there is nothing to compare then.
    pub fn over(
        covered: &[bool],
        picture: &Picture,
        golden: &Picture,
        pixels_per_degree: f64,
    ) -> Result<Self> {
        check_equal_sizes(picture, golden)?;
        check_pixels_per_degree(pixels_per_degree)?;
        if covered.len() != picture.pixels().len() {
            let text = format!(
                "`covered` has {} entries, but the picture has {} pixels",
                covered.len(),
                picture.pixels().len()
            );
            return Err(Error::usage(text));
        }
        let codes = [picture.to_srgb8(), golden.to_srgb8()];
        let all = Sums::of(covered, picture, golden, &codes).ok_or_else(nothing_in_view)?;
        let covered_px = cast::count_of(covered.iter().filter(|covered| **covered).count());
        let pixels = cast::f64_of_count(covered_px);
        let [r, g, b] = all.max;
        let square = all.square / (3.0 * pixels);
        // 8-bit codes can't represent NaN.
        let or_nan = |figure: &dyn Fn() -> f64| if square.is_nan() { f64::NAN } else { figure() };
        Ok(Self {
            covered_px,
            background_px: cast::count_of(covered.len()) - covered_px,
            max: r.or_later(g).or_later(b),
            mean: all.absolute.iter().sum::<f64>() / (3.0 * pixels),
            channels: std::array::from_fn(|i| ChannelDifference {
                max: all.max[i],
                mean: all.absolute[i] / pixels,
            }),
            psnr_db: -10.0 * libm::log10(square),
            srgb8_differing: cast::f64_of_count(all.differing) / pixels,
            srgb8_max_codes: all.max_codes,
            ssim: or_nan(&|| ssim(&codes[0], &codes[1])),
            flip: or_nan(&|| flip(&codes[0], &codes[1], pixels_per_degree)),
            pixels_per_degree,
        })
    }
}

/// States in words which pixels the means count.
#[must_use]
pub fn coverage(covered_px: u64, background_px: u64) -> String {
    let all = covered_px + background_px;
    format!(
        "{covered_px} of {all} pixels are covered (see an object); means, PSNR and the differing part are over these, SSIM and FLIP over all"
    )
}

/// The error for a picture without a covered pixel.
pub(crate) fn nothing_in_view() -> Error {
    let text = "nothing is in view: no pixel sees an object, so there is no error to report; check the [camera]'s eye and target, and that objects are seen from outside, where their normals point";
    Error::usage(text.to_owned())
}

/// Fails if the value is outside FLIP's range; needs no pictures.
pub(crate) fn check_pixels_per_degree(pixels_per_degree: f64) -> Result<()> {
    if LEGAL_PIXELS_PER_DEGREE.contains(&pixels_per_degree) {
        return Ok(());
    }
    let given = format!("{pixels_per_degree:?}"); // as a power of ten, where that is shorter
    let legal = "a number from 1 to 1000".to_owned();
    Err(Error::parameter_value("pixels_per_degree", &given, legal))
}

/// Sums over the covered pixels of some rows.
struct Sums {
    max: [Extreme; 3],
    absolute: [f64; 3],
    square: f64,
    differing: u64,
    max_codes: u8,
}

impl Sums {
    /// `None` if no pixel is covered.
    fn of(
        covered: &[bool],
        picture: &Picture,
        golden: &Picture,
        codes: &[Srgb8; 2],
    ) -> Option<Self> {
        let row = |y| Self::of_row(covered, picture, golden, codes, y);
        let rows: Vec<Option<Self>> = (0..picture.height_px()).into_par_iter().map(row).collect();
        // Summed from the top down, independent of threads.
        rows.into_iter().flatten().reduce(Self::and)
    }

    fn of_row(
        covered: &[bool],
        picture: &Picture,
        golden: &Picture,
        codes: &[Srgb8; 2],
        y_px: usize,
    ) -> Option<Self> {
        let width = picture.width_px();
        let pixel = |x_px: usize| {
            let at = y_px * width + x_px;
            let channels = std::array::from_fn(|i| {
                let value = f64::from(picture.pixels()[at][i]);
                let golden = f64::from(golden.pixels()[at][i]);
                let difference = (value - golden).abs();
                Extreme { difference, channel: CHANNELS[i], x_px, y_px, value, golden }
            });
            Self::of_pixel(channels, codes.each_ref().map(|picture| picture.codes()[at]))
        };
        (0..width).filter(|x| covered[y_px * width + x]).map(pixel).reduce(Self::and)
    }

    fn of_pixel(channels: [Extreme; 3], [a, b]: [[u8; 3]; 2]) -> Self {
        let absolute = channels.map(|channel| channel.difference);
        let apart = |i: usize| a[i].abs_diff(b[i]);
        // 8-bit codes can't represent NaN: it counts as the largest difference.
        let number = absolute.iter().all(|difference| !difference.is_nan());
        let most = if number { apart(0).max(apart(1)).max(apart(2)) } else { u8::MAX };
        Self {
            max: channels,
            absolute,
            square: absolute.iter().map(|difference| difference * difference).sum(),
            differing: u64::from(most > 0),
            max_codes: most,
        }
    }

    /// The sums of these pixels and later ones.
    fn and(self, later: Self) -> Self {
        Self {
            max: std::array::from_fn(|i| self.max[i].or_later(later.max[i])),
            absolute: std::array::from_fn(|i| self.absolute[i] + later.absolute[i]),
            square: self.square + later.square,
            differing: self.differing + later.differing,
            max_codes: self.max_codes.max(later.max_codes),
        }
    }
}

/// Fails if pictures differ in size.
pub(super) fn check_equal_sizes(picture: &Picture, golden: &Picture) -> Result<()> {
    let size = |p: &Picture| (p.width_px(), p.height_px());
    if size(picture) == size(golden) {
        return Ok(());
    }
    let text = |p: &Picture| format!("{} x {} px", p.width_px(), p.height_px());
    Err(Error::usage(format!(
        "the picture has {} and the golden one {}: only equal sizes can be compared",
        text(picture),
        text(golden)
    )))
}
