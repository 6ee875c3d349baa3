//! Simulation of a netlist: [`batch`] bit-true over many samples, [`real`] the same on reals.

pub mod batch;
mod columns;
mod kernels;
mod lanes;
pub mod real;
