//! Bit-true simulation of many samples: the netlist as a program over columns.
//!
//! [`Program::compile`] turns the netlist into instructions over columns of lanes, and a [`Runner`]
//! runs them block by block, without allocation; nothing is dispatched per sample. What is asked
//! of each node decides its lane (`lanes.rs`): 16, 32 or 64 bits, by the words that can occur
//! and by the bits that users look at. Shifts of the binary point, residues and `narrow`s that
//! change no bit take no instruction; a `narrow` runs in the pass of the sum or product before it;
//! nodes that nobody asks for are gone and those with one word are constants.
//!
//! A table read is a pass of its own of scalar loads: gathers are slower, and reads inside other
//! loops make a chain of them. Tables hold the narrowest lanes that their words fit, and two that are read at
//! one address lie side by side, so that one address serves both. Columns are given to
//! later nodes when all users are done, so that a block's columns and the tables share the
//! first-level cache.
//!
//! Columns start on cache lines, as vectors across two lines cost two accesses, and the input columns of the next
//! block are asked for while one runs.
//!
//! Measured on the rotation unit (`cargo bench --bench engine`): lanes of one width, one node a pass,
//! gave 74 to 105 million samples a second (told by `sim`, on 64-bit columns); typed lanes, sums fused with what narrows them and paired reads 210 to 240;
//! addresses taken apart in registers, four to a load, and short-lived columns 280 to 320; columns on cache lines 8 to 13 %
//! more, asking ahead 10 to 13 % where inputs aren't in the cache, sums of three in a pass 2 to 4 % of `exact`. Tables with a row for
//! every pattern, so that no mask is needed, and pairs split after the reads gained nothing. An interpreter of passes
//! is kept because passes over a block cost about as much as they would compiled: the faster of two kernels by hand for
//! the one setting, for AVX2 and for AVX-512, takes 0.7 times as long.
//!
//! `kernels.rs` has the loops, plain Rust that the compiler vectorises for each set of
//! processor features in `simd.rs`. [`crate::sim::real`] does the same on reals, for the
//! algorithm's value at every node.

use crate::sim::kernels::{self, Fit, Kernel, Lane, Limit, Slow, Wrap};
use crate::sim::lanes::{Narrowed, Placed, Way, Width, alignment, least, place, wide_product};
use crate::base::cast;
use crate::base::error::{Error, Result};
pub use crate::base::simd::Features;
use crate::base::simd::{Body, prefetch, vectorised_for};
use crate::netlist::op::Op;
use crate::netlist::{Netlist, NodeId};
use crate::number::format::Overflow;
use std::cmp::Reverse;
use std::collections::{BTreeSet, HashMap};
use std::mem::take;
use std::ops::Range;
use std::sync::Arc;

/// Samples per block: two kilobytes a column in 16-bit lanes.
pub const BLOCK: usize = 1024;

/// A number that callers' columns hold.
pub trait Word: Copy + Default + Send + Sync {
    /// The word, of which the low bits count.
    fn word(self) -> i64;
    /// The low bits of a word.
    fn of_word(word: i64) -> Self;
}

impl Word for i64 {
    #[inline(always)]
    fn word(self) -> i64 {
        self
    }
    #[inline(always)]
    fn of_word(word: i64) -> Self {
        word
    }
}

impl Word for i32 {
    #[inline(always)]
    fn word(self) -> i64 {
        i64::from(self)
    }
    #[inline(always)]
    fn of_word(word: i64) -> Self {
        cast::low_i32(word)
    }
}

impl Word for u16 {
    #[inline(always)]
    fn word(self) -> i64 {
        i64::from(self)
    }
    #[inline(always)]
    fn of_word(word: i64) -> Self {
        cast::low_u16(word)
    }
}

/// A column: of all lanes of its width, the one with this number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Column {
    width: Width,
    slot: usize,
}

