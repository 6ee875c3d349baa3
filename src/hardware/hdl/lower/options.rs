//! What may be asked of a module, and how large one may be.

use crate::base::error::{Error, Result};
use crate::hardware::hdl::module::{Memories, Tables};
use crate::hardware::hdl::names;
use crate::hardware::rtl::Rtl;

/// The most table rows that a module holds in line: more belong into files.
pub const INLINE_ROWS: u64 = 1 << 16;
/// Up to this many table rows are in line if nothing else was asked for.
pub const AUTO_INLINE_ROWS: u64 = 1 << 12;
/// The most bits in the tables of a module, in line or in files.
pub const TABLE_BITS: u64 = 1 << 28;
/// The most words (wires and registers) of a module.
pub const WORDS: usize = 1 << 16;

/// What to emit.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Name of the module; the unit's if `None`.
    pub name: Option<String>,
    /// Where the words of tables stand; by their number if `None`.
    pub tables: Option<Tables>,
    /// Where the words of memories stand.
    pub memories: Memories,
    /// Lines for the head of each file: parameters, figures.
    pub header: Vec<String>,
}

/// Refuses a name that some tool would stumble over.
pub(super) fn check_name(name: &str) -> Result<()> {
    if !crate::base::name::is_legal(name) {
        return Err(Error::form(name, &format!("my_module: {}", crate::base::name::RULE)));
    }
    if names::is_reserved(name) {
        return Err(Error::usage(format!(
            "`{name}` is a word of Verilog, VHDL or their tools, or a port of every module: choose another name"
        )));
    }
    Ok(())
}

pub(super) fn refuse_size(what: &str, given: u64, limit: u64, remedy: &str) -> Error {
    Error::usage(format!("the module would have {given} {what} and {limit} is the most: {remedy}"))
}

/// Bits in the tables of a netlist, in words that fit any table.
fn rom_bits(rtl: &Rtl) -> u64 {
    rtl.netlist().roms().map(crate::netlist::Table::rom_bits).sum()
}

fn rows(rtl: &Rtl) -> u64 {
    rtl.netlist().roms().map(|table| 1u64 << table.addr_bits).sum()
}

/// Where a module's table rows go, and whether it is small enough.
pub(super) fn place_tables(rtl: &Rtl, asked: Option<Tables>, memories: Memories) -> Result<Tables> {
    let ram_bits: u64 = rtl.netlist().memories().map(crate::netlist::Table::rom_bits).sum();
    if memories == Memories::Ram && ram_bits > TABLE_BITS {
        let remedy = "leave memories outside, at ports";
        return Err(refuse_size("bits of RAM", ram_bits, TABLE_BITS, remedy));
    }
    let (rows, bits) = (rows(rtl), rom_bits(rtl));
    if bits > TABLE_BITS {
        return Err(refuse_size("table bits", bits, TABLE_BITS, "take smaller tables"));
    }
    let auto = if rows <= AUTO_INLINE_ROWS { Tables::Inline } else { Tables::Files };
    let tables = asked.unwrap_or(auto);
    if tables != Tables::Files && rows > INLINE_ROWS {
        return Err(refuse_size("table rows in line", rows, INLINE_ROWS, "put tables into files"));
    }
    Ok(tables)
}
