//! The operations of a datapath, each with its one meaning.
//!
//! Every operation is exact: its result format holds every result that its
//! operands' formats allow. Only [`Op::Narrow`] rounds, saturates or wraps.
//! This module gives, for each operation, the result format
//! ([`Op::result_format`]), the value on words ([`Op::eval_raw`]) and the value
//! on reals ([`Op::eval_real`]); the engines and the emitted hardware are twins
//! of these and are tested against them.

use super::id::{NodeId, TableId};
use super::table::Table;
use crate::base::cast;
use crate::number::format::{Format, Overflow, Round, bit_len, narrow};
use crate::number::function::Function;
use crate::number::trig;

/// An operation; operands are kept by the node.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Op {
    /// A port that the caller drives.
    Input,
    /// The word `raw`.
    Const {
        /// The word.
        raw: i64,
    },
    /// `a + b`.
    Add,
    /// `a - b`.
    Sub,
    /// `a - b` where the flag is set, else `a + b`; operands flag, a, b. One adder/subtractor.
    AddSub,
    /// `a * b`.
    Mul,
    /// `-a`.
    Neg,
    /// `|a|`, unsigned.
    Abs,
    /// Bitwise and of words of one format.
    And,
    /// Bitwise or of words of one format.
    Or,
    /// Bitwise exclusive or of words of one format.
    Xor,
    /// Flag: `a = b` as values.
    Equal,
    /// Flag: `a < b` as values.
    Less,
    /// `a` where the flag is set, else `b`; operands flag, a, b.
    Mux,
    /// Bits `lo` and up of the word's pattern, as an unsigned integer; the node's format says how many.
    Slice {
        /// Least bit that is taken.
        lo: u32,
    },
    /// The bits of integer a above the bits of integer b.
    Concat,
    /// `a * 2^left`: the binary point moves, no bit does.
    Shift {
        /// Places to the left; negative is to the right.
        left: i32,
    },
    /// Number of zero bits above the first one of an unsigned word.
    LeadingZeros,
    /// `a * 2^min(n, max)` for an unsigned integer n; operands a, n. A barrel shifter.
    ShiftLeft {
        /// Largest shift that the hardware does.
        max: u32,
    },
    /// The word of a table's column at an address.
    Read {
        /// Table of the netlist.
        table: TableId,
        /// Column of the table.
        column: u32,
    },
    /// The residue of `a` in the node's format modulo that format's span; exact in modular
    /// arithmetic, so angles in turns use it where others would count a wrap.
    Modulo,
    /// `a` in the node's format: the one operation that loses bits.
    Narrow {
        /// What to do with low bits.
        round: Round,
        /// What to do with values outside the format.
        overflow: Overflow,
    },
}

/// What a node stands for as a real number, where that isn't its operation on reals:
/// a table read stands for the function that it approximates, of the node that it approximates it of.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Meaning {
    /// A function of a node.
    Apply(Function, NodeId),
    /// Direction of (x, y) in turns, -½ to ½.
    Atan2 {
        /// Ordinate.
        y: NodeId,
        /// Abscissa.
        x: NodeId,
    },
    /// Angle of (x, y, z) from the z axis in turns, 0 to ½.
    Inclination {
        /// Component across.
        x: NodeId,
        /// Component across.
        y: NodeId,
        /// Component along the axis.
        z: NodeId,
    },
    /// `y / (2 f(angle))`, with 0/0 taken as 0.
    OverTwice {
        /// Dividend.
        y: NodeId,
        /// Function in the divisor.
        function: Function,
        /// Its argument.
        angle: NodeId,
    },
    /// Flag: the node is negative.
    Negative(NodeId),
    /// The greatest whole number that is not above the node.
    Floor(NodeId),
    /// Flag: the cosine of an angle in turns is negative.
    CosNegative(NodeId),
    /// The angle half a turn on.
    Opposite(NodeId),
    /// `a / b`; 0/0 is 0, and what is over 0 else is the largest `f64`, as words saturate.
    Quotient {
        /// Dividend.
        a: NodeId,
        /// Divisor.
        b: NodeId,
    },
    /// Square root; 0 below 0.
    Root(NodeId),
    /// 1 / square root; the largest `f64` at 0 and below, as words saturate.
    RecipRoot(NodeId),
    /// A function of the cosine of an angle in turns.
    OfCos(Function, NodeId),
    /// The largest magnitude of three.
    Largest {
        /// One.
        x: NodeId,
        /// Another.
        y: NodeId,
        /// The third.
        z: NodeId,
    },
    /// By how many places a magnitude shifts up to get to `2^(top - 1)` and above, which is below
    /// `2^top`; 0 for 0.
    Headroom {
        /// The magnitude.
        a: NodeId,
        /// It is below two to this.
        top: i32,
    },
    /// `a * 2^(places + more)`.
    Scaled {
        /// What is scaled.
        a: NodeId,
        /// By how many places, upwards.
        places: NodeId,
        /// By how many more.
        more: i32,
    },
    /// An angle of a direction that is turned about y.
    Tilted {
        /// Its azimuth in turns.
        phi: NodeId,
        /// Its polar angle in turns.
        theta: NodeId,
        /// By this angle in turns, from z to x.
        by: NodeId,
        /// The polar angle of the result, or else its azimuth.
        polar: bool,
    },
}

