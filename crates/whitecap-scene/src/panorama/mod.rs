//! Pictures of a whole sky: equirectangular Radiance HDR and OpenEXR files.
//!
//! Row 0 is the zenith; the middle column looks north and east is to its right. Files are told apart by their
//! first bytes. What a file's header claims is checked before memory is set aside for it.

mod decode;
mod error;
mod exr;
mod hdr;
mod sample;

use std::fs::File;
use std::io::{BufReader, Cursor};
use std::path::Path;

pub use error::{PanoramaError, PanoramaProblem};

/// A picture of everything around, in linear RGB radiance.
#[derive(Clone, Debug, PartialEq)]
pub struct Panorama {
    /// Pixels in a row, a full turn; at least 1.
    pub width: usize,
    /// Rows, from the zenith to the nadir; at least 1.
    pub height: usize,
    /// `width * height` pixels, row by row: red, green and blue, finite and not negative.
    pub pixels: Vec<[f32; 3]>,
    /// How many pixels were not so in the file: NaN and negative values became 0, those above 65504 became that.
    pub repaired: usize,
}

impl Panorama {
    /// The widest picture that is read, pixels.
    pub const MAX_WIDTH: usize = 8192;

    /// The highest picture that is read, pixels.
    pub const MAX_HEIGHT: usize = 4096;

    /// The longest file that is read, bytes.
    pub const MAX_FILE_BYTES: u64 = 2 << 30;

    /// Reads a Radiance HDR or OpenEXR file.
    ///
    /// # Errors
    ///
    /// If the file cannot be read, is of another format, is damaged, holds no light, is larger than [`Self::MAX_WIDTH`] by
    /// [`Self::MAX_HEIGHT`] pixels or [`Self::MAX_FILE_BYTES`], or is not about twice as wide as high.
    pub fn load(path: &Path) -> Result<Self, PanoramaError> {
        Self::load_problem(path).map_err(|problem| problem.in_file(path.display()))
    }

    /// Reads the bytes of such a file; `name` is what errors call it.
    ///
    /// # Errors
    ///
    /// As [`load`](Self::load).
    pub fn from_bytes(bytes: &[u8], name: &str) -> Result<Self, PanoramaError> {
        decode::decode(Cursor::new(bytes), bytes.len() as u64).map_err(|problem| problem.in_file(name))
    }

    fn load_problem(path: &Path) -> Result<Self, PanoramaProblem> {
        // Before it is opened: opening a pipe that nobody writes to would wait for ever.
        let about = std::fs::metadata(path).map_err(PanoramaProblem::Unreadable)?;
        if about.is_dir() {
            return Err(PanoramaProblem::Folder);
        }
        if !about.is_file() {
            return Err(PanoramaProblem::NoFile);
        }
        let file = File::open(path).map_err(PanoramaProblem::Unreadable)?;
        decode::decode(BufReader::new(file), about.len())
    }
}
