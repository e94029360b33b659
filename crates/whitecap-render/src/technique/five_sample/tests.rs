#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use super::*;
use crate::gpu::Gpu;
use crate::gpu::for_tests::{Canvas, compute, gpu};
use crate::picture::{PictureRequest, render_picture};
use crate::shader_lib::{self, layout::assert_layout};
use crate::{TargetFormat, Water};
use glam::DVec3;
use whitecap_scene::{Camera, Scene, named};
use whitecap_waves::optics::classics::{
    FIVE_SAMPLE_DEFAULTS, FiveSampleConstants, five_sample_coordinates, five_sample_normal, five_sample_pixel,
};

#[test]
fn rust_and_wgsl_agree_about_layout() {
    for shader in [
        shader_lib::FIVE_SAMPLE,
        shader_lib::FIVE_SAMPLE_LATER,
        shader_lib::FIVE_SAMPLE_STAGES,
        shader_lib::FIVE_SAMPLE_DOME,
    ] {
        assert_layout!(
            GpuFiveSample,
            shader.wgsl,
            "GpuFiveSample",
            [
                centre_from_eye,
                exponent,
                toward_sun,
                sun_brightness,
                layers,
                emission,
                layer_count,
                reflection,
                options,
                diffuse_color,
                ambient,
                near_absorption,
                diffuse,
                far_absorption,
                sky_address,
                ground_from_eye,
                ground_points_per_m,
                extinction_per_m,
                distortion,
                shore_depth_m,
                swash_height_m,
                swash_turns,
                daylight,
            ]
        );
    }
}

/// Layout twin of `FiveSampleInput` in `twins.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct GpuInput {
    texels: [[f32; 4]; 5],
    toward_eye: [f32; 3],
    exponent: f32,
    toward_sun: [f32; 3],
    brightness: f32,
    emission: [f32; 4],
    reflection: [f32; 4],
    sky: [f32; 4],
}

fn input(
    texels: [[f64; 3]; 5],
    view: DVec3,
    sun: DVec3,
    sky: [f64; 3],
    with: &FiveSampleConstants,
) -> GpuInput {
    let four = |[r, g, b]: [f64; 3]| [r as f32, g as f32, b as f32, 0.0];
    GpuInput {
        texels: texels.map(four),
        toward_eye: view.as_vec3().to_array(),
        exponent: with.exponent as f32,
        toward_sun: sun.as_vec3().to_array(),
        brightness: with.sun as f32,
        emission: four(with.emission),
        reflection: four(with.reflection),
        sky: four(sky),
    }
}

/// Normal and Fresnel, colour and sun, then the sky's address and three functions of the shore.
fn run(gpu: &Gpu, inputs: &[GpuInput]) -> Vec<[[f32; 4]; 3]> {
    compute(gpu, &shader_lib::FIVE_SAMPLE_TWINS, "cs_pixel", inputs)
}

const SKY: [f64; 3] = [0.4, 0.6, 0.9];
const FLAT: [[f64; 3]; 5] = [[0.5, 0.5, 1.0]; 5];
const RIPPLED: [[f64; 3]; 5] =
    [[0.55, 0.5, 0.95], [0.48, 0.52, 0.97], [0.5, 0.45, 0.9], [0.6, 0.5, 0.9], [0.5, 0.5, 1.0]];

