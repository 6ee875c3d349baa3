//! The loops of [`super::batch`]: one instruction over one block of lanes.
//!
//! Plain Rust without branches on samples, which the compiler vectorises. The loops are inlined
//! into the bodies that [`crate::base::simd`] compiles for each set of processor features. A table
//! has 2^n rows and is read at an address masked to n bits, so no read is out of bounds, and the
//! compiler can see that.

use super::lanes::Width;
use crate::base::cast;
use crate::number::format::{Format, Overflow, Round, narrow, word_mask};
use num_traits::{
    PrimInt, WrappingAdd, WrappingMul, WrappingNeg, WrappingShl, WrappingShr, WrappingSub,
};

/// An integer type of lanes.
pub(super) trait Lane:
    PrimInt
    + WrappingAdd
    + WrappingSub
    + WrappingMul
    + WrappingNeg
    + WrappingShl
    + WrappingShr
    + Default
{
    /// Its width.
    const WIDTH: Width;
    /// Bits of the lane.
    const BITS: u32;
    /// Two lanes, as one load from a table returns them.
    type Pair: Copy + Send + Sync + std::fmt::Debug;
    /// Joins two lanes.
    fn pair(first: Self, second: Self) -> Self::Pair;
    /// Splits two lanes.
    fn split(pair: Self::Pair) -> [Self; 2];
    /// Four bit patterns, zero-extended, from one load that is split in registers: four separate
    /// loads would compete with those of the table.
    fn four(lanes: &[Self; 4]) -> [u64; 4];
    /// The low bits of a word.
    fn of(raw: i64) -> Self;
    /// The word of a lane, sign-extended.
    fn raw(self) -> i64;
    /// The word of a lane, zero-extended; for the widest lane, sign-extended.
    fn raw_of_pattern(self) -> i64;
    /// 1 if set.
    #[inline(always)]
    fn flag(set: bool) -> Self {
        if set { Self::one() } else { Self::zero() }
    }
}

impl Lane for i16 {
    const WIDTH: Width = Width::W16;
    const BITS: u32 = 16;
    type Pair = u32;
    #[inline(always)]
    fn pair(first: Self, second: Self) -> u32 {
        u32::from(cast::pattern_of_i16(first)) | u32::from(cast::pattern_of_i16(second)) << 16
    }
    #[inline(always)]
    fn split(pair: u32) -> [Self; 2] {
        [i64::from(pair), i64::from(pair >> 16)].map(cast::low_i16)
    }
    #[inline(always)]
    fn four(lanes: &[Self; 4]) -> [u64; 4] {
        let [a, b, c, d] = lanes.map(i16::to_le_bytes);
        let all = u64::from_le_bytes([a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]]);
        [all & 0xffff, all >> 16 & 0xffff, all >> 32 & 0xffff, all >> 48]
    }
    #[inline(always)]
    fn of(raw: i64) -> Self {
        cast::low_i16(raw)
    }
    #[inline(always)]
    fn raw(self) -> i64 {
        i64::from(self)
    }
    #[inline(always)]
    fn raw_of_pattern(self) -> i64 {
        i64::from(cast::pattern_of_i16(self))
    }
}

impl Lane for i32 {
    const WIDTH: Width = Width::W32;
    const BITS: u32 = 32;
    type Pair = u64;
    #[inline(always)]
    fn pair(first: Self, second: Self) -> u64 {
        u64::from(cast::pattern_of_i32(first)) | u64::from(cast::pattern_of_i32(second)) << 32
    }
    #[inline(always)]
    fn split(pair: u64) -> [Self; 2] {
        [pair, pair >> 32].map(|bits| cast::low_i32(cast::word_of_bits(bits)))
    }
    #[inline(always)]
    fn four(lanes: &[Self; 4]) -> [u64; 4] {
        let two = |a: Self, b: Self| {
            let (a, b) = (a.to_le_bytes(), b.to_le_bytes());
            u64::from_le_bytes([a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]])
        };
        let (low, high) = (two(lanes[0], lanes[1]), two(lanes[2], lanes[3]));
        [low & 0xffff_ffff, low >> 32, high & 0xffff_ffff, high >> 32]
    }
    #[inline(always)]
    fn of(raw: i64) -> Self {
        cast::low_i32(raw)
    }
    #[inline(always)]
    fn raw(self) -> i64 {
        i64::from(self)
    }
    #[inline(always)]
    fn raw_of_pattern(self) -> i64 {
        i64::from(cast::pattern_of_i32(self))
    }
}

