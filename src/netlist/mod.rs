//! The netlist: a flat arena of nodes whose operands are earlier nodes.
//!
//! Creation order is evaluation order, so a combinational loop can't be written. [`Builder`] grows
//! the netlist and checks every step. [`Builder::build`] drops what no output needs and returns an
//! immutable [`Netlist`]. Building the same operation on the same operands twice gives the same
//! node, so a table read at one address is one port, however often its word is used.
//!
//! # Names
//! One rule covers the names of netlists, ports, nodes, scopes, tables and columns: a letter a to z
//! first, then a to z, 0 to 9 and single _ between them, at most 64 characters. Such names are
//! legal in Verilog, VHDL, C++ and waves. A name that is a keyword in one of these languages is
//! renamed when hardware is written; only a module can't have such a name.
//!
//! # Memories, rates and delays
//! A [memory](Builder::memory) is read like a table; its words are [bound](Netlist::bind) for
//! simulation. A port has a [`Rate`]: nodes that depend only on per-face ports are computed once
//! per face. A [delay](Builder::delay) gives the word of an earlier sample, which a [`State`] keeps
//! for [`Netlist::eval_next`].
//!
//! # Errors
//! No call of a [`Builder`] panics. It keeps the first mistake, with the source location that made
//! it ([`Error::caller`](crate::base::error::Error::caller)), and [`Builder::build`] returns it.
//! [`Wires`] wraps a builder and gives its nodes operators.
//!
//! The reference interpreter ([`Netlist::eval`] on words, [`Netlist::eval_reals`] on reals) is a
//! loop over [`Op`]. Every other engine must match it bit for bit.

mod builder;
mod choices;
mod counts;
pub mod file;
mod id;
mod memory;
pub mod op;
pub(crate) mod ranges;
mod rate;
mod state;
mod table;
mod text;
mod wire;
pub(crate) mod words;

pub use builder::Builder;
pub use choices::{Choice, Overrides, SchemeChoice, with_formats};
pub(crate) use counts::is_zero;
pub use counts::{Counts, Operators, RAM_PORTS};
pub use id::{NodeId, ScopeId, TableId};
pub use rate::Rate;
pub use state::State;
pub use table::{Column, Memory, Table};
pub use wire::{Wire, Wires};

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::netlist::op::Op;
use crate::number::format::Format;
use crate::number::real::{Expr, Graph, Term, TermId, Twin};

/// What a signal measures, which decides how waves and reports show it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Quantity {
    /// A plain number.
    #[default]
    Number,
    /// An angle in turns, equal modulo one.
    Turns,
    /// A number in 20-bit floating point ([`crate::number::format::float20`]).
    Float20,
}

/// One node: an operation on earlier nodes.
#[derive(Clone, PartialEq, Debug)]
pub struct Node {
    /// The operation.
    pub op: Op,
    /// Its operands, [`Op::arity`] of them.
    pub operands: Vec<NodeId>,
    /// Format of its word.
    pub format: Format,
    /// Its name, unique in its scope.
    pub name: Option<String>,
    /// Scope that it was built in.
    pub scope: ScopeId,
    /// What it measures.
    pub quantity: Quantity,
    /// How often it gets a new word.
    pub rate: Rate,
    /// Its meaning on reals, if that isn't its operation.
    pub meaning: Option<Meaning>,
    /// Its value on reals in [`Netlist::reals`]; `None` for bits, which have none.
    pub real: Option<TermId>,
}

/// What a node stands for as a real number, if not its operation on reals. For example, a table
/// read stands for the function that the table approximates, applied to the exact argument.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Meaning {
    /// An expression of other nodes.
    pub expr: Expr,
    /// These nodes: the expression's variables, in order.
    pub of: Vec<NodeId>,
}

impl Meaning {
    /// Renumbers the variables by first occurrence, and merges those of the same node.
    fn in_order(expr: &Expr, of: &[NodeId]) -> Self {
        let mut nodes: Vec<NodeId> = Vec::new();
        let expr = expr.renumbered(|number| {
            let node = of[cast::index_of_u32(number)];
            let known = nodes.iter().position(|known| *known == node);
            cast::id_of(known.unwrap_or_else(|| {
                nodes.push(node);
                nodes.len() - 1
            }))
        });
        Self { expr, of: nodes }
    }
}

