//! Bit-true simulation of many samples: the netlist as a program over columns.
//!
//! [`Program::compile`] turns each node into one instruction over a column of words, and gives
//! columns to nodes whose users are all done to later nodes, so that a block's columns stay in
//! the first-level cache. A [`Runner`] holds the columns and takes any number of samples, block
//! by block, without allocation; nothing is dispatched per sample. Lanes are `i32` where every
//! word fits, else `i64`. The loops are plain Rust that the compiler vectorises, for the baseline
//! processor and for AVX2.
//!
//! [`super::real`] does the same on reals, for the algorithm's value at every node.

use super::columns::Columns;
use crate::cast;
use crate::error::{Error, Result};
use crate::format::{Format, Overflow, Round, narrow, word_mask};
use crate::netlist::{Netlist, NodeId};
use crate::op::Op;
use crate::simd::{Body, vectorised};
use num_traits::{
    PrimInt, WrappingAdd, WrappingMul, WrappingNeg, WrappingShl, WrappingShr, WrappingSub,
};
use std::sync::Arc;

/// Samples per block: two kilobytes a column in 32-bit lanes.
pub const BLOCK: usize = 512;

/// An integer that columns hold.
trait Lane:
    PrimInt
    + WrappingAdd
    + WrappingSub
    + WrappingMul
    + WrappingNeg
    + WrappingShl
    + WrappingShr
    + Default
    + Send
    + Sync
{
    /// Bits of the lane.
    const BITS: u32;
    /// The word, which must fit.
    fn of(raw: i64) -> Self;
    /// The word.
    fn raw(self) -> i64;
    /// The word, known not to be negative, as an index.
    fn index(self) -> usize;
    /// 1 if set.
    fn flag(set: bool) -> Self;
}

impl Lane for i32 {
    const BITS: u32 = 32;
    #[inline(always)]
    fn of(raw: i64) -> Self {
        cast::low_i32(raw)
    }
    #[inline(always)]
    fn raw(self) -> i64 {
        i64::from(self)
    }
    #[inline(always)]
    fn index(self) -> usize {
        cast::index_of_i32(self)
    }
    #[inline(always)]
    fn flag(set: bool) -> Self {
        Self::from(set)
    }
}

impl Lane for i64 {
    const BITS: u32 = 64;
    #[inline(always)]
    fn of(raw: i64) -> Self {
        raw
    }
    #[inline(always)]
    fn raw(self) -> i64 {
        self
    }
    #[inline(always)]
    fn index(self) -> usize {
        cast::index_of(self)
    }
    #[inline(always)]
    fn flag(set: bool) -> Self {
        Self::from(set)
    }
}

/// A column number.
type Slot = usize;

/// One instruction; shifts align operands to the result's fraction bits.
#[derive(Clone, Copy, Debug)]
enum Kernel {
    Copy,
    Add { shifts: [u32; 2] },
    Sub { shifts: [u32; 2] },
    AddSub { shifts: [u32; 2] },
    Mul,
    Neg,
    Abs,
    And,
    Or,
    Xor,
    Equal { shifts: [u32; 2] },
    Less { shifts: [u32; 2] },
    Mux { shifts: [u32; 2] },
    Slice { lo: u32, bits: u32 },
    Concat { low_bits: u32 },
    LeadingZeros { bits: u32 },
    ShiftLeft { max: u32 },
    Read { words: usize },
    Wrap { to: Format },
    Narrow(Narrow),
}

#[derive(Clone, Copy, Debug)]
struct Narrow {
    from_frac: i32,
    to: Format,
    round: Round,
    overflow: Overflow,
    /// False if no word of the operand's format can overflow.
    can_overflow: bool,
    /// Counter that it feeds.
    counter: usize,
}

#[derive(Clone, Copy, Debug)]
struct Instruction {
    kernel: Kernel,
    of: [Slot; 3],
    to: Slot,
}

