//! Files that are published together.

use super::file::{check, write_file};
use super::folder::make_folder;
use super::place::{FILES, STATE, at, place, real_path};
use super::scratch::{self, Scratch};
use crate::base::error::{Error, Result};
use crate::base::input;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File, Metadata};
use std::io::{self, Read, Write};
use std::path::{Component, Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::UNIX_EPOCH;

/// The file that lists them, beside them.
const LIST: &str = "list";

/// The files that a command writes into a folder that may also hold other files.
///
/// They are written into a side folder and published together, so that an interrupted run leaves
/// the files of one run only. Files of the previous run that this one doesn't make are removed,
/// except those that have changed since or that another set has written since. A second run that
/// wants to write the same set at the same time is refused; its lock is released when the process
/// ends.
///
/// # Guarantees
///
/// `.fixpath/NAME` lists the files of the last completed run, with the length and time of each to
/// recognise it. A run that has written all its files renames its side folder to
/// `.fixpath/NAME.next`, the journal. From then on its files are the set's. They are moved into
/// place one by one, files of the previous run that are no longer made are removed, and finally the
/// journal's list becomes `.fixpath/NAME`. A run that is killed before the first rename leaves the
/// previous run's files. A run that is killed later leaves the journal, and the next run that opens
/// the set finishes it first. So without a journal, all files belong to one run; with a journal,
/// they may belong to two, and a reader waits or opens the set. After a power cut, the order of
/// renames depends on the file system: nothing is flushed to disk.
#[derive(Debug)]
pub struct Set {
    /// Dropped while the list is still locked.
    _trace: Trace,
    folder: PathBuf,
    /// Lists the files of the previous run. It is locked.
    list: PathBuf,
    /// The files of a run that has completed but not yet published them.
    journal: PathBuf,
    lock: File,
    earlier: Files,
    /// The files to be written, if declared.
    expected: Option<BTreeSet<PathBuf>>,
    /// Removed when the set is dropped.
    side: Option<Scratch>,
}

impl Set {
    /// Opens the set `name` in a folder, which is created if missing. First finishes a run that was
    /// killed while publishing.
    ///
    /// # Errors
    /// If another run has the set open, or the folder can't be made or written.
    pub fn open(folder: &Path, name: &str) -> Result<Self> {
        let is_new = !folder.exists();
        make_folder(folder)?;
        let fail = at(folder);
        let state = folder.join(STATE);
        let list = state.join(name);
        let lock = claim(&state, &list).map_err(&fail)?.ok_or_else(|| {
            let problem =
                "another run is writing to it: wait until it ends, or choose another folder";
            Error::file(folder, problem.to_owned())
        })?;
        let trace = Trace::new(list.clone(), is_new.then(|| folder.to_owned()));
        let earlier = listed(&lock).map_err(&fail)?;
        let mut set = Self {
            _trace: trace,
            folder: folder.to_owned(),
            list,
            journal: state.join(format!("{name}.next")),
            lock,
            earlier,
            expected: None,
            side: None,
        };
        if set.journal.exists() {
            set.finish()?;
        }
        set.side = Some(Scratch::within(&state, "new-").map_err(&fail)?);
        fs::create_dir(set.path()).map_err(fail)?;
        Ok(set)
    }

    /// The side folder. [`Self::commit`] moves the files written here into place.
    #[must_use]
    pub fn path(&self) -> PathBuf {
        self.side().join(FILES)
    }

    fn side(&self) -> &Path {
        self.side.as_ref().expect("bug: it goes with the set").path()
    }

    /// Checks in advance that these files can be moved into place. The set will hold no others.
    ///
    /// # Errors
    /// If a file can't be, or this process reads it.
    pub fn expect<P: Into<PathBuf>>(&mut self, files: impl IntoIterator<Item = P>) -> Result<()> {
        let files: BTreeSet<PathBuf> = files.into_iter().map(Into::into).collect();
        for file in &files {
            check(&self.folder.join(file))?;
        }
        self.expected = Some(files);
        Ok(())
    }

    /// Moves all files of the side folder into place, and removes those of the previous run that
    /// are not among them.
    ///
    /// # Errors
    /// If a file can't be moved, or this process reads it. If that is known before the first move,
    /// nothing has changed.
    pub fn commit(mut self) -> Result<()> {
        self.publish()?;
        self.finish()
    }

    /// Makes the side folder the journal.
    fn publish(&mut self) -> Result<()> {
        let mut made = Files::new();
        files_of(&self.path(), Path::new(""), &mut made).map_err(at(&self.folder))?;
        debug_assert!(
            self.expected.as_ref().is_none_or(|all| made.keys().all(|file| all.contains(file))),
            "bug: {made:?}"
        );
        for file in made.keys() {
            let place = self.folder.join(file);
            check(&place)?;
            make_folder(place.parent().unwrap_or(&self.folder))?;
        }
        let tell = || -> io::Result<()> {
            let mut list = File::create_new(self.side().join(LIST))?;
            made.iter().try_for_each(|(file, stamp)| {
                writeln!(list, "{} {} {}", stamp.bytes, stamp.nanoseconds, file.display())
            })?;
            // An interrupt removes the side folder, either before it becomes the journal or not at
            // all.
            let _held = scratch::hold();
            fs::rename(self.side(), &self.journal)
        };
        tell().map_err(at(&self.list))
    }

    /// Moves the files of the journal into place.
    fn finish(&mut self) -> Result<()> {
        let journal = self.journal.clone();
        let list = journal.join(LIST);
        let mut new = match File::open(&list) {
            // Only removing the journal is left to do.
            Err(why) if why.kind() == io::ErrorKind::NotFound => {
                return fs::remove_dir_all(&journal).map_err(at(&journal));
            }
            opened => opened.map_err(at(&list))?,
        };
        let made = listed(&new).map_err(at(&list))?;
        let mut plain = Vec::new();
        for file in made.keys() {
            let (from, to) = (journal.join(FILES).join(file), self.folder.join(file));
            if !from.exists() {
                continue; // already in place
            }
            check(&to)?;
            make_folder(to.parent().unwrap_or(&self.folder))?;
            // The target of a link may be on another disk.
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
        let stale = self.earlier.iter().filter(|(file, _)| !made.contains_key(*file));
        let others = self.others().map_err(at(&self.folder))?;
        for (file, stamp) in stale.filter(|(file, _)| !others.contains(*file)) {
            self.remove(file, *stamp)?;
        }
        // No other run knows this list yet. A system without locks has none here either.
        let _ = new.try_lock();
        fs::rename(&list, &self.list).map_err(at(&self.list))?;
        std::mem::swap(&mut self.lock, &mut new);
        self.earlier = made;
        drop(held);
        // Whatever remains of the journal has no meaning any more.
        let _ = fs::remove_dir_all(&journal);
        Ok(())
    }

    /// Files of the other sets in the folder.
    fn others(&self) -> io::Result<BTreeSet<PathBuf>> {
        let state = self.folder.join(STATE);
        let mut files = BTreeSet::new();
        for entry in fs::read_dir(state)? {
            let path = entry?.path();
            if path != self.list && path.is_file() {
                files.extend(listed(&File::open(path)?)?.into_keys());
            }
        }
        Ok(files)
    }

    /// Removes a file of the previous run if it is unchanged, and then its folders that are empty.
    fn remove(&self, file: &Path, stamp: Stamp) -> Result<()> {
        let path = self.folder.join(file);
        let above = || {
            let folders = file.ancestors().skip(1).filter(|above| !above.as_os_str().is_empty());
            folders.map(|above| self.folder.join(above))
        };
        // Doesn't follow links, which may lead out of the folder.
        let is_here =
            above().all(|above| fs::symlink_metadata(above).is_ok_and(|there| there.is_dir()));
        let is_same = fs::symlink_metadata(&path).is_ok_and(|at| Stamp::of(&at) == Some(stamp));
        if !is_here || !is_same || input::input_at(&path).is_some() {
            return Ok(());
        }
        match fs::remove_file(&path) {
            Err(why) if why.kind() != io::ErrorKind::NotFound => {
                return Err(Error::io(&path, "can't remove", why));
            }
            Ok(()) | Err(_) => {}
        }
        for folder in above() {
            // A folder with other files stays.
            let _ = fs::remove_dir(folder);
        }
        Ok(())
    }
}

impl Drop for Set {
    fn drop(&mut self) {
        self.side = None;
    }
}

/// The list of an open set, and the folder created for it. Both are removed if the run writes
/// nothing.
#[derive(Debug)]
struct Trace(Made);

/// A list, and its folder if this run created it.
type Made = (PathBuf, Option<PathBuf>);

/// The traces of all open sets.
static TRACES: Mutex<BTreeSet<Made>> = Mutex::new(BTreeSet::new());

impl Trace {
    fn new(list: PathBuf, new_folder: Option<PathBuf>) -> Self {
        let made = (list, new_folder);
        TRACES.lock().unwrap_or_else(PoisonError::into_inner).insert(made.clone());
        Self(made)
    }
}

impl Drop for Trace {
    fn drop(&mut self) {
        TRACES.lock().unwrap_or_else(PoisonError::into_inner).remove(&self.0);
        fade(&self.0);
    }
}

fn fade((list, new_folder): &Made) {
    if fs::metadata(list).is_ok_and(|list| list.len() == 0) {
        let _ = fs::remove_file(list);
        let _ = list.parent().map(fs::remove_dir);
        let _ = new_folder.as_ref().map(fs::remove_dir);
    }
}

/// Removes the traces of open sets; the process ends next.
pub(super) fn abandon() {
    TRACES.lock().unwrap_or_else(PoisonError::into_inner).iter().for_each(fade);
}

/// Opens and locks a list, which is created if missing; `None` if another run holds the lock.
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
        // The previous holder may have replaced it.
        if input::is_at(&file, list) {
            return Ok(Some(file));
        }
    }
}

