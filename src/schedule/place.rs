//! Finds stages as early as the delay model allows, with one operation of a unit per phase.
//!
//! The netlist has no loops, so every operation finds a free phase within one interval. So a
//! schedule at the shortest interval that the units allow always exists.

use super::share::{Hardware, Kind, Operand, Operation, Structure, Unit, operations};
use super::{Entries, Entry, Free, REGISTER_PS, Rom, Schedule, delay_ps, places};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::netlist::{Netlist, Rate};
use crate::number::format::addr_bits;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Sharing of one kind of unit.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Share {
    /// The kind.
    pub kind: Kind,
    /// Units for each structure of that kind.
    pub units: u32,
    /// Cycles from issue to output; from the delay model if `None`.
    pub latency: Option<u32>,
    /// True if operands are registered in the cycle before the issue.
    pub loads: bool,
}

/// What to schedule for.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Plan {
    /// The shared kinds; everything else has its own hardware.
    pub shares: Vec<Share>,
    /// Cycles between samples of the fastest rate; if `None`, as few as the units allow. Slower
    /// rates always get the fewest that their units allow.
    pub interval: Option<u32>,
}

/// A hand-written schedule: the units, and which operation runs where and when.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Binding {
    /// Cycles between samples.
    pub interval: u32,
    /// The units.
    pub units: Vec<BoundUnit>,
    /// Their operations.
    pub operations: Vec<BoundOperation>,
}

/// A unit of a [`Binding`].
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct BoundUnit {
    /// Name in hardware and waves, such as `dot1`.
    pub name: String,
    /// Name in the printed table, such as `Vector Dot Unit #1`.
    pub title: String,
    /// Its kind.
    pub kind: Kind,
    /// Cycles from issue to output; from the delay model if `None`.
    pub latency: Option<u32>,
    /// For each side, whether it has an operand register, which stores its word in the cycle before
    /// the issue. A side is the position of an operand in its node. An adder's first operand is the
    /// flag that selects subtraction.
    pub registered: Vec<bool>,
    /// Word for a load in the printed table, such as `Load` or `Ld`.
    pub load: String,
}

/// An operation of a [`Binding`].
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct BoundOperation {
    /// Label of its scope or node, as in the netlist.
    pub label: String,
    /// Index of its unit.
    pub unit: usize,
    /// Printed cycle of its issue, from 1; as early as possible if `None`.
    pub cycle: Option<u32>,
    /// Its result in the printed table, such as `Tx`.
    pub result: String,
    /// Its formula in the printed table, such as `M0 · T`; empty for no compute line.
    pub formula: String,
    /// The operand of each side in the printed table; empty ones aren't printed.
    pub operands: Vec<String>,
}

/// Operations of one structure, and the units that serve them.
struct Group {
    kind: Kind,
    /// Index of their rate among those of the ports.
    rate: usize,
    structure: Structure,
    wanted: Vec<usize>,
    names: Vec<String>,
    latency: u32,
    registered: Vec<bool>,
}

struct Wanted {
    operation: Operation,
    group: usize,
    fixed: Option<u32>,
}

/// How many operations of a structure share how many units.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Load {
    /// Their kind.
    pub kind: Kind,
    /// Their rate.
    pub rate: Rate,
    /// Names of the operations.
    pub operations: Vec<String>,
    /// Names of the units.
    pub units: Vec<String>,
}

impl Load {
    /// The shortest interval that the units allow.
    #[must_use]
    pub fn interval(&self) -> u32 {
        self.interval_with(0)
    }

    /// The shortest interval with `more` additional units.
    #[must_use]
    pub fn interval_with(&self, more: u32) -> u32 {
        // Nodes have 32-bit ids, so there are no more operations than that, and no more units.
        cast::id_of(self.operations.len()).div_ceil(cast::id_of(self.units.len()) + more)
    }
}

/// Delay of a multiplexer with `cases` inputs.
fn mux_ps(cases: usize) -> u32 {
    500 * addr_bits(cast::count_of(cases.max(1)))
}

