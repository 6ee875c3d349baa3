//! Scenes by emboss: displaced texture coordinates per vertex, texels and a combiner per pixel.
//!
//! The scene's surfaces are tessellated ([`Scene::tessellate`]). Per vertex and light the unit `emboss` displaces
//! the texture coordinates; rays interpolate the plain and the displaced ones in floating point; per pixel the
//! units `sampler` and `combine` look the height map up and add the differences to the diffuse light, which is the
//! texture's colour times light computed per vertex (Gouraud). There is no specular light.
//!
//! Each setting keeps the convention of its seed, and what looks raised in one does in the other:
//!
//! - `emboss-gx` displaces toward the light, and adds h(undisplaced) - h(displaced). The sign of L departs from that of
//!   the patents, which is `light_sign = "vertex-light"` in `[emboss]` and turns what looks raised.
//! - `emboss-nv` displaces away from the light, as the extension's CT points along growing t, and adds
//!   h(displaced) - h(undisplaced).
//!
//! These are two pictures of one relief, a displacement apart, so each has its golden: the same in `f64` without any
//! rounding: displacements `± strength (T·L)/|L|` and
//! `± strength (B·L)/|L|`, in texels, and interpolation between exact texels. What a picture and its golden share is the front end (surfaces,
//! rays and their weights, light per vertex, the texture's colour) and the texels of the height map, which have 8
//! bits. Of `scale` in `[height]` only the sign counts: a negative one makes dents of bumps.
//!
//! # Where binary points are
//! The unit `emboss` counts texture coordinates in steps of 2^k texels, the same along both axes: then the
//! matrix and displacements use the range of their words, and the map's size is a power of two away.
//! k is the least that gives room to every coordinate of the scene.
//!
//! - `emboss-gx`: the matrix is the camera's times the strength in those steps, so its scale is the strength, and T
//!   and B are unit vectors.
//! - `emboss-nv`: Ks and Kt are the strength in those steps. The extension's current texture coordinate CT is B, along
//!   which t grows, so that its BN is -T and its T is B. As N × CT knows nothing of mirrored textures, Ks is
//!   negative where one is.
//!
//! A directional light stands [`FAR_AWAY`] from the vertex, in both models.
//!
//! # Bound
//! Where heights are looked up bilinearly the largest difference to the golden is bounded: a position that is off by
//! d texels is off by at most d times the largest difference of neighbouring texels. Positions of vertices
//! are compared with the golden's; interpolation makes no error larger.

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::design::Unit;
use crate::measure::{BoundCheck, quantize_inputs};
use crate::number::format::Format;
use crate::shading::render::named::Stage;
use crate::shading::render::{
    Block, BlockShot, Gathered, Pipeline, Rendered, Shot, count, gather, median_rate, overflows,
};
use crate::shading::scene::{
    Address, Filter, Light, LightSign, Place, Scene, Seen, Tessellation, Vertex,
};
use crate::sim::batch::Runner;
use crate::units::combine::COMBINE;
use crate::units::sampler::SAMPLER;
use glam::{DMat3, DVec2, DVec3};
use serde::Serialize;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;
use std::time::Instant;

/// Units behind the emboss unit.
pub(in crate::shading::render) static BEHIND: [&Unit; 2] = [&SAMPLER, &COMBINE];

/// Parameters of the units that the pipeline's name and the scene give.
pub(in crate::shading::render) const FROM_SCENE: &[&str] = &[
    "setting",
    "frame",
    "normalise_basis",
    "s_vector",
    "t_sign",
    "scale_q",
    "constants",
    "ks",
    "kt",
    "l_sign",
    "texture_size",
    "filter",
    "address_s",
    "address_t",
    "int_bits",
    "log2_width",
    "log2_height",
    "lights",
    "gain_log2",
    "difference",
    "light",
    "source",
    "destination",
];

/// How far a directional light is from what it shines on.
pub const FAR_AWAY: f64 = 1024.0;

