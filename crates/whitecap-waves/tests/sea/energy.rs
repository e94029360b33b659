//! The sea has the height that was asked for.

use crate::{TILE, WIND, one_wave, wind_sea};
use glam::DVec2;
use std::f64::consts::TAU;
use whitecap_waves::ParameterError;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::model::spectral::{Amplitudes, SpectralTile, SpectralTileParameters, Water};
use whitecap_waves::model::{Surface, TileFields, WaveModel};
use whitecap_waves::spectrum::directional::{Directional, DirectionalParameters};
use whitecap_waves::spectrum::elfouhaily::Elfouhaily;
use whitecap_waves::spectrum::jonswap::Jonswap;
use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};
use whitecap_waves::spectrum::pierson_moskowitz::PiersonMoskowitz;
use whitecap_waves::spectrum::tma::Tma;
use whitecap_waves::spectrum::{Omnidirectional, WaveSpectrum};
use whitecap_waves::spreading::{Spread, Spreading};
use whitecap_waves::statistics::{LatticeWaves, Moments, significant_height_m};

fn measured_variance(sea: &mut SpectralTile, time_s: f64) -> f64 {
    let mut fields = TileFields::default();
    sea.evaluate(time_s, &mut fields);
    Moments::of(&fields.height).variance
}

/// The integral of a spectrum over the waves that a lattice has, in polar coordinates: nothing of the synthesis.
fn lattice_integral(spectrum: &impl WaveSpectrum, tile: SpectralTileParameters) -> f64 {
    let spacing = TAU / tile.tile_size_m;
    let outermost = (tile.resolution as f64 / 2.0 - 0.5) * spacing;
    let (lowest, steps, directions) = ((0.2 * spacing).ln(), 4000, 720);
    let step = ((2.0 * outermost).ln() - lowest) / f64::from(steps);
    let mut sum = 0.0;
    for i in 0..steps {
        let k = (lowest + step * (f64::from(i) + 0.5)).exp();
        for j in 0..directions {
            let k = k * DVec2::from_angle(TAU * (f64::from(j) + 0.5) / f64::from(directions));
            let reach = k.abs().max_element();
            if (0.5 * spacing..outermost).contains(&reach) {
                sum += spectrum.density_m4(k) * k.length_squared() * step * TAU / f64::from(directions);
            }
        }
    }
    sum
}

#[test]
fn every_deterministic_sea_has_the_height_of_its_band() {
    for (resolution, height_m) in [(32, 0.4), (64, 2.0), (128, 3.5)] {
        let wind = PhillipsParameters { significant_height_m: Some(height_m), ..WIND };
        let tile = SpectralTileParameters { resolution, ..TILE };
        let m0 = lattice_integral(&Phillips::new(wind).unwrap(), tile);
        for seed in [0, 1, u64::MAX] {
            let mut sea = wind_sea(SpectralTileParameters { seed, ..tile }, wind);
            assert!((sea.variance_m2() / m0 - 1.0).abs() < 2e-3, "{}", sea.variance_m2() / m0);
            assert!((sea.captured_fraction() / m0 * (height_m / 4.0).powi(2) - 1.0).abs() < 2e-3);
            for time_s in [-50.0, 0.0, 3.7, 1e4] {
                let measured = significant_height_m(measured_variance(&mut sea, time_s));
                let expected = significant_height_m(m0);
                assert!((measured / expected - 1.0).abs() < 2e-3, "N {resolution} seed {seed}: {measured}");
            }
        }
    }
}

#[test]
fn without_a_height_the_wind_decides() {
    let tile = SpectralTileParameters { resolution: 256, ..TILE };
    let measured = significant_height_m(measured_variance(&mut wind_sea(tile, WIND), 5.0));
    assert!((measured / 2.1330 - 1.0).abs() < 0.01, "{measured}");
}

