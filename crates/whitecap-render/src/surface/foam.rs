//! Foam on the GPU: a map for each tile with breaking waves, and the structure that breaks its cover up.

use crate::RenderError;
use crate::gpu::checked;
use crate::gpu::resources::{texture_2d, write_level};
use crate::shader_lib::GpuPatchwork;
use crate::threads::*;
use glam::DVec2;
use half::f16;
use whitecap_waves::field::FoamStructure;
use whitecap_waves::model::spectral::foam::{Foam, FoamLevel};

/// Texels along a side of the structure, and what a seed would only change to no purpose.
const STRUCTURE_SIZE: usize = 512;
const STRUCTURE_SEED: u64 = 7;

/// Sides of the large structure and the small one in metres: walls of metres, bubbles of centimetres. Their ratio is
/// far from small whole numbers.
const STRUCTURE_SIDES_M: [f64; 2] = [11.0, 2.31];

/// Layout twin of `GpuFoamTile` in `foam.wesl`.
#[repr(C)]
#[derive(Clone, Copy, Default, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub struct GpuFoamTile {
    eye_in_tile: [f32; 2],
    tiles_per_m: f32,
    half_texel: f32,
    patchwork: GpuPatchwork,
}

/// Layout twin of `GpuFoam` in `foam.wesl`: what a view needs to read the maps. Zeroed it stands for no foam.
#[repr(C)]
#[derive(Clone, Copy, Default, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub struct GpuFoam {
    tiles: [GpuFoamTile; Foam::MOST_TILES],
    eye_in_structure: [f32; 4],
    structures_per_m: [f32; 2],
    variance_gain: [f32; 2],
    threshold: f32,
    padding: [u32; 3],
}

/// The foam of a sea and the textures that hold it at one moment.
///
/// The processor works it out on either backend: a step of the grid of times is a transform a tile, some tenths of a
/// millisecond.
pub struct FoamMaps {
    foam: Option<Foam>,
    /// One for each tile with breaking waves.
    chains: Vec<MipChain>,
    maps: wgpu::Texture,
    structure: wgpu::Texture,
}

/// Room for the mips of one tile.
#[derive(Default)]
struct MipChain {
    level: FoamLevel,
    /// Mean and variance, all levels one after the other.
    texels: Vec<[f16; 2]>,
}

impl MipChain {
    /// Takes in a field with `size` samples a side. Allocates nothing after the first time.
    fn fill(&mut self, field: &[f32], size: usize) {
        self.texels.clear();
        self.level.begin(field, size);
        loop {
            self.texels.extend(self.level.texels().map(|texel| texel.map(f16::from_f32)));
            if self.level.size() <= 1 {
                break;
            }
            self.level.halve();
        }
    }

    /// The levels, from the largest.
    fn levels(&self) -> impl Iterator<Item = &[[f16; 2]]> {
        let (mut rest, mut size) = (&self.texels[..], self.texels.len().isqrt());
        size = 1 << size.max(1).ilog2();
        std::iter::from_fn(move || {
            let (level, smaller) = rest.split_at_checked(size * size)?;
            (rest, size) = (smaller, size / 2);
            (!level.is_empty()).then_some(level)
        })
    }
}

