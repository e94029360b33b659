//! The axes of the charts of S(f) and of the energy by direction.

use super::Area;
use super::style::{Anchor, FAINT, GRID, HEADING, INK, LABEL, written};
use plotters::chart::ChartContext;
use plotters::coord::types::RangedCoordf64;
use plotters::drawing::DrawingAreaErrorKind;
use plotters::prelude::{Cartesian2d, ChartBuilder, Color, DrawingBackend, Text};

type Chart<'a, DB> = ChartContext<'a, DB, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// A chart with the words above and below it, from 0 to `last` along, whose marks `mark` words, and from 0 to a little
/// over `most` upwards.
pub(super) fn draw<'a, DB: DrawingBackend>(
    area: &Area<DB>,
    [heading, below]: [&'static str; 2],
    last: f64,
    mark: &dyn Fn(&f64) -> String,
    most: f64,
) -> Result<Chart<'a, DB>, DrawingAreaErrorKind<DB::ErrorType>> {
    let most = if most > 0.0 { 1.1 * most } else { 1.0 };
    area.draw(&Text::new(heading, (60, 30), written(HEADING, INK, Anchor::Left)))?;
    let (width, height) = area.dim_in_pixel();
    let place = ((width as i32 + 80) / 2, height as i32 - 40);
    area.draw(&Text::new(below, place, written(LABEL, FAINT, Anchor::Middle)))?;
    let mut chart = ChartBuilder::on(area)
        .margin_top(70)
        .margin_left(20)
        .margin_right(60)
        .margin_bottom(60)
        .x_label_area_size(60)
        .y_label_area_size(120)
        .build_cartesian_2d(0.0..last, 0.0..most)?;
    let decimals = decimals(most);
    chart
        .configure_mesh()
        .light_line_style(GRID.mix(0.0))
        .bold_line_style(GRID.stroke_width(2))
        .axis_style(FAINT.stroke_width(2))
        .label_style(written(LABEL, FAINT, Anchor::Middle))
        .x_labels(9)
        .y_labels(7)
        .x_label_formatter(&mark)
        .y_label_formatter(&|value| format!("{value:.decimals$}"))
        .draw()?;
    Ok(chart)
}

/// Enough for about seven different labels from 0 to `most`.
fn decimals(most: f64) -> usize {
    (1.0 - most.log10()).ceil().clamp(0.0, 9.0) as usize
}
