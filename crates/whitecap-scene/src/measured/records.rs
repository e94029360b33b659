//! The records of a file, each place and time once.

use std::collections::HashMap;

use super::{MeasuredError, MeasuredProblem, MeasuredSea, Text, Time};

/// The most records of a file: a buoy takes a hundred years for as many.
const MOST_RECORDS: usize = 1 << 20;

/// The name of a place and the bits of its coordinates.
type Site = (Option<String>, Option<[u64; 2]>);

/// What was read of a file so far.
#[derive(Default)]
pub(super) struct Records {
    seas: Vec<MeasuredSea>,
    /// The line that each begins in.
    lines: Vec<usize>,
    /// Where the record of a time and a place's number is.
    by_number: HashMap<(Option<Time>, usize), usize>,
    /// Where that of a time and a site is, whatever the place's number.
    by_site: HashMap<(Option<Time>, Site), usize>,
}

impl Records {
    /// Adds a record that begins in this line. One of the same place and time that says the same is there already.
    ///
    /// # Errors
    ///
    /// If another of the same place and time says otherwise, or there are too many.
    pub(super) fn push(
        &mut self,
        text: &Text<'_>,
        line: usize,
        sea: MeasuredSea,
    ) -> Result<(), MeasuredError> {
        let index = self.seas.len();
        if let Some(&known) = self.by_number.get(&(sea.time, sea.place.number)) {
            return if self.seas[known] == sea { Ok(()) } else { Err(self.twice(text, line, known, &sea)) };
        }
        if index == MOST_RECORDS {
            let (count, most) = (index as u64 + 1, MOST_RECORDS as u64);
            return Err(text.error(MeasuredProblem::Count { what: "records", count, least: 1, most }));
        }
        // A place that a file lists twice keeps both its numbers.
        let site = (sea.place.name.clone(), sea.place.coordinates.map(|at| at.map(f64::to_bits)));
        let at_site = (sea.time, site);
        if let Some(&known) = self.by_site.get(&at_site) {
            let other = &self.seas[known];
            if (&other.frequencies_hz, &other.energy) != (&sea.frequencies_hz, &sea.energy) {
                return Err(self.twice(text, line, known, &sea));
            }
        }
        self.by_number.insert((sea.time, sea.place.number), index);
        self.by_site.entry(at_site).or_insert(index);
        self.lines.push(line);
        self.seas.push(sea);
        Ok(())
    }

    /// All of them, the file having ended.
    ///
    /// # Errors
    ///
    /// If there are none.
    pub(super) fn all(self, text: &Text<'_>) -> Result<Vec<MeasuredSea>, MeasuredError> {
        if self.seas.is_empty() { Err(text.error(MeasuredProblem::NoRecord)) } else { Ok(self.seas) }
    }

    fn twice(&self, text: &Text<'_>, line: usize, known: usize, sea: &MeasuredSea) -> MeasuredError {
        let time = sea.time.map(|time| format!(" of {time}")).unwrap_or_default();
        let record = format!("the record{time} at place {}", sea.place);
        text.error_at(line, MeasuredProblem::Twice { record, first: self.lines[known] })
    }
}
