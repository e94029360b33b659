//! Directions: from the seaman's bearings to vectors in the horizontal plane.
//!
//! A bearing is in degrees clockwise from north and names where weather comes *from*. Vectors have `.x` east
//! and `.y` south (the world's z), and point where it goes *to*.

use glam::DVec2;

/// The unit vector that weather from the bearing `from_deg` travels towards.
///
/// From 0 (north) runs towards +z, from 90 (east) towards −x, from 180 (south) towards −z, from 270 (west)
/// towards +x. Any finite number of degrees is accepted; turns beyond 360 wrap.
pub fn toward_from_nautical(from_deg: f64) -> DVec2 {
    // Reducing in degrees keeps large bearings exact. The bearing's own vector is (sin, −cos) in (east,
    // south); travel is opposite to it.
    let (sin, cos) = libm::sincos((from_deg % 360.0).to_radians());
    DVec2::new(-sin, cos)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_four_winds() {
        for (from_deg, toward) in [
            (0.0, DVec2::new(0.0, 1.0)),
            (90.0, DVec2::new(-1.0, 0.0)),
            (180.0, DVec2::new(0.0, -1.0)),
            (270.0, DVec2::new(1.0, 0.0)),
        ] {
            assert!(toward_from_nautical(from_deg).distance(toward) < 1e-15, "from {from_deg}");
        }
    }

    #[test]
    fn a_south_westerly_runs_north_east() {
        let toward = toward_from_nautical(225.0);
        assert!(toward.distance(DVec2::new(0.5_f64.sqrt(), -(0.5_f64.sqrt()))) < 1e-15);
    }

    proptest! {
        #[test]
        fn always_a_unit_vector_and_periodic(from_deg in -1e4..1e4_f64) {
            let toward = toward_from_nautical(from_deg);
            prop_assert!((toward.length() - 1.0).abs() < 1e-14);
            prop_assert!(toward.distance(toward_from_nautical(from_deg + 360.0)) < 1e-12);
        }
    }
}
