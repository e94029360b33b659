//! Settings of ATI's lake (ShaderX 2002): mirror and refraction maps disturbed by scrolling bump maps.

use crate::key::table;
use crate::reader::TableReader;
use crate::registry::Registered;

use super::Technique;

pub(super) const REGISTERED: Registered<Technique> = Registered {
    word: "rippling-lake",
    summary: "ATI's lake (ShaderX 2002): mirror and refraction maps disturbed by scrolling bump maps",
    keys: RipplingLake::keys,
    read: |table| RipplingLake::read(table).map(Technique::RipplingLake),
};

table! {
    /// How it is drawn: the table `[rippling-lake]`.
    pub struct RipplingLake {}
}

impl Default for RipplingLake {
    /// The settings of an empty `[rippling-lake]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}
