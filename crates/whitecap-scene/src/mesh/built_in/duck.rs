//! The rubber duck of bathtubs.

use glam::{DAffine3, DQuat, DVec3, Vec3};

use super::Mesh;
use super::implicit::{blend, ellipsoid, rod, surface};
use super::solid;

const YELLOW: Vec3 = Vec3::new(1.0, 0.82, 0.09);
const ORANGE: Vec3 = Vec3::new(0.96, 0.42, 0.06);
const WHITE: Vec3 = Vec3::new(0.97, 0.97, 0.95);
const BLACK: Vec3 = Vec3::new(0.05, 0.05, 0.06);

const HEAD: DVec3 = DVec3::new(0.0, 0.51, -0.17);
const HEAD_RADII: DVec3 = DVec3::new(0.245, 0.24, 0.245);

/// A duck 1 m long, its beak to the north. The lower third of its body is below y = 0.
pub(super) fn mesh() -> Mesh {
    let around = [DVec3::new(-0.5, -0.3, -0.5), DVec3::new(0.5, 0.85, 0.6)];
    let mut mesh = surface(body, around, 0.062, YELLOW);
    // A broad upper bill, and below it a smaller one, open a little.
    mesh.append(&bill(DVec3::new(0.0, 0.478, -0.40), DVec3::new(0.12, 0.036, 0.135), 0.25));
    mesh.append(&bill(DVec3::new(0.0, 0.425, -0.37), DVec3::new(0.088, 0.03, 0.105), -0.05));
    for side in [-1.0, 1.0] {
        // Where the eye sits on the head, and which way it looks.
        let outward = DVec3::new(0.50 * side, 0.30, -0.80).normalize();
        let turn = DQuat::from_rotation_arc(DVec3::Z, outward);
        let mut eye = |radius: f64, bulge: f64, out: f64, color| {
            let scale = DVec3::new(radius, 1.2 * radius, bulge);
            let place = HEAD + outward * HEAD_RADII * out;
            let place = DAffine3::from_scale_rotation_translation(scale, turn, place);
            mesh.append(&solid::ellipsoid(place, 12, color));
        };
        eye(0.062, 0.022, 0.985, WHITE);
        eye(0.042, 0.018, 1.045, BLACK);
    }
    mesh
}

/// The yellow part: a wide body with a full breast, a head, wings that stand out a little, a tail that turns up.
fn body(place: DVec3) -> f64 {
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
    // The sides are alike.
    let half = at(place.x.abs(), place.y, place.z);

    let hull = ellipsoid(place, at(0.0, 0.08, 0.07), at(0.345, 0.27, 0.40));
    let breast = ellipsoid(place, at(0.0, 0.12, -0.16), at(0.27, 0.24, 0.24));
    let tail = rod(place, [at(0.0, 0.20, 0.30), at(0.0, 0.39, 0.475)], 0.15, 0.05);
    let head = ellipsoid(place, HEAD, HEAD_RADII);
    let neck = rod(place, [at(0.0, 0.20, -0.10), at(0.0, 0.42, -0.15)], 0.20, 0.16);
    let wing = blend(
        rod(half, [at(0.275, 0.16, -0.04), at(0.30, 0.18, 0.18)], 0.11, 0.09),
        rod(half, [at(0.30, 0.18, 0.18), at(0.265, 0.26, 0.30)], 0.09, 0.05),
        0.06,
    );

    let body = blend(blend(hull, breast, 0.12), tail, 0.14);
    let body = blend(blend(body, neck, 0.08), head, 0.05);
    let body = blend(body, wing, 0.06);
    // The flat bottom on which it stands when the tub is empty.
    body.max(-0.17 - place.y)
}

/// A bill: an ellipsoid that points ahead of the head, its tip turned up by `turned_up_rad`.
fn bill(center: DVec3, radii: DVec3, turned_up_rad: f64) -> Mesh {
    let turn = DQuat::from_rotation_x(turned_up_rad);
    solid::ellipsoid(DAffine3::from_scale_rotation_translation(radii, turn, center), 16, ORANGE)
}
