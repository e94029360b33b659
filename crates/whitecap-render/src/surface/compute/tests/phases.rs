//! The parts of a wave and of a point, run one by one.

use super::*;
use crate::gpu::for_tests::compute;
use crate::surface::compute::waves::fixed_point;
use crate::surface::normal_level::slope_of;

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Input {
    frequency: [u32; 2],
    moment_ticks: [u32; 2],
    part_of_tick: f32,
    slope_x: f32,
    slope_z: f32,
    xx: f32,
    xz: f32,
    zz: f32,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Output {
    turns: f32,
    cos: f32,
    sin: f32,
    normal_x: f32,
    normal_y: f32,
    normal_z: f32,
    slope_x: f32,
    slope_z: f32,
}

fn run(inputs: &[Input]) -> Option<Vec<Output>> {
    Some(compute(gpu()?, &shader_lib::SPECTRAL_TWINS, "cs_twins", inputs))
}

fn at(turns_per_s: f64, time_s: f64) -> Input {
    let GpuMoment { ticks, part_of_tick, .. } = GpuMoment::at(time_s);
    Input {
        frequency: fixed_point(turns_per_s),
        moment_ticks: ticks,
        part_of_tick,
        ..bytemuck::Zeroable::zeroed()
    }
}

#[test]
fn rust_and_wgsl_agree_about_layout() {
    let wgsl = shader_lib::SPECTRAL_TWINS.wgsl;
    assert_layout!(
        Input,
        wgsl,
        "Input",
        [frequency, moment_ticks, part_of_tick, slope_x, slope_z, xx, xz, zz]
    );
    assert_layout!(Output, wgsl, "Output", [turns, cos, sin, normal_x, normal_y, normal_z, slope_x, slope_z]);
}

/// A phase is right to 1e-7 turns for waves from minutes to a hundredth of a second, both ways, at any time within a
/// million seconds: on a tick, beside it, and between two.
#[test]
fn phases_are_exact_at_any_time() {
    let tick = 1.0 / 65_536.0;
    let times =
        [0.0, 3.7, -3.7, 1e6, -1e6, 999_999.999_99, -123_456.789, 70_000.0 - tick, 65_536.0, -0.4 * tick];
    let mut cases = Vec::new();
    for i in 0..400 {
        let size = turns_per_s(i);
        for turns_per_s in [size, -size] {
            for time_s in times {
                cases.push((turns_per_s, time_s));
                cases.push((turns_per_s, time_s + tick));
            }
        }
    }
    let inputs: Vec<Input> = cases.iter().map(|&(turns_per_s, time_s)| at(turns_per_s, time_s)).collect();
    let Some(outputs) = run(&inputs) else { return };
    let (mut worst, mut worst_wave) = (0.0f64, 0.0f64);
    for ((turns_per_s, time_s), seen) in cases.into_iter().zip(outputs) {
        // The product in two parts, so that it is good to 1e-9 turns where it is 1e8.
        let (whole, part) = (time_s.trunc(), time_s.fract());
        let turns = fraction_of_product(turns_per_s, whole) + turns_per_s * part;
        let off = f64::from(seen.turns) - turns;
        worst = worst.max((off - off.round()).abs());
        let (sin, cos) = (TAU * f64::from(seen.turns)).sin_cos();
        worst_wave = worst_wave.max((f64::from(seen.cos) - cos).abs()).max((f64::from(seen.sin) - sin).abs());
    }
    assert!(worst < 1e-7, "{worst} turns");
    assert!(worst_wave < 3e-7, "{worst_wave}");
}

/// From 0.005 to 100 in 400 steps.
fn turns_per_s(i: i32) -> f64 {
    0.005 * 20_000.0f64.powf(f64::from(i) / 399.0)
}

/// The fraction of a × b for a whole number b below 2²¹, with nothing rounded away: a in two parts of 26 bits.
fn fraction_of_product(a: f64, b: f64) -> f64 {
    let scale = 2f64.powi(20);
    let high = (a * scale).trunc() / scale;
    (high * b).fract() + ((a - high) * b).fract()
}

/// Upright, folded over, and where the tangents are parallel.
#[test]
fn normals_and_slopes_are_the_models() {
    let noise = |i: usize, salt: usize| ((i * 7919 + salt * 104_729) % 2001) as f32 / 700.0 - 1.4;
    let mut inputs: Vec<Input> = (0..500)
        .map(|i| Input {
            slope_x: noise(i, 1),
            slope_z: noise(i, 2),
            xx: noise(i, 3),
            xz: noise(i, 4),
            zz: noise(i, 5),
            ..bytemuck::Zeroable::zeroed()
        })
        .collect();
    inputs.push(Input { xx: -1.0, zz: -1.0, ..bytemuck::Zeroable::zeroed() });
    let Some(outputs) = run(&inputs) else { return };
    let mut folded = 0;
    for (input, seen) in inputs.iter().zip(outputs) {
        let mut fields = TileFields::new(1);
        (fields.slope_x[0], fields.slope_z[0]) = (input.slope_x, input.slope_z);
        (fields.gradient_xx[0], fields.gradient_xz[0], fields.gradient_zz[0]) =
            (input.xx, input.xz, input.zz);
        let normal = glam::Vec3::from(fields.normal(0));
        let off = normal - glam::Vec3::new(seen.normal_x, seen.normal_y, seen.normal_z);
        assert!(off.abs().max_element() < 1e-5, "{normal}");
        folded += usize::from(normal.y < 0.0);
        let [x, z] = slope_of(normal.to_array());
        // A slope of a steep normal is a quotient by a small number.
        let allowed = 1e-5 * (1.0 + 6.0 / normal.y.max(1e-3));
        assert!((x - seen.slope_x).abs().max((z - seen.slope_z).abs()) < allowed, "{normal}");
    }
    assert!(folded > 50, "{folded}");
}
