//! Estimates the cost of a module without tools.
//!
//! As in a synthesiser, the module is taken apart into single bits: wires are followed through
//! slices, shifts and extensions, equal bits are built once, and bits that no output needs are not
//! built. The rest is counted by the rules below; [`DEVIATIONS`] lists how far that is from Yosys.
//!
//! | part | LUTs on iCE40 | on ECP5 | on Xilinx |
//! |---|---|---|---|
//! | sum, comparison, rounding | 1 a bit that is used | 1 a bit (`CCU2C` has 2) | 1 a bit |
//! | difference, negation | 1 more for each bit to invert | as a sum | as a sum |
//! | other logic: 1 for up to this many inputs | 4 | 4 | 6 |
//! | barrel shifter | 1 a bit and level | 1 a bit and level | 1 a bit and two levels |
//! | table without a clock | [`Rules::rom_share`] of a tree of LUTs | the same | the same |
//! | product | adders for its partial products | the same | the same |
//! | delays of three cycles and more | - | - | 1 (`SRL16E`) |
//!
//! Logic with a single use is merged into its user's LUT as long as the inputs suffice. Flip-flops
//! are the bits of all registers, except those of rows of block RAM and those that DSPs absorb.

use super::{Cost, Target};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::hardware::hdl::{
    Bit, Expr, Item, Module, Next, Operand, Options, Register, RomTable, Tables, View, WordId,
};
use crate::hardware::rtl::Rtl;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Estimates the cost of hardware on a target.
///
/// # Errors
/// As [`of_module`], or if the module would be too large.
pub fn estimate(rtl: &Arc<Rtl>, target: Target) -> Result<Cost> {
    of_module(&Module::new(rtl, &Options::default())?, target)
}

/// Estimates the cost of a module on a target.
///
/// # Errors
/// If it is time-shared or has delays: the rules cover neither registers with an enable nor loops
/// through registers.
pub fn of_module(module: &Module, target: Target) -> Result<Cost> {
    if module.has_state {
        let text = "registers of delays can't be estimated: use `fixpath cost`, which runs Yosys";
        return Err(Error::usage(text.to_owned()));
    }
    if module.stages.iter().any(|stage| !stage.declared.is_empty()) {
        let text = "time-shared hardware can't be estimated: use `fixpath cost`, which runs Yosys";
        return Err(Error::usage(text.to_owned()));
    }
    let graph = Graph::new(module);
    Ok(Count::new(&graph, module, target.rules()).cost())
}

/// A constant or a wire.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Net {
    Zero,
    One,
    Wire(usize),
}

/// What drives a wire.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Source {
    Input,
    /// A function of some bits.
    Gate(Vec<Net>, Function),
    /// A bit of a part.
    Part(usize),
    Flop(Net),
    /// A flip-flop with an enable.
    Held(Net),
}

/// The function of a gate, which distinguishes gates on the same bits.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Function {
    Invert,
    Xor,
    And,
    Or,
    /// Flag, value if set, value if clear.
    Choose,
    /// A flag, by the index of its word.
    Flag(usize),
}

/// A part that isn't a gate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    Sum,
    Difference,
    Compare,
    Product { a_bits: u32, b_bits: u32, signed: bool },
    Shift { levels: u32 },
    Read { table: usize, clocked: bool },
}

#[derive(Debug)]
struct Part {
    kind: Kind,
    /// Operands, least significant bit first.
    a: Vec<Net>,
    b: Vec<Net>,
    carry: Option<Net>,
    /// Wires of the result.
    out: Vec<usize>,
}

impl Part {
    /// True if a sum's bit needs more than the carry: not where one operand is zero.
    fn is_free(&self, at: usize) -> bool {
        self.kind != Kind::Sum || self.a[at] != Net::Zero && self.b[at] != Net::Zero
    }
}

/// A module as bits.
#[derive(Debug, Default)]
struct Graph {
    sources: Vec<Source>,
    known: BTreeMap<Source, usize>,
    parts: Vec<Part>,
    /// Bits of each word, once it is driven.
    words: Vec<Vec<Net>>,
    outputs: Vec<Net>,
    valid_bits: u64,
}

