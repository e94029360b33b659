//! What a surface turned out to be: the moments of a field and the heights they stand for.
//!
//! | symbol | meaning | unit (for a height field) |
//! | --- | --- | --- |
//! | m0 | zeroth moment of the spectrum, the variance of the surface | m² |
//! | Hs | significant wave height, 4√m0 | m |
//!
//! A linear sea is Gaussian: skewness 0, kurtosis 3.

/// The first four moments of a field, with every sample weighted alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    /// The mean, in the field's unit.
    pub mean: f64,
    /// The population variance about the mean (divided by n, not n − 1), in the unit squared.
    pub variance: f64,
    /// E[(x − mean)³] / variance^1.5; 0 for a constant field.
    pub skewness: f64,
    /// E[(x − mean)⁴] / variance², 3 for a Gaussian (not the excess); 0 for a constant field.
    pub kurtosis: f64,
}

impl Moments {
    /// The moments of `field`, summed in f64 in two passes, so that a large mean costs no accuracy.
    /// All are 0 for an empty field.
    pub fn of(field: &[f32]) -> Self {
        let n = field.len().max(1) as f64;
        let mean = field.iter().map(|&x| f64::from(x)).sum::<f64>() / n;
        let (mut second, mut third, mut fourth) = (0.0, 0.0, 0.0);
        for &x in field {
            let d = f64::from(x) - mean;
            let d2 = d * d;
            second += d2;
            third += d2 * d;
            fourth += d2 * d2;
        }
        let variance = second / n;
        let (skewness, kurtosis) = if variance > 0.0 {
            (third / n / (variance * variance.sqrt()), fourth / n / (variance * variance))
        } else {
            (0.0, 0.0)
        };
        Self { mean, variance, skewness, kurtosis }
    }
}

/// The mean of a field; see [`Moments`] to get all four at once.
pub fn mean(field: &[f32]) -> f64 {
    Moments::of(field).mean
}

/// The population variance of a field about its mean.
pub fn variance(field: &[f32]) -> f64 {
    Moments::of(field).variance
}

/// The skewness of a field: 0 for a symmetric one, above 0 where crests are higher than troughs are deep.
pub fn skewness(field: &[f32]) -> f64 {
    Moments::of(field).skewness
}

/// The kurtosis of a field: 3 for a Gaussian one.
pub fn kurtosis(field: &[f32]) -> f64 {
    Moments::of(field).kurtosis
}

/// Hs = 4√m0 in metres, for a surface variance `m0` in m² (the definition of H_m0; equal to the mean of the
/// highest third of the waves of a narrow-banded sea within 0.1 %, Longuet-Higgins 1952).
pub fn significant_height_m(m0: f64) -> f64 {
    4.0 * m0.sqrt()
}

/// The share of the sea that is white under a wind of `wind_speed_mps` (U10), 0..=1: 3.84e-6 U^3.41 (Monahan
/// and O'Muircheartaigh, *J. Phys. Oceanogr.* 10, 1980).
pub fn whitecap_cover(wind_speed_mps: f64) -> f64 {
    (3.84e-6 * libm::pow(wind_speed_mps.max(0.0), 3.41)).min(1.0)
}

/// The variance of the slope of a clean sea under a wind of `wind_speed_mps` (at 12.5 m, up to 14), across and
/// along the wind, from the glitter of the sun: 0.003 + 0.00192 U and 0.00316 U (Cox and Munk, *J. Opt. Soc.
/// Am.* 44, 1954). Both together have a fit of their own, [`mean_square_slope`].
pub fn slope_variances(wind_speed_mps: f64) -> (f64, f64) {
    (0.003 + 0.00192 * wind_speed_mps, 0.00316 * wind_speed_mps)
}

/// The variance of the slope in both directions together: 0.003 + 0.00512 U; see [`slope_variances`].
pub fn mean_square_slope(wind_speed_mps: f64) -> f64 {
    0.003 + 0.00512 * wind_speed_mps
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A whole number of periods of a sine: variance ½, no skew, kurtosis 3/2.
    #[test]
    fn a_sine() {
        let field: Vec<f32> = (0..1000).map(|i| (std::f32::consts::TAU * i as f32 / 1000.0).sin()).collect();
        let moments = Moments::of(&field);
        assert!(moments.mean.abs() < 1e-7);
        assert!((moments.variance - 0.5).abs() < 1e-6);
        assert!(moments.skewness.abs() < 1e-6);
        assert!((moments.kurtosis - 1.5).abs() < 1e-5);
        assert!((significant_height_m(moments.variance) - 8.0_f64.sqrt()).abs() < 1e-5);
    }

    /// One sample in four is 1, the rest 0: a Bernoulli variable with p = ¼, whose moments are
    /// p, p(1−p), (1−2p)/√(p(1−p)) and (1 − 3p(1−p))/(p(1−p)).
    #[test]
    fn a_skewed_field() {
        let field = [0.0, 0.0, 1.0, 0.0];
        assert!((mean(&field) - 0.25).abs() < 1e-15);
        assert!((variance(&field) - 0.1875).abs() < 1e-15);
        assert!((skewness(&field) - 0.5 / 0.1875_f64.sqrt()).abs() < 1e-12);
        assert!((kurtosis(&field) - 7.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn the_sea_whitens_with_the_wind() {
        for (wind, cover) in [(0.0, 0.0), (5.0, 0.00093), (10.0, 0.00987), (15.0, 0.03934), (60.0, 1.0)] {
            assert!((whitecap_cover(wind) - cover).abs() < 1e-5, "{wind}: {}", whitecap_cover(wind));
        }
    }

    #[test]
    fn slopes_of_cox_and_munk() {
        assert!((mean_square_slope(10.0) - 0.0542).abs() < 1e-12);
        let (across, along) = slope_variances(10.0);
        assert!((across - 0.0222).abs() < 1e-12 && (along - 0.0316).abs() < 1e-12);
        assert!((across + along - mean_square_slope(10.0)).abs() < 1e-3);
    }

    #[test]
    fn nothing_and_constants_have_no_spread() {
        assert_eq!(Moments::of(&[]), Moments { mean: 0.0, variance: 0.0, skewness: 0.0, kurtosis: 0.0 });
        assert_eq!(
            Moments::of(&[2.5; 7]),
            Moments { mean: 2.5, variance: 0.0, skewness: 0.0, kurtosis: 0.0 }
        );
    }

    proptest! {
        #[test]
        fn moments_follow_scale_and_shift(
            field in prop::collection::vec(-10.0..10.0_f32, 3..40), scale in 0.5..4.0_f32, shift in -100.0..100.0_f32,
        ) {
            let moved: Vec<f32> = field.iter().map(|x| -scale * x + shift).collect();
            let (a, b) = (Moments::of(&field), Moments::of(&moved));
            prop_assume!(a.variance > 0.1);
            let (scale, shift) = (f64::from(scale), f64::from(shift));
            prop_assert!((b.mean - (shift - scale * a.mean)).abs() < 1e-4);
            prop_assert!((b.variance / (scale * scale * a.variance) - 1.0).abs() < 1e-3);
            prop_assert!((b.skewness + a.skewness).abs() < 1e-2);
            prop_assert!((b.kurtosis / a.kurtosis - 1.0).abs() < 1e-2);
        }
    }
}