impl Schedule {
    /// Finds a schedule for shared units: each operation as early as possible, longest remaining
    /// path first.
    ///
    /// # Errors
    /// If the requested interval is too short for the units, a unit's words would be wider than 63
    /// bits, or its latency is too short for tables that are read on a clock.
    pub fn shared(netlist: &Netlist, rom: Rom, period_ps: u32, plan: &Plan) -> Result<Self> {
        let kinds: Vec<Kind> = plan.shares.iter().map(|share| share.kind).collect();
        let mut groups: Vec<Group> = Vec::new();
        let mut wanted: Vec<Wanted> = Vec::new();
        let rates = places(netlist);
        for share in &plan.shares {
            let start = groups.len();
            for (operation, structure) in operations(netlist, share.kind, &kinds) {
                let rate = rates[operation.nodes[0].index()];
                let fits = |g: &Group| g.rate == rate && g.structure.fits(&structure);
                let known = groups[start..].iter().position(fits);
                let group = known.map_or(groups.len(), |at| start + at);
                if known.is_none() {
                    groups.push(Group {
                        kind: share.kind,
                        rate,
                        structure: structure.clone(),
                        wanted: Vec::new(),
                        names: Vec::new(),
                        latency: 0,
                        registered: vec![share.loads; 4],
                    });
                }
                merge(&mut groups[group].structure.exports, &structure.exports);
                groups[group].wanted.push(wanted.len());
                wanted.push(Wanted { operation, group, fixed: None });
            }
            // An operation that shares with none keeps its own hardware, unless it is the only one.
            if groups.len() > start + 1 {
                for group in &mut groups[start..] {
                    if group.wanted.len() == 1 {
                        group.wanted.clear();
                    }
                }
            }
            // Units of one kind are numbered across groups.
            let mut number = 0;
            for group in &mut groups[start..] {
                let units = group.wanted.len().min(cast::index_of(i64::from(share.units)));
                for _ in 0..units {
                    number += 1;
                    group.names.push(format!("{}{number}", share.kind.name()));
                }
            }
        }
        for group in groups.iter_mut().filter(|group| !group.wanted.is_empty()) {
            let share = plan.shares.iter().find(|share| share.kind == group.kind);
            let fixed = share.and_then(|share| share.latency);
            group.latency = latency_of(netlist, rom, period_ps, group, &wanted, fixed)?;
        }
        let intervals = intervals(netlist, &groups, &wanted, plan.interval)?;
        loop {
            let stuck = match place(netlist, rom, period_ps, &intervals, &groups, &wanted)? {
                Placement::Done(placed) => {
                    return finish(netlist, rom, &groups, wanted, placed);
                }
                Placement::Stuck(operation) => operation,
            };
            // It can't run in one go, so it keeps its own hardware.
            groups.iter_mut().for_each(|group| group.wanted.retain(|at| *at != stuck));
        }
    }

