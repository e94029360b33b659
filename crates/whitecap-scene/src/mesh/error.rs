//! Why a mesh could not be read.

use std::fmt::Display;
use std::io;

use super::Mesh;

/// The longest piece of a file or of another's message that goes into an error, characters.
const LONGEST_QUOTE: usize = 160;

/// A mesh that cannot be used, and why. It prints as one line that begins with the file.
#[derive(Debug, thiserror::Error)]
#[error("{file}: {problem}")]
pub struct MeshError {
    /// The file, or what stands for it.
    pub file: String,
    /// What is wrong with it.
    #[source]
    pub problem: MeshProblem,
}

/// What is wrong with a mesh's file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MeshProblem {
    /// The file system refused.
    #[error("cannot be read: {0}")]
    Unreadable(#[source] io::Error),

    /// It is a folder.
    #[error("this is a folder; accepted: a glTF 2.0 file, .gltf or .glb")]
    Folder,

    /// It is a pipe, a socket or a device.
    #[error("no ordinary file; accepted: a glTF 2.0 file, .gltf or .glb")]
    NoFile,

    /// It holds no byte.
    #[error("empty; accepted: a glTF 2.0 file, .gltf or .glb")]
    Empty,

    /// It begins like neither form of glTF.
    #[error("neither a .gltf nor a .glb file, by its first bytes")]
    UnknownFormat,

    /// It is of another version of glTF.
    #[error("glTF version {0}; accepted: 2.0")]
    Version(String),

    /// The file and its buffers have too many bytes.
    #[error("more than {} bytes with its buffers; accepted: up to that", Mesh::MAX_FILE_BYTES)]
    TooLong,

    /// It has too many of something.
    #[error("{count} {what}; accepted: up to {most}")]
    TooMany {
        /// What there is too much of.
        what: &'static str,
        /// How many there are, or how many there are at least.
        count: u64,
        /// How many may be.
        most: u64,
    },

    /// The file ends early or is no JSON of the right form.
    #[error("damaged or not supported glTF: {0}")]
    Damaged(String),

    /// A buffer cannot be had.
    #[error("buffer {index}: {explanation}")]
    Buffer {
        /// Which one, from 0.
        index: usize,
        /// Why not.
        explanation: String,
    },

    /// A part of the file contradicts another or what glTF demands.
    #[error("{part} {index}: {explanation}")]
    Faulty {
        /// What kind of part: accessor, node …
        part: &'static str,
        /// Which one, from 0.
        index: usize,
        /// What is wrong with it.
        explanation: String,
    },

    /// It needs an extension that is not known here.
    #[error("needs the extension {0}; accepted: files without compression or other extensions to geometry")]
    Extension(String),

    /// The scene shows nothing.
    #[error("no triangles of any size in its scene")]
    NoTriangles,
}

impl MeshProblem {
    pub(super) fn in_file(self, file: impl Display) -> MeshError {
        MeshError { file: file.to_string(), problem: self }
    }
}

/// What somebody else wrote, as a piece of one line: no control characters, and not too long.
pub(super) fn one_line(text: impl Display) -> String {
    let text = text.to_string();
    let mut line: String =
        text.chars().take(LONGEST_QUOTE).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if line.len() < text.len() {
        line.push('…');
    }
    line
}
