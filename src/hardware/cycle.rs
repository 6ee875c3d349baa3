//! Clock cycles of the hardware, flat or shared.
//!
//! In each cycle [`Cycle::settle`] lets logic follow the inputs and registers, and
//! [`Cycle::clock`] takes the rising edge. Inputs are taken in phase 0 only ([`Cycle::ready`]).
//! Registers are unknown until the first data reaches them; only the valid bits and the phase
//! counter have a reset, as in the emitted hardware. Units are flat pipelines inside, so they are
//! simulated by this same type.
//!
//! What a cycle does is worked out once, as a `Program`: all words of the hardware are slots of one
//! array, logic is a list of operations from slots to slots, and an edge is, for each phase, a list
//! of slots that take another's word. A chain of registers is moved on word by word; pipelines are
//! so short that a ring with a head costs more than it saves. Operations are those of
//! [`Op::eval_raw`], with no second meaning: on the rotation unit a cycle takes 0.4 us, a quarter of a wave's time.

use crate::base::cast;
use crate::base::error::Result;
use crate::hardware::rtl::{Case, Rtl, Signal, Source};
use crate::netlist::op::Op;
use crate::netlist::{NodeId, Table};
use crate::number::format::{Format, Overflow};
use std::sync::Arc;

/// State of the hardware.
#[derive(Clone, Debug)]
pub struct Cycle {
    program: Arc<Program>,
    /// The word in each slot.
    words: Vec<i64>,
    control: Control,
    units: Vec<UnitState>,
    /// Edges since the start.
    edges: u64,
    /// A `narrow` under overflow mode `error` that overflowed on valid data.
    forbidden: Option<NodeId>,
}

/// What is known of time and data.
#[derive(Clone, Debug)]
struct Control {
    /// The valid input, and what the valid bits hold.
    valid_in: bool,
    valid: Vec<bool>,
    phase: u32,
    interval: u32,
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

/// What a cycle does.
#[derive(Debug)]
struct Program {
    rtl: Arc<Rtl>,
    /// Slot of each node's word in its own stage; those of its hold registers follow.
    own: Vec<usize>,
    /// Words at the start: constants, and 0.
    start: Vec<i64>,
    inputs: Vec<usize>,
    steps: Vec<Step>,
    units: Vec<Feeds>,
    results: Vec<Taken>,
    /// By phase, in order: slots that take the word of another at the edge that ends it.
    moves: Vec<Vec<(usize, usize)>>,
}

/// The operation of a free node.
#[derive(Clone, Copy, Debug)]
struct Step {
    node: NodeId,
    stage: u32,
    op: Op,
    format: Format,
    /// Slots and formats of the operands.
    of: [(usize, Format); 3],
    operands: usize,
    /// Where the word goes: for a read on a clock, to what is taken at the edge.
    to: usize,
}

/// What goes into a unit.
#[derive(Debug)]
struct Feeds {
    /// By phase: for each port what it takes and from which slot; nothing where a register keeps
    /// its word.
    ports: Vec<Vec<Option<(Case, usize)>>>,
    /// Operation that is issued in each phase.
    issued: Vec<Option<usize>>,
}

/// A node's word at the output of a unit.
#[derive(Clone, Copy, Debug)]
struct Taken {
    unit: usize,
    /// Slot inside the unit.
    from: usize,
    right: u32,
    format: Format,
    to: usize,
}

impl Control {
    fn ready(&self) -> bool {
        self.phase == 0
    }

    fn valid(&self, stage: u32) -> bool {
        match stage.checked_sub(1) {
            None => self.valid_in,
            Some(before) => {
                let bit = before / self.interval;
                self.valid.get(cast::index_of_u32(bit)).copied().unwrap_or(false)
            }
        }
    }

