//! What to say where the tiles of a spectral sea do not hold its waves, under the keys that the file has.

use std::f64::consts::TAU;

use glam::DVec2;
use whitecap_waves::model::spectral::{Band, Cascade, SpectralSea};
use whitecap_waves::spectrum::{Profile, WaveSpectrum};
use whitecap_waves::statistics::DirectionalSum;
use whitecap_waves::{ParameterError, Remedy};

use super::spectral::{FULL, LEAST_PEAK_WAVES};
use super::system::metres;
use super::{SpectralSettings, Tiling, cascade};
use crate::error::SceneError;

/// The sea's own complaint, under the key that it is about.
pub(super) fn problem(
    settings: &SpectralSettings,
    spectra: &[Box<dyn WaveSpectrum>],
    tiling: &Tiling,
    error: &ParameterError,
) -> SceneError {
    match *error {
        ParameterError::OutOfRange { field, value, accepted } => SceneError::about_key(
            format!("sea.{field}"),
            format!("{value} is out of range for this sea; accepted: {accepted}"),
        ),
        ParameterError::SeaDoesNotFit { system, captured_fraction, .. } if settings.cascade.is_none() => {
            let (key, change) = change(settings, spectra, tiling);
            let tiles = settings.cascades(spectra, tiling);
            let (longest, shortest) = ends(&tiles);
            let tiles_carry = match tiles.len() {
                1 => "one tile carries".to_owned(),
                count => format!("{count} tiles carry"),
            };
            let problem = format!(
                "{tiles_carry} only {:.0} % of the energy of wave system {system}: {} samples a side and {} m \
                 hold waves from {:.2} to {:.1} m, and its peak is at {:.1} m; {change}",
                100.0 * captured_fraction,
                tiles[0].resolution,
                tiles[0].tile_size_m,
                TAU / shortest,
                TAU / longest,
                TAU / Profile::of(&spectra[system]).peak_wave_number()
            );
            SceneError::about_key(key, problem)
        }
        ParameterError::SeaDoesNotFit { system, captured_fraction, ref remedy, .. } => {
            if let Some(gap) = gap(settings, &Profile::of(&spectra[system])) {
                let problem = format!(
                    "the tiles carry only {:.0} % of the energy of wave system {system}: {gap}",
                    100.0 * captured_fraction
                );
                return SceneError::about_key("sea.cascade", problem);
            }
            let key = match remedy {
                Remedy::LargerTile { .. } => largest_tile(settings),
                Remedy::CloserSamples { .. } => finest_tile(settings),
            };
            let problem = match several(settings) {
                // The sea speaks of one tile as large as the first and as fine as the last.
                Some(count) => format!(
                    "the {count} tiles carry only {:.0} % of the energy of wave system {system}: {remedy}",
                    100.0 * captured_fraction
                ),
                None => error.to_string(),
            };
            SceneError::about_key(key, problem)
        }
        _ => SceneError::about_key("sea", error.to_string()),
    }
}

/// What would make the rest of a spectrum fit.
pub(super) fn remedy(
    settings: &SpectralSettings,
    spectra: &[Box<dyn WaveSpectrum>],
    tiling: &Tiling,
    sea: &SpectralSea,
    profile: &Profile,
) -> String {
    if let Some(gap) = gap(settings, profile) {
        return gap;
    }
    let cascades = &sea.parameters().cascades;
    let first = cascades[0];
    let (longest, finest) = ends(cascades);
    let planned = || change(settings, spectra, tiling).1;
    let too_short = profile.variance_m2(Band { from: finest, to: f64::INFINITY });
    let too_long = profile.variance_m2(Band { from: 0.0, to: longest });
    if too_long > too_short {
        let larger = match settings.cascade {
            Some(_) => format!("{} = {} holds them", largest_tile(settings), eight_waves_m(profile)),
            None => planned(),
        };
        format!("its waves are too long for a tile of {} m; {larger}", first.tile_size_m)
    } else {
        let more = match settings.cascade {
            Some(_) => {
                let finest = finest_tile(settings);
                format!("a greater {finest} or one more [[sea.cascade]] of a smaller tile hold them")
            }
            None => planned(),
        };
        format!("waves below {:.2} m are too short for the samples; {more}", TAU / finest)
    }
}

/// Where bands that a file says leave out more than its tiles cannot hold.
fn gap(settings: &SpectralSettings, profile: &Profile) -> Option<String> {
    cascade::widest_gap(settings.cascade.as_deref()?, profile)
}

