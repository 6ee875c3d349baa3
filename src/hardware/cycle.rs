//! Cycle-accurate simulation of the hardware, flat or time-shared.
//!
//! In each cycle [`Cycle::settle`] propagates inputs and registers through the logic, and
//! [`Cycle::clock`] applies the rising edge. The inputs of a rate are accepted in the phases given
//! by its interval ([`Cycle::ready_of`]). Registers are unknown until the first data reaches them;
//! only the valid bits, the delays and the phase counter have a reset, as in the emitted hardware.
//! Units are flat pipelines inside, so this same type simulates them.
//!
//! The work of a cycle is compiled once, into a `Program`: every word of the hardware is a slot of
//! one array, the logic is a list of operations from slots to slots, and the edge that ends a phase
//! is a list of slots that each load the word of another slot. A chain of registers moves word by
//! word: pipelines are so short that a ring buffer would cost more than it saves. Operations are
//! evaluated by [`Op::eval_raw`], their only definition. A cycle of the rotation unit takes 0.4 µs,
//! a quarter of the time of writing its wave.

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::hardware::rtl::{Case, Rtl, Signal, Source};
use crate::netlist::op::Op;
use crate::netlist::{NodeId, Table};
use crate::number::format::{Format, Overflow};
use crate::schedule::Operation;
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
    /// The first `narrow` under overflow mode `error` that overflowed on valid data.
    forbidden: Option<NodeId>,
    /// Scratch: the words that enter delays at an edge.
    taken: Vec<i64>,
}

/// Phase, and valid bits of all rates.
#[derive(Clone, Debug)]
struct Control {
    /// By rate, slowest first.
    rates: Vec<Valid>,
    phase: u32,
    phases: u32,
}

/// The valid bits of a rate.
#[derive(Clone, Debug)]
struct Valid {
    /// Stage in which the rate's words enter.
    entry: u32,
    interval: u32,
    /// The valid input, and the state of the valid bits.
    input: bool,
    bits: Vec<bool>,
}

/// State of a unit.
#[derive(Clone, Debug)]
struct UnitState {
    inside: Cycle,
    /// Words at the unit's ports; a port with a register holds its word.
    ports: Vec<i64>,
    /// The words that port registers load at the next edge.
    next: Vec<i64>,
    /// The operation in each stage of the unit, from the issue on; `None` where there is none or
    /// its data isn't valid.
    sits: Vec<Option<usize>>,
}

/// The compiled work of a cycle.
#[derive(Debug)]
struct Program {
    rtl: Arc<Rtl>,
    /// Slot of each node's word in its own stage; the slots of its hold registers follow.
    own: Vec<usize>,
    /// Words at the start: the constants, and 0 elsewhere.
    start: Vec<i64>,
    inputs: Vec<usize>,
    steps: Vec<Step>,
    units: Vec<Feeds>,
    results: Vec<Taken>,
    /// By phase: the loads at the edge that ends it, in order.
    moves: Vec<Vec<Move>>,
    delays: Vec<Delay>,
    /// Index of each node's rate among the rates of the ports.
    rates: Vec<usize>,
    /// A memory without words, which can't be read.
    unbound: Option<String>,
}

/// A slot that loads the word of another slot at an edge.
#[derive(Clone, Copy, Debug)]
struct Move {
    to: usize,
    from: usize,
    /// For a register that holds words for faster rates: the index of the rate that it waits for,
    /// and the stage in which that rate's sample must be data.
    when: Option<(usize, u32)>,
}

/// A delay: the words of earlier samples.
#[derive(Clone, Debug)]
struct Delay {
    stage: u32,
    rate: usize,
    /// Slot of the word that enters.
    from: usize,
    /// Slots from the newest word to the oldest, which is the node's own word.
    line: Vec<usize>,
}

/// An operation of a free node.
#[derive(Clone, Copy, Debug)]
struct Step {
    node: NodeId,
    stage: u32,
    op: Op,
    format: Format,
    /// Slots and formats of the operands.
    of: [(usize, Format); 3],
    operands: usize,
    /// Slot of the result; for a clocked read, the slot that is loaded from at the edge.
    to: usize,
}