    fn is_data(&self, stage: u32) -> bool {
        self.valid(stage) && stage % self.interval == self.phase
    }
}

impl Step {
    #[inline(always)]
    fn eval(&self, words: &[i64], tables: &[Table]) -> (i64, bool) {
        let of = self.of.map(|(slot, format)| (words[slot], format));
        self.op.eval_raw(&of[..self.operands], self.format, tables)
    }
}

impl Program {
    /// `inside` are the units' own.
    fn new(rtl: Arc<Rtl>, inside: &[Arc<Self>]) -> Self {
        let (netlist, schedule) = (rtl.netlist(), rtl.schedule());
        let (mut own, mut start) = (Vec::new(), Vec::new());
        for id in netlist.ids() {
            own.push(start.len());
            start.resize(start.len() + 1 + rtl.registers(id).count(), 0);
        }
        let mut program = Self {
            own,
            start,
            inputs: Vec::new(),
            steps: Vec::new(),
            units: Vec::new(),
            results: Vec::new(),
            moves: vec![Vec::new(); cast::index_of_u32(schedule.interval())],
            rtl: Arc::clone(&rtl),
        };
        for id in netlist.ids() {
            let (node, own) = (netlist.node(id), program.own[id.index()]);
            let mut edge = Vec::new();
            let registers = rtl.registers(id).count();
            edge.extend((own..own + registers).rev().map(|slot| (slot + 1, slot)));
            let phase = schedule.phase(schedule.stage(id));
            program.moves[cast::index_of_u32(phase)].extend(edge);
            let mut to = own;
            if schedule.is_clocked(netlist, id) {
                // A read takes a word at every edge.
                to = program.constant(0);
                program.moves.iter_mut().for_each(|moves| moves.push((own, to)));
            }
            if node.op == Op::Input {
                program.inputs.push(own);
            } else if let Op::Const { raw } = node.op {
                program.start[own] = raw;
            } else if rtl.is_free(id) {
                let mut of = [(own, Format::FLAG); 3];
                for (slot, operand) in of.iter_mut().zip(&node.operands) {
                    let signal = rtl.operand(id, *operand);
                    *slot = (program.slot(signal), netlist.node(*operand).format);
                }
                program.steps.push(Step {
                    node: id,
                    stage: schedule.stage(id),
                    op: node.op,
                    format: node.format,
                    of,
                    operands: node.operands.len(),
                    to,
                });
            }
            if let Some(result) = rtl.result(id) {
                let unit = &rtl.units()[result.unit].rtl;
                let hull = unit.netlist().outputs()[result.output].node;
                program.results.push(Taken {
                    unit: result.unit,
                    from: inside[result.unit].slot(unit.output(hull)),
                    right: result.right,
                    format: node.format,
                    to: own,
                });
            }
        }
        program.units = (0..rtl.units().len()).map(|unit| program.feeds(unit)).collect();
        program
    }

    fn feeds(&mut self, unit: usize) -> Feeds {
        let rtl = Arc::clone(&self.rtl);
        let mut feed = |case: &Case| match case.source {
            Source::Signal(signal) => (*case, self.slot(signal)),
            Source::Constant { raw, .. } => (*case, self.constant(raw)),
        };
        let phases = 0..rtl.schedule().interval();
        let mut at = |phase: u32| -> Vec<Option<(Case, usize)>> {
            let ports = rtl.units()[unit].ports.iter().map(|port| {
                let idle = (!port.registered).then_some(&port.cases[0]);
                port.case(phase).or(idle).map(&mut feed)
            });
            ports.collect()
        };
        let issued = |phase: u32| {
            let operations = rtl.operations(unit).iter();
            operations.map(|o| rtl.schedule().phase(o.issue)).position(|issue| issue == phase)
        };
        Feeds { ports: phases.clone().map(&mut at).collect(), issued: phases.map(issued).collect() }
    }

    /// A slot of its own that starts with a word.
    fn constant(&mut self, raw: i64) -> usize {
        self.start.push(raw);
        self.start.len() - 1
    }

    fn slot(&self, signal: Signal) -> usize {
        let (own, schedule) = (self.own[signal.node.index()], self.rtl.schedule());
        match signal.stage.checked_sub(schedule.stage(signal.node) + 1) {
            None => own,
            Some(after) => own + 1 + cast::index_of_u32(after / schedule.interval()),
        }
    }
}

impl Cycle {
    /// Hardware before the first edge, with all valid bits clear.
    #[must_use]
    pub fn new(rtl: Arc<Rtl>) -> Self {
        let units: Vec<UnitState> = rtl
            .units()
            .iter()
            .map(|unit| UnitState {
                inside: Self::new(Arc::clone(&unit.rtl)),
                ports: vec![0; unit.ports.len()],
                next: vec![0; unit.ports.len()],
                sits: vec![None; cast::index_of_u32(unit.rtl.schedule().latency()) + 1],
            })
            .collect();
        let inside: Vec<Arc<Program>> =
            units.iter().map(|unit| Arc::clone(&unit.inside.program)).collect();
        let control = Control {
            valid_in: false,
            valid: vec![false; cast::index_of_u32(rtl.valid_bits())],
            phase: 0,
            interval: rtl.schedule().interval(),
        };
        let program = Arc::new(Program::new(rtl, &inside));
        let words = program.start.clone();
        Self { program, words, control, units, edges: 0, forbidden: None }
    }

    /// Lets logic follow the input words; `valid` says whether they are data.
    ///
    /// # Errors
    /// If there is not one word of its format per input port.
    pub fn settle(&mut self, inputs: &[i64], valid: bool) -> Result<()> {
        self.program.rtl.netlist().check_words(inputs)?;
        self.follow(inputs, valid);
        Ok(())
    }

