//! Interval arithmetic that contains every value for its operands.

use super::expr::Reading;
use super::primitive::Primitive;
use super::rows::Rows;
use super::scalar::Scalar;
use crate::base::cast;
use std::ops::{Add, Mul};

/// The numbers from `lo` to `hi` inclusive; ends may be infinite.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Interval {
    /// Lower end.
    pub lo: f64,
    /// Upper end.
    pub hi: f64,
}

impl From<f64> for Interval {
    fn from(value: f64) -> Self {
        Self { lo: value, hi: value }
    }
}

impl Interval {
    /// Every number.
    pub const ALL: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
    /// 0 or 1.
    const FLAG: Self = Self { lo: 0.0, hi: 1.0 };

    /// The interval between two numbers.
    #[must_use]
    pub fn new(lo: f64, hi: f64) -> Self {
        Self { lo, hi }
    }

    /// True if the interval contains a number.
    #[must_use]
    pub fn contains(self, value: f64) -> bool {
        self.lo <= value && value <= self.hi
    }

    /// The smallest interval that contains both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The interval with both ends clamped.
    #[must_use]
    pub fn clamp(self, lo: f64, hi: f64) -> Self {
        Self { lo: self.lo.clamp(lo, hi), hi: self.hi.clamp(lo, hi) }
    }

    /// Moves the ends outward by the error of `libm`; an infinite end stays.
    fn outward(self) -> Self {
        // Functions are within an ulp; turns and reduced arguments add three roundings.
        const ULPS: f64 = 4.0 * f64::EPSILON;
        let moved = |x: f64, up: bool| {
            if x.is_infinite() {
                x
            } else {
                step(x + if up { 1.0 } else { -1.0 } * x.abs() * ULPS, up)
            }
        };
        Self { lo: moved(self.lo, false), hi: moved(self.hi, true) }
    }

    /// As [`Self::outward`], for a function whose only zero is at 0, where it is exact.
    fn outward_from(self, argument: Self) -> Self {
        let Self { lo, hi } = self.outward();
        Self {
            lo: if argument.lo == 0.0 { 0.0 } else { lo },
            hi: if argument.hi == 0.0 { 0.0 } else { hi },
        }
    }

    /// The hull of some ends; every number if one of them is NaN.
    fn of_ends(ends: &[f64]) -> Self {
        if ends.iter().any(|end| end.is_nan()) {
            return Self::ALL;
        }
        let lo = ends.iter().copied().fold(f64::INFINITY, f64::min);
        let hi = ends.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self { lo, hi }
    }

    fn is_point(self) -> bool {
        self.lo.total_cmp(&self.hi).is_eq()
    }

    /// The image under a monotone increasing function.
    fn rising(self, function: impl Fn(f64) -> f64) -> Self {
        Self::of_ends(&[function(self.lo), function(self.hi)])
    }

    /// sin or cos, whose maxima are at `top` plus a whole number of turns.
    fn wave(self, function: impl Fn(f64) -> f64, top: f64) -> Self {
        let full = Self { lo: -1.0, hi: 1.0 };
        // Beyond this, angles are coarse: use the full range.
        if !(self.lo.abs() < 1e12 && self.hi.abs() < 1e12) || self.hi - self.lo >= 1.0 {
            return full;
        }
        // A zero at a quarter turn is exact, since the reduction is.
        let exact = |x: f64, value: f64| value == 0.0 && (4.0 * x).fract() == 0.0;
        let (at_lo, at_hi) = (function(self.lo), function(self.hi));
        let near = |x: f64, value: f64| {
            let end = Self::from(value + 0.0);
            if exact(x, value) { end } else { end.outward() }
        };
        let ends = near(self.lo, at_lo).hull(near(self.hi, at_hi));
        // True if `at` plus a whole number of turns lies in the interval.
        let holds = |at: f64| (self.hi - at).floor() >= (self.lo - at).ceil();
        let lo = if holds(top + 0.5) { -1.0 } else { ends.lo.max(-1.0) };
        let hi = if holds(top) { 1.0 } else { ends.hi.min(1.0) };
        Self { lo, hi }
    }

    fn negative(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }

    fn magnitude(self) -> Self {
        if self.lo >= 0.0 {
            self
        } else if self.hi <= 0.0 {
            self.negative()
        } else {
            Self { lo: 0.0, hi: self.hi.max(-self.lo) }
        }
    }

