//! The two forms of a file: JSON alone, or JSON and a blob in chunks (section 4, GLB).

use gltf::json::Root;

use super::Mesh;
use crate::mesh::error::{MeshProblem, one_line};

/// The most objects that the JSON may have. Each takes some hundred bytes of memory for as little as three in the
/// file, so they are counted before any is made.
const MAX_OBJECTS: u64 = 400_000;

/// The most values that the JSON may have, for the same reason.
const MAX_VALUES: u64 = 4_000_000;

/// A chunk of JSON, by its type.
const JSON: [u8; 4] = *b"JSON";

/// A chunk of bytes for a buffer, by its type.
const BIN: [u8; 4] = *b"BIN\0";

/// Extensions that may be required because nothing that they change is read here. Those to geometry are not
/// among them, except for quantized vertices, which are read.
const HARMLESS_EXTENSIONS: &[&str] = &[
    "KHR_mesh_quantization",
    "KHR_materials_",
    "KHR_texture_",
    "EXT_texture_",
    "KHR_lights_",
    "MSFT_texture_",
];

/// What a file consists of.
pub(super) struct Container<'a> {
    json: &'a [u8],
    /// The bytes that a `.glb` brings for its first buffer.
    pub(super) blob: Option<&'a [u8]>,
}

impl<'a> Container<'a> {
    pub(super) fn read(bytes: &'a [u8]) -> Result<Self, MeshProblem> {
        if bytes.is_empty() {
            return Err(MeshProblem::Empty);
        }
        if let Some(rest) = bytes.strip_prefix(b"glTF") {
            return Self::read_chunks(rest);
        }
        let json = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
        if json.trim_ascii_start().starts_with(b"{") {
            Ok(Container { json, blob: None })
        } else {
            Err(MeshProblem::UnknownFormat)
        }
    }

    /// What follows the first four bytes of a `.glb` file.
    fn read_chunks(rest: &'a [u8]) -> Result<Self, MeshProblem> {
        let ends_early = || MeshProblem::Damaged("the file ends early".to_owned());
        let (version, rest) = split_number(rest).ok_or_else(ends_early)?;
        if version != 2 {
            return Err(MeshProblem::Version(version.to_string()));
        }
        let (length, rest) = split_number(rest).ok_or_else(ends_early)?;
        // The length counts the twelve bytes that are already read.
        let mut rest =
            (length as usize).checked_sub(12).and_then(|length| rest.get(..length)).ok_or_else(ends_early)?;
        let (mut json, mut blob) = (None, None);
        while !rest.is_empty() {
            let (length, after) = split_number(rest).ok_or_else(ends_early)?;
            let (kind, after) = after.split_first_chunk::<4>().ok_or_else(ends_early)?;
            let (data, after) = after.split_at_checked(length as usize).ok_or_else(ends_early)?;
            match *kind {
                JSON if json.is_none() => json = Some(data),
                BIN if blob.is_none() => blob = Some(data),
                // Others are for extensions and are to be ignored (section 4.4.1).
                _ => {}
            }
            rest = after;
        }
        let json = json.ok_or_else(|| MeshProblem::Damaged("no chunk of JSON".to_owned()))?;
        Ok(Container { json, blob })
    }

    /// What the JSON says, of a version and with extensions that are read here. Its indices may still point
    /// anywhere.
    pub(super) fn root(&self) -> Result<Root, MeshProblem> {
        let count = |is_one: fn(&u8) -> bool| self.json.iter().filter(|byte| is_one(byte)).count() as u64;
        at_most("JSON objects", count(|byte| *byte == b'{'), MAX_OBJECTS)?;
        at_most("JSON values", count(|byte| matches!(byte, b'{' | b'[' | b',')), MAX_VALUES)?;
        let root: Root = gltf::json::deserialize::from_slice(self.json)
            .map_err(|error| MeshProblem::Damaged(one_line(error)))?;

        if root.asset.version.split('.').next() != Some("2") {
            return Err(MeshProblem::Version(one_line(format_args!("{:?}", root.asset.version))));
        }
        let is_harmless = |name: &str| HARMLESS_EXTENSIONS.iter().any(|start| name.starts_with(start));
        if let Some(name) = root.extensions_required.iter().find(|name| !is_harmless(name)) {
            return Err(MeshProblem::Extension(one_line(name)));
        }
        at_most("nodes", root.nodes.len() as u64, Mesh::MAX_NODES as u64)?;
        Ok(root)
    }
}

/// An error if there are too many.
pub(super) fn at_most(what: &'static str, count: u64, most: u64) -> Result<(), MeshProblem> {
    if count > most { Err(MeshProblem::TooMany { what, count, most }) } else { Ok(()) }
}

fn split_number(bytes: &[u8]) -> Option<(u32, &[u8])> {
    let (number, rest) = bytes.split_first_chunk::<4>()?;
    Some((u32::from_le_bytes(*number), rest))
}
