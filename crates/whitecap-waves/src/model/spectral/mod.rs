//! A sea synthesised from spectra on a periodic lattice of waves, by the Fourier transform.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | L, N | side of a tile, samples along it | m, – |
//! | k | 2π (p, q)/L, wave vector of the lattice point (p, q) | rad/m |
//! | Δk | 2π/L, spacing of the lattice | rad/m |
//! | Ψ(k) | variance density of all systems together | m⁴ |
//! | h0(k) | complex amplitude of the wave that travels towards k | m |
//! | ω | angular frequency in water at rest, by [`Dispersion`] | rad/s |
//! | d, U | depth of the water, current | m, m/s |
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
//! −kx²/|k|, −kx kz/|k| and −kz²/|k|. Over a bottom the orbits are flatter, and D has the factor coth kd. The mean
//! and the Nyquist terms p, q = −N/2 are zero. The velocity of the water is ∂h/∂t upwards and ∂D/∂t along, both
//! without λ, which is of the drawing and not of the water; a current adds U and carries the pattern past:
//! e^{−ik·Ut}.
//!
//! # The energy is that of the spectrum
//!
//! Each wave of the lattice has the energy of its cell, ∫Ψ d²k, so the variance of a tile is the
//! integral of the spectrum over the waves that the tile carries, no more and no less. Nothing is scaled to hide
//! what a tile is too small or too coarse for: [`SpectralSea::captured_fractions`] says how much of a system it
//! carries, and one of which it carries less than half is refused.
//!
//! One tile carries waves from its length down to twice its spacing. A [`SpectralSea`] of several tiles, its
//! [cascades](Cascade), carries more: each has a [`Band`] of wave numbers of its own. A tile repeats, and so does what it
//! draws, unless the sea is [sewn from patches](SpectralSea::sewn).

use crate::dispersion::Dispersion;
use crate::error::{ParameterError, check};
use glam::DVec2;
use std::f64::consts::TAU;

mod band;
mod cascade;
mod energy;
pub(crate) mod evolve;
pub mod foam;
pub(crate) mod lattice;
mod patchwork;
mod random;
pub(crate) mod sample;
mod sea;
mod tile;

pub use band::Band;
pub use cascade::{Cascade, CascadeBudget, CascadeRequest};
pub use patchwork::{Patch, Patchwork};
pub use sea::{SpectralSea, SpectralSeaParameters};
pub use tile::{SpectralTile, SpectralTileParameters, WaveColumn};

/// How the amplitudes of the waves follow from the spectrum. The phases are random in either case, and the
/// same for the same seed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Amplitudes {
    /// Of each pair of opposite waves, k and −k, one runs, and |h0|² is half the energy of both cells: every sea has
    /// its exact significant height and mean square slope, at every time. Which one runs is chosen so that among
    /// neighbours each direction has its energy; where none runs against another, all run.
    #[default]
    Deterministic,
    /// h0 = ½ (ξr + iξi) times the root of the cell's energy, with ξ standard normal: a fair draw from the Gaussian
    /// random sea, whose significant height varies from seed to seed as it does from one record of a buoy to the
    /// next.
    Gaussian,
}

/// What moves the waves of a sea: the same for all its tiles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Water {
    /// Depth and surface tension.
    pub dispersion: Dispersion,
    /// U in m/s (`.x` east, `.y` south), each component from −20 to 20: a uniform current that carries the waves.
    /// Spectra are those that an observer sees who drifts with it.
    pub current_mps: DVec2,
    /// After how many seconds the motion repeats without a seam, from 1 to 1e6; `None` for never. Each wave takes the
    /// nearest frequency with a whole number of turns, at least one: frequencies are off by at most half a turn
    /// per loop, and waves whose period is longer than the loop run faster than they should.
    pub loop_s: Option<f64>,
}

impl Water {
    /// Deep and at rest, for ever.
    pub const STILL: Self = Self { dispersion: Dispersion::DEEP, current_mps: DVec2::ZERO, loop_s: None };

    /// ω/2π of waves of wave number `k` in rad/m, as they run here, in turns per second: in a loop the nearest that
    /// closes.
    pub fn turns_per_s(&self, k: f64) -> f64 {
        self.looped(self.dispersion.angular_frequency(k) / TAU, 1.0)
    }

    /// k·U/2π of the wave vector `k` in rad/m: how often the current carries the wave past, in turns per second.
    pub fn drift_turns_per_s(&self, k: DVec2) -> f64 {
        self.looped(k.dot(self.current_mps) / TAU, 0.0)
    }

    /// `turns_per_s` as it is, or the nearest that makes a whole number of turns in a loop, `at_least` so many
    /// (Tessendorf 2001 takes the next lower one, which stops the longest waves).
    fn looped(&self, turns_per_s: f64, at_least: f64) -> f64 {
        let Some(loop_s) = self.loop_s else { return turns_per_s };
        let turns = (turns_per_s * loop_s).round();
        if turns.abs() < at_least { at_least / loop_s } else { turns / loop_s }
    }

    fn check(&self) -> Result<(), ParameterError> {
        for component in self.current_mps.to_array() {
            check("current_mps", component, "from -20 to 20", |u| u.abs() <= 20.0)?;
        }
        if let Some(loop_s) = self.loop_s {
            check("loop_s", loop_s, "from 1 to 1e6", |t| (1.0..=1e6).contains(&t))?;
        }
        Ok(())
    }
}
