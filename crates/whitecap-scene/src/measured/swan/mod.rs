//! SWAN standard spectral files, version 1 (*SWAN User Manual*, appendix "Spectrum files, input and output").
//!
//! Key words say what follows: time coding, places, frequencies, directions, quantities with their exception
//! values; then for each time and place `FACTOR` and a table of integers, `ZERO`, `NODATA`, or without
//! directions `LOCATION` and a table of densities, mean directions and spreads.

mod header;
mod table;

pub(super) use header::is_swan;

use std::sync::Arc;

use super::{Format, MeasuredError, MeasuredProblem, MeasuredSea, Records, Text, Time};
use header::Header;

/// Reads every record: every place at every time.
pub(super) fn read(bytes: &[u8], name: &str) -> Result<Vec<MeasuredSea>, MeasuredError> {
    let mut text = Text::new(bytes, name)?;
    let header = Header::read(&mut text)?;
    let mut records = Records::default();
    let mut is_first = true;
    loop {
        let mut time = None;
        if header.has_times {
            let Some(line) = next(&mut text) else { break };
            let word = line.split_whitespace().next().unwrap_or_default();
            time = word.split_once('.').and_then(|(date, clock)| Time::compact(date, clock));
            if time.is_none() {
                return Err(text.unexpected(line, "a time: yyyymmdd.hhmmss"));
            }
        } else if !is_first {
            if let Some(line) = next(&mut text) {
                return Err(text.unexpected(line, "the end of a file without times"));
            }
            break;
        }
        is_first = false;
        for place in &header.places {
            let (begins, energy, missing) = table::read(&mut text, &header)?;
            let sea = MeasuredSea {
                source: Format::Swan,
                place: Arc::clone(place),
                time,
                frequencies_hz: Arc::clone(&header.frequencies_hz),
                energy,
                missing,
            };
            records.push(&text, begins, sea)?;
        }
    }
    records.all(&text)
}

/// The next line that is no comment.
fn next<'a>(text: &mut Text<'a>) -> Option<&'a str> {
    loop {
        let line = text.next()?;
        if !line.trim_start().starts_with(['$', '!']) {
            return Some(line);
        }
    }
}

/// As [`next`], where there must be one.
fn expect<'a>(text: &mut Text<'a>, wanted: &'static str) -> Result<&'a str, MeasuredError> {
    next(text).ok_or_else(|| text.error(MeasuredProblem::EndsEarly { wanted }))
}

/// The first word of a line.
fn first(line: &str) -> &str {
    line.split_whitespace().next().unwrap_or_default()
}
