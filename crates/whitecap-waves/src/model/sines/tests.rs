//! Laws of the surface, and the text's constants worked out by hand.

use super::*;
use std::f64::consts::{PI, TAU};

fn ocean() -> SumOfSines {
    SumOfSines::new(SumOfSinesParameters::OCEAN_WATER).unwrap()
}

fn mended() -> SumOfSines {
    SumOfSines::new(SumOfSinesParameters { taylor: Taylor::Mended, ..Default::default() }).unwrap()
}

fn close(seen: f64, expected: f64) {
    assert!((seen - expected).abs() < 1e-5, "{seen} for {expected}");
}

/// How far apart the ends of a period are: just before a whole turn, and at it.
fn jump(series: &Series) -> f64 {
    (series.sine(series.range_reduced(1.0 - 1e-12)) - series.sine(series.range_reduced(1.0))).abs()
}

#[test]
fn golden_polynomials() {
    for (f, x, s, q) in [
        (0.0, -PI, -0.081375, -0.976022),
        (0.1, -2.500708, -0.666921, -0.799052),
        (0.25, -1.539380, -1.017799, 0.031431),
        (0.5, 0.062832, 0.062792, 0.998027),
        (0.75, 1.665044, 1.018611, -0.094064),
        (0.9, 2.626371, 0.568820, -0.866097),
    ] {
        close(range_reduced(f), x);
        close(range_reduced(f - 3.0), x);
        close(taylor_sine(range_reduced(f)), s);
        close(taylor_cosine(range_reduced(f)), q);
    }
    close(range_reduced(1.0 - 1e-9), 3.267256);
}

#[test]
fn golden_vertices() {
    for (uv, time_s, height, derivatives, normal) in [
        ((0.0, 0.0), 0.0, -106.35375, (12.20028, 1.34523), (0.036576, 0.004033, 0.999323)),
        ((0.3, 0.7), 1.0, -102.12166, (-3.41076, -13.78677), (-0.010223, -0.041323, 0.999094)),
        ((2.5, 1.25), 3.7, -17.81397, (-13.35977, 11.60173), (-0.040023, 0.034756, 0.998594)),
    ] {
        let seen = ocean().at_uv(uv.into(), time_s, 0.0);
        close(seen.height, height);
        assert!(seen.derivatives.distance(derivatives.into()) < 1.5e-5, "{:?}", seen.derivatives);
        assert!(seen.normal.distance(normal.into()) < 1.5e-6, "{:?}", seen.normal);
        // T keeps the text's tilt by nx, and Bi is T × N.
        let tangent = DVec3::new(0.0, 1.0, -0.003 * seen.derivatives.x).normalize();
        assert!(seen.tangent.distance(tangent) < 1e-12);
        assert_eq!(seen.binormal, seen.tangent.cross(seen.normal));
        assert!(seen.binormal.x > 0.99, "bump x runs along u");
    }
}

#[test]
fn damping_leaves_a_plane() {
    let (full, half) = (ocean().at_uv(DVec2::ONE, 2.0, 0.0), ocean().at_uv(DVec2::ONE, 2.0, 0.5));
    close(half.height, 0.5 * full.height);
    assert!(half.derivatives.distance(0.5 * full.derivatives) < 1e-12);
    let shore = ocean().at_uv(DVec2::ONE, 2.0, 1.0);
    assert_eq!((shore.height, shore.normal, shore.tangent), (0.0, DVec3::Z, DVec3::Y));
    assert_eq!(shore.binormal, DVec3::X);
}

