//! A sea in a handful of numbers.

use super::{DirectionalSum, PolarSpectrum, SlopeVariance, significant_height_m};
use crate::dispersion::Dispersion;
use crate::error::ParameterError;
use crate::model::spectral::Band;
use crate::spectrum::WaveSpectrum;
use glam::DVec2;
use std::f64::consts::TAU;

/// mₙ = ∫ωⁿ S dω in m² (rad/s)ⁿ, with ω in the water: an observer who drifts with it.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SpectralMoments {
    /// m₋₁ in m² s/rad.
    pub minus_1: f64,
    /// m0 in m².
    pub m0: f64,
    /// m1 in m² rad/s.
    pub m1: f64,
    /// m2 in m² (rad/s)².
    pub m2: f64,
    /// m4 in m² (rad/s)⁴. A tail of S ∝ ω⁻⁵ makes it grow with the band, without limit but slowly.
    pub m4: f64,
}

impl SpectralMoments {
    /// Adds waves of this energy and frequency.
    pub fn add(&mut self, energy_m2: f64, omega: f64) {
        let omega2 = omega * omega;
        self.minus_1 += energy_m2 / omega;
        self.m0 += energy_m2;
        self.m1 += energy_m2 * omega;
        self.m2 += energy_m2 * omega2;
        self.m4 += energy_m2 * omega2 * omega2;
    }
}

impl std::ops::AddAssign for SpectralMoments {
    fn add_assign(&mut self, other: Self) {
        self.minus_1 += other.minus_1;
        self.m0 += other.m0;
        self.m1 += other.m1;
        self.m2 += other.m2;
        self.m4 += other.m4;
    }
}

impl std::ops::MulAssign<f64> for SpectralMoments {
    fn mul_assign(&mut self, factor: f64) {
        self.minus_1 *= factor;
        self.m0 *= factor;
        self.m1 *= factor;
        self.m2 *= factor;
        self.m4 *= factor;
    }
}

/// The sea in numbers; see the [module above](super) for the symbols.
///
/// What a sea without waves does not have, such as a period, is `None`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SeaStatistics {
    /// The moments of the frequency spectrum.
    pub moments: SpectralMoments,
    /// Tp in s: one over the frequency where S(f) is largest.
    pub peak_period_s: Option<f64>,
    /// All energy, and where it goes.
    pub directions: DirectionalSum,
    /// The energy near the peak of S(f), and where it goes.
    pub peak_directions: DirectionalSum,
    /// Of the surface's slope.
    pub slope: SlopeVariance,
}

impl SeaStatistics {
    /// The statistics of all `spectra` together, within `band`; the same as
    /// [`PolarSpectrum::of`] and [`PolarSpectrum::statistics`].
    ///
    /// # Errors
    ///
    /// As [`PolarSpectrum::of`].
    pub fn of<S: WaveSpectrum>(
        spectra: &[S],
        dispersion: Dispersion,
        band: Band,
    ) -> Result<Self, ParameterError> {
        Ok(PolarSpectrum::of(spectra, dispersion, band)?.statistics())
    }

    /// Hs = 4√m0 in m.
    pub fn significant_height_m(&self) -> f64 {
        significant_height_m(self.moments.m0)
    }

    /// Tz = 2π√(m0/m2) in s: the mean time between upward crossings of the mean (Rice 1944).
    pub fn zero_crossing_period_s(&self) -> Option<f64> {
        ratio(self.moments.m0, self.moments.m2).map(|ratio| TAU * ratio.sqrt())
    }

    /// Tm01 = 2π m0/m1 in s, one over the mean frequency.
    pub fn mean_period_s(&self) -> Option<f64> {
        ratio(self.moments.m0, self.moments.m1).map(|ratio| TAU * ratio)
    }

    /// Te = Tm−1,0 = 2π m₋₁/m0 in s, the period of the sine with the height and the power of the sea.
    pub fn energy_period_s(&self) -> Option<f64> {
        ratio(self.moments.minus_1, self.moments.m0).filter(|&ratio| ratio > 0.0).map(|ratio| TAU * ratio)
    }

    /// The unit vector of the mean direction of travel; `None` where waves run all ways alike.
    pub fn mean_toward(&self) -> Option<DVec2> {
        self.directions.mean_toward()
    }

    /// The mean direction of travel of the waves near the peak of S(f).
    pub fn peak_toward(&self) -> Option<DVec2> {
        self.peak_directions.mean_toward()
    }

    /// The spread of the directions in radians; see [`DirectionalSum::spread_rad`].
    pub fn spread_rad(&self) -> Option<f64> {
        (self.directions.energy_m2 > 0.0).then(|| self.directions.spread_rad())
    }

    /// The variance of the slope along the mean direction and across it; `None` without one.
    pub fn slope_along_and_across(&self) -> Option<(f64, f64)> {
        self.mean_toward().map(|toward| (self.slope.along(toward), self.slope.along(toward.perp())))
    }
}

fn ratio(above: f64, below: f64) -> Option<f64> {
    (below > 0.0).then(|| above / below)
}

/// Where samples (x, y), ordered by x > 0, have their peak: that of the parabola through the largest and its two
/// neighbours in logarithms. `None` where nothing is above 0.
pub(super) fn peak_of(samples: &[(f64, f64)]) -> Option<(usize, f64)> {
    let (at, &(x, y)) = samples.iter().enumerate().max_by(|(_, a), (_, b)| a.1.total_cmp(&b.1))?;
    if y <= 0.0 {
        return None;
    }
    let neighbours = at.checked_sub(1).and_then(|before| Some((samples[before], *samples.get(at + 1)?)));
    let Some((before, after)) = neighbours.filter(|(before, after)| before.1 > 0.0 && after.1 > 0.0) else {
        return Some((at, x));
    };
    let offset = |(x1, y1): (f64, f64)| (libm::log(x1 / x), libm::log(y1 / y));
    let ((left, drop_left), (right, drop_right)) = (offset(before), offset(after));
    // y ≈ a u + b u² through the two neighbours; its top is at −a/2b.
    let curvature = (drop_right / right - drop_left / left) / (right - left);
    let slope = drop_right / right - curvature * right;
    let top = if curvature < 0.0 { (-0.5 * slope / curvature).clamp(left, right) } else { 0.0 };
    Some((at, x * libm::exp(top)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_wave_has_its_own_period_throughout() {
        let mut sea = SeaStatistics::default();
        assert_eq!((sea.zero_crossing_period_s(), sea.spread_rad(), sea.mean_toward()), (None, None, None));
        sea.moments.add(0.5, TAU / 8.0);
        for period_s in [sea.zero_crossing_period_s(), sea.mean_period_s(), sea.energy_period_s()] {
            assert!((period_s.unwrap() - 8.0).abs() < 1e-12);
        }
        assert!((sea.significant_height_m() - 8.0_f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn a_parabola_in_logarithms_is_found_between_its_samples() {
        let bell = |x: f64| 3.0 * libm::exp(-2.0 * libm::log(x / 1.234).powi(2));
        for step in [0.1, 0.17] {
            let samples: Vec<_> = (1..30).map(|i| f64::from(i) * step).map(|x| (x, bell(x))).collect();
            let (at, x) = peak_of(&samples).unwrap();
            assert!((x - 1.234).abs() < 1e-12 && (samples[at].0 - x).abs() < step);
        }
        assert_eq!(peak_of(&[(1.0, 2.0), (2.0, 1.0)]), Some((0, 1.0)));
        assert_eq!(peak_of(&[(1.0, 0.0), (2.0, 0.0)]), None);
        assert_eq!(peak_of(&[]), None);
    }
}