/// A part that counts as one operator, whatever its nodes are.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Part {
    /// A table with the logic around it. Folding and interpolation are counted separately.
    Scheme,
    /// A divider.
    Divider,
    /// A square root.
    SquareRoot,
    /// A reciprocal square root.
    ReciprocalRoot,
    /// A dot product of three elements. Its three multipliers and two adders count as the
    /// datapath's own.
    Dot,
}

/// A named group of nodes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scope {
    /// Name.
    pub name: String,
    /// Enclosing scope; `None` for the unit itself.
    pub parent: Option<ScopeId>,
    /// Its part, if its nodes count as one operator.
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
    reals: Graph,
    choices: Vec<Choice>,
    schemes: Vec<SchemeChoice>,
}

/// Two netlists are equal if they are the same datapath. The formats that a recipe
/// [chose](Netlist::choices) and the words [bound](Netlist::bind) to memories don't matter.
impl PartialEq for Netlist {
    fn eq(&self, other: &Self) -> bool {
        if [self, other].iter().any(|netlist| netlist.memories().any(|memory| !memory.is_unbound()))
        {
            return self.unbound() == other.unbound();
        }
        let of = |netlist: &Self| {
            let Self { name, scopes, tables, inputs, outputs, .. } = netlist;
            (name.clone(), scopes.clone(), tables.clone(), inputs.clone(), outputs.clone())
        };
        of(self) == of(other) && self.nodes == other.nodes
    }
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
        (0..cast::id_of(self.nodes.len())).map(NodeId::finished)
    }

    /// Id of the node at a position in [`Netlist::nodes`].
    #[must_use]
    pub(crate) fn id_at(&self, index: usize) -> NodeId {
        NodeId::finished(cast::id_of(index))
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

    /// The nodes' values on reals. The variables are the input ports, in order, and come first.
    #[must_use]
    pub fn reals(&self) -> &Graph {
        &self.reals
    }

    /// The distinct rates of the input ports, slowest first; at least one.
    #[must_use]
    pub fn rates(&self) -> Vec<Rate> {
        let mut rates: Vec<Rate> = self.inputs.iter().map(|id| self.node(*id).rate).collect();
        rates.sort_unstable();
        rates.dedup();
        if rates.is_empty() {
            rates.push(Rate::default());
        }
        rates
    }

    /// The first node that holds a word of an earlier sample. With such a node, samples aren't
    /// independent.
    #[must_use]
    pub fn first_delay(&self) -> Option<NodeId> {
        self.ids().find(|id| matches!(self.node(*id).op, Op::Delay { .. }))
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

    /// Names of the enclosing scopes, outermost first, without the unit itself.
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
            None => format!("{path}%{}", id.number),
        }
    }

    /// Evaluates every node on words. This is the reference for all engines. The sample is the
    /// first after a reset; [`Netlist::eval_next`] evaluates later ones.
    ///
    /// Returns the word of each node, and for each node whether it is a `narrow` that overflowed.
    ///
    /// # Errors
    /// If `inputs` isn't one word of the right format per input, or a memory has no words.
    pub fn eval(&self, inputs: &[i64]) -> Result<(Vec<i64>, Vec<bool>)> {
        self.eval_next(&mut State::new(self), inputs)
    }

    /// As [`Netlist::eval`], for the sample after those that `state` has seen.
    ///
    /// # Errors
    /// As [`Netlist::eval`].
    ///
    /// # Panics
    /// If `state` belongs to another netlist.
    pub fn eval_next(&self, state: &mut State, inputs: &[i64]) -> Result<(Vec<i64>, Vec<bool>)> {
        self.check_words(inputs)?;
        self.check_bound()?;
        let mut words: Vec<i64> = Vec::with_capacity(self.nodes.len());
        let mut overflowed = Vec::with_capacity(self.nodes.len());
        let mut ports = inputs.iter();
        for (index, node) in self.nodes.iter().enumerate() {
            let (word, flag) = if node.op == Op::Input {
                (*ports.next().expect("bug: counted above"), false)
            } else if let Op::Delay { .. } = node.op {
                (state.delayed(index, words[node.operands[0].index()]), false)
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
        Ok((words, overflowed))
    }

    /// Refuses words unless there is one for each input port, in its format.
    pub(crate) fn check_words(&self, words: &[i64]) -> Result<()> {
        if words.len() != self.inputs.len() {
            let ports: Vec<&str> = (0..self.inputs.len()).map(|i| self.input_name(i)).collect();
            let (given, ports) = (words.len(), ports.join(", "));
            let problem =
                format!("{given} words for `{}`: it takes one for each of {ports}", self.name);
            return Err(Error::usage(problem));
        }
        for (port, (id, word)) in self.inputs.iter().zip(words).enumerate() {
            let format = self.node(*id).format;
            if !format.contains(*word) {
                let name = self.input_name(port).to_owned();
                return Err(Error::outside_port(name, *word, None, format.spelled()));
            }
        }
        Ok(())
    }

    /// Evaluates every node on reals: `narrow` returns its operand, and a table read the function
    /// that it approximates.
    ///
    /// A node without a value on reals gives NaN.
    ///
    /// # Panics
    /// If `inputs` doesn't hold one value per input.
    #[must_use]
    pub fn eval_reals(&self, inputs: &[f64]) -> Vec<f64> {
        assert_eq!(inputs.len(), self.inputs.len(), "bug: one value per input");
        let values = self.reals.values(&Twin, inputs);
        self.nodes
            .iter()
            .map(|node| node.real.map_or(f64::NAN, |real| values[real.index()]))
            .collect()
    }

    /// The outermost part other than [`Part::Dot`] that a scope is or lies in.
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
}

impl Netlist {
    /// Derives what each node stands for on reals.
    fn read_reals(&mut self) {
        let mut reals = Graph::default();
        let mut ports = (0..self.inputs.len())
            .map(|port| reals.add(Term::Variable(cast::id_of(port))))
            .collect::<Vec<TermId>>()
            .into_iter();
        let mut found: Vec<Option<TermId>> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            let of = |ids: &[NodeId]| ids.iter().map(|id| found[id.index()]).collect();
            let real = if node.op == Op::Input {
                ports.next()
            } else if let Some(Meaning { expr, of: nodes }) = &node.meaning {
                let of: Option<Vec<TermId>> = of(nodes);
                of.map(|of| reals.insert(expr, &of))
            } else {
                let of: Option<Vec<TermId>> = of(&node.operands);
                of.and_then(|of| self.reading(node, &mut reals, &of))
            };
            found.push(real);
        }
        for (node, real) in self.nodes.iter_mut().zip(found) {
            node.real = real;
        }
        self.reals = reals;
    }

    /// The value of an operation on reals.
    fn reading(&self, node: &Node, reals: &mut Graph, of: &[TermId]) -> Option<TermId> {
        if let Op::Read { table, column } = node.op {
            let table = &self.tables[table.index()];
            let column = &table.columns[cast::index_of_u32(column)];
            let bound = table.memory.is_some() && !table.is_unbound();
            return bound.then(|| reals.add(Term::Row(column.values(&table.name), of[0])));
        }
        node.op.reading(reals, of, node.format)
    }

    /// Checks the invariants of every netlist.
    fn verify(&self) {
        for (id, node) in self.ids().zip(&self.nodes) {
            assert!(
                node.operands.iter().all(|operand| *operand < id),
                "bug: operands of %{} come later",
                id.number
            );
            let formats: Vec<Format> =
                node.operands.iter().map(|id| self.node(*id).format).collect();
            let format = node.op.result_format(&formats, Some(node.format), &self.tables);
            assert_eq!(format.as_ref(), Ok(&node.format), "bug: format of {}", self.label(id));
        }
    }
}
