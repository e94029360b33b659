//! The frequency of a wave number, and its slope, fast and consistent with each other.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | k | wave number | rad/m |
//! | u | √k; in deep water f is in proportion to it | (rad/m)^½ |
//! | f | frequency ω/2π | Hz |
//! | c_g | group speed dω/dk | m/s |
//!
//! f(u) is a cubic Hermite spline over equal steps of u, with f and df/du = 2u c_g/2π from the
//! [`Dispersion`] at the knots. The slope handed out is that of the spline itself, so that ∫ E(f) (df/du) du
//! is ∫ E df without any error from the spline.

use crate::dispersion::Dispersion;
use std::f64::consts::TAU;

/// Steps of the spline: f is right to 1e-9 of itself in deep water, and to 1e-4 where the whole way from
/// shallow to deep water lies within a few steps.
const STEPS: usize = 1024;

/// f(√k) between two frequencies.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FrequencyCurve {
    first_u: f64,
    steps_per_u: f64,
    /// f in Hz and df/du times the step, at each knot.
    knots: Vec<[f64; 2]>,
}

impl FrequencyCurve {
    /// From `low_hz` to `high_hz`, both above 0 and the second the greater.
    pub(super) fn new(low_hz: f64, high_hz: f64, water: &Dispersion) -> Self {
        let [first_u, last_u] = [low_hz, high_hz].map(|hz| water.wave_number(TAU * hz).sqrt());
        let step = (last_u - first_u) / STEPS as f64;
        let knot = |i: usize| {
            let u = first_u + i as f64 * step;
            let k = u * u;
            [water.angular_frequency(k) / TAU, step * 2.0 * u * water.group_speed(k) / TAU]
        };
        let mut knots: Vec<_> = (0..=STEPS).map(knot).collect();
        // The ends are exactly those of the table, so that its first and last frequencies are not lost to
        // rounding.
        knots[0][0] = low_hz;
        knots[STEPS][0] = high_hz;
        Self { first_u, steps_per_u: 1.0 / step, knots }
    }

    /// f in Hz and df/du at `u` = √k; `None` outside the curve and for NaN.
    #[inline]
    pub(super) fn at(&self, u: f64) -> Option<(f64, f64)> {
        let along = (u - self.first_u) * self.steps_per_u;
        if !(0.0..=STEPS as f64).contains(&along) {
            return None;
        }
        let step = (along as usize).min(STEPS - 1);
        let t = along - step as f64;
        let ([f0, slope0], [f1, slope1]) = (self.knots[step], self.knots[step + 1]);
        // f0 + slope0 t + b t² + a t³ meets the four values.
        let rise = f1 - f0;
        let a = slope0 + slope1 - 2.0 * rise;
        let b = 3.0 * rise - 2.0 * slope0 - slope1;
        let f = ((a * t + b) * t + slope0) * t + f0;
        let slope = (3.0 * a * t + 2.0 * b) * t + slope0;
        Some((f, slope * self.steps_per_u))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_is_the_dispersion() {
        let waters = [1.0, 10.0, 60.0, 4000.0, f64::INFINITY].map(|d| Dispersion::at_depth(d).unwrap());
        for water in waters.into_iter().chain([Dispersion::DEEP.with_surface_tension()]) {
            let curve = FrequencyCurve::new(0.01, 2.0, &water);
            let [low, high] = [0.01, 2.0].map(|hz: f64| water.wave_number(TAU * hz).sqrt());
            for i in 1..5000 {
                let u = low + (high - low) * f64::from(i) / 5000.0;
                let (f, slope) = curve.at(u).unwrap();
                let expected = water.angular_frequency(u * u) / TAU;
                assert!((f / expected - 1.0).abs() < 1e-4, "{water:?} {f} {expected}");
                let expected = 2.0 * u * water.group_speed(u * u) / TAU;
                assert!((slope / expected - 1.0).abs() < 1e-2, "{water:?} {f} Hz: {slope} {expected}");
            }
        }
    }

    #[test]
    fn nothing_outside_its_ends() {
        let curve = FrequencyCurve::new(0.1, 0.5, &Dispersion::DEEP);
        for u in [0.0, 0.15, 1.1, f64::NAN, f64::INFINITY] {
            assert_eq!(curve.at(u), None);
        }
    }
}
