//! What can be wrong with a request.

use thiserror::Error;

/// A parameter that no sea can be made from.
///
/// The message names the field, the value that was found and what would be accepted, so that a caller can
/// show it as it is.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ParameterError {
    /// A number outside its range, or not a number at all.
    #[error("{field} is {value}, but must be {accepted}")]
    OutOfRange {
        /// The name of the parameter, as in the struct that carries it.
        field: &'static str,
        /// The value found.
        value: f64,
        /// The accepted range in words, for instance "above 0 and at most 100".
        accepted: &'static str,
    },

    /// A spectrum of shallow water over water without a bottom.
    #[error("this spectrum is that of shallow water; set depth_m")]
    NeedsDepth,

    /// A wave system most of whose energy the lattice of a tile cannot carry.
    #[error(
        "a tile of {tile_size_m} m with {resolution} samples a side carries only {:.0} % of the energy of \
         wave system {system}: {remedy}",
        captured_fraction * 100.0
    )]
    SeaDoesNotFit {
        /// Which of the systems, counted from 0.
        system: usize,
        /// The share of its variance that the tile would carry, 0..=1.
        captured_fraction: f64,
        /// The tile's side in metres.
        tile_size_m: f64,
        /// Samples along that side.
        resolution: usize,
        /// What to change.
        remedy: Remedy,
    },
}

/// The change that would make a sea fit its tile.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum Remedy {
    /// The waves are too long for the tile.
    #[error("its waves are too long; a tile of {tile_size_m} m is large enough")]
    LargerTile {
        /// A tile of four peak wavelengths, rounded up to a whole metre.
        tile_size_m: f64,
    },
    /// The waves are too short for the spacing of the samples.
    #[error(
        "its waves are too short; samples {spacing_m:.3} m apart are close enough (a finer resolution or a smaller tile)"
    )]
    CloserSamples {
        /// The spacing that resolves nine tenths of the energy, in metres.
        spacing_m: f64,
    },
}

/// Passes `value` on if it lies within the range that `accepted` describes; never lets a NaN through.
pub(crate) fn check(
    field: &'static str,
    value: f64,
    accepted: &'static str,
    holds: impl Fn(f64) -> bool,
) -> Result<(), ParameterError> {
    if value.is_finite() && holds(value) {
        Ok(())
    } else {
        Err(ParameterError::OutOfRange { field, value, accepted })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_message_names_field_value_and_range() {
        let error = check("wind_speed_mps", -3.0, "above 0", |v| v > 0.0).unwrap_err();
        assert_eq!(error.to_string(), "wind_speed_mps is -3, but must be above 0");
    }

    #[test]
    fn what_is_not_finite_never_passes() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(check("x", value, "any number", |_| true).is_err());
        }
    }
}
