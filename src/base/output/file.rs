//! Files that are written whole or not at all.

use super::place::{at, folder_of, place, real_path};
use super::scratch::{self, Scratch};
use crate::base::error::{Error, Result};
use crate::base::input;
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// Refuses a path that can't be written, or that leads to a file that this process reads.
///
/// # Errors
/// If the path is refused; the message says why.
pub fn check(path: &Path) -> Result<()> {
    if let Some(input) = input::input_at(path) {
        let also = if input == path { String::new() } else { format!(" {}", input.display()) };
        return Err(Error::file(path, format!("is the input{also}: choose another output file")));
    }
    match fs::metadata(path) {
        Ok(there) if there.is_dir() => {
            Err(Error::file(path, "can't write: it is a folder".to_owned()))
        }
        // The folder may allow replacing a file that is itself read-only: keep it.
        Ok(there) if there.is_file() => {
            File::options().write(true).open(path).map(|_| ()).map_err(at(path))
        }
        Ok(_) | Err(_) => Ok(()),
    }
}

/// Writes a text file; see [`write_file`].
///
/// # Errors
/// As [`write_file`].
pub fn write_text(path: &Path, text: &str) -> Result<()> {
    write_file(path, |to| to.write_all(text.as_bytes()).map_err(at(path)))
}

/// Writes a file and moves it into place when it is complete. An existing file stays until then,
/// and the new one inherits its mode and owner. A path that is not a regular file (`/dev/stdout`, a
/// pipe) is written directly.
///
/// # Errors
/// If the file can't be written, if this process reads it, or if `body` fails; no partial file is
/// left.
pub fn write_file(path: &Path, body: impl FnOnce(&mut dyn Write) -> Result<()>) -> Result<()> {
    Draft::write(path, body)?.publish()
}

/// A file that is complete but not yet in place.
#[derive(Debug)]
pub struct Draft {
    path: PathBuf,
    /// `None` if the path was written directly.
    made: Option<Scratch>,
}

impl Draft {
    /// Writes the draft; see [`write_file`].
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

    /// Moves it into place.
    ///
    /// # Errors
    /// If that fails.
    pub fn publish(self) -> Result<()> {
        Self::publish_all([self])
    }

    /// Moves several files into place, one right after the other.
    ///
    /// # Errors
    /// If one of them can't be moved.
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
