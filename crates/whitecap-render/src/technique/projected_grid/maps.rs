//! The passes that make a view's height map, its normal map and the normal map's mips.

use super::chunk_maps::ChunkMaps;
use super::mesh::GpuVertex;
use crate::geometry::ProjectedGrid;
use crate::gpu::resources::{PipelineRequest, bind_group, linear_sampler, texture_2d};
use crate::shader_lib::{self, Shader};
use crate::technique::Frame;
use crate::uniforms::{ViewSlots, sampler_entry, texture_entry};
use glam::{DVec2, DVec3};
use whitecap_scene::technique::{Pairing, ProjectedGrid as Settings};
use whitecap_waves::model::perlin::PerlinNoise;

const HEIGHTS: wgpu::TextureFormat = wgpu::TextureFormat::R32Float;
const NORMALS: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;

/// Layout twin of `GpuMaps` in `maps.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuMaps {
    pub(super) corners: [[f32; 4]; 4],
    pub(super) chunk_origins: [f32; 4],
    pub(super) chunks_per_m: [f32; 2],
    pub(super) texel: [f32; 2],
    pub(super) amplitude_m: f32,
    pub(super) padding: [u32; 3],
}

impl GpuMaps {
    pub(super) fn new(
        settings: &Settings,
        noise: &PerlinNoise,
        grid: &ProjectedGrid,
        eye_m: DVec3,
    ) -> GpuMaps {
        let parameters = noise.parameters();
        let chunk = noise.chunk_size() as f64;
        // Repeats of each chunk in a unit of scaled distance, metres for a height of 1, texels between the corner
        // of a texel and the place that it stands for.
        let (repeats, strengths, centre) = match settings.pairing {
            Pairing::Faithful => ([0.015625, 0.25], 2.0, 0.0),
            Pairing::Coherent => ([1.0 / chunk, 16.0 / chunk], 65_535.0 / 16_384.0, 0.5 / chunk),
        };
        let per_m = repeats.map(|repeats| parameters.scale_per_m * repeats);
        let eye = DVec2::new(eye_m.x, eye_m.z);
        let origin = |per_m: f64| (eye * per_m).map(|at| at.rem_euclid(1.0) + centre);
        let (first, second) = (origin(per_m[0]).as_vec2(), origin(per_m[1]).as_vec2());
        GpuMaps {
            corners: grid.corners().map(|corner| corner.as_vec4().to_array()),
            chunk_origins: [first.x, first.y, second.x, second.y],
            chunks_per_m: per_m.map(|per_m| per_m as f32),
            texel: [1.0 / settings.map_across as f32, 1.0 / settings.map_down as f32],
            amplitude_m: (strengths * parameters.strength_m) as f32,
            padding: [0; 3],
        }
    }
}

/// A view's normal map.
pub(super) struct NormalMap {
    levels: Vec<wgpu::TextureView>,
    /// What each level but the first is made from.
    finer: Vec<wgpu::BindGroup>,
    pub(super) texture: wgpu::Texture,
}

/// The pipelines, and the height map that all views use one after the other.
pub(super) struct MapPasses {
    size: [u32; 2],
    slots: ViewSlots<GpuMaps>,
    pub(super) heights: wgpu::Texture,
    height_pipeline: wgpu::RenderPipeline,
    height_group: wgpu::BindGroup,
    normal_pipeline: wgpu::RenderPipeline,
    normal_group: wgpu::BindGroup,
    mip_pipeline: wgpu::RenderPipeline,
    mip_layout: wgpu::BindGroupLayout,
}

