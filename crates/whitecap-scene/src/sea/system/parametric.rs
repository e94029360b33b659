//! What the parametric spectra share: they are energy over frequency, spread over directions.

use whitecap_waves::ParameterError;
use whitecap_waves::direction::toward_from_nautical;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::directional::{Directional, DirectionalParameters};
use whitecap_waves::spectrum::{Omnidirectional, WaveSpectrum};
use whitecap_waves::spreading;

use super::asked::Asked;
use super::spreading::Spreading;

/// A system whose spectrum is S(ω) × D(ω, θ).
pub(super) trait Parametric {
    /// How it says how high and how long its waves are.
    fn asked(&self) -> Asked;

    /// The peak enhancement, for spectra that have one.
    fn gamma(&self) -> Option<f64> {
        None
    }

    /// Where its law ends short of what is asked of it: a sentence without a full stop.
    fn bent(&self) -> Option<String> {
        None
    }

    /// Its directions.
    fn spread(&self) -> Spread;

    /// Its energy over frequency, on water with this dispersion.
    fn sea(&self, dispersion: &Dispersion) -> Result<Box<dyn Omnidirectional>, ParameterError>;
}

/// The directions of a system, as its keys say them.
pub(super) struct Spread {
    pub(super) from_deg: f64,
    pub(super) spreading: Spreading,
    pub(super) swell: f64,
}

/// The spectrum of a parametric system.
pub(super) fn build(
    system: &dyn Parametric,
    dispersion: &Dispersion,
) -> Result<Box<dyn WaveSpectrum>, ParameterError> {
    let Spread { from_deg, spreading, swell } = system.spread();
    let parameters = DirectionalParameters {
        spread: spreading::Spread { spreading: spreading.into(), swell },
        toward: toward_from_nautical(from_deg),
        dispersion: *dispersion,
    };
    Ok(Box::new(Directional::new(system.sea(dispersion)?, parameters)?))
}
