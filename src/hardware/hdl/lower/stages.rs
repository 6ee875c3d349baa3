//! Ports, stages and units, in the module's order.

use super::options::{Options, WORDS, check_name, place_tables, refuse_size};
use super::words::{Context, Lowering};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::hardware::hdl::module::{
    Driver, Expr, Module, Next, Operand, READY, Register, SlowRate, Stage, Valid, View, WordId,
    new_word_id, valid_bit,
};
use crate::hardware::hdl::names::Names;
use crate::hardware::hdl::testbench::bench_name;
use crate::hardware::rtl::{Port, Rtl, Signal, Source};
use crate::netlist::op::Op;
use crate::netlist::{NodeId, Rate, TableId};
use crate::schedule::Timing;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

impl Module {
    /// Lowers hardware to words and statements.
    ///
    /// # Errors
    /// If the name isn't legal, or the module would be too large.
    pub fn new(rtl: &Arc<Rtl>, options: &Options) -> Result<Self> {
        let netlist = rtl.netlist();
        let name = options.name.clone().unwrap_or_else(|| netlist.name().to_owned());
        check_name(&name)?;
        let is_input =
            netlist.inputs().iter().any(|id| netlist.node(*id).name.as_ref() == Some(&name));
        if is_input || netlist.outputs().iter().any(|output| output.name == name) {
            let text =
                format!("`{name}` is a port of the module: choose another name for the module");
            return Err(Error::usage(text));
        }
        let tables_in = place_tables(rtl, options.tables, options.memories)?;
        let latency = rtl.schedule().latency();
        let interval = rtl.schedule().interval();
        let mut names = Names::default();
        names.take(&name);
        if interval > 1 {
            names.take(READY);
        }
        if netlist.memories().next().is_some() || netlist.rates().len() > 1 {
            names.take(&bench_name(&name));
        }
        let clocked = |rtl: &Rtl| {
            let netlist = rtl.netlist();
            let of_table = |id: &NodeId| netlist.memory(*id).is_none();
            netlist.ids().filter(of_table).any(|id| rtl.schedule().is_clocked(netlist, id))
        };
        let fastest = rtl.schedule().fastest();
        let mut timings = rtl.schedule().timings();
        timings.pop();
        let slow = |timing: &Timing| SlowRate {
            rate: timing.rate,
            entry: timing.entry,
            interval: timing.interval,
            valid: names.take(&format!("valid_{}", timing.rate)),
            ready: None,
        };
        let rates: Vec<SlowRate> = timings.iter().map(slow).collect();
        let mut lowering = Lowering {
            at: Context {
                rtl: Arc::clone(rtl),
                prefix: String::new(),
                signals: BTreeMap::new(),
                roms: BTreeMap::new(),
                rows: BTreeMap::new(),
            },
            names,
            titles: Names::default(),
            stage: 0,
            scope: String::new(),
            columns: BTreeMap::new(),
            flags: BTreeMap::new(),
            ports: BTreeMap::new(),
            memories: options.memories,
            reads: BTreeMap::new(),
            valids: rates.iter().map(|slow| (slow.rate, slow.valid.clone())).collect(),
            module: Module {
                name,
                header: options.header.clone(),
                latency,
                interval,
                phases: rtl.schedule().phases(),
                block_rom: clocked(rtl) || rtl.units().iter().any(|unit| clocked(&unit.rtl)),
                words: Vec::new(),
                inputs: Vec::new(),
                input_rates: netlist.inputs().iter().map(|id| netlist.node(*id).rate).collect(),
                outputs: Vec::new(),
                tables: Vec::new(),
                tables_in,
                memories: Vec::new(),
                rates,
                idle_rates: Vec::new(),
                entry: fastest.entry,
                has_state: netlist.first_delay().is_some(),
                stages: Vec::new(),
                ready: None,
                valid: ("valid_in".to_owned(), None),
                renamed: Vec::new(),
                signals: BTreeMap::new(),
            },
        };
        lowering.ports();
        lowering.memory_ports();
        let roms = lowering.tables();
        lowering.phases();
        lowering.declarations();
        lowering.stages(roms[0].clone())?;
        for (number, roms) in roms.into_iter().skip(1).enumerate() {
            lowering.unit(number, roms)?;
        }
        lowering.finish();
        Ok(lowering.module)
    }
}

