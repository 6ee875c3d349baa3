//! Only what a scene needs: a netlist cut down to the words that occur at its inputs.
//!
//! A caller knows which words each input can hold ([`Known::words`]) and how often it changes
//! ([`Known::rate`]). [`specialise`] finds from that which words every node can hold ([`ranges`]), and
//! makes netlists that give the same output words for all such inputs:
//!
//! 1. nodes of one word become constants; choices with a known flag, additions of zero, products with
//!    a power of two and shifts by a known count become wires; limits that are never met go;
//! 2. what depends only on inputs that are constant over a face moves to a netlist of its own, whose
//!    outputs are further inputs of the rest;
//! 3. tables are cut to rows and columns that are read;
//! 4. nodes, tables and inputs that no wanted output needs go.
//!
//! What is left keeps its operation, format, name, scope and meaning. A meaning whose arguments are
//! gone goes too: on reals, a constant is its word, with the error that it has.

mod rebuild;
mod tables;

pub use crate::netlist::ranges::ranges;
pub use crate::netlist::words::Words;
pub use tables::{CutTable, TableCut};

use crate::base::cast;
use crate::netlist::op::Op;
use crate::netlist::{Counts, Netlist, NodeId};
use crate::number::format::{Format, Overflow, narrow};
use rebuild::Rebuild;
use std::collections::BTreeSet;

/// How often an input changes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Rate {
    /// It is constant over the whole scene.
    Scene,
    /// It is constant over each flat face.
    Face,
    /// It changes with every sample.
    Pixel,
}

/// What is known of an input.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Known {
    /// The words that occur.
    pub words: Words,
    /// How often it changes.
    pub rate: Rate,
}

impl Known {
    /// Nothing: every word of the format, with every sample.
    #[must_use]
    pub fn nothing(format: Format) -> Self {
        Self { words: Words::all(format), rate: Rate::Pixel }
    }
}

/// Where an input of a specialised netlist gets its word.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Source {
    /// Input port of the general netlist.
    Port(usize),
    /// Output of the netlist that is evaluated once per face.
    Face(usize),
}

/// A specialised netlist.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// The netlist.
    pub netlist: Netlist,
    /// Where each of its inputs gets its word.
    pub inputs: Vec<Source>,
}

impl Reduced {
    /// The words of its inputs, from those of the general netlist and of the face's outputs.
    ///
    /// # Panics
    /// If a word is missing.
    #[must_use]
    pub fn select(&self, ports: &[i64], face: &[i64]) -> Vec<i64> {
        let word = |source: &Source| match source {
            Source::Port(port) => ports[*port],
            Source::Face(output) => face[*output],
        };
        self.inputs.iter().map(word).collect()
    }
}

/// What [`specialise`] makes.
#[derive(Clone, Debug)]
pub struct Specialised {
    /// The whole datapath, reduced.
    pub whole: Reduced,
    /// What is evaluated once per face; `None` if nothing is gained by it.
    pub face: Option<Reduced>,
    /// What is evaluated for every sample; [`Specialised::whole`] if there is no `face`.
    pub pixel: Reduced,
    /// What was saved.
    pub report: Report,
}

/// Counts and tables of a specialised netlist.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct PartReport {
    /// Its input ports.
    pub inputs: Vec<String>,
    /// Its output ports.
    pub outputs: Vec<String>,
    /// Its operators and tables.
    pub counts: Counts,
    /// What became of each table that it reads.
    pub tables: Vec<TableCut>,
}

/// A node of the general netlist that has one word.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Folded {
    /// Its name with its scopes.
    pub node: String,
    /// Its format.
    pub format: String,
    /// Its word.
    pub raw: i64,
    /// The value of that word.
    pub value: f64,
}

/// A word that is computed once per face.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Hoisted {
    /// Its node's name with its scopes.
    pub node: String,
    /// Output of the face's netlist and input of the rest.
    pub port: String,
    /// Its format.
    pub format: String,
}

/// What was folded, cut and moved, and what that saves.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Report {
    /// The general netlist.
    pub before: Counts,
    /// The whole datapath, reduced.
    pub whole: PartReport,
    /// What is evaluated once per face.
    pub face: Option<PartReport>,
    /// What is evaluated for every sample.
    pub pixel: PartReport,
    /// Input ports that are gone.
    pub removed_inputs: Vec<String>,
    /// Output ports that are gone.
    pub removed_outputs: Vec<String>,
    /// Nodes that had operands and are constants, those with names.
    pub folded: Vec<Folded>,
    /// How many of them there are, with and without names.
    pub folded_nodes: u64,
    /// Nodes that became wires or a simpler operation.
    pub simplified_nodes: u64,
    /// `narrow`s that lost limits that they never meet.
    pub unlimited_narrows: u64,
    /// Words that are computed once per face.
    pub hoisted: Vec<Hoisted>,
}

