//! Integrals over a spectrum: smooth, with one peak, and with a tail that falls as a power.

/// The range of ln(x/peak) in which a spectrum has its energy. Below it every spectrum of this crate is less
/// than e⁻¹⁰⁰⁰ of its peak. Above it the tail ω⁻⁵ holds nothing of m0 and 1e-12 of m2; seas over wave numbers reach
/// from the peak of a storm to ripples of a millimetre.
const LOWEST: f64 = -3.5;
const HIGHEST: f64 = 14.0;

/// Panels per unit of ln x. JONSWAP's peak, 0.07 wide, spans one.
const PANELS_PER_UNIT: f64 = 16.0;

/// Nodes and weights of Gauss and Legendre's five-point rule on −1 to 1 (Abramowitz and Stegun, table 25.4).
const GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// ∫ `f`(x) dx over all x > 0 for a spectrum whose peak, the only place where it may have a kink, is at `peak`.
/// Gauss's rule in ln x, with a panel that ends at the peak; accurate to 1e-9.
pub(super) fn integral(peak: f64, f: impl Fn(f64) -> f64) -> f64 {
    let side = |from: f64, to: f64| {
        let panels = ((to - from) * PANELS_PER_UNIT).ceil();
        let half = 0.5 * (to - from) / panels;
        let panel = |i: f64| {
            let middle = from + (2.0 * i + 1.0) * half;
            let at = |(node, weight): (f64, f64)| {
                let x = peak * libm::exp(middle + half * node);
                half * weight * x * f(x)
            };
            GAUSS.into_iter().map(at).sum::<f64>()
        };
        (0..panels as u32).map(|i| panel(f64::from(i))).sum::<f64>()
    };
    side(LOWEST, 0.0) + side(0.0, HIGHEST)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ x⁻⁵ exp(−1.25 x⁻⁴) dx = 1/5, and ∫ x⁻³ exp(−1.25 x⁻⁴) dx = √(π/1.25)/4.
    #[test]
    fn the_integrals_of_pierson_and_moskowitz() {
        for peak in [0.01, 1.0, 30.0_f64] {
            let shape = |x: f64| (-1.25 * (peak / x).powi(4)).exp();
            let zeroth = integral(peak, |x| peak.powi(4) * x.powi(-5) * shape(x));
            assert!((zeroth - 0.2).abs() < 1e-10, "{zeroth}");
            let second = integral(peak, |x| peak.powi(2) * x.powi(-3) * shape(x));
            assert!((second - (std::f64::consts::PI / 1.25).sqrt() / 4.0).abs() < 1e-7, "{second}");
        }
    }
}
