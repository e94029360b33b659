//! Ground whose height is a formula, as rings of triangles around a middle.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3, Vec3};

use super::Mesh;

/// Over what distance slopes are measured, metres.
const SLOPE_STEP_M: f64 = 0.25;

/// A place on the ground.
pub(super) struct Spot {
    /// Where: `.x` east, `.y` south, metres.
    pub(super) place: DVec2,
    /// Its height, metres.
    pub(super) height_m: f64,
    /// How much it rises per metre along its steepest line.
    pub(super) slope: f64,
}

/// A mesh over a disc: a middle, and `radii_m` from the inside out with `sectors` corners each.
pub(super) fn rings(
    radii_m: &[f64],
    sectors: u32,
    height_m: impl Fn(DVec2) -> f64,
    color: impl Fn(&Spot) -> Vec3,
) -> Mesh {
    let mut mesh = Mesh::default();
    let mut push = |place: DVec2| {
        let rise = |step: DVec2| (height_m(place + step) - height_m(place - step)) / (2.0 * SLOPE_STEP_M);
        let slope = DVec2::new(rise(DVec2::X * SLOPE_STEP_M), rise(DVec2::Y * SLOPE_STEP_M));
        let spot = Spot { place, height_m: height_m(place), slope: slope.length() };
        mesh.push(
            DVec3::new(place.x, spot.height_m, place.y),
            DVec3::new(-slope.x, 1.0, -slope.y),
            color(&spot),
        );
    };
    push(DVec2::ZERO);
    for (ring, radius_m) in radii_m.iter().enumerate() {
        for sector in 0..sectors {
            // Every other ring is turned by half a sector, which makes the triangles nearly equilateral.
            let turn = (f64::from(sector) + 0.5 * (ring % 2) as f64) / f64::from(sectors);
            push(DVec2::from_angle(turn * TAU) * *radius_m);
        }
    }

    let corner = |ring: u32, sector: u32| 1 + ring * sectors + sector % sectors;
    for sector in 0..sectors {
        mesh.indices.extend([0, corner(0, sector + 1), corner(0, sector)]);
    }
    for ring in 1..radii_m.len() as u32 {
        for sector in 0..sectors {
            let [near, next] = [corner(ring - 1, sector), corner(ring - 1, sector + 1)];
            let [far, far_next] = [corner(ring, sector), corner(ring, sector + 1)];
            if ring % 2 == 1 {
                // The outer ring is the turned one.
                mesh.indices.extend([near, next, far, next, far_next, far]);
            } else {
                mesh.indices.extend([near, far_next, far, near, next, far_next]);
            }
        }
    }
    mesh
}

/// The colours that ground has, as a display shows them.
pub(super) mod colors {
    use glam::Vec3;

    pub(crate) const SAND: Vec3 = Vec3::new(0.85, 0.77, 0.60);
    pub(crate) const WET_SAND: Vec3 = Vec3::new(0.63, 0.55, 0.41);
    pub(crate) const PEBBLES: Vec3 = Vec3::new(0.38, 0.36, 0.33);
    pub(crate) const WEED: Vec3 = Vec3::new(0.24, 0.31, 0.17);
    pub(crate) const GRASS: Vec3 = Vec3::new(0.33, 0.46, 0.19);
    pub(crate) const DRY_GRASS: Vec3 = Vec3::new(0.52, 0.53, 0.27);
    pub(crate) const ROCK: Vec3 = Vec3::new(0.47, 0.44, 0.40);
}
