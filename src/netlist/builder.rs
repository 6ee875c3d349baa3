//! Builds a netlist and checks every step.

use super::choices::{Asked, Overrides, Place, SchemeChoice};
use super::id::Owner;
use super::{
    Meaning, Memory, Netlist, Node, NodeId, Output, Part, Quantity, Rate, Scope, ScopeId, Table,
    TableId,
};
use crate::base::cast;
use crate::base::error::{Error, Operation, Result};
use crate::base::{escape, name};
use crate::netlist::op::{FormatProblem, Op};
use crate::number::format::{Format, Overflow, Round};
use crate::number::real::{Expr, Graph};
use std::cell::OnceCell;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::panic::Location;

/// Builds a netlist.
///
/// A datapath is written as plain expressions. The first mistake is kept and returned by
/// [`Builder::build`]: a word wider than 63 bits, operands that don't fit, a node of another
/// builder, or an illegal name ([rules](super#names)). No method panics on wrong use.
#[derive(Debug)]
pub struct Builder {
    netlist: Netlist,
    owner: Owner,
    known: HashMap<(Op, Vec<NodeId>, Format), NodeId>,
    scope: ScopeId,
    overrides: Overrides,
    /// Number of `narrow`s requested in each scope.
    narrows: BTreeMap<ScopeId, u32>,
    asked: Vec<Asked>,
    schemes: Vec<SchemeChoice>,
    error: OnceCell<Error>,
}

impl Builder {
    /// Starts an empty netlist.
    #[must_use]
    #[track_caller]
    pub fn new(name: &str) -> Self {
        Self::with(name, &Overrides::default())
    }

    /// As [`Builder::new`], with overridden formats for some nodes.
    #[must_use]
    #[track_caller]
    pub fn with(name: &str, overrides: &Overrides) -> Self {
        let root = Scope { name: name.to_owned(), parent: None, part: None };
        let builder = Self {
            netlist: Netlist {
                name: name.to_owned(),
                nodes: Vec::new(),
                scopes: vec![root],
                tables: Vec::new(),
                inputs: Vec::new(),
                outputs: Vec::new(),
                reals: Graph::default(),
                choices: Vec::new(),
                schemes: Vec::new(),
            },
            owner: Owner::builder(),
            known: HashMap::new(),
            scope: ScopeId::ROOT,
            overrides: overrides.clone(),
            narrows: BTreeMap::new(),
            asked: Vec::new(),
            schemes: Vec::new(),
            error: OnceCell::new(),
        };
        builder.check_name("netlist", name);
        builder
    }

    /// Starts a netlist `name` with the scopes of another, which is then rebuilt node by node.
    pub(crate) fn rebuild(of: &Netlist, name: &str) -> Self {
        let mut builder = Self::new(name);
        builder.netlist.scopes.extend(of.scopes.iter().skip(1).cloned());
        builder
    }

    /// Builds the next nodes in an existing scope.
    pub(crate) fn enter(&mut self, scope: ScopeId) {
        self.scope = scope;
    }

    /// Number of nodes so far.
    pub(crate) fn len(&self) -> usize {
        self.netlist.nodes.len()
    }

    /// A node built so far.
    pub(crate) fn node(&self, id: NodeId) -> &Node {
        self.netlist.node(id)
    }

    /// The tables added so far.
    pub(crate) fn tables(&self) -> &[Table] {
        &self.netlist.tables
    }

    /// Adds any operation except a port; `asked` is its format, if the operation takes one.
    #[track_caller]
    pub fn operation(&mut self, op: Op, operands: &[NodeId], asked: Format) -> NodeId {
        if op == Op::Input {
            return self.refuse(op, operands, Some(asked), "a port has a name: use `input`");
        }
        if operands.len() != op.arity() {
            let problem = format!("it takes {} operands", op.arity());
            return self.refuse(op, operands, Some(asked), problem);
        }
        if let Op::Read { table, column } = op {
            return self.read(table, cast::index_of_u32(column), operands[0]);
        }
        self.push(op, operands, Some(asked))
    }

    /// The first mistake, if any.
    pub(super) fn into_error(self) -> Option<Error> {
        self.error.into_inner()
    }

    /// The owner of this builder's nodes.
    pub(super) fn owner(&self) -> Owner {
        self.owner
    }

