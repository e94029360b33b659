use super::gpu::GpuOceanWater;
use super::*;
use crate::environment::Environment;
use crate::gpu::for_tests::{Canvas, compute, gpu};
use crate::gpu::read_buffer;
use crate::gpu::resources::bind_group;
use crate::pass::Objects;
use crate::shader_lib::{self, layout::assert_layout};
use crate::uniforms::Shared;
use crate::{Gpu, TargetFormat, Water};
use glam::{Vec3, Vec3Swizzles};
use whitecap_scene::{Camera, Scene};
use whitecap_waves::model::Surface;
use whitecap_waves::optics::classics::{BumpFrame, HIGHLIGHT_COLOR, ocean_water_pixel};

#[test]
fn rust_and_wgsl_agree_about_layout() {
    let wgsl = shader_lib::OCEAN_WATER.wgsl;
    assert_layout!(
        GpuOceanWater,
        wgsl,
        "GpuOceanWater",
        [sines, centre_bump_uv, centre_from_eye, glow, highlight_color, bumps_per_m]
    );
    assert_layout!(
        PixelInput,
        shader_lib::OCEAN_WATER_TWINS.wgsl,
        "PixelInput",
        [first, second, toward_eye, frame, sky, water, highlight]
    );
}

/// Position, binormal, tangent, normal.
type VertexOutput = [[f32; 4]; 4];

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct PixelInput {
    first: [f32; 4],
    second: [f32; 4],
    toward_eye: [f32; 4],
    frame: [[f32; 4]; 3],
    sky: [f32; 4],
    water: [f32; 4],
    highlight: [f32; 4],
}

/// Bump and N·V, reflection and address, colour and sparkle.
type PixelOutput = [[f32; 4]; 3];

fn close(seen: f32, expected: f64, tolerance: f64) {
    assert!((f64::from(seen) - expected).abs() <= tolerance, "{seen} instead of {expected}");
}

fn close3(seen: [f32; 4], expected: DVec3, tolerance: f64) {
    for (seen, expected) in seen.into_iter().zip(expected.to_array()) {
        close(seen, expected, tolerance);
    }
}

fn pixel(first: [f32; 3], second: [f32; 3], toward_eye: [f32; 3]) -> PixelInput {
    let four = |[x, y, z]: [f32; 3]| [x, y, z, 0.0];
    PixelInput {
        first: four(first),
        second: four(second),
        toward_eye: four(toward_eye),
        frame: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]],
        sky: [0.7, 0.85, 0.95, -1.0],
        water: [0.1, 0.3, 0.35, 0.0],
        highlight: four(HIGHLIGHT_COLOR.map(|c| c as f32)),
    }
}

#[test]
fn golden_pixels() {
    let Some(gpu) = gpu() else { return };
    let inputs = [
        pixel([0.5, 0.5, 1.0], [0.5, 0.5, 1.0], [0.0, 0.0, 1.0]),
        pixel([0.6, 0.45, 0.9], [0.5, 0.55, 1.0], [0.6, 0.0, 0.8]),
        pixel([0.8, 0.3, 0.85], [0.7, 0.4, 0.9], [0.9798, 0.0, 0.2]),
    ];
    let seen: Vec<PixelOutput> = compute(gpu, &shader_lib::OCEAN_WATER_TWINS, "cs_pixel", &inputs);
    let goldens = [
        ([0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 1.0, 1.0], [0.267992, 0.357093, 0.343944, 0.272491]),
        ([0.05, 0.0, 0.9, 0.75], [-0.525, 0.0, 0.55, 1.0], [0.298617, 0.402249, 0.400350, 0.272491]),
        (
            [0.25, -0.15, 0.85, 0.41495],
            [-0.772325, -0.124485, 0.505415, 0.8299],
            [0.339661, 0.462767, 0.475946, 0.272491],
        ),
    ];
    for (seen, (bump, reflection, color)) in seen.into_iter().zip(goldens) {
        for (seen, expected) in seen.into_iter().zip([bump, reflection, color]) {
            for (seen, expected) in seen.into_iter().zip(expected) {
                close(seen, expected, 1e-5);
            }
        }
    }
}

