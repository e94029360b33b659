//! Spectra sampled over wave number and direction, and what follows by integration.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | u | ln k | |
//! | θ | direction of travel | rad |
//! | e | k²Ψ, variance density over u and θ: Ψ d²k = e du dθ | m² |
//! | c_g | group speed dω/dk | m/s |
//!
//! With df = c_g k du/2π, E(f, θ) = 2π e/(k c_g).
//!
//! The rule is the trapezoid's in both: it converges exponentially in θ, which is periodic, and in u for the bells
//! that spectra are. Samples are added in either until every second one would have done.

use super::sea::peak_of;
use super::{DirectionalSum, SeaStatistics, SlopeVariance, SpectralMoments};
use crate::dispersion::Dispersion;
use crate::error::{ParameterError, check};
use crate::spectrum::WaveSpectrum;
use glam::DVec2;
use std::f64::consts::TAU;

/// How far the integrals may change when every second sample is left out. The error of the whole rule is a small
/// part of that.
const TOLERANCE: f64 = 5e-4;

/// Samples of the first attempt: the step of u, and the number of directions.
const FIRST: (f64, usize) = (0.02, 128);

/// The finest step of u and the largest number of directions: e-folding swells of 1 % of their wave number.
const FINEST: (f64, usize) = (0.0025, 1024);

/// Which waves count, by their wave numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveBand {
    /// The lowest wave number in rad/m, above 0.
    pub lowest: f64,
    /// The highest wave number in rad/m, above the lowest.
    pub highest: f64,
}

impl WaveBand {
    /// Every wave of the sea: from 60 km to 0.6 mm.
    pub const ALL: Self = Self { lowest: 1e-4, highest: 1e4 };

    /// What a square lattice carries along its axes: from waves as long as the tile to those of two samples.
    pub fn of_tile(tile_size_m: f64, resolution: usize) -> Self {
        let lowest = TAU / tile_size_m;
        Self { lowest, highest: lowest * resolution as f64 / 2.0 }
    }
}

/// The energy of one wave number.
#[derive(Debug, Clone, Copy)]
struct Ring {
    k: f64,
    omega: f64,
    /// ∫e dθ and ∫e (cos θ, sin θ) dθ.
    sum: DirectionalSum,
    /// ∫k² e (cos², cos sin, sin²) dθ.
    slope: SlopeVariance,
}

/// Spectra, summed and sampled over wave number and direction.
#[derive(Debug, Clone)]
pub struct PolarSpectrum {
    dispersion: Dispersion,
    /// From u to u.
    step: f64,
    rings: Vec<Ring>,
    /// Unit vectors of travel, evenly around, the first of them east.
    directions: Vec<DVec2>,
    /// e, a run over the directions for each ring.
    energy_m2: Vec<f64>,
}

