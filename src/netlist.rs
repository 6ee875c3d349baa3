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

use crate::cast;
use crate::error::{Error, Result};
use crate::format::{Format, Overflow, Round};
use crate::op::{FormatProblem, Meaning, Op};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fmt::Write as _;
use std::sync::Arc;

/// Index of a node in its netlist.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct NodeId(u32);

/// Index of a table in its netlist.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct TableId(u32);

/// Index of a scope in its netlist; scope 0 is the unit itself.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct ScopeId(u32);

impl NodeId {
    /// Position in [`Netlist::nodes`].
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "32 bits always fit")]
    pub fn index(self) -> usize {
        usize::try_from(self.0).expect("bug: 32 bits fit")
    }
}

impl TableId {
    /// Position in [`Netlist::tables`].
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "32 bits always fit")]
    pub fn index(self) -> usize {
        usize::try_from(self.0).expect("bug: 32 bits fit")
    }
}

impl ScopeId {
    /// Position in [`Netlist::scopes`].
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "32 bits always fit")]
    pub fn index(self) -> usize {
        usize::try_from(self.0).expect("bug: 32 bits fit")
    }
}

/// What a signal measures; says how waves and reports show it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Quantity {
    /// A plain number.
    #[default]
    Number,
    /// An angle in turns, equal modulo one.
    Turns,
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

/// A named group of nodes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scope {
    /// Name.
    pub name: String,
    /// Enclosing scope; `None` for the unit itself.
    pub parent: Option<ScopeId>,
    /// True for the logic of a table scheme: folding and interpolation are counted apart.
    pub is_scheme: bool,
}

/// One column of a table.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Column {
    /// Name.
    pub name: String,
    /// Format of its words.
    pub format: Format,
    /// One word per address.
    pub words: Arc<[i64]>,
}

/// A read-only table: columns of words that share an address.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Table {
    /// Name.
    pub name: String,
    /// Address bits; it has 2^addr_bits rows.
    pub addr_bits: u32,
    /// Its columns.
    pub columns: Vec<Column>,
}

impl Table {
    /// Format of an address.
    ///
    /// # Panics
    /// If the table has no address bits or more than 63.
    #[must_use]
    pub fn address_format(&self) -> Format {
        Format::integer(self.addr_bits).expect("bug: table size was checked when it was added")
    }

    /// Stored bits: rows times the width of a row.
    #[must_use]
    pub fn rom_bits(&self) -> u64 {
        let row: u32 = self.columns.iter().map(|column| column.format.bits()).sum();
        u64::from(row) << self.addr_bits
    }
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
}

