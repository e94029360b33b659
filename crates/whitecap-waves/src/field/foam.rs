//! The structure of foam: a still field that repeats, whose lowest ranks are the last to vanish.
//!
//! Old foam is a lace: walls around holes that grow, bubbles in the walls. The distance to the second nearest of
//! random points less that to the nearest (Worley, "A Cellular Texture Basis Function", 1996) is zero on such walls.
//! Octaves of it are bent by gradient noise, added up, and replaced by their ranks: then a share c of the texels has
//! ranks below c, and foam that is drawn where ranks are below its cover has just that cover.

use super::HeightField;
use crate::error::{ParameterError, check};
use crate::random::uniform;
use glam::DVec2;
use rand_chacha::ChaCha8Rng;
use rand_core::SeedableRng;

/// Cells along the side and weight of each octave, from holes to bubbles.
const OCTAVES: [(usize, f64); 4] = [(5, 1.0), (13, 0.6), (37, 0.4), (89, 0.25)];

/// How far the walls are bent, in sides.
const BENT: f64 = 0.012;

/// A mip chain of ranks; see [`foam_drawn`](crate::optics::foam_drawn).
///
/// Each level is ranked for itself, so its mean is kept at every distance, and says what share of the structure is left
/// in it: the variance of the averaged field over that of the first level.
pub struct FoamStructure {
    size: usize,
    levels: Vec<Vec<[u8; 2]>>,
}

impl FoamStructure {
    /// The structure with `size` texels a side, a power of two from 16 to 2048.
    ///
    /// # Errors
    ///
    /// If `size` is no such number.
    pub fn new(size: usize, seed: u64) -> Result<Self, ParameterError> {
        check("size", size as f64, "a power of two from 16 to 2048", |_| {
            size.is_power_of_two() && (16..=2048).contains(&size)
        })?;
        let bend = [HeightField::perlin(size, seed, 2, 0.5)?, HeightField::perlin(size, seed ^ 1, 2, 0.5)?];
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut field = vec![0.0_f32; size * size];
        // Walls finer than two texels would only be noise.
        for &(cells, weight) in OCTAVES.iter().filter(|octave| 4 * octave.0 <= size) {
            let points = Points::new(cells, &mut rng);
            for (i, value) in field.iter_mut().enumerate() {
                let bent = DVec2::new(f64::from(bend[0].heights()[i]), f64::from(bend[1].heights()[i]));
                let place = DVec2::new((i % size) as f64, (i / size) as f64) / size as f64 + BENT * bent;
                *value += (weight * points.wall_distance(place * cells as f64)) as f32;
            }
        }
        Ok(Self { size, levels: ranked_levels(field, size) })
    }

    /// Texels along a side of the first level.
    pub fn size(&self) -> usize {
        self.size
    }

    /// All levels, the largest first: for each texel its rank and the level's contrast, of 255.
    pub fn levels(&self) -> &[Vec<[u8; 2]>] {
        &self.levels
    }
}

/// One random point in each cell of a square, which repeats.
struct Points {
    cells: usize,
    points: Vec<DVec2>,
}

impl Points {
    fn new(cells: usize, rng: &mut ChaCha8Rng) -> Self {
        let points = (0..cells * cells).map(|_| DVec2::new(uniform(rng), uniform(rng))).collect();
        Self { cells, points }
    }

    /// F2 − F1 at `place`, in cells.
    fn wall_distance(&self, place: DVec2) -> f64 {
        let corner = place.floor();
        let (mut nearest, mut second) = (f64::INFINITY, f64::INFINITY);
        let wrap = |i: f64| i.rem_euclid(self.cells as f64) as usize % self.cells;
        for dz in -1..=1 {
            for dx in -1..=1 {
                let cell = corner + DVec2::new(f64::from(dx), f64::from(dz));
                let point = cell + self.points[wrap(cell.y) * self.cells + wrap(cell.x)];
                let distance = place.distance_squared(point);
                second = second.min(distance.max(nearest));
                nearest = nearest.min(distance);
            }
        }
        second.sqrt() - nearest.sqrt()
    }
}

