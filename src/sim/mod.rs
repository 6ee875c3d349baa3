//! Simulation of a netlist: [`batch`] for many independent samples, [`cycle`] for clock
//! cycles.

pub mod batch;
pub mod cycle;