/// A row's bits; those that are the same in all rows become constants.
fn constant_bits(table: &RomTable, mut row: Vec<Net>) -> Vec<Net> {
    let mut at = 0;
    for column in table.columns.iter().rev() {
        let patterns = || column.words.iter().map(|word| column.format.pattern(*word));
        let (ones, any) = patterns().fold((u64::MAX, 0), |(all, any), p| (all & p, any | p));
        for bit in 0..column.format.bits() {
            if ones >> bit & 1 == 1 {
                row[at] = Net::One;
            } else if any >> bit & 1 == 0 {
                row[at] = Net::Zero;
            }
            at += 1;
        }
    }
    row
}

fn index(bits: u32) -> usize {
    usize::try_from(bits).expect("bug: 32 bits fit")
}

impl Graph {
    fn new(module: &Module) -> Self {
        let mut graph = Self { words: vec![Vec::new(); module.words.len()], ..Self::default() };
        let valid = module.stages.iter().map(|stage| stage.valid.len());
        graph.valid_bits = cast::count_of(valid.sum());
        let outside = module.memories.iter();
        let fetched = outside.clone().flat_map(|memory| &memory.reads).flat_map(|(.., data)| data);
        let written = outside.filter_map(|memory| memory.write.as_ref());
        let written = written
            .flat_map(|write| [&write.enable, &write.address].into_iter().chain(&write.data));
        for id in module.inputs.iter().chain(fetched).chain(written) {
            let bits = module.word(*id).bits;
            graph.words[id.index()] =
                (0..bits).map(|_| Net::Wire(graph.wire(Source::Input))).collect();
        }
        for stage in &module.stages {
            for item in &stage.items {
                if let Item::Assign(id, expr) = item {
                    graph.words[id.index()] = graph.expr(module, *id, expr);
                }
            }
            for Register { word: id, next, valid, .. } in &stage.registers {
                graph.words[id.index()] = match next {
                    // It keeps its word, so no chain of registers runs through it.
                    Next::Word(from) if valid.is_some() => {
                        let from = graph.words[from.index()].clone();
                        from.into_iter().map(|net| graph.held(net)).collect()
                    }
                    Next::Word(from) => {
                        let from = graph.words[from.index()].clone();
                        from.into_iter().map(|net| graph.flop(net)).collect()
                    }
                    Next::Read(table, address) => {
                        let address = graph.words[address.index()].clone();
                        let bits = index(module.word(*id).bits);
                        let kind = Kind::Read { table: *table, clocked: true };
                        let row = graph.part(kind, address, Vec::new(), None, bits);
                        constant_bits(&module.tables[*table], row)
                    }
                };
            }
        }
        for (_, id) in module.driven() {
            graph.outputs.extend(graph.words[id.index()].clone());
        }
        graph
    }

    fn wire(&mut self, source: Source) -> usize {
        self.sources.push(source);
        self.sources.len() - 1
    }

    /// The wire of a source, which may exist already.
    fn shared(&mut self, source: Source) -> Net {
        if let Some(wire) = self.known.get(&source) {
            return Net::Wire(*wire);
        }
        let wire = self.wire(source.clone());
        self.known.insert(source, wire);
        Net::Wire(wire)
    }

    fn flop(&mut self, net: Net) -> Net {
        match net {
            Net::Zero | Net::One => net,
            Net::Wire(_) => self.shared(Source::Flop(net)),
        }
    }

    fn held(&mut self, net: Net) -> Net {
        match net {
            Net::Zero | Net::One => net,
            Net::Wire(_) => Net::Wire(self.wire(Source::Held(net))),
        }
    }

    fn part(
        &mut self,
        kind: Kind,
        a: Vec<Net>,
        b: Vec<Net>,
        carry: Option<Net>,
        bits: usize,
    ) -> Vec<Net> {
        let number = self.parts.len();
        let out: Vec<usize> = (0..bits).map(|_| self.wire(Source::Part(number))).collect();
        let nets = out.iter().map(|wire| Net::Wire(*wire)).collect();
        self.parts.push(Part { kind, a, b, carry, out });
        nets
    }

    fn invert(&mut self, net: Net) -> Net {
        match net {
            Net::Zero => Net::One,
            Net::One => Net::Zero,
            Net::Wire(_) => self.shared(Source::Gate(vec![net], Function::Invert)),
        }
    }

