//! Evaluates many samples on reals: the algorithm's value at every node.
//!
//! The counterpart of [`super::batch`] on `f64` columns: `narrow` passes its operand through, and a
//! table is the function that it approximates. It evaluates the terms of [`Netlist::reals`].

use super::batch::BLOCK;
use super::columns::Columns;
use crate::base::error::{Error, Result};
use crate::base::simd::{Body, vectorised};
use crate::netlist::{Netlist, NodeId};
use crate::number::function;
use crate::number::real::{Graph, Primitive, Rows, Term, TermId, modulo};
use crate::number::trig::Real;
use std::collections::{HashMap, HashSet};

/// How a term is computed.
#[derive(Clone, Debug)]
enum Kernel {
    /// A primitive.
    Of(Primitive),
    /// Subtracts a multiple of `span` so that the result is from `low` to below `low + span`, both
    /// constants.
    Modulo { low: f64, span: f64 },
    /// Multiplication by a constant.
    Times(f64),
    /// Sine and cosine of one angle; the cosine goes to this column.
    SinCos(usize),
    /// A function with its own kernel.
    Call(function::Kernel),
    /// The value in a list of rows.
    Row(Rows),
}

/// A netlist's reals compiled for blocks; bit-identical to [`Netlist::eval_reals`].
#[derive(Clone, Debug)]
pub struct Program {
    steps: Vec<(Kernel, [usize; 3], usize)>,
    constants: Vec<(usize, f64)>,
    slots: usize,
    inputs: Vec<usize>,
    outputs: Vec<usize>,
    /// The number of leading steps that give the same values in each block of a run.
    repeated: usize,
    /// Which ports hold the same values in each block of a run.
    repeats: Vec<bool>,
}

impl Program {
    /// Compiles everything that the nodes of `outputs` need.
    ///
    /// # Errors
    /// If one of them is bits without a value on reals.
    pub fn compile(netlist: &Netlist, outputs: &[NodeId]) -> Result<Self> {
        Self::compile_repeated(netlist, outputs, &vec![false; netlist.inputs().len()])
    }

    /// As [`Program::compile`], with ports marked whose values are the same in each block of a run.
    /// Terms that depend only on those are computed once per run.
    ///
    /// # Errors
    /// As [`Program::compile`].
    ///
    /// # Panics
    /// If `repeats` doesn't have one entry per port.
    pub fn compile_repeated(
        netlist: &Netlist,
        outputs: &[NodeId],
        repeats: &[bool],
    ) -> Result<Self> {
        assert_eq!(repeats.len(), netlist.inputs().len(), "bug: one per port");
        let real = |id: &NodeId| {
            netlist.node(*id).real.ok_or_else(|| {
                Error::usage(format!(
                    "`{}` of `{}` is bits without a value on reals, so its error can't be measured: give it a meaning, or leave it out",
                    netlist.label(*id),
                    netlist.name()
                ))
            })
        };
        let outputs: Vec<TermId> = outputs.iter().map(real).collect::<Result<_>>()?;
        Ok(Self::of_graph(netlist.reals(), &outputs, repeats))
    }

    /// Compiles everything that some terms of a graph need. The first terms of the graph are its
    /// variables.
    fn of_graph(graph: &Graph, outputs: &[TermId], repeats: &[bool]) -> Self {
        let terms = graph.terms();
        let mut needed = vec![false; terms.len()];
        needed[..repeats.len()].fill(true);
        outputs.iter().for_each(|id| needed[id.index()] = true);
        for index in (0..terms.len()).rev() {
            if needed[index] {
                terms[index].operands().iter().for_each(|id| needed[id.index()] = true);
            }
        }
        let mut same = vec![true; terms.len()];
        same[..repeats.len()].copy_from_slice(repeats);
        for index in repeats.len()..terms.len() {
            same[index] = terms[index].operands().iter().all(|id| same[id.index()]);
        }
        // Ports and repeated terms first, in unchanged order.
        let early = |index: &usize| same[*index] || *index < repeats.len();
        let (mut order, rest): (Vec<usize>, Vec<usize>) =
            (0..terms.len()).filter(|index| needed[*index]).partition(early);
        let first = order.len();
        order.extend(rest);
        let order = beside(terms, &order);
        let columns = Columns::new(graph, &order, first, outputs);
        let mut program = Self {
            steps: Vec::new(),
            constants: Vec::new(),
            slots: columns.count,
            inputs: Vec::new(),
            outputs: outputs.iter().map(|id| columns.of(id.index())).collect(),
            repeated: 0,
            repeats: repeats.to_vec(),
        };
        let constant = |id: TermId| match terms[id.index()] {
            Term::Constant(number) => Some(number.get()),
            Term::Variable(_) | Term::Of(..) | Term::Call(..) | Term::Row(..) => None,
        };
        for (at, index) in order.iter().copied().enumerate() {
            let to = columns.of(index);
            let mut of = columns.operands(terms[index].operands());
            let kernel = match &terms[index] {
                Term::Variable(_) => {
                    program.inputs.push(to);
                    continue;
                }
                Term::Constant(number) => {
                    program.constants.push((to, number.get()));
                    continue;
                }
                Term::Call(function, _) => {
                    Kernel::Call(function.kernel().expect("bug: only such functions are terms"))
                }
                Term::Row(rows, _) => Kernel::Row(rows.clone()),
                Term::Of(primitive, operands) => {
                    if *primitive == Primitive::Cos
                        && let Some((before @ Kernel::Of(Primitive::Sin), [angle, ..], _)) =
                            program.steps.last_mut()
                        && *angle == of[0]
                    {
                        *before = Kernel::SinCos(to);
                        continue;
                    }
                    kernel(*primitive, operands.map(constant), &mut of)
                }
            };
            program.steps.push((kernel, of, to));
            if at < first {
                program.repeated += 1;
            }
        }
        program
    }

