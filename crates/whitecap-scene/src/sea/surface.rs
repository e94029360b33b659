//! A sea that has been built, in the form in which it reaches a renderer.

use std::ops::Deref;

use whitecap_waves::model::perlin::PerlinNoise;
use whitecap_waves::model::sines::SumOfSines;
use whitecap_waves::model::{Calm, Surface, WaveModel};

/// A moving surface. Every form of it is a [`Surface`] and can be asked for its height; the form is what a
/// renderer draws it by.
#[non_exhaustive]
pub enum SeaSurface {
    /// A tile that repeats: it reaches the GPU as maps.
    Tile(Box<dyn WaveModel>),
    /// Four sines: they reach the GPU as constants.
    Sines(SumOfSines),
    /// Noise in packed octaves: it reaches the GPU as two textures.
    Noise(PerlinNoise),
    /// A level that stays.
    Calm(Calm),
}

impl Deref for SeaSurface {
    type Target = dyn Surface;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Tile(model) => &**model,
            Self::Sines(sines) => sines,
            Self::Noise(noise) => noise,
            Self::Calm(calm) => calm,
        }
    }
}

impl std::fmt::Debug for SeaSurface {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Tile(_) => "Tile",
            Self::Sines(_) => "Sines",
            Self::Noise(_) => "Noise",
            Self::Calm(_) => "Calm",
        })
    }
}
