//! Bit-true simulation of many samples: the netlist as a program over columns.
//!
//! [`Program::compile`] turns the netlist into instructions over columns of lanes. A [`Runner`]
//! runs them block by block, without allocation; nothing is dispatched per sample. Each node has a
//! lane of 16, 32 or 64 bits (`sim/lanes.rs`), chosen by the words that can occur and the bits that
//! its users read. Shifts of the binary point, residues and `narrow`s that change no bit need no
//! instruction. A `narrow` runs in the pass of the sum or product before it. Unused nodes are
//! removed, and nodes with only one word are constants.
//!
//! A table read is a separate pass of scalar loads: gathers are slower, and reads inside other
//! loops form a dependency chain. Tables use the narrowest lanes that their words fit. Two tables
//! that are read at one address are stored side by side, so that one address serves both. Columns
//! are reused when all users are done, so that a block's columns and the tables share the
//! first-level cache.
//!
//! Columns start on cache lines, since a vector across two lines costs two accesses. The input
//! columns of the next block are prefetched while one runs.
//!
//! Measured on the rotation unit (`cargo bench --bench engine`), in million samples per second:
//!
//! - lanes of one width, one node per pass: 74 to 105 (reported by `sim`, on 64-bit columns);
//! - typed lanes, sums fused with their `narrow`, and paired reads: 210 to 240;
//! - addresses split in registers, four per load, and short-lived columns: 280 to 320;
//! - columns on cache lines: 8 to 13 % more;
//! - prefetching: 10 to 13 % more if inputs aren't in the cache;
//! - sums of three in one pass: 2 to 4 % of `exact`.
//!
//! Two variants gained nothing: tables with a row for every pattern, which need no mask, and
//! splitting pairs after the reads. The interpreter of passes stays because passes over a block
//! cost about as much as compiled ones: the faster of two hand-written kernels for this one
//! setting, for AVX2 and for AVX-512, takes 0.7 times as long.
//!
//! `sim/kernels.rs` has the loops: plain Rust that the compiler vectorises for each set of
//! processor features in `simd.rs`. [`crate::sim::real`] does the same on reals, for the
//! algorithm's value at every node.

mod compile;
mod order;
mod program;
mod run;
mod step;
mod store;
mod word;

pub use crate::base::simd::Features;
pub use program::{BLOCK, Program};
pub use run::{Runner, check_overflows};
pub use word::Word;
