//! The waves of a tile as the evolution reads them.
//!
//! Symbols as in the [module above](super), and further:
//!
//! | symbol | meaning |
//! | --- | --- |
//! | P, Q | h(k, t) = P cos ωt + Q sin ωt, in water at rest |
//! | ν | ω/2π, turns per second |
//! | δ | k·U/2π, turns per second by which a current U carries the wave past |
//!
//! With h0 = h0(k) and h̄ = conj(h0(−k)), P = h0 + h̄ and Q = −i h0 + i h̄. Both are constants, so evolving a wave
//! costs two real-by-complex products. Only p ≥ 0 is stored; the other half follows from the surface being
//! real. ω depends on |q| alone within a column, so one sine and cosine serve two waves. A current turns both
//! waves of a pair the same way in the plane, which is one more factor, e^{−2πiδt}.

use super::energy::cell;
use super::random::{Draw, Point, for_each_ring};
use super::{Amplitudes, SpectralTileParameters};
use glam::DVec2;
use rustfft::num_complex::Complex;
use std::f64::consts::TAU;

/// The waves with p ≥ 0, column by column.
pub(crate) struct Waves {
    /// N.
    pub(crate) n: usize,
    /// L in metres.
    pub(crate) tile_size_m: f64,
    /// For each p in 0..N/2 four runs of N numbers over q (negative q at N + q): Re P, Im P, Re Q, Im Q, in
    /// metres.
    amplitudes: Vec<f32>,
    /// For each p in 0..N/2 a run over |q| in 0..N/2: ν in 1/s. In f64, since it is multiplied by the time.
    turns_per_s: Vec<f64>,
    /// For each p in 0..N/2 a run over q, δ in 1/s; empty without a current.
    drift_turns_per_s: Vec<f64>,
    /// Like `turns_per_s`: coth(kd)/|k| in m/rad, 0 at k = 0. How far an orbit reaches along, for its height
    /// and for each rad/m.
    orbit: Vec<f32>,
    /// λ times `orbit`.
    lean: Vec<f32>,
    /// 2π q/L in rad/m for q as stored, 0 at q = N/2.
    pub(crate) kz: Vec<f32>,
    /// The largest |p| or |q| of a wave with any energy.
    pub(crate) reach: usize,
}

impl Waves {
    /// Draws the waves: `cell_variance_m2` is the energy at [`cell`] (p, q).
    pub(super) fn new(parameters: &SpectralTileParameters, stream: u64, cell_variance_m2: &[f64]) -> Self {
        let &SpectralTileParameters { tile_size_m, resolution: n, choppiness, water, .. } = parameters;
        let half = n / 2;
        let h0 = initial_amplitudes(parameters, stream, cell_variance_m2);

        let mut amplitudes = vec![0.0; half * 4 * n];
        let mut turns_per_s = vec![0.0; half * half];
        let mut orbit = vec![0.0; half * half];
        let mut reach: usize = 0;
        let spacing = TAU / tile_size_m;
        for p in 0..half {
            let run = &mut amplitudes[p * 4 * n..][..4 * n];
            for q in 0..n {
                let (signed_p, signed_q) = (p as i32, signed(n, q));
                if signed_q == -(half as i32) {
                    continue;
                }
                let with = h0[cell(n, signed_p, signed_q)];
                let against = h0[cell(n, -signed_p, -signed_q)].conj();
                let cosine = with + against;
                let sine = (against - with) * Complex::<f64>::i();
                for (part, value) in [cosine.re, cosine.im, sine.re, sine.im].into_iter().enumerate() {
                    run[part * n + q] = value as f32;
                }
                if with.norm_sqr() + against.norm_sqr() > 0.0 {
                    reach = reach.max(p).max(signed_q.unsigned_abs() as usize);
                }
            }
            for q in 0..half {
                let k = spacing * libm::hypot(p as f64, q as f64);
                if k > 0.0 {
                    turns_per_s[p * half + q] = water.turns_per_s(k);
                    orbit[p * half + q] = (water.dispersion.orbit_ratio(k) / k) as f32;
                }
            }
        }
        let kz = (0..n)
            .map(|q| if q == half { 0.0 } else { (spacing * f64::from(signed(n, q))) as f32 })
            .collect();
        let lean = orbit.iter().map(|orbit| (choppiness * f64::from(*orbit)) as f32).collect();
        let drift_turns_per_s = drift(parameters);
        Self { n, tile_size_m, amplitudes, turns_per_s, drift_turns_per_s, orbit, lean, kz, reach }
    }

