//! Every key that a scene file accepts, for documents and panels.

use crate::camera::Camera;
use crate::key::Key;
use crate::object::Object;
use crate::picture::Picture;
use crate::registry::{Registered, Tag};
use crate::scene::Scene;
use crate::{sea, sky, technique};

pub use crate::key::{Accepts, WhenAbsent};

/// One key of a scene file.
#[derive(Clone, Debug)]
pub struct KeyDoc {
    /// The table it is in: `sea.system[]` stands for every `[[sea.system]]`; empty for the top of the file.
    pub table: String,
    /// The key.
    pub key: &'static str,
    /// The key and the word that this table must have for the key to be accepted, such as `kind`, `panorama`.
    pub only_with: Option<(&'static str, &'static str)>,
    /// What it accepts, with its unit.
    pub accepts: Accepts,
    /// What it means to leave it out.
    pub when_absent: WhenAbsent,
    /// What it is, in sentences.
    pub doc: String,
}

/// The keys as tables in Markdown, one for each table of the file.
pub fn markdown() -> String {
    let mut text = String::new();
    let mut heading = String::new();
    for key in reference() {
        let of_key = key.heading();
        if of_key != heading {
            let gap = if text.is_empty() { "" } else { "\n" };
            text += &format!(
                "{gap}## {of_key}\n\n| key | accepts | left out | what it is |\n|---|---|---|---|\n"
            );
            heading = of_key;
        }
        let KeyDoc { key, accepts, when_absent, doc, .. } = key;
        text += &format!("| `{key}` | {}: {accepts} | {when_absent} | {doc} |\n", accepts.type_name());
    }
    text
}

/// Every key of a scene file, table by table.
pub fn reference() -> impl Iterator<Item = KeyDoc> {
    let mut keys = Keys(Vec::new());
    keys.add("", None, Scene::keys());
    keys.add_tagged("sea", &sea::TAG);
    keys.add_tagged("sea.system[]", &sea::system::TAG);
    keys.add("sea.system[]", Some((sea::system::MEASURED, "FILE")), sea::system::MEASURED_KEYS());
    keys.add("sea.cascade[]", None, sea::CASCADE_KEYS());
    keys.add("sea.wave[]", None, sea::WAVE_KEYS());
    for technique in technique::ALL {
        keys.add(technique.word, None, (technique.keys)());
    }
    keys.add_tagged("sky", &sky::TAG);
    keys.add("camera", None, Camera::keys());
    keys.add(Picture::TABLE, None, Picture::keys());
    keys.add("object[]", None, Object::keys());
    keys.0.into_iter()
}

/// A setting of a scene that is not what leaving it out would mean.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Difference {
    /// The key with its table, such as `sea.choppiness`.
    pub key: String,
    /// What the scene says, as TOML writes it.
    pub value: String,
    /// What leaving the key out means: a value as TOML writes it, or words.
    pub default: String,
}

/// The settings of the scene's technique and sea that differ from their defaults, which are the texts' values
/// where a text gives one. Keys that a file must give have no default to differ from.
pub fn differences(scene: &Scene) -> Vec<Difference> {
    let Ok(said) = toml::Table::try_from(scene) else { return Vec::new() };
    let model = Some((sea::TAG.key, scene.sea.model.word()));
    let technique = scene.technique.word();
    let settings = reference().filter(|key| {
        (key.table == technique && key.only_with.is_none()) || (key.table == "sea" && key.only_with == model)
    });
    let difference = |KeyDoc { table, key, when_absent, .. }: KeyDoc| {
        let value = said.get(&table)?.get(key)?.to_string();
        let default = match when_absent {
            WhenAbsent::Refused => return None,
            WhenAbsent::Default(default) => default,
            WhenAbsent::Means(meaning) => meaning.to_owned(),
        };
        (value != default).then(|| Difference { key: format!("{table}.{key}"), value, default })
    };
    settings.filter_map(difference).collect()
}

impl KeyDoc {
    /// The table as the file spells it, and the kind it must be of.
    fn heading(&self) -> String {
        let table = match self.table.strip_suffix("[]") {
            Some(repeated) => format!("`[[{repeated}]]`"),
            None if self.table.is_empty() => "The top of the file".to_owned(),
            None => format!("`[{}]`", self.table),
        };
        let kind = self.only_with.map(|(tag, word)| format!(" with `{tag} = \"{word}\"`"));
        table + &kind.unwrap_or_default()
    }
}

struct Keys(Vec<KeyDoc>);

impl Keys {
    fn add(&mut self, table: &str, only_with: Option<(&'static str, &'static str)>, keys: Vec<Key>) {
        self.0.extend(keys.into_iter().map(|Key { key, doc, accepts, when_absent }| KeyDoc {
            table: table.to_owned(),
            key,
            only_with,
            accepts,
            when_absent,
            doc,
        }));
    }

    fn add_tagged<T>(&mut self, table: &str, tag: &Tag<T>) {
        self.add(table, None, vec![tag.key()]);
        for Registered { word, keys, .. } in tag.all {
            self.add(table, Some((tag.key, word)), keys());
        }
    }
}
