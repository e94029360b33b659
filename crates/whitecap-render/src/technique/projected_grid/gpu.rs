//! The water's own pipeline and layouts.

use super::maps::vertex_layout;
use crate::gpu::resources::{PipelineRequest, bind_group, linear_sampler, table_1d, texture_2d};
use crate::shader_lib;
use crate::technique::Build;
use crate::uniforms::{ViewSlots, sampler_entry, texture_entry};
use whitecap_waves::optics::{WATER_REFRACTIVE_INDEX, fresnel_exact};

/// Entries of the Fresnel table.
pub(super) const FRESNEL_ENTRIES: usize = 256;

/// The option bits that `projected_grid.wesl` names.
pub(super) const NORMAL_MAP: u32 = 1;
pub(super) const LOCAL_REFLECTIONS: u32 = 2;
pub(super) const REFRACTION_MAP: u32 = 4;

/// Layout twin of `GpuProjectedGrid` in `projected_grid.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuProjectedGrid {
    pub(super) toward_sun: [f32; 3],
    pub(super) sun_strength: f32,
    pub(super) water_color: [f32; 3],
    pub(super) sun_shininess: f32,
    pub(super) offset_axes: [f32; 4],
    pub(super) level_m: f32,
    pub(super) distortion: f32,
    pub(super) options: u32,
    pub(super) padding: u32,
}

/// The reflected share by R·N, from 0 to 1, in 8 bits: what the text's Fresnel map holds is not said.
pub(super) fn fresnel_table() -> Vec<[u8; 4]> {
    let entry = |i: usize| {
        let cos = (i as f64 + 0.5) / FRESNEL_ENTRIES as f64;
        let share = (255.0 * fresnel_exact(cos, WATER_REFRACTIVE_INDEX)).round() as u8;
        [share, share, share, 255]
    };
    (0..FRESNEL_ENTRIES).map(entry).collect()
}

/// What a view's bind group holds of its own; what is not made for it stays empty.
#[derive(Default)]
pub(super) struct ViewMaps<'a> {
    pub(super) normals: Option<&'a wgpu::TextureView>,
    pub(super) reflection: Option<&'a wgpu::TextureView>,
    pub(super) refraction: Option<&'a wgpu::TextureView>,
}

pub(super) struct Pipeline {
    pub(super) pipeline: wgpu::RenderPipeline,
    pub(super) slots: ViewSlots<GpuProjectedGrid>,
    layout: wgpu::BindGroupLayout,
    fresnel: wgpu::TextureView,
    /// One transparent texel.
    empty: wgpu::TextureView,
    clamping: wgpu::Sampler,
}

impl Pipeline {
    pub(super) fn new(build: &Build<'_>) -> Pipeline {
        use wgpu::ShaderStages as S;
        let (device, shared) = (build.device, build.shared);
        let texture = |binding| texture_entry(binding, S::FRAGMENT, wgpu::TextureViewDimension::D2, true);
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("projected grid"),
            entries: &[
                ViewSlots::<GpuProjectedGrid>::layout_entry(0, S::VERTEX_FRAGMENT),
                texture(1),
                texture(2),
                texture(3),
                texture(4),
                sampler_entry(5, S::FRAGMENT),
            ],
        });
        let request = PipelineRequest {
            label: "projected grid",
            shader: &shader_lib::PROJECTED_GRID,
            constants: &[],
            groups: &[Some(&shared.view_layout), Some(&shared.environment_layout), Some(&layout)],
            vertices: &[Some(vertex_layout())],
            color: shared.target.color,
            depth: Some(shared.target.depth_state(true)),
            multisample: shared.target.multisample(),
        };
        let format = wgpu::TextureFormat::Rgba8Unorm;
        let empty = texture_2d(device, "nothing", [1, 1], 1, format, wgpu::TextureUsages::empty());
        Pipeline {
            pipeline: request.create(device),
            slots: ViewSlots::new(device, "projected grid"),
            fresnel: table_1d(device, build.queue, "fresnel", &fresnel_table()),
            empty: empty.create_view(&Default::default()),
            clamping: linear_sampler(device, "projected grid", wgpu::AddressMode::ClampToEdge),
            layout,
        }
    }

    pub(super) fn view_group(&self, device: &wgpu::Device, maps: &ViewMaps<'_>) -> wgpu::BindGroup {
        use wgpu::BindingResource::{Sampler, TextureView};
        let or_empty = |map: Option<&'_ wgpu::TextureView>| map.unwrap_or(&self.empty).clone();
        let own = [maps.normals, maps.reflection, maps.refraction].map(or_empty);
        let resources = [
            self.slots.binding(),
            TextureView(&own[0]),
            TextureView(&self.fresnel),
            TextureView(&own[1]),
            TextureView(&own[2]),
            Sampler(&self.clamping),
        ];
        bind_group(device, "projected grid", &self.layout, resources)
    }
}
