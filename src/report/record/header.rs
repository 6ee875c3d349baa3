//! What was swept, and over which inputs.

use super::parameters::{Parameters, plain};
use super::rank::RankBy;
use crate::shading::scene::Scene;
use serde::{Deserialize, Serialize};
use std::fmt;

/// Version of the format of `sweep.json`.
pub const FORMAT_VERSION: u32 = 2;

/// One swept parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// The parameter.
    pub key: String,
    /// Its values.
    pub values: Vec<serde_json::Value>,
}

/// What was swept, and over which inputs. It must be equal for a sweep to resume.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// [`FORMAT_VERSION`] of the file.
    pub format_version: u32,
    /// Version of this crate.
    pub crate_version: String,
    /// Name of the unit.
    pub unit: String,
    /// Parameters that are not swept.
    pub base: Parameters,
    /// Swept parameters; the last one runs fastest.
    pub axes: Vec<Axis>,
    /// Name of the sampler.
    pub sampler: String,
    /// Number of samples requested, for the random samplers.
    pub samples: u64,
    /// Seed of the random samplers.
    pub seed: u64,
    /// The scene that was rendered, if it gave the inputs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene: Option<SceneId>,
    /// The figure that ranks points over a scene; points record all of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error: Option<RankBy>,
}

/// The identity of a scene.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SceneId {
    /// Its name, or that of its file.
    pub name: String,
    /// Its fingerprint, in hexadecimal digits.
    pub fingerprint: String,
    /// Columns of its image.
    pub width_px: u32,
    /// Rows.
    pub height_px: u32,
    /// How it deviates from its files, or that it stands still.
    #[serde(default)]
    pub notes: Vec<String>,
}

impl SceneId {
    /// The identity of a scene.
    #[must_use]
    pub fn new(name: &str, scene: &Scene) -> Self {
        Self {
            name: name.to_owned(),
            fingerprint: format!("{:016x}", scene.fingerprint()),
            width_px: scene.image.width,
            height_px: scene.image.height,
            notes: scene.notes_at_start(),
        }
    }
}

impl fmt::Display for SceneId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, fingerprint, width_px, height_px, notes: _ } = self;
        write!(f, "{name} ({width_px} x {height_px} px, fingerprint {fingerprint})")
    }
}

impl Header {
    /// Where this header (of a file) differs from the requested one, in words.
    #[must_use]
    pub fn differences(&self, asked: &Self) -> Vec<String> {
        let mut found = Vec::new();
        let mut compare = |what: &str, there: String, here: String| {
            if there != here {
                found.push(format!("{what} is {there} there and {here} here"));
            }
        };
        let (there, here) = (self, asked);
        compare("format", there.format_version.to_string(), here.format_version.to_string());
        compare("version", there.crate_version.clone(), here.crate_version.clone());
        compare("unit", there.unit.clone(), here.unit.clone());
        compare("sampler", there.sampler.clone(), here.sampler.clone());
        compare("samples", there.samples.to_string(), here.samples.to_string());
        compare("seed", there.seed.to_string(), here.seed.to_string());
        let scene = |header: &Self| header.scene.as_ref().map(ToString::to_string);
        if let (Some(there), Some(here)) = (scene(there), scene(here)) {
            compare("scene", there, here);
        }
        let axis = |axis: &Axis| {
            let values: Vec<String> = axis.values.iter().map(plain).collect();
            format!("{}={}", axis.key, values.join(","))
        };
        let axes = |header: &Self| match header.axes.iter().map(axis).collect::<Vec<_>>() {
            axes if axes.is_empty() => "no axis".to_owned(),
            axes => axes.join(" "),
        };
        compare("the grid", axes(there), axes(here));
        // A parameter that is swept on one side is covered by the comparison of grids.
        for (name, value) in &there.base {
            if let Some(other) = here.base.get(name) {
                compare(name, plain(value), plain(other));
            }
        }
        if found.is_empty() && there != here {
            found.push("the set of parameters differs".to_owned());
        }
        found
    }
}
