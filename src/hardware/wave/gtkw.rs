//! GTKWave's save file.

use super::choice::Wave;
use super::shown::top_index;
use super::trace::{DEGREES, Trace, Twin};
use super::units;
use crate::base::cast;
use crate::netlist::op::Op;
use crate::netlist::{Netlist, Quantity};
use crate::number::format::Format;
use std::io::{self, Write};
use std::path::Path;

impl Wave<'_> {
    /// Writes the GTKWave save file for a VCD of this name.
    ///
    /// # Errors
    /// If `to` can't be written.
    pub fn write_gtkw(&self, vcd: &Path, to: &mut dyn Write) -> io::Result<()> {
        let netlist = self.rtl.netlist();
        let unit = netlist.name();
        // The file name without its folder, so that both files can be moved together. GTKWave reads
        // it literally, from the first quote of the line to the last; a name that can't be written
        // on a line must be given on the command line.
        let name = vcd.file_name().unwrap_or_default();
        let file = name.to_str().filter(|name| !name.contains(['\n', '\r']));
        writeln!(to, "[*] fixpath {}: unit {unit}", env!("CARGO_PKG_VERSION"))?;
        // The first samples start at the left edge, as wide as leaves their results visible.
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
        let cycles = f64::from(schedule.latency() + FIRST_SAMPLES * schedule.phases());
        let width = (WAVES_WIDTH / cycles).min(CYCLE_WIDTH);
        // GTKWave draws 2^-zoom units of time over 200 pixels.
        let zoom = -libm::log2(cast::f64_of_count(self.period_ps) * 200.0 / width);
        writeln!(to, "*{zoom:.6} 0 {}", "-1 ".repeat(26).trim_end())?;
        writeln!(to, "@28\n{unit}.clk\n{unit}.rst")?;
        for name in self.slow_valids() {
            writeln!(to, "{unit}.{name}")?;
        }
        writeln!(to, "{unit}.valid_in\n{unit}.valid_out")?;
        self.write_units(to)?;
        let is_input = |trace: &Trace| netlist.node(trace.signal.node).op == Op::Input;
        self.write_group("input ports", is_input, to)?;
        if !self.angles.is_empty() {
            writeln!(to, "@200\n-angle to the golden model")?;
        }
        for angle in &self.angles {
            write_gtkw_real(&format!("{unit}.{}{DEGREES}", angle.name), ERROR_COLOR, 2, to)?;
        }
        let latency = self.rtl.schedule().latency();
        let title = format!("output ports, {latency} cycles later");
        self.write_group(&title, |trace| trace.port.is_some(), to)?;
        let shared = self.rtl.schedule().phases() > 1;
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
            // A value that the word already shows is omitted, but an angle's value has another
            // unit.
            let (color, rows) = match twin {
                Twin::Value if is_output => (color, 1),
                Twin::Value if trace.word && trace.quantity != Quantity::Turns => continue,
                Twin::Value => (color, 0),
                Twin::Ideal | Twin::ArithError if trace.word => continue,
                // As curves: truncated text would lose its exponent.
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

/// Pixels of GTKWave's window, its tree, and its list of names, which is wide enough for whole
/// numbers.
const WINDOW_WIDTH: u32 = 1500;
const TREE_WIDTH: u32 = 110;
const NAMES_WIDTH: u32 = 430;
/// Pixels that remain for the waves.
const WAVES_WIDTH: f64 = 920.0;
/// Width of a cycle that shows words and errors in full.
const CYCLE_WIDTH: f64 = 100.0;
/// Number of samples whose results are visible at the start.
const FIRST_SAMPLES: u32 = 2;

/// Red.
const ERROR_COLOR: u8 = 1;

/// A real in the save file: as text if `rows` is 0, otherwise as steps scaled to all data, with
/// `rows` blank rows below its name.
fn write_gtkw_real(name: &str, color: u8, rows: usize, to: &mut dyn Write) -> io::Result<()> {
    if rows == 0 {
        return writeln!(to, "@20\n[color] {color}\n{name}");
    }
    let space = "\n-".repeat(rows);
    writeln!(to, "@88420\n[color] {color}\n{name}\n@20000{space}")
}

/// A word in the save file, with its fixed-point shift.
fn write_gtkw_word(name: &str, format: Format, color: u8, to: &mut dyn Write) -> io::Result<()> {
    // GTKWave renumbers bits from 0 where the declared top index is not above 0.
    let range = if top_index(format) > 0 {
        format!("[{}:{}]", top_index(format), -format.frac_bits())
    } else {
        format!("[{}:0]", format.bits() - 1)
    };
    // Fixed-point shift of the decimal display, signed or unsigned.
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

fn path_text(netlist: &Netlist, trace: &Trace) -> String {
    let mut text = format!("{}.", netlist.name());
    for scope in &trace.path {
        text.push_str(scope);
        text.push('.');
    }
    text
}
