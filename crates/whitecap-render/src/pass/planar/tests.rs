//! What is on the wrong side of the water is never shown, and what is shown is where it belongs.

use super::*;
use crate::View;
use crate::environment::Environment;
use crate::gpu::{Gpu, for_tests::gpu, read_texture};
use crate::pass::Objects;
use crate::uniforms::Shared;
use glam::{DVec3, Vec2, Vec4Swizzles};
use std::sync::Arc;
use whitecap_scene::Scene;
use whitecap_scene::mesh::Mesh;
use whitecap_scene::object::Model;

pub(crate) const RED: [f32; 3] = [1.0, 0.0, 0.0];
pub(crate) const BLUE: [f32; 3] = [0.0, 0.0, 1.0];

/// A block of one colour between two corners of the world.
pub(crate) fn block(low: [f32; 3], high: [f32; 3], color: [f32; 3]) -> Model {
    let mut mesh = Mesh::default();
    for axis in 0..3 {
        for end in [low, high] {
            let first = mesh.positions.len() as u32;
            for (across, along) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                let mut corner = end;
                corner[(axis + 1) % 3] = [low, high][across][(axis + 1) % 3];
                corner[(axis + 2) % 3] = [low, high][along][(axis + 2) % 3];
                let mut normal = [0.0; 3];
                normal[axis] = if end == low { -1.0 } else { 1.0 };
                mesh.positions.push(corner);
                mesh.normals.push(normal);
                mesh.colors.push(color);
            }
            mesh.indices.extend([0, 1, 2, 2, 1, 3].map(|corner| first + corner));
        }
    }
    let base = whitecap_scene::named::find("meshuggah").unwrap().toml;
    let scene = Scene::from_toml(&format!("{base}\n[[object]]\nmesh = \"duck\"\n"), "test.toml").unwrap();
    Model { object: scene.objects[0].clone(), mesh: Arc::new(mesh) }
}

pub(crate) fn view_of(eye_m: [f64; 3], look_at_m: [f64; 3], size_px: [u32; 2]) -> View {
    let camera = whitecap_scene::Camera { position_m: eye_m, look_at_m, vertical_fov_deg: 50.0 };
    View::of_camera(&camera, size_px)
}

/// Pixels of a map, rows from the top.
pub(crate) struct Map {
    pub(crate) size_px: [u32; 2],
    pub(crate) texels: Vec<[u8; 4]>,
}

impl Map {
    pub(crate) fn read(gpu: &Gpu, texture: &wgpu::Texture) -> Map {
        let bytes = read_texture(&gpu.device, &gpu.queue, texture).unwrap();
        let texels = bytemuck::pod_collect_to_vec::<u8, [u8; 4]>(&bytes);
        Map { size_px: [texture.width(), texture.height()], texels }
    }

    pub(crate) fn count(&self, is: fn(&[u8; 4]) -> bool) -> usize {
        self.texels.iter().filter(|texel| is(texel)).count()
    }

    /// The middle of the pixels that are such, from the upper left corner, in pixels.
    pub(crate) fn middle(&self, is: fn(&[u8; 4]) -> bool) -> Vec2 {
        let width = self.size_px[0] as usize;
        let places = (0..self.texels.len()).filter(|&i| is(&self.texels[i]));
        let sum: Vec2 = places.map(|i| Vec2::new((i % width) as f32 + 0.5, (i / width) as f32 + 0.5)).sum();
        sum / self.count(is) as f32
    }
}

pub(crate) fn is_red(texel: &[u8; 4]) -> bool {
    texel[0] > 12 && texel[2] < texel[0] / 2
}

pub(crate) fn is_blue(texel: &[u8; 4]) -> bool {
    texel[2] > 12 && texel[0] < texel[2] / 2
}

/// Where a place of the world is on a map of this view, in pixels.
fn on_map(view: &View, place_m: DVec3, size_px: [u32; 2]) -> Vec2 {
    let clip = view.clip_from_eye_world() * (place_m - view.eye_m).as_vec3().extend(1.0);
    let ndc = clip.xy() / clip.w;
    (ndc * Vec2::new(0.5, -0.5) + 0.5) * Vec2::new(size_px[0] as f32, size_px[1] as f32)
}

fn render(gpu: &Gpu, models: Vec<Model>, settings: PlanarSettings, views: &[View]) -> Vec<Map> {
    let (device, queue) = (&gpu.device, &gpu.queue);
    let scene = whitecap_scene::open("meshuggah").unwrap();
    let environment = Environment::new(&scene).unwrap();
    let shared = Shared::new(device, queue, &environment, TargetFormat::default());
    let objects = Objects::of_models(device, queue, models, None);
    let build = Build::under_white_light(device, queue, &scene, &shared, &objects);
    let mut pass = PlanarPass::new(&build, settings);
    objects.prepare(queue, views, 0.0);
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut frame = Frame {
        device,
        queue,
        encoder: &mut encoder,
        views,
        time_s: 0.0,
        shared: &shared,
        objects: &objects,
        timer: None,
    };
    for index in 0..views.len() {
        pass.render(&mut frame, index);
    }
    queue.submit([encoder.finish()]);
    (0..views.len()).map(|index| Map::read(gpu, pass.map(device, index).texture())).collect()
}

