//! E(f, θ) on a compass: north up, bearings clockwise, each where its waves come from; frequency outwards.

use super::style::{Anchor, FAINT, HEADING, INK, LABEL, SURFACE, heat, written};
use super::{Area, Drawn, Figure};
use plotters::prelude::{Circle, Color, DrawingBackend, PathElement, Polygon, Rectangle, Text};
use whitecap_waves::direction::{nautical_from_toward, toward_from_nautical};

/// E is shown until S(f) stays below this share of its peak.
const LEAST: f64 = 0.03;
const CENTER: (i32, i32) = (545, 640);
const RADIUS: f64 = 440.0;
/// Cells outwards and around.
const OUTWARDS: u32 = 55;
const AROUND: u32 = 120;
/// The bar that explains the colours: left end, top, length and height.
const BAR: (i32, i32, i32, i32) = (165, 1255, 760, 34);

pub(super) fn draw<DB: DrawingBackend>(figure: &Figure<'_>, area: &Area<DB>) -> Drawn<DB> {
    let last_hz = figure.last_frequency_hz(LEAST);
    let density = |i: u32, j: f64| {
        let frequency_hz = last_hz * (f64::from(i) + 0.5) / f64::from(OUTWARDS);
        let bearing = j * 360.0 / f64::from(AROUND);
        // Per degree, as the bearings are.
        figure.theory.directional_density(frequency_hz, toward_from_nautical(bearing)).to_radians()
    };
    let cells: Vec<(u32, u32, f64)> = (0..OUTWARDS)
        .flat_map(|i| (0..AROUND).map(move |j| (i, j)))
        .map(|(i, j)| (i, j, density(i, f64::from(j) + 0.5)))
        .collect();
    let most = cells.iter().map(|cell| cell.2).fold(0.0, f64::max);

    let heading = "Spectrum E(f, direction), m²/(Hz deg)";
    area.draw(&Text::new(heading, (60, 30), written(HEADING, INK, Anchor::Left)))?;
    for (i, j, density) in cells {
        let share = if most > 0.0 { (density / most).sqrt() } else { 0.0 };
        if share > 0.015 {
            // A little larger than itself, so that no seam shows between two.
            let (inner, outer) = (ring(i) - 0.5, ring(i + 1) + 1.0);
            let (start, end) = (bearing(j) - 0.1, bearing(j + 1) + 0.1);
            let corners = vec![at(inner, start), at(outer, start), at(outer, end), at(inner, end)];
            area.draw(&Polygon::new(corners, heat(share).filled()))?;
        }
    }
    draw_compass(area)?;
    let from = figure.theory.statistics().mean_toward().map(nautical_from_toward);
    draw_rings(area, last_hz, names_at(from))?;
    if let Some(from) = from {
        let tip = vec![at(RADIUS - 14.0, from), at(RADIUS + 22.0, from - 2.6), at(RADIUS + 22.0, from + 2.6)];
        area.draw(&Polygon::new(tip, SURFACE.filled()))?;
    }
    draw_bar(area, most)
}

fn ring(i: u32) -> f64 {
    RADIUS * f64::from(i) / f64::from(OUTWARDS)
}

fn bearing(j: u32) -> f64 {
    f64::from(j) * 360.0 / f64::from(AROUND)
}

/// The place at a distance from the middle, in a direction clockwise from north.
fn at(radius: f64, bearing: f64) -> (i32, i32) {
    let (sin, cos) = bearing.to_radians().sin_cos();
    (CENTER.0 + (radius * sin).round() as i32, CENTER.1 - (radius * cos).round() as i32)
}

fn draw_compass<DB: DrawingBackend>(area: &Area<DB>) -> Drawn<DB> {
    for sector in 0..12 {
        let bearing = f64::from(sector) * 30.0;
        area.draw(&PathElement::new([at(0.0, 0.0), at(RADIUS, bearing)], FAINT.mix(0.3).stroke_width(1)))?;
        let (name, color) = match sector {
            0 => ("N".to_owned(), INK),
            3 => ("E".to_owned(), INK),
            6 => ("S".to_owned(), INK),
            9 => ("W".to_owned(), INK),
            _ => (format!("{bearing:.0}°"), FAINT),
        };
        area.draw(&Text::new(name, at(RADIUS + 55.0, bearing), written(LABEL, color, Anchor::Middle)))?;
    }
    Ok(())
}

