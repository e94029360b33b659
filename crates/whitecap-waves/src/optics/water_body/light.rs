//! The light that comes up out of the water.

use super::WaterOptics;
use crate::optics::fresnel_exact;
use crate::optics::surface::SEA_REFRACTIVE_INDEX;
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// Q of water without a bottom. Morel and Gentili, *Appl. Opt.* 32, 1993, have 3.1 to 5.6.
const DEEP_SPREAD_SR: f64 = 4.0;

/// What a level surface reflects of light that comes alike from everywhere above: 2∫F c dc for n = 1.34.
const DIFFUSE_FRESNEL: f64 = 0.0669;

/// The mean cosine of scattering by Henyey and Greenstein, for Petzold's measured phase function (Mobley 1994).
const SCATTERING_COSINE: f64 = 0.924;

/// The light over the water, by colour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Daylight {
    /// Of the sun, on a plane that faces it.
    pub sun_irradiance: [f64; 3],
    /// Unit vector.
    pub toward_sun: DVec3,
    /// Of the sky, on a level plane.
    pub sky_irradiance: [f64; 3],
}

/// What a pixel has to know of the water under the surface. Radiances are above the surface, before its transmission:
/// divided by n² (Snell), to be multiplied by what the surface lets through towards the eye.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaterLight {
    /// Radiance of water without a bottom.
    pub deep: [f64; 3],
    /// Radiance of the bottom if there were no water.
    pub bottom: [f64; 3],
    /// Kd.
    pub attenuation_per_m: [f64; 3],
    /// b.
    pub scattering_per_m: [f64; 3],
    /// The sun's irradiance over n².
    pub sun: [f64; 3],
    /// How sharp crests are: the root of slope variance over height variance, that of a wave of one length.
    pub crest_wavenumber_per_m: f64,
}

impl WaterLight {
    /// E is the sun's and the sky's light below a level surface, L = R E/(Q n²). Light that the surface throws back
    /// down is left out: half of R, a few hundredths of deep water and up to a fifth over a bright bottom.
    pub fn new(
        optics: &WaterOptics,
        daylight: &Daylight,
        bottom_albedo: [f64; 3],
        crest_wavenumber_per_m: f64,
    ) -> WaterLight {
        let cos = daylight.toward_sun.y.max(0.0);
        let sun_part = (1.0 - fresnel_exact(cos, SEA_REFRACTIVE_INDEX)) * cos;
        let n2 = SEA_REFRACTIVE_INDEX * SEA_REFRACTIVE_INDEX;
        let below: [f64; 3] = std::array::from_fn(|i| {
            (sun_part * daylight.sun_irradiance[i] + (1.0 - DIFFUSE_FRESNEL) * daylight.sky_irradiance[i])
                / n2
        });
        WaterLight {
            deep: std::array::from_fn(|i| optics.reflectance[i] * below[i] / DEEP_SPREAD_SR),
            bottom: std::array::from_fn(|i| bottom_albedo[i] * below[i] / PI),
            attenuation_per_m: optics.attenuation_per_m,
            scattering_per_m: optics.scattering_per_m,
            sun: daylight.sun_irradiance.map(|irradiance| irradiance / n2),
            crest_wavenumber_per_m,
        }
    }
}

/// The radiance of water of depth `depth_m` (`f64::INFINITY` for no bottom) under a level surface, `view_cos` the
/// cosine between the view and the vertical in air.
///
/// Two flows (Lee and others, *Appl. Opt.* 37, 1998, with one K for both): R∞ (1 − e^(−2Kd)) + A e^(−2Kd), where the way
/// up is slanted as the view is: 1 + 1/μ instead of 2.
pub fn water_radiance(light: &WaterLight, depth_m: f64, view_cos: f64) -> [f64; 3] {
    let c = view_cos.clamp(0.0, 1.0);
    let mu = (1.0 - (1.0 - c * c) / (SEA_REFRACTIVE_INDEX * SEA_REFRACTIVE_INDEX)).sqrt();
    let way_m = depth_m.max(0.0) * (1.0 + 1.0 / mu);
    std::array::from_fn(|i| {
        let left = libm::exp(-light.attenuation_per_m[i] * way_m);
        light.deep[i] + (light.bottom[i] - light.deep[i]) * left
    })
}

/// Sunlight that comes through a crest: scattered once, forwards, inside it. In the units of [`water_radiance`], to
/// which it adds.
///
/// `slope` is the mean slope where the eye looks, `height_m` the height there over the mean level. The crest is a
/// wave of one length whose other side leans as much the other way; the sun comes in there. Through a parabola of
/// that wave's curvature a level ray at slope s and height h takes the way 2s/(k√(s² + k²h²)), k the wavenumber. Of
/// the view's own refracted ray, the part above the mean level counts, h over its descent; the shorter of the two
/// prevails as 1/(1/x + 1/y). Light on all ways fades by Kd over the crest; 1 − e^(−b l) of it is scattered. Level
/// water has no crest, and what it scatters is in its reflectance.
pub fn crest_light(
    light: &WaterLight,
    slope: DVec2,
    height_m: f64,
    toward_eye: DVec3,
    toward_sun: DVec3,
) -> [f64; 3] {
    let horizontal = DVec2::new(toward_eye.x, toward_eye.z);
    let leaning = -slope.dot(horizontal) / horizontal.length().max(1e-6);
    let front = DVec3::new(-slope.x, 1.0, -slope.y).normalize();
    let back = DVec3::new(-front.x, front.y, -front.z);
    let (sun_cos, view_cos) = (toward_sun.dot(back), toward_eye.dot(front));
    if leaning <= 0.0 || height_m <= 0.0 || sun_cos <= 0.0 || view_cos <= 0.0 {
        return [0.0; 3];
    }
    let view = refracted(toward_eye, front, view_cos);
    let sun = refracted(toward_sun, back, sun_cos);
    let k = light.crest_wavenumber_per_m;
    let kh = k * height_m;
    let chord_m = 2.0 * leaning / (k * (leaning * leaning + kh * kh).sqrt());
    let descent = (-view.y).max(0.05);
    let lit_m = chord_m * height_m / (height_m + chord_m * descent);

    // Henyey and Greenstein 1941.
    let g = SCATTERING_COSINE;
    let base = 1.0 + g * g + 2.0 * g * sun.dot(view);
    let phase = (1.0 - g * g) / (4.0 * PI * base * base.sqrt());
    // Snell: the beam below is as much wider as its cosine is larger.
    let entering = (1.0 - fresnel_exact(sun_cos, SEA_REFRACTIVE_INDEX)) * sun_cos / (-sun.dot(back));
    std::array::from_fn(|i| {
        let scattered = 1.0 - libm::exp(-light.scattering_per_m[i] * lit_m);
        let left = libm::exp(-light.attenuation_per_m[i] * chord_m);
        light.sun[i] * entering * phase * scattered * left
    })
}

/// The way into the water of a ray that comes from `toward`, `cos` its cosine with the normal.
fn refracted(toward: DVec3, normal: DVec3, cos: f64) -> DVec3 {
    let eta = 1.0 / SEA_REFRACTIVE_INDEX;
    let cos_below = (1.0 - eta * eta * (1.0 - cos * cos)).sqrt();
    -eta * toward + (eta * cos - cos_below) * normal
}
