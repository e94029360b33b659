//! Where the scene is seen from.

use crate::error::SceneError;
use crate::key::{Point, Real, or, required, table};
use crate::mesh::Ground;
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

    /// What is unusual about where the eye is: in the ground that objects make, under a bottom `depth_m` deep, or in the
    /// water. One of them, that which hides most.
    pub(crate) fn warning(&self, depth_m: Option<f64>, ground: Option<&Ground>) -> Option<String> {
        let [x, y, z] = self.position_m;
        let place = format!("camera.position_m = {:?}: ", self.position_m);
        let over = |level_m: f64| level_m - y;
        if let Some(inside_m) = ground.and_then(|ground| ground.height_m(x, z)).map(over).filter(|m| *m > 0.0)
        {
            return Some(format!(
                "{place}{inside_m:.1} m inside the ground that the objects make there; it is seen from within"
            ));
        }
        if let Some(below_m) = depth_m.map(|depth_m| over(-depth_m)).filter(|m| *m > 0.0) {
            return Some(format!(
                "{place}{below_m:.1} m under the bottom of the sea; its surface is drawn as if seen from above"
            ));
        }
        (y < 0.0).then(|| {
            format!(
                "{place}{:.1} m under the level of the sea; its surface is drawn as if seen from above",
                -y
            )
        })
    }
}
