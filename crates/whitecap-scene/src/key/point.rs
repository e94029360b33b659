//! Places in the world.

use super::colour::triple;
use super::{Accepts, Kind, Real};
use crate::error::SceneError;
use crate::reader::ValueReader;

/// A place `[x, y, z]` in metres, at most `far` from the origin east–west and north–south.
pub(crate) struct Point {
    pub(crate) far: f64,
    pub(crate) min_y: f64,
    pub(crate) max_y: f64,
}

impl Point {
    fn bounds(&self) -> ([f64; 3], [f64; 3]) {
        ([-self.far, self.min_y, -self.far], [self.far, self.max_y, self.far])
    }
}

impl Kind for Point {
    type Value = [f64; 3];

    fn accepts(&self) -> Accepts {
        let (min, max) = self.bounds();
        Accepts::Point { min, max }
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<[f64; 3], SceneError> {
        let (min, max) = self.bounds();
        let axis = |axis: usize| Real { unit: "m", min: min[axis], max: max[axis] };
        triple(value, &self.accepts(), [axis(0), axis(1), axis(2)])
    }
}
