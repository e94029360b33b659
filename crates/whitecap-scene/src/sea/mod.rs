//! The sea: which model moves it, and the waves that it is made of.

mod calm;
mod cascade;
mod perlin;
mod sines;
mod spectral;
mod surface;
pub mod system;
mod wave;

pub use calm::CalmSettings;
pub use cascade::Cascade;
pub use perlin::PerlinSettings;
pub use sines::{SinesSettings, Taylor};
pub use spectral::{Amplitudes, SpectralSettings};
pub use surface::SeaSurface;
pub use wave::Wave;

pub(crate) use cascade::KEYS as CASCADE_KEYS;
pub(crate) use spectral::Tiling;
pub(crate) use wave::KEYS as WAVE_KEYS;

use crate::error::SceneError;
use crate::reader::{TableReader, quoted_list};
use crate::registry::{Registered, Tag, TagDefault};
use crate::technique::Technique;

/// The sea, the table `[sea]`. It serialises as that table.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Sea {
    /// What moves the surface, with its settings.
    #[serde(flatten)]
    pub model: SeaModel,
}

/// A model of the moving surface, with its settings.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(tag = "model", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum SeaModel {
    /// Waves drawn from spectra, transformed on a periodic tile.
    Spectral(SpectralSettings),
    /// Four sines.
    Sines(SinesSettings),
    /// Animated Perlin noise.
    Perlin(PerlinSettings),
    /// No waves at all.
    Calm(CalmSettings),
}

/// Every sea model.
pub const MODELS: &[Registered<SeaModel>] =
    &[spectral::REGISTERED, sines::REGISTERED, perlin::REGISTERED, calm::REGISTERED];

pub(crate) const TAG: Tag<SeaModel> = Tag {
    key: "model",
    noun: "sea model",
    doc: "What moves the surface. Each technique draws models of its own.",
    default: TagDefault::Decided("the technique's first"),
    all: MODELS,
};

impl SeaModel {
    /// The model's word in scene files.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Spectral(_) => spectral::REGISTERED.word,
            Self::Sines(_) => sines::REGISTERED.word,
            Self::Perlin(_) => perlin::REGISTERED.word,
            Self::Calm(_) => calm::REGISTERED.word,
        }
    }
}

impl Sea {
    /// Reads the sea that `technique` draws; the first of its models is meant where the file names none. Another
    /// model is refused before its settings are read: they would not help.
    pub(crate) fn read(table: &TableReader<'_>, technique: &Technique) -> Result<Self, SceneError> {
        let models = technique.sea_models();
        let tag = TAG.or(models.first().copied().unwrap_or("spectral"));
        if !models.contains(&table.read(tag.key, &tag)?.word) {
            return Err(table.error(
                Some(tag.key),
                format!(
                    "not a sea that technique = \"{}\" draws; accepted: {}",
                    technique.word(),
                    quoted_list(models)
                ),
            ));
        }
        let mut model = table.tagged(&tag)?;
        if let SeaModel::Spectral(settings) = &mut model {
            settings.complete(table, technique.word(), &technique.tiling())?;
        }
        Ok(Self { model })
    }

    /// Where `surface`, built from this sea, bends what was asked for, such as energy that its tiles cannot carry:
    /// one sentence each, with the figure and what to change.
    pub fn warnings(&self, surface: &SeaSurface) -> Vec<String> {
        match (&self.model, surface) {
            (SeaModel::Spectral(settings), SeaSurface::Spectral(sea)) => settings.warnings(sea),
            _ => Vec::new(),
        }
    }

    /// The moving surface itself. Equal settings and seeds give equal surfaces.
    ///
    /// # Errors
    ///
    /// If the settings contradict each other, such as waves that do not fit their tile. A scene that was read
    /// from a file has been built once, so it builds again.
    pub fn build(&self, seed: u64) -> Result<SeaSurface, SceneError> {
        match &self.model {
            SeaModel::Spectral(settings) => settings.build(seed),
            SeaModel::Sines(settings) => settings.build(),
            SeaModel::Perlin(settings) => settings.build(seed),
            SeaModel::Calm(settings) => Ok(settings.build()),
        }
    }
}
