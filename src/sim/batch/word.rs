//! The number types of callers' columns.

use crate::base::cast;
use crate::number::format::Format;

/// A number type of callers' columns.
pub trait Word: Copy + Default + Send + Sync {
    /// The least and the greatest number.
    const RANGE: (i64, i64);
    /// The number as a word.
    fn word(self) -> i64;
    /// The low bits of a word.
    fn of_word(word: i64) -> Self;
    /// `seen`, with the bits of the wrapping distance from `low` set as well.
    fn distance(self, low: Self, seen: Self) -> Self;
    /// The number as a bit pattern.
    fn pattern(self) -> u64;
}

macro_rules! words {
    ($($number:ty, $unsigned:ty, $low:path, $min:literal, $max:literal;)*) => {$(
        impl Word for $number {
            const RANGE: (i64, i64) = ($min, $max);

            #[inline(always)]
            fn word(self) -> i64 {
                i64::from(self)
            }
            #[inline(always)]
            fn of_word(word: i64) -> Self {
                $low(word)
            }
            #[inline(always)]
            fn distance(self, low: Self, seen: Self) -> Self {
                seen | self.wrapping_sub(low)
            }
            #[inline(always)]
            fn pattern(self) -> u64 {
                u64::from(<$unsigned>::from_ne_bytes(self.to_ne_bytes()))
            }
        }
    )*};
}

words! {
    i64, u64, std::convert::identity, -0x8000_0000_0000_0000, 0x7fff_ffff_ffff_ffff;
    i32, u32, cast::low_i32, -0x8000_0000, 0x7fff_ffff;
    u16, u16, cast::low_u16, 0, 0xffff;
}

/// The words of a format that a number type holds: 2^bits of them, starting at `low`. Because their
/// count is a power of two, the upper bits of the wrapping distance from `low` show whether a word
/// is outside.
#[derive(Clone, Copy)]
pub(super) struct Inside<I> {
    low: I,
    bits: u32,
}

impl<I: Word> Inside<I> {
    pub(super) fn new(format: Format) -> Self {
        let (low, high) = (format.min_raw().max(I::RANGE.0), format.max_raw().min(I::RANGE.1));
        let span = cast::bits_of(high.wrapping_sub(low));
        Self { low: I::of_word(low), bits: span.count_ones() }
    }

    /// Records a word.
    #[inline(always)]
    pub(super) fn see(self, word: I, seen: I) -> I {
        word.distance(self.low, seen)
    }

    /// True if all recorded words belong to the format.
    #[inline(always)]
    pub(super) fn holds(self, seen: I) -> bool {
        seen.pattern().checked_shr(self.bits).unwrap_or(0) == 0
    }
}
