//! Operations that can share a unit: finding them, comparing their structures, and building a unit
//! that serves several.
//!
//! An *operation* is a single node (a product, a sum, a table port) or a whole part (a dot product,
//! a root, a divider, a table scheme). Two operations can share a unit if they have the same
//! structure: in creation order, their nodes have the same operations, attributes and wiring.
//! Formats may differ if the operations work on values. If one of them works on bit patterns
//! (slices, table reads, leading zeros …), the formats must be equal too.
//!
//! The unit's hardware is a netlist of its own on the *hulls* of its operands' formats: signed if
//! any is, with the most integer bits and the most fraction bits of all. Every operation is exact
//! and `narrow` works on values. So a node's word is the unit's word with its binary point moved,
//! whichever operation is in the unit.

use super::{Rom, Schedule, places};
use crate::base::error::{Error, Result};
use crate::netlist::op::Op;
use crate::netlist::{Builder, Netlist, NodeId, Part, Quantity, Rate, ScopeId};
use crate::number::format::Format;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The kind of a unit.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Kind {
    /// Dot products of three: [`Part::Dot`].
    Dot,
    /// Products outside dividers, roots, schemes and shared dot products.
    Multiplier,
    /// Sums and differences outside those; one adder does both.
    Adder,
    /// Table schemes, and table reads outside any scheme.
    Table,
    /// Square roots and reciprocal square roots.
    Root,
    /// Dividers.
    Divider,
}

impl Kind {
    /// Every kind with its name in units and parameters.
    pub const ALL: &'static [(Self, &'static str)] = &[
        (Self::Dot, "dot"),
        (Self::Multiplier, "mul"),
        (Self::Adder, "add"),
        (Self::Table, "table"),
        (Self::Root, "root"),
        (Self::Divider, "divide"),
    ];

    /// Name in units and parameters.
    ///
    /// # Panics
    /// Never: every kind is listed.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(known, _)| *known == self).expect("bug: every kind is listed").1
    }
}

/// An operand of an operation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Operand {
    /// A node's word.
    Node(NodeId),
    /// A constant.
    Constant {
        /// The word.
        raw: i64,
        /// Its format.
        format: Format,
    },
}

/// An operation of the netlist that can use a unit.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Operation {
    /// Label of its scope or node.
    pub name: String,
    /// Its nodes in creation order.
    pub nodes: Vec<NodeId>,
    /// Its operands from outside: one for each use by a node, in order.
    pub operands: Vec<Operand>,
    /// For each operand, its position among its node's operands. An adder's first operand is the
    /// flag that selects subtraction.
    pub sides: Vec<usize>,
    /// Cycle in which it enters its unit, counted from the entry of the slowest rate.
    pub issue: u32,
}

/// The wiring of an operation's nodes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Structure {
    nodes: Vec<Shape>,
    /// Formats of the operation's operands, if they matter.
    formats: Option<Vec<Format>>,
    /// Positions of nodes that are used outside, in any of the operations.
    pub(super) exports: Vec<usize>,
}

