//! Output files of one run: they appear together and whole, or not at all.
//!
//! Nothing in the folder changes before the whole set is on the disk. Then one rename of a hidden folder decides: before it the earlier set
//! stands untouched, after it the new set is complete. A process that is killed while the files get their names leaves the rest in that
//! folder, and the next run into the same folder completes the set first (`folder`). Two runs into one folder take turns; the last one
//! stands whole.
//!
//! **Run id.** The first 16 hexadecimal digits of the SHA-256 of the run's tables (CSV), one after another in the order written:
//! `sha256sum trajectory.csv` begins with it. JSON has it as `run`, SVG, HTML and Markdown in a comment. So every table carries it without
//! a line or column that its readers would trip over, and equal results have equal ids.

mod folder;
mod run_id;
mod stamp;
mod unnamed;

use std::fs::File;
use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};

use serde::Serialize;

use self::folder::Folder;
use self::run_id::Hashing;
pub use self::run_id::RunId;
use self::stamp::stamped;
use crate::error::{Error, Result};

/// Beginning and end of names that have a number between them.
pub type Series = (&'static str, &'static str);

/// Output files of one command: written without their names first, then named together.
///
/// Files that are dropped without [`Files::publish`] leave nothing behind but the folder.
#[derive(Debug)]
pub struct Files {
    folder: Folder,
    /// Names that the command may write; those that it does not write are removed with the earlier set.
    names: Vec<String>,
    /// Beginnings and ends of names with a number between them, which the command may write as well.
    series: Vec<Series>,
    written: Vec<(String, File)>,
    /// Texts that get the run id when all tables are known.
    texts: Vec<(String, String)>,
    tables: RunId,
}

impl Files {
    /// Output files in `folder`, which is created if it does not exist. `names` are all files that the command may write, `inputs` the
    /// files that it reads. What is certain to fail later fails here: a folder that cannot be written, a name that a folder has, an output
    /// that would replace an input.
    ///
    /// # Errors
    /// [`Error::Write`] with the system's reason; [`Error::OverwritesInput`].
    pub fn in_folder<N: Into<String>>(
        folder: &Path,
        names: impl IntoIterator<Item = N>,
        inputs: &[&Path],
    ) -> Result<Files> {
        let names: Vec<String> = names.into_iter().map(N::into).collect();
        // Before the folder is created: a refused command leaves nothing.
        for name in &names {
            let path = folder.join(name);
            if inputs.iter().any(|input| is_same_file(input, &path)) {
                return Err(Error::OverwritesInput { path });
            }
        }
        let folder = Folder::open(folder)?;
        folder.check(&names)?;
        let (series, written, texts) = (Vec::new(), Vec::new(), Vec::new());
        Ok(Files { folder, names, series, written, texts, tables: RunId::default() })
    }

    /// Tells of files that are numbered, as many as there may be. Those of an earlier run that this one does not write are
    /// removed with it.
    #[must_use]
    pub fn numbered(mut self, series: &[Series]) -> Files {
        self.series.extend(series);
        self
    }