    fn choose(&mut self, flag: Net, a: Net, b: Net) -> Net {
        match (flag, a, b) {
            (Net::One, a, _) => a,
            (Net::Zero, _, b) => b,
            (_, a, b) if a == b => a,
            (flag, Net::One, Net::Zero) => flag,
            (flag, Net::Zero, Net::One) => self.invert(flag),
            (flag, a, b) => self.shared(Source::Gate(vec![flag, a, b], Function::Choose)),
        }
    }

    fn xor(&mut self, a: Net, b: Net) -> Net {
        match (a.min(b), a.max(b)) {
            (Net::Zero, net) => net,
            (Net::One, net) => self.invert(net),
            (a, b) if a == b => Net::Zero,
            (a, b) => self.shared(Source::Gate(vec![a, b], Function::Xor)),
        }
    }

    fn bitwise(&mut self, and: bool, a: Net, b: Net) -> Net {
        let (neutral, strong) = if and { (Net::One, Net::Zero) } else { (Net::Zero, Net::One) };
        if a == b || b == neutral {
            a
        } else if a == neutral {
            b
        } else if a == strong || b == strong {
            strong
        } else {
            let function = if and { Function::And } else { Function::Or };
            self.shared(Source::Gate(vec![a.min(b), a.max(b)], function))
        }
    }

    fn view(&self, module: &Module, view: View) -> Vec<Net> {
        let View { word, lo, zeros, bits } = view;
        let nets = &self.words[word.index()];
        let top = if module.word(word).signed { nets[nets.len() - 1] } else { Net::Zero };
        (0..bits)
            .map(|bit| match bit.checked_sub(zeros) {
                None => Net::Zero,
                Some(bit) => nets.get(index(bit + lo)).copied().unwrap_or(top),
            })
            .collect()
    }

    fn operand(&self, module: &Module, operand: Operand) -> Vec<Net> {
        match operand {
            Operand::View(view) => self.view(module, view),
            Operand::Literal { pattern, bits } => (0..bits)
                .map(|bit| if pattern >> bit & 1 == 1 { Net::One } else { Net::Zero })
                .collect(),
        }
    }

    fn bit(&self, bit: Bit) -> Net {
        self.words[bit.word.index()][index(bit.bit)]
    }

    /// A sum or difference. Without a carry in, low bits where b is zero are copies of a; in a sum,
    /// those where a is zero are copies of b.
    fn sum(&mut self, kind: Kind, a: Vec<Net>, b: Vec<Net>, carry: Option<Net>) -> Vec<Net> {
        let bits = a.len();
        let none = carry.is_none();
        let plain = |at: &usize| {
            none && (b[*at] == Net::Zero || (kind == Kind::Sum && a[*at] == Net::Zero))
        };
        let low = (0..bits).take_while(plain).count();
        let mut nets: Vec<Net> =
            (0..low).map(|at| if b[at] == Net::Zero { a[at] } else { b[at] }).collect();
        if low < bits {
            nets.extend(self.part(kind, a[low..].to_vec(), b[low..].to_vec(), carry, bits - low));
        }
        nets
    }

    fn flag(&mut self, of: WordId, mut bits: Vec<Net>) -> Vec<Net> {
        bits.sort_unstable();
        bits.dedup();
        vec![self.shared(Source::Gate(bits, Function::Flag(of.index())))]
    }

