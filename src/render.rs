//! Scenes rendered by fixed-point pipelines, beside the golden picture in plain floating point.
//!
//! The front end ([`Scene::trace`]) is floating point and gives what each pixel sees. A pipeline is a
//! unit whose input ports are those of a [`Fragment`] and that has an output port `diffuse`, and
//! `specular` if it has highlights: one pass for each light. What goes on from there is the same for
//! the pipelines and for the golden: over all lights, diffuse light (with the ambient light, which the
//! first light brings) times the texture's colour, plus specular light, each sum and the colour saturated
//! at 1. All of it is linear light.
//!
//! The golden is tangent-space bump mapping: N' = p_x T + p_y B + p_z N and the reflection formula. Blinn's
//! equation, N' = N + B_u (N × P_v) - B_v (N × P_u) normalised, is evaluated beside it: with an
//! orthonormal frame (scales are in texels) both are one.

mod specialised;

pub use specialised::{SeenPort, SpecialisedStage, specialise_to};

use crate::cast;
use crate::error::{Error, Result, nearest};
use crate::format::Format;
use crate::measure::{angle_between, as_golden, quantize_inputs, run_golden};
use crate::netlist::NodeId;
use crate::picture::Picture;
use crate::scene::{Fragments, Light, Material, Scene};
use crate::sim::batch::{Program, Runner};
use crate::units::fragment::{Fragment, Port};
use crate::units::{Design, Kind, UNITS, Unit, Value};
use glam::DVec3;
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// Rows that a thread takes at a time.
const ROWS: u32 = 8;

/// A unit with parameters, as a way to shade pixels.
#[derive(Clone, Debug)]
pub struct Pipeline {
    /// Name in reports and of its files.
    pub name: String,
    /// The unit.
    pub unit: &'static Unit,
    /// Parameters that differ from the defaults, as `key=value`. Those of the material come from the
    /// scene.
    pub assignments: Vec<String>,
}

/// Pipelines that are settings of the bump unit.
const BUMP_PIPELINES: [&str; 4] = ["printed", "corrected", "exact-polar", "exact-cartesian"];

/// Parameters that come from the scene.
const MATERIAL: [&str; 4] = ["ambient", "diffuse", "specular", "exponent"];

