//! One tile of waves.
//!
//! Symbols as in the [module above](super).

use super::band::Band;
use super::energy::lattice_energy;
use super::evolve::{Column, evolve_column};
use super::lattice::Waves;
use super::sample::{Sums, sums};
use super::{Amplitudes, Water};
use crate::error::{ParameterError, Remedy, check};
use crate::model::{Surface, SurfacePoint, TileFields, WaveModel};
use crate::spectrum::{Profile, WaveSpectrum};
use crate::spline;
use crate::transform::{Complex, InverseReal2d, for_each_run, thread_count};
use glam::DVec2;
use std::f64::consts::{PI, TAU};

#[cfg(test)]
mod tests;

/// A system of which a sea carries less is refused.
pub(super) const LEAST_CAPTURED: f64 = 0.5;

/// What a [`SpectralTile`] is made from, beside its spectra.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectralTileParameters {
    /// L in metres, above 0 and at most 1e6. Four wavelengths of the spectral peak or more carry all of a
    /// sea's energy.
    pub tile_size_m: f64,
    /// N, a power of two from 16 to 2048.
    pub resolution: usize,
    /// Which of the waves of the lattice it carries.
    pub band: Band,
    /// λ, from 0 to 10: 0 for waves that only rise and fall, 1 for the physical sea, more for a stylised one.
    pub choppiness: f64,
    /// What the waves run in.
    pub water: Water,
    /// Which of the random seas with these parameters.
    pub seed: u64,
    /// How the waves' amplitudes are chosen.
    pub amplitudes: Amplitudes,
}

/// The waves of one column of a tile's lattice, those of one p ≥ 0, for a backend that evolves them itself.
///
/// With the arrays below, at time t and with c, s = cos, sin of 2π ν t: h = (c P + s Q) e^{−2πiδt}, and the
/// displaced fields come from G = lean · h as the [module](super) says. A place q holds the lattice number q for
/// q < N/2 and q − N from there on; q = N/2 is empty.
#[derive(Debug, Clone, Copy)]
pub struct WaveColumn<'a> {
    /// Re P, Im P, Re Q, Im Q, each N numbers over q, in metres.
    pub amplitudes: [&'a [f32]; 4],
    /// ν in turns per second, N/2 numbers over |q|.
    pub turns_per_s: &'a [f64],
    /// δ in turns per second, N numbers over q; `None` without a current.
    pub drift_turns_per_s: Option<&'a [f64]>,
    /// λ coth(kd)/|k| in m/rad, N/2 numbers over |q|; 0 at k = 0.
    pub lean: &'a [f32],
}

/// A tile of at most (N − 1)² − 1 waves with random phases; see the [module](super).
///
/// Doubling the resolution over the same tile adds shorter waves and leaves those that were there.
pub struct SpectralTile {
    parameters: SpectralTileParameters,
    /// The variance of each system, and what of it the tile carries.
    systems: Vec<Share>,
    waves: Waves,
    /// One run of evolved amplitudes for each p ≥ 0; see [`Column`].
    evolved: Vec<f32>,
    transform: InverseReal2d,
    /// See [`spline_factors`](Self::spline_factors).
    spline_factors: Vec<f32>,
}

/// Of a system's variance, in m².
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Share {
    pub(super) asked_m2: f64,
    pub(super) carried_m2: f64,
}

impl Share {
    pub(super) fn fraction(&self) -> f64 {
        if self.asked_m2 > 0.0 { self.carried_m2 / self.asked_m2 } else { 1.0 }
    }
}

impl SpectralTile {
    /// The tile whose energy is the sum of `systems`: spectra by value, by reference or boxed. Without any it
    /// is flat.
    ///
    /// # Errors
    ///
    /// When a parameter is out of its range or when less than half of a system fits the tile.
    pub fn new<S: WaveSpectrum>(
        parameters: SpectralTileParameters,
        systems: &[S],
    ) -> Result<Self, ParameterError> {
        let tile = Self::of_cascade(parameters, 0, systems)?;
        let SpectralTileParameters { tile_size_m, resolution, .. } = parameters;
        let poor = tile.systems.iter().position(|share| share.fraction() < LEAST_CAPTURED);
        match poor {
            None => Ok(tile),
            Some(system) => Err(ParameterError::SeaDoesNotFit {
                system,
                captured_fraction: tile.systems[system].fraction(),
                tile_size_m,
                resolution,
                remedy: remedy(&Profile::of(&systems[system]), tile_size_m, resolution),
            }),
        }
    }

    /// The tile that is the `index`-th of a sea, however little it carries.
    pub(super) fn of_cascade<S: WaveSpectrum>(
        parameters: SpectralTileParameters,
        index: u64,
        systems: &[S],
    ) -> Result<Self, ParameterError> {
        let SpectralTileParameters { tile_size_m, resolution: n, choppiness, band, .. } = parameters;
        check("tile_size_m", tile_size_m, "above 0 and at most 1e6", |l| l > 0.0 && l <= 1e6)?;
        check("resolution", n as f64, "a power of two from 16 to 2048", |_| {
            n.is_power_of_two() && (16..=2048).contains(&n)
        })?;
        check("choppiness", choppiness, "from 0 to 10", |c| (0.0..=10.0).contains(&c))?;
        parameters.water.check()?;
        let energy = lattice_energy(tile_size_m, n, band, systems)?;
        let share =
            |(spectrum, &carried_m2): (&S, &f64)| Share { asked_m2: spectrum.variance_m2(), carried_m2 };
        Ok(Self {
            parameters,
            systems: systems.iter().zip(&energy.carried_m2).map(share).collect(),
            waves: Waves::new(&parameters, index, &energy.cell_variance_m2),
            evolved: vec![0.0; n / 2 * Column::len(n)],
            transform: InverseReal2d::new(n)?,
            spline_factors: spline::factors(n / 2, n, spline::CUBIC),
        })
    }

