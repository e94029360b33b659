use super::gpu::{GpuMeshuggah, bind_group, group_layout};
use super::*;
use crate::TargetFormat;
use crate::environment::Environment;
use crate::gpu::for_tests::{BoundGroup, compute_beside, gpu};
use crate::pass::Objects;
use crate::shader_lib::{self, layout::assert_layout};
use crate::surface::Backend;
use crate::uniforms::Shared;
use glam::{Vec2, Vec3};
use whitecap_scene::Scene;

const TOWARD_SUN: Vec3 = Vec3::new(0.954, 0.3, 0.0);

#[test]
fn rust_and_wgsl_agree_about_layout() {
    assert_layout!(
        GpuMeshuggah,
        shader_lib::MESHUGGAH.wgsl,
        "GpuMeshuggah",
        [
            centre_from_eye,
            cell_m,
            centre_cell,
            mesh_samples,
            earth_radius_m,
            centre_tile_uv,
            centre_bump_uv,
            tiles_per_m,
            bumps_per_m,
            fade_start_m,
            fade_end_m,
            deep_color,
            exposure,
            grazing_color,
            options,
            texels_per_m,
            visibility_m,
        ]
    );
}

/// A technique on the test adapter, with what its bind groups were made from.
struct Fixture {
    scene: Scene,
    shared: Shared,
    objects: Objects,
    technique: Meshuggah,
}

fn with_fixture(edit: impl Fn(&mut String), test: impl Fn(&wgpu::Device, &wgpu::Queue, Fixture)) {
    with_backend(None, edit, test);
}

fn with_backend(
    backend: Option<Backend>,
    edit: impl Fn(&mut String),
    test: impl Fn(&wgpu::Device, &wgpu::Queue, Fixture),
) {
    let Some(gpu) = gpu() else { return };
    let (device, queue) = (&gpu.device, &gpu.queue);
    let mut toml = whitecap_scene::named::find("meshuggah").unwrap().toml.to_owned();
    edit(&mut toml);
    let scene = Scene::from_toml(&toml, "test.toml").unwrap();
    let environment = Environment::new(&scene).unwrap();
    let shared = Shared::new(device, queue, &environment, TargetFormat::default());
    let objects = Objects::new(device, queue, &scene).unwrap();
    let whitecap_scene::Technique::Meshuggah(settings) = &scene.technique else { panic!() };
    let build = Build {
        backend,
        toward_sun: TOWARD_SUN,
        ..Build::under_white_light(device, queue, &scene, &shared, &objects)
    };

    let technique = Meshuggah::new(&build, settings).unwrap();
    test(device, queue, Fixture { scene, shared, objects, technique });
}

fn bring_to(device: &wgpu::Device, queue: &wgpu::Queue, technique: &mut Meshuggah, time_s: f64) {
    let mut encoder = device.create_command_encoder(&Default::default());
    technique.maps.update(queue, &mut encoder, time_s);
    queue.submit([encoder.finish()]);
}

fn view_from(eye_m: DVec3) -> View {
    let camera = whitecap_scene::Camera {
        position_m: eye_m.to_array(),
        look_at_m: (eye_m + DVec3::new(10.0, -1.0, 3.0)).to_array(),
        vertical_fov_deg: 45.0,
    };
    View::of_camera(&camera, [320, 180])
}

/// Runs the vertex stage's own functions on the device and reads position, share of geometry and normal.
fn read_vertices(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    fixture: &Fixture,
    view: &View,
    grid: &[[f32; 2]],
) -> Vec<[[f32; 4]; 2]> {
    let Fixture { scene, shared, objects, technique } = fixture;
    let build =
        Build { toward_sun: TOWARD_SUN, ..Build::under_white_light(device, queue, scene, shared, objects) };
    let layout = group_layout(device);
    let colors = super::gpu::water_colors(&technique.settings, Vec3::ONE, 0.3);
    let group = bind_group(&build, &layout, &technique.maps, &technique.slots, &colors);
    technique.slots.write(queue, 3, &technique.uniforms(view));
    let water = BoundGroup {
        index: 2,
        layout: &layout,
        group: &group,
        offsets: &[ViewSlots::<GpuMeshuggah>::offset(3)],
    };
    compute_beside(device, queue, &shader_lib::MESHUGGAH_VERTICES, "cs_displace", grid, 3, &[water])
}

