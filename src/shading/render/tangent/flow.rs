//! Pictures by the whole flow.

use super::known::Known;
use super::setup::{Corner, Outputs, Setup, flagged};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::Design;
use crate::netlist::Counts;
use crate::shading::render::block::{Block, BlockShot, Gathered, gather, overflows};
use crate::shading::render::light::{colour, reflected};
use crate::shading::render::named::Stage;
use crate::shading::render::pipeline::Pipeline;
use crate::shading::render::shot::Shot;
use crate::shading::scene::{Assembly, Scene, Seen, SharedVertex, halfway};
use crate::units::fragment::Fragment;
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;
use std::time::Duration;

/// The part of a scene that the golden and the pipelines share.
struct Front<'a> {
    scene: &'a Scene,
    mesh: Assembly,
    /// The vertex stage's result for each vertex: the unit vectors to the eye and to each light.
    /// Vertices that no triangle uses are computed too, but aren't counted as operations.
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

    /// A corner of a triangle, numbered over all triangles.
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

/// Vectors to the eye and to the lights in texture space, for every corner of every triangle: the
/// eye's, then the lights', three columns each.
type Vectors = Vec<Vec<f64>>;

/// A pipeline with its triangles set up.
struct Shader<'a> {
    pipeline: &'a Pipeline,
    design: Arc<Design>,
    fixed: Vectors,
    golden: Vectors,
    known: KnownSoFar,
    shot: BlockShot,
    program: crate::sim::batch::Program,
}

/// All of [`Known`] except the picture.
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

/// Colours of pixels from the vectors of the corners.
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

/// Renders a scene by these pipelines. `progress` receives the number of finished rows.
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

/// Corners per second of engine time.
fn rate(samples: u64, engine: Duration) -> f64 {
    cast::f64_of_count(samples) / engine.as_secs_f64().max(1e-9)
}
