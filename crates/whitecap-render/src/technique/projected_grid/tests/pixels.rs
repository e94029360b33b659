//! The water's own stages from end to end, on a level sea under an even sky: what is looked up where, and what is
//! mixed by which share.

use super::*;
use crate::environment::{CubeMap, display_from_linear};
use crate::gpu::for_tests::Canvas;
use crate::gpu::resources::{texture_2d, write_level};
use crate::pass::planar_tests::{RED, block, is_red};
use glam::camera::rh::proj::directx::perspective;
use std::sync::OnceLock;
use whitecap_scene::object::Model;
use whitecap_waves::optics::classics::{ProjectedGridConstants, projected_grid_pixel};

const SIZE: u32 = 33;

/// Of the sky, linear.
const SKY: Vec3 = Vec3::new(0.1, 0.3, 0.7);

/// An even sky without a sun.
fn environment() -> &'static Environment {
    static EVEN: OnceLock<Environment> = OnceLock::new();
    EVEN.get_or_init(|| Environment {
        cube: CubeMap::bake(|_| SKY, None, 1),
        sun: None,
        irradiance: Vec3::ONE,
        skylight: Vec3::ONE,
        daylight: 1.0,
        light: None,
    })
}

fn sky() -> DVec3 {
    SKY.to_array().map(|linear| f64::from(display_from_linear(linear))).into()
}

/// The demo's without its sun, on a sea without waves.
fn level(scene: &mut Scene) {
    let whitecap_scene::sea::SeaModel::Perlin(sea) = &mut scene.sea.model else { panic!() };
    sea.strength_m = 0.0;
    settings(scene).sun_strength = 0.0;
}

/// Maps that stand in for those of a view.
struct Stands {
    normal: Vec3,
    reflection: fn(DVec2) -> [f64; 4],
    refraction: fn(DVec2) -> [f64; 4],
}

/// A map of so many texels along a side.
fn map_of(side: u32, texel: impl Fn(DVec2) -> [f64; 4]) -> wgpu::TextureView {
    let gpu = gpu().unwrap();
    let format = wgpu::TextureFormat::Rgba16Float;
    let texture = texture_2d(&gpu.device, "stand", [side; 2], 1, format, wgpu::TextureUsages::COPY_DST);
    let at = |i: u32| (DVec2::new(f64::from(i % side), f64::from(i / side)) + 0.5) / f64::from(side);
    let texels: Vec<[f16; 4]> = (0..side * side).map(|i| texel(at(i)).map(f16::from_f64)).collect();
    write_level(&gpu.queue, &texture, 0, bytemuck::cast_slice(&texels));
    texture.create_view(&Default::default())
}

/// The water alone at time 0 over magenta, display-referred.
fn drawn(
    edit: impl Fn(&mut Scene),
    models: Vec<Model>,
    target: TargetFormat,
    view: View,
    stands: Option<&Stands>,
) -> Option<Vec<DVec3>> {
    let gpu = gpu()?;
    let (device, queue) = (&gpu.device, &gpu.queue);
    let mut scene = whitecap_scene::open("projected-grid").unwrap();
    level(&mut scene);
    edit(&mut scene);
    let shared = Shared::new(device, queue, environment(), target);
    let objects = Objects::of_models(device, queue, models, None);
    let build = Build::under_white_light(device, queue, &scene, &shared, &objects);
    let whitecap_scene::Technique::ProjectedGrid(settings) = &scene.technique else { panic!() };
    let mut technique = ProjectedGrid::new(&build, settings).unwrap();
    shared.write_views(queue, &[view]).unwrap();
    objects.prepare(queue, &[view], 0.0);
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut frame = Frame {
        device,
        queue,
        encoder: &mut encoder,
        views: &[view],
        time_s: 0.0,
        shared: &shared,
        objects: &objects,
        timer: None,
    };
    technique.prepare(&mut frame).unwrap();
    if let Some(stands) = stands {
        let [normals, reflection, refraction] = [
            map_of(1, |_| stands.normal.as_dvec3().extend(0.0).to_array()),
            map_of(256, stands.reflection),
            map_of(256, stands.refraction),
        ];
        let maps = ViewMaps {
            normals: Some(&normals),
            reflection: Some(&reflection),
            refraction: Some(&refraction),
        };
        technique.views[0].group = technique.pipeline.view_group(device, &maps);
        let options = gpu::NORMAL_MAP | gpu::LOCAL_REFLECTIONS | gpu::REFRACTION_MAP;
        let uniforms = GpuProjectedGrid { options, ..technique.uniforms(&view, true) };
        technique.pipeline.slots.write(queue, 0, &uniforms);
    }

    let canvas = Canvas::new(gpu, &target, view.size_px);
    let magenta = wgpu::Color { r: 1.0, g: 0.0, b: 1.0, a: 1.0 };
    canvas.draw(&mut encoder, magenta, |pass| {
        shared.bind(pass, 0, Role::Main);
        technique.draw(pass, 0);
    });
    queue.submit([encoder.finish()]);
    let pixels = canvas.pixels();
    let display = |pixel: &[u8]| DVec3::new(pixel[0].into(), pixel[1].into(), pixel[2].into()) / 255.0;
    Some(pixels.chunks(4).map(display).collect())
}

fn view_of(eye_m: DVec3, toward: DVec3) -> View {
    let look_at_m = (eye_m + toward).to_array();
    let camera = Camera { position_m: eye_m.to_array(), look_at_m, vertical_fov_deg: 40.0 };
    View::of_camera(&camera, [SIZE; 2])
}

