//! Sweeps: a unit measured over a grid of parameters.
//!
//! Points are measured in groups that share their inputs and golden values. A group's designs are
//! dropped before the next group is built, so memory grows with the grid only by the points'
//! figures. Finished points are saved on disk, so a sweep that was stopped resumes. Each point's
//! figures are the same as if it were measured alone.
//!
//! A sweep can take its inputs from a scene: a point is then a picture, and its error is the
//! difference from the golden picture. Material parameters come from the scene. Those that are set
//! explicitly replace the scene's, in the pipeline and the golden alike.

pub mod compare;
pub mod ladder;

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::output::{self, Set};
use crate::base::whole;
use crate::design::{Design, Kind, Param, Reflection, Role, Sampler, Shading, Unit, Value, Values};
use crate::measure::{self, Inputs};
use crate::report;
use crate::report::record::{self, Header, Measured, Point, RankBy, Record, SceneId};
use crate::shading::picture::PIXELS_PER_DEGREE;
use crate::shading::render::{
    EMBOSS_PIPELINES, Pipeline, Shader, TANGENT_PIPELINES, check_view, pipeline_units,
    set_material, shots_together,
};
use crate::shading::scene::Scene;
use std::collections::HashMap;
use std::fs;
use std::io;
use std::path::Path;
use std::time::{Duration, Instant};

/// Largest number of points of a grid.
const MAX_POINTS: usize = 100_000;
/// Largest number of points measured together.
const GROUP_POINTS: usize = 16;
/// Largest total of samples of a group: a few seconds' work.
const GROUP_SAMPLES: u64 = 1 << 25;
/// Largest total of table bits of a group: large tables are compiled into memory.
const GROUP_ROM_BITS: u64 = 1 << 28;

/// A swept parameter, format of a node or scheme of a table, and its values.
#[derive(Clone, Debug)]
pub struct Axis {
    unit: Unit,
    key: String,
    values: Vec<Value>,
}

impl Axis {
    /// Parses `key=v,v,…`, where each `v` is a value or a range `a..b` or `a..b:step` that includes
    /// `b` if the steps meet it. Formats of nodes and schemes of tables have the keys that
    /// [`Values::set`] accepts; a point whose datapath has no such node or table fails.
    ///
    /// # Errors
    /// If the unit has no such parameter, a value is not legal or comes twice, there is none, or a
    /// range runs backwards or has a step of 0.
    pub fn parse(text: &str, unit: &Unit) -> Result<Self> {
        let (key, list) = text
            .split_once('=')
            .ok_or_else(|| Error::form(text, "key=v,v,… or key=a..b or key=a..b:step"))?;
        let key = key.trim();
        let mut values = Vec::new();
        for item in list.split(',').map(str::trim) {
            if item.is_empty() {
                return Err(Error::usage(format!(
                    "axis `{text}` has an empty value: write {key}=v,v,… or {key}=a..b"
                )));
            }
            match item.split_once("..") {
                Some((from, rest)) => values.extend(range(unit, key, item, from, rest)?),
                None => values.push(unit.value(key, item)?),
            }
            if values.len() > MAX_POINTS {
                return Err(too_many(&format!("axis `{text}` has more than {MAX_POINTS} values")));
            }
        }
        let mut sorted: Vec<_> = values.iter().collect();
        sorted.sort_unstable();
        match sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            Some(pair) => {
                Err(Error::usage(format!("axis `{text}` has the value {} twice", pair[0])))
            }
            None => Ok(Self { unit: unit.clone(), key: key.to_owned(), values }),
        }
    }

    /// Name of the parameter, or key of the format or scheme.
    #[must_use]
    pub fn key(&self) -> &str {
        &self.key
    }

    /// Its values in the order given.
    #[must_use]
    pub fn values(&self) -> &[Value] {
        &self.values
    }
}

