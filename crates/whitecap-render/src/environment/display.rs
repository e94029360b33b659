//! The display encoding that the classics' raw 8-bit values stand for.
//!
//! IEC 61966-2-1 (sRGB), carried on above 1 so that a bright sky keeps its range in a float texture.

/// Display value of linear light; 0 for negative light.
pub fn display_from_linear(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { 12.92 * linear.max(0.0) } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

/// Linear light of a display value. Twin of `linear_from_display` in `display.wesl`.
pub fn linear_from_display(display: f32) -> f32 {
    if display <= 0.040_45 { display / 12.92 } else { ((display + 0.055) / 1.055).powf(2.4) }
}

/// Where the response of [`exposed`] leaves the straight line, and what it tends to.
const SHOULDER: (f32, f32) = (0.35, 1.0);

/// Radiance from here on is a source of light, not a bright sky, and keeps its range.
const SOURCE: f32 = 20.0;

/// The response of the picture that an environment map stands for: straight in the shadows, a shoulder
/// that holds the colour of a bright sky below white, and the full range for the sun, whose reflections
/// are what exposure is there for. Twin of `exposed` in `display.wesl`.
pub fn exposed(linear: f32) -> f32 {
    let (low, high) = SHOULDER;
    let sky = linear.min(SOURCE);
    let rolled =
        if sky <= low { sky } else { low + (high - low) * (1.0 - (-(sky - low) / (high - low)).exp()) };
    rolled + (linear - SOURCE).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_response_rises_everywhere_and_keeps_the_sun() {
        let mut last = -1.0;
        for i in 0..4000 {
            let light = 1e-3 * 1.005_f32.powi(i);
            let response = exposed(light);
            assert!(response >= last);
            last = response;
        }
        assert_eq!(exposed(0.2), 0.2);
        assert!(exposed(10.0) <= 1.0);
        assert!((exposed(10_000.0) / 10_000.0 - 1.0).abs() < 0.01);
    }

    #[test]
    fn encoding_and_decoding_are_inverse_beyond_one_too() {
        for linear in [0.0, 0.001, 0.0031308, 0.18, 1.0, 37.0, 60_000.0_f32] {
            let back = linear_from_display(display_from_linear(linear));
            assert!((back - linear).abs() <= 1e-3 * linear.max(1e-3), "{linear} came back as {back}");
        }
        assert!((display_from_linear(1.0) - 1.0).abs() < 1e-6);
        assert!((display_from_linear(0.18) - 0.4613).abs() < 1e-3);
    }
}
