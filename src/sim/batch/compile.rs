//! Compiles a netlist to instructions, one node after another.

use super::program::{Action, Column, Instruction, Port, Program, Tables, slot_of};
use crate::netlist::op::Op;
use crate::netlist::{Netlist, NodeId};
use crate::number::format::Overflow;
use crate::sim::kernels::{Fit, Kernel, Lane, Limit, Slow, Wrap};
use crate::sim::lanes::{Narrowed, Placed, Way, Width, alignment, least, place, wide_product};
use std::collections::HashMap;
use std::sync::Arc;

/// Columns are numbered as they are created; [`Compiler::finish`] lets nodes share them.
pub(super) struct Compiler<'a> {
    netlist: &'a Netlist,
    placed: Vec<Placed>,
    /// True if a node is computed in the pass of the one that reads it.
    fused_into: Vec<bool>,
    /// For a sum, the operand that is a sum computed in the same pass: the first or the second.
    inner: Vec<Option<usize>>,
    pub(super) instructions: Vec<Instruction>,
    /// Width of each column.
    pub(super) widths: Vec<Width>,
    /// Columns of nodes, by width.
    columns: Vec<[Option<usize>; 3]>,
    pub(super) constants: HashMap<(i64, Width), usize>,
    known_tables: HashMap<(usize, usize, Width), usize>,
    counters: Vec<usize>,
    pub(super) program: Program,
}

impl Program {
    /// Compiles a netlist; a run returns the nodes of `outputs`.
    ///
    /// # Panics
    /// If the netlist has an operation without a kernel, which is a bug.
    #[must_use]
    pub fn compile(netlist: &Netlist, outputs: &[NodeId]) -> Self {
        Self::compile_repeated(netlist, outputs, &vec![false; netlist.inputs().len()])
    }

    /// As [`Program::compile`], with ports marked whose words repeat: in each run of more than a
    /// block, all blocks have the same words at that port. Nodes that depend only on those are
    /// computed once per run.
    ///
    /// # Panics
    /// As [`Program::compile`], or if `repeats` doesn't have one entry per port.
    #[must_use]
    pub fn compile_repeated(netlist: &Netlist, outputs: &[NodeId], repeats: &[bool]) -> Self {
        Self::compile_counted(netlist, outputs, repeats, &vec![true; netlist.nodes().len()])
    }

    /// As [`Program::compile_repeated`], restricted to the outputs' cone: a `narrow` that no output
    /// depends on isn't computed, and its count stays 0.
    ///
    /// # Panics
    /// As [`Program::compile_repeated`].
    #[must_use]
    pub fn compile_cone(netlist: &Netlist, outputs: &[NodeId], repeats: &[bool]) -> Self {
        let mut inside = vec![false; netlist.nodes().len()];
        outputs.iter().for_each(|id| inside[id.index()] = true);
        for (index, node) in netlist.nodes().iter().enumerate().rev() {
            if inside[index] {
                node.operands.iter().for_each(|operand| inside[operand.index()] = true);
            }
        }
        Self::compile_counted(netlist, outputs, repeats, &inside)
    }

    fn compile_counted(
        netlist: &Netlist,
        outputs: &[NodeId],
        repeats: &[bool],
        counted: &[bool],
    ) -> Self {
        assert_eq!(repeats.len(), netlist.inputs().len(), "bug: one per port");
        let nodes = netlist.nodes();
        let mut compiler = Compiler {
            netlist,
            placed: place(netlist, outputs, counted),
            fused_into: vec![false; nodes.len()],
            inner: vec![None; nodes.len()],
            instructions: Vec::new(),
            widths: Vec::new(),
            columns: vec![[None; 3]; nodes.len()],
            constants: HashMap::new(),
            known_tables: HashMap::new(),
            counters: vec![0; nodes.len()],
            program: Self {
                instructions: Vec::new(),
                constants: Vec::new(),
                tables16: Tables::default(),
                tables32: Tables::default(),
                tables64: Tables::default(),
                slots: [0; 3],
                inputs: Vec::new(),
                ports: input_ports(netlist),
                results: ports(netlist, outputs),
                outputs: Vec::new(),
                narrows: Vec::new(),
                delays: Vec::new(),
                unbound: None,
                repeated: 0,
                repeats: repeats.to_vec(),
            },
        };
        for (index, node) in nodes.iter().enumerate() {
            if matches!(node.op, Op::Narrow { .. }) {
                compiler.counters[index] = compiler.program.narrows.len();
                compiler.program.narrows.push(netlist.id_at(index));
            }
        }
        compiler.fuse(outputs);
        for index in 0..nodes.len() {
            compiler.node(index);
        }
        let outputs: Vec<(usize, bool)> = outputs
            .iter()
            .map(|id| {
                let index = compiler.root(id.index());
                let Placed { width, zero, .. } = compiler.placed[index];
                (compiler.column(index, width), zero)
            })
            .collect();
        compiler.finish(&outputs)
    }
}

