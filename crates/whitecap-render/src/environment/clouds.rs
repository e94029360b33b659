//! Thin high clouds, so that the water has something to mirror.
//!
//! One layer of gradient noise (Perlin 2002, "Improving Noise"), stretched along a wind and warped by
//! itself into the streaks of cirrus. It is lit by the sun through the air and by the sky around it, and
//! thins out towards the horizon, where a flat layer would show its repeat and its edge.

use super::ClearSky;
use glam::{Vec2, Vec3};
use std::f32::consts::PI;

/// Height of the layer; it sets the sun's colour on it.
const HEIGHT_KM: f32 = 9.0;

/// The layer and its light.
pub(super) struct Clouds {
    cover: f32,
    seed: u32,
    sun: Vec3,
    toward_sun: Vec3,
    ambient: Vec3,
}

impl Clouds {
    /// `cover` from 0 (none) to 1 (nearly all of the sky).
    pub(super) fn new(clear: &ClearSky, cover: f32, seed: u64) -> Clouds {
        Clouds {
            cover,
            seed: (seed ^ (seed >> 32)) as u32,
            sun: clear.sun_transmittance(HEIGHT_KM),
            toward_sun: clear.toward_sun,
            ambient: clear.mean,
        }
    }

    /// The clear sky's `radiance` in a direction above the horizon, with the layer before it.
    pub(super) fn over(&self, direction: Vec3, radiance: Vec3) -> Vec3 {
        let fade = smoothstep(0.02, 0.22, direction.y);
        if self.cover <= 0.0 || fade == 0.0 {
            return radiance;
        }
        let depth = self.optical_depth(direction) * fade;
        let opacity = 1.0 - (-depth).exp();
        radiance * (1.0 - opacity) + self.light(direction, depth) * opacity
    }

    fn optical_depth(&self, direction: Vec3) -> f32 {
        // Where the ray meets the layer, in units of its height; the offset stands for its curvature.
        let at = Vec2::new(direction.x, direction.z) / (direction.y + 0.06);
        let along = Vec2::new(0.87 * at.x - 0.5 * at.y, 0.5 * at.x + 0.87 * at.y);
        let warp = Vec2::new(self.fbm(along * 0.7, 3), self.fbm(along * 0.7 + 31.7, 3));
        let streaks = self.fbm(Vec2::new(along.x * 0.55, along.y * 1.9) + warp * 1.1, 6);
        let patches = self.fbm(along * 0.35 + 7.3, 3);
        let density = streaks + 0.8 * patches + 1.3 * self.cover - 0.55;
        1.6 * smoothstep(0.0, 0.9, density) * density.max(0.0)
    }

    /// Ice scatters forward; thick parts see less of the sun and more of their own grey.
    fn light(&self, direction: Vec3, depth: f32) -> Vec3 {
        let nu = direction.dot(self.toward_sun);
        let phase = 0.55 * henyey_greenstein(nu, 0.75) + 0.45 * henyey_greenstein(nu, 0.1);
        let lit = self.sun * (phase + 0.5 / (4.0 * PI)) * (-0.35 * depth).exp();
        1.6 * lit + 1.1 * self.ambient
    }

    fn fbm(&self, mut at: Vec2, octaves: u32) -> f32 {
        let (mut sum, mut amplitude) = (0.0, 0.5);
        for octave in 0..octaves {
            sum += amplitude * gradient_noise(at, self.seed.wrapping_add(octave));
            amplitude *= 0.5;
            // A rotation between octaves hides the lattice.
            at = Vec2::new(1.6 * at.x + 1.2 * at.y, -1.2 * at.x + 1.6 * at.y);
        }
        sum
    }
}

fn henyey_greenstein(nu: f32, g: f32) -> f32 {
    (1.0 - g * g) / (4.0 * PI * (1.0 + g * g - 2.0 * g * nu).powf(1.5))
}

fn smoothstep(low: f32, high: f32, x: f32) -> f32 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Gradient noise about 0, within ±1.
fn gradient_noise(at: Vec2, seed: u32) -> f32 {
    let cell = at.floor();
    let f = at - cell;
    let fade = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let corner = |dx: f32, dy: f32| {
        let hash = lattice_hash(cell.x as i32 + dx as i32, cell.y as i32 + dy as i32, seed);
        GRADIENTS[(hash >> 29) as usize].dot(f - Vec2::new(dx, dy))
    };
    let low = corner(0.0, 0.0) + fade.x * (corner(1.0, 0.0) - corner(0.0, 0.0));
    let high = corner(0.0, 1.0) + fade.x * (corner(1.0, 1.0) - corner(0.0, 1.0));
    std::f32::consts::SQRT_2 * (low + fade.y * (high - low))
}

/// Eight directions are enough where many octaves add up, and need no sines for each corner.
const GRADIENTS: [Vec2; 8] = {
    const D: f32 = std::f32::consts::FRAC_1_SQRT_2;
    [
        Vec2::new(1.0, 0.0),
        Vec2::new(D, D),
        Vec2::new(0.0, 1.0),
        Vec2::new(-D, D),
        Vec2::new(-1.0, 0.0),
        Vec2::new(-D, -D),
        Vec2::new(0.0, -1.0),
        Vec2::new(D, -D),
    ]
};

/// An integer hash of a lattice point: xor-shifts between odd multipliers.
fn lattice_hash(x: i32, y: i32, seed: u32) -> u32 {
    let mut h =
        (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca77) ^ seed.rotate_left(13);
    h = (h ^ (h >> 15)).wrapping_mul(0x2c1b_3c6d);
    h = (h ^ (h >> 12)).wrapping_mul(0x297a_2d39);
    h ^ (h >> 15)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_centred_bounded_and_continuous() {
        let mut sum = 0.0;
        for i in 0..10_000 {
            let at = Vec2::new((i % 100) as f32 * 0.173, (i / 100) as f32 * 0.211);
            let n = gradient_noise(at, 5);
            assert!(n.abs() <= 1.0);
            assert!((gradient_noise(at + 1e-4, 5) - n).abs() < 1e-2);
            sum += n;
        }
        assert!((sum / 10_000.0_f32).abs() < 0.05);
    }

    #[test]
    fn more_cover_means_less_clear_sky() {
        let air =
            ClearSky::new(&whitecap_scene::sky::Atmosphere { sun_elevation_deg: 53.0, ..Default::default() });
        let clear = Vec3::new(0.1, 0.2, 0.4);
        let mean_change = |cover: f32| {
            let clouds = Clouds::new(&air, cover, 3);
            (0..400)
                .map(|i| {
                    let a = i as f32 * 0.7;
                    let d = Vec3::new(a.sin(), 0.3 + 0.001 * i as f32, a.cos()).normalize();
                    (clouds.over(d, clear) - clear).length()
                })
                .sum::<f32>()
        };
        assert_eq!(mean_change(0.0), 0.0);
        assert!(mean_change(0.8) > 1.5 * mean_change(0.3));
    }
}
