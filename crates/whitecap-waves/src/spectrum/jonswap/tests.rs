use super::*;
use proptest::prelude::*;

/// U, F in km → χ, α, ωp, Tp, Hs by the integral, Hs by the fetch law, Tz.
#[test]
fn known_seas_of_wind_and_fetch() {
    for (wind, fetch_km, chi, alpha, omega_p, tp, height, by_law, tz) in [
        (5.0, 10.0, 3924.0, 0.01231, 2.7366, 2.296, 0.3210, 0.2554, 1.785),
        (10.0, 100.0, 9810.0, 0.01006, 1.0082, 6.232, 2.1386, 1.6154, 4.845),
        (15.0, 300.0, 13080.0, 0.00944, 0.6107, 10.289, 5.6475, 4.1970, 7.999),
    ] {
        let fetch_m = 1000.0 * fetch_km;
        let sea = Jonswap::from_wind_and_fetch(wind, fetch_m, MEAN_PEAK_ENHANCEMENT).unwrap();
        assert!((dimensionless_fetch(wind, fetch_m) - chi).abs() < 0.5);
        assert!((energy_scale(wind, fetch_m) - alpha).abs() < 1e-5);
        assert!((sea.peak_angular_frequency() - omega_p).abs() < 1e-4);
        assert!((sea.peak_period_s() - tp).abs() < 1e-3);
        assert!((sea.significant_height_m() - height).abs() < 1e-4);
        assert!((fetch_law_height_m(wind, fetch_m) - by_law).abs() < 1e-4);
        assert!((sea.zero_crossing_period_s() - tz).abs() < 1e-3);
        assert!((sea.inverse_wave_age() - wind * omega_p / 9.81).abs() < 1e-4);
    }
}

#[test]
fn the_peak_adds_so_much_energy() {
    for (gamma, factor) in [(1.0, 1.0), (2.0, 1.2456), (3.3, 1.5249), (5.0, 1.8584), (7.0, 2.2252)] {
        assert!((enhanced_variance(gamma) - factor).abs() < 1e-4, "{gamma}: {}", enhanced_variance(gamma));
    }
}

/// The formula of 1973, written out, below, at and above the peak.
#[test]
fn the_density_is_that_of_1973() {
    let (wind, fetch_m, gamma) = (12.0, 80e3, 2.5_f64);
    let sea = Jonswap::from_wind_and_fetch(wind, fetch_m, gamma).unwrap();
    let peak = 22.0 * (9.81 * 9.81 / (wind * fetch_m)).cbrt();
    for omega in [0.6 * peak, 0.95 * peak, peak, 1.08 * peak, 4.0 * peak] {
        let width: f64 = if omega <= peak { 0.07 } else { 0.09 };
        let r = (-(omega - peak).powi(2) / (2.0 * (width * peak).powi(2))).exp();
        let alpha = 0.076 * (9.81 * fetch_m / (wind * wind)).powf(-0.22);
        let expected =
            alpha * 9.81 * 9.81 / omega.powi(5) * (-1.25 * (peak / omega).powi(4)).exp() * gamma.powf(r);
        assert!((sea.density_m2s(omega) / expected - 1.0).abs() < 1e-12, "{omega}");
    }
}

/// The fetch is in metres throughout: a thousand times as much of it makes the peak ten times as slow.
#[test]
fn the_fetch_is_in_metres() {
    let short = Jonswap::from_wind_and_fetch(10.0, 1e3, 3.3).unwrap();
    let long = Jonswap::from_wind_and_fetch(10.0, 1e6, 3.3).unwrap();
    assert!((short.peak_angular_frequency() / long.peak_angular_frequency() - 10.0).abs() < 1e-12);
    let full = Jonswap::from_wind_and_fetch(10.0, fully_developed_fetch_m(10.0), 1.0).unwrap();
    assert!((full.inverse_wave_age() - FULLY_DEVELOPED_INVERSE_WAVE_AGE).abs() < 1e-12);
}

#[test]
fn without_enhancement_it_is_pierson_and_moskowitz() {
    let plain = super::super::pierson_moskowitz::PiersonMoskowitz::from_height_and_period(3.0, 9.0).unwrap();
    let sea = Jonswap::from_height_and_period(3.0, 9.0, 1.0).unwrap();
    for omega in [0.3, 0.7, 1.0, 5.0] {
        assert!((sea.density_m2s(omega) - plain.density_m2s(omega)).abs() < 1e-9);
    }
}

#[test]
fn what_no_sea_has_is_refused() {
    for (wind, fetch, gamma) in
        [(0.0, 1e5, 3.3), (10.0, 0.0, 3.3), (10.0, -1.0, 3.3), (10.0, f64::NAN, 3.3), (10.0, 1e5, 0.9)]
    {
        assert!(Jonswap::from_wind_and_fetch(wind, fetch, gamma).is_err());
    }
    for (height, period, gamma) in [(-1.0, 8.0, 3.3), (1.0, 0.0, 3.3), (1.0, 8.0, 10.1), (1.0, 8.0, f64::NAN)]
    {
        assert!(Jonswap::from_height_and_period(height, period, gamma).is_err());
    }
}

proptest! {
    #[test]
    fn the_height_asked_for_is_the_integral(
        height in 0.1..20.0_f64, period in 0.5..25.0_f64, gamma in 1.0..10.0_f64,
    ) {
        let sea = Jonswap::from_height_and_period(height, period, gamma).unwrap();
        let m0 = integral(sea.peak_angular_frequency(), |omega| sea.density_m2s(omega));
        prop_assert!((4.0 * m0.sqrt() / height - 1.0).abs() < 1e-9);
        prop_assert!((sea.significant_height_m() / height - 1.0).abs() < 1e-12);
        // The peak of the density is where it was asked for.
        let at = |ratio: f64| sea.density_m2s(ratio * std::f64::consts::TAU / period);
        prop_assert!(at(1.0) >= at(0.999) && at(1.0) >= at(1.001));
    }
}
