//! Error measurement: bit-true words and real evaluations against the golden.
//!
//! An error is always told with its *basis*:
//!
//! - `total`: bit-true against the golden of the same quantised inputs;
//! - `arithmetic`: bit-true against the netlist on reals: what words and tables do;
//! - `algorithm`: the netlist on reals against the golden: what the method itself does;
//! - `end-to-end`: bit-true against the golden of the inputs before quantisation.
//!
//! Samples come in chunks, each with a random stream of its own; partial results are merged in
//! chunk order, so the figures don't depend on the number of threads. Designs measured together
//! share inputs and golden values.

mod bounds;
mod cone;
pub mod eval;
mod inputs;
pub mod samples;
mod stream;
#[cfg(test)]
mod tests;

pub use crate::table::figures::{TABLE_ARGUMENT_BITS, TableFigures, table_figures};
pub use bounds::{
    BoundCheck, HardResult, HardVerdict, StatedBound, case_columns, hard_columns, hard_results,
    hard_verdicts,
};
pub use cone::{Cone, ConeReport};
pub use inputs::{Inputs, quantize_inputs, sample_words};
pub(crate) use inputs::{quantize_input, values_of};
pub use stream::angle_between;

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::json;
use crate::base::simd::vectorised;
use crate::design::{Design, Group, Scale, Shape};
use crate::netlist::{Netlist, NodeId};
use crate::number::trig::Real;
use crate::sim::batch::{Program, Runner, check_overflows};
use crate::sim::real;
use inputs::CHUNK;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;
use stream::{Angles, Counts, Differences, Lengths, Merged};
pub(crate) use stream::{BINS, Histograms, Stream};

/// Columns of judged nodes as the golden has them: directions as x, y, z. It takes the columns and leaves
/// others.
pub(crate) fn as_golden(groups: &[Group], nodes: &mut [Vec<f64>], to: &mut Vec<Vec<f64>>) {
    let columns = groups.iter().map(|group| group.shape.columns().len()).sum();
    to.resize(columns, Vec::new());
    let (mut node, mut column) = (0, 0);
    for group in groups {
        let from = &mut nodes[node..node + group.shape.nodes()];
        let to = &mut to[column..column + group.shape.columns().len()];
        node += from.len();
        column += to.len();
        match group.shape {
            Shape::Cartesian | Shape::Scalar | Shape::Scaled { .. } => {
                for (to, from) in to.iter_mut().zip(from) {
                    std::mem::swap(to, from);
                }
            }
            Shape::Polar => {
                let [x, y, z] = to else { panic!("bug: x, y, z") };
                let len = from[0].len();
                [&mut *x, &mut *y, &mut *z].into_iter().for_each(|to| to.resize(len, 0.0));
                f64::sin_cos_turns(&from[0], y, x);
                let mut sin_theta = vec![0.0; len];
                f64::sin_cos_turns(&from[1], &mut sin_theta, z);
                for ((x, y), sin_theta) in x.iter_mut().zip(y).zip(&sin_theta) {
                    *x *= sin_theta;
                    *y *= sin_theta;
                }
            }
        }
    }
}

/// How an error comes from golden columns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    /// Angle between the directions of three columns.
    Angle,
    /// Length of the difference of three columns.
    Dot,
    /// Difference of one column.
    Number,
    /// The same over the golden's scale, in this column.
    Relative(usize),
    /// Difference of one column in texels of a texture of that size.
    Texels(u32),
}

/// A quantity whose error is measured.
#[derive(Clone, Debug)]
struct Measurand {
    name: String,
    kind: Kind,
    /// The first golden column that it takes.
    column: usize,
    /// Last place of the node, where the column is a node.
    ulp: Option<f64>,
}

