//! Square roots and reciprocal square roots: by digit recurrence, by tables, and by a table with a
//! Newton step.

use super::divide::{bit_of, limit, normalise, sticky, word_of};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::netlist::{Builder, NodeId, Part};
use crate::number::format::{Format, Overflow, Round, bit_len};
use crate::table::{self, Spec};

/// How a square root is computed.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Method<'a> {
    /// Digit by digit: a subtractor and a multiplexer each. Correctly rounded in every mode.
    Digits,
    /// A table of the root of the normalised operand.
    Table(Table<'a>),
}

/// A table of a function of the operand, which is shifted by an even number of places to at least
/// ¼.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Table<'a> {
    /// Its specification; the argument is [`argument`], the origin is ¼.
    pub(crate) spec: Spec<'a>,
    /// Bits kept of the shifted operand, at least 4; lower bits are dropped.
    pub(crate) kept_bits: u32,
}

/// Square root of an unsigned word in format `output`; results out of range saturate.
///
/// With a table, the result is off by twice the root times the sum of the table's worst error and
/// `2^-kept_bits`, before the one rounding.
///
/// # Panics
/// If the word is signed, which is a bug.
pub(crate) fn root(
    b: &mut Builder,
    name: &str,
    a: NodeId,
    output: Format,
    round: Round,
    method: &Method<'_>,
) -> NodeId {
    b.part(Part::SquareRoot, name, |b| {
        let exact = match method {
            Method::Digits => digits(b, a, output),
            Method::Table(table) => {
                let Normalised { table, half_places, half_bits, frac_bits, .. } =
                    normalised(b, a, table);
                // sqrt(m * 2^(bits - places)): shift by half of that.
                let most = b.checked(Format::integer(bit_len(u64::from(half_bits))));
                let most = b.constant(i64::from(half_bits), most);
                let left = b.sub(most, half_places);
                let left = b.slice(left, 0, bit_len(u64::from(half_bits)));
                let shifted = b.shift_left(table, left, half_bits);
                let shifted = b.shift(shifted, -frac_bits / 2);
                let zero = b.constant(0, Format::FLAG);
                let of_zero = b.equal(a, zero);
                b.mux(of_zero, zero, shifted)
            }
        };
        let root = b.narrow(exact, output, round, Overflow::Saturate);
        b.means(root, [a], |[a]| a.max(0.0).sqrt())
    })
}

/// 1 / square root of an unsigned word in format `output`, from a table for the normalised operand.
/// Results out of range saturate, including 1/sqrt(0). Off by the result times the sum of the
/// table's worst error and `4 * 2^-kept_bits`, before the one rounding. With a Newton step of this
/// many fraction bits, [`newton_error`] replaces the table's error.
///
/// # Panics
/// If the word is signed, which is a bug.
pub(crate) fn reciprocal_root(
    b: &mut Builder,
    name: &str,
    a: NodeId,
    output: Format,
    round: Round,
    table: &Table<'_>,
    newton: Option<u32>,
) -> NodeId {
    b.part(Part::ReciprocalRoot, name, |b| {
        let Normalised { table, m, half_places, half_bits, frac_bits } = normalised(b, a, table);
        let table = match newton {
            None => table,
            Some(frac_bits) => step(b, m, table, frac_bits, round),
        };
        let shifted = b.shift_left(table, half_places, half_bits);
        let shifted = b.shift(shifted, frac_bits / 2 - cast::signed_count(half_bits));
        let limit = limit(b, output);
        let zero = b.constant(0, Format::FLAG);
        let of_zero = b.equal(a, zero);
        let exact = b.mux(of_zero, limit, shifted);
        let root = b.narrow(exact, output, round, Overflow::Saturate);
        // The largest f64 at 0, just as words saturate.
        b.means(root, [a], |[a]| (1.0 / a.max(0.0).sqrt()).min(f64::MAX))
    })
}

/// A Newton step: `y (3 - m y²) / 2` for y near 1/sqrt(m) and ¼ <= m < 1.
fn step(b: &mut Builder, m: NodeId, y: NodeId, frac_bits: u32, round: Round) -> NodeId {
    let format = Format::unsigned(2 + frac_bits, cast::signed_count(frac_bits));
    let format = b.checked(format); // 0 <= x < 4
    let product = b.mul(m, y); // below 2, about sqrt(m)
    let product = b.narrow(product, format, round, Overflow::Saturate);
    let square = b.mul(product, y); // about 1
    let two = b.checked(Format::integer(2));
    let three = b.constant(3, two);
    let rest = b.sub(three, square); // about 2
    let rest = b.narrow(rest, format, round, Overflow::Saturate);
    let twice = b.mul(y, rest);
    let next = b.shift(twice, -1);
    b.narrow(next, format, round, Overflow::Saturate)
}

