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
use super::quadrature::gauss_legendre;
use super::shell::{GROUND_KM, Ray, Steps, TOP_KM, horizon_mu};
use super::table::{Table, fourth_power, place};
use super::transmittance::Transmittance;
use glam::DVec3;
use std::f64::consts::{FRAC_1_PI, PI};

/// Columns (the sun) and rows (height) that are integrated, and in how many parts a cubic divides their intervals.
const INTEGRATED: [usize; 2] = [49, 29];
const REFINED: usize = 3;

/// The lowest sun of the table, and how wide the range about 0 is that most columns fall into.
const LOWEST_MU_S: f64 = -0.35;
const SUNSET: f64 = 0.15;

/// Mean reflectance of what lies below: mostly sea.
const GROUND_ALBEDO: f64 = 0.1;

/// Rays by their angle to the zenith, on each side of the horizon.
const RINGS: u32 = 20;

/// Along each.
const STEPS: Steps = Steps { longest: 3.0, fewest: 8.0 };

/// Rays by their azimuth from the sun, over half a turn: the other half mirrors it. With the sun well up half as many do,
/// and in the Earth's shadow, whose edge runs through what is seen, twice as many are needed.
const SPOKES: u32 = 8;
const HIGH_SUN: f64 = 0.2;
const SUNKEN_SUN: f64 = -0.1;

/// Air that is turned by less than this at the Earth's centre, 32 km, has two at all times: the sun stands as high in all of it.
const NEARBY: f64 = 0.005;

/// The fourth roots of Ψ.
pub(super) fn table(air: &Transmittance) -> Table {
    let unit = |i: usize, n: usize| i as f64 / (n - 1) as f64;
    let [low, high] = [LOWEST_MU_S, 1.0].map(bent);
    let suns: Vec<Sun> = (0..INTEGRATED[0])
        .map(|column| {
            let x = low + unit(column, INTEGRATED[0]) * (high - low);
            let mu_s = (SUNSET * x / (1.0 - x.abs())).clamp(-1.0, 1.0);
            Sun::new(mu_s, spokes(mu_s))
        })
        .collect();
    let integrated = Table::fill_rows(INTEGRATED, |row, entries| {
        let height_km = TOP_KM * unit(row, INTEGRATED[1]).powi(2);
        entries.copy_from_slice(&light(air, height_km, &suns, RINGS, STEPS));
        entries.iter_mut().for_each(|entry| *entry = entry.powf(0.25));
    });
    integrated.refined(REFINED)
}

/// Ψ at a height whose [`row`] this is, from the table.
pub(super) fn sample_row(table: &Table, row: (usize, f64), mu_s: f64) -> DVec3 {
    let [low, high, x] = [LOWEST_MU_S, 1.0, mu_s].map(bent);
    fourth_power(table.sample_row((x - low) / (high - low) * (table.size()[0] - 1) as f64, row))
}

/// The row of the table that belongs to a height: most rows lie in the dense air.
pub(super) fn row(table: &Table, height_km: f64) -> (usize, f64) {
    let rows = table.size()[1];
    place((height_km / TOP_KM).clamp(0.0, 1.0).sqrt() * (rows - 1) as f64, rows)
}

fn spokes(mu_s: f64) -> u32 {
    if mu_s > HIGH_SUN {
        SPOKES / 2
    } else if mu_s > SUNKEN_SUN {
        SPOKES
    } else {
        SPOKES * 2
    }
}

fn bent(mu_s: f64) -> f64 {
    mu_s / (SUNSET + mu_s.abs())
}

/// A sun, and the cosines of its azimuths times the sine of its zenith angle.
pub(super) struct Sun {
    mu_s: f64,
    all: Vec<f64>,
    few: Vec<f64>,
}

impl Sun {
    pub(super) fn new(mu_s: f64, spokes: u32) -> Sun {
        let sin_s = (1.0 - mu_s * mu_s).max(0.0).sqrt();
        let azimuths = |spokes: u32| {
            (0..spokes).map(|i| (PI * (f64::from(i) + 0.5) / f64::from(spokes)).cos() * sin_s).collect()
        };
        Sun { mu_s, all: azimuths(spokes), few: azimuths(2) }
    }
}

/// Ψ at a height under each of some suns: the second order over all directions, and the geometric series of those that
/// follow (Hillaire 2020, equations 5 to 10).
///
/// Directions are Gauss–Legendre's over the root of the distance from the horizon, on each side of it: the light from
/// near the horizon is most of it high up and with a low sun, and even rings miss it by a tenth.
pub(super) fn light(
    air: &Transmittance,
    height_km: f64,
    suns: &[Sun],
    rings: u32,
    steps: Steps,
) -> Vec<DVec3> {
    let isotropic = 0.25 * FRAC_1_PI;
    let horizon = horizon_mu(height_km);
    let rings = gauss_legendre(rings);
    let (mut second, mut share) = (vec![DVec3::ZERO; suns.len()], DVec3::ZERO);
    for (downward, &(x, ring_weight)) in
        [true, false].into_iter().flat_map(|d| rings.iter().map(move |r| (d, r)))
    {
        let range = if downward { -1.0 - horizon } else { 1.0 - horizon };
        let mu = horizon + range * x * x;
        // Of the whole sphere: half the difference of the cosines.
        let solid = range.abs() * x * ring_weight;
        let ray = Ray::whole(height_km, mu, downward);
        let mut add = |at_km: f64, here_km: f64, weight: DVec3, is_ground: bool| {
            // All suns in turn: they read the same rows of the table.
            let level = air.at(here_km);
            let [cos, sin] = [GROUND_KM + height_km + at_km * mu, at_km * (1.0 - mu * mu).sqrt()]
                .map(|x| x / (GROUND_KM + here_km));
            for (sun, second) in suns.iter().zip(&mut second) {
                let azimuths = if sin < NEARBY { &sun.few } else { &sun.all };
                let of_sun = |azimuth: &f64| {
                    let sun_mu = cos * sun.mu_s + sin * azimuth;
                    let onto = if is_ground { sun_mu.max(0.0) } else { 1.0 };
                    onto * level.of_sun(sun_mu)
                };
                *second += weight * azimuths.iter().map(of_sun).sum::<DVec3>() / azimuths.len() as f64;
            }
        };
        let mut through = DVec3::ONE;
        for (at_km, length_km) in ray.nodes([ray.length_km; 2], steps) {
            let here_km = ray.height_at(at_km).min(TOP_KM);
            let medium = Medium::at(here_km, air.haze);
            let passed = (-medium.extinction() * length_km).exp();
            let scattered = solid * medium.scattering() / medium.extinction() * through * (1.0 - passed);
            add(at_km, here_km, isotropic * scattered, false);
            share += scattered;
            through *= passed;
        }
        if downward {
            add(ray.length_km, 0.0, solid * through * GROUND_ALBEDO * FRAC_1_PI, true);
        }
    }
    second.into_iter().map(|second| second / (1.0 - share)).collect()
}
