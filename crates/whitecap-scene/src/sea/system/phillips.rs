//! Settings of a wave system with Phillips's spectrum.

use whitecap_waves::ParameterError;
use whitecap_waves::direction::toward_from_nautical;
use whitecap_waves::spectrum::WaveSpectrum;
use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};

use super::System;
use crate::key::{Real, optional, or, required, table};
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<System> = Registered {
    word: "phillips",
    summary: "Phillips's spectrum with a cosine-squared spread, as in Tessendorf's notes",
    keys: PhillipsSystem::keys,
    read: |table| PhillipsSystem::read_keys(table).map(System::Phillips),
};

table! {
    /// A wind sea: a table `[[sea.system]]` with `spectrum = "phillips"`.
    pub struct PhillipsSystem {
        /// The mean wind speed 10 m above the sea.
        wind_speed_mps: f64 = required(Real { unit: "m/s", min: 0.1, max: 50.0 });
        /// The bearing that wind and waves come from, clockwise from north.
        from_deg: f64 = required(Real { unit: "deg", min: 0.0, max: 360.0 });
        /// The significant height to scale the waves to.
        significant_height_m: Option<f64> =
            optional(Real { unit: "m", min: 0.01, max: 40.0 }, "as high as the wind raises in time");
        /// The energy of waves that run against the wind, as a part of that of waves that run with it.
        opposing_energy: f64 = or(Real { unit: "", min: 0.0, max: 1.0 }, 0.0);
        /// Waves much shorter than 2π times this length are smoothed away; at most U²/g for the wind speed U.
        small_wave_cutoff_m: f64 = or(Real { unit: "m", min: 0.0, max: 10.0 }, 0.0);
    }
}

impl PhillipsSystem {
    pub(super) fn build(&self) -> Result<Box<dyn WaveSpectrum>, ParameterError> {
        let spectrum = Phillips::new(PhillipsParameters {
            wind_speed_mps: self.wind_speed_mps,
            toward: toward_from_nautical(self.from_deg),
            significant_height_m: self.significant_height_m,
            opposing_energy: self.opposing_energy,
            small_wave_cutoff_m: self.small_wave_cutoff_m,
        })?;
        Ok(Box::new(spectrum))
    }
}
