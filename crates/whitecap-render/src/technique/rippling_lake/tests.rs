use super::gpu::{NORMALISE_VECTORS, SWAP_BUMP, SWAP_REFRACTION};
use super::*;
use crate::environment::Environment;
use crate::gpu::{
    Gpu,
    for_tests::{Canvas, compute, gpu},
};
use crate::pass::Objects;
use crate::pass::planar_tests::{BLUE, Map, RED, block, is_blue, is_red, view_of};
use crate::shader_lib::{self, layout::assert_layout};
use crate::uniforms::Shared;
use crate::{TargetFormat, View};
use glam::{Vec2, Vec2Swizzles, Vec3, Vec4, Vec4Swizzles};
use whitecap_scene::Scene;
use whitecap_scene::object::Model;
use whitecap_waves::model::Surface;
use whitecap_waves::optics::classics::{
    RipplingLakeConstants, rippling_lake_coordinates, rippling_lake_pixel,
};

const TOWARD_SUN: Vec3 = Vec3::new(0.6, 0.64, -0.48);

#[test]
fn rust_and_wgsl_agree_about_layout() {
    let wgsl = shader_lib::RIPPLING_LAKE.wgsl;
    assert_layout!(
        GpuLakeConstants,
        wgsl,
        "GpuLakeConstants",
        [reflection_perturbation, refraction_perturbation, reflection_tint, refraction_tint, highlight_color]
    );
    assert_layout!(
        GpuLake,
        wgsl,
        "GpuLake",
        [sines, constants, map_x, map_y, map_w, centre_from_eye, size_m, bump_tiling, bump_centre, options]
    );
}

/// The named scene without its objects, its lake of these settings and with a small bump map.
fn lake_scene(keys: &str) -> Scene {
    lake_scene_with_bumps(64, keys)
}

fn lake_scene_with_bumps(resolution: u32, keys: &str) -> Scene {
    let toml = whitecap_scene::named::find("rippling-lake").unwrap().toml;
    let place = |of: &str| toml.find(of).unwrap();
    let (before, after) = (&toml[..place("[rippling-lake]")], &toml[place("[sky]")..place("[[object]]")]);
    let table = format!("[rippling-lake]\nbump_resolution = {resolution}\n{keys}\n");
    Scene::from_toml(&format!("{before}{table}{after}"), "test.toml").unwrap()
}

/// The scene's technique with `models` in the water, on the test adapter.
struct Fixture<'g> {
    gpu: &'g Gpu,
    shared: Shared,
    objects: Objects,
    lake: RipplingLake,
}

