//! Library functions, and correctly rounded words of functions.
//!
//! Angles are in turns, so that the reduction to the first octant is exact: sin(½ turn) is 0 and
//! not 1.2e-16. At a pole the result is an infinity whose sign is the function's just above the
//! pole.

use super::real::{Big, Interval, Outward, Precise, Reading};
use crate::base::cast;
use crate::base::error::{Error, Result};
use std::sync::LazyLock;

pub use super::real::{Function, Kernel, Number, cos_turns, sin_turns};

/// Bits of the high-precision evaluation; table words have at most 63.
const BIG_BITS: usize = 160;

impl Function {
    /// Maximum error of a kernel in units in the last place.
    pub const KERNEL_ULP: f64 = 2.5;

    /// Compares the kernel with the high-precision value of the expression at some arguments.
    /// Returns the largest difference in units in the last place and its argument.
    ///
    /// # Errors
    /// If it exceeds [`Self::KERNEL_ULP`], the function has no kernel, or it has a value at none of
    /// the arguments.
    pub fn check_kernel(&self, arguments: &[f64]) -> Result<(f64, f64)> {
        let Some(kernel) = self.kernel() else {
            return Err(Error::usage(format!("function `{}` has no kernel", self.name())));
        };
        let mut values = vec![0.0; arguments.len()];
        kernel(arguments, &mut values);
        let mut worst = (0.0, f64::NAN);
        let mut compared = false;
        for (x, is) in arguments.iter().zip(values) {
            let Some(exact) = self.precise(*x) else { continue };
            compared = true;
            let nearest = exact.nearest();
            let ulp = nearest.abs().next_up() - nearest.abs();
            let off = ((is - nearest) - exact.less(nearest)).abs() / ulp;
            // A NaN counts as the worst.
            if off.is_nan() || off > worst.0 {
                worst = (off, *x);
            }
        }
        if !compared {
            let text = format!("function `{}` has no value at any argument given", self.name());
            return Err(Error::usage(text));
        }
        if worst.0 <= Self::KERNEL_ULP {
            return Ok(worst);
        }
        Err(Error::usage(format!(
            "the kernel of function `{}` is {:.1} ulp off at {:e}: legal is up to {}",
            self.name(),
            worst.0,
            worst.1,
            Self::KERNEL_ULP
        )))
    }

    /// Value of a single argument, within a few ulp.
    #[must_use]
    pub fn eval(&self, x: f64) -> f64 {
        self.expr().eval(&[x])
    }

    /// An interval that contains the function's values over an interval.
    #[must_use]
    pub fn interval(&self, x: Interval) -> Interval {
        self.expr().read(&Outward, &[x])
    }

    /// Value with [`BIG_BITS`] bits; `None` at a pole.
    fn precise(&self, x: f64) -> Option<Big> {
        let reading = Precise::new(BIG_BITS);
        let x = reading.constant(x);
        self.expr().read(&reading, &[x])
    }
}

macro_rules! library {
    ($($name:ident = $function:expr, $text:literal;)+) => {
        /// Predefined functions.
        impl Function {$(
            #[doc = $text]
            #[must_use]
            pub fn $name() -> Self {
                static FUNCTION: LazyLock<Function> = LazyLock::new(|| $function);
                FUNCTION.clone()
            }
        )+}
    };
}

library! {
    sin = Function::new("sin", |x| x.sin_turns()).with_quarter_wave(), "sin of an angle in turns.";
    cos = Function::new("cos", |x| x.cos_turns()).advanced_of(&Function::sin()), "cos of an angle in turns.";
    asin = Function::new("asin", |x| x.asin_turns()), "asin in turns, -¼ to ¼.";
    atan = Function::new("atan", |x| x.atan_turns()), "atan in turns, -¼ to ¼.";
    recip = Function::new("recip", |x| 1.0 / x), "1 / x.";
    sqrt = Function::new("sqrt", |x| x.max(0.0).sqrt()), "Square root; 0 below 0.";
    recip_sqrt = Function::new("recip_sqrt", |x| 1.0 / x.max(0.0).sqrt()), "1 / sqrt(x); +infinity at 0 and below.";
}

/// A linear combination of function values, the form of every table entry: `Σ coefficient *
/// clamp(f(x), lo, hi) + constant`.
#[derive(Clone, Debug)]
pub struct Combination<'a> {
    /// The function.
    pub function: &'a Function,
    /// Pairs of coefficient and argument, both exact.
    pub terms: &'a [(f64, f64)],
    /// Added to the sum; exact.
    pub constant: f64,
    /// The function's values are clamped to this range, which also bounds poles.
    pub range: (f64, f64),
}