/// Identifies a file's content without reading it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Stamp {
    bytes: u64,
    /// Modification time, since 1970.
    nanoseconds: u128,
}

impl Stamp {
    /// The stamp of a regular file.
    fn of(there: &Metadata) -> Option<Self> {
        let written = there.modified().ok()?.duration_since(UNIX_EPOCH).unwrap_or_default();
        let stamp = Self { bytes: there.len(), nanoseconds: written.as_nanos() };
        there.is_file().then_some(stamp)
    }
}

/// The files of a set.
type Files = BTreeMap<PathBuf, Stamp>;

/// The files in a list, read from its start: one line each, `BYTES NANOSECONDS PATH`.
fn listed(mut list: &File) -> io::Result<Files> {
    let mut text = Vec::new();
    list.read_to_end(&mut text)?;
    let file = |line: &str| {
        let (bytes, rest) = line.split_once(' ')?;
        let (nanoseconds, path) = rest.split_once(' ')?;
        let stamp = Stamp { bytes: bytes.parse().ok()?, nanoseconds: nanoseconds.parse().ok()? };
        let path = PathBuf::from(path);
        is_within(&path).then_some((path, stamp))
    };
    Ok(String::from_utf8_lossy(&text).lines().filter_map(file).collect())
}

/// True for a path that can't lead out of its folder.
fn is_within(path: &Path) -> bool {
    path.components().all(|part| matches!(part, Component::Normal(_))) && path != Path::new("")
}

