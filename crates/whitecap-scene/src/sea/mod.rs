//! The sea: which model moves it, and the wave systems it is made of.

mod spectral;
pub mod system;

use whitecap_waves::model::WaveModel;

pub use spectral::{Amplitudes, SpectralSettings};

use crate::error::SceneError;
use crate::reader::TableReader;
use crate::registry::{Registered, Tag};

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
}

/// Every sea model.
pub const MODELS: &[Registered<SeaModel>] = &[spectral::REGISTERED];

pub(crate) const TAG: Tag<SeaModel> = Tag {
    key: "model",
    noun: "sea model",
    doc: "What moves the surface.",
    default: Some("spectral"),
    all: MODELS,
};

impl Sea {
    pub(crate) fn read(table: &TableReader<'_>) -> Result<Self, SceneError> {
        table.tagged(&TAG).map(|model| Self { model })
    }

    /// The moving surface itself. Equal settings and seeds give equal surfaces.
    ///
    /// # Errors
    ///
    /// If the settings contradict each other, such as waves that do not fit their tile. A scene that was read
    /// from a file has been built once, so it builds again.
    pub fn build(&self, seed: u64) -> Result<Box<dyn WaveModel>, SceneError> {
        match &self.model {
            SeaModel::Spectral(settings) => settings.build(seed),
        }
    }
}
