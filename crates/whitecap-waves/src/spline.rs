//! A periodic surface between its samples: uniform cubic B-splines.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | ω | phase of a wave from one sample to the next | rad |
//! | β(ω) | (sin ½ω / ½ω)⁴, the Fourier transform of the cubic B-spline | |
//!
//! A spline whose coefficients are those of a wave e^{iωx}, times c, is Σ_j c β(ω + 2πj) e^{i(ω+2πj)x}: the wave, and
//! its aliases from the coarse grid. c = β(ω)/Σβ² makes the mean square of the error least, and since waves come
//! here as a Fourier series, c costs one factor for each. What remains is √(1 − β²/Σβ²): 1.2 % of a wave of four
//! samples, 0.16 % of one of six, 0.03 % of one of eight (Unser, Aldroubi and Eden 1993 derive the transforms).
//!
//! What is known by its samples alone has coefficients, too: those of the spline through them.

use glam::Vec4;
use rustfft::num_complex::Complex;
use std::f64::consts::PI;

/// c for a wave that turns by `turns` from one sample to the next, |`turns`| ≤ ½.
fn coefficient(turns: f64) -> f64 {
    (1.0 - error_variance(turns)) / beta(turns, 0)
}

/// β at the `j`-th alias of a wave.
fn beta(turns: f64, j: i32) -> f64 {
    let half = PI * (turns + f64::from(j));
    if half == 0.0 { 1.0 } else { (libm::sin(half) / half).powi(4) }
}

/// √(1 − β²/Σβ²) squared: the mean square error of a wave, relative to its own mean square.
pub(crate) fn error_variance(turns: f64) -> f64 {
    // They die off with the eighth power.
    let aliases: f64 = (1..=4).map(|j| beta(turns, j).powi(2) + beta(turns, -j).powi(2)).sum();
    aliases / (aliases + beta(turns, 0).powi(2))
}

/// c for each lattice number from 0 to `most`, on a grid with `side` samples to the tile.
pub(crate) fn factors(most: usize, side: usize) -> Vec<f32> {
    (0..=most).map(|q| coefficient((q as f64 / side as f64).min(0.5)) as f32).collect()
}

/// Makes coefficients of the waves of one column, those of lattice number `p` along x and 0, 1 … −1 along z.
#[inline(always)]
pub(crate) fn filter(factors: &[f32], p: usize, column: &mut [Complex<f32>]) {
    let (positive, negative) = column.split_at_mut(column.len() / 2);
    for (value, by) in positive.iter_mut().zip(factors) {
        *value *= by * factors[p];
    }
    for (value, by) in negative.iter_mut().rev().zip(&factors[1..]) {
        *value *= by * factors[p];
    }
}

/// The pole of the filter below, √3 − 2.
const POLE: f32 = -0.267_949_2;

/// Samples after which the filter has forgotten where it started, to a part in 10⁹.
const WARM_UP: usize = 16;

/// Makes coefficients of a field's samples, index `iz * side + ix`: those of the spline that passes through them.
///
/// 6/(z + 4 + 1/z) = −6 r/((1 − r/z)(1 − r z)), r = √3 − 2: once forwards and once backwards along each row
/// (Unser, Aldroubi and Eden 1993, part II, table I).
pub(crate) fn interpolate(samples: &mut [f32], side: usize) {
    for i in 0..side {
        interpolate_run(samples, i * side, 1, side);
    }
    for i in 0..side {
        interpolate_run(samples, i, side, side);
    }
}

/// The samples at `first`, `first + step` … go round.
fn interpolate_run(samples: &mut [f32], first: usize, step: usize, side: usize) {
    let at = |i: usize| first + i % side * step;
    let start = side * WARM_UP - WARM_UP;
    let mut last = (start..start + WARM_UP).fold(0.0, |last, i| samples[at(i)] + POLE * last);
    for i in 0..side {
        last = samples[at(i)] + POLE * last;
        samples[at(i)] = last;
    }
    let mut next = (0..WARM_UP).rev().fold(0.0, |next, i| POLE * (next - 6.0 * samples[at(i)]));
    for i in (0..side).rev() {
        next = POLE * (next - 6.0 * samples[at(i)]);
        samples[at(i)] = next;
    }
}

/// The four coefficients about a place, and the weights of each for the value and for the derivative by the
/// sample number.
#[derive(Clone, Copy)]
pub(crate) struct Taps {
    first: usize,
    mask: usize,
    value: [f32; 4],
    slope: [f32; 4],
}

impl Taps {
    /// Of a place counted in samples, 0 ≤ `place` ≤ `side`, on a grid with a power of two of them.
    #[inline(always)]
    pub(crate) fn at(place: f64, side: usize) -> Self {
        // Not below 0, so the cast is the floor, without a call.
        let whole = place as usize;
        let t = (place - whole as f64) as f32;
        let mask = side - 1;
        let (u, t2) = (1.0 - t, t * t);
        Self {
            first: whole.wrapping_sub(1) & mask,
            mask,
            value: [
                u * u * u / 6.0,
                (3.0 * t - 6.0) * t2 / 6.0 + 2.0 / 3.0,
                ((-3.0 * t + 3.0) * t2 + 3.0 * t + 1.0) / 6.0,
                t2 * t / 6.0,
            ],
            slope: [-0.5 * u * u, (1.5 * t - 2.0) * t, (-1.5 * t + 1.0) * t + 0.5, 0.5 * t2],
        }
    }

