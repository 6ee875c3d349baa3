//! The fast engines against the reference interpreter, on random netlists.

use fixpath::format::{Format, Overflow, Round};
use fixpath::function::Function;
use fixpath::netlist::{Builder, Column, Netlist, NodeId, Quantity, Rate, State, Table, TableId};
use fixpath::op::Op;
use fixpath::real::{Expr, Primitive};
use fixpath::sim::batch::{BLOCK, Features, Program};
use fixpath::sim::real;
use fixpath::units::{UNITS, Unit};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};
use std::sync::Arc;

/// A small generator of our own, so that a seed always gives the same netlist.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// splitmix64.
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `count`.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }

    pub(crate) fn chance(&mut self, percent: usize) -> bool {
        self.below(100) < percent
    }

    /// A number of `lo..=hi`.
    pub(crate) fn within(&mut self, lo: i64, hi: i64) -> i64 {
        lo + (self.bits() % (hi - lo + 1) as u64) as i64
    }

    pub(crate) fn pick<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())]
    }

    /// A word of a format; half of the time an extreme one.
    pub(crate) fn word(&mut self, format: Format) -> i64 {
        let (lo, hi) = (format.min_raw(), format.max_raw());
        let extremes = [lo, hi, 0, -1, 1, lo + 1, hi - 1, hi / 2, lo / 2];
        let word = match self.below(2) {
            0 => self.pick(&extremes),
            _ => format.wrap(self.bits() as i64),
        };
        word.clamp(lo, hi)
    }
}

/// A netlist with every kind of operation, as a function of `seed` alone.
pub(crate) fn random_netlist(seed: u64) -> Netlist {
    random_netlist_of(seed, 4 + (seed % 61) as usize)
}

/// Like [`random_netlist`], with about `operations` operations.
pub(crate) fn random_netlist_of(seed: u64, operations: usize) -> Netlist {
    let mut random = Random::new(seed);
    // Widths that stay in 32-bit lanes, that just leave them, and any.
    let max_bits = random.pick(&[6, 16, 31, 32, 33, 63, 63]);
    grow(random, operations, max_bits)
}

/// Like [`random_netlist_of`], with words of at most `max_bits` bits.
pub(crate) fn random_netlist_within(seed: u64, operations: usize, max_bits: u32) -> Netlist {
    grow(Random::new(seed), operations, max_bits)
}

/// Like [`random_netlist_within`] with memories (with words bound) and delays, and half of the time
/// with ports of several rates.
pub(crate) fn random_machine(seed: u64) -> Netlist {
    let mut random = Random::new(seed ^ 0x3a5e);
    let max_bits = random.pick(&[6, 12, 16, 31, 33]);
    grow_with(random, 4 + (seed % 41) as usize, max_bits, true)
}

fn grow(random: Random, operations: usize, max_bits: u32) -> Netlist {
    grow_with(random, operations, max_bits, false)
}

fn grow_with(mut random: Random, operations: usize, max_bits: u32, machine: bool) -> Netlist {
    let mut grower = Grower {
        rates: match machine && random.chance(50) {
            true => (0..1 + random.below(3)).map(|_| random.pick(Rate::ALL)).collect(),
            false => vec![Rate::default()],
        },
        random,
        b: Builder::new("random"),
        max_bits,
        machine,
        nodes: Vec::new(),
        tables: Vec::new(),
        memories: Vec::new(),
        ports: Vec::new(),
    };
    for _ in 0..=grower.random.below(4) {
        grower.input();
    }
    while grower.nodes.len() < operations {
        // Ports may come late, after columns have been freed.
        if grower.random.chance(3) { grower.input() } else { grower.operation() }
    }
    let Grower { mut random, mut b, nodes, memories, .. } = grower;
    // Every node should matter: outputs are the last few nodes, and some from anywhere.
    let mut outputs = vec![nodes[nodes.len() - 1]];
    for _ in 0..random.below(6) {
        let any = random.pick(&nodes);
        outputs.push(any);
    }
    for (i, node) in outputs.into_iter().enumerate() {
        b.output(&format!("out{i}"), node);
    }
    let netlist = b.build().expect("the generator checks every operation first");
    let bound = memories.iter().filter(|(name, _)| netlist.memories().any(|m| m.name == *name));
    bound.fold(netlist.clone(), |netlist, (name, words)| netlist.bind(name, words).unwrap())
}

