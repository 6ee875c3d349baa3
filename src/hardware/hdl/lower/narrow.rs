//! The logic of a `narrow`: rounding, then limits.

use super::words::Lowering;
use crate::base::cast;
use crate::hardware::hdl::module::{Bit, Expr, Operand, View, WordId};
use crate::number::format::{Format, Narrowing, Overflow, Round, narrow};

impl Lowering {
    /// Rounds to the places of `to`, then applies its limits; each step is a word of its own.
    pub(super) fn narrow(
        &mut self,
        word: WordId,
        a: WordId,
        from: Format,
        to: Format,
        round: Round,
        overflow: Overflow,
    ) -> Expr {
        let hardware = Narrowing::new(from, to, round, overflow);
        let dropped = from.frac_bits() - to.frac_bits();
        let signed = from.is_signed();
        let (whole, whole_bits) = if dropped <= 0 {
            // Appending more zeros than `to` has bits changes neither the overflow nor the low
            // bits.
            let zeros = dropped.unsigned_abs().min(to.bits());
            let bits = from.bits() + zeros;
            if zeros == 0 {
                (a, bits)
            } else {
                let view = Operand::View(View { word: a, lo: 0, zeros, bits });
                (self.helper(word, "wide", bits, signed, Expr::Copy(view)), bits)
            }
        } else {
            // Dropping `from.bits() + 1` places or more gives the same result in every mode.
            let dropped = dropped.unsigned_abs().min(from.bits() + 1);
            if hardware.rounds {
                self.rounded(word, a, from, dropped, round)
            } else {
                let bits = from.bits().saturating_sub(dropped).max(1);
                // If all bits are dropped, the sign remains.
                let lo = dropped.min(from.bits() - 1);
                let view = View { word: a, lo, zeros: 0, bits };
                let kept = if dropped < from.bits() || signed {
                    Operand::View(view)
                } else {
                    Operand::Literal { pattern: 0, bits }
                };
                (self.helper(word, "cut", bits, signed, Expr::Copy(kept)), bits)
            }
        };
        let kept = self.low(whole, whole_bits, to.bits());
        if !hardware.saturates {
            return Expr::Copy(kept);
        }
        let limit =
            |raw: i64| Operand::Literal { pattern: to.pattern(raw).into(), bits: to.bits() };
        let overflows = |raw: i64| narrow(raw, from.frac_bits(), to, round, overflow);
        let magnitude_bits = to.bits() - u32::from(to.is_signed());
        let mut cases = Vec::new();
        if overflows(from.max_raw()).1 {
            let over = Expr::Above { word: whole, keep: magnitude_bits };
            cases.push((self.flag(word, "over", over), limit(to.max_raw())));
        }
        let (least, under) = overflows(from.min_raw());
        if under && from.min_raw() < 0 {
            let symmetric = to.is_signed() && overflow == Overflow::Symmetric;
            let under = if symmetric {
                let bits = whole_bits.max(to.bits());
                let pattern = low_bits(i128::from(least), bits);
                Expr::Less {
                    a: self.resized(whole, bits),
                    b: Operand::Literal { pattern, bits },
                    signed: true,
                }
            } else if to.is_signed() {
                Expr::Below { word: whole, keep: magnitude_bits }
            } else {
                // Any negative number.
                let view = View { word: whole, lo: whole_bits - 1, zeros: 0, bits: 1 };
                Expr::Copy(Operand::View(view))
            };
            cases.push((self.flag(word, "under", under), limit(least)));
        }
        Expr::Choose { cases, default: kept }
    }

    /// The low bits of a word, or the word extended by its sign.
    fn low(&self, word: WordId, have: u32, bits: u32) -> Operand {
        debug_assert_eq!(self.module.word(word).bits, have, "bug: bits of a word");
        Operand::View(View { word, lo: 0, zeros: 0, bits })
    }

    /// `a / 2^dropped`, rounded: an addend below the kept bits carries into them.
    fn rounded(
        &mut self,
        word: WordId,
        a: WordId,
        from: Format,
        dropped: u32,
        round: Round,
    ) -> (WordId, u32) {
        let signed = from.is_signed();
        // One bit more than the longer of word and addend, for the carry.
        let bits = from.bits().max(dropped) + 1;
        let half = 1u128 << (dropped - 1);
        let literal = |pattern: u128| Operand::Literal { pattern, bits };
        let sign = Bit { word: a, bit: from.bits() - 1 };
        let mut choice = |bit: Bit, set: u128, clear: u128| {
            let cases = vec![(bit, literal(set))];
            let chosen = Expr::Choose { cases, default: literal(clear) };
            let addend = self.helper(word, "half", bits, false, chosen);
            self.module.words[addend.index()].frac = from.frac_bits();
            self.resized(addend, bits)
        };
        let addend = match round {
            Round::Floor => unreachable!("bug: floor only cuts"),
            // Negative words are raised by all but one step of the next integer.
            Round::TowardZero => choice(sign, 2 * half - 1, 0),
            Round::HalfAway if signed => choice(sign, half - 1, half),
            Round::HalfUp | Round::HalfAway => literal(half),
            // The last kept bit; the sign if all bits are dropped.
            Round::HalfEven if dropped < from.bits() => {
                choice(Bit { word: a, bit: dropped }, half, half - 1)
            }
            Round::HalfEven if signed => choice(sign, half, half - 1),
            Round::HalfEven => literal(half - 1),
        };
        let a = self.resized(a, bits);
        let sum = self.helper(word, "sum", bits, signed, Expr::Add(a, addend));
        self.module.words[sum.index()].frac = from.frac_bits();
        let kept_bits = bits - dropped;
        let view = View { word: sum, lo: dropped, zeros: 0, bits: kept_bits };
        let kept = Expr::Copy(Operand::View(view));
        (self.helper(word, "cut", kept_bits, signed, kept), kept_bits)
    }
}

/// The low bits of a number, as a pattern.
fn low_bits(number: i128, bits: u32) -> u128 {
    cast::pattern_of(number) & (u128::MAX >> (u128::BITS - bits))
}
