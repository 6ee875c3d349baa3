//! Knowledge about an input.

use crate::netlist::Rate;
use crate::netlist::words::Words;
use crate::number::format::Format;

/// Knowledge about an input.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Known {
    /// The words that occur.
    pub words: Words,
    /// How often it changes.
    pub rate: Rate,
}

impl Known {
    /// No knowledge: every word of the format may occur, with every sample.
    #[must_use]
    pub fn nothing(format: Format) -> Self {
        Self { words: Words::all(format), rate: Rate::Pixel }
    }
}