#[test]
fn golden_pixels_on_the_device() {
    let Some(gpu) = gpu() else { return };
    let sun = DVec3::new(1.0, 1.0, 0.0).normalize();
    let at = |texels, view: DVec3| input(texels, view.normalize(), sun, SKY, &FIVE_SAMPLE_DEFAULTS);
    let found = run(
        gpu,
        &[
            at(FLAT, DVec3::Y),
            at(FLAT, DVec3::new(1.0, 0.2, 0.0)),
            at(FLAT, DVec3::new(-1.0, 1.0, 0.0)),
            at(RIPPLED, DVec3::new(-1.0, 1.0, 0.0)),
        ],
    );
    // Fresnel, the sun's glint, the colour.
    let golden = [
        [0.0, 0.0, 0.1, 0.15, 0.12],
        [0.646229, 0.0, 0.203397, 0.305095, 0.420497],
        [0.085786, 7.0, 0.504054, 0.560917, 0.550219],
        [0.112560, 5.281984, 0.504460, 0.563465, 0.558791],
    ];
    for ([normal, color, _], golden) in found.iter().zip(golden) {
        let found = [normal[3], color[3], color[0], color[1], color[2]];
        for (found, golden) in found.iter().zip(golden) {
            // The glint's 40th power multiplies what 32 bits round.
            let allowed = if golden > 1.0 { 4e-5 } else { 1e-5 };
            assert!((f64::from(*found) - golden).abs() < allowed, "{found} for {golden}");
        }
    }
    let normal = Vec3::from_slice(&found[3][0][..3]);
    assert!(normal.distance(Vec3::new(0.058453, 0.998199, -0.013489)) < 1e-5, "{normal}");
}

/// A generator that is good enough to scatter inputs.
struct Lcg(u64);

impl Lcg {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn three(&mut self) -> [f64; 3] {
        [self.next(), self.next(), self.next()]
    }
}

#[test]
fn the_device_calculates_as_the_model_does() {
    let Some(gpu) = gpu() else { return };
    let mut random = Lcg(3);
    let cases: Vec<_> = (0..200)
        .map(|_| {
            let texels: [[f64; 3]; 5] = std::array::from_fn(|_| {
                let [x, y, z] = random.three();
                [0.3 + 0.4 * x, 0.3 + 0.4 * y, 0.7 + 0.3 * z]
            });
            let up = |[x, y, z]: [f64; 3]| DVec3::new(x - 0.5, 0.01 + y, z - 0.5).normalize();
            let constants = FiveSampleConstants {
                exponent: 1.0 + 60.0 * random.next(),
                emission: random.three(),
                reflection: random.three(),
                sun: 9.0 * random.next(),
            };
            (texels, up(random.three()), up(random.three()), random.three(), constants)
        })
        .collect();
    let inputs: Vec<_> =
        cases.iter().map(|(t, view, sun, sky, with)| input(*t, *view, *sun, *sky, with)).collect();
    for ([normal, color, more], (texels, view, sun, sky, with)) in run(gpu, &inputs).into_iter().zip(cases) {
        let model = five_sample_pixel(texels, view, sun, &with, |_| sky);
        let close = |a: f32, b: f64| (f64::from(a) - b).abs() < 2e-5 * (1.0 + 10.0 * b.abs());
        assert!(Vec3::from_slice(&normal[..3]).as_dvec3().distance(model.normal) < 1e-5);
        assert!(
            close(normal[3], model.fresnel) && close(color[3], model.sun),
            "{normal:?} {color:?} {model:?}"
        );
        assert!((0..3).all(|c| close(color[c], model.color[c])), "{color:?} {model:?}");
        let [x, y, z] = texels[0];
        let expected =
            [model.sky_address, later::shoal(x, y), later::swash_drop_m(z, x), later::swash_phase(x, z, y)];
        assert!((0..4).all(|i| close(more[i], expected[i])), "{more:?} {expected:?}");
    }
}

/// What a repeating map shows: coordinates are equal when they differ by whole tiles.
fn apart(a: DVec2, b: DVec2) -> f64 {
    let between = a - b;
    (between - between.round()).abs().max_element()
}

/// Far out and late, coordinates are those of the text, at 64 bits, to a thousandth of a texel or so.
#[test]
fn layers_keep_their_precision_everywhere_and_always() {
    let uv_size_m = 437.0;
    for eye in [DVec2::ZERO, DVec2::new(12.3, -7.7), DVec2::new(1.0e6, -1.0e6), DVec2::new(-9.9e6, 3.1e6)] {
        for time_s in [0.0, 3.7, 86_400.5, 1e6, -1e6] {
            for offset in [DVec2::ZERO, DVec2::new(-3.0, 5.5)] {
                let expected = five_sample_coordinates((eye + offset) / uv_size_m, time_s);
                for (layer, expected) in LAYERS.iter().zip(expected) {
                    let [u, v, per_m, across] = layer_uniform(layer, eye, uv_size_m, time_s).map(f64::from);
                    assert!((0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v));
                    let found = DVec2::new(
                        u + per_m * offset.x + across * offset.y,
                        v + per_m * offset.y - across * offset.x,
                    );
                    assert!(apart(found, expected) < 2e-6, "{layer:?} at {eye} and {time_s}");
                }
            }
        }
    }
}

