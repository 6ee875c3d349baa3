//! When each node computes, and where: a map from nodes to cycles and, for shared operations,
//! to units.
//!
//! A *stage* is a cycle counted from the sample's entry: stage 0 works on the input ports;
//! output ports are registers at the stage that is the *latency*. (Printed schedules count from
//! 1.) A new sample may enter every *interval* cycles. Flat pipelining is the interval of 1 with
//! nothing shared: between stage s and s + 1 there is a register. A schedule never edits the
//! netlist. It comes from the delay model below and a target period ([`Schedule::pipeline`]),
//! from stages given by hand ([`Schedule::from_stages`]), from numbers of units
//! ([`Schedule::shared`]), or from units and cycles given by hand ([`Schedule::bound`]).
//!
//! # Sharing
//!
//! What shares a unit, and the unit's hardware, is in [`share`]; how cycles are found in
//! [`place`]. A unit takes one operation a cycle, at its *issue*, and gives the result *latency*
//! cycles later, at its *out*: that is the stage of the operation's nodes. Nodes inside are
//! spread over the latency as evenly as the delay model can, and a latency of 0 is
//! combinational. Operands come through a multiplexer at the issue, or into operand registers
//! (*loads*) in the cycle before. **The output of a unit is used from hold registers only, from
//! out + 1 on**, so that sharing can't make a combinational loop.
//!
//! # Delay model
//!
//! Round figures for a mid-range FPGA, in ps; they place registers and are no promise of a
//! clock (a synthesiser and a router have the last word):
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
//! | table read with a clock | 400 before the edge, 1800 after it |
//! | register, clock to output and set-up | 500 |

pub mod place;
pub mod share;

pub use place::{Binding, BoundOperation, BoundUnit, Load, Plan, Share};
pub use share::{Kind, Operand, Operation, Unit, UnitPort, name_of};

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::netlist::op::{Logic, Op};
use crate::netlist::{Netlist, NodeId};
use crate::number::format::{Narrowing, addr_bits};

const REGISTER_PS: u32 = 500;
const ROM_SETUP_PS: u32 = 400;
const ROM_OUTPUT_PS: u32 = 1800;

/// How tables are read.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Rom {
    /// On a clock edge, as block RAM does: the word is there a stage later.
    Block,
    /// Without a clock, as distributed logic does.
    Distributed,
}

/// How deep to pipeline.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Depth {
    /// As many stages as it takes for this period in ps.
    Period(u32),
    /// This latency in cycles; 0 is combinational.
    Stages(u32),
}

/// Stage of each node, the latency, the interval, and the units that are shared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Schedule {
    stages: Vec<u32>,
    latency: u32,
    period_ps: u32,
    rom: Rom,
    /// Cycles from one sample to the next.
    interval: u32,
    units: Vec<Unit>,
    /// Units with the same number serve operations of one structure.
    same: Vec<usize>,
    /// Unit and operation that each node is in.
    seated: Vec<Option<(usize, usize)>>,
}

