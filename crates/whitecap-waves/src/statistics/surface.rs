//! What a synthesised surface turned out to be.

use super::sea::peak_of;
use super::{
    DirectionalSum, FrequencyBin, LatticeWaves, Moments, SeaStatistics, SlopeVariance, SpectralMoments,
    frequency_bins,
};
use crate::model::spectral::Water;
use crate::model::{TileFields, WaveModel};
use glam::DVec2;
use std::f64::consts::TAU;

/// A surface that is the sum of one or several tiles, measured at one moment.
#[derive(Debug, Clone)]
pub struct SurfaceStatistics {
    /// Heights, periods, directions and slopes. m0 and the slope are those of the fields; the other moments and the
    /// directions those of the [waves](LatticeWaves). The peak is found between rings of the lattice, within about
    /// half its spacing.
    pub sea: SeaStatistics,
    /// The skewness of the height over the calm plane: 0 for a Gaussian sea.
    pub skewness: f64,
    /// The kurtosis of the height over the calm plane: 3 for a Gaussian sea.
    pub kurtosis: f64,
    /// The waves of each tile.
    pub waves: Vec<LatticeWaves>,
    /// S(f) of all tiles together.
    pub bins: Vec<FrequencyBin>,
}

impl SurfaceStatistics {
    /// Measures the sum of `tiles` at `time_s`. Their waves must run as they do in `water`, and be independent of each
    /// other: then cumulants add.
    pub fn measure<'a>(
        tiles: impl IntoIterator<Item = &'a mut dyn WaveModel>,
        water: &Water,
        time_s: f64,
    ) -> Self {
        let mut fields = TileFields::default();
        let (mut variance_m2, mut third, mut fourth) = (0.0, 0.0, 0.0);
        let (mut slope, mut waves) = (SlopeVariance::default(), Vec::new());
        for tile in tiles {
            waves.push(LatticeWaves::measure(tile, water, time_s, &mut fields));
            let height = Moments::of(&fields.height);
            variance_m2 += height.variance;
            third += height.skewness * height.variance * height.variance.sqrt();
            fourth +=
                if height.variance > 0.0 { (height.kurtosis - 3.0) * height.variance.powi(2) } else { 0.0 };
            slope += slope_of(&fields);
        }
        let bins = frequency_bins(&waves, water.dispersion);
        let whole: Vec<&FrequencyBin> = bins.iter().filter(|bin| bin.filled >= 0.5).collect();
        let samples: Vec<_> = whole.iter().map(|bin| (bin.frequency_hz, bin.density_m2phz)).collect();
        let peak = peak_of(&samples);
        let (moments, directions) = sum_of(&waves, water, variance_m2);
        let sea = SeaStatistics {
            moments,
            peak_period_s: peak.map(|(_, frequency_hz)| 1.0 / frequency_hz),
            directions,
            peak_directions: peak.map(|(at, _)| whole[at].sum).unwrap_or_default(),
            slope,
        };
        let flat = variance_m2 <= 0.0;
        Self {
            sea,
            skewness: if flat { 0.0 } else { third / (variance_m2 * variance_m2.sqrt()) },
            kurtosis: if flat { 0.0 } else { 3.0 + fourth / (variance_m2 * variance_m2) },
            waves,
            bins,
        }
    }

    /// The energy in m²/rad of the waves that travel within each of `count` equal sectors around the compass. The
    /// sectors follow each other from east to south; the first has east in its middle.
    pub fn sectors(&self, count: usize) -> Vec<f64> {
        let mut sectors = vec![0.0; count];
        let width = TAU / count as f64;
        for (k, energy_m2) in self.waves.iter().flat_map(LatticeWaves::waves) {
            if k != DVec2::ZERO && count > 0 {
                let place = (k.to_angle() / width + 0.5).rem_euclid(count as f64) as usize;
                sectors[place.min(count - 1)] += energy_m2 / width;
            }
        }
        sectors
    }
}

/// The moments of all waves, scaled to the variance that the field has: the waves' own sum is its mean over time,
/// from which it differs where waves run against each other, in Gaussian seas.
fn sum_of(waves: &[LatticeWaves], water: &Water, variance_m2: f64) -> (SpectralMoments, DirectionalSum) {
    let (mut moments, mut directions) = (SpectralMoments::default(), DirectionalSum::default());
    for tile in waves {
        let (tile_moments, tile_directions) = tile.sum(water);
        moments += tile_moments;
        directions.energy_m2 += tile_directions.energy_m2;
        directions.toward_m2 += tile_directions.toward_m2;
    }
    if moments.m0 > 0.0 {
        let scale = variance_m2 / moments.m0;
        moments *= scale;
        directions.energy_m2 *= scale;
        directions.toward_m2 *= scale;
    }
    (moments, directions)
}

fn slope_of(fields: &TileFields) -> SlopeVariance {
    let n = fields.slope_x.len().max(1) as f64;
    let mean =
        |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(&a, &b)| f64::from(a) * f64::from(b)).sum::<f64>() / n;
    SlopeVariance {
        xx: mean(&fields.slope_x, &fields.slope_x),
        xz: mean(&fields.slope_x, &fields.slope_z),
        zz: mean(&fields.slope_z, &fields.slope_z),
    }
}