/// Values of a range; `rest` is what follows the dots.
fn range(unit: &Unit, key: &str, item: &str, from: &str, rest: &str) -> Result<Vec<Value>> {
    let (to, step) = match rest.split_once(':') {
        Some((to, step)) => (to, Some(step)),
        None => (rest, None),
    };
    let refused = |why: &str| Error::usage(format!("`{item}`: {why}: write {key}=v,v,…"));
    let numbers = || Error::usage(format!("`{item}`: a range of `{key}` needs numbers"));
    match unit.find_param(key).map(|param| &param.kind) {
        Some(Kind::Int { .. }) => {}
        Some(Kind::Real { .. }) => {
            return Err(refused(&format!("`{key}` is a real number and has no ranges")));
        }
        Some(Kind::Choice(_)) => {
            return Err(refused(&format!("`{key}` is a name and has no ranges")));
        }
        // A format or a scheme, or an unknown key, which its value reports.
        None => {
            unit.value(key, from.trim())?;
            return Err(refused(&format!("`{key}` has no ranges")));
        }
    }
    let Value::Int(from) = unit.value(key, from.trim())? else { return Err(numbers()) };
    let Value::Int(to) = unit.value(key, to.trim())? else { return Err(numbers()) };
    if from > to {
        return Err(Error::usage(format!("range `{item}` runs backwards: write {to}..{from}")));
    }
    let step = match step {
        None => 1,
        Some(text) => {
            let step = whole::parse(text.trim())
                .filter(|step| *step > 0)
                .and_then(|step| step.try_into().ok());
            step.ok_or_else(|| {
                Error::usage(format!(
                    "range `{item}` has the step `{text}`: a step is a whole number from 1"
                ))
            })?
        }
    };
    // One more than the limit is enough to be refused.
    Ok((from..=to).step_by(step).take(MAX_POINTS + 1).map(Value::Int).collect())
}

fn too_many(what: &str) -> Error {
    Error::usage(format!(
        "{what}: a sweep has at most {MAX_POINTS} points; use fewer values or a larger step"
    ))
}

/// Progress of a sweep.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Progress {
    /// Finished points, including failed ones and those from an earlier run.
    pub points_done: usize,
    /// Points of the grid.
    pub points: usize,
    /// Points now being measured together.
    pub running: usize,
    /// Number of samples, or rows of the picture, done for each of them.
    pub samples_done: u64,
}

/// A scene to sweep a unit over.
#[derive(Clone, Debug)]
pub struct View {
    /// The scene.
    pub scene: Scene,
    /// Its name in reports.
    pub name: String,
    /// The figure that ranks points.
    pub error: RankBy,
}

/// The remedy for a unit that a sweep can't measure over a scene.
fn instead_of_a_scene(unit: &Unit) -> String {
    let named = |names: [&str; 2]| format!("fixpath render SCENE --pipelines {}", names.join(","));
    match unit.name.as_str() {
        "emboss" => format!(
            "`{} --ladder` measures its widths, tables and fractions over a scene",
            named(EMBOSS_PIPELINES)
        ),
        "tangent" => format!(
            "`{} -p key=value` renders a scene with one setting of it",
            named(TANGENT_PIPELINES)
        ),
        _ => {
            let names: Vec<&str> = pipeline_units().map(|unit| unit.name.as_str()).collect();
            format!("leave --scene out, or use one of {}", names.join(", "))
        }
    }
}

/// Source of inputs.
#[derive(Clone, Debug)]
enum Source {
    Drawn(Inputs),
    Scene {
        view: Box<View>,
        id: SceneId,
        /// Material parameters that were set explicitly, so that they don't come from the scene.
        given: Vec<(String, Reflection)>,
    },
}

/// A unit, its parameters, and the grid to measure it over.
#[derive(Clone, Debug)]
pub struct Sweep {
    base: Values,
    axes: Vec<Axis>,
    source: Source,
}

impl Sweep {
    /// A sweep of `axes` around `base`; the last axis runs fastest.
    ///
    /// # Errors
    /// If a parameter has two axes or belongs to another unit, the grid is too large, or the number
    /// of samples is 0.
    pub fn new(base: Values, axes: Vec<Axis>, inputs: Inputs) -> Result<Self> {
        if inputs.samples == 0 && matches!(inputs.sampler, Sampler::Lit | Sampler::Sphere) {
            return Err(Error::usage("a sweep needs at least 1 sample".to_owned()));
        }
        Self::check(&base, &axes)?;
        Ok(Self { base, axes, source: Source::Drawn(inputs) })
    }

