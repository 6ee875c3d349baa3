//! Folders for files that are temporary or not yet in place.

use crate::base::error::{Error, Result};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Folders in use.
static SCRATCH: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Folders that were already searched for leftovers of killed runs.
static SWEPT: Mutex<BTreeSet<(PathBuf, String)>> = Mutex::new(BTreeSet::new());

/// Number of the next folder.
static NEXT: AtomicU64 = AtomicU64::new(0);

/// While the guard is held, no interrupt ends the process, and no scratch folder is made or
/// removed.
pub(super) fn hold() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    SCRATCH.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes all folders in use. For the interrupt handler, which then ends the process.
pub(super) fn abandon() {
    let folders = hold();
    for folder in &*folders {
        // A tool may still write a last file. The next run sweeps what can't be removed.
        let _ = fs::remove_dir_all(folder).or_else(|_| fs::remove_dir_all(folder));
    }
    // Locked forever: no other thread makes a folder before the process ends.
    std::mem::forget(folders);
}

/// A temporary folder, removed on drop. If the run is killed, the next run that makes one in the
/// same place removes it.
#[derive(Debug)]
pub struct Scratch {
    folder: PathBuf,
    /// Held until the folder is removed: an unlocked folder belongs to a dead run.
    _lock: Option<File>,
}

impl Scratch {
    /// Makes a folder in the system's temporary folder, at a path that shells and makefiles accept
    /// unquoted, since outside tools pass it on unquoted.
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
                "outside tools can't work in `{}`: set TMPDIR to a folder whose path has only letters, \
                 digits, `.`, `_` and `-`",
                given.display()
            )));
        };
        Self::within(&place, "fixpath-")
            .map_err(|why| Error::io(&place, "can't make a folder in it", why))
    }

    /// Makes a folder inside `place`, with a name that starts with `prefix`.
    pub(super) fn within(place: &Path, prefix: &str) -> io::Result<Self> {
        // Locks on folders don't reach other machines that share `place`.
        let prefix = format!("{prefix}{}-", machine());
        sweep(place, &prefix);
        let mut known = hold();
        loop {
            let number = NEXT.fetch_add(1, Ordering::Relaxed);
            let folder = place.join(format!("{prefix}{}-{number}", std::process::id()));
            match make(&folder) {
                Err(why) if why.kind() == io::ErrorKind::AlreadyExists => continue,
                made => made?,
            }
            let lock = lock(&folder);
            // Another run may have swept it before it was locked.
            if folder.is_dir() && !matches!(lock, Lock::Others) {
                known.insert(folder.clone());
                let _lock = if let Lock::Ours(file) = lock { Some(file) } else { None };
                return Ok(Self { folder, _lock });
            }
        }
    }

    /// The folder.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.folder
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let mut known = hold();
        // A later run sweeps what can't be removed.
        let _ = fs::remove_dir_all(&self.folder);
        known.remove(&self.folder);
    }
}

/// Makes a folder that only this user can access.
fn make(folder: &Path) -> io::Result<()> {
    let mut builder = fs::DirBuilder::new();
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.create(folder)
}

/// Who holds the lock on a folder.
enum Lock {
    /// This run, until the file is closed.
    Ours(File),
    Others,
    /// Nobody: the system has no such locks.
    Unknown,
}

fn lock(folder: &Path) -> Lock {
    let Ok(file) = File::open(folder) else { return Lock::Unknown };
    match file.try_lock() {
        Ok(()) => Lock::Ours(file),
        Err(fs::TryLockError::WouldBlock) => Lock::Others,
        Err(fs::TryLockError::Error(_)) => Lock::Unknown,
    }
}

/// Removes folders left by killed runs on this machine; once per run.
fn sweep(place: &Path, prefix: &str) {
    let place_and_prefix = (place.to_owned(), prefix.to_owned());
    let is_first = SWEPT.lock().unwrap_or_else(PoisonError::into_inner).insert(place_and_prefix);
    let Some(entries) = is_first.then(|| fs::read_dir(place).ok()).flatten() else { return };
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    for entry in entries.flatten() {
        let name = entry.file_name();
        let rest = name.to_str().and_then(|name| name.strip_prefix(prefix)?.split_once('-'));
        let is_ours = rest.is_some_and(|(id, number)| is_number(id) && is_number(number))
            && entry.file_type().is_ok_and(|kind| kind.is_dir());
        if is_ours && let Lock::Ours(_lock) = lock(&entry.path()) {
            // Another user's folder stays.
            let _ = fs::remove_dir_all(entry.path());
        }
    }
}

/// The name of this machine, restricted to characters that are legal in any path.
fn machine() -> String {
    #[cfg(unix)]
    let name = rustix::system::uname().nodename().to_string_lossy().into_owned();
    #[cfg(not(unix))]
    let name = String::new();
    name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect()
}
