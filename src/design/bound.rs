//! Stated bounds on errors.

use super::unit::Values;
use std::fmt;
use std::sync::Arc;

/// A bound computed from the parameters and the exact worst error of each table scheme, by name.
pub type BoundFn = dyn Fn(&Values, &dyn Fn(&str) -> f64) -> f64 + Send + Sync;

/// A stated bound on the error against the golden of the quantised inputs.
#[derive(Clone)]
pub struct Bound {
    /// What is bounded, in a few words: they complete "stated bound on each …".
    pub what: String,
    /// The quantities that it bounds, by their names in reports.
    pub quantities: Vec<String>,
    /// The bound, in the unit of those quantities.
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

/// The error bounds that a design states.
#[derive(Clone, Debug)]
pub enum Bounds {
    /// These bounds.
    Stated(Vec<Bound>),
    /// These bounds, for the described inputs only.
    Within(String, Vec<Bound>),
    /// No bound, and why.
    Unstated(String),
}

impl Bounds {
    /// The stated bounds.
    #[must_use]
    pub fn stated(&self) -> &[Bound] {
        match self {
            Self::Stated(bounds) | Self::Within(_, bounds) => bounds,
            Self::Unstated(_) => &[],
        }
    }

    /// No bound, and why.
    #[must_use]
    pub fn unstated(why: impl Into<String>) -> Self {
        Self::Unstated(why.into())
    }
}
