//! `whitecap render`: one picture of one scene, or a sequence of them.

mod film;
mod frames;
mod sequence;

use super::options::{
    MAX_SEED, Size, WantedAdapter, WantedBackend, backend_parser, parse_size, parse_time_s,
};
use crate::failure::Failure;
use crate::stages::{StageTime, Stages, milliseconds};
use crate::whole_file::WholeFile;
use crate::{memory, openexr, png, stdout};
use anyhow::{Context, anyhow};
use clap::ValueHint;
use clap::builder::{PathBufValueParser, TypedValueParser};
use frames::{Chunk, Frames, Pattern, Rate, parse_chunk, parse_frames, parse_rate};
use std::fmt::Write;
use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;
use whitecap_render::picture::{
    AuxPicture, LightPicture, MAX_SAMPLES, Picture, PictureRequest, Pictures, SAMPLES_OF_STILL, Stage,
};
use whitecap_render::{AdapterDescription, Gpu};
use whitecap_scene::{Scene, named};

const EXAMPLES: &str = "\
Examples:
  whitecap render                                  the default scene, in the current folder
  whitecap render meshuggah -o sea.png --time 3.5  another moment
  whitecap render storm.toml --size 1920x1080      your own scene file, as storm.png
  whitecap render --adapter llvmpipe --json        on one adapter, with timings for programs
  whitecap render --samples 64 -o still.png        a smooth still, the mean of 64 drawings
  whitecap render spectral-ocean -o sea.exr        the light itself: linear, without tone map
  whitecap render spectral-ocean --aux             beside it spectral-ocean.aux.exr: depth, normals, masks
  whitecap render --frames 0..240 -o out/frame.%04d.png       ten seconds at 24 frames a second
  whitecap render --frames 0..240 --chunk 2/5 -o out/f.%d.exr the second fifth of them, as one of five machines
  whitecap render --frames 0..250 --fps 25 -o sea.mp4         a film, through your ffmpeg

Frames that are there already are kept, so a sequence that was interrupted goes on where it was; several processes \
may work on one folder. Frame 0 is at --time. With --json each frame is a line as soon as its file is there, and the \
last line is the whole.

Same scene, same seed, same time, same adapter: same picture. The file is written whole or not at all, and \
an existing one is replaced. `whitecap scenes` lists the named scenes, `whitecap adapters` the adapters.";

/// Render a picture of a scene, a sequence of pictures, or a film
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Render {
    /// A named scene, or the path of a scene file
    #[arg(default_value = named::DEFAULT, value_hint = ValueHint::FilePath)]
    scene: String,

    /// The picture's file, ending in .png, or in .exr for linear light; its folder must exist. With --frames a name with a
    /// counter, such as frame.%04d.png, or a film's, ending in .mp4 or .webm [default: SCENE's name with .png, in the
    /// current folder]
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath,
        value_parser = PathBufValueParser::new().try_map(picture_path))]
    output: Option<PathBuf>,

    /// Width and height in pixels; the adapter sets the largest
    #[arg(long, value_name = "WxH", default_value = "1280x720", allow_hyphen_values = true,
        value_parser = parse_size)]
    size: Size,

    /// The moment to show, in seconds from the scene's start: from -1000000 to 1000000
    #[arg(long, value_name = "SECONDS", default_value = "0", allow_hyphen_values = true,
        value_parser = parse_time_s)]
    time: f64,

    /// Render a sequence: the frames from A to the one before B
    #[arg(long, value_name = "A..B", allow_hyphen_values = true, value_parser = parse_frames)]
    frames: Option<Frames>,

    /// Frames a second of a sequence, as a number or a fraction such as 30000/1001
    #[arg(long, value_name = "RATE", default_value = "24", allow_hyphen_values = true, requires = "frames",
        value_parser = parse_rate)]
    fps: Rate,

    /// Render the I-th of N parts of the frames, for one machine of N
    #[arg(long, value_name = "I/N", allow_hyphen_values = true, requires = "frames", value_parser = parse_chunk)]
    chunk: Option<Chunk>,

    /// Make the frames anew that are there already
    #[arg(long, requires = "frames")]
    overwrite: bool,

    /// The seed of the sea's random phases, in place of the scene's
    #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u64).range(..=MAX_SEED))]
    seed: Option<u64>,

    /// Whole drawings whose light is averaged, from 1 to 1024, each a sample a pixel: for smooth stills [default: 4, or for
    /// the PNG of a classic technique the adapter's own smoothing]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_SAMPLES)))]
    samples: Option<u32>,

    /// Also write what each pixel's centre shows: depth, position, normal, masks of water, objects, sky and sun glint,
    /// into FILE with .aux.exr in place of its ending (docs/pictures.md)
    #[arg(long)]
    aux: bool,

    #[command(flatten)]
    adapter: WantedAdapter,

    /// Who works out a sea of spectra: the processor, or compute passes of the adapter
    #[arg(long, value_name = "WHO", default_value = "auto", value_parser = backend_parser())]
    backend: WantedBackend,

    /// Print the result as JSON: scene, picture, aux, size, samples, time, seed, adapter, stages, total, peak memory; of a
    /// sequence a line for each frame, and one of the whole
    #[arg(long)]
    pub(crate) json: bool,
}

