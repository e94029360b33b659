//! Settings of a wave system with the JONSWAP spectrum.

use whitecap_waves::ParameterError;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::Omnidirectional;
use whitecap_waves::spectrum::jonswap::{Jonswap, MEAN_PEAK_ENHANCEMENT, fully_developed_fetch_m};

use super::System;
use super::asked::{self, ANOTHER_WAY, Asked, PERIOD_OF_HEIGHT, Way};
use super::parametric::{Parametric, Spread};
use super::spreading::{AnySpreading, Spreading, SpreadingLaw};
use crate::key::{optional, or, required, table};
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<System> = Registered {
    word: "jonswap",
    summary: "the growing wind sea of the JONSWAP experiment (Hasselmann and others 1973)",
    keys: JonswapSystem::keys,
    read: |table| {
        let system = JonswapSystem::read_keys(table).map(System::Jonswap)?;
        asked::check(table, false).map(|()| system)
    },
};

table! {
    /// A growing wind sea, or swell: a table `[[sea.system]]` with `spectrum = "jonswap"`.
    pub struct JonswapSystem {
        /// The mean wind speed 10 m above the sea.
        wind_speed_mps: Option<f64> = optional(asked::WIND, ANOTHER_WAY);
        /// The way over water that the wind has had, with `wind_speed_mps` or `beaufort`.
        fetch_km: Option<f64> = optional(asked::FETCH, "as far as waves grow");
        /// The significant height.
        significant_height_m: Option<f64> = optional(asked::HEIGHT, ANOTHER_WAY);
        /// The period of the spectrum's peak, with `significant_height_m`.
        peak_period_s: Option<f64> = optional(asked::PERIOD, PERIOD_OF_HEIGHT);
        /// How much higher the peak is than that of a fully developed sea; 1 to 7 in nature.
        gamma: f64 = or(asked::GAMMA, MEAN_PEAK_ENHANCEMENT);
        /// The WMO's code for the state of the sea: its middle height.
        sea_state: Option<u32> = optional(asked::SEA_STATE, ANOTHER_WAY);
        /// The Beaufort number of the wind.
        beaufort: Option<u32> = optional(asked::BEAUFORT, ANOTHER_WAY);
        /// The bearing that the waves come from on the mean, clockwise from north.
        from_deg: f64 = required(asked::BEARING);
        /// How the directions are spread about it.
        spreading: Spreading = or(AnySpreading, Spreading::Law(SpreadingLaw::Hasselmann));
        /// How far the waves have become swell: 0 leaves the spread as it is, 1 makes long waves nearly parallel.
        swell: f64 = or(asked::SWELL, 0.0);
    }
}

impl Parametric for JonswapSystem {
    fn asked(&self) -> Asked {
        Asked {
            wind_speed_mps: self.wind_speed_mps,
            beaufort: self.beaufort,
            fetch_km: self.fetch_km,
            significant_height_m: self.significant_height_m,
            peak_period_s: self.peak_period_s,
            sea_state: self.sea_state,
        }
    }

    fn spread(&self) -> Spread {
        Spread { from_deg: self.from_deg, spreading: self.spreading, swell: self.swell }
    }

    fn gamma(&self) -> Option<f64> {
        Some(self.gamma)
    }

    fn sea(&self, _: &Dispersion) -> Result<Box<dyn Omnidirectional>, ParameterError> {
        Ok(Box::new(match self.asked().way()? {
            Way::Wind { speed_mps, fetch_m } => of_wind(speed_mps, fetch_m, self.gamma)?,
            Way::Height { height_m, period_s } => {
                Jonswap::from_height_and_period(height_m, period_s, self.gamma)?
            }
        }))
    }
}

/// The sea of a wind; without a fetch, over all the water in which it can grow.
pub(super) fn of_wind(speed_mps: f64, fetch_m: Option<f64>, gamma: f64) -> Result<Jonswap, ParameterError> {
    let fetch_m = fetch_m.unwrap_or_else(|| fully_developed_fetch_m(speed_mps));
    Jonswap::from_wind_and_fetch(speed_mps, fetch_m, gamma)
}
