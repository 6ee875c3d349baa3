//! The signals that a wave shows.

use super::trace::{AngleTrace, Trace, Twin, full_name};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::name;
use crate::design::{Design, Group};
use crate::hardware::rtl::{Rtl, Signal};
use crate::hardware::timetable::Timetable;
use crate::measure::angle_quantities;
use crate::netlist::op::Op;
use crate::netlist::{NodeId, Rate};
use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;

/// Contents of a wave.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Cycles to write; all if `None`.
    pub cycles: Option<Range<u64>>,
    /// Patterns of signals to write, with `*` for any text; all named ones if empty. A word comes
    /// with its twins. A twin may be selected alone, with or without the unit in its name.
    pub signals: Vec<String>,
    /// True to include nodes without a name, and the registers that carry words to later stages.
    pub all: bool,
    /// True to omit real twins and angles.
    pub words_only: bool,
}

/// A wave, ready to be written.
#[derive(Debug)]
pub struct Wave<'a> {
    pub(super) design: &'a Design,
    pub(super) rtl: Arc<Rtl>,
    pub(super) table: Timetable,
    pub(super) traces: Vec<Trace>,
    pub(super) angles: Vec<AngleTrace>,
    pub(super) options: Options,
    pub(super) period_ps: u64,
}

impl<'a> Wave<'a> {
    /// Selects the signals.
    ///
    /// # Errors
    /// If a pattern matches no signal, or the pipeline can't be built.
    #[expect(clippy::missing_panics_doc, reason = "period_ps always has a value")]
    pub fn new(design: &'a Design, options: Options) -> Result<Self> {
        design.netlist.check_bound()?;
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
                    "no signal matches `{pattern}`: available are {}, …; *error selects all errors, --all adds unnamed signals",
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

    /// The hardware shown.
    #[must_use]
    pub fn rtl(&self) -> &Rtl {
        &self.rtl
    }

    /// Names of the valid bits of the rates that are slower than the fastest, slowest first.
    pub(super) fn slow_valids(&self) -> Vec<String> {
        let taken: BTreeSet<String> = self.traces.iter().map(full_name).collect();
        let rates = self.rtl.netlist().rates();
        let slow = &rates[..rates.len() - 1];
        let named = |rate: &Rate| name::numbered(&format!("valid_{rate}"), |n| !taken.contains(n));
        slow.iter().map(named).collect()
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

    /// Cycles until the last of `samples` samples is out.
    #[must_use]
    pub fn cycles(&self, samples: usize) -> u64 {
        let interval = u64::from(self.rtl.schedule().phases());
        let last = cast::count_of(samples).saturating_sub(1) * interval;
        last + u64::from(self.rtl.schedule().latency()) + u64::from(samples > 0)
    }
}

/// Access for tests.
impl Wave<'_> {
    /// Names, nodes and stages of the words.
    pub fn signals(&self) -> impl Iterator<Item = (String, NodeId, u32)> + '_ {
        let words = self.traces.iter().filter(|trace| trace.word);
        words.map(|trace| (full_name(trace), trace.signal.node, trace.signal.stage))
    }
}

/// All signals that can be shown, ports first.
fn all_traces(rtl: &Rtl, options: &Options) -> Vec<Trace> {
    let netlist = rtl.netlist();
    // Nothing upstream of an exact node was rounded or tabulated, so its error is always 0.
    let mut exact: Vec<bool> = Vec::new();
    for node in netlist.nodes() {
        let lossy =
            node.meaning.is_some() || matches!(node.op, Op::Narrow { .. } | Op::Read { .. });
        exact.push(!lossy && node.operands.iter().all(|operand| exact[operand.index()]));
    }
    let trace = |signal: Signal, path: Vec<String>, name: String, port: Option<usize>| {
        let node = netlist.node(signal.node);
        let twins = match port {
            _ if node.real.is_none() || node.format.bits() == 1 => &[],
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
        // The source of an output register has the port's name, and the port is already in the
        // list.
        let is_shown = node.name.as_ref() == Some(&name);
        if !is_shown && !options.all {
            continue;
        }
        // A unit's output shows one operation's word after another; the hold register shows this
        // node's.
        let mut own_twins = rtl.is_free(id);
        if own_twins {
            traces.push(trace(own, path.clone(), name, None));
        }
        let shown = match (options.all, rtl.schedule().phases()) {
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
