//! Specialisation of a netlist to a scene: reduces it to the words that occur at its inputs.
//!
//! A caller knows which words each input can have ([`Known::words`]) and how often it changes
//! ([`Known::rate`]). From this, [`specialise`] derives the words that every node can have
//! ([`ranges`]), and builds netlists with the same output words for all such inputs:
//!
//! 1. Nodes with one possible word become constants. Muxes with a known flag, additions of zero,
//!    products with a power of two and shifts by a known count become wires. Saturation that never
//!    happens is removed.
//! 2. Nodes that depend only on inputs that are constant over a face move to a separate netlist,
//!    whose outputs become further inputs of the rest.
//! 3. Tables are cut to the rows and columns that are read.
//! 4. Nodes, tables and inputs that no wanted output needs are removed.
//!
//! The remaining nodes keep their operation, format, name, scope and meaning. A meaning is removed
//! if its arguments are gone: in real arithmetic, a constant is then its word, with the word's
//! error.

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
