//! The water that a view can see: the frustum cut with the slab.

use super::GridRequest;
use glam::{DVec2, DVec3, DVec4, Vec4Swizzles};

/// A frustum's corners in the sea's coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frustum {
    /// On the near plane: lower left, lower right, upper left, upper right.
    pub(super) near: [DVec3; 4],
    /// On the far plane, in the same order.
    pub(super) far: [DVec3; 4],
}

/// Lower left, lower right, upper left, upper right in clip space.
const CORNERS: [DVec2; 4] =
    [DVec2::new(-1.0, -1.0), DVec2::new(1.0, -1.0), DVec2::new(-1.0, 1.0), DVec2::new(1.0, 1.0)];

/// A homogeneous point this small in w against its length is infinitely far away.
const INFINITE: f64 = 1e-9;

impl Frustum {
    /// The view's frustum; `None` if the matrix is none of a view.
    ///
    /// A depth that reaches to infinity has no far corners, and one that reaches far has hardly any in f32. So the
    /// frustum is built from the rays through its near corners and cut off at `far_m`, whatever the view's own far
    /// plane is: water that is covered and not seen costs nothing.
    pub(super) fn new(request: &GridRequest) -> Option<Frustum> {
        let clip_from_eye_world = request.clip_from_eye_world.as_dmat4();
        let eye_world_from_clip = clip_from_eye_world.inverse();
        let at = |corner: DVec2, depth: f64| eye_world_from_clip * corner.extend(depth).extend(1.0);
        let finite = |p: DVec4| (p.w.abs() > INFINITE * p.xyz().length()).then(|| p.xyz() / p.w);
        let ends: [[Option<DVec3>; 2]; 4] =
            CORNERS.map(|corner| [finite(at(corner, 0.0)), finite(at(corner, 1.0))]);

        // Depth grows or falls with distance: the near plane is the one nearer to the eye.
        let distance = |end: usize| ends[0][end].map_or(f64::INFINITY, |p: DVec3| p.length());
        let near_end = usize::from(distance(1) < distance(0));
        let mut near = [DVec3::ZERO; 4];
        for (corner, ends) in near.iter_mut().zip(&ends) {
            *corner = ends[near_end]?;
        }
        let normal = (near[1] - near[0]).cross(near[2] - near[0]).normalize_or_zero();
        let near_depth = normal.dot(near[0]).abs();
        // All rays come from the eye, but for a view without perspective.
        let perspective = clip_from_eye_world.row(3).xyz() != DVec3::ZERO;
        let mut far = near;
        for (corner, ends) in far.iter_mut().zip(&ends) {
            let along = if perspective { *corner } else { ends[1 - near_end]? - *corner };
            *corner += along / normal.dot(along).abs() * (request.far_m - near_depth).max(near_depth);
        }
        let over_level = DVec3::Y * request.eye_height_m;
        let frustum = Frustum {
            near: near.map(|corner| corner + over_level),
            far: far.map(|corner| corner + over_level),
        };
        frustum.near.iter().chain(&frustum.far).all(|corner| corner.is_finite()).then_some(frustum)
    }

    /// Unit vector along the view.
    pub(super) fn forward(&self) -> DVec3 {
        let [a, b, c, _] = self.near;
        let normal = (b - a).cross(c - a).normalize_or(DVec3::NEG_Z);
        if normal.dot(self.far[0] - a) < 0.0 { -normal } else { normal }
    }

    /// Unit vector to the upper edge of the picture.
    pub(super) fn up(&self) -> DVec3 {
        (self.near[2] - self.near[0]).normalize_or(DVec3::Y)
    }

    /// The ends of the twelve edges.
    fn edges(&self) -> [[DVec3; 2]; 12] {
        let Frustum { near: n, far: f } = self;
        let around = [[0, 1], [1, 3], [3, 2], [2, 0]];
        std::array::from_fn(|i| match (i / 4, i % 4) {
            (0, side) => around[side].map(|corner| n[corner]),
            (1, side) => around[side].map(|corner| f[corner]),
            (_, corner) => [n[corner], f[corner]],
        })
    }
}

/// The corners of V_cam ∩ V_displaceable, dropped onto the level: the cuts of the frustum's edges with both
/// bounds, and the frustum's corners that lie between them. What is visible of a surface that is displaced
/// upright lies over their convex hull.
pub(super) fn visible_hull(frustum: &Frustum, slab_m: f64) -> Vec<DVec3> {
    let mut points = Vec::with_capacity(16);
    for [from, to] in frustum.edges() {
        for bound_m in [slab_m, -slab_m] {
            let (start, end) = (from.y - bound_m, to.y - bound_m);
            if start * end < 0.0 {
                points.push(from + (to - from) * (start / (start - end)));
            }
        }
    }
    let corners = frustum.near.iter().chain(&frustum.far);
    points.extend(corners.filter(|corner| corner.y.abs() <= slab_m));
    for point in &mut points {
        point.y = 0.0;
    }
    points
}
