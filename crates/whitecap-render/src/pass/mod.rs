//! Passes that techniques share: the sky, the objects, the maps of what lies over and under the water.

mod objects;
mod planar;
mod sky;

pub(crate) use objects::{ObjectPass, Objects};
pub(crate) use planar::{PlanarPass, PlanarSettings};
pub(crate) use sky::SkyPass;
