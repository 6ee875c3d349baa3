//! Every operation against exact arithmetic on dyadic rationals, over all small operands.
//!
//! The oracle knows a word only as `raw * 2^(FINE - frac)` steps of 2^-FINE, in `i128`.

use fixpath::format::{Format, Overflow, Round};
use fixpath::netlist::{Builder, Column, NodeId, Quantity, Table};
use fixpath::op::{FormatProblem, Op};
use fixpath::real::{Graph, Twin};
use std::sync::Arc;

const FINE: i32 = 24;

/// The value of a word in steps of 2^-FINE.
fn steps(raw: i64, format: Format) -> i128 {
    i128::from(raw) * 2i128.pow((FINE - format.frac_bits()) as u32)
}

/// All formats of 1 to 4 bits with some fraction bits, signed and unsigned.
fn small_formats() -> Vec<Format> {
    let mut formats = Vec::new();
    for signed in [false, true] {
        for (bits, frac) in [(4, 0), (4, 2), (4, -1), (4, 5), (3, 1), (1, 0), (2, 2)] {
            formats.push(Format::new(signed, bits, frac).unwrap());
        }
    }
    formats
}

fn words(format: Format) -> std::ops::RangeInclusive<i64> {
    format.min_raw()..=format.max_raw()
}

/// Evaluates an operation without a format argument, and checks that its word is in the format.
fn eval(op: Op, of: &[(i64, Format)]) -> (i64, Format) {
    let formats: Vec<Format> = of.iter().map(|(_, format)| *format).collect();
    let out = op.result_format(&formats, None, &[]).unwrap();
    let (raw, overflowed) = op.eval_raw(of, out, &[]);
    assert!(!overflowed, "only narrow overflows");
    let (lo, hi) = if out.is_signed() {
        (-(1i128 << (out.bits() - 1)), (1i128 << (out.bits() - 1)) - 1)
    } else {
        (0, (1i128 << out.bits()) - 1)
    };
    assert!((lo..=hi).contains(&i128::from(raw)), "{op:?} of {of:?} gave {raw}, outside {out}");
    (raw, out)
}

/// Value of an operation on reals, if defined.
fn on_reals(op: Op, reals: &[f64], out: Format) -> Option<f64> {
    let mut graph = Graph::default();
    let of: Vec<_> = reals.iter().map(|value| graph.constant(*value)).collect();
    let reading = op.reading(&mut graph, &of, out)?;
    Some(graph.values(&Twin, &[])[reading.index()])
}

/// The real evaluation must be the value of the word.
fn check_real(op: Op, of: &[(i64, Format)], (raw, out): (i64, Format)) {
    let mut reals = [0.0; 3];
    for (real, (raw, format)) in reals.iter_mut().zip(of) {
        *real = *raw as f64 * 2f64.powi(-format.frac_bits());
    }
    let expected = raw as f64 * 2f64.powi(-out.frac_bits());
    assert_eq!(on_reals(op, &reals[..of.len()], out), Some(expected), "{op:?} of {of:?}");
}

/// The fewest bits that hold all of some words, by trial.
fn fewest(least: i64, most: i64) -> (bool, u32) {
    let signed = least < 0;
    let fits = |bits: u32| {
        if signed {
            -(1i64 << (bits - 1)) <= least && most < 1i64 << (bits - 1)
        } else {
            most < 1i64 << bits
        }
    };
    (signed, (1..=63).find(|bits| fits(*bits)).unwrap())
}

fn check_smallest(op: Op, seen: &[i64], out: Format) {
    let (least, most) = (*seen.iter().min().unwrap(), *seen.iter().max().unwrap());
    assert_eq!((out.is_signed(), out.bits()), fewest(least, most), "{op:?} into {out}");
}

