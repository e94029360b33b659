//! The laws of foam.

#![allow(clippy::unwrap_used, reason = "a helper of tests may fail as a test may")]

use glam::DVec2;
use std::time::Instant;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::model::spectral::foam::{DECAY_S, Foam, FoamLevel, FoamParameters};
use whitecap_waves::model::spectral::{
    Amplitudes, Cascade, CascadeBudget, SpectralSea, SpectralSeaParameters, Water,
};
use whitecap_waves::model::{TileFields, WaveModel};
use whitecap_waves::optics::foam_cover;
use whitecap_waves::spectrum::directional::{Directional, DirectionalParameters};
use whitecap_waves::spectrum::jonswap::{Jonswap, MEAN_PEAK_ENHANCEMENT};
use whitecap_waves::spreading::{Spread, Spreading};
use whitecap_waves::statistics::whitecap_cover;

/// The sea of a wind over 300 km, on four tiles.
fn sea(wind_speed_mps: f64, seed: u64, resolution: usize, water: Water) -> SpectralSea {
    let energy = Jonswap::from_wind_and_fetch(wind_speed_mps, 3e5, MEAN_PEAK_ENHANCEMENT).unwrap();
    of_systems(&[spread(energy)], seed, resolution, water)
}

fn spread(energy: Jonswap) -> Directional<Jonswap> {
    let directions = DirectionalParameters {
        spread: Spread { spreading: Spreading::Hasselmann, swell: 0.0 },
        toward: DVec2::X,
        dispersion: Dispersion::DEEP,
    };
    Directional::new(energy, directions).unwrap()
}

fn of_systems(systems: &[Directional<Jonswap>], seed: u64, resolution: usize, water: Water) -> SpectralSea {
    let budget = CascadeBudget { tile_size_m: None, shortest_wave_m: 0.1, cascades: 4, resolution };
    let parameters = SpectralSeaParameters {
        cascades: Cascade::plan(systems, budget),
        choppiness: 1.0,
        water,
        seed,
        amplitudes: Amplitudes::Deterministic,
    };
    SpectralSea::new(parameters, systems).unwrap()
}

fn foam(sea: &SpectralSea, wind_speed_mps: f64) -> Foam {
    Foam::new(sea, FoamParameters { wind_speed_mps: Some(wind_speed_mps), decay_s: DECAY_S })
        .unwrap()
        .unwrap()
}

/// The sum of the fields at a rest point, between samples as a texture gives it.
fn excess(foam: &Foam, rest_m: DVec2) -> f64 {
    let n = foam.resolution();
    let sum: f64 = foam
        .tiles()
        .iter()
        .map(|tile| {
            let place = (rest_m / tile.tile_size_m()).rem_euclid(DVec2::ONE) * n as f64;
            let (corner, t) = (place.floor(), place.fract());
            let (x, z) = (corner.x as usize, corner.y as usize);
            let at = |i: usize, j: usize| f64::from(tile.field()[(z + j) % n * n + (x + i) % n]);
            let row = |j: usize| at(0, j) * (1.0 - t.x) + at(1, j) * t.x;
            row(0) * (1.0 - t.y) + row(1) * t.y
        })
        .sum();
    sum - foam.threshold()
}

/// Places all over the sea, by a sequence without pattern (Roberts's R2).
fn places(count: usize) -> impl Iterator<Item = DVec2> {
    (0..count).map(|i| i as f64 * DVec2::new(7_548.776_662, 5_698.402_91))
}

fn drawn_cover(foam: &Foam, count: usize) -> f64 {
    places(count).map(|place| foam_cover(excess(foam, place), 0.0)).sum::<f64>() / count as f64
}

