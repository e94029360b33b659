//! How the energy is spread over the directions that waves come from.

use super::style::{SURFACE, THEORY};
use super::{Area, Drawn, Figure, axes};
use glam::DVec2;
use plotters::prelude::{AreaSeries, Color, DrawingBackend, LineSeries, PathElement};
use std::f64::consts::TAU;
use whitecap_waves::direction::nautical_from_toward;

/// The surface's waves are collected in this many sectors: a lattice has few waves in any one direction.
const SECTORS: usize = 24;

/// The axis counts in eighths of the compass: plotters puts its marks at round numbers.
const STEP_DEG: f64 = 45.0;

pub(super) fn draw<DB: DrawingBackend>(figure: &Figure<'_>, area: &Area<DB>) -> Drawn<DB> {
    let m0 = figure.theory.total().energy_m2;
    // From m²/rad to hundredths of all energy per degree.
    let share = |energy: f64| if m0 > 0.0 { 100.0 * energy / m0 * TAU / 360.0 } else { 0.0 };
    let theory = around(
        figure
            .theory
            .direction_spectrum()
            .into_iter()
            .map(|(toward, energy)| (nautical_from_toward(toward), share(energy))),
    );
    let sectors = figure.surface.sectors(SECTORS);
    let most = theory.iter().map(|sample| sample.1).chain(sectors.iter().map(|&energy| share(energy)));
    let most = most.fold(0.0, f64::max);
    let words = ["Energy by direction, % per degree", "direction that waves come from, clockwise from north"];
    let mark = |steps: &f64| format!("{:.0}°", steps * STEP_DEG);
    let mut chart = axes::draw(area, words, 360.0 / STEP_DEG, &mark, most)?;
    let placed = || theory.iter().map(|&(bearing, share)| (bearing / STEP_DEG, share));
    chart.draw_series(AreaSeries::new(placed(), 0.0, THEORY.mix(0.12)))?;
    chart.draw_series(LineSeries::new(placed(), THEORY.stroke_width(5)))?;
    let half = 180.0 / SECTORS as f64;
    for (i, &energy) in sectors.iter().enumerate() {
        let toward = DVec2::from_angle(i as f64 * TAU / SECTORS as f64);
        let (middle, height) = (nautical_from_toward(toward), share(energy));
        // A sector around north has a part at either end.
        for middle in [middle - 360.0, middle, middle + 360.0] {
            let (start, end) = ((middle - half).max(0.0), (middle + half).min(360.0));
            if start < end {
                let step = PathElement::new(
                    [(start / STEP_DEG, height), (end / STEP_DEG, height)],
                    SURFACE.stroke_width(6),
                );
                chart.draw_series([step])?;
            }
        }
    }
    Ok(())
}

/// The samples by rising bearing, from 0 to 360 with both.
fn around(samples: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut samples: Vec<(f64, f64)> = samples.collect();
    samples.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (Some(&first), Some(&last)) = (samples.first(), samples.last()) else { return samples };
    let gap = first.0 + 360.0 - last.0;
    let north = last.1 + (first.1 - last.1) * (360.0 - last.0) / gap;
    samples.insert(0, (0.0, north));
    samples.push((360.0, north));
    samples
}

#[cfg(test)]
mod tests {
    use super::around;

    #[test]
    fn the_line_reaches_both_ends_at_one_height() {
        let samples = [(350.0, 1.0), (20.0, 4.0), (180.0, 9.0)];
        let expected = vec![(0.0, 2.0), (20.0, 4.0), (180.0, 9.0), (350.0, 1.0), (360.0, 2.0)];
        assert_eq!(around(samples.into_iter()), expected);
        assert!(around(std::iter::empty()).is_empty());
    }
}
