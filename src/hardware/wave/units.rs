//! The units of a time-shared schedule in a wave: the operations in them, as text, and the words at
//! their ports.
//!
//! Strings contain no blanks, which a VCD can't hold, and only ASCII, since GTKWave shows other
//! bytes as blanks: `Te · L` is `Te*L`, `L²` is `L^2`; `-` means none. `issue` is the operation
//! that enters in this cycle, `out` the one whose result is at the output, and `load` the operands
//! that operand registers load at the end of this cycle. `inside`, for units with a latency, lists
//! all operations from the one being issued to the one at the output. Only operations on valid data
//! are shown. The words at ports are shown in every cycle; where `issue` and `out` are `-` they
//! have no meaning.

use super::shown::{Shown, index_range};
use super::text::{Code, Lines};
use crate::base::cast;
use crate::hardware::cycle::Cycle;
use crate::hardware::rtl::{Instance, Rtl};
use crate::hardware::timetable::{Name, Timetable};
use crate::number::format::Format;
use std::collections::BTreeMap;
use std::io::{self, Write};
use vcd::VarType;

/// Scope of all units.
pub(super) const SCOPE: &str = "units";

/// Text for no operation.
const NONE: &str = "-";

/// Names of a unit's strings.
pub(super) fn strings(unit: &Instance) -> Vec<&'static str> {
    let mut names = Vec::new();
    if unit.ports.iter().any(|port| port.registered) {
        names.push("load");
    }
    names.push("issue");
    if unit.rtl.schedule().latency() > 0 {
        names.push("inside");
    }
    names.push("out");
    names
}

/// Names and formats of a unit's words: first ports, then outputs.
pub(super) fn words(unit: &Instance) -> Vec<(String, Format)> {
    let inside = unit.rtl.netlist();
    let ports = inside.inputs().iter().enumerate();
    let ports = ports.map(|(at, id)| (inside.input_name(at).to_owned(), inside.node(*id).format));
    let outputs = inside.outputs().iter();
    let outputs = outputs.map(|o| (o.name.clone(), inside.node(o.node).format));
    ports.chain(outputs).collect()
}

/// Identifiers, texts and latest values.
pub(super) struct UnitCodes {
    phase: Shown,
    ready: Shown,
    units: Vec<UnitCode>,
}

/// Those of one unit.
struct UnitCode {
    load: Option<Text>,
    issue: Text,
    inside: Option<Text>,
    out: Text,
    /// By phase: for each load at its end, the rate, the stage whose data it is, and the text.
    loads: Vec<Vec<(usize, u32, String)>>,
    /// By operation: its text at the issue, and its result.
    formulas: Vec<String>,
    results: Vec<String>,
    latency: u32,
    /// The text of `inside`, rebuilt in each cycle.
    all: String,
    /// Ports; then outputs, with their slots inside.
    ports: Vec<(Shown, Format)>,
    outputs: Vec<(Shown, Format, usize)>,
}

/// A string variable, and its latest value.
struct Text {
    code: Code,
    last: String,
}

impl Text {
    /// Writes a text if it has changed; no text is empty.
    fn change(&mut self, lines: &mut Lines<'_>, now: &str) -> io::Result<()> {
        if self.last == now {
            return Ok(());
        }
        now.clone_into(&mut self.last);
        lines.string(now, &self.code)
    }
}

impl UnitCodes {
    /// Declares phase and units, in the scope of the module.
    pub(super) fn declare<W: Write>(
        writer: &mut vcd::Writer<W>,
        rtl: &Rtl,
        table: &Timetable,
        cycle: &Cycle,
    ) -> io::Result<Option<Self>> {
        if rtl.phase_bits() == 0 && rtl.units().is_empty() {
            return Ok(None);
        }
        let ready = Shown::new(writer.add_wire(1, "ready")?, 1);
        let format = Format::integer(rtl.phase_bits().max(1)).expect("bug: a few bits");
        let phase = writer.add_var(VarType::Wire, format.bits(), "phase", index_range(format))?;
        let phase = Shown::new(phase, format.bits());
        writer.add_module(SCOPE)?;
        let mut units = Vec::new();
        for number in 0..rtl.units().len() {
            units.push(UnitCode::declare(writer, rtl, number, &table.names[number], cycle)?);
        }
        writer.upscope()?;
        Ok(Some(Self { phase, ready, units }))
    }

    /// Writes what changed after a rising edge.
    pub(super) fn change(&mut self, lines: &mut Lines<'_>, cycle: &Cycle) -> io::Result<()> {
        self.ready.change(lines, cycle.ready().into())?;
        self.phase.change(lines, cycle.phase().into())?;
        let mut units = self.units.iter_mut().enumerate();
        units.try_for_each(|(number, unit)| unit.change(lines, number, cycle))
    }
}

