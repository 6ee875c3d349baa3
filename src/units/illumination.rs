//! The illumination unit of Lee et al., section 4.2 and Fig. 8: two dot products and light tables.
//!
//! The unit computes the light of a pixel from L', H' and the perturbed normal N', all in the
//! texture frame: `diffuse = ka + kd max(0, N'·L')`, `specular = ks max(0, N'·H')^n`, and their
//! sum. Variants:
//!
//! - `printed`: eqs (24), (25) exactly as printed; the second bracket has the wrong sign;
//! - `corrected`: the same with that sign corrected: 3 cosines and 1 multiplier per dot product;
//! - `kim`: eqs (3), (4), after Kim et al. 2001: 5 sines and cosines and 3 multipliers;
//! - `cartesian`: the plain dot product of components, 3 multipliers.
//!
//! A rounded dot product can exceed 1, so it has a guard bit. From 1 on, a constant replaces the
//! table's light. If the dot product is negative, only ambient light remains.

use super::parts::fragment;
use super::parts::plan::{self, Plan, angle, number, rounding_ulp};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{
    Bound, Bounds, Design, Golden, Group, HardCase, Param, Reflection, Role, Shading, Shape, Unit,
    Values,
};
use crate::netlist::{Builder, Netlist, NodeId, Quantity};
use crate::number::format::{Format, Overflow, Round, quantize};
use crate::number::function::Function;
use crate::number::trig::{Real, acos_turns};
use crate::table::{self, Tabulated};

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("illumination", "light of a pixel from light, halfway and perturbed normal vector in the texture frame")
        .source("Lee et al., sections 3.2 and 4.2, Fig. 8; variant kim: its eqs (3) and (4)")
        .formula(format!(
            "L' = (phi_lt, theta_lt), H' = (phi_ht, theta_ht), N' = (phi_p, theta_p); N'.H' as N'.L':\n\
             variant=corrected: N'.L' = [cos(theta_lt+theta_p) + cos(theta_lt-theta_p)]/2\n\
             + [cos(theta_lt-theta_p) - cos(theta_lt+theta_p)]/2 cos(phi_lt-phi_p); printed: the second bracket with the other sign\n\
             kim: N'.L' = cos(theta_lt) cos(theta_p) + sin(theta_lt) sin(theta_p) cos(phi_lt-phi_p); cartesian: the sum of products of components\n\
             {REFLECTION}"
        ))
        .params([
            Param::choice("variant", ["printed", "corrected", "kim", "cartesian"])
                .role(Role::Variant)
                .default("corrected")
                .help("eqs (24) and (25) as printed, with the sign corrected, Kim's eqs (3) and (4), or the Cartesian dot product"),
            plan::angle_bits(),
            plan::table_addr_bits(),
            Param::scheme("scheme"),
            plan::quarter_wave(),
            plan::frac_bits(),
            plan::guard_bits(),
            Param::rounding("rounding"),
            plan::sincos_addr_bits(),
            cos_addr_bits(),
            highlight(),
            diffuse_addr_bits(),
            specular_addr_bits(),
            light_scheme(),
            light_bits(),
            ambient(),
            diffuse(),
            specular(),
            exponent(),
        ])
        .inputs("phi_lt, theta_lt, phi_ht, theta_ht, phi_p, theta_p: angles; or lt_x, lt_y, lt_z and so on (variant=cartesian)")
        .outputs("intensity, diffuse (with the ambient light), specular: 0 to 1")
        .shades(Shading::Part)
        .design(design)
}

/// The light of dot products, for the formulas of units that shade.
pub(super) const REFLECTION: &str = "with ka, kd, ks, n the parameters ambient, diffuse, specular, exponent:\n\
     diffuse = min(1, ka + kd max(0, N'.L')); specular = ks (N'.H')^n, 0 where N'.H' <= 0; both dot products at most 1\n\
     intensity = min(1, diffuse + specular); highlight=off: no H', and intensity = diffuse";

pub(super) fn cos_addr_bits() -> Param {
    Param::bits("cos_addr_bits", 2..=20)
        .role(Role::TableSize)
        .auto("table_addr_bits")
        .help("address bits of the cos table of the dot products")
}

