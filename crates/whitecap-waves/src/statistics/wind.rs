//! What a wind does to the sea by the measurements of others: how white it is, and how steep.

/// The share of the sea's surface, 0..=1, that whitecaps cover under a wind of `wind_speed_mps` 10 m above it:
/// W = 3.84e-6 U^3.41 (Monahan and O'Muircheartaigh, *Optimal power-law description of oceanic whitecap coverage
/// dependence on wind speed*, J. Phys. Oceanogr. 10, 1980). 0 without wind; at most 1, though the law was found
/// below 20 m/s.
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

    #[test]
    fn slopes_of_cox_and_munk() {
        assert!((mean_square_slope(10.0) - 0.0542).abs() < 1e-12);
        let (across, along) = slope_variances(10.0);
        assert!((across - 0.0222).abs() < 1e-12 && (along - 0.0316).abs() < 1e-12);
        assert!((across + along - mean_square_slope(10.0)).abs() < 1e-3);
    }

    #[test]
    fn known_values() {
        for (wind_speed_mps, cover) in [(0.0, 0.0), (5.0, 0.00093), (10.0, 0.00987), (15.0, 0.03934)] {
            assert!((whitecap_cover(wind_speed_mps) - cover).abs() < 5e-6, "{wind_speed_mps} m/s");
        }
        assert_eq!((whitecap_cover(-3.0), whitecap_cover(100.0)), (0.0, 1.0));
    }
}
