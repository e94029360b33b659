//! Sampling spectra until their integrals stand still.
//!
//! Symbols as in the [module above](super). Samples are added in u or in θ until every second one would have done.

use super::{PolarSpectrum, Ring};
use crate::dispersion::Dispersion;
use crate::error::{ParameterError, check};
use crate::model::spectral::Band;
use crate::spectrum::WaveSpectrum;
use crate::statistics::{DirectionalSum, SlopeVariance};
use glam::DVec2;
use std::f64::consts::TAU;

/// How far the integrals may change when every second sample is left out. The error of the whole rule is a small
/// part of that.
const TOLERANCE: f64 = 5e-4;

/// Samples of the first attempt: the step of u, and the number of directions.
const FIRST: (f64, usize) = (0.02, 128);

/// The finest step of u and the largest number of directions: e-folding swells of 1 % of their wave number.
const FINEST: (f64, usize) = (0.0025, 1024);

impl PolarSpectrum {
    /// Samples all `spectra` together within `band`, as far as it lies between 1e-4 and 1e4 rad/m (60 km and 0.6 mm),
    /// finely enough for integrals to 1e-3, with any frequency as
    /// `dispersion` says.
    ///
    /// # Errors
    ///
    /// If the band is empty or a density is not finite.
    pub fn of<S: WaveSpectrum>(
        spectra: &[S],
        dispersion: Dispersion,
        band: Band,
    ) -> Result<Self, ParameterError> {
        let band = band.of_a_sea();
        check("from", band.from, "a wave number", |_| true)?;
        check("to", band.to, "a wave number above `from`, between 1e-4 and 1e4 rad/m", |k| k > band.from)?;
        let expected: f64 = spectra.iter().map(WaveSpectrum::variance_m2).sum();
        let (mut step, mut directions) = FIRST;
        loop {
            let sampled = Self::sample(spectra, dispersion, band, step, directions)?;
            // A swell that falls between the samples shows only in what is missing.
            let missing = sampled.total().energy_m2 < 0.9 * expected;
            let finer_step = missing || sampled.differs(&sampled.thinned(2, 1));
            let more_directions = missing || sampled.differs(&sampled.thinned(1, 2));
            let (before, around) = (step, directions);
            if finer_step {
                step = FINEST.0.max(0.5 * step);
            }
            if more_directions {
                directions = FINEST.1.min(2 * directions);
            }
            if (step, directions) == (before, around) {
                return Ok(sampled);
            }
        }
    }

    fn sample<S: WaveSpectrum>(
        spectra: &[S],
        dispersion: Dispersion,
        band: Band,
        step: f64,
        directions: usize,
    ) -> Result<Self, ParameterError> {
        let length = libm::log(band.to / band.from);
        // An even number of steps, so that every second ring reaches both ends.
        let steps = (((length / step).ceil() as usize).max(2)).next_multiple_of(2);
        let step = length / steps as f64;
        let directions: Vec<DVec2> =
            (0..directions).map(|j| DVec2::from_angle(TAU * j as f64 / directions as f64)).collect();
        let mut energy_m2 = vec![0.0; (steps + 1) * directions.len()];
        let rings = energy_m2.chunks_mut(directions.len()).enumerate().map(|(i, run)| {
            let k = band.from * libm::exp(step * i as f64);
            for (energy, direction) in run.iter_mut().zip(&directions) {
                *energy = k * k * spectra.iter().map(|s| s.density_m4(k * direction)).sum::<f64>();
            }
            Ring::of(k, dispersion.angular_frequency(k), &directions, run, 1)
        });
        let rings: Vec<Ring> = rings.collect();
        let sampled = Self { dispersion, step, rings, directions, energy_m2 };
        let sum = sampled.total().energy_m2;
        check("density_m4", sum, "finite", |_| true)?;
        Ok(sampled)
    }

    /// Every so manieth ring and direction.
    fn thinned(&self, by_rings: usize, by_directions: usize) -> Self {
        let n = self.directions.len();
        let rings = self.rings.iter().zip(self.energy_m2.chunks(n)).step_by(by_rings);
        Self {
            dispersion: self.dispersion,
            step: self.step * by_rings as f64,
            rings: rings
                .map(|(ring, run)| Ring::of(ring.k, ring.omega, &self.directions, run, by_directions))
                .collect(),
            directions: Vec::new(),
            energy_m2: Vec::new(),
        }
    }

    fn differs(&self, other: &Self) -> bool {
        let ((a, slope_a), (b, slope_b)) = ((self.total(), self.slope()), (other.total(), other.slope()));
        let change = (a.energy_m2 - b.energy_m2).abs().max(a.toward_m2.distance(b.toward_m2));
        let slope_change = (slope_a.xx - slope_b.xx).abs().max((slope_a.zz - slope_b.zz).abs());
        change > TOLERANCE * a.energy_m2 || slope_change > TOLERANCE * slope_a.total()
    }
}

impl Ring {
    /// From every `by`th of the `run` of e over `directions`.
    fn of(k: f64, omega: f64, directions: &[DVec2], run: &[f64], by: usize) -> Self {
        let (mut sum, mut slope) = (DirectionalSum::default(), SlopeVariance::default());
        let width = TAU * by as f64 / directions.len() as f64;
        for (energy, &direction) in run.iter().zip(directions).step_by(by) {
            sum.add(width * energy, direction);
            slope += SlopeVariance::of_waves(k * k * width * energy, direction);
        }
        Self { k, omega, sum, slope }
    }
}
