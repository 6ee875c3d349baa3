//! Gouraud bump mapping of Ernst et al. 1998, as Lee et al. count it in Table 1: Cartesian.
//!
//! The set-up of [`super::peercy`], followed by two dot products, one power table, and a multiplier
//! for the diffuse coefficient.

use super::illumination::{
    self, Curve, DOTS, Light, cartesian_dot, diffuse_bound, dot_groups, golden_dot, golden_light,
    intensity_bound, light_ports, specular_bound,
};
use super::parts::plan::{Plan, rounding_ulp};
use super::parts::{fragment, setup};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{Bound, Bounds, Design, Golden, Group, Shading, Shape, Unit, Values};
use crate::netlist::{Builder, NodeId};
use crate::number::format::{Format, Overflow, Round, quantize};
use crate::number::trig::Real;

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("ernst", "light of a bump-mapped pixel by matrix, normalisation and Cartesian dot products")
        .source("Ernst et al. 1998, as Lee et al. count it in Table 1 and section 4.3")
        .formula(format!(
            "L' = v/|v| with v = (T.L, B.L, N.L); H' = w/|w| with w = (T.H, B.H, N.H); N' = p/|p|, as in the unit peercy\n\
             {}",
            illumination::REFLECTION
        ))
        .params(setup::params())
        .params([
            illumination::highlight(),
            illumination::specular_addr_bits(),
            illumination::light_scheme(),
            illumination::light_bits(),
            illumination::ambient(),
            illumination::diffuse(),
            illumination::specular(),
            illumination::exponent(),
        ])
        .inputs("l_x … p_z: components of L, H, N, T, B in the world and of N' in the texture frame, from ½ to 2 long after the transform")
        .outputs("intensity, diffuse (with the ambient light), specular: 0 to 1")
        .shades(Shading::Pipeline)
        .design(design)
}

fn design(values: &Values) -> Result<Design> {
    let highlight = values.flag("highlight");
    let mut plan = Plan::new(values);
    let mut b = values.builder("ernst");
    let units = setup::set_up(&mut b, &mut plan, highlight)?;
    let (p, lights) = units.split_last().expect("bug: N' is there");
    let dots = lights
        .iter()
        .zip(DOTS)
        .map(|(v, name)| {
            let dot = cartesian_dot(&mut b, &plan, name, *v, *p)?;
            Ok(b.name(dot, name))
        })
        .collect::<Result<Vec<_>>>()?;
    lit(&mut b, &mut plan, &dots)?.output(&mut b);
    let tabulated = plan.tabulated;
    let netlist = b.build()?;
    let mut groups = Group::ports(&netlist, light_ports(values))?;
    groups.extend(dot_groups(&netlist, highlight)?);
    for (name, scope) in ["lt", "ht"].into_iter().zip(["light", "half"]).take(lights.len()) {
        groups.push(Group::inside(&netlist, name, Shape::Cartesian, setup::labels(scope))?);
    }
    let components: &[&str] = &["lt_x", "lt_y", "lt_z", "ht_x", "ht_y", "ht_z"];
    let bounds = vec![
        Bound::new("dot", DOTS, dot_bound),
        Bound::new("diffuse", ["diffuse"], |v, w| {
            diffuse_bound(v, &product(v, w), dot_bound(v, w))
        }),
        Bound::new("specular", ["specular"], |v, w| specular_bound(v, w, dot_bound(v, w))),
        Bound::new("intensity", ["intensity"], |v, w| {
            intensity_bound(v, &product(v, w), dot_bound(v, w))
        }),
        setup::bound(if highlight { components } else { &components[..3] }),
    ];
    let hard = fragment::hard_cases(&netlist);
    Ok(Design::new(values, netlist)
        .groups(groups)
        .goldens(golden::<f64>, golden::<f32>)
        .draw(fragment::draw)
        .hard(hard)
        .bounds(Bounds::Within(setup::INPUTS.to_owned(), illumination::restricted(values, bounds)))
        .tabulated(tabulated))
}

