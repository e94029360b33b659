use super::*;
use crate::TargetFormat;
use crate::environment::Environment;
use crate::gpu::for_tests::{compute, gpu};
use crate::gpu::read_texture;
use crate::pass::Objects;
use crate::shader_lib::{self, layout::assert_layout};
use crate::uniforms::Shared;
use glam::{DVec2, DVec3, DVec4};
use half::f16;
use whitecap_scene::{Camera, Scene};
use whitecap_waves::model::Surface;
use whitecap_waves::optics::classics::{mirrored_coordinates, sun_glint};
use whitecap_waves::optics::fresnel_exact;

mod pixels;

#[test]
fn rust_and_wgsl_agree_about_layout() {
    assert_layout!(
        GpuProjectedGrid,
        shader_lib::PROJECTED_GRID.wgsl,
        "GpuProjectedGrid",
        [toward_sun, sun_strength, water_color, sun_shininess, offset_axes, level_m, distortion, options]
    );
    for shader in [shader_lib::PROJECTED_GRID_HEIGHTS, shader_lib::PROJECTED_GRID_NORMALS] {
        assert_layout!(
            GpuMaps,
            shader.wgsl,
            "GpuMaps",
            [corners, chunk_origins, chunks_per_m, texel, amplitude_m]
        );
    }
}

/// The demo's, which its golden numbers are for.
const STRENGTH_M: f64 = 0.9;

/// A technique on the test adapter, brought to a time for one view.
struct Fixture {
    technique: ProjectedGrid,
    grid: Grid,
    view: View,
    time_s: f64,
}

fn fixture(edit: impl Fn(&mut Scene), eye_m: DVec3, time_s: f64) -> Option<Fixture> {
    let gpu = gpu()?;
    let (device, queue) = (&gpu.device, &gpu.queue);
    let mut scene = whitecap_scene::open("projected-grid").unwrap();
    scene.objects.clear();
    let whitecap_scene::sea::SeaModel::Perlin(sea) = &mut scene.sea.model else { panic!() };
    sea.strength_m = STRENGTH_M;
    edit(&mut scene);
    let environment = Environment::new(&scene).unwrap();
    let shared = Shared::new(device, queue, &environment, TargetFormat::default());
    let objects = Objects::new(device, queue, &scene).unwrap();
    let build = Build::under_white_light(device, queue, &scene, &shared, &objects);
    let whitecap_scene::Technique::ProjectedGrid(settings) = &scene.technique else { panic!() };
    let mut technique = ProjectedGrid::new(&build, settings).unwrap();
    let look_at_m = (eye_m + DVec3::new(3.0, -2.0, -10.0)).to_array();
    let camera = Camera { position_m: eye_m.to_array(), look_at_m, vertical_fov_deg: 45.0 };
    let view = View::of_camera(&camera, [320, 180]);
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut frame = Frame {
        device,
        queue,
        encoder: &mut encoder,
        views: &[view],
        time_s,
        shared: &shared,
        objects: &objects,
        timer: None,
    };
    technique.prepare(&mut frame).unwrap();
    queue.submit([encoder.finish()]);
    let grid = technique.grid(&view).unwrap();
    Some(Fixture { technique, grid, view, time_s })
}

fn settings(scene: &mut Scene) -> &mut settings::ProjectedGrid {
    let whitecap_scene::Technique::ProjectedGrid(settings) = &mut scene.technique else { panic!() };
    settings
}

fn coherent(scene: &mut Scene) {
    settings(scene).pairing = settings::Pairing::Coherent;
    settings(scene).smooth = false;
}

/// The vertices that are drawn lie on the surface that can be asked for its height, far from the origin as well.
#[test]
fn drawn_vertices_are_the_models() {
    for (eye_m, time_s) in [
        (DVec3::new(5.0, 3.0, -7.0), 12.3),
        (DVec3::new(1e6, 8.0, -7e5), -5e5),
        (DVec3::new(0.0, 0.1, 0.0), 0.0),
    ] {
        let Some(fixture) = fixture(coherent, eye_m, time_s) else { return };
        let vertices = &fixture.technique.vertices;
        assert_eq!(vertices.len(), 65 * 129);
        for (i, vertex) in vertices.iter().enumerate().step_by(41) {
            let (u, v) = ((i % 65) as f64 / 64.0, (i / 65) as f64 / 128.0);
            let from_eye = fixture.grid.point(u, v);
            let [x, y, z] = vertex.position.map(f64::from);
            assert!(from_eye.distance(DVec2::new(x, z)) <= 1e-6 * from_eye.length());
            let rest = DVec2::new(eye_m.x, eye_m.z) + from_eye;
            let height = fixture.technique.noise.sample(rest, time_s).displacement_m.y;
            assert!((y + eye_m.y - height).abs() < 1e-5, "vertex {i}: {y} for {height}");
            assert!(vertex.normal[1] > 0.0);
        }
    }
}

