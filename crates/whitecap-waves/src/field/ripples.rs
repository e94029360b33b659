//! Ripples as the wind makes them: a moment of a small spectral sea.

use super::HeightField;
use crate::GRAVITY_MPS2;
use crate::error::{ParameterError, check};
use crate::model::spectral::{Amplitudes, Band, SpectralTile, SpectralTileParameters, Water};
use crate::model::{TileFields, WaveModel};
use crate::spectrum::phillips::{Phillips, PhillipsParameters};
use glam::DVec2;
use std::f64::consts::TAU;

/// What [`HeightField::wind_ripples`] is made from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WindRippleParameters {
    /// Texels along a side, a power of two from 16 to 2048.
    pub size: usize,
    /// Which ripples.
    pub seed: u64,
    /// The unit vector the wind blows towards, along u and v.
    pub toward: DVec2,
    /// The energy of ripples that run against the wind relative to that of those with it, 0 to 1: still, both
    /// look alike.
    pub opposing_energy: f64,
    /// How many of the longest strong waves fit along the tile, from 2 to `size` / 8. Few waves make a map that
    /// shows its period, many a fine one.
    pub peak_waves: f64,
    /// The damping length in texels, from 0 to 8: waves much shorter than 2π of it are left out. 0.5 keeps
    /// neighbouring texels from alternating.
    pub smoothing_texels: f64,
}

impl WindRippleParameters {
    /// Ripples under a wind along u with 6 long waves across the tile.
    pub fn new(size: usize, seed: u64) -> Self {
        Self { size, seed, toward: DVec2::X, opposing_energy: 1.0, peak_waves: 6.0, smoothing_texels: 0.5 }
    }
}

impl HeightField {
    /// Ripples with the Phillips spectrum, mean 0 and variance 1.
    ///
    /// The spectrum's peak over k is at kL = √(2/3), L = U²/g (by the derivative of k⁻³ exp(−1/(kL)²)); L, and by
    /// it the wind, follows from `peak_waves`.
    ///
    /// Fails when a parameter is out of its range, or when so much is smoothed away that too little is left.
    pub fn wind_ripples(parameters: WindRippleParameters) -> Result<Self, ParameterError> {
        let WindRippleParameters { size, seed, toward, opposing_energy, peak_waves, smoothing_texels } =
            parameters;
        check("size", size as f64, "a power of two from 16 to 2048", |_| {
            size.is_power_of_two() && (16..=2048).contains(&size)
        })?;
        check("peak_waves", peak_waves, "from 2 to an eighth of the size", |waves| {
            (2.0..=size as f64 / 8.0).contains(&waves)
        })?;
        check("smoothing_texels", smoothing_texels, "from 0 to 8", |s| (0.0..=8.0).contains(&s))?;
        // Everything below is relative to the tile, whose size in metres is therefore free.
        let tile_size_m = 100.0;
        let length_scale_m = (2.0_f64 / 3.0).sqrt() * tile_size_m / (TAU * peak_waves);
        let spectrum = Phillips::new(PhillipsParameters {
            wind_speed_mps: (GRAVITY_MPS2 * length_scale_m).sqrt(),
            toward,
            significant_height_m: Some(4.0),
            opposing_energy,
            small_wave_cutoff_m: (smoothing_texels * tile_size_m / size as f64).min(length_scale_m),
        })?;
        let tile = SpectralTileParameters {
            tile_size_m,
            resolution: size,
            band: Band::WHOLE,
            choppiness: 0.0,
            water: Water::STILL,
            seed,
            amplitudes: Amplitudes::Deterministic,
        };
        let mut fields = TileFields::new(size);
        SpectralTile::new(tile, &[spectrum])?.evaluate(0.0, &mut fields);
        Ok(Self::normalised(size, &fields.height))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::statistics::Moments;

    #[test]
    fn ripples_have_unit_variance_and_follow_their_seed() {
        let make = |seed| HeightField::wind_ripples(WindRippleParameters::new(64, seed)).unwrap();
        let moments = Moments::of(make(1).heights());
        assert!(moments.mean.abs() < 1e-6 && (moments.variance - 1.0).abs() < 1e-5);
        assert_eq!(make(1), make(1));
        assert_ne!(make(1), make(2));
    }

    /// The step across the border is like any other step.
    #[test]
    fn ripples_wrap() {
        let field = HeightField::wind_ripples(WindRippleParameters::new(64, 5)).unwrap();
        let step = |u: usize| {
            (0..64).map(|v| f64::from(field.at(u + 1, v) - field.at(u, v)).powi(2)).sum::<f64>() / 64.0
        };
        let mean = (0..63).map(step).sum::<f64>() / 63.0;
        assert!((0.3..3.0).contains(&(step(63) / mean)), "{} {mean}", step(63));
    }

    /// A wind along u makes crests along v: heights change faster along u. More waves, faster changes.
    #[test]
    fn wind_and_number_of_waves_show() {
        let steepness = |toward: DVec2, peak_waves: f64| {
            let field = HeightField::wind_ripples(WindRippleParameters {
                toward,
                peak_waves,
                ..WindRippleParameters::new(64, 5)
            })
            .unwrap();
            let along = |du: usize, dv: usize| {
                (0..4096)
                    .map(|i| (field.at(i % 64 + du, i / 64 + dv) - field.at(i % 64, i / 64)).powi(2))
                    .sum::<f32>()
            };
            (along(1, 0), along(0, 1))
        };
        let (u, v) = steepness(DVec2::X, 6.0);
        assert!(u > 1.5 * v, "{u} {v}");
        let (u, v) = steepness(DVec2::Y, 6.0);
        assert!(v > 1.5 * u, "{u} {v}");
        assert!(steepness(DVec2::X, 3.0).0 < steepness(DVec2::X, 8.0).0);
    }

    #[test]
    fn what_is_out_of_range_is_named() {
        let base = WindRippleParameters::new(64, 0);
        for (parameters, name) in [
            (WindRippleParameters { size: 48, ..base }, "size is 48"),
            (WindRippleParameters { peak_waves: 9.0, ..base }, "peak_waves is 9"),
            (WindRippleParameters { smoothing_texels: f64::NAN, ..base }, "smoothing_texels"),
            (WindRippleParameters { toward: DVec2::ZERO, ..base }, "toward"),
        ] {
            let error = HeightField::wind_ripples(parameters).unwrap_err().to_string();
            assert!(error.starts_with(name), "{error}");
        }
    }

    #[test]
    fn all_sizes_and_numbers_of_waves_fit() {
        for size in [16, 32, 256] {
            for peak_waves in [2.0, size as f64 / 8.0] {
                for smoothing_texels in [0.0, 1.0, 8.0] {
                    let parameters = WindRippleParameters {
                        peak_waves,
                        smoothing_texels,
                        ..WindRippleParameters::new(size, 3)
                    };
                    assert!(HeightField::wind_ripples(parameters).is_ok(), "{parameters:?}");
                }
            }
        }
    }
}
