//! The computed sky over the sea, as the map of the environment is made from it.

use super::{SUN_RADIUS_RAD, toward};
use glam::Vec3;
use std::f32::consts::PI;
use whitecap_scene::sky::Atmosphere as Settings;
use whitecap_waves::optics::atmosphere::{Atmosphere, LOWEST_EYE_M, Sky};

/// The clear sky at sea level, in units of the sun's irradiance above the air.
pub(super) struct ClearSky {
    pub(super) air: Atmosphere,
    pub(super) toward_sun: Vec3,
    /// Mean radiance, weighted by the cosine of the angle to the zenith: irradiance over π.
    pub(super) mean: Vec3,
    pub(super) sky: Sky,
}

impl ClearSky {
    pub(super) fn new(settings: &Settings) -> ClearSky {
        let toward_sun = toward(settings.sun_azimuth_deg, settings.sun_elevation_deg);
        let air = Atmosphere::new(settings.haze);
        let sky = Sky::new(&air, LOWEST_EYE_M, toward_sun.as_dvec3());
        let mean = sky.irradiance().as_vec3() / PI;
        ClearSky { air, toward_sun, mean, sky }
    }

    /// Radiance without the sun's disc, above the horizon; below it, that of the horizon.
    pub(super) fn radiance(&self, direction: Vec3) -> Vec3 {
        self.sky.radiance(direction.with_y(direction.y.max(0.0)).as_dvec3()).as_vec3()
    }

    /// Radiance of the sun's disc through the air, zero once it has set.
    pub(super) fn sun_radiance(&self) -> Vec3 {
        self.sun_transmittance(0.0) / (PI * SUN_RADIUS_RAD * SUN_RADIUS_RAD)
    }

    /// What is left of the sun's light at `height_km` above the sea.
    pub(super) fn sun_transmittance(&self, height_km: f32) -> Vec3 {
        self.air.sun_transmittance(f64::from(height_km) * 1e3, self.toward_sun.y.into()).as_vec3()
    }
}
