//! Real expressions: the meaning of nodes, tables and golden models.
//!
//! An [`Expr`] is a graph of [`Primitive`]s over constants and numbered variables, without
//! duplicate terms. It can be evaluated in several ways, each of which defines the primitives on
//! its own type of value ([`Reading`]):
//!
//! - [`Twin`]: `f64` with the functions of [`trig`](super::trig), bit for bit as evaluation in
//!   blocks;
//! - [`Scalar`]: `f64` with the crate `libm`, one value at a time, the starting point of tables;
//! - [`Outward`]: intervals rounded outward, which contain every value for their operands;
//! - [`Precise`]: any number of bits, from which table words are rounded.
//!
//! Angles are in turns, so that their reduction is exact: the sine of ½ is 0 and not 1.2e-16.
//!
//! A [`Function`] is a named expression of one variable. [`Rows`] are a function given by its
//! values.

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
