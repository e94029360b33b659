//! How the waves of one frequency are spread over directions.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | θ | angle between a wave and the mean direction, −π..=π | rad |
//! | D(θ) | share of the energy per angle; ∫D dθ = 1 over the full circle | 1/rad |
//! | x | ω/ωp, frequency over that of the peak | |
//! | Ω | U10 ωp/g, inverse wave age | |
//! | s | exponent of cos²ˢ(θ/2) | |
//! | ξ | swell, 0..=1 | |
//!
//! | spreading | D(θ) | source |
//! | --- | --- | --- |
//! | cos² | (2/π) cos²θ for \|θ\| < π/2 | Pierson, Neumann and James 1955 |
//! | cos²ˢ | Q(s) cos²ˢ(θ/2) with one s | Longuet-Higgins, Cartwright and Smith 1963 |
//! | Mitsuyasu | the same, s = 11.5 Ω^−2.5 · x⁵ up to the peak, x^−2.5 beyond | Mitsuyasu et al. 1975, eqs. 28–30 |
//! | Hasselmann | the same, s = 6.97 x^4.06 up to the peak, 9.77 x^(−2.33 − 1.45 (Ω − 1.17)) beyond | Hasselmann, Dunckel and Ewing 1980 |
//! | Donelan–Banner | β/(2 tanh βπ) sech²βθ | Donelan, Hamilton and Hui 1985; Banner 1990 |
//! | Elfouhaily | (1 + Δ cos 2θ)/π for \|θ\| < π/2 | Elfouhaily et al. 1997, eqs. 49 and 57 |
//!
//! Q(s) = Γ(s + 1)/(2√π Γ(s + ½)), by logarithms of Γ, so that no s overflows.
//!
//! Elfouhaily's function is 2π-normalised and symmetric: by itself it sends as much energy against the wind as
//! with it, since it was made for radar images that cannot tell. Here it is kept to the half plane down wind and
//! doubled. The integral of cos 2θ over the half circle is 0, so that is its exact normalisation.
//!
//! # Swell
//!
//! Waves that have travelled far are nearly parallel. [`Spread::swell`] = ξ multiplies D by cos²ˢ(θ/2) with
//! s_ξ = 16 tanh(1/x) ξ² and normalises again (Horvath, *Empirical Directional Wave Spectra for Computer
//! Graphics*, DigiPro 2015, eq. 44): long waves gather more than short ones. For the cos²ˢ family the exponents
//! add.

use crate::error::{ParameterError, check};

mod distribution;
#[cfg(test)]
mod tests;

pub use distribution::Distribution;
pub(crate) use distribution::{Lobe, ln_half};

/// A law for the spread of directions; see the [module](self).
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Spreading {
    /// cos², the same at every frequency, nothing against the wind.
    CosSquared,
    /// cos²ˢ(θ/2) with one s.
    Cos2s {
        /// s, 0 for all directions alike to 1e5 for waves as parallel as they get.
        exponent: f64,
    },
    /// Mitsuyasu's.
    Mitsuyasu,
    /// Hasselmann's.
    Hasselmann,
    /// Donelan's, with Banner's continuation to short waves.
    DonelanBanner,
    /// Elfouhaily's, down wind.
    Elfouhaily,
}

/// A spreading and how far it is narrowed to swell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// The law.
    pub spreading: Spreading,
    /// ξ, 0 for a wind sea to 1 for the longest swell.
    pub swell: f64,
}

/// A wave and the sea that it belongs to, as far as spreading depends on them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeaWave {
    /// x = ω/ωp, above 0.
    pub frequency_ratio: f64,
    /// k of the wave in rad/m, above 0.
    pub wave_number: f64,
    /// k of the peak in rad/m, above 0.
    pub peak_wave_number: f64,
    /// Ω = U10 ωp/g, above 0.
    pub inverse_wave_age: f64,
}

