//! From nodes and registers to words of plain bits: the one place where an operation becomes
//! logic, for every language.
//!
//! All arithmetic is modulo two to the bits of the result, on operands that are extended to
//! them: with formats that hold every result that is exact, and no language's own rules of
//! signs and widths come into play.
//!
//! A flat pipeline is its stages, one after the other. A time-shared one has before them the
//! phase counter and the declarations of what is used before it is driven (hold registers and
//! results of units), and after them each unit: multiplexers, its own stages, results. Its hold
//! registers load in their phase. All of it is stages and registers; a flat pipeline has no phase.

use crate::hardware::hdl::{
    Bit, Bitwise, Driver, Expr, Item, Module, Next, Operand, Options, READY, Register, RomTable,
    Stage, Tables, Valid, View, WORDS, Word, WordId, check_name, new_word_id, place_tables,
    refuse_size, valid_bit,
};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::hardware::hdl::names::Names;
use crate::hardware::rtl::{Port, Rtl, Signal, Source};
use crate::netlist::op::Op;
use crate::netlist::{NodeId, RAM_PORTS, Table, TableId};
use crate::number::format::{Format, Narrowing, Overflow, Round, bit_len, narrow};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

pub(in crate::hardware::hdl) fn lower(rtl: &Arc<Rtl>, options: &Options) -> Result<Module> {
    let netlist = rtl.netlist();
    let name = options.name.clone().unwrap_or_else(|| netlist.name().to_owned());
    check_name(&name)?;
    let is_input = netlist.inputs().iter().any(|id| netlist.node(*id).name.as_ref() == Some(&name));
    if is_input || netlist.outputs().iter().any(|output| output.name == name) {
        let text = format!("`{name}` is a port of the module: choose another name for the module");
        return Err(Error::usage(text));
    }
    let tables_in = place_tables(rtl, options.tables)?;
    let latency = rtl.schedule().latency();
    let interval = rtl.schedule().interval();
    let mut names = Names::default();
    names.take(&name);
    if interval > 1 {
        names.take(READY);
    }
    let clocked = |rtl: &Rtl| {
        let netlist = rtl.netlist();
        netlist.ids().any(|id| rtl.schedule().is_clocked(netlist, id))
    };
    let mut lowering = Lowering {
        at: Context {
            rtl: Arc::clone(rtl),
            prefix: String::new(),
            signals: BTreeMap::new(),
            roms: BTreeMap::new(),
            rows: BTreeMap::new(),
        },
        names,
        stage: 0,
        scope: String::new(),
        columns: BTreeMap::new(),
        flags: BTreeMap::new(),
        ports: BTreeMap::new(),
        module: Module {
            name,
            header: options.header.clone(),
            latency,
            interval,
            block_rom: clocked(rtl) || rtl.units().iter().any(|unit| clocked(&unit.rtl)),
            words: Vec::new(),
            inputs: Vec::new(),
            outputs: Vec::new(),
            tables: Vec::new(),
            tables_in,
            stages: Vec::new(),
            ready: None,
            valid: ("valid_in".to_owned(), None),
            renamed: Vec::new(),
            signals: BTreeMap::new(),
        },
    };
    lowering.ports();
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

/// Hardware that is being lowered: the whole, or the inside of a unit.
struct Context {
    rtl: Arc<Rtl>,
    /// What its names begin with.
    prefix: String,
    /// Word of each of its signals.
    signals: BTreeMap<Signal, WordId>,
    /// Position of each of its tables in the module.
    roms: BTreeMap<TableId, usize>,
    /// Word of a row by table, address and stage.
    rows: BTreeMap<(TableId, Signal, u32), WordId>,
}

struct Lowering {
    at: Context,
    names: Names,
    module: Module,
    /// Stage that statements go to.
    stage: usize,
    /// Scope of the latest statement.
    scope: String,
    /// Least bit of each column in its table's rows, by the table's position in the module.
    columns: BTreeMap<(usize, u32), u32>,
    /// Flags that are set in some phases.
    flags: BTreeMap<Vec<u32>, Bit>,
    /// Ports so far on the clock by table, and the copy that the latest is at.
    ports: BTreeMap<usize, (u64, usize)>,
}

impl Lowering {
    fn ports(&mut self) {
        let rtl = Arc::clone(&self.at.rtl);
        let netlist = rtl.netlist();
        for id in netlist.inputs() {
            let signal = Signal { node: *id, stage: 0 };
            let wanted = rtl.local_name(signal);
            let format = netlist.node(*id).format;
            let word = self.node_word(&wanted, format, Driver::Input);
            self.module.inputs.push(word);
            self.at.signals.insert(signal, word);
        }
        // Outputs have their names before anything inside; registers of their own are made now.
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
                // Known only later: a placeholder until then.
                let name = self.take(&output.name);
                self.module.outputs.push((name, new_word_id(0)));
            }
        }
    }

    /// Opens a stage of the module.
    fn open(&mut self, title: String) {
        self.stage = self.module.stages.len();
        self.module.stages.push(Stage { title, ..Stage::default() });
        self.scope.clear();
    }

    /// The phase counter, where there is more than one phase.
    fn phases(&mut self) {
        let interval = self.module.interval;
        if interval == 1 {
            return;
        }
        self.open("phase".to_owned());
        let bits = self.at.rtl.phase_bits();
        let phase = self.word("phase", bits, false, 0, Driver::Register);
        self.module.stages[self.stage].declared.push(phase);
        let literal = |number: u32| Operand::Literal { pattern: number.into(), bits };
        let more = Expr::Add(self.resized(phase, bits), literal(1));
        let mut next = self.plain(phase, "more", bits, more);
        if !interval.is_power_of_two() {
            let last = Expr::Equal(self.resized(phase, bits), literal(interval - 1));
            let last = self.flag(phase, "last", last);
            let cases = vec![(last, literal(0))];
            let around = Expr::Choose { cases, default: self.resized(next, bits) };
            next = self.plain(phase, "next", bits, around);
        }
        self.use_bits(next, 0, u32::MAX);
        for number in self.phases_at_work() {
            let is = Expr::Equal(self.resized(phase, bits), literal(number));
            let word = self.word(&format!("phase_{number}"), 1, false, 0, Driver::Logic);
            self.assign(word, is);
            self.flags.insert(vec![number], Bit { word, bit: 0 });
        }
        self.module.stages[self.stage].registers.push(Register {
            word: phase,
            next: Next::Word(next),
            load: None,
            reset: true,
        });
        let ready = self.flags[&vec![0]];
        self.use_bits(ready.word, ready.bit, 1);
        self.module.ready = Some(ready);
    }

    /// Phases that something depends on.
    fn phases_at_work(&self) -> BTreeSet<u32> {
        let rtl = &self.at.rtl;
        let loads = rtl.netlist().ids().flat_map(|id| rtl.registers(id));
        let ports = rtl.units().iter().flat_map(|unit| &unit.ports);
        let several = ports.filter(|port| port.registered || port.cases.len() > 1);
        let mut phases: BTreeSet<u32> = loads.map(|register| rtl.load_phase(register)).collect();
        phases.extend(several.flat_map(|port| port.cases.iter().map(|case| case.phase)));
        phases.extend([0, rtl.schedule().phase(rtl.schedule().latency())]);
        phases
    }

    /// The flag of some phases in ascending order; none if they are all that there are.
    fn during(&mut self, phases: &[u32]) -> Option<Bit> {
        if phases.len() == cast::index_of_u32(self.module.interval) {
            return None;
        }
        if let Some(flag) = self.flags.get(phases) {
            return Some(*flag);
        }
        let (last, before) = phases.split_last().expect("bug: some phase");
        let before = self.during(before).expect("bug: fewer phases than there are");
        let last = self.flags[&vec![*last]];
        let numbers: Vec<String> = phases.iter().map(u32::to_string).collect();
        let wanted = format!("phase_{}", numbers.join("_"));
        let word = self.word(&wanted, 1, false, 0, Driver::Logic);
        self.assign(word, Expr::Bitwise(Bitwise::Or, before.word, last.word));
        let flag = Bit { word, bit: 0 };
        self.flags.insert(phases.to_vec(), flag);
        Some(flag)
    }

    /// Hold registers and results of units: multiplexers come before what drives them.
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

    /// All stages of the hardware at hand.
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
                let remedy = "take fewer stages or smaller units";
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

    /// A unit: what goes in when, its inside, and what it gives.
    fn unit(&mut self, number: usize, roms: BTreeMap<TableId, usize>) -> Result<()> {
        let rtl = Arc::clone(&self.at.rtl);
        let unit = &rtl.units()[number];
        self.open(format!("what {} takes", unit.name));
        let ports: Vec<WordId> = unit
            .ports
            .iter()
            .enumerate()
            .map(|(at, port)| self.port(&format!("{}_in{at}", unit.name), port))
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
        self.open(format!("what {} gives", unit.name));
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

    /// The word at a port of a unit: of what it takes in each phase.
    fn port(&mut self, name: &str, port: &Port) -> WordId {
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
        // One choice for each operand, the first where nothing else is asked for.
        let mut choices: Vec<(Operand, Vec<u32>)> = Vec::new();
        for (case, operand) in port.cases.iter().zip(operands) {
            match choices.iter_mut().find(|(known, _)| *known == operand) {
                Some((_, phases)) => phases.push(case.phase),
                None => choices.push((operand, vec![case.phase])),
            }
        }
        let default = choices.remove(0).0;
        let mut cases = Vec::new();
        for (operand, phases) in choices {
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
        let mut phases: Vec<u32> = port.cases.iter().map(|case| case.phase).collect();
        phases.dedup();
        let load = self.during(&phases);
        if let Some(flag) = load {
            self.use_bits(flag.word, flag.bit, 1);
        }
        let next = Next::Word(next);
        let register = Register { word: register, next, load, reset: false };
        self.module.stages[self.stage].registers.push(register);
        register.word
    }

    fn finish(&mut self) {
        let netlist = Arc::clone(self.at.rtl.netlist());
        for (port, output) in netlist.outputs().iter().enumerate() {
            let word = self.at.signals[&self.at.rtl.output(output.node)];
            self.module.outputs[port].1 = word;
            self.use_bits(word, 0, u32::MAX);
        }
        // Of phases that nothing happens in no flag is left, and of stages no title.
        if self.module.interval > 1 {
            self.module.stages.retain(|stage| !stage.is_empty());
        }
        self.module.signals = std::mem::take(&mut self.at.signals);
        if !self.module.renamed.is_empty() {
            let why = "renamed, since a language or another word has the name:";
            self.module.header.push(why.to_owned());
            let names = self.module.renamed.iter();
            self.module.header.extend(names.map(|(was, is)| format!("  {was} is {is}")));
        }
    }

    /// Tables with the columns that are read; for the whole and for each unit, the position of
    /// each of its tables in the module. What several read is one table.
    fn tables(&mut self) -> Vec<BTreeMap<TableId, usize>> {
        let whole = Arc::clone(&self.at.rtl);
        let mut read: Vec<(Table, BTreeSet<u32>)> = Vec::new();
        let mut all = Vec::new();
        for rtl in [&whole].into_iter().chain(whole.units().iter().map(|unit| &unit.rtl)) {
            let netlist = rtl.netlist();
            let mut own: BTreeMap<TableId, BTreeSet<u32>> = BTreeMap::new();
            for id in netlist.ids().filter(|id| rtl.is_free(*id)) {
                if let Op::Read { table, column } = netlist.node(id).op {
                    own.entry(table).or_default().insert(column);
                }
            }
            let mut roms = BTreeMap::new();
            for (id, columns) in own {
                let table = &netlist.tables()[id.index()];
                let known = read.iter().position(|(known, _)| known == table);
                let at = known.unwrap_or_else(|| {
                    read.push((table.clone(), BTreeSet::new()));
                    read.len() - 1
                });
                read[at].1.extend(columns);
                roms.insert(id, at);
            }
            all.push(roms);
        }
        // Files are named by titles, so no two tables may share one.
        let mut titles = Names::default();
        for (at, (table, columns)) in read.into_iter().enumerate() {
            let index = |column: u32| usize::try_from(column).expect("bug: small");
            let formats = columns.iter().map(|c| table.columns[index(*c)].format.bits());
            let row_bits: u32 = formats.sum();
            let mut lo = row_bits;
            for column in &columns {
                lo -= table.columns[index(*column)].format.bits();
                self.columns.insert((at, *column), lo);
            }
            let title = titles.take(&table.name);
            let name = self.names.take(&format!("{title}_rom"));
            let wanted = format!("{}_rom", table.name);
            if name != wanted {
                self.module.renamed.push((wanted, name.clone()));
            }
            self.module.tables.push(RomTable {
                name,
                title,
                addr_bits: table.addr_bits,
                row_bits,
                columns: columns.iter().map(|c| table.columns[index(*c)].clone()).collect(),
                copy_of: None,
            });
        }
        all
    }

    /// The table or its copy that one more port on the clock reads.
    fn port_of(&mut self, rom: usize) -> usize {
        let (ports, latest) = self.ports.entry(rom).or_insert((0, rom));
        if *ports > 0 && *ports % RAM_PORTS == 0 && self.module.tables_in != Tables::Case {
            let name = self.names.take(&self.module.tables[rom].name);
            let copy = RomTable { name, copy_of: Some(rom), ..self.module.tables[rom].clone() };
            *latest = self.module.tables.len();
            self.module.tables.push(copy);
        }
        *ports += 1;
        *latest
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
        for id in netlist.ids() {
            let clocked = schedule.is_clocked(netlist, id);
            if clocked && schedule.stage(id) == stage + 1 {
                self.row_register(id);
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
                let load = self.load(rtl.load_phase(register));
                let next = Next::Word(from);
                let register = Register { word, next, load, reset: false };
                self.module.stages[self.stage].registers.push(register);
            }
        }
        // A valid bit beside them, one for each interval; units have none.
        let valid = self.at.prefix.is_empty() && stage < schedule.latency();
        if valid && schedule.phase(stage) == 0 {
            let to = valid_bit(cast::index_of_u32(stage) + 1);
            let from = std::mem::replace(&mut self.module.valid.0, to.clone());
            let load = self.load(0);
            self.module.stages[self.stage].valid = Some(Valid { from, to, load });
            if stage + schedule.interval() >= schedule.latency() {
                self.module.valid.1 = self.load(schedule.phase(schedule.latency()));
            }
        }
    }

    /// The flag of a phase at whose end something happens.
    fn load(&mut self, phase: u32) -> Option<Bit> {
        // The inside of a unit works in every phase.
        let flat = self.at.rtl.schedule().interval() == 1;
        let flag = if flat { None } else { self.during(&[phase]) };
        if let Some(flag) = flag {
            self.use_bits(flag.word, flag.bit, 1);
        }
        flag
    }

    /// Scope and local name in one.
    fn flat_name(&self, signal: Signal) -> String {
        let netlist = self.at.rtl.netlist();
        let mut path = netlist.scope_path(netlist.node(signal.node).scope).join("_");
        if !path.is_empty() {
            path.push('_');
        }
        self.at.prefix.clone() + &path + &self.at.rtl.local_name(signal)
    }

    fn node_word(&mut self, wanted: &str, format: Format, driver: Driver) -> WordId {
        let name = self.take(wanted);
        let (bits, signed, frac) = (format.bits(), format.is_signed(), format.frac_bits());
        self.push(Word { name, bits, signed, frac, format: Some(format), driver, used: Vec::new() })
    }

    /// A name that the netlist gives; another one than that is told.
    fn take(&mut self, wanted: &str) -> String {
        let name = self.names.take(wanted);
        if name != wanted {
            self.module.renamed.push((wanted.to_owned(), name.clone()));
        }
        name
    }

    fn word(&mut self, wanted: &str, bits: u32, signed: bool, frac: i32, driver: Driver) -> WordId {
        let name = self.names.take(wanted);
        self.push(Word { name, bits, signed, frac, format: None, driver, used: Vec::new() })
    }

    /// Adds a word, of which no bit is used so far.
    fn push(&mut self, word: Word) -> WordId {
        let used = vec![false; usize::try_from(word.bits).expect("bug: 32 bits fit")];
        self.module.words.push(Word { used, ..word });
        new_word_id(self.module.words.len() - 1)
    }

    /// A helper of a node's word, named after it.
    fn helper(&mut self, of: WordId, what: &str, bits: u32, signed: bool, expr: Expr) -> WordId {
        let (name, frac) = (self.module.word(of).name.clone(), self.module.word(of).frac);
        let word = self.word(&format!("{name}_{what}"), bits, signed, frac, Driver::Logic);
        self.assign(word, expr);
        word
    }

    fn flag(&mut self, of: WordId, what: &str, expr: Expr) -> Bit {
        let word = self.helper(of, what, 1, false, expr);
        self.module.words[word.index()].frac = 0;
        Bit { word, bit: 0 }
    }

    fn use_bits(&mut self, word: WordId, lo: u32, bits: u32) {
        let used = &mut self.module.words[word.index()].used;
        let skip = usize::try_from(lo).expect("bug: 32 bits fit");
        let count = usize::try_from(bits).expect("bug: 32 bits fit");
        used.iter_mut().skip(skip).take(count).for_each(|bit| *bit = true);
    }

    fn use_operand(&mut self, operand: Operand) {
        if let Operand::View(view) = operand {
            self.use_bits(view.word, view.lo, view.bits.saturating_sub(view.zeros));
        }
    }

    fn assign(&mut self, word: WordId, expr: Expr) {
        match &expr {
            Expr::Copy(a) | Expr::Negate(a) => self.use_operand(*a),
            Expr::Add(a, b) | Expr::Sub(a, b) | Expr::Equal(a, b) | Expr::Less { a, b, .. } => {
                self.use_operand(*a);
                self.use_operand(*b);
            }
            Expr::AddCarry(a, b, bit) => {
                self.use_operand(*a);
                self.use_operand(*b);
                self.use_bits(bit.word, bit.bit, 1);
            }
            Expr::InvertIf(bit, a) => {
                self.use_bits(bit.word, bit.bit, 1);
                self.use_operand(*a);
            }
            Expr::Multiply(a, b) | Expr::Bitwise(_, a, b) => {
                self.use_bits(*a, 0, u32::MAX);
                self.use_bits(*b, 0, u32::MAX);
            }
            Expr::Choose { cases, default } => {
                for (bit, operand) in cases.clone() {
                    self.use_bits(bit.word, bit.bit, 1);
                    self.use_operand(operand);
                }
                self.use_operand(*default);
            }
            Expr::Concat(parts) => parts.clone().into_iter().for_each(|p| self.use_operand(p)),
            Expr::ShiftLeft(a, count) => {
                self.use_operand(*a);
                self.use_bits(*count, 0, u32::MAX);
            }
            Expr::Above { word, keep } | Expr::Below { word, keep } => {
                self.use_bits(*word, *keep, u32::MAX);
            }
            Expr::Read(_, address) => self.use_bits(*address, 0, u32::MAX),
        }
        self.module.stages[self.stage].items.push(Item::Assign(word, expr));
    }

    /// A whole word with its binary point moved to `frac`, extended or cut to `bits`.
    fn aligned(&self, word: WordId, frac: i32, bits: u32) -> Operand {
        let zeros = (frac - self.module.word(word).frac).unsigned_abs();
        Operand::View(View { word, lo: 0, zeros, bits })
    }

    /// A whole word extended or cut to `bits`.
    fn resized(&self, word: WordId, bits: u32) -> Operand {
        self.aligned(word, self.module.word(word).frac, bits)
    }

    /// The word that `user` takes operand `i` from.
    fn operand(&self, user: NodeId, i: usize) -> WordId {
        let operand = self.at.rtl.netlist().node(user).operands[i];
        self.at.signals[&self.at.rtl.operand(user, operand)]
    }

    fn address(&self, read: NodeId) -> Signal {
        self.at.rtl.operand(read, self.at.rtl.netlist().node(read).operands[0])
    }

    /// The register that a read on a clock goes through, one for all columns of an address.
    fn row_register(&mut self, read: NodeId) {
        let Op::Read { table, .. } = self.at.rtl.netlist().node(read).op else { return };
        let address = self.address(read);
        let key = (table, address, self.at.rtl.schedule().stage(read));
        if self.at.rows.contains_key(&key) {
            return;
        }
        let rom = self.at.roms[&table];
        let from = self.at.signals[&address];
        let row = self.row_word(rom, Driver::Register);
        self.use_bits(from, 0, u32::MAX);
        let next = Next::Read(self.port_of(rom), from);
        let register = Register { word: row, next, load: None, reset: false };
        self.module.stages[self.stage].registers.push(register);
        self.at.rows.insert(key, row);
    }

    fn row_word(&mut self, rom: usize, driver: Driver) -> WordId {
        let wanted = format!("{}{}_row", self.at.prefix, self.module.tables[rom].title);
        self.word(&wanted, self.module.tables[rom].row_bits, false, 0, driver)
    }

    fn node(&mut self, id: NodeId) {
        let netlist = Arc::clone(self.at.rtl.netlist());
        let node = netlist.node(id);
        let scope = netlist.scope_path(node.scope).join(".");
        if scope != self.scope {
            self.scope.clone_from(&scope);
            self.module.stages[self.stage].items.push(Item::Scope(scope));
        }
        let out = node.format;
        let stage = self.at.rtl.schedule().stage(id);
        let signal = Signal { node: id, stage };
        let wanted = self.flat_name(signal);
        let word = self.node_word(&wanted, out, Driver::Logic);
        self.at.signals.insert(signal, word);
        let expr = self.expr(id, word);
        self.assign(word, expr);
    }

    /// Logic of a node; helpers that it takes come first.
    fn expr(&mut self, id: NodeId, word: WordId) -> Expr {
        let netlist = Arc::clone(self.at.rtl.netlist());
        let node = netlist.node(id);
        let out = node.format;
        let bits = out.bits();
        let frac = out.frac_bits();
        let of = |i: usize| netlist.node(node.operands[i]).format;
        let bit0 = |word| Bit { word, bit: 0 };
        match node.op {
            Op::Input => unreachable!("bug: inputs are ports"),
            Op::Const { raw } => {
                Expr::Copy(Operand::Literal { pattern: out.pattern(raw).into(), bits })
            }
            Op::Add | Op::Sub => {
                let a = self.aligned(self.operand(id, 0), frac, bits);
                let b = self.aligned(self.operand(id, 1), frac, bits);
                if node.op == Op::Add { Expr::Add(a, b) } else { Expr::Sub(a, b) }
            }
            // One adder: a - b is a + ~b + 1.
            Op::AddSub => {
                let minus = bit0(self.operand(id, 0));
                let a = self.aligned(self.operand(id, 1), frac, bits);
                let b = self.aligned(self.operand(id, 2), frac, bits);
                let b = self.helper(word, "term", bits, false, Expr::InvertIf(minus, b));
                Expr::AddCarry(a, self.resized(b, bits), minus)
            }
            // One-bit factors whose product has one bit: a language would need two to keep signs.
            Op::Mul if bits == 1 => self.bitwise(id, Bitwise::And),
            Op::Mul => Expr::Multiply(self.operand(id, 0), self.operand(id, 1)),
            Op::Neg => Expr::Negate(self.resized(self.operand(id, 0), bits)),
            Op::Abs if of(0).is_signed() => {
                let a = self.operand(id, 0);
                let same = self.resized(a, bits);
                let opposite = self.helper(word, "neg", bits, false, Expr::Negate(same));
                let sign = Bit { word: a, bit: of(0).bits() - 1 };
                let opposite = self.resized(opposite, bits);
                Expr::Choose { cases: vec![(sign, opposite)], default: same }
            }
            Op::Abs | Op::Shift { .. } | Op::Modulo => {
                Expr::Copy(self.resized(self.operand(id, 0), bits))
            }
            Op::And => self.bitwise(id, Bitwise::And),
            Op::Or => self.bitwise(id, Bitwise::Or),
            Op::Xor => self.bitwise(id, Bitwise::Xor),
            Op::Equal | Op::Less => {
                let frac = of(0).frac_bits().max(of(1).frac_bits());
                let signed = of(0).is_signed() || of(1).is_signed();
                let wide = |f: Format| {
                    let above = u32::from(signed && !f.is_signed());
                    f.bits() + (frac - f.frac_bits()).unsigned_abs() + above
                };
                let bits = wide(of(0)).max(wide(of(1)));
                let a = self.aligned(self.operand(id, 0), frac, bits);
                let b = self.aligned(self.operand(id, 1), frac, bits);
                if node.op == Op::Equal { Expr::Equal(a, b) } else { Expr::Less { a, b, signed } }
            }
            Op::Mux => {
                let a = self.aligned(self.operand(id, 1), frac, bits);
                let b = self.aligned(self.operand(id, 2), frac, bits);
                Expr::Choose { cases: vec![(bit0(self.operand(id, 0)), a)], default: b }
            }
            Op::Slice { lo } => {
                Expr::Copy(Operand::View(View { word: self.operand(id, 0), lo, zeros: 0, bits }))
            }
            Op::Concat => Expr::Concat(vec![
                self.resized(self.operand(id, 0), of(0).bits()),
                self.resized(self.operand(id, 1), of(1).bits()),
            ]),
            Op::LeadingZeros => self.leading_zeros(word, self.operand(id, 0), of(0).bits()),
            Op::ShiftLeft { max } => {
                let a = self.resized(self.operand(id, 0), bits);
                let mut count = self.operand(id, 1);
                if i64::from(max) < of(1).max_raw() {
                    let given_bits = of(1).bits();
                    let limit = |bits| Operand::Literal { pattern: max.into(), bits };
                    let given = self.resized(count, given_bits);
                    let past = Expr::Less { a: limit(given_bits), b: given, signed: false };
                    let past = self.flag(word, "past", past);
                    // No more bits than the limit has: a count with others is past it.
                    let kept_bits = bit_len(max.into()).max(1);
                    let kept = self.resized(count, kept_bits);
                    let cases = vec![(past, limit(kept_bits))];
                    let kept = Expr::Choose { cases, default: kept };
                    count = self.plain(word, "count", kept_bits, kept);
                }
                Expr::ShiftLeft(a, count)
            }
            Op::Read { table, column } => {
                let address = self.address(id);
                let rom = self.at.roms[&table];
                let key = (table, address, self.at.rtl.schedule().stage(id));
                let row = match self.at.rows.get(&key) {
                    Some(row) => *row,
                    None => {
                        let row = self.row_word(rom, Driver::Logic);
                        let read = Expr::Read(rom, self.at.signals[&address]);
                        self.assign(row, read);
                        self.at.rows.insert(key, row);
                        row
                    }
                };
                let lo = self.columns[&(rom, column)];
                Expr::Copy(Operand::View(View { word: row, lo, zeros: 0, bits }))
            }
            Op::Narrow { round, overflow } => {
                self.narrow(word, self.operand(id, 0), of(0), out, round, overflow)
            }
        }
    }

    fn bitwise(&self, id: NodeId, operator: Bitwise) -> Expr {
        Expr::Bitwise(operator, self.operand(id, 0), self.operand(id, 1))
    }

    /// Rounding to the places of `to`, then its limits; each step is a word of its own.
    fn narrow(
        &mut self,
        word: WordId,
        a: WordId,
        from: Format,
        to: Format,
        round: Round,
        overflow: Overflow,
    ) -> Expr {
        let hardware = Narrowing::new(from, to, round, overflow);
        let dropped = from.frac_bits() - to.frac_bits();
        let signed = from.is_signed();
        let (whole, whole_bits) = if dropped <= 0 {
            // Past as many places as `to` has, more don't change whether it overflows, or the low bits.
            let zeros = dropped.unsigned_abs().min(to.bits());
            let bits = from.bits() + zeros;
            if zeros == 0 {
                (a, bits)
            } else {
                let view = Operand::View(View { word: a, lo: 0, zeros, bits });
                (self.helper(word, "wide", bits, signed, Expr::Copy(view)), bits)
            }
        } else {
            // Past one place more than the word has, every mode gives what it gives there.
            let dropped = dropped.unsigned_abs().min(from.bits() + 1);
            if hardware.rounds {
                self.rounded(word, a, from, dropped, round)
            } else {
                let bits = from.bits().saturating_sub(dropped).max(1);
                // Of a word that is dropped whole, the sign is left.
                let lo = dropped.min(from.bits() - 1);
                let view = View { word: a, lo, zeros: 0, bits };
                let kept = if dropped < from.bits() || signed {
                    Operand::View(view)
                } else {
                    Operand::Literal { pattern: 0, bits }
                };
                (self.helper(word, "cut", bits, signed, Expr::Copy(kept)), bits)
            }
        };
        let kept = self.low(whole, whole_bits, to.bits());
        if !hardware.saturates {
            return Expr::Copy(kept);
        }
        let limit =
            |raw: i64| Operand::Literal { pattern: to.pattern(raw).into(), bits: to.bits() };
        let overflows = |raw: i64| narrow(raw, from.frac_bits(), to, round, overflow);
        let magnitude_bits = to.bits() - u32::from(to.is_signed());
        let mut cases = Vec::new();
        if overflows(from.max_raw()).1 {
            let over = Expr::Above { word: whole, keep: magnitude_bits };
            cases.push((self.flag(word, "over", over), limit(to.max_raw())));
        }
        let (least, under) = overflows(from.min_raw());
        if under && from.min_raw() < 0 {
            let symmetric = to.is_signed() && overflow == Overflow::Symmetric;
            let under = if symmetric {
                let bits = whole_bits.max(to.bits());
                let pattern = low_bits(i128::from(least), bits);
                Expr::Less {
                    a: self.resized(whole, bits),
                    b: Operand::Literal { pattern, bits },
                    signed: true,
                }
            } else if to.is_signed() {
                Expr::Below { word: whole, keep: magnitude_bits }
            } else {
                // Any negative number.
                let view = View { word: whole, lo: whole_bits - 1, zeros: 0, bits: 1 };
                Expr::Copy(Operand::View(view))
            };
            cases.push((self.flag(word, "under", under), limit(least)));
        }
        Expr::Choose { cases, default: kept }
    }

    /// The low bits of a word, or the word extended by its sign.
    fn low(&self, word: WordId, have: u32, bits: u32) -> Operand {
        debug_assert_eq!(self.module.word(word).bits, have, "bug: bits of a word");
        Operand::View(View { word, lo: 0, zeros: 0, bits })
    }

    /// `a / 2^dropped` rounded: an addend below the kept bits carries into them.
    fn rounded(
        &mut self,
        word: WordId,
        a: WordId,
        from: Format,
        dropped: u32,
        round: Round,
    ) -> (WordId, u32) {
        let signed = from.is_signed();
        // One bit more than the longer of word and addend, for the carry.
        let bits = from.bits().max(dropped) + 1;
        let half = 1u128 << (dropped - 1);
        let literal = |pattern: u128| Operand::Literal { pattern, bits };
        let sign = Bit { word: a, bit: from.bits() - 1 };
        let mut choice = |bit: Bit, set: u128, clear: u128| {
            let cases = vec![(bit, literal(set))];
            let chosen = Expr::Choose { cases, default: literal(clear) };
            let addend = self.helper(word, "half", bits, false, chosen);
            self.module.words[addend.index()].frac = from.frac_bits();
            self.resized(addend, bits)
        };
        let addend = match round {
            Round::Floor => unreachable!("bug: floor only cuts"),
            // Negative words get all but one step of the next whole number.
            Round::TowardZero => choice(sign, 2 * half - 1, 0),
            Round::HalfAway if signed => choice(sign, half - 1, half),
            Round::HalfUp | Round::HalfAway => literal(half),
            // The last kept bit: of a word that is all dropped, its sign.
            Round::HalfEven if dropped < from.bits() => {
                choice(Bit { word: a, bit: dropped }, half, half - 1)
            }
            Round::HalfEven if signed => choice(sign, half, half - 1),
            Round::HalfEven => literal(half - 1),
        };
        let a = self.resized(a, bits);
        let sum = self.helper(word, "sum", bits, signed, Expr::Add(a, addend));
        self.module.words[sum.index()].frac = from.frac_bits();
        let kept_bits = bits - dropped;
        let view = View { word: sum, lo: dropped, zeros: 0, bits: kept_bits };
        let kept = Expr::Copy(Operand::View(view));
        (self.helper(word, "cut", kept_bits, signed, kept), kept_bits)
    }

    /// Halves the word as often as it can be: each time, is the upper half all zero?
    fn leading_zeros(&mut self, word: WordId, a: WordId, bits: u32) -> Expr {
        let out_bits = self.module.word(word).bits;
        if bits == 1 {
            let literal = |pattern| Operand::Literal { pattern, bits: 1 };
            let bit = Bit { word: a, bit: 0 };
            return Expr::Choose { cases: vec![(bit, literal(0))], default: literal(1) };
        }
        let mut size = bits.next_power_of_two();
        // Ones below, so that a zero word of no power of two counts its own bits.
        let mut part = if size == bits {
            a
        } else {
            let pad = size - bits;
            let ones = Operand::Literal { pattern: (1 << pad) - 1, bits: pad };
            let padded = Expr::Concat(vec![self.resized(a, bits), ones]);
            self.plain(word, "padded", size, padded)
        };
        let mut digits = Vec::new();
        while size > 1 {
            size /= 2;
            let half = |word, lo| Operand::View(View { word, lo, zeros: 0, bits: size });
            let zero = Operand::Literal { pattern: 0, bits: size };
            let (upper, lower) = (half(part, size), half(part, 0));
            let empty = self.flag(word, &format!("skip{size}"), Expr::Equal(upper, zero));
            digits.push(self.resized(empty.word, 1));
            if size == 1 && !bits.is_power_of_two() {
                break;
            }
            let chosen = Expr::Choose { cases: vec![(empty, lower)], default: upper };
            part = self.plain(word, &format!("part{size}"), size, chosen);
        }
        if !bits.is_power_of_two() {
            return Expr::Concat(digits);
        }
        let digit_count = out_bits - 1;
        let count = self.plain(word, "places", digit_count, Expr::Concat(digits));
        let count = self.resized(count, out_bits);
        let all = Operand::Literal { pattern: bits.into(), bits: out_bits };
        Expr::Choose { cases: vec![(Bit { word: part, bit: 0 }, count)], default: all }
    }

    /// A helper without a binary point.
    fn plain(&mut self, of: WordId, what: &str, bits: u32, expr: Expr) -> WordId {
        let word = self.helper(of, what, bits, false, expr);
        self.module.words[word.index()].frac = 0;
        word
    }
}

/// The low bits of a number as a pattern.
fn low_bits(number: i128, bits: u32) -> u128 {
    cast::pattern_of(number) & (u128::MAX >> (u128::BITS - bits))
}