    /// The quotient. A divisor that starts at 0 is taken as the upper side of the pole.
    fn over(self, other: Self) -> Self {
        if other.contains(0.0) && (other.lo < 0.0 || other.hi == 0.0) {
            return Self::ALL; // a pole inside, or one whose side is unknown
        }
        let quotient = |a: f64, b: f64, up: bool| {
            let q = a / b;
            let exact = b != 0.0 && q.is_finite() && q.mul_add(b, -a) == 0.0 && a.abs() > SAFE;
            if exact || a == 0.0 || q.is_infinite() && b == 0.0 { q } else { step(q, up) }
        };
        let mut ends = Vec::with_capacity(8);
        for a in [self.lo, self.hi] {
            for b in [other.lo, other.hi] {
                if a == 0.0 {
                    ends.push(0.0);
                } else if b.is_infinite() {
                    ends.push(if a.is_infinite() { f64::NAN } else { 0.0 });
                } else {
                    // Adding 0.0 makes a zero positive: it is the lower end of a divisor that is
                    // not negative.
                    ends.extend([quotient(a, b + 0.0, false), quotient(a, b + 0.0, true)]);
                }
            }
        }
        Self::of_ends(&ends)
    }
}

/// Below this, the remainder of a product or quotient may be too small for an `f64`.
const SAFE: f64 = 1e-250;

/// The next float up or down. It turns an infinity from rounding back into the largest float.
fn step(x: f64, up: bool) -> f64 {
    if up { x.next_up() } else { x.next_down() }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let sum = |a: f64, b: f64, up: bool| {
            let sum = a + b;
            // The remainder of the sum is exact (Knuth).
            let part = sum - a;
            let left = (a - (sum - part)) + (b - part);
            let exact = left == 0.0 || a.is_infinite() || b.is_infinite();
            if exact { sum } else { step(sum, up) }
        };
        let ends = [sum(self.lo, other.lo, false), sum(self.hi, other.hi, true)];
        Self::of_ends(&ends)
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = |a: f64, b: f64, up: bool| {
            if a == 0.0 || b == 0.0 {
                return 0.0;
            }
            let p = a * b;
            let exact = a.is_infinite()
                || b.is_infinite()
                || p.is_finite() && a.mul_add(b, -p) == 0.0 && p.abs() > SAFE;
            if exact { p } else { step(p, up) }
        };
        let pairs =
            [(self.lo, other.lo), (self.lo, other.hi), (self.hi, other.lo), (self.hi, other.hi)];
        let lo = pairs.map(|(a, b)| product(a, b, false));
        let hi = pairs.map(|(a, b)| product(a, b, true));
        Self::of_ends(&[Self::of_ends(&lo).lo, Self::of_ends(&hi).hi])
    }
}

/// Interval evaluation, rounded outward: the result contains the value for all values of the
/// variables.
///
/// Where a primitive is undefined for some of the operands' values (a root of a negative number, a
/// pole), the result is every number. A divisor that starts at 0 is an exception: it gives the
/// values on the upper side of the pole, so the result doesn't contain a value from the other side,
/// such as that of 1/-0.
#[derive(Clone, Copy, Debug)]
pub struct Outward;

impl Reading for Outward {
    type Value = Interval;

    fn constant(&self, value: f64) -> Interval {
        value.into()
    }

    fn row(&self, rows: &Rows, of: &Interval) -> Interval {
        // Maximum number of rows to scan; beyond that, the range of all rows is used.
        const MOST: usize = 1 << 12;
        let (first, last) = (of.lo.floor(), of.hi.floor());
        let few = last - first < cast::f64_of_len(rows.count().min(MOST));
        let (lo, hi) = rows.range();
        // Larger whole numbers are not all distinct in an `f64`.
        if !few || first.abs().max(last.abs()) > 2f64.powi(52) {
            return Interval { lo, hi };
        }
        let steps = cast::i64_of(last - first);
        let at = |step: i64| Interval::from(rows.at(first + cast::f64_of(step)));
        (1..=steps).fold(at(0), |all, step| all.hull(at(step)))
    }

