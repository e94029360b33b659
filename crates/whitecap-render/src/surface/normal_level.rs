//! The levels of a normal map and what they average away, on the processor.

use crate::threads::*;
use half::f16;
use whitecap_waves::model::TileFields;

/// Steeper than this (80°) a folded crest is not shaded: its normal would point under the water.
const MAX_SLOPE: f32 = 5.7;

/// One level of the normal map before encoding.
pub(super) struct NormalLevel {
    size: usize,
    /// Mean normal.
    normals: Vec<[f32; 3]>,
    /// Mean slope (x, z) and mean square slope.
    moments: Vec<[f32; 3]>,
}

impl NormalLevel {
    pub(super) fn of(fields: &TileFields) -> NormalLevel {
        let size = fields.resolution();
        let normals: Vec<[f32; 3]> = (0..size * size).into_par_iter().map(|i| fields.normal(i)).collect();
        let moments = normals
            .par_iter()
            .map(|&normal| {
                let [x, z] = slope_of(normal);
                [x, z, x * x + z * z]
            })
            .collect();
        NormalLevel { size, normals, moments }
    }

    pub(super) fn halved(&self) -> NormalLevel {
        let size = self.size / 2;
        let mean = |values: &[[f32; 3]]| -> Vec<[f32; 3]> {
            (0..size * size)
                .into_par_iter()
                .map(|i| {
                    let at = (i / size) * 2 * self.size + (i % size) * 2;
                    let four = [at, at + 1, at + self.size, at + self.size + 1];
                    std::array::from_fn(|c| 0.25 * four.iter().map(|&j| values[j][c]).sum::<f32>())
                })
                .collect()
        };
        NormalLevel { size, normals: mean(&self.normals), moments: mean(&self.moments) }
    }

    /// The mean slope (x, z) of texel `i`.
    pub(super) fn slope(&self, i: usize) -> [f32; 2] {
        let [x, z, _] = self.moments[i];
        [x, z]
    }

    fn lost(&self, i: usize) -> f32 {
        let [x, z, square] = self.moments[i];
        (square - x * x - z * z).max(0.0)
    }

    pub(super) fn mean_lost_variance(&self) -> f32 {
        let sum: f64 = (0..self.moments.len()).map(|i| f64::from(self.lost(i))).sum();
        (sum / self.moments.len() as f64) as f32
    }

    pub(super) fn texels(&self) -> Vec<[f16; 4]> {
        (0..self.normals.len())
            .into_par_iter()
            .map(|i| {
                let [x, y, z] = self.normals[i];
                [x, y, z, self.moments[i][2]].map(f16::from_f32)
            })
            .collect()
    }
}

/// Slopes of a surface with this normal, bounded where a crest has folded over.
pub(super) fn slope_of([x, y, z]: [f32; 3]) -> [f32; 2] {
    let y = y.max(1e-3);
    let (sx, sz) = (-x / y, -z / y);
    let scale = (MAX_SLOPE / sx.hypot(sz)).min(1.0);
    [sx * scale, sz * scale]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level() -> NormalLevel {
        let size = 16;
        let slope = |i: usize| {
            let (x, z) = ((i % size) as f32, (i / size) as f32);
            [0.3 * (x * 0.8).sin(), 0.2 * (z * 1.7 + x).cos()]
        };
        let normals = (0..size * size)
            .map(|i| {
                let [x, z] = slope(i);
                glam::Vec3::new(-x, 1.0, -z).normalize().to_array()
            })
            .collect();
        let moments = (0..size * size)
            .map(|i| {
                let [x, z] = slope(i);
                [x, z, x * x + z * z]
            })
            .collect();
        NormalLevel { size, normals, moments }
    }

    #[test]
    fn mean_square_and_lost_variance_add_up_at_every_level() {
        let mut level = level();
        let total = level.moments.iter().map(|m| m[2]).sum::<f32>() / level.moments.len() as f32;
        while level.size > 1 {
            level = level.halved();
            let sum: f32 = (0..level.moments.len())
                .map(|i| level.moments[i][0].powi(2) + level.moments[i][1].powi(2) + level.lost(i))
                .sum();
            assert!((sum / level.moments.len() as f32 / total - 1.0).abs() < 1e-5);
        }
    }

    #[test]
    fn slopes_undo_normals_and_stay_bounded() {
        let normal = glam::Vec3::new(-0.3, 1.0, 0.7).normalize().to_array();
        let [x, z] = slope_of(normal);
        assert!((x - 0.3).abs() < 1e-6 && (z + 0.7).abs() < 1e-6);
        let [x, z] = slope_of([-1.0, -0.2, 0.0]);
        assert!(x.hypot(z) <= MAX_SLOPE * 1.001 && x > 0.0);
    }
}
