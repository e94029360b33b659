//! An island with a beach, ridges and an underwater flank.

use glam::DVec2;

use super::Mesh;
use super::noise::{Noise, smooth_step};
use super::terrain::{Spot, colors, rings};

/// The radius of the island at the waterline, on average, metres.
const SHORE_M: f64 = 40.0;

/// How far out the ground reaches, metres.
const RIM_M: f64 = 90.0;

/// The height of the summit, metres.
const SUMMIT_M: f64 = 9.0;

/// The depth at the rim, metres.
const DEPTH_M: f64 = 12.0;

/// How much the beach rises per metre inland.
const BEACH_SLOPE: f64 = 0.07;

/// The ground of the built-in mesh "island".
#[derive(Clone, Debug)]
pub struct Island {
    coast: Noise,
    ridges: Noise,
    patches: Noise,
    /// What makes the highest of the ridges as high as the summit.
    hill_m: f64,
}

impl Island {
    /// The island of this seed.
    pub fn new(seed: u64) -> Self {
        let noise = |purpose| Noise::new(seed, purpose);
        let mut island =
            Island { coast: noise(0x15a0), ridges: noise(0x15a1), patches: noise(0x15a2), hill_m: 0.0 };
        // The summit is where the search finds it: the beach's share is small, so one division is near enough.
        let mut steepest = 0.0_f64;
        for x in -40..=40 {
            for z in -40..=40 {
                let place = DVec2::new(f64::from(x), f64::from(z));
                let hill = island.hill(place, island.inland_m(place));
                let beach_m = BEACH_SLOPE * island.inland_m(place);
                steepest = steepest.max(hill / (SUMMIT_M - beach_m));
            }
        }
        island.hill_m = 1.0 / steepest.max(1e-3);
        island
    }

    /// The height of the ground `x` east and `z` south of the middle, metres; below 0 under water.
    pub fn height_m(&self, x: f64, z: f64) -> f64 {
        let place = DVec2::new(x, z);
        let inland_m = self.inland_m(place);
        if inland_m >= 0.0 {
            return BEACH_SLOPE * inland_m + self.hill_m * self.hill(place, inland_m);
        }
        // A shelf as flat as the beach, which bends down to the rim.
        let out = (-inland_m / (RIM_M - SHORE_M)).min(1.3);
        let shelf_m = BEACH_SLOPE * (RIM_M - SHORE_M) * out;
        let rocks_m = 0.8 * self.ridges.octaves(place / 7.0, 3) * smooth_step(0.05, 0.3, out);
        -shelf_m - (DEPTH_M - BEACH_SLOPE * (RIM_M - SHORE_M)) * smooth_step(0.0, 1.2, out) * 1.08 + rocks_m
    }

    /// The mesh, about 4,400 triangles.
    pub(super) fn mesh(&self) -> Mesh {
        // Dense across the island, coarser towards the rim.
        let radius_m = |ring: u32| {
            let t = f64::from(ring) / 35.0;
            62.0 * t + (RIM_M - 62.0) * t.powi(4)
        };
        let radii_m: Vec<f64> = (1..=35).map(radius_m).collect();
        rings(&radii_m, 64, |place| self.height_m(place.x, place.y), |spot| self.color(spot))
    }

    /// How far the waterline is, metres; negative at sea.
    fn inland_m(&self, place: DVec2) -> f64 {
        let radius_m = place.length();
        let shore_m = SHORE_M * (1.0 + 0.16 * self.coast.octaves(place.normalize_or_zero() * 1.6, 3));
        shore_m - radius_m + 1.5 * self.coast.octaves(place / 9.0, 2)
    }

    /// The hills without their scale: ridges that begin behind the beach.
    fn hill(&self, place: DVec2, inland_m: f64) -> f64 {
        let crest = |wavelength_m: f64| 1.0 - self.ridges.octaves(place / wavelength_m, 3).abs() * 2.2;
        let rough = 0.10 * self.ridges.octaves(place / 4.0, 2);
        smooth_step(6.0, 34.0, inland_m) * (0.45 + 0.65 * crest(22.0).max(0.0) + rough)
    }

    fn color(&self, spot: &Spot) -> glam::Vec3 {
        let patch = self.patches.octaves(spot.place / 5.0, 3);
        let dry = smooth_step(0.1, 0.6, spot.height_m + 0.15 * patch) as f32;
        let sand = colors::WET_SAND.lerp(colors::SAND, dry) * (1.0 + 0.08 * patch as f32);
        // Below the beach weed and stones take over with depth.
        let deep = smooth_step(0.8, 6.0, -spot.height_m + 2.0 * patch) as f32;
        let sea_bed = sand.lerp(colors::PEBBLES.lerp(colors::WEED, 0.4 + 0.6 * patch as f32), 0.75 * deep);
        let grass = colors::GRASS.lerp(colors::DRY_GRASS, (0.45 + 0.9 * patch as f32).clamp(0.0, 1.0));
        let green = smooth_step(1.1, 1.9, spot.height_m + 0.5 * patch) as f32;
        let steep = smooth_step(0.55, 0.85, spot.slope + 0.2 * patch) as f32;
        let land = sea_bed.lerp(grass, green);
        land.lerp(colors::ROCK * (1.0 + 0.25 * patch as f32), steep)
    }
}
