//! How the energy of a sea is spread over wave lengths and directions.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | k | wave vector, pointing where the wave travels; `.x` east, `.y` south | rad/m |
//! | Ψ(k) | variance density over the wave-number plane | m² per (rad/m)², that is m⁴ |
//! | m0 | ∫∫Ψ d²k, the variance of the surface elevation | m² |
//!
//! Most spectra come in two factors, S(ω) and a spreading over directions:
//!
//! | what | where |
//! | --- | --- |
//! | S(ω) | [`Omnidirectional`]: [`pierson_moskowitz`], [`jonswap`], [`tma`], [`elfouhaily`] |
//! | D(ω, θ) | [`Spreading`](crate::spreading::Spreading) |
//! | Ψ(k) = S(ω) D(ω, θ) c_g / k | [`Directional`](directional::Directional) |
//! | Ψ(k) as a whole | [`phillips`], [`tabulated`] |
//!
//! A sea state or a Beaufort number stands for heights and winds: [`sea_state`].

use glam::DVec2;
use std::f64::consts::TAU;

pub mod directional;
pub mod elfouhaily;
pub mod jonswap;
mod omnidirectional;
pub mod phillips;
pub mod pierson_moskowitz;
mod profile;
mod quadrature;
pub mod sea_state;
pub mod tabulated;
pub mod tma;

pub use omnidirectional::{FULLY_DEVELOPED_INVERSE_WAVE_AGE, Omnidirectional};
pub use profile::Profile;

/// A directional spectrum of surface waves over the wave-number plane.
///
/// One spectrum is one *system*, a wind sea or a swell; the systems of a sea are independent and their
/// variances add.
///
/// # Implementing
///
/// Two laws bind the methods: `density_m4` is never negative, and `variance_m2` is its integral over the
/// whole plane. Energy at `k` travels **towards** `k`; a spectrum that gives `k` and `-k` the same density
/// describes waves that run both ways. An isolated swell, Gaussian in the wave-number plane:
///
/// ```
/// use glam::DVec2;
/// use whitecap_waves::spectrum::WaveSpectrum;
///
/// struct Swell { peak: DVec2, width: f64, variance_m2: f64 }
///
/// impl WaveSpectrum for Swell {
///     fn density_m4(&self, k: DVec2) -> f64 {
///         let spread = 2.0 * self.width * self.width;
///         self.variance_m2 / (std::f64::consts::PI * spread) * (-k.distance_squared(self.peak) / spread).exp()
///     }
///     fn variance_m2(&self) -> f64 {
///         self.variance_m2
///     }
/// }
///
/// let swell = Swell { peak: DVec2::new(0.05, 0.0), width: 0.005, variance_m2: 0.25 };
/// assert!(swell.density_m4(swell.peak) > swell.density_m4(-swell.peak));
/// ```
pub trait WaveSpectrum: Send + Sync {
    /// Ψ(`k`) ≥ 0 in m² per (rad/m)², the energy travelling towards `k` (rad/m). Must be finite for every
    /// `k` other than zero; the sea never asks for zero.
    fn density_m4(&self, k: DVec2) -> f64;

    /// m0 in m²: the integral of [`density_m4`](Self::density_m4) over the whole plane.
    fn variance_m2(&self) -> f64;

    /// ∮Ψ k dθ in m³, the density over wave number alone, at `k` > 0 in rad/m. By itself it takes the mean of 72
    /// directions; a spectrum that knows it should say it.
    fn omnidirectional_m3(&self, k: f64) -> f64 {
        const DIRECTIONS: u32 = 72;
        let toward = |i: u32| k * DVec2::from_angle(TAU * f64::from(i) / f64::from(DIRECTIONS));
        let sum: f64 = (0..DIRECTIONS).map(|i| self.density_m4(toward(i))).sum();
        TAU * k * sum / f64::from(DIRECTIONS)
    }
}

impl<T: WaveSpectrum + ?Sized> WaveSpectrum for &T {
    fn density_m4(&self, k: DVec2) -> f64 {
        (**self).density_m4(k)
    }
    fn variance_m2(&self) -> f64 {
        (**self).variance_m2()
    }
    fn omnidirectional_m3(&self, k: f64) -> f64 {
        (**self).omnidirectional_m3(k)
    }
}

impl<T: WaveSpectrum + ?Sized> WaveSpectrum for Box<T> {
    fn density_m4(&self, k: DVec2) -> f64 {
        (**self).density_m4(k)
    }
    fn variance_m2(&self) -> f64 {
        (**self).variance_m2()
    }
    fn omnidirectional_m3(&self, k: f64) -> f64 {
        (**self).omnidirectional_m3(k)
    }
}
