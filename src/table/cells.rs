//! The division of an argument's words into cells, and code that all schemes share.

use crate::base::cast;
use crate::netlist::{Builder, Column, NodeId, Table, TableId};
use crate::number::format::{Format, Round, word_mask};
use crate::number::function::{Combination, Function};
use quick_cache::Weighter;
use quick_cache::sync::Cache;
use rayon::prelude::*;
use std::sync::{Arc, LazyLock};

/// Extra fraction bits of words that are summed.
const SUM_GUARD_BITS: i32 = 2;

/// A scheme, as its file defines it.
pub(super) struct Definition {
    /// Name on the command line and in files.
    pub(super) name: &'static str,
    /// False if the cells leave the scheme nothing to do; the direct scheme then replaces it.
    pub(super) applies: fn(&Cells<'_>) -> bool,
    /// The columns of its tables, with the suffix of each table's name.
    pub(super) tables: fn(&Cells<'_>) -> Tables,
    /// The nodes that read the tables for one of the functions, given by its position.
    pub(super) emit: fn(&mut Builder, &Cells<'_>, &[TableId], usize, NodeId) -> NodeId,
    /// See [`Scheme::balanced_int_bits`](super::Scheme::balanced_int_bits).
    pub(super) balanced_int_bits: fn(u32) -> u32,
}

/// Columns of tables, with the suffix of each table's name.
pub(super) type Tables = Vec<(&'static str, Vec<Column>)>;

/// Tabulated functions, and the words of their argument divided into cells. Each cell has an
/// address.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cells<'a> {
    /// Name of the table.
    pub(super) name: &'a str,
    pub(super) functions: &'a [Function],
    /// Value of the argument's word 0.
    pub(super) origin: f64,
    pub(super) output: Format,
    /// Rounding of sums.
    pub(super) round: Round,
    pub(super) argument: Format,
    pub(super) addr_bits: u32,
    /// Bits of the position inside a cell.
    pub(super) cell_bits: u32,
}

impl Cells<'_> {
    /// Bits of the argument.
    pub(super) fn bits(&self) -> u32 {
        self.argument.bits()
    }

    /// Fraction bits of words that are summed.
    pub(super) fn sum_frac(&self) -> i32 {
        self.output.frac_bits() + SUM_GUARD_BITS
    }

    /// Computes a word for each address.
    pub(super) fn each(&self, word: &(dyn Fn(i64) -> i64 + Sync)) -> Vec<i64> {
        (0..1i64 << self.addr_bits).into_par_iter().map(word).collect()
    }

    /// Value of the word whose pattern is `pattern`.
    fn at(&self, pattern: i64) -> f64 {
        self.origin + self.argument.value(self.argument.wrap(pattern))
    }

    /// Value `words` after the start of cell `i` of 2^bits words, without wrapping at the end.
    pub(super) fn after(&self, i: i64, bits: u32, words: i64) -> f64 {
        self.at(i << bits) + cast::f64_of(words) * self.argument.ulp()
    }

    /// First and last value of cell `i`.
    pub(super) fn ends(&self, i: i64) -> (f64, f64) {
        (self.after(i, self.cell_bits, 0), self.after(i, self.cell_bits, word_mask(self.cell_bits)))
    }

    /// True if the function saturates within the `2^bits` words from cell `i`, or has a pole there.
    /// A line through such words could have the wrong sign where the function is small. One ulp
    /// beyond the range is only rounding, such as 1.0 in a format without it.
    fn saturates(&self, function: &Function, i: i64, bits: u32) -> bool {
        let ((lo, hi), ulp) = (range(self.output), self.output.ulp());
        [0, word_mask(bits), 1 << bits].into_iter().any(|words| {
            let value = function.eval(self.after(i, bits, words));
            value < lo - ulp || value > hi + ulp
        })
    }

    /// Terms of the rise of the function over the `2^bits` words from cell `i`; weights are 0 if it
    /// saturates.
    pub(super) fn rise(&self, function: &Function, i: i64, bits: u32) -> [(f64, f64); 2] {
        let weight = if self.saturates(function, i, bits) { 0.0 } else { 1.0 };
        [(-weight, self.after(i, bits, 0)), (weight, self.after(i, bits, 1 << bits))]
    }

    /// The tables of a scheme.
    pub(super) fn tables(&self, scheme: &'static Definition) -> Vec<Table> {
        let key = Key {
            functions: self.functions.to_vec(),
            scheme: scheme.name,
            addr_bits: self.addr_bits,
            origin_bits: self.origin.to_bits(),
            formats: [self.argument, self.output],
        };
        let parts = BUILT.get(&key).unwrap_or_else(|| {
            let parts: Parts = (scheme.tables)(self).into();
            BUILT.insert(key, Arc::clone(&parts));
            parts
        });
        let table = |(end, columns): &(&str, Vec<Column>)| Table {
            name: format!("{}{end}", self.name),
            addr_bits: self.addr_bits,
            columns: columns.clone(),
            memory: None,
        };
        parts.iter().map(table).collect()
    }
}

/// Everything that defines the words of a table.
#[derive(PartialEq, Eq, Hash)]
struct Key {
    functions: Vec<Function>,
    scheme: &'static str,
    addr_bits: u32,
    origin_bits: u64,
    formats: [Format; 2],
}

/// Columns of each table of a scheme, with the suffix of the table's name.
type Parts = Arc<[(&'static str, Vec<Column>)]>;

/// Tables built so far: a sweep asks for the same ones repeatedly. No lock is held while a table is
/// built, so rows are built in parallel.
static BUILT: LazyLock<Cache<Key, Parts, Words>> =
    LazyLock::new(|| Cache::with_weighter(1024, BUILT_WORDS, Words));
/// Number of words that are kept; the cache evicts the least used.
const BUILT_WORDS: u64 = 1 << 24;

/// Weighs tables by their words.
#[derive(Clone)]
struct Words;

impl Weighter<Key, Parts> for Words {
    fn weight(&self, _: &Key, parts: &Parts) -> u64 {
        let columns = parts.iter().flat_map(|(_, columns)| columns);
        columns.map(|column| cast::count_of(column.words.len())).sum::<u64>().max(1)
    }
}

/// A combination of two function values that owns its terms. Its constant is an `f64`, hence
/// rounded if it needs more than 53 bits.
pub(super) struct Entry<'a> {
    pub(super) function: &'a Function,
    pub(super) terms: [(f64, f64); 2],
    pub(super) constant: f64,
    pub(super) range: (f64, f64),
}

impl Entry<'_> {
    pub(super) fn round(&self, frac_bits: i32) -> i64 {
        let Self { function, ref terms, constant, range } = *self;
        Combination { function, terms, constant, range }.round(frac_bits)
    }
}

/// A column in the smallest format that holds its words.
pub(super) fn column(name: String, words: Vec<i64>, frac_bits: i32) -> Column {
    let lo = words.iter().copied().min().expect("bug: tables have entries");
    let hi = words.iter().copied().max().expect("bug: tables have entries");
    let format = Format::spanning(i128::from(lo), i128::from(hi), frac_bits);
    Column { name, format: format.expect("bug: entries are words"), words: Arc::from(words) }
}

/// The least and the greatest value of a format.
pub(super) fn range(format: Format) -> (f64, f64) {
    (format.value(format.min_raw()), format.value(format.max_raw()))
}

/// The word of a format nearest to a combination.
pub(super) fn entry(combination: &Combination<'_>, format: Format) -> i64 {
    combination.round(format.frac_bits()).clamp(format.min_raw(), format.max_raw())
}
