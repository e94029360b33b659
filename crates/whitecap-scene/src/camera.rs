//! Where the scene is seen from.

use crate::error::SceneError;
use crate::key::{Point, Real, or, required, table};
use crate::reader::TableReader;

/// How far from the origin a scene reaches east–west and north–south, metres.
const FAR_M: f64 = 1e7;

/// The shortest distance from the camera to what it looks at, metres.
const NEAREST_M: f64 = 0.001;

table! {
    /// Where the scene is seen from: the table `[camera]`. Places are `[x, y, z]`: x east, y up, z south.
    pub struct Camera {
        /// Where the eye is.
        position_m: [f64; 3] = required(Point { far: FAR_M, min_y: -100.0, max_y: 1e5 });
        /// A place in the middle of the picture.
        look_at_m: [f64; 3] = required(Point { far: FAR_M, min_y: -FAR_M, max_y: FAR_M });
        /// The angle between the picture's upper and lower edge.
        vertical_fov_deg: f64 = or(Real { unit: "deg", min: 1.0, max: 170.0 }, 45.0);
    }
}

impl Camera {
    pub(crate) fn read_checked(table: &TableReader<'_>) -> Result<Self, SceneError> {
        let camera = Self::read(table)?;
        let distance = glam::DVec3::from(camera.position_m).distance(camera.look_at_m.into());
        if distance < NEAREST_M {
            return Err(table.error(
                Some("look_at_m"),
                format!("the same place as position_m; accepted: at least {NEAREST_M} m away from it"),
            ));
        }
        Ok(camera)
    }
}
