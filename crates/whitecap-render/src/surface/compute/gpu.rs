//! Compute passes and buffers in a line each.

use crate::gpu::resources::buffer;
use crate::shader_lib::Shader;

/// One compute pipeline with its bindings and the number of workgroups that it always runs with.
pub(super) struct Pass {
    pipeline: wgpu::ComputePipeline,
    group: wgpu::BindGroup,
    workgroups: [u32; 3],
}

impl Pass {
    /// `buffers` are whole, at bindings 0, 1, 2 … of group 0.
    pub(super) fn new(
        device: &wgpu::Device,
        shader: &Shader,
        entry: &str,
        buffers: &[&wgpu::Buffer],
        workgroups: [u32; 3],
    ) -> Pass {
        let bindings: Vec<_> = (0..).zip(buffers.iter().map(|buffer| buffer.as_entire_binding())).collect();
        Pass::with_bindings(device, shader, entry, &bindings, workgroups)
    }

    /// As [`Pass::new`], with each binding's number and resources of any kind.
    pub(super) fn with_bindings(
        device: &wgpu::Device,
        shader: &Shader,
        entry: &str,
        bindings: &[(u32, wgpu::BindingResource<'_>)],
        workgroups: [u32; 3],
    ) -> Pass {
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(shader.name),
            layout: None,
            module: &shader.module(device),
            entry_point: Some(entry),
            compilation_options: Default::default(),
            cache: None,
        });
        let entries: Vec<_> = bindings
            .iter()
            .map(|(binding, resource)| wgpu::BindGroupEntry { binding: *binding, resource: resource.clone() })
            .collect();
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(shader.name),
            layout: &pipeline.get_bind_group_layout(0),
            entries: &entries,
        });
        Pass { pipeline, group, workgroups }
    }

    pub(super) fn dispatch(&self, pass: &mut wgpu::ComputePass<'_>) {
        let [x, y, z] = self.workgroups;
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        pass.dispatch_workgroups(x, y, z);
    }
}

/// A buffer that passes write and later ones read. It can be read back.
pub(super) fn storage(device: &wgpu::Device, label: &str, bytes: u64) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: bytes,
        usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    })
}

/// A uniform buffer with this value.
pub(super) fn uniform<T: bytemuck::Pod>(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    label: &str,
    value: &T,
) -> wgpu::Buffer {
    buffer(device, queue, label, bytemuck::bytes_of(value), wgpu::BufferUsages::UNIFORM)
}
