//! Units and designs: parameters turn a unit into a design.
//!
//! A [`Unit`] declares its parameters ([`Param`]). From their [`Values`] it makes a [`Design`]: a
//! netlist with its golden model, input sampler, hard cases and stated bounds.

mod bound;
mod file;
mod golden;
mod group;
mod inputs;
mod memory;
mod param;
mod unit;

pub use bound::{Bound, BoundFn, Bounds};
pub use golden::{Draw, Golden, InputPorts};
pub use group::{Group, Scale, Shape};
pub use inputs::{HardCase, Sampler, Uniform};
pub use param::{Kind, PIPELINE, Param, Reflection, Role, Value};
pub use unit::{Recipe, Shading, Unit, Values};

use crate::base::error::{Error, Result};
use crate::base::name;
use crate::netlist::{Netlist, NodeId, Quantity};
use crate::number::format::Format;
use crate::schedule::Binding;
use crate::table::Tabulated;
use group::prefixed;
use std::fmt::Display;
use std::sync::Arc;

/// A datapath with everything needed to run and judge it. [`Design::new`] and setters make it;
/// building a unit checks it.
#[derive(Debug)]
pub struct Design {
    /// Parameters that made it.
    pub values: Values,
    /// The datapath.
    pub netlist: Arc<Netlist>,
    /// The judged nodes: the output ports in order, then inner nodes.
    pub groups: Vec<Group>,
    /// Golden model in `f64`.
    pub golden: Golden<f64>,
    /// The golden model in `f32`, which is judged as a rival.
    pub golden_f32: Option<Golden<f32>>,
    /// Stated error bounds.
    pub bounds: Bounds,
    /// The table schemes in use.
    pub tabulated: Vec<Tabulated>,
    /// The hard cases.
    pub hard: Vec<HardCase>,
    /// Input sampler.
    pub draw: Draw,
    /// A hand-written schedule, for `schedule=printed`.
    pub binding: Option<Binding>,
    made: Made,
}

/// How the golden models and the sampler were made.
#[derive(Debug)]
struct Made {
    has_golden: bool,
    /// For each parameter, whether it was read.
    read: Vec<bool>,
    /// Whether the sampler depends on the formats of the ports.
    drawn_by_format: bool,
    /// The first read of an unknown parameter, or words that don't fit a memory.
    wrong: Option<Error>,
    /// Whether a memory has random words.
    filled: bool,
}

impl Design {
    /// A design of a netlist, made from these values. Defaults until set: each output port is a
    /// number or angle of its own, the hard cases are the ends of the formats, inputs are numbers
    /// of all sizes, and no bound is stated. A golden model must be set.
    #[must_use]
    pub fn new(values: &Values, netlist: Netlist) -> Self {
        let values = values.clone();
        let mut made = Made {
            has_golden: false,
            read: vec![false; values.all().len()],
            drawn_by_format: true,
            wrong: None,
            filled: false,
        };
        let netlist = values.bound(&netlist).unwrap_or_else(|wrong| {
            made.wrong = Some(wrong);
            netlist
        });
        let group = |output: &crate::netlist::Output| {
            let shape = match netlist.node(output.node).quantity {
                Quantity::Turns => Shape::Turns,
                Quantity::Number | Quantity::Float20 => Shape::Scalar,
            };
            Group::new(output.name.as_str(), shape, vec![output.node])
        };
        Self {
            groups: netlist.outputs().iter().map(group).collect(),
            golden: Golden::new(|_, _| ()),
            golden_f32: None,
            bounds: Bounds::unstated("the unit states none"),
            tabulated: Vec::new(),
            hard: HardCase::extremes(&netlist),
            draw: Draw::words(&InputPorts::new(&netlist)),
            binding: None,
            netlist: Arc::new(netlist),
            values,
            made,
        }
    }

    /// Sets the judged nodes: the output ports in order, then inner nodes.
    #[must_use]
    pub fn groups(mut self, groups: Vec<Group>) -> Self {
        self.groups = groups;
        self
    }

    /// Sets the golden model. `make` must depend on nothing of the design but the parameters that
    /// it reads through its argument: points of a sweep with equal values of these share golden
    /// values. (A closure that captures something counts as reading all parameters.)
    #[must_use]
    pub fn golden<M: FnOnce(&Values) -> Golden<f64>>(mut self, make: M) -> Self {
        self.golden = self.made_by::<M, _>(make);
        self.made.has_golden = true;
        self
    }

