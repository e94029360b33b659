//! The fully developed wind sea (Pierson and Moskowitz, *J. Geophys. Res.* 69, 1964).
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | U19.5, U10 | wind 19.5 m and 10 m above the sea; U19.5 = 1.026 U10 (Stewart, *Introduction to Physical Oceanography*, ch. 16) | m/s |
//! | α, β | 0.0081, 0.74 | |
//! | ωp | (4β/5)^¼ g/U19.5 | rad/s |
//!
//! S(ω) = α g² ω⁻⁵ exp(−β (g/(U19.5 ω))⁴). Its integral is m0 = α U⁴/(4β g²), its peak is at ωp, and with both
//!
//! S(ω) = 5 m0 ωp⁴ ω⁻⁵ exp(−5/4 (ωp/ω)⁴),
//!
//! which serves for any height and period as well (Bretschneider 1959; the ITTC's two-parameter spectrum).

use super::Omnidirectional;
use super::omnidirectional::FULLY_DEVELOPED_INVERSE_WAVE_AGE;
use crate::GRAVITY_MPS2;
use crate::error::{ParameterError, check};
use std::f64::consts::TAU;

const ALPHA: f64 = 0.0081;
const BETA: f64 = 0.74;

/// U19.5 over U10.
const HIGHER_WIND: f64 = 1.026;

/// Pierson and Moskowitz's spectrum; see the [module](self).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PiersonMoskowitz {
    variance_m2: f64,
    peak_angular_frequency: f64,
}

impl PiersonMoskowitz {
    /// The sea that a wind of U10 = `wind_speed_mps`, above 0 and at most 100, raises in time.
    ///
    /// # Errors
    ///
    /// If the wind is out of its range.
    pub fn from_wind(wind_speed_mps: f64) -> Result<Self, ParameterError> {
        check_wind(wind_speed_mps)?;
        Self::from_wind_at_19_5_m(HIGHER_WIND * wind_speed_mps)
    }

    /// The same, by the wind 19.5 m above the sea, above 0 and at most 103 m/s: the height of the anemometers
    /// that the spectrum was fitted to.
    ///
    /// # Errors
    ///
    /// If the wind is out of its range.
    pub fn from_wind_at_19_5_m(wind_speed_mps: f64) -> Result<Self, ParameterError> {
        check("wind_speed_mps", wind_speed_mps, "above 0 and at most 103", |u| u > 0.0 && u <= 103.0)?;
        let scale_m = wind_speed_mps * wind_speed_mps / GRAVITY_MPS2;
        Ok(Self {
            variance_m2: ALPHA / (4.0 * BETA) * scale_m * scale_m,
            peak_angular_frequency: peak_over_g_by_u() * GRAVITY_MPS2 / wind_speed_mps,
        })
    }

    /// The sea of significant height Hs, 0..=100 m, that is fully developed: its period is
    /// [`fully_developed_period_s`].
    ///
    /// # Errors
    ///
    /// If the height is out of its range. A flat sea has no period, so 0 is.
    pub fn from_height(significant_height_m: f64) -> Result<Self, ParameterError> {
        check("significant_height_m", significant_height_m, "above 0 and at most 100", |h| {
            h > 0.0 && h <= 100.0
        })?;
        Self::from_height_and_period(significant_height_m, fully_developed_period_s(significant_height_m))
    }

    /// Any sea of this shape, by its significant height, 0..=100 m, and its peak period, 0.1..=100 s.
    ///
    /// # Errors
    ///
    /// If one of them is out of its range.
    pub fn from_height_and_period(
        significant_height_m: f64,
        peak_period_s: f64,
    ) -> Result<Self, ParameterError> {
        check_height_and_period(significant_height_m, peak_period_s)?;
        Ok(Self {
            variance_m2: variance_of_height_m2(significant_height_m),
            peak_angular_frequency: TAU / peak_period_s,
        })
    }
}

impl Omnidirectional for PiersonMoskowitz {
    fn density_m2s(&self, omega: f64) -> f64 {
        self.variance_m2 / self.peak_angular_frequency * unit_density(omega / self.peak_angular_frequency)
    }

    fn peak_angular_frequency(&self) -> f64 {
        self.peak_angular_frequency
    }

    fn variance_m2(&self) -> f64 {
        self.variance_m2
    }

    fn inverse_wave_age(&self) -> f64 {
        FULLY_DEVELOPED_INVERSE_WAVE_AGE
    }
}

/// The peak period in seconds of the fully developed sea that is `significant_height_m` high:
/// Hs = 2√(α/β) U²/g and Tp = 2π U/((4β/5)^¼ g), so Tp = 5.000 √Hs.
pub fn fully_developed_period_s(significant_height_m: f64) -> f64 {
    TAU / GRAVITY_MPS2 / peak_over_g_by_u() * wind_at_19_5_m_of_height_mps(significant_height_m)
}

/// U10 in m/s of the fully developed sea that is `significant_height_m` high.
pub fn fully_developed_wind_mps(significant_height_m: f64) -> f64 {
    wind_at_19_5_m_of_height_mps(significant_height_m) / HIGHER_WIND
}

