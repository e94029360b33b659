//! Why a panorama could not be read.

use std::fmt::Display;
use std::io;

use super::Panorama;

/// A panorama that cannot be used, and why. It prints as one line that begins with the file.
#[derive(Debug, thiserror::Error)]
#[error("{file}: {problem}")]
pub struct PanoramaError {
    /// The file, or what stands for it.
    pub file: String,
    /// What is wrong with it.
    #[source]
    pub problem: PanoramaProblem,
}

/// What is wrong with a panorama.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PanoramaProblem {
    /// The file system refused.
    #[error("cannot be read: {0}")]
    Unreadable(#[source] io::Error),

    /// It is a folder.
    #[error("this is a folder; accepted: a Radiance HDR or OpenEXR picture")]
    Folder,

    /// It is a pipe, a socket or a device.
    #[error("no ordinary file; accepted: a Radiance HDR or OpenEXR picture")]
    NoFile,

    /// Every pixel is black, negative or not a number.
    #[error("without any light: every pixel is 0, negative or not a number")]
    Dark,

    /// It begins like neither format.
    #[error("neither a Radiance HDR nor an OpenEXR picture, by its first bytes")]
    UnknownFormat,

    /// The file has too many bytes.
    #[error("{bytes} bytes long; accepted: up to {}", Panorama::MAX_FILE_BYTES)]
    FileTooLong {
        /// How many.
        bytes: u64,
    },

    /// The header claims too many pixels.
    #[error("{width} x {height} pixels; accepted: up to {} x {}", Panorama::MAX_WIDTH, Panorama::MAX_HEIGHT)]
    TooLarge {
        /// The width in the header.
        width: usize,
        /// The height in the header.
        height: usize,
    },

    /// The picture is not twice as wide as high.
    #[error("{width} x {height} pixels, which is not equirectangular; accepted: about twice as wide as high")]
    NotEquirectangular {
        /// The width in the header.
        width: usize,
        /// The height in the header.
        height: usize,
    },

    /// The file ends early or contradicts itself.
    #[error("damaged or not supported {format}: {explanation}")]
    Damaged {
        /// The format that it seems to be.
        format: &'static str,
        /// What the decoder found.
        explanation: String,
    },
}

impl PanoramaProblem {
    pub(super) fn in_file(self, file: impl Display) -> PanoramaError {
        PanoramaError { file: file.to_string(), problem: self }
    }
}
