//! Where files go, and errors that name it.

use crate::base::error::Error;
use std::fs::{self};
use std::io::{self};
use std::path::{Component, Path, PathBuf};

/// Folder in an output folder that tells what was written there.
pub(super) const STATE: &str = ".fixpath";

/// Folder in a scratch folder or journal there, for the files.
pub(super) const FILES: &str = "files";

/// Where a file of a set will be, if that is a path in its side folder.
pub(super) fn in_place(path: &Path) -> PathBuf {
    let parts: Vec<Component<'_>> = path.components().collect();
    let is_side = |at: usize| parts[at].as_os_str() == STATE && parts[at + 2].as_os_str() == FILES;
    match (0..parts.len().saturating_sub(2)).find(|at| is_side(*at)) {
        Some(at) => in_place(&parts[..at].iter().chain(&parts[at + 3..]).collect::<PathBuf>()),
        None => path.to_owned(),
    }
}

/// Names the file in an error of writing to it.
pub(crate) fn at(path: &Path) -> impl Fn(io::Error) -> Error {
    move |why| Error::io(&in_place(path), "can't write", why)
}

/// The same for a writer of CSV, whose errors hold that of the file.
#[expect(clippy::wildcard_enum_match_arm, reason = "a foreign enum that may grow")]
pub(crate) fn csv_at(path: &Path) -> impl Fn(csv::Error) -> Error + Copy {
    move |why| match why.into_kind() {
        csv::ErrorKind::Io(why) => at(path)(why),
        kind => panic!("bug: rows of equal length can be written: {kind:?}"),
    }
}

/// What a path leads to: a link stays a link.
pub(super) fn real_path(path: &Path) -> PathBuf {
    match (fs::canonicalize(path), fs::read_link(path)) {
        (Ok(real), _) => real,
        // A link to what isn't there yet.
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

/// Gives a file its name; of a file that had it, mode and owner stay.
pub(super) fn place(from: &Path, to: &Path) -> io::Result<()> {
    if let Ok(there) = fs::metadata(to) {
        #[cfg(unix)]
        {
            use std::os::unix::fs::{MetadataExt, chown};
            // Only root may give files away; before the mode, from which it takes bits.
            let _ = chown(from, Some(there.uid()), Some(there.gid()));
        }
        fs::set_permissions(from, there.permissions())?;
    }
    fs::rename(from, to)
}
