//! What a frame may depend on, and that no water is missing from it.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use glam::{DVec3, Vec3};
use whitecap_render::gpu::for_tests::Canvas;
use whitecap_render::picture::{PictureRequest, render_picture};
use whitecap_render::{Gpu, MAX_VIEWS, RenderError, TargetFormat, View, Water};
use whitecap_scene::{Camera, Scene, Technique, technique};
use whitecap_tests::adapter::gpu;

const SIZE: [u32; 2] = [64, 36];

/// No water and no sky has this colour.
const NOTHING: wgpu::Color = wgpu::Color { r: 1.0, g: 0.0, b: 1.0, a: 1.0 };

fn scene() -> Scene {
    whitecap_scene::open("meshuggah").unwrap()
}

fn ocean() -> Scene {
    whitecap_scene::open("spectral-ocean").unwrap()
}

/// High waves with foam, long ones, and next to none.
const SEAS: [&str; 3] = ["spectral-ocean-storm", "spectral-ocean-swell", "spectral-ocean-dawn"];

/// The scene that each technique is shown by.
fn scene_of_each_technique() -> impl Iterator<Item = Scene> {
    technique::ALL.iter().map(|technique| whitecap_scene::open(technique.word).unwrap())
}

fn look(eye: DVec3, toward: DVec3) -> View {
    let look_at = eye + toward * 100.0;
    let camera = Camera { position_m: eye.to_array(), look_at_m: look_at.to_array(), vertical_fov_deg: 50.0 };
    View::of_camera(&camera, SIZE)
}

/// The water and, if `sky`, the sky of one view at one time.
fn frame(gpu: &Gpu, water: &mut Water, target: &TargetFormat, view: View, time_s: f64, sky: bool) -> Vec<u8> {
    let canvas = Canvas::new(gpu, target, SIZE);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    water.prepare(&gpu.device, &gpu.queue, &mut encoder, &[view], time_s).unwrap();
    canvas.draw(&mut encoder, NOTHING, |pass| {
        water.draw(pass, 0);
        if sky {
            water.draw_sky(pass, 0);
        }
    });
    gpu.queue.submit([encoder.finish()]);
    canvas.pixels()
}

fn largest_difference(a: &[u8], b: &[u8]) -> u8 {
    a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0)
}

#[test]
fn a_frame_depends_on_its_time_and_view_alone() {
    let Some(gpu) = gpu() else { return };
    let target = TargetFormat::default();
    for scene in scene_of_each_technique() {
        let word = scene.technique.word();
        let mut water = Water::new(&gpu.device, &gpu.queue, &scene, target).unwrap();
        let view = View::of_camera(&scene.camera, SIZE);
        let first = frame(gpu, &mut water, &target, view, 2.5, true);
        let later = frame(gpu, &mut water, &target, view, 77.0, true);
        assert!(largest_difference(&first, &later) > 8, "{word} stands still");
        let other = look(view.eye_m + DVec3::new(9.0, 2.0, 1.0), DVec3::new(1.0, -0.2, 0.1));
        assert_ne!(frame(gpu, &mut water, &target, other, 77.0, true), later, "{word}");
        assert_eq!(frame(gpu, &mut water, &target, view, 2.5, true), first, "{word} remembers");
    }
}

/// Frames of a sequence, across the end of a block of the foam's memory, and each of them as the first that is drawn.
#[test]
fn a_frame_alone_is_the_frame_of_a_sequence() {
    let Some(gpu) = gpu() else { return };
    let target = TargetFormat::default();
    for name in SEAS {
        let scene = whitecap_scene::open(name).unwrap();
        let new = || Water::new(&gpu.device, &gpu.queue, &scene, target).unwrap();
        let view = View::of_camera(&scene.camera, SIZE);
        // Blocks are five e-folding times of foam long.
        let time_s = |i: usize| 5.0 * 3.53 + (i as f64 - 7.0) / 30.0;
        let mut water = new();
        let sequence: Vec<Vec<u8>> =
            (0..12).map(|i| frame(gpu, &mut water, &target, view, time_s(i), true)).collect();
        let mut alone = new();
        for i in [11, 6, 8, 0] {
            let drawn = frame(gpu, &mut alone, &target, view, time_s(i), true);
            assert!(drawn == sequence[i], "{name}: frame {i} is another one alone");
        }
        let first = frame(gpu, &mut new(), &target, view, time_s(9), true);
        assert!(first == sequence[9], "{name}: frame 9 is another one where it is the first");
        assert!(largest_difference(&sequence[0], &sequence[11]) > 4, "{name} stands still");
    }
}

