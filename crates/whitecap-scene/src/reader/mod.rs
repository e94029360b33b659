//! Reads one TOML table at a time, and knows where in the file everything stands.

mod nearest;
mod source;
mod value;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

pub(crate) use nearest::{did_you_mean, quoted_choice, quoted_list};
pub(crate) use source::Source;
pub(crate) use value::ValueReader;

use crate::error::SceneError;
use crate::key::Entry;
use crate::registry::Tag;

/// One table of a scene file, with its path (`sea.system[0]`; empty for the whole file).
pub(crate) struct TableReader<'a> {
    source: &'a Source<'a>,
    path: String,
    /// Where the table begins; `None` for the whole file and for tables that are left out.
    start: Option<usize>,
    table: Option<&'a DeTable<'a>>,
}

impl<'a> TableReader<'a> {
    /// The whole file.
    pub(crate) fn root(source: &'a Source<'a>, table: &'a DeTable<'a>) -> Self {
        Self { source, path: String::new(), start: None, table: Some(table) }
    }

    /// A table that the file leaves out: every key takes its default.
    pub(crate) fn absent(source: &'a Source<'a>, path: impl Into<String>) -> Self {
        Self { source, path: path.into(), start: None, table: None }
    }

    /// What `read` makes of a table with nothing in it; it must not have required keys.
    pub(crate) fn defaults<T>(read: impl FnOnce(&TableReader<'_>) -> Result<T, SceneError>) -> T {
        let source = Source { origin: "defaults", text: "" };
        read(&TableReader::absent(&source, "")).expect("every key has a default")
    }

    pub(super) fn at(source: &'a Source<'a>, path: String, start: usize, table: &'a DeTable<'a>) -> Self {
        Self { source, path, start: Some(start), table: Some(table) }
    }

    /// Reads `key` as its entry describes; a key left out takes its default, or is an error if required.
    pub(crate) fn read<E: Entry>(&self, key: &'static str, entry: &E) -> Result<E::Value, SceneError> {
        match self.get(key) {
            Some(value) => entry.read(&ValueReader::new(self.source, self.path_of(key), value)),
            None => entry
                .absent()
                .ok_or_else(|| self.error(Some(key), format!("missing; required: {}", entry.accepts()))),
        }
    }

    /// Reads the table `key`, or one with nothing in it where the file leaves it out.
    pub(crate) fn table(&self, key: &str) -> Result<TableReader<'a>, SceneError> {
        match self.get(key) {
            Some(value) => ValueReader::new(self.source, self.path_of(key), value).table(),
            None => Ok(TableReader::absent(self.source, self.path_of(key))),
        }
    }

    /// Whether the file has this table or key.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }

    /// Reads the key that says which kind of table this is, refuses keys of other kinds, and hands the rest to
    /// the kind's own reader.
    pub(crate) fn tagged<T>(&self, tag: &Tag<T>) -> Result<T, SceneError> {
        let chosen = self.read(tag.key, tag)?;
        let keys = (chosen.keys)();
        let accepted = std::iter::once(tag.key).chain(keys.iter().map(|key| key.key));
        self.refuse_unknown(accepted, |found| {
            let owners = tag.owners_of(found);
            (!owners.is_empty()).then(|| {
                let owners = quoted_choice(&owners);
                format!("only with {0} = {owners}, but here {0} = \"{1}\"; ", tag.key, chosen.word)
            })
        })?;
        (chosen.read)(self)
    }

    /// Refuses every key that is not among `accepted`, the first in the file first.
    pub(crate) fn only(&self, accepted: impl IntoIterator<Item = &'static str>) -> Result<(), SceneError> {
        self.refuse_unknown(accepted, |_| None)
    }

    /// As [`only`](Self::only); `explain` may know more about a key than that it is not accepted.
    fn refuse_unknown(
        &self,
        accepted: impl IntoIterator<Item = &'static str>,
        explain: impl Fn(&str) -> Option<String>,
    ) -> Result<(), SceneError> {
        let mut accepted: Vec<_> = accepted.into_iter().collect();
        accepted.sort_unstable();
        let keys = self.table.into_iter().flat_map(|table| table.keys());
        let unknown = keys.filter(|key| !accepted.contains(&key.get_ref().as_ref()));
        let Some(unknown) = unknown.min_by_key(|key| key.span().start) else { return Ok(()) };
        let name = unknown.get_ref();
        let why = explain(name).unwrap_or_else(|| format!("unknown key; {}", did_you_mean(name, &accepted)));
        let problem = format!("{why}accepted here: {}", accepted.join(", "));
        Err(self.source.error(Some(unknown.span().start), self.path_of(name), problem))
    }

    /// An error about `key` of this table, or about the table itself.
    pub(crate) fn error(&self, key: Option<&str>, problem: impl Into<String>) -> SceneError {
        let path = key.map_or_else(|| self.path.clone(), |key| self.path_of(key));
        let value = key.and_then(|key| self.get(key));
        match value {
            Some(value) => ValueReader::new(self.source, path, value).error(problem),
            None => self.source.error(self.start, path, problem.into()),
        }
    }

    /// Gives an error about a key of the built scene the line of the file that says it, or of the nearest table
    /// around it if the file leaves the key out.
    pub(crate) fn locate(&self, mut error: SceneError) -> SceneError {
        let Some(path) = error.key() else { return error };
        let steps = path.split(['.', '[']).map(|step| step.trim_end_matches(']'));
        let mut here: Option<&Spanned<DeValue<'_>>> = None;
        let mut whole = true;
        for step in steps {
            let next = match here.map(Spanned::get_ref) {
                None => self.get(step),
                Some(DeValue::Table(table)) => table.get(step),
                Some(DeValue::Array(array)) => step.parse().ok().and_then(|index: usize| array.get(index)),
                Some(_) => None,
            };
            whole &= next.is_some();
            here = next.or(here);
        }
        let place = here.map(|value| ValueReader::new(self.source, path.to_owned(), value).error(""));
        if let Some(place) = place {
            error.0.line = place.0.line;
            error.0.found = place.0.found.filter(|_| whole);
        }
        error.0.file = Some(self.source.origin.to_owned());
        error
    }

    fn get(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.table?.get(key)
    }

    fn path_of(&self, key: &str) -> String {
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        let key = match !key.is_empty() && key.chars().all(plain) {
            true => source::shortened(key),
            false => source::shortened(&format!("{key:?}")),
        };
        if self.path.is_empty() { key } else { format!("{}.{key}", self.path) }
    }
}
