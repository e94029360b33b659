//! N-patches: a coarse mesh refined by curved PN triangles.
//!
//! Source: Vlachos, Peters, Boyd and Mitchell, "Curved PN Triangles", I3D 2001. Each triangle becomes a cubic
//! Bézier patch that follows from its corners and their normals alone, and normals vary quadratically over it.
//! What lies on an edge follows from the edge's two corners, so neighbours that share an edge share its points.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | P, N | position and normal of a corner |
//! | b with three digits | control point of the cubic; the digits are its powers of the corners' weights |
//! | h with three digits | control normal between two corners |

use glam::DVec3;
use std::collections::HashMap;

/// A refined mesh. Its first vertices are the coarse mesh's, at their places and with their indices.
#[derive(Clone, Debug, PartialEq)]
pub struct NPatches {
    /// Where each vertex is.
    pub positions: Vec<[f32; 3]>,
    /// The unit normal at each vertex.
    pub normals: Vec<[f32; 3]>,
    /// Three vertices for each triangle, wound as in the coarse mesh, and in the order of its triangles.
    pub indices: Vec<u32>,
    /// What each vertex is made of.
    origins: Vec<Origin>,
}

/// The corners of the coarse triangle that a vertex lies in, and its barycentric weights.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Origin {
    corners: [u32; 3],
    weights: [f32; 3],
}

#[derive(Clone, Copy)]
struct Corner {
    index: u32,
    position: DVec3,
    normal: DVec3,
}

impl NPatches {
    /// Divides each edge of a mesh of triangles into `level` parts, and each triangle into `level`² (a level of
    /// 0 counts as 1, which leaves the mesh as it is). Normals are of length 1.
    ///
    /// # Panics
    ///
    /// If there is not a normal for each position, or an index is out of range.
    pub fn new(positions: &[[f32; 3]], normals: &[[f32; 3]], indices: &[u32], level: u32) -> NPatches {
        assert_eq!(positions.len(), normals.len(), "a normal for each position");
        let level = level.max(1);
        let corner = |index: u32| Corner {
            index,
            position: DVec3::from(positions[index as usize].map(f64::from)),
            normal: DVec3::from(normals[index as usize].map(f64::from)),
        };
        let itself = |i: usize| Origin { corners: [i as u32; 3], weights: [1.0, 0.0, 0.0] };
        let mut refined = NPatches {
            positions: positions.to_vec(),
            normals: normals.to_vec(),
            indices: Vec::with_capacity(indices.len() * (level * level) as usize),
            origins: (0..positions.len()).map(itself).collect(),
        };
        let mut edges = HashMap::new();
        for triangle in indices.chunks_exact(3) {
            let corners = [corner(triangle[0]), corner(triangle[1]), corner(triangle[2])];
            refined.add_patch(corners, level, &mut edges);
        }
        refined
    }

    /// A value for each refined vertex, linear over each coarse triangle, from one for each coarse vertex.
    ///
    /// # Panics
    ///
    /// If `coarse` has fewer values than the coarse mesh has vertices.
    pub fn interpolate<'a>(&'a self, coarse: &'a [f32]) -> impl Iterator<Item = f32> + 'a {
        self.origins.iter().map(|Origin { corners, weights }| {
            corners.iter().zip(weights).map(|(&corner, weight)| coarse[corner as usize] * weight).sum()
        })
    }

    fn add_patch(&mut self, corners: [Corner; 3], level: u32, edges: &mut HashMap<(u32, u32), Vec<u32>>) {
        let [a, b, c] = corners;
        let ab = self.edge(a, b, level, edges);
        let ac = self.edge(a, c, level, edges);
        let bc = self.edge(b, c, level, edges);
        // Rows from corner a to the side between b and c.
        let mut last = vec![a.index];
        for row in 1..=level {
            let vertices: Vec<u32> = (0..=row)
                .map(|i| match (i, row) {
                    (i, row) if row == level => bc[i as usize],
                    (0, row) => ab[row as usize],
                    (i, row) if i == row => ac[row as usize],
                    (i, row) => {
                        let [of_b, of_c] = [row - i, i].map(|n| f64::from(n) / f64::from(level));
                        self.add_vertex(corners, DVec3::new(1.0 - of_b - of_c, of_b, of_c))
                    }
                })
                .collect();
            for i in 0..row as usize {
                self.indices.extend([last[i], vertices[i], vertices[i + 1]]);
                if i + 1 < row as usize {
                    self.indices.extend([last[i], vertices[i + 1], last[i + 1]]);
                }
            }
            last = vertices;
        }
    }

