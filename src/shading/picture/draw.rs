//! Draws pictures, scales and text on white sheets.

use super::pixels::{MAX_SIDE_PX, Srgb8};
use crate::base::cast;
use crate::base::error::{Error, Result};
use noto_sans_mono_bitmap::{FontWeight, RasterHeight, get_raster, get_raster_width};

/// Font of all text.
const WEIGHT: FontWeight = FontWeight::Regular;
const HEIGHT: RasterHeight = RasterHeight::Size16;
/// Height of a line of text.
pub(super) const LINE_PX: usize = 16;
/// Gap between items, and margin around all.
pub(super) const GAP_PX: usize = 8;

const PAPER: [u8; 3] = [255; 3];
const INK: u8 = 30;
/// Colour of frames around items that may be white at their edges.
const FRAME: [u8; 3] = [150; 3];

/// Width of a line of text.
pub(super) fn text_width(text: &str) -> usize {
    text.chars().count() * get_raster_width(WEIGHT, HEIGHT)
}

/// A white sheet to draw on.
pub(super) struct Canvas {
    width: usize,
    codes: Vec<[u8; 3]>,
}

impl Canvas {
    /// # Errors
    /// If a side is longer than [`MAX_SIDE_PX`].
    pub(super) fn new(width: usize, height: usize) -> Result<Self> {
        if width.max(height) > MAX_SIDE_PX {
            return Err(Error::usage(format!(
                "a sheet of {width} x {height} px: legal are sides of at most {MAX_SIDE_PX} px"
            )));
        }
        Ok(Self { width, codes: vec![PAPER; width * height] })
    }

    /// Fills a rectangle; `colour` gets x and y from its upper left.
    pub(super) fn fill(
        &mut self,
        (left, top): (usize, usize),
        (width, height): (usize, usize),
        colour: impl Fn(usize, usize) -> [u8; 3],
    ) {
        for y in 0..height {
            for x in 0..width {
                self.codes[(top + y) * self.width + left + x] = colour(x, y);
            }
        }
    }

    /// Draws a thin frame around a rectangle, then fills it.
    pub(super) fn framed(
        &mut self,
        (left, top): (usize, usize),
        (width, height): (usize, usize),
        colour: impl Fn(usize, usize) -> [u8; 3],
    ) {
        self.fill((left - 1, top - 1), (width + 2, height + 2), |_, _| FRAME);
        self.fill((left, top), (width, height), colour);
    }

    /// Draws a picture.
    pub(super) fn picture(&mut self, corner: (usize, usize), picture: &Srgb8) {
        let size = (picture.width_px(), picture.height_px());
        self.fill(corner, size, |x, y| picture.codes[y * size.0 + x]);
    }

    /// Writes a line; characters that the font lacks become question marks.
    pub(super) fn text(&mut self, (left, top): (usize, usize), text: &str) {
        for (i, c) in text.chars().enumerate() {
            let raster = get_raster(c, WEIGHT, HEIGHT)
                .or_else(|| get_raster('?', WEIGHT, HEIGHT))
                .expect("bug: a font without question mark");
            let left = left + i * raster.width();
            self.fill((left, top), (raster.width(), raster.height()), |x, y| {
                let ink = f64::from(raster.pixel(x, y).unwrap_or(0)) / 255.0;
                [code(255.0 + ink * (f64::from(INK) - 255.0)); 3]
            });
        }
    }

    pub(super) fn done(self) -> Srgb8 {
        Srgb8 { width_px: self.width, codes: self.codes }
    }
}

/// Rounds to the nearest code.
pub(super) fn code(x: f64) -> u8 {
    u8::try_from(cast::i64_of(x.round()).clamp(0, 255)).expect("bug: clamped to a byte")
}

/// A picture of a [`sheet`] and its caption.
#[derive(Clone, Copy, Debug)]
pub struct Panel<'a> {
    /// One line below the picture; letters outside Latin-1 become question marks.
    pub caption: &'a str,
    /// The picture.
    pub picture: &'a Srgb8,
}

/// Puts pictures side by side, `columns` in a row, each with its caption below it. All cells have
/// the size of the largest picture and the longest caption, so that equal pictures line up.
///
/// # Errors
/// If there are no panels or no columns, or the sheet is larger than a picture may be.
pub fn sheet(panels: &[Panel<'_>], columns: usize) -> Result<Srgb8> {
    if panels.is_empty() || columns == 0 {
        return Err(Error::usage(format!(
            "a sheet of {} pictures in {columns} columns: give at least one of each",
            panels.len()
        )));
    }
    let columns = columns.min(panels.len());
    let most = |size: &dyn Fn(&Panel<'_>) -> usize| panels.iter().map(size).max().unwrap_or(0);
    let width = most(&|panel| panel.picture.width_px().max(text_width(panel.caption)));
    let height = most(&|panel| panel.picture.height_px());
    let across = width + 2 * GAP_PX;
    let down = height + LINE_PX + 2 * GAP_PX;
    let rows = panels.len().div_ceil(columns);
    let mut canvas = Canvas::new(columns * across, rows * down + GAP_PX)?;
    for (i, panel) in panels.iter().enumerate() {
        let (left, top) = (i % columns * across + GAP_PX, i / columns * down + GAP_PX);
        canvas.picture((left, top), panel.picture);
        canvas.text((left, top + height + GAP_PX / 2), panel.caption);
    }
    Ok(canvas.done())
}