    /// Makes a schedule from a binding. Nodes that it doesn't bind are placed as early as possible.
    ///
    /// # Errors
    /// If it names an unknown operation, an operation's structure doesn't fit its unit, two
    /// operations use a unit in the same phase, or an operand isn't ready in time.
    pub fn bound(netlist: &Netlist, rom: Rom, period_ps: u32, binding: &Binding) -> Result<Self> {
        let mut groups: Vec<Group> = Vec::new();
        let mut wanted: Vec<Wanted> = Vec::new();
        let kinds: Vec<Kind> = binding.units.iter().map(|unit| unit.kind).collect();
        let rates = places(netlist);
        for (number, unit) in binding.units.iter().enumerate() {
            let refuse = |problem: String| Err(Error::node(unit.name.clone(), problem));
            let there = operations(netlist, unit.kind, &kinds);
            let mut group: Option<Group> = None;
            for bound in binding.operations.iter().filter(|o| o.unit == number) {
                let found = there.iter().find(|(o, _)| o.name == bound.label);
                let Some((operation, structure)) = found else {
                    let names: Vec<&str> = there.iter().map(|(o, _)| o.name.as_str()).collect();
                    return refuse(format!(
                        "there is no operation `{}` of this kind: there are {}",
                        bound.label,
                        names.join(", ")
                    ));
                };
                let group = group.get_or_insert_with(|| Group {
                    kind: unit.kind,
                    rate: rates[operation.nodes[0].index()],
                    structure: structure.clone(),
                    wanted: Vec::new(),
                    names: vec![unit.name.clone()],
                    latency: 0,
                    registered: unit.registered.clone(),
                });
                if !group.structure.fits(structure) {
                    return refuse(format!("`{}` has a different structure", bound.label));
                }
                merge(&mut group.structure.exports, &structure.exports);
                group.wanted.push(wanted.len());
                let fixed = match bound.cycle {
                    Some(0) => return refuse("printed cycles count from 1".to_owned()),
                    cycle => cycle.map(|cycle| cycle - 1),
                };
                wanted.push(Wanted { operation: operation.clone(), group: groups.len(), fixed });
            }
            let Some(mut group) = group else {
                return refuse("it has no operation".to_owned());
            };
            group.latency = latency_of(netlist, rom, period_ps, &group, &wanted, unit.latency)?;
            groups.push(group);
        }
        let intervals = intervals(netlist, &groups, &wanted, Some(binding.interval))?;
        match place(netlist, rom, period_ps, &intervals, &groups, &wanted)? {
            Placement::Done(placed) => finish(netlist, rom, &groups, wanted, placed),
            Placement::Stuck(at) => Err(Error::node(
                wanted[at].operation.name.clone(),
                "can't run in one go: a node outside it lies between its nodes".to_owned(),
            )),
        }
    }

    /// The load of the units by structure, which determines the shortest interval.
    #[must_use]
    pub fn loads(&self) -> Vec<Load> {
        let mut loads: Vec<(usize, Load)> = Vec::new();
        for (at, unit) in self.units.iter().enumerate() {
            let names = unit.operations.iter().map(|o| o.name.clone());
            let known = loads.iter_mut().find(|(first, _)| self.same[at] == self.same[*first]);
            match known {
                Some((_, load)) => {
                    load.operations.extend(names);
                    load.units.push(unit.name.clone());
                }
                None => loads.push((
                    at,
                    Load {
                        kind: unit.kind,
                        rate: unit.rate,
                        operations: names.collect(),
                        units: vec![unit.name.clone()],
                    },
                )),
            }
        }
        loads.into_iter().map(|(_, load)| load).collect()
    }

    /// The shortest interval that the units allow for the fastest rate.
    #[must_use]
    pub fn shortest_interval(&self) -> u32 {
        let fastest = self.entries.last().map(|entry| entry.rate);
        let loads = self.loads();
        let own = loads.iter().filter(|load| Some(load.rate) == fastest);
        own.map(Load::interval).max().unwrap_or(1)
    }
}

fn merge(exports: &mut Vec<usize>, more: &[usize]) {
    exports.extend_from_slice(more);
    exports.sort_unstable();
    exports.dedup();
}

fn too_short(load: &Load, interval: u32) -> Error {
    let needed = load.operations.len().div_ceil(cast::index_of(i64::from(interval)).max(1));
    let text = format!(
        "{} or more: {} operations ({}) share {} units of kind {} ({}); or share_{}={needed}",
        load.interval(),
        load.operations.len(),
        load.operations.join(", "),
        load.units.len(),
        load.kind.name(),
        load.units.join(", "),
        load.kind.name(),
    );
    Error::parameter_value("interval", &interval.to_string(), text)
}

/// The interval of each rate, slowest first: as requested for the fastest, and as short as the
/// units allow for the others.
fn intervals(
    netlist: &Netlist,
    groups: &[Group],
    wanted: &[Wanted],
    asked: Option<u32>,
) -> Result<Vec<u32>> {
    let rates = netlist.rates();
    let loads = loads_of(&rates, groups, wanted);
    let of = |rate: Rate| loads.iter().filter(move |load| load.rate == rate);
    let mut intervals = vec![1; rates.len()];
    for (place, rate) in rates.iter().enumerate().rev() {
        let shortest = of(*rate).map(Load::interval).max().unwrap_or(1);
        intervals[place] = match (intervals.get(place + 1), asked) {
            (Some(faster), _) => shortest.max(*faster).next_multiple_of(*faster),
            (None, Some(asked)) => asked,
            (None, None) => shortest,
        };
        if let Some(load) = of(*rate).find(|load| load.interval() > intervals[place]) {
            return Err(too_short(load, intervals[place]));
        }
    }
    Ok(intervals)
}

