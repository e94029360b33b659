//! The fields belong together: grid and direct sum, slopes and heights, displacement and Jacobian.

use crate::{TILE, WIND, one_wave, wind_sea};
use glam::{DVec2, DVec3, Vec3};
use proptest::prelude::*;
use whitecap_waves::direction::toward_from_nautical;
use whitecap_waves::model::spectral::{Amplitudes, Band, SpectralTile, SpectralTileParameters, Water};
use whitecap_waves::model::{Surface, TileFields, WaveModel};
use whitecap_waves::spectrum::phillips::PhillipsParameters;
use whitecap_waves::statistics::significant_height_m;

/// A sea with energy in all directions on an odd-sized tile, so that no axis or sign is like another.
fn lopsided(resolution: usize, seed: u64) -> SpectralTile {
    let wind = PhillipsParameters { toward: toward_from_nautical(237.0), opposing_energy: 0.3, ..WIND };
    let tile = SpectralTileParameters {
        tile_size_m: 310.0,
        resolution,
        band: Band::WHOLE,
        choppiness: 0.8,
        water: Water::STILL,
        seed,
        amplitudes: Amplitudes::Gaussian,
    };
    wind_sea(tile, wind)
}

/// The gradients ∂dx/∂x, ∂dx/∂z, ∂dz/∂x, ∂dz/∂z and the slopes, by central differences of `sample`.
fn differences(sea: &SpectralTile, rest: DVec2, time_s: f64) -> (DVec3, DVec3) {
    let step = 1e-3;
    let along = |axis: DVec2| {
        let ahead = sea.sample(rest + axis * step, time_s).displacement_m;
        let behind = sea.sample(rest - axis * step, time_s).displacement_m;
        (ahead - behind) / (2.0 * step)
    };
    (along(DVec2::X), along(DVec2::Y))
}

#[test]
fn the_tile_is_the_direct_sum() {
    for (resolution, time_s) in [(16, 0.0), (32, 12.3), (64, -4.5), (32, 1e6), (32, -1e6)] {
        let mut sea = lopsided(resolution, 5);
        let mut fields = TileFields::default();
        sea.evaluate(time_s, &mut fields);
        let height = significant_height_m(sea.variance_m2());
        let spacing = sea.tile_size_m() / resolution as f64;
        for i in (0..resolution * resolution).step_by(37) {
            let rest = DVec2::new((i % resolution) as f64, (i / resolution) as f64) * spacing;
            let point = sea.sample(rest, time_s);
            let displacement = Vec3::from(fields.displacement(i)).as_dvec3();
            assert!(displacement.distance(point.displacement_m) < 1e-4 * height, "{i} at {time_s}");
            assert!(Vec3::from(fields.normal(i)).as_dvec3().distance(point.normal) < 1e-4);
            assert!((f64::from(fields.jacobian(i)) - point.jacobian).abs() < 1e-4);
            let slope = DVec2::new(f64::from(fields.slope_x[i]), f64::from(fields.slope_z[i]));
            assert!(slope.distance(point.slope) < 1e-4);
        }
    }
}

