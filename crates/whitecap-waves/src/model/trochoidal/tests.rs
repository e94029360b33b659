use super::*;
use crate::direction::toward_from_nautical;
use crate::spectrum::directional::{Directional, DirectionalParameters};
use crate::spectrum::jonswap::Jonswap;
use crate::spreading::{Spread, Spreading};
use crate::statistics::Moments;
use proptest::prelude::*;

const PARAMETERS: TrochoidalParameters =
    TrochoidalParameters { waves: 64, choppiness: 1.0, seed: 7, dispersion: Dispersion::DEEP };

fn swell(from_deg: f64, exponent: f64) -> Directional<Jonswap> {
    let parameters = DirectionalParameters {
        spread: Spread { spreading: Spreading::Cos2s { exponent }, swell: 0.0 },
        toward: toward_from_nautical(from_deg),
        dispersion: Dispersion::DEEP,
    };
    Directional::new(Jonswap::from_height_and_period(2.0, 8.0, 3.3).unwrap(), parameters).unwrap()
}

fn sea(parameters: TrochoidalParameters) -> Trochoidal {
    Trochoidal::new(parameters, &[swell(237.0, 10.0)]).unwrap()
}

#[test]
fn energies_are_equal_and_their_sum_is_m0() {
    for waves in [1, 7, 64] {
        let sea = sea(TrochoidalParameters { waves, ..PARAMETERS });
        assert_eq!(sea.waves().len(), waves);
        let variance: f64 = sea.waves().iter().map(|wave| 0.5 * wave.amplitude_m.powi(2)).sum();
        assert!((variance - 0.25).abs() < 1e-14 && (sea.variance_m2() - 0.25).abs() < 1e-15);
        assert!(sea.waves().iter().all(|wave| wave.amplitude_m == sea.waves()[0].amplitude_m));
    }
    // Two systems add.
    let both = Trochoidal::new(PARAMETERS, &[swell(237.0, 10.0), swell(10.0, 30.0)]).unwrap();
    assert!((both.variance_m2() - 0.5).abs() < 1e-15);
}

/// The heights at many places and times have the variance too.
#[test]
fn the_surface_has_the_variance() {
    let sea = sea(PARAMETERS);
    let heights: Vec<f32> = (0..60_000)
        .map(|i| {
            let rest = DVec2::new(61.803, 138.197) * f64::from(i % 251);
            sea.sample(rest, 3.7 * f64::from(i)).displacement_m.y as f32
        })
        .collect();
    let moments = Moments::of(&heights);
    assert!((moments.variance / 0.25 - 1.0).abs() < 0.03 && moments.mean.abs() < 0.01, "{moments:?}");
}

/// Half of the energy lies below the median wave, and the directions have the mean and the spread of cos²ˢ:
/// E[cos θ] = s/(s + 1).
#[test]
fn lengths_and_directions_are_those_of_the_spectrum() {
    let spectrum = swell(237.0, 10.0);
    let sea = Trochoidal::new(PARAMETERS, &[&spectrum]).unwrap();
    let k = |i: usize| sea.waves()[i].wave_vector.length();
    assert!((1..64).all(|i| k(i) >= k(i - 1)));
    let omega = |i: usize| TAU * sea.waves()[i].frequency_hz;
    assert!((omega(0) - Dispersion::DEEP.angular_frequency(k(0))).abs() < 1e-12);
    // Below the frequency of wave i lies (i + ½)/64 of the energy, by an integral over the frequencies.
    use crate::spectrum::Omnidirectional;
    let jonswap = spectrum.omnidirectional();
    for i in [3, 20, 32, 50] {
        let step = omega(i) / 20_000.0;
        let below: f64 =
            (0..20_000).map(|j| jonswap.density_m2s((f64::from(j) + 0.5) * step)).sum::<f64>() * step;
        let share = below / jonswap.variance_m2();
        assert!((share - (i as f64 + 0.5) / 64.0).abs() < 2e-3, "{i}: {share}");
    }
    let toward = toward_from_nautical(237.0);
    let mean = sea.waves().iter().map(|wave| wave.wave_vector.normalize()).sum::<DVec2>() / 64.0;
    assert!((mean.dot(toward) - 10.0 / 11.0).abs() < 0.01, "{}", mean.dot(toward));
    assert!(mean.perp_dot(toward).abs() < 0.02);
}

