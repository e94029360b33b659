//! What a frame of animated noise costs: both chunks, on one thread, for the sizes of the thesis and of its demo.

use criterion::{BenchmarkId, Criterion};
use std::hint::black_box;
use whitecap_waves::model::perlin::{Chunks, PerlinNoise, PerlinNoiseParameters};

/// n = 16 as in the demo, 32 as in the thesis.
const OCTAVE_SIZES: [usize; 2] = [16, 32];

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    for octave_size in OCTAVE_SIZES {
        let parameters = PerlinNoiseParameters { octave_size, ..Default::default() };
        let noise = PerlinNoise::new(parameters).expect("good parameters");
        let mut chunks = Chunks::new();
        let mut time_s = 0.0;
        criterion.benchmark_group("chunks").bench_function(
            BenchmarkId::from_parameter(octave_size),
            |bencher| {
                bencher.iter(|| {
                    time_s += 1.0 / 60.0;
                    noise.evaluate(black_box(time_s), &mut chunks);
                    black_box(&chunks);
                });
            },
        );
    }
    criterion.final_summary();
}
