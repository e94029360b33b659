//! The waves of one column at one moment, and the spectra of the eight fields from them.
//!
//! Symbols as in the [module above](super), and G = λ coth(kd)/|k| · h, so that the displaced fields need no
//! further look at |k|: λD has i k G, its gradients −kx² G, −kx kz G and −kz² G.
//!
//! All loops run over separate arrays of real and imaginary parts and have no branches, which is what lets
//! the compiler make vector code of them.

use super::lattice::Waves;
use crate::turns::cos_sin;
use rustfft::num_complex::Complex;
use std::f64::consts::TAU;

/// Writes column `p` at `time_s` into `run`: Re h, Im h, Re G, Im G, N numbers each; see [`Column`].
///
/// cos ωt and sin ωt are good to 4e-7 for |ω t| up to 1e9: turns are counted in f64 and reduced to one period
/// before anything is rounded to f32.
pub(crate) fn evolve_column(waves: &Waves, p: usize, time_s: f64, run: &mut [f32]) {
    evolve(waves, p, time_s, 0.0, waves.lean(p), run);
}

/// Like [`evolve_column`], but with rates of change for an observer who drifts with the current: ∂h/∂t in place of
/// h, and coth(kd)/|k| ∂h/∂t in place of G, whose "displacement" is then the horizontal velocity.
pub(crate) fn evolve_velocity_column(waves: &Waves, p: usize, time_s: f64, run: &mut [f32]) {
    // ∂h/∂t = ω (Q cos ωt − P sin ωt), which is ω times what h is a quarter turn later.
    evolve(waves, p, time_s, 0.25, waves.orbit(p), run);
    for part in run.chunks_exact_mut(waves.n) {
        multiply_by_frequency(waves.turns_per_s(p), part);
    }
}

fn evolve(waves: &Waves, p: usize, time_s: f64, turns: f64, reach: &[f32], run: &mut [f32]) {
    let n = waves.n;
    let half = n / 2;
    let (h, g) = run.split_at_mut(2 * n);
    let (h_re, h_im) = h.split_at_mut(n);
    let (g_re, g_im) = g.split_at_mut(n);

    // Cosines and sines wait in the places that h takes afterwards, the orbit's reach in that of G.
    cosines_and_sines(waves.turns_per_s(p), time_s, turns, &mut h_re[..half], &mut h_im[..half]);
    g_re[..half].copy_from_slice(reach);
    for values in [&mut h_re[..], &mut h_im[..], &mut g_re[..]] {
        let (positive, negative) = values.split_at_mut(half);
        negative[0] = 0.0;
        copy_reversed(&positive[1..], &mut negative[1..]);
    }
    combine(waves.amplitudes(p), [h_re, h_im, g_re, g_im]);
    if let Some(drift) = waves.drift_turns_per_s(p) {
        turn_back(drift, time_s, [h_re, h_im, g_re, g_im]);
    }
}

// Each of these is a function of its own, so that the compiler knows its slices apart and makes vector code.

/// cos and sin of 2π (ν t + `turns`) for every ν.
#[inline(never)]
fn cosines_and_sines(turns_per_s: &[f64], time_s: f64, turns: f64, cosines: &mut [f32], sines: &mut [f32]) {
    let (cosines, sines) = (&mut cosines[..turns_per_s.len()], &mut sines[..turns_per_s.len()]);
    for (q, turns_per_s) in turns_per_s.iter().enumerate() {
        (cosines[q], sines[q]) = cos_sin(turns_per_s * time_s + turns);
    }
}

/// e^{−2πiδt} times h and G: the pattern as an observer at rest sees it pass.
#[inline(never)]
fn turn_back(drift_turns_per_s: &[f64], time_s: f64, [h_re, h_im, g_re, g_im]: [&mut [f32]; 4]) {
    for (q, drift) in drift_turns_per_s.iter().enumerate() {
        let (cos, sin) = cos_sin(drift * time_s);
        (h_re[q], h_im[q]) = (h_re[q] * cos + h_im[q] * sin, h_im[q] * cos - h_re[q] * sin);
        (g_re[q], g_im[q]) = (g_re[q] * cos + g_im[q] * sin, g_im[q] * cos - g_re[q] * sin);
    }
}

/// ω for each q, from the ν of |q|.
#[inline(never)]
fn multiply_by_frequency(turns_per_s: &[f64], values: &mut [f32]) {
    let (positive, negative) = values.split_at_mut(turns_per_s.len());
    for (value, turns_per_s) in positive.iter_mut().zip(turns_per_s) {
        *value *= (TAU * turns_per_s) as f32;
    }
    for (value, turns_per_s) in negative[1..].iter_mut().zip(turns_per_s[1..].iter().rev()) {
        *value *= (TAU * turns_per_s) as f32;
    }
}

/// The waves of −q have the frequency and the length of those of q.
#[inline(never)]
fn copy_reversed(from: &[f32], to: &mut [f32]) {
    for (to, from) in to.iter_mut().zip(from.iter().rev()) {
        *to = *from;
    }
}