/// The demo's option: a fifth of the vertex and of each neighbour.
#[test]
fn smoothing_is_the_mean_of_five() {
    let eye_m = DVec3::new(0.0, 4.0, 0.0);
    let Some(plain) = fixture(|scene| settings(scene).smooth = false, eye_m, 2.0) else { return };
    let Some(smooth) = fixture(|scene| settings(scene).smooth = true, eye_m, 2.0) else { return };
    let y = |i: usize| plain.technique.vertices[i].position[1];
    for i in [65 * 3 + 7, 65 * 50 + 30, 65 * 100 + 60] {
        let mean = 0.2 * (y(i) + y(i - 1) + y(i + 1) + y(i - 65) + y(i + 65));
        assert!((smooth.technique.vertices[i].position[1] - mean).abs() < 1e-5);
    }
}

fn height_map(fixture: &Fixture) -> Vec<f32> {
    let gpu = gpu().unwrap();
    let heights = &fixture.technique.map_passes.as_ref().unwrap().heights;
    bytemuck::pod_collect_to_vec(&read_texture(&gpu.device, &gpu.queue, heights).unwrap())
}

fn normal_map(fixture: &Fixture) -> Vec<Vec3> {
    let gpu = gpu().unwrap();
    let map = &fixture.technique.views[0].normals.as_ref().unwrap().texture;
    let texels: Vec<[f16; 4]> =
        bytemuck::pod_collect_to_vec(&read_texture(&gpu.device, &gpu.queue, map).unwrap());
    texels.iter().map(|t| Vec3::new(t[0].to_f32(), t[1].to_f32(), t[2].to_f32())).collect()
}

/// Coherent pairing: near the viewer, where no mip is read, the height map holds the heights of the model.
#[test]
fn the_coherent_height_map_is_the_model() {
    let eye_m = DVec3::new(4e5, 2.0, -3e5);
    let Some(fixture) = fixture(coherent, eye_m, 7.7) else { return };
    let heights = height_map(&fixture);
    let metres = 65_535.0 / 16_384.0 * STRENGTH_M;
    // Half floats keep 11 bits; 40 cm are the waves' height.
    let bound_m = 4e-4;
    for row in [3, 20, 60] {
        for column in (5..512).step_by(50) {
            let (u, v) = ((f64::from(column) + 0.5) / 512.0, (f64::from(row) + 0.5) / 1024.0);
            let rest = DVec2::new(eye_m.x, eye_m.z) + in_mesh(&fixture.grid, u, v);
            let model = fixture.technique.noise.sample(rest, fixture.time_s).displacement_m.y;
            let drawn = f64::from(heights[row as usize * 512 + column as usize]) * metres;
            assert!((drawn - model).abs() < bound_m, "({column}, {row}): {drawn} for {model}");
        }
    }
}

/// Coherent pairing: as far as a texel of the map spans about 1.4 of the short waves' texels, a bias of one level
/// still reads the finest one, so that the height map holds the heights of the model.
#[test]
fn the_bias_keeps_the_finest_noise_half_a_level_further() {
    let eye_m = DVec3::new(3.0, 2.0, 5.0);
    let Some(fixture) = fixture(coherent, eye_m, 7.7) else { return };
    let heights = height_map(&fixture);
    let uniforms = GpuMaps::new(&fixture.technique.settings, &fixture.technique.noise, &fixture.grid, eye_m);
    let texels_per_m = f64::from(uniforms.chunks_per_m[1]) * fixture.technique.noise.chunk_size() as f64;
    let mut compared = 0;
    for row in 0..1024 {
        for column in (3..512).step_by(7) {
            let (u, v) = ((f64::from(column) + 0.5) / 512.0, (f64::from(row) + 0.5) / 1024.0);
            let at = in_mesh(&fixture.grid, u, v);
            let across_m = in_mesh(&fixture.grid, u + 1.0 / 512.0, v).distance(at);
            let down_m = in_mesh(&fixture.grid, u, v + 1.0 / 1024.0).distance(at);
            let level = (texels_per_m * across_m.max(down_m)).log2();
            if !(0.4..0.7).contains(&level) {
                continue;
            }
            let rest = DVec2::new(eye_m.x, eye_m.z) + at;
            let model = fixture.technique.noise.sample(rest, fixture.time_s).displacement_m.y;
            let drawn = f64::from(heights[row as usize * 512 + column as usize] * uniforms.amplitude_m);
            assert!((drawn - model).abs() < 4e-4, "({column}, {row}), level {level}: {drawn} for {model}");
            compared += 1;
        }
    }
    assert!(compared > 100, "{compared} texels of that level");
}

