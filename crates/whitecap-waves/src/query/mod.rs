//! The surface over places: what a buoy, a hull or a camera asks for.
//!
//! A surface is a function of where water rests ([`Surface::sample`]); the horizontal displacement of waves takes it
//! elsewhere. [`Surface::query`] answers for a place in the world: it finds the water that is there.
//!
//! | model | how | bound |
//! | --- | --- | --- |
//! | [`SpectralSea`](crate::model::spectral::SpectralSea) | a [`Snapshot`], made once for a moment | 1 mm or 0.1 % of the significant height, whichever is larger; velocities as much a second; normals 0.1° |
//! | others | direct sums and iteration | 0.1 mm where waves do not fold |
//!
//! Where a crest folds over itself, three heights lie over one place or more. A snapshot's answer is then one of the
//! upright ones: its Jacobian is above 0.

use crate::model::{Surface, SurfacePoint};
use glam::DVec2;
use thiserror::Error;

mod inverse;
mod snapshot;

#[cfg(test)]
mod tests;

pub use snapshot::Snapshot;

/// What the normal of a [`Snapshot`]'s answer is within of the direct sum's, where J ≥ 0.3: a tenth of a degree.
const NORMAL_BOUND_RAD: f64 = 0.1 * std::f64::consts::PI / 180.0;

/// A question without an answer.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum QueryError {
    /// A place that is nowhere.
    #[error("place {index} is ({}, {}), but both coordinates must be finite", place_m.x, place_m.y)]
    NoPlace {
        /// Which of the places, counted from 0.
        index: usize,
        /// The place.
        place_m: DVec2,
    },
    /// A time that is never.
    #[error("the time is {time_s} s, but must be finite")]
    NoTime {
        /// The time.
        time_s: f64,
    },
}

/// Refuses places and times that are not finite.
///
/// # Errors
///
/// [`QueryError::NoPlace`] for the first such place, [`QueryError::NoTime`].
pub fn check(places_m: &[DVec2], time_s: f64) -> Result<(), QueryError> {
    if !time_s.is_finite() {
        return Err(QueryError::NoTime { time_s });
    }
    match places_m.iter().position(|place| !place.is_finite()) {
        Some(index) => Err(QueryError::NoPlace { index, place_m: places_m[index] }),
        None => Ok(()),
    }
}

/// The rest point whose water is over `place_m` (x east, z south) at `time_s`: the horizontal displacement is
/// undone by iteration, to a tenth of a millimetre where waves do not fold.
pub fn rest_under(surface: &(impl Surface + ?Sized), place_m: DVec2, time_s: f64) -> DVec2 {
    let mut rest_m = place_m;
    for _ in 0..24 {
        let moved = surface.sample(rest_m, time_s).displacement_m;
        let error = rest_m + DVec2::new(moved.x, moved.z) - place_m;
        if error.length() < 1e-4 {
            break;
        }
        // Damped, since near a fold the plain iteration swings.
        rest_m -= 0.8 * error;
    }
    rest_m
}

/// The answers of any surface, one place after the other.
pub(crate) fn one_by_one(
    surface: &(impl Surface + ?Sized),
    places_m: &[DVec2],
    time_s: f64,
) -> Result<Vec<SurfacePoint>, QueryError> {
    check(places_m, time_s)?;
    let answer = |&place_m: &DVec2| surface.sample(rest_under(surface, place_m, time_s), time_s);
    #[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
    {
        use rayon::prelude::*;
        Ok(places_m.par_iter().with_min_len(16).map(answer).collect())
    }
    #[cfg(not(all(feature = "parallel", not(target_arch = "wasm32"))))]
    Ok(places_m.iter().map(answer).collect())
}
