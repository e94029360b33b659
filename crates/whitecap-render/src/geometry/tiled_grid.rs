//! A square grid round the viewer and an apron that carries it to the horizon.
//!
//! The grid's vertices lie on the samples of the tile, so it must move by whole cells. The apron is a
//! set of square rings, each wider and coarser than the last, joined edge to edge: every vertex on a
//! border belongs to both sides, so no crack can open.

/// Vertices and triangles in cells from the grid's centre (east, south).
pub struct TiledGrid {
    /// Places of the vertices.
    pub vertices: Vec<[f32; 2]>,
    /// Triangles, nearest first, counter-clockwise from above.
    pub indices: Vec<u32>,
}

/// Segments along a side never become fewer than this.
const MIN_SEGMENTS: u32 = 16;

impl TiledGrid {
    /// How much wider each ring of the apron is than the one before, where nothing asks for less.
    pub const RING_GROWTH: f32 = 1.5;

    /// A grid of `cells`² squares with an apron out to at least `reach` cells from the centre.
    ///
    /// `cells` must be even, so that the centre is a vertex.
    pub fn new(cells: u32, reach: f32) -> TiledGrid {
        let mut grid = TiledGrid { vertices: Vec::new(), indices: Vec::new() };
        grid.add_square(cells);
        grid.add_apron(grid.border_of_square(cells), reach, Self::RING_GROWTH);
        grid
    }

    /// A square mesh of your own with an apron out to at least `reach`, whose rings are each `growth` times as wide as the one
    /// before: on a round earth their chords lower the horizon by up to (growth − 1)²/8 of its dip. `border` runs once round the square,
    /// whose middle is the origin, from its north-west corner eastwards; each side has as many segments.
    ///
    /// # Panics
    ///
    /// If an index of the border is out of range.
    pub fn around(
        vertices: Vec<[f32; 2]>,
        indices: Vec<u32>,
        border: Vec<u32>,
        reach: f32,
        growth: f32,
    ) -> TiledGrid {
        let mut grid = TiledGrid { vertices, indices };
        grid.add_apron(border, reach, growth);
        grid
    }

    fn add_apron(&mut self, border: Vec<u32>, reach: f32, growth: f32) {
        let corner = border.first().map_or([0.0; 2], |&corner| self.vertices[corner as usize]);
        let mut half = corner[0].abs();
        let mut segments = border.len() as u32 / 4;
        let mut ring = border;
        while half > 0.0 && half < reach {
            half *= growth;
            // Halving as the rings widen keeps their squares square.
            let coarser = if segments.is_multiple_of(2) && segments / 2 >= MIN_SEGMENTS {
                segments / 2
            } else {
                segments
            };
            let next = self.add_ring(half, coarser);
            self.join(&ring, segments, &next, coarser);
            (ring, segments) = (next, coarser);
        }
    }

    fn add_square(&mut self, cells: u32) {
        let half = (cells / 2) as i32;
        let side = cells + 1;
        for z in -half..=half {
            for x in -half..=half {
                self.vertices.push([x as f32, z as f32]);
            }
        }
        let mut squares: Vec<(i32, i32)> =
            (-half..half).flat_map(|z| (-half..half).map(move |x| (x, z))).collect();
        squares.sort_by_key(|&(x, z)| (2 * x + 1).abs().max((2 * z + 1).abs()));
        for (x, z) in squares {
            let a = (z + half) as u32 * side + (x + half) as u32;
            let (b, c, d) = (a + 1, a + side, a + side + 1);
            self.indices.extend([a, c, b, b, c, d]);
        }
    }

    /// Indices round the square's border, from its north-west corner eastwards.
    fn border_of_square(&self, cells: u32) -> Vec<u32> {
        let side = cells + 1;
        let north = 0..cells;
        let east = (0..cells).map(|i| i * side + cells);
        let south = (0..cells).map(|i| cells * side + cells - i);
        let west = (0..cells).map(|i| (cells - i) * side);
        north.chain(east).chain(south).chain(west).collect()
    }

    fn add_ring(&mut self, half: f32, segments: u32) -> Vec<u32> {
        let first = self.vertices.len() as u32;
        for side in 0..4 {
            for i in 0..segments {
                let along = half * (2.0 * i as f32 / segments as f32 - 1.0);
                self.vertices.push(match side {
                    0 => [along, -half],
                    1 => [half, along],
                    2 => [-along, half],
                    _ => [-half, -along],
                });
            }
        }
        (first..first + 4 * segments).collect()
    }

    /// Triangles between two rings, of which the outer has as many segments or half as many.
    fn join(&mut self, inner: &[u32], inner_segments: u32, outer: &[u32], outer_segments: u32) {
        let at = |ring: &[u32], i: u32| ring[(i as usize) % ring.len()];
        let halves = inner_segments / outer_segments == 2;
        for i in 0..4 * outer_segments {
            let (o0, o1) = (at(outer, i), at(outer, i + 1));
            if halves {
                let (a, b, c) = (at(inner, 2 * i), at(inner, 2 * i + 1), at(inner, 2 * i + 2));
                self.indices.extend([o0, a, b, o0, b, o1, o1, b, c]);
            } else {
                let (a, b) = (at(inner, i), at(inner, i + 1));
                self.indices.extend([o0, a, b, o0, b, o1]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    /// Every inner edge is shared by exactly two triangles that run along it in opposite directions;
    /// only the outermost border is open. So there is no hole, no crack and no overlap.
    #[test]
    fn the_surface_is_closed_to_its_outer_border() {
        for (cells, reach) in [(8, 100.0), (64, 5_000.0), (256, 1e6)] {
            let grid = TiledGrid::new(cells, reach);
            let mut edges: HashMap<(u32, u32), i32> = HashMap::new();
            for t in grid.indices.chunks(3) {
                for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                    *edges.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
                    assert!(edges[&(a.min(b), a.max(b))].abs() <= 1);
                }
            }
            let open: Vec<_> = edges.iter().filter(|&(_, &n)| n != 0).map(|(e, _)| *e).collect();
            let half = grid.vertices.iter().map(|v| v[0]).fold(0.0, f32::max);
            assert!(half >= reach);
            for (a, b) in open {
                for v in [a, b] {
                    let [x, z] = grid.vertices[v as usize];
                    assert_eq!(x.abs().max(z.abs()), half, "an edge is open inside the mesh");
                }
            }
        }
    }

    #[test]
    fn triangles_face_up_and_cover_the_area_once() {
        let grid = TiledGrid::new(16, 100.0);
        let mut area = 0.0;
        for t in grid.indices.chunks(3) {
            let [a, b, c] = [t[0], t[1], t[2]].map(|i| grid.vertices[i as usize]);
            // x east, z south: seen from above, counter-clockwise has a negative cross product.
            let cross = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            assert!(cross < 0.0);
            area -= 0.5 * f64::from(cross);
        }
        let half = f64::from(grid.vertices.iter().map(|v| v[0]).fold(0.0, f32::max));
        assert!((area / (4.0 * half * half) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn the_near_comes_first() {
        let grid = TiledGrid::new(64, 64.0);
        let far = |i: usize| {
            let [x, z] = grid.vertices[grid.indices[i] as usize];
            x.abs().max(z.abs())
        };
        assert!(far(0) <= 1.0 && far(grid.indices.len() - 1) > 32.0);
    }
}
