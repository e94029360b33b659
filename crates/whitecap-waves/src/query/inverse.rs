//! Which water is over a place: the inverse of the horizontal displacement.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | **x** | where water rests | m |
//! | **X** | the place, **x** + D(**x**) | m |
//! | E | ½\|**x** − **X**\|² + φ(**x**), D = ∇φ | m² |
//! | **e** | ∇E = **x** + D(**x**) − **X**, the miss | m |
//! | H | ∂²E/∂**x**² = 1 + ∂D/∂**x**, whose determinant is the Jacobian | |
//!
//! Linear waves displace by a gradient. So the water over a place rests where E is stationary: at a minimum both
//! eigenvalues of H are positive and the surface is upright, at a saddle or a maximum it is turned over. φ is bounded
//! and E grows without end, so there is a minimum for every place. Where the surface does not fold, it is all there
//! is; where it does, minima are the upright sheets.
//!
//! Newton's method finds nearly all. Where it leads to no upright sheet, E is descended (Nocedal and Wright 2006,
//! "Numerical Optimization", sections 3.1 and 3.4): along Newton's direction for |H|, H with its eigenvalues made
//! positive, as far as E falls. E itself is not needed, only its slope along the way.

use crate::model::spectral::sample::Sums;
use glam::{DMat2, DVec2};

/// Newton's method needs four steps on most places and has lost its way after so many.
const MOST_NEWTON_STEPS: usize = 12;

/// The step within which a surface is a plane: its curvature is below 100 per metre where waves of a centimetre break, and
/// where those of a decimetre do, below 10, so that its normal turns by a thirtieth of a degree at most.
const NEAR_M: f64 = 5e-5;

/// The Jacobian below which the surface is all but folded.
const STEEPEST: f64 = 0.2;

/// Descents, and probes along each, that are enough next to a fold; elsewhere a few are.
const MOST_DESCENTS: usize = 60;
const MOST_PROBES: usize = 40;

/// A miss that is none, for where the surface stands upright and no step is short: ten times what single precision
/// leaves of a displacement of tens of metres.
const ARRIVED_M: f64 = 1e-5;

/// Eigenvalues of H are taken for this at least, so that a flat E is not left in one leap.
const FLATTEST: f64 = 0.01;

/// The push that leaves a saddle, where E does not say which way it falls.
const PUSH_M: f64 = 0.01;

/// The rest point of upright water over `place_m`, and what `shape` says of it.
pub(super) fn rest_under(place_m: DVec2, shape: impl Fn(DVec2) -> Sums) -> (DVec2, Sums) {
    let mut rest_m = place_m;
    for _ in 0..MOST_NEWTON_STEPS {
        let sums = shape(rest_m);
        let hessian = hessian(&sums);
        if hessian.determinant() <= STEEPEST || hessian.x_axis.x <= 0.0 {
            break;
        }
        let step = hessian.inverse() * (rest_m + sums.shift - place_m);
        if step.length_squared() < NEAR_M * NEAR_M {
            return moved(rest_m, sums, step);
        }
        rest_m -= step;
    }
    descend(place_m, shape)
}

/// H.
fn hessian(sums: &Sums) -> DMat2 {
    let [xx, xz, zz] = sums.gradient;
    DMat2::IDENTITY + DMat2::from_cols(DVec2::new(xx, xz), DVec2::new(xz, zz))
}

/// The surface a last step back from where `sums` were taken, so short that it is a plane.
fn moved(rest_m: DVec2, mut sums: Sums, step: DVec2) -> (DVec2, Sums) {
    let [xx, xz, zz] = sums.gradient;
    sums.height -= sums.slope.dot(step);
    sums.shift -= DVec2::new(xx * step.x + xz * step.y, xz * step.x + zz * step.y);
    (rest_m - step, sums)
}

/// The minimum of E downhill from the place itself.
#[cold]
fn descend(place_m: DVec2, shape: impl Fn(DVec2) -> Sums) -> (DVec2, Sums) {
    let mut rest_m = place_m;
    let mut sums = shape(rest_m);
    for _ in 0..MOST_DESCENTS {
        let miss = rest_m + sums.shift - place_m;
        let (least, way) = downhill(&hessian(&sums), miss);
        if least > 0.0 {
            let step = hessian(&sums).inverse() * miss;
            if step.length_squared() < NEAR_M * NEAR_M {
                return moved(rest_m, sums, step);
            }
            if miss.length_squared() < ARRIVED_M * ARRIVED_M {
                break;
            }
        }
        let fall = miss.dot(way).abs();
        let (mut low, mut high, mut part) = (0.0, f64::INFINITY, 1.0);
        let mut there = rest_m;
        for _ in 0..MOST_PROBES {
            there = rest_m + part * way;
            sums = shape(there);
            let rise = (there + sums.shift - place_m).dot(way);
            // Half as steep is far enough: the next way is better.
            if rise.abs() <= 0.5 * fall {
                break;
            }
            if rise > 0.0 {
                high = part;
            } else {
                low = part;
            }
            part = if high.is_finite() { 0.5 * (low + high) } else { 2.0 * part };
        }
        rest_m = there;
    }
    (rest_m, sums)
}

/// The smaller eigenvalue of H, and Newton's step for |H|, along which E falls.
fn downhill(hessian: &DMat2, miss: DVec2) -> (f64, DVec2) {
    let (xx, xz, zz) = (hessian.x_axis.x, hessian.x_axis.y, hessian.y_axis.y);
    let (mean, half) = (0.5 * (xx + zz), 0.5 * (xx - zz));
    let radius = (half * half + xz * xz).sqrt();
    let (least, most) = (mean - radius, mean + radius);
    // Of the two forms of the larger one's eigenvector the one that does not cancel.
    let across = if half > 0.0 { DVec2::new(radius + half, xz) } else { DVec2::new(xz, radius - half) };
    let across = across.normalize_or(DVec2::X);
    let along = across.perp();
    let step = |axis: DVec2, value: f64| axis * (-miss.dot(axis) / value.abs().max(FLATTEST));
    let way = step(along, least) + step(across, most);
    if least <= 0.0 && way.length_squared() < NEAR_M * NEAR_M {
        return (least, along * PUSH_M.copysign(-miss.dot(along)));
    }
    (least, way)
}