const SIZE: [u32; 2] = [64, 36];

fn look(eye: DVec3, toward: DVec3) -> View {
    let look_at_m = (eye + toward * 100.0).to_array();
    View::of_camera(&Camera { position_m: eye.to_array(), look_at_m, vertical_fov_deg: 50.0 }, SIZE)
}

/// The water, and the sky if asked for, as one view's raw pixels; what nothing covers is magenta.
fn draw(gpu: &Gpu, water: &mut Water, view: View, time_s: f64, sky: bool) -> Vec<u8> {
    let (device, queue) = (&gpu.device, &gpu.queue);
    let canvas = Canvas::new(gpu, &TargetFormat::default(), SIZE);
    let mut encoder = device.create_command_encoder(&Default::default());
    water.prepare(device, queue, &mut encoder, &[view], time_s).unwrap();
    let magenta = wgpu::Color { r: 1.0, g: 0.0, b: 1.0, a: 1.0 };
    canvas.draw(&mut encoder, magenta, |pass| {
        water.draw_surface(pass, 0);
        if sky {
            water.draw_sky(pass, 0);
        }
    });
    queue.submit([encoder.finish()]);
    canvas.pixels()
}

fn water(gpu: &Gpu, toml: &str) -> Water {
    let scene = Scene::from_toml(toml, "test.toml").unwrap_or_else(|error| panic!("{error}"));
    Water::new(&gpu.device, &gpu.queue, &scene, TargetFormat::default()).unwrap()
}

fn scene_named(name: &str) -> &'static str {
    named::find(name).unwrap().toml
}

/// The direction of the ray through a pixel's middle.
fn ray(view: &View, x: u32, y: u32) -> Vec3 {
    let ndc = Vec3::new(
        (x as f32 + 0.5) / SIZE[0] as f32 * 2.0 - 1.0,
        1.0 - (y as f32 + 0.5) / SIZE[1] as f32 * 2.0,
        0.5,
    );
    view.clip_from_eye_world().inverse().project_point3(ndc).normalize()
}

