//! Meshes from glTF 2.0 files, `.gltf` and `.glb`.
//!
//! Section numbers are those of the Khronos glTF 2.0 specification, version 2.0.1.

mod accessor;
mod buffer;
mod container;
mod primitive;
mod scene;

use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::error::MeshProblem;
use super::{Mesh, MeshError};

impl Mesh {
    /// The most bytes that a file and its buffers may have together.
    pub const MAX_FILE_BYTES: u64 = 256 << 20;

    /// The most triangles that are read.
    pub const MAX_TRIANGLES: usize = 2_000_000;

    /// The most vertices that are read.
    pub const MAX_VERTICES: usize = 3 * Self::MAX_TRIANGLES;

    /// The most nodes that a file may have.
    pub const MAX_NODES: usize = 10_000;

    /// The farthest that a vertex may be from the origin along an axis, metres.
    pub const MAX_REACH_M: f64 = 1e7;

    /// Reads a glTF 2.0 file: `.gltf`, with buffers inside or beside it, or `.glb`.
    ///
    /// All nodes of the default scene become one mesh, in the file's own axes: y up, in metres; glTF's front, +z,
    /// is south at heading 0. Base colours are the material's factor times the vertex colours. Vertices without
    /// normals get those of their triangles. Textures, skins, morph targets, animations, cameras and lights are
    /// ignored; so is whether a material shows its back. Points and lines are refused.
    ///
    /// Buffers are files in the file's own folder or in folders in that.
    ///
    /// # Errors
    ///
    /// If a file cannot be read, is no glTF 2.0, contradicts itself, needs an extension that changes geometry
    /// (other than quantized vertices), shows no triangles or goes beyond a limit: [`Self::MAX_FILE_BYTES`],
    /// [`Self::MAX_TRIANGLES`], [`Self::MAX_VERTICES`], [`Self::MAX_NODES`], [`Self::MAX_REACH_M`].
    pub fn load(path: &Path) -> Result<Self, MeshError> {
        let read = || {
            let bytes = read_file(path, Self::MAX_FILE_BYTES)?;
            parse(&bytes, Some(path.parent().unwrap_or(Path::new(""))))
        };
        read().map_err(|problem: MeshProblem| problem.in_file(path.display()))
    }

    /// Reads the bytes of such a file, which can have no buffers beside it; `name` is what errors call it.
    ///
    /// # Errors
    ///
    /// As [`load`](Self::load).
    pub fn from_gltf_bytes(bytes: &[u8], name: &str) -> Result<Self, MeshError> {
        parse(bytes, None).map_err(|problem| problem.in_file(name))
    }
}

fn parse(bytes: &[u8], folder: Option<&Path>) -> Result<Mesh, MeshProblem> {
    if bytes.len() as u64 > Mesh::MAX_FILE_BYTES {
        return Err(MeshProblem::TooLong);
    }
    let container = container::Container::read(bytes)?;
    let root = container.root()?;
    let buffers = buffer::load_all(&root, container.blob, folder, bytes.len() as u64)?;
    scene::flatten(&root, &buffers)
}

/// The bytes of an ordinary file, at most `most` of them.
fn read_file(path: &Path, most: u64) -> Result<Vec<u8>, MeshProblem> {
    // Before it is opened: opening a pipe that nobody writes to would wait for ever.
    let about = std::fs::metadata(path).map_err(MeshProblem::Unreadable)?;
    if about.is_dir() {
        return Err(MeshProblem::Folder);
    }
    if !about.is_file() {
        return Err(MeshProblem::NoFile);
    }
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(MeshProblem::Unreadable)?;
    file.take(most + 1).read_to_end(&mut bytes).map_err(MeshProblem::Unreadable)?;
    if bytes.len() as u64 > most {
        return Err(MeshProblem::TooLong);
    }
    Ok(bytes)
}
