//! The pixel shaders of the classic techniques, as functions that a shader can be held against.
//!
//! Each takes what the pixel has fetched or interpolated, calculates as its source does, clamps included, and
//! returns its intermediate values beside the colour. Texels and colours are the raw values that the textures
//! hold, 0 to 1; nothing is decoded and nothing normalised that the source leaves alone.

mod five_sample;
mod ocean_water;
mod projected_grid;
mod rippling_lake;

pub use five_sample::{
    FIVE_SAMPLE_DEFAULTS, FiveSampleConstants, FiveSamplePixel, five_sample_coordinates, five_sample_normal,
    five_sample_pixel,
};
pub use ocean_water::{
    BUMP_SPEED, BumpFrame, HIGHLIGHT_COLOR, OceanWaterPixel, bump_coordinates, ocean_water_pixel,
};
pub use projected_grid::{
    ProjectedGridConstants, ProjectedGridPixel, mirrored_coordinates, projected_grid_pixel, sun_glint,
    sun_vector,
};
pub use rippling_lake::{
    LAKE_DEFAULTS, RipplingLakeConstants, RipplingLakePixel, rippling_lake_coordinates, rippling_lake_pixel,
};

use glam::DVec3;

/// `_sat`: each channel within 0..=1.
fn saturate(color: DVec3) -> DVec3 {
    color.clamp(DVec3::ZERO, DVec3::ONE)
}

/// `_bx2`: from 0..1 to −1..1.
fn signed(texel: [f64; 3]) -> DVec3 {
    2.0 * DVec3::from(texel) - 1.0
}

#[cfg(test)]
fn assert_close<const N: usize>(seen: [f64; N], expected: [f64; N]) {
    for (a, b) in seen.iter().zip(expected) {
        assert!((a - b).abs() < 1e-5, "{seen:?} for {expected:?}");
    }
}
