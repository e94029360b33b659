//! How a wave system says how high and how long its waves are: in exactly one way.
//!
//! | way | what it gives |
//! | --- | --- |
//! | `wind_speed_mps`, and `fetch_km` where the spectrum knows one | a wind |
//! | `beaufort`, and `fetch_km` likewise | a wind |
//! | `significant_height_m`, and `peak_period_s` where the spectrum has one to choose | a height |
//! | `sea_state` | a height |
//!
//! A height without a period has that of the fully developed sea of this height.

use whitecap_waves::ParameterError;
use whitecap_waves::spectrum::pierson_moskowitz::fully_developed_period_s;
use whitecap_waves::spectrum::sea_state;

use crate::error::SceneError;
use crate::key::{Count, Real};
use crate::reader::TableReader;

pub(super) const WIND: Real = Real { unit: "m/s", min: 0.1, max: 50.0 };
pub(super) const FETCH: Real = Real { unit: "km", min: 0.01, max: 20_000.0 };
pub(super) const HEIGHT: Real = Real { unit: "m", min: 0.01, max: 40.0 };
pub(super) const PERIOD: Real = Real { unit: "s", min: 0.5, max: 40.0 };
pub(super) const GAMMA: Real = Real { unit: "", min: 1.0, max: 10.0 };
pub(super) const BEARING: Real = Real { unit: "deg", min: 0.0, max: 360.0 };
pub(super) const SWELL: Real = Real { unit: "", min: 0.0, max: 1.0 };
pub(super) const SEA_STATE: Count = Count { min: 0, max: 9 };
pub(super) const BEAUFORT: Count = Count { min: 0, max: 12 };

/// What leaving out one of the ways means.
pub(super) const ANOTHER_WAY: &str = "said in another way";
/// What leaving out the period means.
pub(super) const PERIOD_OF_HEIGHT: &str = "that of the fully developed sea of this height";

/// The keys that say it by themselves; a system has exactly one of them.
const WAYS: [&str; 4] = ["wind_speed_mps", "significant_height_m", "sea_state", "beaufort"];

/// Those of the keys that a system has. A wind counts before a height.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Asked {
    pub(super) wind_speed_mps: Option<f64>,
    pub(super) beaufort: Option<u32>,
    pub(super) fetch_km: Option<f64>,
    pub(super) significant_height_m: Option<f64>,
    pub(super) peak_period_s: Option<f64>,
    pub(super) sea_state: Option<u32>,
}

/// What they come to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Way {
    Wind { speed_mps: f64, fetch_m: Option<f64> },
    Height { height_m: f64, period_s: f64 },
}

/// The period of a sea without waves: that of the lowest ripples.
const FLAT_PERIOD_S: f64 = 1.0;

impl Asked {
    /// The wind that it speaks of, in m/s.
    pub(super) fn wind_mps(&self) -> Result<Option<f64>, ParameterError> {
        match self.wind_speed_mps {
            Some(speed_mps) => Ok(Some(speed_mps)),
            None => self.beaufort.map(sea_state::beaufort_wind_mps).transpose(),
        }
    }

    /// The significant height that it speaks of, in metres.
    pub(super) fn height_m(&self) -> Result<Option<f64>, ParameterError> {
        match self.significant_height_m {
            Some(height_m) => Ok(Some(height_m)),
            None => self.sea_state.map(sea_state::significant_height_m).transpose(),
        }
    }

    pub(super) fn way(&self) -> Result<Way, ParameterError> {
        let height = |height_m: f64, period_s: Option<f64>| {
            let natural = if height_m > 0.0 { fully_developed_period_s(height_m) } else { FLAT_PERIOD_S };
            Ok(Way::Height { height_m, period_s: period_s.unwrap_or(natural) })
        };
        let speed_mps = match (self.wind_mps()?, self.height_m()?) {
            (Some(speed_mps), _) => speed_mps,
            (None, Some(height_m)) => return height(height_m, self.peak_period_s),
            (None, None) => 0.0,
        };
        if speed_mps == 0.0 {
            return height(0.0, None);
        }
        Ok(Way::Wind { speed_mps, fetch_m: self.fetch_km.map(|km| 1000.0 * km) })
    }
}

/// Refuses a table that says it in no way or in several. A table whose `wind_sets_lengths` may have a height
/// beside the wind: the wind then makes the waves long, the height makes them high.
pub(super) fn check(table: &TableReader<'_>, wind_sets_lengths: bool) -> Result<(), SceneError> {
    let said: Vec<_> = WAYS.into_iter().filter(|way| table.has(way)).collect();
    let both = ["wind_speed_mps", "significant_height_m"];
    let way = match said.as_slice() {
        [] => {
            let problem = "does not say how high its waves are; accepted: one of";
            return Err(table.error(None, format!("{problem} {}", WAYS.join(", "))));
        }
        [way] => way,
        said if wind_sets_lengths && said == both => &both[0],
        [first, second, ..] => {
            let problem = format!("beside {first}, which says how high the waves are; remove one of the two");
            return Err(table.error(Some(second), problem));
        }
    };
    let belongs = |key: &str, owners: &[&str]| {
        if !table.has(key) || owners.contains(way) {
            return Ok(());
        }
        let owners = owners.join(" or ");
        Err(table.error(
            Some(key),
            format!("beside {way}, but only with {owners}; remove {key}, or give {owners} instead of {way}"),
        ))
    };
    belongs("fetch_km", &["wind_speed_mps", "beaufort"])?;
    belongs("peak_period_s", &["significant_height_m"])
}
