//! Bump maps of small ripples, for techniques that scroll a still map over the water.

use crate::RenderError;
use whitecap_waves::field::{HeightField, WindRippleParameters, encode_unorm8, mip_chain, normal_map};

/// The normals of a height map of ripples with this root mean square slope, as raw 8-bit values, all levels.
///
/// A field's own steepness depends on its spectrum, so it is measured.
///
/// # Errors
///
/// If the ripples' parameters are out of range, which those of a checked scene are not.
pub(crate) fn bump_map(ripples: WindRippleParameters, slope: f64) -> Result<Vec<Vec<[u8; 4]>>, RenderError> {
    let size = ripples.size;
    let field = HeightField::wind_ripples(ripples)
        .map_err(|error| RenderError::Internal { description: error.to_string() })?;
    let strength = slope / rms_slope(&normal_map(&field, 1.0)).max(1e-9);
    Ok(mip_chain(encode_unorm8(&normal_map(&field, strength as f32)), size))
}

/// √(mean of (∂h/∂u)² + (∂h/∂v)²) of a map of unit normals.
pub(crate) fn rms_slope(normals: &[[f32; 3]]) -> f64 {
    let squares = normals.iter().map(|&[x, y, z]| f64::from((x * x + y * y) / (z * z)));
    (squares.sum::<f64>() / normals.len().max(1) as f64).sqrt()
}
