//! What is left of light on its way out of the air.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | h | height over the ground | km |
//! | μ | cosine of the ray's angle to the zenith | |
//! | d | distance to the end of the air; from `h` at least `d_min`, straight up, and at most `d_max`, along the horizon | km |
//! | ρ, H | √(r² − R²) at the height and at the end of the air: distances to the horizon | km |

use super::SUN_RADIUS_RAD;
use super::medium::Medium;
use super::shell::{GROUND_KM, Ray, TOP_KM, horizon_mu, squared_beyond, to_top_km};
use super::table::{Table, fourth_power};
use glam::DVec3;

/// Columns and rows (Hillaire 2020, section 5.2).
pub(super) const SIZE: [usize; 2] = [256, 64];

/// Steps along a ray. Twice as many change nothing by more than 0.8 %.
const STEPS: u32 = 40;

/// How much aerosol there is, and the table of the fourth roots of transmittance that follows from it.
#[derive(Clone, Debug)]
pub(super) struct Transmittance {
    pub(super) haze: f64,
    pub(super) table: Table,
}

impl Transmittance {
    pub(super) fn new(haze: f64) -> Transmittance {
        let unit = |i: usize, n: usize| i as f64 / (n - 1) as f64;
        let table = Table::fill(SIZE, |column, row| {
            let (height_km, mu) = place(unit(column, SIZE[0]), unit(row, SIZE[1]));
            march(height_km, mu, haze, STEPS).powf(0.25)
        });
        Transmittance { haze, table }
    }

    /// From a height to the end of the air, in a direction that is not below the horizon.
    pub(super) fn to_top(&self, height_km: f64, mu: f64) -> DVec3 {
        let [u, v] = coordinates(height_km, mu);
        fourth_power(self.table.sample(u * (SIZE[0] - 1) as f64, v * (SIZE[1] - 1) as f64))
    }

    /// The same of the sun's light: its disc sets gradually behind the Earth's edge.
    pub(super) fn of_sun(&self, height_km: f64, mu_s: f64) -> DVec3 {
        // Of the disc, this much is over the edge. The cubic is within 0.04 of the segment of a circle.
        let over = ((mu_s - horizon_mu(height_km)) / SUN_RADIUS_RAD * 0.5 + 0.5).clamp(0.0, 1.0);
        if over == 0.0 {
            return DVec3::ZERO;
        }
        over * over * (3.0 - 2.0 * over) * self.to_top(height_km, mu_s)
    }
}

/// exp(−∫ extinction) to the end of the air.
pub(super) fn march(height_km: f64, mu: f64, haze: f64, steps: u32) -> DVec3 {
    let ray = Ray::whole(height_km, mu, false);
    let depth = |(at_km, length_km)| Medium::at(ray.height_at(at_km), haze).extinction * length_km;
    (-ray.steps(steps).map(depth).sum::<DVec3>()).exp()
}

/// (d − d_min)/(d_max − d_min) and ρ/H, both in 0..=1: distances to the horizon stretch the table where light changes fast
/// (Bruneton and Neyret 2008, section 4).
fn coordinates(height_km: f64, mu: f64) -> [f64; 2] {
    let to_horizon_top = squared_beyond(TOP_KM).sqrt();
    let rho = squared_beyond(height_km).max(0.0).sqrt();
    let (near, far) = (TOP_KM - height_km, rho + to_horizon_top);
    let distance = to_top_km(height_km, mu.max(horizon_mu(height_km)));
    [(distance - near) / (far - near), rho / to_horizon_top]
}

/// The inverse of [`coordinates`].
fn place(u: f64, v: f64) -> (f64, f64) {
    let to_horizon_top = squared_beyond(TOP_KM).sqrt();
    let rho = v * to_horizon_top;
    let height_km = rho * rho / ((rho * rho + GROUND_KM * GROUND_KM).sqrt() + GROUND_KM);
    let (near, far) = (TOP_KM - height_km, rho + to_horizon_top);
    let distance = near + u * (far - near);
    let squares = to_horizon_top * to_horizon_top - rho * rho - distance * distance;
    let mu = if distance <= 0.0 { 1.0 } else { squares / (2.0 * (GROUND_KM + height_km) * distance) };
    (height_km, mu.clamp(-1.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_and_place_are_inverse() {
        for (u, v) in [(0.1, 0.2), (0.5, 0.9), (0.99, 0.5), (1.0, 0.01)] {
            let (height_km, mu) = place(u, v);
            let [u2, v2] = coordinates(height_km, mu);
            assert!((u - u2).abs() < 1e-6 && (v - v2).abs() < 1e-6, "{u} {v}: {u2} {v2}");
        }
    }

    #[test]
    fn twice_the_steps_change_little() {
        for (height_km, mu) in [(0.0, 1.0), (0.0, 0.1), (0.001, 0.0), (5.0, -0.03), (60.0, -0.1)] {
            let (few, many) = (march(height_km, mu, 1.0, STEPS), march(height_km, mu, 1.0, 2000));
            let error = (few / many - 1.0).abs().max_element();
            assert!(error < 8e-3, "{height_km} {mu}: {error}");
        }
    }

    /// Lehn's and others' figures for clear air straight up: about 94, 87 and 76 % of red, green and blue.
    #[test]
    fn clear_air_is_yellowish_straight_through() {
        let vertical = march(0.0, 1.0, 1.0, STEPS);
        assert!((vertical - DVec3::new(0.936, 0.868, 0.763)).abs().max_element() < 0.01, "{vertical}");
    }
}
