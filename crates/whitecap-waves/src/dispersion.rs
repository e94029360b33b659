//! How fast waves run: linear gravity waves on deep water.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | k | wave number, 2π / wavelength | rad/m |
//! | ω | angular frequency, 2π / period | rad/s |
//! | c | phase speed, of a crest | m/s |
//! | c_g | group speed, of the energy | m/s |
//!
//! Airy's linear theory in the limit kh → ∞ (Lamb, *Hydrodynamics*, art. 229): ω² = g k. That is
//! within 0.4 % of the finite-depth ω² where the water is deeper than half a wavelength. Surface tension, which matters
//! below about 7 cm, is left out.

use crate::GRAVITY_MPS2;

/// ω = √(g k) in rad/s, for a wave number `k` ≥ 0 in rad/m.
pub fn deep_water_angular_frequency(k: f64) -> f64 {
    (GRAVITY_MPS2 * k).sqrt()
}

/// k = ω²/g in rad/m, for an angular frequency `omega` in rad/s: the inverse of
/// [`deep_water_angular_frequency`].
pub fn deep_water_wave_number(omega: f64) -> f64 {
    omega * omega / GRAVITY_MPS2
}

/// c = ω/k = √(g/k) in m/s, for a wave number `k` in rad/m; infinite at k = 0.
pub fn deep_water_phase_speed(k: f64) -> f64 {
    (GRAVITY_MPS2 / k).sqrt()
}

/// c_g = dω/dk = c/2 in m/s, for a wave number `k` in rad/m; infinite at k = 0.
pub fn deep_water_group_speed(k: f64) -> f64 {
    0.5 * deep_water_phase_speed(k)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    /// Wavelength g T²/2π, speed g T/2π: 156.13 m and 15.61 m/s for ten seconds, a quarter of the length
    /// for half the period.
    #[test]
    fn known_values() {
        for (period_s, wavelength_m, speed_mps) in [(10.0, 156.1310, 15.61310), (5.0, 39.03275, 7.806550)] {
            let k = deep_water_wave_number(TAU / period_s);
            assert!((TAU / k - wavelength_m).abs() < 1e-3);
            assert!((deep_water_phase_speed(k) - speed_mps).abs() < 1e-4);
            assert!((deep_water_group_speed(k) - speed_mps / 2.0).abs() < 1e-4);
        }
        assert_eq!(deep_water_angular_frequency(0.0), 0.0);
    }

    proptest! {
        #[test]
        fn speeds_follow_from_the_frequency(k in 1e-3..1e2_f64) {
            let omega = deep_water_angular_frequency(k);
            prop_assert!((deep_water_wave_number(omega) / k - 1.0).abs() < 1e-14);
            prop_assert!((deep_water_phase_speed(k) * k / omega - 1.0).abs() < 1e-14);
            let step = 1e-5 * k;
            let slope = (deep_water_angular_frequency(k + step) - deep_water_angular_frequency(k - step)) / (2.0 * step);
            prop_assert!((deep_water_group_speed(k) / slope - 1.0).abs() < 1e-8);
        }
    }
}
