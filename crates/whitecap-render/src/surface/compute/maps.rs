//! The maps of a tile, made on the device from its fields.
//!
//! The normal map is built in steps of three levels: a workgroup takes eight by eight texels in, keeps them in its own
//! memory, and hands one on. Four storage textures to a stage are what WebGPU promises.

use super::SpectralFields;
use super::gpu::{Pass, storage, uniform};
use crate::gpu::resources::texture_2d;
use crate::shader_lib;
use crate::surface::tile_maps::TileTextures;
use wgpu::BindingResource::TextureView;

/// Bytes of `Moments` in `level.wesl`.
pub(super) const MOMENTS_BYTES: u64 = 48;

/// Layout twin of `GpuLevel` in `level.wesl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GpuLevel {
    pub(super) side: u32,
    pub(super) source_start: u32,
    pub(super) target_start: u32,
}

/// The passes from the fields to a tile's textures.
pub(super) struct MapPasses(Vec<Pass>);

impl MapPasses {
    pub(super) fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        fields: &SpectralFields,
        maps: &TileTextures,
    ) -> MapPasses {
        let levels = levels(fields.resolution);
        let uniforms = levels.iter().map(|level| uniform(device, queue, "level", level)).collect::<Vec<_>>();
        let moments: u64 = levels.iter().map(|level| u64::from(groups(level.side)).pow(2)).sum();
        let moments = storage(device, "moments of slope", moments * MOMENTS_BYTES);
        let [whole, sums, fields] = [&uniforms[0], &moments, &fields.fields].map(|b| b.as_entire_binding());

        let displacement = maps.displacement.create_view(&Default::default());
        let slopes = maps.slopes.create_view(&Default::default());
        let side = maps.displacement.width().div_ceil(8);
        let mut passes = vec![Pass::with_bindings(
            device,
            &shader_lib::SPECTRAL_MESH_MAPS,
            "cs_map_mesh",
            &[
                (0, whole.clone()),
                (1, fields.clone()),
                (2, TextureView(&displacement)),
                (3, TextureView(&slopes)),
            ],
            [side, side, 1],
        )];

        let spare = spare_levels(device);
        let view = |mip: u32| {
            let last = maps.normals.mip_level_count() - 1;
            if mip <= last { level_view(&maps.normals, mip) } else { level_view(&spare, mip - last - 1) }
        };
        let level_0 = view(0);
        for (i, (level, uniform)) in levels.iter().zip(&uniforms).enumerate() {
            let first = 3 * i as u32;
            let views = [view(first + 1), view(first + 2), view(first + 3)];
            let [a, b, c] = views.each_ref().map(TextureView);
            let mut bindings =
                vec![(0, uniform.as_entire_binding()), (2, sums.clone()), (3, a), (4, b), (5, c)];
            let (shader, entry) = if i == 0 {
                bindings.extend([(1, fields.clone()), (6, TextureView(&level_0))]);
                (&shader_lib::SPECTRAL_NORMAL_MAP, "cs_map_normals")
            } else {
                (&shader_lib::SPECTRAL_MIPS, "cs_map_mips")
            };
            let side = groups(level.side);
            passes.push(Pass::with_bindings(device, shader, entry, &bindings, [side, side, 1]));
        }
        let lost = maps.lost_variance.as_entire_binding();
        let shader = &shader_lib::SPECTRAL_LOST_VARIANCE;
        passes.push(Pass::with_bindings(
            device,
            shader,
            "cs_average_lost",
            &[(0, whole), (1, sums.clone()), (2, lost)],
            [1, 1, 1],
        ));
        MapPasses(passes)
    }

    pub(super) fn dispatch(&self, pass: &mut wgpu::ComputePass<'_>) {
        for step in &self.0 {
            step.dispatch(pass);
        }
    }
}

/// The levels that passes start from: 0, 3, 6 … as far as there is one after them.
fn levels(resolution: u32) -> Vec<GpuLevel> {
    let mut levels = Vec::new();
    let (mut side, mut source_start, mut target_start) = (resolution, 0, 0);
    while side > 1 {
        levels.push(GpuLevel { side, source_start, target_start });
        source_start = target_start;
        target_start += groups(side).pow(2);
        side = groups(side);
    }
    levels
}

/// Workgroups along a side of a level.
fn groups(side: u32) -> u32 {
    (side / 8).max(1)
}

/// One mip, to write to.
fn level_view(texture: &wgpu::Texture, mip: u32) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor {
        base_mip_level: mip,
        mip_level_count: Some(1),
        ..Default::default()
    })
}

/// What a pass binds in place of levels that its map does not have. No two bindings may share one.
fn spare_levels(device: &wgpu::Device) -> wgpu::Texture {
    let (format, usage) = (wgpu::TextureFormat::Rgba16Float, wgpu::TextureUsages::STORAGE_BINDING);
    texture_2d(device, "spare levels", [2, 2], 2, format, usage)
}
