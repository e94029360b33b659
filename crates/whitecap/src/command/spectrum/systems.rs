//! What the scene says about its wave systems, read from the scene as it is written.

use serde_json::Value;
use whitecap_scene::sea::{self, Sea, SeaModel};
use whitecap_waves::spectrum::sea_state;
use whitecap_waves::statistics::significant_height_m;

/// The tables `[[sea.system]]`, with the keys that any spectrum may have.
#[derive(serde::Serialize)]
#[serde(transparent)]
pub(super) struct Systems(Vec<System>);

#[derive(serde::Serialize)]
struct System {
    spectrum: Option<String>,
    measured: Option<String>,
    significant_height_m: Option<f64>,
    peak_period_s: Option<f64>,
    from_deg: Option<f64>,
    wind_speed_mps: Option<f64>,
}

impl Systems {
    pub(super) fn of(sea: &Sea) -> Self {
        let SeaModel::Spectral(settings) = &sea.model else { return Self(Vec::new()) };
        let system = |(index, system): (usize, &sea::system::System)| {
            // A system serialises as its table, so a new kind of spectrum shows without a line here.
            let table = serde_json::to_value(system).unwrap_or_default();
            let number = |key: &str| table.get(key).and_then(Value::as_f64);
            let code =
                |key: &str| table.get(key).and_then(Value::as_u64).and_then(|code| u32::try_from(code).ok());
            let of_state = || code("sea_state").and_then(|code| sea_state::significant_height_m(code).ok());
            let of_beaufort = || code("beaufort").and_then(|force| sea_state::beaufort_wind_mps(force).ok());
            System {
                spectrum: table.get("spectrum").and_then(Value::as_str).map(str::to_owned),
                measured: table.get("measured").and_then(Value::as_str).map(str::to_owned),
                significant_height_m: number("significant_height_m")
                    .or_else(of_state)
                    .or_else(|| measured_height_m(system, index)),
                peak_period_s: number("peak_period_s"),
                from_deg: number("from_deg"),
                wind_speed_mps: number("wind_speed_mps").or_else(of_beaufort),
            }
        };
        Self(settings.system.iter().enumerate().map(system).collect())
    }

    /// Of all systems together, whose variances add; `None` if one does not say its own.
    pub(super) fn significant_height_m(&self) -> Option<f64> {
        let squares: Option<Vec<f64>> = self
            .0
            .iter()
            .map(|system| system.significant_height_m.map(|height_m| height_m * height_m))
            .collect();
        squares.filter(|squares| !squares.is_empty()).map(|squares| squares.iter().sum::<f64>().sqrt())
    }

    /// Several systems have no one period.
    pub(super) fn peak_period_s(&self) -> Option<f64> {
        self.alone().and_then(|system| system.peak_period_s)
    }

    /// Where the one system comes from.
    pub(super) fn bearing_deg(&self) -> Option<f64> {
        self.alone().and_then(|system| system.from_deg).map(|from_deg| from_deg % 360.0)
    }

    /// The strongest wind that any system speaks of.
    pub(super) fn wind_speed_mps(&self) -> Option<f64> {
        self.0.iter().filter_map(|system| system.wind_speed_mps).reduce(f64::max)
    }

    fn alone(&self) -> Option<&System> {
        self.0.first().filter(|_| self.0.len() == 1)
    }
}

/// The significant height of a measured system's record, by the sum that its own format prescribes.
fn measured_height_m(system: &sea::system::System, index: usize) -> Option<f64> {
    let sea::system::System::Measured(system) = system else { return None };
    let record = system.load(&format!("sea.system[{index}]")).ok()?;
    Some(significant_height_m(record.variance_m2()))
}
