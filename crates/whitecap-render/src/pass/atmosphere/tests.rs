use super::*;
use crate::environment::Environment;
use crate::gpu::for_tests::{BoundGroup, Canvas, compute_beside, gpu};
use crate::pass::SkyPass;
use crate::shader_lib::layout::assert_layout;
use crate::uniforms::{Role, Shared};
use crate::{Gpu, TargetFormat};
use whitecap_scene::panorama::Panorama;
use whitecap_scene::{Camera, Scene};
use whitecap_waves::optics::atmosphere::Atmosphere;

#[test]
fn rust_and_wgsl_agree_about_layout() {
    assert_layout!(
        GpuAir,
        shader_lib::LINEAR_SKY.wgsl,
        "GpuAir",
        [toward_sun, sun_radius_rad, sun_klx, haze, eye_km, horizon_rad, clouds, visibility_m]
    );
    assert_layout!(GpuPicture, shader_lib::LINEAR_SKY.wgsl, "GpuPicture", [exposure, tone_map]);
}

/// Layout twin of `TwinInput` in `twins.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Asked {
    direction: [f32; 3],
    distance_m: f32,
}

fn scene_under(sky: &str) -> Scene {
    let base = whitecap_scene::named::find("meshuggah").unwrap().toml;
    let without = &base[..base.find("[sky]").unwrap()];
    let camera = &base[base.find("[camera]").unwrap()..];
    Scene::from_toml(&format!("{without}[sky]\n{sky}\n{camera}"), "test.toml").unwrap()
}

fn view_from(eye_m: f64) -> View {
    let camera = Camera {
        position_m: [50.0, eye_m, -7.0],
        look_at_m: [80.0, eye_m + 4.0, -9.0],
        vertical_fov_deg: 45.0,
    };
    View::of_camera(&camera, [32, 18])
}

fn shared_under(gpu: &Gpu, scene: &Scene, target: TargetFormat) -> Shared {
    let environment = Environment::linear(scene).unwrap();
    Shared::new(&gpu.device, &gpu.queue, &environment, target)
}

fn prepare(gpu: &Gpu, shared: &mut Shared, eyes_m: &[f64]) {
    let views: Vec<View> = eyes_m.iter().copied().map(view_from).collect();
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    shared.skies.as_mut().unwrap().prepare(&gpu.device, &gpu.queue, &mut encoder, &views);
    gpu.queue.submit([encoder.finish()]);
}

/// Sky, aerial perspective and disc for each input, as view `view` sees them.
fn ask(gpu: &Gpu, shared: &Shared, view: usize, inputs: &[Asked]) -> Vec<[[f32; 4]; 3]> {
    let environment = BoundGroup {
        index: 1,
        layout: &shared.environment_layout,
        group: shared.skies.as_ref().unwrap().group(view).unwrap(),
        offsets: &[],
    };
    let twins = &shader_lib::ATMOSPHERE_TWINS;
    compute_beside(&gpu.device, &gpu.queue, twins, "cs_run", inputs, 0, &[environment])
}

fn color(v: [f32; 4]) -> DVec3 {
    DVec3::new(v[0].into(), v[1].into(), v[2].into())
}

/// Luminance of a moonless night sky, kcd/m²: the light of stars and of the upper air, which is left out, hides what is
/// darker.
const NIGHT: f64 = 2e-7;

/// The largest error of a channel as a share of the brightest, or of the night's light.
fn error_of(found: DVec3, expected: DVec3) -> f64 {
    (found - expected).abs().max_element() / expected.max_element().max(NIGHT)
}

/// Directions between the tables' entries: azimuth from the sun and elevation from the eye's horizon.
fn asked(toward_sun: DVec3, horizon_rad: f64, above: bool, distance_m: f64) -> Vec<(DVec3, Asked)> {
    let sun_azimuth = toward_sun.z.atan2(toward_sun.x);
    let mut inputs = Vec::new();
    for azimuth_deg in [0.0, 4.0, 33.0, -70.0, 151.0, 180.0_f64] {
        for from_horizon_deg in [0.02, 0.2, 0.9, 2.1, 6.0, 17.0, 44.0, 80.0_f64] {
            let elevation = horizon_rad + from_horizon_deg.to_radians() * if above { 1.0 } else { -1.0 };
            let (sin, cos) = (sun_azimuth + azimuth_deg.to_radians()).sin_cos();
            let d = DVec3::new(cos * elevation.cos(), elevation.sin(), sin * elevation.cos());
            inputs.push((d, Asked { direction: d.as_vec3().to_array(), distance_m: distance_m as f32 }));
        }
    }
    inputs
}