#[derive(Clone, PartialEq, Eq, Debug)]
struct Shape {
    op: Op,
    asked: Option<Format>,
    operands: Vec<Wire>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Wire {
    /// The node at this position.
    Inner(usize),
    /// The outside operand at this position.
    Place(usize),
}

impl Operation {
    /// The operation of these nodes and its structure. `None` if an outside node lies on a path
    /// between two of them, so that the operation can't run in one go.
    fn of(netlist: &Netlist, name: String, nodes: Vec<NodeId>) -> Option<(Self, Structure)> {
        let place_of: BTreeMap<NodeId, usize> =
            nodes.iter().enumerate().map(|(place, id)| (*id, place)).collect();
        let first = *nodes.first()?;
        // Marks outside nodes that depend on it.
        let mut behind = vec![false; netlist.nodes().len()];
        for id in netlist.ids().skip(first.index()) {
            let inside = place_of.contains_key(&id);
            let hangs = |o: &NodeId| behind[o.index()] || place_of.contains_key(o);
            if inside && netlist.node(id).operands.iter().any(|o| behind[o.index()]) {
                return None;
            }
            behind[id.index()] = !inside && netlist.node(id).operands.iter().any(hangs);
        }
        let (mut operands, mut sides) = (Vec::new(), Vec::new());
        let mut shapes = Vec::new();
        for id in &nodes {
            let node = netlist.node(*id);
            let mut wires = Vec::new();
            let adder = nodes.len() == 1 && matches!(node.op, Op::Add | Op::Sub);
            if adder {
                // One adder does both; the flag selects subtraction.
                wires.push(Wire::Place(operands.len()));
                let raw = i64::from(node.op == Op::Sub);
                operands.push(Operand::Constant { raw, format: Format::FLAG });
                sides.push(0);
            }
            for (side, operand) in node.operands.iter().enumerate() {
                wires.push(match place_of.get(operand) {
                    Some(place) => Wire::Inner(*place),
                    None => {
                        operands.push(operand_of(netlist, *operand));
                        sides.push(side + usize::from(adder));
                        Wire::Place(operands.len() - 1)
                    }
                });
            }
            let asked = node.op.traits().takes_format.then_some(node.format);
            let op = if adder { Op::AddSub } else { node.op };
            shapes.push(Shape { op, asked, operands: wires });
        }
        let bits = shapes.iter().any(|shape| shape.op.traits().looks_at_bits);
        let formats = bits.then(|| operands.iter().map(|o| format_of(netlist, *o)).collect());
        let used_outside = |id: &NodeId| {
            netlist.outputs().iter().any(|output| output.node == *id)
                || netlist.ids().any(|user| {
                    !place_of.contains_key(&user) && netlist.node(user).operands.contains(id)
                })
        };
        let exports = (0..nodes.len()).filter(|at| used_outside(&nodes[*at])).collect();
        let structure = Structure { nodes: shapes, formats, exports };
        Some((Self { name, nodes, operands, sides, issue: 0 }, structure))
    }
}

fn operand_of(netlist: &Netlist, id: NodeId) -> Operand {
    let node = netlist.node(id);
    if let Op::Const { raw } = node.op {
        Operand::Constant { raw, format: node.format }
    } else {
        Operand::Node(id)
    }
}

pub(super) fn format_of(netlist: &Netlist, operand: Operand) -> Format {
    match operand {
        Operand::Node(id) => netlist.node(id).format,
        Operand::Constant { format, .. } => format,
    }
}

impl Structure {
    /// True if operations of both structures can share a unit.
    pub(super) fn fits(&self, other: &Self) -> bool {
        self.nodes == other.nodes && self.formats == other.formats
    }
}

/// Operations of one kind with their structures, in creation order. `whole` lists all shared kinds:
/// nodes of a shared dot product are not operations by themselves.
pub(super) fn operations(
    netlist: &Netlist,
    kind: Kind,
    whole: &[Kind],
) -> Vec<(Operation, Structure)> {
    let dots_shared = whole.contains(&Kind::Dot);
    let scopes = |belongs: &dyn Fn(Part) -> bool| {
        let mut parts: BTreeMap<ScopeId, Vec<NodeId>> = BTreeMap::new();
        for id in netlist.ids() {
            let node = netlist.node(id);
            if matches!(node.op, Op::Input | Op::Const { .. }) {
                continue;
            }
            let part = netlist.part_of(node.scope).or_else(|| dot_of(netlist, node.scope));
            if let Some((part, scope)) = part
                && belongs(part)
            {
                parts.entry(scope).or_default().push(id);
            }
        }
        let mut parts: Vec<(String, Vec<NodeId>)> = parts
            .into_iter()
            .map(|(scope, nodes)| (netlist.scope_path(scope).join("."), nodes))
            .collect();
        parts.sort_by_key(|(_, nodes)| nodes[0]);
        parts
    };
    let singles = |belongs: &dyn Fn(Op) -> bool| {
        let mut groups: Vec<(String, Vec<NodeId>)> = Vec::new();
        for id in netlist.ids() {
            let node = netlist.node(id);
            let apart = netlist.part_of(node.scope).is_some()
                || dots_shared && dot_of(netlist, node.scope).is_some();
            if !apart && belongs(node.op) {
                groups.push((name_of(netlist, id), vec![id]));
            }
        }
        groups
    };
    let found = match kind {
        Kind::Dot => scopes(&|part| part == Part::Dot),
        Kind::Root => scopes(&|part| matches!(part, Part::SquareRoot | Part::ReciprocalRoot)),
        Kind::Divider => scopes(&|part| part == Part::Divider),
        Kind::Multiplier => singles(&|op| op == Op::Mul),
        Kind::Adder => singles(&|op| matches!(op, Op::Add | Op::Sub | Op::AddSub)),
        Kind::Table => {
            let mut found = scopes(&|part| part == Part::Scheme);
            // Reads at one address are one port.
            let mut ports: Vec<(String, Vec<NodeId>)> = Vec::new();
            for (name, nodes) in singles(&|op| matches!(op, Op::Read { .. })) {
                let key = |id: NodeId| {
                    let node = netlist.node(id);
                    let table =
                        if let Op::Read { table, .. } = node.op { Some(table) } else { None };
                    (table, node.operands[0])
                };
                match ports.iter_mut().find(|(_, known)| key(known[0]) == key(nodes[0])) {
                    Some((_, known)) => known.extend(nodes),
                    None => ports.push((name, nodes)),
                }
            }
            found.append(&mut ports);
            found.sort_by_key(|(_, nodes)| nodes[0]);
            found
        }
    };
    // A unit can't hold memories, which are outside the datapath, or delays, which keep a word. And
    // a unit's operands enter together, so its nodes have one rate.
    let rates = places(netlist);
    let fits = |(_, nodes): &(String, Vec<NodeId>)| {
        nodes.iter().all(|id| {
            netlist.memory(*id).is_none()
                && !matches!(netlist.node(*id).op, Op::Delay { .. })
                && rates[id.index()] == rates[nodes[0].index()]
        })
    };
    let found = found.into_iter().filter(fits);
    found.filter_map(|(name, nodes)| Operation::of(netlist, name, nodes)).collect()
}

/// The outermost dot product that a scope is or lies in.
fn dot_of(netlist: &Netlist, scope: ScopeId) -> Option<(Part, ScopeId)> {
    let mut found = None;
    let mut at = Some(scope);
    while let Some(id) = at {
        let scope = &netlist.scopes()[id.index()];
        found = (scope.part == Some(Part::Dot)).then_some((Part::Dot, id)).or(found);
        at = scope.parent;
    }
    found
}

/// Label of a node. An unnamed node takes the name of its output port, or of the rounding that is
/// its only user (possibly after moves of the binary point).
#[must_use]
pub fn name_of(netlist: &Netlist, id: NodeId) -> String {
    let mut at = id;
    while netlist.node(at).name.is_none() {
        if let Some(output) = netlist.outputs().iter().find(|output| output.node == at) {
            return output.name.clone();
        }
        let mut users = netlist
            .ids()
            .skip(at.index())
            .filter(|user| netlist.node(*user).operands.contains(&at));
        match (users.next(), users.next()) {
            (Some(user), None)
                if matches!(netlist.node(user).op, Op::Narrow { .. } | Op::Shift { .. }) =>
            {
                at = user;
            }
            (None | Some(_), None | Some(_)) => return netlist.label(id),
        }
    }
    netlist.label(at)
}

/// A unit that serves several operations.
#[derive(Clone, Debug)]
pub struct Unit {
    /// Its name, such as `dot1`.
    pub name: String,
    /// Its kind.
    pub kind: Kind,
    /// The rate of its operations.
    pub rate: Rate,
    /// Cycles between samples of that rate.
    pub interval: u32,
    /// Its nodes on hull formats. The inputs are its ports, the outputs are the nodes that
    /// operations export.
    pub netlist: Arc<Netlist>,
    /// Stages of its nodes, counted from the issue; its latency is the unit's.
    pub pipeline: Schedule,
    /// Its ports, in the order of the netlist's inputs.
    pub ports: Vec<UnitPort>,
    /// For each output, its position among an operation's nodes.
    pub exports: Vec<usize>,
    /// For each node of the netlist except ports and constants, its position among an operation's
    /// nodes.
    pub positions: Vec<Option<usize>>,
    /// Its operations, sorted by issue.
    pub operations: Vec<Operation>,
}

/// A port of a unit.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct UnitPort {
    /// Index into [`Operation::operands`].
    pub place: usize,
    /// Side of the unit: the operand's position in its node.
    pub side: usize,
    /// True if a register stores the operand in the cycle before the issue.
    pub registered: bool,
}

