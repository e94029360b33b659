//! How fast waves run: Airy's linear theory, over any depth, with or without surface tension.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | k | wave number, 2π / wavelength | rad/m |
//! | ω | angular frequency in water at rest, 2π / period | rad/s |
//! | d | depth of the water | m |
//! | τ | surface tension over density, σ/ρ | m³/s² |
//! | c | phase speed ω/k, of a crest | m/s |
//! | c_g | group speed dω/dk, of the energy | m/s |
//! | U | a uniform current | m/s |
//!
//! ω² = (g k + τ k³) tanh kd (Lamb, *Hydrodynamics*, 6th ed., arts. 229 and 267). A current carries the whole
//! pattern with it, so an observer at rest sees ω + k·U ([`doppler`]).

use crate::GRAVITY_MPS2;
use crate::error::{ParameterError, check};
use glam::DVec2;

/// Surface tension of sea water over its density, 0.074 N/m over 1000 kg/m³, in m³/s².
pub const SURFACE_TENSION_M3PS2: f64 = 7.4e-5;

/// Beyond this kd, tanh kd is 1 to the last bit of an f64.
const DEEP_KD: f64 = 20.0;

/// The relation between the length of a wave and its period; see the [module](self).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dispersion {
    depth_m: f64,
    surface_tension_m3ps2: f64,
}

impl Dispersion {
    /// Gravity waves on water that is deeper than they are long: ω² = g k.
    pub const DEEP: Self = Self { depth_m: f64::INFINITY, surface_tension_m3ps2: 0.0 };

    /// Gravity waves on water of `depth_m` metres, above 0; infinity is deep water.
    ///
    /// # Errors
    ///
    /// If the depth is not above 0.
    pub fn at_depth(depth_m: f64) -> Result<Self, ParameterError> {
        if depth_m != f64::INFINITY {
            check("depth_m", depth_m, "above 0", |d| d > 0.0)?;
        }
        Ok(Self { depth_m, ..Self::DEEP })
    }

    /// The same water with surface tension, which rules waves below 17 mm and quickens those below 10 cm.
    pub fn with_surface_tension(self) -> Self {
        Self { surface_tension_m3ps2: SURFACE_TENSION_M3PS2, ..self }
    }

    /// d in metres, infinity for deep water.
    pub fn depth_m(&self) -> f64 {
        self.depth_m
    }

    /// ω in rad/s of a wave number `k` ≥ 0 in rad/m.
    pub fn angular_frequency(&self, k: f64) -> f64 {
        ((GRAVITY_MPS2 * k + self.surface_tension_m3ps2 * k * k * k) * self.tanh_kd(k)).sqrt()
    }

    /// k in rad/m of an angular frequency `omega` ≥ 0 in rad/s: the inverse of
    /// [`angular_frequency`](Self::angular_frequency), to 1e-12 of k.
    ///
    /// Newton's method on ω(k)² from Eckart's (1952) guess k = ω²/g / √tanh(ω²d/g); with surface tension from
    /// the smaller of that and the capillary (ω²/τ)^⅓.
    pub fn wave_number(&self, omega: f64) -> f64 {
        let deep = omega * omega / GRAVITY_MPS2;
        if omega == 0.0 || (self.depth_m == f64::INFINITY && self.surface_tension_m3ps2 == 0.0) {
            return deep;
        }
        let mut k = deep / self.tanh_kd(deep).sqrt();
        if self.surface_tension_m3ps2 > 0.0 {
            k = k.min(libm::cbrt(omega * omega / self.surface_tension_m3ps2));
        }
        for _ in 0..50 {
            let slope = 2.0 * self.angular_frequency(k) * self.group_speed(k);
            let next = k - (self.angular_frequency(k).powi(2) - omega * omega) / slope;
            // ω² is convex enough for Newton's steps to stay above 0, but for rounding at the very start.
            let next = next.max(0.1 * k);
            let done = (next - k).abs() <= 1e-14 * next;
            k = next;
            if done {
                break;
            }
        }
        k
    }

