//! What of a spectrum depends on the wave number alone, over ln k.
//!
//! Rows are interpolated linearly between knots that are close enough for JONSWAP's narrowest peak: with γ = 10
//! the curvature of ln S over ln k is below 200, and a spacing of h errs by h²/8 of it. Where a law steps or
//! bends (at the peak, or between the branches of a spreading) one piece of the table ends and another begins,
//! each with the values of its own side.

/// Where the dense knots begin and end, and where the table does, in ln(k/kp).
const LOWEST: f64 = -3.5;
const DENSE_TO: f64 = 2.5;
const HIGHEST: f64 = 16.0;

/// Spacing of the knots near the peak and in the tail, in ln k.
const DENSE: f64 = 1.0 / 960.0;
const SPARSE: f64 = 1.0 / 160.0;

/// How far from a step its two sides are asked, in ln k.
const SIDE: f64 = 1e-9;

/// What a wave number has, whatever its direction.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Row {
    /// ln of S(k)/(m0 k) and of the distribution's scale.
    pub(super) ln_scale: f64,
    /// The number of the distribution's lobe.
    pub(super) parameter: f64,
    /// s_ξ.
    pub(super) swell_exponent: f64,
}

/// A stretch of evenly spaced knots.
#[derive(Debug, Clone)]
struct Piece {
    from: f64,
    to: f64,
    knots_per_unit: f64,
    rows: Vec<Row>,
}

/// The pieces in order, without gaps.
#[derive(Debug, Clone, Default)]
pub(super) struct Table {
    pieces: Vec<Piece>,
}

impl Table {
    /// The table of `row` about a peak at the wave number `peak`, with steps there and at `breaks`.
    pub(super) fn new(peak: f64, breaks: impl Iterator<Item = f64>, row: impl Fn(f64) -> Row) -> Self {
        let ln_peak = libm::log(peak);
        let mut ends: Vec<f64> = breaks.map(|k| libm::log(k) - ln_peak).collect();
        ends.extend([LOWEST, 0.0, DENSE_TO, HIGHEST]);
        ends.sort_by(f64::total_cmp);
        let piece = |ends: &[f64]| {
            let (from, to) = (ends[0], ends[1]);
            let spacing = if from < DENSE_TO { DENSE } else { SPARSE };
            let steps = ((to - from) / spacing).ceil().max(1.0);
            let at = |i: u32| {
                let x = from + (to - from) * f64::from(i) / steps;
                row(libm::exp(ln_peak + x.clamp(from + SIDE, to - SIDE)))
            };
            Piece {
                from: ln_peak + from,
                to: ln_peak + to,
                knots_per_unit: steps / (to - from),
                rows: (0..=steps as u32).map(at).collect(),
            }
        };
        Self { pieces: ends.windows(2).map(piece).collect() }
    }

    /// The row at `ln_k`; `None` outside the table.
    #[inline]
    pub(super) fn at(&self, ln_k: f64) -> Option<Row> {
        let piece = self.pieces.iter().find(|piece| ln_k <= piece.to)?;
        let place = (ln_k - piece.from) * piece.knots_per_unit;
        if place < 0.0 {
            return None;
        }
        let index = (place as usize).min(piece.rows.len() - 2);
        let (a, b) = (&piece.rows[index], &piece.rows[index + 1]);
        let part = place - index as f64;
        let mix = |a: f64, b: f64| a + (b - a) * part;
        Some(Row {
            ln_scale: mix(a.ln_scale, b.ln_scale),
            parameter: mix(a.parameter, b.parameter),
            swell_exponent: mix(a.swell_exponent, b.swell_exponent),
        })
    }
}
