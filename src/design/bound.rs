//! Stated bounds on errors.

use super::unit::Values;
use std::fmt;
use std::sync::Arc;

/// A bound from parameters and the exact worst error of each table scheme by its name.
pub type BoundFn = dyn Fn(&Values, &dyn Fn(&str) -> f64) -> f64 + Send + Sync;

/// A stated bound on the error against the golden of the quantised inputs.
#[derive(Clone)]
pub struct Bound {
    /// What is bounded, in a word.
    pub what: String,
    /// The quantities that it holds for, by their names in reports.
    pub quantities: Vec<String>,
    /// The bound, in the unit of those.
    pub bound: Arc<BoundFn>,
}

impl Bound {
    /// A bound on some quantities, by their names in reports.
    #[must_use]
    pub fn new<N: AsRef<str>>(
        what: impl Into<String>,
        quantities: impl IntoIterator<Item = N>,
        bound: impl Fn(&Values, &dyn Fn(&str) -> f64) -> f64 + Send + Sync + 'static,
    ) -> Self {
        let quantities = quantities.into_iter().map(|name| name.as_ref().to_owned());
        Self { what: what.into(), quantities: quantities.collect(), bound: Arc::new(bound) }
    }
}

impl fmt::Debug for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.what)
    }
}

/// What a design promises of its errors.
#[derive(Clone, Debug)]
pub enum Bounds {
    /// These.
    Stated(Vec<Bound>),
    /// These, for such inputs only.
    Within(String, Vec<Bound>),
    /// Nothing, and why.
    Unstated(String),
}

impl Bounds {
    /// Those that are stated.
    #[must_use]
    pub fn stated(&self) -> &[Bound] {
        match self {
            Self::Stated(bounds) | Self::Within(_, bounds) => bounds,
            Self::Unstated(_) => &[],
        }
    }

    /// None, and why.
    #[must_use]
    pub fn unstated(why: impl Into<String>) -> Self {
        Self::Unstated(why.into())
    }
}