/// What an instruction does.
#[derive(Clone, Copy, Debug)]
enum Action {
    /// Lanes of the operands' width in, lanes of the result's out.
    Kernel(Kernel),
    /// A product of 32-bit lanes in 64 bits, and what becomes of it.
    WideProduct(Option<Fit>),
    /// Lanes of another width, extended by zeros or by the sign.
    Convert { zero: bool },
    /// A table's words; which of those of the result's width.
    Read { table: usize },
    /// Two tables' words at one address; the second goes to `second`.
    ReadPair { table: usize, second: usize },
}

#[derive(Clone, Copy, Debug)]
struct Instruction {
    action: Action,
    /// Width of the operands.
    width: Width,
    of: [usize; 3],
    operands: usize,
    to: Column,
}

/// Tables in lanes of one width.
#[derive(Clone, Debug, Default)]
struct Tables<L: Lane> {
    single: Vec<Arc<[L]>>,
    pairs: Vec<Arc<[L::Pair]>>,
}

/// A netlist compiled for blocks of samples.
#[derive(Clone, Debug)]
pub struct Program {
    instructions: Vec<Instruction>,
    constants: Vec<(Column, i64)>,
    tables16: Tables<i16>,
    tables32: Tables<i32>,
    tables64: Tables<i64>,
    /// Number of columns of each width.
    slots: [usize; 3],
    /// Column of each port that something reads.
    inputs: Vec<Option<Column>>,
    /// Column of each output, and whether zeros extend it.
    outputs: Vec<(Column, bool)>,
    /// The `narrow` nodes, in the order of the counters.
    narrows: Vec<NodeId>,
    /// The first instructions give the same words in each block of a run, so many of them.
    repeated: usize,
    /// Which ports hold the same words in each block of a run.
    repeats: Vec<bool>,
}

/// Columns are numbered as they are made, and shared between nodes at the end.
struct Compiler<'a> {
    netlist: &'a Netlist,
    placed: Vec<Placed>,
    /// True if a node is computed with the one that reads it, in the same pass.
    fused_into: Vec<bool>,
    /// Of a sum, the operand that is a sum in the same pass: the first or the second.
    inner: Vec<Option<usize>>,
    instructions: Vec<Instruction>,
    /// Width of each column.
    widths: Vec<Width>,
    /// Columns of nodes, by width.
    columns: Vec<[Option<usize>; 3]>,
    constants: HashMap<(i64, Width), usize>,
    known_tables: HashMap<(usize, usize, Width), usize>,
    counters: Vec<usize>,
    program: Program,
}

impl Program {
    /// Compiles a netlist; the nodes of `outputs` are what a run gives.
    ///
    /// # Panics
    /// If the netlist has an operation without a kernel: that is wrong code.
    #[must_use]
    pub fn compile(netlist: &Netlist, outputs: &[NodeId]) -> Self {
        Self::compile_repeated(netlist, outputs, &vec![false; netlist.inputs().len()])
    }

    /// As [`Program::compile`], where the words at some ports repeat: in each run of more than a block, all
    /// blocks have the same at that port. What depends on such ports only is computed once a run.
    ///
    /// # Panics
    /// As [`Program::compile`], or if there is not one `repeats` per port.
    #[must_use]
    pub fn compile_repeated(netlist: &Netlist, outputs: &[NodeId], repeats: &[bool]) -> Self {
        Self::compile_counted(netlist, outputs, repeats, &vec![true; netlist.nodes().len()])
    }

    /// As [`Program::compile_repeated`] of the outputs' cone alone: a `narrow` that none of them depends on isn't computed, and
    /// its count stays 0.
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
                outputs: Vec::new(),
                narrows: Vec::new(),
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

    /// The `narrow` nodes, in the order of [`Runner::overflows`].
    #[must_use]
    pub fn narrows(&self) -> &[NodeId] {
        &self.narrows
    }

    /// Makes a runner with columns of its own.
    #[must_use]
    pub fn runner(&self) -> Runner {
        self.runner_for(Features::best())
    }