/// The level under a place of the mesh: linear in the triangle that it lies in.
fn in_mesh(grid: &Grid, u: f64, v: f64) -> DVec2 {
    let (x, y) = (u * 64.0, v * 128.0);
    let at = |du: f64, dv: f64| grid.point((x.floor() + du) / 64.0, (y.floor() + dv) / 128.0);
    let (fx, fy) = (x.fract(), y.fract());
    if fx + fy <= 1.0 {
        at(0.0, 0.0) + fx * (at(1.0, 0.0) - at(0.0, 0.0)) + fy * (at(0.0, 1.0) - at(0.0, 0.0))
    } else {
        at(1.0, 1.0) + (1.0 - fx) * (at(0.0, 1.0) - at(1.0, 1.0)) + (1.0 - fy) * (at(1.0, 0.0) - at(1.0, 1.0))
    }
}

/// Faithful pairing: half as high, four times as often (256 texels to a chunk where the text's constants mean 64).
#[test]
fn the_faithful_height_map_repeats_every_64_over_scale() {
    let eye_m = DVec3::new(0.0, 2.0, 0.0);
    let Some(first) = fixture(|_| {}, eye_m, 1.0) else { return };
    let step = DVec3::new(64.0 / 0.38, 0.0, -2.0 * 64.0 / 0.38);
    let Some(next) = fixture(|_| {}, eye_m + step, 1.0) else { return };
    let (a, b) = (height_map(&first), height_map(&next));
    let near = 0..512 * 300;
    let worst = near.map(|i| (a[i] - b[i]).abs()).fold(0.0, f32::max);
    assert!(worst < 2e-3, "{worst}");
    let uniforms = GpuMaps::new(&first.technique.settings, &first.technique.noise, &first.grid, eye_m);
    assert!((uniforms.amplitude_m - 1.8).abs() < 1e-6);
    assert!((uniforms.chunks_per_m[0] - 0.38 / 64.0).abs() < 1e-9);
    assert!((uniforms.chunks_per_m[1] - 0.38 / 4.0).abs() < 1e-9);
}

/// The normal map's normals are those of the height map: unit length, upwards, and near the viewer across the map's
/// own surface.
#[test]
fn normals_are_of_the_height_map() {
    let eye_m = DVec3::new(0.0, 3.0, 0.0);
    let Some(fixture) = fixture(coherent, eye_m, 3.0) else { return };
    let (heights, normals) = (height_map(&fixture), normal_map(&fixture));
    let metres = 65_535.0 / 16_384.0 * STRENGTH_M;
    let at = |column: i32, row: i32| {
        let (u, v) = ((f64::from(column) + 0.5) / 512.0, (f64::from(row) + 0.5) / 1024.0);
        let level = fixture.grid.point(u, v);
        let height = f64::from(heights[(row * 512 + column) as usize]) * metres;
        DVec3::new(level.x, height, level.y)
    };
    for (i, normal) in normals.iter().enumerate().step_by(977) {
        assert!((normal.length() - 1.0).abs() < 2e-3, "texel {i}: {normal}");
        assert!(normal.y > 0.0, "texel {i}: {normal}");
    }
    for row in (5..500).step_by(37) {
        for column in (8..500).step_by(61) {
            let across = at(column + 1, row) - at(column - 1, row);
            let expected = across.cross(at(column, row + 1) - at(column, row - 1)).normalize();
            let seen = normals[(row * 512 + column) as usize].as_dvec3();
            assert!(seen.distance(expected) < 0.02, "({column}, {row}): {seen} for {expected}");
        }
    }
    // The last row reaches past where waves can be told apart.
    let far = normals[1023 * 512..].iter().copied().fold(Vec3::ZERO, |a, b| a + b) / 512.0;
    assert!(far.y > 0.99, "{far}");
}

/// A view that sees no water draws nothing, and neither do maps that were made for another.
#[test]
fn no_water_in_view_draws_nothing() {
    let Some(gpu) = gpu() else { return };
    let Some(mut fixture) = fixture(|_| {}, DVec3::new(0.0, 4.0, 0.0), 0.0) else { return };
    assert!(fixture.technique.views[0].sees_water);
    let scene = whitecap_scene::open("projected-grid").unwrap();
    let environment = Environment::new(&scene).unwrap();
    let shared = Shared::new(&gpu.device, &gpu.queue, &environment, TargetFormat::default());
    let objects = Objects::new(&gpu.device, &gpu.queue, &scene).unwrap();
    let up = View { view_from_world: glam::Quat::from_rotation_x(-1.5), ..fixture.view };
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    fixture
        .technique
        .prepare(&mut Frame {
            device: &gpu.device,
            queue: &gpu.queue,
            encoder: &mut encoder,
            views: &[up],
            time_s: 0.0,
            shared: &shared,
            objects: &objects,
            timer: None,
        })
        .unwrap();
    assert!(!fixture.technique.views[0].sees_water);
}

