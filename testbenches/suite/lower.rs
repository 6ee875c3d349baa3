//! Lowered hardware against the reference, without external tools. The interpreter of the
//! language-neutral form knows nothing about how the form was built, only what its definitions say.

use crate::engines::{Random, random_netlist, random_netlist_within};
use crate::hdl::{little_shared, some_rtl};
use crate::shared::{emboss_netlist, figure_8, random_plan, with_dots};
use expect_test::expect_file;
use fixpath::format::{Format, Overflow, Round, narrow};
use fixpath::hdl::{
    Bit, Bitwise, Driver, Expr, Item, LANGUAGES, Module, Next, Operand, Options, Register,
    RomTable, Tables, Verilog, Vhdl, View, WordId,
};
use fixpath::netlist::{Builder, Column, Netlist, NodeId, Quantity, Table};
use fixpath::rtl::{Rtl, Signal};
use fixpath::schedule::{Depth, Rom, Schedule};
use fixpath::units::rotation;
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::sync::Arc;

fn mask(bits: u32) -> u128 {
    if bits >= 128 { u128::MAX } else { (1 << bits) - 1 }
}

/// A pattern as a number; if `signed`, the top bit counts negative.
fn number(pattern: u128, bits: u32, signed: bool) -> i128 {
    assert!(bits < 128, "a number of {bits} bits");
    let negative = signed && pattern >> (bits - 1) & 1 == 1;
    pattern as i128 - if negative { 1 << bits } else { 0 }
}

/// Bits of a row in hexadecimal, from bit 0.
fn bits_of_row(digits: &str, bits: u32) -> Vec<bool> {
    let digit = |c: char| c.to_digit(16).unwrap_or_else(|| panic!("digit {c}"));
    let all: Vec<bool> =
        digits.chars().rev().flat_map(|c| (0..4).map(move |b| digit(c) >> b & 1 == 1)).collect();
    let (row, padding) = all.split_at(bits as usize);
    assert!(padding.len() < 4 && padding.iter().all(|bit| !bit), "{digits} for {bits} bits");
    row.to_vec()
}

/// Runs a module on bit patterns.
pub(crate) struct Machine<'a> {
    module: &'a Module,
    /// Pattern of each word; rows of tables can be wider than this.
    words: Vec<u128>,
    rows: BTreeMap<WordId, Vec<bool>>,
    tables: Vec<Vec<Vec<bool>>>,
    /// Valid input and valid bits, by name.
    valid: BTreeMap<String, bool>,
}

impl<'a> Machine<'a> {
    /// Registers start with arbitrary contents, on which nothing may depend.
    pub(crate) fn new(module: &'a Module) -> Self {
        let mut random = Random::new(1);
        let words = module.words.iter().map(|word| u128::from(random.bits()) & mask(word.bits));
        let rows_of = |table: &RomTable| -> Vec<Vec<bool>> {
            table.rows().map(|row| bits_of_row(&row, table.row_bits)).collect()
        };
        let tables: Vec<_> = module.tables.iter().map(rows_of).collect();
        let mut rows = BTreeMap::new();
        for stage in &module.stages {
            let assigned = stage.items.iter().filter_map(|item| match item {
                Item::Assign(id, Expr::Read(table, _)) => Some((*id, *table)),
                Item::Assign(..) | Item::Scope(_) => None,
            });
            let clocked = stage.registers.iter().filter_map(|register| match register.next {
                Next::Read(table, _) => Some((register.word, table)),
                Next::Word(_) => None,
            });
            rows.extend(assigned.chain(clocked).map(|(id, table)| (id, tables[table][0].clone())));
        }
        Self { words: words.collect(), rows, tables, valid: BTreeMap::new(), module }
    }

    fn whole(&self, id: WordId) -> u128 {
        let bits = self.module.word(id).bits;
        match self.rows.get(&id) {
            None => self.words[id.index()],
            Some(row) => {
                assert!(bits <= 128, "a row of {bits} bits as a number");
                row.iter().rev().fold(0, |pattern, bit| pattern << 1 | u128::from(*bit))
            }
        }
    }

    fn bit(&self, bit: Bit) -> bool {
        assert!(bit.bit < self.module.word(bit.word).bits);
        self.whole(bit.word) >> bit.bit & 1 == 1
    }

    /// Zeros below, the word's bits from `lo` on, and its sign extension above.
    fn view(&self, view: View) -> u128 {
        let word = self.module.word(view.word);
        assert!(view.lo < word.bits && view.bits <= 128, "{view:?} of {}", word.name);
        let at = |bit: u32| match self.rows.get(&view.word) {
            Some(row) => row[bit as usize],
            None => self.words[view.word.index()] >> bit & 1 == 1,
        };
        if word.bits < 128 && view.zeros < 128 {
            let taken = number(self.whole(view.word), word.bits, word.signed) >> view.lo;
            return (taken as u128) << view.zeros & mask(view.bits);
        }
        let bit = |i: u32| match i.checked_sub(view.zeros).map(|i| i + view.lo) {
            None => false,
            Some(i) if i < word.bits => at(i),
            Some(_) => word.signed && at(word.bits - 1),
        };
        (0..view.bits).rev().fold(0, |pattern, i| pattern << 1 | u128::from(bit(i)))
    }

    fn operand(&self, operand: Operand) -> (u128, u32) {
        match operand {
            Operand::View(view) => (self.view(view), view.bits),
            Operand::Literal { pattern, bits } => {
                assert!(pattern <= mask(bits), "{pattern:#x} has more than {bits} bits");
                (pattern, bits)
            }
        }
    }

