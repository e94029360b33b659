//! A snapshot against the direct sum over all waves.

#![allow(clippy::unwrap_used)]

use super::*;
use crate::model::spectral::{
    Amplitudes, Band, Cascade, CascadeBudget, SpectralSea, SpectralSeaParameters, Water,
};
use crate::spectrum::directional::{Directional, DirectionalParameters};
use crate::spectrum::jonswap::Jonswap;
use crate::spectrum::phillips::{Phillips, PhillipsParameters};
use crate::spreading::{Spread, Spreading};
use crate::statistics::significant_height_m;
use glam::{DMat2, DVec3};

fn wind_sea(wind_speed_mps: f64) -> Phillips {
    Phillips::new(PhillipsParameters {
        wind_speed_mps,
        toward: DVec2::from_angle(0.4),
        significant_height_m: None,
        opposing_energy: 0.1,
        small_wave_cutoff_m: 0.0,
    })
    .unwrap()
}

fn sea(cascades: Vec<Cascade>, spectrum: Phillips, water: Water) -> SpectralSea {
    choppy_sea(1.0, cascades, spectrum, water)
}

fn choppy_sea(choppiness: f64, cascades: Vec<Cascade>, spectrum: Phillips, water: Water) -> SpectralSea {
    let parameters =
        SpectralSeaParameters { cascades, choppiness, water, seed: 11, amplitudes: Amplitudes::Gaussian };
    SpectralSea::new(parameters, &[spectrum]).unwrap()
}

/// Places all over, from the origin to 1,000 km away.
fn places(count: u32) -> Vec<DVec2> {
    let place = |i: u32| {
        let far = [100.0, 3e4, 1e6][i as usize % 3];
        far * DVec2::new(
            (0.754_877_666 * f64::from(i + 1)).fract() - 0.5,
            (0.569_840_291 * f64::from(i + 1)).fract() - 0.5,
        )
    };
    (0..count).map(place).collect()
}

/// The water over a place by direct sums: from where the answer rests, two steps of Newton's method further.
fn directly(surface: &SpectralSea, place_m: DVec2, found: &SurfacePoint, time_s: f64) -> SurfacePoint {
    let mut rest_m = place_m - along(found);
    let back = stretch(surface, rest_m, time_s).inverse();
    for _ in 0..2 {
        rest_m -= back * (rest_m + along(&surface.sample(rest_m, time_s)) - place_m);
    }
    surface.sample(rest_m, time_s)
}

/// The largest errors of a batch of answers, as shares of what is promised where J ≥ 0.3.
#[derive(Debug, Default)]
struct Worst {
    height: f64,
    displacement: f64,
    velocity: f64,
    normal: f64,
    compared: usize,
    steep: usize,
}

/// Asks `surface` and the direct sum. Where J < 0.3 errors may be 0.3/J times as large, or (0.3/J)² those of the normal; where
/// J < 0.1 they are held by the test of folds.
fn worst(surface: &SpectralSea, places: &[DVec2], time_s: f64) -> Worst {
    let bound = (1e-3 * significant_height_m(surface.variance_m2())).max(1e-3);
    let mut worst = Worst::default();
    for (place, found) in places.iter().zip(surface.query(places, time_s).unwrap()) {
        if found.jacobian < 0.1 {
            continue;
        }
        let expected = directly(surface, *place, &found, time_s);
        let room = (0.3 / found.jacobian).max(1.0);
        let of = |error: f64| error / bound / room;
        worst.height = worst.height.max(of((found.height_m() - expected.height_m()).abs()));
        worst.displacement =
            worst.displacement.max(of(found.displacement_m.distance(expected.displacement_m)));
        worst.velocity = worst.velocity.max(of(found.velocity_mps.distance(expected.velocity_mps)));
        let turned_rad = found.normal.angle_between(expected.normal);
        worst.normal = worst.normal.max(turned_rad / NORMAL_BOUND_RAD / (room * room));
        worst.compared += 1;
        worst.steep += usize::from(found.jacobian < 0.5);
    }
    worst
}