/// The bearing where rings have their names: opposite to where the waves come from, between two rays.
fn names_at(from: Option<f64>) -> f64 {
    from.map_or(15.0, |from| ((from + 180.0) / 30.0).floor() * 30.0 + 15.0)
}

/// Rings at whole steps of frequency, with their names along a bearing.
fn draw_rings<DB: DrawingBackend>(area: &Area<DB>, last_hz: f64, names_at: f64) -> Drawn<DB> {
    let step_hz = step(last_hz);
    let count = (last_hz / step_hz).floor() as u32;
    for i in 1..=count {
        let frequency_hz = step_hz * f64::from(i);
        let radius = RADIUS * frequency_hz / last_hz;
        area.draw(&Circle::new(CENTER, radius.round() as u32, FAINT.mix(0.45).stroke_width(1)))?;
    }
    area.draw(&Circle::new(CENTER, RADIUS as u32, FAINT.stroke_width(2)))?;
    for i in 1..=count {
        let frequency_hz = step_hz * f64::from(i);
        let name = format!("{frequency_hz:.0$}", decimals(step_hz));
        let name = if i == count { format!("{name} Hz") } else { name };
        let place = at(RADIUS * frequency_hz / last_hz, names_at);
        area.draw(&Text::new(name, place, written(LABEL, INK, Anchor::Middle)))?;
    }
    Ok(())
}

/// 1, 2 or 5 times a power of ten, for three to six rings.
fn step(last: f64) -> f64 {
    let power = 10_f64.powf((last / 3.0).log10().floor());
    [5.0, 2.0].into_iter().map(|times| times * power).find(|&step| step <= last / 3.0).unwrap_or(power)
}

/// Enough to tell multiples of a step from each other.
fn decimals(step: f64) -> usize {
    (-step.log10() - 1e-9).ceil().clamp(0.0, 9.0) as usize
}

fn draw_bar<DB: DrawingBackend>(area: &Area<DB>, most: f64) -> Drawn<DB> {
    let (left, top, length, height) = BAR;
    for x in (0..length).step_by(4) {
        let color = heat(f64::from(x) / f64::from(length));
        area.draw(&Rectangle::new([(left + x, top), (left + x + 5, top + height)], color.filled()))?;
    }
    area.draw(&Rectangle::new([(left, top), (left + length, top + height)], FAINT.stroke_width(2)))?;
    let step = if most > 0.0 { step(most) } else { 1.0 };
    for density in (0..=(most / step) as u32).map(|i| f64::from(i) * step) {
        let share = if most > 0.0 { density / most } else { 0.0 };
        let x = left + (f64::from(length) * share.sqrt()).round() as i32;
        area.draw(&PathElement::new([(x, top + height), (x, top + height + 10)], FAINT.stroke_width(2)))?;
        let name = format!("{density:.0$}", decimals(step));
        area.draw(&Text::new(name, (x, top + height + 34), written(LABEL, FAINT, Anchor::Middle)))?;
    }
    let words = "colour: where waves come from; mark: mean direction";
    let place = (left + length / 2, top + height + 95);
    area.draw(&Text::new(words, place, written(LABEL, FAINT, Anchor::Middle)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn north_is_up_and_bearings_run_clockwise() {
        let (x, y) = CENTER;
        assert_eq!((at(100.0, 0.0), at(100.0, 90.0)), ((x, y - 100), (x + 100, y)));
        assert_eq!((at(100.0, 180.0), at(100.0, 270.0)), ((x, y + 100), (x - 100, y)));
    }

    #[test]
    fn there_are_three_to_seven_rings() {
        for tenths in 1..200 {
            let last = 0.013 * f64::from(tenths);
            let rings = (last / step(last) + 1e-9).floor();
            assert!((3.0..=7.5).contains(&rings), "{rings} rings up to {last}");
        }
    }
}
