//! How much of the scene's light makes the picture.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | EV100 | exposure value at ISO 100 | stops |
//! | E | illuminance that falls on a level sea | lx |
//!
//! A camera at EV100 shows a luminance of 1.2 · 2^EV100 cd/m² as white (ISO 12232, saturation-based speed, lens
//! transmittance 0.65: 78/(100 · 0.65)). A light meter with a dome sets EV100 = log₂(100 E/C), C = 340 (ISO 2720).

use whitecap_scene::Picture;

/// Luminance of white at EV100 = 0, kcd/m².
const WHITE_KCD_PER_M2: f64 = 1.2e-3;
/// The constant of a light meter with a dome; ISO 2720 allows 320 to 540.
const METER_LX: f64 = 340.0;
/// From this illuminance on it is day: a sun some degrees high.
const DAYLIGHT_LX: f64 = 8000.0;
/// How much of the way a picture follows the light below that: evenings are to be seen, and to look like evenings.
const ADAPTATION: f64 = 0.8;

/// The exposure value that a camera would choose by itself where `illuminance_lx` falls on the sea. It depends on nothing
/// else: a pan does not change it, nor does a frame before.
pub(crate) fn automatic_ev100(illuminance_lx: f64) -> f64 {
    let light = illuminance_lx.max(1e-6);
    let followed = light.max(DAYLIGHT_LX).ln() + ADAPTATION * (light.min(DAYLIGHT_LX) / DAYLIGHT_LX).ln();
    (100.0 / METER_LX).log2() + followed / std::f64::consts::LN_2
}

/// What a radiance of 1 kcd/m² becomes in the picture's linear light, white being 1. `ev` is added in stops.
pub(crate) fn exposure(picture: &Picture, illuminance_klx: f64, ev: f64) -> f32 {
    let ev100 = picture.exposure_ev100.unwrap_or_else(|| automatic_ev100(1000.0 * illuminance_klx));
    ((ev - ev100).exp2() / WHITE_KCD_PER_M2) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The photographers' rule: a sixteenth's aperture and a hundredth of a second in sunshine at ISO 100, EV 14.6.
    #[test]
    fn sunshine_is_exposed_by_the_rule_of_sixteen() {
        let rule = (16.0_f64 * 16.0 * 100.0).log2();
        assert!((automatic_ev100(80_000.0) - rule).abs() < 0.5, "{}", automatic_ev100(80_000.0));
        // A white surface in it is near white, and a grey card near middle grey.
        let exposure = f64::from(exposure(&Picture::default(), 80.0, 0.0));
        let white = exposure * 80.0 / std::f64::consts::PI;
        assert!((0.6..1.1).contains(&white), "{white}");
    }

    #[test]
    fn stops_double_and_evenings_stay_darker_than_days() {
        let manual = Picture { exposure_ev100: Some(12.0), ..Picture::default() };
        assert_eq!(exposure(&manual, 50.0, 1.0), 2.0 * exposure(&manual, 3.0, 0.0));
        let shown = |klx: f64| klx * f64::from(exposure(&Picture::default(), klx, 0.0));
        assert!((shown(100.0) / shown(10.0) - 1.0).abs() < 1e-3);
        assert!(shown(0.5) < 0.7 * shown(10.0) && shown(0.5) > 0.3 * shown(10.0));
        assert!(exposure(&Picture::default(), 0.0, 20.0).is_finite());
    }
}
