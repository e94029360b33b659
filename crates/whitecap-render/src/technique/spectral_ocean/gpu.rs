//! The spectral ocean's pipeline, buffers and layouts.

use super::super::Build;
use crate::environment::Air;
use crate::geometry::NestedGrid;
use crate::gpu::resources::{PipelineRequest, bind_group, buffer, linear_sampler};
use crate::shader_lib::{self, GpuPatchwork, GpuWaterLight, Shader};
use crate::surface::{FoamMaps, GpuFoam, TileMaps};
use crate::uniforms::{ViewSlots, sampler_entry, texture_entry, uniform_entry};
use std::ops::Range;

/// Tiles that the shader reads.
pub(super) const MAX_CASCADES: usize = 4;
/// Levels of the mesh that the uniform has room for.
pub(super) const MAX_LEVELS: usize = 12;

/// Layout twin of `GpuCascade` in `surface.wesl`.
#[repr(C)]
#[derive(Clone, Copy, Default, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuCascade {
    pub(super) eye_in_tile: [f32; 2],
    pub(super) tiles_per_m: f32,
    pub(super) samples: f32,
    pub(super) fade_start_m: f32,
    pub(super) fade_end_m: f32,
    pub(super) half_texel: f32,
    pub(super) padding: u32,
    pub(super) slope_shape: [f32; 3],
    pub(super) end: u32,
    pub(super) patchwork: GpuPatchwork,
}

/// Layout twin of `GpuSpectralOcean` in `surface.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuSpectralOcean {
    pub(super) level_origins: [[f32; 4]; MAX_LEVELS / 2],
    pub(super) cascades: [GpuCascade; MAX_CASCADES],
    pub(super) cell_m: f32,
    pub(super) eye_height_m: f32,
    pub(super) earth_radius_m: f32,
    pub(super) cascade_count: u32,
    pub(super) foam: GpuFoam,
}

/// Layout twin of `GpuWaters` in `spectral_ocean.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuWaters {
    pub(super) light: GpuWaterLight,
    pub(super) slopes_beyond: [f32; 3],
    pub(super) depth_m: f32,
    pub(super) slopes_whole: [f32; 3],
    pub(super) gap: u32,
    pub(super) sun_klx: [f32; 3],
    pub(super) padding: u32,
    pub(super) sky_klx: [f32; 3],
    pub(super) sun_radius_rad: f32,
    pub(super) toward_sun: [f32; 3],
    pub(super) end: u32,
}

pub(super) struct Pipeline {
    pipeline: wgpu::RenderPipeline,
    aux: Option<wgpu::RenderPipeline>,
    group: wgpu::BindGroup,
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
}

impl Pipeline {
    pub(super) fn new(
        build: &Build<'_>,
        grid: &NestedGrid,
        tiles: &[TileMaps],
        sewn: usize,
        foam: &FoamMaps,
        waters: &GpuWaters,
        slots: &ViewSlots<GpuSpectralOcean>,
    ) -> Pipeline {
        let (device, queue) = (build.device, build.queue);
        let layout = group_layout(device);
        let contents = |label, bytes, usage| buffer(device, queue, label, bytes, usage);
        let waters = contents("waters", bytemuck::bytes_of(waters), wgpu::BufferUsages::UNIFORM);
        let constants = constants(build, tiles.len(), sewn, foam);
        Pipeline {
            pipeline: pipeline(build, &layout, &shader_of(build), &constants),
            aux: build.aux.then(|| pipeline(build, &layout, &shader_lib::SPECTRAL_OCEAN_AUX, &constants)),
            group: ocean_group(device, &layout, tiles, foam, &waters, slots),
            vertices: contents(
                "nested grid",
                bytemuck::cast_slice(&grid.vertices),
                wgpu::BufferUsages::VERTEX,
            ),
            indices: contents("nested grid", bytemuck::cast_slice(&grid.indices), wgpu::BufferUsages::INDEX),
        }
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view_offset: u32, parts: &[Range<u32>]) {
        self.draw_through(&self.pipeline, pass, view_offset, parts);
    }

    /// Answers whether it was built for this.
    pub(super) fn draw_aux(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        view_offset: u32,
        parts: &[Range<u32>],
    ) -> bool {
        let Some(pipeline) = &self.aux else { return false };
        self.draw_through(pipeline, pass, view_offset, parts);
        true
    }

