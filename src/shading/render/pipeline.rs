//! A pipeline: a unit with parameters, as a way to shade pixels.

use crate::base::error::{Error, Result, nearest};
use crate::design::{Design, Kind, Param, Reflection, Role, Shading, Unit, Value, Values};
use crate::shading::scene::{Light, Material, Scene};
use crate::units::{self, built_in};

/// A unit with parameters, as a way to shade pixels.
#[derive(Clone, Debug)]
pub struct Pipeline {
    /// Name in reports and file names.
    pub name: String,
    /// The unit.
    pub unit: Unit,
    /// Parameters that differ from the defaults, as `key=value`. Material parameters come from the
    /// scene.
    pub assignments: Vec<String>,
    /// The source of the pixels' texture frames.
    pub frames: Frames,
}

/// The source of the pixels' texture frames (T, B, N).
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Frames {
    /// Floating point, for each pixel: those of the golden.
    #[default]
    Float,
    /// The fixed-point setup (unit `tangent`), for each corner of each face, then interpolated.
    /// Spheres have no corners and keep their own frames. See [`tangent`](super::tangent).
    Setup,
}

/// Pipelines that are settings of the emboss unit.
pub const EMBOSS_PIPELINES: [&str; 2] = ["emboss-gx", "emboss-nv"];

/// Units behind the emboss unit.
const EMBOSS_BEHIND: [&str; 2] = ["sampler", "combine"];

/// Unit parameters that the pipeline's name and the scene determine.
const EMBOSS_FROM_SCENE: &[&str] = &[
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

/// Pipelines that are settings of the tangent-space setup.
pub const TANGENT_PIPELINES: [&str; 2] = ["tangent-smooth", "tangent-faceted"];

/// Units before a pipeline with [`Frames::Setup`].
const TANGENT_BEFORE: [&str; 1] = ["tangent"];

/// Unit parameters that the pipeline's name and the scene determine.
const TANGENT_FROM_SCENE: &[&str] = &["frame", "lights"];

/// Sets a part of the reflection formula in every material of a scene, for the golden and for
/// pipelines alike.
///
/// # Panics
/// If the value has the wrong kind: a bug of the caller.
pub fn set_material(scene: &mut Scene, part: Reflection, value: &Value) {
    for material in &mut scene.materials {
        match (part, value) {
            (Reflection::Ambient, Value::Real(number)) => material.ambient = number.get(),
            (Reflection::Diffuse, Value::Real(number)) => material.diffuse = number.get(),
            (Reflection::Specular, Value::Real(number)) => material.specular = number.get(),
            (Reflection::Exponent, Value::Int(number)) => {
                material.exponent = u32::try_from(*number).expect("bug: a legal exponent");
            }
            _ => panic!("bug: {part:?} is not {value}"),
        }
    }
}

/// The units that are pipelines.
pub(crate) fn pipeline_units() -> impl Iterator<Item = &'static Unit> {
    units::all().filter(|unit| unit.shades == Shading::Pipeline)
}

/// Names of the pipelines that a unit implements.
fn pipelines_of(unit: &Unit) -> Vec<&str> {
    let choices = unit.params.iter().find(|param| param.role == Role::Pipeline);
    match choices.map(|param| &param.kind) {
        Some(Kind::Choice(names)) => names.iter().map(|name| &**name).collect(),
        Some(Kind::Int { .. } | Kind::Real { .. }) | None => vec![&unit.name],
    }
}

/// True if a parameter of a unit comes from a scene's material and lights.
fn is_of_material(unit: &Unit, key: &str) -> bool {
    unit.find_param(key).is_some_and(|param| matches!(param.role, Role::Material(_)))
}

/// True if an assignment is to a parameter of the unit.
pub(super) fn knows(unit: &Unit, set: &str) -> bool {
    let key = set.split_once('=').map_or("", |(key, _)| key);
    unit.find_param(key).is_some()
}