/// The words that enter a unit.
#[derive(Debug)]
struct Feeds {
    /// By phase and port: the case and the slot of its word; `None` where a register keeps its
    /// word.
    ports: Vec<Vec<Option<(Case, usize)>>>,
    /// The operation issued in each phase.
    issued: Vec<Option<usize>>,
}

/// A node's word, taken from the output of a unit.
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
    fn ready(&self, rate: usize) -> bool {
        self.phase.is_multiple_of(self.rates[rate].interval)
    }

    fn valid(&self, rate: usize, stage: u32) -> bool {
        let Valid { entry, interval, input, bits } = &self.rates[rate];
        match stage.checked_sub(entry + 1) {
            None => *input && stage == *entry,
            Some(before) => {
                let bit = before / interval;
                bits.get(cast::index_of_u32(bit)).copied().unwrap_or(false)
            }
        }
    }

    fn is_data(&self, rate: usize, stage: u32) -> bool {
        let interval = self.rates[rate].interval;
        self.valid(rate, stage) && stage % interval == self.phase % interval
    }

    fn fastest(&self) -> usize {
        self.rates.len() - 1
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
    /// `inside` holds the programs of the units.
    fn new(rtl: Arc<Rtl>, inside: &[Arc<Self>]) -> Self {
        let (netlist, schedule) = (rtl.netlist(), rtl.schedule());
        let place = |id: NodeId| schedule.place_of(netlist.node(id).rate);
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
            moves: vec![Vec::new(); cast::index_of_u32(schedule.phases())],
            delays: Vec::new(),
            rates: netlist.ids().map(place).collect(),
            unbound: netlist.memories().find(|m| m.is_unbound()).map(|m| m.name.clone()),
            rtl: Arc::clone(&rtl),
        };
        for id in netlist.ids() {
            let (node, own) = (netlist.node(id), program.own[id.index()]);
            // Last register first: each loads its word before the register in front of it changes.
            let registers: Vec<Signal> = rtl.registers(id).collect();
            for (number, register) in registers.into_iter().enumerate().rev() {
                let (to, from) = (own + number + 1, own + number);
                let when =
                    rtl.holds(register).map(|rate| (schedule.place_of(rate), register.stage - 1));
                for phase in rtl.load_phases(register) {
                    program.moves[cast::index_of_u32(phase)].push(Move { to, from, when });
                }
            }
            let mut to = own;
            for _ in 0..schedule.clocks(netlist, id) {
                // A clocked read loads a word at every edge.
                let from = program.constant(0);
                let step = Move { to, from, when: None };
                program.moves.iter_mut().for_each(|moves| moves.push(step));
                to = from;
            }
            if let Op::Delay { samples } = node.op {
                let mut line: Vec<usize> = (1..samples).map(|_| program.constant(0)).collect();
                line.push(own);
                let from = program.slot(rtl.operand(id, node.operands[0]));
                let stage = schedule.stage(id);
                program.delays.push(Delay { stage, rate: place(id), from, line });
                continue;
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
        let (phases, interval) = (0..rtl.schedule().phases(), rtl.units()[unit].interval);
        let mut at = |phase: u32| -> Vec<Option<(Case, usize)>> {
            let ports = rtl.units()[unit].ports.iter().map(|port| {
                let idle = (!port.registered).then_some(&port.cases[0]);
                port.case(phase % interval).or(idle).map(&mut feed)
            });
            ports.collect()
        };
        let issued = |phase: u32| {
            let mut operations = rtl.operations(unit).iter();
            operations.position(|operation| operation.issue % interval == phase % interval)
        };
        Feeds { ports: phases.clone().map(&mut at).collect(), issued: phases.map(issued).collect() }
    }

    /// A new slot with an initial word.
    fn constant(&mut self, raw: i64) -> usize {
        self.start.push(raw);
        self.start.len() - 1
    }

    fn slot(&self, signal: Signal) -> usize {
        let own = self.own[signal.node.index()];
        if signal.stage == self.rtl.schedule().stage(signal.node) {
            return own;
        }
        let number = self.rtl.registers(signal.node).position(|register| register == signal);
        own + 1 + number.expect("bug: a register of the node")
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
        let timings = rtl.schedule().timings();
        let valid = timings.iter().map(|timing| Valid {
            entry: timing.entry,
            interval: timing.interval,
            input: false,
            bits: vec![false; cast::index_of_u32(rtl.valid_bits_of(timing))],
        });
        let control = Control { rates: valid.collect(), phase: 0, phases: rtl.schedule().phases() };
        let program = Arc::new(Program::new(rtl, &inside));
        let words = program.start.clone();
        Self { program, words, control, units, edges: 0, forbidden: None, taken: Vec::new() }
    }

    /// Propagates the input words through the logic; `valid` says whether they are data, at all
    /// rates.
    ///
    /// # Errors
    /// If `inputs` isn't one word per input port in the port's format, or a memory has no bound
    /// words.
    pub fn settle(&mut self, inputs: &[i64], valid: bool) -> Result<()> {
        self.settle_rates(inputs, |_| valid)
    }

    /// As [`Cycle::settle`], with a valid bit for each rate of the ports, counted from the slowest.
    ///
    /// # Errors
    /// As [`Cycle::settle`].
    pub fn settle_rates(&mut self, inputs: &[i64], valid: impl Fn(usize) -> bool) -> Result<()> {
        if let Some(memory) = &self.program.unbound {
            return Err(Error::unbound_memory(memory));
        }
        self.program.rtl.netlist().check_words(inputs)?;
        self.follow(inputs, valid);
        Ok(())
    }

    /// As [`Cycle::settle_rates`], for words that are known to fit their formats.
    fn follow(&mut self, inputs: &[i64], valid: impl Fn(usize) -> bool) {
        let Self { program, words, control, units, forbidden, .. } = self;
        let phase = control.phase;
        for (place, rate) in control.rates.iter_mut().enumerate() {
            rate.input = valid(place) && phase.is_multiple_of(rate.interval);
        }
        for (slot, word) in program.inputs.iter().zip(inputs) {
            words[*slot] = *word;
        }
        let tables = program.rtl.netlist().tables();
        for step in &program.steps {
            let (word, overflowed) = step.eval(words, tables);
            let error = overflowed && step.op.overflow() == Some(Overflow::Error);
            if error && control.is_data(program.rates[step.node.index()], step.stage) {
                forbidden.get_or_insert(step.node);
            }
            words[step.to] = word;
        }
        for (number, (state, feeds)) in units.iter_mut().zip(&program.units).enumerate() {
            if let Some(node) = state.settle(program, number, feeds, words, control) {
                forbidden.get_or_insert(node);
            }
        }
        for result in &program.results {
            let word = units[result.unit].inside.words[result.from] >> result.right;
            words[result.to] = result.format.wrap(word);
        }
    }

    /// Applies a rising edge.
    pub fn clock(&mut self) {
        let Self { program, words, control, units, edges, taken, .. } = self;
        // Delays load the words from before the edge, and registers load the delays' words from
        // before it.
        taken.clear();
        taken.extend(program.delays.iter().map(|delay| words[delay.from]));
        for Move { to, from, when } in &program.moves[cast::index_of_u32(control.phase)] {
            if when.is_none_or(|(rate, stage)| control.is_data(rate, stage)) {
                words[*to] = words[*from];
            }
        }
        for (delay, word) in program.delays.iter().zip(taken) {
            if control.is_data(delay.rate, delay.stage) {
                for pair in delay.line.windows(2).rev() {
                    words[pair[1]] = words[pair[0]];
                }
                words[delay.line[0]] = *word;
            }
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
        let phase = control.phase;
        for Valid { input, bits, interval, .. } in &mut control.rates {
            if phase.is_multiple_of(*interval) && !bits.is_empty() {
                bits.rotate_right(1);
                bits[0] = *input;
            }
            *input = false;
        }
        control.phase = (control.phase + 1) % control.phases;
        *edges += 1;
    }

    /// Clears the valid bits, the phase and the delays, as a reset does at an edge.
    pub fn reset(&mut self) {
        for rate in &mut self.control.rates {
            rate.input = false;
            rate.bits.fill(false);
        }
        for slot in self.program.delays.iter().flat_map(|delay| &delay.line) {
            self.words[*slot] = 0;
        }
        self.control.phase = 0;
        for state in &mut self.units {
            state.inside.reset();
            state.sits.fill(None);
        }
    }

    /// The phase: cycles modulo the number of phases.
    #[must_use]
    pub fn phase(&self) -> u32 {
        self.control.phase
    }

    /// True in a phase in which inputs of the fastest rate are accepted.
    #[must_use]
    pub fn ready(&self) -> bool {
        self.control.ready(self.control.fastest())
    }

    /// True in a phase in which inputs of a rate are accepted; rates of the ports count from the
    /// slowest.
    #[must_use]
    pub fn ready_of(&self, rate: usize) -> bool {
        self.control.ready(rate)
    }

    /// The operation on valid data in a stage of a unit. Stage 0 is the issue; the stage equal to
    /// the unit's latency is the output.
    #[must_use]
    pub fn sits(&self, unit: usize, stage: u32) -> Option<usize> {
        self.units[unit].sits[cast::index_of_u32(stage)]
    }

    /// Word at a port of a unit, after its register if it has one.
    #[must_use]
    pub fn port(&self, unit: usize, port: usize) -> i64 {
        self.units[unit].ports[port]
    }

    /// The simulation of a unit's inside.
    #[must_use]
    pub fn inside(&self, unit: usize) -> &Self {
        &self.units[unit].inside
    }

    /// Word of a signal; meaningless while it is not [known](Self::known).
    #[must_use]
    pub fn word(&self, signal: Signal) -> i64 {
        self.words[self.program.slot(signal)]
    }

    /// Index of a signal's word in [`Cycle::words`]; the same in every cycle.
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

    /// True if the sample of a rate that occupies this stage, in the stage's phase, is data; rates
    /// of the ports count from the slowest.
    #[must_use]
    pub fn valid(&self, rate: usize, stage: u32) -> bool {
        self.control.valid(rate, stage)
    }

    /// True in a cycle in which a stage works on data of the fastest rate: valid, and in its phase.
    #[must_use]
    pub fn is_data(&self, stage: u32) -> bool {
        self.control.is_data(self.control.fastest(), stage)
    }

    /// True in a cycle in which words of a rate of the ports are accepted.
    #[must_use]
    pub fn takes(&self, rate: usize) -> bool {
        self.control.rates[rate].input
    }

    /// Index of a node's rate among the rates of the ports.
    #[must_use]
    pub fn rate_of(&self, node: NodeId) -> usize {
        self.program.rates[node.index()]
    }

    /// Words of the output ports if they are valid, which is one cycle for each sample.
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
    /// Propagates the words and valid bits around a unit through it. Returns the netlist's node
    /// that overflowed although its overflow mode forbids it.
    fn settle(
        &mut self,
        program: &Program,
        number: usize,
        feeds: &Feeds,
        words: &[i64],
        control: &Control,
    ) -> Option<NodeId> {
        let rtl = &program.rtl;
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
        let is_data = |operation: &Operation| {
            control.valid(program.rates[operation.nodes[0].index()], operation.issue)
        };
        let issued = feeds.issued[phase].filter(|at| is_data(&operations[*at]));
        self.sits[0] = issued;
        self.inside.follow(&self.ports, |_| issued.is_some());
        let inside = self.inside.forbidden.take()?;
        // Map the node inside the unit to the node of the operation in that stage.
        let stage = self.inside.program.rtl.schedule().stage(inside);
        let position = rtl.schedule().units()[number].positions[inside.index()]?;
        Some(operations[self.sits[cast::index_of_u32(stage)]?].nodes[position])
    }
}
