//! What of a spectrum depends on the wave number alone, over ln k.
//!
//! Rows are interpolated linearly between knots that are close enough for JONSWAP's narrowest peak: with γ = 10
//! the curvature of ln S over ln k is below 200, and a spacing of h errs by h²/8 of it. Beyond the peak's own width it
//! is below 40, and far below the peak, where it grows again, there is no energy. Where a law steps or
//! bends (at the peak, or between the branches of a spreading) one piece of the table ends and another begins,
//! each with the values of its own side.

use crate::model::spectral::Band;

/// Stretches of the table in ln(k/kp), each from the end of the one before, and the knots to a unit of ln k.
const LOWEST: f64 = -3.5;
const STRETCHES: [(f64, f64); 5] =
    [(-2.0, 160.0), (-1.0, 480.0), (1.0, 960.0), (2.5, 480.0), (HIGHEST, 160.0)];
const HIGHEST: f64 = 16.0;

/// The wave number in rad/m beyond which no sea has waves: the table may end there.
const SHORTEST: f64 = Band::OF_SEAS.to;

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
    pub(super) fn new(
        peak: f64,
        breaks: impl Iterator<Item = f64>,
        row: impl Fn(f64) -> Row + Send + Sync,
    ) -> Self {
        let ln_peak = libm::log(peak);
        let highest = (libm::log(SHORTEST) - ln_peak).clamp(STRETCHES[3].0 + 1.0, HIGHEST);
        let mut ends: Vec<f64> = breaks.map(|k| libm::log(k) - ln_peak).collect();
        ends.extend(STRETCHES.map(|(end, _)| end.min(highest)));
        ends.extend([LOWEST, 0.0]);
        ends.sort_by(f64::total_cmp);
        let piece = |ends: &[f64]| {
            let (from, to) = (ends[0], ends[1]);
            let knots_per_unit = STRETCHES
                .iter()
                .find(|(end, _)| from < *end)
                .map_or(0.0, |(_, knots_per_unit)| *knots_per_unit);
            let steps = ((to - from) * knots_per_unit).ceil().max(1.0);
            let at = |i: u32| {
                let x = from + (to - from) * f64::from(i) / steps;
                row(libm::exp(ln_peak + x.clamp(from + SIDE, to - SIDE)))
            };
            Piece {
                from: ln_peak + from,
                to: ln_peak + to,
                knots_per_unit: steps / (to - from),
                rows: rows(steps as u32 + 1, at),
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

/// A row for each of the knots, on as many threads as there are.
fn rows(knots: u32, at: impl Fn(u32) -> Row + Send + Sync) -> Vec<Row> {
    #[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
    {
        use rayon::prelude::*;
        (0..knots).into_par_iter().with_min_len(64).map(at).collect()
    }
    #[cfg(not(all(feature = "parallel", not(target_arch = "wasm32"))))]
    (0..knots).map(at).collect()
}
