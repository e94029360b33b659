//! What the shape of the sea does to the view: its roughness and its curvature.
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | c | cosine between the view and the mean normal | |
//! | σ² | variance of the slope along the view's azimuth | |
//! | R | radius of the Earth, or 7/6 of it with refraction | m |

use std::f64::consts::FRAC_PI_2;

/// The mean cosine that a rough surface shows a viewer, √(max(c, 0)² + π/2 σ²), at most 1.
///
/// `cos` is that of the angle between the view and the mean normal, `slope_variance` is σ² ≥ 0.
///
/// A flat normal is wrong at grazing angles, where one sees only the sides of waves that face the eye. To
/// first order in the slope s along the view, a facet shows the cosine c + s, and it takes up a share
/// max(c + s, 0) of the picture. For Gaussian slopes the mean over what is seen, with z = c/σ, is
///
/// E[max(c+s, 0)²] / E[max(c+s, 0)] = σ ((z² + 1) Φ(z) + z φ(z)) / (z Φ(z) + φ(z)),
///
/// Φ and φ being the normal distribution and its density. At c = 0 that is σ √(π/2) = 1.2533 σ, for c ≫ σ it
/// tends to c, and so does the square root above. In between the root is low by 0.174 σ at most (at
/// c = 0.98 σ, where that is 10 %). The derivation is ours; it leaves out that waves hide one another.
pub fn visible_cosine(cos: f64, slope_variance: f64) -> f64 {
    let c = cos.max(0.0);
    (c * c + FRAC_PI_2 * slope_variance).sqrt().min(1.0)
}

/// How far the Earth's surface falls below the viewer's horizontal plane, d²/(2R) in metres, at a distance of
/// `horizontal_distance_m` on a sphere of `radius_m`.
///
/// The first term of R − √(R² − d²): short by d²/(4R²) of itself, under 1e-6 within 10 km on the Earth.
pub fn curvature_drop_m(horizontal_distance_m: f64, radius_m: f64) -> f64 {
    horizontal_distance_m * horizontal_distance_m / (2.0 * radius_m)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// E[max(c+s,0)²]/E[max(c+s,0)] by the midpoint rule over ±10 σ, from the definition alone.
    fn mean_visible_cosine(c: f64, sigma: f64) -> f64 {
        let (mut first, mut second) = (0.0, 0.0);
        let steps = 4000;
        for i in 0..steps {
            let z = -10.0 + 20.0 * (f64::from(i) + 0.5) / f64::from(steps);
            let weight = (-0.5 * z * z).exp();
            let facet = (c + sigma * z).max(0.0);
            first += weight * facet;
            second += weight * facet * facet;
        }
        second / first
    }

    #[test]
    fn the_root_follows_the_mean_within_its_bound() {
        let sigma = 0.05;
        let mut worst = 0.0_f64;
        for i in 0..=400 {
            let c = 0.05 * sigma * f64::from(i);
            let error = (visible_cosine(c, sigma * sigma) - mean_visible_cosine(c, sigma)) / sigma;
            assert!(error < 1e-4 && error > -0.174, "c {c}: {error}");
            worst = worst.min(error);
        }
        assert!(worst < -0.172, "the bound is tight: {worst}");
    }

    #[test]
    fn its_limits() {
        assert!((visible_cosine(0.0, 0.04) - 1.2533 * 0.2).abs() < 1e-5);
        assert_eq!(visible_cosine(-0.5, 0.04), visible_cosine(0.0, 0.04));
        assert_eq!(visible_cosine(0.6, 0.0), 0.6);
        assert_eq!(visible_cosine(1.0, 0.04), 1.0);
    }

    #[test]
    fn curvature_on_the_earth() {
        for (distance, drop) in [(1e3, 0.0785), (5e3, 1.962), (1e4, 7.848)] {
            assert!((curvature_drop_m(distance, 6.371e6) - drop).abs() < 5e-4);
        }
        let (d, r) = (1e4_f64, 6.371e6_f64);
        let exact = r - (r * r - d * d).sqrt();
        assert!((curvature_drop_m(d, r) / exact - 1.0).abs() < 1e-6);
    }
}
