//! Emboss pipelines on a scene, one parameter at a time: how much accuracy a picture and its
//! displacements lose with narrower words, smaller tables of the reciprocal root, and coarser
//! fractions between texels.

use super::with;
use crate::base::columns::{self, Field};
use crate::base::error::{Error, Result};
use crate::base::escape;
use crate::base::json;
use crate::base::output;
use crate::netlist::Counts;
use crate::report::Table;
use crate::report::ladder::refusals;
use crate::report::record::{Parameters, SceneId, assigned};
use crate::shading::picture::{Difference, coverage};
use crate::shading::render::{Pipeline, Rendered, Shot, check_view, render, shots_together};
use crate::shading::scene::Scene;
use serde::Serialize;
use std::path::Path;

/// Default widths of vectors and of the matrix.
pub const WIDTHS: [u32; 5] = [8, 10, 12, 14, 16];
/// Parameters that take a rung's width.
const WIDE: [&str; 2] = ["component_bits", "matrix_bits"];
/// Legal widths.
pub const LEGAL_WIDTHS: std::ops::RangeInclusive<u32> = 4..=24;

/// A pipeline with some parameters, and its outcome.
#[derive(Clone, Debug, Serialize)]
pub struct Rung {
    /// The pipeline.
    pub pipeline: String,
    /// How it differs from the common parameters.
    pub setting: String,
    /// The same, by name.
    pub parameters: Parameters,
    /// Figures, or the reason why there are none.
    #[serde(flatten)]
    pub outcome: Outcome,
}

impl Rung {
    /// The reason why it has no figures.
    fn refused(&self) -> Option<&str> {
        match &self.outcome {
            Outcome::Measured(_) => None,
            Outcome::Error(why) => Some(why),
        }
    }
}

/// Figures of a rung, or the reason why there are none.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Outcome {
    /// Figures.
    Measured(Box<Figures>),
    /// The reason why it can't be built.
    Error(String),
}

/// Figures of a picture, differences in linear light.
#[derive(Clone, Debug, Serialize)]
pub struct Figures {
    /// The differences from the golden: largest, mean, SSIM and FLIP.
    pub difference: Difference,
    /// Bound on the largest difference.
    pub bound: Option<f64>,
    /// The largest error of a displaced coordinate of any vertex, in texels.
    pub displacement_max_texels: f64,
    /// Total multipliers of its units.
    pub multipliers: u64,
    /// Total bits of their tables.
    pub rom_bits: u64,
}

/// A ladder's result.
#[derive(Clone, Debug, Serialize)]
pub struct Record {
    /// Version of this crate.
    pub crate_version: String,
    /// The scene.
    pub scene: SceneId,
    /// Pixels that see an object.
    pub covered_px: u64,
    /// Other pixels.
    pub background_px: u64,
    /// Parameters that were set, which every rung has.
    pub given: Vec<String>,
    /// All rungs.
    pub rungs: Vec<Rung>,
}

/// Settings of the rungs, each a list of parameters.
fn settings(widths: &[u32]) -> Vec<Vec<(&'static str, String)>> {
    let mut all = vec![Vec::new()];
    all.extend(widths.iter().map(|width| WIDE.map(|key| (key, width.to_string())).to_vec()));
    for scheme in ["direct", "linear", "newton"] {
        all.extend([2, 3, 4, 5, 6, 8, 10].map(|bits: u32| {
            vec![("root_scheme", scheme.to_owned()), ("root_addr_bits", bits.to_string())]
        }));
    }
    let one = |key: &'static str, values: &[u32]| -> Vec<Vec<(&'static str, String)>> {
        values.iter().map(|value| vec![(key, value.to_string())]).collect()
    };
    all.extend(one("fraction_bits", &[1, 2, 3, 4, 5, 6, 8, 10, 12]));
    all.extend(one("texture_frac_bits", &[6, 8, 10, 12, 14, 18]));
    all.extend(one("position_frac_bits", &[4, 6, 8, 10, 12, 15]));
    all.push(vec![("input20", "on".to_owned())]);
    all
}

/// Number of pictures.
#[must_use]
pub fn pictures(pipelines: &[Pipeline], widths: &[u32]) -> usize {
    pipelines.len() * settings(widths).len()
}

