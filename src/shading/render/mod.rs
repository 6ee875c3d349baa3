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
//!
//! Emboss pipelines are another family, with a golden of their own: see [`emboss`]. Those of the tangent-space
//! set-up have this golden and one more, of their own flow: see [`tangent`].

pub mod emboss;
mod named;
mod specialised;
pub mod tangent;

pub use specialised::{SeenPort, SpecialisedStage, specialise_to};

use crate::base::cast;
use crate::base::error::{Error, Result, nearest};
use crate::base::json;
use crate::design::{Design, Kind, Param, Reflection, Role, Shading, Unit, Value, Values};
use crate::measure::{
    BINS, Basis, Figures, Histograms, OverflowCount, Report, Speed, Stream, angle_between,
    as_golden, overflow_counts, quantize_inputs, run_golden,
};
use crate::netlist::NodeId;
use crate::number::format::Format;
use crate::shading::picture::{Difference, Picture, nothing_in_view};
use crate::shading::scene::{Fragments, Light, Material, Scene};
use crate::sim::batch::{Program, Runner, check_overflows};
use crate::units::UNITS;
use crate::units::fragment::{Fragment, Port};
use glam::DVec3;
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// The most pixels of all pictures that are rendered together.
const TOGETHER_PIXELS: u64 = 1 << 24;
/// Rows that a thread takes at a time.
const ROWS: u32 = 8;
/// Blocks of rows whose colours are held at a time.
const BLOCKS_TOGETHER: usize = 64;

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
    /// Where the texture frames of pixels come from.
    pub frames: Frames,
}

/// Where texture frames (T, B, N) of pixels come from.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Frames {
    /// Floating point, for each pixel: those of the golden.
    #[default]
    Float,
    /// The fixed-point set-up (unit `tangent`), for each corner of each face; interpolated. Spheres, which have no
    /// corners, keep their own. See [`tangent`].
    Setup,
}

/// Pipelines that are settings of the emboss unit.
pub const EMBOSS_PIPELINES: [&str; 2] = ["emboss-gx", "emboss-nv"];

/// Pipelines that are settings of the tangent-space set-up.
pub const TANGENT_PIPELINES: [&str; 2] = ["tangent-smooth", "tangent-faceted"];

/// Sets a part of the reflection formula in every material of a scene, for the golden and for pipelines
/// alike.
///
/// # Panics
/// If the value is none of its kind: that is wrong code.
pub fn set_material(scene: &mut Scene, part: Reflection, value: Value) {
    for material in &mut scene.materials {
        match (part, value) {
            (Reflection::Ambient, Value::Real(number)) => material.ambient = number.get(),
            (Reflection::Diffuse, Value::Real(number)) => material.diffuse = number.get(),
            (Reflection::Specular, Value::Real(number)) => material.specular = number.get(),
            (Reflection::Exponent, Value::Int(number)) => {
                material.exponent = u32::try_from(number).expect("bug: a legal exponent");
            }
            _ => panic!("bug: {part:?} is not {value}"),
        }
    }
}

/// The units that are pipelines.
pub(crate) fn pipeline_units() -> impl Iterator<Item = &'static Unit> {
    UNITS.iter().copied().filter(|unit| unit.shades == Shading::Pipeline)
}

/// Names of the pipelines that a unit is.
fn pipelines_of(unit: &Unit) -> Vec<&'static str> {
    let choices = unit.params.iter().find(|param| param.role == Role::Pipeline);
    match choices.map(|param| param.kind) {
        Some(Kind::Choice(names)) => names.to_vec(),
        Some(Kind::Int { .. } | Kind::Real { .. }) | None => vec![unit.name],
    }
}

/// True if a parameter of a unit comes from a scene's material and lights.
fn is_of_material(unit: &Unit, key: &str) -> bool {
    unit.param(key).is_some_and(|param| matches!(param.role, Role::Material(_)))
}

