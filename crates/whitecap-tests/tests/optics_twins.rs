//! The sea's optics, run on the GPU over the same inputs as in Rust.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use glam::{DVec2, DVec3, Vec3};
use whitecap_render::gpu::for_tests::compute;
use whitecap_render::shader_lib::{self, GpuWaterLight};
use whitecap_tests::adapter::gpu;
use whitecap_waves::optics::surface::{
    ReflectionTap, SEA_REFRACTIVE_INDEX, SlopeCovariance, Slopes, sea_reflection, sun_glitter, visible_facets,
};
use whitecap_waves::optics::water_body::{
    Daylight, JerlovType, WaterLight, WaterOptics, crest_light, water_radiance,
};

/// Layout twin of `OpticsInput` in `optics_twins.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Input {
    light: GpuWaterLight,
    toward_eye: [f32; 3],
    sun_radius_rad: f32,
    toward_sun: [f32; 3],
    height_m: f32,
    covariance: [f32; 3],
    depth_m: f32,
    mean_slope: [f32; 2],
    padding: [f32; 2],
    whole_sea: [f32; 3],
    end: u32,
}

/// Layout twin of `OpticsOutput`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
struct Output {
    normal: [f32; 3],
    mean_fresnel: f32,
    taps: [[f32; 4]; 3],
    along: [f32; 4],
    across: [f32; 4],
    water_radiance: [f32; 4],
    crest_light: [f32; 4],
}

fn light() -> WaterLight {
    let daylight = Daylight {
        sun_irradiance: [1.0, 0.9, 0.8],
        toward_sun: DVec3::new(0.4, 0.5, -0.2).normalize(),
        sky_irradiance: [0.1, 0.2, 0.3],
    };
    WaterLight::new(&WaterOptics::from(JerlovType::II), &daylight, [0.3, 0.35, 0.25], 0.3)
}

/// Views from above to the horizon and past it, over seas from a mirror to a storm, some facing away.
fn inputs() -> Vec<Input> {
    let mut inputs = Vec::new();
    for view in 0..40 {
        // Dense towards the horizon.
        let elevation = 1.57 * (f64::from(view) / 38.0).powi(3) - 0.01;
        for sea in 0..12 {
            let deviation = [0.0, 1e-4, 3e-3, 0.03, 0.1, 0.35][sea % 6];
            let variance = deviation * deviation;
            let azimuth = f64::from(view) + 2.0 * sea as f64;
            let eye =
                DVec3::new(elevation.cos() * azimuth.cos(), elevation.sin(), elevation.cos() * azimuth.sin());
            let tilt = if sea < 6 { 0.0 } else { 0.12 };
            let mean = DVec2::new(tilt * (1.7 * azimuth).cos(), tilt * (2.3 * azimuth).sin());
            // Around the mirror's direction.
            let normal = DVec3::new(-mean.x, 1.0, -mean.y).normalize();
            let mirrored = 2.0 * eye.dot(normal) * normal - eye;
            let beside = DVec3::new(0.0, 0.01, 0.002) + 0.5 * deviation * DVec3::new(0.3, 0.8, -0.4);
            let sun = (mirrored + beside * f64::from(view % 4)).normalize();
            inputs.push(Input {
                light: GpuWaterLight::from(&light()),
                toward_eye: eye.as_vec3().normalize().to_array(),
                sun_radius_rad: 0.00465,
                toward_sun: sun.as_vec3().normalize().to_array(),
                height_m: (0.3 * f64::from(view % 5) - 0.2) as f32,
                covariance: [variance as f32, (0.4 * variance) as f32, (0.6 * variance) as f32],
                depth_m: (2.0 * f64::from(view % 7)) as f32,
                mean_slope: mean.as_vec2().to_array(),
                padding: [0.0; 2],
                // A pixel resolves a part of it.
                whole_sea: [2.0 * variance as f32 + 0.01, 0.0, variance as f32 + 0.004]
                    .map(|c| if sea % 2 == 0 { c } else { 0.0 }),
                end: 0,
            });
        }
    }
    inputs
}

