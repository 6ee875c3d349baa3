//! Evaluation of many samples on reals: the algorithm's value at every node.
//!
//! The twin of [`super::batch`] on `f64` columns: `narrow` keeps its operand and a table is the
//! function that it stands for.

use super::batch::BLOCK;
use super::columns::Columns;
use crate::base::cast;
use crate::base::simd::{Body, vectorised};
use crate::netlist::op::{Meaning, Op, modulo};
use crate::netlist::{Netlist, NodeId};
use crate::number::format::Format;
use crate::number::function::Function;
use crate::number::trig::Real;
use std::collections::{HashMap, HashSet};

/// How a node gets its value on reals.
#[derive(Clone, Copy, Debug)]
enum Kernel {
    /// `narrow` and other operations that keep their operand.
    Same,
    Add,
    Sub,
    Mul,
    /// Less as many spans as keep it from `low` to below `low + span`.
    Modulo {
        low: f64,
        span: f64,
    },
    /// A product with a constant.
    Times(f64),
    /// Any other operation.
    Op(Op, Format),
    Sin,
    Cos,
    /// Both of one angle; the cosine goes to this column.
    SinCos(usize),
    /// Any other meaning.
    Meaning(Meaning),
}

/// A netlist compiled for blocks of reals; the twin of [`Netlist::eval_reals`], bit for bit.
#[derive(Clone, Debug)]
pub struct Program {
    steps: Vec<(Kernel, [usize; 3], usize)>,
    constants: Vec<(usize, f64)>,
    slots: usize,
    inputs: Vec<usize>,
    outputs: Vec<usize>,
    /// The first steps give the same in each block of a run, so many of them.
    repeated: usize,
    /// Which ports hold the same in each block of a run.
    repeats: Vec<bool>,
}

impl Program {
    /// Compiles what the nodes of `outputs` need, all of which must have a value on reals.
    ///
    /// # Panics
    /// If an output has none.
    #[must_use]
    pub fn compile(netlist: &Netlist, outputs: &[NodeId]) -> Self {
        Self::compile_repeated(netlist, outputs, &vec![false; netlist.inputs().len()])
    }

    /// As [`Program::compile`], where the values at some ports are the same in each block of a run:
    /// what depends on such ports only is computed once a run.
    ///
    /// # Panics
    /// As [`Program::compile`], or if there is not one `repeats` per port.
    #[must_use]
    pub fn compile_repeated(netlist: &Netlist, outputs: &[NodeId], repeats: &[bool]) -> Self {
        assert_eq!(repeats.len(), netlist.inputs().len(), "bug: one per port");
        let nodes = netlist.nodes();
        let operands = |index: usize| -> Vec<usize> {
            match nodes[index].meaning {
                Some(meaning) => {
                    meaning.arguments().into_iter().flatten().map(NodeId::index).collect()
                }
                None => nodes[index].operands.iter().map(|id| id.index()).collect(),
            }
        };
        let mut needed = vec![false; nodes.len()];
        for id in outputs {
            assert!(netlist.node(*id).has_real, "bug: {} has no real value", netlist.label(*id));
            needed[id.index()] = true;
        }
        for index in (0..nodes.len()).rev().filter(|i| nodes[*i].op != Op::Input) {
            if needed[index] {
                operands(index).into_iter().for_each(|operand| needed[operand] = true);
            }
        }
        let operands: Vec<Option<Vec<usize>>> = (0..nodes.len())
            .map(|index| {
                let port = nodes[index].op == Op::Input;
                if port { Some(Vec::new()) } else { needed[index].then(|| operands(index)) }
            })
            .collect();
        let mut same = vec![true; nodes.len()];
        for (id, repeats) in netlist.inputs().iter().zip(repeats) {
            same[id.index()] = *repeats;
        }
        for (index, operands) in operands.iter().enumerate() {
            for operand in operands.iter().flatten() {
                same[index] = same[index] && same[*operand];
            }
        }
        // Ports and what repeats first; order among them stays.
        let early = |index: &usize| same[*index] || nodes[*index].op == Op::Input;
        let (mut order, rest): (Vec<usize>, Vec<usize>) =
            (0..nodes.len()).filter(|index| operands[*index].is_some()).partition(early);
        let first = order.len();
        order.extend(rest);
        let order = beside(netlist, &order);
        let columns = Columns::new(netlist, &operands, &order, first, outputs);
        let mut program = Self {
            steps: Vec::new(),
            constants: Vec::new(),
            slots: columns.count,
            inputs: Vec::new(),
            outputs: outputs.iter().map(|id| columns.of(id.index())).collect(),
            repeated: 0,
            repeats: repeats.to_vec(),
        };
        for (at, index) in order.iter().copied().enumerate() {
            let (node, operands) = (&nodes[index], operands[index].as_deref().unwrap_or_default());
            let to = columns.of(index);
            if node.op == Op::Input {
                program.inputs.push(to);
            } else if let (Op::Const { raw }, None) = (node.op, node.meaning) {
                program.constants.push((to, node.format.value(raw)));
            } else {
                let kernel = kernel(node.op, node.meaning, node.format);
                let of = columns.operands(operands);
                if let (Some((before @ Kernel::Sin, angle, _)), Kernel::Cos) =
                    (program.steps.last_mut(), kernel)
                    && *angle == of
                {
                    *before = Kernel::SinCos(to);
                    continue;
                }
                program.steps.push((kernel, of, to));
                if at < first {
                    program.repeated += 1;
                }
            }
        }
        program
    }

