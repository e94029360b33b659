//! A sea that is sewn from patches is the same sea, and does not repeat.

use crate::WIND;
use glam::DVec2;
use whitecap_waves::model::Surface;
use whitecap_waves::model::spectral::{
    Amplitudes, Cascade, CascadeBudget, SpectralSea, SpectralSeaParameters, Water,
};
use whitecap_waves::query::Snapshot;
use whitecap_waves::spectrum::phillips::Phillips;

const TIME_S: f64 = 40.0;

fn sea() -> SpectralSea {
    let systems = [Phillips::new(WIND).expect("a spectrum within its ranges")];
    let budget = CascadeBudget { tile_size_m: None, shortest_wave_m: 1.5, cascades: 3, resolution: 64 };
    let parameters = SpectralSeaParameters {
        cascades: Cascade::plan(&systems, budget),
        choppiness: 1.0,
        water: Water::STILL,
        seed: 11,
        amplitudes: Amplitudes::Deterministic,
    };
    SpectralSea::new(parameters, &systems).expect("a sea that fits")
}

fn places(count: u32) -> impl Iterator<Item = DVec2> {
    (0..count).map(|i| {
        let i = f64::from(i);
        2e4 * DVec2::new((0.754_877_666 * i).fract() - 0.5, (0.569_840_291 * i).fract() - 0.5)
    })
}

/// Heights over many rest points, and those a lag away: the share that they have in common.
fn alike(sea: &SpectralSea, lag_m: DVec2) -> f64 {
    let (mut both, mut squares) = (0.0, 0.0);
    for place in places(3000) {
        let height = |rest_m| sea.sample(rest_m, TIME_S).displacement_m.y;
        let (here, there) = (height(place), height(place + lag_m));
        both += here * there;
        squares += 0.5 * (here * here + there * there);
    }
    both / squares
}

/// Without patches all of the longest tile is there again, and most of the sea's energy with it.
#[test]
fn nothing_lies_a_tile_further_again() {
    let sea = sea();
    let size_m = sea.parameters().cascades[0].tile_size_m;
    let lags = [(1.0, 0.0), (0.0, 1.0), (1.0, -1.0), (5.0, 3.0)].map(|(x, z)| size_m * DVec2::new(x, z));
    for lag_m in lags {
        assert!(alike(&sea, lag_m) > 0.5);
    }
    let sea = sea.sewn(2);
    for lag_m in lags {
        let share = alike(&sea, lag_m);
        assert!(share.abs() < 0.06, "{share} at {lag_m}");
    }
}

/// Height, slope and velocity have the mean squares that they have without.
#[test]
fn the_statistics_stay() {
    let squares = |sea: &SpectralSea| {
        let mut sums = [0.0; 3];
        for place in places(6000) {
            let point = sea.sample(place, TIME_S);
            sums[0] += point.displacement_m.y.powi(2);
            sums[1] += point.slope.length_squared();
            sums[2] += point.velocity_mps.length_squared();
        }
        sums.map(|sum| sum / 6000.0)
    };
    let expected = squares(&sea());
    for (found, expected) in squares(&sea().sewn(2)).into_iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 0.04, "{found} instead of {expected}");
    }
}

/// What a snapshot answers is the direct sum, and slopes are those of the heights, seams included.
#[test]
fn queries_and_slopes_are_those_of_the_sewn_sea() {
    let sea = sea().sewn(2);
    let mut snapshot = Snapshot::new(&sea);
    snapshot.take(&sea, TIME_S).expect("a moment");
    let bound_m = (1e-3 * 4.0 * sea.variance_m2().sqrt()).max(1e-3);
    for rest_m in places(300) {
        let point = sea.sample(rest_m, TIME_S);
        if point.jacobian > 0.3 {
            let place_m = rest_m + DVec2::new(point.displacement_m.x, point.displacement_m.z);
            let answer = snapshot.query(&[place_m]).expect("a place")[0];
            let miss_m = (answer.displacement_m - point.displacement_m).length();
            assert!(miss_m < 2.0 * bound_m, "{miss_m} at {rest_m}");
            assert!((answer.velocity_mps - point.velocity_mps).length() < 0.02);
        }
        let step_m = 1e-3;
        for (along, slope) in [(DVec2::X, point.slope.x), (DVec2::Y, point.slope.y)] {
            let height = |by_m: f64| sea.sample(rest_m + by_m * along, TIME_S).displacement_m.y;
            let rise = (height(step_m) - height(-step_m)) / (2.0 * step_m);
            assert!((rise - slope).abs() < 1e-5, "{rise} instead of {slope} at {rest_m}");
        }
    }
    // A sea that repeats is another one.
    let plain = self::sea();
    snapshot.take(&plain, TIME_S).expect("a moment");
    let place = [DVec2::new(3.0, 4.0)];
    assert_eq!(snapshot.query(&place).expect("a place"), plain.query(&place, TIME_S).expect("a place"),);
}