/// Of the pixel in the middle.
const MIDDLE: usize = (SIZE * (SIZE / 2) + SIZE / 2) as usize;

fn close(seen: DVec3, expected: DVec3, levels: f64, what: &str) {
    let worst = (seen - expected).abs().max_element() * 255.0;
    assert!(worst < levels, "{what}: {seen} instead of {expected}");
}

/// The share that Fresnel's equations give of the sky, the rest of the water's colour: grazing, slanting and steep.
#[test]
fn level_water_mixes_sky_and_water_by_fresnel() {
    for cos in [0.1, 0.4, 0.9_f64] {
        let view = view_of(DVec3::new(3.0, 4.0, -2.0), DVec3::new((1.0 - cos * cos).sqrt(), -cos, 0.0));
        let Some(pixels) = drawn(|_| {}, Vec::new(), TargetFormat::default(), view, None) else { return };
        let water = DVec3::new(0.17, 0.27, 0.26);
        let expected = water.lerp(sky(), fresnel_exact(cos, 1.333));
        close(pixels[MIDDLE], expected, 1.5, &format!("cosine {cos}"));
    }
}

/// A block that stands over the water is seen in it where its mirror image is, as solid as it is, and the sky
/// everywhere else.
#[test]
fn level_water_mirrors_a_block_and_beside_it_the_sky() {
    let red = || vec![block([-1.0, 0.3, -6.0], [1.0, 2.5, -4.0], RED)];
    let edit = |scene: &mut Scene| settings(scene).water_color = [0.0; 3];
    let view = view_of(DVec3::new(0.0, 2.0, 4.0), DVec3::new(0.0, -3.4, -8.0));
    let Some(pixels) = drawn(edit, red(), TargetFormat::default(), view, None) else { return };
    let Some(bare) = drawn(edit, Vec::new(), TargetFormat::default(), view, None) else { return };
    let texel = |pixel: DVec3| (255.0 * pixel).to_array().map(|level| level.round() as u8);
    let [r, g, b] = texel(pixels[MIDDLE]);
    assert!(is_red(&[r, g, b, 255]), "{} in the block's mirror image", pixels[MIDDLE]);
    for beside in [MIDDLE - 14, MIDDLE + 14] {
        close(pixels[beside], bare[beside], 0.5, "beside it");
        assert!(bare[beside].z > 0.05, "no sky in the water: {}", bare[beside]);
    }
}

/// Tilted water over maps that tell where they were read, from all of the pixel stage's parts. The eye is close
/// over the water, where the depth is far from both of its ends, and both senses of depth mean the same.
#[test]
fn tilted_water_is_the_twins() {
    // Multiples of 1/64, which a half float holds.
    let normal = DVec3::new(0.25, 0.9375, -0.125);
    let stands = Stands {
        normal: normal.as_vec3(),
        reflection: |at| [at.x, at.y, 0.5, 0.25],
        refraction: |at| [1.0 - at.y, at.x, 0.25, 1.0],
    };
    let edit = |scene: &mut Scene| settings(scene).sun_strength = 0.1;
    let reversed = TargetFormat::default();
    let usual = TargetFormat { depth_compare: wgpu::CompareFunction::Less, ..reversed };
    for toward in [DVec3::NEG_Y, DVec3::new(0.5, -0.7, 0.3), DVec3::new(-0.2, -0.4, -1.0)] {
        let view = view_of(DVec3::new(0.0, 0.3, 0.0), toward);
        let finite = View { clip_from_view: perspective(40_f32.to_radians(), 1.0, 0.1, 1e6), ..view };
        for (target, view) in [(reversed, view), (usual, finite)] {
            let Some(pixels) = drawn(edit, Vec::new(), target, view, Some(&stands)) else { return };
            for (x, y) in [(16, 16), (8, 20), (22, 10)] {
                let what = format!("({x}, {y}) toward {toward}, {:?}", target.depth_compare);
                let screen = (DVec2::new(x as f64, y as f64) + 0.5) / f64::from(SIZE);
                let clip_from_eye_world = view.clip_from_eye_world().as_dmat4();
                let ndc = DVec2::new(2.0 * screen.x - 1.0, 1.0 - 2.0 * screen.y).extend(0.5);
                let ray = clip_from_eye_world.inverse().project_point3(ndc);
                let water = ray * (-view.eye_m.y / ray.y);
                let z = clip_from_eye_world.project_point3(water).z;
                let depth = if target.far_depth() == 0.0 { 1.0 - z } else { z };
                assert!((0.55..0.95).contains(&depth), "{what}: a depth of {depth}");
                // The text's z runs north.
                let north = |v: DVec3| DVec3::new(v.x, v.y, -v.z);
                let at = mirrored_coordinates(screen, depth, 0.1, north(normal));
                let [r, g, b, _] = (stands.refraction)(at);
                let twin = projected_grid_pixel(
                    (0.5 + 0.5 * north(normal)).to_array(),
                    north(water.normalize()),
                    (screen, depth),
                    &ProjectedGridConstants {
                        sun: DVec3::Y,
                        sun_strength: 0.1,
                        water_color: [r, g, b],
                        ..Default::default()
                    },
                    |_| sky().to_array(),
                    stands.reflection,
                );
                close(pixels[SIZE as usize * y + x], twin.color, 1.5, &what);
            }
        }
    }
}
