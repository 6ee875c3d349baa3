//! Simulation of a netlist: [`batch`] for many independent samples, [`real`] for the same on reals.

pub mod batch;
mod columns;
mod kernels;
mod lanes;
pub mod real;