impl Measurand {
    fn unit(&self) -> &'static str {
        match self.kind {
            Kind::Angle => "rad",
            Kind::Dot | Kind::Number => "1",
            Kind::Relative(_) => "rel",
            Kind::Texels(_) => "texel",
        }
    }

    /// True if it stands for its group where no bound is stated: the angle of a direction, or a
    /// number itself.
    fn counts_unbounded(&self, design: &Design) -> bool {
        let direction = design.groups.iter().any(|group| group.shape.is_direction());
        if direction { self.kind == Kind::Angle } else { self.kind == Kind::Number }
    }

    /// All of a design, in reporting order: the same for all designs of a unit.
    fn all(design: &Design) -> Vec<Self> {
        let mut all = Vec::new();
        let mut column = 0;
        let mut scale: usize = design.groups.iter().map(|group| group.shape.columns().len()).sum();
        for group in &design.groups {
            let named = |part: &str| match group.name {
                "" => part.to_owned(),
                name => format!("{name}_{part}"),
            };
            if group.shape.is_direction() {
                for (part, kind) in [("angle", Kind::Angle), ("dot", Kind::Dot)] {
                    all.push(Self { name: named(part), kind, column, ulp: None });
                }
            }
            if let Shape::Scaled { scales, texels } = group.shape {
                let own = |part: &str, kind| Self { name: named(part), kind, column, ulp: None };
                all.extend(texels.map(|texels| own("texels", Kind::Texels(texels))));
                for Scale { name, .. } in scales {
                    all.push(own(name, Kind::Relative(scale)));
                    scale += 1;
                }
            }
            for (i, name) in group.columns().into_iter().enumerate() {
                let ulp = |i: usize| design.netlist.node(group.nodes[i]).format.ulp();
                let ulp = (group.shape != Shape::Polar).then(|| ulp(i));
                all.push(Self { name, kind: Kind::Number, column: column + i, ulp });
            }
            column += group.shape.columns().len();
        }
        all
    }

    /// Errors of samples; scales are those of the golden.
    fn errors(
        &self,
        is: &[Vec<f64>],
        should: &[Vec<f64>],
        golden: &[Vec<f64>],
        errors: &mut Vec<f64>,
    ) {
        errors.resize(is[self.column].len(), 0.0);
        match self.kind {
            Kind::Angle => {
                let (u, v) = (self.three(is), self.three(should));
                vectorised(Angles { u, v, angles: errors });
            }
            Kind::Dot => {
                let (u, v) = (self.three(is), self.three(should));
                vectorised(Lengths { u, v, lengths: errors });
            }
            Kind::Number | Kind::Texels(_) | Kind::Relative(_) => {
                let factor =
                    if let Kind::Texels(texels) = self.kind { f64::from(texels) } else { 1.0 };
                let (is, should) = (&is[self.column], &should[self.column]);
                vectorised(Differences { is, should, factor, errors });
            }
        }
        if let Kind::Relative(scale) = self.kind {
            for (error, scale) in errors.iter_mut().zip(&golden[scale]) {
                // Of nothing nothing is no error.
                *error = if *error == 0.0 { 0.0 } else { *error / scale };
            }
        }
    }

    /// Its columns, of a vector.
    fn three<'a>(&self, columns: &'a [Vec<f64>]) -> [&'a [f64]; 3] {
        [0, 1, 2].map(|axis| columns[self.column + axis].as_slice())
    }
}

/// Names of the angles whose error is measured, one for each direction.
pub(crate) fn angle_quantities(design: &Design) -> Vec<String> {
    angles(design).map(|measurand| measurand.name).collect()
}

/// The same errors in rad, of golden columns of samples; each is a column.
pub(crate) fn angle_errors(design: &Design, is: &[Vec<f64>], should: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let errors = |measurand: Measurand| {
        let mut errors = Vec::new();
        measurand.errors(is, should, should, &mut errors);
        errors
    };
    angles(design).map(errors).collect()
}

fn angles(design: &Design) -> impl Iterator<Item = Measurand> {
    Measurand::all(design).into_iter().filter(|measurand| measurand.kind == Kind::Angle)
}

