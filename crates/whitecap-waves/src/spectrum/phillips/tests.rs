use super::*;
use crate::direction::toward_from_nautical;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

fn west_wind(wind_speed_mps: f64) -> PhillipsParameters {
    PhillipsParameters {
        wind_speed_mps,
        toward: DVec2::X,
        significant_height_m: None,
        opposing_energy: 0.0,
        small_wave_cutoff_m: 0.0,
    }
}

/// ∫∫Ψ d²k over a polar grid, logarithmic in k: the midpoint rule in the angle is exact for cos², the one in
/// ln k converges fast for this bell.
fn plane_integral(spectrum: &Phillips, length_scale_m: f64) -> f64 {
    let (steps, directions) = (4000, 64);
    let (low, high) = (1e-2 / length_scale_m, 1e4 / length_scale_m);
    let step = (high / low).ln() / f64::from(steps);
    let mut sum = 0.0;
    for i in 0..steps {
        let k = low * ((f64::from(i) + 0.5) * step).exp();
        for j in 0..directions {
            let angle = TAU * (f64::from(j) + 0.5) / f64::from(directions);
            sum += spectrum.density_m4(k * DVec2::from_angle(angle)) * k * k;
        }
    }
    sum * step * TAU / f64::from(directions)
}

#[test]
fn fully_developed_heights() {
    for (wind, height) in [(5.0, 0.5332), (10.0, 2.1330), (20.0, 8.5319)] {
        assert!((Phillips::fully_developed_height_m(wind) - height).abs() < 1e-4);
        let m0 = Phillips::new(west_wind(wind)).unwrap().variance_m2();
        assert!((4.0 * m0.sqrt() - height).abs() < 1e-4);
    }
}

/// The peak of S(ω) = Ψ k/c_g along the wind, found by search, has the period that was asked for.
#[test]
fn the_wind_of_a_peak_period() {
    for period in [3.0, 8.0, 14.0] {
        let spectrum = Phillips::new(west_wind(Phillips::wind_of_peak_period_mps(period))).unwrap();
        let density = |omega: f64| {
            let k = omega * omega / GRAVITY_MPS2;
            spectrum.density_m4(DVec2::new(k, 0.0)) * k * 2.0 * omega / GRAVITY_MPS2
        };
        let periods = (1..40_000).map(|i| f64::from(i) * 1e-3);
        let peak = periods.max_by(|a, b| density(TAU / a).total_cmp(&density(TAU / b))).unwrap();
        assert!((peak - period).abs() < 2e-3, "{peak}");
    }
}

#[test]
fn the_plane_holds_the_requested_variance() {
    for (opposing_energy, cutoff) in [(0.0, 0.0), (0.3, 0.0), (1.0, 0.0), (0.0, 0.05), (0.5, 1.0), (1.0, 9.0)]
    {
        let spectrum = Phillips::new(PhillipsParameters {
            significant_height_m: Some(3.0),
            opposing_energy,
            small_wave_cutoff_m: cutoff,
            ..west_wind(10.0)
        })
        .unwrap();
        let m0 = (3.0_f64 / 4.0).powi(2);
        assert!((spectrum.variance_m2() - m0).abs() < 1e-15);
        let integral = plane_integral(&spectrum, 100.0 / GRAVITY_MPS2);
        assert!((integral / m0 - 1.0).abs() < 1e-6, "b {opposing_energy} l {cutoff}: {integral} for {m0}");
    }
}

/// A = 2 m0/(π L²) when the spectrum is symmetric: the density at one wave number, by hand.
#[test]
fn the_symmetric_constant() {
    let length = 100.0 / GRAVITY_MPS2;
    let parameters =
        PhillipsParameters { significant_height_m: Some(4.0), opposing_energy: 1.0, ..west_wind(10.0) };
    let spectrum = Phillips::new(parameters).unwrap();
    let k = 1.0 / length;
    let expected = 2.0 / (PI * length * length) * (-1.0_f64).exp() / k.powi(4);
    for sign in [1.0, -1.0] {
        assert!((spectrum.density_m4(DVec2::new(sign * k, 0.0)) / expected - 1.0).abs() < 1e-12);
    }
}

