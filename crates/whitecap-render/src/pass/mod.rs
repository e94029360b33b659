//! Passes that techniques share: the air, the sky, the objects, the maps of what lies over and under the water. For stills:
//! the mean of several samples, and the picture that it becomes.

mod atmosphere;
mod develop;
mod mean;
mod objects;
mod planar;
mod sky;

pub(crate) use atmosphere::{Around, Skies, sky_layout_entries};
pub(crate) use develop::develop;
pub(crate) use mean::MeanPass;
pub(crate) use objects::{ObjectPass, Objects};
#[cfg(test)]
pub(crate) use planar::tests as planar_tests;
pub(crate) use planar::{PlanarPass, PlanarSettings};
pub(crate) use sky::SkyPass;
