//! Wave systems: each is a spectrum and where it comes from; a sea has one or several.

mod asked;
mod elfouhaily;
mod jonswap;
mod parametric;
mod phillips;
mod pierson_moskowitz;
mod spreading;
mod tma;
mod warnings;

use whitecap_waves::ParameterError;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::{Omnidirectional, WaveSpectrum};

pub use elfouhaily::ElfouhailySystem;
pub use jonswap::JonswapSystem;
pub use phillips::PhillipsSystem;
pub use pierson_moskowitz::PiersonMoskowitzSystem;
pub use spreading::{Spreading, SpreadingLaw};
pub use tma::TmaSystem;

use parametric::Parametric;

use crate::error::SceneError;
use crate::key::{Accepts, Kind};
use crate::reader::ValueReader;
use crate::registry::{Registered, Tag, TagDefault};

/// One wave system, a table `[[sea.system]]`. It serialises as that table.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(tag = "spectrum", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum System {
    /// Pierson and Moskowitz's fully developed sea.
    PiersonMoskowitz(PiersonMoskowitzSystem),
    /// The growing sea of JONSWAP.
    Jonswap(JonswapSystem),
    /// The same over shallow water.
    Tma(TmaSystem),
    /// Elfouhaily's, with short waves and ripples.
    Elfouhaily(ElfouhailySystem),
    /// Phillips's wind sea as Tessendorf uses it.
    Phillips(PhillipsSystem),
}

/// Every spectrum.
pub const SPECTRA: &[Registered<System>] = &[
    pierson_moskowitz::REGISTERED,
    jonswap::REGISTERED,
    tma::REGISTERED,
    elfouhaily::REGISTERED,
    phillips::REGISTERED,
];

pub(crate) const TAG: Tag<System> = Tag {
    key: "spectrum",
    noun: "spectrum",
    doc: "How the energy is spread over wavelengths and directions.",
    default: TagDefault::Required,
    all: SPECTRA,
};

impl System {
    /// The spectrum of its waves on water with this dispersion.
    ///
    /// # Errors
    ///
    /// If the settings contradict each other or the water, such as a spectrum of shallow water over deep water.
    pub fn build(&self, dispersion: &Dispersion) -> Result<Box<dyn WaveSpectrum>, ParameterError> {
        match self.form() {
            Form::Parametric(system) => parametric::build(system, dispersion),
            Form::Phillips(system) => system.build(),
        }
    }

    /// Its energy over frequency; `None` for spectra that are known over wave vectors only.
    ///
    /// # Errors
    ///
    /// As [`build`](Self::build).
    pub fn omnidirectional(
        &self,
        dispersion: &Dispersion,
    ) -> Result<Option<Box<dyn Omnidirectional>>, ParameterError> {
        match self.form() {
            Form::Parametric(system) => system.sea(dispersion).map(Some),
            Form::Phillips(_) => Ok(None),
        }
    }

    /// What of it can be drawn but is not found at sea, in sentences without a full stop; empty for a usual sea
    /// and for one that cannot be built.
    pub fn warnings(&self, dispersion: &Dispersion) -> Vec<String> {
        match self.form() {
            Form::Parametric(system) => system.sea(dispersion).map_or_else(
                |_| Vec::new(),
                |sea| {
                    let (height_m, period_s) = (sea.significant_height_m(), sea.peak_period_s());
                    warnings::about(&system.asked(), height_m, period_s, system.gamma(), dispersion)
                },
            ),
            Form::Phillips(system) => system.warnings(dispersion),
        }
    }

    fn form(&self) -> Form<'_> {
        match self {
            Self::PiersonMoskowitz(system) => Form::Parametric(system),
            Self::Jonswap(system) => Form::Parametric(system),
            Self::Tma(system) => Form::Parametric(system),
            Self::Elfouhaily(system) => Form::Parametric(system),
            Self::Phillips(system) => Form::Phillips(system),
        }
    }
}

/// What a system's spectrum is made of.
enum Form<'a> {
    /// Energy over frequency and a spread.
    Parametric(&'a dyn Parametric),
    /// Phillips's, over wave vectors.
    Phillips(&'a PhillipsSystem),
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
