use super::*;
use std::f64::consts::{PI, TAU};

fn sun_at(elevation_deg: f64) -> DVec3 {
    let (s, c) = elevation_deg.to_radians().sin_cos();
    DVec3::new(c, s, 0.0)
}

fn toward(azimuth_deg: f64, elevation_deg: f64) -> DVec3 {
    let ((sa, ca), (se, ce)) = (azimuth_deg.to_radians().sin_cos(), elevation_deg.to_radians().sin_cos());
    DVec3::new(ce * ca, se, ce * sa)
}

/// The largest error of a channel as a share of the brightest, or of `floor` where all are darker than that.
fn error_of(found: DVec3, expected: DVec3, floor: f64) -> f64 {
    (found - expected).abs().max_element() / expected.max_element().max(floor)
}

/// Luminance of a moonless night sky, 2 · 10⁻⁴ cd/m², over the sun's illuminance: the light of stars and of the upper air,
/// which is left out, hides what is darker.
const NIGHT: f64 = 1.6e-9;

fn worst(found: DVec3, expected: DVec3) -> f64 {
    (found / expected - 1.0).abs().max_element()
}

#[test]
fn phase_functions_scatter_all_light_once() {
    for phase in [rayleigh_phase as fn(f64) -> f64, mie_phase] {
        let n = 20_000;
        let sum: f64 = (0..n).map(|i| phase(-1.0 + 2.0 * (f64::from(i) + 0.5) / f64::from(n))).sum();
        assert!((sum * 2.0 / f64::from(n) * TAU - 1.0).abs() < 1e-6);
    }
}

#[test]
fn the_table_of_transmittance_agrees_with_marching() {
    for haze in [0.0, 1.0, 10.0, 20.0] {
        let air = Transmittance::new(haze);
        let mut most = 0.0_f64;
        for height_km in [0.0, 0.003, 0.05, 0.4, 1.7, 9.0, 31.0, 59.0, 85.0] {
            for i in 0..60 {
                let part = (f64::from(i) / 59.0).powi(3);
                let mu = horizon_mu(height_km) * (1.0 - part) + part;
                let direct = transmittance::tests::march(height_km, mu, haze);
                most = most.max(error_of(air.to_top(height_km, mu), direct, 1e-3));
            }
        }
        println!("transmittance, haze {haze}: {most:.4}");
        assert!(most < 0.01, "haze {haze}: {most}");
    }
}

/// What Ψ can add to the sky from a height on is less than Ψ by this factor: the depth of a level ray through the air above.
fn depth_above(height_km: f64) -> f64 {
    (18.7 * (-height_km / 8.0).exp()).min(1.0)
}

/// Of an integral with twice the rays, which are twice as finely divided.
#[test]
fn the_table_of_multiple_scattering_agrees_with_integrating() {
    // In dusk the lowest metres of thick haze, and the last of the light, are a little off.
    for (haze, bounds) in [(1.0, [0.01, 0.01, 0.012]), (5.0, [0.01, 0.02, 0.015])] {
        let air = Atmosphere::new(haze);
        let ranges_deg = [(0.0, 90.0), (-6.0, 0.0), (-10.0, -6.0)];
        for ((lowest_deg, highest_deg), bound) in ranges_deg.into_iter().zip(bounds) {
            let mut most = 0.0_f64;
            for height_km in [0.01, 0.7, 3.3, 8.3, 12.1, 20.0, 32.0, 47.0] {
                let fine = Steps { longest: 1.5, fewest: 16.0 };
                let mus: Vec<f64> = (0..20)
                    .map(|i| lowest_deg + (highest_deg - lowest_deg) * f64::from(i) / 19.0)
                    .map(|elevation_deg: f64| elevation_deg.to_radians().sin())
                    .collect();
                let suns: Vec<_> = mus.iter().map(|mu_s| multiple::Sun::new(*mu_s, 28)).collect();
                let direct = multiple::light(&air.transmittance, height_km, &suns, 40, fine);
                let row = multiple::row(&air.multiple, height_km);
                for (mu_s, direct) in mus.iter().zip(direct) {
                    let found = multiple::sample_row(&air.multiple, row, *mu_s);
                    most = most.max(error_of(found, direct, NIGHT / depth_above(height_km)));
                }
            }
            println!("multiple scattering, haze {haze}, sun from {lowest_deg}°: {most:.4}");
            assert!(most < bound, "{most}");
        }
    }
}

