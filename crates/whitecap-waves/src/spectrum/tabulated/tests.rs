use super::*;
use proptest::prelude::*;

/// A table with a known formula at its points.
fn table(
    frequencies_hz: &[f64],
    toward_rad: &[f64],
    density: impl Fn(f64, f64) -> f64,
) -> TabulatedParameters {
    let density = frequencies_hz
        .iter()
        .flat_map(|&f| toward_rad.iter().map(move |&t| (f, t)))
        .map(|(f, t)| density(f, t));
    TabulatedParameters {
        density: density.collect(),
        frequencies_hz: frequencies_hz.to_vec(),
        toward_rad: toward_rad.to_vec(),
    }
}

fn uneven() -> TabulatedParameters {
    let directions = [0.3, 1.0, 1.2, 2.9, 4.0, 5.5, 6.1];
    table(&[0.04, 0.05, 0.07, 0.12, 0.2, 0.5], &directions, |f, t| {
        libm::exp(-200.0 * (f - 0.09) * (f - 0.09)) * (1.0 + libm::cos(t - 1.0))
    })
}

/// ∫∫Ψ d²k by the midpoint rule over equal steps of u = √k and of the angle, with the integrand of the plane:
/// k dk = 2u³ du.
fn integral_over_the_plane(spectrum: &Tabulated, water: &Dispersion) -> f64 {
    const RINGS: usize = 2500;
    const TURNS: usize = 720;
    let frequencies_hz = spectrum.frequencies_hz();
    let [low, high] = [frequencies_hz[0], frequencies_hz[frequencies_hz.len() - 1]]
        .map(|hz| water.wave_number(TAU * hz).sqrt());
    // A little more on both sides, where there must be nothing.
    let (low, high) = (0.9 * low, 1.1 * high);
    let du = (high - low) / RINGS as f64;
    let mut sum = 0.0;
    for ring in 0..RINGS {
        let u = low + (ring as f64 + 0.5) * du;
        for turn in 0..TURNS {
            let k = u * u * DVec2::from_angle(TAU * (turn as f64 + 0.5) / TURNS as f64);
            sum += spectrum.density_m4(k) * 2.0 * u * u * u;
        }
    }
    sum * du * TAU / TURNS as f64
}

#[test]
fn the_plane_holds_the_variance_at_every_depth() {
    for depth_m in [3.0, 30.0, f64::INFINITY] {
        let water = Dispersion::at_depth(depth_m).unwrap();
        let spectrum = Tabulated::new(uneven(), &water).unwrap();
        let integral = integral_over_the_plane(&spectrum, &water);
        assert!((integral / spectrum.variance_m2() - 1.0).abs() < 1e-3, "{depth_m}: {integral}");
    }
}

/// E = 2 m²/(Hz rad) from 0.1 to 0.3 Hz and all round: m0 = 2 · 0.2 · 2π.
#[test]
fn a_flat_table_by_hand() {
    let flat = table(&[0.1, 0.3], &[0.0, 1.0, 4.0], |_, _| 2.0);
    let spectrum = Tabulated::new(flat, &Dispersion::DEEP).unwrap();
    assert!((spectrum.variance_m2() - 0.8 * PI).abs() < 1e-12);
    // In deep water df/dk = g/(8π² f), here at 0.2 Hz, where k = (2π f)²/g = 0.16097 rad/m.
    let k = libm::pow(TAU * 0.2, 2.0) / crate::GRAVITY_MPS2;
    let expected = 2.0 * crate::GRAVITY_MPS2 / (8.0 * PI * PI * 0.2) / k;
    for toward in [-3.0, 0.0, 2.0] {
        let found = spectrum.density_m4(k * DVec2::from_angle(toward));
        assert!((found / expected - 1.0).abs() < 1e-7, "{found} {expected}");
    }
}

#[test]
fn linear_between_the_points_also_over_the_end_of_the_circle() {
    let parameters = uneven();
    let columns = parameters.toward_rad.len();
    let at = |row: usize, column: usize| parameters.density[row * columns + column];
    let spectrum = Tabulated::new(parameters.clone(), &Dispersion::DEEP).unwrap();
    let value = |f: f64, t: f64| spectrum.density_m2phzprad(f, t);
    assert!((value(0.07, 4.0) - at(2, 4)).abs() < 1e-12);
    assert!((value(0.07, 4.0 - 2.0 * TAU) - at(2, 4)).abs() < 1e-12);
    assert!((value(0.095, 1.1) - (at(2, 1) + at(2, 2) + at(3, 1) + at(3, 2)) / 4.0).abs() < 1e-12);
    // 6.1 and 0.3 + 2π are neighbours.
    let half_way = 0.5 * (6.1 + 0.3 + TAU);
    assert!((value(0.12, half_way) - 0.5 * (at(3, 6) + at(3, 0))).abs() < 1e-12);
}

