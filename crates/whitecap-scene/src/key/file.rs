//! Paths of files that a scene uses.

use std::path::PathBuf;

use super::number::wrong_type;
use super::{Accepts, Kind};
use crate::error::SceneError;
use crate::reader::ValueReader;

/// The path of a file, as the scene file writes it. Whether the file is there is for its reader to say.
pub(crate) struct File;

impl Kind for File {
    type Value = PathBuf;

    fn accepts(&self) -> Accepts {
        Accepts::File
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<PathBuf, SceneError> {
        let path = value.string().ok_or_else(|| wrong_type(value, &Accepts::File))?;
        if path.is_empty() || path.contains('\0') {
            return Err(value.error(format!("not a path; accepted: {}", Accepts::File)));
        }
        Ok(PathBuf::from(path))
    }
}
