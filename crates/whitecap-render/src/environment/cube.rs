//! A cube map with mips that are prefiltered for reflection in a rough surface.

use super::{SUN_RADIUS_RAD, Sun, display_from_linear};
use crate::threads::*;
use glam::{Vec2, Vec3};
use half::f16;

/// Texels along a face's edge: 0.18° each, a third of the sun's disc.
pub const FACE_SIZE: u32 = 512;

/// Levels above this one are plain 2×2 means; from here on a wider kernel hides the texel grid.
const FIRST_SMOOTHED_LEVEL: u32 = 3;

/// The largest radiance kept, well inside a half float.
const MAX_RADIANCE: f32 = 60_000.0;

/// Six faces and their mip chain as half floats: display values, or the radiance itself.
pub struct CubeMap {
    /// For each level all six faces (+x −x +y −y +z −z), rows downwards, RGBA; alpha is the [`glow`] of display
    /// values.
    pub levels: Vec<Vec<[f16; 4]>>,
}

impl CubeMap {
    /// Samples `radiance` (linear, by unit direction) with `across`² samples a texel, adds the sun's
    /// disc by the share of each texel that it covers, and filters the chain in linear light.
    pub fn bake(radiance: impl Fn(Vec3) -> Vec3 + Sync, sun: Option<&Sun>, across: u32) -> CubeMap {
        CubeMap { levels: chain(radiance, sun, across, encode) }
    }

    /// As [`CubeMap::bake`] without a sun, and with the radiance itself instead of display values; alpha is 1.
    pub fn bake_linear(radiance: impl Fn(Vec3) -> Vec3 + Sync, across: u32) -> CubeMap {
        let store =
            |level: &[Vec3]| level.par_iter().map(|c| c.extend(1.0).to_array().map(f16::from_f32)).collect();
        CubeMap { levels: chain(radiance, None, across, store) }
    }

    /// Irradiance of a linear map on a level surface that faces upwards.
    pub fn irradiance(&self) -> Vec3 {
        // A level that is a plain mean of the finest, and has edges along the horizon as all have.
        const LEVEL: usize = 2;
        let size = FACE_SIZE >> LEVEL;
        let light = |(i, texel): (usize, &[f16; 4])| {
            let (face, x, y) = split(i, size);
            let [r, g, b, _] = texel.map(f16::to_f32);
            Vec3::new(r, g, b) * level_share(face, Vec2::new(x as f32, y as f32) + 0.5, size)
        };
        self.levels[LEVEL].iter().enumerate().map(light).sum()
    }
}

/// Every level's radiance, as `store` keeps it.
fn chain(
    radiance: impl Fn(Vec3) -> Vec3 + Sync,
    sun: Option<&Sun>,
    across: u32,
    store: impl Fn(&[Vec3]) -> Vec<[f16; 4]>,
) -> Vec<Vec<[f16; 4]>> {
    let texel = |face: usize, x: u32, y: u32| {
        let mut sum = Vec3::ZERO;
        for (i, j) in (0..across).flat_map(|j| (0..across).map(move |i| (i, j))) {
            let offset = (Vec2::new(i as f32, j as f32) + 0.5) / across as f32;
            sum += radiance(direction(face, Vec2::new(x as f32, y as f32) + offset, FACE_SIZE));
        }
        sum / (across * across) as f32 + sun.map_or(Vec3::ZERO, |sun| sun_in_texel(sun, face, x, y))
    };
    let mut level: Vec<Vec3> = (0..6 * FACE_SIZE as usize * FACE_SIZE as usize)
        .into_par_iter()
        .map(|i| {
            let (face, x, y) = split(i, FACE_SIZE);
            texel(face, x, y).clamp(Vec3::ZERO, Vec3::splat(MAX_RADIANCE))
        })
        .collect();
    let mut levels = vec![store(&level)];
    let mut size = FACE_SIZE;
    while size > 1 {
        let finer = Level { size, texels: &level };
        size /= 2;
        let smooth = levels.len() as u32 >= FIRST_SMOOTHED_LEVEL;
        level = (0..6 * (size * size) as usize)
            .into_par_iter()
            .map(|i| {
                let (face, x, y) = split(i, size);
                if smooth { finer.tent(face, x, y) } else { finer.mean(face, x, y) }
            })
            .collect();
        // The chain goes on from the sharp level; what is stored is rounder, so that a small bright sun
        // spreads into a glow and not into a texel.
        let stored = if smooth { Level { size, texels: &level }.blurred() } else { level.clone() };
        levels.push(store(&stored));
    }
    levels
}

