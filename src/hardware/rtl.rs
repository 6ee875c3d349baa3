//! Registers, phases, units and multiplexers of the hardware, derived from netlist and schedule.
//!
//! A [`Signal`] is a node's word as seen in a stage. In the node's own stage it is the node's own
//! logic; in a later stage it is a *hold register*. With an interval of I cycles, hold register k
//! of a node in stage s loads at the edge that ends stage s + kI and holds its word for I cycles:
//! it is visible in stages s + 1 + kI to s + (k + 1)I, and is named after the first of them. (Where
//! a faster rate enters, a separate register begins, and from there on I is that rate's interval.)
//! With I = 1 the hold registers are a shift register; with several samples in flight they are the
//! delay FIFO. The cycle simulator, the waves and the emitted hardware all read this structure, so
//! they can't disagree.
//!
//! # Structure of hardware with an interval
//!
//! * **Phase.** A counter of [`Rtl::phase_bits`] bits cycles through the phases from reset on.
//!   Inputs of a rate with interval I are accepted only in phases that are 0 modulo I (the flag
//!   `ready`). The events of stage s happen in phases that are s modulo the interval of the stage's
//!   rate ([`Schedule::phases_of`](crate::schedule::Schedule::phases_of)).
//! * **Free nodes** ([`Rtl::is_free`]) are logic as in a flat pipeline; their operands are the
//!   signals of [`Rtl::operand`]. Their words are meaningful in the phase of their stage.
//! * **Hold registers** ([`Rtl::registers`]) load [`Rtl::held`] at the edges that end the phases
//!   [`Rtl::load_phases`]. The output register of a free clocked read has no enable: it is the read
//!   itself, and its word is held like any other.
//! * **Units** ([`Rtl::units`]) are flat pipelines of their own ([`Instance::rtl`]: interval 1, no
//!   enables) on hull formats. In each phase a port receives one of its [`Case`]s, extended to the
//!   port's format ([`shifted`](Case::left)). A port without a register is a plain multiplexer; in
//!   phases without a case it selects the first case. A port with a register loads the case at the
//!   edge that ends the phase, and keeps its word in all other phases.
//! * **Results.** The word of a node inside a unit ([`Rtl::result`]) is the unit's output with its
//!   low bits dropped and cut to the node's format. Only hold registers use it.
//! * **Delays** hold the words of earlier samples in registers that a reset clears. They load at
//!   the edge that ends the node's stage when its sample is data: [`Rtl::is_state`].
//! * **Rates.** Where a faster rate enters, all slower words are held for it: their registers load
//!   only when a sample of the next slower rate is data ([`Rtl::holds`]). So an object applies to
//!   the faces that come after it, and to their pixels, but not to those of the face before. Each
//!   rate has its own valid bits.
//! * **Memories** are outside the module and stall with the pipeline: a read's word arrives a fixed
//!   number of cycles after its address.
//! * **Valid.** Bit k of a rate's valid bits loads at the edges at which its inputs are accepted:
//!   bit 0 from `valid_in`, each other bit from the one before it. Stage s > 0 after the rate's
//!   entry holds data where bit (s - 1) / I is set. `valid_out` is that bit for the latency, in the
//!   phase of the latency: one cycle for each sample.

use crate::base::cast;
use crate::netlist::op::Op;
use crate::netlist::{Counts, Netlist, NodeId, Rate};
use crate::number::format::{Format, addr_bits};
use crate::schedule::{Kind, Operand, Operation, Schedule, Timing, Unit};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A node's word as seen in a stage; a hold register is named by the first stage that sees it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub struct Signal {
    /// The node.
    pub node: NodeId,
    /// The stage.
    pub stage: u32,
}

