//! Sine and cosine of an angle in turns, fast and for a whole row at a time.
//!
//! Angles in turns (1 = 2π) make the reduction to one period a subtraction of a whole number, which f64 does
//! without error: the phase of a wave keeps its accuracy for as long as ω t/2π itself has it.

use std::f64::consts::TAU;

/// Added to an f64 and taken away again, 1.5 × 2⁵² leaves no bits for a fraction, which rounds to the nearest
/// whole number on any IEEE machine and, unlike a call to `round`, compiles to two vector additions.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// (cos, sin) of 2π × `turns` in f64, for |`turns`| below 2⁵¹; the same bits on every platform.
pub(crate) fn cos_sin_exact(turns: f64) -> (f64, f64) {
    let fraction = turns - ((turns + WHOLE) - WHOLE);
    let (sin, cos) = libm::sincos(TAU * fraction);
    (cos, sin)
}

/// (cos, sin) of 2π × `turns` in f32, with an absolute error below 3e-7, for |`turns`| below 2⁵⁰.
///
/// Whole half turns are taken off first, which leaves an angle of πr with |r| ≤ ½, and for an odd number of
/// them both results change sign. Polynomials in r² give sin πr and cos πr: Chebyshev interpolations, off by
/// 7e-9 and 2e-10 before rounding. There is no branch and no table, so a loop over it becomes vector code.
#[inline(always)]
pub(crate) fn cos_sin(turns: f64) -> (f32, f32) {
    let half_turns = 2.0 * turns;
    let rounded = half_turns + WHOLE;
    // Between 2⁵² and 2⁵³ the last bit of an f64 counts ones.
    let odd = (rounded.to_bits() as u32) << 31;
    let r = (half_turns - (rounded - WHOLE)) as f32;

    let y = r * r;
    let sin = ((((0.077_655_91 * y - 0.598_290_4) * y + 2.550_077_4) * y - 5.167_71) * y + 3.141_592_64) * r;
    let cos = ((((-0.024_395_932 * y + 0.234_937_07) * y - 1.335_211_95) * y + 4.058_709_15) * y
        - 4.934_802_14)
        * y
        + 1.0;
    (f32::from_bits(cos.to_bits() ^ odd), f32::from_bits(sin.to_bits() ^ odd))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Over three turns to either side, and far out, where a step is a fraction of a turn away from a whole
    /// number.
    #[test]
    fn the_fast_pair_keeps_its_bound() {
        let mut worst = 0.0_f64;
        for start in [0.0, 1e4, -3e6, 1e9] {
            for i in -30_000..=30_000 {
                let turns = start + f64::from(i) * 1e-4;
                let (cos, sin) = cos_sin(turns);
                let (exact_sin, exact_cos) = (TAU * (turns - turns.round())).sin_cos();
                worst = worst.max((f64::from(cos) - exact_cos).abs()).max((f64::from(sin) - exact_sin).abs());
            }
        }
        assert!(worst < 3e-7, "{worst}");
    }

    #[test]
    fn the_quarters_of_a_turn() {
        for (turns, expected) in
            [(0.0, (1.0, 0.0)), (0.25, (0.0, 1.0)), (0.5, (-1.0, 0.0)), (0.75, (0.0, -1.0))]
        {
            for whole in [-2.0, 0.0, 7.0] {
                let (cos, sin) = cos_sin(turns + whole);
                assert!((cos - expected.0).abs() < 3e-7 && (sin - expected.1).abs() < 3e-7, "{turns}");
                let (cos, sin) = cos_sin_exact(turns + whole);
                assert!(
                    (cos - f64::from(expected.0)).abs() < 1e-15
                        && (sin - f64::from(expected.1)).abs() < 1e-15
                );
            }
        }
    }

    #[test]
    fn the_exact_pair_is_cosine_then_sine() {
        let (cos, sin) = cos_sin_exact(1_000_000.0 + 1.0 / 6.0);
        assert!((cos - 0.5).abs() < 1e-9 && (sin - 0.75_f64.sqrt()).abs() < 1e-9);
    }
}