    /// c = ω/k in m/s of a wave number `k` > 0 in rad/m.
    pub fn phase_speed(&self, k: f64) -> f64 {
        self.angular_frequency(k) / k
    }

    /// c_g = dω/dk in m/s of a wave number `k` > 0 in rad/m.
    pub fn group_speed(&self, k: f64) -> f64 {
        let tension = self.surface_tension_m3ps2 * k * k;
        let tanh = self.tanh_kd(k);
        // d sech² kd; no wave feels a bottom that is far below it.
        let bottom = if k * self.depth_m > DEEP_KD { 0.0 } else { self.depth_m * (1.0 - tanh * tanh) };
        ((GRAVITY_MPS2 + 3.0 * tension) * tanh + k * (GRAVITY_MPS2 + tension) * bottom)
            / (2.0 * self.angular_frequency(k))
    }

    /// coth kd: how much longer than high the orbits at the surface are; 1 in deep water.
    pub fn orbit_ratio(&self, k: f64) -> f64 {
        1.0 / self.tanh_kd(k)
    }

    /// The horizontal and the vertical orbit at `depth_m` below the calm surface, as shares of the vertical one
    /// at the surface: cosh k(d − depth) / sinh kd and sinh k(d − depth) / sinh kd, both e^(−k depth) in deep
    /// water. Above the calm surface (a negative depth) linear theory has no answer, and that of the surface
    /// is given; below the bottom, that of the bottom.
    pub fn orbits_below(&self, k: f64, depth_m: f64) -> (f64, f64) {
        let depth_m = depth_m.clamp(0.0, self.depth_m);
        if k * self.depth_m > DEEP_KD {
            let decay = libm::exp(-k * depth_m);
            return (decay, decay);
        }
        let above_bottom = k * (self.depth_m - depth_m);
        let sinh = libm::sinh(k * self.depth_m);
        (libm::cosh(above_bottom) / sinh, libm::sinh(above_bottom) / sinh)
    }

    fn tanh_kd(&self, k: f64) -> f64 {
        let kd = k * self.depth_m;
        // At k = 0 over infinite depth kd is not a number; the water is deep for every wave there is.
        if kd <= DEEP_KD { libm::tanh(kd) } else { 1.0 }
    }
}

