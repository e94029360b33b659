//! How much of the scene's light makes the picture.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | EV100 | exposure value at ISO 100 | stops |
//! | E | illuminance that falls on a level sea | lx |
//! | Y | luminance of a grey card in it, 0.18 E/π | cd/m² |
//!
//! A camera at EV100 shows a luminance of 1.2 · 2^EV100 cd/m² as white (ISO 12232, saturation-based speed, lens
//! transmittance 0.65: 78/(100 · 0.65)). A light meter with a dome sets EV100 = log₂(100 E/C), C = 340 (ISO 2720).

use super::{LUMINANCE, SunLight};
use crate::View;
use glam::Vec3;
use std::f64::consts::{FRAC_PI_2, LN_2, PI};
use whitecap_scene::Picture;
use whitecap_waves::optics::fresnel_exact;
use whitecap_waves::optics::surface::SEA_REFRACTIVE_INDEX;

/// Luminance of white at EV100 = 0, kcd/m².
const WHITE_KCD_PER_M2: f64 = 1.2e-3;
/// The constant of a light meter with a dome; ISO 2720 allows 320 to 540.
const METER_LX: f64 = 340.0;
/// From this illuminance on it is day: a sun some degrees high.
const DAYLIGHT_LX: f64 = 8000.0;
/// How much of the way a picture follows the light below that, before what eyes make of it: evenings are to be seen, and to look
/// like evenings.
const ADAPTATION: f64 = 0.9;
/// Reflectance of a grey card, and what part of white it is to be in a picture.
const GREY: f64 = 0.18;

/// How bright a picture is to be whose grey has the luminance `y` in cd/m²: from 0.69 for sunshine to 0.03 for night, as eyes see
/// less and less light the less there is (Krawczyk, Myszkowski and Seidel 2005, "Perceptual Effects in Real-time Tone Mapping",
/// equation 11).
fn key(y: f64) -> f64 {
    1.03 - 2.0 / (2.0 + (y + 1.0).log10())
}

/// The exposure value that a camera would choose by itself where `illuminance_lx` falls on the sea, whatever it looks at.
pub(crate) fn automatic_ev100(illuminance_lx: f64) -> f64 {
    let light = illuminance_lx.max(1e-6);
    let dim = light.min(DAYLIGHT_LX);
    let followed = light.max(DAYLIGHT_LX).ln() + ADAPTATION * (dim / DAYLIGHT_LX).ln();
    let grey = |lx: f64| GREY * lx / PI;
    let darker = (key(grey(DAYLIGHT_LX)) / key(grey(dim))).log2();
    (100.0 / METER_LX).log2() + followed / LN_2 + darker
}

/// Rays across and down a view that its meter looks along.
const RAYS: [u32; 2] = [16, 9];
/// Stops below grey that a view may be on the mean as it is, and how much of what it is darker it gets more light.
const DARK_STOPS: f64 = 1.5;
const FOLLOWED: f64 = 0.75;
/// Of the rays, those beyond this share are highlights; they may be so much of white before a view gets less light, at most
/// this much less.
const HIGHLIGHTS: f64 = 0.85;
const BRIGHTEST: f64 = 2.0;
const LEAST_GAIN: f64 = 0.6;
/// Radiance out of deep clear water over the illuminance on it, 1/sr: R/(Q n²) of a per cent or two (Morel and Gentili 1993).
const WATER_PER_SR: f64 = 0.002;
/// Mean square slope of a breeze's sea, either axis (Cox and Munk 1954, 7 m/s).
const SLOPE_VARIANCE: f64 = 0.02;

/// What an automatic exposure makes of where a view looks.
///
/// It measures no picture, so it knows none before: along a grid of rays it takes a mean sky above the horizon and, below, what
/// the level sea sends there, mirrored sky, glitter and the water's own light. A view straight down, far darker than its grey, gets
/// more light, and one whose glitter is far brighter than white a little less.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Meter {
    /// What the picture's linear light is of 1 kcd/m², white being 1.
    exposure: f64,
    /// Luminance of a grey card that lies there, kcd/m².
    grey: f64,
    /// Mean radiance of the sky, kcd/m².
    sky: f64,
    /// Illuminance of the sun on what faces it, klx, and where it stands.
    sun_klx: f64,
    toward_sun: Vec3,
    /// Radiance out of the water, kcd/m².
    water: f64,
}

impl Meter {
    /// For the light of a scene, whose automatic exposure is `exposure`.
    pub(crate) fn new(exposure: f32, sky_klx: f64, sun: Option<&SunLight>) -> Self {
        let (sun_klx, toward_sun) =
            sun.map_or((0.0, Vec3::Y), |sun| (f64::from(sun.illuminance_klx.dot(LUMINANCE)), sun.toward));
        let on_level = sky_klx + sun_klx * f64::from(toward_sun.y).max(0.0);
        Self {
            exposure: f64::from(exposure),
            grey: (GREY * on_level / PI).max(1e-12),
            sky: sky_klx / PI,
            sun_klx,
            toward_sun,
            water: WATER_PER_SR * on_level,
        }
    }

