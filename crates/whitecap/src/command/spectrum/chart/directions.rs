//! How the energy is spread over the directions that waves come from.

use super::frequencies::decimals;
use super::style::{Anchor, FAINT, GRID, HEADING, INK, LABEL, SURFACE, THEORY, written};
use super::{Area, Drawn, Figure};
use glam::DVec2;
use plotters::prelude::{AreaSeries, ChartBuilder, Color, DrawingBackend, LineSeries, PathElement, Text};
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
    let most = if most > 0.0 { 1.1 * most } else { 1.0 };

    let heading = "Energy by direction, % per degree";
    area.draw(&Text::new(heading, (60, 30), written(HEADING, INK, Anchor::Left)))?;
    let mut chart = ChartBuilder::on(area)
        .margin_top(70)
        .margin_left(20)
        .margin_right(60)
        .margin_bottom(60)
        .x_label_area_size(60)
        .y_label_area_size(120)
        .build_cartesian_2d(0.0..360.0 / STEP_DEG, 0.0..most)?;
    let decimals = decimals(most);
    chart
        .configure_mesh()
        .light_line_style(GRID.mix(0.0))
        .bold_line_style(GRID.stroke_width(2))
        .axis_style(FAINT.stroke_width(2))
        .label_style(written(LABEL, FAINT, Anchor::Middle))
        .x_labels(9)
        .y_labels(7)
        .x_label_formatter(&|steps| format!("{:.0}°", steps * STEP_DEG))
        .y_label_formatter(&|share| format!("{share:.decimals$}"))
        .draw()?;
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
    let (width, height) = area.dim_in_pixel();
    let below = written(LABEL, FAINT, Anchor::Middle);
    let place = ((width as i32 + 80) / 2, height as i32 - 40);
    area.draw(&Text::new("direction that waves come from, clockwise from north", place, below))
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
