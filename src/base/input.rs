//! Files that are read: each is opened here and remembered, so that nothing is written over it.

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

/// How long nobody may be at the other end of a pipe until that is told.
const PIPE_WAIT: Duration = Duration::from_secs(3);

/// What tells files apart, whatever their names.
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

/// True if two paths lead to one file.
pub(crate) fn same_file(a: &Path, b: &Path) -> bool {
    let of = |path: &Path| identity(path, &fs::metadata(path).ok()?);
    of(a).is_some_and(|a| Some(a) == of(b))
}

/// True if an open file is still the one at a path.
#[cfg(unix)]
pub(crate) fn is_at(file: &File, path: &Path) -> bool {
    let of = |there: io::Result<Metadata>| identity(path, &there.ok()?);
    of(file.metadata()).is_some_and(|file| Some(file) == of(fs::metadata(path)))
}

/// Open files stay where they are.
#[cfg(not(unix))]
pub(crate) fn is_at(_: &File, _: &Path) -> bool {
    true
}

/// A file that was read: its path as it was given, and from the root.
struct Known {
    given: PathBuf,
    absolute: PathBuf,
}

/// All that was read.
static READ: Mutex<BTreeMap<Identity, Known>> = Mutex::new(BTreeMap::new());

/// Keeps in mind that a file is read. A file that the standard output is appended to is refused.
fn remember(given: &Path, absolute: PathBuf) -> Result<()> {
    let there = fs::metadata(&absolute).ok().filter(Metadata::is_file);
    let Some(identity) = there.and_then(|there| identity(&absolute, &there)) else {
        return Ok(());
    };
    if same_file(&absolute, Path::new("/dev/stdout")) {
        let problem = "is the standard output as well: send that elsewhere".to_owned();
        return Err(Error::file(given, problem));
    }
    let known = Known { given: given.to_owned(), absolute };
    READ.lock().unwrap_or_else(PoisonError::into_inner).insert(identity, known);
    Ok(())
}

/// The input that a path leads to, by its name or another: a link, a second name.
pub(crate) fn input_at(path: &Path) -> Option<PathBuf> {
    let there = fs::metadata(path).ok().filter(Metadata::is_file)?;
    let read = READ.lock().unwrap_or_else(PoisonError::into_inner);
    let known = read.get(&identity(path, &there)?)?;
    // A file that is gone may have left its number to another.
    same_file(path, &known.absolute).then(|| known.given.clone())
}

/// What a path leads to, if that isn't a file.
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

/// Opens what is there. It waits for the other end of a pipe as long as it takes: who names a pipe
/// may have a slow program there. After [`PIPE_WAIT`] a note tells what it waits for, since nobody
/// may be there at all.
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
    // The thread ends without a word; if it has ended, the word is out.
    let _ = sender.send(());
    opened
}

fn absolute(path: &Path) -> PathBuf {
    path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// Opens a file, a pipe or a device to read it.
///
/// # Errors
/// If it can't be read or is a folder.
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

/// Opens a file that another file names: no pipe, since nobody may be there to write to it.
///
/// # Errors
/// If it can't be read, or is no regular file.
pub(crate) fn open_regular(path: &Path) -> Result<File> {
    let there = fs::metadata(path).map_err(|why| Error::io(path, "can't read", why))?;
    if !there.is_file() {
        let kind = kind(there.file_type());
        return Err(Error::file(path, format!("can't read: it is {kind}, and a file is needed")));
    }
    open(path)
}

/// The standard input.
///
/// # Errors
/// If it is the standard output as well.
pub(crate) fn stdin() -> Result<StdinLock<'static>> {
    remember(Path::new("standard input"), PathBuf::from("/dev/stdin"))?;
    Ok(io::stdin().lock())
}

/// The whole of an open file; `None` if it has more bytes than these. `path` names it in messages.
///
/// # Errors
/// If it can't be read.
pub(crate) fn read_up_to(file: File, path: &Path, max_bytes: u64) -> Result<Option<Vec<u8>>> {
    let mut bytes = Vec::new();
    let read = file.take(max_bytes.saturating_add(1)).read_to_end(&mut bytes);
    read.map_err(|why| Error::io(path, "can't read", why))?;
    Ok((cast::count_of(bytes.len()) <= max_bytes).then_some(bytes))
}

/// The whole of an open file of no more bytes than these.
///
/// # Errors
/// If it can't be read, or is longer.
pub(crate) fn read(file: File, path: &Path, max_bytes: u64) -> Result<Vec<u8>> {
    read_up_to(file, path, max_bytes)?.ok_or_else(|| {
        let problem = format!("has more than {max_bytes} bytes, the most that is read");
        Error::file(path, problem)
    })
}