    fn draw_through(
        &self,
        pipeline: &wgpu::RenderPipeline,
        pass: &mut wgpu::RenderPass<'_>,
        view_offset: u32,
        parts: &[Range<u32>],
    ) {
        pass.set_pipeline(pipeline);
        pass.set_bind_group(2, &self.group, &[view_offset]);
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        for part in parts {
            pass.draw_indexed(part.clone(), 0, 0..1);
        }
    }
}

/// Bind group 2, as `surface.wesl` and `spectral_ocean.wesl` declare it.
pub(super) fn group_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    use wgpu::ShaderStages as S;
    let d2 = wgpu::TextureViewDimension::D2;
    let displacement = |binding| texture_entry(binding, S::VERTEX | S::COMPUTE, d2, false);
    let normals = |binding| texture_entry(binding, S::FRAGMENT, d2, true);
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("spectral ocean"),
        entries: &[
            ViewSlots::<GpuSpectralOcean>::layout_entry(0, S::VERTEX_FRAGMENT | S::COMPUTE),
            displacement(1),
            displacement(2),
            displacement(3),
            displacement(4),
            normals(5),
            normals(6),
            normals(7),
            normals(8),
            sampler_entry(9, S::FRAGMENT),
            texture_entry(10, S::FRAGMENT, wgpu::TextureViewDimension::D2Array, true),
            texture_entry(11, S::FRAGMENT, d2, true),
            uniform_entry(12, S::FRAGMENT),
        ],
    })
}

pub(super) fn ocean_group(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    tiles: &[TileMaps],
    foam: &FoamMaps,
    waters: &wgpu::Buffer,
    slots: &ViewSlots<GpuSpectralOcean>,
) -> wgpu::BindGroup {
    // A place that no tile fills holds the last one's map, which is not read there.
    let views = |map: fn(&TileMaps) -> &wgpu::Texture| -> Vec<wgpu::TextureView> {
        let maps = (0..MAX_CASCADES).filter_map(|i| tiles.get(i).or(tiles.last()));
        maps.map(|tile| map(tile).create_view(&Default::default())).collect()
    };
    let (displacements, normals) =
        (views(|maps| &maps.textures.displacement), views(|maps| &maps.textures.normals));
    let repeating = linear_sampler(device, "spectral ocean", wgpu::AddressMode::Repeat);
    use wgpu::BindingResource::{Sampler, TextureView};
    let textures = displacements.iter().chain(&normals).map(TextureView);
    let (memory, structure) = (foam.maps(), foam.structure());
    let rest =
        [Sampler(&repeating), TextureView(&memory), TextureView(&structure), waters.as_entire_binding()];
    let resources = std::iter::once(slots.binding()).chain(textures).chain(rest);
    bind_group(device, "spectral ocean", layout, resources)
}

/// A still is made of samples that stand for less than a pixel.
fn shader_of(build: &Build<'_>) -> Shader {
    let is_still = build.shared.target.sample_shading;
    if is_still { shader_lib::SPECTRAL_OCEAN_PER_SAMPLE } else { shader_lib::SPECTRAL_OCEAN }
}

/// What the shader is told when it is made.
fn constants(build: &Build<'_>, cascades: usize, sewn: usize, foam: &FoamMaps) -> Vec<(&'static str, f64)> {
    let under_panorama = build.light.is_some_and(|light| matches!(light.air, Air::Photographed { .. }));
    let mut constants = vec![
        ("CASCADES", cascades as f64),
        ("SEWN_TILES", sewn as f64),
        ("FOAM_TILES", foam.tile_count() as f64),
        ("SEWN_FOAM_TILES", foam.sewn_count() as f64),
        ("UNDER_PANORAMA", f64::from(u8::from(under_panorama))),
    ];
    if let Some(feature) = build.without {
        constants.retain(|(name, _)| *name != feature.constant());
        constants.push((feature.constant(), 0.0));
    }
    constants
}

fn pipeline(
    build: &Build<'_>,
    group: &wgpu::BindGroupLayout,
    shader: &Shader,
    constants: &[(&str, f64)],
) -> wgpu::RenderPipeline {
    let (device, shared) = (build.device, build.shared);
    let request = PipelineRequest {
        label: "spectral ocean",
        shader,
        constants,
        groups: &[Some(&shared.view_layout), Some(&shared.environment_layout), Some(group)],
        vertices: &[Some(wgpu::VertexBufferLayout {
            array_stride: 12,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![0 => Float32x3],
        })],
        color: shared.target.color,
        depth: Some(shared.target.depth_state(true)),
        multisample: shared.target.multisample(),
    };
    request.create(device)
}
