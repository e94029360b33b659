//! Where one wave lies, and which way it goes.

use super::*;
use crate::surface::compute::waves::fixed_point;

const TILE_SIZE_M: f64 = 80.0;

/// A tile with the one wave P = `amplitude`, Q = −iP at (p, q), which travels towards it, on a current.
fn one_wave(
    n: usize,
    (p, q): (usize, i32),
    amplitude: [f32; 2],
    turns_per_s: f64,
    drift: f64,
) -> WaveConstants {
    let mut waves = WaveConstants {
        tile: GpuTile::new(n, TILE_SIZE_M),
        amplitudes: vec![[0.0; 4]; n * n / 2],
        frequencies: vec![[0; 4]; n * n / 2],
        lean: vec![0.0; n * n / 4],
        displacement_factors: vec![1.0; n / 2 + 1],
    };
    let place = |q: i32| p * n + q.rem_euclid(n as i32) as usize;
    let [re, im] = amplitude;
    let mut put = |q: i32, value: [f32; 4], drift: f64| {
        waves.amplitudes[place(q)] = value;
        let ([a, b], [c, d]) = (fixed_point(turns_per_s), fixed_point(drift));
        waves.frequencies[place(q)] = [a, b, c, d];
    };
    put(q, [re, im, im, -re], drift);
    if p == 0 {
        // The mirror image, h(−k) = conj h(k).
        put(-q, [re, -im, im, re], -drift);
    }
    waves.lean[p * n / 2 + q.unsigned_abs() as usize] = LEAN;
    waves
}

const LEAN: f32 = 3.25;

/// 2 Re h e^{ik·x} with h = P e^{−2πi(ν + δ)t}: the place, the sign and the direction of travel of each field.
#[test]
fn one_wave_is_where_it_belongs() {
    let Some(gpu) = gpu() else { return };
    let (turns_per_s, drift, amplitude) = (0.31, -0.047, [0.3, -0.4]);
    let modes = [(1, 0), (0, 1), (0, -3), (3, 2), (5, -6), (7, 7)];
    let larger = [(128, (61, -3)), (32, (2, -15)), (2048, (1023, -700))];
    for (n, mode) in modes.map(|mode| (16, mode)).into_iter().chain(larger) {
        let waves = one_wave(n, mode, amplitude, turns_per_s, drift);
        let fields = SpectralFields::new(&gpu.device, &gpu.queue, &waves);
        let k = TAU / TILE_SIZE_M * DVec2::new(mode.0 as f64, f64::from(mode.1));
        let lean = f64::from(LEAN);
        // Of 2048² samples, some.
        let step = if n > 128 { 997 } else { 1 };
        for time_s in if n > 128 { vec![2.6] } else { vec![0.0, 2.6] } {
            let seen = evaluate(gpu, &fields, time_s);
            for i in (0..n * n).step_by(step) {
                let x = TILE_SIZE_M / n as f64 * DVec2::new((i % n) as f64, (i / n) as f64);
                let (sin, cos) = (k.dot(x) - TAU * (turns_per_s + drift) * time_s).sin_cos();
                let [re, im] = amplitude.map(f64::from);
                // Twice the real part of P e^{iφ} and of i P e^{iφ}.
                let (h, ih) = (2.0 * (re * cos - im * sin), -2.0 * (re * sin + im * cos));
                let expected = [
                    h,
                    k.x * lean * ih,
                    k.y * lean * ih,
                    k.x * ih,
                    k.y * ih,
                    -k.x * k.x * lean * h,
                    -k.x * k.y * lean * h,
                    -k.y * k.y * lean * h,
                ];
                for ((name, seen), expected) in arrays(&seen).into_iter().zip(expected) {
                    let error = (f64::from(seen[i]) - expected).abs();
                    assert!(error < 1e-5 * (1.0 + k.length_squared() * lean), "{name} of {mode:?} at {i}");
                }
            }
        }
    }
}
