//! A table of a scene file: one list of keys gives the settings, their reader and their documentation.

use std::fmt;

use super::{Accepts, Entry};

/// What documents one key within its table.
#[derive(Clone, Debug)]
pub(crate) struct Key {
    pub(crate) key: &'static str,
    pub(crate) doc: String,
    pub(crate) accepts: Accepts,
    pub(crate) when_absent: WhenAbsent,
}

/// What a key that is left out means.
#[derive(Clone, Debug, PartialEq)]
pub enum WhenAbsent {
    /// The key must be there.
    Refused,
    /// This value, as TOML writes it.
    Default(String),
    /// Something that no value says.
    Means(&'static str),
}

impl fmt::Display for WhenAbsent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused => f.write_str("required"),
            Self::Default(value) => write!(f, "`{value}`"),
            Self::Means(meaning) => f.write_str(meaning),
        }
    }
}

impl Key {
    /// `doc` as rustdoc has it: lines with a leading space.
    pub(crate) fn new(key: &'static str, doc: &str, entry: &impl Entry) -> Self {
        let doc = doc.trim().to_owned();
        Self { key, doc, accepts: entry.accepts(), when_absent: entry.when_absent() }
    }
}

/// Defines a settings struct, its reader and its documentation from one list of keys.
///
/// Each line is a field: its doc comment, its name (the key in the file), its type, and the
/// [`Entry`](crate::key::Entry) that reads it.
macro_rules! table {
    (
        $(#[doc = $about:literal])*
        pub struct $name:ident {
            $( $(#[doc = $doc:literal])* $field:ident: $type:ty = $entry:expr; )*
        }
    ) => {
        $(#[doc = $about])*
        #[derive(Clone, Debug, PartialEq, serde::Serialize)]
        pub struct $name {
            $( $(#[doc = $doc])* pub $field: $type, )*
        }

        impl $name {
            /// The keys of this table, in the order of the struct.
            pub(crate) fn keys() -> Vec<$crate::key::Key> {
                vec![$( $crate::key::Key::new(stringify!($field), concat!($($doc),*), &$entry), )*]
            }

            /// Reads the keys, but leaves it to the caller to refuse others.
            pub(crate) fn read_keys(
                table: &$crate::reader::TableReader<'_>,
            ) -> Result<Self, $crate::error::SceneError> {
                let _ = table; // some tables have no keys
                Ok(Self { $( $field: table.read(stringify!($field), &$entry)?, )* })
            }

            /// Reads the table and refuses keys that are not its own.
            #[allow(dead_code, reason = "a table with a tag is checked together with its tag")]
            pub(crate) fn read(
                table: &$crate::reader::TableReader<'_>,
            ) -> Result<Self, $crate::error::SceneError> {
                table.only([$( stringify!($field) ),*])?;
                Self::read_keys(table)
            }
        }
    };
}
pub(crate) use table;
