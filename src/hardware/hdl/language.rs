//! What a hardware description language has to provide.

use super::module::{File, Module};

/// A hardware description language.
pub trait Language: Sync + std::fmt::Debug {
    /// Name on the command line.
    fn name(&self) -> &'static str;
    /// Its standard, and tools that read it, in one line.
    fn summary(&self) -> &'static str;
    /// Extension of its files.
    fn extension(&self) -> &'static str;
    /// The text of a module.
    fn module(&self, module: &Module) -> String;
    /// Testbench, harness, makefiles and scripts for the tools that read this language. `vectors`
    /// is the number of test vectors.
    fn companions(&self, module: &Module, vectors: u64) -> Vec<File>;
}

impl Module {
    /// The module in a language.
    #[must_use]
    pub fn file(&self, language: &dyn Language) -> File {
        File {
            name: format!("{}.{}", self.name, language.extension()),
            text: language.module(self),
        }
    }
}

/// Largest number of table rows on a line.
pub(super) const ROWS_A_LINE: usize = 4;

/// Attributes that place a table in block RAM or in logic. Vivado reads `rom_style`, Quartus
/// `romstyle`, Synplify `syn_romstyle`. Yosys reads all of them and uses the first, but knows no
/// distributed ROM: the attribute `rom_block`, which only Yosys has and which it reads before the
/// others, says `logic`. Quartus and Synplify place clocked reads in block RAM without an
/// attribute, and their names for it differ by device family.
pub(super) fn rom_attributes(block: bool) -> &'static [(&'static str, &'static str)] {
    if block {
        &[("rom_style", "block")]
    } else {
        &[
            ("rom_block", "logic"),
            ("rom_style", "distributed"),
            ("romstyle", "logic"),
            ("syn_romstyle", "logic"),
        ]
    }
}
