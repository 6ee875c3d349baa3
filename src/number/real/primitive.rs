//! What terms are made by.

use crate::base::cast;
use crate::number::trig;

/// What a term does with those before it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Primitive {
    /// `a + b`.
    Add,
    /// `a - b`.
    Sub,
    /// `a * b`.
    Mul,
    /// `a / b`, as floats have it: infinite at `b = 0`, and no number where `a` is 0, too.
    Div,
    /// `-a`.
    Neg,
    /// `|a|`.
    Abs,
    /// The smaller of two.
    Min,
    /// The larger of two.
    Max,
    /// The greatest whole number that is not above `a`.
    Floor,
    /// `a` less as many spans `c` as keep it from `b` to below `b + c`.
    Modulo,
    /// Square root.
    Sqrt,
    /// `2^a`.
    Exp2,
    /// Logarithm to base 2.
    Log2,
    /// `a^b` of `a` not below 0; `0^0` is 1.
    Pow,
    /// The whole number `e` with `2^e <= |a| < 2^(e + 1)`, of normal floats.
    Exponent,
    /// Sine of an angle in turns.
    Sin,
    /// Cosine of an angle in turns.
    Cos,
    /// Arc of a sine in turns, -¼ to ¼; what is beyond ±1 is taken to it.
    Asin,
    /// Arc of a cosine in turns, 0 to ½; what is beyond ±1 is taken to it.
    Acos,
    /// Arc of a tangent in turns, -¼ to ¼.
    Atan,
    /// Direction of (b, a) in turns, -½ to ½: operands are ordinate and abscissa; 0 of (0, 0). Half
    /// a turn is ½; in blocks, of an ordinate of -0, it is -½.
    Atan2,
    /// 1 if `a < b`, else 0.
    Less,
    /// 1 if `a = b`, else 0.
    Equal,
    /// `b` where `a` isn't 0, else `c`.
    Select,
}

impl Primitive {
    /// Every primitive.
    pub const ALL: [Self; 24] = [
        Self::Add,
        Self::Sub,
        Self::Mul,
        Self::Div,
        Self::Neg,
        Self::Abs,
        Self::Min,
        Self::Max,
        Self::Floor,
        Self::Modulo,
        Self::Sqrt,
        Self::Exp2,
        Self::Log2,
        Self::Pow,
        Self::Exponent,
        Self::Sin,
        Self::Cos,
        Self::Asin,
        Self::Acos,
        Self::Atan,
        Self::Atan2,
        Self::Less,
        Self::Equal,
        Self::Select,
    ];

    /// Name in text.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Add => "add",
            Self::Sub => "sub",
            Self::Mul => "mul",
            Self::Div => "div",
            Self::Neg => "neg",
            Self::Abs => "abs",
            Self::Min => "min",
            Self::Max => "max",
            Self::Floor => "floor",
            Self::Modulo => "modulo",
            Self::Sqrt => "sqrt",
            Self::Exp2 => "exp2",
            Self::Log2 => "log2",
            Self::Pow => "pow",
            Self::Exponent => "exponent",
            Self::Sin => "sin_turns",
            Self::Cos => "cos_turns",
            Self::Asin => "asin_turns",
            Self::Acos => "acos_turns",
            Self::Atan => "atan_turns",
            Self::Atan2 => "atan2_turns",
            Self::Less => "less",
            Self::Equal => "equal",
            Self::Select => "select",
        }
    }

    /// Number of operands.
    #[must_use]
    pub const fn arity(self) -> usize {
        match self {
            Self::Neg
            | Self::Abs
            | Self::Floor
            | Self::Sqrt
            | Self::Exp2
            | Self::Log2
            | Self::Exponent
            | Self::Sin
            | Self::Cos
            | Self::Asin
            | Self::Acos
            | Self::Atan => 1,
            Self::Add
            | Self::Sub
            | Self::Mul
            | Self::Div
            | Self::Min
            | Self::Max
            | Self::Pow
            | Self::Atan2
            | Self::Less
            | Self::Equal => 2,
            Self::Modulo | Self::Select => 3,
        }
    }
}

impl Primitive {
    /// Value as evaluation in blocks gives it.
    #[inline(always)]
    pub(crate) fn twin(self, a: f64, b: f64, c: f64) -> f64 {
        let flag = |holds: bool| f64::from(u8::from(holds));
        match self {
            Self::Add => a + b,
            Self::Sub => a - b,
            Self::Mul => a * b,
            Self::Div => a / b,
            Self::Neg => -a,
            Self::Abs => a.abs(),
            // The processor's own, whichever of two zeros comes first.
            Self::Min => {
                if a < b {
                    a
                } else {
                    b
                }
            }
            Self::Max => {
                if a > b {
                    a
                } else {
                    b
                }
            }
            Self::Floor => a.floor(),
            Self::Modulo => modulo(a, b, c),
            Self::Sqrt => a.sqrt(),
            Self::Exp2 => libm::exp2(a),
            Self::Log2 => libm::log2(a),
            Self::Pow => libm::pow(a, b),
            Self::Exponent => f64::from(exponent(a)),
            Self::Sin => trig::sin_cos_turns(a).0,
            Self::Cos => trig::sin_cos_turns(a).1,
            Self::Asin => trig::asin_turns(a),
            Self::Acos => trig::acos_turns(a),
            Self::Atan => trig::atan_turns(a),
            Self::Atan2 => trig::atan2_turns(a, b),
            Self::Less => flag(a < b),
            Self::Equal => flag(a == b),
            Self::Select => {
                if a == 0.0 {
                    c
                } else {
                    b
                }
            }
        }
    }
}

/// A number less as many spans as keep it from `low` to below `low + span`.
#[inline(always)]
pub(crate) fn modulo(a: f64, low: f64, span: f64) -> f64 {
    let rest = a - span * ((a - low) * span.recip()).floor();
    // What is below `low` by less than a last place of the span rounds to the far end.
    if rest < low + span { rest } else { rest - span }
}

/// The exponent of a float that is not 0 nor subnormal: `2^exponent <= |x| < 2^(exponent + 1)`.
#[inline(always)]
fn exponent(x: f64) -> i32 {
    cast::signed_count(cast::id_of(cast::index_of_bits((x.to_bits() >> 52) & 0x7ff))) - 1023
}