/// Energy at θ travels towards (cos θ, sin θ): east, then south.
#[test]
fn the_angle_is_that_of_the_wave_vector() {
    let beam =
        table(&[0.1, 0.2], &even_directions(8), |_, t| if (t - PI / 2.0).abs() < 0.1 { 1.0 } else { 0.0 });
    let spectrum = Tabulated::new(beam, &Dispersion::DEEP).unwrap();
    let south = 0.09 * DVec2::Y;
    assert!(spectrum.density_m4(south) > 0.0);
    assert_eq!(spectrum.density_m4(-south), 0.0);
    assert_eq!(spectrum.density_m4(0.09 * DVec2::X), 0.0);
}

#[test]
fn nothing_outside_the_measured_band() {
    let spectrum = Tabulated::new(uneven(), &Dispersion::DEEP).unwrap();
    for hz in [0.0399, 0.501, 5.0] {
        let k = Dispersion::DEEP.wave_number(TAU * hz);
        assert_eq!(spectrum.density_m4(DVec2::new(k, 0.0)), 0.0, "{hz} Hz");
    }
    for k in [0.0, 1e-300, 1e300, f64::INFINITY, f64::NAN] {
        assert_eq!(spectrum.density_m4(DVec2::new(k, 0.0)), 0.0);
    }
}

#[test]
fn what_is_no_table_is_refused() {
    let refused = |change: &dyn Fn(&mut TabulatedParameters), field: &str| {
        let mut parameters = uneven();
        change(&mut parameters);
        let error = Tabulated::new(parameters, &Dispersion::DEEP).unwrap_err().to_string();
        assert!(error.starts_with(field), "{error}");
    };
    refused(&|p| p.frequencies_hz.truncate(1), "frequencies_hz is 1, but must be at least 2");
    refused(&|p| p.frequencies_hz.swap(2, 3), "frequencies_hz is 0.07");
    refused(&|p| p.frequencies_hz[1] = 0.04, "frequencies_hz is 0.04");
    refused(&|p| p.frequencies_hz[0] = 0.0, "frequencies_hz is 0");
    refused(&|p| p.frequencies_hz[5] = f64::NAN, "frequencies_hz is NaN");
    refused(&|p| p.toward_rad.truncate(2), "toward_rad is 2");
    refused(&|p| p.toward_rad[3] = p.toward_rad[0] + TAU, "toward_rad is");
    refused(&|p| p.toward_rad[3] = f64::INFINITY, "toward_rad is inf");
    refused(&|p| p.density[9] = -1e-9, "density is -0.000000001");
    refused(&|p| p.density[9] = f64::NAN, "density is NaN");
    refused(&|p| p.density.truncate(9), "density is 9");
}

/// r₁, θ₁, r₂, 2θ₂ of a distribution, by the rectangle rule, exact for a smooth periodic function.
fn moments_of(distribution: impl Fn(f64) -> f64) -> (f64, [f64; 4]) {
    const N: usize = 1 << 14;
    let mut sums = [0.0; 5];
    for i in 0..N {
        let theta = TAU * i as f64 / N as f64;
        let d = distribution(theta) * TAU / N as f64;
        assert!(d >= 0.0 && d.is_finite());
        for (sum, term) in sums.iter_mut().zip([
            1.0,
            libm::cos(theta),
            libm::sin(theta),
            libm::cos(2.0 * theta),
            libm::sin(2.0 * theta),
        ]) {
            *sum += d * term;
        }
    }
    (sums[0], [sums[1], sums[2], sums[3], sums[4]])
}

fn coefficients(moments: DirectionalMoments) -> [f64; 4] {
    let DirectionalMoments { r1, mean_toward_rad, r2, principal_toward_rad } = moments;
    let (s1, c1) = libm::sincos(mean_toward_rad);
    let (s2, c2) = libm::sincos(2.0 * principal_toward_rad);
    [r1 * c1, r1 * s1, r2 * c2, r2 * s2]
}

