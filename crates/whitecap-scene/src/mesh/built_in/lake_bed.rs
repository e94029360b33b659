//! A lake's bed: a basin, its shore and the hills around it.

use glam::{DVec2, Vec3};

use super::Mesh;
use super::noise::{Noise, smooth_step};
use super::terrain::{Spot, colors, rings};

/// How far the shore is from the middle on average, metres.
const SHORE_M: f64 = 43.0;

/// How far out the ground reaches, metres.
const RIM_M: f64 = 150.0;

/// The depth in the middle, metres.
const DEPTH_M: f64 = 5.0;

/// How much the bank rises per metre away from the water.
const BANK_SLOPE: f64 = 0.09;

/// The ground of the built-in mesh "lake-bed".
#[derive(Clone, Debug)]
pub struct LakeBed {
    shore: Noise,
    hills: Noise,
    bottom: Noise,
    patches: Noise,
}

impl LakeBed {
    /// The lake's bed of this seed.
    pub fn new(seed: u64) -> Self {
        let noise = |purpose| Noise::new(seed, purpose);
        LakeBed {
            shore: noise(0x1a4e0),
            hills: noise(0x1a4e1),
            bottom: noise(0x1a4e2),
            patches: noise(0x1a4e3),
        }
    }

    /// The height of the ground `x` east and `z` south of the middle, metres; below 0 under water.
    pub fn height_m(&self, x: f64, z: f64) -> f64 {
        let place = DVec2::new(x, z);
        let shore_m = self.shore_m(place);
        let out = place.length() / shore_m;
        if out <= 1.0 {
            // Steepest half-way down; the bed is as flat as the bank at the water's edge.
            let below = 1.0 - out;
            let basin_m = (DEPTH_M - BANK_SLOPE * shore_m * 0.5) * smooth_step(0.0, 0.9, below);
            let uneven_m = 0.45 * self.bottom.octaves(place / 9.0, 3) * smooth_step(0.05, 0.4, below);
            // The bank's slope fades into the flat middle.
            return -basin_m - BANK_SLOPE * shore_m * below * (1.0 - 0.5 * below) + uneven_m;
        }
        let inland = (place.length() - shore_m) / (RIM_M - shore_m);
        let hill_m = 10.8 + 4.0 * (1.8 * self.hills.octaves(place / 55.0, 3)).clamp(-1.0, 1.0);
        let rough_m = 0.7 * self.hills.octaves(place / 6.0, 2) * smooth_step(0.05, 0.3, inland);
        let bank_m = BANK_SLOPE * (place.length() - shore_m);
        let rise = smooth_step(0.0, 0.95, inland);
        bank_m * (1.0 - rise) + hill_m * rise + rough_m
    }

    /// The mesh, about 7,500 triangles.
    pub(super) fn mesh(&self) -> Mesh {
        // Dense in the water and on the shore, coarse on the hills.
        let radius_m = |ring: u32| {
            let t = f64::from(ring) / 47.0;
            76.0 * t + (RIM_M - 76.0) * t.powi(4)
        };
        let radii_m: Vec<f64> = (1..=47).map(radius_m).collect();
        rings(&radii_m, 80, |place| self.height_m(place.x, place.y), |spot| self.color(spot))
    }

    /// How far the shore is from the middle in the direction of `place`, metres.
    fn shore_m(&self, place: DVec2) -> f64 {
        let around = place.normalize_or(DVec2::X);
        SHORE_M * (1.0 + 0.2 * (1.6 * self.shore.octaves(around * 1.7, 3)).clamp(-1.0, 1.0))
    }

    fn color(&self, spot: &Spot) -> Vec3 {
        let fine = self.patches.octaves(spot.place / 2.2, 2) as f32;
        let broad = self.patches.octaves(spot.place / 8.0, 3);
        // Fields of pebbles and banks of sand, with edges that refraction bends visibly.
        let stony = smooth_step(0.0, 0.2, broad) as f32;
        let sand = colors::SAND * (0.94 + 0.16 * fine);
        let pebbles = colors::PEBBLES * (1.0 + 0.55 * fine);
        let bed = sand.lerp(pebbles, stony);
        let weedy = smooth_step(2.2, 3.6, -spot.height_m) * smooth_step(-0.1, -0.3, -broad.abs());
        let bed = bed.lerp(colors::WEED, 0.8 * weedy as f32);
        let wet = smooth_step(0.5, 0.1, spot.height_m) as f32;
        let shore = bed * (1.0 - 0.22 * wet);

        let grass =
            colors::GRASS.lerp(colors::DRY_GRASS, (0.4 + 0.9 * broad as f32 + 0.3 * fine).clamp(0.0, 1.0));
        let green = smooth_step(0.6, 1.4, spot.height_m + 0.5 * broad) as f32;
        let steep = smooth_step(0.38, 0.6, spot.slope + 0.1 * f64::from(fine)) as f32;
        shore.lerp(grass.lerp(colors::ROCK * (1.0 + 0.3 * fine), steep), green)
    }
}