impl FoamMaps {
    /// Makes the textures for `foam`; without any they are one texel.
    ///
    /// # Errors
    ///
    /// [`RenderError::OutOfMemory`] or [`RenderError::LimitExceeded`].
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        foam: Option<Foam>,
    ) -> Result<FoamMaps, RenderError> {
        let structure = FoamStructure::new(if foam.is_some() { STRUCTURE_SIZE } else { 16 }, STRUCTURE_SEED)
            .map_err(|error| RenderError::Internal { description: error.to_string() })?;
        checked(device, "the foam's maps", || {
            let (size, layers) =
                foam.as_ref().map_or((1, 1), |foam| (foam.resolution() as u32, foam.tiles().len() as u32));
            let maps = device.create_texture(&wgpu::TextureDescriptor {
                label: Some("foam"),
                size: wgpu::Extent3d { width: size, height: size, depth_or_array_layers: layers },
                mip_level_count: size.ilog2() + 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: wgpu::TextureFormat::Rg16Float,
                usage: wgpu::TextureUsages::COPY_DST | wgpu::TextureUsages::TEXTURE_BINDING,
                view_formats: &[],
            });
            let format = wgpu::TextureFormat::Rg8Unorm;
            let (size, levels) = (structure.size() as u32, structure.levels().len() as u32);
            let usage = wgpu::TextureUsages::COPY_DST;
            let texture = texture_2d(device, "foam's structure", [size; 2], levels, format, usage);
            for (level, texels) in (0..).zip(structure.levels()) {
                write_level(queue, &texture, level, texels.as_flattened());
            }
            let chains = (0..foam.as_ref().map_or(0, |foam| foam.tiles().len())).map(|_| MipChain::default());
            Ok(FoamMaps { foam, chains: chains.collect(), maps, structure: texture })
        })
    }

    /// Brings the maps to `time_s`.
    pub fn update(&mut self, queue: &wgpu::Queue, time_s: f64) {
        self.evaluate(time_s);
        for (layer, chain) in (0..).zip(&self.chains) {
            for (mip, texels) in (0..).zip(chain.levels()) {
                write_layer(queue, &self.maps, layer, mip, bytemuck::cast_slice(texels));
            }
        }
    }

    /// Works out what the maps hold at `time_s`. Allocates nothing after the first time.
    fn evaluate(&mut self, time_s: f64) {
        let Some(foam) = &mut self.foam else { return };
        foam.evaluate(time_s);
        let (tiles, size) = (foam.tiles(), foam.resolution());
        self.chains.par_iter_mut().zip(tiles).for_each(|(chain, tile)| chain.fill(tile.field(), size));
    }

    /// Mean and variance of what each tile remembers, a layer a tile, `Rg16Float` with mips: a `texture_2d_array`.
    pub fn maps(&self) -> wgpu::TextureView {
        self.maps.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(wgpu::TextureViewDimension::D2Array),
            ..Default::default()
        })
    }

    /// Ranks and contrast of the structure, `Rg8Unorm` with mips.
    pub fn structure(&self) -> wgpu::TextureView {
        self.structure.create_view(&Default::default())
    }

    /// Tiles with breaking waves.
    pub fn tile_count(&self) -> usize {
        self.foam.as_ref().map_or(0, |foam| foam.tiles().len())
    }

    /// The first of those, which are sewn from patches.
    pub fn sewn_count(&self) -> usize {
        let tiles = self.foam.as_ref().map_or(&[][..], |foam| foam.tiles());
        tiles.iter().take_while(|tile| tile.patchwork().is_some()).count()
    }

    /// What shaders need for an eye over this place, metres.
    pub fn uniforms(&self, eye_m: DVec2) -> GpuFoam {
        let Some(foam) = &self.foam else { return GpuFoam::default() };
        let within = |side_m: f64| (eye_m / side_m).fract_gl().as_vec2().to_array();
        let mut tiles = [GpuFoamTile::default(); Foam::MOST_TILES];
        for (gpu, tile) in tiles.iter_mut().zip(foam.tiles()) {
            *gpu = GpuFoamTile {
                eye_in_tile: within(tile.tile_size_m()),
                tiles_per_m: (1.0 / tile.tile_size_m()) as f32,
                half_texel: (0.5 / foam.resolution() as f64) as f32,
                patchwork: GpuPatchwork::new(tile.patchwork(), eye_m),
            };
        }
        let [large_m, small_m] = STRUCTURE_SIDES_M;
        let ([x, z], [small_x, small_z]) = (within(large_m), within(small_m));
        GpuFoam {
            tiles,
            eye_in_structure: [x, z, small_x, small_z],
            structures_per_m: [(1.0 / large_m) as f32, (1.0 / small_m) as f32],
            variance_gain: foam.variance_gain().map(|gain| gain as f32),
            threshold: foam.threshold() as f32,
            padding: [0; 3],
        }
    }
}

/// Replaces a level of one layer.
fn write_layer(queue: &wgpu::Queue, texture: &wgpu::Texture, layer: u32, mip_level: u32, texels: &[u8]) {
    let side = (texture.width() >> mip_level).max(1);
    queue.write_texture(
        wgpu::TexelCopyTextureInfo {
            mip_level,
            origin: wgpu::Origin3d { x: 0, y: 0, z: layer },
            ..texture.as_image_copy()
        },
        texels,
        wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(texels.len() as u32 / side),
            rows_per_image: None,
        },
        wgpu::Extent3d { width: side, height: side, depth_or_array_layers: 1 },
    );
}

#[cfg(test)]
mod tests;
