//! Words and reals: formats with their one rounding, real functions to any precision.

pub mod format;
pub mod function;
pub mod real;
pub mod trig;
