//! A unit of a render path, whose ports are addressed by name.

use super::block::BlockShot;
use super::pipeline::{Pipeline, knows};
use crate::base::error::Result;
use crate::design::{Design, Unit};
use crate::netlist::NodeId;
use crate::number::format::Format;
use crate::sim::batch::{Program, Runner};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Instant;

/// A design with its program.
pub(super) struct Stage {
    pub(super) design: Arc<Design>,
    pub(super) program: Program,
}

impl Stage {
    /// A unit with those assignments of the pipeline that it has parameters for, and the scene's.
    pub(super) fn new(unit: &Unit, pipeline: &Pipeline, scene: &[String]) -> Result<Self> {
        let own = pipeline.assignments.iter().filter(|set| knows(unit, set));
        let all: Vec<&String> = own.chain(scene).collect();
        let design = unit.values(&all)?.build()?;
        let nodes: Vec<NodeId> =
            design.netlist.outputs().iter().map(|output| output.node).collect();
        let program = Program::compile(&design.netlist, &nodes);
        Ok(Self { design: Arc::new(design), program })
    }

    /// Input columns in the order of the ports, from columns by name.
    pub(super) fn inputs<T>(&self, mut columns: BTreeMap<String, Vec<T>>) -> Vec<Vec<T>> {
        let netlist = &self.design.netlist;
        let column = |at| {
            let name = netlist.input_name(at);
            columns.remove(name).unwrap_or_else(|| panic!("bug: nothing for the port `{name}`"))
        };
        (0..netlist.inputs().len()).map(column).collect()
    }

    /// Runs the unit; returns the words of all outputs by name.
    pub(super) fn run(
        &self,
        runner: &mut Runner,
        words: &[Vec<i64>],
        shot: &mut BlockShot,
        stage: usize,
    ) -> BTreeMap<&str, Vec<i64>> {
        let outputs = self.design.netlist.outputs();
        let slices: Vec<&[i64]> = words.iter().map(Vec::as_slice).collect();
        let mut out = vec![Vec::new(); outputs.len()];
        let before = runner.overflows().to_vec();
        let start = Instant::now();
        runner
            .run(&self.program, &slices, &mut out)
            .expect("bug: words are of their ports' formats");
        shot.engine += start.elapsed();
        let counts = runner.overflows().iter().zip(before);
        for (total, (after, before)) in shot.overflows[stage].iter_mut().zip(counts) {
            *total += after - before;
        }
        outputs.iter().map(|output| output.name.as_str()).zip(out).collect()
    }

    pub(super) fn ulp(&self, name: &str) -> f64 {
        let netlist = &self.design.netlist;
        let port = netlist.outputs().iter().find(|output| output.name == name);
        netlist.node(port.expect("bug: a port of this name").node).format.ulp()
    }

    /// Format of an input port, if a port has this name.
    pub(super) fn port(&self, name: &str) -> Option<Format> {
        let netlist = &self.design.netlist;
        let at = (0..netlist.inputs().len()).find(|at| netlist.input_name(*at) == name);
        at.map(|at| netlist.node(netlist.inputs()[at]).format)
    }

    /// The largest value that an input port holds; its negative fits too.
    pub(super) fn reach(&self, port: &str) -> f64 {
        let format = self.port(port).expect("bug: a port of this name");
        format.value(format.max_raw())
    }
}