    /// Writes a table; `content` gets a buffered writer.
    ///
    /// # Errors
    /// [`Error::Write`] with the file's final name and the system's reason.
    pub fn write_table(&mut self, name: &str, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<()> {
        self.declared(name)?;
        let tables = &mut self.tables;
        let file = written(&mut self.folder, name, |file| {
            let mut buffered = BufWriter::new(Hashing { file, id: tables });
            content(&mut buffered)?;
            buffered.flush()
        })?;
        self.written.push((name.into(), file));
        Ok(())
    }

    /// Writes a file that does not carry the run id, or carries it already.
    ///
    /// # Errors
    /// [`Error::Write`] with the file's final name and the system's reason.
    pub fn write(&mut self, name: &str, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<()> {
        self.declared(name)?;
        let file = written(&mut self.folder, name, |file| {
            let mut buffered = BufWriter::new(file);
            content(&mut buffered)?;
            buffered.flush()
        })?;
        self.written.push((name.into(), file));
        Ok(())
    }

    /// Writes a text that gets the run id when all tables are written: JSON of an object, SVG, HTML or Markdown, as the name says.
    ///
    /// # Errors
    /// [`Error::Write`] for a name that the command has not told.
    pub fn write_text(&mut self, name: &str, text: String) -> Result<()> {
        self.declared(name)?;
        self.texts.push((name.into(), text));
        Ok(())
    }

    /// Writes an object as JSON that gets the run id as its first key when all tables are written.
    ///
    /// # Errors
    /// [`Error::Write`].
    pub fn write_json(&mut self, name: &str, content: &impl Serialize) -> Result<()> {
        let text = serde_json::to_string_pretty(content);
        let path = || self.folder.path().join(name);
        let text = text.map_err(|source| Error::Write { path: path(), source: source.into() })?;
        self.write_text(name, text)
    }

    /// Refuses a name that the command has not told, as nothing was checked for it.
    fn declared(&self, name: &str) -> Result<()> {
        if self.names.iter().any(|known| known == name) || is_numbered(&self.series, name) {
            return Ok(());
        }
        let source = io::Error::other("this command has no output file of that name");
        Err(Error::Write { path: self.folder.path().join(name), source })
    }

    /// Run id of the tables written so far.
    pub fn run_id(&self) -> String {
        self.tables.to_string()
    }

    /// Identifies the run by `content`, too; for a command without tables.
    pub fn identify(&mut self, content: &[u8]) {
        self.tables.add(content);
    }

    /// Names all files, in the order of writing, and returns their paths. Files of an earlier run that have the names of this command are
    /// replaced or removed.
    ///
    /// # Errors
    /// [`Error::Write`]; the earlier files are untouched, unless the system fails to name a file. The next run into the folder then
    /// completes the set.
    pub fn publish(mut self) -> Result<Vec<PathBuf>> {
        let run = self.run_id();
        for (name, text) in std::mem::take(&mut self.texts) {
            self.write(&name, |out| out.write_all(stamped(&name, &text, &run).as_bytes()))?;
        }
        for (name, file) in &self.written {
            file.sync_all().map_err(|source| Error::Write { path: self.folder.path().join(name), source })?;
        }
        let names: Vec<&String> = self.written.iter().map(|(name, _)| name).collect();
        let paths = names.iter().map(|name| self.folder.path().join(name)).collect();
        let stale: Vec<&str> = self.names.iter().filter(|name| !names.contains(name)).map(String::as_str).collect();
        let series = self.series;
        self.folder.switch(self.written, &stale, |name| is_numbered(&series, name))?;
        Ok(paths)
    }
}

/// Whether a name is one of a series.
fn is_numbered(series: &[Series], name: &str) -> bool {
    let number = |(begin, end): &Series| name.strip_prefix(begin)?.strip_suffix(end);
    series.iter().filter_map(number).any(|number| !number.is_empty() && number.bytes().all(|c| c.is_ascii_digit()))
}

/// The lines that tell a person which files were written.
pub fn written_lines(paths: &[PathBuf]) -> String {
    paths.iter().map(|path| format!("wrote {}\n", path.display())).collect()
}

/// A file with its content, without its final name yet.
fn written(folder: &mut Folder, name: &str, content: impl FnOnce(&mut File) -> io::Result<()>) -> Result<File> {
    let path = folder.path().join(name);
    let write = || {
        let mut file = folder.create(name)?;
        content(&mut file)?;
        file.rewind()?;
        Ok(file)
    };
    write().map_err(|source| Error::Write { path, source })
}

/// Whether two paths lead to one file; of those that do not exist none is the same.
fn is_same_file(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    fn entries(folder: &Path) -> Vec<String> {
        let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
        let mut names: Vec<String> = names.map(|name| name.into_string().unwrap()).collect();
        names.sort();
        names
    }

    fn in_folder(folder: &Path, names: &[&str]) -> Result<Files> {
        Files::in_folder(folder, names.iter().copied(), &[])
    }

    #[test]
    fn files_appear_together_in_a_new_folder() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("new/deep");
        let mut files = in_folder(&inner, &["a", "b"]).unwrap();
        files.write("a", |w| w.write_all(b"first")).unwrap();
        files.write("b", |w| w.write_all(b"second")).unwrap();
        assert!(!inner.join("a").exists() && !inner.join("b").exists());
        assert_eq!(files.publish().unwrap(), [inner.join("a"), inner.join("b")]);
        assert_eq!(entries(&inner), ["a", "b"]);
        assert_eq!(fs::read(inner.join("b")).unwrap(), b"second");
    }

    #[test]
    fn a_failing_write_leaves_nothing_and_the_old_file_alone() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a"), "old").unwrap();
        let mut files = in_folder(folder.path(), &["a", "b"]).unwrap();
        files.write("a", |w| w.write_all(b"new")).unwrap();
        let failure = files.write("b", |w| {
            w.write_all(b"half of")?;
            Err(io::Error::other("the disk is full"))
        });
        let message = failure.unwrap_err().to_string();
        assert!(message.contains("the disk is full") && message.contains("b"), "{message}");
        drop(files);
        assert_eq!(entries(folder.path()), ["a"]);
        assert_eq!(fs::read_to_string(folder.path().join("a")).unwrap(), "old");
    }

