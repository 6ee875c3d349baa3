//! Words that a netlist carries from one sample to the next.

use super::Netlist;
use crate::base::cast;
use crate::netlist::op::Op;
use std::collections::{BTreeMap, VecDeque};

/// The words of earlier samples inside each `delay` of a netlist.
#[derive(Clone, Debug)]
pub struct State {
    /// By node position, oldest word first.
    words: BTreeMap<usize, VecDeque<i64>>,
}

impl State {
    /// The state after a reset.
    #[must_use]
    pub fn new(netlist: &Netlist) -> Self {
        let delays = netlist.nodes().iter().enumerate().filter_map(|(index, node)| {
            let Op::Delay { samples } = node.op else { return None };
            Some((index, VecDeque::from(vec![0; cast::index_of_u32(samples)])))
        });
        Self { words: delays.collect() }
    }

    /// Pushes a word into a delay and returns the word that leaves it.
    pub(super) fn delayed(&mut self, index: usize, word: i64) -> i64 {
        let words = self.words.get_mut(&index).expect("bug: the state is another netlist's");
        words.push_back(word);
        words.pop_front().expect("bug: a delay holds a word")
    }
}
