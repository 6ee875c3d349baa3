//! Scenes by tangent-space set-up: texture-space vectors per corner of a triangle, lighting per pixel.
//!
//! The flow of US 7,843,463 (seed 004): a vertex stage (float: unit normal, unit vector to the eye and to each
//! light, once per shared vertex), primitive assembly ([`Scene::assemble`]), the set-up (the fixed-point unit
//! `tangent`, for each corner of each triangle: the map from object space to texture space, and the eye's and the
//! lights' vectors through it), a rasteriser (float: rays and perspective-correct weights, which interpolate
//! those vectors and the texture coordinates), and lighting per pixel in texture space: with interpolated
//! vectors made unit again, `N'` straight from the bump map, and the formula of the golden.
//!
//! - `tangent-smooth` has a map for each vertex of a triangle, with the vertex's normal;
//! - `tangent-faceted` has one for each triangle, whose normal is its own. It takes none from vertices: by itself it
//!   shows a mesh without normals in facets, as does its golden then ([`Scene::faceted`]).
//!
//! # Two goldens
//! A picture's difference to the golden of all pipelines (frames and vectors per pixel, without triangles) splits
//! into *arithmetic*, against [`Known::flow`], which is the same flow with the unit's golden in place of its words,
//! and *algorithm*, of that against the golden: vectors interpolated over triangles, a tangent that is constant on
//! each, and the outline of a sphere that has corners here. As many triangles as `[emboss] tessellation` says.
//!
//! # Words
//! Positions and texture coordinates of an object's vertices are moved to the middle of their range and scaled by one
//! power of two each, so that they take at least half of what the unit's words hold; then each is a word of the buffer,
//! the same for all its triangles. Neither changes a direction. A small object beside a large one has steps of its
//! own: only edges enter the set-up, and no triangle has vertices of two objects. A texture whose determinant is 0 in these words, or a triangle
//! without area in them, gets the unit's fallback frame and is counted.
//!
//! # Frames for the other pipelines
//! With [`Frames::Setup`](super::Frames) pipelines that shade bumps per pixel take their frames from the unit, too: the
//! rows of the map at the corners of a face are interpolated, N made unit, and T its part at right angles to N made
//! unit, from which come the angles φ_N, θ_N and ψ (angles themselves wrap, so they aren't interpolated). Units have
//! B = N × T; so where the map's own B is on the other side, which is where a texture is mirrored, p_y changes sign. So
//! it does with frames in floating point. T isn't turned: with T and N × T both turned, bumps would be
//! dents.

use crate::base::cast;
use crate::base::error::Result;
use crate::design::{Design, Unit};
use crate::measure::{OverflowCount, quantize_inputs, run_golden};
use crate::netlist::Counts;
use crate::netlist::words::Words;
use crate::number::format::Format;
use crate::shading::picture::Picture;
use crate::shading::render::named::{Stage, knows};
use crate::shading::render::{
    Block, BlockShot, Gathered, Pipeline, Shot, colour, gather, overflows, reflected,
};
use crate::shading::scene::{
    Assembly, CURVED, Fragments, Scene, Seen, SharedVertex, Sharing, halfway,
};
use crate::shading::specialise::{Known as KnownWords, Rate, specialise};
use crate::units::fragment::Fragment;
use crate::units::tangent::TANGENT;
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use serde::Serialize;
use std::ops::Range;
use std::sync::Arc;
use std::time::Duration;

/// Parameters of the unit that the pipeline's name and the scene give.
pub(in crate::shading::render) const FROM_SCENE: &[&str] = &["frame", "lights"];

/// Units before a pipeline whose frames are set up.
pub(in crate::shading::render) static BEFORE: [&Unit; 1] = [&TANGENT];

/// Corners that a thread sets up at a time.
const TOGETHER: usize = 3 << 10;

