//! A folder whose files change as a set.
//!
//! A set is put together in a hidden folder beside its place, with a list of its names. Renaming that folder to [`READY`] decides: from
//! then on the set is complete, and whoever comes next moves what is left of it, should this process be killed. While files move, at most
//! one run's are seen: those of the earlier run go first.
//!
//! Who changes the folder holds a lock of the system, which vanishes with its holder. So does the lock of a hidden folder in the making;
//! one without a holder is the rest of a killed run, and is removed.
//!
//! On Linux files get no name at all until then (`unnamed`), so that a killed run leaves nothing.

use std::fs::{self, File, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::{Duration, Instant};

use tempfile::TempDir;

use super::unnamed;
use crate::error::{Error, Result};

/// Beginning of hidden names.
const HIDDEN: &str = ".ancf-";

/// Hidden folder of a complete set.
const READY: &str = ".ancf-ready";

/// List of the names of a set, in its hidden folder: a line for each file, new ones in their order, then names to be removed.
const LIST: &str = ".names";

/// Lock file where a folder itself cannot be locked.
const LOCK: &str = ".ancf-lock";

/// Longest wait for another run to name its files, which takes milliseconds.
const PATIENCE: Duration = Duration::from_secs(10);

/// A folder for output files, ready to be written.
#[derive(Debug)]
pub(super) struct Folder {
    path: PathBuf,
    /// Whether files without a name can be written here, and named later.
    takes_unnamed: bool,
    staging: Option<Staging>,
}

/// Hidden folder of a set in the making.
#[derive(Debug)]
struct Staging {
    folder: TempDir,
    /// Says that its run lives.
    _lock: File,
}

impl Folder {
    /// Creates the folder if it does not exist, completes the set of a killed run, removes what others have left, and tries to write a
    /// file.
    ///
    /// # Errors
    /// [`Error::Write`] if that fails.
    pub(super) fn open(path: &Path) -> Result<Folder> {
        let mut folder = Folder { path: path.into(), takes_unnamed: false, staging: None };
        folder.prepare().map_err(|source| Error::Write { path: path.into(), source })?;
        Ok(folder)
    }

    fn prepare(&mut self) -> io::Result<()> {
        let _lock = lock(&self.path)?;
        complete(&self.path)?;
        sweep(&self.path)?;
        let staging = self.stage()?;
        let probe = staging.join("probe");
        let mut named = File::create_new(staging.join("named"))?;
        // A full disk takes a file, but not its first byte.
        named.write_all(b"a")?;
        let unnamed = unnamed::create(&self.path).and_then(|file| unnamed::link(&file, &probe));
        self.takes_unnamed = unnamed.is_ok() && probe.exists();
        self.staging = None;
        Ok(())
    }

    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Refuses names that folders have.
    ///
    /// # Errors
    /// [`Error::Write`] for the first of them.
    pub(super) fn check<N: AsRef<str>>(&self, names: &[N]) -> Result<()> {
        let paths = names.iter().map(|name| self.path.join(name.as_ref()));
        match paths.into_iter().find(|path| path.is_dir()) {
            Some(path) => Err(Error::Write { path, source: io::ErrorKind::IsADirectory.into() }),
            None => Ok(()),
        }
    }

    /// A new file of the set, without its final name.
    pub(super) fn create(&mut self, name: &str) -> io::Result<File> {
        // It may be gone by the end of a long run.
        fs::create_dir_all(&self.path)?;
        if self.takes_unnamed {
            return unnamed::create(&self.path);
        }
        let _lock = lock(&self.path)?;
        File::options().read(true).write(true).create_new(true).open(self.stage()?.join(name))
    }

    /// The hidden folder, made at the first call by who holds the lock of this one.
    fn stage(&mut self) -> io::Result<&Path> {
        let staging = match self.staging.take() {
            Some(staging) => staging,
            None => {
                let folder = tempfile::Builder::new().prefix(HIDDEN).tempdir_in(&self.path)?;
                let lock = try_lock(folder.path())?.ok_or(io::ErrorKind::WouldBlock)?;
                Staging { folder, _lock: lock }
            }
        };
        Ok(self.staging.insert(staging).folder.path())
    }

    /// Gives the files of a set their names in place of an earlier set's, and removes files of the `stale` names and all
    /// others whose name `is_own`.
    ///
    /// # Errors
    /// [`Error::Write`]. Before the set was complete the earlier one is untouched; afterwards the next run completes it.
    pub(super) fn switch(
        mut self,
        written: Vec<(String, File)>,
        stale: &[&str],
        is_own: impl Fn(&str) -> bool,
    ) -> Result<()> {
        let path = self.path.clone();
        let failed = |source| Error::Write { path: path.clone(), source };
        let _lock = lock(&self.path).map_err(failed)?;
        complete(&self.path).map_err(failed)?;
        let names: Vec<&str> = written.iter().map(|(name, _)| name.as_str()).collect();
        self.check(&names)?;
        self.check(stale)?;
        let others = files_of(&self.path, |name| is_own(name) && !names.contains(&name)).map_err(failed)?;
        let stale: Vec<&str> = stale.iter().copied().chain(others.iter().map(String::as_str)).collect();
        let ready = self.fill(&written, &list(&names, &stale)).map_err(failed)?;
        // Some systems rename no folder of an open file.
        drop(written);
        fs::rename(ready, self.path.join(READY)).map_err(failed)?;
        complete(&self.path).map_err(failed)
    }

    /// The hidden folder with the whole set and its list.
    fn fill(&mut self, written: &[(String, File)], list: &str) -> io::Result<PathBuf> {
        let takes_unnamed = self.takes_unnamed;
        let staging = self.stage()?;
        for (name, file) in written.iter().filter(|_| takes_unnamed) {
            unnamed::link(file, &staging.join(name))?;
        }
        let mut names = File::create_new(staging.join(LIST))?;
        names.write_all(list.as_bytes())?;
        names.sync_all()?;
        // From here on it is not removed when this value goes.
        self.staging.take().map(|staging| staging.folder.keep()).ok_or(io::ErrorKind::NotFound.into())
    }
}

/// Names of the files in a folder that are wanted.
fn files_of(folder: &Path, is_wanted: impl Fn(&str) -> bool) -> io::Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if let Some(name) = entry.file_name().to_str().filter(|name| is_wanted(name))
            && entry.file_type()?.is_file()
        {
            names.push(name.to_string());
        }
    }
    Ok(names)
}

