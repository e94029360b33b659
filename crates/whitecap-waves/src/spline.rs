//! A periodic surface between its samples: uniform B-splines, cubic where it is drawn, quintic where it is asked.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | n | coefficients that count at a place, along an axis: 4 of a cubic spline, 6 of a quintic one | |
//! | ω | phase of a wave from one sample to the next | rad |
//! | β(ω) | (sin ½ω / ½ω)ⁿ, the Fourier transform of the B-spline | |
//!
//! A spline whose coefficients are those of a wave e^{iωx}, times c, is Σ_j c β(ω + 2πj) e^{i(ω+2πj)x}: the wave, and
//! its aliases from the coarse grid. c = β(ω)/Σβ² makes the mean square of the error least, and since waves come
//! here as a Fourier series, c costs one factor for each. What remains is √(1 − β²/Σβ²) (Unser, Aldroubi and Eden 1993
//! derive the transforms):
//!
//! | samples to a wave | cubic | quintic |
//! | --- | --- | --- |
//! | 4 | 1.2 % | 0.14 % |
//! | 6 | 0.16 % | 0.006 % |
//! | 8 | 0.04 % | 0.0009 % |
//!
//! What is known by its samples alone has coefficients, too: those of the cubic spline through them.

use glam::{DVec2, Vec4};
use rustfft::num_complex::Complex;
use std::f64::consts::{PI, TAU};

/// n of a cubic spline.
pub(crate) const CUBIC: usize = 4;

/// n of a quintic spline.
pub(crate) const QUINTIC: usize = 6;

/// What a spline of `n` coefficients makes of a wave along one axis.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OnGrid {
    /// ω.
    phase: f64,
    /// c.
    coefficient: f64,
    /// 1 − β²/Σβ²: the mean square error, relative to the wave's own mean square.
    lost: f64,
    /// The mean square of the spline's derivative by the sample number, aliases and all, relative to the same.
    slope: f64,
}

impl OnGrid {
    /// Of a wave that turns by `turns` from one sample to the next, |`turns`| ≤ ½.
    pub(crate) fn new(turns: f64, n: usize) -> Self {
        let beta = |j: i32| {
            let half = PI * (turns + f64::from(j));
            if half == 0.0 { 1.0 } else { (libm::sin(half) / half).powi(n as i32) }
        };
        let phase = |j: i32| TAU * (turns + f64::from(j));
        // They die off with the eighth power, or the twelfth.
        let aliases = || (1..=4).flat_map(|j| [j, -j]);
        let lost: f64 = aliases().map(|j| beta(j).powi(2)).sum();
        let all = lost + beta(0).powi(2);
        let coefficient = beta(0) / all;
        let slope: f64 = aliases().chain([0]).map(|j| (coefficient * beta(j) * phase(j)).powi(2)).sum();
        Self { phase: phase(0), coefficient, lost: lost / all, slope }
    }

    /// The mean square error of a wave on a square grid, and that of its derivative by the number of the sample along
    /// the axis of `self`, both relative to the mean square of the wave.
    pub(crate) fn errors(&self, across: &Self) -> (f64, f64) {
        // 1 − (1 − a)(1 − b), with all digits where both are small.
        let lost = self.lost + across.lost - self.lost * across.lost;
        // Aliases have what is not the wave; of the wave itself `lost` is missing.
        let wave = self.phase * self.phase;
        let aliases = (self.slope * (1.0 - across.lost) - wave * (1.0 - lost) * (1.0 - lost)).max(0.0);
        (lost, aliases + wave * lost * lost)
    }
}

