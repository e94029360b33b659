//! What a key of a scene file accepts, said once: its entry reads it, words its errors and documents it.
//!
//! A [`Kind`] says which values a key takes (a number in a range, one of some words …); an [`Entry`] adds what
//! a key that is left out means. The [`table!`] macro turns a list of keys into a settings struct, its reader
//! and its documentation, so that a key cannot be read without being documented, nor the other way round.

mod accepts;
mod colour;
mod file;
mod flag;
mod number;
mod pair;
mod point;
mod table;
mod tables;
mod text;
mod word;

pub use accepts::Accepts;
pub(crate) use colour::Colour;
pub(crate) use file::File;
pub(crate) use flag::Flag;
pub(crate) use number::{Count, PowerOfTwo, Real, Seed};
pub(crate) use pair::Pair;
pub(crate) use point::Point;
pub use table::WhenAbsent;
pub(crate) use table::{Key, table};
pub(crate) use tables::Tables;
pub(crate) use text::{Moment, Name};
pub(crate) use word::{OneOf, Word, Words, read_word, words};

use crate::error::SceneError;
use crate::reader::ValueReader;

/// Which values a key takes.
pub(crate) trait Kind {
    /// What the scene holds of it.
    type Value: Clone + serde::Serialize;

    /// The accepted values, for errors, documentation and sliders.
    fn accepts(&self) -> Accepts;

    /// Checks and converts a value of the file.
    fn read(&self, value: &ValueReader<'_>) -> Result<Self::Value, SceneError>;
}

/// A kind of value, and what a key that is left out means.
pub(crate) trait Entry {
    /// What the scene holds of it.
    type Value;

    /// As [`Kind::accepts`].
    fn accepts(&self) -> Accepts;

    /// As [`Kind::read`].
    fn read(&self, value: &ValueReader<'_>) -> Result<Self::Value, SceneError>;

    /// The value of a key that is left out; `None` if it must be there.
    fn absent(&self) -> Option<Self::Value>;

    /// [`absent`](Entry::absent), for the documentation.
    fn when_absent(&self) -> WhenAbsent;
}

/// A key that must be there.
pub(crate) struct Required<K>(K);

/// A key with a default.
pub(crate) struct Or<K: Kind>(K, K::Value);

/// A key that may be left out, and what that means.
pub(crate) struct Optional<K>(K, &'static str);

pub(crate) const fn required<K>(kind: K) -> Required<K> {
    Required(kind)
}

pub(crate) const fn or<K: Kind>(kind: K, default: K::Value) -> Or<K> {
    Or(kind, default)
}

pub(crate) const fn optional<K>(kind: K, without: &'static str) -> Optional<K> {
    Optional(kind, without)
}

impl<K: Kind> Entry for Required<K> {
    type Value = K::Value;

    fn accepts(&self) -> Accepts {
        self.0.accepts()
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<K::Value, SceneError> {
        self.0.read(value)
    }

    fn absent(&self) -> Option<K::Value> {
        None
    }

    fn when_absent(&self) -> WhenAbsent {
        WhenAbsent::Refused
    }
}

impl<K: Kind> Entry for Or<K> {
    type Value = K::Value;

    fn accepts(&self) -> Accepts {
        self.0.accepts()
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<K::Value, SceneError> {
        self.0.read(value)
    }

    fn absent(&self) -> Option<K::Value> {
        Some(self.1.clone())
    }

    fn when_absent(&self) -> WhenAbsent {
        let default = toml::Value::try_from(&self.1).expect("a default is a plain TOML value");
        WhenAbsent::Default(default.to_string())
    }
}

impl<K: Kind> Entry for Optional<K> {
    type Value = Option<K::Value>;

    fn accepts(&self) -> Accepts {
        self.0.accepts()
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<Self::Value, SceneError> {
        self.0.read(value).map(Some)
    }

    fn absent(&self) -> Option<Self::Value> {
        Some(None)
    }

    fn when_absent(&self) -> WhenAbsent {
        WhenAbsent::Means(self.1)
    }
}
