//! Expressions over the reals: what nodes, tables and goldens stand for.
//!
//! An [`Expr`] is a graph of [`Primitive`]s over constants and numbered variables, in which no term
//! stands twice. It has one meaning and several readings, each of which says what a primitive does
//! with values of its own ([`Reading`]):
//!
//! - [`Twin`], `f64` by the kernels of [`trig`](super::trig): what evaluation in blocks gives, bit for bit;
//! - [`Scalar`], `f64` by the crate `libm`, one value at a time, which tables start from;
//! - [`Outward`], intervals rounded outward, which hold every value of their operands;
//! - [`Precise`], to any number of bits, from which words of tables are rounded.
//!
//! Angles are in turns, so that their reduction is exact: the sine of ½ is 0 and not 1.2e-16.
//!
//! A [`Function`] is an expression of one variable with a name; [`Rows`] are one that is told by
//! its values.

mod expr;
mod interval;
mod precise;
mod primitive;
mod rows;
mod scalar;
#[cfg(test)]
mod tests;
mod text;

pub use expr::{Expr, Function, Graph, Kernel, Number, Reading, Term, TermId};
pub use interval::{Interval, Outward};
pub use precise::{Big, Precise};
pub use primitive::Primitive;
pub use rows::Rows;
pub use scalar::{Scalar, Twin, cos_turns, sin_turns};
pub use text::ParseError;

pub(crate) use primitive::modulo;