const EYES_M: [f64; 4] = [2.0, 300.0, 12e3, 55e3];

fn toward_sun_of(environment: &Shared) -> DVec3 {
    Vec3::from(environment.skies.as_ref().unwrap().air.toward_sun).as_dvec3()
}

/// Suns from high to the lowest that scenes allow, and haze.
const SUNS: [(f64, f64); 7] =
    [(70.0, 1.0), (35.0, 1.0), (6.0, 3.0), (2.0, 2.0), (-1.0, 1.0), (-4.0, 1.0), (-10.0, 1.0)];

#[test]
fn the_skys_tables_are_those_of_the_atmosphere() {
    let Some(gpu) = gpu() else { return };
    for (sun_elevation_deg, haze) in SUNS {
        let sky = format!("sun_elevation_deg = {sun_elevation_deg:?}\nhaze = {haze:?}\ncloud_cover = 0.0");
        let mut shared = shared_under(gpu, &scene_under(&sky), TargetFormat::default());
        prepare(gpu, &mut shared, &EYES_M);
        let (sun, air) = (toward_sun_of(&shared), Atmosphere::new(haze));
        for (i, eye_m) in EYES_M.into_iter().enumerate() {
            let inputs = asked(sun, horizon_rad(eye_m), true, 0.0);
            let outputs = ask(gpu, &shared, i, &inputs.iter().map(|i| i.1).collect::<Vec<_>>());
            let mut worst = 0.0_f64;
            for ((d, _), [sky, ..]) in inputs.iter().zip(&outputs) {
                let expected = f64::from(SUN_KLX) * air.radiance(eye_m, *d, sun);
                worst = worst.max(error_of(color(*sky), expected));
            }
            println!("sky, sun {sun_elevation_deg}°, eye {eye_m} m: {worst:.4}");
            assert!(worst < 0.01, "sun {sun_elevation_deg}°, eye {eye_m} m: {worst}");
        }
    }
}

/// What air adds to a thing, as a share of the sky behind it, and the mean share of light that it lets through.
#[test]
fn what_the_air_does_to_things_is_what_the_atmosphere_says() {
    let Some(gpu) = gpu() else { return };
    for (sun_elevation_deg, haze) in SUNS {
        let sky = format!("sun_elevation_deg = {sun_elevation_deg:?}\nhaze = {haze:?}\ncloud_cover = 0.0");
        let mut shared = shared_under(gpu, &scene_under(&sky), TargetFormat::default());
        prepare(gpu, &mut shared, &EYES_M);
        let (sun, air) = (toward_sun_of(&shared), Atmosphere::new(haze));
        for (i, eye_m) in EYES_M.into_iter().enumerate() {
            let (mut errors, mut clear) = ([0.0_f64; 2], 0.0_f64);
            for (above, distance_m) in
                [1.0, 30.0, 700.0, 5e3, 20e3, 80e3].iter().flat_map(|d| [(true, *d), (false, *d)])
            {
                let inputs = asked(sun, horizon_rad(eye_m), above, distance_m);
                let outputs = ask(gpu, &shared, i, &inputs.iter().map(|i| i.1).collect::<Vec<_>>());
                // Nothing is higher than the highest eye.
                let things = inputs.iter().zip(&outputs);
                for ((d, _), [_, aerial, _]) in
                    things.filter(|((d, _), _)| eye_m + d.y * distance_m < HIGHEST_EYE_M)
                {
                    let expected = air.aerial_perspective(eye_m, *d, sun, distance_m);
                    let added = f64::from(SUN_KLX) * expected.in_scattered;
                    let sky = f64::from(SUN_KLX) * air.radiance(eye_m, *d, sun).max_element();
                    let off = (color(*aerial) - added).abs().max_element();
                    let error = &mut errors[usize::from(above)];
                    *error = error.max(off / sky.max(NIGHT));
                    let mean = expected.transmittance.dot(DVec3::splat(1.0 / 3.0));
                    clear = clear.max((f64::from(aerial[3]) - mean).abs());
                }
            }
            let [below, above] = errors;
            println!(
                "aerial, sun {sun_elevation_deg}°, eye {eye_m} m: below the horizon {below:.4}, above {above:.4}, transmittance {clear:.4}"
            );
            assert!(
                below < 0.01 && above < 0.01 && clear < 0.002,
                "sun {sun_elevation_deg}°, eye {eye_m} m: {below} {above} {clear}"
            );
        }
    }
}

