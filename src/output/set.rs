//! Files that belong together.

use super::{Scratch, at, check, make_folder, place, real_path, scratch, write_file};
use crate::error::{Error, Result};
use crate::input;
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Component, Path, PathBuf};

/// Folder in an output folder that tells what was written there.
const STATE: &str = ".fixpath";

/// Folder in a scratch folder there, for the files.
const FILES: &str = "files";

/// The files that a command writes into a folder, where others' may be, too.
///
/// They are written into a side folder and take their places together, so that a run that is stopped
/// leaves all files of the run before. Files that the run before made and this one doesn't make go
/// then. A second run that wants to write the same set meanwhile is refused; what refuses it falls with
/// the process.
#[derive(Debug)]
pub struct Set {
    folder: PathBuf,
    /// The folder wasn't there before.
    is_new: bool,
    /// Names the files of the run before, a line each. It is locked.
    list: PathBuf,
    lock: File,
    earlier: BTreeSet<PathBuf>,
    /// Gone when the set is dropped.
    side: Option<Scratch>,
}

impl Set {
    /// Takes the set of a name in a folder, which is made if it isn't there.
    ///
    /// # Errors
    /// If another run has the set, or the folder can't be made or written.
    pub fn open(folder: &Path, name: &str) -> Result<Self> {
        let is_new = !folder.exists();
        make_folder(folder)?;
        let fail = at(folder);
        let state = folder.join(STATE);
        let list = state.join(name);
        let mut lock = claim(&state, &list).map_err(&fail)?.ok_or_else(|| {
            let problem =
                "another run is writing into it: wait for its end, or choose another folder";
            Error::file(folder, problem.to_owned())
        })?;
        let mut text = String::new();
        lock.read_to_string(&mut text).map_err(&fail)?;
        let earlier = text.lines().map(PathBuf::from).filter(|path| is_within(path)).collect();
        let mut set = Self { folder: folder.to_owned(), is_new, list, lock, earlier, side: None };
        set.side = Some(Scratch::within(&state, "new-").map_err(&fail)?);
        fs::create_dir(set.path()).map_err(fail)?;
        Ok(set)
    }

    /// The side folder: what is written here takes its place at [`Self::commit`].
    #[must_use]
    pub fn path(&self) -> PathBuf {
        self.side().join(FILES)
    }

    fn side(&self) -> &Path {
        self.side.as_ref().expect("bug: it goes with the set").path()
    }

    /// Puts all files of the side folder into their places, and removes those of the run before that
    /// are not among them.
    ///
    /// # Errors
    /// If a file can't be put there, or this process reads it. Nothing has changed if that is known
    /// before the first is in its place.
    pub fn commit(mut self) -> Result<()> {
        let mut made = BTreeSet::new();
        files_of(&self.path(), Path::new(""), &mut made).map_err(at(&self.folder))?;
        let stale: Vec<PathBuf> = self.earlier.difference(&made).cloned().collect();
        for file in &made {
            check(&self.folder.join(file))?;
        }
        // The files of both runs, until those of one are there.
        let both: BTreeSet<PathBuf> = self.earlier.union(&made).cloned().collect();
        self.tell(&both).map_err(at(&self.list))?;
        let mut plain = Vec::new();
        for file in &made {
            let (from, to) = (self.path().join(file), self.folder.join(file));
            make_folder(to.parent().unwrap_or(&self.folder))?;
            // What a link leads to may be on another disk.
            if fs::symlink_metadata(&to).is_ok_and(|there| !there.is_file()) {
                copy(&from, &to)?;
            } else {
                plain.push((from, to));
            }
        }
        let held = scratch::hold();
        for (from, to) in &plain {
            place(from, &real_path(to)).map_err(at(to))?;
        }
        for file in &stale {
            self.remove(file)?;
        }
        drop(held);
        // The list of both says too much and nothing wrong.
        let _ = self.tell(&made);
        Ok(())
    }

    /// Writes the list; a kill leaves the old one or the new one.
    fn tell(&mut self, files: &BTreeSet<PathBuf>) -> io::Result<()> {
        let path = self.side().join("list");
        let mut new = File::options().read(true).write(true).create_new(true).open(&path)?;
        // Nobody else knows it yet; a system without locks has none here either.
        let _ = new.try_lock();
        for file in files {
            writeln!(new, "{}", file.display())?;
        }
        fs::rename(&path, &self.list)?;
        self.lock = new;
        Ok(())
    }

    /// Removes a file of the run before, and its folder if that is empty then.
    fn remove(&self, file: &Path) -> Result<()> {
        let path = self.folder.join(file);
        if input::input_at(&path).is_some() {
            return Ok(());
        }
        match fs::remove_file(&path) {
            Err(why) if why.kind() != io::ErrorKind::NotFound => {
                return Err(Error::io(&path, "can't remove", why));
            }
            Ok(()) | Err(_) => {}
        }
        let above = file.ancestors().skip(1).filter(|folder| !folder.as_os_str().is_empty());
        for folder in above {
            // One with other files stays.
            let _ = fs::remove_dir(self.folder.join(folder));
        }
        Ok(())
    }
}

impl Drop for Set {
    fn drop(&mut self) {
        self.side = None;
        // A run that wrote nothing leaves nothing.
        if self.lock.metadata().is_ok_and(|list| list.len() == 0) {
            let _ = fs::remove_file(&self.list);
            let _ = fs::remove_dir(self.folder.join(STATE));
            if self.is_new {
                let _ = fs::remove_dir(&self.folder);
            }
        }
    }
}

/// Opens and locks a list, which is made if it isn't there; `None` if another run has it.
fn claim(state: &Path, list: &Path) -> io::Result<Option<File>> {
    loop {
        fs::create_dir_all(state)?;
        let mut options = File::options();
        let file = match options.read(true).write(true).create(true).truncate(false).open(list) {
            // Another run has just removed the folder.
            Err(why) if why.kind() == io::ErrorKind::NotFound => continue,
            opened => opened?,
        };
        match file.try_lock() {
            Err(fs::TryLockError::WouldBlock) => return Ok(None),
            // A file system without locks can't refuse anyone.
            Ok(()) | Err(fs::TryLockError::Error(_)) => {}
        }
        // Whoever had it before may have put another in its place.
        if input::is_at(&file, list) {
            return Ok(Some(file));
        }
    }
}

/// Where a file of a set will be, if that is a path in its side folder.
pub(super) fn in_place(path: &Path) -> PathBuf {
    let parts: Vec<Component<'_>> = path.components().collect();
    let is_side = |at: usize| parts[at].as_os_str() == STATE && parts[at + 2].as_os_str() == FILES;
    match (0..parts.len().saturating_sub(2)).find(|at| is_side(*at)) {
        Some(at) => in_place(&parts[..at].iter().chain(&parts[at + 3..]).collect::<PathBuf>()),
        None => path.to_owned(),
    }
}

/// True for a path that leads out of no folder.
fn is_within(path: &Path) -> bool {
    path.components().all(|part| matches!(part, Component::Normal(_))) && path != Path::new("")
}

/// Paths of all files in a folder, from there.
fn files_of(root: &Path, below: &Path, files: &mut BTreeSet<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(root.join(below))? {
        let entry = entry?;
        let path = below.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            files_of(root, &path, files)?;
        } else {
            files.insert(path);
        }
    }
    Ok(())
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    write_file(to, |writer| {
        let mut file = File::open(from).map_err(at(from))?;
        io::copy(&mut file, writer).map(|_| ()).map_err(at(to))
    })
}
