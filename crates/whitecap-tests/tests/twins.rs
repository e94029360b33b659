//! Every shader function that has a Rust twin, run on the GPU over the same inputs.
#![allow(clippy::unwrap_used)] // a test that cannot go on should stop

use glam::{DVec2, DVec3, Vec2, Vec3};
use whitecap_render::environment::{display_from_linear, exposed, linear_from_display};
use whitecap_render::gpu::for_tests::compute;
use whitecap_render::shader_lib::{self, GpuPatchwork};
use whitecap_render::technique::meshuggah::normals::{bump_frame, world_from_bump};
use whitecap_tests::adapter::gpu;
use whitecap_waves::model::spectral::{
    Amplitudes, Cascade, Patch, SpectralSea, SpectralSeaParameters, Water as Moved,
};
use whitecap_waves::optics::{
    WATER_REFRACTIVE_INDEX, curvature_drop_m, exposure_split, foam_cover, foam_drawn, foam_radiance,
    foam_rank, fresnel_exact, fresnel_jensen_golias, tone_map_aces, tone_map_agx, tone_map_pbr_neutral,
    visible_cosine,
};

/// Runs `twins.wesl` on inputs of two vectors and gives back five for each.
fn run(inputs: &[[[f32; 4]; 2]]) -> Option<Vec<[[f32; 4]; 5]>> {
    let gpu = gpu()?;
    Some(compute(gpu, &shader_lib::TWINS, "cs_run", inputs))
}

fn assert_near(seen: f32, expected: f64, what: &str) {
    let error = (f64::from(seen) - expected).abs();
    assert!(error <= 1e-5 * expected.abs().max(1.0), "{what}: {seen} instead of {expected}");
}

#[test]
fn the_gpus_functions_equal_the_cpus() {
    let inputs: Vec<[[f32; 4]; 2]> = (0..500)
        .map(|i| {
            let t = i as f32 / 499.0;
            let x = -0.5 + 5.0 * t;
            [[x, 0.2 * t * t, 40_000.0 * t, 6.371e6], [1.5 * (9.0 * t).sin(), 2.0 * t - 0.7, 0.0, 0.0]]
        })
        .collect();
    let Some(outputs) = run(&inputs) else { return };
    for ([a, b], [light, surface, normal, water, foam]) in inputs.iter().zip(&outputs) {
        let [x, variance, distance, radius] = a.map(f64::from);
        assert_near(light[0], fresnel_jensen_golias(x), "fresnel_jensen_golias");
        let (integer, fraction) = exposure_split(x);
        // The two parts jump together where the value passes an integer; their sum does not.
        if (x - x.round()).abs() > 1e-5 {
            assert_near(light[1], integer, "exposure_split, integer part");
            assert_near(light[2], fraction, "exposure_split, fraction");
        }
        assert_near(light[3], x.clamp(0.0, 4.0), "exposure_join");
        assert_near(surface[0], visible_cosine(x, variance), "visible_cosine");
        assert_near(surface[1], curvature_drop_m(distance, radius), "curvature_drop_m");
        assert_near(surface[2], linear_from_display(a[0]).into(), "linear_from_display");
        assert_near(surface[3], exposed(a[0]).into(), "exposed");
        assert_near(normal[3], display_from_linear(a[0]).into(), "display_from_linear");
        assert_near(water[0], fresnel_exact(x, WATER_REFRACTIVE_INDEX), "fresnel_exact, into water");
        // From below it rises without bound to total reflection at the critical angle, a cosine of 0.661.
        if (x - 0.661).abs() > 0.01 {
            assert_near(
                water[1],
                fresnel_exact(x, 1.0 / WATER_REFRACTIVE_INDEX),
                "fresnel_exact, out of water",
            );
        }
        let share = f64::from(b[0].abs()) / 1.5;
        assert_near(foam[0], foam_cover(x - 3.0, 50.0 * variance), "foam_cover");
        assert_near(foam[1], foam_rank(share, variance), "foam_rank");
        assert_near(foam[2], foam_drawn(share, variance, f64::from(b[1].abs())), "foam_drawn");
        let lit = foam_radiance(
            DVec3::Y,
            DVec3::new(0.0, b[0].into(), 0.0),
            DVec3::splat(2.0),
            DVec3::splat(variance),
        );
        assert_near(foam[3], lit.x, "foam_radiance");
        let bump = Vec3::new(a[0], a[1], a[2]);
        let expected = world_from_bump(bump_frame(Vec2::new(b[0], b[1])), bump);
        let seen = Vec3::new(normal[0], normal[1], normal[2]);
        assert!((seen - expected).abs().max_element() < 1e-6 * bump.length().max(1.0), "{seen} {expected}");
    }
}

