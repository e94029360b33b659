//! The five-sample sea's pipelines, buffers and layouts.

use super::super::Build;
use super::later::Later;
use super::plane::{Spacing, plane};
use super::stage::Form;
use crate::gpu::resources::{self, IndexedMesh, PipelineRequest, linear_sampler, rgba8_map, table_1d};
use crate::shader_lib::{self, Shader};
use crate::uniforms::{ViewSlots, sampler_entry, texture_entry};

/// Layout twin of `GpuFiveSample` in `layers.wesl`.
#[repr(C)]
#[derive(Clone, Copy, Default, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuFiveSample {
    pub(super) centre_from_eye: [f32; 3],
    pub(super) exponent: f32,
    pub(super) toward_sun: [f32; 3],
    pub(super) sun_brightness: f32,
    pub(super) layers: [[f32; 4]; 5],
    pub(super) emission: [f32; 3],
    pub(super) layer_count: u32,
    pub(super) reflection: [f32; 3],
    pub(super) options: u32,
    pub(super) diffuse_color: [f32; 3],
    pub(super) ambient: f32,
    pub(super) near_absorption: [f32; 3],
    pub(super) diffuse: f32,
    pub(super) far_absorption: [f32; 3],
    pub(super) sky_address: f32,
    pub(super) ground_from_eye: [f32; 2],
    pub(super) ground_points_per_m: [f32; 2],
    pub(super) extinction_per_m: [f32; 3],
    pub(super) distortion: f32,
    pub(super) shore_depth_m: f32,
    pub(super) swash_height_m: f32,
    pub(super) swash_turns: f32,
    pub(super) daylight: f32,
}

/// The option bits that `later.wesl` and `dome.wesl` name.
pub(super) const DEPTH_FOG: u32 = 1;
pub(super) const REFLECTED_GEOMETRY: u32 = 2;
pub(super) const WAVES_MEET_LAND: u32 = 4;
pub(super) const SUN_DISC: u32 = 64;

/// Samples along a slanted pixel where a graphics card does the drawing; a processor takes ten times as long.
const ANISOTROPY: u16 = 8;

pub(super) struct Pipeline {
    water: wgpu::RenderPipeline,
    dome: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
    mesh: IndexedMesh,
}

impl Pipeline {
    pub(super) fn new(
        build: &Build<'_>,
        form: &Form,
        spacing: Spacing,
        slots: &ViewSlots<GpuFiveSample>,
        map: &[Vec<[u8; 4]>],
        sky: &[[u8; 4]],
        later: Option<&Later>,
    ) -> Pipeline {
        let (device, shared) = (build.device, build.shared);
        let layout = group_layout(device);
        let group = bind_group(build, &layout, slots, map, sky);
        let shader = match (form.stage, later) {
            (Some(_), _) => shader_lib::FIVE_SAMPLE_STAGES,
            (None, None) => shader_lib::FIVE_SAMPLE,
            (None, Some(_)) => shader_lib::FIVE_SAMPLE_LATER,
        };
        let vertices = [Some(wgpu::VertexBufferLayout {
            array_stride: 8,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![0 => Float32x2],
        })];
        let create = |shader: &Shader, vertices: &[Option<wgpu::VertexBufferLayout<'_>>], write, later| {
            let groups = [Some(&shared.view_layout), Some(&shared.environment_layout), Some(&layout), later];
            PipelineRequest {
                label: shader.name,
                constants: &[],
                shader,
                groups: if groups[3].is_some() { &groups } else { &groups[..3] },
                vertices,
                color: shared.target.color,
                depth: Some(shared.target.depth_state(write)),
                multisample: shared.target.multisample(),
            }
            .create(device)
        };
        let water = create(&shader, &vertices, true, later.map(|later| &later.layout));
        let dome = create(&shader_lib::FIVE_SAMPLE_DOME, &[], false, None);
        let grid = plane(spacing);
        let vertices = bytemuck::cast_slice(&grid.vertices);
        Pipeline {
            water,
            dome,
            group,
            mesh: IndexedMesh::new(device, build.queue, "level sea", vertices, &grid.indices),
        }
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view_offset: u32) {
        pass.set_pipeline(&self.water);
        pass.set_bind_group(2, &self.group, &[view_offset]);
        self.mesh.draw(pass);
    }

    pub(super) fn draw_dome(&self, pass: &mut wgpu::RenderPass<'_>, view_offset: u32) {
        pass.set_pipeline(&self.dome);
        pass.set_bind_group(2, &self.group, &[view_offset]);
        pass.draw(0..3, 0..1);
    }
}

/// Bind group 2, as `layers.wesl` declares it.
fn group_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    use wgpu::ShaderStages as S;
    let d2 = wgpu::TextureViewDimension::D2;
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("five-sample"),
        entries: &[
            ViewSlots::<GpuFiveSample>::layout_entry(0, S::VERTEX_FRAGMENT),
            texture_entry(1, S::FRAGMENT, d2, true),
            sampler_entry(2, S::FRAGMENT),
            texture_entry(3, S::FRAGMENT, d2, true),
            sampler_entry(4, S::FRAGMENT),
        ],
    })
}

fn bind_group(
    build: &Build<'_>,
    layout: &wgpu::BindGroupLayout,
    slots: &ViewSlots<GpuFiveSample>,
    map: &[Vec<[u8; 4]>],
    sky: &[[u8; 4]],
) -> wgpu::BindGroup {
    let (device, queue) = (build.device, build.queue);
    let wavemap = rgba8_map(device, queue, "wave map", super::maps::MAP_SIZE as u32, map);
    let skymap = table_1d(device, queue, "sky gradient", sky);
    let repeat = device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("wave map"),
        address_mode_u: wgpu::AddressMode::Repeat,
        address_mode_v: wgpu::AddressMode::Repeat,
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        anisotropy_clamp: if build.is_software() { 1 } else { ANISOTROPY },
        ..Default::default()
    });
    let clamp = linear_sampler(device, "sky gradient", wgpu::AddressMode::ClampToEdge);
    use wgpu::BindingResource::{Sampler, TextureView};
    let resources =
        [slots.binding(), TextureView(&wavemap), Sampler(&repeat), TextureView(&skymap), Sampler(&clamp)];
    resources::bind_group(device, "five-sample", layout, resources)
}
