//! What a specialised netlist is made of, and what it saves.

use super::reduced::Reduced;
use super::tables::TableCut;
use crate::netlist::Counts;

/// What [`specialise`](super::specialise()) makes.
#[derive(Clone, Debug)]
pub struct Specialised {
    /// The whole datapath, reduced.
    pub whole: Reduced,
    /// What is evaluated once per face; `None` if nothing is gained by it.
    pub face: Option<Reduced>,
    /// What is evaluated for every sample; [`Specialised::whole`] if there is no `face`.
    pub pixel: Reduced,
    /// What was saved.
    pub report: Report,
}

/// Counts and tables of a specialised netlist.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct PartReport {
    /// Its input ports.
    pub inputs: Vec<String>,
    /// Its output ports.
    pub outputs: Vec<String>,
    /// Its operators and tables.
    pub counts: Counts,
    /// What became of each table that it reads.
    pub tables: Vec<TableCut>,
}

/// A node of the general netlist that has one word.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Folded {
    /// Its name with its scopes.
    pub node: String,
    /// Its format.
    pub format: String,
    /// Its word.
    pub raw: i64,
    /// The value of that word.
    pub value: f64,
}

/// A word that is computed once per face.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Hoisted {
    /// Its node's name with its scopes.
    pub node: String,
    /// Output of the face's netlist and input of the rest.
    pub port: String,
    /// Its format.
    pub format: String,
}

/// What was folded, cut and moved, and what that saves.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Report {
    /// The general netlist.
    pub before: Counts,
    /// The whole datapath, reduced.
    pub whole: PartReport,
    /// What is evaluated once per face.
    pub face: Option<PartReport>,
    /// What is evaluated for every sample.
    pub pixel: PartReport,
    /// Input ports that are gone.
    pub removed_inputs: Vec<String>,
    /// Output ports that are gone.
    pub removed_outputs: Vec<String>,
    /// Nodes that had operands and are constants, those with names.
    pub folded: Vec<Folded>,
    /// How many of them there are, with and without names.
    pub folded_nodes: u64,
    /// Nodes that became wires or a simpler operation.
    pub simplified_nodes: u64,
    /// `narrow`s that lost limits that they never meet.
    pub unlimited_narrows: u64,
    /// Words that are computed once per face.
    pub hoisted: Vec<Hoisted>,
}