#[test]
fn several_views_in_one_frame_equal_each_alone() {
    let Some(gpu) = gpu() else { return };
    let (device, queue) = (&gpu.device, &gpu.queue);
    let target = TargetFormat::default();
    for scene in scene_of_each_technique() {
        let mut water = Water::new(device, queue, &scene, target).unwrap();
        let first = View::of_camera(&scene.camera, SIZE);
        let views = [first, look(first.eye_m + DVec3::new(30.0, 12.0, 8.0), DVec3::new(-0.2, -0.5, 1.0))];
        let alone = views.map(|view| frame(gpu, &mut water, &target, view, 1.0, true));
        let canvases = views.map(|_| Canvas::new(gpu, &target, SIZE));
        let mut encoder = device.create_command_encoder(&Default::default());
        water.prepare(device, queue, &mut encoder, &views, 1.0).unwrap();
        for (i, canvas) in canvases.iter().enumerate() {
            canvas.draw(&mut encoder, NOTHING, |pass| {
                water.draw(pass, i);
                water.draw_sky(pass, i);
            });
        }
        queue.submit([encoder.finish()]);
        for (canvas, alone) in canvases.iter().zip(&alone) {
            assert_eq!(&canvas.pixels(), alone, "{}", scene.technique.word());
        }
    }

    let mut water = Water::new(device, queue, &scene(), target).unwrap();
    let views = [look(DVec3::new(0.0, 4.0, 0.0), DVec3::new(1.0, -0.1, 0.0))];
    let too_many = vec![views[0]; MAX_VIEWS + 1];
    let mut encoder = device.create_command_encoder(&Default::default());
    let refused = water.prepare(device, queue, &mut encoder, &too_many, 0.0);
    assert!(matches!(refused, Err(RenderError::LimitExceeded { .. })));
}

/// Meshuggah's sea repeats every tile and its bump map every 600/63 m: a thousand kilometres further on, at a
/// multiple of both, the picture must be the same to the last level or two.
#[test]
fn a_thousand_kilometres_from_the_origin_nothing_trembles() {
    let Some(gpu) = gpu() else { return };
    let target = TargetFormat::default();
    // Four tiles as they are laid out, not sewn, that have a common multiple, which is also one of the mesh's largest cell.
    let ocean = whitecap_scene::named::find("spectral-ocean").unwrap().toml.replacen(
        "[[sea.system]]",
        "cascade = [\n  { tile_size_m = 400.0 },\n  { tile_size_m = 80.0 },\n  { tile_size_m = 16.0 },\n  \
         { tile_size_m = 3.2 },\n]\n\n[[sea.system]]",
        1,
    );
    // In a light wind: the structure of foam repeats at other lengths.
    let ocean = ocean.replacen("wind_speed_mps = 9.0", "wind_speed_mps = 2.5", 1);
    let ocean = Scene::from_toml(&ocean, "ocean.toml").unwrap();
    for (scene, shift_m) in [
        (scene(), DVec3::new(1_000_200.0, 0.0, -999_600.0)),
        (ocean, DVec3::new(1_024_000.0, 0.0, -1_011_200.0)),
    ] {
        let mut water = Water::new(&gpu.device, &gpu.queue, &scene, target).unwrap();
        let eye = DVec3::new(12.3, 4.0, -45.6);
        let toward = DVec3::new(-1.0, -0.15, 0.3);
        let here = frame(gpu, &mut water, &target, look(eye, toward), 3.0, true);
        let there = frame(gpu, &mut water, &target, look(eye + shift_m, toward), 3.0, true);
        let unequal = here.iter().zip(&there).filter(|(a, b)| a.abs_diff(**b) > 2).count();
        let word = scene.technique.word();
        assert!(unequal * 500 < here.len(), "{word}: {unequal} of {} values differ", here.len());
    }
}

