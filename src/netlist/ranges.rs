//! Interval analysis: the words that each node can hold.

use super::words::{Words, wrapped};
use crate::base::cast;
use crate::netlist::op::Op;
use crate::netlist::{Netlist, Table};
use crate::number::format::{Format, Overflow, narrow, rounded};

/// The words that each node can hold, given the words of each input; a superset, never too few.
///
/// Monotone or modular operations of one operand, sums, comparisons and multiplexers are exact for
/// operands that are independent intervals. Products, shifts and table reads have exact ends.
///
/// # Panics
/// If there isn't one set per input, within the input's format.
#[must_use]
pub fn ranges(netlist: &Netlist, inputs: &[Words]) -> Vec<Words> {
    assert_eq!(inputs.len(), netlist.inputs().len(), "bug: one set of words per input");
    let mut ports = inputs.iter();
    let mut words: Vec<Words> = Vec::with_capacity(netlist.nodes().len());
    for node in netlist.nodes() {
        let of =
            |i: usize| (&words[node.operands[i].index()], netlist.node(node.operands[i]).format);
        let found = if node.op == Op::Input {
            let given = ports.next().expect("bug: counted above");
            let inside = node.format.contains(given.lo()) && node.format.contains(given.hi());
            assert!(inside, "bug: words {given} of a port {}", node.format);
            given.clone()
        } else if let Op::Delay { .. } = node.op {
            // A delay starts with 0.
            Words::of(of(0).0.intervals().iter().copied().chain([(0, 0)]))
        } else if node.op == Op::Mul && node.operands[0] == node.operands[1] {
            square(of(0).0, node.format)
        } else {
            let of: Vec<(&Words, Format)> = (0..node.operands.len()).map(of).collect();
            image(node.op, &of, node.format, netlist.tables())
        };
        words.push(found);
    }
    words
}

/// `x * x`: both factors are the same word.
fn square(of: &Words, out: Format) -> Words {
    let intervals: Vec<(i128, i128)> = magnitudes(of).map(|(lo, hi)| (lo * lo, hi * hi)).collect();
    Words::in_format(&intervals, out)
}

/// `|x|` of each interval.
fn magnitudes(of: &Words) -> impl Iterator<Item = (i128, i128)> {
    wide(of, 0).map(|(lo, hi)| (lo.max(-hi).max(0), hi.max(-lo)))
}

/// The intervals, shifted left.
fn wide(of: &Words, shift: i32) -> impl Iterator<Item = (i128, i128)> + Clone {
    let up = move |raw: i64| i128::from(raw) << shift;
    of.intervals().iter().map(move |(lo, hi)| (up(*lo), up(*hi)))
}

