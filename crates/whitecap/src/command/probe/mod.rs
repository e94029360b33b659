//! `whitecap probe`: the surface as numbers, from the model that moves it.

mod answers;
mod places;
mod points;
mod rows;

use super::options::{MAX_SEED, Place, parse_place_m, parse_time_s, parse_uv};
use super::series::{Grid, Series, parse_grid, parse_times};
use crate::failure::Failure;
use crate::stdout;
use crate::whole_file::{WholeFile, cannot_write};
use answers::{answers, answers_in_text};
use anyhow::anyhow;
use clap::ValueHint;
use places::Places;
use points::Points;
use rows::{Format, Rows};
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use whitecap_scene::sea::SeaSurface;
use whitecap_scene::{Scene, named, technique};

/// The most rows that one answer may have, about 150 GB of them.
const MAX_ROWS: u64 = 1_000_000_000;

const EXAMPLES: &str = "\
Examples:
  whitecap probe --at 0,0                               the default scene, at its origin
  whitecap probe storm.toml --at -3,4 --at 10,4         two places of your own scene
  whitecap probe --at 0,0 --time 12.5 --json            another moment, for programs
  whitecap probe --at 0,0 --times 0..600/6001 --csv     ten minutes of a buoy, ten rows a second
  whitecap probe --grid -50..50/101,-50..50/101 -o sea.csv
                                                        a square of 100 m, a row for each metre
  whitecap probe --points track.csv --csv > answers.csv places from a file with columns x_m and z_m
  whitecap probe ocean-water --uv 0.3,0.7 --time 1      in the text's own units

The numbers are those of the sea that moves the technique's surface, in 64 bits and without a graphics \
adapter: the height over a place is the one that a floating object there has, calmed towards a shore where the \
technique calms it. x is east, y up, z south. Ripples that are only drawn, as by a normal map, do not count. \
--uv answers in the units and axes of the text, z up.

Rows come moment by moment; in a moment each --at, then each line of --points, then --grid from its first z to \
its last, x running fastest; rows of --uv follow after all others. They are written as they are found, in memory \
that does not grow with their number, so that another program can read along or leave early.";

/// Print height and normal of a scene's surface at given places and times
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Probe {
    /// A named scene, or the path of a scene file
    #[arg(default_value = named::DEFAULT, value_hint = ValueHint::FilePath)]
    scene: String,

    /// A place, in metres east and south of the origin, each from -10000000 to 10000000; may be repeated
    #[arg(long, value_name = "X,Z", allow_hyphen_values = true,
        required_unless_present_any = ["uv", "points", "grid"], value_parser = parse_place_m)]
    at: Vec<Place>,

    /// A CSV file of places in metres: two columns, or a first line that names x_m and z_m among others. "-" is
    /// standard input, answered as it comes. With --times it is read first, up to 10000000 places
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    points: Option<PathBuf>,

    /// A grid of places, in metres: NX from X0 to X1 eastwards by NZ from Z0 to Z1 southwards, ends included
    #[arg(long, value_name = "X0..X1/NX,Z0..Z1/NZ", allow_hyphen_values = true, value_parser = parse_grid)]
    grid: Option<Grid>,

    /// A place in texture coordinates, for seas of sines; may be repeated, and is answered after all others
    #[arg(long, value_name = "U,V", allow_hyphen_values = true, value_parser = parse_uv)]
    uv: Vec<Place>,

    /// The moment, in seconds from the scene's start: from -1000000 to 1000000
    #[arg(long, value_name = "SECONDS", default_value = "0", allow_hyphen_values = true,
        value_parser = parse_time_s)]
    time: f64,

    /// N moments from A to B seconds, both included and evenly apart, in place of --time; with N = 1 only A
    #[arg(long, value_name = "A..B/N", allow_hyphen_values = true, conflicts_with = "time",
        value_parser = parse_times)]
    times: Option<Series>,

    /// The seed of the sea's random phases, in place of the scene's
    #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u64).range(..=MAX_SEED))]
    seed: Option<u64>,

    /// Write the rows into this file, whole or not at all, and nothing to standard output. A name that ends in
    /// .csv, .json or .txt (a table for people) says the format, unless an option does
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,

    /// Print a JSON list with x_m, z_m, time_s, height_m, displacement_m, normal and velocity_mps of each place; for
    /// --uv with u, v, time_s, height and normal. If it must end early, its last entry has the key error
    #[arg(long)]
    pub(crate) json: bool,

    /// Print CSV: a line that names the columns x_m, z_m, time_s, height_m, displacement_x_m, …, normal_z, and a
    /// line for each place
    #[arg(long, conflicts_with_all = ["json", "uv"])]
    csv: bool,
}

