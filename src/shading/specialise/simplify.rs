//! Replaces every node by its simplest form.

use super::rebuild::{self, Rebuild};
use super::reduced::{Reduced, Source};
use super::report::Folded;
use crate::base::cast;
use crate::netlist::op::Op;
use crate::netlist::words::Words;
use crate::netlist::{Netlist, NodeId};
use crate::number::format::{Format, Overflow, narrow};

/// The simplified form of a node.
enum Form {
    /// Unchanged.
    Same,
    /// A constant.
    Word(i64),
    /// The value of an operand, in the node's format.
    Wires(NodeId),
    /// The value of a simpler operation, in the node's format.
    Simpler(Op, Vec<NodeId>),
}

impl Form {
    /// The operands that are still needed.
    fn operands<'a>(&'a self, of: &'a [NodeId]) -> &'a [NodeId] {
        match self {
            Self::Same => of,
            Self::Word(_) => &[],
            Self::Wires(operand) => std::slice::from_ref(operand),
            Self::Simpler(_, operands) => operands,
        }
    }
}

/// Counts what [`simplify`] did.
#[derive(Default)]
pub(super) struct Tally {
    pub(super) folded: Vec<Folded>,
    pub(super) folded_nodes: u64,
    pub(super) simplified_nodes: u64,
    pub(super) unlimited_narrows: u64,
}

/// The simplest form of a node whose operands can only have these words.
#[expect(clippy::wildcard_enum_match_arm, reason = "other operations have no simpler form")]
fn form(netlist: &Netlist, id: NodeId, words: &[Words]) -> Form {
    let node = netlist.node(id);
    let of = &node.operands;
    let known = |i: usize| words[of[i].index()].constant();
    let is = |i: usize, raw: i64| known(i) == Some(raw);
    let simpler = |op: Op, operands: &[NodeId]| {
        // An intermediate result must be a word: the negation of -2^62 isn't.
        let formats: Vec<Format> = operands.iter().map(|id| netlist.node(*id).format).collect();
        match op.result_format(&formats, Some(node.format), netlist.tables()) {
            Ok(_) => Form::Simpler(op, operands.to_vec()),
            Err(_) => Form::Same,
        }
    };
    let shifted = |operand: NodeId, left: i32| match left {
        0 => Form::Wires(operand),
        left => simpler(Op::Shift { left }, &[operand]),
    };
    if let Some(raw) = words[id.index()].constant() {
        return Form::Word(raw);
    }
    match node.op {
        Op::Add | Op::Or | Op::Xor | Op::Sub if is(1, 0) => Form::Wires(of[0]),
        Op::Add | Op::Or | Op::Xor if is(0, 0) => Form::Wires(of[1]),
        Op::Sub if is(0, 0) => simpler(Op::Neg, &[of[1]]),
        Op::AddSub if is(2, 0) => Form::Wires(of[1]),
        Op::AddSub if is(0, 0) => simpler(Op::Add, &of[1..]),
        Op::AddSub if is(0, 1) => simpler(Op::Sub, &of[1..]),
        Op::And if is(1, node.format.wrap(-1)) => Form::Wires(of[0]),
        Op::And if is(0, node.format.wrap(-1)) => Form::Wires(of[1]),
        Op::Mux if is(0, 1) || of[1] == of[2] => Form::Wires(of[1]),
        Op::Mux if is(0, 0) => Form::Wires(of[2]),
        Op::Mul => {
            let power = |i: usize| known(i).filter(|raw| raw.count_ones() == 1 && *raw > 0);
            let found = (0..2).find_map(|i| power(i).map(|raw| (i, raw)));
            found.map_or(Form::Same, |(i, raw)| {
                let frac_bits = netlist.node(of[i]).format.frac_bits();
                shifted(of[1 - i], cast::signed_count(raw.trailing_zeros()) - frac_bits)
            })
        }
        Op::Abs if words[of[0].index()].lo() >= 0 => Form::Wires(of[0]),
        Op::Abs if words[of[0].index()].hi() <= 0 => simpler(Op::Neg, of),
        Op::ShiftLeft { max } => known(1).map_or(Form::Same, |count| {
            let places = count.min(i64::from(max));
            shifted(of[0], i32::try_from(places).expect("bug: at most 62"))
        }),
        Op::Narrow { round, overflow: overflow @ (Overflow::Saturate | Overflow::Symmetric) } => {
            let from = netlist.node(of[0]).format.frac_bits();
            let overflows = |raw| narrow(raw, from, node.format, round, overflow).1;
            // Rounding is monotone, so the ends decide.
            if overflows(words[of[0].index()].lo()) || overflows(words[of[0].index()].hi()) {
                Form::Same
            } else {
                simpler(Op::Narrow { round, overflow: Overflow::Wrap }, of)
            }
        }
        _ => Form::Same,
    }
}

/// Replaces every node by its simplest form, and removes nodes that no wanted output needs.
pub(super) fn simplify(
    netlist: &Netlist,
    words: &[Words],
    outputs: &[(String, NodeId)],
    tally: &mut Tally,
) -> Reduced {
    let forms: Vec<Form> = netlist.ids().map(|id| form(netlist, id, words)).collect();
    let general = Reduced {
        netlist: netlist.clone(),
        inputs: (0..netlist.inputs().len()).map(Source::Port).collect(),
    };
    let mut new = Rebuild::new(&general, netlist.name());
    let operands = |id: NodeId| forms[id.index()].operands(&netlist.node(id).operands);
    let live = rebuild::live(netlist, outputs.iter().map(|(_, id)| *id), operands);
    let operands = |id: NodeId| netlist.node(id).operands.as_slice();
    let needed = rebuild::live(netlist, outputs.iter().map(|(_, id)| *id), operands);
    for id in netlist.ids() {
        let node = netlist.node(id);
        let form = &forms[id.index()];
        if let Form::Word(raw) = form
            && needed[id.index()]
            && node.op.arity() > 0
        {
            tally.folded_nodes += 1;
            if node.name.is_some() {
                tally.folded.push(Folded {
                    node: netlist.label(id),
                    format: node.format.to_string(),
                    raw: *raw,
                    value: node.format.value(*raw),
                });
            }
        }
        if !live[id.index()] {
            continue;
        }
        match form {
            Form::Same => new.copy(id),
            Form::Word(raw) => new.constant(id, *raw),
            Form::Wires(operand) => {
                tally.simplified_nodes += 1;
                new.wires(id, *operand);
            }
            Form::Simpler(op, operands) => {
                let narrows = matches!(op, Op::Narrow { .. });
                tally.unlimited_narrows += u64::from(narrows);
                tally.simplified_nodes += u64::from(!narrows);
                new.simpler(id, *op, operands);
            }
        }
    }
    new.finish(outputs)
}
