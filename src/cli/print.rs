//! What a command prints, and its notes.

use crate::base::error::Result;
use crate::base::{escape, output};
use crate::measure::samples::SampleFile;
use std::io::{self, Write as _};
use std::path::Path;

/// Tells what doesn't stop a command, and doesn't belong to its result.
pub(super) fn note(text: &str) {
    // A lost stderr changes nothing.
    let _ = writeln!(io::stderr(), "note: {}", escape::message(text));
}

/// Tells of values of a table that were clipped.
pub(super) fn note_clipped<R: io::Read>(samples: &SampleFile<'_, R>) {
    if let Some(text) = samples.clipped_note() {
        note(&text);
    }
}

/// Tells which of some options were given for nothing.
pub(super) fn note_unused(options: &[(&str, Option<u64>)], why: &str) {
    for (name, _) in options.iter().filter(|(_, given)| given.is_some()) {
        note(&format!("{name} changes nothing: {why}"));
    }
}

/// Writes to the standard output, and nothing that a terminal would act on. A reader that went away is no error, and
/// changes no verdict.
pub(super) fn print(text: &str) -> Result<()> {
    printed(io::stdout().lock().write_all(escape::lines(text).as_bytes()))
}

/// Whether all of what was written to the standard output got there.
pub(super) fn printed(written: io::Result<()>) -> Result<()> {
    match written.and_then(|()| io::stdout().flush()) {
        Err(why) if why.kind() != io::ErrorKind::BrokenPipe => {
            Err(output::at(Path::new("standard output"))(why))
        }
        Ok(()) | Err(_) => Ok(()),
    }
}