/// So near that every texel covers several pixels, the picture is what the f64 model calculates from the map:
/// colour, and the Fresnel term in alpha.
#[test]
fn what_is_drawn_is_what_the_model_says() {
    let Some(gpu) = gpu() else { return };
    let toml = scene_named("five-sample");
    let scene = Scene::from_toml(toml, "test.toml").unwrap();
    let mut water = water(gpu, toml);
    let map = maps::MapRecipe::HandMade.levels(scene.seed, 1.0).unwrap().swap_remove(0);
    let whitecap_scene::Technique::FiveSample(settings) = &scene.technique else { panic!() };
    let sky = maps::sky_gradient([settings.zenith_color, settings.middle_color, settings.horizon_color], 1.0);
    let toward_sun = crate::environment::Environment::new(&scene).unwrap().sun.unwrap().toward.as_dvec3();
    let texel = |u: i64, v: i64| {
        let size = maps::MAP_SIZE as i64;
        let [r, g, b, _] = map[(v.rem_euclid(size) * size + u.rem_euclid(size)) as usize];
        DVec3::new(r.into(), g.into(), b.into()) / 255.0
    };
    let filtered = |coordinate: DVec2| {
        let place = coordinate * maps::MAP_SIZE as f64 - 0.5;
        let corner = place.floor();
        let t = place - corner;
        let (u, v) = (corner.x as i64, corner.y as i64);
        let row = |v: i64| texel(u, v).lerp(texel(u + 1, v), t.x);
        row(v).lerp(row(v + 1), t.y).to_array()
    };
    let sky_at = |address: f64| {
        let place = (address * maps::SKY_ENTRIES as f64 - 0.5).clamp(0.0, (maps::SKY_ENTRIES - 1) as f64);
        let low = place.floor() as usize;
        let high = (low + 1).min(maps::SKY_ENTRIES - 1);
        std::array::from_fn(|c| {
            let (a, b) = (f64::from(sky[low][c]), f64::from(sky[high][c]));
            (a + (b - a) * (place - low as f64)) / 255.0
        })
    };
    for (eye, toward, time_s) in [
        (DVec3::new(31.0, 0.25, -8.0), DVec3::new(0.01, -1.0, 0.0), 3.7),
        (DVec3::new(-1.0e6, 0.2, 5.0e5), DVec3::new(0.7, -1.0, -0.3), 1.0e6),
    ] {
        let view = look(eye, toward.normalize());
        let pixels = draw(gpu, &mut water, view, time_s, false);
        for (i, pixel) in pixels.chunks(4).enumerate().step_by(13) {
            let direction = ray(&view, i as u32 % SIZE[0], i as u32 / SIZE[0]).as_dvec3();
            let place = eye + direction * (eye.y / -direction.y);
            let tex_coord = DVec2::new(place.x, place.z) / settings.uv_size_m;
            let texels = five_sample_coordinates(tex_coord, time_s).map(filtered);
            let model = five_sample_pixel(texels, -direction, toward_sun, &FIVE_SAMPLE_DEFAULTS, sky_at);
            let expected = [model.color.x, model.color.y, model.color.z, model.fresnel];
            for (found, expected) in pixel.iter().zip(expected) {
                // The glint multiplies what the filter's fixed-point weights round.
                let allowed = if model.sun > 0.05 { 12.0 } else { 3.0 };
                let expected = expected.clamp(0.0, 1.0) * 255.0;
                assert!((f64::from(*found) - expected).abs() <= allowed, "{pixel:?} {expected} {model:?}");
            }
            assert!(five_sample_normal(texels).y > 0.5);
        }
    }
}

/// The map repeats after whole units of the texture coordinate: a thousand kilometres further on, at a multiple of
/// unit and cell, the picture is the same.
#[test]
fn a_thousand_kilometres_from_the_origin_nothing_trembles() {
    let Some(gpu) = gpu() else { return };
    for name in ["five-sample", "five-sample-01-blinn-phong", "five-sample-08-fresnel-fifth-layer"] {
        let mut water = water(gpu, scene_named(name));
        let (eye, toward) = (DVec3::new(12.3, 1.8, -45.6), DVec3::new(-1.0, -0.15, 0.3));
        let here = draw(gpu, &mut water, look(eye, toward), 3.0, true);
        let far = eye + DVec3::new(1_002_000.0, 0.0, -999_000.0);
        let there = draw(gpu, &mut water, look(far, toward), 3.0, true);
        let unequal = here.iter().zip(&there).filter(|(a, b)| a.abs_diff(**b) > 2).count();
        assert!(unequal * 500 < here.len(), "{name}: {unequal} of {} values differ", here.len());
    }
}

#[test]
fn water_is_where_it_should_be_for_every_camera() {
    let Some(gpu) = gpu() else { return };
    for name in ["five-sample", "five-sample-01-blinn-phong"] {
        let mut water = water(gpu, scene_named(name));
        let mut random = Lcg(1);
        for camera in 0..24 {
            let height = [0.4, 2.5, 30.0, 900.0, 50_000.0][camera % 5] * (1.0 + random.next());
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
            let pixels = draw(gpu, &mut water, view, 40.0 * random.next(), false);
            for (i, pixel) in pixels.chunks(4).enumerate() {
                let (x, y) = (i as u32 % SIZE[0], i as u32 / SIZE[0]);
                let up = ray(&view, x, y).y;
                let nothing = pixel[..3] == [255, 0, 255];
                if up.abs() > 0.5 * view.pixel_angle_rad() {
                    assert_eq!(
                        nothing,
                        up > 0.0,
                        "{name}, camera {camera} at {eye}: ({x}, {y}) looks {up} up"
                    );
                }
            }
        }
    }
}

