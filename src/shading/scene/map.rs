//! Maps over surfaces: colours and heights, from image files or generated.

use super::jpeg;
use super::procedural::Samples;
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::input;
use crate::shading::srgb::from_srgb;
use glam::DVec3;
use image::{DynamicImage, ImageBuffer, ImageDecoder, ImageFormat, ImageReader, Rgb};
use std::io::Cursor;
use std::path::Path;

/// Largest side of a map, in texels.
pub(super) const MAX_SIDE: u32 = 8192;
/// The most texels of a map.
const MAX_TEXELS: u64 = 1 << 25;
/// The most texels of a map whose bump vectors are stored (96 MiB): each is read often, by pixels
/// and lights.
const MAX_VECTORS: usize = 1 << 22;
/// The largest difference between the channels of a grey picture, of 65535: JPEG stores colour
/// coarsely, and conversions average inexactly.
const GREY: u16 = 16 * 257;
/// Largest file that a scene may name, in bytes.
pub(super) const MAX_BYTES: u64 = 1 << 28;

/// Colours over a surface, in linear light.
#[derive(Clone, Debug)]
pub struct Texture {
    size: Size,
    texels: Vec<[f32; 3]>,
}

/// Bump vectors over a surface, computed from heights.
#[derive(Clone, Debug)]
pub struct Bumps {
    size: Size,
    heights: Vec<f64>,
    scale: f64,
    /// By texel index; empty for a map above [`MAX_VECTORS`].
    vectors: Vec<DVec3>,
    flat: bool,
}

/// Columns and rows of a map.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Size {
    width: u32,
    height: u32,
}

impl Size {
    /// Index of the texel at (u, v).
    #[inline]
    fn texel(self, u: f64, v: f64) -> u32 {
        let along = |x: f64, side: u32| {
            // Far out, where floats have no fraction, the column hardly matters; nothing overflows.
            cast::i64_of((x * f64::from(side)).floor()).rem_euclid(i64::from(side))
        };
        let index = along(1.0 - v, self.height) * i64::from(self.width) + along(u, self.width);
        cast::id_of(cast::index_of(index))
    }

    fn len(self) -> usize {
        cast::index_of_u32(self.width) * cast::index_of_u32(self.height)
    }
}

impl Texture {
    /// A single linear colour.
    #[must_use]
    pub(super) fn constant(color: [f64; 3], width: u32, height: u32) -> Self {
        let size = Size { width, height };
        Self { size, texels: vec![color.map(cast::f32_of); size.len()] }
    }

    pub(super) fn made(samples: &Samples) -> Self {
        let size = Size { width: samples.width, height: samples.height };
        let texels = samples.texels.iter().map(|sample| sample.color.map(cast::f32_of));
        Self { size, texels: texels.collect() }
    }

    pub(super) fn open(path: &Path) -> Result<Self> {
        let (size, image) = open_image(path)?;
        // For 8-bit files k/255 becomes 257 k/65535, which is the same number.
        let linear: Vec<f32> = (0..=u16::MAX)
            .map(|code| cast::f32_of(from_srgb(f64::from(code) / f64::from(u16::MAX))))
            .collect();
        let image = image.into_rgb16();
        let texels = image.pixels().map(|pixel| pixel.0.map(|code| linear[usize::from(code)]));
        Ok(Self { size, texels: texels.collect() })
    }

    /// Columns and rows.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (self.size.width, self.size.height)
    }

    /// True if it has only one colour.
    pub(super) fn is_even(&self) -> bool {
        self.texels.iter().all(|texel| *texel == self.texels[0])
    }

    /// Colours by texel index: linear RGB, 0 to 1.
    #[must_use]
    pub fn texels(&self) -> &[[f32; 3]] {
        &self.texels
    }

    /// Index of the texel at (u, v).
    #[inline]
    #[must_use]
    pub fn texel(&self, u: f64, v: f64) -> u32 {
        self.size.texel(u, v)
    }
}

impl Bumps {
    pub(super) fn constant(width: u32, height: u32) -> Self {
        let size = Size { width, height };
        Self::new(size, vec![0.0; size.len()], 0.0)
    }

    pub(super) fn made(samples: &Samples, scale: f64) -> Self {
        let size = Size { width: samples.width, height: samples.height };
        Self::new(size, samples.texels.iter().map(|sample| sample.height).collect(), scale)
    }

    /// Grey values of a file as stored; for nearly grey colours, 0.2126 R + 0.7152 G + 0.0722 B.
    pub(super) fn open(path: &Path, scale: f64) -> Result<Self> {
        let (size, image) = open_image(path)?;
        let heights = if image.color().has_color() {
            let luma = |[r, g, b]: [u16; 3]| 0.2126 * unit(r) + 0.7152 * unit(g) + 0.0722 * unit(b);
            let image = image.into_rgb16();
            check_grey(&image).map_err(|problem| Error::file(path, problem))?;
            image.pixels().map(|pixel| luma(pixel.0)).collect()
        } else {
            image.into_luma16().pixels().map(|pixel| unit(pixel.0[0])).collect()
        };
        Ok(Self::new(size, heights, scale))
    }