impl Lane for i64 {
    const WIDTH: Width = Width::W64;
    const BITS: u32 = 64;
    type Pair = [Self; 2];
    #[inline(always)]
    fn pair(first: Self, second: Self) -> [Self; 2] {
        [first, second]
    }
    #[inline(always)]
    fn split(pair: [Self; 2]) -> [Self; 2] {
        pair
    }
    #[inline(always)]
    fn four(lanes: &[Self; 4]) -> [u64; 4] {
        lanes.map(cast::bits_of)
    }
    #[inline(always)]
    fn of(raw: i64) -> Self {
        raw
    }
    #[inline(always)]
    fn raw(self) -> i64 {
        self
    }
    #[inline(always)]
    fn raw_of_pattern(self) -> i64 {
        self
    }
}

/// An instruction on lanes of one width. Shifts align operands to the result's fraction bits.
#[derive(Clone, Copy, Debug)]
pub(super) enum Kernel {
    /// A sum, difference or product, with an optional [`Fit`] of the result.
    Add {
        shifts: [u32; 2],
        fit: Option<Fit>,
    },
    Sub {
        shifts: [u32; 2],
        fit: Option<Fit>,
    },
    /// The sum of three operands; flags subtract the second and third.
    Sum {
        shifts: [u32; 3],
        minus: [bool; 2],
        fit: Option<Fit>,
    },
    Mul {
        fit: Option<Fit>,
    },
    Fit(Fit),
    AddSub {
        shifts: [u32; 2],
    },
    Neg,
    Abs,
    And,
    Or,
    Xor,
    Equal {
        shifts: [u32; 2],
    },
    Less {
        shifts: [u32; 2],
    },
    Mux {
        shifts: [u32; 2],
    },
    Slice {
        lo: u32,
        bits: u32,
    },
    Concat {
        low_bits: u32,
    },
    /// Leading zeros of a pattern, plus `more`.
    LeadingZeros {
        more: i64,
    },
    ShiftLeft {
        max: u32,
    },
    Wrap(Wrap),
    Slow(Slow),
}

/// `narrow` if the lanes hold all its steps: `((a << up) + bias) >> down`, then a limit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fit {
    pub(super) up: u32,
    pub(super) down: u32,
    pub(super) bias: i64,
    /// Added if the word is negative.
    pub(super) bias_below_0: i64,
    /// Added if the quotient is odd.
    pub(super) bias_if_odd: i64,
    pub(super) limit: Limit,
    /// True if rounded 64-bit words, before limiting, fit 32 bits.
    pub(super) halves: bool,
    /// Index of the overflow counter.
    pub(super) counter: usize,
}

/// How words outside the format are handled.
#[derive(Clone, Copy, Debug)]
pub(super) enum Limit {
    /// No word is outside.
    Free,
    Clamp {
        lo: i64,
        hi: i64,
    },
    Wrap(Wrap),
    /// Keeps this many low bits as a slice; dropped bits don't count as overflow.
    Slice {
        bits: u32,
    },
}

impl Fit {
    /// True if the bias depends on the word.
    pub(super) fn depends(&self) -> bool {
        self.bias_below_0 != 0 || self.bias_if_odd != 0
    }

    /// Biases of a rounding mode that drops `down` bits.
    pub(super) fn biases(round: Round, down: u32) -> [i64; 3] {
        if down == 0 {
            return [0; 3];
        }
        let (half, mask) = (1i64 << (down - 1), word_mask(down));
        match round {
            Round::Floor => [0, 0, 0],
            Round::TowardZero => [0, mask, 0],
            Round::HalfUp => [half, 0, 0],
            Round::HalfAway => [half, -1, 0],
            Round::HalfEven => [half - 1, 0, 1],
        }
    }
}

