//! One picture, whoever works the sea out.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use whitecap_render::environment::Environment;
use whitecap_render::gpu::{for_tests::gpu, read_texture};
use whitecap_render::surface::Backend;
use whitecap_render::{Gpu, TargetFormat, View, Water, WaterOptions};
use whitecap_scene::Scene;

const SIZE: [u32; 2] = [160, 90];

fn attachment(gpu: &Gpu, format: wgpu::TextureFormat) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: SIZE[0], height: SIZE[1], depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}

/// The scene at `time_s`, a moment after it was drawn at another one.
fn picture(gpu: &Gpu, scene: &Scene, backend: Backend, time_s: f64) -> Vec<u8> {
    let (device, queue) = (&gpu.device, &gpu.queue);
    let target = TargetFormat::default();
    let options = WaterOptions { backend: Some(backend) };
    let environment = Environment::new(scene).unwrap();
    let mut water = Water::with_options(device, queue, scene, &environment, target, &options).unwrap();
    let (color, depth) = (attachment(gpu, target.color), attachment(gpu, target.depth));
    let [color_view, depth_view] = [&color, &depth].map(|t| t.create_view(&Default::default()));
    let view = View::of_camera(&scene.camera, SIZE);
    for time_s in [time_s - 3.0, time_s] {
        let mut encoder = device.create_command_encoder(&Default::default());
        water.prepare(device, queue, &mut encoder, &[view], time_s).unwrap();
        let clear = wgpu::LoadOp::Clear(wgpu::Color::BLACK);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: None,
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &color_view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: clear, store: wgpu::StoreOp::Store },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &depth_view,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(target.far_depth()),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        water.draw(&mut pass, 0);
        water.draw_sky(&mut pass, 0);
        drop(pass);
        queue.submit([encoder.finish()]);
    }
    gpu.check().unwrap();
    read_texture(device, queue, &color).unwrap()
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
