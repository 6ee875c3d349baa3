//! Bit-true simulation of many samples: the netlist as a program over columns.
//!
//! [`Program::compile`] turns the netlist into instructions over columns of lanes, and a [`Runner`]
//! runs them block by block, without allocation; nothing is dispatched per sample. What is asked
//! of each node decides its lane (`sim/lanes.rs`): 16, 32 or 64 bits, by the words that can occur
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
//! `sim/kernels.rs` has the loops, plain Rust that the compiler vectorises for each set of
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