    /// As [`Program::runner`], for a set of processor features; the baseline if this processor
    /// lacks them.
    #[must_use]
    pub fn runner_for(&self, features: Features) -> Runner {
        let mut store = Store {
            features,
            lanes16: columns(self.slots[0]),
            lanes32: columns(self.slots[1]),
            lanes64: columns(self.slots[2]),
        };
        for (column, raw) in &self.constants {
            match column.width {
                Width::W16 => fill(&mut store.lanes16[column.slot], *raw),
                Width::W32 => fill(&mut store.lanes32[column.slot], *raw),
                Width::W64 => fill(&mut store.lanes64[column.slot], *raw),
            }
        }
        let counters = self.narrows.len().max(1);
        Runner {
            store,
            overflows: vec![0; counters],
            repeated: vec![0; counters],
            narrows: self.narrows.len(),
        }
    }
}

fn slot_of(width: Width) -> usize {
    match width {
        Width::W16 => 0,
        Width::W32 => 1,
        Width::W64 => 2,
    }
}

impl Compiler<'_> {
    /// The node whose lanes serve for a node.
    fn root(&self, mut index: usize) -> usize {
        while let Way::Same(operand) = self.placed[index].way {
            index = operand;
        }
        index
    }

    fn operand(&self, index: usize, i: usize) -> usize {
        self.root(self.netlist.nodes()[index].operands[i].index())
    }

    /// Finds sums and products that only one `narrow` or slice reads, which then does both in one pass,
    /// and sums that only one sum reads.
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
            // In these lanes, all of the sum is right.
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

    /// True if an operand of a sum is a sum of two that nobody else reads, in the same lanes.
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

    /// The operands of a sum or product and its kernel, with what is summed in the same pass.
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

    /// The column of a node in lanes of a width; made from its own if it isn't there.
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

    /// Writes the instructions of a node, after those of its operands.
    fn node(&mut self, index: usize) {
        let Placed { way, width, compute, .. } = self.placed[index];
        let nodes = self.netlist.nodes();
        let node = &nodes[index];
        if node.op == Op::Input {
            let column = (way == Way::Computed).then(|| self.new_column(width));
            self.columns[index][slot_of(width)] = column;
            // Columns are numbers until the end.
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
        let action = if let Op::Slice { lo } = node.op {
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
                    // Counts nothing; a program without a `narrow` has a counter all the same.
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

    /// A sum or product with the `narrow` that reads it.
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
            | Op::Narrow { .. } => {
                panic!("bug: {} has no kernel of its own", node.op.name())
            }
        }
    }

    /// A read, with a later one at the same address if there is one.
    fn read(&mut self, index: usize) {
        let nodes = self.netlist.nodes();
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

    /// The instructions in an order that keeps few columns alive: of those whose operands are there,
    /// the one that frees most, or else takes least, comes next.
    fn ordered(&self, outputs: &[(usize, bool)]) -> Vec<Instruction> {
        /// Instructions looked at for the next one: enough for short lives, and few for long programs.
        const WINDOW: usize = 64;
        let operands = |at: usize| {
            let mut of = self.instructions[at].of[..self.instructions[at].operands].to_vec();
            of.sort_unstable();
            of.dedup();
            of
        };
        let mut users: Vec<Vec<usize>> = vec![Vec::new(); self.widths.len()];
        let mut left = vec![0; self.widths.len()];
        let mut maker = vec![None; self.widths.len()];
        for (at, instruction) in self.instructions.iter().enumerate() {
            for column in operands(at) {
                users[column].push(at);
                left[column] += 1;
            }
            maker[instruction.to.slot] = Some(at);
            if let Action::ReadPair { second, .. } = instruction.action {
                maker[second] = Some(at);
            }
        }
        // Outputs are never free.
        for (column, _) in outputs {
            left[*column] += 1;
        }
        let mut missing: Vec<usize> = (0..self.instructions.len())
            .map(|at| operands(at).into_iter().filter(|column| maker[*column].is_some()).count())
            .collect();
        let mut ready: BTreeSet<usize> =
            (0..missing.len()).filter(|at| missing[*at] == 0).collect();
        let mut order = Vec::with_capacity(missing.len());
        let bits = |column: usize| i64::from(self.widths[column].bits());
        while !ready.is_empty() {
            let gain = |at: &usize| {
                let freed = operands(*at).into_iter().filter(|column| {
                    // Ports and constants keep their columns.
                    left[*column] == 1 && maker[*column].is_some()
                });
                let freed: i64 = freed.map(bits).sum();
                let instruction = &self.instructions[*at];
                let pair = matches!(instruction.action, Action::ReadPair { .. });
                freed - bits(instruction.to.slot) * if pair { 2 } else { 1 }
            };
            let candidates = ready.iter().take(WINDOW);
            let best = candidates.max_by_key(|at| (gain(at), Reverse(**at)));
            let at = *best.expect("bug: something is ready");
            ready.remove(&at);
            let instruction = self.instructions[at];
            for column in operands(at) {
                left[column] -= 1;
            }
            let mut made = vec![instruction.to.slot];
            if let Action::ReadPair { second, .. } = instruction.action {
                made.push(second);
            }
            for user in made.into_iter().flat_map(|column| &users[column]) {
                missing[*user] -= 1;
                if missing[*user] == 0 {
                    ready.insert(*user);
                }
            }
            order.push(instruction);
        }
        assert_eq!(order.len(), self.instructions.len(), "bug: an instruction waits for itself");
        order
    }

    /// Gives columns to nodes; those whose users are all done go to later ones. Constants, which
    /// are filled once, and ports, which are filled before the first instruction, keep theirs.
    fn finish(mut self, outputs: &[(usize, bool)]) -> Program {
        self.instructions = self.ordered(outputs);
        // What repeats comes first, in the order that it has; nothing does where no port repeats,
        // not even what has only constants: the last block may be short, and overflows are counted.
        let mut repeats = vec![self.program.repeats.contains(&true); self.widths.len()];
        for (input, port) in self.program.inputs.iter().zip(&self.program.repeats) {
            if let Some(input) = input {
                repeats[input.slot] = *port;
            }
        }
        let (mut first, mut rest) = (Vec::new(), Vec::new());
        for instruction in take(&mut self.instructions) {
            let all = instruction.of[..instruction.operands].iter().all(|column| repeats[*column]);
            repeats[instruction.to.slot] = all;
            if let Action::ReadPair { second, .. } = instruction.action {
                repeats[second] = all;
            }
            if all { first.push(instruction) } else { rest.push(instruction) }
        }
        self.program.repeated = first.len();
        first.append(&mut rest);
        self.instructions = first;
        let mut last_use = vec![0; self.widths.len()];
        for (at, instruction) in self.instructions.iter().enumerate() {
            for column in &instruction.of[..instruction.operands] {
                // What repeats is kept for the next block's instructions.
                let kept = repeats[*column] && at >= self.program.repeated;
                last_use[*column] = if kept { usize::MAX } else { at };
            }
        }
        let mut slots = vec![usize::MAX; self.widths.len()];
        let mut count = [0; 3];
        let mut fresh = |width: Width| {
            count[slot_of(width)] += 1;
            count[slot_of(width)] - 1
        };
        let mut kept: Vec<usize> = outputs.iter().map(|(column, _)| *column).collect();
        for input in self.program.inputs.iter_mut().flatten() {
            kept.push(input.slot);
            slots[input.slot] = fresh(input.width);
            input.slot = slots[input.slot];
        }
        let mut constants: Vec<((i64, Width), usize)> = self.constants.into_iter().collect();
        constants.sort_unstable_by_key(|(_, column)| *column);
        for ((raw, width), column) in constants {
            kept.push(column);
            slots[column] = fresh(width);
            self.program.constants.push((Column { width, slot: slots[column] }, raw));
        }
        for column in kept {
            last_use[column] = usize::MAX;
        }
        let mut free: [Vec<usize>; 3] = Default::default();
        for (at, mut instruction) in self.instructions.into_iter().enumerate() {
            let width = instruction.to.width;
            let mut give = |column: usize| {
                if slots[column] == usize::MAX {
                    slots[column] = free[slot_of(width)].pop().unwrap_or_else(|| fresh(width));
                }
                slots[column]
            };
            let to = instruction.to.slot;
            instruction.to.slot = give(to);
            let mut made = vec![to];
            if let Action::ReadPair { second, .. } = &mut instruction.action {
                made.push(*second);
                *second = give(*second);
            }
            let mut done: Vec<usize> = instruction.of[..instruction.operands].to_vec();
            for column in &mut instruction.of[..instruction.operands] {
                *column = slots[*column];
            }
            done.sort_unstable();
            done.dedup();
            done.retain(|column| last_use[*column] == at);
            // What nobody reads is free at once.
            made.retain(|column| last_use[*column] <= at);
            for column in done.into_iter().chain(made) {
                free[slot_of(self.widths[column])].push(slots[column]);
            }
            self.program.instructions.push(instruction);
        }
        self.program.outputs = outputs
            .iter()
            .map(|(column, zero)| {
                (Column { width: self.widths[*column], slot: slots[*column] }, *zero)
            })
            .collect();
        self.program.slots = count;
        self.program
    }
}

/// Number of a table, or of a pair, among those packed.
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

/// A block's lanes, from the start of a cache line: a vector across two lines costs two accesses.
#[derive(Debug)]
#[repr(align(64))]
struct Lanes<L>([L; BLOCK]);

/// Columns of one width; one that is written is taken out meanwhile.
type Columns<L> = Vec<Option<Box<Lanes<L>>>>;

fn columns<L: Lane>(count: usize) -> Columns<L> {
    (0..count).map(|_| Some(Box::new(Lanes([L::zero(); BLOCK])))).collect()
}

#[inline(always)]
fn take_column<L: Stored>(store: &mut Store, slot: usize) -> Box<Lanes<L>> {
    L::columns(store)[slot].take().expect("bug: written twice at once")
}

/// Columns of a runner.
#[derive(Debug)]
struct Store {
    features: Features,
    lanes16: Columns<i16>,
    lanes32: Columns<i32>,
    lanes64: Columns<i64>,
}

/// Lanes whose columns a [`Store`] has.
trait Stored: Lane {
    fn columns(store: &mut Store) -> &mut Columns<Self>;
    fn tables(program: &Program) -> &Tables<Self>;
}

impl Stored for i16 {
    #[inline(always)]
    fn columns(store: &mut Store) -> &mut Columns<Self> {
        &mut store.lanes16
    }
    #[inline(always)]
    fn tables(program: &Program) -> &Tables<Self> {
        &program.tables16
    }
}

impl Stored for i32 {
    #[inline(always)]
    fn columns(store: &mut Store) -> &mut Columns<Self> {
        &mut store.lanes32
    }
    #[inline(always)]
    fn tables(program: &Program) -> &Tables<Self> {
        &program.tables32
    }
}

impl Stored for i64 {
    #[inline(always)]
    fn columns(store: &mut Store) -> &mut Columns<Self> {
        &mut store.lanes64
    }
    #[inline(always)]
    fn tables(program: &Program) -> &Tables<Self> {
        &program.tables64
    }
}

/// Columns for one thread.
#[derive(Debug)]
pub struct Runner {
    store: Store,
    /// Of each `narrow`, and at least one.
    overflows: Vec<u64>,
    /// Those of one block, of instructions that are run once for all blocks.
    repeated: Vec<u64>,
    narrows: usize,
}

impl Runner {
    /// Simulates as many samples as the input columns hold; `outputs` are overwritten.
    ///
    /// # Panics
    /// If the columns don't match the program's ports or differ in length.
    pub fn run(&mut self, program: &Program, inputs: &[&[i64]], outputs: &mut [Vec<i64>]) {
        self.run_words(program, inputs, outputs);
    }

    /// As [`Runner::run`] on columns of any [`Word`]s that hold those of all ports: narrow ones
    /// save time.
    ///
    /// # Panics
    /// If the columns don't match the program's ports or differ in length.
    pub fn run_words<I: Word, O: Word>(
        &mut self,
        program: &Program,
        inputs: &[&[I]],
        outputs: &mut [Vec<O>],
    ) {
        assert_eq!(inputs.len(), program.inputs.len(), "bug: one column per input");
        assert_eq!(outputs.len(), program.outputs.len(), "bug: one column per output");
        let count = inputs.first().map_or(0, |column| column.len());
        assert!(inputs.iter().all(|column| column.len() == count), "bug: columns differ in length");
        for column in outputs.iter_mut() {
            column.resize(count, O::default());
        }
        let some_repeats = program.repeats.contains(&true);
        assert!(
            !some_repeats || count <= BLOCK || count.is_multiple_of(BLOCK),
            "bug: blocks repeat words, and the last is short"
        );
        let Self { store, overflows, repeated, .. } = self;
        let features = store.features;
        let mut start = 0;
        while start < count {
            let len = BLOCK.min(count - start);
            let again = start > 0;
            vectorised_for(features, Load { program, store, inputs, again, start, len });
            if again {
                // What isn't computed again would overflow again.
                overflows.iter_mut().zip(&*repeated).for_each(|(count, more)| *count += more);
            } else if program.repeated > 0 {
                repeated.copy_from_slice(overflows);
                run_block(program, store, 0..program.repeated, len, overflows);
                repeated.iter_mut().zip(&*overflows).for_each(|(more, now)| *more = now - *more);
            }
            let next = start + len..count.min(start + len + BLOCK);
            for ((input, port), repeats) in inputs.iter().zip(&program.inputs).zip(&program.repeats)
            {
                if port.is_some() && !repeats {
                    prefetch(&input[next.clone()]);
                }
            }
            let rest = program.repeated..program.instructions.len();
            run_block(program, store, rest, len, overflows);
            vectorised_for(features, Unload { program, store, outputs, start, len });
            start += len;
        }
    }

    /// How often each `narrow` overflowed so far, in the order of [`Program::narrows`].
    #[must_use]
    pub fn overflows(&self) -> &[u64] {
        &self.overflows[..self.narrows]
    }

    /// An error if a `narrow` under [`Overflow::Error`] overflowed.
    ///
    /// # Errors
    /// Names the node.
    pub fn check(&self, program: &Program, netlist: &Netlist) -> Result<()> {
        check_overflows(netlist, program.narrows(), self.overflows())
    }
}

/// An error if a `narrow` under [`Overflow::Error`] has a count above 0.
///
/// # Errors
/// Names the node.
pub fn check_overflows(netlist: &Netlist, narrows: &[NodeId], counts: &[u64]) -> Result<()> {
    for (id, count) in narrows.iter().zip(counts) {
        let forbidden = netlist.node(*id).op.overflow() == Some(Overflow::Error);
        if forbidden && *count > 0 {
            return Err(Error::node_overflow(netlist.label(*id), *count));
        }
    }
    Ok(())
}

/// A block of the callers' columns into those of the ports.
struct Load<'a, 'b, I> {
    program: &'a Program,
    store: &'a mut Store,
    inputs: &'a [&'b [I]],
    /// Not what repeats: it is there.
    again: bool,
    start: usize,
    len: usize,
}

