//! Radiance HDR: RGBE pixels, run-length coded row by row.

use std::io::{Read, SeekFrom};

use image::ImageDecoder;
use image::codecs::hdr::HdrDecoder;

use super::decode::{Failure, Input, Picture, Size};

/// The longest header that is read, bytes. Real ones have a few hundred.
const MAX_HEADER_BYTES: u64 = 1 << 16;

pub(super) fn decode(input: &mut dyn Input, length: u64) -> Result<Picture, Failure> {
    check_header_ends(input)?;
    // "Non-strict" accepts the signature `#?RGBE`, which is as common as `#?RADIANCE`.
    let decoder = HdrDecoder::new_nonstrict(&mut *input).map_err(Failure::damaged)?;
    let (width, height) = decoder.dimensions();
    let size = Size::checked(width as usize, height as usize)?;
    if length < fewest_bytes(size) {
        return Err(Failure::damaged(format!("ends too early for {width} x {height} pixels")));
    }
    let about = decoder.metadata();
    let mut pixels = size.black();
    decoder.read_image(bytemuck::cast_slice_mut(&mut pixels)).map_err(Failure::damaged)?;

    // By the format, stored values are radiance times EXPOSURE and times COLORCORR.
    let exposure = usable(about.exposure.unwrap_or(1.0));
    let (red, green, blue) = about.color_correction.unwrap_or((1.0, 1.0, 1.0));
    let divisor = [red, green, blue].map(|correction| usable(correction * exposure));
    if divisor != [1.0; 3] {
        for pixel in &mut pixels {
            *pixel = std::array::from_fn(|channel| pixel[channel] / divisor[channel]);
        }
    }
    Ok(Picture { size, pixels })
}

/// The decoder reads header lines of any length; a file that is all one line must not fill the memory.
fn check_header_ends(input: &mut dyn Input) -> Result<(), Failure> {
    let mut head = Vec::new();
    (&mut *input).take(MAX_HEADER_BYTES).read_to_end(&mut head).map_err(Failure::damaged)?;
    input.seek(SeekFrom::Start(0)).map_err(Failure::damaged)?;
    let end = head.windows(2).position(|pair| pair == b"\n\n");
    let size_follows = end.is_some_and(|end| head[end + 2..].contains(&b'\n'));
    if size_follows { Ok(()) } else { Err(Failure::damaged("no header, or one without an end")) }
}

/// The fewest bytes that can hold a picture of this size: each row a pixel and one or two run lengths.
fn fewest_bytes(size: Size) -> u64 {
    let runs = if size.width <= 256 { usize::from(size.width > 1) } else { 2 };
    (size.height * 4 * (1 + runs)) as u64
}

/// A factor that can be divided by; others are as good as none.
fn usable(factor: f32) -> f32 {
    if factor.is_normal() && factor > 0.0 { factor } else { 1.0 }
}
