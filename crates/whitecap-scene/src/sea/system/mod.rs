//! Wave systems: each is a spectrum and where it comes from; a sea has one or several.

mod asked;
mod elfouhaily;
mod jonswap;
mod measured;
mod parametric;
mod phillips;
mod pierson_moskowitz;
mod spreading;
mod tma;
mod warnings;

use std::path::PathBuf;

use whitecap_waves::ParameterError;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::pierson_moskowitz::fully_developed_wind_mps;
use whitecap_waves::spectrum::{Omnidirectional, Profile, WaveSpectrum};
use whitecap_waves::statistics::significant_height_m;

pub use elfouhaily::ElfouhailySystem;
pub use jonswap::JonswapSystem;
pub use measured::{DirectionMethod, MeasuredSystem};
pub use phillips::PhillipsSystem;
pub use pierson_moskowitz::PiersonMoskowitzSystem;
pub use spreading::{Spreading, SpreadingLaw};
pub use tma::TmaSystem;

pub(super) use warnings::metres;

use asked::{Asked, HEIGHT};
use parametric::Parametric;

use crate::error::SceneError;
use crate::key::{Key, Tables};
use crate::named;
use crate::reader::TableReader;
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
    /// A measured sea: `measured` stands in place of `spectrum`.
    #[serde(untagged)]
    Measured(MeasuredSystem),
}

/// What a wave system says of its sea by itself; `None` where it leaves it to its spectrum.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Requested {
    /// By itself, as the height of a sea state, or as the sum of a measured record.
    pub significant_height_m: Option<f64>,
    /// By itself.
    pub peak_period_s: Option<f64>,
    /// The bearing that its waves come from.
    pub from_deg: Option<f64>,
    /// By itself, or as that of a Beaufort number.
    pub wind_speed_mps: Option<f64>,
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

/// The key that a measured system has in place of [`TAG`].
pub(crate) const MEASURED: &str = "measured";

/// The keys of a measured system.
pub(crate) const MEASURED_KEYS: fn() -> Vec<Key> = MeasuredSystem::keys;

