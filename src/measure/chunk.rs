//! Runs compiled designs over a chunk of samples.

use super::golden::{as_golden, run_golden};
use super::inputs::{Inputs, quantize_inputs, values_of};
use super::measurand::Measurand;
use super::report::{Basis, Lap, Profile, Witness};
use super::stream::{Counts, Histograms, Stream};
use crate::base::cast;
use crate::base::error::Result;
use crate::design::Design;
use crate::netlist::NodeId;
use crate::sim::batch::{Program, Runner};
use crate::sim::real;
use std::time::Instant;

/// A compiled design.
pub(super) struct Compiled<'a> {
    pub(super) design: &'a Design,
    pub(super) bases: &'a [Basis],
    pub(super) program: Program,
    pub(super) reals: real::Program,
    pub(super) judged: Vec<NodeId>,
    pub(super) measurands: Vec<Measurand>,
    /// The index of its set of quantised inputs.
    pub(super) set: usize,
}

impl Compiled<'_> {
    /// Number of measurands times bases.
    pub(super) fn streams(&self) -> usize {
        self.measurands.len() * self.bases.len()
    }
}

/// Designs with the same input words and the same golden model.
pub(super) struct Set<'a> {
    /// One of the designs.
    pub(super) design: &'a Design,
    /// The set that draws the values before quantisation, and their golden, for this one.
    pub(super) drawn: usize,
}

/// Columns of one thread for one design.
pub(super) struct Lanes<'a> {
    runner: Runner,
    real_runner: real::Runner,
    words: Vec<Vec<i64>>,
    values: Vec<Vec<f64>>,
    reals: Vec<Vec<f64>>,
    counts: Counts<'a>,
}

/// Columns of one thread that all designs share.
#[derive(Default)]
pub(super) struct Shared {
    sets: Vec<SetColumns>,
    bit_true: Vec<Vec<f64>>,
    real: Vec<Vec<f64>>,
    errors: Vec<f64>,
}

/// Columns of a set of designs.
#[derive(Clone, Default)]
struct SetColumns {
    /// Inputs before quantisation, and their golden; empty if another set draws them.
    values: Vec<Vec<f64>>,
    real_golden: Vec<Vec<f64>>,
    words: Vec<Vec<i64>>,
    quantised: Vec<Vec<f64>>,
    golden: Vec<Vec<f64>>,
}

/// The results of a chunk for one design.
pub(super) struct Partial {
    pub(super) streams: Vec<(Stream, Witness)>,
    pub(super) overflows: Vec<u64>,
    pub(super) profile: Profile,
}

pub(super) fn new_lanes<'a>(c: &Compiled<'_>, all: &'a Histograms) -> Lanes<'a> {
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

/// A run of consecutive samples.
pub(super) struct Chunk<'a> {
    pub(super) inputs: &'a Inputs,
    pub(super) from: u64,
    pub(super) len: usize,
}

pub(super) fn measure_chunk(
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
    // For samplers of words, the words are the real inputs.
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
        lanes.runner.run_quantised(&c.program, &words, &mut lanes.words)?;
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