#[test]
fn gradients_are_those_of_the_displacement() {
    let mut sea = lopsided(32, 11);
    let mut fields = TileFields::default();
    sea.evaluate(6.0, &mut fields);
    for i in [0, 33, 500, 777, 1023] {
        let rest = DVec2::new((i % 32) as f64, (i / 32) as f64) * (310.0 / 32.0);
        let (along_x, along_z) = differences(&sea, rest, 6.0);
        for (field, expected) in [
            (&fields.gradient_xx, along_x.x),
            (&fields.gradient_xz, along_x.z),
            (&fields.gradient_xz, along_z.x),
            (&fields.gradient_zz, along_z.z),
            (&fields.slope_x, along_x.y),
            (&fields.slope_z, along_z.y),
        ] {
            assert!((f64::from(field[i]) - expected).abs() < 2e-5, "{i}: {} for {expected}", field[i]);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn normal_slope_and_jacobian_follow_from_the_position(
        x in -500.0..500.0_f64, z in -500.0..500.0_f64, time_s in -1e3..1e3_f64, seed in any::<u64>(),
    ) {
        let sea = lopsided(16, seed);
        let point = sea.sample(DVec2::new(x, z), time_s);
        let (along_x, along_z) = differences(&sea, DVec2::new(x, z), time_s);
        let normal = (DVec3::Z + along_z).cross(DVec3::X + along_x);
        prop_assert!((point.jacobian - normal.y).abs() < 1e-6);
        prop_assert!(point.normal.distance(normal.normalize()) < 1e-6);
        prop_assert!(point.slope.distance(DVec2::new(along_x.y, along_z.y)) < 1e-6);
    }

    #[test]
    fn the_surface_repeats_with_the_tile(
        x in 0.0..310.0_f64, z in 0.0..310.0_f64, across in -9..9_i32, down in -9..9_i32,
    ) {
        let sea = lopsided(16, 3);
        let rest = DVec2::new(x, z);
        let far = rest + 310.0 * DVec2::new(f64::from(across), f64::from(down));
        let (here, there) = (sea.sample(rest, 8.0), sea.sample(far, 8.0));
        prop_assert!(here.displacement_m.distance(there.displacement_m) < 1e-9);
        prop_assert!(here.normal.distance(there.normal) < 1e-9);
    }
}

/// Gerstner's wave: under a crest of a cos θ the water moves by −λ a sin θ along the travel, so crests crowd
/// together, J = 1 − λ k a there and 1 + λ k a in the trough.
#[test]
fn crests_are_sharp_and_troughs_are_wide() {
    for (p, q) in [(4.0, 0.0), (0.0, 4.0), (-4.0, 0.0), (3.0, -4.0)] {
        let (wave, mut sea) = one_wave(p, q);
        let steepness = 0.5 * wave.k().length();
        let mut fields = TileFields::default();
        sea.evaluate(1.0, &mut fields);
        let n = sea.resolution();
        let (mut above, mut area) = (0.0, 0.0);
        for i in 0..n * n {
            let (height, jacobian) = (f64::from(fields.height[i]), f64::from(fields.jacobian(i)));
            assert!((jacobian - (1.0 - steepness * height / 0.5)).abs() < 1e-4);
            above += if height > 0.0 { jacobian } else { 0.0 };
            area += jacobian;
        }
        assert!(above / area < 0.5 - 0.2 * steepness, "crests take {} of the water", above / area);
    }
}

/// ∫ det ∇(x + λD) over a tile is the tile's area: D is periodic, so the displaced water covers the sea once.
#[test]
fn the_jacobian_has_mean_one() {
    let mut sea = lopsided(64, 21);
    let mut fields = TileFields::default();
    for time_s in [0.0, 10.0] {
        sea.evaluate(time_s, &mut fields);
        let mean = (0..64 * 64).map(|i| f64::from(fields.jacobian(i))).sum::<f64>() / 4096.0;
        assert!((mean - 1.0).abs() < 1e-5, "{mean}");
    }
}

#[test]
fn choppiness_scales_the_displacement_and_nothing_else() {
    let sea = |choppiness| wind_sea(SpectralTileParameters { choppiness, ..TILE }, WIND);
    let at = |choppiness: f64| sea(choppiness).sample(DVec2::new(17.0, 91.0), 3.0);
    let (none, one, two) = (at(0.0), at(1.0), at(2.0));
    assert_eq!(none.displacement_m.with_y(0.0), DVec3::ZERO);
    assert_eq!(none.jacobian, 1.0);
    assert!((two.displacement_m.with_y(0.0) - 2.0 * one.displacement_m.with_y(0.0)).length() < 1e-12);
    assert_eq!((none.displacement_m.y, none.slope), (two.displacement_m.y, two.slope));
}

/// Under too much choppiness a crest turns over: J and the normal's y go below zero together, and the tile
/// says the same as the direct sum.
#[test]
fn a_folded_crest_shows_its_underside() {
    let (_, gentle) = one_wave(4.0, 0.0);
    let tile = SpectralTileParameters { choppiness: 10.0, ..*gentle.parameters() };
    let (wave, _) = one_wave(4.0, 0.0);
    let mut sea = SpectralTile::new(tile, &[wave]).unwrap();
    let mut fields = TileFields::default();
    sea.evaluate(0.0, &mut fields);
    let crest = (0..32).max_by(|&a, &b| fields.height[a].total_cmp(&fields.height[b])).unwrap();
    let point = sea.sample(DVec2::new(crest as f64 * 100.0 / 32.0, 0.0), 0.0);
    assert!(point.jacobian < 0.0 && point.normal.y < 0.0, "{point:?}");
    assert!((f64::from(fields.jacobian(crest)) - point.jacobian).abs() < 1e-4);
    assert!(Vec3::from(fields.normal(crest)).as_dvec3().distance(point.normal) < 1e-3);
}