    /// Allocates columns for one thread.
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

/// A run over all blocks, compiled for the processor's features.
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
                    step(kernel, of, &mut to[..len], &mut other[..len]);
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

/// A separate loop for each primitive, so that the compiler vectorises those without branches. The
/// loops are written out because closures aren't always inlined, and only inlined code uses the
/// processor's features.
macro_rules! loops {
    ($primitive:expr, $of:expr, $to:expr; $($known:ident),+) => {
        match $primitive {
            $(Primitive::$known => {
                let [a, b, c] = filled($of);
                for (((to, a), b), c) in $to.iter_mut().zip(a).zip(b).zip(c) {
                    *to = Primitive::$known.twin(*a, *b, *c);
                }
            })+
        }
    };
}

#[inline(always)]
fn step(kernel: &Kernel, of: [&[f64]; 3], to: &mut [f64], other: &mut [f64]) {
    match kernel {
        Kernel::Modulo { low, span } => {
            for (to, a) in to.iter_mut().zip(of[0]) {
                *to = modulo(*a, *low, *span);
            }
        }
        Kernel::Times(factor) => {
            for (to, a) in to.iter_mut().zip(of[0]) {
                *to = a * factor;
            }
        }
        Kernel::Of(Primitive::Sin) => f64::sin_cos_turns(of[0], to, other),
        Kernel::Of(Primitive::Cos) => f64::sin_cos_turns(of[0], other, to),
        Kernel::SinCos(_) => unreachable!("bug: it has two columns"),
        Kernel::Call(kernel) => kernel(of[0], to),
        Kernel::Row(rows) => {
            for (to, a) in to.iter_mut().zip(of[0]) {
                *to = rows.at(*a);
            }
        }
        Kernel::Of(primitive) => loops!(*primitive, of, to;
            Add, Sub, Mul, Div, Neg, Abs, Min, Max, Floor, Modulo, Sqrt, Exp2, Log2, Pow, Exponent, Sin, Cos, Asin,
            Acos, Atan, Atan2, Less, Equal, Select
        ),
    }
}

/// Unused operands read some column; any will do.
#[inline(always)]
fn filled([a, b, c]: [&[f64]; 3]) -> [&[f64]; 3] {
    let filler = if a.is_empty() { b } else { a };
    [a, b, c].map(|x| if x.is_empty() { filler } else { x })
}

/// The loop for a primitive, some of whose operands are constants.
fn kernel(primitive: Primitive, numbers: [Option<f64>; 3], of: &mut [usize; 3]) -> Kernel {
    if primitive == Primitive::Mul {
        if let Some(factor) = numbers[1] {
            return Kernel::Times(factor);
        }
        if let Some(factor) = numbers[0] {
            of.swap(0, 1);
            return Kernel::Times(factor);
        }
    }
    if primitive == Primitive::Modulo
        && let [_, Some(low), Some(span)] = numbers
    {
        return Kernel::Modulo { low, span };
    }
    Kernel::Of(primitive)
}

/// The same order, but with each cosine right after the sine of its angle, so that one step
/// computes both.
fn beside(terms: &[Term], order: &[usize]) -> Vec<usize> {
    let wave = |index: usize| match terms[index] {
        Term::Of(primitive @ (Primitive::Sin | Primitive::Cos), [of, ..]) => Some((primitive, of)),
        Term::Constant(_) | Term::Variable(_) | Term::Of(..) | Term::Call(..) | Term::Row(..) => {
            None
        }
    };
    let mut known = HashMap::new();
    for index in order.iter().copied() {
        if let Some(wave) = wave(index) {
            known.insert(wave, index);
        }
    }
    let mut done = HashSet::new();
    let mut together = Vec::with_capacity(order.len());
    for index in order.iter().copied() {
        let pair = wave(index)
            .map(|(_, of)| [Primitive::Sin, Primitive::Cos].map(|wave| known.get(&(wave, of))));
        for one in pair.into_iter().flatten().flatten().chain([&index]) {
            if done.insert(*one) {
                together.push(*one);
            }
        }
    }
    together
}