    fn expr(&self, expr: &Expr, to: WordId) -> u128 {
        let to = self.module.word(to);
        let of = |operand: Operand| {
            let (pattern, bits) = self.operand(operand);
            assert_eq!(bits, to.bits, "an operand of {}", to.name);
            pattern
        };
        let two = |a: Operand, b: Operand| {
            let (a, b) = (self.operand(a), self.operand(b));
            assert_eq!(a.1, b.1, "operands that {} compares", to.name);
            (a.0, b.0, a.1)
        };
        let value = |id: WordId| {
            let word = self.module.word(id);
            number(self.whole(id), word.bits, word.signed)
        };
        let flag = |holds: bool| {
            assert_eq!((to.bits, to.signed), (1, false), "{} is a flag", to.name);
            u128::from(holds)
        };
        let result = match expr {
            Expr::Copy(a) => of(*a),
            Expr::Add(a, b) => of(*a).wrapping_add(of(*b)),
            Expr::Sub(a, b) => of(*a).wrapping_sub(of(*b)),
            Expr::AddCarry(a, b, bit) => {
                of(*a).wrapping_add(of(*b)).wrapping_add(self.bit(*bit).into())
            }
            Expr::InvertIf(bit, a) => of(*a) ^ if self.bit(*bit) { u128::MAX } else { 0 },
            Expr::Negate(a) => of(*a).wrapping_neg(),
            Expr::Multiply(a, b) => {
                let product = value(*a) * value(*b);
                let pattern = product as u128 & mask(to.bits);
                assert_eq!(number(pattern, to.bits, to.signed), product, "{} holds it", to.name);
                pattern
            }
            Expr::Bitwise(operator, a, b) => {
                let bits = |id| self.module.word(id).bits;
                assert_eq!((bits(*a), bits(*b)), (to.bits, to.bits), "operands of {}", to.name);
                let (a, b) = (self.whole(*a), self.whole(*b));
                match operator {
                    Bitwise::And => a & b,
                    Bitwise::Or => a | b,
                    Bitwise::Xor => a ^ b,
                }
            }
            Expr::Equal(a, b) => {
                let (a, b, _) = two(*a, *b);
                flag(a == b)
            }
            Expr::Less { a, b, signed } => {
                let (a, b, bits) = two(*a, *b);
                flag(number(a, bits, *signed) < number(b, bits, *signed))
            }
            Expr::Choose { cases, default } => {
                // All alternatives have the bits of the result, selected or not.
                let default = of(*default);
                let cases: Vec<_> = cases.iter().map(|(bit, a)| (self.bit(*bit), of(*a))).collect();
                cases.into_iter().find(|(holds, _)| *holds).map_or(default, |(_, a)| a)
            }
            Expr::Concat(parts) => {
                let parts: Vec<_> = parts.iter().map(|part| self.operand(*part)).collect();
                assert_eq!(parts.iter().map(|(_, bits)| bits).sum::<u32>(), to.bits);
                parts.into_iter().fold(0, |all, (pattern, bits)| all << bits | pattern)
            }
            Expr::ShiftLeft(a, count) => {
                assert!(!self.module.word(*count).signed, "a count of {}", to.name);
                let count = u32::try_from(self.whole(*count)).unwrap_or(u32::MAX);
                of(*a).checked_shl(count).unwrap_or(0)
            }
            Expr::Above { word, keep } => {
                assert!(*keep < self.module.word(*word).bits);
                flag(value(*word) >= 1 << keep)
            }
            Expr::Below { word, keep } => {
                assert!(self.module.word(*word).signed && *keep < self.module.word(*word).bits);
                flag(value(*word) < -(1 << keep))
            }
            Expr::Read(..) => unreachable!("rows are kept apart"),
        };
        result & mask(to.bits)
    }

    fn row(&self, table: usize, address: WordId) -> Vec<bool> {
        assert_eq!(self.module.word(address).bits, self.module.tables[table].addr_bits);
        self.tables[table][self.whole(address) as usize].clone()
    }

    /// Settles the logic for the input words.
    pub(crate) fn settle(&mut self, inputs: &[i64], valid: bool) {
        let module = self.module;
        assert_eq!(inputs.len(), module.inputs.len());
        for (id, raw) in module.inputs.iter().zip(inputs) {
            self.words[id.index()] = module.word(*id).format.unwrap().pattern(*raw).into();
        }
        self.valid.insert("valid_in".to_owned(), valid);
        for item in module.stages.iter().flat_map(|stage| &stage.items) {
            match item {
                Item::Scope(_) => {}
                Item::Assign(id, Expr::Read(table, address)) => {
                    let row = self.row(*table, *address);
                    self.rows.insert(*id, row);
                }
                Item::Assign(id, expr) => self.words[id.index()] = self.expr(expr, *id),
            }
        }
    }

    /// A clock edge.
    pub(crate) fn clock(&mut self, enable: bool, reset: bool) {
        let loads = |flag: Option<Bit>| enable && flag.is_none_or(|flag| self.bit(flag));
        let mut words = Vec::new();
        let mut rows = Vec::new();
        for register in self.module.stages.iter().flat_map(|stage| &stage.registers) {
            let Register { word, next, load, ref valid, reset: cleared } = *register;
            let is_data = valid.as_ref().is_none_or(|valid| self.valid.get(valid) == Some(&true));
            match next {
                _ if cleared && reset => words.push((word, 0)),
                _ if !(loads(load) && is_data) => {}
                Next::Word(from) => words.push((word, self.whole(from))),
                Next::Read(table, address) => rows.push((word, self.row(table, address))),
            }
        }
        let mut valid = Vec::new();
        for bit in self.module.stages.iter().flat_map(|stage| &stage.valid) {
            if reset {
                valid.push((bit.to.clone(), false));
            } else if loads(bit.load) {
                valid.push((bit.to.clone(), self.valid.get(&bit.from) == Some(&true)));
            }
        }
        words.into_iter().for_each(|(id, word)| self.words[id.index()] = word);
        self.rows.extend(rows);
        self.valid.extend(valid);
    }

    /// True if the outputs are valid.
    pub(crate) fn valid_out(&self) -> bool {
        let (bit, flag) = &self.module.valid;
        self.valid.get(bit) == Some(&true) && flag.is_none_or(|flag| self.bit(flag))
    }

    /// True if the module takes its inputs at the next edge.
    pub(crate) fn ready(&self) -> bool {
        self.module.ready.is_none_or(|flag| self.bit(flag))
    }

    /// Bit patterns at the output ports.
    pub(crate) fn outputs(&self) -> Vec<u128> {
        self.module.outputs.iter().map(|(_, id)| self.whole(*id)).collect()
    }
}

fn module(rtl: &Arc<Rtl>) -> Module {
    Module::new(rtl, &Options::default()).unwrap()
}

fn combinational(netlist: Netlist) -> (Arc<Netlist>, Module) {
    let netlist = Arc::new(netlist);
    let schedule = Schedule::pipeline(&netlist, Rom::Distributed, Depth::Stages(0)).unwrap();
    let module = module(&Arc::new(Rtl::new(Arc::clone(&netlist), schedule)));
    (netlist, module)
}