/// c for each lattice number from 0 to `most`, on a grid with `side` samples to the tile, for splines of `n` coefficients.
pub(crate) fn factors(most: usize, side: usize, n: usize) -> Vec<f32> {
    (0..=most).map(|q| OnGrid::new((q as f64 / side as f64).min(0.5), n).coefficient as f32).collect()
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

/// The N coefficients about a place, along one axis, and the weights of each for the value and for the derivative by the
/// sample number.
#[derive(Clone, Copy)]
pub(crate) struct Taps<const N: usize> {
    first: usize,
    mask: usize,
    value: [f32; N],
    slope: [f32; N],
}

#[cfg(test)]
impl Taps<CUBIC> {
    /// The same for one axis, as shaders take them.
    pub(crate) fn at(place: f64, side: usize) -> Self {
        let whole = place as usize;
        let t = (place - whole as f64) as f32;
        let mask = side - 1;
        let (u, t2) = (1.0 - t, t * t);
        Self {
            first: whole.wrapping_sub(CUBIC / 2 - 1) & mask,
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
}

impl Taps<QUINTIC> {
    /// Of a place counted in samples along x and z, 0 ≤ `place` ≤ `side`, on a grid with a power of two of them.
    #[inline(always)]
    pub(crate) fn at(place: DVec2, side: usize) -> [Self; 2] {
        // Not below 0, so the cast is the floor, without a call.
        let whole = [place.x as usize, place.y as usize];
        let (x, z) = ((place.x - whole[0] as f64) as f32, (place.y - whole[1] as f64) as f32);
        // Weights are those of the mirror image in reverse, so three of them, at t and at 1 − t, are all six.
        let t = Vec4::new(x, 1.0 - x, z, 1.0 - z);
        let (t2, one) = (t * t, Vec4::ONE);
        let (t3, t4) = (t2 * t, t2 * t2);
        let value = [
            one + 5.0 * (t + t4) + 10.0 * (t2 + t3) - 5.0 * (t4 * t),
            26.0 * one + 50.0 * t + 20.0 * (t2 - t3 - t4) + 10.0 * (t4 * t),
            t4 * t,
        ];
        let slope = [
            one + 4.0 * (t + t3) + 6.0 * t2 - 5.0 * t4,
            10.0 * one + 8.0 * t - 12.0 * t2 - 16.0 * t3 + 10.0 * t4,
            t4,
        ];
        let [outer, inner, last] = value.map(|weights| (weights * (1.0 / 120.0)).to_array());
        let [outer_slope, inner_slope, last_slope] = slope.map(|weights| (weights * (1.0 / 24.0)).to_array());
        let mask = side - 1;
        std::array::from_fn(|axis| {
            let (here, there) = (2 * axis, 2 * axis + 1);
            Self {
                first: whole[axis].wrapping_sub(QUINTIC / 2 - 1) & mask,
                mask,
                value: [last[there], outer[there], inner[there], inner[here], outer[here], last[here]],
                slope: [
                    -last_slope[there],
                    -outer_slope[there],
                    -inner_slope[there],
                    inner_slope[here],
                    outer_slope[here],
                    last_slope[here],
                ],
            }
        })
    }
}

impl<const N: usize> Taps<N> {
    fn places(&self) -> [usize; N] {
        std::array::from_fn(|i| (self.first + i) & self.mask)
    }

    /// The coefficients of row `iz`.
    #[inline(always)]
    fn row(&self, coefficients: &[Vec4], iz: usize) -> [Vec4; N] {
        let row = &coefficients[iz * (self.mask + 1)..][..self.mask + 1];
        match row[self.first..].first_chunk() {
            Some(run) => *run,
            None => self.places().map(|ix| row[ix]),
        }
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
pub(crate) fn jet<const N: usize>(coefficients: &[Vec4], x: &Taps<N>, z: &Taps<N>) -> Jet {
    let (mut value, mut by_x, mut by_z) = (Vec4::ZERO, Vec4::ZERO, Vec4::ZERO);
    for (i, iz) in z.places().into_iter().enumerate() {
        let row = x.row(coefficients, iz);
        let (mut along, mut slope) = (Vec4::ZERO, Vec4::ZERO);
        for ((coefficient, value), by_place) in row.into_iter().zip(x.value).zip(x.slope) {
            along += coefficient * value;
            slope += coefficient * by_place;
        }
        value += along * z.value[i];
        by_x += slope * z.value[i];
        by_z += along * z.slope[i];
    }
    Jet { value, by_x, by_z }
}

/// The value alone.
#[inline(always)]
pub(crate) fn value<const N: usize>(coefficients: &[Vec4], x: &Taps<N>, z: &Taps<N>) -> Vec4 {
    let mut value = Vec4::ZERO;
    for (i, iz) in z.places().into_iter().enumerate() {
        let row = x.row(coefficients, iz);
        let mut along = Vec4::ZERO;
        for (coefficient, value) in row.into_iter().zip(x.value) {
            along += coefficient * value;
        }
        value += along * z.value[i];
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    type At<const N: usize> = fn(f64, usize) -> Taps<N>;

    /// Those of the one axis and of the other.
    fn quintic(place: f64, side: usize) -> Taps<QUINTIC> {
        let [x, z] = Taps::<QUINTIC>::at(DVec2::splat(place), side);
        assert_eq!((x.first, x.value, x.slope), (z.first, z.value, z.slope));
        let [other, same] = Taps::<QUINTIC>::at(DVec2::new(1.3, place), side);
        assert_eq!((x.value, other.first), (same.value, side - 1));
        x
    }

    #[test]
    fn weights_sum_to_one_and_slopes_to_nothing() {
        fn check<const N: usize>(at: At<N>) {
            for i in 0..64 {
                let taps = at(f64::from(i) * 0.25, 16);
                assert!((taps.value.iter().sum::<f32>() - 1.0).abs() < 1e-6);
                assert!(taps.slope.iter().sum::<f32>().abs() < 1e-6);
                // They have their middle at the place, and slopes are their rates.
                let middle: f32 =
                    taps.value.iter().zip(0..).map(|(w, j)| w * (j - N as i32 / 2 + 1) as f32).sum();
                let rate: f32 = taps.slope.iter().zip(0..).map(|(w, j)| w * j as f32).sum();
                let t = (0.25 * i as f32).fract();
                assert!((middle - t).abs() < 1e-5 && (rate - 1.0).abs() < 1e-5, "{middle} {rate}");
            }
        }
        check(Taps::<CUBIC>::at);
        check(quintic);
        // At a sample: 1/6, 4/6, 1/6 and 1/120, 26/120, 66/120, 26/120, 1/120.
        let near = |found: &[f32], expected: &[f32]| {
            assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-7), "{found:?}");
        };
        near(&Taps::<CUBIC>::at(3.0, 16).value.map(|w| 6.0 * w), &[1.0, 4.0, 1.0, 0.0]);
        near(&quintic(3.0, 16).value.map(|w| w), &[1.0, 26.0, 66.0, 26.0, 1.0, 0.0].map(|w| w / 120.0));
        assert_eq!(Taps::<CUBIC>::at(0.5, 16).places(), [15, 0, 1, 2]);
        assert_eq!(Taps::<CUBIC>::at(16.0, 16).places(), [15, 0, 1, 2]);
        assert_eq!(quintic(0.5, 16).places(), [14, 15, 0, 1, 2, 3]);
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

    /// A wave's value, its derivatives, and the error of both that the text above promises.
    #[test]
    fn a_wave_is_drawn_to_its_bound() {
        fn check<const N: usize>(at: At<N>, turns: f64, bound: f64) {
            let side = 64;
            let wave = OnGrid::new(turns, N);
            let (lost, slope_lost) = wave.errors(&OnGrid::new(0.0, N));
            assert!((lost.sqrt() / bound - 1.0).abs() < 0.1, "{N} {turns}: {}", lost.sqrt());
            let filter = wave.coefficient as f32;
            let phase = |x: f64| (TAU * turns * x).cos();
            let grid: Vec<Vec4> =
                (0..side * side).map(|i| Vec4::Y * filter * phase((i % side) as f64) as f32).collect();
            // Turns that do not divide the side have a seam; stay away from it.
            let (mut square, mut slope_square, mut count) = (0.0, 0.0, 0.0);
            for i in 0..400 {
                let place = 10.0 + 0.097 * f64::from(i);
                let (x, z) = (at(place, side), at(7.3, side));
                let found = jet(&grid, &x, &z);
                let error = f64::from(found.value.y) - phase(place);
                let slope = -TAU * turns * (TAU * turns * place).sin();
                let slope_error = f64::from(found.by_x.y) - slope;
                assert!(found.by_z.length() < 1e-6);
                assert_eq!(value(&grid, &x, &z), found.value);
                square += 2.0 * error * error;
                slope_square += 2.0 * slope_error * slope_error;
                count += 1.0;
            }
            // Single precision ends at a few parts in 10⁸.
            let [error, slope_error] = [square, slope_square].map(|square: f64| (square / count).sqrt());
            assert!((error - lost.sqrt()).abs() < 0.1 * lost.sqrt() + 2e-7, "{N} {turns}: {error}");
            let expected = slope_lost.sqrt();
            assert!(
                (slope_error - expected).abs() < 0.1 * expected + 5e-7,
                "{N} {turns}: {slope_error} {expected}"
            );
        }
        for (turns, bounds) in
            [(1.0 / 4.0, (0.01234, 1.37e-3)), (1.0 / 6.0, (1.6e-3, 6.4e-5)), (1.0 / 8.0, (4.2e-4, 8.5e-6))]
        {
            check(Taps::<CUBIC>::at, turns, bounds.0);
            check(quintic, turns, bounds.1);
        }
    }

    /// A wave across the grid has the errors of both axes.
    #[test]
    fn a_diagonal_wave_has_the_errors_of_both_axes() {
        let side = 64;
        let (along, across) = (OnGrid::new(0.25, QUINTIC), OnGrid::new(0.1875, QUINTIC));
        let (lost, slope_lost) = along.errors(&across);
        let phase = |x: f64, z: f64| TAU * (0.25 * x + 0.1875 * z);
        let filter = along.coefficient * across.coefficient;
        let grid: Vec<Vec4> = (0..side * side)
            .map(|i| Vec4::Y * (filter * phase((i % side) as f64, (i / side) as f64).cos()) as f32)
            .collect();
        let (mut square, mut slope_square) = (0.0, 0.0);
        for i in 0..4000 {
            let (x, z) = ((0.618_034 * f64::from(i)) % 64.0, (0.754_878 * f64::from(i)) % 64.0);
            let found = jet(&grid, &quintic(x, side), &quintic(z, side));
            square += 2.0 * (f64::from(found.value.y) - phase(x, z).cos()).powi(2) / 4000.0;
            slope_square += 2.0 * (f64::from(found.by_x.y) + TAU * 0.25 * phase(x, z).sin()).powi(2) / 4000.0;
        }
        let (lost_there, slope_there) = (square / lost, slope_square / slope_lost);
        assert!(
            (lost_there - 1.0).abs() < 0.1 && (slope_there - 1.0).abs() < 0.1,
            "{lost_there} {slope_there}"
        );
    }
}