/// What is known of a set-up beside its picture.
#[derive(Clone, Debug, Serialize)]
pub struct Known {
    /// The same flow with the golden of the set-up.
    #[serde(skip)]
    pub flow: Picture,
    /// What sharing of vertices saves.
    pub sharing: Sharing,
    /// Operations of the set-up for each triangle; `None` if none are apart from those of its vertices.
    pub per_primitive: Option<Counts>,
    /// Operations for each vertex of a triangle, besides.
    pub per_vertex: Counts,
    /// Triangles whose texture is mirrored.
    pub mirrored: u64,
    /// Corners that got a fallback frame.
    pub degenerate: u64,
    /// Last place of positions, in the world: that of the object where it is coarsest.
    pub position_step: f64,
    /// Last place of texture coordinates, likewise.
    pub uv_step: f64,
}

/// What is known of the set-up of a scene's frames.
#[derive(Clone, Debug, Serialize)]
pub struct FramesKnown {
    /// Faces that were set up, with three corners each; spheres have none.
    pub faces: u64,
    /// Faces whose texture is mirrored.
    pub mirrored: u64,
    /// Corners that got a fallback frame.
    pub degenerate: u64,
    /// As [`Known::position_step`].
    pub position_step: f64,
    /// As [`Known::uv_step`].
    pub uv_step: f64,
    /// Every `narrow` of the set-up that overflowed at least once.
    pub overflows: Vec<OverflowCount>,
}

/// How many flags are set.
fn flagged<'a>(flags: impl Iterator<Item = &'a f64>) -> u64 {
    cast::count_of(flags.filter(|flag| **flag != 0.0).count())
}

/// What the set-up takes for one corner of a triangle.
#[derive(Clone, Copy, Debug)]
struct Corner {
    /// Index of its object.
    object: u32,
    positions: [DVec3; 3],
    uvs: [DVec2; 3],
    normal: DVec3,
    view: DVec3,
    lights: [DVec3; 8],
}

/// What an input port of the set-up takes.
#[derive(Clone, Copy, Debug)]
enum Source {
    Position(usize, usize),
    Uv(usize, usize),
    Normal(usize),
    View(usize),
    Light(usize, usize),
}

impl Source {
    /// That of a port's name.
    fn of(port: &str) -> Option<Self> {
        let (name, axis) = port.rsplit_once('_')?;
        let axis = ["x", "y", "z", "u", "v"].iter().position(|known| *known == axis)?;
        let number = |prefix: &str| -> Option<usize> { name.strip_prefix(prefix)?.parse().ok() };
        if let Some(k) = number("uv") {
            return Some(Self::Uv(k, axis.checked_sub(3)?));
        }
        match name {
            "normal" => Some(Self::Normal(axis)),
            "view" => Some(Self::View(axis)),
            _ => match (number("p"), number("light")) {
                (Some(k), _) => Some(Self::Position(k, axis)),
                (_, Some(k)) => Some(Self::Light(k, axis)),
                (None, None) => None,
            },
        }
    }
}

impl Corner {
    fn value(&self, source: Source) -> f64 {
        match source {
            Source::Position(k, axis) => self.positions[k][axis],
            Source::Uv(k, axis) => self.uvs[k][axis],
            Source::Normal(axis) => self.normal[axis],
            Source::View(axis) => self.view[axis],
            Source::Light(k, axis) => self.lights[k][axis],
        }
    }
}

/// Where words of a set-up have their middle, and what they count.
#[derive(Clone, Copy, Debug)]
struct Place<V> {
    middle: V,
    scale: f64,
}

/// The places of an object's words.
#[derive(Clone, Copy, Debug)]
struct Places {
    position: Place<DVec3>,
    uv: Place<DVec2>,
}

/// The set-up of a scene's triangles by the unit.
struct Setup {
    stage: Stage,
    /// Of each object that has corners.
    places: Vec<Option<Places>>,
}