    /// A sweep over the pixels of a scene. `set` has the names of parameters that were set in
    /// `base`. Material parameters that are neither among them nor swept come from the scene.
    ///
    /// # Errors
    /// If a parameter has two axes or belongs to another unit, the grid is too large, or the unit
    /// doesn't shade.
    pub fn over_scene(base: Values, set: &[&str], axes: Vec<Axis>, view: View) -> Result<Self> {
        Self::check(&base, &axes)?;
        let unit = base.unit();
        if unit.shades == Shading::None {
            return Err(Error::usage(format!(
                "unit `{}` can't shade a scene by itself: {}",
                unit.name,
                instead_of_a_scene(unit)
            )));
        }
        let is_given =
            |name: &str| set.contains(&name) || axes.iter().any(|axis| axis.key() == name);
        let reflection = |param: &Param| {
            let Role::Material(part) = param.role else { return None };
            is_given(&param.name).then(|| (param.name.clone(), part))
        };
        let given = unit.params.iter().filter_map(reflection).collect();
        let id = SceneId::new(&view.name, &view.scene);
        Ok(Self { base, axes, source: Source::Scene { view: Box::new(view), id, given } })
    }

    /// Refuses axes that don't form a grid.
    fn check(base: &Values, axes: &[Axis]) -> Result<()> {
        let mut points = 1usize;
        for (index, axis) in axes.iter().enumerate() {
            if axis.unit != *base.unit() {
                let (key, own, other) = (axis.key(), &base.unit().name, &axis.unit.name);
                let text = format!("axis `{key}` belongs to unit `{other}`, not to `{own}`");
                return Err(Error::usage(text));
            }
            if axes[..index].iter().any(|before| before.key() == axis.key()) {
                return Err(Error::usage(format!(
                    "parameter `{}` has two axes: put all its values in one, such as {}=v,v,…",
                    axis.key(),
                    axis.key()
                )));
            }
            // Each axis has at most MAX_POINTS values, so the product can't exceed 2^64.
            points *= axis.values.len();
            if points > MAX_POINTS {
                let sizes: Vec<_> = axes.iter().map(|a| a.values.len().to_string()).collect();
                return Err(too_many(&format!("the grid has {} points", sizes.join(" × "))));
            }
        }
        Ok(())
    }

    /// Number of points of the grid.
    #[must_use]
    pub fn points(&self) -> usize {
        self.axes.iter().map(|axis| axis.values.len()).product()
    }

    /// Parameters of a point, given by its index in grid order.
    fn point(&self, index: usize) -> Values {
        let mut values = self.base.clone();
        let mut rest = index;
        for axis in self.axes.iter().rev() {
            let value = &axis.values[rest % axis.values.len()];
            rest /= axis.values.len();
            values.set(axis.key(), &value.to_string()).expect("bug: axes hold legal values");
        }
        values
    }

    /// Parameters of a point as they are recorded.
    fn parameters(&self, values: &Values) -> record::Parameters {
        let mut parameters = record::parameters_of(values);
        if let Source::Scene { given, .. } = &self.source {
            for param in &values.unit().params {
                let is_given = given.iter().any(|(name, _)| *name == param.name);
                if matches!(param.role, Role::Material(_)) && !is_given {
                    parameters.insert(param.name.to_owned(), "scene".into());
                }
            }
        }
        parameters
    }

    /// What was swept, as recorded in `sweep.json`.
    #[must_use]
    pub fn header(&self) -> Header {
        let (sampler, samples, seed, scene, error) = match &self.source {
            Source::Drawn(inputs) => {
                let drawn = if inputs.sampler.is_random() { inputs.samples } else { 0 };
                let seed = if inputs.sampler.is_random() { inputs.seed } else { 0 };
                (inputs.sampler.name(), drawn, seed, None, None)
            }
            Source::Scene { view, id, .. } => ("scene", 0, 0, Some(id.clone()), Some(view.error)),
        };
        let mut base = self.parameters(&self.base);
        base.retain(|name, _| self.axes.iter().all(|axis| axis.key() != name));
        let axes = self.axes.iter().map(|axis| record::Axis {
            key: axis.key().to_owned(),
            values: axis.values.iter().map(record::json_of).collect(),
        });
        Header {
            format_version: record::FORMAT_VERSION,
            crate_version: env!("CARGO_PKG_VERSION").to_owned(),
            unit: self.base.unit().name.to_owned(),
            base,
            axes: axes.collect(),
            sampler: sampler.to_owned(),
            samples,
            seed,
            scene,
            error,
        }
    }