/// The pixel stage against its f64 twin in frames that are neither straight nor of length 1, and from behind; and
/// with a glow in place of the green.
#[test]
fn pixels_equal_their_twins() {
    let Some(gpu) = gpu() else { return };
    let inputs: Vec<PixelInput> = (0..300)
        .map(|i| {
            let wave = |k: f32| 0.5 + 0.5 * (k * i as f32 + k).sin();
            let signed = |k: f32| 2.0 * wave(k) - 1.0;
            let mut input = pixel(
                [wave(0.3), wave(0.7), wave(1.1)],
                [wave(1.3), wave(1.7), wave(1.9)],
                Vec3::new(signed(2.3), signed(2.9), signed(3.1)).normalize_or(Vec3::Z).to_array(),
            );
            input.frame = [
                [0.98, signed(3.7) * 0.2, signed(4.1) * 0.2, 0.0],
                [signed(4.3) * 0.2, 0.97, signed(4.7) * 0.2, 0.0],
                [signed(5.3) * 0.2, signed(5.9) * 0.2, 0.95, 0.0],
            ];
            input.sky = [wave(6.1), wave(6.7), wave(7.1), if i % 3 == 0 { wave(7.3) } else { -1.0 }];
            input
        })
        .collect();
    let seen: Vec<PixelOutput> = compute(gpu, &shader_lib::OCEAN_WATER_TWINS, "cs_pixel", &inputs);
    for (input, [bump, reflection, color]) in inputs.iter().zip(seen) {
        let three = |v: [f32; 4]| [v[0], v[1], v[2]].map(f64::from);
        let column = |i: usize| DVec3::from(three(input.frame[i]));
        let frame = BumpFrame { binormal: column(0), tangent: column(1), normal: column(2) };
        let twin = ocean_water_pixel(
            three(input.first),
            three(input.second),
            three(input.toward_eye).into(),
            &frame,
            |_| three(input.sky),
            |_| three(input.water),
        );
        close3(bump, twin.bump, 1e-5);
        close(bump[3], twin.cos_view, 1e-5);
        close3(reflection, twin.reflection, 1e-5);
        close(reflection[3], twin.gradient_address, 1e-5);
        if input.sky[3] < 0.0 {
            close(color[3], twin.sparkle, 1e-5);
            close3(color, twin.color, 1e-5);
        } else {
            close(color[3], f64::from(input.sky[3]), 0.0);
            let glow = color[3] * Vec3::from(HIGHLIGHT_COLOR.map(|c| c as f32));
            close3(color, (twin.water + glow.as_dvec3()).min(DVec3::ONE), 1e-5);
        }
    }
}

fn scene(edits: &[(&str, &str)]) -> Scene {
    let mut toml = whitecap_scene::named::find("ocean-water").unwrap().toml.to_owned();
    for (from, to) in edits {
        assert!(toml.contains(from), "the scene has no {from}");
        toml = toml.replacen(from, to, 1);
    }
    Scene::from_toml(&toml, "test.toml").unwrap_or_else(|e| panic!("{e}"))
}

/// A sky that is quick to make: dark below, brighter towards the south, with a small lamp.
fn environment() -> &'static Environment {
    static ENVIRONMENT: std::sync::OnceLock<Environment> = std::sync::OnceLock::new();
    ENVIRONMENT.get_or_init(|| {
        let lamp = Vec3::new(-0.8, 0.4, 0.3).normalize();
        let radiance = |d: Vec3| {
            if d.dot(lamp) > 0.995 {
                Vec3::splat(100.0)
            } else {
                Vec3::new(0.2, 0.3, 0.4) * (1.0 + 0.5 * d.z)
            }
        };
        environment_of(radiance)
    })
}

fn environment_of(radiance: impl Fn(Vec3) -> Vec3 + Sync) -> Environment {
    Environment {
        cube: crate::environment::CubeMap::bake(radiance, None, 1),
        sun: None,
        irradiance: Vec3::ONE,
        skylight: Vec3::ONE,
        daylight: 1.0,
        light: None,
    }
}

fn view_of(eye_m: DVec3, toward: DVec3, size_px: [u32; 2]) -> View {
    let look_at_m = (eye_m + 100.0 * toward).to_array();
    View::of_camera(&Camera { position_m: eye_m.to_array(), look_at_m, vertical_fov_deg: 50.0 }, size_px)
}

