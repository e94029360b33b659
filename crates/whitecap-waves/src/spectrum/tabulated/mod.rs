//! A spectrum that somebody measured or calculated: energy on a table of frequencies and directions.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | f | frequency in water at rest | Hz |
//! | θ | direction of travel, from east towards south: the angle of k | rad |
//! | E(f, θ) | variance density over frequency and direction | m²/(Hz rad) |
//! | Ψ(k) | variance density over the wave-number plane | m⁴ |
//! | c_g | group speed dω/dk | m/s |
//!
//! A wave system has the same energy in every description, Ψ k dk dθ = E df dθ, so Ψ(k) = E(f, θ) (df/dk)/k
//! with df/dk = c_g/2π.
//!
//! Between the points of the table E is linear in f and linear in θ around the circle; the integral of that
//! is the trapezoidal rule both ways, which gives the variance. **Below the first frequency and above the
//! last there is nothing**: no tail is added to what was measured.

use super::WaveSpectrum;
use crate::dispersion::Dispersion;
use crate::error::{ParameterError, check};
use axis::Axis;
use frequency::FrequencyCurve;
use glam::DVec2;
use std::f64::consts::{PI, TAU};

mod axis;
mod directional;
mod frequency;
#[cfg(test)]
mod tests;

pub use directional::{DirectionMethod, DirectionalMoments, cos2s_distribution, even_directions, sampled};

/// What a [`Tabulated`] spectrum is made from.
#[derive(Debug, Clone, PartialEq)]
pub struct TabulatedParameters {
    /// At least two frequencies in Hz, strictly ascending, from 1e-4 to 100.
    pub frequencies_hz: Vec<f64>,
    /// At least three directions of travel in radians from east towards south, in any order and spacing, no
    /// two the same.
    pub toward_rad: Vec<f64>,
    /// E in m²/(Hz rad), 0..=1e9: for each frequency its directions, in the order of `toward_rad`.
    pub density: Vec<f64>,
}

/// A spectrum from a table; see the [module](self).
#[derive(Debug, Clone, PartialEq)]
pub struct Tabulated {
    curve: FrequencyCurve,
    frequencies_hz: Axis,
    /// Ascending from −π, and the first again a turn later.
    toward_rad: Axis,
    /// Row by row, with the first direction repeated at the end of each.
    density: Vec<f64>,
    variance_m2: f64,
}

impl Tabulated {
    /// The spectrum of `parameters` on water with this dispersion, or which parameter is out of its range.
    ///
    /// # Errors
    ///
    /// If the table is too small, out of order, of another size than its sides, or holds what is no energy.
    pub fn new(parameters: TabulatedParameters, water: &Dispersion) -> Result<Self, ParameterError> {
        let TabulatedParameters { frequencies_hz, toward_rad, density } = parameters;
        let (rows, columns) = (frequencies_hz.len(), toward_rad.len());
        check("frequencies_hz", rows as f64, "at least 2 frequencies", |count| count >= 2.0)?;
        check("toward_rad", columns as f64, "at least 3 directions", |count| count >= 3.0)?;
        check("density", density.len() as f64, "one value for each frequency and direction", |count| {
            count == rows as f64 * columns as f64
        })?;
        let mut below = 0.0;
        for &hz in &frequencies_hz {
            check("frequencies_hz", hz, "from 1e-4 to 100 Hz, strictly ascending", |hz| {
                (1e-4..=100.0).contains(&hz) && hz > below
            })?;
            below = hz;
        }
        for &value in &density {
            check("density", value, "from 0 to 1e9 m²/(Hz rad)", |value| (0.0..=1e9).contains(&value))?;
        }

        let mut order = Vec::with_capacity(columns);
        for (column, &toward) in toward_rad.iter().enumerate() {
            check("toward_rad", toward, "a finite angle", |_| true)?;
            order.push(((toward + PI).rem_euclid(TAU).min(TAU) - PI, column));
        }
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut around: Vec<f64> = order.iter().map(|&(toward, _)| toward).collect();
        around.push(around[0] + TAU);
        for pair in around.windows(2) {
            check("toward_rad", pair[1], "no two directions the same", |toward| toward - pair[0] > 1e-6)?;
        }

        let around_row = |row: &[f64]| {
            let sorted = order.iter().chain(&order[..1]).map(|&(_, column)| row[column]);
            sorted.collect::<Vec<_>>()
        };
        let density: Vec<f64> = density.chunks_exact(columns).flat_map(around_row).collect();
        let rows: Vec<f64> = density.chunks_exact(columns + 1).map(|row| trapezoid(&around, row)).collect();
        Ok(Self {
            curve: FrequencyCurve::new(frequencies_hz[0], frequencies_hz[rows.len() - 1], water),
            variance_m2: trapezoid(&frequencies_hz, &rows),
            frequencies_hz: Axis::new(frequencies_hz),
            toward_rad: Axis::new(around),
            density,
        })
    }

    /// The frequencies of the table in Hz: the first and the last bound the energy.
    pub fn frequencies_hz(&self) -> &[f64] {
        self.frequencies_hz.points()
    }

    /// E(`frequency_hz`, `toward_rad`) in m²/(Hz rad), interpolated; 0 outside the table's frequencies.
    #[inline]
    pub fn density_m2phzprad(&self, frequency_hz: f64, toward_rad: f64) -> f64 {
        let Some((row, up)) = self.frequencies_hz.find(frequency_hz) else { return 0.0 };
        let around = self.toward_rad.points();
        let first = around[0];
        let mut toward = toward_rad;
        if !(first..=first + TAU).contains(&toward) {
            toward = (toward - first).rem_euclid(TAU) + first;
        }
        // Rounding may leave it a hair beyond the end, and NaN stays NaN.
        let Some((column, across)) = self.toward_rad.find(toward.min(around[around.len() - 1])) else {
            return 0.0;
        };
        let low = row * around.len() + column;
        let high = low + around.len();
        let along = |at: usize| self.density[at] + across * (self.density[at + 1] - self.density[at]);
        // Between two values that are not negative, but for rounding.
        (along(low) + up * (along(high) - along(low))).max(0.0)
    }
}

/// ∫ y dx by the trapezoidal rule.
fn trapezoid(x: &[f64], y: &[f64]) -> f64 {
    x.windows(2).zip(y.windows(2)).map(|(x, y)| 0.5 * (x[1] - x[0]) * (y[0] + y[1])).sum()
}

impl WaveSpectrum for Tabulated {
    fn density_m4(&self, k: DVec2) -> f64 {
        let wave_number = k.length();
        let u = wave_number.sqrt();
        // dk = 2u du.
        let Some((hz, slope)) = self.curve.at(u) else { return 0.0 };
        self.density_m2phzprad(hz, libm::atan2(k.y, k.x)) * slope / (2.0 * u * wave_number)
    }

    fn variance_m2(&self) -> f64 {
        self.variance_m2
    }
}