pub(super) fn highlight() -> Param {
    Param::choice("highlight", ["on", "off"])
        .help("off leaves out the halfway vector, its dot product and the specular light")
}

pub(super) fn diffuse_addr_bits() -> Param {
    Param::bits("diffuse_addr_bits", 2..=20)
        .role(Role::TableSize)
        .default(10)
        .help("address bits of the diffuse light table")
}

pub(super) fn specular_addr_bits() -> Param {
    Param::bits("specular_addr_bits", 2..=20)
        .role(Role::TableSize)
        .default(10)
        .help("address bits of the specular light table")
}

pub(super) fn light_scheme() -> Param {
    Param::scheme("light_scheme")
        .help("how the light tables approximate; sharp highlights need linear")
}

pub(super) fn light_bits() -> Param {
    Param::bits("light_bits", 2..=24)
        .default(16)
        .help("bits of the light and of the light tables' words; all are fraction bits")
}

pub(super) fn ambient() -> Param {
    Param::real("ambient", 0.0..=1.0)
        .role(Role::Material(Reflection::Ambient))
        .default(0.1)
        .help("ambient light, Ia ka")
}

pub(super) fn diffuse() -> Param {
    Param::real("diffuse", 0.0..=1.0)
        .role(Role::Material(Reflection::Diffuse))
        .default(0.6)
        .help("diffuse light of a surface that faces the light, Ii kd")
}

pub(super) fn specular() -> Param {
    Param::real("specular", 0.0..=1.0)
        .role(Role::Material(Reflection::Specular))
        .default(0.3)
        .help("specular light in the middle of the highlight, Ii ks")
}

pub(super) fn exponent() -> Param {
    Param::int("exponent", 0..=255)
        .role(Role::Material(Reflection::Exponent))
        .default(32)
        .help("exponent n of the specular reflection")
}

/// N'·A of polar forms: a word with `frac_bits` fraction bits, between -2 and 2.
pub(super) fn polar_dot(
    b: &mut Builder,
    plan: &mut Plan<'_>,
    variant: &str,
    name: &str,
    [phi_a, theta_a]: [NodeId; 2],
    [phi_p, theta_p]: [NodeId; 2],
) -> Result<NodeId> {
    let turn = Format::turns(plan.angle_bits)?;
    let dot = b.scope(name, |b| -> Result<NodeId> {
        let delta = b.sub(phi_a, phi_p);
        let delta = angle(b, "delta", delta, turn);
        if variant == "kim" {
            let (_, cos_delta) = plan.sincos(b, delta)?;
            let ((sin_a, cos_a), (sin_p, cos_p)) =
                (plan.sincos(b, theta_a)?, plan.sincos(b, theta_p)?);
            let along = b.mul(cos_a, cos_p); // -1 to 1 except for table error
            let across = b.mul(sin_a, sin_p);
            let across =
                b.narrow(across, number(2, plan.work_bits)?, plan.round, Overflow::Saturate);
            let across = b.mul(across, cos_delta);
            return Ok(b.add(along, across));
        }
        let sum = b.add(theta_a, theta_p);
        let sum = angle(b, "sum", sum, turn);
        let difference = b.sub(theta_a, theta_p);
        let difference = angle(b, "difference", difference, turn);
        let mut cos = |b: &mut Builder, angle, name| -> Result<NodeId> {
            let output = number(1, plan.work_bits)?;
            let cos = plan.table(b, "cos", "cos_addr_bits", &[Function::cos()], angle, output)[0];
            Ok(b.name(cos, name))
        };
        let cos_sum = cos(b, sum, "cos_sum")?;
        let cos_difference = cos(b, difference, "cos_difference")?;
        let cos_delta = cos(b, delta, "cos_delta")?;
        let along = b.add(cos_sum, cos_difference); // twice cos theta_a cos theta_p
        let along = b.shift(along, -1);
        // Twice sin theta_a sin theta_p; as printed, with the opposite sign.
        let across = if variant == "printed" {
            b.sub(cos_sum, cos_difference)
        } else {
            b.sub(cos_difference, cos_sum)
        };
        let across = b.shift(across, -1);
        let across = b.mul(across, cos_delta);
        Ok(b.add(along, across))
    })?;
    // Below 1.5 in magnitude for tables of any size, except for `printed`.
    Ok(b.narrow(dot, number(1, plan.frac_bits)?, plan.round, Overflow::Saturate))
}

