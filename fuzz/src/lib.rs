//! What holds for every reader of measured seas.

use whitecap_scene::measured::{MeasuredError, MeasuredSea};

/// Sound records, or an error on one line.
pub fn check(read: Result<Vec<MeasuredSea>, MeasuredError>) {
    let is_sound = |m2: f64| m2 >= 0.0 && m2.is_finite();
    match read {
        Ok(seas) => {
            assert!(
                seas.iter().all(|sea| is_sound(sea.variance_m2()) && is_sound(sea.variance_missing_m2()))
            );
        }
        Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
    }
}
