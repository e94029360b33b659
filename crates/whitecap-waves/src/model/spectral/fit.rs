//! Laying spectra onto a tile's lattice, and what to say when they do not fit.
//!
//! Symbols as in the [module above](super).

use crate::error::{ParameterError, Remedy};
use crate::spectrum::WaveSpectrum;
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// A system of which the lattice carries less is refused.
const LEAST_CAPTURED: f64 = 0.5;

/// The energy of all systems on the lattice.
pub(super) struct LatticeEnergy {
    /// ΨΔk² for the point (p, q) at index `(p + N/2) * N + q + N/2`, the systems scaled and summed.
    pub(super) cell_variance_m2: Vec<f64>,
    /// m0 of all systems.
    pub(super) variance_m2: f64,
    /// ΣΨΔk² before scaling over m0; 1 when there is no energy at all.
    pub(super) captured_fraction: f64,
}

/// Samples `systems` at the centres of the lattice's cells and scales each to its own m0.
pub(super) fn lattice_energy<S: WaveSpectrum>(
    tile_size_m: f64,
    n: usize,
    systems: &[S],
) -> Result<LatticeEnergy, ParameterError> {
    let spacing = TAU / tile_size_m;
    let half = n as i32 / 2;
    let mut cell_variance_m2 = vec![0.0; n * n];
    let mut raw = vec![0.0; n * n];
    let (mut requested, mut carried) = (0.0, 0.0);
    for (system, spectrum) in systems.iter().enumerate() {
        let m0 = spectrum.variance_m2();
        if m0 == 0.0 {
            continue;
        }
        for p in 1 - half..half {
            for q in 1 - half..half {
                if (p, q) != (0, 0) {
                    let k = DVec2::new(f64::from(p), f64::from(q)) * spacing;
                    raw[cell(n, p, q)] = spectrum.density_m4(k) * spacing * spacing;
                }
            }
        }
        let sum: f64 = raw.iter().sum();
        if !(sum.is_finite() && m0.is_finite()) {
            return Err(ParameterError::OutOfRange { field: "density_m4", value: sum, accepted: "finite" });
        }
        if sum < LEAST_CAPTURED * m0 {
            return Err(ParameterError::SeaDoesNotFit {
                system,
                captured_fraction: sum / m0,
                tile_size_m,
                resolution: n,
                remedy: remedy(spectrum, tile_size_m, n),
            });
        }
        for (total, raw) in cell_variance_m2.iter_mut().zip(&raw) {
            *total += raw * (m0 / sum);
        }
        requested += m0;
        carried += sum;
    }
    let captured_fraction = if requested > 0.0 { carried / requested } else { 1.0 };
    Ok(LatticeEnergy { cell_variance_m2, variance_m2: requested, captured_fraction })
}

/// The index of the lattice point (`p`, `q`), −N/2 ≤ p, q < N/2.
pub(super) fn cell(n: usize, p: i32, q: i32) -> usize {
    let half = n as i32 / 2;
    (p + half) as usize * n + (q + half) as usize
}

/// What would make `spectrum` fit, from its omnidirectional form on a logarithmic scale of k: a larger tile if
/// more energy is longer than the tile than is shorter than two samples, closer samples otherwise.
fn remedy(spectrum: &impl WaveSpectrum, tile_size_m: f64, n: usize) -> Remedy {
    const STEPS: u32 = 2400;
    const DIRECTIONS: u32 = 72;
    // From waves of 60 km to such of 0.6 mm.
    let (lowest, decades) = (1e-4, 8.0);
    let wave_number = |i: u32| lowest * libm::exp10(decades * f64::from(i) / f64::from(STEPS));
    // Per step of ln k the energy is k² times the mean of Ψ over directions, but for a constant.
    let energy: Vec<f64> = (0..STEPS)
        .map(|i| {
            let k = wave_number(i);
            let mean = |j: u32| {
                spectrum.density_m4(k * DVec2::from_angle(TAU * f64::from(j) / f64::from(DIRECTIONS)))
            };
            k * k * (0..DIRECTIONS).map(mean).sum::<f64>()
        })
        .collect();
    let total: f64 = energy.iter().sum();
    let below =
        |limit: f64| (0..STEPS).filter(|&i| wave_number(i) < limit).map(|i| energy[i as usize]).sum::<f64>();
    let too_long = below(TAU / tile_size_m);
    let too_short = total - below(PI * n as f64 / tile_size_m);
    if too_long >= too_short {
        // The peak of the spectrum over k, which is what a wave number spectrum S(k) shows.
        let density = |i: u32| energy[i as usize] / wave_number(i);
        let peak = (0..STEPS).max_by(|&a, &b| density(a).total_cmp(&density(b))).unwrap_or(0);
        Remedy::LargerTile { tile_size_m: (4.0 * TAU / wave_number(peak)).ceil() }
    } else {
        let mut sum = 0.0;
        let resolved = (0..STEPS).find(|&i| {
            sum += energy[i as usize];
            sum >= 0.9 * total
        });
        Remedy::CloserSamples { spacing_m: PI / wave_number(resolved.unwrap_or(STEPS)) }
    }
}
