//! Registers of the pipelined hardware, from netlist and schedule.
//!
//! A [`Signal`] is a node's word as it is seen in a stage: the node's own logic in its own
//! stage, a register in each later stage up to the last one that uses it. The cycle simulator,
//! the waves and the emitted hardware all read this, so they can't disagree.

use crate::cast;
use crate::netlist::{Netlist, NodeId};
use crate::op::Op;
use crate::schedule::Schedule;
use std::sync::Arc;

/// A node's word as seen in a stage.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub struct Signal {
    /// The node.
    pub node: NodeId,
    /// The stage.
    pub stage: u32,
}

/// The pipelined hardware of a netlist.
#[derive(Clone, Debug)]
pub struct Rtl {
    netlist: Arc<Netlist>,
    schedule: Schedule,
    /// Last stage in which a node's word is needed.
    last: Vec<u32>,
}

impl Rtl {
    /// Derives the registers.
    #[must_use]
    pub fn new(netlist: Arc<Netlist>, schedule: Schedule) -> Self {
        let mut last: Vec<u32> = netlist.ids().map(|id| schedule.stage(id)).collect();
        for id in netlist.ids() {
            let at = schedule.operand_stage(&netlist, id);
            for operand in &netlist.node(id).operands {
                last[operand.index()] = last[operand.index()].max(at);
            }
        }
        for output in netlist.outputs() {
            last[output.node.index()] = schedule.latency();
        }
        // A constant is the same in every stage.
        for id in netlist.ids() {
            if matches!(netlist.node(id).op, Op::Const { .. }) {
                last[id.index()] = schedule.stage(id);
            }
        }
        Self { netlist, schedule, last }
    }

    /// The datapath.
    #[must_use]
    pub fn netlist(&self) -> &Arc<Netlist> {
        &self.netlist
    }

    /// The schedule.
    #[must_use]
    pub fn schedule(&self) -> &Schedule {
        &self.schedule
    }

    /// Registers that carry a node's word to later stages, in order of their stages. The output
    /// register of a read on a clock is not among them: it is the read itself.
    pub fn registers(&self, node: NodeId) -> impl Iterator<Item = Signal> + use<> {
        let first = self.schedule.stage(node) + 1;
        (first..=self.last[node.index()]).map(move |stage| Signal { node, stage })
    }

    /// The signal that `user` takes its operand from; constants are seen at their own stage.
    #[must_use]
    pub fn operand(&self, user: NodeId, operand: NodeId) -> Signal {
        let constant = matches!(self.netlist.node(operand).op, Op::Const { .. });
        let stage = if constant {
            self.schedule.stage(operand)
        } else {
            self.schedule.operand_stage(&self.netlist, user)
        };
        Signal { node: operand, stage }
    }

    /// The signal behind an output port.
    #[must_use]
    pub fn output(&self, node: NodeId) -> Signal {
        let constant = matches!(self.netlist.node(node).op, Op::Const { .. });
        let stage = if constant { self.schedule.stage(node) } else { self.schedule.latency() };
        Signal { node, stage }
    }

    /// Name of a signal in its scope, which the waves and the emitted hardware share: the node's
    /// own name or its number, `_next` where an output port, its register, has that name, and
    /// the stage of a register that carries it on.
    #[must_use]
    pub fn local_name(&self, signal: Signal) -> String {
        let node = self.netlist.node(signal.node);
        let at_root = self.netlist.scope_path(node.scope).is_empty();
        let is_port = |name: &str| self.netlist.outputs().iter().any(|output| output.name == name);
        let name = match &node.name {
            Some(name) if at_root && node.op != Op::Input && is_port(name) => {
                format!("{name}_next")
            }
            Some(name) => name.clone(),
            None => format!("n{}", signal.node.index()),
        };
        if signal.stage == self.schedule.stage(signal.node) {
            name
        } else {
            format!("{name}_s{}", signal.stage)
        }
    }

    /// Flip-flops: bits of all registers, the output registers of reads on a clock, and the
    /// valid bits.
    #[must_use]
    pub fn register_bits(&self) -> u64 {
        let data: u64 = self
            .netlist
            .ids()
            .map(|id| {
                let copies = self.registers(id).count()
                    + usize::from(self.schedule.is_clocked(&self.netlist, id));
                u64::from(self.netlist.node(id).format.bits()) * cast::count_of(copies)
            })
            .sum();
        data + u64::from(self.schedule.latency())
    }
}