#[test]
fn one_operand_arithmetic() {
    for a in small_formats() {
        for op in [Op::Neg, Op::Abs] {
            let mut seen = Vec::new();
            let mut format = None;
            for raw in words(a) {
                let result = eval(op, &[(raw, a)]);
                let value = steps(raw, a);
                let expected = if op == Op::Neg || value < 0 { -value } else { value };
                assert_eq!(steps(result.0, result.1), expected, "{op:?} {raw} {a}");
                check_real(op, &[(raw, a)], result);
                seen.push(result.0);
                format = Some(result.1);
            }
            check_smallest(op, &seen, format.unwrap());
        }
        for left in -5..=5 {
            let op = Op::Shift { left };
            for raw in words(a) {
                let result = eval(op, &[(raw, a)]);
                let scaled = steps(raw, a) * 32 * if left >= 0 { 1 << left } else { 1 };
                let expected = scaled / 32 / if left < 0 { 1 << -left } else { 1 };
                assert_eq!(steps(result.0, result.1), expected);
                assert_eq!((result.0, result.1.bits()), (raw, a.bits()), "no bit moves");
                check_real(op, &[(raw, a)], result);
            }
        }
    }
}

#[test]
fn two_operand_arithmetic_and_comparison() {
    for a in small_formats() {
        for b in small_formats() {
            for op in [Op::Add, Op::Sub, Op::Mul, Op::Equal, Op::Less] {
                let (mut seen, mut format) = (Vec::new(), None);
                for x in words(a) {
                    for y in words(b) {
                        let result = eval(op, &[(x, a), (y, b)]);
                        let (p, q) = (steps(x, a), steps(y, b));
                        let is = steps(result.0, result.1);
                        let expected = [
                            (Op::Add, p + q),
                            (Op::Sub, p - q),
                            (Op::Mul, (p * q) >> FINE),
                            (Op::Equal, i128::from(p == q) << FINE),
                            (Op::Less, i128::from(p < q) << FINE),
                        ];
                        assert!(expected.contains(&(op, is)), "{op:?} {x} {a}, {y} {b}: {is}");
                        check_real(op, &[(x, a), (y, b)], result);
                        seen.push(result.0);
                        format = Some(result.1);
                    }
                }
                if matches!(op, Op::Add | Op::Sub | Op::Mul) {
                    check_smallest(op, &seen, format.unwrap());
                } else {
                    assert_eq!(format, Some(Format::FLAG));
                }
            }
        }
    }
}

#[test]
fn flagged_arithmetic() {
    for a in small_formats() {
        for b in small_formats() {
            for op in [Op::AddSub, Op::Mux] {
                let (mut seen, mut format) = (Vec::new(), None);
                for flag in [0, 1] {
                    for x in words(a) {
                        for y in words(b) {
                            let of = [(flag, Format::FLAG), (x, a), (y, b)];
                            let result = eval(op, &of);
                            let (p, q) = (steps(x, a), steps(y, b));
                            let expected = match (op, flag) {
                                (Op::AddSub, 1) => p - q,
                                (Op::AddSub, _) => p + q,
                                (_, 1) => p,
                                _ => q,
                            };
                            assert_eq!(steps(result.0, result.1), expected, "{op:?} {of:?}");
                            check_real(op, &of, result);
                            seen.push(result.0);
                            format = Some(result.1);
                        }
                    }
                }
                check_smallest(op, &seen, format.unwrap());
            }
        }
    }
}

/// Bits of a word, least first, by repeated halving of its residue.
fn bits_of(raw: i64, bits: u32) -> Vec<i64> {
    let mut rest = raw.rem_euclid(1 << bits);
    (0..bits)
        .map(|_| {
            let bit = rest % 2;
            rest /= 2;
            bit
        })
        .collect()
}

fn number_of(bits: &[i64]) -> i64 {
    bits.iter().rev().fold(0, |number, bit| 2 * number + bit)
}

