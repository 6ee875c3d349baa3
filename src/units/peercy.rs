//! The set-up of Peercy et al. 1997, as seed 001 counts it in Table 1: Cartesian, tangent space.
//!
//! 18 multipliers and 12 adders transform L and H; 9 multipliers, 6 adders, 3 square roots and 9
//! dividers normalise L', H' and N'. The paper gives no illumination for it.

use super::parts::plan::Plan;
use super::parts::{fragment, setup};
use crate::base::error::Result;
use crate::design::{Bounds, Design, Group, Param, Shading, Shape, Unit, Values};
use crate::netlist::Builder;
use crate::number::trig::Real;
use std::sync::Arc;

/// The unit.
pub static PEERCY: Unit = Unit {
    name: "peercy",
    summary: "light and halfway vector in the texture frame, by matrix, with the bump vector normalised",
    source: "Peercy et al. 1997, as seed 001 (Lee et al.) counts it in Table 1 and section 4.3",
    params: PARAMS,
    golden_params: &[],
    inputs: "l_x … p_z: components of L, H, N, T, B in the world and of N' in the texture frame, from ½ to 2 long after the transform",
    outputs: "lt_x … ht_z: L and H in the texture frame; np_x, np_y, np_z: N'; unit vectors",
    shades: Shading::None,
    build,
};

static PARAMS: &[Param] = &setup::PARAMS;

const QUANTITIES: &[&str] =
    &["lt_x", "lt_y", "lt_z", "ht_x", "ht_y", "ht_z", "np_x", "np_y", "np_z"];

fn build(values: &Values) -> Result<Design> {
    let mut plan = Plan::new(values)?;
    let mut b = Builder::new("peercy");
    let units = setup::set_up(&mut b, &mut plan, true)?;
    for (node, name) in units.iter().flatten().zip(QUANTITIES) {
        b.output(name, *node);
    }
    let tabulated = plan.tabulated;
    let netlist = b.build()?;
    let group = |(name, ports): (&'static str, &[crate::netlist::Output])| Group {
        name,
        shape: Shape::Cartesian,
        nodes: ports.iter().map(|port| port.node).collect(),
    };
    let groups = ["lt", "ht", "np"].into_iter().zip(netlist.outputs().chunks(3)).map(group);
    Ok(Design {
        values: values.clone(),
        groups: groups.collect(),
        hard: fragment::hard_cases(&netlist),
        netlist: Arc::new(netlist),
        golden: golden::<f64>,
        golden_f32: golden::<f32>,
        bounds: Bounds::Within(setup::INPUTS, vec![setup::bound(QUANTITIES)]),
        tabulated,
        draw: fragment::draw,
        binding: None,
    })
}

/// The golden model: the matrix of T, B, N, and division by lengths.
fn golden<F: Real>(_: &Values, inputs: &[&[F]], outputs: &mut [Vec<F>]) {
    for (column, axis) in outputs.iter_mut().zip(setup::golden(inputs).into_iter().flatten()) {
        *column = axis;
    }
}