/// The dot product of components of one format; exact except for its last rounding.
pub(super) fn cartesian_dot(
    b: &mut Builder,
    plan: &Plan<'_>,
    name: &str,
    u: [NodeId; 3],
    v: [NodeId; 3],
) -> Result<NodeId> {
    let sum = b.scope(name, |b| {
        let [x, y, z] = [0, 1, 2].map(|axis| b.mul(u[axis], v[axis]));
        let sum = b.add(x, y);
        b.add(sum, z)
    });
    // Words may not be unit vectors: -12 <= sum <= 12.
    Ok(b.narrow(sum, number(4, plan.frac_bits)?, plan.round, Overflow::Saturate))
}

/// Light words of `light_bits` fraction bits.
pub(super) struct Light {
    /// Saturated sum.
    pub(super) intensity: NodeId,
    /// Ambient and diffuse light.
    pub(super) diffuse: NodeId,
    /// Specular light.
    pub(super) specular: Option<NodeId>,
}

impl Light {
    /// Adds the output ports.
    pub(super) fn output(&self, b: &mut Builder) {
        b.output("intensity", self.intensity);
        b.output("diffuse", self.diffuse);
        if let Some(specular) = self.specular {
            b.output("specular", specular);
        }
    }
}

/// Names of the output ports that [`Light::output`] adds.
pub(super) fn light_ports(values: &Values) -> &'static [&'static str] {
    let all = &["intensity", "diffuse", "specular"];
    if values.flag("highlight") { all } else { &all[..2] }
}

/// Light tables of dot products.
pub(super) fn light(
    b: &mut Builder,
    plan: &mut Plan<'_>,
    dot_l: NodeId,
    dot_h: Option<NodeId>,
) -> Result<Light> {
    let values = plan.values;
    let bits = values.bits("light_bits");
    let output = Format::unsigned(bits, cast::signed_count(bits))?; // 0 <= light < 1
    let power = u8::try_from(values.bits("exponent")).expect("bug: at most 255");
    let curve =
        |offset, factor: &str, exponent| Curve { offset, factor: values.real(factor), exponent };
    let diffuse = curve(values.real("ambient"), "diffuse", 1);
    let diffuse = table(b, plan, "diffuse", "diffuse_addr_bits", diffuse, dot_l, output)?;
    let mut light = Light { intensity: diffuse, diffuse, specular: None };
    if let Some(dot_h) = dot_h {
        let specular = curve(0.0, "specular", power);
        let specular = table(b, plan, "specular", "specular_addr_bits", specular, dot_h, output)?;
        let sum = b.add(diffuse, specular);
        light.intensity = b.narrow(sum, output, plan.round, Overflow::Saturate);
        b.name(light.intensity, "intensity");
        light.specular = Some(specular);
    }
    Ok(light)
}

/// `offset + factor * max(0, x)^exponent`, the light at a cosine x. 0^0 is 1.
#[derive(Clone, Copy)]
pub(super) struct Curve {
    /// Light at 0.
    pub(super) offset: f64,
    /// Light at 1 less the offset. Neither is negative.
    pub(super) factor: f64,
    /// The exponent.
    pub(super) exponent: u8,
}

impl Curve {
    pub(super) fn function(self) -> Function {
        let Self { offset, factor, exponent } = self;
        Function::new("light", |x| offset + factor * x.max(0.0).pow(f64::from(exponent)))
    }
}

