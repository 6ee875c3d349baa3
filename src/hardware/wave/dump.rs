//! Waves as VCD files.

use super::choice::Wave;
use super::shown::{Shown, UNKNOWN, index_range};
use super::text::{Code, Lines};
use super::trace::{DEGREES, Trace};
use super::twins::Twins;
use super::units::UnitCodes;
use crate::base::error::{Error, Result};
use crate::base::output;
use crate::hardware::cycle::Cycle;
use crate::hardware::rtl::{Rtl, Signal};
use crate::netlist::{Netlist, Rate};
use crate::number::format::Format;
use crate::schedule::Schedule;
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;
use vcd::{TimescaleUnit, VarType};

impl Wave<'_> {
    /// Simulates one sample per run through all phases (one per interval if all ports have one
    /// rate) and writes the VCD. The simulation runs on until the last result is out.
    ///
    /// # Errors
    /// If `to` can't be written; the error names `path`. If a `narrow` under overflow mode `error`
    /// overflowed on valid data.
    ///
    /// # Panics
    /// If the samples don't match the input ports.
    pub fn write(&self, samples: &[Vec<i64>], to: &mut dyn Write, path: &Path) -> Result<u64> {
        self.write_with(samples, to, path, &|_| ())
    }

    /// As [`Wave::write`]; `progress` receives the number of cycles done.
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
            (self.rtl.schedule().latency(), u64::from(self.rtl.schedule().phases()));
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
        // The oldest sample that can be in the pipeline when the window starts.
        let oldest = window.start.saturating_sub(u64::from(latency) + interval) / interval;
        let oldest = usize::try_from(oldest).unwrap_or(usize::MAX).min(samples.len());
        let mut codes = Codes::declare(&mut writer, self, &cycle, oldest)?;
        let mut lines = Lines::new(to);

        let mut stimulus = Stimulus::new(netlist, self.rtl.schedule(), samples);
        for at in 0..end {
            let (words, data) = stimulus.at(at);
            cycle.settle_rates(words, |rate| data[rate]).map_err(io::Error::other)?;
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
}

/// The words at the ports in each cycle. Words of each rate come with their sample, delayed by the
/// rate's entry. Words of slower rates are data only where they change.
struct Stimulus<'a> {
    samples: &'a [Vec<i64>],
    interval: u64,
    /// By rate: the cycle in which it enters, and the ports of that rate and of slower ones.
    rates: Vec<(u64, Vec<usize>)>,
    /// Index of the rate of each port.
    rate_of: Vec<usize>,
    words: Vec<i64>,
    data: Vec<bool>,
}

impl<'a> Stimulus<'a> {
    fn new(netlist: &Netlist, schedule: &Schedule, samples: &'a [Vec<i64>]) -> Self {
        let timings = schedule.timings();
        let rates: Vec<Rate> = netlist.inputs().iter().map(|id| netlist.node(*id).rate).collect();
        let up_to = |rate: Rate| (0..rates.len()).filter(|port| rates[*port] <= rate).collect();
        let place = |own: &Rate| timings.iter().position(|timing| timing.rate == *own);
        Self {
            samples,
            interval: schedule.phases().into(),
            rates: timings.iter().map(|timing| (timing.entry.into(), up_to(timing.rate))).collect(),
            rate_of: rates.iter().map(|own| place(own).expect("bug: it is of a port")).collect(),
            words: vec![0; rates.len()],
            data: vec![false; timings.len()],
        }
    }

    /// Words of the ports in a cycle, and which rates have data.
    fn at(&mut self, cycle: u64) -> (&[i64], &[bool]) {
        let fastest = self.rates.len() - 1;
        for (rate, (entry, ports)) in self.rates.iter().enumerate() {
            let since = cycle.checked_sub(*entry).filter(|since| since % self.interval == 0);
            let number = since.and_then(|since| usize::try_from(since / self.interval).ok());
            let sample = number.and_then(|number| self.samples.get(number));
            let before = number.and_then(|n| n.checked_sub(1)).and_then(|n| self.samples.get(n));
            let is_new = |sample: &Vec<i64>| {
                rate == fastest
                    || before.is_none_or(|before| {
                        ports.iter().any(|port| before[*port] != sample[*port])
                    })
            };
            self.data[rate] = sample.is_some_and(is_new);
            for port in ports.iter().filter(|port| self.rate_of[**port] == rate) {
                self.words[*port] = sample.map_or(0, |words| words[*port]);
            }
        }
        (&self.words, &self.data)
    }
}

/// Identifiers and latest values of the signals.
struct Codes<'a> {
    clk: Code,
    rst: Code,
    valid_in: Shown,
    /// Valid bits of slower rates, slowest first.
    valid_slow: Vec<Shown>,
    valid_out: Shown,
    words: Vec<Word>,
    twins: Twins<'a>,
    units: Option<UnitCodes>,
}

/// A signal's word.
struct Word {
    shown: Shown,
    format: Format,
    /// Index of the word in the simulator.
    slot: usize,
    stage: u64,
    /// The phase in which the word is meaningful; `None` for a register, which holds it.
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
        let mut valid_slow = Vec::new();
        for name in wave.slow_valids() {
            valid_slow.push(Shown::new(writer.add_wire(1, &name)?, 1));
        }
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
                    phase: (stage == schedule.stage(node)).then(|| stage % schedule.phases()),
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
        Ok(Self { clk, rst, valid_in, valid_slow, valid_out, words, twins, units })
    }

    /// Writes what changed after a rising edge.
    fn change(
        &mut self,
        lines: &mut Lines<'_>,
        rtl: &Rtl,
        samples: &[Vec<i64>],
        cycle: &Cycle,
    ) -> io::Result<()> {
        for (rate, valid) in self.valid_slow.iter_mut().enumerate() {
            valid.change(lines, cycle.takes(rate).into())?;
        }
        self.valid_in.change(lines, cycle.takes(self.valid_slow.len()).into())?;
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
