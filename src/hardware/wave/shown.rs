//! A variable of bits: its declaration and its latest value.

use super::text::{Code, Lines};
use crate::base::cast;
use crate::number::format::Format;
use std::io;
use vcd::{IdCode, ReferenceIndex};

/// Latest value of a variable: its pattern, or one of these, which aren't patterns.
const NOTHING: u64 = u64::MAX;
pub(super) const UNKNOWN: u64 = u64::MAX - 1;

/// A variable of bits, and its latest value.
pub(super) struct Shown {
    code: Code,
    bits: u32,
    last: u64,
}

impl Shown {
    pub(super) fn new(code: IdCode, bits: u32) -> Self {
        Self { code: code.into(), bits, last: NOTHING }
    }

    /// Writes a pattern if it has changed.
    #[inline(always)]
    pub(super) fn change(&mut self, lines: &mut Lines<'_>, now: u64) -> io::Result<()> {
        if self.last == now {
            return Ok(());
        }
        self.last = now;
        lines.word((now != UNKNOWN).then_some(now), self.bits, &self.code)
    }
}

pub(super) fn top_index(format: Format) -> i32 {
    cast::signed_count(format.bits()) - format.frac_bits() - 1
}

/// Range of a word's bit indices, with the binary point below index 0; `None` for one bit.
pub(super) fn index_range(format: Format) -> Option<ReferenceIndex> {
    let range = ReferenceIndex::Range(top_index(format), -format.frac_bits());
    (format.bits() > 1).then_some(range)
}
