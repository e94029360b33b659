//! A sky computed from the sun, the haze and the clouds.

use super::{EXPOSURE_EV, Sky};
use crate::key::{Real, or, table};
use crate::reader::TableReader;
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<Sky> = Registered {
    word: "atmosphere",
    summary: "an atmosphere lit by the sun, with haze and clouds",
    keys: Atmosphere::keys,
    read: |table| Atmosphere::read_keys(table).map(Sky::Atmosphere),
};

table! {
    /// An atmosphere lit by the sun: the table `[sky]` with `kind = "atmosphere"`.
    pub struct Atmosphere {
        /// The bearing of the sun, clockwise from north.
        sun_azimuth_deg: f64 = or(Real { unit: "deg", min: 0.0, max: 360.0 }, 240.0);
        /// The height of the sun's centre above the horizon; below it the sky darkens into dusk.
        sun_elevation_deg: f64 = or(Real { unit: "deg", min: -10.0, max: 90.0 }, 18.0);
        /// How much haze there is, as a multiple of a clear day's.
        haze: f64 = or(Real { unit: "", min: 0.0, max: 20.0 }, 1.0);
        /// The part of the sky that clouds cover.
        cloud_cover: f64 = or(Real { unit: "", min: 0.0, max: 1.0 }, 0.3);
        /// What is added to the exposure of the picture, in stops: 1 doubles the light.
        exposure_ev: f64 = or(EXPOSURE_EV, 0.0);
    }
}

impl Default for Atmosphere {
    /// The sky of a scene without a `[sky]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}
