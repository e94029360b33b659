//! How the energy of a sea is spread over wave lengths and directions.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | k | wave vector, pointing where the wave travels; `.x` east, `.y` south | rad/m |
//! | Ψ(k) | variance density over the wave-number plane | m² per (rad/m)², that is m⁴ |
//! | m0 | ∫∫Ψ d²k, the variance of the surface elevation | m² |

use glam::DVec2;

pub mod phillips;
pub mod tabulated;

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
}

impl<T: WaveSpectrum + ?Sized> WaveSpectrum for &T {
    fn density_m4(&self, k: DVec2) -> f64 {
        (**self).density_m4(k)
    }
    fn variance_m2(&self) -> f64 {
        (**self).variance_m2()
    }
}

impl<T: WaveSpectrum + ?Sized> WaveSpectrum for Box<T> {
    fn density_m4(&self, k: DVec2) -> f64 {
        (**self).density_m4(k)
    }
    fn variance_m2(&self) -> f64 {
        (**self).variance_m2()
    }
}
