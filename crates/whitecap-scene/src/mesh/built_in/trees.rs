//! Conifers around the built-in lake.

use std::f64::consts::TAU;

use glam::{DAffine3, DQuat, DVec2, DVec3, Vec3};

use super::noise::Noise;
use super::solid::{Ring, turned};
use super::{LakeBed, Mesh};

/// How many trees.
const TREES: u64 = 70;

/// How many of them stand in the water.
const IN_WATER: u64 = 5;

const BARK: Vec3 = Vec3::new(0.33, 0.25, 0.18);

/// The trees around the lake of this seed.
pub(super) fn mesh(seed: u64) -> Mesh {
    let bed = LakeBed::new(seed);
    let noise = Noise::new(seed, 0x74ee);
    let mut mesh = Mesh::default();
    for tree in 0..TREES {
        let random = |use_: u64| noise.uniform(16 * tree + use_);
        // One in each share of the full turn, at the height that it asks for.
        let around = DVec2::from_angle((tree as f64 + 0.9 * random(0)) / TREES as f64 * TAU);
        let in_water = tree % (TREES / IN_WATER) == 3;
        let wanted_m = if in_water { -0.3 - 0.4 * random(1) } else { 0.9 + 5.0 * random(1) * random(2) };
        let radius_m = radius_at_height(&bed, around, wanted_m);
        let place = around * radius_m;
        let foot = DVec3::new(place.x, bed.height_m(place.x, place.y), place.y);
        let height_m = if in_water { 4.0 + 2.0 * random(3) } else { 5.0 + 6.0 * random(3) };
        let lean = 0.05 * (random(4) - 0.5) + if in_water { 0.12 } else { 0.0 };
        let turn = DQuat::from_rotation_y(TAU * random(5)) * DQuat::from_rotation_z(lean);
        mesh.append(&one(DAffine3::from_rotation_translation(turn, foot), height_m, random(6)));
    }
    mesh
}

/// The distance from the middle at which the ground has this height, by bisection.
fn radius_at_height(bed: &LakeBed, around: DVec2, height_m: f64) -> f64 {
    let (mut low, mut high) = (10.0, 140.0);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        let place = around * middle;
        if bed.height_m(place.x, place.y) < height_m { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// A conifer around the y axis: a trunk and skirts of needles that grow smaller.
fn one(place: DAffine3, height_m: f64, shade: f64) -> Mesh {
    let ring = |radius_m, y_m, color| Ring { radius_m, y_m, color };
    let tips = Vec3::new(0.22, 0.36, 0.17).lerp(Vec3::new(0.31, 0.41, 0.19), shade as f32);
    let inside = tips * 0.5;
    // The trunk goes on into the ground, which may slope.
    let trunk_m = height_m * 0.022;
    let mut mesh = turned(&[ring(trunk_m, -0.6, BARK), ring(trunk_m * 0.8, 0.35 * height_m, BARK)], 6, place);
    const SKIRTS: u32 = 4;
    for skirt in 0..SKIRTS {
        let up = f64::from(skirt) / f64::from(SKIRTS);
        let (base_m, top_m) =
            (height_m * (0.14 + 0.66 * up), height_m * (0.44 + 0.56 * (up + 0.25).min(1.0)));
        let radius_m = height_m * 0.21 * (1.0 - 0.72 * up);
        mesh.append(&turned(
            &[
                ring(radius_m * 0.15, base_m + 0.3 * radius_m, inside),
                ring(radius_m, base_m, tips),
                ring(0.0, top_m, tips * 1.1),
            ],
            8,
            place,
        ));
    }
    mesh
}