/// Its light is the sun's through the air; towards the limb it is darker and, with a low sun, redder below.
#[test]
fn the_disc_has_the_suns_energy() {
    let Some(gpu) = gpu() else { return };
    for sun_elevation_deg in [30.0, 0.6] {
        let sky = format!("sun_elevation_deg = {sun_elevation_deg:?}\ncloud_cover = 0.0");
        let mut shared = shared_under(gpu, &scene_under(&sky), TargetFormat::default());
        let eye_m = 8.0;
        prepare(gpu, &mut shared, &[eye_m]);
        let sun = toward_sun_of(&shared);
        let (right, n) = (sun.cross(DVec3::Y).normalize(), 64);
        let up = right.cross(sun);
        let step = 0.012 / f64::from(n);
        let mut inputs = Vec::new();
        for i in 0..n * n {
            let at = |i: i32| (f64::from(i) + 0.5) * step - 0.006;
            let d = (sun + right * at(i % n) + up * at(i / n)).normalize();
            inputs.push(Asked { direction: d.as_vec3().to_array(), distance_m: 0.0 });
        }
        let discs: Vec<DVec3> = ask(gpu, &shared, 0, &inputs).iter().map(|o| color(o[2])).collect();
        let whole = discs.iter().sum::<DVec3>() * (step * step);
        let air = Atmosphere::new(1.0);
        let expected = f64::from(SUN_KLX) * air.sun_transmittance(eye_m, sun.y);
        println!("disc at {sun_elevation_deg}°: {:.4}", error_of(whole, expected));
        assert!(error_of(whole, expected) < 0.01, "{whole} instead of {expected}");
        let n = n as usize;
        let (middle, limb) = (discs[n / 2 * n + n / 2], discs[n / 2 * n + n / 2 + 23]);
        assert!(limb.y > 0.0 && limb.y < 0.8 * middle.y && limb.z / limb.x < middle.z / middle.x);
        let (upper, lower) = (discs[(n / 2 + 15) * n + n / 2], discs[(n / 2 - 15) * n + n / 2]);
        assert!(lower.z / lower.x < upper.z / upper.x || sun_elevation_deg > 10.0);
    }
}

/// Tables are kept where an eye stays at its height, and nothing else of earlier frames is.
#[test]
fn the_sky_does_not_depend_on_what_was_drawn_before() {
    let Some(gpu) = gpu() else { return };
    let scene = scene_under("sun_elevation_deg = 12.0\ncloud_cover = 0.4");
    let inputs: Vec<Asked> = asked(DVec3::X, 0.0, true, 9e3).iter().map(|i| i.1).collect();
    let mut fresh = shared_under(gpu, &scene, TargetFormat::default());
    prepare(gpu, &mut fresh, &[40.0, 7e3]);
    let mut used = shared_under(gpu, &scene, TargetFormat::default());
    for eyes_m in [&[7e3, 40.0][..], &[40.0], &[40.0, 7e3]] {
        prepare(gpu, &mut used, eyes_m);
    }
    for view in [0, 1] {
        assert_eq!(ask(gpu, &fresh, view, &inputs), ask(gpu, &used, view, &inputs));
    }
    let [low, high] = [0, 1].map(|view| ask(gpu, &fresh, view, &inputs));
    assert_ne!(low, high);
}

/// An eye at sea level sees the clouds of the map, one over them does not.
#[test]
fn clouds_are_those_of_the_map_from_below() {
    let Some(gpu) = gpu() else { return };
    let scene = scene_under("sun_elevation_deg = 30.0\ncloud_cover = 0.8");
    let environment = Environment::linear(&scene).unwrap();
    let mut shared = Shared::new(&gpu.device, &gpu.queue, &environment, TargetFormat::default());
    prepare(gpu, &mut shared, &[1.0, 10e3]);
    let (sun, air) = (toward_sun_of(&shared), Atmosphere::new(1.0));
    let directions: Vec<DVec3> = (0..60)
        .map(|i| DVec3::new((f64::from(i) * 0.7).sin(), 0.5, (f64::from(i) * 0.7).cos()).normalize())
        .collect();
    let inputs: Vec<Asked> =
        directions.iter().map(|d| Asked { direction: d.as_vec3().to_array(), distance_m: 0.0 }).collect();
    let [below, over] = [0, 1].map(|view| ask(gpu, &shared, view, &inputs));
    let mut cloudy = 0;
    for ((d, below), over) in directions.iter().zip(&below).zip(&over) {
        let [from_sea, from_high] =
            [1.0, 10e3].map(|eye_m| f64::from(SUN_KLX) * air.radiance(eye_m, *d, sun));
        assert!(error_of(color(over[0]), from_high) < 0.01);
        cloudy += usize::from(error_of(color(below[0]), from_sea) > 0.1);
    }
    assert!(cloudy > 20, "{cloudy}");
}