    fn expr(&mut self, module: &Module, id: WordId, expr: &Expr) -> Vec<Net> {
        let bits = index(module.word(id).bits);
        match expr {
            Expr::Copy(a) => self.operand(module, *a),
            Expr::Add(a, b) => {
                let (a, b) = (self.operand(module, *a), self.operand(module, *b));
                self.sum(Kind::Sum, a, b, None)
            }
            Expr::Sub(a, b) => {
                let (a, b) = (self.operand(module, *a), self.operand(module, *b));
                self.sum(Kind::Difference, a, b, None)
            }
            Expr::AddCarry(a, b, carry) => {
                let carry = self.bit(*carry);
                let (a, b) = (self.operand(module, *a), self.operand(module, *b));
                self.sum(Kind::Sum, a, b, Some(carry))
            }
            Expr::Negate(a) => {
                let a = self.operand(module, *a);
                self.sum(Kind::Difference, vec![Net::Zero; bits], a, None)
            }
            Expr::InvertIf(flag, a) => {
                let flag = self.bit(*flag);
                let a = self.operand(module, *a);
                a.into_iter().map(|net| self.xor(net, flag)).collect()
            }
            Expr::Bitwise(operator, a, b) => {
                let (a, b) = (self.words[a.index()].clone(), self.words[b.index()].clone());
                let pairs = a.into_iter().zip(b);
                pairs
                    .map(|(a, b)| match operator {
                        crate::hardware::hdl::Bitwise::And => self.bitwise(true, a, b),
                        crate::hardware::hdl::Bitwise::Or => self.bitwise(false, a, b),
                        crate::hardware::hdl::Bitwise::Xor => self.xor(a, b),
                    })
                    .collect()
            }
            Expr::Choose { cases, default } => {
                let mut nets = self.operand(module, *default);
                for (flag, operand) in cases.iter().rev() {
                    let flag = self.bit(*flag);
                    let chosen = self.operand(module, *operand);
                    let pairs = chosen.into_iter().zip(nets);
                    nets = pairs.map(|(a, b)| self.choose(flag, a, b)).collect();
                }
                nets
            }
            Expr::Concat(parts) => {
                parts.iter().rev().flat_map(|part| self.operand(module, *part)).collect()
            }
            Expr::Multiply(a, b) => {
                let (x, y) = (module.word(*a), module.word(*b));
                let signed = x.signed || y.signed;
                let wide = |word: &crate::hardware::hdl::Word| {
                    word.bits + u32::from(signed && !word.signed)
                };
                let (a, b) = (self.words[a.index()].clone(), self.words[b.index()].clone());
                let kind = Kind::Product { a_bits: wide(x), b_bits: wide(y), signed };
                self.part(kind, a, b, None, bits)
            }
            Expr::Equal(a, b) => {
                let (a, b) = (self.operand(module, *a), self.operand(module, *b));
                self.flag(id, [a, b].concat())
            }
            Expr::Less { a, b, .. } => {
                let (a, b) = (self.operand(module, *a), self.operand(module, *b));
                self.part(Kind::Compare, a, b, None, 1)
            }
            Expr::ShiftLeft(a, count) => {
                let a = self.operand(module, *a);
                let count = self.words[count.index()].clone();
                let kind =
                    Kind::Shift { levels: module.word(id).bits.min(cast::id_of(count.len())) };
                self.part(kind, a, count, None, bits)
            }
            Expr::Above { word, keep } | Expr::Below { word, keep } => {
                let nets = self.words[word.index()][index(*keep)..].to_vec();
                self.flag(id, nets)
            }
            Expr::Read(table, address) => {
                let address = self.words[address.index()].clone();
                let kind = Kind::Read { table: *table, clocked: false };
                let row = self.part(kind, address, Vec::new(), None, bits);
                constant_bits(&module.tables[*table], row)
            }
        }
    }
}

/// Which bits of a sum need a LUT.
#[derive(Clone, Copy, Debug)]
pub(super) enum Sum {
    /// The bits that are used.
    Used,
    /// All bits up to the highest used one, in pairs.
    Pairs,
    /// All bits up to the highest used one that have two operands: a single bit fits into the carry
    /// chain.
    Two,
}

/// Which sums of partial products a DSP absorbs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Adds {
    /// None.
    None,
    /// Sums along the longer factor.
    Rows,
    /// All.
    All,
}

/// The multipliers of a target.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dsp {
    /// Bits of the longer factor.
    pub long_bits: u32,
    /// Bits of the shorter factor.
    pub short_bits: u32,
    /// Bits of the pieces into which a longer factor is cut.
    pub part_bits: u32,
    /// True if factors are always signed.
    pub signed_only: bool,
    /// Smallest sum of both factors' bits for which a DSP is used.
    pub least_bits: u32,
    /// Number of consecutive registers that it absorbs in front of a factor.
    pub registers: u32,
    /// Which sums of partial products it absorbs.
    pub adds: Adds,
}

/// How a target builds parts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rules {
    /// Inputs of a LUT.
    pub inputs: usize,
    /// True if the source of a difference's inverted side needs LUTs of its own.
    pub inverters: bool,
    /// Which bits of a sum need a LUT.
    pub sum: Sum,
    /// Levels of a barrel shifter per LUT.
    pub shift_levels: u32,
    /// Fraction of a full tree of LUTs that a table needs: table words repeat.
    pub rom_share: f64,
    /// Shapes of a block RAM: log2 of the rows, and bits per row.
    pub ram: &'static [(u32, u32)],
    /// Read ports of a block RAM.
    pub ram_ports: usize,
    /// Further shapes for a RAM with a single read port.
    pub lone_ram: &'static [(u32, u32)],
    /// Its multipliers.
    pub dsp: Dsp,
    /// Least length in cycles of a delay that is built from LUTs; `None` if none is.
    pub shift_registers: Option<usize>,
}

