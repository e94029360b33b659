//! Numbers: reals with a unit and a range, counts, powers of two, seeds.

use super::{Accepts, Kind};
use crate::error::SceneError;
use crate::reader::ValueReader;

/// A number of this unit, from `min` to `max`.
pub(crate) struct Real {
    pub(crate) unit: &'static str,
    pub(crate) min: f64,
    pub(crate) max: f64,
}

impl Kind for Real {
    type Value = f64;

    fn accepts(&self) -> Accepts {
        Accepts::Real { min: self.min, max: self.max, unit: self.unit }
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<f64, SceneError> {
        let accepts = self.accepts();
        let number = value.real().ok_or_else(|| wrong_type(value, &accepts))?;
        // Written so that NaN is out of range.
        if (self.min..=self.max).contains(&number) { Ok(number) } else { Err(out_of_range(value, &accepts)) }
    }
}

/// An integer from `min` to `max`.
pub(crate) struct Count {
    pub(crate) min: u32,
    pub(crate) max: u32,
}

impl Kind for Count {
    type Value = u32;

    fn accepts(&self) -> Accepts {
        Accepts::Integer { min: self.min.into(), max: self.max.into() }
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<u32, SceneError> {
        integer(value, &self.accepts(), |count| (self.min..=self.max).contains(count))
    }
}

/// A power of two from `min` to `max`, which are powers of two themselves.
pub(crate) struct PowerOfTwo {
    pub(crate) min: u32,
    pub(crate) max: u32,
}

impl Kind for PowerOfTwo {
    type Value = u32;

    fn accepts(&self) -> Accepts {
        Accepts::Integers((0..32).map(|bit| 1 << bit).filter(|power| self.has(power)).collect())
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<u32, SceneError> {
        integer(value, &self.accepts(), |power| self.has(power))
    }
}

impl PowerOfTwo {
    fn has(&self, number: &u32) -> bool {
        number.is_power_of_two() && (self.min..=self.max).contains(number)
    }
}

/// The seed of a random stream: any integer that TOML can write and that is not negative.
pub(crate) struct Seed;

impl Seed {
    const MAX: u64 = i64::MAX as u64;
}

impl Kind for Seed {
    type Value = u64;

    fn accepts(&self) -> Accepts {
        Accepts::Integer { min: 0, max: Self::MAX }
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<u64, SceneError> {
        integer(value, &self.accepts(), |seed| *seed <= Self::MAX)
    }
}

fn integer<T: TryFrom<i128>>(
    value: &ValueReader<'_>,
    accepts: &Accepts,
    is_accepted: impl FnOnce(&T) -> bool,
) -> Result<T, SceneError> {
    let integer = value.integer().ok_or_else(|| wrong_type(value, accepts))?;
    let integer = T::try_from(integer).ok().filter(is_accepted);
    integer.ok_or_else(|| match accepts {
        Accepts::Integers(_) => value.error(format!("not one of the accepted sizes: {accepts}")),
        _ => out_of_range(value, accepts),
    })
}

pub(super) fn out_of_range(value: &ValueReader<'_>, accepts: &Accepts) -> SceneError {
    value.error(format!("out of range; accepted: {accepts}"))
}

pub(super) fn wrong_type(value: &ValueReader<'_>, accepts: &Accepts) -> SceneError {
    value.wrong_type(&format!("{}; accepted: {accepts}", accepts.type_name()))
}