/// Values of outputs for corners, by name; and the golden's.
#[derive(Default)]
struct Outputs {
    fixed: Vec<Vec<f64>>,
    golden: Vec<Vec<f64>>,
}

/// Columns of some corners: pieces of those of [`Outputs`].
#[derive(Default)]
struct Part<'a> {
    fixed: Vec<&'a mut [f64]>,
    golden: Vec<&'a mut [f64]>,
}

impl Setup {
    /// For corners of these objects.
    fn new(
        pipeline: &Pipeline,
        lights: usize,
        corners: impl Iterator<Item = (u32, SharedVertex)>,
    ) -> Result<Self> {
        let stage = Stage::new(&TANGENT, pipeline, &[format!("lights={lights}")])?;
        // Least and greatest position and uv.
        let mut bounds: Vec<Option<[[DVec3; 2]; 2]>> = Vec::new();
        for (object, SharedVertex { position, uv, .. }) in corners {
            let object = cast::index_of_u32(object);
            bounds.resize(bounds.len().max(object + 1), None);
            let at = [position, uv.extend(0.0)];
            let bounds = bounds[object].get_or_insert(at.map(|at| [at, at]));
            for (bounds, at) in bounds.iter_mut().zip(at) {
                *bounds = [bounds[0].min(at), bounds[1].max(at)];
            }
        }
        let place = |[low, high]: [DVec3; 2], port: &str| {
            // All in one place still have a scale.
            let half = (0.5 * (high - low)).max_element().max(1e-18);
            // A power of two, so that scaling rounds nothing.
            let scale = libm::exp2(libm::log2(stage.reach(port) / half).floor());
            Place { middle: 0.5 * (low + high), scale }
        };
        let places = |[positions, uvs]: [[DVec3; 2]; 2]| {
            let Place { middle, scale } = place(uvs, "uv0_u");
            let uv = Place { middle: middle.truncate(), scale };
            Places { position: place(positions, "p0_x"), uv }
        };
        let places = bounds.into_iter().map(|bounds| bounds.map(places)).collect();
        Ok(Self { places, stage })
    }

    /// The coarsest last places of positions and of texture coordinates, in the scene; 0 without corners.
    fn steps(&self) -> [f64; 2] {
        let step = |port, scale: fn(&Places) -> f64| {
            let ulp = self.stage.port(port).map_or(0.0, Format::ulp);
            self.places.iter().flatten().map(|places| ulp / scale(places)).fold(0.0, f64::max)
        };
        [step("p0_x", |places| places.position.scale), step("uv0_u", |places| places.uv.scale)]
    }

