//! What a sea is, in the numbers that sailors and oceanographers use: of a spectrum by integration, of a surface
//! by measuring it.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | Ψ(k) | variance density over the wave-number plane | m⁴ |
//! | ω, f | frequency in the water, ω = 2πf | rad/s, Hz |
//! | S(f) | variance density over frequency | m²/Hz |
//! | E(f, θ) | variance density over frequency and direction | m²/(Hz rad) |
//! | mₙ | ∫ωⁿ S dω; m0 is the variance of the surface | m² (rad/s)ⁿ |
//! | Hs | significant wave height, 4√m0 | m |
//! | mss | mean square slope, ∫∫k²Ψ d²k | |
//!
//! - [`SeaStatistics`]: heights, periods, directions and slopes, whatever they come from.
//! - [`PolarSpectrum`]: spectra sampled over wave number and direction, and their integrals.
//! - [`SurfaceStatistics`]: what a synthesised surface turned out to be.
//! - [`Moments`]: mean, variance, skewness and kurtosis of a field.
//!
//! A linear sea is Gaussian: skewness 0, kurtosis 3.

mod directions;
mod lattice;
mod moments;
mod polar;
mod sea;
mod surface;
mod wind;

#[cfg(test)]
mod tests;

pub use directions::{DirectionalSum, SlopeVariance};
pub use lattice::{FrequencyBin, LatticeWaves, frequency_bins};
pub use moments::{Moments, kurtosis, mean, skewness, variance};
pub use polar::PolarSpectrum;
pub use sea::{SeaStatistics, SpectralMoments};
pub use surface::SurfaceStatistics;
pub use wind::{mean_square_slope, slope_variances, whitecap_cover};

/// Hs = 4√m0 in metres, for a surface variance `m0` in m² (the definition of H_m0; equal to the mean of the
/// highest third of the waves of a narrow-banded sea within 0.1 %, Longuet-Higgins 1952).
pub fn significant_height_m(m0: f64) -> f64 {
    4.0 * m0.sqrt()
}