/// Sends a stream of words, with occasional gaps, stalls, and one reset. Every word of the module
/// that is a signal is compared with the reference for its sample.
fn stream(rtl: &Arc<Rtl>, module: &Module, seed: u64) {
    let netlist = rtl.netlist();
    let (latency, interval) = (module.latency as usize, module.interval as usize);
    let mut random = Random::new(seed ^ 0xfeed);
    let mut machine = Machine::new(module);
    let by_name: BTreeMap<&str, usize> =
        module.words.iter().enumerate().map(|(at, word)| (word.name.as_str(), at)).collect();
    let signals: Vec<(Signal, usize)> = netlist
        .ids()
        .flat_map(|node| (0..=module.latency).map(move |stage| Signal { node, stage }))
        .filter_map(|signal| Some((signal, by_name[module.signal(signal)?.name.as_str()])))
        .collect();
    for id in netlist.ids() {
        let mut all = vec![Signal { node: id, stage: rtl.schedule().stage(id) }];
        all.extend(rtl.registers(id));
        // Inside a unit only its result is a signal.
        if !rtl.is_free(id) && rtl.result(id).is_none() {
            assert!(all.len() == 1 && module.signal(all[0]).is_none(), "seed {seed}: {all:?}");
            continue;
        }
        let missing = all.iter().find(|signal| module.signal(**signal).is_none());
        assert!(missing.is_none(), "seed {seed}: {missing:?}");
    }
    // Samples in the pipeline, the latest first: words of all nodes, and whether they are valid.
    let mut flight: VecDeque<(Vec<i64>, bool)> = VecDeque::new();
    let mut seen = 0;
    let reset_at = latency + 4 + random.below(8);
    let mut reset_done = latency == 0;
    let cycles = 2 * latency + 24 * interval;
    // The phase counter may start anywhere.
    if interval > 1 {
        machine.clock(false, true);
    }
    let (mut at, mut phase) = (0, 0);
    while at < cycles {
        let words: Vec<i64> =
            netlist.inputs().iter().map(|id| random.word(netlist.node(*id).format)).collect();
        let valid = random.below(8) > 0;
        machine.settle(&words, valid);
        assert_eq!(machine.ready(), phase == 0, "seed {seed}, cycle {at}: ready");
        // Words in other phases aren't taken.
        flight.push_front((netlist.eval(&words).unwrap().0, valid && phase == 0));
        for (signal, index) in &signals {
            // A constant is the same for every sample. A word holds a sample in the phase of its
            // stage, and a hold register holds it for a whole interval.
            let own = rtl.schedule().stage(signal.node) as usize;
            let first = signal.stage as usize;
            let seen = if first == own { first..first + 1 } else { first..first + interval };
            let mine = seen.clone().find(|stage| stage % interval == phase);
            let Some((reference, _)) = mine.and_then(|stage| flight.get(stage)) else { continue };
            let format = netlist.node(signal.node).format;
            let word = &module.words[*index];
            let is = machine.words[*index];
            let should = u128::from(format.pattern(reference[signal.node.index()]));
            assert_eq!((word.bits, word.signed), (format.bits(), format.is_signed()));
            assert_eq!(is, should, "seed {seed}, cycle {at}: {} {format}", word.name);
        }
        let out = flight.get(latency);
        let valid_out = out.is_some_and(|(_, valid)| *valid);
        assert_eq!(machine.valid_out(), valid_out, "seed {seed}, cycle {at}: valid");
        if let Some((reference, true)) = out {
            let should = |(port, is): (usize, u128)| {
                let output = &netlist.outputs()[port];
                let format = netlist.node(output.node).format;
                let should = u128::from(format.pattern(reference[output.node.index()]));
                assert_eq!(is, should, "seed {seed}, cycle {at}: {}", output.name);
            };
            machine.outputs().into_iter().enumerate().for_each(should);
            seen += 1;
        }
        let stall = latency > 0 && random.below(5) == 0;
        let reset = !reset_done && at == reset_at;
        machine.clock(!stall, reset);
        if stall {
            // The words of this cycle never enter: the next cycle has others.
            flight.pop_front();
        } else {
            at += 1;
            phase = (phase + 1) % interval;
            flight.truncate(latency + interval + 1);
        }
        if reset {
            reset_done = true;
            phase = 0;
            flight.iter_mut().for_each(|(_, valid)| *valid = false);
            // When the phase jumps, no word belongs to an earlier sample.
            if interval > 1 {
                flight.clear();
            }
        }
    }
    assert!(seen > 0 && reset_done, "seed {seed}: {seen} samples came out");
}

#[test]
fn random_netlists_with_stalls_and_a_reset() {
    for seed in 0..400 {
        let netlist = Arc::new(random_netlist(seed));
        let rtl = some_rtl(&netlist, seed / 3);
        stream(&rtl, &module(&rtl), seed);
    }
    // Every kind of table at every depth.
    for seed in 0..40 {
        let netlist = Arc::new(random_netlist(seed));
        for rom in [Rom::Block, Rom::Distributed] {
            for depth in [Depth::Stages(3), Depth::Stages(9), Depth::Period(100)] {
                let Ok(schedule) = Schedule::pipeline(&netlist, rom, depth) else { continue };
                let rtl = Arc::new(Rtl::new(Arc::clone(&netlist), schedule));
                stream(&rtl, &module(&rtl), seed);
            }
        }
    }
}

const ROTATIONS: [&[&str]; 6] = [
    &["variant=exact"],
    &["variant=exact", "output=polar-cordic"],
    &["variant=exact", "output=polar-table", "rom=distributed"],
    &["variant=corrected", "scheme=bipartite"],
    &["variant=printed", "scheme=linear", "period_ps=100"],
    &["scheme=linear", "rom=distributed", "stages=0"],
];

#[test]
fn rotation_with_stalls_and_a_reset() {
    for (seed, assignments) in ROTATIONS.iter().enumerate() {
        let design = rotation::unit().values(assignments).unwrap().build().unwrap();
        let rtl = Arc::new(design.rtl().unwrap());
        stream(&rtl, &module(&rtl), seed as u64);
    }
}

fn formats(
    bits: impl Iterator<Item = u32>,
    frac: impl Iterator<Item = i32> + Clone,
) -> Vec<Format> {
    bits.flat_map(|bits| frac.clone().map(move |frac| (bits, frac)))
        .flat_map(|(bits, frac)| [false, true].map(|sign| Format::new(sign, bits, frac).unwrap()))
        .collect()
}

fn words(format: Format) -> impl Iterator<Item = i64> + Clone {
    format.min_raw()..=format.max_raw()
}

/// Extreme and random words.
fn some_words(format: Format, count: usize) -> Vec<i64> {
    let mut random = Random::new(u64::from(format.bits()));
    (0..count).map(|_| random.word(format)).collect()
}

fn narrowing(from: Format, to: Format, words: impl Iterator<Item = i64> + Clone) -> usize {
    let mut compared = 0;
    for round in Round::ALL {
        for overflow in Overflow::ALL {
            let mut b = Builder::new("narrowing");
            let x = b.input("x", from, Quantity::Number);
            let y = b.narrow(x, to, *round, *overflow);
            b.output("y", y);
            let (_, module) = combinational(b.build().unwrap());
            let mut machine = Machine::new(&module);
            for raw in words.clone() {
                machine.settle(&[raw], true);
                let (should, _) = narrow(raw, from.frac_bits(), to, *round, *overflow);
                assert_eq!(
                    machine.outputs(),
                    [u128::from(to.pattern(should))],
                    "{raw} from {from} to {to} {round} {overflow}: {should}\n{:?}",
                    module.stages[0].items
                );
                compared += 1;
            }
        }
    }
    compared
}

#[test]
fn every_narrow_of_small_formats() {
    let from = formats(1..=6, 0..=0);
    let mut compared = 0;
    for from in &from {
        // From shifts that drop all bits and more, to shifts beyond every format.
        for to in formats(1..=6, -8..=9) {
            compared += narrowing(*from, to, words(*from));
        }
    }
    assert_eq!(compared, 2 * (2 + 4 + 8 + 16 + 32 + 64) * 2 * 6 * 18 * 20);
}

#[test]
fn narrows_of_wide_formats() {
    let wide =
        [(63, 0), (63, 62), (62, -20), (33, 70), (32, -127), (1, 127), (63, 127), (63, -127)];
    let all: Vec<Format> = wide
        .into_iter()
        .flat_map(|(bits, frac)| [false, true].map(|sign| Format::new(sign, bits, frac).unwrap()))
        .collect();
    for from in &all {
        for to in &all {
            narrowing(*from, *to, some_words(*from, 24).into_iter());
        }
    }
    // Ties and their neighbours, which random words don't hit.
    let from = Format::signed(63, 40).unwrap();
    for bits in [1, 20, 62, 63] {
        for frac in [-30, -23, -22, -1, 0, 20, 39] {
            let half = 1i64 << (39 - frac).clamp(0, 61);
            let ties = [half, -half, 3 * (half / 2), 3 * half.min(1 << 59), -3 * half.min(1 << 59)];
            let near = ties.into_iter().flat_map(|tie| [tie - 1, tie, tie + 1]);
            let near = near.filter(|raw| from.contains(*raw));
            narrowing(from, Format::signed(bits, frac).unwrap(), near);
        }
    }
}

