//! Runs instructions over one block of the columns.

use super::program::{Action, Column, Instruction, Program};
use super::store::{Columns, Store, Stored, take_column};
use crate::base::simd::{Body, Features, vectorised_for};
use crate::sim::kernels::{self, Kernel};
use crate::sim::lanes::Width;
use std::ops::Range;

/// Not inlined: it is large, and the same for all number types of callers' columns.
#[inline(never)]
pub(super) fn run_block(
    program: &Program,
    store: &mut Store,
    instructions: Range<usize>,
    len: usize,
    overflows: &mut [u64],
) {
    let instructions = &program.instructions[instructions];
    vectorised_for(store.features, Run { program, instructions, store, len, overflows });
}

/// The instructions over one block, compiled for the processor's features.
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
            // Of all other kernels, only a `narrow` halves lanes.
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
        Action::Delay { line } => {
            assert!(width == L::WIDTH, "bug: a word and the one before have one lane");
            let mut to = take_column::<L>(store, slot);
            let mut under_way = std::mem::take(&mut store.delays[line]);
            for (to, word) in to.0[..len].iter_mut().zip(operands::<L>(instruction, store, len)[0])
            {
                under_way.push_back(word.raw());
                *to = L::of(under_way.pop_front().unwrap_or_default());
            }
            store.delays[line] = under_way;
            L::columns(store)[slot] = Some(to);
        }
    }
}

/// A pass of table reads. It is limited to AVX2, since with AVX-512 the compiler turns it into
/// gathers.
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
        Action::Kernel(_)
        | Action::WideProduct(_)
        | Action::Convert { .. }
        | Action::Delay { .. } => {
            unreachable!("bug: a read")
        }
    }
    L::columns(store)[slot] = Some(to);
}
