//! A sea of four tiles of 256²: its making, a snapshot of it, and a million questions.
//!
//! `setup` draws the waves from a wind sea by Phillips. `setup-default` makes the spectra too, a wind sea and a swell as
//! in the default scene, and `setup-dearest` those that cost the most: Donelan and Banner's spread narrowed to swell,
//! which is normalised by number. `snapshot` brings the answers to a new moment. `query` asks for the water
//! over 100,000 places at one moment, `snapshot` not counted. All on two threads.

use criterion::{Criterion, Throughput};
use glam::DVec2;
use std::hint::black_box;
use whitecap_waves::direction::toward_from_nautical;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::model::spectral::{
    Amplitudes, Cascade, CascadeBudget, SpectralSea, SpectralSeaParameters, Water,
};
use whitecap_waves::query::Snapshot;
use whitecap_waves::spectrum::WaveSpectrum;
use whitecap_waves::spectrum::directional::{Directional, DirectionalParameters};
use whitecap_waves::spectrum::jonswap::Jonswap;
use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};
use whitecap_waves::spreading::{Spread, Spreading};

const PLACES: u32 = 100_000;

fn sea<S: WaveSpectrum>(systems: &[S]) -> SpectralSea {
    let budget = CascadeBudget { tile_size_m: None, shortest_wave_m: 0.02, cascades: 4, resolution: 256 };
    let parameters = SpectralSeaParameters {
        cascades: Cascade::plan(systems, budget),
        choppiness: 1.0,
        water: Water::STILL,
        seed: 7,
        amplitudes: Amplitudes::Deterministic,
    };
    SpectralSea::new(parameters, systems).expect("a sea that fits")
}

fn jonswap(height_m: f64, period_s: f64, spreading: Spreading, swell: f64) -> Directional<Jonswap> {
    let parameters = DirectionalParameters {
        spread: Spread { spreading, swell },
        toward: toward_from_nautical(250.0),
        dispersion: Dispersion::DEEP,
    };
    let jonswap = Jonswap::from_height_and_period(height_m, period_s, 3.3).expect("a good spectrum");
    Directional::new(jonswap, parameters).expect("a good spread")
}

fn bench(criterion: &mut Criterion) {
    let spectrum = Phillips::new(PhillipsParameters {
        wind_speed_mps: 10.0,
        toward: toward_from_nautical(250.0),
        significant_height_m: None,
        opposing_energy: 0.0,
        small_wave_cutoff_m: 0.0,
    })
    .expect("a good spectrum");
    let mut group = criterion.benchmark_group("four-tiles");
    group.sample_size(30);
    group.bench_function("setup", |bencher| bencher.iter(|| black_box(sea(&[spectrum]))));
    group.bench_function("setup-default", |bencher| {
        bencher.iter(|| {
            let wind_sea = jonswap(black_box(2.0), 7.0, Spreading::Hasselmann, 0.0);
            let swell = jonswap(1.2, 12.0, Spreading::Cos2s { exponent: 25.0 }, 0.0);
            black_box(sea(&[wind_sea, swell]))
        });
    });
    group.bench_function("setup-dearest", |bencher| {
        bencher.iter(|| black_box(sea(&[jonswap(black_box(2.0), 8.0, Spreading::DonelanBanner, 0.5)])));
    });

    let sea = sea(&[spectrum]);
    assert_eq!(sea.tiles().len(), 4);
    let mut snapshot = Snapshot::new(&sea);
    let mut time_s = 0.0;
    group.bench_function("snapshot", |bencher| {
        bencher.iter(|| {
            time_s += 1.0 / 60.0;
            snapshot.take(&sea, black_box(time_s)).expect("a time");
        });
    });
    // All over a square kilometre, in no order.
    let place = |i: u32| {
        1000.0 * DVec2::new((0.754_877_666 * f64::from(i)).fract(), (0.569_840_291 * f64::from(i)).fract())
    };
    let places: Vec<DVec2> = (0..PLACES).map(place).collect();
    group.throughput(Throughput::Elements(PLACES.into()));
    group.bench_function("query", |bencher| {
        bencher.iter(|| black_box(snapshot.query(black_box(&places)).expect("places")));
    });
}

fn main() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("two threads");
    pool.install(|| {
        let mut criterion = Criterion::default().configure_from_args();
        bench(&mut criterion);
        criterion.final_summary();
    });
}
