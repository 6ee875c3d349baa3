//! Simulation of a netlist: [`batch`] for many independent samples, [`real`] for the same on
//! reals, [`cycle`] for clock cycles of the pipelined hardware.

pub mod batch;
mod columns;
pub mod cycle;
mod kernels;
mod lanes;
pub mod real;