#[test]
fn bitwise_operations() {
    for a in small_formats() {
        for x in words(a) {
            for y in words(a) {
                for op in [Op::And, Op::Or, Op::Xor] {
                    let result = eval(op, &[(x, a), (y, a)]);
                    let (p, q) = (bits_of(x, a.bits()), bits_of(y, a.bits()));
                    let expected: Vec<i64> = p
                        .iter()
                        .zip(&q)
                        .map(|(p, q)| {
                            if op == Op::And {
                                p * q
                            } else if op == Op::Or {
                                *p.max(q)
                            } else {
                                (p + q) % 2
                            }
                        })
                        .collect();
                    assert_eq!(bits_of(result.0, a.bits()), expected, "{op:?} {x} {y} {a}");
                    assert_eq!(result.1, a);
                    if a == Format::FLAG {
                        check_real(op, &[(x, a), (y, a)], result);
                    }
                }
            }
            for lo in 0..a.bits() {
                for count in 1..=a.bits() - lo {
                    let op = Op::Slice { lo };
                    let asked = Format::integer(count).unwrap();
                    assert_eq!(op.result_format(&[a], Some(asked), &[]), Ok(asked));
                    let (raw, _) = op.eval_raw(&[(x, a)], asked, &[]);
                    let bits = &bits_of(x, a.bits())[lo as usize..(lo + count) as usize];
                    assert_eq!(raw, number_of(bits), "bits {lo} and {count} of {x} {a}");
                }
            }
        }
    }
    for (high, low) in [(4, 4), (1, 4), (3, 1)] {
        let (a, b) = (Format::integer(high).unwrap(), Format::integer(low).unwrap());
        for x in words(a) {
            for y in words(b) {
                let (raw, format) = eval(Op::Concat, &[(x, a), (y, b)]);
                assert_eq!((raw, format), ((x << low) + y, Format::integer(high + low).unwrap()));
            }
        }
    }
}

#[test]
fn leading_zeros_and_barrel_shifts() {
    for a in small_formats() {
        for x in words(a) {
            if !a.is_signed() {
                let (raw, _) = eval(Op::LeadingZeros, &[(x, a)]);
                let zeros = bits_of(x, a.bits()).iter().rev().take_while(|bit| **bit == 0).count();
                assert_eq!(raw, zeros as i64);
            }
            for count_bits in 1..=3 {
                let count = Format::integer(count_bits).unwrap();
                for max in 0..=6 {
                    for n in words(count) {
                        let result = eval(Op::ShiftLeft { max }, &[(x, a), (n, count)]);
                        let expected = steps(x, a) * 2i128.pow((n as u32).min(max));
                        assert_eq!(steps(result.0, result.1), expected);
                    }
                }
            }
        }
    }
}

#[test]
fn residues() {
    for a in small_formats() {
        for signed in [false, true] {
            for bits in 1..=5 {
                let out = Format::new(signed, bits, a.frac_bits()).unwrap();
                let op = Op::Modulo;
                assert_eq!(op.result_format(&[a], Some(out), &[]), Ok(out));
                for x in words(a) {
                    let (raw, overflowed) = op.eval_raw(&[(x, a)], out, &[]);
                    assert!(!overflowed && words(out).contains(&raw));
                    assert_eq!((raw - x).rem_euclid(1 << bits), 0);
                    check_real(op, &[(x, a)], (raw, out));
                }
            }
        }
    }
}

