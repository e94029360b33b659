//! A sky that is a picture; [`crate::panorama`] reads the picture itself.

use std::path::PathBuf;

use super::{EXPOSURE_EV, Sky};
use crate::key::{File, Real, or, required, table};
use crate::panorama::{Panorama, PanoramaError};
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<Sky> = Registered {
    word: "panorama",
    summary: "an equirectangular HDR or EXR picture all around",
    keys: PanoramaSky::keys,
    read: |table| PanoramaSky::read_keys(table).map(Sky::Panorama),
};

table! {
    /// A picture of the sky: the table `[sky]` with `kind = "panorama"`.
    pub struct PanoramaSky {
        /// The picture: Radiance HDR or OpenEXR, equirectangular, twice as wide as high.
        file: PathBuf = required(File);
        /// How far the sky is turned clockwise; at 0 the middle of the picture is in the north.
        yaw_deg: f64 = or(Real { unit: "deg", min: -360.0, max: 360.0 }, 0.0);
        /// What is added to the exposure of the picture, in stops: 1 doubles the light.
        exposure_ev: f64 = or(EXPOSURE_EV, 0.0);
    }
}

impl PanoramaSky {
    /// Reads the picture.
    ///
    /// # Errors
    ///
    /// When [`Panorama::load`] cannot.
    pub fn load(&self) -> Result<Panorama, PanoramaError> {
        Panorama::load(&self.file)
    }
}
