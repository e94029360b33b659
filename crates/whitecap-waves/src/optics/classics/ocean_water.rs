//! "Rendering Ocean Water" (Isidoro, Vlachos and Brennan, in *Direct3D ShaderX*, ATI 2002): the pixel shader.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | a, b | texels of the normal map at the two scrolling coordinates |
//! | n | composite normal in the plane's tangent space |
//! | V | unit vector to the eye |
//! | E, W | colours of the environment and of the gradient |
//! | g | green of E, from which the sparkles are made |
//!
//! The article's prose and its captions disagree on how the gradient is addressed; the code says 2 N·V clamped,
//! and so does this: whatever is seen within 60° of the normal has the gradient's last colour.

use super::{saturate, signed};
use glam::{DVec2, DVec3, Vec2Swizzles};

/// c17: how fast the two bump coordinates scroll, in uv per second: (u, v) of the first, (u, v) of the second.
pub const BUMP_SPEED: [f64; 4] = [0.031, 0.04, -0.03, 0.02];

/// ps c1: the colour of the sparkles.
pub const HIGHLIGHT_COLOR: [f64; 3] = [0.8, 0.76, 0.62];

/// The three interpolated vectors that carry a bump from tangent space to the world, none of them normalised
/// by the pixel shader.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BumpFrame {
    /// What the bump's x goes along: T × N of the vertex (oT3).
    pub binormal: DVec3,
    /// What the bump's y goes along: the tangent along v (oT4).
    pub tangent: DVec3,
    /// What the bump's z goes along (oT5).
    pub normal: DVec3,
}

/// What becomes of a pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OceanWaterPixel {
    /// n.
    pub bump: DVec3,
    /// n in the frame's space, not of length 1.
    pub normal: DVec3,
    /// N·V.
    pub cos_view: f64,
    /// 2 (N·V) N − V, where the environment is looked up.
    pub reflection: DVec3,
    /// 2 N·V within 0..=1, where the gradient is looked up.
    pub gradient_address: f64,
    /// g⁸.
    pub sparkle: f64,
    /// Environment and water without sparkles, within 0..=1.
    pub water: DVec3,
    /// What is written, within 0..=1.
    pub color: DVec3,
}

/// Where the two bump maps are read at `uv` and `time_s` (oT0 and oT1). u and v of the second are swapped, so
/// that the maps never line up.
///
/// `bump_speed` is c17, [`BUMP_SPEED`] in the text.
pub fn bump_coordinates(uv: DVec2, time_s: f64, bump_speed: [f64; 4]) -> [DVec2; 2] {
    let [u0, v0, u1, v1] = bump_speed.map(|speed| {
        let scrolled = time_s * speed;
        scrolled - scrolled.floor()
    });
    [uv + DVec2::new(u0, v0), (uv + DVec2::new(u1, v1)).yx()]
}

/// One pixel of the ocean.
///
/// `a` and `b` are raw texels of the normal map. `environment` is asked for the colour of a direction (of any
/// length), `gradient` for the colour at an address within 0..=1. n.xy is half the mean of both maps'; n.z is
/// the blue of `a` **as it is**, where a flat texel has 1: not expanded to −1..1 and not averaged.
pub fn ocean_water_pixel(
    a: [f64; 3],
    b: [f64; 3],
    view: DVec3,
    frame: &BumpFrame,
    environment: impl Fn(DVec3) -> [f64; 3],
    gradient: impl Fn(f64) -> [f64; 3],
) -> OceanWaterPixel {
    let softened = 0.25 * (signed(a) + signed(b));
    let bump = DVec3::new(softened.x, softened.y, a[2]);
    let normal = bump.x * frame.binormal + bump.y * frame.tangent + bump.z * frame.normal;
    let cos_view = normal.dot(view);
    let reflection = 2.0 * cos_view * normal - view;
    let gradient_address = (2.0 * cos_view).clamp(0.0, 1.0);

    let seen = DVec3::from(environment(reflection));
    let squared = seen * seen * (1.0 - cos_view);
    let water = saturate(0.25 * (squared + 2.0 * DVec3::from(gradient(gradient_address))));
    let sparkle = seen.y.powi(8);
    let color = saturate(sparkle * DVec3::from(HIGHLIGHT_COLOR) + water);
    OceanWaterPixel { bump, normal, cos_view, reflection, gradient_address, sparkle, water, color }
}