    /// The vertices along an edge from `a` to `b`, both included.
    fn edge(
        &mut self,
        a: Corner,
        b: Corner,
        level: u32,
        edges: &mut HashMap<(u32, u32), Vec<u32>>,
    ) -> Vec<u32> {
        if a.index > b.index {
            let mut reversed = self.edge(b, a, level, edges);
            reversed.reverse();
            return reversed;
        }
        let between = edges.entry((a.index, b.index)).or_insert_with(|| {
            // A patch whose third corner has no weight is the edge's curve.
            let at = |i: u32| f64::from(i) / f64::from(level);
            (1..level).map(|i| self.add_vertex([a, b, b], DVec3::new(1.0 - at(i), at(i), 0.0))).collect()
        });
        [&[a.index], between.as_slice(), &[b.index]].concat()
    }

    fn add_vertex(&mut self, corners: [Corner; 3], weights: DVec3) -> u32 {
        let index = self.positions.len() as u32;
        self.positions.push(position(corners, weights).as_vec3().to_array());
        self.normals.push(normal(corners, weights).as_vec3().to_array());
        let corners = corners.map(|corner| corner.index);
        self.origins.push(Origin { corners, weights: weights.as_vec3().to_array() });
        index
    }
}

/// The control point next to `a` on its edge to `b`: a third of the way, laid into the plane of `a`'s normal.
fn edge_control(a: Corner, b: Corner) -> DVec3 {
    let rise = (b.position - a.position).dot(a.normal);
    (2.0 * a.position + b.position - rise * a.normal) / 3.0
}

/// The cubic patch at barycentric weights.
fn position([a, b, c]: [Corner; 3], weights: DVec3) -> DVec3 {
    let [w, u, v] = weights.to_array();
    let (b210, b120) = (edge_control(a, b), edge_control(b, a));
    let (b021, b012) = (edge_control(b, c), edge_control(c, b));
    let (b102, b201) = (edge_control(c, a), edge_control(a, c));
    let mean_of_edges = (b210 + b120 + b021 + b012 + b102 + b201) / 6.0;
    let mean_of_corners = (a.position + b.position + c.position) / 3.0;
    let b111 = mean_of_edges + (mean_of_edges - mean_of_corners) / 2.0;
    a.position * (w * w * w)
        + b.position * (u * u * u)
        + c.position * (v * v * v)
        + 3.0 * (b210 * (w * w * u) + b120 * (w * u * u) + b201 * (w * w * v))
        + 3.0 * (b021 * (u * u * v) + b102 * (w * v * v) + b012 * (u * v * v))
        + b111 * (6.0 * w * u * v)
}

/// The control normal between two corners: their mean, mirrored in the plane across the edge's middle.
fn normal_control(a: Corner, b: Corner) -> DVec3 {
    let along = b.position - a.position;
    let sum = a.normal + b.normal;
    let length_squared = along.length_squared();
    let share = if length_squared > 0.0 { 2.0 * along.dot(sum) / length_squared } else { 0.0 };
    (sum - share * along).normalize_or(a.normal)
}

