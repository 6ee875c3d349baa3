//! Final paths of files, and errors that name them.

use crate::base::error::Error;
use std::fs::{self};
use std::io::{self};
use std::path::{Component, Path, PathBuf};

/// Folder inside an output folder that records what was written there.
pub(super) const STATE: &str = ".fixpath";

/// Folder for the files inside a scratch folder or journal.
pub(super) const FILES: &str = "files";

/// The final path of a file in a set's side folder; other paths unchanged.
pub(super) fn in_place(path: &Path) -> PathBuf {
    let parts: Vec<Component<'_>> = path.components().collect();
    let is_side = |at: usize| parts[at].as_os_str() == STATE && parts[at + 2].as_os_str() == FILES;
    match (0..parts.len().saturating_sub(2)).find(|at| is_side(*at)) {
        Some(at) => in_place(&parts[..at].iter().chain(&parts[at + 3..]).collect::<PathBuf>()),
        None => path.to_owned(),
    }
}

/// Turns an I/O error into one that names the file being written.
pub(crate) fn at(path: &Path) -> impl Fn(io::Error) -> Error {
    move |why| Error::io(&in_place(path), "can't write", why)
}

/// [`at`] for a CSV writer, whose errors wrap the file's.
#[expect(clippy::wildcard_enum_match_arm, reason = "a foreign enum that may grow")]
pub(crate) fn csv_at(path: &Path) -> impl Fn(csv::Error) -> Error + Copy {
    move |why| match why.into_kind() {
        csv::ErrorKind::Io(why) => at(path)(why),
        kind => panic!("bug: rows of equal length can be written: {kind:?}"),
    }
}

/// Follows a link, so that writing to it keeps the link.
pub(super) fn real_path(path: &Path) -> PathBuf {
    match (fs::canonicalize(path), fs::read_link(path)) {
        (Ok(real), _) => real,
        // A dangling link.
        (Err(_), Ok(target)) => folder_of(path).join(target),
        (Err(_), Err(_)) => path.to_owned(),
    }
}

pub(super) fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
        Some(_) | None => PathBuf::from("."),
    }
}

/// Renames `from` to `to`. A file that is replaced passes on its mode and owner.
pub(super) fn place(from: &Path, to: &Path) -> io::Result<()> {
    if let Ok(there) = fs::metadata(to) {
        #[cfg(unix)]
        {
            use std::os::unix::fs::{MetadataExt, chown};
            // Only root may change an owner. Done before the mode, since it clears mode bits.
            let _ = chown(from, Some(there.uid()), Some(there.gid()));
        }
        fs::set_permissions(from, there.permissions())?;
    }
    fs::rename(from, to)
}