impl<'g> Fixture<'g> {
    fn new(gpu: &'g Gpu, scene: &Scene, models: Vec<Model>) -> Fixture<'g> {
        let (device, queue) = (&gpu.device, &gpu.queue);
        let environment = Environment::new(scene).unwrap();
        let shared = Shared::new(device, queue, &environment, TargetFormat::default());
        let objects = Objects::of_models(device, queue, models, None);
        let lake = Self::lake(gpu, scene, &shared, &objects);
        Fixture { gpu, shared, objects, lake }
    }

    fn lake(gpu: &Gpu, scene: &Scene, shared: &Shared, objects: &Objects) -> RipplingLake {
        let whitecap_scene::Technique::RipplingLake(settings) = &scene.technique else { panic!() };
        let build = Build {
            toward_sun: TOWARD_SUN,
            ..Build::under_white_light(&gpu.device, &gpu.queue, scene, shared, objects)
        };
        RipplingLake::new(&build, settings).unwrap()
    }

    fn prepare(&mut self, encoder: &mut wgpu::CommandEncoder, views: &[View], time_s: f64) {
        let Gpu { device, queue, .. } = self.gpu;
        let Fixture { shared, objects, lake, .. } = self;
        shared.write_views(queue, views).unwrap();
        objects.prepare(queue, views, time_s);
        let mut frame = Frame { device, queue, encoder, views, time_s, shared, objects, timer: None };
        lake.prepare(&mut frame).unwrap();
    }

    /// The water alone, as each view sees it, black elsewhere.
    fn draw(&mut self, views: &[View], time_s: f64) -> Vec<Map> {
        let Gpu { device, queue, .. } = self.gpu;
        let mut encoder = device.create_command_encoder(&Default::default());
        self.prepare(&mut encoder, views, time_s);
        let target = self.shared.target;
        let mut pictures = Vec::new();
        for (index, view) in views.iter().enumerate() {
            let canvas = Canvas::new(self.gpu, &target, view.size_px);
            canvas.draw(&mut encoder, wgpu::Color::BLACK, |pass| {
                self.shared.bind(pass, index, Role::Main);
                self.lake.draw(pass, index);
            });
            pictures.push(canvas.color);
        }
        queue.submit([encoder.finish()]);
        pictures.iter().map(|picture| Map::read(self.gpu, picture)).collect()
    }
}

fn over_the_lake(size_px: [u32; 2]) -> View {
    view_of([0.0, 2.0, 20.0], [0.0, 0.5, 0.0], size_px)
}

/// The text's M for row vectors, its missing number 0: the place on a map is clip · M, w in the third component.
#[test]
fn the_altered_projection_is_clip_times_m() {
    let m = [[0.5, 0.0, 0.0, 0.0], [0.0, -0.5, 0.0, 0.0], [0.0; 4], [0.5, 0.5, 1.0, 0.0]];
    let view = view_of([3.0, 2.5, 9.0], [-1.0, 0.0, 0.0], [320, 180]);
    let [map_x, map_y, map_w] = altered_projection(view.clip_from_eye_world());
    for place in [Vec3::new(1.0, -2.0, -4.0), Vec3::new(-30.0, -2.5, -70.0), Vec3::new(8.0, -2.5, 9.0)] {
        let place = place.extend(1.0);
        let clip = (view.clip_from_eye_world() * place).to_array();
        let column = |c: usize| (0..4).map(|row| clip[row] * m[row][c]).sum::<f32>();
        let seen = [map_x, map_y, map_w].map(|row| row.dot(place));
        for c in 0..3 {
            assert!((seen[c] - column(c)).abs() < 1e-4, "{seen:?} {}", column(c));
        }
        assert!((seen[2] - clip[3]).abs() < 1e-5, "w is carried in the third component");
    }
}

/// A map's corners: what the projection draws at the upper left is read at (0, 0).
#[test]
fn maps_are_read_from_the_upper_left() {
    let view = view_of([0.0, 2.0, 0.0], [0.0, 2.0, -1.0], [320, 180]);
    let rows = altered_projection(view.clip_from_eye_world());
    let half_height = 25.0_f32.to_radians().tan();
    let half_width = half_height * 320.0 / 180.0;
    for (x, y, expected) in [
        (0.0, 0.0, (0.5, 0.5)),
        (-half_width, half_height, (0.0, 0.0)),
        (half_width, half_height, (1.0, 0.0)),
        (-half_width, -half_height, (0.0, 1.0)),
    ] {
        let [u, v, w] = rows.map(|row| row.dot(Vec4::new(x, y, -1.0, 1.0)));
        assert!(Vec2::new(u / w, v / w).distance(expected.into()) < 1e-5, "{u} {v} {w}");
    }
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct PixelInput {
    constants: GpuLakeConstants,
    a: Vec4,
    b: Vec4,
    toward_eye: Vec4,
    toward_light: Vec4,
    projected: Vec4,
    reflection: Vec4,
    refraction: Vec4,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct PixelOutput {
    bump: Vec4,
    addresses: Vec4,
    color: Vec4,
}

fn texts_constants() -> GpuLakeConstants {
    GpuLakeConstants {
        reflection_perturbation: [0.05; 2],
        refraction_perturbation: [0.03; 2],
        reflection_tint: [1.0; 4],
        refraction_tint: [0.4, 0.55, 0.5, 0.0],
        highlight_color: [0.8, 0.76, 0.62, 0.0],
    }
}

#[test]
fn golden_pixel_on_the_gpu() {
    let Some(gpu) = gpu() else { return };
    let input = PixelInput {
        constants: texts_constants(),
        a: Vec4::new(0.6, 0.45, 0.9, 0.0),
        b: Vec4::new(0.5, 0.55, 1.0, 0.0),
        toward_eye: Vec4::new(0.6, 0.0, 0.8, 0.0),
        toward_light: Vec4::new(0.0, 0.6, 0.8, 0.0),
        projected: Vec4::new(1.5, 1.5, 3.0, 0.0),
        reflection: Vec4::new(0.5, 0.6, 0.8, 0.0),
        refraction: Vec4::new(0.2, 0.3, 0.25, 0.0),
    };
    let outputs: Vec<PixelOutput> = compute(gpu, &shader_lib::RIPPLING_LAKE_TWINS, "cs_pixel", &[input]);
    let PixelOutput { bump, addresses, color } = outputs[0];
    for (seen, expected) in [
        (bump, Vec4::new(0.1, 0.0, 0.9, 0.0)),
        (addresses, Vec4::new(0.505, 0.5, 0.503, 0.5)),
        (color, Vec4::new(0.247776, 0.351888, 0.345777, 0.19)),
    ] {
        assert!((seen - expected).abs().max_element() < 1e-5, "{seen} for {expected}");
    }
}

/// The shader against the text in f64: bumps, views from every side, places on and off the map, all constants.
#[test]
fn the_pixel_shader_is_the_texts() {
    let Some(gpu) = gpu() else { return };
    let wave = |i: usize, k: f32| 0.5 + 0.5 * (i as f32 * k + k).sin();
    let inputs: Vec<PixelInput> = (0..400)
        .map(|i| {
            let texel = |k: f32| Vec4::new(wave(i, k), wave(i, 1.3 * k), wave(i, 0.7 * k), 0.0);
            let vector = |k: f32| (2.0 * texel(k) - 1.0).with_w(0.0);
            let w = 0.5 + 9.0 * wave(i, 0.37);
            let place = Vec2::new(1.2 * wave(i, 0.9) - 0.1, 1.2 * wave(i, 0.53) - 0.1);
            PixelInput {
                constants: GpuLakeConstants {
                    reflection_perturbation: [wave(i, 0.11), -wave(i, 0.13)],
                    refraction_perturbation: [-wave(i, 0.17), wave(i, 0.19)],
                    reflection_tint: texel(0.23).to_array(),
                    refraction_tint: texel(0.29).to_array(),
                    highlight_color: texel(0.31).to_array(),
                },
                a: texel(1.1),
                b: texel(2.3),
                toward_eye: vector(0.47),
                toward_light: vector(0.71),
                projected: (place * w).extend(w).extend(if i % 3 == 0 { 1.0 } else { 0.0 }),
                reflection: texel(0.83),
                refraction: texel(0.97),
            }
        })
        .collect();
    let outputs: Vec<PixelOutput> = compute(gpu, &shader_lib::RIPPLING_LAKE_TWINS, "cs_pixel", &inputs);
    for (input, seen) in inputs.iter().zip(outputs) {
        let rgb = |v: Vec4| v.truncate().as_dvec3().to_array();
        let color = |[r, g, b, _]: [f32; 4]| [r, g, b].map(f64::from);
        let pair = |[x, y]: [f32; 2]| DVec2::new(x.into(), y.into());
        let constants = RipplingLakeConstants {
            reflection_perturbation: pair(input.constants.reflection_perturbation),
            refraction_perturbation: pair(input.constants.refraction_perturbation),
            reflection_tint: color(input.constants.reflection_tint),
            refraction_tint: color(input.constants.refraction_tint),
            highlight_color: color(input.constants.highlight_color),
            ..Default::default()
        };
        let expected = rippling_lake_pixel(
            [rgb(input.a), rgb(input.b)],
            input.toward_eye.truncate().as_dvec3(),
            input.toward_light.truncate().as_dvec3(),
            input.projected.xy().as_dvec2() / f64::from(input.projected.z),
            &constants,
            |_| rgb(input.reflection),
            |_| rgb(input.refraction),
        );
        let mut refraction = expected.refraction_address.as_vec2();
        if input.projected.w == 1.0 {
            refraction = refraction.yx();
        }
        let addresses = expected.reflection_address.as_vec2();
        let addresses = Vec4::new(addresses.x, addresses.y, refraction.x, refraction.y);
        let color = expected.color.as_vec3().extend(expected.alpha as f32);
        for (seen, expected) in [
            (seen.bump, expected.bump.as_vec3().extend(0.0)),
            (seen.addresses, addresses),
            (seen.color, color),
        ] {
            assert!((seen - expected).abs().max_element() < 1e-5, "{seen} for {expected}");
        }
    }
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct VertexInput {
    lake: GpuLake,
    grid: Vec4,
    toward_sun: Vec4,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct VertexOutput {
    position: Vec4,
    bump: Vec4,
    projected: Vec4,
    toward_eye: Vec4,
    toward_light: Vec4,
}

/// What is drawn is what the model says, here and a thousand kilometres away, now and a million seconds off.
#[test]
fn drawn_vertices_equal_the_model() {
    let Some(gpu) = gpu() else { return };
    for (centre, time_s) in
        [([0.0, 0.0], 3.713), ([1e6, -2.000_03e6], 999_999.37), ([-31.5, 7.25], -999_998.61)]
    {
        let scene = lake_scene(&format!("centre_m = {centre:?}\nsize_m = 60.0"));
        let fixture = Fixture::new(gpu, &scene, Vec::new());
        let lake = &fixture.lake;
        let centre = DVec2::from(centre);
        let eye = DVec3::new(centre.x + 3.0, 1.7, centre.y + 22.0);
        let view = view_of(eye.to_array(), [centre.x, 0.2, centre.y], [320, 180]);
        let uniforms = lake.uniforms(&view, time_s);
        let inputs: Vec<VertexInput> = (0..81)
            .map(|i| VertexInput {
                lake: uniforms,
                grid: Vec4::new((i % 9) as f32 / 8.0 - 0.5, (i / 9) as f32 / 8.0 - 0.5, 0.0, 0.0),
                toward_sun: TOWARD_SUN.extend(0.0),
            })
            .collect();
        let outputs: Vec<VertexOutput> = compute(gpu, &shader_lib::RIPPLING_LAKE_TWINS, "cs_vertex", &inputs);
        for (input, seen) in inputs.iter().zip(outputs) {
            let rest = centre + 60.0 * input.grid.xy().as_dvec2();
            let raised = lake.sines.sample(rest, time_s).displacement_m;
            let place = DVec3::new(rest.x, 0.0, rest.y) + raised;
            let position = (place - eye).as_vec3();
            let rounding = 3e-6 + 2e-7 * position.length();
            let off = seen.position.truncate() - position;
            assert!(
                off.abs().max_element() < rounding,
                "{off} at {position}, phases {:?}",
                lake.sines.phases(lake.sines.uv(rest), time_s)
            );

            let uv = lake.sines.uv(rest);
            for (i, expected) in
                rippling_lake_coordinates(uv, time_s, &Default::default()).into_iter().enumerate()
            {
                let bump = seen.bump.to_array();
                let off = DVec2::new(bump[2 * i].into(), bump[2 * i + 1].into()) - expected;
                assert!((off - off.round()).abs().max_element() < 1e-5, "{off}: whole repeats apart");
            }

            // From the still water, not from the wave.
            let still = (DVec3::new(rest.x, 0.0, rest.y) - eye).as_vec3();
            let clip = view.clip_from_eye_world() * still.extend(1.0);
            let expected = [0.5 * (clip.x + clip.w), 0.5 * (clip.w - clip.y), clip.w];
            assert!((seen.projected.truncate() - Vec3::from(expected)).abs().max_element() < 1e-4);

            let text = lake.sines.at_uv(uv, time_s, 0.0);
            for (seen, world) in
                [(seen.toward_eye, (eye - place).normalize()), (seen.toward_light, TOWARD_SUN.as_dvec3())]
            {
                let axes = DVec3::new(world.x, world.z, world.y);
                let expected =
                    DVec3::new(axes.dot(text.binormal), axes.dot(text.tangent), axes.dot(text.normal));
                assert!(seen.truncate().distance(expected.as_vec3()) < 1e-5, "{seen} for {expected}");
            }
        }
    }
}

#[test]
fn swapped_coordinates_are_v_u() {
    let Some(gpu) = gpu() else { return };
    let options = |keys: &str| {
        Fixture::new(gpu, &lake_scene(keys), Vec::new()).lake.uniforms(&over_the_lake([64, 36]), 1.5)
    };
    assert_eq!(options("").options, 0);
    assert_eq!(options("swap_uv = \"refraction\"").options, SWAP_REFRACTION);
    assert_eq!(options("normalised_vectors = true").options, NORMALISE_VECTORS);
    let swapped = options("swap_uv = \"bump\"");
    assert_eq!(swapped.options, SWAP_BUMP);
    let plain = GpuLake { options: 0, ..swapped };
    let input =
        |lake| VertexInput { lake, grid: Vec4::new(0.2, -0.4, 0.0, 0.0), toward_sun: TOWARD_SUN.extend(0.0) };
    let outputs: Vec<VertexOutput> =
        compute(gpu, &shader_lib::RIPPLING_LAKE_TWINS, "cs_vertex", &[input(plain), input(swapped)]);
    let [x, y, z, w] = outputs[0].bump.to_array();
    assert_eq!(outputs[1].bump.to_array(), [x, y, w, z]);
}

/// Above red, below blue; a lake over both, its own maps read back.
#[test]
fn the_lakes_maps_never_show_the_wrong_side() {
    let Some(gpu) = gpu() else { return };
    let models = vec![
        block([-3.0, 0.001, -1.0], [-1.0, 2.0, 1.0], RED),
        block([-3.0, -2.0, -1.0], [-1.0, -0.001, 1.0], BLUE),
        block([1.0, -1.5, -1.0], [3.0, -0.2, 1.0], BLUE),
    ];
    let keys = "refraction_margin_m = 0.0\nmap_width_px = 300\nmap_height_px = 170";
    let mut fixture = Fixture::new(gpu, &lake_scene(keys), models);
    for time_s in [0.0, 2.5] {
        let view = view_of([2.0, 3.0, 9.0], [0.0, 0.0, 0.0], [320, 180]);
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        fixture.prepare(&mut encoder, &[view], time_s);
        gpu.queue.submit([encoder.finish()]);
        let lake = &mut fixture.lake;
        let reflection = Map::read(gpu, lake.reflection.map(&gpu.device, 0).texture());
        let refraction = Map::read(gpu, lake.refraction.map(&gpu.device, 0).texture());
        assert_eq!([reflection.size_px, refraction.size_px], [[300, 170]; 2]);
        assert!(reflection.count(is_red) > 50 && refraction.count(is_blue) > 50);
        assert_eq!(refraction.count(is_red), 0);
        // The sky is blue, but nothing in it is as blue as the block.
        let deep = |texel: &[u8; 4]| texel[0] == 0 && texel[1] == 0 && texel[2] > 40;
        assert_eq!(reflection.count(deep), 0);
        assert!(refraction.count(deep) > 50);
    }
}

/// On still water under a level eye, a block's reflection lies straight below the block.
#[test]
fn reflections_lie_straight_below_what_they_mirror() {
    let Some(gpu) = gpu() else { return };
    let calm = "bump_slope = 0.0\nmap_width_px = 640\nmap_height_px = 360\ndeep_color = [0.0, 0.0, 0.0]\n\
                highlight_color = [0.0, 0.0, 0.0]";
    for place in [Vec3::new(-3.0, 1.2, -6.0), Vec3::new(2.0, 0.6, 2.0)] {
        let half = Vec3::splat(0.2);
        let red = block((place - half).to_array(), (place + half).to_array(), RED);
        let mut fixture = Fixture::new(gpu, &lake_scene(calm), vec![red]);
        let view = view_of([0.0, 2.0, 20.0], [0.0, 2.0, 0.0], [320, 180]);
        let picture = fixture.draw(&[view], 0.0).remove(0);
        let pixel = |place: Vec3| {
            let clip = view.clip_from_eye_world() * (place - view.eye_m.as_vec3()).extend(1.0);
            let ndc = clip.xy() / clip.w;
            (ndc * Vec2::new(0.5, -0.5) + 0.5) * Vec2::new(320.0, 180.0)
        };
        let seen = picture.middle(is_red);
        let (above, image) = (pixel(place), pixel(place * Vec3::new(1.0, -1.0, 1.0)));
        assert!(picture.count(is_red) > 4 && seen.distance(image) < 2.0, "{seen} for {image}");
        assert!((seen.x - above.x).abs() < 2.0 && seen.y > above.y, "{seen} under {above}");
    }
}

/// What stands under water is seen where it stands, through the water's tint.
#[test]
fn the_bottom_shows_through() {
    let Some(gpu) = gpu() else { return };
    let models = vec![block([-1.0, -1.5, -1.0], [1.0, -0.5, 1.0], RED)];
    let keys = "bump_slope = 0.0\nreflection_tint = [0.0, 0.0, 0.0]\nhighlight_color = [0.0, 0.0, 0.0]";
    let mut fixture = Fixture::new(gpu, &lake_scene(keys), models);
    let view = view_of([0.0, 8.0, 0.01], [0.0, 0.0, 0.0], [320, 180]);
    let picture = fixture.draw(&[view], 0.0).remove(0);
    assert!(picture.middle(is_red).distance(Vec2::new(160.0, 90.0)) < 2.0);
    let inside = picture.texels[90 * 320 + 160];
    let map = Map::read(gpu, fixture.lake.refraction.map(&gpu.device, 0).texture());
    let raw = map.texels[128 * 512 + 256];
    assert!((f32::from(inside[0]) - 0.4 * f32::from(raw[0])).abs() <= 1.0, "{inside:?} {raw:?}");
}

/// The more one looks along the water, the more it mirrors: per pixel, 1 − N·V.
#[test]
fn reflection_grows_towards_grazing_angles() {
    let Some(gpu) = gpu() else { return };
    let keys = "bump_slope = 0.0\nrefraction_tint = [0.0, 0.0, 0.0]\nhighlight_color = [0.0, 0.0, 0.0]";
    let mut fixture = Fixture::new(gpu, &lake_scene(keys), Vec::new());
    let down = view_of([0.0, 5.0, 0.01], [0.0, 0.0, 0.0], [64, 36]);
    let along = view_of([0.0, 1.0, 20.0], [0.0, 0.0, 0.0], [64, 36]);
    let pictures = fixture.draw(&[down, along], 0.0);
    let middle = |map: &Map| u32::from(map.texels[18 * 64 + 32][2]);
    let [straight, grazing] = [middle(&pictures[0]), middle(&pictures[1])];
    assert!(straight < 12 && grazing > 60, "{straight} {grazing}");
}

/// The waves and bump maps of this scene repeat every 80 m, so the lake and the viewer may be moved by 1,000 km.
#[test]
fn the_lake_looks_the_same_a_thousand_kilometres_away() {
    let Some(gpu) = gpu() else { return };
    let draw = |east: f64, south: f64| {
        let scene = lake_scene(&format!("centre_m = [{east:?}, {south:?}]"));
        let view = view_of([east, 2.0, south + 20.0], [east, 0.5, south], [160, 90]);
        Fixture::new(gpu, &scene, Vec::new()).draw(&[view], 12.5).remove(0)
    };
    let (near, far) = (draw(0.0, 0.0), draw(1.0e6, -2.0e6));
    let worst =
        near.texels.iter().zip(&far.texels).flat_map(|(a, b)| [0, 1, 2].map(|c| a[c].abs_diff(b[c]))).max();
    assert!(worst <= Some(3), "{worst:?} levels");
}

#[test]
fn several_views_have_maps_of_their_own() {
    let Some(gpu) = gpu() else { return };
    let models = || vec![block([-1.0, -0.5, -1.0], [1.0, 2.0, 1.0], RED)];
    let (one, two) = (over_the_lake([96, 54]), view_of([9.0, 4.0, 1.0], [0.0, 0.0, 0.0], [64, 64]));
    let mut fixture = Fixture::new(gpu, &lake_scene(""), models());
    let both = fixture.draw(&[one, two], 4.0);
    let alone = Fixture::new(gpu, &lake_scene(""), models()).draw(&[two], 4.0).remove(0);
    assert_eq!(both[1].texels, alone.texels);
    // Nothing is left of the frame before.
    let again = fixture.draw(&[two], 4.0).remove(0);
    assert_eq!(again.texels, alone.texels);
}

#[test]
fn every_setting_has_an_effect() {
    let Some(gpu) = gpu() else { return };
    // A new setting does not compile here until it has a line below.
    let settings::RipplingLake {
        size_m: _,
        centre_m: _,
        cells: _,
        map_width_px: _,
        map_height_px: _,
        refraction_margin_m: _,
        bump_resolution: _,
        bump_slope: _,
        bump_tiling_0: _,
        bump_tiling_1: _,
        bump_scroll_0: _,
        bump_scroll_1: _,
        reflection_perturbation: _,
        refraction_perturbation: _,
        reflection_tint: _,
        refraction_tint: _,
        highlight_color: _,
        deep_color: _,
        swap_uv: _,
        normalised_vectors: _,
    } = settings::RipplingLake::default();
    let models = vec![
        block([-1.0, -0.5, 8.0], [1.0, 2.0, 9.0], RED),
        block([-9.0, -3.0, -9.0], [9.0, -0.6, 12.0], [0.8, 0.7, 0.3]),
        block([2.0, -0.3, 8.0], [4.0, -0.02, 12.0], BLUE),
    ];
    let view = over_the_lake([128, 72]);
    let mut fixture = Fixture::new(gpu, &lake_scene(""), models);
    let base = fixture.draw(&[view], 5.0).remove(0).texels;
    for keys in [
        "size_m = 30.0",
        "centre_m = [3.0, 0.0]",
        "cells = 8",
        "map_width_px = 64",
        "map_height_px = 64",
        "refraction_margin_m = 0.5",
        "bump_slope = 0.1",
        "bump_tiling_0 = [3.0, 2.0]",
        "bump_tiling_1 = [2.7, 1.7]",
        "bump_scroll_0 = [0.0, 0.04]",
        "bump_scroll_1 = [-0.03, 0.01]",
        "reflection_perturbation = [0.02, 0.05]",
        "refraction_perturbation = [0.03, 0.0]",
        "reflection_tint = [1.0, 0.9, 0.8]",
        "refraction_tint = [0.4, 0.5, 0.5]",
        "highlight_color = [0.0, 0.0, 0.0]",
        "deep_color = [0.3, 0.2, 0.2]",
        "swap_uv = \"refraction\"",
        "swap_uv = \"bump\"",
        "normalised_vectors = true",
    ] {
        let scene = lake_scene(keys);
        fixture.lake = Fixture::lake(gpu, &scene, &fixture.shared, &fixture.objects);
        let seen = fixture.draw(&[view], 5.0).remove(0).texels;
        assert_ne!(seen, base, "{keys}");
    }
    let [finer, coarser] = [128, 64].map(|resolution| {
        let scene = lake_scene_with_bumps(resolution, "");
        fixture.lake = Fixture::lake(gpu, &scene, &fixture.shared, &fixture.objects);
        fixture.draw(&[view], 5.0).remove(0).texels
    });
    assert_ne!(finer, coarser, "bump_resolution");
}

/// A map beyond the device's textures is an error with the key's name, not a panic.
#[test]
fn maps_too_large_for_the_device_are_refused() {
    let Some(gpu) = gpu() else { return };
    let limit = gpu.device.limits().max_texture_dimension_2d;
    let ask = |width| {
        let settings = settings::RipplingLake { map_width_px: width, ..Default::default() };
        map_size(&gpu.device, &settings)
    };
    assert_eq!(ask(limit).unwrap(), [limit, 256]);
    assert!(ask(limit + 1).unwrap_err().to_string().contains("map_width_px"));
}