#[test]
fn cover_is_that_of_monahan() {
    for wind in [7.0, 10.0, 15.0] {
        let mut covers = Vec::new();
        for seed in [3, 8] {
            let sea = sea(wind, seed, 256, Water::STILL);
            let start = Instant::now();
            let mut foam = foam(&sea, wind);
            let set_up = start.elapsed();
            let start = Instant::now();
            foam.evaluate(500.0);
            let alone = start.elapsed();
            let start = Instant::now();
            foam.evaluate(500.0 + 1.0 / 30.0);
            println!("set up {set_up:?}, alone {alone:?}, next {:?}", start.elapsed());
            for i in 0..12 {
                foam.evaluate(500.0 + 3.7 * f64::from(i));
                covers.push(drawn_cover(&foam, 200_000));
            }
            println!(
                "{wind} m/s, seed {seed}: threshold {:.2}, gain {:.3?}, {} tiles",
                foam.threshold(),
                foam.variance_gain(),
                foam.tiles().len()
            );
        }
        let mean = covers.iter().sum::<f64>() / covers.len() as f64;
        let wanted = whitecap_cover(wind);
        println!("{wind} m/s: {:.3} % of {:.3} %: {covers:.4?}", 100.0 * mean, 100.0 * wanted);
        assert!((mean / wanted - 1.0).abs() < 0.2, "{wind} m/s: {mean} for {wanted}");
        assert!(covers.iter().all(|cover| (cover / wanted - 1.0).abs() < 0.6), "{wind} m/s: {covers:?}");
    }
}

#[test]
fn a_frame_alone_is_the_frame_of_a_sequence() {
    for loop_s in [None, Some(10.0)] {
        let sea = sea(12.0, 5, 64, Water { loop_s, ..Water::STILL });
        let (mut sequence, mut alone) = (foam(&sea, 12.0), foam(&sea, 12.0));
        // Across the ends of blocks, forwards, with leaps, and back.
        for time_s in [-3.0, 0.0, 0.04, 0.3, 7.7, 20.9, 21.3, 30.0, 42.2, 42.4, 41.0, 64.0, 1e6] {
            sequence.evaluate(time_s);
            let mut fresh = foam(&sea, 12.0);
            fresh.evaluate(time_s);
            alone.evaluate(-500.0);
            alone.evaluate(time_s);
            for ((a, b), c) in sequence.tiles().iter().zip(fresh.tiles()).zip(alone.tiles()) {
                assert!(
                    a.field().iter().zip(b.field()).all(|(a, b)| a.to_bits() == b.to_bits()),
                    "{time_s} s"
                );
                assert_eq!(a.field(), c.field(), "{time_s} s");
            }
        }
    }
}

/// Nothing is lost faster than 1/e in the stated time, and what no wave renews is lost just as fast.
#[test]
fn a_patch_left_alone_loses_its_e_th_part() {
    let sea = sea(10.0, 5, 64, Water::STILL);
    let mut foam = foam(&sea, 10.0);
    // A time of the grid, since what happens between its times is seen while it happens and not remembered; and the start
    // of a block, since nothing is forgotten then.
    let start_s = 480.0 * DECAY_S / 16.0;
    foam.evaluate(start_s);
    let before: Vec<f64> = places(2_000).map(|place| excess(&foam, place)).collect();
    for after_s in [0.1, 1.0, DECAY_S] {
        foam.evaluate(start_s + after_s);
        let mut alone = 0;
        for (place, before) in places(2_000).zip(&before) {
            let lost = before - excess(&foam, place);
            assert!(lost < after_s / DECAY_S + 1e-3, "{after_s} s: {lost}");
            alone += usize::from((lost - after_s / DECAY_S).abs() < 1e-3);
        }
        println!("{after_s} s: {alone} of 2000 are left alone");
        assert!(alone > 20, "{after_s} s: {alone}");
    }
}

/// What changes in a thousandth of a second is small, at the ends of steps and blocks too.
#[test]
fn foam_is_continuous_in_time() {
    let sea = sea(12.0, 5, 64, Water::STILL);
    let mut foam = foam(&sea, 12.0);
    let block_s = 5.0 * DECAY_S;
    let mut at = |time_s: f64| {
        foam.evaluate(time_s);
        places(3_000).map(|place| foam_cover(excess(&foam, place), 0.0)).collect::<Vec<_>>()
    };
    for time_s in [3.0, 17.0 * block_s / 80.0, block_s, 1.75 * block_s, 2.0 * block_s] {
        let (before, after) = (at(time_s - 5e-4), at(time_s + 5e-4));
        let most = before.iter().zip(&after).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        println!("{time_s} s: {most:.5}");
        assert!(most > 0.0 && most < 0.02, "{time_s} s: {most}");
    }
}