struct Count<'a> {
    graph: &'a Graph,
    module: &'a Module,
    rules: Rules,
    live: Vec<bool>,
    /// Number of uses of each wire.
    uses: Vec<u32>,
}

impl<'a> Count<'a> {
    fn new(graph: &'a Graph, module: &'a Module, rules: Rules) -> Self {
        let count = graph.sources.len();
        let mut all = Self { graph, module, rules, live: vec![false; count], uses: vec![0; count] };
        for net in &graph.outputs {
            all.take(*net);
        }
        // Sources come before their users.
        let mut done = vec![false; graph.parts.len()];
        for wire in (0..count).rev() {
            if !all.live[wire] {
                continue;
            }
            match &graph.sources[wire] {
                Source::Input => {}
                Source::Gate(nets, _) => nets.iter().for_each(|net| all.take(*net)),
                Source::Flop(net) | Source::Held(net) => all.take(*net),
                // The highest live bit comes first and determines the operand bits that are needed.
                Source::Part(part) if !done[*part] => {
                    done[*part] = true;
                    all.take_part(&graph.parts[*part], wire);
                }
                Source::Part(_) => {}
            }
        }
        all
    }

    fn take(&mut self, net: Net) {
        if let Net::Wire(wire) = net {
            self.live[wire] = true;
            self.uses[wire] += 1;
        }
    }

    fn take_part(&mut self, part: &Part, highest: usize) {
        let bits = match part.kind {
            Kind::Sum | Kind::Difference | Kind::Product { .. } => highest - part.out[0] + 1,
            Kind::Compare | Kind::Shift { .. } | Kind::Read { .. } => usize::MAX,
        };
        for net in part.a.iter().take(bits).chain(part.b.iter().take(bits)).chain(&part.carry) {
            self.take(*net);
        }
    }

    fn is_live(&self, part: &Part) -> bool {
        part.out.iter().any(|wire| self.live[*wire])
    }

    fn cost(&self) -> Cost {
        let mut luts = self.gates();
        let mut dsps = 0;
        for part in self.graph.parts.iter().filter(|part| self.is_live(part)) {
            let (l, d) = self.part(part);
            luts += l;
            dsps += d;
        }
        let (flip_flops, delays) = self.flip_flops();
        Cost { luts: luts + delays, flip_flops, block_rams: self.block_rams(), dsps }
    }

    /// LUTs of gates: each gate absorbs the gates before it that have no other use, as far as the
    /// inputs suffice.
    fn gates(&self) -> u64 {
        let mut leaves: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
        let mut luts = 0;
        for (wire, source) in self.graph.sources.iter().enumerate() {
            let Source::Gate(nets, _) = source else { continue };
            if !self.live[wire] {
                continue;
            }
            let mut own: BTreeSet<usize> = nets
                .iter()
                .filter_map(|net| if let Net::Wire(wire) = net { Some(*wire) } else { None })
                .collect();
            let packed: Vec<usize> = own
                .iter()
                .copied()
                // An inverter fits into any LUT; any gate fits into its only user.
                .filter(|input| {
                    leaves.contains_key(input)
                        && (self.uses[*input] == 1 || leaves[input].len() == 1)
                })
                .collect();
            for input in packed {
                let mut merged = own.clone();
                merged.remove(&input);
                merged.extend(&leaves[&input]);
                if merged.len() <= self.rules.inputs {
                    if self.uses[input] == 1 {
                        luts -= 1;
                    }
                    own = merged;
                }
            }
            let inputs = cast::count_of(own.len().max(2));
            luts += (inputs - 1).div_ceil(cast::count_of(self.rules.inputs - 1));
            leaves.insert(wire, own);
        }
        luts
    }

