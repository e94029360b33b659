//! Light, and what pictures show beside it, as OpenEXR: compressed without loss (ZIP). Baked maps, as they are.
//!
//! Equal pictures give equal bytes. The `exr` crate writes attributes of its own order only where it knows their names;
//! of others a header takes one from the layer and one from the image.

use exr::meta::attribute::Chromaticities;
use exr::prelude::{
    AnyChannel, AnyChannels, AttributeValue, Blocks, Compression, Encoding, FlatSamples, Image,
    ImageAttributes, IntegerBounds, Layer, LayerAttributes, LineOrder, Text, Vec2, WritableImage, f16,
};
use glam::{Mat4, Vec3};
use std::io::{self, Cursor};
use whitecap_render::picture::{AuxPicture, LightPicture, LightUnit, Shows};

/// The attribute that says what light is measured in.
const UNIT: &str = "whitecapUnit";

/// The attribute that says what light of 1 becomes in a picture whose white is 1, before its tone map.
const EXPOSURE: &str = "whitecapExposure";

/// Rec. ITU-R BT.709, section 1.
const REC_709: Chromaticities = Chromaticities {
    red: Vec2(0.64, 0.33),
    green: Vec2(0.3, 0.6),
    blue: Vec2(0.15, 0.06),
    white: Vec2(0.3127, 0.329),
};

/// Encodes `picture` into memory; `about` says in words where it comes from.
pub(crate) fn encode(picture: &LightPicture, about: &str) -> io::Result<Vec<u8>> {
    let size = Vec2(picture.width as usize, picture.height as usize);
    let channel = |name: &str, channel: usize| {
        let samples = picture.rgb.iter().map(|rgb| rgb[channel]).collect();
        AnyChannel::new(name, FlatSamples::F32(samples))
    };
    let channels = vec![channel("R", 0), channel("G", 1), channel("B", 2)];
    let mut layer = layer_attributes(about);
    let mut image = ImageAttributes::new(IntegerBounds::from_dimensions(size));
    image.chromaticities = Some(REC_709);
    let unit = match picture.unit {
        LightUnit::KilocandelaPerSquareMetre => "kcd/m^2",
        LightUnit::Panorama => "of the panorama",
        LightUnit::DisplayWhite => "white of a display",
    };
    // Standard: what luminance, in cd/m², white has.
    layer.white_luminance = (picture.unit == LightUnit::KilocandelaPerSquareMetre).then_some(1000.0);
    layer.other.insert(Text::from(EXPOSURE), AttributeValue::F32(picture.exposure));
    image.other.insert(Text::from(UNIT), AttributeValue::Text(Text::from(unit)));
    write(size, layer, image, channels, Compression::ZIP16)
}

/// The attribute that says what positions are relative to, in the world, metres.
const ORIGIN: &str = "whitecapOrigin";

/// Channels of [`encode_aux`]: those that every technique has, and those of techniques in linear light.
pub(crate) const AUX_CHANNELS: [&str; 8] =
    ["Z", "distance.Z", "P.X", "P.Y", "P.Z", "water.X", "object.X", "sky.X"];
pub(crate) const SHADING_CHANNELS: [&str; 4] = ["N.X", "N.Y", "N.Z", "glint.X"];

/// Encodes what a picture shows beside its light into memory, as channels of one layer: lengths and normals as 32-bit
/// floats, masks as 16-bit floats. Names are those that Blender gives its passes; `worldToCamera` and `worldToNDC` are
/// OpenEXR's, with camera and device space as in RenderMan, for positions from the origin.
pub(crate) fn encode_aux(picture: &AuxPicture, about: &str) -> io::Result<Vec<u8>> {
    let size = Vec2(picture.width as usize, picture.height as usize);
    let mask = |wanted: Shows| {
        let is_it = picture.shows.iter().map(|shows| f16::from_f32(f32::from(u8::from(*shows == wanted))));
        FlatSamples::F16(is_it.collect())
    };
    let axis = |of: &[[f32; 3]], axis: usize| FlatSamples::F32(of.iter().map(|v| v[axis]).collect());
    let position = |i| axis(&picture.position_m, i);
    let samples = [
        FlatSamples::F32(picture.depth_m.clone()),
        FlatSamples::F32(picture.distance_m.clone()),
        position(0),
        position(1),
        position(2),
        mask(Shows::Water),
        mask(Shows::Object),
        mask(Shows::Sky),
    ];
    let mut channels: Vec<_> =
        AUX_CHANNELS.into_iter().zip(samples).map(|(name, samples)| AnyChannel::new(name, samples)).collect();
    if let Some(shading) = &picture.shading {
        let normal = |i| axis(&shading.normal, i);
        let glint = FlatSamples::F16(shading.glint.iter().map(|share| f16::from_f32(*share)).collect());
        let samples = [normal(0), normal(1), normal(2), glint];
        channels.extend(
            SHADING_CHANNELS.into_iter().zip(samples).map(|(name, samples)| AnyChannel::new(name, samples)),
        );
    }
    let mut layer = layer_attributes(about);
    // The camera's z runs forwards, the device's x and y from the top left corner to 1.
    let forwards = Mat4::from_scale(Vec3::new(1.0, 1.0, -1.0));
    let from_corner =
        Mat4::from_translation(Vec3::new(0.5, 0.5, 0.0)) * Mat4::from_scale(Vec3::new(0.5, -0.5, 1.0));
    // OpenEXR's vectors are rows, so its rows are our columns.
    layer.world_to_camera = Some((forwards * picture.view_from_position).to_cols_array());
    layer.world_to_normalized_device = Some((from_corner * picture.clip_from_position).to_cols_array());
    let [x, y, z] = picture.origin_m.as_vec3().to_array();
    layer.other.insert(Text::from(ORIGIN), AttributeValue::FloatVec3((x, y, z)));
    write(
        size,
        layer,
        ImageAttributes::new(IntegerBounds::from_dimensions(size)),
        channels,
        Compression::ZIP16,
    )
}

