//! What callers' columns may hold.

use crate::base::cast;

/// A number that callers' columns hold.
pub trait Word: Copy + Default + Send + Sync {
    /// The word, of which the low bits count.
    fn word(self) -> i64;
    /// The low bits of a word.
    fn of_word(word: i64) -> Self;
}

impl Word for i64 {
    #[inline(always)]
    fn word(self) -> i64 {
        self
    }
    #[inline(always)]
    fn of_word(word: i64) -> Self {
        word
    }
}

impl Word for i32 {
    #[inline(always)]
    fn word(self) -> i64 {
        i64::from(self)
    }
    #[inline(always)]
    fn of_word(word: i64) -> Self {
        cast::low_i32(word)
    }
}

impl Word for u16 {
    #[inline(always)]
    fn word(self) -> i64 {
        i64::from(self)
    }
    #[inline(always)]
    fn of_word(word: i64) -> Self {
        cast::low_u16(word)
    }
}
