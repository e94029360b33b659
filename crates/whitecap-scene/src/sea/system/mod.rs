//! Wave systems: each is a spectrum and where it comes from; a sea has one or several.

mod phillips;

use whitecap_waves::ParameterError;
use whitecap_waves::spectrum::WaveSpectrum;

pub use phillips::PhillipsSystem;

use crate::error::SceneError;
use crate::key::{Accepts, Kind};
use crate::reader::ValueReader;
use crate::registry::{Registered, Tag, TagDefault};

/// One wave system, a table `[[sea.system]]`. It serialises as that table.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(tag = "spectrum", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum System {
    /// Phillips's wind sea as Tessendorf uses it.
    Phillips(PhillipsSystem),
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

impl System {
    pub(super) fn build(&self) -> Result<Box<dyn WaveSpectrum>, ParameterError> {
        match self {
            Self::Phillips(system) => system.build(),
        }
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
        systems.into_iter().map(|system| system.table()?.tagged(&TAG)).collect()
    }
}