/// Cuts a netlist down to the outputs that are wanted, for the words that occur at its inputs.
///
/// # Panics
/// If there isn't one `Known` per input, with words of its format, or if there is no output
/// `outputs` or none of one of their names.
#[must_use]
pub fn specialise(netlist: &Netlist, inputs: &[Known], outputs: &[&str]) -> Specialised {
    let wanted = netlist.outputs().iter().filter(|output| outputs.contains(&output.name.as_str()));
    let wanted: Vec<(String, NodeId)> =
        wanted.map(|output| (output.name.clone(), output.node)).collect();
    let names: BTreeSet<&str> = outputs.iter().copied().collect();
    assert!(wanted.len() == names.len(), "bug: `{}` lacks one of {names:?}", netlist.name());
    let given: Vec<Words> = inputs.iter().map(|known| known.words.clone()).collect();
    let words = ranges(netlist, &given);

    let mut tally = Tally::default();
    let simple = simplify(netlist, &words, &wanted, &mut tally);
    let rates: Vec<Rate> =
        simple.inputs.iter().map(|source| inputs[port_of(*source)].rate).collect();
    let mut words_of_face = Vec::new();
    let (parts, hoisted) = match split(&simple, &rates) {
        None => (None, Vec::new()),
        Some(cut) => {
            let given = known_words(&simple, &given, &[]);
            let words = ranges(&simple.netlist, &given);
            words_of_face = cut.frontier.iter().map(|id| words[id.index()].clone()).collect();
            (Some((cut.face, cut.pixel)), cut.hoisted)
        }
    };
    let finish = |part: &Reduced| {
        let words = known_words(part, &given, &words_of_face);
        let (reduced, cuts) = tables::cut(part, &ranges(&part.netlist, &words));
        let report = PartReport {
            inputs: (0..reduced.inputs.len())
                .map(|i| reduced.netlist.input_name(i).to_owned())
                .collect(),
            outputs: reduced.netlist.outputs().iter().map(|output| output.name.clone()).collect(),
            counts: reduced.netlist.counts(),
            tables: cuts,
        };
        (reduced, report)
    };
    let (whole, whole_report) = finish(&simple);
    let (face, pixel) = match parts {
        None => (None, (whole.clone(), whole_report.clone())),
        Some((face, pixel)) => (Some(finish(&face)), finish(&pixel)),
    };
    let (face, face_report) = face.unzip();
    let removed_inputs = (0..netlist.inputs().len())
        .filter(|port| !whole.inputs.contains(&Source::Port(*port)))
        .map(|port| netlist.input_name(port).to_owned())
        .collect();
    let removed_outputs = netlist
        .outputs()
        .iter()
        .filter(|output| !outputs.contains(&output.name.as_str()))
        .map(|output| output.name.clone())
        .collect();
    Specialised {
        report: Report {
            before: netlist.counts(),
            whole: whole_report,
            face: face_report,
            pixel: pixel.1,
            removed_inputs,
            removed_outputs,
            folded: tally.folded,
            folded_nodes: tally.folded_nodes,
            simplified_nodes: tally.simplified_nodes,
            unlimited_narrows: tally.unlimited_narrows,
            hoisted,
        },
        whole,
        face,
        pixel: pixel.0,
    }
}

fn port_of(source: Source) -> usize {
    match source {
        Source::Port(port) => port,
        Source::Face(_) => panic!("bug: the whole datapath has no face"),
    }
}

/// The words that occur at each input of a part.
fn known_words(part: &Reduced, ports: &[Words], face: &[Words]) -> Vec<Words> {
    let words = |source: &Source| match source {
        Source::Port(port) => ports[*port].clone(),
        Source::Face(output) => face[*output].clone(),
    };
    part.inputs.iter().map(words).collect()
}

/// What a node becomes.
enum Form {
    /// It stays.
    Same,
    /// A constant.
    Word(i64),
    /// The value of an operand, in the node's format.
    Wires(NodeId),
    /// The value of a simpler operation, in the node's format.
    Simpler(Op, Vec<NodeId>),
}

impl Form {
    /// The nodes that are still needed.
    fn operands<'a>(&'a self, of: &'a [NodeId]) -> &'a [NodeId] {
        match self {
            Self::Same => of,
            Self::Word(_) => &[],
            Self::Wires(operand) => std::slice::from_ref(operand),
            Self::Simpler(_, operands) => operands,
        }
    }
}