impl Pipeline {
    /// Names of all pipelines that shade bumps.
    #[must_use]
    pub fn names() -> Vec<&'static str> {
        pipeline_units().flat_map(pipelines_of).collect()
    }

    /// The pipeline of a name.
    ///
    /// # Errors
    /// If there is none.
    ///
    /// # Panics
    /// Never: each name is that of a unit.
    pub fn named(name: &str) -> Result<Self> {
        let names: Vec<&str> =
            Self::names().into_iter().chain(TANGENT_PIPELINES).chain(EMBOSS_PIPELINES).collect();
        if !names.contains(&name) {
            let (hint, names) = (nearest(name, names.iter().copied()), names.join(", "));
            return Err(Error::usage(format!("no pipeline `{name}`{hint}: legal is {names}")));
        }
        if let Some(setting) = name.strip_prefix("emboss-") {
            let assignments = vec![format!("setting={setting}")];
            return Ok(Self::with(name, Unit::find("emboss")?, assignments));
        }
        if let Some(frame) = name.strip_prefix("tangent-") {
            let assignments = vec![format!("frame={frame}")];
            return Ok(Self::with(name, Unit::find("tangent")?, assignments));
        }
        let unit = pipeline_units().find(|unit| pipelines_of(unit).contains(&name));
        let unit = unit.expect("bug: it is among the names");
        let choice = unit.params.iter().find(|param| param.role == Role::Pipeline);
        let assignments = choice.map(|param| format!("{}={name}", param.name));
        Ok(Self::with(name, unit, assignments.into_iter().collect()))
    }

    fn with(name: &str, unit: &'static Unit, assignments: Vec<String>) -> Self {
        Self { name: name.to_owned(), unit, assignments, frames: Frames::Float }
    }

    /// True if it embosses: its golden is another one than that of the others.
    #[must_use]
    pub fn is_emboss(&self) -> bool {
        EMBOSS_PIPELINES.contains(&self.name.as_str())
    }

    /// True if it sets triangles up and lights in texture space.
    #[must_use]
    pub fn is_tangent(&self) -> bool {
        TANGENT_PIPELINES.contains(&self.name.as_str())
    }

    /// False if it takes nothing of the normals at vertices, so that triangles' own do where a mesh has none.
    #[must_use]
    pub fn takes_normals(&self) -> bool {
        self.name != "tangent-faceted"
    }

    /// What it sets beside the parameter that tells the unit's pipelines apart.
    pub(crate) fn given(&self) -> impl Iterator<Item = &String> {
        self.assignments.iter().filter(|set| !self.names_it(set))
    }

    /// True if an assignment says which of the unit's pipelines this is.
    fn names_it(&self, set: &str) -> bool {
        let param = set.split_once('=').and_then(|(key, _)| self.unit.param(key));
        param.is_some_and(|param| param.role == Role::Pipeline)
    }

    /// Parameters of all its units.
    pub fn params(&self) -> impl Iterator<Item = &'static Param> + use<> {
        let behind: &[&'static Unit] = match self.frames {
            _ if self.is_emboss() => &emboss::BEHIND,
            Frames::Float => &[],
            Frames::Setup => &tangent::BEFORE,
        };
        self.unit.all_params().chain(behind.iter().flat_map(|unit| unit.all_params()))
    }

    /// A unit with parameters, under a name of its own; what the scene gives is left out of them.
    #[must_use]
    pub fn of_unit(name: &str, unit: &'static Unit, assignments: &[String]) -> Self {
        let from_scene =
            |set: &&String| set.split_once('=').is_some_and(|(key, _)| is_of_material(unit, key));
        let assignments = assignments.iter().filter(|set| !from_scene(set)).cloned().collect();
        Self::with(name, unit, assignments)
    }

    /// The pipeline of all parameters of a unit but those of the material.
    #[must_use]
    pub fn of_values(values: &Values) -> Self {
        let given = values.params().filter(|(p, _)| !matches!(p.role, Role::Material(_)));
        let assignments = given.map(|(param, value)| format!("{}={value}", param.name)).collect();
        Self::with(values.unit().name, values.unit(), assignments)
    }

    /// Sets parameters for all pipelines that have them.
    ///
    /// # Errors
    /// If none has one of them, or the scene gives it.
    pub fn set(pipelines: &mut [Self], assignments: &[String]) -> Result<()> {
        for assignment in assignments {
            let (key, _) =
                assignment.split_once('=').ok_or_else(|| Error::form(assignment, "key=value"))?;
            if pipelines.iter().any(|pipeline| is_of_material(pipeline.unit, key)) {
                let text =
                    format!("parameter `{key}` comes from the scene's [material] and lights");
                return Err(Error::usage(text));
            }
            if emboss::FROM_SCENE.contains(&key) && pipelines.iter().any(Self::is_emboss) {
                let text = format!(
                    "parameter `{key}` comes from the name of the emboss pipeline, or the scene's [emboss], lights and height map"
                );
                return Err(Error::usage(text));
            }
            if tangent::FROM_SCENE.contains(&key) && pipelines.iter().any(Self::is_tangent) {
                let text = format!(
                    "parameter `{key}` comes from the name of the tangent pipeline, or the scene's lights"
                );
                return Err(Error::usage(text));
            }
            let is_named = |p: &Self| {
                p.names_it(assignment) && p.assignments.iter().any(|own| p.names_it(own))
            };
            if pipelines.iter().any(is_named) {
                let text = format!("parameter `{key}` comes from the names of the pipelines");
                return Err(Error::usage(text));
            }
            let mut known = false;
            for pipeline in pipelines.iter_mut() {
                if pipeline.params().any(|param| param.name == key) {
                    known = true;
                    pipeline.assignments.push(assignment.clone());
                }
            }
            if !known {
                let names: Vec<&str> = pipelines.iter().map(|p| p.name.as_str()).collect();
                let all = pipelines.iter().flat_map(Self::params);
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
        // Others are for the set-up of the frames.
        let mut assignments = match self.frames {
            Frames::Float => self.assignments.clone(),
            Frames::Setup => {
                let known = |set: &&String| named::knows(self.unit, set);
                self.assignments.iter().filter(known).cloned().collect()
            }
        };
        if light.intensity * material.specular > 0.0
            && assignments.iter().any(|set| set == "highlight=off")
        {
            let text = "highlight=off leaves out specular light that the scene has: set specular = 0 in its [material]";
            return Err(Error::usage(text.to_owned()));
        }
        for param in self.unit.params {
            let Role::Material(part) = param.role else { continue };
            let value = match part {
                Reflection::Ambient => ambient,
                Reflection::Diffuse => light.intensity * material.diffuse,
                Reflection::Specular => light.intensity * material.specular,
                Reflection::Exponent => f64::from(material.exponent),
            };
            // A product of numbers that are at most 1 each can be an ulp above.
            let legal = match param.kind {
                Kind::Real { min, max } => value.clamp(min, max),
                Kind::Int { .. } | Kind::Choice(_) => value,
            };
            assignments.push(format!("{}={legal}", param.name));
        }
        self.unit.values(&assignments)?.build()
    }
}

/// A design ready to shade pixels.
struct Stage {
    design: Arc<Design>,
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
        let (design, has_specular) = (Arc::new(design), specular.is_some());
        Ok(Self { program, ports, vector, has_specular, light_format, design })
    }

    /// True unless its specular light is 0 everywhere.
    fn needs_specular(&self) -> bool {
        let specular = self.design.values.reflection(Reflection::Specular);
        let dark = matches!(specular, Some(Value::Real(number)) if number.get() <= 0.0);
        self.has_specular && !dark
    }
}

