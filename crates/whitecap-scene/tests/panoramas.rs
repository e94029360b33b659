//! Panoramas: small pictures in every compression, files that lie, end early or hold values that are no light.

#![allow(clippy::unwrap_used, reason = "a helper of tests may fail as a test may")]

use std::io::Cursor;
use std::path::Path;

use exr::prelude::{
    AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, Image, ImageAttributes,
    IntegerBounds, Layer, LayerAttributes, LineOrder, Vec2, WritableImage, f16,
};
use glam::DVec3;
use image::Rgb;
use image::codecs::hdr::HdrEncoder;
use proptest::prelude::*;
use whitecap_scene::panorama::{Panorama, PanoramaProblem};

const WIDTH: usize = 32;
const HEIGHT: usize = 16;

/// A smooth sky: every format holds it well.
fn light(x: usize, y: usize) -> [f32; 3] {
    [1.0 + x as f32 / 8.0, 0.5 + y as f32 / 8.0, 2.0]
}

fn hdr(header: &str, light: impl Fn(usize, usize) -> [f32; 3]) -> Vec<u8> {
    let pixels: Vec<_> = (0..WIDTH * HEIGHT).map(|i| Rgb(light(i % WIDTH, i / WIDTH))).collect();
    let mut bytes = Vec::new();
    HdrEncoder::new(&mut bytes).encode(&pixels, WIDTH, HEIGHT).unwrap();
    let body = bytes.windows(2).position(|pair| pair == b"\n\n").unwrap();
    [header.as_bytes(), &bytes[body..]].concat()
}

const HDR_HEADER: &str = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe";

