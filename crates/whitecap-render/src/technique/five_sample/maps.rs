//! The wave map and the sky's gradient, made from seeds and colours in place of the text's lost pictures.

use crate::RenderError;
use whitecap_waves::ParameterError;
use whitecap_waves::field::{HeightField, WindRippleParameters, encode_unorm8, mip_chain, normal_map};

/// Texels along a side, as in the text.
pub(super) const MAP_SIZE: usize = 256;

/// Entries of the sky's gradient.
pub(super) const SKY_ENTRIES: usize = 256;

/// What the log says of the normal map's contents at a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MapRecipe {
    /// "generated from regular Perlin noise".
    Perlin,
    /// "a slightly better normal map".
    BetterPerlin,
    /// From a map of wave heights, with "a more subtle normal map filter, smoothing the surface out somewhat".
    SoftWaves,
    /// "one I made in Gimp".
    HandMade,
}

impl MapRecipe {
    /// The texels of all levels. `strength` multiplies the slopes.
    pub(super) fn levels(self, seed: u64, strength: f64) -> Result<Vec<Vec<[u8; 4]>>, RenderError> {
        let (field, texels) = self.field(seed).map_err(|error| RenderError::Unsupported {
            what: format!("the wave map of this stage ({error})"),
        })?;
        let normals = normal_map(&field, texels * strength as f32);
        Ok(mip_chain(encode_unorm8(&normals), MAP_SIZE))
    }

    /// The heights, and what a height of 1 is worth in texels.
    fn field(self, seed: u64) -> Result<(HeightField, f32), ParameterError> {
        let ripples = |peak_waves, smoothing_texels, opposing_energy, toward| {
            HeightField::wind_ripples(WindRippleParameters {
                peak_waves,
                smoothing_texels,
                opposing_energy,
                toward,
                ..WindRippleParameters::new(MAP_SIZE, seed)
            })
        };
        let diagonal = glam::DVec2::new(0.8, 0.6);
        Ok(match self {
            MapRecipe::Perlin => (HeightField::perlin(MAP_SIZE, seed, 6, 0.6)?, 9.0),
            MapRecipe::BetterPerlin => (HeightField::perlin(MAP_SIZE, seed, 4, 0.4)?, 11.0),
            MapRecipe::SoftWaves => (ripples(5.0, 3.0, 1.0, diagonal)?, 2.2),
            MapRecipe::HandMade => (ripples(7.0, 1.0, 0.3, diagonal)?, 1.9),
        })
    }
}

/// The address at which the sky has its middle colour: 14.5° over the horizon.
const MIDDLE: f64 = 0.75;

/// The gradient by address, 0 overhead to 1 at the horizon: a monotone cubic through three colours (Fritsch and
/// Butland 1984), so that no edge shows in the middle.
pub(super) fn sky_gradient(colors: [[f64; 3]; 3], dimming: f64) -> Vec<[u8; 4]> {
    (0..SKY_ENTRIES)
        .map(|entry| {
            let address = entry as f64 / (SKY_ENTRIES - 1) as f64;
            let channel = |c: usize| {
                let value = monotone(address, colors.map(|color| color[c])) * dimming;
                (value.clamp(0.0, 1.0) * 255.0).round() as u8
            };
            [channel(0), channel(1), channel(2), 255]
        })
        .collect()
}

fn monotone(x: f64, [y0, y1, y2]: [f64; 3]) -> f64 {
    let (h0, h1) = (MIDDLE, 1.0 - MIDDLE);
    let (s0, s1) = ((y1 - y0) / h0, (y2 - y1) / h1);
    let slope = if s0 * s1 > 0.0 {
        // The weighted harmonic mean.
        let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
        (w0 + w1) / (w0 / s0 + w1 / s1)
    } else {
        0.0
    };
    let hermite = |t: f64, h: f64, from: f64, to: f64, start: f64, end: f64| {
        let (t2, t3) = (t * t, t * t * t);
        from * (2.0 * t3 - 3.0 * t2 + 1.0)
            + to * (3.0 * t2 - 2.0 * t3)
            + h * (start * (t3 - 2.0 * t2 + t) + end * (t3 - t2))
    };
    if x < MIDDLE {
        hermite(x / h0, h0, y0, y1, s0, slope)
    } else {
        hermite((x - MIDDLE) / h1, h1, y1, y2, slope, s1)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn the_gradient_goes_through_its_colours_without_overshoot() {
        let table = sky_gradient([[0.1, 0.9, 0.5], [0.5, 0.3, 0.5], [1.0, 0.2, 0.5]], 1.0);
        assert_eq!(table.len(), SKY_ENTRIES);
        assert_eq!((table[0], table[SKY_ENTRIES - 1]), ([26, 230, 128, 255], [255, 51, 128, 255]));
        assert!((monotone(MIDDLE, [0.1, 0.5, 1.0]) - 0.5).abs() < 1e-12);
        for pair in table.windows(2) {
            assert!(pair[0][0] <= pair[1][0] && pair[0][1] >= pair[1][1] && pair[0][2] == pair[1][2]);
            assert!(pair[0][0].abs_diff(pair[1][0]) < 4);
        }
    }

    /// The log's words as numbers: each map is another, and the soft one smoother than the noise before it.
    #[test]
    fn maps_differ_as_the_log_says() {
        let recipes = [MapRecipe::Perlin, MapRecipe::BetterPerlin, MapRecipe::SoftWaves, MapRecipe::HandMade];
        let maps = recipes.map(|recipe| recipe.levels(7, 1.0).unwrap());
        let roughness = |levels: &Vec<Vec<[u8; 4]>>| {
            let texels = &levels[0];
            let steps = texels.windows(2).map(|pair| f64::from(pair[0][0].abs_diff(pair[1][0])));
            steps.sum::<f64>() / texels.len() as f64
        };
        let rough = maps.each_ref().map(roughness);
        assert!(rough[0] > 1.5 * rough[1] && rough[1] > 1.5 * rough[2], "{rough:?}");
        for (i, map) in maps.iter().enumerate() {
            assert_eq!((map.len(), map[0].len()), (9, MAP_SIZE * MAP_SIZE));
            assert!(maps[..i].iter().all(|other| other != map));
            // Level on the mean.
            assert!(map[8][0][0].abs_diff(128) <= 3 && map[8][0][1].abs_diff(128) <= 3, "{:?}", map[8][0]);
        }
        assert_ne!(MapRecipe::HandMade.levels(8, 1.0).unwrap(), maps[3]);
        let level = MapRecipe::HandMade.levels(7, 0.0).unwrap();
        assert!(level.iter().flatten().all(|texel| *texel == [128, 128, 255, 255]));
    }
}
