//! Input files. Each is opened here and remembered, so that no output overwrites it.

use crate::base::cast;
use crate::base::error::{Error, Result};
use crate::base::escape;
use std::collections::BTreeMap;
use std::fs::{self, File, FileType, Metadata, OpenOptions};
use std::io::{self, Read, StdinLock, Write as _};
use std::path::{self, Path, PathBuf};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Duration;

/// How long to wait for the other end of a pipe before reporting it.
const PIPE_WAIT: Duration = Duration::from_secs(3);

/// Identifies a file regardless of its name.
#[cfg(unix)]
type Identity = (u64, u64);
#[cfg(not(unix))]
type Identity = PathBuf;

#[cfg(unix)]
fn identity(_: &Path, there: &Metadata) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt;
    Some((there.dev(), there.ino()))
}

#[cfg(not(unix))]
fn identity(path: &Path, _: &Metadata) -> Option<Identity> {
    path.canonicalize().ok()
}

/// True if both paths lead to the same file.
pub(crate) fn same_file(a: &Path, b: &Path) -> bool {
    let of = |path: &Path| identity(path, &fs::metadata(path).ok()?);
    of(a).is_some_and(|a| Some(a) == of(b))
}

/// True if an open file is still the one at `path`.
#[cfg(unix)]
pub(crate) fn is_at(file: &File, path: &Path) -> bool {
    let of = |there: io::Result<Metadata>| identity(path, &there.ok()?);
    of(file.metadata()).is_some_and(|file| Some(file) == of(fs::metadata(path)))
}

/// Without inodes, an open file is assumed to be still in place.
#[cfg(not(unix))]
pub(crate) fn is_at(_: &File, _: &Path) -> bool {
    true
}

/// A file that was read: its path as given, and its absolute path.
struct Known {
    given: PathBuf,
    absolute: PathBuf,
}

/// All files read so far.
static READ: Mutex<BTreeMap<Identity, Known>> = Mutex::new(BTreeMap::new());

/// Records that a file is read. Refuses a file that standard output is redirected to.
fn remember(given: &Path, absolute: PathBuf) -> Result<()> {
    let there = fs::metadata(&absolute).ok().filter(Metadata::is_file);
    let Some(identity) = there.and_then(|there| identity(&absolute, &there)) else {
        return Ok(());
    };
    if same_file(&absolute, Path::new("/dev/stdout")) {
        let problem = "is also the standard output: redirect the output elsewhere".to_owned();
        return Err(Error::file(given, problem));
    }
    let known = Known { given: given.to_owned(), absolute };
    READ.lock().unwrap_or_else(PoisonError::into_inner).insert(identity, known);
    Ok(())
}

/// The input file that `path` leads to, directly or through a symbolic or hard link.
pub(crate) fn input_at(path: &Path) -> Option<PathBuf> {
    let there = fs::metadata(path).ok().filter(Metadata::is_file)?;
    let read = READ.lock().unwrap_or_else(PoisonError::into_inner);
    let known = read.get(&identity(path, &there)?)?;
    // The inode of a deleted file may have been reused.
    same_file(path, &known.absolute).then(|| known.given.clone())
}

/// What `path` leads to, if that isn't a regular file.
fn kind(of: FileType) -> &'static str {
    if of.is_dir() {
        return "a folder";
    }
    if is_pipe(of) { "a pipe" } else { "a device or a socket" }
}

#[cfg(unix)]
fn is_pipe(of: FileType) -> bool {
    std::os::unix::fs::FileTypeExt::is_fifo(&of)
}

#[cfg(not(unix))]
fn is_pipe(_: FileType) -> bool {
    false
}

