//! The polar rotation unit of Lee et al., *An Effective Hardware Architecture for Bump Mapping
//! Using Angular Operation*, Fig. 7.
//!
//! It rotates a direction A = (phi_a, theta_a) into the frame of the normal N = (phi_n, theta_n),
//! all angles in turns: A' is A turned by -phi_n about z, then by -theta_n about y. Three variants:
//!
//! - `printed`: eqs (5)-(9), (16)-(21), (26), (27) exactly as printed;
//! - `corrected`: the same tables, multipliers and adders with corrected identities;
//! - `exact`: the rotation's triple products expanded into sums, one table read per term.

use super::parts::plan::{self, Plan, angle, number, rounding_ulp};
use super::parts::polar::{self, PolarTables};
use crate::base::cast;
use crate::base::error::Result;
use crate::base::simd::{Body, vectorised};
use crate::design::{
    Bound, Bounds, Design, Draw, Golden, Group, HardCase, InputPorts, Param, Role, Sampler, Shape,
    Unit, Value, Values,
};
use crate::netlist::{Builder, NodeId, Quantity};
use crate::number::format::{Format, Overflow};
use crate::number::function::Function;
use crate::number::real::Expr;
use crate::number::trig::{Real, acos_turns, asin_turns, atan_turns, sin_cos_turns};
use std::f64::consts::TAU;

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("rotation", "turns a direction in polar form into the frame of a surface normal")
        .source("Lee et al., An Effective Hardware Architecture for Bump Mapping Using Angular Operation, section 3.1 and Fig. 7")
        .formula(
            "A' is A = (phi_a, theta_a) turned by -phi_n about z, then by -theta_n about y. With d = phi_a - phi_n:\n\
         x' = sin(theta_a) cos(d) cos(theta_n) - cos(theta_a) sin(theta_n)\n\
         y' = sin(theta_a) sin(d)\n\
         z' = sin(theta_a) cos(d) sin(theta_n) + cos(theta_a) cos(theta_n)\n\
         variant=exact, with X = theta_a + d, Y = theta_a - d:\n\
         x' = [sin(X+theta_n) + sin(X-theta_n) + sin(Y+theta_n) + sin(Y-theta_n)]/4 - [sin(theta_a+theta_n) - sin(theta_a-theta_n)]/2\n\
         y' = [cos(Y) - cos(X)]/2\n\
         z' = [cos(X-theta_n) - cos(X+theta_n) + cos(Y-theta_n) - cos(Y+theta_n)]/4 + [cos(theta_a+theta_n) + cos(theta_a-theta_n)]/2\n\
         variant=corrected: theta_x = asin([sin X + sin Y]/2), Z = theta_x - theta_n, phi' = atan([cos Y - cos X]/(2 sin Z)),\n\
         theta' = |Z| + (90 deg - |Z|) (1 - acos(|y_k|)/90 deg), y_k = [cos Y - cos X]/(2 cos Z), in the right quadrants\n\
         variant=printed: the same with X and Y halved, without quadrants and magnitudes",
        )
        .params([
            Param::choice("variant", ["printed", "corrected", "exact"])
                .role(Role::Variant)
                .default("exact")
                .help("as the paper prints it, with its identities corrected, or the exact rotation"),
            Param::choice("output", ["auto", "cartesian", "polar-cordic", "polar-table"])
                .help("form of the result; auto: cartesian for exact, the paper's own polar form for the others"),
            plan::angle_bits(),
            plan::table_addr_bits(),
            Param::scheme("scheme"),
            plan::quarter_wave(),
            plan::frac_bits(),
            Param::bits("int_bits", 0..=1)
                .default(1)
                .help("integer bits of the components; 1: +1.0 is representable; 0: one bit less, +1.0 overflows"),
            plan::guard_bits(),
            Param::rounding("rounding"),
            plan::overflow(),
            plan::sincos_addr_bits(),
            plan::asin_addr_bits(),
            plan::recip_addr_bits(),
            plan::atan_addr_bits(),
            plan::prop_addr_bits(),
            plan::recip_int_bits(),
            plan::atan_int_bits(),
            plan::quadrants(),
            plan::cordic_iterations(),
        ])
        .inputs("phi_a, theta_a, phi_n, theta_n: angles, modulo a turn (theta > 180° continues past the pole)")
        .outputs("x, y, z (output=cartesian) or phi, theta: angles (the others)")
        .design(design)
}

