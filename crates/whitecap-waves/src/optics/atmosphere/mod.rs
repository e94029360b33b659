//! A clear sky by scattering in a round shell of air.
//!
//! After S. Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique", EGSR 2020: light that was
//! scattered once is summed along each ray, all higher orders come from a small table (`multiple`). What the air is made
//! of is in `medium`. Rays go straight, there is no light but the sun's, and polarisation is left out.
//!
//! Light is in units of the sun's irradiance above the air, which is 1 in each channel. Directions have y up and need not
//! point above the horizon; the sun may be anywhere.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | `mu` | cosine of a ray's angle to the zenith |
//! | `mu_s` | the same of the sun's direction |
//! | `nu` | cosine of the angle between ray and sun |

mod medium;
mod multiple;
mod quadrature;
mod shell;
mod sky;
mod table;
mod transmittance;

pub use medium::{mie_phase, rayleigh_phase};
pub use sky::Sky;
pub use table::Table;

use glam::DVec3;
use medium::Medium;
use shell::{Ray, Steps, TOP_KM, horizon_mu};
use transmittance::{Level, Transmittance};

/// The sun's angular radius seen from Earth, radians (0.2666°).
pub const SUN_RADIUS_RAD: f64 = 0.004_653;

/// An eye counts as at least this high, so that it has something of a horizon.
pub const LOWEST_EYE_M: f64 = 1.0;

/// Along a ray of [`Atmosphere::radiance`].
const STEPS: Steps = Steps { longest: 1.2, fewest: 14.0 };

/// The air: what of it does not depend on where the sun and the eye are.
#[derive(Clone, Debug)]
pub struct Atmosphere {
    transmittance: Transmittance,
    multiple: Table,
}

/// What the air does to what is seen through it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AerialPerspective {
    /// Radiance that the air adds.
    pub in_scattered: DVec3,
    /// The share of the radiance behind it that it lets through.
    pub transmittance: DVec3,
}

impl Atmosphere {
    /// Computes the tables. `haze` multiplies the density of aerosols: 1 is a clear maritime day.
    pub fn new(haze: f64) -> Atmosphere {
        let transmittance = Transmittance::new(haze);
        let multiple = multiple::table(&transmittance);
        Atmosphere { transmittance, multiple }
    }

    /// What the density of aerosols is multiplied by.
    pub fn haze(&self) -> f64 {
        self.transmittance.haze
    }

    /// The fourth roots of the transmittance to the end of the air, by the coordinates of Bruneton and Neyret 2008:
    /// columns by distance, rows by height.
    pub fn transmittance_table(&self) -> &Table {
        &self.transmittance.table
    }

    /// The fourth roots of the light of all orders above the first: columns by the sun's elevation, rows by height.
    pub fn multiple_table(&self) -> &Table {
        &self.multiple
    }

    /// What of a star's light, whose direction has the cosine `mu` to the zenith and is not below the horizon, arrives at
    /// `height_m`.
    pub fn transmittance(&self, height_m: f64, mu: f64) -> DVec3 {
        self.transmittance.to_top(height_m / 1e3, mu)
    }

    /// What of the sun's light arrives at `height_m`, on a surface that faces it. `mu_s` is the sine of the elevation of
    /// its centre. The disc sets gradually behind the Earth's edge.
    pub fn sun_transmittance(&self, height_m: f64, mu_s: f64) -> DVec3 {
        self.transmittance.of_sun(height_m / 1e3, mu_s)
    }

    /// Radiance of the clear sky without the sun's disc, for an eye at `eye_height_m` (up to 60 km). Below the horizon it is the
    /// light of the air before the ground, without the ground's.
    pub fn radiance(&self, eye_height_m: f64, direction: DVec3, toward_sun: DVec3) -> DVec3 {
        let (height_km, mu) = (eye_km(eye_height_m), direction.y);
        let ray = Ray::whole(height_km, mu, mu < horizon_mu(height_km));
        self.lit(&ray, toward_sun.y, direction.dot(toward_sun)).in_scattered
    }

    /// What the air between an eye and something `distance_m` away does to it. Beyond the end of the air or the ground
    /// there is nothing more: over the whole way, what is scattered in is [`Atmosphere::radiance`].
    pub fn aerial_perspective(
        &self,
        eye_height_m: f64,
        direction: DVec3,
        toward_sun: DVec3,
        distance_m: f64,
    ) -> AerialPerspective {
        let (height_km, mu) = (eye_km(eye_height_m), direction.y);
        let whole = Ray::whole(height_km, mu, mu < horizon_mu(height_km));
        let ray = Ray { length_km: whole.length_km.min(distance_m / 1e3), ..whole };
        self.lit(&ray, toward_sun.y, direction.dot(toward_sun))
    }

    fn lit(&self, ray: &Ray, mu_s: f64, nu: f64) -> AerialPerspective {
        let path = Path::new(self, ray, ray.shadow(mu_s, nu), STEPS);
        AerialPerspective { in_scattered: path.light(self, ray, mu_s, nu), transmittance: path.transmittance }
    }
}

/// The air along a ray, whatever the sun.
struct Path<'a> {
    pieces: Vec<Piece<'a>>,
    transmittance: DVec3,
}

/// The air that a node of a ray stands for.
struct Piece<'a> {
    at_km: f64,
    level: Level<'a>,
    row: (usize, f64),
    /// What it scatters to the ray's start, by molecules and by aerosols, of light of 1.
    rayleigh: DVec3,
    mie: DVec3,
}

impl<'a> Path<'a> {
    fn new(air: &'a Atmosphere, ray: &Ray, shadow: [f64; 2], steps: Steps) -> Path<'a> {
        let mut through = DVec3::ONE;
        let pieces = ray.nodes(shadow, steps).map(|(at_km, length_km)| {
            let height_km = ray.height_at(at_km).min(TOP_KM);
            let medium = Medium::at(height_km, air.haze());
            let extinction = medium.extinction();
            let passed = (-extinction * length_km).exp();
            let taken = through * (1.0 - passed) / extinction;
            through *= passed;
            Piece {
                at_km,
                level: air.transmittance.at(height_km),
                row: multiple::row(&air.multiple, height_km),
                rayleigh: taken * medium.rayleigh,
                mie: taken * medium.mie,
            }
        });
        let pieces = pieces.collect();
        Path { pieces, transmittance: through }
    }

    /// Hillaire 2020, equations 1 to 4 with his Ψ: what is scattered towards the start of the ray, with the integral
    /// over each part done exactly for the light and the air of its node.
    fn light(&self, air: &Atmosphere, ray: &Ray, mu_s: f64, nu: f64) -> DVec3 {
        let (phase_rayleigh, phase_mie) = (rayleigh_phase(nu), mie_phase(nu));
        let scattered = |piece: &Piece<'_>| {
            let sun_mu = ray.sun_at(piece.at_km, piece.level.height_km, mu_s, nu);
            (piece.rayleigh * phase_rayleigh + piece.mie * phase_mie) * piece.level.of_sun(sun_mu)
                + (piece.rayleigh + piece.mie) * multiple::sample_row(&air.multiple, piece.row, sun_mu)
        };
        self.pieces.iter().map(scattered).sum()
    }
}

/// Elevation of the horizon that an eye sees, radians: 0 or below.
pub fn horizon_rad(eye_height_m: f64) -> f64 {
    horizon_mu(eye_km(eye_height_m)).asin()
}

fn eye_km(eye_height_m: f64) -> f64 {
    eye_height_m.max(LOWEST_EYE_M) / 1e3
}

#[cfg(test)]
mod tests;
