//! Fixed-point formats known at run time, and the one place that rounds.
//!
//! A *word* (raw) is an integer. Its *value* is the real number that it stands for:
//! `value = raw * 2^-frac_bits`. Formats print as `s16f14` (signed, 16 bits in total, 14 of them
//! fraction bits) and `u12f12`; a negative number of fraction bits prints as `u8e2` (8 bits, in
//! steps of 2^2). [`narrow`] is the only place where a datapath rounds, saturates or wraps a
//! number. [`quantize`] converts reals to words.

use crate::base::cast;
use crate::base::error::{Error, Result};
use std::fmt;
use std::str::FromStr;

/// A fixed-point format: sign, total bits and fraction bits.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Format {
    signed: bool,
    bits: u8,
    frac: i8,
}

/// How to round away the bits below the last one that is kept.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Round {
    /// Toward minus infinity: the bits are truncated.
    Floor,
    /// Toward zero.
    TowardZero,
    /// To nearest, ties toward plus infinity: half an ulp is added, then the bits are dropped.
    HalfUp,
    /// To nearest, ties away from zero.
    HalfAway,
    /// To nearest, ties to the even word.
    HalfEven,
}

impl Round {
    /// Largest error of one rounding in ulp.
    #[must_use]
    pub const fn error_ulp(self) -> f64 {
        match self {
            Self::Floor | Self::TowardZero => 1.0,
            Self::HalfUp | Self::HalfAway | Self::HalfEven => 0.5,
        }
    }
}

/// How to handle a value outside the format.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Overflow {
    /// Keep the low bits.
    Wrap,
    /// Clamp to the nearest word of the format.
    Saturate,
    /// As `Saturate`, without the most negative word of a signed format.
    Symmetric,
    /// Keep the low bits, and end the run with an error that names the node.
    Error,
}

macro_rules! named {
    ($type:ident: $($variant:ident = $name:literal),*) => {
        impl $type {
            /// Every mode, in the order of the documentation.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];
            /// The mode's name on the command line and in files.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name),* }
            }
        }
        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result { f.pad(self.name()) }
        }
        impl FromStr for $type {
            type Err = Error;
            fn from_str(text: &str) -> Result<Self> {
                Self::ALL.iter().copied().find(|mode| mode.name() == text).ok_or_else(|| {
                    Error::form(text, concat!($("`", $name, "` "),*).trim_end())
                })
            }
        }
    };
}
named!(Round: Floor = "floor", TowardZero = "toward-zero", HalfUp = "half-up", HalfAway = "half-away", HalfEven = "half-even");
named!(Overflow: Wrap = "wrap", Saturate = "saturate", Symmetric = "symmetric", Error = "error");

/// Number of bits needed to write `x`: 0 for 0, 3 for 4 to 7.
#[must_use]
pub const fn bit_len(x: u64) -> u32 {
    u64::BITS - x.leading_zeros()
}

/// Number of address bits for `entries` entries: 0 for 1, 2 for 3 and 4, 3 for 5.
///
/// # Panics
/// If `entries` is 0.
#[must_use]
pub const fn addr_bits(entries: u64) -> u32 {
    assert!(entries > 0, "bug: a table without entries has no addresses");
    bit_len(entries - 1)
}

impl Format {
    /// Maximum bits of a word.
    pub const MAX_BITS: u32 = 63;

    /// Makes a format of `bits` bits in total, `frac_bits` of them after the binary point.
    ///
    /// # Errors
    /// If `bits` is not in 1 to 63 or `frac_bits` not in -127 to 127.
    pub fn new(signed: bool, bits: u32, frac_bits: i32) -> Result<Self> {
        let frac = i8::try_from(frac_bits)
            .ok()
            .filter(|frac| *frac != i8::MIN)
            .ok_or_else(|| Error::format_frac(frac_bits))?;
        match u8::try_from(bits) {
            Ok(width) if (1..=Self::MAX_BITS).contains(&bits) => {
                Ok(Self { signed, bits: width, frac })
            }
            Ok(_) | Err(_) => Err(Error::format_bits(bits)),
        }
    }

    /// Makes a signed format, as [`Format::new`].
    ///
    /// # Errors
    /// As [`Format::new`].
    pub fn signed(bits: u32, frac_bits: i32) -> Result<Self> {
        Self::new(true, bits, frac_bits)
    }

