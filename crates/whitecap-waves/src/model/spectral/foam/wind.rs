//! The wind that a sea speaks of which names none.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | k_c | where waves stop counting | rad/m |
//! | S(ω) | the spectrum of Pierson and Moskowitz | m² s |

use super::super::SpectralSea;
use super::convergence::Convergence;
use crate::GRAVITY_MPS2;
use crate::error::ParameterError;
use crate::spectrum::Omnidirectional;
use crate::spectrum::pierson_moskowitz::PiersonMoskowitz;
use crate::statistics::Moments;
use std::f64::consts::TAU;

/// Waves shorter than this many metres do not count: buoys do not measure them.
const SHORTEST_M: f64 = 6.0;

/// The wind over the deep, fully developed sea whose waves are as steep as those of `sea`, at most 60 m/s: the variance
/// of its convergence without choppiness, which is the mean square slope, with the share 1/(1 + (k/k_c)⁴) of each wave.
pub(super) fn equivalent_wind_mps(sea: &SpectralSea) -> Result<f64, ParameterError> {
    let choppiness = sea.parameters().choppiness;
    if choppiness <= 0.0 {
        return Ok(0.0);
    }
    let mut steepness = 0.0;
    for tile in sea.tiles() {
        let n = tile.parameters().resolution;
        let mut field = vec![0.0; n * n];
        Convergence::new(tile.waves(), n, TAU / SHORTEST_M)?.evaluate(0.0, &mut field);
        steepness += Moments::of(&field).variance / (choppiness * choppiness);
    }
    let (mut low, mut high) = (0.0, 60.0);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if fully_developed(middle)? < steepness {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(low)
}

/// The same of the sea of Pierson and Moskowitz under a wind 10 m above it: ∫ω⁴/g² S w² dω, by the trapezium rule over
/// ln ω.
fn fully_developed(wind_speed_mps: f64) -> Result<f64, ParameterError> {
    const STEP: f64 = 0.02;
    let sea = PiersonMoskowitz::from_wind(wind_speed_mps.max(1e-3))?;
    let shortest = TAU / SHORTEST_M;
    let density = |i: u32| {
        let omega = 0.05 * libm::exp(STEP * f64::from(i));
        let share = 1.0 / (1.0 + libm::pow(omega * omega / (GRAVITY_MPS2 * shortest), 4.0));
        let slope = omega * omega / GRAVITY_MPS2 * share;
        omega * sea.density_m2s(omega) * slope * slope
    };
    Ok(STEP * (0..400).map(density).sum::<f64>())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without the share of the waves it is α/4 E₁(β (g/(U ω))⁴), which grows by α dω/ω: an octave of waves has α ln 2.
    #[test]
    fn twice_the_wind_adds_an_octave_of_waves() {
        let fully_developed = |wind_speed_mps| fully_developed(wind_speed_mps).unwrap();
        let octave = fully_developed(16.0) - fully_developed(8.0);
        assert!((octave / (0.0081 * 2.0_f64.ln()) - 1.0).abs() < 0.02, "{octave}");
        assert!(fully_developed(0.0) < 1e-12 && fully_developed(2.0) < fully_developed(3.0));
    }
}