/// A netlist compiled for blocks of samples.
#[derive(Clone, Debug)]
pub struct Program {
    instructions: Vec<Instruction>,
    constants: Vec<(Slot, i64)>,
    /// Words of the columns read.
    tables: Vec<Arc<[i64]>>,
    /// The same in narrow lanes, if those are used; runners share them.
    narrow_tables: Vec<Arc<[i32]>>,
    slots: usize,
    inputs: Vec<Slot>,
    outputs: Vec<Slot>,
    /// The `narrow` nodes, in the order of the counters.
    narrows: Vec<NodeId>,
    wide: bool,
}

impl Program {
    /// Compiles a netlist; the nodes of `outputs` are what a run gives.
    ///
    /// # Panics
    /// If the netlist has an operation without a kernel: that is wrong code.
    #[must_use]
    pub fn compile(netlist: &Netlist, outputs: &[NodeId]) -> Self {
        let nodes = netlist.nodes();
        let operands: Vec<Option<Vec<usize>>> = nodes
            .iter()
            .map(|node| Some(node.operands.iter().map(|id| id.index()).collect()))
            .collect();
        let columns = Columns::new(netlist, &operands, outputs);
        let mut program = Self {
            instructions: Vec::new(),
            constants: Vec::new(),
            tables: Vec::new(),
            narrow_tables: Vec::new(),
            slots: columns.count,
            inputs: Vec::new(),
            outputs: outputs.iter().map(|id| columns.of(id.index())).collect(),
            narrows: Vec::new(),
            wide: nodes.iter().enumerate().any(|(i, _)| !fits_i32(netlist, i)),
        };
        for (index, (node, operands)) in nodes.iter().zip(&operands).enumerate() {
            let to = columns.of(index);
            if node.op == Op::Input {
                program.inputs.push(to);
            } else if let Op::Const { raw } = node.op {
                program.constants.push((to, raw));
            } else {
                let kernel = program.kernel(netlist, index);
                let of = columns.operands(operands.as_deref().unwrap_or_default());
                program.instructions.push(Instruction { kernel, of, to });
            }
        }
        if !program.wide {
            let narrow = |words: &Arc<[i64]>| words.iter().map(|word| i32::of(*word)).collect();
            program.narrow_tables = program.tables.iter().map(narrow).collect();
        }
        program
    }

    fn kernel(&mut self, netlist: &Netlist, index: usize) -> Kernel {
        let node = &netlist.nodes()[index];
        let format_of = |i: usize| netlist.node(node.operands[i]).format;
        let shifts = |a: usize, b: usize| {
            let (a, b) = (format_of(a).frac_bits(), format_of(b).frac_bits());
            [a.max(b).abs_diff(a), a.max(b).abs_diff(b)]
        };
        match node.op {
            Op::Input | Op::Const { .. } => panic!("bug: ports and constants have no kernel"),
            Op::Add => Kernel::Add { shifts: shifts(0, 1) },
            Op::Sub => Kernel::Sub { shifts: shifts(0, 1) },
            Op::AddSub => Kernel::AddSub { shifts: shifts(1, 2) },
            Op::Mul => Kernel::Mul,
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
            Op::Shift { .. } => Kernel::Copy,
            Op::LeadingZeros => Kernel::LeadingZeros { bits: format_of(0).bits() },
            Op::ShiftLeft { max } => Kernel::ShiftLeft { max },
            Op::Read { table, column } => {
                let column = usize::try_from(column).expect("bug: small");
                let words = &netlist.tables()[table.index()].columns[column].words;
                let known = self.tables.iter().position(|known| Arc::ptr_eq(known, words));
                let words = known.unwrap_or_else(|| {
                    self.tables.push(Arc::clone(words));
                    self.tables.len() - 1
                });
                Kernel::Read { words }
            }
            Op::Modulo => Kernel::Wrap { to: node.format },
            Op::Narrow { round, overflow } => {
                self.narrows.push(netlist.id_at(index));
                let from = format_of(0);
                let overflows = |raw| narrow(raw, from.frac_bits(), node.format, round, overflow).1;
                Kernel::Narrow(Narrow {
                    from_frac: from.frac_bits(),
                    to: node.format,
                    round,
                    overflow,
                    // Rounding is monotone, so the ends of the format decide.
                    can_overflow: overflows(from.min_raw()) || overflows(from.max_raw()),
                    counter: self.narrows.len() - 1,
                })
            }
        }
    }

