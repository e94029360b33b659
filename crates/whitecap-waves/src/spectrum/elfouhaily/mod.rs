//! The unified spectrum of long and short waves (Elfouhaily, Chapron, Katsaros and Vandemark, *J. Geophys. Res.*
//! 102, 1997), from the swell of a storm to ripples of a few millimetres.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | U | wind 10 m above the sea | m/s |
//! | Ω | U/cp, inverse wave age: 0.84 for a fully developed sea, up to 5 for a young one | |
//! | k, kp | wave number, that of the peak: kp = g (Ω/U)² | rad/m |
//! | km, cm | 370 rad/m and √(2g/km) ≈ 0.23 m/s, of the slowest wave | |
//! | c, cp | phase speed √(g/k (1 + (k/km)²)), that of the peak U/Ω | m/s |
//! | u* | friction velocity, √0.00144 U | m/s |
//! | γ | 1.7 for Ω < 1, else 1.7 + 6 log₁₀ Ω | |
//! | σ | 0.08 (1 + 4 Ω⁻³) | |
//! | αp, αm | energy of long and of short waves | |
//!
//! S(k) = (Bl + Bh)/k³ with, by their equations 30 to 44,
//!
//! - L = exp(−5/4 (kp/k)²), J = γ^Γ, Γ = exp(−(√(k/kp) − 1)²/(2σ²));
//! - Bl = ½ αp (cp/c) L J exp(−Ω/√10 (√(k/kp) − 1)), αp = 0.006 √Ω;
//! - Bh = ½ αm (cm/c) L J exp(−¼ (k/km − 1)²), αm = 0.01 (1 + a ln(u*/cm)), a = 1 for u* < cm, else 3.
//!
//! L J in Bh follows the authors' later correction: as printed the short waves would not end at the peak.
//! The spectrum is one of wave numbers and brings its own dispersion, ω² = g k (1 + (k/km)²); its S(ω) is by that.

use super::Omnidirectional;
use super::pierson_moskowitz::{check_wind, variance_of_height_m2};
use super::quadrature::integral;
use crate::GRAVITY_MPS2;
use crate::dispersion::Dispersion;
use crate::error::{ParameterError, check};

#[cfg(test)]
mod tests;

/// km in rad/m.
const SLOWEST_WAVE_NUMBER: f64 = 370.0;

/// cm in m/s, as printed.
pub(crate) const SLOWEST_MPS: f64 = 0.23;

/// Ω of the fully developed sea.
pub const FULLY_DEVELOPED: f64 = 0.84;

/// Ω of the youngest sea that the spectrum is of.
pub const YOUNGEST: f64 = 5.0;

/// Ω under a wind over `fetch_m` metres of water: 0.84 tanh((g F/(U² 2.2e4))^0.4)^−0.75 (their equation 37).
pub fn inverse_age(wind_speed_mps: f64, fetch_m: f64) -> f64 {
    let fetch = GRAVITY_MPS2 * fetch_m / (wind_speed_mps * wind_speed_mps);
    FULLY_DEVELOPED * libm::pow(libm::tanh(libm::pow(fetch / 2.2e4, 0.4)), -0.75)
}

/// ω of the greatest S(ω) of the fully developed sea over that of kp, while the peak is far from the ripples.
const DENSEST: f64 = 1.036_76;

/// Elfouhaily's spectrum; see the [module](self).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elfouhaily {
    inverse_wave_age: f64,
    peak_wave_number: f64,
    /// ln γ.
    ln_peak_enhancement: f64,
    /// 1/(2σ²).
    narrowness: f64,
    /// ½ αp cp and ½ αm cm in m/s.
    long: f64,
    short: f64,
    variance_m2: f64,
}

impl Elfouhaily {
    /// The fully developed sea under a wind of U = `wind_speed_mps`, above 0 and at most 100.
    ///
    /// # Errors
    ///
    /// If the wind is out of its range.
    pub fn from_wind(wind_speed_mps: f64) -> Result<Self, ParameterError> {
        Self::from_wind_and_age(wind_speed_mps, FULLY_DEVELOPED)
    }