    /// Measures every point and writes `sweep.json`, `sweep.csv`, `report.md` and plots into a
    /// folder. Points that an earlier run of the same sweep left there are kept unless `fresh` is
    /// set. Points that can't be built or fail a check are recorded with the reason.
    ///
    /// # Errors
    /// If nothing is in view, the folder holds another sweep, a file can't be read or written, or
    /// every point fails.
    pub fn run(
        &self,
        folder: &Path,
        fresh: bool,
        progress: &(dyn Fn(Progress) + Sync),
    ) -> Result<Record> {
        if let Source::Scene { view, .. } = &self.source {
            check_view(&view.scene)?;
        }
        let set = Set::open(folder, "sweep")?;
        let header = self.header();
        let mut run = Run {
            sweep: self,
            folder,
            points: vec![None; self.points()],
            done: 0,
            progress,
            written: None,
            header,
            scene: match &self.source {
                Source::Drawn(_) => None,
                Source::Scene { view, .. } => Some(view.scene.clone()),
            },
        };
        // Check before the work starts.
        let check = || files().try_for_each(|name| output::check(&folder.join(name)));
        if fresh {
            check()?;
            run.remove_files()?;
        } else {
            run.resume()?;
            check()?;
        }
        run.finish()?;
        let record =
            Record { header: run.header, points: run.points.into_iter().flatten().collect() };
        let failed = |point: &Point| point.measured.is_none();
        if record.points.iter().all(failed) {
            let first = record.points.iter().find_map(|point| point.error.as_deref());
            return Err(Error::usage(format!(
                "all {} points failed, the first because {}",
                record.points.len(),
                first.unwrap_or_default()
            )));
        }
        report::write(&set.path(), &record)?;
        set.commit()?;
        Ok(record)
    }

    /// The material parameters of a point that were set explicitly.
    fn material(&self, point: &Values) -> Vec<(Reflection, Value)> {
        match &self.source {
            Source::Drawn(_) => Vec::new(),
            Source::Scene { given, .. } => {
                given.iter().map(|(name, part)| (*part, point.get(name).clone())).collect()
            }
        }
    }

    /// True if two points can be measured together. Random inputs are drawn as reals and suit all
    /// points; other samplers give lists of words; a picture's golden depends on the material.
    fn same_inputs(&self, (a, first): (usize, &Job), (b, second): (usize, &Job)) -> bool {
        match &self.source {
            Source::Drawn(inputs) => {
                !inputs.are_words() || inputs.same(first.design(), second.design())
            }
            Source::Scene { .. } => self.material(&self.point(a)) == self.material(&self.point(b)),
        }
    }

    /// Number of points measured together: enough to share golden values well, but few enough that
    /// a sweep of many samples saves results every few seconds.
    fn group_points(&self) -> usize {
        let most = match &self.source {
            Source::Drawn(inputs) => match inputs.sampler {
                Sampler::Lit | Sampler::Sphere => GROUP_SAMPLES / inputs.samples.max(1),
                Sampler::Hard => GROUP_SAMPLES,
                Sampler::Exhaustive => 1, // a point may be long: save each
            },
            Source::Scene { view, .. } => cast::count_of(shots_together(&view.scene)),
        };
        usize::try_from(most).unwrap_or(GROUP_POINTS).clamp(1, GROUP_POINTS)
    }
}

/// The files are rewritten when the time since the last writing is this many times what that took.
const WRITE_SHARE: u32 = 10;

/// A running sweep.
struct Run<'a> {
    sweep: &'a Sweep,
    folder: &'a Path,
    header: Header,
    /// Finished points in grid order.
    points: Vec<Option<Point>>,
    done: usize,
    progress: &'a (dyn Fn(Progress) + Sync),
    /// When the files were last written, and how long that took.
    written: Option<(Instant, Duration)>,
    /// The scene, with the material of the most recently requested point.
    scene: Option<Scene>,
}

/// A point that was built.
enum Job {
    Design(Box<Design>),
    Shader(Box<Shader>),
}

