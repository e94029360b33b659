//! Pairs: two numbers that belong together, such as the scroll of a map along u and v.

use super::number::wrong_type;
use super::{Accepts, Kind, Real};
use crate::error::SceneError;
use crate::reader::ValueReader;

/// Two numbers of this unit, each from `min` to `max`.
pub(crate) struct Pair {
    pub(crate) unit: &'static str,
    pub(crate) min: f64,
    pub(crate) max: f64,
}

impl Kind for Pair {
    type Value = [f64; 2];

    fn accepts(&self) -> Accepts {
        Accepts::Pair { min: self.min, max: self.max, unit: self.unit }
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<[f64; 2], SceneError> {
        let accepts = self.accepts();
        let elements = value.array().ok_or_else(|| wrong_type(value, &accepts))?;
        let [first, second] = elements.as_slice() else {
            let found = elements.len();
            return Err(value.error(format!("found {found} elements, wanted 2; accepted: {accepts}")));
        };
        let each = Real { unit: self.unit, min: self.min, max: self.max };
        Ok([each.read(first)?, each.read(second)?])
    }
}
