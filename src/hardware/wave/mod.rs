//! Waves of the pipelined hardware: a VCD file and a GTKWave save file beside it.
//!
//! Words are declared with the binary point as a negative least index, so `[1:-14]` is a
//! 16-bit word with 14 fraction bits. Beside each named word stand three reals: its value, the
//! netlist evaluated on reals for the same sample (`ideal`), and the difference (`arith_error`);
//! beside each output port also the golden, and the difference to that (`total_error`). Words that are exact, such as sums of inputs, have
//! only their value. Angles are in degrees there, and their errors are
//! taken modulo a turn. Each direction has the angle between it and its golden (`angle_error_deg`), which reports
//! rank by. GTKWave cuts long numbers, and with them the exponent of a small error, so errors also stand in ulp of
//! their word, to 1/256 (`arith_error_ulp`, `total_error_ulp`): short, and without exponent. In stage s, cycle t shows the sample that entered at cycle t - s;
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

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::output;
use crate::design::{Design, Group};
use crate::hardware::cycle::Cycle;
use crate::hardware::rtl::{Rtl, Signal};
use crate::hardware::timetable::Timetable;
use crate::measure::angle_quantities;
use crate::netlist::op::Op;
use crate::netlist::{Netlist, NodeId, Quantity};
use crate::number::format::Format;
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
    /// Patterns of signals to write, with `*` for any text; every named one if empty. A word comes with its
    /// twins, and a twin, with or without the unit in its name, may be chosen alone.
    pub signals: Vec<String>,
    /// Also nodes without a name, and the registers that carry words to later stages.
    pub all: bool,
    /// No real twins and no angles.
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
    /// True if the word itself is shown, not only some of its twins.
    word: bool,
    /// The reals beside it.
    twins: Vec<Twin>,
    /// Number of the output port that it is.
    port: Option<usize>,
}

/// A real beside a word.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Twin {
    Value,
    Ideal,
    ArithError,
    ArithErrorUlp,
    Golden,
    TotalError,
    TotalErrorUlp,
}

impl Twin {
    /// Those of an exact word.
    const EXACT: &[Self] = &[Self::Value];
    /// Those of another word inside.
    const INSIDE: &[Self] = &[Self::Value, Self::Ideal, Self::ArithError, Self::ArithErrorUlp];
    /// Those of an output port.
    const PORT: &[Self] = &[
        Self::Value,
        Self::Ideal,
        Self::ArithError,
        Self::ArithErrorUlp,
        Self::Golden,
        Self::TotalError,
        Self::TotalErrorUlp,
    ];

    fn name(self) -> &'static str {
        match self {
            Self::Value => "value",
            Self::Ideal => "ideal",
            Self::ArithError | Self::ArithErrorUlp => "arith_error",
            Self::Golden => "golden",
            Self::TotalError | Self::TotalErrorUlp => "total_error",
        }
    }

    fn is_in_ulp(self) -> bool {
        matches!(self, Self::ArithErrorUlp | Self::TotalErrorUlp)
    }
}

/// The angle between a direction and its golden.
#[derive(Clone, Debug)]
struct AngleTrace {
    /// Name without its unit.
    name: String,
    /// Number of the direction.
    direction: usize,
    /// The stage in which all of the direction is there.
    stage: u32,
}

/// Unit of angles at the end of a name.
const DEGREES: &str = "_deg";

impl Trace {
    /// Name of a twin, and its unit behind it.
    fn twin_name(&self, twin: Twin) -> (String, &'static str) {
        let unit = match self.quantity {
            Quantity::Turns => DEGREES,
            Quantity::Number | Quantity::Float20 => "",
        };
        let unit = if twin.is_in_ulp() { "_ulp" } else { unit };
        (format!("{}_{}", self.name, twin.name()), unit)
    }

    /// Leaves what patterns choose: all of a word that one matches, or the twins that one does.
    fn choose(&mut self, patterns: &[String]) {
        let any = |text: &str| patterns.iter().any(|pattern| matches(pattern, text));
        if any(&full_name(self)) {
            return;
        }
        self.word = false;
        let scopes = self.path.iter().map(|scope| format!("{scope}.")).collect::<String>();
        let mut twins = std::mem::take(&mut self.twins);
        twins.retain(|twin| {
            let (name, unit) = self.twin_name(*twin);
            any(&format!("{scopes}{name}{unit}")) || any(&format!("{scopes}{name}"))
        });
        self.twins = twins;
    }