    /// As [`Cycle::settle`], of words that are in their formats.
    fn follow(&mut self, inputs: &[i64], valid: bool) {
        let Self { program, words, control, units, forbidden, .. } = self;
        control.valid_in = valid && control.ready();
        for (slot, word) in program.inputs.iter().zip(inputs) {
            words[*slot] = *word;
        }
        let tables = program.rtl.netlist().tables();
        for step in &program.steps {
            let (word, overflowed) = step.eval(words, tables);
            let error = overflowed && step.op.overflow() == Some(Overflow::Error);
            if error && control.is_data(step.stage) {
                forbidden.get_or_insert(step.node);
            }
            words[step.to] = word;
        }
        for (number, (state, feeds)) in units.iter_mut().zip(&program.units).enumerate() {
            if let Some(node) = state.settle(&program.rtl, number, feeds, words, control) {
                forbidden.get_or_insert(node);
            }
        }
        for result in &program.results {
            let word = units[result.unit].inside.words[result.from] >> result.right;
            words[result.to] = result.format.wrap(word);
        }
    }

    /// Takes a rising edge.
    pub fn clock(&mut self) {
        let Self { program, words, control, units, edges, .. } = self;
        for (to, from) in &program.moves[cast::index_of_u32(control.phase)] {
            words[*to] = words[*from];
        }
        for (state, unit) in units.iter_mut().zip(program.rtl.units()) {
            state.inside.clock();
            state.sits.rotate_right(1);
            state.sits[0] = None;
            for (at, port) in unit.ports.iter().enumerate() {
                if port.registered {
                    state.ports[at] = state.next[at];
                }
            }
        }
        if control.ready() && !control.valid.is_empty() {
            control.valid.rotate_right(1);
            control.valid[0] = control.valid_in;
        }
        control.valid_in = false;
        control.phase = (control.phase + 1) % control.interval;
        *edges += 1;
    }

    /// Clears the valid bits and the phase, as the reset does at an edge.
    pub fn reset(&mut self) {
        self.control.valid_in = false;
        self.control.valid.fill(false);
        self.control.phase = 0;
        for state in &mut self.units {
            state.inside.reset();
            state.sits.fill(None);
        }
    }

    /// The phase: cycles modulo the interval.
    #[must_use]
    pub fn phase(&self) -> u32 {
        self.control.phase
    }

    /// True in the phase in which inputs are taken.
    #[must_use]
    pub fn ready(&self) -> bool {
        self.control.ready()
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
        self.words[self.program.slot(signal)]
    }

    /// Where in [`Cycle::words`] a signal's word is, in every cycle.
    #[must_use]
    pub fn slot(&self, signal: Signal) -> usize {
        self.program.slot(signal)
    }

    /// The words of all signals.
    #[must_use]
    pub fn words(&self) -> &[i64] {
        &self.words
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
        self.control.valid(stage)
    }

    /// True in a cycle in which a stage works on data: valid, and in its phase.
    #[must_use]
    pub fn is_data(&self, stage: u32) -> bool {
        self.control.is_data(stage)
    }

    /// Words of the output ports, if they are valid: in one cycle for each sample.
    #[must_use]
    pub fn outputs(&self) -> Option<Vec<i64>> {
        let rtl = &self.program.rtl;
        let word = |node: NodeId| self.word(rtl.output(node));
        let outputs = rtl.netlist().outputs();
        self.is_data(rtl.schedule().latency())
            .then(|| outputs.iter().map(|output| word(output.node)).collect())
    }
}

impl UnitState {
    /// Lets a unit follow the words and valid bits around it. Gives the node of the netlist that
    /// overflowed and may not.
    fn settle(
        &mut self,
        rtl: &Rtl,
        number: usize,
        feeds: &Feeds,
        words: &[i64],
        control: &Control,
    ) -> Option<NodeId> {
        let phase = cast::index_of_u32(control.phase);
        for (at, (port, feed)) in
            rtl.units()[number].ports.iter().zip(&feeds.ports[phase]).enumerate()
        {
            let word = feed.map(|(case, slot)| case.shifted(words[slot]));
            if port.registered {
                self.next[at] = word.unwrap_or(self.ports[at]);
            } else if let Some(word) = word {
                self.ports[at] = word;
            }
        }
        let operations = rtl.operations(number);
        let issued = feeds.issued[phase].filter(|at| control.valid(operations[*at].issue));
        self.sits[0] = issued;
        self.inside.follow(&self.ports, issued.is_some());
        let inside = self.inside.forbidden.take()?;
        // The node of the operation that sits there.
        let stage = self.inside.program.rtl.schedule().stage(inside);
        let position = rtl.schedule().units()[number].positions[inside.index()]?;
        Some(operations[self.sits[cast::index_of_u32(stage)]?].nodes[position])
    }
}