/// Each wave's direction is the quantile of cos²ˢ at its fraction, (i + ½) of the golden ratio: as much of D lies to the left of it,
/// by an integral of steps a hundredth as wide as the tolerance of a twentieth of a degree.
#[test]
fn directions_are_quantiles_to_a_twentieth_of_a_degree() {
    for (from_deg, exponent) in [(237.0, 10.0), (0.0, 3.0), (90.25, 25.0), (311.6, 10.0)] {
        let sea = Trochoidal::new(PARAMETERS, &[swell(from_deg, exponent)]).unwrap();
        let density = |angle: f64| (0.5 * angle).cos().abs().powf(2.0 * exponent);
        let steps = 720_000;
        let angle = |i: i32| (f64::from(i) + 0.5) / f64::from(steps) * TAU - TAU / 2.0;
        let all: f64 = (0..steps).map(|i| density(angle(i))).sum();
        // From the first wave to the last in the order of their fractions.
        let mut waves: Vec<(f64, DVec2)> = sea
            .waves()
            .iter()
            .enumerate()
            .map(|(i, wave)| (((i as f64 + 0.5) * GOLDEN).fract(), wave.wave_vector))
            .collect();
        waves.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (mut sum, mut next) = (0.0, 0);
        for (fraction, wave_vector) in waves {
            while sum < fraction * all {
                sum += density(angle(next));
                next += 1;
            }
            let found = toward_from_nautical(from_deg).angle_to(wave_vector);
            let off_deg = (found - angle(next - 1)).to_degrees();
            assert!(off_deg.abs() < 0.05, "from {from_deg}, s = {exponent}, {fraction}: off by {off_deg}°");
        }
    }
}

/// Who runs along with a lone wave, c t k̂ in t seconds, sees it stand still; the opposite way he does not.
#[test]
fn a_crest_travels_towards_its_wave_vector() {
    let water = Dispersion::at_depth(15.0).unwrap();
    for from_deg in [0.0, 60.0, 135.0, 200.0, 285.0] {
        let parameters = TrochoidalParameters { waves: 1, dispersion: water, ..PARAMETERS };
        let sea = Trochoidal::new(parameters, &[swell(from_deg, 500.0)]).unwrap();
        let k = sea.waves()[0].wave_vector;
        assert!(k.normalize().dot(toward_from_nautical(from_deg)) > 0.99);
        let velocity = k.normalize() * water.phase_speed(k.length());
        let start = DVec2::new(12.0, -7.0);
        let there = sea.sample(start, 0.0).displacement_m;
        for time_s in [0.4, -3.0, 60.0, 1e6, -1e6] {
            let moved = sea.sample(start + velocity * time_s, time_s).displacement_m;
            assert!(moved.distance(there) < 1e-6, "from {from_deg} after {time_s} s");
        }
        let quarter_s = 0.25 / sea.waves()[0].frequency_hz;
        let met = sea.sample(start - velocity * quarter_s, quarter_s).displacement_m;
        assert!((met + there).length() < 1e-9);
    }
}

/// A lone wave in deep water: at the crest J = 1 − λka, and the water moves on a circle; over a bottom the
/// circle is coth kd times as long as high.
#[test]
fn orbits_are_circles_that_a_bottom_flattens() {
    for depth_m in [f64::INFINITY, 5.0] {
        let water = Dispersion::at_depth(depth_m).unwrap();
        let parameters = TrochoidalParameters { waves: 1, dispersion: water, ..PARAMETERS };
        let sea = Trochoidal::new(parameters, &[swell(250.0, 100.0)]).unwrap();
        let wave = sea.waves()[0];
        let ratio =
            if depth_m.is_finite() { 1.0 / (wave.wave_vector.length() * depth_m).tanh() } else { 1.0 };
        let a = wave.amplitude_m;
        for i in 0..16 {
            let point = sea.sample(DVec2::new(3.0 * f64::from(i), 9.0), 0.0);
            let shift = DVec2::new(point.displacement_m.x, point.displacement_m.z);
            let height = point.displacement_m.y;
            let circle = (shift.length() / ratio / a).powi(2) + (height / a).powi(2);
            assert!((circle - 1.0).abs() < 1e-12, "{circle}");
            let jacobian = 1.0 - ratio * wave.wave_vector.length() * height;
            assert!((point.jacobian - jacobian).abs() < 1e-12);
            assert!(shift.dot(point.slope) >= -1e-12, "water moves towards the crest");
        }
    }
}