/// K₁ from tables (Abramowitz and Stegun, table 9.8): K₁(0.2) = 4.7759725, K₁(1) = 0.60190723,
/// K₁(2) = 0.13986588.
#[test]
fn the_damping_factor_is_a_bessel_function() {
    for (x, k1) in [(0.2, 4.775_972_5), (1.0, 0.601_907_23), (2.0, 0.139_865_88)] {
        assert!((damping_factor(x / 2.0) / (x * k1) - 1.0).abs() < 1e-7);
    }
    assert_eq!(damping_factor(0.0), 1.0);
    assert!((damping_factor(1e-8) - 1.0).abs() < 1e-12);
}

#[test]
fn energy_runs_with_the_wind() {
    let toward = toward_from_nautical(250.0);
    let spectrum = |b| {
        let parameters = PhillipsParameters { toward, opposing_energy: b, ..west_wind(8.0) };
        Phillips::new(parameters).unwrap()
    };
    let (with, against, across) = (0.2 * toward, -0.2 * toward, 0.2 * toward.perp());
    let one_sided = spectrum(0.0);
    assert!(one_sided.density_m4(with) > 0.0);
    assert_eq!(one_sided.density_m4(against), 0.0);
    assert!(one_sided.density_m4(across) < 1e-30);
    let partly = spectrum(0.25);
    assert!((partly.density_m4(against) / partly.density_m4(with) - 0.25).abs() < 1e-12);
    // The angle is that between k and the wind: 60° off the wind a quarter is left.
    let oblique = one_sided.density_m4(DVec2::from_angle(PI / 3.0).rotate(with));
    assert!((oblique / one_sided.density_m4(with) - 0.25).abs() < 1e-12);
}

#[test]
fn the_cutoff_damps_short_waves() {
    let damped = Phillips::new(PhillipsParameters { small_wave_cutoff_m: 0.1, ..west_wind(10.0) }).unwrap();
    let plain = Phillips::new(west_wind(10.0)).unwrap();
    let ratio = |k: f64| damped.density_m4(DVec2::X * k) / plain.density_m4(DVec2::X * k);
    assert!((ratio(10.0) / ratio(1e-1) - (-1.0_f64 + 1e-4).exp()).abs() < 1e-12);
}

#[test]
fn ranges_are_checked() {
    let good = west_wind(10.0);
    for (field, bad) in [
        ("wind_speed_mps", PhillipsParameters { wind_speed_mps: 0.0, ..good }),
        ("wind_speed_mps", PhillipsParameters { wind_speed_mps: f64::NAN, ..good }),
        ("toward", PhillipsParameters { toward: DVec2::new(1.0, 1.0), ..good }),
        ("toward", PhillipsParameters { toward: DVec2::NAN, ..good }),
        ("significant_height_m", PhillipsParameters { significant_height_m: Some(-1.0), ..good }),
        ("opposing_energy", PhillipsParameters { opposing_energy: 1.5, ..good }),
        ("small_wave_cutoff_m", PhillipsParameters { small_wave_cutoff_m: 11.0, ..good }),
    ] {
        let error = Phillips::new(bad).unwrap_err();
        assert!(error.to_string().starts_with(field), "{error}");
    }
}

proptest! {
    #[test]
    fn never_negative_always_finite(
        wind in 0.5..60.0_f64, from_deg in 0.0..360.0_f64, b in 0.0..=1.0_f64, x in -50.0..50.0_f64, z in -50.0..50.0_f64,
    ) {
        let parameters =
            PhillipsParameters { toward: toward_from_nautical(from_deg), opposing_energy: b, ..west_wind(wind) };
        let density = Phillips::new(parameters).unwrap().density_m4(DVec2::new(x, z));
        prop_assert!(density.is_finite() && density >= 0.0);
    }
}

#[test]
fn the_density_over_wave_number_is_that_over_all_directions() {
    let spectrum = Phillips::new(PhillipsParameters {
        wind_speed_mps: 7.0,
        toward: DVec2::from_angle(0.3),
        significant_height_m: Some(1.5),
        opposing_energy: 0.4,
        small_wave_cutoff_m: 0.2,
    })
    .unwrap();
    for k in [0.1, 0.5, 4.0] {
        let directions = 3600;
        let density = |i: i32| {
            spectrum.density_m4(
                k * DVec2::from_angle(std::f64::consts::TAU * f64::from(i) / f64::from(directions)),
            )
        };
        let sum =
            (0..directions).map(density).sum::<f64>() * std::f64::consts::TAU / f64::from(directions) * k;
        assert!((spectrum.omnidirectional_m3(k) / sum - 1.0).abs() < 1e-6);
    }
}
