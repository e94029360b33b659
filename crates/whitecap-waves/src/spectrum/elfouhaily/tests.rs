use super::*;

/// U → Hs, mean square slope, of the fully developed sea.
#[test]
fn known_seas() {
    for (wind, height, slope) in [(5.0, 0.6501, 0.03359), (10.0, 2.6332, 0.06031), (20.0, 10.5017, 0.09324)] {
        let sea = Elfouhaily::from_wind(wind).unwrap();
        assert!((sea.significant_height_m() / height - 1.0).abs() < 2e-4, "{}", sea.significant_height_m());
        assert!((sea.mean_square_slope() / slope - 1.0).abs() < 3e-4, "{}", sea.mean_square_slope());
    }
}

#[test]
fn its_own_dispersion() {
    for k in [1e-3, 0.1, 10.0, 370.0, 5000.0] {
        let omega = k * phase_speed(k);
        assert!((wave_number(omega) / k - 1.0).abs() < 1e-12, "{k}");
        let step = 1e-5 * k;
        let difference =
            ((k + step) * phase_speed(k + step) - (k - step) * phase_speed(k - step)) / (2.0 * step);
        assert!((group_speed(k) / difference - 1.0).abs() < 1e-8, "{k}");
    }
    assert!((phase_speed(370.0) - 0.23).abs() < 5e-4);
}

#[test]
fn the_energy_is_the_same_over_frequencies() {
    for age in [0.84, 1.0, 2.5, 5.0] {
        let sea = Elfouhaily::from_wind_and_age(9.0, age).unwrap();
        let m0 = integral(sea.peak_angular_frequency(), |omega| sea.density_m2s(omega));
        assert!((m0 / sea.variance_m2() - 1.0).abs() < 1e-7, "{age}");
    }
}

/// The peak of a young sea by hand: γ = 1.7 + 6 log₁₀ 2 = 3.50618 (a natural logarithm would make it 5.86).
#[test]
fn the_young_peak_by_hand() {
    let (wind, age) = (10.0, 2.0_f64);
    let sea = Elfouhaily::from_wind_and_age(wind, age).unwrap();
    let k: f64 = 9.81 * 0.04;
    let peak = (-1.25_f64).exp() * 3.50618;
    let speed = (9.81 / k * (1.0 + (k / 370.0).powi(2))).sqrt();
    let friction: f64 = 0.00144_f64.sqrt() * wind;
    let short =
        0.01 * (1.0 + 3.0 * (friction / 0.23).ln()) * 0.23 * (-0.25 * (k / 370.0 - 1.0).powi(2)).exp();
    let long = 0.006 * age.sqrt() * wind / age;
    let expected = 0.5 * (long + short) / speed * peak / k.powi(3);
    assert!((sea.density_m3(k) / expected - 1.0).abs() < 1e-5, "{} {expected}", sea.density_m3(k));
}

#[test]
fn a_long_fetch_is_fully_developed_and_a_short_one_young() {
    let age = |fetch_m: f64| Elfouhaily::from_wind_and_fetch(10.0, fetch_m).unwrap().inverse_wave_age();
    assert!((age(1e8) - 0.84).abs() < 1e-3);
    assert!((age(2.2e4 * 100.0 / GRAVITY_MPS2) - 0.84 * 1.0_f64.tanh().powf(-0.75)).abs() < 1e-12);
    // Ω = 0.84 tanh((X/2.2e4)^0.4)^−0.75 at X of an eighth and of a fiftieth, by hand.
    for (share, expected) in [(0.125, 1.640_263_127), (0.02, 2.745_812_200)] {
        let found = age(share * 2.2e4 * 100.0 / GRAVITY_MPS2);
        assert!((found - expected).abs() < 1e-8, "{share}: {found}");
    }
    assert_eq!(age(1.0), 5.0);
}

#[test]
fn the_height_asked_for_is_the_integral() {
    for height in [0.05, 1.0, 2.6332, 12.0] {
        let sea = Elfouhaily::from_height(height).unwrap();
        let m0 = integral(sea.peak_wave_number, |k| sea.density_m3(k));
        assert!((4.0 * m0.sqrt() / height - 1.0).abs() < 1e-9, "{height}");
    }
    let wind =
        (FULLY_DEVELOPED * phase_speed(Elfouhaily::from_height(2.6332).unwrap().peak_wave_number)).abs();
    assert!((wind - 10.0).abs() < 1e-3, "{wind}");
    assert_eq!(Elfouhaily::from_height(0.0).unwrap().variance_m2(), 0.0);
}

#[test]
fn no_density_is_negative_or_infinite() {
    for wind in [0.1, 1.0, 2.0, 50.0] {
        let sea = Elfouhaily::from_wind(wind).unwrap();
        for exponent in -300..300 {
            let density = sea.density_m2s(10.0_f64.powi(exponent));
            assert!(density >= 0.0 && density.is_finite(), "{wind} 1e{exponent}: {density}");
        }
    }
    assert!(Elfouhaily::from_wind(0.0).is_err() && Elfouhaily::from_wind_and_age(10.0, 9.0).is_err());
}

#[test]
fn by_height_and_period() {
    for (height_m, period_s) in [(0.1, 2.0), (2.0, 8.0), (1.0, 14.0)] {
        let sea = Elfouhaily::from_height_and_period(height_m, period_s).unwrap();
        assert!((sea.significant_height_m() / height_m - 1.0).abs() < 1e-12);
        assert_eq!(sea.inverse_wave_age(), FULLY_DEVELOPED);
        let m0 = integral(sea.peak_angular_frequency(), |omega| sea.density_m2s(omega));
        assert!((m0 / sea.variance_m2() - 1.0).abs() < 1e-7, "{period_s}");
        let densest = (0..4000)
            .map(|i| std::f64::consts::TAU / period_s * (0.8 + 1e-4 * f64::from(i)))
            .max_by(|a, b| sea.density_m2s(*a).total_cmp(&sea.density_m2s(*b)));
        let found_s = std::f64::consts::TAU / densest.unwrap();
        assert!((found_s / period_s - 1.0).abs() < 1e-3, "{found_s}");
    }
    assert!(Elfouhaily::from_height_and_period(1.0, 0.0).is_err());
    assert!(Elfouhaily::from_height_and_period(-1.0, 8.0).is_err());
}
