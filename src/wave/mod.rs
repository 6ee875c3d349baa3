//! Waves of the pipelined hardware: a VCD file and a GTKWave save file beside it.
//!
//! Words are declared with the binary point as a negative least index, so `[1:-14]` is a
//! 16-bit word with 14 fraction bits. Beside each named word stand three reals: its value, the
//! netlist evaluated on reals for the same sample (`ideal`), and the difference (`arith_error`);
//! beside each output port also the golden, and the difference to that (`total_error`). Words that are exact, such as sums of inputs, have
//! only their value. Angles are in degrees there, and their errors are
//! taken modulo a turn. In stage s, cycle t shows the sample that entered at cycle t - s;
//! what no data has reached yet is `x`.
//!
//! With a time-shared schedule, a word in its own stage is shown in its phase only and is `x` in
//! the others; the hold register of a word, `name_sN`, shows it for the whole interval. A node inside a
//! unit has only that. Phase and units stand beside them.
//!
//! # Speed
//!
//! Every word comes from the cycle simulator, flat or shared, and only what changed is written. For flat
//! pipelines the batch engine could give the words too; but of a wave of the rotation unit's
//! words, stepping takes a quarter of the time, text a fifth, and the system's
//! copying of the file half, so one way is kept, and the wave shows what registers really hold.
//! `cargo bench --bench engine` compares it with Verilator's tracing.
//!
//! # Why there is no FST
//!
//! Tried with `fst-writer` 0.3 on a wave of 10^5 cycles of the rotation unit with all signals: files are a
//! sixth of the VCD's size (25 MB of 159) and with reals a quarter (120 of 483), but writing takes several times as
//! long and holds all changes of a block in memory, and it has no strings of varying length,
//! which time-shared units are shown by. `vcd2fst`, which comes with GTKWave, makes the same files of
//! a finished VCD, strings included.

mod text;
mod twins;
mod units;

use crate::cast;
use crate::error::{Error, Result};
use crate::format::Format;
use crate::netlist::{Netlist, NodeId, Quantity};
use crate::op::Op;
use crate::output;
use crate::rtl::{Rtl, Signal};
use crate::sim::cycle::Cycle;
use crate::timetable::Timetable;
use crate::units::Design;
use std::collections::BTreeSet;
use std::io::{self, Write};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;
use text::{Code, Lines};
use twins::Twins;
use units::UnitCodes;
use vcd::{IdCode, ReferenceIndex, TimescaleUnit, VarType};

/// What to put into a wave.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Cycles to write; all if `None`.
    pub cycles: Option<Range<u64>>,
    /// Patterns of signals to write, with `*` for any text; every named one if empty.
    pub signals: Vec<String>,
    /// Also nodes without a name, and the registers that carry words to later stages.
    pub all: bool,
    /// No real twins.
    pub words_only: bool,
}

/// One signal of the wave.
#[derive(Clone, Debug)]
struct Trace {
    signal: Signal,
    /// Scopes and name.
    path: Vec<String>,
    name: String,
    quantity: Quantity,
    /// How many of value, ideal, arithmetic error, golden and total error stand beside it.
    twins: usize,
    /// Number of the output port that it is.
    port: Option<usize>,
}

impl Trace {
    fn names(&self) -> [String; 5] {
        let unit = match self.quantity {
            Quantity::Turns => "_deg",
            Quantity::Number | Quantity::Float20 => "",
        };
        ["value", "ideal", "arith_error", "golden", "total_error"]
            .map(|twin| format!("{}_{twin}{unit}", self.name))
    }

    /// Factor from values to what twins show.
    fn scale(&self) -> f64 {
        match self.quantity {
            Quantity::Turns => 360.0,
            Quantity::Number | Quantity::Float20 => 1.0,
        }
    }
}

/// A wave that is ready to be written.
#[derive(Debug)]
pub struct Wave<'a> {
    design: &'a Design,
    rtl: Arc<Rtl>,
    table: Timetable,
    traces: Vec<Trace>,
    options: Options,
    period_ps: u64,
}