/// A pipeline ready to shade the pixels of a scene: all its designs.
pub struct Shader {
    pipeline: Pipeline,
    stages: Vec<Stage>,
    /// Stage of each material under each light.
    of: Vec<Vec<usize>>,
    /// Frames of its own.
    frames: Option<Arc<tangent::FaceFrames>>,
}

impl Shader {
    /// The pipeline on a scene; `vectors` also judges the rotated light vectors.
    ///
    /// # Errors
    /// If the pipeline can't be built with its parameters, or lacks a port.
    pub fn new(scene: &Scene, pipeline: &Pipeline, vectors: bool) -> Result<Self> {
        Self::with_stages(scene, pipeline, vectors, true, true)
    }

    /// As [`Shader::new`]; unless `shared`, each material has a stage of its own under each light,
    /// also where two are built the same; unless `framed`, frames are left to be put in.
    fn with_stages(
        scene: &Scene,
        pipeline: &Pipeline,
        vectors: bool,
        shared: bool,
        framed: bool,
    ) -> Result<Self> {
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
                    Some(index) if shared => *index,
                    Some(_) | None => {
                        stages.push(Stage::new(design, vectors)?);
                        known.insert(key, stages.len() - 1);
                        stages.len() - 1
                    }
                };
                row.push(index);
            }
            of.push(row);
        }
        let frames = match pipeline.frames {
            Frames::Setup if framed => Some(Arc::new(tangent::FaceFrames::new(scene, pipeline)?)),
            Frames::Float | Frames::Setup => None,
        };
        Ok(Self { pipeline: pipeline.clone(), stages, of, frames })
    }

    /// One of its designs: that of the first material under the first light. The others differ in
    /// what the light tables hold.
    #[must_use]
    pub fn design(&self) -> &Arc<Design> {
        &self.stages[0].design
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
    #[serde(serialize_with = "json::real")]
    pub max_rad: f64,
    /// The mean, in rad.
    #[serde(serialize_with = "json::real")]
    pub mean_rad: f64,
    /// The root of the mean square, in rad.
    #[serde(serialize_with = "json::real")]
    pub rms_rad: f64,
    /// The median, in rad, to 1.6 %; 0 means below 2^-44.
    #[serde(serialize_with = "json::real")]
    pub p50_rad: f64,
    /// The 99th percentile, likewise.
    #[serde(serialize_with = "json::real")]
    pub p99_rad: f64,
    /// The 99.9th percentile, likewise.
    #[serde(serialize_with = "json::real")]
    pub p999_rad: f64,
}

