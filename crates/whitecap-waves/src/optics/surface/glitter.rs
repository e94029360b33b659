//! The sun in the waves.

use super::masking::shown_share;
use super::{Slopes, VisibleFacets, level};
use crate::optics::fresnel_exact;
use glam::DVec3;
use std::f64::consts::TAU;

/// H_y of the steepest facet that is taken to be there: a slope of 3.2, 72°, nine deviations of the roughest sea.
const STEEPEST: f64 = 0.3;

/// The radiance that a rough sea sends to the eye of a sun of irradiance 1 on a plane that faces it, in 1/sr.
///
/// With p the density of slopes, F p(ζ)/(4 H_y⁴ E[max(v, 0)]) times the share of the light that waves let pass
/// (Bruneton, Neyret and Holzschuch 2010, F p/(4 H_y⁴ cos θv (1 + Λv + Λl)), with c (1 + Λ) = E[max(v, 0)]).
///
/// The sun's disc has the variance r²/4 to each side, r = `sun_radius_rad`. Turning the light by δ turns H by δ/2
/// in the plane of V and L and by δ/(2 cos i) across it, i the angle of incidence. As slopes that is the covariance
/// r²/(16 H_y²) (1 + ζζᵀ + kkᵀ/(4 cos⁴ i)), k = qₕ + ζ q_y, q = V × L, which is added to the sea's own: even a
/// mirror shows a disc, as a Gaussian of the disc's variance, twice as bright in its middle. To first order in r: the steeper
/// the facet, the more its slope changes over the disc, and none is taken to be steeper than 72°.
pub fn sun_glitter(
    slopes: &Slopes,
    facets: &VisibleFacets,
    toward_eye: DVec3,
    toward_sun: DVec3,
    sun_radius_rad: f64,
    n: f64,
) -> f64 {
    let sun = level(toward_sun);
    let deviation = facets.sea.between(sun, sun).max(0.0).sqrt();
    let open = shown_share(toward_sun.y, deviation, facets.seen_share);
    let half = toward_eye + toward_sun;
    if open <= 0.0 || half.y <= 1e-3 {
        return 0.0;
    }
    let half = half.normalize();
    if half.y < STEEPEST {
        return 0.0;
    }
    let cos = toward_eye.dot(half).clamp(0.03, 1.0);
    let slope = -level(half) / half.y;
    let cross = toward_eye.cross(toward_sun);
    let k = level(cross) + slope * cross.y;
    let across = 1.0 / (4.0 * cos * cos * cos * cos);
    let disc = sun_radius_rad * sun_radius_rad / (16.0 * half.y * half.y);
    let xx = slopes.covariance.xx + disc * (1.0 + slope.x * slope.x + across * k.x * k.x);
    let xz = slopes.covariance.xz + disc * (slope.x * slope.y + across * k.x * k.y);
    let zz = slopes.covariance.zz + disc * (1.0 + slope.y * slope.y + across * k.y * k.y);
    let determinant = (xx * zz - xz * xz).max(1e-14);
    let d = slope - facets.mean_slope;
    let squares = (zz * d.x * d.x - 2.0 * xz * d.x * d.y + xx * d.y * d.y) / determinant;
    let density = libm::exp(-0.5 * squares.max(0.0)) / (TAU * determinant.sqrt());
    let fourth = half.y * half.y * half.y * half.y;
    fresnel_exact(cos, n) * density * open / (4.0 * fourth * facets.projection)
}
