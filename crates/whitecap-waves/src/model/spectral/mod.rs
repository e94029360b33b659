//! A sea synthesised from spectra on a periodic lattice of waves, by the Fourier transform.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | L, N | side of the tile, samples along it | m, – |
//! | k | 2π (p, q)/L, wave vector of the lattice point (p, q) | rad/m |
//! | Δk | 2π/L, spacing of the lattice | rad/m |
//! | Ψ(k) | variance density of all systems together | m⁴ |
//! | h0(k) | complex amplitude of the wave that travels towards k | m |
//! | ω | √(g k), angular frequency | rad/s |
//! | λ | choppiness | |
//! | D | horizontal displacement | m |
//!
//! After Tessendorf, *Simulating Ocean Water* (2001), "Building a Random Ocean Wave Height Field" and "Choppy
//! Waves", with three departures:
//!
//! - **Direction.** h(k, t) = h0(k) e^{−iωt} + conj(h0(−k)) e^{+iωt}, so that h0(k) travels *towards* +k.
//!   Tessendorf's e^{+iωt} sends it the other way, which his symmetric spectrum hides and a one-sided one
//!   does not.
//! - **Amplitude.** E|h0|² = Ψ Δk²/2, which makes the variance of the surface ΣΨΔk² = m0. His 1/√2 (ξr + iξi)
//!   √P has twice that.
//! - **Displacement.** D = Σ +i (k/|k|) h e^{ik·x}; the position is x + λD. With his −i, crests sharpen only
//!   for negative λ. λ = 1 is the first-order Lagrangian solution for deep water, Gerstner's.
//!
//! The height is the un-normalised sum Σ h e^{ik·x}; slopes carry ik, the gradients of the displacement
//! −kx²/|k|, −kx kz/|k| and −kz²/|k|. The mean and the Nyquist terms p, q = −N/2 are zero.
//!
//! # The height is the one asked for
//!
//! Ψ is taken at the centre of each lattice cell, and each system is then scaled so that its ΣΨΔk² is exactly
//! its m0: the surface has the significant height that was requested whatever the tile. Which share of the
//! energy the lattice carried before scaling is [`SpectralTile::captured_fraction`]; a system below ½ is
//! refused, since scaling would make another sea of it.

use super::{Surface, SurfacePoint, TileFields, WaveModel};
use crate::error::{ParameterError, check};
use crate::spectrum::WaveSpectrum;
use crate::transform::{InverseReal2d, for_each_run, thread_count};
use glam::DVec2;

mod evolve;
mod fit;
mod lattice;
mod random;
mod sample;

#[cfg(test)]
mod tests;

use evolve::{Column, evolve_column};
use lattice::Waves;

/// What a [`SpectralTile`] is made from, beside its spectra.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectralTileParameters {
    /// L in metres, above 0 and at most 1e6. Four wavelengths of the spectral peak or more carry all of a
    /// sea's energy.
    pub tile_size_m: f64,
    /// N, a power of two from 16 to 2048.
    pub resolution: usize,
    /// λ, from 0 to 10: 0 for waves that only rise and fall, 1 for the physical sea, more for a stylised one.
    pub choppiness: f64,
    /// Which of the random seas with these parameters.
    pub seed: u64,
    /// How the waves' amplitudes are chosen.
    pub amplitudes: Amplitudes,
}

/// How the amplitudes of the waves follow from the spectrum. The phases are random in either case, and the
/// same for the same seed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Amplitudes {
    /// |h0| = √(Ψ Δk²/2): every sea has its exact significant height, at every time, as far as no waves run
    /// against each other (where they do, they interfere, and it holds on average).
    #[default]
    Deterministic,
    /// h0 = ½ (ξr + iξi) √(Ψ Δk²) with ξ standard normal: a fair draw from the Gaussian random sea, whose
    /// significant height varies from seed to seed as it does from one record of a buoy to the next.
    Gaussian,
}

/// The waves of one column of a tile's lattice, those of one p ≥ 0, for a backend that evolves them itself.
///
/// With the arrays below, at time t and with c, s = cos, sin of 2π ν t: h = c P + s Q, and the displaced fields
/// come from G = lean · h as the [module](self) says. A place q holds the lattice number q for q < N/2 and q − N
/// from there on; q = N/2 is empty.
#[derive(Debug, Clone, Copy)]
pub struct WaveColumn<'a> {
    /// Re P, Im P, Re Q, Im Q, each N numbers over q, in metres.
    pub amplitudes: [&'a [f32]; 4],
    /// ν in turns per second, N/2 numbers over |q|.
    pub turns_per_s: &'a [f64],
    /// λ coth(kd)/|k| in m/rad, N/2 numbers over |q|; 0 at k = 0.
    pub lean: &'a [f32],
}

