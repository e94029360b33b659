//! High dynamic range in two 8-bit colours (Wenzel, "Ocean scene", in *Meshuggah*, 2002, after Cohen, Tchou,
//! Hawkins and Debevec 2001).

/// The largest exposure that the two parts can carry.
pub const MAX_EXPOSURE: f64 = 4.0;

/// Splits an exposure into two numbers in 0..=1, as the vertex program writes them to its two colours:
/// `((x − fract x) / 4, fract x)`, for x clamped to 0..=[`MAX_EXPOSURE`].
///
/// The pixel stage puts them together as 4 × first + second. Since that sum is linear, interpolating the
/// parts across a triangle is exact but for their quantisation.
///
/// ```
/// # use whitecap_waves::optics::exposure_split;
/// assert_eq!(exposure_split(2.5), (0.5, 0.5));
/// assert_eq!(exposure_split(4.0), (1.0, 0.0));
/// ```
pub fn exposure_split(x: f64) -> (f64, f64) {
    let x = x.clamp(0.0, MAX_EXPOSURE);
    let fraction = x - x.floor();
    ((x - fraction) / MAX_EXPOSURE, fraction)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::fresnel_jensen_golias;
    use proptest::prelude::*;

    #[test]
    fn known_values_at_exposure_four() {
        for (cos, x, split) in [
            (0.0, 4.0, (1.0, 0.0)),
            (0.1, 1.86603, (0.25, 0.86603)),
            (0.25, 0.67109, (0.0, 0.67109)),
            (1.0, 0.015625, (0.0, 0.015625)),
        ] {
            let exposure = 4.0 * fresnel_jensen_golias(cos);
            assert!((exposure - x).abs() < 1e-5);
            let (whole, fraction) = exposure_split(exposure);
            assert!((whole - split.0).abs() < 1e-12 && (fraction - split.1).abs() < 1e-5, "{cos}");
        }
    }

    #[test]
    fn beyond_the_range_it_clamps() {
        assert_eq!(exposure_split(17.3), (1.0, 0.0));
        assert_eq!(exposure_split(-2.5), (0.0, 0.0));
    }

    proptest! {
        #[test]
        fn the_parts_fit_and_add_up(x in 0.0..=4.0_f64) {
            let (whole, fraction) = exposure_split(x);
            prop_assert!((0.0..=1.0).contains(&whole) && (0.0..1.0).contains(&fraction));
            prop_assert!((4.0 * whole + fraction - x).abs() < 1e-15);
        }
    }
}
