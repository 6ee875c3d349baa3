//! Runs all tools in parallel.

use super::request::{Job, Request, SLOW_VECTORS, Simulator};
use super::row::Row;
use super::simulators;
use crate::base::error::Result;
use crate::base::output::{Scratch, Set, copy_folder};
use crate::base::outside;
use crate::design::Design;
use crate::hardware::emit::{Package, Settings};
use std::sync::mpsc;
use std::thread;

/// Runs a design's hardware in outside simulators, all in parallel. `progress` receives each row as
/// soon as it is ready. Rows are returned in the order requested.
///
/// # Errors
/// If the hardware can't be built, or files can't be written.
///
/// # Panics
/// If a simulator's thread panicked.
pub fn verify(design: &Design, request: &Request, progress: &dyn Fn(&Row)) -> Result<Vec<Row>> {
    let scratch = Scratch::new()?;
    let folder = scratch.path();
    let settings = Settings {
        tables: request.tables,
        memories: request.memories,
        random: request.vectors.unwrap_or(SLOW_VECTORS),
        seed: request.seed,
        figures: false,
        ..Settings::default()
    };
    let mut package = Package::new(design, &settings)?;
    // Before long work, check that the kept files can be written. They replace what `hdl` wrote
    // under this name.
    let set = package.set_name();
    let kept = request.keep.as_deref().map(|keep| Set::open(keep, &set)).transpose()?;
    package.write_texts(folder, folder)?;
    let reads_file = |simulator: &Simulator| match simulator {
        Simulator::Icarus | Simulator::Ghdl => true,
        // Verilator gets the vectors through a pipe; a proof needs none.
        Simulator::Verilator | Simulator::Yosys => false,
    };
    if request.keep.is_some() || request.simulators.iter().any(reads_file) {
        package.write_vectors(folder)?;
    }
    let job = Job { design, request, package: &package, folder };
    let mut rows: Vec<(usize, Row)> = Vec::new();
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        for (at, simulator) in request.simulators.iter().enumerate() {
            let (sender, job) = (sender.clone(), &job);
            let again = sender.clone();
            let started = outside::new_thread().spawn_scoped(scope, move || {
                let row = simulators::run(job, *simulator);
                sender.send((at, row)).expect("bug: the receiver takes all rows");
            });
            if let Err(why) = started {
                let row = simulators::unusable(*simulator, outside::no_thread(&why));
                again.send((at, row)).expect("bug: the receiver takes all rows");
            }
        }
        drop(sender);
        for (at, row) in receiver {
            progress(&row);
            rows.push((at, row));
        }
    });
    if let Some(kept) = kept {
        copy_folder(folder, &kept.path())?;
        kept.commit()?;
    }
    assert_eq!(rows.len(), request.simulators.len(), "bug: one row a simulator");
    rows.sort_by_key(|(at, _)| *at);
    Ok(rows.into_iter().map(|(_, row)| row).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::Unit;
    use crate::hardware::verify::row::Verdict;

    #[test]
    fn a_tool_without_a_thread_is_unfinished() {
        let design = Unit::find("dot").unwrap().defaults().build().unwrap();
        let request =
            Request { simulators: Simulator::ALL.to_vec(), vectors: Some(1), ..Request::default() };
        outside::NO_THREADS.set(true);
        let rows = verify(&design, &request, &|_| ());
        outside::NO_THREADS.set(false);
        let rows = rows.unwrap();
        assert_eq!(rows.len(), Simulator::ALL.len());
        for row in rows {
            assert!(row.is_unfinished(), "{row:?}");
            let Verdict::Unusable(why) = row.verdict else { panic!("{}: it ran", row.tool) };
            assert!(why.starts_with("can't start a thread: "), "{why}");
        }
    }
}