/// `narrow` by the reference function, for shifts as wide as lanes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slow {
    pub(super) from_frac: i32,
    pub(super) to: Format,
    pub(super) round: Round,
    pub(super) overflow: Overflow,
    pub(super) counter: usize,
}

/// Keeps the low bits of a word, signed or unsigned. The signed form shifts them to the top of the
/// lane and back.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wrap {
    pub(super) signed: bool,
    pub(super) bits: u32,
}

impl Wrap {
    #[inline(always)]
    fn signed<L: Lane>(self, a: L) -> L {
        let places = L::BITS.saturating_sub(self.bits);
        a.wrapping_shl(places).wrapping_shr(places)
    }
}

/// An instruction's operands; those that it doesn't have may be empty.
pub(super) type Operands<'a, L> = [&'a [L]; 3];

/// Runs an instruction whose result has the lane width of its operands.
#[inline(always)]
pub(super) fn step<L: Lane>(
    kernel: Kernel,
    [a, b, c]: Operands<'_, L>,
    to: &mut [L],
    counts: &mut [u64],
) {
    let zero = L::zero();
    match kernel {
        Kernel::Add { shifts: [0, 0], fit: None } => map2(to, a, b, |a, b| a.wrapping_add(&b)),
        Kernel::Add { shifts: [sa, sb], fit: None } => {
            map2(to, a, b, |a, b| a.wrapping_shl(sa).wrapping_add(&b.wrapping_shl(sb)));
        }
        Kernel::Sub { shifts: [0, 0], fit: None } => map2(to, a, b, |a, b| a.wrapping_sub(&b)),
        Kernel::Sub { shifts: [sa, sb], fit: None } => {
            map2(to, a, b, |a, b| a.wrapping_shl(sa).wrapping_sub(&b.wrapping_shl(sb)));
        }
        Kernel::Sum { shifts: [0, 0, 0], minus, fit: None } => match minus {
            [false, false] => map3(to, a, b, c, |a, b, c| a.wrapping_add(&b).wrapping_add(&c)),
            [false, true] => map3(to, a, b, c, |a, b, c| a.wrapping_add(&b).wrapping_sub(&c)),
            [true, false] => map3(to, a, b, c, |a, b, c| a.wrapping_sub(&b).wrapping_add(&c)),
            [true, true] => map3(to, a, b, c, |a, b, c| a.wrapping_sub(&b).wrapping_sub(&c)),
        },
        Kernel::Sum { shifts, minus, fit: None } => {
            for (to, sum) in to.iter_mut().zip(sums(shifts, minus, [a, b, c])) {
                *to = sum;
            }
        }
        Kernel::Mul { fit: None } => map2(to, a, b, |a, b| a.wrapping_mul(&b)),
        Kernel::Add { fit: Some(_), .. }
        | Kernel::Sub { fit: Some(_), .. }
        | Kernel::Sum { fit: Some(_), .. }
        | Kernel::Mul { fit: Some(_) }
        | Kernel::Fit(_) => fitted::<L, L>(kernel, [a, b, c], to, counts),
        Kernel::AddSub { shifts: [sa, sb] } => map3(to, a, b, c, |flag, a, b| {
            // With the mask all ones, (b ^ mask) - mask is -b.
            let mask = flag.wrapping_neg();
            let b = (b.wrapping_shl(sb) ^ mask).wrapping_sub(&mask);
            a.wrapping_shl(sa).wrapping_add(&b)
        }),
        Kernel::Neg => map1(to, a, |a| a.wrapping_neg()),
        Kernel::Abs => map1(to, a, |a| if a < zero { a.wrapping_neg() } else { a }),
        Kernel::And => map2(to, a, b, |a, b| a & b),
        Kernel::Or => map2(to, a, b, |a, b| a | b),
        Kernel::Xor => map2(to, a, b, |a, b| a ^ b),
        Kernel::Equal { shifts: [sa, sb] } => {
            map2(to, a, b, |a, b| L::flag(a.wrapping_shl(sa) == b.wrapping_shl(sb)));
        }
        Kernel::Less { shifts: [sa, sb] } => {
            map2(to, a, b, |a, b| L::flag(a.wrapping_shl(sa) < b.wrapping_shl(sb)));
        }
        Kernel::Mux { shifts: [sa, sb] } => {
            map3(
                to,
                a,
                b,
                c,
                |flag, a, b| {
                    if flag == zero { b.wrapping_shl(sb) } else { a.wrapping_shl(sa) }
                },
            )
        }
        Kernel::Slice { lo, bits } => {
            let mask = L::of(word_mask(bits));
            map1(to, a, |a| a.wrapping_shr(lo) & mask);
        }
        Kernel::Concat { low_bits } => map2(to, a, b, |a, b| a.wrapping_shl(low_bits) | b),
        Kernel::LeadingZeros { more } => {
            map1(to, a, |a| L::of(i64::from(a.leading_zeros()) + more));
        }
        Kernel::ShiftLeft { max } => {
            let most = L::of(i64::from(max));
            map2(to, a, b, |a, n| {
                let n = if n > most { most } else { n };
                a.wrapping_shl(n.to_u32().unwrap_or_default())
            });
        }
        Kernel::Wrap(wrap) if wrap.signed => map1(to, a, |a| wrap.signed(a)),
        Kernel::Wrap(wrap) => {
            let mask = L::of(word_mask(wrap.bits));
            map1(to, a, |a| a & mask);
        }
        Kernel::Slow(slow) => narrow_slowly(slow, a, to, counts),
    }
}

