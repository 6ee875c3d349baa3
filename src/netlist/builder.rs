//! Growing a netlist, step by checked step.

use super::{Netlist, Node, NodeId, Output, Part, Quantity, Scope, ScopeId, Table, TableId};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::name;
use crate::netlist::op::{FormatProblem, Meaning, Op};
use crate::number::format::{Format, Overflow, Round};
use std::collections::{BTreeSet, HashMap};

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
        let root = Scope { name: name.to_owned(), parent: None, part: None };
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

    /// Starts a netlist called `name` with the scopes of another, which is rebuilt node by node.
    pub(crate) fn rebuild(of: &Netlist, name: &str) -> Self {
        let mut builder = Self::new(name);
        builder.netlist.scopes.extend(of.scopes.iter().skip(1).cloned());
        builder
    }

    /// Builds the next nodes in a scope that is there already.
    pub(crate) fn enter(&mut self, scope: ScopeId) {
        self.scope = scope;
    }

    /// Number of nodes so far.
    pub(crate) fn len(&self) -> usize {
        self.netlist.nodes.len()
    }

    /// A node so far.
    pub(crate) fn node(&self, id: NodeId) -> &Node {
        self.netlist.node(id)
    }

    /// The tables so far.
    pub(crate) fn tables(&self) -> &[Table] {
        &self.netlist.tables
    }

    /// Any operation but a port; `asked` is its format, where the operation takes one.
    pub fn operation(&mut self, op: Op, operands: &[NodeId], asked: Format) -> NodeId {
        self.push(op, operands, Some(asked))
    }

    /// Format of a node.
    #[must_use]
    pub fn format(&self, id: NodeId) -> Format {
        self.netlist.node(id).format
    }

    /// True once there was a mistake: `build` will return it.
    #[must_use]
    pub fn has_failed(&self) -> bool {
        self.error.is_some()
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
                let place = self.netlist.nodes.len();
                self.fail(match why {
                    FormatProblem::TooWide(bits) => {
                        Error::node_too_wide(node, place, bits, Format::MAX_BITS)
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
        self.in_scope(name, None, body)
    }

    /// As [`Builder::scope`], for nodes that are counted as one operator.
    pub fn part<R>(&mut self, part: Part, name: &str, body: impl FnOnce(&mut Self) -> R) -> R {
        self.in_scope(name, Some(part), body)
    }

    fn in_scope<R>(
        &mut self,
        name: &str,
        part: Option<Part>,
        body: impl FnOnce(&mut Self) -> R,
    ) -> R {
        let outer = self.scope;
        let scope = Scope { name: name.to_owned(), parent: Some(outer), part };
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

    /// As [`Builder::build`], but a meaning of a node that no output needs is dropped.
    pub(crate) fn build_rebuilt(mut self) -> Result<Netlist> {
        let live = live(&self.netlist);
        for node in &mut self.netlist.nodes {
            node.meaning = node.meaning.filter(|meaning| {
                meaning.arguments().into_iter().flatten().all(|id| live[id.index()])
            });
        }
        self.build()
    }

    /// Verifies and freezes the netlist; nodes and tables that no output needs are gone.
    ///
    /// # Errors
    /// The first mistake made while building: a word past 63 bits, operands that don't fit.
    ///
    /// # Panics
    /// If ports are missing, share a name, a name is no identifier, or a node means something of
    /// a node that no output needs: that is wrong code.
    pub fn build(self) -> Result<Netlist> {
        if let Some(error) = self.error {
            return Err(error);
        }
        let old = self.netlist;
        assert!(!old.outputs.is_empty(), "bug: `{}` has no output", old.name);
        let input_named = |name: &str| {
            old.inputs.iter().any(|id| old.nodes[id.index()].name.as_deref() == Some(name))
        };
        if let Some(Output { name, .. }) = old.outputs.iter().find(|o| input_named(&o.name)) {
            return Err(Error::usage(format!(
                "`{name}` is an input and an output of `{}`: give one of them another name",
                old.name
            )));
        }

        let live = live(&old);
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
        // Ports have their names first: whatever else is called so gets a number.
        let mut names: BTreeSet<(ScopeId, String)> = BTreeSet::new();
        for id in &old.inputs {
            let node = &old.nodes[id.index()];
            let name = node.name.clone().expect("bug: inputs are named");
            assert!(name::is_legal(&name), "bug: `{name}` is no identifier");
            assert!(names.insert((node.scope, name)), "bug: two inputs share a name");
        }
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
            if node.op != Op::Input
                && let Some(name) = node.name.take()
            {
                assert!(name::is_legal(&name), "bug: `{name}` is no identifier");
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
            assert!(fresh && name::is_legal(&output.name), "bug: output name `{}`", output.name);
            netlist.outputs.push(Output { node: new_ids[output.node.index()], ..output });
        }
        netlist.verify();
        Ok(netlist)
    }
}

/// Which nodes the outputs need, with all ports.
fn live(netlist: &Netlist) -> Vec<bool> {
    let mut live = vec![false; netlist.nodes.len()];
    for id in &netlist.inputs {
        live[id.index()] = true;
    }
    for output in &netlist.outputs {
        live[output.node.index()] = true;
    }
    for (index, node) in netlist.nodes.iter().enumerate().rev() {
        if live[index] {
            node.operands.iter().for_each(|id| live[id.index()] = true);
        }
    }
    live
}