impl MapPasses {
    pub(super) fn new(device: &wgpu::Device, settings: &Settings, chunks: &ChunkMaps) -> MapPasses {
        use wgpu::BindingResource::{Sampler, TextureView};
        use wgpu::ShaderStages as S;
        let d2 = wgpu::TextureViewDimension::D2;
        let layout = |label, entries: &[wgpu::BindGroupLayoutEntry]| {
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries })
        };
        let uniform = ViewSlots::<GpuMaps>::layout_entry(0, S::VERTEX_FRAGMENT);
        let height_layout = layout(
            "height map",
            &[
                uniform,
                texture_entry(1, S::FRAGMENT, d2, true),
                texture_entry(2, S::FRAGMENT, d2, true),
                sampler_entry(3, S::FRAGMENT),
            ],
        );
        let normal_layout = layout("normal map", &[uniform, texture_entry(1, S::FRAGMENT, d2, false)]);
        let mip_layout = layout("mip", &[texture_entry(0, S::FRAGMENT, d2, false)]);

        let size = [settings.map_across, settings.map_down];
        let slots = ViewSlots::new(device, "height and normal maps");
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let heights = texture_2d(device, "height map", size, 1, HEIGHTS, usage);
        let height_view = heights.create_view(&Default::default());
        let [chunk0, chunk1] = chunks.views();
        let sampler = linear_sampler(device, "noise", wgpu::AddressMode::Repeat);
        let height_resources =
            [slots.binding(), TextureView(&chunk0), TextureView(&chunk1), Sampler(&sampler)];
        let normal_resources = [slots.binding(), TextureView(&height_view)];
        MapPasses {
            size,
            height_pipeline: pipeline(
                device,
                &shader_lib::PROJECTED_GRID_HEIGHTS,
                &height_layout,
                HEIGHTS,
                true,
            ),
            height_group: bind_group(device, "height map", &height_layout, height_resources),
            normal_pipeline: pipeline(
                device,
                &shader_lib::PROJECTED_GRID_NORMALS,
                &normal_layout,
                NORMALS,
                true,
            ),
            normal_group: bind_group(device, "normal map", &normal_layout, normal_resources),
            mip_pipeline: pipeline(device, &shader_lib::PROJECTED_GRID_MIP, &mip_layout, NORMALS, false),
            mip_layout,
            slots,
            heights,
        }
    }

    /// An empty normal map for one view.
    pub(super) fn normal_map(&self, device: &wgpu::Device) -> NormalMap {
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let count = self.size[0].max(self.size[1]).ilog2() + 1;
        let texture = texture_2d(device, "normal map", self.size, count, NORMALS, usage);
        let level = |base_mip_level| {
            let mip_level_count = Some(1);
            texture.create_view(&wgpu::TextureViewDescriptor {
                base_mip_level,
                mip_level_count,
                ..Default::default()
            })
        };
        let levels: Vec<_> = (0..count).map(level).collect();
        let from =
            |finer| bind_group(device, "mip", &self.mip_layout, [wgpu::BindingResource::TextureView(finer)]);
        let finer = levels[..levels.len() - 1].iter().map(from).collect();
        NormalMap { levels, finer, texture }
    }

    /// Makes the normal map of view `index` from its grid.
    pub(super) fn render(
        &self,
        frame: &mut Frame<'_>,
        index: usize,
        uniforms: &GpuMaps,
        normals: &NormalMap,
        draw: impl Fn(&mut wgpu::RenderPass<'_>),
    ) {
        self.slots.write(frame.queue, index, uniforms);
        let offset = [ViewSlots::<GpuMaps>::offset(index)];
        {
            let heights = self.heights.create_view(&Default::default());
            let mut pass = begin(frame.encoder, "height map", &heights);
            pass.set_pipeline(&self.height_pipeline);
            pass.set_bind_group(0, &self.height_group, &offset);
            draw(&mut pass);
        }
        frame.end_of_pass("height map");
        {
            let mut pass = begin(frame.encoder, "normal map", &normals.levels[0]);
            pass.set_pipeline(&self.normal_pipeline);
            pass.set_bind_group(0, &self.normal_group, &offset);
            draw(&mut pass);
        }
        for (level, finer) in normals.levels[1..].iter().zip(&normals.finer) {
            let mut pass = begin(frame.encoder, "normal map's mips", level);
            pass.set_pipeline(&self.mip_pipeline);
            pass.set_bind_group(0, finer, &[]);
            pass.draw(0..3, 0..1);
        }
    }
}

/// The layout of [`GpuVertex`].
pub(super) const VERTEX_ATTRIBUTES: [wgpu::VertexAttribute; 3] =
    wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x2];

pub(super) fn vertex_layout() -> wgpu::VertexBufferLayout<'static> {
    wgpu::VertexBufferLayout {
        array_stride: size_of::<GpuVertex>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &VERTEX_ATTRIBUTES,
    }
}

fn pipeline(
    device: &wgpu::Device,
    shader: &Shader,
    group: &wgpu::BindGroupLayout,
    color: wgpu::TextureFormat,
    on_the_grid: bool,
) -> wgpu::RenderPipeline {
    let vertices = [Some(vertex_layout())];
    let request = PipelineRequest {
        label: shader.name,
        constants: &[],
        shader,
        groups: &[Some(group)],
        vertices: if on_the_grid { &vertices } else { &[] },
        color,
        depth: None,
        multisample: wgpu::MultisampleState::default(),
    };
    request.create(device)
}

/// A pass that fills a whole map.
fn begin<'e>(
    encoder: &'e mut wgpu::CommandEncoder,
    label: &str,
    map: &wgpu::TextureView,
) -> wgpu::RenderPass<'e> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some(label),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: map,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                store: wgpu::StoreOp::Store,
            },
        })],
        depth_stencil_attachment: None,
        timestamp_writes: None,
        occlusion_query_set: None,
        multiview_mask: None,
    })
}