impl Pipeline {
    /// Names of all pipelines.
    #[must_use]
    pub fn names() -> Vec<&'static str> {
        let shades = |unit: &&&Unit| {
            unit.name != "bump"
                && unit.params.iter().any(|param| param.name == "exponent")
                && unit.name != "illumination"
        };
        let units = UNITS.iter().filter(shades).map(|unit| unit.name);
        BUMP_PIPELINES.into_iter().chain(units).collect()
    }

    /// The pipeline of a name.
    ///
    /// # Errors
    /// If there is none.
    pub fn named(name: &str) -> Result<Self> {
        if !Self::names().contains(&name) {
            let (hint, names) =
                (nearest(name, Self::names().into_iter()), Self::names().join(", "));
            return Err(Error::usage(format!("no pipeline `{name}`{hint}: legal is {names}")));
        }
        let (unit, assignments) = match Unit::find(name) {
            Ok(unit) => (unit, Vec::new()),
            Err(_) => (Unit::find("bump")?, vec![format!("pipeline={name}")]),
        };
        Ok(Self { name: name.to_owned(), unit, assignments })
    }

    /// A unit with parameters, under a name of its own; what the scene gives is left out of them.
    #[must_use]
    pub fn of_unit(name: &str, unit: &'static Unit, assignments: &[String]) -> Self {
        let from_scene =
            |set: &&String| set.split_once('=').is_some_and(|(key, _)| MATERIAL.contains(&key));
        let assignments = assignments.iter().filter(|set| !from_scene(set)).cloned().collect();
        Self { name: name.to_owned(), unit, assignments }
    }

    /// Sets parameters for all pipelines that have them.
    ///
    /// # Errors
    /// If none has one of them, or the scene gives it.
    pub fn set(pipelines: &mut [Self], assignments: &[String]) -> Result<()> {
        for assignment in assignments {
            let (key, _) =
                assignment.split_once('=').ok_or_else(|| Error::form(assignment, "key=value"))?;
            if MATERIAL.contains(&key) {
                let text =
                    format!("parameter `{key}` comes from the scene's [material] and lights");
                return Err(Error::usage(text));
            }
            let own = |p: &Self| p.assignments.iter().any(|own| own.starts_with("pipeline="));
            if key == "pipeline" && pipelines.iter().any(own) {
                let text = "parameter `pipeline` comes from the names of the pipelines";
                return Err(Error::usage(text.to_owned()));
            }
            let mut known = false;
            for pipeline in pipelines.iter_mut() {
                if pipeline.unit.all_params().any(|param| param.name == key) {
                    known = true;
                    pipeline.assignments.push(assignment.clone());
                }
            }
            if !known {
                let names: Vec<&str> = pipelines.iter().map(|p| p.name.as_str()).collect();
                let all = pipelines.iter().flat_map(|p| p.unit.all_params());
                return Err(Error::usage(format!(
                    "no parameter `{key}` in any of the pipelines {}{}: `fixpath list` names them all",
                    names.join(", "),
                    nearest(key, all.map(|param| param.name))
                )));
            }
        }
        Ok(())
    }

    /// Its design for a material in a light; `ambient` is what the light brings of that.
    ///
    /// # Errors
    /// If the parameters don't go together.
    pub fn design(&self, ambient: f64, light: &Light, material: &Material) -> Result<Design> {
        let mut assignments = self.assignments.clone();
        let legal = |name: &str, value: f64| {
            // A product of numbers that are at most 1 each can be an ulp above.
            match self.unit.params.iter().find(|param| param.name == name).map(|p| p.kind) {
                Some(Kind::Real { min, max }) => value.clamp(min, max),
                Some(Kind::Int { .. } | Kind::Choice(_)) | None => value,
            }
        };
        for (name, value) in [
            ("ambient", ambient),
            ("diffuse", light.intensity * material.diffuse),
            ("specular", light.intensity * material.specular),
            ("exponent", f64::from(material.exponent)),
        ] {
            assignments.push(format!("{name}={}", legal(name, value)));
        }
        self.unit.values(&assignments)?.build()
    }
}

/// A design ready to shade pixels.
struct Stage {
    design: Design,
    program: Program,
    ports: Vec<Port>,
    /// Number of the first judged node of the rotated light vector among the program's outputs.
    vector: Option<Range<usize>>,
    has_specular: bool,
    light_format: Format,
}

impl Stage {
    fn new(design: Design, vectors: bool) -> Result<Self> {
        let netlist = &design.netlist;
        let mut ports = Vec::new();
        for at in 0..netlist.inputs().len() {
            let name = netlist.input_name(at);
            let none = || Error::usage(format!("a scene has nothing for the port `{name}`"));
            ports.push(Port::of(name).ok_or_else(none)?);
        }
        let output = |name: &str| {
            netlist.outputs().iter().find(|output| output.name == name).map(|output| output.node)
        };
        let diffuse = output("diffuse").ok_or_else(|| {
            Error::usage(format!("unit `{}` has no output `diffuse`", design.values.unit().name))
        })?;
        let mut nodes: Vec<NodeId> = vec![diffuse];
        let specular = output("specular");
        nodes.extend(specular);
        let group = design.groups.iter().find(|group| vectors && group.name == "lt");
        let vector = group.map(|group| nodes.len()..nodes.len() + group.nodes.len());
        nodes.extend(group.iter().flat_map(|group| group.nodes.iter().copied()));
        let program = Program::compile(netlist, &nodes);
        let light_format = netlist.node(diffuse).format;
        Ok(Self { program, ports, vector, has_specular: specular.is_some(), light_format, design })
    }

    /// True unless its specular light is 0 everywhere.
    fn needs_specular(&self) -> bool {
        self.has_specular && self.design.values.real("specular") > 0.0
    }
}