impl VectorError {
    fn of(angles: &Stream, histogram: &[u64]) -> Self {
        let figures = angles.figures("lt_angle", "rad", Basis::EndToEnd, histogram);
        Self {
            max_rad: figures.max,
            mean_rad: figures.mean,
            rms_rad: figures.rms,
            p50_rad: figures.p50,
            p99_rad: figures.p99,
            p999_rad: figures.p999,
        }
    }

    /// The same as figures of a quantity `lt_angle`.
    fn figures(&self) -> Figures {
        Figures {
            quantity: "lt_angle".to_owned(),
            unit: "rad",
            over: None,
            basis: Basis::EndToEnd,
            max: self.max_rad,
            max_ulp: None,
            witness: None,
            mean: self.mean_rad,
            bias: self.mean_rad, // an angle has no sign
            rms: self.rms_rad,
            p50: self.p50_rad,
            p99: self.p99_rad,
            p999: self.p999_rad,
        }
    }
}

/// A picture by a pipeline.
#[derive(Clone, Debug)]
pub struct Shot {
    /// The pipeline.
    pub pipeline: Pipeline,
    /// Its picture.
    pub picture: Picture,
    /// Its golden picture, where that isn't [`Rendered::golden`]: an emboss that displaces the other way.
    pub golden: Option<Arc<Picture>>,
    /// One of its designs: that of the first material under the first light.
    pub design: Arc<Design>,
    /// Designs of the units behind it, if there are some.
    pub behind: Vec<Arc<Design>>,
    /// What is known of an emboss.
    pub emboss: Option<emboss::Known>,
    /// What is known of a tangent-space set-up.
    pub setup: Option<Box<tangent::Known>>,
    /// What is known of the set-up of its frames, if they are set up.
    pub frames: Option<Box<tangent::FramesKnown>>,
    /// Time in the bit-true engine, all threads together.
    pub engine: Duration,
    /// Samples per second and thread of the engine alone: the median of all samples by the rate of the
    /// rows that they were in, so that a thread that was held up hardly shows.
    pub samples_per_second: f64,
    /// Samples that the engine took: covered pixels times lights.
    pub samples: u64,
    /// Errors of the rotated light vectors, if they were asked for and the unit has them.
    pub vectors: Option<VectorError>,
    /// Every `narrow` that overflowed at least once.
    pub overflows: Vec<OverflowCount>,
}

impl Shot {
    /// How often any `narrow` overflowed.
    #[must_use]
    pub fn overflowed(&self) -> u64 {
        self.overflows.iter().map(|overflow| overflow.count).sum()
    }
}

/// A scene rendered.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The golden picture, in `f64`: tangent-space bump mapping, or an emboss as the first pipeline has it.
    pub golden: Picture,
    /// The largest difference of Blinn's equation to it, in linear light; an emboss has none.
    pub blinn: Option<f64>,
    /// Pixels that see an object.
    pub covered: u64,
    /// Which they are, row after row.
    pub covers: Vec<bool>,
    /// The pipelines' pictures.
    pub shots: Vec<Shot>,
    /// Wall-clock time of all of it.
    pub elapsed: Duration,
}

impl Rendered {
    /// The golden picture of a shot.
    #[must_use]
    pub fn golden_of<'a>(&'a self, shot: &'a Shot) -> &'a Picture {
        shot.golden.as_deref().unwrap_or(&self.golden)
    }

    /// Pixels that see no object.
    #[must_use]
    pub fn background(&self) -> u64 {
        cast::count_of(self.covers.len()) - self.covered
    }

    /// How far one picture of the scene is from another, over the pixels that see an object;
    /// `pixels_per_degree` is FLIP's.
    ///
    /// # Errors
    /// If no pixel does, or FLIP can't look that finely.
    pub fn difference(
        &self,
        picture: &Picture,
        golden: &Picture,
        pixels_per_degree: f64,
    ) -> Result<Difference> {
        Difference::over(&self.covers, picture, golden, pixels_per_degree)
    }

