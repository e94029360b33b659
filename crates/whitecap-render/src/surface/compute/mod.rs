//! The spectral sea on the device: waves, transforms and maps as compute passes, the twin of
//! [`SpectralTile`]'s own evaluation.
//!
//! | pass | reads | writes |
//! | --- | --- | --- |
//! | evolve | P, Q (16 B a wave), ν, δ (16 B) | h of the half plane p ≥ 0 |
//! | columns | h, lean, factors, for each of four pairs of fields and both half planes | four spectra, transformed along q |
//! | rows | the same four | eight fields, two to a complex number |
//! | mesh maps | the fields, at the mesh's samples | displacement (rgba32f), slopes (rg32f) |
//! | normal map | slopes and gradients | normals and lost variance (rgba16f), levels 0 to 3; moments of level 3 |
//! | mips, up to three times | moments of levels 3, 6, 9 | the three levels after; moments of the last |
//! | lost variance | the sums beside all moments | twelve numbers, a uniform for shaders |
//!
//! Symbols as in `whitecap_waves::model::spectral`, and δ for the turns per second by which a current carries a wave
//! past. The waves' constants are uploaded once; a frame writes one uniform of 16 bytes, the time. Nothing is
//! carried from one frame to the next.
//!
//! Everything stays within WebGPU's default limits: 16 KiB of workgroup memory, 256 threads, and for N = 2048
//! bindings of exactly 128 MiB.

mod gpu;
mod maps;
mod waves;

#[cfg(test)]
mod tests;

use crate::gpu::resources::buffer;
use crate::shader_lib;
use crate::surface::tile_maps::{TileTextures, Vertices};
use gpu::{Pass, storage, uniform};
use maps::MapPasses;
use waves::{GpuMoment, WaveConstants, twiddles};
use whitecap_waves::model::spectral::SpectralTile;

/// Complex numbers that a workgroup transforms, as in `transform.wesl`.
const NUMBERS: u32 = 2048;

/// Pairs of fields.
const PAIRS: u32 = 4;

/// What `device` lacks for tiles of `resolution` samples a side, in words; `None` if it can.
pub(super) fn missing(device: &wgpu::Device, resolution: usize) -> Option<&'static str> {
    let limits = device.limits();
    let largest = u64::from(PAIRS) * 8 * (resolution as u64).pow(2);
    if device.adapter_info().backend == wgpu::Backend::Gl {
        // Rg32Float as a storage texture is beyond OpenGL ES.
        Some("storage textures for a sea on the GPU")
    } else if limits.max_compute_invocations_per_workgroup < 256
        || limits.max_compute_workgroup_storage_size < 8 * NUMBERS
        || limits.max_storage_buffers_per_shader_stage < 5
        || limits.max_storage_textures_per_shader_stage < 4
    {
        Some("compute passes as large as a sea on the GPU needs")
    } else if limits.max_storage_buffer_binding_size < largest || limits.max_buffer_size < largest {
        Some("storage buffers large enough for this sea on the GPU")
    } else {
        None
    }
}

/// The maps of a spectral tile, made on the device.
pub(super) struct SpectralMaps {
    fields: SpectralFields,
    passes: MapPasses,
}

impl SpectralMaps {
    /// Uploads the waves of `tile` and sets up the passes that fill `textures` for such `vertices`.
    pub(super) fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        tile: &SpectralTile,
        textures: &TileTextures,
        vertices: Vertices,
    ) -> SpectralMaps {
        let fields = SpectralFields::new(device, queue, &WaveConstants::of(tile, vertices));
        let passes = MapPasses::new(device, queue, &fields, textures);
        SpectralMaps { fields, passes }
    }

    /// Encodes the passes that bring the textures to `time_s`; see [`SpectralFields::encode`].
    pub(super) fn encode(&self, queue: &wgpu::Queue, encoder: &mut wgpu::CommandEncoder, time_s: f64) {
        self.fields.encode(queue, encoder, time_s);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some("spectral maps"),
            timestamp_writes: None,
        });
        self.passes.dispatch(&mut pass);
    }
}

/// The eight fields of a spectral tile, evolved and transformed on the device.
pub(super) struct SpectralFields {
    resolution: u32,
    moment: wgpu::Buffer,
    /// Two fields in each number: f32 pairs at (pair N + z) N + x.
    fields: wgpu::Buffer,
    evolve: Pass,
    columns: Pass,
    rows: Pass,
}

impl SpectralFields {
    /// Uploads the waves and makes the buffers and pipelines for them.
    fn new(device: &wgpu::Device, queue: &wgpu::Queue, waves: &WaveConstants) -> SpectralFields {
        let n = waves.tile.resolution;
        let upload = |label: &str, contents: &[u8]| {
            buffer(device, queue, label, contents, wgpu::BufferUsages::STORAGE)
        };
        let tile = uniform(device, queue, "tile", &waves.tile);
        let moment = uniform(device, queue, "moment", &GpuMoment::at(0.0));
        let amplitudes = upload("amplitudes", bytemuck::cast_slice(&waves.amplitudes));
        let frequencies = upload("frequencies", bytemuck::cast_slice(&waves.frequencies));
        let lean = upload("lean", bytemuck::cast_slice(&waves.lean));
        let factors = upload("displacement factors", bytemuck::cast_slice(&waves.displacement_factors));
        let twiddles = upload("twiddles", bytemuck::cast_slice(&twiddles(NUMBERS)));
        let complex = u64::from(n) * u64::from(n) * 8;
        let evolved = storage(device, "evolved waves", complex / 2);
        let columns = storage(device, "columns", u64::from(PAIRS) * complex);
        let fields = storage(device, "fields", u64::from(PAIRS) * complex);
        let rows_per_workgroup = n.min(NUMBERS / n);
        let transforms = [n / rows_per_workgroup, PAIRS, 1];
        SpectralFields {
            resolution: n,
            evolve: Pass::new(
                device,
                &shader_lib::SPECTRAL_EVOLVE,
                "cs_evolve",
                &[&tile, &moment, &amplitudes, &frequencies, &evolved],
                [n.div_ceil(64), n / 2, 1],
            ),
            columns: Pass::new(
                device,
                &shader_lib::SPECTRAL_COLUMNS,
                "cs_transform_columns",
                &[&tile, &twiddles, &evolved, &lean, &factors, &columns],
                transforms,
            ),
            rows: Pass::new(
                device,
                &shader_lib::SPECTRAL_ROWS,
                "cs_transform_rows",
                &[&tile, &twiddles, &columns, &fields],
                transforms,
            ),
            moment,
            fields,
        }
    }

    /// Encodes the passes that bring the fields to `time_s`. The time is written by the queue: it holds for
    /// whatever is submitted next.
    pub(super) fn encode(&self, queue: &wgpu::Queue, encoder: &mut wgpu::CommandEncoder, time_s: f64) {
        queue.write_buffer(&self.moment, 0, bytemuck::bytes_of(&GpuMoment::at(time_s)));
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some("spectral sea"),
            timestamp_writes: None,
        });
        for step in [&self.evolve, &self.columns, &self.rows] {
            step.dispatch(&mut pass);
        }
    }
}
