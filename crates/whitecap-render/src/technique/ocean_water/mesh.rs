//! The plane that the vertex shader raises: a coarse grid round the viewer, refined by N-patches, and an apron that
//! carries it to the horizon.

use crate::geometry::{NPatches, TiledGrid};
use glam::{DVec2, Vec2};
use whitecap_scene::technique::OceanWater as Settings;

/// The apron reaches this far, metres.
const REACH_M: f32 = 1.0e7;

/// Cells on each side of the centre that are equally wide.
const EVEN_CELLS: u32 = 4;

/// East and south of the mesh's centre, metres.
pub(super) struct Mesh {
    /// The coarse input grid's vertices.
    pub(super) coarse: Vec<Vec2>,
    /// What is drawn: the refined grid's vertices first, then the apron's.
    pub(super) drawn: TiledGrid,
    /// Half the grid's width.
    pub(super) half_m: f32,
    refined: NPatches,
    cell_m: f64,
}

impl Mesh {
    /// `refinement` parts along each edge of the coarse grid.
    pub(super) fn new(settings: &Settings, refinement: u32) -> Mesh {
        let square = TiledGrid::new(settings.grid_cells, 0.0);
        let place = |cell: f32| cell.signum() * distance_m(settings, cell.abs() as u32);
        let coarse: Vec<Vec2> = square.vertices.iter().map(|&[x, z]| Vec2::new(place(x), place(z))).collect();
        let half_m = distance_m(settings, settings.grid_cells / 2);
        let positions: Vec<[f32; 3]> = coarse.iter().map(|at| [at.x, 0.0, at.y]).collect();
        let normals = vec![[0.0, 1.0, 0.0]; positions.len()];
        let refined = NPatches::new(&positions, &normals, &square.indices, refinement);
        let vertices: Vec<[f32; 2]> = refined.positions.iter().map(|&[x, _, z]| [x, z]).collect();
        let border = border(&vertices, half_m);
        let drawn =
            TiledGrid::around(vertices, refined.indices.clone(), border, REACH_M, TiledGrid::RING_GROWTH);
        Mesh { coarse, drawn, half_m, refined, cell_m: settings.cell_m }
    }

    /// Where the centre lies for a viewer at `eye` (east, south): the grid follows in whole cells.
    pub(super) fn centre_m(&self, eye: DVec2) -> DVec2 {
        (eye / self.cell_m).round() * self.cell_m
    }

    /// The damping of every drawn vertex from that of the coarse ones. The apron is still.
    pub(super) fn drawn_damping(&self, coarse: &[f32]) -> Vec<f32> {
        let mut damping: Vec<f32> = self.refined.interpolate(coarse).collect();
        damping.resize(self.drawn.vertices.len(), 1.0);
        damping
    }
}

/// How far the `cell`-th line of the grid lies from its centre.
fn distance_m(settings: &Settings, cell: u32) -> f32 {
    let width = |i: u32| settings.cell_growth.powi((i + 1).saturating_sub(EVEN_CELLS) as i32);
    ((0..cell).map(width).sum::<f64>() * settings.cell_m) as f32
}

/// The vertices on the border of a square of this half width, from the north-west corner eastwards.
fn border(vertices: &[[f32; 2]], half_m: f32) -> Vec<u32> {
    let near = 1e-5 * half_m;
    // How far along the way round a vertex lies, in half widths.
    let along = |[x, z]: [f32; 2]| {
        if z <= near - half_m && x < half_m - near {
            x + half_m
        } else if x >= half_m - near && z < half_m - near {
            3.0 * half_m + z
        } else if z >= half_m - near && x > near - half_m {
            5.0 * half_m - x
        } else {
            7.0 * half_m - z
        }
    };
    let is_border = |[x, z]: [f32; 2]| x.abs().max(z.abs()) >= half_m - near;
    let mut border: Vec<u32> =
        (0..vertices.len() as u32).filter(|&i| is_border(vertices[i as usize])).collect();
    border.sort_by(|&a, &b| along(vertices[a as usize]).total_cmp(&along(vertices[b as usize])));
    border
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    /// No hole and no crack from the refined grid through the apron, and all of it counter-clockwise from above.
    #[test]
    fn the_plane_is_closed_to_its_outer_border() {
        for (cell_growth, refinement) in [(1.2, 3), (1.0, 1), (1.5, 2), (1.13, 8)] {
            let settings = Settings { cell_growth, grid_cells: 16, ..Settings::default() };
            let mesh = Mesh::new(&settings, refinement);
            let mut edges: HashMap<(u32, u32), i32> = HashMap::new();
            for t in mesh.drawn.indices.chunks(3) {
                for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                    *edges.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
                }
                let [a, b, c] = [t[0], t[1], t[2]].map(|i| Vec2::from(mesh.drawn.vertices[i as usize]));
                assert!((b - a).perp_dot(c - a) < 0.0);
            }
            let half = mesh.drawn.vertices.iter().map(|v| v[0]).fold(0.0, f32::max);
            assert!(half >= REACH_M);
            for ((a, b), n) in edges {
                let outer = |v: u32| Vec2::from(mesh.drawn.vertices[v as usize]).abs().max_element() == half;
                assert!(n == 0 || (outer(a) && outer(b)), "an edge is open inside the mesh");
            }
        }
    }

    #[test]
    fn cells_are_even_near_the_viewer_and_grow_outwards() {
        let settings = Settings { cell_m: 2.0, cell_growth: 1.5, grid_cells: 16, ..Settings::default() };
        let at = |cell| distance_m(&settings, cell);
        assert_eq!([at(0), at(1), at(4), at(5), at(6)], [0.0, 2.0, 8.0, 11.0, 15.5]);
        let mesh = Mesh::new(&settings, 3);
        assert_eq!(mesh.half_m, at(8));
        assert_eq!(mesh.centre_m(DVec2::new(1_000_000.9, -3.2)), DVec2::new(1_000_000.0, -4.0));
    }

    /// The coarse vertices keep their damping, the middle of an edge has the mean, the apron none of the waves.
    #[test]
    fn damping_is_joined_linearly() {
        let mesh = Mesh::new(&Settings { grid_cells: 8, ..Settings::default() }, 2);
        let damping_at = |at: Vec2| 0.3 + 0.01 * at.x - 0.02 * at.y;
        let coarse: Vec<f32> = mesh.coarse.iter().map(|at| damping_at(*at)).collect();
        let drawn = mesh.drawn_damping(&coarse);
        assert_eq!(drawn.len(), mesh.drawn.vertices.len());
        assert_eq!(drawn[..coarse.len()], coarse);
        let refined = mesh.refined.positions.len();
        for (at, damping) in mesh.drawn.vertices[..refined].iter().zip(&drawn) {
            assert!((damping_at(Vec2::from(*at)) - damping).abs() < 1e-5);
        }
        assert!(drawn[refined..].iter().all(|&damping| damping == 1.0));
    }

    /// On a processor each triangle costs a third of a microsecond.
    #[test]
    fn a_processor_gets_few_triangles() {
        let mesh = Mesh::new(&Settings::default(), super::super::REFINEMENT_ON_A_PROCESSOR);
        let triangles = mesh.drawn.indices.len() / 3;
        assert!((10_000..25_000).contains(&triangles), "{triangles}");
    }
}
