//! Settings of a wave system with Elfouhaily's spectrum.

use whitecap_waves::ParameterError;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::Omnidirectional;
use whitecap_waves::spectrum::elfouhaily::{Elfouhaily, YOUNGEST, inverse_age};

use super::System;
use super::asked::{self, ANOTHER_WAY, Asked, Way};
use super::parametric::{Parametric, Spread};
use super::spreading::{AnySpreading, Spreading, SpreadingLaw};
use crate::key::{optional, or, required, table};
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<System> = Registered {
    word: "elfouhaily",
    summary: "long and short waves in one spectrum (Elfouhaily and others 1997)",
    keys: ElfouhailySystem::keys,
    read: |table| {
        let system = ElfouhailySystem::read_keys(table).map(System::Elfouhaily)?;
        asked::check(table, false).map(|()| system)
    },
};

table! {
    /// A wind sea down to its ripples: a table `[[sea.system]]` with `spectrum = "elfouhaily"`.
    pub struct ElfouhailySystem {
        /// The mean wind speed 10 m above the sea.
        wind_speed_mps: Option<f64> = optional(asked::WIND, ANOTHER_WAY);
        /// The way over water that the wind has had, with `wind_speed_mps` or `beaufort`.
        fetch_km: Option<f64> = optional(asked::FETCH, "as far as waves grow");
        /// The significant height.
        significant_height_m: Option<f64> = optional(asked::HEIGHT, ANOTHER_WAY);
        /// The period of the spectrum's peak, with `significant_height_m`.
        peak_period_s: Option<f64> =
            optional(asked::PERIOD, "that of the wind that raises a fully developed sea of this height");
        /// The WMO's code for the state of the sea: its middle height.
        sea_state: Option<u32> = optional(asked::SEA_STATE, ANOTHER_WAY);
        /// The Beaufort number of the wind.
        beaufort: Option<u32> = optional(asked::BEAUFORT, ANOTHER_WAY);
        /// The bearing that the waves come from on the mean, clockwise from north.
        from_deg: f64 = required(asked::BEARING);
        /// How the directions are spread about it.
        spreading: Spreading = or(AnySpreading, Spreading::Law(SpreadingLaw::Elfouhaily));
        /// How far the waves have become swell: 0 leaves the spread as it is, 1 makes long waves nearly parallel.
        swell: f64 = or(asked::SWELL, 0.0);
    }
}

impl Parametric for ElfouhailySystem {
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

    fn bent(&self) -> Option<String> {
        let Ok(Way::Wind { speed_mps, fetch_m: Some(fetch_m) }) = self.asked().way() else { return None };
        let asked = inverse_age(speed_mps, fetch_m);
        (asked > YOUNGEST).then(|| {
            format!(
                "fetch_km = {}: so short a way under {speed_mps:.1} m/s of wind would be an inverse wave age of {asked:.1}, beyond \
                 Elfouhaily's law, which ends at {YOUNGEST}; that sea is drawn, higher than the fetch raises",
                fetch_m / 1000.0
            )
        })
    }

    fn spread(&self) -> Spread {
        Spread { from_deg: self.from_deg, spreading: self.spreading, swell: self.swell }
    }

    fn sea(&self, _: &Dispersion) -> Result<Box<dyn Omnidirectional>, ParameterError> {
        Ok(Box::new(match self.asked().way()? {
            Way::Wind { speed_mps, fetch_m: None } => Elfouhaily::from_wind(speed_mps)?,
            Way::Wind { speed_mps, fetch_m: Some(fetch_m) } => {
                Elfouhaily::from_wind_and_fetch(speed_mps, fetch_m)?
            }
            Way::Height { height_m, .. } => match self.peak_period_s {
                Some(period_s) => Elfouhaily::from_height_and_period(height_m, period_s)?,
                None => Elfouhaily::from_height(height_m)?,
            },
        }))
    }
}