    /// The parameters that the tile was made from.
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
            drift_turns_per_s: self.waves.drift_turns_per_s(p),
            lean: self.waves.lean(p),
        }
    }

    /// What makes a coefficient of a wave's amplitude, for a backend that evolves waves itself: the wave (p, q) takes
    /// the number at |p| times the one at |q|, from 0 to N/2. See
    /// [`evaluate_coefficients`](WaveModel::evaluate_coefficients).
    pub fn spline_factors(&self) -> &[f32] {
        &self.spline_factors
    }

    /// The share of the requested variance that the tile carries, over all systems: 1 when it is large and fine
    /// enough, lower where it cuts off long or short waves. It is 1 for a flat sea.
    pub fn captured_fraction(&self) -> f64 {
        let sum = |of: fn(&Share) -> f64| self.systems.iter().map(of).sum::<f64>();
        Share { asked_m2: sum(|share| share.asked_m2), carried_m2: self.variance_m2() }.fraction()
    }

    pub(super) fn shares(&self) -> &[Share] {
        &self.systems
    }

    pub(crate) fn waves(&self) -> &Waves {
        &self.waves
    }

    pub(super) fn sums(&self, rest_m: DVec2, depth_m: f64, time_s: f64) -> Sums {
        sums(&self.waves, &self.parameters, rest_m, depth_m, time_s)
    }
}

impl Surface for SpectralTile {
    fn variance_m2(&self) -> f64 {
        self.systems.iter().map(|share| share.carried_m2).sum()
    }

    fn sample(&self, rest_m: DVec2, time_s: f64) -> SurfacePoint {
        self.sums(rest_m, 0.0, time_s).surface(self.parameters.water.current_mps)
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
        self.fill(time_s, fields, |_, _, _| {});
    }

    /// Each wave has the coefficients whose mean square error is the least; the spline misses the samples by as much
    /// as it misses what is between them.
    fn evaluate_coefficients(&mut self, time_s: f64, fields: &mut TileFields) {
        self.fill(time_s, fields, spline::filter);
    }
}

impl SpectralTile {
    /// Evaluates all fields; `filter` may change the spectra of height and displacement, column by column.
    #[inline(always)]
    fn fill(
        &mut self,
        time_s: f64,
        fields: &mut TileFields,
        filter: impl Fn(&[f32], usize, &mut [Complex<f32>]) + Sync,
    ) {
        let n = self.parameters.resolution;
        fields.resize(n);
        let waves = &self.waves;
        // The workers of this pass need no memory of their own, and a list of nothings allocates none.
        let mut workers = vec![(); thread_count(n)];
        for_each_run(&mut self.evolved, Column::len(n), &mut workers, |p, run, ()| {
            evolve_column(waves, p, time_s, run);
        });

        let (evolved, transform, factors) = (&self.evolved, &mut self.transform, &self.spline_factors);
        let column = |p: usize| Column::of(waves, evolved, p);
        let mut displacement = |of: fn(&Column<'_>, &mut [Complex<f32>]), field: &mut Vec<f32>| {
            let spectrum = |p: usize, out: &mut [Complex<f32>]| {
                of(&column(p), out);
                filter(factors, p, out);
            };
            transform.process_with(spectrum, field);
        };
        displacement(|column, out| column.height(out), &mut fields.height);
        displacement(|column, out| column.displacement_x(out), &mut fields.displacement_x);
        displacement(|column, out| column.displacement_z(out), &mut fields.displacement_z);
        transform.process_with(|p, out| column(p).slope_x(out), &mut fields.slope_x);
        transform.process_with(|p, out| column(p).slope_z(out), &mut fields.slope_z);
        transform.process_with(|p, out| column(p).gradient_xx(out), &mut fields.gradient_xx);
        transform.process_with(|p, out| column(p).gradient_xz(out), &mut fields.gradient_xz);
        transform.process_with(|p, out| column(p).gradient_zz(out), &mut fields.gradient_zz);
    }
}

/// What would make a spectrum fit: a larger tile if more energy is longer than the tile than is shorter than two
/// samples, closer samples otherwise.
pub(super) fn remedy(profile: &Profile, tile_size_m: f64, n: usize) -> Remedy {
    let Band { from, to } = Band::of_tile(tile_size_m, n);
    let too_long = profile.variance_m2(Band { from: 0.0, to: from });
    let too_short = profile.variance_m2(Band { from: to, to: f64::INFINITY });
    if too_long >= too_short {
        Remedy::LargerTile { tile_size_m: (4.0 * TAU / profile.peak_wave_number()).ceil() }
    } else {
        Remedy::CloserSamples { spacing_m: PI / profile.wave_number_below(0.9) }
    }
}