/// For cameras of all heights and directions: water wherever the ray meets the sea, none above it.
#[test]
fn water_is_where_it_should_be_for_every_camera() {
    let Some(gpu) = gpu() else { return };
    let target = TargetFormat::default();
    for mut scene in [scene(), ocean()] {
        match &mut scene.technique {
            // Haze would hide a hole.
            Technique::Meshuggah(settings) => settings.visibility_km = 1e6,
            Technique::SpectralOcean(settings) => settings.visibility_km = 1e6,
            _ => panic!(),
        }
        let mut water = Water::new(&gpu.device, &gpu.queue, &scene, target).unwrap();
        for_every_camera(|view, time_s| frame(gpu, &mut water, &target, view, time_s, false));
    }
}

fn for_every_camera(mut frame: impl FnMut(View, f64) -> Vec<u8>) {
    let mut random = Lcg(1);
    for camera in 0..60 {
        let height = [2.5, 6.0, 30.0, 400.0, 9_000.0][camera % 5] * (1.0 + random.next());
        let pitch = match camera % 4 {
            0 => -90.0,
            1 => -60.0 * random.next(),
            2 => 60.0 * random.next(),
            _ => -2.0,
        };
        let (azimuth, pitch) = (std::f64::consts::TAU * random.next(), f64::to_radians(pitch));
        let toward = DVec3::new(azimuth.cos() * pitch.cos(), pitch.sin(), azimuth.sin() * pitch.cos());
        let eye = DVec3::new(1e4 * random.next(), height, 1e4 * random.next());
        let view = look(eye, toward);
        let pixels = frame(view, 40.0 * random.next());
        let world_from_clip = view.clip_from_eye_world().inverse();
        // Waves stand some metres about the level and hide the horizon's last pixels.
        let dip = (2.0 * height / 6.371e6).sqrt();
        let margin = 3.0 * f64::from(view.pixel_angle_rad())
            + (3.0 / height.max(3.0)).min(0.5).min(4.0 / 104.0 + 3.0 / height);
        for (i, pixel) in pixels.chunks(4).enumerate() {
            let (x, y) = (i as u32 % SIZE[0], i as u32 / SIZE[0]);
            let ndc_x = (x as f32 + 0.5) / SIZE[0] as f32 * 2.0 - 1.0;
            let ndc_y = 1.0 - (y as f32 + 0.5) / SIZE[1] as f32 * 2.0;
            let ray = world_from_clip.project_point3(Vec3::new(ndc_x, ndc_y, 0.5)).normalize();
            let elevation = f64::from(ray.y.clamp(-1.0, 1.0)).asin();
            let nothing = pixel[0] == 255 && pixel[1] == 0 && pixel[2] == 255;
            if elevation < -dip - margin {
                assert!(!nothing, "camera {camera} at {eye}: no water at ({x}, {y}), {elevation} rad");
            }
            if elevation > margin {
                assert!(nothing, "camera {camera} at {eye}: water in the sky at ({x}, {y}), {elevation} rad");
            }
        }
    }
}

/// Two frames a thirtieth of a second apart: along the horizon, where waves are far smaller than
/// pixels, nothing may flicker.
#[test]
fn the_far_sea_is_calm() {
    let Some(gpu) = gpu() else { return };
    for mut scene in [scene(), ocean()] {
        // Away from the sun, whose glints may come and go; 0.76° down: the horizon lies a little above the middle row.
        let eye_height_m = scene.camera.position_m[1];
        scene.camera.look_at_m = [300.0, eye_height_m - 4.0, 0.0];
        let word = scene.technique.word();
        let picture = |time_s| {
            let request = PictureRequest { backend: None, width: 320, height: 180, time_s };
            render_picture(gpu, &scene, &request, &mut |_| {}).unwrap().rgba8
        };
        let (now, then) = (picture(10.0), picture(10.0 + 1.0 / 30.0));
        let row = |y: usize| y * 320 * 4..(y + 1) * 320 * 4;
        let mean_change = |rows: std::ops::Range<usize>| {
            let count = rows.len() * 320 * 4;
            let sum: f64 = rows.flat_map(row).map(|i| f64::from(now[i].abs_diff(then[i]))).sum();
            sum / count as f64
        };
        let far = mean_change(85..92);
        assert!(far < 2.0, "{word}: the horizon changes by {far} levels in 1/30 s");
        assert!(mean_change(120..180) > 0.2, "{word}: the near sea stands still");
    }
}

