//! Evaluation with any number of bits.

use super::expr::Reading;
use super::primitive::Primitive;
use super::rows::Rows;
use dashu_float::FBig;
use dashu_float::ops::{Abs, SquareRoot};
use dashu_float::round::mode::HalfEven;
use std::cmp::Ordering;

type Float = FBig<HalfEven, 2>;

/// A number with its reading's number of bits.
#[derive(Clone, Debug)]
pub struct Big(Float);

impl Big {
    /// The nearest `f64`.
    #[must_use]
    pub fn nearest(&self) -> f64 {
        self.0.to_f64().value()
    }

    /// The difference to `other` as the nearest `f64`; NaN if `other` is not finite.
    #[must_use]
    pub fn less(&self, other: f64) -> f64 {
        let other = Float::try_from(other).ok().filter(|other| !other.repr().is_infinite());
        other.map_or(f64::NAN, |other| (&self.0 - other).to_f64().value())
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self(&self.0 + &other.0)
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        Self(&self.0 * &other.0)
    }

    /// The number clamped to a range.
    #[must_use]
    pub fn clamp(self, lo: &Self, hi: &Self) -> Self {
        Self(self.0.clamp(lo.0.clone(), hi.0.clone()))
    }

    /// The nearest whole number, ties to even; `None` beyond 63 bits.
    #[must_use]
    pub fn round(&self) -> Option<i64> {
        i64::try_from(self.0.to_int().value()).ok()
    }
}

/// Evaluation with a given number of bits: each primitive's result is within a few units in its
/// last place. A value is `None` where it is undefined: at poles, and for roots and logarithms of
/// negative numbers.
#[derive(Clone, Copy, Debug)]
pub struct Precise {
    bits: usize,
}

impl Precise {
    /// A reading with `bits` bits.
    #[must_use]
    pub fn new(bits: usize) -> Self {
        Self { bits }
    }

    fn exact(self, value: f64) -> Option<Float> {
        let value = Float::try_from(value).ok().filter(|value| !value.repr().is_infinite())?;
        Some(value.with_precision(self.bits).value())
    }

    fn whole(self, value: f64) -> Float {
        self.exact(value).expect("bug: a whole number is finite")
    }

    /// `a - span * floor((a - low) / span)`.
    fn modulo(a: &Float, low: &Float, span: &Float) -> Option<Float> {
        (*span != Float::ZERO).then(|| a - ((a - low) / span).floor() * span)
    }

    fn log2(self, a: &Float) -> Float {
        a.ln() / self.whole(2.0).ln()
    }

    /// `2^a` from the whole part, which is exact, and the rest.
    fn exp2(self, a: &Float) -> Option<Float> {
        let whole = a.floor();
        let far = 1 << 20;
        let places = isize::try_from(whole.to_int().value());
        let places = match places {
            Ok(places) if places.abs() <= far => places,
            // Smaller results are 0 in any format; larger ones are not needed.
            Ok(_) | Err(_) if *a < Float::ZERO => return Some(Float::ZERO),
            Ok(_) | Err(_) => return None,
        };
        let rest = (a - whole).with_precision(self.bits).value();
        if rest == Float::ZERO {
            return Some(self.whole(1.0) << places);
        }
        Some((rest * self.whole(2.0).ln()).exp() << places)
    }

    fn pow(self, a: &Float, b: &Float) -> Option<Float> {
        let zero = Float::ZERO;
        match (a.cmp(&zero), b.cmp(&zero)) {
            (_, Ordering::Equal) => Some(self.whole(1.0)),
            (Ordering::Equal, Ordering::Greater) => Some(zero),
            (Ordering::Equal, Ordering::Less) | (Ordering::Less, _) => None,
            (Ordering::Greater, _) => {
                let whole = b.floor() == *b && b.clone().abs() < self.whole(65_536.0);
                if whole {
                    Some(a.powi(b.to_int().value()))
                } else {
                    self.exp2(&(b * self.log2(a)))
                }
            }
        }
    }

    /// Direction of (x, y) in turns.
    fn atan2(self, y: &Float, x: &Float) -> Float {
        let zero = Float::ZERO;
        let half = |sign: &Float| if *sign < zero { self.whole(-0.5) } else { self.whole(0.5) };
        match (x.cmp(&zero), y.cmp(&zero)) {
            (Ordering::Equal, Ordering::Equal) => zero,
            (Ordering::Equal, _) => half(y) / self.whole(2.0),
            (Ordering::Greater, _) => (y / x).atan_unit(1),
            (Ordering::Less, _) => (y / x).atan_unit(1) + half(y),
        }
    }

    fn exponent(a: &Float) -> Option<isize> {
        let repr = a.repr();
        let digits = isize::try_from(repr.digits()).ok()?;
        (*a != Float::ZERO).then(|| repr.exponent() + digits - 1)
    }
}

impl Reading for Precise {
    type Value = Option<Big>;

    fn constant(&self, value: f64) -> Option<Big> {
        self.exact(value).map(Big)
    }

    fn row(&self, rows: &Rows, of: &Option<Big>) -> Option<Big> {
        let at = Big(of.as_ref()?.0.floor()).nearest();
        self.constant(rows.at(at))
    }

    fn of(&self, primitive: Primitive, of: [&Option<Big>; 3]) -> Option<Big> {
        let zero = Float::ZERO;
        let operand = |i: usize| of[i].as_ref().map(|big| &big.0);
        if primitive == Primitive::Select {
            // The branch that isn't taken may have no value.
            let taken = if *operand(0)? == zero { 2 } else { 1 };
            return of[taken].clone();
        }
        let a = operand(0)?;
        let b = || operand(1);
        let c = || operand(2);
        let flag = |holds: bool| self.whole(f64::from(u8::from(holds)));
        let within = |a: &Float| a.clone().clamp(self.whole(-1.0), self.whole(1.0));
        let value = match primitive {
            Primitive::Add => a + b()?,
            Primitive::Sub => a - b()?,
            Primitive::Mul => a * b()?,
            Primitive::Div => {
                let b = b()?;
                if *b == zero {
                    return None;
                }
                a / b
            }
            Primitive::Neg => -a.clone(),
            Primitive::Abs => a.clone().abs(),
            Primitive::Min => a.min(b()?).clone(),
            Primitive::Max => a.max(b()?).clone(),
            Primitive::Floor => a.floor(),
            Primitive::Modulo => Self::modulo(a, b()?, c()?)?,
            Primitive::Sqrt if *a < zero => return None,
            Primitive::Sqrt => SquareRoot::sqrt(a),
            Primitive::Exp2 => self.exp2(a)?,
            Primitive::Log2 if *a <= zero => return None,
            Primitive::Log2 => self.log2(a),
            Primitive::Pow => self.pow(a, b()?)?,
            Primitive::Exponent => {
                let exponent = i32::try_from(Self::exponent(a)?).ok()?;
                self.whole(f64::from(exponent))
            }
            Primitive::Sin => a.sin_unit(1),
            Primitive::Cos => a.cos_unit(1),
            Primitive::Asin => within(a).asin_unit(1),
            Primitive::Acos => self.whole(0.25) - within(a).asin_unit(1),
            Primitive::Atan => a.atan_unit(1),
            Primitive::Atan2 => self.atan2(a, b()?),
            Primitive::Less => flag(a < b()?),
            Primitive::Equal => flag(a == b()?),
            Primitive::Select => unreachable!("bug: handled above"),
        };
        // Some results of dashu, such as 0, carry only as many bits as they need: restore the
        // precision.
        Some(Big(value.with_precision(self.bits).value()))
    }
}
