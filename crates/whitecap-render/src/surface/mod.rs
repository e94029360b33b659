//! How a wave model reaches the GPU.

mod sines;
mod tile_maps;

pub(crate) use sines::GpuSines;
pub use tile_maps::TileMaps;
