//! Evaluation of many samples on reals: the algorithm's value at every node.
//!
//! The twin of [`super::batch`] on `f64` columns: `narrow` keeps its operand and a table is the
//! function that it stands for.

use super::batch::BLOCK;
use super::columns::Columns;
use crate::format::Format;
use crate::function::Function;
use crate::netlist::{Netlist, NodeId};
use crate::op::{Meaning, Op};
use crate::simd::{Body, vectorised};
use crate::trig::Real;

/// How a node gets its value on reals.
#[derive(Clone, Copy, Debug)]
enum Kernel {
    /// `narrow` and other operations that keep their operand.
    Same,
    Add,
    Sub,
    Mul,
    Modulo(Format),
    /// Any other operation.
    Op(Op, Format),
    Sin,
    Cos,
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
}

impl Program {
    /// Compiles what the nodes of `outputs` need, all of which must have a value on reals.
    ///
    /// # Panics
    /// If an output has none.
    #[must_use]
    pub fn compile(netlist: &Netlist, outputs: &[NodeId]) -> Self {
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
        let columns = Columns::new(netlist, &operands, outputs);
        let mut program = Self {
            steps: Vec::new(),
            constants: Vec::new(),
            slots: columns.count,
            inputs: Vec::new(),
            outputs: outputs.iter().map(|id| columns.of(id.index())).collect(),
        };
        for (index, (node, operands)) in nodes.iter().zip(&operands).enumerate() {
            let Some(operands) = operands else { continue };
            let to = columns.of(index);
            if node.op == Op::Input {
                program.inputs.push(to);
            } else if let (Op::Const { raw }, None) = (node.op, node.meaning) {
                program.constants.push((to, node.format.value(raw)));
            } else {
                let kernel = kernel(node.op, node.meaning, node.format);
                program.steps.push((kernel, columns.operands(operands), to));
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
            for (slot, input) in program.inputs.iter().zip(inputs) {
                columns[*slot][..len].copy_from_slice(&input[start..start + len]);
            }
            for (kernel, of, to_slot) in &program.steps {
                let mut to = std::mem::take(&mut columns[*to_slot]);
                let of = of.map(|slot| columns[slot].get(..len).unwrap_or_default());
                step(*kernel, of, &mut to[..len], &mut other[..len]);
                columns[*to_slot] = to;
            }
            for (slot, output) in program.outputs.iter().zip(outputs.iter_mut()) {
                output[start..start + len].copy_from_slice(&columns[*slot][..len]);
            }
            start += len;
        }
    }
}

#[inline(always)]
fn step(kernel: Kernel, [a, b, c]: [&[f64]; 3], to: &mut [f64], other: &mut [f64]) {
    match kernel {
        Kernel::Same => to.copy_from_slice(a),
        Kernel::Add => each(to, a, b, |a, b| a + b),
        Kernel::Sub => each(to, a, b, |a, b| a - b),
        Kernel::Mul => each(to, a, b, |a, b| a * b),
        Kernel::Modulo(format) => {
            each(to, a, a, |a, _| Op::Modulo.eval_real([a, 0.0, 0.0], format));
        }
        Kernel::Sin => f64::sin_cos_turns(a, to, other),
        Kernel::Cos => f64::sin_cos_turns(a, other, to),
        Kernel::Meaning(meaning) => each3(to, [a, b, c], |of| meaning.eval(of)),
        Kernel::Op(op, format) => each3(to, [a, b, c], |of| op.eval_real(of, format)),
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
fn each3(to: &mut [f64], [a, b, c]: [&[f64]; 3], f: impl Fn([f64; 3]) -> f64) {
    let filler = if a.is_empty() { b } else { a };
    let [b, c] = [b, c].map(|x| if x.is_empty() { filler } else { x });
    for (((to, a), b), c) in to.iter_mut().zip(a).zip(b).zip(c) {
        *to = f([*a, *b, *c]);
    }
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
        (None, Op::Modulo) => Kernel::Modulo(format),
        (None, op) => Kernel::Op(op, format),
    }
}