    /// Format of a node; arbitrary for a node of another builder.
    #[must_use]
    #[track_caller]
    pub fn format(&self, id: NodeId) -> Format {
        if self.owned("format", id) { self.netlist.node(id).format } else { Format::FLAG }
    }

    /// True after a mistake, which `build` will return.
    #[must_use]
    pub fn has_failed(&self) -> bool {
        self.error.get().is_some()
    }

    /// Keeps the first error.
    pub fn fail(&self, error: Error) {
        // Later errors follow from the first.
        let _ = self.error.set(error);
    }

    /// Unwraps a format; on error, keeps the error and returns a placeholder.
    pub fn checked(&mut self, format: Result<Format>) -> Format {
        format.unwrap_or_else(|error| {
            self.fail(error);
            Format::FLAG
        })
    }

    /// Records a mistake in the caller's code.
    #[track_caller]
    pub(super) fn misuse(&self, what: impl Into<String>, problem: impl Into<String>) {
        self.fail(Error::misuse(what.into(), problem.into(), Location::caller()));
    }

    #[track_caller]
    fn check_name(&self, what: &str, given: &str) {
        if !name::is_legal(given) {
            let given = escape::short(given);
            self.misuse(format!("{what} `{given}`"), format!("a name is {}", name::RULE));
        }
    }

    /// True if a node belongs to this builder.
    fn owns(&self, id: NodeId) -> bool {
        id.owner == self.owner
    }

    /// True if a node belongs to this builder and has a format.
    fn is_in(&self, id: NodeId, format: Format) -> bool {
        self.owns(id) && self.netlist.node(id).format == format
    }

    /// As [`Builder::owns`], but a foreign node is recorded as a mistake.
    #[track_caller]
    fn owned(&self, operation: &str, id: NodeId) -> bool {
        let owned = self.owns(id);
        if !owned {
            self.misuse(
                format!("{operation} in `{}`", self.netlist.name),
                "the node belongs to another builder: use one builder per netlist",
            );
        }
        owned
    }

    /// A node with its format, for messages.
    fn described(&self, id: NodeId) -> String {
        if self.owns(id) {
            format!("{} ({})", self.netlist.label(id), self.netlist.node(id).format)
        } else {
            "a node of another builder".to_owned()
        }
    }

    /// An operation, for messages.
    #[track_caller]
    fn operation_of(&self, op: Op, operands: &[NodeId]) -> Operation {
        let of = |names: String| match &names[..] {
            "" => op.name().to_owned(),
            names => format!("{} of {names}", op.name()),
        };
        let first = operands.first().filter(|id| self.owns(**id));
        let listed: Vec<String> = operands.iter().map(|id| self.described(*id)).collect();
        Operation {
            plain: of(first.map(|id| self.netlist.label(*id)).unwrap_or_default()),
            with_formats: of(listed.join(", ")),
            caller: Location::caller(),
        }
    }

    /// Records a mistake in an operation and returns a placeholder node.
    #[track_caller]
    fn refuse(
        &mut self,
        op: Op,
        operands: &[NodeId],
        asked: Option<Format>,
        problem: impl Into<String>,
    ) -> NodeId {
        let operation = self.operation_of(op, operands);
        self.misuse(operation.with_formats, problem);
        self.placeholder(asked)
    }

    /// A node to continue with after a mistake.
    fn placeholder(&mut self, asked: Option<Format>) -> NodeId {
        self.insert(Op::Const { raw: 0 }, &[], asked.unwrap_or(Format::FLAG))
    }

    #[track_caller]
    fn push(&mut self, op: Op, operands: &[NodeId], asked: Option<Format>) -> NodeId {
        if !operands.iter().all(|id| self.owns(*id)) {
            return self.refuse(op, operands, asked, "use one builder per netlist");
        }
        let formats: Vec<Format> =
            operands.iter().map(|id| self.netlist.node(*id).format).collect();
        match op.result_format(&formats, asked, &self.netlist.tables) {
            Ok(format) => self.insert(op, operands, format),
            Err(why) => {
                let operation = self.operation_of(op, operands);
                let place = self.netlist.nodes.len();
                self.fail(match why {
                    FormatProblem::TooWide(bits) => {
                        Error::node_too_wide(operation, place, bits, Format::MAX_BITS)
                    }
                    FormatProblem::Mismatch(problem) => Error::operands(operation, problem),
                });
                self.placeholder(asked)
            }
        }
    }

