//! A netlist of which some inputs are gone.

use crate::netlist::Netlist;

/// Where an input of a specialised netlist gets its word.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Source {
    /// Input port of the general netlist.
    Port(usize),
    /// Output of the netlist that is evaluated once per face.
    Face(usize),
}

/// A specialised netlist.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// The netlist.
    pub netlist: Netlist,
    /// Where each of its inputs gets its word.
    pub inputs: Vec<Source>,
}

impl Reduced {
    /// The words of its inputs, from those of the general netlist and of the face's outputs.
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
