//! The sea as a random process: how often it is how high, and what a gauge in it records.

use crate::{TILE, WIND};
use glam::DVec2;
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use std::f64::consts::TAU;
use std::sync::Arc;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::model::spectral::{
    Amplitudes, Cascade, CascadeBudget, SpectralSea, SpectralSeaParameters, SpectralTile,
    SpectralTileParameters, Water,
};
use whitecap_waves::model::{Surface, TileFields, WaveModel};
use whitecap_waves::spectrum::WaveSpectrum;
use whitecap_waves::spectrum::directional::{Directional, DirectionalParameters};
use whitecap_waves::spectrum::jonswap::Jonswap;
use whitecap_waves::spectrum::phillips::Phillips;
use whitecap_waves::spreading::{Spread, Spreading};

/// P(|η| > nσ) of a Gaussian sea: 0.31731, 0.04550, 0.0026998, 6.334e-5.
#[test]
fn heights_are_exceeded_as_often_as_they_should() {
    let (mut fields, mut counts, mut all) = (TileFields::default(), [0.0; 4], 0.0);
    // Four standard deviations are rare: a hundred of 1.6 million heights lie beyond.
    for seed in 0..24 {
        let tile = SpectralTileParameters {
            tile_size_m: 2400.0,
            resolution: 256,
            seed,
            amplitudes: Amplitudes::Gaussian,
            ..TILE
        };
        let mut sea = SpectralTile::new(tile, &[Phillips::new(WIND).unwrap()]).unwrap();
        let sigma = sea.variance_m2().sqrt();
        sea.evaluate(50.0, &mut fields);
        for height in &fields.height {
            let deviations = f64::from(height.abs()) / sigma;
            for (count, n) in counts.iter_mut().zip([1.0, 2.0, 3.0, 4.0]) {
                *count += f64::from(u8::from(deviations > n));
            }
            all += 1.0;
        }
    }
    for (count, (expected, tolerance)) in
        counts.iter().zip([(0.31731, 0.01), (0.04550, 0.004), (0.0026998, 6e-4), (6.334e-5, 1e-5)])
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

/// Welch's estimate of a gauge's spectrum: Hann windows that overlap by half.
struct Welch {
    step_s: f64,
    segment: usize,
    plan: Arc<dyn Fft<f64>>,
}

impl Welch {
    /// S(f) in m²/Hz at the multiples of [`bin_hz`](Self::bin_hz).
    fn of(&self, series: &[f64]) -> Vec<f64> {
        let window = |i: usize| 0.5 - 0.5 * (TAU * i as f64 / self.segment as f64).cos();
        let window_power: f64 = (0..self.segment).map(|i| window(i).powi(2)).sum();
        let segments = series.windows(self.segment).step_by(self.segment / 2);
        let scale = 2.0 * self.step_s / (window_power * segments.len() as f64);
        let mut power = vec![0.0; self.segment / 2];
        for segment in segments {
            let mut line: Vec<Complex<f64>> =
                segment.iter().enumerate().map(|(i, height)| Complex::new(window(i) * height, 0.0)).collect();
            self.plan.process(&mut line);
            for (power, line) in power.iter_mut().zip(&line) {
                *power += scale * line.norm_sqr();
            }
        }
        power
    }

    fn bin_hz(&self) -> f64 {
        1.0 / (self.segment as f64 * self.step_s)
    }

    /// What it is on average for a sea of `spectrum` over deep water, at a multiple of the bin: S(f) = S(k) 2π/c_g, seen through
    /// the window, whose power falls off within two bins.
    fn expected(&self, spectrum: &impl WaveSpectrum, bin: usize) -> f64 {
        let theory = |f: f64| {
            let k = Dispersion::DEEP.wave_number(TAU * f);
            spectrum.omnidirectional_m3(k) * TAU / Dispersion::DEEP.group_speed(k)
        };
        let hann = |x: f64| {
            let sinc = |x: f64| if x.abs() < 1e-9 { 1.0 } else { (0.5 * TAU * x).sin() / (0.5 * TAU * x) };
            (sinc(x) + 0.5 * (sinc(x - 1.0) + sinc(x + 1.0))).powi(2) / 1.5
        };
        let steps = (0..400).map(|i| (f64::from(i) + 0.5) / 50.0 - 4.0);
        steps.map(|x| hann(x) * theory((bin as f64 + x).max(0.01) * self.bin_hz()) / 50.0).sum()
    }
}

/// What gauges record has the spectrum of the sea by Welch's estimate: on average of all gauges on a tile to 4 %; and of their
/// single estimates nine in ten at least lie between the bounds that χ² gives for 95 in 100.
#[test]
fn a_gauge_records_the_spectrum() {
    let welch = Welch { step_s: 0.5, segment: 128, plan: FftPlanner::new().plan_fft_forward(128) };
    let (n, samples, seeds) = (64, 1152, 3);
    let spectrum = Phillips::new(WIND).unwrap();
    let gauges: Vec<usize> = (0..16).map(|gauge| n * (16 * (gauge / 4) + 5) + 16 * (gauge % 4) + 3).collect();
    let (mut mean, mut single) = (vec![0.0; 64], Vec::new());
    for seed in 0..seeds {
        let tile =
            SpectralTileParameters { tile_size_m: 1200.0, resolution: n, choppiness: 0.0, seed, ..TILE };
        let mut sea = SpectralTile::new(tile, &[spectrum]).unwrap();
        let mut fields = TileFields::default();
        let mut series = vec![Vec::new(); n * n];
        for i in 0..samples {
            sea.evaluate(welch.step_s * f64::from(i), &mut fields);
            for (series, height) in series.iter_mut().zip(&fields.height) {
                series.push(f64::from(*height));
            }
        }
        single.extend(gauges.iter().map(|gauge| welch.of(&series[*gauge])));
        for series in series.iter().step_by(7) {
            let power = welch.of(series);
            mean.iter_mut().zip(power).for_each(|(mean, power)| *mean += power);
        }
    }
    let of_seed = (n * n).div_ceil(7) as f64;
    mean.iter_mut().for_each(|mean| *mean /= of_seed * seeds as f64);

    let expected = |bin: usize| welch.expected(&spectrum, bin);
    let (mut compared, mut inside, mut all) = (0.0, 0, 0);
    // From just below the peak to the shortest waves of the tile: 0.11 to 0.2 Hz.
    for first in (7..13).step_by(2) {
        let band = |power: &[f64]| power[first] + power[first + 1];
        let expected = expected(first) + expected(first + 1);
        let ratio = band(&mean) / expected;
        assert!((ratio - 1.0).abs() < 0.04, "bin {first}: {ratio}");
        compared += expected * welch.bin_hz();
        // 17 segments that overlap by half are worth 0.9 of their number, two bins one and a half: ν = 46, and χ² of it
        // is between 29.2 and 66.6 in 95 of 100.
        for power in &single {
            all += 1;
            inside += u32::from((29.2 / 46.0..66.6 / 46.0).contains(&(band(power) / expected)));
        }
    }
    assert!(compared > 0.6 * spectrum.variance_m2(), "{compared} of {}", spectrum.variance_m2());
    // 137 of 144 are to be expected, more or less by 2.6 if all were independent of each other; found are 135.
    assert!(f64::from(inside) > 0.9 * f64::from(all), "{inside} of {all}");
}

/// On the tiles that a scene plans: records of twenty minutes, as a buoy takes them, at many places and of many seeds, in
/// bands of 1.5/128 s, 0.012 Hz, from 0.7 to 2.2 times the peak's frequency. Of the single estimates 90 in 100 at least lie between
/// the bounds that χ² gives for 95 in 100; on average they are the spectrum to 2 %.
///
/// Longer records resolve what a tile of eight wavelengths of the peak has of waves: few, which beat at a place for ever.
#[test]
fn a_buoys_record_has_the_spectrum() {
    let welch = Welch { step_s: 0.5, segment: 256, plan: FftPlanner::new().plan_fft_forward(256) };
    let parameters = DirectionalParameters {
        spread: Spread { spreading: Spreading::Hasselmann, swell: 0.0 },
        toward: DVec2::from_angle(0.7),
        dispersion: Dispersion::DEEP,
    };
    let jonswap = Jonswap::from_height_and_period(2.5, 8.0, 3.3).unwrap();
    let spectrum = Directional::new(jonswap, parameters).unwrap();
    let budget = CascadeBudget { tile_size_m: None, shortest_wave_m: 2.0, cascades: 3, resolution: 128 };
    let bins = 12..36;
    let expected: Vec<f64> = bins.clone().map(|bin| welch.expected(&spectrum, bin)).collect();
    // 17 segments that overlap by half are worth 16.1: ν = 32.2, and χ² of it is between 18.4 and 49.7 in 95 of 100.
    let band = 18.4 / 32.2..49.7 / 32.2;
    let (mut inside, mut mean, mut all) = (0.0, 0.0, 0.0);
    for seed in 0..4 {
        let sea = SpectralSeaParameters {
            cascades: Cascade::plan(&[&spectrum], budget),
            choppiness: 0.0,
            water: Water::STILL,
            seed,
            amplitudes: Amplitudes::Deterministic,
        };
        let mut sea = SpectralSea::new(sea, &[&spectrum]).unwrap();
        assert!(sea.tiles().len() >= 2);
        // Tiles have no common multiple, so that somewhere any sample of one lies over any of another.
        let gauge = |gauge: usize, tile: usize| {
            let turns =
                [0.754_877_666, 0.569_840_291].map(|step| (step * (1 + gauge + 7 * tile) as f64).fract());
            let [x, z] = turns.map(|part| (128.0 * part) as usize);
            128 * z + x
        };
        let mut series = vec![vec![0.0; 2400]; 24];
        let mut fields = TileFields::default();
        for i in 0..2400 {
            for (index, tile) in sea.tiles_mut().iter_mut().enumerate() {
                tile.evaluate(welch.step_s * i as f64, &mut fields);
                for (number, series) in series.iter_mut().enumerate() {
                    series[i] += f64::from(fields.height[gauge(number, index)]);
                }
            }
        }
        for series in &series {
            let power = welch.of(series);
            for (bin, expected) in bins.clone().zip(&expected) {
                let ratio = power[bin] / expected;
                inside += f64::from(u8::from(band.contains(&ratio)));
                mean += ratio;
                all += 1.0;
            }
        }
    }
    println!("{} inside, mean {}", inside / all, mean / all);
    assert!(inside >= 0.9 * all, "{} inside", inside / all);
    assert!((mean / all - 1.0).abs() < 0.02, "{}", mean / all);
}
