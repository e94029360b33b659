//! Standard output, which carries data and nothing else.

use crate::failure::Failure;
use std::io::{self, Write};

/// Writes `bytes` and sees them out, so that a full disk behind a redirection is noticed.
pub(crate) fn write(bytes: &[u8]) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(bytes).and_then(|()| stdout.flush()).map_err(failure)
}

/// Writes `value` as one indented JSON document.
pub(crate) fn write_json<T: serde::Serialize>(value: &T) -> Result<(), Failure> {
    let mut text = serde_json::to_string_pretty(value).map_err(|e| Failure::Machine(e.into()))?;
    text.push('\n');
    write(text.as_bytes())
}

/// Writes `value` as one line of JSON, at once.
pub(crate) fn write_json_line<T: serde::Serialize>(value: &T) -> Result<(), Failure> {
    let mut text = serde_json::to_string(value).map_err(|e| Failure::Machine(e.into()))?;
    text.push('\n');
    write(text.as_bytes())
}

/// Writes what programs get in place of a result.
pub(crate) fn error_as_json(sentence: &str) -> Result<(), Failure> {
    write_json(&serde_json::json!({ "error": sentence }))
}

/// What a failed write to standard output means.
pub(crate) fn failure(error: io::Error) -> Failure {
    if error.kind() == io::ErrorKind::BrokenPipe {
        Failure::ReaderGone
    } else {
        Failure::Machine(anyhow::Error::new(error).context("cannot write to standard output"))
    }
}