/// Uniform moments and one peak by hand: a peak of maximum entropy with r₂ = r₁² is Poisson's kernel.
#[test]
fn known_distributions() {
    let moments = |r1, r2| DirectionalMoments { r1, mean_toward_rad: 0.5, r2, principal_toward_rad: 0.5 };
    for method in [DirectionMethod::MaximumEntropy, DirectionMethod::LonguetHiggins] {
        let flat = moments(0.0, 0.0).distribution(method);
        assert!((flat(1.0) - 1.0 / TAU).abs() < 1e-15);
    }
    let peak = moments(0.6, 0.36).distribution(DirectionMethod::MaximumEntropy);
    assert!((peak(0.5) - (1.0 + 0.6) / (1.0 - 0.6) / TAU).abs() < 1e-12);
    // One wave: ((1 + cos)²/3)/π.
    let one = moments(1.0, 1.0).distribution(DirectionMethod::LonguetHiggins);
    assert!((one(0.5) - 4.0 / 3.0 / PI).abs() < 1e-12 && one(0.5 + PI).abs() < 1e-12);
}

#[test]
fn moments_of_cos2s() {
    for s in [0.0, 0.4, 1.0, 3.0, 25.0] {
        let shape = sampled(cos2s_distribution(s, 1.2), 720);
        let (mut c, step) = ([0.0; 4], TAU / 720.0);
        for (i, d) in shape.iter().enumerate() {
            let t = step * i as f64;
            let terms = [libm::cos(t), libm::sin(t), libm::cos(2.0 * t), libm::sin(2.0 * t)];
            c.iter_mut().zip(terms).for_each(|(sum, term)| *sum += d * term * step);
        }
        for (found, expected) in c.into_iter().zip(coefficients(DirectionalMoments::of_cos2s(s, 1.2))) {
            assert!((found - expected).abs() < 1e-4, "s = {s}: {found} {expected}");
        }
    }
}

/// Every distribution's moments lie inside, those of one beam and of two on the edge; beyond it by as much as is said.
#[test]
fn moments_that_no_distribution_has() {
    let of = |r1: f64, r2: f64, turned: f64| DirectionalMoments {
        r1,
        mean_toward_rad: 2.0,
        r2,
        principal_toward_rad: 2.0 + turned,
    };
    for s in [0.0, 0.5, 1.0, 8.0, 200.0, 1e5] {
        assert!(DirectionalMoments::of_cos2s(s, 1.0).contradiction() < 1e-12, "s = {s}");
    }
    for sharpness in [0.3, 2.0, 30.0] {
        let (all, moments) = moments_of(|theta| {
            (sharpness * (theta - 1.0).cos()).exp() + (sharpness * (theta - 2.5).cos()).exp()
        });
        let [a1, b1, a2, b2] = moments.map(|moment| moment / all);
        let moments = DirectionalMoments {
            r1: a1.hypot(b1),
            mean_toward_rad: b1.atan2(a1),
            r2: a2.hypot(b2),
            principal_toward_rad: 0.5 * b2.atan2(a2),
        };
        assert!(moments.contradiction() == 0.0, "{sharpness}");
    }
    for (moments, expected) in [
        (of(1.0, 1.0, 0.0), 0.0),
        (of(0.0, 1.0, 0.7), 0.0),
        (of(0.9, 0.1, 0.0), 0.81 - 0.1 - 0.19),
        (of(0.5, 0.6, std::f64::consts::FRAC_PI_2), 0.25 + 0.6 - 0.75),
        (of(0.0, 1.2, 0.0), 0.2),
    ] {
        assert!(
            (moments.contradiction() - expected).abs() < 1e-12,
            "{moments:?}: {}",
            moments.contradiction()
        );
    }
    for moments in [of(1.01, 1.0, 0.0), of(-0.1, 0.0, 0.0), of(f64::NAN, 0.0, 0.0), of(0.5, 0.2, f64::NAN)] {
        assert_eq!(moments.contradiction(), f64::INFINITY);
    }
}

/// Moments that no distribution has, or only an infinitely narrow one: an answer near them all the same.
#[test]
fn contradictory_moments_are_brought_together() {
    for (r1, r2, turned) in
        [(1.0, 1.0, 0.0), (0.9, 0.1, 1.5), (0.0, 1.0, 0.0), (7.0, -3.0, 0.2), (1.0, 0.0, 0.0)]
    {
        let moments = DirectionalMoments { r1, mean_toward_rad: 2.0, r2, principal_toward_rad: 2.0 + turned };
        for method in [DirectionMethod::MaximumEntropy, DirectionMethod::LonguetHiggins] {
            let cells = sampled(moments.distribution(method), 180);
            let integral = cells.iter().sum::<f64>() * TAU / 180.0;
            assert!((integral - 1.0).abs() < 1e-12 && cells.iter().all(|d| *d >= 0.0));
            if r1 > 0.5 {
                let mean: DVec2 =
                    cells.iter().zip(even_directions(180)).map(|(d, t)| *d * DVec2::from_angle(t)).sum();
                assert!((mean.to_angle() - 2.0).abs() < 5e-3, "{r1} {r2} {method:?}: {mean}");
            }
        }
    }
    let nothing = DirectionalMoments {
        r1: f64::NAN,
        mean_toward_rad: f64::NAN,
        r2: f64::NAN,
        principal_toward_rad: 0.0,
    };
    let flat = nothing.distribution(DirectionMethod::MaximumEntropy);
    assert!((flat(3.0) - 1.0 / TAU).abs() < 1e-12);
}

