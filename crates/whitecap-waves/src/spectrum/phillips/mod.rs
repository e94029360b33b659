//! The Phillips spectrum as computer graphics uses it (Tessendorf, *Simulating Ocean Water*, 2001,
//! "Statistical Wave Models and the Fourier Transform"),
//! calibrated so that the sea has the height that was asked for.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | U | wind speed | m/s |
//! | ŵ | unit vector that the wind blows towards | |
//! | L | U²/g, the length that scales the sea | m |
//! | l | length below which waves are damped | m |
//! | b | energy of waves against the wind over that of waves with it | |
//! | A | amplitude constant | |
//! | Ψ | variance density | m⁴ |
//!
//! Ψ(k) = A exp(−1/(kL)²) k⁻⁴ |k̂·ŵ|² exp(−k²l²), times b where k̂·ŵ < 0.
//!
//! # The constant A
//!
//! Tessendorf leaves A free. Here it follows from the variance m0. Without damping the plane integral
//! separates into radius and angle:
//!
//! - ∫ exp(−1/(kL)²) k⁻³ dk = L²/2, by u = 1/(kL)²;
//! - ∫ cos²θ dθ = π/2 over the half plane down wind, and b π/2 over the other;
//!
//! so m0 = A · (π/2)(1 + b) · L²/2. With damping the radial integral gains the factor
//! ∫ exp(−u − a²/u) du = 2a K₁(2a), a = l/L, where K₁ is the modified Bessel function. It is below 1 and tends
//! to 1 with a → 0; A is raised to make up for it, so that the sea keeps its height.

use super::WaveSpectrum;
use crate::GRAVITY_MPS2;
use crate::error::{ParameterError, check};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, TAU};

#[cfg(test)]
mod tests;

/// What a [`Phillips`] spectrum is made from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PhillipsParameters {
    /// U in m/s, above 0 and at most 100. Sets the length of the waves and, where no height is given,
    /// their height.
    pub wind_speed_mps: f64,
    /// The unit vector the wind blows towards (`.x` east, `.y` south); see
    /// [`toward_from_nautical`](crate::direction::toward_from_nautical).
    pub toward: DVec2,
    /// Hs = 4√m0 in metres, 0..=100; `None` for that of the fully developed sea,
    /// [`Phillips::fully_developed_height_m`].
    pub significant_height_m: Option<f64>,
    /// The energy of the waves that run against the wind relative to that of the waves that run with it,
    /// 0..=1: 0 for none, 1 for Tessendorf's symmetric |k̂·ŵ|², a sea of standing waves.
    pub opposing_energy: f64,
    /// l in metres, at least 0 and at most L = U²/g: waves much shorter than 2πl are damped away. 0 for no
    /// damping.
    pub small_wave_cutoff_m: f64,
}

/// The Phillips spectrum; see the [module](self).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phillips {
    toward: DVec2,
    opposing_energy: f64,
    small_wave_cutoff_m: f64,
    length_scale_m: f64,
    amplitude: f64,
    variance_m2: f64,
}

impl Phillips {
    /// The spectrum for `parameters`, or which of them is out of its range.
    pub fn new(parameters: PhillipsParameters) -> Result<Self, ParameterError> {
        let PhillipsParameters { wind_speed_mps, toward, opposing_energy, small_wave_cutoff_m, .. } =
            parameters;
        check("wind_speed_mps", wind_speed_mps, "above 0 and at most 100", |u| u > 0.0 && u <= 100.0)?;
        check("toward", toward.length(), "a vector of length 1", |len| (len - 1.0).abs() < 1e-6)?;
        check("opposing_energy", opposing_energy, "from 0 to 1", |b| (0.0..=1.0).contains(&b))?;
        let length_scale_m = wind_speed_mps * wind_speed_mps / GRAVITY_MPS2;
        check("small_wave_cutoff_m", small_wave_cutoff_m, "at least 0 and at most U²/g", |l| {
            (0.0..=length_scale_m).contains(&l)
        })?;
        let height_m = match parameters.significant_height_m {
            Some(height_m) => height_m,
            None => Self::fully_developed_height_m(wind_speed_mps),
        };
        check("significant_height_m", height_m, "from 0 to 100", |h| (0.0..=100.0).contains(&h))?;

        let variance_m2 = (height_m / 4.0) * (height_m / 4.0);
        let angular = FRAC_PI_2 * (1.0 + opposing_energy);
        let radial =
            0.5 * length_scale_m * length_scale_m * damping_factor(small_wave_cutoff_m / length_scale_m);
        Ok(Self {
            toward,
            opposing_energy,
            small_wave_cutoff_m,
            length_scale_m,
            amplitude: variance_m2 / (angular * radial),
            variance_m2,
        })
    }