impl<I: Word> Body for Load<'_, '_, I> {
    #[inline(always)]
    fn run(self) {
        let Self { program, store, inputs, again, start, len } = self;
        for ((column, input), repeats) in program.inputs.iter().zip(inputs).zip(&program.repeats) {
            let Some(Column { width, slot }) = *column else { continue };
            if again && *repeats {
                continue;
            }
            let input = &input[start..start + len];
            match width {
                Width::W16 => load(input, &mut store.lanes16[slot]),
                Width::W32 => load(input, &mut store.lanes32[slot]),
                Width::W64 => load(input, &mut store.lanes64[slot]),
            }
        }
    }
}

fn fill<L: Lane>(to: &mut Option<Box<Lanes<L>>>, raw: i64) {
    to.as_mut().expect("bug: no column is taken out").0.fill(L::of(raw));
}

#[inline(always)]
fn load<I: Word, L: Lane>(from: &[I], to: &mut Option<Box<Lanes<L>>>) {
    let to = to.as_mut().expect("bug: no column is taken out");
    for (to, word) in to.0.iter_mut().zip(from) {
        *to = L::of(word.word());
    }
}

/// Columns of the outputs into the callers'.
struct Unload<'a, O> {
    program: &'a Program,
    store: &'a Store,
    outputs: &'a mut [Vec<O>],
    start: usize,
    len: usize,
}

