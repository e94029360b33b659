//! A grid that always lies before the camera (Johanson, *Real-time water rendering: introducing the projected
//! grid concept*, Lund 2004).
//!
//! A regular grid in the picture plane of a *projector*, thrown onto the level of the sea: near the viewer its
//! cells are small, at the horizon large, and wherever one looks they cover all the water that can be seen.
//!
//! | the text's word | here |
//! | --- | --- |
//! | S_base | the level y = 0 |
//! | S_upper, S_lower | y = ±`slab_m`, the levels that no wave passes |
//! | V_displaceable | the slab between the two |
//! | V_cam | the camera's frustum, its far plane brought to `far_m` |
//! | M_range | what part of the projector's picture the water fills |
//!
//! # Steps
//!
//! 1. The frustum's corners and edges are cut with the slab (`hull.rs`); without a cut there is no water to see.
//! 2. A projector is placed and aimed (`projector.rs`).
//! 3. The cuts are dropped onto S_base and seen by the projector: their bounds are M_range.
//! 4. The grid's four corners are lines of the projector cut with S_base, in homogeneous coordinates. Every other
//!    vertex is bilinear between them, and divided by w.
//!
//! Coordinates are those of the sea as the eye stands over it: x and z from the eye, y from the level. They are
//! f64 and hold at any distance from the world's origin.

mod hull;
mod projector;
#[cfg(test)]
mod tests;

use glam::{DMat4, DVec2, DVec3, DVec4, Mat4};
use hull::{Frustum, visible_hull};
use projector::Projector;

/// What a grid is laid for.
#[derive(Debug, Clone, Copy)]
pub struct GridRequest {
    /// Clip space (depth 0 to 1 in either sense, reaching to infinity or not) from the world's axes centred on
    /// the eye.
    pub clip_from_eye_world: Mat4,
    /// How high the eye is over the level, metres; negative under water.
    pub eye_height_m: f64,
    /// Half the thickness of the slab that the surface keeps to, metres, at least 0.
    pub slab_m: f64,
    /// How far ahead water is drawn, metres, whatever the view's own far plane is.
    pub far_m: f64,
    /// The projector keeps so far over the slab, metres, above 0.
    pub elevation_m: f64,
}

/// A grid over all the water that one view sees.
#[derive(Debug, Clone, Copy)]
pub struct ProjectedGrid {
    corners: [DVec4; 4],
    projector: Projector,
    range: Range,
}

/// The part of the projector's picture that holds water, in its normalised device coordinates.
#[derive(Debug, Clone, Copy)]
struct Range {
    min: DVec2,
    size: DVec2,
}

impl Range {
    /// What encloses all `points` of the level. A range has a size, however thin the water is.
    fn of(projector: &Projector, points: &[DVec3]) -> Range {
        let (mut min, mut max) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for point in points {
            let seen = projector.project(DVec2::new(point.x, point.z));
            (min, max) = (min.min(seen), max.max(seen));
        }
        Range { min, size: (max - min).max(DVec2::splat(1e-12)) }
    }

    /// M_range: from 0..1 along both axes into the range.
    fn matrix(&self) -> DMat4 {
        let mut matrix = DMat4::from_scale(self.size.extend(1.0));
        matrix.w_axis = self.min.extend(0.0).extend(1.0);
        matrix
    }
}

impl ProjectedGrid {
    /// The grid for a view, or `None` if it sees no water.
    pub fn new(request: &GridRequest) -> Option<ProjectedGrid> {
        let frustum = Frustum::new(request)?;
        let hull = visible_hull(&frustum, request.slab_m);
        if hull.is_empty() {
            return None;
        }
        let projector = Projector::new(request, &frustum, &hull);
        let range = Range::of(&projector, &hull);
        let world_from_grid = projector.clip_from_sea().inverse() * range.matrix();
        let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)]
            .map(|(u, v)| corner_on_level(&world_from_grid, u, v));
        corners.iter().all(|corner| corner.is_finite() && corner.w > 0.0).then_some(ProjectedGrid {
            corners,
            projector,
            range,
        })
    }

    /// The corners at (u, v) = (0, 0), (1, 0), (0, 1) and (1, 1) in homogeneous coordinates: x and z over w are
    /// metres east and south of the eye, y is 0. v = 0 is the near side; w is above 0.
    pub fn corners(&self) -> [DVec4; 4] {
        self.corners
    }

    /// The point of the level at (u, v), each from 0 to 1: metres east and south of the eye.
    pub fn point(&self, u: f64, v: f64) -> DVec2 {
        let [c00, c10, c01, c11] = self.corners;
        // Weights that are exact at both ends, since w almost vanishes at the far one.
        let near = (1.0 - u) * c00 + u * c10;
        let far = (1.0 - u) * c01 + u * c11;
        let point = (1.0 - v) * near + v * far;
        DVec2::new(point.x, point.z) / point.w
    }

    /// Where in the grid a point of the level lies: within 0..=1 along both axes if the grid covers it. `None`
    /// if it is not before the projector.
    pub fn place_of(&self, from_eye_m: DVec2) -> Option<DVec2> {
        (self.projector.depth(from_eye_m) > 0.0)
            .then(|| (self.projector.project(from_eye_m) - self.range.min) / self.range.size)
    }
}

/// Where the projector's line through (u, v) meets the level, without dividing by w. Any two depths are points
/// of that line; the text takes ±1, here 0 and 1, since the projector's own depth is free.
fn corner_on_level(world_from_grid: &DMat4, u: f64, v: f64) -> DVec4 {
    let q0 = *world_from_grid * DVec4::new(u, v, 0.0, 1.0);
    let q1 = *world_from_grid * DVec4::new(u, v, 1.0, 1.0);
    let t = -q0.y / (q1.y - q0.y);
    let mut corner = q0 + t * (q1 - q0);
    corner.y = 0.0;
    corner
}
