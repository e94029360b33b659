//! A spectrum over frequency, spread over directions.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | S(ω), S(k) | energy over frequency and over the wave number, S(k) = S(ω) c_g | m²·s/rad, m³/rad |
//! | D(ω, θ) | share of the energy per angle θ from the mean direction | 1/rad |
//! | c_g | dω/dk, from the dispersion | m/s |
//! | Ψ(k) | S(ω) D(ω, θ) c_g/k | m⁴ |
//!
//! Ψ d²k = S(ω) D dω dθ, since d²k = k dk dθ and dω = c_g dk. So the integral of Ψ over the plane is m0, over
//! any depth.
//!
//! A sea asks for the density of some hundred thousand wave vectors. What depends on the wave number alone is
//! therefore calculated once, over ln k, and interpolated linearly, to 1e-4; what depends on the direction costs
//! a logarithm and an exponential. Outside the table the formulas answer.

use super::{Omnidirectional, WaveSpectrum};
use crate::dispersion::Dispersion;
use crate::error::{ParameterError, check};
use crate::spreading::{Distribution, Lobe, SeaWave, Spread, ln_half};
use glam::DVec2;

mod table;
#[cfg(test)]
mod tests;

use table::{Row, Table};

/// What a [`Directional`] spectrum is made from, beside its energy over frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DirectionalParameters {
    /// The law of the spread and its swell.
    pub spread: Spread,
    /// The unit vector that the waves travel towards on the mean (`.x` east, `.y` south); see
    /// [`toward_from_nautical`](crate::direction::toward_from_nautical).
    pub toward: DVec2,
    /// The water that they run on.
    pub dispersion: Dispersion,
}

/// Energy over frequency × spreading over directions; see the [module](self).
#[derive(Debug, Clone)]
pub struct Directional<O> {
    omnidirectional: O,
    parameters: DirectionalParameters,
    peak_angular_frequency: f64,
    peak_wave_number: f64,
    /// The shape of every distribution, whose number is in the table.
    lobe: Lobe,
    table: Table,
}

impl<O: Omnidirectional> Directional<O> {
    /// The spectrum with the energy of `omnidirectional`, or which of `parameters` is out of its range.
    ///
    /// # Errors
    ///
    /// If the direction is not of length 1, or the spread cannot be used.
    pub fn new(omnidirectional: O, parameters: DirectionalParameters) -> Result<Self, ParameterError> {
        check("toward", parameters.toward.length(), "a vector of length 1", |len| (len - 1.0).abs() < 1e-6)?;
        parameters.spread.check()?;
        let peak_angular_frequency = omnidirectional.peak_angular_frequency();
        let peak_wave_number = parameters.dispersion.wave_number(peak_angular_frequency);
        let mut spectrum = Self {
            omnidirectional,
            parameters,
            peak_angular_frequency,
            peak_wave_number,
            lobe: Lobe::CosSquared,
            table: Table::default(),
        };
        spectrum.lobe = spectrum.distribution(peak_wave_number).lobe;
        let breaks = parameters.spread.spreading.breaks();
        let breaks =
            breaks.iter().map(|ratio| parameters.dispersion.wave_number(ratio * peak_angular_frequency));
        spectrum.table = Table::new(peak_wave_number, breaks, |k| spectrum.row(k));
        Ok(spectrum)
    }

    /// The energy over frequency.
    pub fn omnidirectional(&self) -> &O {
        &self.omnidirectional
    }

    /// Spread, mean direction and water.
    pub fn parameters(&self) -> &DirectionalParameters {
        &self.parameters
    }

    /// D at the wave number `k` > 0 in rad/m.
    pub fn distribution(&self, k: f64) -> Distribution {
        let omega = self.parameters.dispersion.angular_frequency(k);
        self.parameters.spread.at(&SeaWave {
            frequency_ratio: omega / self.peak_angular_frequency,
            wave_number: k,
            peak_wave_number: self.peak_wave_number,
            inverse_wave_age: self.omnidirectional.inverse_wave_age(),
        })
    }

    /// Everything at `k` that does not depend on the direction.
    fn row(&self, k: f64) -> Row {
        let distribution = self.distribution(k);
        let density_m3 = self.omnidirectional.wave_number_density_m3(k, &self.parameters.dispersion);
        let share = density_m3 / self.omnidirectional.variance_m2() / k;
        Row {
            // A flat sea has no shares; it never asks for them.
            ln_scale: libm::log(share.max(f64::MIN_POSITIVE)) + distribution.ln_scale,
            parameter: distribution.lobe.parameter(),
            swell_exponent: distribution.swell_exponent,
        }
    }
}

impl<O: Omnidirectional> WaveSpectrum for Directional<O> {
    fn density_m4(&self, k: DVec2) -> f64 {
        let k2 = k.length_squared();
        let variance_m2 = self.omnidirectional.variance_m2();
        if k2 == 0.0 || variance_m2 == 0.0 {
            return 0.0;
        }
        let row = match self.table.at(0.5 * libm::log(k2)) {
            Some(row) => row,
            None => self.row(k2.sqrt()),
        };
        let toward = self.parameters.toward;
        let inverse = 1.0 / k2.sqrt();
        let (along, across) = (k.dot(toward) * inverse, k.perp_dot(toward).abs() * inverse);
        let swell = if row.swell_exponent > 0.0 { row.swell_exponent * ln_half(along, across) } else { 0.0 };
        let lobe = self.lobe.with(row.parameter);
        variance_m2 * lobe.times_exp(row.ln_scale + swell, along, across)
    }

    fn variance_m2(&self) -> f64 {
        self.omnidirectional.variance_m2()
    }

    fn omnidirectional_m3(&self, k: f64) -> f64 {
        self.omnidirectional.wave_number_density_m3(k, &self.parameters.dispersion)
    }
}