struct Grower {
    random: Random,
    b: Builder,
    max_bits: u32,
    /// Whether to use memories and delays.
    machine: bool,
    /// Rates of the ports.
    rates: Vec<Rate>,
    nodes: Vec<NodeId>,
    tables: Vec<(TableId, Table)>,
    /// Words for the memories.
    memories: Vec<(String, Vec<Arc<[i64]>>)>,
    ports: Vec<NodeId>,
}

impl Grower {
    fn format(&mut self) -> Format {
        let bits = if self.random.chance(20) {
            self.random.pick(&[1, 2, self.max_bits - 1, self.max_bits])
        } else {
            1 + self.random.below(self.max_bits as usize) as u32
        };
        let frac = if self.random.chance(5) {
            self.random.within(-80, 80)
        } else {
            self.random.within(-3, i64::from(bits) + 2)
        };
        Format::new(self.random.chance(60), bits, frac as i32).unwrap()
    }

    fn input(&mut self) {
        let format = self.format();
        let name = format!("in{}", self.ports.len());
        let node = self.b.input(&name, format, Quantity::Number);
        if self.machine {
            let rate = self.random.pick(&self.rates);
            self.b.rate(node, rate);
        }
        self.ports.push(node);
        self.nodes.push(node);
    }

    /// Any node; later ones are more likely.
    fn any(&mut self) -> NodeId {
        let len = self.nodes.len();
        let recent = if self.random.chance(60) { len.min(8) } else { len };
        self.nodes[len - 1 - self.random.below(recent)]
    }

    fn push(&mut self, node: NodeId) -> NodeId {
        self.nodes.push(node);
        node
    }

    fn narrow_to(&mut self, node: NodeId, format: Format) -> NodeId {
        let (round, overflow) = (self.random.pick(Round::ALL), self.random.pick(Overflow::ALL));
        let narrowed = self.b.narrow(node, format, round, overflow);
        self.push(narrowed)
    }

    fn flag(&mut self) -> NodeId {
        let flags: Vec<NodeId> =
            self.nodes.iter().copied().filter(|n| self.b.format(*n) == Format::FLAG).collect();
        if !flags.is_empty() && self.random.chance(50) {
            return self.random.pick(&flags);
        }
        let node = self.any();
        let lo = self.random.below(self.b.format(node).bits() as usize) as u32;
        let flag = self.b.slice(node, lo, 1);
        self.push(flag)
    }

    /// An unsigned integer of at most `bits` bits.
    fn integer(&mut self, bits: u32) -> NodeId {
        let node = self.any();
        let of = self.b.format(node).bits();
        let bits = 1 + self.random.below(bits.min(of) as usize) as u32;
        let lo = self.random.below((of - bits + 1) as usize) as u32;
        let slice = self.b.slice(node, lo, bits);
        self.push(slice)
    }

    fn exactly(&mut self, bits: u32) -> NodeId {
        let integer = self.integer(bits);
        let format = Format::integer(bits).unwrap();
        if self.b.format(integer) == format { integer } else { self.narrow_to(integer, format) }
    }

    /// Operands of an operation, narrowed until the result is a word.
    fn arithmetic(&mut self, op: Op, mut operands: Vec<NodeId>) -> Vec<NodeId> {
        loop {
            let formats: Vec<Format> = operands.iter().map(|id| self.b.format(*id)).collect();
            match op.result_format(&formats, None, &[]) {
                Ok(format) if format.bits() <= self.max_bits => return operands,
                Ok(_) | Err(_) => {
                    // Never narrow the flag in front.
                    let first = usize::from(op.arity() == 3);
                    for operand in &mut operands[first..] {
                        let bits = (self.max_bits / 3).max(2);
                        let bits = 1 + self.random.below(bits as usize / 2) as u32;
                        let frac = self.random.within(-1, i64::from(bits / 2)) as i32;
                        let signed = self.random.chance(50);
                        let format = Format::new(signed, bits, frac).unwrap();
                        *operand = self.narrow_to(*operand, format);
                    }
                }
            }
        }
    }