impl Combination<'_> {
    /// The combination in units of 2^-frac_bits, rounded to the nearest whole number, ties to even.
    ///
    /// If both ends of an interval evaluation round to the same number, that is the result.
    /// Otherwise, near a tie or for words near the limit of `f64`, it is evaluated with 160 bits
    /// (Ziv's strategy).
    #[must_use]
    pub fn round(&self, frac_bits: i32) -> i64 {
        let (lo, hi) = self.range;
        let sum = self.terms.iter().fold(Interval::from(self.constant), |sum, &(c, x)| {
            let value = self.function.interval(x.into()).clamp(lo, hi);
            sum + value * Interval::from(c)
        });
        let Interval { lo, hi } = sum * Interval::from(2f64.powi(frac_bits));
        let nearest = lo.round_ties_even();
        let inside = |x: f64| (x - nearest).abs() < 0.5;
        if inside(lo) && inside(hi) {
            cast::i64_of(nearest)
        } else {
            self.round_precisely(frac_bits)
        }
    }

    fn round_precisely(&self, frac_bits: i32) -> i64 {
        let reading = Precise::new(BIG_BITS);
        let exact = |x: f64| reading.constant(x).expect("bug: a number");
        let (lo, hi) = (exact(self.range.0), exact(self.range.1));
        let mut sum = exact(self.constant);
        for &(coefficient, x) in self.terms {
            let value = match self.function.precise(x) {
                Some(value) => value.clamp(&lo, &hi),
                // A pole gives the end of the range on its side. Where an inner term has a pole,
                // such as 1 / (1 + 1/x) at 0, it gives the value in floats.
                None => match self.function.eval(x) {
                    value if value <= self.range.0 => lo.clone(),
                    value if value < self.range.1 => exact(value),
                    _ => hi.clone(),
                },
            };
            sum = sum.plus(&exact(coefficient).times(&value));
        }
        let scaled = sum.times(&exact(2f64.powi(frac_bits)));
        scaled.round().expect("bug: table entry past 63 bits")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn half_recip_sin() -> Function {
        Function::new("half_recip_sin", |x| 0.5 / x.sin_turns())
    }

    fn half_recip_cos() -> Function {
        Function::new("half_recip_cos", |x| 0.5 / x.cos_turns())
    }

    #[test]
    fn zeros_and_poles_have_the_sign_of_the_side_above() {
        assert_eq!(sin_turns(0.5), 0.0);
        assert!(sin_turns(0.5).is_sign_negative() && cos_turns(0.25).is_sign_negative());
        assert!(cos_turns(-0.25).is_sign_positive() && cos_turns(0.75).is_sign_positive());
        assert_eq!(half_recip_sin().eval(0.0), f64::INFINITY);
        assert_eq!(half_recip_sin().eval(-0.5), f64::NEG_INFINITY);
        assert_eq!(half_recip_cos().eval(-0.25), f64::INFINITY);
        assert_eq!(half_recip_cos().eval(0.25), f64::NEG_INFINITY);
    }

    #[test]
    fn ties_and_near_ties_round_to_nearest() {
        let range = (-4.0, 4.0);
        let function = &Function::sin();
        let half = Combination { function, terms: &[(0.5, 0.25)], constant: 0.0, range };
        assert_eq!(half.round(0), 0, "½ exactly: to even");
        let above = Combination { terms: &[(0.5, 0.25), (1.0, 2f64.powi(-70))], ..half.clone() };
        assert_eq!(above.round(0), 1, "½ + 2π 2^-70: f64 can't tell, the long evaluation can");
        let below = Combination { terms: &[(0.5, 0.25), (-1.0, 2f64.powi(-70))], ..half };
        assert_eq!(below.round(0), 0);
    }

    #[test]
    fn poles_saturate_to_the_range() {
        let pole = |function: &Function, x| {
            Combination { function, terms: &[(1.0, x)], constant: 0.0, range: (-8.0, 7.5) }.round(1)
        };
        assert_eq!(pole(&half_recip_sin(), 0.0), 15);
        assert_eq!(pole(&half_recip_sin(), -0.5), -16);
        assert_eq!(pole(&half_recip_cos(), 0.25), -16);
        assert_eq!(pole(&Function::recip_sqrt(), 0.0), 15);
        assert_eq!(pole(&Function::recip_sqrt(), -1.0), 15);
    }

    /// With an inner pole, or where there is no precise value, entries are the values in floats.
    #[test]
    fn what_has_no_precise_value_is_that_of_floats() {
        let entry = |function: Function, x| {
            let (function, terms) = (&function, &[(1.0, x)][..]);
            Combination { function, terms, constant: 0.0, range: (-8.0, 8.0) }.round(3)
        };
        assert_eq!(entry(Function::new("f", |x| 1.0 / (1.0 + 1.0 / x)), 0.0), 0);
        assert_eq!(entry(Function::new("f", |x| (1.0 / x).atan_turns()), 0.0), 2);
        assert_eq!(entry(Function::new("f", |x| x.exp2() + 0.5), -3e6), 4);
        assert_eq!(entry(Function::new("f", |x| x.pow(2.0)), -1.0), 8);
        assert_eq!(entry(Function::new("f", |x| (&x * 100.0).floor().sqrt()), 0.07), 21);
    }

    #[test]
    fn a_kernel_is_held_to_its_expression() {
        fn good(x: &[f64], to: &mut [f64]) {
            for (to, x) in to.iter_mut().zip(x) {
                *to = libm::tanh(*x);
            }
        }
        fn bad(x: &[f64], to: &mut [f64]) {
            for (to, x) in to.iter_mut().zip(x) {
                let power = libm::exp2(2.0 * std::f64::consts::LOG2_E * x);
                *to = (power - 1.0) / (power + 1.0); // cancels at 0
            }
        }
        let tanh = Function::new("tanh", |x| {
            let power = (x * (2.0 * std::f64::consts::LOG2_E)).exp2();
            (&power - 1.0) / (power + 1.0)
        });
        let arguments: Vec<f64> = (-400..=400).map(|i| f64::from(i) / 128.0 + 1e-9).collect();
        assert!(
            tanh.check_kernel(&arguments)
                .is_err_and(|error| error.to_string().contains("no kernel"))
        );
        let error = tanh.clone().with_kernel(bad).check_kernel(&arguments).unwrap_err();
        assert!(error.to_string().contains("the kernel of function `tanh`"), "{error}");
        // 2 log2 e is rounded in the expression: a relative error of 2^-54 in the argument of exp2.
        let (worst, at) = tanh.with_kernel(good).check_kernel(&arguments).unwrap();
        assert!(worst > 0.1, "{worst} ulp at {at}");
    }
}
