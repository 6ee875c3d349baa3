//! When and where each node computes: a map from nodes to cycles and, for shared operations, to
//! units.
//!
//! A *stage* is a cycle counted from the sample's entry. Stage 0 works on the input ports (of the
//! slowest rate); output ports are registers at the stage that equals the *latency*. (Printed
//! schedules count from 1.) A new sample may enter every *interval* cycles. Flat pipelining has an
//! interval of 1 and no sharing: there is a register between stages s and s + 1. A schedule never
//! edits the netlist. It is derived from the delay model below and a target period
//! ([`Schedule::pipeline`]), from given stages ([`Schedule::from_stages`]), from numbers of units
//! ([`Schedule::shared`]), or from given units and cycles ([`Schedule::bound`]).
//!
//! # Rates
//!
//! Ports may have several [rates](Rate). Stages are counted from the entry of the slowest rate.
//! Nodes of a slow rate are computed first and held where the next faster rate enters
//! ([`Schedule::entry`], [`Schedule::hold`]). From there their words accompany each faster sample,
//! like the words of a port. So a slow word applies to every sample of the next faster rate that
//! enters [`Timing::latency`] cycles later or after, until the next slow word is held, and to the
//! even faster samples that go with those. Each rate has its own interval, a multiple of the next
//! faster rate's, so slow operations can share units over a longer time.
//!
//! # Sharing
//!
//! [`share`] decides which operations can share a unit and builds the unit's hardware; [`place`]
//! finds the cycles. A unit accepts one operation per cycle, at its *issue*, and gives the result
//! *latency* cycles later, at its *out*, which is the stage of the operation's nodes. The unit's
//! inner nodes are spread over the latency as evenly as the delay model allows; a latency of 0 is
//! combinational. Operands arrive through a multiplexer at the issue, or in operand registers
//! (*loads*) in the cycle before. **A unit's output is used only from hold registers, from out + 1
//! on**, so sharing can't create a combinational loop.
//!
//! # Delay model
//!
//! Approximate figures for a mid-range FPGA, in ps. They place registers and don't predict the
//! clock, which depends on synthesis and routing:
//!
//! | operation | delay |
//! |---|---|
//! | wires: slice, concat, shift, modulo, narrow that only drops bits | 0 |
//! | and, or, xor, mux | 500 |
//! | add, sub, addsub, neg, abs, equal, less | 600 + 25 a bit |
//! | narrow: rounding / saturation | 600 + 25 a bit / 600 more |
//! | mul | 1500 + 50 a bit of both operands |
//! | leading_zeros, shift_left | 450 a level, log2 of the bits or places |
//! | table read without a clock | 700 + 350 an address bit past 6 |
//! | table read with a clock, memory | 400 before the edge, 1800 after it |
//! | register, clock to output and set-up | 500 |

pub mod place;
pub mod share;

pub use place::{Binding, BoundOperation, BoundUnit, Load, Plan, Share};
pub use share::{Kind, Operand, Operation, Unit, UnitPort, name_of};

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::netlist::op::{Logic, Op};
use crate::netlist::{Netlist, NodeId, Rate};
use crate::number::format::{Narrowing, addr_bits};

const REGISTER_PS: u32 = 500;
const ROM_SETUP_PS: u32 = 400;
const ROM_OUTPUT_PS: u32 = 1800;

/// How tables are read.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Rom {
    /// On a clock edge, as in block RAM: the word arrives a stage later.
    Block,
    /// Without a clock, as in distributed logic.
    Distributed,
}

/// How deeply to pipeline.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Depth {
    /// As many stages as this period in ps needs.
    Period(u32),
    /// This latency in cycles; 0 is combinational.
    Stages(u32),
}

