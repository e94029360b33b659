//! Sea states and winds as forecasts name them.
//!
//! | code | sea (WMO code table 3700) | Hs in m | the Hs taken here |
//! | --- | --- | --- | --- |
//! | 0 | calm (glassy) | 0 | 0 |
//! | 1 | calm (rippled) | 0 to 0.1 | 0.05 |
//! | 2 | smooth (wavelets) | 0.1 to 0.5 | 0.3 |
//! | 3 | slight | 0.5 to 1.25 | 0.875 |
//! | 4 | moderate | 1.25 to 2.5 | 1.875 |
//! | 5 | rough | 2.5 to 4 | 3.25 |
//! | 6 | very rough | 4 to 6 | 5 |
//! | 7 | high | 6 to 9 | 7.5 |
//! | 8 | very high | 9 to 14 | 11.5 |
//! | 9 | phenomenal | over 14 | 15 |
//!
//! The height taken is the middle of the range; the open range of code 9 has none, and 15 m is taken. A height
//! alone makes a sea by [`fully_developed_period_s`](super::pierson_moskowitz::fully_developed_period_s).

use crate::error::{ParameterError, check};

/// The least and the greatest Hs in metres of each code.
const RANGES_M: [(f64, f64); 10] = [
    (0.0, 0.0),
    (0.0, 0.1),
    (0.1, 0.5),
    (0.5, 1.25),
    (1.25, 2.5),
    (2.5, 4.0),
    (4.0, 6.0),
    (6.0, 9.0),
    (9.0, 14.0),
    (14.0, f64::INFINITY),
];

/// What stands for "over 14 m".
const PHENOMENAL_M: f64 = 15.0;

/// The least and the greatest significant height in metres of the WMO sea-state `code`, 0 to 9; the greatest of
/// 9 is infinite.
///
/// # Errors
///
/// If there is no such code.
pub fn significant_height_range_m(code: u32) -> Result<(f64, f64), ParameterError> {
    check("sea_state", f64::from(code), "from 0 to 9", |code| code <= 9.0)?;
    Ok(RANGES_M[code as usize])
}

/// The significant height in metres taken for the WMO sea-state `code`, 0 to 9: the middle of its range, 15 m
/// for 9.
///
/// # Errors
///
/// If there is no such code.
pub fn significant_height_m(code: u32) -> Result<f64, ParameterError> {
    let (least, greatest) = significant_height_range_m(code)?;
    Ok(if greatest.is_finite() { 0.5 * (least + greatest) } else { PHENOMENAL_M })
}

/// The wind in m/s, 10 m above the sea, of the Beaufort `number`, 0 to 12: U = 0.836 B^1.5 (WMO, *The Beaufort
/// Scale of Wind Force*, 1970), which is the middle of each number's range.
///
/// # Errors
///
/// If there is no such number.
pub fn beaufort_wind_mps(number: u32) -> Result<f64, ParameterError> {
    check("beaufort", f64::from(number), "from 0 to 12", |number| number <= 12.0)?;
    let number = f64::from(number);
    Ok(0.836 * number * number.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_has_the_height_of_the_table() {
        let heights = [0.0, 0.05, 0.3, 0.875, 1.875, 3.25, 5.0, 7.5, 11.5, 15.0];
        for (code, height) in (0..).zip(heights) {
            assert!((significant_height_m(code).unwrap() - height).abs() < 1e-12, "{code}");
            let (least, greatest) = significant_height_range_m(code).unwrap();
            assert!((least..=greatest).contains(&height));
            if code > 0 {
                assert_eq!(significant_height_range_m(code - 1).unwrap().1, least, "a gap below {code}");
            }
        }
        assert!(significant_height_m(10).is_err() && significant_height_m(u32::MAX).is_err());
    }

    /// Each lies within the range of the Beaufort table, in m/s.
    #[test]
    fn winds_of_the_beaufort_scale() {
        let ranges = [
            (0.0, 0.2),
            (0.3, 1.5),
            (1.6, 3.3),
            (3.4, 5.4),
            (5.5, 7.9),
            (8.0, 10.7),
            (10.8, 13.8),
            (13.9, 17.1),
            (17.2, 20.7),
            (20.8, 24.4),
            (24.5, 28.4),
            (28.5, 32.6),
            (32.7, 100.0),
        ];
        for (number, (least, greatest)) in (0..).zip(ranges) {
            let wind = beaufort_wind_mps(number).unwrap();
            assert!((least..=greatest).contains(&wind), "{number}: {wind}");
        }
        // The formula passes 12's lower bound, 32.7, at 34.75.
        assert!((beaufort_wind_mps(12).unwrap() - 34.752).abs() < 1e-3);
        assert!(beaufort_wind_mps(13).is_err());
    }
}
