//! What is left of light on its way out of the air.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | h | height over the ground | km |
//! | μ | cosine of the ray's angle to the zenith | |
//! | d | distance to the end of the air; from `h` at least `d_min`, straight up, and at most `d_max`, along the horizon | km |
//! | ρ, H | √(r² − R²) at the height and at the end of the air: distances to the horizon | km |

use super::SUN_RADIUS_RAD;
use super::medium::{Medium, OZONE_EDGES_KM, OZONE_PER_KM, ozone};
use super::quadrature::gauss_legendre;
use super::shell::{GROUND_KM, TOP_KM, height_of, squared_beyond, to_top_km};
use super::table::{Table, fourth_power, place as place_of};
use glam::DVec3;

/// Columns and rows. Hillaire's 256 × 64 (section 5.2) are up to 2.4 % off under thick haze.
pub(super) const SIZE: [usize; 2] = [512, 128];

/// How much aerosol there is, and the table of the fourth roots of transmittance that follows from it.
#[derive(Clone, Debug)]
pub(super) struct Transmittance {
    pub(super) haze: f64,
    pub(super) table: Table,
}

impl Transmittance {
    pub(super) fn new(haze: f64) -> Transmittance {
        let unit = |i: usize, n: usize| i as f64 / (n - 1) as f64;
        let depth = Depth::new(haze);
        let table = Table::fill(SIZE, |column, row| {
            let (height_km, mu) = place(unit(column, SIZE[0]), unit(row, SIZE[1]));
            (-0.25 * depth.to_top(height_km, mu)).exp()
        });
        Transmittance { haze, table }
    }

    /// From a height to the end of the air, in a direction that is not below the horizon.
    pub(super) fn to_top(&self, height_km: f64, mu: f64) -> DVec3 {
        self.at(height_km).to_top(mu)
    }

    /// The same of the sun's light: its disc sets gradually behind the Earth's edge.
    pub(super) fn of_sun(&self, height_km: f64, mu_s: f64) -> DVec3 {
        self.at(height_km).of_sun(mu_s)
    }

    /// What of it holds for one height.
    pub(super) fn at(&self, height_km: f64) -> Level<'_> {
        let rho = squared_beyond(height_km).max(0.0).sqrt();
        let near = TOP_KM - height_km;
        Level {
            table: &self.table,
            height_km,
            horizon_mu: -rho / (GROUND_KM + height_km),
            near,
            columns_per_km: (SIZE[0] - 1) as f64 / (rho + to_horizon_top() - near),
            row: place_of(rho / to_horizon_top() * (SIZE[1] - 1) as f64, SIZE[1]),
        }
    }
}

/// [`Transmittance`] at one height.
pub(super) struct Level<'a> {
    table: &'a Table,
    pub(super) height_km: f64,
    horizon_mu: f64,
    near: f64,
    columns_per_km: f64,
    row: (usize, f64),
}

impl Level<'_> {
    fn to_top(&self, mu: f64) -> DVec3 {
        let distance = to_top_km(self.height_km, mu.max(self.horizon_mu));
        fourth_power(self.table.sample_row((distance - self.near) * self.columns_per_km, self.row))
    }

    pub(super) fn of_sun(&self, mu_s: f64) -> DVec3 {
        // Of the disc, this much is over the edge. The cubic is within 0.04 of the segment of a circle.
        let over = ((mu_s - self.horizon_mu) / SUN_RADIUS_RAD * 0.5 + 0.5).clamp(0.0, 1.0);
        if over == 0.0 {
            return DVec3::ZERO;
        }
        over * over * (3.0 - 2.0 * over) * self.to_top(mu_s)
    }
}

/// Optical depth on the way out of the air: ∫ extinction.
///
/// Molecules and aerosols are integrated over the root of the distance from the ray's lowest point, in which they are
/// smooth; ozone over distances between its corners, which would spoil the rule for them all.
pub(super) struct Depth {
    haze: f64,
    smooth: Vec<(f64, f64)>,
    ozone: Vec<(f64, f64)>,
}

impl Depth {
    pub(super) fn new(haze: f64) -> Depth {
        Depth { haze, smooth: gauss_legendre(12), ozone: gauss_legendre(4) }
    }

    pub(super) fn to_top(&self, height_km: f64, mu: f64) -> DVec3 {
        // Distances are from the lowest point of the whole line, which lies behind a ray that goes up.
        let start_km = (GROUND_KM + height_km) * mu;
        let lowest = squared_beyond(height_km) - start_km * start_km;
        let end_km = (squared_beyond(TOP_KM) - lowest).max(0.0).sqrt();
        if start_km >= 0.0 {
            self.upwards(lowest, start_km, end_km)
        } else {
            self.upwards(lowest, 0.0, end_km) + self.upwards(lowest, 0.0, -start_km)
        }
    }

