//! `whitecap view`: a scene in a window.

use super::options::{Size, WantedAdapter, parse_size, parse_time_s};
use crate::failure::Failure;
use crate::png;
use crate::whole_file::WholeFile;
use clap::ValueHint;
use std::path::Path;
use std::process::ExitCode;
use whitecap_scene::named;
use whitecap_viewer::{ViewError, ViewOptions, view};

const EXAMPLES: &str = "\
Examples:
  whitecap view                       the default scene
  whitecap view meshuggah --paused    another one, at its first moment
  whitecap view storm.toml            your own scene file; saved changes are read at once

Keys W A S D fly, the mouse turns, P hides the panel, F1 shows all keys. On a machine without a screen, `whitecap render` \
makes pictures.";

/// Look at a scene in a window, and change it
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct View {
    /// A named scene, or the path of a scene file
    #[arg(default_value = named::DEFAULT, value_hint = ValueHint::FilePath)]
    scene: String,

    /// Width and height of the window in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720", allow_hyphen_values = true,
        value_parser = parse_size)]
    size: Size,

    /// The moment to begin with, in seconds from the scene's start: from -1000000 to 1000000
    #[arg(long, value_name = "SECONDS", default_value = "0", allow_hyphen_values = true,
        value_parser = parse_time_s)]
    time: f64,

    /// Begin with time standing still
    #[arg(long)]
    paused: bool,

    #[command(flatten)]
    adapter: WantedAdapter,
}

impl View {
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        view(ViewOptions {
            scene: self.scene.clone(),
            adapter: self.adapter.name.clone(),
            size_px: [self.size.width, self.size.height],
            time_s: self.time,
            is_paused: self.paused,
            encode: png::encode,
            write,
        })?;
        Ok(ExitCode::SUCCESS)
    }
}

/// Writes a file whole or not at all.
fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    let written = WholeFile::plan(path).and_then(|file| file.write(bytes));
    written.map_err(|failure| failure.sentence().unwrap_or_default())
}

impl From<ViewError> for Failure {
    fn from(error: ViewError) -> Self {
        match error {
            ViewError::Scene(error) => error.into(),
            ViewError::Render(error) => error.into(),
            ViewError::NoDisplay { .. } | ViewError::Window(_) => Failure::Machine(error.into()),
        }
    }
}
