//! The netlist: a flat arena of nodes whose operands are earlier nodes.
//!
//! Creation order is evaluation order, so a combinational loop can't be
//! written. [`Builder`] grows it and checks every step; [`Builder::build`] drops
//! what no output needs and returns an immutable [`Netlist`]. Building the same
//! operation on the same operands twice gives the same node: a table read at an
//! address is one port, however often it is used.
//!
//! The reference interpreter ([`Netlist::eval`] on words, [`Netlist::eval_reals`]
//! on reals) is a loop over [`Op`]; every other engine is held to it bit for bit.

mod builder;
mod id;
pub mod op;
pub(crate) mod ranges;
mod table;
pub(crate) mod words;

pub use builder::Builder;
pub use id::{NodeId, ScopeId, TableId};
pub use table::{Column, Table};

use crate::base::cast;
use crate::netlist::op::{Meaning, Op};
use crate::number::format::{Format, Narrowing};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// What a signal measures; says how waves and reports show it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Quantity {
    /// A plain number.
    #[default]
    Number,
    /// An angle in turns, equal modulo one.
    Turns,
    /// A number that comes as a float of 20 bits ([`crate::number::format::float20`]).
    Float20,
}

/// One node: an operation on earlier nodes.
#[derive(Clone, Debug)]
pub struct Node {
    /// The operation.
    pub op: Op,
    /// Its operands, [`Op::arity`] of them.
    pub operands: Vec<NodeId>,
    /// Format of its word.
    pub format: Format,
    /// Name, unique in its scope.
    pub name: Option<String>,
    /// Scope that it was built in.
    pub scope: ScopeId,
    /// What it measures.
    pub quantity: Quantity,
    /// What it stands for on reals, if not its operation.
    pub meaning: Option<Meaning>,
    /// True if it has a value on reals.
    pub has_real: bool,
}

/// A part that is counted as one operator, whatever it is made of.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Part {
    /// A table with the logic around it: folding and interpolation are counted apart.
    Scheme,
    /// A divider.
    Divider,
    /// A square root.
    SquareRoot,
    /// A reciprocal square root.
    ReciprocalRoot,
    /// A dot product of three: three multipliers and two adders, which count as the datapath's own.
    Dot,
}

/// A named group of nodes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scope {
    /// Name.
    pub name: String,
    /// Enclosing scope; `None` for the unit itself.
    pub parent: Option<ScopeId>,
    /// What it is, if its nodes are counted as one operator.
    pub part: Option<Part>,
}

/// An output port.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    /// Name.
    pub name: String,
    /// The node that drives it.
    pub node: NodeId,
}

/// An immutable, verified datapath.
#[derive(Clone, Debug)]
pub struct Netlist {
    name: String,
    nodes: Vec<Node>,
    scopes: Vec<Scope>,
    tables: Vec<Table>,
    inputs: Vec<NodeId>,
    outputs: Vec<Output>,
}

/// How many operators of each sort a netlist has.
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
    /// Those of them that take an incrementer to round.
    pub rounders: u64,
}

/// Ports of a block RAM: a table that is read through more is copied.
pub const RAM_PORTS: u64 = 2;

/// Counts over a whole netlist.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Counts {
    /// Operators of the datapath itself.
    pub datapath: Operators,
    /// Operators inside table schemes: folding, interpolation, the addition of a bipartite table.
    pub schemes: Operators,
    /// Operators inside dividers and roots, with the table schemes there.
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
    /// Stored bits when each table is copied until two ports a copy suffice.
    pub rom_bits_dual_port: u64,
}

