//! The whole bump mapping unit of Lee et al., Fig. 8: two rotations and the illumination unit.
//!
//! The light L and the halfway vector H are rotated into the frame of the normal N. The perturbed
//! normal N', which the bump vector map gives in the texture frame, is turned by psi about N into
//! the same frame. That takes one adder for both dot products; turning L' and H' would take two.
//! The dot products and the light tables follow. Pipelines:
//!
//! - `printed`: rotation and illumination as the paper prints them;
//! - `corrected`: both with their identities corrected;
//! - `exact-polar`: the exact rotation, converted to polar form, and the corrected illumination;
//! - `exact-cartesian`: the exact rotation in Cartesian components, a Cartesian dot product, and N'
//!   in components.

use super::illumination::{
    self, DOTS, Light, cartesian_dot, components, corrected_dot_bound, diffuse_bound,
    direction_words, golden_dot, golden_light, intensity_bound, light, light_ports, polar_dot,
    specular_bound,
};
use super::parts::fragment;
use super::parts::plan::{self, Plan, angle, number, rounding_ulp};
use super::rotation::{self, Form, rotate};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{
    Bound, Bounds, Design, Golden, Group, HardCase, Param, Role, Shading, Shape, Unit, Values,
};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::format::{Format, Overflow};
use crate::number::trig::Real;

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("bump", "light of a bump-mapped pixel from light, halfway vector, normal and bump vector")
        .source("Lee et al., Fig. 8; the turn psi and the exact pipelines are this project's")
        .formula(format!(
            "L' and H' are L and H rotated into the frame of N, as the unit rotation does; N' = (phi_p + psi, theta_p)\n\
             {}",
            illumination::REFLECTION
        ))
        .params([
            Param::choice("pipeline", ["printed", "corrected", "exact-polar", "exact-cartesian"])
                .role(Role::Pipeline)
                .default("exact-polar")
                .help("as the paper prints it, with its identities corrected, or the exact rotation with polar or Cartesian dot products"),
            Param::choice("conversion", ["table", "cordic"])
                .help("how exact-polar converts components to angles"),
            plan::angle_bits(),
            plan::table_addr_bits(),
            Param::scheme("scheme"),
            plan::quarter_wave(),
            plan::frac_bits(),
            plan::guard_bits(),
            Param::rounding("rounding"),
            plan::sincos_addr_bits(),
            plan::asin_addr_bits(),
            plan::recip_addr_bits(),
            plan::atan_addr_bits(),
            plan::prop_addr_bits(),
            illumination::cos_addr_bits(),
            plan::recip_int_bits(),
            plan::atan_int_bits(),
            plan::quadrants(),
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
        .inputs("phi_l, theta_l, phi_h, theta_h, phi_n, theta_n, psi: angles in the world; phi_p, theta_p or p_x, p_y, p_z (exact-cartesian): the bump vector in the texture frame")
        .outputs("intensity, diffuse (with the ambient light), specular: 0 to 1")
        .shades(Shading::Pipeline)
        .design(design)
}

/// Scopes of the rotations.
const SCOPES: [&str; 2] = ["light", "half"];

fn design(values: &Values) -> Result<Design> {
    let pipeline = values.choice("pipeline");
    let highlight = values.flag("highlight");
    let cartesian = pipeline == "exact-cartesian";
    let (variant, brackets) = match pipeline {
        "printed" => ("printed", "printed"),
        "corrected" => ("corrected", "corrected"),
        _ => ("exact", "corrected"),
    };
    let mut plan = Plan::new(values);
    let component = number(1, plan.frac_bits)?;
    let form = match (cartesian, values.choice("conversion")) {
        (true, _) => Form::Cartesian { format: component, overflow: Overflow::Saturate },
        (false, "cordic") => Form::PolarCordic,
        (false, _) => Form::PolarTable,
    };
    let mut b = values.builder("bump");
    let turn = Format::turns(plan.angle_bits)?;
    let pair = |b: &mut Builder, v: &str| {
        ["phi", "theta"].map(|a| b.input(&format!("{a}_{v}"), turn, Quantity::Turns))
    };
    let mut vectors = vec![pair(&mut b, "l")];
    if highlight {
        vectors.push(pair(&mut b, "h"));
    }
    let [phi_n, theta_n] = pair(&mut b, "n");
    let psi = b.input("psi", turn, Quantity::Turns);
    let perturbed: Vec<NodeId> = if cartesian {
        let axes = ["p_x", "p_y", "p_z"];
        axes.map(|name| b.input(name, component, Quantity::Number)).to_vec()
    } else {
        pair(&mut b, "p").to_vec()
    };
    let rotated = vectors
        .iter()
        .zip(SCOPES)
        .map(|([phi, theta], scope)| {
            b.scope(scope, |b| rotate(b, &mut plan, variant, form, [*phi, *theta, phi_n, theta_n]))
        })
        .collect::<Result<Vec<_>>>()?;
    let perturbed = b.scope("bump", |b| turned(b, &mut plan, psi, &perturbed))?;
    let dots = rotated
        .iter()
        .zip(DOTS)
        .map(|(v, name)| {
            let dot = match (&v[..], &perturbed[..]) {
                ([x, y, z], [px, py, pz]) => {
                    cartesian_dot(&mut b, &plan, name, [*x, *y, *z], [*px, *py, *pz])?
                }
                ([phi, theta], [pp, pt]) => {
                    polar_dot(&mut b, &mut plan, brackets, name, [*phi, *theta], [*pp, *pt])?
                }
                _ => unreachable!("bug: both have the same form"),
            };
            Ok(b.name(dot, name))
        })
        .collect::<Result<Vec<_>>>()?;
    let lit: Light = light(&mut b, &mut plan, dots[0], dots.get(1).copied())?;
    lit.output(&mut b);
    let tabulated = plan.tabulated;
    let netlist = b.build()?;
    let mut groups = Group::ports(&netlist, light_ports(values))?;
    groups.extend(illumination::dot_groups(&netlist, highlight)?);
    let (shape, parts): (_, &[&str]) = if cartesian {
        (Shape::Cartesian, &["x", "y", "z"])
    } else {
        (Shape::Polar, &["phi", "theta"])
    };
    let names = if highlight { &["lt", "ht"][..] } else { &["lt"] };
    for (name, scope) in names.iter().copied().zip(SCOPES) {
        let labels = parts.iter().map(|part| format!("{scope}.{part}"));
        groups.push(Group::inside(&netlist, name, shape.clone(), labels)?);
    }
    let bounds = match pipeline {
        "exact-polar" | "exact-cartesian" => stated(values),
        _ => Bounds::unstated(
            "asin, 1/sin and 1/cos have infinite slopes, so no word length bounds the error; each table's own error is stated",
        ),
    };
    Ok(Design::new(values, netlist)
        .groups(groups)
        .goldens(golden::<f64>, golden::<f32>)
        .draw(fragment::draw)
        .hard(hard_cases(values, cartesian))
        .bounds(bounds)
        .tabulated(tabulated))
}

/// The bump vector turned by psi about z.
fn turned(
    b: &mut Builder,
    plan: &mut Plan<'_>,
    psi: NodeId,
    perturbed: &[NodeId],
) -> Result<Vec<NodeId>> {
    let [x, y, z] = *perturbed else {
        let sum = b.add(perturbed[0], psi);
        let phi = angle(b, "phi", sum, Format::turns(plan.angle_bits)?);
        return Ok(vec![phi, perturbed[1]]);
    };
    let (sin, cos) = plan.sincos(b, psi)?;
    let products = |b: &mut Builder, u, v| (b.mul(u, cos), b.mul(v, sin));
    let (xc, ys) = products(b, x, y);
    let (yc, xs) = products(b, y, x);
    let (tx, ty) = (b.sub(xc, ys), b.add(yc, xs)); // below 2 sqrt 2, except for table error
    let work = number(2, plan.work_bits)?;
    let word = |b: &mut Builder, node, name| {
        let word = b.narrow(node, work, plan.round, Overflow::Saturate);
        b.name(word, name)
    };
    Ok(vec![word(b, tx, "x"), word(b, ty, "y"), z])
}

/// Bounds of the exact pipelines.
fn stated(values: &Values) -> Bounds {
    let polar = values.choice("pipeline") == "exact-polar";
    // With a highlight, those of H' too.
    let of = |all: &'static [&'static str]| {
        if values.flag("highlight") { all } else { &all[..all.len() / 2] }
    };
    let vector = if polar {
        Bound::new("angle", of(&["lt_angle", "ht_angle"]), angle_bound)
    } else {
        let components = of(&["lt_x", "lt_y", "lt_z", "ht_x", "ht_y", "ht_z"]);
        Bound::new("component", components, rotation::component_bound)
    };
    let bounds = vec![
        Bound::new("dot", DOTS, dot_bound),
        Bound::new("diffuse", ["diffuse"], |v, w| diffuse_bound(v, w, dot_bound(v, w))),
        Bound::new("specular", ["specular"], |v, w| specular_bound(v, w, dot_bound(v, w))),
        Bound::new("intensity", ["intensity"], |v, w| intensity_bound(v, w, dot_bound(v, w))),
        vector,
    ];
    Bounds::Stated(illumination::restricted(values, bounds))
}

