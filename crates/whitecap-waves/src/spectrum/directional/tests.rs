use super::*;
use crate::direction::toward_from_nautical;
use crate::spectrum::elfouhaily::Elfouhaily;
use crate::spectrum::jonswap::Jonswap;
use crate::spectrum::pierson_moskowitz::PiersonMoskowitz;
use crate::spectrum::tma::Tma;
use crate::spreading::Spreading;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

const SPREADINGS: [Spreading; 6] = [
    Spreading::CosSquared,
    Spreading::Cos2s { exponent: 25.0 },
    Spreading::Mitsuyasu,
    Spreading::Hasselmann,
    Spreading::DonelanBanner,
    Spreading::Elfouhaily,
];

fn east(spreading: Spreading, swell: f64, dispersion: Dispersion) -> DirectionalParameters {
    DirectionalParameters { spread: Spread { spreading, swell }, toward: DVec2::X, dispersion }
}

fn jonswap() -> Jonswap {
    Jonswap::from_wind_and_fetch(12.0, 150e3, 3.3).unwrap()
}

/// Ψ by the formula, without table: S(k) D(θ)/k.
fn formula<O: Omnidirectional>(spectrum: &Directional<O>, k: DVec2) -> f64 {
    let toward = spectrum.parameters().toward;
    let theta = toward.angle_to(k);
    let density_m3 =
        spectrum.omnidirectional().wave_number_density_m3(k.length(), &spectrum.parameters().dispersion);
    density_m3 * spectrum.distribution(k.length()).density_per_rad(theta) / k.length()
}

/// ∫∫Ψ d²k on a polar grid, logarithmic in k.
fn plane_integral(spectrum: &impl WaveSpectrum, peak: f64) -> f64 {
    let (steps, directions) = (1500, 128);
    let step = 12.0 / f64::from(steps);
    let mut sum = 0.0;
    for i in 0..steps {
        let k = peak * (-3.0 + (f64::from(i) + 0.5) * step).exp();
        for j in 0..directions {
            let angle = TAU * (f64::from(j) + 0.5) / f64::from(directions);
            sum += spectrum.density_m4(k * DVec2::from_angle(angle)) * k * k;
        }
    }
    sum * step * TAU / f64::from(directions)
}

#[test]
fn the_plane_holds_the_variance_of_the_frequencies() {
    for spreading in SPREADINGS {
        for swell in [0.0, 0.6] {
            let spectrum = Directional::new(jonswap(), east(spreading, swell, Dispersion::DEEP)).unwrap();
            let share = plane_integral(&spectrum, spectrum.peak_wave_number) / spectrum.variance_m2();
            // The cos² family and the steps of the laws leave the midpoint rule a few parts in 10⁵.
            assert!((share - 1.0).abs() < 1e-4, "{spreading:?} {swell}: {share}");
        }
    }
}

#[test]
fn so_it_does_over_a_bottom_and_with_surface_tension() {
    let water = Dispersion::at_depth(12.0).unwrap();
    let tma = Tma::over(jonswap(), 12.0).unwrap();
    for dispersion in [water, water.with_surface_tension(), Dispersion::DEEP.with_surface_tension()] {
        let spectrum = Directional::new(tma, east(Spreading::Hasselmann, 0.0, dispersion)).unwrap();
        let share = plane_integral(&spectrum, spectrum.peak_wave_number) / spectrum.variance_m2();
        assert!((share - 1.0).abs() < 1e-4, "{dispersion:?}: {share}");
    }
    let sea = Elfouhaily::from_wind(10.0).unwrap();
    let spectrum = Directional::new(sea, east(Spreading::Elfouhaily, 0.0, Dispersion::DEEP)).unwrap();
    let share = plane_integral(&spectrum, spectrum.peak_wave_number) / spectrum.variance_m2();
    assert!((share - 1.0).abs() < 1e-4, "{share}");
}

