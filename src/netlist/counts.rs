//! Counts of a netlist's operators, tables and stored bits.

use super::{Netlist, NodeId, Part, ScopeId, Table};
use crate::base::cast;
use crate::netlist::op::{Op, Operator};
use crate::number::format::Narrowing;
use std::collections::BTreeSet;

/// How many operators of each kind a netlist has.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, serde::Serialize)]
pub struct Operators {
    /// `mul`.
    pub multipliers: u64,
    /// `add`, `sub` and `addsub`.
    pub adders: u64,
    /// `neg` and `abs`.
    pub negations: u64,
    /// `equal` and `less`.
    pub comparators: u64,
    /// `mux`.
    pub multiplexers: u64,
    /// `shift_left` and `leading_zeros`.
    pub shifters: u64,
    /// `narrow`: rounding, saturation, or only wires.
    pub narrows: u64,
    /// The `narrow`s that need an incrementer to round.
    pub rounders: u64,
}

/// Ports of a block RAM. A table with more ports is copied.
pub const RAM_PORTS: u64 = 2;

/// Counts over a whole netlist.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Counts {
    /// Operators of the datapath itself.
    pub datapath: Operators,
    /// Operators inside table schemes: folding, interpolation, the adder of a bipartite table.
    pub schemes: Operators,
    /// Operators inside dividers and roots, including those of their table schemes.
    pub parts: Operators,
    /// Dividers.
    pub dividers: u64,
    /// Square roots.
    pub square_roots: u64,
    /// Reciprocal square roots.
    pub reciprocal_roots: u64,
    /// Distinct tables.
    pub tables: u64,
    /// Words read: pairs of column and address.
    pub reads: u64,
    /// Table ports: pairs of table and address; a dual-port block RAM serves two.
    pub ports: u64,
    /// Stored bits of all tables, one copy each.
    pub rom_bits: u64,
    /// Stored bits when each table is copied so that every copy has at most two ports.
    pub rom_bits_dual_port: u64,
    /// Distinct memories; the table counts above exclude them.
    #[serde(skip_serializing_if = "is_zero")]
    pub memories: u64,
    /// Memory ports: pairs of memory and address.
    #[serde(skip_serializing_if = "is_zero")]
    pub memory_ports: u64,
    /// Stored bits of all memories.
    #[serde(skip_serializing_if = "is_zero")]
    pub memory_bits: u64,
}

/// True for a count of 0. Counts that are 0 in most netlists are then left out.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde gives references")]
pub(crate) fn is_zero(count: &u64) -> bool {
    *count == 0
}

impl Netlist {
    /// Counts operators, tables, ports and stored bits.
    #[must_use]
    pub fn counts(&self) -> Counts {
        self.counts_of(|_| true)
    }

    /// As [`Netlist::counts`], for the nodes in some scopes. A table counts where it is read.
    #[must_use]
    pub fn counts_of(&self, counted: impl Fn(ScopeId) -> bool) -> Counts {
        Self::counts_over(&[(self, &|id| counted(self.node(id).scope))])
    }

    /// As [`Netlist::counts`], for some nodes of several netlists that form one circuit. A table
    /// that several netlists read counts once, with a port for each.
    ///
    /// # Panics
    /// Never: parts are matched before.
    #[must_use]
    pub fn counts_over(netlists: &[(&Self, &dyn Fn(NodeId) -> bool)]) -> Counts {
        let mut counts = Counts {
            datapath: Operators::default(),
            schemes: Operators::default(),
            parts: Operators::default(),
            dividers: 0,
            square_roots: 0,
            reciprocal_roots: 0,
            tables: 0,
            reads: 0,
            ports: 0,
            rom_bits: 0,
            rom_bits_dual_port: 0,
            memories: 0,
            memory_ports: 0,
            memory_bits: 0,
        };
        let mut tables: Vec<(&Table, BTreeSet<(usize, NodeId)>)> = Vec::new();
        let mut parts: BTreeSet<(usize, ScopeId)> = BTreeSet::new();
        let all = netlists.iter().enumerate().flat_map(|(n, (netlist, counted))| {
            netlist.ids().filter(move |id| counted(*id)).map(move |id| (n, *netlist, id))
        });
        for (n, netlist, id) in all {
            let node = netlist.node(id);
            let operators = match netlist.part_of(node.scope) {
                None => &mut counts.datapath,
                Some((Part::Scheme, _)) => &mut counts.schemes,
                Some((part, scope)) => {
                    if parts.insert((n, scope)) {
                        match part {
                            Part::Divider => counts.dividers += 1,
                            Part::SquareRoot => counts.square_roots += 1,
                            Part::ReciprocalRoot => counts.reciprocal_roots += 1,
                            Part::Scheme | Part::Dot => unreachable!("bug: matched above"),
                        }
                    }
                    &mut counts.parts
                }
            };
            match node.op.traits().operator {
                None => {}
                Some(Operator::Multiplier) => operators.multipliers += 1,
                Some(Operator::Adder) => operators.adders += 1,
                Some(Operator::Negation) => operators.negations += 1,
                Some(Operator::Comparator) => operators.comparators += 1,
                Some(Operator::Multiplexer) => operators.multiplexers += 1,
                Some(Operator::Shifter) => operators.shifters += 1,
                Some(Operator::Narrow) => operators.narrows += 1,
                Some(Operator::Read) => counts.reads += u64::from(netlist.memory(id).is_none()),
            }
            if let Op::Narrow { round, overflow } = node.op {
                let from = netlist.node(node.operands[0]).format;
                let hardware = Narrowing::new(from, node.format, round, overflow);
                operators.rounders += u64::from(hardware.rounds);
            } else if let Op::Read { table, .. } = node.op {
                let table = &netlist.tables[table.index()];
                let known = tables.iter().position(|(known, _)| *known == table);
                let at = known.unwrap_or_else(|| {
                    tables.push((table, BTreeSet::new()));
                    tables.len() - 1
                });
                tables[at].1.insert((n, node.operands[0]));
            }
        }
        for (table, at) in tables {
            let ports = cast::count_of(at.len());
            if table.memory.is_some() {
                counts.memories += 1;
                counts.memory_ports += ports;
                counts.memory_bits += table.rom_bits();
                continue;
            }
            counts.tables += 1;
            counts.rom_bits += table.rom_bits();
            counts.ports += ports;
            counts.rom_bits_dual_port += table.rom_bits() * ports.div_ceil(RAM_PORTS);
        }
        counts
    }
}
