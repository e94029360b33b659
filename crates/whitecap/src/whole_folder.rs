//! Folders of files, each of which is written whole or not at all.

use crate::failure::Failure;
use crate::whole_file::{WholeFile, cannot_write};
use anyhow::anyhow;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// A folder to be filled once the work for it is done.
///
/// It is made when the first file is written. Files that are there are replaced one by one, each in a moment;
/// others are left alone.
#[derive(Debug)]
pub(crate) struct WholeFolder {
    path: PathBuf,
}

impl WholeFolder {
    /// Checks that `path` is a folder or can become one, before anybody works for it.
    pub(crate) fn plan(path: &Path) -> Result<Self, Failure> {
        let shown = path.display();
        match fs::metadata(path) {
            Ok(found) if found.is_dir() => {}
            Ok(_) => return Err(Failure::Input(anyhow!("{shown} is a file; name a folder"))),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                // Whatever keeps a file of this name from being made keeps the folder from it as well.
                WholeFile::plan(path)?;
            }
            Err(error) if error.kind() == io::ErrorKind::NotADirectory => {
                return Err(Failure::Input(anyhow!("a part of {shown} that should be a folder is a file")));
            }
            Err(error) if error.kind() == io::ErrorKind::InvalidFilename => {
                return Err(Failure::Input(anyhow!("cannot write {shown}: the name is too long")));
            }
            Err(error) => return Err(cannot_write(path, error)),
        }
        Ok(WholeFolder { path: path.to_owned() })
    }

    /// Checks that a file called `name` can be written into the folder, if that is there already.
    pub(crate) fn check(&self, name: &str) -> Result<(), Failure> {
        if self.path.is_dir() {
            WholeFile::plan(&self.path.join(name))?;
        }
        Ok(())
    }

    /// Makes the folder now, if it is not there.
    pub(crate) fn make(&self) -> Result<(), Failure> {
        match fs::create_dir(&self.path) {
            Ok(()) => Ok(()),
            Err(_) if self.path.is_dir() => Ok(()),
            Err(error) => Err(cannot_write(&self.path, error)),
        }
    }

    /// Writes files by name and bytes, in order. If the folder had to be made and the first file does not
    /// succeed, no folder is left behind.
    pub(crate) fn write(&self, files: &[(String, Vec<u8>)]) -> Result<(), Failure> {
        let is_new = match fs::create_dir(&self.path) {
            Ok(()) => true,
            Err(_) if self.path.is_dir() => false,
            Err(error) => return Err(cannot_write(&self.path, error)),
        };
        let written = files.iter().try_for_each(|(name, bytes)| {
            WholeFile::plan(&self.path.join(name)).and_then(|file| file.write(bytes))
        });
        if written.is_err() && is_new {
            // It goes only if it is empty.
            let _ = fs::remove_dir(&self.path);
        }
        written
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn files(names: &[&str]) -> Vec<(String, Vec<u8>)> {
        names.iter().map(|name| ((*name).to_owned(), name.as_bytes().to_vec())).collect()
    }

    #[test]
    fn a_folder_is_made_when_it_is_filled_and_not_before() {
        let around = tempfile::tempdir().unwrap();
        let path = around.path().join("gallery");
        let folder = WholeFolder::plan(&path).unwrap();
        folder.check("a.png").unwrap();
        assert_eq!(fs::read_dir(around.path()).unwrap().count(), 0, "planning leaves nothing behind");
        folder.write(&files(&["a.png", "b.html"])).unwrap();
        assert_eq!(fs::read(path.join("a.png")).unwrap(), b"a.png");
        assert_eq!(fs::read_dir(&path).unwrap().count(), 2);
    }

    #[test]
    fn files_of_an_existing_folder_are_replaced_and_others_left_alone() {
        let around = tempfile::tempdir().unwrap();
        fs::write(around.path().join("a.png"), "old").unwrap();
        fs::write(around.path().join("notes.txt"), "mine").unwrap();
        WholeFolder::plan(around.path()).unwrap().write(&files(&["a.png"])).unwrap();
        assert_eq!(fs::read(around.path().join("a.png")).unwrap(), b"a.png");
        assert_eq!(fs::read(around.path().join("notes.txt")).unwrap(), b"mine");
    }

    #[test]
    fn a_name_that_is_taken_by_a_folder_is_found_beforehand() {
        let around = tempfile::tempdir().unwrap();
        fs::create_dir(around.path().join("a.png")).unwrap();
        let folder = WholeFolder::plan(around.path()).unwrap();
        let sentence = folder.check("a.png").unwrap_err().sentence().unwrap();
        assert!(sentence.contains("a.png is a folder"), "{sentence}");
    }

    #[test]
    fn a_folder_that_had_to_be_made_does_not_stay_empty() {
        let around = tempfile::tempdir().unwrap();
        let path = around.path().join("gallery");
        let folder = WholeFolder::plan(&path).unwrap();
        folder.write(&files(&[&"x".repeat(300)])).unwrap_err();
        assert!(!path.exists());
    }
}
