//! Settings of a wave system with Phillips's spectrum.

use whitecap_waves::ParameterError;
use whitecap_waves::direction::toward_from_nautical;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::WaveSpectrum;
use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};

use super::asked::{self, ANOTHER_WAY, Asked, Way};
use super::{System, warnings};
use crate::key::{Real, optional, or, required, table};
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<System> = Registered {
    word: "phillips",
    summary: "Phillips's spectrum with a cosine-squared spread, as in Tessendorf's notes",
    keys: PhillipsSystem::keys,
    read: |table| {
        let system = PhillipsSystem::read_keys(table).map(System::Phillips)?;
        asked::check(table, true).map(|()| system)
    },
};

table! {
    /// A wind sea: a table `[[sea.system]]` with `spectrum = "phillips"`.
    pub struct PhillipsSystem {
        /// The mean wind speed 10 m above the sea, which makes the waves long.
        wind_speed_mps: Option<f64> = optional(asked::WIND, ANOTHER_WAY);
        /// The significant height to scale the waves to; with `wind_speed_mps`, with `peak_period_s`, or alone.
        significant_height_m: Option<f64> = optional(asked::HEIGHT, "as high as the wind raises in time");
        /// The period of the spectrum's peak, with `significant_height_m`.
        peak_period_s: Option<f64> = optional(asked::PERIOD, asked::PERIOD_OF_HEIGHT);
        /// The WMO's code for the state of the sea: its middle height.
        sea_state: Option<u32> = optional(asked::SEA_STATE, ANOTHER_WAY);
        /// The Beaufort number of the wind.
        beaufort: Option<u32> = optional(asked::BEAUFORT, ANOTHER_WAY);
        /// The bearing that wind and waves come from, clockwise from north.
        from_deg: f64 = required(asked::BEARING);
        /// The energy of waves that run against the wind, as a part of that of waves that run with it.
        opposing_energy: f64 = or(Real { unit: "", min: 0.0, max: 1.0 }, 0.0);
        /// Waves much shorter than 2π times this length are smoothed away; at most U²/g for the wind speed U.
        small_wave_cutoff_m: f64 = or(Real { unit: "m", min: 0.0, max: 10.0 }, 0.0);
    }
}

impl PhillipsSystem {
    pub(super) fn build(&self) -> Result<Box<dyn WaveSpectrum>, ParameterError> {
        let (wind_speed_mps, significant_height_m) = self.wind_and_height()?;
        let spectrum = Phillips::new(PhillipsParameters {
            wind_speed_mps,
            toward: toward_from_nautical(self.from_deg),
            significant_height_m: Some(significant_height_m),
            opposing_energy: self.opposing_energy,
            small_wave_cutoff_m: self.small_wave_cutoff_m,
        })?;
        Ok(Box::new(spectrum))
    }

    pub(super) fn warnings(&self, spectrum: &dyn WaveSpectrum, dispersion: &Dispersion) -> Vec<String> {
        let Ok((wind_speed_mps, height_m)) = self.wind_and_height() else { return Vec::new() };
        let period_s = wind_speed_mps / Phillips::wind_of_peak_period_mps(1.0);
        let mut warnings = warnings::about(&self.asked(), height_m, period_s, None, dispersion);
        warnings.extend(warnings::about_period(&self.asked(), spectrum, dispersion));
        warnings
    }

    pub(super) fn asked(&self) -> Asked {
        Asked {
            wind_speed_mps: self.wind_speed_mps,
            beaufort: self.beaufort,
            fetch_km: None,
            significant_height_m: self.significant_height_m,
            peak_period_s: self.peak_period_s,
            sea_state: self.sea_state,
        }
    }

    /// The wind in m/s that makes the waves as long as they are, and their significant height in metres.
    fn wind_and_height(&self) -> Result<(f64, f64), ParameterError> {
        Ok(match self.asked().way()? {
            Way::Wind { speed_mps, .. } => {
                let natural = || Phillips::fully_developed_height_m(speed_mps);
                (speed_mps, self.significant_height_m.unwrap_or_else(natural))
            }
            Way::Height { height_m, period_s } => (Phillips::wind_of_peak_period_mps(period_s), height_m),
        })
    }
}
