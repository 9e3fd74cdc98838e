//! Files that appear whole or not at all.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::error::{Error, Result};

/// Output files of one command: written under temporary names first, then given their names together.
///
/// Files that are dropped without [`Files::publish`] leave nothing behind but the folder.
#[derive(Debug)]
pub struct Files {
    folder: PathBuf,
    written: Vec<(NamedTempFile, PathBuf)>,
}

impl Files {
    /// Output files in `folder`, which is created if it does not exist.
    ///
    /// # Errors
    /// [`Error::Write`] if the folder can be neither found nor created.
    pub fn in_folder(folder: &Path) -> Result<Files> {
        fs::create_dir_all(folder).map_err(write_error(folder))?;
        Ok(Files { folder: folder.into(), written: Vec::new() })
    }

    /// Writes the file `name` under a temporary name; `content` gets a buffered writer.
    ///
    /// # Errors
    /// [`Error::Write`] with the file's final name and the system's reason.
    pub fn write(&mut self, name: &str, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<()> {
        let path = self.folder.join(name);
        let file = write_temporary(&self.folder, content).map_err(write_error(&path))?;
        self.written.push((file, path));
        Ok(())
    }

    /// Gives all files their final names, in the order of writing, and returns these. A file of the same name from an
    /// earlier run is replaced.
    ///
    /// # Errors
    /// [`Error::Write`] if a file cannot get its name. Those that already had theirs are removed: a new file beside
    /// old ones would look like one result.
    pub fn publish(self) -> Result<Vec<PathBuf>> {
        let mut published: Vec<PathBuf> = Vec::new();
        for (file, path) in self.written {
            if let Err(failure) = file.persist(&path) {
                for earlier in &published {
                    // The first failure is the one to tell; this one could add nothing to it.
                    let _ = fs::remove_file(earlier);
                }
                return Err(write_error(&path)(failure.error));
            }
            published.push(path);
        }
        Ok(published)
    }
}

/// The lines that tell a person which files were written.
pub fn written(paths: &[PathBuf]) -> String {
    paths.iter().map(|path| format!("wrote {}\n", path.display())).collect()
}

fn write_error(path: &Path) -> impl FnOnce(io::Error) -> Error {
    move |source| Error::Write { path: path.into(), source }
}

/// A new temporary file in `folder`, complete and on the disk.
fn write_temporary(folder: &Path, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As for any new file, the umask decides; temporary files are private otherwise.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut buffered = BufWriter::new(builder.prefix(".ancf-").tempfile_in(folder)?);
    content(&mut buffered)?;
    let file = buffered.into_inner()?;
    file.as_file().sync_all()?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entries(folder: &Path) -> Vec<String> {
        let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
        let mut names: Vec<String> = names.map(|name| name.into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn files_appear_together_in_a_new_folder() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("new/deep");
        let mut files = Files::in_folder(&inner).unwrap();
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
        let mut files = Files::in_folder(folder.path()).unwrap();
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
    fn a_name_that_is_taken_by_a_folder_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("b")).unwrap();
        let mut files = Files::in_folder(folder.path()).unwrap();
        files.write("a", |w| w.write_all(b"first")).unwrap();
        files.write("b", |w| w.write_all(b"second")).unwrap();
        assert!(matches!(files.publish(), Err(Error::Write { path, .. }) if path.ends_with("b")));
        assert_eq!(entries(folder.path()), ["b"]);
    }

    #[cfg(unix)]
    #[test]
    fn others_may_read_what_the_umask_lets_them() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("plain"), "").unwrap();
        let mut files = Files::in_folder(folder.path()).unwrap();
        files.write("a", |_| Ok(())).unwrap();
        files.publish().unwrap();
        let mode = |name| fs::metadata(folder.path().join(name)).unwrap().permissions().mode();
        assert_eq!(mode("a"), mode("plain"));
    }
}