/// The same of the ocean's scenes as they are, towards the sun where they look there: docs/spectral-ocean.md states the bound.
#[test]
fn the_horizon_of_every_sea_is_calm() {
    let Some(gpu) = gpu() else { return };
    for name in SEAS {
        let scene = whitecap_scene::open(name).unwrap();
        let (width, height) = (320, 180);
        let picture = |time_s| {
            let request = PictureRequest { backend: None, width, height, time_s };
            render_picture(gpu, &scene, &request, &mut |_| {}).unwrap().rgba8
        };
        let [eye, look_at] = [scene.camera.position_m, scene.camera.look_at_m].map(DVec3::from);
        let toward = (look_at - eye).normalize();
        let slope = toward.y / toward.x.hypot(toward.z) + (2.0 * eye.y / 6.371e6).sqrt();
        let half = (0.5 * scene.camera.vertical_fov_deg).to_radians().tan();
        // The first row under the horizon.
        let first = (90.0 * (1.0 + slope / half)).ceil() as usize;
        for time_s in [10.0, 100.0] {
            let (now, then) = (picture(time_s), picture(time_s + 1.0 / 30.0));
            let row = |y: usize| y * 320 * 4..(y + 1) * 320 * 4;
            let mean_change = |rows: std::ops::Range<usize>| {
                let count = (rows.len() * 320 * 3) as f64;
                rows.flat_map(row).map(|i| f64::from(now[i].abs_diff(then[i]))).sum::<f64>() / count
            };
            let (far, near) = (mean_change(first - 1..first + 6), mean_change(first + 30..180));
            println!("{name} at {time_s} s: horizon in row {first}, {far:.2} levels, near {near:.2}");
            assert!(far < 1.0, "{name}: the horizon changes by {far} levels in 1/30 s");
            assert!(near > 0.2, "{name}: the near sea stands still");
        }
    }
}

#[test]
fn targets_that_store_linear_light_look_the_same() {
    let Some(gpu) = gpu() else { return };
    for scene in scene_of_each_technique() {
        let view = View::of_camera(&scene.camera, SIZE);
        let shot = |target: TargetFormat| {
            let mut water = Water::new(&gpu.device, &gpu.queue, &scene, target).unwrap();
            frame(gpu, &mut water, &target, view, 1.0, true)
        };
        let raw = shot(TargetFormat::default());
        let srgb = TargetFormat { color: wgpu::TextureFormat::Rgba8UnormSrgb, ..TargetFormat::default() };
        let difference = largest_difference(&raw, &shot(srgb));
        assert!(difference <= 2, "{}: {difference} levels", scene.technique.word());
    }
    let usual_depth = TargetFormat { depth_compare: wgpu::CompareFunction::Less, ..TargetFormat::default() };
    assert!(usual_depth.far_depth() == 1.0 && TargetFormat::default().far_depth() == 0.0);
}

/// A host with the usual depth, near 0 and far 1, gets the same picture.
#[test]
fn the_sense_of_depth_does_not_matter() {
    let Some(gpu) = gpu() else { return };
    for scene in scene_of_each_technique() {
        let reversed = View::of_camera(&scene.camera, SIZE);
        let aspect = SIZE[0] as f32 / SIZE[1] as f32;
        let fov = scene.camera.vertical_fov_deg.to_radians() as f32;
        let usual = View {
            clip_from_view: glam::camera::rh::proj::directx::perspective(fov, aspect, 0.1, 1e5),
            ..reversed
        };
        let shot = |target: TargetFormat, view: View| {
            let mut water = Water::new(&gpu.device, &gpu.queue, &scene, target).unwrap();
            frame(gpu, &mut water, &target, view, 1.0, true)
        };
        let target = TargetFormat { depth_compare: wgpu::CompareFunction::Less, ..TargetFormat::default() };
        let (a, b) = (shot(TargetFormat::default(), reversed), shot(target, usual));
        // Along silhouettes and the horizon a pixel may fall to either side.
        let unequal = a.chunks(4).zip(b.chunks(4)).filter(|(a, b)| largest_difference(a, b) > 12).count();
        let word = scene.technique.word();
        assert!(unequal * 50 < a.len() / 4, "{word}: {unequal} pixels of {} differ", a.len() / 4);
    }
}

