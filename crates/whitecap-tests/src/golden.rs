//! Golden pictures: somebody looked at them, and every change is measured against them.
//!
//! A golden never makes itself. A missing one is a failure that says how to make it, because a test that
//! writes what it then compares with has tested nothing.

use crate::compare::{Report, Tolerance, compare};
use crate::repository;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, RgbImage};
use std::path::{Path, PathBuf};
use whitecap_render::picture::Picture;

/// Set by `cargo xtask goldens`: pictures are written instead of compared.
pub const UPDATE: &str = "WHITECAP_UPDATE_GOLDENS";

/// The most pixels across and down: the repository keeps every version of every golden for ever.
pub const MOST_PIXELS: [u32; 2] = [320, 180];
/// The most bytes of one golden's file.
pub const MOST_BYTES: usize = 64 * 1024;

/// Why a picture is not its golden.
#[derive(Debug, thiserror::Error)]
pub enum Mismatch {
    /// There is no golden.
    #[error(
        "there is no golden picture {path}; `cargo xtask goldens` makes it, and somebody must look at it"
    )]
    Missing {
        /// Where it would be.
        path: PathBuf,
    },
    /// The golden has another size.
    #[error("the golden {path} is {golden:?} pixels large and the picture {picture:?}")]
    Size {
        /// The golden's file.
        path: PathBuf,
        /// Its width and height.
        golden: (u32, u32),
        /// The picture's.
        picture: (u32, u32),
    },
    /// The picture looks different.
    #[error("the picture differs from {path}: {report}. Compare it with {picture}")]
    Different {
        /// The golden's file.
        path: PathBuf,
        /// By how much.
        report: Report,
        /// Where the picture was left to be looked at.
        picture: PathBuf,
    },
    /// The picture is too large to become a golden.
    #[error("{path} would be {found}; accepted: up to {accepted}")]
    TooLarge {
        /// The golden's file.
        path: PathBuf,
        /// How large it would be.
        found: String,
        /// How large it may be.
        accepted: String,
    },
    /// A file could not be read or written.
    #[error("{path}: {cause}")]
    File {
        /// The file.
        path: PathBuf,
        /// What the system or the decoder said.
        cause: image::ImageError,
    },
}

/// A folder of golden pictures.
#[derive(Clone, Debug)]
pub struct Goldens {
    folder: PathBuf,
    /// Where pictures that differ are left.
    differing: PathBuf,
    updating: bool,
}

impl Goldens {
    /// Those of the repository, written anew if [`UPDATE`] is set.
    pub fn of_repository() -> Self {
        Goldens {
            folder: repository::root().join("crates/whitecap-tests/goldens"),
            differing: repository::root().join("out/goldens"),
            updating: std::env::var_os(UPDATE).is_some_and(|value| value == "1"),
        }
    }

    /// Those in `folder`, which are only compared with; pictures that differ go to `differing`.
    pub fn in_folder(folder: &Path, differing: &Path) -> Self {
        Goldens { folder: folder.to_owned(), differing: differing.to_owned(), updating: false }
    }

    /// The same folder, with every picture written instead of compared.
    pub fn updating(self) -> Self {
        Goldens { updating: true, ..self }
    }

    /// Where the goldens are.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Compares `picture` with the golden called `name`.
    ///
    /// # Errors
    ///
    /// If there is no such golden, or the picture is not like it.
    pub fn check(&self, name: &str, picture: &Picture) -> Result<(), Mismatch> {
        let path = self.folder.join(format!("{name}.png"));
        let picture = without_alpha(picture);
        if self.updating {
            return write_golden(&path, &picture);
        }
        if !path.exists() {
            return Err(Mismatch::Missing { path });
        }
        let golden =
            image::open(&path).map_err(|cause| Mismatch::File { path: path.clone(), cause })?.to_rgb8();
        let Some(report) = compare(&golden, &picture) else {
            return Err(Mismatch::Size { path, golden: golden.dimensions(), picture: picture.dimensions() });
        };
        if report.is_within(&Tolerance::default()) {
            return Ok(());
        }
        let left = self.differing.join(format!("{name}.png"));
        write(&left, &encode(&left, &picture)?)?;
        Err(Mismatch::Different { path, report, picture: left })
    }
}

fn without_alpha(picture: &Picture) -> RgbImage {
    let pixel = |x: u32, y: u32| {
        let at = 4 * (y as usize * picture.width as usize + x as usize);
        image::Rgb([picture.rgba8[at], picture.rgba8[at + 1], picture.rgba8[at + 2]])
    };
    RgbImage::from_fn(picture.width, picture.height, pixel)
}

fn write_golden(path: &Path, picture: &RgbImage) -> Result<(), Mismatch> {
    let too_large =
        |found: String, accepted: String| Mismatch::TooLarge { path: path.to_owned(), found, accepted };
    let [width, height] = MOST_PIXELS;
    if picture.width() > width || picture.height() > height {
        let found = format!("{} × {} pixels", picture.width(), picture.height());
        return Err(too_large(found, format!("{width} × {height}")));
    }
    let bytes = encode(path, picture)?;
    if bytes.len() > MOST_BYTES {
        return Err(too_large(format!("{} bytes", bytes.len()), MOST_BYTES.to_string()));
    }
    write(path, &bytes)
}

fn encode(path: &Path, picture: &RgbImage) -> Result<Vec<u8>, Mismatch> {
    let mut bytes = Vec::new();
    PngEncoder::new_with_quality(&mut bytes, CompressionType::Best, FilterType::Adaptive)
        .write_image(picture.as_raw(), picture.width(), picture.height(), ExtendedColorType::Rgb8)
        .map_err(|cause| Mismatch::File { path: path.to_owned(), cause })?;
    Ok(bytes)
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), Mismatch> {
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder)
        .and_then(|()| std::fs::write(path, bytes))
        .map_err(|cause| Mismatch::File { path: path.to_owned(), cause: cause.into() })
}