/// Largest relative error of a Newton step. It starts from a table with this worst error, and has
/// this many fraction bits and roundings of this fraction of an ulp.
///
/// `y = Y (1 + e)` with Y = 1/sqrt(m) from 1 to 2 gives `Y (1 - 1.5 e² - 0.5 e³)`. The product m y
/// is off by one rounding, so its product with y is off by y roundings. The difference adds one,
/// and half of y multiplies them: y (y + 1) / 2 roundings, plus the last one.
pub(crate) fn newton_error(worst: f64, frac_bits: u32, rounding: f64) -> f64 {
    let ulp = rounding * 2f64.powi(-cast::signed_count(frac_bits));
    let y = 2.0 + worst;
    (1.5 + 0.5 * worst) * worst * worst + (0.5 * y * (y + 1.0) + 1.0) * ulp
}

/// Format of the tables' argument: the shifted operand less ¼.
///
/// # Errors
/// If it needs more than 63 bits.
pub(crate) fn argument(operand: Format, kept_bits: u32) -> Result<Format> {
    Format::turns(even_bits(operand).0.min(kept_bits))
}

/// An even number of bits, at least 4, and an even number of fraction bits, for an operand.
fn even_bits(operand: Format) -> (u32, i32) {
    let odd = u32::from(operand.frac_bits() % 2 != 0);
    let bits = (operand.bits() + odd).max(4);
    (bits + bits % 2, operand.frac_bits() + cast::signed_count(odd))
}

/// An operand `m * 2^(2 * (half_bits - half_places) - frac_bits)` with ¼ <= m < 1.
struct Normalised {
    /// The table's word for m.
    table: NodeId,
    /// m in the bits kept.
    m: NodeId,
    half_places: NodeId,
    half_bits: u32,
    frac_bits: i32,
}

/// The operand of a root; a signed one is an error in formats given by name.
fn unsigned(b: &mut Builder, a: NodeId) -> NodeId {
    let format = b.format(a);
    if !format.is_signed() {
        return a;
    }
    b.fail(Error::usage(format!(
        "the operand of a root has the signed format {format}: give it an unsigned one"
    )));
    b.abs(a)
}

fn normalised(b: &mut Builder, a: NodeId, table: &Table<'_>) -> Normalised {
    let a = unsigned(b, a);
    let format = b.format(a);
    let (bits, frac_bits) = even_bits(format);
    let mut word = b.slice(a, 0, format.bits());
    if frac_bits != format.frac_bits() {
        let zero = b.constant(0, Format::FLAG);
        word = b.concat(word, zero);
    }
    let missing = bits - b.format(word).bits();
    if missing > 0 {
        let zeros = b.checked(Format::integer(missing));
        let zeros = b.constant(0, zeros);
        word = b.concat(zeros, word);
    }
    let (mantissa, half_places) = normalise(b, word, 2);
    // Less ¼: one less in the top two bits, which are 01 to 11.
    let top = b.slice(mantissa, bits - 2, 2);
    let one = b.constant(1, Format::FLAG);
    let top = b.sub(top, one);
    let top = b.slice(top, 0, 2);
    let kept = bits.min(table.kept_bits);
    let low = b.slice(mantissa, bits - kept, kept - 2);
    let m = b.slice(mantissa, bits - kept, kept);
    let m = b.shift(m, -cast::signed_count(kept));
    let argument = b.concat(top, low);
    let argument = b.shift(argument, -cast::signed_count(kept));
    let table = table::emit(b, &table.spec, argument)[0];
    Normalised { table, m, half_places, half_bits: bits / 2, frac_bits }
}