    fn of(&self, primitive: Primitive, [a, b, c]: [&Interval; 3]) -> Interval {
        let (a, b, c) = (*a, *b, *c);
        let scalar = |x: f64, y: f64| Scalar.of(primitive, [&x, &y, &0.0]);
        let one = |x: f64| scalar(x, 0.0);
        match primitive {
            Primitive::Add => a + b,
            Primitive::Sub => a + b.negative(),
            Primitive::Mul => a * b,
            Primitive::Div => a.over(b),
            Primitive::Neg => a.negative(),
            Primitive::Abs => a.magnitude(),
            Primitive::Min => Interval { lo: a.lo.min(b.lo), hi: a.hi.min(b.hi) },
            Primitive::Max => Interval { lo: a.lo.max(b.lo), hi: a.hi.max(b.hi) },
            Primitive::Floor => a.rising(f64::floor),
            Primitive::Modulo => residue(a, b, c),
            Primitive::Sqrt => {
                let root = |x: f64, up: bool| {
                    let root = x.sqrt();
                    let exact = root.mul_add(root, -x) == 0.0 && x > SAFE || x == 0.0;
                    if exact || root.is_infinite() { root } else { step(root, up) }
                };
                if a.lo < 0.0 {
                    return Interval::ALL;
                }
                Interval::of_ends(&[root(a.lo, false), root(a.hi, true)])
            }
            Primitive::Exp2 => {
                let whole = a.is_point() && a.lo.floor() == a.lo && a.lo.abs() < 1000.0;
                let power = a.rising(one);
                if whole { power } else { power.outward().at_least(0.0) }
            }
            Primitive::Log2 if a.lo <= 0.0 => Interval::ALL,
            // The logarithm of 1 is exactly 0.
            Primitive::Log2 => a.rising(one).outward_from(a + Interval::from(-1.0)),
            Primitive::Pow if a.lo < 0.0 || a.lo == 0.0 && b.lo < 0.0 => Interval::ALL,
            Primitive::Pow => {
                let ends = [
                    scalar(a.lo, b.lo),
                    scalar(a.lo, b.hi),
                    scalar(a.hi, b.lo),
                    scalar(a.hi, b.hi),
                ];
                Interval::of_ends(&ends).outward().at_least(0.0)
            }
            Primitive::Exponent => {
                let magnitude = a.magnitude();
                if magnitude.lo < f64::MIN_POSITIVE || magnitude.hi.is_infinite() {
                    return Interval::ALL;
                }
                magnitude.rising(one)
            }
            Primitive::Sin => a.wave(one, 0.25),
            Primitive::Cos => a.wave(one, 0.0),
            Primitive::Asin | Primitive::Atan => a.rising(one).outward_from(a).clamp(-0.25, 0.25),
            Primitive::Acos => a.rising(one).outward().clamp(0.0, 0.5),
            Primitive::Atan2 => {
                let cut = a.lo < 0.0 && a.hi >= 0.0 && b.lo < 0.0;
                let origin = a.contains(0.0) && b.contains(0.0) && !(a.is_point() && b.is_point());
                if cut || origin {
                    return Interval { lo: -0.5, hi: 0.5 };
                }
                let [a_lo, a_hi] = [a.lo + 0.0, a.hi + 0.0]; // -0 becomes 0
                let ends = [
                    scalar(a_lo, b.lo),
                    scalar(a_lo, b.hi),
                    scalar(a_hi, b.lo),
                    scalar(a_hi, b.hi),
                ];
                let direction = Interval::of_ends(&ends);
                // Along the positive axis, 0 is exact.
                let exact = a.is_point() && a_lo == 0.0 && b.lo >= 0.0;
                if exact { direction } else { direction.outward().clamp(-0.5, 0.5) }
            }
            Primitive::Less => {
                if a.hi < b.lo {
                    1.0.into()
                } else if a.lo >= b.hi {
                    0.0.into()
                } else {
                    Interval::FLAG
                }
            }
            Primitive::Equal => {
                if a.lo == a.hi && a == b {
                    1.0.into()
                } else if a.hi < b.lo || b.hi < a.lo {
                    0.0.into()
                } else {
                    Interval::FLAG
                }
            }
            Primitive::Select => {
                if !a.contains(0.0) {
                    b
                } else if a.lo == a.hi {
                    c
                } else {
                    b.hull(c)
                }
            }
        }
    }
}

impl Interval {
    /// Clips the interval from below, for values that are known to be at least `least`.
    fn at_least(self, least: f64) -> Self {
        Self { lo: self.lo.max(least), hi: self.hi.max(least) }
    }
}

/// `a` modulo the span; the whole range if the interval crosses a span boundary.
fn residue(a: Interval, low: Interval, span: Interval) -> Interval {
    let known =
        low.is_point() && span.is_point() && span.lo > 0.0 && a.lo.is_finite() && a.hi.is_finite();
    if !known {
        return Interval::ALL;
    }
    let (low, span) = (low.lo, span.lo);
    let shift = Interval::from(((a.lo - low) / span).floor()) * span.into();
    let start = Interval::from(low) + shift;
    if a.lo < start.hi || a.hi >= (start + span.into()).lo {
        return Interval { lo: low, hi: (Interval::from(low) + span.into()).hi };
    }
    (a + shift.negative()).clamp(low, (Interval::from(low) + span.into()).hi)
}
