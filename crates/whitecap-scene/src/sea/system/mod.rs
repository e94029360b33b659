//! Wave systems: each is a spectrum and where it comes from; a sea has one or several.

mod measured;
mod phillips;

use std::path::PathBuf;

use whitecap_waves::ParameterError;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::WaveSpectrum;

pub use measured::{DirectionMethod, MeasuredSystem};
pub use phillips::PhillipsSystem;

use crate::error::SceneError;
use crate::key::{Accepts, Key, Kind};
use crate::reader::{TableReader, ValueReader};
use crate::registry::{Registered, Tag, TagDefault};

/// One wave system, a table `[[sea.system]]`. It serialises as that table.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(tag = "spectrum", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum System {
    /// Phillips's wind sea as Tessendorf uses it.
    Phillips(PhillipsSystem),
    /// A measured sea: `measured` stands in place of `spectrum`.
    #[serde(untagged)]
    Measured(MeasuredSystem),
}

/// Every spectrum.
pub const SPECTRA: &[Registered<System>] = &[phillips::REGISTERED];

pub(crate) const TAG: Tag<System> = Tag {
    key: "spectrum",
    noun: "spectrum",
    doc: "How the energy is spread over wavelengths and directions.",
    default: TagDefault::Required,
    all: SPECTRA,
};

/// The key that a measured system has in place of [`TAG`].
pub(crate) const MEASURED: &str = "measured";

/// The keys of a measured system.
pub(crate) const MEASURED_KEYS: fn() -> Vec<Key> = MeasuredSystem::keys;

impl System {
    /// The spectrum over water with this dispersion; `table` is what errors call this system, and `problem` words what
    /// is wrong with its parameters.
    pub(super) fn build(
        &self,
        table: &str,
        water: &Dispersion,
        problem: impl Fn(&ParameterError) -> SceneError,
    ) -> Result<Box<dyn WaveSpectrum>, SceneError> {
        match self {
            Self::Phillips(system) => system.build().map_err(|error| problem(&error)),
            Self::Measured(system) => system.build(table, water),
        }
    }

    /// The file that it is read from, if it is.
    pub(crate) fn file_mut(&mut self) -> Option<&mut PathBuf> {
        match self {
            Self::Measured(system) => Some(&mut system.measured),
            _ => None,
        }
    }

    fn read(table: &TableReader<'_>) -> Result<Self, SceneError> {
        if table.has(MEASURED) {
            return MeasuredSystem::read_checked(table).map(Self::Measured);
        }
        table.tagged(&TAG)
    }
}

/// One to eight wave systems.
pub(super) struct Systems;

impl Systems {
    const MAX: usize = 8;
}

impl Kind for Systems {
    type Value = Vec<System>;

    fn accepts(&self) -> Accepts {
        Accepts::Tables { name: "sea.system", min: 1, max: Self::MAX }
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<Vec<System>, SceneError> {
        let wrong_type = || value.wrong_type(&self.accepts().to_string());
        let systems = value.array().ok_or_else(wrong_type)?;
        if !(1..=Self::MAX).contains(&systems.len()) {
            return Err(value.error(format!("found {}; accepted: {}", systems.len(), self.accepts())));
        }
        systems.into_iter().map(|system| System::read(&system.table()?)).collect()
    }
}
