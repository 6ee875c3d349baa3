//! Dividers: by digit recurrence, and by a reciprocal table.

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::netlist::{Builder, NodeId, Part};
use crate::number::format::{Format, Overflow, Round};
use crate::number::real::Expr;
use crate::table::{self, Spec};

/// How a quotient is computed.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Method<'a> {
    /// Digit by digit: a subtractor and a multiplexer each. Correctly rounded in every mode.
    Restoring,
    /// Digit by digit: an adder/subtractor each. Correctly rounded in every mode.
    NonRestoring,
    /// The normalised dividend times the reciprocal of the normalised divisor, from a table with
    /// argument [`argument`] and origin ½. Off by the quotient times the table's worst error,
    /// before the one rounding.
    Table(Spec<'a>),
}

/// `a / d` in format `output`. Results out of range saturate, including x/0; 0/0 is 0.
pub(crate) fn divide(
    b: &mut Builder,
    name: &str,
    [a, d]: [NodeId; 2],
    output: Format,
    round: Round,
    method: &Method<'_>,
) -> NodeId {
    b.part(Part::Divider, name, |b| {
        let (dividend, divisor) = (magnitude(b, a), magnitude(b, d));
        let limit = limit(b, output);
        let (quotient, past) = match method {
            Method::Restoring => digits(b, dividend, divisor, output, false),
            Method::NonRestoring => digits(b, dividend, divisor, output, true),
            Method::Table(spec) => (normalised(b, dividend, divisor, output, spec), None),
        };
        let zero = b.constant(0, Format::FLAG);
        let by_zero = b.equal(divisor, zero);
        let past = past.map_or(by_zero, |past| b.or(past, by_zero));
        let quotient = b.mux(past, limit, quotient);
        let of_zero = b.equal(dividend, zero);
        let quotient = b.mux(of_zero, zero, quotient);
        let signed = |operand: &NodeId| b.format(*operand).is_signed();
        let signs: Vec<NodeId> = [a, d].into_iter().filter(signed).collect();
        let signs: Vec<NodeId> = signs.into_iter().map(|operand| b.negative(operand)).collect();
        let signed = match signs[..] {
            [] => quotient,
            [sign] => negate(b, sign, quotient),
            [one, other, ..] => {
                let sign = b.xor(one, other);
                negate(b, sign, quotient)
            }
        };
        let quotient = b.narrow(signed, output, round, Overflow::Saturate);
        b.means(quotient, [a, d], |[a, d]| ended_quotient(&a, &d))
    })
}

/// `a / d`. 0/0 is 0; any other division by 0 gives ±`f64::MAX`, just as words saturate.
fn ended_quotient(a: &Expr, d: &Expr) -> Expr {
    let quotient = (a / d).max(-f64::MAX).min(f64::MAX);
    a.equal(0.0).select(0.0, quotient)
}

/// Format of the reciprocal table's argument: the mantissa of the divisor's magnitude, without its
/// top bit.
///
/// # Errors
/// If the divisor has only one bit.
pub(crate) fn argument(divisor: Format) -> Result<Format> {
    let bits = magnitude_bits(divisor);
    Format::unsigned(bits - 1, cast::signed_count(bits))
}

/// Bits of |x|: as many as x, since the magnitude of the least word must fit.
fn magnitude_bits(format: Format) -> u32 {
    format.bits()
}

fn magnitude(b: &mut Builder, a: NodeId) -> NodeId {
    if b.format(a).is_signed() { b.abs(a) } else { a }
}

fn negate(b: &mut Builder, sign: NodeId, a: NodeId) -> NodeId {
    let minus = b.neg(a);
    b.mux(sign, minus, a)
}

/// The least number above the range of a format; it saturates on both sides.
pub(crate) fn limit(b: &mut Builder, output: Format) -> NodeId {
    let power = b.checked(Format::unsigned(1, -output.int_bits()));
    b.constant(1, power)
}

/// Bit `i` of an unsigned word with zeros appended.
pub(crate) fn bit_of(b: &mut Builder, a: NodeId, appended: u32, i: u32) -> NodeId {
    let format = b.format(a);
    if (appended..appended + format.bits()).contains(&i) {
        b.slice(a, i - appended, 1)
    } else {
        b.constant(0, Format::FLAG)
    }
}

