//! One column: the same numbers, wherever they come from.

use super::measure::Measured;
use super::systems::Systems;
use whitecap_waves::direction::nautical_from_toward;
use whitecap_waves::statistics::SeaStatistics;

/// A sea in numbers; `None` where there is nothing to say.
#[derive(Clone, Copy, Debug, Default, serde::Serialize)]
pub(super) struct Numbers {
    pub(super) significant_height_m: Option<f64>,
    pub(super) peak_period_s: Option<f64>,
    pub(super) zero_crossing_period_s: Option<f64>,
    pub(super) energy_period_s: Option<f64>,
    pub(super) m0_m2: Option<f64>,
    pub(super) mean_direction_from_deg: Option<f64>,
    pub(super) peak_direction_from_deg: Option<f64>,
    pub(super) directional_spread_deg: Option<f64>,
    pub(super) mean_square_slope: Option<f64>,
    pub(super) mean_square_slope_along: Option<f64>,
    pub(super) mean_square_slope_across: Option<f64>,
    pub(super) skewness: Option<f64>,
    pub(super) kurtosis: Option<f64>,
}

impl Numbers {
    pub(super) fn requested(systems: &Systems) -> Self {
        let height_m = systems.significant_height_m();
        Self {
            significant_height_m: height_m,
            peak_period_s: systems.peak_period_s(),
            m0_m2: height_m.map(|height_m| height_m * height_m / 16.0),
            mean_direction_from_deg: systems.bearing_deg(),
            ..Self::default()
        }
    }

    pub(super) fn of(sea: &SeaStatistics) -> Self {
        let slopes = sea.slope_along_and_across();
        Self {
            significant_height_m: Some(sea.significant_height_m()),
            peak_period_s: sea.peak_period_s,
            zero_crossing_period_s: sea.zero_crossing_period_s(),
            energy_period_s: sea.energy_period_s(),
            m0_m2: Some(sea.moments.m0),
            mean_direction_from_deg: sea.mean_toward().map(nautical_from_toward),
            peak_direction_from_deg: sea.peak_toward().map(nautical_from_toward),
            directional_spread_deg: sea.spread_rad().map(f64::to_degrees),
            mean_square_slope: Some(sea.slope.total()),
            mean_square_slope_along: slopes.map(|(along, _)| along),
            mean_square_slope_across: slopes.map(|(_, across)| across),
            skewness: None,
            kurtosis: None,
        }
    }

    pub(super) fn surface(measured: &Measured) -> Self {
        let (skewness, kurtosis) = measured.shape();
        Self { skewness: Some(skewness), kurtosis: Some(kurtosis), ..Self::of(measured.sea()) }
    }
}
