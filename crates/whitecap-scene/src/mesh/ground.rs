//! How high the solid ground is under a place.

use glam::{DVec2, DVec3};

/// The height of the highest surface of some triangles, in a regular grid.
///
/// Between grid points heights are joined bilinearly. Points that no triangle covers lie at [`Self::NOWHERE_M`] in
/// [`heights_m`](Self::heights_m); a place next to one has no ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    bounds: [DVec2; 2],
    resolution: usize,
    heights_m: Vec<f32>,
}

impl Ground {
    /// The most grid points along a side.
    pub const MAX_RESOLUTION: usize = 1024;

    /// The height that a grid point has where there is no ground, metres: deeper than any sea.
    pub const NOWHERE_M: f32 = -20_000.0;

    /// Looks at triangles from above: the grid has `resolution` points (2 to [`Self::MAX_RESOLUTION`], brought into
    /// that range) along each side of the rectangle that encloses them. Triangles that stand upright add nothing.
    ///
    /// `None` if no triangle can be seen from above, or one has a corner that is infinite or not a number.
    pub fn new(triangles: impl Iterator<Item = [DVec3; 3]>, resolution: usize) -> Option<Self> {
        let triangles: Vec<[DVec3; 3]> = triangles.collect();
        let places = || triangles.iter().flatten();
        if !places().all(|place| place.is_finite()) {
            return None;
        }
        let low = places().copied().reduce(DVec3::min)?;
        let high = places().copied().reduce(DVec3::max)?;
        let flat = |place: DVec3| DVec2::new(place.x, place.z);
        let bounds = [flat(low), flat(high)];
        if !(bounds[1] - bounds[0]).cmpgt(DVec2::ZERO).all() {
            return None;
        }
        let resolution = resolution.clamp(2, Self::MAX_RESOLUTION);
        let heights_m = vec![Self::NOWHERE_M; resolution * resolution];
        let mut ground = Ground { bounds, resolution, heights_m };
        for triangle in &triangles {
            ground.raise(triangle);
        }
        ground.heights_m.iter().any(|height| *height > Self::NOWHERE_M).then_some(ground)
    }

    /// The height of the ground at a place, `x` east and `z` south, metres. `None` where there is none.
    pub fn height_m(&self, x: f64, z: f64) -> Option<f64> {
        let place = DVec2::new(x, z);
        if !(place.cmpge(self.bounds[0]) & place.cmple(self.bounds[1])).all() {
            return None;
        }
        let in_grid = (place - self.bounds[0]) / self.cell_m();
        let last = (self.resolution - 2) as f64;
        let corner = in_grid.floor().clamp(DVec2::ZERO, DVec2::splat(last));
        let within = in_grid - corner;
        let index = corner.y as usize * self.resolution + corner.x as usize;
        let row = |first: usize| {
            let [west, east] = [self.heights_m[first], self.heights_m[first + 1]];
            let covered = west > Self::NOWHERE_M && east > Self::NOWHERE_M;
            covered.then(|| f64::from(west) * (1.0 - within.x) + f64::from(east) * within.x)
        };
        let (north, south) = (row(index)?, row(index + self.resolution)?);
        Some(north * (1.0 - within.y) + south * within.y)
    }

    /// How deep the ground is below sea level at a place, metres; negative on land. `None` where there is none.
    pub fn depth_m(&self, x: f64, z: f64) -> Option<f64> {
        self.height_m(x, z).map(|height_m| -height_m)
    }

    /// The north-western and the south-eastern corner of the grid: `.x` east, `.y` south, metres.
    pub fn bounds(&self) -> [DVec2; 2] {
        self.bounds
    }

    /// Grid points along each side.
    pub fn resolution(&self) -> usize {
        self.resolution
    }

    /// From one grid point to the next: `.x` eastwards, `.y` southwards, metres.
    pub fn cell_m(&self) -> DVec2 {
        (self.bounds[1] - self.bounds[0]) / (self.resolution - 1) as f64
    }

    /// The heights of all grid points, metres: rows from north to south, each from west to east. The outermost
    /// points lie on [`bounds`](Self::bounds).
    pub fn heights_m(&self) -> &[f32] {
        &self.heights_m
    }

    /// Raises the grid points that this triangle covers to it.
    fn raise(&mut self, triangle: &[DVec3; 3]) {
        let cell_m = self.cell_m();
        let in_grid = triangle.map(|corner| (DVec2::new(corner.x, corner.z) - self.bounds[0]) / cell_m);
        let [a, b, c] = in_grid;
        let area = (b - a).perp_dot(c - a);
        if area.abs() < 1e-12 {
            return;
        }
        // Rounding must not leave a gap between neighbours or along the outer edge.
        let tolerance = 1e-7;
        let last = (self.resolution - 1) as f64;
        let first = (a.min(b).min(c) - tolerance).ceil().clamp(DVec2::ZERO, DVec2::splat(last));
        let end = (a.max(b).max(c) + tolerance).floor().clamp(DVec2::ZERO, DVec2::splat(last));
        for row in first.y as usize..=end.y as usize {
            for column in first.x as usize..=end.x as usize {
                let point = DVec2::new(column as f64, row as f64);
                let of_b = (point - a).perp_dot(c - a) / area;
                let of_c = (b - a).perp_dot(point - a) / area;
                if of_b < -tolerance || of_c < -tolerance || of_b + of_c > 1.0 + tolerance {
                    continue;
                }
                let rise = of_b * (triangle[1].y - triangle[0].y) + of_c * (triangle[2].y - triangle[0].y);
                let height_m = (triangle[0].y + rise) as f32;
                let here = &mut self.heights_m[row * self.resolution + column];
                *here = here.max(height_m);
            }
        }
    }
}
