//! The projected grid's pictures: water wherever it is to be seen, and every setting does something.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use glam::{DVec3, Vec3};
use whitecap_render::environment::Environment;
use whitecap_render::gpu::for_tests::{Canvas, gpu};
use whitecap_render::{Gpu, TargetFormat, View, Water};
use whitecap_scene::{Camera, Scene};

const SIZE: [u32; 2] = [64, 36];

/// No water has this colour.
const NOTHING: wgpu::Color = wgpu::Color { r: 1.0, g: 0.0, b: 1.0, a: 1.0 };

/// The water alone, in one view at one time.
fn draw(gpu: &Gpu, water: &mut Water, view: View, time_s: f64) -> Vec<u8> {
    let canvas = Canvas::new(gpu, &TargetFormat::default(), SIZE);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    water.prepare(&gpu.device, &gpu.queue, &mut encoder, &[view], time_s).unwrap();
    canvas.draw(&mut encoder, NOTHING, |pass| water.draw(pass, 0));
    gpu.queue.submit([encoder.finish()]);
    canvas.pixels()
}

fn scene(toml: &str) -> Scene {
    Scene::from_toml(toml, "test.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn toml(name: &str) -> &'static str {
    whitecap_scene::named::find(name).unwrap().toml
}

/// From under water, within the waves, low and high; level, straight down, straight up and rolled: water wherever
/// a ray meets the sea below or above the eye, and none in the sky.
#[test]
fn water_is_where_it_should_be_for_every_camera() {
    let Some(gpu) = gpu() else { return };
    let mut scene = scene(toml("projected-grid"));
    scene.objects.clear();
    let mut water = Water::new(&gpu.device, &gpu.queue, &scene, TargetFormat::default()).unwrap();
    let mut camera = 0;
    for height_m in [-12.0_f64, -0.2, 0.1, 2.5, 60.0, 4_000.0] {
        for (pitch_deg, roll_deg) in
            [(-90.0_f64, 0.0_f64), (90.0, 0.0), (-3.0, 0.0), (-35.0, 140.0), (20.0, 70.0)]
        {
            camera += 1;
            let look_at = DVec3::new(1.0, 0.0, -2.0 - f64::from(camera));
            let level =
                Camera { position_m: [0.0; 3], look_at_m: look_at.to_array(), vertical_fov_deg: 70.0 };
            let mut view = View::of_camera(&level, SIZE);
            let turn = glam::Quat::from_rotation_z(-roll_deg.to_radians() as f32)
                * glam::Quat::from_rotation_x(-pitch_deg.to_radians() as f32);
            view.view_from_world = turn * view.view_from_world;
            view.eye_m = DVec3::new(1e5 * f64::from(camera), height_m, -77.0);
            let pixels = draw(gpu, &mut water, view, f64::from(camera));
            let world_from_clip = view.clip_from_eye_world().inverse();
            // Within the waves the surface may pass the eye on either side, near the horizon by any angle.
            let distance = height_m.abs();
            let margin = 3.0 * f64::from(view.pixel_angle_rad()) + (1.5 / distance).min(1.6);
            for (i, pixel) in pixels.chunks(4).enumerate() {
                let (x, y) = (i as u32 % SIZE[0], i as u32 / SIZE[0]);
                let ndc_x = (x as f32 + 0.5) / SIZE[0] as f32 * 2.0 - 1.0;
                let ndc_y = 1.0 - (y as f32 + 0.5) / SIZE[1] as f32 * 2.0;
                let ray = world_from_clip.project_point3(Vec3::new(ndc_x, ndc_y, 0.5)).normalize();
                // Towards the water.
                let toward = f64::from(ray.y.clamp(-1.0, 1.0)).asin() * -height_m.signum();
                let nothing = pixel[0] == 255 && pixel[1] == 0 && pixel[2] == 255;
                // The water ends at 100 km.
                let end = (distance / 100e3).min(1.0);
                if toward > margin + end {
                    assert!(!nothing, "{height_m} m, {pitch_deg}, {roll_deg}: no water at ({x}, {y})");
                }
                if toward < -margin {
                    assert!(nothing, "{height_m} m, {pitch_deg}, {roll_deg}: water in the sky at ({x}, {y})");
                }
            }
        }
    }
}

/// Every setting of the technique and of its sea changes the picture, in the scene or in another that uses it.
#[test]
fn no_setting_is_without_effect() {
    let Some(gpu) = gpu() else { return };
    // Without the lines that the test itself writes.
    let own = ["smooth", "sun_strength", "sun_shininess"];
    let kept = toml("projected-grid").lines().filter(|line| !own.iter().any(|key| line.starts_with(key)));
    let base = kept.map(|line| format!("{line}\n")).collect::<String>();
    let environment = Environment::new(&scene(&base)).unwrap();
    let target = TargetFormat::default();
    let render = |toml: &str| {
        let mut scene = scene(toml);
        // Low, close to a duck, and over where the island shelves.
        scene.camera.position_m = [20.0, 3.0, -95.0];
        scene.camera.look_at_m = [45.0, 0.0, -130.0];
        let view = View::of_camera(&scene.camera, SIZE);
        let mut water =
            Water::with_environment(&gpu.device, &gpu.queue, &scene, &environment, target).unwrap();
        draw(gpu, &mut water, view, 1.0)
    };
    let with = |line: &str| base.replace("pairing = \"faithful\"", line);
    let before = render(&base);
    assert_eq!(render(&base), before);
    for line in [
        "grid_across = 33",
        "grid_down = 65",
        "far_km = 0.2",
        "elevation_m = 20.0",
        "slab_margin_m = 5.0",
        "smooth = true",
        "pairing = \"coherent\"",
        "map_across = 256",
        "map_down = 256",
        "refraction = \"map\"",
        "local_map_size = 64",
        "distortion = 0.5",
        "offset_axes = \"view\"",
        "water_color = [0.35, 0.54, 0.52]",
        "sun_alfa_deg = 45.0",
        "sun_theta_deg = 10.0",
    ] {
        assert_ne!(render(&with(line)), before, "{line} changes nothing");
    }
    for (from, to) in [
        ("normals = \"map\"", "normals = \"per-vertex\""),
        ("local_reflections = true", "local_reflections = false"),
        ("seed = 7", "seed = 8"),
        ("strength_m = 1.5", "strength_m = 0.5"),
        ("scale_per_m = 0.38", "scale_per_m = 0.7"),
        ("strength_m = 1.5", "strength_m = 1.5\nfalloff = 0.9"),
        ("strength_m = 1.5", "strength_m = 1.5\nframes_per_s = 3.0"),
        ("strength_m = 1.5", "strength_m = 1.5\noctave_speedup = 2.0"),
        ("strength_m = 1.5", "strength_m = 1.5\noctave_size = 16"),
    ] {
        assert!(base.contains(from), "the scene has no {from}");
        assert_ne!(render(&base.replacen(from, to, 1)), before, "{to} changes nothing");
    }
    // Against the sun, so that its glint is in the picture.
    let sunny = |line: &str| with(&format!("sun_alfa_deg = 36.0\nsun_theta_deg = 8.0\n{line}"));
    let glint = render(&sunny(""));
    for line in ["sun_strength = 3.0", "sun_shininess = 20.0"] {
        assert_ne!(render(&sunny(line)), glint, "{line} changes nothing");
    }
}
