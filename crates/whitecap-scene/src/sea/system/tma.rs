//! Settings of a wave system with the TMA spectrum.

use whitecap_waves::ParameterError;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::Omnidirectional;
use whitecap_waves::spectrum::jonswap::MEAN_PEAK_ENHANCEMENT;
use whitecap_waves::spectrum::tma::Tma;

use super::System;
use super::asked::{self, ANOTHER_WAY, Asked, PERIOD_OF_HEIGHT, Way};
use super::jonswap::of_wind;
use super::parametric::{Parametric, Spread};
use super::spreading::{AnySpreading, Spreading, SpreadingLaw};
use crate::key::{optional, or, required, table};
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<System> = Registered {
    word: "tma",
    summary: "the growing wind sea over shallow water (Bouws and others 1985)",
    keys: TmaSystem::keys,
    read: |table| {
        let system = TmaSystem::read_keys(table).map(System::Tma)?;
        asked::check(table, false).map(|()| system)
    },
};

table! {
    /// A wind sea over shallow water, `depth_m` deep: a table `[[sea.system]]` with `spectrum = "tma"`.
    pub struct TmaSystem {
        /// The mean wind speed 10 m above the sea, which raises less of a sea than over deep water.
        wind_speed_mps: Option<f64> = optional(asked::WIND, ANOTHER_WAY);
        /// The way over water that the wind has had, with `wind_speed_mps` or `beaufort`.
        fetch_km: Option<f64> = optional(asked::FETCH, "as far as waves grow");
        /// The significant height over this depth.
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

impl Parametric for TmaSystem {
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

    fn sea(&self, dispersion: &Dispersion) -> Result<Box<dyn Omnidirectional>, ParameterError> {
        let depth_m = dispersion.depth_m();
        Ok(Box::new(match self.asked().way()? {
            Way::Wind { speed_mps, fetch_m } => Tma::over(of_wind(speed_mps, fetch_m, self.gamma)?, depth_m)?,
            Way::Height { height_m, period_s } => {
                Tma::from_height_and_period(height_m, period_s, self.gamma, depth_m)?
            }
        }))
    }
}
