//! A generator and bit-true simulator of fixed-point datapaths.
#![deny(unsafe_code)]

mod cast;
pub mod error;
pub mod format;
pub mod function;
pub mod lut;
pub mod measure;
pub mod netlist;
pub mod op;
pub mod output;
pub mod report;
pub mod sim;
pub mod sweep;
pub mod units;
