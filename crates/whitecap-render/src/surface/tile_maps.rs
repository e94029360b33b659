//! A tile of sea as textures: displacement and slopes for vertices, normals with mips for pixels.

use crate::gpu::resources::{texture_2d, write_level};
use crate::{RenderError, gpu::checked};
use glam::DVec2;
use half::f16;
use rayon::prelude::*;
use whitecap_waves::model::{TileFields, WaveModel};

/// Samples along a side of the largest tile, and mip levels of its normal map.
const MAX_RESOLUTION: usize = 2048;
const MAX_LEVELS: usize = MAX_RESOLUTION.ilog2() as usize + 1;

/// Vertices along a side of a mesh stay within this; of a finer tile every 2nd, 4th … sample is used.
const MAX_MESH_SIDE: usize = 1024;

/// Steeper than this (80°) a folded crest is not shaded: its normal would point under the water.
const MAX_SLOPE: f32 = 5.7;

/// A wave model, its fields at one moment and the textures that hold them.
///
/// The normal map's mips carry what they average away: red, green and blue are the mean normal
/// (x, y, z), alpha the variance of slope (both axes together) inside the texel, so that mean square of
/// the mean plus alpha is the same at every level (Olano and Baker, "LEAN Mapping", 2010).
pub struct TileMaps {
    model: Box<dyn WaveModel>,
    fields: TileFields,
    stride: usize,
    /// Displacement (x, height, z) of each `stride`-th sample, metres, `Rgba32Float`.
    pub displacement: wgpu::Texture,
    /// Slopes (∂h/∂x, ∂h/∂z) of the displaced surface there, `Rg32Float`.
    pub slopes: wgpu::Texture,
    /// Normals of all samples with mips, `Rgba16Float`.
    pub normals: wgpu::Texture,
    lost_variance: [f32; MAX_LEVELS],
}

impl TileMaps {
    /// Makes the textures for `model`, of which a mesh repeats `repeats` tiles along a side.
    ///
    /// # Errors
    ///
    /// [`RenderError::OutOfMemory`] or [`RenderError::LimitExceeded`].
    pub fn new(
        device: &wgpu::Device,
        model: Box<dyn WaveModel>,
        repeats: u32,
    ) -> Result<TileMaps, RenderError> {
        let n = model.resolution();
        let mut stride = 1;
        while n * repeats as usize / stride > MAX_MESH_SIDE {
            stride *= 2;
        }
        if n == 0 || n > MAX_RESOLUTION {
            return Err(RenderError::LimitExceeded {
                what: "the number of samples along a side of the sea's tile".into(),
                asked: n as u64,
                accepted: format!("1 to {MAX_RESOLUTION}"),
            });
        }
        checked(device, "the sea's maps", || {
            let mesh = (n / stride) as u32;
            Ok(TileMaps {
                displacement: texture(device, "displacement", mesh, 1, wgpu::TextureFormat::Rgba32Float),
                slopes: texture(device, "slopes", mesh, 1, wgpu::TextureFormat::Rg32Float),
                normals: texture(
                    device,
                    "normals",
                    n as u32,
                    n.ilog2() + 1,
                    wgpu::TextureFormat::Rgba16Float,
                ),
                fields: TileFields::new(n),
                lost_variance: [0.0; MAX_LEVELS],
                model,
                stride,
            })
        })
    }

    /// Brings the textures to `time_s`.
    pub fn update(&mut self, queue: &wgpu::Queue, time_s: f64) {
        self.model.evaluate(time_s, &mut self.fields);
        let (n, stride) = (self.fields.resolution(), self.stride);
        let (fields, mesh) = (&self.fields, n / stride);
        let sample = move |i: usize| (i / mesh) * stride * n + (i % mesh) * stride;
        let displacement: Vec<[f32; 4]> = (0..mesh * mesh)
            .into_par_iter()
            .map(|i| {
                let [x, y, z] = fields.displacement(sample(i));
                [x, y, z, 0.0]
            })
            .collect();
        write_level(queue, &self.displacement, 0, bytemuck::cast_slice(&displacement));
        let slopes: Vec<[f32; 2]> =
            (0..mesh * mesh).into_par_iter().map(|i| slope_of(fields.normal(sample(i)))).collect();
        write_level(queue, &self.slopes, 0, bytemuck::cast_slice(&slopes));

        let mut level = NormalLevel::of(fields);
        for mip in 0..=n.ilog2() {
            self.lost_variance[mip as usize] = level.mean_lost_variance();
            write_level(queue, &self.normals, mip, bytemuck::cast_slice(&level.texels()));
            if mip < n.ilog2() {
                level = level.halved();
            }
        }
        for coarser in n.ilog2() as usize + 1..MAX_LEVELS {
            self.lost_variance[coarser] = self.lost_variance[coarser - 1];
        }
    }

    /// Samples along a side of the tile that the vertex maps hold.
    pub fn mesh_samples(&self) -> usize {
        self.fields.resolution() / self.stride
    }

    /// Samples along a side of the normal map.
    pub fn resolution(&self) -> usize {
        self.fields.resolution()
    }