    /// The `narrow` nodes, in the order of [`Runner::overflows`].
    #[must_use]
    pub fn narrows(&self) -> &[NodeId] {
        &self.narrows
    }

    /// Makes a runner with columns of its own.
    #[must_use]
    pub fn runner(&self) -> Runner {
        Runner {
            columns: if self.wide {
                Lanes::Wide(Store::new(self, self.tables.clone()))
            } else {
                Lanes::Narrow(Store::new(self, self.narrow_tables.clone()))
            },
            overflows: vec![0; self.narrows.len()],
        }
    }
}

/// True if the node's words, and its operands' words when they are aligned, fit 32-bit lanes.
fn fits_i32(netlist: &Netlist, index: usize) -> bool {
    let node = &netlist.nodes()[index];
    let fits = |format: Format| format.bits() + u32::from(!format.is_signed()) <= 32;
    let compares = matches!(node.op, Op::Equal | Op::Less);
    let aligned = !compares || {
        let [a, b] = [0, 1].map(|i| netlist.node(node.operands[i]).format);
        let frac = a.frac_bits().max(b.frac_bits());
        [a, b].into_iter().all(|f| f.bits() + frac.abs_diff(f.frac_bits()) < 32)
    };
    aligned && fits(node.format)
}

#[derive(Debug)]
struct Store<L> {
    columns: Vec<Vec<L>>,
    tables: Vec<Arc<[L]>>,
}

impl<L: Lane> Store<L> {
    fn new(program: &Program, tables: Vec<Arc<[L]>>) -> Self {
        let mut columns = vec![vec![L::default(); BLOCK]; program.slots];
        for (slot, raw) in &program.constants {
            columns[*slot].fill(L::of(*raw));
        }
        Self { columns, tables }
    }
}

#[derive(Debug)]
enum Lanes {
    Narrow(Store<i32>),
    Wide(Store<i64>),
}

/// Columns for one thread.
#[derive(Debug)]
pub struct Runner {
    columns: Lanes,
    overflows: Vec<u64>,
}

impl Runner {
    /// Simulates as many samples as the input columns hold; `outputs` are overwritten.
    ///
    /// # Panics
    /// If the columns don't match the program's ports or differ in length.
    pub fn run(&mut self, program: &Program, inputs: &[&[i64]], outputs: &mut [Vec<i64>]) {
        assert_eq!(inputs.len(), program.inputs.len(), "bug: one column per input");
        assert_eq!(outputs.len(), program.outputs.len(), "bug: one column per output");
        let count = inputs.first().map_or(0, |column| column.len());
        assert!(inputs.iter().all(|column| column.len() == count), "bug: columns differ in length");
        for column in outputs.iter_mut() {
            column.resize(count, 0);
        }
        let overflows = &mut self.overflows[..];
        match &mut self.columns {
            Lanes::Narrow(store) => vectorised(Run { program, store, inputs, outputs, overflows }),
            Lanes::Wide(store) => vectorised(Run { program, store, inputs, outputs, overflows }),
        }
    }

    /// How often each `narrow` overflowed so far, in the order of [`Program::narrows`].
    #[must_use]
    pub fn overflows(&self) -> &[u64] {
        &self.overflows
    }