/// The end of a block does not show in the cover: places are white as often when much of it is remembered.
#[test]
fn blocks_do_not_show() {
    let sea = sea(12.0, 5, 128, Water::STILL);
    let mut foam = foam(&sea, 12.0);
    let block_s = 5.0 * DECAY_S;
    let mut by_part = [0.0; 4];
    for block in 0..6 {
        for (i, sum) in by_part.iter_mut().enumerate() {
            foam.evaluate((f64::from(block) + [0.01, 0.35, 0.7, 0.97][i]) * block_s);
            *sum += drawn_cover(&foam, 40_000) / 6.0;
        }
    }
    println!("{by_part:.5?} of {:.5}", foam.cover());
    let mean = by_part.iter().sum::<f64>() / 4.0;
    assert!(by_part.iter().all(|cover| (cover / mean - 1.0).abs() < 0.25), "{by_part:?}");
}

#[test]
fn a_loop_closes() {
    for loop_s in [8.0, 60.0] {
        let sea = sea(12.0, 5, 64, Water { loop_s: Some(loop_s), ..Water::STILL });
        let mut foam = foam(&sea, 12.0);
        let mut at = |time_s: f64| {
            foam.evaluate(time_s);
            places(1_000).map(|place| excess(&foam, place)).collect::<Vec<_>>()
        };
        let repeats_s = loop_s * (5.0 * DECAY_S / loop_s).ceil();
        let (first, again) = (at(5.0), at(5.0 + repeats_s));
        assert!(first.iter().zip(&again).all(|(a, b)| (a - b).abs() < 1e-2), "{loop_s} s");
    }
}

#[test]
fn a_calm_sea_has_no_foam() {
    let sea = sea(10.0, 5, 64, Water::STILL);
    for wind_speed_mps in [0.0, 0.5] {
        let parameters = FoamParameters { wind_speed_mps: Some(wind_speed_mps), decay_s: DECAY_S };
        assert!(Foam::new(&sea, parameters).unwrap().is_none());
    }
    let upright = SpectralSea::new(
        SpectralSeaParameters { choppiness: 0.0, ..sea.parameters().clone() },
        &[] as &[Jonswapped],
    )
    .unwrap();
    assert!(
        Foam::new(&upright, FoamParameters { wind_speed_mps: Some(10.0), decay_s: DECAY_S })
            .unwrap()
            .is_none()
    );
    for parameters in [
        FoamParameters { wind_speed_mps: Some(-1.0), decay_s: DECAY_S },
        FoamParameters { wind_speed_mps: Some(f64::NAN), decay_s: DECAY_S },
        FoamParameters { wind_speed_mps: Some(9.0), decay_s: 0.0 },
    ] {
        assert!(Foam::new(&sea, parameters).is_err());
    }
}

/// A sea that names no wind has the foam of the one that would have raised it; a swell has none.
#[test]
fn steepness_stands_for_the_wind() {
    for wind in [7.0, 10.0, 15.0] {
        let foam = Foam::new(
            &sea(wind, 5, 64, Water::STILL),
            FoamParameters { wind_speed_mps: None, decay_s: DECAY_S },
        );
        let found = foam.unwrap().unwrap().wind_speed_mps();
        println!("{wind} m/s: as steep as {found:.2} m/s");
        assert!((found / wind - 1.0).abs() < 0.5, "{wind}: {found}");
    }
    let swell = spread(Jonswap::from_height_and_period(1.2, 11.0, 5.0).unwrap());
    let foam = Foam::new(
        &of_systems(&[swell], 5, 64, Water::STILL),
        FoamParameters { wind_speed_mps: None, decay_s: DECAY_S },
    );
    assert!(foam.unwrap().is_none_or(|foam| foam.cover() < 2e-4));
}

type Jonswapped = Directional<Jonswap>;

/// Where the first tile has the most convergence, its Jacobian is the least: of the hundredth part of the places that
/// comes first by one, most come first by the other.
#[test]
fn convergence_finds_the_folds() {
    let mut sea = sea(15.0, 5, 128, Water::STILL);
    let mut fields = TileFields::default();
    sea.tiles_mut()[0].evaluate(10.0, &mut fields);
    let n = fields.resolution() * fields.resolution();
    let first = |of: &dyn Fn(usize) -> f32| {
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by(|&a, &b| of(a).total_cmp(&of(b)));
        order.truncate(n / 100);
        order.into_iter().collect::<std::collections::HashSet<_>>()
    };
    let by_area = first(&|i| fields.jacobian(i));
    let by_convergence = first(&|i| fields.gradient_xx[i] + fields.gradient_zz[i]);
    let both = by_area.intersection(&by_convergence).count() as f64 / by_area.len() as f64;
    println!("{:.1} % of the folds", 100.0 * both);
    assert!(both > 0.8, "{both}");
}

