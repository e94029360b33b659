//! The light around in the scene's own measure, for techniques that draw in linear light.

use super::exposure::Meter;
use crate::View;
use glam::Vec3;
use whitecap_scene::ToneMap;
use whitecap_waves::optics::atmosphere::{Atmosphere, Sky};

/// The sun's illuminance outside the air, klx: the solar constant of 1361 W/m² at 94 lm/W. It counts as white, the same in
/// each channel; luminance is 0.2126 R + 0.7152 G + 0.0722 B.
pub(crate) const SUN_KLX: f32 = 128.0;

/// The light that an [`Environment`](super::Environment) without display values adds to its map. The map is without the
/// sun's disc.
///
/// Under an atmosphere the units are kcd/m² and klx. A panorama keeps those of its file, which few files state: what is
/// called kcd/m² is then whatever the picture holds.
pub struct Light {
    /// The sun's disc; none after sunset, nor under a panorama without a peak that could be one.
    pub sun: Option<SunLight>,
    /// Illuminance of the sky on a level sea, with clouds and without the sun.
    pub sky_illuminance_klx: Vec3,
    /// What a radiance of 1 kcd/m² becomes in the linear light of a picture whose white is 1, before what a view makes of it: see
    /// [`exposure_of`](Self::exposure_of).
    pub exposure: f32,
    /// What that depends on of a view; none where the scene says its exposure.
    pub(crate) meter: Option<Meter>,
    /// What brings that light into a display's range.
    pub tone_map: ToneMap,
    /// The air, for what is seen through it.
    pub(crate) air: Air,
}

impl Light {
    /// What a radiance of 1 kcd/m² becomes in the linear light of a picture of this view.
    pub fn exposure_of(&self, view: &View) -> f32 {
        self.exposure * self.meter.map_or(1.0, |meter| meter.gain(view))
    }
}

/// The sun as the sea sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SunLight {
    /// Unit vector towards its centre.
    pub toward: Vec3,
    /// Illuminance at sea level on a surface that faces it.
    pub illuminance_klx: Vec3,
    /// Angular radius, radians.
    pub radius_rad: f32,
}

/// What the air between the eye and the sea is known by.
pub(crate) enum Air {
    /// All that scatters in it.
    Computed {
        /// Its tables.
        atmosphere: Box<Atmosphere>,
        /// The clear sky from sea level, to which the map adds the clouds.
        sea_level: Box<Sky>,
        /// Whether it adds any.
        has_clouds: bool,
    },
    /// How far one sees through it.
    Photographed {
        /// Meteorological visibility, metres.
        visibility_m: f32,
    },
}
