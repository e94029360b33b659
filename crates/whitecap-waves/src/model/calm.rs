//! Water that does not move.

use super::{Surface, SurfacePoint};
use glam::DVec2;

/// A surface at rest: level, at y = 0, for ever.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Calm;

impl Surface for Calm {
    fn variance_m2(&self) -> f64 {
        0.0
    }

    fn sample(&self, _rest_m: DVec2, _time_s: f64) -> SurfacePoint {
        SurfacePoint::upright(0.0, DVec2::ZERO, 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn it_is_level_everywhere() {
        let point = Calm.sample(DVec2::new(1e6, -3.0), 1e6);
        assert_eq!((point.displacement_m, point.normal), (DVec3::ZERO, DVec3::Y));
        assert_eq!((point.jacobian, point.slope, Calm.variance_m2()), (1.0, DVec2::ZERO, 0.0));
    }
}