fn settings(role: Role) -> PlanarSettings {
    PlanarSettings { role, size_px: [256, 128], sky: false, background: [0.0; 4], margin_m: 0.0 }
}

/// Low over the water, from the side, from high up, straight down, a thousand kilometres away from nothing.
fn views() -> Vec<View> {
    let size_px = [320, 180];
    vec![
        view_of([0.0, 0.3, 12.0], [0.0, 0.0, 0.0], size_px),
        view_of([9.0, 3.0, 2.0], [0.0, 0.5, 0.0], size_px),
        view_of([-6.0, 14.0, -6.0], [0.0, 0.0, 0.0], size_px),
        view_of([0.5, 12.0, 0.5], [0.5, 0.0, 0.5], size_px),
    ]
}

/// A red block above the plane, a blue one below it, and a post through it, red above and blue below.
fn both_sides() -> Vec<Model> {
    vec![
        block([-3.0, 0.8, -1.0], [-1.5, 2.0, 1.0], RED),
        block([1.5, -2.0, -1.0], [3.0, -0.8, 1.0], BLUE),
        block([-0.5, 0.001, -0.5], [0.5, 1.5, 0.5], RED),
        block([-0.5, -1.5, -0.5], [0.5, -0.001, 0.5], BLUE),
    ]
}

#[test]
fn maps_never_show_the_wrong_side() {
    let Some(gpu) = gpu() else { return };
    for map in render(gpu, both_sides(), settings(Role::Mirror), &views()) {
        assert!(map.count(is_red) > 20, "the mirror map is empty");
        assert_eq!(map.count(is_blue), 0, "what is under water in the mirror map");
    }
    for map in render(gpu, both_sides(), settings(Role::Refraction), &views()) {
        assert!(map.count(is_blue) > 20, "the refraction map is empty");
        assert_eq!(map.count(is_red), 0, "what is above water in the refraction map");
    }
    // The same pixels would see it: it is the plane that hides it.
    for map in render(gpu, both_sides(), settings(Role::Main), &views()) {
        assert!(map.count(is_red) > 20 && map.count(is_blue) > 20);
    }
}

/// The margin reaches past the plane by what it says, and no further.
#[test]
fn the_margin_is_in_metres() {
    let Some(gpu) = gpu() else { return };
    let plate = |top: f32, color| block([-2.0, top - 0.02, -2.0], [2.0, top, 2.0], color);
    for (role, depth, shown) in [
        (Role::Mirror, 0.05, true),
        (Role::Mirror, 0.12, false),
        (Role::Refraction, -0.05, true),
        (Role::Refraction, -0.13, false),
    ] {
        let settings = PlanarSettings { margin_m: 0.1, ..settings(role) };
        let map = &render(gpu, vec![plate(-depth, BLUE)], settings, &views()[2..3])[0];
        assert_eq!(map.count(is_blue) > 0, shown, "{role:?} {depth}");
    }
}

/// A small block's picture is where the mirror image of the block is, to a pixel; below water it is where the block
/// itself is.
#[test]
fn what_is_mirrored_is_where_its_mirror_image_is() {
    let Some(gpu) = gpu() else { return };
    for place in [DVec3::new(-2.0, 1.0, 0.5), DVec3::new(1.7, 0.4, -2.0), DVec3::new(0.3, 2.5, 0.0)] {
        let half = DVec3::splat(0.12);
        let at = |middle: DVec3| {
            block((middle - half).as_vec3().to_array(), (middle + half).as_vec3().to_array(), RED)
        };
        let image = place * DVec3::new(1.0, -1.0, 1.0);
        for (role, stands) in [(Role::Mirror, place), (Role::Refraction, image)] {
            let maps = render(gpu, vec![at(stands)], settings(role), &views());
            for (map, view) in maps.iter().zip(&views()) {
                let expected = on_map(view, image, map.size_px);
                if !(expected.cmpge(Vec2::splat(6.0)) & expected.cmple(Vec2::new(250.0, 122.0))).all() {
                    continue; // cut by the map's edge
                }
                let seen = map.middle(is_red);
                assert!(seen.distance(expected) < 1.0, "{role:?} {place}: {seen} for {expected}");
            }
        }
    }
}

/// To a level eye the mirrored sky is the sky upside down.
#[test]
fn the_sky_is_mirrored_at_the_horizon() {
    let Some(gpu) = gpu() else { return };
    let view = view_of([0.0, 2.0, 0.0], [30.0, 2.0, 40.0], [320, 180]);
    let map = |role| {
        let settings = PlanarSettings { sky: true, ..settings(role) };
        render(gpu, Vec::new(), settings, &[view]).remove(0)
    };
    let (sky, mirrored) = (map(Role::Main), map(Role::Mirror));
    let width = sky.size_px[0] as usize;
    let upside_down = sky.texels.chunks(width).rev().flatten();
    let worst =
        upside_down.zip(&mirrored.texels).flat_map(|(a, b)| [0, 1, 2].map(|c| a[c].abs_diff(b[c]))).max();
    assert!(worst <= Some(1), "{worst:?} levels");
    assert_ne!(sky.texels, mirrored.texels);
}