fn with_technique(scene: &Scene, test: impl FnOnce(&Gpu, OceanWater)) {
    let Some(gpu) = gpu() else { return };
    let (device, queue) = (&gpu.device, &gpu.queue);
    let shared = Shared::new(device, queue, environment(), TargetFormat::default());
    let objects = Objects::new(device, queue, scene).unwrap();
    let whitecap_scene::Technique::OceanWater(settings) = &scene.technique else { panic!() };
    let build = Build::under_white_light(device, queue, scene, &shared, &objects);
    let technique = OceanWater::new(&build, settings).unwrap();
    test(gpu, technique);
}

/// Runs the vertex stage's own function over (east, south, damping, unused) and reads position and frame.
fn read_vertices(gpu: &Gpu, uniforms: &GpuOceanWater, places: &[[f32; 4]]) -> Vec<VertexOutput> {
    let (device, queue) = (&gpu.device, &gpu.queue);
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: None,
        layout: None,
        module: &shader_lib::OCEAN_WATER_VERTICES.module(device),
        entry_point: Some("cs_raise"),
        compilation_options: Default::default(),
        cache: None,
    });
    use wgpu::BufferUsages as U;
    let make = |bytes: &[u8], usage| crate::gpu::resources::buffer(device, queue, "test", bytes, usage);
    let uniforms = make(bytemuck::bytes_of(uniforms), U::UNIFORM);
    let input = make(bytemuck::cast_slice(places), U::STORAGE);
    let output = make(&vec![0; places.len() * size_of::<VertexOutput>()], U::STORAGE | U::COPY_SRC);
    let group = |index, resources: Vec<wgpu::BindingResource<'_>>| {
        bind_group(device, "test", &pipeline.get_bind_group_layout(index), resources)
    };
    let ocean = group(2, vec![uniforms.as_entire_binding()]);
    let io = group(3, vec![input.as_entire_binding(), output.as_entire_binding()]);
    let mut encoder = device.create_command_encoder(&Default::default());
    {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(2, &ocean, &[]);
        pass.set_bind_group(3, &io, &[]);
        pass.dispatch_workgroups((places.len() as u32).div_ceil(64), 1, 1);
    }
    queue.submit([encoder.finish()]);
    bytemuck::pod_collect_to_vec(&read_buffer(device, queue, &output).unwrap())
}

/// What is drawn is the model, in the world's axes: near, 1,000 km away and after many days.
#[test]
fn drawn_vertices_are_the_model() {
    let mended = ("slope_factor = 0.003", "slope_factor = 0.003\ntaylor = \"mended\"");
    for edits in [&[][..], &[mended]] {
        drawn_vertices_are_the_model_of(&scene(edits));
    }
}

fn drawn_vertices_are_the_model_of(scene: &Scene) {
    with_technique(scene, |gpu, technique| {
        let eyes = [
            (DVec3::new(0.0, 7.0, 0.0), 0.0),
            (DVec3::new(5.3, 2.5, -71.9), 3.7),
            (DVec3::new(1_000_000.4, 40.0, -999_999.7), 20.0),
            (DVec3::new(-123_456.7, 3.0, 654_321.1), -1e6),
            (DVec3::new(77.0, 900.0, 1e6), 999_999.9),
        ];
        for (eye, time_s) in eyes {
            let view = view_of(eye, DVec3::X, [64, 36]);
            let centre = technique.mesh.centre_m(DVec2::new(eye.x, eye.z));
            let places: Vec<[f32; 4]> = technique.mesh.coarse.iter().map(|p| [p.x, p.y, 0.0, 0.0]).collect();
            let seen = read_vertices(gpu, &technique.uniforms(&view, time_s), &places);
            for (place, [position, binormal, tangent, normal]) in places.iter().zip(seen) {
                let rest = centre + DVec2::new(f64::from(place[0]), f64::from(place[1]));
                let height_m = technique.sines.sample(rest, time_s).displacement_m.y;
                close3(position, DVec3::new(rest.x, height_m, rest.y) - eye, 2e-4);
                let twin = technique.sines.at_uv(technique.sines.uv(rest), time_s, 0.0);
                close3(normal, twin.normal, 1e-4);
                close3(binormal, twin.binormal, 1e-4);
                close3(tangent, twin.tangent, 1e-4);
            }
        }
    });
}

