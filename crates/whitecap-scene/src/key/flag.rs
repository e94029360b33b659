//! Yes or no.

use super::number::wrong_type;
use super::{Accepts, Kind};
use crate::error::SceneError;
use crate::reader::ValueReader;

/// `true` or `false`.
pub(crate) struct Flag;

impl Kind for Flag {
    type Value = bool;

    fn accepts(&self) -> Accepts {
        Accepts::Flag
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<bool, SceneError> {
        value.flag().ok_or_else(|| wrong_type(value, &Accepts::Flag))
    }
}