/// Light from dot products: a multiplier for the diffuse light, a table for the specular light.
fn lit(b: &mut Builder, plan: &mut Plan<'_>, dots: &[NodeId]) -> Result<Light> {
    let values = plan.values;
    let bits = values.bits("light_bits");
    let frac = cast::signed_count(bits);
    let output = Format::unsigned(bits, frac)?; // 0 <= light < 1
    let diffuse = b.scope("diffuse", |b| -> Result<NodeId> {
        let away = b.negative(dots[0]);
        let zero = b.constant(0, Format::FLAG);
        let towards = b.mux(away, zero, dots[0]);
        let unit = Format::unsigned(plan.frac_bits + 1, cast::signed_count(plan.frac_bits))?;
        let towards = b.narrow(towards, unit, Round::Floor, Overflow::Saturate); // below 2
        let one = b.constant(1 << plan.frac_bits, unit);
        let past = b.less(one, towards);
        let towards = b.mux(past, one, towards);
        // 0 to 1; 1 is representable.
        let coefficient = Format::unsigned(bits + 1, frac)?;
        let constant = |b: &mut Builder, name| -> Result<NodeId> {
            let word =
                quantize(values.real(name), coefficient, Round::HalfEven, Overflow::Saturate)?;
            Ok(b.constant(word.0, coefficient))
        };
        let (kd, ambient) = (constant(b, "diffuse")?, constant(b, "ambient")?);
        let product = b.mul(towards, kd);
        let sum = b.add(product, ambient);
        Ok(b.narrow(sum, output, plan.round, Overflow::Saturate))
    })?;
    let (offset, factor) = (values.real("ambient"), values.real("diffuse"));
    let function = Curve { offset, factor, exponent: 1 }.function();
    b.means(diffuse, [dots[0]], |[dot]| function.of(&dot));
    b.name(diffuse, "diffuse");
    let mut light = Light { intensity: diffuse, diffuse, specular: None };
    if let [_, dot_h] = dots {
        let exponent = u8::try_from(values.bits("exponent")).expect("bug: at most 255");
        let power = Curve { offset: 0.0, factor: values.real("specular"), exponent };
        let size = "specular_addr_bits";
        let specular = illumination::table(b, plan, "specular", size, power, *dot_h, output)?;
        let sum = b.add(diffuse, specular);
        light.intensity = b.narrow(sum, output, plan.round, Overflow::Saturate);
        b.name(light.intensity, "intensity");
        light.specular = Some(specular);
    }
    Ok(light)
}

/// Bound on N'·A: both vectors have unit length up to the error of their components.
fn dot_bound(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    let vector = 3f64.sqrt() * setup::component_bound(values, worst);
    let last = rounding_ulp(values) * 2f64.powi(-cast::signed_count(values.bits("frac_bits")));
    vector + vector * (1.0 + vector) + last
}

/// Worst errors, with the diffuse product's in place of a table's: its coefficients are rounded to
/// nearest, and one rounding follows.
fn product<'a>(values: &'a Values, worst: &'a dyn Fn(&str) -> f64) -> impl Fn(&str) -> f64 + 'a {
    let ulp = 2f64.powi(-cast::signed_count(values.bits("light_bits")));
    move |name| if name == "diffuse" { (1.0 + rounding_ulp(values)) * ulp } else { worst(name) }
}

/// The golden model: unit vectors in the texture frame, their dot products, the reflection formula.
fn golden<F: Real>(values: &Values) -> Golden<F> {
    let light = golden_light(values);
    Golden::new(move |inputs, outputs| {
        let units = setup::golden(inputs);
        let (p, lights) = units.split_last().expect("bug: N' is there");
        let dots = lights.iter().map(|v| golden_dot([&v[0], &v[1], &v[2]], [&p[0], &p[1], &p[2]]));
        light(&dots.collect::<Vec<_>>(), outputs);
        let first = outputs.len() - 3 * lights.len();
        for (column, axis) in outputs[first..].iter_mut().zip(lights.iter().flatten()) {
            column.clone_from(axis);
        }
    })
}
