//! The bump map that both scrolling layers read.

use crate::RenderError;
use whitecap_waves::field::WindRippleParameters;

/// How many of the longest strong ripples fit along the map.
const PEAK_WAVES: f64 = 7.0;

/// How many times weaker ripples against the wind are: a lake's run every way.
const OPPOSING_ENERGY: f64 = 1.0;

/// Ripples of the wind as 8-bit normals with this root mean square slope, all levels.
pub(super) fn bump_map(seed: u64, resolution: u32, slope: f64) -> Result<Vec<Vec<[u8; 4]>>, RenderError> {
    let size = resolution as usize;
    let parameters = WindRippleParameters {
        peak_waves: PEAK_WAVES,
        opposing_energy: OPPOSING_ENERGY,
        smoothing_texels: 1.0,
        ..WindRippleParameters::new(size, seed)
    };
    crate::surface::bump_map(parameters, slope)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::rms_slope;

    #[test]
    fn the_map_has_the_slope_asked_for() {
        for slope in [0.05, 0.2, 0.5] {
            let levels = bump_map(7, 128, slope).unwrap();
            assert_eq!(levels.len(), 8);
            let normals: Vec<[f32; 3]> =
                levels[0].iter().map(|texel| [0, 1, 2].map(|i| f32::from(texel[i]) / 127.5 - 1.0)).collect();
            let seen = rms_slope(&normals);
            assert!((seen - slope).abs() < 0.01, "{seen} for {slope}");
        }
        assert!(bump_map(7, 64, 0.0).unwrap()[0].iter().all(|texel| *texel == [128, 128, 255, 255]));
    }
}
