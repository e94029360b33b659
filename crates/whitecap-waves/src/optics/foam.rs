//! What foam looks like.
//!
//! | symbol | meaning |
//! | --- | --- |
//! | a | logarithm of the amount of foam, 0 where the water is just covered |
//! | σ² | variance of a within a pixel |
//! | Φ | distribution of the standard normal |
//!
//! CPU twins of the functions of the same names in `foam.wesl`.

use glam::DVec3;
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// Reflectance of dense, fresh foam in visible light: 0.55 (Whitlock, Bartlett and Gurganus, *Geophys. Res. Lett.* 9,
/// 1982). The 0.22 of Koepke, *Appl. Opt.* 23, 1984, is that of a whole whitecap while it decays, and would count the
/// decay twice.
pub const FOAM_ALBEDO: f64 = 0.55;

/// The most of a place that foam covers: even fresh foam has holes.
const DENSEST_COVER: f64 = 0.72;

/// Width of the edge between foam and water, in ranks.
const EDGE: f64 = 0.12;

/// The share of a pixel that foam covers: 0.72 of the mean of min(1, eᵃ) over normal a with this mean and variance. With
/// z = a/σ + σ it is Φ(a/σ) + e^{a + σ²/2} Φ(−z), of which the second term is ½ e^{−a²/2σ²} erfcx(z/√2).
pub fn foam_cover(excess: f64, variance: f64) -> f64 {
    if variance < 1e-6 {
        return DENSEST_COVER * libm::exp(excess.min(0.0));
    }
    let deviation = variance.sqrt();
    let ratio = excess / deviation;
    let covered = 0.5 * libm::erfc(-ratio * FRAC_1_SQRT_2);
    let x = (ratio + deviation) * FRAC_1_SQRT_2;
    let partly = if x > 5.0 {
        // erfcx to six digits, where erfc runs out of exponent: the first terms of its continued fraction.
        0.5 * libm::exp(-0.5 * ratio * ratio)
            / (PI.sqrt() * (x + 0.5 / (x + 1.0 / (x + 1.5 / (x + 2.0 / x)))))
    } else {
        0.5 * libm::exp(excess + 0.5 * variance) * libm::erfc(x)
    };
    DENSEST_COVER * (covered + partly).clamp(0.0, 1.0)
}

/// The rank, uniform on 0..=1, of the weighted sum of two independent uniform ranks, the second of which counts half:
/// the distribution of x + y/2 is a trapezium's.
pub fn foam_rank(large: f64, small: f64) -> f64 {
    let sum = large + 0.5 * small;
    if sum < 0.5 {
        sum * sum
    } else if sum < 1.0 {
        sum - 0.25
    } else {
        1.0 - (1.5 - sum) * (1.5 - sum)
    }
}

/// How white a place is whose structure has this `rank`, where foam covers `cover`: 1 below it and 0 above, with a soft
/// edge. Uniform ranks make the mean `cover`, exactly. `contrast` is the share of the structure that is left in the
/// ranks; without any the place is as white as all of them.
pub fn foam_drawn(cover: f64, rank: f64, contrast: f64) -> f64 {
    // The mean of the ramp over ranks is its middle but for the ends, where a part of it is cut off.
    let end = 0.5 * EDGE;
    let middle = if cover < end {
        (2.0 * EDGE * cover).sqrt() - end
    } else if cover > 1.0 - end {
        1.0 + end - (2.0 * EDGE * (1.0 - cover)).sqrt()
    } else {
        cover
    };
    let white = ((middle - rank) / EDGE + 0.5).clamp(0.0, 1.0);
    cover + (white - cover) * contrast
}

/// Light that a full cover of foam sends into every direction: a diffuse scatterer under a sun that shines `sun` on a
/// plane square to it and a sky that shines `sky` on the level, [`FOAM_ALBEDO`] (E_sun max(n·l, 0) + E_sky)/π.
pub fn foam_radiance(normal: DVec3, toward_sun: DVec3, sun: DVec3, sky: DVec3) -> DVec3 {
    FOAM_ALBEDO / PI * (sun * normal.dot(toward_sun).max(0.0) + sky)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By summing up the normal density.
    #[test]
    fn cover_is_the_mean_over_a_normal_pixel() {
        for (excess, variance) in
            [(-3.0, 0.5), (-8.0, 9.0), (-12.0, 20.0), (0.0, 1.0), (2.0, 4.0), (-1.0, 1e-7), (-20.0, 60.0)]
        {
            let deviation = f64::sqrt(variance);
            let steps = 40_000;
            let mut sum = 0.0;
            for i in 0..steps {
                let z = -10.0 + 20.0 * (f64::from(i) + 0.5) / f64::from(steps);
                sum += (excess + deviation * z).min(0.0).exp() * (-0.5 * z * z).exp();
            }
            let mean = DENSEST_COVER * sum * 20.0 / f64::from(steps) / (2.0 * PI).sqrt();
            let found = foam_cover(excess, variance);
            assert!((found - mean).abs() < 1e-5 * mean + 1e-9, "{excess} {variance}: {found} {mean}");
        }
        assert_eq!(foam_cover(3.0, 0.0), DENSEST_COVER);
    }

    #[test]
    fn ranks_of_two_scales_are_uniform() {
        const N: usize = 400;
        let mut below = [0_usize; 9];
        for i in 0..N * N {
            let at = |i: usize| (i as f64 + 0.5) / N as f64;
            let rank = foam_rank(at(i % N), at(i / N));
            below.iter_mut().enumerate().for_each(|(j, n)| *n += usize::from(rank < (j + 1) as f64 / 10.0));
        }
        for (j, below) in below.into_iter().enumerate() {
            let share = below as f64 / (N * N) as f64;
            assert!((share - (j + 1) as f64 / 10.0).abs() < 2e-3, "{j}: {share}");
        }
    }

    /// For every cover, and for every contrast that is left.
    #[test]
    fn structure_keeps_the_mean() {
        for i in 0..=200 {
            let cover = f64::from(i) / 200.0;
            for contrast in [0.0, 0.4, 1.0] {
                let drawn = |j: i32| foam_drawn(cover, (f64::from(j) + 0.5) / 1e4, contrast);
                let mean = (0..10_000).map(drawn).sum::<f64>() / 1e4;
                assert!((mean - cover).abs() < 1e-6, "{cover} {contrast}: {mean}");
            }
        }
        assert_eq!((foam_drawn(0.3, 0.1, 1.0), foam_drawn(0.3, 0.5, 1.0)), (1.0, 0.0));
    }

    /// A white plane under a sky alone is as bright as the sky; foam has its albedo of that.
    #[test]
    fn foam_under_an_even_sky_has_its_albedo() {
        let sky = DVec3::splat(PI);
        let lit = foam_radiance(DVec3::Y, DVec3::Y, DVec3::ZERO, sky);
        assert!((lit - DVec3::splat(FOAM_ALBEDO)).length() < 1e-12);
        let low_sun = DVec3::new(0.6, -0.8, 0.0);
        assert_eq!(foam_radiance(DVec3::Y, low_sun, DVec3::ONE, sky), lit);
    }
}
