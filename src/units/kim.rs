//! Bump mapping by angles after Kim et al. 2001, as Lee et al. count it in Table 1: polar.
//!
//! Lee et al. give the illumination, eqs (3) and (4). Of the set-up they give only the count (31
//! multipliers, 6 tables and 18 adders) and say that it builds a matrix for each pixel. The set-up
//! here is a reconstruction: sines and cosines of six angles give L, H and the frame of N in
//! components, 3×3 transforms take L and H into that frame, and tables convert them back to angles.
//! One adder turns N' by psi into the frame of N.

use super::illumination::{
    self, DOTS, components, diffuse_bound, dot_groups, golden_dot, golden_light, intensity_bound,
    kim_dot_bound, light, light_ports, polar_dot, specular_bound,
};
use super::parts::fragment;
use super::parts::plan::{self, Plan, angle, number, rounding_ulp};
use super::rotation::{converted_bound, to_polar};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{Bound, Bounds, Design, Golden, Group, Param, Shading, Shape, Unit, Values};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::format::{Format, Overflow};
use crate::number::trig::Real;

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("kim", "light of a bump-mapped pixel by a matrix of sines and cosines and polar dot products")
        .source("Kim et al. 2001: eqs (3), (4) of Lee et al.; the set-up is a reconstruction")
        .formula(format!(
            "L' = (phi', theta') is L in the frame of N, by a matrix of sines and cosines, as angles; H' likewise\n\
             N'.L' = cos(theta') cos(theta_p) + sin(theta') sin(theta_p) cos(phi' - phi_p - psi)\n\
             {}",
            illumination::REFLECTION
        ))
        .params([
            Param::choice("conversion", ["table", "cordic"]).help("how components are converted to angles"),
            plan::angle_bits(),
            plan::table_addr_bits(),
            Param::scheme("scheme"),
            plan::quarter_wave(),
            plan::frac_bits(),
            plan::guard_bits(),
            Param::rounding("rounding"),
            plan::sincos_addr_bits(),
            plan::recip_addr_bits(),
            plan::atan_addr_bits(),
            plan::cordic_iterations(),
            illumination::highlight(),
            illumination::diffuse_addr_bits(),
            illumination::specular_addr_bits(),
            illumination::light_scheme(),
            illumination::light_bits(),
            illumination::ambient(),
            illumination::diffuse(),
            illumination::specular(),
            illumination::exponent(),
        ])
        .inputs("phi_l, theta_l, phi_h, theta_h, phi_n, theta_n, psi: angles in the world; phi_p, theta_p: the bump vector in the texture frame")
        .outputs("intensity, diffuse (with the ambient light), specular: 0 to 1")
        .shades(Shading::Pipeline)
        .design(design)
}