fn input_ports(netlist: &Netlist) -> Vec<Port> {
    let ids = netlist.inputs().iter().enumerate();
    ids.map(|(port, id)| Port {
        name: netlist.input_name(port).to_owned(),
        format: netlist.node(*id).format,
    })
    .collect()
}

/// Output nodes with the names of their ports, other nodes with their labels.
fn ports(netlist: &Netlist, ids: &[NodeId]) -> Vec<Port> {
    let name = |id: NodeId| {
        let output = netlist.outputs().iter().find(|output| output.node == id);
        output.map_or_else(|| netlist.label(id), |output| output.name.clone())
    };
    ids.iter().map(|id| Port { name: name(*id), format: netlist.node(*id).format }).collect()
}

impl Compiler<'_> {
    /// The node whose lanes a node shares.
    fn root(&self, mut index: usize) -> usize {
        while let Way::Same(operand) = self.placed[index].way {
            index = operand;
        }
        index
    }

    fn operand(&self, index: usize, i: usize) -> usize {
        self.root(self.netlist.nodes()[index].operands[i].index())
    }

    /// Finds sums and products that only one `narrow` or slice reads, which then does both in one
    /// pass, and sums that only one sum reads.
    fn fuse(&mut self, outputs: &[NodeId]) {
        let nodes = self.netlist.nodes();
        let mut uses = vec![0; nodes.len()];
        for id in outputs {
            uses[self.root(id.index())] += 2;
        }
        let works = |placed: &Placed| matches!(placed.way, Way::Computed | Way::Low(_));
        for index in (0..nodes.len()).filter(|i| works(&self.placed[*i])) {
            for i in 0..nodes[index].operands.len() {
                uses[self.operand(index, i)] += 1;
            }
        }
        for index in 0..nodes.len() {
            let Placed { way, width, compute, .. } = self.placed[index];
            if way != Way::Computed {
                continue;
            }
            let fits = if let Op::Narrow { round, .. } = nodes[index].op {
                let narrowed = self.narrowed(index);
                let biases = Fit::biases(round, narrowed.down.min(62));
                narrowed.compute.is_some() && biases[1] == 0 && biases[2] == 0
            } else if let Op::Slice { .. } = nodes[index].op {
                width == compute
            } else {
                continue;
            };
            let first = self.operand(index, 0);
            let before = &self.placed[first];
            let summed = self.is_sum(first) || nodes[first].op == Op::Mul;
            // In these lanes, all bits of the sum are right.
            let same = before.compute == self.placed[index].compute;
            if fits && summed && same && uses[first] == 1 && before.way == Way::Computed {
                self.fused_into[first] = true;
            }
        }
        for index in 0..nodes.len() {
            if self.placed[index].way == Way::Computed && self.is_sum(index) {
                let inner = (0..2).find(|i| self.sums_in(index, *i, &uses));
                if let Some(i) = inner {
                    let operand = self.operand(index, i);
                    self.fused_into[operand] = true;
                    self.inner[index] = inner;
                }
            }
        }
    }

    fn is_sum(&self, index: usize) -> bool {
        matches!(self.netlist.nodes()[index].op, Op::Add | Op::Sub)
    }

    /// True if an operand of a sum is itself a sum of two that nothing else reads, in the same
    /// lanes.
    fn sums_in(&self, index: usize, i: usize, uses: &[usize]) -> bool {
        let inner = self.operand(index, i);
        let Placed { way, width, compute, .. } = self.placed[inner];
        let lanes = self.placed[index].compute;
        let most = || self.shifts(inner).into_iter().max().unwrap_or_default();
        way == Way::Computed
            && self.is_sum(inner)
            && uses[inner] == 1
            && self.inner[inner].is_none()
            && !self.fused_into[inner]
            && width == lanes
            && compute == lanes
            && most() + self.shifts(index)[i] < lanes.bits()
    }

    /// Shifts that align the operands of a sum.
    fn shifts(&self, index: usize) -> [u32; 2] {
        let operands = &self.netlist.nodes()[index].operands;
        let format = |i: usize| self.netlist.node(operands[i]).format;
        alignment(format(0), format(1))
    }

    /// The operands and the kernel of a sum or product, including a sum fused into it.
    fn terms(&self, index: usize, fit: Option<Fit>) -> (Vec<usize>, Kernel) {
        let [a, b] = [0, 1].map(|i| self.operand(index, i));
        let op = self.netlist.nodes()[index].op;
        if op == Op::Mul {
            return (vec![a, b], Kernel::Mul { fit });
        }
        let (shifts, minus) = (self.shifts(index), op == Op::Sub);
        let Some(i) = self.inner[index] else {
            let kernel =
                if minus { Kernel::Sub { shifts, fit } } else { Kernel::Add { shifts, fit } };
            return (vec![a, b], kernel);
        };
        let inner = [a, b][i];
        let [c, d] = [0, 1].map(|i| self.operand(inner, i));
        let [sc, sd] = self.shifts(inner).map(|shift| shift + shifts[i]);
        let inner_minus = self.netlist.nodes()[inner].op == Op::Sub;
        if i == 0 {
            let (shifts, minus) = ([sc, sd, shifts[1]], [inner_minus, minus]);
            (vec![c, d, b], Kernel::Sum { shifts, minus, fit })
        } else {
            let (shifts, minus) = ([shifts[0], sc, sd], [minus, minus != inner_minus]);
            (vec![a, c, d], Kernel::Sum { shifts, minus, fit })
        }
    }

    fn narrowed(&self, index: usize) -> Narrowed {
        let node = &self.netlist.nodes()[index];
        let Op::Narrow { round, overflow } = node.op else { panic!("bug: a narrow") };
        let from = node.operands[0];
        let range = self.placed_range(from.index());
        Narrowed::new(range, self.netlist.node(from).format, node.format, round, overflow)
    }

    fn placed_range(&self, index: usize) -> (i64, i64) {
        self.placed[index].range
    }

    fn new_column(&mut self, width: Width) -> usize {
        self.widths.push(width);
        self.widths.len() - 1
    }

    fn constant(&mut self, raw: i64, width: Width) -> usize {
        if let Some(known) = self.constants.get(&(raw, width)) {
            return *known;
        }
        let column = self.new_column(width);
        self.constants.insert((raw, width), column);
        column
    }

    /// The column of a node in lanes of a width, converted from its own width if necessary.
    fn column(&mut self, index: usize, width: Width) -> usize {
        let index = self.root(index);
        let Placed { way, width: own, zero, .. } = self.placed[index];
        if let Way::Constant(raw) = way {
            return self.constant(raw, width);
        }
        if let Some(known) = self.columns[index][slot_of(width)] {
            return known;
        }
        assert!(own != width, "bug: %{index} is read before it is computed");
        let from = self.column(index, own);
        let to = self.new_column(width);
        self.push(Action::Convert { zero }, own, &[from], to);
        self.columns[index][slot_of(width)] = Some(to);
        to
    }

    fn push(&mut self, action: Action, width: Width, operands: &[usize], to: usize) {
        let mut of = [usize::MAX; 3];
        of[..operands.len()].copy_from_slice(operands);
        let to = Column { width: self.widths[to], slot: to };
        self.instructions.push(Instruction { action, width, of, operands: operands.len(), to });
    }

    /// Emits the instructions of a node, after those of its operands.
    fn node(&mut self, index: usize) {
        let Placed { way, width, compute, .. } = self.placed[index];
        let nodes = self.netlist.nodes();
        let node = &nodes[index];
        if node.op == Op::Input {
            let column = (way == Way::Computed).then(|| self.new_column(width));
            self.columns[index][slot_of(width)] = column;
            // Slots are column numbers until [`Compiler::finish`].
            self.program.inputs.push(column.map(|slot| Column { width, slot }));
            return;
        }
        match way {
            Way::Unused | Way::Constant(_) | Way::Same(_) => return,
            Way::Low(operand) => {
                let column = self.column(operand, width);
                self.columns[index][slot_of(width)] = Some(column);
                return;
            }
            Way::Computed
                if self.fused_into[index] || self.columns[index][slot_of(width)].is_some() =>
            {
                return;
            }
            Way::Computed => {}
        }
        if let Op::Read { .. } = node.op {
            self.read(index);
            return;
        }
        let mut operands: Vec<usize> =
            (0..node.operands.len()).map(|i| self.operand(index, i)).collect();
        let action = if let Op::Delay { samples } = node.op {
            self.program.delays.push(samples);
            Action::Delay { line: self.program.delays.len() - 1 }
        } else if let Op::Slice { lo } = node.op {
            let first = self.operand(index, 0);
            let limit = Limit::Slice { bits: node.format.bits() };
            if self.fused_into[first] {
                let fit = Fit {
                    up: 0,
                    down: lo,
                    bias: 0,
                    bias_below_0: 0,
                    bias_if_odd: 0,
                    limit,
                    halves: false,
                    // Unused: a slice counts nothing. Every runner has at least one counter.
                    counter: 0,
                };
                self.fused(first, fit, index);
                return;
            }
            Action::Kernel(self.kernel(index))
        } else if let Op::Narrow { .. } = node.op {
            let first = self.operand(index, 0);
            let fit = self.fit(index);
            if self.fused_into[first] {
                self.fused(first, fit.expect("bug: fused"), index);
                return;
            }
            Action::Kernel(fit.map_or_else(|| Kernel::Slow(self.slow(index)), Kernel::Fit))
        } else if node.op == Op::Mul && self.is_wide(index, width) {
            let [a, b] = [0, 1].map(|i| self.operand(index, i));
            let of = [self.column(a, Width::W32), self.column(b, Width::W32)];
            let to = self.new_column(width);
            self.push(Action::WideProduct(None), Width::W32, &of, to);
            self.columns[index][slot_of(width)] = Some(to);
            return;
        } else if matches!(node.op, Op::Add | Op::Sub | Op::Mul) {
            let (terms, kernel) = self.terms(index, None);
            operands = terms;
            Action::Kernel(kernel)
        } else {
            Action::Kernel(self.kernel(index))
        };
        let of: Vec<usize> =
            operands.into_iter().map(|operand| self.column(operand, compute)).collect();
        let to = self.new_column(width);
        self.push(action, compute, &of, to);
        self.columns[index][slot_of(width)] = Some(to);
    }

    fn is_wide(&self, index: usize, width: Width) -> bool {
        let node = &self.netlist.nodes()[index];
        let [a, b] = [0, 1].map(|i| self.placed[node.operands[i].index()].range);
        wide_product(width, a, b)
    }

    /// A sum or product fused with the `narrow` or slice that reads it.
    fn fused(&mut self, sum: usize, fit: Fit, narrow: usize) {
        let Placed { width, compute, .. } = self.placed[narrow];
        let node = &self.netlist.nodes()[sum];
        let wide = node.op == Op::Mul && self.is_wide(sum, compute);
        let lanes = if wide { Width::W32 } else { compute };
        let (operands, kernel) = self.terms(sum, Some(fit));
        let of: Vec<usize> =
            operands.into_iter().map(|operand| self.column(operand, lanes)).collect();
        let action = if wide { Action::WideProduct(Some(fit)) } else { Action::Kernel(kernel) };
        let to = self.new_column(width);
        self.push(action, lanes, &of, to);
        self.columns[narrow][slot_of(width)] = Some(to);
    }

    fn fit(&self, index: usize) -> Option<Fit> {
        let node = &self.netlist.nodes()[index];
        let Op::Narrow { round, overflow } = node.op else { panic!("bug: a narrow") };
        let narrowed = self.narrowed(index);
        narrowed.compute?;
        let Placed { compute, width, .. } = self.placed[index];
        let halves = narrowed.halves && compute == Width::W64 && width == Width::W32;
        let lanes = if halves { 32 } else { compute.bits() };
        let (min, max) = (i64::MIN >> (64 - lanes), i64::MAX >> (64 - lanes));
        let [bias, bias_below_0, bias_if_odd] = Fit::biases(round, narrowed.down);
        Some(Fit {
            up: narrowed.up,
            down: narrowed.down,
            bias,
            bias_below_0,
            bias_if_odd,
            limit: match overflow {
                _ if !narrowed.overflows => Limit::Free,
                Overflow::Saturate | Overflow::Symmetric => Limit::Clamp {
                    lo: least(node.format, overflow).clamp(min, max),
                    hi: node.format.max_raw().clamp(min, max),
                },
                Overflow::Wrap | Overflow::Error => {
                    Limit::Wrap(Wrap { signed: node.format.is_signed(), bits: node.format.bits() })
                }
            },
            halves,
            counter: self.counters[index],
        })
    }

    fn slow(&self, index: usize) -> Slow {
        let node = &self.netlist.nodes()[index];
        let Op::Narrow { round, overflow } = node.op else { panic!("bug: a narrow") };
        let from_frac = self.netlist.node(node.operands[0]).format.frac_bits();
        Slow { from_frac, to: node.format, round, overflow, counter: self.counters[index] }
    }

    fn kernel(&self, index: usize) -> Kernel {
        let node = &self.netlist.nodes()[index];
        let format_of = |i: usize| self.netlist.node(node.operands[i]).format;
        let shifts = |a: usize, b: usize| alignment(format_of(a), format_of(b));
        match node.op {
            Op::AddSub => Kernel::AddSub { shifts: shifts(1, 2) },
            Op::Neg => Kernel::Neg,
            Op::Abs => Kernel::Abs,
            Op::And => Kernel::And,
            Op::Or => Kernel::Or,
            Op::Xor => Kernel::Xor,
            Op::Equal => Kernel::Equal { shifts: shifts(0, 1) },
            Op::Less => Kernel::Less { shifts: shifts(0, 1) },
            Op::Mux => Kernel::Mux { shifts: shifts(1, 2) },
            Op::Slice { lo } => Kernel::Slice { lo, bits: node.format.bits() },
            Op::Concat => Kernel::Concat { low_bits: format_of(1).bits() },
            Op::LeadingZeros => {
                let lanes = self.placed[index].compute.bits();
                Kernel::LeadingZeros { more: i64::from(format_of(0).bits()) - i64::from(lanes) }
            }
            Op::ShiftLeft { max } => Kernel::ShiftLeft { max },
            Op::Modulo => {
                Kernel::Wrap(Wrap { signed: node.format.is_signed(), bits: node.format.bits() })
            }
            Op::Input
            | Op::Const { .. }
            | Op::Add
            | Op::Sub
            | Op::Mul
            | Op::Shift { .. }
            | Op::Read { .. }
            | Op::Delay { .. }
            | Op::Narrow { .. } => {
                panic!("bug: {} has no kernel of its own", node.op.name())
            }
        }
    }

    /// A table read, paired with a later one at the same address if there is one.
    fn read(&mut self, index: usize) {
        let nodes = self.netlist.nodes();
        let read =
            self.netlist.read_of(self.netlist.id_at(index)).filter(|table| table.is_unbound());
        if let Some(memory) = read {
            self.program.unbound.get_or_insert_with(|| memory.name.clone());
        }
        let Placed { width, .. } = self.placed[index];
        let address = self.operand(index, 0);
        let lanes = self.placed[address].width;
        let of = self.column(address, lanes);
        let partner = (index + 1..nodes.len()).find(|other| {
            let Placed { way, width: its, .. } = self.placed[*other];
            matches!(nodes[*other].op, Op::Read { .. })
                && way == Way::Computed
                && its == width
                && self.columns[*other][slot_of(width)].is_none()
                && self.operand(*other, 0) == address
        });
        let first = Arc::clone(self.words(index));
        let second = partner.map(|other| Arc::clone(self.words(other)));
        let table = match width {
            Width::W16 => {
                packed(&mut self.known_tables, &mut self.program.tables16, &first, second.as_ref())
            }
            Width::W32 => {
                packed(&mut self.known_tables, &mut self.program.tables32, &first, second.as_ref())
            }
            Width::W64 => {
                packed(&mut self.known_tables, &mut self.program.tables64, &first, second.as_ref())
            }
        };
        let to = self.new_column(width);
        self.columns[index][slot_of(width)] = Some(to);
        let action = if let Some(other) = partner {
            let second = self.new_column(width);
            self.columns[other][slot_of(width)] = Some(second);
            Action::ReadPair { table, second }
        } else {
            Action::Read { table }
        };
        self.push(action, lanes, &[of], to);
    }

    fn words(&self, index: usize) -> &Arc<[i64]> {
        let Op::Read { table, column } = self.netlist.nodes()[index].op else {
            panic!("bug: a read")
        };
        let column = usize::try_from(column).expect("bug: small");
        &self.netlist.tables()[table.index()].columns[column].words
    }
}

/// Index of a table, or of a pair of tables, among those packed.
fn packed<L: Lane>(
    known: &mut HashMap<(usize, usize, Width), usize>,
    tables: &mut Tables<L>,
    first: &Arc<[i64]>,
    second: Option<&Arc<[i64]>>,
) -> usize {
    let address = |words: &Arc<[i64]>| words.as_ptr().addr();
    let key = (address(first), second.map_or(0, address), L::WIDTH);
    *known.entry(key).or_insert_with(|| match second {
        None => {
            tables.single.push(first.iter().map(|word| L::of(*word)).collect());
            tables.single.len() - 1
        }
        Some(second) => {
            let pairs = first.iter().zip(&second[..]);
            tables.pairs.push(pairs.map(|(a, b)| L::pair(L::of(*a), L::of(*b))).collect());
            tables.pairs.len() - 1
        }
    })
}
