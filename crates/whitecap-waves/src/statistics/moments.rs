//! The moments of a field of numbers.

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::statistics::significant_height_m;
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