/// The words of an operation's result for any combination of its operands' words.
#[expect(clippy::wildcard_enum_match_arm, reason = "any word of the format is right for all")]
fn image(op: Op, of: &[(&Words, Format)], out: Format, tables: &[Table]) -> Words {
    let known: Option<Vec<(i64, Format)>> =
        of.iter().map(|(words, format)| words.constant().map(|raw| (raw, *format))).collect();
    if let Some(known) = known.filter(|_| !of_memory(op, tables)) {
        return Words::only(op.eval_raw(&known, out, tables).0);
    }
    // As in `Op::eval_raw`: operands a and b in units of the finer one.
    let aligned = |a: usize, b: usize| {
        let frac = of[a].1.frac_bits().max(of[b].1.frac_bits());
        let at = |i: usize| wide(of[i].0, frac - of[i].1.frac_bits()).collect::<Vec<_>>();
        (at(a), at(b))
    };
    let flag = |holds: bool| of[0].0.contains(i64::from(holds));
    let minus = |(lo, hi): (i128, i128)| (-hi, -lo);
    let intervals: Vec<(i128, i128)> = match op {
        Op::Add => {
            let (a, b) = aligned(0, 1);
            pairs(&a, &b, |a, b| (a.0 + b.0, a.1 + b.1))
        }
        Op::Sub => {
            let (a, b) = aligned(0, 1);
            pairs(&a, &b, |a, b| (a.0 - b.1, a.1 - b.0))
        }
        Op::AddSub => {
            let (a, b) = aligned(1, 2);
            let mut terms = if flag(false) { b.clone() } else { Vec::new() };
            if flag(true) {
                terms.extend(b.into_iter().map(minus));
            }
            pairs(&a, &terms, |a, b| (a.0 + b.0, a.1 + b.1))
        }
        Op::Mul => {
            let (a, b): (Vec<_>, Vec<_>) = (wide(of[0].0, 0).collect(), wide(of[1].0, 0).collect());
            pairs(&a, &b, |a, b| ends([a.0 * b.0, a.0 * b.1, a.1 * b.0, a.1 * b.1]))
        }
        Op::Neg => wide(of[0].0, 0).map(minus).collect(),
        Op::Abs => magnitudes(of[0].0).collect(),
        Op::And => bitwise(|a, b| a & b, of[0].0, of[1].0),
        Op::Or => bitwise(|a, b| a | b, of[0].0, of[1].0),
        Op::Xor => bitwise(|a, b| a ^ b, of[0].0, of[1].0),
        Op::Equal => {
            let (a, b) = aligned(0, 1);
            let meet = pairs(&a, &b, |a, b| (a.0.max(b.0), a.1.min(b.1)));
            // If both operands are constant, that was handled above; so a common word means that
            // both results are possible.
            vec![(0, i128::from(meet.into_iter().any(|(lo, hi)| lo <= hi)))]
        }
        Op::Less => {
            let (a, b) = aligned(0, 1);
            let (least, most) = ((a[0].0, b[0].0), (a[a.len() - 1].1, b[b.len() - 1].1));
            vec![(i128::from(most.0 < least.1), i128::from(least.0 < most.1))]
        }
        Op::Mux => {
            let (mut a, b) = aligned(1, 2);
            if !flag(true) {
                a.clear();
            }
            if flag(false) {
                a.extend(b);
            }
            a
        }
        // The bits are those of the two's complement, whatever its width.
        Op::Slice { lo } => of[0]
            .0
            .intervals()
            .iter()
            .flat_map(|(first, last)| wrapped((first >> lo).into(), (last >> lo).into(), out))
            .collect(),
        Op::Concat => {
            let (a, b): (Vec<_>, Vec<_>) = (
                wide(of[0].0, cast::signed_count(of[1].1.bits())).collect(),
                wide(of[1].0, 0).collect(),
            );
            pairs(&a, &b, |a, b| (a.0 + b.0, a.1 + b.1))
        }
        Op::Shift { .. } => wide(of[0].0, 0).collect(),
        Op::LeadingZeros => {
            let zeros = |raw: i64| op.eval_raw(&[(raw, of[0].1)], out, tables).0.into();
            of[0].0.intervals().iter().map(|(lo, hi)| (zeros(*hi), zeros(*lo))).collect()
        }
        Op::ShiftLeft { max } => {
            let (least, most) =
                (of[1].0.lo().min(i64::from(max)), of[1].0.hi().min(i64::from(max)));
            wide(of[0].0, 0)
                .map(|(lo, hi)| ends([lo << least, lo << most, hi << least, hi << most]))
                .collect()
        }
        Op::Read { table, column } if !of_memory(op, tables) => {
            let column = usize::try_from(column).expect("bug: small");
            let rows = &tables[table.index()].columns[column].words;
            let span = |(lo, hi): &(i64, i64)| {
                let rows = &rows[cast::index_of(*lo)..=cast::index_of(*hi)];
                let least = rows.iter().min().expect("bug: not empty");
                let most = rows.iter().max().expect("bug: not empty");
                (i128::from(*least), i128::from(*most))
            };
            of[0].0.intervals().iter().map(span).collect()
        }
        Op::Modulo => wide(of[0].0, 0).flat_map(|(lo, hi)| wrapped(lo, hi, out)).collect(),
        Op::Narrow { round, overflow } => {
            let frac = of[0].1.frac_bits();
            let narrowed = |(lo, hi): &(i64, i64)| match overflow {
                Overflow::Saturate | Overflow::Symmetric => {
                    let word = |raw| i128::from(narrow(raw, frac, out, round, overflow).0);
                    vec![(word(*lo), word(*hi))]
                }
                Overflow::Wrap | Overflow::Error => {
                    let whole = |raw| rounded(raw, frac, out.frac_bits(), round);
                    wrapped(whole(*lo), whole(*hi), out)
                }
            };
            of[0].0.intervals().iter().flat_map(narrowed).collect()
        }
        // A memory may hold any word. Other operations without a rule get every word of their
        // format.
        _ => vec![(out.min_raw().into(), out.max_raw().into())],
    };
    Words::in_format(&intervals, out)
}

