//! The vectors of `GL_NV_texgen_emboss`: a normal and a tangent give a binormal and a tangent, at
//! right angles to the normal and to each other.
//!
//! `B = N x CT, BN = B/|B|, T = BN x N`. CT may have any length: BN doesn't depend on it, so the
//! normalisation of CT in the specification needs no hardware. If N is parallel to CT, or either is
//! 0, then B = 0. In that case BN and T are 0, nothing is displaced, and `degenerate` is 1.

use super::cross::cross;
use super::dot::vector_ports;
use super::normalise::{direction_error, norm_bits, unit_vector};
use super::parts::plan::rounding_ulp;
use super::rsqrt::{Root, length_error, root_addr_bits, root_frac_bits, root_scheme};
use super::vertex;
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{Bound, Bounds, Design, Golden, Group, HardCase, Param, Shape, Unit, Values};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::format::{Format, Overflow, Round};
use crate::number::trig::Real;

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("basis", "binormal and tangent from normal and tangent: N x CT, normalised, x N")
        .source("GL_NV_texgen_emboss, section 2.10.4")
        .formula(
            "B = N x CT; BN = B/|B|; T = BN x N; both 0 if B is 0",
        )
        .params([
            component_bits(),
            guard_bits().default(0),
            norm_bits(),
            dot_frac_bits(),
            root_scheme(),
            root_addr_bits(),
            root_frac_bits(),
            Param::rounding("rounding"),
        ])
        .inputs("normal_x … normal_z: N in eye space; ct_x … ct_z: CT in eye space, of any length; all from -2 to 2")
        .outputs("t_x … t_z: T; bn_x … bn_z: BN; degenerate: 1 where N is parallel to CT, and T and BN are 0")
        .design(design)
}

pub(super) fn component_bits() -> Param {
    Param::bits("component_bits", 2..=24)
        .default(16)
        .help("bits of vector components, signed, from -2 to 2")
}

pub(super) fn guard_bits() -> Param {
    Param::bits("guard_bits", 0..=8)
        .default(4)
        .help("extra fraction bits of vectors computed from these components")
}

pub(super) fn dot_frac_bits() -> Param {
    Param::bits("dot_frac_bits", 2..=24)
        .default(20)
        .help("fraction bits of dot products, which are rounded to these")
}

/// Format of vector components.
pub(super) fn component(values: &Values) -> Result<Format> {
    let bits = values.bits("component_bits");
    Format::signed(bits, cast::signed_count(bits) - 2)
}

/// Fraction bits of vectors computed from components.
pub(super) fn vector_frac_bits(values: &Values) -> i32 {
    cast::signed_count(values.bits("component_bits") + values.bits("guard_bits")) - 2
}

/// Rounds a word to `frac_bits` fraction bits if it has more. Nothing overflows.
pub(super) fn rounded(b: &mut Builder, exact: NodeId, frac_bits: i32, round: Round) -> NodeId {
    let format = b.format(exact);
    if format.frac_bits() <= frac_bits {
        return exact;
    }
    // One more integer bit for a carry.
    let bits = format.int_bits() + 1 + frac_bits + i32::from(format.is_signed());
    let format = Format::new(format.is_signed(), bits.max(1).unsigned_abs(), frac_bits);
    let format = b.checked(format);
    b.narrow(exact, format, round, Overflow::Saturate)
}

/// T, BN and the flag for B = 0. The flag exists only if B is normalised; otherwise BN = B.
pub(super) fn frame(
    b: &mut Builder,
    root: &mut Root<'_>,
    [n, ct]: [[NodeId; 3]; 2],
    normalise: bool,
) -> Result<([NodeId; 3], [NodeId; 3], Option<NodeId>)> {
    let (frac_bits, round) = (vector_frac_bits(root.values), root.round);
    let exact = cross(b, "n_cross_ct", n, ct);
    let (bn, zero) = if normalise {
        // -2 to 2: 1 is representable.
        let format = Format::signed((frac_bits + 2).unsigned_abs(), frac_bits)?;
        let (bn, zero) = unit_vector(b, root, "bn", exact, format)?;
        (bn, Some(zero))
    } else {
        (exact.map(|x| rounded(b, x, frac_bits, round)), None)
    };
    let exact = cross(b, "bn_cross_n", bn, n);
    let t = exact.map(|x| rounded(b, x, frac_bits, round));
    Ok((t, bn, zero))
}

