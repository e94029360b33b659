//! `whitecap bake`: the surface as maps, for other programs.

mod format;
mod map;
mod sidecar;
mod surface;

use super::frames::{Chunk, Frames, Rate, check_times, parse_chunk, parse_frames, parse_rate};
use super::options::{MAX_SEED, parse_time_s};
use super::series::{Grid, parse_grid};
use crate::failure::Failure;
use crate::stages::{Stages, milliseconds};
use crate::whole_file::WholeFile;
use crate::whole_folder::WholeFolder;
use crate::{memory, part, stdout};
use anyhow::{Context, anyhow};
use clap::ValueHint;
use format::Format;
use map::{Map, Raster};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;
use surface::{Area, Place, Sea};
use whitecap_scene::{Scene, named};

/// The most samples of a rectangle: a quarter of a gigabyte a map.
const MOST_SAMPLES: u64 = 1 << 24;

const EXAMPLES: &str = "\
Examples:
  whitecap bake -o maps                            displacement and normals of each cascade, as EXR
  whitecap bake storm.toml --frames 0..240 -o maps ten seconds at 24 frames a second
  whitecap bake --maps displacement,foam --area 0..100/1025,0..100/1025 -o maps
                                                   all cascades together on a square of 100 m
  whitecap bake --format npy --maps velocity -o maps
                                                   for NumPy: numpy.load(\"maps/cascade0.velocity.0000.npy\")

DIR gets a file for each cascade, map and frame, cascade0.displacement.0000.exr, and bake.json, which says what the \
numbers are. Cascades are tiles that repeat; a sea is the sum of all of them, each at its own size. Those that bake.json \
calls sewn do not repeat in whitecap itself, which lays patches of them over one another: --area has them so. A sample lies \
over a rest point: the water that rests at (x, z) is at (x, 0, z) + displacement. Files that are there already are \
kept. No graphics adapter is needed, and the numbers are the same on every machine of a kind.";

/// Bake a sea into maps of displacement, normals, foam and more
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Bake {
    /// A named scene, or the path of a scene file
    #[arg(default_value = named::DEFAULT, value_hint = ValueHint::FilePath)]
    scene: String,

    /// The folder to write into; it is made if it does not exist, but the folder around it must
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    output: PathBuf,

    /// What to bake, separated by commas
    #[arg(long, value_name = "MAPS", value_delimiter = ',', default_values = ["displacement", "normal"])]
    maps: Vec<Map>,

    /// How to write it
    #[arg(long, value_name = "FORMAT", default_value = "exr")]
    format: Format,

    /// All cascades together, on a rectangle of rest points: NX columns from X0 to X1 eastwards by NZ rows from Z0 to Z1
    /// southwards, in metres, ends included; in place of each cascade alone
    #[arg(long, value_name = "X0..X1/NX,Z0..Z1/NZ", allow_hyphen_values = true, value_parser = parse_grid)]
    area: Option<Grid>,

    /// The frames from A to the one before B
    #[arg(long, value_name = "A..B", default_value = "0..1", allow_hyphen_values = true, value_parser = parse_frames)]
    frames: Frames,

    /// Frames a second, as a number or a fraction such as 30000/1001
    #[arg(long, value_name = "RATE", default_value = "24", allow_hyphen_values = true, value_parser = parse_rate)]
    fps: Rate,

    /// The moment of frame 0, in seconds from the scene's start: from -1000000 to 1000000
    #[arg(long, value_name = "SECONDS", default_value = "0", allow_hyphen_values = true,
        value_parser = parse_time_s)]
    time: f64,

    /// Bake the I-th of N parts of the frames, for one machine of N
    #[arg(long, value_name = "I/N", allow_hyphen_values = true, value_parser = parse_chunk)]
    chunk: Option<Chunk>,

    /// Make the files anew that are there already
    #[arg(long)]
    overwrite: bool,

    /// The seed of the sea's random phases, in place of the scene's
    #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u64).range(..=MAX_SEED))]
    seed: Option<u64>,

    /// Print a line of JSON for each frame as soon as its files are there, and one for the whole
    #[arg(long)]
    pub(crate) json: bool,
}

/// What maps are baked of, and what it is called in the names of files.
pub(super) struct Shown {
    pub(super) name: String,
    place: Place,
    pub(super) facts: serde_json::Value,
}

