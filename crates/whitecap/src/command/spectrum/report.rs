//! All that is said, for people and for programs.

use super::measure::Measured;
use super::numbers::Numbers;
use super::systems::Systems;
use std::f64::consts::TAU;
use std::fmt::Write;
use whitecap_scene::Scene;
use whitecap_scene::sea::SeaSurface;
use whitecap_waves::model::spectral::Band;
use whitecap_waves::statistics::{LatticeWaves, PolarSpectrum, whitecap_cover};

#[derive(serde::Serialize)]
pub(super) struct Report<'a> {
    scene: &'a str,
    model: &'static str,
    seed: u64,
    time_s: f64,
    requested: Numbers,
    /// Of a sea without a spectrum there is no theory.
    theory: Option<Numbers>,
    surface: Numbers,
    systems: &'a Systems,
    cascades: Vec<Cascade>,
    mean_square_slope: Slopes,
    wind_speed_mps: Option<f64>,
    /// Whether a system names the wind, or a height implies it.
    #[serde(skip)]
    is_wind_named: bool,
    /// Expected at that wind.
    whitecap_cover: Option<f64>,
    warnings: Vec<String>,
}

/// One tile of the surface.
#[derive(serde::Serialize)]
struct Cascade {
    tile_size_m: f64,
    resolution: usize,
    shortest_wavelength_m: f64,
    longest_wavelength_m: f64,
    m0_m2: f64,
}

#[derive(serde::Serialize)]
struct Slopes {
    /// On the surface.
    resolved: f64,
    /// In the spectrum.
    total: Option<f64>,
}

impl<'a> Report<'a> {
    pub(super) fn new(
        name: &'a str,
        scene: &Scene,
        time_s: f64,
        systems: &'a Systems,
        theory: Option<&PolarSpectrum>,
        measured: &Measured,
        surface: &SeaSurface,
    ) -> Self {
        let theory_numbers = theory.map(|theory| Numbers::of(&theory.statistics()));
        let wind_speed_mps = scene.sea.developed_wind_mps();
        let mut report = Self {
            scene: name,
            model: scene.sea.model.word(),
            seed: scene.seed,
            time_s,
            requested: Numbers::requested(systems),
            theory: theory_numbers,
            surface: Numbers::surface(measured),
            systems,
            cascades: cascades(measured, surface),
            mean_square_slope: Slopes {
                resolved: measured.sea().slope.total(),
                total: theory_numbers.and_then(|numbers| numbers.mean_square_slope),
            },
            wind_speed_mps,
            is_wind_named: scene.sea.wind_speed_mps() == wind_speed_mps,
            whitecap_cover: wind_speed_mps.map(whitecap_cover),
            warnings: scene.warnings.clone(),
        };
        let others = report.of_the_surface();
        report.warnings.extend(others);
        report
    }

    /// What is odd about the surface, seen from what its tiles should carry.
    fn of_the_surface(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        if self.theory.is_none() {
            warnings.push(format!(
                "a sea with model = \"{}\" has no spectrum, so there are only heights and slopes of its surface",
                self.model
            ));
            return warnings;
        }
        let carried: f64 = self.cascades.iter().map(|cascade| cascade.m0_m2).sum();
        let (asked, found) = (carried.sqrt(), self.surface.m0_m2.unwrap_or(0.0).sqrt());
        if (found - asked).abs() > 0.02 * asked {
            warnings.push(format!(
                "the surface is {:.1} % {} than its waves on average: amplitudes = \"gaussian\" leaves that to chance",
                100.0 * (found / asked - 1.0).abs(),
                if found > asked { "higher" } else { "lower" }
            ));
        }
        warnings
    }

