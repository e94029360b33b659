//! A sea of several tiles.
//!
//! Symbols as in the [module above](super).

use super::sample::Sums;
use super::tile::{LEAST_CAPTURED, Share, SpectralTile, SpectralTileParameters, remedy};
use super::{Amplitudes, Cascade, Patchwork, Water};
use crate::error::{ParameterError, check};
use crate::model::{Surface, SurfacePoint};
use crate::query::{QueryError, Snapshot};
use crate::spectrum::{Profile, WaveSpectrum};
use glam::{DVec2, DVec3};
use std::sync::{Mutex, PoisonError};

/// What a [`SpectralSea`] is made from, beside its spectra.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectralSeaParameters {
    /// The tiles, one to eight; see [`Cascade::plan`]. Their bands should not overlap.
    pub cascades: Vec<Cascade>,
    /// λ, as for [`SpectralTileParameters`].
    pub choppiness: f64,
    /// What the waves run in.
    pub water: Water,
    /// Which of the random seas with these parameters.
    pub seed: u64,
    /// How the waves' amplitudes are chosen.
    pub amplitudes: Amplitudes,
}

/// A sea whose waves are shared out among tiles of different lengths; see the [module](super).
///
/// The surface is the sum of the tiles' displacements over the same rest point. Where their lengths have no common
/// multiple it never repeats, but waves of one tile do: see [`sewn`](Self::sewn).
pub struct SpectralSea {
    parameters: SpectralSeaParameters,
    tiles: Vec<SpectralTile>,
    /// Of the first tiles, those that do not repeat.
    patchworks: Vec<Patchwork>,
    /// What queries have made before. Their memory serves again, and their moment if it is the one that is asked for.
    snapshots: Mutex<Vec<Snapshot>>,
}

impl SpectralSea {
    /// The sea whose energy is the sum of `systems`: spectra by value, by reference or boxed.
    ///
    /// # Errors
    ///
    /// When a parameter is out of its range, or when less than half of a system's energy falls into the bands of
    /// all tiles together.
    pub fn new<S: WaveSpectrum>(
        parameters: SpectralSeaParameters,
        systems: &[S],
    ) -> Result<Self, ParameterError> {
        let count = parameters.cascades.len();
        check("cascades", count as f64, "from 1 to 8 tiles", |_| (1..=Cascade::MOST).contains(&count))?;
        let tile = |(index, cascade): (usize, &Cascade)| {
            let tile = SpectralTileParameters {
                tile_size_m: cascade.tile_size_m,
                resolution: cascade.resolution,
                band: cascade.band,
                choppiness: parameters.choppiness,
                water: parameters.water,
                seed: parameters.seed,
                amplitudes: parameters.amplitudes,
            };
            SpectralTile::of_cascade(tile, index as u64, systems)
        };
        let tiles = each(&parameters.cascades, tile)?;
        let sea = Self { parameters, tiles, patchworks: Vec::new(), snapshots: Mutex::default() };
        for (system, share) in sea.shares().enumerate() {
            if share.fraction() < LEAST_CAPTURED {
                let Cascade { tile_size_m, .. } = sea.parameters.cascades[0];
                let finest = sea.parameters.cascades[count - 1];
                // As many samples as the first tile would need to be as fine as the last.
                let resolution = finest.resolution as f64 * tile_size_m / finest.tile_size_m;
                return Err(ParameterError::SeaDoesNotFit {
                    system,
                    captured_fraction: share.fraction(),
                    tile_size_m,
                    resolution: resolution as usize,
                    remedy: remedy(&Profile::of(&systems[system]), tile_size_m, resolution as usize),
                });
            }
        }
        Ok(sea)
    }

    /// The same sea, whose first `tiles` tiles are sewn from patches that lie where chance has it, so that they do not repeat: see
    /// [`Patchwork`]. Its statistics stay as they are. What a tile's [fields](crate::model::WaveModel::evaluate) hold is the
    /// cloth, and three copies of it lie over a place.
    pub fn sewn(self, tiles: usize) -> Self {
        let seed = self.parameters.seed;
        let cascades = self.parameters.cascades.iter().take(tiles).enumerate();
        let patchworks = cascades.map(|(index, cascade)| Patchwork::new(cascade.tile_size_m, index, seed));
        Self { patchworks: patchworks.collect(), snapshots: Mutex::default(), ..self }
    }