    #[test]
    fn a_name_that_was_not_told_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let failure = in_folder(folder.path(), &["a"]).unwrap().write("b", |_| Ok(()));
        assert!(failure.unwrap_err().to_string().contains("no output file of that name"));
    }

    #[test]
    fn a_name_that_is_taken_by_a_folder_is_found_before_the_run() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("b")).unwrap();
        assert!(matches!(in_folder(folder.path(), &["a", "b"]), Err(Error::Write { path, .. }) if path.ends_with("b")));
        assert_eq!(entries(folder.path()), ["b"]);
    }

    /// The names are taken while the run goes on.
    #[test]
    fn a_folder_that_comes_later_leaves_the_old_files_alone() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a"), "old").unwrap();
        let mut files = in_folder(folder.path(), &["a", "b"]).unwrap();
        files.write("a", |w| w.write_all(b"first")).unwrap();
        files.write("b", |w| w.write_all(b"second")).unwrap();
        fs::create_dir(folder.path().join("b")).unwrap();
        assert!(matches!(files.publish(), Err(Error::Write { path, .. }) if path.ends_with("b")));
        assert_eq!(entries(folder.path()), ["a", "b"]);
        assert_eq!(fs::read_to_string(folder.path().join("a")).unwrap(), "old");
    }

    #[test]
    fn a_folder_that_is_removed_during_the_run_comes_again() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("inner");
        let mut files = in_folder(&inner, &["a"]).unwrap();
        fs::remove_dir(&inner).unwrap();
        files.write("a", |w| w.write_all(b"first")).unwrap();
        files.publish().unwrap();
        assert_eq!(entries(&inner), ["a"]);
    }

    /// Not even the superuser writes there.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_folder_that_cannot_be_written_is_found_before_the_run() {
        for folder in ["/proc/self", "/proc/ancf/new"] {
            assert!(matches!(in_folder(Path::new(folder), &["a"]), Err(Error::Write { .. })), "{folder}");
        }
    }

    #[test]
    fn an_output_replaces_no_input() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a"), "input").unwrap();
        let input = folder.path().join("../").join(folder.path().file_name().unwrap()).join("a");
        let refused = |out: &Path| Files::in_folder(out, ["b", "a"], &[&input]);
        assert!(matches!(refused(folder.path()), Err(Error::OverwritesInput { path }) if path.ends_with("a")));
        refused(&folder.path().join("out")).unwrap();
    }

    #[test]
    fn every_text_carries_the_id_of_the_tables() {
        let folder = tempfile::tempdir().unwrap();
        let mut files = in_folder(folder.path(), &["a.json", "b.csv", "c.svg"]).unwrap();
        files.write_text("a.json", "{\n  \"b\": 1\n}".into()).unwrap();
        files.write_table("b.csv", |w| w.write_all(b"abc")).unwrap();
        files.write_text("c.svg", "<svg/>".into()).unwrap();
        assert_eq!(files.run_id(), "ba7816bf8f01cfea");
        files.publish().unwrap();
        for name in ["a.json", "c.svg"] {
            let text = fs::read_to_string(folder.path().join(name)).unwrap();
            assert!(text.contains("ba7816bf8f01cfea"), "{text}");
        }
        assert_eq!(fs::read_to_string(folder.path().join("b.csv")).unwrap(), "abc");
    }

    /// Each pair ends as the whole set of one of them, and no hidden file is left.
    #[test]
    fn two_at_once_are_both_whole() {
        let folder = tempfile::tempdir().unwrap();
        let publish = |text: &'static [u8]| {
            let mut files = in_folder(folder.path(), &["a", "b", "c"]).unwrap();
            for name in ["a", "b", "c"] {
                files.write(name, |w| w.write_all(text)).unwrap();
            }
            files.publish().unwrap();
        };
        for _ in 0..50 {
            std::thread::scope(|scope| {
                let both = [&b"one"[..], b"two"].map(|text| scope.spawn(|| publish(text)));
                both.map(|one| one.join().unwrap())
            });
            let [a, b, c] = ["a", "b", "c"].map(|name| fs::read(folder.path().join(name)).unwrap());
            assert!(a == b && b == c);
        }
        assert_eq!(entries(folder.path()), ["a", "b", "c"]);
    }

    #[test]
    fn numbered_files_of_an_earlier_run_are_removed() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["a.1.vtu", "a.2.vtu", "a.vtu", "a.x.vtu", "ba.1.vtu"] {
            fs::write(folder.path().join(name), "old").unwrap();
        }
        let mut files = in_folder(folder.path(), &[]).unwrap().numbered(&[("a.", ".vtu")]);
        files.write("a.1.vtu", |w| w.write_all(b"new")).unwrap();
        assert!(files.write("a.x.vtu", |_| Ok(())).is_err());
        files.publish().unwrap();
        assert_eq!(entries(folder.path()), ["a.1.vtu", "a.vtu", "a.x.vtu", "ba.1.vtu"]);
        assert_eq!(fs::read(folder.path().join("a.1.vtu")).unwrap(), b"new");
    }

    #[cfg(unix)]
    #[test]
    fn others_may_read_what_the_umask_lets_them() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("plain"), "").unwrap();
        let mut files = in_folder(folder.path(), &["a"]).unwrap();
        files.write("a", |_| Ok(())).unwrap();
        files.publish().unwrap();
        let mode = |name| fs::metadata(folder.path().join(name)).unwrap().permissions().mode();
        assert_eq!(mode("a"), mode("plain"));
    }
}
