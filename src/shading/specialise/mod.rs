//! Only what a scene needs: a netlist cut down to the words that occur at its inputs.
//!
//! A caller knows which words each input can hold ([`Known::words`]) and how often it changes
//! ([`Known::rate`]). [`specialise`] finds from that which words every node can hold ([`ranges`]), and
//! makes netlists that give the same output words for all such inputs:
//!
//! 1. nodes of one word become constants; choices with a known flag, additions of zero, products with
//!    a power of two and shifts by a known count become wires; limits that are never met go;
//! 2. what depends only on inputs that are constant over a face moves to a netlist of its own, whose
//!    outputs are further inputs of the rest;
//! 3. tables are cut to rows and columns that are read;
//! 4. nodes, tables and inputs that no wanted output needs go.
//!
//! What is left keeps its operation, format, name, scope and meaning. A meaning whose arguments are
//! gone goes too: on reals, a constant is its word, with the error that it has.

mod known;
mod rebuild;
mod reduced;
mod report;
mod simplify;
mod split;
mod tables;
mod whole;

pub use crate::netlist::Rate;
pub use crate::netlist::ranges::ranges;
pub use crate::netlist::words::Words;
pub use known::Known;
pub use reduced::{Reduced, Source};
pub use report::{Folded, Hoisted, PartReport, Report, Specialised};
pub use tables::{CutTable, TableCut};
pub use whole::specialise;