/// The quadratic normals at barycentric weights.
fn normal([a, b, c]: [Corner; 3], weights: DVec3) -> DVec3 {
    let [w, u, v] = weights.to_array();
    let (h110, h011, h101) = (normal_control(a, b), normal_control(b, c), normal_control(c, a));
    let sum = a.normal * (w * w)
        + b.normal * (u * u)
        + c.normal * (v * v)
        + h110 * (w * u)
        + h011 * (u * v)
        + h101 * (w * v);
    sum.normalize_or(a.normal)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    /// A sphere's octahedron: corners on the sphere with its normals.
    const CORNERS: [[f32; 3]; 6] = [
        [1.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
    ];
    const FACES: [u32; 24] = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];

    fn octahedron(level: u32) -> NPatches {
        NPatches::new(&CORNERS, &CORNERS, &FACES, level)
    }

    #[test]
    fn at_the_coarse_vertices_the_surfaces_agree() {
        for level in 1..9 {
            let refined = octahedron(level);
            assert_eq!(refined.positions[..6], CORNERS);
            assert_eq!(refined.normals[..6], CORNERS);
            assert_eq!(refined.indices.len(), 24 * (level * level) as usize);
            assert_eq!(refined.positions.len(), 2 + 4 * (level * level) as usize);
        }
        // The patch itself runs through its corners; vertices there are not only copied.
        let corner = |i: usize| Corner {
            index: 0,
            position: Vec3::from(CORNERS[i]).as_dvec3(),
            normal: Vec3::from(CORNERS[i]).as_dvec3(),
        };
        let corners = [corner(0), corner(2), corner(4)];
        for (weights, at) in [(DVec3::X, 0), (DVec3::Y, 2), (DVec3::Z, 4)] {
            assert!((position(corners, weights) - corner(at).position).length() < 1e-12);
            assert!((normal(corners, weights) - corner(at).normal).length() < 1e-12);
        }
    }

    #[test]
    fn level_one_is_the_identity() {
        let refined = octahedron(1);
        assert_eq!((refined.positions.as_slice(), refined.indices.as_slice()), (&CORNERS[..], &FACES[..]));
        assert_eq!(octahedron(0), refined);
    }

    #[test]
    fn a_flat_mesh_stays_flat_and_even() {
        let normal = Vec3::new(0.3, 0.8, -0.2).normalize();
        let (x, y) = (normal.any_orthonormal_vector(), normal.cross(normal.any_orthonormal_vector()));
        let at = |a: f32, b: f32| (5.0 * normal + a * x + b * y).to_array();
        let corners = [at(0.0, 0.0), at(4.0, 1.0), at(-2.0, 3.0), at(3.0, 7.0)];
        let refined = NPatches::new(&corners, &[normal.to_array(); 4], &[0, 1, 2, 2, 1, 3], 5);
        let along = |axis: usize| corners.map(|corner| corner[axis]);
        let linear: Vec<Vec<f32>> = (0..3).map(|axis| refined.interpolate(&along(axis)).collect()).collect();
        for (i, (place, n)) in refined.positions.iter().zip(&refined.normals).enumerate() {
            assert!((Vec3::from(*place).dot(normal) - 5.0).abs() < 1e-5);
            assert!((Vec3::from(*n) - normal).length() < 1e-6);
            // Without curvature the cubic is the plane triangle, point by point.
            assert!((0..3).all(|axis| (place[axis] - linear[axis][i]).abs() < 1e-5));
        }
    }

    /// On a sphere the refined points lie nearer to it than those of the flat triangles, and so do the normals.
    #[test]
    fn a_sphere_becomes_rounder() {
        let refined = octahedron(6);
        let along =
            |axis: usize| -> Vec<f32> { refined.interpolate(&CORNERS.map(|corner| corner[axis])).collect() };
        let (x, y, z) = (along(0), along(1), along(2));
        for i in 6..refined.positions.len() {
            let (curved, flat) = (Vec3::from(refined.positions[i]), Vec3::new(x[i], y[i], z[i]));
            let error = |place: Vec3| (place.length() - 1.0).abs();
            assert!(error(curved) < 0.55 * error(flat), "{curved} {flat}");
            assert!(Vec3::from(refined.normals[i]).dot(curved.normalize()) > 0.995);
        }
    }

    /// By hand: an edge's middle is at 3/8 (1 + 1/3) + 1/8, a face's at 1/27 + 3/27 · 8/3 + 6/27 · 1/2.
    #[test]
    fn golden_points_of_the_octahedron() {
        let edge = octahedron(2);
        let found = |refined: &NPatches, place: [f32; 3]| {
            refined.positions.iter().any(|p| (Vec3::from(*p) - Vec3::from(place)).length() < 1e-6)
        };
        assert!(found(&edge, [0.625, 0.625, 0.0]) && found(&edge, [0.0, -0.625, 0.625]));
        assert!(found(&octahedron(3), [4.0 / 9.0; 3]));
    }

    /// Each inner edge belongs to two triangles that run along it in opposite directions: no crack.
    #[test]
    fn shared_edges_stay_shared() {
        for level in [2, 3, 7] {
            let mut edges: HashMap<(u32, u32), i32> = HashMap::new();
            for t in octahedron(level).indices.chunks(3) {
                for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                    *edges.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
                }
            }
            // A closed surface: every edge is met once in each direction.
            assert!(edges.values().all(|&n| n == 0));
            assert_eq!(edges.len(), 12 * (level * level) as usize);
        }
    }

    #[test]
    fn triangles_keep_their_winding() {
        for t in octahedron(4).indices.chunks(3) {
            let refined = octahedron(4);
            let [a, b, c] = [t[0], t[1], t[2]].map(|i| Vec3::from(refined.positions[i as usize]));
            assert!((b - a).cross(c - a).dot(a + b + c) > 0.0);
        }
    }
}
