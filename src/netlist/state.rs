//! Words that netlists carry from one sample to the next.

use super::Netlist;
use crate::base::cast;
use crate::netlist::op::Op;
use std::collections::{BTreeMap, VecDeque};

/// What a netlist keeps of the samples that it has seen: the words under way in each `delay`.
#[derive(Clone, Debug)]
pub struct State {
    /// By position of the node, oldest words first.
    words: BTreeMap<usize, VecDeque<i64>>,
}

impl State {
    /// After a reset.
    #[must_use]
    pub fn new(netlist: &Netlist) -> Self {
        let delays = netlist.nodes().iter().enumerate().filter_map(|(index, node)| {
            let Op::Delay { samples } = node.op else { return None };
            Some((index, VecDeque::from(vec![0; cast::index_of_u32(samples)])))
        });
        Self { words: delays.collect() }
    }

    /// What comes out of a delay when a word goes in.
    pub(super) fn delayed(&mut self, index: usize, word: i64) -> i64 {
        let words = self.words.get_mut(&index).expect("bug: the state is another netlist's");
        words.push_back(word);
        words.pop_front().expect("bug: a delay holds a word")
    }
}
