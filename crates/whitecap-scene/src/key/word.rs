//! Words: a choice between a few.

use std::marker::PhantomData;

use super::number::wrong_type;
use super::{Accepts, Kind};
use crate::error::SceneError;
use crate::reader::{ValueReader, did_you_mean, quoted_list};

/// One word that a file may say, what it stands for and what that is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Word<T> {
    pub(crate) word: &'static str,
    pub(crate) value: T,
}

/// A type whose values are words in a scene file.
pub(crate) trait Words: Copy + serde::Serialize + 'static {
    /// Every word, in the order of menus.
    const WORDS: &'static [Word<Self>];
}

/// One of the words of `W`.
pub(crate) struct OneOf<W>(PhantomData<W>);

impl<W: Words> OneOf<W> {
    pub(crate) const WORDS: Self = Self(PhantomData);
}

impl<W: Words> Kind for OneOf<W> {
    type Value = W;

    fn accepts(&self) -> Accepts {
        Accepts::Words(W::WORDS.iter().map(|word| word.word).collect())
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<W, SceneError> {
        let words: Vec<_> = W::WORDS.iter().map(|word| word.word).collect();
        let found = read_word(value, "choice", &words)?;
        Ok(W::WORDS[found].value)
    }
}

/// The index of the word that the file says; `noun` says what the words are.
pub(crate) fn read_word(
    value: &ValueReader<'_>,
    noun: &str,
    words: &[&'static str],
) -> Result<usize, SceneError> {
    let accepts = || Accepts::Words(words.to_vec());
    let found = value.string().ok_or_else(|| wrong_type(value, &accepts()))?;
    words.iter().position(|word| *word == found).ok_or_else(|| {
        let nearest = did_you_mean(found, words);
        value.error(format!("no such {noun}; {nearest}accepted: {}", quoted_list(words)))
    })
}

/// Defines an enum whose values are words in a scene file, and serialise as such.
macro_rules! words {
    (
        $(#[$about:meta])*
        pub enum $name:ident {
            $( $(#[$doc:meta])* $variant:ident = $word:literal, )*
        }
    ) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize)]
        pub enum $name {
            $( $(#[$doc])* #[serde(rename = $word)] $variant, )*
        }

        impl $crate::key::Words for $name {
            const WORDS: &'static [$crate::key::Word<Self>] =
                &[$( $crate::key::Word { word: $word, value: Self::$variant }, )*];
        }
    };
}
pub(crate) use words;