    fn table(&mut self) -> usize {
        if self.tables.len() < 3 && self.random.chance(60) || self.tables.is_empty() {
            let addr_bits = 1 + self.random.below(6) as u32;
            let columns = (0..=self.random.below(2))
                .map(|i| {
                    let format = self.format();
                    let words: Vec<i64> =
                        (0..1 << addr_bits).map(|_| self.random.word(format)).collect();
                    Column { name: format!("c{i}"), format, words: Arc::from(words) }
                })
                .collect();
            let name = format!("t{}", self.tables.len());
            let mut table = Table { name, addr_bits, columns, memory: None };
            if self.machine && self.random.chance(60) {
                let words = table.columns.iter().map(|column| Arc::clone(&column.words)).collect();
                self.memories.push((table.name.clone(), words));
                let columns: Vec<(&str, Format)> =
                    table.columns.iter().map(|c| (&c.name[..], c.format)).collect();
                let latency = 1 + self.random.below(4) as u32;
                table = Table::memory(&table.name, addr_bits, &columns, latency);
            }
            let id = self.b.table(table.clone());
            self.tables.push((id, table));
        }
        self.random.below(self.tables.len())
    }

    /// An operation of any kind.
    fn operation(&mut self) {
        let op = self.random.pick(Op::ALL);
        let node = match op {
            Op::Const { .. } => {
                let format = self.format();
                let raw = self.random.word(format);
                self.b.constant(raw, format)
            }
            Op::Add | Op::Sub | Op::Mul | Op::Equal | Op::Less | Op::AddSub | Op::Mux => {
                let mut operands = if op.arity() == 3 { vec![self.flag()] } else { Vec::new() };
                operands.extend([self.any(), self.any()]);
                let of = self.arithmetic(op, operands);
                self.b.operation(op, &of, Format::FLAG)
            }
            Op::Neg => {
                let operand = self.any();
                let of = self.arithmetic(op, vec![operand]);
                self.b.neg(of[0])
            }
            Op::Abs => {
                let operand = self.any();
                self.b.abs(operand)
            }
            Op::And | Op::Or | Op::Xor => {
                let (a, b) = (self.any(), self.any());
                let format = self.b.format(a);
                let b = if self.b.format(b) == format { b } else { self.narrow_to(b, format) };
                self.b.operation(op, &[a, b], format)
            }
            Op::Slice { .. } => {
                let width = self.max_bits;
                self.integer(width)
            }
            Op::Concat => {
                let half = self.max_bits / 2;
                let (high, low) = (self.integer(half), self.integer(half));
                self.b.concat(high, low)
            }
            Op::Shift { .. } => {
                let node = self.any();
                let frac = self.b.format(node).frac_bits();
                let left = self.random.within(-6, 6) as i32;
                if (-127..=127).contains(&(frac - left)) { self.b.shift(node, left) } else { node }
            }
            Op::LeadingZeros => {
                let node = self.any();
                let node = if self.b.format(node).is_signed() { self.b.abs(node) } else { node };
                self.push(node);
                self.b.leading_zeros(node)
            }
            Op::ShiftLeft { .. } => {
                let (node, count) = (self.any(), self.integer(7));
                let room = self.max_bits.saturating_sub(self.b.format(node).bits());
                let max = self.random.below(room as usize + 1) as u32;
                self.b.shift_left(node, count, max)
            }
            Op::Read { .. } => {
                let index = self.table();
                let (id, table) = self.tables[index].clone();
                let address = self.exactly(table.addr_bits);
                let column = self.random.below(table.columns.len());
                self.b.read(id, column, address)
            }
            Op::Modulo => {
                let node = self.any();
                let to = self.format();
                let frac = self.b.format(node).frac_bits();
                self.b.modulo(node, Format::new(to.is_signed(), to.bits(), frac).unwrap())
            }
            Op::Delay { .. } if self.machine => {
                let (node, samples) = (self.any(), self.random.pick(&[1, 1, 2, 3, 40]));
                self.b.delay(node, samples)
            }
            // Ports are added elsewhere; a narrow is built in their place.
            Op::Narrow { .. } | Op::Input | Op::Delay { .. } => {
                let (node, format) = (self.any(), self.format());
                self.narrow_to(node, format)
            }
        };
        self.push(node);
        self.meaning(node);
    }

