//! WAVEWATCH III point output of spectra (`ww3_outp`, transfer file; *User Manual and System Documentation of
//! WAVEWATCH III*, "Point output post-processor").
//!
//! A header with the counts, the frequencies in Hz and the directions; then for each time a line of date and
//! clock, and for each point a line with its name, latitude, longitude, depth, wind and current, and E(f, θ)
//! in m²/(Hz rad), frequencies within directions. The file's directions are radians clockwise from north
//! that waves travel towards: the program turns its own, which run from east, before it writes them.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

use super::text::number;
use super::{Energy, Format, MeasuredError, MeasuredProblem, MeasuredSea, Place, Records, Text, Time};

const TITLE: &str = "WAVEWATCH III SPECTRA";

/// Whether a file with this first line is of the format.
pub(super) fn is_ww3(first_line: &str) -> bool {
    first_line.trim_start().trim_start_matches('\'').starts_with(TITLE)
}

/// Reads every record: every point at every time.
pub(super) fn read(bytes: &[u8], name: &str) -> Result<Vec<MeasuredSea>, MeasuredError> {
    let mut text = Text::new(bytes, name)?;
    let header = text.expect(HEADER)?;
    let (_, counts) = in_quotes(header).ok_or_else(|| text.unexpected(header, HEADER))?;
    let mut counts = counts.split_whitespace();
    let frequencies = text.points(counts.next(), "frequencies", 2)?;
    let directions = text.points(counts.next(), "directions", 3)?;
    let points = counts.next().unwrap_or_default();
    let points: usize = points.parse().map_err(|_| text.unexpected(points, "a count of points"))?;
    if points == 0 {
        return Err(text.error(MeasuredProblem::NoRecord));
    }

    let frequencies_hz: Arc<[f64]> = text.numbers(frequencies, "frequencies in Hz")?.into();
    text.ascending(&frequencies_hz)?;
    let toward_rad = text.numbers_that(directions, "directions in radians", |text, toward| {
        // Digits are few; degrees are not radians.
        match (-0.01..=TAU + 0.01).contains(&toward) {
            true => Ok(toward),
            false => Err(text.unexpected(&toward.to_string(), "directions in radians, from 0 to 2π")),
        }
    })?;
    // From clockwise from north to clockwise from east.
    let toward_rad: Arc<[f64]> = toward_rad.into_iter().map(|toward| toward - FRAC_PI_2).collect();
    text.distinct(&toward_rad)?;

    let mut records = Records::default();
    while let Some(line) = text.next() {
        let mut words = line.split_whitespace();
        let time = words.next().zip(words.next()).and_then(|(date, clock)| Time::compact(date, clock));
        let time = time.ok_or_else(|| text.unexpected(line, "a time: yyyymmdd hhmmss"))?;
        for point in 1..=points {
            let line = text.expect(POINT)?;
            let begins = text.line();
            let place = place(line, point).ok_or_else(|| text.unexpected(line, POINT))?;
            let count = frequencies * directions;
            let values = text.numbers_that(count, "densities in m²/(Hz rad)", checked)?;
            let sea = MeasuredSea {
                source: Format::WaveWatch3,
                place: Arc::new(place),
                time: Some(time),
                frequencies_hz: Arc::clone(&frequencies_hz),
                energy: energy(&values, &toward_rad),
                missing: Vec::new(), // the format has no word for it
            };
            records.push(&text, begins, sea)?;
        }
    }
    records.all(&text)
}

fn checked(text: &Text<'_>, density: f64) -> Result<f64, MeasuredError> {
    match (0.0..=1e6).contains(&density) {
        true => Ok(density),
        false => Err(text.unexpected(&density.to_string(), "a density from 0 to 1000000 m²/(Hz rad)")),
    }
}

/// E with the directions within the frequencies.
fn energy(values: &[f64], toward_rad: &Arc<[f64]>) -> Energy {
    if values.iter().all(|value| *value == 0.0) {
        return Energy::Calm;
    }
    let frequencies = values.len() / toward_rad.len();
    let column = |frequency: usize| values.iter().skip(frequency).step_by(frequencies);
    let density = (0..frequencies).flat_map(column).copied().collect();
    Energy::Directional { toward_rad: Arc::clone(toward_rad), density }
}

/// A point: its name in quotes, which may hold blanks, latitude and longitude; the columns may touch where a
/// number is negative.
fn place(line: &str, number_from_1: usize) -> Option<Place> {
    let (name, rest) = in_quotes(line)?;
    let spaced = rest.replace('-', " -");
    let mut words = spaced.split_whitespace().map(number);
    let (latitude, longitude) = (words.next()??, words.next()??);
    Some(Place {
        number: number_from_1,
        name: Some(name.trim().to_owned()),
        coordinates: Some([longitude, latitude]),
    })
}

/// What stands in the quotes that a line begins with, and what follows them.
fn in_quotes(line: &str) -> Option<(&str, &str)> {
    line.trim_start().strip_prefix('\'')?.split_once('\'')
}

const HEADER: &str = "'WAVEWATCH III SPECTRA' and the counts of frequencies, directions and points";

const POINT: &str = "a point: its name in quotes, latitude, longitude …";