/// The word made of these bits, the first on top.
pub(crate) fn word_of(b: &mut Builder, bits: &[NodeId]) -> NodeId {
    let Some((first, rest)) = bits.split_first() else {
        b.fail(Error::usage(
            "formats given by name leave a result without bits: give finer ones".to_owned(),
        ));
        return b.constant(0, Format::FLAG);
    };
    rest.iter().fold(*first, |word, bit| b.concat(word, *bit))
}

/// Flag: the word isn't 0. It is the lowest bit of an exact result, for rounding.
pub(crate) fn sticky(b: &mut Builder, rest: NodeId) -> NodeId {
    let (zero, one) = (b.constant(0, Format::FLAG), b.constant(1, Format::FLAG));
    let none = b.equal(rest, zero);
    b.xor(none, one)
}

/// Shifts a nonzero word up by `step` places at a time until one of its top `step` bits is set.
/// Returns it and the number of steps. The result is as wide as the word: a multiplexer per bit of
/// the count.
pub(crate) fn normalise(b: &mut Builder, word: NodeId, step: u32) -> (NodeId, NodeId) {
    let bits = b.format(word).bits();
    let zero = b.constant(0, Format::FLAG);
    let mut word = b.slice(word, 0, bits);
    let mut steps = Vec::new();
    for places in (0..u32::BITS).rev().map(|k| u64::from(step) << k) {
        let Some(places) = u32::try_from(places).ok().filter(|places| *places < bits) else {
            continue;
        };
        let top = b.slice(word, bits - places, places);
        let empty = b.equal(top, zero);
        let low = b.slice(word, 0, bits - places);
        let zeros = b.checked(Format::integer(places));
        let zeros = b.constant(0, zeros);
        let shifted = b.concat(low, zeros);
        word = b.mux(empty, shifted, word);
        steps.push(empty);
    }
    (word, word_of(b, &steps))
}

/// The quotient to half an ulp of `output`, a sticky bit for the remainder, and a flag for a
/// quotient of at least twice the largest word.
fn digits(
    b: &mut Builder,
    dividend: NodeId,
    divisor: NodeId,
    output: Format,
    non_restoring: bool,
) -> (NodeId, Option<NodeId>) {
    let (of_a, of_d) = (b.format(dividend), b.format(divisor));
    // The quotient is in half ulps of the output: a * 2^places / d on words.
    let places = output.frac_bits() + 1 + of_d.frac_bits() - of_a.frac_bits();
    let appended = u32::try_from(places).unwrap_or(0);
    let mut word = b.slice(divisor, 0, of_d.bits());
    if places < 0 {
        let zeros = b.checked(Format::integer(places.unsigned_abs()));
        let zeros = b.constant(0, zeros);
        word = b.concat(word, zeros);
    }
    let divisor = word;
    let bits = b.format(divisor).bits();
    let total = of_a.bits() + appended;
    // One bit for half an ulp, and one above the output's.
    let steps = (output.bits() - u32::from(output.is_signed()) + 2).min(total);

    // 0 <= rest < divisor; otherwise the quotient has a bit above those of the steps.
    let head: Vec<NodeId> =
        (steps..total).rev().map(|i| bit_of(b, dividend, appended, i)).collect();
    let one = b.constant(1, Format::FLAG);
    let integer = b.checked(Format::integer(bits));
    let (mut rest, past) = if head.is_empty() {
        (b.constant(0, integer), None)
    } else {
        let head = word_of(b, &head);
        let inside = b.less(head, divisor);
        let past = b.xor(inside, one);
        let zero = b.constant(0, integer);
        let wide = b.concat(zero, head);
        (b.slice(wide, 0, bits), Some(past))
    };
    let mut quotient = Vec::new();
    if non_restoring {
        // -divisor <= rest < divisor: `bits` bits and a sign.
        let (signed, wide) = (Format::signed(bits + 1, 0), Format::signed(bits + 2, 0));
        let (signed, wide) = (b.checked(signed), b.checked(wide));
        rest = b.modulo(rest, signed);
        let mut below = b.constant(0, Format::FLAG);
        for i in (0..steps).rev() {
            let pattern = b.slice(rest, 0, bits + 1);
            let bit = bit_of(b, dividend, appended, i);
            let twice = b.concat(pattern, bit);
            let twice = b.modulo(twice, wide);
            let ahead = b.xor(below, one);
            let next = b.addsub(ahead, twice, divisor);
            rest = b.modulo(next, signed);
            below = b.negative(rest);
            quotient.push(b.xor(below, one));
        }
        let restored = b.add(rest, divisor);
        rest = b.mux(below, restored, rest);
    } else {
        for i in (0..steps).rev() {
            let bit = bit_of(b, dividend, appended, i);
            let twice = b.concat(rest, bit);
            let difference = b.sub(twice, divisor);
            let below = b.negative(difference);
            let next = b.mux(below, twice, difference);
            rest = b.slice(next, 0, bits);
            quotient.push(b.xor(below, one));
        }
    }
    quotient.push(sticky(b, rest));
    let quotient = word_of(b, &quotient);
    (b.shift(quotient, -(output.frac_bits() + 2)), past)
}