    fn is_shown(&self) -> bool {
        self.word || !self.twins.is_empty()
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
    angles: Vec<AngleTrace>,
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
        let mut angles = all_angles(design, &rtl);
        if options.words_only {
            traces.iter_mut().for_each(|trace| trace.twins.clear());
            angles.clear();
        }
        for pattern in &options.signals {
            let chosen = |trace: &Trace| {
                let mut trace = trace.clone();
                trace.choose(std::slice::from_ref(pattern));
                trace.is_shown()
            };
            if !traces.iter().any(chosen) && !angles.iter().any(|angle| angle.matches(pattern)) {
                let mut names: Vec<String> = traces.iter().map(full_name).collect();
                names.truncate(8);
                return Err(Error::usage(format!(
                    "no signal matches `{pattern}`: there are {}, …; *error takes all errors, --all adds unnamed signals",
                    names.join(", ")
                )));
            }
        }
        if !options.signals.is_empty() {
            traces.iter_mut().for_each(|trace| trace.choose(&options.signals));
            traces.retain(Trace::is_shown);
            angles.retain(|angle| options.signals.iter().any(|pattern| angle.matches(pattern)));
        }
        let target = design.values.int("period_ps").expect("bug: no auto here");
        let period_ps = u64::from(rtl.schedule().period_ps()).max(target.unsigned_abs());
        let table = Timetable::new(&rtl, design.printed());
        let period_ps = period_ps.next_multiple_of(2);
        Ok(Self { design, rtl, table, traces, angles, options, period_ps })
    }

    /// The hardware that it shows.
    #[must_use]
    pub fn rtl(&self) -> &Rtl {
        &self.rtl
    }

    /// Number of signals.
    #[must_use]
    pub fn len(&self) -> usize {
        self.traces.len() + self.angles.len()
    }

    /// True if there is no signal.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
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
        // The name alone: the pair of files can be moved together. GTKWave takes it as it is from the first quote of
        // the line to the last; what can't stand in a line is left to the command line.
        let name = vcd.file_name().unwrap_or_default();
        let file = name.to_str().filter(|name| !name.contains(['\n', '\r']));
        writeln!(to, "[*] fixpath {}: unit {unit}", env!("CARGO_PKG_VERSION"))?;
        // The first samples from the left edge on, as wide as lets their results be seen too.
        let start = self.options.cycles.as_ref().map_or(0, |cycles| cycles.start) * self.period_ps;
        if let Some(file) = file {
            writeln!(to, "[dumpfile] \"{file}\"")?;
        }
        writeln!(to, "[timestart] {start}")?;
        writeln!(to, "[size] {WINDOW_WIDTH} 1000\n[pos] -1 -1")?;
        writeln!(
            to,
            "[sst_width] {TREE_WIDTH}\n[signals_width] {NAMES_WIDTH}\n[sst_expanded] 0\n[treeopen] {unit}."
        )?;
        let schedule = self.rtl.schedule();
        let cycles = f64::from(schedule.latency() + FIRST_SAMPLES * schedule.interval());
        let width = (WAVES_WIDTH / cycles).min(CYCLE_WIDTH);
        // GTKWave draws 2^-zoom units of time in 200 pixels.
        let zoom = -libm::log2(cast::f64_of_count(self.period_ps) * 200.0 / width);
        writeln!(to, "*{zoom:.6} 0 {}", "-1 ".repeat(26).trim_end())?;
        writeln!(to, "@28\n{unit}.clk\n{unit}.rst\n{unit}.valid_in\n{unit}.valid_out")?;
        self.write_units(to)?;
        let is_input = |trace: &Trace| netlist.node(trace.signal.node).op == Op::Input;
        self.write_group("input ports", is_input, to)?;
        if !self.angles.is_empty() {
            writeln!(to, "@200\n-angle to the golden")?;
        }
        for angle in &self.angles {
            write_gtkw_real(&format!("{unit}.{}{DEGREES}", angle.name), ERROR_COLOR, 2, to)?;
        }
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
        let is_output = trace.port.is_some();
        let color = if is_output || node.op == Op::Input { 2 } else { 3 };
        if trace.word {
            write_gtkw_word(&format!("{dots}{}", trace.name), format, color, to)?;
        }
        let order = [
            Twin::Value,
            Twin::Ideal,
            Twin::Golden,
            Twin::TotalError,
            Twin::TotalErrorUlp,
            Twin::ArithError,
            Twin::ArithErrorUlp,
        ];
        for twin in order.into_iter().filter(|twin| trace.twins.contains(twin)) {
            // What the word beside it tells isn't shown again, but an angle's value has another unit.
            let (color, rows) = match twin {
                Twin::Value if is_output => (color, 1),
                Twin::Value if trace.word && trace.quantity != Quantity::Turns => continue,
                Twin::Value => (color, 0),
                Twin::Ideal | Twin::ArithError if trace.word => continue,
                // As curves: cut text would lose its exponent.
                Twin::Ideal | Twin::Golden => (5, 1),
                Twin::TotalError | Twin::ArithError => (ERROR_COLOR, 2),
                Twin::TotalErrorUlp | Twin::ArithErrorUlp => (ERROR_COLOR, 0),
            };
            let (name, unit) = trace.twin_name(twin);
            write_gtkw_real(&format!("{dots}{name}{unit}"), color, rows, to)?;
        }
        Ok(())
    }
}