/// Compares one operation with the reference on all words of its operands, or on some if there are
/// too many. Returns how many, or 0 if the operation refuses the formats.
fn operation(formats: &[Format], build: &dyn Fn(&mut Builder, &[NodeId]) -> NodeId) -> usize {
    let mut b = Builder::new("operation");
    let operands: Vec<NodeId> = formats
        .iter()
        .enumerate()
        .map(|(i, format)| b.input(&format!("x{i}"), *format, Quantity::Number))
        .collect();
    let y = build(&mut b, &operands);
    b.output("y", y);
    let Ok(netlist) = b.build() else { return 0 };
    let (netlist, module) = combinational(netlist);
    let format = netlist.node(netlist.outputs()[0].node).format;
    let mut machine = Machine::new(&module);
    let mut compare = |words: &[i64]| {
        machine.settle(words, true);
        let should = netlist.eval(words).unwrap().0[netlist.outputs()[0].node.index()];
        let should = u128::from(format.pattern(should));
        assert_eq!(machine.outputs(), [should], "{words:?} in {}", netlist.to_text());
    };
    let bits: u32 = formats.iter().map(|format| format.bits()).sum();
    if bits > 12 {
        let columns: Vec<Vec<i64>> = formats.iter().map(|f| some_words(*f, 60)).collect();
        for (i, rotated) in (0..60).flat_map(|i| [0, 7, 31].map(|by| (i, (i + by) % 60))) {
            // Not all operands are at their ends at the same time.
            let at = |port: usize| if port.is_multiple_of(2) { i } else { rotated };
            let row: Vec<i64> = columns.iter().enumerate().map(|(p, c)| c[at(p)]).collect();
            compare(&row);
        }
        return 180;
    }
    let mut row: Vec<i64> = formats.iter().map(|format| format.min_raw()).collect();
    let mut count = 0;
    loop {
        compare(&row);
        count += 1;
        let Some(port) = (0..row.len()).find(|port| row[*port] < formats[*port].max_raw()) else {
            return count;
        };
        row[port] += 1;
        (0..port).for_each(|port| row[port] = formats[port].min_raw());
    }
}

#[test]
fn every_operation_on_two_small_words() {
    type Build = fn(&mut Builder, &[NodeId]) -> NodeId;
    let two: [(&str, Build); 6] = [
        ("add", |b, of| b.add(of[0], of[1])),
        ("sub", |b, of| b.sub(of[0], of[1])),
        ("mul", |b, of| b.mul(of[0], of[1])),
        ("equal", |b, of| b.equal(of[0], of[1])),
        ("less", |b, of| b.less(of[0], of[1])),
        ("square", |b, of| b.mul(of[0], of[0])),
    ];
    let three: [(&str, Build); 2] = [
        ("addsub", |b, of| b.addsub(of[0], of[1], of[2])),
        ("mux", |b, of| b.mux(of[0], of[1], of[2])),
    ];
    let mut pairs = Vec::new();
    let small = formats(1..=4, -1..=2);
    for a in &small {
        pairs.extend(small.iter().map(|b| [*a, *b]));
    }
    // Formats with distant points, and the widest ones.
    let wide = formats([1, 2, 31, 32, 61, 62, 63].into_iter(), [0, 1, 40].into_iter());
    for a in &wide {
        pairs.extend(wide.iter().map(|b| [*a, *b]));
    }
    for (name, build) in two {
        let compared: usize = pairs.iter().map(|pair| operation(pair, &build)).sum();
        assert!(compared > 60_000, "{name}: {compared}");
    }
    for (name, build) in three {
        let with_flag = |pair: &[Format; 2]| operation(&[Format::FLAG, pair[0], pair[1]], &build);
        let compared: usize = pairs.iter().map(with_flag).sum();
        assert!(compared > 120_000, "{name}: {compared}");
    }
    for format in formats(1..=5, -1..=1).into_iter().chain(formats([32, 63].into_iter(), 0..=0)) {
        let bitwise: [Build; 3] =
            [|b, of| b.and(of[0], of[1]), |b, of| b.or(of[0], of[1]), |b, of| b.xor(of[0], of[1])];
        for build in bitwise {
            assert!(operation(&[format, format], &build) > 0, "{format}");
        }
    }
}

#[test]
fn every_operation_on_one_word() {
    let all = formats(1..=7, -1..=2).into_iter().chain(formats([32, 62, 63].into_iter(), 0..=1));
    for format in all {
        let bits = format.bits();
        // The opposite of the least 63-bit word isn't representable.
        let most = bits == Format::MAX_BITS;
        assert!(operation(&[format], &|b, of| b.neg(of[0])) > 0 || most, "{format}");
        assert!(operation(&[format], &|b, of| b.abs(of[0])) > 0, "{format}");
        for lo in 0..bits {
            for count in (1..=bits - lo).filter(|count| bits < 8 || count % 13 == 1) {
                assert!(operation(&[format], &|b, of| b.slice(of[0], lo, count)) > 0);
            }
        }
        for left in [-3, -1, 1, 5] {
            assert!(operation(&[format], &|b, of| b.shift(of[0], left)) > 0);
        }
        for to in [1, 2, bits, bits + 1, 9, 63] {
            for signed in [false, true] {
                let to = Format::new(signed, to.min(63), format.frac_bits()).unwrap();
                assert!(operation(&[format], &|b, of| b.modulo(of[0], to)) > 0);
            }
        }
    }
}

#[test]
fn leading_zeros_of_every_number_of_bits() {
    for bits in 1..=63 {
        let format = Format::integer(bits).unwrap();
        assert!(operation(&[format], &|b, of| b.leading_zeros(of[0])) > 0);
        // One bit set, with and without all bits below it.
        let mut b = Builder::new("count");
        let x = b.input("x", format, Quantity::Number);
        let y = b.leading_zeros(x);
        b.output("y", y);
        let (netlist, module) = combinational(b.build().unwrap());
        let mut machine = Machine::new(&module);
        for word in (0..bits).flat_map(|top| [1 << top, (1i64 << top) | ((1 << top) - 1)]) {
            machine.settle(&[word], true);
            let should = bits - (64 - word.leading_zeros());
            assert_eq!(machine.outputs(), [u128::from(should)], "{word:#x} of {bits} bits");
            assert_eq!(netlist.eval(&[word]).unwrap().0[1], i64::from(should));
        }
    }
}

#[test]
fn shifts_by_a_count_below_at_and_above_their_range() {
    for format in formats(1..=5, -1..=1).into_iter().chain(formats([31, 60].into_iter(), 0..=0)) {
        for count_bits in 1..=6 {
            let count = Format::integer(count_bits).unwrap();
            for max in (0..=63u32).filter(|max| max + format.bits() <= 63) {
                if format.bits() > 2 && ![0, 1, 2, 3, 4, 6, 7, 8, 15, 31, 32].contains(&max) {
                    continue;
                }
                let shift = |b: &mut Builder, of: &[NodeId]| b.shift_left(of[0], of[1], max);
                assert!(operation(&[format, count], &shift) > 0, "{format} {max}");
            }
        }
    }
}