/// Round the island, where water draws back from the shore and the ground may slope away behind it.
#[test]
fn no_hole_opens_along_the_shore() {
    let Some(gpu) = gpu() else { return };
    let mut water = water(gpu, scene_named("five-sample-island"));
    for camera in 0..24 {
        let azimuth = std::f64::consts::TAU * f64::from(camera) / 24.0;
        let eye = DVec3::new(66.0 * azimuth.sin(), 1.5 + f64::from(camera % 5), 66.0 * azimuth.cos());
        let beside = DVec3::new(-35.0 * azimuth.cos(), 0.0, 35.0 * azimuth.sin());
        let view = look(eye, (beside - eye).normalize());
        let pixels = draw(gpu, &mut water, view, 3.7 + f64::from(camera), false);
        for (i, pixel) in pixels.chunks(4).enumerate() {
            let (x, y) = (i as u32 % SIZE[0], i as u32 / SIZE[0]);
            let up = ray(&view, x, y).y;
            let nothing = pixel[..3] == [255, 0, 255];
            assert!(!nothing || up > -0.5 * view.pixel_angle_rad(), "camera {camera}: a hole at ({x}, {y})");
        }
    }
}

fn picture(gpu: &Gpu, toml: &str, time_s: f64) -> Vec<u8> {
    let scene = Scene::from_toml(toml, "test.toml").unwrap_or_else(|error| panic!("{error}"));
    let request = PictureRequest { backend: None, width: 96, height: 54, time_s };
    render_picture(gpu, &scene, &request, &mut |_| {}).unwrap().rgba8
}

/// The log can be retraced: no stage looks like another, and a still has no holes where Fresnel is small.
#[test]
fn every_stage_looks_different() {
    let Some(gpu) = gpu() else { return };
    let stages: Vec<_> = named::ALL.iter().filter(|scene| scene.name.starts_with("five-sample")).collect();
    assert!(stages.len() >= 10, "{}", stages.len());
    let pictures: Vec<_> = stages.iter().map(|scene| picture(gpu, scene.toml, 3.7)).collect();
    for (i, a) in pictures.iter().enumerate() {
        assert!(a.iter().skip(3).step_by(4).all(|alpha| *alpha == 255));
        for (j, b) in pictures[..i].iter().enumerate() {
            let sum: f64 = a.iter().zip(b).map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
            let mean = sum / a.len() as f64;
            assert!(mean > 0.3, "{} and {} differ by {mean} levels", stages[i].name, stages[j].name);
        }
    }
}

#[test]
fn no_setting_is_without_effect() {
    let Some(gpu) = gpu() else { return };
    let check = |name: &str, changes: &[&str]| {
        let base = scene_named(name);
        // Each key once: what the scene says of it goes.
        let with = |line: &str| {
            let key = format!("{} =", line.split(' ').next().unwrap());
            let kept: Vec<_> = base.lines().filter(|l| !l.starts_with(&key)).collect();
            kept.join("\n").replace("[five-sample]", &format!("[five-sample]\n{line}"))
        };
        let before = picture(gpu, base, 1.0);
        for line in changes {
            assert!(picture(gpu, &with(line), 1.0) != before, "{line} changes nothing");
        }
    };
    check(
        "five-sample",
        &[
            "uv_size_m = 500.0",
            "wave_strength = 0.5",
            "exponent = 20.0",
            "emission = [0.2, 0.15, 0.12]",
            "reflection = [0.65, 0.65, 0.8]",
            "sun_brightness = 1.0",
            "zenith_color = [0.9, 0.0, 0.0]",
            "middle_color = [0.9, 0.0, 0.0]",
            "horizon_color = [0.9, 0.0, 0.0]",
        ],
    );
    check(
        "five-sample-island",
        &[
            "depth_fog = false",
            "extinction_per_m = [2.0, 2.0, 2.0]",
            "reflected_geometry = false",
            "distortion = 0.0",
            "waves_meet_land = false",
            "shore_depth_m = 4.0",
            "swash_height_m = 0.3",
            "swash_period_s = 4.0",
        ],
    );
    let base = scene_named("five-sample");
    for (from, to) in [("seed = 7", "seed = 8"), ("sun_azimuth_deg = 215.0", "sun_azimuth_deg = 245.0")] {
        assert!(
            picture(gpu, &base.replace(from, to), 1.0) != picture(gpu, base, 1.0),
            "{to} changes nothing"
        );
    }
    let at_the_sun = base.replace("look_at_m = [-60.0, -6.0, 50.0]", "look_at_m = [-40.6, 72.5, 57.9]");
    let with_disc = at_the_sun.replace("[five-sample]", "[five-sample]\nsun_disc = true");
    assert!(picture(gpu, &with_disc, 1.0) != picture(gpu, &at_the_sun, 1.0), "there is no sun");
}

