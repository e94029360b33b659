//! The fields of a whole sea; `tests/one_wave.rs` has those of one wave, `tests/phases.rs` its parts,
//! `tests/maps.rs` the maps, and `tests/seas.rs` other kinds of sea.

use super::waves::GpuTile;
use super::*;
use crate::gpu::for_tests::gpu;
use crate::gpu::read_buffer;
use crate::shader_lib::layout::assert_layout;
use glam::DVec2;
use std::f64::consts::TAU;
use whitecap_waves::model::spectral::{Amplitudes, Band, SpectralTileParameters, Water};
use whitecap_waves::model::{TileFields, WaveModel};
use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};

mod maps;
mod one_wave;
mod phases;
mod seas;

const ON_SAMPLES: Vertices = Vertices::OnSamples { repeats: 1 };

/// A sea with waves in all directions, on a current.
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
        band: Band::WHOLE,
        choppiness,
        water: Water { current_mps: DVec2::new(0.7, -0.4), ..Water::STILL },
        seed: 42,
        amplitudes: Amplitudes::Gaussian,
    };
    SpectralTile::new(parameters, &[wind.unwrap()]).unwrap()
}

/// The fields at a time, as the CPU lays them out.
fn evaluate(gpu: &crate::Gpu, fields: &SpectralFields, time_s: f64) -> TileFields {
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    fields.encode(&gpu.queue, &mut encoder, time_s);
    gpu.queue.submit([encoder.finish()]);
    let bytes = read_buffer(&gpu.device, &gpu.queue, &fields.fields).unwrap();
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

fn mean_square(values: &[f32]) -> f64 {
    values.iter().map(|&v| f64::from(v).powi(2)).sum::<f64>() / values.len() as f64
}

/// The largest difference of two fields.
fn worst(expected: &[f32], seen: &[f32]) -> f64 {
    assert_eq!(expected.len(), seen.len());
    expected.iter().zip(seen).map(|(a, b)| (f64::from(*a) - f64::from(*b)).abs()).fold(0.0, f64::max)
}

#[test]
fn rust_and_wgsl_agree_about_layout() {
    let wgsl = shader_lib::SPECTRAL_EVOLVE.wgsl;
    assert_layout!(GpuMoment, wgsl, "GpuMoment", [ticks, part_of_tick]);
    assert_layout!(GpuTile, wgsl, "GpuTile", [resolution, log2_resolution, spacing_rad_per_m]);
}

/// Both backends, samples and coefficients, every size of first step, a million seconds before and after. Every field to
/// 2e-5 of its r.m.s., which for heights is 5e-6 of the significant height.
#[test]
fn both_backends_agree() {
    let Some(gpu) = gpu() else { return };
    for n in [16, 32, 64, 128, 256, 512, 1024, 2048] {
        let mut sea = sea(n, 1.3);
        let [samples, coefficients] = [ON_SAMPLES, Vertices::Anywhere]
            .map(|vertices| SpectralFields::new(&gpu.device, &gpu.queue, &WaveConstants::of(&sea, vertices)));
        let mut expected = TileFields::new(n);
        // The largest one takes its time.
        let times = [-1e6, 0.0, 3.7, 1e6];
        for &time_s in if n < 1024 { &times[..] } else { &times[..1] } {
            let mut agree = |evaluated: fn(&mut SpectralTile, f64, &mut TileFields), fields| {
                evaluated(&mut sea, time_s, &mut expected);
                let seen = evaluate(gpu, fields, time_s);
                for ((name, expected), (_, seen)) in arrays(&expected).into_iter().zip(arrays(&seen)) {
                    let worst = worst(expected, seen) / mean_square(expected).sqrt();
                    assert!(worst < 2e-5, "{name} of {n}² at {time_s}: {worst}");
                }
            };
            agree(SpectralTile::evaluate, &samples);
            agree(SpectralTile::evaluate_coefficients, &coefficients);
        }
    }
}

/// Parseval's theorem: the variance of a field is the sum of |H|² over the whole plane.
#[test]
fn variances_are_sums_over_the_spectrum() {
    let Some(gpu) = gpu() else { return };
    for n in [16, 128] {
        let sea = sea(n, 1.0);
        let fields = SpectralFields::new(&gpu.device, &gpu.queue, &WaveConstants::of(&sea, ON_SAMPLES));
        let time_s = 17.0;
        let (mut energy, mut slopes) = (0.0, 0.0);
        for p in 0..n / 2 {
            let column = sea.column(p);
            for q in (0..n).filter(|&q| q != n / 2) {
                let [p_re, p_im, q_re, q_im] = column.amplitudes.map(|part| f64::from(part[q]));
                let (sin, cos) = (TAU * column.turns_per_s[q.min(n - q)] * time_s).sin_cos();
                let square = (cos * p_re + sin * q_re).powi(2) + (cos * p_im + sin * q_im).powi(2);
                let k = TAU / sea.tile_size_m() * (p as f64).hypot(q.min(n - q) as f64);
                let times = if p == 0 { 1.0 } else { 2.0 };
                energy += times * square;
                slopes += times * square * k * k;
            }
        }
        let seen = evaluate(gpu, &fields, time_s);
        assert!((mean_square(&seen.height) / energy - 1.0).abs() < 1e-5);
        let seen = mean_square(&seen.slope_x) + mean_square(&seen.slope_z);
        assert!((seen / slopes - 1.0).abs() < 1e-5);
    }
}

#[test]
fn a_moment_is_the_same_whatever_came_before() {
    let Some(gpu) = gpu() else { return };
    let waves = WaveConstants::of(&sea(32, 1.0), ON_SAMPLES);
    let fields = SpectralFields::new(&gpu.device, &gpu.queue, &waves);
    let first = evaluate(gpu, &fields, 12.25);
    assert_ne!(evaluate(gpu, &fields, -4e5), first);
    assert_eq!(evaluate(gpu, &fields, 12.25), first);
}

/// In a browser there is no more than this. 16 KiB of workgroup memory less a little, which wgpu calls downlevel, is
/// not enough, and is seen to be so.
#[test]
fn webgpus_default_limits_are_enough() {
    if gpu().is_none() {
        return;
    }
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = wgpu::Backends::PRIMARY;
    let instance = wgpu::Instance::new(descriptor);
    let adapter = pollster::block_on(instance.request_adapter(&Default::default())).unwrap();
    let open = |limits: wgpu::Limits| {
        let descriptor = wgpu::DeviceDescriptor { required_limits: limits, ..Default::default() };
        pollster::block_on(adapter.request_device(&descriptor)).unwrap()
    };
    let (device, queue) = open(wgpu::Limits::default());
    assert_eq!((missing(&device, 16), missing(&device, 2048)), (None, None));
    let (small, _) = open(wgpu::Limits::downlevel_defaults());
    assert!(missing(&small, 64).is_some());

    let made = crate::gpu::checked(&device, "a sea", || {
        let sea = Box::new(sea(64, 1.0));
        let backend = Some(crate::surface::Backend::Gpu);
        let mut maps = crate::surface::TileMaps::new(&device, &queue, backend, sea, ON_SAMPLES)?;
        let mut encoder = device.create_command_encoder(&Default::default());
        maps.update(&queue, &mut encoder, 1.0);
        queue.submit([encoder.finish()]);
        Ok(())
    });
    made.unwrap();
}