    /// An error if a `narrow` under [`Overflow::Error`] overflowed.
    ///
    /// # Errors
    /// Names the node.
    pub fn check(&self, program: &Program, netlist: &Netlist) -> Result<()> {
        check_overflows(netlist, program.narrows(), &self.overflows)
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

/// A run over all blocks, to be compiled for the processor.
struct Run<'a, 'b, L> {
    program: &'a Program,
    store: &'a mut Store<L>,
    inputs: &'a [&'b [i64]],
    outputs: &'a mut [Vec<i64>],
    overflows: &'a mut [u64],
}

impl<L: Lane> Body for Run<'_, '_, L> {
    #[inline(always)]
    fn run(self) {
        run_blocks(self.program, self.store, self.inputs, self.outputs, self.overflows);
    }
}

#[inline(always)]
fn run_blocks<L: Lane>(
    program: &Program,
    store: &mut Store<L>,
    inputs: &[&[i64]],
    outputs: &mut [Vec<i64>],
    overflows: &mut [u64],
) {
    let count = inputs.first().map_or(0, |column| column.len());
    let Store { columns, tables } = store;
    let mut start = 0;
    while start < count {
        let len = BLOCK.min(count - start);
        for (slot, input) in program.inputs.iter().zip(inputs) {
            let column = &mut columns[*slot][..len];
            for (lane, word) in column.iter_mut().zip(&input[start..start + len]) {
                *lane = L::of(*word);
            }
        }
        for instruction in &program.instructions {
            let mut to = std::mem::take(&mut columns[instruction.to]);
            step(instruction, columns, tables, &mut to[..len], overflows);
            columns[instruction.to] = to;
        }
        for (slot, output) in program.outputs.iter().zip(outputs.iter_mut()) {
            for (word, lane) in output[start..start + len].iter_mut().zip(&columns[*slot][..len]) {
                *word = lane.raw();
            }
        }
        start += len;
    }
}

#[inline(always)]
fn step<L: Lane>(
    instruction: &Instruction,
    columns: &[Vec<L>],
    tables: &[Arc<[L]>],
    to: &mut [L],
    overflows: &mut [u64],
) {
    let len = to.len();
    let [a, b, c] = instruction.of.map(|slot| columns[slot].get(..len).unwrap_or_default());
    let zero = L::zero();
    match instruction.kernel {
        Kernel::Copy => to.copy_from_slice(a),
        Kernel::Add { shifts: [0, 0] } => map2(to, a, b, |a, b| a.wrapping_add(&b)),
        Kernel::Add { shifts: [sa, sb] } => {
            map2(to, a, b, |a, b| a.wrapping_shl(sa).wrapping_add(&b.wrapping_shl(sb)));
        }
        Kernel::Sub { shifts: [0, 0] } => map2(to, a, b, |a, b| a.wrapping_sub(&b)),
        Kernel::Sub { shifts: [sa, sb] } => {
            map2(to, a, b, |a, b| a.wrapping_shl(sa).wrapping_sub(&b.wrapping_shl(sb)));
        }
        Kernel::AddSub { shifts: [sa, sb] } => map3(to, a, b, c, |flag, a, b| {
            // With the mask all ones, (b ^ mask) - mask is -b.
            let mask = flag.wrapping_neg();
            let b = (b.wrapping_shl(sb) ^ mask).wrapping_sub(&mask);
            a.wrapping_shl(sa).wrapping_add(&b)
        }),
        Kernel::Mul => map2(to, a, b, |a, b| a.wrapping_mul(&b)),
        Kernel::Neg => map1(to, a, |a| a.wrapping_neg()),
        Kernel::Abs => map1(to, a, |a| if a < zero { a.wrapping_neg() } else { a }),
        Kernel::And => map2(to, a, b, |a, b| a & b),
        Kernel::Or => map2(to, a, b, |a, b| a | b),
        Kernel::Xor => map2(to, a, b, |a, b| a ^ b),
        Kernel::Equal { shifts: [sa, sb] } => {
            map2(to, a, b, |a, b| L::flag(a.wrapping_shl(sa) == b.wrapping_shl(sb)));
        }
        Kernel::Less { shifts: [sa, sb] } => {
            map2(to, a, b, |a, b| L::flag(a.wrapping_shl(sa) < b.wrapping_shl(sb)));
        }
        Kernel::Mux { shifts: [sa, sb] } => {
            map3(
                to,
                a,
                b,
                c,
                |flag, a, b| {
                    if flag == zero { b.wrapping_shl(sb) } else { a.wrapping_shl(sa) }
                },
            )
        }
        Kernel::Slice { lo, bits } => {
            let mask = L::of(word_mask(bits));
            map1(to, a, |a| a.wrapping_shr(lo) & mask);
        }
        Kernel::Concat { low_bits } => map2(to, a, b, |a, b| a.wrapping_shl(low_bits) | b),
        Kernel::LeadingZeros { bits } => {
            map1(to, a, |a| L::of(i64::from(a.leading_zeros().wrapping_sub(L::BITS - bits))))
        }
        Kernel::ShiftLeft { max } => map2(to, a, b, |a, n| {
            let places = n.raw().min(i64::from(max));
            a.wrapping_shl(u32::try_from(places).unwrap_or_default())
        }),
        Kernel::Read { words } => {
            // Addresses have as many bits as the table has; the mask tells the compiler so.
            let words = &tables[words][..];
            let mask = words.len() - 1;
            debug_assert!(words.len().is_power_of_two(), "bug: table of {} rows", words.len());
            map1(to, a, |address| words[address.index() & mask]);
        }
        Kernel::Wrap { to: format } => {
            let wrap = Wrap::new::<L>(format);
            map1(to, a, |a| wrap.apply(a));
        }
        Kernel::Narrow(narrow) => overflows[narrow.counter] += narrow_column(narrow, a, to),
    }
}

#[inline(always)]
fn map1<L: Lane>(to: &mut [L], a: &[L], f: impl Fn(L) -> L) {
    for (to, a) in to.iter_mut().zip(a) {
        *to = f(*a);
    }
}

#[inline(always)]
fn map2<L: Lane>(to: &mut [L], a: &[L], b: &[L], f: impl Fn(L, L) -> L) {
    for ((to, a), b) in to.iter_mut().zip(a).zip(b) {
        *to = f(*a, *b);
    }
}

#[inline(always)]
fn map3<L: Lane>(to: &mut [L], a: &[L], b: &[L], c: &[L], f: impl Fn(L, L, L) -> L) {
    for (((to, a), b), c) in to.iter_mut().zip(a).zip(b).zip(c) {
        *to = f(*a, *b, *c);
    }
}

/// Keeps the low bits of a word: up against the top of the lane and back, with or without sign.
#[derive(Clone, Copy)]
struct Wrap {
    places: u32,
    signed: bool,
    bits: u32,
}

impl Wrap {
    #[inline(always)]
    fn new<L: Lane>(format: Format) -> Self {
        Self { places: L::BITS - format.bits(), signed: format.is_signed(), bits: format.bits() }
    }

