//! Files that belong together.

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

/// Names those files, beside them.
const LIST: &str = "list";

/// The files that a command writes into a folder, where others' may be, too.
///
/// They are written into a side folder and take their places together, so that a run that is
/// stopped leaves all files of one run. Files that the run before made and this one doesn't make go
/// then, but for those that have changed since or that another set has made since. A second run
/// that wants to write the same set meanwhile is refused; what refuses it falls with the process.
///
/// # What holds
///
/// `.fixpath/NAME` lists the files of the last run that came to its end, each with its length and
/// time, by which it is known again. A run that has written all its files renames its side folder
/// to `.fixpath/NAME.next`, the journal: from then on its files are those of the set. They go to
/// their places one by one, those of the run before that are no longer made go away, and at last
/// the journal's list becomes `.fixpath/NAME`. Whoever is killed before the first rename leaves the
/// files of the run before; whoever is killed later leaves the journal, and the next run that opens
/// the set finishes it before anything else. So while there is no journal, all files are of one
/// run; while there is one, they may be of two, and a reader waits or opens the set. Against a
/// power cut the order of renames is the file system's: nothing is flushed to disk.
#[derive(Debug)]
pub struct Set {
    /// Goes while the list is still locked.
    _trace: Trace,
    folder: PathBuf,
    /// Lists the files of the run before. It is locked.
    list: PathBuf,
    /// Where the files of a run are that has come to its end and not to their places.
    journal: PathBuf,
    lock: File,
    earlier: Files,
    /// What is to be written, if that was told.
    expected: Option<BTreeSet<PathBuf>>,
    /// Gone when the set is dropped.
    side: Option<Scratch>,
}

impl Set {
    /// Takes the set of a name in a folder, which is made if it isn't there. A run that was killed
    /// while its files went to their places is finished first.
    ///
    /// # Errors
    /// If another run has the set, or the folder can't be made or written.
    pub fn open(folder: &Path, name: &str) -> Result<Self> {
        let is_new = !folder.exists();
        make_folder(folder)?;
        let fail = at(folder);
        let state = folder.join(STATE);
        let list = state.join(name);
        let lock = claim(&state, &list).map_err(&fail)?.ok_or_else(|| {
            let problem =
                "another run is writing into it: wait for its end, or choose another folder";
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

    /// The side folder: what is written here takes its place at [`Self::commit`].
    #[must_use]
    pub fn path(&self) -> PathBuf {
        self.side().join(FILES)
    }

    fn side(&self) -> &Path {
        self.side.as_ref().expect("bug: it goes with the set").path()
    }

    /// Checks before the work that these files can be put into their places: there will be no
    /// others in the set.
    ///
    /// # Errors
    /// If one can't, or this process reads it.
    pub fn expect<P: Into<PathBuf>>(&mut self, files: impl IntoIterator<Item = P>) -> Result<()> {
        let files: BTreeSet<PathBuf> = files.into_iter().map(Into::into).collect();
        for file in &files {
            check(&self.folder.join(file))?;
        }
        self.expected = Some(files);
        Ok(())
    }

    /// Puts all files of the side folder into their places, and removes those of the run before
    /// that are not among them.
    ///
    /// # Errors
    /// If a file can't be put there, or this process reads it. Nothing has changed if that is known
    /// before the first is in its place.
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
            // An interrupt removes the side folder: before it is the journal, or not at all.
            let _held = scratch::hold();
            fs::rename(self.side(), &self.journal)
        };
        tell().map_err(at(&self.list))
    }

    /// Puts the files of the journal into their places.
    fn finish(&mut self) -> Result<()> {
        let journal = self.journal.clone();
        let list = journal.join(LIST);
        let mut new = match File::open(&list) {
            // All but the end of the end was done.
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
                continue; // it is in its place
            }
            check(&to)?;
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
        let stale = self.earlier.iter().filter(|(file, _)| !made.contains_key(*file));
        let others = self.others().map_err(at(&self.folder))?;
        for (file, stamp) in stale.filter(|(file, _)| !others.contains(*file)) {
            self.remove(file, *stamp)?;
        }
        // Nobody else knows it yet; a system without locks has none here either.
        let _ = new.try_lock();
        fs::rename(&list, &self.list).map_err(at(&self.list))?;
        std::mem::swap(&mut self.lock, &mut new);
        self.earlier = made;
        drop(held);
        // What stays of it says nothing any more.
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

    /// Removes a file of the run before, if it is as that left it, and its folder if that is empty
    /// then.
    fn remove(&self, file: &Path, stamp: Stamp) -> Result<()> {
        let path = self.folder.join(file);
        let above = || {
            let folders = file.ancestors().skip(1).filter(|above| !above.as_os_str().is_empty());
            folders.map(|above| self.folder.join(above))
        };
        // No link on the way leads out of the folder.
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
            // One with other files stays.
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

/// The list of a set that is open and what was made for it: a run that writes nothing leaves
/// nothing.
#[derive(Debug)]
struct Trace(Made);

/// A list, and its folder if that wasn't there before.
type Made = (PathBuf, Option<PathBuf>);

/// Those of all sets that are open.
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

/// What open sets leave when the process ends next.
pub(super) fn abandon() {
    TRACES.lock().unwrap_or_else(PoisonError::into_inner).iter().for_each(fade);
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

/// What a file is known by, besides its name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Stamp {
    bytes: u64,
    /// When it was written, from 1970 on.
    nanoseconds: u128,
}

impl Stamp {
    /// That of a plain file.
    fn of(there: &Metadata) -> Option<Self> {
        let written = there.modified().ok()?.duration_since(UNIX_EPOCH).unwrap_or_default();
        let stamp = Self { bytes: there.len(), nanoseconds: written.as_nanos() };
        there.is_file().then_some(stamp)
    }
}

/// The files of a set.
type Files = BTreeMap<PathBuf, Stamp>;

/// What a list names, from its start: a line a file, as `BYTES NANOSECONDS PATH`.
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

/// True for a path that leads out of no folder.
fn is_within(path: &Path) -> bool {
    path.components().all(|part| matches!(part, Component::Normal(_))) && path != Path::new("")
}

/// Paths of all files in a folder, from there.
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

    /// A run that ends by a kill when its first file is in its place, or none.
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
            // The next run comes to nothing, and the files are still of one.
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
        // The same file by a link.
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
        fs::remove_dir_all(set.side()).unwrap(); // as the handler does before
        let made = (set.list.clone(), Some(out.clone()));
        assert!(TRACES.lock().unwrap().contains(&made));
        fade(&made);
        assert!(!out.exists());
    }
}
