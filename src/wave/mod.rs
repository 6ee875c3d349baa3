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

mod units;

use crate::cast;
use crate::error::{Error, Result};
use crate::netlist::{Netlist, NodeId, Quantity};
use crate::op::Op;
use crate::output;
use crate::rtl::{Rtl, Signal};
use crate::sim::cycle::Cycle;
use crate::timetable::Timetable;
use crate::units::Design;
use std::collections::{BTreeSet, VecDeque};
use std::io::{self, Write};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;
use units::UnitCodes;
use vcd::{IdCode, ReferenceIndex, TimescaleUnit, Value, VarType};

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
        let cycle = self.write_cycles(samples, to).map_err(output::at(path))?;
        match cycle.forbidden_overflow() {
            Some(node) => Err(Error::node_overflow(self.rtl.netlist().label(node), 1)),
            None => {
                let first = self.options.cycles.as_ref().map_or(0, |cycles| cycles.start);
                Ok(cycle.edges().saturating_sub(first))
            }
        }
    }

    fn write_cycles(&self, samples: &[Vec<i64>], to: &mut dyn Write) -> io::Result<Cycle> {
        let netlist = self.rtl.netlist();
        let latency = self.rtl.schedule().latency();
        let mut writer = vcd::Writer::new(to);
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
        let mut codes = Codes::declare(&mut writer, self)?;

        let total = self.cycles(samples.len());
        let interval = u64::from(self.rtl.schedule().interval());
        let window = self.options.cycles.clone().unwrap_or(0..total);
        let mut cycle = Cycle::new(Arc::clone(&self.rtl));
        // Real values of the samples in the pipeline, the latest first.
        let depth = cast::index_of_u32(latency + self.rtl.schedule().interval());
        let mut ideals: VecDeque<Option<Ideal>> = VecDeque::with_capacity(depth + 1);
        let idle = vec![0; netlist.inputs().len()];
        let mut first = true;
        for at in 0..total.min(window.end) {
            let ready = at % interval == 0;
            let number = usize::try_from(at / interval).ok().filter(|_| ready);
            let sample = number.and_then(|number| samples.get(number));
            cycle.settle(sample.unwrap_or(&idle), sample.is_some());
            // Twins are only evaluated for samples that can be seen.
            let seen = at + u64::from(latency) + interval > window.start;
            ideals.push_front(sample.filter(|_| seen).map(|words| self.ideal(words)));
            ideals.truncate(depth);
            if at >= window.start {
                writer.timestamp(at * self.period_ps)?;
                if first {
                    writer.begin(vcd::SimulationCommand::Dumpvars)?;
                }
                codes.change(&mut writer, self, &cycle, &ideals)?;
                if first {
                    writer.end()?;
                    first = false;
                }
                writer.timestamp(at * self.period_ps + self.period_ps / 2)?;
                codes.fall(&mut writer)?;
            }
            cycle.clock();
        }
        writer.timestamp(total.min(window.end) * self.period_ps)?;
        writer.flush()?;
        Ok(cycle)
    }

    fn ideal(&self, words: &[i64]) -> Ideal {
        let netlist = self.rtl.netlist();
        let inputs: Vec<f64> = netlist
            .inputs()
            .iter()
            .zip(words)
            .map(|(id, word)| netlist.node(*id).format.value(*word))
            .collect();
        let columns: Vec<&[f64]> = inputs.iter().map(std::slice::from_ref).collect();
        let mut golden = vec![vec![0.0]; self.design.golden_columns()];
        (self.design.golden)(&self.design.values, &columns, &mut golden);
        let golden: Vec<f64> = golden.iter().map(|column| column[0]).collect();
        Ideal { nodes: netlist.eval_reals(&inputs), judged: self.design.of_golden(&golden) }
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
fn write_gtkw_word(
    name: &str,
    format: crate::format::Format,
    color: u8,
    to: &mut dyn Write,
) -> io::Result<()> {
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

/// Values on reals of one sample.
#[derive(Debug)]
struct Ideal {
    nodes: Vec<f64>,
    /// Golden values of the judged nodes, which start with the output ports.
    judged: Vec<f64>,
}

fn top_index(format: crate::format::Format) -> i32 {
    cast::signed_count(format.bits()) - format.frac_bits() - 1
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
struct Codes {
    clk: IdCode,
    rst: IdCode,
    valid_in: IdCode,
    valid_out: IdCode,
    last_valid: [Option<bool>; 2],
    words: Vec<(IdCode, Option<Option<i64>>)>,
    twins: Vec<Vec<(IdCode, Option<f64>)>>,
    units: Option<UnitCodes>,
    started: bool,
}

impl Codes {
    fn declare<W: Write>(writer: &mut vcd::Writer<W>, wave: &Wave<'_>) -> io::Result<Self> {
        let netlist = wave.rtl.netlist();
        writer.add_module(netlist.name())?;
        let mut wire = |name: &str| writer.add_wire(1, name);
        let mut codes = Self {
            clk: wire("clk")?,
            rst: wire("rst")?,
            valid_in: wire("valid_in")?,
            valid_out: wire("valid_out")?,
            last_valid: [None; 2],
            words: Vec::new(),
            twins: Vec::new(),
            units: None,
            started: false,
        };
        codes.units = UnitCodes::declare(writer, &wave.rtl)?;
        let mut order: Vec<usize> = (0..wave.traces.len()).collect();
        order.sort_by(|a, b| wave.traces[*a].path.cmp(&wave.traces[*b].path));
        let placeholder = codes.clk;
        codes.words = vec![(placeholder, None); wave.traces.len()];
        codes.twins = vec![Vec::new(); wave.traces.len()];
        let mut open: Vec<String> = Vec::new();
        for index in order {
            let trace = &wave.traces[index];
            while !trace.path.starts_with(&open) {
                writer.upscope()?;
                open.pop();
            }
            for scope in &trace.path[open.len()..] {
                writer.add_module(scope)?;
                open.push(scope.clone());
            }
            let format = netlist.node(trace.signal.node).format;
            let range = (format.bits() > 1)
                .then(|| ReferenceIndex::Range(top_index(format), -format.frac_bits()));
            codes.words[index].0 =
                writer.add_var(VarType::Wire, format.bits(), &trace.name, range)?;
            for name in trace.names().iter().take(trace.twins) {
                codes.twins[index].push((writer.add_var(VarType::Real, 64, name, None)?, None));
            }
        }
        for _ in open {
            writer.upscope()?;
        }
        writer.upscope()?;
        writer.enddefinitions()?;
        Ok(codes)
    }

    /// Writes what changed after a rising edge.
    fn change<W: Write>(
        &mut self,
        writer: &mut vcd::Writer<W>,
        wave: &Wave<'_>,
        cycle: &Cycle,
        ideals: &VecDeque<Option<Ideal>>,
    ) -> io::Result<()> {
        let netlist = wave.rtl.netlist();
        writer.change_scalar(self.clk, true)?;
        if !self.started {
            writer.change_scalar(self.rst, false)?;
            self.started = true;
        }
        let valid = [cycle.is_data(0), cycle.is_data(wave.rtl.schedule().latency())];
        for ((code, now), last) in
            [self.valid_in, self.valid_out].into_iter().zip(valid).zip(&mut self.last_valid)
        {
            if *last != Some(now) {
                writer.change_scalar(code, now)?;
                *last = Some(now);
            }
        }
        for ((trace, word), twins) in wave.traces.iter().zip(&mut self.words).zip(&mut self.twins) {
            let node = netlist.node(trace.signal.node);
            let schedule = wave.rtl.schedule();
            let stage = trace.signal.stage;
            // In its own stage a word means something in its phase; a register holds it.
            let is_own = stage == schedule.stage(trace.signal.node);
            let ago =
                (cycle.phase() + schedule.interval() - schedule.phase(stage)) % schedule.interval();
            let known = cycle.known(stage) && !(is_own && ago > 0);
            let now = known.then(|| cycle.word(trace.signal));
            if word.1 != Some(now) {
                word.1 = Some(now);
                change_word(writer, word.0, node.format, now)?;
            }
            let entered = cast::index_of_u32(stage + ago);
            let (Some(now), Some(Some(ideal))) = (now, ideals.get(entered)) else { continue };
            let scale = trace.scale();
            let value = node.format.value(now) * scale;
            let ideal_value = ideal.nodes[trace.signal.node.index()] * scale;
            // Angles differ by half a turn at most.
            let difference = |other: f64| {
                let difference = value - other;
                match trace.quantity {
                    Quantity::Turns => difference - 360.0 * (difference / 360.0).round(),
                    Quantity::Number | Quantity::Float20 => difference,
                }
            };
            let golden = trace.port.map_or(0.0, |port| ideal.judged[port] * scale);
            let shown = [value, ideal_value, difference(ideal_value), golden, difference(golden)];
            for (twin, shown) in twins.iter_mut().zip(shown) {
                if twin.1.map(f64::to_bits) != Some(shown.to_bits()) {
                    twin.1 = Some(shown);
                    writer.change_real(twin.0, shown)?;
                }
            }
        }
        if let Some(units) = &mut self.units {
            units.change(writer, &wave.rtl, &wave.table, cycle)?;
        }
        Ok(())
    }

    fn fall<W: Write>(&mut self, writer: &mut vcd::Writer<W>) -> io::Result<()> {
        writer.change_scalar(self.clk, false)
    }
}

fn change_word<W: Write>(
    writer: &mut vcd::Writer<W>,
    code: IdCode,
    format: crate::format::Format,
    word: Option<i64>,
) -> io::Result<()> {
    if format.bits() == 1 {
        return writer.change_scalar(code, word.map_or(Value::X, |word| (word != 0).into()));
    }
    match word {
        None => writer.change_vector(code, [Value::X]),
        Some(word) => {
            let pattern = format.pattern(word);
            let bits = (0..format.bits()).rev().map(|bit| Value::from(pattern >> bit & 1 == 1));
            writer.change_vector(code, bits)
        }
    }
}

/// The nodes that a wave shows, for tests.
impl Wave<'_> {
    /// Names and nodes of the signals, with their stages.
    pub fn signals(&self) -> impl Iterator<Item = (String, NodeId, u32)> + '_ {
        self.traces.iter().map(|trace| (full_name(trace), trace.signal.node, trace.signal.stage))
    }
}