/// At a damping of 1 the plane is left, wherever; half of it halves the height.
#[test]
fn damping_goes_from_all_of_the_waves_to_none() {
    with_technique(&scene(&[]), |gpu, technique| {
        let view = view_of(DVec3::new(10.0, 5.0, 3.0), DVec3::X, [64, 36]);
        let places = [0.0, 0.5, 1.0].map(|damp| [12.5, -31.0, damp, 0.0]);
        let seen = read_vertices(gpu, &technique.uniforms(&view, 2.0), &places);
        let height = |i: usize| f64::from(seen[i][0][1]) + 5.0;
        assert!(height(0).abs() > 0.1);
        assert!((height(1) - 0.5 * height(0)).abs() < 1e-5 && height(2).abs() < 1e-6);
        assert_eq!(seen[2][3], [0.0, 0.0, 1.0, 0.0]);
    });
}

/// The bump maps lie still in the world when the viewer moves, and scroll with time.
#[test]
fn bump_maps_stay_in_their_places() {
    let scene = scene(&[("bump_repeats = 1.5", "bump_repeats = 2.5")]);
    with_technique(&scene, |_, technique| {
        let whitecap_scene::Technique::OceanWater(settings) = &scene.technique else { panic!() };
        for (eye, time_s) in [(DVec3::new(3.0, 4.0, 50.0), 0.0), (DVec3::new(1e6, 3.0, -2e6), 1e6 + 0.5)] {
            let uniforms = technique.uniforms(&view_of(eye, DVec3::X, [64, 36]), time_s);
            let centre = technique.mesh.centre_m(DVec2::new(eye.x, eye.z));
            let uv = technique.sines.uv(centre) * 2.5;
            let [u0, v0] = settings.first_scroll_per_s;
            let [u1, v1] = settings.second_scroll_per_s;
            let expected = [uv.x + u0 * time_s, uv.y + v0 * time_s, uv.x + u1 * time_s, uv.y + v1 * time_s];
            for (seen, expected) in uniforms.centre_bump_uv.into_iter().zip(expected) {
                let off = (f64::from(seen) - expected).rem_euclid(1.0);
                assert!(off.min(1.0 - off) < 1e-5, "{seen} {expected}");
            }
        }
    });
}

/// No water and no sky has this colour.
const NOTHING: wgpu::Color = wgpu::Color { r: 1.0, g: 0.0, b: 1.0, a: 1.0 };

/// The water alone, one sample a pixel.
fn frame(gpu: &Gpu, water: &mut Water, view: View, time_s: f64) -> Vec<u8> {
    let (device, queue) = (&gpu.device, &gpu.queue);
    let canvas = Canvas::new(gpu, &TargetFormat::default(), view.size_px);
    let mut encoder = device.create_command_encoder(&Default::default());
    water.prepare(device, queue, &mut encoder, &[view], time_s).unwrap();
    canvas.draw(&mut encoder, NOTHING, |pass| water.draw(pass, 0));
    queue.submit([encoder.finish()]);
    canvas.pixels()
}

fn water(gpu: &Gpu, scene: &Scene, environment: &Environment) -> Water {
    Water::with_environment(&gpu.device, &gpu.queue, scene, environment, TargetFormat::default()).unwrap()
}

