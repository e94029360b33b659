//! The noise on the device: two textures with mips.

use crate::gpu::resources::{texture_2d, write_level};
use half::f16;
use whitecap_waves::model::perlin::Chunks;

/// What a texel of 16 bits counts as 1.
const FULL: f32 = 65_535.0;

/// Both chunks as r16float: filterable everywhere, where 16-bit integers that count to 1 are not.
///
/// The text uploads 32768 + value; here it is the value alone, over 65535. A half float keeps 11 bits of it wherever
/// it lies, so a height is off by less than 1/2048 of itself: 0.2 mm for the demo's waves.
pub(super) struct ChunkMaps {
    textures: [wgpu::Texture; 2],
}

impl ChunkMaps {
    pub(super) fn new(device: &wgpu::Device, side: u32) -> ChunkMaps {
        let (format, usage) = (wgpu::TextureFormat::R16Float, wgpu::TextureUsages::COPY_DST);
        let levels = side.ilog2() + 1;
        let textures = ["noise 0", "noise 1"]
            .map(|label| texture_2d(device, label, [side, side], levels, format, usage));
        ChunkMaps { textures }
    }

    pub(super) fn views(&self) -> [wgpu::TextureView; 2] {
        self.textures.each_ref().map(|texture| texture.create_view(&Default::default()))
    }

    /// Uploads both chunks and their mips.
    pub(super) fn update(&self, queue: &wgpu::Queue, chunks: &Chunks) {
        for (i, texture) in self.textures.iter().enumerate() {
            let mut texels: Vec<f32> = chunks.texels(i).iter().map(|&texel| texel as f32 / FULL).collect();
            let mut side = chunks.side();
            for level in 0..texture.mip_level_count() {
                let stored: Vec<f16> = texels.iter().map(|&texel| f16::from_f32(texel)).collect();
                write_level(queue, texture, level, bytemuck::cast_slice(&stored));
                texels = halved(&texels, side);
                side = (side / 2).max(1);
            }
        }
    }
}

/// The mean of each two by two texels of a square map.
fn halved(texels: &[f32], side: usize) -> Vec<f32> {
    let half = side / 2;
    let at = |u: usize, v: usize| texels[v * side + u];
    let mean = |u: usize, v: usize| {
        0.25 * (at(2 * u, 2 * v) + at(2 * u + 1, 2 * v) + at(2 * u, 2 * v + 1) + at(2 * u + 1, 2 * v + 1))
    };
    (0..half * half).map(|i| mean(i % half, i / half)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mips_keep_the_mean() {
        let texels: Vec<f32> = (0..64).map(|i| (i * i % 17) as f32).collect();
        let mean = texels.iter().sum::<f32>() / 64.0;
        let mut level = texels;
        for side in [8, 4, 2] {
            level = halved(&level, side);
        }
        assert_eq!(level.len(), 1);
        assert!((level[0] - mean).abs() < 1e-5);
    }

    /// The error that the type's documentation names, over all values that a chunk can have.
    #[test]
    fn half_floats_are_fine_enough() {
        for texel in (-32_767..=32_767).step_by(7) {
            let exact = texel as f32 / FULL;
            let error = (f16::from_f32(exact).to_f32() - exact).abs();
            assert!(error <= exact.abs() / 2048.0 + 1e-7, "{texel}");
        }
    }
}
