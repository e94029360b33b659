//! How a tile covers the sea without repeating.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | L | side of the tile, m |
//! | u | place in steps of a lattice of equilateral triangles with sides of 0.6 L |
//! | bᵢ | barycentric coordinates of a place in its triangle |
//! | ŵᵢ | bᵢ²/√Σb⁴ |
//! | oᵢ | a shift of the tile, by chance, one for each corner of the lattice |
//!
//! A tile f repeats after L. Sewn from patches it is Σ ŵᵢ f(**x** + oᵢ), over the three corners of the triangle around **x**: tiling
//! and blending of Heitz and Neyret, "High-Performance By-Example Noise using a Histogram-Preserving Blending Operator" (2018),
//! for fields that are normal to begin with. Copies at different shifts are independent, and Σŵ² = 1: mean and variance of height,
//! slope and velocity are those of the tile at every place. A patch is smaller than a tile, so no water has a copy of itself
//! at L, and shifts are by chance, so none has one at another distance that is the same for all.
//!
//! Corners are of three kinds, one of each to a triangle, and each kind keeps to a third of the tile: two copies that lie over one
//! another are never the same water.

use super::sample::Sums;
use glam::{DMat2, DVec2};

/// Sides of triangles in sides of the tile. Below a half, a patch would not hold the same water twice at all; its outermost
/// tenth counts for nothing.
const EDGE: f64 = 0.6;

/// How far a shift is from the middle of its third, in tiles, to either side of it.
const JITTER: f64 = 0.28;

/// The angle between the triangles of a tile and those of the next, rad.
const TURN: f64 = 0.65;

/// The patches of one tile of a sea that is [sewn](super::SpectralSea::sewn): three copies of it lie over each place, at shifts by
/// chance, with weights whose squares add up to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patchwork {
    /// Steps of the lattice to a metre east and to one south.
    lattice_per_m: DMat2,
    seed: u32,
}

/// One of the three copies of a tile that lie over a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// What is to be added to the place, in tiles.
    pub shift: DVec2,
    /// ŵ; the squares of all three add up to 1.
    pub weight: f64,
    /// By how much it grows to a metre east and south.
    pub slope_per_m: DVec2,
}

impl Patchwork {
    /// That of the `index`-th tile of a sea, `tile_size_m` a side.
    pub(super) fn new(tile_size_m: f64, index: usize, seed: u64) -> Self {
        let angle = 0.3 + TURN * index as f64;
        let side = |angle: f64| EDGE * tile_size_m * DVec2::new(libm::cos(angle), libm::sin(angle));
        let steps = DMat2::from_cols(side(angle), side(angle + std::f64::consts::FRAC_PI_3));
        let seed = (seed ^ (seed >> 32)) as u32 ^ (index as u32).wrapping_mul(0x9e37_79b1);
        Self { lattice_per_m: steps.inverse(), seed }
    }

    /// Steps of the lattice to a metre east and to one south, as columns.
    pub fn lattice_per_m(&self) -> DMat2 {
        self.lattice_per_m
    }

    /// What shifts follow from.
    pub fn seed(&self) -> u32 {
        self.seed
    }

    /// The copies over `rest_m`. Twin of `patches_at` in `patchwork.wesl`.
    pub fn patches_at(&self, rest_m: DVec2) -> [Patch; 3] {
        let place = self.lattice_per_m * rest_m;
        let corner = place.floor();
        let within = place - corner;
        let (u, v) = (within.x, within.y);
        let (east, south) = (self.lattice_per_m.row(0), self.lattice_per_m.row(1));
        let is_far = u + v > 1.0;
        let (first, shares, slopes) = match is_far {
            false => ([0, 0], [1.0 - u - v, u, v], [-east - south, east, south]),
            true => ([1, 1], [u + v - 1.0, 1.0 - v, 1.0 - u], [east + south, -south, -east]),
        };
        // Casts of what is far beyond any sea saturate.
        let (i, j) = (corner.x as i64, corner.y as i64);
        let kind = (i - j).rem_euclid(3) as usize;
        let corners = [first, [1, 0], [0, 1]];
        let fourth: f64 = shares.iter().map(|share| share.powi(4)).sum();
        let length = fourth.sqrt();
        let length_slope: DVec2 =
            shares.iter().zip(slopes).map(|(share, slope)| 2.0 * share.powi(3) * slope).sum::<DVec2>()
                / length;
        std::array::from_fn(|corner| {
            let [di, dj] = corners[corner];
            let shift = self.shift((i + di) as u32, (j + dj) as u32, (kind + corner) % 3);
            let (share, slope) = (shares[corner], slopes[corner]);
            let weight = share * share / length;
            Patch { shift, weight, slope_per_m: (2.0 * share * slope - weight * length_slope) / length }
        })
    }

