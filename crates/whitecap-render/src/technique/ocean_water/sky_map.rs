//! The sky as the text's hardware held it: a cube map of 8-bit display values.
//!
//! Values above white are cut off before anything is filtered, so a sun fades where it is averaged with its
//! surroundings, as it did then. Alpha is the glow map.

use super::super::Build;
use crate::environment::FACE_SIZE;
use crate::gpu::resources::{PipelineRequest, bind_group, linear_sampler};
use crate::shader_lib;

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// Renders the environment into an 8-bit cube map with a mip chain of plain means, once.
pub(super) fn sky_map(build: &Build<'_>) -> wgpu::TextureView {
    let (device, shared) = (build.device, build.shared);
    let levels = FACE_SIZE.ilog2() + 1;
    let map = device.create_texture(&wgpu::TextureDescriptor {
        label: Some("8-bit sky"),
        size: wgpu::Extent3d { width: FACE_SIZE, height: FACE_SIZE, depth_or_array_layers: 6 },
        mip_level_count: levels,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: FORMAT,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    });
    let request = PipelineRequest {
        label: "8-bit sky",
        shader: &shader_lib::OCEAN_WATER_SKY,
        constants: &[],
        groups: &[None, Some(&shared.environment_layout)],
        vertices: &[],
        color: FORMAT,
        depth: None,
        multisample: Default::default(),
    };
    let pipeline = request.create(device);
    let cube = |base_mip_level, mip_level_count| {
        map.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(wgpu::TextureViewDimension::Cube),
            base_mip_level,
            mip_level_count,
            ..Default::default()
        })
    };
    let sampler = linear_sampler(device, "8-bit sky", wgpu::AddressMode::ClampToEdge);
    // The layout has a sun, which the shader does not look at.
    let sun = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("no sun"),
        size: 256,
        usage: wgpu::BufferUsages::UNIFORM,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    for level in 0..levels {
        let finer = level.checked_sub(1).map(|finer| {
            let source = cube(finer, Some(1));
            use wgpu::BindingResource::{Sampler, TextureView};
            let resources = [TextureView(&source), Sampler(&sampler), sun.as_entire_binding()];
            bind_group(device, "8-bit sky", &shared.environment_layout, resources)
        });
        for face in 0..6 {
            let target = map.create_view(&wgpu::TextureViewDescriptor {
                dimension: Some(wgpu::TextureViewDimension::D2),
                base_mip_level: level,
                mip_level_count: Some(1),
                base_array_layer: face,
                array_layer_count: Some(1),
                ..Default::default()
            });
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("8-bit sky"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &target,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                        store: wgpu::StoreOp::Store,
                    },
                })],
                ..Default::default()
            });
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(1, finer.as_ref().unwrap_or(&shared.environment_group), &[]);
            pass.draw(3 * face..3 * face + 3, 0..1);
        }
    }
    build.queue.submit([encoder.finish()]);
    cube(0, None)
}