impl Bake {
    pub(crate) fn run(&self, started: Instant) -> Result<ExitCode, Failure> {
        let mut stages = Stages::new(self.json);
        stages.begin("sea");
        check_times(self.frames, self.fps, self.time).map_err(|error| Failure::Input(anyhow!(error)))?;
        let area = self.area.map(|grid| self.area(grid)).transpose()?;
        let mut scene = super::open(&self.scene)?;
        scene.seed = self.seed.unwrap_or(scene.seed);
        let maps = self.maps();
        let mut sea = Sea::of(&scene, &maps, area.is_some())?;
        let folder = WholeFolder::plan(&self.output)?;
        folder.make()?;
        part::sweep(&self.output);

        let shown = match area.zip(self.area) {
            Some((area, grid)) => {
                vec![Shown {
                    name: "area".to_owned(),
                    place: Place::Area(area),
                    facts: sidecar::of_area(grid),
                }]
            }
            None => (0..sea.sea().tiles().len())
                .map(|index| Shown {
                    name: format!("cascade{index}"),
                    place: Place::Cascade(index),
                    facts: sidecar::of_cascade(&sea, index),
                })
                .collect(),
        };
        let facts = sidecar::of_bake(self, &scene, &sea, self.frames, &shown);
        let facts = serde_json::to_vec_pretty(&facts).map_err(|error| Failure::Machine(error.into()))?;
        WholeFile::plan(&self.output.join("bake.json"))?.write(&[&facts[..], b"\n"].concat())?;

        stages.begin("maps");
        let part = match self.chunk {
            Some(chunk) => chunk.of(self.frames),
            None => Some(self.frames),
        };
        let work =
            Work { bake: self, scene: &scene, maps: &maps, shown: &shown, writer: Writer::new(self.json) };
        if let Some(frames) = part {
            work.all(&mut sea, frames, &stages)?;
        }
        let Writer { made, kept, cut_off, .. } = &work.writer;
        let [made, kept, cut_off] = [made, kept, cut_off].map(|count| count.load(Ordering::Relaxed));
        if cut_off > 0 {
            super::print_warnings(&[format!(
                "{cut_off} numbers lie beyond what 16 bits are bounded by in bake.json and are cut off; EXR and NumPy have room"
            )]);
        }
        stages.finish();
        let report = Report {
            scene: &self.scene,
            folder: self.output.display().to_string(),
            frames: part.map_or(0, Frames::count),
            made,
            kept,
            cut_off,
            seed: scene.seed,
            total_ms: milliseconds(started.elapsed()),
            peak_memory_mib: memory::peak_mib(),
        };
        if self.json {
            stdout::write_json_line(&report)
        } else {
            stdout::write(report.for_people().as_bytes())
        }?;
        Ok(ExitCode::SUCCESS)
    }

    /// Each map once, in an order of their own.
    fn maps(&self) -> Vec<Map> {
        let mut maps = self.maps.clone();
        maps.sort_unstable();
        maps.dedup();
        maps
    }

    fn area(&self, grid: Grid) -> Result<Area, Failure> {
        if grid.count() > MOST_SAMPLES {
            return Err(Failure::Input(anyhow!(
                "--area has {} samples; accepted: up to {MOST_SAMPLES}",
                grid.count()
            )));
        }
        Ok(Area::of(grid))
    }

    fn path(&self, shown: &Shown, map: Map, frame: u64) -> PathBuf {
        let (name, word, extension) = (&shown.name, map.word(), self.format.extension());
        self.output.join(format!("{name}.{word}.{frame:04}.{extension}"))
    }
}

/// A file to be written.
struct Job {
    frame: Arc<FrameState>,
    path: PathBuf,
    map: Map,
    raster: Raster,
    bounds: format::Bounds,
    facts: String,
}

/// How far a frame is.
struct FrameState {
    number: u64,
    time_s: f64,
    begun: Instant,
    /// Files that are not there yet.
    left: AtomicUsize,
    made: usize,
}

/// What those who write have in common.
struct Writer {
    json: bool,
    made: AtomicU64,
    kept: AtomicU64,
    cut_off: AtomicU64,
    failed: Mutex<Option<Failure>>,
}

struct Work<'a> {
    bake: &'a Bake,
    scene: &'a Scene,
    maps: &'a [Map],
    shown: &'a [Shown],
    writer: Writer,
}