    /// Makes columns for one thread.
    #[must_use]
    pub fn runner(&self) -> Runner {
        let mut columns = vec![vec![0.0; BLOCK]; self.slots];
        for (slot, value) in &self.constants {
            columns[*slot].fill(*value);
        }
        Runner { columns }
    }
}

/// Columns of reals for one thread.
#[derive(Debug)]
pub struct Runner {
    columns: Vec<Vec<f64>>,
}

impl Runner {
    /// Evaluates as many samples as the input columns hold; `outputs` are overwritten.
    ///
    /// # Panics
    /// If the columns don't match the program's ports.
    pub fn run(&mut self, program: &Program, inputs: &[&[f64]], outputs: &mut [Vec<f64>]) {
        assert_eq!(inputs.len(), program.inputs.len(), "bug: one column per input");
        assert_eq!(outputs.len(), program.outputs.len(), "bug: one column per output");
        let count = inputs.first().map_or(0, |column| column.len());
        assert!(inputs.iter().all(|column| column.len() == count), "bug: columns differ in length");
        for column in outputs.iter_mut() {
            column.resize(count, 0.0);
        }
        vectorised(Run { program, columns: &mut self.columns, inputs, outputs });
    }
}

/// A run over all blocks, to be compiled for the processor.
struct Run<'a, 'b> {
    program: &'a Program,
    columns: &'a mut [Vec<f64>],
    inputs: &'a [&'b [f64]],
    outputs: &'a mut [Vec<f64>],
}

impl Body for Run<'_, '_> {
    #[inline(always)]
    fn run(self) {
        let Self { program, columns, inputs, outputs } = self;
        let count = inputs.first().map_or(0, |column| column.len());
        let mut other = [0.0; BLOCK];
        let mut start = 0;
        while start < count {
            let len = BLOCK.min(count - start);
            let ports = program.inputs.iter().zip(inputs).zip(&program.repeats);
            for ((slot, input), _) in ports.filter(|(_, repeats)| start == 0 || !**repeats) {
                columns[*slot][..len].copy_from_slice(&input[start..start + len]);
            }
            let done = if start > 0 { program.repeated } else { 0 };
            for (kernel, of, to_slot) in &program.steps[done..] {
                let mut to = std::mem::take(&mut columns[*to_slot]);
                if let Kernel::SinCos(second) = *kernel {
                    let mut cos = std::mem::take(&mut columns[second]);
                    f64::sin_cos_turns(&columns[of[0]][..len], &mut to[..len], &mut cos[..len]);
                    columns[second] = cos;
                } else {
                    let of = of.map(|slot| columns[slot].get(..len).unwrap_or_default());
                    step(*kernel, of, &mut to[..len], &mut other[..len]);
                }
                columns[*to_slot] = to;
            }
            for (slot, output) in program.outputs.iter().zip(outputs.iter_mut()) {
                output[start..start + len].copy_from_slice(&columns[*slot][..len]);
            }
            start += len;
        }
    }
}

/// A loop of its own for each of some operations or meanings, so that those without branches become
/// vectors, and one for all others. They are written out: closures aren't always inlined, and
/// only what is inlined uses the processor's features.
macro_rules! loops {
    (@loop $of:expr, $to:expr, $known:ident, $format:expr) => {{
        let [a, b, c] = filled($of);
        for (((to, a), b), c) in $to.iter_mut().zip(a).zip(b).zip(c) {
            *to = $known.eval_real([*a, *b, *c], $format);
        }
    }};
    (@loop $of:expr, $to:expr, $known:ident) => {{
        let [a, b, c] = filled($of);
        for (((to, a), b), c) in $to.iter_mut().zip(a).zip(b).zip(c) {
            *to = $known.eval([*a, *b, *c]);
        }
    }};
    ($of:expr, $to:expr, $op:expr, $format:expr; $($pattern:pat),+) => {
        match $op {
            $(known @ $pattern => loops!(@loop $of, $to, known, $format),)+
            other => loops!(@loop $of, $to, other, $format),
        }
    };
    ($of:expr, $to:expr, $meaning:expr; $($pattern:pat),+) => {
        match $meaning {
            $(known @ $pattern => loops!(@loop $of, $to, known),)+
            other => loops!(@loop $of, $to, other),
        }
    };
}

