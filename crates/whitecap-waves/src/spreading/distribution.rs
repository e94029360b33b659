//! D(θ) at one frequency.

use std::f64::consts::{FRAC_PI_2, PI};

/// The shape of D(θ) before swell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Lobe {
    /// cos²θ on |θ| < π/2.
    CosSquared,
    /// cos²ˢ(θ/2).
    HalfCosine {
        /// s.
        exponent: f64,
    },
    /// sech²(βθ).
    Sech {
        /// β.
        sharpness: f64,
    },
    /// 1 + Δ cos 2θ on |θ| < π/2.
    TwoWay {
        /// Δ, −1..=1.
        ratio: f64,
    },
}

/// D(θ) of the waves of one frequency, normalised over the full circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distribution {
    pub(crate) lobe: Lobe,
    /// s_ξ, which multiplies the lobe by cos²ˢ(θ/2); 0 for half cosines, which have it in their own exponent.
    pub(crate) swell_exponent: f64,
    /// ln of what makes ∫D dθ = 1.
    pub(crate) ln_scale: f64,
}

impl Lobe {
    /// cos²ˢ(θ/2) with an s that a law gave, kept to where D is a function.
    pub(super) fn half_cosine(exponent: f64) -> Self {
        Self::HalfCosine { exponent: exponent.clamp(0.0, 1e6) }
    }

    /// The number that goes with the shape: s, β, Δ, or nothing.
    pub(crate) fn parameter(&self) -> f64 {
        match *self {
            Self::CosSquared => 0.0,
            Self::HalfCosine { exponent } => exponent,
            Self::Sech { sharpness } => sharpness,
            Self::TwoWay { ratio } => ratio,
        }
    }

    /// The same shape with another number.
    pub(crate) fn with(&self, parameter: f64) -> Self {
        match self {
            Self::CosSquared => Self::CosSquared,
            Self::HalfCosine { .. } => Self::HalfCosine { exponent: parameter },
            Self::Sech { .. } => Self::Sech { sharpness: parameter },
            Self::TwoWay { .. } => Self::TwoWay { ratio: parameter },
        }
    }

    /// The bare shape, 1 at most (2 for `TwoWay`), times e^`ln_factor`, for the direction `along` = cos θ,
    /// `across` = |sin θ|.
    #[inline]
    pub(crate) fn times_exp(&self, ln_factor: f64, along: f64, across: f64) -> f64 {
        match *self {
            Self::CosSquared => {
                if along > 0.0 {
                    along * along * libm::exp(ln_factor)
                } else {
                    0.0
                }
            }
            Self::HalfCosine { exponent } => libm::exp(ln_factor + exponent * ln_half(along, across)),
            Self::Sech { sharpness } => {
                // sech² = 4e/(1 + e)², e = exp(−2βθ), which cannot overflow.
                let e = libm::exp(-2.0 * sharpness * libm::atan2(across, along));
                4.0 * e / ((1.0 + e) * (1.0 + e)) * libm::exp(ln_factor)
            }
            Self::TwoWay { ratio } => {
                let cos_2 = (along - across) * (along + across);
                if along > 0.0 { (1.0 + ratio * cos_2) * libm::exp(ln_factor) } else { 0.0 }
            }
        }
    }
}

/// ln cos²(θ/2) = ln((1 + cos θ)/2) = ln(sin²θ/(2 (1 − cos θ))), by the form that keeps its digits; never −∞.
#[inline]
pub(crate) fn ln_half(along: f64, across: f64) -> f64 {
    let half = if along > -0.5 { 0.5 * (1.0 + along) } else { 0.5 * across * across / (1.0 - along) };
    libm::log(half.max(1e-300))
}

impl Distribution {
    pub(super) fn new(lobe: Lobe, swell_exponent: f64) -> Self {
        if let Lobe::HalfCosine { exponent } = lobe {
            let exponent = exponent + swell_exponent;
            return Self {
                lobe: Lobe::HalfCosine { exponent },
                swell_exponent: 0.0,
                ln_scale: ln_half_cosine_scale(exponent),
            };
        }
        let ln_scale = if swell_exponent > 0.0 {
            ln_numerical_scale(&lobe, swell_exponent)
        } else {
            match lobe {
                Lobe::Sech { sharpness } => libm::log(sharpness / (2.0 * libm::tanh(sharpness * PI))),
                Lobe::TwoWay { .. } => -libm::log(PI),
                Lobe::CosSquared | Lobe::HalfCosine { .. } => -libm::log(FRAC_PI_2),
            }
        };
        Self { lobe, swell_exponent, ln_scale }
    }

    /// D(`theta`) ≥ 0 per radian, for an angle in radians from the mean direction, −π..=π.
    pub fn density_per_rad(&self, theta: f64) -> f64 {
        let (sin, cos) = libm::sincos(theta);
        let swell =
            if self.swell_exponent > 0.0 { self.swell_exponent * ln_half(cos, sin.abs()) } else { 0.0 };
        self.lobe.times_exp(self.ln_scale + swell, cos, sin.abs())
    }
}

/// ln Q(s), Q = Γ(s + 1)/(2√π Γ(s + ½)).
fn ln_half_cosine_scale(s: f64) -> f64 {
    // Beyond, the difference of the two logarithms loses digits, and Stirling's series is exact:
    // Γ(s + 1)/Γ(s + ½) = √s (1 + 1/(8s) + 1/(128s²) − …).
    let ln_ratio = if s > 1e3 {
        0.5 * libm::log(s) + libm::log1p((1.0 + 1.0 / (16.0 * s)) / (8.0 * s))
    } else {
        libm::lgamma(s + 1.0) - libm::lgamma(s + 0.5)
    };
    ln_ratio - libm::log(2.0 * PI.sqrt())
}

/// −ln ∫ lobe · cos²ˢ(θ/2) dθ. The lobes are even, and smooth from 0 to where they end, but for the power of
/// cos(θ/2), which has a cusp at π: Gauss's rule over t with θ = end (1 − (1 − t)²), good to 1e-6.
fn ln_numerical_scale(lobe: &Lobe, swell_exponent: f64) -> f64 {
    let end = match lobe {
        Lobe::CosSquared | Lobe::TwoWay { .. } => FRAC_PI_2,
        Lobe::HalfCosine { .. } | Lobe::Sech { .. } => PI,
    };
    let at = |to_end: f64| {
        let (sin, cos) = libm::sincos(end * (1.0 - to_end * to_end));
        2.0 * end * to_end * lobe.times_exp(swell_exponent * ln_half(cos, sin), cos, sin)
    };
    let pair = |(x, weight): &(f64, f64)| 0.5 * weight * (at(0.5 - 0.5 * x) + at(0.5 + 0.5 * x));
    -libm::log(2.0 * GAUSS.iter().map(pair).sum::<f64>())
}

/// The positive nodes on −1..=1 and the weights of Gauss and Legendre's rule of 24 points.
const GAUSS: [(f64, f64); 12] = [
    (0.06405689286260563, 0.127938195346752),
    (0.1911188674736163, 0.1258374563468282),
    (0.3150426796961634, 0.1216704729278033),
    (0.4337935076260451, 0.1155056680537255),
    (0.5454214713888396, 0.1074442701159656),
    (0.6480936519369755, 0.09761865210411393),
    (0.7401241915785544, 0.0861901615319532),
    (0.8200019859739029, 0.07334648141108016),
    (0.8864155270044011, 0.05929858491543636),
    (0.9382745520027328, 0.04427743881741941),
    (0.9747285559713095, 0.02853138862893356),
    (0.9951872199970213, 0.01234122979998869),
];