/// The hardware of a netlist.
#[derive(Clone, Debug)]
pub struct Rtl {
    netlist: Arc<Netlist>,
    schedule: Schedule,
    /// Last stage in which each node's word is needed.
    last: Vec<u32>,
    /// True for nodes that don't depend on any port.
    fixed: Vec<bool>,
    units: Vec<Instance>,
    /// Unit and output that give each node's word.
    results: Vec<Option<UnitOutput>>,
}

/// A unit, and the schedule of its operands.
#[derive(Clone, Debug)]
pub struct Instance {
    /// Name: `dot1`.
    pub name: String,
    /// The kind of unit.
    pub kind: Kind,
    /// Cycles from one sample of its operations' rate to the next: phases of cases are modulo this.
    pub interval: u32,
    /// Its own hardware: flat, on hull formats. Port i of [`Instance::ports`] is input i, and
    /// [`UnitOutput::output`] indexes its outputs.
    pub rtl: Arc<Rtl>,
    /// Its ports.
    pub ports: Vec<Port>,
}

/// A port of a unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// Its format.
    pub format: Format,
    /// Side of the unit that it belongs to, from 0: the operand index of the unit's node.
    pub side: usize,
    /// Index of the operation's operand that it receives.
    pub place: usize,
    /// True if a register loads the operand in the cycle before the issue.
    pub registered: bool,
    /// The sources by phase; at least one.
    pub cases: Vec<Case>,
}

/// The operand that a port receives in a phase.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Case {
    /// The phase of the issue, or of the load for a port with a register.
    pub phase: u32,
    /// Operation of the schedule's unit that the operand belongs to.
    pub operation: usize,
    /// Where the operand comes from.
    pub source: Source,
    /// Zeros appended below the source's bits to align it with the port's format. Above, the word
    /// is extended by its sign or by zeros.
    pub left: u32,
}

/// The source of an operand.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Source {
    /// A signal.
    Signal(Signal),
    /// A constant.
    Constant {
        /// The word.
        raw: i64,
        /// Its format.
        format: Format,
    },
}

/// The unit and output that give the word of a node.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct UnitOutput {
    /// Position of the unit in [`Rtl::units`].
    pub unit: usize,
    /// Index of the output.
    pub output: usize,
    /// Low bits of the output that are dropped; they are all 0 when the word is used. The rest is
    /// cut to the node's format.
    pub right: u32,
}

/// Resources that the hardware has.
#[derive(Clone, PartialEq, Eq, Debug, serde::Serialize)]
pub struct HardwareCounts {
    /// Operators and tables; those of each unit count once.
    pub operators: Counts,
    /// Operators of each unit, by its name.
    pub units: BTreeMap<String, Counts>,
    /// Bits of all hold registers.
    pub hold_bits: u64,
    /// The part of them in chains of two or more registers: delay FIFOs.
    pub fifo_bits: u64,
    /// Bits of the registers of delays, which keep words from sample to sample.
    #[serde(skip_serializing_if = "crate::netlist::is_zero")]
    pub state_bits: u64,
    /// Bits of operand registers at the ports of units.
    pub operand_bits: u64,
    /// Bits of registers inside units.
    pub unit_bits: u64,
    /// Bits of the phase counter.
    pub phase_bits: u64,
    /// Bits of all flip-flops, with valid bits and the output registers of clocked reads.
    pub register_bits: u64,
    /// Multiplexers in front of units, in bits of two-way selection: each source after the first at
    /// a port of b bits counts b.
    pub multiplexer_bits: u64,
}

/// An event of an operation, in a cycle of its sample.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Event {
    /// Stage: the cycle counted from the entry of the slowest rate.
    pub stage: u32,
    /// Position of the unit in [`Rtl::units`].
    pub unit: usize,
    /// Position of the operation in the unit.
    pub operation: usize,
    /// The kind of event.
    pub action: Action,
}

/// A kind of event.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Action {
    /// Operand registers of this side load a new word.
    Load(usize),
    /// The operation enters the unit.
    Issue,
    /// The result is at the unit's output.
    Out,
}

