//! Runs every vertex under every light through the unit `emboss`.

use super::front::{Coordinates, Front};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::measure::quantize_inputs;
use crate::number::format::Format;
use crate::shading::render::block::BlockShot;
use crate::shading::render::named::Stage;
use glam::DVec2;
use std::collections::BTreeMap;

/// The smallest scale of the matrix, in ulps.
const LEAST_SCALE_ULPS: f64 = 4.0;

/// Runs every vertex under every light through the unit `emboss`; also returns the texels per unit
/// of its coordinates.
pub(super) fn displaced(
    front: &Front<'_>,
    stage: &Stage,
    shot: &mut BlockShot,
) -> Result<(Coordinates, f64)> {
    let scene = front.scene;
    let strength = scene.emboss.strength;
    let plain = &front.toward.plain; // the same either way
    let farthest = plain.iter().map(|at| at.abs().max_element()).fold(0.0, f64::max);
    // Texels per unit of the coordinate words; the strength must be at most 1 such unit.
    let reach = stage.reach("s0");
    let step = (0..32)
        .map(|k| 2f64.powi(k))
        .find(|step| farthest + strength + 1.0 <= reach * step && strength <= *step);
    let step = step.ok_or_else(|| {
        Error::usage(format!(
            "a texture coordinate of {farthest} texels is beyond the emboss unit: give the object smaller ones, or the unit more texture_int_bits"
        ))
    })?;
    let scale = strength / step;
    // With a scale of less than a few ulps of the matrix, the relief would silently be lost or
    // coarsely rounded.
    let ulp = stage.port("m0_x").map_or(0.0, Format::ulp);
    if strength > 0.0 && scale < LEAST_SCALE_ULPS * ulp {
        return Err(Error::usage(format!(
            "a strength of {strength} texels is {scale:.3e} in the emboss unit's coordinates, whose unit is {step} texels, but its matrix has \
             steps of {ulp:.3e}: give the object smaller texture coordinates, or the unit more texture_int_bits or matrix_bits"
        )));
    }
    let reach = stage.reach("vertex_x");
    let rows = [0, 1, 2].map(|row| front.turn.row(row));
    let mut runner = stage.program.runner();
    let (mut words, mut undisplaced) = (Vec::new(), Vec::new());
    let mut all = Vec::new();
    for light in &scene.lights {
        let mut columns: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        let mut put = |name: &str, value: f64| {
            columns.entry(name.to_owned()).or_default().push(value);
        };
        for (number, (vertex, world)) in front.eye.iter().zip(&front.mesh.vertices).enumerate() {
            let place = front.light_in_eye(light, number);
            for (what, at) in [("vertex", vertex.position), ("light", place)] {
                let far = at.abs().max_element();
                if far > reach {
                    return Err(Error::usage(format!(
                        "a {what} is {far} from the camera along an axis, but the emboss unit's positions end at {reach}: make the scene smaller, increase -p position_bits, or decrease -p position_frac_bits"
                    )));
                }
            }
            let texels = plain[number];
            let vectors = [
                ("vertex", vertex.position),
                ("light", place),
                ("m0", rows[0] * scale),
                ("m1", rows[1] * scale),
                ("m2", rows[2] * scale),
                ("tangent", world.tangent),
                ("binormal", world.binormal),
                ("normal", vertex.normal),
                ("ct", vertex.binormal),
            ];
            for (name, vector) in vectors {
                for (axis, value) in ["x", "y", "z"].iter().zip(vector.to_array()) {
                    put(&format!("{name}_{axis}"), value);
                }
            }
            let numbers = [
                ("s0", texels.x / step),
                ("t0", texels.y / step),
                ("q0", 1.0),
                ("r0", 0.0),
                ("ks", scale * vertex.handedness),
                ("kt", scale),
            ];
            numbers.into_iter().for_each(|(name, value)| put(name, value));
        }
        let columns = stage.inputs(columns);
        quantize_inputs(&stage.design.netlist, &columns, &mut words)?;
        let out = stage.run(&mut runner, &words, shot, 0);
        let ulp = [stage.ulp("s1") * step, stage.ulp("t1") * step];
        let value =
            |(s, t): (&i64, &i64)| DVec2::new(cast::f64_of(*s) * ulp[0], cast::f64_of(*t) * ulp[1]);
        all.push(out["s1"].iter().zip(&out["t1"]).map(value).collect());
        // Input and output ports have the same format.
        let netlist = &stage.design.netlist;
        let port = |name: &str| (0..words.len()).find(|at| netlist.input_name(*at) == name);
        let [s0, t0] = ["s0", "t0"].map(|name| &words[port(name).expect("bug: a port")]);
        undisplaced = s0.iter().zip(t0).map(value).collect();
    }
    Ok((Coordinates { plain: undisplaced, displaced: all }, step))
}