impl<O: Word> Body for Unload<'_, O> {
    #[inline(always)]
    fn run(self) {
        let Self { program, store, outputs, start, len } = self;
        for ((Column { width, slot }, zero), output) in program.outputs.iter().zip(outputs) {
            let (output, slot) = (&mut output[start..start + len], *slot);
            match width {
                Width::W16 => unload(*zero, &store.lanes16[slot], output),
                Width::W32 => unload(*zero, &store.lanes32[slot], output),
                Width::W64 => unload(*zero, &store.lanes64[slot], output),
            }
        }
    }
}

#[inline(always)]
fn unload<O: Word, L: Lane>(zero: bool, from: &Option<Box<Lanes<L>>>, to: &mut [O]) {
    let from = from.as_ref().expect("bug: no column is taken out");
    let pairs = to.iter_mut().zip(&from.0);
    if zero {
        pairs.for_each(|(to, lane)| *to = O::of_word(lane.raw_of_pattern()));
    } else {
        pairs.for_each(|(to, lane)| *to = O::of_word(lane.raw()));
    }
}

/// Not inlined: it is large, and the same for all columns of callers.
#[inline(never)]
fn run_block(
    program: &Program,
    store: &mut Store,
    instructions: Range<usize>,
    len: usize,
    overflows: &mut [u64],
) {
    let instructions = &program.instructions[instructions];
    vectorised_for(store.features, Run { program, instructions, store, len, overflows });
}