/// Counts over a whole netlist.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Counts {
    /// Operators of the datapath itself.
    pub datapath: Operators,
    /// Operators inside table schemes: folding, interpolation, the addition of a bipartite table.
    pub schemes: Operators,
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
                    let [a, b] =
                        meaning.arguments().map(|id| id.map_or(0.0, |id| values[id.index()]));
                    meaning.eval(a, b)
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

    /// Counts operators, tables, ports and stored bits.
    #[must_use]
    pub fn counts(&self) -> Counts {
        let mut counts = Counts {
            datapath: Operators::default(),
            schemes: Operators::default(),
            tables: cast::count_of(self.tables.len()),
            reads: 0,
            ports: 0,
            rom_bits: self.tables.iter().map(Table::rom_bits).sum(),
            rom_bits_dual_port: 0,
        };
        let mut addresses: BTreeMap<TableId, BTreeSet<NodeId>> = BTreeMap::new();
        for node in &self.nodes {
            let scheme = self.scopes[node.scope.index()].is_scheme;
            let operators = if scheme { &mut counts.schemes } else { &mut counts.datapath };
            match node.op {
                Op::Mul => operators.multipliers += 1,
                Op::Add | Op::Sub | Op::AddSub => operators.adders += 1,
                Op::Neg | Op::Abs => operators.negations += 1,
                Op::Equal | Op::Less => operators.comparators += 1,
                Op::Mux => operators.multiplexers += 1,
                Op::LeadingZeros | Op::ShiftLeft { .. } => operators.shifters += 1,
                Op::Narrow { .. } => operators.narrows += 1,
                Op::Read { table, .. } => {
                    counts.reads += 1;
                    addresses.entry(table).or_default().insert(node.operands[0]);
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
        for (table, at) in addresses {
            let ports = cast::count_of(at.len());
            counts.ports += ports;
            counts.rom_bits_dual_port += self.tables[table.index()].rom_bits() * ports.div_ceil(2);
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
            if node.quantity == Quantity::Turns {
                text.push_str(" turns");
            }
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
                } else if scope.is_scheme {
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

/// Grows a netlist.
///
/// The first mistake is kept and returned by [`Builder::build`], so that a datapath is
/// written as plain expressions.
#[derive(Debug)]
pub struct Builder {
    netlist: Netlist,
    known: HashMap<(Op, Vec<NodeId>, Format), NodeId>,
    scope: ScopeId,
    error: Option<Error>,
}

impl Builder {
    /// Starts an empty netlist.
    #[must_use]
    pub fn new(name: &str) -> Self {
        let root = Scope { name: name.to_owned(), parent: None, is_scheme: false };
        Self {
            netlist: Netlist {
                name: name.to_owned(),
                nodes: Vec::new(),
                scopes: vec![root],
                tables: Vec::new(),
                inputs: Vec::new(),
                outputs: Vec::new(),
            },
            known: HashMap::new(),
            scope: ScopeId(0),
            error: None,
        }
    }

    /// Format of a node.
    #[must_use]
    pub fn format(&self, id: NodeId) -> Format {
        self.netlist.node(id).format
    }

    /// Keeps the first error.
    pub fn fail(&mut self, error: Error) {
        self.error.get_or_insert(error);
    }

    /// Takes a format, or keeps its error and goes on with a placeholder.
    pub fn checked(&mut self, format: Result<Format>) -> Format {
        format.unwrap_or_else(|error| {
            self.fail(error);
            Format::FLAG
        })
    }

    fn push(&mut self, op: Op, operands: &[NodeId], asked: Option<Format>) -> NodeId {
        let formats: Vec<Format> = operands.iter().map(|id| self.format(*id)).collect();
        let format =
            op.result_format(&formats, asked, &self.netlist.tables).unwrap_or_else(|why| {
                let operand =
                    operands.first().map(|id| self.netlist.label(*id)).unwrap_or_default();
                let node = format!("{} of {operand}", op.name());
                self.fail(match why {
                    FormatProblem::TooWide(bits) => {
                        Error::node_too_wide(node, bits, Format::MAX_BITS)
                    }
                    FormatProblem::Mismatch(problem) => Error::node(node, problem),
                });
                asked.unwrap_or(Format::FLAG)
            });
        let key = (op, operands.to_vec(), format);
        if op != Op::Input
            && let Some(id) = self.known.get(&key)
        {
            return *id;
        }
        let id = NodeId(cast::id_of(self.netlist.nodes.len()));
        self.netlist.nodes.push(Node {
            op,
            operands: operands.to_vec(),
            format,
            name: None,
            scope: self.scope,
            quantity: Quantity::Number,
            meaning: None,
            has_real: false,
        });
        self.known.insert(key, id);
        id
    }

    /// Builds the nodes of `body` in a named scope.
    pub fn scope<R>(&mut self, name: &str, body: impl FnOnce(&mut Self) -> R) -> R {
        self.in_scope(name, false, body)
    }

    /// As [`Builder::scope`], for the logic around a table.
    pub fn scheme_scope<R>(&mut self, name: &str, body: impl FnOnce(&mut Self) -> R) -> R {
        self.in_scope(name, true, body)
    }

    fn in_scope<R>(&mut self, name: &str, is_scheme: bool, body: impl FnOnce(&mut Self) -> R) -> R {
        let outer = self.scope;
        let scope = Scope { name: name.to_owned(), parent: Some(outer), is_scheme };
        let found = self.netlist.scopes.iter().position(|known| *known == scope);
        let index = found.unwrap_or_else(|| {
            self.netlist.scopes.push(scope);
            self.netlist.scopes.len() - 1
        });
        self.scope = ScopeId(cast::id_of(index));
        let result = body(self);
        self.scope = outer;
        result
    }

    /// Names a node, in the scope that it was built in; a node keeps its first name.
    pub fn name(&mut self, id: NodeId, name: &str) -> NodeId {
        let node = &mut self.netlist.nodes[id.index()];
        if node.name.is_none() {
            node.name = Some(name.to_owned());
        }
        id
    }

    /// Says that a node is an angle in turns.
    pub fn turns(&mut self, id: NodeId) -> NodeId {
        self.netlist.nodes[id.index()].quantity = Quantity::Turns;
        id
    }

    /// Says what a node stands for on reals; a node keeps its first meaning.
    pub fn means(&mut self, id: NodeId, meaning: Meaning) -> NodeId {
        self.netlist.nodes[id.index()].meaning.get_or_insert(meaning);
        id
    }

    /// Adds an input port.
    pub fn input(&mut self, name: &str, format: Format, quantity: Quantity) -> NodeId {
        let id = self.push(Op::Input, &[], Some(format));
        self.netlist.nodes[id.index()].quantity = quantity;
        self.netlist.inputs.push(id);
        self.name(id, name)
    }

    /// Adds an output port.
    pub fn output(&mut self, name: &str, node: NodeId) {
        self.netlist.outputs.push(Output { name: name.to_owned(), node });
    }

    /// Adds a table; an identical one that is there already is used again.
    ///
    /// # Panics
    /// If a column doesn't have one word of its format per address: that is wrong code.
    pub fn table(&mut self, table: Table) -> TableId {
        let index = self.netlist.tables.iter().position(|known| *known == table);
        let index = index.unwrap_or_else(|| {
            if table.addr_bits == 0 || table.addr_bits > 30 {
                let problem = format!("{} address bits: legal is 1 to 30", table.addr_bits);
                self.fail(Error::node(table.name.clone(), problem));
            }
            for column in &table.columns {
                assert_eq!(column.words.len(), 1 << table.addr_bits, "bug: one word per address");
                assert!(
                    column.words.iter().all(|word| column.format.contains(*word)),
                    "bug: `{}.{}` has words outside its format",
                    table.name,
                    column.name
                );
            }
            self.netlist.tables.push(table);
            self.netlist.tables.len() - 1
        });
        TableId(cast::id_of(index))
    }

    /// The constant word `raw`.
    pub fn constant(&mut self, raw: i64, format: Format) -> NodeId {
        self.push(Op::Const { raw }, &[], Some(format))
    }

    /// `a + b`.
    pub fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Add, &[a, b], None)
    }

    /// `a - b`.
    pub fn sub(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Sub, &[a, b], None)
    }

    /// `a - b` where `flag` is set, else `a + b`.
    pub fn addsub(&mut self, flag: NodeId, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::AddSub, &[flag, a, b], None)
    }

    /// `a * b`.
    pub fn mul(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Mul, &[a, b], None)
    }

    /// `-a`.
    pub fn neg(&mut self, a: NodeId) -> NodeId {
        self.push(Op::Neg, &[a], None)
    }

    /// `|a|`.
    pub fn abs(&mut self, a: NodeId) -> NodeId {
        self.push(Op::Abs, &[a], None)
    }

    /// Bitwise and.
    pub fn and(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::And, &[a, b], None)
    }

    /// Bitwise or.
    pub fn or(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Or, &[a, b], None)
    }

    /// Bitwise exclusive or.
    pub fn xor(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Xor, &[a, b], None)
    }

    /// Flag `a = b`.
    pub fn equal(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Equal, &[a, b], None)
    }

    /// Flag `a < b`.
    pub fn less(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Less, &[a, b], None)
    }

    /// `a` where `flag` is set, else `b`.
    pub fn mux(&mut self, flag: NodeId, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Mux, &[flag, a, b], None)
    }

    /// `bits` bits of a word from bit `lo` up, as an integer.
    pub fn slice(&mut self, a: NodeId, lo: u32, bits: u32) -> NodeId {
        let format = self.checked(Format::integer(bits));
        self.push(Op::Slice { lo }, &[a], Some(format))
    }

    /// The bits of `high` above the bits of `low`.
    pub fn concat(&mut self, high: NodeId, low: NodeId) -> NodeId {
        self.push(Op::Concat, &[high, low], None)
    }

    /// The sign bit of a signed word as a flag.
    ///
    /// # Panics
    /// If the word is unsigned.
    pub fn negative(&mut self, a: NodeId) -> NodeId {
        assert!(self.format(a).is_signed(), "bug: an unsigned word has no sign");
        let sign = self.slice(a, self.format(a).bits() - 1, 1);
        self.means(sign, Meaning::Negative(a))
    }

    /// `a * 2^left` by moving the binary point.
    pub fn shift(&mut self, a: NodeId, left: i32) -> NodeId {
        if left == 0 { a } else { self.push(Op::Shift { left }, &[a], None) }
    }

    /// Zero bits above the first one.
    pub fn leading_zeros(&mut self, a: NodeId) -> NodeId {
        self.push(Op::LeadingZeros, &[a], None)
    }

    /// `a * 2^min(n, max)`.
    pub fn shift_left(&mut self, a: NodeId, n: NodeId, max: u32) -> NodeId {
        self.push(Op::ShiftLeft { max }, &[a, n], None)
    }

    /// The word of a column at an address.
    ///
    /// # Panics
    /// If the table has no such column.
    pub fn read(&mut self, table: TableId, column: usize, address: NodeId) -> NodeId {
        assert!(column < self.netlist.tables[table.index()].columns.len(), "bug: no such column");
        self.push(Op::Read { table, column: cast::id_of(column) }, &[address], None)
    }

    /// The residue of `a` modulo the span of `format`.
    pub fn modulo(&mut self, a: NodeId, format: Format) -> NodeId {
        if self.format(a) == format { a } else { self.push(Op::Modulo, &[a], Some(format)) }
    }

    /// `a` in `format`: the one way to lose bits.
    pub fn narrow(
        &mut self,
        a: NodeId,
        format: Format,
        round: Round,
        overflow: Overflow,
    ) -> NodeId {
        // Only symmetric saturation changes a word that is in the format already.
        if self.format(a) == format && overflow != Overflow::Symmetric {
            return a;
        }
        self.push(Op::Narrow { round, overflow }, &[a], Some(format))
    }

    /// Verifies and freezes the netlist; nodes and tables that no output needs are gone.
    ///
    /// # Errors
    /// The first mistake made while building: a word past 63 bits, operands that don't fit.
    ///
    /// # Panics
    /// If ports are missing, share a name, or a name is no identifier: that is wrong code.
    pub fn build(self) -> Result<Netlist> {
        if let Some(error) = self.error {
            return Err(error);
        }
        let old = self.netlist;
        assert!(!old.outputs.is_empty(), "bug: `{}` has no output", old.name);

        let mut live = vec![false; old.nodes.len()];
        for id in &old.inputs {
            live[id.index()] = true;
        }
        for output in &old.outputs {
            live[output.node.index()] = true;
        }
        for (index, node) in old.nodes.iter().enumerate().rev() {
            if live[index] {
                node.operands.iter().for_each(|id| live[id.index()] = true);
            }
        }

        let mut new_ids = vec![NodeId(u32::MAX); old.nodes.len()];
        let mut new_tables: Vec<Option<TableId>> = vec![None; old.tables.len()];
        let mut netlist = Netlist {
            name: old.name,
            nodes: Vec::new(),
            scopes: old.scopes,
            tables: Vec::new(),
            inputs: Vec::new(),
            outputs: Vec::new(),
        };
        let mut names = BTreeSet::new();
        for (index, mut node) in old.nodes.into_iter().enumerate().filter(|(i, _)| live[*i]) {
            for operand in &mut node.operands {
                *operand = new_ids[operand.index()];
            }
            node.meaning = node.meaning.map(|meaning| meaning.map(|id| new_ids[id.index()]));
            if let Op::Read { table, .. } = &mut node.op {
                let new = *new_tables[table.index()].get_or_insert_with(|| {
                    netlist.tables.push(old.tables[table.index()].clone());
                    TableId(cast::id_of(netlist.tables.len() - 1))
                });
                *table = new;
            }
            let real = |id: NodeId| {
                let node: Option<&Node> = netlist.nodes.get(id.index());
                node.expect("bug: a meaning names a node that no output needs").has_real
            };
            node.has_real = match node.meaning {
                Some(meaning) => meaning.arguments().into_iter().flatten().all(real),
                None => node.op.has_real(node.format) && node.operands.iter().all(|id| real(*id)),
            };
            if let Some(name) = node.name.take() {
                assert!(is_identifier(&name), "bug: `{name}` is no identifier");
                let unique = (1..)
                    .map(|n| if n == 1 { name.clone() } else { format!("{name}_{n}") })
                    .find(|name| names.insert((node.scope, name.clone())));
                node.name = unique;
            }
            let id = NodeId(cast::id_of(netlist.nodes.len()));
            new_ids[index] = id;
            if node.op == Op::Input {
                netlist.inputs.push(id);
            }
            netlist.nodes.push(node);
        }
        for output in old.outputs {
            let fresh = netlist.outputs.iter().all(|known| known.name != output.name);
            assert!(fresh && is_identifier(&output.name), "bug: output name `{}`", output.name);
            netlist.outputs.push(Output { node: new_ids[output.node.index()], ..output });
        }
        netlist.verify();
        Ok(netlist)
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

/// True for names that are legal in VCD, Verilog and VHDL.
fn is_identifier(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_lowercase())
        && name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_')
        && !name.ends_with('_')
        && !name.contains("__")
}