    /// Some outputs of all corners, by the words and, if it is asked for, by the golden.
    fn run(
        &self,
        count: usize,
        corner: impl Fn(usize) -> Corner + Sync,
        names: &[&str],
        with_golden: bool,
        shot: &mut BlockShot,
    ) -> Result<Outputs> {
        let (stage, netlist) = (&self.stage, &self.stage.design.netlist);
        let source = |at| {
            let port = netlist.input_name(at);
            Source::of(port).unwrap_or_else(|| panic!("bug: nothing for `{port}`"))
        };
        let sources: Vec<Source> = (0..netlist.inputs().len()).map(source).collect();
        let columns: Vec<String> =
            stage.design.groups.iter().flat_map(|group| group.columns()).collect();
        let of_golden = |name: &&str| {
            columns.iter().position(|column| column == name).expect("bug: a golden of this name")
        };
        let of_golden: Vec<usize> = names.iter().map(of_golden).collect();
        // A part's columns of words' values and of the golden are pieces of those of all.
        let chunk = |first: usize, part: Part<'_>| -> Result<BlockShot> {
            let corners: Vec<Corner> = (first..(first + TOGETHER).min(count))
                .map(|at| {
                    let mut corner = corner(at);
                    let object = self.places[cast::index_of_u32(corner.object)];
                    let Places { position, uv } = object.expect("bug: an object with corners");
                    let Place { middle, scale } = position;
                    corner.positions = corner.positions.map(|at| (at - middle) * scale);
                    let Place { middle, scale } = uv;
                    corner.uvs = corner.uvs.map(|at| (at - middle) * scale);
                    corner
                })
                .collect();
            let column = |source: &Source| corners.iter().map(|c| c.value(*source)).collect();
            let inputs: Vec<Vec<f64>> = sources.iter().map(column).collect();
            let mut words = Vec::new();
            quantize_inputs(netlist, &inputs, &mut words)?;
            let mut shot = BlockShot::of([&stage.program].into_iter());
            let out = stage.run(&mut stage.program.runner(), &words, &mut shot, 0);
            for (name, to) in names.iter().zip(part.fixed) {
                let ulp = stage.ulp(name);
                for (to, word) in to.iter_mut().zip(&out[name]) {
                    *to = cast::f64_of(*word) * ulp;
                }
            }
            if with_golden {
                let mut golden = Vec::new();
                run_golden(&stage.design, &inputs, &mut golden);
                for (at, to) in of_golden.iter().zip(part.golden) {
                    to.copy_from_slice(&golden[*at]);
                }
            }
            Ok(shot)
        };
        let golden = if with_golden { names.len() } else { 0 };
        let mut all = Outputs {
            fixed: vec![vec![0.0; count]; names.len()],
            golden: vec![vec![0.0; count]; golden],
        };
        let mut parts: Vec<Part<'_>> = Vec::new();
        parts.resize_with(count.div_ceil(TOGETHER), Part::default);
        for column in &mut all.fixed {
            parts.iter_mut().zip(column.chunks_mut(TOGETHER)).for_each(|(p, c)| p.fixed.push(c));
        }
        for column in &mut all.golden {
            parts.iter_mut().zip(column.chunks_mut(TOGETHER)).for_each(|(p, c)| p.golden.push(c));
        }
        let run = |(number, part)| chunk(number * TOGETHER, part);
        let shots: Vec<BlockShot> =
            parts.into_par_iter().enumerate().map(run).collect::<Result<_>>()?;
        shots.iter().for_each(|part| shot.merge(part));
        shot.samples += cast::count_of(count);
        Ok(all)
    }

    /// Operations for each triangle, and for each of its vertices besides.
    fn counts(&self) -> (Option<Counts>, Counts) {
        let netlist = &self.stage.design.netlist;
        let known = |(at, id): (usize, &crate::netlist::NodeId)| {
            let of_triangle = |prefix: &str| {
                let number = netlist.input_name(at).strip_prefix(prefix);
                number.is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
            };
            let rate = if of_triangle("p") || of_triangle("uv") { Rate::Face } else { Rate::Pixel };
            KnownWords { words: Words::all(netlist.node(*id).format), rate }
        };
        let known: Vec<KnownWords> = netlist.inputs().iter().enumerate().map(known).collect();
        let names: Vec<&str> =
            netlist.outputs().iter().map(|output| output.name.as_str()).collect();
        let report = specialise(netlist, &known, &names).report;
        (report.face.map(|face| face.counts), report.pixel.counts)
    }
}

/// What golden and pipelines share of a scene.
struct Front<'a> {
    scene: &'a Scene,
    mesh: Assembly,
    /// Of each vertex, what the vertex stage makes: the unit vector to the eye, and to each light.
    /// Those of vertices that no triangle has are made here, too, but need not be, and aren't counted as operations.
    vectors: Vec<Vec<DVec3>>,
}

impl<'a> Front<'a> {
    fn new(scene: &'a Scene) -> Result<Self> {
        let mesh = scene.assemble()?;
        let stage = |vertex: &SharedVertex| {
            let to_light =
                scene.lights.iter().map(|light| light.towards(vertex.position, vertex.normal));
            std::iter::once(scene.to_eye(vertex.position)).chain(to_light).collect()
        };
        let vectors = mesh.vertices.par_iter().map(stage).collect();
        Ok(Self { scene, mesh, vectors })
    }

