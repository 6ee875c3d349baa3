//! The set-up of Peercy et al. 1997, as Lee et al. count it in Table 1: Cartesian, tangent space.
//!
//! 18 multipliers and 12 adders transform L and H; 9 multipliers, 6 adders, 3 square roots and 9
//! dividers normalise L', H' and N'. The paper gives no illumination for it.

use super::parts::plan::Plan;
use super::parts::{fragment, setup};
use crate::base::error::Result;
use crate::design::{Bounds, Design, Golden, Group, Shape, Unit, Values};
use crate::number::trig::Real;

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("peercy", "light and halfway vector in the texture frame, by matrix, with the bump vector normalised")
        .source("Peercy et al. 1997, as Lee et al. count it in Table 1 and section 4.3")
        .formula(
            "L' = v/|v| with v = (T.L, B.L, N.L); H' = w/|w| with w = (T.H, B.H, N.H); N' = p/|p|",
        )
        .params(setup::params())
        .inputs("l_x … p_z: components of L, H, N, T, B in the world and of N' in the texture frame, from ½ to 2 long after the transform")
        .outputs("lt_x … ht_z: L and H in the texture frame; np_x, np_y, np_z: N'; unit vectors")
        .design(design)
}

const QUANTITIES: &[&str] =
    &["lt_x", "lt_y", "lt_z", "ht_x", "ht_y", "ht_z", "np_x", "np_y", "np_z"];

fn design(values: &Values) -> Result<Design> {
    let mut plan = Plan::new(values);
    let mut b = values.builder("peercy");
    let units = setup::set_up(&mut b, &mut plan, true)?;
    for (node, name) in units.iter().flatten().zip(QUANTITIES) {
        b.output(name, *node);
    }
    let tabulated = plan.tabulated;
    let netlist = b.build()?;
    let group = |(name, ports): (&str, &[crate::netlist::Output])| {
        Group::new(name, Shape::Cartesian, ports.iter().map(|port| port.node).collect())
    };
    let groups = ["lt", "ht", "np"].into_iter().zip(netlist.outputs().chunks(3)).map(group);
    let (groups, hard) = (groups.collect(), fragment::hard_cases(&netlist));
    Ok(Design::new(values, netlist)
        .groups(groups)
        .goldens(golden::<f64>, golden::<f32>)
        .draw(fragment::draw)
        .hard(hard)
        .bounds(Bounds::Within(setup::INPUTS.to_owned(), vec![setup::bound(QUANTITIES)]))
        .tabulated(tabulated))
}

/// The golden model: the matrix of T, B, N, and division by lengths.
fn golden<F: Real>(_: &Values) -> Golden<F> {
    Golden::new(|inputs, outputs| {
        for (column, axis) in outputs.iter_mut().zip(setup::golden(inputs).into_iter().flatten()) {
            *column = axis;
        }
    })
}
