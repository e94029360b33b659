//! The Meshuggah ocean's pipeline, buffers and layouts.

use super::super::Build;
use crate::environment::display_from_linear;
use crate::geometry::TiledGrid;
use crate::gpu::resources::{self, IndexedMesh, PipelineRequest, linear_sampler};
use crate::shader_lib;
use crate::surface::TileMaps;
use crate::uniforms::{ViewSlots, sampler_entry, texture_entry, uniform_entry};
use glam::Vec3;
use half::f16;
use wgpu::util::DeviceExt;
use whitecap_scene::technique as settings;
use whitecap_waves::optics::{WATER_REFRACTIVE_INDEX, WaterBody};

/// Entries of the table of water colours.
pub(super) const WATER_COLORS: usize = 256;

/// Layout twin of `GpuMeshuggah` in `surface.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuMeshuggah {
    pub(super) centre_from_eye: [f32; 3],
    pub(super) cell_m: f32,
    pub(super) centre_cell: [i32; 2],
    pub(super) mesh_samples: i32,
    pub(super) earth_radius_m: f32,
    pub(super) centre_tile_uv: [f32; 2],
    pub(super) centre_bump_uv: [f32; 2],
    pub(super) tiles_per_m: f32,
    pub(super) bumps_per_m: f32,
    pub(super) fade_start_m: f32,
    pub(super) fade_end_m: f32,
    pub(super) deep_color: [f32; 3],
    pub(super) exposure: f32,
    pub(super) grazing_color: [f32; 3],
    pub(super) options: u32,
    pub(super) texels_per_m: [f32; 2],
    pub(super) visibility_m: f32,
    pub(super) padding: u32,
}

const FRESNEL_PER_PIXEL: u32 = 1;
const COLOR_TABLE: u32 = 2;

/// The option bits that `surface.wesl` names.
pub(super) fn options(settings: &settings::Meshuggah) -> u32 {
    let per_pixel = match settings.fresnel {
        settings::FresnelForm::PerVertexSplit => 0,
        settings::FresnelForm::PerPixel => FRESNEL_PER_PIXEL,
    };
    let table = match settings.water_color {
        settings::WaterColor::Lerp => 0,
        settings::WaterColor::NishitaNakamae => COLOR_TABLE,
    };
    per_pixel | table
}

/// The simplified Nishita–Nakamae colours by view cosine 0 to 1, display-referred.
pub(super) fn water_colors(settings: &settings::Meshuggah, irradiance: Vec3, sun_cos: f32) -> Vec<[f16; 4]> {
    // Water scatters nearly alike in all directions, and radiance thins by n² on its way up into air.
    let share = 1.0 / (4.0 * std::f64::consts::PI * WATER_REFRACTIVE_INDEX * WATER_REFRACTIVE_INDEX);
    let water = WaterBody {
        scattering_per_m: settings.scattering_per_m.map(|b| b * share),
        extinction_per_m: settings.extinction_per_m,
        depth_m: settings.bottom_depth_m.unwrap_or(f64::INFINITY),
        sun_irradiance: irradiance.as_dvec3().to_array(),
        sun_cos: f64::from(sun_cos),
    };
    let display = |v: f32| f16::from_f32(display_from_linear(v));
    water
        .table(WATER_COLORS)
        .into_iter()
        .map(|[r, g, b]| [display(r), display(g), display(b), f16::ONE])
        .collect()
}

pub(super) struct Pipeline {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
    mesh: IndexedMesh,
}

impl Pipeline {
    pub(super) fn new(
        build: &Build<'_>,
        grid: &TiledGrid,
        maps: &TileMaps,
        slots: &ViewSlots<GpuMeshuggah>,
        colors: &[[f16; 4]],
    ) -> Pipeline {
        let device = build.device;
        let layout = group_layout(device);
        let group = bind_group(build, &layout, maps, slots, colors);
        let pipeline = pipeline(build, &layout);
        let vertices = bytemuck::cast_slice(&grid.vertices);
        Pipeline {
            pipeline,
            group,
            mesh: IndexedMesh::new(device, build.queue, "grid", vertices, &grid.indices),
        }
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view_offset: u32) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(2, &self.group, &[view_offset]);
        self.mesh.draw(pass);
    }
}

/// Bind group 2, as `surface.wesl` and `meshuggah.wesl` declare it.
pub(super) fn group_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    use wgpu::ShaderStages as S;
    let d2 = wgpu::TextureViewDimension::D2;
    let vertex = S::VERTEX | S::COMPUTE;
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("meshuggah"),
        entries: &[
            ViewSlots::<GpuMeshuggah>::layout_entry(0, S::VERTEX_FRAGMENT | S::COMPUTE),
            texture_entry(1, vertex, d2, false),
            texture_entry(2, vertex, d2, false),
            texture_entry(3, S::FRAGMENT, d2, true),
            sampler_entry(4, S::FRAGMENT),
            texture_entry(5, S::FRAGMENT, d2, true),
            sampler_entry(6, S::FRAGMENT),
            uniform_entry(7, S::VERTEX),
        ],
    })
}

pub(super) fn bind_group(
    build: &Build<'_>,
    layout: &wgpu::BindGroupLayout,
    maps: &TileMaps,
    slots: &ViewSlots<GpuMeshuggah>,
    colors: &[[f16; 4]],
) -> wgpu::BindGroup {
    let device = build.device;
    let view = |texture: &wgpu::Texture| texture.create_view(&Default::default());
    let textures = &maps.textures;
    let [displacement, slopes, normals] =
        [&textures.displacement, &textures.slopes, &textures.normals].map(view);
    let table = device.create_texture_with_data(
        build.queue,
        &wgpu::TextureDescriptor {
            label: Some("water colours"),
            size: wgpu::Extent3d { width: colors.len() as u32, height: 1, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba16Float,
            usage: wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        },
        wgpu::util::TextureDataOrder::LayerMajor,
        bytemuck::cast_slice(colors),
    );
    let table = view(&table);
    let sampler = |address| linear_sampler(device, "meshuggah", address);
    let (repeat, clamp) = (sampler(wgpu::AddressMode::Repeat), sampler(wgpu::AddressMode::ClampToEdge));
    use wgpu::BindingResource::{Sampler, TextureView};
    let resources = [
        slots.binding(),
        TextureView(&displacement),
        TextureView(&slopes),
        TextureView(&normals),
        Sampler(&repeat),
        TextureView(&table),
        Sampler(&clamp),
        textures.lost_variance.as_entire_binding(),
    ];
    resources::bind_group(device, "meshuggah", layout, resources)
}

fn pipeline(build: &Build<'_>, group: &wgpu::BindGroupLayout) -> wgpu::RenderPipeline {
    let (device, shared) = (build.device, build.shared);
    let per_sample = shared.target.sample_shading && shared.target.sample_count > 1;
    let shader = if per_sample { shader_lib::MESHUGGAH_PER_SAMPLE } else { shader_lib::MESHUGGAH };
    let request = PipelineRequest {
        label: "meshuggah",
        shader: &shader,
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
    request.create(device)
}