impl Meaning {
    /// The nodes that it refers to.
    #[must_use]
    pub fn arguments(self) -> [Option<NodeId>; 3] {
        match self {
            Self::Apply(_, a)
            | Self::Negative(a)
            | Self::Floor(a)
            | Self::CosNegative(a)
            | Self::Opposite(a)
            | Self::Root(a)
            | Self::RecipRoot(a)
            | Self::OfCos(_, a)
            | Self::Headroom { a, .. } => [Some(a), None, None],
            Self::Atan2 { y: a, x: b }
            | Self::OverTwice { y: a, angle: b, .. }
            | Self::Quotient { a, b }
            | Self::Scaled { a, places: b, .. } => [Some(a), Some(b), None],
            Self::Inclination { x: a, y: b, z: c }
            | Self::Largest { x: a, y: b, z: c }
            | Self::Tilted { phi: a, theta: b, by: c, .. } => [Some(a), Some(b), Some(c)],
        }
    }

    /// The meaning with every node replaced.
    #[must_use]
    pub(crate) fn map(self, new: impl Fn(NodeId) -> NodeId) -> Self {
        match self {
            Self::Apply(f, a) => Self::Apply(f, new(a)),
            Self::Atan2 { y, x } => Self::Atan2 { y: new(y), x: new(x) },
            Self::Inclination { x, y, z } => Self::Inclination { x: new(x), y: new(y), z: new(z) },
            Self::OverTwice { y, function, angle } => {
                Self::OverTwice { y: new(y), function, angle: new(angle) }
            }
            Self::Negative(a) => Self::Negative(new(a)),
            Self::Floor(a) => Self::Floor(new(a)),
            Self::CosNegative(a) => Self::CosNegative(new(a)),
            Self::Opposite(a) => Self::Opposite(new(a)),
            Self::Quotient { a, b } => Self::Quotient { a: new(a), b: new(b) },
            Self::Root(a) => Self::Root(new(a)),
            Self::RecipRoot(a) => Self::RecipRoot(new(a)),
            Self::OfCos(f, a) => Self::OfCos(f, new(a)),
            Self::Largest { x, y, z } => Self::Largest { x: new(x), y: new(y), z: new(z) },
            Self::Headroom { a, top } => Self::Headroom { a: new(a), top },
            Self::Scaled { a, places, more } => {
                Self::Scaled { a: new(a), places: new(places), more }
            }
            Self::Tilted { phi, theta, by, polar } => {
                Self::Tilted { phi: new(phi), theta: new(theta), by: new(by), polar }
            }
        }
    }