fn loads_of(rates: &[Rate], groups: &[Group], wanted: &[Wanted]) -> Vec<Load> {
    let load = |group: &Group| Load {
        rate: rates[group.rate],
        kind: group.kind,
        operations: group.wanted.iter().map(|at| wanted[*at].operation.name.clone()).collect(),
        units: group.names.clone(),
    };
    groups.iter().filter(|group| !group.wanted.is_empty()).map(load).collect()
}

fn hardware(
    netlist: &Netlist,
    name: &str,
    group: &Group,
    operations: &[&Operation],
) -> Result<Hardware> {
    let registered = |side: usize| group.registered.get(side).copied().unwrap_or(false);
    Hardware::new(netlist, name, group.kind, &group.structure, operations, &registered)
}

/// Latency of a group's units: as given, or as the delay model needs for this period.
fn latency_of(
    netlist: &Netlist,
    rom: Rom,
    period_ps: u32,
    group: &Group,
    wanted: &[Wanted],
    fixed: Option<u32>,
) -> Result<u32> {
    let all: Vec<&Operation> = group.wanted.iter().map(|at| &wanted[*at].operation).collect();
    let name = group.names.join(", ");
    let hardware = hardware(netlist, group.kind.name(), group, &all)?;
    let latency = fixed.unwrap_or_else(|| {
        let registered = hardware.ports.iter().all(|port| port.registered);
        let mux = if registered { 0 } else { mux_ps(all.len().div_ceil(group.names.len())) };
        Schedule::greedy(&hardware.netlist, rom, period_ps.saturating_sub(mux)).latency() - 1
    });
    hardware.pipeline(&name, rom, latency)?;
    Ok(latency)
}

enum Placement {
    Done(Placed),
    /// An operation that depends on itself.
    Stuck(usize),
}

struct Placed {
    stages: Vec<u32>,
    entries: Vec<Entry>,
    latency: u32,
    /// Unit within its group, and issue, of each wanted operation.
    seats: Vec<(usize, u32)>,
    longest_ps: u32,
}

