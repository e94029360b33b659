//! Square rings of cells that double outwards, with the viewer in the middle and the horizon at the end.
//!
//! Every level is a square of equal cells without its middle, which the finer level before it fills. Its vertices lie
//! on a lattice of the world, a cell apart: when the viewer moves, a level moves by whole cells of its own, so no
//! vertex ever slides along a wave. A level's outermost row belongs to the next one's lattice. That leaves a strip
//! between the two whose width changes by up to a cell either way; it is empty at the narrowest and never folds, and
//! since both sides share their vertices it cannot crack.

use super::TiledGrid;
use std::ops::Range;

/// Vertices and triangles, both in cells of their own level from that level's origin (east, south).
pub struct NestedGrid {
    /// Place and level of the vertices.
    pub vertices: Vec<[f32; 3]>,
    /// Triangles, nearest first within a part, counter-clockwise from above.
    pub indices: Vec<u32>,
    /// The triangles by level and octant, the finest level first.
    pub parts: Vec<Part>,
    cells: u32,
}

/// An eighth of a level's triangles.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Part {
    /// The level.
    pub level: u32,
    /// Which eighth, counted from east over south.
    pub octant: u32,
    /// Its indices.
    pub indices: Range<u32>,
}

impl NestedGrid {
    /// `levels` levels, at least 1, of `cells` cells a side, a multiple of 8; round them an apron of coarse rings out
    /// to at least `reach` cells of the last level, to which it belongs.
    pub fn new(cells: u32, levels: u32, reach: f32) -> NestedGrid {
        let mut builder = Builder { half: (cells / 2) as i32, vertices: Vec::new(), triangles: Vec::new() };
        let mut border = Vec::new();
        for level in 0..levels {
            border = builder.add_level(level, level + 1 == levels, &border);
        }
        builder.add_apron(levels - 1, border, reach);
        builder.finish(cells)
    }

    /// Half the side of a level in its own cells.
    pub fn half_cells(&self) -> u32 {
        self.cells / 2
    }
}

/// Of the apron.
const RING_GROWTH: f32 = 1.2;

struct Builder {
    half: i32,
    vertices: Vec<[f32; 3]>,
    /// With their level.
    triangles: Vec<(u32, [u32; 3])>,
}

impl Builder {
    /// Adds a level round the one before, whose outer ring is `inner`; the answer is its own.
    fn add_level(&mut self, level: u32, last: bool, inner: &[u32]) -> Vec<u32> {
        let hole = if level == 0 { -1 } else { self.half / 2 };
        let outer = if last { self.half } else { self.half - 1 };
        let side = (2 * outer + 1) as usize;
        let slot = |x: i32, z: i32| (z + outer) as usize * side + (x + outer) as usize;
        let mut at = vec![u32::MAX; side * side];
        for z in -outer..=outer {
            for x in -outer..=outer {
                if x.abs().max(z.abs()) >= hole {
                    at[slot(x, z)] = self.vertices.len() as u32;
                    self.vertices.push([x as f32, z as f32, level as f32]);
                }
            }
        }
        let in_hole = |v: i32| (-hole..hole).contains(&v);
        for z in -outer..outer {
            for x in -outer..outer {
                if !(in_hole(x) && in_hole(z)) {
                    let [a, b, c, d] =
                        [slot(x, z), slot(x + 1, z), slot(x, z + 1), slot(x + 1, z + 1)].map(|i| at[i]);
                    self.triangles.extend([(level, [a, c, b]), (level, [b, c, d])]);
                }
            }
        }
        if level > 0 {
            let border = ring(hole).into_iter().map(|[x, z]| at[slot(x, z)]).collect::<Vec<_>>();
            self.join(level - 1, inner, &border);
        }
        ring(outer).into_iter().map(|[x, z]| at[slot(x, z)]).collect()
    }

    /// Triangles between a level's outermost own ring and the finest ring of the next one.
    fn join(&mut self, level: u32, inner: &[u32], outer: &[u32]) {
        let (m, k) = (inner.len() / 4, outer.len() / 4);
        for side in 0..4 {
            let a = |i: usize| inner[(side * m + i) % inner.len()];
            let b = |j: usize| outer[(side * k + j) % outer.len()];
            // Both rows run between parallel lines; whichever is behind takes the next step.
            let (mut i, mut j) = (0, 0);
            while i < m || j < k {
                // From the middle of the side, in cells of the finer level.
                let [next_a, next_b] = [2 * i + 2, 4 * j + 4].map(|v| v as i32);
                if j == k || (i < m && next_a - m as i32 <= next_b - 2 * k as i32) {
                    self.triangles.push((level, [b(j), a(i), a(i + 1)]));
                    i += 1;
                } else {
                    self.triangles.push((level, [b(j), a(i), b(j + 1)]));
                    j += 1;
                }
            }
        }
    }

    fn add_apron(&mut self, level: u32, border: Vec<u32>, reach: f32) {
        let places = self.vertices.iter().map(|&[x, z, _]| [x, z]).collect();
        let apron = TiledGrid::around(places, Vec::new(), border, reach, RING_GROWTH);
        let new = &apron.vertices[self.vertices.len()..];
        self.vertices.extend(new.iter().map(|&[x, z]| [x, z, level as f32]));
        self.triangles.extend(apron.indices.chunks_exact(3).map(|t| (level, [t[0], t[1], t[2]])));
    }

    /// Where a vertex lies, in cells of the first level, if all levels have the same origin.
    fn place(&self, vertex: u32) -> [f32; 2] {
        let [x, z, level] = self.vertices[vertex as usize];
        [x, z].map(|along| along * level.exp2())
    }

