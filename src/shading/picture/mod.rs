//! Pictures in linear light, their PNG files, and how far one is from another.
//!
//! ```text
//! Picture (linear, f32) ──► Difference: linear light, 8-bit codes, SSIM, FLIP
//!    │       │
//!    │       └──► absolute_map, signed_map ──┐
//!    └─ to_srgb8 ──► Srgb8 ──────────────────┴──► sheet ──► Srgb8 ──► save_png
//! ```
//!
//! A [`Picture`] is what was computed; an [`Srgb8`] is what can be seen and stored. Figures in
//! linear light are of the pictures; SSIM and FLIP are of their 8-bit codes, so that any outside
//! tool finds the same from the PNG files. Nothing depends on the number of threads.
//!
//! A pixel that is not a number is never passed over: [`to_srgb8`](Picture::to_srgb8) draws it in
//! magenta, and every figure of a [`Difference`] is NaN or the worst that it can be.

mod compare;
mod draw;
mod filter;
mod flip;
mod maps;
mod pixels;
mod ssim;
#[cfg(test)]
mod tests;

pub use compare::{Channel, ChannelDifference, Difference, Extreme, PIXELS_PER_DEGREE, coverage};
pub(crate) use compare::{check_pixels_per_degree, nothing_in_view};
pub use draw::{Panel, sheet};
pub use maps::{Amplify, absolute_map, signed_map};
pub use pixels::{MAX_SIDE_PX, NAN_COLOUR, Picture, Srgb8};
