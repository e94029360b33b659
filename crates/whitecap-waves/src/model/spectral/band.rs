//! A part of a sea's waves, such as those that a tile carries.

use std::f64::consts::{PI, TAU};

/// The wave numbers |k| from `from` up to, but without, `to`, in rad/m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Band {
    /// The longest waves, at least 0.
    pub from: f64,
    /// Where the next band begins; infinity for none.
    pub to: f64,
}

impl Band {
    /// Every wave that there is.
    pub const WHOLE: Self = Self { from: 0.0, to: f64::INFINITY };

    /// What is looked at to find all waves of a sea: from 60 km to 0.6 mm.
    pub(crate) const OF_SEAS: Self = Self { from: 1e-4, to: 1e4 };

    /// What a square lattice carries along its axes: from waves as long as the tile to those of two samples.
    pub fn of_tile(tile_size_m: f64, resolution: usize) -> Self {
        Self { from: TAU / tile_size_m, to: PI * resolution as f64 / tile_size_m }
    }

    /// Its waves that a sea can have; NaN stays.
    pub(crate) fn of_a_sea(&self) -> Self {
        let Self { from, to } = Self::OF_SEAS;
        Self { from: self.from.clamp(from, to), to: self.to.clamp(from, to) }
    }

    /// Whether a wave of wave number `k` belongs to it.
    pub fn contains(&self, k: f64) -> bool {
        (self.from..self.to).contains(&k)
    }

    /// How a ring of wave numbers lies to the band: wholly inside, wholly outside or across an edge.
    pub(super) fn position(&self, nearest: f64, farthest: f64) -> Position {
        if farthest < self.from || nearest >= self.to {
            Position::Outside
        } else if nearest >= self.from && farthest < self.to {
            Position::Inside
        } else {
            Position::Across
        }
    }
}

/// See [`Band::position`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Position {
    Inside,
    Outside,
    Across,
}
