//! Historical spectral wave density: the frequencies in the header, a line for each hour.

use std::sync::Arc;

use super::super::text::number;
use super::super::{Format, MeasuredError, MeasuredSea, Records, Text};
use super::{DENSITY, energy, missing, place, time};

/// Whether a file with this first line is of the format: columns of a time, then frequencies.
pub(in super::super) fn is_history(first_line: &str) -> bool {
    columns(first_line).is_some_and(|(_, words)| words.into_iter().next().and_then(number).is_some())
}

/// Whether the header has a column of minutes, and the words after the time.
fn columns(header: &str) -> Option<(bool, Vec<&str>)> {
    let mut words = header.trim_start().trim_start_matches('#').split_whitespace().peekable();
    let is_time = matches!(words.next()?, "YY" | "YYYY" | "yr")
        && matches!(words.next()?, "MM" | "mo")
        && matches!(words.next()?, "DD" | "dy")
        && matches!(words.next()?, "hh" | "hr");
    let has_minutes = words.next_if(|word| matches!(*word, "mm" | "mn")).is_some();
    is_time.then(|| (has_minutes, words.collect()))
}

/// Reads every record.
pub(in super::super) fn read(bytes: &[u8], name: &str) -> Result<Vec<MeasuredSea>, MeasuredError> {
    let mut text = Text::new(bytes, name)?;
    let header = text.expect(HEADER)?;
    let (has_minutes, words) = columns(header).ok_or_else(|| text.unexpected(header, HEADER))?;
    text.points(Some(&words.len().to_string()), "frequencies", 2)?;
    let frequencies_hz = words.iter().map(|word| text.number(word, HEADER)).collect::<Result<Vec<_>, _>>()?;
    // Some years begin at 0 Hz, which is no wave.
    let skipped = usize::from(frequencies_hz[0] == 0.0);
    let frequencies_hz: Arc<[f64]> = frequencies_hz[skipped..].into();
    text.points(Some(&frequencies_hz.len().to_string()), "frequencies", 2)?;
    text.ascending(&frequencies_hz)?;

    let place = Arc::new(place(name));
    let mut records = Records::default();
    while let Some(line) = text.next() {
        // A second line of the header, with the units.
        if line.trim_start().starts_with('#') {
            continue;
        }
        let mut words = line.split_whitespace();
        let time = time(&text, &mut words, has_minutes)?;
        let values = words.map(|word| DENSITY.read(&text, word)).collect::<Result<Vec<_>, _>>()?;
        if values.len() != skipped + frequencies_hz.len() {
            let found = format!("{} values", values.len());
            return Err(text.unexpected(&found, "as many values as the header has frequencies"));
        }
        let sea = MeasuredSea {
            source: Format::NdbcHistory,
            place: Arc::clone(&place),
            time: Some(time),
            frequencies_hz: Arc::clone(&frequencies_hz),
            energy: energy(&values[skipped..]),
            missing: missing(&values[skipped..]),
        };
        records.push(&text, text.line(), sea)?;
    }
    records.all(&text)
}

const HEADER: &str = "a header: YYYY MM DD hh, mm, and the frequencies in Hz";
