//! The scene as its file says it, changed key by key.
//!
//! A [`Document`] holds every key of the scene with its value. A change is tried on the text of a scene file first: what the
//! checker refuses is not taken, and its sentence is kept beside the key. So the document always holds a scene that can be
//! saved and rendered.

use std::path::{Path, PathBuf};
use std::rc::Rc;
use toml::{Table, Value};
use whitecap_scene::reference::{Accepts, KeyDoc, WhenAbsent, reference};
use whitecap_scene::{Camera, Scene, SceneError};

/// Changes that can be taken back.
const MOST_UNDONE: usize = 200;

/// Where a key is: names of tables and numbers of repeated ones, such as `sea.system[1].gamma`.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct KeyPath {
    /// The tables from the top of the file.
    pub tables: Vec<Step>,
    /// The key in the last of them.
    pub key: String,
}

impl KeyPath {
    /// Reads a path as it is displayed; `None` if it is none.
    fn parse(text: &str) -> Option<KeyPath> {
        let mut names = text.split('.').map(|name| (!name.is_empty()).then_some(name));
        let key = names.next_back()??.to_owned();
        let step = |name: Option<&str>| {
            let name = name?;
            match name.split_once('[') {
                None => Some(Step::Table(name.to_owned())),
                Some((name, index)) => {
                    Some(Step::Nth(name.to_owned(), index.strip_suffix(']')?.parse().ok()?))
                }
            }
        };
        Some(KeyPath { tables: names.map(step).collect::<Option<_>>()?, key })
    }
}

/// A table on the way to a key.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Step {
    /// `[name]`.
    Table(String),
    /// The so-many-th `[[name]]`.
    Nth(String, usize),
}

impl std::fmt::Display for KeyPath {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for step in &self.tables {
            match step {
                Step::Table(name) => write!(f, "{name}.")?,
                Step::Nth(name, index) => write!(f, "{name}[{index}].")?,
            }
        }
        f.write_str(&self.key)
    }
}

/// A scene that is being changed.
#[derive(Debug)]
pub struct Document {
    /// What the user called it.
    origin: String,
    /// Its file, unless it is one of the named scenes.
    path: Option<PathBuf>,
    scene: Scene,
    table: Table,
    /// The keys that such a scene may have: each frame shows them, and only changes of it change them.
    keys: Rc<[(KeyPath, KeyDoc)]>,
    opened: Table,
    undone: Vec<Table>,
    /// The last change that was refused, and why.
    refused: Option<(KeyPath, String)>,
}

impl Document {
    /// Opens a named scene or a file.
    ///
    /// # Errors
    ///
    /// As [`whitecap_scene::open`].
    pub fn open(name_or_path: &str) -> Result<Document, SceneError> {
        let is_named = whitecap_scene::named::find(name_or_path).is_some();
        let path = (!is_named).then(|| PathBuf::from(name_or_path));
        Ok(Document::of(whitecap_scene::open(name_or_path)?, name_or_path, path))
    }

    /// Opens a named scene; a file is none.
    ///
    /// # Errors
    ///
    /// If there is no such scene.
    pub fn named(name: &str) -> Result<Document, SceneError> {
        Ok(Document::of(whitecap_scene::open_named(name)?, name, None))
    }

    fn of(scene: Scene, origin: &str, path: Option<PathBuf>) -> Document {
        let table = table_of(&scene);
        Document {
            origin: origin.to_owned(),
            path,
            keys: keys_of(&scene, &table),
            scene,
            opened: table.clone(),
            table,
            undone: Vec::new(),
            refused: None,
        }
    }

    /// What the user called it.
    pub fn origin(&self) -> &str {
        &self.origin
    }

    /// Its file, unless it is one of the named scenes.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// The scene as it is now.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Why the last change of this key was refused.
    pub fn refusal(&self, path: &KeyPath) -> Option<&str> {
        self.refused.as_ref().filter(|(refused, _)| refused == path).map(|(_, why)| why.as_str())
    }

    /// The value of a key, if the file gives one.
    pub fn value(&self, path: &KeyPath) -> Option<&Value> {
        inside(&self.table, &path.tables)?.get(&path.key)
    }

    /// Whether a key is as it was when the scene was opened.
    pub fn is_as_opened(&self, path: &KeyPath) -> bool {
        let opened = inside(&self.opened, &path.tables).and_then(|table| table.get(&path.key));
        opened == self.value(path)
    }

    /// Every key that this scene's file may have, with its place, table by table.
    pub fn keys(&self) -> Rc<[(KeyPath, KeyDoc)]> {
        Rc::clone(&self.keys)
    }