fn angle_bound(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    rotation::polar_bound(values, worst, values.choice("conversion") == "cordic")
}

/// Bound on N'·A: from the error of the rotated vector, plus that of the illumination unit.
fn dot_bound(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    let ulp = |bits: u32| 2f64.powi(-cast::signed_count(bits));
    let rounding = rounding_ulp(values);
    let last = rounding * ulp(values.bits("frac_bits"));
    if values.choice("pipeline") == "exact-polar" {
        // A dot product of unit vectors changes by no more than the angle.
        return angle_bound(values, worst).min(2.0) + corrected_dot_bound(worst) + last;
    }
    // N' as words may not be a unit vector: its components are at most 2 in magnitude.
    let (length, across) = (2.0 * 3f64.sqrt(), 2.0 * 2f64.sqrt());
    let rotated = 3f64.sqrt() * rotation::component_bound(values, worst);
    // Error of each of two components: |x| + |y| times the table's error, and one rounding.
    let work = values.bits("frac_bits") + values.bits("guard_bits");
    let turned = 2f64.sqrt() * (2f64.sqrt() * across * worst("sincos") + rounding * ulp(work));
    length * rotated + (1.0 + rotated) * turned + last
}

/// The golden model: rotation matrices, Cartesian dot products, the reflection formula.
fn golden<F: Real>(values: &Values) -> Golden<F> {
    let highlight = values.flag("highlight");
    let vectors = if highlight { 2 } else { 1 };
    let light = golden_light(values);
    Golden::new(move |inputs: &[&[F]], outputs: &mut [Vec<F>]| {
        let (angles, rest) = inputs.split_at(2 * vectors);
        let (phi_n, theta_n, psi, p) = (rest[0], rest[1], rest[2], &rest[3..]);
        let len = psi.len();
        let p: [Vec<F>; 3] = match p {
            [x, y, z] => [x.to_vec(), y.to_vec(), z.to_vec()],
            [phi, theta] => components(phi, theta),
            _ => panic!("bug: N' has two angles or three components"),
        };
        let sin_cos = |angle: &[F]| {
            let (mut sin, mut cos) = (vec![F::default(); len], vec![F::default(); len]);
            F::sin_cos_turns(angle, &mut sin, &mut cos);
            (sin, cos)
        };
        let ((sin_phi, cos_phi), (sin_theta, cos_theta), (sin_psi, cos_psi)) =
            (sin_cos(phi_n), sin_cos(theta_n), sin_cos(psi));
        let [px, py, pz] = p;
        let turned: (Vec<F>, Vec<F>) = (0..len)
            .map(|i| {
                (px[i] * cos_psi[i] - py[i] * sin_psi[i], px[i] * sin_psi[i] + py[i] * cos_psi[i])
            })
            .unzip();
        let mut dots = Vec::new();
        let lights = if highlight { 3 } else { 2 };
        for (v, pair) in angles.chunks(2).enumerate() {
            let [mut x, mut y, mut z] = components(pair[0], pair[1]);
            for i in 0..len {
                let along = x[i] * cos_phi[i] + y[i] * sin_phi[i];
                let across = y[i] * cos_phi[i] - x[i] * sin_phi[i];
                x[i] = along * cos_theta[i] - z[i] * sin_theta[i];
                y[i] = across;
                z[i] = along * sin_theta[i] + z[i] * cos_theta[i];
            }
            dots.push(golden_dot([&x, &y, &z], [&turned.0, &turned.1, &pz]));
            let columns = &mut outputs[lights + vectors + 3 * v..][..3];
            for (column, axis) in columns.iter_mut().zip([x, y, z]) {
                column.copy_from_slice(&axis);
            }
        }
        light(&dots, outputs);
    })
}

