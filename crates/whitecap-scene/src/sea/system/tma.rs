//! Settings of a wave system with the TMA spectrum.

use whitecap_waves::ParameterError;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::Omnidirectional;
use whitecap_waves::spectrum::tma::Tma;

use super::System;
use super::asked::{self, Asked, Way};
use super::jonswap::{JonswapSystem, of_wind};
use super::parametric::{Parametric, Spread};
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<System> = Registered {
    word: "tma",
    summary: "the growing wind sea over shallow water (Bouws and others 1985)",
    keys: JonswapSystem::keys,
    read: |table| {
        let system = JonswapSystem::read_keys(table).map(|system| System::Tma(TmaSystem(system)))?;
        asked::check(table, false).map(|()| system)
    },
};

/// A wind sea over shallow water, `depth_m` deep: a table `[[sea.system]]` with `spectrum = "tma"`. Its keys are those of
/// JONSWAP; a wind raises less of a sea than over deep water, and a height is the one over this depth.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(transparent)]
pub struct TmaSystem(pub JonswapSystem);

impl Parametric for TmaSystem {
    fn asked(&self) -> Asked {
        self.0.asked()
    }

    fn spread(&self) -> Spread {
        self.0.spread()
    }

    fn gamma(&self) -> Option<f64> {
        self.0.gamma()
    }

    fn sea(&self, dispersion: &Dispersion) -> Result<Box<dyn Omnidirectional>, ParameterError> {
        let (gamma, depth_m) = (self.0.gamma, dispersion.depth_m());
        Ok(Box::new(match self.asked().way()? {
            Way::Wind { speed_mps, fetch_m } => Tma::over(of_wind(speed_mps, fetch_m, gamma)?, depth_m)?,
            Way::Height { height_m, period_s } => {
                Tma::from_height_and_period(height_m, period_s, gamma, depth_m)?
            }
        }))
    }
}