/// Above its limit r₁ is smoothed down to it by Poisson's kernel, which takes q off c₁ and q² off c₂: one beam, r₁ = r₂ = 1, becomes
/// that kernel itself, and what is all but one keeps its φ₂ next to nothing.
#[test]
fn a_beam_is_smoothed_to_poissons_kernel() {
    let q = DirectionalMoments::LARGEST_R1;
    for (r1, r2, c2) in [(1.0, 1.0, q * q), (0.99, 0.985, (q / 0.99).powi(2) * 0.985)] {
        let beam = DirectionalMoments { r1, mean_toward_rad: 0.7, r2, principal_toward_rad: 0.7 };
        let distribution = beam.distribution(DirectionMethod::MaximumEntropy);
        let (integral, found) = moments_of(&distribution);
        assert!((integral - 1.0).abs() < 1e-9, "{integral}");
        let kept = DirectionalMoments { r1: q, r2: c2, ..beam };
        for (found, expected) in found.into_iter().zip(coefficients(kept)) {
            assert!((found - expected).abs() < 1e-6, "r1 = {r1}: {found} {expected}");
        }
        if r1 == 1.0 {
            for theta in [0.7, 0.72, 1.0, 3.0_f64] {
                let kernel = (1.0 - q * q) / (1.0 - 2.0 * q * (theta - 0.7).cos() + q * q) / TAU;
                assert!((distribution(theta) / kernel - 1.0).abs() < 1e-9, "{theta}");
            }
        }
    }
}

proptest! {
    /// Any c₁ and φ₂ of a distribution that exists: maximum entropy has both moments, the weighted sum its
    /// shares.
    #[test]
    fn methods_keep_the_moments_they_promise(
        r1 in 0.0..0.9_f64, theta1 in -4.0..4.0_f64, phi2 in 0.0..0.85_f64, turn in -4.0..4.0_f64,
    ) {
        let c1 = DVec2::from_angle(theta1) * r1;
        let square = DVec2::from_angle(2.0 * theta1) * r1 * r1;
        let c2 = square + DVec2::from_angle(turn) * phi2 * (1.0 - r1 * r1);
        let moments = DirectionalMoments {
            r1,
            mean_toward_rad: theta1,
            r2: c2.length(),
            principal_toward_rad: 0.5 * c2.to_angle(),
        };
        let asked = [c1.x, c1.y, c2.x, c2.y];
        let (integral, found) = moments_of(moments.distribution(DirectionMethod::MaximumEntropy));
        prop_assert!((integral - 1.0).abs() < 1e-6, "{integral}");
        for (found, asked) in found.into_iter().zip(asked) {
            prop_assert!((found - asked).abs() < 1e-6, "{found} {asked}");
        }
        let (integral, found) = moments_of(moments.distribution(DirectionMethod::LonguetHiggins));
        prop_assert!((integral - 1.0).abs() < 1e-9);
        let shares = [2.0 / 3.0, 2.0 / 3.0, 1.0 / 6.0, 1.0 / 6.0];
        for ((found, asked), share) in found.into_iter().zip(asked).zip(shares) {
            prop_assert!((found - share * asked).abs() < 1e-9, "{found} {asked}");
        }
    }

    #[test]
    fn any_table_is_not_negative_and_its_directions_may_come_in_any_order(
        values in prop::collection::vec(0.0..5.0_f64, 20),
        turn in 0..5_usize, f in 0.03..0.4_f64, t in -9.0..9.0_f64,
    ) {
        let toward_rad = [0.1, 1.1, 2.6, 3.9, 5.0];
        let frequencies_hz = vec![0.05, 0.1, 0.2, 0.3];
        let spectrum = |turn: usize| {
            let turned = |row: &[f64]| [&row[turn..], &row[..turn]].concat();
            let parameters = TabulatedParameters {
                frequencies_hz: frequencies_hz.clone(),
                toward_rad: turned(&toward_rad),
                density: values.chunks(5).flat_map(turned).collect(),
            };
            Tabulated::new(parameters, &Dispersion::DEEP).unwrap()
        };
        let (plain, turned) = (spectrum(0), spectrum(turn));
        prop_assert!(plain.density_m2phzprad(f, t) >= 0.0);
        prop_assert_eq!(plain, turned);
    }
}