fn wind_at_19_5_m_of_height_mps(significant_height_m: f64) -> f64 {
    (significant_height_m * GRAVITY_MPS2 / (2.0 * (ALPHA / BETA).sqrt())).sqrt()
}

/// (4β/5)^¼ = 0.8772, which is ωp U19.5/g.
fn peak_over_g_by_u() -> f64 {
    (0.8 * BETA).sqrt().sqrt()
}

/// S ωp/m0 of Pierson and Moskowitz at `ratio` = ω/ωp: 5 ratio⁻⁵ exp(−5/4 ratio⁻⁴).
pub(super) fn unit_density(ratio: f64) -> f64 {
    // The exponential has long been 0 where the power would overflow.
    if ratio < 0.15 {
        return 0.0;
    }
    let x = 1.0 / ratio;
    let x4 = (x * x) * (x * x);
    5.0 * x4 * x * libm::exp(-1.25 * x4)
}

/// m0 = (Hs/4)².
pub(super) fn variance_of_height_m2(significant_height_m: f64) -> f64 {
    (significant_height_m / 4.0) * (significant_height_m / 4.0)
}

pub(super) fn check_wind(wind_speed_mps: f64) -> Result<(), ParameterError> {
    check("wind_speed_mps", wind_speed_mps, "above 0 and at most 100", |u| u > 0.0 && u <= 100.0)
}

pub(super) fn check_height_and_period(
    significant_height_m: f64,
    peak_period_s: f64,
) -> Result<(), ParameterError> {
    check("significant_height_m", significant_height_m, "from 0 to 100", |h| (0.0..=100.0).contains(&h))?;
    check("peak_period_s", peak_period_s, "from 0.1 to 100", |t| (0.1..=100.0).contains(&t))
}

#[cfg(test)]
mod tests {
    use super::super::quadrature::integral;
    use super::*;

    /// U19.5 → Hs, Tp, Tz, λp.
    #[test]
    fn known_seas() {
        for (wind, height, tp, tz, wavelength) in [
            (5.0, 0.5332, 3.651, 2.594, 20.81),
            (10.0, 2.1330, 7.302, 5.187, 83.24),
            (20.0, 8.5319, 14.604, 10.374, 332.97),
        ] {
            let sea = PiersonMoskowitz::from_wind_at_19_5_m(wind).unwrap();
            assert!((sea.significant_height_m() - height).abs() < 1e-4);
            assert!((sea.peak_period_s() - tp).abs() < 1e-3);
            assert!((sea.zero_crossing_period_s() - tz).abs() < 1e-3);
            assert!((sea.deep_peak_wavelength_m() - wavelength).abs() < 1e-2);
        }
    }

    /// The density by the formula of 1964, at several frequencies, and its integral.
    #[test]
    fn the_density_is_that_of_1964_and_its_integral_the_variance() {
        let sea = PiersonMoskowitz::from_wind(10.0).unwrap();
        for omega in [0.4, 0.8, 0.9, 1.7, 6.0_f64] {
            let g: f64 = 9.81;
            let expected = 0.0081 * g.powi(2) / omega.powi(5) * (-0.74 * (g / (10.26 * omega)).powi(4)).exp();
            assert!((sea.density_m2s(omega) / expected - 1.0).abs() < 1e-12);
        }
        let m0 = integral(sea.peak_angular_frequency(), |omega| sea.density_m2s(omega));
        assert!((m0 / sea.variance_m2() - 1.0).abs() < 1e-9);
    }

    #[test]
    fn the_height_alone_gives_wind_and_period() {
        let wind = PiersonMoskowitz::from_wind(13.0).unwrap();
        let height_m = wind.significant_height_m();
        let sea = PiersonMoskowitz::from_height(height_m).unwrap();
        assert!((sea.peak_period_s() / wind.peak_period_s() - 1.0).abs() < 1e-12);
        assert!((fully_developed_wind_mps(height_m) - 13.0).abs() < 1e-12);
        assert!((fully_developed_period_s(1.0) - 5.000).abs() < 1e-3);
        let age = 13.0 * wind.peak_angular_frequency() / GRAVITY_MPS2;
        assert!((wind.inverse_wave_age() - age).abs() < 1e-6, "{age}");
    }

    #[test]
    fn what_no_sea_has_is_refused() {
        for wind in [0.0, -1.0, 101.0, f64::NAN, f64::INFINITY] {
            assert!(PiersonMoskowitz::from_wind(wind).is_err(), "{wind}");
        }
        for (height, period) in [(-1.0, 8.0), (101.0, 8.0), (f64::NAN, 8.0), (1.0, 0.0), (1.0, f64::NAN)] {
            assert!(PiersonMoskowitz::from_height_and_period(height, period).is_err());
        }
        assert!(PiersonMoskowitz::from_height(0.0).is_err());
    }

    #[test]
    fn the_ends_of_the_frequencies_are_empty() {
        let sea = PiersonMoskowitz::from_height_and_period(2.0, 8.0).unwrap();
        for omega in [f64::MIN_POSITIVE, 1e-100, 1e-3, 1e100, f64::MAX] {
            assert!(sea.density_m2s(omega).abs() < 1e-100, "{omega}");
        }
    }
}
