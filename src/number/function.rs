//! The real functions that tables hold, in `f64` and to any precision.
//!
//! Angles are in turns, so that the reduction to the first octant is exact:
//! sin(½ turn) is 0 and not 1.2e-16. Poles give an infinity of the sign that
//! the function has on the side where the angle grows; arguments outside the
//! domain of asin are taken to its end.

use crate::base::cast;
use crate::number::trig;
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use std::f64::consts::TAU;

type Big = FBig<HalfEven, 2>;

/// Bits of the high-precision evaluation; table words have at most 63.
const BIG_BITS: usize = 160;

/// A finite `f64` that is ordered and can be a key; equal is bit for bit, and there is no -0.
#[derive(Clone, Copy, Debug)]
pub struct Number(f64);

impl Number {
    /// The number.
    #[must_use]
    pub fn get(self) -> f64 {
        self.0
    }
}

impl From<f64> for Number {
    fn from(value: f64) -> Self {
        Self(value + 0.0) // -0 becomes 0
    }
}

impl Ord for Number {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Number {}

impl std::hash::Hash for Number {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.0.to_bits().hash(state);
    }
}

/// A real function of one variable.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Function {
    /// sin of an angle in turns.
    Sin,
    /// cos of an angle in turns.
    Cos,
    /// 1 / (2 sin) of an angle in turns; +infinity at 0, -infinity at ½.
    HalfRecipSin,
    /// 1 / (2 cos) of an angle in turns; -infinity at ¼, +infinity at ¾.
    HalfRecipCos,
    /// asin in turns, -¼ to ¼.
    Asin,
    /// atan in turns, -¼ to ¼.
    Atan,
    /// θ_prop of seed 001, eq (26): `1 - acos(y)/90°`, which is asin in quarter turns.
    Prop,
    /// 1 / x.
    Recip,
    /// sqrt(1 + x²), the secant of atan x.
    Secant,
    /// Square root; 0 below 0.
    Sqrt,
    /// 1 / sqrt(x); +infinity at 0 and below.
    RecipSqrt,
    /// `offset + factor * max(0, x)^exponent`, a light table of seed 001; 0^0 is 1.
    Light {
        /// Light at 0.
        offset: Number,
        /// Light at 1 without it; not negative, as the offset.
        factor: Number,
        /// The exponent.
        exponent: u8,
    },
}

impl Function {
    /// Every function; of those with parameters, one.
    pub const ALL: [Self; 12] = [
        Self::Sin,
        Self::Cos,
        Self::HalfRecipSin,
        Self::HalfRecipCos,
        Self::Asin,
        Self::Atan,
        Self::Prop,
        Self::Recip,
        Self::Secant,
        Self::Sqrt,
        Self::RecipSqrt,
        Self::Light { offset: Number(0.1), factor: Number(0.8), exponent: 33 },
    ];

