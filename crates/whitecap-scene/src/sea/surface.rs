//! A sea that has been built, in the form in which it reaches a renderer.

use std::ops::Deref;

use whitecap_waves::model::perlin::PerlinNoise;
use whitecap_waves::model::sines::SumOfSines;
use whitecap_waves::model::spectral::SpectralSea;
use whitecap_waves::model::{Calm, Surface, WaveModel};

/// A moving surface. Every form of it is a [`Surface`] and can be asked for its height; the form is what a
/// renderer draws it by.
#[non_exhaustive]
pub enum SeaSurface {
    /// A tile that repeats: it reaches the GPU as maps.
    Tile(Box<dyn WaveModel>),
    /// Tiles that share a spectrum out among them: each reaches the GPU as maps.
    Spectral(Box<SpectralSea>),
    /// Four sines: they reach the GPU as constants.
    Sines(SumOfSines),
    /// Noise in packed octaves: it reaches the GPU as two textures.
    Noise(PerlinNoise),
    /// A level that stays.
    Calm(Calm),
}

impl SeaSurface {
    /// The tiles that it is made of, the largest first; `None` for a sea of another form.
    pub fn into_tiles(self) -> Option<Vec<Box<dyn WaveModel>>> {
        match self {
            Self::Tile(model) => Some(vec![model]),
            Self::Spectral(sea) => {
                Some(sea.into_tiles().into_iter().map(|tile| Box::new(tile) as Box<dyn WaveModel>).collect())
            }
            _ => None,
        }
    }
}

impl Deref for SeaSurface {
    type Target = dyn Surface;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Tile(model) => &**model,
            Self::Spectral(sea) => &**sea,
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
            Self::Spectral(_) => "Spectral",
            Self::Sines(_) => "Sines",
            Self::Noise(_) => "Noise",
            Self::Calm(_) => "Calm",
        })
    }
}
