//! Which of a sea's waves a tile carries.

/// The wave numbers |k| from `from` up to, but without, `to`, in rad/m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Band {
    /// The longest waves, at least 0.
    pub from: f64,
    /// Where the next band begins; infinity for none.
    pub to: f64,
}

impl Band {
    /// Every wave that the lattice has.
    pub const WHOLE: Self = Self { from: 0.0, to: f64::INFINITY };

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