    /// LUTs and DSPs.
    fn part(&self, part: &Part) -> (u64, u64) {
        let rules = self.rules;
        let used = cast::count_of(part.out.iter().filter(|wire| self.live[**wire]).count());
        let highest = part.out.iter().rposition(|wire| self.live[*wire]).map_or(0, |at| at + 1);
        let built = || match rules.sum {
            Sum::Used => used,
            // Carries come in pairs of LUTs.
            Sum::Pairs => 2 * cast::count_of(highest.div_ceil(2)),
            Sum::Two => cast::count_of((0..highest).filter(|at| part.is_free(*at)).count()),
        };
        match part.kind {
            Kind::Sum => (built(), 0),
            Kind::Difference => {
                let inverted: BTreeSet<Net> = part.b[..highest]
                    .iter()
                    .filter(|net| match net {
                        Net::Zero | Net::One => false,
                        // A gate's own LUT can invert.
                        Net::Wire(wire) => !matches!(self.graph.sources[*wire], Source::Gate(..)),
                    })
                    .copied()
                    .collect();
                let inverters = if rules.inverters { cast::count_of(inverted.len()) } else { 0 };
                (built() + inverters, 0)
            }
            Kind::Compare => (cast::count_of(part.a.len()), 0),
            Kind::Shift { levels } => (used * u64::from(levels.div_ceil(rules.shift_levels)), 0),
            Kind::Read { clocked: true, .. } => (0, 0),
            Kind::Read { table, clocked: false } => {
                let addr_bits = self.module.tables[table].addr_bits;
                (self.rom(addr_bits, used), 0)
            }
            Kind::Product { a_bits, b_bits, signed } => {
                self.product(a_bits, b_bits, signed, cast::id_of(highest))
            }
        }
    }

    /// LUTs of a table without a clock: leaves and the multiplexers between them.
    fn rom(&self, addr_bits: u32, columns: u64) -> u64 {
        let inputs = cast::id_of(self.rules.inputs);
        let leaves = 1u64 << addr_bits.saturating_sub(inputs);
        // A LUT with 4 inputs selects from 2 words, one with 6 from 4.
        let fan = if inputs >= 6 { 3 } else { 1 };
        let tree = leaves + (leaves - 1).div_ceil(fan);
        cast::bits_of(cast::i64_of(
            (cast::f64_of_count(columns * tree) * self.rules.rom_share).ceil(),
        ))
    }

    fn product(&self, a: u32, b: u32, signed: bool, used: u32) -> (u64, u64) {
        let rules = self.rules;
        // A target with only signed DSPs gives unsigned factors a sign bit.
        let sign = u32::from(rules.dsp.signed_only && !signed);
        let (long, short) = (a.max(b) + sign, a.min(b) + sign);
        let headroom = u32::from(rules.dsp.signed_only);
        // A factor that is too long is cut; the rest comes last.
        let pieces = |bits: u32, most: u32| {
            let part = rules.dsp.part_bits - headroom;
            let cuts = if bits <= most { 0 } else { (bits - most).div_ceil(part) };
            let mut widths = vec![part; index(cuts)];
            widths.push(bits - cuts * part);
            widths
        };
        let (longs, shorts) =
            (pieces(long, rules.dsp.long_bits), pieces(short, rules.dsp.short_bits));
        let (mut luts, mut dsps) = (0, 0);
        let mut below = 0;
        for short in &shorts {
            let mut lo = below;
            for long in &longs {
                if lo >= used {
                    // Nothing of this piece is used.
                } else if *short.min(long) < 2 || long + short < rules.dsp.least_bits {
                    luts += u64::from(*long) * u64::from(*short);
                } else {
                    dsps += 1;
                }
                lo += long;
            }
            below += short;
        }
        // Pieces are added where they overlap: those of a row first, then the rows.
        let (last_long, last_short) = (longs[longs.len() - 1], shorts[shorts.len() - 1]);
        let in_rows = cast::count_of(longs.len() - 1) * u64::from(short + last_long);
        let of_rows = cast::count_of(shorts.len() - 1) * u64::from(long + last_short);
        match rules.dsp.adds {
            Adds::All => {}
            Adds::Rows => luts += of_rows,
            Adds::None => luts += in_rows + of_rows,
        }
        (luts, dsps)
    }

