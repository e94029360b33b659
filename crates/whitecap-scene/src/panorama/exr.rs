//! OpenEXR: the first layer with red, green and blue, or else with luminance.

mod dwa;

use exr::block::UncompressedBlock;
use exr::block::reader::ChunksReader;
use exr::meta::attribute::{ChannelDescription, SampleType};
use exr::meta::header::Header;
use exr::prelude::f16;

use super::decode::{Failure, Input, Picture, Size};

/// The largest block (rows or tile) that is decoded, bytes. Real ones have a few million.
const MAX_BLOCK_BYTES: usize = 1 << 30;

pub(super) fn decode(input: &mut dyn Input, length: u64) -> Result<Picture, Failure> {
    let reader = exr::block::read(input, false).map_err(Failure::damaged)?;
    let (layer, header, channels) = find_layer(reader.headers())
        .ok_or_else(|| Failure::damaged("no layer with channels R, G and B, or Y"))?;
    let size = check_layer(header)?;
    let blocks: usize = reader.headers().iter().map(|header| header.chunk_count).sum();
    if (blocks as u64).saturating_mul(size_of::<u64>() as u64) > length {
        let Size { width, height } = size;
        return Err(Failure::damaged(format!("ends too early for {width} x {height} pixels")));
    }

    let is_wanted = |of_layer, level| of_layer == layer && level == exr::math::Vec2(0, 0);
    let mut blocks = reader
        .filter_chunks(false, |_, _, block| is_wanted(block.layer, block.level))
        .map_err(Failure::damaged)?;
    let mut pixels = size.black();
    // One thread: a panic on another could not be caught.
    while let Some(chunk) = blocks.read_next_chunk() {
        let chunk = chunk.map_err(Failure::damaged)?;
        let meta = blocks.meta_data();
        if chunk.layer_index != layer {
            return Err(Failure::damaged("the table of blocks leads to a block of another layer"));
        }
        let header = &meta.headers[layer];
        dwa::check_claims(&chunk, header)?;
        let block = UncompressedBlock::decompress_chunk(chunk, meta, false).map_err(Failure::damaged)?;
        if !is_wanted(block.index.layer, block.index.level) {
            return Err(Failure::damaged("the table of blocks leads to a block of another size"));
        }
        copy(&block, header, &channels, size, &mut pixels);
    }
    Ok(Picture { size, pixels })
}

/// Which channel of the file goes to red, green and blue.
type Rgb = [usize; 3];

/// The first layer with red, green and blue; or else the first with luminance.
fn find_layer(headers: &[Header]) -> Option<(usize, &Header, Rgb)> {
    let find = |channels_of: fn(&Header) -> Option<Rgb>| {
        let with_channels = |(index, header)| Some((index, header, channels_of(header)?));
        headers.iter().enumerate().find_map(with_channels)
    };
    find(colour).or_else(|| find(|header| channel(header, "Y").map(|y| [y; 3])))
}

/// The channels R, G and B, with the prefix of the first layer that has all three (`beauty.R` …) if any.
fn colour(header: &Header) -> Option<Rgb> {
    let names = header.channels.list.iter().map(|channel| channel.name.to_string());
    let prefixes = names.filter_map(|name| {
        let prefix = name.strip_suffix('R')?;
        (prefix.is_empty() || prefix.ends_with('.')).then(|| prefix.to_owned())
    });
    prefixes.into_iter().find_map(|prefix| {
        let rgb = ["R", "G", "B"].map(|letter| channel(header, &format!("{prefix}{letter}")));
        Some([rgb[0]?, rgb[1]?, rgb[2]?])
    })
}

fn channel(header: &Header, name: &str) -> Option<usize> {
    header.channels.list.iter().position(|channel| channel.name.eq(name))
}

/// Checks what the header claims, before memory is set aside for it.
fn check_layer(header: &Header) -> Result<Size, Failure> {
    let size = Size::checked(header.layer_size.width(), header.layer_size.height())?;
    if header.layer_size != header.shared_attributes.display_window.size {
        return Err(Failure::damaged("its data window is not its display window: cropped or with overscan"));
    }
    let block = header.max_block_pixel_size();
    let bytes =
        [block.width().min(size.width), block.height().min(size.height), header.channels.bytes_per_pixel]
            .into_iter()
            .try_fold(1_usize, usize::checked_mul);
    match bytes {
        Some(bytes) if bytes <= MAX_BLOCK_BYTES => Ok(size),
        _ => Err(Failure::damaged("its blocks are too large")),
    }
}

/// Copies the wanted channels of a block to their places in the picture.
fn copy(block: &UncompressedBlock, header: &Header, rgb: &Rgb, size: Size, pixels: &mut [[f32; 3]]) {
    for line in block.lines(&header.channels) {
        let description = &header.channels.list[line.location.channel];
        let start = line.location.position.y() * size.width + line.location.position.x();
        for (channel, _) in rgb.iter().enumerate().filter(|(_, from)| **from == line.location.channel) {
            for (pixel, sample) in pixels[start..].iter_mut().zip(samples(line.value, description)) {
                pixel[channel] = sample;
            }
        }
    }
}

/// The samples of a line, which the decoder hands over in the machine's byte order.
fn samples<'a>(bytes: &'a [u8], channel: &ChannelDescription) -> impl Iterator<Item = f32> + use<'a> {
    let (width, convert): (usize, fn(&[u8]) -> f32) = match channel.sample_type {
        SampleType::F16 => (2, |bytes| f16::from_ne_bytes([bytes[0], bytes[1]]).to_f32()),
        SampleType::F32 => (4, |bytes| f32::from_ne_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])),
        SampleType::U32 => (4, |bytes| u32::from_ne_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]) as f32),
    };
    bytes.chunks_exact(width).map(convert)
}
