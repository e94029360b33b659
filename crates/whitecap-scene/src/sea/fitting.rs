//! What to say where the tiles of a spectral sea do not hold its waves, under the keys that the file has.

use std::f64::consts::TAU;

use whitecap_waves::model::spectral::{Band, SpectralSea};
use whitecap_waves::spectrum::Profile;
use whitecap_waves::{ParameterError, Remedy};

use super::SpectralSettings;
use crate::error::SceneError;

/// The sea's own complaint, under the key that it is about.
pub(super) fn problem(settings: &SpectralSettings, error: &ParameterError) -> SceneError {
    match *error {
        ParameterError::OutOfRange { field, value, accepted } => SceneError::about_key(
            format!("sea.{field}"),
            format!("{value} is out of range for this sea; accepted: {accepted}"),
        ),
        ParameterError::SeaDoesNotFit { system, captured_fraction, ref remedy, .. } => {
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
pub(super) fn remedy(settings: &SpectralSettings, sea: &SpectralSea, profile: &Profile) -> String {
    let cascades = &sea.parameters().cascades;
    let (first, last) = (cascades[0], cascades[cascades.len() - 1]);
    let finest = last.band.to.min(Band::of_tile(last.tile_size_m, last.resolution).to);
    let longest = Band::of_tile(first.tile_size_m, first.resolution).from;
    let too_short = profile.variance_m2(Band { from: finest, to: f64::INFINITY });
    let too_long = profile.variance_m2(Band { from: 0.0, to: longest });
    if too_long > too_short {
        format!(
            "its waves are too long for a tile of {} m; {} = {} holds them",
            first.tile_size_m,
            largest_tile(settings),
            (8.0 * TAU / profile.peak_wave_number()).ceil()
        )
    } else {
        let more = match settings.cascade {
            Some(_) => {
                format!("a greater {} or one more [[sea.cascade]] of a smaller tile", finest_tile(settings))
            }
            None => "more resolution, more cascades or a smaller tile".to_owned(),
        };
        format!("waves below {:.2} m are too short for the samples; {more} hold them", TAU / finest)
    }
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