fn design(values: &Values) -> Result<Design> {
    let variant = values.choice("variant");
    let output = match (variant, values.choice("output")) {
        ("exact", "auto") => "cartesian",
        ("exact", given) => given,
        (_, "auto" | "polar-table") => "polar-table",
        (_, _) => {
            return Err(
                values.refuse("output", &format!("auto or polar-table when variant={variant}"))
            );
        }
    };
    let mut plan = Plan::new(values);
    let mut b = values.builder("rotation");
    let turn = Format::turns(plan.angle_bits)?;
    let inputs =
        ["phi_a", "theta_a", "phi_n", "theta_n"].map(|name| b.input(name, turn, Quantity::Turns));
    let overflow = values.overflow("overflow");
    let form = match output {
        "cartesian" => {
            let format = number(values.bits("int_bits"), plan.frac_bits)?;
            Form::Cartesian { format, overflow }
        }
        "polar-cordic" => Form::PolarCordic,
        _ => Form::PolarTable,
    };
    let names: &[&str] = if output == "cartesian" { &["x", "y", "z"] } else { &["phi", "theta"] };
    for (name, node) in names.iter().zip(rotate(&mut b, &mut plan, variant, form, inputs)?) {
        b.output(name, node);
    }
    let tabulated = plan.tabulated;
    let netlist = b.build()?;
    let wraps =
        values.bits("int_bits") == 0 && matches!(overflow, Overflow::Wrap | Overflow::Error);
    let bounds = match (variant, output) {
        ("exact", "cartesian") if wraps => {
            Bounds::unstated("with int_bits=0 and without saturation, components near 1 wrap to -1")
        }
        ("exact", "cartesian") => {
            Bounds::Stated(vec![Bound::new("component", ["x", "y", "z"], component_bound)])
        }
        ("exact", _) => Bounds::Stated(vec![Bound::new("angle", ["angle"], angle_bound)]),
        _ => Bounds::unstated(
            "asin, 1/sin and 1/cos have infinite slopes, so no word length bounds the error; each table's own error is stated",
        ),
    };
    let shape = if output == "cartesian" { Shape::Cartesian } else { Shape::Polar };
    let words = netlist.outputs().iter().map(|output| output.node).collect();
    Ok(Design::new(values, netlist)
        .groups(vec![Group::new("", shape, words)])
        .goldens(golden::<f64>, golden::<f32>)
        .draw(draw)
        .hard(hard_cases(values))
        .bounds(bounds)
        .tabulated(tabulated))
}

/// Form of a rotated direction.
#[derive(Clone, Copy, Debug)]
pub(super) enum Form {
    /// x, y, z.
    Cartesian {
        /// Format of each.
        format: Format,
        /// Overflow mode of components out of its range.
        overflow: Overflow,
    },
    /// phi, theta of x, y, z by CORDIC.
    PolarCordic,
    /// phi, theta of x, y, z by tables. The paper's variants have this form too.
    PolarTable,
}

/// Rotates a direction: phi_a, theta_a, phi_n, theta_n to x, y, z or to phi, theta in words of the
/// ports' format. The paper's variants have only the polar form.
pub(super) fn rotate(
    b: &mut Builder,
    plan: &mut Plan<'_>,
    variant: &str,
    form: Form,
    inputs: [NodeId; 4],
) -> Result<Vec<NodeId>> {
    match variant {
        "exact" => exact(b, plan, inputs, form),
        variant => seed(b, plan, inputs, variant == "corrected"),
    }
}