/// True if `text` matches a pattern with `*` for any text.
fn matches(pattern: &str, text: &str) -> bool {
    let Some((head, rest)) = pattern.split_once('*') else { return pattern == text };
    let Some(mut text) = text.strip_prefix(head) else { return false };
    let (middle, tail) = rest.rsplit_once('*').unwrap_or(("", rest));
    // The leftmost place of each middle part leaves the most text to the others.
    for part in middle.split('*') {
        match text.find(part) {
            Some(at) => text = &text[at + part.len()..],
            None => return false,
        }
    }
    text.ends_with(tail)
}

impl<'a> Wave<'a> {
    /// Chooses the signals.
    ///
    /// # Errors
    /// If a pattern matches none, or the pipeline can't be built.
    #[expect(clippy::missing_panics_doc, reason = "period_ps always has a value")]
    pub fn new(design: &'a Design, options: Options) -> Result<Self> {
        let rtl = Arc::new(design.rtl()?);
        let mut traces = all_traces(&rtl, &options);
        for pattern in &options.signals {
            if !traces.iter().any(|trace| matches(pattern, &full_name(trace))) {
                let mut names: Vec<String> = traces.iter().map(full_name).collect();
                names.truncate(8);
                return Err(Error::usage(format!(
                    "no signal matches `{pattern}`: there are {}, …; --all adds unnamed ones",
                    names.join(", ")
                )));
            }
        }
        if !options.signals.is_empty() {
            traces.retain(|trace| {
                options.signals.iter().any(|pattern| matches(pattern, &full_name(trace)))
            });
        }
        if options.words_only {
            traces.iter_mut().for_each(|trace| trace.twins = 0);
        }
        let target = design.values.int("period_ps").expect("bug: no auto here");
        let period_ps = u64::from(rtl.schedule().period_ps()).max(target.unsigned_abs());
        let table = Timetable::new(&rtl, design.printed());
        Ok(Self { design, rtl, table, traces, options, period_ps: period_ps.next_multiple_of(2) })
    }

    /// The hardware that it shows.
    #[must_use]
    pub fn rtl(&self) -> &Rtl {
        &self.rtl
    }

    /// Number of signals.
    #[must_use]
    pub fn len(&self) -> usize {
        self.traces.len()
    }

