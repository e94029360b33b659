//! The inverse Fourier transform from half a spectrum to a real field.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | N | samples along a side, a power of two |
//! | p, q | lattice numbers along x and z, −N/2 < p, q < N/2 |
//! | H(p, q) | spectrum, with H(−p, −q) the conjugate of H(p, q) |
//!
//! f(x, z) = Σ_p Σ_q H(p, q) exp(2πi (p x + q z)/N), with no factor before the sum.
//!
//! Two decisions make it fast. The spectrum is stored by columns, for each p ≥ 0 a run over q, so that the
//! first pass of transforms runs over contiguous memory that the caller has just written. In the second
//! pass two rows of real numbers share one complex transform (Press et al., *Numerical Recipes*, 2nd
//! ed., §12.3), which the turn from columns to rows prepares on its way.

use crate::error::{ParameterError, check};
use rustfft::{Fft, FftPlanner};
use std::sync::Arc;

pub use rustfft::num_complex::Complex;

mod threads;

pub(crate) use threads::{for_each_run, thread_count};

#[cfg(test)]
mod tests;

/// Rows that are turned from columns together: eight complex numbers fill a cache line.
const ROWS: usize = 8;

/// Extra numbers after each column, so that the columns of a wide tile do not all fall into the same sets of
/// the cache.
const PADDING: usize = ROWS;

/// A planned two-dimensional complex-to-real inverse transform of one size, with its working memory.
///
/// The spectrum is a slice of N/2 columns of N numbers: index `p * N + q` is H(p, q) for p in 0..N/2, with
/// negative q at N + q as usual. The terms at p = N/2, whose sign nothing determines, are taken as zero.
/// Column 0 must be Hermitian in itself, H(0, −q) the conjugate of H(0, q).
///
/// The same input gives the same bits for any number of threads. rustfft chooses its instructions when the program runs
/// (AVX with FMA, SSE 4.1, NEON, wasm SIMD, none), and each rounds in an order of its own: between them a field differs
/// by less than 5e-6 of its r.m.s.
pub struct InverseReal2d {
    n: usize,
    plan: Arc<dyn Fft<f32>>,
    /// N/2 columns, each with its padding.
    columns: Vec<Complex<f32>>,
    workers: Vec<Worker>,
}

/// The memory that one thread works in.
struct Worker {
    /// ROWS/2 complex rows of N numbers: each holds two rows of the result, as real and imaginary part.
    row_pairs: Vec<Complex<f32>>,
    fft_scratch: Vec<Complex<f32>>,
}

impl InverseReal2d {
    /// Plans the transform for `n` samples a side, a power of two from 16 to 4096.
    pub fn new(n: usize) -> Result<Self, ParameterError> {
        check("n", n as f64, "a power of two from 16 to 4096", |_| {
            n.is_power_of_two() && (16..=4096).contains(&n)
        })?;
        Ok(Self::with_plan(n, FftPlanner::new().plan_fft_inverse(n)))
    }

    /// The transform by a one-dimensional inverse `plan` for `n` numbers.
    fn with_plan(n: usize, plan: Arc<dyn Fft<f32>>) -> Self {
        let columns = vec![Complex::default(); n / 2 * (n + PADDING)];
        let mut transform = Self { n, plan, columns, workers: Vec::new() };
        transform.workers.push(transform.new_worker());
        transform
    }

    /// Numbers in a half spectrum, N²/2.
    pub fn half_spectrum_len(&self) -> usize {
        self.n / 2 * self.n
    }

    /// Transforms `half_spectrum` into `out`, whose index is `z * N + x`.
    ///
    /// Allocates nothing, but for each thread's working memory the first time it meets more threads than
    /// before.
    ///
    /// # Panics
    ///
    /// If `half_spectrum` does not hold N²/2 numbers or `out` does not hold N².
    pub fn process(&mut self, half_spectrum: &[Complex<f32>], out: &mut [f32]) {
        assert_eq!(half_spectrum.len(), self.half_spectrum_len(), "length of the half spectrum");
        let n = self.n;
        self.process_with(|p, column| column.copy_from_slice(&half_spectrum[p * n..][..n]), out);
    }

    /// Like [`process`](Self::process), with `fill(p, column)` writing column p where it is about to be
    /// transformed.
    pub(crate) fn process_with(&mut self, fill: impl Fn(usize, &mut [Complex<f32>]) + Sync, out: &mut [f32]) {
        let n = self.n;
        assert_eq!(out.len(), n * n, "length of the field");
        while self.workers.len() < thread_count(n) {
            self.workers.push(self.new_worker());
        }
        let workers = &mut self.workers[..thread_count(n)];
        let (plan, stride) = (&*self.plan, n + PADDING);
        for_each_run(&mut self.columns, stride, workers, |p, column, worker| {
            let column = &mut column[..n];
            fill(p, column);
            plan.process_with_scratch(column, &mut worker.fft_scratch);
        });
        let columns = &self.columns;
        for_each_run(out, ROWS * n, workers, |block, rows, worker| {
            pair_rows(&columns[block * ROWS..], stride, &mut worker.row_pairs);
            plan.process_with_scratch(&mut worker.row_pairs, &mut worker.fft_scratch);
            for (pair, rows) in worker.row_pairs.chunks_exact(n).zip(rows.chunks_exact_mut(2 * n)) {
                let (even, odd) = rows.split_at_mut(n);
                split_parts(pair, even, odd);
            }
        });
    }

    fn new_worker(&self) -> Worker {
        Worker {
            row_pairs: vec![Complex::default(); ROWS / 2 * self.n],
            fft_scratch: vec![Complex::default(); self.plan.get_inplace_scratch_len()],
        }
    }
}

/// Turns ROWS rows out of `columns` (which begins at the first of them) into complex rows of two each.
///
/// With A and B the spectra of two real rows, A + iB is the spectrum of the complex row a + ib. For p > 0 both
/// are known; at −p they are conj A and conj B. At p = 0 they are real, and what rounding left in their
/// imaginary parts is dropped.
fn pair_rows(columns: &[Complex<f32>], stride: usize, row_pairs: &mut [Complex<f32>]) {
    let n = stride - PADDING;
    for (pair, row) in row_pairs.chunks_exact_mut(n).enumerate() {
        let (positive, negative) = row.split_at_mut(n / 2);
        positive[0] = Complex::new(columns[2 * pair].re, columns[2 * pair + 1].re);
        negative[0] = Complex::default();
        let both = positive[1..].iter_mut().zip(negative[1..].iter_mut().rev());
        for ((positive, negative), column) in both.zip(columns[stride..].chunks(stride)) {
            let (a, b) = (column[2 * pair], column[2 * pair + 1]);
            *positive = Complex::new(a.re - b.im, a.im + b.re);
            *negative = Complex::new(a.re + b.im, b.re - a.im);
        }
    }
}

/// Real and imaginary parts, each to its own row. A function of its own, so that the compiler knows the rows
/// apart and makes vector code.
#[inline(never)]
fn split_parts(numbers: &[Complex<f32>], re: &mut [f32], im: &mut [f32]) {
    let (re, im) = (&mut re[..numbers.len()], &mut im[..numbers.len()]);
    for (i, number) in numbers.iter().enumerate() {
        re[i] = number.re;
        im[i] = number.im;
    }
}
