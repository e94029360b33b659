//! Solid things: built-in meshes, meshes from glTF files, where they stand, and the ground that they make.
//!
//! Meshes are y up, in metres; the triangles run counter-clockwise as seen from outside. [`BUILT_IN`] lists those
//! that need no file; [`Mesh::load`] reads the others. A [`Placement`] puts a mesh into the world, a [`Ground`]
//! answers how deep the water over it is.
//!
//! ```
//! use whitecap_scene::mesh::{self, Ground, Placement};
//!
//! let island = (mesh::built_in("island").unwrap().make)(7);
//! let placement = Placement { position_m: [1000.0, 0.0, 0.0].into(), heading_deg: 90.0, scale: 1.0 };
//! let ground = Ground::new(island.triangles_in_world(&placement), 256).unwrap();
//! assert!(ground.height_m(1000.0, 0.0).unwrap() > 3.0);
//! assert_eq!(ground.height_m(0.0, 0.0), None);
//! ```

mod built_in;
mod error;
mod fault;
mod gltf;
mod ground;
mod placement;

use glam::{DVec3, Vec3};

pub use built_in::{BUILT_IN, BuiltIn, Island, LakeBed, built_in};
pub use error::{MeshError, MeshProblem};
pub use fault::MeshFault;
pub use ground::Ground;
pub use placement::Placement;

/// A surface of triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Where each vertex is, metres.
    pub positions: Vec<[f32; 3]>,
    /// The unit normal at each vertex, pointing out of the thing.
    pub normals: Vec<[f32; 3]>,
    /// The base colour at each vertex as a display shows it, sRGB-encoded, 0 to 1.
    pub colors: Vec<[f32; 3]>,
    /// Three vertices for each triangle, counter-clockwise from outside.
    pub indices: Vec<u32>,
}

impl Mesh {
    /// The lowest and the highest corner of the box around all vertices, metres; `None` without vertices.
    pub fn bounds(&self) -> Option<[Vec3; 2]> {
        let positions = || self.positions.iter().copied().map(Vec3::from);
        Some([positions().reduce(Vec3::min)?, positions().reduce(Vec3::max)?])
    }

    /// The corners of each triangle, metres.
    ///
    /// # Panics
    ///
    /// If an index is out of range, which it is in no mesh that [`validate`](Self::validate) accepts.
    pub fn triangles(&self) -> impl Iterator<Item = [Vec3; 3]> + '_ {
        let corner = |index: u32| Vec3::from(self.positions[index as usize]);
        self.indices.chunks_exact(3).map(move |corners| [0, 1, 2].map(|i| corner(corners[i])))
    }

    /// The corners of each triangle of this mesh where it is placed, metres: what [`Ground::new`] takes.
    ///
    /// # Panics
    ///
    /// As [`triangles`](Self::triangles).
    pub fn triangles_in_world(&self, placement: &Placement) -> impl Iterator<Item = [DVec3; 3]> + '_ {
        let world_from_mesh = placement.world_from_mesh();
        self.triangles()
            .map(move |corners| corners.map(|corner| world_from_mesh.transform_point3(corner.as_dvec3())))
    }

    /// Checks what every mesh promises; see the fields.
    ///
    /// # Errors
    ///
    /// The first promise that is broken.
    pub fn validate(&self) -> Result<(), MeshFault> {
        fault::find(self)
    }

    /// Adds another mesh beside this one.
    pub fn append(&mut self, other: &Self) {
        // Meshes are far below 2³² vertices: readers refuse more.
        let first = self.positions.len() as u32;
        self.positions.extend_from_slice(&other.positions);
        self.normals.extend_from_slice(&other.normals);
        self.colors.extend_from_slice(&other.colors);
        self.indices.extend(other.indices.iter().map(|index| first + index));
    }

    /// Adds a vertex and returns its index.
    fn push(&mut self, position_m: DVec3, normal: DVec3, color: Vec3) -> u32 {
        let index = self.positions.len() as u32;
        self.positions.push(position_m.as_vec3().into());
        self.normals.push(normal.normalize_or(DVec3::Y).as_vec3().into());
        self.colors.push(color.clamp(Vec3::ZERO, Vec3::ONE).into());
        index
    }
}
