//! The maps of both backends, level by level.

use super::*;
use crate::Gpu;
use crate::gpu::read_level;
use crate::surface::normal_level::slope_of;
use crate::surface::{Backend, TileMaps};
use glam::DVec3;
use half::f16;
use whitecap_waves::model::{Surface, SurfacePoint};

/// A mesh of eight tiles in a row has 1024 vertices if it skips every other sample of 256.
const EIGHT_TILES: Vertices = Vertices::OnSamples { repeats: 8 };

pub(super) fn maps_of(gpu: &Gpu, backend: Backend, sea: Box<SpectralTile>, vertices: Vertices) -> TileMaps {
    let maps = TileMaps::new(&gpu.device, &gpu.queue, Some(backend), sea, vertices).unwrap();
    assert_eq!(maps.backend(), backend);
    maps
}

fn maps_at(gpu: &Gpu, backend: Backend, n: usize, vertices: Vertices, time_s: f64) -> TileMaps {
    let (device, queue) = (&gpu.device, &gpu.queue);
    let mut maps = maps_of(gpu, backend, Box::new(sea(n, 1.0)), vertices);
    for time_s in [time_s + 5.0, time_s] {
        let mut encoder = device.create_command_encoder(&Default::default());
        maps.update(queue, &mut encoder, time_s);
        queue.submit([encoder.finish()]);
    }
    maps
}

pub(super) fn floats(gpu: &Gpu, texture: &wgpu::Texture) -> Vec<f32> {
    bytemuck::pod_collect_to_vec(&read_level(&gpu.device, &gpu.queue, texture, 0).unwrap())
}

pub(super) fn texels(gpu: &Gpu, maps: &TileMaps, mip: u32) -> Vec<[f32; 4]> {
    let bytes = read_level(&gpu.device, &gpu.queue, &maps.textures.normals, mip).unwrap();
    let halves: Vec<[f16; 4]> = bytemuck::pod_collect_to_vec(&bytes);
    halves.into_iter().map(|texel| texel.map(f16::to_f32)).collect()
}

fn lost_variance(gpu: &Gpu, maps: &TileMaps) -> Vec<f32> {
    let bytes = read_buffer(&gpu.device, &gpu.queue, &maps.textures.lost_variance).unwrap();
    bytemuck::pod_collect_to_vec(&bytes)
}

#[test]
fn rust_and_wgsl_agree_about_layout() {
    let wgsl = shader_lib::SPECTRAL_MIPS.wgsl;
    assert_layout!(
        crate::surface::compute::maps::GpuLevel,
        wgsl,
        "GpuLevel",
        [side, source_start, target_start]
    );
    let (_, size) = crate::shader_lib::layout::reflected(wgsl, "Moments");
    assert_eq!(u64::from(size), crate::surface::compute::maps::MOMENTS_BYTES);
}

/// Sizes whose last step makes one, two and three levels, with a mesh that lies anywhere, with one that lies on samples
/// and with one that skips some.
#[test]
fn both_backends_make_the_same_maps() {
    let Some(gpu) = gpu() else { return };
    let cases = [
        (16, EIGHT_TILES),
        (32, Vertices::Anywhere),
        (64, EIGHT_TILES),
        (256, Vertices::Anywhere),
        (256, EIGHT_TILES),
    ];
    for (n, vertices) in cases {
        let [cpu, device] =
            [Backend::Cpu, Backend::Gpu].map(|backend| maps_at(gpu, backend, n, vertices, 3.7));
        assert_eq!(cpu.mesh_samples(), if vertices == EIGHT_TILES { n.min(128) } else { n });
        let both =
            |texture: fn(&TileMaps) -> &wgpu::Texture| [&cpu, &device].map(|m| floats(gpu, texture(m)));
        let [expected, seen] = both(|maps| &maps.textures.displacement);
        assert!(worst(&expected, &seen) < 1e-5, "displacement of {n}²");
        let [expected, seen] = both(|maps| &maps.textures.slopes);
        assert!(worst(&expected, &seen) < 1e-5, "slopes of {n}²");
        for mip in 0..=n.ilog2() {
            let [expected, seen] = [&cpu, &device].map(|maps| texels(gpu, maps, mip));
            assert_eq!(expected.len(), (n >> mip).pow(2));
            for (expected, seen) in expected.iter().flatten().zip(seen.iter().flatten()) {
                // A rounding to half floats that falls the other way, where it is finest as well.
                let allowed = expected.abs() / 1000.0 + 1e-6;
                assert!((expected - seen).abs() < allowed, "level {mip} of {n}²: {expected} {seen}");
            }
        }
        let [expected, seen] = [&cpu, &device].map(|maps| lost_variance(gpu, maps));
        assert_eq!(expected.len(), 12);
        for (expected, seen) in expected.into_iter().zip(seen) {
            assert!((expected - seen).abs() <= 1e-4 * expected + 1e-7, "{n}²: {expected} {seen}");
        }
    }
}