#[test]
fn a_single_wave_has_the_amplitude_of_its_energy() {
    let (_, mut sea) = one_wave(4.0, 0.0);
    let mut fields = TileFields::default();
    sea.evaluate(2.0, &mut fields);
    let highest = (0..1000)
        .map(|i| sea.sample(DVec2::new(0.025 * f64::from(i), 0.0), 2.0).displacement_m.y)
        .fold(0.0, f64::max);
    assert!((highest - 0.5).abs() < 1e-4, "{highest}");
    assert!((Moments::of(&fields.height).variance - 0.125).abs() < 1e-6);
}

#[test]
fn gaussian_seas_have_it_on_average_and_differ() {
    let seeds = 128;
    let m0 = wind_sea(SpectralTileParameters { resolution: 32, ..TILE }, WIND).variance_m2();
    let all: Vec<f64> = (0..seeds)
        .map(|seed| {
            let tile =
                SpectralTileParameters { resolution: 32, seed, amplitudes: Amplitudes::Gaussian, ..TILE };
            measured_variance(&mut wind_sea(tile, WIND), 1.5) / m0
        })
        .collect();
    let mean = all.iter().sum::<f64>() / seeds as f64;
    let spread = (all.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / seeds as f64).sqrt();
    assert!((mean - 1.0).abs() < 0.03, "{mean}");
    // The relative deviation of m0 is √Σ(ΨΔk²)²/m0, about a tenth for this sea.
    assert!((0.03..0.3).contains(&spread), "{spread}");
}

/// Over 32 seeds a Gaussian sea has the height of its spectrum within 3 %, whatever the spectrum.
#[test]
fn gaussian_seas_of_every_spectrum_have_their_height() {
    for (name, spectrum) in every_spectrum() {
        let tile = |seed| SpectralTileParameters {
            tile_size_m: 1200.0,
            seed,
            amplitudes: Amplitudes::Gaussian,
            ..TILE
        };
        let mut sum = 0.0;
        let mut expected = 0.0;
        for seed in 0..32 {
            let mut sea = SpectralTile::new(tile(seed), &[&spectrum]).unwrap();
            sum += measured_variance(&mut sea, 3.0) / 32.0;
            expected = sea.captured_fraction() * spectrum.variance_m2();
        }
        let ratio = (sum / expected).sqrt();
        assert!((ratio - 1.0).abs() < 0.03, "{name}: {ratio}");
    }
}

/// Each spectrum under a wind of 10 m/s.
fn every_spectrum() -> Vec<(&'static str, Box<dyn WaveSpectrum>)> {
    fn spread<S: Omnidirectional + 'static>(
        sea: Result<S, ParameterError>,
        dispersion: Dispersion,
    ) -> Box<dyn WaveSpectrum> {
        let parameters = DirectionalParameters {
            spread: Spread { spreading: Spreading::Cos2s { exponent: 8.0 }, swell: 0.0 },
            toward: DVec2::from_angle(0.4),
            dispersion,
        };
        let sea = sea.expect("a sea within its ranges");
        Box::new(Directional::new(sea, parameters).expect("spreads within their ranges"))
    }
    let shallow = Dispersion::at_depth(15.0).expect("a depth within its range");
    let jonswap = || Jonswap::from_wind_and_fetch(10.0, 1e5, 3.3);
    let over_shallows = || Tma::over(jonswap()?, 15.0);
    vec![
        ("Phillips", Box::new(Phillips::new(WIND).expect("a wind within its range"))),
        ("Pierson-Moskowitz", spread(PiersonMoskowitz::from_wind(10.0), Dispersion::DEEP)),
        ("JONSWAP", spread(jonswap(), Dispersion::DEEP)),
        ("TMA", spread(over_shallows(), shallow)),
        ("Elfouhaily", spread(Elfouhaily::from_wind(10.0), Dispersion::DEEP)),
    ]
}

