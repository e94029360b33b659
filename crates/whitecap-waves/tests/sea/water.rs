//! What waves run in: a bottom beneath them, a current, a loop of time; and how the water itself moves.

use crate::{OneWave, TILE, WIND, wind_sea};
use glam::{DVec2, DVec3};
use whitecap_waves::dispersion::{Dispersion, doppler};
use whitecap_waves::model::spectral::{
    Amplitudes, Cascade, SpectralSea, SpectralSeaParameters, SpectralTile, SpectralTileParameters, Water,
};
use whitecap_waves::model::{Surface, TileFields, WaveModel};
use whitecap_waves::statistics::variance;

const CURRENT: DVec2 = DVec2::new(1.3, -0.6);

fn shallow() -> Dispersion {
    Dispersion::at_depth(6.0).expect("water")
}

/// One wave of 20 m by 100/3 m, half a metre high, in this water.
fn one_wave_in(water: Water, choppiness: f64) -> (DVec2, SpectralTile) {
    let wave = OneWave { tile_size_m: 100.0, lattice: DVec2::new(5.0, -3.0), variance_m2: 0.125 };
    let tile = SpectralTileParameters { tile_size_m: 100.0, resolution: 32, water, choppiness, ..TILE };
    (wave.k(), SpectralTile::new(tile, &[&wave]).expect("one wave fits"))
}

/// The crest of a wave moves at ω/k + U along k, in any water.
#[test]
fn crests_run_at_the_speed_of_their_water() {
    for (dispersion, current_mps) in [
        (Dispersion::DEEP, DVec2::ZERO),
        (shallow(), DVec2::ZERO),
        (Dispersion::DEEP, CURRENT),
        (shallow().with_surface_tension(), -CURRENT),
    ] {
        let (k, sea) = one_wave_in(Water { dispersion, current_mps, loop_s: None }, 1.0);
        let omega = doppler(dispersion.angular_frequency(k.length()), k, current_mps);
        let velocity = k / k.length_squared() * omega;
        let start = DVec2::new(3.0, -7.0);
        for time_s in [0.8, 17.0, -90.0] {
            let (then, now) = (sea.sample(start, 0.0), sea.sample(start + velocity * time_s, time_s));
            assert!((then.height_m() - now.height_m()).abs() < 1e-6, "{time_s}");
            assert!(then.slope.distance(now.slope) < 1e-6);
        }
        let still = k / k.length_squared() * dispersion.angular_frequency(k.length());
        let wrong = sea.sample(start + still * 1.7, 1.7).height_m() - sea.sample(start, 0.0).height_m();
        assert!(current_mps == DVec2::ZERO || wrong.abs() > 0.02);
    }
}

/// Over a bottom water moves farther along than up: the displacement has the factor coth kd.
#[test]
fn orbits_are_flat_over_a_bottom() {
    let reach = |dispersion| {
        let (k, mut sea) = one_wave_in(Water { dispersion, ..Water::STILL }, 1.0);
        let mut fields = TileFields::default();
        sea.evaluate(1.0, &mut fields);
        let variance = variance(&fields.displacement_x) + variance(&fields.displacement_z);
        (k.length(), variance.sqrt())
    };
    let ((k, shallow_m), (_, deep_m)) = (reach(shallow()), reach(Dispersion::DEEP));
    assert!((shallow_m / deep_m / shallow().orbit_ratio(k) - 1.0).abs() < 1e-3);
    assert!(shallow_m / deep_m > 1.02);
}

/// The water moves as its place does: velocity is the rate of change of the displacement, plus the current that
/// carries an observer's rest points past.
#[test]
fn velocity_is_the_rate_of_displacement() {
    let water = Water { dispersion: shallow(), current_mps: CURRENT, loop_s: None };
    let sea = wind_sea(SpectralTileParameters { water, resolution: 32, ..TILE }, WIND);
    let step = 1e-4;
    for (i, time_s) in [(1.0, 0.0), (2.0, 33.3), (3.0, -8e5)] {
        let rest = DVec2::new(37.0 * i, -11.0 * i * i);
        // A parcel of water rests in the frame that drifts.
        let at = |dt: f64| sea.sample(rest + CURRENT * dt, time_s + dt);
        let rate = (at(step).displacement_m - at(-step).displacement_m) / (2.0 * step);
        let expected = rate + DVec3::new(CURRENT.x, 0.0, CURRENT.y);
        let found = at(0.0).velocity_mps;
        assert!(found.distance(expected) < 2e-5 * (1.0 + expected.length()), "{found} {expected}");
    }
}

