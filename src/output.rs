//! Writing files whole or not at all.

use crate::error::{Error, Result};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Temporary files being written now.
static TEMPORARY: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Removes the temporary files of writes under way; for a handler of interrupts, which ends
/// the process next.
pub(crate) fn abandon() {
    for path in &*TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner) {
        // What can't be removed can't be helped any more.
        let _ = fs::remove_file(path);
    }
}

/// Makes a folder and those above it.
///
/// # Errors
/// If it can't be made; names it.
pub fn make_folder(path: &Path) -> Result<()> {
    fs::create_dir_all(path).map_err(|why| Error::io(path, "can't make the folder", why))
}

/// Writes a file through a temporary one beside it, which takes its name when it is complete;
/// whatever was there stays until then. What is no regular file (`/dev/stdout`, a pipe) is
/// written directly.
///
/// # Errors
/// If the file can't be written, or `body` fails; nothing of it is left then.
pub fn write_file(path: &Path, body: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    // Without the temporary file's name, which says nothing to anyone.
    let fail = |why: io::Error| {
        let plain = why.raw_os_error().map(io::Error::from_raw_os_error);
        let inner = why.get_ref().and_then(|inner| inner.source()?.downcast_ref::<io::Error>());
        let plain = plain.or_else(|| inner?.raw_os_error().map(io::Error::from_raw_os_error));
        Error::io(path, "can't write", plain.unwrap_or(why))
    };
    if fs::metadata(path).is_ok_and(|there| !there.is_file()) {
        let file = File::options().write(true).open(path).map_err(fail)?;
        let mut writer = BufWriter::new(file);
        body(&mut writer)?;
        return writer.flush().map_err(fail);
    }
    // A link stays a link: what it points to is written.
    let real = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let folder = match real.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        Some(_) | None => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".fixpath-");
    #[cfg(unix)]
    {
        // As a new file would have it, not as a secret: the process's mask still applies.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let file = builder.tempfile_in(folder).map_err(fail)?;
    let temporary = file.path().to_owned();
    let known = || TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner);
    known().insert(temporary.clone());
    let mut writer = BufWriter::with_capacity(1 << 16, file);
    let written = body(&mut writer).and_then(|()| {
        let file = writer.into_inner().map_err(|why| fail(why.into_error()))?;
        file.persist(&real).map_err(|why| fail(why.error))?;
        Ok(())
    });
    known().remove(&temporary);
    written
}

/// Names the file in an error of writing to it.
pub(crate) fn at(path: &Path) -> impl Fn(io::Error) -> Error {
    move |why| Error::io(path, "can't write", why)
}