/// Variant `exact`: every product of sines and cosines as a sum of sines or cosines.
fn exact(
    b: &mut Builder,
    plan: &mut Plan<'_>,
    inputs: [NodeId; 4],
    form: Form,
) -> Result<Vec<NodeId>> {
    let [phi_a, theta_a, phi_n, theta_n] = inputs;
    let turn = Format::turns(plan.angle_bits)?;
    let [big_y, big_x, xp, xm, yp, ym, ap, am] = b.scope("angles", |b| {
        let delta = b.sub(phi_a, phi_n);
        let delta = angle(b, "delta", delta, turn);
        let sum = |b: &mut Builder, name: &str, p, q| {
            let exact = b.add(p, q);
            angle(b, name, exact, turn)
        };
        let difference = |b: &mut Builder, name: &str, p, q| {
            let exact = b.sub(p, q);
            angle(b, name, exact, turn)
        };
        let big_x = sum(b, "ang_x", theta_a, delta);
        let big_y = difference(b, "ang_y", theta_a, delta);
        [
            big_y,
            big_x,
            sum(b, "x_plus_n", big_x, theta_n),
            difference(b, "x_minus_n", big_x, theta_n),
            sum(b, "y_plus_n", big_y, theta_n),
            difference(b, "y_minus_n", big_y, theta_n),
            sum(b, "a_plus_n", theta_a, theta_n),
            difference(b, "a_minus_n", theta_a, theta_n),
        ]
    });
    let mut read = |b: &mut Builder, angle, suffix: &str| -> Result<(NodeId, NodeId)> {
        let (sin, cos) = plan.sincos(b, angle)?;
        b.name(sin, &format!("sin_{suffix}"));
        b.name(cos, &format!("cos_{suffix}"));
        Ok((sin, cos))
    };
    let (_, cos_y) = read(b, big_y, "y")?;
    let (_, cos_x) = read(b, big_x, "x")?;
    let (sin_xp, cos_xp) = read(b, xp, "xpn")?;
    let (sin_xm, cos_xm) = read(b, xm, "xmn")?;
    let (sin_yp, cos_yp) = read(b, yp, "ypn")?;
    let (sin_ym, cos_ym) = read(b, ym, "ymn")?;
    let (sin_ap, cos_ap) = read(b, ap, "apn")?;
    let (sin_am, cos_am) = read(b, am, "amn")?;
    // Each sum is below 1 in magnitude except for table error; formats grow to hold any words.
    let [x, y, z] = b.scope("sums", |b| {
        let quarters = |b: &mut Builder, [p, q, r, s]: [NodeId; 4], minus: bool| {
            // p + q + r + s, or p - q + r - s
            let (first, second) =
                if minus { (b.sub(p, q), b.sub(r, s)) } else { (b.add(p, q), b.add(r, s)) };
            let sum = b.add(first, second);
            b.shift(sum, -2)
        };
        let quarter_x = quarters(b, [sin_xp, sin_xm, sin_yp, sin_ym], false);
        let difference = b.sub(sin_ap, sin_am);
        let half_x = b.shift(difference, -1);
        let x = b.sub(quarter_x, half_x);
        let difference = b.sub(cos_y, cos_x);
        let y = b.shift(difference, -1);
        let quarter_z = quarters(b, [cos_xm, cos_xp, cos_ym, cos_yp], true);
        let sum = b.add(cos_ap, cos_am);
        let half_z = b.shift(sum, -1);
        let z = b.add(quarter_z, half_z);
        [b.name(x, "x_sum"), b.name(y, "y_sum"), b.name(z, "z_sum")]
    });
    if let Form::Cartesian { format, overflow } = form {
        let word = |(name, node)| {
            let word = b.narrow(node, format, plan.round, overflow);
            b.name(word, name)
        };
        return Ok([("x", x), ("y", y), ("z", z)].map(word).to_vec());
    }
    let component = number(1, plan.work_bits)?;
    let [x, y, z] = [("x", x), ("y", y), ("z", z)].map(|(name, node)| {
        let word = b.narrow(node, component, plan.round, Overflow::Saturate);
        b.name(word, name)
    });
    let angles = to_polar(b, plan, [x, y, z], matches!(form, Form::PolarCordic))?;
    Ok(angles.to_vec())
}

/// Converts a direction to phi, theta in words of the ports' format. Its three words have one
/// format, of `1 + work_bits` bits and a sign. (0, 0, 0) gives 0, 0.
pub(super) fn to_polar(
    b: &mut Builder,
    plan: &mut Plan<'_>,
    [x, y, z]: [NodeId; 3],
    cordic: bool,
) -> Result<[NodeId; 2]> {
    let component = b.format(x);
    let (phi, theta) = if cordic {
        let iterations = cordic_iterations(plan.values);
        let work_bits = polar::cordic_frac_bits(plan.work_bits, iterations);
        let angle_bits = polar::cordic_frac_bits(plan.work_angle_bits, iterations);
        let azimuth =
            b.scope("azimuth", |b| polar::cordic(b, y, x, iterations, work_bits, angle_bits));
        let theta = b.scope("polar_angle", |b| {
            // The first CORDIC's length is too long by its gain, so z is scaled by it too.
            let z = polar::scale(b, z, polar::gain(iterations), work_bits);
            polar::cordic(b, azimuth.length, z, iterations, work_bits, angle_bits)
        });
        (azimuth.angle, theta.angle)
    } else {
        let frac_bits = plan.work_bits.max(plan.work_angle_bits);
        let round = plan.round;
        let recip_output = Format::unsigned(frac_bits + 2, cast::signed_count(frac_bits))?;
        let atan_output = Format::unsigned(frac_bits + 1, cast::signed_count(frac_bits))?;
        let mut convert = |b: &mut Builder, y, x, scope: &str| -> Result<polar::Polar> {
            let argument = polar::mantissa_argument(b.format(x))?;
            let recip = plan.tabulate(
                b,
                "recip",
                "recip_addr_bits",
                &[Function::recip()],
                0.5,
                recip_output,
                argument,
            );
            let atan = plan.tabulate(
                b,
                "atan",
                "atan_addr_bits",
                &[Function::atan(), secant()],
                0.0,
                atan_output,
                Format::unsigned(frac_bits, cast::signed_count(frac_bits))?,
            );
            let tables =
                PolarTables { recip: recip.spec(), atan: atan.spec(), ratio_bits: frac_bits };
            Ok(b.scope(scope, |b| polar::table(b, y, x, &tables)))
        };
        let azimuth = convert(b, y, x, "azimuth")?;
        let length = b.narrow(azimuth.length, component, round, Overflow::Saturate);
        (azimuth.angle, convert(b, length, z, "polar_angle")?.angle)
    };
    b.means(phi, [y, x], |[y, x]| y.atan2_turns(x));
    b.means(theta, [x, y, z], |[x, y, z]| inclination(&x, &y, &z));
    Ok([plan.angle_word(b, "phi", phi)?, plan.angle_word(b, "theta", theta)?])
}

