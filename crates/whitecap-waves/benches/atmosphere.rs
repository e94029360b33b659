//! What a scene's sky costs before its first frame: the tables of the air, and the sky from sea level by day and in dusk, when
//! the edge of the Earth's shadow divides every ray anew. Together, with the passes of a first view (some 12 ms on two cores
//! and a software adapter), they are to take 150 ms on two cores; of one core's time they take 150 by day and 190 in dusk.

use criterion::Criterion;
use glam::DVec3;
use std::hint::black_box;
use whitecap_waves::optics::atmosphere::{Atmosphere, LOWEST_EYE_M, Sky};

fn main() {
    let mut criterion = Criterion::default().configure_from_args().sample_size(20);
    let mut group = criterion.benchmark_group("atmosphere");
    group.bench_function("air", |bencher| bencher.iter(|| Atmosphere::new(black_box(1.0))));
    let air = Atmosphere::new(1.0);
    for (name, elevation_deg) in [("day", 20.0_f64), ("dusk", -6.0)] {
        let (sin, cos) = elevation_deg.to_radians().sin_cos();
        let sun = DVec3::new(cos, sin, 0.0);
        group.bench_function(name, |bencher| bencher.iter(|| Sky::new(&air, LOWEST_EYE_M, black_box(sun))));
    }
    group.finish();
    criterion.final_summary();
}