    /// The patches of a tile; `None` where it repeats.
    pub fn patchwork(&self, tile: usize) -> Option<Patchwork> {
        self.patchworks.get(tile).copied()
    }

    /// The parameters that the sea was made from.
    pub fn parameters(&self) -> &SpectralSeaParameters {
        &self.parameters
    }

    /// The tiles, in the order of the parameters' cascades.
    pub fn tiles(&self) -> &[SpectralTile] {
        &self.tiles
    }

    /// The same, to be evaluated.
    pub fn tiles_mut(&mut self) -> &mut [SpectralTile] {
        &mut self.tiles
    }

    /// The tiles themselves, for a renderer.
    pub fn into_tiles(self) -> Vec<SpectralTile> {
        self.tiles
    }

    /// The share of each system's variance that the tiles carry together.
    pub fn captured_fractions(&self) -> Vec<f64> {
        self.shares().map(|share| share.fraction()).collect()
    }

    /// The velocity in m/s of the water that rests at `rest_m` and `depth_m` below the calm surface, current
    /// included: the direct sum. Linear theory has no answer above the calm surface; a negative depth gives that of
    /// the surface.
    pub fn velocity_below_mps(&self, rest_m: DVec2, depth_m: f64, time_s: f64) -> DVec3 {
        let current = self.parameters.water.current_mps;
        self.sums(rest_m, depth_m, time_s).velocity + DVec3::new(current.x, 0.0, current.y)
    }

    fn shares(&self) -> impl Iterator<Item = Share> + '_ {
        let systems = self.tiles.first().map_or(0, |tile| tile.shares().len());
        (0..systems).map(|system| Share {
            asked_m2: self.tiles[0].shares()[system].asked_m2,
            carried_m2: self.tiles.iter().map(|tile| tile.shares()[system].carried_m2).sum(),
        })
    }

    fn sums(&self, rest_m: DVec2, depth_m: f64, time_s: f64) -> Sums {
        let mut sums = Sums::default();
        for (index, tile) in self.tiles.iter().enumerate() {
            let of_tile = |rest_m| tile.sums(rest_m, depth_m, time_s);
            sums += match self.patchwork(index) {
                Some(patchwork) => patchwork.sums(rest_m, tile.parameters().tile_size_m, of_tile),
                None => of_tile(rest_m),
            };
        }
        sums
    }
}

impl Surface for SpectralSea {
    fn variance_m2(&self) -> f64 {
        self.tiles.iter().map(SpectralTile::variance_m2).sum()
    }

    fn sample(&self, rest_m: DVec2, time_s: f64) -> SurfacePoint {
        self.sums(rest_m, 0.0, time_s).surface(self.parameters.water.current_mps)
    }

    /// By a [`Snapshot`]: to within 1 mm or 0.1 % of the significant height of the direct sum, whichever is larger; velocities to
    /// within as much a second.
    fn query(&self, places_m: &[DVec2], time_s: f64) -> Result<Vec<SurfacePoint>, QueryError> {
        // Only who asks at the same time as another needs one more. A lock that a panic has poisoned holds whole ones.
        let kept = || self.snapshots.lock().unwrap_or_else(PoisonError::into_inner);
        let found = kept().pop();
        let mut snapshot = found.unwrap_or_else(|| Snapshot::new(self));
        if snapshot.time_s() != Some(time_s) {
            snapshot.take(self, time_s)?;
        }
        let answers = snapshot.query(places_m);
        kept().push(snapshot);
        answers
    }
}

/// Each cascade's tile, on as many threads as there are.
fn each<F>(cascades: &[Cascade], tile: F) -> Result<Vec<SpectralTile>, ParameterError>
where
    F: Fn((usize, &Cascade)) -> Result<SpectralTile, ParameterError> + Send + Sync,
{
    #[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
    {
        use rayon::prelude::*;
        cascades.par_iter().enumerate().map(tile).collect()
    }
    #[cfg(not(all(feature = "parallel", not(target_arch = "wasm32"))))]
    cascades.iter().enumerate().map(tile).collect()
}
