//! Sums that stand for integrals.

use std::f64::consts::PI;

/// Places in 0..1 and their weights, by which a sum over `n` values of a polynomial of degree 2n − 1 is its integral: the
/// Gauss–Legendre rule, its roots by Newton's method.
pub(super) fn gauss_legendre(n: u32) -> Vec<(f64, f64)> {
    let degree = f64::from(n);
    let root = |i: u32| {
        let mut x = (PI * (f64::from(i) + 0.75) / (degree + 0.5)).cos();
        let mut slope = 1.0;
        // From Tricomi's first guess four steps would do.
        for _ in 0..8 {
            let (mut before, mut here) = (1.0, x);
            for k in 2..=n {
                let k = f64::from(k);
                (before, here) = (here, ((2.0 * k - 1.0) * x * here - (k - 1.0) * before) / k);
            }
            slope = degree * (x * here - before) / (x * x - 1.0);
            x -= here / slope;
        }
        (0.5 - 0.5 * x, 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(root).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_integrated_exactly() {
        for n in [2, 4, 12, 16] {
            let rule = gauss_legendre(n);
            for degree in 0..2 * n as i32 {
                let sum: f64 = rule.iter().map(|(x, weight)| weight * x.powi(degree)).sum();
                assert!((sum * f64::from(degree + 1) - 1.0).abs() < 1e-12, "{n} {degree}");
            }
        }
    }
}