/// With nothing in the water, what was left for later leaves the text's own picture, but for rounding.
#[test]
fn on_the_open_sea_the_later_things_change_nothing() {
    let Some(gpu) = gpu() else { return };
    let base = scene_named("five-sample");
    let later = "[five-sample]\ndepth_fog = true\nreflected_geometry = true\nwaves_meet_land = true";
    let (before, after) = (picture(gpu, base, 2.0), picture(gpu, &base.replace("[five-sample]", later), 2.0));
    let largest = before.iter().zip(&after).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
    assert!(largest <= 1, "{largest}");
}

/// The dome and the far water show one gradient: at the horizon the water has the sky's colour, as absorbed.
#[test]
fn the_water_mirrors_the_dome() {
    let Some(gpu) = gpu() else { return };
    let mut water = water(gpu, scene_named("five-sample"));
    let eye = DVec3::new(0.0, 1.8, 0.0);
    let away_from_the_sun = DVec3::new(1.0, 0.0, -0.8).normalize();
    let pixels = draw(gpu, &mut water, look(eye, away_from_the_sun), 0.0, true);
    let row = |y: usize| Vec3::from([0, 1, 2].map(|c| f32::from(pixels[(y * 64 + 32) * 4 + c])));
    let (above, below) = (row(17), row(18));
    assert!((below / above - 0.65).abs().max_element() < 0.08, "{above} over {below}");
}

/// Over the flank of the island the water takes the bottom's colour, and its edge moves with the waves.
#[test]
fn the_later_things_show_at_the_island() {
    let Some(gpu) = gpu() else { return };
    let base = scene_named("five-sample-island");
    // Straight down from over the shore, without ripples.
    let down = base
        .replace("[five-sample]", "[five-sample]\nwave_strength = 0.0")
        .replace("position_m = [0.0, 3.5, 66.0]", "position_m = [0.0, 40.0, 46.0]")
        .replace("look_at_m = [-14.0, 0.0, 30.0]", "look_at_m = [0.0, 0.0, 45.9]");
    let with = |flag: &str, time_s| {
        picture(gpu, &down.replace(&format!("{flag} = true"), &format!("{flag} = false")), time_s)
    };
    let mean = |pixels: &[u8], c: usize| {
        pixels.iter().skip(c).step_by(4).map(|v| f64::from(*v)).sum::<f64>() / (pixels.len() / 4) as f64
    };
    let (clear, murky) = (with("waves_meet_land", 0.0), with("depth_fog", 0.0));
    assert!(mean(&clear, 0) > mean(&murky, 0) + 3.0, "the bottom does not show");
    let (one, other) = (picture(gpu, &down, 0.0), picture(gpu, &down, 3.5));
    let moved = one.iter().zip(&other).filter(|(a, b)| a.abs_diff(**b) > 20).count();
    assert!(moved > 100, "the water's edge stands still: {moved}");
    // From low over the water the island's reflection darkens it.
    let reflected = picture(gpu, base, 0.0);
    let not = picture(gpu, &base.replace("reflected_geometry = true", "reflected_geometry = false"), 0.0);
    let changed = reflected.iter().zip(&not).filter(|(a, b)| a.abs_diff(**b) > 8).count();
    assert!(changed > 60, "the island is not reflected: {changed}");
}