    /// True if there is no signal.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.traces.is_empty()
    }

    /// Cycles until the last of so many samples is out.
    #[must_use]
    pub fn cycles(&self, samples: usize) -> u64 {
        let interval = u64::from(self.rtl.schedule().interval());
        let last = cast::count_of(samples).saturating_sub(1) * interval;
        last + u64::from(self.rtl.schedule().latency()) + u64::from(samples > 0)
    }

    /// Simulates one sample per interval and writes the VCD; runs on until the last result is out.
    ///
    /// # Errors
    /// If `to` can't be written; `path` names it. If a `narrow` under overflow mode `error`
    /// overflowed on valid data.
    ///
    /// # Panics
    /// If the samples don't match the input ports.
    pub fn write(&self, samples: &[Vec<i64>], to: &mut dyn Write, path: &Path) -> Result<u64> {
        self.write_with(samples, to, path, &|_| ())
    }

    /// As [`Wave::write`]; `progress` gets the cycles done.
    ///
    /// # Errors
    /// As [`Wave::write`].
    ///
    /// # Panics
    /// As [`Wave::write`].
    pub fn write_with(
        &self,
        samples: &[Vec<i64>],
        to: &mut dyn Write,
        path: &Path,
        progress: &dyn Fn(u64),
    ) -> Result<u64> {
        let cycle = self.write_cycles(samples, to, progress).map_err(output::at(path))?;
        match cycle.forbidden_overflow() {
            Some(node) => Err(Error::node_overflow(self.rtl.netlist().label(node), 1)),
            None => {
                let first = self.options.cycles.as_ref().map_or(0, |cycles| cycles.start);
                Ok(cycle.edges().saturating_sub(first))
            }
        }
    }

    fn write_cycles(
        &self,
        samples: &[Vec<i64>],
        to: &mut dyn Write,
        progress: &dyn Fn(u64),
    ) -> io::Result<Cycle> {
        let netlist = self.rtl.netlist();
        let (latency, interval) =
            (self.rtl.schedule().latency(), u64::from(self.rtl.schedule().interval()));
        let total = self.cycles(samples.len());
        let window = self.options.cycles.clone().unwrap_or(0..total);
        let end = total.min(window.end);
        let mut cycle = Cycle::new(Arc::clone(&self.rtl));

        let mut writer = vcd::Writer::new(&mut *to);
        writer.comment(&format!(
            "fixpath {}: unit {}, latency {latency} cycles; {}",
            env!("CARGO_PKG_VERSION"),
            netlist.name(),
            self.design
                .values
                .told()
                .map(|(name, value)| format!("{name}={value}"))
                .collect::<Vec<_>>()
                .join(" ")
        ))?;
        writer.timescale(1, TimescaleUnit::PS)?;
        // The oldest sample that can be in the pipeline then.
        let oldest = window.start.saturating_sub(u64::from(latency) + interval) / interval;
        let oldest = usize::try_from(oldest).unwrap_or(usize::MAX).min(samples.len());
        let mut codes = Codes::declare(&mut writer, self, &cycle, oldest)?;
        let mut lines = Lines::new(to);

        let idle = vec![0; netlist.inputs().len()];
        for at in 0..end {
            let number = usize::try_from(at / interval).ok().filter(|_| cycle.ready());
            let sample = number.and_then(|number| samples.get(number));
            cycle.settle(sample.unwrap_or(&idle), sample.is_some());
            if at >= window.start {
                lines.timestamp(at * self.period_ps)?;
                let first = at == window.start;
                if first {
                    lines.text("$dumpvars\n")?;
                    lines.flag(false, &codes.rst)?;
                }
                lines.flag(true, &codes.clk)?;
                codes.change(&mut lines, &self.rtl, samples, &cycle)?;
                if first {
                    lines.text("$end\n")?;
                }
                lines.timestamp(at * self.period_ps + self.period_ps / 2)?;
                lines.flag(false, &codes.clk)?;
            }
            cycle.clock();
            if at % 4096 == 0 {
                progress(at);
            }
        }
        lines.timestamp(end * self.period_ps)?;
        lines.flush()?;
        Ok(cycle)
    }

    /// Writes the GTKWave save file for a VCD of this name.
    ///
    /// # Errors
    /// If `to` can't be written.
    pub fn write_gtkw(&self, vcd: &Path, to: &mut dyn Write) -> io::Result<()> {
        let netlist = self.rtl.netlist();
        let unit = netlist.name();
        // The name alone: the pair of files can be moved together.
        let file = vcd.file_name().unwrap_or_default().to_string_lossy();
        writeln!(to, "[*] fixpath {}: unit {unit}", env!("CARGO_PKG_VERSION"))?;
        // From the first result on: before it there is nothing to see.
        let cycles = self.options.cycles.clone().unwrap_or(0..u64::MAX);
        let latency = u64::from(self.rtl.schedule().latency());
        let first = if latency < cycles.end { latency.max(cycles.start) } else { cycles.start };
        let start = first * self.period_ps;
        writeln!(to, "[dumpfile] \"{file}\"\n[timestart] {start}")?;
        writeln!(to, "[size] 1500 1000\n[pos] -1 -1")?;
        writeln!(to, "[sst_width] 210\n[signals_width] 330\n[sst_expanded] 0\n[treeopen] {unit}.")?;
        let zoom = -(cast::f64_of_count(self.period_ps).log2() + 1.0);
        writeln!(to, "*{zoom:.6} 0 {}", "-1 ".repeat(26).trim_end())?;
        writeln!(to, "@28\n{unit}.clk\n{unit}.rst\n{unit}.valid_in\n{unit}.valid_out")?;
        self.write_units(to)?;
        let is_input = |trace: &Trace| netlist.node(trace.signal.node).op == Op::Input;
        self.write_group("input ports", is_input, to)?;
        let latency = self.rtl.schedule().latency();
        let title = format!("output ports, {latency} cycles later");
        self.write_group(&title, |trace| trace.port.is_some(), to)?;
        let shared = self.rtl.schedule().interval() > 1;
        let is_held = |trace: &Trace| {
            shared && trace.signal.stage > self.rtl.schedule().stage(trace.signal.node)
        };
        for stage in 0..=latency {
            let inner = |trace: &Trace| {
                trace.signal.stage == stage
                    && trace.port.is_none()
                    && !is_input(trace)
                    && !is_held(trace)
            };
            self.write_group(&format!("stage {stage}"), inner, to)?;
        }
        let held = |trace: &Trace| is_held(trace) && trace.port.is_none();
        self.write_group("hold registers", held, to)?;
        writeln!(to, "[pattern_trace] 1\n[pattern_trace] 0")
    }

    /// Phase, and the strings and words of each unit.
    fn write_units(&self, to: &mut dyn Write) -> io::Result<()> {
        let unit = self.rtl.netlist().name();
        if self.rtl.phase_bits() > 0 {
            let top = self.rtl.phase_bits() - 1;
            let range = if top > 0 { format!("[{top}:0]") } else { String::new() };
            writeln!(to, "@200\n-phase: inputs are taken in phase 0")?;
            writeln!(to, "@28\n{unit}.ready\n@24\n{unit}.phase{range}")?;
        }
        for (instance, title) in self.rtl.units().iter().zip(&self.table.titles) {
            let title = if *title == instance.name {
                title.clone()
            } else {
                format!("{title} ({})", instance.name)
            };
            writeln!(to, "@200\n-{title}")?;
            let path = format!("{unit}.{}.{}", units::SCOPE, instance.name);
            for name in units::strings(instance) {
                let color = if name == "issue" { 2 } else { 3 };
                writeln!(to, "@20\n[color] {color}\n{path}.{name}")?;
            }
            for (name, format) in units::words(instance) {
                write_gtkw_word(&format!("{path}.{name}"), format, 6, to)?;
            }
        }
        Ok(())
    }

    fn write_group(
        &self,
        title: &str,
        belongs: impl Fn(&Trace) -> bool,
        to: &mut dyn Write,
    ) -> io::Result<()> {
        if self.traces.iter().any(&belongs) {
            writeln!(to, "@200\n-{title}")?;
        }
        self.traces
            .iter()
            .filter(|trace| belongs(trace))
            .try_for_each(|trace| self.write_gtkw_trace(trace, to))
    }

    fn write_gtkw_trace(&self, trace: &Trace, to: &mut dyn Write) -> io::Result<()> {
        let netlist = self.rtl.netlist();
        let node = netlist.node(trace.signal.node);
        let (format, dots) = (node.format, path_text(netlist, trace));
        let port = trace.port.is_some() || node.op == Op::Input;
        let color = if port { 2 } else { 3 };
        write_gtkw_word(&format!("{dots}{}", trace.name), format, color, to)?;
        let [value, _, arith_error, golden, total_error] = trace.names();
        if trace.quantity == Quantity::Turns && (1..5).contains(&trace.twins) {
            writeln!(to, "@20\n[color] {color}\n{dots}{value}")?;
        }
        match trace.twins {
            5 => {
                // Value and error also as analog traces: steps, scaled to all of the data.
                let analog = |color: u8, name: &str, rows: usize| {
                    let space = "\n-".repeat(rows);
                    format!("@88420\n[color] {color}\n{dots}{name}\n@20000{space}\n")
                };
                write!(to, "{}", analog(color, &value, 1))?;
                writeln!(to, "@20\n[color] 5\n{dots}{golden}")?;
                write!(to, "{}", analog(1, &total_error, 2))?;
                writeln!(to, "@20\n[color] 1\n{dots}{arith_error}")
            }
            3 => writeln!(to, "@20\n[color] 1\n{dots}{arith_error}"),
            _ => Ok(()),
        }
    }
}

