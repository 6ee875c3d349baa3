//! What a command prints, and its notes.

use crate::base::error::Result;
use crate::base::{escape, output};
use crate::measure::samples::SampleFile;
use std::io::{self, Write as _};
use std::path::Path;

/// Prints a note that neither stops the command nor belongs to its result.
pub(super) fn note(text: &str) {
    // A failed write to stderr is ignored.
    let _ = writeln!(io::stderr(), "note: {}", escape::message(text));
}

/// Notes that values of a table were clipped.
pub(super) fn note_clipped<R: io::Read>(samples: &SampleFile<'_, R>) {
    if let Some(text) = samples.clipped_note() {
        note(&text);
    }
}

/// Notes which options were given without effect.
pub(super) fn note_unused(options: &[(&str, Option<u64>)], why: &str) {
    for (name, _) in options.iter().filter(|(_, given)| given.is_some()) {
        note(&format!("{name} has no effect: {why}"));
    }
}

/// Writes to standard output, with escapes for whatever a terminal would act on. A closed pipe is
/// not an error and doesn't change the verdict.
pub(super) fn print(text: &str) -> Result<()> {
    printed(io::stdout().lock().write_all(escape::lines(text).as_bytes()))
}

/// Whether everything written to standard output arrived.
pub(super) fn printed(written: io::Result<()>) -> Result<()> {
    match written.and_then(|()| io::stdout().flush()) {
        Err(why) if why.kind() != io::ErrorKind::BrokenPipe => {
            Err(output::at(Path::new("standard output"))(why))
        }
        Ok(()) | Err(_) => Ok(()),
    }
}