/// Renders all rungs; `progress` receives the number of pictures done.
///
/// # Errors
/// If the scene can't be embossed, nothing is in view, every rung fails, or `pixels_per_degree` is
/// outside FLIP's range (1 to 1000).
pub fn climb(
    scene: &Scene,
    name: &str,
    pipelines: &[Pipeline],
    widths: &[u32],
    pixels_per_degree: f64,
    progress: &dyn Fn(usize),
) -> Result<Record> {
    check_view(scene)?;
    let mut wanted = Vec::new();
    for pipeline in pipelines {
        for setting in settings(widths) {
            let pairs: Vec<String> =
                setting.iter().map(|(key, value)| format!("{key}={value}")).collect();
            wanted.push((with(pipeline, &[], &setting), pairs.join(" ")));
        }
    }
    let mut rungs = Vec::new();
    for group in wanted.chunks(shots_together(scene)) {
        let pipelines: Vec<Pipeline> = group.iter().map(|(pipeline, _)| pipeline.clone()).collect();
        // If one pipeline can't be built, render each on its own.
        let outcomes = match render(scene, &pipelines, false, &|_| ()) {
            Ok(rendered) => {
                let of = |shot| measured(&rendered, shot, pixels_per_degree).map(Ok);
                rendered.shots.iter().map(of).collect::<Result<Vec<_>>>()?
            }
            Err(_) => {
                let alone = |pipeline: &Pipeline| {
                    let rendered = render(scene, std::slice::from_ref(pipeline), false, &|_| ());
                    match rendered {
                        Ok(rendered) => {
                            measured(&rendered, &rendered.shots[0], pixels_per_degree).map(Ok)
                        }
                        Err(why) => Ok(Err(why)),
                    }
                };
                pipelines.iter().map(alone).collect::<Result<Vec<_>>>()?
            }
        };
        for ((pipeline, setting), outcome) in group.iter().zip(outcomes) {
            rungs.push(Rung {
                pipeline: pipeline.name.clone(),
                parameters: assigned(
                    &setting.split_whitespace().map(str::to_owned).collect::<Vec<_>>(),
                ),
                setting: if setting.is_empty() { "defaults".to_owned() } else { setting.clone() },
                outcome: match outcome {
                    Ok(figures) => Outcome::Measured(Box::new(figures)),
                    Err(why) => Outcome::Error(why.to_string()),
                },
            });
        }
        progress(rungs.len());
    }
    if let Some(first) = rungs.iter().find_map(Rung::refused)
        && rungs.iter().all(|rung| rung.refused().is_some())
    {
        return Err(Error::usage(format!("every rung failed, the first because {first}")));
    }
    let difference = rungs.iter().find_map(|rung| match &rung.outcome {
        Outcome::Measured(figures) => Some(&figures.difference),
        Outcome::Error(_) => None,
    });
    let mut given: Vec<String> = Vec::new();
    for parameter in pipelines.iter().flat_map(Pipeline::given) {
        if !given.contains(parameter) {
            given.push(parameter.clone());
        }
    }
    Ok(Record {
        covered_px: difference.map_or(0, |difference| difference.covered_px),
        background_px: difference.map_or(0, |difference| difference.background_px),
        crate_version: env!("CARGO_PKG_VERSION").to_owned(),
        scene: SceneId::new(name, scene),
        given,
        rungs,
    })
}

/// Figures of a picture.
fn measured(rendered: &Rendered, shot: &Shot, pixels_per_degree: f64) -> Result<Figures> {
    let golden = rendered.golden_of(shot);
    let counts = || {
        let designs = shot.behind.iter().chain([&shot.design]);
        designs.map(|design| design.netlist.counts())
    };
    let multipliers = |counts: Counts| {
        counts.datapath.multipliers + counts.schemes.multipliers + counts.parts.multipliers
    };
    let known = shot.emboss.expect("bug: an emboss knows that");
    Ok(Figures {
        difference: rendered.difference(&shot.picture, golden, pixels_per_degree)?,
        bound: known.bound,
        displacement_max_texels: known.displacement_max_texels,
        multipliers: counts().map(multipliers).sum(),
        rom_bits: counts().map(|counts| counts.rom_bits).sum(),
    })
}

/// Names of all files that [`Record::write`] writes.
pub const FILES: [&str; 3] = ["ladder.json", "ladder.csv", "ladder.md"];