impl Rtl {
    /// Derives the registers.
    #[must_use]
    pub fn new(netlist: Arc<Netlist>, schedule: Schedule) -> Self {
        let mut last: Vec<u32> = netlist.ids().map(|id| schedule.stage(id)).collect();
        let mut see = |id: NodeId, at: u32| last[id.index()] = last[id.index()].max(at);
        for id in netlist.ids().filter(|id| schedule.seat(*id).is_none()) {
            let at = schedule.operand_stage(&netlist, id);
            for operand in &netlist.node(id).operands {
                see(*operand, at);
            }
        }
        for unit in schedule.units() {
            for port in &unit.ports {
                for operation in &unit.operations {
                    if let Operand::Node(id) = operation.operands[port.place] {
                        see(id, operation.issue - u32::from(port.registered));
                    }
                }
            }
        }
        for output in netlist.outputs() {
            last[output.node.index()] = schedule.latency();
        }
        // A constant is the same in every stage.
        for id in netlist.ids() {
            if matches!(netlist.node(id).op, Op::Const { .. }) {
                last[id.index()] = schedule.stage(id);
            }
        }
        let mut fixed: Vec<bool> = Vec::with_capacity(last.len());
        for node in netlist.nodes() {
            let moves = matches!(node.op, Op::Input | Op::Delay { .. });
            fixed.push(!moves && node.operands.iter().all(|operand| fixed[operand.index()]));
        }
        let mut rtl = Self {
            results: vec![None; netlist.nodes().len()],
            netlist,
            schedule,
            last,
            fixed,
            units: Vec::new(),
        };
        rtl.units = rtl.schedule.units().iter().map(|unit| rtl.instance(unit)).collect();
        for (number, unit) in rtl.schedule.units().iter().enumerate() {
            for operation in &unit.operations {
                for (output, position) in unit.exports.iter().enumerate() {
                    let node = operation.nodes[*position];
                    let own = rtl.netlist.node(node).format;
                    let hull = unit.netlist.node(unit.netlist.outputs()[output].node).format;
                    let right = (hull.frac_bits() - own.frac_bits()).unsigned_abs();
                    rtl.results[node.index()] = Some(UnitOutput { unit: number, output, right });
                }
            }
        }
        rtl
    }

    fn instance(&self, unit: &Unit) -> Instance {
        let hardware = Arc::new(Self::new(Arc::clone(&unit.netlist), unit.pipeline.clone()));
        let ports = unit.ports.iter().enumerate().map(|(number, port)| {
            let format = unit.netlist.node(unit.netlist.inputs()[number]).format;
            let operations = unit.operations.iter().enumerate();
            let cases = operations.filter_map(|(at, operation)| {
                if port.registered && self.is_loaded(unit, at, port.place) {
                    return None;
                }
                let stage = operation.issue - u32::from(port.registered);
                let (source, from) = match operation.operands[port.place] {
                    Operand::Node(id) => {
                        (Source::Signal(self.seen(id, stage)), self.netlist.node(id).format)
                    }
                    Operand::Constant { raw, format } => (Source::Constant { raw, format }, format),
                };
                let left = (format.frac_bits() - from.frac_bits()).unsigned_abs();
                Some(Case { phase: stage % unit.interval, operation: at, source, left })
            });
            let mut cases: Vec<Case> = cases.collect();
            cases.sort_by_key(|case| case.phase);
            Port { format, side: port.side, place: port.place, registered: port.registered, cases }
        });
        Instance {
            name: unit.name.clone(),
            kind: unit.kind,
            interval: unit.interval,
            ports: ports.collect(),
            rtl: hardware,
        }
    }