/// The light table at a dot product; the offset alone if the dot product is negative.
pub(super) fn table(
    b: &mut Builder,
    plan: &mut Plan<'_>,
    name: &str,
    size: &str,
    curve: Curve,
    dot: NodeId,
    output: Format,
) -> Result<NodeId> {
    let output = b.table_format(name, output);
    let Curve { offset, exponent, .. } = curve;
    let function = curve.function();
    let zero = b.constant(0, Format::FLAG);
    let away = if exponent > 0 {
        b.negative(dot)
    } else {
        // The table has 0^0 = 1, but a surface at a right angle gets no light.
        let (towards, one) = (b.less(zero, dot), b.constant(1, Format::FLAG));
        b.xor(towards, one)
    };
    let index = b.mux(away, zero, dot);
    let frac = cast::signed_count(plan.frac_bits);
    let index = b.narrow(
        index,
        Format::unsigned(plan.frac_bits + 1, frac)?, // 0 <= index < 2
        Round::Floor,                                // there is nothing to round
        Overflow::Saturate,
    );
    b.name(index, &format!("{name}_index"));
    // The table ends below 1. Light at 1, the middle of a highlight, is a separate constant.
    let facing = b.slice(index, plan.frac_bits, 1);
    let fraction = b.slice(index, 0, plan.frac_bits);
    let fraction = b.shift(fraction, -frac);
    let tabulated = Tabulated {
        name: name.to_owned(),
        functions: vec![function.clone()],
        scheme: table::chosen(b, name, plan.values.scheme("light_scheme")),
        addr_bits: plan.values.bits(size),
        quarter_wave: false,
        origin: 0.0,
        output,
        round: plan.round,
        argument: b.format(fraction),
    };
    let light = table::emit(b, &tabulated.spec(), fraction)[0];
    plan.tabulated.push(tabulated);
    let constant = |b: &mut Builder, value: f64| -> Result<NodeId> {
        let word = quantize(value, output, Round::HalfEven, Overflow::Saturate)?.0;
        Ok(b.constant(word, output))
    };
    let (bright, dark) = (constant(b, function.eval(1.0))?, constant(b, offset)?);
    let light = b.mux(facing, bright, light);
    b.means(light, [index], |[x]| function.of(&x));
    let light = b.mux(away, dark, light);
    if exponent > 0 {
        // Here the function equals its offset, at a higher precision than the constant.
        b.means(light, [dot], |[x]| function.of(&x));
    }
    Ok(b.name(light, name))
}

fn design(values: &Values) -> Result<Design> {
    let variant = values.choice("variant");
    let highlight = values.flag("highlight");
    let mut plan = Plan::new(values);
    let mut b = values.builder("illumination");
    let vectors: &[&str] = if highlight { &["lt", "ht", "p"] } else { &["lt", "p"] };
    let dots = if variant == "cartesian" {
        let component = number(1, plan.frac_bits)?;
        let vectors: Vec<[NodeId; 3]> = vectors
            .iter()
            .map(|v| {
                ["x", "y", "z"]
                    .map(|axis| b.input(&format!("{v}_{axis}"), component, Quantity::Number))
            })
            .collect();
        let (last, others) = vectors.split_last().expect("bug: N' is there");
        let dots =
            others.iter().zip(DOTS).map(|(v, name)| cartesian_dot(&mut b, &plan, name, *v, *last));
        dots.collect::<Result<Vec<_>>>()?
    } else {
        let turn = Format::turns(plan.angle_bits)?;
        let vectors: Vec<[NodeId; 2]> = vectors
            .iter()
            .map(|v| ["phi", "theta"].map(|a| b.input(&format!("{a}_{v}"), turn, Quantity::Turns)))
            .collect();
        let (last, others) = vectors.split_last().expect("bug: N' is there");
        let dots = others
            .iter()
            .zip(DOTS)
            .map(|(v, name)| polar_dot(&mut b, &mut plan, variant, name, *v, *last));
        dots.collect::<Result<Vec<_>>>()?
    };
    for (dot, name) in dots.iter().zip(DOTS) {
        b.name(*dot, name);
    }
    light(&mut b, &mut plan, dots[0], dots.get(1).copied())?.output(&mut b);
    let tabulated = plan.tabulated;
    let netlist = b.build()?;
    let mut groups = Group::ports(&netlist, light_ports(values))?;
    groups.extend(dot_groups(&netlist, highlight)?);
    let bounds = match variant {
        "printed" => Bounds::unstated("the equations as printed give no dot product"),
        _ => light_bounds(values),
    };
    Ok(Design::new(values, netlist)
        .groups(groups)
        .goldens(golden::<f64>, golden::<f32>)
        .draw(fragment::draw)
        .hard(hard_cases(values, variant == "cartesian"))
        .bounds(bounds)
        .tabulated(tabulated))
}

