//! From nodes and registers to words of plain bits: the one place where an operation becomes
//! logic, for every language.
//!
//! All arithmetic is modulo two to the bits of the result, on operands that are extended to
//! them: with formats that hold every result that is exact, and no language's own rules of
//! signs and widths come into play.
//!
//! A flat pipeline is its stages, one after the other. A time-shared one has before them the
//! phase counter and the declarations of what is used before it is driven (hold registers and
//! results of units), and after them each unit: multiplexers, its own stages, results. Its hold
//! registers load in their phase. All of it is stages and registers; a flat pipeline has no phase.

mod logic;
mod narrow;
mod options;
mod phases;
mod stages;
mod tables;
mod words;

pub use options::{AUTO_INLINE_ROWS, INLINE_ROWS, Options, TABLE_BITS, WORDS};