/// Where the largest of the tiles that a file asks for holds few waves of a system's peak: one sentence for each such system.
pub(super) fn few_waves(
    settings: &SpectralSettings,
    spectra: &[Box<dyn WaveSpectrum>],
    sea: &SpectralSea,
) -> Vec<String> {
    if settings.cascade.is_none() && settings.tile_size_m.is_none() {
        return Vec::new();
    }
    let largest_m = sea.parameters().cascades[0].tile_size_m;
    let of_system = |(index, spectrum): (usize, &dyn WaveSpectrum)| {
        if spectrum.variance_m2() <= 0.0 {
            return None;
        }
        let profile = Profile::of(&spectrum);
        let length_m = TAU / profile.peak_wave_number();
        let waves = largest_m / length_m;
        (waves < LEAST_PEAK_WAVES).then(|| {
            let key = largest_tile(settings);
            format!(
                "{key} = {largest_m}: it holds {waves:.1} waves of the peak of sea.system[{index}], {} m long; fewer than \
                 {LEAST_PEAK_WAVES} have few lengths and directions, and are seen to repeat; {key} = {} holds eight",
                metres(length_m, 1),
                eight_waves_m(&profile)
            )
        })
    };
    spectra.iter().map(|spectrum| &**spectrum).enumerate().filter_map(of_system).collect()
}

/// How much broader than asked for directions may run without a word, as a factor.
const BROADENED: f64 = 1.05;

/// Where the largest tile's lattice has too few directions for a system's spread at its peak: one sentence for each such
/// system. A wave stands for a cell of 2π/L, which is 2π/(L k) wide in direction; evenly filled it has a twelfth of the square of
/// that as variance, beside the system's own.
pub(super) fn few_directions(
    settings: &SpectralSettings,
    spectra: &[Box<dyn WaveSpectrum>],
    sea: &SpectralSea,
) -> Vec<String> {
    let largest_m = sea.parameters().cascades[0].tile_size_m;
    let of_system = |(index, spectrum): (usize, &dyn WaveSpectrum)| {
        if spectrum.variance_m2() <= 0.0 {
            return None;
        }
        let peak = Profile::of(&spectrum).peak_wave_number();
        if largest_m * peak < LEAST_PEAK_WAVES * TAU {
            return None; // few_waves says it
        }
        let spread = spread_rad(spectrum, peak);
        let of_cells = TAU / (largest_m * peak) / 12.0_f64.sqrt();
        let drawn = spread.hypot(of_cells);
        let enough_m = (TAU / peak / (12.0 * (BROADENED.powi(2) - 1.0)).sqrt() / spread).ceil();
        (drawn > BROADENED * spread && spread > 0.0).then(|| {
            let key = largest_tile(settings);
            format!(
                "{key} = {largest_m}: waves at the peak of sea.system[{index}] spread over {:.1}°, drawn over {:.1}°, as a tile has \
                 only so many directions; {key} = {enough_m} has enough",
                spread.to_degrees(),
                drawn.to_degrees()
            )
        })
    };
    spectra.iter().map(|spectrum| &**spectrum).enumerate().filter_map(of_system).collect()
}

/// The spread of a spectrum's directions at one wave number.
fn spread_rad(spectrum: &dyn WaveSpectrum, wave_number: f64) -> f64 {
    /// Steps of a tenth of the narrowest spread.
    const DIRECTIONS: u32 = 1440;
    let mut sum = DirectionalSum::default();
    for i in 0..DIRECTIONS {
        let toward = DVec2::from_angle(TAU * f64::from(i) / f64::from(DIRECTIONS));
        sum.add(spectrum.density_m4(wave_number * toward), toward);
    }
    sum.spread_rad()
}

/// The side of a tile that holds eight waves of the peak.
fn eight_waves_m(profile: &Profile) -> f64 {
    (8.0 * TAU / profile.peak_wave_number()).ceil()
}