/// What an error is measured against.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize, PartialOrd, Ord)]
#[serde(rename_all = "kebab-case")]
pub enum Basis {
    /// Bit-true against the golden of the quantised inputs.
    Total,
    /// Bit-true against the netlist on reals.
    Arithmetic,
    /// The netlist on reals against the golden of the quantised inputs.
    Algorithm,
    /// Bit-true against the golden of the real inputs.
    EndToEnd,
}

impl Basis {
    /// All of them, in reporting order.
    pub const ALL: [Self; 4] = [Self::Total, Self::Arithmetic, Self::Algorithm, Self::EndToEnd];

    /// Name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Total => "total",
            Self::Arithmetic => "arithmetic",
            Self::Algorithm => "algorithm",
            Self::EndToEnd => "end-to-end",
        }
    }

    /// What it sets beside what.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Total => {
                "bit-true against the golden of the quantised inputs: arithmetic and algorithm together"
            }
            Self::Arithmetic => "bit-true against the netlist on reals: words and tables",
            Self::Algorithm => {
                "the netlist on reals against the golden of the quantised inputs: the method itself"
            }
            Self::EndToEnd => "bit-true against the golden of the inputs before quantisation",
        }
    }
}

/// The input that gave a maximum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Witness {
    /// Number of the sample.
    pub sample: u64,
    /// Input words, by port.
    pub words: Vec<i64>,
    /// Their values.
    pub values: Vec<f64>,
    /// Output words, by port.
    pub outputs: Vec<i64>,
}

/// Statistics of one quantity on one basis.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Figures {
    /// What is measured: of a direction angle (between vectors), dot (largest error of a dot
    /// product with any unit vector: the length of the difference) and each component; a number
    /// by its own name.
    pub quantity: String,
    /// `rad`, `texel`, `rel` over a scale of the golden ([`Design::scales`]), or `1` for absolute errors.
    pub unit: &'static str,
    /// What it is told over, in words, where it isn't absolute.
    pub over: Option<&'static str>,
    /// Against what.
    pub basis: Basis,
    /// Largest absolute value.
    #[serde(serialize_with = "json::real")]
    pub max: f64,
    /// The same in ulp of the port or node, for numbers and Cartesian components.
    #[serde(serialize_with = "json::known_real")]
    pub max_ulp: Option<f64>,
    /// Input that gave it.
    pub witness: Option<Witness>,
    /// Mean of the absolute value.
    #[serde(serialize_with = "json::real")]
    pub mean: f64,
    /// Mean with sign.
    #[serde(serialize_with = "json::real")]
    pub bias: f64,
    /// Root of the mean square.
    #[serde(serialize_with = "json::real")]
    pub rms: f64,
    /// Median of the absolute value, to 1.6 %; 0 means below 2^-44.
    #[serde(serialize_with = "json::real")]
    pub p50: f64,
    /// 99th percentile, likewise.
    #[serde(serialize_with = "json::real")]
    pub p99: f64,
    /// 99.9th percentile, likewise.
    #[serde(serialize_with = "json::real")]
    pub p999: f64,
}

/// How often a `narrow` overflowed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct OverflowCount {
    /// The node.
    pub node: String,
    /// Its overflow mode.
    pub mode: &'static str,
    /// How often.
    pub count: u64,
}

/// Seconds of all threads together that each part of a measurement took. What designs measured
/// together share counts in equal parts for each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Profile {
    /// Drawing inputs.
    pub draw: f64,
    /// Writing them as words, and their values.
    pub quantise: f64,
    /// The golden of the inputs before quantisation and after.
    pub golden: f64,
    /// The bit-true engine.
    pub engine: f64,
    /// The netlist on reals.
    pub reals: f64,
    /// Errors, their sums, histograms and witnesses.
    pub statistics: f64,
}