/// The stage of each node, the latency, the intervals, and the shared units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Schedule {
    stages: Vec<u32>,
    /// The rates of the ports, slowest first.
    entries: Vec<Entry>,
    latency: u32,
    period_ps: u32,
    rom: Rom,
    units: Vec<Unit>,
    /// For each unit the number of its group; units of a group serve operations of the same
    /// structure.
    same: Vec<usize>,
    /// For each node, its unit and its operation there.
    seated: Vec<Option<(usize, usize)>>,
}

/// The entry of a port rate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(in crate::schedule) struct Entry {
    rate: Rate,
    /// Stage in which its words enter.
    stage: u32,
    /// Cycles from one sample to the next.
    interval: u32,
}

/// When the words of a rate enter, and when they take effect.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Timing {
    /// The rate.
    pub rate: Rate,
    /// Stage in which its words enter.
    pub entry: u32,
    /// Cycles until words of the next faster rate that use them may enter; for the fastest rate,
    /// until the outputs.
    pub latency: u32,
    /// Minimum cycles between two of its words.
    pub interval: u32,
}

impl Schedule {
    /// Places each node as early as the delay model allows.
    ///
    /// # Errors
    /// If the requested latency is too short for tables that are read on a clock.
    pub fn pipeline(netlist: &Netlist, rom: Rom, depth: Depth) -> Result<Self> {
        match depth {
            Depth::Period(period_ps) => Ok(Self::greedy(netlist, rom, period_ps)),
            Depth::Stages(0) if netlist.memories().next().is_some() => Err(Error::parameter_value(
                "stages",
                "0",
                "1 or more: the words of a memory arrive on a clock edge".to_owned(),
            )),
            Depth::Stages(0) if netlist.rates().len() > 1 => Err(Error::parameter_value(
                "stages",
                "0",
                "1 or more: words of slower rates are held in registers".to_owned(),
            )),
            Depth::Stages(0) if netlist.first_delay().is_some() => Err(Error::parameter_value(
                "stages",
                "0",
                "1 or more: a delay consists of registers".to_owned(),
            )),
            Depth::Stages(0) if rom == Rom::Block && !netlist.tables().is_empty() => {
                Err(Error::parameter_value(
                    "stages",
                    "0",
                    "1 or more with rom=block, or rom=distributed".to_owned(),
                ))
            }
            Depth::Stages(0) => {
                let mut whole = Self::greedy(netlist, rom, u32::MAX);
                whole.latency = 0;
                Ok(whole)
            }
            Depth::Stages(stages) => {
                let most = Self::greedy(netlist, rom, u32::MAX);
                if most.latency > stages {
                    return Err(Error::parameter_value(
                        "stages",
                        &stages.to_string(),
                        if netlist.rates().len() > 1 || netlist.memories().next().is_some() {
                            let least = most.latency;
                            format!(
                                "{least} or more: clocked reads, memories and held words need that many"
                            )
                        } else {
                            format!(
                                "{} or more: the longest chain of clocked reads needs that many",
                                most.latency
                            )
                        },
                    ));
                }
                // The shortest period that this latency reaches. A longer period never needs more
                // stages.
                let (mut short, mut long) = (0, most.period_ps);
                while long - short > 1 {
                    let middle = short + (long - short) / 2;
                    if Self::greedy(netlist, rom, middle).latency <= stages {
                        long = middle;
                    } else {
                        short = middle;
                    }
                }
                let mut best = Self::greedy(netlist, rom, long);
                best.latency = stages;
                Ok(best)
            }
        }
    }

    /// Makes a schedule from given stages.
    ///
    /// # Errors
    /// If a node comes before its operands, or an output after the latency.
    pub fn from_stages(
        netlist: &Netlist,
        rom: Rom,
        stages: Vec<u32>,
        latency: u32,
    ) -> Result<Self> {
        let entry = |rate| Entry { rate, stage: 0, interval: 1 };
        let entries = netlist.rates().into_iter().map(entry).collect();
        let mut schedule = Self::flat(stages, entries, latency, 0, rom);
        schedule.verify(netlist)?;
        schedule.period_ps = schedule.longest_ps(netlist) + REGISTER_PS;
        Ok(schedule)
    }

