//! What is above the water: an atmosphere with a sun, or a picture of a sky.

mod atmosphere;
mod panorama;

pub use atmosphere::Atmosphere;
pub use panorama::PanoramaSky;

use crate::error::SceneError;
use crate::key::Real;
use crate::reader::TableReader;
use crate::registry::{Registered, Tag, TagDefault};

/// The sky, the table `[sky]`. It serialises as that table.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Sky {
    /// A clear or cloudy atmosphere lit by the sun.
    Atmosphere(Atmosphere),
    /// A picture all around.
    Panorama(PanoramaSky),
}

/// Every kind of sky.
pub const ALL: &[Registered<Sky>] = &[atmosphere::REGISTERED, panorama::REGISTERED];

pub(crate) const TAG: Tag<Sky> = Tag {
    key: "kind",
    noun: "sky",
    doc: "What the sky is.",
    default: TagDefault::Word("atmosphere"),
    all: ALL,
};

/// The exposure of either sky.
const EXPOSURE_EV: Real = Real { unit: "EV", min: -20.0, max: 20.0 };

impl Sky {
    pub(crate) fn read(table: &TableReader<'_>) -> Result<Self, SceneError> {
        table.tagged(&TAG)
    }

    /// The picture that the sky is made of, if it is.
    pub(crate) fn file_mut(&mut self) -> Option<&mut std::path::PathBuf> {
        match self {
            Self::Atmosphere(_) => None,
            Self::Panorama(panorama) => Some(&mut panorama.file),
        }
    }
}

impl Default for Sky {
    /// The sky of a scene without a `[sky]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}
