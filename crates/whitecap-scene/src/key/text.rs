//! Names and times, as strings.

use super::number::wrong_type;
use super::{Accepts, Kind};
use crate::error::SceneError;
use crate::measured::Time;
use crate::reader::ValueReader;

/// A name that is not empty.
pub(crate) struct Name;

impl Kind for Name {
    type Value = String;

    fn accepts(&self) -> Accepts {
        Accepts::Name
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<String, SceneError> {
        let name = value.string().ok_or_else(|| wrong_type(value, &Accepts::Name))?;
        if name.is_empty() {
            return Err(value.error(format!("empty; accepted: {}", Accepts::Name)));
        }
        Ok(name.to_owned())
    }
}

/// A moment, UTC.
pub(crate) struct Moment;

impl Kind for Moment {
    type Value = Time;

    fn accepts(&self) -> Accepts {
        Accepts::Time
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<Time, SceneError> {
        let text = value.string().ok_or_else(|| wrong_type(value, &Accepts::Time))?;
        Time::parse(text).ok_or_else(|| value.error(format!("no time; accepted: {}", Accepts::Time)))
    }
}
