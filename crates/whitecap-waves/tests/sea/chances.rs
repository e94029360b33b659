//! The sea as a random process: how often it is how high, and what a gauge in it records.

use crate::{TILE, WIND};
use glam::DVec2;
use rustfft::FftPlanner;
use rustfft::num_complex::Complex;
use std::f64::consts::TAU;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::model::spectral::{Amplitudes, SpectralTile, SpectralTileParameters};
use whitecap_waves::model::{Surface, TileFields, WaveModel};
use whitecap_waves::spectrum::WaveSpectrum;
use whitecap_waves::spectrum::phillips::Phillips;

/// P(|η| > nσ) of a Gaussian sea: 0.31731, 0.04550, 0.0026998.
#[test]
fn heights_are_exceeded_as_often_as_they_should() {
    let (mut fields, mut counts, mut all) = (TileFields::default(), [0.0; 3], 0.0);
    for seed in 0..12 {
        let tile = SpectralTileParameters {
            tile_size_m: 1200.0,
            resolution: 128,
            seed,
            amplitudes: Amplitudes::Gaussian,
            ..TILE
        };
        let mut sea = SpectralTile::new(tile, &[Phillips::new(WIND).unwrap()]).unwrap();
        let sigma = sea.variance_m2().sqrt();
        sea.evaluate(50.0, &mut fields);
        for height in &fields.height {
            let deviations = f64::from(height.abs()) / sigma;
            for (count, n) in counts.iter_mut().zip([1.0, 2.0, 3.0]) {
                *count += f64::from(u8::from(deviations > n));
            }
            all += 1.0;
        }
    }
    for (count, (expected, tolerance)) in
        counts.iter().zip([(0.31731, 0.01), (0.04550, 0.004), (0.0026998, 6e-4)])
    {
        assert!((count / all - expected).abs() < tolerance, "{} instead of {expected}", count / all);
    }
}

/// A narrow swell that runs east, Gaussian in the plane of wave numbers.
struct Swell {
    peak: DVec2,
    width: f64,
}

impl WaveSpectrum for Swell {
    fn density_m4(&self, k: DVec2) -> f64 {
        let spread = 2.0 * self.width * self.width;
        (-k.distance_squared(self.peak) / spread).exp() / (std::f64::consts::PI * spread)
    }
    fn variance_m2(&self) -> f64 {
        1.0
    }
}

/// Wave by wave along the direction of travel, from one up-crossing to the next. For a narrow band (Longuet-Higgins
/// 1952) crests exceed x Hs with probability e^(−8x²) and heights with e^(−2x²); H⅓ = 4.004σ, mean 2.507σ.
#[test]
fn crests_and_heights_of_a_narrow_swell() {
    let tile_size_m = 6000.0;
    let swell = Swell { peak: DVec2::X * (TAU / 100.0), width: 0.05 * TAU / 100.0 };
    let (mut crests, mut heights) = (Vec::new(), Vec::new());
    let mut fields = TileFields::default();
    for seed in 0..6 {
        let tile = SpectralTileParameters {
            tile_size_m,
            resolution: 1024,
            choppiness: 0.0,
            seed,
            amplitudes: Amplitudes::Gaussian,
            ..TILE
        };
        SpectralTile::new(tile, &[&swell]).unwrap().evaluate(0.0, &mut fields);
        // Rows close to each other are alike.
        for row in fields.height.chunks_exact(1024).step_by(64) {
            let crossings: Vec<usize> = (1..1024).filter(|&i| row[i - 1] <= 0.0 && row[i] > 0.0).collect();
            for pair in crossings.windows(2) {
                let wave = &row[pair[0]..pair[1]];
                let crest = f64::from(wave.iter().copied().fold(0.0, f32::max));
                let trough = f64::from(wave.iter().copied().fold(0.0, f32::min));
                crests.push(crest);
                heights.push(crest - trough);
            }
        }
    }
    assert!(crests.len() > 3000, "{}", crests.len());
    let exceeded = |values: &[f64], level: f64| {
        values.iter().filter(|value| **value > level).count() as f64 / values.len() as f64
    };
    // σ = 1, Hs = 4.
    for x in [0.25_f64, 0.5, 0.6] {
        let crest = exceeded(&crests, 4.0 * x);
        assert!((crest - (-8.0 * x * x).exp()).abs() < 0.03, "crest {x}: {crest}");
        let height = exceeded(&heights, 8.0 * x);
        assert!((height - (-8.0 * x * x).exp()).abs() < 0.03, "height {x}: {height}");
    }
    heights.sort_by(f64::total_cmp);
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let highest_third = mean(&heights[heights.len() * 2 / 3..]);
    assert!((highest_third / 4.004 - 1.0).abs() < 0.04, "{highest_third}");
    assert!((mean(&heights) / 2.507 - 1.0).abs() < 0.05, "{}", mean(&heights));
}