#[test]
fn words_side_by_side() {
    for high in [1, 2, 5, 31, 32, 62] {
        for low in [1, 2, 5, 31, 32, 62] {
            let formats = [high, low].map(|bits| Format::integer(bits).unwrap());
            let compared = operation(&formats, &|b, of| b.concat(of[0], of[1]));
            assert_eq!(compared > 0, high + low <= 63);
        }
    }
}

/// A table of columns with these formats; each word is a hash of its place.
fn table(name: &str, addr_bits: u32, formats: &[Format]) -> Table {
    let mut random = Random::new(u64::from(addr_bits) + formats.len() as u64);
    let column = |(i, format): (usize, &Format)| Column {
        name: format!("c{i}"),
        format: *format,
        words: (0..1 << addr_bits).map(|_| random.word(*format)).collect(),
    };
    Table {
        name: name.to_owned(),
        addr_bits,
        columns: formats.iter().enumerate().map(column).collect(),
        memory: None,
    }
}

#[test]
fn tables_of_some_columns_of_which_some_are_read() {
    let of = |signed, bits| Format::new(signed, bits, 3).unwrap();
    let tables = [
        table("t", 3, &[of(true, 7), of(false, 1), of(true, 1), of(false, 12), of(true, 63)]),
        table("t", 1, &[of(false, 63), of(true, 63), of(false, 62), of(true, 5)]),
        table("t", 5, &[of(false, 1)]),
        table("t", 2, &[of(true, 4), of(false, 8)]),
    ];
    let mut widest = 0;
    for table in &tables {
        for read in 1u32..1 << table.columns.len() {
            let mut b = Builder::new("reads");
            let address = b.input("x", table.address_format(), Quantity::Number);
            let other = b.input("y", table.address_format(), Quantity::Number);
            let id = b.table(table.clone());
            for column in (0..table.columns.len()).filter(|column| read >> column & 1 == 1) {
                for (port, at) in [("x", address), ("y", other)] {
                    let node = b.read(id, column, at);
                    b.output(&format!("{port}{column}"), node);
                }
            }
            let netlist = Arc::new(b.build().unwrap());
            for (rom, depth) in [
                (Rom::Distributed, Depth::Stages(0)),
                (Rom::Block, Depth::Stages(2)),
                (Rom::Block, Depth::Stages(4)),
            ] {
                let schedule = Schedule::pipeline(&netlist, rom, depth).unwrap();
                let rtl = Arc::new(Rtl::new(Arc::clone(&netlist), schedule));
                let module = module(&rtl);
                stream(&rtl, &module, u64::from(read));
                // Only columns that are read are stored, once.
                let stored: Vec<&Column> = (0..table.columns.len())
                    .filter(|column| read >> column & 1 == 1)
                    .map(|column| &table.columns[column])
                    .collect();
                let rom = &module.tables[0];
                assert_eq!(module.tables.len(), 1);
                // Some readers drop a last row without a line feed.
                let options = Options { tables: Some(Tables::Files), ..Options::default() };
                let files = Module::new(&rtl, &options).unwrap().table_files();
                let text: String = rom.rows().map(|row| row + "\n").collect();
                assert_eq!(files.iter().map(|file| &file.text).collect::<Vec<_>>(), [&text]);
                assert_eq!(rom.columns.iter().collect::<Vec<_>>(), stored);
                let bits: u32 = stored.iter().map(|column| column.format.bits()).sum();
                assert_eq!((rom.row_bits, rom.len()), (bits, 1 << table.addr_bits));
                widest = widest.max(bits);
                assert_eq!(rom.rows().count(), 1 << table.addr_bits);
                for (at, row) in rom.rows().enumerate() {
                    assert_eq!(row.len(), bits.div_ceil(4) as usize);
                    // In reverse order: the first column is at the top.
                    let mut bits: VecDeque<bool> = bits_of_row(&row, bits).into();
                    for column in &stored {
                        let format = column.format;
                        let pattern = (0..format.bits())
                            .fold(0, |p: u64, _| p << 1 | u64::from(bits.pop_back().unwrap()));
                        assert_eq!(pattern, format.pattern(column.words[at]));
                    }
                }
            }
        }
    }
    assert!(widest > 128, "rows that no integer holds: {widest}");
}

/// Bits of words that an expression reads: word, first bit, number of bits.
fn reads(module: &Module, expr: &Expr) -> Vec<(WordId, u32, u32)> {
    let whole = |id: WordId| (id, 0, module.word(id).bits);
    let view = |operand: Operand| match operand {
        Operand::Literal { .. } => None,
        Operand::View(View { word, lo, zeros, bits }) => {
            let room = bits.saturating_sub(zeros).min(module.word(word).bits - lo);
            (room > 0).then_some((word, lo, room))
        }
    };
    let bit = |bit: Bit| (bit.word, bit.bit, 1);
    match expr {
        Expr::Copy(a) | Expr::Negate(a) => view(*a).into_iter().collect(),
        Expr::Add(a, b) | Expr::Sub(a, b) | Expr::Equal(a, b) | Expr::Less { a, b, .. } => {
            [view(*a), view(*b)].into_iter().flatten().collect()
        }
        Expr::AddCarry(a, b, carry) => {
            [view(*a), view(*b), Some(bit(*carry))].into_iter().flatten().collect()
        }
        Expr::InvertIf(condition, a) => {
            [Some(bit(*condition)), view(*a)].into_iter().flatten().collect()
        }
        Expr::Multiply(a, b) | Expr::Bitwise(_, a, b) => vec![whole(*a), whole(*b)],
        Expr::Choose { cases, default } => {
            let mut all: Vec<_> = view(*default).into_iter().collect();
            for (condition, operand) in cases {
                all.push(bit(*condition));
                all.extend(view(*operand));
            }
            all
        }
        Expr::Concat(parts) => parts.iter().filter_map(|part| view(*part)).collect(),
        Expr::ShiftLeft(a, count) => view(*a).into_iter().chain([whole(*count)]).collect(),
        Expr::Above { word, keep } | Expr::Below { word, keep } => {
            vec![(*word, *keep, module.word(*word).bits - keep)]
        }
        Expr::Read(_, address) => vec![whole(*address)],
    }
}

