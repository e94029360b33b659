//! The sky behind everything.

use crate::TargetFormat;
use crate::gpu::resources::PipelineRequest;
use crate::shader_lib;
use crate::uniforms::{Role, Shared};

/// Draws the environment where nothing nearer has been drawn. It goes last: what the water covers is
/// not shaded twice.
pub(crate) struct SkyPass {
    pipeline: wgpu::RenderPipeline,
}

impl SkyPass {
    pub(crate) fn new(device: &wgpu::Device, shared: &Shared, target: &TargetFormat) -> SkyPass {
        let request = PipelineRequest {
            label: "sky",
            shader: if shared.skies.is_some() { &shader_lib::LINEAR_SKY } else { &shader_lib::SKY },
            constants: &[],
            groups: &[Some(&shared.view_layout), Some(&shared.environment_layout)],
            vertices: &[],
            color: target.color,
            depth: Some(target.depth_state(false)),
            multisample: target.multisample(),
        };
        SkyPass { pipeline: request.create(device) }
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, shared: &Shared, view: usize, role: Role) {
        pass.set_pipeline(&self.pipeline);
        shared.bind(pass, view, role);
        pass.draw(0..3, 0..1);
    }
}
