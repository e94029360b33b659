//! The growing wind sea of the JONSWAP experiment (Hasselmann et al., *Dtsch. Hydrogr. Z.* suppl. A8(12), 1973).
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | U | wind 10 m above the sea | m/s |
//! | F | fetch, the way over water that the wind has had | m |
//! | χ | g F/U², the fetch without a unit | |
//! | α | 0.076 χ^−0.22 | |
//! | ωp | 22 (g²/(U F))^⅓ = 22 (g/U) χ^−⅓ | rad/s |
//! | γ | peak enhancement; 3.3 on the mean over the experiment, 1 for Pierson and Moskowitz | |
//! | σ | 0.07 up to ωp, 0.09 beyond: the width of the peak | |
//!
//! S(ω) = α g² ω⁻⁵ exp(−5/4 (ωp/ω)⁴) γ^r, r = exp(−(ω/ωp − 1)²/(2σ²)).
//!
//! # Which height
//!
//! By wind and fetch, the sea has the height that this spectrum integrates to. The law of the same experiment
//! for the height, [`fetch_law_height_m`], was fitted separately and is a quarter lower; it is there to be
//! compared with. By height and period, α is what gives the spectrum its height.

use super::Omnidirectional;
use super::omnidirectional::FULLY_DEVELOPED_INVERSE_WAVE_AGE;
use super::pierson_moskowitz::{check_height_and_period, check_wind, unit_density, variance_of_height_m2};
use super::quadrature::integral;
use crate::GRAVITY_MPS2;
use crate::error::{ParameterError, check};
use std::f64::consts::TAU;

#[cfg(test)]
mod tests;

/// γ on the mean over the experiment.
pub const MEAN_PEAK_ENHANCEMENT: f64 = 3.3;

/// The JONSWAP spectrum; see the [module](self).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jonswap {
    /// m0 of the factor without γ^r.
    base_variance_m2: f64,
    ln_peak_enhancement: f64,
    peak_angular_frequency: f64,
    inverse_wave_age: f64,
    variance_m2: f64,
}

impl Jonswap {
    /// The sea that a wind of U = `wind_speed_mps` raises over `fetch_m` metres of water: above 0 and at most
    /// 100 m/s, 1 to 1e8 m; with γ = `peak_enhancement`, 1 to 10 (1 to 7 in nature).
    ///
    /// # Errors
    ///
    /// If one of them is out of its range.
    pub fn from_wind_and_fetch(
        wind_speed_mps: f64,
        fetch_m: f64,
        peak_enhancement: f64,
    ) -> Result<Self, ParameterError> {
        check_wind(wind_speed_mps)?;
        check("fetch_m", fetch_m, "from 1 to 1e8", |f| (1.0..=1e8).contains(&f))?;
        check_peak_enhancement(peak_enhancement)?;
        let alpha = energy_scale(wind_speed_mps, fetch_m);
        let omega_p = peak_of_fetch(wind_speed_mps, fetch_m);
        let base_variance_m2 = alpha * GRAVITY_MPS2 * GRAVITY_MPS2 / (5.0 * omega_p.powi(4));
        Ok(Self {
            base_variance_m2,
            inverse_wave_age: wind_speed_mps * omega_p / GRAVITY_MPS2,
            variance_m2: base_variance_m2 * enhanced_variance(peak_enhancement),
            ..Self::shape(omega_p, peak_enhancement)
        })
    }

    /// The sea of significant height Hs, 0..=100 m, and peak period, 0.1..=100 s, with γ =
    /// `peak_enhancement`, 1 to 10.
    ///
    /// # Errors
    ///
    /// If one of them is out of its range.
    pub fn from_height_and_period(
        significant_height_m: f64,
        peak_period_s: f64,
        peak_enhancement: f64,
    ) -> Result<Self, ParameterError> {
        check_height_and_period(significant_height_m, peak_period_s)?;
        check_peak_enhancement(peak_enhancement)?;
        let variance_m2 = variance_of_height_m2(significant_height_m);
        Ok(Self {
            base_variance_m2: variance_m2 / enhanced_variance(peak_enhancement),
            variance_m2,
            ..Self::shape(TAU / peak_period_s, peak_enhancement)
        })
    }