/// Reserved words of Verilog, VHDL and C++, from their standards and not from the crate's list,
/// plus names that Verilator, Icarus, GHDL and g++ were seen to reject.
const KEYWORDS: &[&str] = &[
    "abort",
    "abs",
    "access",
    "after",
    "alias",
    "alignas",
    "alignof",
    "all",
    "always",
    "and",
    "and_eq",
    "architecture",
    "array",
    "assert",
    "assign",
    "attribute",
    "auto",
    "begin",
    "bit",
    "bitand",
    "bitor",
    "block",
    "body",
    "bool",
    "break",
    "buf",
    "buffer",
    "bus",
    "byte",
    "case",
    "casex",
    "catch",
    "ce",
    "char",
    "char16_t",
    "char32_t",
    "char8_t",
    "class",
    "clk",
    "co_await",
    "co_return",
    "co_yield",
    "complex",
    "component",
    "configuration",
    "const",
    "const_cast",
    "const_iterator",
    "const_reference",
    "constant",
    "consteval",
    "constinit",
    "continue",
    "cover",
    "deassign",
    "default",
    "defparam",
    "delete",
    "deque",
    "disable",
    "disconnect",
    "do",
    "double",
    "downto",
    "dynamic_cast",
    "edge",
    "else",
    "elsif",
    "end",
    "endcase",
    "endfunction",
    "endmodule",
    "entity",
    "enum",
    "errno",
    "event",
    "exit",
    "explicit",
    "extern",
    "far",
    "file",
    "final",
    "float",
    "for",
    "force",
    "forever",
    "fork",
    "friend",
    "function",
    "generate",
    "generic",
    "genvar",
    "goto",
    "group",
    "guarded",
    "huge",
    "if",
    "import",
    "impure",
    "in",
    "inertial",
    "inherit",
    "initial",
    "inline",
    "inout",
    "input",
    "int",
    "int16_t",
    "int32_t",
    "int64_t",
    "int8_t",
    "integer",
    "interrupt",
    "is",
    "iterator",
    "join",
    "label",
    "large",
    "library",
    "linkage",
    "linux",
    "list",
    "literal",
    "localparam",
    "logic",
    "long",
    "loop",
    "mailbox",
    "map",
    "mod",
    "module",
    "mutable",
    "namespace",
    "nand",
    "near",
    "negedge",
    "new",
    "next",
    "nmos",
    "nor",
    "not",
    "not_eq",
    "null",
    "of",
    "on",
    "open",
    "operator",
    "or",
    "others",
    "out",
    "output",
    "package",
    "parameter",
    "pascal",
    "pmos",
    "port",
    "posedge",
    "postponed",
    "primitive",
    "private",
    "procedure",
    "process",
    "protected",
    "public",
    "pull0",
    "pull1",
    "pure",
    "queue",
    "range",
    "real",
    "record",
    "reference",
    "reg",
    "register",
    "reinterpret_cast",
    "reject",
    "release",
    "rem",
    "repeat",
    "report",
    "return",
    "rol",
    "ror",
    "rst",
    "sc_in",
    "sc_out",
    "sc_signal",
    "select",
    "semaphore",
    "sensitive",
    "set",
    "severity",
    "shared",
    "short",
    "signal",
    "signed",
    "size_t",
    "sizeof",
    "sla",
    "sll",
    "small",
    "specify",
    "sra",
    "srl",
    "stack",
    "static",
    "static_assert",
    "static_cast",
    "string",
    "strong0",
    "struct",
    "subtype",
    "supply0",
    "supply1",
    "switch",
    "synchronized",
    "table",
    "task",
    "template",
    "then",
    "this",
    "thread_local",
    "throw",
    "time",
    "to",
    "tran",
    "transport",
    "tri",
    "tri0",
    "triand",
    "trireg",
    "try",
    "type",
    "type_info",
    "typedef",
    "uint16_t",
    "uint32_t",
    "uint64_t",
    "uint8_t",
    "unaffected",
    "union",
    "unique",
    "units",
    "unix",
    "unsigned",
    "until",
    "use",
    "using",
    "valid_in",
    "valid_out",
    "var",
    "variable",
    "vector",
    "vectored",
    "virtual",
    "void",
    "volatile",
    "wait",
    "wand",
    "wchar_t",
    "weak0",
    "when",
    "while",
    "wire",
    "with",
    "wone",
    "wor",
    "work",
    "wreal",
    "xnor",
    "xor",
    "xor_eq",
];

/// Properties that hold for every module, whatever its content.
fn check_promises(rtl: &Arc<Rtl>, module: &Module) {
    let netlist = rtl.netlist();
    // Names: of words, tables, ports and the module, and those that back ends declare themselves.
    let mut names: BTreeSet<&str> = BTreeSet::from([module.name.as_str()]);
    let mut taken: Vec<&str> = module.words.iter().map(|word| word.name.as_str()).collect();
    taken.extend(module.tables.iter().map(|table| table.name.as_str()));
    taken.extend(
        module
            .outputs
            .iter()
            .filter_map(|(name, id)| (module.word(*id).name != *name).then_some(name.as_str())),
    );
    let valids: Vec<String> = (1..=module.latency)
        .step_by(module.interval as usize)
        .map(|stage| format!("valid_s{stage}"))
        .collect();
    let bits = module.stages.iter().flat_map(|stage| &stage.valid);
    assert_eq!(bits.map(|valid| valid.to.clone()).collect::<Vec<_>>(), valids);
    assert_eq!(valids.len(), rtl.valid_bits() as usize);
    taken.extend(valids.iter().map(String::as_str));
    assert_eq!(module.ready.is_some(), module.interval > 1);
    if module.ready.is_some() {
        taken.push("ready");
    }
    for name in taken {
        assert!(names.insert(name), "{name} is there twice");
        assert!(!KEYWORDS.contains(&name), "{name} is a keyword");
        let legal = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
        assert!(name.starts_with(|c: char| c.is_ascii_lowercase()), "{name}");
        assert!(name.chars().all(legal) && !name.contains("__") && !name.ends_with('_'), "{name}");
    }
    let originals = || module.tables.iter().filter(|table| table.copy_of.is_none());
    let files: BTreeSet<String> = originals().map(|t| module.table_file(t)).collect();
    assert_eq!(files.len(), originals().count(), "tables share a file: {files:?}");
    check_copies(module);
    assert_eq!(module.inputs.len(), netlist.inputs().len());
    assert_eq!(module.outputs.len(), netlist.outputs().len());
    // Each word is driven once, before it is used.
    let mut defined: BTreeSet<WordId> = BTreeSet::new();
    let define = |id: WordId, defined: &mut BTreeSet<WordId>, drivers: &[Driver]| {
        let word = module.word(id);
        assert!(defined.insert(id), "{} is driven twice", word.name);
        assert!(drivers.contains(&word.driver), "{} {:?}", word.name, word.driver);
    };
    let mut used: Vec<Vec<bool>> =
        module.words.iter().map(|word| vec![false; word.bits as usize]).collect();
    let mut use_bits = |(id, lo, bits): (WordId, u32, u32), defined: &BTreeSet<WordId>| {
        assert!(defined.contains(&id), "{} is used before it is known", module.word(id).name);
        used[id.index()][lo as usize..(lo + bits) as usize].fill(true);
    };
    let whole = |id: WordId| (id, 0, module.word(id).bits);
    module.inputs.iter().for_each(|id| define(*id, &mut defined, &[Driver::Input]));
    let flat = module.interval == 1 && rtl.units().is_empty();
    if flat {
        assert_eq!(module.stages.len(), module.latency as usize + 1);
        assert!(module.stages.last().unwrap().registers.is_empty());
    }
    // Ports that are registers are declared in the head.
    let ports: BTreeSet<WordId> = module
        .outputs
        .iter()
        .map(|(_, id)| *id)
        .filter(|id| !flat && module.word(*id).driver == Driver::OutputRegister)
        .collect();
    let mut declared: BTreeSet<WordId> = BTreeSet::new();
    for stage in &module.stages {
        assert!(!flat || stage.declared.is_empty() && stage.registers.iter().all(|r| !r.reset));
        declared.extend(stage.declared.iter().copied());
        let mut known: BTreeSet<WordId> = &(&declared | &ports) | &defined;
        for item in &stage.items {
            let Item::Assign(id, expr) = item else { continue };
            for part in reads(module, expr) {
                use_bits(part, &known);
            }
            define(*id, &mut defined, &[Driver::Logic]);
            known.insert(*id);
        }
        for Register { word, next, load, .. } in &stage.registers {
            let (Next::Word(from) | Next::Read(_, from)) = *next;
            use_bits(whole(from), &known);
            if let Some(flag) = load {
                use_bits((flag.word, flag.bit, 1), &known);
            }
            define(*word, &mut defined, &[Driver::Register, Driver::OutputRegister]);
        }
        for flag in stage.valid.iter().filter_map(|valid| valid.load) {
            use_bits((flag.word, flag.bit, 1), &known);
        }
    }
    for flag in [module.ready, module.valid.1].into_iter().flatten() {
        use_bits((flag.word, flag.bit, 1), &defined);
    }
    for (port, (name, id)) in module.outputs.iter().enumerate() {
        use_bits(whole(*id), &defined);
        let word = module.word(*id);
        assert_eq!(word.format, Some(netlist.node(netlist.outputs()[port].node).format));
        // A register that drives two ports has the name of the first.
        let named = module.outputs.iter().any(|(name, _)| *name == word.name);
        assert_eq!(word.driver == Driver::OutputRegister, named, "{name}");
    }
    assert_eq!(defined.len(), module.words.len(), "every word is driven");
    for (word, used) in module.words.iter().zip(used) {
        assert_eq!(word.used, used, "bits of {} that are used", word.name);
        assert_eq!(word.used.len(), word.bits as usize);
        if let Some(format) = word.format {
            let is = (word.signed, word.bits, word.frac);
            assert_eq!(
                is,
                (format.is_signed(), format.bits(), format.frac_bits()),
                "{}",
                word.name
            );
        }
    }
}

