//! How far a picture is from a golden one, in figures.

use super::flip::flip;
use super::ssim::ssim;
use super::{Picture, Srgb8};
use crate::cast;
use crate::error::{Error, Result};
use rayon::prelude::*;
use serde::{Deserialize, Serialize, Serializer};

/// Pixels per degree of the visual field that FLIP's authors suggest: a 4K display 0.7 m wide,
/// seen from 0.7 m.
pub const PIXELS_PER_DEGREE: f64 = 67.0;

/// How finely FLIP may be told to look. The filters grow with it.
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

/// A largest difference and where it is: the first place from the upper left, if there are
/// several. A NaN is larger than any number.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Extreme {
    /// Absolute difference in linear light.
    #[serde(serialize_with = "real")]
    pub difference: f64,
    /// The channel.
    pub channel: Channel,
    /// Column, from the left.
    pub x_px: usize,
    /// Row, from the top.
    pub y_px: usize,
    /// Linear light in the picture.
    #[serde(serialize_with = "real")]
    pub value: f64,
    /// Linear light in the golden picture.
    #[serde(serialize_with = "real")]
    pub golden: f64,
}

impl Extreme {
    /// The larger of two, the first if none is.
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
    #[serde(serialize_with = "real")]
    pub mean: f64,
}

/// How far a picture is from a golden one.
///
/// In JSON, numbers that it can't write are the texts `NaN`, `inf` and `-inf`.
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
    /// The largest absolute difference of any channel, in linear light.
    pub max: Extreme,
    /// The mean absolute difference of all channels, in linear light.
    #[serde(serialize_with = "real")]
    pub mean: f64,
    /// The differences of red, green and blue.
    pub channels: [ChannelDifference; 3],
    /// Peak signal to noise ratio in dB: a peak of 1 in linear light over the mean squared
    /// difference of all channels. Infinite if the pictures are equal.
    #[serde(serialize_with = "real")]
    pub psnr_db: f64,
    /// Part of the pixels that differ in any of their 8-bit sRGB codes, 0..=1.
    pub srgb8_differing: f64,
    /// The largest difference between 8-bit sRGB codes.
    pub srgb8_max_codes: u8,
    /// Mean structural similarity of the luma (BT.709) of the 8-bit pictures, -1..=1, 1 if they
    /// are equal: Wang et al. 2004, over 11 x 11 px windows that lie inside the picture. A
    /// window is no longer than a side.
    #[serde(serialize_with = "real")]
    pub ssim: f64,
    /// Mean LDR-FLIP of the 8-bit pictures, 0..=1, 0 if they are equal: Andersson et al. 2020.
    /// Beyond its borders a picture goes on with its last pixels.
    #[serde(serialize_with = "real")]
    pub flip: f64,
    /// Pixels per degree of the visual field that FLIP was told.
    pub pixels_per_degree: f64,
}

/// As text where JSON has no number for it.
fn real<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    if value.is_finite() { serializer.serialize_f64(*value) } else { serializer.collect_str(value) }
}

impl Difference {
    /// Compares a picture with a golden one. `pixels_per_degree` is FLIP's, 1..=1000; see
    /// [`PIXELS_PER_DEGREE`].
    ///
    /// # Errors
    /// If the pictures differ in size, or `pixels_per_degree` is outside its range.
    pub fn between(picture: &Picture, golden: &Picture, pixels_per_degree: f64) -> Result<Self> {
        check_equal_sizes(picture, golden)?;
        check_pixels_per_degree(pixels_per_degree)?;
        let codes = [picture.to_srgb8(), golden.to_srgb8()];
        let all = Sums::of(picture, golden, &codes);
        let pixels = cast::f64_of_len(picture.pixels().len());
        let [r, g, b] = all.max;
        let square = all.square / (3.0 * pixels);
        // Codes can't tell what is no number.
        let or_nan = |figure: &dyn Fn() -> f64| if square.is_nan() { f64::NAN } else { figure() };
        Ok(Self {
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

/// Fails if FLIP can't be told so, which takes no pictures to know.
pub(crate) fn check_pixels_per_degree(pixels_per_degree: f64) -> Result<()> {
    if LEGAL_PIXELS_PER_DEGREE.contains(&pixels_per_degree) {
        return Ok(());
    }
    let given = format!("{pixels_per_degree:?}"); // as a power of ten, where that is shorter
    let legal = "a number from 1 to 1000".to_owned();
    Err(Error::parameter_value("pixels_per_degree", &given, legal))
}

/// What is known of some rows.
struct Sums {
    max: [Extreme; 3],
    absolute: [f64; 3],
    square: f64,
    differing: u64,
    max_codes: u8,
}

impl Sums {
    fn of(picture: &Picture, golden: &Picture, codes: &[Srgb8; 2]) -> Self {
        let row = |y| Self::of_row(picture, golden, codes, y);
        let rows: Vec<Self> = (0..picture.height_px()).into_par_iter().map(row).collect();
        // From the top down, whatever thread summed a row.
        rows.into_iter().reduce(Self::and).expect("bug: a picture without rows")
    }

    fn of_row(picture: &Picture, golden: &Picture, codes: &[Srgb8; 2], y_px: usize) -> Self {
        let width = picture.width_px();
        let first = y_px * width;
        let extreme = |x_px: usize, i: usize| {
            let value = f64::from(picture.pixels()[first + x_px][i]);
            let golden = f64::from(golden.pixels()[first + x_px][i]);
            let difference = (value - golden).abs();
            Extreme { difference, channel: CHANNELS[i], x_px, y_px, value, golden }
        };
        let mut sums = Self {
            max: std::array::from_fn(|i| extreme(0, i)),
            absolute: [0.0; 3],
            square: 0.0,
            differing: 0,
            max_codes: 0,
        };
        for x in 0..width {
            let mut number = true;
            for i in 0..3 {
                let here = extreme(x, i);
                sums.max[i] = sums.max[i].or_later(here);
                sums.absolute[i] += here.difference;
                sums.square += here.difference * here.difference;
                number &= !here.difference.is_nan();
            }
            let [a, b] = codes.each_ref().map(|picture| picture.codes()[first + x]);
            let apart = |i: usize| a[i].abs_diff(b[i]);
            // Codes can't tell what is no number: it differs from everything by everything.
            let most = if number { apart(0).max(apart(1)).max(apart(2)) } else { u8::MAX };
            sums.differing += u64::from(most > 0);
            sums.max_codes = sums.max_codes.max(most);
        }
        sums
    }

    /// These rows and later ones.
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
