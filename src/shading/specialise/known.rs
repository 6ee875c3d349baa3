//! What is known of an input.

use crate::netlist::words::Words;
use crate::number::format::Format;

/// How often an input changes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Rate {
    /// It is constant over the whole scene.
    Scene,
    /// It is constant over each flat face.
    Face,
    /// It changes with every sample.
    Pixel,
}

/// What is known of an input.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Known {
    /// The words that occur.
    pub words: Words,
    /// How often it changes.
    pub rate: Rate,
}

impl Known {
    /// Nothing: every word of the format, with every sample.
    #[must_use]
    pub fn nothing(format: Format) -> Self {
        Self { words: Words::all(format), rate: Rate::Pixel }
    }
}