/// Lines of a set's list.
fn list(names: &[&str], stale: &[&str]) -> String {
    let lines = |word: &str, names: &[&str]| names.iter().map(|name| format!("{word} {name}\n")).collect::<String>();
    lines("new", names) + &lines("old", stale)
}

/// Moves what is left of a complete set to its place. Does nothing if there is none.
fn complete(folder: &Path) -> io::Result<()> {
    let ready = folder.join(READY);
    if !ready.exists() {
        return Ok(());
    }
    // Without a list all files have their names.
    let list = match fs::read_to_string(ready.join(LIST)) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
        list => list?,
    };
    let lines: Vec<(&str, &str)> = list.lines().filter_map(|line| line.split_once(' ')).collect();
    if let Some((_, name)) = lines.iter().find(|(_, name)| Path::new(name).file_name() != Some(name.as_ref())) {
        return Err(io::Error::other(format!("{} lists {name:?}, which is no name of a file", ready.display())));
    }
    let is_there = |word: &str, name: &str| word == "old" || ready.join(name).exists();
    let left: Vec<&str> = lines.iter().filter(|(word, name)| is_there(word, name)).map(|(_, name)| *name).collect();
    // The first is replaced by its successor at once.
    for name in left.iter().skip(1) {
        remove(&folder.join(name))?;
    }
    for name in &left {
        let (from, to) = (ready.join(name), folder.join(name));
        if from.exists() { fs::rename(from, to)? } else { remove(&to)? }
    }
    fs::remove_dir_all(ready)
}

/// Removes a file if it is there.
fn remove(file: &Path) -> io::Result<()> {
    match fs::remove_file(file) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        removed => removed,
    }
}

/// Removes hidden folders whose runs have ended.
fn sweep(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let is_hidden = entry.file_name().to_str().is_some_and(|name| name.starts_with(HIDDEN) && name != READY);
        if is_hidden && entry.file_type()?.is_dir() && try_lock(&entry.path())?.is_some() {
            fs::remove_dir_all(entry.path())?;
        }
    }
    Ok(())
}

/// Locks a folder, which is created if it does not exist, until the returned file is dropped or the process ends.
fn lock(folder: &Path) -> io::Result<File> {
    fs::create_dir_all(folder)?;
    let begin = Instant::now();
    loop {
        if let Some(lock) = try_lock(folder)? {
            return Ok(lock);
        }
        if begin.elapsed() > PATIENCE {
            let why = format!("another run has been naming its files there for {} s", PATIENCE.as_secs());
            return Err(io::Error::new(io::ErrorKind::TimedOut, why));
        }
        sleep(Duration::from_millis(2));
    }
}