    /// A shot as a measurement, end to end: `picture`, the difference to the golden in linear light of
    /// every channel of every covered pixel, and `lt_angle`, if it was judged. The difference is that of
    /// the shot's picture.
    #[must_use]
    pub fn report(&self, shot: &Shot, difference: &Difference) -> Report {
        let mut histogram = vec![0; BINS];
        let (mut stream, histograms) = (Stream::EMPTY, Histograms::new(1));
        let width = self.golden.width_px();
        let golden = self.golden_of(shot);
        let rows = shot.picture.pixels().chunks(width).zip(golden.pixels().chunks(width));
        for ((is, should), covers) in rows.zip(self.covers.chunks(width)) {
            let pixels = is.iter().zip(should).zip(covers).filter(|(_, covered)| **covered);
            let pairs = pixels.flat_map(|((is, should), _)| is.iter().zip(should));
            let errors: Vec<f64> = pairs.map(|(a, b)| f64::from(*a) - f64::from(*b)).collect();
            stream.merge(&Stream::of(&errors, 0, &mut histogram));
            histograms.take(&mut histogram);
        }
        // The mean is summed up in another order there: one number, not two that differ in the last place.
        let mut figures = vec![Figures {
            mean: difference.mean,
            ..stream.figures("picture", "1", Basis::EndToEnd, &histograms.of(0))
        }];
        figures.extend(shot.vectors.map(|vectors| vectors.figures()));
        let samples = self.shots.iter().map(|shot| shot.samples).sum();
        Report {
            samples: shot.samples,
            figures,
            overflows: shot.overflows.clone(),
            speed: Speed {
                engine_samples_per_second_per_thread: shot.samples_per_second,
                samples_per_second: cast::f64_of_count(samples)
                    / self.elapsed.as_secs_f64().max(f64::MIN_POSITIVE),
                threads: rayon::current_num_threads(),
                ..Speed::default()
            },
        }
    }
}

/// What a thread keeps from block to block.
struct Lanes {
    fragments: Fragments,
    runners: Vec<Vec<Runner>>,
    /// Of the angle errors of each pipeline.
    histograms: Vec<u32>,
}

/// What a block of rows gave.
struct Block {
    pixels: Vec<u32>,
    golden: Vec<[f64; 3]>,
    blinn: f64,
    shots: Vec<BlockShot>,
}

struct BlockShot {
    colours: Vec<[f64; 3]>,
    engine: Duration,
    samples: u64,
    /// Of each `narrow` of each stage.
    overflows: Vec<Vec<u64>>,
    angles: Stream,
}

impl BlockShot {
    fn new(shader: &Shader) -> Self {
        Self::of(shader.stages.iter().map(|stage| &stage.program))
    }

    /// Nothing yet, by some programs.
    fn of<'a>(programs: impl Iterator<Item = &'a Program>) -> Self {
        Self {
            colours: Vec::new(),
            engine: Duration::ZERO,
            samples: 0,
            overflows: programs.map(|program| vec![0; program.narrows().len()]).collect(),
            angles: Stream::EMPTY,
        }
    }

    /// Adds up all but the colours.
    fn merge(&mut self, later: &Self) {
        self.engine += later.engine;
        self.samples += later.samples;
        for (total, count) in
            self.overflows.iter_mut().flatten().zip(later.overflows.iter().flatten())
        {
            *total += count;
        }
        self.angles.merge(&later.angles);
    }
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
    let embosses = pipelines.iter().filter(|pipeline| pipeline.is_emboss()).count();
    if embosses > 0 && embosses == pipelines.len() {
        return emboss::render(scene, pipelines, progress);
    }
    if embosses > 0 {
        return Err(mixed());
    }
    let (setups, others): (Vec<&Pipeline>, Vec<&Pipeline>) =
        pipelines.iter().partition(|pipeline| pipeline.is_tangent());
    // The golden then has facets, too, and vertices that nothing splits.
    let facets = !pipelines.is_empty() && !pipelines.iter().any(Pipeline::takes_normals);
    let faceted = if facets { scene.faceted() } else { None };
    let scene = faceted.as_ref().unwrap_or(scene);
    let mut shaders: Vec<Shader> = Vec::new();
    for pipeline in others {
        let mut shader = Shader::with_stages(scene, pipeline, vectors, true, false)?;
        if pipeline.frames == Frames::Setup {
            // Of the same parameters, once for all.
            let own = tangent::FaceFrames::parameters(pipeline);
            let same = |known: &&Shader| tangent::FaceFrames::parameters(&known.pipeline) == own;
            shader.frames = match shaders.iter().find(same) {
                Some(known) => known.frames.clone(),
                None => Some(Arc::new(tangent::FaceFrames::new(scene, pipeline)?)),
            };
        }
        shaders.push(shader);
    }
    let shaders: Vec<&Shader> = shaders.iter().collect();
    if setups.is_empty() {
        return shoot(scene, &shaders, progress);
    }
    let start = Instant::now();
    let height = u64::from(scene.image.height);
    // Two passes over the rows.
    let mut rendered = shoot(scene, &shaders, &|done| progress(done / 2))?;
    let setups = tangent::shots(scene, &setups, &|done| progress((height + done) / 2))?;
    let (mut setups, mut others) = (setups.into_iter(), rendered.shots.into_iter());
    // As they were asked for.
    let shots = pipelines
        .iter()
        .filter_map(|pipeline| if pipeline.is_tangent() { setups.next() } else { others.next() });
    rendered.shots = shots.collect();
    rendered.elapsed = start.elapsed();
    Ok(rendered)
}