    fn shape(peak_angular_frequency: f64, peak_enhancement: f64) -> Self {
        Self {
            base_variance_m2: 0.0,
            ln_peak_enhancement: libm::log(peak_enhancement),
            peak_angular_frequency,
            inverse_wave_age: FULLY_DEVELOPED_INVERSE_WAVE_AGE,
            variance_m2: 0.0,
        }
    }

    /// The same shape, `factor` ≥ 0 times as much energy.
    pub(super) fn scaled(self, factor: f64) -> Self {
        Self {
            base_variance_m2: factor * self.base_variance_m2,
            variance_m2: factor * self.variance_m2,
            ..self
        }
    }
}

impl Omnidirectional for Jonswap {
    fn density_m2s(&self, omega: f64) -> f64 {
        let ratio = omega / self.peak_angular_frequency;
        let base = self.base_variance_m2 / self.peak_angular_frequency * unit_density(ratio);
        base * enhancement(ratio, self.ln_peak_enhancement)
    }

    fn peak_angular_frequency(&self) -> f64 {
        self.peak_angular_frequency
    }

    fn variance_m2(&self) -> f64 {
        self.variance_m2
    }

    fn inverse_wave_age(&self) -> f64 {
        self.inverse_wave_age
    }
}

/// α of a wind in m/s and a fetch in metres.
pub fn energy_scale(wind_speed_mps: f64, fetch_m: f64) -> f64 {
    0.076 * libm::pow(dimensionless_fetch(wind_speed_mps, fetch_m), -0.22)
}

/// χ = g F/U² of a wind in m/s and a fetch in metres.
pub fn dimensionless_fetch(wind_speed_mps: f64, fetch_m: f64) -> f64 {
    GRAVITY_MPS2 * fetch_m / (wind_speed_mps * wind_speed_mps)
}

/// The significant height in metres by the experiment's law of growth, 0.0016 √χ U²/g (m0 g²/U⁴ = 1.6e-7 χ),
/// for a wind in m/s and a fetch in metres. A quarter below the integral of the spectrum; see the
/// [module](self).
pub fn fetch_law_height_m(wind_speed_mps: f64, fetch_m: f64) -> f64 {
    0.0016 * dimensionless_fetch(wind_speed_mps, fetch_m).sqrt() * wind_speed_mps * wind_speed_mps
        / GRAVITY_MPS2
}

/// The fetch in metres at which the peak reaches that of the fully developed sea. Over more water the formulas
/// would go on growing; the sea does not.
pub fn fully_developed_fetch_m(wind_speed_mps: f64) -> f64 {
    // U ωp/g = 22 χ^−⅓.
    let chi = (22.0 / FULLY_DEVELOPED_INVERSE_WAVE_AGE).powi(3);
    chi * wind_speed_mps * wind_speed_mps / GRAVITY_MPS2
}

fn peak_of_fetch(wind_speed_mps: f64, fetch_m: f64) -> f64 {
    22.0 * libm::cbrt(GRAVITY_MPS2 * GRAVITY_MPS2 / (wind_speed_mps * fetch_m))
}

pub(super) fn check_peak_enhancement(gamma: f64) -> Result<(), ParameterError> {
    check("gamma", gamma, "from 1 to 10", |g| (1.0..=10.0).contains(&g))
}

/// γ^r at `ratio` = ω/ωp.
fn enhancement(ratio: f64, ln_peak_enhancement: f64) -> f64 {
    let width = if ratio <= 1.0 { 0.07 } else { 0.09 };
    let off = (ratio - 1.0) / width;
    libm::exp(ln_peak_enhancement * libm::exp(-0.5 * off * off))
}

/// m0(γ)/m0(1).
fn enhanced_variance(peak_enhancement: f64) -> f64 {
    let ln = libm::log(peak_enhancement);
    integral(1.0, |ratio| unit_density(ratio) * enhancement(ratio, ln))
}