    /// Sometimes gives a node another meaning on reals. Only live nodes may be named: the node's
    /// operands and ports are live.
    fn meaning(&mut self, node: NodeId) {
        if self.random.chance(80) {
            return;
        }
        // A new node on `of` carries the meaning, so that the named node is its operand.
        let of = self.any();
        if of > node {
            return;
        }
        let to = self.format();
        let (round, overflow) = (self.random.pick(Round::ALL), self.random.pick(Overflow::ALL));
        let stand_in = self.b.narrow(of, to, round, overflow);
        if stand_in <= node {
            return;
        }
        let port = self.random.pick(&self.ports);
        let expr = self.expression(4);
        self.b.means(stand_in, [of, port], |_| expr);
        self.push(stand_in);
    }

    /// A random expression of two variables and numbers, with a maximum depth.
    fn expression(&mut self, depth: usize) -> Expr {
        if depth == 0 || self.random.chance(20) {
            return match self.random.below(4) {
                0 => Expr::variable(0),
                1 => Expr::variable(1),
                2 => Function::sin().of(&Expr::variable(0)),
                _ => Expr::constant(self.random.pick(&[0.0, 0.5, -0.25, 1.0, 2.0, 3.7])),
            };
        }
        let primitive = self.random.pick(&Primitive::ALL);
        let of: Vec<Expr> = (0..primitive.arity()).map(|_| self.expression(depth - 1)).collect();
        match of.as_slice() {
            [a] => Expr::of(primitive, [a]),
            [a, b] => Expr::of(primitive, [a, b]),
            [a, b, c] => Expr::of(primitive, [a, b, c]),
            _ => unreachable!("one to three operands"),
        }
    }
}

/// Columns of random and extreme words for a netlist's ports.
pub(crate) fn random_words(netlist: &Netlist, seed: u64, count: usize) -> Vec<Vec<i64>> {
    let mut random = Random::new(seed ^ 0x5eed);
    netlist
        .inputs()
        .iter()
        .map(|id| (0..count).map(|_| random.word(netlist.node(*id).format)).collect())
        .collect()
}

fn views<T>(columns: &[Vec<T>]) -> Vec<&[T]> {
    columns.iter().map(Vec::as_slice).collect()
}

/// Cuts columns to a range of samples.
fn part<T: Copy>(columns: &[Vec<T>], range: std::ops::Range<usize>) -> Vec<Vec<T>> {
    columns.iter().map(|column| column[range.clone()].to_vec()).collect()
}

/// Reports the first sample at which a column differs from the reference.
fn compare<T: std::fmt::Debug>(
    netlist: &Netlist,
    id: NodeId,
    is: &[T],
    should: &[T],
    equal: impl Fn(&T, &T) -> bool,
) -> Result<(), String> {
    let label = netlist.label(id);
    if is.len() != should.len() {
        return Err(format!("{label}: {} words and not {}", is.len(), should.len()));
    }
    match is.iter().zip(should).position(|(is, should)| !equal(is, should)) {
        None => Ok(()),
        Some(i) => Err(format!(
            "{label} is {:?} and not {:?} at sample {i} of {}\n{}",
            is[i],
            should[i],
            is.len(),
            netlist.to_text()
        )),
    }
}

