//! Johanson's water (*Real-time water rendering: introducing the projected grid concept*, Lund 2004): the pixel
//! shader. y is up.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | v | unit vector from the eye to the water |
//! | N | 2 texel − 1 of the normal map, not normalised |
//! | R | v reflected at N, of length 1, then kept from pointing below the horizon |
//! | F | share that is reflected |
//!
//! Only the sun is encoded (to the power 1/2.2); everything else is taken as it is displayed. The content of the
//! Fresnel map is not in the thesis; it is [`fresnel_exact`] here.

use super::signed;
use crate::optics::{WATER_REFRACTIVE_INDEX, fresnel_exact};
use glam::{DVec2, DVec3, DVec4};

/// The light of the sun in the shader: orange.
const SUN_COLOR: DVec3 = DVec3::new(1.2, 0.4, 0.1);

/// What the demo sets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProjectedGridConstants {
    /// Unit vector towards the sun.
    pub sun: DVec3,
    /// Power of the sun's glint.
    pub sun_shininess: f64,
    /// Strength of the sun's glint.
    pub sun_strength: f64,
    /// The water's own colour.
    pub water_color: [f64; 3],
    /// How far the normal moves the lookup in the mirror image at a depth (z/w) of 1, in widths of it.
    pub reflection_perturbation: f64,
}

impl Default for ProjectedGridConstants {
    /// The demo's set-up.
    fn default() -> Self {
        Self {
            sun: sun_vector(1.38, 1.09),
            sun_shininess: 84.0,
            sun_strength: 12.0,
            water_color: [0.17, 0.27, 0.26],
            reflection_perturbation: 0.1,
        }
    }
}

/// What becomes of a pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProjectedGridPixel {
    /// N.
    pub normal: DVec3,
    /// R, not renormalised after its y was clamped.
    pub reflection: DVec3,
    /// F at R·N.
    pub fresnel: f64,
    /// The sun's glint, encoded.
    pub sun: DVec3,
    /// Where the mirror image is read.
    pub mirror_address: DVec2,
    /// What is reflected: mirrored things over sky and sun.
    pub reflected: DVec3,
    /// What is written, not clamped.
    pub color: DVec3,
}

/// The unit vector towards the sun for the demo's two angles in radians: `alpha` around, from z towards x, and
/// `theta` above the horizon.
pub fn sun_vector(alpha: f64, theta: f64) -> DVec3 {
    let (sin_alpha, cos_alpha) = libm::sincos(alpha);
    let (sin_theta, cos_theta) = libm::sincos(theta);
    DVec3::new(cos_theta * sin_alpha, sin_theta, cos_theta * cos_alpha)
}

/// The sun's glint for R·sun = `cos`: (strength · saturate(cos)^shininess · (1.2, 0.4, 0.1))^(1/2.2).
pub fn sun_glint(cos: f64, strength: f64, shininess: f64) -> DVec3 {
    let light = strength * cos.clamp(0.0, 1.0).powf(shininess) * SUN_COLOR;
    light.powf(1.0 / 2.2)
}

/// Where the mirror image is read: `screen` − `perturbation` / depth · N.xz.
///
/// `screen` is where the undisplaced water is on the screen, ½ + ½ (x, −y) of its normalised device
/// coordinates, `depth` their z, 0 to 1.
pub fn mirrored_coordinates(screen: DVec2, depth: f64, perturbation: f64, normal: DVec3) -> DVec2 {
    screen - perturbation / depth * DVec2::new(normal.x, normal.z)
}

/// One pixel of the water.
///
/// `texel` is the raw texel of the normal map, `view` the unit vector from the eye **to** the water, `screen`
/// and `depth` are as for [`mirrored_coordinates`]. `environment` is asked for the colour of a direction,
/// `mirror` for colour and coverage at an address of the mirror image.
pub fn projected_grid_pixel(
    texel: [f64; 3],
    view: DVec3,
    (screen, depth): (DVec2, f64),
    constants: &ProjectedGridConstants,
    environment: impl Fn(DVec3) -> [f64; 3],
    mirror: impl Fn(DVec2) -> [f64; 4],
) -> ProjectedGridPixel {
    let normal = signed(texel);
    let mut reflection = (view - 2.0 * normal.dot(view) * normal).normalize_or(DVec3::Y);
    reflection.y = reflection.y.max(0.0);
    let fresnel = fresnel_exact(reflection.dot(normal), WATER_REFRACTIVE_INDEX);
    let sun = sun_glint(reflection.dot(constants.sun), constants.sun_strength, constants.sun_shininess);
    let mirror_address = mirrored_coordinates(screen, depth, constants.reflection_perturbation, normal);
    let mirrored = DVec4::from(mirror(mirror_address));
    let sky = DVec3::from(environment(reflection)) + sun;
    let reflected = sky.lerp(mirrored.truncate(), mirrored.w);
    let color = DVec3::from(constants.water_color).lerp(reflected, fresnel);
    ProjectedGridPixel { normal, reflection, fresnel, sun, mirror_address, reflected, color }
}