#[test]
fn constants_reads_and_narrows() {
    let address = Format::integer(3).unwrap();
    let out = Format::signed(4, 1).unwrap();
    let words: Vec<i64> = vec![7, -8, 3, 0, -1, 5, 6, -4];
    let column = |name: &str, words: &[i64]| Column {
        name: name.to_owned(),
        format: out,
        words: Arc::from(words),
    };
    let reversed: Vec<i64> = words.iter().rev().copied().collect();
    let columns = vec![column("up", &words), column("down", &reversed)];
    let mut b = Builder::new("reads");
    let a = b.input("a", address, Quantity::Number);
    let table = b.table(Table { name: "rom".to_owned(), addr_bits: 3, columns, memory: None });
    for (i, name) in ["up", "down"].into_iter().enumerate() {
        let read = b.read(table, i, a);
        assert_eq!(b.format(read), out);
        b.output(name, read);
    }
    let constant = b.constant(-8, out);
    b.output("constant", constant);
    let netlist = b.build().unwrap();
    for at in 0..8usize {
        let (nodes, _) = netlist.eval(&[at as i64]).unwrap();
        let outputs: Vec<i64> = netlist.outputs().iter().map(|o| nodes[o.node.index()]).collect();
        assert_eq!(outputs, [words[at], words[7 - at], -8]);
        assert_eq!(netlist.eval_reals(&[at as f64])[netlist.outputs()[2].node.index()], -4.0);
    }
    let op = Op::Narrow { round: Round::HalfEven, overflow: Overflow::Saturate };
    let to = Format::signed(3, 0).unwrap();
    for (raw, expected) in [(7, (3, true)), (5, (2, false)), (-8, (-4, false)), (-5, (-2, false))] {
        assert_eq!(op.eval_raw(&[(raw, out)], to, &[]), expected, "{raw}");
        assert_eq!(on_reals(op, &[raw as f64 / 2.0], to), Some(raw as f64 / 2.0));
    }
}

#[test]
fn the_most_negative_word() {
    for bits in 1..=32u32 {
        let a = Format::signed(bits, 0).unwrap();
        let least = -(1i64 << (bits - 1));
        let (raw, out) = eval(Op::Neg, &[(least, a)]);
        assert_eq!((raw, out.is_signed()), (-least, bits > 1), "-(-1) of s1 is 0 or 1");
        let (raw, out) = eval(Op::Abs, &[(least, a)]);
        assert_eq!((raw, out), (-least, Format::unsigned(bits, 0).unwrap()));
        if bits <= 31 {
            let (raw, out) = eval(Op::Mul, &[(least, a), (least, a)]);
            assert_eq!(raw, 1 << (2 * (bits - 1)));
            assert_eq!(out.bits(), if bits == 1 { 1 } else { 2 * bits });
        }
    }
    let widest = Format::signed(63, 0).unwrap();
    let (raw, out) = eval(Op::Abs, &[(widest.min_raw(), widest)]);
    assert_eq!((raw, out), (1 << 62, Format::unsigned(63, 0).unwrap()));
}

/// Message of a netlist of one operation on inputs `a`, `b` of the given formats.
fn refusal(formats: &[Format], op: impl FnOnce(&mut Builder, &[NodeId]) -> NodeId) -> String {
    let mut b = Builder::new("wide");
    let names = ["a", "b", "c"];
    let inputs: Vec<_> = formats
        .iter()
        .zip(names)
        .map(|(format, name)| b.input(name, *format, Quantity::Number))
        .collect();
    b.output("out", inputs[0]);
    op(&mut b, &inputs);
    b.build().unwrap_err().to_string()
}

