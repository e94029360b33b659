//! `whitecap bench`: what a frame costs, pass by pass.

use super::options::{Size, parse_size};
use crate::failure::Failure;
use crate::stages::Stages;
use crate::stdout;
use clap::ValueHint;
use std::fmt::Write;
use std::process::ExitCode;
use whitecap_render::picture::{PictureRequest, time_passes};
use whitecap_render::{AdapterDescription, Gpu, PassTime, RenderError};
use whitecap_scene::{Scene, named, technique};

const EXAMPLES: &str = "\
Examples:
  whitecap bench                           each technique's own scene
  whitecap bench meshuggah storm.toml      these
  whitecap bench --size 640x360 --json     smaller frames, for programs

Frames are drawn as a window shows them, one sample a pixel, a thirtieth of a second apart. Each pass is waited \
for by itself; its time is the median over the frames. The first frame, which warms up, does not count.";

/// Time the passes of a frame
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Bench {
    /// Named scenes, or paths of scene files [default: each technique's own]
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    scenes: Vec<String>,

    /// Width and height in pixels; the adapter sets the largest
    #[arg(long, value_name = "WxH", default_value = "1280x720", allow_hyphen_values = true,
        value_parser = parse_size)]
    size: Size,

    /// How many frames to draw of each scene: 1 to 1000
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value = "9", value_parser = clap::value_parser!(u16).range(1..=1000))]
    runs: u16,

    /// Part of the name, backend or driver of the adapter to draw with [default: the fastest kind]
    #[arg(long, value_name = "NAME", value_hint = ValueHint::Other)]
    adapter: Option<String>,

    /// Print a JSON list with scene, technique, width, height, runs, adapter, passes and sum_ms
    #[arg(long)]
    pub(crate) json: bool,
}

impl Bench {
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        // Every scene is read before the first is drawn: nobody waits for a mistake in the last.
        let opened = self.names().into_iter().map(|name| Ok((name.clone(), super::open(&name)?)));
        let scenes = opened.collect::<Result<Vec<(String, Scene)>, Failure>>()?;
        let mut stages = Stages::new(self.json);
        stages.begin("adapter");
        let gpu = Gpu::open(self.adapter.as_deref())?;
        let mut frames = Vec::new();
        for (place, (name, scene)) in scenes.iter().enumerate() {
            let about = format!("{name} ({} of {})", place + 1, scenes.len());
            stages.begin_about("frames", &about);
            let (passes, sum_ms) = timed(&gpu, scene, self.size, self.runs.into())?;
            frames.push(FrameTime {
                scene: name,
                technique: scene.technique.word(),
                width: self.size.width,
                height: self.size.height,
                runs: self.runs,
                adapter: &gpu.adapter,
                passes,
                sum_ms,
            });
        }
        stages.finish();
        if self.json {
            stdout::write_json(&frames)?;
        } else {
            stdout::write(self.for_people(&frames, &gpu.adapter).as_bytes())?;
        }
        Ok(ExitCode::SUCCESS)
    }

    /// The scenes that were asked for, or those that are called like a technique.
    fn names(&self) -> Vec<String> {
        if !self.scenes.is_empty() {
            return self.scenes.clone();
        }
        let own = technique::ALL.iter().map(|technique| technique.word);
        own.filter(|word| named::find(word).is_some()).map(str::to_owned).collect()
    }

    fn for_people(&self, frames: &[FrameTime<'_>], adapter: &AdapterDescription) -> String {
        let mut text = String::new();
        let Size { width, height } = self.size;
        let names = frames.iter().flat_map(|frame| frame.passes.iter().map(|pass| pass.name.len()));
        let column = names.max().unwrap_or(0).max("sum".len());
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{width} × {height} pixels, median of {}, on {adapter}", self.runs);
        for FrameTime { scene, passes, sum_ms, .. } in frames {
            let _ = writeln!(text, "{scene}");
            for PassTime { name, ms } in passes {
                let _ = writeln!(text, "  {name:column$} {ms:9.3} ms");
            }
            let _ = writeln!(text, "  {:column$} {sum_ms:9.3} ms", "sum");
        }
        text
    }
}

/// What a frame of one scene costs.
#[derive(serde::Serialize)]
struct FrameTime<'a> {
    scene: &'a str,
    technique: &'static str,
    width: u32,
    height: u32,
    runs: u16,
    adapter: &'a AdapterDescription,
    passes: Vec<PassTime>,
    sum_ms: f64,
}

/// The median time of each pass of `scene` and their sum, to the microsecond.
pub(super) fn timed(
    gpu: &Gpu,
    scene: &Scene,
    size: Size,
    runs: usize,
) -> Result<(Vec<PassTime>, f64), RenderError> {
    let request = PictureRequest { width: size.width, height: size.height, time_s: 0.0 };
    let mut passes = time_passes(gpu, scene, &request, runs)?;
    let to_microseconds = |ms: f64| (ms * 1e3).round() / 1e3;
    passes.iter_mut().for_each(|pass| pass.ms = to_microseconds(pass.ms));
    let sum_ms = to_microseconds(passes.iter().map(|pass| pass.ms).sum());
    Ok((passes, sum_ms))
}