    /// Stage of a node.
    #[must_use]
    pub fn stage(&self, id: NodeId) -> u32 {
        self.stages[id.index()]
    }

    /// Stage in which a node uses its operands: earlier than its own for a clocked read or a read
    /// of a memory.
    #[must_use]
    pub fn operand_stage(&self, netlist: &Netlist, id: NodeId) -> u32 {
        self.stage(id) - self.clocks(netlist, id)
    }

    /// True for a clocked read or a read of a memory; false inside a unit, which handles its own
    /// clocks.
    #[must_use]
    pub fn is_clocked(&self, netlist: &Netlist, id: NodeId) -> bool {
        self.clocks(netlist, id) > 0
    }

    /// Cycles from a node's operands to its word: 0 except for clocked reads and reads of
    /// memories.
    #[must_use]
    pub fn clocks(&self, netlist: &Netlist, id: NodeId) -> u32 {
        if self.seat(id).is_some() { 0 } else { clocks(netlist, self.rom, id) }
    }

    /// Stage in which the words of a rate enter.
    #[must_use]
    pub fn entry(&self, rate: Rate) -> u32 {
        self.entries[self.place_of(rate)].stage
    }

    /// The rate whose valid bit a node's word waits for in the register at the start of a stage. In
    /// that stage a faster rate enters, and the word applies to its samples once the previous
    /// rate's sample is valid. `None` in other stages.
    #[must_use]
    pub fn hold(&self, netlist: &Netlist, id: NodeId, stage: u32) -> Option<Rate> {
        let own = self.place_of(netlist.node(id).rate);
        let mut pairs = self.entries[own..].windows(2);
        pairs.find(|pair| pair[1].stage == stage).map(|pair| pair[0].rate)
    }

    /// Index among the rates of the ports. A slower rate, such as a constant's, maps to the
    /// slowest.
    pub(crate) fn place_of(&self, rate: Rate) -> usize {
        place_in(self.entries.iter().map(|entry| entry.rate), rate)
    }

    /// The interval of a node's words from a stage on, and the stage up to which it holds: there a
    /// faster rate enters.
    #[must_use]
    pub fn pace(&self, netlist: &Netlist, id: NodeId, stage: u32) -> (u32, Option<u32>) {
        let own = self.place_of(netlist.node(id).rate);
        let faster = self.entries.iter().skip(own + 1);
        let entered = faster.clone().take_while(|entry| entry.stage <= stage).last();
        let until = faster.map(|entry| entry.stage).find(|entry| *entry > stage);
        (entered.unwrap_or(&self.entries[own]).interval, until)
    }

    /// Timing of the fastest rate.
    #[must_use]
    pub fn fastest(&self) -> Timing {
        let mut timings = self.timings();
        timings.swap_remove(timings.len() - 1)
    }

    /// Timing of each rate, slowest first.
    #[must_use]
    pub fn timings(&self) -> Vec<Timing> {
        let ends = self.entries.iter().skip(1).map(|entry| entry.stage).chain([self.latency]);
        let timing = |(&Entry { rate, stage, interval }, end): (&Entry, u32)| Timing {
            rate,
            entry: stage,
            latency: end - stage,
            interval,
        };
        self.entries.iter().zip(ends).map(timing).collect()
    }

    /// Cycles from inputs to outputs.
    #[must_use]
    pub fn latency(&self) -> u32 {
        self.latency
    }

    /// The period that the slowest stage needs in the delay model, in ps.
    #[must_use]
    pub fn period_ps(&self) -> u32 {
        self.period_ps
    }

    /// How tables are read.
    #[must_use]
    pub fn rom(&self) -> Rom {
        self.rom
    }