/// The named hard cases.
fn hard_cases(values: &Values, cartesian: bool) -> Vec<HardCase> {
    let highlight = values.flag("highlight");
    let turn = 1i64 << values.bits("angle_bits");
    let (half, quarter, eighth) = (turn / 2, turn / 4, turn / 8);
    let azimuths = [0, 1, eighth, quarter, half, turn - 1];
    let polars = [0, 1, eighth, quarter - 1, quarter, half - 1, half];
    let near = |centre: i64| [centre - 1, centre, centre + 1];
    let flat = (0, 0);
    let tilted = (eighth + 1, eighth / 2);
    // Pairs of angle words: L, H, N, N'; then psi.
    type Case = ([(i64, i64); 4], i64);
    let words = |([l, h, n, p], psi): Case| -> Vec<i64> {
        let vectors = if highlight { vec![l, h, n] } else { vec![l, n] };
        let word = |w: i64| w.rem_euclid(turn);
        let mut words: Vec<i64> =
            vectors.into_iter().flat_map(|(phi, theta)| [word(phi), word(theta)]).collect();
        words.push(word(psi));
        words.extend(direction_words(values, cartesian, p));
        words
    };
    let cases = |name, list: Vec<Case>| HardCase::new(name, list.into_iter().map(words).collect());
    let (mut poles, mut seam, mut facing, mut opposite, mut grazing, mut mirror) =
        (Vec::new(), Vec::new(), Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for phi in azimuths {
        for theta in polars {
            let n = (phi, theta);
            for pole in [0, 1, half - 1, half] {
                for psi in [0, quarter, turn - 1] {
                    poles.push(([n, n, (0, pole), tilted], psi));
                    poles.push(([(0, pole), (0, pole), n, tilted], psi));
                }
            }
            for (a, b) in [(0, turn - 1), (turn - 1, 0), (half, 0)] {
                seam.push(([(a, quarter), (a, eighth), (b, theta), (turn - 1, eighth)], 1));
                seam.push(([(a, eighth), (a, quarter), (b, theta), (0, eighth)], turn - 1));
            }
            for p in [flat, tilted] {
                facing.extend(near(theta).map(|t| ([(phi, t), (phi, t), n, p], 0)));
                let behind = near(half - theta).map(|t| (phi + half, t));
                opposite.extend(behind.map(|a| ([a, a, n, p], 0)));
                let across = near(quarter).map(|t| (phi + quarter, t));
                grazing.extend(across.map(|a| ([a, a, n, p], 0)));
                let along = near(theta + quarter).map(|t| (phi, t));
                grazing.extend(along.map(|a| ([a, a, n, p], 0)));
            }
            // N' at a right angle to L and along H, and the other way round.
            mirror.extend(near(quarter).map(|t| ([(phi, theta + t), n, n, (0, 1)], phi)));
            mirror.extend(near(quarter).map(|t| ([n, (phi, theta + t), n, (half, t)], phi)));
        }
    }
    vec![
        cases("poles: N or A at theta = 0 or half a turn, and one word either side", poles),
        cases("phi wrap: first and last word", seam),
        cases("A parallel to N: light along the normal, and one word off", facing),
        cases("A opposite to N: lit from behind", opposite),
        cases("grazing light: N·A at 0, just below and just above", grazing),
        cases("N' at a right angle to one of the vectors", mirror),
    ]
}
