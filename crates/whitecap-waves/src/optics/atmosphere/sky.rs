//! The sky as one eye sees it, as a table.

use super::table::Table;
use super::{Atmosphere, horizon_rad};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Columns (azimuth from the sun) and rows (elevation), as Hillaire 2020 has them.
const SIZE: [usize; 2] = [192, 108];

/// Rows below the horizon, where water and ground cover most of the air.
const ROWS_BELOW: usize = 36;

/// The clear sky for one height of the eye and one sun, calculated once.
///
/// Rows lie close at the horizon, where the sky changes fast: their distance grows with the square root of the angle from
/// it (Hillaire 2020, section 5.3). None lies on both sides of it. The sky is the same left and right of the sun, so
/// columns go half round, evenly in the sine of half the azimuth.
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
        let table = Table::fill(SIZE, |column, row| {
            let direction = direction(toward_sun, horizon_rad, column, row);
            air.radiance_beside(eye_height_m, direction, toward_sun, row < ROWS_BELOW)
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
            below + (above - 1.0) * (from_horizon / (FRAC_PI_2 - self.horizon_rad)).sqrt()
        } else {
            (below - 1.0) * (1.0 - (-from_horizon / (FRAC_PI_2 + self.horizon_rad)).sqrt())
        };
        self.table.sample(half_azimuth.sin() * (SIZE[0] - 1) as f64, row)
    }

    /// Irradiance of the sky on a level surface, without the sun.
    pub fn irradiance(&self) -> DVec3 {
        let (rings, spokes) = (64, 64);
        let sum: DVec3 = cosine_weighted(rings, spokes).map(|d| self.radiance(d)).sum();
        PI * sum / f64::from(rings * spokes)
    }

    /// The table, rows below the horizon first.
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// Unit vector towards the sun.
    pub fn toward_sun(&self) -> DVec3 {
        self.toward_sun
    }
}

/// The direction of a table's entry.
fn direction(toward_sun: DVec3, horizon_rad: f64, column: usize, row: usize) -> DVec3 {
    let square = |i: usize, n: usize| (i as f64 / (n - 1) as f64).powi(2);
    let elevation = if row >= ROWS_BELOW {
        horizon_rad + square(row - ROWS_BELOW, SIZE[1] - ROWS_BELOW) * (FRAC_PI_2 - horizon_rad)
    } else {
        horizon_rad - square(ROWS_BELOW - 1 - row, ROWS_BELOW) * (FRAC_PI_2 + horizon_rad)
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
