//! DWA blocks say how large their parts become, and the decoder takes memory for whatever they say.

use exr::block::chunk::{Chunk, CompressedBlock};
use exr::compression::Compression;
use exr::meta::header::Header;

use crate::panorama::decode::Failure;

/// The counters of a block's header that claim unpacked sizes: raw bytes, RLE bytes before and after the second
/// stage, AC and DC coefficients. (`DataSizesSingle` in OpenEXR's `internal_dwa_compressor.h`: eleven 64-bit
/// little-endian counters in all.)
const UNPACKED_SIZES: [usize; 5] = [1, 6, 7, 8, 9];

/// Refuses a DWA block that claims to unpack to more than it can hold pixels for.
pub(super) fn check_claims(chunk: &Chunk, header: &Header) -> Result<(), Failure> {
    if !matches!(header.compression, Compression::DWAA(_) | Compression::DWAB(_)) {
        return Ok(());
    }
    let packed = match &chunk.compressed_block {
        CompressedBlock::ScanLine(block) => &block.compressed_pixels_le,
        CompressedBlock::Tile(block) => &block.compressed_pixels_le,
        _ => return Ok(()), // deep data, which is refused elsewhere
    };
    let place = header.get_block_data_indices(&chunk.compressed_block).map_err(Failure::damaged)?;
    let bounds = header.get_absolute_block_pixel_coordinates(place).map_err(Failure::damaged)?;
    let (width, height) = (bounds.size.width(), bounds.size.height());
    let per_pixel = header.channels.bytes_per_pixel;
    if packed.len() == width * height * per_pixel {
        return Ok(()); // stored as it is, without counters
    }
    // Coefficients come in squares of 8 pixels; run-length codes can be longer than what they stand for, but
    // never twice as long.
    let most = 2 * width.next_multiple_of(8) * height.next_multiple_of(8) * per_pixel;
    let (counters, _) = packed.as_chunks::<8>();
    let claims = UNPACKED_SIZES.iter().filter_map(|&index| counters.get(index));
    for claim in claims.map(|bytes| u64::from_le_bytes(*bytes)) {
        if claim > most as u64 {
            return Err(Failure::damaged(format!(
                "a block claims {claim} bytes for {width} x {height} pixels"
            )));
        }
    }
    Ok(())
}