fn place(
    netlist: &Netlist,
    rom: Rom,
    period_ps: u32,
    intervals: &[u32],
    groups: &[Group],
    wanted: &[Wanted],
) -> Result<Placement> {
    let nodes = netlist.nodes().len();
    let available = period_ps.saturating_sub(REGISTER_PS);
    let bound: Vec<usize> = groups.iter().flat_map(|group| group.wanted.clone()).collect();
    // Items: free nodes by their index, then operations.
    let mut item: Vec<usize> = (0..nodes).collect();
    for at in &bound {
        wanted[*at].operation.nodes.iter().for_each(|id| item[id.index()] = nodes + at);
    }
    let mut users: Vec<Vec<usize>> = vec![Vec::new(); nodes + wanted.len()];
    let mut missing = vec![0usize; nodes + wanted.len()];
    for id in netlist.ids() {
        for operand in &netlist.node(id).operands {
            let (from, to) = (item[operand.index()], item[id.index()]);
            if from != to {
                users[from].push(to);
                missing[to] += 1;
            }
        }
    }
    // Delay of the remaining path to the outputs.
    let mut heights = vec![0u32; nodes];
    for id in netlist.ids().rev() {
        let own = heights[id.index()].saturating_add(delay_ps(netlist, id));
        heights[id.index()] = own;
        for operand in &netlist.node(id).operands {
            heights[operand.index()] = heights[operand.index()].max(own);
        }
    }
    let height = |item: usize| match item.checked_sub(nodes) {
        None => heights[item],
        Some(at) => {
            let ids = wanted[at].operation.nodes.iter();
            ids.map(|id| heights[id.index()]).max().unwrap_or(0)
        }
    };
    let interval = |group: usize| intervals[groups[group].rate];
    let of_group = |group: usize| {
        let width = cast::index_of(i64::from(interval(group)));
        vec![vec![None; width]; groups[group].names.len()]
    };
    let mut taken: Vec<Vec<Vec<Option<usize>>>> = (0..groups.len()).map(of_group).collect();
    let phase = |group: usize, cycle: u32| cast::index_of(i64::from(cycle % interval(group)));
    for at in &bound {
        if let Some(issue) = wanted[*at].fixed {
            let group = wanted[*at].group;
            let slot = &mut taken[group][0][phase(group, issue)];
            if let Some(other) = slot.replace(*at) {
                let problem = format!(
                    "uses {} in the same phase as `{}`: the schedule repeats every {} cycles",
                    groups[group].names[0],
                    wanted[other].operation.name,
                    interval(group)
                );
                return Err(Error::node(wanted[*at].operation.name.clone(), problem));
            }
        }
    }

    let mut stages = vec![0u32; nodes];
    let mut arrivals = vec![0u32; nodes];
    let mut seats = vec![(0usize, 0u32); wanted.len()];
    let mut longest = 0u32;
    let mut done = vec![false; nodes + wanted.len()];
    let mut entries = Entries::new(netlist, intervals.to_vec());
    // All nodes of an operation have one rate.
    let first = |item: usize| match item.checked_sub(nodes) {
        None => netlist.id_at(item),
        Some(at) => wanted[at].operation.nodes[0],
    };
    let rates = netlist.rates().len();
    let mut ready: Vec<BinaryHeap<(u32, Reverse<usize>)>> = vec![BinaryHeap::new(); rates];
    let items = (0..nodes).filter(|index| item[*index] == *index);
    for item in items.chain(bound.iter().map(|at| nodes + at)) {
        if missing[item] == 0 {
            ready[entries.of(first(item))].push((height(item), Reverse(item)));
        }
    }
    let mut rate = entries.next(&stages).expect("bug: there is a rate");
    loop {
        let Some((_, Reverse(now))) = ready[rate].pop() else {
            match entries.next(&stages) {
                Some(next) => rate = next,
                None => break,
            }
            continue;
        };
        let from = entries.now();
        done[now] = true;
        if let Some(at) = now.checked_sub(nodes) {
            let number = wanted[at].group;
            let (operation, group) = (&wanted[at].operation, &groups[number]);
            let share = group.wanted.len().div_ceil(group.names.len());
            let mut earliest = from;
            let mut late = None;
            for (place, operand) in operation.operands.iter().enumerate() {
                let side = operation.sides[place];
                let registered = group.registered.get(side).copied().unwrap_or(false);
                let first = match *operand {
                    Operand::Constant { .. } => from,
                    // A word of a slower rate is held by now.
                    Operand::Node(id) if entries.of(id) < rate => from,
                    // A unit's output is available only from hold registers.
                    Operand::Node(id) if item[id.index()] >= nodes => stages[id.index()] + 1,
                    Operand::Node(id) => {
                        let arrival = arrivals[id.index()];
                        let fits = arrival == 0
                            || registered && arrival.saturating_add(mux_ps(share)) <= available;
                        stages[id.index()] + u32::from(!fits)
                    }
                };
                let first = first + u32::from(registered);
                if first > earliest {
                    (earliest, late) = (first, Some(*operand));
                }
            }
            let free = |unit: usize, issue: u32| {
                taken[number][unit][phase(number, issue)].is_none_or(|known| known == at)
            };
            let (unit, issue) = match wanted[at].fixed {
                Some(issue) if issue < earliest => {
                    let operand = match late {
                        Some(Operand::Node(id)) => netlist.label(id),
                        Some(Operand::Constant { .. }) | None => "its operand".to_owned(),
                    };
                    let problem = format!(
                        "is bound to cycle {}, but `{operand}` is ready for cycle {} at this period: \
                         bind it later, or raise period_ps",
                        issue + 1,
                        earliest + 1
                    );
                    return Err(Error::node(operation.name.clone(), problem));
                }
                Some(issue) => (0, issue),
                None => (earliest..earliest + interval(number))
                    .find_map(|issue| {
                        let unit = (0..group.names.len()).find(|unit| free(*unit, issue));
                        unit.map(|unit| (unit, issue))
                    })
                    .expect("bug: the interval has a phase for each operation"),
            };
            taken[number][unit][phase(number, issue)] = Some(at);
            seats[at] = (unit, issue);
            for (place, operand) in operation.operands.iter().enumerate() {
                let side = operation.sides[place];
                let registered = group.registered.get(side).copied().unwrap_or(false);
                if let Operand::Node(id) = *operand
                    && entries.of(id) == rate
                    && registered
                    && stages[id.index()] + 1 == issue
                    && item[id.index()] < nodes
                {
                    longest = longest.max(arrivals[id.index()].saturating_add(mux_ps(share)));
                }
            }
            for id in &operation.nodes {
                stages[id.index()] = issue + group.latency;
            }
        } else {
            let id = netlist.id_at(now);
            let placed = Free::after(netlist, rom, available, id, from, |operand| {
                if entries.of(operand) < rate {
                    return (from, 0);
                }
                let shared = item[operand.index()] >= nodes;
                let arrival = if shared { 0 } else { arrivals[operand.index()] };
                (stages[operand.index()] + u32::from(shared), arrival)
            });
            longest = longest.max(placed.longest_ps);
            stages[now] = placed.stage;
            arrivals[now] = placed.arrival_ps;
        }
        for user in &users[now] {
            missing[*user] -= 1;
            if missing[*user] == 0 {
                ready[entries.of(first(*user))].push((height(*user), Reverse(*user)));
            }
        }
    }
    let latency = entries.latency(&stages);
    let entries = entries.done();
    match bound.iter().find(|at| !done[nodes + **at]) {
        Some(stuck) => Ok(Placement::Stuck(*stuck)),
        None => {
            Ok(Placement::Done(Placed { stages, entries, latency, seats, longest_ps: longest }))
        }
    }
}