    fn new(size: Size, heights: Vec<f64>, scale: f64) -> Self {
        let mut bumps = Self { size, heights, scale, vectors: Vec::new(), flat: false };
        if size.len() <= MAX_VECTORS {
            bumps.vectors = (0..bumps.len()).map(|texel| bumps.converted(texel)).collect();
        }
        bumps.flat = (0..bumps.len()).all(|texel| bumps.vector(texel) == DVec3::Z);
        bumps
    }

    /// Columns and rows.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (self.size.width, self.size.height)
    }

    /// Number of texels.
    #[expect(clippy::len_without_is_empty, reason = "a map has at least one texel")]
    #[must_use]
    pub fn len(&self) -> u32 {
        self.size.width * self.size.height
    }

    /// True if every bump vector is (0, 0, 1).
    #[must_use]
    pub fn is_flat(&self) -> bool {
        self.flat
    }

    /// Heights by texel index, 0 to 1.
    #[must_use]
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Height in texels of a difference of 1.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// The bump vector of a texel by index: a unit vector along (T, B, N). Maps of up to 2^22
    /// texels store all their vectors; for a larger map each call costs a few additions and a
    /// square root.
    ///
    /// # Panics
    /// If there is no such texel.
    #[inline]
    #[must_use]
    pub fn vector(&self, texel: u32) -> DVec3 {
        if self.vectors.is_empty() {
            self.converted(texel)
        } else {
            self.vectors[cast::index_of_u32(texel)]
        }
    }

    fn converted(&self, texel: u32) -> DVec3 {
        let Size { width, height } = self.size;
        let (x, y) = (texel % width, texel / width);
        let at = |x: u32, y: u32| self.heights[cast::index_of_u32(y * width + x)];
        let (left, right) = ((x + width - 1) % width, (x + 1) % width);
        let (above, below) = ((y + height - 1) % height, (y + 1) % height);
        let du = 0.5 * self.scale * (at(right, y) - at(left, y));
        let dv = 0.5 * self.scale * (at(x, above) - at(x, below));
        DVec3::new(0.0 - du, 0.0 - dv, 1.0).normalize()
    }

    /// Index of the texel at (u, v).
    #[inline]
    #[must_use]
    pub fn texel(&self, u: f64, v: f64) -> u32 {
        self.size.texel(u, v)
    }
}

/// The contents of a file that a scene names.
pub(super) fn read_file(path: &Path) -> Result<Vec<u8>> {
    input::read(input::open_regular(path)?, path, MAX_BYTES)
}

/// The contents of a file; `None` if it has more than `max_bytes` bytes.
pub(super) fn read_up_to(path: &Path, max_bytes: u64) -> Result<Option<Vec<u8>>> {
    input::read_up_to(input::open_regular(path)?, path, max_bytes)
}

/// The fraction of 1 that a channel's code stands for.
fn unit(code: u16) -> f64 {
    f64::from(code) / f64::from(u16::MAX)
}

/// Rejects colours, which don't encode heights.
fn check_grey(image: &ImageBuffer<Rgb<u16>, Vec<u16>>) -> Result<(), String> {
    let spread = |[r, g, b]: [u16; 3]| r.max(g).max(b) - r.min(g).min(b);
    let most = image.enumerate_pixels().max_by_key(|(.., pixel)| spread(pixel.0));
    let Some((x, y, colour)) = most.filter(|(.., pixel)| spread(pixel.0) > GREY) else {
        return Ok(());
    };
    let texel = format!("texel ({x}, {y}) is {:?} of 255", colour.0.map(|code| code / 257));
    // In a normal map, almost all texels are unit vectors that point upwards.
    let is_normal = |pixel: &&Rgb<u16>| {
        let normal = DVec3::from_array(pixel.0.map(|code| 2.0 * unit(code) - 1.0));
        (0.9..1.1).contains(&normal.length()) && normal.z > 0.0
    };
    let normals = image.pixels().filter(is_normal).count();
    Err(if 10 * normals > 9 * image.pixels().len() {
        format!(
            "is a tangent-space normal map ({texel}), but [height] needs heights: give the height or displacement map from which it was baked"
        )
    } else {
        format!(
            "has colours ({texel}), but [height] needs heights: grey values whose channels differ by at most {}. Give a height map, or save it as greyscale if bright means high",
            GREY / 257
        )
    })
}