    /// The sea under that wind with Ω = `inverse_wave_age`, 0.5 to 5.
    ///
    /// # Errors
    ///
    /// If one of them is out of its range.
    pub fn from_wind_and_age(wind_speed_mps: f64, inverse_wave_age: f64) -> Result<Self, ParameterError> {
        check_wind(wind_speed_mps)?;
        check("inverse_wave_age", inverse_wave_age, "from 0.5 to 5", |age| (0.5..=YOUNGEST).contains(&age))?;
        let age = inverse_wave_age;
        let sigma = 0.08 * (1.0 + 4.0 / (age * age * age));
        let gamma = if age < 1.0 { 1.7 } else { 1.7 + 6.0 * libm::log10(age) };
        let friction = libm::log(friction_velocity_mps(wind_speed_mps) / SLOWEST_MPS);
        // In a breath of wind the logarithm says less than no short waves.
        let alpha_m = (0.01 * (1.0 + if friction < 0.0 { friction } else { 3.0 * friction })).max(0.0);
        let mut sea = Self {
            inverse_wave_age: age,
            peak_wave_number: GRAVITY_MPS2 * (age / wind_speed_mps).powi(2),
            ln_peak_enhancement: libm::log(gamma),
            narrowness: 0.5 / (sigma * sigma),
            long: 0.5 * 0.006 * age.sqrt() * wind_speed_mps / age,
            short: 0.5 * alpha_m * SLOWEST_MPS,
            variance_m2: 0.0,
        };
        sea.variance_m2 = integral(sea.peak_wave_number, |k| sea.density_m3(k));
        Ok(sea)
    }

    /// The sea that a wind raises over `fetch_m` metres of water, 1 to 1e8:
    /// [`inverse_age`], at most [`YOUNGEST`].
    ///
    /// # Errors
    ///
    /// If one of them is out of its range.
    pub fn from_wind_and_fetch(wind_speed_mps: f64, fetch_m: f64) -> Result<Self, ParameterError> {
        check_wind(wind_speed_mps)?;
        check("fetch_m", fetch_m, "from 1 to 1e8", |f| (1.0..=1e8).contains(&f))?;
        Self::from_wind_and_age(wind_speed_mps, inverse_age(wind_speed_mps, fetch_m).min(YOUNGEST))
    }

    /// The fully developed sea that is as high as asked for, 0..=100 m: that of the wind whose sea it is, found
    /// by bisection, and scaled by the last 1e-9.
    ///
    /// # Errors
    ///
    /// If the height is out of its range, or no wind up to 100 m/s raises it.
    pub fn from_height(significant_height_m: f64) -> Result<Self, ParameterError> {
        check("significant_height_m", significant_height_m, "from 0 to 100", |h| (0.0..=100.0).contains(&h))?;
        let asked = variance_of_height_m2(significant_height_m);
        let (mut low, mut high) = (0.05_f64, 100.0_f64);
        for _ in 0..40 {
            let middle = (low * high).sqrt();
            if Self::from_wind(middle)?.variance_m2 < asked { low = middle } else { high = middle }
        }
        let sea = Self::from_wind(high)?;
        let factor = asked / sea.variance_m2;
        Ok(Self { long: factor * sea.long, short: factor * sea.short, variance_m2: asked, ..sea })
    }

    /// The shape of the fully developed sea whose greatest S(ω) is at `peak_period_s`, 0.1 to 60 s, as high as asked for,
    /// 0..=100 m: that of the wind U = Ω cp, Ω = 0.84.
    ///
    /// # Errors
    ///
    /// If one of them is out of its range.
    pub fn from_height_and_period(
        significant_height_m: f64,
        peak_period_s: f64,
    ) -> Result<Self, ParameterError> {
        check("significant_height_m", significant_height_m, "from 0 to 100", |h| (0.0..=100.0).contains(&h))?;
        check("peak_period_s", peak_period_s, "from 0.1 to 60", |t| (0.1..=60.0).contains(&t))?;
        let peak = wave_number(std::f64::consts::TAU / (DENSEST * peak_period_s));
        // kp = g (Ω/U)².
        let sea = Self::from_wind((GRAVITY_MPS2 / peak).sqrt() * FULLY_DEVELOPED)?;
        let asked = variance_of_height_m2(significant_height_m);
        let factor = asked / sea.variance_m2;
        Ok(Self { long: factor * sea.long, short: factor * sea.short, variance_m2: asked, ..sea })
    }