#[test]
fn tone_maps_on_the_gpu_equal_the_cpus() {
    let Some(gpu) = gpu() else { return };
    let inputs: Vec<[f32; 4]> = (0..4096)
        .map(|i| {
            let light = |step: u32| 1e-4 * 1.25_f32.powi((i * step % 67) as i32);
            [light(1), light(5), light(11), 0.0]
        })
        .collect();
    let outputs: Vec<[[f32; 4]; 4]> = compute(gpu, &shader_lib::TONE_MAP_TWINS, "cs_run", &inputs);
    let [mut sum, mut squares] = [0.0; 2];
    for ([red, green, blue, _], [agx, aces, pbr_neutral, noise]) in inputs.iter().zip(&outputs) {
        let light = Vec3::new(*red, *green, *blue).as_dvec3();
        let expected = [
            ("agx", agx, tone_map_agx(light)),
            ("aces", aces, tone_map_aces(light)),
            ("pbr-neutral", pbr_neutral, tone_map_pbr_neutral(light)),
        ];
        for (name, seen, expected) in expected {
            for i in 0..3 {
                let error = (f64::from(seen[i]) - expected[i]).abs();
                assert!(error < 2e-5, "{name} of {light}: {seen:?} instead of {expected}");
            }
        }
        for value in &noise[..3] {
            assert!(value.abs() <= 1.0);
            sum += f64::from(*value);
            squares += f64::from(value * value);
        }
    }
    // The difference of two even numbers in [0, 1) has mean 0 and variance 1/6.
    let count = 3.0 * inputs.len() as f64;
    assert!((sum / count).abs() < 0.015, "{}", sum / count);
    assert!((squares / count - 1.0 / 6.0).abs() < 0.01, "{}", squares / count);
}

/// The reference values of the techniques' texts, as the shader computes them.
#[test]
fn golden_numbers_on_the_gpu() {
    let cos80 = 80.0_f64.to_radians().cos();
    let fresnel = [(1.0, 0.003_906), (0.5, 0.039_02), (cos80, 0.277_78), (0.0, 1.0), (-0.3, 1.0)];
    // Exposure 4 times Fresnel: cosine, integer part over 4, fraction.
    let split =
        [(4.0, 1.0, 0.0), (1.866_03, 0.25, 0.866_03), (0.671_09, 0.0, 0.671_09), (0.015_62, 0.0, 0.015_62)];
    let inputs: Vec<[[f32; 4]; 2]> = fresnel
        .iter()
        .map(|f| f.0)
        .chain(split.iter().map(|s| s.0))
        .map(|x| [[x as f32, 0.0, 0.0, 1.0], [0.0; 4]])
        .collect();
    let Some(outputs) = run(&inputs) else { return };
    for ((_, expected), output) in fresnel.iter().zip(&outputs) {
        assert_near(output[0][0], *expected, "Fresnel");
    }
    for ((_, integer, fraction), output) in split.iter().zip(&outputs[fresnel.len()..]) {
        assert_near(output[0][1], *integer, "integer part");
        assert_near(output[0][2], *fraction, "fraction");
    }
}

/// Near the origin, and a thousand kilometres from it.
#[test]
fn patches_on_the_gpu_are_the_cpus() {
    let Some(gpu) = gpu() else { return };
    let flat: [&dyn whitecap_waves::spectrum::WaveSpectrum; 0] = [];
    let parameters = SpectralSeaParameters {
        cascades: Cascade::split(&[(1510.0, 16), (39.7, 16)]),
        choppiness: 1.0,
        water: Moved::STILL,
        seed: 0x1234_5678_9abc,
        amplitudes: Amplitudes::Deterministic,
    };
    let sea = SpectralSea::new(parameters, &flat).unwrap();
    assert_eq!(sea.patchwork(0), None);
    let sea = sea.sewn(2);
    for (tile, eye_m) in [(0, DVec2::ZERO), (0, DVec2::new(-1e6, 3e5)), (1, DVec2::new(-77.0, 1e6))] {
        let patchwork = sea.patchwork(tile).unwrap();
        let uniform: [u32; 12] = bytemuck::cast(GpuPatchwork::new(Some(patchwork), eye_m));
        let rests: Vec<DVec2> = (0..4000)
            .map(|i| {
                let i = f64::from(i);
                let within = DVec2::new((0.754_877_666 * i).fract() - 0.5, (0.569_840_291 * i).fract() - 0.5);
                (4e3 * within).as_vec2().as_dvec2()
            })
            .collect();
        let input = |rest: &DVec2| {
            let mut words = [0; 16];
            words[..12].copy_from_slice(&uniform);
            words[12..14].copy_from_slice(&rest.as_vec2().to_array().map(f32::to_bits));
            words
        };
        let inputs: Vec<[u32; 16]> = rests.iter().map(input).collect();
        let outputs: Vec<[[f32; 4]; 3]> = compute(gpu, &shader_lib::PATCHWORK_TWINS, "cs_patches", &inputs);
        for (rest, [shifts, third, weights]) in rests.iter().zip(&outputs) {
            let seen = [[shifts[0], shifts[1]], [shifts[2], shifts[3]], [third[0], third[1]]];
            for Patch { shift, weight, .. } in patchwork.patches_at(eye_m + *rest) {
                // Where rounding takes a place over an edge, the corner that changes counts for nothing.
                if weight < 1e-6 {
                    continue;
                }
                let of_copy = |(seen, seen_weight): (&[f32; 2], &f32)| {
                    let apart = DVec2::new(seen[0].into(), seen[1].into()) - shift;
                    apart.length() < 1e-6 && (f64::from(*seen_weight) - weight).abs() < 2e-4
                };
                assert!(
                    seen.iter().zip(weights).any(of_copy),
                    "tile {tile} at {eye_m} + {rest}: {seen:?} {weights:?}, not {shift} {weight}"
                );
            }
        }
    }
    let as_it_is: [u32; 12] = bytemuck::cast(GpuPatchwork::new(None, DVec2::ONE));
    assert_eq!(as_it_is, [0; 12]);
}