impl Work<'_> {
    /// Works out the maps here; files are encoded and written by as many threads as there are cores.
    fn all(&self, sea: &mut Sea, frames: Frames, stages: &Stages) -> Result<(), Failure> {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let (send, receive) = sync_channel::<Job>(threads);
        let receive = Mutex::new(receive);
        let drawn = std::thread::scope(|scope| {
            for _ in 0..threads {
                scope.spawn(|| self.writer.work(&receive, self.bake, self.scene));
            }
            let result = self.frames(sea, frames, stages, &|job| {
                // Whoever failed takes the rest in and drops it.
                let _ = send.send(job);
            });
            drop(send);
            result
        });
        let failed = self.writer.failed.lock().unwrap_or_else(PoisonError::into_inner).take();
        failed.map_or(drawn, Err)
    }

    fn frames(
        &self,
        sea: &mut Sea,
        frames: Frames,
        stages: &Stages,
        send: &dyn Fn(Job),
    ) -> Result<(), Failure> {
        let bake = self.bake;
        for number in frames.numbers() {
            if self.writer.has_failed() {
                break;
            }
            let (begun, time_s) = (Instant::now(), bake.time + bake.fps.time_s(number));
            stages.tell(&format!("frame {number}, the last is {}", frames.to - 1));
            // Looked at now and not before: another process may have made them meanwhile.
            let is_wanted = |path: &Path| bake.overwrite || !path.is_file();
            let wanted = |shown: &Shown| -> Vec<Map> {
                let maps = self.maps.iter().copied();
                maps.filter(|map| is_wanted(&bake.path(shown, *map, number))).collect()
            };
            let wanted: Vec<(&Shown, Vec<Map>)> =
                self.shown.iter().map(|shown| (shown, wanted(shown))).collect();
            let made: usize = wanted.iter().map(|(_, maps)| maps.len()).sum();
            let kept = self.shown.len() * self.maps.len() - made;
            self.writer.kept.fetch_add(kept as u64, Ordering::Relaxed);
            let frame = Arc::new(FrameState { number, time_s, begun, left: AtomicUsize::new(made), made });
            if made == 0 {
                self.writer.tell(&frame)?;
                continue;
            }
            sea.go_to(time_s)?;
            for (shown, maps) in wanted.into_iter().filter(|(_, maps)| !maps.is_empty()) {
                let rasters = sea.rasters(&shown.place, &maps, time_s)?;
                for (map, raster) in maps.into_iter().zip(rasters) {
                    let facts = sidecar::of_file(bake, self.scene, sea, shown, map, time_s);
                    let (path, bounds) = (bake.path(shown, map, number), sea.bounds(map));
                    send(Job { frame: Arc::clone(&frame), path, map, raster, bounds, facts });
                }
            }
        }
        Ok(())
    }
}

impl Writer {
    fn new(json: bool) -> Writer {
        let count = || AtomicU64::new(0);
        Writer { json, made: count(), kept: count(), cut_off: count(), failed: Mutex::default() }
    }

    fn has_failed(&self) -> bool {
        self.failed.lock().unwrap_or_else(PoisonError::into_inner).is_some()
    }

    /// Writes what comes until nothing more does; after a failure of anybody it is only taken in.
    fn work(&self, jobs: &Mutex<Receiver<Job>>, bake: &Bake, scene: &Scene) {
        loop {
            let job = jobs.lock().unwrap_or_else(PoisonError::into_inner).recv();
            let Ok(job) = job else { return };
            if self.has_failed() {
                continue;
            }
            if let Err(failure) = self.write(&job, bake, scene) {
                self.failed.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(failure);
            }
        }
    }

    fn write(&self, job: &Job, bake: &Bake, scene: &Scene) -> Result<(), Failure> {
        let about =
            format!("{} of {} at {} s, seed {}", job.map.word(), bake.scene, job.frame.time_s, scene.seed);
        let bytes = bake
            .format
            .encode(job.map, &job.raster, job.bounds, (&about, &job.facts), &self.cut_off)
            .context("cannot encode a map")
            .map_err(Failure::Machine)?;
        WholeFile::plan(&job.path)?.write(&bytes)?;
        self.made.fetch_add(1, Ordering::Relaxed);
        if job.frame.left.fetch_sub(1, Ordering::AcqRel) == 1 {
            self.tell(&job.frame)?;
        }
        Ok(())
    }

    /// A line for a frame whose files are there.
    fn tell(&self, frame: &FrameState) -> Result<(), Failure> {
        if !self.json {
            return Ok(());
        }
        stdout::write_json_line(&serde_json::json!({
            "frame": frame.number,
            "time_s": frame.time_s,
            "made": frame.made,
            "ms": milliseconds(frame.begun.elapsed()),
        }))
    }
}

#[derive(serde::Serialize)]
struct Report<'a> {
    scene: &'a str,
    folder: String,
    frames: u64,
    /// Files.
    made: u64,
    kept: u64,
    /// Numbers beyond what a PNG has room for.
    cut_off: u64,
    seed: u64,
    /// From the start of the process.
    total_ms: f64,
    peak_memory_mib: Option<f64>,
}

impl Report<'_> {
    fn for_people(&self) -> String {
        let Report { folder, frames, made, kept, scene, seed, total_ms, .. } = self;
        let plural = if *frames == 1 { "" } else { "s" };
        let kept = match kept {
            0 => String::new(),
            kept => format!(", {kept} were there already and are kept (--overwrite makes them anew)"),
        };
        let rate = 1e3 * *frames as f64 / total_ms;
        format!(
            "{folder}\n  {frames} frame{plural} of {scene}, seed {seed}: {made} files made{kept}\n  {:.1} s, {rate:.2} frames a second\n",
            1e-3 * total_ms
        )
    }
}