/// All designs of a pipeline on a scene.
struct Shader {
    stages: Vec<Stage>,
    /// Stage of each material under each light.
    of: Vec<Vec<usize>>,
}

impl Shader {
    fn new(scene: &Scene, pipeline: &Pipeline, vectors: bool) -> Result<Self> {
        let mut known: BTreeMap<Vec<Value>, usize> = BTreeMap::new();
        let mut stages = Vec::new();
        let mut of = Vec::new();
        for material in &scene.materials {
            let mut row = Vec::new();
            for (number, light) in scene.lights.iter().enumerate() {
                let ambient = if number == 0 { scene.ambient * material.ambient } else { 0.0 };
                let design = pipeline.design(ambient, light, material)?;
                let key: Vec<Value> = design.values.iter().map(|(_, value)| value).collect();
                let index = match known.get(&key) {
                    Some(index) => *index,
                    None => {
                        stages.push(Stage::new(design, vectors)?);
                        known.insert(key, stages.len() - 1);
                        stages.len() - 1
                    }
                };
                row.push(index);
            }
            of.push(row);
        }
        Ok(Self { stages, of })
    }

    /// The first material and light that a stage serves.
    fn first_use(&self, stage: usize) -> (usize, usize) {
        let uses = self.of.iter().enumerate().flat_map(|(material, row)| {
            row.iter().enumerate().map(move |(light, index)| (material, light, *index))
        });
        let first = uses.into_iter().find(|(_, _, index)| *index == stage);
        first.map(|(material, light, _)| (material, light)).expect("bug: every stage is used")
    }
}

/// Angle errors of the rotated light vectors of a scene's pixels, end to end: against the golden of
/// the inputs before quantisation.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize)]
pub struct VectorError {
    /// The largest, in rad.
    pub max_rad: f64,
    /// The mean, in rad.
    pub mean_rad: f64,
}

/// A picture by a pipeline.
#[derive(Clone, Debug)]
pub struct Shot {
    /// The pipeline.
    pub pipeline: Pipeline,
    /// Its picture.
    pub picture: Picture,
    /// One of its designs: that of the first material under the first light.
    pub design_values: Vec<(String, String)>,
    /// Time in the bit-true engine, all threads together.
    pub engine: Duration,
    /// Samples that the engine took: covered pixels times lights.
    pub samples: u64,
    /// Errors of the rotated light vectors, if they were asked for and the unit has them.
    pub vectors: Option<VectorError>,
    /// How often a `narrow` overflowed.
    pub overflows: u64,
}

impl Shot {
    /// Samples per second and thread of the engine alone.
    #[must_use]
    pub fn samples_per_second(&self) -> f64 {
        let seconds = self.engine.as_secs_f64();
        if seconds > 0.0 { cast::f64_of_count(self.samples) / seconds } else { 0.0 }
    }
}

/// A scene rendered.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The golden picture: tangent-space bump mapping in `f64`.
    pub golden: Picture,
    /// The largest difference of Blinn's equation to it, in linear light.
    pub blinn: f64,
    /// Pixels that see an object.
    pub covered: u64,
    /// The pipelines' pictures.
    pub shots: Vec<Shot>,
    /// Wall-clock time of all of it.
    pub elapsed: Duration,
}

/// What a thread keeps from block to block.
struct Lanes {
    fragments: Fragments,
    runners: Vec<Vec<Runner>>,
}

/// What a block of rows gave.
struct Block {
    pixels: Vec<u32>,
    golden: Vec<[f64; 3]>,
    blinn: f64,
    shots: Vec<BlockShot>,
}

#[derive(Default)]
struct BlockShot {
    colours: Vec<[f64; 3]>,
    engine: Duration,
    samples: u64,
    overflows: u64,
    angle_max: f64,
    angle_sum: f64,
}

