//! How light becomes a picture.

use crate::error::SceneError;
use crate::key::{OneOf, Real, optional, or, table, words};
use crate::reader::TableReader;
use crate::technique::Technique;

words! {
    /// How scene-referred light is brought into a display's range.
    pub enum ToneMap {
        /// AgX (Sobotka 2022): bright colours lose saturation before they clip, as on film.
        Agx = "agx",
        /// The ACES reference rendering for a standard display, as fitted by Hill (2017): more contrast.
        Aces = "aces",
        /// Khronos PBR Neutral (2024): colours keep their values up to 80 % of white.
        PbrNeutral = "pbr-neutral",
        /// None: light is cut off at white.
        None = "none",
    }
}

table! {
    /// How light becomes a picture: the table `[picture]`, for techniques that draw in linear light.
    pub struct Picture {
        /// The exposure value at ISO 100: a sunlit scene has 15, one stop more halves the light.
        exposure_ev100: Option<f64> =
            optional(Real { unit: "EV", min: -10.0, max: 30.0 }, "follows from the light that falls on the sea and where the view looks");
        /// How light is brought into a display's range.
        tone_map: ToneMap = or(OneOf::WORDS, ToneMap::Agx);
    }
}

impl Picture {
    pub(crate) const TABLE: &'static str = "picture";

    /// Reads the table; a technique that works on raw display values has none.
    pub(crate) fn read_for(scene: &TableReader<'_>, technique: &Technique) -> Result<Self, SceneError> {
        if !technique.is_scene_linear() && scene.has(Self::TABLE) {
            let word = technique.word();
            return Err(scene.error(
                Some(Self::TABLE),
                format!(
                    "the technique \"{word}\" works on display values, which nothing maps; accepted: no \
                     [picture] table, sky.exposure_ev sets its exposure"
                ),
            ));
        }
        Self::read(&scene.table(Self::TABLE)?)
    }
}

impl Default for Picture {
    /// The picture of a scene without a `[picture]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}