    /// The node of a checked operation; equal operations share one node.
    fn insert(&mut self, op: Op, operands: &[NodeId], format: Format) -> NodeId {
        let key = (op, operands.to_vec(), format);
        if op != Op::Input
            && let Some(id) = self.known.get(&key)
        {
            return *id;
        }
        let id = NodeId { owner: self.owner, number: cast::id_of(self.netlist.nodes.len()) };
        self.netlist.nodes.push(Node {
            op,
            operands: operands.to_vec(),
            format,
            name: None,
            scope: self.scope,
            quantity: Quantity::Number,
            rate: Rate::default(),
            meaning: None,
            real: None,
        });
        self.known.insert(key, id);
        id
    }

    /// Builds the nodes of `body` in a named scope.
    #[track_caller]
    pub fn scope<R>(&mut self, name: &str, body: impl FnOnce(&mut Self) -> R) -> R {
        self.in_scope(name, None, body)
    }

    /// As [`Builder::scope`], for nodes that count as one operator.
    #[track_caller]
    pub fn part<R>(&mut self, part: Part, name: &str, body: impl FnOnce(&mut Self) -> R) -> R {
        self.in_scope(name, Some(part), body)
    }

    #[track_caller]
    fn in_scope<R>(
        &mut self,
        name: &str,
        part: Option<Part>,
        body: impl FnOnce(&mut Self) -> R,
    ) -> R {
        let outer = self.open(name, part);
        let result = body(self);
        self.scope = outer;
        result
    }

    /// Opens a named scope for the next nodes; returns the previous scope.
    #[track_caller]
    pub(super) fn open(&mut self, name: &str, part: Option<Part>) -> ScopeId {
        self.check_name("scope", name);
        let outer = self.scope;
        self.scope = self.declare_scope(outer, name, part);
        outer
    }

    /// The scope `name` below `parent`; created if missing.
    pub(super) fn declare_scope(
        &mut self,
        parent: ScopeId,
        name: &str,
        part: Option<Part>,
    ) -> ScopeId {
        let scope = Scope { name: name.to_owned(), parent: Some(parent), part };
        let same = |known: &Scope| known.name == scope.name && known.parent == scope.parent;
        let found = self.netlist.scopes.iter().position(same);
        if found.is_some_and(|index| self.netlist.scopes[index].part != part) {
            let name = escape::short(name);
            self.misuse(
                format!("scope `{name}`"),
                "it is a different part elsewhere: choose another name",
            );
        }
        let index = found.unwrap_or_else(|| {
            self.netlist.scopes.push(scope);
            self.netlist.scopes.len() - 1
        });
        ScopeId(cast::id_of(index))
    }

    /// Names a node within its scope; a node keeps its first name.
    #[track_caller]
    pub fn name(&mut self, id: NodeId, name: &str) -> NodeId {
        self.check_name("node", name);
        if self.owned("name", id) {
            let node = &mut self.netlist.nodes[id.index()];
            if node.name.is_none() {
                node.name = Some(name.to_owned());
            }
        }
        id
    }

    /// Marks a node as an angle in turns.
    #[track_caller]
    pub fn turns(&mut self, id: NodeId) -> NodeId {
        if self.owned("turns", id) {
            self.netlist.nodes[id.index()].quantity = Quantity::Turns;
        }
        id
    }

    /// Sets how often an input port gets a new word.
    #[track_caller]
    pub fn rate(&mut self, id: NodeId, rate: Rate) -> NodeId {
        if self.owned("rate", id) {
            if self.netlist.node(id).op == Op::Input {
                self.netlist.nodes[id.index()].rate = rate;
            } else {
                let problem =
                    "only ports can be given a rate: a node has the fastest rate of its operands";
                self.misuse(self.described(id), problem);
            }
        }
        id
    }

    /// Sets a node's meaning on reals, as an expression of earlier nodes; a node keeps its first
    /// meaning.
    #[track_caller]
    pub fn means<const N: usize>(
        &mut self,
        id: NodeId,
        of: [NodeId; N],
        expr: impl FnOnce([Expr; N]) -> Expr,
    ) -> NodeId {
        self.stands_for(id, &expr(Expr::variables()), &of)
    }

