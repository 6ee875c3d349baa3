//! Whole pipelines on a scene over a ladder of widths, and their light tables over exponents: a
//! picture's error against its cost in tables, multipliers, cycles and simulation time.
//!
//! On a rung, all widths of a pipeline grow together, as [`RUNG`] defines. Separately, the light
//! tables are judged over exponents of the highlight, with all other parameters so fine that only
//! the light tables matter: this shows how their error grows, and which scheme helps.

pub mod emboss;

use crate::base::error::{Error, Result};
use crate::design::{Reflection, Value};
use crate::report;
use crate::report::ladder::{Header, LightPoint, Record, Rung};
use crate::report::record::{Point, SceneId, assigned, parameters_of};
use crate::shading::render::{Pipeline, Shader, check_view, set_material, shots_together};
use crate::shading::scene::Scene;
use crate::table::Scheme;
use rayon::prelude::*;

/// Default widths of the rungs.
pub const WIDTHS: [u32; 5] = [8, 10, 12, 14, 16];
/// The narrowest and the widest legal rung, as tables allow.
pub const LEGAL_WIDTHS: std::ops::RangeInclusive<u32> = 4..=22;
/// Default exponents of the highlight.
pub const EXPONENTS: [u32; 5] = [1, 8, 32, 128, 255];
/// Exponents that a material can have.
pub const LEGAL_EXPONENTS: std::ops::RangeInclusive<u32> = 0..=255;

/// Parameters of a rung, with the amount to subtract from its width. A pipeline skips those that
/// its unit lacks, and keeps those that were set.
pub const RUNG: [(&str, u32); 6] = [
    ("angle_bits", 0),
    ("frac_bits", 0),
    ("light_bits", 0),
    ("table_addr_bits", 2),
    ("diffuse_addr_bits", 2),
    ("specular_addr_bits", 2),
];

/// The preferred pipeline for judging light tables: its dot products address them directly.
const LIGHT_PIPELINE: &str = "exact-cartesian";
/// Its other parameters, so fine that the light tables dominate the error.
const FINE: [(&str, &str); 5] = [
    ("angle_bits", "18"),
    ("frac_bits", "18"),
    ("light_bits", "16"),
    ("scheme", "linear"),
    ("table_addr_bits", "12"),
];
/// Address bits of the light tables.
const LIGHT_ADDR_BITS: [u32; 3] = [8, 10, 12];
/// Largest total of table bits of pictures rendered together: the tables are compiled into memory.
const TOGETHER_ROM_BITS: u64 = 1 << 28;

/// What to measure.
#[derive(Clone, Debug)]
pub struct Ladder {
    /// Pipelines, with parameters that stay the same on every rung.
    pub pipelines: Vec<Pipeline>,
    /// Widths of the rungs.
    pub widths: Vec<u32>,
    /// Exponents at which the light tables are judged.
    pub exponents: Vec<u32>,
    /// Pixels per degree of visual angle, for FLIP.
    pub pixels_per_degree: f64,
}

/// A pipeline with more parameters: `weak` ones don't override its own, `strong` ones do. Both are
/// added only if its unit has them.
fn with(pipeline: &Pipeline, weak: &[(&str, String)], strong: &[(&str, String)]) -> Pipeline {
    let mut new = pipeline.clone();
    let has = |key: &str| pipeline.params().any(|param| param.name == key);
    let key_of = |assignment: &String| assignment.split_once('=').map(|(key, _)| key.to_owned());
    new.assignments.retain(|assignment| {
        strong.iter().all(|(key, _)| key_of(assignment).is_none_or(|known| known != *key))
    });
    for (key, value) in strong.iter().chain(weak) {
        if has(key) && new.assignments.iter().filter_map(key_of).all(|known| known != *key) {
            new.assignments.push(format!("{key}={value}"));
        }
    }
    new
}

/// The point of a rung that can't be built.
fn failed(pipeline: &Pipeline, why: &Error) -> Point {
    Point {
        parameters: assigned(&pipeline.assignments),
        error: Some(why.to_string()),
        measured: None,
    }
}

impl Ladder {
    /// Number of pictures.
    #[must_use]
    pub fn pictures(&self, scene: &Scene) -> usize {
        let lights = self
            .light_pipeline(scene)
            .map_or(0, |_| self.exponents.len() * Scheme::ALL.len() * LIGHT_ADDR_BITS.len());
        self.pipelines.len() * self.widths.len() + lights
    }

    /// The pipeline in which the light tables are judged; `None` if no pipeline has light tables,
    /// or the scene has no highlight.
    fn light_pipeline(&self, scene: &Scene) -> Option<&Pipeline> {
        let has = |pipeline: &&Pipeline, key: &str| {
            pipeline.unit.all_params().any(|param| param.name == key)
        };
        let with_light_tables =
            |p: &&Pipeline| has(p, "light_scheme") && has(p, "specular_addr_bits");
        if !scene.facts().specular {
            return None;
        }
        let mut able = self.pipelines.iter().filter(with_light_tables);
        let best = able.clone().find(|pipeline| pipeline.name == LIGHT_PIPELINE);
        best.or_else(|| able.next())
    }