// Netlist and stages follow from the rest.
impl PartialEq for Unit {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
            && self.pipeline.latency() == other.pipeline.latency()
            && self.ports == other.ports
            && self.operations == other.operations
    }
}

impl Eq for Unit {}

impl Unit {
    /// Cycles from issue to output.
    #[must_use]
    pub fn latency(&self) -> u32 {
        self.pipeline.latency()
    }
}

/// The smallest format that holds all values of all formats, or the bits it would need.
fn hull(formats: impl Iterator<Item = Format>) -> Result<Format, u32> {
    let (mut signed, mut int_bits, mut frac_bits) = (false, i32::MIN, i32::MIN);
    for format in formats {
        signed |= format.is_signed();
        int_bits = int_bits.max(format.int_bits());
        frac_bits = frac_bits.max(format.frac_bits());
    }
    let bits = (int_bits + frac_bits + i32::from(signed)).unsigned_abs();
    Format::new(signed, bits, frac_bits).map_err(|_| bits)
}

/// Hardware for operations of one structure: the netlist, its ports, and the positions of its
/// nodes.
pub(super) struct Hardware {
    pub(super) netlist: Arc<Netlist>,
    pub(super) ports: Vec<UnitPort>,
    pub(super) positions: Vec<Option<usize>>,
}

