//! Laws of the noise sea.

use super::*;
use glam::DVec3;

fn noise(parameters: PerlinNoiseParameters) -> PerlinNoise {
    PerlinNoise::new(parameters).unwrap()
}

fn small() -> PerlinNoise {
    noise(PerlinNoiseParameters { octave_size: 8, seed: 3, ..Default::default() })
}

#[test]
fn golden_octave_weights() {
    let golden = [0.40038, 0.24303, 0.14752, 0.08954, 0.05435, 0.03299, 0.02003, 0.01216];
    for (seen, expected) in octave_weights(0.607).iter().zip(golden) {
        assert!((seen - expected).abs() < 5.1e-6, "{seen} for {expected}");
    }
    assert!((octave_weights(1.7).iter().sum::<f64>() - 1.0).abs() < 1e-14);
}

/// Chunks by whole rows and texels one by one are the same whole numbers, so heights differ by rounding alone.
#[test]
fn a_sample_is_what_the_chunks_hold() {
    let sea = noise(PerlinNoiseParameters { octave_size: 16, seed: 11, ..Default::default() });
    let mut chunks = Chunks::new();
    for time_s in [0.0, 12.34, -7.7, 1e6] {
        sea.evaluate(time_s, &mut chunks);
        assert_eq!(chunks.side(), 128);
        let mixes: [Mix; OCTAVES] = std::array::from_fn(|o| sea.mix(o, time_s));
        for chunk in 0..2 {
            for i in (0..128 * 128).step_by(37) {
                let (u, v) = (i % 128, i / 128);
                let direct = chunks::packed_texel(&sea.frames, &mixes[4 * chunk..][..4], u, v);
                assert_eq!(chunks.texel(chunk, u, v), direct, "chunk {chunk} ({u}, {v})");
            }
        }
        for i in 0..500 {
            let rest = DVec2::new(2.71 * f64::from(i), -1.37 * f64::from(i));
            let seen = sea.sample(rest, time_s).displacement_m;
            assert_eq!(seen, DVec3::new(0.0, sea.height_m(&chunks, rest), 0.0));
        }
    }
}

/// Between octaves the packing is what it says: at a texel that all octaves share, their plain sum.
#[test]
fn shared_texels_are_the_sum_of_the_octaves() {
    let sea = small();
    let mut chunks = Chunks::new();
    sea.evaluate(4.2, &mut chunks);
    for (u, v) in [(0, 0), (8, 16), (56, 40)] {
        for chunk in 0..2 {
            let octave = |i: usize, power: usize| {
                let at = (v >> power) % 8 * 8 + (u >> power) % 8;
                sea.frames.mixed(&sea.mix(4 * chunk + i, 4.2), at)
            };
            let sum = octave(0, 3) + octave(1, 2) + octave(2, 1) + octave(3, 0);
            assert_eq!(chunks.texel(chunk, u, v), sum);
        }
    }
}

#[test]
fn it_repeats_in_space_and_where_all_octaves_run_alike_in_time() {
    let sea = small();
    let period = sea.period_m();
    assert!((period - 64.0 / 0.38).abs() < 1e-9);
    let rest = DVec2::new(12.3, 45.6);
    let here = sea.sample(rest, 9.0).displacement_m.y;
    let there = sea.sample(rest + DVec2::new(period, -3.0 * period), 9.0).displacement_m.y;
    assert!((here - there).abs() < 1e-9);
    assert!((here - sea.sample(rest + 0.5 * period, 9.0).displacement_m.y).abs() > 1e-4);

    let even =
        noise(PerlinNoiseParameters { time_multiplier: 1.0, animation_speed: 2.0, ..*sea.parameters() });
    let now = even.sample(rest, 3.25).displacement_m.y;
    assert_eq!(now, even.sample(rest, 3.25 + 128.0).displacement_m.y);
    assert_eq!(now, even.sample(rest, 3.25 - 128.0 * 5000.0).displacement_m.y);
    assert_ne!(now, even.sample(rest, 3.25 + 64.0).displacement_m.y);
}

/// From one frame to the next, and over the last frame's end, nothing jumps.
#[test]
fn time_is_continuous() {
    let sea = small();
    let height = |time_s: f64| sea.sample(DVec2::new(3.3, 8.1), time_s).displacement_m.y;
    // 16 whole numbers: what rounding may do to eight octaves.
    let grain = 16.0 * sea.parameters().strength_m / ONE;
    for frame in [0.0, 1.0, 17.0, 256.0, 512.0] {
        let at = frame / 1.4;
        assert!((height(at - 1e-7) - height(at + 1e-7)).abs() <= grain);
    }
    assert!((height(0.0) - height(1.0)).abs() > grain);
}

#[test]
fn the_same_seed_is_the_same_sea() {
    let rest = DVec2::new(5.0, -6.0);
    let make = |seed| noise(PerlinNoiseParameters { octave_size: 8, seed, ..Default::default() });
    assert_eq!(make(3).sample(rest, 7.5), make(3).sample(rest, 7.5));
    assert_ne!(make(3).sample(rest, 7.5), make(4).sample(rest, 7.5));
}

