//! A netlist with some inputs removed.

use crate::netlist::Netlist;

/// The source of a specialised netlist's input word.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Source {
    /// An input port of the general netlist.
    Port(usize),
    /// An output of the netlist that is evaluated once per face.
    Face(usize),
}

/// A specialised netlist.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// The netlist.
    pub netlist: Netlist,
    /// The source of each input.
    pub inputs: Vec<Source>,
}

impl Reduced {
    /// Its input words, from those of the general netlist and the face netlist's outputs.
    ///
    /// # Panics
    /// If a word is missing.
    #[must_use]
    pub fn select(&self, ports: &[i64], face: &[i64]) -> Vec<i64> {
        let word = |source: &Source| match source {
            Source::Port(port) => ports[*port],
            Source::Face(output) => face[*output],
        };
        self.inputs.iter().map(word).collect()
    }
}
