//! Colours and other triples by wavelength: red, green, blue.

use super::number::wrong_type;
use super::{Accepts, Kind, Real};
use crate::error::SceneError;
use crate::reader::ValueReader;

/// Red, green and blue, each of this unit and from `min` to `max`.
pub(crate) struct Colour {
    pub(crate) unit: &'static str,
    pub(crate) min: f64,
    pub(crate) max: f64,
}

impl Kind for Colour {
    type Value = [f64; 3];

    fn accepts(&self) -> Accepts {
        Accepts::Colour { min: self.min, max: self.max, unit: self.unit }
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<[f64; 3], SceneError> {
        let channel = || Real { unit: self.unit, min: self.min, max: self.max };
        triple(value, &self.accepts(), [channel(), channel(), channel()])
    }
}

/// An array of exactly three numbers.
pub(super) fn triple(
    value: &ValueReader<'_>,
    accepts: &Accepts,
    each: [Real; 3],
) -> Result<[f64; 3], SceneError> {
    let elements = value.array().ok_or_else(|| wrong_type(value, accepts))?;
    if elements.len() != 3 {
        let found = elements.len();
        return Err(value.error(format!("found {found} elements, wanted 3; accepted: {accepts}")));
    }
    let mut triple = [0.0; 3];
    for ((number, element), real) in triple.iter_mut().zip(&elements).zip(each) {
        *number = real.read(element)?;
    }
    Ok(triple)
}