/// Scopes and names of the dot products.
pub(super) const DOTS: [&str; 2] = ["dot_l", "dot_h"];

/// The dot products as groups whose errors are judged.
pub(super) fn dot_groups(netlist: &Netlist, highlight: bool) -> Result<Vec<Group>> {
    let names = if highlight { &DOTS[..] } else { &DOTS[..1] };
    names.iter().map(|name| Group::inside(netlist, *name, Shape::Scalar, [name])).collect()
}

/// Bounds of the dot products and of the light computed from them.
fn light_bounds(values: &Values) -> Bounds {
    let bounds = vec![
        Bound::new("dot", DOTS, dot_bound),
        Bound::new("diffuse", ["diffuse"], |v, w| diffuse_bound(v, w, dot_bound(v, w))),
        Bound::new("specular", ["specular"], |v, w| specular_bound(v, w, dot_bound(v, w))),
        Bound::new("intensity", ["intensity"], |v, w| intensity_bound(v, w, dot_bound(v, w))),
    ];
    Bounds::Stated(restricted(values, bounds))
}

/// Bounds that remain without the highlight.
pub(super) fn restricted(values: &Values, mut bounds: Vec<Bound>) -> Vec<Bound> {
    if !values.flag("highlight") {
        for bound in &mut bounds {
            if bound.quantities == DOTS {
                bound.quantities.truncate(1);
            }
        }
        bounds.retain(|bound| bound.what != "specular");
    }
    bounds
}

fn ulp(bits: u32) -> f64 {
    2f64.powi(-cast::signed_count(bits))
}

/// Bound on N'·A: the sum of the terms' table errors, and the last rounding.
fn dot_bound(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    let last = rounding_ulp(values) * ulp(values.bits("frac_bits"));
    let inner = match values.choice("variant") {
        "cartesian" => 0.0,
        "kim" => kim_dot_bound(values, worst),
        _ => corrected_dot_bound(worst),
    };
    inner + last
}

/// Bound for eqs (3), (4). cos cos: 2e + e². sin sin: as much, and one rounding; times cos: (1 + e)
/// of it, plus e.
pub(super) fn kim_dot_bound(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    let e = worst("sincos");
    let work = values.bits("frac_bits") + values.bits("guard_bits");
    let pair = 2.0 * e + e * e;
    pair + (1.0 + e) * (pair + rounding_ulp(values) * ulp(work)) + e
}

/// Bound for the corrected eq (24): e for the half sum. The half difference is at most 1 and off by
/// e, and its cosine is off by e.
pub(super) fn corrected_dot_bound(worst: &dyn Fn(&str) -> f64) -> f64 {
    let e = worst("cos");
    e + e + (1.0 + e) * e
}

/// Bound on the diffuse light from the bound on the dot product; its slope is kd. Light of 1
/// saturates one ulp lower.
pub(super) fn diffuse_bound(values: &Values, worst: &dyn Fn(&str) -> f64, dot: f64) -> f64 {
    worst("diffuse") + values.real("diffuse") * dot + ulp(values.bits("light_bits"))
}

/// Bound on the specular light: the change of the power over the bound on the dot product, times
/// ks. With exponent 0 the light jumps at a right angle.
pub(super) fn specular_bound(values: &Values, worst: &dyn Fn(&str) -> f64, dot: f64) -> f64 {
    let slope = match values.bits("exponent") {
        0 => 1.0,
        // (x + d)^n - x^n is largest where x + d = 1.
        n => 1.0 - (1.0 - dot.min(1.0)).powi(i32::try_from(n).expect("bug: at most 255")),
    };
    worst("specular") + values.real("specular") * slope + ulp(values.bits("light_bits"))
}

