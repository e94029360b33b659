//! Settings of Berglund's shader of five samples: emission against reflection on a flat sea.

use crate::key::table;
use crate::reader::TableReader;
use crate::registry::Registered;

use super::Technique;

pub(super) const REGISTERED: Registered<Technique> = Registered {
    word: "five-sample",
    summary: "Berglund's shader of five samples: emission against reflection on a flat sea",
    keys: FiveSample::keys,
    read: |table| FiveSample::read(table).map(Technique::FiveSample),
};

table! {
    /// How it is drawn: the table `[five-sample]`.
    pub struct FiveSample {}
}

impl Default for FiveSample {
    /// The settings of an empty `[five-sample]` table.
    fn default() -> Self {
        TableReader::defaults(Self::read)
    }
}