    /// Luminance along a ray, kcd/m².
    fn luminance(&self, toward: Vec3) -> f64 {
        if toward.y >= 0.0 {
            return self.sky;
        }
        let cosine = f64::from(-toward.y);
        // A rough sea is not seen at grazing angles: the mean facet leans towards the eye.
        let seen = (cosine * cosine + FRAC_PI_2 * SLOPE_VARIANCE).sqrt().min(1.0);
        let half = (self.toward_sun - toward).normalize_or(Vec3::Y);
        let up = f64::from(half.y).max(0.05);
        let slope2 = (1.0 - up * up) / (up * up);
        let density = (-0.5 * slope2 / SLOPE_VARIANCE).exp() / (2.0 * PI * SLOPE_VARIANCE);
        let facet = f64::from(half.dot(self.toward_sun)).clamp(0.0, 1.0);
        let glitter =
            self.sun_klx * fresnel_exact(facet, SEA_REFRACTIVE_INDEX) * density / (4.0 * seen * up.powi(4));
        let is_up = f64::from(u8::from(self.toward_sun.y > 0.0));
        fresnel_exact(seen, SEA_REFRACTIVE_INDEX) * self.sky + self.water + is_up * glitter
    }

    /// How much more light than by [`automatic_ev100`] alone a view gets: 1 where it sees as much sky as water.
    pub(crate) fn gain(&self, view: &View) -> f32 {
        let world_from_clip = view.clip_from_eye_world().inverse();
        let mut seen: Vec<f64> = (0..RAYS[0] * RAYS[1])
            .map(|i| {
                let [x, y] = [i % RAYS[0], i / RAYS[0]];
                let at = |i: u32, count: u32| (i as f32 + 0.5) / count as f32 * 2.0 - 1.0;
                let ndc = Vec3::new(at(x, RAYS[0]), at(y, RAYS[1]), 0.5);
                let toward = world_from_clip.project_point3(ndc).try_normalize().unwrap_or(Vec3::Y);
                self.luminance(toward).max(1e-12)
            })
            .collect();
        // Against a grey card in the same light: evenings that are to look dark stay so.
        let darker = -seen.iter().map(|light| (light / self.grey).log2()).sum::<f64>() / seen.len() as f64
            - DARK_STOPS;
        seen.sort_by(f64::total_cmp);
        let highlight = self.exposure * seen[(HIGHLIGHTS * seen.len() as f64) as usize];
        let wanted = (FOLLOWED * darker).exp2().max(1.0);
        let most = (BRIGHTEST / highlight).max(LEAST_GAIN);
        let gain = wanted.min(most);
        // A view through nothing has no mean.
        if gain.is_finite() { gain as f32 } else { 1.0 }
    }
}

/// What a radiance of 1 kcd/m² becomes in the picture's linear light, white being 1. `ev` is added in stops.
pub(crate) fn exposure(picture: &Picture, illuminance_klx: f64, ev: f64) -> f32 {
    let ev100 = picture.exposure_ev100.unwrap_or_else(|| automatic_ev100(1000.0 * illuminance_klx));
    ((ev - ev100).exp2() / WHITE_KCD_PER_M2) as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use whitecap_scene::Camera;

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

    /// The sun 4° below the horizon gives some ten lux, 8° half of one, a night without moon a thousandth.
    #[test]
    fn dusk_is_dusky_and_night_is_dark() {
        let stops = |lx: f64| {
            (lx / 1000.0 * f64::from(exposure(&Picture::default(), lx / 1000.0, 0.0)) / shown_by_day()).log2()
        };
        let mut last = 0.1;
        for (lx, from, to) in [
            (3000.0, -0.5, 0.0),
            (300.0, -2.0, -0.7),
            (10.0, -5.0, -2.5),
            (0.5, -7.0, -4.0),
            (1e-3, -9.0, -5.0),
        ] {
            let darker = stops(lx);
            assert!((from..to).contains(&darker) && darker < last, "{lx} lx: {darker} stops");
            last = darker;
        }
    }

    fn shown_by_day() -> f64 {
        80.0 * f64::from(exposure(&Picture::default(), 80.0, 0.0))
    }

    fn gain(toward: [f64; 3], vertical_fov_deg: f64, sun_elevation_deg: f32) -> f64 {
        let (y, x) = sun_elevation_deg.to_radians().sin_cos();
        let sun =
            SunLight { toward: Vec3::new(x, y, 0.0), illuminance_klx: Vec3::splat(70.0), radius_rad: 0.005 };
        let exposure = exposure(&Picture::default(), 15.0 + 70.0 * f64::from(y), 0.0);
        let camera = Camera {
            position_m: [0.0, 5.0, 0.0],
            look_at_m: [toward[0], 5.0 + toward[1], toward[2]],
            vertical_fov_deg,
        };
        f64::from(Meter::new(exposure, 15.0, Some(&sun)).gain(&View::of_camera(&camera, [1280, 720])))
    }

    /// A level view is exposed by the light alone, the dark water straight down by what it sends up, and into the sun a stop less at
    /// most; what lies between changes without a step.
    #[test]
    fn a_view_down_gets_more_light_and_one_into_glitter_less() {
        for azimuth in [[0.0, 1.0], [-1.0, 0.0]] {
            let level = gain([azimuth[0], -0.05, azimuth[1]], 45.0, 45.0);
            assert!((level - 1.0).abs() < 0.3, "{level}");
        }
        let up = gain([0.0, 1.0, 0.1], 45.0, 45.0);
        assert_eq!(up, 1.0);
        let down = gain([0.0, -1.0, 0.0], 45.0, 20.0);
        assert!((2.5..8.0).contains(&down), "{down}");
        let into_the_sun = gain([1.0, -0.2, 0.0], 12.0, 20.0);
        assert!((f64::from(LEAST_GAIN as f32)..1.0).contains(&into_the_sun), "{into_the_sun}");
        let mut last = gain([0.0, 0.0, 1.0], 45.0, 30.0);
        for step in 1..=90 {
            let (down, along) = f64::from(step).to_radians().sin_cos();
            let here = gain([0.0, -down, along], 45.0, 30.0);
            assert!((here / last).log2().abs() < 0.2, "{step}°: {last} to {here}");
            last = here;
        }
    }
}