    /// As [`Builder::means`], with an expression.
    #[track_caller]
    pub(crate) fn stands_for(&mut self, id: NodeId, expr: &Expr, of: &[NodeId]) -> NodeId {
        if !self.owned("means", id) {
            return id;
        }
        if expr.arity() > of.len() {
            let problem = format!(
                "its meaning has {} variables, and {} nodes are given",
                expr.arity(),
                of.len()
            );
            self.misuse(self.described(id), problem);
            return id;
        }
        if let Some(problem) = expr.problem_with_calls() {
            self.misuse(self.described(id), format!("its meaning: {problem}"));
            return id;
        }
        let earlier = |of: &NodeId| self.owns(*of) && *of < id;
        match of.iter().find(|of| !earlier(of)) {
            None => {
                let node = &mut self.netlist.nodes[id.index()];
                node.meaning.get_or_insert_with(|| Meaning::in_order(expr, of));
            }
            Some(of) => {
                let problem = format!(
                    "its meaning refers to {}: that must be an earlier node",
                    self.described(*of)
                );
                self.misuse(self.described(id), problem);
            }
        }
        id
    }

    /// Sets what a node measures.
    pub(crate) fn measures(&mut self, id: NodeId, quantity: Quantity) {
        self.netlist.nodes[id.index()].quantity = quantity;
    }

    /// Takes the first mistake, if any, and forgets it.
    pub(super) fn take_error(&mut self) -> Option<Error> {
        self.error.take()
    }

    /// Adds an input port.
    #[track_caller]
    pub fn input(&mut self, name: &str, format: Format, quantity: Quantity) -> NodeId {
        self.check_port("input", name);
        let id = self.insert(Op::Input, &[], format);
        let node = &mut self.netlist.nodes[id.index()];
        node.quantity = quantity;
        node.name = Some(name.to_owned());
        self.netlist.inputs.push(id);
        id
    }

    /// Adds an output port.
    #[track_caller]
    pub fn output(&mut self, name: &str, node: NodeId) {
        self.check_port("output", name);
        if self.owned(&format!("output `{name}`"), node) {
            self.netlist.outputs.push(Output { name: name.to_owned(), node });
        }
    }

    /// Refuses a port name that another port has, since hardware has one namespace for ports.
    #[track_caller]
    fn check_port(&self, what: &str, given: &str) {
        self.check_name(what, given);
        let inputs =
            self.netlist.inputs.iter().map(|id| (self.netlist.node(*id).name.as_deref(), "input"));
        let outputs = self.netlist.outputs.iter().map(|output| (Some(&output.name[..]), "output"));
        if let Some((_, other)) = inputs.chain(outputs).find(|(name, _)| *name == Some(given)) {
            let article = if other == what { "another" } else { "an" };
            self.misuse(
                format!("{what} `{given}` of `{}`", self.netlist.name),
                format!("{article} {other} has this name: rename one of them"),
            );
        }
    }

    /// Adds a table; an identical existing table is reused.
    #[track_caller]
    pub fn table(&mut self, table: Table) -> TableId {
        let known = self.netlist.tables.iter().position(|known| *known == table);
        let index = known.unwrap_or(self.netlist.tables.len());
        let taken = self.netlist.memories().any(|memory| memory.name == table.name);
        if known.is_none() && table.memory.is_some() && taken {
            let name = escape::short(&table.name);
            self.misuse(
                format!("memory `{name}`"),
                "another memory has this name, by which words are bound: rename one of them",
            );
        }
        if known.is_none() {
            match table_problem(&table) {
                None => self.netlist.tables.push(table),
                // Reading it is then a mistake too, but not the first.
                Some(problem) => {
                    self.misuse(format!("table `{}`", escape::short(&table.name)), problem)
                }
            }
        }
        TableId { owner: self.owner, number: cast::id_of(index) }
    }

    /// Adds a memory from the names and formats of its columns. Its words are
    /// [bound](Netlist::bind) for simulation. It is [read](Builder::read) like a table; in hardware
    /// its words arrive `latency` cycles after the address.
    #[track_caller]
    pub fn memory(
        &mut self,
        name: &str,
        addr_bits: u32,
        columns: &[(&str, Format)],
        latency: u32,
    ) -> TableId {
        self.table(Table::memory(name, addr_bits, columns, latency))
    }

    /// The format of a table's result: the recipe's, or the [override](Overrides) for the table's
    /// name. Call this before making a table's words.
    pub fn table_format(&mut self, name: &str, format: Format) -> Format {
        let place = Place::Table(name.to_owned());
        let (format, given) = self.overrides.at(&place, format);
        self.asked.push(Asked { place, format, node: None, given });
        format
    }

