//! Golden models and samplers: closures that a design makes from its parameters.

use super::inputs::{Sampler, Uniform};
use crate::netlist::{Netlist, Quantity};
use crate::number::format::Format;
use std::cell::Cell;
use std::fmt;
use std::sync::Arc;

type GoldenFn<F> = dyn Fn(&[&[F]], &mut [Vec<F>]) + Send + Sync;

/// A golden model for one setting of the parameters: the unit's function in plain floating point,
/// written from the mathematics and not from the netlist. From the input columns it computes the
/// columns of all groups, in order, followed by the scales of those that have any.
#[derive(Clone)]
pub struct Golden<F> {
    run: Arc<GoldenFn<F>>,
    /// Number of inputs and columns, if the closure's type fixes them.
    takes: Option<[usize; 2]>,
}

impl<F: Copy + 'static> Golden<F> {
    /// A model on blocks. The columns to fill have the length of the inputs.
    #[must_use]
    pub fn new(run: impl Fn(&[&[F]], &mut [Vec<F>]) + Send + Sync + 'static) -> Self {
        Self { run: Arc::new(run), takes: None }
    }

    /// A model of one sample: it maps the inputs in order to the columns in order.
    #[must_use]
    pub fn each<const INPUTS: usize, const COLUMNS: usize>(
        sample: impl Fn([F; INPUTS]) -> [F; COLUMNS] + Send + Sync + 'static,
    ) -> Self {
        let run = move |inputs: &[&[F]], outputs: &mut [Vec<F>]| {
            for i in 0..outputs.first().map_or(0, Vec::len) {
                let values = sample(std::array::from_fn(|port| inputs[port][i]));
                for (column, value) in outputs.iter_mut().zip(values) {
                    column[i] = value;
                }
            }
        };
        Self { run: Arc::new(run), takes: Some([INPUTS, COLUMNS]) }
    }

    /// Fills the columns, which have the length of the inputs.
    pub fn run(&self, inputs: &[&[F]], outputs: &mut [Vec<F>]) {
        (self.run)(inputs, outputs);
    }

    pub(super) fn takes(&self) -> Option<[usize; 2]> {
        self.takes
    }
}

impl<F> fmt::Debug for Golden<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("golden")
    }
}

type DrawFn = dyn Fn(Sampler, &mut Uniform, &mut [Vec<f64>], usize) + Send + Sync;

/// Draws random inputs, for one setting of the parameters.
#[derive(Clone)]
pub struct Draw(Arc<DrawFn>);

impl Draw {
    /// A closure that fills one column per input with the requested number of values.
    #[must_use]
    pub fn new(
        run: impl Fn(Sampler, &mut Uniform, &mut [Vec<f64>], usize) + Send + Sync + 'static,
    ) -> Self {
        Self(Arc::new(run))
    }

    /// Numbers of both signs and all sizes: for half of the rows the exponent is uniform over a
    /// port's bits, for the others the value is uniform. Angles are uniform.
    #[must_use]
    pub fn words(ports: &InputPorts<'_>) -> Self {
        let all = (0..ports.len()).map(|at| (ports.format(at), ports.quantity(at)));
        let all: Vec<(Format, Quantity)> = all.collect();
        Self::new(move |_, uniform, columns, count| {
            columns.iter_mut().for_each(Vec::clear);
            for _ in 0..count {
                let evenly = uniform.draw() < 0.5;
                for (column, (format, quantity)) in columns.iter_mut().zip(&all) {
                    let (low, high) =
                        (format.value(format.min_raw()), format.value(format.max_raw()));
                    let value = if evenly || *quantity == Quantity::Turns {
                        low + (high - low) * uniform.draw()
                    } else {
                        let size = high * libm::exp2(-uniform.draw() * f64::from(format.bits()));
                        if uniform.draw() < 0.5 && format.is_signed() { -size } else { size }
                    };
                    column.push(value);
                }
            }
        })
    }

    /// Fills the columns.
    pub(crate) fn run(
        &self,
        sampler: Sampler,
        uniform: &mut Uniform,
        columns: &mut [Vec<f64>],
        count: usize,
    ) {
        (self.0)(sampler, uniform, columns, count);
    }
}

impl fmt::Debug for Draw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("draw")
    }
}

/// The input ports of a netlist, as a sampler sees them.
#[derive(Debug)]
pub struct InputPorts<'a> {
    netlist: &'a Netlist,
    /// Whether a format or quantity was read: then the drawn values depend on formats.
    more: Cell<bool>,
}

impl<'a> InputPorts<'a> {
    pub(super) fn new(netlist: &'a Netlist) -> Self {
        Self { netlist, more: Cell::new(false) }
    }

    /// Number of ports.
    #[must_use]
    pub fn len(&self) -> usize {
        self.netlist.inputs().len()
    }

    /// True if there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Their names.
    pub fn names(&self) -> impl Iterator<Item = &'a str> + use<'a> {
        let netlist = self.netlist;
        (0..self.len()).map(move |at| netlist.input_name(at))
    }

    /// Format of a port.
    #[must_use]
    pub fn format(&self, at: usize) -> Format {
        self.more.set(true);
        self.netlist.node(self.netlist.inputs()[at]).format
    }

    /// Quantity of a port.
    #[must_use]
    pub fn quantity(&self, at: usize) -> Quantity {
        self.more.set(true);
        self.netlist.node(self.netlist.inputs()[at]).quantity
    }

    pub(super) fn were_read(&self) -> bool {
        self.more.get()
    }
}
