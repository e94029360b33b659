//! The wind sea over shallow water (Bouws, Günther, Rosenthal and Vincent, *J. Geophys. Res.* 90, 1985: Texel,
//! Marsen and ARSLOE).
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | d | depth of the water | m |
//! | k | wave number of ω over that depth | rad/m |
//! | Φ | what the depth leaves of the deep sea's density, 0..=1 | |
//!
//! S(ω) = S_JONSWAP(ω) Φ(ω, d), with Kitaigorodskii's (1975) similarity over wave numbers: a wave number has the
//! same density whatever the depth, k⁻³ (∂k/∂ω) over the same in deep water. From the dispersion it follows that
//! Φ = tanh²(kd)/(1 + 2kd/sinh 2kd): ½(ω²d/g) in shallow water, 1 in deep.

use super::Omnidirectional;
use super::jonswap::Jonswap;
use super::pierson_moskowitz::variance_of_height_m2;
use super::quadrature::integral;
use crate::dispersion::Dispersion;
use crate::error::{ParameterError, check};

/// The TMA spectrum; see the [module](self).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tma {
    jonswap: Jonswap,
    water: Dispersion,
    variance_m2: f64,
}

impl Tma {
    /// What becomes of the sea `deep` over water of `depth_m` metres, above 0 and finite: it loses energy. Its
    /// peak frequency stays, though the greatest density may move a little above it.
    ///
    /// # Errors
    ///
    /// [`ParameterError::NeedsDepth`] over deep water; if the depth is not above 0.
    pub fn over(deep: Jonswap, depth_m: f64) -> Result<Self, ParameterError> {
        if depth_m == f64::INFINITY {
            return Err(ParameterError::NeedsDepth);
        }
        check("depth_m", depth_m, "above 0", |d| d > 0.0)?;
        let water = Dispersion::at_depth(depth_m)?;
        let mut sea = Self { jonswap: deep, water, variance_m2: 0.0 };
        sea.variance_m2 = integral(deep.peak_angular_frequency(), |omega| sea.density_m2s(omega));
        Ok(sea)
    }

    /// The sea of this height *over this depth*: 0..=100 m, a peak period of 0.1..=100 s, γ =
    /// `peak_enhancement` from 1 to 10.
    ///
    /// # Errors
    ///
    /// As [`over`](Self::over), or if height, period or γ are out of their range.
    pub fn from_height_and_period(
        significant_height_m: f64,
        peak_period_s: f64,
        peak_enhancement: f64,
        depth_m: f64,
    ) -> Result<Self, ParameterError> {
        let unit = Jonswap::from_height_and_period(4.0, peak_period_s, peak_enhancement)?;
        let asked = Jonswap::from_height_and_period(significant_height_m, peak_period_s, peak_enhancement)?;
        let factor = 1.0 / Self::over(unit, depth_m)?.variance_m2;
        Ok(Self {
            jonswap: asked.scaled(factor),
            water: Dispersion::at_depth(depth_m)?,
            variance_m2: variance_of_height_m2(significant_height_m),
        })
    }

    /// d in metres.
    pub fn depth_m(&self) -> f64 {
        self.water.depth_m()
    }
}

impl Omnidirectional for Tma {
    fn density_m2s(&self, omega: f64) -> f64 {
        let deep = self.jonswap.density_m2s(omega);
        if deep == 0.0 {
            return 0.0;
        }
        deep * depth_factor(self.water.wave_number(omega) * self.water.depth_m())
    }

    fn peak_angular_frequency(&self) -> f64 {
        self.jonswap.peak_angular_frequency()
    }

    fn variance_m2(&self) -> f64 {
        self.variance_m2
    }

    fn inverse_wave_age(&self) -> f64 {
        self.jonswap.inverse_wave_age()
    }
}

/// Φ at `kd`, wave number times depth, at least 0.
pub fn depth_factor(kd: f64) -> f64 {
    let x = 2.0 * kd;
    // x/sinh x is 1 − x²/6 near 0, and 0 where sinh overflows.
    let ratio = if x < 1e-4 { 1.0 - x * x / 6.0 } else { x / libm::sinh(x).max(x) };
    let tanh = libm::tanh(kd);
    tanh * tanh / (1.0 + if x > 700.0 { 0.0 } else { ratio })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::GRAVITY_MPS2;

    /// Φ by ω √(d/g).
    #[test]
    fn known_depth_factors() {
        for (omega_h, phi) in [(0.5, 0.12480), (1.0, 0.48277), (1.5, 0.87853)] {
            let depth_m = 7.0;
            let omega = omega_h * (GRAVITY_MPS2 / depth_m).sqrt();
            let k = Dispersion::at_depth(depth_m).unwrap().wave_number(omega);
            assert!((depth_factor(k * depth_m) - phi).abs() < 1e-5, "{}", depth_factor(k * depth_m));
        }
    }

    #[test]
    fn the_limits_of_the_depth_factor() {
        for kd in [1e-9, 1e-5, 4.9e-5, 5.1e-5, 1e-3] {
            assert!((depth_factor(kd) / (0.5 * kd * kd) - 1.0).abs() < 1e-6, "{kd}");
        }
        assert_eq!(depth_factor(0.0), 0.0);
        for kd in [20.0, 349.0, 351.0, 1e4, 1e300, f64::INFINITY] {
            assert!((depth_factor(kd) - 1.0).abs() < 1e-14, "{kd}");
        }
    }

    /// Φ is the ratio of k⁻³ ∂k/∂ω over the depth to that in deep water.
    #[test]
    fn a_wave_number_keeps_its_density() {
        let (water, deep) = (Dispersion::at_depth(6.0).unwrap(), Dispersion::DEEP);
        for omega in [0.3, 0.8, 1.4, 3.0] {
            let part = |water: &Dispersion| {
                let k = water.wave_number(omega);
                k.powi(-3) / water.group_speed(k)
            };
            let phi = depth_factor(water.wave_number(omega) * 6.0);
            assert!((part(&water) / part(&deep) / phi - 1.0).abs() < 1e-9);
        }
    }

    /// Ten metres a second over a hundred kilometres, by depth.
    #[test]
    fn known_heights_over_a_bottom() {
        let deep = Jonswap::from_wind_and_fetch(10.0, 1e5, 3.3).unwrap();
        for (depth_m, height) in [(10.0, 1.6700), (50.0, 2.1356), (1e5, 2.1386)] {
            let sea = Tma::over(deep, depth_m).unwrap();
            assert!((sea.significant_height_m() - height).abs() < 1e-4, "{}", sea.significant_height_m());
        }
    }

    #[test]
    fn the_height_asked_for_is_that_over_the_depth() {
        let sea = Tma::from_height_and_period(1.5, 9.0, 2.0, 5.0).unwrap();
        let m0 = integral(sea.peak_angular_frequency(), |omega| sea.density_m2s(omega));
        assert!((4.0 * m0.sqrt() / 1.5 - 1.0).abs() < 1e-9);
        assert!((sea.significant_height_m() - 1.5).abs() < 1e-12);
    }

    #[test]
    fn it_needs_a_bottom() {
        let deep = Jonswap::from_wind_and_fetch(10.0, 1e5, 3.3).unwrap();
        assert_eq!(Tma::over(deep, f64::INFINITY), Err(ParameterError::NeedsDepth));
        assert!(ParameterError::NeedsDepth.to_string().contains("set depth_m"));
        for depth_m in [0.0, -1.0, f64::NAN] {
            assert!(Tma::over(deep, depth_m).is_err());
        }
    }
}
