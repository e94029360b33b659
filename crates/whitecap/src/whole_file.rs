//! Files that are written whole or not at all.

use crate::failure::Failure;
use crate::part::Part;
use anyhow::anyhow;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A file to be written once the work for it is done.
///
/// The bytes go into a temporary file beside it, which takes its name when it is complete and on the
/// disk. Whoever looks at the name sees the old file or the new one, never half of one. A process that is
/// told to end leaves nothing, a killed one at most a `.whitecap-….part`.
#[derive(Debug)]
pub(crate) struct WholeFile {
    path: PathBuf,
    folder: PathBuf,
}

impl WholeFile {
    /// Checks that `path` can be written, before anybody works for it. An existing file will be replaced;
    /// a link to a file keeps its place and the file behind it is replaced.
    pub(crate) fn plan(path: &Path) -> Result<Self, Failure> {
        let shown = path.display();
        match fs::metadata(path) {
            Ok(found) if found.is_dir() => {
                return Err(Failure::Input(anyhow!("{shown} is a folder; name a file in it")));
            }
            Ok(found) if !found.is_file() => {
                return Err(Failure::Input(anyhow!("{shown} is not a regular file; choose another name")));
            }
            Ok(_) => {}
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) if error.kind() == io::ErrorKind::NotADirectory => {
                return Err(Failure::Input(anyhow!("a part of {shown} that should be a folder is a file")));
            }
            Err(error) if error.kind() == io::ErrorKind::InvalidFilename => {
                return Err(Failure::Input(anyhow!("cannot write {shown}: the name is too long")));
            }
            Err(error) => return Err(cannot_write(path, error)),
        }
        let path = if path.is_symlink() {
            fs::canonicalize(path).unwrap_or_else(|_| path.to_owned())
        } else {
            path.to_owned()
        };
        let folder = match path.parent() {
            Some(parent) if parent != Path::new("") => parent.to_owned(),
            _ => PathBuf::from("."),
        };
        if !folder.is_dir() {
            return Err(Failure::Input(anyhow!(
                "the folder {} does not exist; make it first, or choose another with --output",
                folder.display()
            )));
        }
        let file = WholeFile { path, folder };
        file.temporary().map_err(|error| cannot_write(&file.path, error))?;
        Ok(file)
    }

    /// Writes `bytes` under the planned name.
    pub(crate) fn write(&self, bytes: &[u8]) -> Result<(), Failure> {
        self.stream(|file| file.write_all(bytes).map_err(|error| cannot_write(&self.path, error)))
    }

    /// Writes what `fill` writes under the planned name, once it is done; nothing if it fails.
    pub(crate) fn stream(
        &self,
        fill: impl FnOnce(&mut fs::File) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let failure = |error| cannot_write(&self.path, error);
        let mut temporary = self.temporary().map_err(failure)?;
        fill(temporary.file_mut())?;
        temporary.file_mut().sync_all().map_err(failure)?;
        temporary.persist(&self.path).map_err(failure)
    }

    /// A file in the same folder, since renaming is atomic only within one file system. It is removed when
    /// dropped.
    fn temporary(&self) -> io::Result<Part> {
        Part::new(&self.folder, self.path.extension())
    }
}

/// Why `path` was not written, and what helps.
pub(crate) fn cannot_write(path: &Path, error: io::Error) -> Failure {
    let hint = match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => {
            "; free some space or choose another place with --output"
        }
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            "; choose a place that you may write to with --output"
        }
        _ => "",
    };
    Failure::Machine(anyhow!("cannot write {}: {error}{hint}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names_in(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }

    #[test]
    fn a_file_arrives_whole_and_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("sea.png");
        let file = WholeFile::plan(&path).unwrap();
        assert!(names_in(folder.path()).is_empty(), "planning leaves nothing behind");
        file.write(b"first").unwrap();
        WholeFile::plan(&path).unwrap().write(b"second").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"second");
        assert_eq!(names_in(folder.path()), ["sea.png"]);
    }

    #[test]
    fn a_disk_that_fills_up_half_way_leaves_the_old_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("sea.png");
        fs::write(&path, b"old").unwrap();
        let file = WholeFile::plan(&path).unwrap();
        let error = file
            .stream(|file| {
                file.write_all(b"half of the new").unwrap();
                Err(cannot_write(&path, io::ErrorKind::StorageFull.into()))
            })
            .unwrap_err();
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(names_in(folder.path()), ["sea.png"]);

        let sentence = error.sentence().unwrap();
        assert!(sentence.contains("sea.png") && sentence.contains("free some space"), "{sentence}");
    }

    #[test]
    fn a_folder_that_vanishes_during_the_work_is_an_error_with_the_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("sea.png");
        let file = WholeFile::plan(&path).unwrap();
        folder.close().unwrap();
        let sentence = file.write(b"late").unwrap_err().sentence().unwrap();
        assert!(sentence.contains("sea.png") && !sentence.contains(".part"), "{sentence}");
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link_and_others_may_read_the_file() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = tempfile::tempdir().unwrap();
        let (kept, link) = (folder.path().join("kept.png"), folder.path().join("link.png"));
        fs::write(&kept, b"old").unwrap();
        symlink(&kept, &link).unwrap();
        WholeFile::plan(&link).unwrap().write(b"new").unwrap();
        assert!(link.is_symlink());
        assert_eq!(fs::read(&kept).unwrap(), b"new");

        let ordinary = folder.path().join("ordinary");
        fs::write(&ordinary, b"").unwrap();
        let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode();
        assert_eq!(mode(&kept), mode(&ordinary));
    }
}
