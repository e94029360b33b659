//! `whitecap spectrum`: the sea in numbers and in a chart, as asked for, as integrated, and as synthesised.

mod chart;
mod measure;
mod numbers;
mod report;
mod systems;

use super::options::{MAX_SEED, parse_time_s};
use crate::failure::Failure;
use crate::stdout;
use crate::whole_file::WholeFile;
use anyhow::anyhow;
use chart::{Figure, Kind};
use clap::ValueHint;
use clap::builder::{PathBufValueParser, TypedValueParser};
use measure::Measured;
use report::Report;
use std::path::PathBuf;
use std::process::ExitCode;
use systems::Systems;
use whitecap_scene::named;
use whitecap_waves::model::spectral::Band;
use whitecap_waves::statistics::PolarSpectrum;

const EXAMPLES: &str = "\
Examples:
  whitecap spectrum                             the default scene
  whitecap spectrum storm.toml --json           your own, for programs
  whitecap spectrum storm.toml -o storm.svg     with a chart of its spectrum
  whitecap spectrum meshuggah -o sea.png --seed 8

Three columns: what the scene asks for, what its spectrum holds by integration over all waves from 60 km to \
0.6 mm, and what is measured on the surface that the scene shows, at rest points and over a whole tile. Hs is \
4√m0; Tp belongs to the peak of S(f), Tz is 2π√(m0/m2) and Te 2π m₋₁/m0, by frequencies in the water; \
directions are those that waves come from, clockwise from north; the spread is √(2(1 − r1)). The chart shows \
S(f), the energy by direction, and both together on a compass.";

/// Print heights, periods, directions and slopes of a scene's sea, and draw its spectrum
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Spectrum {
    /// A named scene, or the path of a scene file
    #[arg(default_value = named::DEFAULT, value_hint = ValueHint::FilePath)]
    scene: String,

    /// Draw a chart into this file, ending in .svg or .png; its folder must exist
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath,
        value_parser = PathBufValueParser::new().try_map(chart_path))]
    output: Option<PathBuf>,

    /// The moment at which the surface is measured, in seconds from the scene's start: from -1000000 to 1000000
    #[arg(long, value_name = "SECONDS", default_value = "0", allow_hyphen_values = true,
        value_parser = parse_time_s)]
    time: f64,

    /// The seed of the sea's random phases, in place of the scene's
    #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u64).range(..=MAX_SEED))]
    seed: Option<u64>,

    /// Print the result as JSON: requested, theory and surface with the same keys, systems, cascades,
    /// mean_square_slope, whitecap_cover, warnings
    #[arg(long)]
    pub(crate) json: bool,
}

impl Spectrum {
    pub(crate) fn run(&self) -> Result<ExitCode, Failure> {
        let mut scene = whitecap_scene::open(&self.scene)?;
        scene.seed = self.seed.unwrap_or(scene.seed);
        let chart =
            self.output.as_deref().map(|path| Ok::<_, Failure>((Kind::of(path), WholeFile::plan(path)?)));
        let chart = chart.transpose()?;
        let spectra = scene.sea.spectra()?;
        if chart.is_some() && spectra.is_empty() {
            return Err(Failure::Input(anyhow!(
                "{}: a sea with model = \"{}\" has no spectrum to draw; charts are for \"spectral\"",
                self.scene,
                scene.sea.model.word()
            )));
        }
        let water = scene.sea.water()?;
        let theory = if spectra.is_empty() {
            None
        } else {
            let theory = PolarSpectrum::of(&spectra, water.dispersion, Band::WHOLE);
            Some(theory.map_err(|error| Failure::Input(anyhow!("{}: {error}", self.scene)))?)
        };
        let mut surface = scene.sea.build(scene.seed)?;
        let measured = Measured::of(&mut surface, &water, self.time);
        let systems = Systems::of(&scene.sea);
        let report =
            Report::new(&self.scene, &scene, self.time, &systems, theory.as_ref(), &measured, &surface);
        if let (Some((kind, file)), Some(theory), Measured::Tiles(surface)) = (chart, &theory, &measured) {
            let figure = Figure { title: &self.scene, theory, surface };
            file.write(&figure.draw(kind).map_err(Failure::Machine)?)?;
        }
        if self.json { stdout::write_json(&report) } else { stdout::write(report.for_people().as_bytes()) }?;
        Ok(ExitCode::SUCCESS)
    }
}

fn chart_path(path: PathBuf) -> Result<PathBuf, String> {
    let known = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("svg") || ending.eq_ignore_ascii_case("png"));
    if known { Ok(path) } else { Err("accepted: a file name that ends in .svg or .png".to_owned()) }
}