/// Codes of texels and channels that stand for 1, of 8 bits: what a map holds.
const TEXEL_MAX: f64 = 255.0;

/// What is known of an emboss beside its picture.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Known {
    /// What no channel can be off by more than, in linear light; unknown for `filter = "nearest"`, where a
    /// position beside a texel's border may be on its other side.
    pub bound: Option<f64>,
    /// The largest error of a displaced texture coordinate of any vertex under any light, in texels.
    pub displacement_max_texels: f64,
    /// Texels that the emboss unit counts as 1.
    pub step_texels: f64,
}

/// Texture coordinates of every vertex, in texels: plain, and displaced by each light.
#[derive(Clone, Default)]
struct Coordinates {
    plain: Vec<DVec2>,
    displaced: Vec<Vec<DVec2>>,
}

/// Which way a setting displaces, and so which of two samples it takes from the other.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Way {
    /// To the light.
    Toward,
    /// From it.
    Away,
}

impl Way {
    fn of(pipeline: &Pipeline) -> Self {
        let nv = pipeline.assignments.iter().any(|set| set == "setting=nv");
        if nv { Self::Away } else { Self::Toward }
    }

    /// The factor of displacements, and of the undisplaced height less the displaced one.
    fn sign(self) -> f64 {
        match self {
            Self::Toward => 1.0,
            Self::Away => -1.0,
        }
    }

    /// The parameter of the combiner.
    fn difference(self) -> &'static str {
        match self {
            Self::Toward => "undisplaced-displaced",
            Self::Away => "displaced-undisplaced",
        }
    }
}

/// What the goldens and all pipelines share of a scene.
struct Front<'a> {
    scene: &'a Scene,
    mesh: Tessellation,
    /// From the world's axes to the camera's: rows are its right, its up, and backwards.
    turn: DMat3,
    /// Vertices in the order of the mesh, in the camera's space.
    eye: Vec<Vertex>,
    /// The light of each vertex.
    light: Vec<f64>,
    /// Texels of the height map, 0 to 255, the row of t = 0 first.
    texels: Vec<u8>,
    /// Columns and rows.
    size: [u32; 2],
    toward: Coordinates,
    away: Coordinates,
}

impl<'a> Front<'a> {
    fn new(scene: &'a Scene) -> Result<Self> {
        let (width, height) = scene.bumps.size();
        let fits = |side: u32| side.is_power_of_two() && (2..=8192).contains(&side);
        if !fits(width) || !fits(height) {
            return Err(Error::usage(format!(
                "a height map of {width} x {height} texels: for an emboss, legal are sides of powers of two from 2 to 8192; give [height] such `width` and `height`, or scale its file"
            )));
        }
        let columns = cast::index_of_u32(width);
        let dents = scene.bumps.scale() < 0.0;
        let code = |height: &f64| {
            let height = if dents { 1.0 - height } else { *height };
            u8::try_from(cast::i64_of((height.clamp(0.0, 1.0) * TEXEL_MAX).round()))
                .expect("bug: heights are 0 to 1")
        };
        let rows = scene.bumps.heights().chunks(columns).rev();
        let texels: Vec<u8> = rows.flatten().map(code).collect();
        let mesh = scene.tessellate()?;
        let camera = &scene.camera;
        let back = (camera.eye - camera.target).normalize();
        let right = camera.up.normalize().cross(back).normalize();
        let turn = DMat3::from_cols(right, back.cross(right), back).transpose();
        let to_eye = |vertex: &Vertex| Vertex {
            position: turn * (vertex.position - camera.eye),
            normal: turn * vertex.normal,
            tangent: turn * vertex.tangent,
            binormal: turn * vertex.binormal,
            ..*vertex
        };
        let eye: Vec<Vertex> = mesh.vertices.iter().map(to_eye).collect();
        let size = [width, height];
        let mut front = Self {
            scene,
            mesh,
            turn,
            eye,
            light: Vec::new(),
            texels,
            size,
            toward: Coordinates::default(),
            away: Coordinates::default(),
        };
        front.light = front.mesh.vertices.iter().map(|vertex| gouraud(scene, vertex)).collect();
        front.toward = front.displaced(Way::Toward);
        front.away = front.displaced(Way::Away);
        Ok(front)
    }