/// Runs samples through both engines, with all nodes and with the ports as outputs.
pub(crate) fn check(netlist: &Netlist, seed: u64, count: usize) -> Result<(), String> {
    let columns = random_words(netlist, seed, count);
    let all: Vec<NodeId> = netlist.ids().collect();
    let ports: Vec<NodeId> = netlist.outputs().iter().map(|output| output.node).collect();
    let mut expected = vec![Vec::with_capacity(count); all.len()];
    let mut flags = vec![0u64; all.len()];
    let mut state = State::new(netlist);
    for sample in 0..count {
        let inputs: Vec<i64> = columns.iter().map(|column| column[sample]).collect();
        let (words, overflowed) = netlist.eval_next(&mut state, &inputs).unwrap();
        for (column, word) in expected.iter_mut().zip(words) {
            column.push(word);
        }
        for (count, overflowed) in flags.iter_mut().zip(overflowed) {
            *count += u64::from(overflowed);
        }
    }
    let narrows: Vec<NodeId> = all
        .iter()
        .copied()
        .filter(|id| matches!(netlist.node(*id).op, Op::Narrow { .. }))
        .collect();
    let counts: Vec<u64> = narrows.iter().map(|id| flags[id.index()]).collect();
    for outputs in [&all, &ports] {
        let program = Program::compile(netlist, outputs);
        for features in Features::here() {
            let mut runner = program.runner_for(*features);
            let mut given = vec![Vec::new(); outputs.len()];
            runner.run(&program, &views(&columns), &mut given).unwrap();
            for (id, column) in outputs.iter().zip(&given) {
                let should = &expected[id.index()];
                compare(netlist, *id, column, should, |is, should| is == should)
                    .map_err(|text| format!("{features:?}: {text}"))?;
            }
            if runner.overflows() != counts {
                return Err(format!("{features:?}: overflows {:?}", runner.overflows()));
            }
        }
        // In two parts with one runner: nothing of the first part may remain except counts and the
        // contents of delays.
        let mut runner = program.runner();
        let mut given = vec![vec![77; 3]; outputs.len()];
        for range in [0..count / 2, count / 2..count] {
            runner.run(&program, &views(&part(&columns, range.clone())), &mut given).unwrap();
            for (id, column) in outputs.iter().zip(&given) {
                let should = &expected[id.index()][range.clone()];
                compare(netlist, *id, column, should, |is, should| is == should)?;
            }
        }
        let halves = runner.overflows().to_vec();
        runner.reset(&program);
        let start = part(&columns, 0..count / 3);
        runner.run(&program, &views(&start), &mut given).unwrap();
        for (id, column) in outputs.iter().zip(&given) {
            let should = &expected[id.index()][..count / 3];
            compare(netlist, *id, column, should, |is, should| is == should)
                .map_err(|text| format!("after a reset: {text}"))?;
        }
        let mut runner = program.runner();
        runner.run(&program, &views(&columns), &mut given).unwrap();
        for (id, column) in outputs.iter().zip(&given) {
            compare(netlist, *id, column, &expected[id.index()], |is, should| is == should)?;
        }
        if program.narrows() != narrows || runner.overflows() != counts || halves != counts {
            return Err(format!(
                "overflows of {narrows:?} are {:?}, {halves:?} in two parts and not {counts:?}\n{}",
                runner.overflows(),
                netlist.to_text()
            ));
        }
        check_refusal(netlist, &narrows, &counts, runner.check(&program, netlist))?;
    }
    check_reals(netlist, &columns, &all, &ports)
}

/// The error must name the first `narrow` with a forbidden overflow.
fn check_refusal(
    netlist: &Netlist,
    narrows: &[NodeId],
    counts: &[u64],
    given: fixpath::error::Result<()>,
) -> Result<(), String> {
    let forbidden = narrows.iter().zip(counts).find(|(id, count)| {
        let op = netlist.node(**id).op;
        matches!(op, Op::Narrow { overflow: Overflow::Error, .. }) && **count > 0
    });
    match (forbidden, given) {
        (None, Ok(())) => Ok(()),
        (Some((id, count)), Err(error)) => {
            let start = format!("node `{}` overflowed {count} times", netlist.label(*id));
            let right = error.to_string().starts_with(&start) && error.is_failed_check();
            if right { Ok(()) } else { Err(format!("`{error}` for `{start}`")) }
        }
        (forbidden, given) => Err(format!("{given:?} for {forbidden:?}")),
    }
}

fn check_reals(
    netlist: &Netlist,
    words: &[Vec<i64>],
    all: &[NodeId],
    ports: &[NodeId],
) -> Result<(), String> {
    let columns: Vec<Vec<f64>> = netlist
        .inputs()
        .iter()
        .zip(words)
        .map(|(id, column)| {
            let format = netlist.node(*id).format;
            column.iter().map(|raw| format.value(*raw)).collect()
        })
        .collect();
    let count = words.first().map_or(0, Vec::len);
    let mut expected = vec![Vec::with_capacity(count); all.len()];
    for i in 0..count {
        let inputs: Vec<f64> = columns.iter().map(|column| column[i]).collect();
        for (column, value) in expected.iter_mut().zip(netlist.eval_reals(&inputs)) {
            column.push(value);
        }
    }
    let real = |ids: &[NodeId]| -> Vec<NodeId> {
        ids.iter().copied().filter(|id| netlist.node(*id).real.is_some()).collect()
    };
    for outputs in [real(all), real(ports)] {
        let program = real::Program::compile(netlist, &outputs).unwrap();
        let mut runner = program.runner();
        let mut given = vec![Vec::new(); outputs.len()];
        runner.run(&program, &views(&part(&columns, 0..count / 3)), &mut given);
        runner.run(&program, &views(&columns), &mut given);
        for (id, column) in outputs.iter().zip(&given) {
            // NaNs are all equal; everything else is equal to the last bit.
            compare(netlist, *id, column, &expected[id.index()], |a, b| {
                a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
            })?;
        }
    }
    Ok(())
}