    /// Makes an unsigned format, as [`Format::new`].
    ///
    /// # Errors
    /// As [`Format::new`].
    pub fn unsigned(bits: u32, frac_bits: i32) -> Result<Self> {
        Self::new(false, bits, frac_bits)
    }

    /// Makes the format of an angle in turns, 0 to 1: all bits are fraction bits.
    ///
    /// # Errors
    /// As [`Format::new`].
    pub fn turns(bits: u32) -> Result<Self> {
        Self::unsigned(bits, cast::signed_count(bits))
    }

    /// Makes the format of an angle in turns, -½ to ½.
    ///
    /// # Errors
    /// As [`Format::new`].
    pub fn signed_turns(bits: u32) -> Result<Self> {
        Self::signed(bits, cast::signed_count(bits))
    }

    /// The format of a flag: one bit, 0 or 1.
    pub const FLAG: Self = Self { signed: false, bits: 1, frac: 0 };

    /// Makes the unsigned format of an integer word of `bits` bits, such as an address.
    ///
    /// # Errors
    /// As [`Format::new`].
    pub fn integer(bits: u32) -> Result<Self> {
        Self::unsigned(bits, 0)
    }

    /// Makes the smallest format with `frac_bits` that holds every word of `lo..=hi`; it is signed
    /// if `lo` is negative.
    ///
    /// # Errors
    /// The number of bits needed, if it is more than 63.
    ///
    /// # Panics
    /// If `lo > hi`, or if `frac_bits` is outside -127 to 127.
    pub fn spanning(lo: i128, hi: i128, frac_bits: i32) -> Result<Self, u32> {
        assert!(lo <= hi, "bug: empty range {lo}..={hi}");
        let magnitude = |x: i128| i128::BITS - if x < 0 { !x } else { x }.leading_zeros();
        let signed = lo < 0;
        let bits = if signed { magnitude(lo).max(magnitude(hi)) + 1 } else { magnitude(hi).max(1) };
        if bits > Self::MAX_BITS {
            return Err(bits);
        }
        Ok(Self::new(signed, bits, frac_bits).expect("bug: fraction bits out of range"))
    }

    /// True if words of this format can be negative.
    #[must_use]
    pub const fn is_signed(self) -> bool {
        self.signed
    }

    /// Total bits, 1 to 63.
    #[must_use]
    pub fn bits(self) -> u32 {
        u32::from(self.bits)
    }

    /// Bits after the binary point; negative if words count in steps of more than one.
    #[must_use]
    pub fn frac_bits(self) -> i32 {
        i32::from(self.frac)
    }

    /// Bits before the binary point, without the sign; can be negative.
    #[must_use]
    pub fn int_bits(self) -> i32 {
        i32::from(self.bits) - i32::from(self.frac) - i32::from(self.signed)
    }

    /// The least word.
    #[must_use]
    pub fn min_raw(self) -> i64 {
        if self.signed { -(1i64 << (self.bits - 1)) } else { 0 }
    }

    /// The greatest word.
    #[must_use]
    pub fn max_raw(self) -> i64 {
        let magnitude_bits = self.bits - u8::from(self.signed);
        word_mask(u32::from(magnitude_bits))
    }

    /// Number of words: 2^bits.
    #[must_use]
    pub fn words(self) -> u64 {
        1 << self.bits
    }

    /// True if `raw` is a word of this format.
    #[must_use]
    pub fn contains(self, raw: i64) -> bool {
        (self.min_raw()..=self.max_raw()).contains(&raw)
    }

    /// Its name, and its smallest and largest word, for messages.
    pub(crate) fn spelled(self) -> (String, i64, i64) {
        (self.to_string(), self.min_raw(), self.max_raw())
    }

    /// Value of one unit in the last place: 2^-frac_bits.
    #[must_use]
    pub fn ulp(self) -> f64 {
        2f64.powi(-i32::from(self.frac))
    }

    /// Nearest `f64` to the value of a word; exact for formats of at most 53 bits.
    #[must_use]
    pub fn value(self, raw: i64) -> f64 {
        cast::f64_of(raw) * self.ulp()
    }

    /// Exact value of a word.
    ///
    /// # Errors
    /// If `raw` is not a word of this format, or its value is not exactly an `f64`.
    pub fn exact_value(self, raw: i64) -> Result<f64> {
        if !self.contains(raw) {
            return Err(Error::word_range(raw, self.to_string(), self.min_raw(), self.max_raw()));
        }
        let magnitude = raw.unsigned_abs();
        let significant_bits =
            bit_len(magnitude) - magnitude.trailing_zeros().min(bit_len(magnitude));
        if significant_bits > f64::MANTISSA_DIGITS {
            return Err(Error::not_exact(raw, self.to_string(), significant_bits));
        }
        Ok(self.value(raw))
    }

