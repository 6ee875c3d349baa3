//! Assigns terms to columns, for the program on reals.

use crate::number::real::{Graph, Term, TermId};

/// Columns of a program.
pub(super) struct Columns {
    /// Column of each term that has one.
    of: Vec<usize>,
    /// Number of columns.
    pub(super) count: usize,
}

impl Columns {
    /// Gives each term of `order` a column, and reuses a column once all users of its term are
    /// done. Some columns are not reused: those of outputs; those of constants, which are filled
    /// once; those of ports, which are filled before the first step; and, of the first `repeated`
    /// terms, those that later terms read. Constants and ports also don't take a column that
    /// another term used before.
    pub(super) fn new(graph: &Graph, order: &[usize], repeated: usize, outputs: &[TermId]) -> Self {
        let terms = graph.terms();
        let mut place = vec![usize::MAX; terms.len()];
        for (at, index) in order.iter().enumerate() {
            place[*index] = at;
        }
        let mut last_use = vec![0; terms.len()];
        let mut read_again = vec![false; terms.len()];
        for (at, index) in order.iter().enumerate() {
            for operand in terms[*index].operands().iter().map(|id| id.index()) {
                last_use[operand] = *index;
                read_again[operand] |= at >= repeated && place[operand] < repeated;
            }
        }
        for id in outputs {
            last_use[id.index()] = usize::MAX;
        }
        let fresh = |index: usize| matches!(terms[index], Term::Variable(_) | Term::Constant(_));
        let keeps = |index: usize| fresh(index) || read_again[index];
        let mut columns = Self { of: vec![usize::MAX; terms.len()], count: 0 };
        let mut free = Vec::new();
        for index in order.iter().copied() {
            let used = if fresh(index) { None } else { free.pop() };
            columns.of[index] = used.unwrap_or_else(|| {
                columns.count += 1;
                columns.count - 1
            });
            let mut done: Vec<usize> = terms[index]
                .operands()
                .iter()
                .map(|id| id.index())
                .filter(|operand| last_use[*operand] == index && !keeps(*operand))
                .collect();
            done.sort_unstable();
            done.dedup();
            free.extend(done.into_iter().map(|operand| columns.of[operand]));
        }
        columns
    }

    /// Column of a term.
    pub(super) fn of(&self, index: usize) -> usize {
        self.of[index]
    }

    /// Columns of up to three operands; the rest are 0 and unused.
    pub(super) fn operands(&self, operands: &[TermId]) -> [usize; 3] {
        let mut of = [0; 3];
        for (column, operand) in of.iter_mut().zip(operands) {
            *column = self.of[operand.index()];
        }
        of
    }
}
