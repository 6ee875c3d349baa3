//! The operations of a datapath, each with a single definition.
//!
//! Every operation is exact: its result format holds every result that its operands' formats allow.
//! Only [`Op::Narrow`] rounds, saturates or wraps. For each operation this module gives the result
//! format ([`Op::result_format`]), the value on words ([`Op::eval_raw`]) and the value on reals
//! ([`Op::reading`]). The engines and the emitted hardware implement the same functions and are
//! tested against these.

use super::id::TableId;
use super::table::Table;
use crate::base::cast;
use crate::number::format::{Format, Overflow, Round, bit_len, narrow};
use crate::number::real::{Graph, Primitive, TermId};

/// An operation; the node holds the operands.
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
    /// `a - b` where the flag is set, otherwise `a + b`; operands flag, a, b. One adder/subtractor.
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
    /// `a` where the flag is set, otherwise `b`; operands flag, a, b.
    Mux,
    /// Bits from `lo` up of the word's pattern, as an unsigned integer; the node's format gives
    /// their number.
    Slice {
        /// Lowest bit taken.
        lo: u32,
    },
    /// The bits of integer a above the bits of integer b.
    Concat,
    /// `a * 2^left`: only the binary point moves.
    Shift {
        /// Places to the left; negative is to the right.
        left: i32,
    },
    /// The number of zero bits above the highest one bit of an unsigned word.
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
    /// `a` of `samples` accepted samples earlier; 0 if there was no such sample since the reset.
    Delay {
        /// Number of samples, at least 1.
        samples: u32,
    },
    /// The residue of `a` in the node's format, modulo that format's span. It is exact in modular
    /// arithmetic, so angles in turns use it where `narrow` would count a wrap as an overflow.
    Modulo,
    /// `a` in the node's format; the only operation that loses bits.
    Narrow {
        /// How low bits are rounded.
        round: Round,
        /// How values outside the format are handled.
        overflow: Overflow,
    },
}

/// Why an operation has no result format.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum FormatProblem {
    /// The exact result would need this many bits.
    TooWide(u32),
    /// The operands don't fit the operation.
    Mismatch(String),
}

/// The range of a format's words, scaled to `frac_bits` fraction bits (at least its own).
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

/// Properties of an operation for counting, printing, sharing and timing.
#[derive(Clone, Copy, Debug)]
pub struct Traits {
    /// Name in the netlist's text form.
    pub name: &'static str,
    /// Number of operands.
    pub arity: usize,
    /// How it is counted.
    pub operator: Option<Operator>,
    /// True if it is built with a format; otherwise its format follows from its operands.
    pub takes_format: bool,
    /// True if it works on bit patterns and not on values.
    pub looks_at_bits: bool,
    /// The logic that determines its delay.
    pub logic: Logic,
}

/// Kinds of operators that are counted.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Operator {
    /// A multiplier.
    Multiplier,
    /// An adder or subtractor.
    Adder,
    /// A sign change.
    Negation,
    /// A comparison.
    Comparator,
    /// A multiplexer.
    Multiplexer,
    /// A barrel shifter, or a leading-zero counter for one.
    Shifter,
    /// A change of format.
    Narrow,
    /// A word read from a table.
    Read,
}

/// The logic that determines an operation's delay.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Logic {
    /// Nothing: wires.
    Wires,
    /// One level of gates.
    Gates,
    /// A carry chain over the result.
    Carry,
    /// A carry chain over the wider operand.
    Comparison,
    /// The rows of a product.
    Product,
    /// A tree over the operand's bits.
    Tree,
    /// A tree over the shift amounts.
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
        /// How low bits are rounded.
        round: Round,
        /// How values outside the format are handled.
        overflow: Overflow,
    },
}