/// Bound on the sum of both, which saturates one ulp below 1.
pub(super) fn intensity_bound(values: &Values, worst: &dyn Fn(&str) -> f64, dot: f64) -> f64 {
    let specular = if values.flag("highlight") { specular_bound(values, worst, dot) } else { 0.0 };
    diffuse_bound(values, worst, dot) + specular + ulp(values.bits("light_bits"))
}

/// Components of directions with angles in turns.
pub(super) fn components<F: Real>(phi: &[F], theta: &[F]) -> [Vec<F>; 3] {
    let zero = || vec![F::default(); phi.len()];
    let (mut sin_phi, mut cos_phi, mut sin_theta, mut cos_theta) = (zero(), zero(), zero(), zero());
    F::sin_cos_turns(phi, &mut sin_phi, &mut cos_phi);
    F::sin_cos_turns(theta, &mut sin_theta, &mut cos_theta);
    for ((x, y), across) in cos_phi.iter_mut().zip(&mut sin_phi).zip(&sin_theta) {
        (*x, *y) = (*x * *across, *y * *across);
    }
    [cos_phi, sin_phi, cos_theta]
}

/// A function that computes the golden light from dot products. It writes the first columns:
/// intensity, diffuse, specular (if there is a highlight), then the dot products themselves.
pub(super) fn golden_light<F: Real>(
    values: &Values,
) -> impl Fn(&[Vec<F>], &mut [Vec<F>]) + Send + Sync + use<F> {
    let number = |name: &str| F::from(values.real(name)).expect("bug: floats hold numbers");
    let (ambient, diffuse, specular) = (number("ambient"), number("diffuse"), number("specular"));
    let exponent = i32::try_from(values.bits("exponent")).expect("bug: at most 255");
    let (zero, one) = (F::zero(), F::one());
    move |dots, outputs| {
        let highlight = dots.len() > 1;
        for i in 0..dots[0].len() {
            let diffuse = (ambient + diffuse * dots[0][i].max(zero).min(one)).min(one);
            let mut intensity = diffuse;
            outputs[1][i] = diffuse;
            if highlight {
                let dot = dots[1][i].min(one);
                let light = if dot > zero { specular * dot.powi(exponent) } else { zero };
                outputs[2][i] = light;
                intensity = intensity + light;
            }
            outputs[0][i] = intensity.min(one);
        }
        let ports = if highlight { 3 } else { 2 };
        for (column, dot) in outputs[ports..].iter_mut().zip(dots) {
            column.copy_from_slice(dot);
        }
    }
}

/// Dot products of component columns.
pub(super) fn golden_dot<F: Real>(u: [&[F]; 3], v: [&[F]; 3]) -> Vec<F> {
    (0..u[0].len()).map(|i| u[0][i] * v[0][i] + u[1][i] * v[1][i] + u[2][i] * v[2][i]).collect()
}

/// The golden model: spherical coordinates, Cartesian dot products, the reflection formula.
fn golden<F: Real>(values: &Values) -> Golden<F> {
    let cartesian = values.choice("variant") == "cartesian";
    let light = golden_light(values);
    Golden::new(move |inputs, outputs| {
        let dots: Vec<Vec<F>> = if cartesian {
            let vectors: Vec<[&[F]; 3]> = inputs.chunks(3).map(|v| [v[0], v[1], v[2]]).collect();
            let (p, others) = vectors.split_last().expect("bug: N' is there");
            others.iter().map(|v| golden_dot(*v, *p)).collect()
        } else {
            let vectors: Vec<[Vec<F>; 3]> =
                inputs.chunks(2).map(|v| components(v[0], v[1])).collect();
            let (p, others) = vectors.split_last().expect("bug: N' is there");
            others
                .iter()
                .map(|v| golden_dot([&v[0], &v[1], &v[2]], [&p[0], &p[1], &p[2]]))
                .collect()
        };
        light(&dots, outputs);
    })
}