    /// The same waves on the smallest lattice that holds them.
    pub(super) fn trimmed(&self) -> Self {
        let n = (2 * (self.reach + 1)).next_power_of_two().clamp(16, self.n);
        let half = n / 2;
        let signed = |run: &[f32]| {
            let mut run = [&run[..half], &run[self.n - half..]].concat();
            // The place of −N/2, which is empty.
            run[half] = 0.0;
            run
        };
        let columns = 0..half;
        let drift =
            |p: usize| self.drift_turns_per_s(p).map(|run| [&run[..half], &run[self.n - half..]].concat());
        Self {
            n,
            tile_size_m: self.tile_size_m,
            amplitudes: columns.clone().flat_map(|p| self.amplitudes(p).map(signed)).flatten().collect(),
            turns_per_s: columns.clone().flat_map(|p| &self.turns_per_s(p)[..half]).copied().collect(),
            drift_turns_per_s: columns.clone().filter_map(drift).flatten().collect(),
            orbit: columns.clone().flat_map(|p| &self.orbit(p)[..half]).copied().collect(),
            lean: columns.flat_map(|p| &self.lean(p)[..half]).copied().collect(),
            kz: signed(&self.kz),
            reach: self.reach,
        }
    }

    /// 2π p/L in rad/m.
    pub(crate) fn kx(&self, p: usize) -> f32 {
        (TAU * p as f64 / self.tile_size_m) as f32
    }

    /// Re P, Im P, Re Q, Im Q of column `p`, over q.
    pub(super) fn amplitudes(&self, p: usize) -> [&[f32]; 4] {
        let run = &self.amplitudes[p * 4 * self.n..][..4 * self.n];
        std::array::from_fn(|part| &run[part * self.n..][..self.n])
    }

    /// ν of column `p`, over |q|.
    pub(super) fn turns_per_s(&self, p: usize) -> &[f64] {
        &self.turns_per_s[p * self.n / 2..][..self.n / 2]
    }

    /// δ of column `p`, over q; `None` without a current.
    pub(super) fn drift_turns_per_s(&self, p: usize) -> Option<&[f64]> {
        self.drift_turns_per_s.get(p * self.n..(p + 1) * self.n)
    }

    /// coth(kd)/|k| of column `p`, over |q|.
    pub(super) fn orbit(&self, p: usize) -> &[f32] {
        &self.orbit[p * self.n / 2..][..self.n / 2]
    }

    /// λ coth(kd)/|k| of column `p`, over |q|.
    pub(super) fn lean(&self, p: usize) -> &[f32] {
        &self.lean[p * self.n / 2..][..self.n / 2]
    }
}

/// δ over (p, q), column by column; nothing in water at rest.
fn drift(parameters: &SpectralTileParameters) -> Vec<f64> {
    let &SpectralTileParameters { tile_size_m, resolution: n, water, .. } = parameters;
    if water.current_mps == DVec2::ZERO {
        return Vec::new();
    }
    let spacing = TAU / tile_size_m;
    let turns =
        |p: usize, q: usize| water.drift_turns_per_s(spacing * DVec2::new(p as f64, f64::from(signed(n, q))));
    (0..n / 2).flat_map(|p| (0..n).map(move |q| turns(p, q))).collect()
}

/// q from its place in a run: 0, 1 … N/2 − 1, −N/2 … −1.
pub(super) fn signed(n: usize, q: usize) -> i32 {
    if q < n / 2 { q as i32 } else { q as i32 - n as i32 }
}

