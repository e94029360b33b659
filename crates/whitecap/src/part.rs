//! Files on their way, which go when the process is told to end.
//!
//! A file that is dropped is removed, but a signal drops nothing. So the paths of all files on their way are kept in one
//! list, and a thread that waits for SIGINT and SIGTERM removes them and then lets the signal do what it does. Other
//! ends, such as SIGKILL, leave them behind: then the lock that a file carries while it is on its way is gone, and
//! [`sweep`] can tell it from one that somebody still writes.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The files that are on their way.
static ON_THEIR_WAY: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn on_their_way() -> MutexGuard<'static, Vec<PathBuf>> {
    ON_THEIR_WAY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A temporary file. It is removed when dropped, and when the process is told to end.
#[derive(Debug)]
pub(crate) struct Part {
    file: tempfile::NamedTempFile,
    listed: Listed,
}

/// What names of files on their way begin and end with.
const PREFIX: &str = ".whitecap-";
const SUFFIX: &str = ".part";

impl Part {
    /// A new file in `folder` with a random name that says what it will be by `extension`.
    pub(crate) fn new(folder: &Path, extension: Option<&OsStr>) -> io::Result<Self> {
        watch_signals();
        let mut suffix = OsString::new();
        if let Some(extension) = extension {
            suffix.push(".");
            suffix.push(extension);
        }
        suffix.push(SUFFIX);
        // Held until the path is listed: a file that is made is known.
        let mut paths = on_their_way();
        let file = loop {
            // Opened by ourselves, as any new file: the user's umask decides who may read it, and an error is
            // the system's own, without the random name.
            let open = |path: &Path| fs::File::options().write(true).create_new(true).open(path);
            let file = tempfile::Builder::new().prefix(PREFIX).suffix(&suffix).make_in(folder, open)?;
            // Where files cannot be locked, nobody sweeps.
            let _ = file.as_file().try_lock();
            // Somebody may have swept it away before it was locked; nobody can from now on.
            if file.path().exists() {
                break file;
            }
        };
        paths.push(file.path().to_owned());
        let listed = Listed(file.path().to_owned());
        Ok(Self { file, listed })
    }

    /// Where it is now.
    pub(crate) fn path(&self) -> &Path {
        self.file.path()
    }

    pub(crate) fn file_mut(&mut self) -> &mut fs::File {
        self.file.as_file_mut()
    }

    /// Gives the file this name, whatever had it before.
    pub(crate) fn persist(self, path: &Path) -> io::Result<()> {
        let Self { file, listed } = self;
        // Whoever is removing the files ends the process and never lets go.
        let paths = on_their_way();
        let persisted = file.persist(path);
        drop(paths);
        drop(listed);
        persisted.map(|_| ()).map_err(|refused| refused.error)
    }
}

/// Removes what killed processes have left on its way in `folder`: files that nobody holds the lock of.
pub(crate) fn sweep(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if !(name.starts_with(PREFIX) && name.ends_with(SUFFIX)) {
            continue;
        }
        // Writing, as some systems lock no file that is only read.
        let Ok(file) = fs::File::options().write(true).open(entry.path()) else { continue };
        if file.try_lock().is_ok() {
            // What cannot be removed is in nobody's way.
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// A path on the list, until it is dropped.
#[derive(Debug)]
struct Listed(PathBuf);

impl Drop for Listed {
    fn drop(&mut self) {
        on_their_way().retain(|path| *path != self.0);
    }
}

/// Waits for signals from the first file on. Where no thread can be had, files are written all the same.
#[cfg(unix)]
fn watch_signals() {
    use signal_hook::consts::{SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use std::sync::Once;

    static FIRST: Once = Once::new();
    FIRST.call_once(|| {
        let (is_ready, ready) = std::sync::mpsc::channel();
        // Only a thread that runs takes the signals: without anybody who listens they must do what they always do.
        let remove_and_end = move || {
            let Ok(mut signals) = Signals::new([SIGINT, SIGTERM]) else { return };
            let _ = is_ready.send(());
            let Some(signal) = signals.forever().next() else { return };
            // Never let go of, so that no file is made or named any more.
            let paths = on_their_way();
            for path in paths.iter() {
                // What is gone already is as wanted.
                let _ = fs::remove_file(path);
            }
            // Whoever sent the signal sees that it was the end.
            let _ = signal_hook::low_level::emulate_default_handler(signal);
            std::process::exit(128 + signal);
        };
        if std::thread::Builder::new().name("signals".to_owned()).spawn(remove_and_end).is_ok() {
            let _ = ready.recv();
        }
    });
}

#[cfg(not(unix))]
fn watch_signals() {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_behind_is_swept_and_what_is_on_its_way_is_not() {
        let folder = tempfile::tempdir().unwrap();
        let names = || fs::read_dir(folder.path()).unwrap().count();
        fs::write(folder.path().join(".whitecap-abc.png.part"), "left").unwrap();
        fs::write(folder.path().join("whitecap.part"), "another's").unwrap();
        let part = Part::new(folder.path(), Some(OsStr::new("png"))).unwrap();
        assert_eq!(names(), 3);
        sweep(folder.path());
        assert_eq!(names(), 2);
        part.persist(&folder.path().join("sea.png")).unwrap();
        sweep(folder.path());
        assert_eq!(names(), 2);
    }
}
