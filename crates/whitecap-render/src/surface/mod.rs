//! How a wave model reaches the GPU.

mod backend;
mod bump_map;
mod compute;
mod foam;
mod normal_level;
mod sines;
mod tile_maps;

pub use backend::Backend;
pub(crate) use bump_map::bump_map;
#[cfg(test)]
pub(crate) use bump_map::rms_slope;
pub use foam::{FoamMaps, GpuFoam, GpuFoamTile};
pub(crate) use sines::GpuSines;
pub use tile_maps::{TileMaps, TileTextures, Vertices};
