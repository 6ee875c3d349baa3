//! Measures designs together, chunk by chunk on all threads.

use super::chunk::{Chunk, Compiled, Lanes, Partial, Set, Shared, measure_chunk, new_lanes};
use super::inputs::{CHUNK, Inputs};
use super::measurand::Measurand;
use super::report::{Basis, Figures, Profile, Report, Speed, overflow_counts};
use super::stream::{Histograms, Merged};
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::design::Design;
use crate::sim::batch::{Program, check_overflows};
use crate::sim::real;
use rayon::prelude::*;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// Measures designs of one unit over the same inputs, on all bases; `progress` receives the number
/// of samples done.
///
/// # Errors
/// If an exhaustive run has more than 2^32 combinations, a `narrow` under overflow mode `error`
/// overflowed, or the designs belong to different units.
pub fn measure(
    designs: &[&Design],
    inputs: &Inputs,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Report>> {
    measure_on(&Basis::ALL, designs, inputs, progress)
}

/// As [`measure`], on some bases only, such as `measure_on(&[Basis::Total], &[&design], &inputs,
/// &|_| ())`; the work for the others is skipped.
/// [`BoundCheck`](crate::measure::BoundCheck) needs [`Basis::Total`].
///
/// # Errors
/// As [`measure`].
#[expect(clippy::missing_panics_doc, reason = "a chunk fits memory")]
pub fn measure_on(
    bases: &[Basis],
    designs: &[&Design],
    inputs: &Inputs,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Report>> {
    let Some(first) = designs.first() else { return Ok(Vec::new()) };
    if let Some(other) = designs.iter().find(|d| d.values.unit() != first.values.unit()) {
        let names = [first, other].map(|design| design.values.unit().name.as_str());
        let text = format!(
            "designs of different units, `{}` and `{}`, can't be measured together",
            names[0], names[1]
        );
        return Err(Error::usage(text));
    }
    designs.iter().try_for_each(|design| design.check_samples())?;
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
            reals: real::Program::compile_repeated(netlist, &judged, &repeats)?,
            judged,
            measurands: Measurand::all(design),
            set,
        });
    }
    let count = count.unwrap_or_default();

    let start = Instant::now();
    let chunks = count.div_ceil(CHUNK);
    let threads = rayon::current_num_threads();
    // A few chunks per thread at a time, so that memory doesn't grow with the number of samples.
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
    // Dropping the columns adds their counts to the histograms.
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

/// Columns that no thread uses at the moment. A run creates one set per thread.
struct Idle<T>(Mutex<Vec<T>>);

impl<T> Default for Idle<T> {
    fn default() -> Self {
        Self(Mutex::new(Vec::new()))
    }
}

impl<T> Idle<T> {
    // A panic elsewhere ends the run; the columns here are intact.
    fn take(&self) -> Option<T> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).pop()
    }

    fn give(&self, columns: T) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(columns);
    }
}

fn figures(c: &Compiled<'_>, merged: &[Merged], histograms: &Histograms) -> Vec<Figures> {
    let mut figures = Vec::new();
    let scales = c.design.scales();
    let over =
        |name: &str| scales.iter().find(|(scaled, _)| scaled == name).map(|(_, what)| what.clone());
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