/// What a texel with its middle at `place` adds to the irradiance of a level surface for each unit of its radiance: its solid
/// angle times its cosine to the zenith.
pub(super) fn level_share(face: usize, place: Vec2, size: u32) -> f32 {
    let across = place * (2.0 / size as f32) - 1.0;
    let solid_angle = (2.0 / size as f32).powi(2) / (1.0 + across.length_squared()).powf(1.5);
    solid_angle * direction(face, place, size).y.max(0.0)
}

struct Level<'a> {
    size: u32,
    texels: &'a [Vec3],
}

impl Level<'_> {
    fn texel(&self, face: usize, x: u32, y: u32) -> Vec3 {
        self.texels[(face * self.size as usize + y as usize) * self.size as usize + x as usize]
    }

    fn mean(&self, face: usize, x: u32, y: u32) -> Vec3 {
        let at = |i, j| self.texel(face, 2 * x + i, 2 * y + j);
        0.25 * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1))
    }

    /// A 4×4 binomial kernel about the centre of a texel half as fine.
    fn tent(&self, face: usize, x: u32, y: u32) -> Vec3 {
        let corner = Vec2::new((2 * x) as f32 - 0.5, (2 * y) as f32 - 0.5);
        self.weigh(face, corner, &[0.125, 0.375, 0.375, 0.125])
    }

    /// Every texel under a 5×5 binomial kernel.
    fn blurred(&self) -> Vec<Vec3> {
        let texel = |i: usize| {
            let (face, x, y) = split(i, self.size);
            let corner = Vec2::new(x as f32 - 1.5, y as f32 - 1.5);
            self.weigh(face, corner, &[0.0625, 0.25, 0.375, 0.25, 0.0625])
        };
        (0..self.texels.len()).into_par_iter().map(texel).collect()
    }

    /// A separable kernel whose first tap lies at `corner`, carried across the edges of faces.
    fn weigh(&self, face: usize, corner: Vec2, weights: &[f32]) -> Vec3 {
        let mut sum = Vec3::ZERO;
        for (j, wy) in weights.iter().enumerate() {
            for (i, wx) in weights.iter().enumerate() {
                let at = corner + Vec2::new(i as f32, j as f32);
                let (face, x, y) = locate(direction(face, at, self.size), self.size);
                sum += wx * wy * self.texel(face, x, y);
            }
        }
        sum
    }
}

fn split(index: usize, size: u32) -> (usize, u32, u32) {
    let size = size as usize;
    (index / (size * size), (index % size) as u32, (index / size % size) as u32)
}

/// Unit direction of a place on a face, in texels from its upper left corner (WebGPU's cube layout).
pub(super) fn direction(face: usize, at: Vec2, size: u32) -> Vec3 {
    let Vec2 { x: u, y: v } = at * (2.0 / size as f32) - 1.0;
    let d = match face {
        0 => Vec3::new(1.0, -v, -u),
        1 => Vec3::new(-1.0, -v, u),
        2 => Vec3::new(u, 1.0, v),
        3 => Vec3::new(u, -1.0, -v),
        4 => Vec3::new(u, -v, 1.0),
        _ => Vec3::new(-u, -v, -1.0),
    };
    d.normalize()
}

/// The face and texel that a direction falls on: the inverse of [`direction`].
pub(super) fn locate(d: Vec3, size: u32) -> (usize, u32, u32) {
    let a = d.abs();
    let (face, u, v, major) = if a.x >= a.y && a.x >= a.z {
        if d.x > 0.0 { (0, -d.z, -d.y, a.x) } else { (1, d.z, -d.y, a.x) }
    } else if a.y >= a.z {
        if d.y > 0.0 { (2, d.x, d.z, a.y) } else { (3, d.x, -d.z, a.y) }
    } else if d.z > 0.0 {
        (4, d.x, -d.y, a.z)
    } else {
        (5, -d.x, -d.y, a.z)
    };
    let texel = |c: f32| (((c / major + 1.0) * 0.5 * size as f32) as u32).min(size - 1);
    (face, texel(u), texel(v))
}

/// The sun's light in a texel: its radiance times the share of the texel that the disc covers.
fn sun_in_texel(sun: &Sun, face: usize, x: u32, y: u32) -> Vec3 {
    const ACROSS: u32 = 8;
    let centre = direction(face, Vec2::new(x as f32 + 0.5, y as f32 + 0.5), FACE_SIZE);
    // A texel is at most 2√2/size wide; further out the disc cannot touch it.
    let reach = SUN_RADIUS_RAD + 3.0 / FACE_SIZE as f32;
    if centre.dot(sun.toward) < reach.cos() {
        return Vec3::ZERO;
    }
    let covered = (0..ACROSS * ACROSS)
        .filter(|i| {
            let offset = (Vec2::new((i % ACROSS) as f32, (i / ACROSS) as f32) + 0.5) / ACROSS as f32;
            let d = direction(face, Vec2::new(x as f32, y as f32) + offset, FACE_SIZE);
            // The chord, since 1 − cos is too small for f32.
            (d - sun.toward).length() < SUN_RADIUS_RAD
        })
        .count();
    sun.radiance * (covered as f32 / (ACROSS * ACROSS) as f32)
}

