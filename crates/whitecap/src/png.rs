//! Pictures as PNG.

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageError};
use std::io;
use whitecap_render::picture::Picture;

/// Encodes `picture` into memory, compressed for speed: a picture is looked at or read by a program far
/// more often than it is kept.
pub(crate) fn encode(picture: &Picture) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    PngEncoder::new_with_quality(&mut bytes, CompressionType::Fast, FilterType::Adaptive)
        .write_image(&picture.rgba8, picture.width, picture.height, ExtendedColorType::Rgba8)
        .map_err(|error| match error {
            ImageError::IoError(error) => error,
            other => io::Error::other(other),
        })?;
    Ok(bytes)
}