/// The sun's path on the water lies under the sun, and moves with it.
#[test]
fn the_glitter_lies_under_the_sun() {
    let Some(gpu) = gpu() else { return };
    let mut scene = scene();
    // Looking west, 53° wide.
    scene.camera.look_at_m = [-200.0, 0.0, 0.0];
    for sun_azimuth_deg in [255.0, 270.0, 288.0] {
        let whitecap_scene::Sky::Atmosphere(sky) = &mut scene.sky else { panic!() };
        sky.sun_azimuth_deg = sun_azimuth_deg;
        sky.cloud_cover = 0.0;
        let request = PictureRequest { backend: None, width: 160, height: 90, time_s: 5.0 };
        let picture = render_picture(gpu, &scene, &request, &mut |_| {}).unwrap().rgba8;
        let mut weighted = 0.0;
        let mut total = 0.0;
        for (i, pixel) in picture.chunks(4).enumerate() {
            let (x, y) = (i % 160, i / 160);
            // Glints alone: below the horizon and nearly white.
            if y > 46 && pixel[..3].iter().all(|&c| c > 200) {
                weighted += x as f64 + 0.5;
                total += 1.0;
            }
        }
        assert!(total > 20.0, "no glitter with the sun at {sun_azimuth_deg}°");
        let half_width = 80.0 / (22.5_f64.to_radians().tan() * 160.0 / 90.0);
        let expected = 80.0 + half_width * (sun_azimuth_deg - 270.0).to_radians().tan();
        let mean = weighted / total;
        assert!((mean - expected).abs() < 12.0, "the path lies at {mean}, the sun at {expected}");
    }
}

/// Every setting of the scene does something to the picture.
#[test]
fn no_setting_is_without_effect() {
    let Some(gpu) = gpu() else { return };
    let base = whitecap_scene::named::find("meshuggah").unwrap().toml;
    let render = |toml: &str| {
        let scene = Scene::from_toml(toml, "test.toml").unwrap_or_else(|e| panic!("{e}"));
        let request = PictureRequest { backend: None, width: 96, height: 54, time_s: 1.0 };
        render_picture(gpu, &scene, &request, &mut |_| {}).unwrap().rgba8
    };
    let before = render(base);
    let table = base.replace("water_color = \"lerp\"", "water_color = \"nishita-nakamae\"");
    let before_table = render(&table);
    let changes = [
        ("seed = 7", "seed = 8"),
        ("tile_size_m = 150.0", "tile_size_m = 170.0"),
        ("resolution = 64", "resolution = 128"),
        ("choppiness = 1.0", "choppiness = 0.4"),
        ("wind_speed_mps = 9.0", "wind_speed_mps = 8.0"),
        ("from_deg = 250.0", "from_deg = 200.0"),
        ("tile_repeats = 4", "tile_repeats = 2"),
        ("bump_repeats = 63.0", "bump_repeats = 40.0"),
        ("exposure = 1.5", "exposure = 1.0"),
        ("fresnel = \"per-vertex-split\"", "fresnel = \"per-pixel\""),
        ("water_color = \"lerp\"", "water_color = \"nishita-nakamae\""),
        ("deep_color = [0.0,", "deep_color = [0.3,"),
        ("grazing_color = [0.0,", "grazing_color = [0.3,"),
        ("visibility_km = 12.0", "visibility_km = 2.0"),
        ("tile_repeats = 4", "tile_repeats = 4\ncurvature_radius_km = 20.0"),
        ("sun_azimuth_deg = 255.0", "sun_azimuth_deg = 250.0"),
        ("sun_elevation_deg = 16.0", "sun_elevation_deg = 30.0"),
        ("kind = \"atmosphere\"", "kind = \"atmosphere\"\nhaze = 4.0"),
        ("kind = \"atmosphere\"", "kind = \"atmosphere\"\ncloud_cover = 0.9"),
        ("kind = \"atmosphere\"", "kind = \"atmosphere\"\nexposure_ev = 1.0"),
        ("position_m = [0.0, 4.0, 0.0]", "position_m = [0.0, 5.0, 0.0]"),
        ("vertical_fov_deg = 45.0", "vertical_fov_deg = 50.0"),
        ("from_deg = 250.0", "from_deg = 250.0\nsignificant_height_m = 3.0"),
        ("from_deg = 250.0", "from_deg = 250.0\nopposing_energy = 1.0"),
        ("from_deg = 250.0", "from_deg = 250.0\nsmall_wave_cutoff_m = 2.0"),
        ("choppiness = 1.0", "choppiness = 1.0\namplitudes = \"gaussian\""),
    ];
    for (from, to) in changes {
        assert!(base.contains(from), "the scene has no {from}");
        assert_ne!(render(&base.replacen(from, to, 1)), before, "{to} changes nothing");
    }
    for to in
        ["bottom_depth_m = 3.0", "scattering_per_m = [0.01, 0.01, 0.01]\nextinction_per_m = [0.5, 0.1, 0.1]"]
    {
        let changed = table.replacen("tile_repeats = 4", &format!("tile_repeats = 4\n{to}"), 1);
        assert_ne!(render(&changed), before_table, "{to} changes nothing");
    }
}