impl Profile {
    /// Each part with its name, in the order of the work.
    #[must_use]
    pub fn parts(&self) -> [(&'static str, f64); 6] {
        [
            ("draw", self.draw),
            ("quantise", self.quantise),
            ("golden", self.golden),
            ("engine", self.engine),
            ("reals", self.reals),
            ("statistics", self.statistics),
        ]
    }

    /// Adds another's seconds.
    pub fn add(&mut self, other: &Self) {
        self.draw += other.draw;
        self.quantise += other.quantise;
        self.golden += other.golden;
        self.engine += other.engine;
        self.reals += other.reals;
        self.statistics += other.statistics;
    }
}

/// Tells the time since it was last asked.
struct Lap(Instant);

impl Lap {
    fn seconds(&mut self) -> f64 {
        let now = Instant::now();
        let seconds = now.duration_since(self.0).as_secs_f64();
        self.0 = now;
        seconds
    }
}

/// Time spent.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct Speed {
    /// Bit-true samples per second and thread: the engine alone.
    pub engine_samples_per_second_per_thread: f64,
    /// Samples per second of the whole run on all threads: inputs, golden, both evaluations,
    /// statistics; of all designs together where several were measured at once.
    pub samples_per_second: f64,
    /// Threads.
    pub threads: usize,
    /// Where the time went; not kept in files.
    #[serde(skip)]
    pub profile: Profile,
}

/// What was measured of a design.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Samples measured.
    pub samples: u64,
    /// One entry per quantity and basis.
    pub figures: Vec<Figures>,
    /// Every `narrow` that overflowed at least once.
    pub overflows: Vec<OverflowCount>,
    /// Time spent; the only part that differs from run to run.
    pub speed: Speed,
}

impl Report {
    /// Figures of a quantity on a basis.
    ///
    /// # Panics
    /// If there is no such quantity.
    #[must_use]
    pub fn figures(&self, quantity: &str, basis: Basis) -> &Figures {
        self.figures
            .iter()
            .find(|figures| figures.quantity == quantity && figures.basis == basis)
            .expect("bug: no such quantity")
    }
}

/// Compiled design.
struct Compiled<'a> {
    design: &'a Design,
    bases: &'a [Basis],
    program: Program,
    reals: real::Program,
    judged: Vec<NodeId>,
    measurands: Vec<Measurand>,
    /// Which set of quantised inputs it shares.
    set: usize,
}

impl Compiled<'_> {
    /// Measurands on each basis.
    fn streams(&self) -> usize {
        self.measurands.len() * self.bases.len()
    }
}

/// Designs with the same input words and the same golden model.
struct Set<'a> {
    /// One of them.
    design: &'a Design,
    /// The set whose values before quantisation, and their golden, are its own too.
    drawn: usize,
}

/// Columns of one thread for one design.
struct Lanes<'a> {
    runner: Runner,
    real_runner: real::Runner,
    words: Vec<Vec<i64>>,
    values: Vec<Vec<f64>>,
    reals: Vec<Vec<f64>>,
    counts: Counts<'a>,
}

/// Columns of one thread that designs share.
#[derive(Default)]
struct Shared {
    sets: Vec<SetColumns>,
    bit_true: Vec<Vec<f64>>,
    real: Vec<Vec<f64>>,
    errors: Vec<f64>,
}

/// Columns of a set of designs.
#[derive(Clone, Default)]
struct SetColumns {
    /// Inputs before quantisation, and their golden; empty if those of another set serve.
    values: Vec<Vec<f64>>,
    real_golden: Vec<Vec<f64>>,
    words: Vec<Vec<i64>>,
    quantised: Vec<Vec<f64>>,
    golden: Vec<Vec<f64>>,
}

/// What a chunk gave for one design.
struct Partial {
    streams: Vec<(Stream, Witness)>,
    overflows: Vec<u64>,
    profile: Profile,
}

