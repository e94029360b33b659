//! The level sea's mesh: squares about the viewer, and rings that reach the horizon.

use crate::geometry::TiledGrid;

/// How far the plane reaches, metres. It is level, so its edge must lie beyond what pixels resolve from any height:
/// from 100 km up it is a ten-thousandth of a radian below the horizon.
const REACH_M: f64 = 1.0e9;

/// Rings of the apron.
const RINGS: i32 = 12;

/// How much wider than the last each ring of [`TiledGrid`] is.
const GRID_GROWTH: f64 = 1.5;

/// How far the squares of the plane lie apart, metres, and how many there are along a side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spacing {
    pub(super) cell_m: f64,
    pub(super) cells: u32,
}

/// The plane of the log's first stage: few, large triangles.
pub(super) const COARSE: Spacing = Spacing { cell_m: 250.0, cells: 2 };

/// The plane that is divided into a grid. A level needs no more: position and texture coordinates are linear.
pub(super) const GRIDDED: Spacing = Spacing { cell_m: 10.0, cells: 16 };

/// Vertices in metres from the centre (east, south).
pub(super) fn plane(spacing: Spacing) -> TiledGrid {
    let half = f64::from(spacing.cells) / 2.0;
    let grid_reach = half * GRID_GROWTH.powi(RINGS);
    let mut grid = TiledGrid::new(spacing.cells, (grid_reach * 0.99) as f32);
    // A level can be stretched freely: each ring is drawn out until the last one lies at the horizon.
    let stretch = (REACH_M / (half * spacing.cell_m)).ln() / (grid_reach / half).ln() - 1.0;
    for vertex in &mut grid.vertices {
        let [x, z] = vertex.map(f64::from);
        let out = (x.abs().max(z.abs()) / half).max(1.0);
        let scale = spacing.cell_m * out.powf(stretch);
        *vertex = [(x * scale) as f32, (z * scale) as f32];
    }
    grid
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_plane_reaches_the_horizon_in_few_triangles() {
        for (spacing, most) in [(COARSE, 300), (GRIDDED, 2_500)] {
            let plane = plane(spacing);
            assert!(plane.indices.len() / 3 <= most, "{}", plane.indices.len() / 3);
            let farthest = plane.vertices.iter().map(|v| v[0]).fold(0.0, f32::max);
            assert!((f64::from(farthest) / REACH_M - 1.0).abs() < 1e-4, "{farthest}");
        }
    }

    #[test]
    fn the_plane_faces_up_and_covers_its_area_once() {
        let plane = plane(GRIDDED);
        let mut area = 0.0;
        for t in plane.indices.chunks(3) {
            let [a, b, c] = [t[0], t[1], t[2]].map(|i| plane.vertices[i as usize].map(f64::from));
            let cross = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            assert!(cross < 0.0);
            area -= 0.5 * cross;
        }
        assert!((area / (4.0 * REACH_M * REACH_M) - 1.0).abs() < 1e-3);
    }
}