#[test]
fn words_of_63_bits_pass_and_of_64_are_refused_by_name() {
    let (s, u) = (Format::signed(63, 0).unwrap(), Format::unsigned(63, 0).unwrap());
    let (s62, s32) = (Format::signed(62, 0).unwrap(), Format::signed(32, 0).unwrap());
    let s31 = Format::signed(31, 0).unwrap();
    let wide = |node: &str, bits: u32| {
        format!(
            "node `{node}` needs {bits} bits and words have at most 63: lower the widths or guard bits that feed it"
        )
    };
    assert_eq!(Op::Add.result_format(&[s62, s62], None, &[]), Ok(s));
    assert_eq!(Op::Mul.result_format(&[s31, s32], None, &[]), Ok(s));
    assert_eq!(Op::Add.result_format(&[s, s], None, &[]), Err(FormatProblem::TooWide(64)));
    assert_eq!(refusal(&[s, s], |b, i| b.add(i[0], i[1])), wide("add of a (s63f0), b (s63f0)", 64));
    assert_eq!(refusal(&[s, s], |b, i| b.sub(i[0], i[1])), wide("sub of a (s63f0), b (s63f0)", 64));
    assert_eq!(
        refusal(&[s32, s32], |b, i| b.mul(i[0], i[1])),
        wide("mul of a (s32f0), b (s32f0)", 64)
    );
    assert_eq!(refusal(&[s], |b, i| b.neg(i[0])), wide("neg of a (s63f0)", 64));
    assert_eq!(refusal(&[u], |b, i| b.neg(i[0])), wide("neg of a (u63f0)", 64));
    assert_eq!(
        refusal(&[u, u], |b, i| b.concat(i[0], i[1])),
        wide("concat of a (u63f0), b (u63f0)", 126)
    );
    let fine = Format::signed(60, 4).unwrap();
    // Alignment to 4 fraction bits takes 67 bits before the operation itself.
    assert_eq!(
        refusal(&[s, fine], |b, i| b.less(i[0], i[1])),
        wide("less of a (s63f0), b (s60f4)", 67)
    );
    let n = Format::integer(2).unwrap();
    assert_eq!(
        refusal(&[s62, n], |b, i| b.shift_left(i[0], i[1], 2)),
        wide("shift_left of a (s62f0), b (u2f0)", 64)
    );
    assert_eq!(
        refusal(&[s, u, Format::FLAG], |b, i| b.mux(i[2], i[0], i[1])),
        wide("mux of c (u1f0), a (s63f0), b (u63f0)", 64)
    );
    assert_eq!(
        refusal(&[s, s, Format::FLAG], |b, i| b.addsub(i[2], i[0], i[1])),
        wide("addsub of c (u1f0), a (s63f0), b (s63f0)", 64)
    );
}

#[test]
fn operands_that_do_not_fit_are_refused() {
    let (s4, u4) = (Format::signed(4, 0).unwrap(), Format::unsigned(4, 1).unwrap());
    let cases: [(&str, String); 9] = [
        (
            "bitwise operands must have the same format",
            refusal(&[s4, u4], |b, i| b.and(i[0], i[1])),
        ),
        ("the first operand must be a flag", refusal(&[s4, s4], |b, i| b.mux(i[0], i[1], i[0]))),
        ("the first operand must be a flag", refusal(&[s4, s4], |b, i| b.addsub(i[0], i[1], i[0]))),
        ("bits 3..5 of a 4-bit word", refusal(&[s4], |b, i| b.slice(i[0], 3, 2))),
        (
            "only unsigned integers can be concatenated",
            refusal(&[s4, s4], |b, i| b.concat(i[0], i[1])),
        ),
        (
            "leading zeros can only be counted in unsigned words",
            refusal(&[s4], |b, i| b.leading_zeros(i[0])),
        ),
        (
            "a shift count must be an unsigned integer",
            refusal(&[s4, u4], |b, i| b.shift_left(i[0], i[1], 2)),
        ),
        ("a residue must keep the fraction bits", refusal(&[s4], |b, i| b.modulo(i[0], u4))),
        ("word 8 is outside s4f0", refusal(&[s4], |b, _| b.constant(8, s4))),
    ];
    for (expected, message) in cases {
        assert!(message.ends_with(expected), "{message}");
    }
    let far = Format::signed(4, 100).unwrap();
    assert_eq!(
        refusal(&[far, far], |b, i| b.mul(i[0], i[1])),
        "node `mul of a (s4f100), b (s4f100)`: the sum of the fraction bits is outside -127 to 127"
    );
    assert_eq!(
        refusal(&[far], |b, i| b.shift(i[0], -28)),
        "node `shift of a (s4f100)`: the binary point moves past 127 places"
    );
    // The first mistake is reported.
    let first = refusal(&[s4, u4], |b, i| {
        let wrong = b.and(i[0], i[1]);
        b.slice(wrong, 60, 60)
    });
    assert_eq!(
        first,
        "node `and of a (s4f0), b (u4f1)`: bitwise operands must have the same format"
    );
}
