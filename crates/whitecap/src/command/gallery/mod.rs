//! `whitecap gallery`: every named scene side by side, as pictures and as a page.

mod contact_sheet;
mod page;

use super::bench::timed;
use super::options::{Size, WantedAdapter, parse_size, parse_time_s};
use crate::failure::Failure;
use crate::stages::{Stages, milliseconds};
use crate::whole_folder::WholeFolder;
use crate::{memory, png, stdout};
use anyhow::Context;
use clap::ValueHint;
use clap::builder::PossibleValuesParser;
use std::fmt::Write;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;
use whitecap_render::picture::{Picture, PictureRequest, render_picture};
use whitecap_render::{AdapterDescription, Gpu, PassTime};
use whitecap_scene::Scene;
use whitecap_scene::named::{self, NamedScene};
use whitecap_scene::reference::{Difference, differences};

const EXAMPLES: &str = "\
Examples:
  whitecap gallery -o gallery                        every named scene, and gallery/index.html
  whitecap gallery -o gallery meshuggah --time 3.5   one of them, at another moment
  whitecap gallery -o small --size 160x90 --runs 0   without timing the passes

DIR gets a picture of each scene, contact-sheet.png with all of them, and index.html, which shows with each \
picture the scene file, the text it follows, the settings that differ from the defaults, and the time of each \
pass. Everything is drawn before anything is written. Each file is written whole or not at all; files of an \
existing gallery are replaced one by one, and others are left alone.";

/// Render the named scenes into a folder, with a contact sheet and a page
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Gallery {
    /// The named scenes to show [default: all of them]
    #[arg(value_name = "SCENE", value_parser = PossibleValuesParser::new(named::ALL.iter().map(|scene| scene.name)),
        hide_possible_values = true)]
    scenes: Vec<String>,

    /// The folder to write into; it is made if it does not exist, but the folder around it must
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    output: PathBuf,

    /// Width and height of each picture in pixels; the adapter sets the largest
    #[arg(long, value_name = "WxH", default_value = "640x360", allow_hyphen_values = true,
        value_parser = parse_size)]
    size: Size,

    /// The moment to show, in seconds from the scenes' start: from -1000000 to 1000000
    #[arg(long, value_name = "SECONDS", default_value = "0", allow_hyphen_values = true,
        value_parser = parse_time_s)]
    time: f64,

    /// How many frames to time the passes by: 0 to 1000; 0 times none
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value = "3", value_parser = clap::value_parser!(u16).range(0..=1000))]
    runs: u16,

    /// Width and height in pixels of the frames that are timed
    #[arg(long, value_name = "WxH", default_value = "1280x720", allow_hyphen_values = true,
        value_parser = parse_size)]
    timing_size: Size,

    #[command(flatten)]
    adapter: WantedAdapter,

    /// Print the result as JSON: page, contact_sheet, size, time, adapter, timing, total, peak memory, and of
    /// each scene its picture, passes and differences
    #[arg(long)]
    pub(crate) json: bool,
}

/// One scene of the gallery.
struct Exhibit {
    named: &'static NamedScene,
    scene: Scene,
    picture: Picture,
    /// No pass where none was timed.
    passes: Vec<PassTime>,
    sum_ms: f64,
    differences: Vec<Difference>,
}

impl Exhibit {
    /// The name of the picture's file.
    fn file_name(&self) -> String {
        format!("{}.png", self.named.name)
    }
}

const CONTACT_SHEET: &str = "contact-sheet.png";
const PAGE: &str = "index.html";

impl Gallery {
    pub(crate) fn run(&self, started: Instant) -> Result<ExitCode, Failure> {
        let mut stages = Stages::new(self.json);
        let folder = WholeFolder::plan(&self.output)?;
        for name in self.shown().map(|named| format!("{}.png", named.name)).chain(own_names()) {
            folder.check(&name)?;
        }
        stages.begin("adapter");
        let gpu = Gpu::open(self.adapter.name.as_deref())?;

        let count = self.shown().count();
        let mut exhibits = Vec::new();
        for (place, named) in self.shown().enumerate() {
            let about = format!("{} ({} of {count})", named.name, place + 1);
            exhibits.push(self.exhibit(&gpu, named, &mut |stage| stages.begin_about(stage, &about))?);
        }

        stages.begin("png");
        let encode = |picture: &Picture| {
            png::encode(picture).context("cannot encode a picture").map_err(Failure::Machine)
        };
        let mut files = Vec::new();
        for exhibit in &exhibits {
            files.push((exhibit.file_name(), encode(&exhibit.picture)?));
        }
        files.push((CONTACT_SHEET.to_owned(), encode(&contact_sheet::draw(&exhibits))?));
        let setting = page::Setting {
            adapter: gpu.adapter.to_string(),
            time_s: self.time,
            timing_size: self.timing_size,
            runs: self.runs,
        };
        files.push((PAGE.to_owned(), page::html(&exhibits, &setting).into_bytes()));
        stages.begin("files");
        // The page last: what it shows is there.
        folder.write(&files)?;
        stages.finish();

        let report = self.report(&exhibits, &gpu.adapter, started);
        if self.json { stdout::write_json(&report) } else { stdout::write(report.for_people().as_bytes()) }?;
        Ok(ExitCode::SUCCESS)
    }

