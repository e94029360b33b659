//! Files of the US National Data Buoy Center, which holds the description of both formats
//! (*NDBC Web Data Guide*; *Measurement Descriptions and Units*).

mod history;
mod real_time;

pub(super) use history::{is_history, read as read_history};
pub(super) use real_time::{COMPANIONS, is_real_time, names_directions, read as read_real_time};

use super::text::{Text, number};
use super::time::{Time, digits};
use super::{Energy, MeasuredError, Place};

/// A value of a column; `None` where it is missing: `MM`, or a number of nines.
fn value(text: &Text<'_>, word: &str, accepted: &'static str) -> Result<Option<f64>, MeasuredError> {
    if word == "MM" {
        return Ok(None);
    }
    let value = number(word).ok_or_else(|| text.unexpected(word, accepted))?;
    Ok(Some(value).filter(|value| *value != 99.0 && *value != 999.0 && *value != 9999.0))
}

/// The densities of a record in m²/Hz, where a missing value is no energy.
fn energy(text: &Text<'_>, values: Vec<Option<f64>>) -> Result<Energy, MeasuredError> {
    if let Some(wrong) = values.iter().flatten().find(|value| !(0.0..=1e6).contains(*value)) {
        return Err(text.unexpected(&wrong.to_string(), DENSITY));
    }
    if values.iter().all(Option::is_none) {
        return Ok(Energy::Missing);
    }
    let density: Vec<f64> = values.into_iter().map(|value| value.unwrap_or(0.0)).collect();
    if density.iter().all(|s| *s == 0.0) { Ok(Energy::Calm) } else { Ok(Energy::Omnidirectional { density }) }
}

const DENSITY: &str = "a density from 0 to 1000000 m²/Hz, or MM or 999 where it is missing";

/// The time that a line begins with: year (of two or four digits), month, day, hour, and the minute if there
/// is a column for it.
fn time<'a>(
    text: &Text<'_>,
    words: &mut impl Iterator<Item = &'a str>,
    has_minutes: bool,
) -> Result<Time, MeasuredError> {
    let mut parts = [0; 6];
    for part in &mut parts[..if has_minutes { 5 } else { 4 }] {
        let word = words.next().unwrap_or_default();
        *part = digits(word).ok_or_else(|| text.unexpected(word, TIME))?;
    }
    // Files before 1999 write the last two digits of the year; the first buoys are of the seventies.
    parts[0] += match parts[0] {
        70..=99 => 1900,
        0..=69 => 2000,
        _ => 0,
    };
    Time::new(parts).ok_or_else(|| text.unexpected(&format!("{parts:?}"), TIME))
}

const TIME: &str = "a time: year month day hour, and minute";

/// A buoy's file is of one place, named by the file.
fn place(name: &str) -> Place {
    let stem = std::path::Path::new(name).file_stem().map(|stem| stem.to_string_lossy().into_owned());
    Place { number: 1, name: stem, coordinates: None }
}