/// Angle of (x, y, z) from the z axis in turns.
pub(super) fn inclination(x: &Expr, y: &Expr, z: &Expr) -> Expr {
    (x * x + y * y).sqrt().atan2_turns(z)
}

/// sqrt(1 + x²), the secant of atan x.
fn secant() -> Function {
    Function::new("secant", |x| (&x * &x + 1.0).sqrt())
}

/// 1 / (2 sin) of an angle in turns; +infinity at 0, -infinity at ½.
fn half_recip_sin() -> Function {
    Function::new("half_recip_sin", |x| 0.5 / x.sin_turns()).with_quarter_wave()
}

/// 1 / (2 cos) of an angle in turns; -infinity at ¼, +infinity at ¾.
fn half_recip_cos() -> Function {
    let sin = half_recip_sin();
    Function::new("half_recip_cos", |x| 0.5 / x.cos_turns()).advanced_of(&sin)
}

/// θ_prop of Lee et al., eq (26): `1 - acos(y)/90°`, which is asin in quarter turns.
fn prop() -> Function {
    Function::new("prop", |y| 4.0 * y.asin_turns())
}

/// `y / 2f`, with 0/0 taken as 0.
fn over_twice(y: &Expr, f: &Expr) -> Expr {
    y.equal(0.0).select(0.0, y / (2.0 * f))
}

/// Integer bits of the atan table's index. Beyond 2^k the result is off by 2^-k rad. With 2^a cells
/// over ±2^k, a direct cell is off by 2^(k-a) rad and a linear one by about 2^(2k-2a) rad.
fn atan_int_bits(values: &Values) -> u32 {
    let count = |bits: i64| u32::try_from(bits).expect("bug: counts of bits are small");
    let own = values.int("atan_addr_bits");
    let addr_bits = own.map_or_else(|| values.bits("table_addr_bits"), count);
    let balanced = values.scheme_of("atan", "scheme").balanced_int_bits(addr_bits);
    values.int("atan_int_bits").map_or(balanced.max(1), count)
}

fn cordic_iterations(values: &Values) -> u32 {
    match values.int("cordic_iterations") {
        Some(iterations) => u32::try_from(iterations).expect("bug: counts are small"),
        None => values.bits("frac_bits") + values.bits("guard_bits"),
    }
}

