//! Sets of words, as a few intervals.

use crate::base::cast;
use crate::number::format::{Format, word_mask};
use std::fmt;

/// A set of words that a port or a node can hold. It has at least one word, in at most
/// [`Words::MAX_INTERVALS`] intervals; if more would be needed, the smallest gaps are filled.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Words(Vec<(i64, i64)>);

impl Words {
    /// Maximum number of intervals.
    pub const MAX_INTERVALS: usize = 8;

    /// The words `lo..=hi`.
    ///
    /// # Panics
    /// If there are none.
    #[must_use]
    pub fn between(lo: i64, hi: i64) -> Self {
        Self::of([(lo, hi)])
    }

    /// One word.
    #[must_use]
    pub fn only(raw: i64) -> Self {
        Self(vec![(raw, raw)])
    }

    /// Every word of a format.
    #[must_use]
    pub fn all(format: Format) -> Self {
        Self(vec![(format.min_raw(), format.max_raw())])
    }

    /// The words of several intervals `lo..=hi`, in any order.
    ///
    /// # Panics
    /// If an interval is empty, or there is none.
    #[must_use]
    pub fn of(intervals: impl IntoIterator<Item = (i64, i64)>) -> Self {
        let mut intervals: Vec<(i64, i64)> = intervals.into_iter().collect();
        assert!(!intervals.is_empty(), "bug: a set of words has a word");
        intervals.sort_unstable();
        let mut joined: Vec<(i64, i64)> = Vec::with_capacity(intervals.len());
        for (lo, hi) in intervals {
            assert!(lo <= hi, "bug: empty interval {lo}..={hi}");
            match joined.last_mut() {
                Some(last) if lo <= last.1.saturating_add(1) => last.1 = last.1.max(hi),
                Some(_) | None => joined.push((lo, hi)),
            }
        }
        while joined.len() > Self::MAX_INTERVALS {
            let gap = |i: &usize| joined[*i].0.abs_diff(joined[*i - 1].1);
            let least = (1..joined.len()).min_by_key(gap).expect("bug: several intervals");
            joined[least - 1].1 = joined[least].1;
            joined.remove(least);
        }
        Self(joined)
    }

    /// The part of several intervals that lies within a format.
    pub(crate) fn in_format(intervals: &[(i128, i128)], format: Format) -> Self {
        let (min, max) = (i128::from(format.min_raw()), i128::from(format.max_raw()));
        let inside = intervals.iter().filter(|(lo, hi)| *lo <= max && *hi >= min);
        Self::of(
            inside.map(|(lo, hi)| (cast::low_i64(*lo.max(&min)), cast::low_i64(*hi.min(&max)))),
        )
    }

    /// The intervals, in order, with at least one missing word between two of them.
    #[must_use]
    pub fn intervals(&self) -> &[(i64, i64)] {
        &self.0
    }

    /// The least word.
    #[must_use]
    pub fn lo(&self) -> i64 {
        self.0[0].0
    }

    /// The greatest word.
    #[must_use]
    pub fn hi(&self) -> i64 {
        self.0[self.0.len() - 1].1
    }

    /// The word, if there is only one.
    #[must_use]
    pub fn constant(&self) -> Option<i64> {
        (self.lo() == self.hi()).then(|| self.lo())
    }

    /// True if the word is in the set.
    #[must_use]
    pub fn contains(&self, raw: i64) -> bool {
        self.0.iter().any(|(lo, hi)| (*lo..=*hi).contains(&raw))
    }

    /// The union of both sets.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        Self::of(self.0.iter().chain(&other.0).copied())
    }

    /// The smallest number of low bits that distinguish all words of the set, which are addresses
    /// of `addr_bits` bits.
    pub(crate) fn telling_bits(&self, addr_bits: u32) -> u32 {
        let told_apart = |bits: u32| {
            let format = Format::integer(bits).expect("bug: fewer than an address has");
            let mut slots: Vec<(i128, i128)> = Vec::new();
            for (lo, hi) in &self.0 {
                if hi - lo > word_mask(bits) {
                    return false;
                }
                slots.extend(wrapped((*lo).into(), (*hi).into(), format));
            }
            slots.sort_unstable();
            slots.windows(2).all(|pair| pair[0].1 < pair[1].0)
        };
        (1..addr_bits).find(|bits| told_apart(*bits)).unwrap_or(addr_bits)
    }
}

impl fmt::Display for Words {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (lo, hi)) in self.0.iter().enumerate() {
            let comma = if i == 0 { "" } else { ", " };
            match lo == hi {
                true => write!(f, "{comma}{lo}")?,
                false => write!(f, "{comma}{lo}..={hi}")?,
            }
        }
        Ok(())
    }
}

/// The whole numbers `lo..=hi` modulo the span of a format: one interval or two.
pub(crate) fn wrapped(lo: i128, hi: i128, format: Format) -> Vec<(i128, i128)> {
    let (min, max) = (i128::from(format.min_raw()), i128::from(format.max_raw()));
    let span = max - min + 1;
    if hi - lo >= span - 1 {
        return vec![(min, max)];
    }
    let first = min + (lo - min).rem_euclid(span);
    let last = first + (hi - lo);
    if last <= max { vec![(first, last)] } else { vec![(first, max), (min, last - span)] }
}
