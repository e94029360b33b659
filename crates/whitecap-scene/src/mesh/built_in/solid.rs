//! Round solids: bodies of revolution and ellipsoids.

use std::f64::consts::TAU;

use glam::{DAffine3, DVec2, DVec3, Vec3};

use super::Mesh;

/// A ring of a body of revolution.
#[derive(Clone, Copy)]
pub(super) struct Ring {
    /// Its radius, metres; 0 is a tip.
    pub(super) radius_m: f64,
    /// Its height on the axis, metres.
    pub(super) y_m: f64,
    /// Its colour.
    pub(super) color: Vec3,
}

/// What a profile makes when it is turned about the y axis, `sides` corners around. `profile` runs upwards. Each
/// stretch between two rings is as smooth around as it can be, with an edge to the next one.
pub(super) fn turned(profile: &[Ring], sides: u32, place: DAffine3) -> Mesh {
    let mut mesh = Mesh::default();
    for pair in profile.windows(2) {
        let [low, high] = [pair[0], pair[1]];
        // Outwards and square to the profile.
        let normal = DVec2::new(high.y_m - low.y_m, low.radius_m - high.radius_m);
        let first = mesh.positions.len() as u32;
        for ring in [low, high] {
            for side in 0..sides {
                let around = DVec2::from_angle(f64::from(side) / f64::from(sides) * TAU);
                let at = |r: f64, y: f64| DVec3::new(r * around.x, y, r * around.y);
                mesh.push(
                    place.transform_point3(at(ring.radius_m, ring.y_m)),
                    place.transform_vector3(at(normal.x, normal.y)),
                    ring.color,
                );
            }
        }
        for side in 0..sides {
            let next = (side + 1) % sides;
            let [a, b] = [first + side, first + next];
            let [c, d] = [a + sides, b + sides];
            if low.radius_m > 0.0 {
                mesh.indices.extend([a, d, b]);
            }
            if high.radius_m > 0.0 {
                mesh.indices.extend([a, c, d]);
            }
        }
    }
    mesh
}

/// An ellipsoid: a unit sphere seen through `place`, with `sides` corners around and half as many rings.
pub(super) fn ellipsoid(place: DAffine3, sides: u32, color: Vec3) -> Mesh {
    let rings = sides / 2;
    let normal_from_sphere = place.matrix3.inverse().transpose();
    let mut mesh = Mesh::default();
    for ring in 0..=rings {
        let (sin, cos) = (f64::from(ring) / f64::from(rings) * TAU / 2.0).sin_cos();
        for side in 0..sides {
            let around = DVec2::from_angle(f64::from(side) / f64::from(sides) * TAU);
            let on_sphere = DVec3::new(sin * around.x, -cos, sin * around.y);
            mesh.push(place.transform_point3(on_sphere), normal_from_sphere * on_sphere, color);
        }
    }
    for ring in 0..rings {
        for side in 0..sides {
            let next = (side + 1) % sides;
            let [a, b] = [ring * sides + side, ring * sides + next];
            let [c, d] = [a + sides, b + sides];
            if ring > 0 {
                mesh.indices.extend([a, d, b]);
            }
            if ring + 1 < rings {
                mesh.indices.extend([a, c, d]);
            }
        }
    }
    mesh
}
