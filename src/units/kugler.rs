//! The intelligent memory IMEM of Kugler 1998, as Lee et al. describe and count it: polar, with
//! maps.
//!
//! Lee et al. say that the normal comes in Cartesian form and is converted to angles. It is
//! perturbed "by using three rotations, which are executed by two additions and one look-up table
//! access", a map of 32 KB. Light maps of 2^20 × 16 bits, addressed by the perturbed direction,
//! give the light. The rest is a reconstruction. The three rotations of N' are about z by psi (an
//! addition), about y by theta_n (the map, addressed by azimuth, polar angle and theta_n) and about
//! z by phi_n (an addition). The address of a light map is N' rotated so that the light is at the
//! pole, which takes a subtraction and the same map.
//!
//! A map entry is exact in the middle of its cell. The maps' sizes are parameters: Kugler's are
//! `tilt_addr_bits=14` and `map_addr_bits=20`.

use super::illumination::{self, Curve, components, golden_dot, golden_light};
use super::parts::fragment;
use super::parts::plan::{self, Plan, angle, number};
use super::parts::polar::opposite;
use super::rotation::{inclination, to_polar};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::{Bounds, Design, Golden, Group, Param, Role, Shading, Shape, Unit, Values};
use crate::netlist::{Builder, Column, NodeId, Quantity, Table, TableId};
use crate::number::format::{Format, Overflow, Round, quantize, word_mask};
use crate::number::real::{Expr, Graph, Twin};
use crate::number::trig::Real;
use std::sync::Arc;

/// The unit.
#[must_use]
pub fn unit() -> Unit {
    Unit::new("kugler", "light of a bump-mapped pixel by rotations and light maps, without dot products")
        .source("Kugler 1998 (IMEM), as Lee et al. describe it; largely a reconstruction")
        .formula(format!(
            "N = (phi, theta) by its components; N' is (phi_p, theta_p) turned by psi about z, by theta about y, by phi about z\n\
             N'.L is the cosine of the polar angle of N' once L is turned to the pole; N'.H likewise; L' = L and H' = H below\n\
             {}",
            illumination::REFLECTION
        ))
        .params([
            Param::choice("conversion", ["table", "cordic"]).help("how the normal is converted to angles"),
            Param::bits("tilt_addr_bits", 6..=20)
                .role(Role::TableSize)
                .default(14)
                .help("address bits of the map that rotates a direction about y, divided among its three angles"),
            Param::bits("map_angle_bits", 2..=16)
                .default(8)
                .help("bits of each angle in that map; an LSB of a polar angle is half an LSB of an azimuth"),
            Param::bits("map_addr_bits", 4..=20)
                .role(Role::TableSize)
                .default(12)
                .help("address bits of each light map, divided between its two angles; the paper's have 20"),
            plan::angle_bits(),
            plan::table_addr_bits(),
            Param::scheme("scheme"),
            plan::quarter_wave(),
            plan::frac_bits(),
            plan::guard_bits(),
            Param::rounding("rounding"),
            plan::recip_addr_bits(),
            plan::atan_addr_bits(),
            plan::cordic_iterations(),
            illumination::highlight(),
            illumination::light_bits(),
            illumination::ambient(),
            illumination::diffuse(),
            illumination::specular(),
            illumination::exponent(),
        ])
        .inputs("n_x, n_y, n_z; psi, phi_p, theta_p (the bump vector in the texture frame), phi_l, theta_l, phi_h, theta_h: angles, theta up to half a turn")
        .outputs("intensity, diffuse (with the ambient light), specular: 0 to 1")
        .shades(Shading::Pipeline)
        .design(design)
}

