//! The facets that an eye sees.

use super::masking::hidden_projection;
use super::{SlopeCovariance, Slopes, level};
use crate::optics::fresnel_exact;
use glam::{DVec2, DVec3};

/// What an eye sees of a rough sea.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VisibleFacets {
    /// Fresnel reflectance, averaged over what is seen.
    pub mean_fresnel: f64,
    /// Unit normal of the mean slope that is seen.
    pub normal: DVec3,
    /// Mean slope of the sea, turned to the eye's edge where it faces away: averaged over a fold it can.
    pub mean_slope: DVec2,
    /// E[max(v, 0)]: what the facets of a unit of level area show the eye.
    pub projection: f64,
    /// Slopes of the whole sea, whose waves stand before one another.
    pub sea: SlopeCovariance,
    /// Smith's G₁ of that sea: the share of the facets turned to the eye that no wave hides.
    pub seen_share: f64,
    /// Unit level vector towards the eye.
    pub toward: DVec2,
    /// Slopes towards the eye of three facets that stand for what reflects.
    pub reflecting_slopes: [f64; 3],
    /// Their shares of `mean_fresnel`.
    pub reflecting_weights: [f64; 3],
    /// Slope across the view where that towards the eye is 0.
    pub across_slope: f64,
    /// Its change per slope towards the eye.
    pub across_per_slope: f64,
    /// Its variance where that is given.
    pub across_variance: f64,
}

/// Slopes at which the mean over visible facets is taken, in deviations from the mean, and their weights.
///
/// What is seen of the slope t is weighted with (z + t) φ(t), t > −z. These are the three nodes of Gauss's
/// quadrature for that weight, as rational fits over z ≥ 0: right to 0.0065 in place and 0.001 in weight. Far
/// from grazing they tend to −√3, 0, √3 with 1/6, 2/3, 1/6.
fn visible_nodes(z: f64) -> [(f64, f64); 3] {
    let fit = |p: [f64; 3], q: [f64; 3]| {
        (p[0] + z * (p[1] + z * p[2])) / (1.0 + z * (q[0] + z * (q[1] + z * q[2])))
    };
    let low = -1.732_05 + fit([2.2733, -0.2164, 0.1104], [0.3065, 0.0256, 0.0963]);
    let middle = fit([1.54, -0.1377, 0.1106], [0.3405, 0.0597, 0.1022]);
    let high = 1.732_05 + fit([1.1364, -0.1442, 0.0822], [0.2935, 0.068, 0.0751]);
    let low_weight = 1.0 / 6.0 + fit([0.2135, -0.0376, 0.0018], [0.214, -0.0362, 0.0971]);
    let high_weight = 1.0 / 6.0 + fit([-0.094, 0.0166, -0.0009], [0.0942, 0.0007, 0.0556]);
    [(low, low_weight), (middle, 1.0 - low_weight - high_weight), (high, high_weight)]
}

/// The facets of a piece of `sea` seen from `toward_eye`, a unit vector; `n` is the water's refractive index.
///
/// `slopes` are the piece's own: a pixel that resolves waves sees a part of the sea's covariance as its mean. What waves
/// hide from the eye, and later from the light, is by the whole sea's slopes all the same: the wave that is in the way lies
/// somewhere else. That is why near and far water are as bright.
///
/// A facet is seen in proportion to max(v, 0) (Heitz 2014, equation 15 over slopes); the mean Fresnel
/// reflectance is right to 0.003 against that integral at any angle and any deviation up to 0.35.
pub fn visible_facets(slopes: &Slopes, sea: SlopeCovariance, toward_eye: DVec3, n: f64) -> VisibleFacets {
    let horizontal = level(toward_eye);
    let sine = horizontal.length();
    let toward = if sine > 1e-6 { horizontal / sine } else { DVec2::X };
    let side = DVec2::new(-toward.y, toward.x);
    let covariance = slopes.covariance;
    let variance = covariance.between(toward, toward).max(1e-12);
    let deviation = variance.sqrt();
    let across_per_slope = covariance.between(toward, side) / variance;
    let across_variance =
        (covariance.between(side, side) - across_per_slope * across_per_slope * variance).max(0.0);

    // Slopes towards the eye and across it are those of −ζ.
    let shown = toward_eye.y - horizontal.dot(slopes.mean);
    let turned = (-shown).max(0.0) / sine.max(1e-3);
    let mean_slope = slopes.mean - turned * toward;
    let slope = -mean_slope.dot(toward);
    let across_slope = -mean_slope.dot(side) - across_per_slope * slope;

    let shown = shown.max(0.0);
    let tau = (sine * deviation).max(1e-6);
    let z = shown / tau;
    let projection = (shown + tau * hidden_projection(z)).max(1e-5);

    let level_shown = toward_eye.y.max(0.0);
    let sea_tau = sea.between(horizontal, horizontal).max(0.0).sqrt().max(1e-6);
    let sea_projection = level_shown + sea_tau * hidden_projection(level_shown / sea_tau);

    let mut mean = 0.0;
    let (mut reflecting_slopes, mut reflecting_weights) = ([0.0; 3], [0.0; 3]);
    // Beyond this the nodes move no more, and the cube of z stays finite in f32.
    for (node, (t, weight)) in visible_nodes(z.min(1e4)).into_iter().enumerate() {
        let a = slope + deviation * t;
        let b = across_slope + across_per_slope * a;
        let stretch = (1.0 + a * a + b * b + across_variance).sqrt();
        mean += weight * t;
        reflecting_slopes[node] = a;
        reflecting_weights[node] = weight * fresnel_exact((shown + sine * deviation * t) / stretch, n);
    }
    let mean_fresnel: f64 = reflecting_weights.iter().sum();
    let seen = slope + deviation * mean;
    let seen_slope = seen * toward + (across_slope + across_per_slope * seen) * side;
    VisibleFacets {
        mean_fresnel,
        normal: DVec3::new(seen_slope.x, 1.0, seen_slope.y).normalize(),
        mean_slope,
        projection,
        sea,
        seen_share: level_shown / sea_projection,
        toward,
        reflecting_slopes,
        reflecting_weights: reflecting_weights.map(|weight| weight / mean_fresnel),
        across_slope,
        across_per_slope,
        across_variance,
    }
}
