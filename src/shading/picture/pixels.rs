//! Pictures in linear light and in 8-bit sRGB codes.

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::output;
use crate::shading::srgb::from_srgb;
use rayon::prelude::*;
use std::array;
use std::path::Path;
use std::sync::LazyLock;

/// The longest side of a picture.
pub const MAX_SIDE_PX: usize = 1 << 16;

/// The colour of a pixel with a NaN channel in [`Picture::to_srgb8`].
pub const NAN_COLOUR: [u8; 3] = [255, 0, 255];

/// Weights of linear red, green and blue in luminance (ITU-R BT.709, the primaries of sRGB).
pub(super) const LUMINANCE: [f64; 3] = [0.2126, 0.7152, 0.0722];

/// A picture in linear light, with sRGB's primaries: red, green and blue, nominally 0..1.
///
/// Rows run from the top down, pixels from left to right. Values outside 0..1 are kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    width_px: usize,
    pixels: Vec<[f32; 3]>,
}

impl Picture {
    /// Creates a picture from its pixels, row by row.
    ///
    /// # Errors
    /// If a side is not in 1..=[`MAX_SIDE_PX`], or the pixels don't fill the sides.
    pub fn new(width_px: usize, height_px: usize, pixels: Vec<[f32; 3]>) -> Result<Self> {
        check_sides(width_px, height_px, pixels.len())?;
        Ok(Self { width_px, pixels })
    }

    /// Creates a picture from a function of x and y (in px, from the upper left), on all threads.
    ///
    /// # Errors
    /// If a side is not in 1..=[`MAX_SIDE_PX`].
    pub fn from_fn(
        width_px: usize,
        height_px: usize,
        colour: impl Fn(usize, usize) -> [f32; 3] + Sync,
    ) -> Result<Self> {
        check_sides(width_px, height_px, width_px.saturating_mul(height_px))?;
        let row = |y| (0..width_px).map(|x| colour(x, y)).collect::<Vec<_>>();
        let pixels = (0..height_px).into_par_iter().flat_map_iter(row).collect();
        Ok(Self { width_px, pixels })
    }

    /// Pixels in a row.
    #[must_use]
    pub fn width_px(&self) -> usize {
        self.width_px
    }

    /// Rows.
    #[must_use]
    pub fn height_px(&self) -> usize {
        self.pixels.len() / self.width_px
    }

    /// All pixels, row by row.
    #[must_use]
    pub fn pixels(&self) -> &[[f32; 3]] {
        &self.pixels
    }

    /// The picture for display: clamped to 0..1, encoded with the transfer function of IEC
    /// 61966-2-1 and rounded to the nearest code. Pixels with a NaN become [`NAN_COLOUR`].
    #[must_use]
    pub fn to_srgb8(&self) -> Srgb8 {
        let codes = self.pixels.par_iter().map(|pixel| encode(*pixel)).collect();
        Srgb8 { width_px: self.width_px, codes }
    }

    /// Writes [`to_srgb8`](Self::to_srgb8) as PNG, completely or not at all.
    ///
    /// # Errors
    /// If the file can't be written.
    pub fn save_png(&self, path: &Path) -> Result<()> {
        self.to_srgb8().save_png(path)
    }
}

/// A picture of 8-bit sRGB codes: red, green and blue, 0..=255.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Srgb8 {
    pub(super) width_px: usize,
    pub(super) codes: Vec<[u8; 3]>,
}

impl Srgb8 {
    /// Creates a picture from its codes, row by row.
    ///
    /// # Errors
    /// If a side is not in 1..=[`MAX_SIDE_PX`], or the codes don't fill the sides.
    pub fn new(width_px: usize, height_px: usize, codes: Vec<[u8; 3]>) -> Result<Self> {
        check_sides(width_px, height_px, codes.len())?;
        Ok(Self { width_px, codes })
    }

    /// Pixels in a row.
    #[must_use]
    pub fn width_px(&self) -> usize {
        self.width_px
    }

    /// Rows.
    #[must_use]
    pub fn height_px(&self) -> usize {
        self.codes.len() / self.width_px
    }

    /// All codes, row by row.
    #[must_use]
    pub fn codes(&self) -> &[[u8; 3]] {
        &self.codes
    }

    /// The picture in linear light; [`Picture::to_srgb8`] returns the same codes.
    #[must_use]
    pub fn to_linear(&self) -> Picture {
        let decode = |codes: &[u8; 3]| codes.map(|code| cast::f32_of(linear(code)));
        Picture { width_px: self.width_px, pixels: self.codes.par_iter().map(decode).collect() }
    }

    /// Writes the picture as PNG, completely or not at all. The file declares sRGB, so that
    /// colour-managed viewers and tools interpret its codes correctly.
    ///
    /// # Errors
    /// If the file can't be written.
    pub fn save_png(&self, path: &Path) -> Result<()> {
        let (width, height) = (side(self.width_px), side(self.height_px()));
        output::write_file(path, |to| {
            let write = || {
                let mut encoder = png::Encoder::new(to, width, height);
                encoder.set_color(png::ColorType::Rgb);
                encoder.set_depth(png::BitDepth::Eight);
                encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
                // The same for programs that don't know the sRGB chunk, as the PNG specification
                // recommends.
                encoder.set_source_gamma(png::ScaledFloat::from_scaled(45_455));
                encoder.set_source_chromaticities(png::SourceChromaticities::new(
                    (0.3127, 0.329),
                    (0.64, 0.33),
                    (0.3, 0.6),
                    (0.15, 0.06),
                ));
                let mut writer = encoder.write_header()?;
                writer.write_image_data(self.codes.as_flattened())?;
                writer.finish()
            };
            write().map_err(|why: png::EncodingError| {
                if let png::EncodingError::IoError(why) = why {
                    output::at(path)(why)
                } else {
                    Error::file(path, why.to_string())
                }
            })
        })
    }
}

/// A side in the encoder's type.
fn side(px: usize) -> u32 {
    u32::try_from(px).expect("bug: a side was not checked")
}

fn check_sides(width_px: usize, height_px: usize, pixels: usize) -> Result<()> {
    let legal = 1..=MAX_SIDE_PX;
    if !legal.contains(&width_px) || !legal.contains(&height_px) {
        return Err(Error::usage(format!(
            "a picture of {width_px} x {height_px} px: legal are sides of 1 to {MAX_SIDE_PX} px"
        )));
    }
    if width_px * height_px != pixels {
        return Err(Error::usage(format!(
            "a picture of {width_px} x {height_px} px has {} pixels and {pixels} were given",
            width_px * height_px
        )));
    }
    Ok(())
}

/// Linear light of each code.
static LINEAR: LazyLock<[f64; 256]> =
    LazyLock::new(|| array::from_fn(|code| from_srgb(cast::f64_of_len(code) / 255.0)));

/// Linear light halfway between each code and the next.
static THRESHOLDS: LazyLock<[f64; 255]> =
    LazyLock::new(|| array::from_fn(|code| from_srgb((cast::f64_of_len(code) + 0.5) / 255.0)));

pub(super) fn linear(code: u8) -> f64 {
    LINEAR[usize::from(code)]
}

pub(super) fn encode(pixel: [f32; 3]) -> [u8; 3] {
    if pixel.iter().any(|value| value.is_nan()) {
        return NAN_COLOUR;
    }
    // The nearest code is the number of thresholds at or below the value: needs no inverse and no
    // rounding.
    pixel.map(|value| {
        let code = THRESHOLDS.partition_point(|threshold| *threshold <= f64::from(value));
        u8::try_from(code).expect("bug: more than 255 thresholds")
    })
}
