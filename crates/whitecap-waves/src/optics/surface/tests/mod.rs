mod reference;

use super::*;
use crate::optics::fresnel_exact;
use reference::*;
use std::f64::consts::PI;

const ANGLES_DEG: [f64; 13] = [0.0, 20.0, 45.0, 60.0, 70.0, 75.0, 80.0, 83.0, 86.0, 88.0, 89.0, 89.9, 90.0];
const DEVIATIONS: [f64; 7] = [0.0001, 0.01, 0.04, 0.1, 0.17, 0.25, 0.35];

#[test]
fn hidden_projections_by_erfc() {
    for i in 0..=900 {
        let z = f64::from(i) / 100.0;
        let density = (-0.5 * z * z).exp() / (2.0 * PI).sqrt();
        let exact = density - z * 0.5 * libm::erfc(z / 2.0_f64.sqrt());
        assert!((hidden_projection(z) - exact).abs() < 3.2e-5, "{z}");
    }
}

/// Bruneton's Λ.
#[test]
fn the_share_let_pass_is_that_of_correlated_heights() {
    let lambda = |z: f64| {
        let a = z / 2.0_f64.sqrt();
        let root = a * PI.sqrt();
        ((-a * a).exp() - root * libm::erfc(a)) / (2.0 * root)
    };
    for eye in [0.1, 0.5, 1.0, 2.0] {
        for light in [0.1, 0.4, 1.3, 3.0] {
            let seen = 1.0 / (1.0 + lambda(eye));
            let expected = (1.0 + lambda(eye)) / (1.0 + lambda(eye) + lambda(light));
            assert!((shown_share(0.2 * light, 0.2, seen) - expected).abs() < 2e-4);
        }
    }
    assert_eq!(shown_share(0.0, 0.1, 0.5), 0.0);
    assert_eq!(shown_share(-0.2, 0.1, 0.5), 0.0);
    assert_eq!(shown_share(0.3, 0.0, 1.0), 1.0);
}

/// What is seen of a sea of which a pixel resolves nothing but what all of it leans by.
fn whole_sea(slopes: &Slopes, toward_eye: DVec3, n: f64) -> VisibleFacets {
    let (c, m) = (slopes.covariance, slopes.mean);
    let sea = SlopeCovariance { xx: c.xx + m.x * m.x, xz: c.xz + m.x * m.y, zz: c.zz + m.y * m.y };
    visible_facets(slopes, sea, toward_eye, n)
}

/// Seas to try: alike in all directions, long-crested in any direction, and tilted.
fn seas() -> Vec<Slopes> {
    let mut seas: Vec<Slopes> = DEVIATIONS.map(isotropic).to_vec();
    seas.push(slopes(0.02, 0.0, 0.005, DVec2::ZERO));
    seas.push(slopes(0.02, 0.012, 0.01, DVec2::ZERO));
    seas.push(slopes(0.006, -0.004, 0.02, DVec2::new(0.1, -0.05)));
    seas.push(slopes(0.003, 0.001, 0.002, DVec2::new(-0.15, 0.2)));
    seas
}

#[test]
fn mean_fresnel_and_normal_are_those_of_what_is_seen() {
    let (mut worst, mut worst_slope) = (0.0_f64, 0.0_f64);
    for slopes in seas() {
        for degrees in ANGLES_DEG {
            let facets = whole_sea(&slopes, eye(degrees), N);
            // A sea that faces away as a whole is turned to the eye; what is seen there is another question.
            if facets.mean_slope.distance(slopes.mean) > 1e-12 {
                continue;
            }
            let (fresnel, _, slope) = visible_means(&slopes, eye(degrees));
            let error = (facets.mean_fresnel - fresnel).abs();
            assert!(error < 0.003, "{degrees} {slopes:?}: {} for {fresnel}", facets.mean_fresnel);
            let seen = -DVec2::new(facets.normal.x, facets.normal.z) / facets.normal.y;
            worst = worst.max(error);
            worst_slope = worst_slope.max(seen.distance(slope));
        }
    }
    println!("mean Fresnel is off by {worst:.5}, the slope that is seen by {worst_slope:.5}");
    assert!(worst_slope < 0.004, "{worst_slope}");
}

#[test]
fn calm_water_is_a_mirror() {
    for degrees in [0.0, 30.0, 60.0, 80.0, 89.0] {
        let eye = eye(degrees);
        let flat = isotropic(0.0);
        let facets = whole_sea(&flat, eye, N);
        assert!((facets.mean_fresnel - fresnel_exact(eye.y, N)).abs() < 1e-6);
        let reflection = sea_reflection(&facets, eye, N);
        let mirrored = DVec3::new(-eye.x, eye.y, -eye.z);
        for tap in reflection.taps {
            assert!(tap.toward.distance(mirrored) < 2e-4, "{degrees}: {tap:?}");
        }
        assert!((1.0 - reflection.water_weight - facets.mean_fresnel).abs() < 1e-4);
    }
    let sixty = whole_sea(&isotropic(0.0), eye(60.0), N).mean_fresnel;
    assert!((sixty - 0.061_00).abs() < 6e-6);
}