/// Runs `narrow`, alone or fused with a sum, difference or product.
#[inline(always)]
#[expect(clippy::wildcard_enum_match_arm, reason = "no other kernel has anything to fit")]
pub(super) fn fitted<L: Lane, To: Lane>(
    kernel: Kernel,
    [a, b, c]: Operands<'_, L>,
    to: &mut [To],
    counts: &mut [u64],
) {
    match kernel {
        Kernel::Add { shifts: [sa, sb], fit: Some(fit) } => {
            let sums =
                a.iter().zip(b).map(|(a, b)| a.wrapping_shl(sa).wrapping_add(&b.wrapping_shl(sb)));
            counts[fit.counter] += evenly(fit, sums, to);
        }
        Kernel::Sub { shifts: [sa, sb], fit: Some(fit) } => {
            let sums =
                a.iter().zip(b).map(|(a, b)| a.wrapping_shl(sa).wrapping_sub(&b.wrapping_shl(sb)));
            counts[fit.counter] += evenly(fit, sums, to);
        }
        Kernel::Sum { shifts, minus, fit: Some(fit) } => {
            counts[fit.counter] += evenly(fit, sums(shifts, minus, [a, b, c]), to);
        }
        Kernel::Mul { fit: Some(fit) } => {
            let products = a.iter().zip(b).map(|(a, b)| a.wrapping_mul(b));
            counts[fit.counter] += evenly(fit, products, to);
        }
        Kernel::Fit(fit) if fit.depends() => {
            let (up, down) = (fit.up, fit.down);
            let [bias, below_0, odd] = [fit.bias, fit.bias_below_0, fit.bias_if_odd].map(L::of);
            let quotients = a.iter().map(|a| {
                let a = a.wrapping_shl(up);
                let sign = a.wrapping_shr(L::BITS - 1);
                let more = (sign & below_0).wrapping_add(&(a.wrapping_shr(down) & odd));
                a.wrapping_add(&bias).wrapping_add(&more).wrapping_shr(down)
            });
            counts[fit.counter] += limited(fit.limit, quotients, to);
        }
        Kernel::Fit(fit) => counts[fit.counter] += evenly(fit, a.iter().copied(), to),
        other => unreachable!("bug: {other:?} fits nothing"),
    }
}