/// A word with its fixed-point shift in the save file.
fn write_gtkw_word(name: &str, format: Format, color: u8, to: &mut dyn Write) -> io::Result<()> {
    // GTKWave counts anew from 0 where the declared top index is not above 0.
    let range = if top_index(format) > 0 {
        format!("[{}:{}]", top_index(format), -format.frac_bits())
    } else {
        format!("[{}:0]", format.bits() - 1)
    };
    // Fixed-point shift of the decimal display; signed or not.
    if format.bits() == 1 {
        writeln!(to, "@28\n[color] {color}\n{name}")
    } else if format.frac_bits() > 0 {
        let flags = if format.is_signed() { "40000420" } else { "40000024" };
        writeln!(to, "@{flags}\n[fpshift_count] {}\n[color] {color}", format.frac_bits())?;
        writeln!(to, "{name}{range}")
    } else {
        let flags = if format.is_signed() { "420" } else { "24" };
        writeln!(to, "@{flags}\n[color] {color}\n{name}{range}")
    }
}

fn top_index(format: Format) -> i32 {
    cast::signed_count(format.bits()) - format.frac_bits() - 1
}

/// Indices of a word's bits with the binary point below 0; none for one bit.
fn index_range(format: Format) -> Option<ReferenceIndex> {
    let range = ReferenceIndex::Range(top_index(format), -format.frac_bits());
    (format.bits() > 1).then_some(range)
}