    /// A corner of a triangle, counted over all triangles.
    fn corner(&self, at: usize) -> Corner {
        let ids = self.mesh.primitives()[at / 3].map(cast::index_of_u32);
        let vertices = ids.map(|id| self.mesh.vertices[id]);
        let vectors = &self.vectors[ids[at % 3]];
        let mut lights = [DVec3::ZERO; 8];
        for (to, from) in lights.iter_mut().zip(&vectors[1..]) {
            *to = *from;
        }
        Corner {
            object: self.mesh.object(cast::id_of(at / 3)),
            positions: vertices.map(|vertex| vertex.position),
            uvs: vertices.map(|vertex| vertex.uv),
            normal: vertices[at % 3].normal,
            view: vectors[0],
            lights,
        }
    }
}

/// Vectors of the eye and of the lights in texture space, of every corner of every triangle: of the eye, then of
/// the lights, each three columns.
type Vectors = Vec<Vec<f64>>;

/// A pipeline whose triangles are set up.
struct Shader<'a> {
    pipeline: &'a Pipeline,
    design: Arc<Design>,
    fixed: Vectors,
    golden: Vectors,
    known: KnownSoFar,
    shot: BlockShot,
    program: crate::sim::batch::Program,
}

/// All of [`Known`] but the picture.
struct KnownSoFar {
    per_primitive: Option<Counts>,
    per_vertex: Counts,
    mirrored: u64,
    degenerate: u64,
    steps: [f64; 2],
}

impl<'a> Shader<'a> {
    fn new(front: &Front<'_>, pipeline: &'a Pipeline) -> Result<Self> {
        let lights = front.scene.lights.len();
        let corners = front.mesh.primitives().iter().zip(0..).flat_map(|(ids, triangle)| {
            let object = front.mesh.object(triangle);
            ids.map(|id| (object, front.mesh.vertices[cast::index_of_u32(id)]))
        });
        let setup = Setup::new(pipeline, lights, corners)?;
        let vectors = std::iter::once("ts_view".to_owned())
            .chain((0..lights).map(|light| format!("ts_light{light}")));
        let mut names: Vec<String> =
            vectors.flat_map(|name| ["x", "y", "z"].map(|axis| format!("{name}_{axis}"))).collect();
        names.extend(["mirrored", "degenerate"].map(str::to_owned));
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let mut shot = BlockShot::of([&setup.stage.program].into_iter());
        let count = 3 * front.mesh.primitives().len();
        let Outputs { mut fixed, mut golden } =
            setup.run(count, |at| front.corner(at), &names, true, &mut shot)?;
        let mut flag = || {
            golden.pop();
            fixed.pop().expect("bug: a flag")
        };
        let (degenerate, mirrored) = (flag(), flag());
        let (per_primitive, per_vertex) = setup.counts();
        let known = KnownSoFar {
            per_primitive,
            per_vertex,
            mirrored: flagged(mirrored.iter().step_by(3)),
            degenerate: flagged(degenerate.iter()),
            steps: setup.steps(),
        };
        let Stage { design, program } = setup.stage;
        Ok(Self { pipeline, design, fixed, golden, known, shot, program })
    }
}