impl Render {
    pub(crate) fn run(&self, started: Instant) -> Result<ExitCode, Failure> {
        match self.frames {
            Some(frames) => sequence::run(self, frames, started),
            None => self.still(started),
        }
    }

    fn still(&self, started: Instant) -> Result<ExitCode, Failure> {
        let mut stages = Stages::new(self.json);
        stages.begin("scene");
        let path = self.output.clone().unwrap_or_else(|| default_output(&self.scene, ".png"));
        if film::Container::of(&path).is_some() {
            return Err(Failure::Input(anyhow!("{} is a film; say which --frames", path.display())));
        }
        if Pattern::parse(&path).is_ok() {
            return Err(Failure::Input(anyhow!("{} counts frames; say which --frames", path.display())));
        }
        let scene = self.opened()?;
        let file = WholeFile::plan(&path)?;
        let aux_path = self.aux.then(|| path.with_extension("aux.exr"));
        let aux_file = aux_path.as_deref().map(WholeFile::plan).transpose()?;

        stages.begin("adapter");
        let gpu = Gpu::open(self.adapter.name.as_deref())?;

        let request = self.request();
        let mut pictures = Pictures::new(&gpu, &scene, &request);
        if aux_file.is_some() {
            pictures = pictures.expecting_aux();
        }
        let is_exr = is_exr(&path);
        let drawn = self.draw(&mut pictures, is_exr, &mut |stage, done| match done {
            Some((done, count)) if done > 0 => stages.tell(&format!("{done} of {count} samples")),
            _ => stages.begin(stage.label()),
        })?;
        stages.begin(if is_exr { "exr" } else { "png" });
        let bytes = drawn.encoded(&self.about(&scene, self.time, drawn.samples))?;
        let aux = match &aux_file {
            Some(_) => {
                stages.begin("aux");
                let aux = pictures.aux(&mut |stage| stages.tell(stage.label()))?;
                Some(encoded_aux(&aux, &self.about(&scene, self.time, Some(1)))?)
            }
            None => None,
        };
        stages.begin("file");
        if let Some((file, aux)) = aux_file.zip(aux) {
            file.write(&aux)?;
        }
        file.write(&bytes)?;

        let report = Report {
            scene: &self.scene,
            picture: path.display().to_string(),
            aux: aux_path.map(|path| path.display().to_string()),
            width: request.width,
            height: request.height,
            samples: drawn.samples,
            time_s: self.time,
            seed: scene.seed,
            adapter: &gpu.adapter,
            stages: stages.finish(),
            total_ms: milliseconds(started.elapsed()),
            peak_memory_mib: memory::peak_mib(),
        };
        if self.json { stdout::write_json(&report) } else { stdout::write(report.for_people().as_bytes()) }?;
        Ok(ExitCode::SUCCESS)
    }

    fn opened(&self) -> Result<Scene, Failure> {
        let mut scene = super::open(&self.scene)?;
        scene.seed = self.seed.unwrap_or(scene.seed);
        Ok(scene)
    }

    fn request(&self) -> PictureRequest {
        PictureRequest {
            backend: self.backend.0,
            width: self.size.width,
            height: self.size.height,
            time_s: self.time,
        }
    }

    /// One picture. `progress` hears of each stage, and while samples are drawn how many of how many.
    fn draw(
        &self,
        pictures: &mut Pictures<'_>,
        is_exr: bool,
        progress: &mut dyn FnMut(Stage, Option<(u32, u32)>),
    ) -> Result<Drawn, Failure> {
        let samples = self.samples.or(is_exr.then_some(SAMPLES_OF_STILL));
        let Some(count) = samples else {
            let picture = pictures.picture(&mut |stage| progress(stage, None))?;
            return Ok(Drawn { image: Image::Display(picture), samples });
        };
        let mut progress =
            |stage: Stage, done: u32| progress(stage, (stage == Stage::Draw).then_some((done, count)));
        let image = if is_exr {
            Image::Light(pictures.light(count, &mut progress)?)
        } else {
            Image::Display(pictures.supersampled(count, &mut progress)?)
        };
        Ok(Drawn { image, samples })
    }