fn assert_near(seen: f32, expected: f64, tolerance: f64, what: &str, input: &Input) {
    let error = (f64::from(seen) - expected).abs();
    assert!(
        error <= tolerance * expected.abs().max(1.0),
        "{what}: {seen} instead of {expected} for {:?} {:?} {:?}",
        input.toward_eye,
        input.covariance,
        input.mean_slope
    );
}

fn assert_tap(seen: [f32; 4], along: f32, across: f32, expected: &ReflectionTap, input: &Input) {
    assert_near(seen[3], expected.weight, 2e-5, "weight", input);
    let toward = Vec3::from_slice(&seen[..3]).as_dvec3();
    // A tap at the zenith has no bearing.
    let bearing_error = toward.distance(expected.toward);
    assert!(bearing_error < 5e-4, "{toward} instead of {} for {:?}", expected.toward, input.toward_eye);
    assert!(toward.y >= 0.0 && (toward.length() - 1.0).abs() < 1e-3);
    assert_near(along, expected.spread_along_rad, 5e-4, "along", input);
    assert_near(across, expected.spread_across_rad, 1e-4, "across", input);
}

#[test]
fn the_seas_optics_on_the_gpu_equal_the_cpus() {
    let Some(gpu) = gpu() else { return };
    let inputs = inputs();
    let outputs: Vec<Output> = compute(gpu, &shader_lib::OPTICS_TWINS, "cs_run", &inputs);
    let n = SEA_REFRACTIVE_INDEX;
    let mut glints = 0;
    for (input, output) in inputs.iter().zip(&outputs) {
        let wide = |v: [f32; 3]| Vec3::from(v).as_dvec3();
        let (eye, sun) = (wide(input.toward_eye), wide(input.toward_sun));
        let [xx, xz, zz] = input.covariance.map(f64::from);
        let mean = glam::Vec2::from(input.mean_slope).as_dvec2();
        let [sea_xx, sea_xz, sea_zz] = input.whole_sea.map(f64::from);
        let whole_sea = SlopeCovariance { xx: sea_xx, xz: sea_xz, zz: sea_zz };
        let slopes = Slopes { mean, covariance: SlopeCovariance { xx, xz, zz } };
        let facets = visible_facets(&slopes, whole_sea, eye, n);
        let reflection = sea_reflection(&facets, eye, n);
        assert_near(output.mean_fresnel, facets.mean_fresnel, 2e-5, "mean_fresnel", input);
        assert!(wide(output.normal).distance(facets.normal) < 1e-4);
        for (i, tap) in reflection.taps.iter().enumerate() {
            assert_tap(output.taps[i], output.along[i], output.across[i], tap, input);
        }
        assert_near(output.along[3], reflection.water_weight, 2e-5, "water_weight", input);
        // In single precision slopes are known to about 1e-7 of 1/H_y, and the narrowest glints have a deviation of
        // 1e-3: some parts in ten thousand of their height, and more on their flanks.
        let glitter = sun_glitter(&slopes, &facets, eye, sun, input.sun_radius_rad.into(), n);
        assert!(output.across[3].is_finite());
        assert_near(output.across[3], glitter, 4e-3, "sun_glitter", input);
        glints += usize::from(glitter > 1.0);
        let light = light();
        let water = water_radiance(&light, input.depth_m.into(), eye.y);
        let crest = crest_light(&light, mean, input.height_m.into(), eye, sun);
        for i in 0..3 {
            assert_near(output.water_radiance[i], water[i], 1e-5, "water_radiance", input);
            assert_near(output.crest_light[i], crest[i], 1e-4, "crest_light", input);
        }
    }
    assert!(glints > 100, "{glints} of the suns are seen in the water");
}