    /// Cycles between samples of the fastest rate.
    #[must_use]
    pub fn interval(&self) -> u32 {
        self.entries.last().map_or(1, |entry| entry.interval)
    }

    /// Number of phases: cycles between samples of the slowest rate.
    #[must_use]
    pub fn phases(&self) -> u32 {
        self.entries.first().map_or(1, |entry| entry.interval)
    }

    /// The phases in which a stage has a sample of a rate with this interval.
    pub fn phases_of(&self, stage: u32, interval: u32) -> impl Iterator<Item = u32> + use<> {
        let step = cast::index_of(i64::from(interval));
        (stage % interval..self.phases()).step_by(step)
    }

    /// The shared units.
    #[must_use]
    pub fn units(&self) -> &[Unit] {
        &self.units
    }

    /// Index of the unit that a node belongs to, and of its operation there.
    #[must_use]
    pub fn seat(&self, id: NodeId) -> Option<(usize, usize)> {
        self.seated[id.index()]
    }

    /// A schedule without sharing.
    fn flat(stages: Vec<u32>, entries: Vec<Entry>, latency: u32, period_ps: u32, rom: Rom) -> Self {
        let seated = vec![None; stages.len()];
        Self {
            stages,
            entries,
            latency,
            period_ps,
            rom,
            units: Vec::new(),
            same: Vec::new(),
            seated,
        }
    }

    pub(in crate::schedule) fn greedy(netlist: &Netlist, rom: Rom, period_ps: u32) -> Self {
        let available = period_ps.saturating_sub(REGISTER_PS);
        let mut stages = vec![0; netlist.nodes().len()];
        let mut arrivals = vec![0; netlist.nodes().len()];
        let mut longest = 0;
        let mut entries = Entries::new(netlist, vec![1; netlist.rates().len()]);
        while let Some(place) = entries.next(&stages) {
            for id in netlist.ids().filter(|id| entries.of(*id) == place) {
                let from = entries.now();
                let placed = Free::after(netlist, rom, available, id, from, |operand| {
                    if entries.of(operand) < place {
                        (from, 0)
                    } else {
                        (stages[operand.index()], arrivals[operand.index()])
                    }
                });
                longest = longest.max(placed.longest_ps);
                stages[id.index()] = placed.stage;
                arrivals[id.index()] = placed.arrival_ps;
            }
        }
        let latency = entries.latency(&stages);
        Self::flat(stages, entries.done(), latency, longest.saturating_add(REGISTER_PS), rom)
    }

    /// The longest path between registers.
    fn longest_ps(&self, netlist: &Netlist) -> u32 {
        let mut arrivals: Vec<u32> = Vec::with_capacity(netlist.nodes().len());
        let mut longest = 0;
        for id in netlist.ids() {
            let at = self.operand_stage(netlist, id);
            let operands = netlist.node(id).operands.iter();
            let start = operands
                .filter(|operand| self.stage(**operand) == at)
                .map(|operand| arrivals[operand.index()])
                .max()
                .unwrap_or(0);
            if self.is_clocked(netlist, id) {
                longest = longest.max(start + ROM_SETUP_PS);
                arrivals.push(ROM_OUTPUT_PS);
            } else {
                arrivals.push(start + delay_ps(netlist, id));
            }
            longest = longest.max(arrivals[id.index()]);
        }
        longest
    }