/// Sums of three shifted terms; the last two may be negated.
#[inline(always)]
fn sums<L: Lane>(
    [sa, sb, sc]: [u32; 3],
    minus: [bool; 2],
    [a, b, c]: Operands<'_, L>,
) -> impl Iterator<Item = L> {
    // With the mask all ones, (b ^ mask) - mask is -b.
    let [mb, mc] = minus.map(|minus| L::flag(minus).wrapping_neg());
    a.iter().zip(b).zip(c).map(move |((a, b), c)| {
        let b = (b.wrapping_shl(sb) ^ mb).wrapping_sub(&mb);
        let c = (c.wrapping_shl(sc) ^ mc).wrapping_sub(&mc);
        a.wrapping_shl(sa).wrapping_add(&b).wrapping_add(&c)
    })
}

/// The product of 32-bit lanes, computed in 64 bits.
#[inline(always)]
pub(super) fn wide_product<To: Lane>(
    fit: Option<Fit>,
    [a, b, _]: Operands<'_, i32>,
    to: &mut [To],
    counts: &mut [u64],
) {
    let products = a.iter().zip(b).map(|(a, b)| i64::from(*a) * i64::from(*b));
    match fit {
        None => {
            for (to, product) in to.iter_mut().zip(products) {
                *to = To::of(product);
            }
        }
        Some(fit) => counts[fit.counter] += evenly(fit, products, to),
    }
}

/// Rounds with the same bias for all words.
#[inline(always)]
fn evenly<L: Lane, To: Lane>(fit: Fit, words: impl Iterator<Item = L>, to: &mut [To]) -> u64 {
    let (up, down, bias) = (fit.up, fit.down, L::of(fit.bias));
    let biased = move |a: L| a.wrapping_shl(up).wrapping_add(&bias);
    if L::WIDTH == Width::W64 && To::WIDTH == Width::W32 && fit.halves {
        // The low half of the quotient is all of it, so the shift needs no sign.
        let low = move |a: L| {
            let bits = cast::bits_of(biased(a).raw()).wrapping_shr(down);
            To::of(cast::word_of_bits(bits))
        };
        limited(fit.limit, words.map(low), to)
    } else {
        limited(fit.limit, words.map(move |a| biased(a).wrapping_shr(down)), to)
    }
}

/// Limits rounded words and counts those outside the limits.
#[inline(always)]
fn limited<L: Lane, To: Lane>(limit: Limit, words: impl Iterator<Item = L>, to: &mut [To]) -> u64 {
    // A block's count fits the narrowest lane.
    let mut changed = L::zero();
    let store = |to: &mut To, word: L, kept: L, changed: &mut L| {
        *changed = changed.wrapping_add(&L::flag(word != kept));
        *to = To::of(kept.raw());
    };
    match limit {
        Limit::Free => {
            for (to, word) in to.iter_mut().zip(words) {
                *to = To::of(word.raw());
            }
        }
        Limit::Slice { bits } => {
            let mask = L::of(word_mask(bits));
            for (to, word) in to.iter_mut().zip(words) {
                *to = To::of((word & mask).raw());
            }
        }
        Limit::Clamp { lo, hi } => {
            let (lo, hi) = (L::of(lo), L::of(hi));
            for (to, word) in to.iter_mut().zip(words) {
                let kept = if word < lo { lo } else { word };
                let kept = if kept > hi { hi } else { kept };
                store(to, word, kept, &mut changed);
            }
        }
        Limit::Wrap(wrap) if wrap.signed => {
            for (to, word) in to.iter_mut().zip(words) {
                store(to, word, wrap.signed(word), &mut changed);
            }
        }
        Limit::Wrap(wrap) => {
            let mask = L::of(word_mask(wrap.bits));
            for (to, word) in to.iter_mut().zip(words) {
                store(to, word, word & mask, &mut changed);
            }
        }
    }
    changed.raw().unsigned_abs()
}

/// Applies the reference function to each word, for shifts as wide as the lane.
#[inline(never)]
fn narrow_slowly<L: Lane>(slow: Slow, from: &[L], to: &mut [L], counts: &mut [u64]) {
    for (to, a) in to.iter_mut().zip(from) {
        let (word, overflowed) =
            narrow(a.raw(), slow.from_frac, slow.to, slow.round, slow.overflow);
        *to = L::of(word);
        counts[slow.counter] += u64::from(overflowed);
    }
}