fn path_text(netlist: &Netlist, trace: &Trace) -> String {
    let mut text = format!("{}.", netlist.name());
    for scope in &trace.path {
        text.push_str(scope);
        text.push('.');
    }
    text
}

/// `scope.name`, what patterns are matched with.
fn full_name(trace: &Trace) -> String {
    let mut names = trace.path.clone();
    names.push(trace.name.clone());
    names.join(".")
}

/// Every signal that could be shown, ports first.
fn all_traces(rtl: &Rtl, options: &Options) -> Vec<Trace> {
    let netlist = rtl.netlist();
    // Nothing upstream of an exact node was rounded or tabulated: its error is 0 always.
    let mut exact: Vec<bool> = Vec::new();
    for node in netlist.nodes() {
        let lossy =
            node.meaning.is_some() || matches!(node.op, Op::Narrow { .. } | Op::Read { .. });
        exact.push(!lossy && node.operands.iter().all(|operand| exact[operand.index()]));
    }
    let trace = |signal: Signal, path: Vec<String>, name: String, port: Option<usize>| {
        let node = netlist.node(signal.node);
        let twins = match port {
            _ if !node.has_real || node.format.bits() == 1 => 0,
            Some(_) => 5,
            None if exact[signal.node.index()] => 1,
            None => 3,
        };
        Trace { signal, path, name, quantity: node.quantity, twins, port }
    };
    let mut traces = Vec::new();
    for (port, output) in netlist.outputs().iter().enumerate() {
        traces.push(trace(rtl.output(output.node), Vec::new(), output.name.clone(), Some(port)));
    }
    for id in netlist.ids() {
        let node = netlist.node(id);
        if matches!(node.op, Op::Const { .. }) {
            continue;
        }
        let path: Vec<String> =
            netlist.scope_path(node.scope).into_iter().map(str::to_owned).collect();
        let own = Signal { node: id, stage: rtl.schedule().stage(id) };
        let name = rtl.local_name(own);
        // What goes into an output register has the port's name, and the port is there already.
        let is_shown = node.name.as_ref() == Some(&name);
        if !is_shown && !options.all {
            continue;
        }
        // A unit's output is one operation's word after another: the hold register shows it.
        let mut own_twins = rtl.is_free(id);
        if own_twins {
            traces.push(trace(own, path.clone(), name, None));
        }
        let shown = match (options.all, rtl.schedule().interval()) {
            (true, _) => usize::MAX,
            (false, 1) => usize::from(!own_twins),
            (false, _) => 1,
        };
        if shown > 0 {
            for register in rtl.registers(id).take(shown) {
                let is_output = netlist.outputs().iter().any(|o| rtl.output(o.node) == register);
                if !is_output {
                    let mut copy = trace(register, path.clone(), rtl.local_name(register), None);
                    if own_twins {
                        copy.twins = 0;
                    }
                    own_twins = true;
                    traces.push(copy);
                }
            }
        }
    }
    let mut names = BTreeSet::new();
    traces.retain(|trace| names.insert(full_name(trace)));
    traces
}

/// Identifiers and last values of the signals.
struct Codes<'a> {
    clk: Code,
    rst: Code,
    valid_in: Shown,
    valid_out: Shown,
    words: Vec<Word>,
    twins: Twins<'a>,
    units: Option<UnitCodes>,
}

/// What was written of a variable last: its pattern, or one of these, which no pattern is.
const NOTHING: u64 = u64::MAX;
const UNKNOWN: u64 = u64::MAX - 1;

/// A variable of bits, and what it shows.
struct Shown {
    code: Code,
    bits: u32,
    last: u64,
}

