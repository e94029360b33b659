//! One picture, whoever works the sea out.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use whitecap_render::environment::Environment;
use whitecap_render::gpu::for_tests::{Canvas, gpu};
use whitecap_render::surface::Backend;
use whitecap_render::{Gpu, TargetFormat, View, Water, WaterOptions};
use whitecap_scene::Scene;

const SIZE: [u32; 2] = [160, 90];

/// The scene at `time_s`, a moment after it was drawn at another one.
fn picture(gpu: &Gpu, scene: &Scene, backend: Backend, time_s: f64) -> Vec<u8> {
    let (device, queue) = (&gpu.device, &gpu.queue);
    let target = TargetFormat::default();
    let options = WaterOptions { backend: Some(backend), ..Default::default() };
    let environment = Environment::new(scene).unwrap();
    let mut water = Water::with_options(device, queue, scene, &environment, target, &options).unwrap();
    let canvas = Canvas::new(gpu, &target, SIZE);
    let view = View::of_camera(&scene.camera, SIZE);
    for time_s in [time_s - 3.0, time_s] {
        let mut encoder = device.create_command_encoder(&Default::default());
        water.prepare(device, queue, &mut encoder, &[view], time_s).unwrap();
        canvas.draw(&mut encoder, wgpu::Color::BLACK, |pass| {
            water.draw(pass, 0);
            water.draw_sky(pass, 0);
        });
        queue.submit([encoder.finish()]);
    }
    gpu.check().unwrap();
    canvas.pixels()
}

/// To a level of 8 bits, but for the few pixels where a rounding moves an edge or a glint; and another time is another
/// picture.
#[test]
fn both_backends_draw_the_same_sea() {
    let Some(gpu) = gpu() else { return };
    let scene =
        Scene::from_toml(whitecap_scene::named::find("meshuggah").unwrap().toml, "test.toml").unwrap();
    let [cpu, device] = Backend::ALL.map(|backend| picture(gpu, &scene, backend, 2.5));
    let apart = |a: &[u8], b: &[u8]| a.iter().zip(b).filter(|(a, b)| a.abs_diff(**b) > 1).count();
    let allowed = cpu.len() / 500;
    assert!(apart(&cpu, &device) <= allowed, "{} of {}", apart(&cpu, &device), cpu.len());
    let later = picture(gpu, &scene, Backend::Gpu, 6.5);
    assert!(apart(&device, &later) > 10 * allowed);
}
