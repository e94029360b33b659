//! From bytes to a checked picture: the format, the limits, the repairs.

use std::io::{self, Read, Seek};
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::{Panorama, PanoramaProblem, exr, hdr};

/// The largest value that a 16-bit float holds: what stands for infinity.
const LARGEST_HALF: f32 = 65504.0;

/// A format: its name, how its files begin, and its decoder.
struct Format {
    name: &'static str,
    magic: &'static [u8],
    decode: fn(&mut dyn Input, u64) -> Result<Picture, Failure>,
}

const FORMATS: [Format; 2] = [
    Format { name: "Radiance HDR", magic: b"#?", decode: |input, length| hdr::decode(input, length) },
    Format {
        name: "OpenEXR",
        magic: &[0x76, 0x2f, 0x31, 0x01],
        decode: |input, length| exr::decode(input, length),
    },
];

/// Where a picture comes from.
pub(super) trait Input: io::BufRead + Seek {}

impl<T: io::BufRead + Seek> Input for T {}

/// A picture as its decoder hands it over, with whatever values the file has.
pub(super) struct Picture {
    pub(super) size: Size,
    pub(super) pixels: Vec<[f32; 3]>,
}

/// A size that has been checked: not zero, not too large, about twice as wide as high.
#[derive(Clone, Copy)]
pub(super) struct Size {
    pub(super) width: usize,
    pub(super) height: usize,
}

/// Why a decoder gave up.
pub(super) enum Failure {
    /// The picture has a size that is not accepted.
    Refused(PanoramaProblem),
    /// The file is damaged, in the decoder's words.
    Damaged(String),
}

impl Failure {
    pub(super) fn damaged(explanation: impl ToString) -> Self {
        Self::Damaged(explanation.to_string())
    }
}

impl Size {
    /// Checks the size that a header claims, before memory is set aside for it.
    pub(super) fn checked(width: usize, height: usize) -> Result<Self, Failure> {
        if width > Panorama::MAX_WIDTH || height > Panorama::MAX_HEIGHT {
            return Err(Failure::Refused(PanoramaProblem::TooLarge { width, height }));
        }
        // Written so that 0 x 0 is refused too.
        if height > 0 && (1.9..=2.1).contains(&(width as f64 / height as f64)) {
            Ok(Self { width, height })
        } else {
            Err(Failure::Refused(PanoramaProblem::NotEquirectangular { width, height }))
        }
    }

    pub(super) fn black(self) -> Vec<[f32; 3]> {
        vec![[0.0; 3]; self.width * self.height]
    }
}

/// Decodes `length` bytes of either format.
pub(super) fn decode(mut input: impl Input, length: u64) -> Result<Panorama, PanoramaProblem> {
    if length > Panorama::MAX_FILE_BYTES {
        return Err(PanoramaProblem::FileTooLong { bytes: length });
    }
    let mut head = Vec::new();
    input.by_ref().take(4).read_to_end(&mut head).map_err(PanoramaProblem::Unreadable)?;
    input.rewind().map_err(PanoramaProblem::Unreadable)?;
    let format = FORMATS.iter().find(|format| head.starts_with(format.magic));
    let format = format.ok_or(PanoramaProblem::UnknownFormat)?;

    // The decoders are other people's and meet hostile files; some of their arithmetic and indexing panics on
    // them. A damaged file is the user's finding, not a fault of the program. Nothing that a decoder leaves
    // half-done survives: its input and its picture are dropped here.
    let decoded = catch_unwind(AssertUnwindSafe(|| (format.decode)(&mut input, length)));
    let damaged = |explanation| PanoramaProblem::Damaged { format: format.name, explanation };
    match decoded {
        Ok(Ok(picture)) => {
            let picture = repaired(picture);
            let lit = picture.pixels.iter().any(|pixel| *pixel != [0.0; 3]);
            if lit { Ok(picture) } else { Err(PanoramaProblem::Dark) }
        }
        Ok(Err(Failure::Refused(problem))) => Err(problem),
        Ok(Err(Failure::Damaged(explanation))) => Err(damaged(explanation)),
        Err(_) => Err(damaged("its contents contradict each other".to_owned())),
    }
}

/// Replaces what is no radiance, and counts the pixels that had such values.
fn repaired(Picture { size: Size { width, height }, mut pixels }: Picture) -> Panorama {
    let mut repaired = 0;
    for pixel in &mut pixels {
        let is_radiance = |value: &f32| (0.0..=LARGEST_HALF).contains(value);
        if !pixel.iter().all(is_radiance) {
            repaired += 1;
            *pixel = pixel.map(|value| if value.is_nan() { 0.0 } else { value.clamp(0.0, LARGEST_HALF) });
        }
    }
    Panorama { width, height, pixels, repaired }
}
