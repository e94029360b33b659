//! Settings of ATI's ocean (ShaderX 2002): four sines at the vertices, two bump maps, a squared reflection.

use crate::key::table;
use crate::reader::TableReader;
use crate::registry::Registered;

use super::Technique;

pub(super) const REGISTERED: Registered<Technique> = Registered {
    word: "ocean-water",
    summary: "ATI's ocean (ShaderX 2002): four sines at the vertices, two bump maps, a squared reflection",
    keys: OceanWater::keys,
    read: |table| OceanWater::read(table).map(Technique::OceanWater),
};

table! {
    /// How it is drawn: the table `[ocean-water]`.
    pub struct OceanWater {}
}

impl Default for OceanWater {
    /// The settings of an empty `[ocean-water]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}