    /// The scenes that were asked for, or all, in the order of the list and each once.
    fn shown(&self) -> impl Iterator<Item = &'static NamedScene> {
        let is_asked = |named: &&NamedScene| {
            self.scenes.is_empty() || self.scenes.iter().any(|asked| asked == named.name)
        };
        named::ALL.iter().filter(is_asked)
    }

    fn exhibit(
        &self,
        gpu: &Gpu,
        named: &'static NamedScene,
        begin: &mut dyn FnMut(&'static str),
    ) -> Result<Exhibit, Failure> {
        let scene = whitecap_scene::open(named.name)?;
        let request = PictureRequest {
            backend: None,
            width: self.size.width,
            height: self.size.height,
            time_s: self.time,
        };
        let picture = render_picture(gpu, &scene, &request, &mut |stage| begin(stage.label()))?;
        let (passes, sum_ms) = if self.runs > 0 {
            begin("frames");
            timed(gpu, &scene, self.timing_size, None, self.runs.into())?
        } else {
            (Vec::new(), 0.0)
        };
        let differences = differences(&scene);
        Ok(Exhibit { named, scene, picture, passes, sum_ms, differences })
    }

    fn report<'a>(
        &self,
        exhibits: &'a [Exhibit],
        adapter: &'a AdapterDescription,
        started: Instant,
    ) -> Report<'a> {
        let shown = |name: &str| self.output.join(name).display().to_string();
        let scene = |exhibit: &'a Exhibit| SceneReport {
            scene: exhibit.named.name,
            technique: exhibit.scene.technique.word(),
            picture: shown(&exhibit.file_name()),
            passes: &exhibit.passes,
            sum_ms: (self.runs > 0).then_some(exhibit.sum_ms),
            differences: &exhibit.differences,
        };
        Report {
            page: shown(PAGE),
            contact_sheet: shown(CONTACT_SHEET),
            width: self.size.width,
            height: self.size.height,
            time_s: self.time,
            adapter,
            timing: Timing {
                width: self.timing_size.width,
                height: self.timing_size.height,
                runs: self.runs,
            },
            scenes: exhibits.iter().map(scene).collect(),
            total_ms: milliseconds(started.elapsed()),
            peak_memory_mib: memory::peak_mib(),
        }
    }
}

/// The names of the files that belong to no one scene.
fn own_names() -> [String; 2] {
    [CONTACT_SHEET.to_owned(), PAGE.to_owned()]
}

/// What became of the request.
#[derive(serde::Serialize)]
struct Report<'a> {
    page: String,
    contact_sheet: String,
    width: u32,
    height: u32,
    time_s: f64,
    adapter: &'a AdapterDescription,
    timing: Timing,
    scenes: Vec<SceneReport<'a>>,
    /// From the start of the process.
    total_ms: f64,
    peak_memory_mib: Option<f64>,
}

#[derive(serde::Serialize)]
struct Timing {
    width: u32,
    height: u32,
    runs: u16,
}

#[derive(serde::Serialize)]
struct SceneReport<'a> {
    scene: &'a str,
    technique: &'a str,
    picture: String,
    passes: &'a [PassTime],
    /// `None` where nothing was timed.
    sum_ms: Option<f64>,
    differences: &'a [Difference],
}

impl Report<'_> {
    fn for_people(&self) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}", self.page);
        let _ = writeln!(text, "{}", self.contact_sheet);
        let _ = writeln!(
            text,
            "  {} {} of {} × {} pixels at {} s, on {}",
            self.scenes.len(),
            if self.scenes.len() == 1 { "scene" } else { "scenes" },
            self.width,
            self.height,
            self.time_s,
            self.adapter
        );
        let column = self.scenes.iter().map(|scene| scene.picture.chars().count()).max().unwrap_or(0);
        for SceneReport { picture, sum_ms, .. } in &self.scenes {
            let _ = match sum_ms {
                Some(ms) => writeln!(text, "  {picture:column$} {ms:8.1} ms a frame"),
                None => writeln!(text, "  {picture}"),
            };
        }
        let _ = writeln!(text, "  in {:.1} s", self.total_ms / 1e3);
        text
    }
}
