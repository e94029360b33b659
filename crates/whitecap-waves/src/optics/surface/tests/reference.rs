//! What the closed forms stand for, by brute force.

use super::super::{SlopeCovariance, Slopes, hidden_projection};
use crate::optics::fresnel_exact;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

pub(super) const N: f64 = 1.34;

pub(super) fn slopes(xx: f64, xz: f64, zz: f64, mean: DVec2) -> Slopes {
    Slopes { mean, covariance: SlopeCovariance { xx, xz, zz } }
}

pub(super) fn isotropic(deviation: f64) -> Slopes {
    slopes(deviation * deviation, 0.0, deviation * deviation, DVec2::ZERO)
}

/// Towards an eye whose ray meets the vertical at `degrees`, in the south-east.
pub(super) fn eye(degrees: f64) -> DVec3 {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    DVec3::new(0.8 * sine, cosine, 0.6 * sine)
}

pub(super) fn facet(slope: DVec2) -> DVec3 {
    DVec3::new(-slope.x, 1.0, -slope.y)
}

/// Calls `each` with slopes over the plane and their share of it.
pub(super) fn over_slopes(slopes: &Slopes, mut each: impl FnMut(DVec2, f64)) {
    let c = slopes.covariance;
    // Cholesky's factors of C.
    let first = c.xx.max(1e-16).sqrt();
    let second = c.xz / first;
    let third = (c.zz - second * second).max(0.0).sqrt();
    let step = 0.05;
    for i in -130..=130 {
        for j in -130..=130 {
            let (u, w) = (step * f64::from(i), step * f64::from(j));
            let share = (-0.5 * (u * u + w * w)).exp() / TAU * step * step;
            each(slopes.mean + DVec2::new(first * u, second * u + third * w), share);
        }
    }
}

/// Means over what is seen: of the Fresnel reflectance, of F times the share of light that escapes at once, and of
/// the slope.
pub(super) fn visible_means(slopes: &Slopes, toward_eye: DVec3) -> (f64, f64, DVec2) {
    let (mut seen, mut fresnel, mut single, mut slope) = (0.0, 0.0, 0.0, DVec2::ZERO);
    let eye_lambda = lambda(slopes, toward_eye);
    over_slopes(slopes, |zeta, share| {
        let shown = share * toward_eye.dot(facet(zeta)).max(0.0);
        let normal = facet(zeta).normalize();
        let cos = toward_eye.dot(normal);
        let f = fresnel_exact(cos, N);
        let light = 2.0 * cos * normal - toward_eye;
        let light_lambda = lambda(slopes, light);
        seen += shown;
        fresnel += shown * f;
        slope += shown * zeta;
        if light_lambda >= 0.0 {
            single += shown * f * (1.0 + eye_lambda) / (1.0 + eye_lambda + light_lambda);
        }
    });
    (fresnel / seen, single / seen, slope / seen)
}

/// Smith's Λ, negative below the horizon, where Λ(−ω) = −1 − Λ(ω).
fn lambda(slopes: &Slopes, ray: DVec3) -> f64 {
    let horizontal = DVec2::new(ray.x, ray.z);
    let mean = ray.y - horizontal.dot(slopes.mean);
    let deviation = slopes.covariance.between(horizontal, horizontal).sqrt().max(1e-12);
    let z = mean / deviation;
    let hidden = hidden_projection(z.abs()) / z.abs().max(1e-12);
    if z > 0.0 { hidden } else { -1.0 - hidden }
}

/// Uniform numbers in 0..1 (SplitMix64, Steele et al. 2014).
struct Random(u64);

impl Random {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x ^ (x >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn normal_pair(&mut self) -> DVec2 {
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        let (sine, cosine) = (TAU * self.uniform()).sin_cos();
        radius * DVec2::new(cosine, sine)
    }
}

/// The light that many reflections on a surface by Smith bring to the eye of a sky of radiance `sky`, by the random
/// walk of Heitz, Hanika, d'Eon and Dachsbacher (*ACM Trans. Graph.* 35, 2016). What enters the water is lost.
pub(super) fn walked(slopes: &Slopes, toward_eye: DVec3, walks: u32, sky: impl Fn(DVec3) -> f64) -> f64 {
    let mut random = Random(7);
    let c = slopes.covariance;
    let first = c.xx.sqrt();
    let second = c.xz / first;
    let third = (c.zz - second * second).max(0.0).sqrt();
    let mut sum = 0.0;
    for _ in 0..walks {
        // `ray` goes on; `below` is the share of the surface that lies lower.
        let (mut ray, mut below, mut weight) = (-toward_eye, 1.0_f64, 1.0);
        for _ in 0..12 {
            let lambda = lambda(slopes, ray);
            let u = 1.0 - random.uniform();
            if lambda >= 0.0 && u <= below.powf(lambda) {
                sum += weight * sky(ray);
                break;
            }
            below = (below * u.powf(-1.0 / lambda)).clamp(1e-12, 1.0);
            // A facet seen from where the ray comes, in proportion to what it shows.
            let horizontal = DVec2::new(ray.x, ray.z);
            let mean = -ray.y + horizontal.dot(slopes.mean);
            let most = mean.max(0.0) + 6.0 * c.between(horizontal, horizontal).sqrt();
            let normal = loop {
                let g = random.normal_pair();
                let n = facet(slopes.mean + DVec2::new(first * g.x, second * g.x + third * g.y));
                if random.uniform() * most < -ray.dot(n) {
                    break n.normalize();
                }
            };
            let cos = -ray.dot(normal);
            weight *= fresnel_exact(cos, N);
            ray += 2.0 * cos * normal;
        }
    }
    sum / f64::from(walks)
}
