//! The sum of four sines as a uniform: a shader calculates it at each vertex.

use glam::DVec2;
use whitecap_waves::model::sines::SumOfSines;

/// Layout twin of `GpuSines` in `shader_lib/sines.wesl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct GpuSines {
    pub(crate) sine: [f32; 4],
    pub(crate) cosine: [f32; 4],
    pub(crate) phases: [f32; 4],
    pub(crate) heights: [f32; 4],
    pub(crate) direction_x: [f32; 4],
    pub(crate) direction_y: [f32; 4],
    pub(crate) stretch: f32,
    pub(crate) slope_factor: f32,
    pub(crate) uv_per_m: f32,
    pub(crate) unit_m: f32,
    pub(crate) folds: f32,
    pub(crate) mended_tangent: f32,
    pub(crate) padding: [u32; 2],
}

impl GpuSines {
    /// The waves at `time_s`, for texture coordinates that are counted from `uv_origin`. The phases there are
    /// brought into one turn in f64, so that neither a far place nor a late time costs the shader digits. The
    /// tangent is the printed one.
    pub(crate) fn new(sines: &SumOfSines, uv_origin: DVec2, time_s: f64) -> GpuSines {
        let parameters = sines.parameters();
        let series = parameters.taylor.series();
        let waves = &parameters.waves;
        let f32s = |values: [f64; 4]| values.map(|value| value as f32);
        GpuSines {
            sine: f32s(series.sine),
            cosine: f32s(series.cosine),
            phases: f32s(sines.phases(uv_origin, time_s)),
            heights: f32s(waves.map(|wave| wave.height)),
            direction_x: f32s(waves.map(|wave| wave.direction_per_uv.x)),
            direction_y: f32s(waves.map(|wave| wave.direction_per_uv.y)),
            stretch: series.stretch as f32,
            slope_factor: parameters.slope_factor as f32,
            uv_per_m: (1.0 / parameters.uv_size_m) as f32,
            unit_m: parameters.unit_m as f32,
            folds: f32::from(u8::from(series.folds)),
            mended_tangent: 0.0,
            padding: [0; 2],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::for_tests::{compute, gpu};
    use crate::shader_lib::{self, layout::assert_layout};
    use glam::{DVec3, Vec4};
    use std::f32::consts::PI;
    use std::f64::consts::TAU;
    use whitecap_waves::model::sines::{SumOfSinesParameters, Taylor};

    #[repr(C)]
    #[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
    struct Input {
        sines: GpuSines,
        phases: [f32; 4],
        place: [f32; 4],
    }

    #[repr(C)]
    #[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
    struct Output {
        x: Vec4,
        sine: Vec4,
        cosine: Vec4,
        raised: Vec4,
        normal: Vec4,
        tangent: Vec4,
        binormal: Vec4,
    }

    fn ocean(taylor: Taylor) -> SumOfSines {
        SumOfSines::new(SumOfSinesParameters { taylor, ..SumOfSinesParameters::OCEAN_WATER }).unwrap()
    }

    fn run(inputs: &[Input]) -> Option<Vec<Output>> {
        Some(compute(gpu()?, &shader_lib::SINES_TWINS, "cs_run", inputs))
    }

    fn at(sines: &SumOfSines, origin: DVec2, time_s: f64, from_origin: DVec2, damp: f64) -> Input {
        let [u, v] = from_origin.as_vec2().to_array();
        let sines = GpuSines::new(sines, origin, time_s);
        Input { sines, phases: [0.0; 4], place: [u, v, damp as f32, 0.0] }
    }

    fn assert_near(seen: Vec4, expected: DVec3, tolerance: f64) {
        assert!(seen.truncate().as_dvec3().distance(expected) < tolerance, "{seen} for {expected}");
    }

    #[test]
    fn rust_and_wgsl_agree_about_layout() {
        assert_layout!(
            GpuSines,
            shader_lib::SINES_TWINS.wgsl,
            "GpuSines",
            [
                sine,
                cosine,
                phases,
                heights,
                direction_x,
                direction_y,
                stretch,
                slope_factor,
                uv_per_m,
                unit_m,
                folds,
                mended_tangent
            ]
        );
        assert_layout!(Input, shader_lib::SINES_TWINS.wgsl, "TwinInput", [sines, phases, place]);
    }

    /// The polynomials at phases worked out by hand, whole turns away on either side.
    #[test]
    fn golden_polynomials() {
        let golden = [
            (0.0, -PI, -0.081375, -0.976022),
            (0.1, -2.500708, -0.666921, -0.799052),
            (0.25, -1.539380, -1.017799, 0.031431),
            (0.5, 0.062832, 0.062792, 0.998027),
            (0.75, 1.665044, 1.018611, -0.094064),
            (0.9, 2.626371, 0.568820, -0.866097),
        ];
        let sines = GpuSines::new(&ocean(Taylor::Printed), DVec2::ZERO, 0.0);
        let inputs: Vec<Input> = golden
            .iter()
            .map(|&(f, ..)| Input { sines, phases: [f, f - 3.0, f + 2.0, f], place: [0.0; 4] })
            .collect();
        let Some(outputs) = run(&inputs) else { return };
        for ((_, x, s, q), seen) in golden.into_iter().zip(outputs) {
            for (seen, expected) in [(seen.x, x), (seen.sine, s), (seen.cosine, q)] {
                assert!((seen - Vec4::splat(expected)).abs().max_element() < 1e-5, "{seen} for {expected}");
            }
        }
    }

    /// Mended, the polynomials are −sin 2πf and −cos 2πf, at the seam and where x is folded as well.
    #[test]
    fn mended_polynomials_are_sine_and_cosine() {
        let sines = GpuSines::new(&ocean(Taylor::Mended), DVec2::ZERO, 0.0);
        let mut phases: Vec<f32> = (0..=1000).map(|i| i as f32 / 1000.0).collect();
        phases.extend([0.25f32.next_down(), 0.75f32.next_up(), 1.0f32.next_down(), 1e-7]);
        let inputs: Vec<Input> = phases
            .iter()
            .map(|&f| Input { sines, phases: [f, f - 1.0, f + 1.0, f], place: [0.0; 4] })
            .collect();
        let Some(outputs) = run(&inputs) else { return };
        let mut worst = [0.0f64; 2];
        for (input, seen) in inputs.iter().zip(outputs) {
            for (i, phase) in input.phases.into_iter().enumerate() {
                let (sine, cosine) = (TAU * f64::from(phase)).sin_cos();
                let errors = [f64::from(seen.sine[i]) + sine, f64::from(seen.cosine[i]) + cosine];
                worst = [0, 1].map(|k| worst[k].max(errors[k].abs()));
            }
        }
        assert!(worst[0] < 1.6e-4 && worst[1] < 2.6e-5, "{worst:?}");
    }

    #[test]
    fn golden_vertices() {
        let golden = [
            ((0.0, 0.0), 0.0, -106.35375, (12.20028, 1.34523), (0.036576, 0.004033, 0.999323)),
            ((0.3, 0.7), 1.0, -102.12166, (-3.41076, -13.78677), (-0.010223, -0.041323, 0.999094)),
            ((2.5, 1.25), 3.7, -17.81397, (-13.35977, 11.60173), (-0.040023, 0.034756, 0.998594)),
        ];
        let sea = ocean(Taylor::Printed);
        let inputs: Vec<Input> = golden
            .iter()
            .map(|&(uv, time_s, ..)| at(&sea, DVec2::ZERO, time_s, DVec2::from(uv), 0.0))
            .collect();
        let Some(outputs) = run(&inputs) else { return };
        for ((_, _, height, (nx, ny), normal), seen) in golden.into_iter().zip(outputs) {
            // f32 sums of waves 100 units high.
            assert_near(seen.raised, DVec3::new(height, nx, ny), 1e-4);
            assert_near(seen.normal, normal.into(), 1e-5);
        }
    }

    /// As printed, the tangent along v is tilted by the derivative along u; mended, it lies in the surface.
    #[test]
    fn the_mended_tangent_is_at_right_angles_to_the_normal() {
        let sea = ocean(Taylor::Printed);
        let printed = at(&sea, DVec2::ZERO, 1.0, DVec2::new(0.3, 0.7), 0.0);
        let mended = Input { sines: GpuSines { mended_tangent: 1.0, ..printed.sines }, ..printed };
        let Some(outputs) = run(&[printed, mended]) else { return };
        let [printed, mended] = [0, 1].map(|i| outputs[i].tangent.dot(outputs[i].normal));
        assert!(printed.abs() > 0.02 && mended.abs() < 1e-6, "{printed} {mended}");
        assert_eq!([outputs[0].raised, outputs[0].normal], [outputs[1].raised, outputs[1].normal]);
        let ny = sea.at_uv(DVec2::new(0.3, 0.7), 1.0, 0.0).derivatives.y;
        assert_near(outputs[1].tangent, DVec3::new(0.0, 1.0, -0.003 * ny).normalize(), 1e-5);
    }

    /// Anywhere, at any time: a thousand kilometres from the origin, a million seconds before and after.
    #[test]
    fn the_shader_is_the_model() {
        let mut inputs = Vec::new();
        let mut expected = Vec::new();
        for taylor in [Taylor::Printed, Taylor::Mended] {
            let sea = ocean(taylor);
            for (origin, time_s) in [
                (DVec2::ZERO, 3.7),
                (DVec2::new(47_746.3, -95_492.7), -1e6),
                (DVec2::new(-0.31, 1e6 / 20.94395), 1e6),
            ] {
                for (i, damp) in (0..40).zip([0.0, 0.3, 1.0].into_iter().cycle()) {
                    let from_origin = DVec2::new(f64::from(i) * 0.237 - 4.0, 3.0 - f64::from(i) * 0.171);
                    let from_origin = from_origin.as_vec2().as_dvec2();
                    inputs.push(at(&sea, origin, time_s, from_origin, damp));
                    expected.push(sea.at_uv(origin + from_origin, time_s, damp));
                }
            }
        }
        let Some(outputs) = run(&inputs) else { return };
        for (seen, model) in outputs.iter().zip(expected) {
            assert_near(
                seen.raised,
                DVec3::new(model.height, model.derivatives.x, model.derivatives.y),
                1e-3,
            );
            assert_near(seen.normal, model.normal, 1e-5);
            assert_near(seen.tangent, model.tangent, 1e-5);
            assert_near(seen.binormal, model.binormal, 1e-5);
        }
    }
}