fn design(values: &Values) -> Result<Design> {
    let highlight = values.flag("highlight");
    let mut plan = Plan::new(values);
    let mut b = values.builder("kim");
    let turn = Format::turns(plan.angle_bits)?;
    let pair = |b: &mut Builder, v: &str| {
        ["phi", "theta"].map(|a| b.input(&format!("{a}_{v}"), turn, Quantity::Turns))
    };
    let mut lights = vec![pair(&mut b, "l")];
    if highlight {
        lights.push(pair(&mut b, "h"));
    }
    let normal = pair(&mut b, "n");
    let psi = b.input("psi", turn, Quantity::Turns);
    let perturbed = pair(&mut b, "p");
    let (vectors, perturbed) =
        b.scope("setup", |b| set_up(b, &mut plan, &lights, normal, psi, perturbed))?;
    let dots = vectors
        .iter()
        .zip(DOTS)
        .map(|(v, name)| {
            let dot = polar_dot(&mut b, &mut plan, "kim", name, *v, perturbed)?;
            Ok(b.name(dot, name))
        })
        .collect::<Result<Vec<_>>>()?;
    light(&mut b, &mut plan, dots[0], dots.get(1).copied())?.output(&mut b);
    let tabulated = plan.tabulated;
    let netlist = b.build()?;
    let mut groups = Group::ports(&netlist, light_ports(values))?;
    groups.extend(dot_groups(&netlist, highlight)?);
    let labels = [["setup.light.phi", "setup.light.theta"], ["setup.half.phi", "setup.half.theta"]];
    for (name, labels) in ["lt", "ht"].into_iter().zip(labels).take(lights.len()) {
        groups.push(Group::inside(&netlist, name, Shape::Polar, labels)?);
    }
    let angles: &[&str] = if highlight { &["lt_angle", "ht_angle"] } else { &["lt_angle"] };
    let bounds = vec![
        Bound::new("dot", DOTS, dot_bound),
        Bound::new("diffuse", ["diffuse"], |v, w| diffuse_bound(v, w, dot_bound(v, w))),
        Bound::new("specular", ["specular"], |v, w| specular_bound(v, w, dot_bound(v, w))),
        Bound::new("intensity", ["intensity"], |v, w| intensity_bound(v, w, dot_bound(v, w))),
        Bound::new("angle", angles, angle_bound),
    ];
    let hard = fragment::hard_cases(&netlist);
    Ok(Design::new(values, netlist)
        .groups(groups)
        .goldens(golden::<f64>, golden::<f32>)
        .draw(fragment::draw)
        .hard(hard)
        .bounds(Bounds::Stated(illumination::restricted(values, bounds)))
        .tabulated(tabulated))
}

/// L', H' in the frame of N, and N' turned into it, all as angles.
fn set_up(
    b: &mut Builder,
    plan: &mut Plan<'_>,
    lights: &[[NodeId; 2]],
    normal: [NodeId; 2],
    psi: NodeId,
    [phi_p, theta_p]: [NodeId; 2],
) -> Result<(Vec<[NodeId; 2]>, [NodeId; 2])> {
    let cordic = plan.values.choice("conversion") == "cordic";
    let (round, work) = (plan.round, number(1, plan.work_bits)?);
    let product = |b: &mut Builder, u, v, name: &str| {
        let product = b.mul(u, v);
        let word = b.narrow(product, work, round, Overflow::Saturate);
        b.name(word, name)
    };
    // The frame of N: T along growing theta, B along growing phi, which has no z.
    let (tangent, binormal, n) = b.scope("frame", |b| -> Result<_> {
        let ((sin_phi, cos_phi), (sin_theta, cos_theta)) =
            (plan.sincos(b, normal[0])?, plan.sincos(b, normal[1])?);
        let tx = product(b, cos_theta, cos_phi, "t_x");
        let ty = product(b, cos_theta, sin_phi, "t_y");
        let nx = product(b, sin_theta, cos_phi, "n_x");
        let ny = product(b, sin_theta, sin_phi, "n_y");
        Ok(([tx, ty, sin_theta], [sin_phi, cos_phi], [nx, ny, cos_theta]))
    })?;
    let mut rotated = Vec::new();
    for ([phi, theta], scope) in lights.iter().zip(["light", "half"]) {
        rotated.push(b.scope(scope, |b| -> Result<_> {
            let ((sin_phi, cos_phi), (sin_theta, cos_theta)) =
                (plan.sincos(b, *phi)?, plan.sincos(b, *theta)?);
            let vx = product(b, sin_theta, cos_phi, "world_x");
            let vy = product(b, sin_theta, sin_phi, "world_y");
            let vz = cos_theta;
            let terms = |b: &mut Builder, u, v| (b.mul(u, vx), b.mul(v, vy));
            let (xx, xy) = terms(b, tangent[0], tangent[1]);
            let xz = b.mul(tangent[2], vz); // T's z is -sin theta
            let (yx, yy) = terms(b, binormal[0], binormal[1]); // B's x is -sin phi
            let (zx, zy) = terms(b, n[0], n[1]);
            let zz = b.mul(n[2], vz);
            let x = b.add(xx, xy);
            let x = b.sub(x, xz);
            let y = b.sub(yy, yx);
            let z = b.add(zx, zy);
            let z = b.add(z, zz);
            let components = [("x", x), ("y", y), ("z", z)].map(|(name, exact)| {
                let word = b.narrow(exact, work, round, Overflow::Saturate);
                b.name(word, name)
            });
            to_polar(b, plan, components, cordic)
        })?);
    }
    let sum = b.add(phi_p, psi);
    let phi_p = angle(b, "phi_p", sum, Format::turns(plan.angle_bits)?);
    Ok((rotated, [phi_p, theta_p]))
}

