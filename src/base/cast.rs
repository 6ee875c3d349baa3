//! The only module with lossy number conversions.
//!
//! Each function says what is lost. Everywhere else clippy's cast lints forbid such casts. Lossless
//! conversions use `From` where they occur.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss
)]

/// Nearest `f64` to a word; exact below 2^53.
#[inline(always)]
pub(crate) fn f64_of(raw: i64) -> f64 {
    raw as f64
}

/// Nearest `f64` to a count; exact below 2^53.
#[inline(always)]
pub(crate) fn f64_of_count(count: u64) -> f64 {
    count as f64
}

/// Nearest `f64` to a length; exact below 2^53.
#[inline(always)]
pub(crate) fn f64_of_len(len: usize) -> f64 {
    len as f64
}

/// Nearest `f32` to a real.
#[inline(always)]
pub(crate) fn f32_of(x: f64) -> f32 {
    x as f32
}

/// Whole part of a real, kept inside `i128`; NaN gives 0.
#[inline(always)]
pub(crate) fn i128_of(x: f64) -> i128 {
    x as i128
}

/// Whole part of a real, kept inside `i64`; NaN gives 0.
#[inline(always)]
pub(crate) fn i64_of(x: f64) -> i64 {
    x as i64
}

/// Whole part of a real, kept inside `usize`; NaN and negative numbers give 0.
#[inline(always)]
pub(crate) fn usize_of(x: f64) -> usize {
    x as usize
}

/// The low 64 bits of a wide word, as a word.
#[inline(always)]
pub(crate) fn low_i64(wide: i128) -> i64 {
    wide as i64
}

/// The low 32 bits of a word, as a narrow lane.
#[inline(always)]
pub(crate) fn low_i32(raw: i64) -> i32 {
    raw as i32
}

/// The low 32 bits of a node index (the arena refuses to grow past that), or of a short run's
/// length.
#[inline(always)]
pub(crate) fn id_of(index: usize) -> u32 {
    index as u32
}

/// A word that is known not to be negative, as an index.
#[inline(always)]
pub(crate) fn index_of(raw: i64) -> usize {
    debug_assert!(raw >= 0, "bug: negative index {raw}");
    raw as usize
}

/// A small number as an index; lossless where addresses have 32 bits or more.
#[inline(always)]
pub(crate) fn index_of_u32(number: u32) -> usize {
    number as usize
}

/// The bit pattern of a word.
#[inline(always)]
pub(crate) fn bits_of(raw: i64) -> u64 {
    raw as u64
}

/// The word with this bit pattern.
#[inline(always)]
pub(crate) fn word_of_bits(bits: u64) -> i64 {
    bits as i64
}

/// The bit pattern of a wide number.
#[inline(always)]
pub(crate) fn pattern_of(wide: i128) -> u128 {
    wide as u128
}

/// A difference of bit counts (all below 2^31), signed.
#[inline(always)]
pub(crate) fn signed_count(count: u32) -> i32 {
    count as i32
}

/// A length as a count.
#[inline(always)]
pub(crate) fn count_of(len: usize) -> u64 {
    len as u64
}

/// Nearest pixel to a real, kept inside `i32`; NaN gives 0.
#[inline(always)]
pub(crate) fn pixel_of(x: f64) -> i32 {
    x.round() as i32
}

/// The low 16 bits of a word, as a narrow lane.
#[inline(always)]
pub(crate) fn low_i16(raw: i64) -> i16 {
    raw as i16
}

/// The bit pattern of a 16-bit lane.
#[inline(always)]
pub(crate) fn pattern_of_i16(lane: i16) -> u16 {
    lane as u16
}

/// The bit pattern of a 32-bit lane.
#[inline(always)]
pub(crate) fn pattern_of_i32(lane: i32) -> u32 {
    lane as u32
}

/// The low bits of a pattern as an index; lossless where addresses have 64 bits.
#[inline(always)]
pub(crate) fn index_of_bits(bits: u64) -> usize {
    bits as usize
}

/// The low 16 bits of a word, as a pattern.
#[inline(always)]
pub(crate) fn low_u16(raw: i64) -> u16 {
    raw as u16
}