/// One density by hand: a JONSWAP peak with cos²ˢ, s = 1, whose Q is 1/π: Ψ = S(ωp)/π · cos²(θ/2) · c_g/k.
#[test]
fn a_density_by_hand() {
    let sea = Jonswap::from_height_and_period(2.0, 8.0, 3.3).unwrap();
    let toward = toward_from_nautical(300.0);
    let parameters =
        DirectionalParameters { toward, ..east(Spreading::Cos2s { exponent: 1.0 }, 0.0, Dispersion::DEEP) };
    let spectrum = Directional::new(sea, parameters).unwrap();
    let omega = TAU / 8.0;
    let k = omega * omega / 9.81;
    for theta in [0.0, 0.7, -2.0, 3.1_f64] {
        let share = (0.5 * theta).cos().powi(2) / PI;
        let expected = sea.density_m2s(omega) * share * 0.5 * (9.81 / omega) / k;
        let found = spectrum.density_m4(k * toward.rotate(DVec2::from_angle(theta)));
        assert!((found / expected - 1.0).abs() < 1e-6, "{theta}: {found} {expected}");
    }
}

/// The table against the formula wherever there is energy, for the sharpest spectra. No place is the peak itself,
/// where Hasselmann's law steps and either side is right.
#[test]
fn the_table_is_the_formula() {
    let sharp = Jonswap::from_height_and_period(2.0, 11.0, 10.0).unwrap();
    let shallow = Tma::from_height_and_period(1.0, 9.0, 5.0, 6.0).unwrap();
    let boxed: [Box<dyn Omnidirectional>; 4] = [
        Box::new(sharp),
        Box::new(shallow),
        Box::new(Elfouhaily::from_wind(15.0).unwrap()),
        Box::new(PiersonMoskowitz::from_wind(7.0).unwrap()),
    ];
    for sea in boxed {
        for spreading in SPREADINGS {
            let water = Dispersion::at_depth(6.0).unwrap().with_surface_tension();
            let spectrum = Directional::new(&*sea, east(spreading, 0.3, water)).unwrap();
            let peak = formula(&spectrum, DVec2::new(spectrum.peak_wave_number, 0.0));
            for i in 0..1500 {
                let k = spectrum.peak_wave_number * (-1.3005 + 0.008 * f64::from(i)).exp();
                for theta in [0.0, 0.4, -1.2, 1.5, 2.5] {
                    let k = k * DVec2::from_angle(theta);
                    let (found, expected) = (spectrum.density_m4(k), formula(&spectrum, k));
                    let near = 1e-4 * expected + 1e-12 * peak;
                    assert!((found - expected).abs() < near, "{spreading:?} {k} {found} {expected}");
                }
            }
        }
    }
}

/// Mitsuyasu's and Hasselmann's spreads are those of the sea's own wind and fetch: r₁ = ∫S s/(s + 1) dω/m0, since cos²ˢ has s/(s + 1),
/// and the spread is √(2(1 − r₁)). Both s are written out here. By Mitsuyasu's a young sea is much broader than an old one.
#[test]
fn the_spread_is_that_of_wind_and_fetch() {
    for (wind_mps, fetch_m) in [(12.0, 20e3), (10.0, 100e3), (20.0, 500e3)] {
        let sea = Jonswap::from_wind_and_fetch(wind_mps, fetch_m, 3.3).unwrap();
        // Ω = U ωp/g = 22 χ^(−1/3).
        let inverse_age = 22.0 * (9.81 * fetch_m / (wind_mps * wind_mps)).powf(-1.0 / 3.0);
        let peak = inverse_age * 9.81 / wind_mps;
        let mitsuyasu = |x: f64| 11.5 * inverse_age.powf(-2.5) * x.powf(if x <= 1.0 { 5.0 } else { -2.5 });
        let hasselmann = |x: f64| match x <= 1.0 {
            true => 6.97 * x.powf(4.06),
            false => 9.77 * x.powf(-2.33 - 1.45 * (inverse_age - 1.17)),
        };
        let laws: [(Spreading, &dyn Fn(f64) -> f64); 2] =
            [(Spreading::Mitsuyasu, &mitsuyasu), (Spreading::Hasselmann, &hasselmann)];
        for (spreading, s) in laws {
            let (mut all, mut along) = (0.0, 0.0);
            for i in 0..40_000 {
                // Equal steps of ln ω from a third of the peak to forty times it.
                let x = (-1.1 + 4.8 * (f64::from(i) + 0.5) / 40_000.0).exp();
                let energy = sea.density_m2s(x * peak) * x;
                (all, along) = (all + energy, along + energy * s(x) / (s(x) + 1.0));
            }
            let expected_deg = (2.0 * (1.0 - along / all)).sqrt().to_degrees();
            let spectrum = Directional::new(sea, east(spreading, 0.0, Dispersion::DEEP)).unwrap();
            let (mut all, mut along) = (0.0, 0.0);
            for i in 0..1200 {
                let k = spectrum.peak_wave_number * (-2.2 + 9.6 * (f64::from(i) + 0.5) / 1200.0).exp();
                for j in 0..180 {
                    let toward = DVec2::from_angle(TAU * f64::from(j) / 180.0);
                    let energy = spectrum.density_m4(k * toward) * k * k;
                    (all, along) = (all + energy, along + energy * toward.x);
                }
            }
            let found_deg = (2.0 * (1.0 - along / all)).sqrt().to_degrees();
            let what = format!("{spreading:?}, {wind_mps} m/s, {fetch_m} m");
            assert!(
                (found_deg - expected_deg).abs() < 0.02,
                "{what}: {found_deg}° instead of {expected_deg}°"
            );
        }
    }
}

