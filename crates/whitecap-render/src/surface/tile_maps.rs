//! A tile of sea as textures: displacement and slopes for vertices, normals with mips for pixels.

use super::backend::{Backend, evolved_on_device};
use super::compute::SpectralMaps;
use super::normal_level::NormalLevel;
use crate::gpu::resources::{buffer, texture_2d, write_level};
use crate::threads::*;
use crate::{RenderError, gpu::checked};
use glam::DVec2;
use wgpu::{TextureFormat, TextureUsages};
use whitecap_waves::model::{TileFields, WaveModel};

/// Samples along a side of the largest tile, and mip levels of its normal map.
const MAX_RESOLUTION: usize = 2048;
const MAX_LEVELS: usize = MAX_RESOLUTION.ilog2() as usize + 1;

/// Vertices along a side of a mesh stay within this; of a finer tile every 2nd, 4th … sample is used.
const MAX_MESH_SIDE: usize = 1024;

/// Where the vertices of a mesh lie on a tile, which decides what its displacement map holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Vertices {
    /// On samples of so many tiles side by side: the map holds those that the mesh uses.
    OnSamples {
        /// Tiles along a side of the mesh, at least 1.
        repeats: u32,
    },
    /// Anywhere: the map holds coefficients of cubic B-splines, as
    /// [`evaluate_coefficients`](WaveModel::evaluate_coefficients) has them, one for each sample.
    Anywhere,
}

impl Vertices {
    /// Of a tile with `n` samples a side every so many-th is in the vertex maps.
    fn stride(self, n: usize) -> usize {
        let Vertices::OnSamples { repeats } = self else { return 1 };
        let mut stride = 1;
        while n * repeats as usize / stride > MAX_MESH_SIDE {
            stride *= 2;
        }
        stride
    }
}

/// The textures that hold a tile at one moment, and what its normal map has lost.
///
/// The normal map carries what its mips, and the filter between its texels, average away: red, green and blue are the mean
/// normal (x, y, z), alpha the mean square slope, both axes together (Olano and Baker, "LEAN Mapping", 2010). What alpha has
/// more than the square of the mean's slope is the variance of slope that is not seen: `unseen_variance` in
/// `roughness.wesl`.
pub struct TileTextures {
    /// Displacement (x, height, z), metres, `Rgba32Float`: samples or coefficients, as the [`Vertices`] need them.
    pub displacement: wgpu::Texture,
    /// Slopes (∂h/∂x, ∂h/∂z) of the displaced surface there, `Rg32Float`.
    pub slopes: wgpu::Texture,
    /// Normals of all samples with mips, `Rgba16Float`.
    pub normals: wgpu::Texture,
    /// Mean slope variance (both axes) that each mip of the normal map has lost: twelve f32, after the last mip its
    /// value again. A uniform for shaders, so that nobody waits for the device to tell it.
    pub lost_variance: wgpu::Buffer,
}

impl TileTextures {
    /// For a tile of `n` samples a side, of which a mesh uses `mesh`.
    fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        n: usize,
        mesh: usize,
        backend: Backend,
    ) -> TileTextures {
        let (texture_usage, buffer_usage) = match backend {
            Backend::Cpu => (TextureUsages::COPY_DST, wgpu::BufferUsages::COPY_DST),
            Backend::Gpu => (TextureUsages::STORAGE_BINDING, wgpu::BufferUsages::STORAGE),
        };
        let texture = |label: &str, side: usize, levels: u32, format| {
            let usage = texture_usage | TextureUsages::COPY_SRC;
            texture_2d(device, label, [side as u32; 2], levels, format, usage)
        };
        let usage = buffer_usage | wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_SRC;
        let none_lost = [0.0f32; MAX_LEVELS];
        TileTextures {
            displacement: texture("displacement", mesh, 1, TextureFormat::Rgba32Float),
            slopes: texture("slopes", mesh, 1, TextureFormat::Rg32Float),
            normals: texture("normals", n, n.ilog2() + 1, TextureFormat::Rgba16Float),
            lost_variance: buffer(device, queue, "lost variance", bytemuck::cast_slice(&none_lost), usage),
        }
    }

    /// Uploads a tile's fields at one moment.
    fn upload(&self, queue: &wgpu::Queue, fields: &TileFields) {
        let (n, mesh) = (fields.resolution(), self.displacement.width() as usize);
        let stride = n / mesh;
        let sample = move |i: usize| (i / mesh) * stride * n + (i % mesh) * stride;
        let displacement: Vec<[f32; 4]> = (0..mesh * mesh)
            .into_par_iter()
            .map(|i| {
                let [x, y, z] = fields.displacement(sample(i));
                [x, y, z, 0.0]
            })
            .collect();
        write_level(queue, &self.displacement, 0, bytemuck::cast_slice(&displacement));
        let mut level = NormalLevel::of(fields);
        let slopes: Vec<[f32; 2]> =
            (0..mesh * mesh).into_par_iter().map(|i| level.slope(sample(i))).collect();
        write_level(queue, &self.slopes, 0, bytemuck::cast_slice(&slopes));

        let mut lost_variance = [0.0; MAX_LEVELS];
        for mip in 0..=n.ilog2() {
            lost_variance[mip as usize..].fill(level.mean_lost_variance());
            write_level(queue, &self.normals, mip, bytemuck::cast_slice(&level.texels()));
            if mip < n.ilog2() {
                level = level.halved();
            }
        }
        queue.write_buffer(&self.lost_variance, 0, bytemuck::cast_slice(&lost_variance));
    }
}