/// Where waves run against each other they interfere, and a Gaussian sea has them: the variance swings, but not its mean
/// over time.
#[test]
fn opposing_gaussian_waves_have_it_on_average() {
    let wind = PhillipsParameters { opposing_energy: 1.0, ..WIND };
    let tile = SpectralTileParameters { resolution: 32, amplitudes: Amplitudes::Gaussian, ..TILE };
    let mut sea = wind_sea(tile, wind);
    let all: Vec<f64> = (0..200).map(|i| measured_variance(&mut sea, 7.3 * f64::from(i))).collect();
    let over_time = LatticeWaves::measure(&mut sea, &Water::STILL, 0.0, &mut TileFields::default());
    let waves: f64 = over_time.waves().map(|(_, energy_m2)| energy_m2).sum();
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    assert!((mean / waves - 1.0).abs() < 0.03, "{}", mean / waves);
    assert!(all.iter().any(|variance| (variance / waves - 1.0).abs() > 0.01));
}

/// Broad seas, crossing ones and ones against each other.
fn broad_seas() -> Vec<(&'static str, Vec<Box<dyn WaveSpectrum>>)> {
    let wind_sea = || Jonswap::from_wind_and_fetch(12.0, 2e4, 3.3).expect("a fetch within its range");
    let spread = |spreading, degrees: f64| -> Box<dyn WaveSpectrum> {
        let parameters = DirectionalParameters {
            spread: Spread { spreading, swell: 0.0 },
            toward: DVec2::from_angle(degrees.to_radians()),
            dispersion: Dispersion::DEEP,
        };
        Box::new(Directional::new(wind_sea(), parameters).expect("spreads within their ranges"))
    };
    let exponent = |exponent| Spreading::Cos2s { exponent };
    let still = PhillipsParameters { opposing_energy: 1.0, ..WIND };
    vec![
        ("Mitsuyasu", vec![spread(Spreading::Mitsuyasu, 20.0)]),
        ("Donelan-Banner", vec![spread(Spreading::DonelanBanner, 20.0)]),
        ("everywhere alike", vec![spread(exponent(0.0), 20.0)]),
        ("s = 1", vec![spread(exponent(1.0), 20.0)]),
        ("s = 4", vec![spread(exponent(4.0), 20.0)]),
        ("against each other", vec![spread(exponent(10.0), 20.0), spread(exponent(10.0), 200.0)]),
        ("crossing", vec![spread(exponent(6.0), 20.0), spread(exponent(10.0), 130.0)]),
        ("still", vec![Box::new(Phillips::new(still).expect("a spectrum within its ranges"))]),
    ]
}

/// Of a pair of opposite waves one runs, so nothing stands and nothing swings.
#[test]
fn seas_with_waves_in_all_directions_have_it_at_every_time() {
    for (name, systems) in broad_seas() {
        for seed in [0, 1, 7] {
            let tile = SpectralTileParameters { tile_size_m: 300.0, seed, ..TILE };
            let mut sea = SpectralTile::new(tile, &systems).unwrap();
            for time_s in [0.0, 7.0, 1234.5, -1e6] {
                let ratio = measured_variance(&mut sea, time_s) / sea.variance_m2();
                assert!((ratio - 1.0).abs() < 1e-4, "{name}, seed {seed}, {time_s} s: {ratio}");
            }
        }
    }
}

