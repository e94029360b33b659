//! The waves that a tile carries, measured on its surface.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | L, N | side of the tile, samples along it | m, – |
//! | k | 2π (p, q)/L, a wave vector of the lattice | rad/m |
//! | h(k, t) | Fourier coefficient of the height | m |
//! | a, b | of the waves towards k and towards −k at time t | m |
//! | δ | time between two looks at the surface | s |
//! | U | current | m/s |
//!
//! One look cannot tell a wave from its like that runs the other way. Two can: h(t) = a + b and
//! h(t + δ) = a e^{−iωδ} + b e^{+iωδ}, once the current's turn e^{−ik·Uδ} of both is taken back, so a = (h(t) e^{+iωδ} − h(t + δ)) / (2i sin ωδ). The waves towards k have the
//! energy 2|a|²: half of it stands at −k, as the surface is real.

use super::{DirectionalSum, SpectralMoments};
use crate::dispersion::Dispersion;
use crate::model::spectral::Water;
use crate::model::{TileFields, WaveModel};
use glam::DVec2;
use rustfft::FftPlanner;
use rustfft::num_complex::Complex;
use std::f64::consts::{PI, TAU};

/// ωδ of the fastest wave: below π, where two looks no longer tell it from a slower one.
const FASTEST_TURN: f64 = 2.5;

/// A wave with less than this share of the largest one's energy is taken for rounding.
const ROUNDING: f64 = 1e-12;

/// The energy of each wave of a tile.
#[derive(Debug, Clone)]
pub struct LatticeWaves {
    tile_size_m: f64,
    resolution: usize,
    /// Of the wave towards (p, q), 1 − N/2 ≤ p, q < N/2, at (q + N/2) N + p + N/2; m².
    energy_m2: Vec<f64>,
}

impl LatticeWaves {
    /// Looks at `tile` twice, at `time_s` and shortly after. The waves must run as they do in `water`; `fields` is left
    /// as at `time_s`.
    pub fn measure(tile: &mut dyn WaveModel, water: &Water, time_s: f64, fields: &mut TileFields) -> Self {
        let (n, tile_size_m) = (tile.resolution(), tile.tile_size_m());
        let half = n as i32 / 2;
        let spacing = TAU / tile_size_m;
        let fastest = TAU * water.turns_per_s(spacing * f64::from(half) * std::f64::consts::SQRT_2);
        let delta_s = FASTEST_TURN / fastest;
        tile.evaluate(time_s + delta_s, fields);
        let later = coefficients(&fields.height, n);
        tile.evaluate(time_s, fields);
        let now = coefficients(&fields.height, n);

        let mut energy_m2 = vec![0.0; n * n];
        for q in 1 - half..half {
            for p in 1 - half..half {
                if (p, q) == (0, 0) {
                    continue;
                }
                let k = spacing * DVec2::new(f64::from(p), f64::from(q));
                let omega = TAU * water.turns_per_s(k.length());
                let (carried_sin, carried_cos) = libm::sincos(TAU * water.drift_turns_per_s(k) * delta_s);
                let carried_back = Complex::new(carried_cos, carried_sin);
                let (sin, cos) = libm::sincos(omega * delta_s);
                // Where transforms keep negative numbers.
                let stored = q.rem_euclid(n as i32) as usize * n + p.rem_euclid(n as i32) as usize;
                let towards = (now[stored] * Complex::new(cos, sin) - later[stored] * carried_back)
                    / Complex::new(0.0, 2.0 * sin);
                energy_m2[((q + half) * n as i32 + p + half) as usize] = 2.0 * towards.norm_sqr();
            }
        }
        Self { tile_size_m, resolution: n, energy_m2 }
    }

    /// The wave vectors in rad/m and their energies in m².
    pub fn waves(&self) -> impl Iterator<Item = (DVec2, f64)> {
        let (n, half) = (self.resolution, (self.resolution / 2) as f64);
        let spacing = self.spacing();
        self.energy_m2.iter().enumerate().map(move |(i, &energy_m2)| {
            (DVec2::new((i % n) as f64 - half, (i / n) as f64 - half) * spacing, energy_m2)
        })
    }

    /// All waves together.
    pub fn sum(&self, water: &Water) -> (SpectralMoments, DirectionalSum) {
        let (mut moments, mut directions) = (SpectralMoments::default(), DirectionalSum::default());
        for (k, energy_m2) in self.waves().filter(|&(k, _)| k != DVec2::ZERO) {
            let length = k.length();
            moments.add(energy_m2, TAU * water.turns_per_s(length));
            directions.add(energy_m2, k / length);
        }
        (moments, directions)
    }

    /// L in metres.
    pub fn tile_size_m(&self) -> f64 {
        self.tile_size_m
    }

    /// N.
    pub fn resolution(&self) -> usize {
        self.resolution
    }

    /// Between neighbours of the lattice, rad/m.
    fn spacing(&self) -> f64 {
        TAU / self.tile_size_m
    }

    /// The smallest and the largest wave number that has energy; `None` on calm water.
    fn reach(&self) -> Option<(f64, f64)> {
        let largest = self.energy_m2.iter().copied().fold(0.0, f64::max);
        let there = self.waves().filter(|&(_, energy)| energy > ROUNDING * largest);
        there.map(|(k, _)| k.length()).fold(None, |reach, k| {
            let (low, high) = reach.unwrap_or((k, k));
            Some((k.min(low), k.max(high)))
        })
    }
}