/// Measures designs of one unit over the same inputs, on all bases; `progress` gets the samples done.
///
/// # Errors
/// If the inputs are too many to go through, or a `narrow` under overflow mode `error` overflowed.
///
/// # Panics
/// If the designs belong to different units.
pub fn measure(
    designs: &[&Design],
    inputs: &Inputs,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Report>> {
    measure_on(&Basis::ALL, designs, inputs, progress)
}

/// As [`measure`], on some bases: what the others need isn't computed. [`BoundCheck`] needs
/// [`Basis::Total`].
///
/// # Errors
/// As [`measure`].
///
/// # Panics
/// As [`measure`].
pub fn measure_on(
    bases: &[Basis],
    designs: &[&Design],
    inputs: &Inputs,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Report>> {
    let Some(first) = designs.first() else { return Ok(Vec::new()) };
    assert!(
        designs.iter().all(|design| std::ptr::eq(design.values.unit(), first.values.unit())),
        "bug: designs of different units have no common golden"
    );
    let mut sets: Vec<Set<'_>> = Vec::new();
    let mut compiled = Vec::new();
    let mut count = None;
    for design in designs {
        let netlist = &design.netlist;
        let set = sets.iter().position(|known| inputs.same(known.design, design));
        let set = set.unwrap_or_else(|| {
            let drawn = sets.iter().position(|known| inputs.same_values(known.design, design));
            sets.push(Set { design, drawn: drawn.unwrap_or(sets.len()) });
            sets.len() - 1
        });
        let samples = inputs.count(design)?;
        if *count.get_or_insert(samples) != samples {
            return Err(Error::usage(
                "designs with different numbers of inputs can't be measured together".to_owned(),
            ));
        }
        let judged = design.judged();
        let repeats = inputs.repeats(design);
        compiled.push(Compiled {
            design,
            bases,
            program: Program::compile_repeated(netlist, &judged, &repeats),
            reals: real::Program::compile_repeated(netlist, &judged, &repeats),
            judged,
            measurands: Measurand::all(design),
            set,
        });
    }
    let count = count.unwrap_or_default();

    let start = Instant::now();
    let chunks = count.div_ceil(CHUNK);
    let threads = rayon::current_num_threads();
    // Some chunks per thread at a time: memory doesn't grow with samples.
    let round = cast::count_of(threads) * 16;
    let mut merged: Vec<Vec<Merged>> =
        compiled.iter().map(|c| vec![Merged::EMPTY; c.streams()]).collect();
    let histograms: Vec<Histograms> =
        compiled.iter().map(|c| Histograms::new(c.streams())).collect();
    let mut overflows: Vec<Vec<u64>> =
        compiled.iter().map(|c| vec![0; c.program.narrows().len()]).collect();
    let mut profiles = vec![Profile::default(); compiled.len()];
    let idle: Idle<(Shared, Vec<Lanes<'_>>)> = Idle::default();
    let mut next = 0;
    while next < chunks {
        let these: Vec<u64> = (next..(next + round).min(chunks)).collect();
        let partials: Vec<Result<Vec<Partial>>> = these
            .par_iter()
            .map(|chunk| {
                let mut columns = idle.take().unwrap_or_else(|| {
                    let both = compiled.iter().zip(&histograms);
                    let lanes = both.map(|(c, all)| new_lanes(c, all)).collect();
                    (Shared::default(), lanes)
                });
                let from = chunk * CHUNK;
                let len = usize::try_from(CHUNK.min(count - from)).expect("bug: a chunk");
                let chunk = Chunk { inputs, from, len };
                let (shared, lanes) = &mut columns;
                let partials = measure_chunk(&compiled, &sets, &chunk, shared, lanes);
                idle.give(columns);
                partials
            })
            .collect();
        for partial in partials {
            for (i, partial) in partial?.into_iter().enumerate() {
                // The first chunk that overflows ends the run, whatever the number of threads.
                let c = &compiled[i];
                check_overflows(&c.design.netlist, c.program.narrows(), &partial.overflows)?;
                for (merged, (stream, witness)) in merged[i].iter_mut().zip(partial.streams) {
                    merged.merge(&stream, witness);
                }
                for (total, count) in overflows[i].iter_mut().zip(partial.overflows) {
                    *total += count;
                }
                profiles[i].add(&partial.profile);
            }
        }
        next += round;
        progress((next * CHUNK).min(count));
    }
    // Their counts go to the histograms.
    drop(idle);
    let elapsed = start.elapsed().as_secs_f64();
    let rate = |seconds: f64| {
        if seconds > 0.0 { cast::f64_of_count(count) / seconds } else { 0.0 }
    };
    Ok(compiled
        .iter()
        .zip(merged)
        .zip(histograms)
        .zip(overflows.iter().zip(profiles))
        .map(|(((c, merged), histograms), (overflows, profile))| Report {
            samples: count,
            figures: figures(c, &merged, &histograms),
            overflows: overflow_counts(&c.design.netlist, c.program.narrows(), overflows),
            speed: Speed {
                engine_samples_per_second_per_thread: rate(profile.engine),
                samples_per_second: rate(elapsed) * cast::f64_of_len(designs.len()),
                threads,
                profile,
            },
        })
        .collect())
}

fn new_lanes<'a>(c: &Compiled<'_>, all: &'a Histograms) -> Lanes<'a> {
    let outputs = c.judged.len();
    Lanes {
        runner: c.program.runner(),
        real_runner: c.reals.runner(),
        words: vec![Vec::new(); outputs],
        values: vec![Vec::new(); outputs],
        reals: vec![Vec::new(); outputs],
        counts: Counts::new(all, c.streams()),
    }
}

/// Columns that no thread uses now: a run makes as many as threads, once.
struct Idle<T>(Mutex<Vec<T>>);

impl<T> Default for Idle<T> {
    fn default() -> Self {
        Self(Mutex::new(Vec::new()))
    }
}

impl<T> Idle<T> {
    // A panic elsewhere ends the run; what is here is whole.
    fn take(&self) -> Option<T> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).pop()
    }

    fn give(&self, columns: T) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(columns);
    }
}