#[test]
fn engines_agree_with_the_reference_on_memories_and_delays() {
    for seed in 0..200 {
        check(&random_machine(seed), seed, 2 * BLOCK + 300).unwrap();
    }
}

#[test]
fn engines_agree_with_the_reference_on_random_netlists() {
    let config = Config { cases: 400, failure_persistence: None, ..Config::default() };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let mut runner = TestRunner::new_with_rng(config, rng);
    let cases = (proptest::num::u64::ANY, 1usize..70);
    runner
        .run(&cases, |(seed, operations)| {
            let netlist = random_netlist_of(seed, operations);
            check(&netlist, seed, 4 * BLOCK + 300).map_err(TestCaseError::fail)
        })
        .unwrap();
}

/// Ports whose words repeat from block to block: values that depend only on them are computed once,
/// and are equal to the last bit and overflow.
#[test]
fn what_repeats_is_computed_once() {
    for seed in 0..150 {
        check_repeats(&random_netlist(seed), seed);
    }
    for seed in 0..60 {
        check_repeats(&random_machine(seed), seed);
    }
}

fn check_repeats(netlist: &Netlist, seed: u64) {
    let mut random = Random::new(seed);
    let mut columns = random_words(netlist, seed, 4 * BLOCK);
    let repeats: Vec<bool> = columns.iter().map(|_| random.chance(60)).collect();
    for column in columns.iter_mut().zip(&repeats).filter(|(_, r)| **r).map(|(c, _)| c) {
        for i in BLOCK..column.len() {
            column[i] = column[i - BLOCK];
        }
    }
    let outputs: Vec<NodeId> = netlist.outputs().iter().map(|output| output.node).collect();
    let plain = Program::compile(netlist, &outputs);
    let mut runner = plain.runner();
    let mut should = vec![Vec::new(); outputs.len()];
    runner.run(&plain, &views(&columns), &mut should).unwrap();
    // Only values that the outputs depend on are computed and counted.
    let mut inside = vec![false; netlist.nodes().len()];
    outputs.iter().for_each(|id| inside[id.index()] = true);
    for id in netlist.ids().collect::<Vec<_>>().into_iter().rev() {
        if inside[id.index()] {
            netlist.node(id).operands.iter().for_each(|o| inside[o.index()] = true);
        }
    }
    let counts = plain.narrows().iter().zip(runner.overflows());
    let counted = counts.map(|(id, count)| if inside[id.index()] { *count } else { 0 });
    let overflows: Vec<u64> = counted.collect();
    // Only their first block may be read.
    for column in columns.iter_mut().zip(&repeats).filter(|(_, r)| **r).map(|(c, _)| c) {
        column[BLOCK..].fill(0);
    }
    let once = Program::compile_cone(netlist, &outputs, &repeats);
    let mut runner = once.runner();
    for _ in 0..2 {
        let mut given = vec![Vec::new(); outputs.len()];
        let before = runner.overflows().to_vec();
        runner.reset(&once);
        runner.run(&once, &views(&columns), &mut given).unwrap();
        assert_eq!(given, should, "{repeats:?}\n{}", netlist.to_text());
        let counted: Vec<u64> =
            runner.overflows().iter().zip(before).map(|(now, before)| now - before).collect();
        assert_eq!(counted, overflows, "{repeats:?}\n{}", netlist.to_text());
    }

    let real: Vec<NodeId> =
        netlist.ids().filter(|id| netlist.node(*id).real.is_some()).step_by(3).collect();
    let values = |repeated: bool| -> Vec<Vec<f64>> {
        let column = |(port, words): (&NodeId, &Vec<i64>)| {
            let format = netlist.node(*port).format;
            words.iter().map(|raw| format.value(*raw)).collect::<Vec<f64>>()
        };
        let mut values: Vec<Vec<f64>> = netlist.inputs().iter().zip(&columns).map(column).collect();
        for (column, _) in values.iter_mut().zip(&repeats).filter(|(_, r)| **r && repeated) {
            for i in BLOCK..column.len() {
                column[i] = column[i - BLOCK];
            }
        }
        values
    };
    let run = |program: &real::Program, values: &[Vec<f64>]| -> Vec<Vec<u64>> {
        let mut given = vec![Vec::new(); real.len()];
        program.runner().run(program, &views(values), &mut given);
        given.iter().map(|c| c.iter().map(|x| x.to_bits()).collect()).collect()
    };
    let plain = run(&real::Program::compile(netlist, &real).unwrap(), &values(true));
    let once = real::Program::compile_repeated(netlist, &real, &repeats).unwrap();
    assert_eq!(run(&once, &values(false)), plain, "{repeats:?}\n{}", netlist.to_text());
}

