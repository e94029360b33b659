//! Settings of a sea of animated Perlin noise.

use whitecap_waves::model::perlin::{PerlinNoise, PerlinNoiseParameters};

use super::{SeaModel, SeaSurface};
use crate::error::SceneError;
use crate::key::{PowerOfTwo, Real, or, table};
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<SeaModel> = Registered {
    word: "perlin",
    summary: "eight octaves of animated Perlin noise (Johanson 2004)",
    keys: PerlinSettings::keys,
    read: |table| PerlinSettings::read_keys(table).map(SeaModel::Perlin),
};

table! {
    /// A sea of noise: the table `[sea]` with `model = "perlin"`.
    pub struct PerlinSettings {
        /// The height of the waves: what a noise of 1 is worth.
        strength_m: f64 = or(Real { unit: "m", min: 0.0, max: 50.0 }, 0.9);
        /// Texels of the noise to a metre.
        scale_per_m: f64 = or(Real { unit: "1/m", min: 0.001, max: 100.0 }, 0.38);
        /// The weight of each octave relative to the one before it.
        falloff: f64 = or(Real { unit: "", min: 0.01, max: 1.0 }, 0.607);
        /// Frames of noise that the first octave passes in a second.
        frames_per_s: f64 = or(Real { unit: "1/s", min: 0.0, max: 30.0 }, 1.4);
        /// How much faster each octave moves than the one before it.
        octave_speedup: f64 = or(Real { unit: "", min: 0.1, max: 4.0 }, 1.27);
        /// Texels along a side of one octave: 32 in the text, 16 in the published source.
        octave_size: u32 = or(PowerOfTwo { min: 8, max: 64 }, 32);
    }
}

impl PerlinSettings {
    pub(super) fn build(&self, seed: u64) -> Result<SeaSurface, SceneError> {
        let noise = PerlinNoise::new(PerlinNoiseParameters {
            strength_m: self.strength_m,
            scale_per_m: self.scale_per_m,
            falloff: self.falloff,
            animation_speed: self.frames_per_s,
            time_multiplier: self.octave_speedup,
            octave_size: self.octave_size as usize,
            seed,
        });
        noise.map(SeaSurface::Noise).map_err(|error| SceneError::about_key("sea", error.to_string()))
    }
}
