//! A clear sky by scattering in a spherical atmosphere.
//!
//! After S. Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique", EGSR
//! 2020: single scattering is marched along each ray, all higher orders come from a small table under
//! the assumption that they are isotropic and their second and later bounces form a geometric series
//! (his section 5.5). Departures: it runs on the CPU, once per scene, for an eye at sea level; the sun
//! stands still, so the sky is stored for half the azimuths only.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | `r` | distance from the Earth's centre | km |
//! | `mu` | cosine of the angle to the zenith | |
//! | `mu_s` | the same of the sun's direction | |
//! | `nu` | cosine of the angle between ray and sun | |
//! | `T` | transmittance | |
//! | `Psi` | light of all orders above the first, per unit of scattering | 1/sr |
//!
//! Radiance is in units of the sun's irradiance above the atmosphere, which is 1 in each channel.

use super::SUN_RADIUS_RAD;
use glam::Vec3;
use rayon::prelude::*;
use std::f32::consts::{FRAC_PI_2, PI, TAU};

const GROUND_KM: f32 = 6360.0;
const TOP_KM: f32 = 6460.0;
/// The eye, and the lowest sun that is sampled, stay this far above the ground.
const EYE_KM: f32 = GROUND_KM + 0.01;
/// Rayleigh scattering at sea level, 1/km; scale height 8 km (Hillaire 2020, table 1).
const RAYLEIGH: Vec3 = Vec3::new(0.005_802, 0.013_558, 0.033_1);
const RAYLEIGH_HEIGHT_KM: f32 = 8.0;
/// Aerosol scattering and extinction at sea level, 1/km; scale height 1.2 km.
const MIE_SCATTERING: f32 = 0.003_996;
const MIE_EXTINCTION: f32 = 0.004_44;
const MIE_HEIGHT_KM: f32 = 1.2;
/// Asymmetry of the aerosols' phase function.
const MIE_G: f32 = 0.8;
/// Ozone absorption at its densest, 1/km; a tent from 10 to 40 km with its peak at 25 km.
const OZONE: Vec3 = Vec3::new(0.000_650, 0.001_881, 0.000_085);
/// Mean reflectance of what lies below: mostly sea.
const GROUND_ALBEDO: f32 = 0.1;

const TRANSMITTANCE_SIZE: [usize; 2] = [128, 32];
const MULTIPLE_SIZE: [usize; 2] = [32, 16];
const SKY_SIZE: [usize; 2] = [64, 128];
const SKY_STEPS: usize = 32;

/// The clear sky for one height of the sun.
pub struct Atmosphere {
    toward_sun: Vec3,
    haze: f32,
    transmittance: Table,
    multiple: Table,
    sky: Table,
    mean: Vec3,
}

impl Atmosphere {
    /// Computes the tables. `haze` multiplies the density of aerosols: 1 is a clear maritime day.
    pub fn new(toward_sun: Vec3, haze: f32) -> Atmosphere {
        let empty = || Table { size: [1, 1], values: vec![Vec3::ZERO] };
        let mut air = Atmosphere {
            toward_sun,
            haze,
            transmittance: empty(),
            multiple: empty(),
            sky: empty(),
            mean: Vec3::ZERO,
        };
        air.transmittance = Table::fill(TRANSMITTANCE_SIZE, |u, v| {
            let (r, mu) = transmittance_place(u, v);
            air.march_transmittance(r, mu)
        });
        air.multiple = Table::fill(MULTIPLE_SIZE, |u, v| {
            let r = EYE_KM + v * (TOP_KM - EYE_KM - 0.01);
            air.integrate_multiple(r, 2.0 * u - 1.0)
        });
        air.sky = Table::fill(SKY_SIZE, |u, v| air.march_sky(air.sky_direction(u, v)));
        air.mean = air.integrate_mean();
        air
    }

    /// Radiance of the clear sky without the sun's disc, above the horizon; below it, that of the
    /// horizon.
    pub fn radiance(&self, direction: Vec3) -> Vec3 {
        let elevation = direction.y.clamp(0.0, 1.0).asin();
        let azimuth = self.azimuth_from_sun(direction);
        // The square root puts half of the rows into the lowest quarter, where the sky changes.
        self.sky.sample(azimuth / PI, (elevation / FRAC_PI_2).sqrt())
    }

    /// Radiance of the sun's disc through the air, zero once it has set.
    pub fn sun_radiance(&self) -> Vec3 {
        let solid_angle = PI * SUN_RADIUS_RAD * SUN_RADIUS_RAD;
        self.transmittance_at(EYE_KM, self.toward_sun.y) / solid_angle
    }

    /// What is left of the sun's light at `height_km` above the sea.
    pub fn sun_transmittance(&self, height_km: f32) -> Vec3 {
        self.transmittance_at(EYE_KM + height_km, self.toward_sun.y)
    }