/// The same for the settings that only the spectral ocean has.
#[test]
fn no_setting_of_the_ocean_is_without_effect() {
    let Some(gpu) = gpu() else { return };
    let base = whitecap_scene::named::find("spectral-ocean").unwrap().toml;
    let render = |toml: &str| {
        let scene = Scene::from_toml(toml, "test.toml").unwrap_or_else(|e| panic!("{e}"));
        let request = PictureRequest { backend: None, width: 96, height: 54, time_s: 1.0 };
        render_picture(gpu, &scene, &request, &mut |_| {}).unwrap().rgba8
    };
    let before = render(base);
    let changes = [
        ("water = \"jerlov-ib\"", "water = \"jerlov-5c\""),
        ("water = \"jerlov-ib\"", "scattering_per_m = [0.07, 0.1, 0.1]"),
        ("water = \"jerlov-ib\"", "absorption_per_m = [0.4, 0.1, 0.3]"),
        ("water = \"jerlov-ib\"", "water = \"jerlov-ib\"\ncurvature_radius_km = 20.0"),
        ("[camera]", "[picture]\nexposure_ev100 = 12.0\n\n[camera]"),
        ("[camera]", "[picture]\ntone_map = \"aces\"\n\n[camera]"),
        ("[camera]", "[picture]\ntone_map = \"pbr-neutral\"\n\n[camera]"),
        ("[camera]", "[picture]\ntone_map = \"none\"\n\n[camera]"),
        ("model = \"spectral\"", "model = \"spectral\"\ndepth_m = 3.0"),
        ("model = \"spectral\"", "model = \"spectral\"\ncascades = 1"),
        ("model = \"spectral\"", "model = \"spectral\"\ncascades = 3"),
        ("model = \"spectral\"", "model = \"spectral\"\nresolution = 128"),
        ("model = \"spectral\"", "model = \"spectral\"\ntile_size_m = 700.0"),
        ("model = \"spectral\"", "model = \"spectral\"\nshortest_wave_m = 1.0"),
        ("from_deg = 330.0", "from_deg = 300.0"),
    ];
    for (from, to) in changes {
        assert!(base.contains(from), "the scene has no {from}");
        assert_ne!(render(&base.replacen(from, to, 1)), before, "{to} changes nothing");
    }
}

/// A generator that is good enough to scatter cameras.
struct Lcg(u64);

impl Lcg {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}