/// The instructions over one block, to be compiled for the processor.
struct Run<'a> {
    program: &'a Program,
    instructions: &'a [Instruction],
    store: &'a mut Store,
    len: usize,
    overflows: &'a mut [u64],
}

impl Body for Run<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { program, instructions, store, len, overflows } = self;
        for instruction in instructions {
            match instruction.width {
                Width::W16 => step::<i16>(program, instruction, store, len, overflows),
                Width::W32 => step::<i32>(program, instruction, store, len, overflows),
                Width::W64 => step::<i64>(program, instruction, store, len, overflows),
            }
        }
    }
}

#[inline(always)]
fn step<L: Stored>(
    program: &Program,
    instruction: &Instruction,
    store: &mut Store,
    len: usize,
    overflows: &mut [u64],
) {
    let Column { width, slot } = instruction.to;
    match instruction.action {
        Action::Kernel(kernel) if width == L::WIDTH => {
            let mut to = take_column::<L>(store, slot);
            kernels::step(
                kernel,
                operands::<L>(instruction, store, len),
                &mut to.0[..len],
                overflows,
            );
            L::columns(store)[slot] = Some(to);
        }
        Action::Kernel(Kernel::Slice { lo, bits }) => {
            assert!(L::WIDTH == Width::W32 && width == Width::W16, "bug: 32-bit lanes to 16");
            let mut to = take_column::<i16>(store, slot);
            let of = operands::<i32>(instruction, store, len)[0];
            kernels::slice_to_address(lo, bits, of, &mut to.0[..len]);
            store.lanes16[slot] = Some(to);
        }
        Action::Kernel(kernel) => {
            // Of all others, only a `narrow` halves lanes.
            assert!(L::WIDTH == Width::W64 && width == Width::W32, "bug: 64-bit lanes to 32");
            let mut to = take_column::<i32>(store, slot);
            let of = operands::<i64>(instruction, store, len);
            kernels::fitted::<i64, i32>(kernel, of, &mut to.0[..len], overflows);
            store.lanes32[slot] = Some(to);
        }
        Action::WideProduct(fit) if width == Width::W64 => {
            let mut to = take_column::<i64>(store, slot);
            let of = operands::<i32>(instruction, store, len);
            kernels::wide_product(fit, of, &mut to.0[..len], overflows);
            store.lanes64[slot] = Some(to);
        }
        Action::WideProduct(fit) => {
            let mut to = take_column::<i32>(store, slot);
            let of = operands::<i32>(instruction, store, len);
            kernels::wide_product(fit, of, &mut to.0[..len], overflows);
            store.lanes32[slot] = Some(to);
        }
        Action::Convert { zero } => match width {
            Width::W16 => convert::<L, i16>(zero, instruction, store, len),
            Width::W32 => convert::<L, i32>(zero, instruction, store, len),
            Width::W64 => convert::<L, i64>(zero, instruction, store, len),
        },
        Action::Read { .. } | Action::ReadPair { .. } => {
            read_pass(program, instruction, store, len)
        }
    }
}

