//! Which record of a file a scene means.

use super::{MeasuredProblem, MeasuredSea, Time};

/// The record that is wanted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection {
    /// The name of the place or its number from 1; `None` for the first.
    pub place: Option<String>,
    /// Which time.
    pub when: When,
}

/// The time of a record.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum When {
    /// The newest that has waves, and directions where there are files of them.
    #[default]
    Newest,
    /// The record of this time, which must be there and have waves.
    At(Time),
    /// So many records before the newest, which is 0, with those without waves counted.
    Back(usize),
}

/// The record that `selection` means.
///
/// # Errors
///
/// If there is no such place or time, with those that there are, or if it holds no waves.
pub fn select<'a>(
    seas: &'a [MeasuredSea],
    selection: &Selection,
) -> Result<&'a MeasuredSea, MeasuredProblem> {
    let first = seas.first().ok_or(MeasuredProblem::NoRecord)?;
    let wanted = match &selection.place {
        None => first.place.number,
        Some(asked) => {
            let named = |sea: &&MeasuredSea| sea.place.name.as_deref() == Some(asked.as_str());
            let numbered = |sea: &&MeasuredSea| asked.parse() == Ok(sea.place.number);
            let found = seas.iter().find(named).or_else(|| seas.iter().find(numbered));
            found.ok_or_else(|| no_such_place(seas, asked))?.place.number
        }
    };
    let records = newest_first(seas, wanted);
    match selection.when {
        When::Newest => {
            let count = records.len();
            let whole = |sea: &&&MeasuredSea| sea.has_waves() && sea.lacking_directions().is_none();
            let newest = records.iter().find(whole).or_else(|| records.iter().find(|sea| sea.has_waves()));
            newest.copied().ok_or_else(|| MeasuredProblem::NoWaves {
                which: if count == 1 {
                    "the only record is".to_owned()
                } else {
                    format!("{count} records are")
                },
                why: "every value is missing or 0",
            })
        }
        When::At(time) => {
            let label = |sea: Option<&&MeasuredSea>| match sea.and_then(|sea| sea.time) {
                Some(time) => time.to_string(),
                None => "no time".to_owned(),
            };
            records.iter().find(|sea| sea.time == Some(time)).copied().ok_or_else(|| {
                MeasuredProblem::NoSuchTime {
                    asked: time.to_string(),
                    count: records.len(),
                    first: label(records.last()),
                    last: label(records.first()),
                }
            })
        }
        When::Back(asked) => {
            let count = records.len();
            records.get(asked).copied().ok_or(MeasuredProblem::NoSuchRecord { asked, count })
        }
    }
}

/// The newest record of the place of `chosen`, one of `seas`, unless that is it: what choosing the newest with waves
/// and directions passes over.
pub fn passed_over<'a>(seas: &'a [MeasuredSea], chosen: &MeasuredSea) -> Option<&'a MeasuredSea> {
    let newest = newest_first(seas, chosen.place.number).into_iter().next()?;
    (!std::ptr::eq(newest, chosen)).then_some(newest)
}

/// The records of a place. Without times the last in the file counts as the newest.
fn newest_first(seas: &[MeasuredSea], place: usize) -> Vec<&MeasuredSea> {
    let mut records: Vec<_> = seas.iter().filter(|sea| sea.place.number == place).collect();
    records.reverse();
    records.sort_by_key(|sea| std::cmp::Reverse(sea.time));
    records
}

fn no_such_place(seas: &[MeasuredSea], asked: &str) -> MeasuredProblem {
    const MOST: usize = 12;
    let mut places: Vec<_> = seas.iter().map(|sea| &sea.place).collect();
    places.sort_by_key(|place| place.number);
    places.dedup_by_key(|place| place.number);
    let more = if places.len() > MOST { " …" } else { "" };
    let shown: Vec<_> = places.into_iter().take(MOST).map(ToString::to_string).collect();
    MeasuredProblem::NoSuchPlace { asked: asked.to_owned(), accepted: shown.join(", ") + more }
}
