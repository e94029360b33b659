//! Reads one value: what type it has, and what to say if it is the wrong one.

use toml::Spanned;
use toml::de::DeValue;

use super::{Source, TableReader};
use crate::error::SceneError;

/// One value of a scene file, with the full key that it stands under.
pub(crate) struct ValueReader<'a> {
    source: &'a Source<'a>,
    key: String,
    value: &'a Spanned<DeValue<'a>>,
}

impl<'a> ValueReader<'a> {
    pub(super) fn new(source: &'a Source<'a>, key: String, value: &'a Spanned<DeValue<'a>>) -> Self {
        Self { source, key, value }
    }

    /// A number, written as an integer or as a float. It may be NaN or infinite: ranges are the caller's.
    pub(crate) fn real(&self) -> Option<f64> {
        match self.value.get_ref() {
            DeValue::Float(float) => float.as_str().parse().ok(),
            DeValue::Integer(integer) => {
                i128::from_str_radix(integer.as_str(), integer.radix()).ok().map(|integer| integer as f64)
            }
            _ => None,
        }
    }

    /// An integer. One that is too large for 128 bits comes as the largest: ranges are the caller's.
    pub(crate) fn integer(&self) -> Option<i128> {
        let DeValue::Integer(integer) = self.value.get_ref() else { return None };
        Some(i128::from_str_radix(integer.as_str(), integer.radix()).unwrap_or(i128::MAX))
    }

    /// `true` or `false`.
    pub(crate) fn flag(&self) -> Option<bool> {
        self.value.get_ref().as_bool()
    }

    /// A string.
    pub(crate) fn string(&self) -> Option<&'a str> {
        self.value.get_ref().as_str()
    }

    /// The elements of an array; their keys are `key[0]`, `key[1]`, ….
    pub(crate) fn array(&self) -> Option<Vec<ValueReader<'a>>> {
        let elements = self.value.get_ref().as_array()?.iter().enumerate();
        let element = |(index, value)| Self::new(self.source, format!("{}[{index}]", self.key), value);
        Some(elements.map(element).collect())
    }

    /// A table; anything else is an error.
    pub(crate) fn table(&self) -> Result<TableReader<'a>, SceneError> {
        match self.value.get_ref() {
            DeValue::Table(table) => {
                Ok(TableReader::at(self.source, self.key.clone(), self.value.span().start, table))
            }
            _ => Err(self.wrong_type("a table")),
        }
    }

    /// "found a string, wanted …".
    pub(crate) fn wrong_type(&self, wanted: &str) -> SceneError {
        let found = match self.value.get_ref() {
            DeValue::Integer(_) => "an integer",
            DeValue::Array(_) => "an array",
            DeValue::String(_) => "a string",
            DeValue::Float(_) => "a float",
            DeValue::Boolean(_) => "a boolean",
            DeValue::Datetime(_) => "a date or time",
            DeValue::Table(_) => "a table",
        };
        self.error(format!("found {found}, wanted {wanted}"))
    }

    /// An error about this value, which it quotes as the file spells it.
    pub(crate) fn error(&self, problem: impl Into<String>) -> SceneError {
        let span = self.value.span();
        let mut error = self.source.error(Some(span.start), self.key.clone(), problem.into());
        // The span of a table, or of several, is its header, which says nothing that the key does not.
        let is_header = match self.value.get_ref() {
            DeValue::Array(array) => array.iter().next().is_some_and(|first| first.get_ref().is_table()),
            value => value.is_table(),
        };
        error.0.found = (!is_header).then(|| self.source.quote(span)).filter(|found| !found.is_empty());
        error
    }
}