/// Figures of a rung in columns; differences are in linear light, 0 to 1.
pub const COLUMNS: [&str; 12] = [
    "picture_covered_px",
    "picture_background_px",
    "picture_max_abs",
    "picture_bound_abs",
    "picture_mean_abs",
    "picture_ssim",
    "picture_flip",
    "picture_srgb8_differing",
    "displacement_max_texels",
    "multipliers",
    "rom_bits",
    "error",
];

impl Record {
    /// True unless a picture differs from the golden by more than its bound.
    #[must_use]
    pub fn bounds_hold(&self) -> bool {
        self.rungs.iter().all(|rung| match &rung.outcome {
            Outcome::Measured(of) => {
                of.bound.is_none_or(|bound| of.difference.max.difference <= bound) // false for NaN
            }
            Outcome::Error(_) => true,
        })
    }

    /// The rungs; differences are in 1/255.
    #[must_use]
    pub fn table(&self) -> Table {
        let mut headings = vec![
            "pipeline",
            "what differs",
            ">max/255",
            ">bound/255",
            ">mean/255",
            ">FLIP",
            ">displacement max, texels",
            ">multipliers",
            ">ROM bits",
        ];
        let row = |rung: &Rung| {
            let mut row = vec![rung.pipeline.clone(), rung.setting.clone()];
            if let Outcome::Measured(of) = &rung.outcome {
                row.extend([
                    format!("{:.3}", of.difference.max.difference * 255.0),
                    of.bound.map(|bound| format!("{:.3}", bound * 255.0)).unwrap_or_default(),
                    format!("{:.4}", of.difference.mean * 255.0),
                    format!("{:.4}", of.difference.flip),
                    format!("{:.1e}", of.displacement_max_texels),
                    of.multipliers.to_string(),
                    of.rom_bits.to_string(),
                ]);
            }
            row
        };
        let mut rows: Vec<Vec<String>> = self.rungs.iter().map(row).collect();
        refusals(&mut headings, &mut rows, self.rungs.iter().map(Rung::refused));
        Table::new(&headings, rows)
    }

    /// As JSON.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        json::document("emboss-ladder", self)
    }

    /// Writes `ladder.json`, `ladder.csv` and `ladder.md` into a folder.
    ///
    /// # Errors
    /// If a file can't be written.
    pub fn write(&self, folder: &Path) -> Result<()> {
        output::make_folder(folder)?;
        output::write_text(&folder.join("ladder.json"), &json::text(&self.json()))?;
        let names = ["pipeline", "setting"].iter().chain(&COLUMNS);
        let heading: Vec<String> = names.map(|name| (*name).to_owned()).collect();
        let rows = self.rungs.iter().map(|rung| {
            let mut fields: Vec<Field> =
                vec![rung.pipeline.as_str().into(), rung.setting.as_str().into()];
            match &rung.outcome {
                Outcome::Measured(of) => fields.extend([
                    of.difference.covered_px.into(),
                    of.difference.background_px.into(),
                    of.difference.max.difference.into(),
                    of.bound.into(),
                    of.difference.mean.into(),
                    of.difference.ssim.into(),
                    of.difference.flip.into(),
                    of.difference.srgb8_differing.into(),
                    of.displacement_max_texels.into(),
                    of.multipliers.into(),
                    of.rom_bits.into(),
                    Field::Missing,
                ]),
                Outcome::Error(why) => {
                    fields.extend([const { Field::Missing }; COLUMNS.len() - 1]);
                    fields.push(why.as_str().into());
                }
            }
            fields
        });
        let csv = folder.join("ladder.csv");
        output::write_file(&csv, |to| columns::write(to, &csv, &heading, rows))?;
        let mut told = format!(
            "# Emboss of scene {}, one parameter at a time\n\nEvery rung has the defaults{} except for what it names. Differences are from the \
             golden picture, in linear light; *displacement* is the largest error of a displaced texture coordinate of \
             any vertex under any light, in texels. {}.\n\n",
            escape::markdown(&self.scene.to_string()),
            if self.given.is_empty() {
                String::new()
            } else {
                format!(" with {}", escape::markdown(&self.given.join(" ")))
            },
            coverage(self.covered_px, self.background_px),
        );
        for note in &self.scene.notes {
            told.push_str(&format!("Note: {}.\n\n", escape::markdown(note)));
        }
        told.push_str(&self.table().markdown());
        output::write_text(&folder.join("ladder.md"), &told)
    }
}