/// h(k) of the field, negative numbers at N + p.
fn coefficients(field: &[f32], n: usize) -> Vec<Complex<f64>> {
    let mut rows: Vec<Complex<f64>> = field.iter().map(|&x| Complex::new(f64::from(x), 0.0)).collect();
    let transform = FftPlanner::new().plan_fft_forward(n);
    transform.process(&mut rows);
    let mut columns = transposed(&rows, n);
    transform.process(&mut columns);
    let mut result = transposed(&columns, n);
    let scale = 1.0 / (n * n) as f64;
    result.iter_mut().for_each(|h| *h *= scale);
    result
}

fn transposed(values: &[Complex<f64>], n: usize) -> Vec<Complex<f64>> {
    (0..n * n).map(|i| values[i % n * n + i / n]).collect()
}

/// Waves of about one frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrequencyBin {
    /// The middle of the bin, by wave number, as a frequency in Hz.
    pub frequency_hz: f64,
    /// S(f) in m²/Hz. Of a bin that is less than half filled it is too low.
    pub density_m2phz: f64,
    /// How much of the bin's ring lattice points fill, each with its cell: about 1, less in the corners of the
    /// lattice, where some directions are missing.
    pub filled: f64,
    /// The energy of the waves in the bin, and where it goes.
    pub sum: DirectionalSum,
}

/// The spectrum S(f) of waves on one or several lattices, in rings that are at least as wide as a lattice's
/// spacing and 6 % of their wave number.
///
/// A narrow ring catches more or fewer lattice points than its area deserves; its density allows for that.
pub fn frequency_bins(tiles: &[LatticeWaves], dispersion: Dispersion) -> Vec<FrequencyBin> {
    let reaches: Vec<(&LatticeWaves, f64, f64)> = tiles
        .iter()
        .filter_map(|tile| tile.reach().map(|(low, high)| (tile, low - 1e-9 * low, high + 1e-9 * high)))
        .collect();
    let Some(edges) = edges(&reaches) else { return Vec::new() };
    let bounds = bounds(&reaches);
    let mut sums = vec![(DirectionalSum::default(), 0.0); edges.len() - 1];
    for (&(tile, low, high), &(from, to)) in reaches.iter().zip(&bounds) {
        for (k, energy_m2) in tile.waves() {
            let length = k.length();
            if let Some(bin) = edges.partition_point(|&edge| edge <= length).checked_sub(1)
                && bin < sums.len()
                && (low..=high).contains(&length)
            {
                let (sum, area) = &mut sums[bin];
                sum.add(energy_m2, k / length);
                *area += tile.spacing() * tile.spacing() * share_within(k, tile.spacing(), from, to);
            }
        }
    }
    let bins = edges.windows(2).zip(sums).filter(|(_, (_, area))| *area > 0.0);
    bins.map(|(edge, (sum, area))| {
        let (low, high) = (edge[0], edge[1]);
        let hz = |k: f64| dispersion.angular_frequency(k) / TAU;
        let filled = area / (PI * (high * high - low * low));
        // Rings that stand out of the lattice have waves in some directions only, which say nothing about others.
        let even = if (0.5..2.0).contains(&filled) { filled } else { 1.0 };
        FrequencyBin {
            frequency_hz: hz(0.5 * (low + high)),
            density_m2phz: sum.energy_m2 / (even * (hz(high) - hz(low))),
            filled,
            sum,
        }
    })
    .collect()
}

/// Where each lattice hands over to the next: the wave numbers that its own waves lie between, rad/m. A cell that a border
/// cuts has energy on both lattices, with its middle up to half a diagonal beyond the border on either.
fn bounds(reaches: &[(&LatticeWaves, f64, f64)]) -> Vec<(f64, f64)> {
    let mut by_length: Vec<usize> = (0..reaches.len()).collect();
    by_length.sort_by(|&a, &b| reaches[a].1.total_cmp(&reaches[b].1));
    let mut bounds = vec![(0.0, f64::INFINITY); reaches.len()];
    for pair in by_length.windows(2) {
        let ((coarse, _, high), (fine, low, _)) = (reaches[pair[0]], reaches[pair[1]]);
        let both = coarse.spacing() + fine.spacing();
        if low - high < both {
            let border = high - (high - low) * coarse.spacing() / both;
            (bounds[pair[0]].1, bounds[pair[1]].0) = (border, border);
        }
    }
    bounds
}

/// How much of the cell about `k` lies between two wave numbers, as if they bounded it by straight lines.
fn share_within(k: DVec2, spacing: f64, from: f64, to: f64) -> f64 {
    let length = k.length();
    // Across the way that the wave runs.
    let width = spacing * (k.x.abs() + k.y.abs()) / length.max(f64::MIN_POSITIVE);
    let below = |border: f64| (0.5 + (border - length) / width).clamp(0.0, 1.0);
    below(to) - below(from)
}

/// Of the rings, rising in wave number.
fn edges(reaches: &[(&LatticeWaves, f64, f64)]) -> Option<Vec<f64>> {
    let low = reaches.iter().map(|reach| reach.1).min_by(f64::total_cmp)?;
    let high = reaches.iter().map(|reach| reach.2).max_by(f64::total_cmp)?;
    let spacing_at = |k: f64| {
        let there = reaches.iter().filter(|(_, low, high)| (*low..=*high).contains(&k));
        there.map(|(tile, ..)| tile.spacing()).min_by(f64::total_cmp)
    };
    let finest = reaches.iter().map(|(tile, ..)| tile.spacing()).min_by(f64::total_cmp)?;
    let first = spacing_at(low).unwrap_or(finest);
    let mut edges = vec![(low - 0.5 * first).max(0.25 * low)];
    while let Some(&last) = edges.last()
        && last <= high
    {
        edges.push(last + spacing_at(last.max(low)).unwrap_or(finest).max(0.06 * last));
    }
    Some(edges)
}