    /// Name in table names, listings and files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::HalfRecipSin => "half_recip_sin",
            Self::HalfRecipCos => "half_recip_cos",
            Self::Asin => "asin",
            Self::Atan => "atan",
            Self::Prop => "prop",
            Self::Recip => "recip",
            Self::Secant => "secant",
            Self::Sqrt => "sqrt",
            Self::RecipSqrt => "recip_sqrt",
            Self::Light { .. } => "light",
        }
    }

    /// Value to within [`Self::F64_ERROR`] relative.
    #[inline]
    #[must_use]
    pub fn eval(self, x: f64) -> f64 {
        match self {
            Self::Sin => sin_turns(x),
            Self::Cos => cos_turns(x),
            Self::HalfRecipSin => 0.5 / sin_turns(x),
            Self::HalfRecipCos => 0.5 / cos_turns(x),
            Self::Asin => libm::asin(x.clamp(-1.0, 1.0)) / TAU,
            Self::Atan => libm::atan(x) / TAU,
            Self::Prop => libm::asin(x.clamp(-1.0, 1.0)) * (4.0 / TAU),
            Self::Recip => 1.0 / x,
            Self::Secant => x.mul_add(x, 1.0).sqrt(),
            Self::Sqrt => x.max(0.0).sqrt(),
            Self::RecipSqrt => 1.0 / x.max(0.0).sqrt(),
            Self::Light { offset, factor, exponent } => {
                offset.0 + factor.0 * libm::pow(x.max(0.0), exponent.into())
            }
        }
    }

    /// Value as evaluations on reals have it: by [`crate::number::trig`] where it knows the function.
    #[inline(always)]
    #[must_use]
    pub fn eval_real(self, x: f64) -> f64 {
        match self {
            Self::Sin => trig::sin_cos_turns(x).0,
            Self::Cos => trig::sin_cos_turns(x).1,
            Self::HalfRecipSin => 0.5 / trig::sin_cos_turns(x).0,
            Self::HalfRecipCos => 0.5 / trig::sin_cos_turns(x).1,
            Self::Asin => trig::asin_turns(x),
            Self::Atan => trig::atan_turns(x),
            Self::Prop => 4.0 * trig::asin_turns(x),
            Self::Secant => (x * x + 1.0).sqrt(),
            Self::Recip | Self::Sqrt | Self::RecipSqrt | Self::Light { .. } => self.eval(x),
        }
    }

    /// Bound on the relative error of [`Self::eval`]: a few roundings of half an ulp each.
    pub const F64_ERROR: f64 = 8.0 * f64::EPSILON;

    /// Value to [`BIG_BITS`] bits; `None` at a pole.
    fn big(self, x: f64) -> Option<Big> {
        let exact = |x: f64| {
            Big::try_from(x).expect("bug: argument is finite").with_precision(BIG_BITS).value()
        };
        let one = || exact(1.0);
        let root = |big: &Big| dashu_float::ops::SquareRoot::sqrt(big);
        let recip = |big: Big| (big != Big::ZERO).then(|| one() / big);
        match self {
            Self::Sin => Some(exact(x).sin_unit(1)),
            Self::Cos => Some(exact(x).cos_unit(1)),
            Self::HalfRecipSin => recip(exact(x).sin_unit(1) * exact(2.0)),
            Self::HalfRecipCos => recip(exact(x).cos_unit(1) * exact(2.0)),
            Self::Asin => Some(exact(x.clamp(-1.0, 1.0)).asin_unit(1)),
            Self::Atan => Some(exact(x).atan_unit(1)),
            Self::Prop => Some(exact(x.clamp(-1.0, 1.0)).asin_unit(1) * exact(4.0)),
            Self::Recip => recip(exact(x)),
            Self::Secant => {
                let x = exact(x);
                Some(root(&(one() + &x * &x)))
            }
            Self::Sqrt => Some(root(&exact(x.max(0.0)))),
            Self::RecipSqrt => (x > 0.0).then(|| one() / root(&exact(x))),
            Self::Light { offset, factor, exponent } => {
                let power = exact(x.max(0.0)).powi(exponent.into());
                Some(exact(offset.0) + exact(factor.0) * power)
            }
        }
    }
}

/// `x - q/4` and q mod 4 for the nearest quarter turn; both exact.
fn quarter(x: f64) -> (f64, i64) {
    let q = (4.0 * x).round();
    (x - 0.25 * q, cast::i64_of(q).rem_euclid(4))
}

/// sin of an angle in turns. At the zeros the sign is that of the function just above.
#[must_use]
pub fn sin_turns(x: f64) -> f64 {
    let (r, quadrant) = quarter(x);
    let r = r * TAU + 0.0; // -0 becomes +0
    match quadrant {
        0 => libm::sin(r),
        1 => libm::cos(r),
        2 => -libm::sin(r),
        _ => -libm::cos(r),
    }
}

/// cos of an angle in turns. At the zeros the sign is that of the function just above.
#[must_use]
pub fn cos_turns(x: f64) -> f64 {
    let (r, quadrant) = quarter(x);
    let r = r * TAU + 0.0; // -0 becomes +0
    match quadrant {
        0 => libm::cos(r),
        1 => -libm::sin(r),
        2 => -libm::cos(r),
        _ => libm::sin(r),
    }
}

/// A linear combination of values of a function, the form that every table entry has:
/// `Σ coefficient * clamp(f(x), lo, hi) + constant`.
#[derive(Clone, Debug)]
pub struct Combination<'a> {
    /// The function.
    pub function: Function,
    /// Pairs of coefficient and argument, both exact.
    pub terms: &'a [(f64, f64)],
    /// Added to the sum; exact.
    pub constant: f64,
    /// Values of the function are saturated to this range; this is where poles end.
    pub range: (f64, f64),
}