/// The four pairs of coefficient and factor: of those that do not fold only the text's own nearly meets itself.
#[test]
fn the_seam() {
    let printed = Taylor::Printed.series();
    let cubed = |sine_3: f64, stretch: f64| {
        let mut series = Series { stretch, ..printed };
        series.sine[1] = sine_3;
        jump(&series)
    };
    for (sine_3, stretch, expected) in [
        (-0.161_616_16, 1.02, 0.0259),
        (-1.0 / 6.0, 1.02, 0.3069),
        (-0.161_616_16, 1.0, 0.1628),
        (-1.0 / 6.0, 1.0, 0.1504),
    ] {
        let seen = cubed(sine_3, stretch);
        assert!((seen - expected).abs() < 1e-4, "({sine_3}, {stretch}): {seen}");
    }
    assert_eq!(cubed(printed.sine[1], printed.stretch), jump(&printed));
    assert!(jump(&Taylor::Mended.series()) < 1e-11);
}

/// From one phase to the next, over two periods and the seam between them, nothing mended changes by more than
/// the phase does, but for the step of the cosine (and the sine's derivative) where x is folded.
#[test]
fn mended_jumps_nowhere() {
    let series = Taylor::Mended.series();
    let step = 1e-4;
    let at = |i: i32| {
        let x = series.range_reduced(f64::from(i) * step);
        [series.sine(x), series.cosine(x), series.sine_derivative(x)]
    };
    for i in -10_000..10_000 {
        for ((here, next), jump) in at(i).into_iter().zip(at(i + 1)).zip([0.0, 5.0e-5, 1.8e-3]) {
            assert!((next - here).abs() <= TAU * step + jump + 1e-12, "{here} to {next} at {i}");
        }
    }
}

#[test]
fn the_polynomials_keep_their_bounds() {
    let worst = |error: &dyn Fn(f64) -> f64| {
        (-10_000..=10_000).map(|i| error(PI * f64::from(i) * 1e-4).abs()).fold(0.0, f64::max)
    };
    let mended = Taylor::Mended.series();
    for (seen, expected, rounding) in [
        (worst(&|x| taylor_sine(x) - x.sin()), 0.0865, 6e-5),
        (worst(&|x| taylor_cosine(x) - x.cos()), 0.0240, 6e-5),
        (worst(&|x| mended.sine(x) - x.sin()), 1.57e-4, 6e-7),
        (worst(&|x| mended.cosine(x) - x.cos()), 2.47e-5, 6e-8),
    ] {
        assert!((seen - expected).abs() < rounding, "{seen} for {expected}");
    }
    for (series, expected) in [(Taylor::Printed.series(), 1.0201), (mended, 0.9998)] {
        let sine = |i: i32| series.sine(series.range_reduced(f64::from(i) * 1e-4)).abs();
        let highest = (0..10_000).map(sine).fold(0.0, f64::max);
        assert!((highest - expected).abs() < 6e-5, "{highest}");
        let bound = series.max_sine();
        assert!(bound >= highest && bound < highest + 1e-5);
    }
}

/// Mended, the series is the sine but for its next term, y⁹/9!, and the cosine but for y¹⁰/10!, where y is how far
/// x is from the nearest half turn.
#[test]
fn mended_is_the_series_of_the_sine() {
    let series = Taylor::Mended.series();
    for i in 0..1000 {
        let phase = f64::from(i) / 1000.0;
        let x = series.range_reduced(phase);
        let y = x.abs().min(PI - x.abs());
        assert!((series.sine(x) + (TAU * phase).sin()).abs() <= y.powi(9) / 362_880.0 + 1e-12);
        assert!((series.cosine(x) + (TAU * phase).cos()).abs() <= y.powi(10) / 3_628_800.0 + 1e-12);
    }
}

/// Slopes against differences of the height, away from seams.
#[test]
fn slopes_are_derivatives_of_the_drawn_height() {
    for sea in [ocean(), mended()] {
        for (x, z, time_s) in [(3.1, 8.2, 0.7), (-40.0, 15.5, 12.3), (71.3, -2.2, 3.3)] {
            let at = |x: f64, z: f64| sea.sample(DVec2::new(x, z), time_s).displacement_m.y;
            let point = sea.sample(DVec2::new(x, z), time_s);
            let step = 1e-4;
            let slope = DVec2::new(at(x + step, z) - at(x - step, z), at(x, z + step) - at(x, z - step))
                / (2.0 * step);
            assert!(slope.distance(point.slope) < 1e-7, "{slope} {}", point.slope);
            let normal = DVec3::new(-slope.x, 1.0, -slope.y).normalize();
            assert!(normal.distance(point.normal) < 1e-7);
            assert_eq!(point.jacobian, 1.0);
        }
    }
}

