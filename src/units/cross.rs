//! The cross product. The unit's name is `cross_product` because `cross` is a SystemVerilog
//! keyword.

use super::dot::{ended, params, result, rounding_bounds, signed, vector_ports};
use crate::base::error::Result;
use crate::design::{Design, Golden, Unit, Values};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::trig::Real;

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new(
        "cross_product",
        "cross product: six exact products, three differences, one rounding each",
    )
    .source("GL_NV_texgen_emboss: B = N x CT, T = BN x N; in formats of any width")
    .formula("x = v_y w_z - v_z w_y; y = v_z w_x - v_x w_z; z = v_x w_y - v_y w_x")
    .params(params())
    .inputs("v_x, v_y, v_z, w_x, w_y, w_z: two vectors")
    .outputs("x, y, z: v x w, rounded; out-of-range results follow overflow")
    .design(design)
}

const QUANTITIES: &[&str] = &["x", "y", "z"];

/// `v x w`, exact: six multipliers and three adders.
pub(super) fn cross(b: &mut Builder, name: &str, v: [NodeId; 3], w: [NodeId; 3]) -> [NodeId; 3] {
    b.scope(name, |b| {
        [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
            let (plus, minus) = (b.mul(v[i], w[j]), b.mul(v[j], w[i]));
            b.sub(plus, minus)
        })
    })
}

fn design(values: &Values) -> Result<Design> {
    let mut b = values.builder("cross_product");
    let v = signed(values, "v_bits", "v_frac_bits")?;
    let v = vector_ports(&mut b, "v", v, Quantity::Number);
    let w = signed(values, "w_bits", "w_frac_bits")?;
    let w = vector_ports(&mut b, "w", w, Quantity::Number);
    let (format, round, overflow) = result(values)?;
    for (exact, name) in cross(&mut b, "products", v, w).into_iter().zip(QUANTITIES) {
        let word = b.narrow(exact, format, round, overflow);
        b.output(name, word);
    }
    Ok(Design::new(values, b.build()?)
        .goldens(golden::<f64>, golden::<f32>)
        .bounds(rounding_bounds(values, QUANTITIES)))
}

fn golden<F: Real>(values: &Values) -> Golden<F> {
    let ended = ended(values);
    Golden::each(move |[vx, vy, vz, wx, wy, wz]: [F; 6]| {
        [vy * wz - vz * wy, vz * wx - vx * wz, vx * wy - vy * wx].map(&ended)
    })
}