/// For cameras of all heights above the waves: water wherever the ray goes below the horizon, none above it.
#[test]
fn water_is_where_it_should_be_for_every_camera() {
    let Some(gpu) = gpu() else { return };
    const SIZE: [u32; 2] = [64, 36];
    let mut water = water(gpu, &scene(&[]), environment());
    let random = |i: usize, k: f64| (0.5 + 0.5 * (12.9898 * i as f64 + k).sin() * 43.758).rem_euclid(1.0);
    for camera in 0..40 {
        let height = [2.0, 6.0, 30.0, 400.0, 9_000.0][camera % 5] * (1.0 + random(camera, 0.1));
        let pitch: f64 = match camera % 4 {
            0 => -90.0,
            1 => -60.0 * random(camera, 0.2),
            2 => 60.0 * random(camera, 0.3),
            _ => -2.0,
        };
        let (azimuth, pitch) = (std::f64::consts::TAU * random(camera, 0.4), pitch.to_radians());
        let toward = DVec3::new(azimuth.cos() * pitch.cos(), pitch.sin(), azimuth.sin() * pitch.cos());
        let eye = DVec3::new(1e4 * random(camera, 0.5), height, -1e4 * random(camera, 0.6));
        let view = view_of(eye, toward, SIZE);
        let pixels = frame(gpu, &mut water, view, 40.0 * random(camera, 0.7));
        let world_from_clip = view.clip_from_eye_world().inverse();
        // Waves of up to 2 m stand before the horizon's last pixels.
        let margin = 3.0 * f64::from(view.pixel_angle_rad()) + (2.0 / height).min(0.5);
        for (i, pixel) in pixels.chunks(4).enumerate() {
            let (x, y) = (i as u32 % SIZE[0], i as u32 / SIZE[0]);
            let ndc_x = (x as f32 + 0.5) / SIZE[0] as f32 * 2.0 - 1.0;
            let ndc_y = 1.0 - (y as f32 + 0.5) / SIZE[1] as f32 * 2.0;
            let ray = world_from_clip.project_point3(Vec3::new(ndc_x, ndc_y, 0.5)).normalize();
            let elevation = f64::from(ray.y.clamp(-1.0, 1.0)).asin();
            let nothing = pixel[..3] == [255, 0, 255];
            if elevation < -margin {
                assert!(!nothing, "camera {camera} at {eye}: no water at ({x}, {y}), {elevation} rad");
            }
            if elevation > margin {
                assert!(nothing, "camera {camera} at {eye}: water in the sky at ({x}, {y}), {elevation} rad");
            }
        }
    }
}

/// Still, smooth water straight below under an even sky, by hand through all of the chain: the 8-bit sky, the
/// gradient's end, the level texel of the bump map.
#[test]
fn level_water_is_the_sum_that_the_text_gives() {
    let Some(gpu) = gpu() else { return };
    let sky = Vec3::new(0.4, 0.6, 5.0);
    let even = environment_of(|_| sky);
    for highlights in ["green-power", "glow-map"] {
        let mut scene = scene(&[
            ("bump_steepness = 0.35", "bump_steepness = 0.0"),
            ("\"green-power\"", &format!("{highlights:?}")),
        ]);
        let whitecap_scene::Technique::OceanWater(settings) = &mut scene.technique else { panic!() };
        settings.deep_color = [0.0, 0.4, 0.2];
        let settings = settings.clone();
        let eye = DVec3::new(0.0, 2_000.0, 0.0);
        let pixels = frame(gpu, &mut water(gpu, &scene, &even), view_of(eye, DVec3::NEG_Y, [33, 33]), 0.0);
        let seen = &pixels[4 * (16 * 33 + 16)..][..3];

        // No encoding of 0 lies in 8 bits: level water is 128 of 255.
        let level = [128.0 / 255.0, 128.0 / 255.0, 1.0];
        let frame = BumpFrame { binormal: DVec3::X, tangent: DVec3::Y, normal: DVec3::Z };
        let in_8_bits = |linear: f32| {
            f64::from((crate::environment::display_from_linear(linear).min(1.0) * 255.0).round()) / 255.0
        };
        let environment = |_| sky.to_array().map(in_8_bits);
        let twin = ocean_water_pixel(level, level, DVec3::Z, &frame, environment, |_| settings.deep_color);
        let sparkle = match highlights {
            "green-power" => twin.sparkle,
            _ => f64::from(crate::environment::glow(sky)),
        };
        let expected = (twin.water + sparkle * DVec3::from(settings.highlight_color)).min(DVec3::ONE);
        for (seen, expected) in seen.iter().zip(expected.to_array()) {
            let expected = 255.0 * expected;
            assert!((f64::from(*seen) - expected).abs() < 2.0, "{highlights}: {seen} instead of {expected}");
        }
    }
}