/// Length of the error of a unit vector: from its direction, from its length, and from rounding.
pub(super) fn unit_error(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    let length = length_error(values, worst);
    direction_error(values) * (1.0 + length) + length + vector_rounding(values)
}

/// Length of the error of rounding a vector.
pub(super) fn vector_rounding(values: &Values) -> f64 {
    3f64.sqrt() * rounding_ulp(values) * 2f64.powi(-vector_frac_bits(values))
}

/// The greatest length of N with components from -2 to 2.
pub(super) fn longest() -> f64 {
    2.0 * 3f64.sqrt()
}

fn design(values: &Values) -> Result<Design> {
    let mut b = values.builder("basis");
    let format = component(values)?;
    let n = vector_ports(&mut b, "normal", format, Quantity::Number);
    let ct = vector_ports(&mut b, "ct", format, Quantity::Number);
    let mut root = Root::new(values);
    let (t, bn, zero) = frame(&mut b, &mut root, [n, ct], true)?;
    // |T| = |N|
    let frac_bits = vector_frac_bits(values);
    let format = Format::signed((frac_bits + 3).unsigned_abs(), frac_bits)?;
    let t = t.map(|x| b.narrow(x, format, root.round, Overflow::Saturate));
    for (vector, name) in [(t, "t"), (bn, "bn")] {
        for (word, axis) in vector.into_iter().zip(["x", "y", "z"]) {
            b.output(&format!("{name}_{axis}"), word);
        }
    }
    b.output("degenerate", zero.expect("bug: BN is normalised"));
    let tabulated = root.tabulated;
    let netlist = b.build()?;
    let vector = |name, from: usize| {
        let words = netlist.outputs()[from..from + 3].iter().map(|output| output.node);
        Group::new(name, Shape::Cartesian, words.collect())
    };
    let mut groups = vec![vector("t", 0), vector("bn", 3)];
    groups.extend(Group::ports(&netlist, ["degenerate"])?);
    let mut hard = vertex::hard_cases(&netlist);
    hard.extend(HardCase::extremes(&netlist));
    Ok(Design::new(values, netlist)
        .groups(groups)
        .goldens(golden::<f64>, golden::<f32>)
        .draw(vertex::draw)
        .hard(hard)
        .bounds(Bounds::Stated(vec![
            Bound::new("binormal", ["bn_x", "bn_y", "bn_z", "bn_dot"], unit_error),
            Bound::new("tangent", ["t_x", "t_y", "t_z", "t_dot"], |v, w| {
                longest() * unit_error(v, w) + vector_rounding(v)
            }),
            Bound::new("flag", ["degenerate"], |_, _| 0.0),
        ]))
        .tabulated(tabulated))
}

/// The golden model's T and BN, and whether B is 0.
pub(super) fn golden_frame<F: Real>(
    n: [F; 3],
    ct: [F; 3],
    normalise: bool,
) -> ([F; 3], [F; 3], bool) {
    let cross = |u: [F; 3], v: [F; 3]| {
        [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    };
    let b = cross(n, ct);
    let zero = b.iter().all(|x| *x == F::zero());
    let bn = if normalise { golden_unit(b) } else { b };
    (cross(bn, n), bn, zero)
}

/// A vector divided by its length; 0 stays 0.
pub(super) fn golden_unit<F: Real>(v: [F; 3]) -> [F; 3] {
    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    if length > F::zero() { v.map(|x| x / length) } else { v }
}

fn golden<F: Real>(_: &Values) -> Golden<F> {
    Golden::each(|[nx, ny, nz, cx, cy, cz]: [F; 6]| {
        let ([tx, ty, tz], [bx, by, bz], zero) = golden_frame([nx, ny, nz], [cx, cy, cz], true);
        [tx, ty, tz, bx, by, bz, if zero { F::one() } else { F::zero() }]
    })
}
