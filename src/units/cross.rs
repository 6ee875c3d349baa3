//! The cross product (`cross` alone is a word of SystemVerilog, so the unit has a longer name).

use super::dot::{
    PARAM_NAMES, PARAMS, draw_words, ended, extremes, result, rounding_bounds, signed, vector_ports,
};
use crate::base::error::Result;
use crate::design::{Design, Group, Shading, Unit, Values};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::trig::Real;
use std::sync::Arc;

/// The unit.
pub static CROSS: Unit = Unit {
    name: "cross_product",
    summary: "cross product: six exact products, three differences, one rounding each",
    source: "seed 002 (GL_NV_texgen_emboss): B = N x CT, T = BN x N; in formats of any width",
    params: &PARAMS,
    golden_params: &PARAM_NAMES,
    inputs: "v_x, v_y, v_z, w_x, w_y, w_z: two vectors",
    outputs: "x, y, z: v x w, rounded; past their format as overflow says",
    shades: Shading::None,
    build,
};

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

fn build(values: &Values) -> Result<Design> {
    let mut b = Builder::new("cross_product");
    let v = signed(values, "v_bits", "v_frac_bits")?;
    let v = vector_ports(&mut b, "v", v, Quantity::Number);
    let w = signed(values, "w_bits", "w_frac_bits")?;
    let w = vector_ports(&mut b, "w", w, Quantity::Number);
    let (format, round, overflow) = result(values)?;
    for (exact, name) in cross(&mut b, "products", v, w).into_iter().zip(QUANTITIES) {
        let word = b.narrow(exact, format, round, overflow);
        b.output(name, word);
    }
    let netlist = b.build()?;
    Ok(Design {
        values: values.clone(),
        groups: Group::ports(&netlist, QUANTITIES),
        hard: extremes(&netlist),
        netlist: Arc::new(netlist),
        golden: golden::<f64>,
        golden_f32: golden::<f32>,
        bounds: rounding_bounds(values, QUANTITIES),
        tabulated: Vec::new(),
        draw: draw_words,
        binding: None,
    })
}

fn golden<F: Real>(values: &Values, inputs: &[&[F]], outputs: &mut [Vec<F>]) {
    let [vx, vy, vz, wx, wy, wz] = inputs else { panic!("bug: two vectors") };
    for i in 0..vx.len() {
        outputs[0][i] = ended(values, vy[i] * wz[i] - vz[i] * wy[i]);
        outputs[1][i] = ended(values, vz[i] * wx[i] - vx[i] * wz[i]);
        outputs[2][i] = ended(values, vx[i] * wy[i] - vy[i] * wx[i]);
    }
}