impl Hardware {
    /// # Errors
    /// If a hull is wider than 63 bits.
    pub(super) fn new(
        netlist: &Netlist,
        name: &str,
        kind: Kind,
        structure: &Structure,
        operations: &[&Operation],
        registered: &dyn Fn(usize) -> bool,
    ) -> Result<Self> {
        let remedy = |bits: u32| {
            let names: Vec<&str> = operations.iter().map(|o| o.name.as_str()).collect();
            Error::shared_too_wide(name, names.join(", "), bits, kind.name())
        };
        let mut b = Builder::new(name);
        let mut ports: Vec<UnitPort> = Vec::new();
        let mut inputs: Vec<NodeId> = Vec::new();
        let mut at_place: Vec<NodeId> = Vec::new();
        for (place, side) in operations[0].sides.iter().copied().enumerate() {
            let all: Vec<Operand> = operations.iter().map(|o| o.operands[place]).collect();
            if let Operand::Constant { raw, format } = all[0]
                && all.iter().all(|o| *o == all[0])
            {
                at_place.push(b.constant(raw, format));
                continue;
            }
            // A port serves every place that has the same operand in all operations.
            let same = ports.iter().position(|port| {
                port.registered == registered(side)
                    && operations.iter().all(|o| o.operands[port.place] == o.operands[place])
            });
            if let Some(port) = same {
                at_place.push(inputs[port]);
                continue;
            }
            let format = hull(all.iter().map(|o| format_of(netlist, *o))).map_err(remedy)?;
            let input = b.input(&format!("in{}", ports.len()), format, Quantity::Number);
            ports.push(UnitPort { place, side, registered: registered(side) });
            inputs.push(input);
            at_place.push(input);
        }
        let part = match kind {
            Kind::Dot => Some(Part::Dot),
            Kind::Root => {
                // The operation's scope knows which root it is.
                netlist.part_of(netlist.node(operations[0].nodes[0]).scope).map(|(part, _)| part)
            }
            Kind::Divider => Some(Part::Divider),
            Kind::Table => {
                netlist.part_of(netlist.node(operations[0].nodes[0]).scope).map(|(part, _)| part)
            }
            Kind::Multiplier | Kind::Adder => None,
        };
        let body = |b: &mut Builder| {
            let mut made: Vec<NodeId> = Vec::new();
            for (position, shape) in structure.nodes.iter().enumerate() {
                let mut operands: Vec<NodeId> = shape
                    .operands
                    .iter()
                    .map(|wire| match wire {
                        Wire::Inner(inner) => made[*inner],
                        Wire::Place(place) => at_place[*place],
                    })
                    .collect();
                let mut op = shape.op;
                if kind == Kind::Adder
                    && let Op::Const { raw } = b.node(operands[0]).op
                {
                    op = if raw == 0 { Op::Add } else { Op::Sub };
                    operands.remove(0);
                }
                if let Op::Read { table, .. } = &mut op {
                    *table = b.table(netlist.tables()[table.index()].clone());
                }
                let asked = shape.asked.unwrap_or(Format::FLAG);
                let id = b.operation(op, &operands, asked);
                made.push(b.name(id, &format!("n{position}")));
            }
            made
        };
        let made = match part {
            Some(part) => b.part(part, "body", body),
            None => body(&mut b),
        };
        for (number, position) in structure.exports.iter().enumerate() {
            b.output(&format!("out{number}"), made[*position]);
        }
        let built = match b.build() {
            Ok(built) => built,
            Err(why) => {
                if let Some((_, _, bits)) = why.bits_needed() {
                    return Err(remedy(bits));
                }
                let names: Vec<&str> = operations.iter().map(|o| o.name.as_str()).collect();
                return Err(Error::usage(format!(
                    "unit `{name}`, shared by {}: {why}; or leave share_{}=auto",
                    names.join(", "),
                    kind.name()
                )));
            }
        };
        let positions = built
            .nodes()
            .iter()
            .map(|node| {
                let named = !matches!(node.op, Op::Input | Op::Const { .. });
                let name = node.name.as_ref().filter(|_| named)?;
                name.strip_prefix('n')?.parse().ok()
            })
            .collect();
        Ok(Self { netlist: Arc::new(built), ports, positions })
    }

    /// Stages for a latency, as even as the delay model allows.
    ///
    /// # Errors
    /// If reads on a clock need more cycles.
    pub(super) fn pipeline(&self, name: &str, rom: Rom, latency: u32) -> Result<Schedule> {
        let most = Schedule::greedy(&self.netlist, rom, u32::MAX).latency() - 1;
        if most > latency {
            return Err(Error::usage(format!(
                "unit `{name}` can't have a latency of {latency} cycles: its longest chain of clocked reads needs {most}; \
                 raise share_latency, or use rom=distributed"
            )));
        }
        let even = Schedule::pipeline(&self.netlist, rom, super::Depth::Stages(latency + 1))?;
        let stages = self.netlist.ids().map(|id| even.stage(id)).collect();
        Schedule::from_stages(&self.netlist, rom, stages, latency)
    }
}