/// Variants `printed` and `corrected`: Fig. 7 with 6 tables, 3 multipliers, 8 adders.
fn seed(
    b: &mut Builder,
    plan: &mut Plan<'_>,
    inputs: [NodeId; 4],
    corrected: bool,
) -> Result<Vec<NodeId>> {
    let [phi_a, theta_a, phi_n, theta_n] = inputs;
    let (work, work_angle) = (plan.work_bits, plan.work_angle_bits);
    let full_circle = plan.values.choice("quadrants") == "full";
    let inner_turn = Format::turns(work_angle)?;

    // (6): X, Y. As printed they are halved, so Δ may not be reduced modulo a turn before.
    let (big_x, big_y) = b.scope("angles", |b| -> Result<_> {
        let difference = b.sub(phi_a, phi_n);
        b.name(difference, "delta_exact");
        let (delta, halves, format) = if corrected {
            (
                angle(b, "delta", difference, Format::turns(plan.angle_bits)?),
                0,
                Format::turns(plan.angle_bits)?,
            )
        } else {
            (difference, 1, Format::turns(plan.angle_bits + 1)?)
        };
        let sum = b.add(theta_a, delta);
        let sum = b.shift(sum, -halves);
        let difference = b.sub(theta_a, delta);
        let difference = b.shift(difference, -halves);
        Ok((angle(b, "ang_x", sum, format), angle(b, "ang_y", difference, format)))
    })?;
    let (sin_x, cos_x) = plan.sincos(b, big_x)?;
    let (sin_y, cos_y) = plan.sincos(b, big_y)?;
    for (node, name) in [(sin_x, "sin_x"), (cos_x, "cos_x"), (sin_y, "sin_y"), (cos_y, "cos_y")] {
        b.name(node, name);
    }

    // (7): theta_x = asin((sin X + sin Y) / 2), index -1 to 1.
    let sum = b.add(sin_x, sin_y);
    let mean = b.shift(sum, -1);
    let index = b.narrow(mean, number(0, work)?, plan.round, Overflow::Saturate);
    b.name(index, "sin_theta_x");
    let asin = plan.table(
        b,
        "asin",
        "asin_addr_bits",
        &[Function::asin()],
        index,
        Format::signed_turns(work_angle)?,
    )[0];
    b.turns(asin);
    let theta_x = if corrected {
        // ½ - asin where cos theta_a < 0: negate the angle and invert its top bit.
        let quarter = b.constant(1 << (plan.angle_bits - 2), Format::turns(plan.angle_bits)?);
        let three_quarters =
            b.constant(3 << (plan.angle_bits - 2), Format::turns(plan.angle_bits)?);
        let (past, before) = (b.less(quarter, theta_a), b.less(theta_a, three_quarters));
        let behind = b.and(past, before);
        b.means(behind, [theta_a], |[theta_a]| theta_a.cos_turns().less(0.0));
        b.name(behind, "behind");
        let minus = b.neg(asin);
        let minus = b.modulo(minus, inner_turn);
        let mirrored = polar::opposite(b, minus);
        let ahead = b.modulo(asin, inner_turn);
        b.mux(behind, mirrored, ahead)
    } else {
        asin
    };
    b.turns(theta_x);
    b.name(theta_x, "theta_x");

    // Z = theta_x - theta_n; the tables take it modulo a turn.
    let difference = b.sub(theta_x, theta_n);
    b.name(difference, "z_exact");
    let big_z = angle(b, "ang_z", difference, Format::signed_turns(work_angle)?);

    // (9), (27): (cos Y - cos X) over 2 sin Z and 2 cos Z.
    let y_double = b.sub(cos_y, cos_x);
    b.name(y_double, "y_double");
    let recip = number(plan.values.bits("recip_int_bits"), work)?;
    let size = "recip_addr_bits";
    let recip_sin = plan.table(b, "recip_sin", size, &[half_recip_sin()], big_z, recip)[0];
    let recip_cos = plan.table(b, "recip_cos", size, &[half_recip_cos()], big_z, recip)[0];
    b.name(recip_sin, "half_recip_sin");
    b.name(recip_cos, "half_recip_cos");
    let tan = b.mul(y_double, recip_sin);
    b.means(tan, [y_double, big_z], |[y, z]| over_twice(&y, &z.sin_turns()));
    let tan_format = number(atan_int_bits(plan.values), work)?;
    let tan = b.narrow(tan, tan_format, plan.round, Overflow::Saturate);
    b.name(tan, "tan_phi");
    let atan = plan.table(
        b,
        "atan",
        "atan_addr_bits",
        &[Function::atan()],
        tan,
        Format::signed_turns(work_angle)?,
    )[0];
    let phi = b.modulo(atan, inner_turn);
    let phi = if full_circle {
        let behind = b.negative(big_z);
        let turned = polar::opposite(b, phi);
        b.mux(behind, turned, phi)
    } else {
        phi
    };

    // (26), (27): theta_prop of y_k. Approximation errors can take y_k beyond 1, so the index
    // saturates.
    let y_k = b.mul(y_double, recip_cos);
    b.means(y_k, [y_double, big_z], |[y, z]| over_twice(&y, &z.cos_turns()));
    let y_k = b.narrow(y_k, number(0, work)?, plan.round, Overflow::Saturate);
    b.name(y_k, "y_k");
    let (index, distance) = if corrected {
        let magnitude = b.abs(y_k);
        let index = Format::unsigned(work, cast::signed_count(work))?; // -1 has the magnitude 1.0
        (b.narrow(magnitude, index, plan.round, Overflow::Saturate), b.abs(big_z))
    } else {
        (y_k, difference)
    };
    let prop = plan.table(b, "prop", "prop_addr_bits", &[prop()], index, number(1, work)?)[0];
    b.name(prop, "theta_prop");

    // (19): theta' = Z + (90° - Z) * theta_prop.
    let quarter = b.constant(1, Format::unsigned(1, 2)?);
    let rest = b.sub(quarter, distance);
    let part = b.mul(rest, prop);
    let theta = b.add(distance, part);
    Ok(vec![plan.angle_word(b, "phi", phi)?, plan.angle_word(b, "theta", theta)?])
}

