//! Settings of Johanson's projected grid (2004): the mesh that always lies before the camera, on Perlin noise.

use crate::key::table;
use crate::reader::TableReader;
use crate::registry::Registered;

use super::Technique;

pub(super) const REGISTERED: Registered<Technique> = Registered {
    word: "projected-grid",
    summary: "Johanson's projected grid (2004): the mesh that always lies before the camera, on Perlin noise",
    keys: ProjectedGrid::keys,
    read: |table| ProjectedGrid::read(table).map(Technique::ProjectedGrid),
};

table! {
    /// How it is drawn: the table `[projected-grid]`.
    pub struct ProjectedGrid {}
}

impl Default for ProjectedGrid {
    /// The settings of an empty `[projected-grid]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}
