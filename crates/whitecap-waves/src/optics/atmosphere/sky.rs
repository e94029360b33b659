//! The sky as one eye sees it, as a table.

use super::shell::Ray;
use super::table::Table;
use super::{Atmosphere, Path, STEPS, eye_km, horizon_rad};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Columns (azimuth from the sun) and rows (elevation).
const SIZE: [usize; 2] = [128, 128];

/// Rows below the horizon, where water and ground cover most of the air.
const ROWS_BELOW: usize = 40;

/// The share of the way from the horizon to the zenith or nadir where rows, which lie close at the horizon, become even.
const BEND: f64 = 0.5;

/// The clear sky for one height of the eye and one sun, calculated once.
///
/// Rows lie close at the horizon, where the sky changes fast: there their distance grows with the square root of the angle
/// from it (Hillaire 2020, section 5.3). None lies on both sides of it. The sky is the same left and right of the sun, so
/// columns go half round, evenly in the sine of half the azimuth. Entries are square roots of radiance: near the horizon
/// those of a high eye, and of dusk, are straighter than radiance, and half floats hold them.
#[derive(Clone, Debug)]
pub struct Sky {
    toward_sun: DVec3,
    horizon_rad: f64,
    table: Table,
}

impl Sky {
    /// Computes the table for an eye at `eye_height_m`, up to 60 km.
    pub fn new(air: &Atmosphere, eye_height_m: f64, toward_sun: DVec3) -> Sky {
        let horizon_rad = horizon_rad(eye_height_m);
        // A row's rays go through the same air, but for where the shadow's edge divides them.
        let rows: Vec<_> = (0..SIZE[1])
            .map(|row| {
                let mu = direction(toward_sun, horizon_rad, 0, row).y;
                let ray = Ray::whole(eye_km(eye_height_m), mu, row < ROWS_BELOW);
                let path = Path::new(air, &ray, [ray.length_km; 2], STEPS);
                (ray, path)
            })
            .collect();
        let table = Table::fill(SIZE, |column, row| {
            let nu = direction(toward_sun, horizon_rad, column, row).dot(toward_sun);
            let (ray, whole) = &rows[row];
            let shadow = ray.shadow(toward_sun.y, nu);
            let light = if shadow[0] < shadow[1] {
                Path::new(air, ray, shadow, STEPS).light(air, ray, toward_sun.y, nu)
            } else {
                whole.light(air, ray, toward_sun.y, nu)
            };
            light.map(f64::sqrt)
        });
        Sky { toward_sun, horizon_rad, table }
    }

    /// [`Atmosphere::radiance`], within 1 %.
    pub fn radiance(&self, direction: DVec3) -> DVec3 {
        let elevation = direction.y.clamp(-1.0, 1.0).asin();
        let half_azimuth = 0.5 * azimuth_from(self.toward_sun, direction);
        let (below, above) = (ROWS_BELOW as f64, (SIZE[1] - ROWS_BELOW) as f64);
        let from_horizon = elevation - self.horizon_rad;
        let row = if from_horizon >= 0.0 {
            below + (above - 1.0) * part_of_rows(from_horizon / (FRAC_PI_2 - self.horizon_rad))
        } else {
            (below - 1.0) * (1.0 - part_of_rows(-from_horizon / (FRAC_PI_2 + self.horizon_rad)))
        };
        let root = self.table.sample(half_azimuth.sin() * (SIZE[0] - 1) as f64, row);
        root * root
    }

    /// Irradiance of the sky on a level surface, without the sun.
    pub fn irradiance(&self) -> DVec3 {
        let (rings, spokes) = (64, 64);
        let sum: DVec3 = cosine_weighted(rings, spokes).map(|d| self.radiance(d)).sum();
        PI * sum / f64::from(rings * spokes)
    }

    /// The square roots of radiance, rows below the horizon first.
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// Unit vector towards the sun.
    pub fn toward_sun(&self) -> DVec3 {
        self.toward_sun
    }
}

/// How far from the horizon's row, of all rows on its side, an angle from it lies that is such a share of all there are.
fn part_of_rows(angle: f64) -> f64 {
    let angle = angle.clamp(0.0, 1.0);
    (angle * (1.0 + BEND) / (angle + BEND)).sqrt()
}

/// The inverse of [`part_of_rows`].
fn part_of_angle(rows: f64) -> f64 {
    BEND * rows * rows / (1.0 + BEND - rows * rows)
}

/// The direction of a table's entry.
fn direction(toward_sun: DVec3, horizon_rad: f64, column: usize, row: usize) -> DVec3 {
    let part = |i: usize, n: usize| part_of_angle(i as f64 / (n - 1) as f64);
    let elevation = if row >= ROWS_BELOW {
        horizon_rad + part(row - ROWS_BELOW, SIZE[1] - ROWS_BELOW) * (FRAC_PI_2 - horizon_rad)
    } else {
        horizon_rad - part(ROWS_BELOW - 1 - row, ROWS_BELOW) * (FRAC_PI_2 + horizon_rad)
    };
    let azimuth = 2.0 * (column as f64 / (SIZE[0] - 1) as f64).asin();
    let (sin, cos) = (toward_sun.z.atan2(toward_sun.x) + azimuth).sin_cos();
    DVec3::new(cos * elevation.cos(), elevation.sin(), sin * elevation.cos())
}

/// 0 towards the sun, π away from it.
fn azimuth_from(toward_sun: DVec3, direction: DVec3) -> f64 {
    let scale = direction.x.hypot(direction.z) * toward_sun.x.hypot(toward_sun.z);
    if scale < 1e-9 {
        return 0.0;
    }
    let cos = (direction.x * toward_sun.x + direction.z * toward_sun.z) / scale;
    cos.clamp(-1.0, 1.0).acos()
}

/// Unit vectors spread over the upper half by the cosine of their angle to the zenith: the mean of radiances along them
/// times π is an irradiance.
fn cosine_weighted(rings: u32, spokes: u32) -> impl Iterator<Item = DVec3> {
    (0..rings * spokes).map(move |i| {
        // Equal steps of sin² give each direction the same share.
        let sin = ((f64::from(i / spokes) + 0.5) / f64::from(rings)).sqrt();
        let across = DVec2::from_angle(TAU * (f64::from(i % spokes) + 0.5) / f64::from(spokes)) * sin;
        DVec3::new(across.x, (1.0 - sin * sin).sqrt(), across.y)
    })
}