impl Shown {
    fn new(code: IdCode, bits: u32) -> Self {
        Self { code: code.into(), bits, last: NOTHING }
    }

    /// Writes a pattern if it is another.
    #[inline(always)]
    fn change(&mut self, lines: &mut Lines<'_>, now: u64) -> io::Result<()> {
        if self.last == now {
            return Ok(());
        }
        self.last = now;
        lines.word((now != UNKNOWN).then_some(now), self.bits, &self.code)
    }
}

/// A signal's word.
struct Word {
    shown: Shown,
    format: Format,
    /// Where the simulator has it.
    slot: usize,
    stage: u64,
    /// The phase that it means something in; a register holds its word.
    phase: Option<u32>,
}

impl<'a> Codes<'a> {
    fn declare<W: Write>(
        writer: &mut vcd::Writer<W>,
        wave: &'a Wave<'_>,
        cycle: &Cycle,
        oldest: usize,
    ) -> io::Result<Self> {
        let (netlist, schedule) = (wave.rtl.netlist(), wave.rtl.schedule());
        writer.add_module(netlist.name())?;
        let (clk, rst) = (writer.add_wire(1, "clk")?.into(), writer.add_wire(1, "rst")?.into());
        let valid_in = Shown::new(writer.add_wire(1, "valid_in")?, 1);
        let valid_out = Shown::new(writer.add_wire(1, "valid_out")?, 1);
        let units = UnitCodes::declare(writer, &wave.rtl, &wave.table, cycle)?;
        let mut order: Vec<&Trace> = wave.traces.iter().collect();
        order.sort_by(|a, b| a.path.cmp(&b.path));
        let (mut words, mut twins) = (Vec::new(), Vec::new());
        let mut open: &[String] = &[];
        for trace in order {
            let common = trace.path.iter().zip(open).take_while(|(a, b)| a == b).count();
            for _ in common..open.len() {
                writer.upscope()?;
            }
            for scope in &trace.path[common..] {
                writer.add_module(scope)?;
            }
            open = &trace.path;
            let Signal { node, stage } = trace.signal;
            let format = netlist.node(node).format;
            let code =
                writer.add_var(VarType::Wire, format.bits(), &trace.name, index_range(format))?;
            words.push(Word {
                shown: Shown::new(code, format.bits()),
                format,
                slot: cycle.slot(trace.signal),
                stage: stage.into(),
                phase: (stage == schedule.stage(node)).then(|| schedule.phase(stage)),
            });
            let mut codes = Vec::new();
            for name in trace.names().iter().take(trace.twins) {
                codes.push(writer.add_var(VarType::Real, 64, name, None)?);
            }
            twins.push((trace, codes));
        }
        for _ in open {
            writer.upscope()?;
        }
        writer.upscope()?;
        writer.enddefinitions()?;
        let twins = Twins::new(wave.design, &wave.rtl, cycle, twins, oldest);
        Ok(Self { clk, rst, valid_in, valid_out, words, twins, units })
    }

    /// Writes what changed after a rising edge.
    fn change(
        &mut self,
        lines: &mut Lines<'_>,
        rtl: &Rtl,
        samples: &[Vec<i64>],
        cycle: &Cycle,
    ) -> io::Result<()> {
        self.valid_in.change(lines, cycle.is_data(0).into())?;
        self.valid_out.change(lines, cycle.is_data(rtl.schedule().latency()).into())?;
        let (words, edges, phase) = (cycle.words(), cycle.edges(), cycle.phase());
        for word in &mut self.words {
            let known = edges >= word.stage && word.phase.is_none_or(|own| own == phase);
            let now = if known { word.format.pattern(words[word.slot]) } else { UNKNOWN };
            word.shown.change(lines, now)?;
        }
        self.twins.change(lines, samples, cycle)?;
        self.units.as_mut().map_or(Ok(()), |units| units.change(lines, cycle))
    }
}

/// The nodes that a wave shows, for tests.
impl Wave<'_> {
    /// Names and nodes of the signals, with their stages.
    pub fn signals(&self) -> impl Iterator<Item = (String, NodeId, u32)> + '_ {
        self.traces.iter().map(|trace| (full_name(trace), trace.signal.node, trace.signal.stage))
    }
}
