//! How numbers are written.

use super::map::{Map, Raster};
use crate::openexr;
use clap::builder::PossibleValue;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageError};
use std::io;
use std::sync::atomic::{AtomicU64, Ordering};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Exr,
    Exr16,
    Png16,
    Npy,
}

impl clap::ValueEnum for Format {
    fn value_variants<'a>() -> &'a [Self] {
        &[Format::Exr, Format::Exr16, Format::Png16, Format::Npy]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.word()).help(match self {
            Format::Exr => "OpenEXR, 32-bit floats",
            Format::Exr16 => "OpenEXR, 16-bit floats: 1/2000 of each number",
            Format::Png16 => "PNG, 16 bits, between bounds that bake.json tells",
            Format::Npy => "NumPy, 32-bit floats: rows, columns, channels",
        }))
    }
}

/// What 0 and 65535 of a PNG stand for.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub(super) struct Bounds {
    pub(super) black: f64,
    pub(super) white: f64,
}

impl Format {
    pub(super) fn word(self) -> &'static str {
        match self {
            Format::Exr => "exr",
            Format::Exr16 => "exr16",
            Format::Png16 => "png16",
            Format::Npy => "npy",
        }
    }

    pub(super) fn extension(self) -> &'static str {
        match self {
            Format::Exr | Format::Exr16 => "exr",
            Format::Png16 => "png",
            Format::Npy => "npy",
        }
    }

    /// The bytes of a map's file; `cut_off` counts the numbers that the format has no room for.
    pub(super) fn encode(
        self,
        map: Map,
        raster: &Raster,
        bounds: Bounds,
        (about, facts): (&str, &str),
        cut_off: &AtomicU64,
    ) -> io::Result<Vec<u8>> {
        match self {
            Format::Exr | Format::Exr16 => {
                let planes: Vec<(&str, &[f32])> =
                    map.channels().iter().copied().zip(raster.planes.iter().map(Vec::as_slice)).collect();
                openexr::encode_map(raster.size, &planes, self == Format::Exr16, about, facts)
            }
            Format::Png16 => png16(raster, bounds, cut_off),
            Format::Npy => Ok(npy(raster)),
        }
    }
}

/// Grey for one channel, colours for more, of which a third that is not there is 0.
fn png16(raster: &Raster, bounds: Bounds, cut_off: &AtomicU64) -> io::Result<Vec<u8>> {
    let (colors, kind) = match raster.planes.len() {
        1 => (1, ExtendedColorType::L16),
        _ => (3, ExtendedColorType::Rgb16),
    };
    let count = raster.size[0] * raster.size[1];
    let scale = 65_535.0 / (bounds.white - bounds.black);
    let (mut samples, mut cut) = (Vec::with_capacity(2 * colors * count), 0);
    for i in 0..count {
        for color in 0..colors {
            let level = raster.planes.get(color).map_or(0.0, |plane| {
                let level = (f64::from(plane[i]) - bounds.black) * scale;
                cut += u64::from(!(-0.5..=65_535.5).contains(&level));
                level
            });
            // The encoder takes the machine's own order.
            samples.extend_from_slice(&(level.round().clamp(0.0, 65_535.0) as u16).to_ne_bytes());
        }
    }
    cut_off.fetch_add(cut, Ordering::Relaxed);
    let mut bytes = Vec::new();
    PngEncoder::new_with_quality(&mut bytes, CompressionType::Fast, FilterType::Adaptive)
        .write_image(&samples, raster.size[0] as u32, raster.size[1] as u32, kind)
        .map_err(|error| match error {
            ImageError::IoError(error) => error,
            other => io::Error::other(other),
        })?;
    Ok(bytes)
}

/// NumPy's format, version 1.0 (NEP 1): a line that says type and shape, padded to 64 bytes, and the numbers.
fn npy(raster: &Raster) -> Vec<u8> {
    let ([width, height], channels) = (raster.size, raster.planes.len());
    let shape = match channels {
        1 => format!("({height}, {width})"),
        _ => format!("({height}, {width}, {channels})"),
    };
    let header = format!("{{'descr': '<f4', 'fortran_order': False, 'shape': {shape}, }}");
    let padded = (10 + header.len() + 1).next_multiple_of(64) - 10;
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend_from_slice(&(padded as u16).to_le_bytes());
    bytes.extend_from_slice(format!("{header:<width$}\n", width = padded - 1).as_bytes());
    for i in 0..width * height {
        for plane in &raster.planes {
            bytes.extend_from_slice(&plane[i].to_le_bytes());
        }
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn raster() -> Raster {
        Raster::new([3, 2], |i| [i as f32, -0.5, 2.0])
    }

    #[test]
    fn npy_says_its_shape_and_has_the_numbers_in_order() {
        let bytes = npy(&raster());
        assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
        let length = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
        assert_eq!((10 + length) % 64, 0);
        let header = std::str::from_utf8(&bytes[10..10 + length]).unwrap();
        assert!(header.starts_with("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3, 3), }"));
        assert!(header.ends_with('\n'));
        let numbers: Vec<f32> = bytes[10 + length..]
            .chunks_exact(4)
            .map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap()))
            .collect();
        assert_eq!(numbers.len(), 18);
        assert_eq!(numbers[..6], [0.0, -0.5, 2.0, 1.0, -0.5, 2.0]);
    }

    #[test]
    fn png_has_the_numbers_between_its_bounds() {
        let cut_off = AtomicU64::new(0);
        let bytes = png16(&raster(), Bounds { black: -1.0, white: 4.0 }, &cut_off).unwrap();
        let picture = image::load_from_memory(&bytes).unwrap().into_rgb16();
        let number = |x, y, c: usize| -1.0 + 5.0 * f64::from(picture.get_pixel(x, y).0[c]) / 65_535.0;
        assert!((number(2, 0, 0) - 2.0).abs() < 1e-4 && (number(1, 1, 1) + 0.5).abs() < 1e-4);
        // 5 of the six numbers of the first channel is beyond.
        assert_eq!((number(2, 1, 0), cut_off.into_inner()), (4.0, 1));
    }
}
