//! One of the tiles of a spectral sea: a table `[[sea.cascade]]`.

use crate::key::{Key, PowerOfTwo, Real, Tables, or, required, table};

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
pub(super) const CASCADES: Tables<Cascade> =
    Tables { name: "sea.cascade", min: 1, max: 8, read: Cascade::read };
