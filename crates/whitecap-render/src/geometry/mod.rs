//! Meshes that the water is drawn on.

mod n_patches;
mod square_grid;
mod tiled_grid;

pub use n_patches::NPatches;
pub use square_grid::SquareGrid;
pub use tiled_grid::TiledGrid;