impl Lowering {
    fn ports(&mut self) {
        let rtl = Arc::clone(&self.at.rtl);
        let netlist = rtl.netlist();
        for id in netlist.inputs() {
            let signal = Signal { node: *id, stage: rtl.schedule().stage(*id) };
            let wanted = rtl.local_name(signal);
            let format = netlist.node(*id).format;
            let word = self.node_word(&wanted, format, Driver::Input);
            self.module.inputs.push(word);
            self.at.signals.insert(signal, word);
        }
        // Output names are reserved before all inner names; output registers are created now.
        for output in netlist.outputs() {
            let signal = rtl.output(output.node);
            let register = rtl.registers(output.node).any(|register| register == signal);
            let known = self.at.signals.contains_key(&signal);
            if register && !known {
                let format = netlist.node(output.node).format;
                let word = self.node_word(&output.name, format, Driver::OutputRegister);
                self.at.signals.insert(signal, word);
                let name = self.module.word(word).name.clone();
                self.module.outputs.push((name, word));
            } else {
                // The word isn't known yet: insert a placeholder.
                let name = self.take(&output.name);
                self.module.outputs.push((name, new_word_id(0)));
            }
        }
    }

    /// Opens a stage of the module.
    pub(super) fn open(&mut self, title: String) {
        self.stage = self.module.stages.len();
        self.module.stages.push(Stage { title, ..Stage::default() });
        self.scope.clear();
    }

    /// Declares hold registers and results of units, since multiplexers use them before they are
    /// driven.
    fn declarations(&mut self) {
        let rtl = Arc::clone(&self.at.rtl);
        if rtl.units().is_empty() {
            return;
        }
        self.open("hold registers and results of units".to_owned());
        let netlist = rtl.netlist();
        for id in netlist.ids() {
            let format = netlist.node(id).format;
            if rtl.result(id).is_some() {
                let signal = Signal { node: id, stage: rtl.schedule().stage(id) };
                let word = self.node_word(&self.flat_name(signal), format, Driver::Logic);
                self.at.signals.insert(signal, word);
                self.module.stages[self.stage].declared.push(word);
            }
            for register in rtl.registers(id) {
                if !self.at.signals.contains_key(&register) {
                    let wanted = self.flat_name(register);
                    let word = self.node_word(&wanted, format, Driver::Register);
                    self.at.signals.insert(register, word);
                    self.module.stages[self.stage].declared.push(word);
                }
            }
        }
    }

    /// All stages of the current hardware.
    fn stages(&mut self, roms: BTreeMap<TableId, usize>) -> Result<()> {
        self.at.roms = roms;
        for stage in 0..=self.at.rtl.schedule().latency() {
            self.open(match self.at.prefix.trim_end_matches('_') {
                "" => format!("stage {stage}"),
                unit => format!("{unit}, stage {stage}"),
            });
            self.stage(stage);
            let words = self.module.words.len();
            if words > WORDS {
                let remedy = "choose fewer stages or smaller units";
                return Err(refuse_size(
                    "wires and registers",
                    cast::count_of(words),
                    cast::count_of(WORDS),
                    remedy,
                ));
            }
        }
        Ok(())
    }