#[cfg(test)]
mod tests {
    use super::super::assert_close;
    use super::*;

    const FRAME: BumpFrame = BumpFrame { binormal: DVec3::X, tangent: DVec3::Y, normal: DVec3::Z };

    fn pixel(a: [f64; 3], b: [f64; 3], view: [f64; 3]) -> OceanWaterPixel {
        ocean_water_pixel(a, b, view.into(), &FRAME, |_| [0.7, 0.85, 0.95], |_| [0.1, 0.3, 0.35])
    }

    #[test]
    fn golden_pixels() {
        let flat = pixel([0.5, 0.5, 1.0], [0.5, 0.5, 1.0], [0.0, 0.0, 1.0]);
        assert_close([flat.cos_view, flat.gradient_address, flat.sparkle], [1.0, 1.0, 0.272491]);
        assert_close(flat.color.to_array(), [0.267992, 0.357093, 0.343944]);

        let bumpy = pixel([0.6, 0.45, 0.9], [0.5, 0.55, 1.0], [0.6, 0.0, 0.8]);
        assert_close(bumpy.bump.to_array(), [0.05, 0.0, 0.9]);
        assert_close([bumpy.cos_view], [0.75]);
        assert_close(bumpy.reflection.to_array(), [-0.525, 0.0, 0.55]);
        assert_close(bumpy.color.to_array(), [0.298617, 0.402249, 0.400350]);

        let grazing = pixel([0.8, 0.3, 0.85], [0.7, 0.4, 0.9], [0.9798, 0.0, 0.2]);
        assert_close(grazing.bump.to_array(), [0.25, -0.15, 0.85]);
        assert_close([grazing.cos_view, grazing.gradient_address], [0.41495, 0.8299]);
        assert_close(grazing.color.to_array(), [0.339661, 0.462767, 0.475946]);
    }

    #[test]
    fn lookups_get_reflection_and_address() {
        let frame = BumpFrame { binormal: DVec3::Y, tangent: DVec3::Z, normal: DVec3::X };
        let view = DVec3::new(0.2, 0.9, -0.3).normalize();
        let pixel = ocean_water_pixel(
            [0.6, 0.45, 0.9],
            [0.5, 0.55, 1.0],
            view,
            &frame,
            |direction| (0.5 + 0.5 * direction).to_array(),
            |address| [address; 3],
        );
        assert!(pixel.normal.distance(DVec3::new(0.9, 0.05, 0.0)) < 1e-12);
        let seen = 0.5 + 0.5 * pixel.reflection;
        let water = 0.25 * (seen * seen * (1.0 - pixel.cos_view) + 2.0 * pixel.gradient_address);
        assert!(pixel.water.distance(water.clamp(DVec3::ZERO, DVec3::ONE)) < 1e-12);
        assert!((pixel.sparkle - seen.y.powi(8)).abs() < 1e-12);
    }

    /// Turned away, the gradient's first colour is left and the rest gains: 1 − N·V passes 1, as printed.
    #[test]
    fn seen_from_behind() {
        let behind = pixel([0.5, 0.5, 1.0], [0.5, 0.5, 1.0], [0.0, 0.0, -1.0]);
        assert_eq!((behind.gradient_address, behind.cos_view), (0.0, -1.0));
        assert!((behind.water.x - 0.25 * (0.49 * 2.0 + 0.2)).abs() < 1e-12);
    }

    #[test]
    fn the_second_map_is_read_with_u_and_v_swapped() {
        let [first, second] = bump_coordinates(DVec2::new(0.3, 0.7), 1.0, BUMP_SPEED);
        assert_close(first.to_array(), [0.331, 0.74]);
        assert_close(second.to_array(), [0.72, 1.27]);
    }
}
