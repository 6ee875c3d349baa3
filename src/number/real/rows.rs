//! Values at whole numbers: what a memory holds.

use super::interval::Interval;
use crate::base::cast;
use std::fmt;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

/// So many values are gone through for those over an interval; of more, all count.
const MOST: usize = 1 << 12;

/// A function of whole numbers that is told by its values from 0 on and repeats after them. Their number is a power of
/// two. Its value at any number is that at the number rounded down.
#[derive(Clone)]
pub struct Rows(Arc<Held>);

struct Held {
    name: String,
    values: Vec<f64>,
    /// Of all values.
    range: Interval,
    hash: u64,
}

impl Rows {
    /// With a name for listings and its values from 0 on.
    pub(crate) fn new(name: String, values: impl Iterator<Item = f64>) -> Self {
        let values: Vec<f64> = values.collect();
        assert!(values.len().is_power_of_two(), "bug: {} values", values.len());
        let range = hull(&values);
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

    /// The value at a number; NaN at none.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        let values = &self.0.values;
        let count = cast::f64_of_len(values.len());
        // Exact, as the count is a power of two.
        let place = x.floor() - count * (x.floor() / count).floor();
        if place.is_nan() { f64::NAN } else { values[cast::index_of(cast::i64_of(place))] }
    }

    /// The values at the numbers of an interval.
    pub(super) fn between(&self, x: Interval) -> Interval {
        let values = &self.0.values;
        let (first, last) = (x.lo.floor(), x.hi.floor());
        let steps = last - first;
        // Where whole numbers can't be told apart, or are too many, any value may be meant.
        let few = steps < cast::f64_of_len(values.len().min(MOST));
        if !few || first.abs().max(last.abs()) > 2f64.powi(52) {
            return self.0.range;
        }
        let steps = cast::i64_of(steps);
        let all: Vec<f64> = (0..=steps).map(|step| self.at(first + cast::f64_of(step))).collect();
        hull(&all)
    }
}

fn hull(values: &[f64]) -> Interval {
    let lo = values.iter().copied().fold(f64::INFINITY, f64::min);
    let hi = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Interval { lo, hi }
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