/// The layers that most tests write: named channels, each of its own sample type.
type Channels = Vec<(&'static str, FlatSamples)>;

fn layer(
    name: &str,
    compression: Compression,
    blocks: Blocks,
    channels: Channels,
) -> Layer<AnyChannels<FlatSamples>> {
    let channels = channels.into_iter().map(|(name, samples)| AnyChannel::new(name, samples));
    let encoding = Encoding { compression, blocks, line_order: LineOrder::Increasing };
    let attributes = LayerAttributes::named(name);
    Layer::new((WIDTH, HEIGHT), attributes, encoding, AnyChannels::sort(channels.collect()))
}

fn exr(layers: Vec<Layer<AnyChannels<FlatSamples>>>) -> Vec<u8> {
    let bounds = IntegerBounds::from_dimensions((WIDTH, HEIGHT));
    let mut bytes = Cursor::new(Vec::new());
    let image = Image::from_layers(ImageAttributes::new(bounds), layers);
    image.write().non_parallel().to_buffered(&mut bytes).unwrap();
    bytes.into_inner()
}

/// One channel of a picture: 0 red, 1 green, 2 blue.
fn plane(light: impl Fn(usize, usize) -> [f32; 3], channel: usize) -> Vec<f32> {
    (0..WIDTH * HEIGHT).map(|i| light(i % WIDTH, i / WIDTH)[channel]).collect()
}

fn floats(channel: usize) -> FlatSamples {
    FlatSamples::F32(plane(light, channel))
}

fn halves(channel: usize) -> FlatSamples {
    FlatSamples::F16(plane(light, channel).into_iter().map(f16::from_f32).collect())
}

fn rgb(samples: fn(usize) -> FlatSamples) -> Channels {
    vec![("R", samples(0)), ("G", samples(1)), ("B", samples(2))]
}

fn read(bytes: &[u8]) -> Panorama {
    Panorama::from_bytes(bytes, "sky").unwrap()
}

fn problem(bytes: &[u8]) -> String {
    Panorama::from_bytes(bytes, "sky").unwrap_err().to_string()
}

/// Asserts that the picture is `light` within a relative error.
fn assert_is_light(panorama: &Panorama, error: f32) {
    assert_eq!((panorama.width, panorama.height, panorama.repaired), (WIDTH, HEIGHT, 0));
    for (i, pixel) in panorama.pixels.iter().enumerate() {
        for (found, expected) in pixel.iter().zip(light(i % WIDTH, i / WIDTH)) {
            assert!((found - expected).abs() <= error * expected, "pixel {i}: {found} for {expected}");
        }
    }
}

#[test]
fn hdr_round_trip() {
    assert_is_light(&read(&hdr(HDR_HEADER, light)), 0.01);
    assert_is_light(&read(&hdr("#?RGBE\nFORMAT=32-bit_rle_rgbe", light)), 0.01);
}

#[test]
fn hdr_values_are_divided_by_exposure() {
    let header = "#?RADIANCE\nEXPOSURE=4\nEXPOSURE=0.5\nCOLORCORR=1 2 0.5";
    assert_is_light(
        &read(&hdr(header, |x, y| {
            let [red, green, blue] = light(x, y);
            [2.0 * red, 4.0 * green, blue]
        })),
        0.01,
    );
    let header = "#?RADIANCE\nEXPOSURE=0\nCOLORCORR=nan inf -1";
    assert_is_light(&read(&hdr(header, light)), 0.01);
}

#[test]
fn exr_round_trip_in_every_compression() {
    use Compression::*;
    let tiles = Blocks::Tiles(Vec2(8, 8));
    for compression in [Uncompressed, RLE, ZIP1, ZIP16, PIZ, PXR24, B44, B44A, DWAA(None), DWAB(None)] {
        for blocks in [Blocks::ScanLines, tiles] {
            for samples in [floats, halves] {
                let bytes = exr(vec![layer("sky", compression, blocks, rgb(samples))]);
                assert_is_light(&read(&bytes), 0.05);
            }
        }
    }
}

#[test]
fn exr_without_loss_is_exact() {
    let bytes = exr(vec![layer("sky", Compression::ZIP16, Blocks::ScanLines, rgb(floats))]);
    assert_is_light(&read(&bytes), 0.0);
}

#[test]
fn exr_channels_are_found_by_name() {
    let scan_lines = |name: &str, channels| layer(name, Compression::ZIP16, Blocks::ScanLines, channels);
    let depth = || FlatSamples::U32(vec![7; WIDTH * HEIGHT]);

    // Among others, and of mixed types.
    let channels =
        vec![("A", halves(2)), ("B", halves(2)), ("G", floats(1)), ("R", halves(0)), ("Z", depth())];
    assert_is_light(&read(&exr(vec![scan_lines("sky", channels)])), 0.001);
    // In a layer that is not the first; in channels with a layer's name.
    let first = scan_lines("depth", vec![("Z", depth())]);
    assert_is_light(&read(&exr(vec![first.clone(), scan_lines("sky", rgb(floats))])), 0.0);
    let channels = vec![("sky.R", floats(0)), ("sky.G", floats(1)), ("sky.B", floats(2)), ("Y", depth())];
    assert_is_light(&read(&exr(vec![scan_lines("", channels)])), 0.0);

    let grey = read(&exr(vec![scan_lines("sky", vec![("Y", depth())])]));
    assert!(grey.pixels.iter().all(|pixel| *pixel == [7.0; 3]));
    assert_eq!(
        problem(&exr(vec![first])),
        "sky: damaged or not supported OpenEXR: no layer with channels R, G and B, or Y"
    );
}

#[test]
fn a_picture_without_light_is_refused_and_a_glaring_one_is_bounded() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sky.exr");
    let load = |value: f32| {
        exr::prelude::write_rgb_file(&path, 8, 4, |_, _| (value, value, value)).unwrap();
        Panorama::load(&path)
    };
    for dark in [0.0, -3.0, f32::NAN] {
        let message = load(dark).unwrap_err().to_string();
        assert!(
            message.ends_with("without any light: every pixel is 0, negative or not a number"),
            "{message}"
        );
    }
    assert_eq!(load(1e38).unwrap().pixels[0], [65504.0; 3]);
    assert_eq!(load(f32::INFINITY).unwrap().pixels[0], [65504.0; 3]);
}

#[cfg(unix)]
#[test]
fn what_is_no_file_is_refused_before_it_is_opened() {
    let message = Panorama::load(Path::new("/dev/zero")).unwrap_err().to_string();
    assert_eq!(message, "/dev/zero: no ordinary file; accepted: a Radiance HDR or OpenEXR picture");
}

#[test]
fn values_that_are_no_light_are_repaired() {
    let odd = |channel| {
        let mut plane = plane(light, channel);
        plane[..3].copy_from_slice(&[f32::NAN, f32::INFINITY, -1.0]);
        FlatSamples::F32(plane)
    };
    let bytes = exr(vec![layer("sky", Compression::ZIP16, Blocks::ScanLines, rgb(odd))]);
    let panorama = read(&bytes);
    assert_eq!(panorama.repaired, 3);
    assert_eq!(panorama.pixels[..3], [[0.0; 3], [65504.0; 3], [0.0; 3]]);
    assert_eq!(panorama.pixels[3], light(3, 0));
}

