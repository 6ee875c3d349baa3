//! Evaluation of one `f64` at a time.

use super::expr::{Expr, Function, Reading};
use super::primitive::Primitive;
use super::rows::Rows;
use crate::base::cast;
use std::f64::consts::TAU;

/// `f64`, bit for bit as evaluation in blocks.
#[derive(Clone, Copy, Debug)]
pub struct Twin;

impl Reading for Twin {
    type Value = f64;

    fn constant(&self, value: f64) -> f64 {
        value
    }

    fn of(&self, primitive: Primitive, [a, b, c]: [&f64; 3]) -> f64 {
        primitive.twin(*a, *b, *c)
    }

    fn row(&self, rows: &Rows, of: &f64) -> f64 {
        rows.at(*of)
    }

    fn call(&self, function: &Function, of: &f64) -> f64 {
        function.twin(*of)
    }
}

impl Function {
    /// Value as in evaluation in blocks.
    pub(crate) fn twin(&self, x: f64) -> f64 {
        let mut value = [0.0];
        match self.kernel() {
            Some(kernel) => kernel(&[x], &mut value),
            None => return self.expr().read(&Twin, &[x]),
        }
        value[0]
    }
}

/// `f64` with the crate `libm`; each primitive is within a few ulp.
#[derive(Clone, Copy, Debug)]
pub struct Scalar;

impl Reading for Scalar {
    type Value = f64;

    fn constant(&self, value: f64) -> f64 {
        value
    }

    fn row(&self, rows: &Rows, of: &f64) -> f64 {
        rows.at(*of)
    }

    fn of(&self, primitive: Primitive, [a, b, c]: [&f64; 3]) -> f64 {
        match primitive {
            Primitive::Sin => sin_turns(*a),
            Primitive::Cos => cos_turns(*a),
            Primitive::Asin => libm::asin(a.clamp(-1.0, 1.0)) / TAU,
            Primitive::Acos => libm::acos(a.clamp(-1.0, 1.0)) / TAU,
            Primitive::Atan => libm::atan(*a) / TAU,
            // The sign of a zero is ignored.
            Primitive::Atan2 => libm::atan2(*a + 0.0, *b + 0.0) / TAU,
            Primitive::Add
            | Primitive::Sub
            | Primitive::Mul
            | Primitive::Div
            | Primitive::Neg
            | Primitive::Abs
            | Primitive::Min
            | Primitive::Max
            | Primitive::Floor
            | Primitive::Modulo
            | Primitive::Sqrt
            | Primitive::Exp2
            | Primitive::Log2
            | Primitive::Pow
            | Primitive::Exponent
            | Primitive::Less
            | Primitive::Equal
            | Primitive::Select => primitive.twin(*a, *b, *c),
        }
    }
}

impl Expr {
    /// Value in the reading [`Scalar`].
    ///
    /// # Panics
    /// If a variable has no value.
    #[must_use]
    pub fn eval(&self, variables: &[f64]) -> f64 {
        self.read(&Scalar, variables)
    }
}

/// `x - q/4` and q mod 4 for the nearest quarter turn; both exact.
fn quarter(x: f64) -> (f64, i64) {
    let q = (4.0 * x).round();
    (x - 0.25 * q, cast::i64_of(q.rem_euclid(4.0)))
}

/// sin of an angle in turns. A zero has the sign of the function just above it.
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

/// cos of an angle in turns. A zero has the sign of the function just above it.
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