impl Netlist {
    /// Name of the unit.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// All nodes; operands come before users.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// One node.
    #[must_use]
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.index()]
    }

    /// All node ids in order.
    pub fn ids(&self) -> impl DoubleEndedIterator<Item = NodeId> + ExactSizeIterator + use<> {
        (0..cast::id_of(self.nodes.len())).map(NodeId)
    }

    /// Id of the node at a position in [`Netlist::nodes`].
    #[must_use]
    pub(crate) fn id_at(&self, index: usize) -> NodeId {
        NodeId(cast::id_of(index))
    }

    /// All scopes; parents come before children.
    #[must_use]
    pub fn scopes(&self) -> &[Scope] {
        &self.scopes
    }

    /// All tables.
    #[must_use]
    pub fn tables(&self) -> &[Table] {
        &self.tables
    }

    /// Input nodes in port order.
    #[must_use]
    pub fn inputs(&self) -> &[NodeId] {
        &self.inputs
    }

    /// Output ports in order.
    #[must_use]
    pub fn outputs(&self) -> &[Output] {
        &self.outputs
    }

    /// Name of an input port.
    ///
    /// # Panics
    /// If there is no such port.
    #[must_use]
    pub fn input_name(&self, port: usize) -> &str {
        self.node(self.inputs[port]).name.as_deref().expect("bug: inputs are named")
    }

    /// Names of the scopes from the outermost in, without the unit itself.
    #[must_use]
    pub fn scope_path(&self, scope: ScopeId) -> Vec<&str> {
        let mut path = Vec::new();
        let mut at = &self.scopes[scope.index()];
        while let Some(parent) = at.parent {
            path.push(at.name.as_str());
            at = &self.scopes[parent.index()];
        }
        path.reverse();
        path
    }

    /// `scope.name` of a node, or `scope.%7` if it has no name.
    #[must_use]
    pub fn label(&self, id: NodeId) -> String {
        let node = self.node(id);
        let mut path = self.scope_path(node.scope).join(".");
        if !path.is_empty() {
            path.push('.');
        }
        match &node.name {
            Some(name) => path + name,
            None => format!("{path}%{}", id.0),
        }
    }

    /// Evaluates every node on words: the reference that all engines are held to.
    ///
    /// Returns the word of each node and the flags of the `narrow`s that overflowed.
    ///
    /// # Panics
    /// If `inputs` doesn't hold one word of each input's format.
    #[must_use]
    pub fn eval(&self, inputs: &[i64]) -> (Vec<i64>, Vec<bool>) {
        assert_eq!(inputs.len(), self.inputs.len(), "bug: one word per input");
        let mut words: Vec<i64> = Vec::with_capacity(self.nodes.len());
        let mut overflowed = Vec::with_capacity(self.nodes.len());
        let mut ports = inputs.iter();
        for node in &self.nodes {
            let (word, flag) = if node.op == Op::Input {
                (*ports.next().expect("bug: counted above"), false)
            } else {
                let mut of = [(0, Format::FLAG); 3];
                for (slot, id) in of.iter_mut().zip(&node.operands) {
                    *slot = (words[id.index()], self.node(*id).format);
                }
                node.op.eval_raw(&of[..node.operands.len()], node.format, &self.tables)
            };
            assert!(node.format.contains(word), "bug: {word} is no word of {}", node.format);
            words.push(word);
            overflowed.push(flag);
        }
        (words, overflowed)
    }

    /// Evaluates every node on reals: `narrow` keeps its operand and tables are their functions.
    ///
    /// A node without a value on reals gives NaN.
    ///
    /// # Panics
    /// If `inputs` doesn't hold one value per input.
    #[must_use]
    pub fn eval_reals(&self, inputs: &[f64]) -> Vec<f64> {
        assert_eq!(inputs.len(), self.inputs.len(), "bug: one value per input");
        let mut values: Vec<f64> = Vec::with_capacity(self.nodes.len());
        let mut ports = inputs.iter();
        for node in &self.nodes {
            let value = match node.meaning {
                _ if node.op == Op::Input => *ports.next().expect("bug: counted above"),
                Some(meaning) => {
                    let of = meaning.arguments();
                    meaning.eval(of.map(|id| id.map_or(0.0, |id| values[id.index()])))
                }
                None => {
                    let mut of = [0.0; 3];
                    for (slot, id) in of.iter_mut().zip(&node.operands) {
                        *slot = values[id.index()];
                    }
                    node.op.eval_real(of, node.format)
                }
            };
            values.push(if node.has_real { value } else { f64::NAN });
        }
        values
    }

    /// The outermost part with operators that are counted apart that a scope is or stands in.
    #[must_use]
    pub fn part_of(&self, scope: ScopeId) -> Option<(Part, ScopeId)> {
        let mut found = None;
        let mut at = Some(scope);
        while let Some(id) = at {
            let scope = &self.scopes[id.index()];
            found = scope.part.filter(|part| *part != Part::Dot).map(|part| (part, id)).or(found);
            at = scope.parent;
        }
        found
    }

    /// Counts operators, tables, ports and stored bits.
    #[must_use]
    pub fn counts(&self) -> Counts {
        self.counts_of(|_| true)
    }

    /// As [`Netlist::counts`], of the nodes in some scopes; a table counts where it is read.
    #[must_use]
    pub fn counts_of(&self, counted: impl Fn(ScopeId) -> bool) -> Counts {
        Self::counts_over(&[(self, &|id| counted(self.node(id).scope))])
    }

    /// As [`Netlist::counts`], of some nodes of several netlists that are one hardware: a table
    /// that several read is one, with a port for each.
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
            match node.op {
                Op::Mul => operators.multipliers += 1,
                Op::Add | Op::Sub | Op::AddSub => operators.adders += 1,
                Op::Neg | Op::Abs => operators.negations += 1,
                Op::Equal | Op::Less => operators.comparators += 1,
                Op::Mux => operators.multiplexers += 1,
                Op::LeadingZeros | Op::ShiftLeft { .. } => operators.shifters += 1,
                Op::Narrow { round, overflow } => {
                    let from = netlist.node(node.operands[0]).format;
                    let hardware = Narrowing::new(from, node.format, round, overflow);
                    operators.narrows += 1;
                    operators.rounders += u64::from(hardware.rounds);
                }
                Op::Read { table, .. } => {
                    counts.reads += 1;
                    let table = &netlist.tables[table.index()];
                    let known = tables.iter().position(|(known, _)| *known == table);
                    let at = known.unwrap_or_else(|| {
                        tables.push((table, BTreeSet::new()));
                        tables.len() - 1
                    });
                    tables[at].1.insert((n, node.operands[0]));
                }
                Op::Input
                | Op::Const { .. }
                | Op::And
                | Op::Or
                | Op::Xor
                | Op::Slice { .. }
                | Op::Concat
                | Op::Shift { .. }
                | Op::Modulo => {}
            }
        }
        for (table, at) in tables {
            let ports = cast::count_of(at.len());
            counts.tables += 1;
            counts.rom_bits += table.rom_bits();
            counts.ports += ports;
            counts.rom_bits_dual_port += table.rom_bits() * ports.div_ceil(RAM_PORTS);
        }
        counts
    }

    /// Readable text form: one line per node.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut text = format!("netlist {}\n", self.name);
        for table in &self.tables {
            let columns: Vec<String> =
                table.columns.iter().map(|c| format!("{} {}", c.name, c.format)).collect();
            let _ = writeln!(
                text,
                "  table {}[{}]: {}",
                table.name,
                1u64 << table.addr_bits,
                columns.join(", ")
            );
        }
        for (id, node) in self.ids().zip(&self.nodes) {
            let _ = write!(text, "  %{} = {}", id.0, self.describe(node));
            for operand in &node.operands {
                let _ = write!(text, " %{}", operand.0);
            }
            let _ = write!(text, " : {}", node.format);
            text.push_str(match node.quantity {
                Quantity::Number => "",
                Quantity::Turns => " turns",
                Quantity::Float20 => " float20",
            });
            if node.name.is_some() {
                let _ = write!(text, "  # {}", self.label(id));
            }
            text.push('\n');
        }
        for output in &self.outputs {
            let _ = writeln!(text, "  output {} = %{}", output.name, output.node.0);
        }
        text
    }

    /// Operation with its attributes, without operands.
    fn describe(&self, node: &Node) -> String {
        let name = node.op.name();
        match node.op {
            Op::Const { raw } => format!("{name} {raw}"),
            Op::Slice { lo } => {
                format!("{name}[{}:{lo}]", lo + node.format.bits() - 1)
            }
            Op::Shift { left } => format!("{name} {left:+}"),
            Op::ShiftLeft { max } => format!("{name} max {max}"),
            Op::Read { table, column } => {
                let table = &self.tables[table.index()];
                let column = &table.columns[usize::try_from(column).expect("bug: small")];
                format!("{name} {}.{}", table.name, column.name)
            }
            Op::Narrow { round, overflow } => format!("{name} {round} {overflow}"),
            Op::Input
            | Op::Add
            | Op::Sub
            | Op::AddSub
            | Op::Mul
            | Op::Neg
            | Op::Abs
            | Op::And
            | Op::Or
            | Op::Xor
            | Op::Equal
            | Op::Less
            | Op::Mux
            | Op::Concat
            | Op::LeadingZeros
            | Op::Modulo => name.to_owned(),
        }
    }

    /// Graphviz form: scopes are clusters.
    #[must_use]
    pub fn to_dot(&self) -> String {
        let mut text = format!(
            "digraph {} {{\n  rankdir=LR;\n  node [shape=box, fontname=\"sans-serif\", fontsize=10];\n",
            self.name
        );
        for (s, scope) in self.scopes.iter().enumerate() {
            let indent = if s == 0 { "  " } else { "    " };
            if s > 0 {
                let path = self.scope_path(ScopeId(cast::id_of(s))).join(".");
                let _ = writeln!(text, "  subgraph cluster_{s} {{ label=\"{path}\"; color=gray;");
            }
            for (id, node) in self.ids().zip(&self.nodes).filter(|(_, n)| n.scope.index() == s) {
                let name = node.name.as_deref().map(|n| format!("{n}\\n")).unwrap_or_default();
                let shape = if node.op == Op::Input {
                    ", shape=cds"
                } else if matches!(node.op, Op::Read { .. }) {
                    ", shape=cylinder"
                } else if node.op == Op::Mul {
                    ", style=filled, fillcolor=\"#ffd9b3\""
                } else if scope.part.is_some() {
                    ", style=dotted"
                } else {
                    ""
                };
                let _ = writeln!(
                    text,
                    "{indent}n{} [label=\"{name}{}\\n{}\"{shape}];",
                    id.0,
                    self.describe(node),
                    node.format
                );
            }
            if s > 0 {
                text.push_str("  }\n");
            }
        }
        for (id, node) in self.ids().zip(&self.nodes) {
            for operand in &node.operands {
                let _ = writeln!(text, "  n{} -> n{};", operand.0, id.0);
            }
        }
        for output in &self.outputs {
            let _ = writeln!(
                text,
                "  out_{0} [label=\"{0}\", shape=cds]; n{1} -> out_{0};",
                output.name, output.node.0
            );
        }
        text.push_str("}\n");
        text
    }
}

impl Netlist {
    /// Checks what every netlist promises.
    fn verify(&self) {
        for (id, node) in self.ids().zip(&self.nodes) {
            assert!(
                node.operands.iter().all(|operand| *operand < id),
                "bug: operands of %{} come later",
                id.0
            );
            let formats: Vec<Format> =
                node.operands.iter().map(|id| self.node(*id).format).collect();
            let format = node.op.result_format(&formats, Some(node.format), &self.tables);
            assert_eq!(format.as_ref(), Ok(&node.format), "bug: format of {}", self.label(id));
        }
    }
}