/// Error of each of |x'|, |y'|, |z'|: the terms' weights add up to 2, so it is twice the table's
/// worst error plus the last rounding.
pub(super) fn component_bound(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    let ulp = 2f64.powi(-cast::signed_count(values.bits("frac_bits")));
    // Without an integer bit, 1.0 saturates to one ulp less.
    let saturation = if has_int_bit(values) { 0.0 } else { ulp };
    2.0 * worst("sincos") + rounding_ulp(values) * ulp + saturation
}

fn angle_bound(values: &Values, worst: &dyn Fn(&str) -> f64) -> f64 {
    polar_bound(values, worst, values.choice("output") == "polar-cordic")
}

/// True unless the components have no integer bit; only the rotation unit lets the user choose
/// that.
fn has_int_bit(values: &Values) -> bool {
    !values.has("int_bits") || *values.get("int_bits") != Value::Int(0)
}

/// Angle in rad between the exact vector and that of variant `exact` in a polar form: the error of
/// the components, then that of the conversion.
pub(super) fn polar_bound(values: &Values, worst: &dyn Fn(&str) -> f64, cordic: bool) -> f64 {
    let work_bits = values.bits("frac_bits") + values.bits("guard_bits");
    let work_ulp = 2f64.powi(-cast::signed_count(work_bits));
    let component = 2.0 * worst("sincos") + rounding_ulp(values) * work_ulp;
    converted_bound(values, worst, component, cordic)
}

/// Angle in rad between vectors after [`to_polar`] of a unit vector whose components are off by at
/// most `component`.
pub(super) fn converted_bound(
    values: &Values,
    worst: &dyn Fn(&str) -> f64,
    component: f64,
    cordic: bool,
) -> f64 {
    let ulp = |bits: u32| 2f64.powi(-cast::signed_count(bits));
    let guard_bits = values.bits("guard_bits");
    let work_ulp = ulp(values.bits("frac_bits") + guard_bits);
    let work_angle_ulp = ulp(values.bits("angle_bits") + guard_bits);
    let rounding = rounding_ulp(values);
    // Before conversion the vector is off by `vector` in length, so its angle is off by asin of
    // that, and its length is at least 1 - vector. A vector off by 1 may point anywhere.
    let vector = 3f64.sqrt() * component;
    if vector >= 1.0 {
        return std::f64::consts::PI;
    }
    let length = 1.0 - vector;
    // Each conversion gives two angles of plane vectors, azimuth and polar angle. An error `plane`
    // of a plane vector of length s turns it by asin(plane / s) if plane < s, and otherwise by any
    // angle. For the polar angle, s is the vector's length. For the azimuth, s is sin theta times
    // that; but the azimuth turns the vector only by sin theta times as much, so by at most twice
    // `plane`.
    let turned = |plane: f64| libm::asin((plane / length).min(1.0));
    let (azimuth, polar) = if cordic {
        // x, y and the angle keep `cordic_frac_bits`, so the dropped bits together stay below one
        // ulp of the kept word. The last step leaves at most its own angle as a rest.
        let iterations = cordic_iterations(values);
        let rest = 2f64.powi(1 - cast::signed_count(iterations));
        let dropped = 2.0 * turned(2.0 * work_ulp) + TAU * work_angle_ulp;
        // That rest also shortens the length from which the polar angle is computed, by 1 - cos of
        // it.
        (rest + dropped, rest + dropped + turned(1.0 - libm::cos(rest)))
    } else {
        // The ratio is off by the reciprocal's error, one rounding, and one ulp where it saturates
        // below 1. The slope of atan is at most 1 rad.
        let ratio = worst("recip") + (rounding + 1.0) * work_ulp;
        let angle = TAU * worst("atan") + ratio;
        // The length is off by the secant's error, and by the ratio's times a slope below 1.
        (angle, angle + turned(worst("atan") + ratio + 2.0 * work_ulp))
    };
    // Both angles are rounded to the ports' words.
    let port = rounding * TAU * ulp(values.bits("angle_bits"));
    (libm::asin(vector) + azimuth + polar + 2.0 * port).min(std::f64::consts::PI)
}

