//! Stated bounds on errors.

use super::unit::Values;
use std::fmt;

/// A bound from parameters and the exact worst error of each table scheme by its name.
pub type BoundFn = fn(&Values, &dyn Fn(&str) -> f64) -> f64;

/// A stated bound on the error against the golden of the quantised inputs.
#[derive(Clone, Copy)]
pub struct Bound {
    /// What is bounded, in a word.
    pub what: &'static str,
    /// The quantities that it holds for, by their names in reports.
    pub quantities: &'static [&'static str],
    /// The bound, in the unit of those.
    pub bound: BoundFn,
}

impl fmt::Debug for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.what)
    }
}

/// What a design promises of its errors.
#[derive(Clone, Debug)]
pub enum Bounds {
    /// These.
    Stated(Vec<Bound>),
    /// These, for such inputs only.
    Within(&'static str, Vec<Bound>),
    /// Nothing, and why.
    Unstated(&'static str),
}
