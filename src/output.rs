//! Writing files whole or not at all.

use crate::error::{Error, Result};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Temporary files being written now.
static TEMPORARY: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Scratch folders in use.
static SCRATCH: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Removes scratch folders and the temporary files of writes under way; for a handler of
/// interrupts, which ends the process next.
pub(crate) fn abandon() {
    let folders = SCRATCH.lock().unwrap_or_else(PoisonError::into_inner);
    for folder in &*folders {
        // A tool's last file may come in between.
        let _ = fs::remove_dir_all(folder).or_else(|_| fs::remove_dir_all(folder));
    }
    // Locked for ever: other threads make no new ones until the process ends.
    std::mem::forget(folders);
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

/// Copies all that a folder holds into another that is there.
///
/// # Errors
/// If a file can't be read or written.
pub fn copy_folder(from: &Path, to: &Path) -> Result<()> {
    let unreadable = |why| Error::io(from, "can't read", why);
    for entry in fs::read_dir(from).map_err(unreadable)? {
        let entry = entry.map_err(unreadable)?;
        let (old, new) = (entry.path(), to.join(entry.file_name()));
        if entry.file_type().map_err(unreadable)?.is_dir() {
            make_folder(&new)?;
            copy_folder(&old, &new)?;
        } else {
            fs::copy(&old, &new).map_err(|why| Error::io(&new, "can't write", why))?;
        }
    }
    Ok(())
}

/// A folder for files of no further use, which goes with it.
#[derive(Debug)]
pub struct Scratch(tempfile::TempDir);

impl Scratch {
    /// Makes one where the system keeps such folders, with a path that shells and makefiles take
    /// as it is: outside tools pass it on to them unquoted.
    ///
    /// # Errors
    /// If it can't be made, or no such path is known.
    pub fn new() -> Result<Self> {
        let given = std::env::temp_dir();
        let plain = |path: &PathBuf| {
            let is_plain = |c: char| c.is_ascii_alphanumeric() || "/._-".contains(c);
            path.is_absolute() && path.to_str().is_some_and(|text| text.chars().all(is_plain))
        };
        let usual = ["/tmp", "/var/tmp"].map(PathBuf::from);
        let Some(place) = std::iter::once(given.clone()).chain(usual).find(plain) else {
            return Err(Error::usage(format!(
                "outside tools can't work in `{}`: set TMPDIR to a folder whose path has letters, \
                 digits, `.`, `_`, `-` alone",
                given.display()
            )));
        };
        let fail = |why| Error::io(&place, "can't make a folder in it", why);
        let mut known = SCRATCH.lock().unwrap_or_else(PoisonError::into_inner);
        let folder =
            tempfile::Builder::new().prefix("fixpath-").tempdir_in(&place).map_err(fail)?;
        known.insert(folder.path().to_owned());
        Ok(Self(folder))
    }

    /// The folder.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.0.path()
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        SCRATCH.lock().unwrap_or_else(PoisonError::into_inner).remove(self.0.path());
    }
}

/// Writes a text file, as [`write_file`].
///
/// # Errors
/// As [`write_file`].
pub fn write_text(path: &Path, text: &str) -> Result<()> {
    write_file(path, |to| to.write_all(text.as_bytes()).map_err(at(path)))
}

/// Writes a file through a temporary one beside it, which takes its name when it is complete;
/// whatever was there stays until then. What is no regular file (`/dev/stdout`, a pipe) is
/// written directly.
///
/// # Errors
/// If the file can't be written, or `body` fails; nothing of it is left then.
pub fn write_file(path: &Path, body: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    let fail = |why: io::Error| Error::io(path, "can't write", why);
    if fs::metadata(path).is_ok_and(|there| !there.is_file()) {
        let file = File::options().write(true).open(path).map_err(fail)?;
        let mut writer = BufWriter::new(file);
        body(&mut writer)?;
        return writer.flush().map_err(fail);
    }
    // A link stays a link: what it points to is written.
    let real = match (fs::canonicalize(path), fs::read_link(path)) {
        (Ok(real), _) => real,
        // A link to what isn't there yet.
        (Err(_), Ok(target)) => path.parent().unwrap_or(Path::new("")).join(target),
        (Err(_), Err(_)) => path.to_owned(),
    };
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
    // The plain kind of error: the temporary file's name says nothing to anyone.
    let file = builder.tempfile_in(folder).map_err(|why| fail(why.kind().into()))?;
    let (file, temporary_path) = file.into_parts();
    let temporary = temporary_path.to_path_buf();
    let known = || TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner);
    known().insert(temporary.clone());
    let mut writer = BufWriter::with_capacity(1 << 16, file);
    let written = body(&mut writer).and_then(|()| {
        writer.into_inner().map_err(|why| fail(why.into_error()))?;
        temporary_path.persist(&real).map_err(|why| fail(why.error))
    });
    known().remove(&temporary);
    written
}

/// Names the file in an error of writing to it.
pub(crate) fn at(path: &Path) -> impl Fn(io::Error) -> Error {
    move |why| Error::io(path, "can't write", why)
}

/// The same for a writer of CSV, whose errors hold that of the file.
#[expect(clippy::wildcard_enum_match_arm, reason = "a foreign enum that may grow")]
pub(crate) fn csv_at(path: &Path) -> impl Fn(csv::Error) -> Error + Copy {
    move |why| match why.into_kind() {
        csv::ErrorKind::Io(why) => at(path)(why),
        kind => panic!("bug: rows of equal length can be written: {kind:?}"),
    }
}