    /// Renders everything; `progress` receives the number of pictures done.
    ///
    /// # Errors
    /// If nothing is in view, every rung fails, or `pixels_per_degree` is outside FLIP's range (1
    /// to 1000).
    pub fn climb(
        &self,
        scene: &Scene,
        name: &str,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Record> {
        let mut rungs = Vec::new();
        for pipeline in &self.pipelines {
            for width_bits in &self.widths {
                let of =
                    |(key, less): &(&'static str, u32)| (*key, (width_bits - less).to_string());
                rungs.push((
                    *width_bits,
                    with(pipeline, &RUNG.iter().map(of).collect::<Vec<_>>(), &[]),
                ));
            }
        }
        let pipelines: Vec<Pipeline> = rungs.iter().map(|(_, pipeline)| pipeline.clone()).collect();
        check_view(scene)?;
        let points = self.points(scene, &pipelines, progress)?;
        let picture = points.iter().find_map(|point| point.measured.as_ref()?.picture);
        if let Some(first) = points.iter().find_map(|point| point.error.as_deref())
            && points.iter().all(|point| point.measured.is_none())
        {
            return Err(Error::usage(format!("every rung failed, the first because {first}")));
        }
        let rungs = rungs.into_iter().zip(points).map(|((width_bits, pipeline), point)| Rung {
            pipeline: pipeline.name,
            unit: pipeline.unit.name.to_owned(),
            width_bits,
            point,
        });
        let rungs: Vec<Rung> = rungs.collect();
        let light_pipeline = self.light_pipeline(scene);
        let lights = match light_pipeline {
            Some(pipeline) => self.lights(scene, pipeline, &|done| progress(rungs.len() + done))?,
            None => Vec::new(),
        };
        let header = Header {
            crate_version: env!("CARGO_PKG_VERSION").to_owned(),
            scene: SceneId::new(name, scene),
            covered_px: picture.map_or(0, |picture| picture.covered_px),
            background_px: picture.map_or(0, |picture| picture.background_px),
            lights: scene.lights.len(),
            pixels_per_degree: self.pixels_per_degree,
            rung: RUNG.map(|(key, less)| (key.to_owned(), less)).to_vec(),
            widths_bits: self.widths.clone(),
            light_pipeline: light_pipeline.map(|pipeline| pipeline.name.clone()),
            light_parameters: FINE.map(|(key, value)| format!("{key}={value}")).to_vec(),
        };
        Ok(Record { header, rungs, exponents: lights })
    }

    /// The light tables over exponents.
    fn lights(
        &self,
        scene: &Scene,
        pipeline: &Pipeline,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Vec<LightPoint>> {
        let fine = FINE.map(|(key, value)| (key, value.to_owned()));
        let mut settings = Vec::new();
        for scheme in Scheme::ALL.iter().map(|scheme| scheme.name()) {
            for addr_bits in LIGHT_ADDR_BITS {
                let tables = [
                    ("light_scheme", scheme.to_owned()),
                    ("diffuse_addr_bits", addr_bits.to_string()),
                    ("specular_addr_bits", addr_bits.to_string()),
                ];
                settings.push((scheme, addr_bits, with(pipeline, &fine, &tables)));
            }
        }
        let pipelines: Vec<Pipeline> = settings.iter().map(|(.., p)| p.clone()).collect();
        let mut scene = scene.clone();
        let mut all = Vec::new();
        for exponent in &self.exponents {
            set_material(&mut scene, Reflection::Exponent, &Value::Int((*exponent).into()));
            let before = all.len();
            let points = self.points(&scene, &pipelines, &|done| progress(before + done))?;
            all.extend(settings.iter().zip(points).map(|((scheme, addr_bits, _), point)| {
                LightPoint {
                    exponent: *exponent,
                    scheme: (*scheme).to_owned(),
                    addr_bits: *addr_bits,
                    point,
                }
            }));
        }
        Ok(all)
    }

    /// Pictures of a scene, in groups that share one golden and are as large as there is room for.
    fn points(
        &self,
        scene: &Scene,
        pipelines: &[Pipeline],
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Vec<Point>> {
        let mut points: Vec<Option<Point>> = vec![None; pipelines.len()];
        let mut group: Vec<(usize, Shader)> = Vec::new();
        let (mut rom_bits, mut done) = (0, 0);
        let build = |pipeline: &Pipeline| {
            let shader = Shader::new(scene, pipeline, true)?;
            shader.design().rtl()?;
            Ok(shader)
        };
        let together = shots_together(scene);
        let mut next = 0;
        while next < pipelines.len() {
            // Building tables takes time: build one pipeline per thread, and at most as many as are
            // rendered together.
            let some = rayon::current_num_threads().min(together).min(pipelines.len() - next);
            let built: Vec<Result<Shader>> =
                pipelines[next..next + some].par_iter().map(build).collect();
            for (index, built) in (next..).zip(built) {
                match built {
                    Ok(shader) => {
                        rom_bits += shader.design().netlist.counts().rom_bits;
                        group.push((index, shader));
                    }
                    Err(why) => {
                        points[index] = Some(failed(&pipelines[index], &why));
                        done += 1;
                    }
                }
            }
            next += some;
            let full = group.len() + some > together || rom_bits > TOGETHER_ROM_BITS;
            if full || next == pipelines.len() {
                let shaders: Vec<&Shader> = group.iter().map(|(_, shader)| shader).collect();
                let shots = report::shots(scene, &shaders, self.pixels_per_degree, &|_| ())?;
                for ((index, shader), measured) in group.iter().zip(shots) {
                    let parameters = parameters_of(&shader.design().values);
                    points[*index] =
                        Some(Point { parameters, error: None, measured: Some(measured) });
                }
                done += group.len();
                progress(done);
                group.clear();
                rom_bits = 0;
            }
        }
        Ok(points.into_iter().flatten().collect())
    }
}