/// A table has no more clocked ports than a block RAM. A copy has the rows of its original and at
/// least one port.
fn check_copies(module: &Module) {
    let mut ports = vec![0; module.tables.len()];
    let registers = module.stages.iter().flat_map(|stage| &stage.registers);
    for register in registers {
        if let Next::Read(table, _) = register.next {
            ports[table] += 1;
        }
    }
    for (table, ports) in module.tables.iter().zip(ports) {
        assert!(module.tables_in == Tables::Case || ports <= 2, "{}: {ports} ports", table.name);
        if let Some(of) = table.copy_of {
            let of = &module.tables[of];
            assert!(ports > 0 && of.copy_of.is_none(), "{}", table.name);
            assert_eq!(module.table_file(table), module.table_file(of));
            assert_eq!((&table.columns, table.addr_bits), (&of.columns, of.addr_bits));
        }
    }
}

/// Ports have the names that the netlist gave them.
fn check_ports(rtl: &Arc<Rtl>, module: &Module) {
    let netlist = rtl.netlist();
    let inputs: Vec<&str> = (0..netlist.inputs().len()).map(|i| netlist.input_name(i)).collect();
    let outputs: Vec<&str> = netlist.outputs().iter().map(|output| output.name.as_str()).collect();
    let given: Vec<&str> = module.inputs.iter().map(|id| module.word(*id).name.as_str()).collect();
    assert_eq!(given, inputs);
    let given: Vec<&str> = module.outputs.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(given, outputs);
}

/// Hardware of a shared schedule, for the netlist of a seed.
pub(crate) fn shared_rtl(seed: u64) -> Option<Arc<Rtl>> {
    let mut random = Random::new(seed ^ 0xabcd);
    let netlist = Arc::new(if random.chance(50) {
        with_dots(seed)
    } else {
        random_netlist_within(seed, 4 + random.below(40), random.pick(&[6, 8, 12]))
    });
    let plan = random_plan(&mut random);
    let rom = random.pick(&[Rom::Block, Rom::Distributed]);
    let period = random.pick(&[100, 2000, 4000, 8000]);
    let schedule = Schedule::shared(&netlist, rom, period, &plan).ok()?;
    Some(Arc::new(Rtl::new(netlist, schedule)))
}

#[test]
fn shared_hardware_with_stalls_and_a_reset() {
    let (mut streamed, mut units, mut longest) = (0, 0, 0);
    for rtl in (0..400).filter_map(shared_rtl) {
        let module = module(&rtl);
        check_promises(&rtl, &module);
        check_ports(&rtl, &module);
        stream(&rtl, &module, streamed);
        streamed += 1;
        units += rtl.units().len();
        longest = longest.max(module.interval);
    }
    assert!(streamed > 200 && units > 200 && longest > 8, "{streamed} {units} {longest}");
    let figure_8 = Schedule::bound(&emboss_netlist(), Rom::Block, 6000, &figure_8());
    let rtl = Arc::new(Rtl::new(emboss_netlist(), figure_8.unwrap()));
    let module = module(&rtl);
    check_promises(&rtl, &module);
    for seed in 0..5 {
        stream(&rtl, &module, seed);
    }
}

/// Hardware that external simulators run in `hdl.rs`, as text.
#[test]
fn a_small_shared_module_as_text() {
    let options = Options { header: vec!["under test".to_owned()], ..Options::default() };
    let module = Module::new(&little_shared(), &options).unwrap();
    expect_file!["shared_little.v"].assert_eq(&module.file(&Verilog).text);
    expect_file!["shared_little.vhd"].assert_eq(&module.file(&Vhdl).text);
}

#[test]
fn promises_of_every_module() {
    for seed in 0..300 {
        let netlist = Arc::new(random_netlist(seed));
        let rtl = some_rtl(&netlist, seed / 3);
        let module = module(&rtl);
        check_promises(&rtl, &module);
        check_ports(&rtl, &module);
    }
    for assignments in ROTATIONS {
        let design = rotation::unit().values(assignments).unwrap().build().unwrap();
        let rtl = Arc::new(design.rtl().unwrap());
        let module = module(&rtl);
        check_promises(&rtl, &module);
        check_ports(&rtl, &module);
    }
}

/// A netlist whose names are as bad as legal; `words` are names of nodes.
pub(crate) fn badly_named(words: &[&str]) -> Netlist {
    let format = Format::signed(8, 4).unwrap();
    let mut b = Builder::new("names");
    let x = b.input("x", format, Quantity::Number);
    let z = b.input("z", format, Quantity::Number);
    let mut last = x;
    for (i, word) in words.iter().enumerate() {
        let step = b.constant(i as i64 % 100 + 1, format);
        let sum = b.add(last, step);
        last = b.narrow(sum, format, Round::HalfEven, Overflow::Wrap);
        b.name(last, word);
    }
    // `a_b` and `b` in `a` coincide without scopes, as do the names of the helpers.
    let root = b.add(last, z);
    b.name(root, "a_b");
    let inner = b.scope("a", |b| {
        let node = b.sub(last, z);
        b.name(node, "b")
    });
    let y = b.mul(root, inner);
    let y = b.narrow(y, format, Round::HalfEven, Overflow::Symmetric);
    b.name(y, "y");
    for helper in ["y_sum", "y_half", "y_next_sum", "y_cut", "y_over", "y_s3", "x_s1", "n5"] {
        let node = b.xor(y, last);
        let step = b.constant(helper.len() as i64, format);
        let node = b.mul(node, step);
        b.name(node, helper);
        b.output(&format!("out_{helper}"), node);
    }
    b.output("y", y);
    // Two tables with one name.
    for i in 0..2u32 {
        let id = b.table(table("t", 3 + i, &[format]));
        let address = b.slice(last, 0, 3 + i);
        let node = b.read(id, 0, address);
        b.name(node, ["t_rom", "t_row"][i as usize]);
        b.output(&format!("read{i}"), node);
    }
    b.build().unwrap()
}

