//! The parts of a specialised netlist, and what it saves.

use super::reduced::Reduced;
use super::tables::TableCut;
use crate::netlist::Counts;

/// The result of [`specialise`](super::specialise()).
#[derive(Clone, Debug)]
pub struct Specialised {
    /// The whole datapath, reduced.
    pub whole: Reduced,
    /// The part that is evaluated once per face; `None` if there is nothing to gain.
    pub face: Option<Reduced>,
    /// The part that is evaluated for every sample; [`Specialised::whole`] if there is no `face`.
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
    /// How each table that it reads was cut.
    pub tables: Vec<TableCut>,
}

/// A node of the general netlist that became a constant.
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
    /// The output of the face netlist, and the input of the rest.
    pub port: String,
    /// Its format.
    pub format: String,
}

/// What was folded, cut and moved, and the savings.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Report {
    /// The general netlist.
    pub before: Counts,
    /// The whole datapath, reduced.
    pub whole: PartReport,
    /// The part that is evaluated once per face.
    pub face: Option<PartReport>,
    /// The part that is evaluated for every sample.
    pub pixel: PartReport,
    /// Input ports that were removed.
    pub removed_inputs: Vec<String>,
    /// Output ports that were removed.
    pub removed_outputs: Vec<String>,
    /// Nodes with operands that became constants: those with names.
    pub folded: Vec<Folded>,
    /// Number of such nodes, with and without names.
    pub folded_nodes: u64,
    /// Nodes that became wires or a simpler operation.
    pub simplified_nodes: u64,
    /// `narrow`s whose saturation never happens and was removed.
    pub unlimited_narrows: u64,
    /// Words that are computed once per face.
    pub hoisted: Vec<Hoisted>,
}