/// The golden model: the rotation in plain floating point, angles in turns.
///
/// Written from the mathematics, independent of the netlist. Exact up to float rounding, without
/// singularities.
fn golden<F: Real>(_: &Values) -> Golden<F> {
    const BLOCK: usize = 256;
    Golden::new(|inputs: &[&[F]], outputs: &mut [Vec<F>]| {
        let [phi_a, theta_a, phi_n, theta_n] = inputs else { panic!("bug: four inputs") };
        let [xs, ys, zs] = outputs else { panic!("bug: three outputs") };
        let zero = [F::default(); BLOCK];
        let (mut delta, mut sin_delta, mut cos_delta) = (zero, zero, zero);
        let (mut sin_a, mut cos_a, mut sin_n, mut cos_n) = (zero, zero, zero, zero);
        for start in (0..phi_a.len()).step_by(BLOCK) {
            let len = BLOCK.min(phi_a.len() - start);
            let block = start..start + len;
            for (delta, (a, n)) in
                delta.iter_mut().zip(phi_a[block.clone()].iter().zip(&phi_n[block.clone()]))
            {
                *delta = *a - *n;
            }
            F::sin_cos_turns(&delta[..len], &mut sin_delta[..len], &mut cos_delta[..len]);
            F::sin_cos_turns(&theta_a[block.clone()], &mut sin_a[..len], &mut cos_a[..len]);
            F::sin_cos_turns(&theta_n[block], &mut sin_n[..len], &mut cos_n[..len]);
            for i in 0..len {
                let (x, y, z) = (sin_a[i] * cos_delta[i], sin_a[i] * sin_delta[i], cos_a[i]);
                xs[start + i] = x * cos_n[i] - z * sin_n[i];
                ys[start + i] = y;
                zs[start + i] = x * sin_n[i] + z * cos_n[i];
            }
        }
    })
}

/// Directions A and N uniform on the sphere; on the lit side, A is mirrored where N·A < 0.
fn draw(_: &Values, _: &InputPorts<'_>) -> Draw {
    Draw::new(|sampler, uniform, columns, count| {
        for column in columns.iter_mut() {
            column.resize(count, 0.0);
        }
        for i in 0..count {
            for column in columns.iter_mut() {
                column[i] = uniform.draw();
            }
        }
        vectorised(Directions { columns, lit: sampler == Sampler::Lit });
    })
}

/// Converts numbers from 0 to 1 to the azimuths and polar angles of directions.
struct Directions<'a> {
    columns: &'a mut [Vec<f64>],
    lit: bool,
}

impl Body for Directions<'_> {
    #[inline(always)]
    fn run(self) {
        let [phi_a, theta_a, phi_n, theta_n] = self.columns else { panic!("bug: four inputs") };
        let columns = phi_a.iter_mut().zip(theta_a).zip(phi_n).zip(theta_n);
        for (((phi_a, theta_a), phi_n), theta_n) in columns {
            let (za, zn) = (1.0 - 2.0 * *theta_a, 1.0 - 2.0 * *theta_n);
            let cos_delta = sin_cos_turns(*phi_a - *phi_n).1;
            let along = za * zn + ((1.0 - za * za) * (1.0 - zn * zn)).sqrt() * cos_delta;
            let mirrored = self.lit && along < 0.0;
            let half_on = if *phi_a < 0.5 { *phi_a + 0.5 } else { *phi_a - 0.5 };
            *phi_a = if mirrored { half_on } else { *phi_a };
            *theta_a = acos_turns(if mirrored { -za } else { za });
            *theta_n = acos_turns(zn);
        }
    }
}

