//! The sea: which model moves it, and the waves that it is made of.

mod calm;
mod cascade;
mod fitting;
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
pub use spectral::{Amplitudes, SpectralSettings, Tiling};
pub use surface::SeaSurface;
pub use wave::Wave;

pub(crate) use cascade::KEYS as CASCADE_KEYS;
pub(crate) use wave::KEYS as WAVE_KEYS;

use std::path::PathBuf;

use whitecap_waves::model::spectral::Water;
use whitecap_waves::spectrum::WaveSpectrum;

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
    /// How the scene's technique draws a spectral sea where the file leaves it open. It is not part of what the file
    /// says.
    #[serde(skip)]
    pub tiling: Tiling,
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
        let (model, tiling) = (table.tagged(&tag)?, technique.tiling());
        if let SeaModel::Spectral(settings) = &model {
            settings.check(table, technique.word(), &tiling)?;
        }
        Ok(Self { model, tiling })
    }

    /// What the waves of a spectral sea run in; still and deep for another.
    ///
    /// # Errors
    ///
    /// As [`SpectralSettings::water`].
    pub fn water(&self) -> Result<Water, SceneError> {
        match &self.model {
            SeaModel::Spectral(settings) => settings.water(),
            _ => Ok(Water::STILL),
        }
    }

    /// The depth of the water; `None` where it is deep.
    pub fn depth_m(&self) -> Option<f64> {
        let SeaModel::Spectral(settings) = &self.model else { return None };
        settings.depth_m
    }

    /// The strongest wind that any of its systems speaks of.
    pub fn wind_speed_mps(&self) -> Option<f64> {
        let SeaModel::Spectral(settings) = &self.model else { return None };
        settings.system.iter().filter_map(|system| system.requested().wind_speed_mps).reduce(f64::max)
    }

    /// The strongest wind of its systems, where one that speaks of a height alone, or of a sea state, has that of the
    /// fully developed sea of this height.
    pub fn developed_wind_mps(&self) -> Option<f64> {
        let SeaModel::Spectral(settings) = &self.model else { return None };
        settings.system.iter().filter_map(system::System::developed_wind_mps).reduce(f64::max)
    }

    /// Builds the sea, and says where it bends what was asked for, such as energy that its tiles cannot carry: one
    /// sentence each, with the figure and what to change.
    ///
    /// # Errors
    ///
    /// As [`build`](Self::build).
    pub fn warnings(&self, seed: u64) -> Result<Vec<String>, SceneError> {
        match &self.model {
            SeaModel::Spectral(settings) => settings.warnings(&self.tiling, seed),
            _ => self.build(seed).map(|_| Vec::new()),
        }
    }

    /// The files that it is read from.
    pub(crate) fn files_mut(&mut self) -> impl Iterator<Item = &mut PathBuf> {
        let systems = match &mut self.model {
            SeaModel::Spectral(settings) => settings.system.as_mut_slice(),
            _ => &mut [],
        };
        systems.iter_mut().filter_map(system::System::file_mut)
    }

    /// The moving surface itself. Equal settings and seeds give equal surfaces.
    ///
    /// # Errors
    ///
    /// If the settings contradict each other, such as waves that do not fit their tile. A scene that was read
    /// from a file has been built once, so it builds again.
    pub fn build(&self, seed: u64) -> Result<SeaSurface, SceneError> {
        match &self.model {
            SeaModel::Spectral(settings) => settings.build(&self.tiling, seed),
            SeaModel::Sines(settings) => settings.build(),
            SeaModel::Perlin(settings) => settings.build(seed),
            SeaModel::Calm(settings) => Ok(settings.build()),
        }
    }

    /// The spectra that the waves are drawn from, one for each `[[sea.system]]`; none where a sea has no such.
    ///
    /// # Errors
    ///
    /// As [`build`](Self::build).
    pub fn spectra(&self) -> Result<Vec<Box<dyn WaveSpectrum>>, SceneError> {
        match &self.model {
            SeaModel::Spectral(settings) => settings.spectra(),
            _ => Ok(Vec::new()),
        }
    }
}
