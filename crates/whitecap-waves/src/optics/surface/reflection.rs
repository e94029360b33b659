//! What a rough sea reflects of the light around.

use super::masking::shown_share;
use super::{VisibleFacets, level};
use crate::optics::{fresnel_exact, visible_cosine};
use glam::DVec3;

/// Where to read the light around, and what it counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReflectionTap {
    /// Unit vector, never below the horizon.
    pub toward: DVec3,
    /// The share of its radiance that reaches the eye.
    pub weight: f64,
    /// Standard deviation of the light's direction in height, radians.
    pub spread_along_rad: f64,
    /// The same along the horizon.
    pub spread_across_rad: f64,
}

/// What reaches the eye: the sum over `taps` of weight × radiance, and `water_weight` × the water's own radiance.
/// The weights add up to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeaReflection {
    /// From the facets that reflect lowest to those that reflect highest.
    pub taps: [ReflectionTap; 3],
    /// The share of the water's own radiance.
    pub water_weight: f64,
}

/// The deviation of each tap's blur in that of all that reflects, where waves hide all but crests and what it grows by where
/// they hide nothing: at grazing angles taps have to tell up from down, further down the sky's change with elevation.
const TAP_BLUR: f64 = 0.5;
const TAP_BLUR_SEEN: f64 = 0.1;
/// A tap reaches so many of its deviations to either side.
const TAP_REACH: f64 = 2.5;

/// The reflection of the light around, to be read from a prefiltered map.
///
/// A facet turns the reflection by twice its angle along the view and by twice that times the cosine of incidence
/// across: that is why reflections are drawn out towards the viewer. What is reflected downwards, or upwards into
/// waves ([`shown_share`]), meets a facet of another wave, and from there comes the sky higher up, by the share
/// that this facet reflects, or the water. That facet's slope is taken from `visible_cosine` for the whole sea. Third
/// reflections are left to the water.
///
/// Against a random walk on a surface by Smith, what the taps reflect is right to 0.005 of the light for deviations
/// up to 0.15 and to 0.008 up to 0.35; a sky four times as bright at the horizon as overhead is right to 10 %.
pub fn sea_reflection(facets: &VisibleFacets, toward_eye: DVec3, n: f64) -> SeaReflection {
    let (mut mean, mut square) = (0.0, 0.0);
    for (slope, weight) in facets.reflecting_slopes.iter().zip(facets.reflecting_weights) {
        mean += weight * slope;
        square += weight * slope * slope;
    }
    // Taps are drawn together so that they and their blur keep the variance of all that reflects.
    let tap_blur = TAP_BLUR + TAP_BLUR_SEEN * facets.seen_share;
    let tap_spacing = (1.0 - tap_blur * tap_blur).sqrt();
    let blur = tap_blur * (square - mean * mean).max(0.0).sqrt();
    let taps: [ReflectionTap; 3] = std::array::from_fn(|i| {
        let slope = mean + tap_spacing * (facets.reflecting_slopes[i] - mean);
        let weight = facets.mean_fresnel * facets.reflecting_weights[i];
        tap(facets, toward_eye, n, &Lobe { slope, blur, weight })
    });
    SeaReflection { taps, water_weight: 1.0 - taps.iter().map(|tap| tap.weight).sum::<f64>() }
}

/// Facets that reflect as one: their slope towards the eye, its deviation, and what they reflect.
struct Lobe {
    slope: f64,
    blur: f64,
    weight: f64,
}

fn tap(facets: &VisibleFacets, toward_eye: DVec3, n: f64, lobe: &Lobe) -> ReflectionTap {
    let toward = facets.toward;
    let sea_variance = facets.sea.between(toward, toward);
    let a = lobe.slope;
    let b = facets.across_slope + facets.across_per_slope * a;
    let facet = DVec3::new(a * toward.x - b * toward.y, 1.0, a * toward.y + b * toward.x).normalize();
    let cos = toward_eye.dot(facet);
    let reflected = 2.0 * cos * facet - toward_eye;

    let tilt = 1.0 + a * a;
    let along = (2.0 * lobe.blur / tilt).max(1e-4);
    let across = 2.0 * cos.abs() * (facets.across_variance / tilt).sqrt();

    // The part of the blurred tap above the horizon, and its elevation times that part: those of a cubic ramp and a
    // parabola to either side.
    let reach = TAP_REACH * along;
    let sky = (0.5 + 0.5 * reflected.y / reach).clamp(0.0, 1.0);
    let sky_elevation = if sky < 1.0 { reach * sky * sky } else { reflected.y };
    let horizontal = level(reflected);
    let deviation = facets.sea.between(horizontal, horizontal).max(0.0).sqrt();
    let open = shown_share(reflected.y, deviation, facets.seen_share);
    let escaping = sky * sky * (3.0 - 2.0 * sky) * open;

    let descent = (-reflected.y).max(0.0);
    let second_cos = visible_cosine(descent, sea_variance);
    let again = (1.0 - escaping) * fresnel_exact(second_cos, n);
    let second_elevation = 2.0 * second_cos - descent;

    let reached = escaping + again;
    let share = again / reached;
    let elevation = ((open * sky_elevation + again * second_elevation) / reached).clamp(0.0, 1.0);
    let length = ((1.0 - elevation * elevation) / horizontal.length_squared().max(1e-12)).sqrt();
    // Rayleigh's distribution, which is that of slopes seen along the surface, has the variance 2 − π/2.
    let spread = along * along * (1.0 - share) + share * 4.0 * 0.4292 * sea_variance;
    ReflectionTap {
        toward: DVec3::new(horizontal.x * length, elevation, horizontal.y * length),
        weight: lobe.weight * reached,
        spread_along_rad: spread.sqrt(),
        spread_across_rad: across,
    }
}