/// Whatever the slopes, the taps are unit vectors over the horizon, and all weights are shares of one.
#[test]
fn taps_stay_above_the_horizon_and_weights_are_shares() {
    let mut all = seas();
    all.push(slopes(0.01, 0.0, 0.01, DVec2::new(0.9, 0.7)));
    all.push(slopes(1e-9, 0.0, 1e-9, DVec2::new(-0.9, -0.3)));
    for slopes in all {
        for degrees in ANGLES_DEG.into_iter().chain([95.0, 120.0]) {
            let facets = whole_sea(&slopes, eye(degrees), N);
            let reflection = sea_reflection(&facets, eye(degrees), N);
            let mut sum = reflection.water_weight;
            assert!((0.0..=1.0).contains(&reflection.water_weight));
            for tap in reflection.taps {
                assert!((0.0..=1.0).contains(&tap.weight), "{tap:?}");
                assert!((tap.toward.length() - 1.0).abs() < 1e-9 && tap.toward.y >= 0.0, "{tap:?}");
                assert!(tap.spread_along_rad.is_finite() && tap.spread_across_rad.is_finite());
                sum += tap.weight;
            }
            assert!((sum - 1.0).abs() < 1e-12);
        }
    }
}

/// The weights against a walk with any number of reflections: no light is lost but to the water.
#[test]
fn weights_are_those_of_many_reflections() {
    let mut worst = 0.0_f64;
    for slopes in [isotropic(0.04), isotropic(0.15), isotropic(0.35), slopes(0.02, 0.012, 0.01, DVec2::ZERO)]
    {
        for degrees in [30.0, 60.0, 75.0, 80.0, 84.0, 87.0, 89.0, 89.9] {
            let facets = whole_sea(&slopes, eye(degrees), N);
            let reflection = sea_reflection(&facets, eye(degrees), N);
            let (_, single, _) = visible_means(&slopes, eye(degrees));
            let seen = 1.0 - reflection.water_weight;
            let expected = walked(&slopes, eye(degrees), 30_000, |_| 1.0);
            let error = (seen - expected).abs();
            let bound = if slopes.covariance.xx < 0.025 { 0.007 } else { 0.009 };
            assert!(error < bound, "{degrees} {slopes:?}: {seen} for {expected}");
            assert!(expected > single - 0.003 && expected < facets.mean_fresnel + 0.005);
            worst = worst.max(error);
        }
    }
    println!("the reflected share is off by {worst:.4}");
}

/// A sky as seen through the taps, blurred as they say, against the walk.
#[test]
fn a_sky_in_the_taps_is_the_sky_in_the_waves() {
    // Bright at the horizon, with a slant in azimuth.
    let sky = |l: DVec3| 0.25 + 0.75 * (-6.0 * l.y).exp() + 0.2 * l.x;
    let mut worst = 0.0_f64;
    for slopes in [isotropic(0.04), isotropic(0.15), isotropic(0.25), slopes(0.02, 0.012, 0.01, DVec2::ZERO)]
    {
        for degrees in [30.0, 60.0, 75.0, 80.0, 84.0, 87.0, 89.0, 89.9] {
            let facets = whole_sea(&slopes, eye(degrees), N);
            let reflection = sea_reflection(&facets, eye(degrees), N);
            let mut seen = 0.0;
            for tap in reflection.taps {
                for step in [-1.0_f64, 1.0] {
                    let elevation = tap.toward.y.asin() + step * tap.spread_along_rad;
                    let horizontal = DVec2::new(tap.toward.x, tap.toward.z).normalize_or_zero();
                    let (y, length) = elevation.abs().sin_cos();
                    let at = DVec3::new(horizontal.x * length, y, horizontal.y * length);
                    seen += 0.5 * tap.weight * sky(at);
                }
            }
            let expected = walked(&slopes, eye(degrees), 30_000, sky);
            let error = (seen / expected - 1.0).abs();
            assert!(error < 0.10, "{degrees} {slopes:?}: {seen} for {expected}");
            worst = worst.max(error);
        }
    }
    println!("the reflected sky is off by {worst:.4} of itself");
}

/// The integral of the glitter over all suns, for one eye.
fn all_suns(slopes: &Slopes, toward_eye: DVec3) -> f64 {
    let facets = whole_sea(slopes, toward_eye, N);
    let mut sum = 0.0;
    // A solid angle of suns is 4 cos i H_y³ times an area of slopes; `over_slopes` shares out that area by p.
    let c = slopes.covariance;
    let determinant = c.xx * c.zz - c.xz * c.xz;
    over_slopes(slopes, |zeta, share| {
        let half = facet(zeta).normalize();
        let cos = toward_eye.dot(half);
        if cos <= 0.0 {
            return;
        }
        let d = zeta - slopes.mean;
        let squares = (c.zz * d.x * d.x - 2.0 * c.xz * d.x * d.y + c.xx * d.y * d.y) / determinant;
        let area = share * (0.5 * squares).exp() * 2.0 * PI * determinant.sqrt();
        let sun = 2.0 * cos * half - toward_eye;
        sum += sun_glitter(slopes, &facets, toward_eye, sun, 1e-5, N) * 4.0 * cos * half.y.powi(3) * area;
    });
    sum
}