/// Collects the paths of all files in a folder, relative to it.
fn files_of(root: &Path, below: &Path, files: &mut Files) -> io::Result<()> {
    for entry in fs::read_dir(root.join(below))? {
        let entry = entry?;
        let path = below.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            files_of(root, &path, files)?;
        } else if let Some(stamp) = Stamp::of(&entry.metadata()?) {
            files.insert(path, stamp);
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

#[cfg(test)]
mod tests {
    use super::*;

    fn write(set: &Set, files: [(&str, &str); 2]) {
        for (name, text) in files {
            fs::write(set.path().join(name), text).unwrap();
        }
    }

    fn texts(folder: &Path) -> Vec<(String, String)> {
        let mut all = Files::new();
        files_of(folder, Path::new(""), &mut all).unwrap();
        let named = all.into_keys().filter(|file| !file.starts_with(STATE));
        let of = |file: PathBuf| {
            (file.display().to_string(), fs::read_to_string(folder.join(file)).unwrap())
        };
        named.map(of).collect()
    }

    /// A run that is killed after moving its first file into place, or before that.
    fn killed(folder: &Path, placed: bool) {
        let mut set = Set::open(folder, "s").unwrap();
        write(&set, [("a", "2"), ("b", "2")]);
        if placed {
            set.publish().unwrap();
            fs::rename(set.journal.join(FILES).join("a"), folder.join("a")).unwrap();
        }
        // A kill frees the lock and removes nothing.
        set.lock.unlock().unwrap();
        std::mem::forget(set);
    }

    #[test]
    fn what_a_kill_cut_is_finished_by_the_next_run() {
        for placed in [false, true] {
            let folder = tempfile::tempdir().unwrap();
            let folder = folder.path();
            let set = Set::open(folder, "s").unwrap();
            write(&set, [("a", "1"), ("old", "1")]);
            set.commit().unwrap();
            killed(folder, placed);
            // The next run writes nothing, and all files still belong to one run.
            drop(Set::open(folder, "s").unwrap());
            let of_second = [("a", "2"), ("b", "2")];
            let of_first = [("a", "1"), ("old", "1")];
            let want = if placed { of_second } else { of_first };
            let want = want.map(|(name, text)| (name.to_owned(), text.to_owned()));
            assert_eq!(texts(folder), want);
            let list = listed(&File::open(folder.join(STATE).join("s")).unwrap()).unwrap();
            assert!(list.keys().eq(want.iter().map(|(name, _)| Path::new(name))), "{list:?}");
            assert!(!folder.join(STATE).join("s.next").exists());
        }
    }

    #[test]
    fn only_what_the_run_before_left_goes() {
        let folder = tempfile::tempdir().unwrap();
        let (folder, elsewhere) = (folder.path(), tempfile::tempdir().unwrap());
        let commit = |name: &str, files: &[&str]| {
            let set = Set::open(folder, name).unwrap();
            for file in files {
                let path = set.path().join(file);
                fs::create_dir_all(path.parent().unwrap()).unwrap();
                fs::write(path, name).unwrap();
            }
            set.commit().unwrap();
        };
        commit("s", &["same", "changed", "theirs", "now_folder", "sub/same", "moved/same"]);
        commit("t", &["theirs"]);
        fs::write(folder.join("changed"), "by hand").unwrap();
        fs::remove_file(folder.join("now_folder")).unwrap();
        fs::create_dir(folder.join("now_folder")).unwrap();
        // The same file, reached by a link.
        fs::rename(folder.join("moved"), elsewhere.path().join("moved")).unwrap();
        #[cfg(unix)]
        std::os::unix::fs::symlink(elsewhere.path().join("moved"), folder.join("moved")).unwrap();
        commit("s", &[]);
        for gone in ["same", "sub"] {
            assert!(!folder.join(gone).exists(), "{gone}");
        }
        for left in ["changed", "theirs", "now_folder"] {
            assert!(folder.join(left).exists(), "{left}");
        }
        assert!(elsewhere.path().join("moved/same").exists());
        assert_eq!(fs::read_to_string(folder.join("theirs")).unwrap(), "t");
    }

    #[test]
    fn what_is_expected_is_checked_before_the_work() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("a")).unwrap();
        let mut set = Set::open(folder.path(), "s").unwrap();
        let why = set.expect(["b", "a"]).unwrap_err().to_string();
        assert!(why.ends_with("a: can't write: it is a folder"), "{why}");
        drop(set);
        // A run that wrote nothing leaves nothing.
        assert!(!folder.path().join(STATE).exists());
    }

    #[test]
    fn an_interrupt_before_the_first_file_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("out");
        let set = Set::open(&out, "s").unwrap();
        fs::remove_dir_all(set.side()).unwrap(); // as the interrupt handler does first
        let made = (set.list.clone(), Some(out.clone()));
        assert!(TRACES.lock().unwrap().contains(&made));
        fade(&made);
        assert!(!out.exists());
    }
}