/// The least change of the keys of a plan with which its tiles hold all systems: the first of the keys, and a phrase.
fn change(
    settings: &SpectralSettings,
    spectra: &[Box<dyn WaveSpectrum>],
    tiling: &Tiling,
) -> (&'static str, String) {
    let profiles: Vec<_> = spectra.iter().filter(|one| one.variance_m2() > 0.0).map(Profile::of).collect();
    let peaks = || profiles.iter().map(|profile| TAU / profile.peak_wave_number());
    let eight_peaks_m = Some(profiles.iter().map(eight_waves_m).fold(8.0, f64::max));
    // A quarter of a peak's length has 4 % of the energy of a wind sea below it, an eighth 1 %.
    let eighth_peak_m = Some((1e3 * peaks().fold(1e3, f64::min) / 8.0).floor().max(1.0) / 1e3);
    let cascades_now = settings.cascades.unwrap_or(tiling.cascades);
    let resolution_now = settings.resolution.unwrap_or(tiling.resolution);
    let mut least: Option<(u64, SpectralSettings)> = None;
    for cascades in cascades_now..=tiling.cascades.max(cascades_now) {
        for resolution in (0..8).map(|doubled| resolution_now << doubled).take_while(|side| *side <= 2048) {
            for tile_size_m in [settings.tile_size_m, eight_peaks_m] {
                for shortest_wave_m in [settings.shortest_wave_m, eighth_peak_m] {
                    let mut tried = settings.clone();
                    let keys = tried.replan(cascades, resolution, tile_size_m, shortest_wave_m, tiling);
                    // A key more is worth a quarter of the samples.
                    let cost = (u64::from(cascades) * u64::from(resolution).pow(2)) << (2 * keys);
                    let is_less = least.as_ref().is_none_or(|(known, _)| cost < *known);
                    if is_less && holds(&tried.cascades(spectra, tiling), &profiles) {
                        least = Some((cost, tried));
                    }
                }
            }
        }
    }
    let Some((_, found)) = least else {
        return (
            "sea.system",
            "no tiles of this technique hold all of its systems; draw them apart".to_owned(),
        );
    };
    let count = |now: Option<u32>, then: Option<u32>| (now != then).then_some(then).flatten().map(f64::from);
    let real = |now: Option<f64>, then: Option<f64>| (now != then).then_some(then).flatten();
    let keys = [
        ("sea.cascades", count(settings.cascades, found.cascades)),
        ("sea.tile_size_m", real(settings.tile_size_m, found.tile_size_m)),
        ("sea.shortest_wave_m", real(settings.shortest_wave_m, found.shortest_wave_m)),
        ("sea.resolution", count(settings.resolution, found.resolution)),
    ];
    let said: Vec<_> = keys.into_iter().filter_map(|(key, value)| Some((key, value?))).collect();
    let phrase: Vec<_> = said.iter().map(|(key, value)| format!("{key} = {value}")).collect();
    let verb = if phrase.len() == 1 { "holds" } else { "hold" };
    (said.first().map_or("sea", |(key, _)| key), format!("{} {verb} them", phrase.join(" and ")))
}

/// Whether tiles carry each system but for what is not worth a warning, and waves enough of its peak.
fn holds(tiles: &[Cascade], profiles: &[Profile]) -> bool {
    profiles.iter().all(|profile| {
        if tiles[0].tile_size_m * profile.peak_wave_number() < LEAST_PEAK_WAVES * TAU {
            return false;
        }
        let part = |tile: &Cascade| {
            let lattice = Band::of_tile(tile.tile_size_m, tile.resolution);
            let (from, to) = (tile.band.from.max(lattice.from), tile.band.to.min(lattice.to));
            if from < to { profile.variance_m2(Band { from, to }) } else { 0.0 }
        };
        // A profile is good to a part of a per cent.
        let all = profile.variance_m2(Band::WHOLE);
        tiles.iter().map(part).sum::<f64>() > (FULL + 0.002) * all
    })
}

/// The wave numbers of the longest and the shortest waves of a sea's tiles.
fn ends(tiles: &[Cascade]) -> (f64, f64) {
    let (first, last) = (tiles[0], tiles[tiles.len() - 1]);
    let of = |tile: Cascade| Band::of_tile(tile.tile_size_m, tile.resolution);
    (of(first).from, last.band.to.min(of(last).to))
}

/// How many tiles the file has, where it has several.
fn several(settings: &SpectralSettings) -> Option<usize> {
    settings.cascade.as_ref().map(Vec::len).filter(|count| *count > 1)
}

/// The key of the tile that holds the longest waves.
fn largest_tile(settings: &SpectralSettings) -> String {
    match index_of(settings, |a, b| b.total_cmp(a)) {
        Some(index) => format!("sea.cascade[{index}].tile_size_m"),
        None => "sea.tile_size_m".to_owned(),
    }
}

/// The key that decides how short the shortest waves are.
fn finest_tile(settings: &SpectralSettings) -> String {
    match index_of(settings, f64::total_cmp) {
        Some(index) => format!("sea.cascade[{index}].resolution"),
        None if settings.resolution.is_some() => "sea.resolution".to_owned(),
        None => "sea.tile_size_m".to_owned(),
    }
}

/// Which table `[[sea.cascade]]` has the tile whose size comes first in this order.
fn index_of(settings: &SpectralSettings, order: impl Fn(&f64, &f64) -> std::cmp::Ordering) -> Option<usize> {
    let sizes = settings.cascade.as_ref()?.iter().map(|tile| tile.tile_size_m).enumerate();
    sizes.min_by(|a, b| order(&a.1, &b.1)).map(|(index, _)| index)
}
