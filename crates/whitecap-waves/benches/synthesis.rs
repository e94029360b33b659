//! A whole sea against the bare transforms it cannot do without.
//!
//! `sea/N` evolves the waves and makes all eight fields of a tile of N² samples, on one thread. `realfft/N` makes eight
//! fields from eight spectra that are there already, with realfft along rows and rustfft along columns: the
//! yardstick. `bare/N` does the same with our own transform. The ratios are what the sea costs beyond its transforms.
//! `sea-two-threads/N` is the sea on two.

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion};
use realfft::{ComplexToReal, RealFftPlanner};
use rustfft::{Fft, FftPlanner};
use std::hint::black_box;
use std::sync::Arc;
use whitecap_waves::direction::toward_from_nautical;
use whitecap_waves::model::spectral::{Amplitudes, Band, SpectralTile, SpectralTileParameters, Water};
use whitecap_waves::model::{TileFields, WaveModel};
use whitecap_waves::spectrum::phillips::{Phillips, PhillipsParameters};
use whitecap_waves::transform::{Complex, InverseReal2d};

const SIZES: [usize; 5] = [64, 256, 512, 1024, 2048];
const FIELDS: usize = 8;

fn sea(resolution: usize) -> SpectralTile {
    let wind_sea = Phillips::new(PhillipsParameters {
        wind_speed_mps: 10.0,
        toward: toward_from_nautical(250.0),
        significant_height_m: None,
        opposing_energy: 0.0,
        small_wave_cutoff_m: 0.0,
    });
    let parameters = SpectralTileParameters {
        tile_size_m: 400.0,
        resolution,
        band: Band::WHOLE,
        choppiness: 1.0,
        water: Water::STILL,
        seed: 7,
        amplitudes: Amplitudes::Deterministic,
    };
    SpectralTile::new(parameters, &[wind_sea.expect("a good spectrum")]).expect("a sea that fits its tile")
}

/// A Hermitian spectrum with energy everywhere, as the transform takes it.
fn spectrum(n: usize) -> Vec<Complex<f32>> {
    let wave = |i: usize| Complex::new((i as f32).sin(), (1.7 * i as f32).cos()) / n as f32;
    let mut half: Vec<_> = (0..n * n / 2).map(wave).collect();
    (half[0].im, half[n / 2].im) = (0.0, 0.0);
    for q in 1..n / 2 {
        half[n - q] = half[q].conj();
    }
    half
}

/// A two-dimensional complex-to-real inverse transform as one would write it with realfft: complex transforms
/// down the columns, a turn to rows by blocks, real transforms along the rows.
struct Yardstick {
    n: usize,
    down: Arc<dyn Fft<f32>>,
    along: Arc<dyn ComplexToReal<f32>>,
    columns: Vec<Complex<f32>>,
    rows: Vec<Complex<f32>>,
    scratch: Vec<Complex<f32>>,
}

impl Yardstick {
    fn new(n: usize) -> Yardstick {
        let down = FftPlanner::new().plan_fft_inverse(n);
        let along = RealFftPlanner::new().plan_fft_inverse(n);
        let scratch = down.get_inplace_scratch_len().max(along.get_scratch_len());
        let zeros = |len| vec![Complex::default(); len];
        let (columns, rows, scratch) = (zeros(n * n / 2), zeros(n * (n / 2 + 1)), zeros(scratch));
        Yardstick { n, down, along, columns, rows, scratch }
    }

    /// `half` holds columns as [`InverseReal2d`] takes them.
    fn process(&mut self, half: &[Complex<f32>], out: &mut [f32]) {
        const BLOCK: usize = 16;
        let (n, width) = (self.n, self.n / 2 + 1);
        self.columns.copy_from_slice(half);
        self.down.process_with_scratch(&mut self.columns, &mut self.scratch);
        for (z0, x0) in (0..n).step_by(BLOCK).flat_map(|z| (0..n / 2).step_by(BLOCK).map(move |x| (z, x))) {
            for z in z0..z0 + BLOCK {
                for x in x0..x0 + BLOCK {
                    self.rows[z * width + x] = self.columns[x * n + z];
                }
            }
        }
        for (row, out) in self.rows.chunks_exact_mut(width).zip(out.chunks_exact_mut(n)) {
            // The constant and the Nyquist term of a real row are real.
            (row[0].im, row[n / 2]) = (0.0, Complex::default());
            self.along.process_with_scratch(row, out, &mut self.scratch).expect("lengths agree");
        }
    }
}

/// A few runs of a large tile tell as much as many of a small one.
fn group<'a>(criterion: &'a mut Criterion, name: &str, n: usize) -> BenchmarkGroup<'a, WallTime> {
    let mut group = criterion.benchmark_group(name);
    group.sample_size(if n >= 1024 { 15 } else { 60 });
    group
}

fn evaluate(criterion: &mut Criterion, name: &str, n: usize) {
    let mut sea = sea(n);
    let mut fields = TileFields::new(n);
    let mut time_s = 0.0;
    group(criterion, name, n).bench_function(BenchmarkId::from_parameter(n), |bencher| {
        bencher.iter(|| {
            time_s += 1.0 / 60.0;
            sea.evaluate(black_box(time_s), &mut fields);
            black_box(&fields);
        });
    });
}

/// What one core does: the sea and the bare transforms.
fn alone(criterion: &mut Criterion, n: usize) {
    evaluate(criterion, "sea", n);
    let mut yardstick = Yardstick::new(n);
    let mut transform = InverseReal2d::new(n).expect("a good size");
    let spectra: Vec<_> = (0..FIELDS).map(|_| spectrum(n)).collect();
    let mut outs = vec![vec![0.0; n * n]; FIELDS];
    group(criterion, "realfft", n).bench_function(BenchmarkId::from_parameter(n), |bencher| {
        bencher.iter(|| {
            for (half, out) in spectra.iter().zip(&mut outs) {
                yardstick.process(black_box(half), out);
            }
            black_box(&outs);
        });
    });
    group(criterion, "bare", n).bench_function(BenchmarkId::from_parameter(n), |bencher| {
        bencher.iter(|| {
            for (half, out) in spectra.iter().zip(&mut outs) {
                transform.process(black_box(half), out);
            }
            black_box(&outs);
        });
    });
}

/// For each size first what one thread does, then what two do.
fn main() {
    let pool =
        |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("as many threads");
    let (one, two) = (pool(1), pool(2));
    for n in SIZES {
        one.install(|| alone(&mut Criterion::default().configure_from_args(), n));
        two.install(|| evaluate(&mut Criterion::default().configure_from_args(), "sea-two-threads", n));
    }
    Criterion::default().configure_from_args().final_summary();
}
