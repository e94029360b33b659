//! The sky behind everything.

use crate::shader_lib;
use crate::uniforms::Shared;

/// Draws the environment where nothing nearer has been drawn. It goes last: what the water covers is
/// not shaded twice.
pub struct SkyPass {
    pipeline: wgpu::RenderPipeline,
}

impl SkyPass {
    pub(crate) fn new(device: &wgpu::Device, shared: &Shared) -> SkyPass {
        let module = shader_lib::SKY.module(device);
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("sky"),
            bind_group_layouts: &[Some(&shared.view_layout), Some(&shared.environment_layout)],
            immediate_size: 0,
        });
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("sky"),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("vs_main"),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: Some(shared.target.depth_state(false)),
            multisample: shared.target.multisample(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("fs_main"),
                compilation_options: Default::default(),
                targets: &[Some(shared.target.color.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        SkyPass { pipeline }
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, shared: &Shared, view: usize) {
        pass.set_pipeline(&self.pipeline);
        shared.bind(pass, view);
        pass.draw(0..3, 0..1);
    }
}
