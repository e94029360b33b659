//! Foam at a place.

use super::{Foam, FoamTile};
use crate::model::spectral::Patch;
use glam::DVec2;

impl Foam {
    /// The share of the water at `rest_m` that foam covers, by the fields of the moment that it was
    /// [brought to](Foam::evaluate): between samples the fields are linear.
    pub fn cover_at(&self, rest_m: DVec2) -> f64 {
        let sum: f64 = self.tiles.iter().map(|tile| tile.value_at(rest_m, self.resolution)).sum();
        self.cover_of(sum, 0.0)
    }
}

impl FoamTile {
    fn value_at(&self, rest_m: DVec2, n: usize) -> f64 {
        let Some(patchwork) = self.patchwork else { return self.value_of_tile(rest_m, n) };
        let of_patch = |Patch { shift, weight, .. }: Patch| {
            weight * weight * libm::exp(self.value_of_tile(rest_m + shift * self.tile_size_m, n))
        };
        libm::log(patchwork.patches_at(rest_m).into_iter().map(of_patch).sum::<f64>())
    }

    fn value_of_tile(&self, rest_m: DVec2, n: usize) -> f64 {
        let place = (rest_m / self.tile_size_m).fract_gl() * n as f64;
        let corner = place.floor();
        let DVec2 { x, y: z } = place - corner;
        let (column, row) = (corner.x as usize % n, corner.y as usize % n);
        let value = |row: usize, column: usize| f64::from(self.field[(row % n) * n + column % n]);
        let along = |row: usize| (1.0 - x) * value(row, column) + x * value(row, column + 1);
        (1.0 - z) * along(row) + z * along(row + 1)
    }
}
