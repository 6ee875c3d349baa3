//! Clock cycles of the hardware, flat or shared.
//!
//! In each cycle [`Cycle::settle`] lets logic follow the inputs and registers, and
//! [`Cycle::clock`] takes the rising edge. Inputs are taken in phase 0 only ([`Cycle::ready`]).
//! Registers are unknown until the first data reaches them; only the valid bits and the phase
//! counter have a reset, as in the emitted hardware. Units are flat pipelines inside, so they are
//! simulated by this same type.

use crate::cast;
use crate::format::{Format, Overflow};
use crate::netlist::NodeId;
use crate::op::Op;
use crate::rtl::{Rtl, Signal, Source};
use std::sync::Arc;

/// State of the hardware.
#[derive(Clone, Debug)]
pub struct Cycle {
    rtl: Arc<Rtl>,
    /// Word of each node in its own stage.
    own: Vec<i64>,
    /// Words of its registers.
    registers: Vec<Vec<i64>>,
    /// What reads on a clock take at the next edge.
    read: Vec<i64>,
    /// The valid input, and what the valid bits hold.
    valid_in: bool,
    valid: Vec<bool>,
    phase: u32,
    units: Vec<UnitState>,
    /// Edges since the start.
    edges: u64,
    /// A `narrow` under overflow mode `error` that overflowed on valid data.
    forbidden: Option<NodeId>,
}

/// State of a unit.
#[derive(Clone, Debug)]
struct UnitState {
    inside: Cycle,
    /// Words at its ports; those with a register keep theirs.
    ports: Vec<i64>,
    /// What port registers take at the next edge.
    next: Vec<i64>,
    /// Operation in each of its stages, the one that is issued first; of valid data or not.
    sits: Vec<Option<usize>>,
}

impl Cycle {
    /// Hardware before the first edge, with all valid bits clear.
    #[must_use]
    pub fn new(rtl: Arc<Rtl>) -> Self {
        let nodes = rtl.netlist().nodes().len();
        let registers = rtl.netlist().ids().map(|id| vec![0; rtl.registers(id).count()]).collect();
        let units = rtl.units().iter().map(|unit| UnitState {
            inside: Self::new(Arc::clone(&unit.rtl)),
            ports: vec![0; unit.ports.len()],
            next: vec![0; unit.ports.len()],
            sits: vec![None; cast::index_of_u32(unit.rtl.schedule().latency()) + 1],
        });
        Self {
            own: vec![0; nodes],
            registers,
            read: vec![0; nodes],
            valid_in: false,
            valid: vec![false; cast::index_of_u32(rtl.valid_bits())],
            phase: 0,
            units: units.collect(),
            edges: 0,
            forbidden: None,
            rtl,
        }
    }

    /// Lets logic follow the input words; `valid` says whether they are data.
    ///
    /// # Panics
    /// If there is not one word per input port.
    pub fn settle(&mut self, inputs: &[i64], valid: bool) {
        let rtl = Arc::clone(&self.rtl);
        let netlist = rtl.netlist();
        assert_eq!(inputs.len(), netlist.inputs().len(), "bug: one word per input");
        self.valid_in = valid && self.ready();
        let mut ports = inputs.iter();
        for id in netlist.ids() {
            let node = netlist.node(id);
            if node.op == Op::Input {
                self.own[id.index()] = *ports.next().expect("bug: counted above");
                continue;
            }
            if !rtl.is_free(id) {
                continue;
            }
            let mut of = [(0, Format::FLAG); 3];
            for (slot, operand) in of.iter_mut().zip(&node.operands) {
                *slot = (self.word(rtl.operand(id, *operand)), netlist.node(*operand).format);
            }
            let of = &of[..node.operands.len()];
            let (word, overflowed) = node.op.eval_raw(of, node.format, netlist.tables());
            let error = overflowed && node.op.overflow() == Some(Overflow::Error);
            if error && self.is_data(rtl.schedule().stage(id)) {
                self.forbidden.get_or_insert(id);
            }
            if rtl.schedule().is_clocked(netlist, id) {
                self.read[id.index()] = word;
            } else {
                self.own[id.index()] = word;
            }
        }
        let mut units = std::mem::take(&mut self.units);
        for (number, state) in units.iter_mut().enumerate() {
            self.settle_unit(&rtl, number, state);
        }
        self.units = units;
        for id in netlist.ids() {
            if let Some(result) = rtl.result(id) {
                let unit = rtl.units()[result.unit].rtl.netlist();
                let hull = unit.outputs()[result.output].node;
                let inside = &self.units[result.unit].inside;
                let word = inside.word(inside.rtl.output(hull)) >> result.right;
                self.own[id.index()] = netlist.node(id).format.wrap(word);
            }
        }
    }