/// What a panorama shows is the sky, and its horizon's light is what distance adds.
#[test]
fn under_a_panorama_the_sky_is_the_picture_and_haze_has_its_light() {
    let Some(gpu) = gpu() else { return };
    let pixels = vec![[3.0, 4.0, 5.0]; 64 * 32];
    let mut scene = whitecap_scene::open("spectral-ocean").unwrap();
    scene.sky = whitecap_scene::Sky::Panorama(whitecap_scene::sky::PanoramaSky {
        file: "sky.hdr".into(),
        yaw_deg: 0.0,
        exposure_ev: 0.0,
    });
    scene.panorama = Some(Panorama { width: 64, height: 32, pixels, repaired: 0 }.into());
    let mut shared = shared_under(gpu, &scene, TargetFormat::default());
    prepare(gpu, &mut shared, &[1.0]);
    let whitecap_scene::Technique::SpectralOcean(settings) = &scene.technique else { panic!() };
    let distance_m = 1e3 * settings.visibility_km as f32;
    let inputs = [
        Asked { direction: [0.8, -0.01, 0.6], distance_m },
        Asked { direction: [0.0, 1.0, 0.0], distance_m: 0.0 },
    ];
    let outputs = ask(gpu, &shared, 0, &inputs);
    let light = DVec3::new(3.0, 4.0, 5.0);
    assert!(error_of(color(outputs[1][0]), light) < 2e-3);
    // Koschmieder: at the range of visibility 2 % of the contrast is left.
    assert!((outputs[0][1][3] - 0.02).abs() < 1e-3, "{:?}", outputs[0][1]);
    assert!(error_of(color(outputs[0][1]), 0.98 * light) < 3e-3, "{:?}", outputs[0][1]);
    assert_eq!(outputs[0][2], [0.0; 4]);
}

/// Into a target that keeps radiance, the sky behind everything is the atmosphere's.
#[test]
fn the_drawn_sky_is_the_atmospheres() {
    let Some(gpu) = gpu() else { return };
    let (device, queue) = (&gpu.device, &gpu.queue);
    let target = TargetFormat { color: wgpu::TextureFormat::Rgba16Float, ..TargetFormat::default() };
    let scene = scene_under("sun_elevation_deg = 30.0\nsun_azimuth_deg = 300.0\ncloud_cover = 0.0");
    let mut shared = shared_under(gpu, &scene, target);
    let sky = SkyPass::new(device, &shared, &target);
    let view = view_from(2.0);
    shared.write_views(queue, &[view]).unwrap();
    prepare(gpu, &mut shared, &[2.0]);
    let canvas = Canvas::new(gpu, &target, view.size_px);
    let mut encoder = device.create_command_encoder(&Default::default());
    canvas.draw(&mut encoder, wgpu::Color::BLACK, |pass| sky.draw(pass, &shared, 0, Role::Main));
    queue.submit([encoder.finish()]);
    let texels: Vec<[f16; 4]> = bytemuck::pod_collect_to_vec(&canvas.pixels());
    let (air, sun) = (Atmosphere::new(1.0), toward_sun_of(&shared));
    let eye_world_from_clip = view.clip_from_eye_world().inverse();
    let [width, height] = view.size_px;
    for (x, y) in [(3, 2), (16, 9), (30, 5)] {
        let ndc =
            glam::Vec2::new((x as f32 + 0.5) / width as f32, (y as f32 + 0.5) / height as f32) * 2.0 - 1.0;
        let d = eye_world_from_clip.project_point3(Vec3::new(ndc.x, -ndc.y, 0.5)).normalize().as_dvec3();
        let expected = f64::from(SUN_KLX) * air.radiance(2.0, d, sun);
        let found = color(texels[(y * width + x) as usize].map(f16::to_f32));
        assert!(error_of(found, expected) < 0.01, "{found} instead of {expected}");
    }
}