/// Bound on the angle of L' and H': the error of the components, then that of the conversion.
fn angle_bound(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    let work = values.bits("frac_bits") + values.bits("guard_bits");
    let rounding = rounding_ulp(values) * 2f64.powi(-cast::signed_count(work));
    let e = worst("sincos");
    // A product of sines or cosines, then three products of two such products.
    let entry = 2.0 * e + e * e + rounding;
    let component = 3.0 * (2.0 * entry + entry * entry) + rounding;
    converted_bound(values, worst, component, values.choice("conversion") == "cordic")
}

/// Bound on N'·A: a dot product of unit vectors changes by no more than the angle.
fn dot_bound(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    let last = rounding_ulp(values) * 2f64.powi(-cast::signed_count(values.bits("frac_bits")));
    angle_bound(values, worst).min(2.0) + kim_dot_bound(values, worst) + last
}

/// The golden model: components of all vectors, projected onto the axes of the frame of N.
fn golden<F: Real>(values: &Values) -> Golden<F> {
    let light = golden_light(values);
    Golden::new(move |inputs: &[&[F]], outputs: &mut [Vec<F>]| {
        let (lights, rest) = inputs.split_at(inputs.len() - 5);
        let [phi_n, theta_n, psi, phi_p, theta_p] = *rest else { panic!("bug: N, psi, N'") };
        let turned: Vec<F> = phi_p.iter().zip(psi).map(|(phi, psi)| *phi + *psi).collect();
        let p = components(&turned, theta_p);
        let len = psi.len();
        let n = components(phi_n, theta_n);
        let (mut sin_phi, mut cos_phi) = (vec![F::default(); len], vec![F::default(); len]);
        let (mut sin_theta, mut cos_theta) = (sin_phi.clone(), sin_phi.clone());
        F::sin_cos_turns(phi_n, &mut sin_phi, &mut cos_phi);
        F::sin_cos_turns(theta_n, &mut sin_theta, &mut cos_theta);
        let t: [Vec<F>; 3] = [
            (0..len).map(|i| cos_theta[i] * cos_phi[i]).collect(),
            (0..len).map(|i| cos_theta[i] * sin_phi[i]).collect(),
            sin_theta.iter().map(|sin| -*sin).collect(),
        ];
        let binormal: [Vec<F>; 3] =
            [sin_phi.iter().map(|sin| -*sin).collect(), cos_phi, vec![F::zero(); len]];
        let mut dots = Vec::new();
        let first = outputs.len() - 3 * lights.len() / 2;
        for (v, pair) in lights.chunks(2).enumerate() {
            let a = components(pair[0], pair[1]);
            let a = [&a[0][..], &a[1], &a[2]];
            let rotated = [&t, &binormal, &n].map(|row| golden_dot([&row[0], &row[1], &row[2]], a));
            dots.push(golden_dot([&rotated[0], &rotated[1], &rotated[2]], [&p[0], &p[1], &p[2]]));
            for (column, axis) in outputs[first + 3 * v..].iter_mut().zip(rotated) {
                *column = axis;
            }
        }
        light(&dots, outputs);
    })
}
