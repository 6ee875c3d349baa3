//! Rebuilds a netlist node by node, replacing some nodes.

use super::reduced::{Reduced, Source};
use crate::base::name;
use crate::netlist::op::Op;
use crate::netlist::{Builder, Netlist, NodeId, Quantity, ScopeId, TableId};
use crate::number::format::{Overflow, Round};
use std::collections::{BTreeMap, BTreeSet};

/// A netlist rebuilt from another; nodes are added in the order of the old one.
pub(super) struct Rebuild<'a> {
    old: &'a Netlist,
    old_inputs: &'a [Source],
    b: Builder,
    /// New ids by old ones.
    new: Vec<Option<NodeId>>,
    /// The operand of each new node that only converts its format.
    wires_of: BTreeMap<NodeId, NodeId>,
    inputs: Vec<Source>,
}

impl<'a> Rebuild<'a> {
    pub(super) fn new(of: &'a Reduced, name: &str) -> Self {
        Self {
            old: &of.netlist,
            old_inputs: &of.inputs,
            b: Builder::rebuild(&of.netlist, name),
            new: vec![None; of.netlist.nodes().len()],
            wires_of: BTreeMap::new(),
            inputs: Vec::new(),
        }
    }

    /// Copies a node unchanged.
    pub(super) fn copy(&mut self, id: NodeId) {
        let node = self.old.node(id);
        if node.op == Op::Input {
            let port = self.old.inputs().iter().position(|port| *port == id);
            let port = port.expect("bug: an input is a port");
            self.port(id, self.old.input_name(port), self.old_inputs[port]);
        } else if let Op::Read { table, column } = node.op {
            let table = self.b.table(self.old.tables()[table.index()].clone());
            self.simpler(id, Op::Read { table, column }, &node.operands);
        } else {
            self.simpler(id, node.op, &node.operands);
        }
    }

    /// Replaces a node by a port.
    pub(super) fn port(&mut self, id: NodeId, name: &str, source: Source) {
        let node = self.old.node(id);
        self.b.enter(ScopeId::ROOT);
        let new = self.b.input(name, node.format, node.quantity);
        if node.op == Op::Input {
            self.b.rate(new, node.rate);
        }
        self.inputs.push(source);
        self.new[id.index()] = Some(new);
    }

    /// Replaces a node by a constant.
    pub(super) fn constant(&mut self, id: NodeId, raw: i64) {
        let before = self.b.len();
        self.b.enter(self.old.node(id).scope);
        let new = self.b.constant(raw, self.old.node(id).format);
        self.stands_for(id, new, self.b.len() > before, None);
    }

    /// Replaces a node by the value of an operand, in the node's format.
    pub(super) fn wires(&mut self, id: NodeId, operand: NodeId) {
        let before = self.b.len();
        self.b.enter(self.old.node(id).scope);
        let new = self.in_format(self.at(operand), id);
        // An operand without a value on reals may take over the node's meaning.
        let own = self.b.len() > before || self.old.node(operand).real.is_none();
        self.stands_for(id, new, self.b.len() > before, own.then_some(id));
    }

    /// Replaces a node by another operation, in the node's format.
    pub(super) fn simpler(&mut self, id: NodeId, op: Op, operands: &[NodeId]) {
        let operands: Vec<NodeId> = operands.iter().map(|id| self.at(*id)).collect();
        self.place(id, op, &operands);
    }

    /// Replaces a table read by a read of a table at the low bits of the address.
    pub(super) fn read(&mut self, id: NodeId, table: TableId, column: u32) {
        let mut address = self.at(self.old.node(id).operands[0]);
        let bits = self.b.tables()[table.index()].addr_bits;
        self.b.enter(self.old.node(id).scope);
        if bits < self.b.format(address).bits() {
            // Merge a slice of a slice into one.
            let (of, lo) = match (self.b.node(address).op, &self.b.node(address).operands[..]) {
                (Op::Slice { lo }, [of]) => (*of, lo),
                _ => (address, 0),
            };
            address = self.b.slice(of, lo, bits);
        }
        self.place(id, Op::Read { table, column }, &[address]);
    }