impl Combination<'_> {
    /// Value of the combination in `f64`.
    #[must_use]
    pub fn eval(&self) -> f64 {
        let (lo, hi) = self.range;
        let sum: f64 =
            self.terms.iter().map(|&(c, x)| c * self.function.eval(x).clamp(lo, hi)).sum();
        sum + self.constant
    }

    /// The combination in units of 2^-frac_bits, correctly rounded to the nearest whole number.
    ///
    /// `f64` decides where its error bound allows, and the high-precision evaluation elsewhere
    /// (Ziv's strategy): near a tie, and for words near the limit of `f64`.
    #[must_use]
    pub fn round(&self, frac_bits: i32) -> i64 {
        let (lo, hi) = self.range;
        let scale = 2f64.powi(frac_bits);
        let magnitude: f64 = self
            .terms
            .iter()
            .map(|&(c, x)| (c * self.function.eval(x).clamp(lo, hi)).abs())
            .sum::<f64>()
            + self.constant.abs();
        let scaled = self.eval() * scale;
        let error = magnitude * scale * Function::F64_ERROR * 2.0;
        let nearest = scaled.round_ties_even();
        let to_tie = 0.5 - (scaled - nearest).abs();
        if to_tie > error { cast::i64_of(nearest) } else { self.round_big(frac_bits) }
    }

    fn round_big(&self, frac_bits: i32) -> i64 {
        let exact = |x: f64| {
            Big::try_from(x).expect("bug: coefficient is finite").with_precision(BIG_BITS).value()
        };
        let (lo, hi) = (exact(self.range.0), exact(self.range.1));
        let mut sum = exact(self.constant);
        for &(coefficient, x) in self.terms {
            let value = match self.function.big(x) {
                None if self.function.eval(x) < 0.0 => lo.clone(),
                None => hi.clone(),
                Some(value) => value.clamp(lo.clone(), hi.clone()),
            };
            sum += exact(coefficient) * value;
        }
        let scaled = sum * exact(2f64.powi(frac_bits));
        i64::try_from(scaled.to_int().value()).expect("bug: table entry past 63 bits")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_and_poles_have_the_sign_of_the_side_above() {
        assert_eq!(sin_turns(0.5), 0.0);
        assert!(sin_turns(0.5).is_sign_negative() && cos_turns(0.25).is_sign_negative());
        assert!(cos_turns(-0.25).is_sign_positive() && cos_turns(0.75).is_sign_positive());
        assert_eq!(Function::HalfRecipSin.eval(0.0), f64::INFINITY);
        assert_eq!(Function::HalfRecipSin.eval(-0.5), f64::NEG_INFINITY);
        assert_eq!(Function::HalfRecipCos.eval(-0.25), f64::INFINITY);
        assert_eq!(Function::HalfRecipCos.eval(0.25), f64::NEG_INFINITY);
    }

    #[test]
    fn f64_is_within_its_stated_error_of_the_high_precision_value() {
        for function in Function::ALL {
            for i in -300..=300 {
                let x = f64::from(i) / 256.0 + f64::from(i) * 2f64.powi(-30);
                let Some(big) = function.big(x) else { continue };
                let big = big.to_f64().value();
                let error = (function.eval(x) - big).abs();
                assert!(error <= big.abs() * Function::F64_ERROR, "{function:?}({x}): {error:e}");
            }
        }
    }

    #[test]
    fn ties_and_near_ties_round_to_nearest() {
        let range = (-4.0, 4.0);
        let half =
            Combination { function: Function::Sin, terms: &[(0.5, 0.25)], constant: 0.0, range };
        assert_eq!(half.round(0), 0, "½ exactly: to even");
        let above = Combination { terms: &[(0.5, 0.25), (1.0, 2f64.powi(-70))], ..half.clone() };
        assert_eq!(above.round(0), 1, "½ + 2π 2^-70: f64 can't tell, the long evaluation can");
        let below = Combination { terms: &[(0.5, 0.25), (-1.0, 2f64.powi(-70))], ..half };
        assert_eq!(below.round(0), 0);
    }

    #[test]
    fn poles_saturate_to_the_range() {
        let pole = |function, x| {
            Combination { function, terms: &[(1.0, x)], constant: 0.0, range: (-8.0, 7.5) }.round(1)
        };
        assert_eq!(pole(Function::HalfRecipSin, 0.0), 15);
        assert_eq!(pole(Function::HalfRecipSin, -0.5), -16);
        assert_eq!(pole(Function::HalfRecipCos, 0.25), -16);
    }
}