impl Worst {
    /// Within what is promised: height and displacement to 1 mm or 0.1 % of the significant height, velocity to as much a
    /// second, normals to 0.1°.
    fn check(&self, what: &str) {
        println!("{what}: {self:.2?}");
        let errors = [self.height, self.displacement, self.velocity, self.normal];
        assert!(errors.iter().all(|error| *error < 1.0), "{what}: {self:.3?}");
    }
}

/// From a calm to a storm, with several tiles and with one whose shortest waves have two samples.
#[test]
fn a_query_is_the_direct_sum() {
    let current = Water { current_mps: DVec2::new(0.7, -0.3), loop_s: Some(60.0), ..Water::STILL };
    for wind_speed_mps in [3.0, 8.0, 15.0, 25.0] {
        let spectrum = wind_sea(wind_speed_mps);
        let length = wind_speed_mps * wind_speed_mps / crate::GRAVITY_MPS2;
        let budget =
            CascadeBudget { tile_size_m: None, shortest_wave_m: 0.002 * length, cascades: 3, resolution: 64 };
        let several = sea(Cascade::plan(&[spectrum], budget), spectrum, Water::STILL);
        let one = sea(vec![Cascade::whole(40.0 * length, 64)], spectrum, current);
        for (surface, time_s) in [(several, 1e6), (one, -12.3)] {
            let worst = worst(&surface, &places(150), time_s);
            worst.check(&format!("{wind_speed_mps} m/s, {} tiles", surface.tiles().len()));
            assert!(worst.compared > 140, "{worst:?}");
        }
    }
}

/// The same on round, on sharp and on all but folding crests: the surface is drawn together by λ, the velocity of the
/// water is without it, over a bottom as over deep water.
#[test]
fn a_query_is_the_direct_sum_for_any_choppiness() {
    let spectrum = wind_sea(8.0);
    let shallow = Water { dispersion: crate::dispersion::Dispersion::at_depth(6.0).unwrap(), ..Water::STILL };
    for (choppiness, water) in [(0.0, shallow), (0.5, Water::STILL), (2.5, shallow), (4.0, Water::STILL)] {
        let surface = choppy_sea(choppiness, Cascade::split(&[(260.0, 64), (31.0, 64)]), spectrum, water);
        let worst = worst(&surface, &places(200), 4.0);
        worst.check(&format!("λ {choppiness}"));
        assert!(worst.compared > 130 && (worst.steep > 5 || choppiness < 3.0), "λ {choppiness}: {worst:?}");
    }
}

/// The same on tiles as a scene plans them, down to waves of a decimetre: from ripples to a storm, over a bottom, with round crests
/// and with crests that all but fold.
#[test]
fn a_query_of_a_planned_sea_is_the_direct_sum() {
    for (height_m, period_s, depth_m, choppiness) in [
        (0.1, 1.6, f64::INFINITY, 1.0),
        (0.4, 3.0, 2.0, 2.0),
        (2.5, 8.0, f64::INFINITY, 0.0),
        (2.5, 8.0, 8.0, 1.0),
        (1.5, 6.0, f64::INFINITY, 2.0),
        (1.5, 6.0, 8.0, 2.0),
        (6.0, 12.0, 20.0, 1.0),
        (14.0, 17.0, f64::INFINITY, 1.0),
    ] {
        let dispersion = crate::dispersion::Dispersion::at_depth(depth_m).unwrap();
        let spectrum = Directional::new(
            Jonswap::from_height_and_period(height_m, period_s, 3.3).unwrap(),
            DirectionalParameters {
                spread: Spread { spreading: Spreading::Hasselmann, swell: 0.0 },
                toward: DVec2::from_angle(0.4),
                dispersion,
            },
        )
        .unwrap();
        let budget = CascadeBudget { tile_size_m: None, shortest_wave_m: 0.1, cascades: 4, resolution: 128 };
        let parameters = SpectralSeaParameters {
            cascades: Cascade::plan(&[&spectrum], budget),
            choppiness,
            water: Water { dispersion, ..Water::STILL },
            seed: 11,
            amplitudes: Amplitudes::Deterministic,
        };
        let surface = SpectralSea::new(parameters, &[&spectrum]).unwrap();
        let worst = worst(&surface, &places(60), 7.0);
        worst.check(&format!("{height_m} m, {period_s} s, {depth_m} m deep, λ {choppiness}"));
        assert!(worst.compared > 45, "{worst:?}");
    }
}

