//! Passes that techniques share: the air, the sky, the objects, the maps of what lies over and under the water.

mod atmosphere;
mod objects;
mod planar;
mod sky;

pub(crate) use atmosphere::{Around, Skies, sky_layout_entries};
pub(crate) use objects::{ObjectPass, Objects};
#[cfg(test)]
pub(crate) use planar::tests as planar_tests;
pub(crate) use planar::{PlanarPass, PlanarSettings};
pub(crate) use sky::SkyPass;