    /// S(k) in m³/rad at `k` > 0 in rad/m, by the module's formula.
    pub fn density_m3(&self, k: f64) -> f64 {
        let ratio = k / self.peak_wave_number;
        // exp(−5/4 · 30²) has long been 0.
        if ratio < 1.0 / 30.0 || k > 1e3 * SLOWEST_WAVE_NUMBER.max(self.peak_wave_number) {
            return 0.0;
        }
        let beyond = ratio.sqrt() - 1.0;
        let enhancement = self.ln_peak_enhancement * libm::exp(-beyond * beyond * self.narrowness);
        let peak = libm::exp(enhancement - 1.25 / (ratio * ratio));
        let long = self.long * libm::exp(-self.inverse_wave_age / 10.0_f64.sqrt() * beyond);
        let off = k / SLOWEST_WAVE_NUMBER - 1.0;
        let short = self.short * libm::exp(-0.25 * off * off);
        peak * (long + short) / phase_speed(k) / (k * k * k)
    }

    /// The variance of the slope, in both directions together: ∫ k² S(k) dk.
    pub fn mean_square_slope(&self) -> f64 {
        integral(self.peak_wave_number, |k| k * k * self.density_m3(k))
    }
}

impl Omnidirectional for Elfouhaily {
    /// S(k) dk/dω by the spectrum's own dispersion.
    fn density_m2s(&self, omega: f64) -> f64 {
        let k = wave_number(omega);
        let density = self.density_m3(k);
        if density == 0.0 { 0.0 } else { density / group_speed(k) }
    }

    /// That of kp, at which L and J have their peak; the greatest density is a few percent away.
    fn peak_angular_frequency(&self) -> f64 {
        self.peak_wave_number * phase_speed(self.peak_wave_number)
    }

    fn variance_m2(&self) -> f64 {
        self.variance_m2
    }

    /// S(k) itself, whatever the water: the spectrum was measured over wave numbers.
    fn wave_number_density_m3(&self, k: f64, _: &Dispersion) -> f64 {
        self.density_m3(k)
    }

    fn inverse_wave_age(&self) -> f64 {
        self.inverse_wave_age
    }
}

/// u* in m/s of a wind 10 m above the sea, by the drag coefficient 0.00144.
pub(crate) fn friction_velocity_mps(wind_speed_mps: f64) -> f64 {
    0.00144_f64.sqrt() * wind_speed_mps
}

/// c in m/s at `k` in rad/m.
pub(crate) fn phase_speed(k: f64) -> f64 {
    (GRAVITY_MPS2 / k + GRAVITY_MPS2 * k / (SLOWEST_WAVE_NUMBER * SLOWEST_WAVE_NUMBER)).sqrt()
}

/// dω/dk in m/s: g (1 + 3 (k/km)²)/(2ω).
fn group_speed(k: f64) -> f64 {
    let tension = (k / SLOWEST_WAVE_NUMBER) * (k / SLOWEST_WAVE_NUMBER);
    GRAVITY_MPS2 * (1.0 + 3.0 * tension) / (2.0 * k * phase_speed(k))
}

/// k in rad/m of ω in rad/s: the one real root of k³/km² + k = ω²/g, by the hyperbolic form of Cardano's
/// solution.
fn wave_number(omega: f64) -> f64 {
    let scale = 2.0 * SLOWEST_WAVE_NUMBER / 3.0_f64.sqrt();
    let forced = 1.5 * 3.0_f64.sqrt() * omega * omega / (GRAVITY_MPS2 * SLOWEST_WAVE_NUMBER);
    scale * libm::sinh(libm::asinh(forced) / 3.0)
}
