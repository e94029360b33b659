//! S(f): how the energy is spread over frequencies.

use super::style::{Anchor, INK, LABEL, SURFACE, THEORY, written};
use super::{Area, Drawn, Figure, axes};
use plotters::prelude::{AreaSeries, Circle, Color, DrawingBackend, LineSeries, PathElement, Text};

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
    let words = ["Spectrum S(f), m²/Hz", "frequency, Hz"];
    let mut chart = axes::draw(area, words, last_hz, &|hz| format!("{hz:.2}"), most)?;
    chart.draw_series(AreaSeries::new(theory.iter().copied(), 0.0, THEORY.mix(0.12)))?;
    chart.draw_series(LineSeries::new(theory.iter().copied(), THEORY.stroke_width(5)))?;
    chart.draw_series(surface.iter().map(|&sample| Circle::new(sample, 9, SURFACE.filled())))?;

    legend(area, area.dim_in_pixel().0 as i32 - 430, "measured on the surface")
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
