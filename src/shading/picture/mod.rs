//! Pictures in linear light, their PNG files, and the differences between them.
//!
//! ```text
//! Picture (linear, f32) ──► Difference: linear light, 8-bit codes, SSIM, FLIP
//!    │       │
//!    │       └──► absolute_map, signed_map ──┐
//!    └─ to_srgb8 ──► Srgb8 ──────────────────┴──► sheet ──► Srgb8 ──► save_png
//! ```
//!
//! A [`Picture`] holds computed values; an [`Srgb8`] holds 8-bit codes for display and storage.
//! Differences in linear light are computed from pictures. SSIM and FLIP are computed from their
//! 8-bit codes, so any other tool finds the same from the PNG files. Results don't depend on the
//! number of threads. The *golden* picture is the reference: computed by the same function in
//! double precision.
//!
//! A NaN pixel is never ignored: [`to_srgb8`](Picture::to_srgb8) draws it in magenta, and every
//! figure of a [`Difference`] is NaN or its worst value.

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