/// A glitter for every sun adds up to what escapes in one reflection, which away from grazing is all.
#[test]
fn glitter_over_all_suns_is_the_mean_fresnel() {
    for slopes in [isotropic(0.02), isotropic(0.15), isotropic(0.3), slopes(0.02, 0.012, 0.01, DVec2::ZERO)] {
        for degrees in [0.0, 30.0, 60.0, 70.0, 80.0, 85.0, 88.0] {
            let facets = whole_sea(&slopes, eye(degrees), N);
            let (_, single, _) = visible_means(&slopes, eye(degrees));
            let sum = all_suns(&slopes, eye(degrees));
            assert!((sum / single - 1.0).abs() < 0.01, "{degrees} {slopes:?}: {sum} for {single}");
            if degrees <= 30.0 && slopes.covariance.xx < 0.03 {
                assert!((sum / facets.mean_fresnel - 1.0).abs() < 0.02, "{degrees} {slopes:?}");
            }
        }
    }
}

/// The brightest place of the glitter gives the slope back that it was made with.
#[test]
fn slopes_are_read_back_from_the_glitter() {
    let mean = DVec2::new(0.12, -0.07);
    let slopes = slopes(4e-4, 1e-4, 3e-4, mean);
    let eye = eye(40.0);
    let facets = whole_sea(&slopes, eye, N);
    let (mut best, mut found) = (0.0, DVec2::ZERO);
    for i in -100..=100 {
        for j in -100..=100 {
            let zeta = DVec2::new(0.002 * f64::from(i), 0.002 * f64::from(j));
            let half = facet(zeta).normalize();
            let sun = 2.0 * eye.dot(half) * half - eye;
            let light = sun_glitter(&slopes, &facets, eye, sun, 0.0047, N);
            if light > best {
                (best, found) = (light, zeta);
            }
        }
    }
    assert!(found.distance(mean) < 0.004, "{found}");
}

/// A mirror shows the whole sun, F times its light, and no more than twice its radiance.
#[test]
fn a_mirror_shows_a_disc() {
    let radius = 0.00465;
    for degrees in [0.0, 40.0, 75.0, 86.0] {
        let eye = eye(degrees);
        let flat = isotropic(0.0);
        let facets = whole_sea(&flat, eye, N);
        let mirrored = DVec3::new(-eye.x, eye.y, -eye.z);
        let fresnel = fresnel_exact(eye.y, N);
        let peak = sun_glitter(&flat, &facets, eye, mirrored, radius, N);
        assert!((peak * PI * radius * radius / (2.0 * fresnel) - 1.0).abs() < 1e-3, "{degrees}: {peak}");
        let up = DVec3::Z.cross(mirrored).normalize();
        let (mut sum, step) = (0.0, radius / 12.0);
        for i in -60..=60 {
            for j in -60..=60 {
                let sun = mirrored + step * (f64::from(i) * up + f64::from(j) * mirrored.cross(up));
                sum += sun_glitter(&flat, &facets, eye, sun.normalize(), radius, N) * step * step;
            }
        }
        assert!((sum / fresnel - 1.0).abs() < 0.02, "{degrees}: {sum} for {fresnel}");
    }
}

/// However low the sun and the eye: beside the sun's path there is no glitter, although the half-way vector is level there and
/// its slope changes without bound over the disc.
#[test]
fn a_sun_at_the_horizon_does_not_light_all_of_it() {
    let at = |elevation_deg: f64, azimuth_deg: f64| {
        let (height, along) = elevation_deg.to_radians().sin_cos();
        let (z, x) = azimuth_deg.to_radians().sin_cos();
        DVec3::new(along * x, height, along * z)
    };
    for slopes in [isotropic(0.0), isotropic(0.03), isotropic(0.1), isotropic(0.15)] {
        for eye_deg in [0.003, 0.03, 0.1, 0.5, 2.0] {
            for sun_deg in [0.01, 0.05, 0.1, 0.3, 0.5, 1.0, 2.0] {
                for aside_deg in [20.0, 30.0, 45.0, 60.0, 90.0, 150.0, 179.0] {
                    let eye = at(eye_deg, 0.0);
                    let facets = whole_sea(&slopes, eye, N);
                    let light =
                        sun_glitter(&slopes, &facets, eye, at(sun_deg, 180.0 - aside_deg), 0.00465, N);
                    assert!(light < 1e-6, "{slopes:?} {eye_deg} {sun_deg} {aside_deg}: {light}");
                }
            }
        }
    }
}

#[test]
fn the_sun_does_not_shine_through_waves() {
    let slopes = isotropic(0.1);
    let facets = whole_sea(&slopes, eye(80.0), N);
    let below = DVec3::new(-0.8, -0.05, -0.6).normalize();
    assert_eq!(sun_glitter(&slopes, &facets, eye(80.0), below, 0.0047, N), 0.0);
}