#[test]
fn a_file_that_ends_early_is_an_error() {
    let compressed = |compression| exr(vec![layer("sky", compression, Blocks::ScanLines, rgb(halves))]);
    for whole in [
        hdr(HDR_HEADER, light),
        compressed(Compression::PIZ),
        compressed(Compression::Uncompressed),
        compressed(Compression::DWAB(None)),
    ] {
        for length in (0..whole.len()).step_by(7) {
            let error = Panorama::from_bytes(&whole[..length], "sky").unwrap_err();
            assert!(error.to_string().starts_with("sky: "), "{error}");
        }
    }
}

#[test]
fn sizes_are_checked_before_memory_is_taken() {
    let hdr = |width: u32, height: u32| format!("#?RADIANCE\n\n-Y {height} +X {width}\nlittle").into_bytes();
    assert!(problem(&hdr(4_000_000_000, 2_000_000_000)).contains("4000000000x2000000000"));
    assert_eq!(
        problem(&hdr(2_000_000_000, 1_000_000_000)),
        "sky: 2000000000 x 1000000000 pixels; accepted: up to 8192 x 4096"
    );
    assert_eq!(
        problem(&hdr(8192, 4096)),
        "sky: damaged or not supported Radiance HDR: ends too early for 8192 x 4096 pixels"
    );

    let small = exr(vec![layer("sky", Compression::ZIP16, Blocks::ScanLines, rgb(halves))]);
    let claim = |width: i32, height: i32| {
        let mut bytes = small.clone();
        for window in [&b"dataWindow\0box2i\0"[..], b"displayWindow\0box2i\0"] {
            let start = bytes.windows(window.len()).position(|found| found == window).unwrap();
            let corner = start + window.len() + 4 + 8;
            bytes[corner..corner + 4].copy_from_slice(&(width - 1).to_le_bytes());
            bytes[corner + 4..corner + 8].copy_from_slice(&(height - 1).to_le_bytes());
        }
        // The decoder compares the number of blocks: 16 rows each.
        let blocks = bytes.windows(15).position(|found| found == b"chunkCount\0int\0").unwrap() + 15 + 4;
        bytes[blocks..blocks + 4].copy_from_slice(&(height / 16).to_le_bytes());
        bytes
    };
    assert_eq!(
        problem(&claim(1_000_000_000, 500_000_000)),
        "sky: 1000000000 x 500000000 pixels; accepted: up to 8192 x 4096"
    );
    assert_eq!(
        problem(&claim(8192, 4096)),
        "sky: damaged or not supported OpenEXR: ends too early for 8192 x 4096 pixels"
    );
}

#[test]
fn blocks_that_claim_to_unpack_to_too_much_are_refused() {
    let mut bytes = exr(vec![layer("sky", Compression::DWAB(None), Blocks::ScanLines, rgb(halves))]);
    // The table of blocks holds the place of the only block, which follows it: a row, a length, and eleven
    // counters, of which the ninth is the number of coefficients.
    let table = (0..bytes.len() - 8)
        .find(|&at| u64::from_le_bytes(bytes[at..at + 8].try_into().unwrap()) == at as u64 + 8)
        .unwrap();
    let coefficients = table + 8 + (4 + 4) + 8 * 8;
    bytes[coefficients..coefficients + 8].copy_from_slice(&(1_u64 << 50).to_le_bytes());
    assert_eq!(
        problem(&bytes),
        "sky: damaged or not supported OpenEXR: a block claims 1125899906842624 bytes for 32 x 16 pixels"
    );
}

#[test]
fn a_panic_in_a_decoder_is_an_error() {
    // Run lengths that follow each other count in powers of 256; nine overflow where overflow is checked.
    let runs = [1, 1, 1, 0].repeat(9);
    let bytes = [&b"#?RADIANCE\n\n-Y 2 +X 4\n\x08\x08\x08\x80"[..], &runs].concat();
    assert!(problem(&bytes).starts_with("sky: damaged or not supported Radiance HDR: "));
}

