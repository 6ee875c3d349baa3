//! The logic of a node.

use super::words::Lowering;
use crate::hardware::hdl::module::{
    Bit, Bitwise, Driver, Expr, Item, Next, Operand, Register, View, WordId,
};
use crate::hardware::rtl::Signal;
use crate::netlist::NodeId;
use crate::netlist::op::Op;
use crate::number::format::{Format, bit_len};
use std::sync::Arc;

impl Lowering {
    pub(super) fn node(&mut self, id: NodeId) {
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
        if let Op::Delay { samples } = node.op {
            self.delay(id, &wanted, samples);
            return;
        }
        let word = self.node_word(&wanted, out, Driver::Logic);
        self.at.signals.insert(signal, word);
        let expr = self.expr(id, word);
        self.assign(word, expr);
    }

    /// The registers of a delay, which load a word when the sample is data.
    fn delay(&mut self, id: NodeId, name: &str, samples: u32) {
        let rtl = Arc::clone(&self.at.rtl);
        let stage = rtl.schedule().stage(id);
        let phases = rtl.schedule().phases_of(stage, rtl.schedule().interval());
        let (load, valid) = (self.load(phases), self.module.valid.0.clone());
        let mut from = self.operand(id, 0);
        for number in 1..=samples {
            let wanted =
                if number < samples { format!("{name}_d{number}") } else { name.to_owned() };
            let word = self.node_word(&wanted, rtl.netlist().node(id).format, Driver::Register);
            self.use_bits(from, 0, u32::MAX);
            self.module.stages[self.stage].declared.push(word);
            let (next, valid) = (Next::Word(from), Some(valid.clone()));
            let register = Register { word, next, load, valid, reset: true };
            self.module.stages[self.stage].registers.push(register);
            from = word;
        }
        self.at.signals.insert(Signal { node: id, stage }, from);
    }

    /// The expression of a node; the helpers that it needs are added first.
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
            // One-bit factors with a one-bit product: a language would need two bits to keep signs.
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
                    // The kept bits are as many as the limit has: a count with higher bits set
                    // exceeds it.
                    let kept_bits = bit_len(max.into()).max(1);
                    let kept = self.resized(count, kept_bits);
                    let cases = vec![(past, limit(kept_bits))];
                    let kept = Expr::Choose { cases, default: kept };
                    count = self.plain(word, "count", kept_bits, kept);
                }
                Expr::ShiftLeft(a, count)
            }
            Op::Delay { .. } => unreachable!("bug: a delay is registers"),
            Op::Read { .. } if let Some(word) = self.fetched(id) => {
                Expr::Copy(self.resized(word, bits))
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

    /// Repeatedly halves the word, testing whether the upper half is all zero.
    fn leading_zeros(&mut self, word: WordId, a: WordId, bits: u32) -> Expr {
        let out_bits = self.module.word(word).bits;
        if bits == 1 {
            let literal = |pattern| Operand::Literal { pattern, bits: 1 };
            let bit = Bit { word: a, bit: 0 };
            return Expr::Choose { cases: vec![(bit, literal(0))], default: literal(1) };
        }
        let mut size = bits.next_power_of_two();
        // Ones are appended below, so that a zero word whose size isn't a power of two counts its
        // own bits.
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
}