/// ω + k·U in rad/s: the frequency that an observer at rest counts, for a wave vector `k` in rad/m whose
/// frequency in the water is `omega`, on a current in m/s.
pub fn doppler(omega: f64, k: DVec2, current_mps: DVec2) -> f64 {
    omega + k.dot(current_mps)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    /// Period, depth → wave number, wavelength, speed and group speed.
    #[test]
    fn known_values_over_a_bottom() {
        for (period_s, depth_m, k, wavelength_m, c, cg) in [
            (5.0, 20.0, 0.161477, 38.911, 7.7821, 3.9698),
            (10.0, 10.0, 0.068019, 92.374, 9.2374, 8.0699),
            (10.0, 100.0, 0.040269, 156.032, 15.6032, 7.8415),
            (20.0, 100.0, 0.012047, 521.537, 26.0769, 18.7306),
        ] {
            let water = Dispersion::at_depth(depth_m).unwrap();
            let found = water.wave_number(TAU / period_s);
            assert!((found - k).abs() < 1e-6, "{found}");
            assert!((TAU / found - wavelength_m).abs() < 1e-3);
            assert!((water.phase_speed(found) - c).abs() < 1e-4);
            assert!((water.group_speed(found) - cg).abs() < 1e-4);
        }
    }

    /// 156.13 m and 15.61 m/s for ten seconds, a quarter of the length for half the period.
    #[test]
    fn known_values_in_deep_water() {
        for (period_s, wavelength_m, speed_mps) in [(10.0, 156.1310, 15.61310), (5.0, 39.03275, 7.806550)] {
            let k = Dispersion::DEEP.wave_number(TAU / period_s);
            assert!((TAU / k - wavelength_m).abs() < 1e-3);
            assert!((Dispersion::DEEP.phase_speed(k) - speed_mps).abs() < 1e-4);
            assert!((Dispersion::DEEP.group_speed(k) - speed_mps / 2.0).abs() < 1e-4);
        }
        assert_eq!(Dispersion::DEEP.angular_frequency(0.0), 0.0);
        assert_eq!(Dispersion::at_depth(10.0).unwrap().wave_number(0.0), 0.0);
    }

    /// The slowest wave there is, and two that surface tension quickens.
    #[test]
    fn known_values_of_ripples() {
        let water = Dispersion::DEEP.with_surface_tension();
        for (wavelength_m, omega) in [(0.1, 25.1940), (0.01, 156.587)] {
            assert!((water.angular_frequency(TAU / wavelength_m) - omega).abs() < 1e-3);
        }
        let slowest = (1000..3000)
            .map(|i| f64::from(i) * 1e-5)
            .min_by(|&a, &b| water.phase_speed(TAU / a).total_cmp(&water.phase_speed(TAU / b)));
        let slowest = slowest.unwrap();
        assert!((slowest - 0.017257).abs() < 2e-5, "{slowest}");
        assert!((water.phase_speed(TAU / slowest) - 0.23213).abs() < 1e-5);
    }

    #[test]
    fn shallow_water_runs_at_the_root_of_g_d() {
        let water = Dispersion::at_depth(2.0).unwrap();
        let speed = (GRAVITY_MPS2 * 2.0).sqrt();
        assert!((water.phase_speed(1e-4) / speed - 1.0).abs() < 1e-6);
        assert!((water.group_speed(1e-4) / speed - 1.0).abs() < 1e-6);
    }

    #[test]
    fn orbits_end_at_the_bottom() {
        let water = Dispersion::at_depth(10.0).unwrap();
        let (along, up) = water.orbits_below(0.2, 0.0);
        assert!((along - water.orbit_ratio(0.2)).abs() < 1e-12 && (up - 1.0).abs() < 1e-12);
        assert_eq!(water.orbits_below(0.2, 10.0).1, 0.0);
        assert_eq!(water.orbits_below(0.2, 99.0), water.orbits_below(0.2, 10.0));
        assert_eq!(Dispersion::DEEP.orbits_below(0.2, 5.0), ((-1.0_f64).exp(), (-1.0_f64).exp()));
        // Above the calm level there is no answer but the surface's.
        for water in [water, Dispersion::DEEP] {
            for above in [-1e-3, -5.0, -1e4] {
                assert_eq!(water.orbits_below(0.2, above), water.orbits_below(0.2, 0.0));
            }
        }
    }

    #[test]
    fn no_water_is_refused() {
        for depth_m in [0.0, -3.0, f64::NAN, f64::NEG_INFINITY] {
            assert!(Dispersion::at_depth(depth_m).is_err(), "{depth_m}");
        }
        assert_eq!(Dispersion::at_depth(f64::INFINITY).unwrap(), Dispersion::DEEP);
    }

    #[test]
    fn a_following_current_raises_the_frequency() {
        let seen = doppler(1.0, DVec2::new(0.1, 0.2), DVec2::new(2.0, -0.5));
        assert!((seen - 1.1).abs() < 1e-15);
    }

    proptest! {
        #[test]
        fn wave_number_inverts_and_speeds_follow(
            ln_k in -9.0..6.0_f64, ln_depth in -2.0..9.0_f64, deep in any::<bool>(), tension in any::<bool>(),
        ) {
            let k = ln_k.exp();
            let water = Dispersion::at_depth(if deep { f64::INFINITY } else { ln_depth.exp() }).unwrap();
            let water = if tension { water.with_surface_tension() } else { water };
            let omega = water.angular_frequency(k);
            prop_assert!((water.wave_number(omega) / k - 1.0).abs() < 1e-11);
            prop_assert!((water.phase_speed(k) * k / omega - 1.0).abs() < 1e-14);
            let step = 1e-5 * k;
            let slope = (water.angular_frequency(k + step) - water.angular_frequency(k - step)) / (2.0 * step);
            prop_assert!((water.group_speed(k) / slope - 1.0).abs() < 1e-7);
        }
    }
}