/// Colours of pixels by vectors of the corners.
fn shade(front: &Front<'_>, seen: &Seen, vectors: &Vectors) -> Vec<[f64; 3]> {
    let scene = front.scene;
    let shade = |i: usize| {
        let first = 3 * cast::index_of_u32(seen.triangle[i]);
        let weights = seen.weights[i];
        let between = |columns: &[Vec<f64>]| -> DVec3 {
            let at = |column: &Vec<f64>| -> f64 {
                (0..3).map(|corner| weights[corner] * column[first + corner]).sum()
            };
            DVec3::new(at(&columns[0]), at(&columns[1]), at(&columns[2]))
        };
        let DVec2 { x: u, y: v } = front.mesh.uv(seen, i);
        let eye = between(&vectors[..3]).normalize_or(DVec3::Z);
        let perturbed = scene.bumps.vector(scene.bumps.texel(u, v));
        let material = &scene.materials[cast::index_of_u32(front.mesh.object(seen.triangle[i]))];
        let (mut diffuse, mut specular) = (scene.ambient * material.ambient, 0.0);
        for (light, columns) in scene.lights.iter().zip(vectors[3..].chunks(3)) {
            let to_light = between(columns).normalize_or(DVec3::Z);
            let point = Fragment {
                normal: DVec3::Z,
                tangent: DVec3::X,
                light: to_light,
                half: halfway(to_light, eye, DVec3::Z),
                perturbed,
            };
            let (d, s) = reflected(&point, perturbed, light, material);
            diffuse += d;
            specular += s;
        }
        let texel = scene.texture.texels()[cast::index_of_u32(scene.texture.texel(u, v))];
        colour(diffuse, specular, texel)
    };
    (0..seen.len()).map(shade).collect()
}