    /// Flip-flops, and LUTs used as delays.
    fn flip_flops(&self) -> (u64, u64) {
        let flops: BTreeSet<usize> = (0..self.graph.sources.len())
            .filter(|wire| self.live[*wire])
            .filter(|wire| matches!(self.graph.sources[*wire], Source::Flop(_)))
            .collect();
        let input = |wire: usize| match self.graph.sources[wire] {
            Source::Flop(Net::Wire(from)) => from,
            Source::Input
            | Source::Gate(..)
            | Source::Part(_)
            | Source::Flop(_)
            | Source::Held(_) => {
                unreachable!("bug: a flip-flop of a wire")
            }
        };
        let mut gone: BTreeSet<usize> = BTreeSet::new();
        if self.rules.dsp.registers > 0 {
            let products: Vec<&Part> = self
                .graph
                .parts
                .iter()
                .filter(|part| matches!(part.kind, Kind::Product { .. }))
                .filter(|part| self.is_live(part) && self.part(part).1 > 0)
                .collect();
            let mut factors: BTreeMap<usize, u32> = BTreeMap::new();
            for net in products.iter().flat_map(|part| part.a.iter().chain(&part.b)) {
                if let Net::Wire(wire) = net {
                    *factors.entry(*wire).or_default() += 1;
                }
            }
            let whole: BTreeSet<usize> = products
                .iter()
                .filter(|part| self.part(part).1 == 1)
                .flat_map(|part| part.out.iter().copied())
                .collect();
            for flop in &flops {
                let from = input(*flop);
                let into = factors.get(flop) == Some(&self.uses[*flop]);
                if into {
                    // Absorb consecutive registers as long as each feeds nothing else.
                    let mut at = *flop;
                    gone.insert(at);
                    for _ in 1..self.rules.dsp.registers {
                        at = input(at);
                        if !flops.contains(&at) || self.uses[at] > 1 {
                            break;
                        }
                        gone.insert(at);
                    }
                }
                if whole.contains(&from) && self.uses[from] == 1 {
                    gone.insert(*flop);
                }
            }
        }
        let mut delays = 0;
        if let Some(least) = self.rules.shift_registers {
            // A chain ends where its last bit feeds anything other than one flip-flop.
            let feeds: BTreeSet<usize> = flops
                .iter()
                .filter(|flop| !gone.contains(flop))
                .map(|flop| input(*flop))
                .filter(|from| flops.contains(from) && self.uses[*from] == 1)
                .collect();
            for flop in flops.iter().filter(|flop| !feeds.contains(flop)) {
                let mut chain = vec![*flop];
                let mut at = input(*flop);
                while feeds.contains(&at) && !gone.contains(&at) {
                    chain.push(at);
                    at = input(at);
                }
                if chain.len() >= least && !gone.contains(flop) {
                    delays += 1;
                    gone.extend(chain);
                }
            }
        }
        let held = (0..self.graph.sources.len()).filter(|wire| self.live[*wire]);
        let held = held.filter(|wire| matches!(self.graph.sources[*wire], Source::Held(_))).count();
        let data = cast::count_of(flops.difference(&gone).count() + held);
        (data + self.graph.valid_bits, delays)
    }

    fn block_rams(&self) -> u64 {
        let mut ports: BTreeMap<usize, Vec<BTreeSet<usize>>> = BTreeMap::new();
        for part in &self.graph.parts {
            let Kind::Read { table, clocked: true } = part.kind else { continue };
            let used: BTreeSet<usize> =
                (0..part.out.len()).filter(|bit| self.live[part.out[*bit]]).collect();
            if !used.is_empty() {
                ports.entry(table).or_default().push(used);
            }
        }
        // Functions with one case per address don't share.
        let shares = self.module.tables_in != Tables::Case;
        let ram_ports = if shares { self.rules.ram_ports } else { 1 };
        let mut total = 0;
        for (table, ports) in ports {
            for shared in ports.chunks(ram_ports) {
                let columns: BTreeSet<usize> = shared.iter().flatten().copied().collect();
                let columns = cast::id_of(columns.len());
                let of = |shapes| block_rams(shapes, self.module.tables[table].addr_bits, columns);
                let lone = shared.len() == 1 && !self.rules.lone_ram.is_empty();
                let any = of(self.rules.ram);
                total += if lone { any.min(of(self.rules.lone_ram)) } else { any };
            }
        }
        total
    }
}

/// Number of block RAMs for a table in the best shape.
pub(super) fn block_rams(shapes: &[(u32, u32)], addr_bits: u32, columns: u32) -> u64 {
    let count = |(rows, width): &(u32, u32)| {
        (1u64 << addr_bits.saturating_sub(*rows)) * u64::from(columns.div_ceil(*width))
    };
    shapes.iter().map(count).min().expect("bug: a RAM has a shape")
}
