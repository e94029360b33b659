//! What only the inside can see: the amplitudes themselves.

use super::super::lattice::signed;
use super::*;
use crate::spectrum::phillips::{Phillips, PhillipsParameters};
use crate::spline::{self, Taps};
use crate::statistics::Moments;
use glam::Vec4;

const TILE: SpectralTileParameters = SpectralTileParameters {
    tile_size_m: 250.0,
    resolution: 32,
    band: Band::WHOLE,
    choppiness: 1.3,
    water: Water::STILL,
    seed: 42,
    amplitudes: Amplitudes::Gaussian,
};

fn sea(parameters: SpectralTileParameters) -> SpectralTile {
    let wind = Phillips::new(PhillipsParameters {
        wind_speed_mps: 9.0,
        toward: DVec2::from_angle(0.7),
        significant_height_m: Some(2.0),
        opposing_energy: 0.2,
        small_wave_cutoff_m: 0.0,
    });
    SpectralTile::new(parameters, &[wind.unwrap()]).unwrap()
}

/// Σ weight(|k|) |h(k, t)|² over the whole lattice, from the evolved amplitudes.
fn spectral_sum(sea: &SpectralTile, weight: impl Fn(f64) -> f64) -> f64 {
    let n = sea.parameters.resolution;
    let spacing = std::f64::consts::TAU / sea.parameters.tile_size_m;
    let mut sum = 0.0;
    for (p, run) in sea.evolved.chunks_exact(Column::len(n)).enumerate() {
        for q in 0..n {
            let k = spacing * f64::from(signed(n, q)).hypot(p as f64);
            let energy = f64::from(run[q]).powi(2) + f64::from(run[n + q]).powi(2);
            sum += if p == 0 { 1.0 } else { 2.0 } * weight(k) * energy;
        }
    }
    sum
}

/// Parseval's theorem for the height, the slopes and the displacement: Σ|h|², Σk²|h|², λ²Σ|h|².
#[test]
fn variances_are_sums_over_the_spectrum() {
    for time_s in [0.0, 17.0] {
        let mut sea = sea(TILE);
        let mut fields = TileFields::default();
        sea.evaluate(time_s, &mut fields);
        let variance = |field: &[f32]| Moments::of(field).variance;
        let energy = spectral_sum(&sea, |_| 1.0);
        assert!((variance(&fields.height) / energy - 1.0).abs() < 1e-5);
        let slopes = variance(&fields.slope_x) + variance(&fields.slope_z);
        assert!((slopes / spectral_sum(&sea, |k| k * k) - 1.0).abs() < 1e-5);
        let shifts = variance(&fields.displacement_x) + variance(&fields.displacement_z);
        assert!((shifts / (1.3 * 1.3 * energy) - 1.0).abs() < 1e-5);
    }
}

/// The spline through a tile's coefficients is the surface between its samples: for waves of four samples and more to
/// 0.06 % of the significant height, root mean square. Slopes and gradients stay what they are.
#[test]
fn coefficients_draw_the_surface_between_samples() {
    let four_samples = Band { from: 0.0, to: 0.25 * TAU * 64.0 / TILE.tile_size_m };
    let mut sea = sea(SpectralTileParameters { resolution: 64, band: four_samples, ..TILE });
    let (mut samples, mut found) = (TileFields::default(), TileFields::default());
    sea.evaluate(5.5, &mut samples);
    sea.evaluate_coefficients(5.5, &mut found);
    assert_eq!(samples.slope_x, found.slope_x);
    assert_eq!(samples.gradient_xz, found.gradient_xz);
    let coefficients: Vec<Vec4> = (0..64 * 64)
        .map(|i| {
            let [x, y, z] = found.displacement(i);
            Vec4::new(x, y, z, 0.0)
        })
        .collect();
    let mut square = 0.0;
    for i in 0..200 {
        let place = DVec2::new(f64::from(i) * 0.317, (f64::from(i) * 7.93) % 64.0);
        let cubic = |samples| Taps::<{ spline::CUBIC }>::at(samples, 64);
        let drawn = spline::value(&coefficients, &cubic(place.x), &cubic(place.y));
        let point = sea.sample(place * TILE.tile_size_m / 64.0, 5.5);
        square += (drawn.truncate().as_dvec3() - point.displacement_m).length_squared() / 200.0;
    }
    let error = f64::sqrt(square) / crate::statistics::significant_height_m(sea.variance_m2());
    assert!(error < 6e-4, "{error}");
}

/// Seen from above, choppy crests take less room than troughs, so the mean over the place (not over the
/// rest place) is lower: E[h (gxx + gzz)] = −λ Σ k |h|².
#[test]
fn choppiness_sets_the_mean_down() {
    let mut sea = sea(TILE);
    let mut fields = TileFields::default();
    sea.evaluate(3.0, &mut fields);
    let n2 = fields.height.len();
    let divergence = |i: usize| f64::from(fields.gradient_xx[i] + fields.gradient_zz[i]);
    let mean = (0..n2).map(|i| f64::from(fields.height[i]) * divergence(i)).sum::<f64>() / n2 as f64;
    assert!((mean / (-1.3 * spectral_sum(&sea, |k| k)) - 1.0).abs() < 1e-4);
}

/// A finer grid leaves the waves that were there.
#[test]
fn a_finer_grid_adds_waves_and_keeps_the_phases() {
    for amplitudes in [Amplitudes::Deterministic, Amplitudes::Gaussian] {
        let coarse = sea(SpectralTileParameters { amplitudes, ..TILE });
        let fine = sea(SpectralTileParameters { amplitudes, resolution: 128, ..TILE });
        assert!(coarse.captured_fraction() < fine.captured_fraction());
        let mut compared = 0;
        for p in 0..16 {
            let (few, many) = (coarse.waves.amplitudes(p), fine.waves.amplitudes(p));
            for q in (0..32).filter(|&q| q != 16) {
                let same = if q < 16 { q } else { q + 128 - 32 };
                for (few, many) in few.iter().zip(many) {
                    assert_eq!(many[same], few[q], "({p}, {q})");
                    compared += usize::from(few[q] != 0.0);
                }
            }
        }
        assert!(compared > 1500);
    }
}

#[test]
fn mean_and_nyquist_terms_are_zero() {
    let sea = sea(TILE);
    assert!(sea.waves.amplitudes(0).iter().all(|part| part[0] == 0.0));
    assert!((0..16).all(|p| sea.waves.amplitudes(p).iter().all(|part| part[16] == 0.0)));
    assert_eq!(sea.waves.kz[16], 0.0);
}

/// Column 0 holds waves and their mirror images, which must be conjugate for the surface to be real.
#[test]
fn the_first_column_is_hermitian() {
    let sea = sea(TILE);
    let [p_re, p_im, q_re, q_im] = sea.waves.amplitudes(0);
    for q in 1..16 {
        assert_eq!((p_re[q], p_im[q]), (p_re[32 - q], -p_im[32 - q]));
        assert_eq!((q_re[q], q_im[q]), (q_re[32 - q], -q_im[32 - q]));
    }
}
