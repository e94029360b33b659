use super::*;
use crate::optics::fresnel_exact;
use crate::optics::surface::SEA_REFRACTIVE_INDEX;
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

fn noon() -> Daylight {
    Daylight {
        sun_irradiance: [1.0, 0.95, 0.9],
        toward_sun: DVec3::new(0.3, 0.9, 0.1).normalize(),
        sky_irradiance: [0.1, 0.15, 0.25],
    }
}

fn light(kind: JerlovType, albedo: [f64; 3]) -> WaterLight {
    WaterLight::new(&kind.into(), &noon(), albedo, 0.3)
}

/// E below the surface over n².
fn below(channel: usize) -> f64 {
    let n = SEA_REFRACTIVE_INDEX;
    let steps = 2000;
    let diffuse: f64 = (0..steps)
        .map(|i| (f64::from(i) + 0.5) / f64::from(steps))
        .map(|c| 2.0 * c * (1.0 - fresnel_exact(c, n)) / f64::from(steps))
        .sum();
    let cos = noon().toward_sun.y;
    let sun = noon().sun_irradiance[channel] * cos * (1.0 - fresnel_exact(cos, n));
    (sun + noon().sky_irradiance[channel] * diffuse) / (n * n)
}

#[test]
fn white_is_white_and_weights_are_srgbs() {
    for channel in linear_srgb(&[1.0; BANDS]) {
        assert!((channel - 1.0).abs() < 1e-12);
    }
    // A band of long, middle and short waves is red, green and blue.
    for (bands, channel) in [(9..13, 0), (5..7, 1), (0..4, 2)] {
        let mut spectrum = [0.0; BANDS];
        spectrum[bands].fill(1.0);
        let color = linear_srgb(&spectrum);
        assert!((0..3).all(|i| i == channel || color[i] < 0.35 * color[channel]), "{color:?}");
    }
}

/// Transmission over 10 m at 450, 550 and 650 nm.
#[test]
fn known_transmissions() {
    for (kind, expected) in
        [(JerlovType::I, [0.8386, 0.5273, 0.0285]), (JerlovType::III, [0.2513, 0.3201, 0.0153])]
    {
        for (band, expected) in [2, 6, 10].into_iter().zip(expected) {
            assert!(((-10.0 * kind.attenuation_per_m()[band]).exp() - expected).abs() < 6e-5, "{kind:?}");
        }
    }
}

#[test]
fn oceans_are_blue_and_coasts_green() {
    let mut before = 0.0;
    for kind in JerlovType::ALL {
        let ocean = matches!(kind, JerlovType::I | JerlovType::IA | JerlovType::IB | JerlovType::II);
        let attenuation = kind.attenuation_per_m();
        let clearest = (0..BANDS).min_by(|a, b| attenuation[*a].total_cmp(&attenuation[*b])).unwrap();
        let nm = WAVELENGTHS_NM[clearest];
        assert!(if ocean { nm < 490.0 } else { (490.0..=580.0).contains(&nm) }, "{kind:?}: {nm}");
        let [red, green, blue] = WaterOptics::from(kind).attenuation_per_m;
        assert!(if ocean { blue < green } else { green < blue }, "{kind:?}");
        // Only the murkiest coast is brown.
        assert_eq!(green < red, kind != JerlovType::C9, "{kind:?}");
        assert!(green > before, "the list runs from clear to turbid: {kind:?}");
        before = green;
    }
}

/// How far one exponential for a channel is from the channel's light.
#[test]
fn channels_fade_as_their_light_does() {
    let mut worst = 0.0_f64;
    for kind in JerlovType::ALL {
        let optics = WaterOptics::from(kind);
        for channel in 0..3 {
            let k = optics.attenuation_per_m[channel];
            for step in 0..=40 {
                let depth_m = 0.1 * f64::from(step) / k;
                let spectrum = kind.attenuation_per_m().map(|k| (-k * depth_m).exp());
                let error = ((-k * depth_m).exp() - linear_srgb(&spectrum)[channel]).abs();
                worst = worst.max(error);
            }
        }
    }
    println!("a channel's transmission is off by {worst:.3}");
    assert!(worst < 0.13, "{worst}");
}

#[test]
fn what_is_in_the_water_is_physical() {
    for kind in JerlovType::ALL {
        let c = kind.constituents();
        for band in 0..BANDS {
            assert!(c.absorption_per_m[band] > 0.0 && c.backscattering_per_m[band] > 0.0);
            assert!(c.backscattering_per_m[band] <= 0.5 * c.scattering_per_m[band], "{kind:?} {band}");
        }
        let optics = WaterOptics::from(kind);
        assert!(optics.reflectance.iter().all(|r| (0.0..0.33).contains(r)), "{optics:?}");
        println!(
            "{kind:?}: {:.4?} K {:.3?} b {:.3?}",
            optics.reflectance, optics.attenuation_per_m, optics.scattering_per_m
        );
    }
    // The clearest ocean is deep blue, of a reflectance about 0.05 at 450 nm (Morel and Prieur 1977).
    let [red, green, blue] = WaterOptics::from(JerlovType::I).reflectance;
    assert!(blue > 4.0 * green && green > red);
    assert!((0.02..0.07).contains(&blue), "{blue}");
    assert!((green - 0.00793).abs() < 1e-5 && (blue - 0.05924).abs() < 1e-5);
}

