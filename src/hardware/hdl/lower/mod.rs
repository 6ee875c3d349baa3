//! Lowers nodes and registers to words of plain bits. This is the only place where an operation
//! becomes logic, for every language.
//!
//! All arithmetic is modulo 2^n for a result of n bits, on operands extended to n bits. Formats
//! hold every exact result, so no language's own rules for signs and widths matter.
//!
//! A flat pipeline is the sequence of its stages. A time-shared one first has the phase counter and
//! the declarations of words that are used before they are driven (hold registers and results of
//! units), and after the stages each unit: multiplexers, its own stages, results. Its hold
//! registers load in their phase. All of it consists of stages and registers; a flat pipeline has
//! no phase.

mod logic;
mod narrow;
mod options;
mod phases;
mod stages;
mod tables;
mod words;

pub use options::{AUTO_INLINE_ROWS, INLINE_ROWS, Options, TABLE_BITS, WORDS};
