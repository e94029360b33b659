//! Where the energy of spectra lies, over ln k and directions, as quantiles.

use crate::spectrum::WaveSpectrum;
use glam::DVec2;
use std::f64::consts::TAU;

/// The wave numbers looked at, in rad/m: from the longest swell to ripples.
const LOWEST: f64 = 1e-4;
const HIGHEST: f64 = 1e4;

/// Steps of ln k, 1.2 % each, and of the direction, 2.5° each; the directions at one k are finer.
const STEPS: usize = 1536;
const DIRECTIONS: usize = 144;
const FINE_DIRECTIONS: usize = 1440;

/// The energy of spectra on a polar grid.
pub(super) struct PolarEnergy<'a, S> {
    systems: &'a [S],
    /// The energy up to the end of each step of ln k, beginning with 0.
    cumulative: Vec<f64>,
}

impl<'a, S: WaveSpectrum> PolarEnergy<'a, S> {
    pub(super) fn new(systems: &'a [S]) -> Self {
        let mut cumulative = vec![0.0];
        let mut sum = 0.0;
        for step in 0..STEPS {
            let k = wave_number_at(step as f64 + 0.5);
            // Ψ d²k = Ψ k² d(ln k) dθ.
            let ring: f64 = (0..DIRECTIONS).map(|i| density(systems, k * direction(i, DIRECTIONS))).sum();
            sum += ring * k * k;
            cumulative.push(sum);
        }
        Self { systems, cumulative }
    }

    /// The sum over the grid, in no particular unit.
    pub(super) fn total(&self) -> f64 {
        self.cumulative[STEPS]
    }

    /// The wave number in rad/m below which the share `part`, 0..1, of the energy lies.
    pub(super) fn wave_number(&self, part: f64) -> f64 {
        wave_number_at(inverse(&self.cumulative, part))
    }

    /// The unit vector at which the share `part`, 0..1, of the energy at the wave number `k` lies, counted from
    /// the direction in which there is the least.
    pub(super) fn direction(&self, k: f64, part: f64) -> DVec2 {
        let ring: Vec<f64> =
            (0..FINE_DIRECTIONS).map(|i| density(self.systems, k * direction(i, FINE_DIRECTIONS))).collect();
        // Beginning where there is nothing keeps one lobe in one piece: its middle is the share ½.
        let peak = (0..FINE_DIRECTIONS).max_by(|&a, &b| ring[a].total_cmp(&ring[b])).unwrap_or(0);
        let start = peak + FINE_DIRECTIONS / 2;
        let mut cumulative = vec![0.0];
        let mut sum = 0.0;
        for i in 0..FINE_DIRECTIONS {
            sum += ring[(start + i) % FINE_DIRECTIONS];
            cumulative.push(sum);
        }
        // Steps are about their directions, half of each to either side.
        let place = start as f64 + inverse(&cumulative, part) - 0.5;
        let (sin, cos) = libm::sincos(TAU * place / FINE_DIRECTIONS as f64);
        DVec2::new(cos, sin)
    }
}

fn density<S: WaveSpectrum>(systems: &[S], k: DVec2) -> f64 {
    systems.iter().map(|system| system.density_m4(k)).sum()
}

/// The wave number after so many steps.
fn wave_number_at(steps: f64) -> f64 {
    LOWEST * libm::exp(steps / STEPS as f64 * libm::log(HIGHEST / LOWEST))
}

fn direction(i: usize, of: usize) -> DVec2 {
    let (sin, cos) = libm::sincos(TAU * i as f64 / of as f64);
    DVec2::new(cos, sin)
}

/// The place, in steps, at which a rising sum reaches the share `part` of its end.
fn inverse(cumulative: &[f64], part: f64) -> f64 {
    let wanted = part * cumulative[cumulative.len() - 1];
    let after = cumulative.partition_point(|&sum| sum <= wanted).clamp(1, cumulative.len() - 1);
    let (low, high) = (cumulative[after - 1], cumulative[after]);
    let within = if high > low { (wanted - low) / (high - low) } else { 0.5 };
    (after - 1) as f64 + within
}