/// h0 at [`cell`] (p, q).
fn initial_amplitudes(
    parameters: &SpectralTileParameters,
    stream: u64,
    cell_variance_m2: &[f64],
) -> Vec<Complex<f64>> {
    let n = parameters.resolution;
    let mut h0 = vec![Complex::default(); n * n];
    let mut one_way = OneWay::default();
    for_each_ring(parameters.seed, stream, n as i32 / 2 - 1, |ring| {
        let energy = |point: &Point| cell_variance_m2[cell(n, point.p, point.q)];
        let mut set = |point: &Point, modulus: f64, energy_m2: f64| {
            h0[cell(n, point.p, point.q)] = point.draw.direction * (modulus * (0.5 * energy_m2).sqrt());
        };
        match parameters.amplitudes {
            // |h0|² is half the cell's energy on average (Tessendorf 2001, "Building a Random Ocean Wave Height
            // Field", but for the factor).
            Amplitudes::Gaussian => {
                ring.iter().for_each(|point| set(point, point.draw.modulus(), energy(point)));
            }
            Amplitudes::Deterministic => {
                let (near, far) = ring.split_at(ring.len() / 2);
                let half = near.len();
                // There and back, so that what is owed moves on in neither sense of rotation.
                let backwards = ring[0].p % 2 == 0;
                for i in (0..half).map(|i| if backwards { half - 1 - i } else { i }) {
                    let (near, far) = (&near[i], &far[i]);
                    let both_m2 = energy(near) + energy(far);
                    let chosen = if one_way.is_far(energy(far), both_m2, near.draw) { far } else { near };
                    set(chosen, 1.0, both_m2);
                }
            }
        }
    });
    h0
}

/// Chooses for each pair of opposite waves the one that runs, with the energy of both.
///
/// Two waves that run against each other stand, and the energy of what stands swings in time: with both, the variance
/// of a tile would be right on average only. What one pair owes to a direction the next ones pay, as error diffusion
/// does with grey levels (Floyd and Steinberg 1976), so every direction has its energy among neighbours.
#[derive(Default)]
struct OneWay {
    /// What the far waves of the pairs before should have had and did not get, m².
    owed_to_far_m2: f64,
}

impl OneWay {
    /// Whether the far wave of a pair takes the energy of both, of which `far_m2` is its own.
    fn is_far(&mut self, far_m2: f64, both_m2: f64, draw: Draw) -> bool {
        // Weak pairs cannot pay the debts of strong ones without losing their own directions.
        let due_m2 = far_m2 + self.owed_to_far_m2.clamp(-0.5 * both_m2, 0.5 * both_m2);
        // About half, so that equals do not alternate.
        let is_far = due_m2 > (0.25 + 0.5 * draw.uniform) * both_m2;
        if both_m2 > 0.0 {
            self.owed_to_far_m2 = due_m2 - if is_far { both_m2 } else { 0.0 };
        }
        is_far
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Band, Water};
    use super::*;

    /// Which waves of opposite pairs run turns a sea neither left nor right: its mean direction is off by chance, and on average
    /// over seeds and all directions not at all.
    #[test]
    fn what_is_owed_moves_on_in_neither_sense_of_rotation() {
        const N: usize = 64;
        let waves =
            || (-31..32).flat_map(|p| (-31..32).map(move |q| (p, q))).filter(|(p, q)| p * p + q * q >= 64);
        let mut turned_deg = 0.0;
        for step in 0..24 {
            let wind = DVec2::from_angle(TAU * (f64::from(step) + 0.2) / 24.0);
            let mut energy_m2 = vec![0.0; N * N];
            for (p, q) in waves() {
                let k = DVec2::new(f64::from(p), f64::from(q));
                let along = k.normalize().dot(wind);
                // One tenth runs against the wind.
                let share = if along > 0.0 { 1.0 } else { 0.1 };
                energy_m2[cell(N, p, q)] = share * along * along / k.length_squared().powi(2);
            }
            for seed in 0..40 {
                let parameters = SpectralTileParameters {
                    tile_size_m: 100.0,
                    resolution: N,
                    band: Band::WHOLE,
                    choppiness: 0.0,
                    water: Water::STILL,
                    seed,
                    amplitudes: Amplitudes::Deterministic,
                };
                let h0 = initial_amplitudes(&parameters, 0, &energy_m2);
                let toward: DVec2 = waves()
                    .map(|(p, q)| {
                        h0[cell(N, p, q)].norm_sqr() * DVec2::new(f64::from(p), f64::from(q)).normalize()
                    })
                    .sum();
                turned_deg += wind.angle_to(toward).to_degrees() / (24.0 * 40.0);
            }
        }
        assert!(turned_deg.abs() < 0.1, "{turned_deg}°");
    }
}