#[cfg(test)]
mod tests {
    use super::super::assert_close;
    use super::*;

    #[test]
    fn golden_sun() {
        assert_close(sun_vector(1.38, 1.09).to_array(), [0.454093, 0.886627, 0.087706]);
        for (cos, expected) in [
            (1.0, [3.361464, 2.040117, 1.086404]),
            (0.99, [2.290194, 1.389949, 0.740176]),
            (0.95, [0.474215, 0.287807, 0.153263]),
            (0.9, [0.060176, 0.036522, 0.019449]),
            (-0.5, [0.0; 3]),
        ] {
            assert_close(sun_glint(cos, 12.0, 84.0).to_array(), expected);
        }
    }

    /// Flat water, looked at steeply, with no sun in it: the reference's sum
    /// C = (1 − F) W + F (M a + (1 − a)(E + S)).
    #[test]
    fn the_layers_add_up() {
        let constants = ProjectedGridConstants { sun: DVec3::NEG_Y, ..Default::default() };
        let view = DVec3::new(0.6, -0.8, 0.0);
        let pixel = projected_grid_pixel(
            [0.5, 1.0, 0.5],
            view,
            (DVec2::new(0.25, 0.75), 0.5),
            &constants,
            |direction| direction.to_array(),
            |at| [at.x, at.y, 0.0, 0.4],
        );
        assert_close(pixel.reflection.to_array(), [0.6, 0.8, 0.0]);
        assert_close(pixel.mirror_address.to_array(), [0.25, 0.75]);
        let f = fresnel_exact(0.8, 1.333);
        assert_close([pixel.fresnel], [f]);
        let layer = |water: f64, mirror: f64, sky: f64| (1.0 - f) * water + f * (0.4 * mirror + 0.6 * sky);
        assert_close(
            pixel.color.to_array(),
            [layer(0.17, 0.25, 0.6), layer(0.27, 0.75, 0.8), layer(0.26, 0.0, 0.0)],
        );
    }

    /// A wave that would mirror what lies below the horizon mirrors the horizon, and its R gets shorter.
    #[test]
    fn reflections_stay_above_the_horizon() {
        let normal = DVec3::new(0.8, 0.6, 0.0);
        let view = DVec3::new(-0.995, -0.1, 0.0).normalize();
        let pixel = projected_grid_pixel(
            (0.5 + 0.5 * normal).to_array(),
            view,
            (DVec2::splat(0.5), 0.5),
            &ProjectedGridConstants::default(),
            |_| [0.0; 3],
            |_| [0.0; 4],
        );
        assert!(pixel.reflection.y >= 0.0);
        let down = DVec3::new(0.9, 0.1, 0.0);
        let away = projected_grid_pixel(
            (0.5 + 0.5 * down).to_array(),
            DVec3::new(0.3, -0.954, 0.0).normalize(),
            (DVec2::splat(0.5), 0.5),
            &ProjectedGridConstants::default(),
            |_| [0.0; 3],
            |_| [0.0; 4],
        );
        assert_eq!(away.reflection.y, 0.0);
        assert!(away.reflection.length() < 1.0);
    }

    /// A slope moves the lookup against itself, less with distance.
    #[test]
    fn slopes_move_the_lookup() {
        let near = mirrored_coordinates(DVec2::splat(0.5), 0.5, 0.1, DVec3::new(0.2, 0.9, -0.1));
        assert_close(near.to_array(), [0.46, 0.52]);
        let far = mirrored_coordinates(DVec2::splat(0.5), 1.0, 0.1, DVec3::new(0.2, 0.9, -0.1));
        assert_close(far.to_array(), [0.48, 0.51]);
    }
}