/// At the default scale the text's shading normal is the true one as far as series and factor 1.02 allow; mended,
/// they are the same but for how far the sine's derivative is from the cosine.
#[test]
fn at_the_default_scale_the_slope_factor_is_true() {
    close(SumOfSinesParameters::default().uv_size_m, 20.943_951);
    // The printed one stays within a few degrees.
    for (sea, bound) in [(ocean(), 0.05), (mended(), 1.3e-4)] {
        for i in 0..200 {
            let rest = DVec2::new(7.3 * f64::from(i), -3.1 * f64::from(i));
            let (text, world) = (sea.at_uv(sea.uv(rest), 5.0, 0.0), sea.sample(rest, 5.0));
            let difference = text.normal.distance(DVec3::new(world.normal.x, world.normal.z, world.normal.y));
            assert!(difference < bound, "{difference}");
            close(0.01 * text.height, world.displacement_m.y);
        }
    }
}

/// The mean of h² over many places and times.
#[test]
fn the_variance_is_measured() {
    for sea in [ocean(), mended()] {
        let heights: Vec<f64> = (0..40_000)
            .map(|i| {
                // Steps that no period divides.
                let t = f64::from(i);
                sea.sample(DVec2::new(1.618_034 * 29.0 * t, 1.324_718 * 37.0 * t), 0.754_878 * 3.0 * t)
                    .displacement_m
                    .y
            })
            .collect();
        let mean = heights.iter().sum::<f64>() / heights.len() as f64;
        let variance = heights.iter().map(|h| (h - mean) * (h - mean)).sum::<f64>() / heights.len() as f64;
        assert!((variance / sea.variance_m2() - 1.0).abs() < 0.01, "{variance} {}", sea.variance_m2());
        assert!(heights.iter().all(|h| h.abs() <= sea.max_height_m()));
    }
    // Sines would have half the sum of the squares.
    assert!((mended().variance_m2() / (0.5 * (0.64 + 1.0 + 2.0 * 0.0025)) - 1.0).abs() < 1e-3);
}

/// The same phase far out, late, and near by: exact in whole turns.
#[test]
fn phases_keep_their_digits() {
    let near = ocean().phases(DVec2::new(0.37, 0.11), 2.5);
    // 20 uv units are whole turns of all four waves, and so are 20 s.
    let far = ocean().phases(DVec2::new(0.37 + 20.0 * 2500.0, 0.11 - 20.0 * 2500.0), 2.5 + 20.0 * 50_000.0);
    for (near, far) in near.iter().zip(far) {
        let gap = (near - far + 0.5).rem_euclid(1.0) - 0.5;
        assert!(gap.abs() < 1e-9, "{gap}");
        assert!((0.0..1.0).contains(&far));
    }
}

#[test]
fn what_is_out_of_range_is_named() {
    let base = SumOfSinesParameters::default();
    let error = |parameters| SumOfSines::new(parameters).unwrap_err().to_string();
    assert!(error(SumOfSinesParameters { uv_size_m: 0.0, ..base }).starts_with("uv_size_m is 0"));
    assert!(error(SumOfSinesParameters { unit_m: f64::NAN, ..base }).starts_with("unit_m"));
    assert!(error(SumOfSinesParameters { slope_factor: 2.0, ..base }).starts_with("slope_factor"));
    let mut waves = base.waves;
    waves[2].direction_per_uv.y = f64::INFINITY;
    assert!(error(SumOfSinesParameters { waves, ..base }).starts_with("direction_per_uv"));
}