/// A pass of table reads: never wider than AVX2, as a compiler with AVX-512 turns it into gathers.
#[inline(never)]
fn read_pass(program: &Program, instruction: &Instruction, store: &mut Store, len: usize) {
    let features = store.features.min(Features::Avx2);
    vectorised_for(features, ReadPass { program, instruction, store, len });
}

struct ReadPass<'a> {
    program: &'a Program,
    instruction: &'a Instruction,
    store: &'a mut Store,
    len: usize,
}

impl Body for ReadPass<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { program, instruction, store, len } = self;
        match instruction.width {
            Width::W16 => read_as::<i16>(program, instruction, store, len),
            Width::W32 => read_as::<i32>(program, instruction, store, len),
            Width::W64 => read_as::<i64>(program, instruction, store, len),
        }
    }
}

#[inline(always)]
fn read_as<A: Stored>(program: &Program, instruction: &Instruction, store: &mut Store, len: usize) {
    match instruction.to.width {
        Width::W16 => read::<A, i16>(program, instruction, store, len),
        Width::W32 => read::<A, i32>(program, instruction, store, len),
        Width::W64 => read::<A, i64>(program, instruction, store, len),
    }
}

#[inline(always)]
fn operands<'a, L: Stored>(
    instruction: &Instruction,
    store: &'a mut Store,
    len: usize,
) -> [&'a [L]; 3] {
    let columns: &'a Columns<L> = L::columns(store);
    let column = |slot: usize| match columns.get(slot) {
        Some(Some(column)) => &column.0[..len],
        Some(None) | None => &[],
    };
    let [a, b, c] = instruction.of;
    [column(a), column(b), column(c)]
}

