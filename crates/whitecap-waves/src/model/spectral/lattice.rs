//! The waves of a sea as the evolution reads them.
//!
//! Symbols as in the [module above](super), and further:
//!
//! | symbol | meaning |
//! | --- | --- |
//! | P, Q | h(k, t) = P cos ωt + Q sin ωt |
//! | ν | ω/2π, turns per second |
//!
//! With h0 = h0(k) and h̄ = conj(h0(−k)), P = h0 + h̄ and Q = −i h0 + i h̄. Both are constants, so evolving a wave
//! costs two real-by-complex products. Only p ≥ 0 is stored; the other half follows from the surface being
//! real. ω depends on |q| alone within a column, so one sine and cosine serve two waves.

use super::fit::cell;
use super::random::for_each_draw;
use super::{Amplitudes, SpectralTileParameters};
use crate::dispersion::Dispersion;
use rustfft::num_complex::Complex;
use std::f64::consts::TAU;

/// The waves with p ≥ 0, column by column.
pub(super) struct Waves {
    /// N.
    pub(super) n: usize,
    /// L in metres.
    pub(super) tile_size_m: f64,
    /// λ.
    pub(super) choppiness: f64,
    /// For each p in 0..N/2 four runs of N numbers over q (negative q at N + q): Re P, Im P, Re Q, Im Q, in
    /// metres.
    amplitudes: Vec<f32>,
    /// For each p in 0..N/2 a run over |q| in 0..N/2: ν in 1/s. In f64, since it is multiplied by the time.
    turns_per_s: Vec<f64>,
    /// Like `turns_per_s`: λ/|k| in m/rad, 0 at k = 0.
    lean: Vec<f32>,
    /// 2π q/L in rad/m for q as stored, 0 at q = N/2.
    pub(super) kz: Vec<f32>,
}

impl Waves {
    /// Draws the waves: `cell_variance_m2` is ΨΔk² at [`cell`] (p, q).
    pub(super) fn new(parameters: &SpectralTileParameters, cell_variance_m2: &[f64]) -> Self {
        let &SpectralTileParameters { tile_size_m, resolution: n, choppiness, .. } = parameters;
        let half = n / 2;
        let h0 = initial_amplitudes(parameters, cell_variance_m2);

        let mut amplitudes = vec![0.0; half * 4 * n];
        let mut turns_per_s = vec![0.0; half * half];
        let mut lean = vec![0.0; half * half];
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
            }
            for q in 0..half {
                let k = spacing * libm::hypot(p as f64, q as f64);
                turns_per_s[p * half + q] = Dispersion::DEEP.angular_frequency(k) / TAU;
                lean[p * half + q] = if k > 0.0 { (choppiness / k) as f32 } else { 0.0 };
            }
        }
        let kz = (0..n)
            .map(|q| if q == half { 0.0 } else { (spacing * f64::from(signed(n, q))) as f32 })
            .collect();
        Self { n, tile_size_m, choppiness, amplitudes, turns_per_s, lean, kz }
    }

    /// 2π p/L in rad/m.
    pub(super) fn kx(&self, p: usize) -> f32 {
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

    /// λ/|k| of column `p`, over |q|.
    pub(super) fn lean(&self, p: usize) -> &[f32] {
        &self.lean[p * self.n / 2..][..self.n / 2]
    }
}

/// q from its place in a run: 0, 1 … N/2 − 1, −N/2 … −1.
pub(super) fn signed(n: usize, q: usize) -> i32 {
    if q < n / 2 { q as i32 } else { q as i32 - n as i32 }
}

/// h0 at [`cell`] (p, q): |h0|² = ΨΔk²/2, or that on average (Tessendorf 2001, "Building a
/// Random Ocean Wave Height Field", but for the factor).
fn initial_amplitudes(parameters: &SpectralTileParameters, cell_variance_m2: &[f64]) -> Vec<Complex<f64>> {
    let n = parameters.resolution;
    let mut h0 = vec![Complex::default(); n * n];
    for_each_draw(parameters.seed, n as i32 / 2 - 1, |p, q, draw| {
        let modulus = match parameters.amplitudes {
            Amplitudes::Deterministic => 1.0,
            Amplitudes::Gaussian => draw.modulus,
        };
        let i = cell(n, p, q);
        h0[i] = draw.direction * (modulus * (0.5 * cell_variance_m2[i]).sqrt());
    });
    h0
}
