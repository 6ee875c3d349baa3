//! Block normalisation: the words of a vector are shifted up by one common number of places, until
//! the largest component has no leading zero.
//!
//! The normalised direction doesn't depend on the vector's size, so positions may span a large
//! range: the direction keeps as many bits next to a light as far away.

use super::dot::{dot, signed, vector_ports};
use super::parts::divide;
use super::parts::plan::rounding_ulp;
use super::parts::polar::in_one_format;
use super::rsqrt::Root;
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{Bound, Bounds, Design, Golden, Param, Unit, Values};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::format::{Format, Overflow, Round};
use crate::number::trig::Real;

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("normalise", "block normalisation: three words shifted by the leading zeros of the largest")
        .source("the light vector of US 6,980,218 in fixed point: a displacement doesn't depend on its length")
        .formula(
            "x, y, z = v_x, v_y, v_z times 2^places / 2^(v_bits-v_frac_bits): the largest of them in size is from 1/2 to below 1",
        )
        .params([
            Param::bits("v_bits", 2..=32).default(16).help("bits of the components, signed"),
            super::dot::v_frac_bits().default(8),
            norm_bits(),
            Param::rounding("rounding"),
        ])
        .inputs("v_x, v_y, v_z: the vector")
        .outputs("x, y, z: v divided by the smallest power of two above its largest |component| (or equal to it for the most negative word); places: number of places that the words were shifted up; degenerate: 1 for the zero vector, for which the words and places are 0")
        .design(design)
}

pub(super) fn norm_bits() -> Param {
    Param::bits("norm_bits", 2..=24)
        .default(18)
        .help("bits of block-normalised words, from -1 to 1; the largest is ½ or more in magnitude")
}

/// A vector divided by a power of two.
pub(super) struct Block {
    /// Its words, from -1 to 1: signed, with fraction bits only, exact.
    pub(super) words: [NodeId; 3],
    /// Number of places that they were shifted up; undefined for the zero vector.
    places: NodeId,
    /// Flag: the zero vector.
    pub(super) zero: NodeId,
}

/// Shifts three words of one format up by their common number of leading zeros.
pub(super) fn block(b: &mut Builder, name: &str, v: [NodeId; 3]) -> Block {
    b.scope(name, |b| {
        let format = b.format(v[0]);
        let v = in_one_format(b, format, v);
        let bits = format.bits();
        // The largest component has as many leading zeros as the OR of all magnitudes.
        let [x, y, z] = v.map(|x| {
            let magnitude = b.abs(x); // up to 2^(bits - 1), which is representable
            b.slice(magnitude, 0, bits)
        });
        let any = b.or(x, y);
        let any = b.or(any, z);
        let largest = b.shift(any, -format.frac_bits());
        b.means(largest, v, |[x, y, z]| x.abs().max(y.abs()).max(z.abs()));
        b.name(largest, "largest");
        let (_, count) = divide::normalise(b, largest, 1);
        let top = cast::signed_count(bits) - format.frac_bits();
        // Shifted to 2^(top - 1) or above, below 2^top; 0 for 0.
        let places = b.means(count, [largest], |[a]| {
            a.equal(0.0).select(0.0, f64::from(top - 1) - a.exponent())
        });
        b.name(places, "places");
        let zero = b.constant(0, Format::FLAG);
        let zero = b.equal(largest, zero);
        let signed = Format::signed(bits + 1, 0);
        let signed = b.checked(signed);
        let words = [0, 1, 2].map(|i| {
            let sign = b.negative(v[i]);
            let pattern = b.slice(v[i], 0, bits);
            let mut word = b.concat(sign, pattern);
            for k in (0..b.format(count).bits()).rev() {
                let empty = b.slice(count, k, 1);
                let low = b.slice(word, 0, bits + 1 - (1 << k));
                let zeros = b.checked(Format::integer(1 << k));
                let zeros = b.constant(0, zeros);
                let shifted = b.concat(low, zeros);
                word = b.mux(empty, shifted, word);
            }
            let word = b.modulo(word, signed);
            let word = b.shift(word, -cast::signed_count(bits));
            b.means(word, [v[i], places], |[a, places]| a * (places + f64::from(-top)).exp2());
            b.name(word, ["x", "y", "z"][i])
        });
        Block { words, places, zero }
    })
}