#[inline(always)]
fn step(kernel: Kernel, [a, b, c]: [&[f64]; 3], to: &mut [f64], other: &mut [f64]) {
    match kernel {
        Kernel::Same => to.copy_from_slice(a),
        Kernel::Add => each(to, a, b, |a, b| a + b),
        Kernel::Sub => each(to, a, b, |a, b| a - b),
        Kernel::Mul => each(to, a, b, |a, b| a * b),
        Kernel::Modulo { low, span } => {
            for (to, a) in to.iter_mut().zip(a) {
                *to = modulo(*a, low, span);
            }
        }
        Kernel::Times(factor) => {
            for (to, a) in to.iter_mut().zip(a) {
                *to = a * factor;
            }
        }
        Kernel::Sin => f64::sin_cos_turns(a, to, other),
        Kernel::Cos => f64::sin_cos_turns(a, other, to),
        Kernel::SinCos(_) => unreachable!("bug: it has two columns"),
        Kernel::Meaning(meaning) => loops!([a, b, c], to, meaning;
            Meaning::Apply(Function::Asin, _),
            Meaning::Apply(Function::Prop, _),
            Meaning::Apply(Function::Atan, _),
            Meaning::Apply(Function::HalfRecipSin, _),
            Meaning::Apply(Function::HalfRecipCos, _),
            Meaning::Apply(Function::Recip, _),
            Meaning::Apply(Function::Secant, _),
            Meaning::Atan2 { .. },
            Meaning::Inclination { .. },
            Meaning::OverTwice { function: Function::Sin, .. },
            Meaning::OverTwice { function: Function::Cos, .. },
            Meaning::Negative(_),
            Meaning::CosNegative(_),
            Meaning::Opposite(_),
            Meaning::Quotient { .. },
            Meaning::Root(_),
            Meaning::RecipRoot(_),
            Meaning::Largest { .. },
            Meaning::Tilted { polar: false, .. },
            Meaning::Tilted { polar: true, .. }
        ),
        Kernel::Op(op, format) => loops!([a, b, c], to, op, format;
            Op::Neg, Op::Abs, Op::And, Op::Or, Op::Xor, Op::Less, Op::Mux, Op::AddSub
        ),
    }
}

#[inline(always)]
fn each(to: &mut [f64], a: &[f64], b: &[f64], f: impl Fn(f64, f64) -> f64) {
    for ((to, a), b) in to.iter_mut().zip(a).zip(b) {
        *to = f(*a, *b);
    }
}

/// Operands that are not used read some column; any will do.
#[inline(always)]
fn filled([a, b, c]: [&[f64]; 3]) -> [&[f64]; 3] {
    let filler = if a.is_empty() { b } else { a };
    [a, b, c].map(|x| if x.is_empty() { filler } else { x })
}

/// The same order with each cosine right after the sine of its angle, so that one step gives both.
fn beside(netlist: &Netlist, order: &[usize]) -> Vec<usize> {
    let nodes = netlist.nodes();
    let function = |index: usize| {
        let Some(Meaning::Apply(function, of)) = nodes[index].meaning else { return None };
        matches!(function, Function::Sin | Function::Cos).then_some((function, of))
    };
    let mut known = HashMap::new();
    for index in order.iter().copied() {
        if let Some(function) = function(index) {
            known.entry(function).or_insert(index);
        }
    }
    let mut done = HashSet::new();
    let mut together = Vec::with_capacity(order.len());
    for index in order.iter().copied() {
        let of = function(index).map(|(_, of)| of);
        let pair = of.map(|of| [Function::Sin, Function::Cos].map(|f| known.get(&(f, of))));
        for one in pair.into_iter().flatten().flatten().chain([&index]) {
            if done.insert(*one) {
                together.push(*one);
            }
        }
    }
    together
}

/// The loop for a node.
fn kernel(op: Op, meaning: Option<Meaning>, format: Format) -> Kernel {
    match (meaning, op) {
        (Some(Meaning::Apply(Function::Sin, _)), _) => Kernel::Sin,
        (Some(Meaning::Apply(Function::Cos, _)), _) => Kernel::Cos,
        (Some(meaning), _) => Kernel::Meaning(meaning),
        (None, Op::Narrow { .. }) => Kernel::Same,
        (None, Op::Add) => Kernel::Add,
        (None, Op::Sub) => Kernel::Sub,
        (None, Op::Mul) => Kernel::Mul,
        (None, Op::Modulo) => {
            let span = 2f64.powi(cast::signed_count(format.bits()) - format.frac_bits());
            Kernel::Modulo { low: format.value(format.min_raw()), span }
        }
        (None, Op::Shift { left }) => Kernel::Times(2f64.powi(left)),
        (None, op) => Kernel::Op(op, format),
    }
}