/// If the generator stopped producing an operation, the tests above would check less than they
/// claim.
#[test]
fn random_netlists_have_every_operation_and_width() {
    let mut seen = std::collections::BTreeMap::new();
    let mut modes = std::collections::BTreeSet::new();
    let mut widths = std::collections::BTreeSet::new();
    let mut late_inputs = 0;
    for netlist in (0..300).map(random_netlist).chain((0..300).map(random_machine)) {
        for (i, node) in netlist.nodes().iter().enumerate() {
            *seen.entry(node.op.name()).or_insert(0) += 1;
            widths.insert(node.format.bits());
            if let Op::Narrow { round, overflow } = node.op {
                modes.insert((round, overflow));
            }
            late_inputs += u32::from(node.op == Op::Input && i > 8);
        }
    }
    for op in Op::ALL {
        let count = seen.get(op.name()).copied().unwrap_or(0);
        assert!(count >= 30, "only {count} of {}", op.name());
    }
    assert_eq!(seen.len(), Op::ALL.len());
    assert_eq!(modes.len(), Round::ALL.len() * Overflow::ALL.len());
    assert!(widths.len() > 55, "only widths {widths:?}");
    assert!(late_inputs > 30, "only {late_inputs} late inputs");
}

#[test]
fn blocks_of_every_length() {
    for count in [0, 1, 2, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK, 2 * BLOCK + 1] {
        for seed in 0..20 {
            check(&random_netlist(seed), seed, count).unwrap();
        }
    }
}

/// A sine and a cosine of one angle are one step on reals: in either order, twice, nested, as
/// outputs, with repeating angles, and in the units.
#[test]
fn sines_beside_cosines() {
    let angle = Format::signed(16, 16).unwrap();
    for order in 0..4 {
        let mut b = Builder::new("angles");
        let (x, y) = (b.input("x", angle, Quantity::Turns), b.input("y", angle, Quantity::Turns));
        let mut frac = 4;
        let mut apply = |b: &mut Builder, function: &Function, of| {
            // Each has its own format, since equal nodes are built once.
            frac += 1;
            let to = Format::signed(20, frac).unwrap();
            let stand_in = b.narrow(of, to, Round::HalfUp, Overflow::Wrap);
            b.means(stand_in, [of], |[x]| function.of(&x))
        };
        let (sin, cos) = (&Function::sin(), &Function::cos());
        let [first, second] = if order & 1 == 0 { [sin, cos] } else { [cos, sin] };
        let mut ends = Vec::new();
        for of in if order & 2 == 0 { [x, y] } else { [y, x] } {
            let a = apply(&mut b, first, of);
            let between = apply(&mut b, cos, a);
            let c = apply(&mut b, second, of);
            let again = apply(&mut b, first, of);
            let inside = apply(&mut b, sin, a);
            let sum = b.add(between, c);
            let sum = b.add(sum, inside);
            ends.extend([a, sum, again]);
        }
        for (i, end) in ends.iter().enumerate() {
            b.output(&format!("out{i}"), *end);
        }
        let netlist = b.build().unwrap();
        check(&netlist, order, 2 * BLOCK + 100).unwrap();
        check_repeats(&netlist, order);
    }
    for unit in UNITS.iter() {
        let design = unit.values::<&str>(&[]).unwrap().build().unwrap();
        check(&design.netlist, 1, 400).unwrap_or_else(|text| panic!("{}: {text}", unit.name));
    }
    for variant in ["exact", "corrected"] {
        let unit = Unit::find("rotation").unwrap();
        let design = unit.values(&[format!("variant={variant}")]).unwrap().build().unwrap();
        check(&design.netlist, 1, 400).unwrap();
        check_repeats(&design.netlist, 2);
    }
}