/// Shifts dividend and divisor by the same places, so that the divisor has its top bit set, and
/// multiplies the dividend by the table's reciprocal. The dividend saturates where the quotient
/// does.
fn normalised(
    b: &mut Builder,
    dividend: NodeId,
    divisor: NodeId,
    output: Format,
    spec: &Spec<'_>,
) -> NodeId {
    let (of_a, of_d) = (b.format(dividend), b.format(divisor));
    let bits = of_d.bits();
    let (mantissa, places) = normalise(b, divisor, 1);
    let argument = b.slice(mantissa, 0, bits - 1);
    let argument = b.shift(argument, -cast::signed_count(bits));
    let recip = table::emit(b, spec, argument)[0]; // 1 < recip <= 2
    let shifted = b.shift_left(dividend, places, bits);
    let shifted = b.shift(shifted, of_d.frac_bits() - cast::signed_count(bits));
    // As recip is above 1, a dividend of 2^int_bits is already out of the output's range.
    let frac = of_a.frac_bits() + cast::signed_count(bits) - of_d.frac_bits();
    let kept = (output.int_bits() + 1 + frac).max(1).unsigned_abs();
    let kept = if kept < of_a.bits() + bits {
        let format = b.checked(Format::unsigned(kept, frac));
        b.narrow(shifted, format, Round::Floor, Overflow::Saturate)
    } else {
        shifted
    };
    b.mul(kept, recip)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::netlist::{Netlist, Quantity};
    use crate::number::function::Function;
    use crate::table::Scheme;

    /// `n / d` rounded to an integer, independent of `narrow`.
    pub(crate) fn rounded(n: i128, d: i128, round: Round) -> i128 {
        let (n, d) = (n * d.signum(), d.abs());
        let (floor, rest) = (n.div_euclid(d), n.rem_euclid(d));
        let up = match round {
            Round::Floor => false,
            Round::TowardZero => n < 0 && rest > 0,
            Round::HalfUp => 2 * rest >= d,
            Round::HalfAway => 2 * rest > d || (2 * rest == d && n >= 0),
            Round::HalfEven => 2 * rest > d || (2 * rest == d && floor % 2 != 0),
        };
        floor + i128::from(up)
    }

    fn divider(a: Format, d: Format, output: Format, round: Round, method: &Method<'_>) -> Netlist {
        let mut b = Builder::new("divider");
        let ports = [("a", a), ("d", d)].map(|(name, f)| b.input(name, f, Quantity::Number));
        let quotient = divide(&mut b, "quotient", ports, output, round, method);
        b.output("q", quotient);
        b.build().unwrap()
    }

    fn format(text: &str) -> Format {
        text.parse().unwrap()
    }

    fn words(format: Format) -> std::ops::RangeInclusive<i64> {
        format.min_raw()..=format.max_raw()
    }

    fn result(netlist: &Netlist, inputs: [i64; 2]) -> i64 {
        netlist.eval(&inputs).unwrap().0[netlist.outputs()[0].node.index()]
    }

    /// Dividend and divisor as integers on a common scale, times 2^frac_bits of the output.
    fn ratio([a, d]: [i64; 2], of: [Format; 2], output: Format) -> (i128, i128) {
        let places = output.frac_bits() + of[1].frac_bits() - of[0].frac_bits();
        let up = |x: i64, places: i32| i128::from(x) << places.max(0);
        (up(a, places), up(d, -places))
    }

    #[test]
    fn digits_are_correctly_rounded_for_every_word() {
        for (a, d, output) in [
            ("s6f4", "u5f3", "s7f4"),
            ("s5f4", "s5f2", "s6f3"),
            ("u5f0", "u4f0", "u5f0"),
            ("u4f4", "s5f0", "s9f6"),
            ("u6f0", "u3f3", "u4e2"),
            ("s5f2", "u1f0", "s4f1"),
        ] {
            let (a, d, output) = (format(a), format(d), format(output));
            for round in Round::ALL {
                for method in [Method::Restoring, Method::NonRestoring] {
                    let netlist = divider(a, d, output, *round, &method);
                    assert_eq!(netlist.counts().dividers, 1);
                    assert_eq!(netlist.counts().datapath, Default::default());
                    for (x, y) in words(a).flat_map(|x| words(d).map(move |y| (x, y))) {
                        let (n, m) = ratio([x, y], [a, d], output);
                        let exact = match (n, m) {
                            (0, 0) => 0,
                            (n, 0) => n.signum() << 40,
                            (n, m) => rounded(n, m, *round),
                        };
                        let (lo, hi) = (output.min_raw().into(), output.max_raw().into());
                        let is = i128::from(result(&netlist, [x, y]));
                        assert_eq!(
                            is,
                            exact.clamp(lo, hi),
                            "{x} {a} / {y} {d}: {method:?} {round}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn tables_are_within_the_stated_error_for_every_word() {
        for scheme in Scheme::ALL {
            for (a, d, output) in
                [("s7f5", "u7f5", "s9f6"), ("s6f5", "s6f2", "s8f5"), ("u8f0", "u5f0", "u9f1")]
            {
                let (a, d, output) = (format(a), format(d), format(output));
                let spec = Spec {
                    name: "recip",
                    functions: &[Function::recip()],
                    scheme: *scheme,
                    addr_bits: 4,
                    quarter_wave: false,
                    origin: 0.5,
                    output: format("u12f10"),
                    round: Round::HalfUp,
                };
                // The table's own worst error, from its words.
                let mut b = Builder::new("table");
                let argument = argument(d).unwrap();
                let port = b.input("x", argument, Quantity::Number);
                let node = table::emit(&mut b, &spec, port)[0];
                b.output("y", node);
                let table = b.build().unwrap();
                let worst = words(argument)
                    .map(|x| {
                        let word = table.eval(&[x]).unwrap().0[table.outputs()[0].node.index()];
                        (spec.output.value(word) - 1.0 / (0.5 + argument.value(x))).abs()
                    })
                    .fold(0.0, f64::max);

                let netlist = divider(a, d, output, Round::HalfEven, &Method::Table(spec));
                for (x, y) in words(a).flat_map(|x| words(d).map(move |y| (x, y))) {
                    let is = output.value(result(&netlist, [x, y]));
                    let (lo, hi) = (output.value(output.min_raw()), output.value(output.max_raw()));
                    let exact = if x == 0 { 0.0 } else { a.value(x) / d.value(y) };
                    let bound = exact.abs() * worst + 0.5 * output.ulp();
                    let held = exact.is_infinite() || (is - exact.clamp(lo, hi)).abs() <= bound;
                    let held = held && (exact.is_finite() || is == exact.clamp(lo, hi));
                    assert!(held, "{x} {a} / {y} {d}: {is} for {exact} ({scheme})");
                }
            }
        }
    }

    #[test]
    fn on_reals_it_is_the_quotient() {
        let (a, d, output) = (format("s6f4"), format("u5f3"), format("s9f6"));
        let netlist = divider(a, d, output, Round::Floor, &Method::NonRestoring);
        let real = |x: f64, y: f64| netlist.eval_reals(&[x, y])[netlist.outputs()[0].node.index()];
        assert_eq!(real(1.0, 3.0), 1.0 / 3.0);
        assert_eq!(real(0.0, 0.0), 0.0);
        assert_eq!(real(-1.0, 0.0), -f64::MAX);
    }
}