fn ranked_levels(mut field: Vec<f32>, size: usize) -> Vec<Vec<[u8; 2]>> {
    let variance = |field: &[f32]| crate::statistics::Moments::of(field).variance;
    let whole = variance(&smoothed(&field, size));
    let (mut levels, mut side) = (Vec::new(), size);
    loop {
        let smooth = smoothed(&field, side);
        let contrast = (255.0 * variance(&smooth) / whole).round() as u8;
        levels.push(ranks(&smooth).into_iter().map(|rank| [rank, contrast]).collect());
        if side == 1 {
            return levels;
        }
        side /= 2;
        let mean = |i: usize| {
            let at = i / side * 4 * side + i % side * 2;
            let four = [at, at + 1, at + 2 * side, at + 2 * side + 1];
            0.25 * four.iter().map(|&j| field[j]).sum::<f32>()
        };
        field = (0..side * side).map(mean).collect();
    }
}

/// Means over three by three texels with weights 1, 2, 1: where neighbours are alike, ranks between them are still even.
fn smoothed(field: &[f32], n: usize) -> Vec<f32> {
    let row = |z: usize, x: usize| {
        field[z * n + (x + n - 1) % n] + 2.0 * field[z * n + x] + field[z * n + (x + 1) % n]
    };
    let texel = |i: usize| {
        let (x, z) = (i % n, i / n);
        (row((z + n - 1) % n, x) + 2.0 * row(z, x) + row((z + 1) % n, x)) / 16.0
    };
    (0..n * n).map(texel).collect()
}

/// Of 255, the middle of each texel's share.
fn ranks(field: &[f32]) -> Vec<u8> {
    let mut order: Vec<u32> = (0..field.len() as u32).collect();
    order.sort_by(|&a, &b| field[a as usize].total_cmp(&field[b as usize]));
    let mut ranks = vec![0; field.len()];
    for (rank, texel) in order.into_iter().enumerate() {
        ranks[texel as usize] = (255.0 * (rank as f64 + 0.5) / field.len() as f64).round() as u8;
    }
    ranks
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::{foam_drawn, foam_rank};

    /// Foam of any cover, drawn with any level, has that cover: to a level of 8 bits.
    #[test]
    fn every_level_keeps_every_cover() {
        let structure = FoamStructure::new(256, 7).unwrap();
        assert_eq!(structure.levels().len(), 9);
        for level in structure.levels() {
            for cover in [0.0, 0.01, 0.1, 0.35, 0.8, 1.0] {
                let drawn = |&[rank, contrast]: &[u8; 2]| {
                    foam_drawn(cover, f64::from(rank) / 255.0, f64::from(contrast) / 255.0)
                };
                let mean = level.iter().map(drawn).sum::<f64>() / level.len() as f64;
                // Few texels have few ranks, and little contrast.
                assert!((mean - cover).abs() < 4e-3, "{} texels, {cover}: {mean}", level.len());
            }
        }
    }

    /// Also between texels, and with two scales laid over each other at places without common measure.
    #[test]
    fn two_scales_between_texels_keep_the_cover() {
        let structure = FoamStructure::new(512, 7).unwrap();
        let level = &structure.levels()[0];
        let rank = |place: DVec2| {
            let place = place.rem_euclid(DVec2::ONE) * 512.0;
            let (corner, t) = (place.floor(), place.fract());
            let at = |i: usize, j: usize| {
                f64::from(level[(corner.y as usize + j) % 512 * 512 + (corner.x as usize + i) % 512][0])
                    / 255.0
            };
            let row = |j: usize| at(0, j) * (1.0 - t.x) + at(1, j) * t.x;
            row(0) * (1.0 - t.y) + row(1) * t.y
        };
        for cover in [0.02, 0.1, 0.3, 0.7] {
            let drawn = |i: u32| {
                let place = f64::from(i) * DVec2::new(0.754_877_666, 0.569_840_291) * 13.7;
                foam_drawn(cover, foam_rank(rank(place / 19.0), rank(place / 3.1)), 1.0)
            };
            let mean = (0..200_000).map(drawn).sum::<f64>() / 2e5;
            assert!((mean / cover - 1.0).abs() < 0.06, "{cover}: {mean}");
        }
    }

    #[test]
    fn contrast_falls_with_distance() {
        let structure = FoamStructure::new(256, 7).unwrap();
        let contrasts: Vec<u8> = structure.levels().iter().map(|level| level[0][1]).collect();
        assert_eq!((contrasts[0], contrasts[8]), (255, 0));
        assert!(contrasts.is_sorted_by(|a, b| a >= b), "{contrasts:?}");
    }

    #[test]
    fn seeds_decide_and_sizes_are_checked() {
        let first = |seed| FoamStructure::new(64, seed).unwrap().levels()[0].clone();
        assert_eq!(first(1), first(1));
        assert_ne!(first(1), first(2));
        assert!(FoamStructure::new(100, 1).is_err() && FoamStructure::new(4096, 1).is_err());
    }
}