/// The named hard cases, as words.
fn hard_cases(values: &Values) -> Vec<HardCase> {
    let bits = values.bits("angle_bits");
    let turn = 1i64 << bits;
    let (half, quarter, eighth) = (turn / 2, turn / 4, turn / 8);
    let word = |w: i64| w.rem_euclid(turn);
    let cases = |name, words: Vec<[i64; 4]>| {
        let words = words.into_iter().map(|case| case.map(word).to_vec());
        HardCase::new(name, words.collect())
    };
    let near = |centre: i64| [centre - 1, centre, centre + 1];
    let azimuths = [0, 1, eighth, quarter, half - 1, half, half + quarter, turn - 1];
    let polars = [0, 1, eighth, quarter - 1, quarter, quarter + 1, half - eighth, half - 1, half];

    let mut poles = Vec::new();
    let mut both_poles = Vec::new();
    for pole in [0, 1, half - 1, half, half + 1] {
        for phi in azimuths {
            for theta in polars {
                poles.push([phi, pole, 0, theta]);
                poles.push([0, theta, phi, pole]);
            }
        }
        for other in [0, 1, half - 1, half, half + 1] {
            both_poles.extend(azimuths.map(|phi| [phi, pole, 0, other]));
        }
    }
    let mut wrap = Vec::new();
    for (a, n) in [(0, turn - 1), (turn - 1, 0), (0, 0), (turn - 1, turn - 1), (half, 0), (0, half)]
    {
        for theta in polars {
            wrap.extend(polars.map(|normal| [a, theta, n, normal]));
        }
    }
    let (mut parallel, mut opposite, mut right_angle, mut grazing) =
        (vec![], vec![], vec![], vec![]);
    for phi in azimuths {
        for theta in polars {
            parallel.extend(near(theta).map(|t| [phi, t, phi, theta]));
            opposite.extend(near(half - theta).map(|t| [phi + half, t, phi, theta]));
            right_angle.extend(near(theta + quarter).map(|t| [phi, t, phi, theta]));
            grazing.extend(near(quarter).map(|t| [phi + quarter, t, phi, theta]));
        }
    }
    let mut sin_z = Vec::new();
    let mut cos_z = Vec::new();
    let mut cancel = Vec::new();
    let mut unit = Vec::new();
    for theta in polars {
        for delta in [-1, 0, 1] {
            sin_z.extend(near(theta).map(|t| [delta, t, 0, theta]));
            cos_z.extend(near(theta + quarter).map(|t| [delta, t, 0, theta]));
            cancel.extend(polars.map(|t| [delta, t, 0, theta]));
            cancel.extend(polars.map(|t| [half + delta, t, 0, theta]));
            unit.extend(near(quarter).map(|t| [quarter + delta, t, 0, theta]));
            unit.extend(near(quarter).map(|t| [-quarter + delta, t, 0, theta]));
        }
    }
    // The first and last entry and the joints of each table, through an input that leads there. For
    // tables of more than 2^14 entries, only 2^14 joints.
    let cells = |size: &str| {
        let own = values.int(size);
        let bits = own.unwrap_or_else(|| values.int("table_addr_bits").expect("bug: no auto here"));
        1i64 << bits.min(14)
    };
    let at = |turns: f64| cast::i64_of((turns * cast::f64_of(turn)).round());
    let share = |cell: i64, cells: i64| cast::f64_of(cell) / cast::f64_of(cells);
    let joints = |size: &str, case: &dyn Fn(f64) -> (i64, [i64; 4], usize)| {
        let count = cells(size);
        let mut all = Vec::new();
        for cell in 0..=count {
            let (word, mut vector, port) = case(share(cell, count));
            for word in near(word) {
                vector[port] = word;
                all.push(vector);
            }
        }
        all
    };
    // With N at the pole, theta_a is the angle of X, Y and Z, and sin theta_a is asin's index.
    // delta is phi', whose tangent is atan's index. At theta_a = ¼ turn, sin delta is y_k. The
    // exact unit's tables take the larger component, ½ to 1, and the ratio of two components, 0 to
    // 1.
    let exact = values.choice("variant") == "exact";
    let arc = |sine: f64| at(asin_turns(sine));
    let sincos_joints = joints("sincos_addr_bits", &|x| (at(x), [0; 4], 1));
    let recip_joints = joints("recip_addr_bits", &|x| {
        let angle = if exact { arc(0.5 + 0.5 * x) } else { at(x) };
        (angle, [eighth, 0, eighth, 0], 1)
    });
    let asin_joints = joints("asin_addr_bits", &|x| (arc(2.0 * x - 1.0), [0; 4], 1));
    let limit = 2f64.powi(cast::signed_count(atan_int_bits(values)));
    let atan_joints = joints("atan_addr_bits", &|x| {
        let tangent = if exact { x } else { limit * (2.0 * x - 1.0) };
        (at(atan_turns(tangent)), [0, eighth, 0, 0], 0)
    });
    let prop_joints = joints("prop_addr_bits", &|x| {
        let sine = if values.choice("variant") == "printed" { 2.0 * x - 1.0 } else { x };
        (arc(sine), [0, quarter, 0, 0], 0)
    });
    vec![
        cases("poles: theta = 0 or half a turn, and one word off to either side", poles),
        cases("both vectors at a pole", both_poles),
        cases("phi wrap: first and last word", wrap),
        cases("A parallel to N, and one word off", parallel),
        cases("A opposite to N, and one word off", opposite),
        cases("A at a right angle to N in its plane", right_angle),
        cases("grazing light across N", grazing),
        cases("sin Z at and next to 0", sin_z),
        cases("cos Z at and next to 0", cos_z),
        cases("cancellation in cos Y - cos X", cancel),
        cases("y_k and components at plus and minus 1", unit),
        cases("first and last entry and joints of the sin & cos table", sincos_joints),
        cases("first and last entry and joints of the reciprocal tables", recip_joints),
        cases("first and last entry and joints of the asin table", asin_joints),
        cases("first and last entry and joints of the atan table", atan_joints),
        cases("first and last entry and joints of T_prop", prop_joints),
    ]
}