    /// What the picture is of.
    fn about(&self, scene: &Scene, time_s: f64, samples: Option<u32>) -> String {
        let samples = samples.unwrap_or(1);
        let plural = if samples == 1 { "" } else { "s" };
        format!("{} at {time_s} s, seed {}, {samples} sample{plural} a pixel", self.scene, scene.seed)
    }
}

/// What came from the adapter.
struct Drawn {
    image: Image,
    /// Samples that it has been averaged from; none where the adapter smoothed.
    samples: Option<u32>,
}

enum Image {
    Display(Picture),
    Light(LightPicture),
}

impl Drawn {
    /// The bytes of its file.
    fn encoded(&self, about: &str) -> Result<Vec<u8>, Failure> {
        encoded(match &self.image {
            Image::Display(picture) => png::encode(picture),
            Image::Light(light) => openexr::encode(light, about),
        })
    }
}

/// The bytes of the file of what a picture shows beside its light.
fn encoded_aux(picture: &AuxPicture, about: &str) -> Result<Vec<u8>, Failure> {
    encoded(openexr::encode_aux(picture, about))
}

fn encoded(bytes: io::Result<Vec<u8>>) -> Result<Vec<u8>, Failure> {
    bytes.context("cannot encode the picture").map_err(Failure::Machine)
}

/// What became of the request.
#[derive(serde::Serialize)]
struct Report<'a> {
    scene: &'a str,
    picture: String,
    /// The file of what it shows beside its light, if that was asked for.
    aux: Option<String>,
    width: u32,
    height: u32,
    /// Drawings that were averaged; none where the adapter smoothed.
    samples: Option<u32>,
    time_s: f64,
    seed: u64,
    adapter: &'a AdapterDescription,
    stages: Vec<StageTime>,
    /// From the start of the process.
    total_ms: f64,
    peak_memory_mib: Option<f64>,
}

impl Report<'_> {
    fn for_people(&self) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}", self.picture);
        if let Some(aux) = &self.aux {
            let _ = writeln!(text, "{aux}");
        }
        let _ = writeln!(
            text,
            "  {} × {} pixels of {} at {} s, seed {}",
            self.width, self.height, self.scene, self.time_s, self.seed
        );
        if let Some(samples) = self.samples {
            let _ = writeln!(text, "  {samples} samples a pixel");
        }
        let _ = writeln!(text, "  on {}", self.adapter);
        let width = self.stages.iter().map(|stage| stage.name.len()).max().unwrap_or(0);
        for StageTime { name, ms } in &self.stages {
            let _ = writeln!(text, "  {name:width$} {ms:8.1} ms");
        }
        let _ = write!(text, "  {:width$} {:8.1} ms", "total", self.total_ms);
        if let Some(mib) = self.peak_memory_mib {
            let _ = write!(text, ", at most {mib:.0} MiB of memory");
        }
        text.push('\n');
        text
    }
}

fn picture_path(path: PathBuf) -> Result<PathBuf, String> {
    if has_extension(&path, "png") || is_exr(&path) || film::Container::of(&path).is_some() {
        Ok(path)
    } else {
        Err("accepted: a file name that ends in .png or .exr, or for a film in .mp4 or .webm".to_owned())
    }
}

fn is_exr(path: &Path) -> bool {
    has_extension(path, "exr")
}

fn has_extension(path: &Path, wanted: &str) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(wanted))
}

/// The scene's name, without folder and `.toml`, as a picture in the current folder.
fn default_output(scene: &str, ending: &str) -> PathBuf {
    let name = Path::new(scene).file_name().map_or_else(|| "picture".into(), |name| name.to_string_lossy());
    PathBuf::from(format!("{}{ending}", name.strip_suffix(".toml").unwrap_or(&name)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_are_png_or_exr_by_name() {
        for accepted in ["sea.png", "a/b.PNG", "sea.v2.png", "sea.exr", "sea.png.EXR", "sea.mp4", "sea.WebM"]
        {
            assert!(picture_path(accepted.into()).is_ok(), "{accepted}");
        }
        for refused in ["sea.jpg", "sea", "png", ".png", "exr", ".exr", "-", "sea.png/", "", "sea.png "] {
            let expected = refused != "sea.png/"; // a trailing slash is found when the folder is looked at
            assert_eq!(picture_path(refused.into()).is_err(), expected, "{refused:?}");
        }
    }

    #[test]
    fn a_picture_is_called_like_its_scene() {
        for (scene, picture) in
            [("meshuggah", "meshuggah.png"), ("seas/storm.toml", "storm.png"), ("a.b.toml", "a.b.png")]
        {
            assert_eq!(default_output(scene, ".png"), Path::new(picture));
        }
    }
}
