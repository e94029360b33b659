//! Arrays of tables, such as `[[sea.system]]`.

use super::{Accepts, Kind};
use crate::error::SceneError;
use crate::reader::{TableReader, ValueReader};

/// From `min` to `max` tables `[[name]]`, each read by `read`.
pub(crate) struct Tables<T> {
    pub(crate) name: &'static str,
    pub(crate) min: usize,
    pub(crate) max: usize,
    pub(crate) read: fn(&TableReader<'_>) -> Result<T, SceneError>,
}

impl<T: Clone + serde::Serialize> Kind for Tables<T> {
    type Value = Vec<T>;

    fn accepts(&self) -> Accepts {
        Accepts::Tables { name: self.name, min: self.min, max: self.max }
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<Vec<T>, SceneError> {
        let tables = value.array().ok_or_else(|| value.wrong_type(&self.accepts().to_string()))?;
        if !(self.min..=self.max).contains(&tables.len()) {
            return Err(value.error(format!("found {}; accepted: {}", tables.len(), self.accepts())));
        }
        tables.into_iter().map(|table| (self.read)(&table.table()?)).collect()
    }
}
