//! A time-shared schedule as a table: one row per cycle, one column per unit.
//!
//! The layout is that of the table in US 6,980,218. Cycles count from 1. A unit's cell holds, in
//! this order and separated by `; `:
//!
//! * `Out X` in the cycle of the output, for a unit with operand registers or a latency;
//! * `X = …` in the cycle of the issue, unless that cycle has an `Out X`;
//! * `Load A, B` in the cycle in which operand registers load new words, listed by side. A side
//!   without registers, or one that keeps its word, prints nothing.
//!
//! Names come from a hand-written [`Binding`] if there is one, otherwise from the netlist; a side
//! without a name is omitted.

use crate::hardware::rtl::{Action, Rtl};
use crate::netlist::Netlist;
use crate::netlist::op::Op;
use crate::schedule::{Binding, Kind, Operand, Operation, name_of};
use serde::Serialize;

/// A schedule as a table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Timetable {
    /// Heading of each unit's column.
    pub titles: Vec<String>,
    /// Rows from cycle 1 on; one cell for each unit.
    pub rows: Vec<Vec<String>>,
    /// Names of each unit's operations.
    pub names: Vec<Vec<Name>>,
}

/// Names of an operation.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Name {
    /// Name of its result.
    pub result: String,
    /// Its formula.
    pub formula: String,
    /// Its operand on each side.
    pub operands: Vec<String>,
}

impl Timetable {
    /// Lays out the schedule of some hardware. `binding` is the hand-written schedule that it was
    /// made from, if any.
    #[must_use]
    pub fn new(rtl: &Rtl, binding: Option<&Binding>) -> Self {
        let netlist = rtl.netlist();
        let (mut titles, mut loads, mut names) = (Vec::new(), Vec::new(), Vec::new());
        for (number, unit) in rtl.units().iter().enumerate() {
            let by_hand = binding.and_then(|b| {
                let position = b.units.iter().position(|known| known.name == unit.name)?;
                Some((b, position))
            });
            titles.push(
                by_hand.map_or_else(|| unit.name.clone(), |(b, at)| b.units[at].title.clone()),
            );
            loads.push(by_hand.map_or("Load", |(b, at)| b.units[at].load.as_str()));
            let name = |operation: &Operation| {
                by_hand
                    .and_then(|(b, at)| {
                        b.operations.iter().find(|o| o.unit == at && o.label == operation.name)
                    })
                    .map_or_else(
                        || Name::of(netlist, rtl, number, operation),
                        |known| Name {
                            result: known.result.clone(),
                            formula: known.formula.clone(),
                            operands: known.operands.clone(),
                        },
                    )
            };
            names.push(rtl.operations(number).iter().map(name).collect::<Vec<Name>>());
        }
        let events = rtl.events();
        let last = events.iter().map(|event| event.stage).max();
        let mut rows: Vec<Vec<String>> = Vec::new();
        for stage in 0..last.map_or(0, |last| last + 1) {
            let row = rtl.units().iter().enumerate().map(|(number, unit)| {
                let here = events.iter().filter(|e| e.stage == stage && e.unit == number);
                let (mut outs, mut issues, mut sides) = (Vec::new(), Vec::new(), Vec::new());
                let latency = unit.rtl.schedule().latency();
                let spoken = latency > 0 || unit.ports.iter().any(|port| port.registered);
                for event in here {
                    let name = &names[number][event.operation];
                    match event.action {
                        Action::Out if spoken => outs.push(format!("Out {}", name.result)),
                        Action::Issue if latency > 0 || !spoken => {
                            issues.push(format!("{} = {}", name.result, name.formula));
                        }
                        Action::Out | Action::Issue => {}
                        Action::Load(side) => {
                            let told = name.operands.get(side).filter(|name| !name.is_empty());
                            sides.extend(told.cloned());
                        }
                    }
                }
                let mut cell = outs;
                cell.extend(issues);
                if !sides.is_empty() {
                    cell.push(format!("{} {}", loads[number], sides.join(", ")));
                }
                cell.join("; ")
            });
            rows.push(row.collect());
        }
        Self { titles, rows, names }
    }
}

impl Name {
    fn of(netlist: &Netlist, rtl: &Rtl, unit: usize, operation: &Operation) -> Self {
        // Sides come from the operation: a constant shared by all of a unit's operations has no
        // port.
        let sides = operation.sides.iter().max();
        let adder = rtl.units()[unit].kind == Kind::Adder;
        let operands: Vec<String> = (0..=sides.copied().unwrap_or(0))
            .map(|side| {
                // Side 0 of an adder is the add/subtract flag, which the sign in the formula shows.
                if adder && side == 0 {
                    return String::new();
                }
                let places = operation.sides.iter().zip(&operation.operands);
                let names =
                    places.filter(|(of, _)| **of == side).map(|(_, operand)| match *operand {
                        Operand::Node(id) => name_of(netlist, id),
                        Operand::Constant { raw, format } => format.value(raw).to_string(),
                    });
                vector_name(&names.collect::<Vec<String>>())
            })
            .collect();
        let told: Vec<&str> =
            operands.iter().map(String::as_str).filter(|name| !name.is_empty()).collect();
        let op = netlist.node(operation.nodes[0]).op;
        let formula = match rtl.units()[unit].kind {
            Kind::Dot => told.join(" · "),
            Kind::Multiplier => told.join(" × "),
            Kind::Adder if op == Op::Sub => told.join(" − "),
            Kind::Adder if op == Op::AddSub => told.join(" ± "),
            Kind::Adder => told.join(" + "),
            kind @ (Kind::Table | Kind::Root | Kind::Divider) => {
                format!("{}({})", kind.name(), told.join(", "))
            }
        };
        Self { result: operation.name.clone(), formula, operands }
    }
}

/// `t` for `t_x`, `t_y`, `t_z`; otherwise the distinct names, separated by commas.
fn vector_name(names: &[String]) -> String {
    let mut fresh: Vec<&str> = Vec::new();
    for name in names {
        if !fresh.contains(&name.as_str()) {
            fresh.push(name);
        }
    }
    let stem = |name: &str| {
        let stem = name.strip_suffix(['x', 'y', 'z', '0', '1', '2'])?;
        Some(stem.trim_end_matches('_').to_owned()).filter(|stem| !stem.is_empty())
    };
    let stems: Vec<Option<String>> = fresh.iter().map(|name| stem(name)).collect();
    match stems.first() {
        Some(Some(first)) if fresh.len() > 1 && stems.iter().all(|s| s.as_ref() == Some(first)) => {
            first.clone()
        }
        Some(_) | None => fresh.join(", "),
    }
}
