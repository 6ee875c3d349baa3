//! The tangent-space set-up that `peercy` and `ernst` share: two 3×3 transforms and three
//! normalisations, with real dividers and square roots.
//!
//! L and H are transformed from the world into the frame of tangent T, binormal B and normal N.
//! Then L', H' and N' are normalised. A vector of length 0 stays 0.

use super::divide::{self, divide};
use super::plan::{self, Plan, number, rounding_ulp};
use super::root::{self, reciprocal_root};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{Bound, Param, Role, Values};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::format::{Format, Overflow, Round};
use crate::number::function::Function;
use crate::number::trig::Real;

fn normalise() -> Param {
    Param::choice("normalise", ["divide", "reciprocal-root"])
        .help("a square root and three dividers, or a reciprocal square root and three multipliers")
}

fn divider() -> Param {
    Param::choice("divider", ["restoring", "non-restoring", "table"]).default("non-restoring").help(
        "digit recurrences, or a normalised reciprocal table and a product (normalise=divide)",
    )
}

fn root_method() -> Param {
    Param::choice("root", ["digits", "table"])
        .help("a digit recurrence or a normalised table (normalise=divide)")
}

fn root_addr_bits() -> Param {
    Param::bits("root_addr_bits", 2..=20)
        .role(Role::TableSize)
        .auto("table_addr_bits")
        .help("address bits of the root or reciprocal-root table")
}

/// Integer bits of a transformed component: three products of words below 2 in magnitude.
const INT_BITS: u32 = 4;

/// Vectors of the input ports, in order.
fn vectors(highlight: bool) -> &'static [&'static str] {
    if highlight { &["l", "h", "n", "t", "b", "p"] } else { &["l", "n", "t", "b", "p"] }
}

/// Scopes in `setup` of L', H' and N'.
fn scopes(highlight: bool) -> &'static [&'static str] {
    if highlight { &["light", "half", "bump"] } else { &["light", "bump"] }
}

/// Labels of the components of a unit vector in a scope of `setup`.
pub(crate) fn labels(scope: &str) -> [String; 3] {
    ["x", "y", "z"].map(|axis| format!("setup.{scope}.unit_{axis}.{axis}"))
}

/// Adds the input ports, and computes the unit vectors L', H' (with a highlight) and N'.
pub(crate) fn set_up(
    b: &mut Builder,
    plan: &mut Plan<'_>,
    highlight: bool,
) -> Result<Vec<[NodeId; 3]>> {
    let component = number(1, plan.frac_bits)?;
    let ports: Vec<[NodeId; 3]> = vectors(highlight)
        .iter()
        .map(|v| {
            ["x", "y", "z"].map(|axis| b.input(&format!("{v}_{axis}"), component, Quantity::Number))
        })
        .collect();
    let (lights, frame) = ports.split_at(ports.len() - 4);
    let [n, t, binormal, p] = *frame else { panic!("bug: N, T, B, N'") };
    let work = number(INT_BITS, plan.work_bits)?;
    b.scope("setup", |b| {
        let mut units = Vec::new();
        for (v, scope) in lights.iter().zip(scopes(highlight)) {
            units.push(b.scope(scope, |b| {
                let rows = [("x", t), ("y", binormal), ("z", n)];
                let transformed = rows.map(|(axis, row)| {
                    let [x, y, z] = [0, 1, 2].map(|i| b.mul(row[i], v[i]));
                    let sum = b.add(x, y);
                    let sum = b.add(sum, z); // -12 <= sum <= 12
                    let word = b.narrow(sum, work, plan.round, Overflow::Saturate);
                    b.name(word, &format!("frame_{axis}"))
                });
                normalised(b, plan, transformed)
            })?);
        }
        units.push(b.scope("bump", |b| normalised(b, plan, p))?);
        Ok(units)
    })
}

/// The vector divided by its length, in words of the ports' format.
fn normalised(b: &mut Builder, plan: &mut Plan<'_>, v: [NodeId; 3]) -> Result<[NodeId; 3]> {
    let values = plan.values;
    let (round, work_bits) = (plan.round, plan.work_bits);
    let work_frac = cast::signed_count(work_bits);
    let [x, y, z] = v.map(|axis| b.mul(axis, axis));
    let sum = b.add(x, y);
    let sum = b.add(sum, z);
    let squares = b.format(sum); // signed as all products of signed words, but never negative
    let unsigned = Format::unsigned(squares.bits() - 1, squares.frac_bits());
    let unsigned = b.checked(unsigned);
    let square = b.narrow(sum, unsigned, Round::Floor, Overflow::Saturate);
    b.name(square, "square");
    let output = number(1, plan.frac_bits)?;
    let axes = ["x", "y", "z"];
    let kept_bits = kept_bits(work_bits);
    let mut roots = |b: &mut Builder, name: &str, function| -> Result<_> {
        let argument = root::argument(unsigned, kept_bits)?;
        let format = Format::unsigned(work_bits + 2, work_frac)?; // up to 2
        Ok(plan.tabulate(b, name, "root_addr_bits", &[function], 0.25, format, argument))
    };
    if values.choice("normalise") == "reciprocal-root" {
        let table = roots(b, "recip_root", Function::recip_sqrt())?;
        let table = root::Table { spec: table.spec(), kept_bits };
        // Up to 4, for vectors of length ¼ or more.
        let factor = Format::unsigned(work_bits + 2, work_frac)?;
        let factor = reciprocal_root(b, "reciprocal_length", square, factor, round, &table, None);
        b.name(factor, "reciprocal_length");
        return Ok([0, 1, 2].map(|i| {
            b.scope(&format!("unit_{}", axes[i]), |b| {
                let product = b.mul(v[i], factor);
                let word = b.narrow(product, output, round, Overflow::Saturate);
                b.name(word, axes[i])
            })
        }));
    }
    let length = Format::unsigned(work_bits + INT_BITS + 1, work_frac)?;
    let table;
    let method = if values.choice("root") == "table" {
        table = roots(b, "root", Function::sqrt())?;
        root::Method::Table(root::Table { spec: table.spec(), kept_bits })
    } else {
        root::Method::Digits
    };
    let length = root::root(b, "length", square, length, round, &method);
    b.name(length, "length");
    let table;
    let method = match values.choice("divider") {
        "restoring" => divide::Method::Restoring,
        "non-restoring" => divide::Method::NonRestoring,
        _ => {
            let argument = divide::argument(b.format(length))?;
            let format = Format::unsigned(work_bits + 2, work_frac)?;
            let size = "recip_addr_bits";
            table = plan.tabulate(b, "recip", size, &[Function::recip()], 0.5, format, argument);
            divide::Method::Table(table.spec())
        }
    };
    Ok([0, 1, 2].map(|i| {
        let name = format!("unit_{}", axes[i]);
        let word = divide(b, &name, [v[i], length], output, round, &method);
        b.name(word, axes[i])
    }))
}

