//! Functions given by values at whole numbers: the content of a memory.

use crate::base::cast;
use std::fmt;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

/// A function given by its values at 0, 1, 2 and so on, which repeat after the last. Their number
/// is a power of two. At other numbers its value is that at the number rounded down.
#[derive(Clone)]
pub struct Rows(Arc<Held>);

struct Held {
    name: String,
    values: Vec<f64>,
    /// Smallest and largest value.
    range: (f64, f64),
    hash: u64,
}

impl Rows {
    /// Makes rows from a name for listings and the values from 0 on.
    pub(crate) fn new(name: String, values: impl Iterator<Item = f64>) -> Self {
        let values: Vec<f64> = values.collect();
        assert!(values.len().is_power_of_two(), "bug: {} values", values.len());
        let range = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), value| {
            (lo.min(*value), hi.max(*value))
        });
        let mut hasher = DefaultHasher::new();
        name.hash(&mut hasher);
        values.iter().for_each(|value| value.to_bits().hash(&mut hasher));
        Self(Arc::new(Held { name, values, range, hash: hasher.finish() }))
    }

    /// Name in listings.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.0.name
    }

    /// The value at `x`; NaN unless `x` is finite.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        let values = &self.0.values;
        let count = cast::f64_of_len(values.len());
        // Exact, since the count is a power of two.
        let place = x.floor() - count * (x.floor() / count).floor();
        if place.is_nan() { f64::NAN } else { values[cast::index_of(cast::i64_of(place))] }
    }

    /// Number of values before they repeat.
    #[must_use]
    pub fn count(&self) -> usize {
        self.0.values.len()
    }

    /// The smallest and the largest value.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        self.0.range
    }
}

impl fmt::Debug for Rows {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {} values", self.0.name, self.0.values.len())
    }
}

impl PartialEq for Rows {
    fn eq(&self, other: &Self) -> bool {
        let bits =
            |rows: &Self| rows.0.values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        Arc::ptr_eq(&self.0, &other.0)
            || self.0.hash == other.0.hash
                && self.0.name == other.0.name
                && bits(self) == bits(other)
    }
}

impl Eq for Rows {}

impl Hash for Rows {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.hash.hash(state);
    }
}