impl System {
    /// The spectrum of its waves on water with this dispersion; `table` is what errors call this system, such as
    /// `sea.system[0]`. A measured system reads its file.
    ///
    /// # Errors
    ///
    /// If the settings contradict each other or the water, such as a spectrum of shallow water over deep water, or
    /// the file of a measured system cannot be used.
    pub fn build(&self, table: &str, dispersion: &Dispersion) -> Result<Box<dyn WaveSpectrum>, SceneError> {
        let spectrum = match self.form() {
            Form::Parametric(system) => parametric::build(system, dispersion),
            Form::Phillips(system) => system.build(),
            Form::Measured(system) => return system.build(table, dispersion),
        };
        spectrum.map_err(|error| problem(table, &error))
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
            Form::Phillips(_) | Form::Measured(_) => Ok(None),
        }
    }

    /// What it says of its sea before any spectrum is made of it.
    pub fn requested(&self) -> Requested {
        let of = |asked: Asked, from_deg: f64| Requested {
            significant_height_m: asked.height_m().ok().flatten(),
            peak_period_s: asked.peak_period_s,
            from_deg: Some(from_deg),
            wind_speed_mps: asked.wind_mps().ok().flatten(),
        };
        match self.form() {
            Form::Parametric(system) => of(system.asked(), system.spread().from_deg),
            Form::Phillips(system) => of(system.asked(), system.from_deg),
            Form::Measured(system) => Requested {
                significant_height_m: system.significant_height_m(),
                from_deg: system.from_deg,
                ..Requested::default()
            },
        }
    }

    /// The wind that raises it: the one that it names, or that of the fully developed sea of its height; `None` where
    /// it has a period of its own, as swell has, or was measured.
    pub fn developed_wind_mps(&self) -> Option<f64> {
        let Requested { significant_height_m, peak_period_s, wind_speed_mps, .. } = self.requested();
        match (wind_speed_mps, self) {
            (Some(wind), _) => Some(wind),
            (None, Self::Measured(_)) => None,
            (None, _) if peak_period_s.is_some() => None,
            (None, _) => significant_height_m.map(fully_developed_wind_mps),
        }
    }

    /// What of it can be drawn but is not found at sea, in sentences without a full stop; empty for a usual sea.
    /// `spectrum` is the one that it [builds](Self::build).
    pub fn warnings(&self, dispersion: &Dispersion, spectrum: &dyn WaveSpectrum) -> Vec<String> {
        match self.form() {
            Form::Parametric(system) => system.sea(dispersion).map_or_else(
                |_| Vec::new(),
                |sea| {
                    let (height_m, period_s) = (sea.significant_height_m(), sea.peak_period_s());
                    let asked = system.asked();
                    let mut warnings =
                        warnings::about(&asked, height_m, period_s, system.gamma(), dispersion);
                    warnings.extend(system.bent());
                    warnings.extend(warnings::about_period(&asked, spectrum, dispersion));
                    warnings
                },
            ),
            Form::Phillips(system) => system.warnings(spectrum, dispersion),
            Form::Measured(system) => system.warnings(spectrum, dispersion),
        }
    }

    fn form(&self) -> Form<'_> {
        match self {
            Self::PiersonMoskowitz(system) => Form::Parametric(system),
            Self::Jonswap(system) => Form::Parametric(system),
            Self::Tma(system) => Form::Parametric(system),
            Self::Elfouhaily(system) => Form::Parametric(system),
            Self::Phillips(system) => Form::Phillips(system),
            Self::Measured(system) => Form::Measured(system),
        }
    }

    /// The file of the user's that it is read from, if it is.
    pub(crate) fn file_mut(&mut self) -> Option<&mut PathBuf> {
        match self {
            Self::Measured(system) if named::file(&system.measured).is_none() => Some(&mut system.measured),
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

/// Refuses systems that are together higher than one may be asked to be.
pub(super) fn check_sum(spectra: &[Box<dyn WaveSpectrum>]) -> Result<(), SceneError> {
    let height_m = height_of_sum_m(spectra);
    if spectra.len() < 2 || height_m <= HEIGHT.max {
        return Ok(());
    }
    let problem = format!(
        "{height_m:.1} m of significant height together, as variances add; accepted: up to {} m",
        HEIGHT.max
    );
    Err(SceneError::about_key("sea.system", problem))
}

/// What of several systems together is not found at sea, unless one of them alone was warned of the same: `of_one`.
pub(super) fn warnings_of_sum(
    spectra: &[Box<dyn WaveSpectrum>],
    water: &Dispersion,
    of_one: &[String],
) -> Vec<String> {
    if spectra.len() < 2 {
        return Vec::new();
    }
    let peak = Profile::of_sum(spectra).peak_wave_number();
    let mut warnings = warnings::about_waves(height_of_sum_m(spectra), peak, water, "");
    let kind = |warning: &str| warning.split(':').next().unwrap_or_default().to_owned();
    warnings.retain(|warning| of_one.iter().all(|other| kind(other) != kind(warning)));
    warnings
}

fn height_of_sum_m(spectra: &[Box<dyn WaveSpectrum>]) -> f64 {
    significant_height_m(spectra.iter().map(WaveSpectrum::variance_m2).sum())
}

/// A spectrum's own complaint, under the key that it is about.
fn problem(table: &str, error: &ParameterError) -> SceneError {
    match error {
        ParameterError::OutOfRange { field, value, accepted } => SceneError::about_key(
            format!("{table}.{field}"),
            format!("{value} is out of range for this sea; accepted: {accepted}"),
        ),
        ParameterError::NeedsDepth => SceneError::about_key("sea.depth_m", error.to_string()),
        _ => SceneError::about_key(table, error.to_string()),
    }
}

/// What a system's spectrum is made of.
enum Form<'a> {
    /// Energy over frequency and a spread.
    Parametric(&'a dyn Parametric),
    /// Phillips's, over wave vectors.
    Phillips(&'a PhillipsSystem),
    /// Read from a file, over frequency and direction.
    Measured(&'a MeasuredSystem),
}

/// Any number of wave systems: as many as a file holds.
pub(super) const SYSTEMS: Tables<System> =
    Tables { name: "sea.system", min: 1, max: usize::MAX, read: System::read };