/// Sums read by only one sum are computed in its pass: every sign at every place, of words with and
/// without shifts, in all lanes, alone and with narrows.
#[test]
fn sums_of_sums() {
    for (seed, bits) in
        [8u32, 14, 16, 24, 29, 40, 55].into_iter().flat_map(|bits| [(1, bits), (2, bits)])
    {
        for fracs in [[0, 0, 0, 0], [0, 1, 0, 2], [3, 0, 2, 0], [0, 0, 0, 3]] {
            for signs in 0..8 {
                for shape in 0..3 {
                    let mut b = Builder::new("sums");
                    let mut port = |name: &str, frac: i32| {
                        let format = Format::signed(bits, frac).unwrap();
                        b.input(name, format, Quantity::Number)
                    };
                    let [x, y, z, w] =
                        [0, 1, 2, 3].map(|i| port(["x", "y", "z", "w"][i], fracs[i]));
                    let sum = |b: &mut Builder, sign: i32, p: NodeId, q: NodeId| {
                        if signs >> sign & 1 == 1 { b.sub(p, q) } else { b.add(p, q) }
                    };
                    let inner = sum(&mut b, 0, x, y);
                    let outer = match shape {
                        0 => sum(&mut b, 1, inner, z),
                        1 => sum(&mut b, 1, z, inner),
                        _ => {
                            let other = sum(&mut b, 2, z, w);
                            sum(&mut b, 1, other, inner)
                        }
                    };
                    let to = Format::signed(bits - 1, -1).unwrap();
                    let narrowed = b.narrow(outer, to, Round::HalfUp, Overflow::Saturate);
                    b.output("out", if seed % 2 == 1 { outer } else { narrowed });
                    let netlist = b.build().unwrap();
                    check(&netlist, seed, 300).unwrap();
                }
            }
        }
    }
}

/// A port that is built after nodes whose columns are free again keeps its words.
#[test]
fn late_ports_keep_their_words() {
    let format = Format::signed(8, 0).unwrap();
    let mut b = Builder::new("late");
    let a = b.input("a", format, Quantity::Number);
    let minus = b.neg(a);
    let size = b.abs(minus);
    let late = b.input("late", format, Quantity::Number);
    let sum = b.add(size, late);
    b.output("sum", sum);
    let netlist = b.build().unwrap();
    check(&netlist, 1, 700).unwrap();
}

/// Words at the edge of 32-bit lanes, where alignment needs more bits than the result.
#[test]
fn comparisons_that_need_wider_lanes_than_their_words() {
    for (bits, frac) in [(16, 15), (16, 16), (15, 17), (32, 0), (31, 0), (31, 1)] {
        for signed in [false, true] {
            let narrow = Format::new(signed, bits.min(31), 0).unwrap();
            let fine = Format::new(true, 4, frac).unwrap();
            let mut b = Builder::new("lanes");
            let a = b.input("a", narrow, Quantity::Number);
            let c = b.input("c", fine, Quantity::Number);
            let outputs = [b.less(a, c), b.less(c, a), b.equal(a, c)];
            for (i, node) in outputs.into_iter().enumerate() {
                b.output(&format!("out{i}"), node);
            }
            check(&b.build().unwrap(), 5, 900).unwrap();
        }
    }
}

/// Every pair of formats near the lanes' limits, in every mode, through a single `narrow`.
#[test]
fn narrow_columns_agree_with_narrow() {
    let bits = [1u32, 2, 8, 30, 31, 32, 33, 62, 63];
    let mut random = Random::new(11);
    for from_bits in bits {
        for to_bits in bits {
            for shift in [-70i32, -33, -31, -2, 0, 1, 2, 8, 29, 30, 31, 32, 33, 61, 62, 63, 70] {
                let signed = [random.chance(50), random.chance(50)];
                let from = Format::new(signed[0], from_bits, shift).unwrap();
                let to = Format::new(signed[1], to_bits, 0).unwrap();
                let mut b = Builder::new("narrow");
                let a = b.input("a", from, Quantity::Number);
                for (i, round) in Round::ALL.iter().enumerate() {
                    for (j, overflow) in Overflow::ALL.iter().enumerate() {
                        let narrowed = b.narrow(a, to, *round, *overflow);
                        b.output(&format!("out{i}{j}"), narrowed);
                    }
                }
                check(&b.build().unwrap(), u64::from(from_bits * to_bits), 60).unwrap();
            }
        }
    }
}
