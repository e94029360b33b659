//! Why a scene could not be read: one sentence that names the place, the finding and what is accepted.

use std::fmt;

/// A scene that cannot be used, and why.
///
/// It prints as one line: file, line, key, what was found, and what is accepted instead. For example
/// `storm.toml:12: sea.system[0].wind_speed_mps = -3: out of range; accepted: 0.1 to 50 m/s`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneError(pub(crate) Box<Parts>);

/// What an error is put together from. Boxed, so that the results of good scenes stay small.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Parts {
    pub(crate) file: Option<String>,
    pub(crate) line: Option<usize>,
    pub(crate) column: Option<usize>,
    pub(crate) key: Option<String>,
    pub(crate) found: Option<String>,
    pub(crate) problem: String,
}

impl SceneError {
    /// The scene's file, or what stands for it; `None` if the scene was put together in memory.
    pub fn file(&self) -> Option<&str> {
        self.0.file.as_deref()
    }

    /// The line of the file, from 1, where there is one to name.
    pub fn line(&self) -> Option<usize> {
        self.0.line
    }

    /// The full key, such as `sea.system[0].wind_speed_mps`.
    pub fn key(&self) -> Option<&str> {
        self.0.key.as_deref()
    }

    /// The refused value as the file spells it, shortened if long.
    pub fn found(&self) -> Option<&str> {
        self.0.found.as_deref()
    }

    /// What is wrong and what is accepted, without the place.
    pub fn problem(&self) -> &str {
        &self.0.problem
    }

    /// An error about a whole file.
    pub fn about_file(file: impl Into<String>, problem: impl Into<String>) -> Self {
        Parts { file: Some(file.into()), problem: problem.into(), ..Parts::default() }.into()
    }

    /// An error about a key of a scene in memory.
    pub(crate) fn about_key(key: impl Into<String>, problem: impl Into<String>) -> Self {
        Parts { key: Some(key.into()), problem: problem.into(), ..Parts::default() }.into()
    }
}

impl From<Parts> for SceneError {
    fn from(parts: Parts) -> Self {
        Self(Box::new(parts))
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Parts { file, line, column, key, found, problem } = &*self.0;
        if let Some(file) = file {
            f.write_str(file)?;
            for place in [line, column].into_iter().flatten() {
                write!(f, ":{place}")?;
            }
            f.write_str(": ")?;
        }
        if let Some(key) = key {
            f.write_str(key)?;
            if let Some(found) = found {
                write!(f, " = {found}")?;
            }
            f.write_str(": ")?;
        }
        f.write_str(problem)
    }
}

impl std::error::Error for SceneError {}