/// One row per operation: its pattern, an example, and its traits.
macro_rules! operations {
    ($($op:pat, $one:expr, $name:literal $arity:literal $operator:expr, $takes_format:literal $looks_at_bits:literal $logic:expr;)*) => {
        /// One operation of each kind.
        pub const ALL: &'static [Self] = &[$($one),*];

        /// Its properties besides its meaning.
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
    /// Maximum delay in samples.
    pub const MAX_DELAY: u32 = 4096;

    // pattern, example, name, operands, how it is counted, takes a format, looks at bits, logic
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
        Self::Delay { .. }, Self::Delay { samples: 1 }, "delay" 1 None, false false Logic::Wires;
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

    /// The format of the exact result. `asked` is the format given to the builder, for the
    /// operations that take one (input, const, slice, modulo, narrow).
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
                expect(of[0] == Format::FLAG, "the first operand must be a flag")?;
                let ((alo, ahi), (blo, bhi), frac) = common(of[1], of[2])?;
                spanning(alo + blo.min(-bhi), ahi + bhi.max(-blo), frac)
            }
            Self::Mul => {
                let ((alo, ahi), (blo, bhi)) =
                    (aligned(of[0], of[0].frac_bits())?, aligned(of[1], of[1].frac_bits())?);
                let corners = [alo * blo, alo * bhi, ahi * blo, ahi * bhi];
                let frac = of[0].frac_bits() + of[1].frac_bits();
                expect(
                    (-127..=127).contains(&frac),
                    "the sum of the fraction bits is outside -127 to 127",
                )?;
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
                expect(of[0] == of[1], "bitwise operands must have the same format")?;
                Ok(of[0])
            }
            Self::Equal | Self::Less => {
                common(of[0], of[1])?;
                Ok(Format::FLAG)
            }
            Self::Mux => {
                expect(of[0] == Format::FLAG, "the first operand must be a flag")?;
                let ((alo, ahi), (blo, bhi), frac) = common(of[1], of[2])?;
                spanning(alo.min(blo), ahi.max(bhi), frac)
            }
            Self::Slice { lo } => {
                let format = asked();
                expect(
                    !format.is_signed() && format.frac_bits() == 0,
                    "a slice must be an unsigned integer",
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
                expect(
                    integer(of[0]) && integer(of[1]),
                    "only unsigned integers can be concatenated",
                )?;
                let bits = of[0].bits() + of[1].bits();
                Format::integer(bits).map_err(|_| FormatProblem::TooWide(bits))
            }
            Self::Shift { left } => {
                let frac = of[0].frac_bits().saturating_sub(left);
                expect((-127..=127).contains(&frac), "the binary point moves past 127 places")?;
                Ok(Format::new(of[0].is_signed(), of[0].bits(), frac).expect("bug: checked above"))
            }
            Self::LeadingZeros => {
                expect(!of[0].is_signed(), "leading zeros can only be counted in unsigned words")?;
                Ok(Format::integer(bit_len(u64::from(of[0].bits()))).expect("bug: at most 6 bits"))
            }
            Self::ShiftLeft { max } => {
                expect(
                    !of[1].is_signed() && of[1].frac_bits() == 0,
                    "a shift count must be an unsigned integer",
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
                    &format!(
                        "`{}` takes addresses in format {}",
                        table.name,
                        table.address_format()
                    ),
                )?;
                Ok(table.columns[usize::try_from(column).expect("bug: small")].format)
            }
            Self::Delay { samples } => {
                expect(
                    (1..=Self::MAX_DELAY).contains(&samples),
                    &format!("{samples} samples: legal is 1 to {}", Self::MAX_DELAY),
                )?;
                Ok(of[0])
            }
            Self::Modulo => {
                expect(
                    asked().frac_bits() == of[0].frac_bits(),
                    "a residue must keep the fraction bits",
                )?;
                Ok(asked())
            }
            Self::Narrow { .. } => Ok(asked()),
        }
    }

    /// The word of the result, and whether a `narrow` overflowed.
    ///
    /// `of` holds the operands' words and formats, `out` is the node's format.
    ///
    /// # Panics
    /// On `Input`, which has no operation.
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
            // For an independent sample: there was none before.
            Self::Delay { .. } => 0,
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

    /// The operation on reals, as a term of its operands' terms, in exact arithmetic; `narrow`
    /// returns its operand. `None` for operations on bits, which have no value on reals.
    ///
    /// # Panics
    /// On `Input`: ports are variables.
    #[must_use]
    pub fn reading(self, graph: &mut Graph, of: &[TermId], out: Format) -> Option<TermId> {
        let flags = out == Format::FLAG;
        Some(match self {
            Self::Input => panic!("bug: an input has no operation"),
            Self::Const { raw } => graph.constant(out.value(raw)),
            Self::Add => graph.of(Primitive::Add, of),
            Self::Sub => graph.of(Primitive::Sub, of),
            Self::AddSub => {
                let difference = graph.of(Primitive::Sub, &of[1..]);
                let sum = graph.of(Primitive::Add, &of[1..]);
                graph.of(Primitive::Select, &[of[0], difference, sum])
            }
            Self::Mul => graph.of(Primitive::Mul, of),
            Self::Neg => graph.of(Primitive::Neg, of),
            Self::Abs => graph.of(Primitive::Abs, of),
            Self::And if flags => graph.of(Primitive::Mul, of),
            Self::Or if flags => graph.of(Primitive::Max, of),
            Self::Xor if flags => {
                let difference = graph.of(Primitive::Sub, of);
                graph.of(Primitive::Abs, &[difference])
            }
            Self::Equal => graph.of(Primitive::Equal, of),
            Self::Less => graph.of(Primitive::Less, of),
            Self::Mux => graph.of(Primitive::Select, of),
            Self::Shift { left } => {
                let factor = graph.constant(2f64.powi(left));
                graph.of(Primitive::Mul, &[of[0], factor])
            }
            Self::Modulo => {
                let low = graph.constant(out.value(out.min_raw()));
                let span = 2f64.powi(cast::signed_count(out.bits()) - out.frac_bits());
                let span = graph.constant(span);
                graph.of(Primitive::Modulo, &[of[0], low, span])
            }
            Self::Narrow { .. } => of[0],
            Self::And
            | Self::Or
            | Self::Xor
            | Self::Slice { .. }
            | Self::Concat
            | Self::LeadingZeros
            | Self::ShiftLeft { .. }
            | Self::Read { .. }
            | Self::Delay { .. } => return None,
        })
    }
}
