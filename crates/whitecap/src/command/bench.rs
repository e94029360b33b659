//! `whitecap bench`: what a frame costs, pass by pass.

use super::options::{Size, WantedAdapter, WantedBackend, backend_parser, parse_size};
use crate::failure::Failure;
use crate::stages::Stages;
use crate::stdout;
use clap::ValueHint;
use std::fmt::Write;
use std::process::ExitCode;
use whitecap_render::picture::{PictureRequest, time_features, time_passes};
use whitecap_render::surface::Backend;
use whitecap_render::{AdapterDescription, FeatureTime, Gpu, PassTime, RenderError};
use whitecap_scene::{Scene, named, technique};

const EXAMPLES: &str = "\
Examples:
  whitecap bench                           each technique's own scene
  whitecap bench meshuggah storm.toml      these
  whitecap bench --size 640x360 --json     smaller frames, for programs
  whitecap bench spectral-ocean --features  and what foam, glitter and air cost

Frames are drawn as a window shows them, one sample a pixel, a thirtieth of a second apart. Each pass is waited \
for by itself; its time is the median over the frames. The first frame, which warms up, does not count. \
Features are left out one at a time, in frames that take turns; what the water's pass is shorter by is theirs. \
They share work, so they need not add up.";

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

    #[command(flatten)]
    adapter: WantedAdapter,

    /// Who works out a sea of spectra: the processor, or compute passes of the adapter
    #[arg(long, value_name = "WHO", default_value = "auto", value_parser = backend_parser())]
    backend: WantedBackend,

    /// Also what parts of the light cost, where a technique can leave them out: spectral-ocean
    #[arg(long)]
    features: bool,

    /// Print a JSON list with scene, technique, width, height, runs, adapter, passes, sum_ms and features
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
        let gpu = Gpu::open(self.adapter.name.as_deref())?;
        let mut frames = Vec::new();
        for (place, (name, scene)) in scenes.iter().enumerate() {
            let about = format!("{name} ({} of {})", place + 1, scenes.len());
            stages.begin_about("frames", &about);
            let runs = self.runs.into();
            let (passes, sum_ms, features) = if self.features {
                timed_by_feature(&gpu, scene, self.size, self.backend.0, runs)?
            } else {
                let (passes, sum_ms) = timed(&gpu, scene, self.size, self.backend.0, runs)?;
                (passes, sum_ms, Vec::new())
            };
            frames.push(FrameTime {
                scene: name,
                technique: scene.technique.word(),
                width: self.size.width,
                height: self.size.height,
                runs: self.runs,
                adapter: &gpu.adapter,
                passes,
                sum_ms,
                features,
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
        let names = frames.iter().flat_map(|frame| {
            let features = frame.features.iter().map(|feature| "of which ".len() + feature.name.len());
            frame.passes.iter().map(|pass| pass.name.len()).chain(features)
        });
        let column = names.max().unwrap_or(0).max("sum".len());
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{width} × {height} pixels, median of {}, on {adapter}", self.runs);
        for FrameTime { scene, passes, sum_ms, features, .. } in frames {
            let _ = writeln!(text, "{scene}");
            for PassTime { name, ms } in passes {
                let _ = writeln!(text, "  {name:column$} {ms:9.3} ms");
            }
            let _ = writeln!(text, "  {:column$} {sum_ms:9.3} ms", "sum");
            for FeatureTime { name, ms } in features {
                let _ = writeln!(text, "  {:column$} {ms:9.3} ms", format!("of which {name}"));
            }
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
    #[serde(skip_serializing_if = "Vec::is_empty")]
    features: Vec<FeatureTime>,
}

/// The median time of each pass of `scene` and their sum, to the microsecond.
pub(super) fn timed(
    gpu: &Gpu,
    scene: &Scene,
    size: Size,
    backend: Option<Backend>,
    runs: usize,
) -> Result<(Vec<PassTime>, f64), RenderError> {
    let request = PictureRequest { backend, width: size.width, height: size.height, time_s: 0.0 };
    Ok(summed(time_passes(gpu, scene, &request, runs)?))
}

/// As [`timed`], and what each feature adds to the water's pass.
fn timed_by_feature(
    gpu: &Gpu,
    scene: &Scene,
    size: Size,
    backend: Option<Backend>,
    runs: usize,
) -> Result<(Vec<PassTime>, f64, Vec<FeatureTime>), RenderError> {
    let request = PictureRequest { backend, width: size.width, height: size.height, time_s: 0.0 };
    let (passes, mut features) = time_features(gpu, scene, &request, runs)?;
    features.iter_mut().for_each(|feature| feature.ms = to_microseconds(feature.ms));
    let (passes, sum_ms) = summed(passes);
    Ok((passes, sum_ms, features))
}

/// To the microsecond, and their sum.
fn summed(mut passes: Vec<PassTime>) -> (Vec<PassTime>, f64) {
    passes.iter_mut().for_each(|pass| pass.ms = to_microseconds(pass.ms));
    let sum_ms = to_microseconds(passes.iter().map(|pass| pass.ms).sum());
    (passes, sum_ms)
}

fn to_microseconds(ms: f64) -> f64 {
    (ms * 1e3).round() / 1e3
}