    /// Gives a key a value, or with `None` leaves it out. The answer is whether the scene has changed.
    pub fn set(&mut self, path: &KeyPath, value: Option<Value>) -> bool {
        if self.value(path) == value.as_ref() {
            return false;
        }
        let mut table = self.table.clone();
        let word = value.as_ref().and_then(Value::as_str).map(str::to_owned);
        let Some(target) = inside_mut(&mut table, &path.tables) else { return false };
        match value {
            Some(value) => target.insert(path.key.clone(), value),
            None => target.remove(&path.key),
        };
        if let Some(word) = word {
            forget_other_kinds(target, path, &word);
        }
        if path.tables.is_empty() && path.key == TECHNIQUE {
            forget_techniques(&mut table);
        }
        match self.take(table) {
            Ok(()) => true,
            Err(error) => {
                self.refused = Some((path.clone(), error.to_string()));
                false
            }
        }
    }

    /// As it was when the scene was opened.
    pub fn reset(&mut self, path: &KeyPath) -> bool {
        let opened = inside(&self.opened, &path.tables).and_then(|table| table.get(&path.key)).cloned();
        self.set(path, opened)
    }

    /// Takes the last change back. The answer is whether there was one.
    pub fn undo(&mut self) -> bool {
        let Some(before) = self.undone.pop() else { return false };
        let Ok(scene) = self.read(&before) else { return false };
        self.keys = keys_of(&scene, &before);
        (self.scene, self.table, self.refused) = (scene, before, None);
        true
    }

    /// What differs from the scene as it was opened, by the keys' paths; without a value the key is left out.
    pub fn changes(&self) -> Vec<(String, Option<Value>)> {
        let mut changes = Vec::new();
        // Another technique has other keys, whose defaults go without saying.
        let technique = self.opened.get(TECHNIQUE) != self.table.get(TECHNIQUE);
        compare("", &self.opened, &self.table, &mut |path, value| {
            let root = path.split('.').next().unwrap_or(path);
            let is_of_technique = whitecap_scene::technique::ALL.iter().any(|one| one.word == root);
            if !(technique && is_of_technique && value.is_none()) {
                changes.push((path.to_owned(), value.cloned()));
            }
        });
        changes
    }

    /// Makes changes all at once, as [`Document::changes`] tells them.
    ///
    /// # Errors
    ///
    /// If a path leads nowhere, or the checker refuses what comes of them; then nothing has changed.
    pub fn change(&mut self, changes: &[(String, Option<Value>)]) -> Result<(), SceneError> {
        let mut table = self.table.clone();
        if changes.iter().any(|(path, _)| path == TECHNIQUE) {
            forget_techniques(&mut table);
        }
        for (path, value) in changes {
            let nowhere = || SceneError::about_file(&self.origin, format!("{path} is no key of this scene"));
            let key: KeyPath = KeyPath::parse(path).ok_or_else(nowhere)?;
            let target = inside_mut(&mut table, &key.tables).ok_or_else(nowhere)?;
            match value {
                Some(value) => target.insert(key.key, value.clone()),
                None => target.remove(&key.key),
            };
        }
        if changes.is_empty() { Ok(()) } else { self.take(table) }
    }

    fn take(&mut self, table: Table) -> Result<(), SceneError> {
        let scene = self.read(&table)?;
        // Every key that the change brings with it, by its default.
        let whole = table_of(&scene);
        if self.undone.len() == MOST_UNDONE {
            self.undone.remove(0);
        }
        self.keys = keys_of(&scene, &whole);
        self.undone.push(std::mem::replace(&mut self.table, whole));
        (self.scene, self.refused) = (scene, None);
        Ok(())
    }

    fn read(&self, table: &Table) -> Result<Scene, SceneError> {
        Scene::from_toml(&table.to_string(), &self.origin)
    }

    /// Reads the file again. Whatever was changed here is given up.
    ///
    /// # Errors
    ///
    /// If the file cannot be used; then nothing has changed.
    pub fn reload(&mut self) -> Result<(), SceneError> {
        *self = Document::open(&self.origin)?;
        Ok(())
    }

    /// The text of a scene file of what is seen, from `camera`.
    ///
    /// # Errors
    ///
    /// If a scene file cannot say it.
    pub fn text(&self, camera: Camera) -> Result<String, SceneError> {
        Scene { camera, ..self.scene.clone() }.to_toml()
    }
}

/// The key that says how the water is drawn.
const TECHNIQUE: &str = "technique";

/// Leaves out what only some technique has.
fn forget_techniques(table: &mut Table) {
    for technique in whitecap_scene::technique::ALL {
        table.remove(technique.word);
    }
}

