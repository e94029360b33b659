//! Frames in a row: drawn one after the other, while the one before is encoded and written.

use super::film::{Container, Film};
use super::frames::{Frames, Pattern, check_times};
use super::{Drawn, Render, default_output, encoded_aux, is_exr};
use crate::failure::Failure;
use crate::stages::milliseconds;
use crate::whole_file::WholeFile;
use crate::whole_folder::WholeFolder;
use crate::{memory, part, stdout};
use anyhow::anyhow;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::time::Instant;
use whitecap_render::picture::{AuxPicture, Pictures};
use whitecap_render::{AdapterDescription, Gpu};
use whitecap_scene::Scene;

/// Renders the frames that are not there yet.
pub(super) fn run(render: &Render, frames: Frames, started: Instant) -> Result<ExitCode, Failure> {
    let input = |error: String| Failure::Input(anyhow!(error));
    let output = render.output.clone().unwrap_or_else(|| default_output(&render.scene, ".%04d.png"));
    check_times(frames, render.fps, render.time).map_err(input)?;
    let film = Container::of(&output).map(|container| Film::plan(&output, container)).transpose()?;
    let pattern = match &film {
        Some(film) => film.pattern()?,
        None => Pattern::parse(&output).map_err(|error| input(format!("{}: {error}", output.display())))?,
    };
    if film.is_some() && (render.chunk.is_some() || render.aux) {
        return Err(input(
            "a film has all of its frames and nothing beside them; render frames with --chunk and --aux"
                .to_owned(),
        ));
    }
    let scene = render.opened()?;
    let folder = WholeFolder::plan(pattern.folder())?;
    folder.make()?;
    part::sweep(pattern.folder());
    // Whatever keeps the first from being written keeps all.
    WholeFile::plan(&pattern.path(frames.from))?;

    let gpu = Gpu::open(render.adapter.name.as_deref())?;
    let asked = match render.chunk {
        Some(chunk) => chunk.of(frames),
        None => Some(frames),
    };
    let work = Work { render, scene: &scene, gpu: &gpu, pattern: &pattern };
    let tally = match asked {
        Some(frames) => work.all(frames)?,
        None => Tally::default(),
    };
    if let Some(film) = &film {
        film.make(&pattern, frames, render.fps)?;
    }
    let report = Report {
        scene: &render.scene,
        output: output.display().to_string(),
        frames: asked.map_or(0, Frames::count),
        made: tally.made,
        kept: tally.kept,
        width: render.size.width,
        height: render.size.height,
        seed: scene.seed,
        adapter: &gpu.adapter,
        total_ms: milliseconds(started.elapsed()),
        peak_memory_mib: memory::peak_mib(),
    };
    if render.json {
        stdout::write_json_line(&report)
    } else {
        stdout::write(report.for_people().as_bytes())
    }?;
    Ok(ExitCode::SUCCESS)
}

/// What became of the frames.
#[derive(Default)]
struct Tally {
    made: u64,
    kept: u64,
}

struct Work<'a> {
    render: &'a Render,
    scene: &'a Scene,
    gpu: &'a Gpu,
    pattern: &'a Pattern,
}

/// A frame on its way to its file.
struct Frame {
    number: u64,
    time_s: f64,
    /// None where its file is there already.
    drawn: Option<(Drawn, Option<AuxPicture>)>,
    begun: Instant,
}