/// The half vector of the first stage goes wrong on large triangles, and the plane of the second mends it: this is
/// the only difference between them.
#[test]
fn only_the_plane_differs_between_the_first_two_stages() {
    let (coarse, gridded) =
        (stage::form(settings::Variant::BlinnPhong), stage::form(settings::Variant::Gridded));
    assert!(coarse.is_coarse && !gridded.is_coarse);
    assert!(coarse.map == gridded.map && coarse.stage == gridded.stage);
}

fn in_five_sample(toml: &str, lines: &str) -> String {
    toml.replace("[five-sample]", &format!("[five-sample]\n{lines}"))
}

/// However clear the water: where nothing was drawn under it, it keeps its own colour.
#[test]
fn clear_water_without_a_bottom_is_the_open_sea() {
    let Some(gpu) = gpu() else { return };
    let base = scene_named("five-sample");
    let clear = in_five_sample(base, "depth_fog = true\nextinction_per_m = [0.0, 0.0, 0.0]");
    let (before, after) = (picture(gpu, base, 2.0), picture(gpu, &clear, 2.0));
    let largest = before.iter().zip(&after).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
    assert!(largest <= 1, "{largest}");
}

/// Beer and Lambert's law: of the bottom's difference from the water's own colour, e^(−k·path) is left, and the
/// path goes down with the bent sunlight and up with the bent ray.
#[test]
fn the_bottom_fades_with_the_path_of_the_light() {
    let Some(gpu) = gpu() else { return };
    let calm = scene_named("five-sample-island")
        .replace("reflected_geometry = true\nwaves_meet_land = true", "wave_strength = 0.0");
    let with = |k: f64| in_five_sample(&calm, &format!("extinction_per_m = [{k:?}, {k:?}, {k:?}]"));
    let scene = Scene::from_toml(&calm, "test.toml").unwrap();
    let ground = whitecap_scene::object::ground(&scene.read_objects().unwrap()).unwrap();
    let toward_sun = crate::environment::Environment::new(&scene).unwrap().sun.unwrap().toward.as_dvec3();
    // In water the sine of the angle from the vertical is 1.333 times less.
    let cosine_below = |cosine_above: f64| (1.0 - (1.0 - cosine_above.powi(2)) / 1.333_f64.powi(2)).sqrt();
    let k = 0.25;
    let mut waters = [0.0, k, 100.0].map(|k| water(gpu, &with(k)));
    let eye = DVec3::new(0.0, 20.0, 62.0);
    let view = look(eye, DVec3::new(0.0, -1.0, -0.7).normalize());
    let [clear, seen, murky] = waters.each_mut().map(|water| draw(gpu, water, view, 0.0, false));
    let (mut compared, mut off) = (0, 0.0);
    for i in 0..clear.len() / 4 {
        let ray = ray(&view, i as u32 % SIZE[0], i as u32 / SIZE[0]).as_dvec3();
        let place = eye + ray * (eye.y / -ray.y);
        let Some(depth_m) = ground.depth_m(place.x, place.z).filter(|depth| *depth > 0.3) else { continue };
        // Red differs most.
        let [clear, seen, murky] = [&clear, &seen, &murky].map(|pixels| f64::from(pixels[4 * i]));
        if clear - murky < 40.0 || clear == 255.0 {
            continue;
        }
        let path_m = depth_m * (1.0 / cosine_below(toward_sun.y) + 1.0 / cosine_below(-ray.y));
        off += ((seen - murky) / (clear - murky) - (-k * path_m).exp()).abs();
        compared += 1;
    }
    assert!(compared > 200, "the bottom is seen by {compared} pixels only");
    let off = off / f64::from(compared);
    assert!(off < 0.02, "the light that is left is off by {off}");
}
