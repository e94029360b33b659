//! What can be wrong with a mesh.

use glam::Vec3;

use super::Mesh;

/// How far from 1 the length of a normal may be.
const NORMAL_TOLERANCE: f32 = 1e-3;

/// A promise of [`Mesh`] that is broken.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshFault {
    /// The vertices do not all have a position, a normal and a colour.
    #[error("{positions} positions, {normals} normals and {colors} colours; they must be as many")]
    Uneven {
        /// How many positions.
        positions: usize,
        /// How many normals.
        normals: usize,
        /// How many colours.
        colors: usize,
    },

    /// The indices do not come in threes.
    #[error("{0} indices, which are no whole triangles")]
    NoTriangles(usize),

    /// A triangle has a corner that is no vertex.
    #[error("index {index} among {vertices} vertices")]
    Index {
        /// The index.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },

    /// A coordinate is infinite or not a number.
    #[error("vertex {0} is not at a finite place")]
    Position(usize),

    /// A normal is not of length 1.
    #[error("the normal of vertex {vertex} is {length} long")]
    Normal {
        /// The vertex.
        vertex: usize,
        /// The length of its normal.
        length: f32,
    },

    /// A colour is outside 0 to 1.
    #[error("the colour of vertex {0} is outside 0 to 1")]
    Color(usize),
}

/// The first fault of `mesh`, if any.
pub(super) fn find(mesh: &Mesh) -> Result<(), MeshFault> {
    let vertices = mesh.positions.len();
    if mesh.normals.len() != vertices || mesh.colors.len() != vertices {
        return Err(MeshFault::Uneven {
            positions: vertices,
            normals: mesh.normals.len(),
            colors: mesh.colors.len(),
        });
    }
    if !mesh.indices.len().is_multiple_of(3) {
        return Err(MeshFault::NoTriangles(mesh.indices.len()));
    }
    if let Some(&index) = mesh.indices.iter().find(|index| **index as usize >= vertices) {
        return Err(MeshFault::Index { index, vertices });
    }
    for vertex in 0..vertices {
        if !Vec3::from(mesh.positions[vertex]).is_finite() {
            return Err(MeshFault::Position(vertex));
        }
        let length = Vec3::from(mesh.normals[vertex]).length();
        if length.is_nan() || (length - 1.0).abs() > NORMAL_TOLERANCE {
            return Err(MeshFault::Normal { vertex, length });
        }
        if !mesh.colors[vertex].iter().all(|value| (0.0..=1.0).contains(value)) {
            return Err(MeshFault::Color(vertex));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_broken_promise_is_found() {
        let sound = Mesh {
            positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
            normals: vec![[0.0, 1.0, 0.0]; 3],
            colors: vec![[0.0, 0.5, 1.0]; 3],
            indices: vec![0, 1, 2],
        };
        assert_eq!(sound.validate(), Ok(()));
        let broken = |change: fn(&mut Mesh)| {
            let mut mesh = sound.clone();
            change(&mut mesh);
            mesh.validate().unwrap_err()
        };
        assert_eq!(
            broken(|mesh| mesh.colors.truncate(1)),
            MeshFault::Uneven { positions: 3, normals: 3, colors: 1 }
        );
        assert_eq!(broken(|mesh| mesh.indices.push(0)), MeshFault::NoTriangles(4));
        assert_eq!(broken(|mesh| mesh.indices[2] = 3), MeshFault::Index { index: 3, vertices: 3 });
        assert_eq!(broken(|mesh| mesh.positions[1][2] = f32::INFINITY), MeshFault::Position(1));
        assert_eq!(broken(|mesh| mesh.normals[2][1] = 0.9), MeshFault::Normal { vertex: 2, length: 0.9 });
        assert!(matches!(broken(|mesh| mesh.normals[0][0] = f32::NAN), MeshFault::Normal { vertex: 0, .. }));
        assert_eq!(broken(|mesh| mesh.colors[1][0] = 1.5), MeshFault::Color(1));
        assert_eq!(broken(|mesh| mesh.colors[0][0] = f32::NAN), MeshFault::Color(0));
    }
}