/// Every setting of the scene does something to the picture.
#[test]
fn no_setting_is_without_effect() {
    let Some(gpu) = gpu() else { return };
    let island = "[[object]]\nmesh = \"island\"\nposition_m = [-100.0, 0.0, 30.0]\n\n[sky]";
    let view = view_of(DVec3::new(0.0, 5.0, 0.0), DVec3::new(-1.0, -0.2, 0.3), [96, 54]);
    let render = |edits: &[(&str, &str)]| {
        let edits = [&[("[sky]", island)], edits].concat();
        frame(gpu, &mut water(gpu, &scene(&edits), environment()), view, 1.3)
    };
    let before = render(&[]);
    let add = "[ocean-water]";
    let changes = [
        ("seed = 11", "seed = 12"),
        ("unit_m = 0.01", "unit_m = 0.012"),
        ("slope_factor = 0.003", "slope_factor = 0.006"),
        ("slope_factor = 0.003", "slope_factor = 0.003\nuv_size_m = 300.0"),
        ("slope_factor = 0.003", "slope_factor = 0.003\ntaylor = \"mended\""),
        ("bump_steepness = 0.35", "bump_steepness = 0.3"),
        ("bump_repeats = 1.5", "bump_repeats = 2.0"),
        ("edge_color = [0.05,", "edge_color = [0.3,"),
        ("middle_color = [0.04,", "middle_color = [0.3,"),
        ("deep_color = [0.02,", "deep_color = [0.3,"),
        ("\"green-power\"", "\"glow-map\""),
        ("highlight_color = [0.8,", "highlight_color = [0.2,"),
        (add, "[ocean-water]\ngrid_cells = 16"),
        (add, "[ocean-water]\ncell_m = 5.0"),
        (add, "[ocean-water]\ncell_growth = 1.0"),
        (add, "[ocean-water]\nrefinement = 1"),
        (add, "[ocean-water]\nshore_depth_m = 0.5"),
        (add, "[ocean-water]\ntangent = \"mended\""),
        (add, "[ocean-water]\nbump_resolution = 128"),
        (add, "[ocean-water]\nbump_ripples = 8.0"),
        (add, "[ocean-water]\nfirst_scroll_per_s = [0.1, 0.04]"),
        (add, "[ocean-water]\nsecond_scroll_per_s = [-0.03, 0.1]"),
    ];
    for change in changes {
        assert_ne!(render(&[change]), before, "{} changes nothing", change.1);
    }
}

/// Brighter to the east, and less so to the south. Green makes the sparkles, which tell a reflection's direction.
fn slanted_sky(direction: Vec3) -> Vec3 {
    let display = 0.65 + 0.4 * direction.x + 0.15 * direction.z;
    Vec3::splat(crate::environment::linear_from_display(display.clamp(0.0, 1.0)))
}

/// A level of the bump map at a place in the whole map's units, bilinear.
fn bump_texel(level: &[[u8; 4]], place: DVec2) -> DVec3 {
    let size = level.len().isqrt();
    let texel = |u: f64, v: f64| {
        let [u, v] = [u, v].map(|c| (c as i64).rem_euclid(size as i64) as usize);
        DVec3::from([0, 1, 2].map(|c| f64::from(level[v * size + u][c]) / 255.0))
    };
    let at = place * size as f64 - 0.5;
    let corner = at.floor();
    let within = at - corner;
    let row = |v: f64| texel(corner.x, v).lerp(texel(corner.x + 1.0, v), within.x);
    row(corner.y).lerp(row(corner.y + 1.0), within.y)
}

