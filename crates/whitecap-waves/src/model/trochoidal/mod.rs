//! A few dozen trochoids: the wave of Gerstner, many times over.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | N | number of waves | |
//! | k, a, φ | wave vector, amplitude, phase of one wave | rad/m, m, turns |
//! | ω | its angular frequency | rad/s |
//! | θ | k·x − ωt + 2πφ at the rest point x | rad |
//! | λ | choppiness | |
//! | d | depth of the water | m |
//! | m0 | variance of the height, ½Σa² | m² |
//!
//! Height Σ a cos θ, displacement −Σ λ coth(kd) (k/|k|) a sin θ: water circles, forward over the crest, on orbits
//! that a bottom flattens. For one wave in deep water and λ = 1 this is the exact wave of Gerstner (1802; Lamb,
//! *Hydrodynamics*, art. 251); a sum of several is the first order of the Lagrangian solution.
//!
//! # Which waves
//!
//! All have the same energy, a² = 2 m0/N, so that none is wasted. Their lengths are the quantiles of the energy
//! over ln k at (i + ½)/N, their directions those of the energy over directions at that k, at the fractions
//! {(i + ½)/golden ratio}: the additive sequence of lowest discrepancy, which gives neighbouring lengths different
//! directions. Only the phases are random. The surface never repeats, unlike a tile.

use super::spectral::sample::Sums;
use super::{Surface, SurfacePoint};
use crate::dispersion::Dispersion;
use crate::error::{ParameterError, check};
use crate::random::uniform;
use crate::spectrum::WaveSpectrum;
use crate::turns::cos_sin_exact;
use glam::{DVec2, DVec3};
use rand_chacha::ChaCha8Rng;
use rand_core::SeedableRng;
use std::f64::consts::TAU;

mod quantiles;
#[cfg(test)]
mod tests;

use quantiles::PolarEnergy;

/// What a [`Trochoidal`] sea is made from, beside its spectra.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrochoidalParameters {
    /// N, from 1 to 64.
    pub waves: usize,
    /// λ, from 0 to 10: 0 for waves that only rise and fall, 1 for trochoids.
    pub choppiness: f64,
    /// Which of the random seas with these parameters.
    pub seed: u64,
    /// The water: it sets the waves' speeds and the shape of their orbits.
    pub dispersion: Dispersion,
}

/// One of the waves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trochoid {
    /// k in rad/m, pointing where the wave travels.
    pub wave_vector: DVec2,
    /// a in metres.
    pub amplitude_m: f64,
    /// ω/2π in turns per second.
    pub frequency_hz: f64,
    /// φ in turns, 0..1.
    pub phase_turns: f64,
    /// coth(kd): the horizontal radius of the orbit over the vertical one.
    pub orbit_ratio: f64,
    /// λ coth(kd): the same as it is drawn.
    pub lean: f64,
}

/// A sum of trochoidal waves of equal energy; see the [module](self).
#[derive(Debug, Clone, PartialEq)]
pub struct Trochoidal {
    waves: Vec<Trochoid>,
    variance_m2: f64,
}

/// Chosen so that no other random numbers of this crate begin alike for the same seed.
const STREAM: u64 = 0x7472_6f63;

/// The fractional part of the golden ratio, which is also its inverse.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

impl Trochoidal {
    /// The sea whose energy is the sum of `systems`: spectra by value, by reference or boxed. Without any it is
    /// flat.
    ///
    /// # Errors
    ///
    /// If a parameter is out of its range, or the spectra have no energy between 1e-4 and 1e4 rad/m though they
    /// say so.
    pub fn new<S: WaveSpectrum>(
        parameters: TrochoidalParameters,
        systems: &[S],
    ) -> Result<Self, ParameterError> {
        let TrochoidalParameters { waves: count, choppiness, seed, dispersion } = parameters;
        check("waves", count as f64, "from 1 to 64", |n| (1.0..=64.0).contains(&n))?;
        check("choppiness", choppiness, "from 0 to 10", |c| (0.0..=10.0).contains(&c))?;
        let variance_m2: f64 = systems.iter().map(WaveSpectrum::variance_m2).sum();
        check("variance_m2", variance_m2, "finite and at least 0", |m0| m0 >= 0.0)?;
        if variance_m2 == 0.0 {
            return Ok(Self { waves: Vec::new(), variance_m2 });
        }
        let energy = PolarEnergy::new(systems);
        check("density_m4", energy.total(), "finite, with energy from 1e-4 to 1e4 rad/m", |sum| sum > 0.0)?;
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        rng.set_stream(STREAM);
        let waves = (0..count).map(|i| {
            let place = i as f64 + 0.5;
            let k = energy.wave_number(place / count as f64);
            Trochoid {
                wave_vector: k * energy.direction(k, (place * GOLDEN).fract()),
                amplitude_m: (2.0 * variance_m2 / count as f64).sqrt(),
                frequency_hz: dispersion.angular_frequency(k) / TAU,
                phase_turns: uniform(&mut rng),
                orbit_ratio: dispersion.orbit_ratio(k),
                lean: choppiness * dispersion.orbit_ratio(k),
            }
        });
        Ok(Self { waves: waves.collect(), variance_m2 })
    }

    /// The waves, from the longest to the shortest; none on a flat sea.
    pub fn waves(&self) -> &[Trochoid] {
        &self.waves
    }

    /// How far the displacement lowers the mean level of the water as one sees it, from above, in metres:
    /// ½ Σ λ coth(kd) k a². At rest points the mean height is 0; seen from above the narrow crests count less.
    pub fn set_down_m(&self) -> f64 {
        let part =
            |wave: &Trochoid| wave.lean * wave.wave_vector.length() * wave.amplitude_m * wave.amplitude_m;
        0.5 * self.waves.iter().map(part).sum::<f64>()
    }
}

impl Surface for Trochoidal {
    fn variance_m2(&self) -> f64 {
        self.variance_m2
    }

    fn sample(&self, rest_m: DVec2, time_s: f64) -> SurfacePoint {
        let mut sums = Sums::default();
        for wave in &self.waves {
            let k = wave.wave_vector;
            // Each part is brought to within a turn by itself, so that far away and late the small one keeps its
            // digits.
            let place = (k / TAU * rest_m).map(|turns| turns - turns.round());
            let time = wave.frequency_hz * time_s;
            let turns = place.x + place.y - (time - time.round()) + wave.phase_turns;
            let (cos, sin) = cos_sin_exact(turns);
            let (re, im) = (wave.amplitude_m * cos, wave.amplitude_m * sin);
            // The orbit's horizontal part is lean · k/|k|; its derivative by x brings another k.
            let lean = wave.lean / k.length();

            sums.add_shape(k, lean, re, im);
            let omega = TAU * wave.frequency_hz;
            let along = k / k.length() * (wave.orbit_ratio * omega * re);
            sums.velocity += DVec3::new(along.x, omega * im, along.y);
        }
        sums.surface(DVec2::ZERO)
    }
}
