//! How a wave model reaches the GPU.

mod tile_maps;

pub use tile_maps::TileMaps;
