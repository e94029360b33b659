//! Settings of a sea without waves: it has none.

use whitecap_waves::model::Calm;

use super::{SeaModel, SeaSurface};
use crate::key::table;
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<SeaModel> = Registered {
    word: "calm",
    summary: "a level surface, whose ripples are the technique's alone",
    keys: CalmSettings::keys,
    read: |table| CalmSettings::read_keys(table).map(SeaModel::Calm),
};

table! {
    /// A level sea: the table `[sea]` with `model = "calm"`.
    pub struct CalmSettings {}
}

impl CalmSettings {
    pub(super) fn build(&self) -> SeaSurface {
        SeaSurface::Calm(Calm)
    }
}