    /// The golden coordinates.
    fn golden(&self, way: Way) -> &Coordinates {
        match way {
            Way::Toward => &self.toward,
            Way::Away => &self.away,
        }
    }

    fn in_texels(&self, vertex: &Vertex) -> DVec2 {
        vertex.uv * DVec2::new(f64::from(self.size[0]), f64::from(self.size[1]))
    }

    /// Where a light is in the camera's space, seen from a vertex.
    fn light_in_eye(&self, light: &Light, number: usize) -> DVec3 {
        match light.place {
            Place::Direction(direction) => {
                self.eye[number].position + FAR_AWAY * (self.turn * direction)
            }
            Place::Position(position) => self.turn * (position - self.scene.camera.eye),
        }
    }

    /// The golden displacements.
    fn displaced(&self, way: Way) -> Coordinates {
        let emboss = self.scene.emboss;
        let sign = match emboss.light_sign {
            LightSign::LightVertex => way.sign(),
            LightSign::VertexLight => -way.sign(),
        };
        let displaced = |light: &Light| -> Vec<DVec2> {
            let at = |(number, vertex): (usize, &Vertex)| {
                let to_light = self.light_in_eye(light, number) - vertex.position;
                let unit = to_light.try_normalize().unwrap_or(DVec3::ZERO);
                let along = DVec2::new(vertex.tangent.dot(unit), vertex.binormal.dot(unit));
                self.in_texels(vertex) + sign * emboss.strength * along
            };
            self.eye.iter().enumerate().map(at).collect()
        };
        Coordinates {
            plain: self.eye.iter().map(|vertex| self.in_texels(vertex)).collect(),
            displaced: self.scene.lights.iter().map(displaced).collect(),
        }
    }

    /// A texel, 0 to 255, wherever it is asked for.
    fn texel(&self, column: i64, row: i64) -> f64 {
        let at = |index: i64, axis: usize| {
            let side = i64::from(self.size[axis]);
            match self.scene.emboss.address[axis] {
                Address::Wrap => index.rem_euclid(side),
                Address::Clamp => index.clamp(0, side - 1),
            }
        };
        self.stored(at(column, 0), at(row, 1))
    }

    /// A texel of the map.
    fn stored(&self, column: i64, row: i64) -> f64 {
        let index = row * i64::from(self.size[0]) + column;
        f64::from(self.texels[cast::index_of(index)])
    }

    /// The golden height at a place in texels, 0 to 255.
    fn height(&self, at: DVec2) -> f64 {
        if self.scene.emboss.filter == Filter::Nearest {
            return self.texel(cast::i64_of(at.x.floor()), cast::i64_of(at.y.floor()));
        }
        let at = at - 0.5;
        let (first, part) = (at.floor(), at - at.floor());
        let (column, row) = (cast::i64_of(first.x), cast::i64_of(first.y));
        let mix = |p: f64, q: f64, x: f64| p * (1.0 - x) + q * x;
        let along = |row| mix(self.texel(column, row), self.texel(column + 1, row), part.x);
        mix(along(row), along(row + 1), part.y)
    }

    /// The largest difference of neighbouring texels along s and along t, in codes.
    fn steepest(&self) -> [f64; 2] {
        let [width, height] = self.size.map(i64::from);
        let mut most = [0f64; 2];
        for row in 0..height {
            for column in 0..width {
                let here = self.texel(column, row);
                // Beyond a clamped border is the border itself.
                most[0] = most[0].max((self.texel(column + 1, row) - here).abs());
                most[1] = most[1].max((self.texel(column, row + 1) - here).abs());
            }
        }
        most
    }

