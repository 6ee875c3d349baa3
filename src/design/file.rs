//! A netlist as a unit, without a golden model of its own.

use super::{Bounds, Design, Golden, Unit};
use crate::netlist::op::Op;
use crate::netlist::{Netlist, NodeId};
use crate::number::format::{Format, Overflow, Round, quantize};
use crate::sim::real::Program;
use std::sync::Arc;

const NO_GOLDEN: &str = "a netlist has no golden model: its errors are measured against its own value on reals, so the total error is the arithmetic error";

impl Unit {
    /// A netlist as a unit, with no parameters but the pipeline's. Its golden is the value of its
    /// outputs on reals, so its total error is its arithmetic error. An output of bits without such
    /// a value is its own golden.
    #[must_use]
    pub fn of_netlist(netlist: Netlist) -> Self {
        let names = |names: Vec<&str>| names.join(", ");
        let inputs = (0..netlist.inputs().len()).map(|port| netlist.input_name(port)).collect();
        let outputs = netlist.outputs().iter().map(|output| output.name.as_str()).collect();
        let (inputs, outputs) = (names(inputs), names(outputs));
        let netlist = Arc::new(netlist);
        Self::new(netlist.name(), "a netlist from a file")
            .source(NO_GOLDEN)
            .inputs(inputs)
            .outputs(outputs)
            .design(move |values| {
                let design = Design::new(values, (*netlist).clone());
                // The design's netlist, which includes the words bound to memories.
                let own = Arc::clone(&design.netlist);
                Ok(design.golden(move |_| on_reals(own)).bounds(Bounds::unstated(NO_GOLDEN)))
            })
    }
}

/// Values of the outputs on reals.
fn on_reals(netlist: Arc<Netlist>) -> Golden<f64> {
    let outputs: Vec<NodeId> = netlist.outputs().iter().map(|output| output.node).collect();
    let is_real = |id: &NodeId| netlist.node(*id).real.is_some();
    let reals: Vec<NodeId> = outputs.iter().copied().filter(is_real).collect();
    let program = Program::compile(&netlist, &reals).expect("bug: those with a value");
    Golden::new(move |inputs, columns| {
        let mut values = vec![Vec::new(); reals.len()];
        program.runner().run(&program, inputs, &mut values);
        let mut values = values.into_iter();
        for (id, column) in outputs.iter().zip(columns.iter_mut()) {
            if netlist.node(*id).real.is_some() {
                *column = values.next().unwrap_or_default();
            }
        }
        if reals.len() < outputs.len() {
            by_words(&netlist, &outputs, inputs, columns);
        }
    })
}

/// Fills the columns of outputs that have no value on reals with the values of their words.
fn by_words(netlist: &Netlist, outputs: &[NodeId], inputs: &[&[f64]], columns: &mut [Vec<f64>]) {
    // Nodes behind a delay depend on earlier samples, which aren't known here.
    let mut known: Vec<bool> = Vec::with_capacity(netlist.nodes().len());
    for node in netlist.nodes() {
        let of = node.operands.iter().all(|id| known[id.index()]);
        known.push(of && !matches!(node.op, Op::Delay { .. }));
    }
    let formats: Vec<Format> = netlist.inputs().iter().map(|id| netlist.node(*id).format).collect();
    for sample in 0..columns.first().map_or(0, Vec::len) {
        let word = |(format, column): (&Format, &&[f64])| {
            // Inputs are values of words.
            quantize(column[sample], *format, Round::Floor, Overflow::Wrap).map_or(0, |word| word.0)
        };
        let words: Vec<i64> = formats.iter().zip(inputs).map(word).collect();
        let Ok((words, _)) = netlist.eval(&words) else { continue };
        for (id, column) in outputs.iter().zip(columns.iter_mut()) {
            let node = netlist.node(*id);
            if node.real.is_none() {
                let value = node.format.value(words[id.index()]);
                column[sample] = if known[id.index()] { value } else { f64::NAN };
            }
        }
    }
}
