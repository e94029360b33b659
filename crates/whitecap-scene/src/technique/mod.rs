//! How the water is drawn: one technique with settings of its own, in a table named after it.

mod meshuggah;

pub use meshuggah::{FresnelForm, Meshuggah, WaterColor};

use crate::error::SceneError;
use crate::reader::TableReader;
use crate::registry::{Registered, Tag};

/// A way to draw water, with its settings.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Technique {
    /// Wenzel's ocean of 2002.
    Meshuggah(Meshuggah),
}

/// Every technique.
pub const ALL: &[Registered<Technique>] = &[meshuggah::REGISTERED];

/// The top-level key that names the technique.
pub(crate) const TAG: Tag<Technique> = Tag {
    key: "technique",
    noun: "technique",
    doc: "How the water is drawn; the technique's settings are in the table of its name.",
    default: Some("meshuggah"),
    all: ALL,
};

impl Technique {
    /// The technique's word in scene files, which is also the name of its table.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Meshuggah(_) => meshuggah::REGISTERED.word,
        }
    }

    /// Reads the technique and its table from the top of a scene, and refuses tables of other techniques.
    pub(crate) fn read(scene: &TableReader<'_>) -> Result<Self, SceneError> {
        let chosen = scene.read(TAG.key, &TAG)?;
        refuse_others(scene, chosen.word, ALL.iter().map(|technique| technique.word))?;
        (chosen.read)(&scene.table(chosen.word)?)
    }
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