    fn finish(self, cells: u32) -> NestedGrid {
        let keyed = self.triangles.iter().map(|&(level, triangle)| {
            let corners = triangle.map(|vertex| self.place(vertex));
            let [x, z] = [0, 1].map(|axis| corners.iter().map(|corner| corner[axis]).sum::<f32>());
            let octant = (z.atan2(x).rem_euclid(std::f32::consts::TAU) / std::f32::consts::FRAC_PI_4) as u32;
            // Thirds of a cell: whole numbers sort.
            (level, octant.min(7), x.abs().max(z.abs()) as u64, triangle)
        });
        let mut keyed: Vec<_> = keyed.collect();
        keyed.sort_by_key(|&(level, octant, distance, _)| (level, octant, distance));
        let mut parts: Vec<Part> = Vec::new();
        let mut indices = Vec::with_capacity(3 * keyed.len());
        for (level, octant, _, triangle) in keyed {
            let from = indices.len() as u32;
            indices.extend(triangle);
            match parts.last_mut() {
                Some(part) if (part.level, part.octant) == (level, octant) => part.indices.end = from + 3,
                _ => parts.push(Part { level, octant, indices: from..from + 3 }),
            }
        }
        NestedGrid { vertices: self.vertices, indices, parts, cells }
    }
}

/// Once round a square of this half width, from its north-west corner eastwards.
fn ring(half: i32) -> Vec<[i32; 2]> {
    let along = -half..half;
    let north = along.clone().map(|i| [i, -half]);
    let east = along.clone().map(|i| [half, i]);
    let south = along.clone().map(|i| [-i, half]);
    let west = along.map(|i| [-half, -i]);
    north.chain(east).chain(south).chain(west).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    /// Vertices in metres for an eye anywhere over the lattice: each level moved by whole cells of its own.
    fn placed(grid: &NestedGrid, eye: [f64; 2]) -> Vec<[f64; 2]> {
        let place = |&[x, z, level]: &[f32; 3]| {
            let cell = f64::from(level).exp2();
            let along = |v: f32, eye: f64| (eye / cell).round() * cell + f64::from(v) * cell;
            [along(x, eye[0]), along(z, eye[1])]
        };
        grid.vertices.iter().map(place).collect()
    }

    /// Every edge inside is shared by two triangles that run along it in opposite directions: no hole, no crack.
    #[test]
    fn the_surface_is_closed_to_its_outer_border() {
        for (cells, levels) in [(8, 1), (16, 2), (64, 5)] {
            let grid = NestedGrid::new(cells, levels, 500.0);
            let mut edges: HashMap<(u32, u32), i32> = HashMap::new();
            for t in grid.indices.chunks(3) {
                for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                    let sum = edges.entry((a.min(b), a.max(b))).or_default();
                    *sum += if a < b { 1 } else { -1 };
                    assert!(sum.abs() <= 1);
                }
            }
            let half = grid.vertices.last().unwrap()[0].abs();
            assert!(half >= 500.0);
            for (&(a, b), _) in edges.iter().filter(|(_, sum)| **sum != 0) {
                for v in [a, b] {
                    let [x, z, level] = grid.vertices[v as usize];
                    assert!(level as u32 + 1 == levels && x.abs().max(z.abs()) == half, "open at {x}, {z}");
                }
            }
        }
    }

    /// Wherever the eye stands, the triangles cover the area once: none is folded over.
    #[test]
    fn no_triangle_folds_when_levels_move_apart() {
        let grid = NestedGrid::new(16, 4, 200.0);
        for i in 0..200 {
            let eye = [0.37 * f64::from(i) - 20.0, 1e6 + 1.13 * f64::from(i)];
            let places = placed(&grid, eye);
            let mut area = 0.0;
            for t in grid.indices.chunks(3) {
                let [a, b, c] = [t[0], t[1], t[2]].map(|i| places[i as usize]);
                let cross = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
                assert!(cross <= 1e-6, "a triangle faces down at {a:?}");
                area -= 0.5 * cross;
            }
            let half = 8.0 * f64::from(grid.vertices.last().unwrap()[0].abs());
            assert!((area / (4.0 * half * half) - 1.0).abs() < 1e-6, "{area}");
        }
    }

    #[test]
    fn parts_hold_every_triangle_once_and_in_their_eighth() {
        let grid = NestedGrid::new(32, 3, 100.0);
        let mut next = 0;
        for part in &grid.parts {
            assert_eq!(part.indices.start, next);
            next = part.indices.end;
            for t in grid.indices[part.indices.start as usize..next as usize].chunks(3) {
                let centre = t.iter().fold(glam::Vec2::ZERO, |sum, &v| {
                    let [x, z, level] = grid.vertices[v as usize];
                    sum + glam::Vec2::new(x, z) * level.exp2()
                });
                let angle = (part.octant as f32 + 0.5) * std::f32::consts::FRAC_PI_4;
                assert!(centre.angle_to(glam::Vec2::from_angle(angle)).abs() < 0.3928);
            }
        }
        assert_eq!(next as usize, grid.indices.len());
        assert_eq!(grid.parts.len(), 24);
    }

    /// From a level's inner edge on, its cells are no wider than four parts in `cells` of the distance.
    #[test]
    fn cells_are_as_fine_as_their_distance_asks() {
        let grid = NestedGrid::new(64, 4, 64.0);
        for t in grid.indices.chunks(3) {
            let corners = [t[0], t[1], t[2]].map(|i| grid.vertices[i as usize]);
            let cell = corners.map(|v| v[2].exp2()).into_iter().fold(0.0, f32::max);
            let distance = corners.map(|[x, z, level]| x.abs().max(z.abs()) * level.exp2());
            let nearest = distance.into_iter().fold(f32::INFINITY, f32::min);
            assert!(cell == 1.0 || nearest + cell >= 64.0 / 4.0 * cell * 0.999, "{corners:?}");
        }
    }
}