    /// Value on reals of the arguments in order.
    #[inline(always)]
    #[must_use]
    pub fn eval(self, [a, b, c]: [f64; 3]) -> f64 {
        match self {
            Self::Apply(function, _) => function.eval_real(a),
            Self::Atan2 { .. } => trig::atan2_turns(a, b),
            Self::Inclination { .. } => trig::inclination_turns(a, b, c),
            Self::OverTwice { function, .. } => {
                if a == 0.0 {
                    0.0
                } else {
                    a / (2.0 * function.eval_real(b))
                }
            }
            Self::Negative(_) => f64::from(u8::from(a < 0.0)),
            Self::Floor(_) => a.floor(),
            Self::CosNegative(_) => f64::from(u8::from(trig::sin_cos_turns(a).1 < 0.0)),
            Self::Opposite(_) => a + 0.5,
            Self::Quotient { .. } => {
                if a == 0.0 {
                    0.0
                } else {
                    (a / b).clamp(-f64::MAX, f64::MAX)
                }
            }
            Self::Root(_) => a.max(0.0).sqrt(),
            Self::RecipRoot(_) => (1.0 / a.max(0.0).sqrt()).min(f64::MAX),
            Self::OfCos(function, _) => function.eval_real(trig::sin_cos_turns(a).1),
            Self::Largest { .. } => a.abs().max(b.abs()).max(c.abs()),
            Self::Headroom { top, .. } => {
                if a == 0.0 {
                    0.0
                } else {
                    f64::from(top - 1 - exponent(a))
                }
            }
            Self::Scaled { more, .. } => a * libm::exp2(b + f64::from(more)),
            Self::Tilted { polar, .. } => {
                let (phi, theta) = tilted(a, b, c);
                if polar { theta } else { phi }
            }
        }
    }
}

/// A number less as many spans as keep it from `low` to below `low + span`, a power of two.
#[inline(always)]
#[must_use]
pub fn modulo(a: f64, low: f64, span: f64) -> f64 {
    let rest = a - span * ((a - low) * span.recip()).floor();
    // What is below `low` by less than a last place of the span rounds to the far end.
    if rest < low + span { rest } else { rest - span }
}

/// The exponent of a float that is not 0 nor subnormal: `2^exponent <= |x| < 2^(exponent + 1)`.
fn exponent(x: f64) -> i32 {
    i32::try_from((x.to_bits() >> 52) & 0x7ff).expect("bug: 11 bits") - 1023
}

/// Azimuth and polar angle of a direction that is turned about y from z to x; all in turns.
#[inline(always)]
#[must_use]
pub fn tilted(phi: f64, theta: f64, by: f64) -> (f64, f64) {
    let ((sin_phi, cos_phi), (sin_theta, cos_theta), (sin_by, cos_by)) =
        (trig::sin_cos_turns(phi), trig::sin_cos_turns(theta), trig::sin_cos_turns(by));
    let (x, y) = (sin_theta * cos_phi, sin_theta * sin_phi);
    let (x, z) = (x * cos_by + cos_theta * sin_by, cos_theta * cos_by - x * sin_by);
    (trig::atan2_turns(y, x), trig::inclination_turns(x, y, z))
}

/// Why an operation has no result format.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum FormatProblem {
    /// The exact result would need this many bits.
    TooWide(u32),
    /// The operands don't fit the operation.
    Mismatch(String),
}

/// The range of a format's words with `frac_bits` fraction bits (at least its own).
fn aligned(format: Format, frac_bits: i32) -> Result<(i128, i128), FormatProblem> {
    let shift = (frac_bits - format.frac_bits()).unsigned_abs();
    if format.bits() + shift > Format::MAX_BITS {
        return Err(FormatProblem::TooWide(format.bits() + shift));
    }
    Ok((i128::from(format.min_raw()) << shift, i128::from(format.max_raw()) << shift))
}

fn spanning(lo: i128, hi: i128, frac_bits: i32) -> Result<Format, FormatProblem> {
    Format::spanning(lo, hi, frac_bits).map_err(FormatProblem::TooWide)
}

fn expect(holds: bool, text: &str) -> Result<(), FormatProblem> {
    if holds { Ok(()) } else { Err(FormatProblem::Mismatch(text.to_owned())) }
}

/// What an operation is to whoever counts, prints, shares or times it.
#[derive(Clone, Copy, Debug)]
pub struct Traits {
    /// Name in the netlist's text form.
    pub name: &'static str,
    /// Number of operands.
    pub arity: usize,
    /// What it counts as.
    pub operator: Option<Operator>,
    /// True if it is built with a format: others' follows from their operands'.
    pub takes_format: bool,
    /// True if it looks at bit patterns and not at what they are worth.
    pub looks_at_bits: bool,
    /// What takes time in its hardware.
    pub logic: Logic,
}