impl Probe {
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let mut scene = super::open(&self.scene)?;
        scene.seed = self.seed.unwrap_or(scene.seed);
        let format = self.format()?;
        let file = self.output.as_deref().map(WholeFile::plan).transpose()?;
        self.check_uv(&scene)?;
        let places = self.places()?;
        match (file, &self.output) {
            (Some(file), Some(path)) => {
                let failure = |error| cannot_write(path, error);
                file.stream(|out| {
                    self.answer(&scene, places, (format, out), &failure).map_err(|stop| stop.failure)
                })?;
            }
            _ => {
                let answered =
                    self.answer(&scene, places, (format, &mut io::stdout().lock()), &stdout::failure);
                if let Err(stop) = answered {
                    // The list has told a program already; a second document would spoil the first.
                    return if stop.told {
                        Ok(crate::report(&stop.failure, false))
                    } else {
                        Err(stop.failure)
                    };
                }
            }
        }
        Ok(ExitCode::SUCCESS)
    }

    /// Writes all rows to `out`, whose errors mean what `failure` says.
    fn answer(
        &self,
        scene: &Scene,
        mut places: Places<'_>,
        (format, out): (Format, &mut dyn Write),
        failure: &dyn Fn(io::Error) -> Failure,
    ) -> Result<(), Stop> {
        let surface = scene.surface().map_err(Failure::from)?;
        if let SeaSurface::Calm(_) = surface.sea() {
            // Nobody is left to tell if standard error is closed.
            let _ = writeln!(
                io::stderr(),
                "note: the technique {} does not move its surface, which is level everywhere",
                scene.technique.word()
            );
        }
        let mut rows = Rows::new(format, out, failure);
        let written = (|| {
            rows.begin()?;
            for time_s in self.times().values() {
                places.for_each_chunk(|chunk| {
                    let found = answers(&surface, chunk, time_s)
                        .map_err(|error| Failure::Input(anyhow!("{error}")))?;
                    found.iter().try_for_each(|answer| rows.in_world(answer))?;
                    rows.flush()
                })?;
            }
            if let SeaSurface::Sines(sines) = surface.sea() {
                for time_s in self.times().values() {
                    let mut found = answers_in_text(sines, &self.uv, time_s);
                    found.try_for_each(|answer| rows.in_text(&answer))?;
                }
            }
            rows.end()
        })();
        written.map_err(|failure| Stop { told: rows.end_early(&failure), failure })
    }

    fn places(&self) -> Result<Places<'_>, Failure> {
        let moments = self.times().count;
        let counted = self.at.len() as u64 + self.uv.len() as u64 + self.grid.map_or(0, Grid::count);
        if counted.saturating_mul(moments) > MAX_ROWS {
            return Err(Failure::Input(anyhow!(
                "{counted} places at {moments} moments are more than the {MAX_ROWS} rows that one answer may have"
            )));
        }
        let points = self.points.as_deref().map(Points::open).transpose()?;
        let points = match points {
            Some(points) if moments > 1 => {
                let places = points.read_all(MAX_ROWS / moments)?;
                return Ok(Places {
                    held: [self.at.as_slice(), &places].concat(),
                    points: None,
                    grid: self.grid.as_ref(),
                });
            }
            points => points,
        };
        Ok(Places { held: self.at.clone(), points, grid: self.grid.as_ref() })
    }

    fn times(&self) -> Series {
        self.times.unwrap_or(Series { from: self.time, to: self.time, count: 1 })
    }

    /// What an option says, or else the ending of the file's name.
    fn format(&self) -> Result<Format, Failure> {
        let Some(path) = self.output.as_deref().filter(|_| !self.csv && !self.json) else {
            return Ok(match (self.csv, self.json) {
                (true, _) => Format::Csv,
                (_, true) => Format::Json,
                _ => Format::Table,
            });
        };
        let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
        match ending.as_deref() {
            Some("csv") if self.uv.is_empty() => Ok(Format::Csv),
            Some("json") => Ok(Format::Json),
            Some("txt") => Ok(Format::Table),
            _ => {
                let (endings, options) = match self.uv.is_empty() {
                    true => (".csv, .json or .txt", "--csv or --json"),
                    false => (".json or .txt with --uv", "--json"),
                };
                Err(Failure::Input(anyhow!(
                    "the name {} says no format; accepted: a file name that ends in {endings}, or any with {options}",
                    path.display()
                )))
            }
        }
    }

    fn check_uv(&self, scene: &Scene) -> Result<(), Failure> {
        if self.uv.is_empty() || matches!(scene.sea.model, whitecap_scene::sea::SeaModel::Sines(_)) {
            return Ok(());
        }
        let having: Vec<&str> = technique::that_draw("sines").collect();
        Err(Failure::Input(anyhow!(
            "{}: the technique {} has no texture coordinates to ask by; --uv is for {}",
            self.scene,
            scene.technique.word(),
            having.join(" and ")
        )))
    }
}

/// Why the rows ended early.
struct Stop {
    failure: Failure,
    /// Whether a JSON list already says so.
    told: bool,
}

impl From<Failure> for Stop {
    fn from(failure: Failure) -> Self {
        Self { failure, told: false }
    }
}
