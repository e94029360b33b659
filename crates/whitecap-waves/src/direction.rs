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

/// The bearing in degrees, from 0 to 360, that weather which travels `toward` comes from: the inverse of
/// [`toward_from_nautical`] for a vector of any length above 0. 0 for no direction at all.
pub fn nautical_from_toward(toward: DVec2) -> f64 {
    let bearing = libm::atan2(-toward.x, toward.y).to_degrees();
    // Adding 360 to what is just below 0 rounds to 360, which is 0.
    let bearing = if bearing < 0.0 { bearing + 360.0 } else { bearing };
    if bearing >= 360.0 { 0.0 } else { bearing + 0.0 }
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

    #[test]
    fn bearings_are_never_360_and_never_minus_0() {
        for (toward, from_deg) in [
            (DVec2::new(0.0, 3.0), 0.0),
            (DVec2::new(-0.0, 1.0), 0.0),
            (DVec2::new(1e-300, 1.0), 0.0),
            (DVec2::new(-2.0, 0.0), 90.0),
            (DVec2::new(0.1, 0.0), 270.0),
            (DVec2::ZERO, 0.0),
        ] {
            let found = nautical_from_toward(toward);
            assert_eq!((found, found.is_sign_positive()), (from_deg, true), "{toward}");
        }
    }

    proptest! {
        #[test]
        fn there_and_back(from_deg in 0.0..360.0_f64) {
            prop_assert!((nautical_from_toward(2.5 * toward_from_nautical(from_deg)) - from_deg).abs() < 1e-11);
        }

        #[test]
        fn always_a_unit_vector_and_periodic(from_deg in -1e4..1e4_f64) {
            let toward = toward_from_nautical(from_deg);
            prop_assert!((toward.length() - 1.0).abs() < 1e-14);
            prop_assert!(toward.distance(toward_from_nautical(from_deg + 360.0)) < 1e-12);
        }
    }
}
