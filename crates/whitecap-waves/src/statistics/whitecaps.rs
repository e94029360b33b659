//! How much of the sea is white.

/// The share of the sea's surface, 0..=1, that whitecaps cover under a wind of `wind_speed_mps` 10 m above it:
/// W = 3.84e-6 U^3.41 (Monahan and O'Muircheartaigh, *Optimal power-law description of oceanic whitecap coverage
/// dependence on wind speed*, J. Phys. Oceanogr. 10, 1980). 0 without wind; at most 1, though the law was found
/// below 20 m/s.
pub fn whitecap_cover(wind_speed_mps: f64) -> f64 {
    (3.84e-6 * libm::pow(wind_speed_mps.max(0.0), 3.41)).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        for (wind_speed_mps, cover) in [(0.0, 0.0), (5.0, 0.00093), (10.0, 0.00987), (15.0, 0.03934)] {
            assert!((whitecap_cover(wind_speed_mps) - cover).abs() < 5e-6, "{wind_speed_mps} m/s");
        }
        assert_eq!((whitecap_cover(-3.0), whitecap_cover(100.0)), (0.0, 1.0));
    }
}