    /// Cosine-weighted mean radiance of the sky above the horizon.
    pub fn mean_radiance(&self) -> Vec3 {
        self.mean
    }

    /// Unit vector towards the sun.
    pub fn toward_sun(&self) -> Vec3 {
        self.toward_sun
    }

    /// 0 towards the sun, π away from it.
    fn azimuth_from_sun(&self, direction: Vec3) -> f32 {
        let across = |v: Vec3| v.x.hypot(v.z);
        let scale = across(direction) * across(self.toward_sun);
        if scale < 1e-6 {
            return 0.0;
        }
        let cos = (direction.x * self.toward_sun.x + direction.z * self.toward_sun.z) / scale;
        cos.clamp(-1.0, 1.0).acos()
    }

    fn sky_direction(&self, u: f32, v: f32) -> Vec3 {
        let elevation = v * v * FRAC_PI_2;
        let sun_azimuth = self.toward_sun.z.atan2(self.toward_sun.x);
        let (sin, cos) = (sun_azimuth + u * PI).sin_cos();
        Vec3::new(cos * elevation.cos(), elevation.sin(), sin * elevation.cos())
    }

    /// Scattering by molecules and aerosols, and extinction, 1/km.
    fn medium(&self, r: f32) -> (Vec3, f32, Vec3) {
        let height = r - GROUND_KM;
        let rayleigh = RAYLEIGH * (-height / RAYLEIGH_HEIGHT_KM).exp();
        let aerosols = self.haze * (-height / MIE_HEIGHT_KM).exp();
        let ozone = OZONE * (1.0 - (height - 25.0).abs() / 15.0).max(0.0);
        (rayleigh, MIE_SCATTERING * aerosols, rayleigh + MIE_EXTINCTION * aerosols + ozone)
    }

    fn march_transmittance(&self, r: f32, mu: f32) -> Vec3 {
        const STEPS: usize = 40;
        let step = distance_to_sphere(r, mu, TOP_KM).unwrap_or(0.0) / STEPS as f32;
        let depth: Vec3 =
            (0..STEPS).map(|i| self.medium(radius_along(r, mu, (i as f32 + 0.5) * step)).2 * step).sum();
        exp(-depth)
    }

    fn transmittance_at(&self, r: f32, mu: f32) -> Vec3 {
        // The disc sets gradually behind the Earth's edge.
        let horizon = -(1.0 - (GROUND_KM / r).powi(2)).max(0.0).sqrt();
        let visible = ((mu - horizon) / SUN_RADIUS_RAD * 0.5 + 0.5).clamp(0.0, 1.0);
        if visible == 0.0 {
            return Vec3::ZERO;
        }
        let (u, v) = transmittance_coordinates(r, mu.max(horizon));
        self.transmittance.sample(u, v) * visible
    }

    fn multiple_at(&self, r: f32, mu_s: f32) -> Vec3 {
        self.multiple.sample(0.5 * mu_s + 0.5, (r - EYE_KM) / (TOP_KM - EYE_KM - 0.01))
    }

    /// Hillaire 2020, equations 5 to 10: second-order light over all directions and the share of it
    /// that is scattered once more, summed as a geometric series.
    fn integrate_multiple(&self, r: f32, mu_s: f32) -> Vec3 {
        const DIRECTIONS: usize = 8;
        const STEPS: usize = 20;
        let toward_sun = Vec3::new((1.0 - mu_s * mu_s).max(0.0).sqrt(), mu_s, 0.0);
        let isotropic = 1.0 / (4.0 * PI);
        let mut second = Vec3::ZERO;
        let mut share = Vec3::ZERO;
        for i in 0..DIRECTIONS * DIRECTIONS {
            let mu = 1.0 - 2.0 * ((i / DIRECTIONS) as f32 + 0.5) / DIRECTIONS as f32;
            let azimuth = TAU * ((i % DIRECTIONS) as f32 + 0.5) / DIRECTIONS as f32;
            let across = (1.0 - mu * mu).sqrt();
            let ray = Vec3::new(across * azimuth.cos(), mu, across * azimuth.sin());
            let ground = distance_to_sphere(r, mu, GROUND_KM);
            let length = ground.unwrap_or_else(|| distance_to_sphere(r, mu, TOP_KM).unwrap_or(0.0));
            let step = length / STEPS as f32;
            let mut through = Vec3::ONE;
            for j in 0..STEPS {
                let place = Vec3::new(0.0, r, 0.0) + ray * ((j as f32 + 0.5) * step);
                let here = place.length();
                let (rayleigh, mie, extinction) = self.medium(here);
                let scattering = rayleigh + mie;
                let sun = self.transmittance_at(here, place.dot(toward_sun) / here);
                let passed = exp(-extinction * step);
                let integral = through * (Vec3::ONE - passed) / extinction;
                second += scattering * sun * isotropic * integral;
                share += scattering * integral;
                through *= passed;
            }
            if let Some(distance) = ground {
                let place = (Vec3::new(0.0, r, 0.0) + ray * distance).normalize();
                let cos = place.dot(toward_sun);
                second += through * self.transmittance_at(EYE_KM, cos) * cos.max(0.0) * GROUND_ALBEDO / PI;
            }
        }
        let rays = (DIRECTIONS * DIRECTIONS) as f32;
        (second / rays) / (Vec3::ONE - share / rays)
    }