fn encode(level: &[Vec3]) -> Vec<[f16; 4]> {
    let encode = |v: f32| f16::from_f32(display_from_linear(v));
    let texel = |c: &Vec3| [encode(c.x), encode(c.y), encode(c.z), f16::from_f32(glow(*c))];
    level.par_iter().map(texel).collect()
}

/// How far light (linear) is above what a display shows as white, from 0 for white and below to 1 for the brightest
/// that is kept: in stops, as a share of those there are.
pub fn glow(radiance: Vec3) -> f32 {
    radiance.max_element().max(1.0).log2() / MAX_RADIANCE.log2()
}

#[cfg(test)]
mod tests {
    use super::super::linear_from_display;
    use super::*;

    #[test]
    fn a_linear_map_keeps_its_light() {
        let cube = CubeMap::bake_linear(|_| Vec3::new(0.2, 5.0, 40.0), 1);
        let irradiance = cube.irradiance() / std::f32::consts::PI;
        assert!((irradiance / Vec3::new(0.2, 5.0, 40.0) - 1.0).abs().max_element() < 2e-3, "{irradiance}");
    }

    #[test]
    fn locating_undoes_direction_on_every_face() {
        for face in 0..6 {
            for (x, y) in [(0, 0), (3, 11), (15, 15), (8, 0)] {
                let d = direction(face, Vec2::new(x as f32 + 0.5, y as f32 + 0.5), 16);
                assert_eq!(locate(d, 16), (face, x, y));
            }
        }
    }

    #[test]
    fn faces_look_along_their_axes() {
        let middle = Vec2::splat(8.0);
        let axes = [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z];
        for (face, axis) in axes.into_iter().enumerate() {
            assert!((direction(face, middle, 16) - axis).length() < 1e-6);
        }
    }

    #[test]
    fn a_uniform_sky_is_uniform_at_every_level() {
        let cube = CubeMap::bake(|_| Vec3::new(0.2, 0.5, 2.0), None, 1);
        assert_eq!(cube.levels.len(), 10);
        for level in &cube.levels {
            for texel in level {
                for (channel, expected) in texel.iter().zip([0.2, 0.5, 2.0_f32]) {
                    assert!((linear_from_display(channel.to_f32()) / expected - 1.0).abs() < 5e-3);
                }
            }
        }
    }

    #[test]
    fn only_what_is_brighter_than_white_glows() {
        assert_eq!([0.0, 0.3, 1.0].map(|l| glow(Vec3::new(l, 0.0, l))), [0.0; 3]);
        assert!((glow(Vec3::splat(MAX_RADIANCE)) - 1.0).abs() < 1e-6);
        assert!((glow(Vec3::new(1.0, MAX_RADIANCE.sqrt(), 0.0)) - 0.5).abs() < 1e-6);
        let sun = Sun { toward: Vec3::X, radiance: Vec3::splat(20_000.0) };
        let cube = CubeMap::bake(|_| Vec3::splat(0.5), Some(&sun), 1);
        let glowing = cube.levels[0].iter().filter(|texel| texel[3].to_f32() > 0.0).count();
        assert!((4..40).contains(&glowing), "{glowing} texels");
    }

    #[test]
    fn the_baked_sun_carries_its_own_energy() {
        let toward = Vec3::new(0.3, 0.4, -0.7).normalize();
        let sun = Sun { toward, radiance: Vec3::splat(20_000.0) };
        let cube = CubeMap::bake(|_| Vec3::ZERO, Some(&sun), 1);
        let mut irradiance = 0.0_f64;
        for (i, texel) in cube.levels[0].iter().enumerate() {
            let (face, x, y) = split(i, FACE_SIZE);
            let uv = (Vec2::new(x as f32, y as f32) + 0.5) * (2.0 / FACE_SIZE as f32) - 1.0;
            let solid_angle = (2.0 / FACE_SIZE as f32).powi(2) / (1.0 + uv.length_squared()).powf(1.5);
            assert!(face < 6);
            irradiance += f64::from(linear_from_display(texel[1].to_f32()) * solid_angle);
        }
        let disc = std::f64::consts::PI * f64::from(SUN_RADIUS_RAD).powi(2) * 20_000.0;
        assert!((irradiance / disc - 1.0).abs() < 0.03, "{irradiance} instead of {disc}");
    }
}