/// Locks a folder; `None` if another holder has it.
fn try_lock(folder: &Path) -> io::Result<Option<File>> {
    // Network file systems and Windows lock no folders, but files in them.
    let file = || File::options().create(true).truncate(false).write(true).open(folder.join(LOCK));
    match File::open(folder).map(|itself| (itself.try_lock(), itself)) {
        Ok((Ok(()), itself)) => return Ok(Some(itself)),
        Ok((Err(TryLockError::WouldBlock), _)) => return Ok(None),
        Ok((Err(TryLockError::Error(_)), _)) | Err(_) => {}
    }
    let file = file()?;
    match file.try_lock() {
        Ok(()) => Ok(Some(file)),
        Err(TryLockError::WouldBlock) => Ok(None),
        Err(TryLockError::Error(error)) => Err(error),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Names and contents of a folder, hidden ones too.
    fn contents(folder: &Path) -> Vec<(String, String)> {
        let read = |entry: fs::DirEntry| {
            let text = fs::read_to_string(entry.path()).unwrap_or_default();
            (entry.file_name().into_string().unwrap(), text)
        };
        let mut contents: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| read(entry.unwrap())).collect();
        contents.sort();
        contents
    }

    fn set(files: &[(&str, &str)]) -> Vec<(String, String)> {
        files.iter().map(|(name, text)| (name.to_string(), text.to_string())).collect()
    }

    /// Killed after any number of moves: one run's files alone are seen, and the next run completes the set.
    #[test]
    fn a_set_that_was_cut_off_is_completed_by_the_next_run() {
        let (old, new) =
            ([("a", "old a"), ("b", "old b"), ("gone", "old")], [("a", "new a"), ("b", "new b"), ("c", "new c")]);
        for moved in 0..=new.len() {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path();
            old.iter()
                .skip(usize::from(moved > 0) * 3)
                .for_each(|(name, text)| fs::write(path.join(name), text).unwrap());
            fs::create_dir(path.join(READY)).unwrap();
            fs::write(path.join(READY).join(LIST), list(&["a", "b", "c"], &["gone"])).unwrap();
            for (n, (name, text)) in new.iter().enumerate() {
                let place = if n < moved { path.into() } else { path.join(READY) };
                fs::write(place.join(name), text).unwrap();
            }
            Folder::open(path).unwrap();
            assert_eq!(contents(path), set(&new), "{moved} files were moved before");
        }
    }

    #[test]
    fn a_list_leads_out_of_no_folder() {
        let folder = tempfile::tempdir().unwrap();
        let (inner, outside) = (folder.path().join("out"), folder.path().join("outside"));
        fs::create_dir_all(inner.join(READY)).unwrap();
        fs::write(&outside, "kept").unwrap();
        fs::write(inner.join(READY).join(LIST), "old ../outside\n").unwrap();
        let message = Folder::open(&inner).unwrap_err().to_string();
        assert!(message.contains("\"../outside\", which is no name of a file"), "{message}");
        assert!(outside.exists());
    }

    #[test]
    fn hidden_folders_of_dead_runs_are_removed_and_those_of_living_ones_kept() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join(".ancf-dead")).unwrap();
        fs::write(folder.path().join(".ancf-dead/a"), "half of").unwrap();
        let mut living = Folder::open(folder.path()).unwrap();
        living.takes_unnamed = false;
        let file = living.create("a").unwrap();
        Folder::open(folder.path()).unwrap();
        living.switch(vec![("a".into(), file)], &[], |_| false).unwrap();
        assert_eq!(contents(folder.path()), set(&[("a", "")]));
    }

    /// Where files cannot be without a name the set is the same.
    #[test]
    fn named_and_unnamed_files_are_published_alike() {
        for takes_unnamed in [false, true] {
            let folder = tempfile::tempdir().unwrap();
            fs::write(folder.path().join("stale"), "").unwrap();
            let mut own = Folder::open(folder.path()).unwrap();
            own.takes_unnamed &= takes_unnamed;
            let mut file = own.create("a").unwrap();
            file.write_all(b"new").unwrap();
            own.switch(vec![("a".into(), file)], &["stale"], |_| false).unwrap();
            assert_eq!(contents(folder.path()), set(&[("a", "new")]));
        }
    }

    #[test]
    fn a_lock_keeps_others_out_until_it_goes() {
        let folder = tempfile::tempdir().unwrap();
        let held = lock(folder.path()).unwrap();
        assert!(try_lock(folder.path()).unwrap().is_none());
        drop(held);
        assert!(try_lock(folder.path()).unwrap().is_some());
    }
}
