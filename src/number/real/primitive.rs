//! The operations of terms.

use crate::base::cast;
use crate::number::trig;

/// The operation of a term on earlier terms.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Primitive {
    /// `a + b`.
    Add,
    /// `a - b`.
    Sub,
    /// `a * b`.
    Mul,
    /// `a / b` as in IEEE arithmetic: infinite at `b = 0`, NaN for 0/0.
    Div,
    /// `-a`.
    Neg,
    /// `|a|`.
    Abs,
    /// The smaller of two.
    Min,
    /// The larger of two.
    Max,
    /// The greatest whole number not above `a`.
    Floor,
    /// `a` reduced by multiples of the span `c` to at least `b` and less than `b + c`.
    Modulo,
    /// Square root.
    Sqrt,
    /// `2^a`.
    Exp2,
    /// Logarithm to base 2.
    Log2,
    /// `a^b` for `a >= 0`; `0^0` is 1.
    Pow,
    /// The whole number `e` with `2^e <= |a| < 2^(e + 1)`, for normal floats.
    Exponent,
    /// Sine of an angle in turns.
    Sin,
    /// Cosine of an angle in turns.
    Cos,
    /// Arcsine in turns, -¼ to ¼; arguments beyond ±1 are clamped.
    Asin,
    /// Arccosine in turns, 0 to ½; arguments beyond ±1 are clamped.
    Acos,
    /// Arctangent in turns, -¼ to ¼.
    Atan,
    /// Direction of (b, a) in turns, -½ to ½; 0 for (0, 0). The operands are y, then x. Half a turn
    /// is ½; evaluation in blocks gives -½ for y = -0.
    Atan2,
    /// 1 if `a < b`, otherwise 0.
    Less,
    /// 1 if `a = b`, otherwise 0.
    Equal,
    /// `b` where `a` isn't 0, otherwise `c`.
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
    /// Value as in evaluation in blocks.
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
            // As the processor's instruction: for two zeros, the second operand.
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

/// A number reduced by multiples of the span to at least `low` and less than `low + span`.
#[inline(always)]
pub(crate) fn modulo(a: f64, low: f64, span: f64) -> f64 {
    let rest = a - span * ((a - low) * span.recip()).floor();
    // A number below `low` by less than an ulp of the span rounds up to the far end.
    if rest < low + span { rest } else { rest - span }
}

/// The exponent of a normal float: `2^exponent <= |x| < 2^(exponent + 1)`.
#[inline(always)]
fn exponent(x: f64) -> i32 {
    cast::signed_count(cast::id_of(cast::index_of_bits((x.to_bits() >> 52) & 0x7ff))) - 1023
}
