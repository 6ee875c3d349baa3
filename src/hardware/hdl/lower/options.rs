//! Options of a module, and limits of its size.

use crate::base::error::{Error, Result};
use crate::hardware::hdl::module::{Memories, Tables};
use crate::hardware::hdl::names;
use crate::hardware::rtl::Rtl;

/// Largest number of table rows placed inline in a module; more must be placed in files.
pub const INLINE_ROWS: u64 = 1 << 16;
/// Largest number of table rows that are inline by default.
pub const AUTO_INLINE_ROWS: u64 = 1 << 12;
/// Largest number of bits in the tables of a module, inline or in files.
pub const TABLE_BITS: u64 = 1 << 28;
/// Largest number of words (wires and registers) in a module.
pub const WORDS: usize = 1 << 16;

/// What to emit.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Name of the module; the unit's name if `None`.
    pub name: Option<String>,
    /// Where table words are placed; chosen by their number if `None`.
    pub tables: Option<Tables>,
    /// Where memories are placed.
    pub memories: Memories,
    /// Lines for the head of each file: parameters and figures.
    pub header: Vec<String>,
}

/// Refuses a name that some tool rejects.
pub(super) fn check_name(name: &str) -> Result<()> {
    if !crate::base::name::is_legal(name) {
        return Err(Error::form(name, &format!("my_module: {}", crate::base::name::RULE)));
    }
    if names::is_reserved(name) {
        return Err(Error::usage(format!(
            "`{name}` is a reserved word of Verilog, VHDL or their tools, or a port of every module: choose another name"
        )));
    }
    Ok(())
}

pub(super) fn refuse_size(what: &str, given: u64, limit: u64, remedy: &str) -> Error {
    Error::usage(format!("the module would have {given} {what}; the limit is {limit}: {remedy}"))
}

/// Bits in the tables of a netlist; 64 bits hold the sum for any table.
fn rom_bits(rtl: &Rtl) -> u64 {
    rtl.netlist().roms().map(crate::netlist::Table::rom_bits).sum()
}

fn rows(rtl: &Rtl) -> u64 {
    rtl.netlist().roms().map(|table| 1u64 << table.addr_bits).sum()
}

/// Chooses where table rows go, and checks their size.
pub(super) fn place_tables(rtl: &Rtl, asked: Option<Tables>, memories: Memories) -> Result<Tables> {
    let ram_bits: u64 = rtl.netlist().memories().map(crate::netlist::Table::rom_bits).sum();
    if memories == Memories::Ram && ram_bits > TABLE_BITS {
        let remedy = "keep memories outside, at ports";
        return Err(refuse_size("bits of RAM", ram_bits, TABLE_BITS, remedy));
    }
    let (rows, bits) = (rows(rtl), rom_bits(rtl));
    if bits > TABLE_BITS {
        return Err(refuse_size("table bits", bits, TABLE_BITS, "choose smaller tables"));
    }
    let auto = if rows <= AUTO_INLINE_ROWS { Tables::Inline } else { Tables::Files };
    let tables = asked.unwrap_or(auto);
    if tables != Tables::Files && rows > INLINE_ROWS {
        return Err(refuse_size("inline table rows", rows, INLINE_ROWS, "put tables into files"));
    }
    Ok(tables)
}
