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
//! that spectra are.

mod sampling;

use super::sea::peak_of;
use super::{DirectionalSum, SeaStatistics, SlopeVariance, SpectralMoments};
use crate::dispersion::Dispersion;
use crate::model::spectral::Band;
use glam::DVec2;
use std::f64::consts::TAU;

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

    /// The part of m0 in m² that lies within `band`, and of the slope's variance.
    pub fn within(&self, band: Band) -> (f64, SlopeVariance) {
        // Minus infinity for waves of any length: the shares below take it as the first ring.
        let (low, high) = (libm::log(band.from), libm::log(band.to));
        let (mut variance_m2, mut slope) = (0.0, SlopeVariance::default());
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
            let mean = |a: f64, b: f64| width * (a * (1.0 - middle) + b * middle);
            variance_m2 += mean(a.sum.energy_m2, b.sum.energy_m2);
            slope += SlopeVariance {
                xx: mean(a.slope.xx, b.slope.xx),
                xz: mean(a.slope.xz, b.slope.xz),
                zz: mean(a.slope.zz, b.slope.zz),
            };
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
        // Minus infinity for waves of any length: the shares below take it as the first ring.
        let (low, high) = (self.rings[after - 1].omega, self.rings[after].omega);
        let between = (omega - low) / (high - low);
        at(after - 1) * (1.0 - between) + at(after) * between
    }

    /// From density over u to density over f: 2π/(k c_g).
    fn per_hz(&self, ring: &Ring) -> f64 {
        TAU / (ring.k * self.dispersion.group_speed(ring.k))
    }
}
