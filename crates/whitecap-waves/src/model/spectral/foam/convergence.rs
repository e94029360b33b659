//! By how much a tile's waves draw the water together.

use super::super::evolve::{Column, evolve_column};
use super::super::lattice::Waves;
use crate::error::ParameterError;
use crate::transform::{InverseReal2d, for_each_run, thread_count};

/// s of one tile on a grid of its own: coarser than the tile's it leaves the shortest waves out, finer it is smooth.
pub(super) struct Convergence {
    waves: Waves,
    resolution: usize,
    /// Columns with waves that the grid can hold.
    columns: usize,
    evolved: Vec<f32>,
    transform: InverseReal2d,
    /// 1/k_b⁴ in (m/rad)⁴.
    shortness: f32,
    scale: f32,
}

impl Convergence {
    /// Of the waves up to about `shortest` in rad/m, on `resolution` samples a side.
    pub(super) fn new(waves: &Waves, resolution: usize, shortest: f64) -> Result<Self, ParameterError> {
        let waves = waves.trimmed();
        let columns = (waves.reach + 1).min(waves.n / 2).min(resolution / 2);
        Ok(Self {
            columns,
            evolved: vec![0.0; columns * Column::len(waves.n)],
            transform: InverseReal2d::new(resolution)?,
            shortness: libm::pow(shortest, -4.0) as f32,
            scale: 1.0,
            waves,
            resolution,
        })
    }

    /// The same on another grid.
    pub(super) fn on_grid(&self, resolution: usize) -> Result<Self, ParameterError> {
        let other = Self::new(&self.waves, resolution, 1.0)?;
        Ok(Self { shortness: self.shortness, scale: self.scale, ..other })
    }

    /// Multiplies all that comes by `factor`.
    pub(super) fn scale(&mut self, factor: f64) {
        self.scale = (f64::from(self.scale) * factor) as f32;
    }

    pub(super) fn evaluate(&mut self, time_s: f64, out: &mut [f32]) {
        let waves = &self.waves;
        // The workers of this pass need no memory of their own, and a list of nothings allocates none.
        let mut workers = vec![(); thread_count(self.resolution)];
        for_each_run(&mut self.evolved, Column::len(waves.n), &mut workers, |p, run, ()| {
            evolve_column(waves, p, time_s, run);
        });
        let (evolved, columns) = (&self.evolved, self.columns);
        let (shortness, scale) = (self.shortness, self.scale);
        let fill = |p: usize, out: &mut [_]| {
            if p < columns {
                let share = |k2: f32| scale / (1.0 + shortness * k2 * k2);
                Column::of(waves, evolved, p).convergence(out, share);
            } else {
                out.fill(Default::default());
            }
        };
        self.transform.process_with(fill, out);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::spectral::{Amplitudes, Band, SpectralTile, SpectralTileParameters, Water};
    use crate::model::{TileFields, WaveModel};
    use crate::spectrum::phillips::{Phillips, PhillipsParameters};
    use glam::DVec2;

    /// With all waves it is what the tile's own fields say; on a grid of half as many samples the same at those.
    #[test]
    fn it_is_the_convergence_of_the_fields() {
        let wind = PhillipsParameters {
            wind_speed_mps: 10.0,
            toward: DVec2::X,
            significant_height_m: None,
            opposing_energy: 0.1,
            small_wave_cutoff_m: 0.0,
        };
        let parameters = SpectralTileParameters {
            tile_size_m: 100.0,
            resolution: 64,
            band: Band { from: 0.0, to: 15.5 * std::f64::consts::TAU / 100.0 },
            choppiness: 1.2,
            water: Water { current_mps: DVec2::new(0.7, -0.4), ..Water::STILL },
            seed: 3,
            amplitudes: Amplitudes::Gaussian,
        };
        let mut tile = SpectralTile::new(parameters, &[Phillips::new(wind).unwrap()]).unwrap();
        let mut fields = TileFields::default();
        tile.evaluate(12.3, &mut fields);
        for (n, stride) in [(64, 1), (32, 2)] {
            let mut field = vec![0.0; n * n];
            Convergence::new(tile.waves(), n, 1e6).unwrap().evaluate(12.3, &mut field);
            let mut size = 0.0_f32;
            for (i, value) in field.iter().enumerate() {
                let at = i / n * stride * 64 + i % n * stride;
                let expected = -(fields.gradient_xx[at] + fields.gradient_zz[at]);
                assert!((value - expected).abs() < 2e-6, "{n}, {i}: {value} {expected}");
                size = size.max(expected.abs());
            }
            assert!(size > 0.1, "{size}");
        }
        // Finer than the tile it still passes through the same samples.
        let mut fine = vec![0.0; 128 * 128];
        Convergence::new(tile.waves(), 128, 1e6).unwrap().evaluate(12.3, &mut fine);
        let expected = -(fields.gradient_xx[65] + fields.gradient_zz[65]);
        assert!((fine[2 * 128 + 2] - expected).abs() < 2e-6);
    }

    /// A wave of the length at which waves stop breaking counts half.
    #[test]
    fn short_waves_count_less() {
        let wind = PhillipsParameters {
            wind_speed_mps: 10.0,
            toward: DVec2::X,
            significant_height_m: None,
            opposing_energy: 0.0,
            small_wave_cutoff_m: 0.0,
        };
        let spacing = std::f64::consts::TAU / 400.0;
        let parameters = SpectralTileParameters {
            tile_size_m: 400.0,
            resolution: 64,
            // Hardly more than one ring.
            band: Band { from: 9.9 * spacing, to: 10.1 * spacing },
            choppiness: 1.0,
            water: Water::STILL,
            seed: 3,
            amplitudes: Amplitudes::Deterministic,
        };
        let tile = SpectralTile::of_cascade(parameters, 0, &[Phillips::new(wind).unwrap()]).unwrap();
        let size = |shortest: f64| {
            let mut field = vec![0.0; 64 * 64];
            Convergence::new(tile.waves(), 64, shortest).unwrap().evaluate(0.0, &mut field);
            crate::statistics::Moments::of(&field).variance.sqrt()
        };
        let ratio = size(10.0 * spacing) / size(1e6);
        assert!((ratio - 0.5).abs() < 0.01, "{ratio}");
    }
}