#[test]
fn rays_agree_with_finer_steps() {
    let fine = Steps { longest: 0.02, fewest: 700.0 };
    let air = Atmosphere::new(1.0);
    for elevation_deg in [90.0, 40.0, 4.0, 0.0, -1.0, -2.0, -3.0, -6.0, -10.0] {
        let (sun, mut most) = (sun_at(elevation_deg), 0.0_f64);
        for eye_m in EYES_M {
            for (azimuth_deg, elevation_deg) in directions() {
                let d = toward(azimuth_deg, elevation_deg);
                let height_km = eye_km(eye_m);
                let ray = Ray::whole(height_km, d.y, d.y < horizon_mu(height_km));
                let nu = d.dot(sun);
                let path = Path::new(&air, &ray, ray.shadow(sun.y, nu), fine);
                let direct = path.light(&air, &ray, sun.y, nu);
                most = most.max(error_of(air.radiance(eye_m, d, sun), direct, NIGHT));
            }
        }
        println!("rays, sun at {elevation_deg}°: {most:.4}");
        assert!(most < 0.01, "{most}");
    }
}

const EYES_M: [f64; 4] = [1.0, 300.0, 12e3, 60e3];

fn directions() -> impl Iterator<Item = (f64, f64)> {
    let elevations = [-80.0, -30.0, -5.0, -1.0, 0.0, 0.3, 3.0, 20.0, 85.0];
    elevations.into_iter().flat_map(|e| [0.0, 20.0, 50.0, 180.0].map(|azimuth| (azimuth, e)))
}

/// Below the horizon it is what air, less than a kilometre of it from low down, adds to the sea: see [`Sky`].
#[test]
fn the_sky_agrees_with_its_rays() {
    let air = Atmosphere::new(1.0);
    for elevation_deg in [62.0, 30.0, 6.0, 1.0, 0.0, -3.0, -6.0, -10.0] {
        let (mut above, mut below) = (0.0_f64, 0.0_f64);
        for eye_m in EYES_M {
            let sky = Sky::new(&air, eye_m, sun_at(elevation_deg));
            for (azimuth_deg, i) in
                [0.0, 3.0, 17.0, 50.0, 180.0].into_iter().flat_map(|a| (0..90).map(move |i| (a, i)))
            {
                let d = toward(azimuth_deg, -89.7 + 2.0 * f64::from(i));
                let error = error_of(sky.radiance(d), air.radiance(eye_m, d, sun_at(elevation_deg)), NIGHT);
                let side = if d.y < horizon_mu(eye_km(eye_m)) { &mut below } else { &mut above };
                *side = side.max(error);
            }
        }
        println!("sky, sun at {elevation_deg}°: {above:.4} above the horizon, {below:.4} below");
        assert!(above < 0.01 && below < 0.02, "{above} {below}");
    }
}

#[test]
fn noon_is_blue_and_sunset_is_red() {
    let air = Atmosphere::new(1.0);
    let noon = air.radiance(2.0, toward(180.0, 53.0), sun_at(60.0));
    assert!(noon.z > 1.8 * noon.x, "{noon}");
    let evening = air.radiance(2.0, toward(0.0, 1.7), sun_at(1.0));
    assert!(evening.x > 1.5 * evening.z, "{evening}");
    let disc = air.sun_transmittance(2.0, 1.0_f64.to_radians().sin());
    assert!(disc.x > 3.0 * disc.z, "{disc}");
    // Once the sun has gone ozone keeps the zenith blue.
    let dusk = air.radiance(2.0, DVec3::Y, sun_at(-4.0));
    assert!(dusk.z > 1.5 * dusk.x, "{dusk}");
}

/// The disc goes behind the edge over half a degree, and later for a higher eye.
#[test]
fn the_disc_sets_gradually() {
    let air = Atmosphere::new(1.0);
    let at = |height_m: f64, elevation_deg: f64| {
        air.sun_transmittance(height_m, elevation_deg.to_radians().sin()).x
    };
    let mut last = at(2.0, 3.0);
    for i in 1..100 {
        let now = at(2.0, 3.0 - 0.04 * f64::from(i));
        assert!(now <= last && last - now < 0.05 * at(2.0, 3.0));
        last = now;
    }
    assert_eq!(at(0.0, -0.3), 0.0);
    assert!(at(12e3, -3.0) > 0.0);
    assert_eq!(at(12e3, -4.0), 0.0);
}

#[test]
fn twilight_only_darkens() {
    let air = Atmosphere::new(1.0);
    let mut last = DVec3::INFINITY;
    for i in 0..=60 {
        let elevation_deg = 6.0 - 0.4 * f64::from(i);
        let now = Sky::new(&air, 2.0, sun_at(elevation_deg)).irradiance();
        assert!(now.cmplt(last).all() && now.min_element() > 0.0, "{elevation_deg}: {now} after {last}");
        last = now;
    }
}

