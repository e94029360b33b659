//! What the text's artists painted, made from settings: the bump map of the small ripples and the gradient of the
//! water's colour.

use whitecap_scene::technique::OceanWater as Settings;
use whitecap_waves::field::WindRippleParameters;

use crate::RenderError;
use crate::surface::bump_map;

/// Texels of the gradient.
const GRADIENT: usize = 256;

/// The RGB normal map made from a height map (the text's Figure 3), with its mips.
pub(super) fn bump_levels(settings: &Settings, seed: u64) -> Result<Vec<Vec<[u8; 4]>>, RenderError> {
    let ripples = WindRippleParameters {
        peak_waves: settings.bump_ripples,
        smoothing_texels: 1.0,
        ..WindRippleParameters::new(settings.bump_resolution as usize, seed)
    };
    bump_map(ripples, settings.bump_steepness)
}

/// The 1-D map of the water's colour (Figure 5), from looking along the surface to looking down into it.
pub(super) fn gradient(settings: &Settings) -> Vec<[u8; 4]> {
    let Settings { edge_color, middle_color, deep_color, .. } = settings;
    (0..GRADIENT)
        .map(|i| {
            let at = 2.0 * i as f64 / (GRADIENT - 1) as f64;
            let channel = |c: usize| {
                let value = if at < 1.0 {
                    edge_color[c] + (middle_color[c] - edge_color[c]) * at
                } else {
                    middle_color[c] + (deep_color[c] - middle_color[c]) * (at - 1.0)
                };
                (value * 255.0 + 0.5) as u8
            };
            [channel(0), channel(1), channel(2), 255]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gradient_runs_from_the_edge_to_the_deep() {
        let settings = Settings {
            edge_color: [0.0, 0.2, 1.0],
            middle_color: [0.4, 0.4, 0.6],
            deep_color: [0.0, 1.0, 0.2],
            ..Settings::default()
        };
        let table = gradient(&settings);
        assert_eq!((table[0], table[255]), ([0, 51, 255, 255], [0, 255, 51, 255]));
        assert!((i32::from(table[127][0]) - 102).abs() <= 1 && (i32::from(table[64][2]) - 204).abs() <= 1);
    }

    #[test]
    fn the_bump_map_is_as_steep_as_asked() {
        let rms = |bump_steepness: f64| {
            let settings = Settings { bump_steepness, bump_resolution: 128, ..Settings::default() };
            let levels = bump_levels(&settings, 3).unwrap();
            assert_eq!(levels.len(), 8);
            let slope = |texel: &[u8; 4]| {
                let [x, y, z] = [texel[0], texel[1], texel[2]].map(|c| f64::from(c) / 127.5 - 1.0);
                (x * x + y * y) / (z * z)
            };
            (levels[0].iter().map(slope).sum::<f64>() / levels[0].len() as f64).sqrt()
        };
        assert!((rms(0.2) - 0.2).abs() < 0.01 && (rms(0.6) - 0.6).abs() < 0.02);
        assert!(rms(0.0) < 0.01);
    }

    #[test]
    fn all_settings_make_a_bump_map() {
        for bump_resolution in [128, 1024] {
            for bump_ripples in [2.0, 16.0] {
                let settings = Settings { bump_resolution, bump_ripples, ..Settings::default() };
                assert!(bump_levels(&settings, 1).is_ok());
            }
        }
    }
}