/// The root to half an ulp of `output` or finer, and a sticky bit for the remainder.
fn digits(b: &mut Builder, a: NodeId, output: Format) -> NodeId {
    let a = unsigned(b, a);
    let format = b.format(a);
    // The root is in units of 2^-frac, its square in 2^-2frac: no bit of the operand lies below
    // that.
    let frac = (output.frac_bits() + 1).max((format.frac_bits() + 1).div_euclid(2));
    let appended = (2 * frac - format.frac_bits()).unsigned_abs();
    let steps = (format.bits() + appended).div_ceil(2);
    let one = b.constant(1, Format::FLAG);
    let mut quotient: Option<NodeId> = None;
    let mut rest: Option<NodeId> = None;
    for step in 0..steps {
        let low = 2 * (steps - 1 - step);
        let pair = [low + 1, low].map(|i| bit_of(b, a, appended, i));
        let mut four = word_of(b, &pair);
        if let Some(rest) = rest {
            four = b.concat(rest, four); // 0 <= four < 2^(step + 4)
        }
        // (2q + 1)² - (2q)² = 4q + 1
        let zero = b.constant(0, Format::FLAG);
        let trial = match quotient {
            None => one,
            Some(quotient) => word_of(b, &[quotient, zero, one]),
        };
        let difference = b.sub(four, trial);
        let below = b.negative(difference);
        let next = b.mux(below, four, difference);
        rest = Some(b.slice(next, 0, step + 2)); // 0 <= rest <= 2 * quotient < 2^(step + 2)
        let digit = b.xor(below, one);
        quotient = Some(match quotient {
            None => digit,
            Some(quotient) => b.concat(quotient, digit),
        });
    }
    let (quotient, rest) = quotient.zip(rest).expect("bug: a word has bits");
    let left = sticky(b, rest);
    let word = b.concat(quotient, left);
    b.shift(word, -(frac + 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::netlist::{Netlist, Quantity};
    use crate::number::function::Function;
    use crate::table::Scheme;

    fn format(text: &str) -> Format {
        text.parse().unwrap()
    }

    fn netlist(a: Format, body: impl FnOnce(&mut Builder, NodeId) -> NodeId) -> Netlist {
        let mut b = Builder::new("roots");
        let a = b.input("a", a, Quantity::Number);
        let root = body(&mut b, a);
        b.output("r", root);
        b.build().unwrap()
    }

    fn result(netlist: &Netlist, word: i64) -> i64 {
        netlist.eval(&[word]).unwrap().0[netlist.outputs()[0].node.index()]
    }

    /// Half the root of `n`, rounded to an integer, in integer arithmetic only.
    fn rounded(n: i128, round: Round) -> i128 {
        let halves = n.isqrt();
        let (floor, exact) = (halves / 2, halves * halves == n);
        let up = match (halves % 2, exact, round) {
            (_, _, Round::Floor | Round::TowardZero) | (0, _, _) => false,
            (_, true, Round::HalfEven) => floor % 2 == 1,
            _ => true,
        };
        floor + i128::from(up)
    }

    #[test]
    fn digits_are_correctly_rounded_for_every_word() {
        for (a, output) in [
            ("u12f8", "u8f5"),
            ("u11f7", "u9f6"),
            ("u9f0", "u5f0"),
            ("u10e3", "u8f1"),
            ("u8f9", "u4f2"),
            ("u1f0", "u3f1"),
        ] {
            let (a, output) = (format(a), format(output));
            for round in Round::ALL {
                let netlist =
                    netlist(a, |b, a| root(b, "root", a, output, *round, &Method::Digits));
                assert_eq!(netlist.counts().square_roots, 1);
                for word in a.min_raw()..=a.max_raw() {
                    // 4 * operand * 2^(2 frac_bits): its root is in half ulps.
                    let places = 2 * output.frac_bits() + 2 - a.frac_bits();
                    let exact = if places >= 0 {
                        rounded(i128::from(word) << places, *round)
                    } else {
                        rounded_below(word, places, *round)
                    };
                    let is = i128::from(result(&netlist, word));
                    assert_eq!(is, exact.min(output.max_raw().into()), "{word} {a} {round}");
                }
            }
        }
    }

    /// A search, for operands with bits below those of the result's square.
    fn rounded_below(word: i64, places: i32, round: Round) -> i128 {
        // Largest h with h² <= word * 2^places, and whether it is equal.
        let scale = 1i128 << -places;
        let n = i128::from(word);
        let halves = (0..).take_while(|h: &i128| h * h * scale <= n).last().unwrap();
        let exact = halves * halves * scale == n;
        let floor = halves / 2;
        let up = match (halves % 2, exact, round) {
            (_, _, Round::Floor | Round::TowardZero) | (0, _, _) => false,
            (_, true, Round::HalfEven) => floor % 2 == 1,
            _ => true,
        };
        floor + i128::from(up)
    }

    fn table(functions: &[Function], scheme: Scheme, kept_bits: u32) -> Table<'_> {
        let spec = Spec {
            name: "roots",
            functions,
            scheme,
            addr_bits: 5,
            quarter_wave: false,
            origin: 0.25,
            output: "u14f12".parse().unwrap(),
            round: Round::HalfUp,
        };
        Table { spec, kept_bits }
    }

    /// Worst error of a table over the mantissas from ¼ to 1.
    fn worst(table: &Table<'_>, operand: Format) -> f64 {
        let (argument, spec) = (argument(operand, table.kept_bits).unwrap(), table.spec);
        let table = netlist(argument, |b, a| table::emit(b, &spec, a)[0]);
        let errors = (argument.min_raw()..=argument.max_raw()).filter_map(|word| {
            let m = 0.25 + argument.value(word);
            let is = spec.output.value(result(&table, word));
            (m < 1.0).then(|| (is - spec.functions[0].eval(m)).abs())
        });
        errors.fold(0.0, f64::max)
    }

    #[test]
    fn tables_are_within_the_stated_error_for_every_word() {
        for (scheme, kept) in Scheme::ALL.iter().flat_map(|scheme| [4, 7, 63].map(|k| (scheme, k)))
        {
            let dropped = 2f64.powi(-cast::signed_count(kept));
            for (a, output) in
                [("u12f8", "u12f9"), ("u11f7", "u9f6"), ("u9f0", "u6f1"), ("u3f1", "u8f6")]
            {
                let (a, output) = (format(a), format(output));
                let (max, half_ulp) = (output.value(output.max_raw()), 0.5 * output.ulp());
                let (sqrt, recip_sqrt) = ([Function::sqrt()], [Function::recip_sqrt()]);
                let roots = table(&sqrt, *scheme, kept);
                let method = Method::Table(roots);
                let direct =
                    netlist(a, |b, a| root(b, "root", a, output, Round::HalfEven, &method));
                let reciprocals = table(&recip_sqrt, *scheme, kept);
                let inverse = netlist(a, |b, a| {
                    reciprocal_root(b, "inverse", a, output, Round::HalfEven, &reciprocals, None)
                });
                assert_eq!(inverse.counts().reciprocal_roots, 1);
                let (error, inverse_error) = (worst(&roots, a), worst(&reciprocals, a));
                for word in a.min_raw()..=a.max_raw() {
                    let exact = a.value(word).sqrt();
                    let is = output.value(result(&direct, word));
                    let bound = 2.0 * exact * (error + dropped) + half_ulp;
                    assert!((is - exact.min(max)).abs() <= bound, "{word} {a}: {is} for {exact}");
                    let is = output.value(result(&inverse, word));
                    if word == 0 {
                        assert_eq!(is, max);
                        continue;
                    }
                    let bound = (inverse_error + 4.0 * dropped) / exact + half_ulp;
                    let exact = 1.0 / exact;
                    assert!((is - exact.min(max)).abs() <= bound, "{word} {a}: {is} for {exact}");
                }
            }
        }
    }

    /// For every word and every rounding, with tables of several sizes.
    #[test]
    fn newton_steps_are_within_the_stated_error_for_every_word() {
        for (addr_bits, frac_bits) in [(2, 12), (3, 10), (5, 14), (6, 20), (4, 3)] {
            for (a, output, kept) in [
                ("u12f8", "u14f10", 63),
                ("u11f7", "u9f6", 63),
                ("u12f12", "u16f9", 7),
                ("u3f1", "u8f6", 4),
            ] {
                let (a, output) = (format(a), format(output));
                let max = output.value(output.max_raw());
                for round in Round::ALL {
                    let recip_sqrt = [Function::recip_sqrt()];
                    let mut table = table(&recip_sqrt, Scheme::Direct, kept);
                    table.spec.addr_bits = addr_bits;
                    let inverse = netlist(a, |b, a| {
                        let newton = Some(frac_bits);
                        reciprocal_root(b, "inverse", a, output, *round, &table, newton)
                    });
                    let nearest = !matches!(round, Round::Floor | Round::TowardZero);
                    let rounding = if nearest { 0.5 } else { 1.0 };
                    let dropped = 4.0 * 2f64.powi(-cast::signed_count(kept));
                    let error = newton_error(worst(&table, a), frac_bits, rounding);
                    for word in a.min_raw()..=a.max_raw() {
                        let is = output.value(result(&inverse, word));
                        if word == 0 {
                            assert_eq!(is, max);
                            continue;
                        }
                        let exact = 1.0 / a.value(word).sqrt();
                        // The step's own error is relative to the kept bits.
                        let bound = ((1.0 + error) * (1.0 + dropped) - 1.0) * exact;
                        let bound = bound + rounding * output.ulp();
                        let off = (is - exact.min(max)).abs();
                        assert!(off <= bound, "{word} {a} {round}: {is} for {exact}");
                    }
                }
            }
        }
    }

    #[test]
    fn on_reals_they_are_the_roots() {
        let (a, output) = (format("u8f4"), format("u8f4"));
        let direct = netlist(a, |b, a| root(b, "root", a, output, Round::Floor, &Method::Digits));
        let real =
            |netlist: &Netlist, x| netlist.eval_reals(&[x])[netlist.outputs()[0].node.index()];
        assert_eq!(real(&direct, 2.0), 2f64.sqrt());
        let recip_sqrt = [Function::recip_sqrt()];
        let table = table(&recip_sqrt, Scheme::Linear, 63);
        let inverse =
            netlist(a, |b, a| reciprocal_root(b, "inverse", a, output, Round::Floor, &table, None));
        assert_eq!(real(&inverse, 4.0), 0.5);
        assert_eq!(real(&inverse, 0.0), f64::MAX);
    }
}
