//! What a hardware description language spells.

use super::module::{File, Module};

/// A hardware description language.
pub trait Language: Sync + std::fmt::Debug {
    /// Name on the command line.
    fn name(&self) -> &'static str;
    /// Its edition and who reads it, in a line.
    fn summary(&self) -> &'static str;
    /// Extension of its files.
    fn extension(&self) -> &'static str;
    /// The text of a module.
    fn module(&self, module: &Module) -> String;
    /// Testbench, harness, makefiles and scripts of the tools that take this language;
    /// `vectors` is how many there will be.
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

/// The most table rows on a line.
pub(super) const ROWS_A_LINE: usize = 4;

/// Attributes that put a table into block RAM or into logic. Vivado reads `rom_style`, Quartus
/// `romstyle`, Synplify `syn_romstyle`. Yosys reads them all and takes the first, and knows no
/// distributed ROM: `rom_block`, which it alone has and reads before the others, says `logic`.
/// In block RAM, Quartus and Synplify put by themselves what is read on the clock, and they call
/// it otherwise for each family.
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
