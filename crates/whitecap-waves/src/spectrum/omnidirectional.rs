//! Spectra over frequency alone.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | ω | angular frequency in water at rest | rad/s |
//! | S(ω) | one-sided variance density over ω | m²·s/rad |
//! | S(k) | the same energy over the wave number | m³/rad |
//! | m_n | ∫ ωⁿ S dω | m² (rad/s)ⁿ |
//! | ωp | where S(ω) is greatest | rad/s |
//! | Tz | 2π √(m0/m2), mean time between zero up-crossings (Rice 1944) | s |
//! | U | wind 10 m above the sea | m/s |
//! | Ω | U ωp/g, inverse wave age | |

use super::quadrature::integral;
use crate::GRAVITY_MPS2;
use crate::dispersion::Dispersion;
use std::f64::consts::TAU;

/// Ω of the sea that Pierson and Moskowitz (1964) call fully developed: ωp = (4β/5)^¼ g/U19.5 with β = 0.74, and
/// U19.5 = 1.026 U10, so that U10 ωp/g = 0.8772/1.026.
pub const FULLY_DEVELOPED_INVERSE_WAVE_AGE: f64 = 0.854_934_938_918_319_3;

/// How the energy of a sea is spread over frequencies, whatever its directions.
///
/// # Implementing
///
/// `density_m2s` is never negative, is finite for every ω > 0 and has `variance_m2` for its integral. A spectrum
/// that is known over frequency needs no more; one that is known over wave numbers, such as Elfouhaily's, gives
/// [`wave_number_density_m3`](Self::wave_number_density_m3) itself.
pub trait Omnidirectional: Send + Sync {
    /// S(ω) in m²·s/rad at `omega` > 0 in rad/s.
    fn density_m2s(&self, omega: f64) -> f64;

    /// ωp in rad/s, above 0.
    fn peak_angular_frequency(&self) -> f64;

    /// m0 in m²: the integral of [`density_m2s`](Self::density_m2s).
    fn variance_m2(&self) -> f64;

    /// S(k) in m³/rad at the wave number `k` > 0 in rad/m of waves that obey `dispersion`: S(ω) dω/dk.
    fn wave_number_density_m3(&self, k: f64, dispersion: &Dispersion) -> f64 {
        self.density_m2s(dispersion.angular_frequency(k)) * dispersion.group_speed(k)
    }

    /// Ω = U ωp/g, on which some spreadings depend. Where no wind is known it is taken for the one that has
    /// raised the sea to its full: [`FULLY_DEVELOPED_INVERSE_WAVE_AGE`].
    fn inverse_wave_age(&self) -> f64 {
        FULLY_DEVELOPED_INVERSE_WAVE_AGE
    }

    /// Hs = 4√m0 in metres.
    fn significant_height_m(&self) -> f64 {
        crate::statistics::significant_height_m(self.variance_m2())
    }

    /// Tp = 2π/ωp in seconds.
    fn peak_period_s(&self) -> f64 {
        TAU / self.peak_angular_frequency()
    }

    /// Tz in seconds; 0 for a flat sea.
    fn zero_crossing_period_s(&self) -> f64 {
        if self.variance_m2() == 0.0 {
            return 0.0;
        }
        let m2 = integral(self.peak_angular_frequency(), |omega| omega * omega * self.density_m2s(omega));
        TAU * (self.variance_m2() / m2).sqrt()
    }

    /// λp in metres: the length of a wave of the peak's period in deep water, g Tp²/2π.
    fn deep_peak_wavelength_m(&self) -> f64 {
        TAU * GRAVITY_MPS2 / self.peak_angular_frequency().powi(2)
    }
}

impl<T: Omnidirectional + ?Sized> Omnidirectional for &T {
    fn density_m2s(&self, omega: f64) -> f64 {
        (**self).density_m2s(omega)
    }
    fn peak_angular_frequency(&self) -> f64 {
        (**self).peak_angular_frequency()
    }
    fn variance_m2(&self) -> f64 {
        (**self).variance_m2()
    }
    fn wave_number_density_m3(&self, k: f64, dispersion: &Dispersion) -> f64 {
        (**self).wave_number_density_m3(k, dispersion)
    }
    fn inverse_wave_age(&self) -> f64 {
        (**self).inverse_wave_age()
    }
}

impl<T: Omnidirectional + ?Sized> Omnidirectional for Box<T> {
    fn density_m2s(&self, omega: f64) -> f64 {
        (**self).density_m2s(omega)
    }
    fn peak_angular_frequency(&self) -> f64 {
        (**self).peak_angular_frequency()
    }
    fn variance_m2(&self) -> f64 {
        (**self).variance_m2()
    }
    fn wave_number_density_m3(&self, k: f64, dispersion: &Dispersion) -> f64 {
        (**self).wave_number_density_m3(k, dispersion)
    }
    fn inverse_wave_age(&self) -> f64 {
        (**self).inverse_wave_age()
    }
}
