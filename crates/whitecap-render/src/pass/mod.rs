//! Passes that techniques and hosts share.

mod sky;

pub use sky::SkyPass;
