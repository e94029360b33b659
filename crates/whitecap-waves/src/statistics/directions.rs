//! Mean directions, spreads, and the variance of slopes along a direction.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | θ | direction of travel |
//! | r1 | length of the energy-weighted mean of the unit vectors (cos θ, sin θ), 0..=1 |

use glam::DVec2;

/// Below this r1 there is no mean direction: waves run all ways alike, but for rounding.
const LEAST_R1: f64 = 1e-6;

/// Energy, and where it goes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct DirectionalSum {
    /// The energy of all waves, m².
    pub energy_m2: f64,
    /// The sum of their unit vectors of travel, each times its energy, m².
    pub toward_m2: DVec2,
}

impl DirectionalSum {
    /// Adds waves of this energy that travel towards the unit vector `toward`.
    pub fn add(&mut self, energy_m2: f64, toward: DVec2) {
        self.energy_m2 += energy_m2;
        self.toward_m2 += energy_m2 * toward;
    }

    /// r1: 1 where all waves run one way, 0 where they cancel.
    pub fn r1(&self) -> f64 {
        if self.energy_m2 > 0.0 { (self.toward_m2.length() / self.energy_m2).min(1.0) } else { 0.0 }
    }

    /// The unit vector of the mean direction; `None` where waves run all ways alike.
    pub fn mean_toward(&self) -> Option<DVec2> {
        (self.r1() > LEAST_R1).then(|| self.toward_m2.normalize())
    }

    /// The circular standard deviation √(2(1 − r1)) of the direction in radians (Kuik, van Vledder and Holthuijsen,
    /// J. Phys. Oceanogr. 18, 1988): 0 where all waves run one way, at most √2.
    pub fn spread_rad(&self) -> f64 {
        (2.0 * (1.0 - self.r1())).sqrt()
    }
}

/// The second moments of the surface's slope.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SlopeVariance {
    /// The mean of sx², the square of the slope to the east.
    pub xx: f64,
    /// The mean of sx sz.
    pub xz: f64,
    /// The mean of sz², the square of the slope to the south.
    pub zz: f64,
}

impl SlopeVariance {
    /// Of waves with slope variance `variance` that run along the unit vector `direction`, either way.
    pub fn of_waves(variance: f64, direction: DVec2) -> Self {
        let DVec2 { x, y: z } = direction;
        Self { xx: variance * x * x, xz: variance * x * z, zz: variance * z * z }
    }

    /// The mean square slope.
    pub fn total(&self) -> f64 {
        self.xx + self.zz
    }

    /// Of the slope along the unit vector `direction`; across it for its perpendicular.
    pub fn along(&self, direction: DVec2) -> f64 {
        let DVec2 { x, y: z } = direction;
        self.xx * x * x + 2.0 * self.xz * x * z + self.zz * z * z
    }
}

impl std::ops::AddAssign for SlopeVariance {
    fn add_assign(&mut self, other: Self) {
        self.xx += other.xx;
        self.xz += other.xz;
        self.zz += other.zz;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, SQRT_2};

    #[test]
    fn two_waves_at_right_angles() {
        let mut sum = DirectionalSum::default();
        sum.add(2.0, DVec2::X);
        sum.add(2.0, DVec2::Y);
        assert!((sum.r1() - 0.5_f64.sqrt()).abs() < 1e-15);
        assert!(sum.mean_toward().unwrap().distance(DVec2::ONE.normalize()) < 1e-15);
        sum.add(2.0, -DVec2::X);
        sum.add(2.0, -DVec2::Y);
        assert_eq!(sum.mean_toward(), None);
        assert!((sum.spread_rad() - SQRT_2).abs() < 1e-9);
        assert_eq!(DirectionalSum::default().mean_toward(), None);
    }

    /// A narrow normal distribution has its own standard deviation: r1 = exp(−σ²/2).
    #[test]
    fn a_small_spread_is_the_standard_deviation() {
        let (sigma, mut sum) = (0.05, DirectionalSum::default());
        for i in -400..=400 {
            let angle = f64::from(i) * 1e-3;
            sum.add((-0.5 * (angle / sigma).powi(2)).exp(), DVec2::from_angle(1.0 + angle));
        }
        assert!((sum.spread_rad() / sigma - 1.0).abs() < 1e-3);
        assert!((sum.mean_toward().unwrap().to_angle() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn slopes_along_and_across_make_the_whole() {
        let direction = DVec2::from_angle(0.7);
        let mut slopes = SlopeVariance::of_waves(0.02, direction);
        assert!((slopes.along(direction) - 0.02).abs() < 1e-16);
        assert!(slopes.along(direction.perp()).abs() < 1e-16);
        slopes += SlopeVariance::of_waves(0.005, DVec2::from_angle(0.7 + FRAC_PI_2));
        assert!((slopes.along(direction.perp()) - 0.005).abs() < 1e-16);
        assert!((slopes.total() - 0.025).abs() < 1e-16);
    }
}