/// The named hard cases.
fn hard_cases(values: &Values, cartesian: bool) -> Vec<HardCase> {
    let highlight = values.flag("highlight");
    let bits = values.bits("angle_bits");
    let turn = 1i64 << bits;
    let (half, quarter, eighth) = (turn / 2, turn / 4, turn / 8);
    let near = |centre: i64| [centre - 1, centre, centre + 1];
    let azimuths = [0, 1, eighth, quarter, half, half + quarter, turn - 1];
    let polars = [0, 1, eighth, quarter - 1, quarter];
    // (L', H', N') as pairs of angle words.
    type Case = [(i64, i64); 3];
    let (mut facing, mut away, mut edge, mut joints, mut seam) =
        (Vec::new(), Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for phi in azimuths {
        for theta in polars {
            let p = (phi, theta);
            facing.extend(near(theta).map(|t| [(phi, t), (phi, t), p]));
            away.extend(near(half - theta).map(|t| [(phi + half, t), (phi + half, t), p]));
            // N'·A just below, at and above 0.
            edge.extend(near(theta + quarter).map(|t| [(phi, t), (phi, t), p]));
            edge.extend(near(quarter).map(|t| [(phi + quarter, t), (phi + quarter, t), p]));
            seam.push([(turn - 1, theta), (turn - 1, theta), (0, theta)]);
            seam.push([(0, theta), (0, theta), (turn - 1, theta)]);
        }
    }
    for size in ["diffuse_addr_bits", "specular_addr_bits"] {
        let cells = 1i64 << values.bits(size).min(12);
        for cell in 0..=cells {
            let cosine = cast::f64_of(cell) / cast::f64_of(cells);
            let angle = acos_turns(cosine) * cast::f64_of(turn);
            let word = cast::i64_of(angle.round());
            joints.extend(near(word).map(|t| [(0, t), (0, t), (0, 0)]));
        }
    }
    let words = |case: Case| -> Vec<i64> {
        let vectors =
            if highlight { vec![case[0], case[1], case[2]] } else { vec![case[0], case[2]] };
        vectors.into_iter().flat_map(|v| direction_words(values, cartesian, v)).collect()
    };
    let cases = |name, list: Vec<Case>| HardCase::new(name, list.into_iter().map(words).collect());
    let mut all = vec![
        cases("dot product at 1 and above: A parallel to N', and one word off", facing),
        cases("dot product at -1: A opposite to N', and one word off", away),
        cases("dot product at 0, just below and just above", edge),
        cases("phi wrap: first and last word", seam),
        cases("first and last entry and joints of the light tables", joints),
    ];
    if cartesian {
        let format = number(1, values.bits("frac_bits")).expect("bug: it was built");
        let ends = [format.min_raw(), -1, 0, 1, format.max_raw()];
        let vectors = if highlight { 3 } else { 2 };
        let list = ends.iter().flat_map(|a| ends.map(|b| vec![[*a; 3], [b; 3]]));
        let words = list.map(|pair| {
            let mut words: Vec<i64> = (1..vectors).flat_map(|_| pair[0]).collect();
            words.extend(pair[1]);
            words
        });
        let name = "least and greatest words through all products";
        all.push(HardCase::new(name, words.collect()));
    }
    all
}

/// Words of the ports of a direction given as angle words: the angles themselves, or its
/// components.
pub(super) fn direction_words(
    values: &Values,
    cartesian: bool,
    (phi, theta): (i64, i64),
) -> Vec<i64> {
    let turn = 1i64 << values.bits("angle_bits");
    if !cartesian {
        return vec![phi.rem_euclid(turn), theta.rem_euclid(turn)];
    }
    let turns = |word: i64| [cast::f64_of(word) / cast::f64_of(turn)];
    let format = number(1, values.bits("frac_bits")).expect("bug: it was built");
    components(&turns(phi), &turns(theta))
        .map(|column| {
            let word = quantize(column[0], format, Round::HalfEven, Overflow::Saturate);
            word.expect("bug: components are finite").0
        })
        .to_vec()
}
