//! Laying spectra onto a tile's lattice.
//!
//! Symbols as in the [module above](super). The energy of a wave of the lattice is the integral of Ψ over the
//! lattice's cell around it, not Ψ at its centre times Δk²: next to a sharp peak, or to the origin, Ψ changes by
//! more than its own value within a cell.

use super::band::{Band, Position};
use crate::error::ParameterError;
use crate::spectrum::WaveSpectrum;
use crate::transform::{for_each_run, thread_count};
use glam::DVec2;
use std::f64::consts::TAU;

/// The energy of all systems on the lattice.
pub(super) struct LatticeEnergy {
    /// ∫Ψ d²k over the cell of the point (p, q), at index [`cell`]; the systems summed.
    pub(super) cell_variance_m2: Vec<f64>,
    /// The sum of the above for each system.
    pub(super) carried_m2: Vec<f64>,
}

/// Integrates `systems` over the cells of a lattice, as far as `band` reaches.
pub(super) fn lattice_energy<S: WaveSpectrum>(
    tile_size_m: f64,
    n: usize,
    band: Band,
    systems: &[S],
) -> Result<LatticeEnergy, ParameterError> {
    let spacing = TAU / tile_size_m;
    let half = n as i32 / 2;
    let mut cell_variance_m2 = vec![0.0; n * n];
    let mut carried_m2 = Vec::with_capacity(systems.len());
    let mut of_system = vec![0.0; n * n];
    for spectrum in systems {
        if spectrum.variance_m2() == 0.0 {
            carried_m2.push(0.0);
            continue;
        }
        for_each_run(&mut of_system, n, &mut vec![(); thread_count(n)], |column, cells, ()| {
            let p = column as i32 - half;
            for (q, cell) in (-half..half).zip(cells) {
                // The mean and the Nyquist terms carry nothing.
                let empty = p == -half || q == -half || (p, q) == (0, 0);
                *cell = if empty { 0.0 } else { cell_energy_m2(spectrum, p, q, spacing, band) };
            }
        });
        let sum: f64 = of_system.iter().sum();
        if !(sum.is_finite() && spectrum.variance_m2().is_finite()) {
            return Err(ParameterError::OutOfRange { field: "density_m4", value: sum, accepted: "finite" });
        }
        for (total, cell) in cell_variance_m2.iter_mut().zip(&of_system) {
            *total += cell;
        }
        carried_m2.push(sum);
    }
    Ok(LatticeEnergy { cell_variance_m2, carried_m2 })
}

/// The index of the lattice point (`p`, `q`), −N/2 ≤ p, q < N/2.
pub(super) fn cell(n: usize, p: i32, q: i32) -> usize {
    let half = n as i32 / 2;
    (p + half) as usize * n + (q + half) as usize
}

/// ∫Ψ d²k over the part of the cell around (p, q) that lies in the band.
fn cell_energy_m2(spectrum: &impl WaveSpectrum, p: i32, q: i32, spacing: f64, band: Band) -> f64 {
    let (p_abs, q_abs) = (f64::from(p.abs()), f64::from(q.abs()));
    let nearest = libm::hypot((p_abs - 0.5).max(0.0), (q_abs - 0.5).max(0.0)) * spacing;
    let farthest = libm::hypot(p_abs + 0.5, q_abs + 0.5) * spacing;
    let position = band.position(nearest, farthest);
    let side = match position {
        Position::Outside => return 0.0,
        Position::Inside => points_per_side(p.abs().max(q.abs())),
        Position::Across => points_per_side(p.abs().max(q.abs())).max(EDGE_POINTS),
    };
    let centre = DVec2::new(f64::from(p), f64::from(q));
    let step = 1.0 / f64::from(side);
    let offset = |i: u32| (f64::from(i) + 0.5) * step - 0.5;
    let mut sum = 0.0;
    for i in 0..side {
        for j in 0..side {
            let k = (centre + DVec2::new(offset(i), offset(j))) * spacing;
            if position == Position::Inside || band.contains(k.length()) {
                sum += spectrum.density_m4(k);
            }
        }
    }
    sum * (spacing * step) * (spacing * step)
}

/// Points along a side of a cell that a band's edge cuts: both bands take theirs from the same fine grid.
const EDGE_POINTS: u32 = 8;

/// Points along a side of a cell in the `ring`-th ring around the origin.
///
/// The midpoint rule with steps of Δk/s is off by (Δk/s)²/24 of Ψ's second derivative. The sharpest peak in
/// use, JONSWAP's with γ = 7, has about 50 Ψ/k² of it: 0.1 % for s ring ≥ 48.
fn points_per_side(ring: i32) -> u32 {
    match ring {
        0..=2 => 16,
        3..=7 => 8,
        8..=15 => 4,
        16..=47 => 2,
        _ => 1,
    }
}
