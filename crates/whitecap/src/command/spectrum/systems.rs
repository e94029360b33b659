//! What the scene says about its wave systems, read from the scene as it is written.

use serde_json::Value;
use whitecap_scene::sea::system::Requested;
use whitecap_scene::sea::{self, Sea, SeaModel};

/// The tables `[[sea.system]]`, with the keys that any spectrum may have.
#[derive(serde::Serialize)]
#[serde(transparent)]
pub(super) struct Systems(Vec<System>);

#[derive(serde::Serialize)]
struct System {
    spectrum: Option<String>,
    measured: Option<String>,
    #[serde(flatten)]
    requested: Requested,
}

impl Systems {
    pub(super) fn of(sea: &Sea) -> Self {
        let SeaModel::Spectral(settings) = &sea.model else { return Self(Vec::new()) };
        let system = |system: &sea::system::System| {
            // A system serialises as its table, so a new kind of spectrum shows without a line here.
            let table = serde_json::to_value(system).unwrap_or_default();
            let word = |key: &str| table.get(key).and_then(Value::as_str).map(str::to_owned);
            System { spectrum: word("spectrum"), measured: word("measured"), requested: system.requested() }
        };
        Self(settings.system.iter().map(system).collect())
    }

    /// Of all systems together, whose variances add; `None` if one does not say its own.
    pub(super) fn significant_height_m(&self) -> Option<f64> {
        let squares: Option<Vec<f64>> = self
            .0
            .iter()
            .map(|system| system.requested.significant_height_m.map(|height_m| height_m * height_m))
            .collect();
        squares.filter(|squares| !squares.is_empty()).map(|squares| squares.iter().sum::<f64>().sqrt())
    }

    /// Several systems have no one period.
    pub(super) fn peak_period_s(&self) -> Option<f64> {
        self.alone().and_then(|system| system.requested.peak_period_s)
    }

    /// Where the one system comes from.
    pub(super) fn bearing_deg(&self) -> Option<f64> {
        self.alone().and_then(|system| system.requested.from_deg).map(|from_deg| from_deg % 360.0)
    }

    fn alone(&self) -> Option<&System> {
        self.0.first().filter(|_| self.0.len() == 1)
    }
}