    /// The significant height in metres of a fully developed sea under a wind of `wind_speed_mps`.
    ///
    /// Pierson and Moskowitz (1964): S(ω) = α g² ω⁻⁵ exp(−β (g/(Uω))⁴) with α = 0.0081, β = 0.74 and U the
    /// wind at 19.5 m, whose integral is m0 = α U⁴/(4 β g²). Hence Hs = 4√m0 = 2 √(α/β) U²/g: 2.133 m at
    /// 10 m/s.
    pub fn fully_developed_height_m(wind_speed_mps: f64) -> f64 {
        const ALPHA: f64 = 0.0081;
        const BETA: f64 = 0.74;
        2.0 * (ALPHA / BETA).sqrt() * wind_speed_mps * wind_speed_mps / GRAVITY_MPS2
    }

    /// The wind in m/s whose Phillips sea has the peak period `peak_period_s`, for a sea that is asked for by height
    /// and period.
    ///
    /// Over frequencies in deep water, k⁻⁴ exp(−1/(kL)²) k dk = 2 g² ω⁻⁵ exp(−(g/(Uω))⁴) dω, the form of Pierson
    /// and Moskowitz with β = 1. Its peak is at ωp = (4/5)^¼ g/U.
    pub fn wind_of_peak_period_mps(peak_period_s: f64) -> f64 {
        0.8_f64.sqrt().sqrt() * GRAVITY_MPS2 * peak_period_s / TAU
    }
}

impl WaveSpectrum for Phillips {
    fn density_m4(&self, k: DVec2) -> f64 {
        let k2 = k.length_squared();
        if k2 == 0.0 {
            return 0.0;
        }
        let along = k.dot(self.toward);
        let cos2 = along * along / k2;
        let direction = if along < 0.0 { self.opposing_energy * cos2 } else { cos2 };
        let scale2 = self.length_scale_m * self.length_scale_m;
        let damping2 = self.small_wave_cutoff_m * self.small_wave_cutoff_m;
        self.amplitude * libm::exp(-1.0 / (k2 * scale2) - k2 * damping2) / (k2 * k2) * direction
    }

    fn variance_m2(&self) -> f64 {
        self.variance_m2
    }

    fn omnidirectional_m3(&self, k: f64) -> f64 {
        // cos² has the mean ½ over each half plane.
        let around = FRAC_PI_2 * (1.0 + self.opposing_energy);
        let scale2 = self.length_scale_m * self.length_scale_m;
        let damping2 = self.small_wave_cutoff_m * self.small_wave_cutoff_m;
        self.amplitude * libm::exp(-1.0 / (k * k * scale2) - k * k * damping2) / (k * k * k) * around
    }
}

/// 2a K₁(2a) for 0 ≤ `a` ≤ 1: the share of the variance that the damping leaves.
///
/// By K₁(x) = ∫₀^∞ exp(−x cosh s) cosh s ds (DLMF 10.32.9) with the trapezoidal rule, which converges
/// exponentially for an integrand that is even and dies off doubly exponentially; accurate to 1e-12.
fn damping_factor(a: f64) -> f64 {
    // Below this the factor differs from 1 by less than f64 resolves, and the range of s would grow
    // without bound.
    if a < 1e-9 {
        return 1.0;
    }
    const STEP: f64 = 0.05;
    let x = 2.0 * a;
    let term = |s: f64| x * libm::cosh(s) * libm::exp(-x * libm::cosh(s));
    // Beyond x cosh s = 50 the terms are below 1e-19.
    let last = (libm::acosh(50.0 / x) / STEP) as usize;
    STEP * (0.5 * term(0.0) + (1..=last).map(|i| term(i as f64 * STEP)).sum::<f64>())
}
