//! Which seas fit which tiles, and what is said of those that do not.

use crate::{OneWave, TILE, WIND, wind_sea};
use glam::DVec2;
use whitecap_waves::model::Surface;
use whitecap_waves::model::spectral::{SpectralTile, SpectralTileParameters};
use whitecap_waves::spectrum::WaveSpectrum;
use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};
use whitecap_waves::{ParameterError, Remedy};

fn refusal(tile: SpectralTileParameters, wind: PhillipsParameters) -> ParameterError {
    match SpectralTile::new(tile, &[Phillips::new(wind).expect("a spectrum within its ranges")]) {
        Ok(sea) => panic!("accepted, with {} captured", sea.captured_fraction()),
        Err(error) => error,
    }
}

#[test]
fn a_roomy_tile_captures_nearly_everything() {
    for resolution in [64, 128, 256] {
        let captured = wind_sea(SpectralTileParameters { resolution, ..TILE }, WIND).captured_fraction();
        assert!((0.95..1.01).contains(&captured), "{resolution}: {captured}");
    }
}

/// Of a Phillips spectrum the share exp(−1/(kL)²) has wave numbers below k: the integral of its radial part.
#[test]
fn the_captured_share_is_that_of_the_band() {
    let tile = SpectralTileParameters { tile_size_m: 1200.0, resolution: 64, ..TILE };
    let captured = wind_sea(tile, WIND).captured_fraction();
    let (k_max, length) = (std::f64::consts::PI * 64.0 / 1200.0, 100.0 / 9.81);
    // Inside the circle of radius k_max lies this much, and some more in the corners of the square.
    let inside = (-1.0 / (k_max * length).powi(2)).exp();
    assert!(captured > inside - 0.03 && captured < inside + 0.15, "{captured} for {inside}");
}

#[test]
fn waves_too_long_for_the_tile() {
    let storm = PhillipsParameters { wind_speed_mps: 25.0, ..WIND };
    let tile = SpectralTileParameters { tile_size_m: 40.0, ..TILE };
    let error = refusal(tile, storm);
    let ParameterError::SeaDoesNotFit { captured_fraction, remedy, .. } = error.clone() else {
        panic!("{error}");
    };
    assert!(captured_fraction < 0.5);
    let text = error.to_string();
    assert!(
        text.contains("40 m") && text.contains("too long") && text.contains("m is large enough"),
        "{text}"
    );
    // The peak over k lies where d/dk (k⁻³ exp(−1/(kL)²)) = 0, at k = √(2/3)/L.
    let expected = 4.0 * std::f64::consts::TAU * (625.0 / 9.81) / (2.0_f64 / 3.0).sqrt();
    let Remedy::LargerTile { tile_size_m } = remedy else { panic!("{text}") };
    assert!((tile_size_m / expected - 1.0).abs() < 0.02, "{tile_size_m} for {expected}");
    let roomy = SpectralTileParameters { tile_size_m, ..TILE };
    assert!(wind_sea(roomy, storm).captured_fraction() > 0.9);
}

#[test]
fn waves_too_short_for_the_samples() {
    let breath = PhillipsParameters { wind_speed_mps: 2.0, ..WIND };
    let error = refusal(SpectralTileParameters { resolution: 32, ..TILE }, breath);
    let ParameterError::SeaDoesNotFit { remedy: Remedy::CloserSamples { spacing_m }, .. } = error else {
        panic!("{error}");
    };
    assert!(error.to_string().contains("too short"), "{error}");
    let fine = SpectralTileParameters { tile_size_m: 64.0 * spacing_m, ..TILE };
    assert!((wind_sea(fine, breath).captured_fraction() - 0.9).abs() < 0.08);
}

#[test]
fn parameters_are_checked() {
    let spectrum = [Phillips::new(WIND).unwrap()];
    for (field, tile) in [
        ("tile_size_m", SpectralTileParameters { tile_size_m: 0.0, ..TILE }),
        ("tile_size_m", SpectralTileParameters { tile_size_m: f64::NAN, ..TILE }),
        ("resolution", SpectralTileParameters { resolution: 100, ..TILE }),
        ("resolution", SpectralTileParameters { resolution: 8, ..TILE }),
        ("resolution", SpectralTileParameters { resolution: 4096, ..TILE }),
        ("choppiness", SpectralTileParameters { choppiness: -1.0, ..TILE }),
    ] {
        let Err(error) = SpectralTile::new(tile, &spectrum) else { panic!("{tile:?} was accepted") };
        assert!(error.to_string().starts_with(field), "{error}");
    }
}

struct Broken;

impl WaveSpectrum for Broken {
    fn density_m4(&self, _: DVec2) -> f64 {
        f64::NAN
    }
    fn variance_m2(&self) -> f64 {
        1.0
    }
}

#[test]
fn a_broken_spectrum_is_an_error() {
    assert!(SpectralTile::new(TILE, &[Broken]).is_err());
}

/// A finer grid over the same tile: the one wave that both have is the same to the last digit of the sum.
#[test]
fn a_finer_grid_keeps_the_coarse_waves() {
    let wave = OneWave { tile_size_m: 400.0, lattice: DVec2::new(6.0, -5.0), variance_m2: 0.5 };
    let at = |resolution| {
        let sea = SpectralTile::new(SpectralTileParameters { resolution, ..TILE }, &[&wave]).unwrap();
        sea.sample(DVec2::new(31.0, 77.0), 5.0).displacement_m
    };
    assert_eq!(at(16), at(32));
    assert_eq!(at(16), at(256));
}