#[test]
fn beyond_the_table_the_formula_answers() {
    let spectrum = Directional::new(jonswap(), east(Spreading::Hasselmann, 0.2, Dispersion::DEEP)).unwrap();
    for exponent in -300..150 {
        let k = DVec2::new(10.0_f64.powi(exponent), 0.0);
        let found = spectrum.density_m4(k);
        assert!(found.is_finite() && found >= 0.0, "1e{exponent}: {found}");
    }
    let k = DVec2::new(2e7 * spectrum.peak_wave_number, 0.0);
    assert!((spectrum.density_m4(k) / formula(&spectrum, k) - 1.0).abs() < 1e-9);
    assert_eq!(spectrum.density_m4(DVec2::ZERO), 0.0);
}

#[test]
fn a_flat_sea_has_no_energy() {
    let flat = Jonswap::from_height_and_period(0.0, 8.0, 3.3).unwrap();
    let spectrum = Directional::new(flat, east(Spreading::Mitsuyasu, 0.5, Dispersion::DEEP)).unwrap();
    assert_eq!((spectrum.variance_m2(), spectrum.density_m4(DVec2::new(0.06, 0.0))), (0.0, 0.0));
}

#[test]
fn what_cannot_be_spread_is_refused() {
    let wide = DirectionalParameters {
        toward: DVec2::new(1.0, 1.0),
        ..east(Spreading::CosSquared, 0.0, Dispersion::DEEP)
    };
    assert!(Directional::new(jonswap(), wide).is_err());
    for (spreading, swell) in [
        (Spreading::CosSquared, -0.1),
        (Spreading::CosSquared, 1.1),
        (Spreading::CosSquared, f64::NAN),
        (Spreading::Cos2s { exponent: -1.0 }, 0.0),
        (Spreading::Cos2s { exponent: f64::NAN }, 0.0),
    ] {
        assert!(Directional::new(jonswap(), east(spreading, swell, Dispersion::DEEP)).is_err());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Waves to the left and to the right of the mean direction are alike, and none runs the wrong way more
    /// than the right one.
    #[test]
    fn symmetric_about_the_mean_direction(
        from_deg in 0.0..360.0_f64, theta in 0.0..PI, ln_ratio in -1.0..4.0_f64, law in 0..6_usize,
    ) {
        let toward = toward_from_nautical(from_deg);
        let parameters = DirectionalParameters { toward, ..east(SPREADINGS[law], 0.0, Dispersion::DEEP) };
        let spectrum = Directional::new(jonswap(), parameters).unwrap();
        let k = spectrum.peak_wave_number * ln_ratio.exp();
        let at = |angle: f64| spectrum.density_m4(k * toward.rotate(DVec2::from_angle(angle)));
        // Where cos² and cos 2θ step or vanish, rounding may fall to either side.
        prop_assume!((theta - PI / 2.0).abs() > 1e-6);
        prop_assert!((at(theta) - at(-theta)).abs() <= 1e-9 * at(0.0));
        prop_assert!(at(theta) <= at(0.0) * (1.0 + 1e-9) && at(PI - 1e-9) <= at(1e-9));
    }
}
