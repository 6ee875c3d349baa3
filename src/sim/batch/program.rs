//! A program: instructions over columns, with their constants and tables.

use crate::netlist::NodeId;
use crate::number::format::Format;
use crate::sim::kernels::{Fit, Kernel, Lane};
use crate::sim::lanes::Width;
use std::sync::Arc;

/// Samples per block: two kilobytes per column in 16-bit lanes.
pub const BLOCK: usize = 1024;

/// A column: an index among those of its width.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Column {
    pub(super) width: Width,
    pub(super) slot: usize,
}

/// What an instruction does.
#[derive(Clone, Copy, Debug)]
pub(super) enum Action {
    /// Reads lanes of the operands' width and writes lanes of the result's width.
    Kernel(Kernel),
    /// A product of 32-bit lanes in 64 bits, with an optional [`Fit`] of the result.
    WideProduct(Option<Fit>),
    /// Converts to lanes of another width, extended by zeros or by the sign.
    Convert { zero: bool },
    /// Reads a table; the index is among those of the result's width.
    Read { table: usize },
    /// The words of earlier samples; `line` is the index of the delay.
    Delay { line: usize },
    /// Reads two tables at one address; the second word goes to `second`.
    ReadPair { table: usize, second: usize },
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Instruction {
    pub(super) action: Action,
    /// Width of the operands.
    pub(super) width: Width,
    pub(super) of: [usize; 3],
    pub(super) operands: usize,
    pub(super) to: Column,
}

/// Tables in lanes of one width.
#[derive(Clone, Debug, Default)]
pub(super) struct Tables<L: Lane> {
    pub(super) single: Vec<Arc<[L]>>,
    pub(super) pairs: Vec<Arc<[L::Pair]>>,
}

/// What callers' columns are checked against.
#[derive(Clone, Debug)]
pub(super) struct Port {
    /// Label of the node.
    pub(super) name: String,
    pub(super) format: Format,
}

/// A netlist compiled for blocks of samples.
#[derive(Clone, Debug)]
pub struct Program {
    pub(super) instructions: Vec<Instruction>,
    pub(super) constants: Vec<(Column, i64)>,
    pub(super) tables16: Tables<i16>,
    pub(super) tables32: Tables<i32>,
    pub(super) tables64: Tables<i64>,
    /// Number of columns of each width.
    pub(super) slots: [usize; 3],
    /// Column of each port; `None` if nothing reads it.
    pub(super) inputs: Vec<Option<Column>>,
    /// Column of each output, and whether zeros extend it.
    pub(super) outputs: Vec<(Column, bool)>,
    /// The input ports, and the output nodes.
    pub(super) ports: Vec<Port>,
    pub(super) results: Vec<Port>,
    /// The `narrow` nodes, in the order of the counters.
    pub(super) narrows: Vec<NodeId>,
    /// The number of samples of each delay.
    pub(super) delays: Vec<u32>,
    /// A memory that is read but has no bound words.
    pub(super) unbound: Option<String>,
    /// The number of leading instructions that give the same words in each block of a run.
    pub(super) repeated: usize,
    /// Which ports hold the same words in each block of a run.
    pub(super) repeats: Vec<bool>,
}

impl Program {
    /// The `narrow` nodes, in the order of [`Runner::overflows`](super::Runner::overflows).
    #[must_use]
    pub fn narrows(&self) -> &[NodeId] {
        &self.narrows
    }
}

pub(super) fn slot_of(width: Width) -> usize {
    match width {
        Width::W16 => 0,
        Width::W32 => 1,
        Width::W64 => 2,
    }
}
