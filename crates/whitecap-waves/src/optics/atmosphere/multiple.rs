//! Light that has been scattered more than once.
//!
//! Hillaire 2020, section 5.5: from the second order on light is taken to come alike from all sides, and each order to be
//! the same share of the one before, so that all of them sum as a geometric series.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | Ψ | radiance of all orders above the first at a place, per unit of solar irradiance | 1/sr |
//! | μs | cosine of the sun's zenith angle | |

use super::medium::Medium;
use super::shell::{Ray, TOP_KM, horizon_mu};
use super::table::{Table, fourth_power};
use super::transmittance::Transmittance;
use glam::DVec3;
use std::f64::consts::{FRAC_1_PI, PI};

/// Columns (the sun) and rows (height).
pub(super) const SIZE: [usize; 2] = [40, 20];

/// The lowest sun of the table, and how wide the range about 0 is that most columns fall into.
const LOWEST_MU_S: f64 = -0.35;
const SUNSET: f64 = 0.25;

/// Mean reflectance of what lies below: mostly sea.
const GROUND_ALBEDO: f64 = 0.1;

/// Rays by their angle to the zenith and, over half a turn, to the sun's azimuth: the other half mirrors it.
const RINGS: u32 = 8;
const SPOKES: u32 = 4;
const STEPS: u32 = 12;

/// The fourth roots of Ψ.
pub(super) fn table(air: &Transmittance) -> Table {
    let unit = |i: usize, n: usize| i as f64 / (n - 1) as f64;
    Table::fill(SIZE, |column, row| {
        let [low, high] = [LOWEST_MU_S, 1.0].map(|mu_s| mu_s / (SUNSET + mu_s.abs()));
        let x = low + unit(column, SIZE[0]) * (high - low);
        let v = unit(row, SIZE[1]);
        integrate(air, TOP_KM * v * v, SUNSET * x / (1.0 - x.abs())).powf(0.25)
    })
}

/// Ψ at a height, from the table.
pub(super) fn sample(table: &Table, height_km: f64, mu_s: f64) -> DVec3 {
    let [u, v] = coordinates(height_km, mu_s);
    fourth_power(table.sample(u * (SIZE[0] - 1) as f64, v * (SIZE[1] - 1) as f64))
}

/// Most columns lie about the sunset and most rows in the dense air.
fn coordinates(height_km: f64, mu_s: f64) -> [f64; 2] {
    let [low, high, x] = [LOWEST_MU_S, 1.0, mu_s].map(|mu_s| mu_s / (SUNSET + mu_s.abs()));
    [((x - low) / (high - low)).clamp(0.0, 1.0), (height_km / TOP_KM).clamp(0.0, 1.0).sqrt()]
}

/// Hillaire 2020, equations 5 to 10: the second order, over all directions, and the share of light that is scattered
/// once more.
pub(super) fn integrate(air: &Transmittance, height_km: f64, mu_s: f64) -> DVec3 {
    let isotropic = 0.25 * FRAC_1_PI;
    let (mut second, mut share) = (DVec3::ZERO, DVec3::ZERO);
    let sin_s = (1.0 - mu_s * mu_s).max(0.0).sqrt();
    for ring in 0..RINGS {
        let mu = 1.0 - 2.0 * (f64::from(ring) + 0.5) / f64::from(RINGS);
        let downward = mu < horizon_mu(height_km);
        let ray = Ray::whole(height_km, mu, downward);
        for spoke in 0..SPOKES {
            let azimuth = PI * (f64::from(spoke) + 0.5) / f64::from(SPOKES);
            let nu = mu * mu_s + (1.0 - mu * mu).sqrt() * sin_s * azimuth.cos();
            let mut through = DVec3::ONE;
            for (at_km, length_km) in ray.steps(STEPS) {
                let here_km = ray.height_at(at_km);
                let medium = Medium::at(here_km, air.haze);
                let sun = air.of_sun(here_km, ray.sun_at(at_km, mu_s, nu));
                let passed = (-medium.extinction * length_km).exp();
                let scattered = medium.scattering() / medium.extinction * through * (1.0 - passed);
                second += isotropic * sun * scattered;
                share += scattered;
                through *= passed;
            }
            if downward {
                let cos = ray.sun_at(ray.length_km, mu_s, nu);
                second += through * air.of_sun(0.0, cos) * cos.max(0.0) * GROUND_ALBEDO * FRAC_1_PI;
            }
        }
    }
    let rays = f64::from(RINGS * SPOKES);
    (second / rays) / (1.0 - share / rays)
}