    fn march_sky(&self, ray: Vec3) -> Vec3 {
        let length = distance_to_sphere(EYE_KM, ray.y.max(0.0), TOP_KM).unwrap_or(0.0);
        let nu = ray.dot(self.toward_sun);
        let (phase_rayleigh, phase_mie) = (rayleigh_phase(nu), mie_phase(nu));
        let mut light = Vec3::ZERO;
        let mut through = Vec3::ONE;
        let mut travelled = 0.0;
        for i in 0..SKY_STEPS {
            // Steps grow with distance: the dense air is near.
            let end = length * ((i + 1) as f32 / SKY_STEPS as f32).powi(2);
            let step = end - travelled;
            let place = Vec3::new(0.0, EYE_KM, 0.0) + ray * (travelled + 0.4 * step);
            travelled = end;
            let r = place.length();
            let mu_s = place.dot(self.toward_sun) / r;
            let (rayleigh, mie, extinction) = self.medium(r);
            let single = (rayleigh * phase_rayleigh + mie * phase_mie) * self.transmittance_at(r, mu_s);
            let more = (rayleigh + mie) * self.multiple_at(r, mu_s);
            let passed = exp(-extinction * step);
            light += through * (single + more) * (Vec3::ONE - passed) / extinction;
            through *= passed;
        }
        light
    }

    fn integrate_mean(&self) -> Vec3 {
        const SIDE: usize = 32;
        let sum: Vec3 = (0..SIDE * SIDE)
            .map(|i| {
                let sin = (((i / SIDE) as f32 + 0.5) / SIDE as f32).sqrt();
                let azimuth = TAU * ((i % SIDE) as f32 + 0.5) / SIDE as f32;
                self.radiance(Vec3::new(sin * azimuth.cos(), (1.0 - sin * sin).sqrt(), sin * azimuth.sin()))
            })
            .sum();
        sum / (SIDE * SIDE) as f32
    }
}

/// A table over the unit square, sampled bilinearly; its outermost samples lie on the edges.
struct Table {
    size: [usize; 2],
    values: Vec<Vec3>,
}

impl Table {
    fn fill(size: [usize; 2], value: impl Fn(f32, f32) -> Vec3 + Sync) -> Table {
        let unit = |i: usize, n: usize| i as f32 / (n - 1) as f32;
        let values = (0..size[0] * size[1])
            .into_par_iter()
            .map(|i| value(unit(i % size[0], size[0]), unit(i / size[0], size[1])))
            .collect();
        Table { size, values }
    }

    fn sample(&self, u: f32, v: f32) -> Vec3 {
        let place = |c: f32, n: usize| {
            let c = c.clamp(0.0, 1.0) * (n - 1) as f32;
            let low = (c as usize).min(n.saturating_sub(2));
            (low, c - low as f32)
        };
        let ((x, fx), (y, fy)) = (place(u, self.size[0]), place(v, self.size[1]));
        let at = |x: usize, y: usize| self.values[y * self.size[0] + x];
        at(x, y).lerp(at(x + 1, y), fx).lerp(at(x, y + 1).lerp(at(x + 1, y + 1), fx), fy)
    }
}

/// Distances to the horizon make good coordinates: they stretch the table where the light bends fast
/// (Bruneton and Neyret 2008, section 4).
fn transmittance_coordinates(r: f32, mu: f32) -> (f32, f32) {
    let to_horizon_top = (TOP_KM * TOP_KM - GROUND_KM * GROUND_KM).sqrt();
    let rho = (r * r - GROUND_KM * GROUND_KM).max(0.0).sqrt();
    let distance = distance_to_sphere(r, mu, TOP_KM).unwrap_or(0.0);
    let (near, far) = (TOP_KM - r, rho + to_horizon_top);
    ((distance - near) / (far - near), rho / to_horizon_top)
}

/// The inverse of [`transmittance_coordinates`].
fn transmittance_place(u: f32, v: f32) -> (f32, f32) {
    let to_horizon_top = (TOP_KM * TOP_KM - GROUND_KM * GROUND_KM).sqrt();
    let rho = v * to_horizon_top;
    let r = (rho * rho + GROUND_KM * GROUND_KM).sqrt();
    let (near, far) = (TOP_KM - r, rho + to_horizon_top);
    let distance = near + u * (far - near);
    let mu = if distance <= 0.0 {
        1.0
    } else {
        (to_horizon_top * to_horizon_top - rho * rho - distance * distance) / (2.0 * r * distance)
    };
    (r, mu.clamp(-1.0, 1.0))
}