fn along(point: &SurfacePoint) -> DVec2 {
    DVec2::new(point.displacement_m.x, point.displacement_m.z)
}

/// 1 + ∂D/∂x by differences of direct sums: positive definite where the surface is upright.
fn stretch(surface: &SpectralSea, rest_m: DVec2, time_s: f64) -> DMat2 {
    let step_m = 1e-4;
    let by = |axis: DVec2| {
        let at = |m: f64| along(&surface.sample(rest_m + m * axis, time_s));
        (at(step_m) - at(-step_m)) / (2.0 * step_m)
    };
    DMat2::IDENTITY + DMat2::from_cols(by(DVec2::X), by(DVec2::Y))
}

/// At any place, next to folds and beneath them, an answer is a point of the surface by direct sums, on a sheet that is
/// upright. Its height over the very place is within the bound, and where J is below a tenth, within as many times the
/// bound: the surface is a wall there.
#[test]
fn a_query_finds_upright_water_where_crests_fold() {
    let (mut next_to_folds, mut beneath_folds, mut steepest) = (0, 0, 0);
    for (choppiness, wind_speed_mps) in [(2.0, 5.0), (3.0, 8.0), (6.0, 8.0)] {
        let length = wind_speed_mps * wind_speed_mps / crate::GRAVITY_MPS2;
        let cascades = Cascade::split(&[(20.0 * length, 32), (3.0 * length, 32)]);
        let surface = choppy_sea(choppiness, cascades, wind_sea(wind_speed_mps), Water::STILL);
        let bound_m = (1e-3 * significant_height_m(surface.variance_m2())).max(1e-3);
        let time_s = 4.0;
        // Places all over, and those that water is over which all but folds, or is turned over.
        let mut asked = places(60);
        let rest_points: Vec<DVec2> = places(12_000).iter().map(|place| 0.01 * place).collect();
        for rest_m in rest_points {
            let point = surface.sample(rest_m, time_s);
            if point.jacobian < 0.25 {
                asked.push(rest_m + along(&point));
                next_to_folds += i32::from(point.jacobian > 0.0);
                beneath_folds += i32::from(point.jacobian < 0.0);
            }
        }
        let found = surface.query(&asked, time_s).unwrap();
        for (place, found) in asked.iter().zip(found) {
            let mut rest_m = place - along(&found);
            let direct = surface.sample(rest_m, time_s);
            let off = DVec3::new(rest_m.x - place.x, -found.height_m(), rest_m.y - place.y);
            let off = (direct.displacement_m + off).length();
            assert!(off < bound_m, "λ {choppiness}: {off} off the surface, of {bound_m}");
            let upright = stretch(&surface, rest_m, time_s);
            assert!(found.jacobian > 0.0 && upright.x_axis.x + upright.y_axis.y > 0.0, "{found:?}");
            assert!(upright.determinant() > -0.01, "{}", upright.determinant());
            if found.jacobian < 0.02 {
                steepest += 1;
                continue; // a wall, whose height is that of any of its points
            }
            for _ in 0..8 {
                let miss = rest_m + along(&surface.sample(rest_m, time_s)) - place;
                rest_m -= stretch(&surface, rest_m, time_s).inverse() * miss;
            }
            let direct = surface.sample(rest_m, time_s);
            assert!((rest_m + along(&direct) - place).length() < 1e-6);
            let off = (direct.height_m() - found.height_m()).abs();
            let bound_m = bound_m * (0.1 / found.jacobian).max(1.0);
            assert!(off < bound_m, "λ {choppiness}, J {}: {off} of {bound_m}", found.jacobian);
        }
    }
    assert!(next_to_folds > 100 && beneath_folds > 50, "{next_to_folds}, {beneath_folds}");
    assert!(steepest * 20 < next_to_folds + beneath_folds, "{steepest}");
}

