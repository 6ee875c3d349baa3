//! Specialises pipelines to a scene: each design is reduced to the words that occur, split into a
//! part that runs once per flat face and a part that runs for every pixel, and compared with the
//! general design on every pixel of the scene.

use super::block::blocks;
use super::bumps::{by_material, port_column, shading_point};
use super::shader::{Shader, Stage};
use crate::base::cast;
use crate::base::error::Result;
use crate::measure::quantize_inputs;
use crate::netlist::op::Op;
use crate::netlist::words::Words;
use crate::netlist::{Netlist, NodeId};
use crate::shading::render::pipeline::Pipeline;
use crate::shading::scene::{CURVED, Fragments, Scene};
use crate::shading::specialise::{Known, Rate, Reduced, Report, Source, Specialised, specialise};
use crate::sim::batch::{Program, Runner};
use crate::units::fragment::Fragment;
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use std::ops::Range;
use std::time::{Duration, Instant};

/// Words are bucketed by this many top bits when their intervals are determined.
const BUCKET_BITS: u32 = 10;

/// A flat face: object and number.
type Face = (u32, u32);

/// A design of a pipeline, specialised to a scene.
#[derive(Clone, Debug, Serialize)]
pub struct SpecialisedStage {
    /// Index of the material of the first pair of material and light that uses it.
    pub material: usize,
    /// Index of the light of that pair.
    pub light: usize,
    /// Words that occur at each input port, and how often they change.
    pub inputs: Vec<SeenPort>,
    /// What was folded, cut and moved, and the savings.
    pub report: Report,
    /// Samples compared; all words of the light are compared in each.
    pub samples: u64,
    /// Words that differed: 0, unless the specialiser is wrong.
    pub mismatches: u64,
    /// Faces for which the face part was run.
    pub faces: u64,
    /// Seconds of the general design in the engine, all threads together.
    pub general_seconds: f64,
    /// Seconds of the specialised design, including its face part.
    pub specialised_seconds: f64,
}

/// What a scene feeds to a port.
#[derive(Clone, Debug, Serialize)]
pub struct SeenPort {
    /// The port.
    pub port: String,
    /// Its words, as intervals.
    pub words: String,
    /// `scene`, `face` or `pixel`: the extent over which it is constant.
    pub rate: &'static str,
}

/// Words seen at the ports of a stage.
#[derive(Clone, Default)]
struct Seen {
    /// Smallest and largest word of each nonempty bucket, by port.
    buckets: Vec<BTreeMap<i64, (i64, i64)>>,
    /// The word of each port on each flat face; `None` if it varies there.
    faces: BTreeMap<Face, Vec<Option<i64>>>,
    /// True if a fragment wasn't on a flat face.
    curved: bool,
}

impl Seen {
    fn add(&mut self, netlist: &Netlist, words: &[Vec<i64>], faces: &[Face]) {
        self.buckets.resize(words.len(), BTreeMap::new());
        for ((buckets, words), id) in self.buckets.iter_mut().zip(words).zip(netlist.inputs()) {
            let shift = netlist.node(*id).format.bits().saturating_sub(BUCKET_BITS);
            for word in words {
                let (lo, hi) = buckets.entry(word >> shift).or_insert((*word, *word));
                (*lo, *hi) = ((*lo).min(*word), (*hi).max(*word));
            }
        }
        for (i, face) in faces.iter().enumerate() {
            if face.1 == CURVED {
                self.curved = true;
                continue;
            }
            let known = self.faces.entry(*face);
            let first = || words.iter().map(|column| Some(column[i])).collect();
            for (known, column) in known.or_insert_with(first).iter_mut().zip(words) {
                if *known != Some(column[i]) {
                    *known = None;
                }
            }
        }
    }

    fn merge(&mut self, other: Self) {
        self.buckets.resize(self.buckets.len().max(other.buckets.len()), BTreeMap::new());
        for (mine, theirs) in self.buckets.iter_mut().zip(other.buckets) {
            for (bucket, (lo, hi)) in theirs {
                let (my_lo, my_hi) = mine.entry(bucket).or_insert((lo, hi));
                (*my_lo, *my_hi) = ((*my_lo).min(lo), (*my_hi).max(hi));
            }
        }
        for (face, words) in other.faces {
            match self.faces.get_mut(&face) {
                None => {
                    self.faces.insert(face, words);
                }
                Some(mine) => {
                    for (mine, word) in mine.iter_mut().zip(words) {
                        if *mine != word {
                            *mine = None;
                        }
                    }
                }
            }
        }
        self.curved |= other.curved;
    }

