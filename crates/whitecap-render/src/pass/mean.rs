//! The mean light of several samples a pixel.

use super::develop::begin_cover;
use crate::gpu::resources::{PipelineRequest, bind_group, buffer, texture_2d};
use crate::shader_lib;
use crate::uniforms::{texture_entry, uniform_entry};

/// Takes in one sample after the other. What it holds does not grow with their number.
///
/// Reads: the texture that samples are drawn into. Writes: [`MeanPass::mean`].
pub(crate) struct MeanPass {
    pipeline: wgpu::RenderPipeline,
    share: wgpu::Buffer,
    means: [wgpu::Texture; 2],
    /// Each reads the other mean than the one that is written with it.
    groups: [wgpu::BindGroup; 2],
    taken: u32,
}

impl MeanPass {
    /// Of what is drawn into `sample`, in its format.
    pub(crate) fn new(device: &wgpu::Device, queue: &wgpu::Queue, sample: &wgpu::Texture) -> MeanPass {
        let size_px = [sample.width(), sample.height()];
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let stages = wgpu::ShaderStages::FRAGMENT;
        let d2 = wgpu::TextureViewDimension::D2;
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("mean"),
            entries: &[
                texture_entry(0, stages, d2, false),
                texture_entry(1, stages, d2, false),
                uniform_entry(2, stages),
            ],
        });
        let share = buffer(device, queue, "share", bytemuck::bytes_of(&1.0_f32), wgpu::BufferUsages::UNIFORM);
        let means = [(); 2].map(|()| texture_2d(device, "mean", size_px, 1, sample.format(), usage));
        let sample_view = sample.create_view(&Default::default());
        let groups = [1, 0].map(|before| {
            let before = means[before].create_view(&Default::default());
            use wgpu::BindingResource::TextureView;
            let resources = [TextureView(&before), TextureView(&sample_view), share.as_entire_binding()];
            bind_group(device, "mean", &layout, resources)
        });
        let request = PipelineRequest {
            label: "mean",
            shader: &shader_lib::MEAN,
            constants: &[],
            groups: &[Some(&layout)],
            vertices: &[],
            color: sample.format(),
            depth: None,
            multisample: Default::default(),
        };
        MeanPass { pipeline: request.create(device), share, means, groups, taken: 0 }
    }

    /// Takes in what has been drawn. Once a submission.
    pub(crate) fn take(&mut self, queue: &wgpu::Queue, encoder: &mut wgpu::CommandEncoder) {
        self.taken += 1;
        queue.write_buffer(&self.share, 0, bytemuck::bytes_of(&(1.0 / self.taken as f32)));
        let mut pass = begin_cover(encoder, "mean", self.mean());
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.groups[self.written()], &[]);
        pass.draw(0..3, 0..1);
    }

    /// The mean of all that have been taken in.
    pub(crate) fn mean(&self) -> &wgpu::Texture {
        &self.means[self.written()]
    }

    fn written(&self) -> usize {
        self.taken as usize % 2
    }
}