    /// True if the operand is already in the port's register: the previous operation issued there
    /// belongs to the same sample and has the same operand.
    fn is_loaded(&self, unit: &Unit, at: usize, place: usize) -> bool {
        let now = &unit.operations[at];
        // The operation with the latest issue before this one, of this sample or an earlier one.
        let interval = unit.interval;
        let before = unit.operations.iter().min_by_key(|other| {
            let ago = (now.issue + interval - other.issue % interval - 1) % interval;
            ago % interval
        });
        before.is_some_and(|before| {
            before.issue < now.issue
                && now.issue - before.issue < interval
                && before.operands[place] == now.operands[place]
        })
    }

    /// The datapath.
    #[must_use]
    pub fn netlist(&self) -> &Arc<Netlist> {
        &self.netlist
    }

    /// The schedule.
    #[must_use]
    pub fn schedule(&self) -> &Schedule {
        &self.schedule
    }

    /// The shared units, in the order of the schedule.
    #[must_use]
    pub fn units(&self) -> &[Instance] {
        &self.units
    }

    /// The operations of a unit, in order of issue.
    #[must_use]
    pub fn operations(&self, unit: usize) -> &[Operation] {
        &self.schedule.units()[unit].operations
    }

    /// Bits of the phase counter; 0 if there is only one phase.
    #[must_use]
    pub fn phase_bits(&self) -> u32 {
        addr_bits(u64::from(self.schedule.phases()))
    }

    /// True if a node has its own logic, outside any unit.
    #[must_use]
    pub fn is_free(&self, node: NodeId) -> bool {
        self.schedule.seat(node).is_none()
    }

    /// The unit's output that gives the word of a node. `None` for free nodes, and for nodes that
    /// are used only inside their unit and so have no signal here.
    #[must_use]
    pub fn result(&self, node: NodeId) -> Option<UnitOutput> {
        self.results[node.index()]
    }