/// Converts lanes to another width.
#[inline(always)]
pub(super) fn convert<From: Lane, To: Lane>(zero: bool, from: &[From], to: &mut [To]) {
    let pairs = to.iter_mut().zip(from);
    if zero {
        pairs.for_each(|(to, a)| *to = To::of(a.raw_of_pattern()));
    } else {
        pairs.for_each(|(to, a)| *to = To::of(a.raw()));
    }
}

/// The row of an address. An address has at most as many bits as the table; the mask tells the
/// compiler so, which removes the bounds check.
#[inline(always)]
fn row(address: u64, mask: usize) -> usize {
    let address = cast::index_of_bits(address);
    debug_assert!(address <= mask, "bug: row {address} of {}", mask + 1);
    address & mask
}

/// Reads a table's words at addresses.
#[inline(always)]
pub(super) fn read<A: Lane, L: Lane>(words: &[L], addresses: &[A], to: &mut [L]) {
    let mask = words.len().wrapping_sub(1);
    debug_assert!(words.len().is_power_of_two(), "bug: table of {} rows", words.len());
    let (fours, rest) = addresses.as_chunks::<4>();
    let (to_fours, to_rest) = to.as_chunks_mut::<4>();
    for (to, addresses) in to_fours.iter_mut().zip(fours) {
        *to = A::four(addresses).map(|address| words[row(address, mask)]);
    }
    for (to, address) in to_rest.iter_mut().zip(rest) {
        *to = words[row(cast::bits_of(address.raw_of_pattern()), mask)];
    }
}

/// Reads two tables' words, stored side by side, at one address.
#[inline(always)]
pub(super) fn read_pair<A: Lane, L: Lane>(
    words: &[L::Pair],
    addresses: &[A],
    [first, second]: [&mut [L]; 2],
) {
    let mask = words.len().wrapping_sub(1);
    debug_assert!(words.len().is_power_of_two(), "bug: table of {} rows", words.len());
    let (fours, rest) = addresses.as_chunks::<4>();
    let (first_fours, first_rest) = first.as_chunks_mut::<4>();
    let (second_fours, second_rest) = second.as_chunks_mut::<4>();
    for ((first, second), addresses) in first_fours.iter_mut().zip(second_fours).zip(fours) {
        let addresses = A::four(addresses);
        for lane in 0..4 {
            [first[lane], second[lane]] = L::split(words[row(addresses[lane], mask)]);
        }
    }
    for ((first, second), address) in first_rest.iter_mut().zip(second_rest).zip(rest) {
        let address = cast::bits_of(address.raw_of_pattern());
        [*first, *second] = L::split(words[row(address, mask)]);
    }
}

/// A slice of 32-bit lanes that becomes a 16-bit address.
#[inline(always)]
pub(super) fn slice_to_address(lo: u32, bits: u32, from: &[i32], to: &mut [i16]) {
    let mask = i32::of(word_mask(bits));
    for (to, a) in to.iter_mut().zip(from) {
        *to = i16::of((a.wrapping_shr(lo) & mask).raw());
    }
}

#[inline(always)]
fn map1<L: Lane>(to: &mut [L], a: &[L], f: impl Fn(L) -> L) {
    for (to, a) in to.iter_mut().zip(a) {
        *to = f(*a);
    }
}

#[inline(always)]
fn map2<L: Lane>(to: &mut [L], a: &[L], b: &[L], f: impl Fn(L, L) -> L) {
    for ((to, a), b) in to.iter_mut().zip(a).zip(b) {
        *to = f(*a, *b);
    }
}

#[inline(always)]
fn map3<L: Lane>(to: &mut [L], a: &[L], b: &[L], c: &[L], f: impl Fn(L, L, L) -> L) {
    for (((to, a), b), c) in to.iter_mut().zip(a).zip(b).zip(c) {
        *to = f(*a, *b, *c);
    }
}
