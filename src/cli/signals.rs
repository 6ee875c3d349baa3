//! Signals that end a run: no half-written file stays behind, and the exit code shows which signal
//! it was.

use crate::base::error::Result;

/// Watches for signals from now on.
///
/// # Errors
/// If the watching thread can't start.
#[cfg(unix)]
pub(super) fn watch() -> Result<()> {
    use crate::base::error::Error;
    use crate::base::{output, outside};
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
    use std::io::{self, Write};
    use std::sync::Arc;

    let fail = |why: io::Error| Error::usage(format!("can't watch for signals: {why}"));
    // A write past the limit on file sizes then fails with an error instead of ending the process.
    signal_hook::flag::register(SIGXFSZ, Arc::default()).map_err(fail)?;
    // A run under nohup, or in the background of a script, must go on ignoring these signals.
    let ignored = ignored();
    let heeded = [SIGINT, SIGTERM, SIGHUP].into_iter().filter(|signal| !ignored(*signal));
    let mut signals = signal_hook::iterator::Signals::new(heeded).map_err(fail)?;
    let watch = move || {
        if let Some(signal) = signals.forever().next() {
            outside::abandon();
            output::abandon();
            let _ = writeln!(
                io::stderr(),
                "interrupted: what was finished is saved, nothing half-written is left"
            );
            // The exit code that shells use.
            std::process::exit(128 + signal);
        }
    };
    std::thread::Builder::new().name("signals".to_owned()).spawn(watch).map_err(fail)?;
    Ok(())
}

/// The signals that this process was started to ignore, if the system lists them in `/proc`.
#[cfg(unix)]
fn ignored() -> impl Fn(i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    move |signal| mask >> (signal - 1) & 1 == 1
}

/// The system ends the run; the next run removes its leftovers.
#[cfg(not(unix))]
pub(super) fn watch() -> Result<()> {
    Ok(())
}
