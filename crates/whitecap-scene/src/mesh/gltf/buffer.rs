//! The bytes that a file's buffers hold: in the `.glb` itself, in data URIs or in files beside it (section 3.6.1).

use std::borrow::Cow;
use std::path::{Component, Path, PathBuf};

use base64::Engine as _;
use base64::alphabet;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use gltf::json::Root;

use super::{Mesh, read_file};
use crate::mesh::error::{MeshProblem, one_line};

/// Some writers leave out the padding, which says nothing that the length does not.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &alphabet::STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// The bytes of all buffers, each as long as the JSON says. `read` is how many bytes the file itself has.
pub(super) fn load_all<'a>(
    root: &Root,
    blob: Option<&'a [u8]>,
    folder: Option<&Path>,
    read: u64,
) -> Result<Vec<Cow<'a, [u8]>>, MeshProblem> {
    let mut left = Mesh::MAX_FILE_BYTES - read.min(Mesh::MAX_FILE_BYTES);
    let mut buffers = Vec::new();
    for (index, buffer) in root.buffers.iter().enumerate() {
        let problem = |explanation: String| MeshProblem::Buffer { index, explanation };
        let bytes = match (&buffer.uri, blob) {
            (Some(uri), _) => {
                let bytes = match uri.strip_prefix("data:") {
                    Some(data) => decode_data(data).map_err(problem)?,
                    None => read_beside(uri, folder, left).map_err(|found| match found {
                        Beside::TooLong => MeshProblem::TooLong,
                        Beside::Other(explanation) => problem(explanation),
                    })?,
                };
                left = left.checked_sub(bytes.len() as u64).ok_or(MeshProblem::TooLong)?;
                Cow::Owned(bytes)
            }
            (None, Some(blob)) if index == 0 => Cow::Borrowed(blob),
            (None, _) => {
                return Err(problem("has no bytes; accepted: a uri, or the chunk of a .glb file".to_owned()));
            }
        };
        let length = buffer.byte_length.0;
        if (bytes.len() as u64) < length {
            return Err(problem(format!("{} bytes long, but its byteLength is {length}", bytes.len())));
        }
        // What follows is padding.
        buffers.push(match bytes {
            Cow::Borrowed(bytes) => Cow::Borrowed(&bytes[..length as usize]),
            Cow::Owned(mut bytes) => {
                bytes.truncate(length as usize);
                Cow::Owned(bytes)
            }
        });
    }
    Ok(buffers)
}

/// What follows `data:`: a media type, `;base64,` and the data (RFC 2397).
fn decode_data(data: &str) -> Result<Vec<u8>, String> {
    let (about, data) = data.split_once(',').ok_or("a data URI without a comma")?;
    if !about.ends_with(";base64") {
        return Err(
            "a data URI that is not base64; accepted: data:application/octet-stream;base64,…".to_owned()
        );
    }
    BASE64.decode(data).map_err(|error| format!("damaged base64: {}", one_line(error)))
}

/// Why a file beside the mesh cannot be had.
enum Beside {
    TooLong,
    Other(String),
}

/// The bytes of a file in `folder`.
fn read_beside(uri: &str, folder: Option<&Path>, most: u64) -> Result<Vec<u8>, Beside> {
    let other = |explanation: &str| Beside::Other(format!("{:?}: {explanation}", one_line(uri)));
    let folder = folder.ok_or_else(|| other("a file beside this one, which is not read from a folder"))?;
    let path = decode_path(uri).ok_or_else(|| {
        other(
            "no file in the mesh's own folder; accepted: a relative path without \"..\" and without a scheme",
        )
    })?;
    read_file(&folder.join(path), most).map_err(|problem| match problem {
        MeshProblem::TooLong => Beside::TooLong,
        MeshProblem::Unreadable(error) => other(&format!("cannot be read: {error}")),
        MeshProblem::Folder => other("is a folder; accepted: a file"),
        _ => other("no ordinary file; accepted: a file"),
    })
}

/// The path that a relative reference stands for (RFC 3986), if it leads to no other folder than its own and those
/// in it.
fn decode_path(uri: &str) -> Option<PathBuf> {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.bytes();
    while let Some(byte) = rest.next() {
        if byte == b'%' {
            let mut digit = || char::from(rest.next()?).to_digit(16);
            bytes.push((16 * digit()? + digit()?) as u8);
        } else {
            bytes.push(byte);
        }
    }
    let path = String::from_utf8(bytes).ok()?;
    // A colon is a scheme or a drive, a backslash a separator on some systems; a zero byte is in no name.
    if path.is_empty() || path.contains([':', '\\', '\0']) {
        return None;
    }
    let path = PathBuf::from(path);
    let stays = |part: Component<'_>| matches!(part, Component::Normal(_) | Component::CurDir);
    path.components().all(stays).then_some(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_stay_in_the_folder() {
        for (uri, path) in [
            ("duck.bin", "duck.bin"),
            ("./data/duck%20one.bin", "./data/duck one.bin"),
            ("%C3%A9.bin", "é.bin"),
        ] {
            assert_eq!(decode_path(uri), Some(PathBuf::from(path)), "{uri}");
        }
        for uri in [
            "",
            "/etc/passwd",
            "../duck.bin",
            "a/../../b",
            "%2e%2e/b",
            "%2Fetc/passwd",
            "file:///etc/passwd",
            "https://example.org/a.bin",
            "c:duck.bin",
            "a\\..\\b",
            "a%00b",
            "a%0",
            "a%zz",
            "%ff.bin",
        ] {
            assert_eq!(decode_path(uri), None, "{uri}");
        }
    }
}
