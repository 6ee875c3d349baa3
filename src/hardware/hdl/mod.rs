//! Hardware description from [`Rtl`](crate::hardware::rtl::Rtl): modules, testbenches and the files
//! that accompany them.
//!
//! [`Module::new`] lowers registers and nodes to words of plain bits, each driven by one statement,
//! with every width, alignment, rounding addend and limit written out. A back end only decides the
//! spelling: a [`Language`] prints a [`Module`], and a new language needs one file and one row of
//! [`LANGUAGES`].

mod language;
mod lower;
mod module;
mod names;
pub mod testbench;
mod verilog;
mod vhdl;

pub use language::Language;
pub use lower::{AUTO_INLINE_ROWS, INLINE_ROWS, Options, TABLE_BITS, WORDS};
pub(crate) use module::cycles;
pub use module::{
    Bit, Bitwise, Driver, Expr, File, Item, Memories, MemoryPorts, Module, Next, Operand, Port,
    Register, RomTable, SlowRate, Stage, Tables, Valid, View, Word, WordId, WritePort,
};
pub use verilog::{Verilog, proof};
pub use vhdl::Vhdl;

/// Every back end.
pub static LANGUAGES: &[&dyn Language] = &[&Verilog, &Vhdl];