    /// A unit: its input multiplexers, its inside, and its results.
    fn unit(&mut self, number: usize, roms: BTreeMap<TableId, usize>) -> Result<()> {
        let rtl = Arc::clone(&self.at.rtl);
        let unit = &rtl.units()[number];
        self.open(format!("inputs of {}", unit.name));
        let ports: Vec<WordId> = unit
            .ports
            .iter()
            .enumerate()
            .map(|(at, port)| self.port(&format!("{}_in{at}", unit.name), port, unit.interval))
            .collect();
        let inside = Context {
            rtl: Arc::clone(&unit.rtl),
            prefix: format!("{}_", unit.name),
            signals: unit
                .rtl
                .netlist()
                .inputs()
                .iter()
                .zip(ports)
                .map(|(id, word)| (Signal { node: *id, stage: 0 }, word))
                .collect(),
            roms: BTreeMap::new(),
            rows: BTreeMap::new(),
        };
        let whole = std::mem::replace(&mut self.at, inside);
        self.stages(roms)?;
        let inside = std::mem::replace(&mut self.at, whole);
        self.open(format!("results of {}", unit.name));
        for id in rtl.netlist().ids() {
            let Some(result) = rtl.result(id).filter(|result| result.unit == number) else {
                continue;
            };
            let node = unit.rtl.netlist().outputs()[result.output].node;
            let from = inside.signals[&unit.rtl.output(node)];
            let to = self.at.signals[&Signal { node: id, stage: rtl.schedule().stage(id) }];
            let bits = self.module.word(to).bits;
            let view = View { word: from, lo: result.right, zeros: 0, bits };
            self.assign(to, Expr::Copy(Operand::View(view)));
        }
        Ok(())
    }

    /// The word at a port of a unit, selected by the phase of the unit's interval.
    fn port(&mut self, name: &str, port: &Port, interval: u32) -> WordId {
        let operands: Vec<Operand> = port
            .cases
            .iter()
            .map(|case| match case.source {
                Source::Signal(signal) => Operand::View(View {
                    word: self.at.signals[&signal],
                    lo: 0,
                    zeros: case.left,
                    bits: port.format.bits(),
                }),
                Source::Constant { raw, .. } => Operand::Literal {
                    pattern: port.format.pattern(case.shifted(raw)).into(),
                    bits: port.format.bits(),
                },
            })
            .collect();
        // One choice for each distinct operand; the first is the default.
        let mut choices: Vec<(Operand, Vec<u32>)> = Vec::new();
        for (case, operand) in port.cases.iter().zip(operands) {
            match choices.iter_mut().find(|(known, _)| *known == operand) {
                Some((_, phases)) => phases.push(case.phase),
                None => choices.push((operand, vec![case.phase])),
            }
        }
        let default = choices.remove(0).0;
        let mut cases = Vec::new();
        let schedule = self.at.rtl.schedule().clone();
        let expanded = |phases: &[u32]| -> Vec<u32> {
            let all = phases.iter().flat_map(|phase| schedule.phases_of(*phase, interval));
            all.collect::<BTreeSet<u32>>().into_iter().collect()
        };
        for (operand, phases) in choices {
            let phases = expanded(&phases);
            let flag = self.during(&phases).expect("bug: the first has a phase too");
            cases.push((flag, operand));
        }
        let expr =
            if cases.is_empty() { Expr::Copy(default) } else { Expr::Choose { cases, default } };
        if !port.registered {
            let word = self.node_word(name, port.format, Driver::Logic);
            self.assign(word, expr);
            return word;
        }
        let register = self.node_word(name, port.format, Driver::Register);
        let next = self.node_word(&format!("{name}_next"), port.format, Driver::Logic);
        self.assign(next, expr);
        self.use_bits(next, 0, u32::MAX);
        let phases: Vec<u32> = port.cases.iter().map(|case| case.phase).collect();
        let load = self.during(&expanded(&phases));
        if let Some(flag) = load {
            self.use_bits(flag.word, flag.bit, 1);
        }
        let next = Next::Word(next);
        let entry = Register { word: register, next, load, valid: None, reset: false };
        self.module.stages[self.stage].registers.push(entry);
        register
    }

