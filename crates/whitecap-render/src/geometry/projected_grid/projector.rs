//! The projector: a camera that always looks down on the water.

use super::GridRequest;
use super::hull::Frustum;
use glam::{DMat4, DVec2, DVec3, DVec4};

/// How far ahead of the camera the second aim lies, metres.
const AIM_AHEAD_M: f64 = 10.0;

/// Below this share the view has no direction over the water: it looks straight up or down.
const UPRIGHT: f64 = 1e-4;

/// What lies behind the projector must come before it by this much more than barely.
const BEFORE: f64 = 1.25;

/// A projector over the eye, `height_m` over the level.
#[derive(Debug, Clone, Copy)]
pub(super) struct Projector {
    pub(super) height_m: f64,
    pub(super) right: DVec3,
    pub(super) up: DVec3,
    pub(super) forward: DVec3,
}

impl Projector {
    /// Places and aims the projector. `hull` are the points of the level that it must see.
    pub(super) fn new(request: &GridRequest, frustum: &Frustum, hull: &[DVec3]) -> Projector {
        let height_m = height_m(request);
        let forward = frustum.forward();
        let ahead = direction_over_water(forward, frustum.up());
        // Over how much water ahead of the projector the two aims lie, blended by |n·forward|. The first is where
        // the view, mirrored if it looks away, meets the level. In |H|·cos it needs no division: where the view
        // runs along the level and meets it nowhere, its weight of 0 is already in it.
        let steepness = forward.y.abs();
        let level = (1.0 - steepness * steepness).max(0.0).sqrt();
        let aim1_weighted_m = request.eye_height_m.abs() * level;
        let aim2_m = AIM_AHEAD_M * level;
        let mut aim_m = aim1_weighted_m + (1.0 - steepness) * aim2_m;
        // Wide views see water that lies behind so aimed a projector. It steepens until all lies before it, and
        // straight down everything does.
        let behind_m = hull.iter().map(|point| -point.dot(ahead)).fold(0.0, f64::max);
        if behind_m > 0.0 {
            aim_m = aim_m.min(height_m * height_m / (BEFORE * behind_m));
        }
        let toward_aim = (aim_m * ahead - height_m * DVec3::Y).normalize_or(DVec3::NEG_Y);
        let right = ahead.cross(DVec3::Y);
        Projector { height_m, right, up: right.cross(toward_aim), forward: toward_aim }
    }

    /// Clip space from the sea's coordinates. M_range undoes any stretching of the picture, so the projection is
    /// the simplest with the camera's lines of sight: x/depth, y/depth, and a depth of 1/depth.
    pub(super) fn clip_from_sea(&self) -> DMat4 {
        let position = DVec3::Y * self.height_m;
        let row = |axis: DVec3| axis.extend(-axis.dot(position));
        let rows = [row(self.right), row(self.up), DVec4::W, row(self.forward)];
        DMat4::from_cols(rows[0], rows[1], rows[2], rows[3]).transpose()
    }

    /// How deep in the picture a point of the level lies; above 0 before the projector.
    pub(super) fn depth(&self, from_eye_m: DVec2) -> f64 {
        self.forward.dot(self.line_to(from_eye_m))
    }

    /// Where in the picture a point of the level before the projector is seen.
    pub(super) fn project(&self, from_eye_m: DVec2) -> DVec2 {
        let line = self.line_to(from_eye_m);
        DVec2::new(self.right.dot(line), self.up.dot(line)) / self.forward.dot(line)
    }

    fn line_to(&self, from_eye_m: DVec2) -> DVec3 {
        DVec3::new(from_eye_m.x, -self.height_m, from_eye_m.y)
    }
}

/// The projector's height over the level: the camera's, but kept over the slab, and mirrored into the air from
/// under water. Heights are counted from S_lower, as in the text.
pub(super) fn height_m(request: &GridRequest) -> f64 {
    let over_lower_m = request.eye_height_m + request.slab_m;
    let lowest_m = request.slab_m + request.elevation_m;
    let push_m = if over_lower_m >= lowest_m {
        0.0
    } else if over_lower_m < 0.0 {
        lowest_m - 2.0 * over_lower_m
    } else {
        lowest_m - over_lower_m
    };
    request.eye_height_m + push_m
}

/// The horizontal direction of the view, unit length. A view straight up or down has none; what is up in its
/// picture, or down, then lies ahead.
fn direction_over_water(forward: DVec3, up: DVec3) -> DVec3 {
    let flat = |v: DVec3| DVec3::new(v.x, 0.0, v.z);
    let along = flat(forward);
    if along.length() > UPRIGHT {
        return along.normalize();
    }
    (flat(up) * -forward.y.signum()).normalize_or(DVec3::NEG_Z)
}
