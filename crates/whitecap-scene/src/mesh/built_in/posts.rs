//! The posts of a jetty that lost its planks.

use glam::{DAffine3, DQuat, DVec3, Vec3};

use super::Mesh;
use super::noise::Noise;
use super::solid::{Ring, turned};

/// Posts in each of the two rows.
const IN_ROW: u32 = 5;

/// From post to post along a row, metres.
const SPACING_M: f64 = 2.4;

/// Between the rows, metres.
const WIDTH_M: f64 = 1.8;

const DRY: Vec3 = Vec3::new(0.50, 0.43, 0.34);
const WET: Vec3 = Vec3::new(0.27, 0.22, 0.16);
const ALGAE: Vec3 = Vec3::new(0.20, 0.25, 0.11);
const GRAIN: Vec3 = Vec3::new(0.66, 0.57, 0.44);

/// Two rows of posts that run north, and two posts beside them that lean.
pub(super) fn mesh(seed: u64) -> Mesh {
    let noise = Noise::new(seed, 0x9057);
    let mut mesh = Mesh::default();
    for post in 0..2 * IN_ROW {
        let (row, place) = (f64::from(post % 2) - 0.5, f64::from(post / 2) - 0.5 * f64::from(IN_ROW - 1));
        let shift = |axis: u64| noise.between(8 * u64::from(post) + axis, -1.0, 1.0);
        let foot = DVec3::new(row * WIDTH_M + 0.08 * shift(0), 0.0, place * SPACING_M + 0.12 * shift(1));
        let lean = DQuat::from_rotation_x(0.03 * shift(2)) * DQuat::from_rotation_z(0.03 * shift(3));
        let top_m = 1.35 + 0.15 * shift(4);
        mesh.append(&one(DAffine3::from_rotation_translation(lean, foot), 0.14 + 0.02 * shift(5), top_m));
    }
    for (foot, lean) in [
        (DVec3::new(2.6, 0.0, -2.9), DQuat::from_rotation_z(-0.38) * DQuat::from_rotation_x(0.1)),
        (DVec3::new(-2.2, 0.0, 3.6), DQuat::from_rotation_x(0.27) * DQuat::from_rotation_z(0.12)),
    ] {
        mesh.append(&one(DAffine3::from_rotation_translation(lean, foot), 0.13, 1.2));
    }
    mesh
}

/// A post around the y axis: dry above, dark where waves wet it, green below.
fn one(place: DAffine3, radius_m: f64, top_m: f64) -> Mesh {
    let ring = |radius_m, y_m, color| Ring { radius_m, y_m, color };
    let edge = radius_m * 0.86;
    turned(
        &[
            ring(radius_m * 1.08, -2.9, ALGAE),
            ring(radius_m * 1.04, -0.35, ALGAE),
            ring(radius_m * 1.03, 0.05, WET),
            ring(radius_m, 0.4, DRY),
            ring(radius_m, top_m - 0.04, DRY),
            ring(edge, top_m, GRAIN),
            ring(0.0, top_m + 0.01, GRAIN),
        ],
        10,
        place,
    )
}