    fn finish(&mut self) {
        let netlist = Arc::clone(self.at.rtl.netlist());
        self.memory_addresses();
        for (port, output) in netlist.outputs().iter().enumerate() {
            let word = self.at.signals[&self.at.rtl.output(output.node)];
            self.module.outputs[port].1 = word;
            self.use_bits(word, 0, u32::MAX);
        }
        // Remove stages left empty because no event needs their phases.
        if self.module.phases > 1 {
            self.module.stages.retain(|stage| !stage.is_empty());
        }
        let holds = |rate: Rate| {
            let mut registers = netlist.ids().flat_map(|id| self.at.rtl.registers(id));
            registers.any(|register| self.at.rtl.holds(register) == Some(rate))
        };
        let idle = self.module.rates.iter().filter(|slow| !holds(slow.rate));
        self.module.idle_rates = idle.map(|slow| slow.valid.clone()).collect();
        self.module.signals = std::mem::take(&mut self.at.signals);
        if !self.module.renamed.is_empty() {
            let why = "renamed, since a language or another word has the name:";
            self.module.header.push(why.to_owned());
            let names = self.module.renamed.iter();
            self.module.header.extend(names.map(|(was, is)| format!("  {was} is {is}")));
        }
    }

    fn stage(&mut self, stage: u32) {
        let rtl = Arc::clone(&self.at.rtl);
        let netlist = rtl.netlist();
        let schedule = rtl.schedule();
        for id in netlist.ids() {
            let own = rtl.is_free(id) && netlist.node(id).op != Op::Input;
            if own && schedule.stage(id) == stage {
                self.node(id);
            }
        }
        // Registers at the end of this stage.
        let mut moved = BTreeSet::new();
        for id in netlist.ids() {
            let clocked = schedule.is_clocked(netlist, id) && self.fetched(id).is_none();
            let first = schedule.operand_stage(netlist, id);
            if clocked && first == stage {
                self.row_register(id);
            } else if clocked
                && (first..schedule.stage(id)).contains(&stage)
                && moved.insert((self.address(id), schedule.stage(id)))
            {
                self.later_row(id);
            }
            for register in rtl.registers(id).filter(|register| register.stage == stage + 1) {
                let from = self.at.signals[&rtl.held(register)];
                let word = match self.at.signals.get(&register) {
                    Some(declared) => *declared,
                    None => {
                        let wanted = self.flat_name(register);
                        let format = netlist.node(id).format;
                        let word = self.node_word(&wanted, format, Driver::Register);
                        self.at.signals.insert(register, word);
                        word
                    }
                };
                self.use_bits(from, 0, u32::MAX);
                let load = self.load(rtl.load_phases(register));
                let holds = rtl.holds(register);
                let of =
                    |(rate, name): &(Rate, String)| (Some(*rate) == holds).then(|| name.clone());
                let valid = self.valids.iter().find_map(of);
                let next = Next::Word(from);
                let register = Register { word, next, load, valid, reset: false };
                self.module.stages[self.stage].registers.push(register);
            }
        }
        // Valid bits beside them, one for each interval; units have none.
        if !self.at.prefix.is_empty() {
            return;
        }
        for timing in schedule.timings() {
            let Some(after) = stage.checked_sub(timing.entry) else { continue };
            let number = after / timing.interval;
            if !after.is_multiple_of(timing.interval) || number >= rtl.valid_bits_of(&timing) {
                continue;
            }
            let slow = self.valids.iter().position(|(rate, _)| *rate == timing.rate);
            let (to, from) = match slow {
                Some(place) => {
                    let to = self.names.take(&format!("valid_{}_s{}", timing.rate, stage + 1));
                    (to.clone(), std::mem::replace(&mut self.valids[place].1, to))
                }
                None => {
                    let to = valid_bit(cast::index_of_u32(stage) + 1);
                    (to.clone(), std::mem::replace(&mut self.module.valid.0, to))
                }
            };
            let load = self.load(schedule.phases_of(0, timing.interval));
            self.module.stages[self.stage].valid.push(Valid { from, to, load });
            if slow.is_none() && stage + timing.interval >= schedule.latency() {
                let out = schedule.phases_of(schedule.latency(), timing.interval);
                self.module.valid.1 = self.load(out);
            }
        }
    }
}