/// Renders a scene by these pipelines. `progress` gets the rows done.
pub(in crate::shading::render) fn shots(
    scene: &Scene,
    pipelines: &[&Pipeline],
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Shot>> {
    for pipeline in pipelines {
        scene.demand_uv(&format!("`{}`", pipeline.name))?;
    }
    let front = Front::new(scene)?;
    let shaders: Vec<Shader<'_>> =
        pipelines.iter().map(|pipeline| Shader::new(&front, pipeline)).collect::<Result<_>>()?;
    let nothing = || BlockShot::of(std::iter::empty());
    let shade_rows = |seen: &mut Seen, rows: Range<u32>| {
        front.mesh.trace(scene, rows, seen);
        let both = shaders.iter().flat_map(|shader| [&shader.fixed, &shader.golden]);
        let shot = |vectors| BlockShot { colours: shade(&front, seen, vectors), ..nothing() };
        Ok(Block {
            pixels: seen.pixel.clone(),
            golden: vec![[0.0; 3]; seen.len()],
            blinn: 0.0,
            shots: both.map(shot).collect(),
        })
    };
    let totals = (0..2 * shaders.len()).map(|_| nothing()).collect();
    let Gathered { pictures, .. } = gather(scene, totals, Seen::default, shade_rows, progress)?;
    let sharing = front.mesh.sharing();
    let mut pictures = pictures.into_iter();
    let mut picture = || pictures.next().expect("bug: two pictures for each pipeline");
    let mut shots = Vec::new();
    for shader in shaders {
        let Shader { pipeline, design, known, shot, program, .. } = shader;
        let KnownSoFar { per_primitive, per_vertex, mirrored, degenerate, steps } = known;
        let fixed = picture();
        let known = Known {
            flow: picture(),
            sharing,
            per_primitive,
            per_vertex,
            mirrored,
            degenerate,
            position_step: steps[0],
            uv_step: steps[1],
        };
        let overflows = overflows([(&design, &program)].into_iter(), &shot.overflows)?;
        shots.push(Shot {
            pipeline: pipeline.clone(),
            picture: fixed,
            golden: None,
            design,
            behind: Vec::new(),
            emboss: None,
            setup: Some(Box::new(known)),
            frames: None,
            engine: shot.engine,
            samples_per_second: rate(shot.samples, shot.engine),
            samples: shot.samples,
            vectors: None,
            overflows,
        });
    }
    Ok(shots)
}

/// Frames at the corners of a scene's faces, by the unit.
pub(in crate::shading::render) struct FaceFrames {
    design: Arc<Design>,
    /// Components of T, B and N of each corner of each face, by column.
    rows: Vec<Vec<f64>>,
    known: FramesKnown,
}

impl FaceFrames {
    /// What of a pipeline's parameters they depend on.
    pub(in crate::shading::render) fn parameters(pipeline: &Pipeline) -> Vec<&String> {
        pipeline.assignments.iter().filter(|set| knows(&TANGENT, set)).collect()
    }

    pub(in crate::shading::render) fn new(scene: &Scene, pipeline: &Pipeline) -> Result<Self> {
        scene.demand_uv("the set-up of frames")?;
        let of_face =
            |(object, face): (u32, [SharedVertex; 3])| face.map(|corner| (object, corner));
        let corners: Vec<(u32, SharedVertex)> = scene.faces().flat_map(of_face).collect();
        let setup = Setup::new(pipeline, 1, corners.iter().copied())?;
        let corner = |at: usize| {
            let face = &corners[at / 3 * 3..][..3];
            let of = [0, 1, 2].map(|i| face[i].1);
            Corner {
                object: corners[at].0,
                positions: of.map(|vertex| vertex.position),
                uvs: of.map(|vertex| vertex.uv),
                normal: corners[at].1.normal,
                view: DVec3::ZERO,
                lights: [DVec3::ZERO; 8],
            }
        };
        let mut names: Vec<String> = ["t", "b", "n"]
            .iter()
            .flat_map(|row| ["x", "y", "z"].map(|axis| format!("{row}_{axis}")))
            .collect();
        names.extend(["mirrored", "degenerate"].map(str::to_owned));
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let mut shot = BlockShot::of([&setup.stage.program].into_iter());
        let count = corners.len();
        let Outputs { fixed: mut rows, .. } = setup.run(count, corner, &names, false, &mut shot)?;
        let mut flag = || rows.pop().expect("bug: a flag");
        let (degenerate, mirrored) = (flag(), flag());
        let steps = setup.steps();
        let Stage { design, program } = setup.stage;
        let known = FramesKnown {
            faces: cast::count_of(count / 3),
            mirrored: flagged(mirrored.iter().step_by(3)),
            degenerate: flagged(degenerate.iter()),
            position_step: steps[0],
            uv_step: steps[1],
            overflows: overflows([(&design, &program)].into_iter(), &shot.overflows)?,
        };
        Ok(Self { design, rows, known })
    }

    pub(in crate::shading::render) fn design(&self) -> &Arc<Design> {
        &self.design
    }

    pub(in crate::shading::render) fn known(&self) -> &FramesKnown {
        &self.known
    }

    /// A shading point with the frame of the set-up; `None` on a sphere.
    pub(in crate::shading::render) fn frame(
        &self,
        scene: &Scene,
        fragments: &Fragments,
        i: usize,
        point: &Fragment,
    ) -> Option<Fragment> {
        if fragments.primitive[i] == CURVED {
            return None;
        }
        let first = 3 * cast::index_of_u32(fragments.primitive[i]);
        let [s, r] = [0, 1].map(|axis| fragments.weights[axis][i]);
        let weights = [1.0 - s - r, s, r];
        let row = |row: usize| {
            let at = |axis: usize| -> f64 {
                let column = &self.rows[3 * row + axis];
                (0..3).map(|corner| weights[corner] * column[first + corner]).sum()
            };
            DVec3::new(at(0), at(1), at(2))
        };
        let normal = row(2).normalize_or(point.normal);
        let across = row(0) - normal * normal.dot(row(0));
        let tangent = across.normalize_or(normal.any_orthonormal_vector());
        let side = if row(1).dot(normal.cross(tangent)) < 0.0 { -1.0 } else { 1.0 };
        let bump = scene.bumps.vector(fragments.bump[i]);
        let perturbed = DVec3::new(bump.x, bump.y * side, bump.z);
        Some(Fragment { normal, tangent, perturbed, ..*point })
    }
}

/// Corners per second of the engine.
fn rate(samples: u64, engine: Duration) -> f64 {
    cast::f64_of_count(samples) / engine.as_secs_f64().max(1e-9)
}