/// Renders a scene by some pipelines at once; `vectors` also judges the rotated light vectors.
/// `progress` gets the rows done.
///
/// # Errors
/// If a pipeline can't be built with its parameters, or lacks a port.
pub fn render(
    scene: &Scene,
    pipelines: &[Pipeline],
    vectors: bool,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Rendered> {
    let start = Instant::now();
    let shaders: Vec<Shader> = pipelines
        .iter()
        .map(|pipeline| Shader::new(scene, pipeline, vectors))
        .collect::<Result<_>>()?;
    let blocks = blocks(scene.image.height);
    let done = AtomicU64::new(0);
    let lanes = || Lanes {
        fragments: Fragments::default(),
        runners: shaders
            .iter()
            .map(|shader| shader.stages.iter().map(|stage| stage.program.runner()).collect())
            .collect(),
    };
    let results: Vec<Result<Block>> = blocks
        .par_iter()
        .map_init(lanes, |lanes, rows| {
            let block = block(scene, &shaders, rows.clone(), lanes);
            progress(done.fetch_add(u64::from(rows.end - rows.start), Ordering::Relaxed));
            block
        })
        .collect();
    let (width, height) =
        (cast::index_of_u32(scene.image.width), cast::index_of_u32(scene.image.height));
    let background = scene.image.background.map(cast::f32_of);
    let blank = vec![background; width * height];
    let mut golden = blank.clone();
    let mut blinn = 0f64;
    let mut covered = 0;
    let mut pictures = vec![blank; pipelines.len()];
    let mut totals: Vec<BlockShot> = pipelines.iter().map(|_| BlockShot::default()).collect();
    for block in results {
        let block = block?;
        covered += cast::count_of(block.pixels.len());
        blinn = blinn.max(block.blinn);
        let write = |pixels: &mut [[f32; 3]], colours: &[[f64; 3]]| {
            for (pixel, colour) in block.pixels.iter().zip(colours) {
                pixels[cast::index_of_u32(*pixel)] = colour.map(cast::f32_of);
            }
        };
        write(&mut golden, &block.golden);
        for ((picture, total), shot) in pictures.iter_mut().zip(&mut totals).zip(&block.shots) {
            write(picture, &shot.colours);
            total.engine += shot.engine;
            total.samples += shot.samples;
            total.overflows += shot.overflows;
            total.angle_max = total.angle_max.max(shot.angle_max);
            total.angle_sum += shot.angle_sum;
        }
    }
    let mut shots = Vec::new();
    for (((pipeline, shader), pixels), total) in
        pipelines.iter().zip(&shaders).zip(pictures).zip(totals)
    {
        let stage = &shader.stages[0];
        let values = stage.design.values.iter();
        shots.push(Shot {
            pipeline: pipeline.clone(),
            picture: Picture::new(width, height, pixels)?,
            design_values: values.map(|(name, v)| (name.to_owned(), v.to_string())).collect(),
            engine: total.engine,
            samples: total.samples,
            vectors: stage.vector.as_ref().map(|_| VectorError {
                max_rad: total.angle_max,
                mean_rad: total.angle_sum / cast::f64_of_count(total.samples.max(1)),
            }),
            overflows: total.overflows,
        });
    }
    Ok(Rendered {
        golden: Picture::new(width, height, golden)?,
        blinn,
        covered,
        shots,
        elapsed: start.elapsed(),
    })
}

/// Rows of an image as threads take them.
fn blocks(height: u32) -> Vec<Range<u32>> {
    (0..height.div_ceil(ROWS)).map(|b| b * ROWS..(b * ROWS + ROWS).min(height)).collect()
}

/// Fragments by material, so that each design gets columns of its own.
fn by_material(fragments: &Fragments) -> BTreeMap<usize, Vec<usize>> {
    let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for i in 0..fragments.len() {
        groups.entry(cast::index_of_u32(fragments.object[i])).or_default().push(i);
    }
    groups
}

/// The shading point of a fragment under a light.
fn shading_point(scene: &Scene, fragments: &Fragments, i: usize, light: &Light) -> Fragment {
    let vector = |columns| Fragments::vector(columns, i);
    let normal = vector(&fragments.normal);
    let to_light = light.towards(vector(&fragments.position), normal);
    let bump = scene.bumps.vector(fragments.bump[i]);
    Fragment {
        normal,
        tangent: vector(&fragments.tangent),
        light: to_light,
        half: crate::scene::halfway(to_light, vector(&fragments.eye), normal),
        // A mirrored texture: its second axis is the other way round in the frame (T, N × T, N).
        perturbed: DVec3::new(bump.x, bump.y * fragments.handedness[i], bump.z),
    }
}

/// Colour from light and texture, saturated.
fn colour(diffuse: f64, specular: f64, texel: [f32; 3]) -> [f64; 3] {
    let (diffuse, specular) = (diffuse.min(1.0), specular.min(1.0));
    texel.map(|texel| (diffuse * f64::from(texel) + specular).min(1.0))
}

/// Diffuse and specular light of a perturbed normal, without the ambient light.
fn reflected(point: &Fragment, normal: DVec3, light: &Light, material: &Material) -> (f64, f64) {
    let diffuse = light.intensity * material.diffuse * normal.dot(point.light).max(0.0);
    let across = normal.dot(point.half);
    let exponent = i32::try_from(material.exponent).unwrap_or(i32::MAX);
    let power = if across > 0.0 { across.min(1.0).powi(exponent) } else { 0.0 };
    (diffuse, light.intensity * material.specular * power)
}

fn block(scene: &Scene, shaders: &[Shader], rows: Range<u32>, lanes: &mut Lanes) -> Result<Block> {
    let Lanes { fragments, runners } = lanes;
    scene.trace(rows, fragments);
    let len = fragments.len();
    let material_of = |i: usize| cast::index_of_u32(fragments.object[i]);
    let texel_of = |i: usize| scene.texture.texels()[cast::index_of_u32(fragments.texel[i])];
    let by_material = by_material(fragments);
    let mut golden = vec![(0.0, 0.0); len];
    let mut blinn = vec![(0.0, 0.0); len];
    for i in 0..len {
        let ambient = scene.ambient * scene.materials[material_of(i)].ambient;
        (golden[i].0, blinn[i].0) = (ambient, ambient);
    }
    let mut sums: Vec<Vec<(f64, f64)>> = shaders.iter().map(|_| vec![(0.0, 0.0); len]).collect();
    let mut shots: Vec<BlockShot> = shaders.iter().map(|_| BlockShot::default()).collect();
    for (number, light) in scene.lights.iter().enumerate() {
        for (material_index, members) in &by_material {
            let material = &scene.materials[*material_index];
            let points: Vec<Fragment> =
                members.iter().map(|i| shading_point(scene, fragments, *i, light)).collect();
            for (point, i) in points.iter().zip(members) {
                let p = point.perturbed;
                let binormal = point.normal.cross(point.tangent);
                let perturbed = p.x * point.tangent + p.y * binormal + p.z * point.normal;
                let add = |sum: &mut (f64, f64), (diffuse, specular): (f64, f64)| {
                    sum.0 += diffuse;
                    sum.1 += specular;
                };
                add(&mut golden[*i], reflected(point, perturbed, light, material));
                let by_blinn = blinn_normal(scene, fragments, *i);
                add(&mut blinn[*i], reflected(point, by_blinn, light, material));
            }
            // Values of ports, which pipelines share.
            let mut values: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
            for ((shader, runners), (sums, shot)) in
                shaders.iter().zip(&mut *runners).zip(sums.iter_mut().zip(&mut shots))
            {
                let index = shader.of[*material_index][number];
                let stage = &shader.stages[index];
                let runner = &mut runners[index];
                for (at, port) in stage.ports.iter().enumerate() {
                    values
                        .entry(stage.design.netlist.input_name(at))
                        .or_insert_with(|| points.iter().map(|p| p.value(*port)).collect());
                }
                let columns: Vec<Vec<f64>> = (0..stage.ports.len())
                    .map(|at| values[stage.design.netlist.input_name(at)].clone())
                    .collect();
                shade(stage, runner, &columns, members, sums, shot)?;
            }
        }
    }
    let finish = |sums: &[(f64, f64)]| -> Vec<[f64; 3]> {
        sums.iter().enumerate().map(|(i, (d, s))| colour(*d, *s, texel_of(i))).collect()
    };
    for (shot, sums) in shots.iter_mut().zip(&sums) {
        shot.colours = finish(sums);
    }
    let (golden, blinn) = (finish(&golden), finish(&blinn));
    let differences = golden.iter().flatten().zip(blinn.iter().flatten());
    Ok(Block {
        pixels: fragments.pixel.clone(),
        blinn: differences.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max),
        golden,
        shots,
    })
}