/// The water moves as it is drawn at λ = 1, forward over the crest and on orbits that a bottom flattens; λ is of the
/// drawing alone.
#[test]
fn velocity_is_the_rate_of_displacement() {
    for depth_m in [f64::INFINITY, 5.0] {
        let dispersion = Dispersion::at_depth(depth_m).unwrap();
        let drawn = sea(TrochoidalParameters { waves: 9, dispersion, ..PARAMETERS });
        for choppiness in [0.0, 1.0, 1.7] {
            let sea = sea(TrochoidalParameters { waves: 9, dispersion, choppiness, ..PARAMETERS });
            for i in 0..8 {
                let (rest, time_s, step_s) =
                    (DVec2::new(11.0 * f64::from(i), -7.0), 1.3 * f64::from(i), 1e-3);
                let at = |time_s| drawn.sample(rest, time_s).displacement_m;
                let rate = (at(time_s + step_s) - at(time_s - step_s)) / (2.0 * step_s);
                let off = sea.sample(rest, time_s).velocity_mps.distance(rate);
                assert!(off < 1e-5, "{depth_m} m deep, λ {choppiness}: {off}");
            }
        }
    }
}

/// Seen from above the mean level is lower: the mean over rest points of height × J.
#[test]
fn the_mean_level_is_set_down() {
    for choppiness in [0.0, 0.5, 1.0] {
        let sea = sea(TrochoidalParameters { waves: 8, choppiness, ..PARAMETERS });
        let side = 500;
        let mean = (0..side * side)
            .map(|i| {
                let rest = DVec2::new(f64::from(i % side) * 17.3, f64::from(i / side) * 13.7);
                let point = sea.sample(rest, 0.0);
                point.displacement_m.y * point.jacobian
            })
            .sum::<f64>()
            / f64::from(side * side);
        assert!((mean + sea.set_down_m()).abs() < 2e-3, "{mean} and {}", sea.set_down_m());
        // λ m0 k for waves of one length: 0.25 × 0.063 at the peak, more for the shorter ones.
        assert!(sea.set_down_m() >= choppiness * 0.25 * 0.063);
    }
}

#[test]
fn the_seed_changes_phases_and_nothing_else() {
    let (one, same) = (sea(PARAMETERS), sea(PARAMETERS));
    assert_eq!(one, same);
    let other = sea(TrochoidalParameters { seed: 8, ..PARAMETERS });
    for (a, b) in one.waves().iter().zip(other.waves()) {
        assert_eq!((a.wave_vector, a.amplitude_m), (b.wave_vector, b.amplitude_m));
        assert_ne!(a.phase_turns, b.phase_turns);
    }
}

#[test]
fn what_cannot_be_is_refused_and_nothing_is_flat() {
    for waves in [0, 65] {
        assert!(Trochoidal::new(TrochoidalParameters { waves, ..PARAMETERS }, &[swell(0.0, 1.0)]).is_err());
    }
    for choppiness in [-0.1, f64::NAN, 11.0] {
        let parameters = TrochoidalParameters { choppiness, ..PARAMETERS };
        assert!(Trochoidal::new(parameters, &[swell(0.0, 1.0)]).is_err());
    }
    let flat = Trochoidal::new::<Directional<Jonswap>>(PARAMETERS, &[]).unwrap();
    let point = flat.sample(DVec2::new(3.0, 4.0), 5.0);
    assert_eq!((point.displacement_m, point.normal, point.jacobian), (DVec3::ZERO, DVec3::Y, 1.0));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// Near and a thousand kilometres away, now and eleven days off.
    #[test]
    fn normal_slope_and_jacobian_follow_from_the_position(
        x in -500.0..500.0_f64, z in -500.0..500.0_f64, far in -1..=1_i32, late in -1..=1_i32, seed in any::<u64>(),
    ) {
        let sea = sea(TrochoidalParameters { waves: 12, choppiness: 0.8, seed, ..PARAMETERS });
        let rest = DVec2::new(x + 1e6 * f64::from(far), z - 1e6 * f64::from(far));
        let time_s = 1e6 * f64::from(late) + 3.0;
        // A step that is exact at a thousand kilometres.
        let step = 1.0 / 1024.0;
        let along = |axis: DVec2| {
            let ahead = sea.sample(rest + axis * step, time_s).displacement_m;
            (ahead - sea.sample(rest - axis * step, time_s).displacement_m) / (2.0 * step)
        };
        let (along_x, along_z) = (along(DVec2::X), along(DVec2::Y));
        let point = sea.sample(rest, time_s);
        let normal = (DVec3::Z + along_z).cross(DVec3::X + along_x);
        prop_assert!((point.jacobian - normal.y).abs() < 2e-6);
        prop_assert!(point.normal.distance(normal.normalize()) < 2e-6);
        prop_assert!(point.slope.distance(DVec2::new(along_x.y, along_z.y)) < 2e-6);
    }
}
