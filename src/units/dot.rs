//! The three-component dot product, and code shared by the units of vectors in words.

use super::parts::plan::rounding_ulp;
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{Bound, Bounds, Design, Golden, Param, Unit, Values};
use crate::netlist::{Builder, NodeId, Part, Quantity};
use crate::number::format::{Format, Overflow, Round};
use crate::number::trig::Real;

// Products of 26-bit words, and sums of three of them, are exact in an f64, so the golden is exact.

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("dot", "dot product of three: exact products and sums, one rounding")
        .source("the vector dot units of US 6,980,218, FIG. 8, in formats of any width")
        .formula("dot_product = v_x w_x + v_y w_y + v_z w_z")
        .params(params())
        .inputs("v_x, v_y, v_z, w_x, w_y, w_z: two vectors")
        .outputs("dot_product: v·w, rounded; out-of-range results follow overflow")
        .design(design)
}

pub(super) fn v_frac_bits() -> Param {
    Param::bits("v_frac_bits", 0..=28).default(14).help("fraction bits of v")
}

/// Overflow of results. The golden models the first two modes.
pub(super) fn ending_overflow() -> Param {
    Param::overflow("overflow").among([
        Overflow::Saturate,
        Overflow::Symmetric,
        Overflow::Wrap,
        Overflow::Error,
    ])
}

/// Parameters of two input vectors and of the results.
pub(super) fn params() -> [Param; 8] {
    [
        Param::bits("v_bits", 2..=26).default(16).help("bits of the components of v, signed"),
        v_frac_bits(),
        Param::bits("w_bits", 2..=26).default(16).help("bits of the components of w, signed"),
        Param::bits("w_frac_bits", 0..=28).default(14).help("fraction bits of w"),
        Param::bits("out_bits", 2..=63).default(24).help("bits of each result, signed"),
        Param::bits("out_frac_bits", 0..=56).default(18).help("fraction bits of the results"),
        ending_overflow()
            .help("overflow of results; with overflow=saturate or symmetric, the golden is clamped to the same range"),
        Param::rounding("rounding"),
    ]
}

/// `v_x w_x + v_y w_y + v_z w_z`, exact: three multipliers and two adders, in a part called `name`.
/// All dot products of the emboss family are built here, so that schedules can share them.
pub(super) fn dot(b: &mut Builder, name: &str, v: [NodeId; 3], w: [NodeId; 3]) -> NodeId {
    b.part(Part::Dot, name, |b| {
        let [x, y, z] = [0, 1, 2].map(|i| b.mul(v[i], w[i]));
        let sum = b.add(x, y);
        b.add(sum, z)
    })
}

/// The components of a vector as input ports.
pub(super) fn vector_ports(
    b: &mut Builder,
    name: &str,
    format: Format,
    quantity: Quantity,
) -> [NodeId; 3] {
    ["x", "y", "z"].map(|axis| b.input(&format!("{name}_{axis}"), format, quantity))
}

/// A signed format from two parameters.
pub(super) fn signed(values: &Values, bits: &str, frac_bits: &str) -> Result<Format> {
    Format::signed(values.bits(bits), cast::signed_count(values.bits(frac_bits)))
}

/// Format, rounding and overflow of results.
pub(super) fn result(values: &Values) -> Result<(Format, Round, Overflow)> {
    Ok((
        signed(values, "out_bits", "out_frac_bits")?,
        values.rounding("rounding"),
        values.overflow("overflow"),
    ))
}

/// The function that clamps a golden value to the range of the result's format, if that saturates.
pub(super) fn ended<F: Real>(values: &Values) -> impl Fn(F) -> F + Send + Sync + use<F> {
    let bits = cast::signed_count(values.bits("out_bits"));
    let frac_bits = cast::signed_count(values.bits("out_frac_bits"));
    let overflow = values.overflow("overflow");
    move |exact| ended_at(overflow, bits - 1 - frac_bits, frac_bits, exact)
}

/// A value clamped to a signed format with this many integer and fraction bits, if it saturates.
pub(super) fn ended_at<F: Real>(overflow: Overflow, int_bits: i32, frac_bits: i32, exact: F) -> F {
    let two = F::one() + F::one();
    let (limit, ulp) = (two.powi(int_bits), two.powi(-frac_bits));
    match overflow {
        Overflow::Saturate => exact.max(-limit).min(limit - ulp),
        Overflow::Symmetric => exact.max(ulp - limit).min(limit - ulp),
        Overflow::Wrap | Overflow::Error => exact,
    }
}

/// A bound of one rounding, or the reason why none is stated.
pub(super) fn rounding_bounds(values: &Values, quantities: &[&str]) -> Bounds {
    if !ends(values.overflow("overflow")) {
        return Bounds::unstated(UNENDED);
    }
    Bounds::Stated(vec![Bound::new("result", quantities, rounding_bound)])
}

/// True for the overflow modes that the golden models.
pub(super) fn ends(overflow: Overflow) -> bool {
    matches!(overflow, Overflow::Saturate | Overflow::Symmetric)
}

const UNENDED: &str = "with this overflow mode, out-of-range results are far from the golden";

fn rounding_bound(values: &Values, _: &dyn Fn(&str) -> f64) -> f64 {
    rounding_ulp(values) * 2f64.powi(-cast::signed_count(values.bits("out_frac_bits")))
}

fn design(values: &Values) -> Result<Design> {
    let mut b = values.builder("dot");
    let v = signed(values, "v_bits", "v_frac_bits")?;
    let v = vector_ports(&mut b, "v", v, Quantity::Number);
    let w = signed(values, "w_bits", "w_frac_bits")?;
    let w = vector_ports(&mut b, "w", w, Quantity::Number);
    let (format, round, overflow) = result(values)?;
    let exact = dot(&mut b, "v_dot_w", v, w);
    let word = b.narrow(exact, format, round, overflow);
    b.output("dot_product", word);
    Ok(Design::new(values, b.build()?)
        .goldens(golden::<f64>, golden::<f32>)
        .bounds(rounding_bounds(values, &["dot_product"])))
}

fn golden<F: Real>(values: &Values) -> Golden<F> {
    let ended = ended(values);
    Golden::each(move |[vx, vy, vz, wx, wy, wz]: [F; 6]| {
        [ended(F::zero() + vx * wx + vy * wy + vz * wz)]
    })
}
