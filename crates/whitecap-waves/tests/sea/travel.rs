//! Waves run where they should, as fast as they should, for as long as it takes.

use crate::{TILE, WIND, one_wave, wind_sea};
use glam::DVec2;
use whitecap_waves::direction::toward_from_nautical;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::model::spectral::{
    Amplitudes, Cascade, CascadeBudget, SpectralSea, SpectralSeaParameters, SpectralTileParameters, Water,
};
use whitecap_waves::model::{Surface, TileFields, WaveModel};
use whitecap_waves::spectrum::directional::{Directional, DirectionalParameters};
use whitecap_waves::spectrum::jonswap::Jonswap;
use whitecap_waves::spectrum::phillips::PhillipsParameters;
use whitecap_waves::spreading::{Spread, Spreading};
use whitecap_waves::statistics::LatticeWaves;

/// All around the compass, on the axes, the diagonals and between.
const LATTICE: [(f64, f64); 12] = [
    (5.0, 0.0),
    (4.0, 3.0),
    (4.0, 4.0),
    (3.0, 4.0),
    (0.0, 5.0),
    (-3.0, 4.0),
    (-4.0, 4.0),
    (-5.0, 0.0),
    (-4.0, -3.0),
    (0.0, -5.0),
    (2.0, -5.0),
    (4.0, -3.0),
];

/// Who runs along with a wave, c t k̂ in t seconds, sees it stand still.
#[test]
fn a_wave_travels_towards_its_wave_vector_at_its_phase_speed() {
    for (p, q) in LATTICE {
        let (wave, sea) = one_wave(p, q);
        let k = wave.k();
        let velocity = k.normalize() * Dispersion::DEEP.phase_speed(k.length());
        let start = DVec2::new(12.0, -7.0);
        let there = sea.sample(start, 0.0);
        for time_s in [0.4, -3.0, 60.0, 1e6, -1e6] {
            let moved = sea.sample(start + velocity * time_s, time_s);
            let apart = moved.displacement_m.distance(there.displacement_m);
            assert!(apart < 1e-6, "({p}, {q}) after {time_s} s: {apart} m");
        }
        // Nobody else does: half a period on, the same place has the opposite height.
        let half_period_s = std::f64::consts::PI / Dispersion::DEEP.angular_frequency(k.length());
        let later = sea.sample(start, half_period_s).displacement_m;
        assert!((later + there.displacement_m).length() < 1e-9);
    }
}

/// The water under a crest moves with the wave: its velocity and its height rise and fall together.
#[test]
fn the_water_circles_forward_over_the_crest() {
    for (p, q) in LATTICE {
        let (wave, sea) = one_wave(p, q);
        let mut together = 0.0;
        for i in 0..16 {
            let rest = DVec2::new(6.25 * f64::from(i), 3.0 * f64::from(i));
            let (before, after) =
                (sea.sample(rest, 0.999).displacement_m, sea.sample(rest, 1.001).displacement_m);
            let velocity = (after - before) / 0.002;
            together +=
                sea.sample(rest, 1.0).displacement_m.y * wave.k().dot(DVec2::new(velocity.x, velocity.z));
        }
        assert!(together > 0.0, "({p}, {q})");
    }
}

/// In a sum of waves, −E[∂h/∂t ∇h] = Σ ω k |h|²: it points where the energy goes.
#[test]
fn a_wind_sea_runs_with_the_wind() {
    for from_deg in (0..360).step_by(30) {
        let toward = toward_from_nautical(f64::from(from_deg));
        let tile = SpectralTileParameters { resolution: 32, ..TILE };
        let mut sea = wind_sea(tile, PhillipsParameters { toward, ..WIND });
        let [mut before, mut now, mut after] = [(); 3].map(|()| TileFields::default());
        let step = 0.05;
        sea.evaluate(20.0 - step, &mut before);
        sea.evaluate(20.0, &mut now);
        sea.evaluate(20.0 + step, &mut after);
        let mut flux = DVec2::ZERO;
        for i in 0..32 * 32 {
            let rate = f64::from(after.height[i] - before.height[i]);
            flux -= rate * DVec2::new(f64::from(now.slope_x[i]), f64::from(now.slope_z[i]));
        }
        let aim = flux.normalize().dot(toward);
        assert!(aim > 0.98, "from {from_deg}: {aim}");
    }
}

/// The surface of a planned sea has the spectrum's mean direction wherever that points: to rounding of the lattice where
/// no waves run against the others, and otherwise to a tenth of a degree r.m.s., to neither side.
#[test]
fn a_planned_sea_has_its_mean_direction() {
    let exponent = |exponent| Spreading::Cos2s { exponent };
    for (spreading, rms_deg) in
        [(exponent(15.0), 0.02), (Spreading::CosSquared, 0.02), (Spreading::Hasselmann, 0.13)]
    {
        let mut off_deg = Vec::new();
        for from_deg in (0..360).step_by(15) {
            let parameters = DirectionalParameters {
                spread: Spread { spreading, swell: 0.0 },
                toward: toward_from_nautical(f64::from(from_deg)),
                dispersion: Dispersion::DEEP,
            };
            let jonswap = Jonswap::from_height_and_period(2.0, 7.0, 3.3).unwrap();
            let systems = [Directional::new(jonswap, parameters).unwrap()];
            let budget =
                CascadeBudget { tile_size_m: None, shortest_wave_m: 0.1, cascades: 3, resolution: 64 };
            for seed in 0..4 {
                let sea = SpectralSeaParameters {
                    cascades: Cascade::plan(&systems, budget),
                    choppiness: 1.0,
                    water: Water::STILL,
                    seed,
                    amplitudes: Amplitudes::Deterministic,
                };
                let mut sum = DVec2::ZERO;
                for mut tile in SpectralSea::new(sea, &systems).unwrap().into_tiles() {
                    let mut fields = TileFields::default();
                    let waves = LatticeWaves::measure(&mut tile, &Water::STILL, 10.0, &mut fields);
                    sum += waves.sum(&Water::STILL).1.toward_m2;
                }
                off_deg.push(parameters.toward.angle_to(sum).to_degrees());
            }
        }
        let mean = |values: &dyn Fn(f64) -> f64| {
            off_deg.iter().map(|off| values(*off)).sum::<f64>() / off_deg.len() as f64
        };
        let (mean, rms) = (mean(&|off| off), mean(&|off| off * off).sqrt());
        assert!(rms < rms_deg, "{spreading:?}: {rms}°");
        assert!(mean.abs() < 0.3 * rms_deg, "{spreading:?}: {mean}°");
    }
}

/// A symmetric spectrum runs both ways alike and carries next to nothing on the whole.
#[test]
fn opposing_energy_turns_waves_round() {
    let flux = |opposing_energy: f64| {
        let wind = PhillipsParameters { opposing_energy, ..WIND };
        let tile = SpectralTileParameters { resolution: 32, ..TILE };
        let mut sea = wind_sea(tile, wind);
        let [mut before, mut after] = [(); 2].map(|()| TileFields::default());
        sea.evaluate(0.0, &mut before);
        sea.evaluate(0.1, &mut after);
        let rate = |i: usize| f64::from(after.height[i] - before.height[i]);
        let slope = |i: usize| f64::from(after.slope_x[i] + before.slope_x[i]);
        -(0..32 * 32).map(|i| rate(i) * slope(i)).sum::<f64>()
    };
    assert!(flux(0.0) > 0.0);
    assert!(flux(1.0).abs() < 0.25 * flux(0.0));
}