/// The height over a place is where the water over it is, not the height over the same rest point.
#[test]
fn the_water_is_over_the_place_asked_for() {
    let spectrum = wind_sea(12.0);
    let surface = sea(vec![Cascade::whole(400.0, 64)], spectrum, Water::STILL);
    let places = places(50);
    let mut moved = 0;
    for (place, found) in places.iter().zip(surface.query(&places, 5.0).unwrap()) {
        let along = DVec2::new(found.displacement_m.x, found.displacement_m.z);
        let there = surface.sample(place - along, 5.0);
        let back = DVec2::new(there.displacement_m.x, there.displacement_m.z) - along;
        assert!(back.length() < 5e-3 || found.jacobian < 0.3, "{back}");
        moved += i32::from(along.length() > 0.2);
    }
    assert!(moved > 20, "{moved}");
}

#[test]
fn a_snapshot_serves_again_and_again() {
    let spectrum = wind_sea(9.0);
    let large = sea(vec![Cascade::whole(200.0, 32)], spectrum, Water::STILL);
    let small = sea(Cascade::split(&[(150.0, 64), (20.0, 32)]), spectrum, Water::STILL);
    let places = places(9);
    let mut snapshot = Snapshot::new(&large);
    assert!(snapshot.query(&places).unwrap().iter().all(|point| point.displacement_m == DVec3::ZERO));
    for (surface, time_s) in [(&large, 3.0), (&small, 4.0), (&large, 3.0)] {
        snapshot.take(surface, time_s).unwrap();
        assert_eq!(snapshot.time_s(), Some(time_s));
        assert_eq!(snapshot.query(&places).unwrap(), surface.query(&places, time_s).unwrap());
        // Again, from what was kept, and from another moment back to this one.
        assert_eq!(snapshot.query(&places).unwrap(), surface.query(&places, time_s).unwrap());
        assert_ne!(snapshot.query(&places).unwrap(), surface.query(&places, time_s + 1.0).unwrap());
        assert_eq!(snapshot.query(&places).unwrap(), surface.query(&places, time_s).unwrap());
    }
}

/// The same tiles, but for what they run in.
#[test]
fn a_snapshot_takes_the_current_of_its_sea() {
    let spectrum = wind_sea(9.0);
    let on =
        |current_mps| sea(vec![Cascade::whole(200.0, 32)], spectrum, Water { current_mps, ..Water::STILL });
    let (still, tide) = (on(DVec2::ZERO), on(DVec2::new(2.0, 0.0)));
    let mut snapshot = Snapshot::new(&still);
    for surface in [&still, &tide, &still] {
        snapshot.take(surface, 7.0).unwrap();
        assert_eq!(snapshot.query(&places(5)).unwrap(), surface.query(&places(5), 7.0).unwrap());
    }
}

#[test]
fn what_is_not_finite_is_refused_by_every_surface() {
    let spectrum = wind_sea(9.0);
    let spectral = sea(vec![Cascade::whole(200.0, 32)], spectrum, Water::STILL);
    let surfaces: [&dyn Surface; 2] = [&spectral, &crate::model::Calm];
    for surface in surfaces {
        let error = surface.query(&[DVec2::ZERO, DVec2::new(1.0, f64::NAN)], 0.0).unwrap_err();
        assert_eq!(error.to_string(), "place 1 is (1, NaN), but both coordinates must be finite");
        let error = surface.query(&[DVec2::ZERO], f64::INFINITY).unwrap_err();
        assert_eq!(error.to_string(), "the time is inf s, but must be finite");
        assert!(surface.query(&[], 0.0).unwrap().is_empty());
    }
}

#[test]
fn a_band_alone_is_asked_in_its_band() {
    let band = Band { from: 0.2, to: 0.5 };
    let cascade = Cascade { band, ..Cascade::whole(300.0, 128) };
    let parameters = SpectralSeaParameters {
        cascades: vec![Cascade::whole(300.0, 64), cascade],
        choppiness: 0.0,
        water: Water::STILL,
        seed: 3,
        amplitudes: Amplitudes::Deterministic,
    };
    let surface = SpectralSea::new(parameters, &[wind_sea(9.0)]).unwrap();
    let at = [DVec2::new(3.0, 4.0)];
    let point = surface.query(&at, 0.0).unwrap()[0];
    let direct: f64 = surface.tiles().iter().map(|tile| tile.sample(at[0], 0.0).height_m()).sum();
    assert!((point.height_m() - direct).abs() < 1e-3);
}