    /// Between two distances from a line's lowest point, where r² − R² is `lowest`.
    fn upwards(&self, lowest: f64, from_km: f64, to_km: f64) -> DVec3 {
        let height_at = |distance_km: f64| height_of(lowest + distance_km * distance_km);
        let root = (to_km - from_km).max(0.0).sqrt();
        let smooth = self.smooth.iter().map(|(place, weight)| {
            let x = place * root;
            let medium = Medium::at(height_at(from_km + x * x), self.haze);
            medium.smooth_extinction * (2.0 * x * root * weight)
        });
        let edges =
            OZONE_EDGES_KM.map(|km| (squared_beyond(km) - lowest).max(0.0).sqrt().clamp(from_km, to_km));
        let ozone = edges.windows(2).flat_map(|edges| {
            let length_km = edges[1] - edges[0];
            let density = move |place: f64| ozone(height_at(edges[0] + place * length_km));
            self.ozone.iter().map(move |(place, weight)| weight * length_km * density(*place))
        });
        smooth.sum::<DVec3>() + OZONE_PER_KM * ozone.sum::<f64>()
    }
}

/// H: distance from the ground's horizon to the end of the air, km.
fn to_horizon_top() -> f64 {
    squared_beyond(TOP_KM).sqrt()
}

/// Height and direction of the place of a table that lies at (d − d_min)/(d_max − d_min) and ρ/H, both in 0..=1: distances to
/// the horizon stretch the table where light changes fast (Bruneton and Neyret 2008, section 4).
fn place(u: f64, v: f64) -> (f64, f64) {
    let rho = v * to_horizon_top();
    let height_km = height_of(rho * rho);
    let (near, far) = (TOP_KM - height_km, rho + to_horizon_top());
    let distance = near + u * (far - near);
    let squares = to_horizon_top() * to_horizon_top() - rho * rho - distance * distance;
    let mu = if distance <= 0.0 { 1.0 } else { squares / (2.0 * (GROUND_KM + height_km) * distance) };
    (height_km, mu.clamp(-1.0, 1.0))
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::shell::Ray;
    use super::*;

    /// exp(−∫ extinction) to the end of the air, by many even steps over the root of the distance from the lowest point.
    pub(in super::super) fn march(height_km: f64, mu: f64, haze: f64) -> DVec3 {
        const STEPS: u32 = 4000;
        let ray = Ray::whole(height_km, mu, false);
        let lowest_km = (-(GROUND_KM + height_km) * mu).clamp(0.0, ray.length_km);
        let (first, last) = (-lowest_km.sqrt(), (ray.length_km - lowest_km).sqrt());
        let step = (last - first) / f64::from(STEPS);
        let depth = (0..STEPS).map(|i| {
            let x = first + (f64::from(i) + 0.5) * step;
            Medium::at(ray.height_at(lowest_km + x * x.abs()), haze).extinction() * (2.0 * x.abs() * step)
        });
        (-depth.sum::<DVec3>()).exp()
    }

    /// The table's entries are where they are read.
    #[test]
    fn every_entry_is_found_at_its_place() {
        let air = Transmittance::new(1.0);
        for (column, row) in [(25, 20), (128, 100), (500, 64), (511, 1)] {
            let (height_km, mu) =
                place(column as f64 / (SIZE[0] - 1) as f64, row as f64 / (SIZE[1] - 1) as f64);
            let entry = fourth_power(air.table.values()[row * SIZE[0] + column]);
            assert!((air.to_top(height_km, mu) - entry).abs().max_element() < 1e-6, "{column} {row}");
        }
    }

    #[test]
    fn the_depth_is_what_many_steps_find() {
        for haze in [0.0, 1.0, 20.0] {
            let depth = Depth::new(haze);
            for (height_km, mu) in
                [(0.0, 1.0), (0.0, 0.1), (0.0, 0.01), (0.001, 0.0), (5.0, -0.03), (60.0, -0.1)]
            {
                let error = ((-depth.to_top(height_km, mu)).exp() - march(height_km, mu, haze)).abs();
                assert!(error.max_element() < 2e-5, "haze {haze}, {height_km} {mu}: {error}");
            }
        }
    }

    /// Lehn's and others' figures for clear air straight up: about 94, 87 and 76 % of red, green and blue.
    #[test]
    fn clear_air_is_yellowish_straight_through() {
        let vertical = march(0.0, 1.0, 1.0);
        assert!((vertical - DVec3::new(0.936, 0.868, 0.763)).abs().max_element() < 0.01, "{vertical}");
    }
}