    /// The diffuse colour of a pixel, 0 to 1.
    fn colour(&self, seen: &Seen, i: usize) -> [f64; 3] {
        let light = seen.between(i, |vertex| self.light[vertex]);
        let [u, v] = [0, 1].map(|axis| seen.between(i, |vertex| self.eye[vertex].uv[axis]));
        let texture = &self.scene.texture;
        let texel = texture.texels()[cast::index_of_u32(texture.texel(u, v))];
        texel.map(|channel| light * f64::from(channel))
    }
}

/// Ambient and diffuse light of a vertex, ending at 1.
fn gouraud(scene: &Scene, vertex: &Vertex) -> f64 {
    let material = &scene.materials[cast::index_of_u32(vertex.object)];
    let of_light = |light: &Light| {
        let to_light = light.towards(vertex.position, vertex.normal);
        light.intensity * material.diffuse * vertex.normal.dot(to_light).max(0.0)
    };
    let diffuse: f64 = scene.lights.iter().map(of_light).sum();
    (scene.ambient * material.ambient + diffuse).min(1.0)
}

/// Coordinates between a pixel's corners.
fn between(seen: &Seen, i: usize, of: &[DVec2]) -> DVec2 {
    DVec2::new(seen.between(i, |vertex| of[vertex].x), seen.between(i, |vertex| of[vertex].y))
}

/// A pipeline ready for the pixels of a scene: its designs, and what its first unit made of the vertices.
struct Shader<'a> {
    pipeline: &'a Pipeline,
    way: Way,
    emboss: Stage,
    sampler: Stage,
    combine: Stage,
    coordinates: Coordinates,
    /// What the vertices took and overflowed.
    vertices: BlockShot,
    known: Known,
}

impl<'a> Shader<'a> {
    fn new(front: &Front<'_>, pipeline: &'a Pipeline) -> Result<Self> {
        let scene = front.scene;
        let settings = scene.emboss;
        let set = |key: &str, value: &dyn std::fmt::Display| format!("{key}={value}");
        let mut of_emboss = vec![set("l_sign", &settings.light_sign.name())];
        let way = Way::of(pipeline);
        if way == Way::Away {
            of_emboss.push(set("constants", &"ports"));
        }
        let emboss = Stage::new(pipeline.unit, pipeline, &of_emboss)?;
        let of_combine = [
            set("filter", &settings.filter.name()),
            set("lights", &scene.lights.len()),
            set("gain_log2", &settings.gain_log2),
            set("difference", &way.difference()),
        ];
        let combine = Stage::new(&COMBINE, pipeline, &of_combine)?;
        let mut vertices = BlockShot::of([&emboss.program].into_iter());
        let (coordinates, step_texels) = displaced(front, &emboss, &mut vertices)?;
        // Integer bits for the farthest coordinate, in maps.
        let maps = DVec2::new(f64::from(front.size[0]), f64::from(front.size[1]));
        let all = coordinates.displaced.iter().flatten().chain(&coordinates.plain);
        let farthest = all.map(|at| (*at / maps).abs().max_element()).fold(0.0, f64::max);
        let int_bits = (0..=16).find(|bits| farthest < 2f64.powi(*bits)).ok_or_else(|| {
            Error::usage(format!(
                "a texture coordinate of {farthest} maps is beyond the sampler: legal is below 65536; give the object smaller ones"
            ))
        })?;
        let of_sampler = [
            set("filter", &settings.filter.name()),
            set("address_s", &settings.address[0].name()),
            set("address_t", &settings.address[1].name()),
            set("int_bits", &int_bits),
            set("log2_width", &front.size[0].trailing_zeros()),
            set("log2_height", &front.size[1].trailing_zeros()),
        ];
        let sampler = Stage::new(&SAMPLER, pipeline, &of_sampler)?;
        let pairs = coordinates.displaced.iter().zip(&front.golden(way).displaced);
        let displacement_max_texels =
            pairs.map(|(is, should)| apart(is, should).max_element()).fold(0.0, f64::max);
        let known = Known { bound: None, displacement_max_texels, step_texels };
        let mut shader =
            Self { pipeline, way, emboss, sampler, combine, coordinates, vertices, known };
        shader.known.bound = shader.bounded(front)?;
        Ok(shader)
    }

