//! Read-only tables of a netlist.

use crate::number::format::Format;
use std::sync::Arc;

/// One column of a table.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Column {
    /// Name.
    pub name: String,
    /// Format of its words.
    pub format: Format,
    /// One word per address.
    pub words: Arc<[i64]>,
}

/// A read-only table: columns of words that share an address.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Table {
    /// Name.
    pub name: String,
    /// Address bits; it has 2^addr_bits rows.
    pub addr_bits: u32,
    /// Its columns.
    pub columns: Vec<Column>,
}

impl Table {
    /// The most address bits.
    pub const MAX_ADDR_BITS: u32 = 30;

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
}