/// How far a picture of level water is from the model that reads this level of the bump map, mean of absolute
/// differences in steps of 255, and how far its own pixels are from their mean.
fn off_the_model(scene: &Scene, view: &View, time_s: f64, pixels: &[u8], level: &[[u8; 4]]) -> (f64, f64) {
    let whitecap_scene::Technique::OceanWater(settings) = &scene.technique else { panic!() };
    let SeaSurface::Sines(sines) = scene.sea.build(scene.seed).unwrap() else { panic!() };
    let ([u0, v0], [u1, v1]) = (settings.first_scroll_per_s, settings.second_scroll_per_s);
    let gradient = artwork::gradient(settings);
    let sky = |d: DVec3| {
        let linear = slanted_sky(d.as_vec3().normalize().xzy());
        linear.to_array().map(|c| f64::from(crate::environment::display_from_linear(c)))
    };
    let water = |address: f64| {
        let texel = gradient[(address * (gradient.len() - 1) as f64).round() as usize];
        [0, 1, 2].map(|c| f64::from(texel[c]) / 255.0)
    };
    let level_frame = BumpFrame { binormal: DVec3::X, tangent: DVec3::Y, normal: DVec3::Z };
    let world_from_clip = view.clip_from_eye_world().inverse();
    let [width, height] = view.size_px;
    let count = f64::from(width * height);
    let mean = pixels.chunks(4).map(|pixel| f64::from(pixel[1])).sum::<f64>() / count;
    let (mut off, mut contrast) = (0.0, 0.0);
    for (i, pixel) in pixels.chunks(4).enumerate() {
        let (x, y) = (i as u32 % width, i as u32 / width);
        let ndc_x = (x as f32 + 0.5) / width as f32 * 2.0 - 1.0;
        let ndc_y = 1.0 - (y as f32 + 0.5) / height as f32 * 2.0;
        let ray = world_from_clip.project_point3(Vec3::new(ndc_x, ndc_y, 0.5)).as_dvec3().normalize();
        let place = view.eye_m + ray * (view.eye_m.y / -ray.y);
        let uv = sines.uv(DVec2::new(place.x, place.z)) * settings.bump_repeats;
        let [first, second] =
            bump_coordinates(uv, time_s, [u0, v0, u1, v1]).map(|place| bump_texel(level, place).to_array());
        let twin = ocean_water_pixel(first, second, -ray.xzy(), &level_frame, sky, water);

        off += (f64::from(pixel[1]) - 255.0 * twin.color.y).abs() / count;
        contrast += (f64::from(pixel[1]) - mean).abs() / count;
    }
    (off, contrast)
}

/// Level water under two bump maps, so large that the mesh is fine beside them: the view vector comes from vertices.
fn rippled_scene() -> Scene {
    scene(&[
        ("slope_factor = 0.003", "slope_factor = 0.0\nuv_size_m = 300.0"),
        ("unit_m = 0.01", "unit_m = 1e-6"),
    ])
}

/// So near that a texel covers several pixels, the picture is the model's: both maps at their places, the second
/// one turned over, and x of the bump along the binormal.
#[test]
fn what_is_drawn_near_by_is_what_the_model_says() {
    let Some(gpu) = gpu() else { return };
    let scene = rippled_scene();
    let environment = environment_of(slanted_sky);
    let mut water = water(gpu, &scene, &environment);
    let whitecap_scene::Technique::OceanWater(settings) = &scene.technique else { panic!() };
    let levels = artwork::bump_levels(settings, scene.seed).unwrap();
    for (eye, toward, time_s) in [
        (DVec3::new(3.1, 15.0, -8.3), DVec3::NEG_Y, 3.7),
        (DVec3::new(-7.0, 15.0, 20.3), DVec3::new(0.3, -1.0, 0.2).normalize(), 40.0),
    ] {
        let view = view_of(eye, toward, [48, 27]);
        let pixels = frame(gpu, &mut water, view, time_s);
        let (off, contrast) = off_the_model(&scene, &view, time_s, &pixels, &levels[0]);
        assert!(contrast > 4.0, "there are no ripples to compare: {contrast}");
        assert!(off < 2.5, "{off} steps off the model, of a contrast of {contrast}");
    }
}

/// Where a pixel covers four texels, the level of four texels is 2 and the text's bias makes it 1.
#[test]
fn the_bump_maps_are_read_one_level_finer() {
    let Some(gpu) = gpu() else { return };
    let scene = rippled_scene();
    let environment = environment_of(slanted_sky);
    let mut water = water(gpu, &scene, &environment);
    let whitecap_scene::Technique::OceanWater(settings) = &scene.technique else { panic!() };
    let levels = artwork::bump_levels(settings, scene.seed).unwrap();
    let size = [48, 27];
    let texel_m = 300.0 / settings.bump_repeats / f64::from(settings.bump_resolution);
    // Straight down every pixel covers the same square of water.
    let height_m = 4.0 * texel_m * f64::from(size[1]) / (2.0 * f64::to_radians(25.0).tan());
    let view = view_of(DVec3::new(3.1, height_m, -8.3), DVec3::NEG_Y, size);
    let pixels = frame(gpu, &mut water, view, 3.7);
    let off: Vec<f64> =
        levels[..5].iter().map(|level| off_the_model(&scene, &view, 3.7, &pixels, level).0).collect();
    let nearest = (0..off.len()).min_by(|&a, &b| off[a].total_cmp(&off[b]));
    assert_eq!(nearest, Some(1), "off the levels by {off:?}");
}