/// From level to level the mean stays and variance within texels takes what it loses; at the last one all of a sea has
/// the cover of its wind.
#[test]
fn averaged_away_the_sea_is_as_white() {
    for wind in [7.0, 15.0] {
        let sea = sea(wind, 5, 256, Water::STILL);
        let mut foam = foam(&sea, wind);
        foam.evaluate(40.0);
        let mut levels: Vec<FoamLevel> =
            foam.tiles().iter().map(|tile| FoamLevel::of(tile.field(), foam.resolution())).collect();
        loop {
            // Tiles are independent: at some level of each, any place meets any other.
            let (size, count) = (levels[0].size(), 65_536);
            let texels: Vec<Vec<[f32; 2]>> = levels.iter().map(|level| level.texels().collect()).collect();
            let mut sum = 0.0;
            for place in places(count) {
                let (mut m, mut variance) = (0.0, 0.0);
                for (texels, metres) in texels.iter().zip([97.3, 41.9, 13.7, 5.1]) {
                    let at = (place / metres).rem_euclid(DVec2::ONE) * size as f64;
                    let (x, z, t) = (at.x as usize % size, at.y as usize % size, at.fract());
                    let bilinear = |channel: usize| {
                        let texel = |i: usize, j: usize| {
                            f64::from(texels[(z + j) % size * size + (x + i) % size][channel])
                        };
                        let row = |j: usize| texel(0, j) * (1.0 - t.x) + texel(1, j) * t.x;
                        row(0) * (1.0 - t.y) + row(1) * t.y
                    };
                    m += bilinear(0);
                    variance += bilinear(1);
                }
                sum += foam.cover_of(m, variance);
            }
            let cover = sum / count as f64;
            println!("{wind} m/s, {size}²: {:.4} % of {:.4} %", 100.0 * cover, 100.0 * foam.cover());
            assert!((cover / foam.cover() - 1.0).abs() < 0.2, "{size}: {cover}");
            if size == 1 {
                break;
            }
            levels.iter_mut().for_each(FoamLevel::halve);
        }
    }
}

/// Writes what foam looks like from above, and holds it to repeat with no tile.
#[test]
fn foam_from_above_does_not_repeat() {
    let sea = sea(12.0, 5, 256, Water::STILL);
    let mut foam = foam(&sea, 12.0);
    const SIDE: usize = 640;
    const CELL_M: f64 = 0.6;
    let mut picture = |time_s: f64, from: DVec2| -> Vec<f64> {
        foam.evaluate(time_s);
        let at = |i: usize| from + CELL_M * DVec2::new((i % SIDE) as f64, (i / SIDE) as f64);
        (0..SIDE * SIDE).map(|i| foam_cover(excess(&foam, at(i)), 0.0)).collect()
    };
    let first = picture(60.0, DVec2::ZERO);
    for (name, time_s) in
        [("foam-0", 60.0), ("foam-1", 60.0 + 1.0 / 30.0), ("foam-2", 61.0), ("foam-3", 63.0)]
    {
        let mut file = format!("P5 {SIDE} {SIDE} 255\n").into_bytes();
        file.extend(picture(time_s, DVec2::ZERO).iter().map(|foam| (255.0 * foam.powf(0.45)) as u8));
        std::fs::write(format!("{}/{name}.pgm", env!("CARGO_TARGET_TMPDIR")), file).unwrap();
    }
    let correlation = |other: &[f64]| {
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let (a, b) = (mean(&first), mean(other));
        let product = |x: &[f64], x0: f64, y: &[f64], y0: f64| -> f64 {
            x.iter().zip(y).map(|(x, y)| (x - x0) * (y - y0)).sum()
        };
        product(&first, a, other, b) / (product(&first, a, &first, a) * product(other, b, other, b)).sqrt()
    };
    let soon = correlation(&picture(60.0 + 1.0 / 30.0, DVec2::ZERO));
    println!("a thirtieth of a second later {soon:.4}");
    assert!(soon > 0.98, "{soon}");
    for tile in sea.tiles().iter().skip(1) {
        let shifted = correlation(&picture(60.0, DVec2::new(tile.parameters().tile_size_m, 0.0)));
        println!("a tile of {:.1} m further {shifted:.3}", tile.parameters().tile_size_m);
        // A short tile's length is less than a patch's.
        assert!(shifted < 0.3 || tile.parameters().tile_size_m < 50.0, "{shifted}");
    }
}