/// What [`simplify`] did.
#[derive(Default)]
struct Tally {
    folded: Vec<Folded>,
    folded_nodes: u64,
    simplified_nodes: u64,
    unlimited_narrows: u64,
}

/// The simplest form of a node whose operands hold only these words.
fn form(netlist: &Netlist, id: NodeId, words: &[Words]) -> Form {
    let node = netlist.node(id);
    let of = &node.operands;
    let known = |i: usize| words[of[i].index()].constant();
    let is = |i: usize, raw: i64| known(i) == Some(raw);
    let simpler = |op: Op, operands: &[NodeId]| {
        // An intermediate result must be a word: that of -2^62 negated is none.
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
        Op::Input
        | Op::Const { .. }
        | Op::Add
        | Op::Sub
        | Op::AddSub
        | Op::Neg
        | Op::Abs
        | Op::And
        | Op::Or
        | Op::Xor
        | Op::Equal
        | Op::Less
        | Op::Mux
        | Op::Slice { .. }
        | Op::Concat
        | Op::Shift { .. }
        | Op::LeadingZeros
        | Op::Read { .. }
        | Op::Modulo
        | Op::Narrow { .. } => Form::Same,
    }
}

/// Every node in its simplest form, without those that no wanted output needs.
fn simplify(
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

/// A datapath in two.
struct Halves {
    face: Reduced,
    pixel: Reduced,
    /// The nodes that cross from one to the other, in order of the face's outputs.
    frontier: Vec<NodeId>,
    hoisted: Vec<Hoisted>,
}

/// Parts what depends on inputs of [`Rate::Pixel`] from what doesn't, if anything but ports and
/// constants doesn't.
fn split(whole: &Reduced, rates: &[Rate]) -> Option<Halves> {
    let netlist = &whole.netlist;
    let outputs: Vec<(String, NodeId)> =
        netlist.outputs().iter().map(|output| (output.name.clone(), output.node)).collect();
    let mut ports = rates.iter();
    let mut per_pixel = Vec::with_capacity(netlist.nodes().len());
    for node in netlist.nodes() {
        let own = node.op == Op::Input && ports.next() == Some(&Rate::Pixel);
        per_pixel.push(own || node.operands.iter().any(|id| per_pixel[id.index()]));
    }
    let mut crosses = vec![false; netlist.nodes().len()];
    let pixel_users = netlist.nodes().iter().zip(&per_pixel).filter(|(_, per_pixel)| **per_pixel);
    let used = pixel_users.flat_map(|(node, _)| &node.operands);
    for id in used.chain(outputs.iter().map(|(_, id)| id)) {
        let stays = matches!(netlist.node(*id).op, Op::Input | Op::Const { .. });
        crosses[id.index()] = !stays && !per_pixel[id.index()];
    }
    let frontier: Vec<NodeId> = netlist.ids().filter(|id| crosses[id.index()]).collect();
    if frontier.is_empty() {
        return None;
    }

    let mut taken: BTreeSet<String> = outputs.iter().map(|(name, _)| name.clone()).collect();
    taken.extend((0..netlist.inputs().len()).map(|port| netlist.input_name(port).to_owned()));
    let crossing: Vec<(String, NodeId)> =
        frontier.iter().map(|id| (rebuild::port_name(netlist, *id, &mut taken), *id)).collect();

    let mut face = Rebuild::new(whole, &format!("{}_face", netlist.name()));
    let mut pixel = Rebuild::new(whole, &format!("{}_pixel", netlist.name()));
    let operands = |id: NodeId| netlist.node(id).operands.as_slice();
    let face_live = rebuild::live(netlist, frontier.iter().copied(), operands);
    let operands = |id: NodeId| if crosses[id.index()] { &[] } else { operands(id) };
    let pixel_live = rebuild::live(netlist, outputs.iter().map(|(_, id)| *id), operands);
    for id in netlist.ids() {
        if face_live[id.index()] {
            face.copy(id);
        }
        if pixel_live[id.index()] {
            match crossing.iter().position(|(_, crossing)| *crossing == id) {
                Some(output) => pixel.port(id, &crossing[output].0, Source::Face(output)),
                None => pixel.copy(id),
            }
        }
    }
    let hoisted = crossing.iter().map(|(port, id)| Hoisted {
        node: netlist.label(*id),
        port: port.clone(),
        format: netlist.node(*id).format.to_string(),
    });
    Some(Halves {
        hoisted: hoisted.collect(),
        face: face.finish(&crossing),
        pixel: pixel.finish(&outputs),
        frontier,
    })
}
