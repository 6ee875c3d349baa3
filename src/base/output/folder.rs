//! Making and copying folders.

use super::place::{at, in_place};
use crate::base::error::{Error, Result};
use std::fs::{self};
use std::path::Path;

/// Makes a folder and its parents.
///
/// # Errors
/// If it can't be made; the error names it.
pub fn make_folder(path: &Path) -> Result<()> {
    fs::create_dir_all(path).map_err(|why| Error::io(&in_place(path), "can't make the folder", why))
}

/// Copies the content of a folder into another existing folder.
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