    /// Sets the golden model in `f64`, and a rival in `f32` that is judged on the hard cases.
    #[must_use]
    pub fn goldens<M, N>(mut self, make: M, make_f32: N) -> Self
    where
        M: FnOnce(&Values) -> Golden<f64>,
        N: FnOnce(&Values) -> Golden<f32>,
    {
        self.golden_f32 = Some(self.made_by::<N, _>(make_f32));
        self.golden(make)
    }

    /// Sets the sampler of the inputs; `make` reads parameters as in [`Design::golden`].
    #[must_use]
    pub fn draw<M: FnOnce(&Values, &InputPorts<'_>) -> Draw>(mut self, make: M) -> Self {
        let netlist = Arc::clone(&self.netlist);
        let ports = InputPorts::new(&netlist);
        self.draw = self.made_by::<M, _>(|values| make(values, &ports));
        self.made.drawn_by_format = ports.were_read();
        self
    }

    /// Makes something from the parameters and records which were read; `M` is the unit's closure.
    fn made_by<M, T>(&mut self, make: impl FnOnce(&Values) -> T) -> T {
        let noting = self.values.noting();
        let made = make(&noting);
        let captures = size_of::<M>() > 0;
        for (all, read) in self.made.read.iter_mut().zip(noting.were_read()) {
            *all |= captures || read;
        }
        self.made.wrong = self.made.wrong.take().or_else(|| noting.wrong());
        made
    }

    /// Sets the hard cases.
    #[must_use]
    pub fn hard(mut self, hard: Vec<HardCase>) -> Self {
        self.hard = hard;
        self
    }

    /// Sets the error bounds that the design states.
    #[must_use]
    pub fn bounds(mut self, bounds: Bounds) -> Self {
        self.bounds = bounds;
        self
    }

    /// Sets the table schemes in use: their own errors are reported, and bounds may refer to them.
    #[must_use]
    pub fn tabulated(mut self, tabulated: Vec<Tabulated>) -> Self {
        self.tabulated = tabulated;
        self
    }

    /// Sets a hand-written schedule, for `schedule=printed`.
    #[must_use]
    pub fn binding(mut self, binding: Option<Binding>) -> Self {
        self.binding = binding;
        self
    }

    /// Refuses an inconsistent design.
    ///
    /// # Errors
    /// If there is no golden model, or it has the wrong number of inputs or columns; if a group
    /// doesn't match its shape, or the first groups aren't the output ports; if a hard case isn't
    /// one word of its format per port; or if a bound is on a quantity that isn't measured.
    pub fn check(&self) -> Result<()> {
        let unit = &self.values.unit().name;
        let netlist = &self.netlist;
        let refuse = |why: &dyn Display| Err(Error::usage(format!("unit `{unit}`: {why}")));
        if let Some(wrong) = &self.made.wrong {
            return refuse(wrong);
        }
        for Group { name, shape, nodes } in &self.groups {
            let (takes, given) = (shape.nodes(), nodes.len());
            if takes != given {
                return refuse(&format!("group `{name}` needs {takes} nodes and has {given}"));
            }
            if nodes.iter().any(|id| !id.is_finished() || id.index() >= netlist.nodes().len()) {
                return refuse(&format!(
                    "group `{name}` has a node of another netlist or of a builder: use ids of the built netlist"
                ));
            }
            if !name.is_empty() && !name::is_legal(name) {
                return Err(Error::name("group", name));
            }
        }
        let judged = self.judged();
        let outputs = netlist.outputs().iter().map(|output| output.node);
        if !outputs.enumerate().all(|(at, node)| judged.get(at) == Some(&node)) {
            return refuse(&"its groups don't start with the output ports in order");
        }
        if !self.made.has_golden {
            return refuse(&"it has no golden model: set one with `golden`");
        }
        let (ports, columns) = (netlist.inputs().len(), self.golden_columns());
        let of_f32 = self.golden_f32.as_ref().and_then(Golden::takes);
        for [takes, gives] in self.golden.takes().into_iter().chain(of_f32) {
            if takes != ports {
                return refuse(&format!("its golden takes {takes} inputs, but there are {ports}"));
            }
            if gives != columns {
                return refuse(&format!(
                    "its golden gives {gives} columns, but the groups have {columns}"
                ));
            }
        }
        let formats: Vec<(&str, Format)> = (0..ports)
            .map(|at| (netlist.input_name(at), netlist.node(netlist.inputs()[at]).format))
            .collect();
        for HardCase { name, words } in &self.hard {
            for case in words {
                if case.len() != ports {
                    let given = case.len();
                    return refuse(&format!(
                        "a hard case of `{name}` has {given} words for {ports} ports"
                    ));
                }
                let past =
                    case.iter().zip(&formats).find(|(word, (_, format))| !format.contains(**word));
                if let Some((word, (port, format))) = past {
                    return refuse(&format!(
                        "a hard case of `{name}` has the word {word} for `{port}`, which has format {format}"
                    ));
                }
            }
        }
        let quantities: Vec<String> = self.groups.iter().flat_map(Group::quantities).collect();
        if let Some((_, twice)) =
            quantities.iter().enumerate().find(|(at, name)| quantities[..*at].contains(name))
        {
            return refuse(&format!(
                "two quantities are called `{twice}`: give its groups different names"
            ));
        }
        for bound in self.bounds.stated() {
            if let Some(none) = bound.quantities.iter().find(|name| !quantities.contains(name)) {
                return refuse(&format!(
                    "its bound on `{}` is on `{none}`, which isn't measured; measured are {}",
                    bound.what,
                    quantities.join(", ")
                ));
            }
        }
        self.check_lengths()
    }

