//! Meshes that the water is drawn on.

mod n_patches;
mod tiled_grid;

pub use n_patches::NPatches;
pub use tiled_grid::TiledGrid;
