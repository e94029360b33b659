//! The polynomials that stand for sine and cosine.
//!
//! x = (1.02 f − 0.5) · 2π runs from −π to 1.04 π and not from −π to π: the text multiplies before it subtracts.
//! Because of the −0.5, s ≈ −sin 2πf and q ≈ −cos 2πf.
//!
//! # Why the printed coefficient is no mistake by itself
//!
//! The text prints −0.16161616 where the series has −1/6. Its comment calls the factor 1.02 "a fixup to make
//! the edges of the clamped sin wave match up again"; the two are a matched pair. From the end of one period
//! to the start of the next the polynomial jumps by
//!
//! | coefficient of x³ | factor | jump |
//! | --- | --- | --- |
//! | −0.16161616 | 1.02 | 0.0259 |
//! | −1/6 | 1.02 | 0.3069 |
//! | −0.16161616 | 1 | 0.1628 |
//! | −1/6 | 1 | 0.1504 |
//!
//! so whoever mends one of them alone makes the surface pop, and whoever mends both exchanges a small jump for a
//! large one: what four terms of the true series lack at ±π.
//!
//! # What mends it
//!
//! The series is poor only far from 0, and no sine needs it there: sin x = sin(±π − x) and cos x = −cos(±π − x).
//! [`Taylor::Mended`] has the true coefficients, a factor of 1, and folds x beyond a quarter turn back into ±π/2
//! before the polynomials see it. There they are off by 1.57e-4 (sine) and 2.47e-5 (cosine) at most, both at π/2.
//! At ±π the polynomials see 0, so one period goes over into the next without a jump. Where x is folded the sine
//! goes on, too; the cosine steps by twice its error.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Which polynomials stand for sine and cosine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Taylor {
    /// The constants of the text: −0.16161616 for −1/6, and phases stretched by 1.02.
    #[default]
    Printed,
    /// The true coefficients of both series to the same degree, phases as they are, and x folded into ±π/2. Off
    /// by up to 1.57e-4 (sine) and 2.47e-5 (cosine), and without a jump where a period ends.
    Mended,
}

impl Taylor {
    /// The numbers behind the choice: what a shader is handed.
    pub const fn series(self) -> Series {
        match self {
            Taylor::Printed => Series {
                stretch: 1.02,
                sine: [1.0, -0.161_616_16, 0.008_333_3, -0.000_198_41],
                cosine: [-0.5, 0.041_666_666, -0.001_388_888_9, 0.000_024_801_587],
                folds: false,
            },
            Taylor::Mended => Series {
                stretch: 1.0,
                sine: [1.0, -1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0],
                cosine: [-0.5, 1.0 / 24.0, -1.0 / 720.0, 1.0 / 40320.0],
                folds: true,
            },
        }
    }
}

/// The constants of the polynomials.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Series {
    /// What fract(phase) is multiplied by before 0.5 is taken off; c10.x.
    pub stretch: f64,
    /// The coefficients of x, x³, x⁵ and x⁷; c2.
    pub sine: [f64; 4],
    /// The coefficients of x², x⁴, x⁶ and x⁸, beside the constant 1; c3. The text's comments have the opposite
    /// signs; its values are these.
    pub cosine: [f64; 4],
    /// Whether x beyond a quarter turn is replaced by ±π − x before the polynomials, and the cosine's sign
    /// turned. The text does no such thing. It makes sense with a `stretch` of 1 only.
    pub folds: bool,
}

impl Series {
    /// x in radians for a phase in turns: see [`range_reduced`].
    pub fn range_reduced(&self, phase_turns: f64) -> f64 {
        (super::fract(phase_turns) * self.stretch - 0.5) * TAU
    }

    /// What the polynomials see of `x` (radians, |x| ≤ π), and the sign of cosine that goes with it.
    fn folded(&self, x: f64) -> (f64, f64) {
        if self.folds && x.abs() > FRAC_PI_2 { (PI.copysign(x) - x, -1.0) } else { (x, 1.0) }
    }

    /// The sine of `x` by its polynomial.
    pub fn sine(&self, x: f64) -> f64 {
        let [c1, c3, c5, c7] = self.sine;
        let (x, _) = self.folded(x);
        let y = x * x;
        x * (c1 + y * (c3 + y * (c5 + y * c7)))
    }

    /// The cosine of `x` by its polynomial.
    pub fn cosine(&self, x: f64) -> f64 {
        let [c2, c4, c6, c8] = self.cosine;
        let (x, sign) = self.folded(x);
        let y = x * x;
        sign * (1.0 + y * (c2 + y * (c4 + y * (c6 + y * c8))))
    }

    /// The derivative of [`sine`](Self::sine), which is close to [`cosine`](Self::cosine) but not equal.
    pub fn sine_derivative(&self, x: f64) -> f64 {
        let [c1, c3, c5, c7] = self.sine;
        // Where x is folded, what the polynomial sees falls as x grows.
        let (x, sign) = self.folded(x);
        let y = x * x;
        sign * (c1 + y * (3.0 * c3 + y * (5.0 * c5 + y * 7.0 * c7)))
    }

    /// dx/dp, the radians that x grows by in a turn of the phase.
    pub fn radians_per_turn(&self) -> f64 {
        TAU * self.stretch
    }

    /// The ends of what the polynomials see over one period. They see all between them equally often: once, or
    /// twice where x is folded.
    fn range(&self) -> [f64; 2] {
        if self.folds { [-FRAC_PI_2, FRAC_PI_2] } else { [-0.5 * TAU, (self.stretch - 0.5) * TAU] }
    }

    /// The largest |sine| over a period, rounded up in the fifth digit.
    pub(super) fn max_sine(&self) -> f64 {
        // The extremes lie flat between 1.5 and 1.7, where steps of 1e-4 miss them by less than 1e-8.
        let extreme = (15_000..17_000).map(|i| self.sine(f64::from(i) * 1e-4)).fold(0.0, f64::max);
        extreme * (1.0 + 1e-6)
    }

    /// The variance of the sine over a period, by the integrals of its powers.
    pub(super) fn sine_variance(&self) -> f64 {
        let [from, to] = self.range();
        let mean_of_power = |n: i32| (to.powi(n + 1) - from.powi(n + 1)) / (f64::from(n + 1) * (to - from));
        let (mut mean, mut square) = (0.0, 0.0);
        for (i, a) in (0..).zip(self.sine) {
            mean += a * mean_of_power(2 * i + 1);
            for (j, b) in (0..).zip(self.sine) {
                square += a * b * mean_of_power(2 * i + 2 * j + 2);
            }
        }
        square - mean * mean
    }
}

/// x in radians for a phase in turns, with the text's constants: (1.02 fract(p) − 0.5) · 2π, from −π to below
/// 3.267256 (ATI, ShaderX 2002).
pub fn range_reduced(phase_turns: f64) -> f64 {
    Taylor::Printed.series().range_reduced(phase_turns)
}

/// The text's polynomial for the sine of `x` (radians, |x| ≤ 3.27), off by 0.0865 at most for |x| ≤ π.
pub fn taylor_sine(x: f64) -> f64 {
    Taylor::Printed.series().sine(x)
}

/// The text's polynomial for the cosine of `x` (radians, |x| ≤ 3.27), off by 0.0240 at most for |x| ≤ π.
pub fn taylor_cosine(x: f64) -> f64 {
    Taylor::Printed.series().cosine(x)
}
