use super::*;
use crate::gpu::for_tests::gpu;
use crate::gpu::read_buffer;
use crate::shader_lib::layout::assert_layout;
use glam::DVec2;
use whitecap_waves::model::TileFields;
use whitecap_waves::model::spectral::{Amplitudes, SpectralTileParameters};
use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};

/// A sea with waves in all directions.
fn sea(resolution: usize, choppiness: f64) -> SpectralTile {
    let wind = Phillips::new(PhillipsParameters {
        wind_speed_mps: 9.0,
        toward: DVec2::from_angle(0.7),
        significant_height_m: Some(2.0),
        opposing_energy: 0.2,
        small_wave_cutoff_m: 0.0,
    });
    let parameters = SpectralTileParameters {
        tile_size_m: 250.0,
        resolution,
        choppiness,
        seed: 42,
        amplitudes: Amplitudes::Gaussian,
    };
    SpectralTile::new(parameters, &[wind.unwrap()]).unwrap()
}

/// The fields as the CPU lays them out.
fn read_fields(device: &wgpu::Device, queue: &wgpu::Queue, fields: &SpectralFields) -> TileFields {
    let bytes = read_buffer(device, queue, &fields.fields).unwrap();
    let numbers: Vec<[f32; 2]> = bytemuck::pod_collect_to_vec(&bytes);
    let n = fields.resolution as usize;
    let pair = |i: usize| numbers[i * n * n..][..n * n].iter().map(|&[a, b]| (a, b)).unzip();
    let mut out = TileFields::new(n);
    (out.height, out.gradient_xz) = pair(0);
    (out.displacement_x, out.displacement_z) = pair(1);
    (out.slope_x, out.slope_z) = pair(2);
    (out.gradient_xx, out.gradient_zz) = pair(3);
    out
}

fn evaluate(gpu: &crate::Gpu, fields: &SpectralFields, time_s: f64) -> TileFields {
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    fields.encode(&gpu.queue, &mut encoder, time_s);
    gpu.queue.submit([encoder.finish()]);
    read_fields(&gpu.device, &gpu.queue, fields)
}

fn arrays(fields: &TileFields) -> [(&str, &[f32]); 8] {
    [
        ("height", &fields.height),
        ("displacement_x", &fields.displacement_x),
        ("displacement_z", &fields.displacement_z),
        ("slope_x", &fields.slope_x),
        ("slope_z", &fields.slope_z),
        ("gradient_xx", &fields.gradient_xx),
        ("gradient_xz", &fields.gradient_xz),
        ("gradient_zz", &fields.gradient_zz),
    ]
}

/// The largest difference of two fields over the first one's root mean square.
fn worst(expected: &[f32], seen: &[f32]) -> f64 {
    let square: f64 = expected.iter().map(|&v| f64::from(v).powi(2)).sum();
    let rms = (square / expected.len() as f64).sqrt();
    let difference = expected.iter().zip(seen).map(|(a, b)| (f64::from(*a) - f64::from(*b)).abs());
    difference.fold(0.0, f64::max) / rms
}

#[test]
fn rust_and_wgsl_agree_about_layout() {
    let wgsl = shader_lib::SPECTRAL_EVOLVE.wgsl;
    assert_layout!(GpuMoment, wgsl, "GpuMoment", [ticks, part_of_tick]);
    assert_layout!(GpuTile, wgsl, "GpuTile", [resolution, log2_resolution, spacing_rad_per_m]);
}

/// Both backends, every size of first step, a million seconds before and after. Every field to 2e-5 of its
/// height, which is four times their r.m.s.; the other fields to 2e-5 of their own r.m.s.
#[test]
fn both_backends_agree() {
    let Some(gpu) = gpu() else { return };
    for n in [16, 32, 64, 128, 256, 512] {
        let mut sea = sea(n, 1.3);
        let fields = SpectralFields::new(&gpu.device, &gpu.queue, &sea);
        let mut expected = TileFields::new(n);
        for time_s in [-1e6, 0.0, 3.7, 1e6] {
            sea.evaluate(time_s, &mut expected);
            let seen = evaluate(gpu, &fields, time_s);
            for ((name, expected), (_, seen)) in arrays(&expected).into_iter().zip(arrays(&seen)) {
                let worst = worst(expected, seen);
                assert!(worst < 2e-5, "{name} of {n}² at {time_s}: {worst}");
            }
        }
    }
}