/// Against differences of the height inside a texel of the finer chunk.
#[test]
fn slopes_are_derivatives_of_the_patch() {
    let sea = small();
    for i in 0..50 {
        let texel = DVec2::new(f64::from(i) + 0.4, 3.0 * f64::from(i) + 0.3) / (16.0 * 0.38);
        let (step, time_s) = (1e-4, 2.0 + f64::from(i));
        let at = |x: f64, z: f64| sea.sample(texel + DVec2::new(x, z), time_s).displacement_m.y;
        let slope = DVec2::new(at(step, 0.0) - at(-step, 0.0), at(0.0, step) - at(0.0, -step)) / (2.0 * step);
        let point = sea.sample(texel, time_s);
        assert!(slope.distance(point.slope) < 1e-8, "{slope} {}", point.slope);
        assert!(point.normal.distance(DVec3::new(-slope.x, 1.0, -slope.y).normalize()) < 1e-8);
    }
}

/// 1,000 km out and after 1e6 s the same texels are found, by whole periods.
#[test]
fn it_keeps_its_digits_far_out_and_late() {
    let sea = noise(PerlinNoiseParameters {
        octave_size: 8,
        scale_per_m: 0.5,
        animation_speed: 1.0,
        time_multiplier: 1.0,
        ..Default::default()
    });
    // The period is 128 m in space and 256 s in time.
    let rest = DVec2::new(0.37, 0.11);
    let near = sea.sample(rest, 1.5);
    let far = sea.sample(rest + 128.0 * DVec2::new(8000.0, -8000.0), 1.5 + 256.0 * 3900.0);
    assert!((near.displacement_m.y - far.displacement_m.y).abs() < 1e-8);
    assert!(near.slope.distance(far.slope) < 1e-7);
}

#[test]
fn variance_and_bound_are_those_of_the_heights() {
    let sea = noise(PerlinNoiseParameters { octave_size: 16, ..Default::default() });
    let (mut sum, mut square, mut highest, count) = (0.0, 0.0, 0.0_f64, 40_000);
    for i in 0..count {
        let t = f64::from(i);
        let rest = DVec2::new(1.618_034 * 29.0 * t, 1.324_718 * 37.0 * t);
        let height = sea.sample(rest, 0.754_878 * 3.0 * t).displacement_m.y;
        sum += height;
        square += height * height;
        highest = highest.max(height.abs());
    }
    let mean = sum / f64::from(count);
    let variance = square / f64::from(count) - mean * mean;
    assert!((variance / sea.variance_m2() - 1.0).abs() < 0.04, "{variance} {}", sea.variance_m2());
    assert!(highest <= sea.max_height_m() && sea.max_height_m() <= 0.9 * 1.001);
    assert!(highest > 0.2 * sea.max_height_m());
}

/// One texel at its extreme in all three frames and octaves is just within the bound.
#[test]
fn the_bound_holds_for_the_worst_mix() {
    for largest in [32_768, -32_768] {
        for weight in octave_weights(0.607) {
            for f in [0.0, 0.3, 0.9] {
                let amounts = frame_weights(f).map(|w| (ONE * weight * w) as i32);
                let worst = frames::mixed([largest; 3], amounts);
                assert!(f64::from(worst.abs()) <= 0.5 * weight * 32_768.0 + 1.0);
            }
        }
    }
}

#[test]
fn texels_fit_sixteen_bits() {
    let sea = small();
    let mut chunks = Chunks::new();
    sea.evaluate(1.0, &mut chunks);
    for (encoded, &texel) in chunks.encode_unorm16(0).zip(chunks.texels(0)) {
        assert_eq!(i32::from(encoded), 32_768 + texel);
    }
    let before = chunks.texels(1).as_ptr();
    sea.evaluate(2.0, &mut chunks);
    assert_eq!(chunks.texels(1).as_ptr(), before);
}

#[test]
fn what_is_out_of_range_is_named() {
    let base = PerlinNoiseParameters::default();
    for (parameters, name) in [
        (PerlinNoiseParameters { octave_size: 24, ..base }, "octave_size is 24"),
        (PerlinNoiseParameters { octave_size: 128, ..base }, "octave_size is 128"),
        (PerlinNoiseParameters { scale_per_m: 0.0, ..base }, "scale_per_m is 0"),
        (PerlinNoiseParameters { falloff: f64::NAN, ..base }, "falloff"),
        (PerlinNoiseParameters { strength_m: -1.0, ..base }, "strength_m is -1"),
        (PerlinNoiseParameters { time_multiplier: 9.0, ..base }, "time_multiplier is 9"),
    ] {
        let error = PerlinNoise::new(parameters).err().unwrap().to_string();
        assert!(error.starts_with(name), "{error}");
    }
}