    /// What no channel of its picture can be off by more than, in linear light.
    fn bounded(&self, front: &Front<'_>) -> Result<Option<f64>> {
        if front.scene.emboss.filter == Filter::Nearest {
            return Ok(None); // a position next to a border may be on its other side
        }
        let values = &self.sampler.design.values;
        let power = |bits: u32| 2f64.powi(-cast::signed_count(bits));
        // Rounded to a word of the sampler, and cut off by it.
        let rounded = 0.5 * power(values.bits("frac_bits"));
        let cut = power(values.bits("fraction_bits"));
        let steepest = front.steepest();
        let of_height = |apart: DVec2| -> f64 {
            let axis = |axis: usize| {
                let word = rounded * f64::from(front.size[axis]);
                steepest[axis] * (apart[axis] + word + cut)
            };
            axis(0) + axis(1)
        };
        let golden = front.golden(self.way);
        let plain = of_height(apart(&self.coordinates.plain, &golden.plain));
        let displaced = self.coordinates.displaced.iter().zip(&golden.displaced);
        let relief: f64 =
            displaced.map(|(is, should)| plain + of_height(apart(is, should))).sum::<f64>()
                / TEXEL_MAX;
        let most = self.max_code();
        // Texels are 8 bits wide: other codes are the nearest ones.
        let texel = if most == TEXEL_MAX { 0.0 } else { 0.5 / most };
        let lights = cast::f64_of_len(front.scene.lights.len());
        let gain = 2f64.powi(front.scene.emboss.gain_log2);
        let stated = BoundCheck::new(&self.combine.design)?;
        let combined = stated.stated.first().expect("bug: the combiner states a bound").bound;
        let floats = 1e-7; // pictures are f32
        let bound = gain * (relief + 2.0 * lights * texel) + (0.5 + combined) / most + floats;
        Ok(Some(bound.min(1.0))) // no channel is off by more
    }

    /// The code that stands for 1.
    fn max_code(&self) -> f64 {
        2f64.powi(cast::signed_count(self.combine.design.values.bits("channel_bits"))) - 1.0
    }

    fn stages(&self) -> [&Stage; 3] {
        [&self.emboss, &self.sampler, &self.combine]
    }
}

/// The largest distances along both axes.
fn apart(is: &[DVec2], should: &[DVec2]) -> DVec2 {
    let apart = is.iter().zip(should).map(|(is, should)| (*is - *should).abs());
    apart.fold(DVec2::ZERO, DVec2::max)
}

/// The least scale of the matrix, in its last places.
const LEAST_SCALE_ULPS: f64 = 4.0;

