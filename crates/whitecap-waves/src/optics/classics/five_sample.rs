//! The ocean in five texture samples (Berglund, "Ocean shader", a work log): its final shader.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | c | texture coordinate of the water, in a unit of the caller's choice |
//! | τ | seconds in which a layer scrolls by one tile, for u and for v |
//! | N, V | unit normal and unit vector to the eye, y up |
//! | R | the sun's direction reflected at N |

use glam::{DVec2, DVec3};

/// What the shader's uniforms and literals say.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FiveSampleConstants {
    /// The power of the sun's glint.
    pub exponent: f64,
    /// The water's own light, scattered back from below.
    pub emission: [f64; 3],
    /// What reflections are multiplied by.
    pub reflection: [f64; 3],
    /// The sun's brightness: "fake HDR", 7 in the source.
    pub sun: f64,
}

/// The values of the source's material file.
pub const FIVE_SAMPLE_DEFAULTS: FiveSampleConstants =
    FiveSampleConstants { exponent: 40.0, emission: [0.1, 0.15, 0.12], reflection: [0.65; 3], sun: 7.0 };

impl Default for FiveSampleConstants {
    fn default() -> Self {
        FIVE_SAMPLE_DEFAULTS
    }
}

/// Scale, whether turned by 45° (and stretched by √2), and τ of the five layers.
const LAYERS: [(f64, bool, DVec2); 5] = [
    (5.0, false, DVec2::new(200.0, 166.0)),
    (31.0, false, DVec2::new(94.0, 70.0)),
    (67.0, true, DVec2::new(56.0, 34.0)),
    (203.0, false, DVec2::new(100.0, 20.0)),
    (123.0, true, DVec2::new(60.0, 57.0)),
];

/// What becomes of a pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FiveSamplePixel {
    /// N.
    pub normal: DVec3,
    /// R.
    pub reflection: DVec3,
    /// (1 − N·V)², above 1 where N is turned away.
    pub fresnel: f64,
    /// The sun's glint, in all channels.
    pub sun: f64,
    /// 1 − V·y, where the sky is looked up: 0 straight down, 1 at the horizon.
    pub sky_address: f64,
    /// What is written, not clamped: above 1 in the glint.
    pub color: DVec3,
}

/// Where the map is read for each layer.
///
/// Coordinates are reduced by whole tiles of each layer's scroll only; far out, hand in a `tex_coord` near 0.
/// A shift of `tex_coord` by whole numbers changes nothing that a repeating map shows, since every scale is a
/// whole number.
pub fn five_sample_coordinates(tex_coord: DVec2, time_s: f64) -> [DVec2; 5] {
    let turned = DVec2::new(tex_coord.x + tex_coord.y, tex_coord.y - tex_coord.x);
    LAYERS.map(|(scale, is_turned, seconds_per_tile)| {
        let scrolled = time_s / seconds_per_tile;
        scale * if is_turned { turned } else { tex_coord } + (scrolled - scrolled.floor())
    })
}

/// N from the five raw texels: the sum of texel.xzy − ½, normalised. The texels' blue axis points up; what is
/// subtracted from it is ½ as well, so a flat texel (½, ½, 1) is (0, ½, 0). (0, 1, 0) where the sum is 0.
pub fn five_sample_normal(texels: [[f64; 3]; 5]) -> DVec3 {
    let sum: DVec3 = texels.iter().map(|&[r, g, b]| DVec3::new(r, b, g) - 0.5).sum();
    sum.try_normalize().unwrap_or(DVec3::Y)
}