/// A run of consecutive samples.
struct Chunk<'a> {
    inputs: &'a Inputs,
    from: u64,
    len: usize,
}

fn measure_chunk(
    compiled: &[Compiled<'_>],
    sets: &[Set<'_>],
    chunk: &Chunk<'_>,
    shared: &mut Shared,
    lanes: &mut [Lanes<'_>],
) -> Result<Vec<Partial>> {
    let Chunk { inputs, from, len } = *chunk;
    let Shared { sets: columns, bit_true, real, errors } = shared;
    columns.resize(sets.len(), SetColumns::default());
    let mut lap = Lap(Instant::now());
    let mut together = Profile::default();
    let bases = compiled.first().map_or(&[][..], |c| c.bases);
    let needs_reals = bases.contains(&Basis::Arithmetic) || bases.contains(&Basis::Algorithm);
    // Words are their own real inputs.
    let needs_drawn = bases.contains(&Basis::EndToEnd) && !inputs.are_words();
    for (i, Set { design, drawn }) in sets.iter().enumerate() {
        let netlist = &design.netlist;
        let (before, own) = columns.split_at_mut(i);
        let own = &mut own[0];
        if *drawn == i {
            inputs.values(design, from, len, &mut own.values);
            together.draw += lap.seconds();
            if needs_drawn {
                run_golden(design, &own.values, &mut own.real_golden);
                together.golden += lap.seconds();
            }
        }
        let values = if *drawn == i { &own.values } else { &before[*drawn].values };
        quantize_inputs(netlist, values, &mut own.words)?;
        values_of(netlist, netlist.inputs(), &own.words, &mut own.quantised);
        together.quantise += lap.seconds();
        run_golden(design, &own.quantised, &mut own.golden);
        together.golden += lap.seconds();
    }
    let share = 1.0 / cast::f64_of_len(compiled.len());
    let mut partials = Vec::with_capacity(compiled.len());
    for (c, lanes) in compiled.iter().zip(lanes) {
        let set = &columns[c.set];
        let words: Vec<&[i64]> = set.words.iter().map(Vec::as_slice).collect();
        let before = lanes.runner.overflows().to_vec();
        let mut profile = Profile {
            draw: together.draw * share,
            quantise: together.quantise * share,
            golden: together.golden * share,
            ..Profile::default()
        };
        lanes.counts.make_room(len);
        lap.seconds();
        lanes.runner.run(&c.program, &words, &mut lanes.words);
        profile.engine = lap.seconds();
        values_of(&c.design.netlist, &c.judged, &lanes.words, &mut lanes.values);
        let values: Vec<&[f64]> = set.quantised.iter().map(Vec::as_slice).collect();
        as_golden(&c.design.groups, &mut lanes.values, bit_true);
        profile.statistics = lap.seconds();
        if needs_reals {
            lanes.real_runner.run(&c.reals, &values, &mut lanes.reals);
            profile.reals = lap.seconds();
            as_golden(&c.design.groups, &mut lanes.reals, real);
        }
        let golden = &set.golden;
        let mut streams = Vec::with_capacity(c.streams());
        for basis in bases {
            let (is, should) = match basis {
                Basis::Total => (&*bit_true, golden),
                Basis::Arithmetic => (&*bit_true, &*real),
                Basis::Algorithm => (&*real, golden),
                Basis::EndToEnd if !needs_drawn => (&*bit_true, golden),
                Basis::EndToEnd => (&*bit_true, &columns[sets[c.set].drawn].real_golden),
            };
            for measurand in &c.measurands {
                measurand.errors(is, should, golden, errors);
                streams.push(Stream::of(errors, from, lanes.counts.of(streams.len())));
            }
        }
        let ports = c.design.netlist.outputs().len();
        let witness = |stream: &Stream| {
            let i = usize::try_from(stream.at - from).expect("bug: inside the chunk");
            Witness {
                sample: stream.at,
                words: set.words.iter().map(|column| column[i]).collect(),
                values: set.quantised.iter().map(|column| column[i]).collect(),
                outputs: lanes.words.iter().take(ports).map(|column| column[i]).collect(),
            }
        };
        let after = lanes.runner.overflows();
        let streams = streams.iter().map(|stream| (*stream, witness(stream))).collect();
        profile.statistics += lap.seconds();
        partials.push(Partial {
            streams,
            overflows: after.iter().zip(before).map(|(after, before)| after - before).collect(),
            profile,
        });
    }
    Ok(partials)
}

/// Golden columns of columns of inputs.
pub(crate) fn run_golden(design: &Design, inputs: &[Vec<f64>], to: &mut Vec<Vec<f64>>) {
    let len = inputs.first().map_or(0, Vec::len);
    to.resize(design.golden_columns(), Vec::new());
    for column in to.iter_mut() {
        column.resize(len, 0.0);
    }
    let columns: Vec<&[f64]> = inputs.iter().map(Vec::as_slice).collect();
    (design.golden)(&design.values, &columns, to);
}

fn figures(c: &Compiled<'_>, merged: &[Merged], histograms: &Histograms) -> Vec<Figures> {
    let mut figures = Vec::new();
    let scales = c.design.scales();
    let over = |name: &str| scales.iter().find(|(scaled, _)| scaled == name).map(|(_, what)| *what);
    let kinds = c.bases.iter().flat_map(|basis| c.measurands.iter().map(move |m| (*basis, m)));
    for (i, ((basis, measurand), merged)) in kinds.zip(merged).enumerate() {
        let histogram = histograms.of(i);
        let stream = &merged.stream;
        figures.push(Figures {
            over: over(&measurand.name),
            max_ulp: measurand.ulp.map(|ulp| stream.max / ulp),
            witness: merged.witness.clone(),
            ..stream.figures(&measurand.name, measurand.unit(), basis, &histogram)
        });
    }
    figures
}

/// Those of some `narrow` nodes that overflowed.
pub(crate) fn overflow_counts(
    netlist: &Netlist,
    narrows: &[NodeId],
    counts: &[u64],
) -> Vec<OverflowCount> {
    narrows
        .iter()
        .zip(counts)
        .filter(|(_, count)| **count > 0)
        .map(|(id, count)| OverflowCount {
            node: netlist.label(*id),
            mode: netlist.node(*id).op.overflow().expect("bug: only narrows are counted").name(),
            count: *count,
        })
        .collect()
}