/// Pixels of GTKWave's window, of its tree and of its list of names, which shows numbers in full.
const WINDOW_WIDTH: u32 = 1500;
const TREE_WIDTH: u32 = 110;
const NAMES_WIDTH: u32 = 430;
/// Pixels that waves have then.
const WAVES_WIDTH: f64 = 920.0;
/// A cycle's width that shows words and errors in full.
const CYCLE_WIDTH: f64 = 100.0;
/// Samples whose results are to be seen at the start.
const FIRST_SAMPLES: u32 = 2;

/// Red.
const ERROR_COLOR: u8 = 1;

/// A real in the save file: as text, or as steps scaled to all of the data, so many rows below its name.
fn write_gtkw_real(name: &str, color: u8, rows: usize, to: &mut dyn Write) -> io::Result<()> {
    if rows == 0 {
        return writeln!(to, "@20\n[color] {color}\n{name}");
    }
    let space = "\n-".repeat(rows);
    writeln!(to, "@88420\n[color] {color}\n{name}\n@20000{space}")
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
            _ if !node.has_real || node.format.bits() == 1 => &[],
            Some(_) => Twin::PORT,
            None if exact[signal.node.index()] => Twin::EXACT,
            None => Twin::INSIDE,
        };
        let twins = twins.to_vec();
        Trace { signal, path, name, quantity: node.quantity, word: true, twins, port }
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
                        copy.twins.clear();
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

/// The angle of every direction.
fn all_angles(design: &Design, rtl: &Rtl) -> Vec<AngleTrace> {
    let netlist = rtl.netlist();
    let stage = |node: &NodeId| {
        let is_output = netlist.outputs().iter().any(|output| output.node == *node);
        if is_output { rtl.schedule().latency() } else { rtl.schedule().stage(*node) }
    };
    let directions = design.groups.iter().filter(|group| group.shape.is_direction());
    let names = angle_quantities(design).into_iter();
    let angle = |(direction, (group, name)): (usize, (&Group, String))| AngleTrace {
        name: format!("{name}_error"),
        direction,
        stage: group.nodes.iter().map(stage).max().unwrap_or(0),
    };
    directions.zip(names).enumerate().map(angle).collect()
}

impl AngleTrace {
    /// True if a pattern chooses it, with its unit or without.
    fn matches(&self, pattern: &str) -> bool {
        matches(pattern, &self.name) || matches(pattern, &format!("{}{DEGREES}", self.name))
    }
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
            if trace.word {
                let code = writer.add_var(
                    VarType::Wire,
                    format.bits(),
                    &trace.name,
                    index_range(format),
                )?;
                words.push(Word {
                    shown: Shown::new(code, format.bits()),
                    format,
                    slot: cycle.slot(trace.signal),
                    stage: stage.into(),
                    phase: (stage == schedule.stage(node)).then(|| schedule.phase(stage)),
                });
            }
            let mut codes = Vec::new();
            for twin in &trace.twins {
                let (name, unit) = trace.twin_name(*twin);
                codes.push(writer.add_var(VarType::Real, 64, &format!("{name}{unit}"), None)?);
            }
            twins.push((trace, codes));
        }
        for _ in open {
            writer.upscope()?;
        }
        let mut angles = Vec::new();
        for angle in &wave.angles {
            let name = format!("{}{DEGREES}", angle.name);
            angles.push((angle, writer.add_var(VarType::Real, 64, &name, None)?));
        }
        writer.upscope()?;
        writer.enddefinitions()?;
        let twins = Twins::new(wave.design, &wave.rtl, cycle, twins, angles, oldest);
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
    /// Names and nodes of the words, with their stages.
    pub fn signals(&self) -> impl Iterator<Item = (String, NodeId, u32)> + '_ {
        let words = self.traces.iter().filter(|trace| trace.word);
        words.map(|trace| (full_name(trace), trace.signal.node, trace.signal.stage))
    }
}
