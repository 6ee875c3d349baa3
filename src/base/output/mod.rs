//! Writing files whole or not at all, and never over what is read.

mod scratch;
mod set;

pub use scratch::Scratch;
pub use set::Set;

use crate::base::error::{Error, Result};
use crate::base::input;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Removes what is not in its place yet; for a handler of interrupts, which ends the process next.
pub(crate) fn abandon() {
    scratch::abandon();
    set::abandon();
}

/// Makes a folder and those above it.
///
/// # Errors
/// If it can't be made; names it.
pub fn make_folder(path: &Path) -> Result<()> {
    fs::create_dir_all(path)
        .map_err(|why| Error::io(&set::in_place(path), "can't make the folder", why))
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
            fs::copy(&old, &new).map_err(at(&new))?;
        }
    }
    Ok(())
}

/// Refuses a path that can't be written, or leads to a file that this process reads.
///
/// # Errors
/// Always then; says why.
pub fn check(path: &Path) -> Result<()> {
    if let Some(input) = input::input_at(path) {
        let also = if input == path { String::new() } else { format!(" {}", input.display()) };
        return Err(Error::file(path, format!("is the input{also}: give another file to write")));
    }
    match fs::metadata(path) {
        Ok(there) if there.is_dir() => {
            Err(Error::file(path, "can't write: it is a folder".to_owned()))
        }
        // The folder may allow another file of the name where the file itself is to stay.
        Ok(there) if there.is_file() => {
            File::options().write(true).open(path).map(|_| ()).map_err(at(path))
        }
        Ok(_) | Err(_) => Ok(()),
    }
}

/// Writes a text file, as [`write_file`].
///
/// # Errors
/// As [`write_file`].
pub fn write_text(path: &Path, text: &str) -> Result<()> {
    write_file(path, |to| to.write_all(text.as_bytes()).map_err(at(path)))
}

/// Writes a file, which takes its place when it is complete; whatever was there stays until then, and
/// its mode and owner beyond that. What is no regular file (`/dev/stdout`, a pipe) is written directly.
///
/// # Errors
/// If the file can't be written or is one that this process reads, or `body` fails; nothing of it is
/// left then.
pub fn write_file(path: &Path, body: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    Draft::write(path, body)?.publish()
}

/// A file that is complete and not in its place yet.
#[derive(Debug)]
pub struct Draft {
    path: PathBuf,
    /// None of what was written directly.
    made: Option<Scratch>,
}

impl Draft {
    /// Writes it; see [`write_file`].
    ///
    /// # Errors
    /// As [`write_file`].
    pub fn write(path: &Path, body: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<Self> {
        check(path)?;
        let fail = at(path);
        let (made, file) = if fs::metadata(path).is_ok_and(|there| !there.is_file()) {
            (None, input::open_with(File::options().write(true), path))
        } else {
            let made = Scratch::within(&folder_of(&real_path(path)), ".fixpath-").map_err(&fail)?;
            let file = File::create_new(Self::draft(&made));
            (Some(made), file)
        };
        let mut writer = BufWriter::with_capacity(1 << 16, file.map_err(&fail)?);
        body(&mut writer)?;
        writer.flush().map_err(fail)?;
        Ok(Self { path: path.to_owned(), made })
    }

    /// Puts it into its place.
    ///
    /// # Errors
    /// If it can't be.
    pub fn publish(self) -> Result<()> {
        Self::publish_all([self])
    }

    /// Puts files into their places, one right after the other.
    ///
    /// # Errors
    /// If one of them can't be.
    pub fn publish_all<const N: usize>(drafts: [Self; N]) -> Result<()> {
        let held = scratch::hold();
        let place = |draft: &Self| match &draft.made {
            None => Ok(()),
            Some(made) => {
                place(&Self::draft(made), &real_path(&draft.path)).map_err(at(&draft.path))
            }
        };
        let placed = drafts.iter().try_for_each(place);
        drop(held);
        placed
    }

    fn draft(made: &Scratch) -> PathBuf {
        made.path().join("new")
    }
}

/// What a path leads to: a link stays a link.
fn real_path(path: &Path) -> PathBuf {
    match (fs::canonicalize(path), fs::read_link(path)) {
        (Ok(real), _) => real,
        // A link to what isn't there yet.
        (Err(_), Ok(target)) => folder_of(path).join(target),
        (Err(_), Err(_)) => path.to_owned(),
    }
}

fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
        Some(_) | None => PathBuf::from("."),
    }
}

/// Gives a file its name; of a file that had it, mode and owner stay.
fn place(from: &Path, to: &Path) -> io::Result<()> {
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

/// Names the file in an error of writing to it.
pub(crate) fn at(path: &Path) -> impl Fn(io::Error) -> Error {
    move |why| Error::io(&set::in_place(path), "can't write", why)
}

/// The same for a writer of CSV, whose errors hold that of the file.
#[expect(clippy::wildcard_enum_match_arm, reason = "a foreign enum that may grow")]
pub(crate) fn csv_at(path: &Path) -> impl Fn(csv::Error) -> Error + Copy {
    move |why| match why.into_kind() {
        csv::ErrorKind::Io(why) => at(path)(why),
        kind => panic!("bug: rows of equal length can be written: {kind:?}"),
    }
}
