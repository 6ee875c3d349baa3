//! Words and reals: formats with their only rounding, and real functions to any precision.

pub mod format;
pub mod function;
pub mod real;
pub mod trig;
