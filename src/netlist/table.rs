//! Tables, whose words are part of the netlist, and memories, whose words are bound for simulation.

use crate::number::format::Format;
use crate::number::real::Rows;
use std::sync::Arc;

/// One column of a table.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Column {
    /// Name.
    pub name: String,
    /// Format of its words.
    pub format: Format,
    /// One word per address; empty in an unbound memory.
    pub words: Arc<[i64]>,
}

impl Column {
    /// Its words as values; `memory` is the name of its memory.
    pub(super) fn values(&self, memory: &str) -> Rows {
        let values = self.words.iter().map(|word| self.format.value(*word));
        Rows::new(format!("{memory}.{}", self.name), values)
    }
}

/// Columns of words that share an address: a read-only table or a memory.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Table {
    /// Name.
    pub name: String,
    /// Address bits; the table has 2^addr_bits rows.
    pub addr_bits: u32,
    /// Its columns.
    pub columns: Vec<Column>,
    /// Hardware parameters, if it is a memory.
    pub memory: Option<Memory>,
}

/// Hardware parameters of a memory, whose words are stored outside the datapath, such as a scene's
/// map. For each address that it is read at, the datapath has an output port for the address and an
/// input port for each column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Memory {
    /// Cycles from the address to the words.
    pub latency: u32,
}

impl Memory {
    /// Maximum latency.
    pub const MAX_LATENCY: u32 = 64;
}

impl Table {
    /// Maximum address bits.
    pub const MAX_ADDR_BITS: u32 = 30;

    /// A memory without words, from the names and formats of its columns.
    #[must_use]
    pub fn memory(name: &str, addr_bits: u32, columns: &[(&str, Format)], latency: u32) -> Self {
        let column = |(name, format): &(&str, Format)| Column {
            name: (*name).to_owned(),
            format: *format,
            words: Arc::new([]),
        };
        Self {
            name: name.to_owned(),
            addr_bits,
            columns: columns.iter().map(column).collect(),
            memory: Some(Memory { latency }),
        }
    }

    /// Format of an address.
    ///
    /// # Panics
    /// If the table has no address bits or more than 63.
    #[must_use]
    pub fn address_format(&self) -> Format {
        Format::integer(self.addr_bits).expect("bug: table size was checked when it was added")
    }

    /// Stored bits: rows times the width of a row.
    #[must_use]
    pub fn rom_bits(&self) -> u64 {
        let row: u32 = self.columns.iter().map(|column| column.format.bits()).sum();
        u64::from(row) << self.addr_bits
    }

    /// True for a memory that no words are bound to.
    #[must_use]
    pub fn is_unbound(&self) -> bool {
        self.columns.iter().any(|column| column.words.is_empty())
    }

    /// A copy without words, if it is a memory.
    pub(super) fn without_words(&self) -> Self {
        let mut table = self.clone();
        if table.memory.is_some() {
            table.columns.iter_mut().for_each(|column| column.words = Arc::new([]));
        }
        table
    }
}

impl Table {
    /// The first problem if a column doesn't have one word of its format per address.
    pub(super) fn problem_with_words(&self) -> Option<String> {
        let rows = 1usize << self.addr_bits;
        self.columns.iter().find_map(|column| {
            let (name, format) = (&column.name, column.format);
            if column.words.len() != rows {
                let words = column.words.len();
                return Some(format!(
                    "column `{name}` has {words} words and must have one for each of {rows} addresses"
                ));
            }
            let outside = column.words.iter().position(|word| !format.contains(*word))?;
            let (word, lo, hi) = (column.words[outside], format.min_raw(), format.max_raw());
            Some(format!(
                "column `{name}` has word {word} at address {outside}, outside {format} ({lo}..={hi})"
            ))
        })
    }
}
