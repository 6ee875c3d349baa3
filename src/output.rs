//! Writing files whole or not at all.

use crate::error::{Error, Result};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

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
    let fail = |why: io::Error| Error::io(path, "can't write", why);
    if fs::metadata(path).is_ok_and(|there| !there.is_file()) {
        let file = File::options().write(true).open(path).map_err(fail)?;
        let mut writer = BufWriter::new(file);
        body(&mut writer)?;
        return writer.flush().map_err(fail);
    }
    let folder = match path.parent() {
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
    let mut writer = BufWriter::with_capacity(1 << 16, file);
    body(&mut writer)?;
    let file = writer.into_inner().map_err(|why| fail(why.into_error()))?;
    file.persist(path).map_err(|why| fail(why.error))?;
    Ok(())
}

/// Names the file in an error of writing to it.
pub(crate) fn at(path: &Path) -> impl Fn(io::Error) -> Error {
    move |why| Error::io(path, "can't write", why)
}
