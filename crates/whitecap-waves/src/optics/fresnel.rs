//! How much of the light the surface reflects.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | c | cosine of the angle of incidence |
//! | n | refractive index of the far side relative to the near side: 1.333 from air into fresh water |
//! | t | n times the cosine of the refracted ray, √(n² − 1 + c²) |
//! | F | reflected share of unpolarised light, 0..=1 |

/// The Fresnel reflectance of unpolarised light, exactly.
///
/// `cos_incidence` is taken within 0..=1. `refractive_index` is relative, above 0: 1.333 from air into fresh
/// water, 1/1.333 from below, where F = 1 beyond the critical angle (total reflection).
///
/// Born and Wolf, *Principles of Optics*, §1.5.2: rs = (c − t)/(c + t) and rp = (n²c − t)/(n²c + t), with
/// t = n cos θt by Snell's law, F = (rs² + rp²)/2.
pub fn fresnel_exact(cos_incidence: f64, refractive_index: f64) -> f64 {
    let c = cos_incidence.clamp(0.0, 1.0);
    let n2 = refractive_index * refractive_index;
    let t2 = n2 - 1.0 + c * c;
    if t2 <= 0.0 {
        return 1.0;
    }
    let t = t2.sqrt();
    let rs = (c - t) / (c + t);
    let rp = (n2 * c - t) / (n2 * c + t);
    0.5 * (rs * rs + rp * rp)
}

/// The Fresnel reflectance from air into water as Jensen and Goliáš approximate it (*Deep-Water Animation and
/// Rendering*, 2001): 1/(1 + c)⁸, c the **cosine** of the angle between eye and normal, clamped to at least
/// 0.
///
/// Too low by 0.07 at most (near 80°), and five times too low when looking straight down: 0.0039 for 0.0204.
pub fn fresnel_jensen_golias(cos_incidence: f64) -> f64 {
    let square = (1.0 + cos_incidence.max(0.0)) * (1.0 + cos_incidence.max(0.0));
    let fourth = square * square;
    1.0 / (fourth * fourth)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cos_deg(degrees: f64) -> f64 {
        degrees.to_radians().cos()
    }

    #[test]
    fn known_values() {
        for (degrees, fresh, salt) in [
            (0.0, 0.02037, 0.02111),
            (30.0, 0.02144, 0.02220),
            (60.0, 0.05969, 0.06100),
            (80.0, 0.34792, 0.35020),
            (85.0, 0.58352, 0.58533),
        ] {
            assert!((fresnel_exact(cos_deg(degrees), 1.333) - fresh).abs() < 6e-6, "{degrees} fresh");
            assert!((fresnel_exact(cos_deg(degrees), 1.34) - salt).abs() < 6e-6, "{degrees} salt");
        }
        assert_eq!(fresnel_exact(0.0, 1.333), 1.0);
        assert_eq!(fresnel_exact(-0.3, 1.333), 1.0);
    }

    /// At Brewster's angle, tan θ = n, only the s part is left: F = ½ ((1 − n²)/(1 + n²))².
    #[test]
    fn brewster() {
        for (n, degrees) in [(1.333_f64, 53.123), (1.34, 53.267)] {
            assert!((n.atan().to_degrees() - degrees).abs() < 1e-3);
            let rs = (1.0 - n * n) / (1.0 + n * n);
            assert!((fresnel_exact(n.atan().cos(), n) - 0.5 * rs * rs).abs() < 1e-12);
        }
    }

    #[test]
    fn total_reflection_from_below() {
        for (n, critical_deg) in [(1.333_f64, 48.607), (1.34, 48.268)] {
            assert!(fresnel_exact(cos_deg(critical_deg - 0.01), 1.0 / n) < 1.0);
            assert_eq!(fresnel_exact(cos_deg(critical_deg + 0.01), 1.0 / n), 1.0);
        }
    }

    #[test]
    fn jensen_golias_values() {
        for (cos, value) in
            [(1.0, 0.003906), (0.5, 0.03902), (cos_deg(80.0), 0.27778), (0.0, 1.0), (-1.0, 1.0)]
        {
            assert!((fresnel_jensen_golias(cos) - value).abs() < 5e-6, "{cos}");
        }
        // The mean over a diffuse sky, 2∫F c dc, has a closed form.
        let steps = 20_000;
        let mean = (0..steps)
            .map(|i| (f64::from(i) + 0.5) / f64::from(steps))
            .map(|c| 2.0 * c * fresnel_jensen_golias(c) / f64::from(steps))
            .sum::<f64>();
        assert!((mean - 0.044643).abs() < 1e-6);
    }

    #[test]
    fn jensen_golias_is_as_close_as_it_says() {
        let gap = |c: f64| fresnel_exact(c, 1.333) - fresnel_jensen_golias(c);
        let worst = (0..=1000).map(|i| gap(f64::from(i) / 1000.0).abs()).fold(0.0, f64::max);
        assert!((0.065..0.075).contains(&worst), "{worst}");
    }

    proptest! {
        /// Energy is conserved: R from the function, T from the transmission coefficients of Born and Wolf,
        /// T = n cosθt/cosθi · ½(ts² + tp²), which share no term with it.
        #[test]
        fn reflected_and_transmitted_light_add_up(cos in 0.01..=1.0_f64, n in 0.7..2.0_f64) {
            let sin_t = (1.0 - cos * cos).sqrt() / n;
            prop_assume!(sin_t < 0.999);
            let cos_t = (1.0 - sin_t * sin_t).sqrt();
            let (ts, tp) = (2.0 * cos / (cos + n * cos_t), 2.0 * cos / (n * cos + cos_t));
            let transmitted = n * cos_t / cos * 0.5 * (ts * ts + tp * tp);
            prop_assert!((fresnel_exact(cos, n) + transmitted - 1.0).abs() < 1e-12);
        }

        /// Stokes' reversibility: the way back reflects as much.
        #[test]
        fn both_ways_are_alike(cos in 0.01..=1.0_f64, n in 1.0..2.0_f64) {
            let cos_t = (1.0 - (1.0 - cos * cos) / (n * n)).sqrt();
            prop_assert!((fresnel_exact(cos, n) - fresnel_exact(cos_t, 1.0 / n)).abs() < 1e-12);
        }
    }
}