fn design(values: &Values) -> Result<Design> {
    let highlight = values.flag("highlight");
    let mut plan = Plan::new(values);
    let mut b = values.builder("kugler");
    let turn = Format::turns(plan.angle_bits)?;
    let component = number(1, plan.frac_bits)?;
    let normal = ["n_x", "n_y", "n_z"].map(|name| b.input(name, component, Quantity::Number));
    let mut turns = |name: &str| b.input(name, turn, Quantity::Turns);
    let [psi, phi_p, theta_p] = ["psi", "phi_p", "theta_p"].map(&mut turns);
    let mut lights = vec![["phi_l", "theta_l"].map(&mut turns)];
    if highlight {
        lights.push(["phi_h", "theta_h"].map(&mut turns));
    }
    let map = tilt_map(&mut b, values)?;
    let world = b.scope("setup", |b| -> Result<[NodeId; 2]> {
        let work = number(1, plan.work_bits)?;
        let wide = normal.map(|axis| b.narrow(axis, work, plan.round, Overflow::Saturate));
        let cordic = values.choice("conversion") == "cordic";
        let [phi_n, theta_n] = b.scope("normal", |b| to_polar(b, &mut plan, wide, cordic))?;
        let sum = b.add(phi_p, psi);
        let phi = angle(b, "phi_texture", sum, turn);
        let [phi, theta] = tilt(b, values, map, [phi, theta_p], theta_n)?;
        let sum = b.add(phi, phi_n);
        let format = Format::turns(plan.angle_bits.max(values.bits("map_angle_bits")))?;
        Ok([angle(b, "phi", sum, format), b.name(theta, "theta")])
    })?;
    let bits = values.bits("light_bits");
    let output = Format::unsigned(bits, cast::signed_count(bits))?;
    let names = ["diffuse", "specular"];
    let mut parts = Vec::new();
    for (which, [phi_a, theta_a]) in lights.iter().enumerate() {
        parts.push(b.scope(["light", "half"][which], |b| -> Result<NodeId> {
            // Rotating by -theta_a about y is rotating by theta_a with both azimuths half a turn
            // on.
            let difference = b.sub(world[0], *phi_a);
            let format = b.format(world[0]);
            let format = Format::turns(format.bits().max(plan.angle_bits))?;
            let delta = angle(b, "delta", difference, format);
            let behind = opposite(b, delta);
            b.turns(behind);
            let [phi, theta] = tilt(b, values, map, [behind, world[1]], *theta_a)?;
            let phi = opposite(b, phi);
            b.turns(phi);
            b.name(phi, "phi");
            b.name(theta, "theta");
            light_map(b, values, names[which], [phi, theta], output)
        })?);
    }
    b.name(parts[0], "diffuse");
    let mut intensity = parts[0];
    if let [diffuse, specular] = parts[..] {
        b.name(specular, "specular");
        let sum = b.add(diffuse, specular);
        intensity = b.narrow(sum, output, plan.round, Overflow::Saturate);
        b.name(intensity, "intensity");
    }
    b.output("intensity", intensity);
    for (part, name) in parts.iter().zip(names) {
        b.output(name, *part);
    }
    let tabulated = plan.tabulated;
    let netlist = b.build()?;
    let mut groups = Group::ports(&netlist, illumination::light_ports(values))?;
    let inside = |name, scope: &str| {
        let labels = ["phi", "theta"].map(|a| format!("{scope}.{a}"));
        Group::inside(&netlist, name, Shape::Polar, labels)
    };
    groups.push(inside("pw", "setup")?);
    groups.push(inside("pl", "light")?);
    if highlight {
        groups.push(inside("ph", "half")?);
    }
    let hard = fragment::hard_cases(&netlist);
    Ok(Design::new(values, netlist)
        .groups(groups)
        .goldens(golden::<f64>, golden::<f32>)
        .draw(fragment::draw)
        .hard(hard)
        .bounds(Bounds::unstated(
            "near a pole, one cell of a map spans all azimuths, so no cell size bounds the error of the light",
        ))
        .tabulated(tabulated))
}

/// Address bits of a map's azimuth, polar angle, and rotation angle.
fn tilt_bits(values: &Values) -> [u32; 3] {
    let bits = values.bits("tilt_addr_bits");
    // Polar angles span half a turn: the same number of bits makes cells half as high as wide.
    [bits.div_ceil(3), (bits + 1) / 3, bits / 3]
}

/// Bits of the azimuth and the polar angle that address a light map.
fn map_bits(values: &Values) -> [u32; 2] {
    let bits = values.bits("map_addr_bits");
    [bits / 2, bits - bits / 2]
}

/// The middle of cell `i` of `2^bits` over `span` turns.
fn middle(i: i64, bits: u32, span: f64) -> f64 {
    (cast::f64_of(i) + 0.5) * span * 2f64.powi(-cast::signed_count(bits))
}

