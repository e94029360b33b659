//! A square of equal cells.

/// Vertices and triangles of a square that reaches from −0.5 to 0.5 (east, south).
pub struct SquareGrid {
    /// Places of the vertices.
    pub vertices: Vec<[f32; 2]>,
    /// Triangles, row by row, counter-clockwise from above.
    pub indices: Vec<u32>,
}

impl SquareGrid {
    /// A square of `cells`² squares.
    pub fn new(cells: u32) -> SquareGrid {
        let place = |i: u32| (f64::from(i) / f64::from(cells) - 0.5) as f32;
        let vertices = (0..=cells).flat_map(|z| (0..=cells).map(move |x| [place(x), place(z)])).collect();
        let side = cells + 1;
        let indices = (0..cells)
            .flat_map(|z| (0..cells).map(move |x| z * side + x))
            .flat_map(|a| {
                let (b, c, d) = (a + 1, a + side, a + side + 1);
                [a, c, b, b, c, d]
            })
            .collect();
        SquareGrid { vertices, indices }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec2;

    #[test]
    fn triangles_cover_the_square_once_and_face_up() {
        for cells in [1, 2, 7] {
            let grid = SquareGrid::new(cells);
            let corners =
                |triangle: &[u32]| [0, 1, 2].map(|i| Vec2::from(grid.vertices[triangle[i] as usize]));
            let areas = grid.indices.chunks(3).map(|triangle| {
                let [a, b, c] = corners(triangle);
                // South is down on a map: counter-clockwise there has a negative product.
                -0.5 * (b - a).perp_dot(c - a)
            });
            let one = 0.5 / (cells * cells) as f32;
            assert!(areas.clone().all(|area| (area - one).abs() < 1e-6));
            assert!((areas.sum::<f32>() - 1.0).abs() < 1e-5);
            assert_eq!(grid.vertices.first(), Some(&[-0.5, -0.5]));
            assert_eq!(grid.vertices.last(), Some(&[0.5, 0.5]));
        }
    }
}
