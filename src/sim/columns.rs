//! Which column holds which node, in the program on reals.

use crate::netlist::op::Op;
use crate::netlist::{Netlist, NodeId};

/// Columns of a program.
pub(super) struct Columns {
    /// Column of each node that has one.
    of: Vec<usize>,
    /// Number of columns.
    pub(super) count: usize,
}

impl Columns {
    /// Gives each node of `order` a column; one whose users are all done goes
    /// to a later node. Outputs keep theirs. So do constants, which are filled once, and ports,
    /// which are filled before the first instruction: their columns were no other node's before;
    /// and of the first nodes, so many as `repeated` says, those that later ones read.
    pub(super) fn new(
        netlist: &Netlist,
        operands: &[Option<Vec<usize>>],
        order: &[usize],
        repeated: usize,
        outputs: &[NodeId],
    ) -> Self {
        let nodes = netlist.nodes();
        let mut place = vec![usize::MAX; nodes.len()];
        for (at, index) in order.iter().enumerate() {
            place[*index] = at;
        }
        let mut last_use = vec![0; nodes.len()];
        let mut read_again = vec![false; nodes.len()];
        for (at, index) in order.iter().enumerate() {
            for operand in operands[*index].iter().flatten() {
                last_use[*operand] = *index;
                read_again[*operand] |= at >= repeated && place[*operand] < repeated;
            }
        }
        for id in outputs {
            last_use[id.index()] = usize::MAX;
        }
        let fresh = |index: usize| matches!(nodes[index].op, Op::Input | Op::Const { .. });
        let keeps = |index: usize| fresh(index) || read_again[index];
        let mut columns = Self { of: vec![usize::MAX; nodes.len()], count: 0 };
        let mut free = Vec::new();
        for index in order.iter().copied() {
            let Some(operands) = &operands[index] else { continue };
            let used = if fresh(index) { None } else { free.pop() };
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