    fn place(&mut self, id: NodeId, op: Op, operands: &[NodeId]) {
        let format = self.old.node(id).format;
        self.b.enter(self.old.node(id).scope);
        let before = self.b.len();
        let new = if let Op::Narrow { round, overflow } = op {
            self.b.narrow(self.through_wires(operands[0]), format, round, overflow)
        } else {
            self.b.operation(op, operands, format)
        };
        let new = self.in_format(new, id);
        let fresh = self.b.len() > before;
        self.stands_for(id, new, fresh, fresh.then_some(id));
    }

    /// The builder of the new netlist.
    pub(super) fn builder(&mut self) -> &mut Builder {
        &mut self.b
    }

    /// The netlist with these outputs, given by old ids.
    pub(super) fn finish(mut self, outputs: &[(String, NodeId)]) -> Reduced {
        for (name, id) in outputs {
            let node = self.at(*id);
            self.b.output(name, node);
        }
        let netlist = self.b.build_rebuilt().expect("bug: no format grows in a rebuilt netlist");
        Reduced { netlist, inputs: self.inputs }
    }

    fn at(&self, id: NodeId) -> NodeId {
        self.new[id.index()].expect("bug: operands come first")
    }

    /// The operand of a node that only converts formats; otherwise the node itself.
    fn through_wires(&self, new: NodeId) -> NodeId {
        self.wires_of.get(&new).copied().unwrap_or(new)
    }

    /// Converts a new node to the format of an old one, which can represent each of its words.
    fn in_format(&mut self, new: NodeId, id: NodeId) -> NodeId {
        let format = self.old.node(id).format;
        if self.b.format(new) == format {
            return new;
        }
        let of = self.through_wires(new);
        let wires = self.b.narrow(of, format, Round::Floor, Overflow::Wrap);
        if wires != of {
            self.wires_of.insert(wires, of);
        }
        wires
    }

    /// Records a new node, and gives it the old node's name and meaning.
    fn stands_for(&mut self, id: NodeId, new: NodeId, fresh: bool, meaning_of: Option<NodeId>) {
        let node = self.old.node(id);
        self.new[id.index()] = Some(new);
        if fresh || self.b.node(new).name.is_none() {
            if let Some(name) = &node.name {
                self.b.name(new, name);
            }
            if node.quantity == Quantity::Turns {
                self.b.turns(new);
            }
        }
        if let Some(meaning) = meaning_of.and_then(|id| self.old.node(id).meaning.as_ref()) {
            let known = |id: NodeId| self.new[id.index()].filter(|argument| *argument < new);
            let of: Option<Vec<NodeId>> = meaning.of.iter().map(|id| known(*id)).collect();
            if let Some(of) = of {
                self.b.stands_for(new, &meaning.expr, &of);
            }
        }
    }
}

/// The nodes that some outputs need, where a node needs its `operands`.
pub(super) fn live<'a>(
    netlist: &Netlist,
    outputs: impl Iterator<Item = NodeId>,
    operands: impl Fn(NodeId) -> &'a [NodeId],
) -> Vec<bool> {
    let mut live = vec![false; netlist.nodes().len()];
    outputs.for_each(|id| live[id.index()] = true);
    for id in netlist.ids().rev() {
        if live[id.index()] {
            operands(id).iter().for_each(|id| live[id.index()] = true);
        }
    }
    live
}

/// A free port name, from a node's name with its scopes.
pub(super) fn port_name(netlist: &Netlist, id: NodeId, taken: &mut BTreeSet<String>) -> String {
    let node = netlist.node(id);
    let mut words = netlist.scope_path(node.scope);
    words.push(node.name.as_deref().unwrap_or(node.op.name()));
    let base = name::with_suffix(&words.join("_"), "");
    let is_free = |name: &str| !taken.contains(name);
    let name = if is_free(&base) {
        base
    } else {
        name::numbered(&name::with_suffix(&base, "_face"), is_free)
    };
    taken.insert(name.clone());
    name
}