    /// What is known of each port: nothing if the stage was never used.
    fn known(&self, netlist: &Netlist) -> Vec<Known> {
        let port = |(at, id): (usize, &NodeId)| {
            let Some(buckets) = self.buckets.get(at).filter(|buckets| !buckets.is_empty()) else {
                return Known::nothing(netlist.node(*id).format);
            };
            let words = Words::of(buckets.values().copied());
            let per_face = !self.curved && self.faces.values().all(|words| words[at].is_some());
            let rate = match words.constant() {
                Some(_) => Rate::Scene,
                None if per_face => Rate::Face,
                None => Rate::Pixel,
            };
            Known { words, rate }
        };
        netlist.inputs().iter().enumerate().map(port).collect()
    }
}

/// A specialised stage, ready to run.
struct Lean {
    made: Specialised,
    program: Option<Program>,
    /// Output nodes in the order of the general stage's: diffuse, specular.
    outputs: Vec<NodeId>,
    /// Output words of the face part, by face.
    faces: BTreeMap<Face, Vec<i64>>,
    face_time: Duration,
}

impl Lean {
    fn new(stage: &Stage, seen: &Seen, known: &[Known]) -> Self {
        let names: &[&str] =
            if stage.needs_specular() { &["diffuse", "specular"] } else { &["diffuse"] };
        let made = specialise(&stage.design.netlist, known, names);
        let netlist = &made.pixel.netlist;
        let node = |name: &&str| {
            let output = netlist.outputs().iter().find(|output| output.name == **name);
            output.expect("bug: it was asked for").node
        };
        let outputs: Vec<NodeId> = names.iter().map(node).collect();
        let program = (!netlist.inputs().is_empty()).then(|| Program::compile(netlist, &outputs));
        let start = Instant::now();
        let faces = made.face.as_ref().map(|face| face_words(face, seen)).unwrap_or_default();
        Self { program, outputs, faces, face_time: start.elapsed(), made }
    }

    /// The light's words for some samples, from the general stage's input words.
    fn run(
        &self,
        runner: Option<&mut Runner>,
        words: &[Vec<i64>],
        faces: &[Face],
        to: &mut [Vec<i64>],
    ) {
        let Reduced { netlist, inputs } = &self.made.pixel;
        let (Some(program), Some(runner)) = (&self.program, runner) else {
            // Nothing changes from pixel to pixel.
            for (column, node) in to.iter_mut().zip(&self.outputs) {
                let Op::Const { raw } = netlist.node(*node).op else {
                    panic!("bug: no input, and no constant")
                };
                *column = vec![raw; faces.len()];
            }
            return;
        };
        let hoisted: Vec<Vec<i64>> = inputs
            .iter()
            .map(|source| match source {
                Source::Port(_) => Vec::new(),
                Source::Face(output) => {
                    faces.iter().map(|face| self.faces[face][*output]).collect()
                }
            })
            .collect();
        let columns: Vec<&[i64]> = inputs
            .iter()
            .zip(&hoisted)
            .map(|(source, hoisted)| match source {
                Source::Port(port) => words[*port].as_slice(),
                Source::Face(_) => hoisted.as_slice(),
            })
            .collect();
        runner.run(program, &columns, to).expect("bug: words are of their ports' formats");
    }
}

/// Runs the face part for every face.
fn face_words(face: &Reduced, seen: &Seen) -> BTreeMap<Face, Vec<i64>> {
    let outputs = face.netlist.outputs();
    let words = |known: &Vec<Option<i64>>| {
        // Ports that the face part reads are constant on the face; the others are ignored.
        let ports: Vec<i64> = known.iter().map(|word| word.unwrap_or(0)).collect();
        let ran = face.netlist.eval(&face.select(&ports, &[]));
        let (words, _) = ran.expect("bug: words are of their ports' formats");
        outputs.iter().map(|output| words[output.node.index()]).collect()
    };
    seen.faces.iter().map(|(face, known)| (*face, words(known))).collect()
}

/// Calls `take` with the quantised inputs of a block's fragments, for each stage.
fn each_batch(
    scene: &Scene,
    shader: &Shader,
    rows: Range<u32>,
    fragments: &mut Fragments,
    mut take: impl FnMut(usize, &[Vec<i64>], &[Face]),
) -> Result<()> {
    scene.trace(rows, fragments);
    for (material, members) in by_material(fragments) {
        let faces: Vec<Face> =
            members.iter().map(|i| (fragments.object[*i], fragments.face[*i])).collect();
        for (number, light) in scene.lights.iter().enumerate() {
            let index = shader.of[material][number];
            let stage = &shader.stages[index];
            let points: Vec<Fragment> =
                members.iter().map(|i| shading_point(scene, fragments, *i, light)).collect();
            let columns: Vec<Vec<f64>> =
                stage.ports.iter().map(|port| port_column(*port, &points)).collect();
            let mut words = Vec::new();
            quantize_inputs(&stage.design.netlist, &columns, &mut words)?;
            take(index, &words, &faces);
        }
    }
    Ok(())
}