/// Bits of the root tables' argument: more than their words have.
fn kept_bits(work_bits: u32) -> u32 {
    (work_bits + 2).max(4)
}

/// The inputs for which the bounds hold.
pub(crate) const INPUTS: &str = "L and H in the texture frame, and N', from 1/2 to 2 long";

/// The bound on each component of the unit vectors.
pub(crate) fn bound(quantities: &[&str]) -> Bound {
    Bound::new("component", quantities, component_bound)
}

/// Error of each component of L', H' and N', for [`INPUTS`].
pub(crate) fn component_bound(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    let ulp = |bits: u32| 2f64.powi(-cast::signed_count(bits));
    let work_bits = values.bits("frac_bits") + values.bits("guard_bits");
    let (work_ulp, rounding) = (ulp(work_bits), rounding_ulp(values));
    let last = rounding * ulp(values.bits("frac_bits"));
    // The transformed vector is off by `vector`; projected onto the sphere, it is off by that over
    // its length.
    let vector = 3f64.sqrt() * rounding * work_ulp;
    let length = 0.5 - vector;
    if length <= 0.25 {
        return 4.0; // too short words give no bound: components are from -2 to 2
    }
    let dropped = ulp(kept_bits(work_bits));
    let scaled = if values.choice("normalise") == "reciprocal-root" {
        // The factor is off by the table's relative error and by one rounding; it is at most 2.
        worst("recip_root") + 4.0 * dropped + (2.0 + vector) * rounding * work_ulp
    } else {
        let table = match values.choice("root") {
            "table" => 2.0 * (worst("root") + dropped),
            _ => 0.0,
        };
        let root = table + rounding * work_ulp / length; // relative
        if root >= 0.5 {
            return 4.0;
        }
        let ratio = 1.0 / (1.0 - root);
        let divider = match values.choice("divider") {
            "table" => ratio * worst("recip"),
            _ => 0.0,
        };
        root * ratio + divider
    };
    (vector / length + scaled + last).min(4.0)
}

/// The golden unit vectors L', H' (with a highlight) and N' in the texture frame.
pub(crate) fn golden<F: Real>(inputs: &[&[F]]) -> Vec<[Vec<F>; 3]> {
    let vectors: Vec<&[&[F]]> = inputs.chunks(3).collect();
    let (lights, frame) = vectors.split_at(vectors.len() - 4);
    let [n, t, binormal, p] = *frame else { panic!("bug: N, T, B, N'") };
    let len = n[0].len();
    let dot = |u: &[&[F]], v: &[&[F]], i: usize| {
        u[0][i] * v[0][i] + u[1][i] * v[1][i] + u[2][i] * v[2][i]
    };
    let unit = |v: [Vec<F>; 3]| -> [Vec<F>; 3] {
        let [mut x, mut y, mut z] = v;
        for i in 0..len {
            let length = (x[i] * x[i] + y[i] * y[i] + z[i] * z[i]).sqrt();
            if length > F::zero() {
                (x[i], y[i], z[i]) = (x[i] / length, y[i] / length, z[i] / length);
            }
        }
        [x, y, z]
    };
    let in_frame =
        |v: &&[&[F]]| unit([t, binormal, n].map(|row| (0..len).map(|i| dot(row, v, i)).collect()));
    let mut units: Vec<[Vec<F>; 3]> = lights.iter().map(in_frame).collect();
    units.push(unit([p[0].to_vec(), p[1].to_vec(), p[2].to_vec()]));
    units
}

/// Parameters of the set-up.
pub(crate) fn params() -> [Param; 10] {
    [
        normalise(),
        divider(),
        root_method(),
        plan::frac_bits(),
        plan::guard_bits(),
        Param::rounding("rounding"),
        plan::table_addr_bits(),
        Param::scheme("scheme"),
        plan::recip_addr_bits(),
        root_addr_bits(),
    ]
}