#[test]
fn the_fresnel_table_is_the_exact_curve() {
    let table = gpu::fresnel_table();
    assert_eq!(table.len(), gpu::FRESNEL_ENTRIES);
    for (i, entry) in table.iter().enumerate() {
        let exact = fresnel_exact((i as f64 + 0.5) / 256.0, 1.333);
        assert!((f64::from(entry[0]) / 255.0 - exact).abs() <= 0.5001 / 255.0);
    }
    assert_eq!((table[255][0], table[0][0]), (5, 252));
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct TwinInput {
    normal: [f32; 4],
    view: [f32; 4],
    numbers: [f32; 4],
    corners: [[f32; 4]; 4],
}

#[test]
fn shader_functions_equal_their_twins() {
    let Some(gpu) = gpu() else { return };
    let corners =
        [[-2.0, 0.0, 1.5, 0.5], [2.0, 0.25, 1.5, 0.5], [-3.0, 0.0, -9.0, 0.125], [3.0, 0.5, -9.0, 0.125]];
    let inputs: Vec<TwinInput> = [1.0_f32, 0.99, 0.95, 0.9, -0.5]
        .into_iter()
        .enumerate()
        .map(|(i, cos_sun)| {
            let lean = 0.1 * i as f32;
            let normal = [lean, 0.9, -0.5 * lean, cos_sun];
            let view = Vec3::new(0.3 + lean, -0.2, -0.8).normalize();
            let depth = 1.0 - 0.1 * i as f32;
            TwinInput {
                normal,
                view: view.extend(depth).to_array(),
                numbers: [12.0, 84.0, 0.25 * i as f32, 0.75],
                corners,
            }
        })
        .collect();
    let outputs: Vec<[[f32; 4]; 5]> = compute(gpu, &shader_lib::PROJECTED_GRID_TWINS, "cs_run", &inputs);
    // The printed values for strength 12 and shininess 84.
    let golden = [
        [3.361464, 2.040117, 1.086404],
        [2.290194, 1.389949, 0.740176],
        [0.474215, 0.287807, 0.153263],
        [0.060176, 0.036522, 0.019449],
        [0.0; 3],
    ];
    let close = |seen: [f32; 4], expected: DVec3| {
        let seen = DVec4::from(seen.map(f64::from)).truncate();
        assert!(seen.distance(expected) < 1e-5 * expected.length().max(1.0), "{seen} for {expected}");
    };
    for ((input, output), golden) in inputs.iter().zip(&outputs).zip(golden) {
        let of = |v: [f32; 4]| DVec4::from(v.map(f64::from));
        let (normal, view) = (of(input.normal).truncate(), of(input.view).truncate());
        let mut reflected = (view - 2.0 * normal.dot(view) * normal).normalize();
        reflected.y = reflected.y.max(0.0);
        close(output[0], reflected);
        close(output[1], sun_glint(f64::from(input.normal[3]), 12.0, 84.0));
        close(output[1], golden.into());
        let screen = DVec2::new(f64::from(input.numbers[2]), f64::from(input.numbers[3]));
        let mirrored = mirrored_coordinates(screen, f64::from(input.view[3]), 0.1, normal);
        close(output[2], mirrored.extend(0.0));
        let [c00, c10, c01, c11] = corners.map(of);
        let point = c00.lerp(c10, screen.x).lerp(c01.lerp(c11, screen.x), screen.y);
        close(output[3], point.truncate() / point.w);
        close(
            output[4],
            (c10.truncate() - c00.truncate()).cross(c11.truncate() - c01.truncate()).normalize(),
        );
    }
}

/// Angles of the text, whose z runs north: to the east, 62° high.
#[test]
fn the_texts_sun_stands_in_the_east() {
    let Some(fixture) = fixture(
        |scene| {
            settings(scene).sun_alfa_deg = Some(1.38_f64.to_degrees());
            settings(scene).sun_theta_deg = Some(1.09_f64.to_degrees());
        },
        DVec3::new(0.0, 4.0, 0.0),
        0.0,
    ) else {
        return;
    };
    let expected = Vec3::new(0.454093, 0.886627, -0.087706);
    assert!(fixture.technique.toward_sun.distance(expected) < 1e-5);
}
