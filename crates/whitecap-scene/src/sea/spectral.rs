//! Settings of a sea drawn from spectra and moved by a Fourier transform.

use whitecap_waves::ParameterError;
use whitecap_waves::model::spectral::{self, SpectralTile, SpectralTileParameters};

use super::system::{System, Systems};
use super::{SeaModel, SeaSurface};
use crate::error::SceneError;
use crate::key::{OneOf, PowerOfTwo, Real, or, required, table, words};
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<SeaModel> = Registered {
    word: "spectral",
    summary: "waves drawn from spectra and transformed on a periodic tile (Tessendorf)",
    keys: SpectralSettings::keys,
    read: |table| SpectralSettings::read_keys(table).map(SeaModel::Spectral),
};

words! {
    /// How the waves' amplitudes are drawn.
    pub enum Amplitudes {
        /// Every wave has the amplitude that its spectrum says; only phases are random.
        Deterministic = "deterministic",
        /// Amplitudes are random too, as in nature: the significant height varies from seed to seed.
        Gaussian = "gaussian",
    }
}

table! {
    /// A sea drawn from spectra: the table `[sea]` with `model = "spectral"`.
    pub struct SpectralSettings {
        /// The side of the square after which the sea repeats.
        tile_size_m: f64 = or(Real { unit: "m", min: 1.0, max: 10_000.0 }, 100.0);
        /// How many samples the tile has along a side.
        resolution: u32 = or(PowerOfTwo { min: 16, max: 2048 }, 64);
        /// How far crests are drawn together: 0 leaves them round, 1 is what linear theory says.
        choppiness: f64 = or(Real { unit: "", min: 0.0, max: 3.0 }, 1.0);
        /// How the waves' amplitudes are drawn.
        amplitudes: Amplitudes = or(OneOf::<Amplitudes>::WORDS, Amplitudes::Deterministic);
        /// The wave systems, `[[sea.system]]`; their variances add.
        system: Vec<System> = required(Systems);
    }
}

impl SpectralSettings {
    pub(super) fn build(&self, seed: u64) -> Result<SeaSurface, SceneError> {
        let systems = self.system.iter().enumerate().map(|(index, system)| {
            let key = |field: &str| format!("sea.system[{index}].{field}");
            let water = whitecap_waves::dispersion::Dispersion::DEEP;
            system.build(&format!("sea.system[{index}]"), &water, |error| problem(error, key))
        });
        let systems = systems.collect::<Result<Vec<_>, _>>()?;
        let parameters = SpectralTileParameters {
            tile_size_m: self.tile_size_m,
            resolution: self.resolution as usize,
            choppiness: self.choppiness,
            seed,
            amplitudes: match self.amplitudes {
                Amplitudes::Deterministic => spectral::Amplitudes::Deterministic,
                Amplitudes::Gaussian => spectral::Amplitudes::Gaussian,
            },
        };
        match SpectralTile::new(parameters, &systems) {
            Ok(sea) => Ok(SeaSurface::Tile(Box::new(sea))),
            Err(error) => Err(problem(&error, |field| format!("sea.{field}"))),
        }
    }
}

/// The sea's own complaint, under the key that it is about.
fn problem(error: &ParameterError, key: impl Fn(&str) -> String) -> SceneError {
    match error {
        ParameterError::OutOfRange { field, value, accepted } => SceneError::about_key(
            key(field),
            format!("{value} is out of range for this sea; accepted: {accepted}"),
        ),
        _ => SceneError::about_key("sea.tile_size_m", error.to_string()),
    }
}
