//! A program: instructions over columns, with their constants and tables.

use crate::netlist::NodeId;
use crate::number::format::Format;
use crate::sim::kernels::{Fit, Kernel, Lane};
use crate::sim::lanes::Width;
use std::sync::Arc;

/// Samples per block: two kilobytes a column in 16-bit lanes.
pub const BLOCK: usize = 1024;

/// A column: of all lanes of its width, the one with this number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Column {
    pub(super) width: Width,
    pub(super) slot: usize,
}

/// What an instruction does.
#[derive(Clone, Copy, Debug)]
pub(super) enum Action {
    /// Lanes of the operands' width in, lanes of the result's out.
    Kernel(Kernel),
    /// A product of 32-bit lanes in 64 bits, and what becomes of it.
    WideProduct(Option<Fit>),
    /// Lanes of another width, extended by zeros or by the sign.
    Convert { zero: bool },
    /// A table's words; which of those of the result's width.
    Read { table: usize },
    /// The words of earlier samples; `line` says of which delay.
    Delay { line: usize },
    /// Two tables' words at one address; the second goes to `second`.
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

/// What callers' columns are held to.
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
    /// Column of each port that something reads.
    pub(super) inputs: Vec<Option<Column>>,
    /// Column of each output, and whether zeros extend it.
    pub(super) outputs: Vec<(Column, bool)>,
    /// The input ports, and the nodes that are given out.
    pub(super) ports: Vec<Port>,
    pub(super) results: Vec<Port>,
    /// The `narrow` nodes, in the order of the counters.
    pub(super) narrows: Vec<NodeId>,
    /// How many samples each delay is of.
    pub(super) delays: Vec<u32>,
    /// A memory that is read and that no words are bound to.
    pub(super) unbound: Option<String>,
    /// The first instructions give the same words in each block of a run, so many of them.
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
