//! How much energy a spectrum has at which length of wave.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | S(k) | ∮Ψ k dθ, variance density over wave number alone | m³ |

use super::WaveSpectrum;
use crate::model::spectral::Band;

/// The wave numbers that are looked at, in rad/m: waves from 60 km to 0.6 mm.
const LOWEST: f64 = Band::OF_SEAS.from;
const DECADES: f64 = 8.0;
const STEPS: usize = 1600;

/// S(k) of a spectrum on a logarithmic scale of k, to plan tiles by: good to a per cent or so.
pub struct Profile {
    /// S(k) k, the variance in m² to a unit of ln k, at the middle of each step.
    energy_m2: Vec<f64>,
}

impl Profile {
    /// The profile of one spectrum.
    pub fn of(spectrum: &impl WaveSpectrum) -> Self {
        let energy = |i: usize| {
            let k = wave_number(i as f64 + 0.5);
            k * spectrum.omnidirectional_m3(k)
        };
        Self { energy_m2: (0..STEPS).map(energy).collect() }
    }

    /// The profile of several systems together.
    pub fn of_sum<S: WaveSpectrum>(systems: &[S]) -> Self {
        Self::sum(&systems.iter().map(Self::of).collect::<Vec<_>>())
    }

    /// The profile of several systems together, from their own.
    pub fn sum(profiles: &[Self]) -> Self {
        let mut energy_m2 = vec![0.0; STEPS];
        for profile in profiles {
            for (sum, energy) in energy_m2.iter_mut().zip(&profile.energy_m2) {
                *sum += energy;
            }
        }
        Self { energy_m2 }
    }

    /// The variance of the waves of `band`, in m².
    pub fn variance_m2(&self, band: Band) -> f64 {
        self.integrate(band, |_| 1.0)
    }

    /// The mean square slope of the waves of `band`, along both axes together.
    pub fn mean_square_slope(&self, band: Band) -> f64 {
        self.integrate(band, |k| k * k)
    }

    /// The k in rad/m at which S(k) is greatest.
    pub fn peak_wave_number(&self) -> f64 {
        let density = |i: usize| self.energy_m2[i] / wave_number(i as f64 + 0.5);
        let peak = (0..STEPS).max_by(|&a, &b| density(a).total_cmp(&density(b))).unwrap_or(0);
        // The top of the parabola through the greatest and its neighbours.
        let mut step = peak as f64 + 0.5;
        if (1..STEPS - 1).contains(&peak) {
            let [before, top, after] = [peak - 1, peak, peak + 1].map(density);
            let bend = before - 2.0 * top + after;
            if bend < 0.0 {
                step += 0.5 * (before - after) / bend;
            }
        }
        wave_number(step)
    }

    /// The k in rad/m below which `fraction` of the energy lies.
    pub fn wave_number_below(&self, fraction: f64) -> f64 {
        let total: f64 = self.energy_m2.iter().sum();
        let mut sum = 0.0;
        let found = self.energy_m2.iter().position(|energy| {
            sum += energy;
            sum >= fraction * total
        });
        wave_number(found.unwrap_or(STEPS) as f64)
    }

    /// The k in rad/m beyond which there are no waves: less than a millionth of the mean square slope.
    pub fn last_wave_number(&self) -> f64 {
        let slopes = |i: usize| self.energy_m2[i] * wave_number(i as f64 + 0.5).powi(2);
        let least = 1e-6 * (0..STEPS).map(slopes).sum::<f64>();
        let mut beyond = 0.0;
        let last = (0..STEPS).rev().find(|&i| {
            beyond += slopes(i);
            beyond > least
        });
        wave_number(last.map_or(STEPS, |last| last + 1) as f64)
    }

    fn integrate(&self, band: Band, weight: impl Fn(f64) -> f64) -> f64 {
        let step = DECADES * std::f64::consts::LN_10 / STEPS as f64;
        // An edge of the band takes its share of the step that it cuts.
        let place = |k: f64| ((k / LOWEST).log10() * STEPS as f64 / DECADES).clamp(0.0, STEPS as f64);
        let (from, to) = (place(band.from), place(band.to));
        let energies = self.energy_m2.iter().enumerate();
        let of_step = |(i, energy): (usize, &f64)| {
            let inside = (to.min(i as f64 + 1.0) - from.max(i as f64)).max(0.0);
            energy * weight(wave_number(i as f64 + 0.5)) * inside * step
        };
        energies.map(of_step).sum()
    }
}

fn wave_number(step: f64) -> f64 {
    LOWEST * libm::exp10(DECADES * step / STEPS as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::phillips::{Phillips, PhillipsParameters};
    use glam::DVec2;

    /// Phillips: S(k) ∝ exp(−1/(kL)²) k⁻³, whose peak is at kL = √(2/3), and of which exp(−1/(kL)²) lies below k.
    #[test]
    fn a_phillips_sea() {
        let wind = PhillipsParameters {
            wind_speed_mps: 10.0,
            toward: DVec2::X,
            significant_height_m: Some(4.0),
            opposing_energy: 0.3,
            small_wave_cutoff_m: 0.0,
        };
        let profile = Profile::of(&Phillips::new(wind).unwrap());
        let length = 100.0 / crate::GRAVITY_MPS2;
        assert!((profile.variance_m2(Band::WHOLE) - 1.0).abs() < 2e-3);
        assert!((profile.peak_wave_number() * length / (2.0_f64 / 3.0).sqrt() - 1.0).abs() < 1e-3);
        let median = profile.wave_number_below(0.5) * length;
        assert!((median * 2.0_f64.ln().sqrt() - 1.0).abs() < 0.01, "{median}");
        let below = profile.variance_m2(Band { from: 0.0, to: 2.0 / length });
        assert!((below - (-0.25_f64).exp()).abs() < 2e-3, "{below}");
        let band = Band { from: 2.0 / length, to: 3.0 / length };
        let slope = profile.mean_square_slope(band) / profile.variance_m2(band) * length * length;
        assert!((4.0..9.0).contains(&slope), "{slope}");
    }
}