fn radius_along(r: f32, mu: f32, distance: f32) -> f32 {
    (r * r + distance * distance + 2.0 * r * mu * distance).sqrt()
}

/// From inside the larger sphere to its far side; from outside the smaller one to its near side.
fn distance_to_sphere(r: f32, mu: f32, radius: f32) -> Option<f32> {
    let discriminant = r * r * (mu * mu - 1.0) + radius * radius;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    let distance = if r <= radius { -r * mu + root } else { -r * mu - root };
    (distance >= 0.0).then_some(distance)
}

fn rayleigh_phase(nu: f32) -> f32 {
    3.0 / (16.0 * PI) * (1.0 + nu * nu)
}

/// Cornette and Shanks 1992, the form that Hillaire uses.
fn mie_phase(nu: f32) -> f32 {
    let g2 = MIE_G * MIE_G;
    let k = 3.0 / (8.0 * PI) * (1.0 - g2) / (2.0 + g2);
    k * (1.0 + nu * nu) / (1.0 + g2 - 2.0 * MIE_G * nu).powf(1.5)
}

fn exp(v: Vec3) -> Vec3 {
    Vec3::new(v.x.exp(), v.y.exp(), v.z.exp())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sky(elevation_deg: f32) -> Atmosphere {
        let (s, c) = elevation_deg.to_radians().sin_cos();
        Atmosphere::new(Vec3::new(c, s, 0.0), 1.0)
    }

    #[test]
    fn phase_functions_scatter_all_light_once() {
        for phase in [rayleigh_phase as fn(f32) -> f32, mie_phase] {
            let n = 20_000;
            let sum: f32 = (0..n).map(|i| phase(-1.0 + 2.0 * (i as f32 + 0.5) / n as f32)).sum();
            assert!((sum * 2.0 / n as f32 * TAU - 1.0).abs() < 1e-3);
        }
    }

    #[test]
    fn the_table_of_transmittance_agrees_with_marching() {
        let air = sky(30.0);
        for (height, mu) in [(0.02, 1.0), (0.02, 0.3), (0.02, 0.02), (3.0, 0.1), (12.0, 0.7)] {
            let direct = air.march_transmittance(GROUND_KM + height, mu);
            let table = air.transmittance_at(GROUND_KM + height, mu);
            assert!((direct - table).abs().max_element() < 0.01, "{height} {mu}: {direct} {table}");
        }
        // A vertical ray through clear air keeps about 94, 87 and 76 % of red, green and blue.
        let vertical = air.march_transmittance(EYE_KM, 1.0);
        assert!((vertical - Vec3::new(0.936, 0.868, 0.763)).abs().max_element() < 0.01, "{vertical}");
    }

    #[test]
    fn coordinates_and_place_are_inverse() {
        for (u, v) in [(0.1, 0.2), (0.5, 0.9), (0.99, 0.5)] {
            let (r, mu) = transmittance_place(u, v);
            let (u2, v2) = transmittance_coordinates(r, mu);
            assert!((u - u2).abs() < 1e-3 && (v - v2).abs() < 1e-3, "{u} {v}: {u2} {v2}");
        }
    }

    #[test]
    fn noon_is_blue_and_sunset_is_red() {
        let noon = sky(60.0).radiance(Vec3::new(-0.6, 0.8, 0.0));
        assert!(noon.z > 1.8 * noon.x, "{noon}");
        let evening = sky(1.0);
        let toward_sun = evening.radiance(Vec3::new(1.0, 0.03, 0.0).normalize());
        assert!(toward_sun.x > 1.5 * toward_sun.z, "{toward_sun}");
        let disc = evening.sun_radiance();
        assert!(disc.x > 3.0 * disc.z, "{disc}");
        assert_eq!(sky(-3.0).sun_radiance(), Vec3::ZERO);
        assert!(sky(-3.0).mean_radiance().y < 0.2 * evening.mean_radiance().y);
    }

    #[test]
    fn light_is_not_made_from_nothing() {
        // Irradiance at sea level, sky and sun together, stays below the sun's above the air.
        for elevation in [5.0_f32, 20.0, 50.0, 89.0] {
            let air = sky(elevation);
            let sun = air.sun_transmittance(0.0) * elevation.to_radians().sin();
            let total = air.mean_radiance() * PI + sun;
            let above = elevation.to_radians().sin();
            assert!(total.max_element() < 1.02 * above, "{elevation}: {total} of {above}");
            assert!(total.min_element() > 0.3 * above, "{elevation}: {total} of {above}");
        }
    }
}