/// Builds the units.
fn finish(
    netlist: &Netlist,
    rom: Rom,
    groups: &[Group],
    wanted: Vec<Wanted>,
    placed: Placed,
) -> Result<Schedule> {
    let mut units: Vec<Unit> = Vec::new();
    let mut same: Vec<usize> = Vec::new();
    let mut longest = placed.longest_ps;
    let mut seated = vec![None; netlist.nodes().len()];
    for (number, group) in groups.iter().enumerate() {
        for (unit, name) in group.names.iter().enumerate() {
            let mut operations: Vec<Operation> = Vec::new();
            for at in group.wanted.iter().filter(|at| placed.seats[**at].0 == unit) {
                let mut operation = wanted[*at].operation.clone();
                operation.issue = placed.seats[*at].1;
                operations.push(operation);
            }
            if operations.is_empty() {
                continue;
            }
            operations.sort_by_key(|operation| operation.issue);
            let all: Vec<&Operation> = operations.iter().collect();
            let hardware = hardware(netlist, name, group, &all)?;
            let pipeline = hardware.pipeline(name, rom, group.latency)?;
            let registered = hardware.ports.iter().all(|port| port.registered);
            let mux = if registered { 0 } else { mux_ps(operations.len()) };
            longest = longest.max((pipeline.period_ps() - REGISTER_PS).saturating_add(mux));
            for (at, operation) in operations.iter().enumerate() {
                for id in &operation.nodes {
                    seated[id.index()] = Some((units.len(), at));
                }
            }
            let Entry { rate, interval, .. } = placed.entries[group.rate];
            units.push(Unit {
                name: name.clone(),
                kind: group.kind,
                rate,
                interval,
                netlist: hardware.netlist,
                pipeline,
                ports: hardware.ports,
                exports: group.structure.exports.clone(),
                positions: hardware.positions,
                operations,
            });
            same.push(number);
        }
    }
    Ok(Schedule {
        stages: placed.stages,
        entries: placed.entries,
        latency: placed.latency,
        period_ps: longest.saturating_add(REGISTER_PS),
        rom,
        units,
        same,
        seated,
    })
}