/// True for a read of a memory.
fn of_memory(op: Op, tables: &[Table]) -> bool {
    let Op::Read { table, .. } = op else { return false };
    tables[table.index()].memory.is_some()
}

fn pairs<T>(
    a: &[(i128, i128)],
    b: &[(i128, i128)],
    of: impl Fn((i128, i128), (i128, i128)) -> T,
) -> Vec<T> {
    a.iter().flat_map(|a| b.iter().map(|b| of(*a, *b))).collect()
}

fn ends(corners: [i128; 4]) -> (i128, i128) {
    let [p, q, r, s] = corners;
    (p.min(q).min(r.min(s)), p.max(q).max(r.max(s)))
}

/// How often an interval is halved to find bits that one operand leaves unchanged.
const HALVINGS: u32 = 3;

type Interval = (i64, i64);

fn bitwise(word: fn(i64, i64) -> i64, a: &Words, b: &Words) -> Vec<(i128, i128)> {
    let mut found = Vec::new();
    for a in a.intervals() {
        for b in b.intervals() {
            bitwise_interval(word, *a, *b, HALVINGS, &mut found);
        }
    }
    found
}

fn bitwise_interval(
    word: fn(i64, i64) -> i64,
    a: Interval,
    b: Interval,
    halvings: u32,
    found: &mut Vec<(i128, i128)>,
) {
    // The highest bit that varies in an interval, and all bits below it.
    let varying = |(lo, hi): Interval| match (lo ^ hi).leading_zeros() {
        0 => -1,
        64 => 0,
        same => i64::MAX >> (same - 1),
    };
    let (free_a, free_b) = (varying(a), varying(b));
    let free = free_a | free_b;
    let fixed = if free_a == 0 { a.0 } else { b.0 };
    if (free_a == 0 || free_b == 0) && (fixed & free == 0 || fixed & free == free) {
        // On the free bits, a constant of all zeros or all ones keeps the order, reverses it, or
        // makes all words equal.
        let (p, q) = (word(a.0, b.0), word(a.1, b.1));
        found.push((p.min(q).into(), p.max(q).into()));
    } else if halvings > 0 {
        let a_is_halved = free_a == free;
        let whole = if a_is_halved { a } else { b };
        // The first word that has the highest free bit set like the last word.
        let middle = whole.1 & !(if free == -1 { i64::MAX } else { free >> 1 });
        for half in [(whole.0, middle - 1), (middle, whole.1)] {
            let (a, b) = if a_is_halved { (half, b) } else { (a, half) };
            bitwise_interval(word, a, b, halvings - 1, found);
        }
    } else {
        // Bits that are set in every case, and in any case; a free sign may be either.
        let (a0, a1, b0, b1) = (a.0 & !free_a, a.0 | free_a, b.0 & !free_b, b.0 | free_b);
        let cases = [word(a0, b0), word(a0, b1), word(a1, b0), word(a1, b1)];
        let every = cases.into_iter().fold(-1, |bits, case| bits & case);
        let any = cases.into_iter().fold(0, |bits, case| bits | case);
        let signs = (every ^ any) & i64::MIN;
        found.push(((every | signs).into(), (any & !signs).into()));
    }
}