/// Azimuth and polar angle of a direction after rotation about y by an angle from z to x, all in
/// turns. The direction is given by its azimuth and polar angle.
fn tilted([phi, theta, by]: &[Expr; 3]) -> [Expr; 2] {
    let ((sin_phi, cos_phi), (sin_theta, cos_theta), (sin_by, cos_by)) = (
        (phi.sin_turns(), phi.cos_turns()),
        (theta.sin_turns(), theta.cos_turns()),
        (by.sin_turns(), by.cos_turns()),
    );
    let (x, y) = (&sin_theta * cos_phi, &sin_theta * sin_phi);
    let (x, z) = (&x * &cos_by + &cos_theta * &sin_by, &cos_theta * &cos_by - &x * &sin_by);
    [y.atan2_turns(&x), inclination(&x, &y, &z)]
}

/// The map of directions rotated about y.
fn tilt_map(b: &mut Builder, values: &Values) -> Result<TableId> {
    let [phi_bits, theta_bits, by_bits] = tilt_bits(values);
    let word_bits = values.bits("map_angle_bits");
    let azimuth = Format::turns(word_bits)?;
    let polar = Format::unsigned(word_bits, cast::signed_count(word_bits) + 1)?; // below ½
    let addr_bits = phi_bits + theta_bits + by_bits;
    let mut graph = Graph::default();
    let variables: [Expr; 3] = Expr::variables();
    let ids = variables.each_ref().map(|variable| graph.merge(variable));
    let [phi_at, theta_at] = tilted(&variables).map(|angle| graph.insert(&angle, &ids));
    let (mut phis, mut thetas) = (Vec::new(), Vec::new());
    for address in 0..1i64 << addr_bits {
        let by = address & word_mask(by_bits);
        let theta = address >> by_bits & word_mask(theta_bits);
        let phi = address >> (by_bits + theta_bits);
        let of =
            [middle(phi, phi_bits, 1.0), middle(theta, theta_bits, 0.5), middle(by, by_bits, 0.5)];
        let values = graph.values(&Twin, &of);
        let (phi, theta) = (values[phi_at.index()], values[theta_at.index()]);
        phis.push(quantize(phi, azimuth, Round::HalfEven, Overflow::Wrap)?.0);
        thetas.push(quantize(theta, polar, Round::HalfEven, Overflow::Saturate)?.0);
    }
    let column = |name: &str, format, words: Vec<i64>| Column {
        name: name.to_owned(),
        format,
        words: Arc::from(words),
    };
    let columns = vec![column("phi", azimuth, phis), column("theta", polar, thetas)];
    Ok(b.table(Table { name: "tilt_map".to_owned(), addr_bits, columns, memory: None }))
}

/// The top bits of an azimuth.
fn azimuth_index(b: &mut Builder, phi: NodeId, bits: u32) -> Result<NodeId> {
    let format = b.format(phi);
    if format.bits() >= bits {
        return Ok(b.slice(phi, format.bits() - bits, bits));
    }
    let missing = bits - format.bits();
    let zeros = b.constant(0, Format::integer(missing)?);
    let word = b.slice(phi, 0, format.bits());
    Ok(b.concat(word, zeros))
}

/// The top bits of a polar angle, whose words span half a turn; larger angles saturate.
fn polar_index(b: &mut Builder, theta: NodeId, bits: u32) -> Result<NodeId> {
    let format = Format::unsigned(bits, cast::signed_count(bits) + 1)?;
    let index = b.narrow(theta, format, Round::Floor, Overflow::Saturate);
    Ok(b.slice(index, 0, bits))
}

/// A direction rotated about y by one access to the map.
fn tilt(
    b: &mut Builder,
    values: &Values,
    map: TableId,
    [phi, theta]: [NodeId; 2],
    by: NodeId,
) -> Result<[NodeId; 2]> {
    let [phi_bits, theta_bits, by_bits] = tilt_bits(values);
    let high = azimuth_index(b, phi, phi_bits)?;
    let middle = polar_index(b, theta, theta_bits)?;
    let low = polar_index(b, by, by_bits)?;
    let address = b.concat(high, middle);
    let address = b.concat(address, low);
    Ok([false, true].map(|polar| {
        let word = b.read(map, usize::from(polar), address);
        b.turns(word);
        b.means(word, [phi, theta, by], |of| {
            let [phi, theta] = tilted(&of);
            if polar { theta } else { phi }
        })
    }))
}