    pub(super) fn for_people(&self) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ =
            writeln!(text, "{}: {} sea, seed {}, at {} s\n", self.scene, self.model, self.seed, self.time_s);
        let _ = writeln!(text, "{:27} {:>10} {:>10} {:>10}", "", "requested", "theory", "surface");
        let theory = self.theory.unwrap_or_default();
        for (name, digits, number) in LINES {
            let cell = |numbers: &Numbers| {
                number(numbers).map_or_else(|| "-".to_owned(), |number| format!("{number:.digits$}"))
            };
            let (asked, held, found) = (cell(&self.requested), cell(&theory), cell(&self.surface));
            let _ = writeln!(text, "{name:27} {asked:>10} {held:>10} {found:>10}");
        }
        text.push('\n');
        for Cascade { tile_size_m, resolution, shortest_wavelength_m, longest_wavelength_m, m0_m2 } in
            &self.cascades
        {
            let _ = writeln!(
                text,
                "tile of {tile_size_m:.1} m, {resolution} samples a side: waves from {shortest_wavelength_m:.2} to \
                 {longest_wavelength_m:.2} m, m0 {m0_m2:.3e} m²"
            );
        }
        if let Some(total) = self.mean_square_slope.total.filter(|&total| total > 0.0) {
            let share = 100.0 * self.mean_square_slope.resolved / total;
            let _ = writeln!(text, "the surface has {share:.0} % of the mean square slope");
        }
        if let (Some(cover), Some(wind)) = (self.whitecap_cover, self.wind_speed_mps) {
            let cover = 100.0 * cover;
            let _ = match self.is_wind_named {
                true => writeln!(text, "whitecaps cover {cover:.2} % of the sea at {wind} m/s"),
                false => writeln!(
                    text,
                    "whitecaps cover {cover:.2} % of the sea at {wind:.1} m/s, the wind of the fully developed sea of \
                     this height"
                ),
            };
        } else if self.theory.is_some() {
            let _ = writeln!(
                text,
                "no whitecap cover: no system says its wind, as measured ones and swell do not"
            );
        }
        for warning in &self.warnings {
            let _ = writeln!(text, "warning: {warning}");
        }
        text
    }
}

/// Name, decimals and value of each line of the table.
type Line = (&'static str, usize, fn(&Numbers) -> Option<f64>);

const LINES: [Line; 13] = [
    ("significant height Hs, m", 3, |numbers| numbers.significant_height_m),
    ("variance m0, m²", 4, |numbers| numbers.m0_m2),
    ("peak period Tp, s", 2, |numbers| numbers.peak_period_s),
    ("zero-crossing period Tz, s", 2, |numbers| numbers.zero_crossing_period_s),
    ("energy period Te, s", 2, |numbers| numbers.energy_period_s),
    ("mean direction, from, deg", 1, |numbers| numbers.mean_direction_from_deg),
    ("peak direction, from, deg", 1, |numbers| numbers.peak_direction_from_deg),
    ("directional spread, deg", 1, |numbers| numbers.directional_spread_deg),
    ("mean square slope", 5, |numbers| numbers.mean_square_slope),
    ("  along mean direction", 5, |numbers| numbers.mean_square_slope_along),
    ("  across it", 5, |numbers| numbers.mean_square_slope_across),
    ("skewness of heights", 3, |numbers| numbers.skewness),
    ("kurtosis of heights", 3, |numbers| numbers.kurtosis),
];

fn cascades(measured: &Measured, sea: &SeaSurface) -> Vec<Cascade> {
    let Measured::Tiles(surface) = measured else { return Vec::new() };
    let bands: Vec<Band> = match sea {
        SeaSurface::Spectral(sea) => sea.parameters().cascades.iter().map(|cascade| cascade.band).collect(),
        _ => vec![Band::WHOLE; surface.waves.len()],
    };
    let cascade = |(tile, band): (&LatticeWaves, Band)| {
        let (tile_size_m, resolution) = (tile.tile_size_m(), tile.resolution());
        Cascade {
            tile_size_m,
            resolution,
            shortest_wavelength_m: (TAU / band.to).max(2.0 * tile_size_m / resolution as f64),
            longest_wavelength_m: (TAU / band.from).min(tile_size_m),
            m0_m2: tile.waves().map(|(_, energy_m2)| energy_m2).sum(),
        }
    };
    surface.waves.iter().zip(bands).map(cascade).collect()
}