/// The error for emboss pipelines among others.
pub(crate) fn mixed() -> Error {
    let text = "emboss pipelines have a golden of their own: render them apart from the others, into another folder";
    Error::usage(text.to_owned())
}

/// How many pictures of a scene are best rendered together: all are in memory.
#[must_use]
pub fn shots_together(scene: &Scene) -> usize {
    usize::try_from(TOGETHER_PIXELS / scene.image.pixels()).unwrap_or(1).max(1)
}

/// How many are true.
fn count(covers: &[bool]) -> u64 {
    cast::count_of(covers.iter().filter(|covered| **covered).count())
}

/// Fails if no pixel of a scene sees an object, which takes no picture to know.
///
/// # Errors
/// So it does.
pub fn check_view(scene: &Scene) -> Result<()> {
    let sees = |fragments: &mut Fragments, rows: Range<u32>| {
        scene.trace(rows, fragments);
        !fragments.is_empty()
    };
    let seen = blocks(scene.image.height).into_par_iter().map_init(Fragments::default, sees);
    if seen.any(|seen| seen) { Ok(()) } else { Err(nothing_in_view()) }
}

/// Renders a scene by shaders made for it, all at once: the golden is computed for all of them.
/// `progress` gets the rows done.
///
/// # Errors
/// If a `narrow` under overflow mode `error` overflowed.
pub fn shoot(
    scene: &Scene,
    shaders: &[&Shader],
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Rendered> {
    let start = Instant::now();
    let lanes = || Lanes {
        fragments: Fragments::default(),
        runners: shaders
            .iter()
            .map(|shader| shader.stages.iter().map(|stage| stage.program.runner()).collect())
            .collect(),
        histograms: vec![0; shaders.len() * BINS],
    };
    let histograms = Histograms::new(shaders.len());
    let shade_rows = |lanes: &mut Lanes, rows: Range<u32>| {
        let block = block(scene, shaders, rows, lanes);
        histograms.take(&mut lanes.histograms);
        block
    };
    let totals = shaders.iter().map(|shader| BlockShot::new(shader)).collect();
    let Gathered { golden, blinn, covers, pictures, totals, mut rates } =
        gather(scene, totals, lanes, shade_rows, progress)?;
    let mut shots = Vec::new();
    for (index, ((shader, picture), total)) in shaders.iter().zip(pictures).zip(totals).enumerate()
    {
        let vectors = shader.stages[0].vector.is_some();
        let stages = shader.stages.iter().map(|stage| (&stage.design, &stage.program));
        shots.push(Shot {
            pipeline: shader.pipeline.clone(),
            picture,
            golden: None,
            design: Arc::clone(shader.design()),
            behind: shader.frames.iter().map(|frames| Arc::clone(frames.design())).collect(),
            emboss: None,
            setup: None,
            frames: shader.frames.as_ref().map(|frames| Box::new(frames.known().clone())),
            engine: total.engine,
            samples_per_second: median_rate(&mut rates[index]),
            samples: total.samples,
            vectors: vectors.then(|| VectorError::of(&total.angles, &histograms.of(index))),
            overflows: overflows(stages, &total.overflows)?,
        });
    }
    Ok(Rendered {
        golden,
        blinn: Some(blinn),
        covered: count(&covers),
        covers,
        shots,
        elapsed: start.elapsed(),
    })
}

/// Pictures put together of blocks of rows.
struct Gathered {
    golden: Picture,
    blinn: f64,
    /// Which pixels see an object.
    covers: Vec<bool>,
    pictures: Vec<Picture>,
    totals: Vec<BlockShot>,
    /// Time and samples of each block, by picture.
    rates: Vec<Vec<(Duration, u64)>>,
}

/// Renders a scene block by block on all threads; `totals` has an empty entry for each picture.
fn gather<L: Send>(
    scene: &Scene,
    mut totals: Vec<BlockShot>,
    lanes: impl Fn() -> L + Sync,
    shade_rows: impl Fn(&mut L, Range<u32>) -> Result<Block> + Sync,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Gathered> {
    let blocks = blocks(scene.image.height);
    let done = AtomicU64::new(0);
    let shade_rows = |lanes: &mut L, rows: &Range<u32>| {
        let block = shade_rows(lanes, rows.clone());
        let before = done.fetch_add(u64::from(rows.end - rows.start), Ordering::Relaxed);
        progress(before + u64::from(rows.end - rows.start));
        block
    };
    let (width, height) =
        (cast::index_of_u32(scene.image.width), cast::index_of_u32(scene.image.height));
    let background = scene.image.background.map(cast::f32_of);
    let blank = vec![background; width * height];
    let mut golden = blank.clone();
    let mut blinn = 0f64;
    let mut covers = vec![false; width * height];
    let mut pictures = vec![blank; totals.len()];
    let mut rates: Vec<Vec<(Duration, u64)>> = vec![Vec::new(); totals.len()];
    // Some blocks at a time: beside the pictures, memory doesn't grow with their height.
    let rounds = blocks.chunks(BLOCKS_TOGETHER);
    let results = rounds.flat_map(|some| -> Vec<Result<Block>> {
        some.par_iter().map_init(&lanes, shade_rows).collect()
    });
    for block in results {
        let block = block?;
        for pixel in &block.pixels {
            covers[cast::index_of_u32(*pixel)] = true;
        }
        blinn = blinn.max(block.blinn);
        let write = |pixels: &mut [[f32; 3]], colours: &[[f64; 3]]| {
            for (pixel, colour) in block.pixels.iter().zip(colours) {
                pixels[cast::index_of_u32(*pixel)] = colour.map(cast::f32_of);
            }
        };
        write(&mut golden, &block.golden);
        for (((picture, total), rates), shot) in
            pictures.iter_mut().zip(&mut totals).zip(&mut rates).zip(&block.shots)
        {
            write(picture, &shot.colours);
            total.merge(shot);
            rates.push((shot.engine, shot.samples));
        }
    }
    let picture = |pixels| Picture::new(width, height, pixels);
    Ok(Gathered {
        golden: picture(golden)?,
        blinn,
        covers,
        pictures: pictures.into_iter().map(picture).collect::<Result<_>>()?,
        totals,
        rates,
    })
}

/// The rate, in samples per second, that half of all samples were not above; 0 if there are none.
fn median_rate(blocks: &mut [(Duration, u64)]) -> f64 {
    let rate = |(time, samples): &(Duration, u64)| {
        cast::f64_of_count(*samples) / time.as_secs_f64().max(1e-9)
    };
    blocks.sort_by(|a, b| rate(a).total_cmp(&rate(b)));
    let all: u64 = blocks.iter().map(|(_, samples)| samples).sum();
    let mut seen = 0;
    let middle = blocks.iter().find(|(_, samples)| {
        seen += samples;
        2 * seen >= all
    });
    middle.map_or(0.0, rate)
}

/// What overflowed in any of some designs.
fn overflows<'a>(
    stages: impl Iterator<Item = (&'a Arc<Design>, &'a Program)>,
    counts: &[Vec<u64>],
) -> Result<Vec<OverflowCount>> {
    let mut all: Vec<OverflowCount> = Vec::new();
    for ((design, program), counts) in stages.zip(counts) {
        let (netlist, narrows) = (&design.netlist, program.narrows());
        check_overflows(netlist, narrows, counts)?;
        for overflow in overflow_counts(netlist, narrows, counts) {
            match all.iter_mut().find(|known| known.node == overflow.node) {
                Some(known) => known.count += overflow.count,
                None => all.push(overflow),
            }
        }
    }
    Ok(all)
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

/// Values of a port.
fn port_column(port: Port, points: &[Fragment]) -> Vec<f64> {
    let mut column = Vec::new();
    port.column(points, &mut column);
    column
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
        half: crate::shading::scene::halfway(to_light, vector(&fragments.eye), normal),
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

fn block(scene: &Scene, shaders: &[&Shader], rows: Range<u32>, lanes: &mut Lanes) -> Result<Block> {
    let Lanes { fragments, runners, histograms } = lanes;
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
    let mut shots: Vec<BlockShot> = shaders.iter().map(|shader| BlockShot::new(shader)).collect();
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
            for (((shader, runners), histogram), (sums, shot)) in shaders
                .iter()
                .zip(&mut *runners)
                .zip(histograms.chunks_mut(BINS))
                .zip(sums.iter_mut().zip(&mut shots))
            {
                let index = shader.of[*material_index][number];
                let stage = &shader.stages[index];
                let runner = &mut runners[index];
                let columns: Vec<Vec<f64>> = match &shader.frames {
                    None => {
                        let shared = |(at, port): (usize, &Port)| {
                            let name = stage.design.netlist.input_name(at);
                            values
                                .entry(name)
                                .or_insert_with(|| port_column(*port, &points))
                                .clone()
                        };
                        stage.ports.iter().enumerate().map(shared).collect()
                    }
                    Some(frames) => {
                        let framed = points.iter().zip(members).map(|(point, i)| {
                            frames.frame(scene, fragments, *i, point).unwrap_or(*point)
                        });
                        let framed: Vec<Fragment> = framed.collect();
                        stage.ports.iter().map(|port| port_column(*port, &framed)).collect()
                    }
                };
                let overflows = runner.overflows().to_vec();
                shade(stage, runner, &columns, members, sums, shot, histogram)?;
                for ((total, after), before) in
                    shot.overflows[index].iter_mut().zip(runner.overflows()).zip(overflows)
                {
                    *total += after - before;
                }
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
    let (slope_u, slope_v) = slopes(scene, fragments.bump[i]);
    let normal = Fragments::vector(&fragments.normal, i);
    let (pu, pv) = (Fragments::vector(&fragments.tangent, i), fragments.bitangent(i));
    // The equation takes N as P_u × P_v; a mirrored texture has N on the other side.
    let side = fragments.handedness[i];
    (normal + side * (slope_u * normal.cross(pv) - slope_v * normal.cross(pu))).normalize()
}

/// Slopes B_u, B_v of the height map at a texel, in texels of height per texel, by differences of
/// its neighbours: not from the bump vectors, which they are held against.
fn slopes(scene: &Scene, texel: u32) -> (f64, f64) {
    let (width, height) = scene.bumps.size();
    let (column, row) = (texel % width, texel / width);
    let at = |column: u32, row: u32| {
        scene.bumps.heights()[cast::index_of_u32(row * width + column)] * scene.bumps.scale()
    };
    let (right, left) = ((column + 1) % width, (column + width - 1) % width);
    let (below, above) = ((row + 1) % height, (row + height - 1) % height);
    // v grows upwards.
    (0.5 * (at(right, row) - at(left, row)), 0.5 * (at(column, above) - at(column, below)))
}

/// Runs a design over fragments and adds the light of each.
fn shade(
    stage: &Stage,
    runner: &mut Runner,
    columns: &[Vec<f64>],
    members: &[usize],
    sums: &mut [(f64, f64)],
    shot: &mut BlockShot,
    histogram: &mut [u32],
) -> Result<()> {
    let netlist = &stage.design.netlist;
    let mut words = Vec::new();
    quantize_inputs(netlist, columns, &mut words)?;
    let slices: Vec<&[i64]> = words.iter().map(Vec::as_slice).collect();
    let judged = stage.vector.as_ref().map_or(0, Range::len);
    let mut out = vec![Vec::new(); 1 + usize::from(stage.has_specular) + judged];
    let start = Instant::now();
    runner.run(&stage.program, &slices, &mut out);
    shot.engine += start.elapsed();
    shot.samples += cast::count_of(members.len());
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
        let mut values: Vec<Vec<f64>> = group
            .nodes
            .iter()
            .zip(&out[range.clone()])
            .map(|(node, words)| {
                let ulp = netlist.node(*node).format.ulp();
                words.iter().map(|word| cast::f64_of(*word) * ulp).collect()
            })
            .collect();
        let (mut is, mut should) = (Vec::new(), Vec::new());
        as_golden(std::slice::from_ref(group), &mut values, &mut is);
        run_golden(&stage.design, columns, &mut should);
        let at = |columns: &[Vec<f64>], i: usize| [0, 1, 2].map(|axis| columns[axis][i]);
        let angles: Vec<f64> = (0..members.len())
            .map(|i| angle_between(at(&is, i), at(&should[first..], i)))
            .collect();
        shot.angles.merge(&Stream::of(&angles, 0, histogram));
    }
    Ok(())
}
