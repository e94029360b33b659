//! The lake's pipeline, buffers and layouts.

use super::super::Build;
use crate::geometry::SquareGrid;
use crate::gpu::resources::{self, IndexedMesh, PipelineRequest, linear_sampler};
use crate::shader_lib;
use crate::surface::GpuSines;
use crate::uniforms::{ViewSlots, sampler_entry, texture_entry};
use whitecap_scene::technique as settings;

/// Layout twin of `GpuLakeConstants` in `pixel.wesl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuLakeConstants {
    pub(super) reflection_perturbation: [f32; 2],
    pub(super) refraction_perturbation: [f32; 2],
    pub(super) reflection_tint: [f32; 4],
    pub(super) refraction_tint: [f32; 4],
    pub(super) highlight_color: [f32; 4],
}

/// Layout twin of `GpuLake` in `surface.wesl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuLake {
    pub(super) sines: GpuSines,
    pub(super) constants: GpuLakeConstants,
    pub(super) map_x: [f32; 4],
    pub(super) map_y: [f32; 4],
    pub(super) map_w: [f32; 4],
    pub(super) centre_from_eye: [f32; 3],
    pub(super) size_m: f32,
    pub(super) bump_tiling: [f32; 4],
    pub(super) bump_centre: [f32; 4],
    pub(super) options: u32,
    pub(super) padding: [u32; 3],
}

pub(super) const SWAP_REFRACTION: u32 = 1;
pub(super) const SWAP_BUMP: u32 = 2;
pub(super) const NORMALISE_VECTORS: u32 = 4;

impl GpuLakeConstants {
    pub(super) fn new(settings: &settings::RipplingLake) -> GpuLakeConstants {
        let pair = |pair: [f64; 2]| pair.map(|value| value as f32);
        let color = |[r, g, b]: [f64; 3]| [r as f32, g as f32, b as f32, 0.0];
        GpuLakeConstants {
            reflection_perturbation: pair(settings.reflection_perturbation),
            refraction_perturbation: pair(settings.refraction_perturbation),
            reflection_tint: color(settings.reflection_tint),
            refraction_tint: color(settings.refraction_tint),
            highlight_color: color(settings.highlight_color),
        }
    }
}

/// The option bits that `surface.wesl` names.
pub(super) fn options(settings: &settings::RipplingLake) -> u32 {
    let swap = match settings.swap_uv {
        settings::SwapUv::None => 0,
        settings::SwapUv::Refraction => SWAP_REFRACTION,
        settings::SwapUv::Bump => SWAP_BUMP,
    };
    let normalise = if settings.normalised_vectors { NORMALISE_VECTORS } else { 0 };
    swap | normalise
}

pub(super) struct Pipeline {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    bump: wgpu::TextureView,
    repeat: wgpu::Sampler,
    clamp: wgpu::Sampler,
    /// One for each view, since each has maps of its own.
    groups: Vec<wgpu::BindGroup>,
    mesh: IndexedMesh,
}

impl Pipeline {
    pub(super) fn new(build: &Build<'_>, grid: &SquareGrid, bump: wgpu::TextureView) -> Pipeline {
        let device = build.device;
        let layout = group_layout(device);
        let vertices = bytemuck::cast_slice(&grid.vertices);
        Pipeline {
            pipeline: pipeline(build, &layout),
            layout,
            bump,
            repeat: linear_sampler(device, "bump map", wgpu::AddressMode::Repeat),
            clamp: linear_sampler(device, "planar maps", wgpu::AddressMode::ClampToEdge),
            groups: Vec::new(),
            mesh: IndexedMesh::new(device, build.queue, "lake", vertices, &grid.indices),
        }
    }

    /// Gives view `index` its maps, once: they stay the same textures. Views are met in order.
    pub(super) fn bind_maps(
        &mut self,
        device: &wgpu::Device,
        slots: &ViewSlots<GpuLake>,
        index: usize,
        [reflection, refraction]: [&wgpu::TextureView; 2],
    ) {
        if index < self.groups.len() {
            return;
        }
        use wgpu::BindingResource::{Sampler, TextureView};
        let resources = [
            slots.binding(),
            TextureView(&self.bump),
            Sampler(&self.repeat),
            TextureView(reflection),
            TextureView(refraction),
            Sampler(&self.clamp),
        ];
        self.groups.push(resources::bind_group(device, "rippling lake", &self.layout, resources));
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        let Some(group) = self.groups.get(view) else { return };
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(2, group, &[ViewSlots::<GpuLake>::offset(view)]);
        self.mesh.draw(pass);
    }
}

/// Bind group 2, as `rippling_lake.wesl` declares it.
fn group_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    use wgpu::ShaderStages as S;
    let d2 = wgpu::TextureViewDimension::D2;
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("rippling lake"),
        entries: &[
            ViewSlots::<GpuLake>::layout_entry(0, S::VERTEX_FRAGMENT),
            texture_entry(1, S::FRAGMENT, d2, true),
            sampler_entry(2, S::FRAGMENT),
            texture_entry(3, S::FRAGMENT, d2, true),
            texture_entry(4, S::FRAGMENT, d2, true),
            sampler_entry(5, S::FRAGMENT),
        ],
    })
}

fn pipeline(build: &Build<'_>, group: &wgpu::BindGroupLayout) -> wgpu::RenderPipeline {
    let shared = build.shared;
    let request = PipelineRequest {
        label: "rippling lake",
        shader: &shader_lib::RIPPLING_LAKE,
        constants: &[],
        groups: &[Some(&shared.view_layout), Some(&shared.environment_layout), Some(group)],
        vertices: &[Some(wgpu::VertexBufferLayout {
            array_stride: 8,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![0 => Float32x2],
        })],
        color: shared.target.color,
        depth: Some(shared.target.depth_state(true)),
        multisample: shared.target.multisample(),
    };
    request.create(build.device)
}
