//! The sea has the height that was asked for.

use crate::{TILE, WIND, one_wave, wind_sea};
use glam::DVec2;
use whitecap_waves::model::spectral::{Amplitudes, SpectralTile, SpectralTileParameters};
use whitecap_waves::model::{Surface, TileFields, WaveModel};
use whitecap_waves::spectrum::WaveSpectrum;
use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};
use whitecap_waves::statistics::{Moments, significant_height_m};

fn measured_variance(sea: &mut SpectralTile, time_s: f64) -> f64 {
    let mut fields = TileFields::default();
    sea.evaluate(time_s, &mut fields);
    Moments::of(&fields.height).variance
}

#[test]
fn every_deterministic_sea_has_its_significant_height() {
    for (resolution, height_m) in [(32, 0.4), (64, 2.0), (128, 3.5)] {
        for seed in [0, 1, u64::MAX] {
            let wind = PhillipsParameters { significant_height_m: Some(height_m), ..WIND };
            let mut sea = wind_sea(SpectralTileParameters { resolution, seed, ..TILE }, wind);
            assert!((sea.variance_m2() - (height_m / 4.0).powi(2)).abs() < 1e-12);
            for time_s in [-50.0, 0.0, 3.7, 1e4] {
                let measured = significant_height_m(measured_variance(&mut sea, time_s));
                assert!((measured / height_m - 1.0).abs() < 1e-3, "N {resolution} seed {seed}: {measured}");
            }
        }
    }
}

#[test]
fn without_a_height_the_wind_decides() {
    let measured = significant_height_m(measured_variance(&mut wind_sea(TILE, WIND), 5.0));
    assert!((measured / 2.1330 - 1.0).abs() < 1e-3, "{measured}");
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
    let m0 = wind_sea(TILE, WIND).variance_m2();
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

/// Where waves run against each other they interfere: the variance swings, but not its mean over time.
#[test]
fn opposing_waves_have_it_on_average() {
    let wind = PhillipsParameters { opposing_energy: 1.0, ..WIND };
    let mut sea = wind_sea(SpectralTileParameters { resolution: 32, ..TILE }, wind);
    let times = 200;
    let mean =
        (0..times).map(|i| measured_variance(&mut sea, 7.3 * f64::from(i))).sum::<f64>() / f64::from(times);
    assert!((mean / sea.variance_m2() - 1.0).abs() < 0.03, "{}", mean / sea.variance_m2());
}

#[test]
fn systems_add_by_variance() {
    let swell = PhillipsParameters { toward: DVec2::NEG_Y, significant_height_m: Some(1.5), ..WIND };
    let systems: Vec<Box<dyn WaveSpectrum>> =
        vec![Box::new(Phillips::new(WIND).unwrap()), Box::new(Phillips::new(swell).unwrap())];
    let mut both = SpectralTile::new(TILE, &systems).unwrap();
    let expected = systems[0].variance_m2() + systems[1].variance_m2();
    assert!((both.variance_m2() / expected - 1.0).abs() < 1e-12);
    assert!((measured_variance(&mut both, 4.0) / expected - 1.0).abs() < 0.1);
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