impl Pipeline {
    /// Names of all bump-mapping pipelines.
    #[must_use]
    pub fn names() -> Vec<&'static str> {
        pipeline_units().flat_map(pipelines_of).collect()
    }

    /// The pipeline with this name.
    ///
    /// # Errors
    /// If there is none.
    ///
    /// # Panics
    /// Never: each name belongs to a unit.
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

    fn with(name: &str, unit: &Unit, assignments: Vec<String>) -> Self {
        Self { name: name.to_owned(), unit: unit.clone(), assignments, frames: Frames::Float }
    }

    /// True for emboss pipelines, which have their own golden.
    #[must_use]
    pub fn is_emboss(&self) -> bool {
        EMBOSS_PIPELINES.contains(&self.name.as_str())
    }

    /// True if it sets up triangles and lights in texture space.
    #[must_use]
    pub fn is_tangent(&self) -> bool {
        TANGENT_PIPELINES.contains(&self.name.as_str())
    }

    /// False if it doesn't use vertex normals, so that triangle normals suffice where a mesh has
    /// none.
    #[must_use]
    pub fn takes_normals(&self) -> bool {
        self.name != "tangent-faceted"
    }

    /// Its assignments, without the parameter that selects one of the unit's pipelines.
    pub(crate) fn given(&self) -> impl Iterator<Item = &String> {
        self.assignments.iter().filter(|set| !self.names_it(set))
    }

    /// True if an assignment selects one of the unit's pipelines.
    fn names_it(&self, set: &str) -> bool {
        let param = set.split_once('=').and_then(|(key, _)| self.unit.find_param(key));
        param.is_some_and(|param| param.role == Role::Pipeline)
    }

    /// The parameters of all its units.
    pub fn params(&self) -> impl Iterator<Item = &Param> {
        let beside: &[&str] = match self.frames {
            _ if self.is_emboss() => &EMBOSS_BEHIND,
            Frames::Float => &[],
            Frames::Setup => &TANGENT_BEFORE,
        };
        let beside = beside.iter().flat_map(|name| built_in(name).all_params());
        self.unit.all_params().chain(beside)
    }

    /// A unit with parameters, under its own name; parameters that the scene determines are left
    /// out.
    #[must_use]
    pub fn of_unit(name: &str, unit: &Unit, assignments: &[String]) -> Self {
        let from_scene =
            |set: &&String| set.split_once('=').is_some_and(|(key, _)| is_of_material(unit, key));
        let assignments = assignments.iter().filter(|set| !from_scene(set)).cloned().collect();
        Self::with(name, unit, assignments)
    }

    /// The pipeline of all parameters of a unit, except material parameters.
    #[must_use]
    pub fn of_values(values: &Values) -> Self {
        let given = values.params().filter(|(p, _)| !matches!(p.role, Role::Material(_)));
        let assignments = given.map(|(param, value)| format!("{}={value}", param.name)).collect();
        Self::with(&values.unit().name, values.unit(), assignments)
    }

    /// Sets parameters in all pipelines that have them.
    ///
    /// # Errors
    /// If no pipeline has a parameter, or the scene determines it.
    pub fn set(pipelines: &mut [Self], assignments: &[String]) -> Result<()> {
        for assignment in assignments {
            let (key, _) =
                assignment.split_once('=').ok_or_else(|| Error::form(assignment, "key=value"))?;
            if pipelines.iter().any(|pipeline| is_of_material(&pipeline.unit, key)) {
                let text =
                    format!("parameter `{key}` comes from the scene's [material] and lights");
                return Err(Error::usage(text));
            }
            if EMBOSS_FROM_SCENE.contains(&key) && pipelines.iter().any(Self::is_emboss) {
                let text = format!(
                    "parameter `{key}` comes from the name of the emboss pipeline, or the scene's [emboss], lights and height map"
                );
                return Err(Error::usage(text));
            }
            if TANGENT_FROM_SCENE.contains(&key) && pipelines.iter().any(Self::is_tangent) {
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
                    nearest(key, all.map(|param| param.name.as_str()))
                )));
            }
        }
        Ok(())
    }

    /// Its design for a material and a light; `ambient` is the ambient part that the light
    /// includes.
    ///
    /// # Errors
    /// If the parameters are incompatible.
    pub fn design(&self, ambient: f64, light: &Light, material: &Material) -> Result<Design> {
        // The other assignments are for the setup of the frames.
        let mut assignments = match self.frames {
            Frames::Float => self.assignments.clone(),
            Frames::Setup => {
                let known = |set: &&String| knows(&self.unit, set);
                self.assignments.iter().filter(known).cloned().collect()
            }
        };
        if light.intensity * material.specular > 0.0
            && assignments.iter().any(|set| set == "highlight=off")
        {
            let text = "highlight=off leaves out specular light that the scene has: set specular = 0 in its [material]";
            return Err(Error::usage(text.to_owned()));
        }
        for param in &self.unit.params {
            let Role::Material(part) = param.role else { continue };
            let value = match part {
                Reflection::Ambient => ambient,
                Reflection::Diffuse => light.intensity * material.diffuse,
                Reflection::Specular => light.intensity * material.specular,
                Reflection::Exponent => f64::from(material.exponent),
            };
            // A product of numbers of at most 1 can exceed the limit by an ulp.
            let legal = match param.kind {
                Kind::Real { min, max } => value.clamp(min, max),
                Kind::Int { .. } | Kind::Choice(_) => value,
            };
            assignments.push(format!("{}={legal}", param.name));
        }
        self.unit.values(&assignments)?.build()
    }
}

/// The error for emboss pipelines mixed with others.
pub(crate) fn mixed() -> Error {
    let text = "emboss pipelines have their own golden: render them separately from the others, into another folder";
    Error::usage(text.to_owned())
}
