//! "Rippling Reflective and Refractive Water" (Vlachos, Isidoro and Oat, in *Direct3D ShaderX*, ATI 2002): the
//! pixel shader.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | a, b | texels of the normal map at the two scrolling coordinates |
//! | n | mean of both, in tangent space, not normalised |
//! | V, L | vectors to eye and light in tangent space, as interpolated |
//! | p | where on the screen the undisplaced water is, 0..1, v down |
//! | A, B | what reflection and refraction map hold where n moves the lookup |
//!
//! The article gives no values for c1 to c6 and c24 to c27; [`LAKE_DEFAULTS`] are ours.

use super::{saturate, signed};
use glam::{DVec2, DVec3};

/// What the article leaves to the application.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RipplingLakeConstants {
    /// c1: how far n.xy moves the lookup in the reflection map, in widths of it.
    pub reflection_perturbation: DVec2,
    /// c2: the same for the refraction map.
    pub refraction_perturbation: DVec2,
    /// c3: what reflections are multiplied by.
    pub reflection_tint: [f64; 3],
    /// c4: what refractions are multiplied by.
    pub refraction_tint: [f64; 3],
    /// c6: the colour of the light's highlight.
    pub highlight_color: [f64; 3],
    /// c24: how fast the first bump coordinate scrolls, in its own units per second.
    pub bump_speed_0: DVec2,
    /// c25: the same for the second.
    pub bump_speed_1: DVec2,
    /// c26: how often the first bump map is repeated per unit of uv.
    pub bump_tiling_0: DVec2,
    /// c27: the same for the second.
    pub bump_tiling_1: DVec2,
}

/// Values that make a lake: the scroll speeds are those of the article's twin on the ocean, the tilings have no
/// short common period.
pub const LAKE_DEFAULTS: RipplingLakeConstants = RipplingLakeConstants {
    reflection_perturbation: DVec2::splat(0.05),
    refraction_perturbation: DVec2::splat(0.03),
    reflection_tint: [1.0; 3],
    refraction_tint: [0.4, 0.55, 0.5],
    highlight_color: [0.8, 0.76, 0.62],
    bump_speed_0: DVec2::new(0.031, 0.04),
    bump_speed_1: DVec2::new(-0.03, 0.02),
    bump_tiling_0: DVec2::splat(2.0),
    bump_tiling_1: DVec2::splat(2.7),
};

impl Default for RipplingLakeConstants {
    fn default() -> Self {
        LAKE_DEFAULTS
    }
}

/// What becomes of a pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RipplingLakePixel {
    /// n.
    pub bump: DVec3,
    /// V·n.
    pub cos_view: f64,
    /// n·L.
    pub cos_light: f64,
    /// Where the reflection map is read, within 0..=1.
    pub reflection_address: DVec2,
    /// Where the refraction map is read, within 0..=1.
    pub refraction_address: DVec2,
    /// (n·L)⁸, clamped after the fourth power and after the eighth. It is as strong behind the light as
    /// before it: the square comes first.
    pub highlight: f64,
    /// Both maps together, within 0..=1.
    pub water: DVec3,
    /// What is written, within 0..=1.
    pub color: DVec3,
    /// The alpha that is written: the red of `water`, since the last two instructions run side by side.
    pub alpha: f64,
}

/// Where the two bump maps are read at `uv` and `time_s` (oT0 and oT1). The listing swaps neither; only the
/// prose speaks of it.
pub fn rippling_lake_coordinates(uv: DVec2, time_s: f64, constants: &RipplingLakeConstants) -> [DVec2; 2] {
    let scrolled = |speed: DVec2| time_s * speed - (time_s * speed).floor();
    [
        uv * constants.bump_tiling_0 + scrolled(constants.bump_speed_0),
        uv * constants.bump_tiling_1 + scrolled(constants.bump_speed_1),
    ]
}

