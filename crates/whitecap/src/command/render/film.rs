//! Films, which the user's own ffmpeg makes of frames.

use super::frames::{Frames, Pattern, Rate};
use super::has_extension;
use crate::failure::Failure;
use crate::part::Part;
use crate::whole_file::{WholeFile, cannot_write};
use anyhow::anyhow;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What a film is packed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Container {
    Mp4,
    WebM,
}

impl Container {
    /// By a file's ending.
    pub(super) fn of(path: &Path) -> Option<Container> {
        let all = [("mp4", Container::Mp4), ("webm", Container::WebM)];
        all.into_iter().find(|(ending, _)| has_extension(path, ending)).map(|(_, container)| container)
    }

    /// Format and codec, near to what the eye can tell from the frames.
    fn arguments(self) -> &'static [&'static str] {
        match self {
            Container::Mp4 => &["-c:v", "libx264", "-crf", "16", "-movflags", "+faststart", "-f", "mp4"],
            Container::WebM => &["-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-f", "webm"],
        }
    }
}

/// A film to be made once its frames are there. They lie in a folder beside it until it is.
pub(super) struct Film {
    path: PathBuf,
    container: Container,
    frames: PathBuf,
}

impl Film {
    /// Checks that `path` can be written and that there is an ffmpeg, before anybody works for it.
    pub(super) fn plan(path: &Path, container: Container) -> Result<Film, Failure> {
        WholeFile::plan(path)?;
        let version = ffmpeg().arg("-version").stdout(Stdio::null()).stderr(Stdio::null()).status();
        version.map_err(not_run)?;
        let mut name = path.file_name().unwrap_or_default().to_owned();
        name.push(".frames");
        Ok(Film { path: path.to_owned(), container, frames: path.with_file_name(name) })
    }

    /// What its frames are called.
    pub(super) fn pattern(&self) -> Result<Pattern, Failure> {
        Pattern::new(&self.frames, "frame.", 6, ".png").map_err(|error| Failure::Input(anyhow!(error)))
    }

    /// Makes the film of its frames, and removes them.
    pub(super) fn make(&self, pattern: &Pattern, frames: Frames, rate: Rate) -> Result<(), Failure> {
        let shown = self.path.display();
        let failure = |error: io::Error| cannot_write(&self.path, error);
        let folder = match self.path.parent() {
            Some(folder) if folder != Path::new("") => folder,
            _ => Path::new("."),
        };
        let part = Part::new(folder, self.path.extension()).map_err(failure)?;
        let output = ffmpeg()
            .args(["-hide_banner", "-loglevel", "error", "-nostdin", "-y"])
            .args(["-framerate", &rate.to_string(), "-start_number", &frames.from.to_string()])
            .arg("-i")
            .arg(pattern.counted())
            // Colour is stored for pairs of pixels.
            .args(["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"])
            .args(self.container.arguments())
            .arg(part.path())
            .stdin(Stdio::null())
            .output()
            .map_err(not_run)?;
        if !output.status.success() {
            let said = String::from_utf8_lossy(&output.stderr);
            let last: Vec<&str> = said.lines().rev().filter(|line| !line.trim().is_empty()).take(3).collect();
            let said = last.into_iter().rev().collect::<Vec<_>>().join("; ");
            let kept = self.frames.display();
            return Err(Failure::Machine(anyhow!(
                "ffmpeg could not make {shown} ({}): {said}; the frames are kept in {kept}",
                output.status
            )));
        }
        part.persist(&self.path).map_err(failure)?;
        for number in frames.numbers() {
            // What cannot be removed stays; the film is there.
            let _ = std::fs::remove_file(pattern.path(number));
        }
        let _ = std::fs::remove_dir(&self.frames);
        Ok(())
    }
}

fn ffmpeg() -> Command {
    Command::new("ffmpeg")
}

fn not_run(error: io::Error) -> Failure {
    Failure::Machine(match error.kind() {
        io::ErrorKind::NotFound => anyhow!(
            "films are made by ffmpeg, which is not on the path; install it, or render frames with -o frame.%04d.png"
        ),
        _ => anyhow!("ffmpeg does not run: {error}; render frames with -o frame.%04d.png"),
    })
}
