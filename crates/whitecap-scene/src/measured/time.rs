//! Moments of coordinated universal time, as records are labelled with them.

use std::fmt;

/// A moment to the second, UTC. It prints as `2022-09-12T06:00:00Z`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Time {
    year: u16,
    month: u8,
    day: u8,
    hour: u8,
    minute: u8,
    second: u8,
}

impl Time {
    /// A moment from year, month, day, hour, minute and second; `None` if the calendar has no such.
    pub fn new(parts: [u32; 6]) -> Option<Self> {
        let [year, month, day, hour, minute, second] = parts;
        let leap = year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
        let days = match month {
            1 | 3 | 5 | 7 | 8 | 10 | 12 => 31,
            4 | 6 | 9 | 11 => 30,
            2 if leap => 29,
            2 => 28,
            _ => return None,
        };
        let is_there = (1..=9999).contains(&year)
            && (1..=days).contains(&day)
            && hour <= 23
            && minute <= 59
            && second <= 59;
        is_there.then_some(Self {
            year: year as u16,
            month: month as u8,
            day: day as u8,
            hour: hour as u8,
            minute: minute as u8,
            second: second as u8,
        })
    }

    /// Reads `2022-09-12T06:00:00Z`; the seconds and the `Z` may be left out.
    pub fn parse(text: &str) -> Option<Self> {
        let (date, clock) = text.strip_suffix('Z').unwrap_or(text).split_once('T')?;
        let mut date = date.split('-').map(digits);
        let mut clock = clock.split(':').map(digits);
        let mut parts = [0; 6];
        for part in &mut parts[..3] {
            *part = date.next()??;
        }
        for part in &mut parts[3..5] {
            *part = clock.next()??;
        }
        if let Some(seconds) = clock.next() {
            parts[5] = seconds?;
        }
        if date.next().is_some() || clock.next().is_some() {
            return None;
        }
        Self::new(parts)
    }

    /// Reads `20220912` and `060000`.
    pub(super) fn compact(date: &str, clock: &str) -> Option<Self> {
        let (date, clock) =
            (digits(date).filter(|_| date.len() == 8)?, digits(clock).filter(|_| clock.len() == 6)?);
        Self::new([
            date / 10_000,
            date / 100 % 100,
            date % 100,
            clock / 10_000,
            clock / 100 % 100,
            clock % 100,
        ])
    }
}

/// A number of digits alone.
pub(super) fn digits(text: &str) -> Option<u32> {
    if text.bytes().all(|byte| byte.is_ascii_digit()) { text.parse().ok() } else { None }
}

impl fmt::Display for Time {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { year, month, day, hour, minute, second } = self;
        write!(f, "{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}Z")
    }
}

impl serde::Serialize for Time {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_what_it_prints_and_shorter() {
        let time = Time::new([2022, 9, 12, 6, 0, 0]).unwrap();
        assert_eq!(time.to_string(), "2022-09-12T06:00:00Z");
        for text in ["2022-09-12T06:00:00Z", "2022-09-12T06:00:00", "2022-09-12T06:00Z", "2022-09-12T06:00"] {
            assert_eq!(Time::parse(text), Some(time), "{text}");
        }
        assert_eq!(Time::compact("20220912", "060000"), Some(time));
    }

    #[test]
    fn refuses_what_no_calendar_has() {
        for text in [
            "2022-02-29T00:00",
            "1900-02-29T00:00",
            "2022-13-01T00:00",
            "2022-00-01T00:00",
            "2022-01-01T24:00",
            "2022-01-01",
            "2022-01-01T00:00:00:00",
            "2022-01-01T+1:00",
            "99999999999-01-01T00:00",
            "",
        ] {
            assert_eq!(Time::parse(text), None, "{text}");
        }
        assert!(Time::parse("2000-02-29T00:00").is_some());
        assert_eq!(Time::compact("2022912", "060000"), None);
    }
}