/// Irradiance at sea level, sky and sun together, stays below the sun's above the air; and what falls on the ground and what
/// goes back to space are no more than came in. (A sun that is nearly down lights a round Earth's air from the side, which
/// this balance over a level place leaves out.)
#[test]
fn light_is_not_made_from_nothing() {
    for haze in [0.0, 1.0, 10.0] {
        let air = Atmosphere::new(haze);
        for elevation_deg in [20.0, 50.0, 90.0] {
            let sun = sun_at(elevation_deg);
            let down =
                Sky::new(&air, LOWEST_EYE_M, sun).irradiance() + air.sun_transmittance(1.0, sun.y) * sun.y;
            assert!(down.max_element() < sun.y, "{elevation_deg}: {down}");
            assert!(haze > 1.0 || down.min_element() > 0.4 * sun.y, "{elevation_deg}: {down}");
            let up = upwelling(&air, sun);
            // The ground takes in what it does not send back.
            let total = 0.9 * down + up;
            assert!(total.max_element() < 1.0 * sun.y, "haze {haze}, {elevation_deg}: {}", total / sun.y);
        }
    }
}

/// Radiant exitance at 60 km, where next to no air is left, without light from the ground.
fn upwelling(air: &Atmosphere, sun: DVec3) -> DVec3 {
    let (rings, spokes) = (40, 20);
    let radiance = |i: u32| {
        let sin = ((f64::from(i / spokes) + 0.5) / f64::from(rings)).sqrt();
        let (s, c) = (TAU * (f64::from(i % spokes) + 0.5) / f64::from(spokes)).sin_cos();
        air.radiance(60e3, DVec3::new(sin * c, -(1.0 - sin * sin).sqrt(), sin * s), sun)
    };
    PI * (0..rings * spokes).map(radiance).sum::<DVec3>() / f64::from(rings * spokes)
}

#[test]
fn the_whole_ray_is_the_sky() {
    let air = Atmosphere::new(1.0);
    for (eye_m, elevation_deg) in [(2.0, 4.0), (2.0, -20.0), (9e3, -1.0), (9e3, -40.0), (60e3, 80.0)] {
        let (d, sun) = (toward(70.0, elevation_deg), sun_at(15.0));
        let all = air.aerial_perspective(eye_m, d, sun, 1e8);
        assert_eq!(all.in_scattered, air.radiance(eye_m, d, sun));
    }
    // To the end of the air what is let through is what the table says.
    let all = air.aerial_perspective(100.0, toward(0.0, 12.0), sun_at(30.0), 1e8);
    assert!(worst(all.transmittance, air.transmittance(100.0, toward(0.0, 12.0).y)) < 2e-3);
}

/// Two parts of a ray, the second seen through the first, are the whole.
#[test]
fn aerial_perspective_adds_up_along_the_ray() {
    let air = Atmosphere::new(3.0);
    let (eye_m, sun) = (3e3, sun_at(25.0));
    for elevation_deg in [-10.0, -3.0, 5.0] {
        let d = toward(30.0, elevation_deg);
        let (near_m, far_m) = (6e3, 15e3);
        let near = air.aerial_perspective(eye_m, d, sun, near_m);
        let whole = air.aerial_perspective(eye_m, d, sun, far_m);
        // The second part begins where the Earth has turned the vertical a little.
        let ray = Ray { height_km: eye_m / 1e3, mu: d.y, length_km: near_m / 1e3 };
        let there_m = ray.height_at(near_m / 1e3) * 1e3;
        let up = (DVec3::Y * (shell::GROUND_KM + eye_m / 1e3) + d * near_m / 1e3).normalize();
        let turn = glam::DQuat::from_rotation_arc(up, DVec3::Y);
        let rest = air.aerial_perspective(there_m, turn * d, turn * sun, far_m - near_m);
        let light = near.in_scattered + near.transmittance * rest.in_scattered;
        assert!(worst(light, whole.in_scattered) < 5e-3, "{elevation_deg}");
        assert!(worst(near.transmittance * rest.transmittance, whole.transmittance) < 1e-3);
    }
}

/// Before anything is scattered, air takes away and adds nothing.
#[test]
fn nothing_lies_between_an_eye_and_what_touches_it() {
    let near = Atmosphere::new(1.0).aerial_perspective(2.0, DVec3::X, sun_at(30.0), 0.0);
    assert_eq!((near.in_scattered, near.transmittance), (DVec3::ZERO, DVec3::ONE));
}