/// At every level the mean square of the mean slope and the lost variance add up to the mean square of slope, which is
/// alpha's mean.
#[test]
fn means_and_lost_variance_add_up() {
    let Some(gpu) = gpu() else { return };
    for n in [16, 128, 512] {
        let maps = maps_at(gpu, Backend::Gpu, n, EIGHT_TILES, -1e6);
        let mut fields = TileFields::new(n);
        sea(n, 1.0).evaluate(-1e6, &mut fields);
        let slopes: Vec<DVec2> =
            (0..n * n).map(|i| DVec2::from(slope_of(fields.normal(i)).map(f64::from))).collect();
        let total = slopes.iter().map(|s| s.length_squared()).sum::<f64>() / (n * n) as f64;
        let lost = lost_variance(gpu, &maps);
        for mip in 0..=n.ilog2() {
            let side = n >> mip;
            let mut sums = vec![DVec2::ZERO; side * side];
            for (i, slope) in slopes.iter().enumerate() {
                sums[((i / n) >> mip) * side + ((i % n) >> mip)] += *slope;
            }
            let per_texel = 4f64.powi(mip as i32);
            let kept =
                sums.iter().map(|sum| (*sum / per_texel).length_squared()).sum::<f64>() / sums.len() as f64;
            let lost = f64::from(lost[mip as usize]);
            assert!(
                ((kept + lost) / total - 1.0).abs() < 1e-5,
                "level {mip} of {n}²: {kept} + {lost} of {total}"
            );
            let alpha =
                texels(gpu, &maps, mip).iter().map(|t| f64::from(t[3])).sum::<f64>() / sums.len() as f64;
            assert!((alpha / total - 1.0).abs() <= 1e-3, "level {mip} of {n}²: {alpha} of {total}");
        }
        assert!(lost[n.ilog2() as usize..].iter().all(|&l| (f64::from(l) / total - 1.0).abs() < 1e-4));
    }
}

/// A level sea.
struct Level;

impl Surface for Level {
    fn variance_m2(&self) -> f64 {
        0.0
    }
    fn sample(&self, _rest_m: DVec2, _time_s: f64) -> SurfacePoint {
        SurfacePoint {
            displacement_m: DVec3::ZERO,
            normal: DVec3::Y,
            jacobian: 1.0,
            slope: DVec2::ZERO,
            velocity_mps: DVec3::ZERO,
        }
    }
}

impl WaveModel for Level {
    fn tile_size_m(&self) -> f64 {
        10.0
    }
    fn resolution(&self) -> usize {
        16
    }
    fn evaluate(&mut self, _time_s: f64, fields: &mut TileFields) {
        *fields = TileFields::new(16);
    }
}

/// What has no spectrum cannot be moved by the device: told where it is asked for, and never chosen.
#[test]
fn a_sea_without_a_spectrum_stays_on_the_processor() {
    let Some(gpu) = gpu() else { return };
    let (device, queue) = (&gpu.device, &gpu.queue);
    let refused = TileMaps::new(device, queue, Some(Backend::Gpu), Box::new(Level), ON_SAMPLES);
    assert!(matches!(refused.err(), Some(crate::RenderError::Unsupported { .. })));
    assert_eq!(
        TileMaps::new(device, queue, None, Box::new(Level), ON_SAMPLES).unwrap().backend(),
        Backend::Cpu
    );
    let chosen = TileMaps::new(device, queue, None, Box::new(sea(16, 1.0)), ON_SAMPLES).unwrap();
    assert_eq!(chosen.backend() == Backend::Cpu, gpu.adapter.is_software());
}
