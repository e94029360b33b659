//! The bump map's frame on the wave: CPU twins of `normals.wesl`.

use glam::{Mat3, Vec2, Vec3};

/// The text's "three normalized vectors x, y and z" for slopes (∂h/∂x, ∂h/∂z), as columns. They are
/// not orthogonal in general, and each is normalised by itself, as the text insists.
pub fn bump_frame(slope: Vec2) -> Mat3 {
    Mat3::from_cols(
        Vec3::new(1.0, slope.x, 0.0).normalize(),
        Vec3::new(-slope.x, 1.0, -slope.y).normalize(),
        Vec3::new(0.0, slope.y, 1.0).normalize(),
    )
}

/// A normal of the bump map, which needs no frame where the sea is flat, on the wave.
pub fn world_from_bump(frame: Mat3, bump: Vec3) -> Vec3 {
    frame * bump
}