impl Work<'_> {
    /// Draws here, encodes and writes on a thread of its own: of two frames at a time, one each.
    fn all(&self, frames: Frames) -> Result<Tally, Failure> {
        let bar = bar(frames.count(), self.render.json);
        std::thread::scope(|scope| {
            let (send, receive) = sync_channel(1);
            let writer = scope.spawn({
                let bar = bar.clone();
                move || self.write_all(&receive, &bar)
            });
            let drawn = self.draw_all(frames, &send, &bar);
            drop(send);
            let written = writer.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            bar.finish_and_clear();
            // What stopped the writer is why nothing more was drawn.
            let tally = written?;
            drawn.map(|()| tally)
        })
    }

    fn draw_all(&self, frames: Frames, send: &SyncSender<Frame>, bar: &ProgressBar) -> Result<(), Failure> {
        let mut pictures = Pictures::new(self.gpu, self.scene, &self.render.request());
        if self.render.aux {
            pictures = pictures.expecting_aux();
        }
        for number in frames.numbers() {
            let begun = Instant::now();
            let time_s = self.render.time + self.render.fps.time_s(number);
            let path = self.pattern.path(number);
            // Looked at now and not before: another process may have made it meanwhile.
            let is_there = path.is_file() && (!self.render.aux || aux_path(&path).is_file());
            let drawn = if is_there && !self.render.overwrite {
                None
            } else {
                pictures.at(time_s);
                bar.set_message(format!("frame {number}"));
                let drawn = self.render.draw(&mut pictures, is_exr(&path), &mut |_, _| {})?;
                let aux = if self.render.aux { Some(pictures.aux(&mut |_| {})?) } else { None };
                Some((drawn, aux))
            };
            if send.send(Frame { number, time_s, drawn, begun }).is_err() {
                break; // the writer has failed and says why
            }
        }
        Ok(())
    }

    fn write_all(&self, frames: &Receiver<Frame>, bar: &ProgressBar) -> Result<Tally, Failure> {
        let mut tally = Tally::default();
        for Frame { number, time_s, drawn, begun } in frames {
            let path = self.pattern.path(number);
            let was_kept = drawn.is_none();
            if let Some((drawn, aux)) = drawn {
                let bytes = drawn.encoded(&self.render.about(self.scene, time_s, drawn.samples))?;
                if let Some(aux) = aux {
                    // Before its picture: who sees the picture finds it.
                    let bytes = encoded_aux(&aux, &self.render.about(self.scene, time_s, Some(1)))?;
                    WholeFile::plan(&aux_path(&path))?.write(&bytes)?;
                }
                WholeFile::plan(&path)?.write(&bytes)?;
            }
            *(if was_kept { &mut tally.kept } else { &mut tally.made }) += 1;
            bar.inc(1);
            if self.render.json {
                let line = FrameReport {
                    frame: number,
                    time_s,
                    picture: path.display().to_string(),
                    kept: was_kept,
                    ms: milliseconds(begun.elapsed()),
                };
                stdout::write_json_line(&line)?;
            }
        }
        Ok(tally)
    }
}

fn aux_path(picture: &Path) -> PathBuf {
    picture.with_extension("aux.exr")
}

/// On a terminal: how many frames are done, how fast, how long it will take, and which one is drawn.
fn bar(frames: u64, is_quiet: bool) -> ProgressBar {
    let is_shown = !is_quiet && std::io::stderr().is_terminal();
    let target = if is_shown { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
    let style = ProgressStyle::default_bar();
    let template = "{wide_bar} {pos}/{len} {msg}, {per_sec}, {eta} left";
    let style = style.clone().template(template).unwrap_or(style);
    ProgressBar::with_draw_target(Some(frames), target).with_style(style)
}

/// A frame whose file is there.
#[derive(serde::Serialize)]
struct FrameReport {
    frame: u64,
    time_s: f64,
    picture: String,
    /// It was there already.
    kept: bool,
    /// From the beginning of its drawing to the end of its writing.
    ms: f64,
}

#[derive(serde::Serialize)]
struct Report<'a> {
    scene: &'a str,
    output: String,
    frames: u64,
    made: u64,
    kept: u64,
    width: u32,
    height: u32,
    seed: u64,
    adapter: &'a AdapterDescription,
    /// From the start of the process.
    total_ms: f64,
    peak_memory_mib: Option<f64>,
}

impl Report<'_> {
    fn for_people(&self) -> String {
        let Report { output, frames, made, kept, width, height, scene, seed, adapter, total_ms, .. } = self;
        let kept = match kept {
            0 => String::new(),
            1 => ", 1 was there already and is kept (--overwrite makes it anew)".to_owned(),
            kept => format!(", {kept} were there already and are kept (--overwrite makes them anew)"),
        };
        let rate = 1e3 * *made as f64 / total_ms;
        format!(
            "{output}\n  {frames} frames of {width} × {height} pixels of {scene}, seed {seed}: {made} made{kept}\n  on {adapter}\n  \
             {:.1} s, {rate:.2} frames a second\n",
            1e-3 * total_ms
        )
    }
}
