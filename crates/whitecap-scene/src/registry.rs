//! Registries: the kinds of a thing that a scene file can ask for by a word.

use crate::error::SceneError;
use crate::key::{Accepts, Entry, Key, WhenAbsent, read_word};
use crate::reader::{TableReader, ValueReader};

/// One kind of a thing: the word that scene files say for it, and the settings that it brings.
pub struct Registered<T: 'static> {
    /// The word in the file.
    pub word: &'static str,
    /// What it is, in one sentence without a full stop.
    pub summary: &'static str,
    pub(crate) keys: fn() -> Vec<Key>,
    pub(crate) read: fn(&TableReader<'_>) -> Result<T, SceneError>,
}

/// The key that says which kind a table is, and the kinds there are.
pub(crate) struct Tag<T: 'static> {
    pub(crate) key: &'static str,
    /// What the kinds are kinds of, for "no such …".
    pub(crate) noun: &'static str,
    pub(crate) doc: &'static str,
    /// What it means to leave the key out.
    pub(crate) default: TagDefault,
    pub(crate) all: &'static [Registered<T>],
}

/// What it means to leave a tag out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TagDefault {
    /// The key must be there.
    Required,
    /// This kind.
    Word(&'static str),
    /// What another part of the file decides, in words; its reader puts a word in its place.
    Decided(&'static str),
}

impl<T> Tag<T> {
    /// The same tag where `word` is the kind that is meant without the key.
    pub(crate) fn or(&self, word: &'static str) -> Self {
        Self { default: TagDefault::Word(word), ..*self }
    }

    /// The documentation of the key itself.
    pub(crate) fn key(&self) -> Key {
        Key::new(self.key, self.doc, self)
    }

    /// The words of the kinds that have this key.
    pub(crate) fn owners_of(&self, key: &str) -> Vec<&'static str> {
        let has_it = |kind: &&Registered<T>| (kind.keys)().iter().any(|of_kind| of_kind.key == key);
        self.all.iter().filter(has_it).map(|kind| kind.word).collect()
    }

    fn words(&self) -> Vec<&'static str> {
        self.all.iter().map(|kind| kind.word).collect()
    }
}

impl<T> Entry for Tag<T> {
    type Value = &'static Registered<T>;

    fn accepts(&self) -> Accepts {
        Accepts::Words(self.words())
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<Self::Value, SceneError> {
        let index = read_word(value, self.noun, &self.words())?;
        Ok(&self.all[index])
    }

    fn absent(&self) -> Option<Self::Value> {
        let TagDefault::Word(word) = self.default else { return None };
        self.all.iter().find(|kind| kind.word == word)
    }

    fn when_absent(&self) -> WhenAbsent {
        match self.default {
            TagDefault::Word(word) => WhenAbsent::Default(format!("{word:?}")),
            TagDefault::Decided(meaning) => WhenAbsent::Means(meaning),
            TagDefault::Required => WhenAbsent::Refused,
        }
    }
}

impl<T> std::fmt::Debug for Registered<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Registered").field("word", &self.word).finish_non_exhaustive()
    }
}