/// One pixel of the lake.
///
/// `a` and `b` are raw texels, `view` and `light` vectors in tangent space (x along T × N, y along T, z along
/// N), `screen` is p. `reflection` and `refraction` are asked for the colour at an address within 0..=1.
pub fn rippling_lake_pixel(
    [a, b]: [[f64; 3]; 2],
    view: DVec3,
    light: DVec3,
    screen: DVec2,
    constants: &RipplingLakeConstants,
    reflection: impl Fn(DVec2) -> [f64; 3],
    refraction: impl Fn(DVec2) -> [f64; 3],
) -> RipplingLakePixel {
    let bump = 0.5 * (signed(a) + signed(b));
    let (cos_view, cos_light) = (view.dot(bump), light.dot(bump));
    let address =
        |perturbation: DVec2| (bump.truncate() * perturbation + screen).clamp(DVec2::ZERO, DVec2::ONE);
    let reflection_address = address(constants.reflection_perturbation);
    let refraction_address = address(constants.refraction_perturbation);

    let mirrored =
        saturate(DVec3::from(reflection(reflection_address)) * DVec3::from(constants.reflection_tint));
    let below =
        saturate(DVec3::from(refraction(refraction_address)) * DVec3::from(constants.refraction_tint));
    let fourth = cos_light.powi(4).clamp(0.0, 1.0);
    let highlight = (fourth * fourth).clamp(0.0, 1.0);
    let water = saturate((1.0 - cos_view) * mirrored + below);
    let color = saturate(highlight * DVec3::from(constants.highlight_color) + water);
    RipplingLakePixel {
        bump,
        cos_view,
        cos_light,
        reflection_address,
        refraction_address,
        highlight,
        water,
        color,
        alpha: water.x,
    }
}

#[cfg(test)]
mod tests {
    use super::super::assert_close;
    use super::*;

    const BUMPY: [[f64; 3]; 2] = [[0.6, 0.45, 0.9], [0.5, 0.55, 1.0]];

    #[test]
    fn golden_pixel() {
        let pixel = rippling_lake_pixel(
            BUMPY,
            DVec3::new(0.6, 0.0, 0.8),
            DVec3::new(0.0, 0.6, 0.8),
            DVec2::splat(0.5),
            &LAKE_DEFAULTS,
            |_| [0.5, 0.6, 0.8],
            |_| [0.2, 0.3, 0.25],
        );
        assert_close(pixel.bump.to_array(), [0.1, 0.0, 0.9]);
        assert_close([pixel.cos_view, pixel.cos_light], [0.78, 0.72]);
        assert_close(pixel.reflection_address.to_array(), [0.505, 0.5]);
        assert_close(pixel.refraction_address.to_array(), [0.503, 0.5]);
        assert_close([pixel.highlight, pixel.alpha], [0.072220, 0.19]);
        assert_close(pixel.color.to_array(), [0.247776, 0.351888, 0.345777]);
    }

    #[test]
    fn addresses_stop_at_the_maps_borders_and_reach_the_maps() {
        let pixel = rippling_lake_pixel(
            [[1.0, 0.0, 1.0]; 2],
            DVec3::Z,
            DVec3::Z,
            DVec2::new(0.98, 0.01),
            &LAKE_DEFAULTS,
            |at| [at.x, at.y, 0.0],
            |at| [0.0, at.x, at.y],
        );
        assert_eq!(pixel.reflection_address, DVec2::new(1.0, 0.0));
        assert_eq!(pixel.refraction_address, DVec2::new(1.0, 0.0));
        // Looked straight down upon, n.z is 1: no reflection, all refraction, all highlight.
        assert_eq!(pixel.water, DVec3::new(0.0, 0.55, 0.0));
        assert_eq!(pixel.highlight, 1.0);
    }

    #[test]
    fn coordinates_tile_and_scroll() {
        let [first, second] = rippling_lake_coordinates(DVec2::new(0.5, 1.0), 2.0, &LAKE_DEFAULTS);
        assert_close(first.to_array(), [1.062, 2.08]);
        assert_close(second.to_array(), [2.29, 2.74]);
    }
}