/// The perturbed normal by Blinn's equation, from the slopes along the texture's axes.
fn blinn_normal(scene: &Scene, fragments: &Fragments, i: usize) -> DVec3 {
    let bump = scene.bumps.vector(fragments.bump[i]);
    let (slope_u, slope_v) = (-bump.x / bump.z, -bump.y / bump.z);
    let normal = Fragments::vector(&fragments.normal, i);
    let (pu, pv) = (Fragments::vector(&fragments.tangent, i), fragments.bitangent(i));
    // The equation takes N as P_u × P_v; a mirrored texture has N on the other side.
    let side = fragments.handedness[i];
    (normal + side * (slope_u * normal.cross(pv) - slope_v * normal.cross(pu))).normalize()
}

/// Runs a design over fragments and adds the light of each.
fn shade(
    stage: &Stage,
    runner: &mut Runner,
    columns: &[Vec<f64>],
    members: &[usize],
    sums: &mut [(f64, f64)],
    shot: &mut BlockShot,
) -> Result<()> {
    let netlist = &stage.design.netlist;
    let mut words = Vec::new();
    quantize_inputs(netlist, columns, &mut words)?;
    let slices: Vec<&[i64]> = words.iter().map(Vec::as_slice).collect();
    let judged = stage.vector.as_ref().map_or(0, Range::len);
    let mut out = vec![Vec::new(); 1 + usize::from(stage.has_specular) + judged];
    let before: u64 = runner.overflows().iter().sum();
    let start = Instant::now();
    runner.run(&stage.program, &slices, &mut out);
    shot.engine += start.elapsed();
    shot.samples += cast::count_of(members.len());
    shot.overflows += runner.overflows().iter().sum::<u64>() - before;
    let ulp = stage.light_format.ulp();
    for (at, i) in members.iter().enumerate() {
        // Words of a light are exact in f64, and so are sums of some of them.
        sums[*i].0 += cast::f64_of(out[0][at]) * ulp;
        if stage.has_specular {
            sums[*i].1 += cast::f64_of(out[1][at]) * ulp;
        }
    }
    if let Some(range) = &stage.vector {
        let group = stage.design.groups.iter().position(|group| group.name == "lt");
        let group = group.expect("bug: it was found before");
        let first: usize =
            stage.design.groups[..group].iter().map(|g| g.shape.columns().len()).sum();
        let group = &stage.design.groups[group];
        let values: Vec<Vec<f64>> = group
            .nodes
            .iter()
            .zip(&out[range.clone()])
            .map(|(node, words)| {
                let ulp = netlist.node(*node).format.ulp();
                words.iter().map(|word| cast::f64_of(*word) * ulp).collect()
            })
            .collect();
        let (mut is, mut should) = (Vec::new(), Vec::new());
        as_golden(std::slice::from_ref(group), &values, &mut is);
        run_golden(&stage.design, columns, &mut should);
        for i in 0..members.len() {
            let at = |columns: &[Vec<f64>]| [0, 1, 2].map(|axis| columns[axis][i]);
            let angle = angle_between(at(&is), at(&should[first..]));
            shot.angle_max = shot.angle_max.max(angle);
            shot.angle_sum += angle;
        }
    }
    Ok(())
}
