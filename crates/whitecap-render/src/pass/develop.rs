//! The picture that light makes.

use crate::TargetFormat;
use crate::View;
use crate::gpu::resources::{PipelineRequest, bind_group, texture_2d};
use crate::shader_lib;
use crate::uniforms::{Role, Shared, texture_entry};

/// Exposure, tone map and encoding of `light`, as drawing into `target` does them by the way: for light that is a mean of
/// samples. `view` takes the place of the frame's first one.
///
/// Reads: the light. Writes: the answer, which may be copied from.
pub(crate) fn develop(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    encoder: &mut wgpu::CommandEncoder,
    shared: &Shared,
    view: &View,
    light: &wgpu::Texture,
    target: &TargetFormat,
) -> wgpu::Texture {
    let stages = wgpu::ShaderStages::FRAGMENT;
    let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("develop"),
        entries: &[texture_entry(0, stages, wgpu::TextureViewDimension::D2, false)],
    });
    let light_view = light.create_view(&Default::default());
    let group = bind_group(device, "develop", &layout, [wgpu::BindingResource::TextureView(&light_view)]);
    let linear = shared.skies.is_some();
    let request = PipelineRequest {
        label: "develop",
        shader: if linear { &shader_lib::LINEAR_DEVELOP } else { &shader_lib::DEVELOP },
        constants: &[],
        groups: &[Some(&shared.view_layout), Some(&shared.environment_layout), Some(&layout)],
        vertices: &[],
        color: target.color,
        depth: None,
        multisample: Default::default(),
    };
    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
    let size_px = [light.width(), light.height()];
    let picture = texture_2d(device, "developed", size_px, 1, target.color, usage);
    shared.write_view(queue, 0, view, Role::Main, target, 0.0);
    let mut pass = begin_cover(encoder, "develop", &picture);
    pass.set_pipeline(&request.create(device));
    shared.bind(&mut pass, 0, Role::Main);
    pass.set_bind_group(2, &group, &[]);
    pass.draw(0..3, 0..1);
    drop(pass);
    picture
}

/// A pass over all of `texture`, without depth.
pub(super) fn begin_cover<'e>(
    encoder: &'e mut wgpu::CommandEncoder,
    label: &str,
    texture: &wgpu::Texture,
) -> wgpu::RenderPass<'e> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some(label),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: &texture.create_view(&Default::default()),
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                store: wgpu::StoreOp::Store,
            },
        })],
        ..Default::default()
    })
}