impl Schedule {
    /// Places nodes as early as the delay model allows.
    ///
    /// # Errors
    /// If the latency asked for is too short for tables that are read on a clock.
    pub fn pipeline(netlist: &Netlist, rom: Rom, depth: Depth) -> Result<Self> {
        match depth {
            Depth::Period(period_ps) => Ok(Self::greedy(netlist, rom, period_ps)),
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
                        format!(
                            "{} or more: so many reads on a clock follow each other",
                            most.latency
                        ),
                    ));
                }
                // The shortest period that this latency reaches; longer periods never need more stages.
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

    /// Takes stages given by hand.
    ///
    /// # Errors
    /// If a node would be before its operands, or an output after the latency.
    pub fn from_stages(
        netlist: &Netlist,
        rom: Rom,
        stages: Vec<u32>,
        latency: u32,
    ) -> Result<Self> {
        let mut schedule = Self::flat(stages, latency, 0, rom);
        schedule.verify(netlist)?;
        schedule.period_ps = schedule.longest_ps(netlist) + REGISTER_PS;
        Ok(schedule)
    }

    /// Stage of a node.
    #[must_use]
    pub fn stage(&self, id: NodeId) -> u32 {
        self.stages[id.index()]
    }

    /// Stage at which a node takes its operands: one before its own for a read on a clock.
    #[must_use]
    pub fn operand_stage(&self, netlist: &Netlist, id: NodeId) -> u32 {
        self.stage(id) - u32::from(self.is_clocked(netlist, id))
    }

    /// True for a table read that takes a clock; inside a unit that is the unit's affair.
    #[must_use]
    pub fn is_clocked(&self, netlist: &Netlist, id: NodeId) -> bool {
        self.rom == Rom::Block
            && matches!(netlist.node(id).op, Op::Read { .. })
            && self.seat(id).is_none()
    }

    /// Cycles from inputs to outputs.
    #[must_use]
    pub fn latency(&self) -> u32 {
        self.latency
    }

    /// The period that the slowest stage needs, by the delay model, in ps.
    #[must_use]
    pub fn period_ps(&self) -> u32 {
        self.period_ps
    }

    /// How tables are read.
    #[must_use]
    pub fn rom(&self) -> Rom {
        self.rom
    }

    /// Cycles from one sample to the next.
    #[must_use]
    pub fn interval(&self) -> u32 {
        self.interval
    }

    /// The phase of a stage: cycles modulo the interval.
    #[must_use]
    pub fn phase(&self, stage: u32) -> u32 {
        stage % self.interval
    }

    /// The units that operations share.
    #[must_use]
    pub fn units(&self) -> &[Unit] {
        &self.units
    }

    /// Position of the unit that a node sits in, and of the operation there.
    #[must_use]
    pub fn seat(&self, id: NodeId) -> Option<(usize, usize)> {
        self.seated[id.index()]
    }

    /// A schedule without sharing.
    fn flat(stages: Vec<u32>, latency: u32, period_ps: u32, rom: Rom) -> Self {
        let seated = vec![None; stages.len()];
        Self {
            stages,
            latency,
            period_ps,
            rom,
            interval: 1,
            units: Vec::new(),
            same: Vec::new(),
            seated,
        }
    }

    pub(in crate::schedule) fn greedy(netlist: &Netlist, rom: Rom, period_ps: u32) -> Self {
        let available = period_ps.saturating_sub(REGISTER_PS);
        let mut stages: Vec<u32> = Vec::with_capacity(netlist.nodes().len());
        let mut arrivals: Vec<u32> = Vec::with_capacity(netlist.nodes().len());
        let mut longest = 0;
        for id in netlist.ids() {
            let placed = Free::after(netlist, rom, available, id, |operand| {
                (stages[operand.index()], arrivals[operand.index()])
            });
            longest = longest.max(placed.longest_ps);
            stages.push(placed.stage);
            arrivals.push(placed.arrival_ps);
        }
        // An output port is a register: what is computed in a stage is out after it.
        let latency = netlist
            .outputs()
            .iter()
            .map(|output| stages[output.node.index()] + 1)
            .max()
            .unwrap_or_default();
        Self::flat(stages, latency, longest.saturating_add(REGISTER_PS), rom)
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
        if self.stages.len() != netlist.nodes().len() {
            let problem =
                format!("{} stages for {} nodes", self.stages.len(), netlist.nodes().len());
            return Err(Error::node(netlist.name().to_owned(), problem));
        }
        for id in netlist.ids() {
            let bad = |problem: String| Err(Error::node(netlist.label(id), problem));
            let node = netlist.node(id);
            if self.stage(id) == 0 && self.is_clocked(netlist, id) {
                return bad("a read on a clock can't be in stage 0".to_owned());
            }
            if node.op == Op::Input && self.stage(id) != 0 {
                return bad("input ports are in stage 0".to_owned());
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

/// Where a node with hardware of its own comes.
struct Free {
    stage: u32,
    /// When its word is there, from the start of its stage.
    arrival_ps: u32,
    /// The longest path that ends in it.
    longest_ps: u32,
}

impl Free {
    /// As early as its operands, each with its stage and arrival, and the time between registers
    /// allow.
    fn after(
        netlist: &Netlist,
        rom: Rom,
        available_ps: u32,
        id: NodeId,
        operand: impl Fn(NodeId) -> (u32, u32),
    ) -> Self {
        let node = netlist.node(id);
        let (mut stage, mut arrival) = (0, 0);
        for (s, a) in node.operands.iter().map(|id| operand(*id)) {
            if s > stage {
                (stage, arrival) = (s, a);
            } else if s == stage {
                arrival = arrival.max(a);
            }
        }
        let clocked = rom == Rom::Block && matches!(node.op, Op::Read { .. });
        let delay = if clocked { ROM_SETUP_PS } else { delay_ps(netlist, id) };
        // What starts at a register may be as slow as it is; nothing shorter can be done.
        if arrival > 0 && delay > 0 && arrival.saturating_add(delay) > available_ps {
            (stage, arrival) = (stage + 1, 0);
        }
        arrival += delay;
        let mut longest = arrival;
        if clocked {
            (stage, arrival) = (stage + 1, ROM_OUTPUT_PS);
            longest = longest.max(arrival);
        }
        Self { stage, arrival_ps: arrival, longest_ps: longest }
    }
}

/// Delay of an operation without a clock, by the table in the module's documentation.
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