    /// Hold registers of a node, in order of their stages. They don't include the output register
    /// of a clocked read, which is the read itself.
    pub fn registers(&self, node: NodeId) -> impl Iterator<Item = Signal> + '_ {
        let last = self.last[node.index()];
        let first = Some(self.schedule.stage(node) + 1);
        let stages =
            std::iter::successors(first, move |stage| Some(self.next_register(node, *stage)));
        stages.take_while(move |stage| *stage <= last).map(move |stage| Signal { node, stage })
    }

    /// Stage of the next register: an interval later, or where a faster rate enters.
    fn next_register(&self, node: NodeId, stage: u32) -> u32 {
        let (interval, until) = self.schedule.pace(&self.netlist, node, stage);
        until.map_or(stage + interval, |until| until.min(stage + interval))
    }

    /// The rate that a hold register waits for, where a faster rate enters: the register loads when
    /// that rate's samples are data. A node that doesn't depend on any port waits for none.
    #[must_use]
    pub fn holds(&self, register: Signal) -> Option<Rate> {
        let waits = !self.fixed[register.node.index()];
        waits.then(|| self.schedule.hold(&self.netlist, register.node, register.stage))?
    }

    /// True for a delay, whose word in its own stage is a register.
    #[must_use]
    pub fn is_state(&self, node: NodeId) -> bool {
        matches!(self.netlist.node(node).op, Op::Delay { .. })
    }

    /// The phases at whose ends a hold register loads.
    ///
    /// # Panics
    /// If the signal is no register.
    pub fn load_phases(&self, register: Signal) -> impl Iterator<Item = u32> + use<> {
        assert!(register.stage > self.schedule.stage(register.node), "bug: no register");
        let before = register.stage - 1;
        let (interval, _) = self.schedule.pace(&self.netlist, register.node, before);
        self.schedule.phases_of(before, interval)
    }

    /// The source of a hold register: the node's own word, or the register before it.
    ///
    /// # Panics
    /// If the signal is no register.
    #[must_use]
    pub fn held(&self, register: Signal) -> Signal {
        assert!(register.stage > self.schedule.stage(register.node), "bug: no register");
        self.seen(register.node, register.stage - 1)
    }

    /// The signal of a node's word in a stage at or after its own; a constant is seen in its own
    /// stage.
    ///
    /// # Panics
    /// If the stage is before the node's own.
    #[must_use]
    pub fn seen(&self, node: NodeId, stage: u32) -> Signal {
        let own = self.schedule.stage(node);
        if stage == own || matches!(self.netlist.node(node).op, Op::Const { .. }) {
            return Signal { node, stage: own };
        }
        assert!(stage > own, "bug: a word is seen from its stage on");
        let mut register = own + 1;
        loop {
            // Within one pace, registers are an interval apart.
            let (interval, until) = self.schedule.pace(&self.netlist, node, register);
            let reached = until.map_or(stage, |until| stage.min(until - 1));
            register += (reached - register) / interval * interval;
            match until {
                Some(until) if until <= stage => register = until,
                Some(_) | None => return Signal { node, stage: register },
            }
        }
    }

    /// The signal of an operand of a free `user`.
    #[must_use]
    pub fn operand(&self, user: NodeId, operand: NodeId) -> Signal {
        self.seen(operand, self.schedule.operand_stage(&self.netlist, user))
    }

    /// The signal behind an output port.
    #[must_use]
    pub fn output(&self, node: NodeId) -> Signal {
        self.seen(node, self.schedule.latency())
    }

    /// Name of a signal in its scope, as used in the waves and the emitted hardware. It is the
    /// node's own name or number; `_next` is appended where the node's output port is a register
    /// and has that name; a hold register appends its stage.
    #[must_use]
    pub fn local_name(&self, signal: Signal) -> String {
        let node = self.netlist.node(signal.node);
        let at_root = self.netlist.scope_path(node.scope).is_empty();
        let is_port = |name: &str| self.netlist.outputs().iter().any(|output| output.name == name);
        let name = match &node.name {
            Some(name) if at_root && node.op != Op::Input && is_port(name) => {
                format!("{name}_next")
            }
            Some(name) => name.clone(),
            None => format!("n{}", signal.node.index()),
        };
        if signal.stage == self.schedule.stage(signal.node) {
            name
        } else {
            format!("{name}_s{}", signal.stage)
        }
    }

    /// Valid bits of all rates: one for each interval that a sample is in flight.
    #[must_use]
    pub fn valid_bits(&self) -> u32 {
        self.schedule.timings().iter().map(|timing| self.valid_bits_of(timing)).sum()
    }

    /// Valid bits of a rate, up to the last one that is used.
    #[must_use]
    pub fn valid_bits_of(&self, timing: &Timing) -> u32 {
        let fastest = timing.entry + timing.latency == self.schedule.latency();
        let last = if fastest {
            timing.latency
        } else {
            let held = self.netlist.ids().flat_map(|id| self.registers(id));
            let held = held.filter(|register| self.holds(*register) == Some(timing.rate));
            held.map(|register| register.stage - 1 - timing.entry).max().unwrap_or(0)
        };
        last.div_ceil(timing.interval)
    }

    /// Loads, issues and outputs of the units, in order of time.
    #[must_use]
    pub fn events(&self) -> Vec<Event> {
        let mut events = Vec::new();
        for (number, (unit, instance)) in self.schedule.units().iter().zip(&self.units).enumerate()
        {
            for (at, operation) in unit.operations.iter().enumerate() {
                let mut add = |stage: u32, action: Action| {
                    events.push(Event { stage, unit: number, operation: at, action });
                };
                let loads = |port: &&Port| {
                    port.registered && port.cases.iter().any(|case| case.operation == at)
                };
                let mut sides: Vec<usize> =
                    instance.ports.iter().filter(loads).map(|port| port.side).collect();
                sides.sort_unstable();
                sides.dedup();
                sides.into_iter().for_each(|side| add(operation.issue - 1, Action::Load(side)));
                add(operation.issue, Action::Issue);
                add(operation.issue + unit.latency(), Action::Out);
            }
        }
        events.sort_by_key(|event| (event.stage, event.unit));
        events
    }

    /// Bits of a delay's registers.
    fn state_bits(&self, id: NodeId) -> u64 {
        let node = self.netlist.node(id);
        let Op::Delay { samples } = node.op else { return 0 };
        u64::from(samples) * u64::from(node.format.bits())
    }

    /// Bits of data registers: all but the valid bits and the phase counter.
    pub(crate) fn data_bits(&self) -> u64 {
        let of = |id: NodeId| {
            // A memory has its own registers.
            let row =
                self.schedule.is_clocked(&self.netlist, id) && self.netlist.memory(id).is_none();
            let copies = cast::count_of(self.registers(id).count()) + u64::from(row);
            u64::from(self.netlist.node(id).format.bits()) * copies + self.state_bits(id)
        };
        let own: u64 = self.netlist.ids().map(of).sum();
        own + self.units.iter().map(|unit| unit.operand_bits() + unit.rtl.data_bits()).sum::<u64>()
    }

    /// Flip-flops: bits of all registers, including those of clocked reads, valid bits, the phase
    /// counter and the units.
    #[must_use]
    pub fn register_bits(&self) -> u64 {
        self.data_bits() + u64::from(self.valid_bits()) + u64::from(self.phase_bits())
    }

    /// Counts the resources of the hardware; shared ones count once.
    #[must_use]
    pub fn counts(&self) -> HardwareCounts {
        let bits = |node: NodeId, registers: usize| {
            u64::from(self.netlist.node(node).format.bits()) * cast::count_of(registers)
        };
        let chains = || self.netlist.ids().map(|id| (id, self.registers(id).count()));
        let units = self.units.iter().map(|unit| (unit.name.clone(), unit.rtl.netlist.counts()));
        let mut parts: Vec<(&Netlist, &dyn Fn(NodeId) -> bool)> = Vec::new();
        let (free, all) = (|id| self.is_free(id), |_| true);
        parts.push((&self.netlist, &free));
        for unit in &self.units {
            parts.push((&unit.rtl.netlist, &all));
        }
        let multiplexed = self.units.iter().flat_map(|unit| &unit.ports);
        HardwareCounts {
            operators: Netlist::counts_over(&parts),
            units: units.collect(),
            hold_bits: chains().map(|(id, registers)| bits(id, registers)).sum(),
            fifo_bits: chains()
                .filter(|(_, registers)| *registers > 1)
                .map(|(id, registers)| bits(id, registers))
                .sum(),
            state_bits: self.netlist.ids().map(|id| self.state_bits(id)).sum(),
            operand_bits: self.units.iter().map(Instance::operand_bits).sum(),
            unit_bits: self.units.iter().map(|unit| unit.rtl.data_bits()).sum(),
            phase_bits: u64::from(self.phase_bits()),
            register_bits: self.register_bits(),
            multiplexer_bits: multiplexed
                .map(|port| u64::from(port.format.bits()) * (port.sources() - 1))
                .sum(),
        }
    }
}

impl Instance {
    /// Bits of the registers at its ports.
    #[must_use]
    pub fn operand_bits(&self) -> u64 {
        let registered = self.ports.iter().filter(|port| port.registered);
        registered.map(|port| u64::from(port.format.bits())).sum()
    }
}

impl Port {
    /// Number of distinct words that it selects from.
    fn sources(&self) -> u64 {
        let fresh = |(at, case): &(usize, &Case)| {
            self.cases[..*at].iter().all(|other| other.source != case.source)
        };
        cast::count_of(self.cases.iter().enumerate().filter(fresh).count())
    }

    /// The case of a phase.
    #[must_use]
    pub fn case(&self, phase: u32) -> Option<&Case> {
        self.cases.iter().find(|case| case.phase == phase)
    }
}

impl Case {
    /// A source's word, aligned to the port.
    #[must_use]
    pub fn shifted(&self, raw: i64) -> i64 {
        raw << self.left
    }
}
