//! Settings of a wave system with Pierson and Moskowitz's spectrum.

use whitecap_waves::ParameterError;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::Omnidirectional;
use whitecap_waves::spectrum::pierson_moskowitz::PiersonMoskowitz;

use super::System;
use super::asked::{self, ANOTHER_WAY, Asked, PERIOD_OF_HEIGHT, Way};
use super::parametric::{Parametric, Spread};
use super::spreading::{AnySpreading, Spreading, SpreadingLaw};
use crate::key::{optional, or, required, table};
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<System> = Registered {
    word: "pierson-moskowitz",
    summary: "the fully developed wind sea (Pierson and Moskowitz 1964)",
    keys: PiersonMoskowitzSystem::keys,
    read: |table| {
        let system = PiersonMoskowitzSystem::read_keys(table).map(System::PiersonMoskowitz)?;
        asked::check(table, false).map(|()| system)
    },
};

table! {
    /// A fully developed wind sea: a table `[[sea.system]]` with `spectrum = "pierson-moskowitz"`.
    pub struct PiersonMoskowitzSystem {
        /// The mean wind speed 10 m above the sea, which has blown for long and over much water.
        wind_speed_mps: Option<f64> = optional(asked::WIND, ANOTHER_WAY);
        /// The significant height.
        significant_height_m: Option<f64> = optional(asked::HEIGHT, ANOTHER_WAY);
        /// The period of the spectrum's peak, with `significant_height_m`.
        peak_period_s: Option<f64> = optional(asked::PERIOD, PERIOD_OF_HEIGHT);
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

impl Parametric for PiersonMoskowitzSystem {
    fn asked(&self) -> Asked {
        Asked {
            wind_speed_mps: self.wind_speed_mps,
            beaufort: self.beaufort,
            significant_height_m: self.significant_height_m,
            peak_period_s: self.peak_period_s,
            sea_state: self.sea_state,
            ..Asked::default()
        }
    }

    fn spread(&self) -> Spread {
        Spread { from_deg: self.from_deg, spreading: self.spreading, swell: self.swell }
    }

    fn sea(&self, _: &Dispersion) -> Result<Box<dyn Omnidirectional>, ParameterError> {
        Ok(Box::new(match self.asked().way()? {
            Way::Wind { speed_mps, .. } => PiersonMoskowitz::from_wind(speed_mps)?,
            Way::Height { height_m, period_s } => {
                PiersonMoskowitz::from_height_and_period(height_m, period_s)?
            }
        }))
    }
}
