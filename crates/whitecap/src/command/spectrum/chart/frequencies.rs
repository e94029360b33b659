//! S(f): how the energy is spread over frequencies.

use super::style::{Anchor, FAINT, GRID, HEADING, INK, LABEL, SURFACE, THEORY, written};
use super::{Area, Drawn, Figure};
use plotters::prelude::{
    AreaSeries, ChartBuilder, Circle, Color, DrawingBackend, LineSeries, PathElement, Text,
};

/// S(f) is shown until it stays below this share of its peak.
const LEAST: f64 = 0.01;

pub(super) fn draw<DB: DrawingBackend>(figure: &Figure<'_>, area: &Area<DB>) -> Drawn<DB> {
    let last_hz = 1.05 * figure.last_frequency_hz(LEAST);
    let theory: Vec<(f64, f64)> =
        figure.theory.frequency_spectrum().into_iter().filter(|sample| sample.0 <= last_hz).collect();
    let surface: Vec<(f64, f64)> = figure
        .surface
        .bins
        .iter()
        .filter(|bin| bin.filled >= 0.5 && bin.frequency_hz <= last_hz)
        .map(|bin| (bin.frequency_hz, bin.density_m2phz))
        .collect();
    let most = theory.iter().chain(&surface).map(|sample| sample.1).fold(0.0, f64::max);
    let most = if most > 0.0 { 1.1 * most } else { 1.0 };

    let heading = "Spectrum S(f), m²/Hz";
    area.draw(&Text::new(heading, (60, 30), written(HEADING, INK, Anchor::Left)))?;
    let mut chart = ChartBuilder::on(area)
        .margin_top(70)
        .margin_left(20)
        .margin_right(60)
        .margin_bottom(60)
        .x_label_area_size(60)
        .y_label_area_size(120)
        .build_cartesian_2d(0.0..last_hz, 0.0..most)?;
    let decimals = decimals(most);
    chart
        .configure_mesh()
        .light_line_style(GRID.mix(0.0))
        .bold_line_style(GRID.stroke_width(2))
        .axis_style(FAINT.stroke_width(2))
        .label_style(written(LABEL, FAINT, Anchor::Middle))
        .x_labels(9)
        .y_labels(7)
        .x_label_formatter(&|hz| format!("{hz:.2}"))
        .y_label_formatter(&|density| format!("{density:.decimals$}"))
        .draw()?;
    chart.draw_series(AreaSeries::new(theory.iter().copied(), 0.0, THEORY.mix(0.12)))?;
    chart.draw_series(LineSeries::new(theory.iter().copied(), THEORY.stroke_width(5)))?;
    chart.draw_series(surface.iter().map(|&sample| Circle::new(sample, 9, SURFACE.filled())))?;

    let (width, height) = area.dim_in_pixel();
    let (width, height) = (width as i32, height as i32);
    let below = written(LABEL, FAINT, Anchor::Middle);
    area.draw(&Text::new("frequency, Hz", ((width + 80) / 2, height - 40), below))?;
    legend(area, width - 430, "measured on the surface")
}

/// Of this chart and the one below it.
fn legend<DB: DrawingBackend>(area: &Area<DB>, right: i32, surface: &str) -> Drawn<DB> {
    let words = |color| written(LABEL, color, Anchor::Left);
    let (x, first, second) = (right, 110, 155);
    area.draw(&PathElement::new([(x - 60, first), (x - 15, first)], THEORY.stroke_width(5)))?;
    area.draw(&Text::new("theory", (x, first), words(INK)))?;
    area.draw(&Circle::new((x - 37, second), 9, SURFACE.filled()))?;
    area.draw(&Text::new(surface.to_owned(), (x, second), words(INK)))
}

/// Enough for about seven different labels from 0 to `most`.
pub(super) fn decimals(most: f64) -> usize {
    (1.0 - most.log10()).ceil().clamp(0.0, 9.0) as usize
}
