//! `fixpath wave`: samples cycle by cycle.

use super::print::{note_clipped, note_unused};
use super::progress::progress_bar;
use super::shell;
use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::output::{self, Draft};
use crate::design::{Design, Sampler};
use crate::hardware::wave::{Options, Wave};
use crate::measure::samples::{Block, SampleFile};
use crate::measure::{self, Inputs};
use std::io;
use std::path::Path;

/// Largest number of samples in a wave; all are held in memory.
pub(super) const MAX_SAMPLES: u64 = 10_000_000;

/// Input words from a table, up to the end of the window.
pub(super) fn read_stimulus<R: io::Read>(
    mut samples: SampleFile<'_, R>,
    end: u64,
) -> Result<Vec<Vec<i64>>> {
    let (mut block, mut rows) = (Block::default(), Vec::new());
    loop {
        let count = samples.read(&mut block)?;
        rows.extend((0..count).map(|row| block.words.iter().map(|column| column[row]).collect()));
        if count == 0 || cast::count_of(rows.len()) >= end {
            note_clipped(&samples);
            return Ok(rows);
        }
        if cast::count_of(rows.len()) > MAX_SAMPLES {
            let problem = format!(
                "more than {MAX_SAMPLES} rows, the limit of a wave: --cycles 0..1e6 reads only the first"
            );
            return Err(Error::file(samples.path(), problem));
        }
    }
}

/// One vector of each hard case; then a full turn of the first input with the others fixed, for
/// smooth curves; then random vectors.
pub(super) fn stimulus(design: &Design, samples: u64, seed: Option<u64>) -> Result<Vec<Vec<i64>>> {
    const RAMP: u64 = 64;
    let mut rows: Vec<Vec<i64>> =
        design.hard.iter().filter_map(|case| case.words.first().cloned()).collect();
    let netlist = &design.netlist;
    for step in 0..RAMP {
        let ports = netlist.inputs().iter().enumerate().map(|(port, id)| {
            let format = netlist.node(*id).format;
            let share = if port == 0 { (step, RAMP) } else { (1, 4 + 3 * cast::count_of(port)) };
            let pattern = u128::from(format.words()) * u128::from(share.0) / u128::from(share.1);
            format.wrap(cast::word_of_bits(u64::try_from(pattern).expect("bug: below 2^63")))
        });
        rows.push(ports.collect());
    }
    if cast::count_of(rows.len()) >= samples {
        note_unused(&[("--seed", seed)], "hard cases and the curve fill all samples");
    }
    let inputs = Inputs { sampler: Sampler::Lit, samples, seed: seed.unwrap_or(1) };
    rows.extend(measure::sample_words(design, &inputs)?);
    rows.truncate(usize::try_from(samples).unwrap_or(usize::MAX));
    Ok(rows)
}

/// Writes a VCD and its save file; returns the text to print.
pub(super) fn write_wave(
    design: &Design,
    options: Options,
    samples: &[Vec<i64>],
    out: &Path,
) -> Result<String> {
    let save = out.with_extension("gtkw");
    let special = std::fs::metadata(out).is_ok_and(|there| !there.is_file() && !there.is_dir());
    if special || save == out || out == Path::new("-") {
        let problem = "no place for the save file: give a file that ends in .vcd";
        return Err(Error::file(&save, problem.to_owned()));
    }
    let window = options.cycles.clone();
    let wave = Wave::new(design, options)?;
    let latency = u64::from(wave.rtl().schedule().latency());
    let end = wave.cycles(samples.len());
    if let Some(window) = window.filter(|window| window.start >= end) {
        return Err(Error::usage(format!(
            "cycles {}..{} are past the end: there are {end}",
            window.start, window.end
        )));
    }
    let mut cycles = 0;
    // Check before the work starts.
    output::check(&save)?;
    let dump = Draft::write(out, |to| {
        let bar = progress_bar(end, "cycles");
        cycles = wave.write_with(samples, to, out, &|done| bar.set_position(done))?;
        bar.finish_and_clear();
        Ok(())
    })?;
    let save_file = Draft::write(&save, |to| wave.write_gtkw(out, to).map_err(output::at(&save)))?;
    Draft::publish_all([dump, save_file])?;
    Ok(format!(
        "{}: {cycles} cycles, {} signals, latency {}\nopen with: gtkwave {} {}\n",
        out.display(),
        wave.len(),
        latency,
        shell::word(out),
        shell::word(&save)
    ))
}