/// One pixel of the ocean.
///
/// `view` and `sun` are unit vectors towards eye and sun. `sky` is asked for the colour at an address, from 0
/// (what is mirrored when looking straight down) to 1 (the horizon): by the direction of view and not by that
/// of the reflection.
pub fn five_sample_pixel(
    texels: [[f64; 3]; 5],
    view: DVec3,
    sun: DVec3,
    constants: &FiveSampleConstants,
    sky: impl Fn(f64) -> [f64; 3],
) -> FiveSamplePixel {
    let normal = five_sample_normal(texels);
    let reflection = 2.0 * normal.dot(sun) * normal - sun;
    let fresnel = (1.0 - normal.dot(view)) * (1.0 - normal.dot(view));
    let glint = constants.sun * reflection.dot(view).clamp(0.0, 1.0).powf(constants.exponent);
    let sky_address = 1.0 - view.y;
    let reflected = (glint + DVec3::from(sky(sky_address))) * DVec3::from(constants.reflection);
    let color = DVec3::from(constants.emission).lerp(reflected, fresnel);
    FiveSamplePixel { normal, reflection, fresnel, sun: glint, sky_address, color }
}

#[cfg(test)]
mod tests {
    use super::super::assert_close;
    use super::*;

    fn pixel(texels: [[f64; 3]; 5], view: DVec3) -> FiveSamplePixel {
        let sun = DVec3::new(1.0, 1.0, 0.0).normalize();
        five_sample_pixel(texels, view.normalize(), sun, &FIVE_SAMPLE_DEFAULTS, |_| [0.4, 0.6, 0.9])
    }

    const FLAT: [[f64; 3]; 5] = [[0.5, 0.5, 1.0]; 5];

    #[test]
    fn golden_flat_pixels() {
        let down = pixel(FLAT, DVec3::Y);
        assert_close([down.fresnel, down.sky_address], [0.0, 0.0]);
        assert_close(down.color.to_array(), [0.1, 0.15, 0.12]);
        let grazing = pixel(FLAT, DVec3::new(1.0, 0.2, 0.0));
        assert_close([grazing.fresnel], [0.646229]);
        assert_close(grazing.color.to_array(), [0.203397, 0.305095, 0.420497]);
        let glint = pixel(FLAT, DVec3::new(-1.0, 1.0, 0.0));
        assert_close([glint.fresnel, glint.sun], [0.085786, 7.0]);
        assert_close(glint.color.to_array(), [0.504054, 0.560917, 0.550219]);
    }

    #[test]
    fn golden_rippled_pixel() {
        let texels =
            [[0.55, 0.5, 0.95], [0.48, 0.52, 0.97], [0.5, 0.45, 0.9], [0.6, 0.5, 0.9], [0.5, 0.5, 1.0]];
        let seen = pixel(texels, DVec3::new(-1.0, 1.0, 0.0));
        assert_close(seen.normal.to_array(), [0.058453, 0.998199, -0.013489]);
        assert_close([seen.fresnel], [0.112560]);
        assert!((seen.sun - 5.281984).abs() < 2e-5, "{}", seen.sun);
        assert_close(seen.color.to_array(), [0.504460, 0.563465, 0.558791]);
    }

    #[test]
    fn layers_scale_turn_and_scroll() {
        let coordinates = five_sample_coordinates(DVec2::new(0.1, 0.3), 50.0);
        assert_close(coordinates[0].to_array(), [0.5 + 0.25, 1.5 + 50.0 / 166.0]);
        assert_close(coordinates[2].to_array(), [67.0 * 0.4 + 50.0 / 56.0, 67.0 * 0.2 + 16.0 / 34.0]);
        assert_close(coordinates[3].to_array(), [20.3 + 0.5, 60.9 + 0.5]);
        // Whole shifts of the coordinate are whole shifts of every layer.
        for (a, b) in coordinates.iter().zip(five_sample_coordinates(DVec2::new(3.1, -1.7), 50.0)) {
            let shift = b - a;
            assert!(shift.distance(shift.round()) < 1e-9);
        }
    }

    #[test]
    fn grey_texels_have_a_normal_too() {
        assert_eq!(five_sample_normal([[0.5; 3]; 5]), DVec3::Y);
    }
}