    /// Runs the sampler and the golden once, over few samples.
    fn check_lengths(&self) -> Result<()> {
        const SAMPLES: usize = 2;
        let unit = &self.values.unit().name;
        let wrong = |what: &str| {
            Err(Error::usage(format!(
                "unit `{unit}`: its {what} doesn't fill each column to its length"
            )))
        };
        let mut inputs = vec![Vec::new(); self.netlist.inputs().len()];
        self.draw.run(Sampler::Sphere, &mut Uniform::new(1), &mut inputs, SAMPLES);
        if inputs.iter().any(|column| column.len() != SAMPLES) {
            return wrong("sampler");
        }
        let inputs: Vec<&[f64]> = inputs.iter().map(Vec::as_slice).collect();
        let mut outputs = vec![vec![0.0; SAMPLES]; self.golden_columns()];
        self.golden.run(&inputs, &mut outputs);
        if outputs.iter().any(|column| column.len() != SAMPLES) {
            return wrong("golden model");
        }
        Ok(())
    }

    /// The nodes of all groups in order; the output ports come first.
    #[must_use]
    pub fn judged(&self) -> Vec<NodeId> {
        self.groups.iter().flat_map(|group| group.nodes.iter().copied()).collect()
    }

    /// Number of the golden model's columns: those of all groups, then the scales.
    #[must_use]
    pub fn golden_columns(&self) -> usize {
        let columns = |shape: &Shape| shape.columns().len() + shape.scales().len();
        self.groups.iter().map(|group| columns(&group.shape)).sum()
    }

    /// The scale of each relative quantity, by the quantity's name.
    #[must_use]
    pub fn scales(&self) -> Vec<(String, String)> {
        let of = |group: &Group| -> Vec<(String, String)> {
            let scales = group.shape.scales().iter();
            scales.map(|scale| (prefixed(&group.name, &scale.name), scale.what.clone())).collect()
        };
        self.groups.iter().flat_map(of).collect()
    }

    /// Converts a row of golden columns to values of the judged nodes.
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

    /// Everything that the golden model and the sampler depend on: designs of a unit with equal
    /// keys have the same.
    pub(crate) fn golden_key(&self) -> impl PartialEq {
        let all = self.values.all().iter().zip(&self.made.read).enumerate();
        let read = all.filter(|(_, (_, read))| **read).map(|(at, (value, _))| (at, value.clone()));
        let ports: Vec<String> =
            InputPorts::new(&self.netlist).names().map(str::to_owned).collect();
        // A closure that reads all parameters may also have read values set by name. Words of
        // memories are part of the judged netlist.
        let reads_all = self.made.read.iter().all(|read| *read);
        let named = self.values.named();
        let named = named.filter(|(key, _)| reads_all || key.starts_with(unit::MEMORY));
        let named: Vec<(String, Value)> =
            named.map(|(key, value)| (key.to_owned(), value.clone())).collect();
        (read.collect::<Vec<_>>(), self.golden_columns(), ports, named)
    }

    /// Whether the drawn values also depend on the formats of the ports.
    pub(crate) fn is_drawn_by_format(&self) -> bool {
        self.made.drawn_by_format
    }

    /// The hand-written schedule, if the parameters ask for it.
    #[must_use]
    pub fn printed(&self) -> Option<&Binding> {
        self.binding.as_ref().filter(|_| self.values.choice("schedule") == "printed")
    }
}