/// Counts of a comparison.
#[derive(Clone, Copy, Default)]
struct Compared {
    samples: u64,
    mismatches: u64,
    general: Duration,
    specialised: Duration,
}

/// Specialises every design of a pipeline to a scene, and compares it with the general one on every
/// pixel: all words of the light, bit for bit. [`SpecialisedStage::mismatches`] is the result.
///
/// # Errors
/// If the pipeline can't be built.
///
/// # Panics
/// Never: words are written in their ports' formats.
pub fn specialise_to(scene: &Scene, pipeline: &Pipeline) -> Result<Vec<SpecialisedStage>> {
    let shader = Shader::with_stages(scene, pipeline, false, false, true)?;
    let blocks = blocks(scene.image.height);
    let seen = blocks
        .par_iter()
        .map_init(Fragments::default, |fragments, rows| {
            let mut seen = vec![Seen::default(); shader.stages.len()];
            each_batch(scene, &shader, rows.clone(), fragments, |index, words, faces| {
                seen[index].add(&shader.stages[index].design.netlist, words, faces);
            })?;
            Ok(seen)
        })
        .reduce(
            || Ok(vec![Seen::default(); shader.stages.len()]),
            |a: Result<Vec<Seen>>, b| {
                let mut all = a?;
                for (mine, theirs) in all.iter_mut().zip(b?) {
                    mine.merge(theirs);
                }
                Ok(all)
            },
        )?;
    let known: Vec<Vec<Known>> = shader
        .stages
        .iter()
        .zip(&seen)
        .map(|(stage, seen)| seen.known(&stage.design.netlist))
        .collect();
    let leans: Vec<Lean> = shader
        .stages
        .iter()
        .zip(&seen)
        .zip(&known)
        .map(|((stage, seen), known)| Lean::new(stage, seen, known))
        .collect();
    let compared = blocks
        .par_iter()
        .map_init(
            || {
                let general = shader.stages.iter().map(|stage| stage.program.runner());
                let lean = leans.iter().map(|l| l.program.as_ref().map(Program::runner));
                (Fragments::default(), general.collect::<Vec<_>>(), lean.collect::<Vec<_>>())
            },
            |(fragments, general, lean), rows| {
                let mut all = vec![Compared::default(); leans.len()];
                each_batch(scene, &shader, rows.clone(), fragments, |index, words, faces| {
                    let stage = &shader.stages[index];
                    let slices: Vec<&[i64]> = words.iter().map(Vec::as_slice).collect();
                    let mut should = vec![Vec::new(); 1 + usize::from(stage.has_specular)];
                    let start = Instant::now();
                    let ran = general[index].run(&stage.program, &slices, &mut should);
                    ran.expect("bug: words are of their ports' formats");
                    let middle = Instant::now();
                    let mut is = vec![Vec::new(); leans[index].outputs.len()];
                    leans[index].run(lean[index].as_mut(), words, faces, &mut is);
                    let compared = &mut all[index];
                    compared.specialised += middle.elapsed();
                    compared.general += middle - start;
                    compared.samples += cast::count_of(faces.len());
                    for (at, should) in should.iter().enumerate() {
                        // Specular light that a scene doesn't need is 0 everywhere.
                        let differs = |i: usize| should[i] != is.get(at).map_or(0, |is| is[i]);
                        let count = (0..should.len()).filter(|i| differs(*i)).count();
                        compared.mismatches += cast::count_of(count);
                    }
                })?;
                Ok(all)
            },
        )
        .reduce(
            || Ok(vec![Compared::default(); leans.len()]),
            |a: Result<Vec<Compared>>, b| {
                let mut all = a?;
                for (mine, theirs) in all.iter_mut().zip(b?) {
                    mine.samples += theirs.samples;
                    mine.mismatches += theirs.mismatches;
                    mine.general += theirs.general;
                    mine.specialised += theirs.specialised;
                }
                Ok(all)
            },
        )?;
    let mut stages = Vec::new();
    for (index, (lean, compared)) in leans.into_iter().zip(compared).enumerate() {
        let (material, light) = shader.first_use(index);
        let netlist = &shader.stages[index].design.netlist;
        let port = |(at, known): (usize, &Known)| SeenPort {
            port: netlist.input_name(at).to_owned(),
            words: known.words.to_string(),
            rate: known.rate.name(),
        };
        stages.push(SpecialisedStage {
            material,
            light,
            inputs: known[index].iter().enumerate().map(port).collect(),
            samples: compared.samples,
            mismatches: compared.mismatches,
            faces: cast::count_of(lean.faces.len()),
            general_seconds: compared.general.as_secs_f64(),
            specialised_seconds: (compared.specialised + lean.face_time).as_secs_f64(),
            report: lean.made.report,
        });
    }
    Ok(stages)
}