impl Spread {
    /// Whether the law can be used: s from 0 to 1e5, ξ from 0 to 1.
    ///
    /// # Errors
    ///
    /// If one of them is out of its range.
    pub fn check(&self) -> Result<(), ParameterError> {
        if let Spreading::Cos2s { exponent } = self.spreading {
            check("cos2s", exponent, "from 0 to 1e5", |s| (0.0..=1e5).contains(&s))?;
        }
        check("swell", self.swell, "from 0 to 1", |xi| (0.0..=1.0).contains(&xi))
    }

    /// D at one wave of a sea.
    pub fn at(&self, wave: &SeaWave) -> Distribution {
        // 1/x at the lowest frequencies may overflow, which tanh does not mind.
        let swell = 16.0 * libm::tanh(1.0 / wave.frequency_ratio) * self.swell * self.swell;
        Distribution::new(self.spreading.lobe(wave), swell)
    }
}

impl Spreading {
    /// The frequency ratios at which the law has a kink or a step, other than 1.
    pub(crate) fn breaks(&self) -> &'static [f64] {
        match self {
            Self::DonelanBanner => &[0.56, 0.95, 1.6],
            _ => &[],
        }
    }

    fn lobe(&self, wave: &SeaWave) -> Lobe {
        let &SeaWave { frequency_ratio: x, inverse_wave_age: age, .. } = wave;
        match self {
            Self::CosSquared => Lobe::CosSquared,
            Self::Cos2s { exponent } => Lobe::HalfCosine { exponent: *exponent },
            Self::Mitsuyasu => {
                let at_peak = 11.5 * libm::pow(age, -2.5);
                Lobe::half_cosine(at_peak * libm::pow(x, if x <= 1.0 { 5.0 } else { -2.5 }))
            }
            Self::Hasselmann => Lobe::half_cosine(if x <= 1.0 {
                6.97 * libm::pow(x, 4.06)
            } else {
                9.77 * libm::pow(x, -2.33 - 1.45 * (age - 1.17))
            }),
            Self::DonelanBanner => Lobe::Sech { sharpness: donelan_banner(x) },
            Self::Elfouhaily => Lobe::TwoWay { ratio: elfouhaily(wave) },
        }
    }
}

/// β of Donelan and Banner at `x` = ω/ωp: 2.61 x^1.3 from 0.56 to 0.95, 2.28 x^−1.3 to 1.6 (Donelan, Hamilton
/// and Hui 1985, section 6), 10^(−0.4 + 0.8393 exp(−0.567 ln x²)) beyond (Banner 1990). Nothing was measured
/// below 0.56, where the value of 0.56 is kept.
fn donelan_banner(x: f64) -> f64 {
    if x <= 0.95 {
        2.61 * libm::pow(x.max(0.56), 1.3)
    } else if x <= 1.6 {
        2.28 * libm::pow(x, -1.3)
    } else {
        // exp(−0.567 ln x²) = x^−1.134.
        libm::exp(std::f64::consts::LN_10 * (-0.4 + 0.8393 * libm::pow(x, -1.134)))
    }
}

/// Δ of Elfouhaily et al. (1997), eqs. 57 to 59: tanh(ln 2/4 + 4 (c/cp)^2.5 + 0.13 (u*/cm)(cm/c)^2.5), by the
/// speeds of their own dispersion, c = √(g/k (1 + (k/km)²)).
fn elfouhaily(wave: &SeaWave) -> f64 {
    use crate::spectrum::elfouhaily::{SLOWEST_MPS, friction_velocity_mps, phase_speed};
    let (c, peak) = (phase_speed(wave.wave_number), phase_speed(wave.peak_wave_number));
    let friction = friction_velocity_mps(wave.inverse_wave_age * peak) / SLOWEST_MPS;
    let power = |ratio: f64| libm::pow(ratio, 2.5);
    libm::tanh(
        std::f64::consts::LN_2 / 4.0 + 4.0 * power(c / peak) + 0.13 * friction * power(SLOWEST_MPS / c),
    )
}
