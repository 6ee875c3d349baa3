//! `fixpath sweep`.

use super::progress::progress_bar;
use super::text;
use crate::base::cast;
use crate::base::error::Result;
use crate::measure::Profile;
use crate::sweep::Sweep;
use std::path::Path;

/// Runs a sweep into a folder; returns the text to print.
pub(super) fn run_sweep(sweep: &Sweep, out: &Path, fresh: bool, profile: bool) -> Result<String> {
    let bar = progress_bar(cast::count_of(sweep.points()), "points");
    let record = sweep.run(out, fresh, &|progress| {
        bar.set_position(cast::count_of(progress.points_done));
    })?;
    bar.finish_and_clear();
    let mut told = text::sweep(&record, out);
    if profile {
        // Points that were already on disk took no time.
        let mut times = Profile::default();
        let measured = record.points.iter().filter_map(|point| point.measured.as_ref());
        measured.for_each(|measured| times.add(&measured.speed.profile));
        told += &text::profile(&times);
    }
    Ok(told)
}