/// A tile of (N − 1)² − 1 waves with random phases; see the [module](self).
///
/// Doubling the resolution over the same tile adds shorter waves and leaves the phase and direction of those
/// that were there; their heights all change by the one factor that keeps the significant height.
pub struct SpectralTile {
    parameters: SpectralTileParameters,
    variance_m2: f64,
    captured_fraction: f64,
    waves: Waves,
    /// One run of evolved amplitudes for each p ≥ 0; see [`Column`].
    evolved: Vec<f32>,
    transform: InverseReal2d,
}

impl SpectralTile {
    /// The sea whose energy is the sum of `systems`: spectra by value, by reference or boxed. Without any it
    /// is flat.
    ///
    /// Fails when a parameter is out of its range or when a system does not fit the tile.
    pub fn new<S: WaveSpectrum>(
        parameters: SpectralTileParameters,
        systems: &[S],
    ) -> Result<Self, ParameterError> {
        let SpectralTileParameters { tile_size_m, resolution: n, choppiness, .. } = parameters;
        check("tile_size_m", tile_size_m, "above 0 and at most 1e6", |l| l > 0.0 && l <= 1e6)?;
        check("resolution", n as f64, "a power of two from 16 to 2048", |_| {
            n.is_power_of_two() && (16..=2048).contains(&n)
        })?;
        check("choppiness", choppiness, "from 0 to 10", |c| (0.0..=10.0).contains(&c))?;
        let energy = fit::lattice_energy(tile_size_m, n, systems)?;
        Ok(Self {
            parameters,
            variance_m2: energy.variance_m2,
            captured_fraction: energy.captured_fraction,
            waves: Waves::new(&parameters, &energy.cell_variance_m2),
            evolved: vec![0.0; n / 2 * Column::len(n)],
            transform: InverseReal2d::new(n)?,
        })
    }

    /// The parameters that the sea was made from.
    pub fn parameters(&self) -> &SpectralTileParameters {
        &self.parameters
    }

    /// The waves with lattice number `p` along x, from 0 to N/2 − 1.
    ///
    /// # Panics
    ///
    /// If there is no such column.
    pub fn column(&self, p: usize) -> WaveColumn<'_> {
        WaveColumn {
            amplitudes: self.waves.amplitudes(p),
            turns_per_s: self.waves.turns_per_s(p),
            lean: self.waves.lean(p),
        }
    }

    /// The share of the requested variance that the lattice carried before it was scaled, over all systems: 1
    /// when the tile is large and fine enough, lower where it cuts off long or short waves. Sampling a sharp
    /// peak coarsely can take it somewhat above 1. It is 1 for a flat sea.
    pub fn captured_fraction(&self) -> f64 {
        self.captured_fraction
    }
}

impl Surface for SpectralTile {
    fn variance_m2(&self) -> f64 {
        self.variance_m2
    }

    fn sample(&self, rest_m: DVec2, time_s: f64) -> SurfacePoint {
        sample::sample(&self.waves, rest_m, time_s)
    }
}

impl WaveModel for SpectralTile {
    fn tile_size_m(&self) -> f64 {
        self.parameters.tile_size_m
    }

    fn resolution(&self) -> usize {
        self.parameters.resolution
    }

    fn evaluate(&mut self, time_s: f64, fields: &mut TileFields) {
        let n = self.parameters.resolution;
        fields.resize(n);
        let waves = &self.waves;
        // The workers of this pass need no memory of their own, and a list of nothings allocates none.
        let mut workers = vec![(); thread_count(n)];
        for_each_run(&mut self.evolved, Column::len(n), &mut workers, |p, run, ()| {
            evolve_column(waves, p, time_s, run);
        });

        let (evolved, transform) = (&self.evolved, &mut self.transform);
        let column = |p: usize| Column::of(waves, evolved, p);
        transform.process_with(|p, out| column(p).height(out), &mut fields.height);
        transform.process_with(|p, out| column(p).slope_x(out), &mut fields.slope_x);
        transform.process_with(|p, out| column(p).slope_z(out), &mut fields.slope_z);
        transform.process_with(|p, out| column(p).displacement_x(out), &mut fields.displacement_x);
        transform.process_with(|p, out| column(p).displacement_z(out), &mut fields.displacement_z);
        transform.process_with(|p, out| column(p).gradient_xx(out), &mut fields.gradient_xx);
        transform.process_with(|p, out| column(p).gradient_xz(out), &mut fields.gradient_xz);
        transform.process_with(|p, out| column(p).gradient_zz(out), &mut fields.gradient_zz);
    }
}