/// Sorts of operators that are counted.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Operator {
    /// A multiplier.
    Multiplier,
    /// An adder or subtractor.
    Adder,
    /// A change of sign.
    Negation,
    /// A comparison.
    Comparator,
    /// A choice.
    Multiplexer,
    /// A barrel shifter, or a count of zeros for one.
    Shifter,
    /// A change of format.
    Narrow,
    /// A word of a table.
    Read,
}

/// What takes time in an operation's hardware.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Logic {
    /// Nothing: wires.
    Wires,
    /// A level of gates.
    Gates,
    /// A carry over the result.
    Carry,
    /// A carry over the wider operand.
    Comparison,
    /// Rows of a product.
    Product,
    /// A tree over the operand's bits.
    Tree,
    /// A tree over the shifts.
    Shifter {
        /// Largest shift.
        max: u32,
    },
    /// A table.
    Table {
        /// Table of the netlist.
        table: TableId,
    },
    /// Rounding and saturation.
    Narrow {
        /// What is done with low bits.
        round: Round,
        /// What is done outside the format.
        overflow: Overflow,
    },
}

/// One row for each operation: its pattern, one of its kind, and its traits.
macro_rules! operations {
    ($($op:pat, $one:expr, $name:literal $arity:literal $operator:expr, $takes_format:literal $looks_at_bits:literal $logic:expr;)*) => {
        /// One operation of each kind.
        pub const ALL: &'static [Self] = &[$($one),*];

        /// What it is besides its meaning.
        #[must_use]
        pub const fn traits(self) -> Traits {
            match self {
                $($op => Traits {
                    name: $name,
                    arity: $arity,
                    operator: $operator,
                    takes_format: $takes_format,
                    looks_at_bits: $looks_at_bits,
                    logic: $logic,
                },)*
            }
        }
    };
}

const ADDER: Option<Operator> = Some(Operator::Adder);
const NEGATION: Option<Operator> = Some(Operator::Negation);
const COMPARATOR: Option<Operator> = Some(Operator::Comparator);
const SHIFTER: Option<Operator> = Some(Operator::Shifter);
const READ: Op = Op::Read { table: TableId::FIRST, column: 0 };
const NARROW: Op = Op::Narrow { round: Round::Floor, overflow: Overflow::Wrap };

impl Op {
    // pattern, one of its kind, name, operands, what it counts as, takes a format, looks at bits, what takes time
    #[rustfmt::skip]
    operations! {
        Self::Const { .. }, Self::Const { raw: 0 }, "const" 0 None, true false Logic::Wires;
        Self::Add, Self::Add, "add" 2 ADDER, false false Logic::Carry;
        Self::Sub, Self::Sub, "sub" 2 ADDER, false false Logic::Carry;
        Self::Mul, Self::Mul, "mul" 2 Some(Operator::Multiplier), false false Logic::Product;
        Self::Equal, Self::Equal, "equal" 2 COMPARATOR, false false Logic::Comparison;
        Self::Less, Self::Less, "less" 2 COMPARATOR, false false Logic::Comparison;
        Self::AddSub, Self::AddSub, "addsub" 3 ADDER, false false Logic::Carry;
        Self::Mux, Self::Mux, "mux" 3 Some(Operator::Multiplexer), false false Logic::Gates;
        Self::Neg, Self::Neg, "neg" 1 NEGATION, false false Logic::Carry;
        Self::Abs, Self::Abs, "abs" 1 NEGATION, false false Logic::Carry;
        Self::And, Self::And, "and" 2 None, false true Logic::Gates;
        Self::Or, Self::Or, "or" 2 None, false true Logic::Gates;
        Self::Xor, Self::Xor, "xor" 2 None, false true Logic::Gates;
        Self::Slice { .. }, Self::Slice { lo: 0 }, "slice" 1 None, true true Logic::Wires;
        Self::Concat, Self::Concat, "concat" 2 None, false true Logic::Wires;
        Self::Shift { .. }, Self::Shift { left: 0 }, "shift" 1 None, false false Logic::Wires;
        Self::LeadingZeros, Self::LeadingZeros, "leading_zeros" 1 SHIFTER, false true Logic::Tree;
        Self::ShiftLeft { max }, Self::ShiftLeft { max: 0 }, "shift_left" 2 SHIFTER, false false Logic::Shifter { max };
        Self::Read { table, .. }, READ, "read" 1 Some(Operator::Read), false true Logic::Table { table };
        Self::Modulo, Self::Modulo, "modulo" 1 None, true true Logic::Wires;
        Self::Narrow { round, overflow }, NARROW, "narrow" 1 Some(Operator::Narrow), true false Logic::Narrow { round, overflow };
        Self::Input, Self::Input, "input" 0 None, true false Logic::Wires;
    }

