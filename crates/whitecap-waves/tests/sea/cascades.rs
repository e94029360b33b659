//! Tiles share a spectrum out without loss, and without counting anything twice.

use crate::{TILE, WIND};
use glam::DVec2;
use std::f64::consts::TAU;
use whitecap_waves::ParameterError;
use whitecap_waves::model::spectral::{
    Amplitudes, Band, Cascade, CascadeBudget, SpectralSea, SpectralSeaParameters, SpectralTile,
    SpectralTileParameters, Water,
};
use whitecap_waves::model::{Surface, TileFields, WaveModel};
use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};
use whitecap_waves::spectrum::{Profile, WaveSpectrum};
use whitecap_waves::statistics::Moments;

const BUDGET: CascadeBudget =
    CascadeBudget { tile_size_m: None, shortest_wave_m: 0.05, cascades: 4, resolution: 128 };

fn wind_sea(wind_speed_mps: f64) -> Phillips {
    Phillips::new(PhillipsParameters { wind_speed_mps, ..WIND }).expect("a spectrum within its ranges")
}

fn sea(cascades: Vec<Cascade>, seed: u64, amplitudes: Amplitudes, systems: &[Phillips]) -> SpectralSea {
    let parameters =
        SpectralSeaParameters { cascades, choppiness: 1.0, water: Water::STILL, seed, amplitudes };
    SpectralSea::new(parameters, systems).expect("a sea that fits")
}

fn planned(systems: &[Phillips]) -> SpectralSea {
    sea(Cascade::plan(systems, BUDGET), 5, Amplitudes::Deterministic, systems)
}

#[test]
fn a_planned_sea_loses_less_than_half_a_per_cent() {
    for systems in [vec![wind_sea(3.0)], vec![wind_sea(10.0)], vec![wind_sea(25.0), wind_sea(6.0)]] {
        let sea = planned(&systems);
        let m0: f64 = systems.iter().map(WaveSpectrum::variance_m2).sum();
        assert!((sea.variance_m2() / m0 - 1.0).abs() < 5e-3, "{}", sea.variance_m2() / m0);
        for captured in sea.captured_fractions() {
            assert!((captured - 1.0).abs() < 5e-3, "{captured}");
        }
    }
}

/// Each tile has the energy of its band and no other.
#[test]
fn every_tile_has_its_band() {
    let system = wind_sea(10.0);
    let profile = Profile::of(&system);
    for tile in planned(&[system]).tiles() {
        let band = tile.parameters().band;
        let expected = profile.variance_m2(band);
        let tolerance = 0.02 * expected + 1e-5 * system.variance_m2();
        assert!(
            (tile.variance_m2() - expected).abs() < tolerance,
            "{band:?}: {}",
            tile.variance_m2() / expected
        );
        for p in 0..tile.resolution() / 2 {
            let [p_re, p_im, q_re, q_im] = tile.column(p).amplitudes;
            for q in 0..tile.resolution() {
                let signed =
                    if q < tile.resolution() / 2 { q as f64 } else { q as f64 - tile.resolution() as f64 };
                let k = TAU / tile.tile_size_m() * signed.hypot(p as f64);
                let energy = p_re[q].abs() + p_im[q].abs() + q_re[q].abs() + q_im[q].abs();
                let slack = 0.8 * TAU / tile.tile_size_m();
                let may = k > band.from - slack && k < band.to + slack;
                assert!(may || energy == 0.0, "{k} in {band:?}");
            }
        }
    }
}

/// Two bands on the same lattice are the whole lattice, wave by wave.
#[test]
fn bands_add_up_cell_by_cell() {
    let tile = |band| {
        let tile = SpectralTileParameters { band, ..TILE };
        SpectralTile::new(tile, &[wind_sea(10.0)]).map(|tile| tile.variance_m2())
    };
    // The upper band alone holds too little to be a sea; the middle of three would not either.
    let edge = 0.2;
    let low = tile(Band { from: 0.0, to: edge }).unwrap();
    let whole = tile(Band::WHOLE).unwrap();
    let refused = tile(Band { from: edge, to: f64::INFINITY });
    assert!(matches!(refused, Err(ParameterError::SeaDoesNotFit { .. })), "{refused:?}");
    let parts = vec![
        Cascade { band: Band { from: 0.0, to: edge }, ..Cascade::whole(400.0, 64) },
        Cascade { band: Band { from: edge, to: f64::INFINITY }, ..Cascade::whole(400.0, 64) },
    ];
    let sum = sea(parts, 1, Amplitudes::Deterministic, &[wind_sea(10.0)]);
    assert!((sum.tiles()[0].variance_m2() / low - 1.0).abs() < 1e-12);
    // Where an edge cuts a cell its two parts are integrated on a finer grid than the whole.
    assert!((sum.variance_m2() / whole - 1.0).abs() < 1e-3, "{}", sum.variance_m2() / whole);
}

#[test]
fn the_surface_is_the_sum_of_its_tiles() {
    let sea = planned(&[wind_sea(8.0)]);
    let (at, time_s) = (DVec2::new(12.0, -3.5), 7.0);
    let sum: f64 = sea.tiles().iter().map(|tile| tile.sample(at, time_s).height_m()).sum();
    assert!((sea.sample(at, time_s).height_m() - sum).abs() < 1e-12);
    // The phases of one tile are not those of another.
    let [first, second, ..] = sea.tiles() else { panic!() };
    let phase = |tile: &SpectralTile| {
        let [re, im, ..] = tile.column(9).amplitudes;
        f64::from(im[3]).atan2(f64::from(re[3]))
    };
    assert!((phase(first) - phase(second)).abs() > 1e-3);
}

/// Over the tiles of 32 Gaussian seas the mean variance is that of the spectrum, within 3 % of the height.
#[test]
fn gaussian_seas_have_their_height_on_average() {
    let system = wind_sea(10.0);
    let cascades = Cascade::plan(&[system], CascadeBudget { resolution: 64, cascades: 2, ..BUDGET });
    let (mut sum, mut fields, mut expected) = (0.0, TileFields::default(), 0.0);
    for seed in 0..32 {
        let mut sea = sea(cascades.clone(), seed, Amplitudes::Gaussian, &[system]);
        expected = sea.variance_m2();
        for tile in sea.tiles_mut() {
            tile.evaluate(2.5, &mut fields);
            sum += Moments::of(&fields.height).variance / 32.0;
        }
    }
    assert!(((sum / expected).sqrt() - 1.0).abs() < 0.03, "{}", sum / expected);
}

#[test]
fn a_system_that_no_tile_holds_is_named_with_what_to_change() {
    let parameters = SpectralSeaParameters {
        cascades: Cascade::split(&[(50.0, 64), (8.0, 64)]),
        choppiness: 1.0,
        water: Water::STILL,
        seed: 1,
        amplitudes: Amplitudes::Deterministic,
    };
    let Err(error) = SpectralSea::new(parameters.clone(), &[wind_sea(3.0), wind_sea(25.0)]) else { panic!() };
    let ParameterError::SeaDoesNotFit { system: 1, captured_fraction, .. } = error else { panic!("{error}") };
    assert!(captured_fraction < 0.5);
    assert!(error.to_string().contains("m is large enough"), "{error}");
    for cascades in [vec![], vec![Cascade::whole(50.0, 64); 9]] {
        let Err(error) =
            SpectralSea::new(SpectralSeaParameters { cascades, ..parameters.clone() }, &[wind_sea(3.0)])
        else {
            panic!()
        };
        assert!(error.to_string().contains("1 to 8 tiles"), "{error}");
    }
}