    fn verify(&self, netlist: &Netlist) -> Result<()> {
        if self.entries.len() > 1 {
            let problem = "given stages need ports of a single rate".to_owned();
            return Err(Error::node(netlist.name().to_owned(), problem));
        }
        if self.stages.len() != netlist.nodes().len() {
            let problem =
                format!("{} stages for {} nodes", self.stages.len(), netlist.nodes().len());
            return Err(Error::node(netlist.name().to_owned(), problem));
        }
        for id in netlist.ids() {
            let bad = |problem: String| Err(Error::node(netlist.label(id), problem));
            let node = netlist.node(id);
            if self.stage(id) < self.clocks(netlist, id) {
                let clocks = self.clocks(netlist, id);
                return bad(format!(
                    "its word takes {clocks} cycles: it can't be in an earlier stage"
                ));
            }
            if node.op == Op::Input && self.stage(id) != 0 {
                return bad("input ports must be in stage 0".to_owned());
            }
            for operand in &node.operands {
                if self.stage(*operand) > self.operand_stage(netlist, id) {
                    return bad(format!(
                        "stage {} is before its operand `{}` in stage {}",
                        self.stage(id),
                        netlist.label(*operand),
                        self.stage(*operand)
                    ));
                }
            }
        }
        for output in netlist.outputs() {
            if self.stage(output.node) > self.latency {
                let problem = format!("is ready after the latency of {}", self.latency);
                return Err(Error::node(output.name.clone(), problem));
            }
        }
        Ok(())
    }
}

/// Cycles from the operands to the word, for a node that isn't in a unit.
fn clocks(netlist: &Netlist, rom: Rom, id: NodeId) -> u32 {
    match netlist.memory(id) {
        Some(memory) => memory.latency,
        None => u32::from(rom == Rom::Block && matches!(netlist.node(id).op, Op::Read { .. })),
    }
}

/// Index of a rate among those of the ports, slowest first.
fn place_in(mut rates: impl ExactSizeIterator<Item = Rate>, rate: Rate) -> usize {
    let last = rates.len().saturating_sub(1);
    rates.position(|known| known >= rate).unwrap_or(last)
}

/// Index of each node's rate among those of the ports.
fn places(netlist: &Netlist) -> Vec<usize> {
    let rates = netlist.rates();
    netlist.nodes().iter().map(|node| place_in(rates.iter().copied(), node.rate)).collect()
}

/// The rates of a netlist's ports, slowest first, with their entry stages, which are found one
/// after the other.
struct Entries<'a> {
    netlist: &'a Netlist,
    rates: Vec<Rate>,
    intervals: Vec<u32>,
    found: Vec<Entry>,
    /// Index of each node's rate.
    of: Vec<usize>,
    /// Nodes whose words are held for a faster rate.
    held: Vec<bool>,
}

impl<'a> Entries<'a> {
    /// Starts before the first rate, with the interval of each rate.
    fn new(netlist: &'a Netlist, intervals: Vec<u32>) -> Self {
        let (rates, of) = (netlist.rates(), places(netlist));
        let mut held = vec![false; of.len()];
        for id in netlist.ids() {
            for operand in &netlist.node(id).operands {
                held[operand.index()] |= of[operand.index()] < of[id.index()];
            }
        }
        // Outputs have a word for each sample of the fastest rate.
        for output in netlist.outputs() {
            held[output.node.index()] |= of[output.node.index()] + 1 < rates.len();
        }
        Self { netlist, rates, intervals, found: Vec::new(), of, held }
    }

    /// Advances to the next rate, which enters once everything that is held for it is ready;
    /// returns its index.
    fn next(&mut self, stages: &[u32]) -> Option<usize> {
        let place = self.found.len();
        let rate = *self.rates.get(place)?;
        let held = self.netlist.ids().filter(|id| {
            let constant = matches!(self.netlist.node(*id).op, Op::Const { .. });
            self.held[id.index()] && self.of[id.index()] < place && !constant
        });
        let ready = held.map(|id| stages[id.index()] + 1).max().unwrap_or(0);
        let interval = self.intervals[place];
        // Enter after the previous rate, whose valid bit decides which slower words go with a
        // sample.
        let after = self.found.last().map_or(0, |entry| entry.stage + 1);
        let stage = ready.max(after).next_multiple_of(interval);
        self.found.push(Entry { rate, stage, interval });
        Some(place)
    }

    /// Index of a node's rate.
    fn of(&self, id: NodeId) -> usize {
        self.of[id.index()]
    }