    #[inline(always)]
    fn apply<L: Lane>(self, a: L) -> L {
        if self.signed {
            a.wrapping_shl(self.places).wrapping_shr(self.places)
        } else {
            a & L::of(word_mask(self.bits))
        }
    }
}

/// The twin of [`narrow`] on a column; returns how many words overflowed.
#[inline(always)]
fn narrow_column<L: Lane>(n: Narrow, from: &[L], to: &mut [L]) -> u64 {
    let dropped = n.from_frac - n.to.frac_bits();
    let shift = dropped.unsigned_abs();
    if shift + 2 > L::BITS {
        return narrow_slowly(n, from, to);
    }
    if dropped <= 0 {
        // More fraction bits: what overflows is seen before the shift.
        let hi = n.to.max_raw() >> shift;
        let lo = -(-least(n) >> shift);
        if L::of(lo).raw() != lo || L::of(hi).raw() != hi {
            return narrow_slowly(n, from, to);
        }
        return fit_column(n, from, to, lo, hi, |a| (a, a.wrapping_shl(shift)));
    }
    let (lo, hi) = (least(n), n.to.max_raw());
    if L::of(lo).raw() != lo || L::of(hi).raw() != hi {
        return narrow_slowly(n, from, to);
    }
    let zero = L::zero();
    let half = L::of(1i64 << (shift - 1));
    let mask = L::of(word_mask(shift));
    let twice = |q: L| (q, q);
    match n.round {
        Round::Floor => fit_column(n, from, to, lo, hi, |a| twice(a.wrapping_shr(shift))),
        Round::TowardZero => fit_column(n, from, to, lo, hi, |a| {
            let up = L::flag(a < zero) & L::flag(a & mask != zero);
            twice(a.wrapping_shr(shift).wrapping_add(&up))
        }),
        Round::HalfUp => fit_column(n, from, to, lo, hi, |a| {
            let up = a.wrapping_shr(shift - 1) & L::one();
            twice(a.wrapping_shr(shift).wrapping_add(&up))
        }),
        Round::HalfAway => fit_column(n, from, to, lo, hi, |a| {
            let rest = a & mask;
            let up = L::flag(rest > half) | (L::flag(rest == half) & L::flag(a >= zero));
            twice(a.wrapping_shr(shift).wrapping_add(&up))
        }),
        Round::HalfEven => fit_column(n, from, to, lo, hi, |a| {
            let (rest, q) = (a & mask, a.wrapping_shr(shift));
            let up = L::flag(rest > half) | (L::flag(rest == half) & q & L::one());
            twice(q.wrapping_add(&up))
        }),
    }
}

/// Least word that doesn't saturate.
fn least(n: Narrow) -> i64 {
    match n.overflow {
        Overflow::Symmetric if n.to.is_signed() => -n.to.max_raw(),
        Overflow::Symmetric | Overflow::Wrap | Overflow::Saturate | Overflow::Error => {
            n.to.min_raw()
        }
    }
}

/// `rounded` gives what is compared with `lo..=hi` and the word if it is inside.
#[inline(always)]
fn fit_column<L: Lane>(
    n: Narrow,
    from: &[L],
    to: &mut [L],
    lo: i64,
    hi: i64,
    rounded: impl Fn(L) -> (L, L),
) -> u64 {
    if !n.can_overflow {
        map1(to, from, |a| rounded(a).1);
        return 0;
    }
    let (lo, hi) = (L::of(lo), L::of(hi));
    let mut overflows = L::zero();
    match n.overflow {
        Overflow::Wrap | Overflow::Error => {
            let wrap = Wrap::new::<L>(n.to);
            for (to, a) in to.iter_mut().zip(from) {
                let (compared, word) = rounded(*a);
                overflows = overflows
                    .wrapping_add(&L::flag(compared < lo))
                    .wrapping_add(&L::flag(compared > hi));
                *to = wrap.apply(word);
            }
        }
        Overflow::Saturate | Overflow::Symmetric => {
            let (least, most) = (L::of(least(n)), L::of(n.to.max_raw()));
            for (to, a) in to.iter_mut().zip(from) {
                let (compared, word) = rounded(*a);
                let (under, over) = (compared < lo, compared > hi);
                overflows = overflows.wrapping_add(&L::flag(under)).wrapping_add(&L::flag(over));
                let word = if under { least } else { word };
                *to = if over { most } else { word };
            }
        }
    }
    overflows.raw().unsigned_abs()
}

/// The reference on each word: for shifts as wide as the lane.
#[inline(never)]
fn narrow_slowly<L: Lane>(n: Narrow, from: &[L], to: &mut [L]) -> u64 {
    let mut overflows = 0;
    for (to, a) in to.iter_mut().zip(from) {
        let (word, overflowed) = narrow(a.raw(), n.from_frac, n.to, n.round, n.overflow);
        *to = L::of(word);
        overflows += u64::from(overflowed);
    }
    overflows
}