    /// The name of a table's scheme: the recipe's, or the [override](Overrides) for the table's
    /// name. Call this before making a table from a scheme.
    pub fn table_scheme(&mut self, table: &str, scheme: &str) -> String {
        let given = self.overrides.scheme(table);
        let choice = SchemeChoice {
            table: table.to_owned(),
            scheme: given.unwrap_or(scheme).to_owned(),
            overridden: given.is_some(),
        };
        let scheme = choice.scheme.clone();
        if !self.schemes.contains(&choice) {
            self.schemes.push(choice);
        }
        scheme
    }

    /// The constant word `raw`.
    #[track_caller]
    pub fn constant(&mut self, raw: i64, format: Format) -> NodeId {
        self.push(Op::Const { raw }, &[], Some(format))
    }

    /// `a + b`.
    #[track_caller]
    pub fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Add, &[a, b], None)
    }

    /// `a - b`.
    #[track_caller]
    pub fn sub(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Sub, &[a, b], None)
    }

    /// `a - b` where `flag` is set, otherwise `a + b`.
    #[track_caller]
    pub fn addsub(&mut self, flag: NodeId, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::AddSub, &[flag, a, b], None)
    }

    /// `a * b`.
    #[track_caller]
    pub fn mul(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Mul, &[a, b], None)
    }

    /// `-a`.
    #[track_caller]
    pub fn neg(&mut self, a: NodeId) -> NodeId {
        self.push(Op::Neg, &[a], None)
    }

    /// `|a|`.
    #[track_caller]
    pub fn abs(&mut self, a: NodeId) -> NodeId {
        self.push(Op::Abs, &[a], None)
    }

    /// Bitwise and.
    #[track_caller]
    pub fn and(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::And, &[a, b], None)
    }

    /// Bitwise or.
    #[track_caller]
    pub fn or(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Or, &[a, b], None)
    }

    /// Bitwise exclusive or.
    #[track_caller]
    pub fn xor(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Xor, &[a, b], None)
    }

    /// Flag `a = b`.
    #[track_caller]
    pub fn equal(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Equal, &[a, b], None)
    }

    /// Flag `a < b`.
    #[track_caller]
    pub fn less(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Less, &[a, b], None)
    }

    /// `a` where `flag` is set, otherwise `b`.
    #[track_caller]
    pub fn mux(&mut self, flag: NodeId, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Mux, &[flag, a, b], None)
    }

    /// `bits` bits of a word, starting at bit `lo`, as an integer.
    #[track_caller]
    pub fn slice(&mut self, a: NodeId, lo: u32, bits: u32) -> NodeId {
        if bits == 0 {
            return self.refuse(Op::Slice { lo }, &[a], None, "a slice needs at least one bit");
        }
        let format = self.checked(Format::integer(bits));
        self.push(Op::Slice { lo }, &[a], Some(format))
    }

    /// The bits of `high` above the bits of `low`.
    #[track_caller]
    pub fn concat(&mut self, high: NodeId, low: NodeId) -> NodeId {
        self.push(Op::Concat, &[high, low], None)
    }

    /// The sign bit of a signed word as a flag.
    #[track_caller]
    pub fn negative(&mut self, a: NodeId) -> NodeId {
        let sign_bit = self.format(a).bits() - 1;
        if !self.format(a).is_signed() {
            return self.refuse(
                Op::Slice { lo: sign_bit },
                &[a],
                None,
                "an unsigned word has no sign",
            );
        }
        let sign = self.slice(a, sign_bit, 1);
        self.means(sign, [a], |[a]| a.less(0.0))
    }

    /// `a * 2^left` by moving the binary point.
    #[track_caller]
    pub fn shift(&mut self, a: NodeId, left: i32) -> NodeId {
        if left == 0 { a } else { self.push(Op::Shift { left }, &[a], None) }
    }

    /// The number of zero bits above the highest one bit.
    #[track_caller]
    pub fn leading_zeros(&mut self, a: NodeId) -> NodeId {
        self.push(Op::LeadingZeros, &[a], None)
    }

    /// `a * 2^min(n, max)`.
    #[track_caller]
    pub fn shift_left(&mut self, a: NodeId, n: NodeId, max: u32) -> NodeId {
        self.push(Op::ShiftLeft { max }, &[a, n], None)
    }

    /// The word of a column at an address.
    #[track_caller]
    pub fn read(&mut self, table: TableId, column: usize, address: NodeId) -> NodeId {
        let op = Op::Read { table, column: cast::id_of(column) };
        let found = self.netlist.tables.get(table.index()).filter(|_| table.owner == self.owner);
        let Some(found) = found else {
            return self.refuse(
                op,
                &[address],
                None,
                "the table belongs to another builder: use one builder per netlist",
            );
        };
        if column >= found.columns.len() {
            let names: Vec<&str> = found.columns.iter().map(|column| &column.name[..]).collect();
            let problem = format!(
                "table `{}` has no column {column}: its columns from 0 are {}",
                found.name,
                names.join(", ")
            );
            return self.refuse(op, &[address], None, problem);
        }
        self.push(op, &[address], None)
    }

    /// `a` of `samples` accepted samples earlier; 0 if there was no such sample since the reset.
    #[track_caller]
    pub fn delay(&mut self, a: NodeId, samples: u32) -> NodeId {
        if samples == 0 { a } else { self.push(Op::Delay { samples }, &[a], None) }
    }

    /// The residue of `a` modulo the span of `format`.
    #[track_caller]
    pub fn modulo(&mut self, a: NodeId, format: Format) -> NodeId {
        if self.is_in(a, format) { a } else { self.push(Op::Modulo, &[a], Some(format)) }
    }

    /// `a` in `format`; the only operation that loses bits. Its format can be
    /// [overridden](Overrides) by the node's name.
    #[track_caller]
    pub fn narrow(
        &mut self,
        a: NodeId,
        format: Format,
        round: Round,
        overflow: Overflow,
    ) -> NodeId {
        let number = self.narrows.entry(self.scope).or_insert(0);
        *number += 1;
        let scope = self.netlist.scope_path(self.scope).join(".");
        let place = Place::Narrow { scope, number: *number };
        let (format, given) = self.overrides.at(&place, format);
        // Only symmetric saturation can change a word that is already in the format.
        let same = self.is_in(a, format) && overflow != Overflow::Symmetric;
        let id =
            if same { a } else { self.push(Op::Narrow { round, overflow }, &[a], Some(format)) };
        if !same || given.is_some() {
            self.asked.push(Asked { place, format, node: Some(id), given });
        }
        id
    }

    /// As [`Builder::build`], but drops meanings that refer to nodes that no output needs.
    pub(crate) fn build_rebuilt(mut self) -> Result<Netlist> {
        let live = live(&self.netlist);
        for node in &mut self.netlist.nodes {
            node.meaning =
                node.meaning.take().filter(|meaning| meaning.of.iter().all(|id| live[id.index()]));
        }
        self.build()
    }

    /// Verifies and freezes the netlist; nodes and tables that no output needs are dropped.
    ///
    /// # Errors
    /// The first mistake; or that there is no output, that a meaning refers to a node that no
    /// output needs, or that a node with an overridden format doesn't exist.
    ///
    /// # Panics
    /// Never: every call of a builder is checked.
    #[track_caller]
    pub fn build(self) -> Result<Netlist> {
        self.checks();
        if let Some(error) = self.error.into_inner() {
            return Err(error);
        }
        let old = self.netlist;
        let live = live(&old);
        let fastest = *old.rates().last().expect("bug: there is one");
        let mut new_ids = vec![NodeId::finished(u32::MAX); old.nodes.len()];
        let mut new_tables: Vec<Option<TableId>> = vec![None; old.tables.len()];
        let mut netlist = Netlist {
            name: old.name,
            nodes: Vec::new(),
            scopes: old.scopes,
            tables: Vec::new(),
            inputs: Vec::new(),
            outputs: Vec::new(),
            reals: Graph::default(),
            choices: Vec::new(),
            schemes: self.schemes,
        };
        // Ports keep their names; other nodes with the same name get a number.
        let mut names: BTreeSet<(ScopeId, String)> = BTreeSet::new();
        for id in &old.inputs {
            let node = &old.nodes[id.index()];
            names.insert((node.scope, node.name.clone().expect("bug: inputs are named")));
        }
        for (index, mut node) in old.nodes.into_iter().enumerate().filter(|(i, _)| live[*i]) {
            for operand in &mut node.operands {
                *operand = new_ids[operand.index()];
            }
            for of in node.meaning.iter_mut().flat_map(|meaning| &mut meaning.of) {
                *of = new_ids[of.index()];
            }
            if let Op::Read { table, .. } = &mut node.op {
                let new = *new_tables[table.index()].get_or_insert_with(|| {
                    netlist.tables.push(old.tables[table.index()].clone());
                    TableId::finished(cast::id_of(netlist.tables.len() - 1))
                });
                *table = new;
            }
            let rates = node.operands.iter().map(|id| netlist.nodes[id.index()].rate);
            if let Op::Delay { .. } = node.op {
                // A delay counts samples.
                node.rate = fastest;
            } else if node.op != Op::Input {
                node.rate = rates.max().unwrap_or(Rate::Scene);
            }
            if node.op != Op::Input
                && let Some(name) = node.name.take()
            {
                let scope = node.scope;
                node.name =
                    Some(name::numbered(&name, |name| names.insert((scope, name.to_owned()))));
            }
            let id = NodeId::finished(cast::id_of(netlist.nodes.len()));
            new_ids[index] = id;
            if node.op == Op::Input {
                netlist.inputs.push(id);
            }
            netlist.nodes.push(node);
        }
        for output in old.outputs {
            netlist.outputs.push(Output { node: new_ids[output.node.index()], ..output });
        }
        let new = |asked: Asked| -> Option<Asked> {
            let Some(node) = asked.node else { return Some(asked) };
            live[node.index()].then(|| Asked { node: Some(new_ids[node.index()]), ..asked })
        };
        netlist.choose(self.asked.into_iter().filter_map(new).collect());
        netlist.read_reals();
        netlist.verify();
        Ok(netlist)
    }

    /// The checks at the end.
    #[track_caller]
    fn checks(&self) {
        if self.has_failed() {
            return;
        }
        let Netlist { name, nodes, outputs, .. } = &self.netlist;
        if outputs.is_empty() {
            self.misuse(format!("netlist `{name}`"), "it has no output");
        }
        if let Some(node) = self.overrides.unasked(&self.asked) {
            self.fail(Error::usage(format!(
                "with these formats, `{name}` has no node `{node}`: leave its format out"
            )));
        }
        if let Some(table) = self.overrides.unasked_scheme(&self.schemes) {
            self.fail(Error::usage(format!(
                "with these formats and schemes, `{name}` has no table `{table}`: leave its scheme out"
            )));
        }
        let live = live(&self.netlist);
        for (index, node) in nodes.iter().enumerate().filter(|(index, _)| live[*index]) {
            let mut of = node.meaning.iter().flat_map(|meaning| &meaning.of);
            if let Some(dead) = of.find(|id| !live[id.index()]) {
                let dead = *dead;
                let id = NodeId { owner: self.owner, number: cast::id_of(index) };
                let problem = format!(
                    "its meaning refers to {}, which no output needs: make that an output too, or omit the meaning",
                    self.described(dead)
                );
                self.misuse(self.described(id), problem);
            }
        }
    }
}