/// Tells every key whose value differs, by its path; `None` where only `old` has it.
fn compare(within: &str, old: &Table, new: &Table, differs: &mut dyn FnMut(&str, Option<&Value>)) {
    let path = |key: &str| if within.is_empty() { key.to_owned() } else { format!("{within}.{key}") };
    for (key, value) in new {
        match (old.get(key), value) {
            (Some(Value::Table(old)), Value::Table(new)) => compare(&path(key), old, new, differs),
            (Some(Value::Array(old)), Value::Array(new))
                if old.len() == new.len() && new.iter().all(Value::is_table) =>
            {
                for (i, pair) in old.iter().zip(new).enumerate() {
                    if let (Value::Table(old), Value::Table(new)) = pair {
                        compare(&format!("{}[{i}]", path(key)), old, new, differs);
                    }
                }
            }
            (Some(old), new) if old == new => {}
            _ => differs(&path(key), Some(value)),
        }
    }
    for key in old.keys().filter(|key| !new.contains_key(*key)) {
        differs(&path(key), None);
    }
}

/// As [`Document::keys`].
fn keys_of(scene: &Scene, table: &Table) -> Rc<[(KeyPath, KeyDoc)]> {
    reference()
        .flat_map(|doc| places_of(&doc, scene, table).into_iter().map(move |path| (path, doc.clone())))
        .collect()
}

/// Where a scene's file may have a key: nowhere, or in each of the tables that are repeated.
fn places_of(doc: &KeyDoc, scene: &Scene, table: &Table) -> Vec<KeyPath> {
    let techniques: Vec<&str> = whitecap_scene::technique::ALL.iter().map(|one| one.word).collect();
    let other_technique = techniques.contains(&doc.table.as_str()) && doc.table != scene.technique.word();
    let no_light = doc.table == "picture" && !scene.technique.is_scene_linear();
    if other_technique || no_light || matches!(doc.accepts, Accepts::Tables { .. }) {
        return Vec::new();
    }
    let of_kind = |tables: &[Step]| {
        let Some((tag, word)) = doc.only_with else { return true };
        let found = inside(table, tables).and_then(|table| table.get(tag));
        found.is_some_and(|value| value.as_str() == Some(word) || word == "FILE")
    };
    let path = |tables: Vec<Step>| KeyPath { tables, key: doc.key.to_owned() };
    let Some(repeated) = doc.table.strip_suffix("[]") else {
        let tables: Vec<Step> = doc
            .table
            .split('.')
            .filter(|name| !name.is_empty())
            .map(|name| Step::Table(name.into()))
            .collect();
        return if of_kind(&tables) { vec![path(tables)] } else { Vec::new() };
    };
    let mut outer: Vec<Step> = repeated.split('.').map(|name| Step::Table(name.into())).collect();
    let Some(Step::Table(name)) = outer.pop() else { return Vec::new() };
    let count =
        inside(table, &outer).and_then(|table| table.get(&name)?.as_array().map(Vec::len)).unwrap_or(0);
    let nth = |i: usize| outer.iter().cloned().chain([Step::Nth(name.clone(), i)]).collect::<Vec<_>>();
    (0..count).map(nth).filter(|tables| of_kind(tables)).map(path).collect()
}

/// Every key of a scene. Scenes write themselves as tables.
fn table_of(scene: &Scene) -> Table {
    Table::try_from(scene).unwrap_or_default()
}

fn inside<'a>(table: &'a Table, steps: &[Step]) -> Option<&'a Table> {
    steps.iter().try_fold(table, |table, step| match step {
        Step::Table(name) => table.get(name)?.as_table(),
        Step::Nth(name, index) => table.get(name)?.as_array()?.get(*index)?.as_table(),
    })
}

/// Tables that a file may leave out are made.
fn inside_mut<'a>(table: &'a mut Table, steps: &[Step]) -> Option<&'a mut Table> {
    steps.iter().try_fold(table, |table, step| match step {
        Step::Table(name) => {
            table.entry(name.clone()).or_insert_with(|| Value::Table(Table::new())).as_table_mut()
        }
        Step::Nth(name, index) => table.get_mut(name)?.as_array_mut()?.get_mut(*index)?.as_table_mut(),
    })
}

/// Where a key says of which kind its table is, leaves out what only other kinds have.
fn forget_other_kinds(table: &mut Table, path: &KeyPath, word: &str) {
    let name = |step: &Step| match step {
        Step::Table(name) => name.clone(),
        Step::Nth(name, _) => format!("{name}[]"),
    };
    let heading = path.tables.iter().map(name).collect::<Vec<_>>().join(".");
    let of_table: Vec<KeyDoc> = reference().filter(|doc| doc.table == heading).collect();
    let is_tag = of_table.iter().any(|doc| doc.only_with.is_some_and(|(tag, _)| tag == path.key));
    if !is_tag {
        return;
    }
    let stays = |key: &str| {
        of_table
            .iter()
            .any(|doc| doc.key == key && doc.only_with.is_none_or(|(tag, of)| tag == path.key && of == word))
    };
    table.retain(|key, _| stays(key));
}