#[test]
fn other_shapes_and_formats_are_refused() {
    assert_eq!(
        problem(b"#?RADIANCE\n\n-Y 64 +X 64\n"),
        "sky: 64 x 64 pixels, which is not equirectangular; accepted: about twice as wide as high"
    );
    for bytes in [&b""[..], b"\x89PNG\r\n\x1a\n", b"#", b"v/1"] {
        assert_eq!(problem(bytes), "sky: neither a Radiance HDR nor an OpenEXR picture, by its first bytes");
    }
    for header in [&b"#?RADIANCE"[..], b"#?RADIANCE\n", b"#?RADIANCE\n\n", b"#?RADIANCE\n\n-Y 1 +X 2"] {
        assert_eq!(
            problem(header),
            "sky: damaged or not supported Radiance HDR: no header, or one without an end"
        );
    }
}

#[test]
fn files_are_told_apart_by_their_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sky.exr");
    std::fs::write(&path, hdr(HDR_HEADER, light)).unwrap();
    assert_is_light(&Panorama::load(&path).unwrap(), 0.01);

    let error = Panorama::load(folder.path()).unwrap_err();
    assert!(matches!(error.problem, PanoramaProblem::Folder), "{error}");
    let error = Panorama::load(Path::new("no/such/sky.hdr")).unwrap_err();
    assert!(error.to_string().starts_with("no/such/sky.hdr: cannot be read: "), "{error}");
}

/// A sky that shows each direction as a colour.
fn directions() -> Panorama {
    let (width, height) = (256, 128);
    let mut pixels = Vec::new();
    for y in 0..height {
        for x in 0..width {
            let azimuth = ((x as f64 + 0.5) / width as f64 - 0.5) * std::f64::consts::TAU;
            let (sin, cos) = ((y as f64 + 0.5) / height as f64 * std::f64::consts::PI).sin_cos();
            let direction = DVec3::new(sin * azimuth.sin(), cos, -sin * azimuth.cos());
            pixels.push(direction.as_vec3().to_array());
        }
    }
    Panorama { width, height, pixels, repaired: 0 }
}

#[test]
fn the_middle_looks_north_and_east_is_to_its_right() {
    let sky = directions();
    for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
        for direction in [axis, -axis] {
            let seen = DVec3::from(glam::Vec3::from(sky.sample(direction)));
            assert!(seen.distance(direction) < 0.02, "{seen} in {direction}");
        }
    }
    let half = Panorama { width: 4, height: 2, pixels: vec![[0.0; 3]; 8], repaired: 0 };
    let column = |x: usize| {
        let mut sky = half.clone();
        sky.pixels[x] = [1.0; 3];
        sky.pixels[x + 4] = [1.0; 3];
        sky
    };
    // Columns from the left: from south over west to north, and on over east to south.
    assert_eq!(column(1).sample(DVec3::new(-1.0, 0.0, -1.0)), [1.0; 3]);
    assert_eq!(column(2).sample(DVec3::new(1.0, 0.0, -1.0)), [1.0; 3]);
    // The seam in the south is halfway between the last and the first column.
    assert_eq!(column(0).sample(DVec3::Z), [0.5; 3]);
    assert_eq!(column(3).sample(DVec3::new(-0.0, 0.0, 1.0)), [0.5; 3]);
}

proptest! {
    #[test]
    fn a_sample_shows_its_direction(x in -1.0..1.0, y in -1.0..1.0, z in -1.0..1.0, length in 1e-6..1e6) {
        let direction = DVec3::new(x, y, z);
        prop_assume!(direction.length() > 1e-3);
        let seen = DVec3::from(glam::Vec3::from(directions().sample(direction * length)));
        prop_assert!(seen.distance(direction.normalize()) < 0.02);
    }

    #[test]
    fn no_bytes_panic(bytes in prop::collection::vec(any::<u8>(), 0..300), format in 0..3usize) {
        let begin = [&b"#?RADIANCE\n\n-Y 4 +X 8\n"[..], &[0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0], b""][format];
        let _ = Panorama::from_bytes(&[begin, &bytes].concat(), "sky");
    }

    #[test]
    fn no_changed_byte_panics(position in 0.0..1.0, value in any::<u8>(), compression in 0..4usize) {
        use Compression::*;
        let compression = [PIZ, ZIP16, B44, DWAA(None)][compression];
        let mut bytes = exr(vec![layer("sky", compression, Blocks::ScanLines, rgb(halves))]);
        let position = (position * bytes.len() as f64) as usize;
        bytes[position] = value;
        let _ = Panorama::from_bytes(&bytes, "sky");
    }
}
