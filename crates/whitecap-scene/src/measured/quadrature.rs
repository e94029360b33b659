//! Widths of frequencies and directions, as the makers of each format take them.

use std::f64::consts::TAU;

/// The whole band of each frequency: to the middle between neighbours, at the ends as far out as in.
pub(super) fn bands(x: &[f64]) -> Vec<f64> {
    let last = x.len().saturating_sub(1);
    let half = |i: usize| if i < last { 0.5 * (x[i + 1] - x[i]) } else { 0.0 };
    (0..x.len())
        .map(|i| {
            let above = if i < last { half(i) } else { half(i.saturating_sub(1).min(last)) };
            let below = if i > 0 { half(i - 1) } else { half(0) };
            if x.len() < 2 { 0.0 } else { below + above }
        })
        .collect()
}

/// The weights of the trapezoidal rule.
pub(super) fn trapezoids(x: &[f64]) -> Vec<f64> {
    let last = x.len().saturating_sub(1);
    (0..x.len()).map(|i| 0.5 * (x[(i + 1).min(last)] - x[i.saturating_sub(1)])).collect()
}

/// f Δ ln f, the bands of a logarithmic scale.
pub(super) fn log_bands(x: &[f64]) -> Vec<f64> {
    let logs: Vec<f64> = x.iter().map(|x| x.ln()).collect();
    bands(&logs).into_iter().zip(x).map(|(width, x)| width * x).collect()
}

/// The width of one direction, radians: a part of the circle, or of the sector that the directions cover.
pub(super) fn direction_step(toward_rad: &[f64]) -> f64 {
    let count = toward_rad.len().max(1) as f64;
    match sector(toward_rad) {
        Some(Sector { step, .. }) => step,
        None => TAU / count,
    }
}

/// Directions that do not go round the circle.
struct Sector {
    first: f64,
    last: f64,
    /// The middle one of the distances between neighbours.
    step: f64,
}

/// The sector that the directions cover, if one gap between neighbours is wider than two and a half steps.
fn sector(toward_rad: &[f64]) -> Option<Sector> {
    let mut sorted: Vec<f64> = toward_rad.iter().map(|toward| toward.rem_euclid(TAU)).collect();
    sorted.sort_by(f64::total_cmp);
    let count = sorted.len();
    let gap = |i: usize| if i + 1 < count { sorted[i + 1] - sorted[i] } else { sorted[0] + TAU - sorted[i] };
    let mut gaps: Vec<(f64, usize)> = (0..count).map(|i| (gap(i), i)).collect();
    gaps.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (step, _) = *gaps.get(count / 2)?;
    let (widest, at) = *gaps.last()?;
    let (first, last) = (sorted[(at + 1) % count], sorted[at]);
    (count >= 3 && widest > 2.5 * step).then_some(Sector { first, last, step })
}

/// A table whose directions cover only a sector, with a direction without energy on either side of it, so
/// that nothing is interpolated across the rest of the circle.
pub(super) fn with_closed_sector(toward_rad: &[f64], density: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let Some(Sector { first, last, step }) = sector(toward_rad) else {
        return (toward_rad.to_vec(), density.to_vec());
    };
    let closed = toward_rad.iter().copied().chain([first - step, last + step]).collect();
    let row = |row: &[f64]| row.iter().copied().chain([0.0, 0.0]).collect::<Vec<_>>();
    (closed, density.chunks_exact(toward_rad.len()).flat_map(row).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_by_hand() {
        assert_eq!(bands(&[1.0, 2.0, 4.0]), [1.0, 1.5, 2.0]);
        assert_eq!(trapezoids(&[1.0, 2.0, 4.0]), [0.5, 1.5, 1.0]);
        let ln2 = std::f64::consts::LN_2;
        for (width, expected) in log_bands(&[1.0, 2.0, 4.0]).into_iter().zip([ln2, 2.0 * ln2, 4.0 * ln2]) {
            assert!((width - expected).abs() < 1e-15);
        }
        assert_eq!(bands(&[1.0]), [0.0]);
        assert!(bands(&[]).is_empty());
    }

    #[test]
    fn a_sector_is_closed_and_a_circle_left_alone() {
        let circle = [0.5, 1.5, 2.5, 3.5, 4.5, 5.5];
        assert_eq!(with_closed_sector(&circle, &[1.0; 6]), (circle.to_vec(), vec![1.0; 6]));
        let (directions, density) = with_closed_sector(&[6.0, 6.2, 0.1], &[1.0, 2.0, 3.0]);
        assert_eq!(density, [1.0, 2.0, 3.0, 0.0, 0.0]);
        assert!((directions[3] - 5.8).abs() < 0.02 && (directions[4] - 0.3).abs() < 0.02, "{directions:?}");
        assert!((direction_step(&[6.0, 6.2, 0.1]) - 0.2).abs() < 0.02);
    }
}