    /// The shift at a corner of this kind, in tiles.
    fn shift(&self, i: u32, j: u32, kind: usize) -> DVec2 {
        let mut hash = i.wrapping_mul(0x9e37_79b1) ^ j.wrapping_mul(0x85eb_ca77) ^ self.seed;
        hash = (hash ^ (hash >> 15)).wrapping_mul(0x2c1b_3c6d);
        hash = (hash ^ (hash >> 12)).wrapping_mul(0x297a_2d39);
        hash ^= hash >> 15;
        let chance = DVec2::new(f64::from(hash & 0xffff), f64::from(hash >> 16)) / 65_536.0;
        DVec2::splat(kind as f64 / 3.0) + JITTER * (chance - 0.5)
    }

    /// What is over `rest_m` of a tile of this side of which `of` tells: shape and velocity.
    pub(crate) fn sums(&self, rest_m: DVec2, tile_size_m: f64, of: impl Fn(DVec2) -> Sums) -> Sums {
        let mut all = Sums::default();
        for Patch { shift, weight, slope_per_m } in self.patches_at(rest_m) {
            let there = of(rest_m + shift * tile_size_m);
            let Sums { height, shift, slope, gradient: [xx, xz, zz], velocity } = there;
            // What the weights' own change adds, of a thousandth; the displacement stays a gradient field but for that, whose
            // symmetric part is kept.
            let xz_change = 0.5 * (shift.x * slope_per_m.y + shift.y * slope_per_m.x);
            all += Sums {
                height: weight * height,
                shift: weight * shift,
                slope: weight * slope + height * slope_per_m,
                gradient: [
                    weight * xx + shift.x * slope_per_m.x,
                    weight * xz + xz_change,
                    weight * zz + shift.y * slope_per_m.y,
                ],
                velocity: weight * velocity,
            };
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places() -> impl Iterator<Item = DVec2> {
        (0..4000).map(|i| {
            let i = f64::from(i);
            DVec2::new((0.754_877_666 * i).fract() - 0.5, (0.569_840_291 * i).fract() - 0.5) * 1e5
        })
    }

    #[test]
    fn weights_are_of_unit_length_smooth_and_have_their_slopes() {
        let patchwork = Patchwork::new(900.0, 1, 77);
        for place in places() {
            let here = patchwork.patches_at(place);
            let squares: f64 = here.iter().map(|patch| patch.weight * patch.weight).sum();
            assert!((squares - 1.0).abs() < 1e-12, "{squares}");
            for along in [DVec2::X, DVec2::Y] {
                let step = 1e-3;
                let (behind, ahead) =
                    (patchwork.patches_at(place - step * along), patchwork.patches_at(place + step * along));
                for patch in here {
                    // By its shift, since corners change their order at an edge, where weights are 0.
                    let weight = |of: &[Patch; 3]| {
                        of.iter().find(|other| other.shift == patch.shift).map_or(0.0, |other| other.weight)
                    };
                    let slope = (weight(&ahead) - weight(&behind)) / (2.0 * step);
                    assert!(
                        (slope - patch.slope_per_m.dot(along)).abs() < 1e-6,
                        "{place}: {slope} {patch:?}"
                    );
                }
            }
        }
    }

    /// No two copies over a place are the same water, and those over places a tile apart are neither.
    #[test]
    fn copies_are_of_different_water() {
        let size_m = 900.0;
        let patchwork = Patchwork::new(size_m, 0, 5);
        let apart = |a: DVec2, b: DVec2| {
            let between = a - b;
            (between - between.round()).length()
        };
        let mut same = 0.0;
        for place in places() {
            let here = patchwork.patches_at(place);
            for i in 0..3 {
                assert!(apart(here[i].shift, here[(i + 1) % 3].shift) > 0.05);
            }
            for (x, z) in [(1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (2.0, 0.0), (5.0, 3.0)] {
                for there in patchwork.patches_at(place + size_m * DVec2::new(x, z)) {
                    let shared = here.iter().filter(|patch| apart(patch.shift, there.shift) < 0.01);
                    same += shared.map(|patch| patch.weight * there.weight).sum::<f64>();
                }
            }
        }
        let share = same / (5.0 * places().count() as f64);
        assert!(share < 0.01, "{share}");
    }
}
