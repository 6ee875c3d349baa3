//! Words for the memories of a netlist.

use super::{Memory, Netlist, NodeId, Table};
use crate::base::error::{Error, Result};
use crate::netlist::op::Op;
use std::sync::Arc;

impl Netlist {
    /// The read-only tables.
    pub fn roms(&self) -> impl Iterator<Item = &Table> {
        self.tables.iter().filter(|table| table.memory.is_none())
    }

    /// The memories.
    pub fn memories(&self) -> impl Iterator<Item = &Table> {
        self.tables.iter().filter(|table| table.memory.is_some())
    }

    /// The table or memory that a node reads, if it reads one.
    #[must_use]
    pub fn read_of(&self, id: NodeId) -> Option<&Table> {
        let Op::Read { table, .. } = self.node(id).op else { return None };
        Some(&self.tables[table.index()])
    }

    /// The hardware parameters of the memory that a node reads, if it reads one.
    #[must_use]
    pub fn memory(&self, id: NodeId) -> Option<Memory> {
        self.read_of(id)?.memory
    }

    /// Binds words to a memory: one list per column, with one word per address. On reals, a read
    /// then stands for the value of the word at its address, rounded down, unless it
    /// [means](super::Builder::means) something else.
    ///
    /// # Errors
    /// If there is no such memory, or a column doesn't have one word of its format per address.
    pub fn bind(&self, memory: &str, columns: &[Arc<[i64]>]) -> Result<Self> {
        let at =
            self.tables.iter().position(|table| table.name == memory && table.memory.is_some());
        let Some(at) = at else {
            let known: Vec<&str> = self.memories().map(|memory| &memory.name[..]).collect();
            return Err(Error::unknown_memory(&self.name, memory, &known));
        };
        let refuse = |problem: String| Err(Error::usage(format!("memory `{memory}`: {problem}")));
        let mut bound = self.clone();
        let table = &mut bound.tables[at];
        if columns.len() != table.columns.len() {
            let names: Vec<&str> = table.columns.iter().map(|column| &column.name[..]).collect();
            let (given, names) = (columns.len(), names.join(", "));
            return refuse(format!("{given} columns are given: it takes one for each of {names}"));
        }
        for (column, words) in table.columns.iter_mut().zip(columns) {
            column.words = Arc::clone(words);
        }
        if let Some(problem) = table.problem_with_words() {
            return refuse(problem);
        }
        bound.read_reals();
        Ok(bound)
    }

    /// A copy without the words of memories.
    #[must_use]
    pub fn unbound(&self) -> Self {
        let mut unbound = self.clone();
        unbound.tables = self.tables.iter().map(Table::without_words).collect();
        unbound.read_reals();
        unbound
    }

    /// Refuses a netlist with an unbound memory, which can't be simulated.
    pub(crate) fn check_bound(&self) -> Result<()> {
        match self.memories().find(|memory| memory.is_unbound()) {
            None => Ok(()),
            Some(memory) => Err(Error::unbound_memory(&memory.name)),
        }
    }
}