    /// Name in the netlist's text form.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.traits().name
    }

    /// Overflow mode of a `narrow`.
    #[must_use]
    pub const fn overflow(self) -> Option<Overflow> {
        if let Self::Narrow { overflow, .. } = self { Some(overflow) } else { None }
    }

    /// Number of operands.
    #[must_use]
    pub const fn arity(self) -> usize {
        self.traits().arity
    }

    /// The format of the exact result. `asked` is the format that the builder was given, for
    /// the operations that take one (input, const, slice, modulo, narrow).
    ///
    /// # Errors
    /// If the result would be too wide, or the operands don't fit the operation.
    ///
    /// # Panics
    /// If the number of operands is wrong, or `asked` is missing.
    pub fn result_format(
        self,
        of: &[Format],
        asked: Option<Format>,
        tables: &[Table],
    ) -> Result<Format, FormatProblem> {
        assert_eq!(of.len(), self.arity(), "bug: {} has {} operands", self.name(), of.len());
        let asked = || asked.expect("bug: this operation is built with a format");
        let common = |a: Format, b: Format| -> Result<_, FormatProblem> {
            let frac = a.frac_bits().max(b.frac_bits());
            Ok((aligned(a, frac)?, aligned(b, frac)?, frac))
        };
        match self {
            Self::Input => Ok(asked()),
            Self::Const { raw } => {
                expect(asked().contains(raw), &format!("word {raw} is outside {}", asked()))?;
                Ok(asked())
            }
            Self::Add => {
                let ((alo, ahi), (blo, bhi), frac) = common(of[0], of[1])?;
                spanning(alo + blo, ahi + bhi, frac)
            }
            Self::Sub => {
                let ((alo, ahi), (blo, bhi), frac) = common(of[0], of[1])?;
                spanning(alo - bhi, ahi - blo, frac)
            }
            Self::AddSub => {
                expect(of[0] == Format::FLAG, "the first operand is a flag")?;
                let ((alo, ahi), (blo, bhi), frac) = common(of[1], of[2])?;
                spanning(alo + blo.min(-bhi), ahi + bhi.max(-blo), frac)
            }
            Self::Mul => {
                let ((alo, ahi), (blo, bhi)) =
                    (aligned(of[0], of[0].frac_bits())?, aligned(of[1], of[1].frac_bits())?);
                let corners = [alo * blo, alo * bhi, ahi * blo, ahi * bhi];
                let frac = of[0].frac_bits() + of[1].frac_bits();
                expect((-127..=127).contains(&frac), "fraction bits add up past 127")?;
                let lo = corners.into_iter().fold(i128::MAX, i128::min);
                let hi = corners.into_iter().fold(i128::MIN, i128::max);
                spanning(lo, hi, frac)
            }
            Self::Neg => {
                let (lo, hi) = aligned(of[0], of[0].frac_bits())?;
                spanning(-hi, -lo, of[0].frac_bits())
            }
            Self::Abs => {
                let (lo, hi) = aligned(of[0], of[0].frac_bits())?;
                spanning(0, hi.max(-lo), of[0].frac_bits())
            }
            Self::And | Self::Or | Self::Xor => {
                expect(of[0] == of[1], "bitwise operands have one format")?;
                Ok(of[0])
            }
            Self::Equal | Self::Less => {
                common(of[0], of[1])?;
                Ok(Format::FLAG)
            }
            Self::Mux => {
                expect(of[0] == Format::FLAG, "the first operand is a flag")?;
                let ((alo, ahi), (blo, bhi), frac) = common(of[1], of[2])?;
                spanning(alo.min(blo), ahi.max(bhi), frac)
            }
            Self::Slice { lo } => {
                let format = asked();
                expect(
                    !format.is_signed() && format.frac_bits() == 0,
                    "a slice is an unsigned integer",
                )?;
                expect(
                    lo.saturating_add(format.bits()) <= of[0].bits(),
                    &format!(
                        "bits {lo}..{} of a {}-bit word",
                        lo.saturating_add(format.bits()),
                        of[0].bits()
                    ),
                )?;
                Ok(format)
            }
            Self::Concat => {
                let integer = |format: Format| !format.is_signed() && format.frac_bits() == 0;
                expect(integer(of[0]) && integer(of[1]), "unsigned integers are concatenated")?;
                let bits = of[0].bits() + of[1].bits();
                Format::integer(bits).map_err(|_| FormatProblem::TooWide(bits))
            }
            Self::Shift { left } => {
                let frac = of[0].frac_bits().saturating_sub(left);
                expect((-127..=127).contains(&frac), "the binary point moves past 127 places")?;
                Ok(Format::new(of[0].is_signed(), of[0].bits(), frac).expect("bug: checked above"))
            }
            Self::LeadingZeros => {
                expect(!of[0].is_signed(), "leading zeros are counted in unsigned words")?;
                Ok(Format::integer(bit_len(u64::from(of[0].bits()))).expect("bug: at most 6 bits"))
            }
            Self::ShiftLeft { max } => {
                expect(
                    !of[1].is_signed() && of[1].frac_bits() == 0,
                    "a shift count is an unsigned integer",
                )?;
                let bits = of[0].bits().saturating_add(max);
                if bits > Format::MAX_BITS {
                    return Err(FormatProblem::TooWide(bits));
                }
                Ok(Format::new(of[0].is_signed(), bits, of[0].frac_bits()).expect("bug: checked"))
            }
            Self::Read { table, column } => {
                let table = &tables[table.index()];
                expect(
                    of[0] == table.address_format(),
                    &format!("`{}` takes addresses {}", table.name, table.address_format()),
                )?;
                Ok(table.columns[usize::try_from(column).expect("bug: small")].format)
            }
            Self::Modulo => {
                expect(
                    asked().frac_bits() == of[0].frac_bits(),
                    "a residue keeps the fraction bits",
                )?;
                Ok(asked())
            }
            Self::Narrow { .. } => Ok(asked()),
        }
    }

    /// The word of the result, and whether a `narrow` overflowed.
    ///
    /// `of` are the operands' words and formats, `out` is the node's format.
    ///
    /// # Panics
    /// On `Input`: inputs have no meaning of their own.
    #[must_use]
    pub fn eval_raw(self, of: &[(i64, Format)], out: Format, tables: &[Table]) -> (i64, bool) {
        // |operand| < 2^63 and shifts stay below 63 by construction, so i128 holds every step.
        let at = |i: usize, frac: i32| i128::from(of[i].0) << (frac - of[i].1.frac_bits());
        let pair = |a: usize, b: usize| {
            let frac = of[a].1.frac_bits().max(of[b].1.frac_bits());
            (at(a, frac), at(b, frac))
        };
        let flag = |i: usize| of[i].0 != 0;
        let exact = match self {
            Self::Input => panic!("bug: an input has no operation"),
            Self::Const { raw } => i128::from(raw),
            Self::Add => {
                let (a, b) = pair(0, 1);
                a + b
            }
            Self::Sub => {
                let (a, b) = pair(0, 1);
                a - b
            }
            Self::AddSub => {
                let (a, b) = pair(1, 2);
                if flag(0) { a - b } else { a + b }
            }
            Self::Mul => i128::from(of[0].0) * i128::from(of[1].0),
            Self::Neg => -i128::from(of[0].0),
            Self::Abs => i128::from(of[0].0).abs(),
            Self::And => i128::from(of[0].0 & of[1].0),
            Self::Or => i128::from(of[0].0 | of[1].0),
            Self::Xor => i128::from(of[0].0 ^ of[1].0),
            Self::Equal => {
                let (a, b) = pair(0, 1);
                i128::from(a == b)
            }
            Self::Less => {
                let (a, b) = pair(0, 1);
                i128::from(a < b)
            }
            Self::Mux => {
                let (a, b) = pair(1, 2);
                if flag(0) { a } else { b }
            }
            Self::Slice { lo } => {
                i128::from((of[0].1.pattern(of[0].0) >> lo) & ((1 << out.bits()) - 1))
            }
            Self::Concat => i128::from(of[0].0) << of[1].1.bits() | i128::from(of[1].0),
            Self::Shift { .. } => i128::from(of[0].0),
            Self::LeadingZeros => i128::from(of[0].1.bits() - bit_len(of[0].1.pattern(of[0].0))),
            Self::ShiftLeft { max } => i128::from(of[0].0) << of[1].0.min(i64::from(max)),
            Self::Read { table, column } => {
                let column = usize::try_from(column).expect("bug: small");
                i128::from(tables[table.index()].columns[column].words[cast::index_of(of[0].0)])
            }
            Self::Modulo => i128::from(out.wrap(of[0].0)),
            Self::Narrow { round, overflow } => {
                let (raw, overflowed) = narrow(of[0].0, of[0].1.frac_bits(), out, round, overflow);
                return (raw, overflowed);
            }
        };
        let raw = cast::low_i64(exact);
        debug_assert!(
            i128::from(raw) == exact && out.contains(raw),
            "bug: {} gave {exact}, outside {out}",
            self.name()
        );
        (raw, false)
    }

    /// True if the operation has a value on reals; the bit-level ones have none.
    #[must_use]
    pub fn has_real(self, out: Format) -> bool {
        match self {
            Self::Input
            | Self::Const { .. }
            | Self::Add
            | Self::Sub
            | Self::AddSub
            | Self::Mul
            | Self::Neg
            | Self::Abs
            | Self::Equal
            | Self::Less
            | Self::Mux
            | Self::Shift { .. }
            | Self::Modulo
            | Self::Narrow { .. } => true,
            Self::And | Self::Or | Self::Xor => out == Format::FLAG,
            Self::Slice { .. }
            | Self::Concat
            | Self::LeadingZeros
            | Self::ShiftLeft { .. }
            | Self::Read { .. } => false,
        }
    }

    /// The value on reals: exact arithmetic, `narrow` keeps its operand. NaN for an operation
    /// without a value on reals.
    ///
    /// # Panics
    /// On `Input`: inputs have no meaning of their own.
    #[inline(always)]
    #[must_use]
    pub fn eval_real(self, of: [f64; 3], out: Format) -> f64 {
        let flag = |holds: bool| f64::from(u8::from(holds));
        let [a, b, c] = of;
        match self {
            Self::Input => panic!("bug: an input has no operation"),
            Self::Const { raw } => out.value(raw),
            Self::Add => a + b,
            Self::Sub => a - b,
            Self::AddSub => {
                if a != 0.0 {
                    b - c
                } else {
                    b + c
                }
            }
            Self::Mul => a * b,
            Self::Neg => -a,
            Self::Abs => a.abs(),
            Self::And => a * b,
            Self::Or => a.max(b),
            Self::Xor => (a - b).abs(),
            Self::Equal => flag(a == b),
            Self::Less => flag(a < b),
            Self::Mux => {
                if a != 0.0 {
                    b
                } else {
                    c
                }
            }
            Self::Shift { left } => a * 2f64.powi(left),
            Self::Modulo => {
                let span = 2f64.powi(cast::signed_count(out.bits()) - out.frac_bits());
                modulo(a, out.value(out.min_raw()), span)
            }
            Self::Narrow { .. } => a,
            Self::Slice { .. }
            | Self::Concat
            | Self::LeadingZeros
            | Self::ShiftLeft { .. }
            | Self::Read { .. } => f64::NAN,
        }
    }
}
