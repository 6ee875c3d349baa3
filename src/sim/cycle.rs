//! Clock cycles of the pipelined hardware.
//!
//! In each cycle [`Cycle::settle`] lets logic follow the inputs and registers, and
//! [`Cycle::clock`] takes the rising edge. Registers are unknown until the first data reaches
//! them; only the valid bits have a reset, as in the emitted hardware.

use crate::cast;
use crate::format::{Format, Overflow};
use crate::netlist::NodeId;
use crate::op::Op;
use crate::rtl::{Rtl, Signal};
use std::sync::Arc;

/// State of the hardware.
#[derive(Clone, Debug)]
pub struct Cycle {
    rtl: Arc<Rtl>,
    /// Word of each node in its own stage.
    own: Vec<i64>,
    /// Words of its registers, and what they take at the next edge.
    registers: Vec<Vec<i64>>,
    /// What reads on a clock take at the next edge.
    read: Vec<i64>,
    /// Valid bit of each stage.
    valid: Vec<bool>,
    /// Edges since the start.
    edges: u64,
    /// A `narrow` under overflow mode `error` that overflowed on valid data.
    forbidden: Option<NodeId>,
}

impl Cycle {
    /// Hardware before the first edge, with all valid bits clear.
    #[must_use]
    pub fn new(rtl: Arc<Rtl>) -> Self {
        let nodes = rtl.netlist().nodes().len();
        let registers = rtl.netlist().ids().map(|id| vec![0; rtl.registers(id).count()]).collect();
        let stages = cast::index_of(i64::from(rtl.schedule().latency())) + 1;
        Self {
            own: vec![0; nodes],
            registers,
            read: vec![0; nodes],
            valid: vec![false; stages],
            edges: 0,
            forbidden: None,
            rtl,
        }
    }

    /// Lets logic follow the input words; `valid` says whether they are data.
    ///
    /// # Panics
    /// If there is not one word per input port.
    pub fn settle(&mut self, inputs: &[i64], valid: bool) {
        let rtl = Arc::clone(&self.rtl);
        let netlist = rtl.netlist();
        assert_eq!(inputs.len(), netlist.inputs().len(), "bug: one word per input");
        self.valid[0] = valid;
        let mut ports = inputs.iter();
        for id in netlist.ids() {
            let node = netlist.node(id);
            if node.op == Op::Input {
                self.own[id.index()] = *ports.next().expect("bug: counted above");
                continue;
            }
            let mut of = [(0, Format::FLAG); 3];
            for (slot, operand) in of.iter_mut().zip(&node.operands) {
                *slot = (self.word(rtl.operand(id, *operand)), netlist.node(*operand).format);
            }
            let of = &of[..node.operands.len()];
            let (word, overflowed) = node.op.eval_raw(of, node.format, netlist.tables());
            let error = overflowed && node.op.overflow() == Some(Overflow::Error);
            if error && self.valid(rtl.schedule().stage(id)) {
                self.forbidden.get_or_insert(id);
            }
            if rtl.schedule().is_clocked(netlist, id) {
                self.read[id.index()] = word;
            } else {
                self.own[id.index()] = word;
            }
        }
    }

    /// Takes a rising edge.
    pub fn clock(&mut self) {
        let rtl = Arc::clone(&self.rtl);
        for id in rtl.netlist().ids() {
            let registers = &mut self.registers[id.index()];
            if !registers.is_empty() {
                registers.rotate_right(1);
                registers[0] = self.own[id.index()];
            }
            if rtl.schedule().is_clocked(rtl.netlist(), id) {
                self.own[id.index()] = self.read[id.index()];
            }
        }
        self.valid.rotate_right(1);
        self.valid[0] = false;
        self.edges += 1;
    }

    /// Clears the valid bits, as the reset does at an edge.
    pub fn reset(&mut self) {
        self.valid.fill(false);
    }

    /// Word of a signal; meaningless while it is not [known](Self::known).
    #[must_use]
    pub fn word(&self, signal: Signal) -> i64 {
        let own = self.rtl.schedule().stage(signal.node);
        if signal.stage == own {
            self.own[signal.node.index()]
        } else {
            let register = cast::index_of(i64::from(signal.stage - own - 1));
            self.registers[signal.node.index()][register]
        }
    }

    /// The first `narrow` under [`Overflow::Error`] that overflowed on valid data.
    #[must_use]
    pub fn forbidden_overflow(&self) -> Option<NodeId> {
        self.forbidden
    }

    /// Rising edges taken so far.
    #[must_use]
    pub fn edges(&self) -> u64 {
        self.edges
    }

    /// True once data from the first cycle has reached a stage.
    #[must_use]
    pub fn known(&self, stage: u32) -> bool {
        self.edges >= u64::from(stage)
    }

    /// Valid bit of a stage.
    #[must_use]
    pub fn valid(&self, stage: u32) -> bool {
        self.valid[cast::index_of(i64::from(stage))]
    }

    /// Words of the output ports, if they are valid.
    #[must_use]
    pub fn outputs(&self) -> Option<Vec<i64>> {
        let word = |node: NodeId| self.word(self.rtl.output(node));
        let outputs = self.rtl.netlist().outputs();
        self.valid(self.rtl.schedule().latency())
            .then(|| outputs.iter().map(|output| word(output.node)).collect())
    }
}