/// Encodes a map of numbers into memory: planes by channel, as 32-bit or as 16-bit floats. `about` says in words where it comes
/// from, `facts` the same for programs, in the attribute [`FACTS`].
pub(crate) fn encode_map(
    size: [usize; 2],
    planes: &[(&str, &[f32])],
    halves: bool,
    about: &str,
    facts: &str,
) -> io::Result<Vec<u8>> {
    let channels = planes.iter().map(|(name, plane)| {
        let samples = match halves {
            true => FlatSamples::F16(plane.iter().map(|value| f16::from_f32(*value)).collect()),
            false => FlatSamples::F32(plane.to_vec()),
        };
        // Lengths and slopes, not light: no eye judges them.
        AnyChannel { quantize_linearly: true, ..AnyChannel::new(*name, samples) }
    });
    let (channels, mut layer) = (channels.collect(), layer_attributes(about));
    layer.other.insert(Text::from(FACTS), AttributeValue::Text(Text::from(facts)));
    let size = Vec2(size[0], size[1]);
    write(
        size,
        layer,
        ImageAttributes::new(IntegerBounds::from_dimensions(size)),
        channels,
        Compression::Uncompressed,
    )
}

/// The attribute of a map that says in JSON what its numbers are.
pub(crate) const FACTS: &str = "whitecap";

fn layer_attributes(about: &str) -> LayerAttributes {
    LayerAttributes {
        comments: Some(Text::from(about)),
        software_name: Some(Text::from(concat!("whitecap ", env!("CARGO_PKG_VERSION")))),
        ..Default::default()
    }
}

fn write(
    size: Vec2<usize>,
    layer: LayerAttributes,
    image: ImageAttributes,
    channels: Vec<AnyChannel<FlatSamples>>,
    compression: Compression,
) -> io::Result<Vec<u8>> {
    let encoding = Encoding { compression, blocks: Blocks::ScanLines, line_order: LineOrder::Increasing };
    let channels = AnyChannels::sort(channels.into_iter().collect());
    let layer = Layer::new(size, layer, encoding, channels);
    let mut bytes = Cursor::new(Vec::new());
    Image::new(image, layer).write().to_buffered(&mut bytes).map_err(|error| match error {
        exr::error::Error::Io(error) => error,
        other => io::Error::other(other),
    })?;
    Ok(bytes.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;
    use exr::prelude::{ReadChannels, ReadLayers, read};

    fn picture() -> LightPicture {
        let rgb = (0..48 * 20).map(|i| [i as f32 * 0.37, 1.6e6, -0.25]).collect();
        let unit = LightUnit::KilocandelaPerSquareMetre;
        LightPicture { width: 48, height: 20, rgb, unit, exposure: 0.0321 }
    }

    #[test]
    fn light_comes_back_to_the_bit_with_its_measure() {
        let picture = picture();
        let bytes = encode(&picture, "a sea").unwrap();
        let image = read()
            .no_deep_data()
            .largest_resolution_level()
            .all_channels()
            .first_valid_layer()
            .all_attributes()
            .from_buffered(Cursor::new(&bytes))
            .unwrap();
        let attributes = &image.layer_data.attributes;
        assert_eq!(attributes.white_luminance, Some(1000.0));
        assert_eq!(attributes.comments, Some(Text::from("a sea")));
        assert_eq!(attributes.other[&Text::from(EXPOSURE)], AttributeValue::F32(0.0321));
        assert_eq!(image.attributes.chromaticities, Some(REC_709));
        let names: Vec<String> =
            image.layer_data.channel_data.list.iter().map(|channel| channel.name.to_string()).collect();
        assert_eq!(names, ["B", "G", "R"]);
        for (channel, index) in image.layer_data.channel_data.list.iter().zip([2, 1, 0]) {
            let FlatSamples::F32(samples) = &channel.sample_data else { panic!() };
            assert!(samples.iter().eq(picture.rgb.iter().map(|rgb| &rgb[index])));
        }
    }

    #[test]
    fn equal_pictures_are_equal_files() {
        let first = encode(&picture(), "a sea").unwrap();
        for _ in 0..8 {
            assert!(encode(&picture(), "a sea").unwrap() == first);
        }
    }

    #[test]
    fn light_of_a_display_claims_no_luminance() {
        let picture = LightPicture { unit: LightUnit::DisplayWhite, exposure: 1.0, ..picture() };
        let bytes = encode(&picture, "").unwrap();
        let meta = exr::meta::MetaData::read_from_buffered(Cursor::new(bytes), true).unwrap();
        assert_eq!(meta.headers[0].own_attributes.white_luminance, None);
        assert!(meta.headers[0].shared_attributes.chromaticities.is_some());
    }
}