/// Decodes an image after checking the size in its header, and applies its EXIF orientation.
fn open_image(path: &Path) -> Result<(Size, DynamicImage)> {
    let bytes = read_file(path)?;
    let fail = |why: image::ImageError| {
        let why = why.to_string();
        Error::file(path, format!("can't be decoded as PNG or JPEG: {}", why.trim_end()))
    };
    let check =
        |(width, height)| check_size(width, height).map_err(|problem| Error::file(path, problem));
    png_size(&bytes).map_or(Ok(()), check)?;
    let reader = ImageReader::new(Cursor::new(&bytes)).with_guessed_format();
    let reader = reader.map_err(|why| Error::io(path, "can't read", why))?;
    let is_jpeg = reader.format() == Some(ImageFormat::Jpeg);
    let mut decoder = reader.into_decoder().map_err(fail)?;
    check(decoder.dimensions())?;
    if is_jpeg {
        jpeg::check(&bytes).map_err(|problem| Error::file(path, problem))?;
    }
    let orientation = decoder.orientation().map_err(fail)?;
    let mut image = DynamicImage::from_decoder(decoder).map_err(fail)?;
    image.apply_orientation(orientation);
    Ok((Size { width: image.width(), height: image.height() }, image))
}

/// Width and height in the header of a PNG file. The decoder reports them only if data follow.
fn png_size(bytes: &[u8]) -> Option<(u32, u32)> {
    let header = bytes.strip_prefix(b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR")?;
    let (width, rest) = header.split_first_chunk()?;
    let (height, _) = rest.split_first_chunk()?;
    Some((u32::from_be_bytes(*width), u32::from_be_bytes(*height)))
}

/// Checks the size of a map.
pub(super) fn check_size(width: u32, height: u32) -> Result<(), String> {
    let texels = u64::from(width) * u64::from(height);
    if width.max(height) > MAX_SIDE || texels > MAX_TEXELS || texels == 0 {
        return Err(format!(
            "the map has {width} x {height} texels: legal are sides of 1 to {MAX_SIDE} and at most {MAX_TEXELS} texels; scale it down"
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::procedural::Pattern;
    use super::*;

    #[test]
    fn texels_are_those_of_the_convention() {
        let size = Size { width: 4, height: 2 };
        for (u, v, texel) in [
            (0.0, 1.0, 0),
            (0.25, 1.0, 1),
            (0.999, 0.75, 3),
            (0.0, 0.5, 4),
            (0.0, 0.25, 4),
            (1.0, 0.25, 4),   // wraps to the left
            (-0.01, 0.25, 7), // and to the right
            (0.0, 0.0, 0),    // the lower edge wraps to the upper one
            (0.0, 1.2, 4),
            (1e300, -1e300, 3), // no panic; texel of the largest integer
        ] {
            let found = size.texel(u, v);
            assert!(found < 8);
            if u < 1e300 {
                assert_eq!(found, texel, "{u} {v}");
            }
        }
        assert_eq!(Size { width: 1, height: 1 }.texel(0.3, 0.7), 0);
    }

    #[test]
    fn slopes_are_in_texels() {
        // A ramp that falls by 1/8 per texel to the right and rises by 1/8 per row downwards.
        let heights: Vec<f64> =
            (0..16).map(|i| 0.125 * f64::from(i / 4) - 0.125 * f64::from(i % 4) + 0.5).collect();
        let bumps = Bumps::new(Size { width: 4, height: 4 }, heights, 2.0);
        let n = bumps.vector(5);
        // dh/du = -0.25 and dh/dv = -0.25 with scale 2, v upwards.
        let expected = DVec3::new(0.25, 0.25, 1.0) / 1.125f64.sqrt();
        assert!((n - expected).length() < 1e-15, "{n}");
        assert!(!bumps.is_flat());
        // At the left border the neighbour is the last column.
        let n = bumps.vector(4);
        let du = 2.0 * (-0.125 - -0.375) / 2.0;
        assert!((n.x / n.z + du).abs() < 1e-15, "{n}");
        assert_eq!(bumps.len(), 16);
    }

    #[test]
    fn stored_vectors_are_those_of_the_heights() {
        let bumps = Bumps::made(&Pattern::Brick.over(64, 32), 3.7);
        assert_eq!(bumps.vectors.len(), 64 * 32);
        let large = Bumps { vectors: Vec::new(), ..bumps.clone() };
        for texel in 0..bumps.len() {
            let [stored, converted] = [&bumps, &large].map(|map| map.vector(texel).to_array());
            assert_eq!(stored.map(f64::to_bits), converted.map(f64::to_bits), "{texel}");
        }
        let size = Size { width: 4097, height: 1024 };
        let large = Bumps::new(size, vec![0.5; size.len()], 1.0);
        assert!(large.vectors.is_empty() && large.is_flat());
    }

    #[test]
    fn a_constant_height_is_straight_up_everywhere() {
        for (width, height) in [(1, 1), (2, 1), (5, 3)] {
            let size = Size { width, height };
            let bumps = Bumps::new(size, vec![0.7; size.len()], 1e6);
            assert!(bumps.is_flat());
            for texel in 0..bumps.len() {
                assert_eq!(bumps.vector(texel), DVec3::Z);
            }
        }
        // No scale, no bumps.
        assert!(Bumps::made(&Pattern::Brick.over(16, 16), 0.0).is_flat());
    }
}