    fn places(&self) -> [usize; 4] {
        std::array::from_fn(|i| (self.first + i) & self.mask)
    }
}

/// A value with its derivatives by the sample numbers along x and z.
#[derive(Clone, Copy)]
pub(crate) struct Jet {
    pub(crate) value: Vec4,
    pub(crate) by_x: Vec4,
    pub(crate) by_z: Vec4,
}

/// Value and derivatives at a place, of coefficients whose index is `iz * side + ix`.
#[inline(always)]
pub(crate) fn jet(coefficients: &[Vec4], x: &Taps, z: &Taps) -> Jet {
    let columns = x.places();
    let (mut value, mut by_x, mut by_z) = (Vec4::ZERO, Vec4::ZERO, Vec4::ZERO);
    for (i, row) in z.places().into_iter().enumerate() {
        let row = &coefficients[row * (x.mask + 1)..][..x.mask + 1];
        let (mut along, mut slope) = (Vec4::ZERO, Vec4::ZERO);
        for (j, column) in columns.into_iter().enumerate() {
            along += row[column] * x.value[j];
            slope += row[column] * x.slope[j];
        }
        value += along * z.value[i];
        by_x += slope * z.value[i];
        by_z += along * z.slope[i];
    }
    Jet { value, by_x, by_z }
}

/// The value alone.
#[inline(always)]
pub(crate) fn value(coefficients: &[Vec4], x: &Taps, z: &Taps) -> Vec4 {
    let columns = x.places();
    let mut value = Vec4::ZERO;
    for (i, row) in z.places().into_iter().enumerate() {
        let row = &coefficients[row * (x.mask + 1)..][..x.mask + 1];
        let mut along = Vec4::ZERO;
        for (j, column) in columns.into_iter().enumerate() {
            along += row[column] * x.value[j];
        }
        value += along * z.value[i];
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn weights_sum_to_one_and_slopes_to_nothing() {
        for i in 0..64 {
            let taps = Taps::at(f64::from(i) * 0.25, 16);
            assert!((taps.value.iter().sum::<f32>() - 1.0).abs() < 1e-6);
            assert!(taps.slope.iter().sum::<f32>().abs() < 1e-6);
        }
        assert_eq!(Taps::at(0.5, 16).places(), [15, 0, 1, 2]);
        assert_eq!(Taps::at(16.0, 16).places(), [15, 0, 1, 2]);
    }

    /// Of any number of samples, down to one: the spline passes through them all.
    #[test]
    fn coefficients_of_samples_pass_through_them() {
        for side in [1, 2, 3, 16, 37] {
            let samples: Vec<f32> = (0..side * side).map(|i| ((i * i) % 13) as f32 - 6.0).collect();
            let mut found = samples.clone();
            interpolate(&mut found, side);
            let weights = [1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0];
            for (i, sample) in samples.iter().enumerate() {
                let mut sum = 0.0;
                for (dz, wz) in weights.iter().enumerate() {
                    for (dx, wx) in weights.iter().enumerate() {
                        let (x, z) = ((i % side + side - 1 + dx) % side, (i / side + side - 1 + dz) % side);
                        sum += wx * wz * found[z * side + x];
                    }
                }
                assert!((sum - sample).abs() < 1e-5, "{side}: {sum} instead of {sample}");
            }
        }
    }

    /// A diagonal wave: its value, both derivatives, and the error that the text above promises.
    #[test]
    fn a_wave_is_drawn_to_its_bound() {
        for (turns, bound) in
            [(1.0 / 4.0, 0.0125), (1.0 / 6.0, 1.7e-3), (1.0 / 8.0, 5e-4), (1.0 / 32.0, 3e-6)]
        {
            let side = 64;
            let filter = coefficient(turns) as f32;
            let phase = |x: f64| (TAU * turns * x).cos();
            let grid: Vec<Vec4> =
                (0..side * side).map(|i| Vec4::Y * filter * phase((i % side) as f64) as f32).collect();
            // Turns that do not divide the side have a seam; stay away from it.
            let (mut square, mut count) = (0.0, 0.0);
            for i in 0..200 {
                let place = 10.0 + 0.197 * f64::from(i);
                let found = jet(&grid, &Taps::at(place, side), &Taps::at(7.3, side));
                let error = f64::from(found.value.y) - phase(place);
                let slope = -TAU * turns * (TAU * turns * place).sin();
                // The aliases turn 1/turns − 1 times as fast.
                assert!((f64::from(found.by_x.y) - slope).abs() < 1.5 * TAU * bound + 1e-5);
                assert!(found.by_z.length() < 1e-6);
                assert_eq!(value(&grid, &Taps::at(place, side), &Taps::at(7.3, side)), found.value);
                (square, count) = (square + 2.0 * error * error, count + 1.0);
            }
            let error = f64::sqrt(square / count);
            assert!(error < 1.1 * bound, "{turns}: {error}");
            assert!(error > 0.5 * bound || turns < 0.1, "{turns}: {error}");
        }
    }
}