/// A wave model and the textures that hold it at one moment, whichever [`Backend`] fills them.
pub struct TileMaps {
    model: Box<dyn WaveModel>,
    /// What shaders read.
    pub textures: TileTextures,
    source: Source,
    vertices: Vertices,
}

/// Where the textures' contents come from.
enum Source {
    /// The model's own evaluation.
    Cpu(TileFields),
    /// Compute passes.
    Gpu(SpectralMaps),
}

impl TileMaps {
    /// Makes the textures for `model` and a mesh with such `vertices`. Without a `backend` the device's kind decides.
    ///
    /// # Errors
    ///
    /// [`RenderError::OutOfMemory`] or [`RenderError::LimitExceeded`]; [`RenderError::Unsupported`] if `backend`
    /// asks for what device or model cannot do.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        backend: Option<Backend>,
        model: Box<dyn WaveModel>,
        vertices: Vertices,
    ) -> Result<TileMaps, RenderError> {
        let n = model.resolution();
        if n == 0 || n > MAX_RESOLUTION {
            return Err(RenderError::LimitExceeded {
                what: "the number of samples along a side of the sea's tile".into(),
                asked: n as u64,
                accepted: format!("1 to {MAX_RESOLUTION}"),
            });
        }
        checked(device, "the sea's maps", || {
            let textures = |backend| TileTextures::new(device, queue, n, n / vertices.stride(n), backend);
            let (textures, source) = match evolved_on_device(backend, device, &*model)? {
                None => (textures(Backend::Cpu), Source::Cpu(TileFields::new(n))),
                Some(tile) => {
                    let textures = textures(Backend::Gpu);
                    let maps = SpectralMaps::new(device, queue, tile, &textures, vertices);
                    (textures, Source::Gpu(maps))
                }
            };
            Ok(TileMaps { model, textures, source, vertices })
        })
    }

    /// Brings the textures to `time_s`. On the GPU the work is encoded and the time written by the queue, so one
    /// call belongs to one submission.
    pub fn update(&mut self, queue: &wgpu::Queue, encoder: &mut wgpu::CommandEncoder, time_s: f64) {
        match &mut self.source {
            Source::Cpu(fields) => {
                match self.vertices {
                    Vertices::OnSamples { .. } => self.model.evaluate(time_s, fields),
                    Vertices::Anywhere => self.model.evaluate_coefficients(time_s, fields),
                }
                self.textures.upload(queue, fields);
            }
            Source::Gpu(maps) => maps.encode(queue, encoder, time_s),
        }
    }

    /// Who fills the textures.
    pub fn backend(&self) -> Backend {
        match self.source {
            Source::Cpu(_) => Backend::Cpu,
            Source::Gpu(_) => Backend::Gpu,
        }
    }

    /// Samples along a side of the tile that the vertex maps hold.
    pub fn mesh_samples(&self) -> usize {
        self.textures.displacement.width() as usize
    }

    /// Samples along a side of the normal map.
    pub fn resolution(&self) -> usize {
        self.textures.normals.width() as usize
    }

    /// Side of the tile, metres.
    pub fn tile_size_m(&self) -> f64 {
        self.model.tile_size_m()
    }

    /// Metres between the vertices of a mesh on this tile.
    pub fn cell_m(&self) -> f64 {
        self.tile_size_m() / self.mesh_samples() as f64
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