/// A value to begin with for a key that is left out.
pub fn first_value(doc: &KeyDoc) -> Option<Value> {
    if let WhenAbsent::Default(default) = &doc.when_absent {
        let table: Table = format!("value = {default}").parse().ok()?;
        return table.get("value").cloned();
    }
    let number = |min: f64, max: f64| Value::Float(if (min..=max).contains(&1.0) { 1.0 } else { min });
    Some(match &doc.accepts {
        Accepts::Real { min, max, .. } => number(*min, *max),
        Accepts::Integer { min, .. } => Value::Integer(i64::try_from(*min).ok()?),
        Accepts::Integers(integers) => Value::Integer(i64::from(*integers.first()?)),
        Accepts::Words(words) | Accepts::WordsOrTable { words, .. } => {
            Value::String((*words.first()?).into())
        }
        Accepts::Colour { min, max, .. } => Value::Array(vec![number(*min, *max); 3]),
        Accepts::Pair { min, max, .. } => Value::Array(vec![number(*min, *max); 2]),
        Accepts::Flag => Value::Boolean(true),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(tables: &[&str], key: &str) -> KeyPath {
        KeyPath { tables: tables.iter().map(|name| Step::Table((*name).into())).collect(), key: key.into() }
    }

    fn wind() -> KeyPath {
        KeyPath {
            tables: vec![Step::Table("sea".into()), Step::Nth("system".into(), 0)],
            key: "wind_speed_mps".into(),
        }
    }

    #[test]
    fn a_change_is_in_the_scene_and_can_be_taken_back() {
        let mut document = Document::open("spectral-ocean").unwrap();
        let before = document.scene().clone();
        let value = document.value(&wind()).unwrap().as_float().unwrap();
        assert!(document.set(&wind(), Some(Value::Float(value + 3.0))));
        assert_ne!(document.scene().sea, before.sea);
        assert!(!document.is_as_opened(&wind()));
        assert!(document.undo());
        assert_eq!(document.scene().sea, before.sea);
        assert!(document.is_as_opened(&wind()) && !document.undo());
    }

    #[test]
    fn what_the_checker_refuses_is_not_taken_and_is_said() {
        let mut document = Document::open("spectral-ocean").unwrap();
        let before = document.scene().clone();
        assert!(!document.set(&wind(), Some(Value::Float(1e9))));
        assert_eq!(*document.scene(), before);
        let sentence = document.refusal(&wind()).unwrap();
        assert!(sentence.contains("wind_speed_mps") && sentence.contains("accepted"), "{sentence}");
        assert!(document.set(&wind(), Some(Value::Float(9.5))));
        assert_eq!(document.refusal(&wind()), None);
    }

    #[test]
    fn every_key_of_every_named_scene_can_be_left_and_given_again() {
        for named in whitecap_scene::named::ALL {
            let mut document = Document::open(named.name).unwrap();
            let keys = document.keys();
            assert!(keys.len() > 8, "{}", named.name);
            for (path, _) in keys.iter() {
                if let Some(value) = document.value(path).cloned() {
                    assert!(!document.set(path, Some(value)), "{}: {path} is what it was", named.name);
                }
            }
        }
    }

    #[test]
    fn another_kind_brings_its_own_keys() {
        let mut document = Document::open("spectral-ocean").unwrap();
        assert!(
            document.set(&path(&[], "technique"), Some(Value::String("meshuggah".into()))) || {
                // A sea that the other technique cannot draw is said so.
                document.refusal(&path(&[], "technique")).is_some()
            }
        );
        let mut document = Document::open("meshuggah").unwrap();
        let system = KeyPath {
            tables: vec![Step::Table("sea".into()), Step::Nth("system".into(), 0)],
            key: "spectrum".into(),
        };
        assert!(
            document.set(&system, Some(Value::String("pierson-moskowitz".into()))),
            "{:?}",
            document.refused
        );
        assert!(document.keys().iter().any(|(path, _)| *path == wind()));
    }

    #[test]
    fn the_saved_text_is_the_scene() {
        let document = Document::open("spectral-ocean-storm").unwrap();
        let camera = Camera { position_m: [1.0, 9.0, 2.0], ..document.scene().camera.clone() };
        let text = document.text(camera.clone()).unwrap();
        let again = Scene::from_toml(&text, "again.toml").unwrap();
        assert_eq!(again.camera, camera);
        assert_eq!(again.technique, document.scene().technique);
    }
}
