//! Files of the US National Data Buoy Center, which holds the description of both formats
//! (*NDBC Web Data Guide*; *Measurement Descriptions and Units*).

mod history;
mod real_time;

pub(super) use history::{is_history, read as read_history};
pub(super) use real_time::{COMPANIONS, is_real_time, names_directions, read as read_real_time};

use super::text::{Text, number};
use super::time::{Time, digits};
use super::{Energy, MeasuredError, Place};

/// What a column holds, and the numbers that its missing values are written as. None of these is a value of the
/// column, or as in densities, none that is found: a bearing of 99° is one.
struct Column {
    accepted: &'static str,
    least: f64,
    most: f64,
    missing: &'static [f64],
}

const DENSITY: Column = Column {
    accepted: "a density from 0 to 1000000 m²/Hz, or MM or 999 where it is missing",
    least: 0.0,
    most: 1e6,
    missing: &[999.0],
};

const BEARING: Column = Column {
    accepted: "a bearing from 0 to 360, or MM or 999 where it is missing",
    least: 0.0,
    most: 360.0,
    missing: &[999.0],
};

const RATIO: Column = Column {
    accepted: "a number from 0 to 1, or MM or 999 where it is missing",
    least: 0.0,
    most: 1.0,
    missing: &[9.99, 99.0, 999.0],
};

/// Between swell and wind sea; nothing here depends on it.
const SEPARATION: Column = Column {
    accepted: "the separation frequency, then densities and their frequencies",
    least: 0.0,
    most: 100.0,
    missing: &[9.999, 99.0, 999.0],
};

impl Column {
    /// A value of it; `None` where it is missing.
    fn read(&self, text: &Text<'_>, word: &str) -> Result<Option<f64>, MeasuredError> {
        if word == "MM" {
            return Ok(None);
        }
        let value = number(word).ok_or_else(|| text.unexpected(word, self.accepted))?;
        if self.missing.contains(&value) {
            return Ok(None);
        }
        match (self.least..=self.most).contains(&value) {
            true => Ok(Some(value)),
            false => Err(text.unexpected(&value.to_string(), self.accepted)),
        }
    }
}

/// The frequencies of a record whose values are missing.
fn missing(values: &[Option<f64>]) -> Vec<usize> {
    (0..values.len()).filter(|i| values[*i].is_none()).collect()
}

/// The densities of a record in m²/Hz, where a missing value is no energy.
fn energy(values: &[Option<f64>]) -> Energy {
    if values.iter().all(Option::is_none) {
        return Energy::Missing;
    }
    let density: Vec<f64> = values.iter().map(|value| value.unwrap_or(0.0)).collect();
    if density.iter().all(|s| *s == 0.0) { Energy::Calm } else { Energy::Omnidirectional { density } }
}

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