/// Opens an existing path. For a pipe, waits indefinitely for the other end, since it may be a slow
/// program. After [`PIPE_WAIT`], prints a note that says what it waits for, since the other end may
/// never open.
pub(crate) fn open_with(options: &OpenOptions, path: &Path) -> io::Result<File> {
    if !fs::metadata(path).is_ok_and(|there| is_pipe(there.file_type())) {
        return options.open(path);
    }
    let (sender, receiver) = mpsc::channel::<()>();
    let at = path.to_owned();
    thread::Builder::new().spawn(move || {
        if receiver.recv_timeout(PIPE_WAIT) == Err(RecvTimeoutError::Timeout) {
            let told = format!("{}: waiting for the other end of this pipe", at.display());
            // A lost stderr changes nothing.
            let _ = writeln!(io::stderr(), "note: {}", escape::message(&told));
        }
    })?;
    let opened = options.open(path);
    // The send fails only if the thread has already printed its note and ended.
    let _ = sender.send(());
    opened
}

fn absolute(path: &Path) -> PathBuf {
    path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// Opens a file, a pipe or a device for reading.
///
/// # Errors
/// If it can't be read, or is a folder.
pub(crate) fn open(path: &Path) -> Result<File> {
    let fail = |why| Error::io(path, "can't read", why);
    let there = fs::metadata(path).map_err(fail)?;
    if there.is_dir() {
        return Err(Error::file(path, "can't read: it is a folder".to_owned()));
    }
    let file = open_with(OpenOptions::new().read(true), path).map_err(fail)?;
    remember(path, absolute(path))?;
    Ok(file)
}

/// Opens a file that another file names. Refuses pipes, which might block forever.
///
/// # Errors
/// If it can't be read, or is not a regular file.
pub(crate) fn open_regular(path: &Path) -> Result<File> {
    let there = fs::metadata(path).map_err(|why| Error::io(path, "can't read", why))?;
    if !there.is_file() {
        let kind = kind(there.file_type());
        return Err(Error::file(
            path,
            format!("can't read: it is {kind}; a regular file is needed"),
        ));
    }
    open(path)
}

/// The standard input.
///
/// # Errors
/// If standard output is the same file.
pub(crate) fn stdin() -> Result<StdinLock<'static>> {
    remember(Path::new("standard input"), PathBuf::from("/dev/stdin"))?;
    Ok(io::stdin().lock())
}

/// The whole content of an open file; `None` if it has more than `max_bytes` bytes. `path` names it
/// in messages.
///
/// # Errors
/// If it can't be read.
pub(crate) fn read_up_to(file: File, path: &Path, max_bytes: u64) -> Result<Option<Vec<u8>>> {
    let mut bytes = Vec::new();
    let read = file.take(max_bytes.saturating_add(1)).read_to_end(&mut bytes);
    read.map_err(|why| Error::io(path, "can't read", why))?;
    Ok((cast::count_of(bytes.len()) <= max_bytes).then_some(bytes))
}

/// The whole content of an open file of at most `max_bytes` bytes.
///
/// # Errors
/// If it can't be read, or is longer.
pub(crate) fn read(file: File, path: &Path, max_bytes: u64) -> Result<Vec<u8>> {
    read_up_to(file, path, max_bytes)?.ok_or_else(|| {
        let problem = format!("is larger than the maximum of {max_bytes} bytes");
        Error::file(path, problem)
    })
}

/// The whole text of a file of at most `max_bytes`.
///
/// # Errors
/// If it can't be read, isn't UTF-8, or is longer.
pub(crate) fn text(path: &Path, max_bytes: u64) -> Result<String> {
    let bytes = read(open(path)?, path, max_bytes)?;
    check_encoding(&bytes).map_err(|problem| Error::file(path, problem))?;
    String::from_utf8(bytes)
        .map_err(|why| Error::file(path, format!("isn't UTF-8 text: {}", why.utf8_error())))
}

/// Refuses text whose first bytes say that it is in another encoding than UTF-8.
pub(crate) fn check_encoding(bytes: &[u8]) -> Result<(), String> {
    let marks: [(&[u8], &str); 4] = [
        (b"\xff\xfe\0\0", "UTF-32"),
        (b"\0\0\xfe\xff", "UTF-32"),
        (b"\xff\xfe", "UTF-16"),
        (b"\xfe\xff", "UTF-16"),
    ];
    match marks.iter().find(|(mark, _)| bytes.starts_with(mark)) {
        Some((_, name)) => Err(format!("the text is {name}: save it as UTF-8")),
        None => Ok(()),
    }
}
