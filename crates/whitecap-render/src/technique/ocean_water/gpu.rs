//! The ocean's pipeline, buffers and layouts.

use super::super::Build;
use crate::geometry::TiledGrid;
use crate::gpu::resources::{self, PipelineRequest, buffer, linear_sampler, rgba8_map, table_1d};
use crate::shader_lib;
use crate::surface::GpuSines;
use crate::uniforms::{ViewSlots, sampler_entry, texture_entry};

/// Layout twin of `GpuOceanWater` in `surface.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuOceanWater {
    pub(super) sines: GpuSines,
    pub(super) centre_bump_uv: [f32; 4],
    pub(super) centre_from_eye: [f32; 3],
    pub(super) glow: f32,
    pub(super) highlight_color: [f32; 3],
    pub(super) bumps_per_m: f32,
}

/// What the pixel shader samples.
pub(super) struct Artwork {
    pub(super) bump_levels: Vec<Vec<[u8; 4]>>,
    pub(super) gradient: Vec<[u8; 4]>,
    pub(super) sky: wgpu::TextureView,
}

pub(super) struct Pipeline {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
    places: wgpu::Buffer,
    indices: wgpu::Buffer,
    index_count: u32,
    /// v5.x of every vertex, for each view.
    damping: Vec<wgpu::Buffer>,
}

impl Pipeline {
    pub(super) fn new(
        build: &Build<'_>,
        grid: &TiledGrid,
        slots: &ViewSlots<GpuOceanWater>,
        artwork: &Artwork,
    ) -> Pipeline {
        let (device, queue) = (build.device, build.queue);
        let layout = group_layout(device);
        let group = bind_group(build, &layout, slots, artwork);
        let pipeline = pipeline(build, &layout);
        let places = bytemuck::cast_slice(&grid.vertices);
        let indices = bytemuck::cast_slice(&grid.indices);
        Pipeline {
            pipeline,
            group,
            places: buffer(device, queue, "ocean", places, wgpu::BufferUsages::VERTEX),
            indices: buffer(device, queue, "ocean", indices, wgpu::BufferUsages::INDEX),
            index_count: grid.indices.len() as u32,
            damping: Vec::new(),
        }
    }

    /// Sets the damping of every vertex as `view` sees it. Views come in order.
    pub(super) fn write_damping(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        view: usize,
        damping: &[f32],
    ) {
        let contents = bytemuck::cast_slice(damping);
        match self.damping.get(view) {
            Some(there) => queue.write_buffer(there, 0, contents),
            None => {
                let made = buffer(device, queue, "ocean damping", contents, wgpu::BufferUsages::VERTEX);
                self.damping.push(made);
            }
        }
    }

    /// One pass, one draw.
    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        let Some(damping) = self.damping.get(view) else { return };
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(2, &self.group, &[ViewSlots::<GpuOceanWater>::offset(view)]);
        pass.set_vertex_buffer(0, self.places.slice(..));
        pass.set_vertex_buffer(1, damping.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.index_count, 0, 0..1);
    }
}

/// Bind group 2, as `surface.wesl` and `ocean_water.wesl` declare it.
fn group_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    use wgpu::ShaderStages as S;
    let d2 = wgpu::TextureViewDimension::D2;
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("ocean-water"),
        entries: &[
            ViewSlots::<GpuOceanWater>::layout_entry(0, S::VERTEX_FRAGMENT),
            texture_entry(1, S::FRAGMENT, d2, true),
            sampler_entry(2, S::FRAGMENT),
            texture_entry(3, S::FRAGMENT, wgpu::TextureViewDimension::Cube, true),
            texture_entry(4, S::FRAGMENT, d2, true),
            sampler_entry(5, S::FRAGMENT),
        ],
    })
}

fn bind_group(
    build: &Build<'_>,
    layout: &wgpu::BindGroupLayout,
    slots: &ViewSlots<GpuOceanWater>,
    artwork: &Artwork,
) -> wgpu::BindGroup {
    let (device, queue) = (build.device, build.queue);
    let size = 1 << (artwork.bump_levels.len().max(1) - 1);
    let bump_map = rgba8_map(device, queue, "ocean bump map", size, &artwork.bump_levels);
    let gradient = table_1d(device, queue, "ocean gradient", &artwork.gradient);
    let sampler = |address| linear_sampler(device, "ocean-water", address);
    let (repeat, clamp) = (sampler(wgpu::AddressMode::Repeat), sampler(wgpu::AddressMode::ClampToEdge));
    use wgpu::BindingResource::{Sampler, TextureView};
    let resources = [
        slots.binding(),
        TextureView(&bump_map),
        Sampler(&repeat),
        TextureView(&artwork.sky),
        TextureView(&gradient),
        Sampler(&clamp),
    ];
    resources::bind_group(device, "ocean-water", layout, resources)
}

fn pipeline(build: &Build<'_>, group: &wgpu::BindGroupLayout) -> wgpu::RenderPipeline {
    let (device, shared) = (build.device, build.shared);
    let per_sample = shared.target.sample_shading && shared.target.sample_count > 1;
    let shader = if per_sample { shader_lib::OCEAN_WATER_PER_SAMPLE } else { shader_lib::OCEAN_WATER };
    let vertex = |stride, attributes| wgpu::VertexBufferLayout {
        array_stride: stride,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes,
    };
    let request = PipelineRequest {
        label: "ocean-water",
        shader: &shader,
        constants: &[],
        groups: &[Some(&shared.view_layout), None, Some(group)],
        vertices: &[
            Some(vertex(8, &wgpu::vertex_attr_array![0 => Float32x2])),
            Some(vertex(4, &wgpu::vertex_attr_array![1 => Float32])),
        ],
        color: shared.target.color,
        depth: Some(shared.target.depth_state(true)),
        multisample: shared.target.multisample(),
    };
    request.create(device)
}
