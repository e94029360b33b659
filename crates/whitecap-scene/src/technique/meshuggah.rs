//! Settings of Carsten Wenzel's ocean from "Meshuggah" (2002).
//!
//! The text gives the tiling and the form of the equations but no colours; those here are chosen. The optics
//! of the water default to the clearest sea.

use crate::error::SceneError;
use crate::key::{Colour, Count, OneOf, Real, optional, or, table, words};
use crate::reader::TableReader;
use crate::registry::Registered;

use super::Technique;
use super::water_body::{self, CLEAREST_EXTINCTION_PER_M, CLEAREST_SCATTERING_PER_M, PER_METRE};

/// What it follows.
pub(super) const SOURCE: &str = "Carsten Wenzel, \"Ocean scene\", in Meshuggah, 2002";

/// Where it departs from that, whatever the settings.
pub(super) const DIFFERS: &[&str] = &[
    "The mesh goes on to the horizon by an apron of rings.",
    "Waves finer than the far mesh are drawn as normals, and those finer than a pixel widen the reflection.",
    "The water's colours dim after sunset, and haze softens the horizon.",
    "Environment and bump map hold 16-bit floats instead of 8 bits.",
];

pub(super) const REGISTERED: Registered<Technique> = Registered {
    word: "meshuggah",
    summary: "Wenzel's ocean from Meshuggah (2002): a tiled FFT sea with a bump map of its own normals",
    keys: Meshuggah::keys,
    read: |table| Meshuggah::read_checked(table).map(Technique::Meshuggah),
};

words! {
    /// How reflection grows towards grazing angles.
    pub enum FresnelForm {
        /// Jensen & Goliáš's 1/(1+cos α)^8 at the vertices, split into two 8-bit parts, as the text has it.
        PerVertexSplit = "per-vertex-split",
        /// The same curve evaluated at every pixel.
        PerPixel = "per-pixel",
    }
}

words! {
    /// Where the colour of the water itself comes from.
    pub enum WaterColor {
        /// A blend of `deep_color` and `grazing_color` by the view's angle to the surface, as the text has it.
        Lerp = "lerp",
        /// Single scattering after Nishita & Nakamae, from scattering, extinction and depth.
        NishitaNakamae = "nishita-nakamae",
    }
}

table! {
    /// How the Meshuggah ocean is drawn: the table `[meshuggah]`.
    pub struct Meshuggah {
        /// How many times the sea's tile is repeated along each side of the mesh.
        tile_repeats: u32 = or(Count { min: 1, max: 16 }, 4);
        /// How many times the bump map is repeated along each side of the whole mesh.
        bump_repeats: f64 = or(Real { unit: "", min: 1.0, max: 1000.0 }, 30.0);
        /// What the reflection is multiplied by before it is limited to 4.
        exposure: f64 = or(Real { unit: "", min: 0.0, max: 4.0 }, 1.5);
        /// How reflection grows towards grazing angles.
        fresnel: FresnelForm = or(OneOf::<FresnelForm>::WORDS, FresnelForm::PerVertexSplit);
        /// Where the colour of the water itself comes from.
        water_color: WaterColor = or(OneOf::<WaterColor>::WORDS, WaterColor::Lerp);
        /// The water's colour where one looks straight down into it, for `lerp`.
        deep_color: [f64; 3] = or(COLOUR, [0.0, 0.08, 0.15]);
        /// The water's colour at grazing angles, for `lerp`.
        grazing_color: [f64; 3] = or(COLOUR, [0.0, 0.25, 0.2]);
        /// How much light the water scatters per metre, for `nishita-nakamae`.
        scattering_per_m: [f64; 3] = or(PER_METRE, CLEAREST_SCATTERING_PER_M);
        /// How much light the water scatters and absorbs per metre, for `nishita-nakamae`; not below the
        /// scattering.
        extinction_per_m: [f64; 3] = or(PER_METRE, CLEAREST_EXTINCTION_PER_M);
        /// The depth of a black sea floor, for `nishita-nakamae`.
        bottom_depth_m: Option<f64> = optional(Real { unit: "m", min: 0.1, max: 11000.0 }, "bottomless");
        /// How far one sees through the air: where 2 % of the contrast is left. It softens the horizon.
        visibility_km: f64 = or(Real { unit: "km", min: 0.1, max: 1e6 }, 25.0);
        /// The radius of the planet, which lowers what is far away.
        curvature_radius_km: f64 = or(Real { unit: "km", min: 1.0, max: 1e6 }, 6371.0);
    }
}

const COLOUR: Colour = Colour { unit: "", min: 0.0, max: 1.0 };

impl Meshuggah {
    fn read_checked(table: &TableReader<'_>) -> Result<Self, SceneError> {
        let settings = Self::read(table)?;
        water_body::check(table, settings.scattering_per_m, settings.extinction_per_m)?;
        Ok(settings)
    }
}

impl Default for Meshuggah {
    /// The settings of an empty `[meshuggah]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}
