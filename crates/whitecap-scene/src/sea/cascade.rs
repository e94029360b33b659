//! One of the tiles of a spectral sea: a table `[[sea.cascade]]`.

use crate::error::SceneError;
use crate::key::{Accepts, Key, Kind, PowerOfTwo, Real, or, required, table};
use crate::reader::ValueReader;

table! {
    /// A tile: a table `[[sea.cascade]]`. Each carries the waves that are too short for the next larger one.
    pub struct Cascade {
        /// The side of the square after which its waves repeat.
        tile_size_m: f64 = required(Real { unit: "m", min: 1.0, max: 100_000.0 });
        /// How many samples it has along a side.
        resolution: u32 = or(PowerOfTwo { min: 16, max: 2048 }, 256);
    }
}

/// The keys of a cascade.
pub(crate) const KEYS: fn() -> Vec<Key> = Cascade::keys;

/// One to eight tiles.
pub(super) struct Cascades;

impl Cascades {
    const MAX: usize = 8;
}

impl Kind for Cascades {
    type Value = Vec<Cascade>;

    fn accepts(&self) -> Accepts {
        Accepts::Tables { name: "sea.cascade", min: 1, max: Self::MAX }
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<Vec<Cascade>, SceneError> {
        let wrong_type = || value.wrong_type(&self.accepts().to_string());
        let tiles = value.array().ok_or_else(wrong_type)?;
        if !(1..=Self::MAX).contains(&tiles.len()) {
            return Err(value.error(format!("found {}; accepted: {}", tiles.len(), self.accepts())));
        }
        tiles.into_iter().map(|tile| Cascade::read(&tile.table()?)).collect()
    }
}
