//! A generator and bit-true simulator of fixed-point datapaths.
#![deny(unsafe_code)]

mod cast;
pub mod cli;
pub mod error;
pub mod eval;
pub mod format;
pub mod function;
pub mod lut;
pub mod measure;
pub mod netlist;
pub mod op;
pub mod output;
pub mod report;
pub mod rtl;
pub mod schedule;
pub mod sim;
mod simd;
pub mod sweep;
pub mod trig;
pub mod units;
pub mod wave;
