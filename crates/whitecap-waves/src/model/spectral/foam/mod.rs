//! Whitecaps: where the sea breaks, and the foam that it leaves behind.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | U | wind 10 m above the sea | m/s |
//! | W | share of the sea that is white | |
//! | sᵢ(x, t) | −(∂Dx/∂x + ∂Dz/∂z) of tile i: by how much its waves draw the water together | |
//! | k_b | wave number below which waves break as whitecaps | rad/m |
//! | τ | e-folding time of foam | s |
//! | δ | convergence that makes e times as much foam | |
//! | ρᵢ | e-folds per second by which tile i forgets, Σρᵢ = 1/τ | 1/s |
//! | mᵢ(x, t) | maxₐ (sᵢ(x, t − a)/δ − ρᵢ a): what tile i remembers | |
//! | c | threshold, in e-folds | |
//!
//! # When it folds
//!
//! The area that the surface has, seen from above, is J = 1 − s + det ∇D with s = Σ sᵢ. The determinant is of second
//! order and is zero for long-crested waves, so the surface folds where s is large; tests hold the two together. s is
//! the sum of the tiles' own fields, which J is not, and one transform a tile instead of three.
//!
//! # What foam is left
//!
//! A place breaks in degrees: with convergence s there is e^{(s − c δ)/δ} of foam, at most 1, and what there is decays
//! as e^{−a/τ}. So the foam of the largest breaker within memory is min(1, e^{m − c}), m = maxₐ (s(t − a)/δ − a/τ):
//! the logarithm makes decay a subtraction and foam a maximum. Of several tiles the maximum of the sum is drawn as
//! Σ mᵢ: it needs one number a tile and place, so foam has the pattern of all tiles together and repeats no more
//! than they do. Each tile forgets by its share of the variance of s, for that is its share in a breaking crest (the
//! regression of a summand on a sum of Gaussians), though none by less than a part of it: together they lose 1/τ.
//!
//! x is a rest point, which the water carries along: foam needs no advection of its own.
//!
//! # Which waves
//!
//! Breakers that leave foam travel at 0.3 U or more (the distributions of breaking crests over speed of Kleiss and
//! Melville, *J. Phys. Oceanogr.* 40, 2010, and Gemmrich, Banner and Garrett, *J. Phys. Oceanogr.* 38, 2008, peak
//! there and above); shorter waves break without air. s counts the waves k by 1/(1 + (k/k_b)⁴), k_b = g/(0.3 U)².
//!
//! # How much
//!
//! c is what makes the mean of the foam over places and times the cover of Monahan and O'Muircheartaigh,
//! [`whitecap_cover`]: from the histograms of mᵢ of this very sea, convolved, since tiles are independent.
//!
//! # A function of time
//!
//! sᵢ is taken at the times of a fixed grid and at the moment itself, which makes mᵢ continuous. Memory goes back to
//! the start of the block of 5 τ before the present one, and what is of that block fades away before it is dropped:
//! so a moment costs at most two blocks, the next one a step, and both have the same bits.

use super::{Patchwork, SpectralSea};
use crate::error::{ParameterError, check};
use crate::optics::foam_cover;
use crate::statistics::{Moments, whitecap_cover};

mod calibration;
mod convergence;
mod levels;
mod memory;
mod place;
mod wind;

pub use levels::FoamLevel;

use convergence::Convergence;
use memory::{Clock, Memory};

/// e-folding time of whitecaps on salt water in seconds: 3.53 s in Monahan and Zietlow, *J. Geophys. Res.* 74, 1969.
pub const DECAY_S: f64 = 3.53;

/// δ in standard deviations of s: below it patches have hard edges, above it foam is a haze over the crests.
const SOFTNESS: f64 = 0.2;

/// Speed of the slowest breakers with foam, in winds.
const SLOWEST_BREAKER: f64 = 0.3;

/// A tile with less than this share of the variance of s has no whitecaps of its own.
const LEAST_SHARE: f64 = 0.01;

/// No tile forgets by less than this share of the whole, before shares are made to add up.
const LEAST_FORGOTTEN: f64 = 0.3;

/// Cover below which there is none.
const LEAST_COVER: f64 = 1e-6;

/// Samples along a side of the largest foam field.
const MOST_SAMPLES: usize = 512;

/// What the foam of a sea is made from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FoamParameters {
    /// U, from 0 to 100 m/s: how much foam there is and which waves make it. `None` for that of the fully developed sea
    /// that is as steep, where a sea names no wind: swell alone has next to none.
    pub wind_speed_mps: Option<f64>,
    /// τ, from 0.1 to 100 s; see [`DECAY_S`].
    pub decay_s: f64,
}

/// The foam of a [`SpectralSea`]; see the [module](self).
pub struct Foam {
    clock: Clock,
    resolution: usize,
    tiles: Vec<FoamTile>,
    wind_speed_mps: f64,
    cover: f64,
    threshold: f64,
    variance_gain: [f64; 2],
}

/// What one tile of the sea adds to its foam.
pub struct FoamTile {
    index: usize,
    tile_size_m: f64,
    patchwork: Option<Patchwork>,
    convergence: Convergence,
    memory: Memory,
    mean: f64,
    field: Vec<f32>,
}

impl Foam {
    /// The most tiles with breaking waves: those with most of the convergence.
    pub const MOST_TILES: usize = 4;