impl UnitCode {
    fn declare<W: Write>(
        writer: &mut vcd::Writer<W>,
        rtl: &Rtl,
        number: usize,
        names: &[Name],
        cycle: &Cycle,
    ) -> io::Result<Self> {
        let unit = &rtl.units()[number];
        writer.add_module(&unit.name)?;
        let mut texts = BTreeMap::new();
        for name in strings(unit) {
            let code = writer.add_var(VarType::String, 1, name, None)?.into();
            texts.insert(name, Text { code, last: String::new() });
        }
        let mut ports = Vec::new();
        for (name, format) in words(unit) {
            let code = writer.add_var(VarType::Wire, format.bits(), &name, index_range(format))?;
            ports.push((Shown::new(code, format.bits()), format));
        }
        writer.upscope()?;
        let outputs = ports.split_off(unit.ports.len()).into_iter();
        let nodes = unit.rtl.netlist().outputs().iter();
        let slots = nodes.map(|o| cycle.inside(number).slot(unit.rtl.output(o.node)));
        let formula = |name: &Name| match name.formula.as_str() {
            "" => tight(&name.result),
            formula => tight(&format!("{}={formula}", name.result)),
        };
        Ok(Self {
            load: texts.remove("load"),
            issue: texts.remove("issue").expect("bug: every unit has it"),
            inside: texts.remove("inside"),
            out: texts.remove("out").expect("bug: every unit has it"),
            loads: (0..rtl.schedule().phases())
                .map(|phase| loads(rtl, number, names, phase, cycle))
                .collect(),
            formulas: names.iter().map(formula).collect(),
            results: names.iter().map(|name| tight(&name.result)).collect(),
            latency: unit.rtl.schedule().latency(),
            all: String::new(),
            ports,
            outputs: outputs
                .zip(slots)
                .map(|((shown, format), slot)| (shown, format, slot))
                .collect(),
        })
    }

    fn change(&mut self, lines: &mut Lines<'_>, number: usize, cycle: &Cycle) -> io::Result<()> {
        if let Some(load) = &mut self.load {
            let loads = self.loads[cast::index_of_u32(cycle.phase())].iter();
            let sits = |(rate, stage, _): &&(usize, u32, String)| cycle.valid(*rate, *stage);
            let mut now = loads.filter(sits).map(|(.., text)| text);
            load.change(lines, now.next().map_or(NONE, String::as_str))?;
        }
        let sits = |stage| cycle.sits(number, stage);
        self.issue.change(lines, sits(0).map_or(NONE, |at| &self.formulas[at]))?;
        if let Some(inside) = &mut self.inside {
            self.all.clear();
            for stage in 0..=self.latency {
                let before = if stage == 0 { "" } else { "|" };
                self.all.push_str(before);
                self.all.push_str(sits(stage).map_or(NONE, |at| &self.results[at]));
            }
            inside.change(lines, &self.all)?;
        }
        self.out.change(lines, sits(self.latency).map_or(NONE, |at| &self.results[at]))?;
        for (port, (shown, format)) in self.ports.iter_mut().enumerate() {
            shown.change(lines, format.pattern(cycle.port(number, port)))?;
        }
        let words = cycle.inside(number).words();
        let mut outputs = self.outputs.iter_mut();
        outputs
            .try_for_each(|(shown, format, slot)| shown.change(lines, format.pattern(words[*slot])))
    }
}

/// The loads that operand registers of a unit can do at the end of a phase: the rate and the stage
/// whose data it is, and the operands' names.
fn loads(
    rtl: &Rtl,
    number: usize,
    names: &[Name],
    phase: u32,
    cycle: &Cycle,
) -> Vec<(usize, u32, String)> {
    let unit = &rtl.units()[number];
    let operations = rtl.operations(number).iter().enumerate();
    let loads = operations.filter_map(|(at, operation)| {
        let stage = operation.issue.checked_sub(1)?;
        let takes = |side: usize| {
            let ports = unit.ports.iter().filter(|port| port.registered && port.side == side);
            ports
                .flat_map(|port| &port.cases)
                .any(|case| case.operation == at && case.phase == phase % unit.interval)
        };
        let sides = names[at].operands.iter().enumerate();
        let sides = sides
            .filter(|(side, name)| takes(*side) && !name.is_empty())
            .map(|(_, name)| tight(name));
        let text = sides.collect::<Vec<String>>().join(",");
        (stage % unit.interval == phase % unit.interval && !text.is_empty())
            .then(|| (cycle.rate_of(operation.nodes[0]), stage, text))
    });
    loads.collect()
}

/// A name without blanks, in ASCII.
fn tight(text: &str) -> String {
    let mut tight = String::new();
    let mut open = false;
    for c in text.chars() {
        match c {
            ' ' => {}
            '·' | '×' => tight.push('*'),
            '−' => tight.push('-'),
            '±' => tight.push_str("+-"),
            '²' => tight.push_str("^2"),
            '√' => tight.push_str("sqrt"),
            // Bars come in pairs: the first opens a length, the second closes it.
            '‖' => {
                tight.push_str(if open { ")" } else { "len(" });
                open = !open;
            }
            'Δ' => tight.push('d'),
            c if c.is_ascii_graphic() => tight.push(c),
            _ => tight.push('?'),
        }
    }
    tight
}
