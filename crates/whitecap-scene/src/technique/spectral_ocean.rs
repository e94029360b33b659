//! Settings of the spectral ocean: a sea of several tiles under physical optics.

use crate::error::SceneError;
use crate::key::{Real, or, table};
use crate::reader::TableReader;
use crate::registry::Registered;
use crate::sea::Tiling;

use super::Technique;
use super::water_body::{self, CLEAREST_EXTINCTION_PER_M, CLEAREST_SCATTERING_PER_M, PER_METRE};

/// What it follows.
pub(super) const SOURCE: &str = "whitecap's own; it follows no single text. The sea is that of Tessendorf, Simulating Ocean Water, 2001, \
     calibrated; its far roughness is that of Bruneton, Neyret and Holzschuch, Real-time Realistic Ocean Lighting, 2010";

/// Where it departs from that, whatever the settings.
pub(super) const DIFFERS: &[&str] = &[
    "Waves finer than the mesh are drawn as normals, and those finer than a pixel as roughness.",
    "The sky is the environment map, as it is exposed for display.",
];

/// Four tiles of 256² samples reach from eight wavelengths of a storm's peak down to some decimetres. On two cores
/// their transforms take a few milliseconds a tile, less than their pixels do on a software adapter.
pub(super) const TILING: Tiling = Tiling { cascades: 4, resolution: 256 };

pub(super) const REGISTERED: Registered<Technique> = Registered {
    word: "spectral-ocean",
    summary: "a calibrated sea of several tiles to the horizon, by exact Fresnel over scattering water",
    keys: SpectralOcean::keys,
    read: |table| SpectralOcean::read_checked(table).map(Technique::SpectralOcean),
};

table! {
    /// How the spectral ocean is drawn: the table `[spectral-ocean]`.
    pub struct SpectralOcean {
        /// How much light the water scatters per metre.
        scattering_per_m: [f64; 3] = or(PER_METRE, CLEAREST_SCATTERING_PER_M);
        /// How much light the water scatters and absorbs per metre; not below the scattering.
        extinction_per_m: [f64; 3] = or(PER_METRE, CLEAREST_EXTINCTION_PER_M);
        /// How far one sees through the air: where 2 % of the contrast is left. It softens the horizon.
        visibility_km: f64 = or(Real { unit: "km", min: 0.1, max: 1e6 }, 25.0);
        /// The radius of the planet, which lowers what is far away.
        curvature_radius_km: f64 = or(Real { unit: "km", min: 1.0, max: 1e6 }, 6371.0);
    }
}

impl SpectralOcean {
    fn read_checked(table: &TableReader<'_>) -> Result<Self, SceneError> {
        let settings = Self::read(table)?;
        water_body::check(table, settings.scattering_per_m, settings.extinction_per_m)?;
        Ok(settings)
    }
}

impl Default for SpectralOcean {
    /// The settings of an empty `[spectral-ocean]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}
