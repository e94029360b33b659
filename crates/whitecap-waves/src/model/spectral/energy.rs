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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dispersion::Dispersion;
    use crate::spectrum::directional::{Directional, DirectionalParameters};
    use crate::spectrum::jonswap::Jonswap;
    use crate::spreading::{Spread, Spreading};

    /// The sharpest peak in use: a swell with γ = 7 whose waves are `ring` to a tile, towards 30°.
    fn swell(ring: f64, tile_size_m: f64) -> impl WaveSpectrum {
        let omega = Dispersion::DEEP.angular_frequency(ring * TAU / tile_size_m);
        let parameters = DirectionalParameters {
            spread: Spread { spreading: Spreading::Cos2s { exponent: 15.0 }, swell: 0.0 },
            toward: DVec2::from_angle(0.5),
            dispersion: Dispersion::DEEP,
        };
        Directional::new(Jonswap::from_height_and_period(2.0, TAU / omega, 7.0).unwrap(), parameters).unwrap()
    }

    /// ∫Ψ d²k over the cell of (p, q) by the midpoint rule on 64² points.
    fn reference_m2(spectrum: &impl WaveSpectrum, p: i32, q: i32, spacing: f64) -> f64 {
        let points = (0..64).map(|i| (f64::from(i) + 0.5) / 64.0 - 0.5);
        let row = |x: f64| {
            let at = |y: f64| spectrum.density_m4(spacing * DVec2::new(f64::from(p) + x, f64::from(q) + y));
            points.clone().map(at).sum::<f64>()
        };
        points.clone().map(row).sum::<f64>() * (spacing / 64.0).powi(2)
    }

    /// Wherever on the lattice the peak lies, each wave has its energy to 1 % of the greatest one's, and together they
    /// have theirs to 0.1 %.
    #[test]
    fn each_cell_has_the_energy_of_its_area() {
        let tile_size_m = 1000.0;
        let spacing = TAU / tile_size_m;
        for ring in [1.3, 2.4, 3.1, 5.0, 8.3, 12.0, 16.5, 30.0, 48.5, 70.0] {
            let spectrum = swell(ring, tile_size_m);
            let reach = (0.6 * ring) as i32 + 2;
            let centre = (ring * DVec2::from_angle(0.5)).round().as_ivec2();
            let (mut most, mut worst, mut sum, mut expected) = (0.0_f64, 0.0_f64, 0.0, 0.0);
            for p in centre.x - reach..=centre.x + reach {
                for q in centre.y - reach..=centre.y + reach {
                    if (p, q) == (0, 0) {
                        continue;
                    }
                    let found = cell_energy_m2(&spectrum, p, q, spacing, Band::WHOLE);
                    let exact = reference_m2(&spectrum, p, q, spacing);
                    most = most.max(exact);
                    worst = worst.max((found - exact).abs());
                    sum += found;
                    expected += exact;
                }
            }
            assert!(worst < 0.01 * most, "ring {ring}: {worst} of {most}");
            assert!((sum / expected - 1.0).abs() < 1e-3, "ring {ring}: {}", sum / expected);
        }
    }

    /// A band takes of the cells at its edge what lies inside of it.
    #[test]
    fn cells_across_an_edge_are_shared_by_area() {
        struct Flat;
        impl WaveSpectrum for Flat {
            fn density_m4(&self, _: DVec2) -> f64 {
                1.0
            }
            fn variance_m2(&self) -> f64 {
                1.0
            }
        }
        let band = Band { from: 0.0, to: 20.3 };
        let mut squares = Vec::new();
        for p in -22..=22 {
            for q in -22..=22 {
                let found = cell_energy_m2(&Flat, p, q, 1.0, band);
                let inside = |x: f64, y: f64| f64::from(u8::from(band.contains(x.hypot(y))));
                let points = (0..64).map(|i| (f64::from(i) + 0.5) / 64.0 - 0.5);
                let row =
                    |x: f64| points.clone().map(|y| inside(f64::from(p) + x, f64::from(q) + y)).sum::<f64>();
                let exact = points.clone().map(row).sum::<f64>() / 4096.0;
                if exact > 0.0 && exact < 1.0 {
                    squares.push((found - exact).powi(2));
                }
            }
        }
        let rms = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
        assert!(squares.len() > 100 && rms < 0.025, "{rms} in {} cells", squares.len());
    }
}