/// Choppiness bends the drawn surface, not the water.
#[test]
fn velocity_knows_no_choppiness() {
    let of = |choppiness| {
        let tile = SpectralTileParameters { choppiness, resolution: 32, ..TILE };
        wind_sea(tile, WIND).sample(DVec2::new(5.0, 6.0), 2.0).velocity_mps
    };
    assert!(of(0.0).distance(of(2.0)) < 1e-12 && of(0.0).length() > 0.1);
}

/// One wave: e^{kz} in deep water, and no way through a bottom.
#[test]
fn motion_dies_off_with_depth() {
    let wave = OneWave { tile_size_m: 100.0, lattice: DVec2::new(5.0, -3.0), variance_m2: 0.125 };
    let k = wave.k().length();
    let sea = |dispersion| {
        let parameters = SpectralSeaParameters {
            cascades: vec![Cascade::whole(100.0, 32)],
            choppiness: 1.0,
            water: Water { dispersion, ..Water::STILL },
            seed: 7,
            amplitudes: Amplitudes::Deterministic,
        };
        SpectralSea::new(parameters, &[&wave]).unwrap()
    };
    let (deep, shallow_sea, at) = (sea(Dispersion::DEEP), sea(shallow()), DVec2::new(1.0, 2.0));
    let ratio = deep.velocity_below_mps(at, 4.0, 1.0) / deep.velocity_below_mps(at, 0.0, 1.0);
    assert!((ratio - DVec3::splat((-4.0 * k).exp())).length() < 1e-9, "{ratio}");
    assert_eq!(deep.velocity_below_mps(at, 0.0, 1.0), deep.sample(at, 1.0).velocity_mps);
    let bottom = shallow_sea.velocity_below_mps(at, 6.0, 1.0);
    assert_eq!(bottom.y, 0.0);
    let surface = shallow_sea.velocity_below_mps(at, 0.0, 1.0);
    assert!((bottom.x / surface.x * (k * 6.0).cosh() - 1.0).abs() < 1e-9);
}

/// A loop ends where it began, in every field, with a current or without, and its waves still move.
#[test]
fn a_loop_closes() {
    for current_mps in [DVec2::ZERO, CURRENT] {
        let water = Water { current_mps, loop_s: Some(20.0), ..Water::STILL };
        let mut sea = wind_sea(SpectralTileParameters { water, ..TILE }, WIND);
        let [mut start, mut end, mut middle] = [(); 3].map(|()| TileFields::default());
        sea.evaluate(3.0, &mut start);
        sea.evaluate(23.0, &mut end);
        sea.evaluate(13.0, &mut middle);
        let farthest = |a: &TileFields, b: &TileFields| {
            let of = |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            of(&a.height, &b.height).max(of(&a.displacement_x, &b.displacement_x))
        };
        assert!(farthest(&start, &end) < 2e-5, "{}", farthest(&start, &end));
        assert!(farthest(&start, &middle) > 0.5);
        for p in 0..32 {
            let column = sea.column(p);
            let moves =
                column.turns_per_s.iter().enumerate().all(|(q, turns)| (p, q) == (0, 0) || *turns > 0.0);
            assert!(moves, "column {p}");
        }
    }
}

/// Frequencies move by at most half a turn in a loop.
#[test]
fn a_loop_changes_frequencies_little() {
    let loop_s = 60.0;
    let water = Water { loop_s: Some(loop_s), ..Water::STILL };
    let looped = wind_sea(SpectralTileParameters { water, ..TILE }, WIND);
    let free = wind_sea(TILE, WIND);
    for p in 1..32 {
        for (a, b) in looped.column(p).turns_per_s.iter().zip(free.column(p).turns_per_s) {
            assert!((a - b).abs() <= 0.5 / loop_s + 1e-12);
        }
    }
}
