//! Settings of the spectral ocean: a sea of several tiles under physical optics.

use whitecap_waves::optics::water_body::{JerlovType, WaterOptics};

use crate::key::{Colour, OneOf, Real, optional, or, table, words};
use crate::reader::TableReader;
use crate::registry::Registered;
use crate::sea::Tiling;

use super::Technique;
use super::water_body::{CLEAREST_SCATTERING_PER_M, PER_METRE, PURE_ABSORPTION_PER_M};

/// What it follows.
pub(super) const SOURCE: &str = "whitecap's own; it follows no single text. The sea is that of Tessendorf, Simulating Ocean Water, 2001, \
     calibrated; its far roughness is that of Bruneton, Neyret and Holzschuch, Real-time Realistic Ocean Lighting, 2010";

/// Where it departs from that, whatever the settings.
pub(super) const DIFFERS: &[&str] =
    &["Waves finer than the mesh are drawn as normals, and those finer than a pixel as roughness."];

/// Four tiles of 256² samples reach from eight wavelengths of a storm's peak down to some decimetres. On two cores
/// their transforms take a few milliseconds a tile, less than their pixels do on a software adapter.
///
/// Those that a viewer sees several of at once, from a hill or higher, do not repeat; three copies of them cost what shorter ones
/// at one's feet are not worth.
pub(super) const TILING: Tiling =
    Tiling { cascades: 4, resolution: 256, shortest_wave_m: Tiling::SHORTEST_WAVE_M, sewn: 2 };

pub(super) const REGISTERED: Registered<Technique> = Registered {
    word: "spectral-ocean",
    summary: "a calibrated sea of several tiles to the horizon, by exact Fresnel over scattering water",
    keys: SpectralOcean::keys,
    read: |table| SpectralOcean::read(table).map(Technique::SpectralOcean),
};

words! {
    /// A water type of Jerlov.
    pub enum WaterType {
        /// The clearest ocean.
        I = "jerlov-i",
        /// Clear ocean.
        Ia = "jerlov-ia",
        /// Open ocean.
        Ib = "jerlov-ib",
        /// Temperate ocean.
        Ii = "jerlov-ii",
        /// Green, fertile ocean.
        Iii = "jerlov-iii",
        /// Clear coastal water.
        C1 = "jerlov-1c",
        /// Coastal water.
        C3 = "jerlov-3c",
        /// Coastal water with much yellow substance.
        C5 = "jerlov-5c",
        /// Turbid coastal water.
        C7 = "jerlov-7c",
        /// The most turbid.
        C9 = "jerlov-9c",
    }
}

impl WaterType {
    fn jerlov(self) -> JerlovType {
        match self {
            Self::I => JerlovType::I,
            Self::Ia => JerlovType::IA,
            Self::Ib => JerlovType::IB,
            Self::Ii => JerlovType::II,
            Self::Iii => JerlovType::III,
            Self::C1 => JerlovType::C1,
            Self::C3 => JerlovType::C3,
            Self::C5 => JerlovType::C5,
            Self::C7 => JerlovType::C7,
            Self::C9 => JerlovType::C9,
        }
    }
}

table! {
    /// How the spectral ocean is drawn: the table `[spectral-ocean]`.
    pub struct SpectralOcean {
        /// What is in the water: one of the types of Jerlov (1976), from the clearest ocean to turbid coasts.
        water: WaterType = or(OneOf::WORDS, WaterType::Ib);
        /// How much light the water absorbs per metre, in place of `water`.
        absorption_per_m: Option<[f64; 3]> =
            optional(PER_METRE, "pure water beside `scattering_per_m`, otherwise that of `water`");
        /// How much light the water scatters per metre, in place of `water`.
        scattering_per_m: Option<[f64; 3]> =
            optional(PER_METRE, "pure sea water beside `absorption_per_m`, otherwise that of `water`");
        /// What a bottom at `sea.depth_m` returns of the light on it: 0.4 and more is white sand.
        bottom_albedo: [f64; 3] = or(Colour { unit: "", min: 0.0, max: 1.0 }, [0.35, 0.33, 0.27]);
        /// How far one sees through the air under a panorama: where 2 % of the contrast is left. An atmosphere has its own,
        /// by its haze.
        visibility_km: f64 = or(Real { unit: "km", min: 0.1, max: 1e6 }, 25.0);
        /// The radius of the planet, which lowers what is far away.
        curvature_radius_km: f64 = or(Real { unit: "km", min: 1.0, max: 1e6 }, 6371.0);
    }
}

impl SpectralOcean {
    /// The water's optics.
    pub fn optics(&self) -> WaterOptics {
        match (self.absorption_per_m, self.scattering_per_m) {
            (None, None) => WaterOptics::from(self.water.jerlov()),
            (absorption, scattering) => WaterOptics::from_coefficients(
                absorption.unwrap_or(PURE_ABSORPTION_PER_M),
                scattering.unwrap_or(CLEAREST_SCATTERING_PER_M),
            ),
        }
    }
}

impl Default for SpectralOcean {
    /// The settings of an empty `[spectral-ocean]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}