impl Job {
    fn design(&self) -> &Design {
        match self {
            Self::Design(design) => design,
            Self::Shader(shader) => shader.design(),
        }
    }
}

impl Run<'_> {
    /// Loads finished points from `sweep.json`.
    fn resume(&mut self) -> Result<()> {
        let path = self.folder.join("sweep.json");
        let Some(record) = Record::load(&path)? else { return self.refuse_foreign_files() };
        // Points record every error, so another ranking is not another sweep.
        let there = Header { error: self.header.error, ..record.header };
        if there != self.header {
            let differences = there.differences(&self.header);
            return Err(Error::file(
                &path,
                format!(
                    "holds another sweep: {}; choose another folder or pass --fresh",
                    differences.join(", ")
                ),
            ));
        }
        let index_of: HashMap<String, usize> = (0..self.points.len())
            .map(|index| (key(&self.sweep.parameters(&self.sweep.point(index))), index))
            .collect();
        for point in record.points {
            let slot = index_of.get(&key(&point.parameters)).map(|index| &mut self.points[*index]);
            match slot {
                Some(slot @ None) => *slot = Some(point),
                Some(Some(_)) | None => {
                    return Err(Error::file(
                        &path,
                        "has a point twice or outside its grid: choose another folder or pass --fresh"
                            .to_owned(),
                    ));
                }
            }
            self.done += 1;
        }
        Ok(())
    }

    /// Refuses files that a sweep would overwrite if there is no sweep: they belong to somebody
    /// else.
    fn refuse_foreign_files(&self) -> Result<()> {
        let names = ["sweep.csv"].into_iter().chain(report::FILES);
        match names.map(|name| self.folder.join(name)).find(|path| path.exists()) {
            None => Ok(()),
            Some(path) => Err(Error::file(
                &path,
                "is in the way and not from a sweep: choose another folder or pass --fresh"
                    .to_owned(),
            )),
        }
    }

    /// Removes the files of an earlier sweep. Otherwise a sweep that is stopped before its first
    /// point is done would leave that one's points and reports behind.
    fn remove_files(&self) -> Result<()> {
        for name in files() {
            let path = self.folder.join(name);
            match fs::remove_file(&path) {
                Err(why) if why.kind() != io::ErrorKind::NotFound => {
                    return Err(Error::io(&path, "can't remove", why));
                }
                Ok(()) | Err(_) => {}
            }
        }
        Ok(())
    }

    /// Measures the missing points.
    fn finish(&mut self) -> Result<()> {
        let shared = |index| {
            let point = self.sweep.point(index);
            (self.sweep.material(&point), widths(&point))
        };
        let mut missing: Vec<usize> =
            (0..self.points.len()).filter(|index| self.points[*index].is_none()).collect();
        // Neighbours with equal materials and input formats share their golden values.
        missing.sort_by_cached_key(|index| shared(*index));
        let mut group: Vec<(usize, Job)> = Vec::new();
        let mut rom_bits = 0;
        for index in missing {
            let job = match self.build(index) {
                Ok(job) => job,
                Err(why) => {
                    self.fail(index, &why);
                    continue;
                }
            };
            let own_bits = job.design().netlist.counts().rom_bits;
            let full =
                group.len() == self.sweep.group_points() || rom_bits + own_bits > GROUP_ROM_BITS;
            if group.first().is_some_and(|(at, first)| {
                full || !self.sweep.same_inputs((*at, first), (index, &job))
            }) {
                self.measure(std::mem::take(&mut group))?;
                rom_bits = 0;
            }
            rom_bits += own_bits;
            group.push((index, job));
        }
        self.measure(group)?;
        self.write()
    }

    /// Sets the material of a point in the scene, if there is one.
    fn set_material(&mut self, index: usize) {
        if let Some(scene) = &mut self.scene {
            for (part, value) in self.sweep.material(&self.sweep.point(index)) {
                set_material(scene, part, &value);
            }
        }
    }

    /// Builds a point.
    fn build(&mut self, index: usize) -> Result<Job> {
        self.set_material(index);
        let point = self.sweep.point(index);
        let job = match &self.scene {
            None => Job::Design(Box::new(point.build()?)),
            Some(scene) => {
                Job::Shader(Box::new(Shader::new(scene, &Pipeline::of_values(&point), true)?))
            }
        };
        job.design().rtl()?;
        Ok(job)
    }

    fn fail(&mut self, index: usize, why: &Error) {
        self.put(index, Some(why.to_string()), None);
    }

    fn put(&mut self, index: usize, error: Option<String>, measured: Option<Measured>) {
        let parameters = self.sweep.parameters(&self.sweep.point(index));
        self.points[index] = Some(Point { parameters, error, measured });
        self.done += 1;
    }

    /// Measures a group of points and drops what was built.
    fn measure(&mut self, group: Vec<(usize, Job)>) -> Result<()> {
        let Some((first, _)) = group.first() else { return Ok(()) };
        self.set_material(*first);
        let (points_done, points, progress) = (self.done, self.points.len(), self.progress);
        let tell = |points_done: usize, running: usize, samples_done: u64| {
            progress(Progress { points_done, points, running, samples_done });
        };
        tell(points_done, group.len(), 0);
        let jobs: Vec<&Job> = group.iter().map(|(_, job)| job).collect();
        let together = self.figures(&jobs, &|done| tell(points_done, jobs.len(), done));
        let results: Vec<Result<Measured>> = match together {
            Ok(measured) => measured.into_iter().map(Ok).collect(),
            Err(why) if jobs.len() == 1 => vec![Err(why)],
            // One of them failed, but the error doesn't say which.
            Err(_) => jobs
                .iter()
                .enumerate()
                .map(|(index, job)| {
                    let done = points_done + index;
                    Ok(self.figures(&[job], &|samples| tell(done, 1, samples))?.remove(0))
                })
                .collect(),
        };
        for ((index, _), result) in group.iter().zip(results) {
            match result {
                Ok(measured) => self.put(*index, None, Some(measured)),
                Err(why) => self.fail(*index, &why),
            }
        }
        tell(self.done, 0, 0);
        // The whole files are rewritten each time, which would dominate a large grid of quick
        // points.
        match self.written {
            Some((when, took)) if when.elapsed() < took * WRITE_SHARE => Ok(()),
            Some(_) | None => self.write(),
        }
    }

    /// Figures of points that share their inputs; `progress` receives the number of samples, or
    /// rows, done.
    fn figures(&self, jobs: &[&Job], progress: &(dyn Fn(u64) + Sync)) -> Result<Vec<Measured>> {
        let (mut designs, mut shaders) = (Vec::new(), Vec::new());
        for job in jobs {
            match job {
                Job::Design(design) => designs.push(&**design),
                Job::Shader(shader) => shaders.push(&**shader),
            }
        }
        match (&self.sweep.source, &self.scene) {
            (Source::Scene { .. }, Some(scene)) => {
                report::shots(scene, &shaders, PIXELS_PER_DEGREE, progress)
            }
            (Source::Drawn(inputs), _) => {
                let reports = measure::measure(&designs, inputs, progress)?;
                Ok(designs
                    .iter()
                    .zip(reports)
                    .map(|(d, report)| Measured::new(d, report))
                    .collect())
            }
            (Source::Scene { .. }, None) => panic!("bug: a run over a scene has it"),
        }
    }

    /// Writes `sweep.json` and `sweep.csv` with the points finished so far.
    fn write(&mut self) -> Result<()> {
        let start = Instant::now();
        let points = self.points.iter().flatten();
        Record::write_json(&self.folder.join("sweep.json"), &self.header, points.clone())?;
        Record::write_csv(&self.folder.join("sweep.csv"), &self.header, points)?;
        let end = Instant::now();
        self.written = Some((end, end - start));
        Ok(())
    }
}

/// Names of all files that a sweep may write.
fn files() -> impl Iterator<Item = &'static str> {
    ["sweep.json", "sweep.csv"].into_iter().chain(report::FILES)
}

/// The identity of a point within its grid.
fn key(parameters: &record::Parameters) -> String {
    serde_json::to_string(parameters).expect("bug: parameters are plain values")
}

/// The widths that input formats depend on. Those of the inputs come first among a unit's widths;
/// if one doesn't, only the order of measuring changes.
fn widths(values: &Values) -> Vec<Value> {
    let widths = values.params().filter(|(param, _)| param.role == Role::Width);
    widths.map(|(_, value)| value.clone()).collect()
}

#[cfg(test)]
mod tests;