/// Marks the nodes that outputs need, and all ports.
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

/// What is wrong with a table.
fn table_problem(table: &Table) -> Option<String> {
    if !name::is_legal(&table.name) {
        return Some(format!("a name is {}", name::RULE));
    }
    if !(1..=Table::MAX_ADDR_BITS).contains(&table.addr_bits) {
        return Some(format!(
            "{} address bits: legal is 1 to {}",
            table.addr_bits,
            Table::MAX_ADDR_BITS
        ));
    }
    if let Some(Memory { latency }) = table.memory {
        if !(1..=Memory::MAX_LATENCY).contains(&latency) {
            let most = Memory::MAX_LATENCY;
            return Some(format!("a latency of {latency} cycles: legal is 1 to {most}"));
        }
        if table.columns.is_empty() {
            return Some("it has no column".to_owned());
        }
    }
    let mut names = BTreeSet::new();
    let named = table.columns.iter().find_map(|column| {
        let name = escape::short(&column.name);
        if !name::is_legal(&column.name) {
            return Some(format!("column `{name}`: a name is {}", name::RULE));
        }
        (!names.insert(&column.name)).then(|| format!("two columns are called `{name}`"))
    });
    // A memory has no words yet.
    let unbound = table.memory.is_some() && table.is_unbound();
    named.or_else(|| if unbound { None } else { table.problem_with_words() })
}