#[inline(always)]
fn convert<From: Stored, To: Stored>(
    zero: bool,
    instruction: &Instruction,
    store: &mut Store,
    len: usize,
) {
    let slot = instruction.to.slot;
    let mut to = take_column::<To>(store, slot);
    kernels::convert(zero, operands::<From>(instruction, store, len)[0], &mut to.0[..len]);
    To::columns(store)[slot] = Some(to);
}

#[inline(always)]
fn read<A: Stored, L: Stored>(
    program: &Program,
    instruction: &Instruction,
    store: &mut Store,
    len: usize,
) {
    let slot = instruction.to.slot;
    let mut to = take_column::<L>(store, slot);
    match instruction.action {
        Action::ReadPair { table, second } => {
            let words = &L::tables(program).pairs[table];
            let mut other = take_column::<L>(store, second);
            let addresses = operands::<A>(instruction, store, len)[0];
            kernels::read_pair(words, addresses, [&mut to.0[..len], &mut other.0[..len]]);
            L::columns(store)[second] = Some(other);
        }
        Action::Read { table } => {
            let words = &L::tables(program).single[table];
            kernels::read(words, operands::<A>(instruction, store, len)[0], &mut to.0[..len]);
        }
        Action::Kernel(_) | Action::WideProduct(_) | Action::Convert { .. } => {
            unreachable!("bug: a read")
        }
    }
    L::columns(store)[slot] = Some(to);
}