/// From cos, sin, G/h and anything to Re h, Im h, Re G, Im G, in place.
#[inline(never)]
fn combine([p_re, p_im, q_re, q_im]: [&[f32]; 4], [h_re, h_im, g_re, g_im]: [&mut [f32]; 4]) {
    let n = h_re.len();
    let (p_re, p_im, q_re, q_im) = (&p_re[..n], &p_im[..n], &q_re[..n], &q_im[..n]);
    let (h_im, g_re, g_im) = (&mut h_im[..n], &mut g_re[..n], &mut g_im[..n]);
    for q in 0..n {
        let (cos, sin, lean) = (h_re[q], h_im[q], g_re[q]);
        h_re[q] = cos * p_re[q] + sin * q_re[q];
        h_im[q] = cos * p_im[q] + sin * q_im[q];
        g_re[q] = lean * h_re[q];
        g_im[q] = lean * h_im[q];
    }
}

/// One evolved column, ready to be written out as the spectrum of any field.
pub(crate) struct Column<'a> {
    kx: f32,
    kz: &'a [f32],
    h: Parts<'a>,
    g: Parts<'a>,
}

#[derive(Clone, Copy)]
struct Parts<'a> {
    re: &'a [f32],
    im: &'a [f32],
}

impl<'a> Column<'a> {
    /// Numbers that a column takes.
    pub(crate) fn len(n: usize) -> usize {
        4 * n
    }

    /// Column `p` out of all the `evolved` ones.
    pub(crate) fn of(waves: &'a Waves, evolved: &'a [f32], p: usize) -> Self {
        let n = waves.n;
        let run = &evolved[p * Self::len(n)..][..Self::len(n)];
        let part = |i: usize| &run[i * n..][..n];
        Self {
            kx: waves.kx(p),
            kz: &waves.kz,
            h: Parts { re: part(0), im: part(1) },
            g: Parts { re: part(2), im: part(3) },
        }
    }

    pub(crate) fn height(&self, out: &mut [Complex<f32>]) {
        self.h.write(out, |_| 1.0);
    }

    pub(crate) fn slope_x(&self, out: &mut [Complex<f32>]) {
        self.h.write_times_i(out, |_| self.kx);
    }

    pub(crate) fn slope_z(&self, out: &mut [Complex<f32>]) {
        let kz = &self.kz[..out.len()];
        self.h.write_times_i(out, |q| kz[q]);
    }

    pub(crate) fn displacement_x(&self, out: &mut [Complex<f32>]) {
        self.g.write_times_i(out, |_| self.kx);
    }

    pub(crate) fn displacement_z(&self, out: &mut [Complex<f32>]) {
        let kz = &self.kz[..out.len()];
        self.g.write_times_i(out, |q| kz[q]);
    }

    /// −(∂Dx/∂x + ∂Dz/∂z), by how much the water is drawn together, times `share` of |k|² in (rad/m)²: for the grid
    /// of `out`, which may be coarser or finer than the tile's.
    pub(crate) fn convergence(&self, out: &mut [Complex<f32>], share: impl Fn(f32) -> f32) {
        let (n, kx2) = (self.kz.len(), self.kx * self.kx);
        let half = n.min(out.len()) / 2;
        let Parts { re, im } = self.g;
        let (positive, rest) = out.split_at_mut(half);
        let (empty, negative) = rest.split_at_mut(rest.len() + 1 - half);
        empty.fill(Complex::default());
        for (out, from) in [(positive, 0), (negative, n + 1 - half)] {
            let (kz, re, im) = (&self.kz[from..], &re[from..], &im[from..]);
            for (((out, kz), re), im) in out.iter_mut().zip(kz).zip(re).zip(im) {
                let k2 = kx2 + kz * kz;
                let factor = k2 * share(k2);
                *out = Complex::new(factor * re, factor * im);
            }
        }
    }

    pub(crate) fn gradient_xx(&self, out: &mut [Complex<f32>]) {
        self.g.write(out, |_| -self.kx * self.kx);
    }

    pub(crate) fn gradient_xz(&self, out: &mut [Complex<f32>]) {
        let kz = &self.kz[..out.len()];
        self.g.write(out, |q| -self.kx * kz[q]);
    }

    pub(crate) fn gradient_zz(&self, out: &mut [Complex<f32>]) {
        let kz = &self.kz[..out.len()];
        self.g.write(out, |q| -kz[q] * kz[q]);
    }
}

impl Parts<'_> {
    /// out = factor · self.
    #[inline(always)]
    fn write(self, out: &mut [Complex<f32>], factor: impl Fn(usize) -> f32) {
        let (re, im) = (&self.re[..out.len()], &self.im[..out.len()]);
        for (q, out) in out.iter_mut().enumerate() {
            *out = Complex::new(factor(q) * re[q], factor(q) * im[q]);
        }
    }

    /// out = i · factor · self.
    #[inline(always)]
    fn write_times_i(self, out: &mut [Complex<f32>], factor: impl Fn(usize) -> f32) {
        let (re, im) = (&self.re[..out.len()], &self.im[..out.len()]);
        for (q, out) in out.iter_mut().enumerate() {
            *out = Complex::new(-factor(q) * im[q], factor(q) * re[q]);
        }
    }
}