/// The energy towards each direction, by octants and by short and long waves, is that of the spectrum.
#[test]
fn every_direction_has_its_energy() {
    for (name, systems) in broad_seas() {
        let (mut found, mut expected) = ([[0.0; 8]; 2], [[0.0; 8]; 2]);
        for seed in 0..8 {
            let tile = SpectralTileParameters { tile_size_m: 600.0, resolution: 128, seed, ..TILE };
            let mut sea = SpectralTile::new(tile, &systems).unwrap();
            let cell = (TAU / tile.tile_size_m).powi(2);
            let waves = LatticeWaves::measure(&mut sea, &Water::STILL, 0.0, &mut TileFields::default());
            for (k, energy_m2) in waves.waves().filter(|(k, _)| *k != DVec2::ZERO) {
                let octant = (k.to_angle() / (TAU / 8.0) + 8.5) as usize % 8;
                let short = usize::from(k.length() > 0.3);
                found[short][octant] += energy_m2;
                expected[short][octant] +=
                    systems.iter().map(|system| system.density_m4(k) * cell).sum::<f64>();
            }
        }
        for (found, expected) in found.iter().zip(&expected) {
            let all: f64 = expected.iter().sum();
            for (octant, (found, expected)) in found.iter().zip(expected).enumerate() {
                let error = (found - expected) / all;
                assert!(error.abs() < 0.02, "{name}, octant {octant}: {found} for {expected} of {all}");
            }
        }
    }
}

#[test]
fn systems_add_by_variance() {
    let swell = PhillipsParameters { toward: DVec2::NEG_Y, significant_height_m: Some(1.5), ..WIND };
    let systems: Vec<Box<dyn WaveSpectrum>> =
        vec![Box::new(Phillips::new(WIND).unwrap()), Box::new(Phillips::new(swell).unwrap())];
    let mut both = SpectralTile::new(TILE, &systems).unwrap();
    let alone = |system| SpectralTile::new(TILE, &[system]).unwrap().variance_m2();
    let expected = alone(&systems[0]) + alone(&systems[1]);
    assert!((both.variance_m2() / expected - 1.0).abs() < 1e-12);
    assert!((measured_variance(&mut both, 4.0) / expected - 1.0).abs() < 1e-4);
}

#[test]
fn no_systems_and_no_height_are_a_flat_sea() {
    let calm = PhillipsParameters { significant_height_m: Some(0.0), ..WIND };
    let nothing: [Phillips; 0] = [];
    for mut sea in [wind_sea(TILE, calm), SpectralTile::new(TILE, &nothing).unwrap()] {
        assert_eq!(sea.captured_fraction(), 1.0);
        assert_eq!(measured_variance(&mut sea, 3.0), 0.0);
        assert_eq!(sea.sample(DVec2::new(3.0, 4.0), 3.0).jacobian, 1.0);
    }
}

/// A linear sea is Gaussian, and the mean of the height over the flat tile is zero.
#[test]
fn heights_are_gaussian() {
    let tile = SpectralTileParameters { tile_size_m: 1600.0, resolution: 256, ..TILE };
    let mut fields = TileFields::default();
    wind_sea(tile, WIND).evaluate(9.0, &mut fields);
    let moments = Moments::of(&fields.height);
    assert!(moments.mean.abs() < 1e-5, "{moments:?}");
    assert!(moments.skewness.abs() < 0.1 && (moments.kurtosis - 3.0).abs() < 0.2, "{moments:?}");
}

/// A swell narrower than a cell, between the points of the lattice: what its cells hold is all of it, whatever the
/// density at their centres.
#[test]
fn a_peak_between_the_lattice_points_is_not_missed() {
    struct Peak(DVec2, f64);
    impl WaveSpectrum for Peak {
        fn density_m4(&self, k: DVec2) -> f64 {
            let spread = 2.0 * self.1 * self.1;
            (-k.distance_squared(self.0) / spread).exp() / (std::f64::consts::PI * spread)
        }
        fn variance_m2(&self) -> f64 {
            1.0
        }
    }
    let spacing = TAU / TILE.tile_size_m;
    for centre in [DVec2::new(5.5, 2.5), DVec2::new(6.0, -3.0), DVec2::new(-12.5, 4.5)] {
        let peak = Peak(spacing * centre, 0.25 * spacing);
        let sea = SpectralTile::new(TILE, &[&peak]).unwrap();
        assert!((sea.variance_m2() - 1.0).abs() < 0.01, "{centre}: {}", sea.variance_m2());
    }
}