    /// The foam of `sea`; `None` where there is none, for want of wind or of waves that lean.
    ///
    /// # Errors
    ///
    /// If a parameter is out of its range.
    pub fn new(sea: &SpectralSea, parameters: FoamParameters) -> Result<Option<Self>, ParameterError> {
        let FoamParameters { wind_speed_mps, decay_s } = parameters;
        let wind_speed_mps = match wind_speed_mps {
            Some(wind_speed_mps) => wind_speed_mps,
            None => wind::equivalent_wind_mps(sea)?,
        };
        check("wind_speed_mps", wind_speed_mps, "from 0 to 100", |u| (0.0..=100.0).contains(&u))?;
        check("decay_s", decay_s, "from 0.1 to 100", |s| (0.1..=100.0).contains(&s))?;
        let cover = whitecap_cover(wind_speed_mps);
        if cover < LEAST_COVER {
            return Ok(None);
        }
        let slowest_mps = SLOWEST_BREAKER * wind_speed_mps;
        let shortest = crate::GRAVITY_MPS2 / (slowest_mps * slowest_mps);
        let finest = sea.tiles().iter().map(|tile| tile.parameters().resolution).max().unwrap_or(0);
        let resolution = finest.min(MOST_SAMPLES);

        let mut candidates = Vec::with_capacity(sea.tiles().len());
        for (index, tile) in sea.tiles().iter().enumerate() {
            let mut convergence = Convergence::new(tile.waves(), resolution, shortest)?;
            let mut field = vec![0.0; resolution * resolution];
            convergence.evaluate(0.0, &mut field);
            let variance = Moments::of(&field).variance;
            candidates.push((
                variance,
                FoamTile {
                    index,
                    tile_size_m: tile.parameters().tile_size_m,
                    patchwork: sea.patchwork(index),
                    convergence,
                    memory: Memory::default(),
                    mean: 0.0,
                    field,
                },
            ));
        }
        let total: f64 = candidates.iter().map(|candidate| candidate.0).sum();
        if total <= 0.0 {
            return Ok(None);
        }
        let mut variances: Vec<f64> = candidates.iter().map(|candidate| candidate.0).collect();
        variances.sort_by(|a, b| b.total_cmp(a));
        variances.truncate(Self::MOST_TILES);
        let least = variances.last().map_or(0.0, |last| last.max(LEAST_SHARE * total));
        candidates.retain(|candidate| candidate.0 >= least);
        let share = |variance: f64| (variance / total).max(LEAST_FORGOTTEN);
        let shares: f64 = candidates.iter().map(|candidate| share(candidate.0)).sum();
        let per_convergence = 1.0 / (SOFTNESS * total.sqrt());
        let mut tiles = Vec::with_capacity(candidates.len());
        for (variance, mut tile) in candidates {
            tile.convergence.scale(per_convergence);
            tile.memory = Memory::new(resolution, share(variance) / (shares * decay_s));
            tiles.push(tile);
        }

        let clock = Clock::new(decay_s, sea.parameters().water.loop_s);
        let mut foam = Self {
            clock,
            resolution,
            tiles,
            wind_speed_mps,
            cover,
            threshold: 0.0,
            variance_gain: [1.0, 0.0],
        };
        calibration::calibrate(&mut foam)?;
        Ok(Some(foam))
    }

    /// U, as it was asked for or as the sea is steep.
    pub fn wind_speed_mps(&self) -> f64 {
        self.wind_speed_mps
    }

    /// W, the mean of the foam over places and times.
    pub fn cover(&self) -> f64 {
        self.cover
    }

    /// c less the means of all mᵢ: at a place with the tiles' [fields](FoamTile::field) fᵢ there is
    /// [`foam_cover`] (Σfᵢ − threshold, 0) of foam.
    pub fn threshold(&self) -> f64 {
        self.threshold
    }

    /// (a, b): the variance σ² of what a pixel does not show of the fields counts as (a + b σ²) σ². It makes up for what
    /// is between a texel and the next, which neither holds, and for the tails of mᵢ, which are maxima, longer than those
    /// of normal fields. With it the cover of the whole sea is W where some is averaged away, and where all is.
    pub fn variance_gain(&self) -> [f64; 2] {
        self.variance_gain
    }

    /// The cover of a pixel over which the fields' sum has this mean and variance.
    pub fn cover_of(&self, mean: f64, variance: f64) -> f64 {
        let [constant, slope] = self.variance_gain;
        foam_cover(mean - self.threshold, (constant + slope * variance).max(0.0) * variance)
    }

    /// Samples along a side of every field.
    pub fn resolution(&self) -> usize {
        self.resolution
    }

    /// The tiles with breaking waves, the longest first.
    pub fn tiles(&self) -> &[FoamTile] {
        &self.tiles
    }

    /// Brings the tiles' fields to `time_s`. Allocates nothing after the first time.
    pub fn evaluate(&mut self, time_s: f64) {
        let moment = self.clock.moment(time_s);
        for tile in &mut self.tiles {
            let FoamTile { convergence, memory, field, mean, .. } = tile;
            memory.recall(&self.clock, &moment, convergence, field);
            field.iter_mut().for_each(|value| *value -= *mean as f32);
        }
    }
}

impl FoamTile {
    /// Which of the sea's tiles it is.
    pub fn index(&self) -> usize {
        self.index
    }

    /// Its side in metres, over which the field repeats.
    pub fn tile_size_m(&self) -> f64 {
        self.tile_size_m
    }

    /// The patches that it is sewn from, those of the sea's tile; `None` where it repeats. Copies pᵢ with the weights ŵᵢ make
    /// ln Σŵᵢ² e^{pᵢ}: so the mean of the foam stays what it is.
    pub fn patchwork(&self) -> Option<Patchwork> {
        self.patchwork
    }

    /// mᵢ less its mean, row by row; sample (0, 0) is over the rest point (0, 0).
    pub fn field(&self) -> &[f32] {
        &self.field
    }
}