/// The words in fewer bits: from -1 to 1, the largest still at least ½ in magnitude.
pub(super) fn narrowed(
    b: &mut Builder,
    name: &str,
    words: [NodeId; 3],
    norm_bits: u32,
    round: Round,
) -> [NodeId; 3] {
    let format = Format::signed(norm_bits, cast::signed_count(norm_bits) - 1);
    let format = b.checked(format);
    [0, 1, 2].map(|i| {
        let word = b.narrow(words[i], format, round, Overflow::Saturate);
        b.name(word, &format!("{name}_{}", ["x", "y", "z"][i]))
    })
}

/// Length of the difference between the narrowed direction and the exact one, both as unit vectors.
/// It is at most the difference of the words divided by the shorter length, which is at least ½.
/// Rounded to nearest, a word is off by half an ulp. Where 1 isn't representable it is off by one
/// ulp; then the length is at least 1 less an ulp.
pub(super) fn direction_error(values: &Values) -> f64 {
    let ulp = 2f64.powi(1 - cast::signed_count(values.bits("norm_bits")));
    let off = 3f64.sqrt() * ulp;
    let error = if rounding_ulp(values) <= 0.5 { off / (1.0 - ulp) } else { off / 0.5 };
    error.min(2.0)
}

/// A vector divided by its length, in a signed format that holds 1, and the flag for the zero
/// vector, which stays 0. It takes block normalisation, a reciprocal root, and a product for each
/// component.
pub(super) fn unit_vector(
    b: &mut Builder,
    root: &mut Root<'_>,
    name: &str,
    v: [NodeId; 3],
    format: Format,
) -> Result<([NodeId; 3], NodeId)> {
    let Block { words, zero, .. } = block(b, name, v);
    let words = narrowed(b, &format!("{name}_norm"), words, root.norm_bits, root.round);
    let square = dot(b, &format!("{name}_square"), words, words);
    let factor = root.of_square(b, &format!("{name}_length"), square)?;
    let unit = words.map(|word| {
        let exact = b.mul(word, factor); // -1 to 1, except for errors
        b.narrow(exact, format, root.round, Overflow::Saturate)
    });
    for (word, axis) in unit.iter().zip(["x", "y", "z"]) {
        b.name(*word, &format!("{name}_unit_{axis}"));
    }
    Ok((unit, zero))
}

fn design(values: &Values) -> Result<Design> {
    let mut b = values.builder("normalise");
    let format = signed(values, "v_bits", "v_frac_bits")?;
    let v = vector_ports(&mut b, "v", format, Quantity::Number);
    let Block { words, places, zero } = block(&mut b, "block", v);
    let round = values.rounding("rounding");
    let words = narrowed(&mut b, "norm", words, values.bits("norm_bits"), round);
    for (word, name) in words.into_iter().zip(["x", "y", "z"]) {
        b.output(name, word);
    }
    let none = b.constant(0, Format::FLAG);
    let places = b.mux(zero, none, places);
    b.output("places", places);
    b.output("degenerate", zero);
    Ok(Design::new(values, b.build()?).goldens(golden::<f64>, golden::<f32>).bounds(
        Bounds::Stated(vec![
            Bound::new("component", ["x", "y", "z"], component_bound),
            Bound::new("count and flag", ["places", "degenerate"], |_, _| 0.0),
        ]),
    ))
}

/// One rounding; one ulp where 1 would be the result and isn't representable.
fn component_bound(values: &Values, _: &dyn Fn(&str) -> f64) -> f64 {
    rounding_ulp(values).max(1.0) * 2f64.powi(1 - cast::signed_count(values.bits("norm_bits")))
}

fn golden<F: Real>(values: &Values) -> Golden<F> {
    let two = F::one() + F::one();
    let bits = cast::signed_count(values.bits("v_bits"));
    let frac_bits = cast::signed_count(values.bits("v_frac_bits"));
    Golden::each(move |v: [F; 3]| {
        let largest = v.iter().fold(F::zero(), |most, x| most.max(x.abs()));
        let zero = largest == F::zero();
        // 2^(exponent - 1) <= largest < 2^exponent
        let (mantissa, shift, _) = largest.integer_decode();
        let exponent = if zero {
            bits - frac_bits
        } else {
            i32::from(shift) + cast::signed_count(u64::BITS - mantissa.leading_zeros())
        };
        let [x, y, z] = v.map(|x| x / two.powi(exponent));
        let places = F::from(bits - frac_bits - exponent).expect("bug: a small number");
        [x, y, z, places, if zero { F::one() } else { F::zero() }]
    })
}
