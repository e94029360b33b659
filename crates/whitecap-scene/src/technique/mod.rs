//! How the water is drawn: one technique with settings of its own, in a table named after it.

mod five_sample;
mod meshuggah;
mod ocean_water;
mod projected_grid;
mod rippling_lake;
mod spectral_ocean;
mod water_body;

pub use five_sample::{FiveSample, Variant};
pub use meshuggah::{FresnelForm, Meshuggah, WaterColor};
pub use ocean_water::{Highlights, OceanWater, Tangent, shore_damping};
pub use projected_grid::{Normals, OffsetAxes, Pairing, ProjectedGrid, RefractedColor};
pub use rippling_lake::{RipplingLake, SwapUv};
pub use spectral_ocean::{SpectralOcean, WaterType};

use crate::error::SceneError;
use crate::reader::TableReader;
use crate::registry::{Registered, Tag, TagDefault};
use crate::sea::Tiling;

/// A way to draw water, with its settings.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(untagged)]
#[non_exhaustive]
pub enum Technique {
    /// ATI's ocean of 2002.
    OceanWater(OceanWater),
    /// ATI's lake of 2002.
    RipplingLake(RipplingLake),
    /// Johanson's projected grid of 2004.
    ProjectedGrid(ProjectedGrid),
    /// Wenzel's ocean of 2002.
    Meshuggah(Meshuggah),
    /// Berglund's shader.
    FiveSample(FiveSample),
    /// whitecap's own ocean.
    SpectralOcean(SpectralOcean),
}

/// Every technique.
pub const ALL: &[Registered<Technique>] = &[
    ocean_water::REGISTERED,
    rippling_lake::REGISTERED,
    projected_grid::REGISTERED,
    meshuggah::REGISTERED,
    five_sample::REGISTERED,
    spectral_ocean::REGISTERED,
];

/// The top-level key that names the technique.
pub(crate) const TAG: Tag<Technique> = Tag {
    key: "technique",
    noun: "technique",
    doc: "How the water is drawn; the technique's settings are in the table of its name.",
    default: TagDefault::Word("spectral-ocean"),
    all: ALL,
};

impl Technique {
    /// The technique's word in scene files, which is also the name of its table.
    pub fn word(&self) -> &'static str {
        match self {
            Self::OceanWater(_) => ocean_water::REGISTERED.word,
            Self::RipplingLake(_) => rippling_lake::REGISTERED.word,
            Self::ProjectedGrid(_) => projected_grid::REGISTERED.word,
            Self::Meshuggah(_) => meshuggah::REGISTERED.word,
            Self::FiveSample(_) => five_sample::REGISTERED.word,
            Self::SpectralOcean(_) => spectral_ocean::REGISTERED.word,
        }
    }

    /// The words of the sea models that it draws, the one that it is made for first.
    pub fn sea_models(&self) -> &'static [&'static str] {
        match self {
            Self::OceanWater(_) | Self::RipplingLake(_) => &["sines"],
            Self::ProjectedGrid(_) => &["perlin"],
            Self::Meshuggah(_) | Self::SpectralOcean(_) => &["spectral"],
            Self::FiveSample(_) => &["calm"],
        }
    }

    /// How many tiles of a spectral sea it draws.
    pub fn tiling(&self) -> Tiling {
        match self {
            Self::SpectralOcean(_) => spectral_ocean::TILING,
            _ => Tiling { cascades: 1, resolution: 64, shortest_wave_m: Tiling::SHORTEST_WAVE_M, sewn: 0 },
        }
    }

    /// Whether it draws in linear light of the scene, which a tone map brings to the display, and not in display values.
    pub fn is_scene_linear(&self) -> bool {
        matches!(self, Self::SpectralOcean(_))
    }

    /// The text that it follows: who, what, where, when.
    pub fn source(&self) -> &'static str {
        match self {
            Self::OceanWater(_) => ocean_water::SOURCE,
            Self::RipplingLake(_) => rippling_lake::SOURCE,
            Self::ProjectedGrid(_) => projected_grid::SOURCE,
            Self::Meshuggah(_) => meshuggah::SOURCE,
            Self::FiveSample(_) => five_sample::SOURCE,
            Self::SpectralOcean(_) => spectral_ocean::SOURCE,
        }
    }

    /// Where every scene that it draws departs from its text, whatever the settings; one sentence each.
    pub fn differs(&self) -> &'static [&'static str] {
        match self {
            Self::OceanWater(_) => ocean_water::DIFFERS,
            Self::RipplingLake(_) => rippling_lake::DIFFERS,
            Self::ProjectedGrid(_) => projected_grid::DIFFERS,
            Self::Meshuggah(_) => meshuggah::DIFFERS,
            Self::FiveSample(_) => five_sample::DIFFERS,
            Self::SpectralOcean(_) => spectral_ocean::DIFFERS,
        }
    }

    /// Reads the technique and its table from the top of a scene, and refuses tables of other techniques.
    pub(crate) fn read(scene: &TableReader<'_>) -> Result<Self, SceneError> {
        let chosen = scene.read(TAG.key, &TAG)?;
        refuse_others(scene, chosen.word, ALL.iter().map(|technique| technique.word))?;
        (chosen.read)(&scene.table(chosen.word)?)
    }
}

/// The words of the techniques that draw seas of the model `model`.
pub fn that_draw(model: &str) -> impl Iterator<Item = &'static str> {
    let draws = move |technique: &&Registered<Technique>| {
        TableReader::defaults(technique.read).sea_models().contains(&model)
    };
    ALL.iter().filter(draws).map(|technique| technique.word)
}

/// Settings that would go unused are a mistake: the user changes them and nothing happens.
fn refuse_others(
    scene: &TableReader<'_>,
    chosen: &str,
    mut words: impl Iterator<Item = &'static str>,
) -> Result<(), SceneError> {
    match words.find(|word| *word != chosen && scene.has(word)) {
        None => Ok(()),
        Some(other) => Err(scene.error(
            Some(other),
            format!("settings of another technique: the scene says technique = \"{chosen}\""),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reader::Source;

    #[test]
    fn settings_of_another_technique_are_refused() {
        let text = "technique = \"meshuggah\"\n[ripples]\nheight_m = 1\n";
        let table = toml::de::DeTable::parse(text).unwrap();
        let source = Source { origin: "lake.toml", text };
        let scene = TableReader::root(&source, table.get_ref());
        let error = refuse_others(&scene, "meshuggah", ["meshuggah", "ripples"].into_iter()).unwrap_err();
        assert_eq!(
            error.to_string(),
            "lake.toml:2: ripples: settings of another technique: the scene says technique = \"meshuggah\""
        );
    }
}