    /// Side of the tile, metres.
    pub fn tile_size_m(&self) -> f64 {
        self.model.tile_size_m()
    }

    /// Metres between the vertices of a mesh on this tile.
    pub fn cell_m(&self) -> f64 {
        self.tile_size_m() / self.mesh_samples() as f64
    }

    /// Mean slope variance (both axes) that each mip of the normal map has lost.
    pub fn lost_variance(&self) -> &[f32; MAX_LEVELS] {
        &self.lost_variance
    }

    /// The model behind the maps, for queries.
    pub fn model(&self) -> &dyn WaveModel {
        &*self.model
    }

    /// Index of the mesh sample nearest to a place, not wrapped.
    pub fn nearest_cell(&self, at_m: DVec2) -> glam::I64Vec2 {
        (at_m / self.cell_m()).round().as_i64vec2()
    }
}

/// One level of the normal map before encoding.
struct NormalLevel {
    size: usize,
    /// Mean normal.
    normals: Vec<[f32; 3]>,
    /// Mean slope (x, z) and mean square slope.
    moments: Vec<[f32; 3]>,
}

impl NormalLevel {
    fn of(fields: &TileFields) -> NormalLevel {
        let size = fields.resolution();
        let normals: Vec<[f32; 3]> = (0..size * size).into_par_iter().map(|i| fields.normal(i)).collect();
        let moments = normals
            .par_iter()
            .map(|&normal| {
                let [x, z] = slope_of(normal);
                [x, z, x * x + z * z]
            })
            .collect();
        NormalLevel { size, normals, moments }
    }

    fn halved(&self) -> NormalLevel {
        let size = self.size / 2;
        let mean = |values: &[[f32; 3]]| -> Vec<[f32; 3]> {
            (0..size * size)
                .into_par_iter()
                .map(|i| {
                    let at = (i / size) * 2 * self.size + (i % size) * 2;
                    let four = [at, at + 1, at + self.size, at + self.size + 1];
                    std::array::from_fn(|c| 0.25 * four.iter().map(|&j| values[j][c]).sum::<f32>())
                })
                .collect()
        };
        NormalLevel { size, normals: mean(&self.normals), moments: mean(&self.moments) }
    }

    fn lost(&self, i: usize) -> f32 {
        let [x, z, square] = self.moments[i];
        (square - x * x - z * z).max(0.0)
    }

    fn mean_lost_variance(&self) -> f32 {
        let sum: f64 = (0..self.moments.len()).map(|i| f64::from(self.lost(i))).sum();
        (sum / self.moments.len() as f64) as f32
    }

    fn texels(&self) -> Vec<[f16; 4]> {
        (0..self.normals.len())
            .into_par_iter()
            .map(|i| {
                let [x, y, z] = self.normals[i];
                [x, y, z, self.lost(i)].map(f16::from_f32)
            })
            .collect()
    }
}

/// Slopes of a surface with this normal, bounded where a crest has folded over.
fn slope_of([x, y, z]: [f32; 3]) -> [f32; 2] {
    let y = y.max(1e-3);
    let (sx, sz) = (-x / y, -z / y);
    let scale = (MAX_SLOPE / sx.hypot(sz)).min(1.0);
    [sx * scale, sz * scale]
}

fn texture(
    device: &wgpu::Device,
    label: &str,
    side: u32,
    levels: u32,
    format: wgpu::TextureFormat,
) -> wgpu::Texture {
    texture_2d(device, label, [side, side], levels, format, wgpu::TextureUsages::COPY_DST)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level() -> NormalLevel {
        let size = 16;
        let slope = |i: usize| {
            let (x, z) = ((i % size) as f32, (i / size) as f32);
            [0.3 * (x * 0.8).sin(), 0.2 * (z * 1.7 + x).cos()]
        };
        let normals = (0..size * size)
            .map(|i| {
                let [x, z] = slope(i);
                glam::Vec3::new(-x, 1.0, -z).normalize().to_array()
            })
            .collect();
        let moments = (0..size * size)
            .map(|i| {
                let [x, z] = slope(i);
                [x, z, x * x + z * z]
            })
            .collect();
        NormalLevel { size, normals, moments }
    }

    #[test]
    fn mean_square_and_lost_variance_add_up_at_every_level() {
        let mut level = level();
        let total = level.moments.iter().map(|m| m[2]).sum::<f32>() / level.moments.len() as f32;
        while level.size > 1 {
            level = level.halved();
            let sum: f32 = (0..level.moments.len())
                .map(|i| level.moments[i][0].powi(2) + level.moments[i][1].powi(2) + level.lost(i))
                .sum();
            assert!((sum / level.moments.len() as f32 / total - 1.0).abs() < 1e-5);
        }
    }

    #[test]
    fn slopes_undo_normals_and_stay_bounded() {
        let normal = glam::Vec3::new(-0.3, 1.0, 0.7).normalize().to_array();
        let [x, z] = slope_of(normal);
        assert!((x - 0.3).abs() < 1e-6 && (z + 0.7).abs() < 1e-6);
        let [x, z] = slope_of([-1.0, -0.2, 0.0]);
        assert!(x.hypot(z) <= MAX_SLOPE * 1.001 && x > 0.0);
    }
}
