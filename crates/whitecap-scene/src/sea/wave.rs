//! One of the waves of a sum of sines: a table `[[sea.wave]]`.

use crate::key::{Key, Pair, Real, Tables, or, required, table};

table! {
    /// A sine: a table `[[sea.wave]]`. A phase counts in turns: at 1 the wave is where it was at 0.
    pub struct Wave {
        /// The height, in the text's units (`unit_m`).
        height: f64 = required(Real { unit: "units", min: 0.0, max: 1000.0 });
        /// Where the wave is at time 0.
        offset_turns: f64 = or(Real { unit: "turns", min: -1000.0, max: 1000.0 }, 0.0);
        /// How fast it runs.
        speed_turns_per_s: f64 = required(Real { unit: "turns/s", min: -100.0, max: 100.0 });
        /// Turns of the wave in one unit of the texture coordinate, along u and v.
        direction_per_uv: [f64; 2] = required(Pair { unit: "turns", min: -1000.0, max: 1000.0 });
    }
}

/// The keys of a wave.
pub(crate) const KEYS: fn() -> Vec<Key> = Wave::keys;

/// Exactly four waves: the shader calculates them in one register.
pub(super) const WAVES: Tables<Wave> = Tables { name: "sea.wave", min: 4, max: 4, read: Wave::read };