/// What gauges record has the spectrum of the sea: Welch's estimate over twelve of them, in bands, each within the
/// band of confidence that χ² allows (99.9 %, with the number of independent estimates that went in).
#[test]
fn a_gauge_records_the_spectrum() {
    const SEGMENT: usize = 128;
    let (step_s, samples, gauges) = (0.5, 1152, 12);
    let spectrum = Phillips::new(WIND).unwrap();
    let tile =
        SpectralTileParameters { resolution: 64, choppiness: 0.0, amplitudes: Amplitudes::Gaussian, ..TILE };
    let mut power = vec![0.0; SEGMENT / 2];
    let plan = FftPlanner::new().plan_fft_forward(SEGMENT);
    let window = |i: usize| 0.5 - 0.5 * (TAU * i as f64 / SEGMENT as f64).cos();
    let window_power: f64 = (0..SEGMENT).map(|i| window(i).powi(2)).sum();
    let mut estimates = 0.0;
    for gauge in 0..gauges {
        let sea = SpectralTile::new(SpectralTileParameters { seed: gauge, ..tile }, &[spectrum]).unwrap();
        let at = DVec2::new(33.0 * gauge as f64, 17.0);
        let series: Vec<f64> = (0..samples).map(|i| sea.sample(at, step_s * i as f64).height_m()).collect();
        for segment in series.windows(SEGMENT).step_by(SEGMENT / 2) {
            let mut line: Vec<Complex<f64>> =
                segment.iter().enumerate().map(|(i, height)| Complex::new(window(i) * height, 0.0)).collect();
            plan.process(&mut line);
            for (power, line) in power.iter_mut().zip(&line) {
                *power += 2.0 * step_s * line.norm_sqr() / window_power;
            }
            estimates += 1.0;
        }
    }
    let bin_hz = 1.0 / (SEGMENT as f64 * step_s);
    // S(f) = S(k) 2π/c_g, averaged over the bin.
    let theory = |bin: usize| {
        let at = |f: f64| {
            let k = Dispersion::DEEP.wave_number(TAU * f);
            spectrum.omnidirectional_m3(k) * TAU / Dispersion::DEEP.group_speed(k)
        };
        (0..8).map(|i| at((bin as f64 - 0.5 + (f64::from(i) + 0.5) / 8.0) * bin_hz)).sum::<f64>() / 8.0
    };
    let mut compared = 0.0;
    // From just below the peak to the shortest waves of the tile: 0.125 to 0.34 Hz.
    for first in (8..22).step_by(2) {
        let measured: f64 = power[first..first + 2].iter().sum::<f64>() / estimates;
        let expected: f64 = (first..first + 2).map(theory).sum();
        // Half-overlapped Hann segments are worth about 0.9 of their number; two bins about one and a half.
        let deviation = 1.0 / (0.9 * estimates * 1.5_f64).sqrt();
        // The sea of one seed has a random energy of its own in each band; twelve of them, about six waves each.
        let sea = 1.0 / (f64::from(gauges as u32) * 6.0).sqrt();
        let bound = 3.3 * deviation.hypot(sea);
        assert!((measured / expected - 1.0).abs() < bound, "bin {first}: {} ± {bound}", measured / expected);
        compared += expected * bin_hz;
    }
    assert!(compared > 0.6 * spectrum.variance_m2(), "{compared}");
    let total: f64 = power.iter().sum::<f64>() / estimates * bin_hz;
    assert!((total / spectrum.variance_m2() - 1.0).abs() < 0.1, "{total}");
}
