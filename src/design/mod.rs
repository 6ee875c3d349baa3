//! What a datapath promises: a unit is a recipe, parameters turn it into a design.
//!
//! A [`Unit`] says its parameters ([`Param`]) and builds, from their [`Values`], a [`Design`]: a netlist with its
//! golden model, the sampler of its inputs, its hard cases and its stated bounds.

mod bound;
mod group;
mod inputs;
mod param;
mod unit;

pub use bound::{Bound, BoundFn, Bounds};
pub use group::{Group, Scale, Shape};
pub use inputs::{HardCase, Sampler, Uniform};
pub use param::{Kind, PIPELINE, Param, Reflection, Role, Value};
pub use unit::{Shading, Unit, Values};

use crate::netlist::{Netlist, NodeId};
use crate::schedule::Binding;
use crate::table::Tabulated;
use group::prefixed;
use std::sync::Arc;

/// A datapath with what it takes to run and judge it.
#[derive(Debug)]
pub struct Design {
    /// Parameters that made it.
    pub values: Values,
    /// The datapath.
    pub netlist: Arc<Netlist>,
    /// What is judged: the output ports in order, then nodes inside.
    pub groups: Vec<Group>,
    /// Golden model in `f64`.
    pub golden: Golden<f64>,
    /// The same in `f32`, to be judged as a rival.
    pub golden_f32: Golden<f32>,
    /// Stated error bounds.
    pub bounds: Bounds,
    /// Table schemes in use.
    pub tabulated: Vec<Tabulated>,
    /// The hard cases.
    pub hard: Vec<HardCase>,
    /// Input sampler.
    pub draw: Draw,
    /// A schedule given by hand, for `schedule=printed`.
    pub binding: Option<Binding>,
}

impl Design {
    /// The nodes of all groups in order, which start with the output ports.
    #[must_use]
    pub fn judged(&self) -> Vec<NodeId> {
        self.groups.iter().flat_map(|group| group.nodes.iter().copied()).collect()
    }

    /// Number of the golden model's columns: those of all groups, then the scales.
    #[must_use]
    pub fn golden_columns(&self) -> usize {
        let columns = |shape: Shape| shape.columns().len() + shape.scales().len();
        self.groups.iter().map(|group| columns(group.shape)).sum()
    }

    /// What the errors of some quantities are told over, by the quantities' names.
    #[must_use]
    pub fn scales(&self) -> Vec<(String, &'static str)> {
        let of = |group: &Group| -> Vec<(String, &'static str)> {
            let scales = group.shape.scales().iter();
            scales.map(|scale| (prefixed(group.name, scale.name), scale.what)).collect()
        };
        self.groups.iter().flat_map(of).collect()
    }

    /// Values that a row of golden columns means for the judged nodes.
    #[must_use]
    pub fn of_golden(&self, row: &[f64]) -> Vec<f64> {
        let mut values = Vec::new();
        let mut at = 0;
        for group in &self.groups {
            let columns = group.shape.columns().len();
            values.extend(group.shape.of_golden(&row[at..at + columns]));
            at += columns;
        }
        values
    }

    /// The parameters that the golden model depends on.
    pub(crate) fn golden_key(&self) -> Vec<Value> {
        self.values.unit().golden_params.iter().map(|name| self.values.get(name)).collect()
    }

    /// The schedule by hand, if the parameters ask for it.
    #[must_use]
    pub fn printed(&self) -> Option<&Binding> {
        self.binding.as_ref().filter(|_| self.values.choice("schedule") == "printed")
    }
}

/// A golden model on blocks: input columns in, columns of all groups out, in order, and then the
/// scales of those that have one.
pub type Golden<F> = fn(&Values, &[&[F]], &mut [Vec<F>]);

/// Fills one column per input with random values.
pub type Draw = fn(&Design, Sampler, &mut Uniform, &mut [Vec<f64>], usize);