    /// The word whose low `bits` bits are those of `raw`.
    #[inline(always)]
    #[must_use]
    pub fn wrap(self, raw: i64) -> i64 {
        if self.signed {
            let above = 64 - u32::from(self.bits);
            raw << above >> above
        } else {
            raw & word_mask(u32::from(self.bits))
        }
    }

    /// The word's bit pattern as an unsigned number of `bits` bits.
    #[must_use]
    pub fn pattern(self, raw: i64) -> u64 {
        cast::bits_of(raw & word_mask(u32::from(self.bits)))
    }
}

/// The word whose low `bits` bits are set; `bits` is at most 63.
pub(crate) const fn word_mask(bits: u32) -> i64 {
    debug_assert!(bits <= 63);
    i64::MAX >> (63 - bits)
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.signed { 's' } else { 'u' };
        let (letter, digits) = if self.frac < 0 { ('e', -self.frac) } else { ('f', self.frac) };
        f.pad(&format!("{sign}{}{letter}{digits}", self.bits))
    }
}

impl FromStr for Format {
    type Err = Error;

    /// Parses `s16f14`, `u8e2`, `sfix16_En14`, `ufix8_E2`, and `sfix16` for an integer.
    fn from_str(text: &str) -> Result<Self> {
        let bad = || Error::format_text(text);
        let (signed, rest) = match text.as_bytes().first() {
            Some(b's') => (true, &text[1..]),
            Some(b'u') => (false, &text[1..]),
            Some(_) | None => return Err(bad()),
        };
        let number = |digits: &str| -> Result<i32> {
            let plain = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
            if plain { digits.parse().map_err(|_| bad()) } else { Err(bad()) }
        };
        let (bits, frac) = if let Some(rest) = rest.strip_prefix("fix") {
            match rest.split_once("_E") {
                None => (number(rest)?, 0),
                Some((bits, exponent)) => match exponent.strip_prefix('n') {
                    Some(frac) => (number(bits)?, number(frac)?),
                    None => (number(bits)?, -number(exponent)?),
                },
            }
        } else if let Some((bits, frac)) = rest.split_once('f') {
            (number(bits)?, number(frac)?)
        } else if let Some((bits, steps)) = rest.split_once('e') {
            (number(bits)?, -number(steps)?)
        } else {
            return Err(bad());
        };
        Self::new(signed, bits.unsigned_abs(), frac)
    }
}

/// Converts a word of `from_frac` fraction bits to format `to`, and reports whether it overflowed.
///
/// This is the only operation that loses bits. `raw` may be any word of up to 64 bits. The word is
/// rounded first; overflow is then judged on the rounded value. Under [`Overflow::Error`] the
/// result is as under [`Overflow::Wrap`], and the caller must check the flag.
#[must_use]
pub fn narrow(
    raw: i64,
    from_frac: i32,
    to: Format,
    round: Round,
    overflow: Overflow,
) -> (i64, bool) {
    fit(rounded(raw, from_frac, to.frac_bits(), round), to, overflow)
}

/// The first half of [`narrow`]: `raw` rounded to a whole number of units of `to_frac` fraction
/// bits. Monotone in `raw`.
pub(crate) fn rounded(raw: i64, from_frac: i32, to_frac: i32, round: Round) -> i128 {
    let dropped_bits = from_frac - to_frac;
    // |raw| <= 2^63. Larger shifts change nothing: every bit is dropped, or all kept bits are 0.
    if dropped_bits > 0 {
        round_shift(i128::from(raw), dropped_bits.unsigned_abs().min(100), round)
    } else {
        i128::from(raw) << dropped_bits.unsigned_abs().min(63) // |rounded| <= 2^126
    }
}

/// `wide / 2^shift` rounded to a whole number.
fn round_shift(wide: i128, shift: u32, round: Round) -> i128 {
    let quotient = wide >> shift;
    let rest = wide & ((1i128 << shift) - 1); // 0 <= rest < 2^shift
    let half = 1i128 << (shift - 1);
    let up = match round {
        Round::Floor => false,
        Round::TowardZero => wide < 0 && rest != 0,
        Round::HalfUp => rest >= half,
        Round::HalfAway => rest > half || (rest == half && wide >= 0),
        Round::HalfEven => rest > half || (rest == half && quotient & 1 == 1),
    };
    quotient + i128::from(up)
}

