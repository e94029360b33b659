//! The spectral sea on the device: waves, transforms and maps as compute passes, the twin of
//! [`SpectralTile`]'s own evaluation.
//!
//! | pass | reads | writes |
//! | --- | --- | --- |
//! | evolve | P, Q (16 B a wave), ν, δ (16 B) | h of the half plane p ≥ 0 |
//! | columns | h, lean, for each of four pairs of fields and both half planes | four spectra, transformed along q |
//! | rows | the same four | eight fields, two to a complex number |
//!
//! Symbols as in `whitecap_waves::model::spectral`, and δ for the turns per second by which a current carries a wave
//! past. The waves' constants are uploaded once; a frame writes one uniform of 16 bytes, the time. Nothing is
//! carried from one frame to the next.
//!
//! Everything stays within WebGPU's default limits: 16 KiB of workgroup memory, 256 threads, and for N = 2048
//! bindings of exactly 128 MiB.

mod gpu;
mod waves;

#[cfg(test)]
mod tests;

use crate::gpu::resources::buffer;
use crate::shader_lib;
use gpu::{Pass, storage, uniform};
use waves::{GpuMoment, GpuTile};
use whitecap_waves::model::WaveModel;
use whitecap_waves::model::spectral::SpectralTile;

/// Complex numbers that a workgroup transforms, as in `transform.wesl`.
const NUMBERS: u32 = 2048;

/// Pairs of fields.
const PAIRS: u32 = 4;

/// The eight fields of a spectral tile, evolved and transformed on the device.
pub(crate) struct SpectralFields {
    resolution: u32,
    moment: wgpu::Buffer,
    tile: wgpu::Buffer,
    /// Two fields in each number: f32 pairs at (pair N + z) N + x.
    fields: wgpu::Buffer,
    evolve: Pass,
    columns: Pass,
    rows: Pass,
}

impl SpectralFields {
    /// Uploads the waves of `tile` and makes the buffers and pipelines for them.
    pub(crate) fn new(device: &wgpu::Device, queue: &wgpu::Queue, tile: &SpectralTile) -> SpectralFields {
        let n = tile.resolution() as u32;
        let upload = |label: &str, contents: &[u8]| {
            buffer(device, queue, label, contents, wgpu::BufferUsages::STORAGE)
        };
        let gpu_tile = GpuTile::of(tile);
        let tile_buffer = uniform(device, queue, "tile", &gpu_tile);
        let moment = uniform(device, queue, "moment", &GpuMoment::at(0.0));
        let amplitudes = upload("amplitudes", bytemuck::cast_slice(&waves::amplitudes(tile)));
        let frequencies = upload("frequencies", bytemuck::cast_slice(&waves::frequencies(tile)));
        let lean = upload("lean", bytemuck::cast_slice(&waves::lean(tile)));
        let twiddles = upload("twiddles", bytemuck::cast_slice(&waves::twiddles(NUMBERS)));
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
                &[&tile_buffer, &moment, &amplitudes, &frequencies, &evolved],
                [n.div_ceil(64), n / 2, 1],
            ),
            columns: Pass::new(
                device,
                &shader_lib::SPECTRAL_COLUMNS,
                "cs_transform_columns",
                &[&tile_buffer, &twiddles, &evolved, &lean, &columns],
                transforms,
            ),
            rows: Pass::new(
                device,
                &shader_lib::SPECTRAL_ROWS,
                "cs_transform_rows",
                &[&tile_buffer, &twiddles, &columns, &fields],
                transforms,
            ),
            moment,
            tile: tile_buffer,
            fields,
        }
    }

    /// Encodes the passes that bring the fields to `time_s`. The time is written by the queue: it holds for
    /// whatever is submitted next.
    pub(crate) fn encode(&self, queue: &wgpu::Queue, encoder: &mut wgpu::CommandEncoder, time_s: f64) {
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
