//! The units of a time-shared schedule in a wave: what sits where, as text, and the words at
//! their ports.
//!
//! Strings have no blanks, which a VCD can't hold, and are ASCII, since GTKWave takes other bytes
//! for blanks: `Te · L` is `Te*L`, `L²` is `L^2`; `-` is nothing. `issue` is the operation that
//! enters in this cycle, `out` the one whose result is at the output, `load` what operand
//! registers take at the end of this cycle, and `inside`, for units with a latency, all from the
//! one that is issued to the one at the output. Only operations on valid data are shown. The words at
//! ports are there in every cycle, whatever sits in the unit: where `issue` and `out` are `-` they mean nothing.

use super::{change_word, top_index};
use crate::cast;
use crate::format::Format;
use crate::rtl::{Instance, Rtl};
use crate::sim::cycle::Cycle;
use crate::timetable::{Name, Timetable};
use std::io::{self, Write};
use vcd::{IdCode, ReferenceIndex, VarType};

/// Scope of all units.
pub(super) const SCOPE: &str = "units";

/// What a string says when there is nothing.
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

/// Names and formats of a unit's words: ports, then outputs.
pub(super) fn words(unit: &Instance) -> Vec<(String, Format)> {
    let inside = unit.rtl.netlist();
    let ports = inside.inputs().iter().enumerate();
    let ports = ports.map(|(at, id)| (inside.input_name(at).to_owned(), inside.node(*id).format));
    let outputs = inside.outputs().iter();
    let outputs = outputs.map(|o| (o.name.clone(), inside.node(o.node).format));
    ports.chain(outputs).collect()
}

/// Identifiers and last values.
pub(super) struct UnitCodes {
    phase: IdCode,
    ready: IdCode,
    last_phase: Option<u32>,
    strings: Vec<Vec<(IdCode, Option<String>)>>,
    words: Vec<Vec<(IdCode, Option<i64>)>>,
}

impl UnitCodes {
    /// Declares phase and units, in the scope of the module.
    pub(super) fn declare<W: Write>(
        writer: &mut vcd::Writer<W>,
        rtl: &Rtl,
    ) -> io::Result<Option<Self>> {
        if rtl.phase_bits() == 0 && rtl.units().is_empty() {
            return Ok(None);
        }
        let ready = writer.add_wire(1, "ready")?;
        let bits = rtl.phase_bits().max(1);
        let range = (bits > 1).then(|| ReferenceIndex::Range(cast::signed_count(bits) - 1, 0));
        let phase = writer.add_var(VarType::Wire, bits, "phase", range)?;
        let (mut all_strings, mut all_words) = (Vec::new(), Vec::new());
        writer.add_module(SCOPE)?;
        for unit in rtl.units() {
            writer.add_module(&unit.name)?;
            let mut codes = Vec::new();
            for name in strings(unit) {
                codes.push((writer.add_var(VarType::String, 1, name, None)?, None));
            }
            all_strings.push(codes);
            let mut codes = Vec::new();
            for (name, format) in words(unit) {
                let range = (format.bits() > 1)
                    .then(|| ReferenceIndex::Range(top_index(format), -format.frac_bits()));
                codes.push((writer.add_var(VarType::Wire, format.bits(), &name, range)?, None));
            }
            all_words.push(codes);
            writer.upscope()?;
        }
        writer.upscope()?;
        Ok(Some(Self { phase, ready, last_phase: None, strings: all_strings, words: all_words }))
    }

    /// Writes what changed after a rising edge.
    pub(super) fn change<W: Write>(
        &mut self,
        writer: &mut vcd::Writer<W>,
        rtl: &Rtl,
        table: &Timetable,
        cycle: &Cycle,
    ) -> io::Result<()> {
        if self.last_phase != Some(cycle.phase()) {
            writer.change_scalar(self.ready, cycle.ready())?;
            let format = Format::integer(rtl.phase_bits().max(1)).expect("bug: a few bits");
            change_word(writer, self.phase, format, Some(i64::from(cycle.phase())))?;
            self.last_phase = Some(cycle.phase());
        }
        for (number, unit) in rtl.units().iter().enumerate() {
            let texts = texts(rtl, number, &table.names[number], cycle);
            for ((code, last), text) in self.strings[number].iter_mut().zip(texts) {
                if last.as_ref() != Some(&text) {
                    writer.change_string(*code, &text)?;
                    *last = Some(text);
                }
            }
            let inside = cycle.inside(number);
            let outputs = unit.rtl.netlist().outputs().iter();
            let outputs = outputs.map(|o| inside.word(unit.rtl.output(o.node)));
            let now = (0..unit.ports.len()).map(|port| cycle.port(number, port)).chain(outputs);
            let formats = words(unit);
            for (((code, last), now), (_, format)) in
                self.words[number].iter_mut().zip(now).zip(formats)
            {
                if *last != Some(now) {
                    change_word(writer, *code, format, Some(now))?;
                    *last = Some(now);
                }
            }
        }
        Ok(())
    }
}

/// A name without blanks and in ASCII.
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
            // A bar of one's own stands between what is inside.
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

/// Texts of a unit's strings in this cycle.
fn texts(rtl: &Rtl, number: usize, names: &[Name], cycle: &Cycle) -> Vec<String> {
    let unit = &rtl.units()[number];
    let latency = unit.rtl.schedule().latency();
    let result = |stage: u32| {
        let sits = cycle.sits(number, stage);
        sits.map_or_else(|| NONE.to_owned(), |at| tight(&names[at].result))
    };
    let one = |name: &&str| match *name {
        "load" => {
            let mut loads =
                rtl.operations(number).iter().enumerate().filter_map(|(at, operation)| {
                    let stage =
                        operation.issue.checked_sub(1).filter(|stage| cycle.is_data(*stage))?;
                    let phase = rtl.schedule().phase(stage);
                    let takes = |side: usize| {
                        let ports =
                            unit.ports.iter().filter(|port| port.registered && port.side == side);
                        ports
                            .flat_map(|port| &port.cases)
                            .any(|case| case.operation == at && case.phase == phase)
                    };
                    let sides = names[at].operands.iter().enumerate();
                    let sides = sides
                        .filter(|(side, name)| takes(*side) && !name.is_empty())
                        .map(|(_, name)| tight(name));
                    Some(sides.collect::<Vec<String>>().join(",")).filter(|text| !text.is_empty())
                });
            loads.next().unwrap_or_else(|| NONE.to_owned())
        }
        "issue" => cycle.sits(number, 0).map_or_else(
            || NONE.to_owned(),
            |at| match names[at].formula.as_str() {
                "" => tight(&names[at].result),
                formula => tight(&format!("{}={formula}", names[at].result)),
            },
        ),
        "inside" => (0..=latency).map(result).collect::<Vec<String>>().join("|"),
        _ => result(latency),
    };
    strings(unit).iter().map(one).collect()
}