/// The word of `to` for a whole number of its ulps, and whether it overflowed.
fn fit(whole: i128, to: Format, overflow: Overflow) -> (i64, bool) {
    let hi = to.max_raw();
    let lo = match overflow {
        Overflow::Symmetric if to.signed => -hi,
        Overflow::Symmetric | Overflow::Wrap | Overflow::Saturate | Overflow::Error => to.min_raw(),
    };
    if (i128::from(lo)..=i128::from(hi)).contains(&whole) {
        return (cast::low_i64(whole), false);
    }
    let word = match overflow {
        Overflow::Wrap | Overflow::Error => to.wrap(cast::low_i64(whole)),
        Overflow::Saturate | Overflow::Symmetric => {
            if whole < 0 {
                lo
            } else {
                hi
            }
        }
    };
    (word, true)
}

/// The value of a number in 20-bit floating point: 1 sign bit, 8 exponent bits and the upper 11
/// bits of the mantissa of its nearest `f32`. Lower bits are truncated toward zero. That is 12
/// significant bits with the hidden one; the error is less than 2^-11 of the value.
#[inline(always)]
#[must_use]
pub fn float20(value: f64) -> f64 {
    f64::from(f32::from_bits(cast::f32_of(value).to_bits() & !0xfff))
}

/// Converts a real number to a format, and reports whether it overflowed.
///
/// # Errors
/// If `value` is NaN or infinite, or overflows under [`Overflow::Error`].
pub fn quantize(value: f64, to: Format, round: Round, overflow: Overflow) -> Result<(i64, bool)> {
    if !value.is_finite() {
        return Err(Error::not_finite(value, to.to_string()));
    }
    let (raw, overflowed) = fit(round_real(value, to.frac_bits(), round), to, overflow);
    if overflowed && overflow == Overflow::Error {
        return Err(Error::value_overflow(value.to_string(), to.to_string()));
    }
    Ok((raw, overflowed))
}

/// `value * 2^frac_bits` rounded to a whole number. From 2^126 on it gives ±2^126, whose 63 low
/// bits are zero: it overflows every format in the same way.
fn round_real(value: f64, frac_bits: i32, round: Round) -> i128 {
    let scaled = value * 2f64.powi(frac_bits); // exact, except for subnormal results
    if scaled.abs() >= 2f64.powi(126) {
        return if scaled > 0.0 { 1 << 126 } else { -(1 << 126) };
    }
    if scaled == 0.0 && value != 0.0 {
        // The product underflowed: only directed rounding can tell it from 0.
        return if round == Round::Floor && value < 0.0 { -1 } else { 0 };
    }
    // The difference to the truncated value is exact. From the floor, -½ + 2^-54 would look like a
    // tie.
    let whole = cast::i128_of(scaled);
    let rest = (scaled - scaled.trunc()).abs(); // 0 <= rest < 1
    let negative = scaled < 0.0;
    let away = match round {
        Round::Floor => negative && rest > 0.0,
        Round::TowardZero => false,
        Round::HalfUp => rest > 0.5 || (rest == 0.5 && !negative),
        Round::HalfAway => rest >= 0.5,
        Round::HalfEven => rest > 0.5 || (rest == 0.5 && whole & 1 == 1),
    };
    match (away, negative) {
        (false, _) => whole,
        (true, false) => whole + 1,
        (true, true) => whole - 1,
    }
}

/// The hardware that a `narrow` needs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Narrowing {
    /// An incrementer.
    pub rounds: bool,
    /// A comparison and a multiplexer.
    pub saturates: bool,
}

impl Narrowing {
    /// Hardware for narrowing words of `from` to `to`.
    #[must_use]
    pub fn new(from: Format, to: Format, round: Round, overflow: Overflow) -> Self {
        let overflows = |raw| narrow(raw, from.frac_bits(), to, round, overflow).1;
        let saturating = matches!(overflow, Overflow::Saturate | Overflow::Symmetric);
        let drops_up = match round {
            Round::Floor => false,
            Round::TowardZero => from.is_signed(),
            Round::HalfUp | Round::HalfAway | Round::HalfEven => true,
        };
        Self {
            rounds: from.frac_bits() > to.frac_bits() && drops_up,
            // Rounding is monotone, so checking both ends of the format suffices.
            saturates: saturating && (overflows(from.min_raw()) || overflows(from.max_raw())),
        }
    }
}