/// Every vertex under every light through the unit `emboss`, and the texels that it counts as 1.
fn displaced(front: &Front<'_>, stage: &Stage, shot: &mut BlockShot) -> Result<(Coordinates, f64)> {
    let scene = front.scene;
    let strength = scene.emboss.strength;
    let plain = &front.toward.plain; // the same either way
    let farthest = plain.iter().map(|at| at.abs().max_element()).fold(0.0, f64::max);
    // A word of the coordinates counts so many texels as a whole one; a strength of 1 at most.
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
    // A relief of a scale that the matrix hardly has words for would go without a word.
    let ulp = stage.port("m0_x").map_or(0.0, Format::ulp);
    if strength > 0.0 && scale < LEAST_SCALE_ULPS * ulp {
        return Err(Error::usage(format!(
            "a strength of {strength} texels is {scale:.3e} of the emboss unit's whole coordinate of {step} texels, and its matrix \
             counts {ulp:.3e}: give the object smaller texture coordinates, or the unit more texture_int_bits or matrix_bits"
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
                        "a {what} is {far} from the camera along an axis and the emboss unit's positions end at {reach}: make the scene smaller, or -p position_bits larger or -p position_frac_bits smaller"
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
        // Ports in and out have one format.
        let netlist = &stage.design.netlist;
        let port = |name: &str| (0..words.len()).find(|at| netlist.input_name(*at) == name);
        let [s0, t0] = ["s0", "t0"].map(|name| &words[port(name).expect("bug: a port")]);
        undisplaced = s0.iter().zip(t0).map(value).collect();
    }
    Ok((Coordinates { plain: undisplaced, displaced: all }, step))
}

/// What a thread keeps from block to block.
struct Lanes {
    seen: Seen,
    /// Sampler and combiner of each pipeline.
    runners: Vec<[Runner; 2]>,
}

/// Renders a scene by emboss pipelines at once. `progress` gets the rows done.
///
/// # Errors
/// If a unit can't be built with its parameters, the height map's sides are no powers of two, something is out
/// of the range of its words, or a `narrow` under overflow mode `error` overflowed.
pub fn render(
    scene: &Scene,
    pipelines: &[Pipeline],
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Rendered> {
    let start = Instant::now();
    let front = Front::new(scene)?;
    let shaders: Vec<Shader<'_>> =
        pipelines.iter().map(|pipeline| Shader::new(&front, pipeline)).collect::<Result<_>>()?;
    let nothing = |shader: &Shader<'_>| {
        BlockShot::of(shader.stages().into_iter().map(|stage| &stage.program))
    };
    // `Rendered` has the golden of the first pipeline.
    let first = shaders.first().map_or(Way::Toward, |shader| shader.way);
    let other = shaders.iter().map(|shader| shader.way).find(|way| *way != first);
    let lanes = || Lanes {
        seen: Seen::default(),
        runners: shaders
            .iter()
            .map(|shader| [shader.sampler.program.runner(), shader.combine.program.runner()])
            .collect(),
    };
    let shade = |lanes: &mut Lanes, rows: Range<u32>| {
        let Lanes { seen, runners } = lanes;
        front.mesh.trace(scene, rows, seen);
        let shots = shaders.iter().zip(runners).map(|(shader, runners)| {
            let mut shot = nothing(shader);
            shot.colours = shader.shade(&front, seen, runners, &mut shot)?;
            Ok(shot)
        });
        let golden = |way| -> Vec<[f64; 3]> {
            (0..seen.len()).map(|i| golden(&front, way, seen, i)).collect()
        };
        // The golden of the other way is one more picture.
        let other =
            other.map(|way| BlockShot { colours: golden(way), ..BlockShot::of([].into_iter()) });
        Ok(Block {
            pixels: seen.pixel.clone(),
            golden: golden(first),
            blinn: 0.0,
            shots: shots.chain(other.map(Ok)).collect::<Result<_>>()?,
        })
    };
    let other_total = other.map(|_| BlockShot::of([].into_iter()));
    let totals = shaders.iter().map(nothing).chain(other_total).collect();
    let Gathered { golden, covers, mut pictures, totals, mut rates, .. } =
        gather(scene, totals, lanes, shade, progress)?;
    let other_golden = other.and_then(|_| pictures.pop()).map(Arc::new);
    let mut shots = Vec::new();
    for (((shader, picture), mut total), rates) in
        shaders.iter().zip(pictures).zip(totals).zip(&mut rates)
    {
        total.overflows[0].clone_from(&shader.vertices.overflows[0]);
        let stages = shader.stages().map(|stage| (&stage.design, &stage.program));
        shots.push(Shot {
            pipeline: shader.pipeline.clone(),
            picture,
            golden: if shader.way == first { None } else { other_golden.clone() },
            design: Arc::clone(&shader.emboss.design),
            behind: [&shader.sampler, &shader.combine].map(|s| Arc::clone(&s.design)).to_vec(),
            emboss: Some(shader.known),
            setup: None,
            frames: None,
            engine: total.engine + shader.vertices.engine,
            samples_per_second: median_rate(rates),
            samples: total.samples,
            vectors: None,
            overflows: overflows(stages.into_iter(), &total.overflows)?,
        });
    }
    Ok(Rendered {
        golden,
        blinn: None,
        covered: count(&covers),
        covers,
        shots,
        elapsed: start.elapsed(),
    })
}

/// The golden colour of a pixel.
fn golden(front: &Front<'_>, way: Way, seen: &Seen, i: usize) -> [f64; 3] {
    let height = |of: &[DVec2]| front.height(between(seen, i, of));
    let golden = front.golden(way);
    let here = height(&golden.plain);
    let relief: f64 = golden.displaced.iter().map(|there| here - height(there)).sum();
    let gain = way.sign() * 2f64.powi(front.scene.emboss.gain_log2) / TEXEL_MAX;
    front.colour(seen, i).map(|channel| (channel + gain * relief).clamp(0.0, 1.0))
}

impl Shader<'_> {
    /// Colours of pixels.
    fn shade(
        &self,
        front: &Front<'_>,
        seen: &Seen,
        [sampler, combine]: &mut [Runner; 2],
        shot: &mut BlockShot,
    ) -> Result<Vec<[f64; 3]>> {
        let maps = DVec2::new(f64::from(front.size[0]), f64::from(front.size[1]));
        let most = self.max_code();
        let code = |texel: f64| cast::i64_of((texel / TEXEL_MAX * most).round());
        let mut inputs: BTreeMap<String, Vec<i64>> = BTreeMap::new();
        let samples = std::iter::once(("h".to_owned(), &self.coordinates.plain)).chain(
            self.coordinates.displaced.iter().enumerate().map(|(n, at)| (format!("d{n}"), at)),
        );
        let mut words = Vec::new();
        for (name, coordinates) in samples {
            let places: Vec<DVec2> =
                (0..seen.len()).map(|i| between(seen, i, coordinates) / maps).collect();
            let columns: BTreeMap<String, Vec<f64>> = [("s", 0), ("t", 1)]
                .map(|(name, axis)| (name.to_owned(), places.iter().map(|at| at[axis]).collect()))
                .into();
            let columns = self.sampler.inputs(columns);
            quantize_inputs(&self.sampler.design.netlist, &columns, &mut words)?;
            let out = self.sampler.run(sampler, &words, shot, 1);
            let texels = |i: &str, j: &str| -> Vec<i64> {
                let pairs = out[i].iter().zip(&out[j]);
                pairs.map(|(i, j)| code(front.stored(*i, *j))).collect()
            };
            if front.scene.emboss.filter == Filter::Nearest {
                inputs.insert(name, texels("i", "j"));
                continue;
            }
            for (corner, i, j) in
                [("00", "i0", "j0"), ("10", "i1", "j0"), ("01", "i0", "j1"), ("11", "i1", "j1")]
            {
                inputs.insert(format!("{name}_{corner}"), texels(i, j));
            }
            for fraction in ["a", "b"] {
                inputs.insert(format!("{name}_{fraction}"), out[fraction].clone());
            }
        }
        let colours: Vec<[f64; 3]> = (0..seen.len()).map(|i| front.colour(seen, i)).collect();
        for (name, channel) in [("r", 0), ("g", 1), ("b", 2)] {
            let word = |colour: &[f64; 3]| cast::i64_of((colour[channel] * most).round());
            inputs.insert(name.to_owned(), colours.iter().map(word).collect());
        }
        let out = self.combine.run(combine, &self.combine.inputs(inputs), shot, 2);
        shot.samples += cast::count_of(seen.len());
        let channels = ["out_r", "out_g", "out_b"].map(|name| &out[name]);
        let colour = |i: usize| channels.map(|words| cast::f64_of(words[i]) / most);
        Ok((0..seen.len()).map(colour).collect())
    }
}