#[test]
fn no_name_is_a_keyword_or_there_twice() {
    let mut words = KEYWORDS.to_vec();
    words.extend([
        "x", "z", "names", "y", "valid", "valid_s1", "valid_s2", "t_rom_2", "a_b_2", "a_b",
    ]);
    let netlist = Arc::new(badly_named(&words));
    for (rom, depth) in [
        (Rom::Distributed, Depth::Stages(0)),
        (Rom::Block, Depth::Stages(4)),
        (Rom::Distributed, Depth::Period(100)),
    ] {
        let schedule = Schedule::pipeline(&netlist, rom, depth).unwrap();
        let rtl = Arc::new(Rtl::new(Arc::clone(&netlist), schedule));
        for tables in [Tables::Inline, Tables::Files] {
            let options = Options { tables: Some(tables), ..Options::default() };
            let module = Module::new(&rtl, &options).unwrap();
            check_promises(&rtl, &module);
            check_ports(&rtl, &module);
            stream(&rtl, &module, 5);
        }
    }
}

/// Changed names are reported: in the module and in the head of each file.
#[test]
fn a_name_that_changes_is_told() {
    let format = Format::signed(8, 0).unwrap();
    let mut b = Builder::new("renamed");
    let x = b.input("reg", format, Quantity::Number);
    let z = b.input("z", format, Quantity::Number);
    let y = b.add(x, z);
    b.name(y, "buf");
    b.output("signal", y);
    let (_, module) = combinational(b.build().unwrap());
    let pair = |was: &str, is: &str| (was.to_owned(), is.to_owned());
    let renamed = [pair("reg", "reg_w"), pair("signal", "signal_w"), pair("buf", "buf_w")];
    assert_eq!(module.renamed, renamed);
    for language in LANGUAGES {
        let text = module.file(*language).text;
        assert!(text.contains("renamed, since") && text.contains("  reg is reg_w\n"), "{text}");
    }
    let (_, module) = combinational(random_netlist(3));
    assert!(module.renamed.is_empty() && module.header.is_empty(), "{:?}", module.renamed);
}

/// There are as many copies as the netlist's figure says, and each is written once if tables are
/// files.
#[test]
fn tables_with_many_ports_are_copied() {
    for set in [&[][..], &["scheme=linear", "table_addr_bits=7", "quarter_wave=on"]] {
        let unit = fixpath::units::Unit::find("rotation").unwrap();
        let design = unit.values(set).unwrap().build().unwrap();
        let rtl = Arc::new(design.rtl().unwrap());
        for (tables, copied) in [(Tables::Inline, true), (Tables::Case, false)] {
            let options = Options { tables: Some(tables), ..Options::default() };
            let module = Module::new(&rtl, &options).unwrap();
            let counts = design.netlist.counts();
            let stored: u64 = module
                .tables
                .iter()
                .map(|table| u64::from(table.row_bits) << table.addr_bits)
                .sum();
            let bits = if copied { counts.rom_bits_dual_port } else { counts.rom_bits };
            assert_eq!(stored, bits, "{set:?} {tables:?}");
            assert!(counts.rom_bits_dual_port > counts.rom_bits);
            check_copies(&module);
        }
        let options = Options { tables: Some(Tables::Files), ..Options::default() };
        let module = Module::new(&rtl, &options).unwrap();
        let files = module.table_files();
        assert_eq!(files.len() as u64, design.netlist.counts().tables);
        let names: Vec<String> = files.into_iter().map(|file| file.name).collect();
        assert_eq!(module.table_file_names(), names);
    }
}

#[test]
fn module_names_that_some_tool_would_refuse() {
    // Its ports are in0, … and out0, ….
    let rtl = some_rtl(&Arc::new(random_netlist(3)), 1);
    let build = |name: &str| {
        let options = Options { name: Some(name.to_owned()), ..Options::default() };
        Module::new(&rtl, &options).map(|module| module.name).map_err(|why| why.to_string())
    };
    let longest = "a".repeat(64);
    for name in ["a", "unit7", "a_b_2", &longest] {
        assert_eq!(build(name).as_deref(), Ok(name));
    }
    let long = "a".repeat(65);
    for name in ["", "Unit", "a__b", "a_", "_a", "7a", "a-b", "a b", "ä", "a\n", &long] {
        let why = build(name).unwrap_err();
        let form = "my_module: a letter a to z, then a to z, 0 to 9 and single _ between them, at most 64 characters";
        assert!(why.contains(form), "`{name}`: {why}");
    }
    for name in ["in0", "out0"] {
        let why = build(name).unwrap_err();
        assert!(why.starts_with(&format!("`{name}` is a port of the module: choose")), "{why}");
    }
    for name in KEYWORDS {
        let why = build(name).unwrap_err();
        assert!(why.contains(&format!("`{name}` is a reserved word of")), "{why}");
        assert!(why.contains("choose another name"), "{why}");
    }
}

#[test]
fn tables_that_are_too_large_are_refused() {
    let build = |addr_bits: u32, columns: usize, tables: Option<Tables>| {
        let format = Format::signed(63, 0).unwrap();
        let words: Arc<[i64]> = vec![5; 1 << addr_bits].into();
        let column = |i| Column { name: format!("c{i}"), format, words: Arc::clone(&words) };
        let columns = (0..columns).map(column).collect();
        let mut b = Builder::new("big");
        let x = b.input("x", Format::integer(addr_bits).unwrap(), Quantity::Number);
        let id = b.table(Table { name: "t".to_owned(), addr_bits, columns, memory: None });
        let y = b.read(id, 0, x);
        b.output("y", y);
        let rtl = some_rtl(&Arc::new(b.build().unwrap()), 1);
        let options = Options { tables, ..Options::default() };
        Module::new(&rtl, &options).map(|m| m.tables_in).map_err(|why| why.to_string())
    };
    assert_eq!(build(12, 1, None), Ok(Tables::Inline));
    assert_eq!(build(13, 1, None), Ok(Tables::Files));
    for tables in [Tables::Inline, Tables::Case] {
        assert_eq!(build(16, 1, Some(tables)), Ok(tables));
        let why = build(17, 1, Some(tables)).unwrap_err();
        let text = "131072 inline table rows; the limit is 65536: put tables into files";
        assert!(why.ends_with(text), "{why}");
    }
    assert_eq!(build(17, 1, Some(Tables::Files)), Ok(Tables::Files));
    let bits = (17 * 63u64) << 18;
    let why = build(18, 17, None).unwrap_err();
    let text = format!("{bits} table bits; the limit is 268435456: choose smaller tables");
    assert!(why.ends_with(&text), "{why}");
}