    /// The entry stage of the latest rate.
    fn now(&self) -> u32 {
        self.found.last().map_or(0, |entry| entry.stage)
    }

    /// An output port is a register: a stage's result appears after the stage.
    fn latency(&self, stages: &[u32]) -> u32 {
        let outputs = self.netlist.outputs().iter();
        let last = outputs.map(|output| stages[output.node.index()]).max().unwrap_or(0);
        last.max(self.now()) + 1
    }

    fn done(self) -> Vec<Entry> {
        self.found
    }
}

/// The place of a node that isn't in a unit.
struct Free {
    stage: u32,
    /// Arrival of its word, from the start of its stage.
    arrival_ps: u32,
    /// The longest path that ends at it.
    longest_ps: u32,
}

impl Free {
    /// Places the node as early as its operands' stages and arrivals and the time between registers
    /// allow, but not before stage `from`.
    fn after(
        netlist: &Netlist,
        rom: Rom,
        available_ps: u32,
        id: NodeId,
        from: u32,
        operand: impl Fn(NodeId) -> (u32, u32),
    ) -> Self {
        let node = netlist.node(id);
        let (mut stage, mut arrival) = (from, 0);
        for (s, a) in node.operands.iter().map(|id| operand(*id)) {
            if s > stage {
                (stage, arrival) = (s, a);
            } else if s == stage {
                arrival = arrival.max(a);
            }
        }
        let clocks = clocks(netlist, rom, id);
        let delay = if clocks > 0 { ROM_SETUP_PS } else { delay_ps(netlist, id) };
        // A path that starts at a register may take as long as it must: it can't be shortened.
        if arrival > 0 && delay > 0 && arrival.saturating_add(delay) > available_ps {
            (stage, arrival) = (stage + 1, 0);
        }
        arrival += delay;
        let mut longest = arrival;
        if clocks > 0 {
            (stage, arrival) = (stage + clocks, ROM_OUTPUT_PS);
            longest = longest.max(arrival);
        }
        Self { stage, arrival_ps: arrival, longest_ps: longest }
    }
}

/// Delay of an operation without a clock, from the table in the module's documentation.
#[must_use]
pub fn delay_ps(netlist: &Netlist, id: NodeId) -> u32 {
    let node = netlist.node(id);
    let carry = |bits: u32| 600 + 25 * bits;
    let levels = |n: u32| 450 * addr_bits(u64::from(n.max(2)));
    let operand = |i: usize| netlist.node(node.operands[i]).format;
    match node.op.traits().logic {
        Logic::Wires => 0,
        Logic::Gates => 500,
        Logic::Carry => carry(node.format.bits()),
        Logic::Comparison => carry(operand(0).bits().max(operand(1).bits())),
        Logic::Product => 1500 + 50 * (operand(0).bits() + operand(1).bits()),
        Logic::Tree => levels(operand(0).bits()),
        Logic::Shifter { max } => levels(max + 1),
        Logic::Table { table } => {
            700 + 350 * netlist.tables()[table.index()].addr_bits.saturating_sub(6)
        }
        Logic::Narrow { round, overflow } => {
            let hardware = Narrowing::new(operand(0), node.format, round, overflow);
            let rounding = if hardware.rounds { carry(node.format.bits()) } else { 0 };
            rounding + if hardware.saturates { 600 } else { 0 }
        }
    }
}

impl std::fmt::Display for Rom {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            Self::Block => "block",
            Self::Distributed => "distributed",
        })
    }
}

/// Number of nodes per stage, for reports.
#[must_use]
pub fn stage_sizes(netlist: &Netlist, schedule: &Schedule) -> Vec<usize> {
    let mut sizes = vec![0; cast::index_of(i64::from(schedule.latency())) + 1];
    for id in netlist.ids() {
        sizes[cast::index_of(i64::from(schedule.stage(id)))] += 1;
    }
    sizes
}
