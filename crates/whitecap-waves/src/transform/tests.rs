use super::*;
use crate::random::uniform;
use proptest::prelude::*;
use rand_chacha::ChaCha8Rng;
use rand_core::SeedableRng;
use std::f64::consts::TAU;

/// A half spectrum with one term (p, q) of the given value; p = 0 gets its mirror image too.
fn one_term(n: usize, p: usize, q: usize, value: Complex<f32>) -> Vec<Complex<f32>> {
    let mut half = vec![Complex::default(); n * n / 2];
    half[p * n + q] = value;
    if p == 0 && q != 0 {
        half[n - q] = value.conj();
    }
    half
}

/// A term and its mirror image make 2 Re(H exp(2πi (p x + q z)/N)), x along the rows.
#[test]
fn one_term_is_one_wave() {
    let n = 16;
    let mut transform = InverseReal2d::new(n).unwrap();
    let mut out = vec![0.0; n * n];
    for (p, q) in [(1, 0), (0, 1), (3, 2), (3, 14), (7, 9), (0, 7)] {
        let value = Complex::new(0.75, -0.5);
        transform.process(&one_term(n, p, q, value), &mut out);
        for z in 0..n {
            for x in 0..n {
                let (sin, cos) = (TAU * (p * x + q * z) as f64 / n as f64).sin_cos();
                let expected = 2.0 * (0.75 * cos + 0.5 * sin);
                assert!((f64::from(out[z * n + x]) - expected).abs() < 1e-5, "({p}, {q}) at ({x}, {z})");
            }
        }
    }
}

#[test]
fn the_constant_term_is_the_mean() {
    let n = 32;
    let mut out = vec![0.0; n * n];
    let half = one_term(n, 0, 0, Complex::new(2.5, 0.0));
    InverseReal2d::new(n).unwrap().process(&half, &mut out);
    assert!(out.iter().all(|v| (v - 2.5).abs() < 1e-6));
}

#[test]
fn sizes_are_checked() {
    for n in [0, 8, 100, 8192] {
        assert!(InverseReal2d::new(n).is_err(), "{n}");
    }
    assert_eq!(InverseReal2d::new(64).unwrap().half_spectrum_len(), 2048);
}

/// A spectrum with something in every place, the same for the same `salt`.
fn busy_spectrum(n: usize, salt: usize) -> Vec<Complex<f32>> {
    let noise = |i: usize| (((i + salt).wrapping_mul(2_654_435_761) >> 7) % 2001) as f32 / 1000.0 - 1.0;
    let mut half: Vec<_> = (0..n * n / 2).map(|i| Complex::new(noise(2 * i), noise(2 * i + 1))).collect();
    half[0].im = 0.0;
    half[n / 2].im = 0.0;
    for q in 1..n / 2 {
        half[n - q] = half[q].conj();
    }
    half
}

#[test]
fn used_memory_leaves_no_trace() {
    let n = 32;
    let (mut fresh, mut used) = (InverseReal2d::new(n).unwrap(), InverseReal2d::new(n).unwrap());
    let (mut first, mut second) = (vec![0.0; n * n], vec![0.0; n * n]);
    used.process(&one_term(n, 5, 6, Complex::new(1e6, 1e6)), &mut second);
    used.process(&busy_spectrum(n, 0), &mut second);
    fresh.process(&busy_spectrum(n, 0), &mut first);
    assert_eq!(first, second);
}

#[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
#[test]
fn every_number_of_threads_gives_the_same_bits() {
    let n = 256;
    let half = busy_spectrum(n, 0);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let mut out = vec![0.0; n * n];
        pool.install(|| InverseReal2d::new(n).unwrap().process(&half, &mut out));
        out
    };
    let alone = run(1);
    for threads in [2, 3, 7] {
        assert!(
            run(threads).iter().zip(&alone).all(|(a, b)| a.to_bits() == b.to_bits()),
            "{threads} threads"
        );
    }
}

/// Every set of instructions that this machine has gives the same field to within rounding, and the same bits whenever
/// it is used again.
#[test]
fn instruction_sets_differ_by_rounding_alone() {
    for n in [16, 64, 256, 1024, 4096] {
        // Noise, as the phases of a sea: what comes in a pattern piles up in a few places, and so does its rounding.
        let mut rng = ChaCha8Rng::seed_from_u64(n as u64);
        let mut part = || uniform(&mut rng) as f32 - 0.5;
        let mut half: Vec<_> = (0..n * n / 2).map(|_| Complex::new(part(), part())).collect();
        half[..n].fill(Complex::default());
        let field = |plan: Arc<dyn Fft<f32>>| {
            let mut out = vec![0.0; n * n];
            InverseReal2d::with_plan(n, plan).process(&half, &mut out);
            out
        };
        let scalar = field(rustfft::FftPlannerScalar::new().plan_fft_inverse(n));
        let rms = (scalar.iter().map(|v| f64::from(*v).powi(2)).sum::<f64>() / scalar.len() as f64).sqrt();
        let chosen = || FftPlanner::new().plan_fft_inverse(n);
        let others = [
            ("chosen", Some(chosen())),
            ("AVX", rustfft::FftPlannerAvx::new().ok().map(|mut planner| planner.plan_fft_inverse(n))),
            ("SSE", rustfft::FftPlannerSse::new().ok().map(|mut planner| planner.plan_fft_inverse(n))),
            ("NEON", rustfft::FftPlannerNeon::new().ok().map(|mut planner| planner.plan_fft_inverse(n))),
        ];
        for (name, plan) in others.into_iter().filter_map(|(name, plan)| Some((name, plan?))) {
            let seen = field(Arc::clone(&plan));
            let worst = seen.iter().zip(&scalar).map(|(a, b)| f64::from((a - b).abs())).fold(0.0, f64::max);
            assert!(worst < 5e-6 * rms, "{name}, {n}²: {} of the r.m.s.", worst / rms);
            assert!(field(plan) == seen, "{name}, {n}²");
        }
        assert!(field(chosen()) == field(chosen()), "{n}²");
    }
}

proptest! {
    /// Parseval: Σ f² / N² = Σ|H|² over the whole plane, where p > 0 counts twice.
    #[test]
    fn energy_is_kept(salt in 0_usize..100_000) {
        let n = 16;
        let half = busy_spectrum(n, salt);
        let mut out = vec![0.0; n * n];
        InverseReal2d::new(n).unwrap().process(&half, &mut out);
        let field: f64 = out.iter().map(|v| f64::from(v * v)).sum::<f64>() / (n * n) as f64;
        let spectrum: f64 = half
            .iter()
            .enumerate()
            .map(|(i, h)| if i < n { 1.0 } else { 2.0 } * f64::from(h.norm_sqr()))
            .sum();
        prop_assert!((field / spectrum - 1.0).abs() < 1e-5);
    }
}