#[test]
fn coefficients_and_types_meet() {
    let optics = WaterOptics::from_coefficients([0.3, 0.05, 0.02], [0.3; 3]);
    for i in 0..3 {
        let back = 0.0183 * 0.3;
        assert!((optics.reflectance[i] - 0.33 * back / ([0.3, 0.05, 0.02][i] + back)).abs() < 1e-15);
    }
    assert!((optics.attenuation_per_m[1] * MEAN_COSINE - 0.05 - 0.0183 * 0.3).abs() < 1e-15);
}

#[test]
fn depth_runs_from_the_bottom_to_deep_water() {
    let albedo = [0.4, 0.35, 0.25];
    for kind in [JerlovType::I, JerlovType::III, JerlovType::C9] {
        let light = light(kind, albedo);
        for view_cos in [0.05, 0.5, 1.0] {
            let shallow = water_radiance(&light, 0.0, view_cos);
            let deep = water_radiance(&light, f64::INFINITY, view_cos);
            for i in 0..3 {
                assert!((shallow[i] - albedo[i] * below(i) / PI).abs() < 1e-4, "{kind:?}");
                let reflectance = WaterOptics::from(kind).reflectance[i];
                assert!((deep[i] - reflectance * below(i) / 4.0).abs() < 1e-4, "{kind:?}");
                let mut before = shallow[i];
                for depth_m in [0.5, 2.0, 8.0, 30.0, 200.0] {
                    let seen = water_radiance(&light, depth_m, view_cos)[i];
                    assert!(seen <= before && seen >= deep[i], "a bright bottom fades with depth");
                    before = seen;
                }
                // No more comes up than went down.
                assert!(PI * shallow[i] < below(i) && deep[i] >= 0.0);
            }
        }
    }
    let straight = water_radiance(&light(JerlovType::II, albedo), 5.0, 1.0)[1];
    let lit = light(JerlovType::II, albedo);
    let left = (-10.0 * lit.attenuation_per_m[1]).exp();
    assert!((straight - lit.deep[1] * (1.0 - left) - lit.bottom[1] * left).abs() < 1e-12);
}

/// An eye west of a crest that runs north and south, the sun low in the east behind it.
fn through_a_crest(slope: f64, height_m: f64, sun_deg: f64, sun_from_east: f64) -> [f64; 3] {
    let (sine, cosine) = f64::to_radians(sun_deg).sin_cos();
    let toward_sun = DVec3::new(sun_from_east * cosine, sine, 0.0);
    let daylight = Daylight { toward_sun, ..noon() };
    let light = WaterLight::new(&JerlovType::II.into(), &daylight, [0.0; 3], 0.4);
    let eye = DVec3::new(-0.98, 0.2, 0.0).normalize();
    crest_light(&light, DVec2::new(slope, 0.0), height_m, eye, toward_sun)
}

#[test]
fn crests_glow_against_the_sun() {
    assert_eq!(through_a_crest(0.0, 0.0, 15.0, 1.0), [0.0; 3]);
    assert_eq!(through_a_crest(0.4, 0.0, 15.0, 1.0), [0.0; 3]);
    assert_eq!(through_a_crest(0.0, 1.0, 15.0, 1.0), [0.0; 3]);
    assert_eq!(through_a_crest(-0.4, 1.0, 15.0, 1.0), [0.0; 3]);
    let glow = through_a_crest(0.5, 0.8, 15.0, 1.0);
    let front_lit = through_a_crest(0.5, 0.8, 15.0, -1.0);
    assert!(glow[1] > 10.0 * front_lit[1]);
    for (seen, golden) in glow.into_iter().zip([0.000_324_9, 0.001_156_2, 0.001_403_0]) {
        assert!((seen - golden).abs() < 1e-7);
    }
    // Red is gone, and where the crest is as steep as before it breaks, it outshines what comes up from the deep.
    assert!(glow[1] > 1.3 * glow[0]);
    let (deep, steep) = (light(JerlovType::II, [0.0; 3]).deep[1], through_a_crest(0.9, 0.8, 15.0, 1.0)[1]);
    println!("against deep water: {:.2} at a slope of 0.5, {:.2} at 0.9", glow[1] / deep, steep / deep);
    assert!(glow[1] > 0.4 * deep && steep > deep);
    // It fades to nothing towards the level.
    let mut before = glow[1];
    for step in [0.3, 0.1, 0.03, 0.01, 1e-4] {
        let seen = through_a_crest(0.5 * step, 0.8 * step, 15.0, 1.0)[1];
        assert!(seen >= 0.0 && seen <= before, "{step}: {seen}");
        before = seen;
    }
    assert!(before < 1e-5);
}

#[test]
fn crests_never_blow_up() {
    for slope in [1e-9, 0.01, 0.3, 1.0, 5.0] {
        for height_m in [1e-9, 0.1, 2.0, 20.0] {
            for sun_deg in [-1.0, 0.0, 1.0, 20.0, 89.0] {
                for channel in through_a_crest(slope, height_m, sun_deg, 1.0) {
                    // The sun times the highest value of the phase function.
                    assert!((0.0..26.0).contains(&channel), "{slope} {height_m} {sun_deg}: {channel}");
                }
            }
        }
    }
}
