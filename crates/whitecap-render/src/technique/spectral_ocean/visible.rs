//! Which parts of the mesh a view can see, by bearing alone.

use crate::geometry::NestedGrid;
use glam::{Mat4, Vec2, Vec3, Vec4Swizzles};
use std::f32::consts::{FRAC_PI_4, FRAC_PI_8, PI};
use std::ops::Range;

/// Beyond this to either side of the view's middle its edges say nothing any more.
const WIDEST_RAD: f32 = 0.45 * PI;

/// The bearings that a view spans.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Wedge {
    /// All round: it looks steeply up or down, or has no single eye.
    All,
    /// So far to either side of a direction (east, south).
    Around { middle: Vec2, half_rad: f32 },
}

impl Wedge {
    /// Of a view, whatever its depth.
    pub(super) fn of(clip_from_eye_world: Mat4) -> Wedge {
        if clip_from_eye_world.row(3).xyz() == Vec3::ZERO {
            return Wedge::All;
        }
        let eye_world_from_clip = clip_from_eye_world.inverse();
        // Two depths that are finite in either sense.
        let ray = |x: f32, y: f32| {
            let [a, b] = [0.25, 0.75].map(|depth| eye_world_from_clip.project_point3(Vec3::new(x, y, depth)));
            // Both lie on the ray from the eye, which is the origin, before it.
            let along = if a.length_squared() > b.length_squared() { a } else { b };
            Vec2::new(along.x, along.z) / along.length()
        };
        let middle = ray(0.0, 0.0);
        if !middle.is_finite() || middle.length() < 1e-3 {
            return Wedge::All;
        }
        let corners = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)].map(|(x, y)| ray(x, y));
        let angles = corners.map(|corner| middle.angle_to(corner).abs());
        let half_rad = angles.into_iter().fold(0.0, f32::max);
        // Also where a corner looks straight down, or is no number.
        if half_rad < WIDEST_RAD && corners.iter().all(|corner| corner.length() > 1e-3) {
            Wedge::Around { middle, half_rad }
        } else {
            Wedge::All
        }
    }

    /// The indices of the grid's parts in these bearings, the nearest level first; neighbours are joined. `sway_m` is
    /// how far waves carry a vertex, `cell_m` the first level's cell.
    pub(super) fn visible(&self, grid: &NestedGrid, cell_m: f64, sway_m: f64) -> Vec<Range<u32>> {
        let mut seen: Vec<Range<u32>> = Vec::new();
        for part in &grid.parts {
            // Triangles reach over the edge of their octant by a cell or two, and levels stand off the eye by half one.
            let inner_cells = f64::from(grid.half_cells()) / 2.0;
            let inner_m = inner_cells * cell_m * f64::from(part.level).exp2();
            let margin = (3.0 / inner_cells + sway_m / inner_m) as f32;
            if part.level == 0 || self.meets(part.octant, margin) {
                match seen.last_mut() {
                    Some(last) if last.end == part.indices.start => last.end = part.indices.end,
                    _ => seen.push(part.indices.clone()),
                }
            }
        }
        seen
    }

    fn meets(&self, octant: u32, margin_rad: f32) -> bool {
        let Wedge::Around { middle, half_rad } = *self else { return true };
        let bearing = Vec2::from_angle((octant as f32 + 0.5) * FRAC_PI_4);
        middle.angle_to(bearing).abs() <= half_rad + FRAC_PI_8 + margin_rad
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::View;
    use whitecap_scene::Camera;

    fn seen(look_at_m: [f64; 3], grid: &NestedGrid) -> Vec<Range<u32>> {
        let camera = Camera { position_m: [0.0, 5.0, 0.0], look_at_m, vertical_fov_deg: 45.0 };
        Wedge::of(View::of_camera(&camera, [1280, 720]).clip_from_eye_world()).visible(grid, 0.125, 2.0)
    }

    /// Every vertex on the screen belongs to a part that is drawn, and most of the others do not.
    #[test]
    fn a_level_view_sees_its_own_bearings() {
        let grid = NestedGrid::new(64, 8, 1e4);
        for azimuth in 0..32 {
            let toward = Vec2::from_angle(azimuth as f32 * 0.197);
            let look_at_m = [f64::from(toward.x) * 50.0, 2.0, f64::from(toward.y) * 50.0];
            let parts = seen(look_at_m, &grid);
            let drawn: u32 = parts.iter().map(|part| part.end - part.start).sum();
            assert!((drawn as usize) < 3 * grid.indices.len() / 4, "{drawn} of {}", grid.indices.len());
            for (i, &vertex) in grid.indices.iter().enumerate() {
                let [x, z, _] = grid.vertices[vertex as usize];
                // 36° to either side are in the picture.
                if toward.angle_to(Vec2::new(x, z)).abs() < 0.63 {
                    assert!(parts.iter().any(|part| part.contains(&(i as u32))), "{azimuth}: {x}, {z}");
                }
            }
        }
    }

    #[test]
    fn a_steep_view_sees_all_round() {
        let grid = NestedGrid::new(16, 3, 100.0);
        for look_at_m in [[0.0, 0.0, 0.0], [1.0, 0.0, 1.0], [0.0, 100.0, 0.001]] {
            let all = 0..grid.indices.len() as u32;
            assert_eq!(seen(look_at_m, &grid), [all]);
        }
        assert_eq!(Wedge::of(Mat4::IDENTITY), Wedge::All);
    }
}