/// The light of a direction seen from the light's pole.
fn light_map(
    b: &mut Builder,
    values: &Values,
    name: &str,
    [phi, theta]: [NodeId; 2],
    output: Format,
) -> Result<NodeId> {
    let (offset, exponent) = match name {
        "diffuse" => (values.real("ambient"), 1),
        _ => (0.0, u8::try_from(values.bits("exponent")).expect("bug: at most 255")),
    };
    let function = Curve { offset, factor: values.real(name), exponent }.function();
    let [phi_bits, theta_bits] = map_bits(values);
    let row = (0..1i64 << theta_bits).map(|i| {
        let cosine = crate::number::function::cos_turns(middle(i, theta_bits, 0.5));
        // With exponent 0 the function isn't 0 at negative cosines, but the light is.
        let light = if cosine > 0.0 { function.eval(cosine) } else { offset };
        Ok(quantize(light, output, Round::HalfEven, Overflow::Saturate)?.0)
    });
    let row = row.collect::<Result<Vec<i64>>>()?;
    // With one light at the pole, all azimuths have the same light; a map could hold any number of
    // lights.
    let words = row.repeat(1 << phi_bits);
    let column = Column { name: "light".to_owned(), format: output, words: Arc::from(words) };
    let table = Table {
        name: format!("{name}_map"),
        addr_bits: phi_bits + theta_bits,
        columns: vec![column],
        memory: None,
    };
    let map = b.table(table);
    let high = azimuth_index(b, phi, phi_bits)?;
    let low = polar_index(b, theta, theta_bits)?;
    let address = b.concat(high, low);
    let light = b.read(map, 0, address);
    Ok(b.means(light, [theta], |[theta]| function.of(&theta.cos_turns())))
}

/// The golden model: N' in the world by the axes of N's own frame, and dot products with L and H;
/// also the direction of N' in the frames of N, L and H.
fn golden<F: Real>(values: &Values) -> Golden<F> {
    let light = golden_light(values);
    Golden::new(move |inputs: &[&[F]], outputs: &mut [Vec<F>]| {
        let [nx, ny, nz, psi, phi_p, theta_p] = inputs[..6] else { panic!("bug: N, psi, N'") };
        let lights = &inputs[6..];
        let len = psi.len();
        let (zero, one) = (F::zero(), F::one());
        let turned: Vec<F> = phi_p.iter().zip(psi).map(|(phi, psi)| *phi + *psi).collect();
        let [px, py, pz] = components(&turned, theta_p);
        // Sines and cosines of the polar form of N. At a pole its azimuth is 0; a zero N counts as
        // at the pole.
        let mut world = [vec![zero; len], vec![zero; len], vec![zero; len]];
        for i in 0..len {
            let across = (nx[i] * nx[i] + ny[i] * ny[i]).sqrt();
            let length = (across * across + nz[i] * nz[i]).sqrt();
            let (cos_phi, sin_phi) =
                if across > zero { (nx[i] / across, ny[i] / across) } else { (one, zero) };
            let (cos_theta, sin_theta) =
                if length > zero { (nz[i] / length, across / length) } else { (one, zero) };
            let along = px[i] * cos_theta + pz[i] * sin_theta;
            world[0][i] = along * cos_phi - py[i] * sin_phi;
            world[1][i] = along * sin_phi + py[i] * cos_phi;
            world[2][i] = pz[i] * cos_theta - px[i] * sin_theta;
        }
        let mut dots = Vec::new();
        let mut directions = vec![world.clone()];
        for pair in lights.chunks(2) {
            let a = components(pair[0], pair[1]);
            dots.push(golden_dot([&a[0], &a[1], &a[2]], [&world[0], &world[1], &world[2]]));
            let (mut sin_phi, mut cos_phi) = (vec![zero; len], vec![zero; len]);
            let (mut sin_theta, mut cos_theta) = (vec![zero; len], vec![zero; len]);
            F::sin_cos_turns(pair[0], &mut sin_phi, &mut cos_phi);
            F::sin_cos_turns(pair[1], &mut sin_theta, &mut cos_theta);
            let mut seen = world.clone();
            for i in 0..len {
                let along = world[0][i] * cos_phi[i] + world[1][i] * sin_phi[i];
                seen[0][i] = along * cos_theta[i] - world[2][i] * sin_theta[i];
                seen[1][i] = world[1][i] * cos_phi[i] - world[0][i] * sin_phi[i];
                seen[2][i] = along * sin_theta[i] + world[2][i] * cos_theta[i];
            }
            directions.push(seen);
        }
        light(&dots, outputs); // the dot products are overwritten by the directions below
        let first = outputs.len() - 3 * directions.len();
        for (column, axis) in outputs[first..].iter_mut().zip(directions.into_iter().flatten()) {
            *column = axis;
        }
    })
}
