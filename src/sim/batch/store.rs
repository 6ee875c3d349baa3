//! The columns of a runner.

use super::program::{BLOCK, Program, Tables};
use crate::base::simd::Features;
use crate::sim::kernels::Lane;
use std::collections::VecDeque;

/// A block's lanes, aligned to a cache line: a vector across two lines costs two accesses.
#[derive(Debug)]
#[repr(align(64))]
pub(super) struct Lanes<L>(pub(super) [L; BLOCK]);

/// Columns of one width. A column is taken out while it is written.
pub(super) type Columns<L> = Vec<Option<Box<Lanes<L>>>>;

pub(super) fn columns<L: Lane>(count: usize) -> Columns<L> {
    (0..count).map(|_| Some(Box::new(Lanes([L::zero(); BLOCK])))).collect()
}

#[inline(always)]
pub(super) fn take_column<L: Stored>(store: &mut Store, slot: usize) -> Box<Lanes<L>> {
    L::columns(store)[slot].take().expect("bug: written twice at once")
}

/// Columns of a runner.
#[derive(Debug)]
pub(super) struct Store {
    pub(super) features: Features,
    pub(super) lanes16: Columns<i16>,
    pub(super) lanes32: Columns<i32>,
    pub(super) lanes64: Columns<i64>,
    /// The words in each delay, the oldest first.
    pub(super) delays: Vec<VecDeque<i64>>,
}

/// Lanes with columns in a [`Store`].
pub(super) trait Stored: Lane {
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

pub(super) fn fill<L: Lane>(to: &mut Option<Box<Lanes<L>>>, raw: i64) {
    to.as_mut().expect("bug: no column is taken out").0.fill(L::of(raw));
}