impl PolarSpectrum {
    /// Samples all `spectra` together within `band`, finely enough for integrals to 1e-3, with any frequency as
    /// `dispersion` says.
    ///
    /// # Errors
    ///
    /// If the band is empty or a density is not finite.
    pub fn of<S: WaveSpectrum>(
        spectra: &[S],
        dispersion: Dispersion,
        band: WaveBand,
    ) -> Result<Self, ParameterError> {
        check("lowest", band.lowest, "above 0", |k| k > 0.0)?;
        check("highest", band.highest, "above the lowest wave number", |k| k > band.lowest)?;
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
        band: WaveBand,
        step: f64,
        directions: usize,
    ) -> Result<Self, ParameterError> {
        let length = libm::log(band.highest / band.lowest);
        // An even number of steps, so that every second ring reaches both ends.
        let steps = (((length / step).ceil() as usize).max(2)).next_multiple_of(2);
        let step = length / steps as f64;
        let directions: Vec<DVec2> =
            (0..directions).map(|j| DVec2::from_angle(TAU * j as f64 / directions as f64)).collect();
        let mut energy_m2 = vec![0.0; (steps + 1) * directions.len()];
        let rings = energy_m2.chunks_mut(directions.len()).enumerate().map(|(i, run)| {
            let k = band.lowest * libm::exp(step * i as f64);
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

    /// The rings with their shares of u.
    fn weighted(&self) -> impl Iterator<Item = (f64, &Ring)> {
        let last = self.rings.len() - 1;
        let weight = move |i: usize| if i == 0 || i == last { 0.5 * self.step } else { self.step };
        self.rings.iter().enumerate().map(move |(i, ring)| (weight(i), ring))
    }

    /// m0 in m², and where the energy goes.
    pub fn total(&self) -> DirectionalSum {
        let mut total = DirectionalSum::default();
        for (weight, ring) in self.weighted() {
            total.energy_m2 += weight * ring.sum.energy_m2;
            total.toward_m2 += weight * ring.sum.toward_m2;
        }
        total
    }

    /// The variance of the slope.
    pub fn slope(&self) -> SlopeVariance {
        let mut total = SlopeVariance::default();
        for (weight, Ring { slope, .. }) in self.weighted() {
            total += SlopeVariance { xx: weight * slope.xx, xz: weight * slope.xz, zz: weight * slope.zz };
        }
        total
    }

    /// The part of m0 in m² that lies within `band`, and of the mean square slope.
    pub fn within(&self, band: WaveBand) -> (f64, f64) {
        let (low, high) = (libm::log(band.lowest), libm::log(band.highest));
        let (mut variance_m2, mut slope) = (0.0, 0.0);
        for pair in self.rings.windows(2) {
            let [a, b] = pair else { continue };
            let (start, end) = (libm::log(a.k), libm::log(b.k));
            let (from, to) = (
                ((low - start) / (end - start)).clamp(0.0, 1.0),
                ((high - start) / (end - start)).clamp(0.0, 1.0),
            );
            // Both are straight lines between two rings.
            let middle = 0.5 * (from + to);
            let width = self.step * (to - from).max(0.0);
            variance_m2 += width * (a.sum.energy_m2 * (1.0 - middle) + b.sum.energy_m2 * middle);
            slope += width * (a.slope.total() * (1.0 - middle) + b.slope.total() * middle);
        }
        (variance_m2, slope)
    }

    /// Heights, periods, directions and slopes.
    pub fn statistics(&self) -> SeaStatistics {
        let mut moments = SpectralMoments::default();
        for (weight, ring) in self.weighted() {
            moments.add(weight * ring.sum.energy_m2, ring.omega);
        }
        let peak = peak_of(&self.frequency_spectrum());
        SeaStatistics {
            moments,
            peak_period_s: peak.map(|(_, frequency_hz)| 1.0 / frequency_hz),
            directions: self.total(),
            peak_directions: peak.map(|(at, _)| self.rings[at].sum).unwrap_or_default(),
            slope: self.slope(),
        }
    }

    /// Frequencies in Hz, rising, and S(f) in m²/Hz there.
    pub fn frequency_spectrum(&self) -> Vec<(f64, f64)> {
        let sample = |ring: &Ring| (ring.omega / TAU, ring.sum.energy_m2 * self.per_hz(ring));
        self.rings.iter().map(sample).collect()
    }

    /// Unit vectors of travel, evenly around, and ∫E df in m²/rad there: the energy by direction.
    pub fn direction_spectrum(&self) -> Vec<(DVec2, f64)> {
        let n = self.directions.len();
        let mut sums = vec![0.0; n];
        for ((weight, _), run) in self.weighted().zip(self.energy_m2.chunks(n)) {
            sums.iter_mut().zip(run).for_each(|(sum, energy)| *sum += weight * energy);
        }
        self.directions.iter().copied().zip(sums).collect()
    }

    /// E(f, θ) in m²/(Hz rad) at a frequency in Hz and for waves towards a unit vector, between the samples by
    /// straight lines; 0 outside the band.
    pub fn directional_density(&self, frequency_hz: f64, toward: DVec2) -> f64 {
        let omega = TAU * frequency_hz;
        let after = self.rings.partition_point(|ring| ring.omega < omega);
        if after == 0 || after == self.rings.len() {
            return 0.0;
        }
        let n = self.directions.len();
        let turn = toward.to_angle().rem_euclid(TAU) / TAU * n as f64;
        let (j, across) = (turn as usize % n, turn.fract());
        let at = |i: usize| {
            let run = &self.energy_m2[i * n..][..n];
            (run[j] * (1.0 - across) + run[(j + 1) % n] * across) * self.per_hz(&self.rings[i])
        };
        let (low, high) = (self.rings[after - 1].omega, self.rings[after].omega);
        let between = (omega - low) / (high - low);
        at(after - 1) * (1.0 - between) + at(after) * between
    }

    /// From density over u to density over f: 2π/(k c_g).
    fn per_hz(&self, ring: &Ring) -> f64 {
        TAU / (ring.k * self.dispersion.group_speed(ring.k))
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