/// What the GPU draws is what the model says at that place of the world, to 1e-4 of Hs: here, a
/// thousand kilometres away, between samples of the mesh's grid, and where the waves fade.
#[test]
fn drawn_vertices_equal_the_model() {
    let grid: Vec<[f32; 2]> = (-60..=60)
        .step_by(5)
        .flat_map(|z| (-60..=60).step_by(7).map(move |x| [x as f32, z as f32]))
        .chain([[127.0, -128.0], [128.0, 128.0], [500.0, -300.0]])
        .collect();
    let compare = |device: &wgpu::Device, queue: &wgpu::Queue, mut fixture: Fixture| {
        let hs = 4.0 * fixture.technique.maps.model().variance_m2().sqrt();
        for (eye, time_s) in [
            (DVec3::new(0.0, 4.0, 0.0), 0.0),
            (DVec3::new(-31.7, 2.5, 811.2), 3.7),
            (DVec3::new(1_000_123.4, 8.0, -2_000_456.7), -512.25),
        ] {
            bring_to(device, queue, &mut fixture.technique, time_s);
            let view = view_from(eye);
            let vertices = read_vertices(device, queue, &fixture, &view, &grid);
            let maps = &fixture.technique.maps;
            let eye2 = DVec2::new(eye.x, eye.z);
            let centre = maps.nearest_cell(eye2).as_dvec2() * maps.cell_m();
            for ([gx, gz], [position, normal]) in grid.iter().zip(&vertices) {
                let rest = centre + DVec2::new(f64::from(*gx), f64::from(*gz)) * maps.cell_m();
                let point = maps.model().sample(rest, time_s);
                let share = f64::from(position[3]);
                let from_eye = DVec3::new(rest.x, 0.0, rest.y) - eye;
                let expected_share = expected_geometry(&fixture.technique, from_eye.length());
                assert!((share - expected_share).abs() < 1e-4, "{share} {expected_share}");

                let flat = (from_eye.x * from_eye.x + from_eye.z * from_eye.z).sqrt();
                let mut expected = from_eye + share * point.displacement_m;
                expected.y -= whitecap_waves::optics::curvature_drop_m(flat, 6_371_000.0);
                let drawn = DVec3::new(position[0].into(), position[1].into(), position[2].into());
                // f32 relative to the eye: a thousandth of a millimetre in ten metres.
                let rounding = 2e-7 * from_eye.length();
                assert!((drawn - expected).abs().max_element() < 1e-4 * hs + rounding, "{drawn} {expected}");

                let slope = -DVec2::new(point.normal.x, point.normal.z) / point.normal.y * share;
                let up = normals::bump_frame(slope.as_vec2()).y_axis;
                assert!((Vec3::new(normal[0], normal[1], normal[2]) - up).abs().max_element() < 2e-4);
            }
        }
    };
    for backend in Backend::ALL {
        with_backend(Some(backend), |_| {}, compare);
    }
}

fn expected_geometry(technique: &Meshuggah, distance_m: f64) -> f64 {
    let half = 0.5 * technique.maps.tile_size_m() * f64::from(technique.settings.tile_repeats);
    let t = ((distance_m / half - FADE_START) / (FADE_END - FADE_START)).clamp(0.0, 1.0);
    1.0 - t * t * (3.0 - 2.0 * t)
}

/// The mesh may end, the waves must not: at its border nothing is left to tear.
#[test]
fn waves_have_left_the_mesh_before_it_ends() {
    with_fixture(
        |_| {},
        |_, _, fixture| {
            let maps = &fixture.technique.maps;
            let half = 0.5 * maps.tile_size_m() * f64::from(fixture.technique.settings.tile_repeats);
            // The eye is within half a cell of the centre.
            assert_eq!(expected_geometry(&fixture.technique, half - maps.cell_m()), 0.0);
        },
    );
}

/// Texel (i, j) of the normal map is drawn where sample (i, j) of the tile lies.
#[test]
fn the_maps_lie_where_the_samples_lie() {
    with_fixture(
        |_| {},
        |_, _, fixture| {
            for eye in [DVec3::new(0.0, 3.0, 0.0), DVec3::new(77.7, 3.0, -1.3), DVec3::new(-1e6, 3.0, 2e6)] {
                let uniforms = fixture.technique.uniforms(&view_from(eye));
                let n = fixture.technique.maps.resolution() as f32;
                let texel = Vec2::from(uniforms.centre_tile_uv) * n - 0.5;
                let cell = Vec2::new(uniforms.centre_cell[0] as f32, uniforms.centre_cell[1] as f32);
                assert!((texel - cell).abs().max_element() < 1e-2, "{texel} {cell}");
            }
        },
    );
}

/// Beyond 1,024 vertices a side the mesh takes every other sample; the model stays the same.
#[test]
fn a_fine_tile_is_drawn_with_a_coarser_mesh() {
    let finer = |toml: &mut String| *toml = toml.replace("resolution = 64", "resolution = 512");
    with_fixture(finer, |device, queue, mut fixture| {
        assert_eq!(fixture.technique.maps.mesh_samples(), 256);
        bring_to(device, queue, &mut fixture.technique, 1.0);
        let view = view_from(DVec3::new(5.0, 3.0, 5.0));
        let grid = [[0.0, 0.0], [-7.0, 11.0], [30.0, 2.0]];
        let maps = &fixture.technique.maps;
        let centre = maps.nearest_cell(DVec2::splat(5.0)).as_dvec2() * maps.cell_m();
        for ([x, z], [position, _]) in grid.iter().zip(read_vertices(device, queue, &fixture, &view, &grid)) {
            let rest = centre + DVec2::new(f64::from(*x), f64::from(*z)) * maps.cell_m();
            let height = maps.model().sample(rest, 1.0).displacement_m.y;
            assert!((f64::from(position[1]) + 3.0 - height).abs() < 1e-3);
        }
    });
}

/// A flat sea leaves the bump map as it is; on a slope its up is the slope's normal.
#[test]
fn the_frame_is_the_texts() {
    assert_eq!(normals::bump_frame(Vec2::ZERO), glam::Mat3::IDENTITY);
    let frame = normals::bump_frame(Vec2::new(0.75, -0.2));
    assert!((frame.x_axis - Vec3::new(0.8, 0.6, 0.0)).length() < 1e-6);
    assert!((frame.z_axis - Vec3::new(0.0, -0.2, 1.0).normalize()).length() < 1e-6);
    let up = normals::world_from_bump(frame, Vec3::Y);
    assert!((up - Vec3::new(-0.75, 1.0, 0.2).normalize()).length() < 1e-6);
}

/// At most half of the light of the sky comes back out of clear water, and it is blue.
#[test]
fn clear_water_is_dark_and_blue() {
    with_fixture(
        |_| {},
        |_, _, fixture| {
            let table = super::gpu::water_colors(&fixture.technique.settings, Vec3::ONE, 0.5);
            assert_eq!(table.len(), WATER_COLORS);
            for [r, g, b, a] in table {
                assert!(b > g && g > r && b.to_f32() < 0.5 && a.to_f32() == 1.0);
            }
        },
    );
}