    fn settle_unit(&mut self, rtl: &Rtl, number: usize, state: &mut UnitState) {
        let unit = &rtl.units()[number];
        for (at, port) in unit.ports.iter().enumerate() {
            let case = port.case(self.phase);
            let word = |case: &crate::rtl::Case| {
                case.shifted(match case.source {
                    Source::Signal(signal) => self.word(signal),
                    Source::Constant { raw, .. } => raw,
                })
            };
            match (port.registered, case) {
                (true, Some(case)) => state.next[at] = word(case),
                (true, None) => state.next[at] = state.ports[at],
                (false, Some(case)) => state.ports[at] = word(case),
                (false, None) => state.ports[at] = word(&port.cases[0]),
            }
        }
        let operations = rtl.operations(number);
        let issued = operations
            .iter()
            .position(|operation| rtl.schedule().phase(operation.issue) == self.phase);
        let valid = issued.is_some_and(|at| self.valid(operations[at].issue));
        state.sits[0] = issued.filter(|_| valid);
        state.inside.settle(&state.ports, valid);
        if let Some(inside) = state.inside.forbidden.take() {
            // The node of the operation that sits there.
            let stage = cast::index_of_u32(state.inside.rtl.schedule().stage(inside));
            let position = rtl.schedule().units()[number].positions[inside.index()];
            if let (Some(at), Some(position)) = (state.sits[stage], position) {
                self.forbidden.get_or_insert(operations[at].nodes[position]);
            }
        }
    }

    /// Takes a rising edge.
    pub fn clock(&mut self) {
        let rtl = Arc::clone(&self.rtl);
        for id in rtl.netlist().ids() {
            let loads = rtl.schedule().phase(rtl.schedule().stage(id)) == self.phase;
            let registers = &mut self.registers[id.index()];
            if !registers.is_empty() && loads {
                registers.rotate_right(1);
                registers[0] = self.own[id.index()];
            }
            if rtl.schedule().is_clocked(rtl.netlist(), id) {
                self.own[id.index()] = self.read[id.index()];
            }
        }
        for (state, unit) in self.units.iter_mut().zip(rtl.units()) {
            state.inside.clock();
            state.sits.rotate_right(1);
            state.sits[0] = None;
            for (at, port) in unit.ports.iter().enumerate() {
                if port.registered {
                    state.ports[at] = state.next[at];
                }
            }
        }
        if self.ready() && !self.valid.is_empty() {
            self.valid.rotate_right(1);
            self.valid[0] = self.valid_in;
        }
        self.valid_in = false;
        self.phase = (self.phase + 1) % rtl.schedule().interval();
        self.edges += 1;
    }

    /// Clears the valid bits and the phase, as the reset does at an edge.
    pub fn reset(&mut self) {
        self.valid_in = false;
        self.valid.fill(false);
        self.phase = 0;
        for state in &mut self.units {
            state.inside.reset();
            state.sits.fill(None);
        }
    }

    /// The phase: cycles modulo the interval.
    #[must_use]
    pub fn phase(&self) -> u32 {
        self.phase
    }

    /// True in the phase in which inputs are taken.
    #[must_use]
    pub fn ready(&self) -> bool {
        self.phase == 0
    }

    /// The operation of valid data that sits in a stage of a unit; stage 0 is the issue and the
    /// unit's latency the out.
    #[must_use]
    pub fn sits(&self, unit: usize, stage: u32) -> Option<usize> {
        self.units[unit].sits[cast::index_of_u32(stage)]
    }

    /// Word at a port of a unit, after its register if it has one.
    #[must_use]
    pub fn port(&self, unit: usize, port: usize) -> i64 {
        self.units[unit].ports[port]
    }

    /// State of the inside of a unit.
    #[must_use]
    pub fn inside(&self, unit: usize) -> &Self {
        &self.units[unit].inside
    }

    /// Word of a signal; meaningless while it is not [known](Self::known).
    #[must_use]
    pub fn word(&self, signal: Signal) -> i64 {
        let own = self.rtl.schedule().stage(signal.node);
        if signal.stage == own {
            self.own[signal.node.index()]
        } else {
            let register = (signal.stage - own - 1) / self.rtl.schedule().interval();
            self.registers[signal.node.index()][cast::index_of_u32(register)]
        }
    }

    /// The first `narrow` under [`Overflow::Error`] that overflowed on valid data.
    #[must_use]
    pub fn forbidden_overflow(&self) -> Option<NodeId> {
        self.forbidden
    }

    /// Rising edges taken so far.
    #[must_use]
    pub fn edges(&self) -> u64 {
        self.edges
    }

    /// True once data from the first cycle has reached a stage.
    #[must_use]
    pub fn known(&self, stage: u32) -> bool {
        self.edges >= u64::from(stage)
    }

    /// True if the sample that is in this stage in its phase is data.
    #[must_use]
    pub fn valid(&self, stage: u32) -> bool {
        match stage.checked_sub(1) {
            None => self.valid_in,
            Some(before) => {
                let bit = before / self.rtl.schedule().interval();
                self.valid.get(cast::index_of_u32(bit)).copied().unwrap_or(false)
            }
        }
    }

    /// True in a cycle in which a stage works on data: valid, and in its phase.
    #[must_use]
    pub fn is_data(&self, stage: u32) -> bool {
        self.valid(stage) && self.rtl.schedule().phase(stage) == self.phase
    }

    /// Words of the output ports, if they are valid: in one cycle for each sample.
    #[must_use]
    pub fn outputs(&self) -> Option<Vec<i64>> {
        let word = |node: NodeId| self.word(self.rtl.output(node));
        let outputs = self.rtl.netlist().outputs();
        self.is_data(self.rtl.schedule().latency())
            .then(|| outputs.iter().map(|output| word(output.node)).collect())
    }
}
