//! Which column holds which node, in the program on reals.

use crate::netlist::{Netlist, NodeId};
use crate::op::Op;

/// Columns of a program.
pub(super) struct Columns {
    /// Column of each node that has one.
    of: Vec<usize>,
    /// Number of columns.
    pub(super) count: usize,
}

impl Columns {
    /// Gives each node with `operands` a column, in order; a column whose users are all done goes
    /// to a later node. Outputs keep theirs. So do constants, which are filled once, and ports,
    /// which are filled before the first instruction: their columns were no other node's before.
    pub(super) fn new(
        netlist: &Netlist,
        operands: &[Option<Vec<usize>>],
        outputs: &[NodeId],
    ) -> Self {
        let nodes = netlist.nodes();
        let keeps = |index: usize| matches!(nodes[index].op, Op::Input | Op::Const { .. });
        let mut last_use = vec![0; nodes.len()];
        for (index, operands) in operands.iter().enumerate() {
            for operand in operands.iter().flatten() {
                last_use[*operand] = index;
            }
        }
        for id in outputs {
            last_use[id.index()] = usize::MAX;
        }
        let mut columns = Self { of: vec![usize::MAX; nodes.len()], count: 0 };
        let mut free = Vec::new();
        for (index, operands) in operands.iter().enumerate() {
            let Some(operands) = operands else { continue };
            let used = if keeps(index) { None } else { free.pop() };
            columns.of[index] = used.unwrap_or_else(|| {
                columns.count += 1;
                columns.count - 1
            });
            let mut done: Vec<usize> = operands
                .iter()
                .copied()
                .filter(|operand| last_use[*operand] == index && !keeps(*operand))
                .collect();
            done.sort_unstable();
            done.dedup();
            free.extend(done.into_iter().map(|operand| columns.of[operand]));
        }
        columns
    }

    /// Column of a node.
    pub(super) fn of(&self, index: usize) -> usize {
        self.of[index]
    }

    /// Columns of up to three operands; the rest are 0, and what is there means nothing.
    pub(super) fn operands(&self, operands: &[usize]) -> [usize; 3] {
        let mut of = [0; 3];
        for (column, operand) in of.iter_mut().zip(operands) {
            *column = self.of[*operand];
        }
        of
    }
}
